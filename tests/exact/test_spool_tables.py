"""Tables, hysteresis, setpoints and speed limits of a proportional spool against SciPy and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator

from exact.independent_spool import mass_flow
from poppet import Chamber, Circuit, Reservoir, SpoolValve
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Points, Steps

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "rail", "a": "first", "b": "second"}
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
PRESSURES = {"supply": 7e5, "a": 5e5, "b": 2e5, "exhaust_a": 1e5, "exhaust_b": 1.2e5}
ENDS = {
    "supply_a": ("supply", "a"), "supply_b": ("supply", "b"),
    "exhaust_a": ("a", "exhaust_a"), "exhaust_b": ("b", "exhaust_b"),
}  # fmt: skip


def random_table(seed, side):
    """Positions, C and b of an edge that opens on one side, with leakage and measurement noise."""
    generator = np.random.default_rng(seed)
    inner = np.sort(generator.uniform(-0.95, 0.95, generator.integers(0, 10)))
    positions = np.concatenate(([-1.0], inner, [1.0]))
    conductance = 1e-8 * (0.01 + np.clip(side * positions, 0.0, 1.0)) * generator.uniform(0.9, 1.1, positions.size)
    return positions, conductance, generator.uniform(0.1, 0.5, positions.size)


def table(positions, conductance, ratio):
    return {"position": list(positions), "sonic_conductance": list(conductance), "critical_ratio": list(ratio)}


def edge_flows(valve, position):
    gas = {port: GasState(pressure, 293.15) for port, pressure in PRESSURES.items()}
    outputs = valve.flows(Scope(valve.parameters(AIR), {"position": position}, {"command": 0.0}, AIR), gas).outputs
    return {edge: outputs[f"{edge}_mass_flow_rate"][0] for edge in ENDS}


def expected_flow(edge, position, positions, conductance, ratio):
    position = np.clip(position, -1.0, 1.0)
    size = PchipInterpolator(positions, conductance)(position), PchipInterpolator(positions, ratio)(position)
    first, second = ENDS[edge]
    return mass_flow(PRESSURES[first], 293.15, PRESSURES[second], 293.15, *size)


@pytest.mark.parametrize("seed", range(8))
def test_tables_of_all_edges(seed):
    tables = {
        edge: random_table(4 * seed + k, side)
        for k, (edge, side) in enumerate({"supply_a": 1, "supply_b": -1, "exhaust_a": -1, "exhaust_b": 1}.items())
    }
    fields = {f"{edge}_characteristic": table(*values) for edge, values in tables.items()}
    valve = SpoolValve(**PORTS, characteristic=fields.pop("supply_a_characteristic"), **fields)
    for position in np.linspace(-1.1, 1.1, 45):
        expected = {edge: expected_flow(edge, position, *values) for edge, values in tables.items()}
        assert edge_flows(valve, position) == pytest.approx(expected, rel=1e-9)


def test_other_edges_have_the_mirrored_table():
    positions, conductance, ratio = random_table(1, 1)
    valve = SpoolValve(**PORTS, characteristic=table(positions, conductance, ratio))
    for position in np.linspace(-1.0, 1.0, 21):
        expected = {
            edge: expected_flow(edge, position * (1 if edge in ("supply_a", "exhaust_b") else -1),
                                positions, conductance, ratio)
            for edge in ENDS
        }  # fmt: skip
        assert edge_flows(valve, position) == pytest.approx(expected, rel=1e-9)
    # With a table of port a, the exhaust of b is its mirror image; the edge from the supply to b has its own size.
    other = random_table(2, -1)
    mixed = SpoolValve(
        **PORTS, characteristic=table(positions, conductance, ratio), exhaust_a_characteristic=table(*other),
        supply_b_conductance=3e-9, supply_b_ratio=0.2, overlap=0.1,
    )  # fmt: skip
    flows = edge_flows(mixed, -0.6)
    assert flows["exhaust_b"] == pytest.approx(expected_flow("exhaust_b", 0.6, *other), rel=1e-9)
    by_overlap = 3e-9 * (0.6 - 0.1) / 0.9
    assert flows["supply_b"] == pytest.approx(mass_flow(7e5, 293.15, 2e5, 293.15, by_overlap, 0.2), rel=1e-9)


def test_table_of_setpoints_equals_that_of_positions():
    positions, conductance, ratio = random_table(3, 1)
    reference = SpoolValve(**PORTS, characteristic=table(positions, conductance, ratio))
    for setpoint_type, values in {
        "0-10 V": [f"{5.0 + 5.0 * float(position)!r} V" for position in positions],
        "4-20 mA": [f"{12.0 + 8.0 * float(position)!r} mA" for position in positions],
    }.items():
        columns = table(positions, conductance, ratio)
        del columns["position"]
        valve = SpoolValve(**PORTS, setpoint_type=setpoint_type, characteristic={"command": values, **columns})
        assert edge_flows(valve, 0.37) == pytest.approx(edge_flows(reference, 0.37), rel=1e-12)


def simulated(signal, duration, step=1e-3, **fields):
    parts = {
        "rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="0.5 l"), "second": Chamber(volume="0.5 l"),
        "valve": SpoolValve(**PORTS, **SIZE, **fields),
    }  # fmt: skip
    return Circuit(parts, {"valve.command": signal}).simulate(duration, step)


@pytest.mark.parametrize(
    ("setpoint_type", "values"),
    [("0-10 V", [5.0, 10.0, 6.0, 0.0]), ("4-20 mA", [12e-3, 20e-3, 13.6e-3, 4e-3])],
)
def test_setpoints_move_the_spool_as_their_positions(setpoint_type, values):
    times = [0.0, 0.01, 0.05, 0.09]
    electrical = simulated(Steps(times, values), 0.12, setpoint_type=setpoint_type)
    plain = simulated(Steps(times, [0.0, 1.0, 0.2, -1.0]), 0.12)
    assert np.abs(electrical["valve.position"] - plain["valve.position"]).max() < 1e-6
    assert np.abs(electrical["first.pressure"] - plain["first.pressure"]).max() < 1.0
    assert electrical["valve.command"][-1] == values[-1]


@pytest.mark.parametrize("hysteresis", [0.004, 0.05])
@pytest.mark.parametrize("fields", [{"lag": "1 ms"}, {"dynamics": "second_order", "natural_frequency": "200 Hz"}])
def test_width_of_the_hysteresis_loop(hysteresis, fields):
    # A slow triangle over the full stroke, twice: rising and falling branches differ by this fraction of the stroke 2.
    triangle = Points([0.0, 2.0, 6.0, 8.0], [0.0, 1.0, -1.0, 0.0])
    recording = simulated(triangle, 8.0, 2e-3, hysteresis=hysteresis, **fields)
    command, position, time = recording["valve.command"], recording["valve.position"], recording.time
    falling, rising = (time > 2.2) & (time < 5.8), (time > 6.2)
    levels = np.linspace(-0.8, -0.1, 15)
    loop = np.interp(-levels, -command[falling], position[falling]) - np.interp(
        levels, command[rising], position[rising]
    )
    # The lag of a ramp of 0.5 per second adds 0.5 times the lag on each branch.
    lag = 1e-3 if "lag" in fields else 2.0 * 0.7 / (2.0 * np.pi * 200.0)
    assert loop == pytest.approx(2.0 * hysteresis + 2.0 * 0.5 * lag, rel=1e-3)
    # The centre is not reached exactly.
    assert position[-1] == pytest.approx(-hysteresis, abs=1e-3)


@pytest.mark.parametrize("seed", range(6))
def test_hysteresis_with_random_ramps(seed):
    # Ramps of 0.1 to 10 s: steps of the solver must not pass over the dead band.
    generator = np.random.default_rng(seed)
    hysteresis, lag = 10.0 ** generator.uniform(-3.0, -1.0), 10.0 ** generator.uniform(-3.0, -2.0)
    times = np.concatenate(([0.0], np.cumsum(generator.uniform(0.2, 1.0, 8)) * 10.0 ** generator.uniform(-1.0, 1.0)))
    commands = np.concatenate(([0.0], generator.uniform(-1.0, 1.0, 8)))
    recording = simulated(Points(times, commands), times[-1], times[-1] / 1000, hysteresis=hysteresis, lag=lag)

    def rate(t, y):
        error = np.interp(t, times, commands) - y
        return (error - np.clip(error, -hysteresis, hysteresis)) / lag

    solution = solve_ivp(
        rate, (0.0, times[-1]), [0.0], method="LSODA", t_eval=recording.time, rtol=1e-8, atol=1e-10,
        max_step=times[-1] / 1000,
    )  # fmt: skip
    assert np.abs(recording["valve.position"] - solution.y[0]).max() < 2e-5


def test_reversal_within_the_hysteresis_does_not_move_the_spool():
    recording = simulated(Steps([0.0, 0.01, 0.1], [0.0, 0.5, 0.45]), 0.2, hysteresis=0.05, lag="1 ms")
    assert recording["valve.position"][-1] == pytest.approx(0.45, abs=1e-5)
    assert np.ptp(recording["valve.position"][60:]) < 1e-5


@pytest.mark.parametrize("fields", [{"lag": "0.1 ms"}, {"dynamics": "second_order", "natural_frequency": "3 kHz"}])
def test_speed_limits_away_from_the_centre_and_back(fields):
    signal = Steps([0.0, 0.01, 0.06, 0.11], [0.0, 1.0, 0.0, -1.0])
    recording = simulated(signal, 0.16, 1e-4, switching_time="20 ms", closing_time="40 ms", **fields)
    expected = np.interp(recording.time, [0.01, 0.03, 0.06, 0.1, 0.11, 0.13], [0.0, 1.0, 1.0, 0.0, 0.0, -1.0])
    assert np.abs(recording["valve.position"] - expected).max() < 0.02
    # Through the centre: first the time of the return, then that of the way out.
    through = simulated(Steps([0.0, 0.01], [-1.0, 1.0]), 0.08, 1e-4, command=-1.0, switching_time="20 ms",
                        closing_time="40 ms", **fields)  # fmt: skip
    expected = np.interp(through.time, [0.01, 0.05, 0.07], [-1.0, 0.0, 1.0])
    assert np.abs(through["valve.position"] - expected).max() < 0.02


def test_speed_of_the_return_alone():
    signal = Steps([0.0, 0.01, 0.05], [0.0, 1.0, 0.0])
    recording = simulated(signal, 0.1, 1e-4, lag="1 ms", closing_time="30 ms")
    after = np.clip(recording.time - 0.01, 0.0, 0.04)
    opening = recording.time < 0.05
    assert np.abs(recording["valve.position"] - (1.0 - np.exp(-after / 1e-3)))[opening].max() < 1e-4
    assert recording["valve.position"][650] == pytest.approx(0.5, abs=0.01)
