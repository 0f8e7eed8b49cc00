"""Report of an ensemble: sections, reproducibility and missing results."""

from __future__ import annotations

import re

import pytest

from circuits_of_ensembles import METRICS, NUMBERS, TABLES, tank
from pages import needs_nothing_else
from poppet.report.ensemble_report import ensemble_page, write_ensemble

ALL_TABLES = TABLES.replace("seed = 1", 'seed = 1\nsampling = "latin"\nkeep = "bands"\nindices = 32')


@pytest.fixture(scope="module")
def page() -> str:
    return ensemble_page(tank(ALL_TABLES).ensemble(runs=120))


def test_page_has_a_section_for_each_result(page):
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


def test_page_is_self_contained(page):
    needs_nothing_else(page)


def test_equal_datasets_give_equal_pages(page, tmp_path):
    ensemble = tank(ALL_TABLES).ensemble(tmp_path / "set", runs=120, workers=2)
    assert write_ensemble(ensemble, tmp_path / "page.html").read_text(encoding="utf-8") == page


def test_sections_without_content_are_omitted(tmp_path):
    ensemble = tank("").ensemble(runs=3, parameters=NUMBERS, metrics=METRICS)
    headings = re.findall(r"<h2>(.*?)</h2>", ensemble_page(ensemble))
    assert headings == ["Metrics", "Influence of the parameters", "Runs", "Parameters"]


def test_page_shows_never_for_an_event_that_does_not_occur(tmp_path):
    """The histogram of a metric without values is drawn without bars."""
    metrics = {"late": {"of": "tank.pressure", "metric": "time_to", "value": "9 bar"}}
    ensemble = tank("").ensemble(runs=5, parameters=NUMBERS, metrics=metrics, requirements={"soon": "late < 1 s"})
    text = ensemble_page(ensemble)
    assert [result.good for result in ensemble.yields()] == [0]
    assert ">never<" in text
