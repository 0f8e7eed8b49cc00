"""The editor of `poppet edit` in a browser: its server, its page, and what an outside program does with it."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from functools import cached_property
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

PATIENCE = 60.0
"""Longest time that a server takes to start or to end [s], on a busy machine."""
FLAGS = ("--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--lang=en-US")
REFUSALS = re.compile(r"Failed to load resource: the server responded with a status of (409|422)")
"""Refused operations and stale revisions are part of the protocol; the browser reports them as errors."""


class Server:
    """A running `poppet edit`, and the address that it prints."""

    def __init__(self, folder: Path, *arguments: str) -> None:
        self.folder = folder
        self.errors_file = folder.with_name(f"{folder.name}-stderr.txt")
        command = [sys.executable, "-m", "poppet", "edit", *arguments, "--no-browser", "--port", "0"]
        with self.errors_file.open("w", encoding="utf-8") as errors:
            self.process = subprocess.Popen(
                command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors, text=True
            )
        assert self.process.stdout is not None
        printed = self.process.stdout.readline()
        match = re.search(r"http://127\.0\.0\.1:\d+/\?token=\S+", printed)
        assert match, f"{printed!r} contains no address; {self.errors()}"
        self.address = match.group()
        self.host = self.address.split("/")[2]

    def errors(self) -> str:
        """Output of the server on stderr."""
        return self.errors_file.read_text(encoding="utf-8")

    @cached_property
    def cookie(self) -> dict[str, str]:
        """Cookie that replaces the token, with which several contexts of a browser can open the page."""
        connection = HTTPConnection(self.host, timeout=PATIENCE)
        connection.request("GET", self.address.removeprefix(f"http://{self.host}"))
        name, _, rest = (connection.getresponse().getheader("Set-Cookie") or "").partition("=")
        connection.close()
        return {"name": name, "value": rest.partition(";")[0], "url": f"http://{self.host}"}

    def post(self, path: str, content: dict[str, Any]) -> int:
        """Send a request and return the status of the reply."""
        connection = HTTPConnection(self.host, timeout=PATIENCE)
        cookie = f"{self.cookie['name']}={self.cookie['value']}"
        headers = {"Content-Type": "application/json", "Cookie": cookie, "Origin": f"http://{self.host}"}
        connection.request("POST", path, json.dumps(content), headers)
        status = connection.getresponse().status
        connection.close()
        return status

    def stop(self) -> int:
        """End the server by SIGTERM and return its exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        try:
            return self.process.wait(PATIENCE)
        finally:
            self.process.kill()
            self.process.wait()
            assert self.process.stdout is not None
            self.process.stdout.close()


