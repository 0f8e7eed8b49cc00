"""A browser without a window, driven over its debugging pipe: what a page does when it is looked at."""

from __future__ import annotations

import fcntl
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "chrome-headless-shell")
FLAGS = (
    *("--headless", "--no-sandbox", "--no-zygote", "--disable-gpu", "--disable-dev-shm-usage"),
    *("--no-first-run", "--hide-scrollbars", "--remote-debugging-pipe", "--lang=en-US", "--use-angle=swiftshader"),
)
PATIENCE = 30.0
KEYS = {
    **{name: (code, "") for name, code in {"Tab": 9, "PageUp": 33, "PageDown": 34, "End": 35, "Home": 36}.items()},
    **{name: (code, "") for name, code in {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}.items()},
    "Backspace": (8, ""),
    "Enter": (13, "\r"),
    "Space": (32, " "),
}
"""Codes of keys, and the text that they write."""


def found() -> str | None:
    """The program that `POPPET_BROWSER` names, or one of the usual names."""
    return os.environ.get("POPPET_BROWSER") or next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One page of one browser."""

    def __init__(self, program: str) -> None:
        self.folder = tempfile.mkdtemp(prefix="poppet-browser-")
        theirs_in, ours_out = os.pipe()
        ours_in, theirs_out = os.pipe()
        high = [fcntl.fcntl(each, fcntl.F_DUPFD, 20) for each in (theirs_in, theirs_out)]

        def numbered() -> None:
            """The pipe is numbered three and four."""
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        arguments = [program, *FLAGS, f"--user-data-dir={self.folder}", "about:blank"]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        # Files of Python are closed in a child anyway; those that are numbered are not.
        self.process = subprocess.Popen(
            arguments, preexec_fn=numbered, close_fds=False, start_new_session=True, **quiet
        )
        for each in (theirs_in, theirs_out, *high):
            os.close(each)
        self.out, self.into = os.fdopen(ours_out, "wb", 0), os.fdopen(ours_in, "rb", 0)
        self.count, self.rest, self.session = 0, b"", ""
        self.events: list[dict[str, Any]] = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_: object) -> None:
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.out.close()
        self.into.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self.rest:
            more = os.read(self.into.fileno(), 1 << 20)
            assert more, "the browser has ended"
            self.rest += more
        text, _, self.rest = self.rest.partition(b"\0")
        return json.loads(text)

    def call(self, method: str, **given: Any) -> dict[str, Any]:
        """Ask the browser for something; what it tells meanwhile is kept in `events`."""
        self.count += 1
        asked: dict[str, Any] = {"id": self.count, "method": method, "params": given}
        if self.session:
            asked["sessionId"] = self.session
        self.out.write(json.dumps(asked).encode() + b"\0")
        while (told := self._next()).get("id") != self.count:
            self.events.append(told)
        assert "error" not in told, told["error"]
        return told["result"]

    def open(self, path: Path, width: int = 1000, *, media: str = "screen", scheme: str = "light") -> None:
        """Open a page; it is wide as given, printed or dark."""
        is_telephone = width < 500
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=800, deviceScaleFactor=1, mobile=is_telephone
        )
        self.call("Emulation.setTouchEmulationEnabled", enabled=is_telephone, maxTouchPoints=5)
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.call("Emulation.setEmulatedMedia", media=media, features=features)
        self.call("Page.navigate", url=path.as_uri())
        end = time.monotonic() + PATIENCE
        while self("document.readyState") != "complete" or self("location.href") != path.as_uri():
            assert time.monotonic() < end
            time.sleep(0.02)
        self.settle()

    def settle(self) -> None:
        """Wait until the page has drawn twice."""
        self("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def __call__(self, expression: str) -> Any:
        """What a JavaScript expression gives."""
        told = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in told, told["exceptionDetails"]
        return told["result"].get("value")

    def mouse(self, kind: str, x: float, y: float, *, is_down: bool = False, clicks: int = 0) -> None:
        """Move, press (`Pressed`) or let go (`Released`) the mouse."""
        button = "left" if is_down or kind != "Moved" else "none"
        self.call(
            "Input.dispatchMouseEvent", type=f"mouse{kind}", x=x, y=y, button=button, buttons=int(is_down),
            clickCount=clicks,
        )  # fmt: skip

    def press(self, *keys: str) -> None:
        """Press keys one after the other: `Tab`, `ArrowRight`, `Enter`, `Shift+Tab`, or letters."""
        for key in keys:
            name = key.rpartition("+")[2]
            code, text = KEYS[name] if name in KEYS else (ord(name.upper()) if name.isalnum() else 0, name)
            given = {
                "key": " " if name == "Space" else name,
                "code": name,
                "windowsVirtualKeyCode": code,
                "modifiers": 8 * key.startswith("Shift+"),
            }
            self.call("Input.dispatchKeyEvent", type="keyDown", text=text, **given)
            self.call("Input.dispatchKeyEvent", type="keyUp", **given)

    def fingers(self, kind: str, *places: tuple[float, float]) -> None:
        """Put fingers onto the glass (`Start`), move them (`Move`), lift them (`End`)."""
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        self.call("Input.dispatchTouchEvent", type=f"touch{kind}", touchPoints=points)
