"""Tests of watches that are exported as C: the bits of Python, impossible readings, limits."""

from __future__ import annotations

import csv
import io
import random
import re
import shutil
import subprocess
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from c_compiler import COMPILER, STRICT, compile_c
from exact.independent_watch_tank import ONE_PERCENT, SAMPLE_TIME, random_openings, readings, simulate
from exported_watch_example import (
    FOLDER,
    bits_of,
    cylinder_watch,
    expected_rows,
    offset_watch,
    tank_watch,
)
from poppet.cli.main import run
from poppet.deploy.c.watch_project import watch_project
from poppet.deploy.exported_watch import check_watch
from refusals import refused
from watch_example import PLANT, SENSORS

SAME_BITS = ("-std=c99", "-O2", "-ffp-contract=off")


def host_of(source, folder, *options):
    """The example program of an exported watch."""
    return compile_c(watch_project(source, "tank"), folder, *(options or SAME_BITS))


@pytest.mark.parametrize(("make", "has_alarm"), [(offset_watch, False), (cylinder_watch, True)])
def test_the_example_program_has_the_bits_of_python(make, has_alarm, tmp_path):
    """The test vector of the cylinder has a fault, which the filter adopts."""
    said = subprocess.run([host_of(make(), tmp_path)], capture_output=True, text=True, check=True).stdout
    samples, same, alarms = map(int, re.match(r"(\d+) samples: (\d+) with.*, (\d+) with an alarm", said).groups())
    assert same == samples
    assert bool(alarms) == has_alarm, said


def test_a_recording_gives_the_bits_and_alarms_of_python(tmp_path):
    """The recording has missing readings and inputs, repeated and late times, and a gap."""
    source = tank_watch()
    lines = (FOLDER / "day.csv").read_text().splitlines()
    rows = [line.split(",") for line in lines[1:]]
    generator = random.Random(7)
    for before, row in reversed(list(pairwise(rows))):
        if generator.random() < 0.1:
            row[1] = ""
        if row[2:] == before[2:]:
            row[generator.randrange(2, 4)] = ""
        if generator.random() < 0.01:
            row[1] = "9.5"  # an outlier
    rows[1500][0] = rows[1499][0]
    del rows[400:800]
    recording = tmp_path / "recording.csv"
    recording.write_text("\n".join([lines[0], *map(",".join, rows)]))
    said = subprocess.run([host_of(source, tmp_path), recording], capture_output=True, text=True, check=True).stdout
    exported = list(csv.reader(io.StringIO(said)))[1:]
    expected = expected_rows(source, recording)
    assert len(exported) == len(expected) == len(rows)
    f = len(source.plan.faults)
    for cells, row in zip(exported, expected, strict=True):
        values = [float(cell) for cell in cells[1:-1]]
        assert values == [*np.ravel([row[:f], row[f : 2 * f]], order="F"), row[2 * f]], cells
        assert bits_of(cells[-1], source.plan) == row[-1], cells
    times = [float(cells[0]) for cells in exported if "leak" in cells[-1]]
    assert 200.0 < min(times) < 215.0


def test_faults_that_are_present_together_are_joined_by_and(tmp_path):
    """A leak, and a supply whose pressure falls 60 s later."""
    source, samples = tank_watch(), 2600
    time, openings = SAMPLE_TIME * np.arange(samples), np.round(random_openings(range(1), samples), 2)
    leak = np.where(time < 130.0, PLANT.leak, PLANT.leak + 1.5 * ONE_PERCENT)[np.newaxis]
    supply = np.where(time < 190.0, PLANT.supply_pressure, PLANT.supply_pressure - 0.6e5)[np.newaxis]
    pressure = readings(PLANT, simulate(PLANT, openings, leak, supply=supply), SENSORS, range(1))[0, :, 0] / 1e5
    recording = tmp_path / "recording.csv"
    columns = np.column_stack([time, pressure, openings[0]])
    np.savetxt(recording, columns, "%.6g", ",", header="t,p,u,w", comments="")
    said = subprocess.run([host_of(source, tmp_path), recording], capture_output=True, text=True, check=True).stdout
    alarms = {line.rsplit(",", 1)[1] for line in said.splitlines()}
    assert "leak and supply_low" in alarms
    assert "leak or supply_low" not in alarms


def test_a_late_sample_is_ignored(tmp_path):
    source = tank_watch()
    lines = (FOLDER / "healthy.csv").read_text().splitlines()[:100]
    host = host_of(source, tmp_path)
    paths = [tmp_path / "in_order.csv", tmp_path / "late.csv", tmp_path / "no_time.csv"]
    paths[0].write_text("\n".join(lines))
    paths[1].write_text("\n".join([*lines[:50], lines[10], *lines[50:]]))
    paths[2].write_text("\n".join([*lines[:50], ",4,0,0", *lines[50:]]))
    said = [subprocess.run([host, path], capture_output=True, text=True, check=True).stdout for path in paths]
    assert said[0] == said[1] == said[2]


def test_the_code_is_cpp_too(tmp_path):
    if not (compiler := shutil.which("g++") or shutil.which("clang++")):
        pytest.skip("there is no compiler of C++ on this machine")
    files = watch_project(tank_watch(), "tank")
    (tmp_path / "a.cpp").write_text('#include "tank.h"\nint main() { static tank_watch w; tank_init(&w); }\n')
    (tmp_path / "tank.h").write_text(files["tank.h"])
    subprocess.run([compiler, *STRICT, "-fsyntax-only", tmp_path / "a.cpp"], check=True)


