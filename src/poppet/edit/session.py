"""Editing session: the circuit file of the editor, its history, and its state for the page."""

from __future__ import annotations

import os
import stat
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from threading import RLock
from typing import IO, Any

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.component_files import read_circuit_components
from poppet.circuit.file import loads
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.files import by_suffix, check_characters, check_folder, confined_to, open_input, write_whole
from poppet.core.toml_file import TomlFile
from poppet.edit.document import LARGEST, MARK, Document, History
from poppet.edit.operations import free_name
from poppet.edit.palette import component_choices
from poppet.edit.part_symbols import palette_entries, symbols_of
from poppet.edit.places import places_of
from poppet.library.components import CatalogueComponent
from poppet.parts import KINDS

SUFFIX = ".toml"

EMPTY = '[run]\nduration = "2 s"\noutput_step = "5 ms"\n'
"""Text of a circuit without parts."""

UNREADABLE = b"\0"
"""Content of a file that exists, but cannot be read; no text contains it."""

State = dict[str, Any]


class Session:
    """Circuit file that is edited, with its history.

    The text in memory is separate from the file: only `save` writes to the disk, and only if the file has not changed
    since it was read or saved, or if the user has chosen to overwrite it. All files are in one folder.

    Each method takes a lock, so that requests of several pages cannot interfere.

    Parameters
    ----------
    path : Path
        Circuit file, which does not have to exist, or a folder, in which an empty circuit without a name is edited.
    templates : mapping, optional
        Templates of circuit files by name.
    """

    def __init__(self, path: Path, templates: Mapping[str, Path] | None = None) -> None:
        self.lock = RLock()
        self.templates = dict(templates or {})
        is_folder = path.is_dir()
        if not is_folder:
            check_folder(path, path.parent)
            by_suffix(path, {SUFFIX: None})
        self.folder = Path(os.path.realpath(path if is_folder else path.parent))
        self.name: str | None = None
        self.history = History(EMPTY)
        self._first = EMPTY  # text without a file
        self._opened = 0  # revision at which the circuit was opened
        self._disk: bytes | None = None  # content of the file when it was read or saved
        self._content_of: tuple[int, State, BaseCircuit | InputError] | None = None
        self._places_of: tuple[Any, State] | None = None
        if not is_folder:
            self._open_file(path.name, is_new=True)

    # --- State ---

    @property
    def document(self) -> Document:
        """Present document."""
        return self.history.document

    def circuit(self) -> BaseCircuit:
        """Return the circuit of the present text; an invalid text raises its errors."""
        with self.lock:
            _, circuit = self._content()
        if isinstance(circuit, InputError):
            raise circuit
        return circuit

    def state(self, created: list[str] | None = None) -> State:
        """Return all that the page shows: the text, its content, places, errors, and the state of the file."""
        with self.lock:
            return {
                "revision": self.history.revision,
                "opened": self._opened,
                "name": self.name,
                "folder": self.folder.name,
                "dirty": self.is_changed,
                "can_undo": self.history.can_undo,
                "can_redo": self.history.can_redo,
                "changed_on_disk": self.is_changed_on_disk,
                "created": created or [],
                **self._content()[0],
            }

    def status(self) -> State:
        """Return the revision, and whether another program has changed the file."""
        with self.lock:
            return {"revision": self.history.revision, "changed_on_disk": self.is_changed_on_disk}

    @property
    def is_changed(self) -> bool:
        """True if the text differs from the file, or from its first text if it has no file."""
        return self.document.text != (self._first if self._disk is None else self._disk.decode("utf-8"))

    @property
    def is_changed_on_disk(self) -> bool:
        """True if the file differs from the content that was read or saved."""
        return self.name is not None and self._present(self.name) != self._disk

    def _content(self) -> tuple[State, BaseCircuit | InputError]:
        """Return the content of the present text, and its circuit or its errors."""
        if self._content_of is None or self._content_of[0] != self.history.revision:
            with confined_to(self.folder):
                circuit = self._unmoved() or self._read_circuit()
                self._content_of = self.history.revision, self._shown(circuit), circuit
        return self._content_of[1:]

    def _read_circuit(self) -> BaseCircuit | InputError:
        try:
            # Without a name: the errors of this text have no file.
            return loads(self.document.text.removeprefix(MARK), name="", folder=self.folder)
        except InputError as error:
            return error

    def _unmoved(self) -> BaseCircuit | None:
        """Return the circuit that was read last, if only the drawing has changed since."""
        if self._content_of is None or self.document.error is not None:
            return None
        former = self._content_of[2]
        if isinstance(former, InputError):  # whose lines may have changed
            return None
        tables = [{**content, "drawing": None} for content in (former.origin.tables, self.document.content)]
        return former if tables[0] == tables[1] else None

    def _shown(self, circuit: BaseCircuit | InputError) -> State:
        view = self.document.view()
        state: State = {
            "text": self.document.text,
            "view": view,
            "places": {},
            "symbols": {},
            "models": {},
            "notes": [],
        }
        state["errors"] = error_list(circuit) if isinstance(circuit, InputError) else self._modbus_errors(circuit)
        if "error" in view:
            state["errors"][0]["line"] = view["error"]["line"]
            return state
        content = self.document.content
        components: tuple[CatalogueComponent, ...] = ()
        with suppress(InputError):  # which `errors` contains
            components = read_circuit_components(content.get("components", ()), self.folder)
        state["symbols"] = symbols_of(content, components)
        state["models"] = _models(components)
        state["places"] = self._places(view, _sizes(view, state["symbols"]))
        return state

    def _modbus_errors(self, circuit: BaseCircuit) -> list[dict[str, Any]]:
        """Return the errors of the table `[modbus]` for the page; they do not concern runs and tasks."""
        if "modbus" not in circuit.origin.tables:
            return []
        from poppet.serve.modbus_map import map_of_circuit
        from poppet.serve.points import ServedCircuit

        try:
            map_of_circuit(ServedCircuit.of(circuit, allow_native=True))  # executes nothing
        except InputError as error:
            rows = error_list(TomlFile(self.document.text.removeprefix(MARK), "").located(error))
            # The page receives errors of the equations with the model.
            return [{**row, "concerns_run": False} for row in rows if row["address"].startswith("modbus")]
        return []

    def _places(self, view: State, sizes: Mapping[str, tuple[float, float]]) -> State:
        """Return the places of the parts, which depend on their wiring, but not on their values."""
        wiring = {name: (part["kind"], part["ports"]) for name, part in view["parts"].items()}
        key = (wiring, view["connections"], view["drawing"], sizes)
        if self._places_of is None or self._places_of[0] != key:
            self._places_of = key, places_of(view, sizes)
        return self._places_of[1]

    # --- Changes ---

    def apply(self, revision: int, operations: list[Any], continues: bool = False) -> State:
        """Perform operations as one change, see `poppet.edit.operations`."""
        with self.lock:
            names = self._part_names()
            self.history.apply(revision, operations, continues=continues)
            # A part with a new name is not new.
            names += [operation["name"] for operation in operations if operation["op"] == "rename"]
            return self.state([name for name in self._part_names() if name not in names])

    def replace(self, revision: int, text: str) -> State:
        """Replace the text as one change; line endings and the byte order mark are those of the present text."""
        with self.lock:
            self.history.replace(revision, with_line_endings(text, self.document.text))
            return self.state()

    def undo(self, revision: int) -> State:
        """Return to the text before the last change."""
        with self.lock:
            self.history.undo(revision)
            return self.state()

    def redo(self, revision: int) -> State:
        """Perform a change again after an undo."""
        with self.lock:
            self.history.redo(revision)
            return self.state()

    def _part_names(self) -> list[str]:
        return [] if self.document.error is not None else [*self.document.view()["parts"]]

    # --- File ---

    def save(self, revision: int, name: str | None = None, overwrite: bool = False) -> State:
        """Write the text to its file, or to a new file in the folder; a circuit without a name receives a free one.

        A file that another program has changed is overwritten only if `overwrite` is True; a new file never replaces
        another file.
        """
        with self.lock:
            self.history.check(revision)
            target = (self.name or self._free_name()) if name is None else file_name(name)
            is_new = target != self.name
            expected = None if is_new else self._disk
            data = self.document.text.encode("utf-8")
            self._write(target, data, expected, is_new=is_new, overwrite=overwrite and not is_new)
            self.name, self._disk = target, data
            return self.state()

    def reload(self, revision: int) -> State:
        """Take the text of the file as a change, which can be undone."""
        with self.lock:
            self.history.check(revision)
            if self.name is None:
                raise InputError("edit.no_name")
            data = self._read(self.name)
            self.history.replace(revision, _decoded(data, self.name))
            self._disk = data
            return self.state()

    def open(
        self, template: str | None = None, file: str | None = None, empty: bool = False, discard: bool = False
    ) -> State:
        """Open a template, a file of the folder or an empty circuit; unsaved changes are lost only on request."""
        with self.lock:
            if self.is_changed and not discard:
                raise InputError("edit.unsaved")
            if file is not None:
                self._open_file(file)
            elif template is not None:
                if template not in self.templates:
                    suggestion = NameSuggestion(template, self.templates)
                    raise InputError(
                        "fields.not_an_option", "template", value=template, meaning="template", suggestion=suggestion
                    )
                self._begin(None, None, self.templates[template].read_text(encoding="utf-8"))
            else:
                self._begin(None, None, EMPTY)
            return self.state()

    def start(self) -> State:
        """Return the templates, and the circuit files of the folder, the latest first."""
        files = []
        for path in self.folder.glob(f"*{SUFFIX}"):
            with suppress(InputError, OSError, tomllib.TOMLDecodeError):
                content = tomllib.loads(_decoded(self._read(path.name), path.name).removeprefix(MARK))
                if "parts" in content:
                    modified = path.stat().st_mtime
                    files.append({"name": path.name, "title": str(content.get("title", "")), "modified": modified})
        return {
            "templates": [_template(name, path) for name, path in self.templates.items()],
            "files": sorted(files, key=lambda item: -float(str(item["modified"]))),
        }

    def _free_name(self) -> str:
        return free_name("circuit", {path.stem for path in self.folder.iterdir()}) + SUFFIX

    def _open_file(self, name: str, *, is_new: bool = False) -> None:
        """Open a file of the folder; with `is_new`, a missing file is an empty circuit."""
        name = file_name(name)
        if is_new and not (self.folder / name).exists():
            self._begin(name, None, EMPTY)
            return
        data = self._read(name)
        self._begin(name, data, _decoded(data, name))

    def _begin(self, name: str | None, data: bytes | None, text: str) -> None:
        # Revisions continue, so that a change of another page cannot apply to the new text.
        self.history = History(text, self.history.revision + 1)
        self.name, self._disk, self._first, self._opened = name, data, text, self.history.revision

    def _read(self, name: str) -> bytes:
        try:
            with confined_to(self.folder), open_input(self.folder / name) as stream:
                data = stream.read(LARGEST + 1)
        except FileNotFoundError:
            suggestion = NameSuggestion(name, [path.name for path in self.folder.glob(f"*{SUFFIX}")])
            raise InputError("names.unknown", name, meaning="a file of the folder", suggestion=suggestion) from None
        except OSError as error:
            raise InputError("files.unreadable", path=name, why=error.strerror or str(error)) from None
        if len(data) > LARGEST:
            raise InputError("toml.too_large", path=name, most=LARGEST // 2**20)
        return data

    def _present(self, name: str) -> bytes | None:
        """Return the present content of a file; None if it does not exist."""
        try:
            return self._read(name)
        except InputError:
            return UNREADABLE if (self.folder / name).exists() else None

    def _write(self, name: str, data: bytes, expected: bytes | None, *, is_new: bool, overwrite: bool) -> None:
        """Write a file completely or not at all, unless another program has changed it."""
        path = self.folder / name

        def check() -> None:
            if overwrite or self._present(name) in (expected, data):
                return
            raise InputError("edit.file_exists" if is_new else "edit.changed_on_disk", path=name)

        def fill(stream: IO[bytes]) -> None:
            stream.write(data)
            stream.flush()
            with suppress(FileNotFoundError):
                _copy_access(path, stream.name)
            os.fsync(stream.fileno())
            check()  # again, directly before the new file replaces the old one

        check()
        with confined_to(self.folder):
            write_whole(path, fill)


def file_name(name: str) -> str:
    """Return the name of a circuit file in the folder, with its suffix."""
    check_characters(name)
    if not name or name.startswith(".") or "/" in name or "\\" in name or os.path.basename(name) != name:
        raise InputError("edit.no_file_name", value=name)
    return name if name.lower().endswith(SUFFIX) else f"{name}{SUFFIX}"


def error_list(error: InputError) -> list[dict[str, Any]]:
    """Return errors for the page; the messages of those of another file begin with its name and line."""
    rows = []
    for problem in error.problems:
        line = "" if problem.line is None else f":{problem.line}"
        location = f"{problem.file}{line}: " if problem.file else ""
        rows.append(
            {
                "code": problem.code,
                "address": problem.address or "",
                "line": None if problem.file else problem.line,
                "message": f"{location}{problem.given} {problem.reason}".strip(),
                "hint": problem.hint,
            }
        )
    return rows


def with_line_endings(text: str, former: str) -> str:
    """Return a new text with the byte order mark and the line endings of the former one.

    The text field of a page has line feeds only. Lines before and after the change are unchanged; the others have the
    first line ending of the former text.

    Examples
    --------
    >>> with_line_endings("a = 1\\nb = 3\\n", "a = 1\\r\\nb = 2\\r\\n")
    'a = 1\\r\\nb = 3\\r\\n'
    """
    mark = MARK if former.startswith(MARK) else ""
    text, former = text.removeprefix(MARK), former.removeprefix(MARK)
    if "\r" in text or "\r\n" not in former:
        return mark + text
    old, new = former.splitlines(keepends=True), text.splitlines(keepends=True)
    newline = "\r\n" if old[0].endswith("\r\n") else "\n"
    lines = [line.replace("\r\n", "\n") for line in old]
    shortest = min(len(lines), len(new))
    first = next((k for k in range(shortest) if lines[k] != new[k]), shortest)
    last = next((k for k in range(shortest - first) if lines[-1 - k] != new[-1 - k]), shortest - first)
    middle = [line.replace("\n", newline) for line in new[first : len(new) - last]]
    return mark + "".join([*old[:first], *middle, *old[len(old) - last :]])


def _decoded(data: bytes, name: str) -> str:
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise InputError("toml.no_text", path=name)
    return text


def _copy_access(source: Path, target: str) -> None:
    """Give a new file the owner and the permissions of the file that it replaces."""
    status = os.stat(source)
    if hasattr(os, "chown"):
        with suppress(PermissionError):  # only the superuser can give files away
            os.chown(target, status.st_uid, status.st_gid)
    os.chmod(target, stat.S_IMODE(status.st_mode))


def _template(name: str, path: Path) -> dict[str, str]:
    """Return name, title and first comment lines of a template."""
    text = path.read_text(encoding="utf-8")
    lines = [line[1:].strip() for line in text.splitlines() if line.startswith("#")]
    return {"name": name, "title": str(tomllib.loads(text).get("title", name)), "summary": lines[0] if lines else ""}


def _models(components: Sequence[CatalogueComponent]) -> dict[str, Any]:
    """Return the own components of a circuit by kind of part, as the palette has those of the library."""
    kinds = dict.fromkeys(kind for component in components for kind in component.kinds)
    return {kind: component_choices(KINDS[kind], components) for kind in kinds}


def _sizes(view: Mapping[str, Any], symbols: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """Return the sizes of the symbols, with room for names, vents and wires."""
    sizes = {}
    for name, part in view["parts"].items():
        entry = symbols.get(name) or palette_entries().get(part["kind"])
        if entry is not None:
            *_, width, height = entry["box"]
            sizes[name] = (width + 2.0, height + 4.0)
    return sizes
