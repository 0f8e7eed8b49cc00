"""Notes on values whose unit is probably missing."""

from __future__ import annotations

from typing import Any

import pytest

from poppet import Circuit
from poppet.circuit.options import Run
from poppet.core.codes import Note
from poppet.parts import Chamber, Cylinder, MainStage, Mass, Orifice, Reservoir, Tube
from poppet.signals import Signal, Steps


def notes(signals: dict[str, Signal] | None = None, **changed: Any) -> tuple[Note, ...]:
    values = {"pressure": "7 bar", "temperature": "20 degC", "sonic_conductance": 1e-8, "volume": 0.2, **changed}
    size = {key: values[key] for key in ("sonic_conductance",)}
    parts = {
        "supply": Reservoir(pressure=values["pressure"], temperature=values["temperature"]),
        "fill": Orifice(from_="supply", to="tank", critical_ratio=0.3, **size),
        "tank": Chamber(volume=values["volume"]),
    }
    static_notes = Circuit(parts, signals or {}, Run(duration="1 s")).static_notes
    # Air that is liquid has a note of its own.
    return tuple(note for note in static_notes if note.code.startswith("doubt."))


@pytest.mark.parametrize(
    ("changed", "address", "meant"),
    [
        ({"pressure": 6}, "supply.pressure", "bar"),
        ({"temperature": 20}, "supply.temperature", "degC"),
        ({"sonic_conductance": 0.5}, "fill.sonic_conductance", "dm^3/(s bar)"),
        ({"volume": 20}, "tank.volume", "l"),
        ({"volume": {"value": 20, "source": "measured"}}, "tank.volume", "l"),
    ],
)
def test_unusual_value_without_unit_gives_a_note(changed, address, meant):
    (note,) = notes(**changed)
    assert (note.code, note.address, note.facts["meant"]) == ("doubt.bare_number", address, meant)


@pytest.mark.parametrize(
    "changed",
    [{}, {"pressure": 0.0}, {"pressure": "6 Pa"}, {"temperature": "90 K"}, {"volume": "20 m^3"}, {"pressure": 2e3}],
)
def test_units_and_usual_values_give_no_note(changed):
    assert notes(**changed) == ()


def machine(**values: Any) -> Circuit:
    side = {"dead_volume": "5 cm^3"}
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "line": Tube(from_="supply", to="cylinder.cap", length=values.get("length", 20.0), bore="6 mm"),
        "cylinder": Cylinder(body="slide", bore=values.get("bore", 0.025), stroke_length="0.2 m", cap=side, rod=side),
        "slide": Mass(mass=values.get("mass", 4.0), inclination=values.get("inclination", 1.5)),
        "bleed": Orifice(from_="cylinder.rod", to="ambient", effective_area=values.get("effective_area", 1e-6)),
    }
    return Circuit(parts)


@pytest.mark.parametrize(
    ("field", "value", "address", "meant"),
    [
        ("bore", 25, "cylinder.bore", "mm"),
        ("length", 500, "line.length", "mm"),
        ("effective_area", 16, "bleed.effective_area", "mm^2"),
        ("mass", 1e4, "slide.mass", "g"),
        ("inclination", 90, "slide.inclination", "deg"),
    ],
)
def test_unusual_dimensions_without_unit_give_a_note(field, value, address, meant):
    assert not [note for note in machine().static_notes if note.code == "doubt.bare_number"]
    (note,) = [note for note in machine(**{field: value}).static_notes if note.code == "doubt.bare_number"]
    assert (note.address, note.facts["meant"]) == (address, meant)


def test_signals_near_vacuum_give_a_note():
    (note,) = notes({"supply.pressure": Steps([0.0, 1.0], [2.0, 3.0])})
    assert (note.code, note.address) == ("doubt.low_signal", "supply.pressure")
    assert note.facts == {"highest": 3.0, "unit": "Pa", "meant": "bar"}
    assert notes({"supply.pressure": Steps([0.0, 1.0], [0.0, 3e5]), "fill.opening": Steps([0.0], [1.0])}) == ()


def test_coefficients_of_the_library_give_no_note():
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012"),
        "tank": Chamber(volume="1 l"),
    }
    assert Circuit(parts).static_notes == ()
