"""Tests of the validation page: complete claims, failed claims first, and quick claims measured again."""

from __future__ import annotations

import ast
import importlib
from pathlib import Path
from types import ModuleType

import pytest

import claims
import validate
import validation_pages
from claims import CLAIMS, SOURCES

QUICK = [name for name, claim in CLAIMS.items() if claim.is_quick]


@pytest.fixture(scope="module")
def results():
    return validate.kept()


def test_every_claim_was_measured_and_no_other(results):
    assert list(results) == list(CLAIMS)
    for result in results.values():
        assert {"date", "version", "commit", "figures"} <= result.keys()


@pytest.mark.parametrize("name", CLAIMS)
def test_page_contains_all_facts_of_a_claim(name, results):
    claim, text = CLAIMS[name], validation_pages.page(results)
    source = SOURCES[claim.source]
    section = text.partition(f"({validation_pages.anchor(claim)})=\n")[2].partition("\n(validation-")[0]
    figures = results[name]["figures"]
    texts = (claim.ours.format(**figures), claim.theirs.format(**figures), claim.unseen.format(**figures))
    for fact in (*texts, claim.when, source.name):
        assert validation_pages.prose(fact) in section
    assert source.licence in section
    assert f"`python website/validate.py {name}`\n" in section
    assert results[name]["date"] in section
    assert ("does not hold" in section) is not validation_pages.holds(claim, results)


def test_failed_claims_are_first(results):
    first = validation_pages.page(results).partition("## Claims that do not hold")[2].partition("\n## ")[0]
    failed = [name for name, claim in CLAIMS.items() if not validation_pages.holds(claim, results)]
    assert failed
    assert first.count("(#validation-") == len(failed)
    assert all(f"(#{validation_pages.anchor(CLAIMS[name])})" in first for name in failed)


def test_other_figures_change_the_page(results):
    changed = results | {"discharge_bracket": results["discharge_bracket"] | {
        "figures": {"measured": 30.0, "adiabatic": 17.0, "isothermal": 22.0}}}  # fmt: skip
    assert not validation_pages.holds(CLAIMS["discharge_bracket"], changed)
    assert "30.0 s measured" in validation_pages.page(changed)


@pytest.mark.parametrize("name", QUICK)
def test_quick_claims_have_the_stated_figures(name, results):
    claim = CLAIMS[name]
    if not SOURCES[claim.source].is_here:
        pytest.skip(f"{SOURCES[claim.source].name} is not available")
    assert claim.measure() == pytest.approx(results[name]["figures"], rel=claim.rounding)


def test_claims_use_existing_functions_of_tests():
    def imported(node: ast.AST) -> ModuleType | None:
        is_import = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "module"
        return importlib.import_module(ast.literal_eval(node.args[0])) if is_import else None

    missing = []
    for function in ast.parse(Path(claims.__file__).read_text(encoding="utf-8")).body:
        nodes = list(ast.walk(function))
        modules = {ast.unparse(node.targets[0]): imported(node.value) for node in nodes if isinstance(node, ast.Assign)}
        for node in nodes:
            if isinstance(node, ast.Attribute) and (
                owner := imported(node.value) or modules.get(ast.unparse(node.value))
            ):
                missing += [] if hasattr(owner, node.attr) else [ast.unparse(node)]
    assert missing == []
