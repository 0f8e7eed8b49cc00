"""Circuit files: TOML in, circuit out, with every mistake of a file at once and the line where it stands."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from poppet.circuit.circuit import BaseCircuit, Origin
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.signal_tables import checked_table, read_signal
from poppet.circuit.wiring import (
    PartWiring,
    check_connections,
    check_count,
    check_signals,
    check_starts,
    check_wiring,
    unknown_input,
)
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.toml_file import TomlFile
from poppet.parts import KINDS, Part
from poppet.parts.fields import from_table
from poppet.parts.part import Input, Store, Surroundings

TOP_LEVEL = ("title", "parts", "signals", "connections", "ambient", "gas", "run")
ABOVE = ("ensemble", "requirements")
"""Tables that a circuit hands on to the rooms above, which read them."""


CircuitT = TypeVar("CircuitT", bound=BaseCircuit)


def load(path: str | Path) -> BaseCircuit:
    """Read a circuit file; see `poppet.load`."""
    return read_circuit(TomlFile.read(path, "parts"), BaseCircuit)


def loads(text: str, *, name: str = "circuit", folder: Path | None = None) -> BaseCircuit:
    """Read a circuit from text; see `poppet.loads`."""
    return read_circuit(TomlFile(text, name, folder or Path()), BaseCircuit)


def read_circuit(file: TomlFile, circuit_class: type[CircuitT]) -> CircuitT:
    """Read a circuit of a class from a file.

    Parameters
    ----------
    file : TomlFile
        Content of a circuit file.
    circuit_class : type
        `BaseCircuit` or a subclass.

    Returns
    -------
    BaseCircuit
        Of that class.
    """
    with file.errors() as errors:
        data = file.content
        for key in data:
            if key not in TOP_LEVEL + ABOVE:
                errors.add("circuit.unknown_table", key, near=NameSuggestion(key, TOP_LEVEL + ABOVE))
        tables = {name: _table(errors, name, data.get(name, {})) for name in TOP_LEVEL[1:] if name != "gas"}
        # `gas = "nitrogen"` is short for a table with a name, so it is none of the tables above.
        gas_table = data.get("gas", {})
        ambient, gas, run = Ambient(), GasChoice(), Run()
        with errors.collecting("ambient"):
            ambient = from_table(Ambient, tables["ambient"])
        with errors.collecting("gas"):
            gas = from_table(GasChoice, {"name": gas_table} if isinstance(gas_table, str) else gas_table)
        with errors.collecting("run"):
            run = from_table(Run, tables["run"])
        check_count(tables["parts"])
        parts = _Parts(errors, tables["parts"], ambient, gas, file.folder)
        check_wiring(errors, parts.wiring)
        signals = parts.signals(tables["signals"])
        check_signals(errors, signals, parts.inputs, parts.numbers)
        check_starts(errors, parts.made, signals, "parts.")
        connections = dict(_flattened(tables["connections"]))
        # A part that could not be made has inputs and outputs that nobody knows: no second mistake for the first.
        if len(parts.made) == len(tables["parts"]):
            check_connections(errors, connections, parts.made, parts.inputs, signals)
    # Outside of the block above, which raises what it has collected: the circuit itself finds nothing new.
    origin = Origin(data, file.folder)
    return circuit_class(parts.made, signals, run, ambient, gas, str(data.get("title", "")), connections, origin)


def _table(errors: ErrorCollector, name: str, given: Any) -> Mapping[str, Any]:
    if isinstance(given, Mapping):
        return given
    errors.add("circuit.no_table", name, value=given)
    return {}


class _Parts:
    """The parts of a file as far as they can be made, and what is known of those that cannot."""

    def __init__(
        self, errors: ErrorCollector, tables: Mapping[str, Any], ambient: Ambient, gas: GasChoice, folder: Path
    ) -> None:
        self.errors, self.folder = errors, folder
        self.ambient_pressure, temperature = float(ambient.pressure), float(ambient.temperature)  # type: ignore[arg-type]
        surroundings = Surroundings(self.ambient_pressure, temperature, *gas.values())
        self.made: dict[str, Part] = {}
        self.inputs: dict[str, Input] = {}
        self.numbers: dict[str, float] = {}
        self.wiring: dict[str, PartWiring] = {}
        for name, table in tables.items():
            # Of a kind that is a mistake: it may be anything, so its connections count as right.
            given = table.items() if isinstance(table, Mapping) else ()
            anything = {"": name} | {k: v for k, v in given if isinstance(v, str) and v in tables}
            self.wiring[name] = PartWiring(Store, anything, ("",))
            with errors.collecting(f"parts.{name}"):
                kind = _kind(table)
                self.wiring[name] = PartWiring.of_table(kind, table)
                part = from_table(kind, {key: self._value(key, value) for key, value in given if key != "kind"})
                self.made[name], self.wiring[name] = part, PartWiring.of(part)
                self.inputs |= {f"{name}.{item.name}": item for item in part.inputs()}
                # Last, for a gauge value may lie below vacuum.
                self.numbers |= {f"{name}.{key}": value for key, value in part.parameters(surroundings).items()}

    def _value(self, key: str, given: Any) -> Any:
        # Relative to the file, as the paths of signals are, not to where the program runs.
        is_path = key == "characteristic" and isinstance(given, str) and given.endswith(".toml")
        return str(self.folder / given) if is_path else given

    def signals(self, tables: Mapping[str, Any]) -> dict[str, Any]:
        """Signals of the file by address."""
        signals = {}
        for address, table in _flattened(tables):
            owner = address.partition(".")[0]
            with self.errors.collecting(f"signals.{address}"):
                if address in self.inputs:
                    signals[address] = read_signal(table, self.inputs[address], self.ambient_pressure, self.folder)
                elif owner in self.wiring and owner not in self.made:  # with mistakes, so that its inputs are unknown
                    checked_table(table)
                else:
                    self.errors.extend([unknown_input(address, self.inputs)])
        return signals


def _kind(table: Any) -> type[Part]:
    if not isinstance(table, Mapping):
        raise InputError("circuit.no_part", value=table)
    if "kind" not in table:
        raise InputError("circuit.no_kind", "kind", known=[*KINDS])
    kind = table["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise InputError("circuit.unknown_kind", "kind", value=kind, near=NameSuggestion(str(kind), KINDS))
    return KINDS[kind]


def _flattened(tables: Mapping[str, Any], prefix: str = "") -> list[tuple[str, Any]]:
    """Signals by address; [signals.valve.pilot_pressure] without quotes is a nested table and means the same."""
    found: list[tuple[str, Any]] = []
    for key, table in tables.items():
        # An input's address has a dot, so a table under a name without one is not a signal yet.
        if isinstance(table, Mapping) and "." not in f"{prefix}{key}" and "kind" not in table:
            found += _flattened(table, f"{key}.")
        else:
            found.append((f"{prefix}{key}", table))
    return found
