"""`poppet watch`: baseline, recordings, lines on the standard input, and invalid input."""

from __future__ import annotations

import csv
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from poppet.cli import main
from poppet.cli.progress import FractionProgress

EXAMPLES = Path(__file__).parents[2] / "examples" / "watch"
COLUMNS = [
    "time [s]",
    *("leak [m^3/(s Pa)]", "leak.sigma", "leak.probability"),
    *("valve_clogged [m^3/(s Pa)]", "valve_clogged.sigma", "valve_clogged.probability"),
    *("supply_low [Pa]", "supply_low.sigma", "supply_low.probability"),
    *("nis", "alarm"),
]
HEADING = b"t,p,u,w\n"
HEALTHY_ROWS = [line.encode() for line in (EXAMPLES / "healthy.csv").read_text().splitlines(keepends=True)[1:60]]


@pytest.fixture
def folder(tmp_path):
    """A folder with the files of the example."""
    for file in EXAMPLES.iterdir():
        shutil.copy(file, tmp_path)
    return tmp_path


@pytest.fixture
def watch(poppet, folder, monkeypatch):
    """Run the command with the twin file and lines on the standard input."""

    def run(*arguments, lines=()):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"".join(lines))))
        return poppet("watch", "twin.toml", *arguments)

    return run


def states(answer):
    """Return the JSON lines of an answer."""
    return [json.loads(line) for line in answer.out.splitlines()]


def test_the_leak_of_the_example_is_found(watch, folder):
    answer = watch("--recording", "day.csv", "-o", "states.csv")
    assert answer.code == 0
    rows = list(csv.DictReader(io.StringIO((folder / "states.csv").read_text())))
    assert list(rows[0]) == COLUMNS
    assert len(rows) == 3000
    alarms = [(float(row["time [s]"]), row["alarm"]) for row in rows if row["alarm"]]
    assert all("leak" in alarm.split(" or ") for _, alarm in alarms)
    assert 200.0 < alarms[0][0] < 208.0
    assert {alarm for time, alarm in alarms if time > 220.0} == {"leak"}
    # The leak of the script that simulated the recording: 1 % of the valve more than in the circuit.
    last = rows[-1]
    leak, sigma = float(last["leak [m^3/(s Pa)]"]), float(last["leak.sigma"])
    assert abs(leak - 1.2e-10) < 4.0 * sigma
    assert sigma < 1e-11
    assert float(last["leak.probability"]) > 0.9


def test_lines_give_the_same_rows_as_a_recording(watch, folder):
    rows = (folder / "day.csv").read_bytes().splitlines(keepends=True)[:400]
    (folder / "short.csv").write_bytes(b"".join(rows))
    answer = watch(lines=rows)
    assert answer.code == 0
    assert [list(state) for state in states(answer)] == [COLUMNS] * 399
    watch("--recording", "short.csv", "-o", "states.csv")
    written = list(csv.DictReader(io.StringIO((folder / "states.csv").read_text())))
    for state, row in zip(states(answer), written, strict=True):
        numbers = [float(row[column]) if row[column] else None for column in COLUMNS[:-1]]
        assert [state[column] for column in COLUMNS[:-1]] == numbers


def test_json_lines(watch):
    rows = [dict(zip("tpuw", map(float, line.decode().split(",")), strict=True)) for line in HEALTHY_ROWS]
    answer = watch(lines=[json.dumps(row).encode() + b"\n" for row in rows])
    assert [state["time [s]"] for state in states(answer)] == [row["t"] for row in rows]


def test_commissioning_writes_the_baseline(watch, folder):
    before = (folder / "healthy.toml").read_bytes()
    refusal = watch("--commission", "healthy.csv")
    assert (refusal.code, refusal.codes) == (2, ["twin.baseline_exists"])
    assert (folder / "healthy.toml").read_bytes() == before
    answer = watch("--commission", "healthy.csv", "--force")
    assert answer.code == 0
    # The example is the result of this command, except for rounding.
    example, written = tomllib.loads(before.decode()), tomllib.loads((folder / "healthy.toml").read_text())
    assert written["circuit"] == example["circuit"]
    for name, number in example["numbers"].items():
        assert abs(written["numbers"][name]["value"] - number["value"]) < 0.1 * number["sigma"], name


