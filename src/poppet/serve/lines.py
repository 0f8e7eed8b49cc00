"""JSON lines: commands on the standard input, replies and values on the standard output.

Each line is one JSON object. Threads read and write the lines, so a program that does not read its replies delays no
other protocol.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import sys
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, BinaryIO, TextIO

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.monitoring.stream import LONGEST_LINE, lines_of, object_of
from poppet.serve.adapters import AdapterSettings
from poppet.serve.machine import Machine
from poppet.serve.points import Point, PointRole
from poppet.serve.snapshot import Snapshot

COMMANDS = ("set", "fault", "get", "list", "stop", "id")
"""Keys of a command; `id` is repeated in the reply."""


class JsonLines:
    """Adapter of the standard input and output.

    Parameters
    ----------
    interval : float
        Time between two lines with values [s]; 0 for replies only.
    source, target : streams
        Input and output.
    """

    def __init__(self, interval: float, source: BinaryIO, target: TextIO) -> None:
        self.interval, self.source, self.target = interval, source, target
        self.n_commands, self.n_errors = 0, 0
        self._lock, self._has_ended = threading.Lock(), threading.Event()

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        # Daemons: neither a line that never comes nor a reader that never reads delays the end of the program.
        for work in (self._read, self._print_values):
            threading.Thread(target=work, args=(machine,), daemon=True).start()
        try:
            await asyncio.Event().wait()
        finally:
            self._has_ended.set()

    def summary(self) -> Sequence[Note]:
        """Return the numbers of commands and errors."""
        return [Note("serve.lines_summary", commands=self.n_commands, errors=self.n_errors)]

    def _read(self, machine: Machine) -> None:
        for line in lines_of(self.source):
            if line.strip():
                self._print(self.reply(machine, line))
            if self._has_ended.is_set():
                return

    def _print_values(self, machine: Machine) -> None:
        addresses = [point.address for point in machine.points if point.role is not PointRole.PARAMETER]
        while self.interval > 0.0 and not self._has_ended.wait(self.interval):
            snapshot = machine.snapshot()
            self._print({**status(snapshot), "values": selected(snapshot, addresses)})

    def _print(self, content: Mapping[str, Any]) -> None:
        text = json.dumps(content, allow_nan=False)
        try:
            with self._lock:
                print(text, file=self.target, flush=True)
        except (OSError, ValueError):  # the reader has closed the pipe
            self._has_ended.set()

    def reply(self, machine: Machine, line: bytes) -> dict[str, Any]:
        """Execute the commands of a line, and return the reply."""
        self.n_commands += 1
        content: Mapping[str, Any] = {}
        try:
            content = _read_line(line)
            return {**_mark(content), "ok": True, **_execute(machine, content)}
        except InputError as error:
            self.n_errors += 1
            return {**_mark(content), "ok": False, "errors": error_rows(error)}
        except Exception as error:
            # A defect: the thread must read the next line.
            self.n_errors += 1
            text = f"internal error: {type(error).__name__}: {error}. Please report it."
            return {**_mark(content), "ok": False, "errors": [{"code": "", "address": "", "message": text, "hint": ""}]}


def status(snapshot: Snapshot) -> dict[str, Any]:
    """Return time, number of the period and state of a machine as values of JSON."""
    note = {} if snapshot.note is None else {"note": str(snapshot.note), "code": snapshot.note.code}
    return {"time": snapshot.time, "period": snapshot.period, "state": snapshot.state.name.lower(), **note}


def selected(snapshot: Snapshot, addresses: Iterable[str]) -> dict[str, float | None]:
    """Return values by address; a value that is not finite is None, because JSON has no such numbers."""
    values = {address: snapshot.values[address] for address in addresses}
    return {address: value if abs(value) < float("inf") else None for address, value in values.items()}


def error_rows(error: InputError) -> list[dict[str, str]]:
    """Return all errors of an input as values of JSON."""
    return [
        {
            "code": problem.code,
            "address": problem.address or "",
            "message": f"{problem.given} {problem.reason}",
            "hint": problem.hint,
        }
        for problem in error.problems
    ]


def _read_line(line: bytes) -> Mapping[str, Any]:
    if len(line) > LONGEST_LINE:
        raise InputError("stream.long_line", most=LONGEST_LINE // 2**20)
    try:
        text = line.decode("utf-8-sig").strip()
    except UnicodeDecodeError:
        raise InputError("stream.no_text") from None
    if not text.startswith("{"):
        raise InputError("serve.no_command", commands=COMMANDS[:-1])
    return object_of(text)


def _mark(content: Mapping[str, Any]) -> dict[str, Any]:
    return {"id": content["id"]} if isinstance(content.get("id"), str | int) else {}


def _execute(machine: Machine, content: Mapping[str, Any]) -> dict[str, Any]:
    """Execute the commands of an object: none of them if one is invalid."""
    with ErrorCollector() as errors:
        for key in content:
            if key not in COMMANDS:
                suggestion = NameSuggestion(key, COMMANDS)
                errors.add("names.unknown", key, meaning="a command", suggestion=suggestion)
        if not content.keys() - {"id"}:
            errors.add("serve.no_command", commands=COMMANDS[:-1])
        for key, kind, example in (
            ("set", dict, '{"valve.command": 1}'),
            ("fault", dict, '{"valve": "stuck_open"}'),
            ("get", list, '["tank.pressure"]'),
            ("list", bool, "true"),
            ("stop", bool, "true"),
        ):
            if key in content and not isinstance(content[key], kind):
                errors.add("serve.command_type", key, value=content[key], example=example)
    addresses, values, faults = content.get("get", ()), content.get("set", {}), content.get("fault", {})
    words = {f"{valve}.fault": valve for valve in machine.faults}
    known = [*machine.served.by_address, *words]
    with ErrorCollector() as errors:
        for address in addresses:
            if address not in known:
                suggestion = NameSuggestion(str(address), known)
                errors.add("names.unknown", str(address), meaning="a point of this circuit", suggestion=suggestion)
        with errors.collecting():
            machine.check(values, faults)
    machine.command(values, faults)
    if content.get("stop"):
        machine.request_stop()
    reply: dict[str, Any] = {}
    if "get" in content:
        snapshot = machine.snapshot()
        numbers = selected(snapshot, (address for address in addresses if address not in words))
        faults_now = {address: machine.fault_of(words[address]) for address in addresses if address in words}
        reply |= {**status(snapshot), "values": {**numbers, **faults_now}}
    if content.get("list"):
        reply["points"] = [point_row(point) for point in machine.points]
        reply["faults"] = {valve: [*faults] for valve, faults in machine.faults.items()}
    return reply


def point_row(point: Point) -> dict[str, Any]:
    """Return the description of a point as values of JSON."""
    row = {"address": point.address, "unit": point.unit, "role": point.role.value, "doc": point.doc}
    limits = {"low": point.low, "high": point.high, "initial": point.initial}
    return row | {key: value for key, value in limits.items() if abs(value) < float("inf")}


def make_adapter(settings: AdapterSettings) -> JsonLines:
    """Return the adapter of the option --lines."""
    interval = float(settings.value)
    if interval < 0.0:
        raise InputError("serve.interval", "--lines", value=interval)
    source, target = sys.stdin.buffer, settings.options.stdout
    # Copies: at its end, the interpreter must not wait for a thread that reads or writes its own streams.
    with contextlib.suppress(OSError):  # a stream of a test
        source = os.fdopen(os.dup(source.fileno()), "rb")
        target = os.fdopen(os.dup(target.fileno()), "w", encoding="utf-8")
    return JsonLines(interval, source, target)
