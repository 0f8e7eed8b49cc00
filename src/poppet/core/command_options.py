"""Declaration of the options and arguments of a command."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

# No dataclass: importing it would make `poppet --help` slower by half.


class Option(NamedTuple):
    """Declaration of one option or positional argument on the command line."""

    # `FILE`, `[FILE]` if it is optional, `FILE ...` for several;
    # `--quiet`, `-o, --output FILE`, and `--set ADDRESS=VALUE ...` if it may be repeated
    usage: str
    help: str
    # suffixes of a file that the command writes: the help lists them, and other suffixes are rejected before any work
    formats: Sequence[str] = ()
    actions: Sequence[str] = ()  # actions of the command to which the option is limited; the help begins with them
    choices: Mapping[str, str] = {}  # allowed values and their meanings
    group: str = ""  # options of one group exclude each other
    keywords: Mapping[str, Any] = {}  # further keyword arguments of `argparse`
    old_names: Sequence[str] = ()  # accepted until version 1.0, with a note

    @property
    def names(self) -> list[str]:
        """Names of the option, such as `-o` and `--output`. A positional argument has no such names."""
        return [name.rstrip(",") for name in self.usage.split() if name.startswith("-")]

    @property
    def metavar(self) -> str:
        """Placeholder of the value in the help text, for example `FILE`."""
        names = [name.strip("[]") for name in self.usage.split()]
        return next((name for name in names if not name.startswith("-") and name != "..."), "")

    @property
    def is_repeated(self) -> bool:
        """True if the option or argument accepts several values."""
        return self.usage.endswith("...")

    @property
    def name(self) -> str:
        """Name of the attribute that contains the parsed value, for example `output`."""
        name = self.names[-1][2:] if self.names else self.metavar.lower() + "s" * self.is_repeated
        return str(self.keywords.get("dest", name.replace("-", "_")))

    @property
    def meaning(self) -> str:
        """Help text of the option, with its choices, file formats and the actions to which it applies."""
        text = "; ".join(filter(None, [self.help, *(f"{name}: {text}" for name, text in self.choices.items())]))
        text = f"{', '.join(self.actions)}: {text}" if self.actions else text
        return f"{text}: {' or '.join(', '.join(self.formats).rsplit(', ', 1))}" if self.formats else text

    def argparse_keywords(self) -> dict[str, Any]:
        """Return the keyword arguments of `argparse.ArgumentParser.add_argument` for the option."""
        keywords: dict[str, Any] = {"help": self.meaning.replace("%", "%%")}  # argparse formats help texts with %
        if not self.metavar:
            return keywords | {"action": "store_true", **self.keywords}
        keywords["metavar"] = self.metavar
        if self.choices:
            keywords["choices"] = tuple(self.choices)
        if self.is_repeated and self.names:
            keywords |= {"action": "append", "default": []}
        elif self.is_repeated:
            keywords["nargs"] = "*" if self.usage.startswith("[") else "+"
        elif self.usage.startswith("["):
            keywords["nargs"] = "?"
        return keywords | dict(self.keywords)


FILE = Option("FILE", "circuit file (.toml)")
SET = Option(
    "--set ADDRESS=VALUE ...",
    'change a parameter or an option first: tank.volume="0.1 m^3", tank.thermal=isothermal; a bare number is SI; '
    "may be repeated",
    keywords={"dest": "values"},
)
WITH = Option(
    "--with FILE",
    "use the parameters of a result of `poppet identify`, or gains of `poppet control tune`; --set is applied after",
    keywords={"dest": "result"},
)
QUIET = Option("--quiet", "print notes and errors only")
"""Option of every command."""