@pytest.mark.parametrize("name", ["twin.toml", "tank.toml", "healthy.csv"])
def test_commissioning_replaces_no_other_file(watch, folder, name):
    text = (folder / "twin.toml").read_text().replace('"healthy.toml"', f'"{name}"')
    (folder / "twin.toml").write_text(text)
    before = (folder / name).read_bytes()
    refusal = watch("--commission", "healthy.csv", "--force")
    assert (refusal.code, refusal.codes) == (2, ["twin.no_baseline_file"])
    assert (folder / name).read_bytes() == before


def test_without_a_baseline_nothing_is_watched(watch, folder):
    (folder / "healthy.toml").unlink()
    for arguments in ((), ("--recording", "day.csv")):
        refusal = watch(*arguments, lines=[HEADING, *HEALTHY_ROWS])
        assert (refusal.code, refusal.codes, refusal.out) == (2, ["baseline.no_file"], "")


def test_isolable_needs_neither_data_nor_a_baseline(watch, folder):
    (folder / "healthy.toml").unlink()
    answer = watch("--isolable")
    assert answer.code == 0
    assert [name for name in ("leak", "valve_clogged", "supply_low") if name not in answer.out] == []


@pytest.mark.parametrize("option", [("-o", "states.csv"), ("--report", "day.html")])
def test_files_need_a_recording(watch, option):
    refusal = watch(*option, lines=[HEADING])
    assert (refusal.code, refusal.codes) == (2, ["twin.needs_recording"])


@pytest.mark.parametrize(
    "options",
    [
        ("--commission", "healthy.csv", "--force", "--recording", "day.csv"),
        ("--commission", "healthy.csv", "--force", "--isolable"),
        ("--commission", "healthy.csv", "--force", "--report", "day.html"),
        ("--isolable", "--recording", "day.csv", "-o", "states.csv"),
    ],
)
def test_an_option_of_another_task_is_refused(watch, folder, options):
    before = (folder / "healthy.toml").read_bytes()
    refusal = watch(*options)
    assert (refusal.code, refusal.codes, refusal.out) == (2, ["twin.idle_option"], "")
    assert (folder / "healthy.toml").read_bytes() == before


def test_an_output_does_not_replace_the_twin_file(watch, folder):
    shutil.copy(folder / "day.csv", folder / "twin.csv")
    refusal = watch("--recording", "day.csv", "-o", "day.csv")
    assert (refusal.code, refusal.codes) == (2, ["cli.output.taken"])


@pytest.mark.parametrize(
    ("heading", "code"), [(b"t,pressure,u,w\n", "stream.no_column"), (b"t,p [mbar],u,w\n", "stream.other_unit")]
)
def test_columns_of_the_first_heading_are_checked(watch, folder, heading, code):
    refusal = watch(lines=[heading, *HEALTHY_ROWS])
    assert (refusal.code, refusal.codes) == (2, [code])
    (folder / "other.csv").write_bytes(heading + b"".join(HEALTHY_ROWS))
    refusal = watch("--recording", "other.csv")
    assert (refusal.code, refusal.codes) == (2, [code])


GARBAGE = {
    "words": [b"hello\n"] * 200,
    "open object": [b'{"t": 1, "p": \n'] * 200,
    "deep object": [b'{"t": ' + b"[" * 5000 + b"\n"] * 3,
    "text": [b"1.0,high,0.5,0.2\n"] * 3,
    "infinite": [b"1.0,inf,0.5,0.2\n", b'{"t": 1.0, "p": Infinity}\n', b"1.0,1e300,0.5,0\n"],
    "no time": [b",6.0,0.5,0.2\n", b'{"p": 6.0}\n', b'{"t": NaN}\n'],
    "bytes": [bytes(range(256)).replace(b"\n", b"") + b"\n"] * 5,
    "long": [b"x" * 3_000_000 + b"\n"],
    "short rows": [b"1.0,6.0\n"] * 5,
    "list": [b"[1, 2, 3]\n"],
}


