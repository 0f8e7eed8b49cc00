"""Command `poppet mcp`: functions for assistants, over the Model Context Protocol or as lines of JSON."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import sys

from poppet.cli.assignments import read_value
from poppet.cli.summary import print_notes
from poppet.core.codes import Note


def execute(options: argparse.Namespace) -> None:
    """Run the command `mcp`: serve one folder on the standard input and output until the client ends."""
    # A folder of circuits can contain Python files with the names of modules, which must not be executed.
    sys.path[:] = [path for path in sys.path if path not in ("", os.getcwd())]
    from poppet.assist.folder import Folder
    from poppet.assist.limits import LONGEST_LIMIT, TIME_LIMIT
    from poppet.core.tables import Field

    limits = Field(unit="s", low=1.0, high=LONGEST_LIMIT, meaning="time limit of a call")
    limit = TIME_LIMIT if options.time_limit is None else limits.read(read_value(options.time_limit), "--time-limit")
    folder = Folder.of(options.folder or ".")
    if options.lines:
        from poppet.assist.lines import serve_lines as serve
    else:
        from poppet.assist.mcp_server import serve_mcp as serve
    if sys.stdin.isatty() and not options.quiet:
        print_notes([Note("assist.terminal")])
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(serve(folder, limit))
