"""Every command that a page shows runs: page by page, in order, in a folder that has the examples.

A command that several pages show runs on the first of them, and again where a page goes on with what it writes.
"""

from __future__ import annotations

import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from poppet.cli import main
from poppet.identify.result import read_result
from result_keys import undocumented

pytest.importorskip("sphinx", reason="the pages of the site are made where the extra `docs` is installed")
import gallery_pages
import reference_pages
import validate
import validation_pages

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
NOT_RUN = {
    "pip install": "asks a network; tools/package.py installs what `make package` has built",
    "make": "`make test` runs this test; `make demo` is `poppet paper`, `make docs` is test_website.py",
    "CI=true make": "as `make test`",
    "python website/validate.py": "half an hour for all; tests/conventions/test_validation.py has the quick ones",
    "poppet edit": "runs until it is ended; tests/browser draws its tutorial",
    "poppet mcp": "waits for a client; tests/assist",
    "poppet serve": "runs until it is ended; tests/cli/test_serve.py",
    "python examples/serve/two_cylinders_client.py": "needs a served machine; tests/unit/serve/test_two_cylinders.py",
    "poppet ensemble ensemble.toml --scheduler": "needs a Dask scheduler on another machine",
}
"""How a command begins that no test runs, and why."""
SHORTER = (
    # Two full tests of a valve take 20 s each.
    (r"^(poppet bench iso10094 (?!--recording)\S+)(.*?)( --tests \S+)?$", r'\1\2 --tests leakage --volume "1 l"'),
    (r"^poppet (bench limits|control tune .*--amplitude) .*", ""),
    (r"^(poppet control compare .*) --draws 100", r"\1 --draws 3"),
    (r"^(poppet audit safety .*)$", r"\1 --samples 0"),
    (r"^(poppet ensemble .*) --runs 100000", r"\1 --runs 200"),
    (r"^(poppet size .*) --yield .*$", r"\1"),
)
"""What is shortened every day, and how; nothing: left to the slow test, which runs all as they are printed."""
OUTPUT = re.compile(r"^```text output\n(.*?)^```$", re.MULTILINE | re.DOTALL)
EXIT = {"poppet export": 2}
"""Exit codes other than 0: a command that is not complete lists what may follow."""
PLACEHOLDERS = {
    "FIT.toml": "identify/fit.toml",
    "OTHER.toml": "identify/fit_adiabatic.toml",
    "RECORDING.csv": "identify/tank_discharge.csv",
    "TESTS.toml": "identify/characteristic.toml",
    "DESIGN.toml": "identify/design.toml",
    "VALVE.toml": "bench/valve.toml",
    "MAP.toml": "bench/recordings.toml",
    "FILE.toml": "pressure_control.toml",
    "leak_survey.toml": "audit/leak_survey.toml",
    "pid.toml": "pressure_control.toml",
    "linearising.toml": "pressure_control_linearising.toml",
    "twin.toml": "watch/twin.toml",
}
"""Names that helps use for files of the reader, and examples that stand for them."""


def texts() -> dict[str, str]:
    """Pages with commands; of those that are made, one for each command and example."""
    files = [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        EXAMPLES / "README.md",
        *sorted((ROOT / "docs").glob("*.md")),
    ]
    files += sorted((ROOT / "website" / "pages").rglob("*.md"))
    found = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in files}
    for help_of in re.split(r"^## ", reference_pages.command_page(), flags=re.MULTILINE)[1:]:
        found[help_of.partition("\n")[0].strip("`")] = help_of
    found["validation"] = validation_pages.page(validate.kept())
    found |= {f"gallery/{path.stem}": gallery_pages.page(path, "") for path in sorted(EXAMPLES.glob("*.toml"))}
    return {page: text for page, text in found.items() if commands(text)}


def commands(text: str) -> list[str]:
    """Lines of terminals, and what stands in code and names a file of the examples, a set or a name to write."""
    terminal = r"^```console\n(?P<lines>.*?)^```$"
    inline = (
        r"`(?P<inline>(?:poppet|python) [^`\n]*(?:examples/|website/|library \w|schema -o|check valve.fmu)[^`\n]*)`"
    )
    found = []
    for match in re.finditer(f"{terminal}|{inline}", text, re.MULTILINE | re.DOTALL):
        lines = match["lines"].splitlines() if match["lines"] else [f"$ {match['inline']}"]
        found += [re.sub(r"\s+# .*$", "", line.removeprefix("$ ")) for line in lines if line.startswith("$ ")]
    return found


def why_not(command: str) -> str:
    """Why a command is not run, or nothing."""
    return next((why for begin, why in NOT_RUN.items() if command.startswith(begin)), "")


def written(command: str) -> set[str]:
    """Names of files that a command writes."""
    words = shlex.split(command)
    found = {
        words[at + 1] for at, word in enumerate(words[:-1]) if word in {"-o", "--report", "--plot", "--output-file"}
    }
    return found | ({f"{words[2]}.toml"} if words[1:2] == ["new"] and len(words) == 3 else set())


TEXTS = texts()


