"""Check valve, relief valve, on/off directional valve and silencer: ISO 6358 passages with a rule of their own."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.symbolic import clip, smoothstep
from poppet.parts.fields import NumberLike, number, option, port
from poppet.parts.flow_path import FlowPath
from poppet.parts.orifice import from_to, way
from poppet.parts.part import GasState, Input, PassageFlows, Scope, State

SPOOL_GAIN = 50.0
"""How sharply the spool stops at its end: it covers the last 1/50 of its way exponentially."""


@dataclass(frozen=True)
class CheckValve(FlowPath):
    """A passage that lets gas through in one direction, above a cracking pressure.

    Parameters
    ----------
    from_ : str
        Store at the inlet.
    to : str
        Store at the outlet.
    cracking_pressure : number
        Pressure difference at which it opens [Pa].

    Notes
    -----
    The law of ISO 6358-1:2013 with its cracking-pressure term; no moving mass.
    """

    kind: ClassVar[str] = "check_valve"
    summary: ClassVar[str] = "flow in one direction only, above a cracking pressure"

    from_: str | None = port("store at the inlet")
    to: str | None = port("store at the outlet")
    cracking_pressure: NumberLike = number(
        "Pa", 0.0, doc="cracking pressure", kind="pressure_difference", low=0.0, note="none by default"
    )

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        size = self.size_at(scope, None)
        return from_to(scope, gas, size, cracking_pressure=scope["cracking_pressure"], one_way=True)


@dataclass(frozen=True)
class ReliefValve(FlowPath):
    """A passage that opens with the inlet pressure, from the set pressure on.

    Parameters
    ----------
    from_ : str
        Store that is protected.
    to : str
        Store it discharges into.
    set_pressure : number
        Inlet pressure at which it begins to open [Pa], absolute.
    accumulation : number
        Rise above the set pressure at which it is fully open [Pa].

    Notes
    -----
    Static: the opening follows the inlet pressure by a C1 smoothstep; no hysteresis (blow-down) and no moving mass.
    """

    kind: ClassVar[str] = "relief_valve"
    summary: ClassVar[str] = "opens with its inlet pressure, from the set pressure on"

    from_: str | None = port("store that is protected")
    to: str | None = port("store it discharges into")
    set_pressure: NumberLike = number("Pa", doc="set pressure", kind="pressure", above=0.0)
    accumulation: NumberLike = number(
        "Pa", "0.2 bar", doc="accumulation", kind="pressure_difference", above=0.0, note="rise to full opening"
    )

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        begin = scope["set_pressure"]
        opening = smoothstep(gas["from"].pressure, begin, begin + scope["accumulation"])
        conductance, ratio = self.size_at(scope, None)
        passing = from_to(scope, gas, (conductance * opening, ratio), one_way=True)
        return replace(passing, outputs={"opening": (opening, "1"), **passing.outputs})


@dataclass(frozen=True)
class DirectionalValve(FlowPath):
    """An on/off valve, 2/2 or (with an exhaust port) 3/2, whose spool takes time to move.

    Parameters
    ----------
    supply : str
        Store at port 1.
    outlet : str
        Store at port 2.
    exhaust : str, optional
        Store at port 3; without it the valve is 2/2.
    normally : str
        `closed` (default) or `open`: the state at command 0.
    command : number
        0 is off, 1 on; also an input.
    delay : number
        Time from the command to the first motion [s].
    switching_time : number
        Time of the spool from end to end [s].
    closing_time : number
        Time of its way back [s]; default `switching_time`.
    exhaust_conductance, exhaust_ratio : number
        C [m^3/(s Pa)] and b from port 2 to port 3; default those from 1 to 2.
    initial_position : number
        Where the spool starts, 0..1; default where the number `command` holds it.

    Notes
    -----
    The conductance is proportional to the spool's position. In a 3/2 valve the exhaust closes over the first half of
    the stroke and the supply opens over the second, so the two are never open together.
    """

    kind: ClassVar[str] = "directional_valve"
    summary: ClassVar[str] = "on/off valve, 2/2 or 3/2, with delay and switching time"

    supply: str | None = port("store at port 1")
    outlet: str | None = port("store at port 2")
    exhaust: str | None = port("store at port 3", optional=True)
    normally: str = option("closed", "open", doc="state at command 0")
    command: NumberLike = number("1", 0.0, doc="command", low=0.0, high=1.0, note="off by default")
    delay: NumberLike = number("s", 0.0, doc="delay", low=0.0, note="none by default")
    switching_time: NumberLike = number("s", "10 ms", doc="switching time", above=0.0, note="typical of a small valve")
    closing_time: NumberLike = number("s", optional=True, doc="closing time", above=0.0)
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="exhaust conductance", low=0.0)
    exhaust_ratio: NumberLike = number("1", optional=True, doc="exhaust critical ratio", low=0.0, below=1.0)
    initial_position: NumberLike = number("1", optional=True, doc="initial position of the spool", low=0.0, high=1.0)
    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    def check(self) -> None:
        super().check()
        for name in ("exhaust_conductance", "exhaust_ratio"):
            if getattr(self, name) is not None and self.exhaust is None:
                raise InputError("parts.no_exhaust_port", name)

    def parameters(self, ambient: Any) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("closing_time", values["switching_time"])
        values.setdefault("exhaust_conductance", values["sonic_conductance"])
        values.setdefault("exhaust_ratio", values["critical_ratio"])
        # At rest under its own command; a signal that begins elsewhere moves the spool from there.
        rest = values["command"] if self.normally == "closed" else 1.0 - values["command"]
        values.setdefault("initial_position", rest)
        return values

    def structure(self) -> Hashable:
        return super().structure(), self.exhaust is not None

    def states(self) -> tuple[State, ...]:
        # A spool that creeps onto its seat is to be known as a part of its stroke.
        return (State("position", "1", 1.0, floor=1.0),)

    def inputs(self) -> tuple[Input, ...]:
        return (Input("command", "1", "command", low=0.0, high=1.0, delay="delay"),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"]}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position, command = scope.states["position"], scope.inputs["command"]
        target = command if self.normally == "closed" else 1.0 - command
        pull = clip(SPOOL_GAIN * (target - position), -1.0, 1.0)
        # One of the two is zero: the way back may take another time than the way there.
        opening_rate, closing_rate = clip(pull, 0.0, 1.0), clip(pull, -1.0, 0.0)
        rates = {"position": opening_rate / scope["switching_time"] + closing_rate / scope["closing_time"]}
        conductance, ratio = self.size_at(scope, None)
        supply_opening = clip(position if self.exhaust is None else 2.0 * position - 1.0, 0.0, 1.0)
        flow, outputs = way(scope, gas, "supply", ("supply", "outlet"), (conductance * supply_opening, ratio))
        flows, outputs = [flow], {"position": (position, "1"), **outputs}
        if self.exhaust is not None:
            size = scope["exhaust_conductance"] * clip(1.0 - 2.0 * position, 0.0, 1.0), scope["exhaust_ratio"]
            flow, more = way(scope, gas, "exhaust", ("outlet", "exhaust"), size)
            flows.append(flow)
            outputs.update(more)
        return PassageFlows(tuple(flows), outputs, rates)


@dataclass(frozen=True)
class Silencer(FlowPath):
    """A silencer at an exhaust: an ISO 6358 passage that clogs.

    Parameters
    ----------
    from_ : str
        Store that it vents.
    to : str
        Where it vents to, usually `ambient`.
    clogging : number
        Fraction of the conductance lost to dirt, 0..1.
    """

    kind: ClassVar[str] = "silencer"
    summary: ClassVar[str] = "a silencer at an exhaust, with clogging"

    from_: str | None = port("store that is vented")
    to: str | None = port("store it vents to")
    clogging: NumberLike = number("1", 0.0, doc="clogging", low=0.0, high=1.0, note="clean by default")

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, None)
        return from_to(scope, gas, (conductance * (1.0 - scope["clogging"]), ratio))
