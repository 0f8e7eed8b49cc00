"""Directional valve with five ports, 5/3 or 5/2, proportional or switched."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, number, option, port
from poppet.parts.flow_path import FlowPath, named_flow
from poppet.parts.part import AMBIENT, Flow, GasState, Input, PassageFlows, Quantities, Scope, State, Surroundings

MIN_SWITCHING_TIME = 1e-6
"""Time from the centre to an end of a spool without a speed limit [s]."""
LOOSER = 30.0
"""Tolerance of the spool per tolerance of the gas states.

A sampled command accelerates the spool at each instant. With the tolerance of the gas, the spool would cause three of
four steps."""
EDGES = {
    "supply_a": ("supply", "a", 1.0),
    "supply_b": ("supply", "b", -1.0),
    "exhaust_a": ("a", "exhaust_a", -1.0),
    "exhaust_b": ("b", "exhaust_b", 1.0),
}
"""Mapping from each metering edge to the ports that it connects and the side of the centre on which it opens."""
_INHERITS = {"supply_b": "supply_a", "exhaust_a": "supply_a", "exhaust_b": "exhaust_a"}


@dataclass(frozen=True)
class SpoolValve(FlowPath):
    r"""Directional valve with five ports whose spool opens four metering edges.

    .. math:: C = C_l + (C_e - C_l) \operatorname{clip}\left(\frac{\pm s - o}{1 - o}, 0, 1\right)

    Notes
    -----
    In the equation, s is the position of the spool, o the overlap of the edge, :math:`C_e` the conductance of the open
    edge and :math:`C_l` `leak_conductance`. A positive command fills port a and vents port b. The overlaps determine
    the centre position of a 5/3 valve: closed if both are zero or positive, exhausted if only the exhaust overlap is
    negative, pressurised if only the supply overlap is negative. Commands of a 5/2 valve are -1 and 1 only.
    `switching_time` limits the speed of the spool; by default there is no limit.

    By default, the exhausts are the ambient, and `exhaust_overlap` equals `overlap`. The edges from the supply to port
    b and from port a to its exhaust have the flow capacity of the edge from the supply to port a. The edge from port b
    to its exhaust has the flow capacity of the edge from port a to its exhaust. The initial position of the spool is
    the value of `command`.

    References
    ----------
    ISO 5599-1 and ISO 11727 for numbers of ports; Beater, Pneumatic Drives, Springer 2007, for spool valves.

    Examples
    --------
    >>> valve = SpoolValve(supply="rail", a="cylinder.cap", b="cylinder.rod", nominal_flow="700 l/min ANR")
    >>> valve.ports()["exhaust_a"]
    'ambient'
    """

    kind: ClassVar[str] = "spool_valve"
    regimes: ClassVar[tuple[str, ...]] = tuple(f"{edge}_regime" for edge in EDGES)
    symbol: ClassVar[symbols.Symbol | str] = symbols.SPOOL_VALVE
    summary: ClassVar[str] = "directional valve with five ports, 5/3 or 5/2, proportional or switched"
    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    supply: str | None = port("gas node at port 1")
    a: str | None = port("gas node at port 4")
    b: str | None = port("gas node at port 2")
    exhaust_a: str | None = port("gas node at port 5", optional=True)
    exhaust_b: str | None = port("gas node at port 3", optional=True)
    command: NumberLike = number("1", 0.0, doc="command", low=-1.0, high=1.0, note="centre by default")
    delay: NumberLike = number("s", 0.0, doc="delay of a command signal", low=0.0, note="none by default")
    dynamics: str = option("first_order", "second_order", doc="dynamics of the spool")
    lag: NumberLike = number("s", "5 ms", doc="time constant of the spool", above=0.0, note="a small valve")
    natural_frequency: NumberLike = number("Hz", 100.0, doc="natural frequency", above=0.0, note="a small valve")
    damping: NumberLike = number("1", 0.7, doc="damping ratio", above=0.0, note="small overshoot")
    switching_time: NumberLike = number("s", optional=True, doc="shortest time from centre to end", above=0.0)
    overlap: NumberLike = number("1", 0.0, doc="overlap o of the supply edges", low=-1.0, below=1.0, note="none")
    exhaust_overlap: NumberLike = number("1", optional=True, doc="overlap o of the exhaust edges", low=-1.0, below=1.0)
    supply_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 1 to 2", low=0.0)
    supply_b_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 1 to 2", low=0.0, below=1.0)
    exhaust_a_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 4 to 5", low=0.0)
    exhaust_a_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 4 to 5", low=0.0, below=1.0)
    exhaust_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 2 to 3", low=0.0)
    exhaust_b_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 2 to 3", low=0.0, below=1.0)
    leak_conductance: NumberLike = number(
        "m^3/(s Pa)", 0.0, doc="conductance C of a closed edge", low=0.0, note="tight"
    )
    initial_position: NumberLike = number("1", optional=True, doc="initial position of the spool", low=-1.0, high=1.0)

    def ports(self) -> dict[str, str]:
        exhausts = (name for name in ("exhaust_a", "exhaust_b") if getattr(self, name) is None)
        return super().ports() | dict.fromkeys(exhausts, AMBIENT)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        overlaps: dict[str, Any] = {"supply": self.overlap, "exhausts": self.exhaust_overlap or self.overlap}
        is_open = " and ".join(side for side, overlap in overlaps.items() if float(overlap) < 0.0)
        dynamics = self.lag if self.dynamics == "first_order" else self.natural_frequency
        head, spool = f"5/3, {is_open or 'nothing'} open at the centre", f"spool {numbers.text(dynamics)}"
        return [head, *super().caption(numbers), spool]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        sizes = {"supply_a_conductance": values["sonic_conductance"], "supply_a_ratio": values["critical_ratio"]}
        for edge, default in _INHERITS.items():
            for size in ("conductance", "ratio"):
                sizes[f"{edge}_{size}"] = values.setdefault(f"{edge}_{size}", sizes[f"{default}_{size}"])
        values.setdefault("exhaust_overlap", values["overlap"])
        values.setdefault("switching_time", MIN_SWITCHING_TIME)
        values.setdefault("initial_position", values["command"])
        return values

    def states(self) -> tuple[State, ...]:
        position = State("position", "1", 1.0, LOOSER, 1.0)
        velocity = State("velocity", "1/s", 100.0, LOOSER, 1.0)
        return (position,) if self.dynamics == "first_order" else (position, velocity)

    def inputs(self) -> tuple[Input, ...]:
        return (Input("command", "1", "command", low=-1.0, high=1.0, delay="delay", is_command=True),)

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"position": scope["initial_position"], "velocity": 0.0}
        return {state.name: values[state.name] for state in self.states()}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position, leak = scope.states["position"], scope["leak_conductance"]
        flows, outputs = list[Flow](), Quantities(position=(position, "1"))
        for edge, (first, second, side) in EDGES.items():
            is_first = edge == "supply_a"
            conductance, ratio = (
                self.size_at(scope, None) if is_first else (scope[f"{edge}_conductance"], scope[f"{edge}_ratio"])
            )
            overlap = scope["overlap" if edge.startswith("supply") else "exhaust_overlap"]
            opening = clip((side * position - overlap) / (1.0 - overlap), 0.0, 1.0)
            size = leak + (conductance - leak) * opening, ratio
            flow, edge_outputs = named_flow(scope, gas, edge, (first, second), size)
            flows.append(flow)
            outputs.update(edge_outputs)
        error, max_speed = scope.inputs["command"] - position, 1.0 / scope["switching_time"]
        if self.dynamics == "first_order":
            rates = {"position": clip(error / scope["lag"], -max_speed, max_speed)}
        else:
            omega, velocity = math.tau * scope["natural_frequency"], scope.states["velocity"]
            rate = omega * omega * error - 2.0 * scope["damping"] * omega * velocity
            rates = {"position": clip(velocity, -max_speed, max_speed), "velocity": rate}
        return PassageFlows(tuple(flows), outputs, rates)
