"""Pages of the editor in Chromium, driven by Playwright: one browser per worker, a new context per test."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from chromium import found
from editor_page import FLAGS, Editor, Server, write_files


@pytest.fixture(scope="session")
def _browser() -> Iterator[tuple[Any, asyncio.AbstractEventLoop]]:
    playwright = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
    program = found()
    if program is None:
        pytest.skip("Chromium is not installed; POPPET_BROWSER can contain its path")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=list(FLAGS))
        loop = asyncio.get_running_loop()
        asyncio._set_running_loop(None)
        yield browser, loop
        asyncio._set_running_loop(loop)
        browser.close()


@pytest.fixture
def browser(_browser: tuple[Any, asyncio.AbstractEventLoop]) -> Iterator[Any]:
    """Browser of Playwright.

    Its event loop counts as running only during a test of this folder: other tests of the worker run loops of their
    own.
    """
    opened, loop = _browser
    asyncio._set_running_loop(loop)
    yield opened
    asyncio._set_running_loop(None)


class SharedServer:
    """Server that the tests of a worker use one after another, since most of the time of a server is its start."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.server: Server | None = None

    def begin(self, files: dict[str, str | bytes], name: str | None) -> Server:
        """Return the server with a file of its folder, which contains only the stated files."""
        if self.server is None or self.server.process.poll() is not None or self.server.errors():
            self.stop()
            folder = self.folder / f"work{len(list(self.folder.iterdir()))}"
            folder.mkdir()
            self.server = Server(folder)
        for path in self.server.folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        write_files(self.server.folder, files)
        content = {"empty": True} if name is None else {"file": name}
        assert self.server.post("/open", {**content, "discard": True}) == 200
        return self.server

    def stop(self) -> None:
        """End the server."""
        if self.server is not None:
            self.server.stop()


@pytest.fixture(scope="session")
def _shared_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SharedServer]:
    shared = SharedServer(tmp_path_factory.mktemp("editor"))
    yield shared
    shared.stop()


@pytest.fixture
def start_editor(browser: Any, tmp_path: Path, _shared_server: SharedServer) -> Iterator[Callable[..., Editor]]:
    """Function that opens the page of a server in an otherwise empty folder.

    The function takes the text of a circuit file, its name, further files of the folder by name, and properties of the
    browser. With a name but no text, the file does not exist yet; without both, the circuit is empty. The first page of
    a test is that of a shared server, unless `own` is True. At the end of the test, page and server must have reported
    no errors.
    """
    with ExitStack() as stack:
        started: list[Server] = []

        def serve(text: str | bytes | None, name: str | None, files: dict[str, str | bytes], own: bool) -> Server:
            written = files if name is None or text is None else {**files, name: text}
            if not own and not started and (name is None or text is not None):
                return _shared_server.begin(written, name)
            folder = tmp_path / f"work{len(list(tmp_path.iterdir()))}"
            folder.mkdir()
            write_files(folder, written)
            server = Server(folder, *([] if name is None else [name]))
            stack.callback(_stop_server, server)
            return server

        def start(
            text: str | bytes | None = None,
            name: str | None = None,
            *,
            files: dict[str, str | bytes] | None = None,
            width: int = 1280,
            height: int = 900,
            scheme: str = "light",
            touch: bool = False,
            own: bool = False,
        ) -> Editor:
            server = serve(text, "plant.toml" if name is None and text is not None else name, files or {}, own)
            context = browser.new_context(
                viewport={"width": width, "height": height}, color_scheme=scheme, has_touch=touch, locale="en-US",
                reduced_motion="reduce",
            )  # fmt: skip
            if server is _shared_server.server:
                context.add_cookies([server.cookie])
            started.append(server)
            editor = Editor(server, context.new_page())
            stack.callback(_check_page, editor)
            return editor.open()

        yield start


def _check_page(editor: Editor) -> None:
    editor.page.context.close()
    assert (editor.problems, editor.server.errors()) == ([], "")


def _stop_server(server: Server) -> None:
    assert server.stop() == 0


@pytest.fixture
def editor(start_editor: Callable[..., Editor]) -> Editor:
    """Page of the editor without a file."""
    return start_editor()
