"""Tubes: members, connections, rejected input."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet import Chamber, Circuit, DirectionalValve, FlowSource, Orifice, Reservoir, Tube, iso6358, loads
from poppet.circuit.schema import circuit_schema
from poppet.laws.physics import pipe
from poppet.parts import KINDS
from poppet.parts.fields import PortSpec, specs
from poppet.parts.part import PORTS
from poppet.parts.tube import TubeSegment
from refusals import refused

SIZE = {"length": "2 m", "bore": "4 mm"}
NARROW = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
FILE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "hose"
sonic_conductance = 1e-8
command = 1
[parts.hose]
kind = "tube"
from = "valve.outlet"
to = "tank"
length = "2 m"
bore = "4 mm"
cells = 3
inertia = true
[parts.tank]
kind = "chamber"
volume = "50 cm^3"
[run]
duration = "20 ms"
"""


def between(hose: Tube, **others: object) -> Circuit:
    """A tube from a valve to a tank."""
    valve = Orifice(from_="supply", to="hose", **NARROW)
    parts = {"supply": Reservoir(pressure="7 bar"), "valve": valve, "hose": hose, "tank": Chamber(volume="50 cm^3")}
    return Circuit(parts | others)


def volumes(hose: Tube) -> list[float]:
    return [float(cell.volume) for name, cell in hose.members.items() if name.isdigit()]


def lengths(hose: Tube) -> list[float]:
    return [float(part.length) for part in hose.members.values() if isinstance(part, TubeSegment)]


# --- what it is made of ---


@pytest.mark.parametrize(
    ("ends", "cells", "halves", "inner"),
    [
        ({"from_": "a", "to": "b"}, 4, 0, 4.0),  # half a length at both ends, and three whole ones
        ({"from_": "a"}, 4, 0, 3.5),
        ({"from_": "v.outlet", "to": "b"}, 4, 1, 3.5),
        ({"from_": "v.outlet", "to": "w.from"}, 4, 2, 3.0),
        ({"from_": "v.outlet"}, 4, 1, 3.0),
        ({"from_": "v.outlet"}, 1, 1, 0.0),
    ],
)
def test_volume_and_length_are_those_of_the_tube(ends: dict[str, str], cells: int, halves: int, inner: float) -> None:
    hose = Tube(**ends, **SIZE, cells=cells)
    step = 2.0 / (cells - 0.5 * halves)
    assert sum(volumes(hose)) == pytest.approx(0.25 * math.pi * 16e-6 * 2.0)
    assert sum(lengths(hose)) == pytest.approx(inner * step)
    assert len(hose.stores()) == cells


def test_numbers_of_the_whole_are_followed_by_its_members() -> None:
    circuit = between(Tube(from_="valve.to", to="tank", **SIZE, cells=2))
    assert "hose.length" in circuit.numbers()
    assert not {"hose.length", "hose.cells", "hose.1.volume"} & {*circuit.numbers()} - {"hose.length"}
    longer = circuit.with_values({"hose.length": "4 m"})
    assert longer.parameters["hose.1.volume"] == pytest.approx(2.0 * circuit.parameters["hose.1.volume"])
    assert longer.structure == circuit.structure
    assert circuit.with_values({"hose.cells": 3}).structure != circuit.structure
    assert circuit.with_values({"hose.inertia": "true"}).structure != circuit.structure


def test_wall_and_initial_state_are_shared_out() -> None:
    hose = Tube(from_="valve.to", to="tank", **SIZE, cells=2, wall_conductance=3.0, initial_pressure="1 bar g")
    circuit = between(hose)
    assert [circuit.parameters[f"hose.{k}.wall_conductance"] for k in (1, 2)] == pytest.approx([1.0, 2.0])
    assert circuit.parameters["hose.2.initial_pressure"] == pytest.approx(2e5)
    with refused("numbers.below_vacuum", "hose.initial_pressure"):
        circuit.with_values({"hose.initial_pressure": "-2 bar g"})


def test_a_profile_sets_single_cells() -> None:
    circuit = between(Tube(from_="valve.to", to="tank", **SIZE, cells=2, profile={"pressure_2": "3 bar"}))
    assert circuit.parameters["hose.1.initial_pressure"] == 1e5
    assert circuit.parameters["hose.2.initial_pressure"] == 3e5
    moved = circuit.with_values({"hose.profile.pressure_1": "2 bar", "hose.initial_pressure": "4 bar"})
    assert [moved.parameters[f"hose.{k}.initial_pressure"] for k in (1, 2)] == [2e5, 3e5]
    with refused("fields.unknown", "profile.pressure_3"):
        between(Tube(from_="valve.to", to="tank", **SIZE, cells=2, profile={"pressure_3": "3 bar"}))
    with refused("fields.unknown", "profile.mass_flow_rate_1"):  # that of a tube without inertia is no state
        between(Tube(from_="valve.to", to="tank", **SIZE, cells=2, profile={"mass_flow_rate_1": 0.0}))


