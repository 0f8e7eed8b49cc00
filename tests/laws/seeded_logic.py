"""Seeded random networks with valves that pressures switch: closed, adiabatic, with stepped inputs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from poppet import (
    Chamber,
    Circuit,
    Filter,
    FlowControlValve,
    Orifice,
    PilotedCheckValve,
    QuickExhaustValve,
    ShuttleValve,
    TwoPressureValve,
)
from poppet.timeseries.signals import Steps

VALVES: dict[type, tuple[str, ...]] = {
    ShuttleValve: ("a", "b", "outlet"),
    TwoPressureValve: ("a", "b", "outlet"),
    QuickExhaustValve: ("inlet", "outlet", "exhaust"),
    FlowControlValve: ("from_", "to"),
    PilotedCheckValve: ("from_", "to", "pilot"),
    Filter: ("from_", "to"),
}
INPUTS = {FlowControlValve: "opening", Filter: "clogging", Orifice: "opening"}


def random_logic(seed: int, topologies: int, draws: int, duration: float = 1.0) -> Iterator[Circuit]:
    """Yield circuits: for each of some topologies, several draws of all numbers."""
    for topology in range(topologies):
        for draw in range(draws):
            places, values = np.random.default_rng([seed, topology]), np.random.default_rng([seed, topology, draw])
            yield _circuit(places, values, duration)


def _circuit(places: np.random.Generator, values: np.random.Generator, duration: float) -> Circuit:
    """A ring of 3 to 6 chambers with orifices, and 2 to 5 valves between random chambers."""
    count = int(places.integers(3, 7))
    parts: dict[str, Any] = {
        f"c{k}": Chamber(
            volume=10.0 ** values.uniform(-6, -2),
            initial_pressure=10.0 ** values.uniform(4, 6.3),
            initial_temperature=values.uniform(250.0, 380.0),
        )
        for k in range(count)
    }
    kinds = list(VALVES)
    edges: list[tuple[type, tuple[str, ...], list[int]]] = []
    for k in places.integers(0, len(kinds), int(places.integers(2, 6))):
        ports = VALVES[kinds[k]]
        edges.append((kinds[k], ports, [int(j) for j in places.choice(count, len(ports), replace=False)]))
    edges += [(Orifice, ("from_", "to"), [k, (k + 1) % count]) for k in range(count)]
    signals: dict[str, Any] = {}
    for k, (kind, ports, nodes) in enumerate(edges):
        fields: dict[str, Any] = {port: f"c{node}" for port, node in zip(ports, nodes, strict=True)}
        size = {
            "sonic_conductance": 10.0 ** values.uniform(-10, -7),
            "critical_ratio": values.uniform(0.1, 0.6),
        }
        parts[f"v{k}"] = kind(**fields, **size, **_numbers(kind, values))
        if kind in INPUTS:
            times = np.concatenate([[0.0], np.sort(values.uniform(0.0, duration, 2))])
            signals[f"v{k}.{INPUTS[kind]}"] = Steps(times, values.choice([0.0, 0.3, 1.0], 3))
    return Circuit(parts, signals)


def _numbers(kind: type, values: np.random.Generator) -> dict[str, float]:
    if kind in (Filter, Orifice):
        return {}
    if kind is FlowControlValve:
        fields = {"throttle_conductance": 10.0 ** values.uniform(-11, -8)}
    elif kind is PilotedCheckValve:
        fields = {"pilot_ratio": 10.0 ** values.uniform(-1, 2), "pilot_band": 10.0 ** values.uniform(2, 5)}
    else:
        return {
            "switching_pressure": 10.0 ** values.uniform(2, 5),
            "switching_time": 10.0 ** values.uniform(-4, -1),
            "initial_position": float(values.integers(0, 2)),
        }
    return fields | {"cracking_pressure": float(values.choice([0.0, 1e4]))}
