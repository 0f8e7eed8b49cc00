"""Twin of the DAMADICS actuator from parts of the package, and the signals that a control room has of it.

The positioner is a part of the harness, because no built-in controller is continuous: it compares command and position
and opens the supply or the exhaust of the chamber. Its flow law is ISO 6358. Chamber, spring, diaphragm, stem and leak
are built-in parts.

The twin knows the data sheet of the actuator and of the water valve. The sizes of the passages of the positioner come
from a healthy recording, because the law of the benchmark is not ISO 6358.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

import poppet
from poppet.core.symbolic import clip, maximum
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.flow_path import FlowPath, named_flow
from poppet.parts.part import GasState, Input, PassageFlows, Scope, State

STROKE = 0.0381


@dataclass(frozen=True)
class Positioner(FlowPath):
    """Pneumatic positioner: a proportional controller of a position with a three-way valve."""

    kind: ClassVar[str] = "test_positioner"
    summary: ClassVar[str] = "a proportional controller of a position with a three-way valve"
    regimes: ClassVar[tuple[str, ...]] = ("supply_regime", "exhaust_regime")

    supply: str | None = port("gas node of the air supply")
    outlet: str | None = port("gas node of the actuator")
    exhaust: str | None = port("gas node of the exhaust")
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", doc="C from outlet to exhaust", low=0.0)
    setpoint: NumberLike = number("1", 0.5, doc="command", low=0.0, high=1.024)
    gain: NumberLike = number("1", 100.0, doc="gain of the controller", above=0.0)
    current_factor: NumberLike = number("1", 1.0, doc="factor on the current of the transducer", low=0.0)
    sensor_factor: NumberLike = number("1", 1.0, doc="factor on the sensed position", above=0.0)
    lag: NumberLike = number("s", 0.30, doc="each of two lags of the command", above=0.0)
    delay: NumberLike = number("s", 0.0175, doc="half the sample time of the controller", above=0.0)

    def states(self) -> tuple[State, ...]:
        return tuple(State(name, "1", 1.0) for name in ("first_lag", "second_lag", "current"))

    def inputs(self) -> tuple[Input, ...]:
        return Input("setpoint", "1", "setpoint", is_command=True), Input("position", "m", 0.0)

    def start(self, scope: Scope) -> dict[str, Any]:
        setpoint = scope.inputs["setpoint"]
        return {"first_lag": setpoint, "second_lag": setpoint, "current": 0.0}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        sensed = scope["sensor_factor"] * scope.inputs["position"]
        u = clip(sensed / STROKE - 0.5, -0.75, 0.75)
        # The lever of the sensor: an arc sine as its series, whose error is below 1e-4 between the stops.
        angle = u * (1.0 + u**2 * (1 / 6 + u**2 * (3 / 40 + u**2 * (15 / 336 + u**2 * (105 / 3456)))))
        feedback = angle * (3.0 / np.pi) + 0.5
        command = clip(scope["gain"] * (scope.states["second_lag"] - feedback), -1.0, 1.0)
        current = scope.states["current"]
        opening = 0.04 * (current + 0.04) + (0.98 / 0.40 - 0.04) * maximum(current - 0.46, 0.0)
        opening = opening - (0.53 / 0.40 - 0.04) * maximum(-0.54 - current, 0.0)
        opening = clip(scope["current_factor"] * clip(opening, -0.55, 1.0), -1.0, 1.0)
        sizes = (
            scope["sonic_conductance"] * maximum(opening, 0.0),
            scope["exhaust_conductance"] * maximum(-opening, 0.0),
        )
        fill, fill_outputs = named_flow(scope, gas, "supply", ("supply", "outlet"), (sizes[0], scope["critical_ratio"]))
        vent, vent_outputs = named_flow(
            scope, gas, "exhaust", ("outlet", "exhaust"), (sizes[1], scope["critical_ratio"])
        )
        first, second = scope.states["first_lag"], scope.states["second_lag"]
        rates = {
            "first_lag": (scope.inputs["setpoint"] - first) / scope["lag"],
            "second_lag": (first - second) / scope["lag"],
            "current": (command - current) / scope["delay"],
        }
        readings = {
            "reading": (sensed / STROKE, "1"),
            "discrepancy": ((scope["sensor_factor"] - 1.0) * scope.inputs["position"] / STROKE, "1"),
        }
        outputs = {"opening": (opening, "1"), **readings, **fill_outputs, **vent_outputs}
        return PassageFlows((fill, vent), outputs, rates)


def twin(**values: Any) -> poppet.Circuit:
    """Return the circuit of the twin; `values` are values of the positioner."""
    parts = {
        "air": poppet.Reservoir(pressure="6 bar g"),
        "stem": poppet.Mass(
            mass="2 kg", inclination="-90 deg", initial_position="19 mm",
            friction={"kind": "viscous", "viscous_coefficient": "1500 N s/m"},
            lower_stop={"position": "0 mm"}, upper_stop={"position": "38.1 mm"},
        ),
        "actuator": poppet.Cylinder(
            body="stem", bore=float(np.sqrt(4.0 * 0.029 / np.pi)), stroke_length="60 mm", acting="single",
            spring={"rate": "60892 N/m", "preload": "9.525 mm"},
            cap={"dead_volume": "5.5 l", "wall_conductance": "50 W/K", "initial_pressure": "2.4 bar"},
        ),
        "positioner": Positioner(
            supply="air", outlet="actuator.cap", exhaust="ambient",
            **{"sonic_conductance": 2.5e-9, "exhaust_conductance": 5e-9, "critical_ratio": 0.5} | values,
        ),
        "leak": poppet.Orifice(from_="actuator.cap", to="ambient", sonic_conductance=0.0, critical_ratio=0.3),
    }  # fmt: skip
    ambient = poppet.Ambient(pressure=101325.0, temperature=293.0)
    # An error of 1e-4 of the stroke is small beside the noise of the readings.
    run = poppet.Run(relative_tolerance=1e-4)
    return poppet.Circuit(parts, connections={"positioner.position": "stem.position"}, ambient=ambient, run=run)


# Water valve, from its data sheet: plug diameter [m], Kv, equal-percentage exponent, recovery coefficient by travel.
PLUG_AREA = np.pi * 0.050**2 / 4.0
RECOVERY = (
    (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99, 1),
    (1, 0.95, 0.9, 0.85, 0.785, 0.725, 0.67, 0.61, 0.555, 0.5, 0.45, 0.4),
)
FLOW_LIMIT = 39.0  # the flow meter ends at 40 t/h
GRID = 2  # rows per second of the inputs; readings have one


def line_frequency(series: np.ndarray) -> float:
    """Return the frequency [Hz] of the largest line of a series at 1 Hz: its periodogram, refined by least squares."""
    centred = series - series.mean()
    spectrum = np.abs(np.fft.rfft(centred, 16 * centred.size))
    best = float(np.argmax(spectrum)) / (16 * centred.size)
    for width in (1e-4, 1e-5, 1e-6):
        trials = best + width * np.linspace(-5.0, 5.0, 21)
        k = np.arange(series.size)
        powers = [abs(np.exp(-2j * np.pi * f * k) @ centred) for f in trials]
        best = float(trials[int(np.argmax(powers))])
    return best


def line_filter(series: np.ndarray, frequency: float, memory: float = 60.0) -> np.ndarray:
    """Return mean and line of a series at 1 Hz, on the grid of the inputs; each value uses the past only.

    The filter is recursive least squares of a mean and a sine of known frequency, with exponential forgetting.
    """
    forget = np.exp(-1.0 / memory)
    turn = 2.0 * np.pi * frequency
    information, vector = 1e-6 * np.eye(3), np.array([1e-6 * series[0], 0.0, 0.0])
    out = np.empty((series.size - 1) * GRID + 1)
    for k, value in enumerate(series):
        row = np.array([1.0, np.cos(turn * k), np.sin(turn * k)])
        information = forget * information + np.outer(row, row)
        vector = forget * vector + value * row
        fit = np.linalg.solve(information, vector)
        first = max((k - 1) * GRID + 1, 0)
        t = np.arange(first, k * GRID + 1) / GRID
        out[first : k * GRID + 1] = fit[0] + fit[1] * np.cos(turn * t) + fit[2] * np.sin(turn * t)
    return out


def columns(measured: Mapping[str, np.ndarray], lines: tuple[float, float]) -> dict[str, np.ndarray]:
    """Return the columns for the twin: time, command, force of the water on the plug, and readings (NaN: none).

    The readings are the position, and its difference to the position that the flow through the valve indicates.
    """
    rows = measured["X"].size
    time = np.arange((rows - 1) * GRID + 1) / GRID
    whole = np.arange(rows, dtype=float)
    upstream, downstream = (line_filter(measured[name], f) for name, f in zip(("P1", "P2"), lines, strict=True))
    command, travel = (np.interp(time, whole, measured[name]) for name in ("CV", "X"))
    force = (upstream - downstream) / np.interp(travel, *RECOVERY) * PLUG_AREA
    drop = (upstream - downstream)[::GRID] * 1e-6
    temperature = measured["T1"].mean()
    density = 1000.0 - (temperature - 4.0) ** 2 / 200.0  # of water, within 0.3 %
    with np.errstate(divide="ignore", invalid="ignore"):
        capacity = measured["F"] / (100.0 * 120.0 * np.sqrt(drop / density) * density / 1000.0)
        indicated = -np.log(capacity) / 5.0
    indicated = np.where((measured["F"] < FLOW_LIMIT) & (measured["F"] > 1.0), indicated, np.nan)
    readings = {name: np.full(time.size, np.nan) for name in ("X", "difference")}
    readings["X"][::GRID] = measured["X"]
    readings["difference"][::GRID] = measured["X"] - indicated
    return {"time": time, "command": command, "force": force, **readings}
