"""Tables of a watch: conversion to SI, arrays over the free numbers, and all errors together."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from poppet import Run
from poppet.core.errors import InputErrors
from poppet.monitoring.windows import Window
from poppet.signals import Constant, Steps
from refusals import refused
from watched_tank import TABLES, TANK, plan_of_tank, watched_tank

LEAK = {"leak": TABLES["faults"]["leak"]}
GAUGE = {"column": "p", "unit": "bar g", "noise": "5 mbar"}


def test_sensors_and_driven_inputs():
    plan = plan_of_tank()
    (gauge,), (opening,) = plan.channels, plan.inputs
    assert (gauge.address, gauge.column, gauge.si_unit, gauge.is_gauge) == ("tank.pressure", "p", "Pa", True)
    assert (gauge.noise, gauge.offset) == (500.0, 200.0)
    assert gauge.to_si(4.0) == 5e5
    assert (opening.column, opening.to_si(25.0), opening.low, opening.high, opening.hold) == ("u", 0.25, 0.0, 1.0, True)
    assert plan.instance.input_names[opening.index] == "consumer.opening"


def test_units_of_sensors():
    channels = plan_of_tank(
        measured={
            "tank.temperature": {"unit": "degC", "noise": "0.5 K"},
            "valve.mass_flow_rate": {"unit": "l/min", "noise": "1 l/min ANR"},
            "tank.pressure": {"noise": "5 mbar"},
        }
    ).channels
    temperature, flow, pressure = channels
    assert temperature.to_si(20.0) == 293.15
    assert temperature.column == "tank.temperature"
    assert flow.to_si(60.0) == pytest.approx(1.185e-3, rel=1e-15)  # density of ISO 8778: 1.185 kg/m^3
    assert flow.noise == pytest.approx(1.185e-3 / 60.0, rel=1e-15)
    assert pressure.to_si(5e5) == 5e5


def test_gauge_readings_refer_to_the_ambient_pressure_of_the_circuit():
    plan = plan_of_tank(watched_tank(TANK + '\n[ambient]\npressure = "1.01325 bar"\n'))
    assert plan.channels[0].to_si(0.0) == 101325.0


def test_tolerance_is_that_of_the_runs():
    plan = plan_of_tank()
    coarse = dataclasses.replace(plan.circuit, run=Run(relative_tolerance=1e-4))
    assert plan.tolerance == 1e-6
    assert Window(dataclasses.replace(plan, circuit=coarse)).model.tolerance == 1e-4


def test_arrays_over_the_free_numbers():
    plan = plan_of_tank()
    assert plan.names == (
        "leak", "supply_low", "ambient.pressure", "valve.sonic_conductance", "offset of tank.pressure",
    )  # fmt: skip
    assert plan.units == ("m^3/(s Pa)", "Pa", "Pa", "m^3/(s Pa)", "Pa")
    assert plan.reference.tolist() == [0.0, 7e5, 1e5, 1e-8, 0.0]
    assert plan.prior.tolist() == pytest.approx([1e-10, 3e4, 1500.0, 5e-10, 200.0])
    assert plan.cap.tolist() == pytest.approx([1e-9, 3e5, 1500.0, 5e-10, 200.0])
    # Variance per second: alarm^2 / (1000 windows) for a fault, drift^2 / 3600 s for a nuisance, none for an offset.
    assert plan.walk.tolist() == pytest.approx([1e-20 / 3e4, 9e8 / 3e4, 1e4 / 3600.0, 0.0, 0.0])
    # A gauge reads the difference to the ambient pressure; an offset adds to the reading.
    assert plan.effects.tolist() == [[0.0, 0.0, -1.0, 0.0, 1.0]]
    assert [fault.direction for fault in plan.faults] == [1, -1]
    # Only the estimate of a fault can exceed the limit of its parameter.
    assert plan.low.tolist() == pytest.approx([-1e-10, -3e4, 0.0, 0.0, -np.inf])


def test_free_numbers_move_parameters_and_inputs():
    plan = plan_of_tank()
    parameters = [plan.instance.model.parameters[i] for i in plan.free.places]
    inputs = [plan.instance.input_names[i] for i in plan.touched_inputs]
    rows = dict(zip([*parameters, *inputs], plan.directions.tolist(), strict=True))
    assert rows["leak.sonic_conductance"] == [1.0, 0.0, 0.0, 0.0, 0.0]
    assert rows["supply.pressure"] == [0.0, 1.0, 0.0, 0.0, 0.0]
    assert rows["ambient.pressure"] == [0.0, 0.0, 1.0, 0.0, 0.0]


def test_a_gauge_supply_moves_with_the_ambient_pressure_unless_it_is_driven():
    circuit = watched_tank(TANK.replace('"7 bar"', '"6 bar g"'))
    faults = {"leak": TABLES["faults"]["leak"]}
    moved = plan_of_tank(circuit, faults=faults)
    supply = moved.instance.input_names.index("supply.pressure")
    (k,) = np.flatnonzero(moved.touched_inputs == supply)
    row = moved.directions[len(moved.free.places) + k]
    assert row[moved.names.index("ambient.pressure")] == pytest.approx(1.0)
    driven = plan_of_tank(circuit, faults=faults, measured={**TABLES["measured"], "supply.pressure": {"unit": "bar"}})
    assert supply not in driven.touched_inputs
    assert driven.directions.shape == (len(driven.free.places) + len(driven.touched_inputs), len(driven.names))


def test_a_noise_makes_an_input_a_sensor():
    plan = plan_of_tank(measured={"tank.pressure": GAUGE, "supply.pressure": {"unit": "bar", "noise": "2 kPa"}})
    assert [channel.address for channel in plan.channels] == ["tank.pressure", "supply.pressure"]
    assert plan.inputs == ()


def test_samples_replace_a_signal():
    signals = {"consumer.opening": Steps([0.0, 1.0], [0.0, 1.0]), "valve.opening": Constant(0.5)}
    circuit = dataclasses.replace(watched_tank(), signals=signals)
    assert set(plan_of_tank(circuit).instance.signals) == {"valve.opening"}
    with refused("watch.signal", "signals.consumer.opening"):
        plan_of_tank(circuit, measured={"tank.pressure": GAUGE})


def test_inputs_can_be_interpolated():
    measured = {"tank.pressure": GAUGE, "consumer.opening": {}, "valve.opening": {"hold": True}}
    plan = plan_of_tank(measured=measured, settings={"hold": False})
    assert [item.hold for item in plan.inputs] == [False, True]


def test_relative_values_refer_to_the_value_of_the_circuit():
    nuisances = {"valve.sonic_conductance": {"relative_sigma": "5 %", "relative_drift": 0.01}}
    (nuisance,) = plan_of_tank(nuisances=nuisances).nuisances
    assert (nuisance.sigma, nuisance.drift) == (pytest.approx(5e-10), pytest.approx(1e-10))


def test_all_errors_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        plan_of_tank(
            measured={
                "tank.presure": {"column": "p", "noise": "5 mbar"},
                "tank": {"pressure": {}},
                "tank.temperature": {"unit": "bar", "noise": "0.5 degC"},
                "consumer.opening": {"unit": "parsec", "gain": 3},
                "valve.opening": 5,
                "tank.pressure": {"column": "p"},
                "supply.pressure": {"unit": "bar"},
            },
            faults={
                "time": {"address": "leak.sonic_conductance", "alarm": "3 bar"},
                "two words": {"address": "supply.pressure", "alarm": "1 bar", "direction": "left"},
                "typo": {"address": "leak.sonic_condctance", "alarm": 1.0},
                "empty": {},
                "number": 7,
            },
            nuisances={
                "leak.sonic_conductance": {"relative_sigma": 0.1},
                "ambient.pressure": {"sigma": "5 mbar g", "relative_sigma": 0.1},
                "ambient.temperature": {"sigma": "2 K", "relative_sigma": 0.1},
                "consumer.opening": {"sigma": 0.1},
                "tank.volume": {},
            },
            settings={"window": "5 bar", "alarm_dely": "1 s"},
        )
    assert [(item.code, item.address) for item in caught.value.problems] == [
        ("fields.unknown", "watch.alarm_dely"),
        ("quantity.other_quantity", "watch.window"),
        ("names.unknown", "measured.tank.presure"),
        ("watch.unquoted", "measured.tank"),
        ("quantity.point_of_scale", "measured.tank.temperature.noise"),
        ("unit.other_quantity", "measured.tank.temperature.unit"),
        ("fields.unknown", "measured.consumer.opening.gain"),
        ("unit.unknown", "measured.consumer.opening.unit"),
        ("fields.no_table", "measured.valve.opening"),
        ("fields.missing", "measured.tank.pressure.noise"),
        ("watch.same_column", "measured.tank.pressure.column"),
        ("watch.fault_name", "faults.time"),
        ("quantity.other_quantity", "faults.time.alarm"),
        ("watch.fault_name", "faults.two words"),
        ("watch.driven_and_free", "faults.two words.address"),
        ("fields.not_an_option", "faults.two words.direction"),
        ("names.unknown", "faults.typo.address"),
        ("fields.missing", "faults.empty.address"),
        ("fields.no_table", "faults.number"),
        ("watch.fault_and_nuisance", "nuisance.leak.sonic_conductance"),
        ("watch.relative_to_zero", "nuisance.leak.sonic_conductance.relative_sigma"),
        ("quantity.gauge_difference", "nuisance.ambient.pressure.sigma"),
        ("watch.given_twice", "nuisance.ambient.temperature"),
        ("watch.driven_and_free", "nuisance.consumer.opening"),
        ("fields.missing", "nuisance.tank.volume.sigma"),
    ]


@pytest.mark.parametrize(
    ("code", "address", "tables"),
    [
        ("watch.no_sensor", "measured", {"measured": {"consumer.opening": {}}}),
        ("watch.no_fault", "faults", {"faults": {}}),
        ("fields.no_table", "measured", {"measured": 5}),
        ("fields.no_table", "faults", {"faults": ["leak"]}),
        ("fields.no_table", "nuisance", {"nuisances": 5}),
        ("fields.out_of_range", "watch.window", {"settings": {"window": 0.0}}),
        ("fields.out_of_range", "measured.tank.pressure.noise", {"measured": {"tank.pressure": {"noise": 0.0}}}),
        ("fields.other_type", "watch.hold", {"settings": {"hold": "yes"}}),
        (
            "watch.gauge_drives",
            "measured.supply.pressure",
            {"measured": {"tank.pressure": GAUGE, "supply.pressure": {"unit": "bar g"}}, "faults": LEAK},
        ),
        ("free.no_effect", None, {"nuisances": {"tank.initial_pressure": {"sigma": "1 bar"}}}),
    ],
)
def test_invalid_tables(code, address, tables):
    with refused(code, address):
        plan_of_tank(**tables)
