"""Passages: the ways of sizing them, and the valves with a rule of their own."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, iso6358, library
from poppet.parts import Chamber, CheckValve, DirectionalValve, FlowSource, Orifice, ReliefValve, Reservoir, Silencer
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Points, Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
HIGH, LOW = GasState(7e5, 310.0), GasState(4e5, 290.0)
SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
ENDS = {"from_": "a", "to": "b"}
LAW = {"subsonic_index": 0.5, "laminar_ratio": 0.999}


def passed(part: Any, first: GasState = HIGH, second: GasState = LOW, states: Any = None, **inputs: float) -> Any:
    numbers = part.parameters(AIR)
    defaults = {
        item.name: numbers[item.default] if isinstance(item.default, str) else item.default for item in part.inputs()
    }
    scope = Scope(numbers, states or {}, {**defaults, **inputs}, AIR)
    return part.flows(scope, dict(zip(part.ports(), (first, second, GasState(1e5, 293.15)), strict=False)))


def flow_of(part: Any, *gas: GasState, **inputs: float) -> float:
    return passed(part, *gas, **inputs).outputs["mass_flow_rate"][0]


def expected(conductance: float, ratio: float, first: GasState = HIGH, second: GasState = LOW, **law: Any) -> float:
    temperatures = first.temperature, second.temperature
    return iso6358.mass_flow_rate(
        first.pressure, second.pressure, *temperatures, sonic_conductance=conductance, critical_ratio=ratio, **law
    )


class TestSizes:
    def test_conductance_and_ratio(self):
        assert flow_of(Orifice(**ENDS, **SIZE)) == expected(1e-8, 0.3)

    def test_conductance_in_catalogue_units(self):
        part = Orifice(**ENDS, sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3)
        assert part.parameters(AIR)["sonic_conductance"] == pytest.approx(1e-8, rel=1e-14)

    def test_effective_area_is_a_nozzle(self):
        """C [dm3/(s bar)] = 0.1992 A [mm2], b = 0.5283."""
        numbers = Orifice(**ENDS, effective_area="16 mm^2").parameters(AIR)
        assert numbers["sonic_conductance"] == pytest.approx(16 * 0.1992e-8, rel=3e-4)
        assert numbers["critical_ratio"] == pytest.approx(0.5283, abs=5e-5)

    def test_nominal_flow(self):
        """254.3 l/min ANR per dm3/(s bar) at b = 0.3 and an atmosphere of 1 bar."""
        part = Orifice(**ENDS, nominal_flow="380 l/min ANR", critical_ratio=0.3)
        known = iso6358.conductance_from_nominal_flow(380.0 / 60e3, critical_ratio=0.3).sonic_conductance
        assert part.parameters(AIR)["sonic_conductance"] == pytest.approx(known, rel=1e-12)
        assert known == pytest.approx(380.0 / 255.0 * 1e-8, rel=5e-3)

    def test_kv_and_cv(self):
        """Kv = 0.865 Cv."""
        by_cv = Orifice(**ENDS, flow_coefficient_cv=1.0).parameters(AIR)["sonic_conductance"]
        by_kv = Orifice(**ENDS, flow_coefficient_kv=0.865).parameters(AIR)["sonic_conductance"]
        assert by_kv == pytest.approx(by_cv, rel=1e-3)
        assert by_cv == pytest.approx(3.96e-8, rel=0.06)

    @pytest.mark.parametrize("size", ["flow_coefficient_kv", "flow_coefficient_cv", "sonic_conductance"])
    def test_a_missing_ratio_is_assumed_with_a_note(self, size):
        ratio = Orifice(**ENDS, **{size: 1e-8}).critical_ratio
        assert float(ratio) == 0.3
        assert ratio.source.kind == "assumed"
        assert ratio.source.note == f"{size} alone does not determine b: 0.3 assumed"

    @pytest.mark.parametrize(
        "name", ["varga2012", "varga2012.printed", "varga2012.closed", "varga2012.monotone", "varga2012.table"]
    )
    def test_characteristic_of_the_library(self, name):
        part, curve = Orifice(**ENDS, characteristic=name), library.characteristic(name)
        for stroke in (0.1e-3, 0.499e-3, 0.9e-3):
            size = curve.sonic_conductance_at(stroke), curve.critical_ratio_at(stroke)
            assert flow_of(part, stroke=stroke) == pytest.approx(expected(*size), rel=1e-13)

    def test_stroke_is_zero_unless_given(self):
        printed = 5.0034e-9, 0.71748
        assert flow_of(Orifice(**ENDS, characteristic="varga2012")) == pytest.approx(expected(*printed), rel=1e-12)
        open_ = Orifice(**ENDS, characteristic="varga2012", stroke="0.5 mm")
        assert flow_of(open_) == pytest.approx(flow_of(open_, stroke=0.5e-3), rel=1e-15)

    def test_characteristic_as_a_table_and_from_a_file(self, tmp_path):
        text = 'kind = "table"\nstroke = ["0 mm", "1 mm"]\n'
        text += 'sonic_conductance = ["0 m^3/(s Pa)", "1e-8 m^3/(s Pa)"]\ncritical_ratio = [0.3, 0.3]\n'
        path = tmp_path / "seat.toml"
        path.write_text(text, encoding="utf-8")
        table = {
            "kind": "table",
            "stroke": ["0 mm", "1 mm"],
            "sonic_conductance": ["0 m^3/(s Pa)", "1e-8 m^3/(s Pa)"],
            "critical_ratio": [0.3, 0.3],
        }
        flows = [flow_of(Orifice(**ENDS, characteristic=given), stroke=0.5e-3) for given in (table, str(path))]
        assert flows[0] == flows[1] == pytest.approx(expected(0.5e-8, 0.3), rel=1e-12)

    @pytest.mark.parametrize("index", [0.4, 0.5, 0.6])
    def test_subsonic_index(self, index):
        part = Orifice(**ENDS, **SIZE, subsonic_index=index)
        assert flow_of(part) == pytest.approx(expected(1e-8, 0.3, subsonic_index=index), rel=1e-14)

    def test_opening_scales_the_conductance(self):
        part = Orifice(**ENDS, **SIZE)
        assert flow_of(part, opening=0.25) == pytest.approx(0.25 * flow_of(part), rel=1e-14)
        assert flow_of(part, opening=0.0) == 0.0

    def test_reverse_flow_is_the_mirror(self):
        part = Orifice(**ENDS, **SIZE)
        assert flow_of(part, LOW, HIGH) == -flow_of(part, HIGH, LOW)

    def test_enthalpy_is_that_of_the_upstream_gas(self):
        flow = passed(Orifice(**ENDS, **SIZE), LOW, HIGH).flows[0]
        assert flow.enthalpy == pytest.approx(AIR.heat_capacity_pressure * HIGH.temperature * flow.mass, rel=1e-14)


@pytest.mark.parametrize(
    ("fields", "match"),
    [
        ({}, "parts.no_size"),
        (
            {"effective_area": 1e-5, "sonic_conductance": 1e-8},
            "parts.several_sizes",
        ),
        ({"effective_area": 1e-5, "critical_ratio": 0.3}, "parts.idle_critical_ratio"),
        ({"characteristic": "varga2012", "critical_ratio": 0.3}, "parts.idle_critical_ratio"),
        ({"characteristic": "varga2021"}, "library.unknown"),
        ({"characteristic": 5}, "parts.not_a_characteristic"),
        ({"characteristic": "missing.toml"}, "parts.unreadable_file"),
        ({**SIZE, "stroke": 1e-3}, "parts.idle_stroke"),
        ({"sonic_conductance": 1e-8, "critical_ratio": 1.0}, "fields.out_of_range"),
        ({"sonic_conductance": -1e-8}, "fields.out_of_range"),
        ({"nominal_flow": "380 m^2/min"}, "quantity.other_quantity"),
        ({**SIZE, "laminar_ratio": 1.0}, "fields.out_of_range"),
        ({**SIZE, "opening": 1.5}, "fields.out_of_range"),
    ],
)
def test_contradictions(fields, match):
    with refused(match):
        Orifice(**ENDS, **fields)


@pytest.mark.parametrize(
    "size", [{"effective_area": "16 mm^2"}, {"nominal_flow": "380 l/min ANR"}, {"characteristic": "varga2012"}, SIZE]
)
def test_copies_are_made_with_replace(size):
    part = Orifice(**ENDS, **size)
    copy = dataclasses.replace(part, opening=0.5)
    assert copy.parameters(AIR) == part.parameters(AIR) | {"opening": 0.5}


class TestCheckValve:
    valve = CheckValve(**ENDS, **SIZE, cracking_pressure="0.5 bar")

    def test_forward(self):
        assert flow_of(self.valve) == pytest.approx(expected(1e-8, 0.3, cracking_pressure=5e4, one_way=True), rel=1e-14)

    def test_closed_backwards_and_below_cracking_pressure(self):
        assert flow_of(self.valve, LOW, HIGH) == 0.0
        assert flow_of(self.valve, GasState(4.4e5, 300.0), LOW) == 0.0
        assert flow_of(self.valve, GasState(4.6e5, 300.0), LOW) > 0.0

    def test_follows_no_stroke(self):
        with refused("parts.no_stroke_to_follow", "characteristic"):
            CheckValve(**ENDS, characteristic="varga2012")


class TestReliefValve:
    valve = ReliefValve(**ENDS, **SIZE, set_pressure="5 bar", accumulation="1 bar")

    @pytest.mark.parametrize(("pressure", "opening"), [(4.9e5, 0.0), (5e5, 0.0), (5.5e5, 0.5), (6e5, 1.0), (9e5, 1.0)])
    def test_opens_over_its_accumulation(self, pressure, opening):
        result = passed(self.valve, GasState(pressure, 300.0), GasState(1e5, 300.0))
        assert result.outputs["opening"][0] == pytest.approx(opening, abs=1e-12)
        known = opening * expected(1e-8, 0.3, GasState(pressure, 300.0), GasState(1e5, 300.0))
        assert result.outputs["mass_flow_rate"][0] == pytest.approx(known, rel=1e-12, abs=1e-18)

    def test_does_not_let_gas_in(self):
        assert flow_of(self.valve, GasState(6e5, 300.0), GasState(9e5, 300.0)) == 0.0

    def test_set_pressure_may_be_gauge(self):
        assert ReliefValve(**ENDS, **SIZE, set_pressure="4 bar g").parameters(AIR)["set_pressure"] == 5e5

    def test_holds_a_tank_near_its_set_pressure(self):
        circuit = Circuit(
            {
                "source": FlowSource(to="tank", mass_flow_rate="2 g/s"),
                "tank": Chamber(volume="1 l", thermal="isothermal"),
                "valve": ReliefValve(from_="tank", to="ambient", **SIZE, set_pressure="3 bar", accumulation="0.2 bar"),
            }
        )
        recording = circuit.simulate("20 s")
        assert 3e5 < recording["tank.pressure"][-1] < 3.2e5
        assert recording["valve.mass_flow_rate"][-1] == pytest.approx(2e-3, rel=1e-6)


def test_silencer_clogs():
    clean, half = (Silencer(**ENDS, **SIZE, clogging=clogging) for clogging in (0.0, 0.5))
    assert flow_of(clean) == expected(1e-8, 0.3)
    assert flow_of(half) == pytest.approx(0.5 * flow_of(clean), rel=1e-14)
    assert flow_of(Silencer(**ENDS, **SIZE, clogging=1.0)) == 0.0


def valve_circuit(command: Any, duration: float = 0.2, **fields: Any) -> Any:
    """A 2/2 or 3/2 valve between 7 bar and a large tank."""
    ports = {"supply": "supply", "outlet": "tank"}
    valve = DirectionalValve(**ports, **SIZE, **fields)
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": valve,
        "tank": Chamber(volume="1 m^3", thermal="isothermal"),
    }
    return Circuit(parts, {"valve.command": command}).simulate(duration, 1e-3)


class TestDirectionalValve:
    on_at_50_ms = Steps([0.0, 0.05], [0.0, 1.0])

    def test_spool_moves_after_the_delay_within_the_switching_time(self):
        position = valve_circuit(self.on_at_50_ms, delay="20 ms", switching_time="40 ms")["valve.position"]
        assert np.abs(position[:71]).max() < 1e-9
        assert position[90] == pytest.approx(0.5, abs=1e-6)
        assert position[-1] == pytest.approx(1.0, abs=1e-6)

    def test_closing_takes_its_own_time(self):
        pulse = Steps([0.0, 0.01, 0.1], [0.0, 1.0, 0.0])
        position = valve_circuit(pulse, switching_time="20 ms", closing_time="80 ms")["valve.position"]
        assert position[20] == pytest.approx(0.5, abs=1e-6)
        assert position[140] == pytest.approx(0.5, abs=1e-4)

    def test_the_command_row_is_not_delayed(self):
        recording = valve_circuit(self.on_at_50_ms, switching_time="1 ms")
        assert recording["valve.command"][[49, 50]].tolist() == [0.0, 1.0]

    def test_normally_open(self):
        recording = valve_circuit(self.on_at_50_ms, normally="open", switching_time="10 ms")
        assert recording["valve.position"][0] == 1.0
        assert recording["valve.supply_mass_flow_rate"][40] > 0.0
        assert recording["valve.supply_mass_flow_rate"][-1] == pytest.approx(0.0, abs=1e-8)

    def test_supply_and_exhaust_are_never_open_together(self):
        recording = valve_circuit(self.on_at_50_ms, exhaust="ambient", switching_time="50 ms")
        position = recording["valve.position"]
        both = np.abs(recording["valve.supply_mass_flow_rate"]) * np.abs(recording["valve.exhaust_mass_flow_rate"])
        assert np.all(both == 0.0)
        assert np.any((position > 0.2) & (position < 0.45))

    def test_three_ports_vent_at_rest(self):
        gas = (GasState(7e5, 300.0), GasState(4e5, 300.0))
        part = DirectionalValve(
            supply="s", outlet="o", exhaust="e", **SIZE, exhaust_conductance=2e-8, exhaust_ratio=0.5
        )
        rest = passed(part, *gas, states={"position": 0.0}).outputs
        assert rest["supply_mass_flow_rate"][0] == 0.0
        assert rest["exhaust_mass_flow_rate"][0] == pytest.approx(
            expected(2e-8, 0.5, gas[1], GasState(1e5, 293.15)), rel=1e-12
        )
        on = passed(part, *gas, states={"position": 1.0}).outputs
        assert on["supply_mass_flow_rate"][0] == pytest.approx(expected(1e-8, 0.3, *gas), rel=1e-12)
        assert on["exhaust_mass_flow_rate"][0] == 0.0

    def test_exhaust_size_defaults_to_that_of_the_supply(self):
        numbers = DirectionalValve(supply="s", outlet="o", exhaust="e", **SIZE).parameters(AIR)
        assert (numbers["exhaust_conductance"], numbers["exhaust_ratio"]) == (1e-8, 0.3)

    def test_starts_where_the_command_holds_it(self):
        for normally, position in (("closed", 1.0), ("open", 0.0)):
            part = DirectionalValve(supply="s", outlet="o", **SIZE, command=1.0, normally=normally)
            assert part.parameters(AIR)["initial_position"] == position

    @pytest.mark.parametrize(
        ("fields", "match"),
        [
            ({"exhaust_conductance": 1e-8}, "parts.no_exhaust_port"),
            ({"normally": "shut"}, "fields.not_an_option"),
            ({"switching_time": "0 s"}, "fields.out_of_range"),
            ({"delay": "-1 ms"}, "fields.out_of_range"),
        ],
    )
    def test_contradictions(self, fields, match):
        with refused(match):
            DirectionalValve(supply="s", outlet="o", **SIZE, **fields)


class TestFlowSource:
    def test_number(self):
        circuit = Circuit({"source": FlowSource(to="tank", mass_flow_rate="60 g/min"), "tank": Chamber(volume="1 l")})
        recording = circuit.simulate("2 s")
        gained = recording["tank.mass"][-1] - recording["tank.mass"][0]
        assert gained == pytest.approx(2e-3, rel=1e-12)

    def test_volume_flow_at_its_reference(self):
        assert float(FlowSource(to="tank", mass_flow_rate="60 l/min ANR").mass_flow_rate) == pytest.approx(
            1.185e-3, rel=1e-12
        )

    def test_signal(self):
        ramp = Points([0.0, 2.0], [0.0, 2e-3])
        circuit = Circuit(
            {"source": FlowSource(to="tank"), "tank": Chamber(volume="1 l")}, {"source.mass_flow_rate": ramp}
        )
        recording = circuit.simulate("2 s")
        assert recording["source.mass_flow_rate"][-1] == pytest.approx(2e-3, rel=1e-12)
        assert recording["tank.mass"][-1] - recording["tank.mass"][0] == pytest.approx(2e-3, rel=1e-9)

    def test_delayed_signal(self):
        source = FlowSource(to="tank", delay="0.5 s")
        circuit = Circuit(
            {"source": source, "tank": Chamber(volume="1 l")}, {"source.mass_flow_rate": Steps([0.0, 1.0], [0.0, 1e-3])}
        )
        recording = circuit.simulate("2 s", "0.1 s")
        assert recording["source.mass_flow_rate"][[14, 15]].tolist() == [0.0, 1e-3]
        assert recording["tank.mass"][-1] - recording["tank.mass"][0] == pytest.approx(0.5e-3, rel=1e-9)

    def test_what_is_drawn_out_leaves_at_the_temperature_of_the_store(self):
        source = FlowSource(to="tank", mass_flow_rate=-1e-3, temperature="500 K")
        numbers = source.parameters(AIR)
        scope = Scope(numbers, {}, {"mass_flow_rate": -1e-3}, AIR)
        flow = source.flows(scope, {"to": GasState(2e5, 280.0)}).flows[0]
        assert flow.enthalpy == pytest.approx(-1e-3 * AIR.heat_capacity_pressure * 280.0, rel=1e-14)

    def test_a_volume_flow_without_its_state_is_read_at_anr_and_noted(self):
        parts = {"source": FlowSource(to="tank", mass_flow_rate="60 l/min"), "tank": Chamber(volume="1 l")}
        circuit = Circuit(parts)
        assert circuit.parameters["source.mass_flow_rate"] == pytest.approx(1.185e-3, rel=1e-14)
        (note,) = circuit.static_notes
        assert (note.code, note.address) == ("doubt.open_flow", "source.mass_flow_rate")
        assert (note.facts["shown"], note.facts["stated"]) == ("60 l/min", "60 l/min ANR")
        standard = circuit.with_values({"source.mass_flow_rate": "60 slpm"})
        assert [note.code for note in standard.simulate("1 ms").remarks] == ["doubt.standard_flow"]
        assert circuit.with_values({"source.mass_flow_rate": "60 Nl/min"}).static_notes == ()
