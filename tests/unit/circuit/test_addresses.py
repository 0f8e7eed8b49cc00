"""Changes of parameters by address: several of one member, and inherited fields."""

from __future__ import annotations

import dataclasses

import pytest

from poppet import Chamber, Circuit, Reservoir
from poppet.core.errors import InputError, InputErrors
from poppet.parts import ProportionalValve
from poppet.signals import Constant

FAST_SOLENOIDS = {
    f"valve.pilot.{solenoid}.{name}": value
    for solenoid in ("fill", "vent")
    for name, value in {"frequency": "1 kHz", "opening_delay": 0.0, "closing_delay": 0.0}.items()
}


def circuit() -> Circuit:
    valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l")
    return Circuit({"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="1 l")})


@pytest.mark.parametrize("turn", [1, -1])
def test_changes_of_one_member_are_checked_together(turn):
    # 1 kHz alone leaves the delays of the library set no time.
    numbers = circuit().with_values(dict(list(FAST_SOLENOIDS.items())[::turn])).numbers()
    assert numbers["valve.pilot.fill.frequency"].value == 1e3
    assert numbers["valve.pilot.vent.opening_delay"].value == 0.0
    with pytest.raises(InputError) as caught:
        circuit().with_values({key: value for key, value in FAST_SOLENOIDS.items() if key.endswith("frequency")})
    assert caught.value.address == "valve.pilot.fill.frequency"


@pytest.mark.parametrize("field", ["electronics.preset", "electronics.data", "main_stage.mode", "pilot.supply"])
def test_inherited_field_of_a_member_is_rejected(field):
    member = field.partition(".")[0]
    with pytest.raises(InputError) as caught:
        circuit().with_values({f"valve.{field}": "fast"})
    assert (caught.value.code, caught.value.address) == ("address.told", f"valve.{field}")
    assert caught.value.facts["whole"] == "valve"
    assert circuit().with_values({"valve.preset": "fast"}).parts["valve"].members[member] is not None


@pytest.mark.parametrize(
    ("whole", "part", "value"),
    [
        ("valve.pilot", "valve.pilot.volume", {"volume": "6 cm^3"}),
        ("valve.main_stage.upper_spring", "valve.main_stage.upper_spring.preload", {"rate": 2e3, "preload": 1e-3}),
    ],
)
def test_table_and_one_of_its_parameters_are_rejected_together(whole, part, value):
    with pytest.raises(InputError) as caught:
        circuit().with_values({whole: value, part: 1e-3})
    assert (caught.value.code, caught.value.address) == ("address.whole_and_part", whole)


@pytest.mark.parametrize("name", ["setpoint", "power"])
def test_input_without_a_parameter_is_rejected(name):
    with pytest.raises(InputError) as caught:
        circuit().with_values({f"valve.{name}": 1.0})
    assert (caught.value.code, caught.value.address) == ("address.is_input", f"valve.{name}")


def test_falling_scaling_is_one_error():
    driven = dataclasses.replace(circuit(), signals={"valve.setpoint": Constant(3e5)})
    with pytest.raises(InputError) as caught:
        driven.with_values({"valve.electronics.scaling.high": "0.5 bar"}).simulate(0.1)
    assert caught.value.address == "valve.electronics.scaling.high"


def test_all_errors_of_a_member_are_reported():
    with pytest.raises(InputErrors) as caught:
        circuit().with_values({"valve.pilot.volum": 1.0, "valve.pilot.fill.frequenzy": 1.0, "valve.pilot.volume": 1e-6})
    assert [problem.address for problem in caught.value.problems] == [
        "valve.pilot.volum",
        "valve.pilot.fill.frequenzy",
    ]
