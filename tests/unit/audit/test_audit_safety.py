"""Safety audits of small circuits whose exhaust times and travels follow from closed forms."""

from __future__ import annotations

import math
import re
import tomllib

import numpy as np
import pytest
from scipy.integrate import quad

from poppet import (
    Chamber,
    CheckValve,
    Circuit,
    Cylinder,
    DirectionalValve,
    Mass,
    Orifice,
    Reservoir,
    loads,
)
from poppet.audit.safety import audit_safety
from poppet.audit.safety_result import SafetyAudit
from poppet.core.errors import InputError
from poppet.signals import Chirp, Constant, Steps

AMBIENT, T = 1e5, 293.15
R = 287.05287  # of dry air, ISO 2533
FLOW = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}
VENT = {"supply.pressure": "0 bar g"}


def emptying_time(start: float, end: float, volume: float, conductance: float, b: float) -> float:
    """Time in which an isothermal volume empties from `start` to `end` [Pa absolute], by quadrature of ISO 6358."""

    def rate(p: float) -> float:
        ratio = AMBIENT / p
        subsonic = math.sqrt(max(1.0 - ((ratio - b) / (1.0 - b)) ** 2, 0.0)) if ratio > b else 1.0
        return conductance * 1.185 * p * subsonic * R * T / volume

    return quad(lambda p: 1.0 / rate(p), end, start, points=[AMBIENT / b] if AMBIENT / b < start else None)[0]


def tank_circuit(**fields) -> Circuit:
    """A tank that a valve without voltage connects to the ambient at once."""
    tank = Chamber(volume="2 l", initial_pressure="6 bar g", thermal="isothermal")
    valve = {"normally": "open", "command": 1.0, "initial_position": 0.0, "switching_time": "1 us", "delay": 0.0}
    dump = DirectionalValve(supply="tank", outlet="ambient", **FLOW, **valve, **fields)
    return Circuit({"tank": tank, "dump": dump}).with_values({"run.duration": "2 s"})


@pytest.mark.parametrize("threshold", ["0.5 bar", "0.5 bar g", "2 bar", 3e4])
def test_exhaust_time_of_a_tank(threshold):
    audit = audit_safety(tank_circuit(), {"dump.command": 0}, at="0.7 s", threshold=threshold, duration="20 s")
    level = {"0.5 bar": 5e4, "0.5 bar g": 5e4, "2 bar": 2e5}.get(threshold, threshold)
    assert audit.threshold == level
    row = audit.exhaust_of("tank")
    assert row.time == pytest.approx(emptying_time(7e5, AMBIENT + level, 2e-3, 1e-8, 0.3), rel=2e-5)
    assert row.start_pressure == pytest.approx(6e5)
    assert audit.exhaust_of("tank", "dump.stuck_open").time == pytest.approx(row.time, rel=1e-4)
    for fault in ("dump.stuck_closed", "dump.stuck"):
        kept = audit.exhaust_of("tank", fault)
        assert (kept.time, kept.reason, kept.by, kept.is_exhausted) == (math.inf, "trapped", ("dump",), False)
        assert kept.end_pressure == pytest.approx(6e5, rel=1e-9)


def test_the_result_does_not_depend_on_the_output_step_of_the_circuit():
    times = [
        audit_safety(
            tank_circuit().with_values({"run.output_step": step}), {"dump.command": 0}, at="0.7 s", kinds=()
        ).exhaust_of("tank").time
        for step in ("0.5 s", "0.1 ms")
    ]  # fmt: skip
    assert times[0] == times[1]


def test_a_slow_exhaust_has_no_time_before_it_has_ended():
    audit = audit_safety(tank_circuit(), {"dump.command": 0}, at="0.7 s", duration="0.5 s", kinds=())
    row = audit.exhaust_of("tank")
    assert (row.time, row.reason, row.by) == (math.inf, "falling", ("dump",))


