"""Logic valves and one-way valves against closed forms and an independent model in SciPy."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from poppet import (
    Chamber,
    Circuit,
    Filter,
    FlowControlValve,
    GasChoice,
    Orifice,
    PilotedCheckValve,
    QuickExhaustValve,
    Reservoir,
    ShuttleValve,
    TwoPressureValve,
)
from poppet.signals import Points

sys.path.insert(0, str(Path(__file__).parent))
from independent_logic import DENSITY, GAS_CONSTANT, TEMPERATURE, Element, flow, one_way, simulate

SIZE: dict[str, Any] = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}


def chamber(volume: float, pressure: float = 1e5, thermal: str = "isothermal") -> Chamber:
    return Chamber(volume=volume, thermal=thermal, initial_pressure=pressure, initial_temperature=TEMPERATURE)


# --- Closed forms ---


@pytest.mark.parametrize("switching_time", [1e-3, 2e-2])
def test_quick_exhaust_discharges_the_load_by_the_closed_form(switching_time):
    """Choked isothermal discharge: ln(p0/p) = (t - t0)/tau.

    The exhaust opens between half the switching time and its end. The element moves at constant speed over 98 % of its
    travel and then approaches its seat exponentially, which delays the full opening by 0.7504 switching times.
    """
    volume, conductance, start = 2e-3, 1e-8, 9e5
    valve = QuickExhaustValve(
        inlet="line", outlet="load", sonic_conductance=5e-9, critical_ratio=0.2, exhaust_conductance=conductance,
        exhaust_ratio=0.3, switching_time=switching_time,
    )  # fmt: skip
    parts = {"line": Reservoir(pressure=1e5), "valve": valve, "load": chamber(volume, start)}
    recording = Circuit(parts).simulate(0.6, 0.01, relative_tolerance=1e-9)
    is_choked = (recording.time > 2.0 * switching_time) & (recording["load.pressure"] > 1e5 / 0.3)
    assert is_choked.sum() > 20
    tau = volume / (conductance * DENSITY * GAS_CONSTANT * TEMPERATURE)
    known = start * np.exp(-(recording.time - 0.7504 * switching_time) / tau)
    assert recording["load.pressure"][is_choked] == pytest.approx(known[is_choked], rel=1e-6)


@pytest.mark.parametrize(("kind", "side"), [(ShuttleValve, 1.0), (TwoPressureValve, -1.0)])
@pytest.mark.parametrize("slope", [1e4, 1e5, 1e6])
def test_element_switches_at_the_switching_pressure_in_both_directions(kind, side, slope):
    """Closed form for a ramp of the drive, 1 + r t: T dx/dt = r t + 0.4 x."""
    limit, switching_time = 2e4, 1e-3
    valve = kind(
        a="left", b="right", outlet="load", **SIZE, switching_pressure=limit, switching_time=switching_time,
        initial_position=0.0 if side > 0.0 else 1.0,
    )  # fmt: skip
    parts = {"left": Reservoir(pressure=4e5), "right": Reservoir(pressure=4e5), "valve": valve, "load": chamber(1e-5)}
    up, end = 1e5 / slope, 3e5 / slope
    ramps = Points([0.0, up, end], [4e5, 5e5, 3e5])
    step = 1e-5 * end
    recording = Circuit(parts, {"right.pressure": ramps}).simulate(end, step, relative_tolerance=1e-9)
    position = recording["valve.position"]
    changes = np.flatnonzero(np.diff(position > 0.5))
    crossing = recording.time[changes] + step * (0.5 - position[changes]) / np.diff(position)[changes]
    rate = slope / limit
    tau = switching_time / 0.4

    def travel(time: float) -> float:
        return float(rate / 0.4 * (tau * np.expm1(time / tau) - time))

    delay = brentq(lambda time: travel(time) - 0.5, 1e-6, 1.0)
    assert rate * delay + 0.4 * 0.5 < 1.0  # below full speed
    assert crossing == pytest.approx([limit / slope + delay, up + (1e5 + limit) / slope + delay], abs=1e-2 * delay)


def test_hysteresis_is_twice_the_switching_pressure():
    valve = ShuttleValve(a="left", b="right", outlet="load", **SIZE, switching_pressure="0.1 bar")
    parts = {"left": Reservoir(pressure=4e5), "right": Reservoir(pressure=4e5), "valve": valve, "load": chamber(1e-5)}
    triangle = Points([0.0, 5.0, 15.0, 20.0], [4e5, 4.5e5, 3.5e5, 4e5])
    recording = Circuit(parts, {"right.pressure": triangle}).simulate(20.0, 5e-3)
    at_b = recording["valve.position"] > 0.5
    difference = recording["right.pressure"] - 4e5
    assert difference[np.flatnonzero(np.diff(at_b.astype(int)) > 0)] == pytest.approx([1e4], rel=0.02)
    assert difference[np.flatnonzero(np.diff(at_b.astype(int)) < 0)] == pytest.approx([-1e4], rel=0.02)


def test_pilot_holds_an_equilibrium_by_the_closed_form():
    """A piloted check valve throttles if its outflow raises the pressure behind it: both flows are equal."""
    lock = PilotedCheckValve(
        from_="behind", to="load", pilot="signal", **SIZE, pilot_ratio=3.0, pilot_band="0.5 bar",
        cracking_pressure="0.1 bar",
    )  # fmt: skip
    vent = Orifice(from_="behind", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    parts = {
        "load": Reservoir(pressure=6e5), "signal": Reservoir(pressure=3.2e5), "lock": lock,
        "behind": chamber(1e-4), "vent": vent,
    }  # fmt: skip
    recording = Circuit(parts).simulate(5.0, 0.1)
    behind = recording["behind.pressure"][-1]
    opening = (3.0 * (3.2e5 - behind) - (6e5 - behind) - 1e4) / 5e4
    assert 0.0 < opening < 1.0
    assert recording["lock.opening"][-1] == pytest.approx(opening, rel=1e-6)
    assert 2e-8 * opening * flow(6e5, behind, 1.0, 0.3) == pytest.approx(1e-9 * flow(behind, 1e5, 1.0, 0.3), rel=1e-5)


def test_trapped_gas_stays_trapped():
    """Gas behind closed paths: a reversed check valve, a closed throttle, a lip seal, and the closed inlet of each."""
    size = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
    parts: dict[str, Any] = {"rail": Reservoir(pressure=3e5), "low": Reservoir(pressure=1e5)}
    parts |= {name: chamber(1e-4, 6e5) for name in ("throttled", "locked", "inlet", "other")}
    parts |= {name: chamber(1e-4, 1e5) for name in ("signal", "either", "both")}
    parts |= {
        "throttle": FlowControlValve(from_="rail", to="throttled", throttle_conductance=1e-9, opening=0.0, **size),
        "lock": PilotedCheckValve(from_="rail", to="locked", pilot="low", **size),
        # The chambers `inlet` and `other` have more pressure than the opposite inlets of these valves.
        "or": ShuttleValve(a="low", b="rail", outlet="either", **size, initial_position=1.0),
        "and": TwoPressureValve(a="inlet", b="low", outlet="both", **size, initial_position=1.0),
        "quick": QuickExhaustValve(inlet="signal", outlet="other", exhaust="locked", **size),
    }
    recording = Circuit(parts).simulate(10.0, 0.1)
    for name in ("throttled", "locked", "inlet"):
        assert recording[f"{name}.mass"] == pytest.approx(recording[f"{name}.mass"][0], rel=1e-12), name
    assert recording["both.pressure"][-1] == pytest.approx(1e5, rel=1e-9)
    assert recording["either.pressure"][-1] == pytest.approx(3e5, rel=1e-6)
    # The seal opens the exhaust, but the exhaust has the same pressure.
    assert recording["quick.position"][-1] == pytest.approx(1.0, abs=1e-9)
    assert recording["other.pressure"][-1] == pytest.approx(6e5, rel=1e-9)


@pytest.mark.parametrize("kind", [ShuttleValve, TwoPressureValve])
def test_no_gas_flows_between_two_closed_inlets(kind):
    """Both inlets lose gas to the outlet only, whichever the valve selects; equal pressures at the start."""
    parts = {
        "a": chamber(1e-3, 5e5), "b": chamber(1e-3, 5e5), "load": chamber(1e-3, 1e5),
        "valve": kind(a="a", b="b", outlet="load", **SIZE),
    }  # fmt: skip
    recording = Circuit(parts).simulate(5.0, 1e-3)
    for name in ("a", "b"):
        assert np.diff(recording[f"{name}.mass"]).max() < 1e-7 * recording[f"{name}.mass"][0]
    drop = recording["a.pressure"] - recording["b.pressure"]
    final = recording["load.pressure"][-1]
    if kind is ShuttleValve:
        # It takes gas from both in turn, so that they differ by little more than the switching pressure.
        assert np.abs(drop).max() < 0.08e5
        assert final == pytest.approx(11e5 / 3.0, rel=0.01)
    else:
        # It keeps the inlet that it has, because its pressure falls.
        assert recording["b.pressure"] == pytest.approx(np.full(5001, 5e5), rel=1e-12)
        assert final == pytest.approx(3e5, rel=1e-3)


GASES = [{"name": "helium"}, {"name": "carbon dioxide", "conductances": "from air"}, {"name": "argon"}]


@pytest.mark.parametrize("gas", GASES, ids=lambda gas: gas["name"])
def test_paths_of_other_gases_are_those_of_orifices(gas):
    """Each valve fills or vents a chamber as an orifice of its size does, in every gas."""
    small = {"sonic_conductance": 1e-9, "critical_ratio": 0.4}
    valves: dict[str, tuple[Any, dict[str, float]]] = {
        "or": (ShuttleValve(a="rail", b="low", outlet="load", **small), small),
        "and": (TwoPressureValve(a="rail", b="high", outlet="load", **small), small),
        "quick": (QuickExhaustValve(inlet="rail", outlet="load", **small), small),
        "filter": (Filter(from_="rail", to="load", clogging=0.5, sonic_conductance=2e-9, critical_ratio=0.4), small),
        "throttle": (
            FlowControlValve(
                from_="load", to="rail", **SIZE, throttle_conductance=4e-9, throttle_ratio=0.4, opening=0.25
            ),
            small,
        ),
        "lock": (PilotedCheckValve(from_="load", to="rail", pilot="high", **small), small),
    }
    pressures = {"rail": 6e5, "low": 1e5, "high": 9e5}
    ends = {}
    for name, (valve, size) in valves.items():
        for part in (valve, Orifice(from_="rail", to="load", **size)):
            nodes = {node for node in part.ports().values() if node in pressures}
            parts = {node: Reservoir(pressure=pressures[node], temperature=300.0) for node in nodes}
            circuit = Circuit(parts | {"part": part, "load": Chamber(volume=1e-3)}, gas=GasChoice(**gas))
            ends.setdefault(name, []).append(circuit.simulate(0.5, 0.05, relative_tolerance=1e-9)["load.pressure"])
    for name, (found, known) in ends.items():
        assert found == pytest.approx(known, rel=1e-6), name
        assert np.ptp(known) > 1e4


# --- Independent model ---

T = {"or": 2e-3, "and": 5e-3, "quick": 1e-3}
PRESSURES = {
    "left": ([0.0, 0.2, 0.6, 0.7, 1.2, 1.5], [1e5, 6e5, 6e5, 2e5, 2e5, 5e5]),
    "right": ([0.0, 0.3, 0.4, 0.9, 1.0, 1.5], [3e5, 3e5, 5e5, 5e5, 1e5, 1e5]),
}
VOLUMES = {"t1": 2e-4, "t2": 1e-4, "t3": 5e-4, "t4": 3e-4, "t5": 2e-4}


def independent_flows(p: dict[str, float], x: dict[str, float]) -> dict[str, float]:
    """Return the flows into the chambers of the circuit below."""

    def two_inlets(name: str, outlet: str) -> float:
        total = 0.0
        for side, distance in (("left", x[name]), ("right", 1.0 - x[name])):
            is_early = (p[side] > p[outlet]) == (name == "or")
            opening = np.clip((3.0 if is_early else 1.0) - 4.0 * distance, 0.0, 1.0)
            total += flow(p[side], p[outlet], 2e-8 * opening, 0.3)
        return total

    either, both = two_inlets("or", "t1"), two_inlets("and", "t2")
    fills = one_way(p["t1"], p["t3"], 1e-8 * max(1.0 - 2.0 * x["quick"], 0.0), 0.25)
    vents = flow(p["t3"], p["ambient"], 3e-8 * max(2.0 * x["quick"] - 1.0, 0.0), 0.4)
    throttle = flow(p["t2"], p["t4"], 0.5 * 2e-9, 0.35)
    meter = max(one_way(p["t2"], p["t4"], 1e-8, 0.3, 1e4), throttle) if throttle > 0.0 else throttle
    opening = (2.5 * (p["t2"] - p["t1"]) - (p["t5"] - p["t1"]) - 5e3) / 2e4
    piloted = flow(p["t1"], p["t5"], 4e-9 * min(max(opening, 0.0), 1.0), 0.3)
    lock = max(one_way(p["t1"], p["t5"], 4e-9, 0.3, 5e3), piloted) if piloted >= 0.0 else piloted
    leak = flow(p["t4"], p["ambient"], 1e-9 * (1.0 - 0.6), 0.2)
    return {"t1": either - fills - lock, "t2": both - meter, "t3": fills - vents, "t4": meter - leak, "t5": lock}


def test_network_agrees_with_an_independent_model_in_scipy():
    parts: dict[str, Any] = {side: Reservoir(pressure=values[0]) for side, (_, values) in PRESSURES.items()}
    parts |= {name: chamber(volume) for name, volume in VOLUMES.items()}
    parts |= {
        "or": ShuttleValve(a="left", b="right", outlet="t1", **SIZE, switching_time=T["or"]),
        "and": TwoPressureValve(a="left", b="right", outlet="t2", **SIZE, switching_time=T["and"]),
        "quick": QuickExhaustValve(
            inlet="t1", outlet="t3", sonic_conductance=1e-8, critical_ratio=0.25, exhaust_conductance=3e-8,
            exhaust_ratio=0.4, switching_time=T["quick"],
        ),
        "meter": FlowControlValve(
            from_="t2", to="t4", sonic_conductance=1e-8, critical_ratio=0.3, throttle_conductance=2e-9,
            throttle_ratio=0.35, opening=0.5, cracking_pressure=1e4,
        ),
        "lock": PilotedCheckValve(
            from_="t1", to="t5", pilot="t2", sonic_conductance=4e-9, critical_ratio=0.3, pilot_ratio=2.5,
            pilot_band=2e4, cracking_pressure=5e3,
        ),
        "leak": Filter(from_="t4", to="ambient", sonic_conductance=1e-9, critical_ratio=0.2, clogging=0.6),
    }  # fmt: skip
    # A narrow regularised zone, so that the law of the standard is valid almost everywhere.
    parts = {
        name: type(part)(**_fields(part), laminar_ratio=0.9999) if hasattr(part, "laminar_ratio") else part
        for name, part in parts.items()
    }
    signals = {f"{side}.pressure": Points(*table) for side, table in PRESSURES.items()}
    recording = Circuit(parts, signals).simulate(1.5, 2e-3, relative_tolerance=1e-8)
    elements = {
        "or": Element(lambda p: p["right"] - p["left"], 5e3, T["or"]),
        "and": Element(lambda p: p["left"] - p["right"], 5e3, T["and"]),
        "quick": Element(lambda p: p["t3"] - p["t1"], 5e3, T["quick"]),
    }
    known = simulate(VOLUMES, PRESSURES, elements, independent_flows, recording.time)
    for name in VOLUMES:
        assert np.abs(recording[f"{name}.pressure"] / known[name] - 1.0).max() < 5e-4, name
        assert np.ptp(known[name]) > 1e5
    for name in elements:
        assert np.abs(recording[f"{name}.position"] - known[name]).max() < 0.05, name
        assert np.abs(np.diff(known[name] > 0.5)).sum() >= 3, name


def _fields(part: Any) -> dict[str, Any]:
    from dataclasses import fields

    return {item.name: getattr(part, item.name) for item in fields(part) if item.name != "laminar_ratio"}
