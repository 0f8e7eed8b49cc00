"""The circuits behind the report on Varga & Keski-Honkola 2012, and what had to be chosen for them.

The paper leaves open what was fed to its tank, so some things are chosen: a supply of 7 bar absolute at
20 degC, a tank that starts at 1 bar and 20 degC, and for the staircase of fig. 6 four steps of 30 s.
"""

from __future__ import annotations

from typing import Any

from poppet import library
from poppet.circuit.circuit import Circuit
from poppet.ground.provenance import assumed
from poppet.laws.curves import Characteristic
from poppet.parts import Chamber, MainStage, Orifice, Reservoir
from poppet.series.signals import Signal, Steps

VOLUME = "0.2 m^3"  # section 3
REPORTED_RISE = 18.0  # "approximately 18 degC", section 3 [K]
TARGET = 5e5  # the last step of fig. 6 that its axis shows whole [Pa]
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
    "wall": {},  # with the wall conductance that is found
    "isothermal": {"thermal": "isothermal"},
}
"""Tanks of fig. 6 and their thermal laws."""

_TANK: dict[str, Any] = {
    "volume": VOLUME,
    "initial_pressure": START,
    "initial_temperature": START_TEMPERATURE,
}


def suspected() -> Characteristic:
    """The printed polynomials with one digit of k5 changed: a hypothesis that fig. 3 suggests."""
    changed = assumed(SUSPECTED_K5, "m^3/(s Pa)", "one digit changed from the printed -2.2269e-6")
    return library.characteristic("varga2012").with_numbers({"sonic_conductance.k5": changed})


def filling(supply: float = SUPPLY, stroke: float = STROKE, **tank: Any) -> Circuit:
    """The right half of fig. 5: a supply, the main stage held at a stroke, the tank."""
    return Circuit(
        {
            "supply": Reservoir(pressure=supply, temperature=START_TEMPERATURE),
            "valve": Orifice(from_="supply", to="tank", characteristic="varga2012", stroke=stroke),
            "tank": Chamber(**(_TANK | tank)),
        },
        title="Filling at a fixed stroke",
    )


def staged(mode: str, pilot: Signal | None = None, **tank: Any) -> Circuit:
    """A supply, the main stage with its mechanics, the tank, and the open air behind port 3."""
    return Circuit(
        {
            "supply": Reservoir(pressure=SUPPLY, temperature=START_TEMPERATURE),
            "valve": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012", mode=mode),
            "tank": Chamber(**(_TANK | tank)),
        },
        {} if pilot is None else {"valve.pilot_pressure": pilot},
        title=f"The main stage, {mode} mode, fills the tank",
    )


def staircase_circuit(**tank: Any) -> Circuit:
    """Fig. 6: the regulator follows the required value, which its pilot pressure sets."""
    valve: Any = staged("regulator").parts["valve"]
    springs = valve.upper_spring, valve.lower_spring
    lift = sum(float(spring.rate) * float(spring.preload) for spring in springs) / float(valve.plate_area)
    return staged("regulator", Steps(STEP_TIMES, [value + lift for value in STEP_VALUES]), **tank)