GARBAGE = """
#include "tank.h"
#include <math.h>
#include <stdio.h>
static uint64_t bits = 88172645463325252ull;
static double random_number(void) {
  bits ^= bits << 13;
  bits ^= bits >> 7;
  bits ^= bits << 17;
  return (double)(bits >> 11) / 9007199254740992.0;
}
static double garbage(double usual) {
  const double choice = random_number();
  if (choice < 0.1) return NAN;
  if (choice < 0.2) return choice < 0.15 ? HUGE_VAL : -HUGE_VAL;
  if (choice < 0.4) return 1e300 * (random_number() - 0.5);
  if (choice < 0.5) return 1e15 * random_number();
  if (choice < 0.6) return choice < 0.55 ? 5e-324 : 0.0;
  return choice < 0.7 ? -usual : usual * (0.5 + random_number());
}
int main(void) {
  static tank_watch w;
  double t = 0.0;
  long count;
  int k;
  tank_init(&w);
  for (count = 0; count < 100000; count++) {
    double readings[TANK_CHANNELS], inputs[TANK_INPUTS], time;
    for (k = 0; k < TANK_CHANNELS; k++) readings[k] = garbage(5e5);
    for (k = 0; k < TANK_INPUTS; k++) inputs[k] = garbage(0.5);
    t += random_number() < 0.001 ? 100.0 : 0.1;
    time = random_number() < 0.01 ? -garbage(1.0) : t;
    if (time > t) time = t;
    (void)tank_update(&w, time, readings, random_number() < 0.1 ? 0 : inputs);
    for (k = 0; k < TANK_ESTIMATES * TANK_ESTIMATES; k++) {
      if (!isfinite(w.covariance[k]) || (k < TANK_ESTIMATES && !isfinite(w.mean[k]))) return 1;
    }
    for (k = 0; k < TANK_FREE; k++) {
      if (!(tank_sigma(&w, k) >= 0.0)) return 2;
    }
  }
  /* Possible readings again: the tank rests. */
  for (count = 0; count < 2000; count++) {
    const double reading[] = {5e5}, closed[] = {0.0, 0.0};
    t += 0.1;
    (void)tank_update(&w, t, reading, closed);
  }
  if (!(fabs(w.mean[0] - 5e5) < 5e3) || tank_alarm(&w) > TANK_FAULTS) return 3;
  puts("finite");
  return 0;
}
"""


def test_impossible_readings_leave_finite_estimates(tmp_path):
    """A hundred thousand samples of NaN, infinite, huge and tiny values, with sanitizers; then usual ones."""
    files = {k: v for k, v in watch_project(tank_watch(), "tank").items() if k.endswith((".h", ".c"))}
    del files["tank_host.c"]
    sanitizers = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    command = [str(COMPILER), *sanitizers, "-xc", "-", "-o", tmp_path / "probe"]
    probe = subprocess.run(command, input="int main(void) { return 0; }", text=True, capture_output=True, check=False)
    options = sanitizers if probe.returncode == 0 else ()
    program = compile_c({**files, "garbage.c": GARBAGE}, tmp_path, "-std=c99", "-O1", *options)
    run = subprocess.run([program], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout == "finite\n"


# Errors -----------------------------------------------------------------------------------------------------------


def test_a_delayed_input_is_rejected():
    plan = tank_watch().plan
    inputs = (plan.inputs[0], replace(plan.inputs[1], delay=0.05))
    with refused("deploy.watch.delay", f"measured.{inputs[1].address}", delay=0.05):
        check_watch(replace(plan, inputs=inputs))


def test_too_many_faults_are_rejected():
    plan = tank_watch().plan
    with refused("deploy.watch.faults", "faults", count=33, most=32):
        check_watch(replace(plan, faults=plan.faults * 11))


def test_the_command_writes_a_folder(tmp_path, capsys):
    twin = write_twin(tmp_path)
    assert run(["export", "c", str(twin), "-o", str(tmp_path / "out"), "--name", "pump"]) == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} >= {"pump.c", "pump.h", "pump_host.c", "CMakeLists.txt"}
    assert "6 files" in capsys.readouterr().out


def write_twin(folder):
    """Files of the twin with a baseline."""
    for name in ("twin.toml", "tank.toml"):
        (folder / name).write_text((FOLDER / name).read_text())
    tank_watch().baseline.save(folder / "healthy.toml")
    return folder / "twin.toml"


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["c", "-o", "out", "--set", "tank.volume=1"], "deploy.watch.option"),
        (["c", "-o", "out", "--substeps", "3"], "deploy.watch.option"),
        (["st"], "deploy.watch.target"),
        (["live", "-o", "out.html"], "deploy.watch.target"),
    ],
)
def test_unavailable_targets_and_options(arguments, code, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_twin(tmp_path)
    words = arguments if arguments[0] == "live" else ["export", *arguments]
    words.insert(2 if words[0] == "export" else 1, "twin.toml")
    assert run(words) == 2
    assert code in capsys.readouterr().err
    assert not list(tmp_path.glob("out*"))


def test_without_a_baseline_nothing_is_written(tmp_path, capsys):
    twin = write_twin(tmp_path)
    (tmp_path / "healthy.toml").unlink()
    assert run(["export", "c", str(twin), "-o", str(tmp_path / "out")]) == 2
    assert "baseline.no_file" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
