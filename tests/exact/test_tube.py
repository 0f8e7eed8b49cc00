"""Tubes against closed forms: arrival of waves, quarter-wave resonance, steady flow, and what more cells bring."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq, curve_fit

from poppet import Chamber, Circuit, FlowSource, Orifice, Reservoir, Tube, iso6358
from poppet.circuit.trace import trace
from poppet.laws.physics.pipe import AIR_VISCOSITY_ANR
from poppet.signals import Points

R, KAPPA, T = 287.05, 1.4, 293.15
SOUND = math.sqrt(KAPPA * R * T)
LENGTH, BORE, REST = 2.0, 4e-3, 1e5
DENSITY = REST / (R * T)
QUARTER = 2.0 * math.pi * SOUND / (4.0 * LENGTH)
"""Angular frequency of the quarter wave without friction [1/s]."""
DECAY = 16.0 * AIR_VISCOSITY_ANR / (DENSITY * BORE**2)
"""Half the resistance over the inertance of the line with laminar friction [1/s]: r = 128 mu/(pi rho d^4), l = 1/A."""


def shut(cells: int, **fields: object) -> Circuit:
    """A tube with air at rest, open to a reservoir at one end and shut at the other."""
    hose = Tube(from_="supply", length=LENGTH, bore=BORE, cells=cells, inertia=True, **fields)
    return Circuit({"supply": Reservoir(pressure=REST), "hose": hose})


def modes(circuit: Circuit) -> np.ndarray:
    """Poles with positive frequency, the slowest first, of the traced equations at the start; nothing is compiled."""
    model = trace(circuit.parts, tuple(circuit.parameters), circuit.connections)
    s, p, n = model.symbols, list(circuit.parameters.values()), len(model.states)
    u = [circuit.parameters.get(i.default, i.default) for i in model.inputs]
    start = ca.Function("start", [s["p"]], [model.expressions["start"]])(p)
    slopes = ca.Function("slopes", [s["x"], s["u"], s["p"]], [ca.jacobian(model.expressions["rates"], s["x"])])
    poles = np.linalg.eigvals(np.array(slopes(start, u, p))[:n, :n])
    return np.array(sorted(poles[poles.imag > 1.0], key=lambda pole: pole.imag))


# --- waves ---


def arrival(cells: int, rise: float) -> float:
    """When half of a rise of the pressure at the open end has come to the shut end, where it doubles, over L/c."""
    delay = LENGTH / SOUND
    rising = Points([0.0, rise * delay], [REST, 1.001 * REST])
    run = Circuit(shut(cells).parts, {"supply.pressure": rising}).simulate((1.6 + rise) * delay, delay / 500.0)
    pressure = run[f"hose.{cells}.pressure"]
    assert pressure.max() == pytest.approx(1.002 * REST, rel=3e-4)
    after = int(np.argmax(pressure > 1.001 * REST))
    crossing = np.interp(1.001 * REST, pressure[after - 1 : after + 1], run.time[after - 1 : after + 1])
    return float(crossing / delay - 0.5 * rise)


def test_a_wave_comes_to_the_shut_end_after_the_time_of_sound() -> None:
    assert arrival(12, 0.5) == pytest.approx(1.0, abs=0.03)


@pytest.mark.slow
@pytest.mark.parametrize(("cells", "rise"), [(40, 0.01), (24, 0.2)])
def test_a_sudden_wave_does_so_with_more_cells(cells: int, rise: float) -> None:
    assert arrival(cells, rise) == pytest.approx(1.0, abs=0.03)


# --- resonance ---


def test_quarter_wave_rings_and_dies_away_as_on_the_laminar_line() -> None:
    cells = 12
    mode = {f"pressure_{k}": REST + 50.0 * math.sin(0.5 * math.pi * (k - 0.5) / cells) for k in range(1, cells + 1)}
    profile = mode | {f"temperature_{k}": T * (mode[f"pressure_{k}"] / REST) ** (2 / 7) for k in range(1, cells + 1)}
    run = shut(cells, profile=profile).simulate(0.12, 1e-4)

    def ringing(t: np.ndarray, height: float, decay: float, angular: float, phase: float) -> np.ndarray:
        return height * np.exp(-decay * t) * np.cos(angular * t + phase)

    swing = run[f"hose.{cells}.pressure"] - REST
    (_, decay, angular, _), _ = curve_fit(ringing, run.time, swing, [50.0, DECAY, QUARTER, 0.0])
    assert angular == pytest.approx(math.sqrt(QUARTER**2 - DECAY**2), rel=0.02)
    assert decay == pytest.approx(DECAY, rel=0.02)


@pytest.mark.parametrize("loss", ["iso6358", "friction"])
def test_frequency_converges_with_the_square_of_the_cells(loss: str) -> None:
    line = complex(-DECAY, math.sqrt(QUARTER**2 - DECAY**2))
    first = {cells: modes(shut(cells, loss=loss))[0] for cells in (4, 8, 16)}
    errors = [abs(first[cells] - line) / abs(line) for cells in (4, 8, 16)]
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(np.abs(slopes - 2.0) < 0.1)
    assert errors[1] < 0.002
    assert all(pole.real == pytest.approx(-DECAY, rel=1e-6) for pole in first.values())


def test_a_port_stands_at_the_very_end_of_its_tube() -> None:
    # Shut at both ends, for a source moves what it is told: half a wave in the length, whatever the ports are.
    hose = Tube(from_="pump.to", to="drain.from", length=LENGTH, bore=BORE, cells=10, inertia=True)
    drain = Orifice(from_="hose", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3, opening=0.0)
    both = Circuit({"pump": FlowSource(to="hose"), "hose": hose, "drain": drain})
    assert modes(both)[0].imag == pytest.approx(math.sqrt((2.0 * QUARTER) ** 2 - DECAY**2), rel=0.01)
    assert float(sum(both.parameters[f"hose.{k}.volume"] for k in range(1, 11))) == pytest.approx(
        0.25 * math.pi * BORE**2 * LENGTH
    )


# --- steady flow ---


def steady(ratio: float, **fields: object) -> float:
    """Mass flow rate through a tube between 7 bar and a part of it."""
    hose = Tube(from_="supply", to="end", length=LENGTH, bore=BORE, initial_pressure="4 bar", **fields)
    parts = {"supply": Reservoir(pressure="7 bar"), "hose": hose, "end": Reservoir(pressure=7e5 * ratio)}
    run = Circuit(parts).simulate(1.0, 0.5)
    at_end = run[f"hose.{len(hose.stores())}.mass_flow_rate"][-1]
    assert at_end == pytest.approx(run["hose.mass_flow_rate"][-1], rel=1e-4)
    return float(run["hose.mass_flow_rate"][-1])


@pytest.mark.parametrize("inertia", [False, True])
def test_steady_flow_is_that_of_the_iso_formula(inertia: bool) -> None:
    conductance, critical = iso6358.tube(LENGTH, BORE)
    for ratio in (0.05, 0.3, 0.45, 0.6, 0.8, 0.95, 0.99):
        whole = iso6358.mass_flow_rate(7e5, 7e5 * ratio, T, sonic_conductance=conductance, critical_ratio=critical)
        assert steady(ratio, cells=6, inertia=inertia) == pytest.approx(whole, rel=0.02), ratio


def test_steady_flow_backwards_and_with_c_and_b_of_a_catalogue() -> None:
    whole = -iso6358.mass_flow_rate(9e5, 7e5, T, sonic_conductance=2e-8, critical_ratio=0.4)
    assert steady(9 / 7, cells=6, sonic_conductance=2e-8, critical_ratio=0.4) == pytest.approx(whole, rel=0.02)


def colebrook(reynolds: float, roughness: float) -> float:
    """Friction factor, by a root search of its own."""
    return float(
        brentq(lambda f: 1 / math.sqrt(f) + 2 * math.log10(roughness / 3.7 + 2.51 / (reynolds * math.sqrt(f))), 1e-3, 1)
    )


@pytest.mark.parametrize("roughness", [0.0, 4e-6])
def test_steady_flow_with_friction_is_that_of_darcy_and_weisbach(roughness: float) -> None:
    area, ratio = 0.25 * math.pi * BORE**2, 0.9

    def excess(q: float) -> float:  # p1^2 - p2^2 = f L/d (q/A)^2 R T, isothermal
        factor = colebrook(4 * q / (math.pi * BORE * AIR_VISCOSITY_ANR), roughness / BORE)
        return factor * LENGTH / BORE * (q / area) ** 2 * R * T - 7e5**2 * (1 - ratio**2)

    found = steady(ratio, cells=6, inertia=True, loss="friction", roughness=roughness)
    assert found == pytest.approx(brentq(excess, 1e-4, 1e-1), rel=0.005)


def test_slow_steady_flow_is_laminar() -> None:
    drop = 5.0
    hose = Tube(from_="supply", to="end", length=LENGTH, bore=BORE, cells=6, inertia=True, initial_pressure=REST)
    parts = {"supply": Reservoir(pressure=REST + drop), "hose": hose, "end": Reservoir(pressure=REST)}
    found = Circuit(parts).simulate(2.0, 1.0)["hose.mass_flow_rate"][-1]
    assert found == pytest.approx(math.pi * DENSITY * BORE**4 * drop / (128 * AIR_VISCOSITY_ANR * LENGTH), rel=1e-3)


# --- everything at once ---


def test_mass_and_energy_are_kept_with_waves_and_warm_walls() -> None:
    hose = Tube(
        from_="valve.to", to="tank", length="5 m", bore=BORE, cells=6, inertia=True, wall_conductance="1 W/K",
        wall_temperature="60 degC",
    )  # fmt: skip
    valve = Orifice(from_="supply", to="hose", sonic_conductance=1e-8, critical_ratio=0.3)
    run = Circuit(
        {"supply": Reservoir(pressure="7 bar"), "valve": valve, "hose": hose, "tank": Chamber(volume="50 cm^3")}
    ).simulate(0.3)
    assert {r.store for r in run.residuals} == {"tank", *(f"hose.{k}" for k in range(1, 7))}
    assert all(r.error < 1e-12 * (r.through + r.inventory) for r in run.residuals)
    assert abs(run["hose.3.heat_flow_rate"]).max() > 1.0


def test_what_fills_through_a_tube_converges_with_its_cells() -> None:
    def filled(cells: int) -> np.ndarray:
        hose = Tube(from_="supply", to="tank", length="5 m", bore=BORE, cells=cells)
        parts = {"supply": Reservoir(pressure="7 bar"), "hose": hose, "tank": Chamber(volume="50 cm^3")}
        return np.asarray(Circuit(parts).simulate(0.2, 0.01)["tank.pressure"])

    best = filled(8)
    errors = [float(np.max(np.abs(filled(cells) - best))) for cells in (1, 2, 4)]
    assert errors[0] > 1.5 * errors[1] > 2.25 * errors[2]
    assert errors[2] < 0.02 * 6e5
