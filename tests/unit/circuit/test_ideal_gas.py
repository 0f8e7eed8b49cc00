"""Notes on gas nodes whose gas is not ideal."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from poppet import Circuit, library
from poppet.circuit.ideal_gas import MAX_PRESSURES, TEMPERATURES, TOLERANCE
from poppet.circuit.options import GasChoice
from poppet.laws.physics.real_gas import deviation
from poppet.library.gases import GASES
from poppet.parts import Chamber, FlowSource, Orifice, Reservoir
from poppet.signals import Points


def circuit(pressure: str = "200 bar", signals=None, **gas) -> Circuit:
    parts = {
        "bottle": Reservoir(pressure=pressure),
        "fill": Orifice(from_="bottle", to="tank", effective_area="1 mm^2"),
        "tank": Chamber(volume="1 l", thermal="isothermal"),
    }
    return Circuit(parts, signals or {}, gas=GasChoice(**gas))


def said(notes) -> list[tuple[str, str]]:
    return [(note.code, note.address) for note in notes]


def test_a_bottle_of_nitrogen():
    """The equation of state gives Z = 1.052 and a flow error of -5.7 %."""
    (note,) = circuit(name="nitrogen").static_notes
    assert (note.code, note.address, note.facts["gas"]) == ("gas.not_ideal", "bottle", "nitrogen")
    assert (note.facts["pressure_bar"], note.facts["temperature"]) == (200.0, 293.15)
    assert note.facts["compressibility"] == pytest.approx(1.052, abs=0.012)
    assert note.facts["mass_percent"] == pytest.approx(5.2, abs=1.2)
    assert note.facts["flow_percent"] == pytest.approx(-5.7, abs=1.2)


def test_circuit_accepts_a_gas_object():
    by_name = circuit(name="nitrogen")
    parts = by_name.parts
    by_gas = Circuit(parts, gas=library.gas("nitrogen"))
    assert by_gas.gas == by_name.gas
    assert by_gas.static_notes == by_name.static_notes
    custom_gas = dataclasses.replace(library.gas("helium"), name="my helium")
    assert Circuit(parts, gas=custom_gas).gas.values() == GasChoice(name="helium").values()


def test_note_contains_the_largest_deviation_of_the_run():
    """Each gas node has one note, the tank only after a run that fills it."""
    filled = circuit(name="nitrogen").simulate("20 s").remarks
    assert said(filled) == [("gas.not_ideal", "bottle"), ("gas.not_ideal", "tank")]
    assert filled[1].facts["pressure_bar"] == pytest.approx(200.0, rel=1e-3)
    assert said(circuit(name="nitrogen").simulate("10 ms").remarks) == [("gas.not_ideal", "bottle")]


def test_signal_to_a_real_gas_state_gives_a_note():
    raised = circuit("7 bar", {"bottle.pressure": Points([0.0, 1.0, 2.0], [7e5, 9e6, 7e5])})
    assert raised.static_notes == ()
    (note,) = (note for note in raised.simulate("2 s").remarks if note.address == "bottle")
    assert (note.code, note.facts["pressure_bar"]) == ("gas.not_ideal", pytest.approx(90.0))


@pytest.mark.parametrize("gas", [{}, {"name": "nitrogen"}, {"name": "oxygen"}, {"name": "argon"}, {"name": "hydrogen"}])
def test_usual_pressures_give_no_note(gas):
    assert circuit("10 bar", **gas).simulate("1 s").remarks == ()


def test_carbon_dioxide_gives_notes_at_6_and_70_bar():
    assert said(circuit("6 bar", name="carbon dioxide").static_notes) == [("gas.not_ideal", "bottle")]
    assert said(circuit("70 bar", name="carbon dioxide").static_notes) == [("gas.no_gas", "bottle")]


def test_gas_without_a_name_is_unknown():
    assert said(circuit(gas_constant=296.8).simulate("1 s").remarks) == [("gas.unknown", "gas")]


def test_changed_values_of_a_named_gas_give_a_note():
    library_notes = circuit(name="nitrogen").static_notes
    changed_notes = dataclasses.replace(circuit(), gas=GasChoice(name="nitrogen", isentropic_exponent=1.5)).static_notes
    assert said(changed_notes) == [("options.own_gas_numbers", "gas"), ("gas.not_ideal", "bottle")]
    assert changed_notes[1:] == library_notes


@pytest.mark.parametrize(("text", "is_volume"), [("10 l/min ANR", True), ("10 l/min (N)", True), ("10 g/s", False)])
def test_volume_flow_of_air_in_helium_gives_a_note(text, is_volume):
    parts = {"source": FlowSource(to="tank", mass_flow_rate=text), "tank": Chamber(volume="1 l")}
    messages = said(Circuit(parts, gas=GasChoice(name="helium")).static_notes)
    assert messages == ([("gas.volume_of_air", "source.mass_flow_rate")] if is_volume else [])
    assert Circuit(parts).static_notes == ()


@pytest.mark.parametrize(
    ("gas", "law", "thermal", "is_said"),
    [
        ("helium", "natural", "energy", True),
        ("helium", "natural", "isothermal", False),
        ("helium", "constant", "energy", False),
        ("nitrogen", "natural", "energy", False),
        ("air", "natural", "energy", False),
    ],
)
def test_heat_transfer_law_of_air_in_helium_gives_a_note(gas, law, thermal, is_said):
    sizes = {"wall_area": 0.05, "height": 0.2} if law == "natural" else {}
    tank = Chamber(volume="1 l", heat_transfer=law, thermal=thermal, **sizes)
    source = FlowSource(to="tank", mass_flow_rate="1 g/s")
    messages = said(Circuit({"source": source, "tank": tank}, gas=GasChoice(name=gas)).static_notes)
    assert (("gas.heat_as_of_air", "tank.heat_transfer") in messages) == is_said


@pytest.mark.parametrize("name", MAX_PRESSURES)
def test_usual_states_are_close_to_ideal(name):
    """No real-gas computation is needed for usual states."""
    gas = GASES[name]
    for pressure in np.geomspace(1e4, MAX_PRESSURES[name], 12):
        for temperature in np.linspace(*TEMPERATURES, 7):
            deviations = deviation(float(pressure), float(temperature), gas.as_real, float(gas.isentropic_exponent))
            assert max(abs(deviations.mass), abs(deviations.flow)) <= TOLERANCE
