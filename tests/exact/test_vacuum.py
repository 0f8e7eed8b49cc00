"""Ejectors and suction cups against closed forms and against SciPy code that shares nothing with the package."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet import Chamber, Circuit, Reservoir, SuctionCup, VacuumEjector, load
from poppet.signals import Steps

ROOT = Path(__file__).parents[2]
RHO, R, KAPPA, T0, BAR = 1.185, 287.05, 1.4, 293.15, 1e5
LITRE = 1e-3 / 60.0  # per minute, in m^3/s
NOMINAL, SUCTION, DEPTH, NOZZLE = 5.5 * BAR, 40.0 * LITRE, 0.85 * BAR, 2e-9
VOLUME, OPEN = 2e-3, 6e-9
EJECTOR: dict[str, Any] = {
    "nozzle_conductance": NOZZLE, "nominal_pressure": NOMINAL, "vacuum_conductance": OPEN, "vacuum_ratio": 0.3,
}  # fmt: skip
GENERIC = {"max_suction_flow": SUCTION, "max_vacuum": DEPTH}
TABLE = {"pressure": [0.12 * BAR, 0.3 * BAR, 0.55 * BAR, 0.8 * BAR, BAR], "suction_flow": [0.0, 2e-4, 5e-4, 9e-4, 1e-3]}


def leak(upstream: float, downstream: float, conductance: float, ratio: float = 0.3) -> float:
    r = downstream / upstream
    return conductance * RHO * upstream * (1.0 if r <= ratio else math.sqrt(1.0 - ((r - ratio) / (1.0 - ratio)) ** 2))


def evacuation(supply: Any = NOMINAL, thermal: str = "isothermal", start: float = BAR, **fields: Any) -> Circuit:
    ejector = VacuumEjector(supply="net", vacuum="vessel", **EJECTOR, **fields)
    vessel = Chamber(volume=VOLUME, thermal=thermal, initial_pressure=start)
    signals = {} if isinstance(supply, float) else {"net.pressure": supply}
    net = Reservoir(pressure=supply if isinstance(supply, float) else NOMINAL)
    return Circuit({"net": net, "ejector": ejector, "vessel": vessel}, signals)


@pytest.mark.parametrize("drive", [1.0, 0.6, 0.25])
def test_isothermal_evacuation_with_a_straight_curve(drive: float) -> None:
    """An exponential towards the vacuum that belongs to the supply pressure."""
    run = evacuation(BAR + drive * (NOMINAL - BAR), **GENERIC).simulate(20.0, 0.05, 1e-10)
    end, tau = BAR - drive * DEPTH, VOLUME * DEPTH / (RHO * SUCTION * R * T0)
    pressure = end + (BAR - end) * np.exp(-run.time / tau)
    regular = pressure > end + 1e-3 * BAR  # outside the zone in which the slope decreases
    assert regular.sum() > 100
    np.testing.assert_allclose(run["vessel.pressure"][regular], pressure[regular], rtol=1e-7)
    flow = RHO * SUCTION / DEPTH * (pressure[regular] - end)
    np.testing.assert_allclose(run["ejector.vacuum_mass_flow_rate"][regular], flow, rtol=1e-5)
    assert run["vessel.pressure"][-1] == pytest.approx(end, abs=1e-3 * BAR)


def test_a_supply_above_the_nominal_pressure_does_not_draw_more() -> None:
    runs = [evacuation(pressure, **GENERIC).simulate(4.0, 0.1, 1e-9) for pressure in (NOMINAL, 8 * BAR)]
    np.testing.assert_allclose(runs[0]["vessel.pressure"], runs[1]["vessel.pressure"], rtol=1e-7)
    assert runs[1]["ejector.supply_mass_flow_rate"][-1] == pytest.approx(NOZZLE * RHO * 8 * BAR)


@pytest.mark.parametrize("thermal", ["isothermal", "energy"])
@pytest.mark.parametrize("drive", [1.0, 0.5])
def test_evacuation_with_a_measured_curve(thermal: str, drive: float) -> None:
    def rate(_: float, x: Any) -> Any:
        vacuum = (BAR - x[0]) / drive
        flow = RHO * drive * np.interp(BAR - vacuum, TABLE["pressure"], TABLE["suction_flow"])
        exponent = 1.0 if thermal == "isothermal" else KAPPA
        temperature = T0 * (x[0] / BAR) ** ((exponent - 1.0) / exponent)
        return [-exponent * R * temperature * flow / VOLUME]

    run = evacuation(BAR + drive * (NOMINAL - BAR), thermal, suction_curve=TABLE).simulate(8.0, 0.1, 1e-10)
    solution = solve_ivp(rate, (0.0, 8.0), [BAR], "DOP853", run.time, rtol=1e-10, atol=1e-4, max_step=0.02)
    np.testing.assert_allclose(run["vessel.pressure"], solution.y[0], rtol=1e-6)


def test_gas_flows_back_without_supply() -> None:
    """The vessel fills through the open path; with a check valve, it keeps its vacuum."""
    off = Steps([0.0, 6.0], [NOMINAL, BAR])
    run, kept = (evacuation(off, check_valve=c, **GENERIC).simulate(12.0, 0.02, 1e-10) for c in (False, True))
    start = int(np.searchsorted(run.time, 6.0))

    def rate(_: float, x: Any) -> Any:
        return [R * T0 / VOLUME * leak(BAR, min(x[0], BAR), OPEN)]

    times = run.time[start : start + 200]
    solution = solve_ivp(
        rate, times[[0, -1]], [run["vessel.pressure"][start]], "DOP853", times, rtol=1e-10, max_step=0.01
    )
    rising = solution.y[0] < 0.998 * BAR  # below the regularised zone
    assert rising.sum() > 50
    np.testing.assert_allclose(run["vessel.pressure"][start : start + 200][rising], solution.y[0][rising], rtol=1e-6)
    assert run["vessel.pressure"][-1] == pytest.approx(BAR, rel=1e-4)
    assert kept["vessel.pressure"][-1] == pytest.approx(kept["vessel.pressure"][start], rel=1e-9)


def test_a_vacuum_beyond_that_of_the_ejector_decays_to_it() -> None:
    run = evacuation(BAR + 0.5 * (NOMINAL - BAR), start=0.2 * BAR, **GENERIC).simulate(10.0)
    assert run["vessel.pressure"][-1] == pytest.approx(BAR - 0.5 * DEPTH, rel=1e-3)
    assert run["ejector.vacuum_mass_flow_rate"][0] < 0.0


def test_a_pressurised_vessel_is_vented_through_the_ejector() -> None:
    (flow,) = evacuation(start=3 * BAR, **GENERIC).simulate(1e-6, 1e-6)["ejector.vacuum_mass_flow_rate"][:1]
    assert flow == pytest.approx(leak(3 * BAR, BAR, OPEN) + RHO * SUCTION, rel=1e-9)


# --- Suction cups ---

DIAMETER, CUP, HOSE, LEAK = 0.05, 8e-6, 40e-6, 4e-11
AREA = 0.25 * math.pi * DIAMETER**2


def leaking_cup(load: Any = 0.0, start: float = 0.2 * BAR, sealed: Any = 1.0) -> Circuit:
    """An evacuated cup and a closed hose, which fill through a leak."""
    fields = {name: value for name, value in (("load_force", load), ("sealed", sealed)) if isinstance(value, float)}
    signals = {f"cup.{name}": v for name, v in (("load_force", load), ("sealed", sealed)) if not isinstance(v, float)}
    parts = {
        "hose": Chamber(volume=HOSE, thermal="isothermal", initial_pressure=start),
        "cup": SuctionCup(
            port="hose", volume=CUP, thermal="isothermal", diameter=DIAMETER, leak_conductance=LEAK, leak_ratio=0.3,
            port_conductance=1e-8, initial_pressure=start, **fields,
        ),
    }  # fmt: skip
    return Circuit(parts, signals)


@pytest.mark.parametrize("load", [20.0, 60.0, 120.0])
def test_time_at_which_a_leaking_cup_drops_its_load(load: float) -> None:
    """The fitting is 250 times as wide as the leak: one volume, up to an error below that of the assertion."""

    def rate(_: float, x: Any) -> Any:
        return [R * T0 / (CUP + HOSE) * leak(BAR, x[0], LEAK)]

    def drops(_: float, x: Any) -> float:
        return (BAR - x[0]) * AREA - load

    drops.terminal = True  # type: ignore[attr-defined]
    expected = solve_ivp(rate, (0.0, 60.0), [0.2 * BAR], "DOP853", events=drops, rtol=1e-10).t[-1]
    run = leaking_cup(load).simulate(expected + 0.5, 1e-4, 1e-9)
    held = run["cup.held"] > 0.5
    assert held[0]
    found = run.time[int(np.argmin(held))]
    assert found == pytest.approx(expected, abs=5e-3)
    before = run.time < found - 0.01
    np.testing.assert_allclose(run["cup.holding_force"][before], (BAR - run["cup.pressure"][before]) * AREA)
    assert run["cup.pressure"][-1] == pytest.approx(BAR, rel=1e-3)  # open after the drop
    assert run["cup.holding_force"][-1] == 0.0
    (note,) = [note for note in run.remarks if note.code == "vacuum.dropped"]
    assert note.facts["time"] == pytest.approx(expected, abs=5e-3)


def test_a_load_that_is_too_heavy_drops_at_once() -> None:
    limit = 0.8 * BAR * AREA
    for weight, is_held in ((0.999 * limit, True), (1.001 * limit, False)):
        run = leaking_cup(weight).simulate(0.01, 1e-4, 1e-9)
        assert (run["cup.held"][-1] > 0.5) == is_held


def test_a_cup_holds_again_after_it_was_lifted() -> None:
    """Drop by a pulse of the load, then a new contact; without the new contact, the cup stays open."""
    pulse = Steps([0.0, 1.0, 1.1], [10.0, 200.0, 10.0])
    for sealed, is_open in ((Steps([0.0, 2.0, 2.5], [1.0, 0.0, 1.0]), False), (1.0, True)):
        circuit = leaking_cup(pulse, 0.2 * BAR, sealed)
        parts = {
            **circuit.parts,
            "net": Reservoir(pressure=NOMINAL),
            "ejector": VacuumEjector(supply="net", vacuum="hose", **EJECTOR, **GENERIC),
        }
        run = Circuit(parts, circuit.signals).simulate(5.0, 1e-3)
        held = run["cup.held"]
        assert held[500] == pytest.approx(1.0)
        assert held[[1500, 2200]] == pytest.approx([0.0, 0.0], abs=1e-9)
        assert run["cup.pressure"][1500] > 0.9 * BAR
        assert held[-1] == pytest.approx(0.0 if is_open else 1.0, abs=1e-9)


@pytest.mark.parametrize("sealed", [0.0, 0.3, 0.999, 1.0])
def test_a_partial_contact_leaks_in_proportion(sealed: float) -> None:
    circuit = leaking_cup(0.0, 0.2 * BAR, sealed)
    run = circuit.simulate(1e-9, 1e-9)
    nozzle = 0.685 * math.sqrt(1.0 / (R * T0)) * AREA / RHO  # choked flow of an ideal nozzle of air, 0.1 %
    flow = run["cup.leak_mass_flow_rate"][0]
    assert flow == pytest.approx(RHO * BAR * (LEAK + (1.0 - sealed) * nozzle), rel=2e-3)
    assert run["cup.holding_force"][0] == pytest.approx(sealed * 0.8 * BAR * AREA)


# --- Page ---


def time_of_drop(circuit: Circuit) -> float:
    run = circuit.simulate(60.0, 1e-2)
    return float(run.time[np.flatnonzero(run["cup.held"] > 0.5)[-1] + 1]) - 3.0


def test_results_of_the_page() -> None:
    page = (ROOT / "docs" / "vacuum.md").read_text(encoding="utf-8")

    def stated(name: str) -> float:
        (text,) = re.findall(rf"^\| {re.escape(name)}.*? \| ([\d.]+) ", page, re.MULTILINE)
        return float(text)

    circuit = load(ROOT / "examples" / "vacuum.toml")
    run = circuit.simulate()
    force = run["cup.holding_force"]
    assert run.time[np.argmax(force > 59.2)] - 0.3 == pytest.approx(stated("holding force above"), abs=0.01)
    assert force.max() == pytest.approx(stated("largest holding force"), abs=0.6)
    pressure = float(np.interp(3.0, run.time, run["cup.pressure"]))
    assert pressure == pytest.approx(stated("pressure in the cup") * BAR, abs=60.0)
    air = np.trapezoid(run["ejector.supply_mass_flow_rate"], run.time) / RHO * 1e3
    assert air == pytest.approx(stated("air consumption"), abs=0.06)
    assert time_of_drop(circuit) == pytest.approx(stated("drop after"), abs=0.06)
    assert time_of_drop(circuit) == pytest.approx(stated("none"), abs=0.06)
    for name, values in (
        ("`leak_conductance` of", {"cup.leak_conductance": 4e-11}),
        ("`volume` of", {"hose.volume": 100e-6}),
        ("`diameter` of", {"cup.diameter": 0.05}),
    ):
        assert time_of_drop(circuit.with_values(values)) == pytest.approx(stated(name), rel=5e-3)
    parts = {**circuit.parts, "ejector": dataclasses.replace(circuit.parts["ejector"], check_valve=False)}
    assert time_of_drop(dataclasses.replace(circuit, parts=parts)) == pytest.approx(stated("`check_valve"), abs=0.01)
    area = 0.25 * math.pi * 0.04**2
    lower = 30e-6 * (BAR - 19.6 / area - pressure) / (RHO * R * T0 * 2e-11 * BAR)
    (text,) = re.findall(r"kg/m³: ([\d.]+) s in the\s+example", page)
    assert lower == pytest.approx(float(text), abs=0.06)
    assert lower < time_of_drop(circuit)
    (text,) = re.findall(r"holding force of the example is ([\d.]+) N", page)
    porous = circuit.with_values({"cup.leak_conductance": 2e-9}).simulate(2.9)
    assert porous["cup.holding_force"][-1] == pytest.approx(float(text), abs=0.6)


def test_the_template_is_the_example() -> None:
    template = ROOT / "src" / "poppet" / "cli" / "templates" / "vacuum.toml"
    assert template.read_bytes() == (ROOT / "examples" / "vacuum.toml").read_bytes()
