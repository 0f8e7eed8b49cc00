"""Fault table of the machine with two cylinders: each consequence against an independent simulation of the fault."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet.audit.fault_result import Consequence, FaultTable
from poppet.audit.fault_table import fault_table

sys.path.insert(0, str(Path(__file__).parent))
from independent_exhaust import AMBIENT, THRESHOLD, Fault, Plant, Run, simulate, two_cylinders

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
START, END = 0.3, 3.2
VALVES, WORDS = ("regulator", "valveA", "valveB"), ("stuck_open", "stuck_closed", "stuck", "slow", "leak")


@cache
def table() -> FaultTable:
    return fault_table(poppet.load(MACHINE), start=START)


@cache
def run_with(valve: str = "", word: str = "") -> Run:
    return simulate(two_cylinders(), END, fault=Fault(valve, word, START) if valve else None)


def facts_of(run: Run) -> set[str]:
    """Return what happens in a run as words, from the states of the independent simulation only."""
    healthy, facts = run_with(), set()
    names = [step for _, step in run.steps]
    if "fault" in names:
        facts |= {f"timeout of {names[names.index('fault') - 1]}", f"waits in {names[-1]}"}
    for drive, position in run.positions.items():
        late, usual = position[run.time >= START], healthy.positions[drive][run.time >= START]
        if late.max() < usual.max() - 1e-3 or late.min() > usual.min() + 1e-3:
            facts.add(f"not reached by {drive}")
    for volume, pressure in run.pressures.items():
        late, usual = pressure[run.time >= START], healthy.pressures[volume][run.time >= START]
        if usual.max() > THRESHOLD > late.max():
            facts.add(f"no pressure in {volume}")
    return facts


def test_every_single_fault_is_in_the_table() -> None:
    assert {row.fault for row in table().rows} == {f"{valve}.{word}" for valve in VALVES for word in WORDS}
    assert all(row.consequences for row in table().rows)


@pytest.mark.parametrize("valve", VALVES)
@pytest.mark.parametrize("word", WORDS)
def test_each_consequence_happens_in_the_independent_run(valve: str, word: str) -> None:
    row, run = table().row(f"{valve}.{word}"), run_with(valve, word)
    for consequence in row.consequences:
        check(consequence, run)
    has_fault_step = "fault" in [step for _, step in run.steps]
    assert row.stops_machine == (has_fault_step or len(run.steps) < len(run_with().steps))


@pytest.mark.parametrize("valve", VALVES)
@pytest.mark.parametrize("word", WORDS)
def test_the_table_misses_nothing_of_the_independent_run(valve: str, word: str) -> None:
    row, named = table().row(f"{valve}.{word}"), set()
    for item in row.consequences:
        if item.kind == "timed_out":
            named.add(f"timeout of {item.facts['step']}")
        elif item.kind == "waits":
            named.add(f"waits in {item.facts['step']}")
        elif item.kind == "not_reached":
            named.add(f"not reached by {item.address.removeprefix('slide')}")
        elif item.kind == "pressure_missing":
            named.add(f"no pressure in {item.address}")
    assert facts_of(run_with(valve, word)) <= named


def check(item: Consequence, run: Run) -> None:
    """Compare one consequence with the independent runs with and without the fault."""
    late = run.time >= START - 1e-9
    steps = {step: time for time, step in run.steps}
    drive = item.address.removeprefix("slide")
    match item.kind:
        case "timed_out":
            names = [step for _, step in run.steps]
            assert names[names.index(item.facts["target"]) - 1] == item.facts["step"]
            assert item.time == pytest.approx(steps[item.facts["target"]], abs=1e-6)
        case "waits":
            assert run.steps[-1][1] == item.facts["step"]
            assert item.time == pytest.approx(run.steps[-1][0], abs=1e-6)
            assert item.value == pytest.approx(END - run.steps[-1][0], abs=1e-6)
        case "diverts":
            assert (item.facts["step"], item.time) == next(
                (step, pytest.approx(time, abs=1e-6))
                for (time, step), (_, usual) in zip(run.steps, run_with().steps, strict=False)
                if step != usual
            )
        case "not_reached" | "overtravel":
            positions, usual = run.positions[drive][late], run_with().positions[drive][late]
            ends = [(positions.max(), usual.max()), (positions.min(), usual.min())]
            assert any(
                (item.value, item.healthy) == (pytest.approx(a, abs=1e-4), pytest.approx(b, abs=1e-4)) for a, b in ends
            )
        case "moves_without_command":
            position = run.positions[drive]
            begin = int(np.searchsorted(run.time, item.time))
            travel = np.abs(position[begin:] - position[begin])
            assert np.any(np.abs(travel - abs(item.value)) < 2e-3), (item.value, travel.max())
            assert abs(item.value) > 1e-3
        case "pressure_stays":
            gauge = run.pressures[item.address] - AMBIENT
            after = gauge[run.time >= item.time + 1e-3]
            assert after.min() > THRESHOLD - AMBIENT
            assert item.value == pytest.approx(gauge[-1], rel=0.02)
        case "pressure_missing" | "pressure_high":
            gauge = run.pressures[item.address][late] - AMBIENT
            assert item.value == pytest.approx(gauge.max(), rel=0.02, abs=200.0)
        case "pressure_falls":
            gauge = run.pressures[item.address][late] - AMBIENT
            assert item.value == pytest.approx(gauge.min(), rel=0.02, abs=200.0)
        case "air":
            values = [air_of(result, two_cylinders()) for result in (run, run_with())]
            assert (item.value, item.healthy) == tuple(pytest.approx(value, rel=0.01) for value in values)
        case "stroke_time":
            assert (item.value, item.healthy) == tuple(
                pytest.approx(longest_stroke(result, drive), rel=0.02) for result in (run, run_with())
            )
        case "cycle_time" | "none":
            entries = [[time for time, step in result.steps if step == "wait"] for result in (run, run_with())]
            # Cycles of equal number: the first one includes waiting for the start button.
            number = min(map(len, entries)) - 1
            cycles = [times[number] - times[number - 1] for times in entries]
            if item.kind == "none":
                assert cycles[0] == pytest.approx(cycles[1], rel=0.06)
            else:
                assert (item.value, item.healthy) == tuple(pytest.approx(cycle, abs=1e-6) for cycle in cycles)
        case _:
            raise AssertionError(item.kind)


def air_of(run: Run, machine: dict) -> float:
    """Return the air that the supply delivers from the start of the fault on [m^3 ANR]."""
    plant = Plant(machine)
    rates = []
    for row in run.states[run.time >= START - 1e-9].tolist():
        p, t = plant.gas(row)
        rates.append(next(passage.mass for passage in plant.flows(row, p, t) if passage.source == "supply"))
    return float(np.trapezoid(rates, dx=1e-3)) / 1.185


def longest_stroke(run: Run, drive: str) -> float:
    """Return the longest time from a step that moves a drive to 98 % of its stroke."""
    position, stroke = run.positions[drive], {"A": 0.08, "B": 0.05}[drive]
    times = []
    for (begin, step), (end, _) in zip(run.steps, [*run.steps[1:], (END, "")], strict=True):
        if step in (f"{drive}+", f"{drive}-"):
            rows = (run.time >= begin) & (run.time <= min(end + 0.1, END))
            moved = position[rows] >= 0.98 * stroke if step.endswith("+") else position[rows] <= 0.02 * stroke
            if moved.any():
                times.append(float(run.time[rows][np.argmax(moved)]) - begin)
    return max(times)
