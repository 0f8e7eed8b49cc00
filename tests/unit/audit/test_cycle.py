"""Machine cycles: from a sequence, from a signal, and stated; cycles that do not exist or do not repeat."""

from __future__ import annotations

import pytest

import poppet
from poppet.audit.cycle import find_cycle, read_cycle
from poppet.audit.energy import audit_energy
from poppet.core.errors import InputError

MACHINE = """
[parts.plc]
kind = "sequence"
outputs = ["open"]
start = "begin"
sample_time = "10 ms"
[parts.plc.steps.begin]
next = { fill = "elapsed >= 0.055 s" }
[parts.plc.steps.fill]
on = ["open"]
next = { vent = "elapsed >= 0.2 s" }
[parts.plc.steps.vent]
next = { NEXT = "elapsed >= 0.3 s" }
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3
[parts.tank]
kind = "chamber"
volume = "0.1 l"
[connections]
"valve.command" = "plc.open"
[run]
duration = "3 s"
output_step = "0.1 s"
"""
SQUARE = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3
[parts.tank]
kind = "chamber"
volume = "0.1 l"
[signals."valve.command"]
kind = "square"
low = 0
high = 1
frequency = "2 Hz"
[run]
duration = "1.7 s"
"""


def problem(*arguments, **options) -> InputError:
    with pytest.raises(InputError) as caught:
        audit_energy(*arguments, **options)
    return caught.value


def test_a_cycle_lasts_from_one_entry_of_a_step_to_the_next_one():
    audit = audit_energy(poppet.loads(MACHINE.replace("NEXT", "fill")))
    # The sequence leaves its first step at 0.06 s, and then repeats two steps of 0.2 s and 0.3 s.
    assert audit.cycle.duration == pytest.approx(0.5)
    assert audit.cycle.end == pytest.approx(2.56)
    assert (audit.cycle.found_by, audit.cycle.source, audit.cycle.steps) == ("sequence", "plc", ("fill", "vent"))
    assert audit.cycle.change < 1e-3


def test_a_step_and_a_number_of_cycles_can_be_selected():
    circuit = poppet.loads(MACHINE.replace("NEXT", "fill"))
    one, three = audit_energy(circuit, step="vent"), audit_energy(circuit, step="plc.vent", count=3)
    assert one.cycle.start == pytest.approx(2.26)
    assert three.cycle.start == pytest.approx(1.26)
    assert three.cycle.duration == pytest.approx(0.5)
    assert three.cycle.steps == 3 * ("vent", "fill")
    assert three.air_used == pytest.approx(one.air_used, rel=1e-6)


def test_the_period_of_a_signal_is_a_cycle():
    audit = audit_energy(poppet.loads(SQUARE))
    assert (audit.cycle.start, audit.cycle.end, audit.cycle.found_by) == (1.0, 1.5, "signal")
    # The tank takes the air of one cycle.
    mass = audit.recording["tank.mass"][audit.recording.time >= 1.0]
    assert audit.air_used * 1.185 == pytest.approx(float(mass.max() - mass.min()), rel=1e-2)


def test_a_run_without_repetition_has_no_cycle():
    error = problem(
        poppet.loads(MACHINE.replace("NEXT", "end").replace("[parts.supply]", "[parts.plc.steps.end]\n[parts.supply]"))
    )
    assert (error.code, error.address) == ("cycle.no_repetition", "plc")
    assert error.facts == {"steps": ["begin", "fill", "vent", "end"], "end": 3.0}
    error = problem(poppet.loads(SQUARE.split("[signals")[0] + "[run]\nduration = 1.0"))
    assert error.code == "cycle.no_source"


def test_too_few_cycles_are_an_error():
    circuit = poppet.loads(MACHINE.replace("NEXT", "fill"))
    error = problem(circuit, step="begin")
    assert (error.code, error.facts["visits"]) == ("cycle.too_few", 1)
    error = problem(circuit, count=9)
    assert (error.code, error.facts["count"]) == ("cycle.too_few", 9)
    assert audit_energy(circuit, count=9, duration="6 s").cycle.count == 9
    error = problem(poppet.loads(SQUARE), count=4)
    assert (error.code, error.address) == ("cycle.too_short", "valve.command")


def test_an_unknown_step_is_an_error():
    circuit = poppet.loads(MACHINE.replace("NEXT", "fill"))
    error = problem(circuit, step="vnet")
    assert error.code == "names.unknown"
    assert "vent" in str(error)


def test_a_step_of_two_sequences_needs_its_sequence():
    second = """
[parts.other]
kind = "sequence"
outputs = ["on"]
start = "idle"
sample_time = "10 ms"
[parts.other.steps.idle]
next = { vent = "elapsed >= 0.1 s" }
[parts.other.steps.vent]
on = ["on"]
next = { idle = "elapsed >= 0.2 s" }
"""
    circuit = poppet.loads(MACHINE.replace("NEXT", "fill") + second)
    error = problem(circuit, step="vent")
    assert (error.code, error.facts["names"]) == ("cycle.several_steps", ["plc.vent", "other.vent"])
    for step, source in (("plc.vent", "plc"), ("other.vent", "other"), ("idle", "other")):
        assert audit_energy(circuit, step=step).cycle.source == source


@pytest.mark.parametrize("text", ["1 s", "2 s, 1 s", "1 s, 2 s, 3 s", "-1 s, 1 s"])
def test_a_stated_cycle_has_a_start_before_its_end(text: str):
    with pytest.raises(InputError) as caught:
        read_cycle(text)
    assert (caught.value.code, caught.value.address) == ("cycle.stated", "--cycle")


def test_a_stated_period_can_contain_several_cycles():
    one, two = (
        audit_energy(poppet.loads(SQUARE), cycle=text, count=n) for text, n in (("1 s, 1.5 s", 1), ("0.5 s, 1.5 s", 2))
    )
    assert two.cycle.duration == one.cycle.duration == 0.5
    assert two.air_used == pytest.approx(one.air_used, rel=5e-3)
    assert problem(poppet.loads(SQUARE), count=0).code == "cycle.no_count"


def test_a_stated_cycle_ends_in_the_run():
    circuit = poppet.loads(SQUARE)
    error = problem(circuit, cycle="1 s, 2 s")
    assert (error.code, error.facts) == ("cycle.beyond_end", {"end": 2.0, "duration": 1.7})
    assert audit_energy(circuit, cycle="1 s, 2 s", duration="2 s").cycle.duration == 1.0


def test_a_cycle_that_does_not_repeat_has_a_note():
    audit = audit_energy(poppet.loads(SQUARE), cycle="0 s, 0.2 s")
    (note,) = [note for note in audit.notes if note.code == "cycle.not_repeated"]
    assert note.facts["change"] > 50.0
    assert find_cycle(poppet.loads(SQUARE), audit.recording).start == 1.0
