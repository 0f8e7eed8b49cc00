"""Check valve, relief valve, on/off directional valve, silencer and filter."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, smoothstep
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import HEALTHY, WITHOUT_POSITION, FaultEffect, Valve
from poppet.parts.fields import NumberLike, number, option, port
from poppet.parts.flow_path import FlowPath, named_flow, single_flow
from poppet.parts.one_way_valves import flow_with_bypass, sizes_with_fault
from poppet.parts.part import GasState, Input, PassageFlows, Scope, State, Surroundings

_OF_EXHAUST = ("exhaust_conductance", "exhaust_ratio")
SPOOL_GAIN = 50.0
"""Gain of the spool position; the spool covers the last 1/50 of its travel exponentially."""


@dataclass(frozen=True)
class CheckValve(Valve, FlowPath):
    """Check valve: flow path in one direction, which opens above a cracking pressure.

    Notes
    -----
    The flow law is that of ISO 6358-1:2013 with a cracking pressure. The mass of the closing element is neglected.
    """

    kind: ClassVar[str] = "check_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.CHECK_VALVE
    summary: ClassVar[str] = "flow in one direction only, above a cracking pressure"
    faults: ClassVar[tuple[str, ...]] = WITHOUT_POSITION

    from_: str | None = port("gas node at the inlet")
    to: str | None = port("gas node at the outlet")
    cracking_pressure: NumberLike = number(
        "Pa", 0.0, doc="cracking pressure", kind="pressure_difference", low=0.0, note="none by default"
    )

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [*super().caption(numbers), f"opens at {numbers.text(self.cracking_pressure)}"]

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        size, cracking_pressure = self.size_at(scope, None), scope["cracking_pressure"]
        if self.fault == HEALTHY:
            return single_flow(scope, gas, size, cracking_pressure=cracking_pressure, one_way=True)
        return flow_with_bypass(scope, gas, *sizes_with_fault(scope, size, (0.0, size[1])), cracking_pressure)


@dataclass(frozen=True)
class ReliefValve(Valve, FlowPath):
    """Relief valve: flow path that opens if the inlet pressure exceeds the set pressure.

    Notes
    -----
    The opening is a static, continuously differentiable function of the inlet pressure. Hysteresis (blow-down) and the
    mass of the closing element are neglected.
    """

    kind: ClassVar[str] = "relief_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.RELIEF_VALVE
    summary: ClassVar[str] = "opens above the set pressure at its inlet"
    faults: ClassVar[tuple[str, ...]] = WITHOUT_POSITION

    from_: str | None = port("protected gas node")
    to: str | None = port("gas node that receives the discharge")
    set_pressure: NumberLike = number("Pa", doc="set pressure, where it begins to open", kind="pressure", above=0.0)
    accumulation: NumberLike = number(
        "Pa",
        "0.2 bar",
        doc="accumulation; pressure rise from the set pressure to full opening",
        kind="pressure_difference",
        above=0.0,
        note="rise to full opening",
    )

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [*super().caption(numbers), f"opens at {numbers.text(self.set_pressure)}"]

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        set_pressure = scope["set_pressure"]
        opening = smoothstep(gas["from"].pressure, set_pressure, set_pressure + scope["accumulation"])
        conductance, ratio = self.size_at(scope, None)
        if self.fault == HEALTHY:
            result = single_flow(scope, gas, (conductance * opening, ratio), one_way=True)
        else:
            fault = FaultEffect.of(scope)
            opening = fault.forced(opening, 1.0, 0.0)
            # Gas flows back only past an element that is off its seat.
            sizes = (conductance * fault.leaking(opening), ratio), (conductance * (fault.opens + fault.leak), ratio)
            result = flow_with_bypass(scope, gas, *sizes, 0.0)
        return replace(result, outputs={"opening": (opening, "1"), **result.outputs})


@dataclass(frozen=True)
class DirectionalValve(Valve, FlowPath):
    """Directional on/off valve (2/2 or 3/2) with delay and switching time.

    A valve with an exhaust port is a 3/2 valve.

    Notes
    -----
    The conductance of a 2/2 valve is proportional to the spool position. In a 3/2 valve, the exhaust closes over the
    first half of the stroke, and the supply opens over the second half: they are never open at the same time. By
    default, `closing_time` equals `switching_time`, the exhaust has the flow capacity of the supply, and the initial
    position of the spool is that for the value of `command`.
    """

    kind: ClassVar[str] = "directional_valve"
    regimes: ClassVar[tuple[str, ...]] = ("supply_regime", "exhaust_regime")
    symbol: ClassVar[symbols.Symbol | str] = symbols.directional_valve(has_exhaust=True, is_open=False)
    summary: ClassVar[str] = "on/off valve, 2/2 or 3/2, with delay and switching time"

    supply: str | None = port("gas node at port 1")
    outlet: str | None = port("gas node at port 2")
    exhaust: str | None = port("gas node at port 3; without it the valve is 2/2", optional=True)
    normally: str = option("closed", "open", doc="state at command 0")
    command: NumberLike = number("1", 0.0, doc="command, 0 off and 1 on", low=0.0, high=1.0, note="off by default")
    delay: NumberLike = number("s", 0.0, doc="delay from the command to the motion", low=0.0, note="none by default")
    switching_time: NumberLike = number("s", "10 ms", doc="switching time", above=0.0, note="typical of a small valve")
    closing_time: NumberLike = number("s", optional=True, doc="switching time of the return", above=0.0)
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 2 to 3", low=0.0)
    exhaust_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 2 to 3", low=0.0, below=1.0)
    initial_position: NumberLike = number("1", optional=True, doc="initial position of the spool", low=0.0, high=1.0)
    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    def usable_numbers(self, stated: Mapping[str, Number]) -> Mapping[str, Number]:
        usable = super().usable_numbers(stated)
        return usable if self.exhaust is not None else {k: v for k, v in usable.items() if k not in _OF_EXHAUST}

    def check(self) -> None:
        super().check()
        for name in _OF_EXHAUST:
            if getattr(self, name) is not None and self.exhaust is None:
                raise InputError("parts.no_exhaust_port", name)

    def symbol_for(self, is_driven: bool) -> symbols.Symbol | str:
        return symbols.directional_valve(self.exhaust is not None, self.normally == "open")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        form = "3/2" if self.exhaust is not None else "2/2"
        return [f"{form}, normally {self.normally}", *super().caption(numbers)]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("closing_time", values["switching_time"])
        values.setdefault("exhaust_conductance", values["sonic_conductance"])
        values.setdefault("exhaust_ratio", values["critical_ratio"])
        # At rest under the parameter; a signal with another initial value moves the spool from there.
        initial_position = values["command"] if self.normally == "closed" else 1.0 - values["command"]
        values.setdefault("initial_position", initial_position)
        return values

    def structure(self) -> Hashable:
        return super().structure(), self.exhaust is not None

    def states(self) -> tuple[State, ...]:
        # The tolerance refers to the stroke, also for a spool close to its seat.
        return (State("position", "1", 1.0, floor=1.0),)

    def inputs(self) -> tuple[Input, ...]:
        command = Input("command", "1", "command", low=0.0, high=1.0, delay="delay", is_command=True)
        return (command, *super().inputs())

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"]}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position, command = scope.states["position"], scope.inputs["command"]
        fault = FaultEffect.of(scope)
        target = fault.forced(command if self.normally == "closed" else 1.0 - command, 1.0, 0.0)
        speed = clip(SPOOL_GAIN * (target - position), -1.0, 1.0)
        # One of both is zero: the return can need another time.
        opening_rate, closing_rate = clip(speed, 0.0, 1.0), clip(speed, -1.0, 0.0)
        times = scope["switching_time"] * fault.slowness, scope["closing_time"] * fault.slowness
        rates = {"position": fault.held(opening_rate / times[0] + closing_rate / times[1])}
        conductance, ratio = self.size_at(scope, None)
        supply_opening = clip(position if self.exhaust is None else 2.0 * position - 1.0, 0.0, 1.0)
        supply_size = conductance * fault.leaking(supply_opening), ratio
        flow, outputs = named_flow(scope, gas, "supply", ("supply", "outlet"), supply_size)
        flows, outputs = [flow], {"position": (position, "1"), **outputs}
        if self.exhaust is not None:
            exhaust_opening = fault.leaking(clip(1.0 - 2.0 * position, 0.0, 1.0))
            size = scope["exhaust_conductance"] * exhaust_opening, scope["exhaust_ratio"]
            flow, exhaust_outputs = named_flow(scope, gas, "exhaust", ("outlet", "exhaust"), size)
            flows.append(flow)
            outputs.update(exhaust_outputs)
        return PassageFlows(tuple(flows), outputs, rates)


@dataclass(frozen=True)
class Silencer(FlowPath):
    """Silencer at an exhaust: a flow path whose sonic conductance is reduced by clogging."""

    kind: ClassVar[str] = "silencer"
    symbol: ClassVar[symbols.Symbol | str] = symbols.SILENCER
    summary: ClassVar[str] = "a silencer at an exhaust, with clogging"

    from_: str | None = port("gas node that is vented")
    to: str | None = port("gas node that receives the exhaust, usually `ambient`")
    clogging: NumberLike = number(
        "1", 0.0, doc="lost fraction of the conductance", low=0.0, high=1.0, note="clean by default"
    )

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, None)
        return single_flow(scope, gas, (conductance * (1.0 - scope["clogging"]), ratio))


@dataclass(frozen=True)
class Filter(FlowPath):
    """Filter: a flow path whose sonic conductance is reduced by clogging, which can change during a run."""

    kind: ClassVar[str] = "filter"
    symbol: ClassVar[symbols.Symbol | str] = symbols.FILTER
    summary: ClassVar[str] = "a flow path that clogs during a run"

    from_: str | None = port("gas node at the inlet")
    to: str | None = port("gas node at the outlet")
    clogging: NumberLike = number(
        "1", 0.0, doc="lost fraction of the conductance", low=0.0, high=1.0, note="clean by default"
    )

    def inputs(self) -> tuple[Input, ...]:
        return (Input("clogging", "1", "clogging", low=0.0, high=1.0),)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, None)
        return single_flow(scope, gas, (conductance * (1.0 - scope.inputs["clogging"]), ratio))
