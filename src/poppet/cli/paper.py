"""`poppet paper`: the figures of the paper that this house began with."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from poppet.cli.parser import Option
from poppet.core.errors import InputError

EXAMPLES = ("poppet paper", "poppet paper -o figures")
OPTIONS = (Option("-o, --output FOLDER", "folder to write, `paper` by default", more={"default": "paper"}),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    folder = Path(options.output)
    if folder.exists() and not folder.is_dir():
        raise InputError("paper.folder_is_file", path=str(folder))
    from poppet.report.varga2012.paper import write_paper

    print(write_paper(folder, lambda step: print(step, file=sys.stderr)).table())
    return 0
