"""Mistakes of names, connections and signals of a circuit, all of them at once."""

from __future__ import annotations

import re
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.ground.errors import InputError, suggestion
from poppet.parts.part import AMBIENT, Part, Passage, Store
from poppet.series.segments import Signal

RESERVED = ("ambient", "gas", "run", "time", "title", "signals", "parts", "connections")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")


def kind_mistakes(circuit: Any) -> list[InputError]:
    """What stands in a circuit's fields without being of their kind."""
    mistakes = []
    examples = {
        "parts": '{"tank": Chamber(volume="10 l")}',
        "signals": '{"valve.pilot_pressure": Steps([0.0], [2e5])}',
        "connections": '{"main.pilot_pressure": "pilot.pressure"}',
    }
    for name, example in examples.items():
        given = getattr(circuit, name)
        if not isinstance(given, Mapping):
            mistakes.append(InputError(f"{name} = {given!r}", "is not a mapping from names.", f"Write {example}."))
    for name, kind in {"run": Run, "ambient": Ambient, "gas": GasChoice}.items():
        given = getattr(circuit, name)
        if not isinstance(given, kind):
            cure = f"Write {name}={kind.__name__}(...)."
            mistakes.append(InputError(f"{name} = {given!r}", f"is not of the class {kind.__name__}.", cure))
    for name, part in circuit.parts.items() if isinstance(circuit.parts, Mapping) else ():
        if not isinstance(name, str):
            mistakes.append(InputError(f"parts: {name!r}", "is not a name of a part.", "Write it as text."))
        elif not isinstance(part, Part):
            cure = 'Make one: Chamber(volume="10 l"), say.'
            mistakes.append(InputError(f"parts.{name} = {part!r}", "is not a part.", cure, address=f"parts.{name}"))
    return mistakes


def connection_mistakes(
    connections: Mapping[str, str], parts: Mapping[str, Part], signals: Mapping[str, Signal]
) -> list[InputError]:
    """Connections that end nowhere, or at an input that a signal drives."""
    known = [f"{name}.{item.name}" for name, part in parts.items() for item in part.inputs()]
    mistakes = []
    for target, source in connections.items():
        address = f"connections.{target}"
        if target not in known:
            mistakes.append(
                InputError(address, "is no input of this circuit.", suggestion(target, known), address=address)
            )
        elif not isinstance(source, str) or source.partition(".")[0] not in parts:
            cure = f"Write the address of an output, {next(iter(parts), 'part')}.pressure, say."
            mistakes.append(InputError(f"{address} = {source!r}", "names no output.", cure, address=address))
        elif target in signals:
            reason = f"has a signal as well as the connection to {source}."
            mistakes.append(InputError(f"signals.{target}", reason, "Remove one of them.", address=f"signals.{target}"))
    return mistakes


def signal_mistakes(
    signals: Mapping[str, Signal], parts: Mapping[str, Part], ambient_pressure: float
) -> list[InputError]:
    """Signals that drive nothing, or leave the limits of their input."""
    known = {f"{name}.{item.name}": item for name, part in parts.items() for item in part.inputs()}
    mistakes = []
    for address, signal in signals.items():
        if address not in known:
            mistakes.append(unknown_input(address, known))
        elif not isinstance(signal, Signal):
            mistakes.append(InputError(f"signals.{address}", "is not a signal.", "Use one of poppet.signals."))
        else:
            item = known[address]
            part = parts[address.partition(".")[0]]
            low, high = (_limit(each, part, ambient_pressure) for each in (item.low, item.high))
            if low < high:  # else the part's own numbers are wrong, and it says so
                mistakes += _limit_mistakes(address, signal, low, high, item.unit)
    return mistakes


def _limit(given: str | float, part: Part, ambient_pressure: float) -> float:
    """A limit of an input, or the number of the part that is one."""
    return part.numbers()[given].absolute(ambient_pressure) if isinstance(given, str) else given


def unknown_input(address: str, known: Mapping[str, Any]) -> InputError:
    """The mistake of a signal for an input that no part has."""
    return InputError(
        f"signals.{address}",
        "drives no input of this circuit.",
        suggestion(address, known),
        address=f"signals.{address}",
    )


