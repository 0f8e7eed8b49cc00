"""What a reservoir gives: against the mass of the tank, and as a metric of an ensemble in l ANR."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import loads

REGULATED = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.room]
kind = "reservoir"
pressure = "1 bar"
[parts.valve]
kind = "main_stage"
data = "varga2012"
mode = "regulator"
supply = "supply"
outlet = "tank"
exhaust = "room"
[parts.tank]
kind = "chamber"
volume = "2 l"
wall_conductance = "4 W/K"
[parts.leak]
kind = "orifice"
from = "tank"
to = "room"
sonic_conductance = "1e-9 m^3/(s Pa)"
critical_ratio = 0.3
[signals."valve.pilot_pressure"]
kind = "steps"
times = ["0 s", "2 s"]
values = ["5 bar", "2 bar"]
[run]
duration = "4 s"
output_step = "1 ms"
[ensemble]
runs = 4
[ensemble.numbers]
"tank.volume" = { distribution = "normal", relative_sigma = 0.02 }
"valve.upper_spring.rate" = { distribution = "uniform", low = "1.8 kN/m", high = "2.2 kN/m" }
[ensemble.metrics]
air = { of = "supply.mass_flow_rate", metric = "integral", unit = "l ANR" }
[requirements]
sparing = "air < 100 l ANR"
"""


def test_what_a_reservoir_gives():
    run = loads(REGULATED).simulate()
    supply, room = run["supply.mass_flow_rate"], run["room.mass_flow_rate"]
    np.testing.assert_array_equal(supply, run["valve.supply_mass_flow_rate"])
    np.testing.assert_array_equal(room, -run["valve.exhaust_mass_flow_rate"] - run["leak.mass_flow_rate"])
    assert supply[run.time < 1.0].max() > 0.0 > room.min()
    into = np.trapezoid(supply + room, run.time)
    assert into == pytest.approx(run["tank.mass"][-1] - run["tank.mass"][0], rel=2e-3)
    assert {"supply.mass_flow_rate", "room.mass_flow_rate"} <= run.inner


def test_the_air_that_a_supply_gave_is_a_metric():
    circuit = loads(REGULATED)
    found = circuit.ensemble().to_pandas()
    numbers = ["tank.volume", "valve.upper_spring.rate"]
    for row, air in zip(found[numbers].to_numpy(), found["air"], strict=True):
        single = circuit.with_values(dict(zip(numbers, map(float, row), strict=True))).simulate()
        assert air == pytest.approx(1e3 * np.trapezoid(single["supply.mass_flow_rate"], single.time) / 1.185, rel=1e-5)
        assert air > 1.0
