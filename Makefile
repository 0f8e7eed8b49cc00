# make demo      reproduces the paper's figures as one page
# make docs      the site, into build/site
# make test      style, types and tests in about five minutes on two cores; where CI is set, the costly ones too (tests/costly.txt)
# make test-all  every test, the slow ones too
# Needs Python 3.11 or later with pip and venv; everything else goes into $(VENV).

SHELL := /bin/bash
PYTHON ?= python3
VENV ?= .venv
WORKERS ?= 2
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install -qq --disable-pip-version-check -c constraints.txt
# Tests start many processes: what one has compiled is kept for the others. A worker that is done takes from another.
PYTEST := PYTHONDONTWRITEBYTECODE= $(BIN)/python -m pytest -q --tb=short -n $(WORKERS) --dist worksteal

.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help docs package demo test test-all style types tests tests-all golden integrator benchmark clean

help:
	@echo "make demo       reproduce the figures of the paper (into paper/)"
	@echo "make docs       the site, to be read without a network (into build/site)"
	@echo "make test       style, types and all quick tests; with CI=true the costly ones too"
	@echo "make test-all   the same with all tests, the slow ones too"
	@echo "make package    wheel and sdist, tried in empty environments (into dist/)"
	@echo "make golden     the file of all messages anew, after a change of words; HARVEST=1 adds new codes"
	@echo "make integrator the compiled integrator's text anew, after a change of engine/integrator.py"
	@echo "make benchmark  speed and accuracy, measured side by side"
	@echo "make clean      remove $(VENV), caches and results"

demo: $(VENV)/installed
	$(BIN)/poppet paper -o paper
	@echo "The page lies at $(CURDIR)/paper/report.html"

docs: $(VENV)/installed-dev
	$(BIN)/python website/make_site.py

package: $(VENV)/installed-dev
	$(BIN)/python tools/package.py

test: style types tests

test-all: style types tests-all

style: $(VENV)/installed-dev
	$(BIN)/ruff format --check --output-format concise .
	$(BIN)/ruff check .

types: $(VENV)/installed-dev
	$(BIN)/mypy

tests: $(VENV)/installed-dev
	$(PYTEST) -m "$(if $(CI),not slow,not slow and not costly)"

tests-all: $(VENV)/installed-dev
	$(PYTEST)

golden: $(VENV)/installed-dev
ifdef HARVEST
	rm -rf .golden && mkdir .golden
	-POPPET_GOLDEN=$(CURDIR)/.golden $(PYTEST) -m "not slow"
endif
	$(BIN)/python tools/golden.py .golden
	rm -rf .golden

integrator: $(VENV)/installed-dev
	$(BIN)/python tools/make_integrator.py

benchmark: $(VENV)/installed-dev
	$(BIN)/python benchmarks/flow_law.py
	$(BIN)/python benchmarks/staircase.py
	$(BIN)/python benchmarks/chain.py
	$(BIN)/python benchmarks/lanes.py
	$(BIN)/python benchmarks/loads.py
	$(BIN)/python benchmarks/joint.py
	$(BIN)/python benchmarks/joint_bandwidth.py
	$(BIN)/python benchmarks/joint_control.py
	$(BIN)/python benchmarks/sampled_control.py
	$(BIN)/python benchmarks/presets.py
	$(BIN)/python benchmarks/cold.py
	$(BIN)/python benchmarks/identify.py
	$(BIN)/python benchmarks/ensemble.py
	$(BIN)/python benchmarks/export_c.py
	$(BIN)/python benchmarks/live.py

# The stamps: what they depend on decides when to install again.
$(VENV)/installed: pyproject.toml constraints.txt | $(VENV)/bin/pip
	$(PIP) -e ".[all]"
	@touch $@

$(VENV)/installed-dev: pyproject.toml constraints.txt | $(VENV)/bin/pip
	$(PIP) -e ".[all,dev]"
	@touch $@ $(VENV)/installed

$(VENV)/bin/pip:
	$(PYTHON) -m venv $(VENV)

clean:
	rm -rf $(VENV) paper build dist .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find src tests benchmarks examples -name __pycache__ -type d -prune -exec rm -rf {} +
