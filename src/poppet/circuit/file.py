"""Circuit files: TOML in, circuit out, with every mistake of a file at once and the line where it stands."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import Circuit
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.signal_tables import checked_table, read_signal
from poppet.circuit.wiring import connection_mistakes, signal_mistakes, unknown_input, wiring_mistakes
from poppet.ground.errors import InputError, InputErrors, collect, suggestion
from poppet.parts import KINDS, Part
from poppet.parts.fields import PortSpec, attribute, specs, unknown_field
from poppet.parts.part import Store

TOP_LEVEL = ("title", "parts", "signals", "connections", "ambient", "gas", "run")


def load(path: str | Path) -> Circuit:
    """Read a circuit file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/circuit_file.md`.

    Returns
    -------
    Circuit
        Checked and ready to run.

    Raises
    ------
    InputErrors
        With all mistakes of the file, each with its line where it can be told.
    """
    path = Path(path)
    return loads(read_text(path), name=str(path), folder=path.parent)


def read_text(path: Path) -> str:
    """The text of a file a person should have written."""
    name = str(path)
    if "\n" in name:
        raise InputError("The text", "is no path of a file.", "Read it with poppet.circuit.file.loads(text).")
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        near = [p.name for p in path.parent.glob(f"*{path.suffix}")] if path.parent.is_dir() else []
        raise InputError(name, "does not exist.", suggestion(path.name, near) if near else "Check the path.") from None
    except OSError as error:
        raise InputError(name, f"cannot be read: {error.strerror}.", "Name a circuit file (.toml).") from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        cure = "Save it as UTF-8 if it is a circuit; `poppet new` writes one."
        raise InputError(name, "is not text in UTF-8.", cure)
    if not text.strip():
        raise InputError(name, "is empty.", "Write a circuit into it; `poppet new` writes one to start from.")
    return text


def loads(text: str, *, name: str = "circuit", folder: Path | None = None) -> Circuit:
    """Read a circuit from text."""
    try:
        return _circuit(_parsed(text), folder or Path())
    except InputError as error:
        raise located(error, text, name) from None


def located(error: InputError, text: str, name: str) -> InputError:
    """Mistakes of a circuit with the lines where they stand, in the order of the lines."""
    lines = line_numbers(text)
    found = list(getattr(error, "problems", (error,)))
    for problem in found:
        problem.located(file=name, line=nearest_line(lines, problem.address))
    found.sort(key=lambda problem: problem.line or 0)
    return found[0] if len(found) == 1 else InputErrors(found)


def _parsed(text: str) -> dict[str, Any]:
    text = text.replace("\r\n", "\n")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise InputError("The file", "nests its brackets too deep to be read.", "Close them.") from None
    except tomllib.TOMLDecodeError as error:
        raise _syntax_mistake(str(error), text) from None


def _syntax_mistake(message: str, text: str) -> InputError:
    found = re.search(r"at line (\d+)", message)
    line = int(found.group(1)) if found else None
    table = re.search(r"Cannot declare \((.*?)\) twice", message)
    if table:
        name = ".".join(re.findall(r"'([^']*)'", table.group(1)))
        problem = InputError(f"[{name}]", "stands twice: two parts of one name.", "Rename or remove one of them.")
    elif line and "Cannot overwrite a value" in message:
        key = text.splitlines()[line - 1].partition("=")[0].strip()
        problem = InputError(key, "stands twice in its table.", "Remove one of them.")
    else:
        cure = "Mend it; text values need quotes."
        if line and re.search(r"[=\[,]\s*[+-]?\d+,\d+\s*(#|$)", text.split("\n")[line - 1]):
            cure = "Write a decimal point instead of the comma."
        problem = InputError("The file", f"is not valid TOML: {message}.", cure)
    return problem.located(line=line)


def _leading_field(given: str) -> str:
    """The field that a message without an address begins with: `data` of `data = "varga2021"`."""
    found = re.match(r"([a-z_]+) = ", given)
    return found.group(1) if found else ""


class _Collector:
    """Runs readers and keeps their mistakes instead of stopping at the first."""

    def __init__(self) -> None:
        self.problems: list[InputError] = []

    def __call__(self, prefix: str, read: Callable[[], Any]) -> Any:
        try:
            return read()
        except InputError as error:
            for problem in getattr(error, "problems", (error,)):
                own = problem.address or _leading_field(problem.given)
                if prefix and not own.startswith(prefix):
                    if own and problem.given.startswith(own):
                        problem.given = f"{prefix}.{problem.given}"
                    elif not problem.given.startswith(prefix):
                        problem.given = f"{prefix}: {problem.given}"
                    own = f"{prefix}.{own}" if own else prefix
                problem.address = own or prefix
                self.problems.append(problem)
            return None


def _circuit(data: Mapping[str, Any], folder: Path) -> Circuit:
    keep = _Collector()
    for key in data:
        if key not in TOP_LEVEL:
            keep.problems.append(
                InputError(f"[{key}]", "is not a part of a circuit file.", suggestion(key, TOP_LEVEL), address=key)
            )
    tables = {
        key: _table(keep, key, data.get(key, {})) for key in ("parts", "signals", "connections", "ambient", "run")
    }
    ambient = keep("ambient", lambda: _section(Ambient, tables["ambient"])) or Ambient()
    gas = keep("gas", lambda: _section(GasChoice, _gas_table(data.get("gas", {})))) or GasChoice()
    run = keep("run", lambda: _section(Run, tables["run"])) or Run()
    parts: dict[str, Part] = {}
    wiring: dict[str, Any] = {}
    for name, table in tables["parts"].items():
        kind = keep(f"parts.{name}", lambda t=table: _kind(t))  # type: ignore[misc]
        if kind is None:
            wiring[name] = _unknown_kind(name, table, tables["parts"])
            continue
        wiring[name] = kind, _raw_ports(kind, table)
        part = keep(f"parts.{name}", lambda k=kind, t=table: _part(k, t, folder))  # type: ignore[misc]
        if part is not None:
            parts[name] = part
    complete = len(parts) == len(tables["parts"])
    if complete or wiring:
        keep.problems += wiring_mistakes(wiring)
    elif not tables["parts"]:
        keep.problems += wiring_mistakes({})
    signals = _signals(keep, tables["signals"], parts, wiring, float(ambient.pressure), folder)  # type: ignore[arg-type]
    for part_name, part in parts.items():
        circuit_values = {"ambient": ambient, "gas": gas}
        keep(f"parts.{part_name}", lambda p=part, c=circuit_values: _absolute(p, **c))  # type: ignore[misc]
    keep.problems += signal_mistakes(signals, parts, float(ambient.pressure))  # type: ignore[arg-type]
    connections = dict(_flattened(tables["connections"]))
    if complete:
        keep.problems += connection_mistakes(connections, parts, signals)
    collect(keep.problems)
    title = data.get("title", "")
    return Circuit(parts, signals, run, ambient, gas, title if isinstance(title, str) else str(title), connections)


def _absolute(part: Part, ambient: Ambient, gas: GasChoice) -> None:
    """Refer the gauge values of a part to the ambient pressure, which may show that one is impossible."""
    from poppet.parts.part import Surroundings

    part.parameters(Surroundings(float(ambient.pressure), float(ambient.temperature), *gas.values()))  # type: ignore[arg-type]


def _table(keep: _Collector, name: str, given: Any) -> Mapping[str, Any]:
    if isinstance(given, Mapping):
        return given
    keep.problems.append(
        InputError(f"{name} = {given!r}", "is not a table.", f"Write [{name}] and fields below it.", address=name)
    )
    return {}


def _gas_table(given: Any) -> Any:
    return {"name": given} if isinstance(given, str) else given


def _section(kind: Any, table: Any) -> Any:
    if not isinstance(table, Mapping):
        raise InputError(repr(table), "is not a table.", "Write it as a table of fields.")
    known = specs(kind)
    unknown = [key for key in table if key not in known]
    problems = [unknown_field(key, key, known) for key in unknown]
    try:
        made = kind(**{attribute(key): value for key, value in table.items() if key in known})
    except InputError as error:
        found = getattr(error, "problems", (error,))
        collect([*problems, *(each for each in found if not _is_misspelt(each, unknown))])
    collect(problems)
    return made


def _is_misspelt(problem: InputError, unknown: Sequence[str]) -> bool:
    """True for a missing field that was given under a name much like it: one mistake, not two."""
    name = (problem.address or "").rpartition(".")[2]
    return problem.code in ("fields.missing", "fields.missing_port") and bool(
        difflib.get_close_matches(name, unknown, n=1)
    )


def _kind(table: Any) -> type[Part]:
    if not isinstance(table, Mapping):
        raise InputError(repr(table), "is not a table.", 'Write [parts.NAME] with kind = "..." below it.')
    if "kind" not in table:
        raise InputError("kind is missing:", "nothing says what this part is.", f"Use one of: {', '.join(KINDS)}.")
    kind = table["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise InputError(f"kind = {kind!r}", "is unknown.", suggestion(str(kind), KINDS), address="kind")
    return KINDS[kind]


def _unknown_kind(name: str, table: Any, parts: Mapping[str, Any]) -> tuple[type[Part], dict[str, str]]:
    """Wiring of a part whose kind is a mistake: it may be anything, so its connections count as right."""
    given = table.items() if isinstance(table, Mapping) else ()
    return Store, {"": name} | {key: value for key, value in given if isinstance(value, str) and value in parts}


def _raw_ports(kind: type[Part], table: Mapping[str, Any]) -> dict[str, str]:
    ports = [name for name, spec in specs(kind).items() if isinstance(spec, PortSpec)]
    return {name: table[name] for name in ports if isinstance(table.get(name), str)}


def _part(kind: type[Part], table: Mapping[str, Any], folder: Path) -> Part:
    fields = {key: value for key, value in table.items() if key != "kind"}
    given = fields.get("characteristic")
    if isinstance(given, str) and given.endswith(".toml"):
        fields["characteristic"] = str(folder / given)
    part: Part = _section(kind, fields)
    return part


def _signals(
    keep: _Collector, tables: Mapping[str, Any], parts: Mapping[str, Part], wiring: Mapping[str, Any],
    ambient_pressure: float, folder: Path,
) -> dict[str, Any]:  # fmt: skip
    inputs = {f"{name}.{item.name}": item for name, part in parts.items() for item in part.inputs()}
    signals = {}
    for address, table in _flattened(tables):
        owner = address.partition(".")[0]
        if address in inputs:
            item = inputs[address]
            signal = keep(
                f"signals.{address}",
                lambda t=table, i=item: read_signal(t, i, ambient_pressure, folder),  # type: ignore[misc]
            )
            if signal is not None:
                signals[address] = signal
        elif owner in parts or owner not in wiring:
            keep.problems.append(unknown_input(address, inputs))
        else:  # The part has mistakes, so its inputs are unknown.
            keep(f"signals.{address}", lambda t=table: checked_table(t))  # type: ignore[misc]
    return signals


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


_HEADER = re.compile(r"\s*\[\[?\s*(.+?)\s*\]?\]\s*(#.*)?$")
_KEY = re.compile(r"""\s*((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=""")
_PIECE = re.compile(r""""([^"]*)"|'([^']*)'|([\w-]+)""")


def line_numbers(text: str) -> dict[str, int]:
    """Line of every table and key of a TOML text, by dotted path; arrays and inline tables count as their key."""
    lines: dict[str, int] = {}
    table = ""
    depth, quotes = 0, ""
    for number, line in enumerate(text.splitlines(), 1):
        if quotes:  # inside a text of several lines
            quotes = "" if quotes in line else quotes
            continue
        header = _HEADER.match(line) if depth == 0 else None
        key = _KEY.match(line) if depth == 0 and not header else None
        if header:
            table = _dotted(header.group(1))
            lines.setdefault(table, number)
        elif key:
            path = _dotted(key.group(1))
            lines.setdefault(f"{table}.{path}" if table else path, number)
        quotes = next((q for q in ('"""', "'''") if line.count(q) % 2), "")
        if not header and not quotes:
            bare = re.sub(r"\"[^\"]*\"|'[^']*'|#.*", "", line)
            depth = max(0, depth + bare.count("[") + bare.count("{") - bare.count("]") - bare.count("}"))
    return lines


def _dotted(text: str) -> str:
    return ".".join(a or b or c for a, b, c in _PIECE.findall(text))


def nearest_line(lines: Mapping[str, int], address: str | None) -> int | None:
    """Line of an address, or of the table around it."""
    while address:
        start = f"{address}."
        found = lines.get(address) or next((line for path, line in lines.items() if path.startswith(start)), None)
        if found:
            return found
        address = address.rpartition("[" if address.endswith("]") else ".")[0]
    return None


__all__ = ["InputErrors", "line_numbers", "load", "loads", "located", "nearest_line", "read_text"]
