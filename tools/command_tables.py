"""Write the option tables of docs/cli.md from the declarations: `python tools/command_tables.py`."""

from __future__ import annotations

import re
from pathlib import Path

from poppet.cli.commands import COMMANDS, REPORT
from poppet.cli.parser import Command
from poppet.core.command_options import QUIET, SET, WITH

PAGE = Path(__file__).parents[1] / "docs" / "cli.md"
HEAD = "| option | meaning |\n|---|---|\n"
COMMON = (REPORT, WITH, SET)


def option_table(command: Command) -> str:
    """Return the table of the options of a command, or nothing if it has common options only.

    Common options share a row. `--quiet`, which every command has, is omitted.
    """

    def usage(text: str) -> str:
        return ", ".join(f"`{name}`" for name in text.removesuffix(" ...").split(", "))

    named = [option for option in command.options if option.names]
    rows = [f"| {usage(option.usage)} | {option.meaning} |" for option in named if option not in (*COMMON, QUIET)]
    if not rows:
        return ""
    common = ", ".join(f"`{option.names[-1]}`" for option in COMMON if option in named)
    return HEAD + "\n".join([*rows, *([f"| {common} | as above |"] if common else [])]) + "\n"


def with_tables(text: str) -> str:
    """Return the page with the tables of all commands; a new table is added to the end of its section."""
    for name, command in COMMANDS.items():
        # A heading continues with arguments in capitals: `bench STANDARD`, but not `bench limits`.
        matches = re.finditer(rf"^## `poppet {name}(?: [^a-z`\n][^`\n]*)?`\n(?:(?!## ).*\n)*", text, re.MULTILINE)
        match = next(matches, None)
        if match is None:
            raise SystemExit(f"docs/cli.md has no section for {name}")
        section, table = match[0], option_table(command)
        begin = section.find(HEAD)
        if begin >= 0:
            rest = section[begin:].splitlines(keepends=True)
            end = next((k for k, line in enumerate(rest) if not line.startswith("|")), len(rest))
            section = section[:begin] + table + "".join(rest[end:])
        elif table:
            section = f"{section.rstrip()}\n\n{table}\n"
        text = text[: match.start()] + section + text[match.end() :]
    return text.rstrip() + "\n"


if __name__ == "__main__":
    PAGE.write_text(with_tables(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
