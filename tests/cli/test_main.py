"""Tests of the entry point: command names, help, exit codes, errors without traceback."""

from __future__ import annotations

import importlib
import os
import shlex
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

from poppet import __version__
from poppet.cli import main
from poppet.cli.commands import COMMANDS
from poppet.core.provenance import LEAST_CERTAIN_FIRST

SOURCES = Path(main.__file__).parents[2]


def cold(*arguments: str, cwd: Path, **options: object) -> subprocess.CompletedProcess[str]:
    """Run `python -m poppet` in a process of its own."""
    environment = os.environ | {"PYTHONPATH": str(SOURCES)}
    command = [sys.executable, "-m", "poppet", *arguments]
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, timeout=120, **options)


@pytest.mark.parametrize(
    "arguments",
    [
        ("simulate", "a.toml", "--start-from", "run.csv", "-o", "./run.csv"),
        ("identify", "fit", "a.toml", "-o", "a.toml"),
        ("identify", "characteristic", "a.toml", "-o", "r.toml", "--library", "r.toml"),
        ("control", "tune", "a.toml", "-o", "a.toml"),
        ("plot", "a.csv", "b.png", "-o", "b.png"),
        ("bench", "iso10094", "--recording", "a.toml", "-o", "a.toml"),
    ],
)
def test_input_files_are_never_overwritten(poppet, arguments):
    assert poppet(*arguments).codes == ["cli.output.taken"]


@pytest.mark.parametrize("stream", ["stdout", "stderr"])
def test_a_closed_stream_is_replaced(stream, tanks, monkeypatch):
    monkeypatch.setattr(sys, stream, None)
    assert main.run(["check", str(tanks)]) == 0
    assert main.run(["check", "nothing.toml"]) == 2


def test_users_get_no_python_warning(capsys, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["poppet", "schema"])
    monkeypatch.setattr(main, "_dispatch", lambda _: warnings.warn("of somebody's source", stacklevel=1) or 0)
    assert main.run() == 0
    assert capsys.readouterr() == ("", "")


def test_version(poppet):
    assert poppet("--version") == (0, f"poppet {__version__}\n", "")


def test_help_lists_every_command(poppet):
    code, out, _ = poppet("--help")
    assert code == 0
    assert [name for name, command in COMMANDS.items() if f"  {name} " not in out or command.summary not in out] == []


def test_without_a_command_the_help_goes_to_stderr(poppet):
    code, out, err = poppet()
    assert (code, out) == (2, "")
    assert "commands:" in err


@pytest.mark.parametrize(("arguments", "code"), [(("audit",), 2), (("audit", "--help"), 0)])
def test_the_first_word_of_commands_lists_them(poppet, arguments, code):
    answer = poppet(*arguments)
    text = answer.out + answer.err
    assert answer.code == code
    assert [name for name in COMMANDS if f"\n  {name} " in text] == [n for n in COMMANDS if n.startswith("audit ")]


@pytest.mark.parametrize("name", COMMANDS)
def test_every_help_ends_with_two_or_three_examples(poppet, name):
    code, out, _ = poppet(name, "--help")
    examples = out.partition("examples:\n")[2].splitlines()
    assert code == 0
    assert 2 <= len(examples) <= 4
    assert all(line.startswith(f"  poppet {name}") for line in examples)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_example_can_be_parsed(name):
    for line in COMMANDS[name].examples:
        program, *command_line = shlex.split(line)
        command, arguments = main.split_command(command_line)
        # A group shows what is in it.
        assert program == "poppet"
        assert f"{command} ".startswith(f"{name} ")
        main.command_parser(command).read(arguments)


@pytest.mark.parametrize(
    ("arguments", "code", "address", "nearest"),
    [
        (("simualte", "x.toml"), "names.unknown", "simualte", "simulate"),
        (("audit", "energie"), "names.unknown", "audit energie", "audit energy"),
        (("frobnicate",), "names.unknown", "frobnicate", ""),
        (("simulate", "x.toml", "--duratoin", "5 s"), "names.unknown", "--duratoin", "--duration"),
        (("simulate", "--hepl"), "names.unknown", "--hepl", "--help"),
        (("simulate", "x.toml", "--dur", "5 s"), "names.unknown", "--dur", "--duration"),
        (("--verison",), "names.unknown", "--verison", "--version"),
        (("simulate",), "cli.usage", "", ""),
        (("simulate", "x.toml", "-o"), "cli.usage", "", ""),
        (("simulate", "x.toml", "y.toml"), "cli.argument.extra", "", ""),
    ],
)
def test_a_misspelt_name_has_a_suggestion(poppet, arguments, code, address, nearest):
    answer = poppet(*arguments)
    assert answer.code == 2
    assert answer.errors == [(code, address, None, nearest)]


