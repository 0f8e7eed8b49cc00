"""Check valves with a second flow path: flow control valve and piloted check valve."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from poppet.core.symbolic import clip, maximum, where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import WITHOUT_POSITION, FaultEffect, Valve
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.flow_path import FlowPath, single_flow
from poppet.parts.part import Flow, GasState, Input, PassageFlows, Scope, Surroundings


def flow_with_bypass(
    scope: Scope, gas: Mapping[str, GasState], size: tuple[Any, Any], bypass_size: tuple[Any, Any],
    cracking_pressure: Any,
) -> PassageFlows:  # fmt: skip
    """Return the flow of a check valve with a bypass.

    `size` contains sonic conductance and critical pressure ratio of the free direction including the bypass, and
    `bypass_size` the same values of the bypass alone. In the free direction, the flow is the larger of the two flows.
    In the other direction, it is the flow of the bypass.
    """
    free = single_flow(scope, gas, size, cracking_pressure=cracking_pressure, one_way=True)
    bypass = single_flow(scope, gas, bypass_size)
    (flow,), (other,) = free.flows, bypass.flows
    is_free = flow.mass > maximum(other.mass, 0.0)
    mass, enthalpy = where(is_free, flow.mass, other.mass), where(is_free, flow.enthalpy, other.enthalpy)
    regime = where(is_free, free.outputs["regime"][0], bypass.outputs["regime"][0])
    outputs = {"mass_flow_rate": (mass, "kg/s"), "regime": (regime, "1")}
    return PassageFlows((Flow(flow.name, flow.source, flow.target, mass, enthalpy),), outputs)


def sizes_with_fault(
    scope: Scope, size: tuple[Any, Any], bypass_size: tuple[Any, Any]
) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """Return the two sizes of a check valve with a bypass and a fault of its closing element.

    An element that is stuck open or leaks increases the bypass, and one that is stuck closed leaves only the bypass.
    """
    (conductance, ratio), (bypass_conductance, bypass_ratio), fault = size, bypass_size, FaultEffect.of(scope)
    opened = fault.opens + fault.leak
    bypass_conductance = bypass_conductance + opened * maximum(conductance - bypass_conductance, 0.0)
    bypass_ratio = bypass_ratio + opened * (ratio - bypass_ratio)
    return (conductance * (1.0 - fault.closes), ratio), (bypass_conductance, bypass_ratio)


@dataclass(frozen=True)
class FlowControlValve(Valve, FlowPath):
    r"""One-way flow control valve: free flow in one direction, throttled flow in the other one.

    .. math:: q_m = \begin{cases} \max(q_c, q_t) & p_1 \ge p_2 \\ q_t & p_1 < p_2 \end{cases}

    Notes
    -----
    In the equation, :math:`q_c` is the flow of a check valve with the flow capacity and the cracking pressure of the
    part, and :math:`q_t` is the flow of a throttle. The sonic conductance of this throttle is `throttle_conductance`
    times `opening`. The flow capacity of the part (C and b, or a nominal flow) is the capacity of the complete valve in
    the free direction, including the throttle. Catalogues state this capacity. By default, the throttle has the
    critical ratio of the free direction.

    Examples
    --------
    >>> valve = FlowControlValve(
    ...     from_="line", to="cylinder.cap", nominal_flow="400 l/min ANR", throttle_conductance="0.5 dm^3/(s bar)"
    ... )
    >>> float(valve.opening)
    1.0
    """

    kind: ClassVar[str] = "flow_control_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.FLOW_CONTROL_VALVE
    summary: ClassVar[str] = "free flow in one direction, throttled flow in the other one"
    faults: ClassVar[tuple[str, ...]] = WITHOUT_POSITION

    from_: str | None = port("gas node from which gas flows freely")
    to: str | None = port("gas node from which gas flows through the throttle")
    throttle_conductance: NumberLike = number("m^3/(s Pa)", doc="conductance C of the open throttle", low=0.0)
    throttle_ratio: NumberLike = number("1", optional=True, doc="critical ratio b of the throttle", low=0.0, below=1.0)
    opening: NumberLike = number("1", 1.0, doc="opening of the throttle", low=0.0, high=1.0, note="fully open")
    cracking_pressure: NumberLike = number(
        "Pa", 0.0, doc="cracking pressure", kind="pressure_difference", low=0.0, note="none by default"
    )

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [*super().caption(numbers), f"throttle C = {numbers.text(self.throttle_conductance)}"]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("throttle_ratio", values["critical_ratio"])
        return values

    def inputs(self) -> tuple[Input, ...]:
        return (Input("opening", "1", "opening", low=0.0, high=1.0, is_command=True), *super().inputs())

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        throttle = scope["throttle_conductance"] * scope.inputs["opening"], scope["throttle_ratio"]
        sizes = sizes_with_fault(scope, self.size_at(scope, None), throttle)
        return flow_with_bypass(scope, gas, *sizes, scope["cracking_pressure"])


@dataclass(frozen=True)
class PilotedCheckValve(Valve, FlowPath):
    r"""Pilot-operated check valve: a pilot pressure opens it in the blocked direction.

    .. math:: y = \operatorname{clip}\left(
              \frac{r (p_p - p_1) - (p_2 - p_1) - \Delta p_c}{\Delta p_b}, 0, 1\right)

    Notes
    -----
    In the equation, y is the opening by the pilot, r `pilot_ratio` (area of the pilot piston divided by that of the
    seat), :math:`p_p` the pilot pressure, :math:`p_1` and :math:`p_2` the pressures at `from` and `to`,
    :math:`\Delta p_c` `cracking_pressure` and :math:`\Delta p_b` `pilot_band`. In the blocked direction, C is the
    opening times that of the size. From `from` to `to`, the valve is a check valve. No gas flows through the pilot
    port; the mass of the piston is neglected.

    Examples
    --------
    >>> valve = PilotedCheckValve(from_="line", to="cylinder.cap", pilot="other_line", nominal_flow="300 l/min ANR")
    >>> float(valve.pilot_ratio)
    3.0
    """

    kind: ClassVar[str] = "piloted_check_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.PILOTED_CHECK_VALVE
    pilot_ports: ClassVar[tuple[str, ...]] = ("pilot",)
    summary: ClassVar[str] = "check valve that a pilot pressure opens"
    faults: ClassVar[tuple[str, ...]] = WITHOUT_POSITION

    from_: str | None = port("gas node at the inlet of the check valve")
    to: str | None = port("gas node in which the valve holds the pressure")
    pilot: str | None = port("gas node with the pilot pressure")
    pilot_ratio: NumberLike = number(
        "1", 3.0, doc="area ratio of pilot piston and seat", above=0.0, note="a small valve"
    )
    pilot_band: NumberLike = number(
        "Pa",
        "0.1 bar",
        doc="pilot band; excess pressure on the seat from the start of the opening to full opening",
        kind="pressure_difference",
        above=0.0,
        note="a short stroke",
    )
    cracking_pressure: NumberLike = number(
        "Pa", 0.0, doc="cracking pressure", kind="pressure_difference", low=0.0, note="none by default"
    )

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [*super().caption(numbers), f"pilot ratio {numbers.text(self.pilot_ratio)}"]

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        first, second, pilot = (gas[name].pressure for name in ("from", "to", "pilot"))
        excess = scope["pilot_ratio"] * (pilot - first) - (second - first) - scope["cracking_pressure"]
        fault = FaultEffect.of(scope)
        opening = fault.forced(clip(excess / scope["pilot_band"], 0.0, 1.0), 1.0, 0.0)
        conductance, ratio = self.size_at(scope, None)
        sizes = sizes_with_fault(scope, (conductance, ratio), (conductance * opening, ratio))
        result = flow_with_bypass(scope, gas, *sizes, scope["cracking_pressure"])
        return replace(result, outputs={"opening": (opening, "1"), **result.outputs})
