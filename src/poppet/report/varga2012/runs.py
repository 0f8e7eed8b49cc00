"""What the simulator finds about Varga & Keski-Honkola 2012: every number of the report, made at run time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from poppet import library
from poppet.circuit.circuit import Circuit
from poppet.laws import iso6358
from poppet.report.varga2012.circuits import (
    REPORTED_RISE,
    START,
    START_TEMPERATURE,
    STEP_TIMES,
    STEP_VALUES,
    STEPS_END,
    STROKES,
    SUPPLIES,
    SUPPLY,
    TANKS,
    TARGET,
    filling,
    staged,
    staircase_circuit,
    suspected,
)
from poppet.series.checks import FloatArray
from poppet.series.recording import Recording
from poppet.series.signals import Steps

_LONGEST, _ROWS_EVERY, _TOLERANCE = 600.0, 0.05, 1e-8
_SETTLED = 0.02  # part of the way that counts as arrived


@dataclass(frozen=True)
class Filling:
    """How a tank law fills the tank from 1 to 5 bar.

    Parameters
    ----------
    law : str
        What the law is called.
    time : float
        To 5 bar [s].
    end_temperature : float
        At 5 bar [K].
    peak_temperature : float
        Highest on the way [K].
    peak_time : float
        When that was [s].
    """

    law: str
    time: float
    end_temperature: float
    peak_temperature: float
    peak_time: float


@dataclass(frozen=True)
class WallConductance:
    """Wall conductances that explain the reported rise of temperature, at one supply pressure.

    Parameters
    ----------
    supply : float
        Absolute supply pressure [Pa].
    for_peak : float
        If the rise is the highest on the way [W/K].
    peak_time : float
        When that is [s].
    for_end : float
        If the rise is that at 5 bar [W/K].
    """

    supply: float
    for_peak: float
    peak_time: float
    for_end: float


@dataclass(frozen=True)
class Findings:
    """Everything the report says in numbers.

    Parameters
    ----------
    conductances, ratios : tuple of float
        C [m^3/(s Pa)] and b at `STROKES`.
    largest : tuple of float
        Stroke [m] and value [m^3/(s Pa)] of the largest C.
    smallest_ratio : tuple of float
        Stroke [m] and value of the smallest b.
    conductance_beyond : float
        What the polynomial gives at 1.2 mm [m^3/(s Pa)].
    zero_beyond : float
        Stroke beyond 1 mm at which the polynomial is zero [m].
    suspected_largest : float
        Largest C with the suspected digit [m^3/(s Pa)].
    law_deviation : float
        Largest difference between eqs (1), (2) as printed and the flow law, of choked flow.
    downstream_error : float
        Relative error of choked flow if T1 were the downstream temperature of the adiabatic tank.
    leak : float
        Mass flow rate of the printed polynomial at stroke zero, from the supply into the start state [kg/s].
    fillings : dict
        Filling by key.
    walls : tuple of WallConductance
        One per supply pressure of `SUPPLIES`.
    exponent : float
        Polytropic exponent that gives the reported rise at 5 bar.
    pressure_drop : float
        By which pressure falls after closing, with the wall of the peak rise [Pa].
    slow_time, slow_time_constant : float
        Time to 5 bar at 0.1 mm, with C and b there and with those at 0.5 mm [s].
    settling_time : float
        Of the stroke after a pilot step of 3 bar, paper mode [s].
    open_end : tuple of float
        Pressure after 600 s with 1 and 4 bar g pilot pressure, paper mode [Pa].
    exhaust_strokes : tuple of float
        Stroke while emptying from 2, 4 and 6 bar [m].
    stroke_printed, stroke_fig5 : float
        Stroke at 3 bar g by eq. (5) and with the sign of fig. 5 [m].
    staircase : Recording
        Fig. 6: required value and the tank pressure by each law.
    """

    conductances: tuple[float, ...]
    ratios: tuple[float, ...]
    largest: tuple[float, float]
    smallest_ratio: tuple[float, float]
    conductance_beyond: float
    zero_beyond: float
    suspected_largest: float
    law_deviation: float
    downstream_error: float
    leak: float
    fillings: dict[str, Filling]
    walls: tuple[WallConductance, ...]
    exponent: float
    pressure_drop: float
    slow_time: float
    slow_time_constant: float
    settling_time: float
    open_end: tuple[float, float]
    exhaust_strokes: tuple[float, ...]
    stroke_printed: float
    stroke_fig5: float
    staircase: Recording

    @property
    def wall(self) -> WallConductance:
        """The wall conductances at the supply pressure of the report."""
        return next(wall for wall in self.walls if wall.supply == SUPPLY)


def find(progress: Callable[[str], Any]) -> Findings:
    """Run everything."""
    progress("tank laws")
    exponent = _polytropic_exponent()
    progress("wall conductances")
    walls = tuple(_wall_conductance(supply) for supply in SUPPLIES)
    wall = walls[SUPPLIES.index(SUPPLY)].for_peak
    fillings = _fillings(wall, exponent)
    progress("main stage")
    printed, drawn = _strokes_by_sign()
    return Findings(
        **_curve_findings(),
        law_deviation=_law_deviation(),
        downstream_error=(START_TEMPERATURE / fillings["adiabatic"].end_temperature) ** 0.5 - 1.0,
        leak=float(_filled(stroke=0.0)["valve.mass_flow_rate"][0]),
        fillings=fillings,
        walls=walls,
        exponent=exponent,
        pressure_drop=_pressure_drop(wall, fillings["wall of the peak"].time),
        slow_time=float(_filled(stroke=0.1e-3, thermal="isothermal").time[-1]),
        slow_time_constant=fillings["isothermal"].time,
        settling_time=_settling_time(),
        open_end=(_open_end(1e5), _open_end(4e5)),
        exhaust_strokes=tuple(_exhaust_stroke(pressure) for pressure in (2e5, 4e5, 6e5)),
        stroke_printed=printed,
        stroke_fig5=drawn,
        staircase=_staircase(wall, progress),
    )


# --- Characteristics ---


def _curve_findings() -> dict[str, Any]:
    from scipy.optimize import brentq

    curve = library.characteristic("varga2012")
    polynomial = curve.sonic_conductance
    conductances, ratios = _table()
    return {
        "conductances": conductances,
        "ratios": ratios,
        "largest": _extreme(curve.sonic_conductance_at, -1.0),
        "smallest_ratio": _extreme(curve.critical_ratio_at, 1.0),
        "conductance_beyond": float(polynomial(1.2e-3)),
        "zero_beyond": float(brentq(polynomial, 1e-3, 1.2e-3)),
        "suspected_largest": _extreme(suspected().sonic_conductance_at, -1.0)[1],
    }


def _extreme(curve: Callable[[FloatArray], FloatArray], sign: float) -> tuple[float, float]:
    """Stroke [m] and value where `sign` times the curve is least, on 0..1 mm."""
    strokes = np.linspace(0.0, 1e-3, 100_001)
    values = np.asarray(curve(strokes))
    place = int(np.argmin(sign * values))
    return float(strokes[place]), float(values[place])


def _law_deviation() -> float:
    """Eqs (1) and (2), typed as they are printed, against the flow law, outside its regularised zone."""
    p1, ratio = SUPPLY, np.linspace(0.0, iso6358.LAMINAR_RATIO, 2001)
    deviations = []
    for c, b in zip(*_table(), strict=True):
        choked = c * p1 * iso6358.REFERENCE_DENSITY
        bracket = 1.0 - ((ratio - b) / (1.0 - b)) ** 2
        printed = np.where(ratio <= b, choked, choked * np.sqrt(np.where(ratio <= b, 1.0, bracket)))
        law = iso6358.mass_flow_rate(p1, ratio * p1, 293.15, sonic_conductance=c, critical_ratio=b)
        deviations.append(float(np.max(np.abs(law - printed))) / choked)
    return max(deviations)


def _table() -> tuple[tuple[float, ...], tuple[float, ...]]:
    """C [m^3/(s Pa)] and b at the strokes of the table."""
    curve = library.characteristic("varga2012")
    conductances = tuple(float(curve.sonic_conductance_at(x)) for x in STROKES)
    return conductances, tuple(float(curve.critical_ratio_at(x)) for x in STROKES)


# --- Filling at a fixed stroke ---


def _filled(**given: Any) -> Recording:
    """Run `filling` until the tank holds 5 bar."""
    return _run_to_target(filling(**given))


def _run_to_target(circuit: Circuit) -> Recording:
    return circuit.simulate(_LONGEST, _ROWS_EVERY, _TOLERANCE, stop_when=f"tank.pressure > {TARGET:.0f} Pa")


def _fillings(wall: float, exponent: float) -> dict[str, Filling]:
    laws: dict[str, tuple[str, dict[str, Any]]] = {
        "isothermal": ("isothermal", {"thermal": "isothermal"}),
        "isentrope": ("isentrope, the paper's tank", {"thermal": "isentrope"}),
        "adiabatic": ("energy balance, adiabatic", {}),
        "wall 30": ("energy balance, h A = 30 W/K", {"wall_conductance": 30.0}),
        "wall of the peak": (
            f"energy balance, h A = {wall:.1f} W/K (peak +{REPORTED_RISE:.0f} K)",
            {"wall_conductance": wall},
        ),
        "wall 100": ("energy balance, h A = 100 W/K", {"wall_conductance": 100.0}),
        "polytropic": (
            f"polytropic, n = {exponent:.4f} (+{REPORTED_RISE:.0f} K at 5 bar)",
            {"thermal": "polytropic", "polytropic_exponent": exponent},
        ),
    }
    return {key: _filling_of(law, _filled(**options)) for key, (law, options) in laws.items()}


def _filling_of(law: str, recording: Recording) -> Filling:
    temperature = recording["tank.temperature"]
    peak = int(np.argmax(temperature))
    return Filling(
        law,
        float(recording.time[-1]),
        float(temperature[-1]),
        float(temperature[peak]),
        float(recording.time[peak]),
    )


def _polytropic_exponent() -> float:
    from scipy.optimize import brentq

    circuit = filling(thermal="polytropic", polytropic_exponent=1.1)

    def excess(exponent: float) -> float:
        changed = circuit.with_values({"tank.polytropic_exponent": exponent})
        return float(_run_to_target(changed)["tank.temperature"][-1]) - START_TEMPERATURE - REPORTED_RISE

    return float(brentq(excess, 1.001, 1.4, xtol=1e-7))


def _wall_conductance(supply: float) -> WallConductance:
    from scipy.optimize import brentq

    circuit = filling(supply)

    @cache
    def filled(wall: float) -> Filling:
        return _filling_of("", _run_to_target(circuit.with_values({"tank.wall_conductance": wall})))

    wanted = START_TEMPERATURE + REPORTED_RISE
    peak = float(brentq(lambda wall: filled(wall).peak_temperature - wanted, 5.0, 500.0, xtol=1e-4))
    end = float(brentq(lambda wall: filled(wall).end_temperature - wanted, 5.0, 500.0, xtol=1e-4))
    return WallConductance(supply, peak, filled(peak).peak_time, end)


def _pressure_drop(wall: float, closing_time: float) -> float:
    """Fall of pressure after the valve has closed at 5 bar, while the gas cools to the wall."""
    circuit = filling(wall_conductance=wall)
    closing = Steps([0.0, closing_time], [1.0, 0.0])
    closed = Circuit(circuit.parts, {"valve.opening": closing})
    recording = closed.simulate(_LONGEST, _ROWS_EVERY, _TOLERANCE)
    return float(TARGET - recording["tank.pressure"][-1])


# --- Main stage ---


def _settling_time() -> float:
    """Last time at which the stroke is more than 2 % of its way from where it comes to rest."""
    run = staged("paper", Steps([0.0], [4e5])).simulate(0.05, 1e-5, 1e-6)
    stroke = run["valve.stroke"]
    away = np.abs(stroke - stroke[-1]) > _SETTLED * np.abs(stroke[-1] - stroke[0])
    return float(run.time[np.flatnonzero(away)[-1] + 1])


def _open_end(pilot: float) -> float:
    """Tank pressure after 600 s at a constant pilot gauge pressure, paper mode [Pa]."""
    run = staged("paper", Steps([0.0], [START + pilot]), thermal="isothermal").simulate(_LONGEST)
    return float(run["tank.pressure"][-1])


def _exhaust_stroke(pressure: float) -> float:
    """Stroke after 1 s of emptying without pilot pressure, paper mode [m]."""
    return float(staged("paper", initial_pressure=pressure).simulate(1.0)["valve.stroke"][-1])


def _strokes_by_sign() -> tuple[float, float]:
    """Stroke at 3 bar g: simulated with eq. (5), and at rest with k2 (h2 - x) as fig. 5 shows."""
    circuit = staged("paper", Steps([0.0], [4e5]))
    valve: Any = circuit.parts["valve"]
    k1, h1 = float(valve.upper_spring.rate), float(valve.upper_spring.preload)
    k2, h2 = float(valve.lower_spring.rate), float(valve.lower_spring.preload)
    drawn = (float(valve.plate_area) * 3e5 - k1 * h1 - k2 * h2) / (k1 - k2)
    return float(circuit.simulate(0.1)["valve.stroke"][-1]), drawn


# --- Fig. 6 ---


def _staircase(wall: float, progress: Callable[[str], Any]) -> Recording:
    time, series = np.zeros(0), {}
    for name, options in TANKS.items():
        progress(f"figure 6, {name}")
        if name == "wall":
            options = {"wall_conductance": wall}
        run = staircase_circuit(**options).simulate(STEPS_END, 0.1, 1e-6)
        time = run.time
        series[f"{name}.pressure [Pa]"] = run["tank.pressure"]
        series[f"{name}.temperature [K]"] = run["tank.temperature"]
    required = Steps(STEP_TIMES, STEP_VALUES).evaluate(time)
    return Recording.from_series(time, {"required.pressure [Pa]": required, **series}, title="Figure 6")