def test_unknown_names_of_a_result_are_errors():
    audit = audit_safety(tank_circuit(), {"dump.command": 0}, at="0.7 s", duration="0.5 s", kinds=())
    for look_up, text in (
        (lambda: audit.exhaust_of("tnk"), "tnk is not the name of a volume of the audit. Did you mean tank?"),
        (lambda: audit.exhaust_of("tank", "dump.stuck"), "dump.stuck is not the name of a fault of the audit."),
        (lambda: audit.travel_of("slide"), "slide is not the name of a body of the audit."),
    ):
        with pytest.raises(InputError) as error:
            look_up()
        assert str(error.value).startswith(text)


def test_a_check_valve_traps_the_gas_behind_it():
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "fill": Orifice(from_="supply", to="line", **FLOW),
        "line": Chamber(volume="0.1 l", initial_pressure="6 bar g"),
        "check": CheckValve(from_="line", to="tank", cracking_pressure=0.0, **FLOW),
        "tank": Chamber(volume="1 l", initial_pressure="6 bar g"),
    }
    audit = audit_safety(Circuit(parts).with_values({"run.duration": "1 s"}), VENT, at="0.1 s")
    row = audit.exhaust_of("tank")
    assert (row.time, row.reason, row.by) == (math.inf, "trapped", ("check",))
    assert audit.exhaust_of("line").is_exhausted
    if "check.stuck_open" in audit.faults:
        assert audit.exhaust_of("tank", "check.stuck_open").is_exhausted


def test_a_reservoir_keeps_the_pressure_of_the_volumes_that_it_supplies():
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "fill": Orifice(from_="supply", to="tank", **FLOW),
        "tank": Chamber(volume="1 l", initial_pressure="6 bar g"),
        "dump": DirectionalValve(supply="tank", outlet="ambient", command=0.0, **FLOW),
    }
    circuit = Circuit(parts).with_values({"run.duration": "1 s"})
    row = audit_safety(circuit, {"dump.command": 1}, at="0.1 s", kinds=()).exhaust_of("tank")
    assert (row.time, row.reason, row.by) == (math.inf, "supplied", ("fill",))


def falling_circuit(valve: dict | None = None) -> Circuit:
    """A mass that hangs on the air below its piston; without voltage, the air leaves."""
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "valve": DirectionalValve(
            supply="supply", outlet="cylinder.cap", exhaust="ambient", exhaust_conductance="5 dm^3/(s bar)",
            exhaust_ratio=0.3, command=1.0, initial_position=1.0, switching_time="1 ms", **FLOW, **(valve or {}),
        ),
        "vent": Orifice(from_="cylinder.rod", to="ambient", sonic_conductance="10 dm^3/(s bar)", critical_ratio=0.3),
        "cylinder": Cylinder(
            body="load", bore="40 mm", rod_diameter="12 mm", stroke_length="200 mm",
            cap={"dead_volume": "10 cm^3", "initial_pressure": "6 bar g"}, rod={"dead_volume": "10 cm^3"},
        ),
        "load": Mass(mass="20 kg", inclination="90 deg", initial_position="200 mm"),
    }  # fmt: skip
    return Circuit(parts).with_values({"run.duration": "1 s"})


def test_a_body_that_falls_travels_its_whole_stroke():
    audit = audit_safety(falling_circuit(), {"valve.command": 0}, at="0.5 s", duration="4 s")
    travel = audit.travel_of("load")
    assert travel.is_stopped
    assert travel.net == pytest.approx(-0.2, abs=2e-3)
    assert travel.path >= abs(travel.net)
    # The end stop yields by some millimetres.
    assert 0.2 < travel.farthest < 0.205
    # Not faster than a free fall.
    assert travel.stop_time > math.sqrt(2.0 * 0.2 / 9.81)
    assert audit.travel_of("load", "valve.stuck").distance < 1e-3


