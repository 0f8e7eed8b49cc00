"""Verdicts and intervals of flow benches that code without `poppet` has made."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_flow_benches import KINDS, draw
from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import FlowPoints, Instrument
from refusals import refused

FEW, ALL = 4, 63
NAMES = ("sonic_conductance", "critical_ratio")
CALIBRATED = ("stated", "ambient", "four ratios")


def points_of(bench, **changes):
    """Return the points of a bench as its operator states them."""
    uncertainties = {f"u_{channel}": Instrument(**row) for channel, row in bench.stated.items()}
    return FlowPoints(**{**bench.readings, **uncertainties, **changes})


def counts_of(kind, seeds):
    """Return the numbers of determined and covered values, and of values more than five standard errors off."""
    determined = covered = far = 0
    codes = []
    for seed in seeds:
        bench = draw(seed, kind)
        result = identify_flow(points_of(bench))
        codes += {note.code for note in result.remarks}
        for name in NAMES:
            e = result.parameters[name]
            if e.verdict == "determined":
                determined += 1
                covered += e.low <= bench.truth[name] <= e.high
                far += abs(e.value - bench.truth[name]) > 5.0 * e.standard_error
    print(f"{kind}: {determined} of {2 * len(seeds)} values determined, {covered} covered, {far} beyond 5 sigma")
    return determined, covered, far, codes


@pytest.mark.parametrize("kind", CALIBRATED)
@pytest.mark.parametrize("count", [FEW, pytest.param(ALL, marks=pytest.mark.slow)])
def test_calibrated_benches_are_determined_and_covered(kind, count):
    determined, covered, far, _ = counts_of(kind, range(count))
    assert determined >= 0.9 * 2 * count
    assert covered >= 0.93 * determined - 1
    assert far == 0


@pytest.mark.parametrize("kind", ["scatter unknown", "few points", "half too small"])
@pytest.mark.parametrize("count", [FEW, pytest.param(ALL, marks=pytest.mark.slow)])
def test_scatter_that_is_not_stated_or_too_small_is_covered(kind, count):
    determined, covered, *_ = counts_of(kind, range(count))
    assert determined >= 0.3 * 2 * count
    assert covered >= 0.9 * determined - 1


@pytest.mark.parametrize("kind", ["uncalibrated", "three times", "gauge"])
@pytest.mark.parametrize("count", [FEW, pytest.param(ALL, marks=pytest.mark.slow)])
def test_benches_with_unstated_errors_determine_nothing(kind, count):
    determined, _, _, codes = counts_of(kind, range(count))
    assert determined == 0
    code = {"uncalibrated": "flow.scatter_only", "three times": "flow.residuals_too_large"}.get(kind)
    if code:
        assert codes.count(code) >= 0.97 * count


@pytest.mark.parametrize("count", [6, pytest.param(ALL, marks=pytest.mark.slow)])
def test_a_cracking_valve_makes_no_outliers(count):
    *_, codes = counts_of("cracking", range(count))
    assert codes.count("flow.other_law") >= 0.9 * count - 1
    assert codes.count("flow.outlier") <= 1 + 0.02 * count


def test_calibration_of_the_flow_meter_alone_limits_the_conductance():
    bench = draw(0, "stated")
    meter = Instrument(relative=bench.stated["mass_flow_rate"]["relative"])
    found = identify_flow(points_of(bench, u_mass_flow_rate=meter))
    assert [found.parameters[name].verdict for name in NAMES] == ["weak", "determined"]
    (note,) = [note for note in found.remarks if note.code == "flow.scatter_only"]
    assert (note.facts["channels"], note.facts["names"]) == (["mass_flow_rate"], ["sonic_conductance"])


def test_gauge_pressures_at_one_inlet_pressure_are_weak():
    """At p1 = 7.25 bar, gauge readings give C 16 % too high and b 0.37 in place of 0.46, with good residuals."""
    from exact.independent_flow_benches import law

    p_2 = np.linspace(1.1e5, 6.8e5, 14)
    q = law(7.25e5, p_2, 293.15, 1e-8, 0.46) * (1.0 + 0.002 * np.random.default_rng(1).standard_normal(14))
    scale, sensor = Instrument(relative=0.002, calibration=0.005), Instrument(absolute=200.0, offset=500.0)
    gauge = (q, np.full(14, 7.25e5 - 1e5), p_2 - 1e5, 293.15, scale, sensor, sensor)
    found = identify_flow(FlowPoints(*gauge)).parameters
    assert found["sonic_conductance"].value == pytest.approx(1.16e-8, rel=0.01)
    assert [found[name].verdict for name in NAMES] == ["weak", "weak"]
    absolute = identify_flow(FlowPoints(q, np.full(14, 7.25e5), p_2, 293.15, scale, sensor, sensor)).parameters
    assert [absolute[name].verdict for name in NAMES] == ["determined", "determined"]
    certain = identify_flow(FlowPoints(*gauge, is_absolute=True)).parameters
    assert [certain[name].verdict for name in NAMES] == ["determined", "determined"]


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"pressure_1": 1e3, "pressure_2": 1e3}, "flow.too_large"),  # kPa written for Pa: 6000 bar
        ({"pressure_1": 1e-5, "pressure_2": 1e-5}, "flow.too_small"),  # bar read as Pa
    ],
)
def test_pressures_that_no_bench_has_are_rejected(changes, code):
    bench = draw(1, "stated")
    with refused(code):
        points_of(bench, **{name: factor * bench.readings[name] for name, factor in changes.items()})


def test_fahrenheit_for_celsius_is_rejected():
    bench = draw(1, "stated")
    fahrenheit = 1.8 * (bench.readings["temperature_1"] - 273.15) + 32.0
    with refused("flow.temperature"):
        points_of(bench, temperature_1=fahrenheit + 273.15)


def test_celsius_for_fahrenheit_is_reported():
    bench = draw(1, "stated")
    celsius = bench.readings["temperature_1"] - 273.15
    found = identify_flow(points_of(bench, temperature_1=(celsius - 32.0) / 1.8 + 273.15))
    assert any(note.code == "flow.unusual_temperature" for note in found.remarks)
    assert {found.parameters[name].verdict for name in NAMES} == {"weak"}


def test_the_error_of_one_barometer_reading_is_common_to_all_points():
    bench = draw(1, "ambient")
    assert np.ndim(bench.readings["pressure_2"]) == 0
    stated = points_of(bench).u_pressure_2
    assert (stated.absolute, stated.offset) == (0.0, bench.stated["pressure_2"]["absolute"])


def test_every_kind_has_points():
    assert all(np.all(np.isfinite(draw(0, kind).readings["pressure_1"])) for kind in KINDS)
