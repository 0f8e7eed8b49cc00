"""Functions of spool valves against independent paths, openings and pressures."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from exact.independent_spool import KNOTS, OPENINGS, chamber_pressures, selected_position, spool_path
from poppet import Chamber, Circuit, Reservoir, Run, SpoolValve
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Points, Steps

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "rail", "a": "first", "b": "second"}
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
END = 2.0 / 50.0
"""Travel at the end of the stroke that the spool covers more slowly."""


def circuit(function, instants, commands, parts=None, **fields):
    names = ["command"] if function == "5/2 monostable" else ["command_a", "command_b"]
    signals = {f"valve.{name}": Steps(instants, [float(pair[k]) for pair in commands]) for k, name in enumerate(names)}
    chambers = {"first": Chamber(volume="0.2 l"), "second": Chamber(volume="0.1 l")}
    valve = SpoolValve(**PORTS, **SIZE, function=function, **fields)
    return Circuit({"rail": Reservoir(pressure="7 bar"), **chambers, "valve": valve, **(parts or {})}, signals)


@pytest.mark.parametrize("function", OPENINGS)
def test_positions_for_all_transitions_between_command_pairs(function):
    # All ordered pairs of command pairs follow each other.
    pairs = list(itertools.product((False, True), repeat=2))
    sequence = [pair for first in pairs for second in pairs for pair in (first, second)]
    instants = [0.05 * k for k in range(len(sequence))]
    recording = circuit(function, instants, sequence, switching_time="8 ms", closing_time="20 ms").simulate(
        0.05 * len(sequence), 1e-3
    )
    position = recording["valve.position"]
    expected = -1.0 if function.startswith("5/2") else 0.0
    for instant, (a, b) in zip(instants, sequence, strict=True):
        expected = selected_position(function, a, b, expected)
        last_row = round(instant / 1e-3) + 49  # before the next change
        assert position[last_row] == pytest.approx(expected, abs=1e-5), (instant, a, b)


@pytest.mark.parametrize("function", OPENINGS)
@pytest.mark.parametrize("seed", range(4))
def test_path_of_the_spool_with_random_commands(function, seed):
    # Some intervals are shorter than the stroke: the spool returns before it arrives.
    generator = np.random.default_rng(seed)
    instants = np.concatenate(([0.0], np.cumsum(generator.uniform(0.004, 0.06, 20))))
    commands = [tuple(pair) for pair in generator.integers(0, 2, (21, 2)).astype(bool)]
    if function == "5/2 bistable":  # without memory of an interrupted stroke, which depends on the hysteresis
        instants = np.arange(21) * 0.05
    on_time, off_time = generator.uniform(0.005, 0.03, 2)
    end = instants[-1] + 0.05
    fields = {"switching_time": on_time, "closing_time": off_time}
    recording = circuit(function, list(instants), commands, **fields).simulate(end, 2e-4)
    start = -1.0 if function.startswith("5/2") else 0.0
    times, path = spool_path(function, [*instants, end], commands, start, on_time, off_time)
    difference = np.abs(recording["valve.position"] - np.interp(recording.time, times, path))
    # The approach to an end takes longer, which a following stroke inherits.
    assert difference.max() < 1.5 * END
    assert difference[-1] < 1e-4
    assert np.median(difference) < 1e-3


@pytest.mark.parametrize("function", OPENINGS)
def test_openings_of_the_edges(function):
    valve = SpoolValve(**PORTS, **SIZE, function=function)
    gas = {
        name: GasState(pressure, 293.15)
        for name, pressure in {"supply": 7e5, "a": 3e5, "b": 2e5, "exhaust_a": 1e5, "exhaust_b": 1e5}.items()
    }
    upstream = {"supply_a": 7e5, "supply_b": 7e5, "exhaust_a": 3e5, "exhaust_b": 2e5}
    numbers = valve.parameters(AIR)
    for position in np.linspace(-1.0, 1.0, 41):
        commands = dict.fromkeys(("command", "command_a", "command_b"), 0.0)
        outputs = valve.flows(Scope(numbers, {"position": position}, commands, AIR), gas).outputs
        flows = {edge: outputs[f"{edge}_mass_flow_rate"][0] for edge in OPENINGS[function]}
        choked = {edge: flow / (2e-8 * 1.185 * upstream[edge]) for edge, flow in flows.items()}
        ratio_a, ratio_b = 3.0 / 7.0, 0.5  # of the edges that are not choked
        subsonic = {"supply_a": ratio_a, "exhaust_b": ratio_b, "exhaust_a": 1.0 / 3.0}
        for edge, values in OPENINGS[function].items():
            factor = np.sqrt(1.0 - max(0.0, (subsonic.get(edge, 0.0) - 0.3) / 0.7) ** 2)
            assert choked[edge] == pytest.approx(np.interp(position, KNOTS, values) * factor, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("function", OPENINGS)
def test_pressures_of_two_chambers(function):
    instants, commands = [0.0, 0.02, 0.12, 0.16], [(False, False), (True, False), (False, False), (False, True)]
    fields = {"switching_time": "10 ms", "closing_time": "15 ms"}
    recording = circuit(function, instants, commands, **fields).simulate(0.25, 1e-3)
    start = -1.0 if function.startswith("5/2") else 0.0
    knots = spool_path(function, [*instants, 0.25], commands, start, 0.01, 0.015)
    expected = chamber_pressures(function, knots, (2e-4, 1e-4), 2e-8, 0.3, 7e5, 1e5, recording.time)
    for name, pressure in zip(("first", "second"), expected, strict=True):
        assert np.abs(recording[f"{name}.pressure"] - pressure).max() < 0.01 * 6e5, name
        assert recording[f"{name}.pressure"][-1] == pytest.approx(pressure[-1], rel=2e-3), name
    assert all(residual.is_kept for residual in recording.residuals)


def piloted(function, ramps, **fields):
    """A valve whose pilots have prescribed pressures."""
    ports = {port: port.removeprefix("pilot_").join(("line_", "")) for port in ramps}
    lines = {node: Reservoir(pressure="1 bar") for node in ports.values()}
    parts = {
        "rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="0.2 l"), "second": Chamber(volume="0.1 l"),
        "valve": SpoolValve(**PORTS, **SIZE, function=function, **ports, **fields), **lines,
    }  # fmt: skip
    signals = {f"{ports[port]}.pressure": Points(*ramp) for port, ramp in ramps.items()}
    return Circuit(parts, signals, run=Run(duration=2.0, output_step=1e-3))


def crossings(time, values, level):
    """Times at which a series crosses a level, rising and falling."""
    above = values > level
    return [time[above & ~np.roll(above, 1)][0], time[~above & np.roll(above, 1)][-1]]


@pytest.mark.parametrize(("function", "level"), [("5/2 monostable", 0.0), ("5/3 closed", 0.5), ("5/3 exhausted", 0.5)])
def test_pilot_switches_at_its_pressure_and_releases_below_it(function, level):
    triangle = ([0.0, 1.0, 2.0], [1e5, 6e5, 1e5])  # 5 bar per second
    fields = {"pilot_pressure": "3 bar g", "pilot_hysteresis": "1 bar", "switching_time": "2 ms"}
    recording = piloted(function, {"pilot_a": triangle}, **fields).simulate()
    on, off = crossings(recording.time, recording["valve.position"], level)
    assert on == pytest.approx((4e5 - 1e5) / 5e5 + 0.001, abs=0.0015)
    assert off == pytest.approx(1.0 + (6e5 - 3e5) / 5e5 + 0.001, abs=0.0015)
    assert recording["line_a.pressure"].max() == 6e5


def test_bistable_valve_keeps_its_position_without_pilot_pressure():
    a, b = ([0.0, 0.5, 0.51, 1.0, 2.0], [4e5, 4e5, 1e5, 1e5, 1e5]), ([0.0, 1.2, 1.3, 2.0], [1e5, 1e5, 4e5, 4e5])
    circuit = piloted("5/2 bistable", {"pilot_a": a, "pilot_b": b}, pilot_pressure="3 bar")
    recording = circuit.simulate()
    position = recording["valve.position"]
    assert position[[0, 100, 510, 1100, 1200]] == pytest.approx([-1.0, 1.0, 1.0, 1.0, 1.0], abs=1e-6)
    assert position[-1] == pytest.approx(-1.0, abs=1e-6)
    # No gas flows through a pilot port.
    ends = {end for flow in circuit.model.flows for end in (flow.source, flow.target)}
    assert ends == {"rail", "first", "second", "ambient"}


def test_equal_pilot_pressures_keep_a_bistable_valve_and_centre_another():
    late = ([0.0, 0.5, 0.51, 2.0], [1e5, 1e5, 4e5, 4e5])
    early = ([0.0, 0.1, 0.11, 2.0], [1e5, 1e5, 4e5, 4e5])
    for function, expected in {"5/2 bistable": 1.0, "5/3 closed": 0.0}.items():
        recording = piloted(function, {"pilot_a": early, "pilot_b": late}).simulate()
        assert recording["valve.position"][400] == pytest.approx(1.0, abs=1e-6)
        assert recording["valve.position"][-1] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("function", ["5/2 monostable", "5/2 bistable", "5/3 closed"])
def test_times_on_and_off(function):
    pairs = [(False, False), (True, False), (False, function == "5/2 bistable"), (False, False)]
    recording = circuit(
        function, [0.0, 0.1, 0.2, 0.3], pairs, switching_time="12 ms", closing_time="31 ms", delay="3 ms"
    ).simulate(0.3, 1e-4)
    position, (low, high) = recording["valve.position"], (0.0, 1.0) if function == "5/3 closed" else (-1.0, 1.0)
    fraction = (position - low) / (high - low)
    # The last 1/50 of the stroke is slower: times to 90 %.
    assert crossings(recording.time, fraction, 0.9)[0] == pytest.approx(0.103 + 0.9 * 0.012, abs=2e-4)
    assert crossings(recording.time, fraction, 0.1)[1] == pytest.approx(0.203 + 0.9 * 0.031, abs=2e-4)