def test_a_volume_that_a_load_compresses_after_the_exhaust_counts_until_its_last_fall():
    """Vented at once, the space above the piston rises again while the piston moves into it."""
    parts = dict(falling_circuit().parts)
    parts["vent"] = Orifice(
        from_="cylinder.rod", to="ambient", sonic_conductance="0.02 dm^3/(s bar)", critical_ratio=0.3
    )
    parts["load"] = Mass(mass="1 kg", initial_position="0 mm")
    parts["valve"] = DirectionalValve(
        supply="supply", outlet="cylinder.cap", exhaust="ambient", exhaust_conductance="5 dm^3/(s bar)",
        exhaust_ratio=0.3, command=0.0, initial_position=0.0, switching_time="1 ms", **FLOW,
    )  # fmt: skip
    parts["cylinder"] = Cylinder(
        body="load", bore="40 mm", rod_diameter="12 mm", stroke_length="200 mm", cap={"dead_volume": "10 cm^3"},
        rod={"dead_volume": "10 cm^3"},
    )  # fmt: skip
    circuit = Circuit(parts).with_values({"run.duration": "1 s"})
    row = audit_safety(circuit, {"valve.command": 1}, at="0.1 s", duration="30 s", kinds=()).exhaust_of("cylinder.rod")
    recording = circuit.with_signals({"valve.command": Steps([0.0, 0.1], [0.0, 1.0])}).simulate(30.1, 1e-3)
    pressure = recording["cylinder.rod.pressure"] - AMBIENT
    above = np.flatnonzero(pressure > 5e4)
    assert row.start_pressure < 5e4 < pressure.max()
    assert row.time == pytest.approx(recording.time[above[-1]] - 0.1, abs=2e-3)


def test_the_worst_moment_is_that_with_the_longest_time():
    charged = tank_circuit().with_values({"tank.initial_pressure": "1 bar g"})
    parts = {**charged.parts, "supply": Reservoir(pressure="6 bar g")}
    parts["fill"] = Orifice(from_="supply", to="tank", sonic_conductance="0.2 dm^3/(s bar)", critical_ratio=0.3)
    circuit = Circuit(parts).with_values({"run.duration": "2 s"})
    values = {"dump.command": 0, "supply.pressure": "0 bar g"}
    audit = audit_safety(circuit, values, at=["0.2 s", "1.9 s", "1 s"], kinds=())
    assert [moment.time for moment in audit.moments] == [0.2, 1.0, 1.9]
    assert audit.exhaust_of("tank").moment.time == 1.9
    single = audit_safety(circuit, values, at="1.9 s", kinds=())
    assert audit.exhaust_of("tank").time == single.exhaust_of("tank").time
    even = audit_safety(circuit, values, kinds=())
    assert [moment.time for moment in even.moments] == pytest.approx(np.arange(20) * 0.1)


SEQUENCE = """
[parts.plc]
kind = "sequence"
sample_time = "10 ms"
outputs = ["open"]
start = "rest"
[parts.plc.steps.rest]
next = { fill = "elapsed > 0.195 s" }
[parts.plc.steps.fill]
on = ["open"]
next = { rest = "elapsed > 0.395 s" }
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
exhaust_conductance = "1 dm^3/(s bar)"
exhaust_ratio = 0.3
[parts.tank]
kind = "chamber"
volume = "0.2 l"
initial_pressure = "0 bar g"
[connections]
"valve.command" = "plc.open"
[run]
duration = "2 s"
"""


def test_an_event_replaces_a_connection_from_its_moment_on():
    circuit = loads(SEQUENCE)
    audit = audit_safety(circuit, {"valve.command": 0}, at="0.45 s", kinds=())
    assert audit.events[0].replaced == "plc.open"
    assert "safety.replaced" in [note.code for note in audit.notes]
    # A run whose only difference is that the sequence keeps the valve closed from 0.45 s on.
    alone = {name: part for name, part in circuit.parts.items() if name != "plc"}
    signal = Steps([0.0, 0.2, 0.45], [0.0, 1.0, 0.0])
    recording = Circuit(alone, signals={"valve.command": signal}).simulate(10.45, 1e-4)
    above = np.flatnonzero(recording["tank.pressure"] > AMBIENT + 5e4)
    assert audit.exhaust_of("tank").time == pytest.approx(recording.time[above[-1]] - 0.45, abs=2e-4)
    kept = audit_safety(circuit, {"valve.command": 1}, at="0.1 s", kinds=()).exhaust_of("tank")
    assert (kept.time, kept.reason) == (math.inf, "supplied")


