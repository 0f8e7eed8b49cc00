"""The page of an ensemble: what it holds, and that it needs nothing else."""

from __future__ import annotations

import re

import pytest

from circuits_of_ensembles import METRICS, NUMBERS, TABLES, tank
from pages import needs_nothing_else
from poppet.report.ensemble.ensemble_report import ensemble_page, write_ensemble

WHOLE = TABLES.replace("seed = 1", 'seed = 1\nsampling = "latin"\nkeep = "bands"\nindices = 32')


@pytest.fixture(scope="module")
def page() -> str:
    return ensemble_page(tank(WHOLE).ensemble(runs=120))


def test_a_page_holds_all_that_an_ensemble_tells(page):
    headings = re.findall(r"<h2>(.*?)</h2>", page)
    assert headings == [
        "Yield",
        "Curves",
        "Metrics",
        "Influence of the parameters",
        "Runs",
        "Worst cases",
        "Parameters",
    ]
    assert re.findall(r"<h3>(.*?)</h3>", page) == ["end", "empty", "air"]
    assert page.count("<figure") == 1 + 2 + 1 + 3 + 1
    assert "hole.sonic_conductance" in page
    assert "120 runs" in page


def test_a_page_needs_nothing_else(page):
    needs_nothing_else(page)


def test_the_same_dataset_gives_the_same_page(page, tmp_path):
    found = tank(WHOLE).ensemble(tmp_path / "set", runs=120, workers=2)
    assert write_ensemble(found, tmp_path / "page.html").read_text(encoding="utf-8") == page


def test_a_page_of_little(tmp_path):
    found = tank("").ensemble(runs=3, parameters=NUMBERS, metrics=METRICS)
    headings = re.findall(r"<h2>(.*?)</h2>", ensemble_page(found))
    assert headings == ["Metrics", "Influence of the parameters", "Runs", "Parameters"]


def test_failed_runs_are_said(tmp_path):
    """A level that no run passes is never reached, and a figure of no values is still a figure."""
    never = {"late": {"of": "tank.pressure", "metric": "time_to", "value": "9 bar"}}
    found = tank("").ensemble(runs=5, parameters=NUMBERS, metrics=never, requirements={"soon": "late < 1 s"})
    text = ensemble_page(found)
    assert [each.good for each in found.yields()] == [0]
    assert ">never<" in text
