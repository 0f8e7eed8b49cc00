"""Process of one task.

The server writes the request as one line of JSON to the standard input, which it keeps open. The process writes lines
of JSON to the standard output: progress, and at the end either the result or the errors.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any, TextIO

from poppet.core.errors import InputError, PoppetError
from poppet.core.files import confined_to
from poppet.edit.build import DURATION
from poppet.edit.document import Document
from poppet.edit.session import error_list
from poppet.edit.tasks.kinds import TASKS, read_task
from poppet.edit.tasks.order import TaskOrder, TaskResult

PERIOD = 0.1
"""Shortest time between two messages about the progress [s]."""


def run_task(request: dict[str, Any], stream: TextIO) -> None:
    """Run a task, and write its progress and its result to a stream."""
    progress = Progress(stream)
    try:
        options = read_task(request["task"], request["options"])
        folders = {name: Path(request[name]) for name in ("folder", "output", "uploads")}
        text = with_duration(request["text"])
        order = TaskOrder(text, request["name"], options=options, report=progress.report, **folders)
        # The folder of the task contains the output and temporary files.
        with confined_to(order.folder, order.output.parent, order.uploads):
            result = TASKS[request["task"]].run(order)
        write_message(stream, {"result": content_of(result)})
    except PoppetError as error:
        write_message(stream, {"errors": errors_of(error)})
    except MemoryError:
        write_message(stream, {"errors": errors_of(InputError("edit.no_memory"))})


def with_duration(text: str) -> str:
    """Return the text with the duration that the page simulates by default, if it has none.

    Examples
    --------
    >>> print(with_duration(""), end="")
    [run]
    duration = 2.0
    """
    document = Document(text)
    if document.error is not None or "duration" in document.view()["run"]:
        return text
    return document.apply([{"op": "set", "address": "run.duration", "value": DURATION}]).text


class Progress:
    """Writer of the progress of a task, which limits the number of messages."""

    def __init__(self, stream: TextIO) -> None:
        self._stream, self._step, self._last = stream, "", 0.0

    def report(self, step: str, done: float, total: float | None) -> None:
        """Write the name of a step, the completed amount of work, and the total if it is known."""
        now = time.monotonic()
        if step == self._step and now < self._last + PERIOD:
            return
        self._step, self._last = step, now
        share = min(max(done / total, 0.0), 1.0) if total else None
        write_message(self._stream, {"step": step, "done": done, "total": total, "progress": share})


def content_of(result: TaskResult) -> dict[str, Any]:
    """Return the result of a task as values of JSON."""
    return {
        "text": result.text,
        "notes": list(result.notes),
        "operations": list(result.operations),
        "data": dict(result.data),
    }


def errors_of(error: PoppetError) -> list[dict[str, Any]]:
    """Return all problems of an error as values of JSON."""
    if isinstance(error, InputError):
        return error_list(error)
    return [{"code": "", "address": "", "line": None, "message": str(error), "hint": ""}]


def write_message(stream: TextIO, message: dict[str, Any]) -> None:
    """Write one line of JSON."""
    stream.write(f"{json.dumps(message)}\n")
    stream.flush()


def main() -> None:
    """Read the request, run the task, and end."""
    # Libraries and compilers that print must not disturb the messages.
    stream = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    request = json.loads(sys.stdin.readline())
    threading.Thread(target=_end_with_server, daemon=True).start()
    if hasattr(os, "nice"):
        with contextlib.suppress(OSError):
            os.nice(5)  # the editor stays quick
    run_task(request, stream)


def _end_with_server() -> None:
    """End this process and its children when the server has ended, which closes the standard input."""
    # Not with `sys.stdin`, whose lock would abort the interpreter at its end.
    while os.read(0, 4096):
        pass
    if os.name == "posix" and os.getpgrp() == os.getpid():
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


if __name__ == "__main__":
    main()