def test_moments_of_the_steps():
    audit = audit_safety(loads(SEQUENCE), VENT, kinds=())
    # Complete visits: fill from 1.4 to 1.8 s, rest from 1.2 to 1.4 s.
    expected = [*(1.2 + 0.05 * np.arange(4)), *(1.4 + 0.1 * np.arange(4))]
    assert [moment.time for moment in audit.moments] == pytest.approx(expected, abs=1e-9)
    assert [moment.step for moment in audit.moments] == ["rest"] * 4 + ["fill"] * 4
    assert audit_safety(loads(SEQUENCE), VENT, at="steps", kinds=()).moments == audit.moments


UNCERTAIN = """
[parts.tank]
kind = "chamber"
volume = "1 l"
thermal = "isothermal"
initial_pressure = "6 bar g"
[parts.dump]
kind = "directional_valve"
supply = "tank"
outlet = "ambient"
normally = "open"
command = 1
initial_position = 0
switching_time = "1 us"
delay = "0 s"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[run]
duration = "1 s"
[ensemble]
runs = 1000
seed = 3
sampling = "latin"
[ensemble.parameters]
"tank.volume" = { distribution = "uniform", relative_range = 0.1 }
"""


def test_gauge_pressures_of_a_sample_refer_to_its_ambient_pressure():
    """The interval is that of the audits at both limits, which contain the time without a change."""
    text = UNCERTAIN.replace('initial_pressure = "6 bar g"', 'initial_pressure = "7 bar"')
    ambient = '"ambient.pressure" = { distribution = "uniform", low = "0.6 bar", high = "1 bar" }'
    uncertain = re.sub('"tank.volume" = .*', ambient, text)
    options = {"at": "0.5 s", "duration": "4 s", "kinds": ()}
    times = [
        audit_safety(loads(f'{text}[ambient]\npressure = "{pressure} bar"\n'), {"dump.command": 0}, **options)
        .exhaust_of("tank")
        .time
        for pressure in (1.0, 0.6)
    ]
    interval = audit_safety(loads(uncertain), {"dump.command": 0}, samples=100, **options).exhaust_of("tank")
    assert (interval.low, interval.high) == pytest.approx(times, rel=0.02)


def test_intervals_of_a_time_that_is_proportional_to_a_uniform_volume():
    options = {"at": "0.5 s", "samples": 200, "duration": "8 s", "kinds": ("stuck",)}
    audit = audit_safety(loads(UNCERTAIN), {"dump.command": 0}, **options)
    row = audit.exhaust_of("tank")
    assert audit.samples == 200
    # 95 % of the volumes are within 9.5 % of the mean; each stratum of the sample has a width of 0.1 %.
    assert row.low == pytest.approx(0.905 * row.time, rel=2e-3)
    assert row.high == pytest.approx(1.095 * row.time, rel=2e-3)
    stuck = audit.exhaust_of("tank", "dump.stuck")
    assert (stuck.low, stuck.high) == (math.inf, math.inf)
    assert audit_safety(loads(UNCERTAIN), {"dump.command": 0}, **options).exhaust == audit.exhaust
    other = audit_safety(loads(UNCERTAIN), {"dump.command": 0}, **options | {"samples": 20}, seed=4)
    assert other.exhaust_of("tank").low != row.low
    nominal = audit_safety(loads(UNCERTAIN), {"dump.command": 0}, **options | {"samples": 0})
    assert nominal.exhaust_of("tank").low is None


def test_keys_of_the_result_file(tmp_path):
    path = tmp_path / "safety.toml"
    audit_safety(falling_circuit(), {"valve.command": 0}, at="0.5 s", duration="4 s").save(path)
    content = tomllib.loads(path.read_text())
    for row in content["exhaust"]:
        assert {"volume", "time_s", "fault", "event_s", "start_pressure_pa"} <= row.keys()
    for row in content["travel"]:
        assert {"body", "distance_m", "fault", "path_m", "net_m", "stop_time_s"} <= row.keys()
    faults = ["", "valve.stuck_open", "valve.stuck_closed", "valve.stuck"]
    assert [row["fault"] for row in content["travel"]] == faults
    infinite = [row for row in content["exhaust"] if row["time_s"] == math.inf]
    assert {row["reason"] for row in infinite} == {"supplied"}
    assert "does not certify" in content["statement"]


