"""Seeded random networks: chambers of 1 cm3 to 10 m3, C of 1e-12 to 1e-6 m3/(s Pa), pressures of 1 Pa to 100 bar."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np

from poppet import Chamber, CheckValve, Circuit, Orifice, Reservoir, Run
from poppet.engine.members import Batch
from poppet.engine.problem import Problem

SIZE: dict[str, Any] = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def two_chambers() -> Circuit:
    """Two chambers with energy balance, joined by an orifice."""
    return Circuit(
        {
            "left": Chamber(volume=1e-3, initial_pressure=2e5),
            "link": Orifice(from_="left", to="right", **SIZE),
            "right": Chamber(volume=1e-3),
        }
    )


def random_topology(generator: np.random.Generator, thermal: tuple[str, ...]) -> Circuit:
    """A connected network of 2 to 6 chambers with loops, some check valves and sometimes a supply."""
    n = int(generator.integers(2, 7))
    parts: dict[str, Any] = {
        f"c{j}": Chamber(volume=1e-3, thermal=thermal[int(generator.integers(len(thermal)))]) for j in range(n)
    }
    edges = [(int(generator.integers(j)), j) for j in range(1, n)]
    for _ in range(int(generator.integers(0, n))):
        a, b = generator.choice(n, 2, replace=False)
        edges.append((int(a), int(b)))
    for e, (a, b) in enumerate(edges):
        kind = CheckValve if generator.random() < 0.15 else Orifice
        parts[f"o{e}"] = kind(from_=f"c{a}", to=f"c{b}", **SIZE)
    if generator.random() < 0.4:
        parts["r"] = Reservoir(pressure=7e5)
        parts["in"] = Orifice(from_="r", to="c0", **SIZE)
    return Circuit(parts)


def _draw(generator: np.random.Generator, address: str) -> float | None:
    """A value for one number, or None to leave it."""
    match address.rsplit(".", 1)[-1]:
        case "volume":
            return 10.0 ** generator.uniform(-6, 1)
        case "initial_pressure":
            return 10.0 ** generator.uniform(0, 7)
        case "pressure" if address == "r.pressure":
            return 10.0 ** generator.uniform(4, 7)
        case "initial_temperature":
            return generator.uniform(230.0, 400.0)
        case "sonic_conductance":
            return 10.0 ** generator.uniform(-12, -6)
        case "critical_ratio":
            return generator.uniform(0.0, 0.8)
        case "wall_conductance":
            return float(generator.choice([0.0, 10.0 ** generator.uniform(-3, 2)]))
        case "cracking_pressure":
            return float(generator.choice([0.0, 10.0 ** generator.uniform(2, 5)]))
    return None


def problems(
    circuit: Circuit, generator: np.random.Generator, count: int, rows: int, decades: float
) -> Iterator[Problem]:
    """Runs of one network with random numbers, over 0.1 to 10^decades typical time constants."""
    base = circuit.problem(Run(duration=1.0))
    places = {name: k for k, name in enumerate(circuit.model.parameters)}
    for _ in range(count):
        p = base.p.copy()
        drawn = {name: value for name in places if (value := _draw(generator, name)) is not None}
        for name, value in drawn.items():
            p[places[name]] = value
        volumes = [value for name, value in drawn.items() if name.endswith(".volume")]
        sizes = [value for name, value in drawn.items() if name.endswith(".sonic_conductance")]
        tau = np.median(volumes) / (np.median(sizes) * 1.185 * 287.05 * 293.15)
        grid = np.linspace(0.0, tau * 10.0 ** generator.uniform(-1, decades), rows)
        coefficients = base.coefficients.copy()
        for k, item in enumerate(circuit.model.inputs):
            if isinstance(item.default, str):
                coefficients[0, k, 0] = p[places[item.default]]
        x0 = circuit.kernel.start(p)
        yield dataclasses.replace(base, p=p, x0=x0, grid=grid, coefficients=coefficients)


def batches(circuit: Circuit, generator: np.random.Generator, count: int, each: int) -> Iterator[Batch]:
    """Batches of one network, every run with numbers of its own, over 0.1 to 100 typical time constants."""
    base, names = circuit.problem(Run(duration=1.0)), circuit.model.parameters
    places = [k for k, name in enumerate(names) if _draw(np.random.default_rng(0), name) is not None]
    volumes, sizes = (
        [j for j, k in enumerate(places) if names[k].endswith(ending)] for ending in (".volume", ".sonic_conductance")
    )
    held = tuple(
        (k, names.index(item.default)) for k, item in enumerate(circuit.model.inputs) if isinstance(item.default, str)
    )
    for _ in range(count):
        values = np.array([[_draw(generator, names[k]) for k in places] for _ in range(each)])
        ratios = np.median(values[:, volumes], axis=1) / np.median(values[:, sizes], axis=1)
        tau = np.median(ratios / (1.185 * 287.05 * 293.15))
        grid = np.linspace(0.0, tau * 10.0 ** generator.uniform(-1, 2), 31)
        yield Batch(dataclasses.replace(base, grid=grid), np.array(places), values, held)


def rows_of(circuit: Circuit, ending: str) -> list[int]:
    """Places of the chambers' outputs of one kind."""
    chambers = {name for name, part in circuit.parts.items() if isinstance(part, Chamber)}
    return [
        k
        for k, (name, _) in enumerate(circuit.model.outputs)
        if name.split(".")[0] in chambers and name.endswith(ending)
    ]
