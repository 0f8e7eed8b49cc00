"""A directional valve with five ports, 5/3 or 5/2, proportional or switched."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip
from poppet.parts.fields import NumberLike, number, option, port
from poppet.parts.flow_path import FlowPath
from poppet.parts.orifice import way
from poppet.parts.part import AMBIENT, Flow, GasState, Input, PassageFlows, Quantities, Scope, State, Surroundings

AT_ONCE = 1e-6
"""Time from the centre to an end of a spool whose speed has no limit [s]."""
LOOSER = 30.0
"""Tolerance of the spool per tolerance of the gas, as of bodies: a sampled command sets it going at every instant, and
held as the gas is it alone would take three of four steps."""
EDGES = {
    "supply_a": ("supply", "a", 1.0),
    "supply_b": ("supply", "b", -1.0),
    "exhaust_a": ("a", "exhaust_a", -1.0),
    "exhaust_b": ("b", "exhaust_b", 1.0),
}
"""Metering edge to the ports between which it lies, and the side of the centre on which it opens."""
_INHERITS = {"supply_b": "supply_a", "exhaust_a": "supply_a", "exhaust_b": "exhaust_a"}


@dataclass(frozen=True)
class SpoolValve(FlowPath):
    r"""A directional valve with five ports whose spool opens four metering edges.

    .. math:: C = C_l + (C_e - C_l) \operatorname{clip}\left(\frac{\pm s - o}{1 - o}, 0, 1\right)

    Parameters
    ----------
    supply : str
        Store at port 1.
    a, b : str
        Stores at ports 4 and 2. A positive command fills a and vents b.
    exhaust_a, exhaust_b : str, optional
        Stores at ports 5 and 3; default the open air.
    command : number
        Where the spool shall be, -1..1; also an input.
    delay : number
        Time by which a signal of the command acts later [s].
    dynamics : str
        How the spool follows: `first_order` (default) or `second_order`.
    lag : number
        Time constant of `first_order` [s].
    natural_frequency, damping : number
        Of `second_order` [Hz], [1].
    switching_time : number
        Shortest time from the centre to an end [s]; default no such limit.
    overlap : number
        Part of the way to an end in which the supply's edges stay shut, o; negative: open at the centre by that way.
    exhaust_overlap : number
        The same of the exhausts' edges; default `overlap`.
    supply_b_conductance, supply_b_ratio : number
        C [m^3/(s Pa)] and b of the edge from supply to b, fully open; default those from supply to a.
    exhaust_a_conductance, exhaust_a_ratio : number
        The same from a to its exhaust; default those from supply to a.
    exhaust_b_conductance, exhaust_b_ratio : number
        The same from b to its exhaust; default those from a to its exhaust.
    leak_conductance : number
        C of an edge that is shut [m^3/(s Pa)].
    initial_position : number
        Where the spool starts, -1..1; default where the number `command` holds it.

    Notes
    -----
    5/3 by the overlaps: closed at the centre (both zero or more), exhausted (supply's above, exhaust's below zero),
    under pressure (the other way). A 5/2 valve is the same with commands of -1 and 1. The speed of a switched spool is
    limited by `switching_time`, and a short lag says how it settles.

    References
    ----------
    ISO 5599-1, ISO 11727: numbers of ports. Beater, Pneumatic Drives, Springer 2007, on spool valves.

    Examples
    --------
    >>> valve = SpoolValve(supply="rail", a="cylinder.cap", b="cylinder.rod", nominal_flow="700 l/min ANR")
    >>> valve.ports()["exhaust_a"]
    'ambient'
    """

    kind: ClassVar[str] = "spool_valve"
    summary: ClassVar[str] = "directional valve with five ports, 5/3 or 5/2, proportional or switched"
    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    supply: str | None = port("store at port 1")
    a: str | None = port("store at port 4")
    b: str | None = port("store at port 2")
    exhaust_a: str | None = port("store at port 5", optional=True)
    exhaust_b: str | None = port("store at port 3", optional=True)
    command: NumberLike = number("1", 0.0, doc="command", low=-1.0, high=1.0, note="centre by default")
    delay: NumberLike = number("s", 0.0, doc="delay", low=0.0, note="none by default")
    dynamics: str = option("first_order", "second_order", doc="how the spool follows")
    lag: NumberLike = number("s", "5 ms", doc="time constant of the spool", above=0.0, note="a small valve")
    natural_frequency: NumberLike = number("Hz", 100.0, doc="natural frequency", above=0.0, note="a small valve")
    damping: NumberLike = number("1", 0.7, doc="damping ratio", above=0.0, note="hardly overshoots")
    switching_time: NumberLike = number("s", optional=True, doc="shortest time from centre to end", above=0.0)
    overlap: NumberLike = number("1", 0.0, doc="overlap of the supply's edges", low=-1.0, below=1.0, note="none")
    exhaust_overlap: NumberLike = number("1", optional=True, doc="overlap of the exhausts' edges", low=-1.0, below=1.0)
    supply_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="C from 1 to 2", low=0.0)
    supply_b_ratio: NumberLike = number("1", optional=True, doc="b from 1 to 2", low=0.0, below=1.0)
    exhaust_a_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="C from 4 to 5", low=0.0)
    exhaust_a_ratio: NumberLike = number("1", optional=True, doc="b from 4 to 5", low=0.0, below=1.0)
    exhaust_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="C from 2 to 3", low=0.0)
    exhaust_b_ratio: NumberLike = number("1", optional=True, doc="b from 2 to 3", low=0.0, below=1.0)
    leak_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="C of a shut edge", low=0.0, note="tight")
    initial_position: NumberLike = number("1", optional=True, doc="initial position", low=-1.0, high=1.0)

    def ports(self) -> dict[str, str]:
        open_air = {"exhaust_a": AMBIENT, "exhaust_b": AMBIENT}
        return super().ports() | {name: at for name, at in open_air.items() if getattr(self, name) is None}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        sizes = {"supply_a_conductance": values["sonic_conductance"], "supply_a_ratio": values["critical_ratio"]}
        for edge, other in _INHERITS.items():
            for size in ("conductance", "ratio"):
                sizes[f"{edge}_{size}"] = values.setdefault(f"{edge}_{size}", sizes[f"{other}_{size}"])
        values.setdefault("exhaust_overlap", values["overlap"])
        values.setdefault("switching_time", AT_ONCE)
        values.setdefault("initial_position", values["command"])
        return values

    def states(self) -> tuple[State, ...]:
        position = State("position", "1", 1.0, LOOSER, 1.0)
        velocity = State("velocity", "1/s", 100.0, LOOSER, 1.0)
        return (position,) if self.dynamics == "first_order" else (position, velocity)

    def inputs(self) -> tuple[Input, ...]:
        return (Input("command", "1", "command", low=-1.0, high=1.0, delay="delay"),)

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"position": scope["initial_position"], "velocity": 0.0}
        return {state.name: values[state.name] for state in self.states()}

    def _rates(self, scope: Scope) -> dict[str, Any]:
        missing = scope.inputs["command"] - scope.states["position"]
        fastest = 1.0 / scope["switching_time"]
        if self.dynamics == "first_order":
            return {"position": clip(missing / scope["lag"], -fastest, fastest)}
        turn, velocity = math.tau * scope["natural_frequency"], scope.states["velocity"]
        rate = turn * turn * missing - 2.0 * scope["damping"] * turn * velocity
        return {"position": clip(velocity, -fastest, fastest), "velocity": rate}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position, leak = scope.states["position"], scope["leak_conductance"]
        flows, outputs = list[Flow](), Quantities(position=(position, "1"))
        for edge, (first, second, side) in EDGES.items():
            conductance, ratio = (
                self.size_at(scope, None)
                if edge == "supply_a"
                else (scope[f"{edge}_conductance"], scope[f"{edge}_ratio"])
            )
            overlap = scope["overlap" if edge.startswith("supply") else "exhaust_overlap"]
            opening = clip((side * position - overlap) / (1.0 - overlap), 0.0, 1.0)
            flow, more = way(scope, gas, edge, (first, second), (leak + (conductance - leak) * opening, ratio))
            flows.append(flow)
            outputs.update(more)
        return PassageFlows(tuple(flows), outputs, self._rates(scope))
