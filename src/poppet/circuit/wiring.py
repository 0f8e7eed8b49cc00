"""Mistakes of names, connections and signals of a circuit, all of them at once."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping
from dataclasses import replace
from difflib import get_close_matches
from typing import Any, NamedTuple

from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.parts.fields import BodySpec, MemberSpec, PortSpec, attribute, specs
from poppet.parts.part import AMBIENT, TUBE, Body, Input, Part, Passage, Store, is_port
from poppet.timeseries.segments import Signal

RESERVED = ("ambient", "gas", "run", "time", "title", "signals", "parts", "connections")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,99}")
MOST_PARTS = 5000
"""Parts of a circuit. A thousand chambers take about a minute to be made ready; beyond, something else is meant."""
_MAPPINGS = {
    "parts": '{"tank": Chamber(volume="10 l")}',
    "signals": '{"valve.pilot_pressure": Steps([0.0], [2e5])}',
    "connections": '{"main.pilot_pressure": "pilot.pressure"}',
}
"""Fields of a circuit that are mappings, with an example of each."""


class PartWiring(NamedTuple):
    """How a part is joined to others."""

    kind: type[Part]
    ports: Mapping[str, str]  # port to the address of the store
    stores: tuple[str, ...]  # local names of its own stores; the empty name is the part itself
    body: str | None = None  # that it moves

    @classmethod
    def of(cls, part: Part) -> PartWiring:
        """Of a part that could be made."""
        return cls(type(part), part.ports(), part.stores(), part.body_name())

    @classmethod
    def of_table(cls, kind: type[Part], table: Mapping[str, Any]) -> PartWiring:
        """Of a part that has mistakes, as far as its table tells."""
        texts = {name: value for name, value in table.items() if isinstance(value, str)}
        known = specs(kind)
        ports = {name: texts[name] for name, spec in known.items() if isinstance(spec, PortSpec) and name in texts}
        stores = [name for name, spec in known.items() if isinstance(spec, MemberSpec) and spec.is_open]
        if kind.kind == TUBE:
            from poppet.parts.tube import MAX_CELLS

            stores = [str(k) for k in range(1, MAX_CELLS + 1)]
        body = next((texts.get(name) for name, spec in known.items() if isinstance(spec, BodySpec)), None)
        return cls(kind, ports, ("",) if issubclass(kind, Store) else tuple(stores), body)


Wiring = Mapping[str, PartWiring]


def check_kinds(circuit: Any) -> None:
    """Refuse what stands in a circuit's fields without being of their kind."""
    check_count(circuit.parts)
    with ErrorCollector() as errors:
        for name, example in _MAPPINGS.items():
            if not isinstance(getattr(circuit, name), Mapping):
                errors.add("wiring.no_mapping", name, value=getattr(circuit, name), example=example)
        for name, kind in {"run": Run, "ambient": Ambient, "gas": GasChoice}.items():
            if not isinstance(getattr(circuit, name), kind):
                errors.add("wiring.other_class", name, value=getattr(circuit, name), wanted=kind.__name__)
        for name, part in circuit.parts.items() if isinstance(circuit.parts, Mapping) else ():
            if not isinstance(name, str):
                errors.add("wiring.no_text", "parts", name=name)
            elif not isinstance(part, Part):
                errors.add("wiring.no_part", f"parts.{name}", value=part)


def check_count(parts: Any) -> None:
    """Refuse what is too large for a circuit, before anything is made of it."""
    if isinstance(parts, Mapping) and len(parts) > MOST_PARTS:
        raise InputError("wiring.too_many", "parts", value=len(parts), most=MOST_PARTS)


def check_wiring(errors: ErrorCollector, wiring: Wiring) -> None:
    """Note everything wrong with names and ports."""
    if not wiring:
        errors.add("wiring.empty", "parts")
    for name in wiring:
        if name in RESERVED:
            errors.add("wiring.reserved", f"parts.{name}")
        elif not _NAME.fullmatch(name):
            errors.add("wiring.no_name", f"parts.{name}", name=name)
    stores = {f"{name}.{store}".rstrip(".") for name, each in wiring.items() for store in each.stores}
    # A store that nothing is joined to cannot change: nearly always a forgotten port.
    joined = {store for each in wiring.values() for store in each.ports.values()}
    # A misspelt port is one mistake: the store that was meant counts as joined.
    joined |= {near for name in joined - {*wiring, AMBIENT} for near in get_close_matches(name, stores, n=1)}
    met = {end: name for name, each in wiring.items() if each.kind.kind == TUBE for end in each.ports.values()}
    for name, each in wiring.items():
        for port, store in each.ports.items():
            address = f"parts.{name}.{port}"
            if each.kind.kind == TUBE and is_port(store):
                _check_met(errors, wiring, (name, port), store)
            elif met.get(f"{name}.{port}") == store:
                continue  # a tube names this port, and so may the port name the whole tube
            elif store in wiring and store not in stores:
                inner = [f"{store}.{own}" for own in wiring[store].stores]
                code = "wiring.several_stores" if inner else "wiring.no_store"
                errors.add(code, address, store=store, kind=wiring[store].kind.kind, stores=inner)
            elif store not in stores and store != AMBIENT:
                errors.add("wiring.unknown_store", address, store=store, near=NameSuggestion(store, {*stores, AMBIENT}))
        twice = _joined_twice(each.ports)
        if twice is not None:
            errors.add("wiring.joined_twice", f"parts.{name}", store=twice)
        # Closed gas that a body compresses does change.
        elif name in stores and name not in joined and not issubclass(each.kind, Passage) and each.body is None:
            errors.add("wiring.alone", f"parts.{name}")
    _check_bodies(errors, wiring)


