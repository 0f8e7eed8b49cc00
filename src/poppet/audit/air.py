"""Division of the air that a circuit consumes between its parts."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass

import numpy as np

from poppet.audit.energy_run import EnergyRun
from poppet.circuit.energy_trace import FlowTerm
from poppet.circuit.instance import Array

RETURNED = 0.5
"""Fraction of the air through a flow path that must return, so that both of its gas nodes belong to one line.

The masses of both gas nodes must also rise and fall together. Those on both sides of a leaking piston do not."""
PASSED, EMPTIED = 0.5, 0.5
"""Conditions for air that a line consumes when it releases the air into an exhaust line.

More than the first fraction of the air that arrives in the exhaust line leaves it to the ambient at the same time. The
mass in the line that releases the air varies by more than the second fraction of its maximum. This variation is about 1
for a cylinder, and less for an accumulator, whose air is consumed elsewhere."""


@dataclass(frozen=True)
class _Path:
    """Flow path between a line and another node."""

    flow: FlowTerm
    sign: float  # 1 if positive flow enters the line, else -1
    is_sink: bool  # the other node is the ambient, or a reservoir that does not supply air
    is_used: bool  # air from one line to the exhaust line of another one


@dataclass(frozen=True)
class _Line:
    """Gas nodes that exchange air in both directions, and their flow paths to other nodes."""

    stores: frozenset[str]
    paths: tuple[_Path, ...]


def air_of_parts(
    run: EnergyRun, masses: Mapping[str, Array], supplies: Set[str], tubes: Set[str] = frozenset()
) -> dict[str, float]:
    """Return the mass of air that each part consumes per cycle [kg].

    A line consists of gas nodes between which air flows to and fro or through a tube, such as a cylinder chamber with
    its tube. It consumes the air that it releases to the ambient, and the increase of its mass. It also consumes the
    air that it releases through an exhaust line, such as the volume of a silencer.

    Some supplied air passes a line while the line releases air, for example the air of a nozzle or a leak. The
    consumer of this air is the inlet or the outlet of the line: the flow path that loses more exergy by throttling per
    mass. The consumers of the rest are the gas nodes of the line, in proportion to the range of their masses. The sum
    of all parts is the air of all supplies.

    Parameters
    ----------
    run : EnergyRun
        Result of the audit run.
    masses : mapping
        Mapping from each gas node to its mass at the output times [kg].
    supplies : set of str
        Reservoirs that supply air. The empty name means all flow sources.
    tubes : set of str, optional
        Parts that are tubes.

    Returns
    -------
    dict
        Mapping from parts to masses. Parts that consume no air are omitted.
    """
    consumed: dict[str, float] = defaultdict(float)
    for flow in run.energy.flows:  # from a supply to the ambient
        for node, other, sign in ((flow.source, flow.target, 1.0), (flow.target, flow.source, -1.0)):
            if node in supplies and other not in masses and other not in supplies:
                consumed[flow.part] += sign * run.integral(flow.net)
    losses = {flow.name: _loss(run, flow) for flow in run.energy.flows}
    for line in _lines(run, masses, supplies, tubes):
        released = 0.0
        for path in line.paths:
            outflow = -path.sign * run.integral(path.flow.net)
            released += outflow if path.is_sink or path.is_used else 0.0
        for flow, mass in _passing(run, line, losses):
            consumed[flow.part] += mass
            released -= mass
        change = sum(float(masses[name][-1] - masses[name][0]) for name in line.stores) / run.count
        ranges = {name: float(np.ptp(masses[name])) for name in sorted(line.stores)}
        total = sum(ranges.values())
        for name, extent in ranges.items():
            share = extent / total if total > 0.0 else 1.0 / len(ranges)
            consumed[name.partition(".")[0]] += share * (released + change)
    return {part: mass for part, mass in consumed.items() if mass != 0.0}


def _loss(run: EnergyRun, flow: FlowTerm) -> float:
    """Return the exergy that a flow path loses by throttling per mass of air in both directions [J/kg]."""
    loss = math.fsum(run.integral(t.exergy) for t in run.energy.terms if (t.kind, t.name) == ("throttling", flow.name))
    mass = 2.0 * run.integral(flow.forward) - run.integral(flow.net)
    return loss / mass if mass > 0.0 else 0.0


def _lines(run: EnergyRun, masses: Mapping[str, Array], supplies: Set[str], tubes: Set[str]) -> Iterator[_Line]:
    """Yield all lines of a circuit."""
    stores_of = {name: frozenset({name}) for name in masses}
    for flow in run.energy.flows:
        forward = run.integral(flow.forward)
        backward = forward - run.integral(flow.net)
        is_inner = flow.source in masses and flow.target in masses
        is_returned = min(forward, backward) > RETURNED * max(forward, backward)
        if is_inner and (
            flow.part in tubes or (is_returned and _rise_together(masses[flow.source], masses[flow.target]))
        ):
            joined = stores_of[flow.source] | stores_of[flow.target]
            stores_of |= dict.fromkeys(joined, joined)

    ends = {stores: tuple(_ends(run, stores)) for stores in stores_of.values()}
    variations, exhausts = {}, set()
    for stores, paths in ends.items():
        mass = sum((masses[name] for name in stores), np.zeros(run.time.size))
        variations[stores] = float(np.ptp(mass) / mass.max())
        rates = [(sign * run.values[flow.rate], other) for flow, sign, other in paths]
        arriving = sum((np.maximum(rate, 0.0) for rate, _ in rates), np.zeros(run.time.size))
        exhausted = sum(
            (np.maximum(-rate, 0.0) for rate, other in rates if other not in masses and other not in supplies),
            np.zeros(run.time.size),
        )
        if np.trapezoid(np.minimum(arriving, exhausted), run.time) > PASSED * np.trapezoid(arriving, run.time):
            exhausts.add(stores)
    for stores, paths in ends.items():
        line = []
        for flow, sign, other in paths:
            is_used = False
            if other in masses:
                before, after = stores_of[other], stores
                if sign * run.integral(flow.net) < 0.0:
                    before, after = after, before
                is_used = after in exhausts and variations[before] > EMPTIED
            line.append(_Path(flow, sign, other not in masses and other not in supplies, is_used))
        yield _Line(stores, tuple(line))


def _rise_together(first: Array, second: Array) -> bool:
    return float(np.dot(first - first.mean(), second - second.mean())) > 0.0


def _ends(run: EnergyRun, stores: frozenset[str]) -> Iterator[tuple[FlowTerm, float, str]]:
    """Yield each flow path between a line and another node, with 1 if positive flow enters the line, else -1."""
    for flow in run.energy.flows:
        for sign, node, other in ((1.0, flow.target, flow.source), (-1.0, flow.source, flow.target)):
            if node in stores and other not in stores:
                yield flow, sign, other


def _passing(run: EnergyRun, line: _Line, losses: Mapping[str, float]) -> Iterator[tuple[FlowTerm, float]]:
    """Yield flow paths with the mass of supplied air that passes a line per cycle [kg].

    The flow path is that of the inlet or that of the outlet to the exhaust side, whichever has the larger loss by
    throttling. `losses` contains these losses by flow path [J/kg].
    """
    rates = [(path, path.sign * run.values[path.flow.rate]) for path in line.paths]
    zero = np.zeros(run.time.size)
    inlets = [(path.flow, np.maximum(rate, 0.0)) for path, rate in rates if not (path.is_sink or path.is_used)]
    arriving = sum((np.maximum(rate, 0.0) for _, rate in rates), zero)
    leaving = sum((np.maximum(-rate, 0.0) for _, rate in rates), zero)
    factor = np.minimum(arriving, leaving) / np.where((arriving > 0.0) & (leaving > 0.0), arriving * leaving, 1.0)
    for path, rate in rates:
        if path.is_sink or path.is_used:
            leaves = factor * np.maximum(-rate, 0.0)
            for inlet, enters in inlets:
                mass = float(np.trapezoid(leaves * enters, run.time)) / run.count
                if mass > 0.0:
                    yield max(inlet, path.flow, key=lambda flow: losses.get(flow.name, 0.0)), mass
