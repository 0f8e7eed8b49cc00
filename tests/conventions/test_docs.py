"""What README and docs say works: links, names of code, commands, Python and circuits."""

from __future__ import annotations

import importlib
import re
import runpy
import shlex
import subprocess
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from c_compiler import compile_c
from poppet import load, loads
from poppet.cli.commands import COMMANDS
from poppet.cli.main import command_parser, split_command
from poppet.deploy.c.controller import c_controller
from poppet.deploy.c.project import c_project
from poppet.deploy.controller import controller_program
from poppet.parts import Chamber
from poppet.signals import Constant

ROOT = Path(__file__).parents[2]
PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "examples" / "README.md",
    *sorted((ROOT / "docs").glob("*.md")),
]
TEXTS = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in PAGES}


def blocks(text: str, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def anchors(text: str) -> set[str]:
    """Anchors of headings, as Markdown viewers make them."""
    prose = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ (.+)$", prose, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def test_relative_links_resolve():
    broken = []
    for page, text in TEXTS.items():
        for target in re.findall(r"\]\((?!https?:|mailto:)([^)\s]+)\)", text):
            name, _, anchor = target.partition("#")
            file = (ROOT / page).parent / name if name else ROOT / page
            if not file.exists() or (anchor and anchor not in anchors(file.read_text(encoding="utf-8"))):
                broken.append(f"{page}: {target}")
    assert broken == []


@pytest.mark.parametrize("page", [page for page in TEXTS if blocks(TEXTS[page], "python")])
def test_python_blocks_run(page, tmp_path, monkeypatch, capsys):
    """One after the other, in one namespace, as a reader would type them."""
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, Any] = {"__name__": "__main__"}
    for number, block in enumerate(blocks(TEXTS[page], "python"), 1):
        exec(compile(block, f"{page}, block {number}", "exec"), namespace)
    assert "recording" in namespace


def test_c_blocks_are_programs_that_print_what_the_circuit_does(tmp_path):
    """Beside the export that their page begins with: a run whose pilot the host holds, and one of a smaller tank."""
    circuit = load(ROOT / "examples" / "fill_staircase.toml")
    held = replace(circuit, signals={"valve.pilot_pressure": Constant(2.5e5)}).simulate(duration=10.0)
    smaller = circuit.with_values({"tank.volume": 0.1}).simulate()
    library = {name: text for name, text in c_project(circuit, "fill_staircase").items() if not name.endswith("host.c")}
    printed = []
    for block in blocks(TEXTS["docs/export_c.md"], "c"):
        if "regulator.h" in block:
            continue
        program = compile_c(library | {"own.c": block}, tmp_path, "-std=c99", "-O0")
        out = subprocess.run([program], capture_output=True, text=True, check=True).stdout
        printed += [float(number) for number in re.findall(r"[\d.]+(?= Pa)", out)]
    assert printed == pytest.approx([run["tank.pressure"][-1] for run in (held, smaller)], rel=1e-4)


def test_c_block_of_the_controller_gives_the_commands_of_the_program(tmp_path):
    """The block calls the controller eleven times, with another gain than that of the circuit."""
    circuit = load(ROOT / "examples" / "pressure_control.toml")
    files = c_controller(circuit, name="regulator", precision="single")
    (block,) = (text for text in blocks(TEXTS["docs/export_c.md"], "c") if "regulator.h" in text)
    library = {name: text for name, text in files.items() if not name.endswith("host.c")}
    program = compile_c(library | {"own.c": block}, tmp_path, "-std=c99", "-O0")
    out = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    traced = controller_program(circuit.with_values({"regulator.gain": 8e-5}))
    values = {"regulator.setpoint": 1.1e5, "regulator.measurement": 1.05e5}
    rows = [[values.get(item.address, item.value) for item in traced.inputs]] * 11
    known = dict(zip((output.address for output in traced.outputs), traced.run(rows).outputs[-1], strict=True))
    expected = [known["regulator.fill_command"], known["regulator.vent_command"]]
    assert [float(number) for number in re.findall(r"[\d.]+", out)] == pytest.approx(expected, rel=1e-4)
    assert 0.0 < expected[0] < 1.0


def test_ways_to_write_a_value_are_one_value():
    """Lines of the sketch are alternatives, so that they are no file together."""
    (sketch,) = re.findall(r"^```toml sketch\n(.*?)^```$", TEXTS["docs/circuit_file.md"], re.MULTILINE | re.DOTALL)
    volumes = [Chamber(**tomllib.loads(line)).volume for line in sketch.splitlines()]
    assert [volume.value for volume in volumes] == pytest.approx([0.2] * 3)


RUN = {"python", "toml", "console", "c"}
"""Languages of blocks that run, load or are understood below; cells of notebooks run in `test_first_hours.py`."""
NOT_RUN = {"output", "sketch"}
"""What a block is that nobody can run: printed by a program (test_commands_of_pages.py), a formula or drawing."""


SITE = ROOT / "website" / "pages"
MADE = ("reference/", "gallery/", "validation")
"""Pages of the site that its build makes."""


def is_right(page: Path, directive: str, argument: str, inside: str) -> bool:
    """Whether what a page asks of the site's builder can be had."""
    lines = [line for line in inside.splitlines() if line and not line.startswith(":")]
    if directive == "code-cell":  # run by test_first_hours.py
        return page.parent.name == "first_hours" and argument == "ipython3"
    if directive == "toctree":
        names = [re.sub(r".*<(.*)>", r"\1", line) for line in lines]
        places = [(page.parent / name).relative_to(SITE).as_posix() for name in names]
        return all((SITE / f"{p}.md").exists() or (ROOT / f"{p}.md").exists() or p.startswith(MADE) for p in places)
    return directive == "image" and (ROOT / argument).exists() and ":alt: " in inside