class Editor:
    """A page of the editor.

    Attributes
    ----------
    page : playwright.sync_api.Page
    folder : Path
        Folder in which the server runs.
    problems : list of str
        Errors of the console and of the page, and dialogs. They fail a test.
    """

    def __init__(self, server: Server, page: Any) -> None:
        self.server, self.page, self.folder = server, page, server.folder
        self.address = server.address
        self.process = server.process
        self.problems: list[str] = []
        self.waits = 0
        page.set_default_timeout(float(os.environ.get("POPPET_PATIENCE", "20")) * 1000)
        page.on("console", self._listen)
        page.on("pageerror", lambda error: self.problems.append(f"error of the page: {error}"))
        page.on("dialog", self._dismiss)

    def _listen(self, message: Any) -> None:
        if message.type == "error" and not REFUSALS.match(message.text):
            self.problems.append(f"console: {message.text} ({message.location.get('url')})")

    def _dismiss(self, dialog: Any) -> None:
        if dialog.type == "beforeunload":
            dialog.accept()
            return
        self.problems.append(f"dialog: {dialog.message}")
        dialog.dismiss()

    def open(self, address: str | None = None) -> Editor:
        """Open the page and wait until it is ready."""
        self.page.goto(address or self.address)
        self.page.wait_for_function("() => window.poppet !== undefined")
        self.wait()
        return self

    # --- window.poppet ---

    def wait(self) -> None:
        """Wait until the last edit has been simulated or refused."""
        # Chromium can report that it collected a promise for which an evaluation waits, although the page holds it.
        self.waits += 1
        self.page.evaluate("n => { window.poppet.ready.then(() => { window.settled = n; }); }", self.waits)
        settled = "n => window.settled === n"
        self.page.wait_for_function(settled, arg=self.waits, timeout=PATIENCE * 1000)

    def text(self) -> str:
        """Text of the circuit file in the page."""
        return self.page.evaluate("() => window.poppet.text()")

    def recording(self) -> dict[str, list[float]]:
        """Last run of the page, in SI units."""
        return self.page.evaluate("() => window.poppet.recording()")

    # --- elements ---

    def palette(self, kind: str) -> Any:
        """Return the button of the palette for a kind of part."""
        return self.page.locator(f'[data-kind="{kind}"]')

    def part(self, name: str) -> Any:
        """Return the element of a part in the drawing."""
        return self.page.locator(f'[data-part="{name}"]')

    def port(self, name: str) -> Any:
        """Return the element of a port, for example of `orifice.from`."""
        return self.page.locator(f'[data-port="{name}"]')

    def field(self, name: str) -> Any:
        """Return the input of a field of the selected part, for example of `orifice.critical_ratio`."""
        return self.page.locator(f'input[name="{name}"]')

    def button(self, name: str) -> Any:
        """Return a button by its name."""
        return self.page.get_by_role("button", name=name, exact=True)

    # --- actions of a user, each finished before the next one ---

    def add(self, kind: str) -> None:
        """Add a part from the palette."""
        self.palette(kind).click()
        self.wait()

    def select(self, name: str) -> None:
        """Click the centre of a part."""
        self.page.mouse.click(*self.centre(self.part(name)))

    def connect(self, start: str, end: str) -> None:
        """Click a port, then another port or a part."""
        self.page.mouse.click(*self.centre(self.port(start)))
        self.page.mouse.click(*self.centre(self.port(end) if "." in end else self.part(end)))
        self.wait()

    def drag(self, start: tuple[float, float], end: tuple[float, float], steps: int = 6) -> None:
        """Drag the mouse from one point of the page to another."""
        mouse = self.page.mouse
        mouse.move(*start)
        mouse.down()
        mouse.move(*end, steps=steps)
        mouse.up()
        self.wait()

    def type(self, field: str, value: str) -> None:
        """Enter a value of the selected part, and apply it by Enter."""
        self.field(field).fill(value)
        self.field(field).press("Enter")
        self.wait()

    def press(self, *keys: str) -> None:
        """Press keys such as `Control+z`, one after the other."""
        for key in keys:
            self.page.keyboard.press(key)
        self.wait()

    def save(self) -> None:
        """Save by the button, and wait until the file has the text of the page."""
        self.button("Save").click()
        self.wait()

    # --- geometry ---

    def box(self, element: Any) -> tuple[float, float, float, float]:
        """Return left, top, right and bottom of an element in the page."""
        box = element.bounding_box()
        assert box is not None, "the element is not displayed"
        return box["x"], box["y"], box["x"] + box["width"], box["y"] + box["height"]

    def centre(self, element: Any) -> tuple[float, float]:
        """Return the centre of an element in the page."""
        left, top, right, bottom = self.box(element)
        return (left + right) / 2.0, (top + bottom) / 2.0

    def names(self, attribute: str = "data-part") -> list[str]:
        """Return the values of an attribute of all elements that have it."""
        return self.page.eval_on_selector_all(f"[{attribute}]", f"all => all.map(e => e.getAttribute('{attribute}'))")


def wait_for_text(path: Path, expected: str) -> None:
    """Wait until a file has a text, byte for byte."""
    end = time.monotonic() + PATIENCE
    while not path.exists() or path.read_bytes() != expected.encode():
        assert time.monotonic() < end, f"{path.name} differs from the expected text"
        time.sleep(0.02)


def write_files(folder: Path, files: dict[str, str | bytes]) -> None:
    """Write files into a folder without a change of line endings."""
    for name, content in files.items():
        (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)


def overlaps(boxes: Iterable[Sequence[float]]) -> list[tuple[int, int]]:
    """Return the pairs of boxes that cover each other."""
    all_ = list(boxes)
    return [
        (i, j)
        for j, second in enumerate(all_)
        for i, first in enumerate(all_[:j])
        if first[0] < second[2] and second[0] < first[2] and first[1] < second[3] and second[1] < first[3]
    ]
