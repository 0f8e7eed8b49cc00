"""`poppet export`: what a circuit can be exported to."""

from __future__ import annotations

import argparse

from poppet.cli.main import COMMANDS, WRONG_INPUT
from poppet.cli.parser import Option
from poppet.core.errors import InputError, NameSuggestion

EXAMPLES = ("poppet export", "poppet export c FILE.toml -o valve")
OPTIONS = (Option("[TARGET]", "each has a help of its own"),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    targets = {name: text for name, text in COMMANDS.items() if name.split()[:-1] == ["export"]}
    if options.target:
        name = f"export {options.target}"
        raise InputError("cli.command.unknown", name=name, near=NameSuggestion(name, targets))
    width = max(map(len, targets), default=0)
    print("\n".join(f"poppet {name:<{width}}  {text}" for name, text in targets.items()))
    return WRONG_INPUT
