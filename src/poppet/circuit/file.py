"""Reader of circuit files.

It reports all errors of a file together, each with its line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, TypeVar

from poppet.circuit.circuit import BaseCircuit, Origin
from poppet.circuit.component_files import own_component, read_circuit_components
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.signal_tables import check_signal_table, read_signal
from poppet.circuit.wiring import (
    PartWiring,
    check_bodies,
    check_connections,
    check_count,
    check_signals,
    check_starts,
    check_wiring,
    connect_tube_cells,
    merge_connections,
    part_connections,
    unknown_input,
)
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.toml_file import TomlFile
from poppet.library.components import CatalogueComponent
from poppet.parts import KINDS, Part
from poppet.parts.fields import from_table
from poppet.parts.part import Controller, ControlOutputs, Input, PartConnection, Scope, Store, Surroundings

TOP_LEVEL = ("title", "components", "parts", "signals", "connections", "ambient", "gas", "run")
ABOVE = ("ensemble", "requirements", "audit", "modbus", "drawing")
"""Tables that the packages above read; `drawing`, the last one, contains the positions of an editor."""


CircuitT = TypeVar("CircuitT", bound=BaseCircuit)


def load(path: str | Path) -> BaseCircuit:
    """Read a circuit file.

    The public function `poppet.load` describes the argument.
    """
    return read_circuit(TomlFile.read(path, "parts"), BaseCircuit)


def loads(text: str, *, name: str = "circuit", folder: Path | None = None) -> BaseCircuit:
    """Read a circuit from text.

    The public function `poppet.loads` describes the arguments.
    """
    return read_circuit(TomlFile(text, name, folder or Path()), BaseCircuit)


def read_circuit(file: TomlFile, circuit_class: type[CircuitT]) -> CircuitT:
    """Create a circuit from a file that has been read.

    Parameters
    ----------
    file : TomlFile
        Content of a circuit file.
    circuit_class : type
        `BaseCircuit` or a subclass.

    Returns
    -------
    BaseCircuit
        Circuit of the class `circuit_class`.
    """
    with file.errors() as errors:
        data = file.content
        for key in data:
            if key not in TOP_LEVEL + ABOVE:
                errors.add(
                    "fields.unknown", key, table="circuit file", suggestion=NameSuggestion(key, TOP_LEVEL + ABOVE)
                )
        tables = {name: _table(errors, name, data.get(name, {})) for name in TOP_LEVEL[2:] if name != "gas"}
        # `gas = "nitrogen"` is short for a table with a name.
        gas_table = data.get("gas", {})
        ambient, gas, run = Ambient(), GasChoice(), Run()
        with errors.collecting("ambient"):
            ambient = from_table(Ambient, tables["ambient"])
        with errors.collecting("gas"):
            gas = from_table(GasChoice, {"name": gas_table} if isinstance(gas_table, str) else gas_table)
        with errors.collecting("run"):
            run = from_table(Run, tables["run"])
        check_count(tables["parts"])
        # Not collected: without the components of an invalid file, correct parts would have errors.
        components = read_circuit_components(data.get("components", []), file.folder)
        parts = _Parts(errors, tables["parts"], ambient, gas, file.folder, components)
        check_wiring(errors, parts.wiring)
        check_bodies(errors, parts.wiring)
        signals = parts.signals(tables["signals"])
        check_signals(errors, signals, parts.inputs, parts.numbers, parts.made)
        check_starts(errors, parts.made, signals, "parts.")
        connections = dict(_flatten(tables["connections"]))
        # An invalid part has unknown inputs and outputs: connections are checked only if all parts are valid.
        if len(parts.made) == len(tables["parts"]):
            declared = part_connections(parts.made)
            merged = merge_connections(connections, declared, parts.made, is_excerpt=False)
            check_connections(errors, merged, parts.made, parts.inputs, signals, declared)
        else:
            parts.check_stated_connections(tables["parts"], connections)
    # After the block above, which raises the collected errors.
    origin, title = Origin(data, file.folder), str(data.get("title", ""))
    try:
        return circuit_class(parts.made, signals, run, ambient, gas, title, connections, origin)
    except InputError as error:  # of the model, which the circuit checks if parts name outputs
        raise file.located(error) from None


def _table(errors: ErrorCollector, name: str, value: Any) -> Mapping[str, Any]:
    if isinstance(value, Mapping):
        return value
    errors.add("circuit.no_table", name, value=value)
    return {}


class _Parts:
    """Parts of a circuit file, with their inputs, parameters and connections.

    If a part is invalid, only its connections are read, so that the other parts can still be checked.
    """

    def __init__(
        self,
        errors: ErrorCollector,
        tables: Mapping[str, Any],
        ambient: Ambient,
        gas: GasChoice,
        folder: Path,
        components: tuple[CatalogueComponent, ...],
    ) -> None:
        self.errors, self.folder, self.components = errors, folder, components
        self.ambient_pressure, temperature = float(ambient.pressure), float(ambient.temperature)  # type: ignore[arg-type]
        surroundings = Surroundings(self.ambient_pressure, temperature, *gas.values())
        self.made: dict[str, Part] = {}
        self.inputs: dict[str, Input] = {}
        self.numbers: dict[str, float] = {}
        self.wiring: dict[str, PartWiring] = {}
        for name, table in tables.items():
            entries = table.items() if isinstance(table, Mapping) else ()
            # If the kind is invalid, all names of parts count as valid ports.
            ports = {"": name} | {key: value for key, value in entries if isinstance(value, str) and value in tables}
            self.wiring[name] = PartWiring(Store, ports, ("",))
            with errors.collecting(f"parts.{name}"):
                kind = _kind(table)
                self.wiring[name] = PartWiring.of_table(kind, table)
                part = from_table(kind, {key: self._value(key, value) for key, value in entries if key != "kind"})
                self.made[name], self.wiring[name] = part, PartWiring.of(part)
                self.inputs |= {f"{name}.{item.name}": item for item in part.inputs()}
                # Last, because a gauge value below vacuum raises an error here.
                self.numbers |= {f"{name}.{key}": value for key, value in part.parameters(surroundings).items()}

    def _value(self, key: str, value: object) -> object:
        # Paths are relative to the folder of the file, as for signals.
        if key.endswith("characteristic") and isinstance(value, str) and value.endswith(".toml"):
            return str(self.folder / value)
        if key == "path" and isinstance(value, str) and value:
            return str(self.folder / value)
        if key == "model" and isinstance(value, str) and self.components:
            return own_component(value, self.components)
        # The tables of members, such as the main stage of a valve.
        return (
            {name: self._value(name, inner) for name, inner in value.items()} if isinstance(value, Mapping) else value
        )

    def signals(self, tables: Mapping[str, Any]) -> dict[str, Any]:
        """Return a mapping from input addresses to the signals of the file."""
        signals = {}
        for address, table in _flatten(tables):
            owner = address.partition(".")[0]
            with self.errors.collecting(f"signals.{address}"):
                if address in self.inputs:
                    signals[address] = read_signal(table, self.inputs[address], self.ambient_pressure, self.folder)
                elif owner in self.wiring and owner not in self.made:  # an invalid part has unknown inputs
                    check_signal_table(table)
                else:
                    self.errors.extend([unknown_input(f"signals.{address}", self.inputs, self.made)])
        return signals

    def check_stated_connections(self, tables: Mapping[str, Any], connections: Mapping[str, str]) -> None:
        """Collect errors in the outputs that parts name, if only controllers are invalid and all ports are connected.

        `connections` are those of the file.
        """
        invalid = {name: self.wiring[name].kind for name in tables if name not in self.made}
        wrong_wiring = ErrorCollector()
        check_wiring(wrong_wiring, self.wiring)
        check_bodies(wrong_wiring, self.wiring)
        if wrong_wiring.collected or not all(issubclass(kind, Controller) for kind in invalid.values()):
            return
        from poppet.circuit.trace import SURROUNDINGS, trace

        readers: dict[str, Part] = {}
        for name, kind in invalid.items():
            # The outputs of invalid parts are not known.
            stated = {
                key: connection
                for key, connection in kind.stated_connections(tables[name]).items()
                if connection[0].source.partition(".")[0] not in invalid
            }
            if stated:
                readers[name] = _InvalidReader(stated)
        parts = {**connect_tube_cells(self.made), **readers}
        declared = {
            target: connection.source
            for target, connection in part_connections(parts).items()
            if connection.source.partition(".")[0] not in invalid
        }
        # Other connections can be wrong because of the invalid parts.
        used = {
            target: source
            for target, source in connections.items()
            if target in self.inputs and isinstance(source, str) and source.partition(".")[0] in self.made
        }
        # The model is incomplete: only errors in the names of outputs concern the file.
        with self.errors.collecting():
            trace(parts, (*self.numbers, *SURROUNDINGS), {**declared, **used})


@dataclass(frozen=True)
class _InvalidReader(Controller):
    """Placeholder of an invalid part, with the inputs that its table connects to outputs."""

    summary: ClassVar[str] = "placeholder"

    stated: Mapping[str, tuple[PartConnection, str]]

    def connections(self) -> dict[str, PartConnection]:
        return {name: connection for name, (connection, _) in self.stated.items()}

    def inputs(self) -> tuple[Input, ...]:
        return tuple(Input(name, unit, 0.0) for name, (_, unit) in self.stated.items())

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs({})


def _kind(table: Any) -> type[Part]:
    if not isinstance(table, Mapping):
        raise InputError("circuit.no_part", value=table)
    if "kind" not in table:
        raise InputError("circuit.no_kind", "kind", known=[*KINDS])
    kind = table["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise InputError(
            "fields.not_an_option",
            "kind",
            value=kind,
            meaning="kind of part",
            suggestion=NameSuggestion(str(kind), KINDS),
        )
    return KINDS[kind]


def _flatten(tables: Mapping[str, Any], prefix: str = "") -> list[tuple[str, Any]]:
    """Return pairs of input address and signal table from nested tables.

    A header without quotes, such as [signals.valve.pilot_pressure], creates nested tables. `prefix` is the beginning of
    all addresses in `tables`.
    """
    signals: list[tuple[str, Any]] = []
    for key, table in tables.items():
        # The address of an input has a dot: a table with a name without a dot contains signals.
        if isinstance(table, Mapping) and "." not in f"{prefix}{key}" and "kind" not in table:
            signals += _flatten(table, f"{key}.")
        else:
            signals.append((f"{prefix}{key}", table))
    return signals