def test_a_failed_run_has_no_numbers(monkeypatch):
    from poppet.audit import safety_runs
    from poppet.engine.problem import Outcome

    real = safety_runs.solve

    def fail(problem, solver):
        from dataclasses import replace

        return replace(real(problem, solver), outcome=Outcome.STALLED)

    monkeypatch.setattr(safety_runs, "solve", fail)
    audit = audit_safety(tank_circuit(), {"dump.command": 0}, at="0.7 s", kinds=())
    assert math.isnan(audit.exhaust_of("tank").time)
    assert not audit.exhaust_of("tank").is_exhausted
    assert [note.code for note in audit.notes] == ["safety.no_selection", "safety.failed"]


def stop_after(count: int):
    def progress(done: int, total: int, last: str) -> None:
        if done == count:
            raise KeyboardInterrupt

    return progress


def test_an_interrupted_audit_keeps_complete_faults():
    audit: SafetyAudit = audit_safety(tank_circuit(), {"dump.command": 0}, at="0.7 s", progress=stop_after(2))
    assert not audit.is_whole
    assert 1 <= len(audit.exhaust) < 4


@pytest.mark.parametrize(
    ("events", "options", "code", "address"),
    [
        ({}, {}, "safety.no_event", ""),
        ({"suply.pressure": "0 bar g"}, {}, "names.unknown", "suply.pressure"),
        ({"supply.pressure": "0 kg"}, {}, "quantity.other_quantity", "supply.pressure"),
        ({"supply.pressure": "-2 bar g"}, {}, None, "supply.pressure"),
        ({"valve.command": 2}, {}, "inputs.outside", "valve.command"),
        (VENT, {"at": "5 s"}, "safety.outside_run", "at"),
        (VENT, {"at": "-1 s"}, "safety.outside_run", "at"),
        (VENT, {"at": "0.5"}, None, "at"),
        (VENT, {"at": ["step"]}, "names.unknown", "step"),
        (VENT, {"threshold": "0 bar"}, "safety.not_positive", "threshold"),
        (VENT, {"threshold": "1.5 bar abs"}, None, "threshold"),
        (VENT, {"duration": "0 s"}, "safety.not_positive", "duration"),
        (VENT, {"kinds": ["stuk"]}, "fields.not_an_option", "kinds"),
        (VENT, {"samples": 10}, "safety.no_distributions", ""),
        (VENT, {"samples": -1}, "safety.negative_samples", "samples"),
        ({"supply.pressure": "6 bar g"}, {"at": "0.5 s"}, "safety.no_change", "supply.pressure"),
        ({"supply.pressure": "6 bar g"}, {}, "safety.no_change", "supply.pressure"),
        ({"valve.command": 0}, {"at": "0.1 s"}, "safety.no_change", "valve.command"),
    ],
)
def test_invalid_arguments(events, options, code, address):
    with pytest.raises(InputError) as caught:
        audit_safety(loads(SEQUENCE), events, **options)
    assert (caught.value.address or "") == address
    assert code is None or caught.value.code == code


def test_an_event_does_not_start_a_fault_that_starts_at_a_time_of_its_own():
    circuit = tank_circuit(fault="leak", leak_fraction=0.1, fault_start="0.1 s")
    with pytest.raises(InputError) as caught:
        audit_safety(circuit, {"dump.fault": 1, "dump.command": 0}, at="0.5 s")
    (error,) = caught.value.problems
    assert (error.code, error.address, error.facts["field"]) == ("safety.other_start", "dump.fault", "dump.fault_start")


def test_invalid_arguments_are_reported_together():
    with pytest.raises(InputError) as caught:
        audit_safety(loads(SEQUENCE), {"x.y": 1}, threshold=0.0, duration=-1.0, at="9 s", kinds=["x"])
    assert len(caught.value.problems) == 5


