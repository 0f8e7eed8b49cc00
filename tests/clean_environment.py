"""The wheel in an environment of its own, and the commands that a new user types in an empty folder."""

from __future__ import annotations

import errno
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import time
import venv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

EXTRAS = "all"
"""Extras that README and tutorials name for a first use."""
PATIENCE = 300.0
"""Time after which a command has stalled [s]; no measure of its speed."""
_ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\][^\x07]*\x07|\x1b[=>]")


class OfflineError(Exception):
    """Failure of pip for want of a package index."""


@dataclass
class Session:
    """Command on a terminal: its exit code, and all text that it printed."""

    code: int
    text: str
    asked: list[str] = field(default_factory=list)  # prompts that were answered, in their order


@dataclass(frozen=True)
class CleanEnvironment:
    """Virtual environment with the wheel of the checkout and its extras, and nothing else."""

    folder: Path

    @property
    def bin(self) -> Path:
        """Folder of its programs."""
        return self.folder / "bin"

    @property
    def python(self) -> Path:
        """Interpreter of the environment."""
        return self.bin / "python"

    def variables(self, **more: str) -> dict[str, str]:
        """Return the variables of a new user's shell: no settings of Python, and an empty home folder."""
        home = self.folder / "home"
        home.mkdir(exist_ok=True)
        kept = {
            key: value
            for key, value in os.environ.items()
            if not key.startswith(("PYTHON", "POPPET", "PYTEST", "XDG_", "MPL", "COVERAGE", "VIRTUAL_ENV"))
        }
        path = os.pathsep.join([str(self.bin), kept.get("PATH", os.defpath)])
        return kept | {"HOME": str(home), "PATH": path, "VIRTUAL_ENV": str(self.folder)} | more

    def run(
        self, *command: str | Path, folder: Path, text: str | None = None, **variables: str
    ) -> subprocess.CompletedProcess[str]:
        """Run a command in a folder without a terminal; `text` is its standard input, which is empty by default."""
        return subprocess.run(
            [str(word) for word in command],
            cwd=folder,
            env=self.variables(**variables),
            input=text or "",
            text=True,
            encoding="utf-8",
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )

    def start(self, *command: str | Path, folder: Path, **variables: str) -> subprocess.Popen[str]:
        """Start a command that does not end by itself, such as a server; the caller terminates it."""
        return subprocess.Popen(
            [str(word) for word in command],
            cwd=folder,
            env=self.variables(**variables),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
        )

    def on_terminal(
        self, *command: str | Path, folder: Path, answers: Mapping[str, str | Sequence[str]] | None = None
    ) -> Session:
        """Run a command on a terminal of 100 columns, and answer its questions.

        `answers` maps a regular expression of a prompt to the reply, or to several replies that are given in turn. A
        question without an answer stalls the command, which raises an error with the text so far.
        """
        waiting = {prompt: [reply] if isinstance(reply, str) else [*reply] for prompt, reply in (answers or {}).items()}
        asked: list[str] = []
        process_id, terminal = pty.fork()
        if process_id == 0:  # the command
            try:
                os.chdir(folder)
                size = {"COLUMNS": "100", "LINES": "40", "TERM": "xterm-256color"}
                variables = self.variables(**size)
                program = shutil.which(str(command[0]), path=variables["PATH"]) or str(command[0])
                os.execve(program, [str(word) for word in command], variables)
            finally:
                os._exit(127)
        printed, seen, end = b"", 0, time.monotonic() + PATIENCE
        try:
            while True:
                if not select.select([terminal], [], [], max(0.0, end - time.monotonic()))[0]:
                    os.kill(process_id, 9)
                    raise AssertionError(f"no answer to:\n{_plain(printed)}")
                try:
                    part = os.read(terminal, 65536)
                except OSError as problem:  # Linux reports the end of a terminal by an error
                    if problem.errno != errno.EIO:
                        raise
                    part = b""
                if not part:
                    break
                printed += part
                fresh = _plain(printed)[seen:]
                for prompt, replies in waiting.items():
                    # A prompt is at the end of the text: the command waits there.
                    if replies and re.search(rf"(?:{prompt})[^\n]*\Z", fresh):
                        asked.append(prompt)
                        seen = len(_plain(printed))
                        os.write(terminal, replies.pop(0).encode() + b"\n")
                        break
        finally:
            _, status = os.waitpid(process_id, 0)
            os.close(terminal)
        return Session(os.waitstatus_to_exitcode(status), _plain(printed), asked)


def _plain(printed: bytes) -> str:
    return _ESCAPES.sub("", printed.decode("utf-8", errors="replace")).replace("\r\n", "\n")


def install(wheel: Path, folder: Path, extras: str = EXTRAS) -> CleanEnvironment:
    """Install a wheel with extras in a new environment; pip takes packages from its cache if it has them."""
    venv.create(folder, with_pip=False)
    environment = CleanEnvironment(folder)
    problem = _pip(environment, f"poppet[{extras}] @ {wheel.as_uri()}")
    if problem and _pip(environment, "--dry-run", "--ignore-installed", "--no-deps", "numpy"):
        raise OfflineError(problem)
    if problem:
        raise AssertionError(f"pip could not install the wheel: {problem}")
    return environment


def _pip(environment: CleanEnvironment, *arguments: str) -> str:
    """Return the last lines of a failed `pip install`, or an empty text."""
    clean = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    constraints = Path(__file__).parents[1] / "constraints.txt"
    result = subprocess.run(
        [sys.executable, "-m", "pip", "--python", str(environment.python), "install", "-q", "--retries", "1",
         "--no-compile", "--disable-pip-version-check", "-c", str(constraints), *arguments],
        env=clean, capture_output=True, text=True, check=False,
    )  # fmt: skip
    return "\n".join(result.stderr.splitlines()[-3:]) or "pip failed" if result.returncode else ""
