"""Command `poppet edit`: edit a circuit file in the browser."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import webbrowser
from pathlib import Path
from threading import Thread
from types import FrameType
from typing import NoReturn


def execute(options: argparse.Namespace) -> None:
    """Run the command `edit`: start the server of the editor, and open the browser."""
    # A folder of circuits can contain Python files with the names of modules, which must not be executed.
    sys.path[:] = [path for path in sys.path if path not in ("", os.getcwd())]
    # Both, because a shell makes programs in the background ignore Ctrl-C.
    previous = {number: signal.signal(number, _interrupt) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        _serve(options)
    except KeyboardInterrupt:
        pass
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def _serve(options: argparse.Namespace) -> None:
    """Serve the page until the program is interrupted."""
    from poppet.cli.circuit_files import TEMPLATES
    from poppet.edit.routes import load_simulation, page_routes, session_routes
    from poppet.edit.server import EditServer
    from poppet.edit.session import Session
    from poppet.edit.tasks.manager import Tasks
    from poppet.edit.tasks.routes import task_routes

    session = Session(Path(options.file or "."), TEMPLATES)
    with (
        Tasks() as tasks,
        EditServer(options.port, [page_routes(), session_routes(session), task_routes(session, tasks)]) as server,
    ):
        # Without a buffer: a program that starts the editor reads this line.
        print(server.address, flush=True)
        Thread(target=load_simulation, daemon=True).start()
        if not options.no_browser:
            # In a thread, because a browser in the terminal needs the server before it returns.
            Thread(target=webbrowser.open, args=(server.address,), daemon=True).start()
        try:
            server.serve_forever()
        finally:
            session.lock.acquire(timeout=5.0)  # after a file that is being saved


def _interrupt(_number: int, _frame: FrameType | None) -> NoReturn:
    raise KeyboardInterrupt