def test_steps_require_a_sequence_and_an_audit_a_volume():
    with pytest.raises(InputError) as caught:
        audit_safety(tank_circuit(), {"dump.command": 0}, at="steps")
    assert caught.value.code == "safety.no_sequence"
    only = Circuit({"supply": Reservoir(pressure="6 bar g"), "leak": Orifice(from_="supply", to="ambient", **FLOW)})
    with pytest.raises(InputError) as caught:
        audit_safety(only, VENT, at=0.0)
    assert caught.value.code == "safety.nothing"


def test_a_condition_of_a_sequence_cannot_be_an_event():
    text = SEQUENCE.replace('"elapsed > 0.195 s"', '"elapsed > 0.195 s and tank.pressure < 9 bar"')
    with pytest.raises(InputError) as caught:
        audit_safety(loads(text), {"plc.tank_pressure": "1 bar"})
    assert (caught.value.code, caught.value.address) == ("safety.declared", "plc.tank_pressure")
    assert caught.value.facts["place"] == "parts.plc.steps.rest.next.fill"


def test_an_event_below_ambient_pressure_has_a_note():
    notes = audit_safety(loads(SEQUENCE), {"supply.pressure": "0 bar"}, at="0.3 s", kinds=()).notes
    assert [note.address for note in notes if note.code == "safety.vacuum"] == ["supply.pressure"]
    vented = audit_safety(loads(SEQUENCE), VENT, at="0.3 s", kinds=()).notes
    assert "safety.vacuum" not in [note.code for note in vented]


def test_valves_without_a_stated_exhaust_have_a_note():
    ports = {"supply": "supply", "command": 1.0, "sonic_conductance": 1e-8, "critical_ratio": 0.3}
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "tank": Chamber(volume="2 l"),
        "stated": DirectionalValve(outlet="tank", exhaust="ambient", exhaust_conductance=2e-8, **ports),
        "assumed": DirectionalValve(outlet="tank", exhaust="ambient", **ports),
        "without": DirectionalValve(outlet="tank", **ports),
    }
    circuit = Circuit(parts).with_values({"run.duration": "1 s"})
    audit = audit_safety(circuit, VENT, at="0.5 s", kinds=("stuck",), duration="0.1 s")
    assert [note.facts["valves"] for note in audit.notes if note.code == "safety.assumed_exhaust"] == [["assumed"]]


def test_assumptions_of_the_circuit_are_notes_of_the_audit():
    valve = DirectionalValve(supply="tank", outlet="ambient", command=1.0, sonic_conductance=1e-8)
    circuit = Circuit({"tank": Chamber(volume="2 l"), "dump": valve}).with_values({"run.duration": "2 s"})
    audit = audit_safety(circuit, {"dump.command": 0}, at="0.7 s", kinds=("stuck",))
    assert "parts.assumed_ratio" in [note.code for note in audit.notes]
    assert set(audit.notes) >= set(circuit.static_notes)


def test_a_signal_continues_until_the_event():
    signals = {"valve.command": Steps([0.0, 0.2], [0.0, 1.0]), "load.load_force": Constant(5.0)}
    circuit = falling_circuit().with_signals(signals)
    with pytest.raises(InputError) as caught:
        audit_safety(circuit, {"valve.command": 0}, at=["0.1 s", "0.6 s"], kinds=())
    assert (caught.value.code, caught.value.facts["time"]) == ("safety.no_change", 0.1)
    assert audit_safety(circuit, {"valve.command": 0}, at="0.6 s", kinds=()).travel_of("load").is_stopped


def test_a_sweep_is_that_of_the_run_without_an_event():
    circuit = falling_circuit().with_signals({"load.load_force": Chirp(0.0, 100.0, 0.5, 8.0)})
    stated = circuit.with_signals({"load.load_force": Chirp(0.0, 100.0, 0.5, 8.0, duration=1.0)})
    options = {"at": "0.6 s", "duration": "3 s", "kinds": ()}
    sweeps = [audit_safety(each, {"valve.command": 0}, **options).travel_of("load").path for each in (circuit, stated)]
    assert sweeps[0] == sweeps[1]
