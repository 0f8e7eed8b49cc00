"""What runs with complete valves say about targets, power and the pilot volume."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.core.codes import Note
from poppet.core.note_groups import grouped
from poppet.parts import PID, PilotStage, ProportionalValve
from poppet.parts.proportional_valve import _oscillation_notes
from poppet.signals import Constant, Prbs, Sine, Steps


def notes(signals: dict[str, object], duration: float = 2.0, **fields: object) -> tuple[Note, ...]:
    valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", **fields)
    tank = Chamber(volume="1 l", wall_conductance=1.0)
    circuit = Circuit({"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": tank}, signals)
    return circuit.simulate(duration, 1e-3).remarks


def test_many_missed_plateaus_are_shown_as_one_with_the_worst():
    said = notes({"valve.setpoint": Prbs(2e5, 4e5, 0.05, seed=3)}, 6.0)
    assert len(said) > 10
    assert {note.code for note in said} == {"valve.not_reached"}
    (shown,) = grouped(said)
    assert (shown.code, shown.address, shown.facts["more"]) == ("several.worst", "valve", len(said) - 1)
    assert shown.facts["size"] == max(note.facts["missed_bar"] for note in said)
    assert shown.facts["size"] == pytest.approx(
        max(abs(note.facts["outlet_bar"] - note.facts["target_bar"]) for note in said)
    )


def small_volume(connections, controllers, signals):
    valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l")
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": valve,
        "tank": Chamber(volume="0.03 l", wall_conductance=0.1),
        **controllers,
    }
    return Circuit(parts, signals, connections=connections).simulate(2.0, 2e-3)


def test_an_oscillating_outlet_has_a_note_with_and_without_a_controller():
    alone = small_volume({}, {}, {"valve.setpoint": Constant(3e5)})
    outer = {
        "source": Reservoir(pressure="5 bar"),
        "feed": Orifice(from_="source", to="load", sonic_conductance=1e-11, critical_ratio=0.3),
        "load": Chamber(volume="10 l"),
        "c": PID(command_quantity="pressure", gain=2e-5, bias="3 bar", lower_limit="1 bar", upper_limit="6 bar"),
    }
    driven = small_volume({"c.measurement": "load.pressure", "valve.setpoint": "c.command"}, outer, {})
    assert np.count_nonzero(np.diff(driven["valve.target_pressure"])) > 900
    for recording in (alone, driven):
        (note,) = [note for note in recording.remarks if note.code == "valve.not_held"]
        assert note.facts["target_bar"] == pytest.approx(3.0, abs=1e-3)
        assert 0.1 < note.facts["swing_bar"] < 0.5


TIME = np.arange(2000) * 1e-3
RAMP = 3e5 + 1e4 * TIME


@pytest.mark.parametrize(
    ("outlet", "target", "is_noted"),
    [
        (RAMP + 1.5e4 * np.sin(2 * np.pi * 10.0 * TIME), RAMP, True),
        (RAMP + 1.5e4 * np.exp(-10.0 * TIME) * np.sin(2 * np.pi * 10.0 * TIME), RAMP, False),  # decays
        (RAMP + 2e3 * np.sin(2 * np.pi * 10.0 * TIME), RAMP, False),  # within 1 % of the span
        (  # follows with a lag
            3e5 + 3e4 * np.sin(2 * np.pi * 10.0 * TIME - 0.8),
            3e5 + 4e4 * np.sin(2 * np.pi * 10.0 * TIME),
            False,
        ),
    ],
)
def test_oscillations_about_a_changing_target(outlet, target, is_noted):
    is_driven = np.ones(TIME.size, dtype=bool)
    found = _oscillation_notes(TIME, outlet, target, 6e3, is_driven, is_driven)
    assert [note.code for note in found] == (["valve.not_held"] if is_noted else [])
    if found:
        assert found[0].facts["swing_bar"] == pytest.approx(0.3, abs=0.03)  # the ramp adds 25 mbar


def test_a_target_missed_without_power_has_a_note():
    said = notes({"valve.setpoint": Steps([0.0, 1.0], [2e5, 4e5]), "valve.power": Steps([0.0, 0.8], [1.0, 0.0])})
    found = [note.facts for note in said if note.code == "valve.not_reached"]
    assert [(f["target_bar"], f["time"], f["unpowered"]) for f in found] == [(4.0, 2.0, True)]


def test_a_target_within_the_zero_suppression_is_no_target_that_was_missed():
    electronics = {"zero_suppression": 0.05}
    said = notes({"valve.setpoint": Steps([0.0, 1.0], [1e5, 1.2e5])}, electronics=electronics)
    assert said == (Note("valve.counts_as_zero", "valve", target_bar=1.2, time=1.0),)


@pytest.mark.parametrize("low", ["0 bar g", "1 bar"])
@pytest.mark.parametrize(("offset", "is_said"), [("55 mbar", False), ("65 mbar", True)])
def test_a_hundredth_of_the_span_is_allowed_however_its_ends_are_written(low, offset, is_said):
    electronics = {"scaling": {"low": low}, "outlet_sensor": {"offset": offset}, "converter": {"bits": 0}}
    said = notes({"valve.setpoint": Constant(3e5)}, 8.0, preset="precise", electronics=electronics)
    assert any(note.code == "valve.not_reached" for note in said) == is_said


def test_a_pilot_volume_below_the_swept_volume_has_a_note():
    said = notes({"valve.setpoint": Steps([0.0, 1.0], [3e5, 1e5])}, pilot={"volume": "0.3 cm^3"})
    found = [note for note in said if note.code == "valve.pilot_too_small"]
    assert [(note.address, note.facts["shown"]) for note in found] == [("valve.pilot.volume", "0.3 cm^3")]


@pytest.mark.parametrize(("amplitude", "is_said"), [(4.4e-6, False), (4.6e-6, True)])
def test_a_pilot_stage_alone_has_the_note_too(amplitude, is_said):
    pilot = PilotStage(supply="supply", exhaust="ambient", data="vppm_6l")
    circuit = Circuit(
        {"supply": Reservoir(pressure="7 bar"), "pilot": pilot},
        {"pilot.displacement": Sine(0.0, amplitude, 2.0)},
    )
    recording = circuit.simulate(1.0, 1e-3)
    assert any(note.code == "valve.pilot_too_small" for note in recording.remarks) == is_said
    assert recording["pilot.volume"].min() == pytest.approx(max(5e-6 - amplitude, 5e-7), rel=1e-4)
