"""Pages of the editor in Chromium, driven by Playwright: one browser per worker, a new context per test."""

from __future__ import annotations

import asyncio
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


@pytest.fixture
def start_editor(browser: Any, tmp_path: Path) -> Iterator[Callable[..., Editor]]:
    """Function that starts a server in a new folder and opens its page.

    The function takes the text of a circuit file, its name, further files of the folder by name, and properties of the
    browser. With a name but no text, the file does not exist yet; without both, the editor starts without a file. At
    the end of the test it checks that the page and the server reported no errors.
    """
    with ExitStack() as stack:

        def start(
            text: str | bytes | None = None,
            name: str | None = None,
            *,
            files: dict[str, str | bytes] | None = None,
            width: int = 1280,
            height: int = 900,
            scheme: str = "light",
            touch: bool = False,
        ) -> Editor:
            folder = tmp_path / f"work{len(list(tmp_path.iterdir()))}"
            folder.mkdir()
            name = "plant.toml" if name is None and text is not None else name
            write_files(folder, {**(files or {}), **({} if name is None or text is None else {name: text})})
            server = Server(folder, *([] if name is None else [name]))
            stack.callback(_check_server, server)
            context = browser.new_context(
                viewport={"width": width, "height": height}, color_scheme=scheme, has_touch=touch, locale="en-US",
                reduced_motion="reduce",
            )  # fmt: skip
            editor = Editor(server, context.new_page())
            stack.callback(_check_page, editor)
            return editor.open()

        yield start


def _check_page(editor: Editor) -> None:
    editor.page.context.close()
    assert editor.problems == []


def _check_server(server: Server) -> None:
    code = server.stop()
    assert (code, server.errors()) == (0, "")


@pytest.fixture
def editor(start_editor: Callable[..., Editor]) -> Editor:
    """Page of the editor without a file."""
    return start_editor()