def _check_met(errors: ErrorCollector, wiring: Wiring, place: tuple[str, str], end: str) -> None:
    """Note a port at the end of a tube that is none, or that names something else."""
    tube, side = place
    owner, _, port = end.partition(".")
    address, cell = f"parts.{tube}.{side}", wiring[tube].stores[0 if side == "from" else -1]
    if owner not in wiring or port not in wiring[owner].ports:
        ports = [f"{name}.{own}" for name, each in wiring.items() if name != tube for own in each.ports]
        errors.add("tube.no_port", address, end=end, near=NameSuggestion(end, ports))
    elif (store := wiring[owner].ports[port]) not in (tube, f"{tube}.{cell}"):
        errors.add("tube.not_met", address, end=end, tube=tube, store=store, owner=owner, port=port)


def met_at_cells(parts: Mapping[str, Part]) -> dict[str, Part]:
    """The parts of a circuit, in which each port that a tube names holds the cell at that end."""
    result = dict(parts)
    for name, part in parts.items():
        for end, cell in part.outer_ports().items():
            owner, _, port = end.partition(".")
            other = result.get(owner)
            if isinstance(other, Part) and other.ports().get(port) == name:
                result[owner] = replace(other, **{attribute(port): f"{name}.{cell}"})  # type: ignore[type-var]
    return result


def _check_bodies(errors: ErrorCollector, wiring: Wiring) -> None:
    """Note actuators that move nothing, and bodies that nothing moves."""
    bodies = {name for name, each in wiring.items() if issubclass(each.kind, Body)}
    held = {each.body for each in wiring.values()}
    held |= {near for name in held - {*wiring, None} for near in get_close_matches(str(name), bodies, n=1)}
    for name, each in wiring.items():
        if each.body is not None and each.body not in bodies:
            address = f"parts.{name}.body"
            if each.body in wiring:
                errors.add("wiring.no_body", address, body=each.body, kind=wiring[each.body].kind.kind)
            else:
                errors.add("wiring.unknown_body", address, body=each.body, near=NameSuggestion(each.body, bodies))
        elif name in bodies and name not in held:
            errors.add("wiring.unmoved", f"parts.{name}")


def _joined_twice(ports: Mapping[str, str]) -> str | None:
    """The store at both ends of a path; in a valve of three ports every path ends at the outlet, of five at a or b."""
    ends = list(ports.values())
    if outlets := [ports[name] for name in ("outlet", "a", "b") if name in ports]:
        return next((store for store in outlets if ends.count(store) > 1), None)
    return ends[0] if len(ends) > 1 and len(set(ends)) == 1 else None


def check_connections(
    errors: ErrorCollector, connections: Mapping[str, str], parts: Collection[str], inputs: Mapping[str, Input],
    signals: Collection[str],
) -> None:  # fmt: skip
    """Note connections that end nowhere, or at an input that a signal drives."""
    for target, source in connections.items():
        item = inputs.get(target)
        if item is not None and (item.by_signal or item.slope_of):
            errors.add("wiring.signal_only", f"connections.{target}")
        elif item is None:
            errors.add("wiring.no_input", f"connections.{target}", near=NameSuggestion(target, inputs))
        elif not isinstance(source, str) or source.partition(".")[0] not in parts:
            example = f"{next(iter(parts), 'part')}.pressure"
            errors.add("wiring.no_output", f"connections.{target}", source=source, example=example)
        # Which of the two should hold is for the user to say.
        elif target in signals:
            errors.add("wiring.driven_twice", f"signals.{target}", source=source)


def check_signals(
    errors: ErrorCollector, signals: Mapping[str, Signal], inputs: Mapping[str, Input], numbers: Mapping[str, float]
) -> None:
    """Note signals that drive nothing, or leave the limits of their input, of which some are numbers of its part."""
    for address, signal in signals.items():
        if address not in inputs or inputs[address].slope_of:
            errors.extend([unknown_input(address, [name for name, item in inputs.items() if not item.slope_of])])
        elif not isinstance(signal, Signal):
            errors.add("wiring.no_signal", f"signals.{address}")
        else:
            item, owner = inputs[address], address.partition(".")[0]
            low, high = (
                numbers.get(f"{owner}.{each}", math.nan) if isinstance(each, str) else each
                for each in (item.low, item.high)
            )
            if low < high:  # else the part's own numbers are wrong, and it says so
                _check_limits(errors, address, signal, low, high, item.unit)


def check_starts(
    errors: ErrorCollector, parts: Mapping[str, Part], signals: Mapping[str, Signal], section: str = ""
) -> None:
    """Note actuators that cannot be where their bodies begin."""
    for name, part in parts.items():
        body = parts.get(part.body_name() or "")
        if not isinstance(body, Body):
            continue
        signal = signals.get(f"{part.body_name()}.position")
        with errors.collecting(f"{section}{name}"):
            part.check_start(body.initial_travel() if signal is None else float(signal.table(1.0).evaluate(0.0)))


def unknown_input(address: str, known: Collection[str]) -> InputError:
    """The mistake of a signal for an input that no part has."""
    return InputError("wiring.drives_nothing", f"signals.{address}", near=NameSuggestion(address, known))


def _check_limits(
    errors: ErrorCollector, address: str, signal: Signal, lowest: float, highest: float, unit: str
) -> None:
    low, high = signal.bounds()
    # Rounding of a unit's factor is no mistake.
    slack = 1e-12 * max(abs(lowest), abs(highest)) if highest < math.inf else 0.0
    if low < lowest - slack or high > highest + slack:
        code = "wiring.signal_outside" if highest < math.inf else "wiring.signal_below"
        errors.add(
            code, f"signals.{address}", value=low if low < lowest else high, low=lowest, high=highest,
            unit=unit, is_pressure=unit == "Pa",
        )  # fmt: skip