def _limit_mistakes(address: str, signal: Signal, lowest: float, highest: float, unit: str) -> list[InputError]:
    low, high = signal.bounds()
    # Rounding of a unit's factor is no mistake.
    slack = 1e-12 * max(abs(lowest), abs(highest)) if highest < float("inf") else 0.0
    if lowest - slack <= low and high <= highest + slack:
        return []
    bad = low if low < lowest else high
    limits = f"{lowest:g}" if highest == float("inf") else f"{lowest:g} ... {highest:g}"
    shown = "" if unit == "1" else f" {unit}"
    word = "below the limit" if highest == float("inf") else "outside"
    return [
        InputError(
            f"signals.{address} reaches {bad:g}{shown},",
            f"{word} {limits}{shown} of this input.",
            'Correct the signal; a gauge pressure is written "1 bar g".' if unit == "Pa" else "Correct the signal.",
            address=f"signals.{address}",
        )
    ]


Wiring = Mapping[str, tuple[type[Part], Mapping[str, str]]]
"""Name of each part to its class and to the stores at its ports."""


def wiring_mistakes(wiring: Wiring) -> list[InputError]:
    """Everything wrong with names and connections."""
    if not wiring:
        return [InputError("The circuit", "has no parts.", "Write at least a reservoir, a passage and a chamber.")]
    stores = {name for name, (kind, _) in wiring.items() if issubclass(kind, Store)}
    mistakes = [mistake for name in wiring if (mistake := _name_mistake(name))]
    joined = {store for _, ports in wiring.values() for store in ports.values()}
    # A misspelt port is one mistake: the store that was meant counts as joined.
    joined |= {near for name in joined - {*wiring, AMBIENT} for near in get_close_matches(name, stores, n=1)}
    for name, (kind, ports) in wiring.items():
        found = [_port_mistake(name, port, store, wiring, stores) for port, store in ports.items()]
        mistakes += [mistake for mistake in found if mistake]
        store_twice = _joined_twice(ports)
        if store_twice is not None:
            mistakes.append(
                InputError(
                    f"parts.{name} joins {store_twice} with itself,", "so nothing can flow.",
                    "Join two different parts.", address=f"parts.{name}",
                )
            )  # fmt: skip
        elif name in stores and name not in joined and not issubclass(kind, Passage):
            mistakes.append(
                InputError(
                    f"parts.{name}", "is not connected: no passage names it.",
                    "Join it to a passage, or remove it.", address=f"parts.{name}",
                )
            )  # fmt: skip
    return mistakes


def _joined_twice(ports: Mapping[str, str]) -> str | None:
    """The store at both ends of a path; in a valve of three ports every path ends at the outlet."""
    ends = list(ports.values())
    if "outlet" in ports:
        return ports["outlet"] if ends.count(ports["outlet"]) > 1 else None
    return ends[0] if len(ends) > 1 and len(set(ends)) == 1 else None


def _name_mistake(name: str) -> InputError | None:
    if name in RESERVED:
        return InputError(f"parts.{name}", "is a reserved name.", "Choose another name.", address=f"parts.{name}")
    if not _NAME.fullmatch(name):
        cure = "Begin with a letter; use letters, digits, _ and -."
        return InputError(f"parts.{name!r}", "is not a name of a part.", cure, address=f"parts.{name}")
    return None


def _port_mistake(name: str, port: str, store: str, wiring: Wiring, stores: set[str]) -> InputError | None:
    address = f"parts.{name}.{port}"
    if store in stores or store == AMBIENT:
        return None
    if store in wiring:
        return InputError(
            f'{address} = "{store}"', f"is of kind {wiring[store][0].kind}, which holds no gas.",
            "Join passages through a chamber; a small one will do.", address=address,
        )  # fmt: skip
    return InputError(
        f'{address} = "{store}"',
        "names no part of this circuit.",
        suggestion(store, {*stores, AMBIENT}),
        address=address,
    )
