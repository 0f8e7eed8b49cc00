"""Checks of the names, ports, connections and signals of a circuit.

Each check collects all errors instead of stopping at the first.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping
from dataclasses import replace
from difflib import get_close_matches
from typing import Any, NamedTuple

from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.parts.faults import Valve
from poppet.parts.fields import BodySpec, MemberSpec, PortSpec, attribute, specs
from poppet.parts.part import AMBIENT, TUBE, Body, Input, Part, PartConnection, Passage, Store, is_port
from poppet.parts.sources import Reservoir
from poppet.timeseries.segments import Signal

RESERVED = ("ambient", "gas", "run", "time", "title", "signals", "parts", "connections")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,99}")
MOST_PARTS = 5000
"""Maximum number of parts of a circuit; a thousand chambers need about a minute of preparation."""
_MAPPINGS = {
    "parts": '{"tank": Chamber(volume="10 l")}',
    "signals": '{"valve.pilot_pressure": Steps([0.0], [2e5])}',
    "connections": '{"main.pilot_pressure": "pilot.pressure"}',
}
"""Fields of a circuit that are mappings, with examples."""


class PartWiring(NamedTuple):
    """Ports, gas nodes and body of a part, for checks of the connections."""

    kind: type[Part]
    ports: Mapping[str, str]  # port to the address of the gas node
    stores: tuple[str, ...]  # local names of its gas nodes; the empty name is the part itself
    body: str | None = None  # body that it moves
    inner_bodies: tuple[str, ...] = ()  # local names of its bodies

    @classmethod
    def of(cls, part: Part) -> PartWiring:
        """Return the wiring of a valid part."""
        return cls(type(part), part.ports(), part.stores(), part.body_name(), part.inner_bodies())

    def acts_on(self, name: str) -> str | None:
        """Return the address of the body on which the part acts, or None if it acts on no body.

        `name` is the name of the part. A part with an inner body acts on this body.
        """
        return self.body or next((f"{name}.{body}" for body in self.inner_bodies), None)

    @classmethod
    def of_table(cls, kind: type[Part], table: Mapping[str, Any]) -> PartWiring:
        """Return the wiring of an invalid part from its table in the file."""
        texts = {name: value for name, value in table.items() if isinstance(value, str)}
        fields = specs(kind)
        ports = {name: texts[name] for name, spec in fields.items() if isinstance(spec, PortSpec) and name in texts}
        stores = [name for name, spec in fields.items() if isinstance(spec, MemberSpec) and spec.is_open]
        if kind.kind == TUBE:
            from poppet.parts.tube import MAX_CELLS

            stores = [str(k) for k in range(1, MAX_CELLS + 1)]
        body = next((texts.get(name) for name, spec in fields.items() if isinstance(spec, BodySpec)), None)
        return cls(kind, ports, ("",) if issubclass(kind, Store) else tuple(stores), body)


Wiring = Mapping[str, PartWiring]


def check_kinds(circuit: Any) -> None:
    """Raise InputErrors if a field of a circuit has an invalid type."""
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
    """Raise InputError if a circuit file has too many parts.

    The check takes place before the parts are created.
    """
    if isinstance(parts, Mapping) and len(parts) > MOST_PARTS:
        raise InputError("wiring.too_many", "parts", value=len(parts), most=MOST_PARTS)


def check_name(name: str) -> None:
    """Raise InputError if a text is not a valid name of a part."""
    if name in RESERVED:
        raise InputError("wiring.reserved", f"parts.{name}")
    if not _NAME.fullmatch(name):
        raise InputError("wiring.no_name", f"parts.{name}", name=name)


def check_wiring(errors: ErrorCollector, wiring: Wiring) -> None:
    """Collect errors in names of parts and in ports."""
    if not wiring:
        errors.add("wiring.empty", "parts")
    for name in wiring:
        with errors.collecting():
            check_name(name)
    stores = {f"{name}.{store}".rstrip(".") for name, part in wiring.items() for store in part.stores}
    # A gas node without connections cannot change: usually a port is missing.
    joined = {store for part in wiring.values() for store in part.ports.values()}
    # A misspelt port is one error: the similar gas node counts as connected.
    joined |= {match for name in joined - {*wiring, AMBIENT} for match in get_close_matches(name, stores, n=1)}
    tube_of_port = {end: name for name, part in wiring.items() if part.kind.kind == TUBE for end in part.ports.values()}
    for name, part in wiring.items():
        for port, store in part.ports.items():
            address = f"parts.{name}.{port}"
            if part.kind.kind == TUBE and is_port(store):
                owner, _, owner_port = store.partition(".")
                cell = part.stores[0 if port == "from" else -1]
                if owner not in wiring or owner_port not in wiring[owner].ports:
                    ports = [f"{n}.{local}" for n, other in wiring.items() if n != name for local in other.ports]
                    near = NameSuggestion(store, ports)
                    errors.add("fields.not_an_option", address, value=store, meaning="port", suggestion=near)
                elif (joint := wiring[owner].ports[owner_port]) not in (name, f"{name}.{cell}"):
                    facts = {"end": store, "tube": name, "store": joint, "owner": owner, "port": owner_port}
                    errors.add("tube.not_met", address, **facts)
            elif tube_of_port.get(f"{name}.{port}") == store:
                continue  # port and tube name each other
            elif store in wiring and store not in stores:
                members = [f"{store}.{member}" for member in wiring[store].stores]
                code = "wiring.several_stores" if members else "wiring.no_store"
                errors.add(code, address, store=store, kind=wiring[store].kind.kind, stores=members)
            elif store not in stores and store != AMBIENT:
                suggestion = NameSuggestion(store, {*stores, AMBIENT})
                errors.add("fields.not_an_option", address, value=store, meaning="gas node", suggestion=suggestion)
        # A gas node that a part joins at both ends of a flow path. All paths of a valve with three ports end at the
        # outlet, of a valve with five ports at a or b.
        ends = [store for port, store in part.ports.items() if port not in part.kind.pilot_ports]
        outlets = [part.ports[port] for port in ("outlet", "a", "b") if port in part.ports]
        ends_of_paths = outlets or (ends if len(set(ends)) == 1 else [])
        twice = next((store for store in ends_of_paths if ends.count(store) > 1), None)
        if twice is not None:
            inlets = [part.ports.get(port) for port in part.kind.inlet_ports]
            code = "wiring.equal_inlets" if inlets.count(twice) > 1 else "wiring.joined_twice"
            errors.add(code, f"parts.{name}", store=twice)
        # Enclosed gas that a body compresses changes without a connection.
        elif name in stores and name not in joined and not issubclass(part.kind, Passage) and part.body is None:
            errors.add("wiring.alone", f"parts.{name}")


def connect_tube_cells(parts: Mapping[str, Part]) -> dict[str, Part]:
    """Return all parts, in which ports that name a tube are connected to one of its end cells.

    An end cell is the first or the last cell of a tube.
    """
    result = dict(parts)
    for name, part in parts.items():
        for end, cell in part.outer_ports().items():
            owner, _, port = end.partition(".")
            neighbour = result.get(owner)
            if isinstance(neighbour, Part) and neighbour.ports().get(port) == name:
                result[owner] = replace(neighbour, **{attribute(port): f"{name}.{cell}"})  # type: ignore[type-var]
    return result


def check_bodies(errors: ErrorCollector, wiring: Wiring) -> None:
    """Collect an error for each actuator without a body and each body without an actuator."""
    bodies = {name for name, part in wiring.items() if issubclass(part.kind, Body)}
    driven = {part.body for part in wiring.values()}
    driven |= {match for name in driven - {*wiring, None} for match in get_close_matches(str(name), bodies, n=1)}
    for name, part in wiring.items():
        if part.body is not None and part.body not in bodies:
            address = f"parts.{name}.body"
            if part.body in wiring:
                errors.add("wiring.no_body", address, body=part.body, kind=wiring[part.body].kind.kind)
            else:
                suggestion = NameSuggestion(part.body, bodies)
                errors.add("fields.not_an_option", address, value=part.body, meaning="body", suggestion=suggestion)
        elif name in bodies and name not in driven:
            errors.add("wiring.unmoved", f"parts.{name}")


def part_connections(parts: Mapping[str, Part]) -> dict[str, PartConnection]:
    """Return the connections that the parts of a circuit declare themselves, by the address of the input.

    The places in the result are complete addresses in the circuit.
    """
    return {
        f"{name}.{local}": replace(connection, place=f"parts.{name}.{connection.place}")
        for name, part in parts.items()
        for local, connection in part.connections().items()
    }


def merge_connections(
    connections: Mapping[str, str], declared: Mapping[str, PartConnection], parts: Collection[str], *, is_excerpt: bool
) -> dict[str, str]:
    """Return the connections of a circuit, together with the connections that its parts declare.

    `declared` is the result of `part_connections`. In an excerpt of a circuit, declared connections from absent parts
    are omitted.
    """
    sources = {
        target: connection.source
        for target, connection in declared.items()
        if not is_excerpt or connection.source.partition(".")[0] in parts
    }
    return {**sources, **connections}


def find_drives(wiring: Wiring, connections: Mapping[str, str], inputs: Mapping[str, Input]) -> dict[str, list[str]]:
    """Return the addresses of the inputs that can move each body, by body.

    The effect of an input continues through connections, through gas nodes at the ports of parts, and through
    actuators. A part has no effect on its supply and its pilot ports, nor on a reservoir, whose pressure is prescribed.
    It does not continue through a sequence or a switch, whose outputs are commands of their own.
    """
    successors: dict[str, set[str]] = {name: set() for name in wiring}
    for target, source in connections.items():
        ends = source.partition(".")[0], target.partition(".")[0]
        if not any(wiring[end].kind.is_switching for end in ends):
            successors[ends[0]].add(ends[1])
    for name, part in wiring.items():
        nodes = {port: node.partition(".")[0] for port, node in part.ports.items() if node != AMBIENT}
        for port, node in nodes.items():
            successors[node].add(name)
            if port not in ("supply", *part.kind.pilot_ports) and wiring[node].kind is not Reservoir:
                successors[name].add(node)
        if part.body is not None:
            successors[name].add(part.body)
    drives: dict[str, list[str]] = {name: [] for name, part in wiring.items() if issubclass(part.kind, Body)}
    drives |= {f"{name}.{body}": [] for name, part in wiring.items() for body in part.inner_bodies}
    for address in inputs:
        reached = {address.partition(".")[0]}
        while added := {after for name in reached for after in successors[name]} - reached:
            reached |= added
        for body in drives:
            if body.partition(".")[0] in reached:
                drives[body].append(address)
    return drives


def check_connections(
    errors: ErrorCollector, connections: Mapping[str, str], parts: Mapping[str, Part], inputs: Mapping[str, Input],
    signals: Collection[str], declared: Mapping[str, PartConnection],
) -> None:  # fmt: skip
    """Collect errors of connections.

    The errors are unknown inputs or outputs, and inputs with both a connection and a signal. `declared` contains the
    connections that the parts declare.
    """
    for target, source in connections.items():
        item = inputs.get(target)
        if target in declared:
            own = declared[target]
            if own.source != source:
                errors.add("wiring.connected_twice", f"connections.{target}", source=source, other=own.source)
                continue
            if source.partition(".")[0] not in parts:
                near = NameSuggestion(source.partition(".")[0], parts)
                errors.add("wiring.unknown_output", own.place, source=source, suggestion=near)
                continue
        if item is not None and item.is_coupled:
            errors.add("fmu.driven_output", f"connections.{target}")
        elif item is not None and (item.by_signal or item.slope_of):
            errors.add("wiring.signal_only", f"connections.{target}")
        elif item is None:
            errors.extend([unknown_input(f"connections.{target}", inputs, parts)])
        elif not isinstance(source, str) or source.partition(".")[0] not in parts:
            example = f"{next(iter(parts), 'part')}.pressure"
            errors.add("wiring.no_output", f"connections.{target}", source=source, example=example)
        # The user must choose between signal and connection.
        elif target in signals:
            errors.add("wiring.driven_twice", f"signals.{target}", source=source)


def check_signals(
    errors: ErrorCollector, signals: Mapping[str, Signal], inputs: Mapping[str, Input], numbers: Mapping[str, float],
    parts: Mapping[str, Part],
) -> None:  # fmt: skip
    """Collect errors of signals.

    The errors are unknown inputs, and signal values outside the limits of an input.
    """
    for address, signal in signals.items():
        if address not in inputs or inputs[address].slope_of:
            names = [name for name, item in inputs.items() if not item.slope_of]
            errors.extend([unknown_input(f"signals.{address}", names, parts)])
        elif not isinstance(signal, Signal):
            errors.add("wiring.no_signal", f"signals.{address}")
        elif inputs[address].is_coupled:
            errors.add("fmu.driven_output", f"signals.{address}")
        else:
            item, owner = inputs[address], address.partition(".")[0]
            # A limit can be a parameter of the part.
            lowest, highest = (
                numbers.get(f"{owner}.{limit}", math.nan) if isinstance(limit, str) else limit
                for limit in (item.low, item.high)
            )
            if not lowest < highest:  # an error of the part
                continue
            low, high = signal.bounds()
            is_bounded = highest < math.inf
            # Tolerance for the rounding of unit conversions.
            slack = 1e-12 * max(abs(lowest), abs(highest)) if is_bounded else 0.0
            if low < lowest - slack or high > highest + slack:
                errors.add(
                    "wiring.signal_outside" if is_bounded else "wiring.signal_below", f"signals.{address}",
                    value=low if low < lowest else high, low=lowest, high=highest, unit=item.unit,
                    is_pressure=item.unit == "Pa",
                )  # fmt: skip


def check_starts(
    errors: ErrorCollector, parts: Mapping[str, Part], signals: Mapping[str, Signal], section: str = ""
) -> None:
    """Collect an error for each actuator that cannot reach the initial position of its body.

    `signals` are the signals of the circuit. `section` is the beginning of the addresses in the errors.
    """
    for name, part in parts.items():
        body = parts.get(part.body_name() or "")
        if not isinstance(body, Body):
            continue
        signal = signals.get(f"{part.body_name()}.position")
        with errors.collecting(f"{section}{name}"):
            part.check_start(body.initial_travel() if signal is None else float(signal.table(1.0).evaluate(0.0)))


def unknown_input(address: str, inputs: Collection[str], parts: Mapping[str, Part]) -> InputError:
    """Return the error for a signal or a connection of an input that does not exist.

    `address` begins with the name of the table, such as `signals.valve.command`.
    """
    name = address.partition(".")[2]
    owner, _, local = name.partition(".")
    if local == "fault" and isinstance(parts.get(owner), Valve):
        return InputError("faults.no_input", address, valve=owner)
    suggestion = NameSuggestion(name, inputs)
    return InputError("names.unknown", address, meaning="an input of this circuit", suggestion=suggestion)
