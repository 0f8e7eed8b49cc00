"""Directional valve with five ports, 5/3 or 5/2, proportional or switched."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import ErrorCollector, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, is_certain, is_symbolic, maximum, where
from poppet.laws.curves import Characteristic
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import FaultEffect, Valve
from poppet.parts.fields import NumberLike, NumberSpec, OptionSpec, declared, number, option, port, specs
from poppet.parts.flow_path import named_flow
from poppet.parts.part import AMBIENT, Flow, GasState, Input, PassageFlows, Quantities, Scope, State, Surroundings
from poppet.parts.spool_curves import read_edge_curve
from poppet.parts.spool_edges import EDGES, MeteringEdges
from poppet.parts.spool_functions import (
    BISTABLE,
    FIELDS,
    PILOTS,
    PROPORTIONAL,
    SETPOINTS,
    command_properties,
    pilot_properties,
    pilot_signal,
    position_of,
    possible_defaults,
    resting_position,
    switched_speed,
    time_properties,
    used_field,
)

MIN_SWITCHING_TIME = 1e-6
"""Time from the centre to an end of a spool without a speed limit [s]."""
LOOSER = 30.0
"""Tolerance of the spool per tolerance of the gas states.

A sampled command accelerates the spool at each instant. With the tolerance of the gas, the spool would cause three of
four steps."""


@dataclass(frozen=True)
class SpoolValve(MeteringEdges):
    r"""Directional valve with five ports whose spool opens four metering edges.

    .. math:: C = C_l + (C_e - C_l) \operatorname{clip}\left(\frac{\pm s - o}{1 - o}, 0, 1\right)

    Notes
    -----
    In the equation, s is the position of the spool from -1 to 1, o the overlap of the edge, :math:`C_e` the conductance
    of the open edge and :math:`C_l` `leak_conductance`. At positive positions, port a is filled and port b vented.

    A proportional valve has the input `command`, the position of the spool from -1 to 1, or a setpoint in V or A. Its
    overlaps determine the centre position: closed if both are zero or positive, exhausted if only the exhaust overlap
    is negative, pressurised if only the supply overlap is negative. `switching_time` and `closing_time` limit the speed
    of the spool away from the centre and back to it; by default there is no limit. `hysteresis` is the width of the
    loop of the position, as a fraction of the full stroke from -1 to 1.

    The other functions are those of switched valves, whose spool moves at constant speed between its ends:

    - 5/2 monostable: with `command` 1 or pressure at `pilot_a`, the position is 1, otherwise -1 by the spring.
    - 5/2 bistable: `command_a` or `pilot_a` moves the spool to 1, `command_b` or `pilot_b` to -1. It keeps its position
      if both sides or no side is set. Its initial position is -1, unless `command_a` is set.
    - 5/3: as bistable, but the springs move the spool to the centre if both sides or no side is set. There, all edges
      are closed, or the exhausts or the supplies are open. Edges that are open at the centre close over the first half
      of the stroke, and the others open over the second half.

    A command counts as set from 0.75, and as not set up to 0.25. A pilot is set at `pilot_pressure`, and not set if its
    pressure is lower by `pilot_hysteresis`. No gas flows through a pilot port. `switching_time` is the time from one
    end to the other with two positions, and from the centre to an end with three. `closing_time` is the time of the
    return, by default the same.

    By default, the exhausts are the ambient, and `exhaust_overlap` equals `overlap`. The edges from the supply to port
    b and from port a to its exhaust have the flow capacity of the edge from the supply to port a. The edge from port b
    to its exhaust has the flow capacity of the edge from port a to its exhaust. An edge that is open at the centre has
    its flow capacity also there. The initial position of the spool is that of the commands.

    The fields `characteristic`, `supply_b_characteristic`, `exhaust_a_characteristic` and `exhaust_b_characteristic`
    contain tables of C and b versus s in place of the equation. By default, an edge has the mirrored table of the edge
    whose flow capacity it would have.

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
    pilot_ports: ClassVar[tuple[str, ...]] = PILOTS

    supply: str | None = port("gas node at port 1")
    a: str | None = port("gas node at port 4")
    b: str | None = port("gas node at port 2")
    exhaust_a: str | None = port("gas node at port 5", optional=True)
    exhaust_b: str | None = port("gas node at port 3", optional=True)
    pilot_a: str | None = port("gas node at pilot port 14; its pressure moves the spool to a", optional=True)
    pilot_b: str | None = port("gas node at pilot port 12; its pressure moves the spool to b", optional=True)
    setpoint_type: str = option("command", *SETPOINTS, doc="type of setpoint; position, or voltage or current for it")
    command: NumberLike = number(
        "1", 0.0, doc="command", low=-1.0, high=1.0, note="centre by default", varies=command_properties
    )
    command_a: NumberLike = number(
        "1", 0.0, doc="command to a", low=0.0, high=1.0, note="off by default", varies=used_field("command_a")
    )
    command_b: NumberLike = number(
        "1", 0.0, doc="command to b", low=0.0, high=1.0, note="off by default", varies=used_field("command_b")
    )
    delay: NumberLike = number("s", 0.0, doc="delay of a command signal", low=0.0, note="none by default")
    dynamics: str = option("first_order", "second_order", doc="dynamics of the spool")
    lag: NumberLike = number(
        "s", "5 ms", doc="time constant of the spool", above=0.0, note="a small valve", varies=used_field("lag")
    )
    natural_frequency: NumberLike = number(
        "Hz", 100.0, doc="natural frequency", above=0.0, note="a small valve", varies=used_field("natural_frequency")
    )
    damping: NumberLike = number(
        "1", 0.7, doc="damping ratio", above=0.0, note="small overshoot", varies=used_field("damping")
    )
    hysteresis: NumberLike = number(
        "1", optional=True, doc="hysteresis; width of the loop as a fraction of the full stroke", low=0.0, below=1.0
    )
    switching_time: NumberLike = number(
        "s", "10 ms", doc="switching time", above=0.0, note="typical of a small valve", varies=time_properties
    )
    closing_time: NumberLike = number("s", optional=True, doc="switching time of the return", above=0.0)
    pilot_pressure: NumberLike = number(
        "Pa", "2.5 bar g", doc="switching pressure of the pilots", kind="pressure", above=0.0, note="a small valve",
        varies=pilot_properties,
    )  # fmt: skip
    pilot_hysteresis: NumberLike = number(
        "Pa", "0.5 bar", doc="hysteresis of the pilots; pressure below the switching pressure at which they release",
        kind="pressure_difference", above=0.0, note="a small valve", varies=pilot_properties,
    )  # fmt: skip
    initial_position: NumberLike = number("1", optional=True, doc="initial position of the spool", low=-1.0, high=1.0)

    def __post_init__(self) -> None:
        # A copy with other options must not keep the defaults of the previous ones.
        for name, _, spec in declared(type(self), NumberSpec):
            if spec.varies is None or name in specs(Valve):
                continue
            value = getattr(self, name)
            is_default = isinstance(value, Number) and value.source.kind == "assumed" and not is_symbolic(value.value)
            if is_default and value in possible_defaults(name, spec):
                object.__setattr__(self, name, None)
        super().__post_init__()

    def check(self) -> None:
        super().check()
        with ErrorCollector() as errors:
            for name, functions in FIELDS.items():
                default = spec.choices[0] if isinstance(spec := specs(type(self))[name], OptionSpec) else None
                if self.function not in functions and getattr(self, name) != default:
                    errors.add("spool.idle_field", name, function=self.function, functions=[*functions])
            for name in ("pilot_pressure", "pilot_hysteresis"):
                if getattr(self, name) is not None and self.pilot_a is None and self.pilot_b is None:
                    errors.add("spool.no_pilot", name)

    def read_curve(self, field: str) -> Characteristic:
        return read_edge_curve(getattr(self, field), field, self.setpoint_type)

    @property
    def _is_switched(self) -> bool:
        return self.function != PROPORTIONAL

    def ports(self) -> dict[str, str]:
        exhausts = (name for name in ("exhaust_a", "exhaust_b") if getattr(self, name) is None)
        return super().ports() | dict.fromkeys(exhausts, AMBIENT)

    def structure(self) -> Hashable:
        return super().structure(), self.hysteresis is None, self.closing_time is None

    def symbol_for(self, is_driven: bool) -> symbols.Symbol | str:
        function = self.spool_function
        if not self._is_switched:
            return self.symbol
        pilots = (self.pilot_a is not None, self.pilot_b is not None)
        return symbols.switched_valve(
            function.n_positions, function.open_at_centre, pilots, len(function.commands) == 1
        )

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        if self._is_switched:
            has_pilots = self.pilot_a is not None or self.pilot_b is not None
            pilots = [f"pilots at {numbers.text(self.pilot_pressure)}"] if has_pilots else []
            return [
                self.function,
                *super().caption(numbers),
                f"switches in {numbers.text(self.switching_time)}",
                *pilots,
            ]
        overlaps: dict[str, Any] = {"supply": self.overlap, "exhausts": self.exhaust_overlap or self.overlap}
        is_open = " and ".join(side for side, overlap in overlaps.items() if float(overlap) < 0.0)
        dynamics = self.lag if self.dynamics == "first_order" else self.natural_frequency
        head, spool = f"5/3, {is_open or 'nothing'} open at the centre", f"spool {numbers.text(dynamics)}"
        setpoint = [] if self.setpoint_type == "command" else [f"setpoint: {self.setpoint_type}"]
        return [head, *super().caption(numbers), spool, *setpoint]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self._is_switched:
            values.setdefault("closing_time", values["switching_time"])
            values.setdefault("initial_position", resting_position(self.spool_function, *self._signals(values)))
        else:
            values.setdefault("switching_time", MIN_SWITCHING_TIME)
            values.setdefault("initial_position", position_of(values["command"], self.setpoint_type))
        if "pilot_pressure" in values:
            release = values["pilot_pressure"] - values["pilot_hysteresis"]
            if is_certain(release <= ambient.pressure):
                facts = {"release_bar": release / 1e5, "ambient_bar": ambient.pressure / 1e5}
                shown = self.numbers()["pilot_pressure"].display()
                raise OutOfRangeError("spool.never_released", "pilot_pressure", shown=shown, **facts)
        return values

    def states(self) -> tuple[State, ...]:
        # With a dead band of the error, a large step could end beyond the band without a visible error.
        tolerance = LOOSER if self.hysteresis is None else 1.0
        position = State("position", "1", 1.0, tolerance, 1.0)
        velocity = State("velocity", "1/s", 100.0, tolerance, 1.0)
        return (position,) if self.dynamics == "first_order" else (position, velocity)

    def inputs(self) -> tuple[Input, ...]:
        unit, low, high = SETPOINTS.get(self.setpoint_type, ("1", -1.0, 1.0))
        if self._is_switched:
            low, high = 0.0, 1.0
        names = self.spool_function.commands
        commands = (Input(name, unit, name, low=low, high=high, delay="delay", is_command=True) for name in names)
        return (*commands, *super().inputs())

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"position": scope["initial_position"], "velocity": 0.0}
        return {state.name: values[state.name] for state in self.states()}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        flows, outputs = list[Flow](), Quantities(position=(scope.states["position"], "1"))
        for edge, (first, second, _) in EDGES.items():
            flow, edge_outputs = named_flow(scope, gas, edge, (first, second), self.edge_size(scope, edge))
            flows.append(flow)
            outputs.update(edge_outputs)
        if not self._is_switched:
            return PassageFlows(tuple(flows), outputs, self._proportional_rates(scope))
        fault, signals = FaultEffect.of(scope), [*self._signals(scope.inputs)]
        for k, pilot in enumerate(PILOTS):
            if pilot in gas:
                pressures = scope["pilot_pressure"], scope["pilot_hysteresis"]
                signals[k] = maximum(signals[k], pilot_signal(gas[pilot].pressure, *pressures))
        # Only a bistable spool needs a signal to leave the side of a.
        closing_signal = 1.0 if self.function == BISTABLE else 0.0
        signals = [fault.forced(signals[0], 1.0, 0.0), fault.forced(signals[1], 0.0, closing_signal)]
        times = scope["switching_time"] * fault.slowness, scope["closing_time"] * fault.slowness
        speed = switched_speed(self.spool_function, scope.states["position"], signals[0], signals[1], *times)
        return PassageFlows(tuple(flows), outputs, {"position": fault.held(speed)})

    # Motion of the spool -----------------------------------------------------------------------------------------

    def _proportional_rates(self, scope: Scope) -> dict[str, Any]:
        fault, position = FaultEffect.of(scope), scope.states["position"]
        speed = 1.0 / (scope["switching_time"] * fault.slowness)
        target = fault.forced(position_of(scope.inputs["command"], self.setpoint_type), 1.0, 0.0)
        error, max_speed, min_speed = target - position, speed, -speed
        if self.hysteresis is not None:
            # The position has the unit of half the stroke: this fraction is half the width of its loop. A spool that
            # is stuck at an end reaches it.
            half_width = fault.forced(scope["hysteresis"], 0.0, 0.0)
            error = error - clip(error, -half_width, half_width)
        if self.closing_time is not None:
            return_speed = 1.0 / (scope["closing_time"] * fault.slowness)
            max_speed = where(position < 0.0, return_speed, speed)
            min_speed = -where(position > 0.0, return_speed, speed)
        if self.dynamics == "first_order":
            return {"position": fault.held(clip(error / (scope["lag"] * fault.slowness), min_speed, max_speed))}
        omega, velocity = math.tau * scope["natural_frequency"] / fault.slowness, scope.states["velocity"]
        rate = omega * omega * error - 2.0 * scope["damping"] * omega * velocity
        # A spool that is released starts from rest.
        rate = fault.held(rate) - fault.holds * omega * velocity
        return {"position": fault.held(clip(velocity, min_speed, max_speed)), "velocity": rate}

    def _signals(self, commands: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the signals towards a and b of a switched valve for its commands by name."""
        first, *second = (commands[name] for name in self.spool_function.commands)
        return first, (second or [0.0])[0]
