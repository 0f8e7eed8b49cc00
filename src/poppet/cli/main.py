"""Entry point of the command line.

It runs the requested command, and converts errors to messages and exit codes.

Nothing heavy is imported here, because `poppet --help` must be fast.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence

from poppet.cli.commands import COMMANDS, all_commands
from poppet.cli.parser import Command, CommandParser
from poppet.core.command_options import Option
from poppet.core.errors import InputError, NameSuggestion, PoppetError
from poppet.core.note_groups import explain_command
from poppet.core.number_format import printable
from poppet.core.plugins import PluginWarning, import_object

FAILED, WRONG_INPUT, INTERRUPTED = 1, 2, 130
PROGRAM = Command(
    "electro-pneumatic proportional valves and their loads",
    "",
    (Option("--version", "print the version"),),
    ("poppet new valve-fill", "poppet simulate valve-fill.toml", "poppet simulate --help"),
)


def run(arguments: Sequence[str] | None = None) -> int:
    """Run poppet with command-line arguments, and return the exit code.

    By default, the arguments are those in `sys.argv`.

    Examples
    --------
    >>> run(["convert", "6 bar g", "--to", "bar"])
    6 bar g = 7 bar
      gauge pressures refer to an ambient pressure of 1 bar absolute
    0
    """
    # Buffers replace closed streams. Characters that the terminal cannot print become question marks.
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, io.StringIO())
        if isinstance(stream := getattr(sys, name), io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    if arguments is None and not sys.warnoptions and not os.environ.get("POPPET_DEBUG"):
        # A user of the program gets notes; warnings are for Python code.
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", PluginWarning)
        warnings.formatwarning = lambda message, *_, **__: "".join(
            f"note: {printable(line)}\n" for line in str(message).splitlines()
        )
    try:
        code = _dispatch(list(sys.argv[1:] if arguments is None else arguments))
        # Here, where a broken pipe can still be caught, not when the interpreter ends.
        sys.stdout.flush()
    # The reader of `poppet show ... | head` has closed the pipe: no error.
    except BrokenPipeError:
        # Prevent the error of the interpreter's last flush.
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return _print_error("interrupted.", INTERRUPTED)
    except InputError as error:
        _print_error(str(error), error.exit_code)
        # For a mistyped command line, --help is better than `explain`.
        hint = explain_command(problem.code for problem in error.problems if not problem.code.startswith("cli."))
        return _print_error(hint, error.exit_code, "more: ")
    except PoppetError as error:
        return _print_error(str(error), error.exit_code)
    except OSError as error:
        name = f"{error.filename}: " if error.filename else ""
        return _print_error(f"{name}{error.strerror or error}.", WRONG_INPUT)
    except Exception as error:
        if os.environ.get("POPPET_DEBUG"):
            raise
        # One line, so that a log keeps it together.
        text = " ".join(str(error).splitlines())
        return _print_error(
            f"internal error: {type(error).__name__}: {text}. Please report it; POPPET_DEBUG=1 shows where.", FAILED
        )
    return code


def command_parser(name: str) -> CommandParser:
    """Return the parser of the arguments of the command `name`."""
    # `identify` has the methods of other packages.
    is_built_in = name in COMMANDS and name != "identify"
    return CommandParser(name, COMMANDS[name] if is_built_in else all_commands()[name])


def split_command(arguments: list[str]) -> tuple[str, list[str]]:
    """Split arguments into the name of the command and the remaining arguments.

    The name of a command has one or two words.

    Examples
    --------
    >>> split_command(["bench", "limits", "valve.toml"]), split_command(["show", "valve.toml"])
    (('bench limits', ['valve.toml']), ('show', ['valve.toml']))
    """
    name = " ".join(arguments[:2])
    # Two words first: `bench` alone is also a command.
    if name in COMMANDS or (arguments[0] == "export" and name in all_commands()):
        return name, arguments[2:]
    return arguments[0], arguments[1:]


def _dispatch(arguments: list[str]) -> int:
    if not arguments or arguments[0].startswith("-"):
        parser = _overview("", PROGRAM, all_commands())
        try:
            options = parser.read(arguments)
        except SystemExit:
            return 0
        if options.version:
            from poppet import __version__

            print(f"poppet {__version__}")
            return 0
        if options.command:
            raise InputError("cli.command.late", argument=arguments[0], command=options.command)
        parser.print_help(sys.stderr)
        return WRONG_INPUT
    name, rest = split_command(arguments)
    if name not in COMMANDS and name not in (commands := all_commands()):
        return _run_group(name, rest, commands)
    parser = command_parser(name)
    try:
        options = parser.read(rest)
    except SystemExit:  # --help
        return 0
    options.command, options.stdout = name, sys.stdout
    declaration = COMMANDS.get(name) or all_commands()[name]
    execute: Callable[[argparse.Namespace], int | None] = import_object(f"poppet.cli.{declaration.function}")
    with contextlib.redirect_stdout(io.StringIO()) if options.quiet else contextlib.nullcontext():
        return execute(options) or 0


def _run_group(name: str, arguments: list[str], commands: Mapping[str, Command]) -> int:
    """Print the commands whose first word is a name, such as `audit`, and return the exit code.

    An error reports a name without such commands, or a second word that is none of them.
    """
    group = {key: command for key, command in commands.items() if key.startswith(f"{name} ")}
    words = [name, *arguments[:1]] if group else [name]
    if not group or (arguments and not arguments[0].startswith("-")):
        unknown = " ".join(words)
        suggestion = NameSuggestion(unknown, group or commands)
        raise InputError("names.unknown", unknown, meaning="a command of poppet", suggestion=suggestion)
    examples = [example for command in group.values() for example in command.examples[:1]]
    parser = _overview(name, Command(f"commands of the group {name}", "", (), examples), group)
    try:
        parser.read(arguments)
    except SystemExit:
        return 0
    parser.print_help(sys.stderr)
    return WRONG_INPUT


def _overview(name: str, declaration: Command, commands: Mapping[str, Command]) -> CommandParser:
    """Return a parser whose help lists commands."""
    parser = CommandParser(name, declaration)
    width = max(map(len, commands))
    lines = (f"{name:<{width}}  {command.summary}" for name, command in commands.items())
    group = parser.add_argument_group("commands", "\n".join(lines))
    group.add_argument("command", nargs="?", help="see poppet COMMAND --help")
    return parser


def _print_error(text: str, code: int, prefix: str = "error: ") -> int:
    """Print a message to the standard error, and return the exit code."""
    with contextlib.suppress(OSError):
        for line in text.splitlines():
            print(f"{prefix}{printable(line)}", file=sys.stderr)
        sys.stderr.flush()
    return code
