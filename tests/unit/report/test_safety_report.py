"""Report of a safety audit: times, distances, worst faults and curves."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from pages import lines, needs_nothing_else, plots
from poppet.audit.safety_result import EventValue, ExhaustTime, Moment, SafetyAudit, SafetyCurves, Travel
from poppet.report.audit.safety_report import curve_figure, exhaust_table, safety_page, travel_table

MOMENT = Moment(1.2, "extend")
TIME = np.linspace(0.0, 5.0, 101)


def exhaust(volume: str, fault: str, time: float, **more: object) -> ExhaustTime:
    return ExhaustTime(volume, fault, time, MOMENT, 6e5, 2e4, **more)


def travel(body: str, fault: str, distance: float, unit: str = "m", **more: object) -> Travel:
    return Travel(
        body, fault, unit, distance, MOMENT, 0.25, 0.1, 0.1, 0.4 if math.isfinite(distance) else math.inf, **more
    )


def audit(**changes: object) -> SafetyAudit:
    values = {
        "title": "Press",
        "events": (EventValue("dump.command", 0.0, "1", "0"),),
        "moments": (MOMENT, Moment(2.0, "retract")),
        "threshold": 5e4,
        "duration": 5.0,
        "faults": ("dump.stuck", "valve.stuck"),
        "exhaust": (
            exhaust("cap", "", 0.25, low=0.2, high=0.3125),
            exhaust("rod", "", 0.5),
            exhaust("cap", "dump.stuck", math.inf, reason="trapped", by=("dump",)),
            exhaust("rod", "dump.stuck", 0.75),
            exhaust("cap", "valve.stuck", math.nan),
            exhaust("rod", "valve.stuck", 1.5),
        ),
        "travel": (
            travel("load", "", 0.012, low=0.01, high=0.015),
            travel("arm", "", math.pi / 180.0, "rad"),
            travel("load", "dump.stuck", 0.05),
            travel("arm", "dump.stuck", 0.0, "rad"),
            travel("load", "valve.stuck", math.inf, low=0.1, high=math.inf),
            travel("arm", "valve.stuck", math.radians(12.0), "rad"),
        ),
        "curves": tuple(
            SafetyCurves(
                fault, MOMENT, TIME, {"cap": 6e5 * np.exp(-TIME), "rod": 0.0 * TIME}, {"load": 0.1 + 0.01 * TIME}
            )
            for fault in ("", "dump.stuck")
        ),
    }
    return SafetyAudit(**{**values, **changes})


@pytest.fixture(scope="module")
def page() -> str:
    return safety_page(audit())


def test_page_has_a_section_for_each_result(page):
    headings = re.findall(r"<h2>(.*?)</h2>", page)
    assert headings == ["Exhaust times", "Travels", "Curves", "Moments of the event"]
    assert page.count("<figure") == 2
    needs_nothing_else(page)


def test_the_page_says_that_it_is_no_certificate(page):
    assert "It does not certify a machine" in page
    assert "ISO 13849-1" in page
    assert "ISO 4414" in page


def plain(table):
    return [[re.sub(r"<.*?>", "", cell) for cell in row] for row in table.cells()]


def test_exhaust_times_with_interval_and_worst_fault():
    assert plain(exhaust_table(audit())) == [
        ["cap", "0.25 s (0.2 s to 0.312 s)", "6 → 0.2", "not within 5 s", "dump.stuck", "trapped by dump"],
        ["rod", "0.5 s", "6 → 0.2", "1.5 s", "valve.stuck", ""],
    ]


def test_travels_in_the_unit_of_the_body():
    assert plain(travel_table(audit())) == [
        ["load", "12 mm (10 mm to 15 mm)", "0.4 s", "does not stop: 250 mm so far", "valve.stuck"],
        ["arm", "1 deg", "0.4 s", "12 deg", "valve.stuck"],
    ]


def test_all_faults_are_listed_and_unsafe_results_marked(page):
    assert page.count("run failed") == 1
    marks = re.findall(r'<span class="verdict never">(.*?)</span>', page)
    assert marks.count("not within 5 s") == 3  # summary, table of volumes, table of faults
    assert marks.count("does not stop: 250 mm so far") == 3


def test_curves_are_gauge_pressures_and_displacements(page):
    curves = lines(plots(page)[0])
    time, pressure = curves["pressure [bar g]: cap"]
    assert (time[0], time[-1], pressure[0]) == (0.0, 5.0, pytest.approx(6.0))
    assert curves["displacement [mm]: load"][1][[0, -1]] == pytest.approx([0.0, 50.0])


@pytest.mark.parametrize(
    ("times", "end"),
    [
        ((0.13, 0.02), 1.25 * 0.2),  # the body stops at 0.2 s
        ((0.13, 3.0), 1.25 * 3.0),  # exhausted later than the curves can show
        ((0.13, 9.0), 10.0),
    ],
)
def test_the_time_axis_ends_after_the_last_event(times, end):
    time = np.linspace(0.0, 10.0, 10_001)
    pressures = {"cap": 6e5 * np.exp(-time / 0.05), "rod": 1e3 * np.exp(-time / 10.0)}
    curves = SafetyCurves("", MOMENT, time, pressures, {"load": 0.1 * np.minimum(time / 0.2, 1.0)})
    rows = tuple(exhaust(name, "", value) for name, value in zip(pressures, times, strict=True))
    figure = curve_figure(audit(exhaust=rows, travel=(travel("load", "", 0.1),), faults=()), curves)
    assert [axes.get_xlim()[1] for axes in figure.axes] == pytest.approx([end] * 2, rel=0.03)


def test_a_slow_exhaust_is_drawn_to_its_end():
    time = np.linspace(0.0, 10.0, 101)
    curves = SafetyCurves("", MOMENT, time, {"cap": 6e5 * np.exp(-time / 10.0)}, {})
    figure = curve_figure(audit(exhaust=(exhaust("cap", "", math.inf),), travel=(), faults=()), curves)
    assert figure.axes[0].get_xlim()[1] == 10.0


def test_an_audit_without_faults_and_bodies():
    page = safety_page(audit(faults=(), exhaust=(exhaust("cap", "", 0.25),), travel=(), curves=(), moments=(MOMENT,)))
    assert re.findall(r"<h2>(.*?)</h2>", page) == ["Exhaust times"]
    assert "Simulated in normal operation." in page
