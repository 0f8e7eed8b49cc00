"""Requests of the page to the tasks of an editing session."""

from __future__ import annotations

import io
from http import HTTPStatus
from typing import Any

from poppet.core.errors import InputError
from poppet.edit.server import BYTES, Reply, Request, Route, Routes
from poppet.edit.session import Session
from poppet.edit.tasks.manager import MAX_UPLOAD, Tasks

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".toml": "text/plain; charset=utf-8",
    ".st": "text/plain; charset=utf-8",
    ".csv": "text/csv; charset=utf-8",
    ".zip": "application/zip",
}
"""Media types of result files; others are bytes."""
SANDBOX = (
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; "
    "style-src 'unsafe-inline'; img-src data: blob:; font-src data:; worker-src blob:; connect-src data: blob:; "
    "frame-ancestors 'none'"
)
"""Content security policy of a result page: its scripts run without access to the editor and to the network."""


def task_routes(session: Session, tasks: Tasks) -> Routes:
    """Return the routes to the tasks of a session."""

    def start(request: Request) -> Reply:
        with session.lock:
            text, folder, name = session.document.text, session.folder, session.name or ""
            revision = session.history.revision
        task, options = request.json.get("task"), request.json.get("options", {})
        identifier = tasks.start(task, options, text=text, name=name, folder=folder, revision=revision)
        return Reply.json({"id": identifier})

    def facts(_: Request) -> Reply:
        from poppet.edit.tasks.facts import task_facts  # slow to import

        return Reply.json(task_facts(session.circuit()))

    def keep(request: Request) -> Reply:
        name, new_name = _text(request, "file"), _text(request, "name")
        return Reply.json({"name": tasks.keep(name, session.folder, new_name)})

    def upload(request: Request) -> Reply:
        name = tasks.upload(request.query.get("name", ""), io.BytesIO(request.body), len(request.body))
        return Reply.json({"name": name})

    return {
        ("GET", "/tasks"): Route(lambda _: Reply.json({"tasks": tasks.contents()})),
        ("POST", "/tasks"): Route(start),
        ("GET", "/tasks/facts"): Route(facts),
        ("POST", "/tasks/keep"): Route(keep),
        ("GET", "/tasks/{id}"): Route(lambda request: Reply.json(tasks.content(request.names["id"]))),
        ("POST", "/tasks/{id}/cancel"): Route(lambda request: Reply.json(tasks.cancel(request.names["id"]))),
        ("GET", "/files/{name}"): Route(lambda request: _file(tasks, request)),
        ("POST", "/upload"): Route(upload, media_type=BYTES, largest=MAX_UPLOAD),
    }


def _file(tasks: Tasks, request: Request) -> Reply:
    """Return a result file: a page for a tab of its own with `view`, otherwise a download."""
    try:
        path = tasks.file(request.names["name"])
    except InputError:
        return Reply.refusal(HTTPStatus.NOT_FOUND)
    is_page = path.suffix == ".html" and "view" in request.query
    headers = {"Content-Security-Policy": SANDBOX}
    if not is_page:
        headers["Content-Disposition"] = f'attachment; filename="{path.name}"'
    return Reply(path.read_bytes(), TYPES.get(path.suffix, BYTES), headers=headers)


def _text(request: Request, name: str) -> str:
    value: Any = request.json.get(name, "")
    if not isinstance(value, str):
        raise InputError("edit.no_request", name, wanted="a text", value=value)
    return value
