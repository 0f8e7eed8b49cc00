"""Tests of the virtual bench around a valve of a circuit, with values from its static equations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from poppet import Chamber, Circuit, MainStage, Reservoir, library
from poppet.bench.iso10094.evaluation import BenchSettings
from poppet.bench.iso10094.rig import build_rig, find_valve
from poppet.bench.iso10094.run_bench import run_bench
from poppet.bench.iso10094.step import step_trial
from poppet.bench.iso10094.supply import leakage_trial
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.parts import Orifice
from poppet.signals import Constant, Steps

SETTINGS = BenchSettings(volumes=(2e-3,), setpoints=(50.0,))


def circuit(**fields) -> Circuit:
    valve = MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012", mode="regulator", **fields)
    return Circuit(
        {"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="20 l")},
        {"valve.pilot_pressure": Steps([0.0, 1.0], [1e5, 3e5])},
        title="main stage",
    )


def force(name: str, group: str) -> float:
    numbers = library.main_stage("varga2012", "regulator")
    return float(numbers[f"{group}.rate"]) * float(numbers[f"{group}.preload"]) / float(numbers["plate_area"])


def test_full_scale_and_supply_follow_from_the_circuit():
    rig = build_rig(circuit(), "valve")
    assert (rig.supply, rig.scale.pressure_low, rig.scale.pressure_high) == (7e5, 1e5, 6e5)
    assert rig.scale.setpoint_unit == "Pa"
    assert rig.notes == [Note("rig.full_scale", bars=5)]
    high = build_rig(circuit(), "valve", full_scale=(1e5, 9e5), supply=8e5)
    assert high.notes == [Note("rig.above_supply", high=9e5, supply=8e5)]


def test_low_supply_without_full_scale_is_rejected():
    with pytest.raises(InputError) as caught:
        build_rig(circuit(), "valve", supply=1.5e5)
    assert caught.value.code == "rig.low_supply"


def test_supply_from_chamber_or_signal():
    base = circuit()
    stored = Circuit({**base.parts, "supply": Chamber(volume="50 l", initial_pressure="8 bar")})
    assert build_rig(stored, "valve").supply == 8e5
    driven = Circuit(base.parts, {"supply.pressure": Constant(6.5e5)})
    rig = build_rig(driven, "valve")
    assert rig.supply == 6.5e5
    assert Note("rig.supply_at_start", supply=6.5e5) in rig.notes
    open_air = Circuit({"valve": MainStage(supply="ambient", outlet="tank", exhaust="ambient", data="varga2012"),
                        "tank": Chamber(volume="1 l")})  # fmt: skip
    with pytest.raises(InputError) as caught:
        build_rig(open_air, "valve")
    assert caught.value.code == "rig.open_supply"


def test_test_valve_is_selected():
    single = circuit()
    assert find_valve(single) == "valve"
    two = Circuit(
        {**single.parts, "second": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012")}
    )
    with pytest.raises(InputError) as caught:
        find_valve(two)
    assert caught.value.code == "rig.several_valves"
    assert caught.value.facts["valves"] == ("valve", "second")
    two_valves = Circuit(
        {
            "a": Chamber(volume="1 l"),
            "hole": Orifice(from_="a", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
        }
    )
    with pytest.raises(InputError) as caught:
        find_valve(two_valves)
    assert caught.value.code == "rig.no_valve"
    with pytest.raises(InputError) as caught:
        find_valve(single, "tank")
    assert (caught.value.code, caught.value.address) == ("names.unknown", "tank")
    assert caught.value.facts["suggestion"].valid_names == ["valve"]


def test_record_begins_in_steady_state_after_the_lead():
    rig = build_rig(circuit(), "valve")
    record = rig.respond(step_trial(rig.scale, 2e-3, 40.0, 2.0))
    assert record.time[0] == 0.0
    assert record.is_exact
    assert np.ptp(record.outlet[record.time < 0.4]) < 200.0
    assert rig.scale.setpoint_percent(record.setpoint[[0, -1]]) == pytest.approx([30.0, 30.0])
    assert record.flow == pytest.approx(np.zeros(record.time.size))


def test_consumption_equals_the_stored_mass():
    rig = build_rig(circuit(), "valve")
    record = rig.respond(step_trial(rig.scale, 2e-3, 40.0, 2.0))
    in_window = record.time < 2.0
    consumed = np.trapezoid(record.consumption[in_window], record.time[in_window])
    # Mass at the end less that at the start, the gas warmed by at most its compression.
    isothermal = np.ptp(record.outlet[in_window]) * 2e-3 / (287.05 * 293.15)
    assert isothermal / 1.4 < consumed < 1.02 * isothermal
    still = rig.respond(leakage_trial(rig.scale, 2e-3, 50.0, 1.0))
    assert abs(np.mean(still.consumption)) < 1e-6


@pytest.mark.parametrize("preset", ["universal", "precise"])
def test_leakage_refilled_in_pulses_is_measured_completely(preset):
    from poppet.parts import ProportionalValve

    valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", preset=preset)
    parts = {"supply": Reservoir(pressure="8 bar"), "valve": valve, "tank": Chamber(volume="1 l")}
    rig = build_rig(Circuit(parts), "valve")
    record = rig.respond(leakage_trial(rig.scale, 1e-3, 50.0, 8.0))
    assert np.count_nonzero(record.consumption) < 0.1 * record.time.size  # single samples
    # The only leak is that of the pilot volume, C = 1e-13 m^3/(s Pa), some 0.2 bar above the outlet.
    pilot = np.mean(record.outlet) + 0.19e5
    # In 40 s 2 mg; the pilot may take up or give its hold band, 0.1 mg.
    assert np.mean(record.consumption) == pytest.approx(1e-13 * 1.185 * pilot, rel=0.05)


def test_too_fast_samples_are_reported():
    from poppet.parts import ProportionalValve

    quick = {"inner": {"sample_time": "2 us"}}
    valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", electronics=quick)
    parts = {"supply": Reservoir(pressure="8 bar"), "valve": valve, "tank": Chamber(volume="1 l")}
    rig = build_rig(Circuit(parts), "valve")
    for _ in range(2):
        rig.respond(leakage_trial(rig.scale, 1e-3, 50.0, 0.2))
    assert [note for note in rig.notes if note.code == "rig.pulses"] == [Note("rig.pulses", step=0.00025, sample=2e-6)]


def test_hysteresis_of_the_main_stage_is_the_preload_of_its_lower_spring():
    """The hysteresis is k2 h2 / S; the outlet is zero up to (k1 h1 + k2 h2) / S."""
    rig = build_rig(circuit(), "valve", full_scale=(1e5, 6e5))
    figures = run_bench(rig, BenchSettings(volumes=(2e-3,), sweep_time=20.0), ("characteristic", "step")).figures
    upper, lower = force("valve", "upper_spring"), force("valve", "lower_spring")
    assert figures["hysteresis"].value == pytest.approx(100.0 * lower / 5e5, rel=0.01)
    assert figures["zero_suppression"].value == pytest.approx(100.0 * (upper + lower) / 5e5, rel=0.02)
    assert figures["linearity"].value < 0.05


def test_interruption_and_failure_have_different_outcomes(monkeypatch):
    from poppet.bench.iso10094 import rig as module
    from poppet.engine.problem import Outcome

    solve = module.solve
    rig = build_rig(circuit(), "valve")
    for outcome, error in ((Outcome.INTERRUPTED, KeyboardInterrupt), (Outcome.TOO_MANY, SimulationError)):
        monkeypatch.setattr(module, "solve", lambda p, o=outcome, **options: replace(solve(p, **options), outcome=o))
        with pytest.raises(error):
            rig.respond(leakage_trial(rig.scale, 2e-3, 50.0, 0.5))


def test_load_is_adapted_to_the_valve():
    rig = build_rig(circuit(), "valve")
    result = run_bench(rig, SETTINGS, ("flow",))
    flow_row = next(row for row in result.rows["flow"] if "largest_drawn" in row)
    fed = next(row for row in result.rows["flow"] if "largest_fed" in row)
    assert flow_row["largest_drawn"] > 5.0 * abs(flow_row["droop"]) * 1e-6
    seat = library.characteristic("varga2012.closed").sonic_conductance_at(np.linspace(0.0, 1e-3, 101))
    assert 0.3 < flow_row["largest_drawn"] / (float(np.max(seat)) * 7e5 * 1.185) < 1.05  # the volume empties a little
    assert 0.0 < fed["largest_fed"] < flow_row["largest_drawn"]
    assert result.figures["relief_rise"].value > 0.0


def test_complete_valve_defines_the_scale():
    from poppet.parts import ProportionalValve

    parts = {
        "supply": Reservoir(pressure="9 bar"),
        "valve": ProportionalValve(
            supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", setpoint_type="4-20 mA"
        ),
        "tank": Chamber(volume="1 l"),
    }
    rig = build_rig(Circuit(parts), "valve")
    assert (rig.scale.setpoint_low, rig.scale.setpoint_high, rig.scale.setpoint_unit) == (0.004, 0.02, "A")
    assert (rig.scale.pressure_low, rig.scale.pressure_high) == (1e5, 7e5)
    part = build_rig(Circuit(parts), "valve", full_scale=(1e5, 4e5)).scale
    assert (part.setpoint_low, part.setpoint_high, part.span) == pytest.approx((0.004, 0.012, 3e5))
    with pytest.raises(InputError) as caught:
        build_rig(Circuit(parts), "valve", full_scale=(1e5, 8e5))
    assert caught.value.code == "rig.beyond_scaling"
    assert [caught.value.facts[f"own_{end}"] for end in ("low", "high")] == [1e5, 7e5]
    settings = BenchSettings(volumes=(1e-3,), amplitudes=(40.0,))
    with pytest.raises(InputError) as caught:
        run_bench(rig, replace(settings, sweep_time=0.01), ("characteristic",))
    assert caught.value.code == "bench.sweep_time"
    assert caught.value.facts["given"] == 0.01 < caught.value.facts["response"]
    figures = run_bench(rig, settings, ("step",)).figures
    assert 0.01 < figures["response_time_up"].value < 1.0
