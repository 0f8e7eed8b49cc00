"""Circuits and simulations of the report on Varga & Keski-Honkola 2012.

The paper does not state the supply of its tank. Assumed are a supply of 7 bar absolute at 20 degC, a tank that starts
at 1 bar and 20 degC, and four steps of 30 s for the staircase of fig. 6.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from poppet import library
from poppet.circuit.circuit import BaseCircuit
from poppet.core.provenance import assumed
from poppet.laws import iso6358
from poppet.laws.curves import Characteristic
from poppet.parts import Chamber, MainStage, Orifice, Reservoir
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.recording import Recording
from poppet.timeseries.signals import Signal, Steps

VOLUME = "0.2 m^3"  # section 3
REPORTED_RISE = 18.0  # "approximately 18 degC", section 3 [K]
TARGET = 5e5  # the last step of fig. 6 within its axis [Pa]
START, START_TEMPERATURE = 1e5, 293.15  # assumed: the ambient state [Pa], [K]
SUPPLY = 7e5  # assumed; not printed [Pa]
STROKE = 0.5e-3  # where C(x) is largest, rounded [m]
SUPPLIES = (5.5e5, 6e5, 7e5)  # [Pa]
STROKES = tuple(1e-4 * k for k in range(11))  # [m]
STEP_TIMES = (0.0, 30.0, 60.0, 90.0)  # chosen [s]
STEP_VALUES = (2e5, 3e5, 4e5, 5e5)  # chosen, within the axis of fig. 6 [Pa]
STEPS_END = 120.0  # end of the time axis of fig. 6 [s]
SUSPECTED_K5 = -2.2229e-6  # one digit changed from the printed -2.2269e-6 [m^3/(s Pa)]
TANKS: dict[str, dict[str, Any]] = {
    "isentrope": {"thermal": "isentrope"},
    "adiabatic": {},
    "wall": {},  # with the identified wall conductance
    "isothermal": {"thermal": "isothermal"},
}
"""Tanks of fig. 6 and their thermal laws."""

_LONGEST, _ROWS_EVERY, _TOLERANCE = 600.0, 0.05, 1e-8
_SETTLED = 0.02  # settling band relative to the travel


@dataclass(frozen=True)
class Filling:
    """Result of filling the tank from 1 to 5 bar with one thermal law."""

    law: str
    time: float  # to 5 bar [s]
    end_temperature: float  # at 5 bar [K]
    peak_temperature: float  # maximum during the filling [K]
    peak_time: float  # [s]


@dataclass(frozen=True)
class WallConductance:
    """Wall conductances that explain the temperature rise in the paper, for one supply pressure."""

    supply: float  # absolute [Pa]
    for_peak: float  # if the rise is the maximum [W/K]
    peak_time: float  # time of the maximum [s]
    for_end: float  # if the rise is at 5 bar [W/K]


@dataclass(frozen=True)
class Findings:
    """All simulated values that the report states.

    The file `results.json` contains most of them under the same names.
    """

    conductances: tuple[float, ...]  # C at `STROKES` [m^3/(s Pa)]
    ratios: tuple[float, ...]  # b at `STROKES`
    largest: tuple[float, float]  # stroke [m] and value of the largest C [m^3/(s Pa)]
    smallest_ratio: tuple[float, float]  # stroke [m] and value of the smallest b
    conductance_beyond: float  # value of the polynomial at 1.2 mm [m^3/(s Pa)]
    zero_beyond: float  # stroke beyond 1 mm at which the polynomial is zero [m]
    suspected_largest: float  # largest C with the suspected digit [m^3/(s Pa)]
    law_deviation: float  # maximum deviation of the flow law from eqs (1), (2), relative to choked flow
    downstream_error: float  # of choked flow if T1 were the temperature in the adiabatic tank, relative
    leak: float  # of the printed polynomial at stroke zero, from the supply into the start state [kg/s]
    fillings: dict[str, Filling]
    walls: tuple[WallConductance, ...]  # one per supply pressure of `SUPPLIES`
    exponent: float  # polytropic exponent for the reported rise at 5 bar
    pressure_drop: float  # after closing, with the wall of the peak rise [Pa]
    slow_time: float  # to 5 bar at 0.1 mm, with C and b there [s]
    slow_time_constant: float  # the same with C and b at 0.5 mm [s]
    settling_time: float  # of the stroke after a pilot step of 3 bar, paper mode [s]
    open_end: tuple[float, float]  # pressure after 600 s with 1 and 4 bar g pilot pressure, paper mode [Pa]
    exhaust_strokes: tuple[float, ...]  # while emptying from 2, 4 and 6 bar [m]
    stroke_printed: float  # at 3 bar g by eq. (5) [m]
    stroke_fig5: float  # the same with the sign of fig. 5 [m]
    staircase: Recording  # fig. 6: required value and the tank pressure by each law

    @property
    def wall(self) -> WallConductance:
        """Wall conductances for the supply pressure that the report assumes."""
        return next(wall for wall in self.walls if wall.supply == SUPPLY)


def run_simulations(progress: Callable[[str], Any]) -> Findings:
    """Run all simulations of the report, and return their results.

    The function `progress` is called with a text before each group of simulations.
    """
    progress("tank laws")
    polytropic = filling_circuit(thermal="polytropic", polytropic_exponent=1.1)

    def excess(exponent: float) -> float:
        changed = polytropic.with_values({"tank.polytropic_exponent": exponent})
        return float(_run_to_target(changed)["tank.temperature"][-1]) - START_TEMPERATURE - REPORTED_RISE

    exponent = _root(excess, 1.001, 1.4, xtol=1e-7)
    progress("wall conductances")
    walls = tuple(_wall_conductance(supply) for supply in SUPPLIES)
    wall = walls[SUPPLIES.index(SUPPLY)].for_peak
    fillings = _fillings(wall, exponent)
    # After the valve has closed at 5 bar, the gas cools to the wall.
    closing = Steps([0.0, fillings["wall of the peak"].time], [1.0, 0.0])
    closed = BaseCircuit(filling_circuit(wall_conductance=wall).parts, {"valve.opening": closing})
    end_pressure = closed.simulate(_LONGEST, _ROWS_EVERY, _TOLERANCE)["tank.pressure"][-1]
    progress("main stage")
    # Equilibrium stroke at 3 bar g: by eq. (5) of the paper, and with k2 (h2 - x) as in fig. 5.
    stage = main_stage_circuit("paper", Steps([0.0], [4e5]))
    valve: Any = stage.parts["valve"]
    k1, h1 = float(valve.upper_spring.rate), float(valve.upper_spring.preload)
    k2, h2 = float(valve.lower_spring.rate), float(valve.lower_spring.preload)
    stroke_drawn = (float(valve.plate_area) * 3e5 - k1 * h1 - k2 * h2) / (k1 - k2)
    open_ends = [
        main_stage_circuit("paper", Steps([0.0], [START + pilot]), thermal="isothermal").simulate(_LONGEST)[
            "tank.pressure"
        ][-1]
        for pilot in (1e5, 4e5)
    ]
    # Without pilot pressure the valve empties the tank. After 1 s its plate is at rest.
    emptying = [
        main_stage_circuit("paper", initial_pressure=pressure).simulate(1.0)["valve.stroke"][-1]
        for pressure in (2e5, 4e5, 6e5)
    ]
    # After the settling time, the stroke stays within 2 % of its travel from the final value.
    run = main_stage_circuit("paper", Steps([0.0], [4e5])).simulate(0.05, 1e-5, 1e-6)
    stroke = run["valve.stroke"]
    is_away = np.abs(stroke - stroke[-1]) > _SETTLED * np.abs(stroke[-1] - stroke[0])
    settling_time = float(run.time[np.flatnonzero(is_away)[-1] + 1])
    time, series = np.zeros(0), {}
    for name, options in TANKS.items():
        progress(f"figure 6, {name}")
        wall_option = {"wall_conductance": wall} if name == "wall" else {}
        run = staircase_circuit(**options, **wall_option).simulate(STEPS_END, 0.1, 1e-6)
        time = run.time
        series[f"{name}.pressure [Pa]"] = run["tank.pressure"]
        series[f"{name}.temperature [K]"] = run["tank.temperature"]
    required = {"required.pressure [Pa]": Steps(STEP_TIMES, STEP_VALUES).evaluate(time)}
    return Findings(
        **_curve_findings(),
        downstream_error=(START_TEMPERATURE / fillings["adiabatic"].end_temperature) ** 0.5 - 1.0,
        leak=float(_simulate_filling(stroke=0.0)["valve.mass_flow_rate"][0]),
        fillings=fillings,
        walls=walls,
        exponent=exponent,
        pressure_drop=float(TARGET - end_pressure),
        slow_time=float(_simulate_filling(stroke=0.1e-3, thermal="isothermal").time[-1]),
        slow_time_constant=fillings["isothermal"].time,
        settling_time=settling_time,
        open_end=(float(open_ends[0]), float(open_ends[1])),
        exhaust_strokes=tuple(map(float, emptying)),
        stroke_printed=float(stage.simulate(0.1)["valve.stroke"][-1]),
        stroke_fig5=stroke_drawn,
        staircase=Recording.from_series(time, required | series, title="Figure 6"),
    )


# --- Circuits ---


def filling_circuit(supply: float = SUPPLY, stroke: float = STROKE, **tank: Any) -> BaseCircuit:
    """Return a circuit that fills a tank through a main stage with a constant stroke.

    It is the right half of fig. 5 of the paper. `supply` is the pressure [Pa], and `stroke` is in m. The keyword
    arguments are further fields of the tank.
    """
    valve = Orifice(from_="supply", to="tank", characteristic="varga2012", stroke=stroke)
    return _between(supply, valve, tank, "Filling at a fixed stroke")


def main_stage_circuit(mode: str, pilot: Signal | None = None, **tank: Any) -> BaseCircuit:
    """Return a circuit in which a main stage with moving parts fills the tank.

    Port 3 is connected to the ambient. `mode` is the model of the moving parts, `pilot` the signal of the pilot
    pressure, and the keyword arguments are further fields of the tank.
    """
    valve = MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012", mode=mode)
    signals = {} if pilot is None else {"valve.pilot_pressure": pilot}
    return _between(SUPPLY, valve, tank, f"The main stage, {mode} mode, fills the tank", signals)


def _between(
    supply: float, valve: Any, tank: dict[str, Any], title: str, signals: dict[str, Signal] | None = None
) -> BaseCircuit:
    started: dict[str, Any] = {"volume": VOLUME, "initial_pressure": START, "initial_temperature": START_TEMPERATURE}
    parts = {
        "supply": Reservoir(pressure=supply, temperature=START_TEMPERATURE),
        "valve": valve,
        "tank": Chamber(**(started | tank)),
    }
    return BaseCircuit(parts, signals or {}, title=title)


def staircase_circuit(**tank: Any) -> BaseCircuit:
    """Return the circuit of fig. 6 of the paper, with a staircase of pilot pressures.

    The main stage regulates the tank pressure to the values of the staircase. The keyword arguments are further fields
    of the tank.
    """
    valve: Any = main_stage_circuit("regulator").parts["valve"]
    springs = valve.upper_spring, valve.lower_spring
    # The pilot pressure also balances the springs: the valve closes at the required outlet pressure.
    lift = sum(float(spring.rate) * float(spring.preload) for spring in springs) / float(valve.plate_area)
    return main_stage_circuit("regulator", Steps(STEP_TIMES, [value + lift for value in STEP_VALUES]), **tank)


def suspected_characteristic() -> Characteristic:
    """Return the printed characteristic with one changed digit in the coefficient k5.

    The axis range of fig. 3 suggests this misprint.
    """
    changed = assumed(SUSPECTED_K5, "m^3/(s Pa)", "one digit changed from the printed -2.2269e-6")
    return library.characteristic("varga2012").with_numbers({"sonic_conductance.k5": changed})


# --- Characteristics ---


def _curve_findings() -> dict[str, Any]:
    curve = library.characteristic("varga2012")
    polynomial = curve.sonic_conductance
    conductances = tuple(float(curve.sonic_conductance_at(x)) for x in STROKES)
    ratios = tuple(float(curve.critical_ratio_at(x)) for x in STROKES)
    # Deviation of eqs (1) and (2) of the paper from the flow law without its laminar range, relative to choked flow.
    p1, ratio, deviation = SUPPLY, np.linspace(0.0, iso6358.LAMINAR_RATIO, 2001), 0.0
    for c, b in zip(conductances, ratios, strict=True):
        choked = c * p1 * iso6358.REFERENCE_DENSITY
        bracket = 1.0 - ((ratio - b) / (1.0 - b)) ** 2
        printed = np.where(ratio <= b, choked, choked * np.sqrt(np.where(ratio <= b, 1.0, bracket)))
        law = iso6358.mass_flow_rate(p1, ratio * p1, 293.15, sonic_conductance=c, critical_ratio=b)
        deviation = max(deviation, float(np.max(np.abs(law - printed))) / choked)
    return {
        "conductances": conductances,
        "ratios": ratios,
        "largest": _extremum(curve.sonic_conductance_at, -1.0),
        "smallest_ratio": _extremum(curve.critical_ratio_at, 1.0),
        "conductance_beyond": float(polynomial(1.2e-3)),
        "zero_beyond": _root(polynomial, 1e-3, 1.2e-3),
        "suspected_largest": _extremum(suspected_characteristic().sonic_conductance_at, -1.0)[1],
        "law_deviation": deviation,
    }


def _extremum(curve: Callable[[FloatArray], FloatArray], sign: float) -> tuple[float, float]:
    """Return stroke [m] and value at an extremum of a curve.

    The range of strokes is 0 to 1 mm. The extremum is a minimum if `sign` is 1, and a maximum if it is -1.
    """
    strokes = np.linspace(0.0, 1e-3, 100_001)
    values = np.asarray(curve(strokes))
    index = int(np.argmin(sign * values))
    return float(strokes[index]), float(values[index])


def _root(function: Callable[[float], Any], low: float, high: float, **tolerance: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(function, low, high, **tolerance))


# --- Filling at a fixed stroke ---


def _simulate_filling(**options: Any) -> Recording:
    """Simulate the filling of the tank until its pressure is 5 bar.

    The keyword arguments are arguments of `filling_circuit`.
    """
    return _run_to_target(filling_circuit(**options))


def _run_to_target(circuit: BaseCircuit) -> Recording:
    return circuit.simulate(_LONGEST, _ROWS_EVERY, _TOLERANCE, stop_when=f"tank.pressure > {TARGET:.0f} Pa")


def _fillings(wall: float, exponent: float) -> dict[str, Filling]:
    rise = f"+{REPORTED_RISE:.0f} K"
    laws: dict[str, tuple[str, dict[str, Any]]] = {
        "isothermal": ("isothermal", {"thermal": "isothermal"}),
        "isentrope": ("isentrope, the paper's tank", {"thermal": "isentrope"}),
        "adiabatic": ("energy balance, adiabatic", {}),
        "wall 30": ("energy balance, h A = 30 W/K", {"wall_conductance": 30.0}),
        "wall of the peak": (f"energy balance, h A = {wall:.1f} W/K (peak {rise})", {"wall_conductance": wall}),
        "wall 100": ("energy balance, h A = 100 W/K", {"wall_conductance": 100.0}),
        "polytropic": (
            f"polytropic, n = {exponent:.4f} ({rise} at 5 bar)",
            {"thermal": "polytropic", "polytropic_exponent": exponent},
        ),
    }
    return {key: _filling_of(law, _simulate_filling(**options)) for key, (law, options) in laws.items()}


def _filling_of(law: str, recording: Recording) -> Filling:
    time, temperature = recording.time, recording["tank.temperature"]
    peak = int(np.argmax(temperature))
    return Filling(law, float(time[-1]), float(temperature[-1]), float(temperature[peak]), float(time[peak]))


def _wall_conductance(supply: float) -> WallConductance:
    circuit = filling_circuit(supply)

    @cache  # the two searches have the same limits
    def filled(wall: float) -> Filling:
        return _filling_of("", _run_to_target(circuit.with_values({"tank.wall_conductance": wall})))

    target = START_TEMPERATURE + REPORTED_RISE
    peak = _root(lambda wall: filled(wall).peak_temperature - target, 5.0, 500.0, xtol=1e-4)
    end = _root(lambda wall: filled(wall).end_temperature - target, 5.0, 500.0, xtol=1e-4)
    return WallConductance(supply, peak, filled(peak).peak_time, end)


# --- Main stage ---


# --- Fig. 6 ---