def test_a_run_goes_on_where_another_ended() -> None:
    circuit = loads(FILE)
    whole = circuit.simulate(0.02, 0.001, 1e-9)
    first = circuit.simulate(0.01, 0.001, 1e-9)
    rest = circuit.with_values({"valve.initial_position": 1.0}).simulate(0.01, 0.001, 1e-9, start=first)
    for name in ("hose.2.pressure", "hose.2.mass_flow_rate", "hose.3.mass_flow_rate", "tank.temperature"):
        assert np.allclose(rest[name][1:], whole[name][11:], rtol=1e-6, atol=1e-9), name


# --- how it is joined ---


def test_a_file_needs_no_chamber_between_valve_and_tube() -> None:
    circuit = loads(FILE)
    assert circuit.parts["valve"].outlet == "hose.1"
    assert "hose.mass_flow_rate" not in circuit.model.columns[0]  # the valve's own is that of the first end
    assert {"hose.1.pressure", "hose.1.mass_flow_rate", "hose.3.temperature"} <= {*circuit.model.columns[0]}
    run = circuit.simulate()
    assert run["tank.mass"][-1] > run["tank.mass"][0]


def test_tubes_join_each_other_and_two_valves_join_one() -> None:
    two = {
        "supply": Reservoir(pressure="7 bar"),
        "first": Tube(from_="supply", to="second", **SIZE, cells=2),
        "second": Tube(from_="first.to", to="valve.from", **SIZE, cells=3),
        "valve": Orifice(from_="second", to="ambient", **NARROW),
    }
    circuit = Circuit(two)
    assert circuit.parts["first"].to == "second.1"
    assert circuit.parts["valve"].from_ == "second.3"
    assert circuit.simulate(0.05)["second.3.pressure"][-1] > 1e5


def test_any_cell_may_be_joined() -> None:
    branch = Orifice(from_="hose.2", to="ambient", **NARROW)
    assert between(Tube(from_="valve.to", to="tank", **SIZE, cells=3), branch=branch).simulate(0.01).time[-1] == 0.01


def test_names_of_ports_are_those_of_all_kinds() -> None:
    named = {name for kind in KINDS.values() for name, spec in specs(kind).items() if isinstance(spec, PortSpec)}
    assert named == {*PORTS}
    stores = {name for kind in KINDS.values() for name, spec in specs(kind).items() if getattr(spec, "is_open", False)}
    assert not stores & {*PORTS}


def test_names_of_other_parts_or_ports_are_rejected() -> None:
    hose = Tube(from_="valve.to", to="tank", **SIZE)
    with refused("tube.not_met", "parts.hose.from", store="tank", tube="hose"):
        between(hose, valve=Orifice(from_="supply", to="tank", **NARROW))
    with refused("tube.not_met", "parts.hose.from", store="hose.2", tube="hose"):
        between(hose, valve=Orifice(from_="supply", to="hose.2", **NARROW))
    with refused("fields.not_an_option", "parts.hose.from", value="vlave.to"):
        between(Tube(from_="vlave.to", to="tank", **SIZE), spare=Orifice(from_="hose.1", to="tank", **NARROW))
    with refused("wiring.several_stores", "parts.valve.to"):
        between(Tube(from_="supply", to="tank", **SIZE))
    with refused("fields.not_an_option", "parts.branch.from"):
        between(hose, branch=Orifice(from_="hose.9", to="tank", **NARROW))


@pytest.mark.parametrize("wrong", ['length = "-2 m"', "", 'length = "2 m"\nlenght = 3'])
def test_an_invalid_tube_is_one_error(wrong: str) -> None:
    with refused("fields.out_of_range" if "-2" in wrong else "fields.unknown" if wrong else "fields.missing") as caught:
        loads(FILE.replace('length = "2 m"', wrong))
    assert not hasattr(caught.value, "problems") or len(caught.value.problems) == 1


def test_invalid_forms_are_rejected() -> None:
    with refused("tube.cells", "cells"):
        Tube(from_="a", to="b", **SIZE, cells=2.5)
    with refused("tube.one_cell", "cells"):
        Tube(from_="v.to", to="w.from", **SIZE, cells=1)
    with refused("tube.friction_without_inertia", "loss"):
        Tube(from_="a", to="b", **SIZE, loss="friction")
    with refused("fields.not_an_option", "inertia"):
        Tube(from_="a", to="b", **SIZE, inertia="perhaps")
    notes = Tube(from_="a", to="b", **SIZE, roughness="2 um").notes()
    assert [(note.code, note.address) for note in notes] == [("tube.no_effect", "roughness")]
    rough = Tube(from_="a", to="b", **SIZE, roughness="2 um", sonic_conductance=1e-8, loss="friction", inertia=True)
    assert [note.address for note in rough.notes()] == ["sonic_conductance"]


def test_the_schema_takes_what_a_file_takes() -> None:
    fields = circuit_schema()["$defs"]["tube"]["properties"]
    assert fields["inertia"]["type"] == "boolean"
    assert {"start", "members"}.isdisjoint(fields)


