"""Options of commands: declared as they are typed, those of several commands once, and parsed in one place."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

from poppet.core.errors import InputError, NameSuggestion, collect

if TYPE_CHECKING:
    from pathlib import Path

# No dataclass and no path here: `poppet --help` would take half as long again to import what they need.

RECORDINGS = (".csv", ".parquet", ".mat")
PICTURES = (".png", ".svg", ".pdf")


class Option(NamedTuple):
    """An option or argument of a command, as it is typed."""

    # `FILE`, `[FILE]` where it may be left out, `FILE ...` for several;
    # `--quiet`, `-o, --output FILE`, and `--set ADDRESS=VALUE ...` where it may be repeated
    usage: str
    help: str
    # suffixes of a file that is written: the help lists them, and other files are refused before any work begins
    formats: Sequence[str] = ()
    only: Sequence[str] = ()  # actions of the command that have it; the help begins with them, and the others refuse it
    # what may be given, and what each of them is, which the help lists; the first argument of a command with actions
    choices: Mapping[str, str] = {}
    rival: str = ""  # options with the same word exclude each other
    more: Mapping[str, Any] = {}  # anything else that `argparse` takes

    @property
    def names(self) -> list[str]:
        """`-o` and `--output`; none of an argument."""
        return [word.rstrip(",") for word in self.usage.split() if word.startswith("-")]

    @property
    def metavar(self) -> str:
        """What stands for its value."""
        words = [word.strip("[]") for word in self.usage.split()]
        return next((word for word in words if not word.startswith("-") and word != "..."), "")

    @property
    def is_repeated(self) -> bool:
        """True where its value is a list."""
        return self.usage.endswith("...")

    @property
    def name(self) -> str:
        """Under which its value is found after parsing: `output`, `file`, `files`."""
        own = self.names[-1][2:] if self.names else self.metavar.lower() + "s" * self.is_repeated
        return str(self.more.get("dest", own.replace("-", "_")))

    def declared(self) -> dict[str, Any]:
        """Keywords of `argparse`."""
        text = "; ".join(filter(None, [self.help, *(f"{name}: {what}" for name, what in self.choices.items())]))
        text = f"{', '.join(self.only)}: {text}" if self.only else text
        if self.formats:
            text += f": {' or '.join(', '.join(self.formats).rsplit(', ', 1))}"
        # argparse formats its helps with %.
        found: dict[str, Any] = {"help": text.replace("%", "%%")}
        if not self.metavar:
            return found | {"action": "store_true", **self.more}
        found["metavar"] = self.metavar
        if self.choices:
            found["choices"] = tuple(self.choices)
        if self.is_repeated:
            found |= (
                {"action": "append", "default": []}
                if self.names
                else {"nargs": "*" if self.usage.startswith("[") else "+"}
            )
        elif self.usage.startswith("["):
            found["nargs"] = "?"
        return found | dict(self.more)


FILE = Option("FILE", "circuit file (.toml)")
SET = Option(
    "--set ADDRESS=VALUE ...",
    'change a number or option first: tank.volume="0.1 m^3", tank.thermal=isothermal; a bare number is SI',
    more={"dest": "values"},
)
WITH = Option(
    "--with FILE",
    "take numbers of a result of `poppet identify`, or gains of `poppet control tune`; --set comes after",
    more={"dest": "result"},
)
VALVE = Option("--valve NAME", "the part that is tested; needed where there are several")
RESULT = Option("-o, --output FILE", "write the result", (".toml", ".json"))
REPORT = Option("--report FILE", "write a page for people", (".html",))
UNITS = Option("--units LIST", 'units wanted: "bar,degC,l/min ANR" or ADDRESS=UNIT')
SELECT = Option("--select LIST", 'series wanted: "tank.*,valve.stroke"')
ALL = Option("--all", "draw inner signals of the parts too: sensors, integrals, duties")
QUIET = Option("--quiet", "print errors only")


class CommandParser(argparse.ArgumentParser):
    """Parser of one command, or of the program itself, whose name is empty; the help ends with the examples."""

    def __init__(self, command: str, summary: str, options: Sequence[Option], examples: Sequence[str]) -> None:
        self.command, self.options, self.examples = command, tuple(options), tuple(examples)
        super().__init__(
            prog=f"poppet {command}".strip(),
            description=f"{summary[:1].upper()}{summary[1:]}.",
            epilog="\n".join(["examples:", *(f"  {line}" for line in examples)]),
            formatter_class=argparse.RawDescriptionHelpFormatter,
            # A new option must not change what an abbreviation in a script means.
            allow_abbrev=False,
        )
        rivals: dict[str, Any] = {"": self}
        for option in self.options:
            if option.rival not in rivals:
                rivals[option.rival] = self.add_mutually_exclusive_group()
            rivals[option.rival].add_argument(*(option.names or [option.name]), **option.declared())

    def read(self, arguments: Sequence[str]) -> argparse.Namespace:
        """Parse the arguments of the command; files that it writes are checked."""
        self._refuse_unknown(arguments)
        # `parse_args` would end the program with a sentence of its own.
        found, rest = self.parse_known_args(arguments)
        if rest:
            raise InputError("cli.argument.extra", argument=rest[0], program=self.prog)
        self._refuse_misplaced(found)
        for option in self.options:
            if option.formats and (given := getattr(found, option.name)) is not None:
                setattr(found, option.name, output_path(given, option.formats))
        self._refuse_overwriting(found)
        return found

    def _refuse_unknown(self, arguments: Sequence[str]) -> None:
        # Before argparse, which would first complain about what is missing because of the misspelling.
        known = self._option_string_actions
        for argument in arguments:
            name = argument.partition("=")[0]
            if argument == "--":
                return
            if name.startswith("--") and name not in known:
                near = NameSuggestion(name, [option for option in known if option.startswith("--")])
                raise InputError("cli.option.unknown", option=name, program=self.prog, near=near)

    def _refuse_misplaced(self, found: argparse.Namespace) -> None:
        """Refuse options that only other actions of the command have."""
        action = getattr(found, self.options[0].name, "") if self.options else ""
        given = [option for option in self.options if getattr(found, option.name) != self.get_default(option.name)]
        facts: dict[str, Any] = {"command": self.command, "action": action}
        collect(
            [
                InputError("cli.option.misplaced", option=option.names[-1], actions=option.only, **facts)
                for option in given
                if option.only and action not in option.only
            ]
        )

    def _refuse_overwriting(self, found: argparse.Namespace) -> None:
        """Refuse to write over what is read, and two files to one place."""
        from os.path import realpath

        taken: set[str] = set()
        written = [option for option in self.options if option.formats or option.name == "output"]
        for option in self.options:
            given = getattr(found, option.name)
            if given and option not in written and option.metavar in ("FILE", "RECORDING", "RESULT"):
                taken |= {realpath(each) for each in ([given] if isinstance(given, str) else given)}
        for path in filter(None, (getattr(found, option.name) for option in written)):
            if realpath(path) in taken:
                raise InputError("cli.output.taken", path=str(path))
            taken.add(realpath(path))

    def error(self, message: str) -> NoReturn:
        """Raise what argparse would print."""
        raise InputError("cli.usage", program=self.prog, message=message)


def output_path(text: str, formats: Sequence[str]) -> Path:
    """A file to be written, checked before anything is computed for it."""
    from pathlib import Path

    path = Path(text)
    if path.suffix.lower() not in formats:
        code = "files.suffix" if path.suffix else "cli.output.no_suffix"
        raise InputError(code, path=str(path), suffix=path.suffix, near=NameSuggestion(path.suffix, formats))
    if not path.parent.is_dir():
        raise InputError("files.no_folder", path=str(path), folder=str(path.parent))
    if path.is_dir():
        raise InputError("cli.output.is_folder", path=str(path))
    return path


def tell_written(*paths: Path | None) -> None:
    """Say which files are there now."""
    for path in paths:
        if path is not None:
            print(f"{path}: written.")
