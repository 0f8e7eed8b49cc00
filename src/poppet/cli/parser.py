"""Parser of the command line, made from the declaration of a command."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

from poppet.core.codes import Note
from poppet.core.command_options import QUIET, Option
from poppet.core.errors import InputError, NameSuggestion, raise_errors

if TYPE_CHECKING:
    from pathlib import Path


MEASURED = (".csv", ".txt", ".tsv", ".dat", ".asc", ".log", ".lvm", ".parquet", ".mat", ".tdms", ".mf4")
"""File suffixes of recordings, which are no input files of commands."""


class Command(NamedTuple):
    """Declaration of one command of the program, such as `simulate`.

    The parser, the help text and the tables in the documentation are generated from the declarations.
    """

    summary: str
    function: str  # `module:function` of `poppet.cli`; it takes the parsed options and returns an exit code or None
    arguments: Sequence[Option]
    examples: Sequence[str]
    limitations: Sequence[str] = ()

    @property
    def options(self) -> tuple[Option, ...]:
        """All options and arguments of the command, including `--quiet`."""
        return (*self.arguments, QUIET)


class CommandParser(argparse.ArgumentParser):
    """Parser of the arguments of one command.

    If the name of the command is empty, it parses the arguments of the program without a command, such as --version.
    """

    def __init__(self, name: str, command: Command) -> None:
        self.command, self.options = name, command.options if name else tuple(command.arguments)
        limitations = ["limitations:", *(f"  - {text}" for text in command.limitations), ""]
        super().__init__(
            prog=f"poppet {name}".strip(),
            description=f"{command.summary[:1].upper()}{command.summary[1:]}.",
            epilog="\n".join(
                [*(limitations if command.limitations else ()), "examples:", *(f"  {e}" for e in command.examples)]
            ),
            formatter_class=argparse.RawDescriptionHelpFormatter,
            # A new option must not change the meaning of an abbreviation in a script.
            allow_abbrev=False,
        )
        groups: dict[str, Any] = {"": self}
        for option in self.options:
            if option.group not in groups:
                groups[option.group] = self.add_mutually_exclusive_group()
            groups[option.group].add_argument(*(option.names or [option.name]), **option.argparse_keywords())

    def read(self, arguments: Sequence[str]) -> argparse.Namespace:
        """Parse and check the arguments of the command.

        The checks include the names of output files, so the command does not fail after a long computation.
        """
        new_names = {old: option.names[-1] for option in self.options for old in option.old_names}
        names = self._option_string_actions
        present: list[str] = []
        for k, argument in enumerate(arguments):
            name, equals, value = argument.partition("=")
            if argument == "--":
                present += arguments[k:]
                break
            if name in new_names:
                print(f"note: {Note('cli.option_renamed', option=name, new=new_names[name])}", file=sys.stderr)
                name = new_names[name]
            # Before argparse, which would first report an argument that is missing because of the misspelling.
            elif name.startswith("--") and name not in names:
                near = NameSuggestion(name, [option for option in names if option.startswith("--")])
                raise InputError("names.unknown", name, meaning=f"an option of `{self.prog}`", suggestion=near)
            present.append(f"{name}{equals}{value}")
        self._reject_lone_recording(present)
        # `parse_args` would end the program with its own message.
        options, rest = self.parse_known_args(present)
        if rest:
            raise InputError("cli.argument.extra", argument=rest[0], program=self.prog)
        self._check(options)
        return options

    def _reject_lone_recording(self, arguments: Sequence[str]) -> None:
        """Raise an error if `poppet identify` has a recording but no method; argparse would ask for a method."""
        if self.command != "identify" or any(word in self.options[0].choices for word in arguments):
            return
        recording = next((word for word in arguments if word.lower().endswith(MEASURED)), None)
        if recording:
            raise InputError("question.is_recording", path=recording)

    def _check(self, options: argparse.Namespace) -> None:
        """Raise an error if options contradict each other or an output file would overwrite another file.

        An option contradicts the selected action of a command if it is valid for another action only.
        """
        from os.path import realpath

        action = getattr(options, self.options[0].name, "") if self.options else ""
        facts: dict[str, Any] = {"command": self.command, "action": action}
        raise_errors(
            [
                InputError("cli.option.misplaced", option=option.names[-1], actions=option.actions, **facts)
                for option in self.options
                if option.actions and action not in option.actions
                if getattr(options, option.name) != self.get_default(option.name)
            ]
        )
        paths: set[str] = set()
        outputs = []
        for option in self.options:
            value = getattr(options, option.name)
            if value is not None and option.formats:
                value = output_path(value, option.formats)
                setattr(options, option.name, value)
            if value and (option.formats or option.name == "output"):
                outputs.append(value)
            elif value and option.metavar in ("FILE", "RECORDING", "RESULT"):
                paths |= {realpath(path) for path in ([value] if isinstance(value, str) else value)}
        for path in outputs:
            if realpath(path) in paths:
                raise InputError("cli.output.taken", path=str(path))
            paths.add(realpath(path))

    def error(self, message: str) -> NoReturn:
        """Raise an error with the message that argparse would otherwise print."""
        raise InputError("cli.usage", program=self.prog, message=message)


def output_path(text: str, formats: Sequence[str]) -> Path:
    """Check the name of an output file, and return its path.

    `formats` contains the valid file extensions. The folder must exist. The check takes place before any computation.
    """
    from pathlib import Path

    from poppet.core.files import check_folder, check_path

    path = Path(text)
    if path.suffix.lower() not in formats:
        code = "files.suffix" if path.suffix else "cli.output.no_suffix"
        raise InputError(code, path=str(path), suffix=path.suffix, suggestion=NameSuggestion(path.suffix, formats))
    check_folder(path, path.parent)
    if path.is_dir():
        raise InputError("cli.output.is_folder", path=str(path))
    check_path(path)
    return path