@pytest.mark.parametrize("kind", GARBAGE)
def test_garbage_changes_nothing(watch, kind):
    clean = watch(lines=[HEADING, *HEALTHY_ROWS])
    answer = watch(lines=[HEADING, *HEALTHY_ROWS[:30], *GARBAGE[kind], *HEALTHY_ROWS[30:]])
    assert answer.code == 0
    assert answer.out == clean.out
    notes = answer.err.splitlines()
    # The first message of each kind, and the 10th and 100th; the summary counts all.
    assert 1 < len(notes) - len(clean.err.splitlines()) + 1 <= 5
    count = re.search(r"(\d+) message", notes[-1])
    assert int(count[1]) >= len(GARBAGE[kind])


@pytest.mark.parametrize("lines", [[], [HEADING], [HEADING, *[b"garbage\n"] * 100]], ids=["none", "heading", "garbage"])
def test_a_stream_without_samples_is_an_error(watch, lines):
    refusal = watch("--quiet", lines=lines)
    assert (refusal.code, refusal.error.code, refusal.error.facts["lines"]) == (2, "stream.nothing", len(lines))


def test_quiet_prints_the_lines_and_messages_on_invalid_input_only(watch):
    clean = watch(lines=[HEADING, *HEALTHY_ROWS])
    answer = watch("--quiet", lines=[HEADING, b"hello\n", *HEALTHY_ROWS])
    assert answer.out == clean.out
    assert answer.err.count("\n") == 1


def test_a_clock_that_is_set_back_keeps_the_estimates(watch):
    rows = [line.replace(line.split(b",")[0], b"%.1f" % (0.1 * k), 1) for k, line in enumerate(HEALTHY_ROWS[30:])]
    answer = watch(lines=[HEADING, *HEALTHY_ROWS[:30], *rows])
    times = [state["time [s]"] for state in states(answer)]
    assert times[30:] == pytest.approx([0.1 * k for k in range(2, len(rows))])
    assert states(answer)[30]["leak.sigma"] <= states(answer)[29]["leak.sigma"] * 1.01


def run_process(folder, **keywords):
    command = [sys.executable, "-m", "poppet", "watch", "twin.toml"]
    pipe = subprocess.PIPE
    return subprocess.Popen(command, cwd=folder, stdin=pipe, stdout=pipe, stderr=pipe, **keywords)


def test_each_line_is_answered_before_the_next(folder):
    with run_process(folder) as process:
        process.stdin.write(HEADING)
        for row in HEALTHY_ROWS[:3]:
            process.stdin.write(row)
            process.stdin.flush()
            assert list(json.loads(process.stdout.readline())) == COLUMNS
        process.stdin.close()
        assert process.wait(timeout=60.0) == 0


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_an_interrupted_stream_ends_with_130(folder):
    def accept_interrupts():
        # Processes in the background of a shell ignore this signal, also in their children.
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    with run_process(folder, preexec_fn=accept_interrupts) as process:
        process.stdin.write(HEADING + HEALTHY_ROWS[0])
        process.stdin.flush()
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=60.0) == main.INTERRUPTED
        assert b"Traceback" not in process.stderr.read()


def test_a_closed_output_ends_the_command(folder):
    with run_process(folder) as process:
        process.stdin.write(HEADING + HEALTHY_ROWS[0])
        process.stdin.flush()
        process.stdout.readline()
        process.stdout.close()
        process.stdin.write(b"".join(HEALTHY_ROWS[1:]))
        process.stdin.close()
        assert process.wait(timeout=60.0) == 0
        assert b"Traceback" not in process.stderr.read()


def test_an_interrupted_recording_keeps_its_rows(watch, folder, monkeypatch):
    def interrupt(_, fraction):
        if fraction > 0.1:
            raise KeyboardInterrupt

    monkeypatch.setattr(FractionProgress, "__call__", interrupt)
    answer = watch("--recording", "healthy.csv", "-o", "states.csv", "--report", "states.html")
    assert answer.code == main.INTERRUPTED
    rows = (folder / "states.csv").read_text().splitlines()
    assert f"contain the {len(rows) - 1} samples" in answer.err
    assert 200 < len(rows) < 2000
    assert (folder / "states.html").exists()


def test_a_terminal_is_told_what_to_write(poppet, folder, monkeypatch):
    class Terminal(io.BytesIO):
        def isatty(self):
            return True

    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(Terminal(HEADING + HEALTHY_ROWS[0])))
    answer = poppet("watch", "twin.toml")
    assert answer.code == 0
    assert [column for column in "tpuw" if column not in answer.err.splitlines()[0]] == []
