"""FMU in a child process, as its parent sees it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import deque
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError, PoppetError, needed
from poppet.core.number_format import printable
from poppet.cosim.archive import check_entries, open_archive
from poppet.cosim.child import FOLDER_PREFIX
from poppet.cosim.description import FmuDescription, FmuVariable, present_platform

Array = NDArray[np.float64]
LOADING_TIME = 60.0
"""Minimum time limit for loading an FMU [s]."""
_LAST_LINES, _LONGEST_LINE = 5, 300
_REVIEW = 0.1
"""Time between two checks of the time limit [s]."""


class FmuFailure(PoppetError):
    """Failure of an FMU during a run; the master converts it to the outcome of the run."""

    def __init__(self, note: Note) -> None:
        self.note = note
        super().__init__(note)

    def __str__(self) -> str:
        return str(self.note)


@dataclass(frozen=True)
class FmuSetup:
    """FMU of a run, with the values of its parameters.

    `start` contains values of parameters in the units of the FMU, by name. `time_limit` is the maximum time of one call
    [s]. If `is_sampled` is True, the FMU reads its inputs at the start of a step, and its outputs act from the end on.
    """

    name: str  # of the part
    description: FmuDescription
    start: Mapping[str, Any] = field(default_factory=dict)
    time_limit: float = 60.0
    is_sampled: bool = False
    tolerance: float | None = None


class FmuSlave:
    """FMU that runs in a child process; an error there ends the child process only.

    Use it as a context manager. Inputs and outputs are in SI units, in the order of the description.
    """

    def __init__(self, setup: FmuSetup) -> None:
        self.setup, self.name, description = setup, setup.name, setup.description
        self.can_roll_back = description.can_roll_back
        self.inputs, self.outputs = _by_type(description.inputs), _by_type(description.outputs)
        # Indices of the variables by type in the order of the description.
        self._input_order = [description.inputs.index(v) for v in self.inputs]
        self._output_order = [description.outputs.index(v) for v in self.outputs]
        self._process: subprocess.Popen[bytes] | None = None
        self._threads: list[threading.Thread] = []
        # Time of the clock at which the child process is killed, and True if that has happened.
        self._deadline, self._is_late, self._is_closed = float("inf"), False, threading.Event()
        self._log: deque[str] = deque(maxlen=_LAST_LINES)
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._time = 0.0

    def __enter__(self) -> FmuSlave:
        try:
            self._load()
        except BaseException:
            self.kill()
            raise
        return self

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        process = self._process
        if kind is None and process is not None and process.poll() is None:
            # A failure does not matter: the results are complete.
            with suppress(FmuFailure):
                self._ask({"do": "close"}, min(self.setup.time_limit, 5.0))
        self.kill()

    @property
    def process_id(self) -> int:
        """Identifier of the child process."""
        assert self._process is not None
        return self._process.pid

    def kill(self) -> None:
        """End the child process, and delete its files."""
        process, self._process = self._process, None
        self._is_closed.set()
        if process is not None:
            assert process.stdin is not None
            with suppress(OSError):  # requests that the process has not read
                process.stdin.close()
            try:
                process.wait(timeout=0.5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            _kill_group(process)
            for thread in self._threads:
                thread.join(timeout=1.0)
            assert process.stdout is not None
            process.stdout.close()
            # A program outside the group that the FMU has started can hold the other end, for which `close` would wait.
            if process.stderr is not None and not (self._threads and self._threads[0].is_alive()):
                process.stderr.close()
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None

    def _load(self) -> None:
        """Unpack the FMU, start the child process, and load the FMU in it."""
        description, setup = self.setup.description, self.setup
        with needed("FMPy", "running an FMU", "cosim"):
            import fmpy  # noqa: F401 - the child process imports it again
        # Ignored errors: Windows can lock the library of a killed process for some time.
        self._folder = tempfile.TemporaryDirectory(prefix=FOLDER_PREFIX, ignore_cleanup_errors=True)
        folder = Path(self._folder.name)
        with open_archive(description.path) as archive:
            # Again: the file can have changed since the description was read.
            check_entries(archive, description.path.name)
            archive.extractall(folder)
        library = folder / description.library
        if not library.is_file():
            raise InputError(
                "fmu.no_binary", self.name, path=str(description.path), platform=present_platform(description.version),
                platforms=description.platforms,
            )  # fmt: skip
        (folder / "resources").mkdir(exist_ok=True)
        settings: dict[str, Any] = {"start_new_session": True} if os.name == "posix" else {"creationflags": 0x200}
        # The folder of the package: the child process must not import from the working directory.
        environment = os.environ | {"PYTHONPATH": str(Path(__file__).parents[2]), "PYTHONSAFEPATH": "1"}
        self._process = subprocess.Popen(
            [sys.executable, "-m", "poppet.cosim.child"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, env=environment, cwd=folder, **settings,
        )  # fmt: skip
        assert self._process.stdout is not None
        assert self._process.stderr is not None
        self._threads = [
            threading.Thread(target=self._collect_log, args=(self._process.stderr,), daemon=True),
            threading.Thread(target=self._watch, args=(self._process,), daemon=True),
        ]
        for thread in self._threads:
            thread.start()
        request = {
            "do": "load", "version": description.version, "token": description.token, "folder": str(folder),
            "library": str(library), "identifier": description.identifier, "name": self.name,
            "can_roll_back": description.can_roll_back, "can_interpolate": description.can_interpolate,
            "is_sampled": setup.is_sampled, "tolerance": setup.tolerance, "start": self._parameters(),
            "inputs": _groups(self.inputs), "outputs": _groups(self.outputs),
            "is_continuous": [v.is_continuous for v in self.inputs],
        }  # fmt: skip
        self._ask(request, max(setup.time_limit, LOADING_TIME), "fmu.not_loaded")

    def _parameters(self) -> list[tuple[str, list[int], list[Any]]]:
        """Return the values of parameters as groups, each with all elements of its array."""
        start, result = self.setup.start, []
        variables = self.setup.description.variables
        for name in {v.array: None for v in variables if v.name in start}:
            elements = [v for v in variables if v.array == name]
            values = [start.get(v.name, v.start if v.start is not None else 0.0) for v in elements]
            result.append((elements[0].type, [elements[0].reference], values))
        return result

    # Calls -------------------------------------------------------------------------------------------------------

    def initialise(self, u: Array, *, is_last: bool) -> Array:
        """Set the inputs at the start of the run, and return the outputs."""
        reply = self._ask({"do": "initialise", "u": self._inputs_of(u), "is_last": is_last})
        return self._outputs_of(reply.get("y"))

    def begin_step(self, begin: float, duration: float, u: Array, *, is_saved: bool, is_repeated: bool) -> None:
        """Begin a communication step, during which other FMUs can take theirs.

        `u`, (3, n), contains the inputs at the start, in the middle and at the end. If `is_repeated` is True, the step
        starts from the state that the last step with `is_saved` has saved before it.
        """
        self._time = begin
        request = {
            "do": "step", "t": begin, "h": duration, "u": [self._inputs_of(values) for values in u],
            "is_saved": is_saved, "is_repeated": is_repeated,
        }  # fmt: skip
        self._send(request)

    def end_step(self) -> tuple[Array | None, Array, float | None]:
        """Wait until the FMU has taken its step, and return the outputs in its middle and at its end.

        The outputs in the middle are None if the FMU does not interpolate its inputs. The last result is the time at
        which the FMU has ended the simulation, or None.
        """
        reply = self._receive(self.setup.time_limit)
        middle = self._outputs_of(reply["middle"]) if "middle" in reply else None
        end = reply.get("end")
        return middle, self._outputs_of(reply.get("y")), float(end) if isinstance(end, int | float) else None

    def _inputs_of(self, u: Array) -> list[float]:
        return [v.unit.from_si(float(u[k])) for k, v in zip(self._input_order, self.inputs, strict=True)]

    def _outputs_of(self, values: Any) -> Array:
        result = np.empty(len(self.outputs))
        is_list = isinstance(values, list) and len(values) == len(self.outputs)
        if not is_list or not all(isinstance(v, float) for v in values):
            raise self._failure("fmu.crashed", why="invalid reply")
        for k, v, value in zip(self._output_order, self.outputs, values, strict=True):
            result[k] = v.unit.to_si(value)
        if not np.isfinite(result).all():
            name = self.setup.description.outputs[int(np.argmin(np.isfinite(result)))].name
            raise self._failure("fmu.not_finite", variable=name)
        return result

    def _ask(self, request: Mapping[str, Any], limit: float | None = None, code: str = "fmu.failed") -> dict[str, Any]:
        """Send a request, and return the reply of the child process; an error there has the code `code`."""
        self._send(request)
        return self._receive(self.setup.time_limit if limit is None else limit, code)

    def _send(self, request: Mapping[str, Any]) -> None:
        """Send a request to the child process."""
        assert self._process is not None
        assert self._process.stdin is not None
        # A process that has stopped does not empty the pipe.
        self._deadline = time.monotonic() + self.setup.time_limit
        with suppress(OSError):  # the process has ended, which the missing reply shows
            self._process.stdin.write(json.dumps(request).encode() + b"\n")
            self._process.stdin.flush()
        self._deadline = float("inf")

    def _receive(self, limit: float, code: str = "fmu.failed") -> dict[str, Any]:
        """Return the reply of the child process to the last request, for which it has a limited time [s] from now."""
        process = self._process
        assert process is not None
        assert process.stdout is not None
        self._deadline = time.monotonic() + limit
        try:
            line = process.stdout.readline()
        except OSError:  # the process has ended
            line = b""
        self._deadline = float("inf")
        if self._is_late:
            raise self._failure("fmu.too_long", limit=limit)
        if not line:
            raise self._failure("fmu.crashed", why=self._cause())
        try:
            reply: dict[str, Any] = json.loads(line)
        except ValueError:
            raise self._failure("fmu.crashed", why="invalid reply") from None
        if "error" in reply:
            raise self._failure(code, why=printable(str(reply["error"])).removesuffix("."))
        return reply

    def _cause(self) -> str:
        """Return why the child process has ended."""
        assert self._process is not None
        try:
            status = self._process.wait(timeout=5.0)
        except subprocess.TimeoutExpired:
            return "closed output"
        if status >= 0:
            return f"exit code {status}"
        try:
            return signal.Signals(-status).name
        except ValueError:
            return f"signal {-status}"

    def _failure(self, code: str, **facts: Any) -> FmuFailure:
        if code in ("fmu.crashed", "fmu.failed", "fmu.not_loaded"):
            self._threads[0].join(timeout=0.2)
        path = self.setup.description.path.name
        return FmuFailure(Note(code, self.name, path=path, time=self._time, log=" | ".join(self._log), **facts))

    def _watch(self, process: subprocess.Popen[bytes]) -> None:
        """Kill the child process if it does not answer in time."""
        # The main thread reads the replies itself: a change of threads would take longer than many steps.
        while not self._is_closed.wait(_REVIEW):
            if time.monotonic() > self._deadline:
                self._is_late = True
                process.kill()
                _kill_group(process)
                return

    def _collect_log(self, stream: IO[bytes]) -> None:
        while line := stream.readline(65536):
            text = printable(line.decode(errors="replace").strip())[:_LONGEST_LINE]
            if text:
                self._log.append(text)


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    """Kill the programs that an FMU has started, which would keep the pipes of its process open."""
    if os.name == "posix":
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)


def _by_type(variables: tuple[FmuVariable, ...]) -> list[FmuVariable]:
    """Return variables sorted by type and reference, so that each type needs one call."""
    return sorted(variables, key=lambda v: (v.type, v.reference, v.index))


def _groups(variables: list[FmuVariable]) -> list[tuple[str, list[int], int]]:
    """Return type, references and number of values of each group of variables."""
    groups = []
    for type_, members in groupby(variables, key=lambda v: v.type):
        group = list(members)
        groups.append((type_, list(dict.fromkeys(v.reference for v in group)), len(group)))
    return groups
