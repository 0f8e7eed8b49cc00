"""Compare two checkouts: do the examples and the demo still give the same numbers, to twelve digits?

    python tools/compare_states.py OLD NEW [-o table.md] [--only NAME]

Each job runs with both checkouts, each with its own `src` and its own `examples`. Only what users see is used: the
command line, the files that it writes, and the scripts in `examples`. Numbers decide; words may change and are counted.
Both checkouts must rest meanwhile. Recordings that are not part of the repository are taken from `shared` beside either
checkout; without them their jobs are left out. One checkout takes about three minutes of a processor.
"""

from __future__ import annotations

import argparse
import html
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from itertools import chain, repeat, zip_longest
from pathlib import Path
from typing import Any, NamedTuple

LIMIT = 1e-12
PATIENCE = 600.0
"""Seconds for one command."""
SHOWN = 5
"""Differences of one job, of numbers and of words, that are written out below the table."""


class Job:
    """Commands that run one after the other in `examples`; {out} is the folder of their results.

    With a pattern of `files` it is one job, with its {file} and {example}, for each file of the old state that has the
    table; {example} is its path without the suffix.
    """

    def __init__(self, name: str, *commands: str, files: str = "", table: str = "", needs_shared: bool = False) -> None:
        self.name, self.commands, self.needs_shared = name, commands, needs_shared
        self.files, self.table = files, table


STAIRS = "poppet simulate fill_staircase.toml"
FIT = "poppet identify fit identify/fit.toml"
BENCH = "poppet bench iso10094 bench/valve.toml -o {out}/result.toml --report {out}/report.html --tests"
TUNE = "poppet control tune pressure_control.toml"
RIVALS = "pressure_control.toml pressure_control_scheduled.toml pressure_control_linearising.toml"
# One fit of six, since all of them are jobs of their own; here it is the linear models beside it that count.
BASELINES = "import sys; sys.path[0] = 'regulators'; import compare; print(compare.compare('fit_test_lung_5.toml')[0])"
WAY = "poppet identify {0} identify/{0}.toml -o {{out}}/{0}.json --report {{out}}/{0}.html"
JOBS = (
    Job("paper", "poppet paper -o {out}"),
    Job("simulate {example}", "poppet simulate {file} -o {out}/run.csv", files="**/*.toml", table="parts"),
    Job("linearise {example}", "poppet linearise {file} -o {out}/model.json", files="**/*.toml", table="parts"),
    Job("simulate, helium", "poppet simulate two_tanks.toml --set gas.name=helium -o {out}/run.csv"),
    Job("show {example}", "poppet show {file} --json", files="*.toml", table="parts"),
    Job("show as text", "poppet show pressure_regulator.toml", "poppet show fill_staircase.toml --kind assumed"),
    Job("check", f"poppet check {RIVALS} datasheet_valve.toml pressure_regulator.toml two_tanks.toml"),
    Job(
        "draw and plot",  # of pictures, only that they are drawn
        "poppet draw two_tanks.toml -o {out}/circuit.svg",
        "poppet simulate two_tanks.toml -o {out}/run.csv",
        "poppet plot {out}/run.csv -o {out}/run.svg",
    ),
    Job(
        "simulate, options",
        f'{STAIRS} --set tank.volume="0.1 m^3" --stop-when "tank.pressure > 2 bar" --units "bar,degC" -o {{out}}/a.csv',
        f'{STAIRS} --tolerance 1e-8 --duration "30 s" -o {{out}}/b.csv',
        f'{STAIRS} --start-from {{out}}/b.csv --select "tank.*" -o {{out}}/c.csv',
    ),
    Job(
        "identify fit, intervals",
        f"{FIT} --profile outlet.critical_ratio --bootstrap 10 -o {{out}}/fit.toml --report {{out}}/fit.html",
        "poppet simulate identify/bench.toml --with {out}/fit.toml -o {out}/run.csv",
    ),
    Job("identify fit, rival", f"{FIT} --compare identify/fit_adiabatic.toml -o {{out}}/fit.json"),
    Job("identify tank", WAY.format("tank")),
    Job("identify flow", WAY.format("flow")),
    Job("identify characteristic", WAY.format("characteristic") + " --library {out}/library.toml"),
    Job(
        "{example}",
        "poppet identify fit {file} -o {out}/fit.json --report {out}/fit.html",
        files="regulators/fit_*.toml",
        table="recordings",
        needs_shared=True,
    ),
    Job("regulators/compare.py", f'python -c "{BASELINES}"', needs_shared=True),
    Job("bench, static", f"{BENCH} characteristic,resolution,flow,supply,leakage"),
    Job("bench, step", f"{BENCH} step"),
    Job("bench, frequency", f'{BENCH} frequency --frequencies "0.5 Hz, 1 Hz, 2 Hz, 4 Hz, 8 Hz"'),
    Job("bench, main stage", "poppet bench iso10094 bleed_regulator.toml --tests step -o {out}/result.json"),
    Job(
        "bench, recordings",
        "poppet bench iso10094 --recording bench/recordings.toml -o {out}/result.json --report {out}/report.html",
    ),
    Job(
        "bench limits",
        'poppet bench limits pressure_regulator.toml --mean "4 bar" --volumes "1 l" --amplitudes "50 kPa" --springs 1'
        " --dampings 1 -o {out}/limits.toml --report {out}/limits.html",
    ),
    Job(
        "control tune",
        f"{TUNE} --form pid --sensitivity 1.6 -o {{out}}/pid.toml",
        f'{TUNE} --schedule --at "2 bar" --at "5 bar" -o {{out}}/schedule.toml',
    ),
    Job("control compare", f'poppet control compare {RIVALS} --vary tank.volume="20 %" --draws 8 -o {{out}}/all.csv'),
    Job(
        "convert",
        'poppet convert "6 bar g" --to psi --ambient "1.013 bar"',
        'poppet convert "1.2 Kv" --to C --critical-ratio 0.35',
        'poppet convert "1.2 Cv" --to area',
        'poppet convert "380 l/min ANR" --to C',
        'poppet convert "2e-8 m^3/(s Pa)" --to qNn',
        'poppet convert "21 degC" --to K',
    ),
    Job("library", *(f"poppet library {name}" for name in ("", "gases", "air", "varga2012", "vppm_6l"))),
    Job("schema", "poppet schema -o {out}/schema.json"),
    Job("new", *(f"poppet new {name} -o {{out}}/{name}.toml" for name in ("valve-fill", "pressure-regulator"))),
    Job("first_steps.py", "python first_steps.py"),
    Job("identify/make_data.py", "python identify/make_data.py {out}"),
    Job("bench/make_data.py", "python bench/make_data.py {out}"),
)

