# make demo      reproduces the figures of the paper in one report
# make docs      builds the website in build/site
# make quick     checks style and types and runs the fastest tests, in about one minute
# make test      checks style and types and runs the quick tests, in about three minutes on two cores; with CI=true
#                also the costly tests (tests/costly.txt)
# make test-all  runs all tests, including the slow ones
# Requires Python 3.11 or later with pip and venv. All packages are installed into $(VENV).

SHELL := /bin/bash
PYTHON ?= python3
VENV ?= .venv
WORKERS ?= 2
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install -qq --disable-pip-version-check -c constraints.txt
# Worker processes share compiled code, and an idle worker takes tests from another.
PYTEST := PYTHONDONTWRITEBYTECODE= $(BIN)/python -m pytest -q --tb=short -n $(WORKERS) --dist worksteal

.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help docs package demo quick test test-all style types tests tests-all golden integrator benchmark clean

help:
	@echo "make demo       reproduce the figures of the paper (into paper/)"
	@echo "make docs       build the website for offline reading (into build/site)"
	@echo "make quick      check style and types, run the fastest tests; about one minute"
	@echo "make test       check style and types, run the quick tests; with CI=true also the costly tests"
	@echo "make test-all   check style and types, run all tests including the slow ones"
	@echo "make package    build wheel and sdist and test them in empty environments (into dist/)"
	@echo "make golden     update the file of all messages after a change of texts; HARVEST=1 adds new codes"
	@echo "make integrator update the compiled integrator after a change of engine/integrator.py"
	@echo "make benchmark  measure speed and accuracy side by side"
	@echo "make clean      remove $(VENV), caches and results"

demo: $(VENV)/installed
	$(BIN)/poppet paper -o paper
	@echo "The report is $(CURDIR)/paper/report.html"

docs: $(VENV)/installed-dev
	$(BIN)/python website/make_site.py

package: $(VENV)/installed-dev
	$(BIN)/python tools/package.py

quick: style types
	$(PYTEST) -m "not slow and not costly" $(addprefix tests/unit/,core laws timeseries parts library circuit engine) \
	    tests/conventions/test_imports_go_down.py tests/conventions/test_language.py

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
	$(BIN)/python benchmarks/stepper.py
	$(BIN)/python benchmarks/watch.py
	$(BIN)/python benchmarks/loads.py
	$(BIN)/python benchmarks/machine.py
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
	$(BIN)/python benchmarks/wires.py
	$(BIN)/python benchmarks/cosimulation.py
	$(BIN)/python benchmarks/serve.py
	$(BIN)/python benchmarks/serve_modbus.py
	$(BIN)/python benchmarks/edit.py
	$(BIN)/python benchmarks/windows.py

# Stamp files: a change of their prerequisites triggers a new installation.
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