def test_every_block_is_run_or_says_why_not():
    for page in [*PAGES, *sorted(SITE.rglob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        for info, inside in re.findall(r"^```+([^`\n]*)\n(.*?)^```+$", text, re.MULTILINE | re.DOTALL):
            language, *more = info.split() or [""]
            directive = re.fullmatch(r"\{(.+)\}", language)
            is_known = is_right(page, directive[1], " ".join(more), inside) if directive else language in RUN
            assert is_known or NOT_RUN & {*more}, f"{page.name}: ```{info}"


def test_tables_of_files_are_toml():
    for page, text in TEXTS.items():
        for block in blocks(text, "toml"):
            assert tomllib.loads(block), page


def test_circuits_load():
    found = [(page, block) for page, text in TEXTS.items() for block in blocks(text, "toml")]
    circuits = [
        loads(block, name=page) for page, block in found if re.search('kind = "(chamber|cylinder|muscle)"', block)
    ]
    assert circuits
    assert [circuit.title for circuit in circuits if circuit.run.duration is None] == []


def resolve(name: str) -> Any:
    """The object of a dotted name."""
    parts = name.split(".")
    for cut in range(len(parts), 0, -1):
        try:
            found: Any = importlib.import_module(".".join(parts[:cut]))
        except ModuleNotFoundError:
            continue
        for attribute in parts[cut:]:
            found = getattr(found, attribute)
        return found
    raise ModuleNotFoundError(name)


NAMES = sorted({name for text in TEXTS.values() for name in re.findall(r"`(poppet(?:\.[A-Za-z_]\w*)+)`", text)})


def test_code_that_is_named_exists():
    assert [name for name in NAMES if resolve(name) is None] == []


SHELLS = {"", "sh", "bash", "shell", "console", "text"}


def shell_lines(text: str) -> list[str]:
    """Lines of shell blocks, continued ones joined, without prompts and comments."""
    found = []
    for language, block in re.findall(r"^```(\w*)[^\n]*\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        lines = block.replace("\\\n", " ").splitlines() if language in SHELLS else []
        found += [re.sub(r"(^|\s)#.*$", "", line.strip().removeprefix("$ ")).strip() for line in lines]
    return found


def named(first: str) -> list[tuple[str, str]]:
    """Page and command line, for every line of a shell block or `inline code` that begins with a word."""
    return [
        (page, line)
        for page, text in TEXTS.items()
        for line in dict.fromkeys([*shell_lines(text), *re.findall(rf"`({first} [^`\n]+)`", text)])
        if line.startswith(f"{first} ")
    ]


def is_form(line: str) -> bool:
    """A general form, `poppet simulate FILE [--plot PNG]`, not a command to be typed."""
    return bool(re.search(r"[\[\]|<>]|\.\.\.|…|\bFILE\b|\bADDRESS\b|\bVALUE\b|\bNAME\b|\bCOMMAND\b", line))


def test_command_lines_are_understood():
    typed = [(page, line) for page, line in named("poppet") if not is_form(line)]
    assert any(page == "README.md" and line.startswith("poppet simulate") for page, line in typed)
    for page, line in typed:
        name, arguments = split_command(shlex.split(re.split(r" (?:&&|>|\|) ", line)[0])[1:])
        assert name in (*COMMANDS, "--help", "--version"), f"{page}: {line}"
        if name in COMMANDS and arguments and "--help" not in arguments:  # a bare name is spoken about, not typed
            command_parser(name).read(arguments)


def test_every_option_is_documented():
    missing = []
    for name in COMMANDS:
        found = re.search(rf"^## `poppet {name}\b.*?\n(?=^## |\Z)", TEXTS["docs/cli.md"], re.MULTILINE | re.DOTALL)
        options = {option for option in command_parser(name)._option_string_actions if option.startswith("--")}
        missing += [f"{name} {o}" for o in sorted(options - {"--help", "--quiet"}) if not found or o not in found[0]]
    assert missing == []


def test_tables_of_options_come_from_the_declarations():
    with_tables = runpy.run_path(str(ROOT / "tools" / "command_tables.py"))["with_tables"]
    assert with_tables(TEXTS["docs/cli.md"]) == TEXTS["docs/cli.md"]


def test_examples_are_listed():
    names = [path.name for path in sorted((ROOT / "examples").glob("*.toml"))]
    assert [n for n in names if f"poppet simulate examples/{n}" not in TEXTS["examples/README.md"]] == []


def test_python_example_runs(capsys):
    runpy.run_path(str(ROOT / "examples" / "first_steps.py"))
    assert "highest pressure" in capsys.readouterr().out


def test_fit_example_runs(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(ROOT / "examples" / "fit_circuit.py"))
    assert "95 % confidence interval" in capsys.readouterr().out
    assert (tmp_path / "fit_result.toml").exists()


def test_make_targets_exist():
    """Every `make ...` that a page names is a target."""
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    words = {
        word
        for _, line in named("make")
        for word in shlex.split(line)[1:]
        if "=" not in word and not word.startswith("-")
    }
    assert words <= targets
    assert {"demo", "test"} <= words
