"""Processes that perform calls: at most two at the same time, each can be killed."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import shutil
import signal
import sys
import tempfile
import traceback
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from poppet.assist.arguments import read_arguments
from poppet.assist.folder import Folder
from poppet.assist.functions import find_function, perform
from poppet.assist.limits import CALLS_PER_PROCESS, PATIENCE, PREFIX, REPLY, TIME_LIMIT, WAITING, WORKERS
from poppet.assist.replies import Json, error_rows
from poppet.core.errors import InputError, PoppetError


@dataclass
class CallProcess:
    """Process of calls, with its temporary folder."""

    process: asyncio.subprocess.Process
    folder: Path
    calls: int = 0

    @classmethod
    async def start(cls, folder: Folder) -> CallProcess:
        """Start a process in a process group and a folder of its own."""
        package = str(Path(__file__).resolve().parents[2])
        paths = [package, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
        temporary = tempfile.mkdtemp(prefix=PREFIX)
        variables = {"PYTHONPATH": os.pathsep.join(map(os.path.abspath, paths)), "TMPDIR": temporary, "TEMP": temporary}
        # -P: a file such as numpy.py in the present folder must not be imported.
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-P", "-m", "poppet.assist.worker", str(folder.path), stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE, cwd=temporary, env={**os.environ, **variables, "MPLBACKEND": "agg"},
            start_new_session=True, limit=REPLY + 2**20,
        )  # fmt: skip
        return cls(process, Path(temporary))

    async def perform(self, request: Json) -> Json:
        """Send a call, and return its reply; the reply is empty if the process has ended."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.calls += 1
        with contextlib.suppress(ConnectionError):
            self.process.stdin.write(json.dumps(request).encode() + b"\n")
            await self.process.stdin.drain()
        line = await self.process.stdout.readline()
        reply: Json = json.loads(line) if line.endswith(b"\n") else {}
        return reply

    def kill(self) -> None:
        """Kill the process with its children."""
        if os.name == "posix":
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self.process.pid, signal.SIGKILL)
        else:
            with contextlib.suppress(ProcessLookupError):
                self.process.kill()

    async def end(self) -> None:
        """Wait until the killed process has ended, and delete its folder."""
        await self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Workers:
    """Server side of all calls: quick ones run in a thread, others in processes.

    Parameters
    ----------
    folder : Folder
        Folder to which file access is confined.
    time_limit : float, optional
        Largest time of a call [s].
    """

    def __init__(self, folder: Folder, time_limit: float = TIME_LIMIT) -> None:
        self.folder, self.time_limit = folder, time_limit
        self._slots = asyncio.Semaphore(WORKERS)
        self._idle: list[CallProcess] = []
        self._busy: list[CallProcess] = []
        self._ending: set[asyncio.Task[None]] = set()
        self._waiting = 0

    async def prepare(self) -> None:
        """Start a process, so that the first call does not wait for it."""
        self._idle.append(await CallProcess.start(self.folder))

    async def call(self, name: Any, arguments: Any) -> Json:
        """Perform a call, and return `{"result": ...}` or `{"errors": [...]}`; a cancelled call ends its process."""
        try:
            return await self._perform(name, arguments)
        except PoppetError as error:
            return {"errors": error_rows(error, self.folder)}
        except Exception:  # an error of the program must not end the server
            traceback.print_exc()
            return error_reply("assist.process_ended", call=str(name)[:100])

    async def _perform(self, name: Any, arguments: Any) -> Json:
        function = find_function(name)
        checked = read_arguments(function.run, arguments)
        if function.is_quick:
            return {"result": await asyncio.to_thread(perform, self.folder, function, checked)}
        limit = min(checked.get("time_limit", TIME_LIMIT), self.time_limit)
        if function.is_partial:
            checked["time_limit"] = limit
        if self._waiting >= WAITING:
            raise InputError("assist.many_calls", most=WAITING)
        self._waiting += 1
        try:
            async with self._slots:
                request = {"call": name, "arguments": checked, "time_limit": limit}
                return await self._in_process(request, limit + PATIENCE * function.is_partial)
        finally:
            self._waiting -= 1

    async def _in_process(self, request: Json, time: float) -> Json:
        """Perform a call in a process, which ends if the call takes too long [s], fails or is cancelled."""
        worker = self._idle.pop() if self._idle else await CallProcess.start(self.folder)
        self._busy.append(worker)
        reply: Json = {}
        try:
            reply = await asyncio.wait_for(worker.perform(request), time)
        except TimeoutError:
            raise InputError("assist.time_limit", limit=request["time_limit"]) from None
        finally:
            self._busy.remove(worker)
            if reply and worker.calls < CALLS_PER_PROCESS:
                self._idle.append(worker)
            else:
                self._end(worker)
        if not reply:
            raise InputError("assist.process_ended", call=request["call"])
        return reply

    def _end(self, worker: CallProcess) -> None:
        """Kill a process, and wait for its end in a task of its own, because the present one can be cancelled."""
        worker.kill()
        task = asyncio.create_task(worker.end())
        self._ending.add(task)
        task.add_done_callback(self._ending.discard)

    async def close(self) -> None:
        """End all processes."""
        for worker in (*self._idle, *self._busy):
            self._end(worker)
        self._idle.clear()
        await asyncio.wait_for(asyncio.gather(*self._ending), PATIENCE)


def error_reply(code: str, address: str | None = None, **facts: Any) -> Json:
    """Return the reply with one error."""
    return {"errors": error_rows(InputError(code, address, **facts))}


def is_error(reply: Mapping[str, Any]) -> bool:
    """Return True if a reply contains errors."""
    return "errors" in reply
