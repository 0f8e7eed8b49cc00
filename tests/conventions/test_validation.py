"""The validation page: each claim has all that a reader needs, failures stand on it, and quick ones come out again."""

from __future__ import annotations

import pytest

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
def test_a_reader_finds_all_of_a_claim(name, results):
    claim, text = CLAIMS[name], validation_pages.page(results)
    source = SOURCES[claim.source]
    own = text.partition(f"({validation_pages.anchor(claim)})=\n")[2].partition("\n(validation-")[0]
    figures = results[name]["figures"]
    said = (claim.ours.format(**figures), claim.theirs.format(**figures), claim.unseen.format(**figures))
    for each in (*said, claim.when, source.name):
        assert validation_pages.prose(each) in own
    assert source.licence in own
    assert f"`python website/validate.py {name}`\n" in own
    assert results[name]["date"] in own
    assert ("does not hold" in own) is not validation_pages.holds(claim, results)


def test_what_fails_stands_first(results):
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
def test_quick_claims_come_out_again(name, results):
    claim = CLAIMS[name]
    if not SOURCES[claim.source].is_here:
        pytest.skip(f"not here: {SOURCES[claim.source].name}")
    assert claim.measure() == pytest.approx(results[name]["figures"], rel=claim.rounding)
