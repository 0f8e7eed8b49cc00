"""Routes of the editor: its page, and the requests of the page to the session."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from http import HTTPStatus
from pathlib import Path
from threading import Lock
from typing import Any

from poppet.core.errors import InputError
from poppet.core.toml_file import TomlFile
from poppet.edit.palette import palette, sections, unit_table
from poppet.edit.server import BYTES, Reply, Request, Route, Routes
from poppet.edit.session import Session, State, error_list
from poppet.edit.starting_values import starting_fields
from poppet.parts import KINDS

PACKAGE = Path(__file__).parents[1]
PAGE = Path(__file__).with_name("www")
SHARED = {
    "uPlot.js": PACKAGE / "report" / "plots" / "uplot" / "uPlot.iife.min.js",
    "uPlot.css": PACKAGE / "report" / "plots" / "uplot" / "uPlot.min.css",
    "kernel.js": PACKAGE / "deploy" / "live" / "kernel.js",
}
"""Files of other packages by the name that the page uses."""
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".wasm": "application/wasm",
}
"""Media types of the files of the page; no other files are sent."""
CONFLICTS = ("edit.stale", "edit.changed_on_disk", "edit.file_exists", "edit.unsaved")
"""Codes of errors that the page resolves with the present state, which the reply contains."""

LARGEST_TABLE = 64 * 2**20
"""Maximum size of the table of a run that the page sends [byte]."""

REQUESTS: dict[str, tuple[str, dict[str, tuple[type, ...]]]] = {
    "/apply": ("apply", {"revision": (int,), "operations": (list,), "continues?": (bool,)}),
    "/text": ("replace", {"revision": (int,), "text": (str,)}),
    "/undo": ("undo", {"revision": (int,)}),
    "/redo": ("redo", {"revision": (int,)}),
    "/save": ("save", {"revision": (int,), "name?": (str, type(None)), "overwrite?": (bool,)}),
    "/reload": ("reload", {"revision": (int,)}),
    "/open": (
        "open",
        {"template?": (str, type(None)), "file?": (str, type(None)), "empty?": (bool,), "discard?": (bool,)},
    ),
}
"""Method of the session and fields of each request that changes it; a question mark ends the names of optional ones."""


_TYPE_NAMES = {int: "a number", list: "a list", str: "a text", bool: "true or false"}


def page_routes() -> Routes:
    """Return the routes of the files of the page."""
    return {
        ("GET", "/"): Route(lambda _: _file("index.html")),
        ("GET", "/www/{name}"): Route(lambda r: _file(r.names["name"])),
    }


def load_simulation() -> None:
    """Import the libraries for simulations, so that the first model needs less time."""
    import poppet.edit.build  # noqa: F401


def session_routes(session: Session) -> Routes:
    """Return the routes to the session."""
    routes = {
        ("GET", "/palette"): Route(lambda _: Reply(_palette())),
        ("GET", "/document"): Route(lambda _: Reply.json(session.state())),
        ("GET", "/status"): Route(lambda _: Reply.json(session.status())),
        ("GET", "/start"): Route(lambda _: Reply.json(session.start())),
        ("GET", "/model"): Route(_model(session)),
        ("POST", "/notes"): Route(_notes(session), media_type=BYTES, largest=LARGEST_TABLE),
    }
    for path, (method, fields) in REQUESTS.items():
        routes["POST", path] = Route(_change(session, getattr(session, method), fields))
    return routes


def _file(name: str) -> Reply:
    """Return a file of the page."""
    path = SHARED.get(name)
    # A name of the folder's own list cannot lead to another folder.
    if path is None and name in {entry.name for entry in PAGE.iterdir()}:
        path = PAGE / name
    if path is None or path.suffix not in TYPES or not path.is_file():
        return Reply.refusal(HTTPStatus.NOT_FOUND)
    return Reply(path.read_bytes(), TYPES[path.suffix])


@cache
def _palette() -> bytes:
    content = {
        "kinds": palette(),
        "units": unit_table(),
        "sections": sections(),
        "start": {kind: starting_fields(kind) for kind in KINDS},
    }
    return Reply.json(content).body


def _change(
    session: Session, change: Callable[..., State], fields: Mapping[str, tuple[type, ...]]
) -> Callable[[Request], Reply]:
    """Return the reply to a request that changes the session."""

    def reply(request: Request) -> Reply:
        values = _fields(request.json, fields)
        return _resolved(session, lambda: Reply.json(change(**values)))

    return reply


def _resolved(session: Session, function: Callable[[], Reply]) -> Reply:
    """Return the reply of a function; a conflict is replied with the present state."""
    try:
        return function()
    except InputError as error:
        if error.code not in CONFLICTS:
            raise
        content = {"code": error.code, "errors": error_list(error), "state": session.state()}
        return Reply.json(content, HTTPStatus.CONFLICT)


def _fields(content: Mapping[str, Any], fields: Mapping[str, tuple[type, ...]]) -> dict[str, Any]:
    """Return the fields of a request."""
    values = {}
    for key, types in fields.items():
        name = key.removesuffix("?")
        value = content.get(name)
        if name not in content and key != name:
            continue
        if not isinstance(value, types) or (isinstance(value, bool) and bool not in types):
            raise InputError("edit.no_request", name, wanted=_TYPE_NAMES[types[0]], value=value)
        values[name] = value
    return values


def _model(session: Session) -> Callable[[Request], Reply]:
    """Return the reply with the model of a revision, for the simulation in the page.

    The reply for a former revision is empty, and no error: while a user edits, the page often asks too late.
    """
    building = Lock()  # one build at a time: several would only be slower

    def build(query: Mapping[str, str]) -> Reply:
        with session.lock:
            if query.get("revision") != str(session.history.revision):
                return Reply(b"", BYTES, HTTPStatus.NO_CONTENT)
            circuit, text = session.circuit(), session.document.text
        from poppet.edit.build import build_payload  # slow to import

        try:
            return Reply(build_payload(circuit, query.get("key")), BYTES)
        except InputError as error:  # of the run, such as a wrong stop condition
            raise TomlFile(text, "").located(error) from None

    def reply(request: Request) -> Reply:
        with building:
            return build(request.query)

    return reply


def _notes(session: Session) -> Callable[[Request], Reply]:
    """Return the reply with the notes on a run of the page; for a former revision it is empty."""

    def reply(request: Request) -> Reply:
        with session.lock:
            if request.query.get("revision") != str(session.history.revision):
                return Reply(b"", BYTES, HTTPStatus.NO_CONTENT)
            circuit = session.circuit()
        from poppet.edit.build import page_notes  # slow to import

        return Reply.json({"notes": page_notes(circuit, request.body)})

    return reply
