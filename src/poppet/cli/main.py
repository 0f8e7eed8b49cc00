"""The entry of the command line: finds the command, turns errors into sentences and exit codes.

Nothing heavy is imported here: `poppet --help` has to answer at once.
"""

from __future__ import annotations

import contextlib
import importlib
import io
import os
import sys
import warnings
from collections.abc import Sequence
from typing import Any

from poppet.cli.parser import CommandParser, Option
from poppet.core.errors import InputError, NameSuggestion, PoppetError
from poppet.core.number_format import printable
from poppet.core.plugins import PluginWarning

COMMANDS = {
    "simulate": "run a circuit file",
    "identify": "numbers with intervals from recordings: fit, tank, flow, characteristic, muscle, friction, design",
    "bench": "figures of a pressure valve, of a model or of recordings: iso10094",
    "ensemble": "many runs with uncertain numbers: yield, bands, influence of each number, worst cases",
    "size": "the smallest or largest number with which a circuit meets its requirements",
    "bench limits": "which part limits a valve: maps of bandwidth, step response and stability",
    "check": "find every mistake of circuit files without running them",
    "new": "write a circuit file to start from",
    "show": "list the numbers of a circuit by their source, the assumed ones first",
    "draw": "draw a circuit",
    "plot": "draw recordings over each other",
    "linearise": "linear model, eigenvalues and time constants of a circuit",
    "control": "tune a pressure controller, compare controllers under uncertainty",
    "live": "write a page in which a circuit itself runs, with sliders",
    "export": "a circuit for other places: c, fmu, st",
    "export st": "sampled controllers as a function block of structured text, for a PLC",
    "export c": "a circuit, or a sampled controller, as C with a host that checks it",
    "export fmu": "a circuit as an FMU, FMI 2.0 or 3.0, for Simulink, Dymola, OpenModelica and their kin",
    "export check": "the same run by every target, and how far each is from the kernel",
    "convert": "convert units, and C, Kv, Cv, qNn and effective areas",
    "library": "list or describe published parameter sets, characteristics and gases",
    "explain": "cause, example and remedy of a message code",
    "schema": "write the JSON schema of circuit files for editors",
    "paper": "reproduce the figures of Varga & Keski-Honkola 2012",
}
"""Name and summary of every command; each is the module of that name beside this one, `bench limits` bench_limits."""

FAILED, WRONG_INPUT, INTERRUPTED = 1, 2, 130
EXAMPLES = ("poppet new valve-fill", "poppet simulate valve-fill.toml", "poppet simulate --help")


def run(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Examples
    --------
    >>> run(["convert", "6 bar g", "--to", "bar"])
    6 bar g = 7 bar
      gauge pressures refer to an ambient pressure of 1 bar absolute
    0
    """
    _tolerate_narrow_encodings()
    if arguments is None and not sys.warnoptions and not os.environ.get("POPPET_DEBUG"):
        # As a program: what concerns a user is a note of the house, not a line of somebody's source.
        warnings.simplefilter("ignore")
        warnings.simplefilter("default", PluginWarning)
        warnings.showwarning = _show_warning
    try:
        code = _dispatch(list(sys.argv[1:] if arguments is None else arguments))
        # Here, where a broken pipe can still be caught, not when the interpreter ends.
        sys.stdout.flush()
    # `poppet show ... | head` has read enough: no mistake.
    except BrokenPipeError:
        _drop_output()
        return 0
    except KeyboardInterrupt:
        return _complain("interrupted.", INTERRUPTED)
    except InputError as error:
        _complain(str(error), error.exit_code)
        # Of a line that was mistyped, --help tells more.
        codes = dict.fromkeys(problem.code for problem in error.problems if not problem.code.startswith("cli."))
        more = f"poppet explain {' '.join(list(codes)[:3])}" if codes else ""
        return _complain(more, error.exit_code, "more: ")
    except PoppetError as error:
        return _complain(str(error), error.exit_code)
    except OSError as error:
        name = f"{error.filename}: " if error.filename else ""
        return _complain(f"{name}{error.strerror or error}.", WRONG_INPUT)
    except Exception as error:
        if os.environ.get("POPPET_DEBUG"):
            raise
        # One line, so that a log keeps it together.
        what = " ".join(str(error).splitlines())
        return _complain(
            f"internal error: {type(error).__name__}: {what}. Please report it; POPPET_DEBUG=1 shows where.",
            FAILED,
        )
    return code


def command_parser(name: str) -> CommandParser:
    """The parser of a command."""
    module = _module(name)
    return CommandParser(name, COMMANDS[name], module.OPTIONS, module.EXAMPLES)


def command_of(arguments: list[str]) -> tuple[str, list[str]]:
    """The command that some arguments begin with, of one word or two, and what follows it.

    Examples
    --------
    >>> command_of(["bench", "limits", "valve.toml"]), command_of(["show", "valve.toml"])
    (('bench limits', ['valve.toml']), ('show', ['valve.toml']))
    """
    # Two words first: `bench` alone is a command as well.
    words = 2 if " ".join(arguments[:2]) in COMMANDS else 1
    return " ".join(arguments[:words]), arguments[words:]


def _module(name: str) -> Any:
    return importlib.import_module(f"poppet.cli.{name.replace(' ', '_')}")


def _dispatch(arguments: list[str]) -> int:
    if not arguments or arguments[0].startswith("-"):
        return _program(arguments)
    name, rest = command_of(arguments)
    if name not in COMMANDS:
        raise InputError("cli.command.unknown", name=name, near=NameSuggestion(name, COMMANDS))
    parser = command_parser(name)
    try:
        options = parser.read(rest)
    except SystemExit:  # --help
        return 0
    code: int = _module(name).execute(options)
    return code


def _program(arguments: list[str]) -> int:
    """What `poppet` does without a command: help and version."""
    version = Option("--version", "print the version")
    parser = CommandParser("", "electro-pneumatic proportional valves and what they drive", [version], EXAMPLES)
    width = max(map(len, COMMANDS))
    commands = parser.add_argument_group(
        "commands", "\n".join(f"{name:<{width}}  {text}" for name, text in COMMANDS.items())
    )
    commands.add_argument("command", nargs="?", help="poppet COMMAND --help tells more")
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


def _complain(text: str, code: int, begin: str = "error: ") -> int:
    with contextlib.suppress(OSError):
        for line in text.splitlines():
            print(f"{begin}{printable(line)}", file=sys.stderr)
        sys.stderr.flush()
    return code


def _show_warning(message: Warning | str, *_: Any, **__: Any) -> None:
    _complain(str(message), 0, "note: ")


def _tolerate_narrow_encodings() -> None:
    """A title that the terminal cannot write is shown with ?, not refused; a stream that is closed takes all."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, io.StringIO())
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _drop_output() -> None:
    """Nobody reads any more: let the interpreter's last flush go nowhere instead of complaining."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
