"""Tasks of an editing session: their processes, results and dropped recordings."""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.files import write_whole
from poppet.edit.session import error_list
from poppet.edit.tasks.kinds import read_task

MOST = 2
"""Largest number of tasks that run at the same time."""
KEPT = 40
"""Number of tasks whose results are kept."""
MAX_UPLOAD = 64 * 2**20
"""Largest size of a dropped recording [bytes]."""
MAX_UPLOADS = 20
"""Largest number of dropped recordings; the oldest is deleted."""
PATIENCE = 2.0
"""Time in which a process can end by itself before it is killed [s]."""
_FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,119}")
_UNSAFE = re.compile(r"[^A-Za-z0-9_.-]+")
_DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


@dataclass
class Task:
    """One task: its process while it runs, and its result."""

    id: str
    task: str
    options: Mapping[str, Any]
    revision: int
    folder: Path  # of the task: its results, and the errors that its process has printed
    state: str = "running"  # running, done, failed, cancelled
    progress: float | None = None
    step: str = "start"
    done: float = 0.0
    total: float | None = None
    files: tuple[str, ...] = ()
    result: Mapping[str, Any] = field(default_factory=dict)
    errors: tuple[Mapping[str, Any], ...] = ()
    process: subprocess.Popen[bytes] | None = field(default=None, repr=False)

    @property
    def output(self) -> Path:
        """Folder of the result files."""
        return self.folder / "output"

    def content(self) -> dict[str, Any]:
        """Return the state of the task for the page."""
        names = ("id", "task", "revision", "state", "progress", "step", "done", "total", "errors")
        message = self.errors[0]["message"] if self.errors else ""
        return {
            **{name: getattr(self, name) for name in names},
            "options": dict(self.options),
            "message": message,
            "files": [f"{self.id}-{name}" for name in self.files],
            "text": "", "notes": [], "operations": [], "data": {},
            **self.result,
        }  # fmt: skip


