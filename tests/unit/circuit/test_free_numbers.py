"""Free numbers: touched parameters and inputs, limits, and numbers that cannot be free."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir, load, loads
from poppet.circuit.free_numbers import FreeNumbers, free_numbers
from poppet.core.errors import InputError
from poppet.signals import Constant

EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.fixture
def circuit() -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="6 bar g"),
            "tank": Chamber(volume="10 l", initial_pressure="2 bar g"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=0.0, critical_ratio=0.3),
        }
    )


def moved(circuit: Circuit, free: FreeNumbers, numbers: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Parameters and inputs for other values of the free numbers."""
    p, u = circuit.instance.start()[1], circuit.instance.held_inputs({})
    free.write(numbers, free.base(p, u), p, u)
    return p, u


def code_of(circuit: Circuit, *addresses: str) -> list[tuple[str, str]]:
    with pytest.raises(InputError) as caught:
        free_numbers(circuit.instance, addresses)
    return [(error.code, error.address) for error in caught.value.problems]


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("position_control", {"valve.sonic_conductance": 3e-8, "valve.critical_ratio": 0.25, "valve.overlap": 0.01}),
        ("cylinder_position", {"supply.pressure": 5.5e5, "ambient.pressure": 0.98e5, "slide.friction.viscous": 7.0}),
        ("two_cylinders", {"supply.pressure": 5.5e5, "ambient.pressure": 1.02e5, "ambient.temperature": 280.0}),
        ("cylinder_cushioned", {"cylinder.cap.dead_volume": 3e-5}),
        # Fields of a compound part, which its members use.
        ("cylinder_cushioned", {"cylinder.leakage.sonic_conductance": 1e-10, "cylinder.bore": 0.0321}),
    ],
)
def test_acts_as_a_changed_circuit(name, changes):
    circuit = load(EXAMPLES / f"{name}.toml")
    changes = {a: v for a, v in changes.items() if a in {*circuit.numbers(), *circuit.instance.parameters}}
    free = free_numbers(circuit.instance, tuple(changes))
    # Together, not one at a time: gauge pressures follow the ambient pressure too.
    gauge = {"supply.pressure": changes["ambient.pressure"] - 1e5} if {"ambient.pressure"} <= changes.keys() else {}
    p, u = moved(circuit, free, np.array(list(changes.values())))
    absolute = {a: v + gauge.get(a, 0.0) for a, v in changes.items()}
    other = circuit.with_values(absolute).instance
    read = list(circuit.model.influences[0])
    np.testing.assert_allclose(p[read], other.start()[1][read], rtol=1e-9)
    np.testing.assert_allclose(u, other.held_inputs({}), rtol=1e-9)


def test_held_input_moves_with_its_parameter(circuit):
    free = free_numbers(circuit.instance, ["supply.pressure"])
    assert [circuit.instance.input_names[k] for k in free.inputs] == ["supply.pressure"]
    assert free.places.size == 0
    assert free.values.tolist() == [7e5]
    assert free.directions.tolist() == [[1.0]]


def test_gauge_pressure_follows_the_ambient_pressure(circuit):
    free = free_numbers(circuit.instance, ["ambient.pressure"])
    _, u = moved(circuit, free, np.array([1.013e5]))
    assert u[circuit.instance.input_names.index("supply.pressure")] == pytest.approx(7.013e5, rel=1e-12)


def test_units_and_limits(circuit):
    free = free_numbers(circuit.instance, ["leak.sonic_conductance", "leak.critical_ratio"])
    assert free.units == ("m^3/(s Pa)", "1")
    assert (free.low.tolist(), free.high.tolist()) == ([0.0, 0.0], [np.inf, 1.0])
    assert free.values.tolist() == [0.0, 0.3]


def test_no_numbers(circuit):
    free = free_numbers(circuit.instance, [])
    assert (free.values.size, free.directions.shape) == (0, (0, 0))


def test_all_errors_together(circuit):
    addresses = "tank.volme", "tank.thermal", "tank.initial_pressure", "tank.volume", "tank.volume", "fill.opening"
    assert code_of(circuit, *addresses) == [
        ("names.unknown", "tank.volme"),
        ("free.option", "tank.thermal"),
        ("free.no_effect", "tank.initial_pressure"),
        ("free.twice", "tank.volume"),
    ]


def test_signal_replaces_a_number(circuit):
    driven = circuit.with_signals({"supply.pressure": Constant(6e5)})
    assert code_of(driven, "supply.pressure") == [("free.no_effect", "supply.pressure")]


def test_input_without_a_number():
    circuit = load(EXAMPLES / "bleed_regulator.toml")
    assert code_of(circuit, "valve.pilot_pressure") == [("address.is_input", "valve.pilot_pressure")]


def test_nonlinear_relation_names_the_remedy():
    circuit = load(EXAMPLES / "cylinder_cushioned.toml")
    assert code_of(circuit, "slide.mass") == [("free.not_linear", "slide.mass")]
    damping = {"slide.friction.bristle_damping": circuit.instance.parameters["slide.friction.bristle_damping"]}
    free = free_numbers(circuit.with_values(damping).instance, ["slide.mass"])
    assert [circuit.model.parameters[k] for k in free.places] == ["slide.mass"]


def test_relation_inside_a_part():
    circuit = load(EXAMPLES / "cylinder_cushioned.toml")
    address = "cylinder.cap_cushion.diameter"
    assert code_of(circuit, address) == [("free.not_linear_inside", address)]


def test_value_at_its_upper_limit():
    text = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = 1e-8
critical_ratio = 0.3
opening = 1.0
[parts.tank]
kind = "chamber"
volume = "10 l"
"""
    circuit = loads(text)
    free = free_numbers(circuit.instance, ["fill.opening"])
    assert (free.values.tolist(), free.high.tolist(), free.inputs.size) == ([1.0], [1.0], 1)
