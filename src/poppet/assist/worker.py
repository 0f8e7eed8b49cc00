"""Process that performs calls, one after another.

The server writes each call as one line of JSON to the standard input. The process writes one line for each: the result
or the errors. The server kills it to end a call.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import shutil
import signal
import sys
import tempfile
import threading
import warnings
from pathlib import Path
from typing import Any, TextIO

from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS, perform
from poppet.assist.limits import MEMORY, PREFIX, REPLY
from poppet.assist.replies import error_rows
from poppet.core.errors import InputError, PoppetError


def reply_to(request: dict[str, Any], folder: Folder) -> str:
    """Perform a call, and return its reply as JSON."""
    reply: dict[str, Any]
    try:
        reply = {"result": perform(folder, FUNCTIONS[request["call"]], request["arguments"], Path.cwd())}
        text = json.dumps(reply, allow_nan=False)
        if len(text) > REPLY:
            raise InputError("assist.large_result", most=REPLY // 2**20)
        return text
    except PoppetError as error:
        reply = {"errors": error_rows(error, folder)}
    except KeyboardInterrupt:
        reply = {"errors": error_rows(InputError("assist.time_limit", limit=request["time_limit"]))}
    except MemoryError:
        reply = {"errors": error_rows(InputError("assist.no_memory"))}
    return json.dumps(reply)


def main() -> None:
    """Perform the calls of the server until it closes the standard input."""
    # Libraries that print must not disturb the replies.
    stream: TextIO = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the server, which ends this process
    warnings.simplefilter("ignore")
    _limit_memory()
    if hasattr(os, "nice"):
        with contextlib.suppress(OSError):
            os.nice(5)  # the server stays quick
    folder, requests = Folder.of(sys.argv[1]), queue.SimpleQueue[bytes]()
    threading.Thread(target=_read_requests, args=(requests,), daemon=True).start()
    _import_kernel()
    while line := requests.get():
        stream.write(f"{reply_to(json.loads(line), folder)}\n")
        stream.flush()


def _read_requests(requests: queue.SimpleQueue[bytes]) -> None:
    """Put the lines of the standard input into a queue, and end this process with the server."""
    begin = b""
    while block := os.read(0, 65536):
        *lines, begin = (begin + block).split(b"\n")
        for line in lines:
            requests.put(line)
    # Only the folder that the server has made for this process.
    if os.path.basename(os.getcwd()).startswith(PREFIX) and os.path.samefile(os.getcwd(), tempfile.gettempdir()):
        shutil.rmtree(os.getcwd(), ignore_errors=True)
    if os.name == "posix" and os.getpgrp() == os.getpid():
        os.killpg(0, signal.SIGKILL)
    os._exit(0)


def _limit_memory() -> None:
    """Limit the memory of this process, if the system can."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def _import_kernel() -> None:
    """Import the libraries of simulations before the first call."""
    import poppet.engine.solve
    import poppet.parts  # noqa: F401


if __name__ == "__main__":
    main()
