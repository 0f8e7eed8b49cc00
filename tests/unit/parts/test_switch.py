"""Switches with hysteresis."""

import numpy as np
import pytest

from poppet import Circuit, InputError, Orifice, Reservoir, Switch
from poppet.signals import Points


def recorded(switch, connections=None):
    vent = Orifice(from_="supply", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    parts = {"supply": Reservoir(pressure="5 bar"), "vent": vent, "sensor": switch}
    signals = {"supply.pressure": Points([0.0, 1.0, 2.0], [2e5, 6e5, 2e5])}
    return Circuit(parts, signals, connections=connections or {}).simulate(2.0, output_step="1 ms")


def test_switch_with_hysteresis():
    recording = recorded(Switch(measurement="supply.pressure", on_above="5 bar", off_below="4 bar"))
    time, state = recording.time, recording["sensor.state"]
    # 5 bar at 0.75 s, 4 bar at 1.5 s; the switch samples every millisecond.
    assert np.all(state[(time > 0.7511) & (time < 1.4999)] == 1.0)
    assert np.all(state[(time < 0.7499) | (time > 1.5011)] == 0.0)


def test_reversed_switch_by_a_connection():
    switch = Switch(on_below="3 bar", off_above="4 bar")
    recording = recorded(switch, {"sensor.measurement": "supply.pressure"})
    time, state = recording.time, recording["sensor.state"]
    # On from the first sample until 4 bar at 0.5 s, and again from 3 bar at 1.75 s.
    assert np.all(state[(time < 0.4999) | (time > 1.7511)] == 1.0)
    assert np.all(state[(time > 0.5011) & (time < 1.7499)] == 0.0)


def test_units_of_the_limits_select_the_quantity():
    assert Switch(on_above="98 mm", off_below="97 mm").unit == "m"
    assert Switch(on_above="4 bar", off_below=3e5).unit == "Pa"
    assert Switch(on_above="1.5", off_below=1).unit == "1"
    assert Switch(on_above=0.2, off_below=0.1, quantity="position").unit == "m"
    assert Switch(on_above="90 deg", off_below="80 deg").inputs()[0].unit == "rad"


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        ({}, "switch.limits", "on_above"),
        ({"on_above": "4 bar"}, "switch.limits", "on_above"),
        ({"on_above": "4 bar", "off_above": "3 bar"}, "switch.limits", "on_above"),
        ({"on_above": "4 bar", "off_below": "3 mm"}, "quantity.other_quantity", "off_below"),
        ({"on_above": "4 bar", "off_below": "3 bar", "measurement": 5}, "fields.not_a_name", "measurement"),
    ],
)
def test_invalid_fields(fields, code, address):
    with pytest.raises(InputError) as caught:
        Switch(**fields)
    assert (caught.value.code, caught.value.address) == (code, address)
    assert str(caught.value)


@pytest.mark.parametrize(
    "limits",
    [
        {"on_above": "4 bar", "off_below": "4 bar"},
        {"on_above": "3 bar g", "off_below": "5 bar"},
        {"on_below": "4 bar", "off_above": "3 bar"},
    ],
)
def test_contradictory_limits(limits):
    with pytest.raises(InputError) as caught:
        recorded(Switch(measurement="supply.pressure", **limits))
    assert (caught.value.code, caught.value.address) == ("switch.contradictory", f"sensor.{next(iter(limits))}")