def chosen(page: str) -> list[str]:
    """Commands of a page without those that an earlier page has, unless the page goes on with their files or
    shows what they print."""
    pages = list(TEXTS)
    before = [] if OUTPUT.search(TEXTS[page]) else pages[: pages.index(page)]
    earlier = {command for name in before for command in commands(TEXTS[name])}
    found: list[str] = []
    for command in reversed(commands(TEXTS[page])):
        used = {name for later in found for name in written(command) if name in later}
        if not why_not(command) and (command not in earlier or used):
            found.insert(0, command)
    return found


def shortened(command: str) -> str:
    for pattern, short in SHORTER:
        command = re.sub(pattern, short, command)
    return command


@pytest.fixture
def reader(tmp_path, monkeypatch):
    """An empty folder with the examples, and what readers have made before."""
    pytest.importorskip("matplotlib", reason="commands draw")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]))
    shutil.copytree(EXAMPLES, "examples", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "docs" / "live").mkdir(parents=True)
    return tmp_path


def supply(commands: list[str]) -> None:
    """The files of the reader that commands name and none of them writes."""
    known = PLACEHOLDERS | {path.name: path.name for path in EXAMPLES.glob("*.toml")}
    made = set[str]()
    for command in commands:
        for name in set(shlex.split(command)) - made:
            if Path(name).exists():
                continue
            if name in {"valve-fill.toml", "two-tanks.toml", "machine.toml", "drive-sizing.toml"}:
                assert main.run(["new", name.removesuffix(".toml")]) == 0
            elif name in known:
                # Beside its recordings: what a file names is relative to it.
                shutil.copytree((EXAMPLES / known[name]).parent, ".", dirs_exist_ok=True)
                shutil.copy(EXAMPLES / known[name], name)
                if name == "twin.toml" and any("--commission" in line for line in commands):
                    Path("healthy.toml").unlink()  # a command writes it
            elif name in {"fill.csv", "measured.csv", "simulated.csv"}:
                assert main.run(["simulate", "examples/fill_staircase.toml", "-o", name, "--quiet"]) == 0
            elif name == "bench/*.toml":
                shutil.copytree(EXAMPLES / "bench", "bench", ignore=shutil.ignore_patterns("recordings*"))
        made |= written(command)


def run(command: str) -> None:
    """A line of a terminal: ours in this process, others in a shell."""
    first, *words = shlex.split(command)
    if first == "poppet":
        found = [name for word in words for name in (sorted(glob.glob(word)) if "*" in word else [word])]
        assert main.run(found) == EXIT.get(command, 0), command
    elif first == "python":
        print(subprocess.run([sys.executable, *words], check=True, capture_output=True, text=True).stdout)
    elif shutil.which(first):
        done = subprocess.run(["bash", "-ec", command], capture_output=True, text=True, check=False)
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    else:
        pytest.skip(f"not on this machine: {first}")


@pytest.mark.parametrize("page", [page for page in TEXTS if any(map(shortened, chosen(page)))])
def test_commands_run(reader, capsys, page):
    """And print what the page shows as printed."""
    # A valve that samples takes long: some rows show that its files run, tests/exact/test_identify_valve.py has all.
    for path in (reader / "examples" / "identify" / "valve").glob("[1-9]_*.toml"):
        path.write_text(path.read_text(encoding="utf-8").replace('until = "2 s"', 'until = "0.04 s"'), encoding="utf-8")
    found = [short for command in chosen(page) if (short := shortened(command))]
    check(page, found, reader, capsys)


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in TEXTS if any(shortened(c) != c for c in chosen(page))])
def test_commands_run_as_they_are_printed(reader, capsys, page):
    check(page, chosen(page), reader, capsys)


def check(page: str, found: list[str], reader: Path, capsys: pytest.CaptureFixture[str]) -> None:
    supply(found)
    capsys.readouterr()
    for command in found:
        run(command)
        for name in written(command):
            path = reader / name
            assert any(each.stat().st_size for each in (path.iterdir() if path.is_dir() else [path])), command
            # Tests that could be made are no result.
            if re.match(r"poppet identify (?!design)", command) and name.endswith(".toml"):
                assert undocumented(read_result(path)) == []
    printed = capsys.readouterr()
    said = (printed.out + printed.err).splitlines()
    shown = [line for block in OUTPUT.findall(TEXTS[page]) for line in block.splitlines()]
    assert [line for line in shown if not any(is_same(line, each) for each in said)] == []


NUMBER = re.compile(r"-?\b\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def is_same(shown: str, printed: str) -> bool:
    """The same words, and numbers within some per cent: the last digits are those of a machine."""
    if NUMBER.sub("", shown) != NUMBER.sub("", printed):
        return False
    numbers = [[float(n) for n in NUMBER.findall(text)] for text in (shown, printed)]
    return numbers[1] == pytest.approx(numbers[0], rel=0.05, abs=1e-13)


def test_what_is_not_run_is_shown_somewhere():
    shown = [command for text in TEXTS.values() for command in commands(text)]
    assert [begin for begin in NOT_RUN if not any(command.startswith(begin) for command in shown)] == []
    assert [pattern for pattern, _ in SHORTER if not any(re.search(pattern, command) for command in shown)] == []
