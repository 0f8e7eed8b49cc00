"""An argument parser that names the nearest option, shows examples, and raises instead of exiting."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import NoReturn

from poppet.ground.errors import InputError, suggestion


class CommandParser(argparse.ArgumentParser):
    """Parser of one command.

    Parameters
    ----------
    command : str
        Name of the command; empty for the program itself.
    summary : str
        One sentence.
    examples : sequence of str
        Shown at the end of the help; each is a complete command line.
    """

    def __init__(self, command: str, summary: str, examples: Sequence[str]) -> None:
        self.examples = tuple(examples)
        super().__init__(
            prog=f"poppet {command}".strip(),
            description=f"{summary[:1].upper()}{summary[1:]}.",
            epilog="\n".join(["examples:", *(f"  {line}" for line in examples)]),
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )

    def read(self, arguments: Sequence[str]) -> argparse.Namespace:
        """Parse the arguments of the command."""
        self._refuse_unknown(arguments)
        options, rest = self.parse_known_args(arguments)
        if rest:
            cure = f"Put a value with a space into quotes. {self._cure()}"
            raise InputError(rest[0], "is one argument too many.", cure)
        return options

    def _refuse_unknown(self, arguments: Sequence[str]) -> None:
        # Before argparse, which would first complain about what is missing because of the misspelling.
        known = self._option_string_actions
        for argument in arguments:
            name = argument.partition("=")[0]
            if argument == "--":
                return
            if name.startswith("--") and name not in known:
                cure = suggestion(name, [option for option in known if option.startswith("--")])
                raise InputError(name, f"is no option of `{self.prog}`.", cure)

    def error(self, message: str) -> NoReturn:
        """Raise what argparse would print."""
        raise InputError(f"{self.prog}:", f"{message}.", self._cure())

    def _cure(self) -> str:
        return f"See: {self.prog} --help"