# A number does not start within a word: the digits of p2 and vppm_6l belong to the words.
NUMBER = re.compile(r"(?<!\w)(?<!\d\.)[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
# What is no result: versions, and dates with a time of day. Durations are not printed; random numbers are seeded.
NO_RESULT = re.compile(r"\b\d+(?:\.\d+){2,}[\w.+]*|\b\d{4}-\d\d-\d\d[T ]\d\d:\d\d[\d:.Z]*")
# Drawings repeat, rounded to the picture, the numbers of tables and recordings.
DRAWN = re.compile(r"<(svg|style|script)\b.*?</\1>", re.DOTALL)
BLOCK = re.compile(r"</?(?:body|div|figure|h\d|li|p|section|table|tr|ul)\b[^>]*>")
READ = {".csv", ".html", ".json", ".toml", ".txt"}


class Line(NamedTuple):
    """A line of text, its words apart from its numbers."""

    words: str
    numbers: tuple[float, ...]
    place: int


@dataclass
class Finding:
    """What the comparison of one job found."""

    count: int = 0
    precise: int = 0
    """Numbers that are written with twelve digits or more; the others show only what they are rounded to."""
    changed: int = 0
    """Numbers that are not exactly the same."""
    greatest: float = 0.0
    """Relative difference; infinite where a number has no partner."""
    added: int = 0
    """Numbers in sentences that only the new state writes: more is said, and nothing otherwise."""
    lines: int = 0
    """Lines whose words differ."""
    numbers: list[tuple[float, str]] = field(default_factory=list)
    """The greatest differences with what was and what is."""
    wordings: list[str] = field(default_factory=list)

    def differs(self, size: float, text: str) -> None:
        """Note a number that is not the same."""
        self.changed += 1
        self.greatest = max(self.greatest, size)
        self.numbers = sorted([*self.numbers, (size, text)], reverse=True)[:SHOWN]

    def see(self, where: str, old: list[Line], new: list[Line], floors: list[float]) -> None:
        """Compare lines that belong together."""
        where = f"{where}, line {(old or new)[0].place}"
        was, now = (" / ".join(line.words for line in lines)[:100] for lines in (old, new))
        if [line.words for line in old] != [line.words for line in new]:
            self.lines += max(len(old), len(new))
            self.wordings.append(f"{where}: `{was}` -> `{now}`")
        before, after = ([number for line in lines for number in line.numbers] for lines in (old, new))
        is_said = any(map(str.isalpha, now)) and ".csv" not in where  # a row or an element more is another result
        if not old and is_said:
            self.added += len(after)
            return
        self.count += max(len(before), len(after))
        self.precise += sum(sum(map(str.isdigit, f"{a!r}".split("e")[0].lstrip("-0."))) >= 12 for a in before)
        if len(before) != len(after):
            self.differs(math.inf, f"{where}: {len(before)} -> {len(after)} numbers in `{was or now}`")
            return
        for k, (a, b, floor) in enumerate(zip(before, after, chain(floors, repeat(0.0)), strict=False), 1):
            if a != b:
                self.differs(difference(a, b, floor), f"{where}: {a!r} -> {b!r}, number {k} in `{was}`")


def difference(a: float, b: float, floor: float) -> float:
    """Relative to the larger one; what is below the floor counts relative to the largest number of its column."""
    gap = abs(a - b)
    if not math.isfinite(gap):
        return math.inf
    return gap / max(abs(a), abs(b)) if gap > floor else LIMIT * gap / floor


def lines_of(name: str, text: str) -> list[Line]:
    """Lines that say something."""
    if name.endswith(".json") and text:
        text = json.dumps(json.loads(text), indent=1)  # one number per line, however it was written
    if name.endswith(".html"):
        text = html.unescape(re.sub(r"<[^>]*>", " ", BLOCK.sub("\n", DRAWN.sub("", text))))
    lines = []
    for place, line in enumerate(text.replace("\N{MINUS SIGN}", "-").splitlines(), 1):
        kept = NO_RESULT.sub("*", " ".join(line.split()))
        if kept:
            lines.append(Line(NUMBER.sub("#", kept), tuple(map(float, NUMBER.findall(kept))), place))
    return lines


def floors_of(name: str, lines: list[Line]) -> list[float]:
    """Of recordings, by column: rounding noise about zero is no difference. Other tables mix quantities in a column."""
    if not (name.endswith(".csv") and lines and lines[0].words.startswith("time")):
        return []
    columns = zip_longest(*(line.numbers for line in lines[1:]), fillvalue=0.0)
    return [LIMIT * max(map(abs, column)) for column in columns]


def matched(name: str, old: list[Line], new: list[Line]) -> Iterator[tuple[list[Line], list[Line]]]:
    """Lines that belong together: by place in tables, else by words, so that an added line shifts nothing."""
    before, after = [line.words for line in old], [line.words for line in new]
    if before == after or name.endswith(".csv"):
        for a, b in zip_longest(old, new):
            yield [a] if a else [], [b] if b else []
        return
    for kind, i, j, k, m in SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        if kind == "equal":
            yield from (([a], [b]) for a, b in zip(old[i:j], new[k:m], strict=True))
        else:
            yield old[i:j], new[k:m]


def compare(old: dict[str, str], new: dict[str, str]) -> Finding:
    """Outputs of both states by their names."""
    finding = Finding()
    for name in sorted(old.keys() | new.keys()):
        before, after = lines_of(name, old.get(name, "")), lines_of(name, new.get(name, ""))
        floors = floors_of(name, before)
        for a, b in matched(name, before, after):
            finding.see(name, a, b, floors)
    return finding


class State:
    """A checkout, and the folder in which its jobs run."""

    def __init__(self, checkout: Path, folder: Path) -> None:
        self.checkout, self.folder = checkout.resolve(), folder
        # A copy: the results say nothing of where the checkout lies, and nothing is written into it.
        shutil.copytree(self.checkout / "examples", folder / "examples")
        # A cache of its own: code that the other state compiled would hide a compiler that went wrong.
        own = {"PYTHONPATH": str(self.checkout / "src"), "POPPET_CACHE_DIR": str(folder / "cache")}
        # Sums do not depend on how many processors are free, nor sets on the process.
        same = {"PYTHONHASHSEED": "0", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "COLUMNS": "200"}
        self.environment = os.environ | own | same
        found = self.run("python -c 'import poppet; print(poppet.__file__)'").stdout.strip()
        if not found.startswith(own["PYTHONPATH"] + os.sep):
            raise SystemExit(f"{checkout}: poppet is imported from {found or 'nowhere'}, not from its src folder.")
        git = ("git", "--no-optional-locks", "-C", str(self.checkout), "describe", "--always", "--dirty")
        self.label = subprocess.run(git, capture_output=True, text=True).stdout.strip() or "no commit"

    def run(self, command: str) -> subprocess.CompletedProcess[str]:
        """Run a command with the interpreter that runs this script."""
        program, *words = shlex.split(command)
        line = [sys.executable, *(["-m", "poppet"] if program == "poppet" else []), *words]
        place = self.folder / "examples"
        streams: dict[str, Any] = {"capture_output": True, "encoding": "utf-8", "timeout": PATIENCE}
        try:
            return subprocess.run(line, cwd=place, env=self.environment, **streams)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(line, 124, "", "")

    def results(self, job: Job) -> tuple[str, dict[str, str]]:
        """Exit codes, and all that the commands wrote, by name."""
        out = self.folder / "out" / re.sub(r"\W+", "_", job.name)
        out.mkdir(parents=True)
        done = [self.run(command.replace("{out}", f"../out/{out.name}")) for command in job.commands]
        texts = {f"stdout {k}": run.stdout for k, run in enumerate(done, 1)}
        texts |= {f"stderr {k}": run.stderr for k, run in enumerate(done, 1)}
        files = sorted(path for path in out.rglob("*") if path.is_file())
        texts["files"] = "\n".join(str(path.relative_to(out)) for path in files)
        texts |= {str(path.relative_to(out)): path.read_text("utf-8") for path in files if path.suffix in READ}
        for place in (self.folder, self.checkout):
            texts = {name: text.replace(str(place), "") for name, text in texts.items()}
        return " ".join(str(run.returncode) for run in done), texts


def jobs_of(examples: Path, only: str, has_shared: bool) -> Iterator[Job]:
    """The jobs, written out for the examples that are there."""
    for job in JOBS:
        if job.needs_shared and not has_shared:
            print(f"{job.name}: left out, its recordings are not there.", file=sys.stderr)
            continue
        paths = sorted(examples.glob(job.files)) if job.files else []
        fitting = [path for path in paths if job.table in tomllib.loads(path.read_text("utf-8"))]
        files = [path.relative_to(examples).as_posix() for path in fitting] if job.files else [""]
        for file in files:
            values = {"file": file, "example": file.removesuffix(".toml"), "out": "{out}"}
            name, *commands = (text.format_map(values) for text in (job.name, *job.commands))
            if only in name:
                yield Job(name, *commands)


def run_all(old: State, new: State, jobs: list[Job]) -> tuple[list[str], bool]:
    """Run and compare: the report, and whether all is the same."""
    report: list[str] = []

    def say(*lines: str) -> None:
        report.extend(lines)
        print("\n".join(lines), flush=True)

    say(f"Old: {old.label}. New: {new.label}.", "")
    say("| job | exit old | exit new | numbers | of 12 digits | changed | greatest difference | agree | same words |")
    say("|---" * 9 + "|")
    total, details, failed, wrong, reworded = Finding(), [], 0, 0, 0
    for k, job in enumerate(jobs, 1):
        began = time.monotonic()
        (old_exit, before), (new_exit, after) = old.results(job), new.results(job)
        print(f"[{k}/{len(jobs)}] {job.name}: {time.monotonic() - began:.1f} s for both", file=sys.stderr)
        found = compare(before, after)
        agrees = found.greatest <= LIMIT
        words = f"no ({found.lines} lines differ, with {found.added} more numbers)" if found.lines else "yes"
        cells = job.name, old_exit, new_exit, found.count, found.precise, found.changed, f"{found.greatest:.1e}"
        say(f"| {' | '.join(map(str, cells))} | {'yes' if agrees else 'NO'} | {words} |")
        failed += old_exit == new_exit and old_exit.strip("0 ") != ""
        wrong += not agrees or old_exit != new_exit
        reworded += found.lines > 0
        total.added += found.added
        total.count, total.precise = total.count + found.count, total.precise + found.precise
        total.changed, total.greatest = total.changed + found.changed, max(total.greatest, found.greatest)
        shown = [text for _, text in found.numbers] + found.wordings[:SHOWN]
        details += [f"- {job.name}, {text}" for text in shown]
    say(
        f"\n{len(jobs)} jobs, {failed} of them with the same error in both. {total.count} numbers, {total.precise} of"
        f" them of 12 digits or more, {total.changed} changed, greatest relative difference {total.greatest:.1e}."
        f" Other words in {reworded} jobs, {total.added} numbers in added lines; other numbers or exit"
        f" codes in {wrong} jobs: **{'NOT the same' if wrong else 'the same to 12 digits'}**."
    )
    if details:
        say("\nGreatest differences, and other words, of each job:\n", *details)
    return report, not wrong


def main() -> int:
    """Run the jobs of both states; 0 if they agree, 1 if not."""
    parser = argparse.ArgumentParser(description="Do two checkouts give the same numbers?")
    parser.add_argument("old", type=Path, help="checkout of the last state")
    parser.add_argument("new", type=Path, help="checkout of the new state")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write the table, Markdown")
    parser.add_argument("--only", default="", metavar="NAME", help="jobs whose name contains NAME")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        places = [state.resolve().parent / "shared" for state in (given.old, given.new)]
        shared = [place for place in places if (place / "data").is_dir()]
        if shared:
            (folder / "shared").symlink_to(shared[0])
        old, new = State(given.old, folder / "old"), State(given.new, folder / "new")
        jobs = list(jobs_of(old.folder / "examples", given.only, bool(shared)))
        if not jobs:
            parser.error(f"no job has {given.only!r} in its name")
        report, same = run_all(old, new, jobs)
    if given.output:
        given.output.write_text("\n".join(report) + "\n", encoding="utf-8")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
