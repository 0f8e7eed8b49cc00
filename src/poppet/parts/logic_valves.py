"""Valves that the pressures at their ports switch: shuttle valve, two-pressure valve and quick exhaust valve."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip, where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import FaultEffect, Valve
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.flow_path import FlowPath, named_flow
from poppet.parts.part import AMBIENT, Flow, GasState, PassageFlows, Quantities, Scope, State, Surroundings
from poppet.parts.two_positions import FULL_DRIVE, gradual_switching_rate


@dataclass(frozen=True)
class LogicValve(Valve, FlowPath):
    """Base class of valves with a closing element that moves between two seats.

    The difference of two pressures moves the element. At position 0, only the first flow path is open, at position 1
    only the second one.
    """

    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    switching_pressure: NumberLike = number(
        "Pa",
        "0.05 bar",
        doc="switching pressure; pressure difference that moves the closing element in either direction",
        kind="pressure_difference",
        above=0.0,
        note="a light closing element",
    )
    switching_time: NumberLike = number(
        "s",
        "2 ms",
        doc="switching time; travel time from seat to seat at twice the switching pressure or more",
        above=0.0,
        note="a small valve",
    )
    initial_position: NumberLike = number(
        "1", 0.0, doc="initial position of the closing element", low=0.0, high=1.0, note="first flow path open"
    )

    @abstractmethod
    def pressure_difference(self, gas: Mapping[str, GasState]) -> Any:
        """Return the pressure difference that moves the closing element to position 1 [Pa]."""

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [*super().caption(numbers), f"switches at {numbers.text(self.switching_pressure)}"]

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return super().output_ranges() | {"position": (0.0, 1.0)}

    def states(self) -> tuple[State, ...]:
        return (State("position", "1", 1.0, floor=1.0),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"]}

    def valve_flows(self, scope: Scope, gas: Mapping[str, GasState], *paths: tuple[Flow, Quantities]) -> PassageFlows:
        """Return the flows of both flow paths, all outputs, and the speed of the closing element."""
        position, fault = scope.states["position"], FaultEffect.of(scope)
        drive = self.pressure_difference(gas) / scope["switching_pressure"]
        drive = fault.forced(drive, -FULL_DRIVE, FULL_DRIVE)
        # The integrator can exceed the seats by its tolerance.
        outputs: Quantities = {"position": (clip(position, 0.0, 1.0), "1")}
        for _, path_outputs in paths:
            outputs |= path_outputs
        rate = gradual_switching_rate(position, drive, scope["switching_time"] * fault.slowness)
        return PassageFlows(tuple(flow for flow, _ in paths), outputs, {"position": fault.held(rate)})


@dataclass(frozen=True)
class TwoInletValve(LogicValve):
    r"""Base class of valves that connect one of two inlets with the outlet.

    .. math:: o_a^e = \operatorname{clip}(3 - 4 x, 0, 1), \qquad o_a^l = \operatorname{clip}(1 - 4 x, 0, 1)

    The openings of inlet `a` are the early one (e) for one flow direction, and the late one (l) for the other one.
    Those of inlet `b` are the mirror images. The early openings of both inlets overlap. Otherwise, two inlets of equal
    pressure would stop the element between its seats and close the outlet, because their flows move the element back.
    An early opening and a late one of the other inlet never overlap, so gas never flows from one inlet to the other.
    """

    regimes: ClassVar[tuple[str, ...]] = ("a_regime", "b_regime")
    inlet_ports: ClassVar[tuple[str, ...]] = ("a", "b")
    feeds_early: ClassVar[bool]
    """True if the early openings are those of flows to the outlet."""

    a: str | None = port("gas node at the first inlet")
    b: str | None = port("gas node at the second inlet")
    outlet: str | None = port("gas node at the outlet")

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, None)
        position, fault = scope.states["position"], FaultEffect.of(scope)
        paths = []
        for inlet, distance in (("a", position), ("b", 1.0 - position)):
            early, late = clip(3.0 - 4.0 * distance, 0.0, 1.0), clip(1.0 - 4.0 * distance, 0.0, 1.0)
            feeding, venting = (early, late) if self.feeds_early else (late, early)
            opening = fault.leaking(where(gas[inlet].pressure > gas["outlet"].pressure, feeding, venting))
            paths.append(named_flow(scope, gas, inlet, (inlet, "outlet"), (conductance * opening, ratio)))
        return self.valve_flows(scope, gas, *paths)


@dataclass(frozen=True)
class ShuttleValve(TwoInletValve):
    r"""Shuttle valve (OR): the inlet with the higher pressure is connected with the outlet.

    .. math:: T \dot x = \operatorname{clip}\bigl(d - \operatorname{clip}(d, -0.8, 0.8) + 0.2 (2 x - 1), -1, 1\bigr),
              \qquad d = \frac{p_b - p_a}{\Delta p_s}

    Notes
    -----
    In the equation, x is the position of the closing element (0: `a` open, 1: `b` open), T `switching_time` and
    :math:`\Delta p_s` `switching_pressure`. The element moves to 1 if the pressure at `b` exceeds that at `a` by the
    switching pressure, and to 0 in the opposite case. Between these limits it keeps its seat. Gas flows in both
    directions through the open inlet: the outlet vents through the inlet that has filled it. Between the seats, both
    inlets can feed the outlet, but gas cannot flow from one inlet to the other.

    Examples
    --------
    >>> valve = ShuttleValve(a="button", b="pedal", outlet="signal", nominal_flow="100 l/min ANR")
    >>> valve.switching_pressure.display()
    '0.05 bar'
    """

    kind: ClassVar[str] = "shuttle_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.SHUTTLE_VALVE
    summary: ClassVar[str] = "OR: the inlet with the higher pressure feeds the outlet"
    feeds_early: ClassVar[bool] = True

    def pressure_difference(self, gas: Mapping[str, GasState]) -> Any:
        return gas["b"].pressure - gas["a"].pressure


@dataclass(frozen=True)
class TwoPressureValve(TwoInletValve):
    r"""Two-pressure valve (AND): the inlet with the lower pressure is connected with the outlet.

    .. math:: T \dot x = \operatorname{clip}\bigl(d - \operatorname{clip}(d, -0.8, 0.8) + 0.2 (2 x - 1), -1, 1\bigr),
              \qquad d = \frac{p_a - p_b}{\Delta p_s}

    Notes
    -----
    In the equation, x is the position of the closing element (0: `a` open, 1: `b` open), T `switching_time` and
    :math:`\Delta p_s` `switching_pressure`. The element moves to 1 if the pressure at `a` exceeds that at `b` by the
    switching pressure, and to 0 in the opposite case. Between these limits it keeps its seat. The outlet has pressure
    only if both inlets have pressure. Gas flows in both directions through the open inlet. Between the seats, the
    outlet can vent through both inlets, but gas cannot flow from one inlet to the other.

    Examples
    --------
    >>> valve = TwoPressureValve(a="left", b="right", outlet="press", nominal_flow="100 l/min ANR")
    >>> valve.ports()
    {'a': 'left', 'b': 'right', 'outlet': 'press'}
    """

    kind: ClassVar[str] = "two_pressure_valve"
    symbol: ClassVar[symbols.Symbol | str] = symbols.TWO_PRESSURE_VALVE
    summary: ClassVar[str] = "AND: the inlet with the lower pressure feeds the outlet"
    feeds_early: ClassVar[bool] = False

    def pressure_difference(self, gas: Mapping[str, GasState]) -> Any:
        return gas["a"].pressure - gas["b"].pressure


@dataclass(frozen=True)
class QuickExhaustValve(LogicValve):
    r"""Quick exhaust valve: fills the outlet from the inlet, and vents it to the exhaust.

    .. math:: C_i = C \operatorname{clip}(1 - 2 x, 0, 1), \qquad C_e = C_{23} \operatorname{clip}(2 x - 1, 0, 1)

    Notes
    -----
    In the equation, x is the position of the lip seal and :math:`C_{23}` the field `exhaust_conductance`. The seal
    moves by the law of `ShuttleValve`: to 1 if the pressure at the outlet exceeds that at the inlet by
    `switching_pressure`, and to 0 in the opposite case. Between these limits it keeps its position. No gas flows from
    the outlet to the inlet. By default, the exhaust is the ambient, and has the flow capacity of the path from the
    inlet to the outlet.

    Examples
    --------
    >>> valve = QuickExhaustValve(inlet="line", outlet="cylinder.rod", nominal_flow="300 l/min ANR")
    >>> valve.ports()["exhaust"]
    'ambient'
    """

    kind: ClassVar[str] = "quick_exhaust_valve"
    regimes: ClassVar[tuple[str, ...]] = ("inlet_regime", "exhaust_regime")
    symbol: ClassVar[symbols.Symbol | str] = symbols.QUICK_EXHAUST_VALVE
    summary: ClassVar[str] = "fills a load from its inlet and vents it through its exhaust"

    inlet: str | None = port("gas node at the inlet")
    outlet: str | None = port("gas node that is filled and vented")
    exhaust: str | None = port("gas node at the exhaust", optional=True)
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 2 to 3", low=0.0)
    exhaust_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 2 to 3", low=0.0, below=1.0)

    def ports(self) -> dict[str, str]:
        ports = super().ports()
        ports.setdefault("exhaust", AMBIENT)
        return ports

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("exhaust_conductance", values["sonic_conductance"])
        values.setdefault("exhaust_ratio", values["critical_ratio"])
        return values

    def pressure_difference(self, gas: Mapping[str, GasState]) -> Any:
        return gas["outlet"].pressure - gas["inlet"].pressure

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, None)
        position, fault = scope.states["position"], FaultEffect.of(scope)
        fills = fault.leaking(clip(1.0 - 2.0 * position, 0.0, 1.0))
        vents = fault.leaking(clip(2.0 * position - 1.0, 0.0, 1.0))
        size, exhaust_size = (
            (conductance * fills, ratio),
            (scope["exhaust_conductance"] * vents, scope["exhaust_ratio"]),
        )
        inlet = named_flow(scope, gas, "inlet", ("inlet", "outlet"), size, one_way=True)
        exhaust = named_flow(scope, gas, "exhaust", ("outlet", "exhaust"), exhaust_size)
        return self.valve_flows(scope, gas, inlet, exhaust)