def test_the_version_needs_no_command(poppet):
    assert poppet("--version", "simulate") == (0, f"poppet {__version__}\n", "")


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_quiet(poppet, monkeypatch, tmp_path, name):
    """The output is suppressed, notes are not."""

    def execute(options):
        assert options.quiet
        print("text")
        print("note: text", file=sys.stderr)

    module, _, function = COMMANDS[name].function.partition(":")
    monkeypatch.setattr(importlib.import_module(f"poppet.cli.{module}"), function, execute)
    arguments = shlex.split(COMMANDS[name].examples[0])[1:]
    assert main.split_command(arguments)[0] == name
    assert poppet(*arguments, "--quiet") == (0, "", "note: text\n")


@pytest.mark.parametrize(
    "line",
    [
        "simulate tanks.toml",
        "check tanks.toml",
        "show tanks.toml",
        "linearise tanks.toml",
        "new",
        "new two-tanks",
        "schema",
        "library",
        "explain wiring",
        'convert "6 bar g" --to bar',
        "draw tanks.toml -o tanks.svg",
        "export c tanks.toml -o folder",
    ],
)
def test_quiet_commands_print_nothing(poppet, tanks, line):
    assert poppet(*shlex.split(line)).out
    answer = poppet(*shlex.split(line), "--quiet", *(["--force"] if line.startswith("new t") else []))
    assert (answer.code, answer.out) == (0, "")


def test_an_old_name_of_an_option_is_accepted_with_a_note(poppet, tanks):
    old = poppet("live", str(tanks), "--number=low.volume=10 l..30 l", "-o", "old.html")
    assert (old.code, old.err) == (
        0,
        "note: The option --number is now called --parameter. The old name works until version 1.0.\n",
    )
    new = poppet("live", str(tanks), "--parameter", "low.volume=10 l..30 l", "-o", "new.html")
    assert (new.code, new.err) == (0, "")
    assert Path("old.html").read_bytes() == Path("new.html").read_bytes()


def test_the_help_lists_the_kinds_of_sources():
    (option,) = (option for option in COMMANDS["show"].options if option.name == "kind")
    assert option.help == f"one kind of source: {', '.join(LEAST_CERTAIN_FIRST)}"


def failing(error: BaseException):
    def execute(options):
        raise error

    return execute


@pytest.mark.parametrize(
    ("error", "code", "sentence"),
    [
        (KeyboardInterrupt(), 130, "interrupted."),
        (
            ZeroDivisionError("division\nby zero"),
            1,
            "internal error: ZeroDivisionError: division by zero. Please report",
        ),
        (MemoryError(), 1, "internal error: MemoryError"),
        (PermissionError(13, "Permission denied", "rig.toml"), 2, "rig.toml: Permission denied."),
    ],
)
def test_an_exception_gives_one_line(poppet, monkeypatch, error, code, sentence):
    monkeypatch.delenv("POPPET_DEBUG", raising=False)
    monkeypatch.setattr("poppet.cli.reference.show_library", failing(error))
    answer = poppet("library")
    assert answer.code == code
    assert answer.err.startswith(f"error: {sentence}")
    assert answer.err.count("\n") == 1


def test_debugging_shows_the_traceback(poppet, monkeypatch):
    monkeypatch.setenv("POPPET_DEBUG", "1")
    monkeypatch.setattr("poppet.cli.reference.show_library", failing(ZeroDivisionError("here")))
    with pytest.raises(ZeroDivisionError, match="here"):
        poppet("library")


def test_a_closed_pipe_is_no_error(tmp_path):
    environment = os.environ | {"PYTHONPATH": str(SOURCES)}
    read_end, write_end = os.pipe()
    os.close(read_end)
    done = subprocess.run(
        [sys.executable, "-m", "poppet", "schema"],
        stdout=write_end, stderr=subprocess.PIPE, text=True, env=environment, cwd=tmp_path, timeout=120,
    )  # fmt: skip
    os.close(write_end)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("arguments", [["--help"], ["--version"], ["simulate", "--help"]])
def test_help_and_version_import_nothing_heavy(tmp_path, arguments):
    code = (
        "import sys; from poppet.cli.main import run; code = run(sys.argv[1:]);"
        "heavy = {'numpy', 'casadi', 'numba', 'scipy', 'rich', 'matplotlib', 'pandas'} & set(sys.modules);"
        "sys.exit(f'imported {heavy}' if heavy else code)"
    )
    environment = os.environ | {"PYTHONPATH": str(SOURCES)}
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], env=environment, capture_output=True, text=True, timeout=120
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_a_cold_process_simulates(tmp_path, tanks):
    done = cold("simulate", tanks.name, "-o", "out.csv", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == "out.csv: 11 rows, 11 series, 0 ... 5 s. The run is complete.\n"
    assert (tmp_path / "out.csv").read_text().startswith("time [s],high.pressure [Pa],")


def test_a_cold_process_refuses_bad_input(tmp_path):
    done = cold("simulate", "missing.toml", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert (
        done.stderr
        == "error: missing.toml does not exist. Check the path. `poppet new` writes a circuit as a starting point.\n"
        "more: poppet explain toml.no_file\n"
    )
