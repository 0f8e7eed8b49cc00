"""Moves of a machine cycle: stops against positions at fine output times, dwells that fill the cycle, edge cases."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Circuit
from poppet.audit.moves import find_moves
from poppet.parts import Chamber, Cylinder, Mass, Orifice, Reservoir
from poppet.timeseries.signals import Steps

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
STROKES = {"slideA": 0.08, "slideB": 0.05}


@cache
def machine() -> tuple:
    circuit = poppet.load(MACHINE)
    return circuit, circuit.simulate(output_step=2e-4)


def test_each_stop_is_the_first_contact_with_a_cover():
    circuit, recording = machine()
    moves = find_moves(circuit, recording)
    assert [move.step for move in moves] == ["A+", "B+", "B-", "A-"] * 2
    for move in moves:
        position, later = recording[f"{move.body}.position"], recording.time > move.start
        is_at_stop = position >= STROKES[move.body] if move.travel > 0.0 else position <= 0.0
        contact = recording.time[np.argmax(later & is_at_stop)]
        assert contact - 2e-4 <= move.stop <= contact
        assert move.stroke_time == move.stop - move.command_time
        speed = abs(recording[f"{move.body}.velocity"][np.argmax(later & is_at_stop) - 1])
        assert move.impact_speed == pytest.approx(speed, abs=0.002)


def test_the_command_is_the_entry_of_the_step():
    circuit, recording = machine()
    names = [step.name for step in circuit.parts["plc"].program.steps]
    for move in find_moves(circuit, recording):
        rows = np.flatnonzero(recording["plc.step"] == names.index(move.step) + 1)
        entry = recording.time[rows[np.argmin(np.abs(recording.time[rows] - move.command_time))]]
        assert move.command_time == pytest.approx(entry, abs=1e-9)


def test_the_time_of_a_command_does_not_depend_on_the_output_times():
    circuit, recording = machine()
    coarse = find_moves(circuit, circuit.simulate(output_step="3 ms"))
    for found, move in zip(coarse, find_moves(circuit, recording), strict=True):
        assert found.command_time == pytest.approx(move.command_time, abs=1e-9)
        assert found.command_time == pytest.approx(round(move.command_time / 5e-3) * 5e-3, abs=1e-9)
        assert found.stroke_time == pytest.approx(move.stroke_time, abs=2e-4)


@pytest.mark.parametrize("step", ["0.1 s", "0.25 s", "0.5 s"])
def test_a_move_between_few_rows_stops_after_its_start(step):
    """The body can be at rest in the first row of a move, or in its only one."""
    circuit = machine()[0]
    for move in find_moves(circuit, circuit.simulate(output_step=step)):
        assert move.stop is None or move.stop >= move.start


def test_moves_and_dwells_of_a_body_fill_the_cycle():
    circuit, recording = machine()
    cycle = (0.2, 1.7)
    moves = find_moves(circuit, recording, cycle)
    assert [move.step for move in moves] == ["A+", "B+", "B-", "A-"]
    for body in STROKES:
        total = sum(move.stop - move.start + move.dwell for move in moves if move.body == body)
        first, _, following, _ = (move for move in find_moves(circuit, recording) if move.body == body)
        assert total == pytest.approx(following.start - first.start, abs=1e-12)


def test_the_last_move_of_a_run_dwells_until_the_next_cycle_only_if_a_cycle_is_given():
    circuit, recording = machine()
    assert [move.dwell is None for move in find_moves(circuit, recording)] == [False] * 6 + [True] * 2
    first, second, third, last = find_moves(circuit, recording, (1.7, 3.2))
    assert last.dwell == pytest.approx(first.start + 1.5 - last.stop, abs=1e-12)
    assert third.dwell == pytest.approx(second.start + 1.5 - third.stop, abs=1e-12)


def test_a_run_that_ends_during_a_move_has_no_stop():
    circuit, _ = machine()
    *_, move = find_moves(circuit, circuit.simulate(0.4, output_step=2e-4))
    assert (move.body, move.stop, move.stroke_time, move.dwell) == ("slideA", None, None, None)


def spring_loaded(times: tuple[float, ...]) -> Circuit:
    """A mass between two chambers: the air of one of them rises and falls, and the other one is an air spring."""
    values = [2e5, 4e5] * 2
    side = {"dead_volume": 2e-5, "wall_conductance": 1e3}
    return Circuit(
        {
            "supply": Reservoir(pressure=2e5),
            "fill": Orifice(from_="supply", to="cylinder.cap", sonic_conductance=4e-9, critical_ratio=0.3),
            "cylinder": Cylinder(
                body="slide", bore=0.04, stroke_length=0.2,
                cap=side | {"initial_pressure": 2e5}, rod=side | {"initial_pressure": 2e5},
            ),
            "slide": Mass(mass=1.0, initial_position=0.1, friction={"viscous_coefficient": 400.0}),
        },
        {"supply.pressure": Steps([0.0, *times], values[: len(times) + 1])},
    )  # fmt: skip


def test_a_body_without_end_stop_stops_in_a_band_around_its_rest():
    circuit = spring_loaded((0.5, 4.0))
    recording = circuit.simulate(8.0, output_step=1e-3)
    out, back = find_moves(circuit, recording)
    position = recording["slide.position"]
    for move, rest in ((out, position[np.searchsorted(recording.time, 4.0)]), (back, position[-1])):
        outside = np.abs(position - rest) > 0.02 * abs(move.travel)
        last = np.flatnonzero(outside & (recording.time > move.start) & (recording.time < move.start + 3.4))[-1]
        assert recording.time[last] <= move.stop <= recording.time[last + 1]
        assert (move.impact_speed, move.step, move.command) == (None, "", None)
    assert out.dwell == pytest.approx(back.start - out.stop)


def test_circuits_without_motion_have_no_moves():
    tank = Circuit({
        "supply": Reservoir(pressure=6e5),
        "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-9, critical_ratio=0.3),
        "tank": Chamber(volume=1e-3),
    })  # fmt: skip
    assert find_moves(tank, tank.simulate(1.0)) == ()
    resting = spring_loaded(())
    assert find_moves(resting, resting.simulate(1.0)) == ()


def test_moves_can_be_replaced():
    circuit, recording = machine()
    move = find_moves(circuit, recording)[0]
    assert replace(move, command_time=None).stroke_time is None
