"""Tests of the export model: indices, start values, and parameters that can change."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.circuit.number_specs import number_specs
from poppet.core.errors import InputError
from poppet.deploy.export_model import ExportModel, build_export_model, find_tied
from poppet.parts.fields import flatten
from poppet.timeseries.signals import Square
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"


def of(name: str) -> ExportModel:
    return build_export_model(load(EXAMPLES / f"{name}.toml"), name)


@pytest.mark.parametrize("name", ["fill_staircase", "datasheet_valve", "pressure_control"])
def test_a_free_parameter_changes_no_other_parameter(name):
    circuit, export_model = load(EXAMPLES / f"{name}.toml"), of(name)
    kernel = circuit.kernel
    free = {k: number for k, number in enumerate(export_model.parameters) if number.is_free}
    assert len(free) >= 8
    for k, number in free.items():
        value = number.value * (1.0 - 1e-3) if number.value else 1e-3
        p = export_model.problem.p.copy()
        p[k] = value
        x = kernel.start(p)
        known_x, known_p = circuit.with_values({number.address: value}).instance.start()
        assert np.array_equal(p, known_p), number.address
        assert np.array_equal(x, known_x), number.address


@pytest.mark.parametrize("name", ["datasheet_valve", "muscle_lift"])
def test_tied_parameters_agree_with_a_change_of_the_whole_circuit(name):
    """Change each parameter alone with `with_values`: a tied one changes others or the structure, or is rejected."""
    circuit = load(EXAMPLES / f"{name}.toml")
    specs, tied = number_specs(circuit), set()
    for section in ("ambient", "gas"):
        specs |= {f"{section}.{key}": spec for key, spec, _ in flatten(getattr(circuit, section))}
    for address in circuit.numbers().keys() & circuit.parameters.keys():
        value = circuit.parameters[address]
        candidates = [value * (1.0 + sign * 1e-6) if value else sign * 1e-6 for sign in (1.0, -1.0)]
        neighbour = next((candidate for candidate in candidates if specs[address].holds(candidate)), None)
        try:
            changed = circuit.with_values({address: neighbour})
        except InputError:
            tied.add(address)
            continue
        if changed.parameters != {**circuit.parameters, address: neighbour} or changed.structure != circuit.structure:
            tied.add(address)
    assert find_tied(circuit) == tied
    assert len(tied) >= 5


def test_fixed_parameters_have_a_reason():
    numbers = {number.address: number.fixed for number in of("datasheet_valve").parameters}
    assert numbers["valve.critical_ratio"] == numbers["ambient.pressure"] == "tied"
    assert numbers["valve.delay"] == "delay"
    assert numbers["valve.sonic_conductance"] == numbers["gas.conductance_factor"] == "derived"
    assert not numbers["chamber.volume"]


@pytest.mark.parametrize("name", ["fill_staircase", "pressure_regulator"])
def test_limits_are_the_extreme_valid_values(name):
    """A volume of 0 gives temperatures that are no numbers."""
    specs, export_model = number_specs(load(EXAMPLES / f"{name}.toml")), of(name)
    free = [number for number in export_model.parameters if number.is_free and number.address in specs]
    assert len(free) > 10
    for number in free:
        spec = specs[number.address]
        for end, direction in ((number.low, -1.0), (number.high, 1.0)):
            outside = end + direction * max(2.0 * np.finfo(float).eps * abs(end), 2.0 * np.finfo(float).tiny)
            assert not np.isfinite(end) or (spec.holds(end) and not spec.holds(outside)), number.address


def test_quantities_have_the_order_of_the_model():
    export_model = of("pressure_control")
    model, problem = export_model.model, export_model.problem
    assert tuple(number.address for number in export_model.parameters) == model.parameters
    assert [number.value for number in export_model.parameters] == problem.p[: len(export_model.parameters)].tolist()
    assert [state.value for state in export_model.states] == problem.x0[: len(export_model.states)].tolist()
    assert [quantity.value for quantity in export_model.memory] == problem.p[len(export_model.parameters) :].tolist()
    assert [(quantity.address, quantity.unit) for quantity in export_model.outputs] == list(model.outputs)
    (setpoint,) = (item for item in export_model.inputs if item.address == "regulator.setpoint")
    assert setpoint.is_driven
    constant_inputs = {item.address: item for item in export_model.inputs if item.parameter >= 0 and not item.is_driven}
    assert constant_inputs.keys() == {"supply.pressure", "supply.temperature"}
    assert all(item.value == export_model.parameters[item.parameter].value for item in constant_inputs.values())


def test_missing_duration_and_too_many_segments_are_refused():
    circuit = load(EXAMPLES / "fill_staircase.toml")
    with refused("fields.missing", "run.duration"):
        build_export_model(replace(circuit, run=replace(circuit.run, duration=None)))
    quick = Square(low=1e5, high=2e5, frequency=1e3, duty=0.5)
    with refused("deploy.segments", "signals", most=100_000):
        build_export_model(replace(circuit, signals={"valve.pilot_pressure": quick}))
