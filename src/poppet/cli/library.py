"""`poppet library`: what is published and built in."""

from __future__ import annotations

import argparse

from poppet.cli.parser import Option

EXAMPLES = ("poppet library", "poppet library varga2012", "poppet library nitrogen")
OPTIONS = (Option("[NAME]", "a set, characteristic or gas to describe; lists them when left out"),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet import library

    if options.name is not None:
        print(library.describe(options.name))
        return 0
    listed = {
        "sets": library.sets(),
        "characteristics": library.characteristics(),
        "gases": library.gas_names(),
    }
    for heading, names in listed.items():
        print(f"{heading + ':':<17}{', '.join(names)}")
    return 0
