"""Tests of the bench report: it contains all results and needs no other files."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from pages import needs_nothing_else, plots
from poppet.bench.iso10094.bench_result import DEFINITIONS, TESTS, BenchResult, compare_bench_results, read_bench_result
from poppet.bench.iso10094.evaluation import BenchSettings, CharacteristicValue
from poppet.bench.iso10094.run_bench import run_bench
from poppet.bench.iso10094.virtual_valve import VirtualValve
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.note_groups import grouped
from poppet.report.bench.bench_report import (
    DESCRIPTIONS,
    bench_page,
    conditions_text,
    figure_text,
    value_text,
    verdict_text,
    write_bench,
)

pytest.importorskip("matplotlib")
VALVE = VirtualValve(
    play=0.8, dead_zone=2.0, dead_time=0.01, bow=1.0, droop=20.0, rise=4.0, flow_play=0.05, hum=0.1, hum_frequency=80.0,
    leak=1e-6, supply_sensitivity=0.01, offset=0.2, title="a <first> valve",
)  # fmt: skip
SETTINGS = BenchSettings(
    volumes=(1e-3, 2e-3), amplitudes=(80.0, 10.0), sweep_time=10.0, frequencies=(0.5, 1.0, 2.0, 4.0, 8.0),
    setpoints=(50.0,),
)  # fmt: skip


@pytest.fixture(scope="module")
def result(other) -> BenchResult:
    bench_result = run_bench(VALVE, SETTINGS, source="stand-in", notes=("a note & more",))
    return replace(bench_result, comparison=compare_bench_results(bench_result, other(bench_result)))


@pytest.fixture(scope="module")
def other():
    """Result of another valve with equal curves and different values."""
    return lambda result: replace(
        result, title="second", figures={name: replace(f, value=1.1 * f.value) for name, f in result.figures.items()}
    )


class Page(HTMLParser):
    """HTML parser that rejects unclosed tags."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.words = ""
        self.addresses: list[str] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.addresses += [value or "" for key, value in attrs if key in ("src", "href")]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.addresses += [value or "" for key, value in attrs if key in ("src", "href")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words += data


def test_report_is_complete_and_self_contained(result, other):
    text = bench_page(result, other(result))
    page = Page(text)
    assert [address for address in page.addresses if not address.startswith("#")] == []
    needs_nothing_else(text)
    assert len(plots(text)) == text.count("<figure") == text.count("<svg") > 3
    page_text = page.words.replace("\xa0", " ")
    assert "a <first> valve" in page_text
    assert "a note & more" in page_text
    assert "Compared with: second" in page_text
    for test in TESTS:
        assert DESCRIPTIONS[test].title in page_text
    for name, figure in result.figures.items():
        assert figure_text(figure) in page_text, name
        assert figure.definition in page_text
    assert all(str(note) in page_text for notes in result.notes.values() for note in grouped(notes))
    assert "verify against the standard" in page_text
    assert text.count("<svg") == 6


def test_equal_results_give_equal_reports(result, tmp_path):
    first, second = (write_bench(result, tmp_path / name).read_bytes() for name in ("a.html", "b.htm"))
    assert first == second
    with pytest.raises(InputError) as caught:
        write_bench(result, tmp_path / "a.pdf")
    assert caught.value.code == "files.suffix"


def test_result_from_file_gives_the_same_report(result, tmp_path):
    result.save(tmp_path / "r.toml")
    restored = read_bench_result(tmp_path / "r.toml")
    assert [verdict_text(restored, test) for test in TESTS] == [verdict_text(result, test) for test in TESTS]
    Page(bench_page(restored))


def test_report_without_values_and_curves():
    empty = BenchResult(
        "nothing", "recordings", {}, {test: [] for test in TESTS}, notes={"step": (Note("said", text="not done."),)}
    )
    page_text = Page(bench_page(empty)).words
    assert "not done." in page_text
    assert "nan" not in page_text
    assert "The bench was interrupted." in Page(bench_page(replace(empty, outcome="interrupted"))).words


def test_verdicts_as_text(result):
    assert verdict_text(result, "step").startswith(
        "The step of 80 % FS takes 0.125 s up and 0.125 s down to 90 % of the change."
    )
    assert "At rest the outlet oscillates by ± 0.1 % FS at 80 Hz." in verdict_text(result, "step")
    assert re.search(r"It has fallen by 10 % FS at 5\.2\d g/s\.", verdict_text(result, "flow"))
    assert verdict_text(result, "supply") == "A change of the supply by 1 bar changes the outlet by 1 kPa."
    assert verdict_text(result, "leakage") == "At rest the valve takes 1 mg/s from the supply."
    assert "of a straight line" in verdict_text(result, "characteristic")
    assert "For a sine of ± 5 % FS about 50 % FS, 1 l the amplitude has fallen by 3 dB at" in verdict_text(
        result, "frequency"
    )


@pytest.mark.parametrize("missing", DEFINITIONS)
def test_missing_value_leaves_complete_sentences(result, missing):
    less = replace(result, figures={name: f for name, f in result.figures.items() if name != missing})
    text = verdict_text(less, DEFINITIONS[missing].of.name)
    assert "{" not in text
    assert "nan" not in text
    assert text == "" or (text[0].isupper() and text.endswith("."))
    assert not re.search(r"\.\.|  | ,", text)


def test_bounds_and_units_as_text():
    assert value_text(3e-6, "kg/s", "at least") == "≥ 3 mg/s"
    assert value_text(1e-9, "% FS") == "0 % FS"
    assert value_text(-0.5, "% FS") == "-0.5 % FS"
    figures = {"resolution": CharacteristicValue(0.05, "% FS", "d", "at most")}
    assert "by at most 0.05 % FS" in verdict_text(BenchResult("", "circuit", figures), "resolution")
    assert (
        conditions_text(CharacteristicValue(1.0, "s", "", "", {"from": 10.0, "to": 90.0, "volume": 1e-3}))
        == "step 10 to 90 % FS, 1 l"
    )
    assert math.isfinite(figures["resolution"].value)


def test_characteristic_without_points_is_plotted(result):
    nothing = [replace(curve, x=curve.x[:0], y=curve.y[:0]) for curve in result.curves["characteristic"]]
    page = bench_page(replace(result, curves={**result.curves, "characteristic": nothing}))
    Page(page)
