"""Seeded random pressure valves: tanks of 1 cm3 to 1 m3, sample times of 10 us to 50 ms, averaged and switched."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from poppet import Circuit
from poppet.circuit.options import Run
from poppet.engine.problem import Problem
from poppet.parts import Chamber, Orifice, ProportionalValve, Reservoir
from poppet.signals import Steps

MOST_SAMPLES = 20_000
PRESETS = ("universal", "fast", "precise")
DRIVES = (("averaged", False), ("averaged", True), ("switched", False))
"""Drive of the pilot's solenoids, and whether the averaged openings are limited in their rate."""


def valve(drive: str, is_limited: bool, preset: str) -> Circuit:
    """A valve on a tank with a load."""
    solenoids = {"rate_limit": 100.0} if is_limited else {}
    pilot = {"drive": drive, "fill": solenoids, "vent": solenoids}
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": ProportionalValve(
            data="vppm_6l", preset=preset, supply="supply", outlet="tank", exhaust="room", pilot=pilot
        ),
        "tank": Chamber(volume="1 l", wall_conductance=1.0),
        "load": Orifice(from_="tank", to="room", sonic_conductance=1e-9, critical_ratio=0.3),
    }
    signals = {
        "valve.setpoint": Steps([0.0, 1.0, 2.0, 3.0], [2e5, 3e5, 4e5, 5e5]),
        "valve.power": Steps([0.0, 1.0, 2.0, 3.0], [1.0, 1.0, 1.0, 1.0]),
    }
    return Circuit(parts, signals)


def _log(low: float, high: float) -> Callable[[np.random.Generator, float], float]:
    return lambda generator, _: float(10.0 ** generator.uniform(np.log10(low), np.log10(high)))


def _even(low: float, high: float) -> Callable[[np.random.Generator, float], float]:
    return lambda generator, _: float(generator.uniform(low, high))


def _times(low: float, high: float) -> Callable[[np.random.Generator, float], float]:
    return lambda generator, value: value * float(10.0 ** generator.uniform(np.log10(low), np.log10(high)))


def _or_zero(draw: Callable[[np.random.Generator, float], float]) -> Callable[[np.random.Generator, float], float]:
    return lambda generator, value: 0.0 if generator.random() < 0.25 else draw(generator, value)


DRAWN: dict[str, Callable[[np.random.Generator, float], float]] = {
    "supply.pressure": _even(2e5, 10e5),
    "tank.volume": _log(1e-6, 1.0),
    "tank.wall_conductance": _or_zero(_log(1e-3, 100.0)),
    "tank.initial_pressure": _even(0.9e5, 6e5),
    "load.sonic_conductance": _or_zero(_log(1e-12, 1e-7)),
    "valve.main_stage.moving_mass": _times(0.3, 3.0),
    "valve.main_stage.damping": _times(0.1, 10.0),
    "valve.main_stage.upper_spring.preload": _times(0.3, 2.0),
    "valve.main_stage.lower_spring.preload": _times(0.3, 2.0),
    "valve.pilot.volume": _log(1e-7, 1e-4),
    "valve.pilot.polytropic_exponent": _even(1.0, 1.4),
    "valve.pilot.fill.sonic_conductance": _log(1e-11, 1e-8),
    "valve.pilot.vent.sonic_conductance": _log(1e-11, 1e-8),
    "valve.pilot.fill.rate_limit": _log(1.0, 1e4),
    "valve.pilot.supply_leak.sonic_conductance": _or_zero(_log(1e-14, 1e-11)),
    "valve.pilot.exhaust_leak.sonic_conductance": _or_zero(_log(1e-14, 1e-11)),
    "valve.pilot.initial_pressure": _even(0.9e5, 6e5),
    "valve.electronics.zero_suppression": _or_zero(_even(0.0, 0.1)),
    "valve.electronics.outlet_sensor.lag": _or_zero(_log(1e-5, 2e-2)),
    "valve.electronics.pilot_sensor.lag": _or_zero(_log(1e-5, 2e-2)),
    "valve.electronics.outlet_sensor.offset": _or_zero(_even(-1e4, 1e4)),
    "valve.electronics.converter.bits": lambda generator, _: float(generator.choice([0, 8, 10, 12, 16])),
    "valve.electronics.outer.gain": _times(0.1, 10.0),
    "valve.electronics.outer.integral_time": _or_zero(_log(1e-2, 10.0)),
    "valve.electronics.outer.derivative_time": _or_zero(_log(1e-4, 0.1)),
    "valve.electronics.outer.derivative_filter": _or_zero(_log(1e-4, 0.1)),
    "valve.electronics.outer.feed_forward": _even(0.0, 1.2),
    "valve.electronics.outer.dead_band": _or_zero(_log(1e2, 1e4)),
    "valve.electronics.outer.integral_band": _or_zero(_log(1e3, 1e5)),
    "valve.electronics.outer.integral_limit": _or_zero(_log(1e3, 1e5)),
    "valve.electronics.outer.sample_time": _log(1e-5, 5e-2),
    "valve.electronics.inner.gain": _times(0.1, 10.0),
    "valve.electronics.inner.hold_band": _or_zero(_log(1e2, 1e4)),
    "valve.electronics.inner.minimum_duty": _or_zero(_even(0.0, 0.4)),
    "valve.electronics.inner.vent_delay": _or_zero(_log(1e-4, 0.1)),
    "valve.electronics.inner.sample_time": _log(1e-5, 5e-2),
}


