"""Connected inputs obey their limits: gas never flows against the pressure, whatever output drives a valve."""

from __future__ import annotations

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.parts import PID, DirectionalValve, ProportionalValve, SpoolValve

SOURCES = ("regulator.command", "regulator.derivative", "regulator.integral", "other.regime", "regulator.vent_command")


def random_circuit(seed: int) -> Circuit:
    """Two reservoirs, a tank, a valve whose input an arbitrary dimensionless output drives, and a second passage."""
    generator = np.random.default_rng(seed)
    sizes = generator.uniform(0.2, 3.0, 2)
    pressures = generator.uniform(1.0, 9.0, 3)
    parts = {
        "supply": Reservoir(pressure=f"{pressures[0]} bar"),
        "room": Reservoir(pressure=f"{pressures[1]} bar"),
        "tank": Chamber(volume=f"{generator.uniform(0.1, 2.0)} l", initial_pressure=f"{pressures[2]} bar"),
        "other": Orifice(from_="tank", to="room", sonic_conductance=f"{sizes[0]} dm^3/(s bar)", critical_ratio=0.3),
        "regulator": PID(
            gain=f"{generator.uniform(-5.0, 5.0)} 1/bar", integral_time=f"{generator.uniform(5, 50)} ms",
            derivative_time="5 ms", setpoint=f"{generator.uniform(1.0, 9.0)} bar", sample_time="2 ms",
        ),
    }  # fmt: skip
    if seed % 2:
        parts["valve"] = Orifice(
            from_="supply", to="tank", sonic_conductance=f"{sizes[1]} dm^3/(s bar)", critical_ratio=0.4
        )
        target = "valve.opening"
    else:
        parts["valve"] = DirectionalValve(
            supply="supply", outlet="tank", exhaust="room", sonic_conductance=f"{sizes[1]} dm^3/(s bar)",
            critical_ratio=0.4,
        )  # fmt: skip
        target = "valve.command"
    connections = {"regulator.measurement": "tank.pressure", target: SOURCES[(seed // 2) % len(SOURCES)]}
    return Circuit(parts, connections=connections, run=poppet.Run(duration="0.3 s", output_step="2 ms"))


@pytest.mark.parametrize("seed", range(20))
def test_gas_flows_towards_the_lower_pressure(seed):
    circuit = random_circuit(seed)
    run = circuit.simulate()
    target = next(address for address in circuit.connections if address.startswith("valve."))
    assert run[target].min() >= 0.0
    assert run[target].max() <= 1.0
    tank, supply, room = (run[f"{name}.pressure"] for name in ("tank", "supply", "room"))
    if target == "valve.opening":
        flows = [(run["valve.mass_flow_rate"], supply - tank)]
        size = np.abs(run["valve.mass_flow_rate"]).max()
    else:
        flows = [
            (run["valve.supply_mass_flow_rate"], supply - tank),
            (run["valve.exhaust_mass_flow_rate"], tank - room),
        ]
        size = max(np.abs(flow).max() for flow, _ in flows)
    for flow, difference in flows:
        against = np.sign(flow) * np.sign(difference) < 0.0
        assert not (np.abs(flow[against]) > 1e-9 * size).any()


def test_saturation_is_noted_with_time_and_amount():
    # The setpoint is below the pressure of the tank: the command is negative.
    circuit = random_circuit(1).with_values({"regulator.setpoint": "0.1 bar", "regulator.gain": "5 1/bar"})
    assert circuit.connections["valve.opening"] == "regulator.command"
    notes = {note.code: note for note in circuit.simulate().remarks}
    assert notes["circuit.limited_input"].facts["lowest"] == -1.0
    saturated = notes["circuit.saturated"]
    assert saturated.address == "valve.opening"
    assert saturated.facts["value"] < 0.0
    assert 0.0 <= saturated.facts["time"] <= 0.3


def test_a_command_that_cannot_vent_has_no_note():
    circuit = random_circuit(1).with_values({"regulator.vent_limit": 0.0})
    codes = {note.code for note in circuit.simulate().remarks}
    assert not codes & {"circuit.limited_input", "circuit.saturated"}


def limited_by(connection):
    """Lowest and highest value in the note on a connection between parts of a circuit; None without a note."""
    size = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.4}
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "tank": Chamber(volume="1 l", initial_pressure="2 bar"),
            "valve": Orifice(from_="supply", to="tank", **size),
            "other": Chamber(volume="1 l"),
            "switch": DirectionalValve(supply="supply", outlet="tank", exhaust="ambient", **size),
            "spool": SpoolValve(supply="supply", a="tank", b="other", nominal_flow="700 l/min ANR"),
            "regulator": PID(gain="1 1/bar"),
            "pressure": ProportionalValve(
                data="vppm_6l", preset="fast", supply="supply", outlet="tank", exhaust="ambient"
            ),
        },
        connections=dict([connection]),
    )
    notes = [note for note in circuit.static_notes if note.code == "circuit.limited_input"]
    assert [note.address for note in notes] in ([], [connection[0]])
    return (notes[0].facts["lowest"], notes[0].facts["highest"]) if notes else None


@pytest.mark.parametrize(
    ("target", "source", "expected"),
    [
        ("valve.opening", "switch.supply_regime", (-3.0, 3.0)),  # flow regime of a part with several flows
        ("switch.command", "valve.regime", (-3.0, 3.0)),
        ("valve.opening", "spool.command", (-1.0, 1.0)),  # recorded input
        ("spool.command", "valve.opening", None),
        ("pressure.setpoint", "tank.pressure", (0.0, np.inf)),  # limits that are parameters of a compound part
        ("valve.opening", "pressure.fill_duty", None),  # output of a compound part
        ("valve.opening", "pressure.supply_regime", (-3.0, 3.0)),
        ("valve.opening", "regulator.integral", None),  # the range is not known
    ],
)
def test_note_on_a_range_for_each_kind_of_source(target, source, expected):
    assert limited_by((target, source)) == expected
