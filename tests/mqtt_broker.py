"""MQTT broker mosquitto and its clients, for tests."""

from __future__ import annotations

import getpass
import json
import os
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

SEARCHED = os.pathsep.join((os.environ.get("PATH", ""), "/usr/sbin"))
MOSQUITTO = shutil.which("mosquitto", path=SEARCHED)
PUBLISH, SUBSCRIBE, PASSWORDS = (shutil.which(f"mosquitto_{name}") for name in ("pub", "sub", "passwd"))
IS_INSTALLED = None not in (MOSQUITTO, PUBLISH, SUBSCRIBE, PASSWORDS)
PATIENCE = 30.0


def free_port() -> int:
    """Return a port that no program uses."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        port: int = server.getsockname()[1]
        return port


class Broker:
    """Broker that can be stopped and started again on the same port.

    Parameters
    ----------
    folder : Path
        Folder of the configuration.
    settings : str, optional
        Further lines of the configuration.
    """

    def __init__(self, folder: Path, settings: str = "allow_anonymous true") -> None:
        self.port, self.options = free_port(), ["-h", "127.0.0.1"]
        self.options += ["-p", str(self.port)]
        self._file = folder / "mosquitto.conf"
        # Started by the administrator, mosquitto otherwise takes the rights of a user who cannot read the folder.
        self._file.write_text(f"listener {self.port} 127.0.0.1\nuser {getpass.getuser()}\n{settings}\n")
        self.process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Broker:
        return self.start()

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> Broker:
        """Start the broker, and wait until clients can connect."""
        command = [str(MOSQUITTO), "-c", str(self._file)]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            assert self.process.poll() is None, "the broker has ended"
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
            except OSError:
                time.sleep(0.02)
            else:
                return self
        raise AssertionError("the broker does not answer")

    def stop(self) -> None:
        """End the broker; its retained messages are lost."""
        if self.process is not None:
            self.process.terminate()
            self.process.wait(PATIENCE)

    def publish(self, topic: str, text: str, *more: str) -> None:
        """Publish a message with the client of the broker."""
        subprocess.run(
            [str(PUBLISH), *self.options, "-q", "1", "-t", topic, "-m", text, *more], check=True, timeout=PATIENCE
        )

    def messages(self, *topics: str, count: int, retained: bool = True, more: tuple[str, ...] = ()) -> dict[str, str]:
        """Return the next messages of topics with the client of the broker, by topic."""
        command = [str(SUBSCRIBE), *self.options, *more, "-W", str(int(PATIENCE)), "-C", str(count), "-F", "%j"]
        command += [] if retained else ["-R"]
        for topic in topics:
            command += ["-t", topic]
        result = subprocess.run(command, check=True, timeout=2 * PATIENCE, capture_output=True, text=True)
        rows = [json.loads(line) for line in result.stdout.splitlines()]
        return {row["topic"]: row["payload"] for row in rows}


class Listener:
    """Client that collects messages until it is closed."""

    def __init__(self, broker: Broker, topic: str) -> None:
        command = [str(SUBSCRIBE), *broker.options, "-W", str(int(PATIENCE)), "-F", "%j", "-q", "1", "-t", topic]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def next(self) -> tuple[str, Any]:
        """Return topic and text of the next message; wait for it."""
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        assert line, "no message was received"
        row = json.loads(line)
        return row["topic"], row["payload"]

    def __enter__(self) -> Listener:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()
        assert self._process.stdout is not None
        self._process.stdout.close()


def until(is_reached: Any) -> Iterator[None]:
    """Yield until a condition is reached; fail after a time."""
    end = time.monotonic() + PATIENCE
    while not is_reached():
        assert time.monotonic() < end, "the condition was not reached"
        yield