def test_other_gases_flow_through_tubes() -> None:
    hose = Tube(from_="supply", to="end", length="2 mm", bore="4 mm", cells=1, inertia=True, loss="friction")
    air = Circuit({"supply": Reservoir(pressure="7 bar"), "hose": hose, "end": Reservoir(pressure="1 bar")})
    # So short that its cross-section chokes: by the root of the gas constant.
    flows = [c.simulate(0.1)["hose.mass_flow_rate"][-1] for c in (air, air.with_values({"gas.gas_constant": 2077.0}))]
    assert flows[1] / flows[0] == pytest.approx(math.sqrt(287.05 / 2077.0), rel=0.02)
    assert flows[0] == pytest.approx(
        iso6358.nozzle_mass_flow_rate(7e5, 1e5, 293.15, effective_area=4e-6 * math.pi), rel=0.1
    )


# --- laws ---


def test_pieces_in_a_row_pass_what_the_whole_passes() -> None:
    def row(pieces: list[tuple[float, float]], ratio: float) -> float:
        low, high = 0.0, 2.0
        for _ in range(45):
            flow, pressure = 0.5 * (low + high), 1.0
            for size, critical in pieces:
                if flow > size * pressure:
                    pressure = -1.0
                    break
                pressure *= critical + (1 - critical) * math.sqrt(1 - (flow / (size * pressure)) ** 2)
            low, high = (flow, high) if pressure > ratio else (low, flow)
        return high

    for critical in (0.0, 0.1, 0.35, 0.61):
        for weights in ([1], [0.5, 0.5], [0.5, 1], [0.5, 1, 1], [1, 1, 1, 1], [0.5, *[1] * 7, 0.5], [0.5, *[1] * 29]):
            pieces = iso6358.divided(1.0, critical, weights)
            for ratio in (0.0, *(critical + (1 - critical) * np.linspace(0.1, 0.98, 7))):
                whole = math.sqrt(1 - max(0.0, (ratio - critical) / (1 - critical)) ** 2)
                for way in (pieces, pieces[::-1]):
                    assert row(way, ratio) == pytest.approx(whole, rel=0.015), (critical, weights, ratio)


def test_loss_of_a_flow_is_the_drop_that_makes_it() -> None:
    for low in (6.9e5, 5e5, 3e5, 1e5):
        flow = iso6358.mass_flow_rate(7e5, low, 293.15, sonic_conductance=1e-8, critical_ratio=0.3)
        choked = iso6358.mass_flow_rate(7e5, 0.0, 293.15, sonic_conductance=1e-8, critical_ratio=0.3)
        assert iso6358.loss_coefficient(7e5, low, choked, 0.3) * flow**2 == pytest.approx(7e5 - low, rel=1e-9)
    assert math.isfinite(iso6358.loss_coefficient(7e5, 7e5, 1e-3, 0.3))


def test_friction_is_laminar_then_turbulent_and_smooth_between() -> None:
    q = np.linspace(1e-6, 4e-4, 4001)
    tube = 1.0, 4e-3, 1.2, 1.82e-5
    re = pipe.reynolds_number(q, 4e-3, 1.82e-5)
    laminar = pipe.laminar_resistance(*tube) * q
    turbulent = pipe.darcy_coefficient(q, *tube, 0.0) * q**2
    drop = pipe.between_laminar_and_turbulent(re, laminar, turbulent)
    dynamic = 0.5 * (q / (0.25 * math.pi * 16e-6)) ** 2 / 1.2
    assert np.allclose(drop[re < 2000], (64 / re * dynamic / 4e-3)[re < 2000])
    assert np.all(np.diff(drop) > 0.0)
    assert np.max(np.abs(np.diff(drop, 2))) < 0.02 * np.max(np.diff(drop))
    assert drop[-1] == pytest.approx(turbulent[-1])


def test_turbulent_factor_is_that_of_colebrook() -> None:
    for re in (4e3, 1e5, 1e8):
        for roughness in (0.0, 1e-4, 0.05):
            f = pipe.turbulent_factor(re, roughness)
            for _ in range(50):
                exact = (-2 * math.log10(roughness / 3.7 + 2.51 / (re * math.sqrt(f)))) ** -2
                f = exact
            assert pipe.turbulent_factor(re, roughness) == pytest.approx(exact, rel=0.003)


def test_a_valve_between_two_tubes_needs_no_chamber() -> None:
    valve = DirectionalValve(supply="feed", outlet="hose", command=1.0, **NARROW)
    parts = {
        "source": FlowSource(to="feed.1", mass_flow_rate=1e-3),
        "feed": Tube(from_="valve.supply", **SIZE, cells=2),
        "valve": valve,
        "hose": Tube(from_="valve.outlet", to="ambient", **SIZE, cells=2),
    }
    run = Circuit(parts).simulate(1.0)
    assert run["hose.2.mass_flow_rate"][-1] == pytest.approx(1e-3, rel=1e-3)