def _numbers(circuit: Circuit, generator: np.random.Generator) -> dict[str, float]:
    """Values of the numbers that are drawn, by address."""
    known = circuit.parameters
    values = {name: draw(generator, known[name]) for name, draw in DRAWN.items() if name in known}
    if "valve.pilot.fill.rate_limit" in known:
        values["valve.pilot.vent.rate_limit"] = values["valve.pilot.fill.rate_limit"]
    for solenoid in ("valve.pilot.fill", "valve.pilot.vent"):
        values[f"{solenoid}.frequency"] = frequency = float(10.0 ** generator.uniform(1.0, 3.0))
        for delay in ("opening_delay", "closing_delay"):
            share = 0.0 if generator.random() < 0.25 else generator.uniform(0.0, 0.45)
            values[f"{solenoid}.{delay}"] = share / frequency
    return values


def valves(generator: np.random.Generator, count: int) -> Iterator[tuple[Problem, dict[str, Any]]]:
    """Runs of random valves, of each structure in turn, with what was drawn."""
    circuits = [valve(*drive, preset) for drive in DRIVES for preset in PRESETS]
    bases = [circuit.problem(Run(duration=4.0)) for circuit in circuits]
    for number in range(count):
        circuit, base = circuits[number % len(circuits)], bases[number % len(bases)]
        drawn = _numbers(circuit, generator)
        p = base.p.copy()
        for k, name in enumerate(circuit.model.parameters):
            p[k] = drawn.get(name, p[k])
        clocks = [drawn[f"valve.electronics.{loop}.sample_time"] for loop in ("outer", "inner")]
        duration = min(float(10.0 ** generator.uniform(-1.0, 1.0)), MOST_SAMPLES * min(clocks))
        starts = base.starts * duration / 4.0
        courses, coefficients = np.arange(starts.size), base.coefficients[base.courses]
        for k, item in enumerate(circuit.model.inputs):
            if item.name == "valve.setpoint":
                coefficients[:, k, 0] = generator.uniform(1e5, 7e5, starts.size) * (generator.random(starts.size) < 0.9)
                coefficients[:, k, 0] = np.maximum(coefficients[:, k, 0], 1e5)
            elif item.name == "valve.power":
                coefficients[:, k, 0] = generator.random(starts.size) < 0.9
            elif item.default in drawn:
                coefficients[:, k, 0] = drawn[item.default]
        grid = np.linspace(0.0, duration, 101)
        x0 = circuit.kernel.start(p)
        drawn |= {"duration": duration}
        yield (
            dataclasses.replace(base, p=p, x0=x0, starts=starts, courses=courses, coefficients=coefficients, grid=grid),
            drawn,
        )