class Tasks:
    """Tasks of an editing session.

    A task runs in a process of its own with the present text of the circuit. All files are in a temporary folder, which
    `close` deletes.
    """

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._tasks: dict[str, Task] = {}
        self._count = 0
        self._folder = Path(tempfile.mkdtemp(prefix="poppet-edit-"))
        self.uploads = self._folder / "uploads"
        self.uploads.mkdir()

    def start(self, task: Any, options: Any, *, text: str, name: str, folder: Path, revision: int = 0) -> str:
        """Start a task, and return its identifier.

        Parameters
        ----------
        task : str
            Name of the task, see `poppet.edit.tasks.kinds`.
        options : mapping
            Options of the user.
        text : str
            Present text of the circuit.
        name : str
            Name of the circuit file; empty for a new circuit.
        folder : Path
            Folder of the circuit file.
        revision : int, optional
            Revision of the text.

        Raises
        ------
        InputError
            If the task or an option is invalid, or if too many tasks run.
        """
        read_task(task, options)
        with self._lock:
            if sum(other.state == "running" for other in self._tasks.values()) >= MOST:
                raise InputError("edit.many_tasks", most=MOST)
            self._count += 1
            started = Task(str(self._count), task, options, revision, self._folder / f"task-{self._count}")
            started.output.mkdir(parents=True)
            request = {
                "task": task, "options": options, "text": text, "name": _stem(name), "folder": str(folder),
                "output": str(started.output), "uploads": str(self.uploads),
            }  # fmt: skip
            with (started.folder / "errors.txt").open("wb") as errors:
                started.process = _start_process(started.folder, errors)
            self._tasks[started.id] = started
            self._forget_oldest()
        threading.Thread(target=self._follow, args=(started, request), daemon=True).start()
        return started.id

    def contents(self) -> list[dict[str, Any]]:
        """Return the states of all tasks, the latest first."""
        with self._lock:
            return [task.content() for task in reversed(self._tasks.values())]

    def content(self, identifier: str) -> dict[str, Any]:
        """Return the state of a task."""
        with self._lock:
            return self._task(identifier).content()

    def cancel(self, identifier: str) -> dict[str, Any]:
        """Stop a task with all its processes; a task that has ended is unchanged."""
        with self._lock:
            task = self._task(identifier)
            if task.state == "running":
                task.state = "cancelled"
                _end(task)
            return task.content()

    def file(self, name: str) -> Path:
        """Return the path of a result file, whose name the state of a task contains."""
        with self._lock:
            for task in self._tasks.values():
                for file in task.files:
                    if name == f"{task.id}-{file}":
                        return task.output / file
            known = [file for task in self._tasks.values() for file in task.content()["files"]]
        raise InputError("names.unknown", name, meaning="a result of a task", suggestion=NameSuggestion(name, known))

    def keep(self, name: str, folder: Path, new_name: str = "") -> str:
        """Copy a result file into the folder of the circuit file, and return its name there.

        An existing file is never replaced.
        """
        source = self.file(name)
        target = folder / check_file_name(new_name or name.partition("-")[2])
        if target.suffix != source.suffix:
            raise InputError("edit.other_suffix", name=target.name, suffix=source.suffix)
        if target.exists() or target.is_symlink():
            raise InputError("edit.file_exists", path=target.name)
        write_whole(target, lambda stream: stream.write(source.read_bytes()))
        return target.name

    def upload(self, name: str, stream: BinaryIO, size: int) -> str:
        """Store a dropped recording, and return its name.

        Parameters
        ----------
        name : str
            Name of the file on the computer of the user; a file of the same name is replaced.
        stream : file
            Content.
        size : int
            Number of bytes to read.
        """
        if not 0 <= size <= MAX_UPLOAD:
            raise InputError("edit.large_upload", name=name, most=MAX_UPLOAD // 2**20)
        plain = re.split(r"[\\/]", name)[-1].strip()
        target = self.uploads / check_file_name(_UNSAFE.sub("_", plain)[-100:].lstrip(".-"))
        write_whole(target, lambda output: _copy(stream, output, size))
        kept = sorted(self.uploads.iterdir(), key=lambda path: path.stat().st_mtime_ns)
        for path in kept[:-MAX_UPLOADS]:
            path.unlink(missing_ok=True)
        return target.name

    def close(self) -> None:
        """Stop all tasks, and delete their files."""
        with self._lock:
            for task in self._tasks.values():
                self.cancel(task.id)
        shutil.rmtree(self._folder, ignore_errors=True)

    def _task(self, identifier: str) -> Task:
        if identifier not in self._tasks:
            near = NameSuggestion(identifier, self._tasks)
            raise InputError("names.unknown", identifier, meaning="a task", suggestion=near)
        return self._tasks[identifier]

    def _forget_oldest(self) -> None:
        ended = [task for task in self._tasks.values() if task.state != "running"]
        for task in ended[: max(len(self._tasks) - KEPT, 0)]:
            del self._tasks[task.id]
            shutil.rmtree(task.folder, ignore_errors=True)

    def _follow(self, task: Task, request: Mapping[str, Any]) -> None:
        """Send the request to the process of a task, and read its messages until it ends."""
        process = task.process
        assert process is not None
        assert process.stdin is not None
        assert process.stdout is not None
        # The process can have ended already; the standard input of a running one stays open.
        with contextlib.suppress(OSError):
            process.stdin.write(json.dumps(request).encode() + b"\n")
            process.stdin.flush()
        last: dict[str, Any] = {}
        with process.stdout:
            for line in process.stdout:
                with contextlib.suppress(ValueError):  # of a killed process
                    last = json.loads(line)
                with self._lock:
                    if task.state == "running" and "step" in last:
                        vars(task).update({key: last[key] for key in ("step", "done", "total", "progress")})
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
        _end(task)
        with self._lock:
            if task.state == "running":
                _finish(task, last)

    def __enter__(self) -> Tasks:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def check_file_name(name: str) -> str:
    """Return a file name after a check: no folder, no hidden file, no special characters, no device.

    Examples
    --------
    >>> check_file_name("plant-ensemble.csv")
    'plant-ensemble.csv'
    """
    if not isinstance(name, str) or not _FILE_NAME.fullmatch(name) or name.endswith(".") or _DEVICES.fullmatch(name):
        raise InputError("edit.file_name", name=name)
    return name


def _stem(name: str) -> str:
    """Return the beginning of the names of result files, from the name of the circuit file.

    Examples
    --------
    >>> _stem("Prüfstand 1.toml"), _stem("")
    ('Pr_fstand_1', 'circuit')
    """
    stem = _UNSAFE.sub("_", Path(name).stem).strip("._-")[:60]
    return stem if stem and not _DEVICES.fullmatch(stem) else "circuit"


def _start_process(folder: Path, errors: BinaryIO) -> subprocess.Popen[bytes]:
    """Start the process of a task, in a process group of its own."""
    package = str(Path(__file__).resolve().parents[3])
    paths = [package, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    # -P: a file such as numpy.py in the present folder must not be imported.
    return subprocess.Popen(
        [sys.executable, "-P", "-m", "poppet.edit.tasks.process"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        stderr=errors, cwd=folder, env={**os.environ, "PYTHONPATH": os.pathsep.join(map(os.path.abspath, paths))},
        start_new_session=True,
    )  # fmt: skip


def _end(task: Task) -> None:
    """End the process of a task, and the processes that it has started, such as a compiler."""
    process = task.process
    if process is None:
        return
    if os.name == "posix":
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(PATIENCE)
    with contextlib.suppress(OSError):
        if process.stdin is not None:
            process.stdin.close()


def _finish(task: Task, last: Mapping[str, Any]) -> None:
    """Set the state of a task whose process has ended, from its last message."""
    if "result" in last:
        task.state, task.progress, task.result = "done", 1.0, last["result"]
        task.files = tuple(sorted(path.name for path in task.output.iterdir() if path.is_file()))
        return
    task.state = "failed"
    if "errors" in last:
        task.errors = tuple(last["errors"])
        return
    printed = (task.folder / "errors.txt").read_text(encoding="utf-8", errors="replace").strip().splitlines()
    code = task.process.returncode if task.process is not None else None
    error = InputError("edit.task_ended", status=code, last=printed[-1][:300] if printed else "")
    task.errors = tuple(error_list(error))


def _copy(source: BinaryIO, target: Any, size: int) -> None:
    while size > 0:
        block = source.read(min(size, 2**16))
        if not block:
            raise InputError("edit.upload_ended")
        target.write(block)
        size -= len(block)
