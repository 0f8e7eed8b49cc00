"""`poppet serve` as a process, for tests with clients that are processes too."""

from __future__ import annotations

import contextlib
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path


class ServedProcess:
    """Running process of `poppet serve`."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process, self.output = process, ""

    def modbus_port(self) -> int:
        """Wait until clients can connect, and return the port of the Modbus server."""
        assert self.process.stderr is not None
        lines: list[str] = []
        for line in self.process.stderr:
            lines.append(line)
            if match := re.search(r"Modbus: clients can connect to \S+:(\d+);", line):
                return int(match[1])
        raise AssertionError("".join(lines))

    def interrupt(self) -> int:
        """Press Ctrl-C, and return the exit code; `output` is then the standard output."""
        self.process.send_signal(signal.SIGINT)
        self.output, _ = self.process.communicate(timeout=60.0)
        return self.process.returncode


@contextlib.contextmanager
def serve_process(file: Path, *options: object) -> Iterator[ServedProcess]:
    """Start `poppet serve`, and end it at the end of the block."""
    command = [sys.executable, "-m", "poppet", "serve", str(file), *map(str, options)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        yield ServedProcess(process)
    finally:
        process.kill()
        process.wait()
        for stream in (process.stdout, process.stderr):
            if stream is not None:
                stream.close()
