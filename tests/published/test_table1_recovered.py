"""Tests that recover Table 1 of Varga & Keski-Honkola 2012 from synthetic tank tests."""

from __future__ import annotations

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.identify.characteristic.characteristic_file import write_characteristic
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.characteristic.stroke_tests import StrokeRecording
from poppet.library.varga2012 import printed_characteristic
from poppet.timeseries.measurements import Channel, Measurement

TABLE = printed_characteristic()
STROKES = np.linspace(0.05e-3, 1e-3, 15)
FULL_SCALE = 7e5
NOISE = 0.002
SAMPLES = 300

BENCH = Circuit(
    {
        "tank": Chamber(volume="10 l", thermal="isothermal", initial_pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": Orifice(from_="tank", to="room", sonic_conductance=1e-8, critical_ratio=0.3),
    }
)


def simulate_discharge(stroke: float, generator: np.random.Generator) -> StrokeRecording:
    """Return a discharge of a 10 l tank through the flow path of Table 1 at a stroke, with noise."""
    conductance, ratio = TABLE.sonic_conductance_at(stroke), TABLE.critical_ratio_at(stroke)
    truth = BENCH.with_values({"valve.sonic_conductance": conductance, "valve.critical_ratio": ratio})
    duration = 3.6e-7 / conductance
    run = truth.simulate(duration=duration, output_step=duration / SAMPLES)
    pressure = run["tank.pressure"] + NOISE * FULL_SCALE * generator.standard_normal(run.time.size)
    channel = Channel("tank.pressure", run.time, pressure, "Pa")
    return StrokeRecording(stroke, BENCH, Measurement(f"at{1e6 * stroke:.0f}um", (channel,), duration=duration))


@pytest.fixture(scope="module")
def discharge_tests() -> list[StrokeRecording]:
    generator = np.random.default_rng(2012)
    return [simulate_discharge(float(stroke), generator) for stroke in STROKES]


@pytest.mark.parametrize("joint", [False, True])
def test_fit_recovers_polynomials(discharge_tests, joint):
    result = identify_characteristic(discharge_tests, joint=joint)
    conductance, ratio = (result.series[name] for name in ("sonic_conductance", "critical_ratio"))
    x = conductance["x"]
    assert (x[0], x[-1]) == (STROKES[0], STROKES[-1])
    assert np.max(np.abs(conductance["y"] / TABLE.sonic_conductance_at(x) - 1.0)) < 0.01
    assert np.max(np.abs(ratio["y"] - TABLE.critical_ratio_at(x))) < 0.02
    assert result.conditions["way"] == ("joint" if joint else "test by test")
    assert result.comparison["chi_square_probability"][0] > 0.001


def test_bands_include_truth(discharge_tests):
    series = identify_characteristic(discharge_tests).series
    for name, truth in (("sonic_conductance", TABLE.sonic_conductance_at), ("critical_ratio", TABLE.critical_ratio_at)):
        curve = series[name]
        inside = (curve["low"] <= truth(curve["x"])) & (truth(curve["x"]) <= curve["high"])
        assert np.mean(inside) > 0.8
        assert np.max(curve["high"] - curve["low"]) < 0.1 * np.max(curve["y"])


def test_data_reject_rising_spline(discharge_tests):
    result = identify_characteristic(discharge_tests, form="spline")
    said = result.findings[0]
    assert "but the data contradict this constraint: above a stroke of" in said
    assert "C falls by 10." in said
    assert "runs test" in said
    assert "AICc" in said
    verdict = result.comparison["monotone"]
    assert verdict["rejected"]
    assert verdict["runs_probability"] < 0.05
    assert verdict["aicc_polynomial"] < verdict["aicc_free"] < verdict["aicc_constrained"]
    assert verdict["fall"] == pytest.approx(0.107, abs=0.005)
    # The curve satisfies the constraint, and b does not compensate for the error of C.
    assert np.all(np.diff(result.series["sonic_conductance"]["y"]) >= -1e-20)
    ratio = result.series["critical_ratio"]
    tested = ratio["x"] >= STROKES[0]
    assert np.max(np.abs(ratio["y"] - TABLE.critical_ratio_at(ratio["x"]))[tested]) < 0.05


def test_written_file_runs_in_circuit(discharge_tests, tmp_path):
    """Check the flow of a circuit file that refers to the characteristic fitted to recordings."""
    write_characteristic(identify_characteristic(discharge_tests), tmp_path / "mine.toml")
    text = """
    [parts.tank]
    kind = "chamber"
    volume = "10 l"
    thermal = "isothermal"
    initial_pressure = "7 bar"
    [parts.valve]
    kind = "orifice"
    from = "tank"
    to = "ambient"
    characteristic = "CHARACTERISTIC"
    stroke = "0.3 mm"
    [run]
    duration = "20 s"
    """
    runs = []
    for name in ("mine.toml", "varga2012.printed"):
        (tmp_path / "bench.toml").write_text(text.replace("CHARACTERISTIC", name))
        runs.append(poppet.load(tmp_path / "bench.toml").simulate()["tank.pressure"][-1])
    assert runs[0] == pytest.approx(runs[1], rel=2e-3)
