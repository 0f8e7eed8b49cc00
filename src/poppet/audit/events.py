"""Events of a safety audit: inputs of a circuit that have a given value from a given time on."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, ClassVar, TypeVar

import numpy as np

from poppet.audit.safety_result import EventValue
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.onset import onset_field
from poppet.circuit.wiring import part_connections
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.symbolic import where
from poppet.core.units import quantity
from poppet.parts.part import Controller, ControlOutputs, Input, Scope
from poppet.timeseries.segments import SegmentTable, Signal, held
from poppet.timeseries.signals import Chirp, Constant, Pwm, Steps

AnyCircuit = TypeVar("AnyCircuit", bound=BaseCircuit)


@dataclass(frozen=True)
class EventSignal(Signal):
    """Signal that has a constant value from the time of an event on [s]."""

    before: Signal
    time: float
    value: float

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        if self.time <= 0.0:
            return held(self.value)
        if end <= self.time:
            return self.before.segments(end, duration)
        table = self.before.segments(self.time, duration)
        values = {"start": self.time, "value": self.value, "jump": True}
        columns = {f.name: np.append(getattr(table, f.name), values.get(f.name, 0.0)) for f in fields(table)}
        return SegmentTable(**{**columns, "jump": columns["jump"].astype(bool)})

    def bounds(self) -> tuple[float, float]:
        low, high = self.before.bounds()
        return min(low, self.value), max(high, self.value)


@dataclass(frozen=True)
class EventSwitch(Controller):
    """Selector between the output that drives an input and the value of an event.

    The output is `source`, or `value` while `active` is 1.
    """

    kind: ClassVar[str] = "event"
    summary: ClassVar[str] = "selector between an output and the value of an event"
    internal_outputs: ClassVar[tuple[str, ...]] = ("source", "value", "active", "output")

    unit: str = "1"

    def structure(self) -> Hashable:
        return super().structure(), self.unit

    def inputs(self) -> tuple[Input, ...]:
        return (
            Input("source", self.unit, 0.0), Input("value", self.unit, 0.0),
            Input("active", "1", 0.0, low=0.0, high=1.0, is_flag=True),
        )  # fmt: skip

    def control(self, scope: Scope) -> ControlOutputs:
        inputs = scope.inputs
        return ControlOutputs({"output": (where(inputs["active"] > 0.5, inputs["value"], inputs["source"]), self.unit)})


def read_events(circuit: BaseCircuit, values: Mapping[str, Any]) -> tuple[EventValue, ...]:
    """Return the inputs and values of an event, and report all errors together.

    `values` maps addresses of inputs to values in SI units, or to texts with a unit.
    """
    if not values:
        raise InputError("safety.no_event")
    events, declared = [], part_connections(circuit.parts)
    with ErrorCollector() as errors:
        for address, argument in values.items():
            item = circuit.inputs.get(address)
            if item is None or item.slope_of:
                suggestion = NameSuggestion(
                    address, [name for name, item in circuit.inputs.items() if not item.slope_of]
                )
                errors.add("names.unknown", address, meaning="an input of this circuit", suggestion=suggestion)
                continue
            if address in declared:
                errors.add("safety.declared", address, place=declared[address].place)
                continue
            start = circuit.parameters.get(f"{address.partition('.')[0]}.{item.delay}") if item.is_onset else None
            if start:
                errors.add("safety.other_start", address, field=onset_field(address, item), time=start)
                continue
            with errors.collecting():
                read = quantity(argument, item.unit, kind=item.kind, name=address)  # type: ignore[arg-type]
                is_gauge = read.reference == "gauge"
                value = read.value + (circuit.surroundings.pressure if is_gauge else 0.0)
                low, high = (_limit(circuit, address, limit) for limit in (item.low, item.high))
                if not low <= value <= high:
                    raise InputError("inputs.outside", address, given=argument, low=low, high=high, unit=item.unit)
                text = argument if isinstance(argument, str) else ""
                source = circuit.connections.get(address, "")
                events.append(EventValue(address, value, item.unit, text, source, is_gauge))
    return tuple(events)


def _limit(circuit: BaseCircuit, address: str, limit: str | float) -> float:
    return circuit.parameters[f"{address.rpartition('.')[0]}.{limit}"] if isinstance(limit, str) else limit


def with_switches(circuit: AnyCircuit, events: tuple[EventValue, ...]) -> AnyCircuit:
    """Return a copy of a circuit in which events can replace connections.

    Each connected input of an event is connected to an `EventSwitch`, and the switch to the former output.
    """
    connected = [event for event in events if event.replaced]
    if not connected:
        return circuit
    switches = {_switch_name(circuit, events, event): event for event in connected}
    declared = part_connections(circuit.parts)
    connections = {target: source for target, source in circuit.connections.items() if target not in declared}
    for name, event in switches.items():
        connections |= {event.address: f"{name}.output", f"{name}.source": event.replaced}
    parts = {**circuit.parts, **{name: EventSwitch(unit=event.unit) for name, event in switches.items()}}
    return replace(circuit, parts=parts, connections=connections)


def with_fixed_sweeps(circuit: AnyCircuit) -> AnyCircuit:
    """Return a copy of a circuit whose chirps keep their duration in a longer run.

    A chirp without a duration sweeps during the whole run, which an audit extends.
    """
    if circuit.run.duration is None:
        return circuit
    duration = float(circuit.run.duration)  # type: ignore[arg-type]

    def fixed(signal: Signal) -> Signal:
        if isinstance(signal, Chirp) and signal.duration is None:
            return replace(signal, duration=duration)
        if isinstance(signal, Pwm) and isinstance(signal.duty, Signal):
            return replace(signal, duty=fixed(signal.duty))
        return signal

    return circuit.with_signals({address: fixed(signal) for address, signal in circuit.signals.items()})


def _switch_name(circuit: BaseCircuit, events: tuple[EventValue, ...], event: EventValue) -> str:
    name = f"event_{events.index(event) + 1}"
    while name in circuit.parts and circuit.parts[name].kind != EventSwitch.kind:
        name += "_"
    return name


def event_signals(circuit: BaseCircuit, events: tuple[EventValue, ...], time: float) -> dict[str, Signal]:
    """Return all signals of a circuit with an event at a given time [s].

    `circuit` is the result of `with_switches`. The event never happens if the time is infinite.
    """
    signals = dict(circuit.signals)
    for event in events:
        if event.replaced:
            name = _switch_name(circuit, events, event)
            signals[f"{name}.value"] = Constant(event.value)
            is_stepped = 0.0 < time < math.inf
            signals[f"{name}.active"] = Steps([0.0, time], [0.0, 1.0]) if is_stepped else Constant(float(time <= 0.0))
            continue
        present = signals.get(event.address) or Constant(default_value(circuit, event.address))
        signals[event.address] = EventSignal(present, time, event.value)
    return signals


def default_value(circuit: BaseCircuit, address: str) -> float:
    """Return the value of an input that has neither a signal nor a connection, SI and absolute."""
    return _limit(circuit, address, circuit.inputs[address].default)


def changes_nothing(event: EventValue, present: float) -> bool:
    """Return True if an input already has the value of an event."""
    return math.isclose(event.value, present, rel_tol=1e-9, abs_tol=1e-12)
