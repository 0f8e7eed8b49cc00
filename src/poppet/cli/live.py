"""`poppet live`: a page in which a circuit itself runs."""

from __future__ import annotations

import argparse

from poppet.cli.assignments import loaded
from poppet.cli.parser import FILE, SET, WITH, Option

EXAMPLES = (
    "poppet live valve-fill.toml -o valve-fill.html",
    'poppet live valve-fill.toml --number "tank.volume=0.05 m^3..0.4 m^3" --number supply.pressure -o valve-fill.html',
)
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option(
        "--number ADDRESS ...",
        "a number or input that the page's reader may change, with its range where wanted: "
        'tank.volume="50 l..400 l"; by default the driven inputs and the first numbers that were written',
    ),
    Option("-o, --output PAGE", "page to write", (".html", ".htm"), more={"required": True}),
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.deploy.live.live_page import write_live

    circuit, notes = loaded(options)
    for note in notes:
        print(f"note: {note}")
    path = write_live(circuit, options.output, numbers=options.number)
    print(f"{options.output}: {path.stat().st_size / 1000:.0f} kB; opens in any browser, and asks nobody for anything.")
    return 0
