"""Circuits: wiring, variants, structure, compiled models, and restart from a recording."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest

from poppet import Circuit
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.errors import InputError, InputErrors
from poppet.core.provenance import Number, Source
from poppet.engine.lru_cache import LruCache
from poppet.parts import (
    Chamber,
    CheckValve,
    DirectionalValve,
    FlowSource,
    MainStage,
    Orifice,
    Part,
    ProportionalValve,
    Reservoir,
)
from poppet.signals import Constant, Sine, Steps
from poppet.timeseries.recording import Recording
from refusals import refused

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def filling(**tank: Any) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", **SIZE),
            "tank": Chamber(**{"volume": "10 l", **tank}),
        },
        run=Run(duration="10 s", output_step="0.1 s"),
    )


def valve_circuit(signal: Any = None, **valve: Any) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "room": Reservoir(pressure="1 bar"),
            "valve": MainStage(supply="supply", outlet="tank", exhaust="room", data="varga2012", **valve),
            "tank": Chamber(volume="20 l", wall_conductance="5 W/K", wall_heat_capacity="2 kJ/K"),
        },
        {} if signal is None else {"valve.pilot_pressure": signal},
        Run(duration="4 s"),
    )


def mistakes_of(*arguments: Any) -> list[tuple[str, str | None]]:
    """Return the codes and addresses of the errors."""
    with pytest.raises(InputError) as caught:
        Circuit(*arguments)
    return [(problem.code, problem.address) for problem in caught.value.problems]


class TestWiring:
    def test_all_errors_are_reported_together(self):
        errors = mistakes_of(
            {
                "supply": Reservoir(pressure="7 bar"),
                "fill": Orifice(from_="supply", to="tnk", **SIZE),
                "loop": Orifice(from_="tank", to="tank", **SIZE),
                "joint": Orifice(from_="fill", to="tank", **SIZE),
                "tank": Chamber(volume="1 l"),
                "lonely": Chamber(volume="1 l"),
                "run": Chamber(volume="1 l"),
                "2nd": CheckValve(from_="tank", to="ambient", **SIZE),
            },
            {"fill.openin": Constant(0.5), "supply.pressure": Constant(-1.0)},
        )
        assert errors == [
            ("wiring.reserved", "parts.run"),
            ("wiring.no_name", "parts.2nd"),
            ("fields.not_an_option", "parts.fill.to"),
            ("wiring.joined_twice", "parts.loop"),
            ("wiring.no_store", "parts.joint.from"),
            ("wiring.alone", "parts.lonely"),
            ("wiring.alone", "parts.run"),
            ("names.unknown", "signals.fill.openin"),
            ("wiring.signal_below", "signals.supply.pressure"),
        ]

    @pytest.mark.parametrize("other", ["supply", "exhaust"])
    def test_valve_with_its_outlet_at_its_supply_is_rejected(self, other):
        ports = {"supply": "supply", "outlet": "tank", "exhaust": "ambient"}
        valve = DirectionalValve(**{**ports, other: "tank"}, **SIZE)
        errors = mistakes_of({**filling().parts, "valve": valve})
        assert errors == [("wiring.joined_twice", "parts.valve")]

    def test_supply_and_exhaust_can_be_the_same_node(self):
        valve = DirectionalValve(supply="ambient", outlet="tank", exhaust="ambient", **SIZE)
        assert Circuit({**filling().parts, "valve": valve}).simulate("1 s").ending.code == "run.done"

    def test_empty_circuit_is_rejected(self):
        assert mistakes_of({}) == [("wiring.empty", "parts")]

    def test_signals_of_another_type_are_rejected(self):
        assert mistakes_of(filling().parts, {"supply.pressure": 5.0}) == [
            ("wiring.no_signal", "signals.supply.pressure")
        ]

    def test_limits_on_both_sides_are_named(self):
        with pytest.raises(InputError) as caught:
            Circuit(filling().parts, {"fill.opening": Sine(0.5, 0.6, 1.0)})
        assert caught.value.code == "wiring.signal_outside"
        assert [caught.value.facts[name] for name in ("value", "low", "high")] == pytest.approx([-0.1, 0.0, 1.0])

    def test_ambient_is_a_valid_gas_node_without_a_part(self):
        vent = Circuit(
            {
                "tank": Chamber(volume="1 l", initial_pressure="3 bar"),
                "vent": Orifice(from_="tank", to="ambient", **SIZE),
            }
        )
        assert vent.simulate("20 s")["tank.pressure"][-1] == pytest.approx(1e5, rel=1e-6)


class TestWithValues:
    def test_values_texts_and_numbers(self):
        measured = Number(5e-3, "m^3", Source("measured", "bench 1"))
        changed = filling().with_values(
            {"tank.volume": measured, "fill.sonic_conductance": "2e-8 m^3/(s Pa)", "fill.critical_ratio": 0.25}
        )
        assert changed.numbers()["tank.volume"] == measured
        assert changed.parameters["fill.sonic_conductance"] == 2e-8
        assert changed.parameters["fill.critical_ratio"] == 0.25
        assert filling().parameters["tank.volume"] == 10e-3

    def test_sections(self):
        changed = filling().with_values(
            {
                "ambient.pressure": "950 mbar",
                "gas.name": "helium",
                "run.duration": "3 s",
                "run.stop_when": "tank.pressure > 5 bar",
            }
        )
        assert changed.surroundings.pressure == 95e3
        assert changed.surroundings.gas_constant == pytest.approx(2077.3, rel=1e-4)
        assert changed.surroundings.isentropic_exponent == pytest.approx(5.0 / 3.0, rel=1e-2)
        assert float(changed.run.duration) == 3.0
        assert changed.run.stop_texts == ("tank.pressure > 5 bar",)

    def test_nested_groups(self):
        changed = valve_circuit().with_values(
            {"valve.lower_spring.rate": "40 N/mm", "valve.lower_spring.preload": "0.2 mm"}
        )
        assert changed.parameters["valve.lower_spring.rate"] == 4e4
        assert changed.parameters["valve.lower_spring.preload"] == 2e-4
        assert changed.parameters["valve.upper_spring.rate"] == valve_circuit().parameters["valve.upper_spring.rate"]

    def test_omitted_group_is_created(self):
        assert (
            valve_circuit().with_values({"valve.friction.coulomb": "5 N"}).parameters["valve.friction.coulomb"] == 5.0
        )

    def test_characteristic_numbers(self):
        changed = valve_circuit().with_values({"valve.characteristic.closing": "40 um"})
        assert changed.parameters["valve.characteristic.closing"] == pytest.approx(40e-6)
        assert changed.numbers()["valve.characteristic.closing"].source.kind == "given"

    def test_characteristic_numbers_of_an_orifice(self):
        circuit = Circuit(
            {
                "a": Reservoir(pressure="7 bar"),
                "o": Orifice(from_="a", to="b", characteristic="varga2012", stroke="0.5 mm"),
                "b": Chamber(volume="1 l"),
            }
        )
        low = circuit.with_values({"o.characteristic.critical_ratio.p5": 0.6}).simulate(1.0)
        assert low["b.pressure"][-1] != circuit.simulate(1.0)["b.pressure"][-1]

    @pytest.mark.parametrize("size", [{"effective_area": "16 mm^2"}, {"nominal_flow": "380 l/min ANR"}])
    def test_sizes_of_an_orifice_replace_each_other(self, size):
        ((name, _),) = size.items()
        circuit = Circuit(
            {"a": Reservoir(pressure="7 bar"), "o": Orifice(from_="a", to="b", **size), "b": Chamber(volume="1 l")}
        )
        double = circuit.with_values(
            {
                f"o.{name}": Number(
                    2.0 * float(circuit.numbers()[f"o.{name}"]), circuit.numbers()[f"o.{name}"].unit, Source("fitted")
                )
            }
        )
        assert double.parameters["o.sonic_conductance"] == pytest.approx(
            2.0 * circuit.parameters["o.sonic_conductance"], rel=1e-12
        )

    def test_mode_selects_its_parameters(self):
        changed = valve_circuit().with_values({"valve.mode": "regulator"})
        assert changed.parameters == valve_circuit(mode="regulator").parameters

    def test_all_unknown_addresses_are_reported_together(self):
        with pytest.raises(InputErrors) as caught:
            valve_circuit().with_values(
                {
                    "tank.volum": 1,
                    "tank.mass": 1,
                    "tnk.volume": 1,
                    "tank": 1,
                    "valve.lower_spring.rat": 1,
                    "valve.characteristic.k9": 1,
                    "tank.volume.x": 1,
                }
            )
        addresses = {problem.address for problem in caught.value.problems}
        assert addresses == {
            "tank.volum",
            "tank.mass",
            "tnk.volume",
            "tank",
            "valve.lower_spring.rat",
            "valve.characteristic.k9",
            "tank.volume.x",
        }

    @pytest.mark.parametrize(
        ("address", "value", "code"),
        [
            ("tank.volume", float("nan"), "quantity.not_finite"),
            ("tank.volume", "-1 l", "fields.out_of_range"),
            ("valve.lower_spring.rate", "1 m", "quantity.other_quantity"),
            ("valve.characteristic.closing", "1 s", "quantity.other_quantity"),
            ("valve.mode", "papr", "fields.not_an_option"),
            ("run.duration", "-1 s", "fields.out_of_range"),
            ("gas.name", "heliumm", "library.unknown"),
            ("ambient.pressure", "1 bar g", "options.gauge_ambient"),
        ],
    )
    def test_invalid_values_are_rejected(self, address, value, code):
        with pytest.raises(InputError) as caught:
            valve_circuit().with_values({address: value})
        assert (caught.value.code, caught.value.address) == (code, address)

    def test_changed_port_is_checked_in_the_circuit(self):
        with pytest.raises(InputError) as caught:
            valve_circuit().with_values({"valve.outlet": "tnk"})
        assert {problem.code for problem in caught.value.problems} >= {"fields.not_an_option"}

    def test_gauge_below_vacuum_names_the_part(self):
        with pytest.raises(InputError) as caught:
            filling(initial_pressure="-0.95 bar g").with_values({"ambient.pressure": "0.9 bar"})
        assert (caught.value.code, caught.value.address) == ("numbers.below_vacuum", "tank.initial_pressure")

    def test_limit_of_an_input_can_be_a_parameter(self):
        valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l")
        parts = {"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="1 l")}
        circuit = Circuit(parts, {"valve.setpoint": Constant(6e5)})
        with pytest.raises(InputError) as caught:
            circuit.with_values({"valve.electronics.scaling.high": "4 bar"})
        assert (caught.value.code, caught.value.address) == ("wiring.signal_outside", "signals.valve.setpoint")

    def test_only_changed_parts_are_evaluated_again(self, monkeypatch):
        circuit, evaluated = valve_circuit(Constant(3e5)), []
        monkeypatch.setattr(Part, "numbers", lambda part: evaluated.append(type(part)) or {})
        changed = circuit.with_values({"tank.volume": "1 l"})
        assert evaluated == [Chamber]
        assert changed._drive is circuit._drive


class TestStructure:
    @pytest.fixture
    def compiled(self, monkeypatch):
        kernels: LruCache[Any] = LruCache(10)
        monkeypatch.setattr("poppet.engine.kernel.KERNELS", kernels)
        return kernels

    def test_changed_parameters_are_not_compiled_again(self, compiled):
        circuit = valve_circuit()
        kernel = circuit.kernel
        numbers: dict[str, Any] = {
            "tank.volume": "1 l",
            "tank.wall_heat_capacity": 5.0,
            "valve.lower_spring.rate": 1e4,
            "valve.characteristic.closing": 1e-5,
            "valve.characteristic.sonic_conductance.k1": 1e-9,
            "gas.gas_constant": 300.0,
            "ambient.pressure": 9e4,
            "supply.pressure": "6 bar g",
            "valve.subsonic_index": 0.6,
            "run.duration": 2.0,
        }
        for address, value in numbers.items():
            assert circuit.with_values({address: value}).kernel is kernel, address
        assert len(compiled) == 1

    def test_changed_signals_are_not_compiled_again(self, compiled):
        for signal in (None, Constant(3e5), Steps([0.0, 1.0], [1e5, 2e5]), Sine(2e5, 1e4, 3.0)):
            _ = valve_circuit(signal).kernel
        assert len(compiled) == 1

    @pytest.mark.parametrize(
        "changes",
        [
            {"tank.thermal": "isothermal", "tank.wall_conductance": 0.0},
            {"tank.wall_heat_capacity": "1 kJ/K"},
            {"fill.to": "ambient", "fill.from": "tank"},
        ],
    )
    def test_changed_options_and_wiring_are_compiled_again(self, compiled, changes):
        circuit = Circuit({**filling().parts, "bleed": Orifice(from_="tank", to="supply", **SIZE)})
        first_kernel = circuit.kernel
        assert circuit.with_values(changes).kernel is not first_kernel
        assert len(compiled) == 2

    def test_changed_mode_and_friction_are_compiled_again(self, compiled):
        for circuit in (valve_circuit(), valve_circuit(mode="regulator"), valve_circuit(friction={"coulomb": "1 N"})):
            _ = circuit.kernel
        assert len(compiled) == 3

    def test_changed_parameter_changes_the_result(self):
        small, large = filling(), filling().with_values({"tank.volume": "20 l"})
        assert small.structure == large.structure
        assert large.simulate()["tank.pressure"][20] < small.simulate()["tank.pressure"][20]


class TestResumed:
    @pytest.mark.parametrize(
        "tank",
        [
            {"wall_conductance": "3 W/K"},
            {
                "wall_conductance": "3 W/K",
                "wall_heat_capacity": "1 kJ/K",
                "outer_conductance": "1 W/K",
                "wall_temperature": "300 K",
            },
            {"thermal": "isothermal"},
            {"thermal": "polytropic", "polytropic_exponent": 1.2},
            {"thermal": "isentrope"},
        ],
    )
    def test_split_run_equals_one_run(self, tank):
        circuit = filling(**tank)
        full_run = circuit.simulate("6 s")
        first = circuit.simulate("2 s")
        second = circuit.simulate("4 s", start=first)
        for name in ("tank.pressure", "tank.temperature", "tank.mass"):
            assert second[name][-1] == pytest.approx(full_run[name][-1], rel=2e-6)
            assert second[name][0] == pytest.approx(first[name][-1], rel=1e-12)

    def test_valve_continues_its_motion(self):
        circuit = valve_circuit(Constant(4e5))
        full_run, first = circuit.simulate(4e-3), circuit.simulate(1e-3)
        assert abs(first["valve.velocity"][-1]) > 1e-2
        second = circuit.simulate(3e-3, start=first)
        assert second["valve.stroke"][-1] == pytest.approx(full_run["valve.stroke"][-1], rel=1e-4)
        assert second["valve.velocity"][0] == first["valve.velocity"][-1]

    def test_spool_at_its_end_stop(self):
        valve = DirectionalValve(supply="supply", outlet="tank", **SIZE)
        circuit = Circuit(
            {"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="1 l")},
            {"valve.command": Steps([0.0, 0.2], [1.0, 0.0])},
        )
        for duration in (0.1, 0.15, 0.3, 0.4):
            first = circuit.simulate(duration)
            position = circuit.resumed(first).parameters["valve.initial_position"]
            assert position == pytest.approx(first["valve.position"][-1], abs=1e-6)
            assert 0.0 <= position <= 1.0

    def test_other_units_are_converted(self):
        circuit = filling()
        first = circuit.simulate("2 s")
        converted = first.converted(["bar g", "degC", "g"])
        assert circuit.resumed(converted).parameters == pytest.approx(circuit.resumed(first).parameters, rel=1e-12)

    def test_missing_series_are_reported(self):
        circuit = filling()
        partial = circuit.simulate("2 s").select("tank.pressure")
        with pytest.raises(InputError) as caught:
            circuit.resumed(partial)
        assert caught.value.code == "circuit.no_series"
        assert "tank.temperature" in caught.value.facts["missing"]
        assert caught.value.facts["names"] == ("tank.pressure",)

    def test_recording_of_another_circuit_is_rejected(self):
        with pytest.raises(InputError) as caught:
            filling().resumed(Recording.from_series([0.0], {"p [Pa]": [1e5]}))
        assert caught.value.code == "circuit.no_series"


def test_numbers_have_unit_and_source():
    numbers = filling().numbers()
    assert list(numbers)[:2] == ["supply.pressure", "supply.temperature"]
    assert numbers["ambient.pressure"].source.kind == "standard"
    assert numbers["gas.gas_constant"].source.kind == "standard"
    assert all(number.unit for number in numbers.values())


def test_parameters_are_absolute():
    circuit = Circuit(
        {"a": Reservoir(pressure="6 bar g"), "o": Orifice(from_="a", to="ambient", **SIZE)},
        ambient=Ambient(pressure="0.9 bar"),
    )
    assert circuit.parameters["a.pressure"] == pytest.approx(6.9e5)


def test_all_parameters_can_be_set_by_address():
    circuit = valve_circuit(friction={"coulomb": "1 N"})
    assert circuit.with_values(circuit.numbers()).parameters == circuit.parameters


def test_conductances_from_air_scale_with_choked_nozzle_flow():
    """Choked flux is proportional to sqrt(kappa/R) (2/(kappa+1))^((kappa+1)/(2(kappa-1)))."""
    circuits = [
        Circuit(filling().parts, gas=GasChoice(name="helium", conductances=text)) for text in ("as given", "from air")
    ]
    flows = [circuit.simulate("0.1 s")["fill.mass_flow_rate"][0] for circuit in circuits]
    constant, kappa = circuits[0].gas.values()[:2]

    def flux(r: float, k: float) -> float:
        return np.sqrt(k / r) * (2.0 / (k + 1.0)) ** ((k + 1.0) / (2.0 * (k - 1.0)))

    assert flows[1] / flows[0] == pytest.approx(flux(constant, kappa) / flux(287.05, 1.4), rel=1e-12)


def test_circuit_without_states_inputs_or_signals():
    flow = Circuit({"a": Reservoir(pressure="7 bar"), "o": Orifice(from_="a", to="ambient", **SIZE)}).simulate("1 s")
    assert flow["o.mass_flow_rate"][-1] == pytest.approx(1e-8 * 1.185 * 7e5, rel=1e-12)
    closed = Circuit({"tank": Chamber(volume="1 l"), "valve": CheckValve(from_="tank", to="ambient", **SIZE)}).simulate(
        "1 s"
    )
    assert closed["tank.pressure"][-1] == pytest.approx(1e5, rel=1e-12)
    fed = Circuit({"tank": Chamber(volume="1 l"), "source": FlowSource(to="tank")}).simulate("1 s")
    assert fed["tank.pressure"][-1] == 1e5


class TestKinds:
    @pytest.mark.parametrize(
        ("arguments", "known"),
        [
            (([Chamber(volume=1.0)],), ("wiring.no_mapping", "parts")),
            (({"tank": "10 l"},), ("wiring.no_part", "parts.tank")),
            (({1: Chamber(volume=1.0)},), ("wiring.no_text", "parts")),
            ((filling().parts, {}, "10 s"), ("wiring.other_class", "run")),
            ((filling().parts, [Constant(1.0)]), ("wiring.no_mapping", "signals")),
        ],
    )
    def test_arguments_of_wrong_type_are_rejected(self, arguments, known):
        assert known in mistakes_of(*arguments)

    def test_values_are_a_mapping(self):
        with pytest.raises(InputError) as caught:
            filling().with_values("tank.volume")  # type: ignore[arg-type]
        assert caught.value.code == "address.no_mapping"

    def test_start_is_a_recording(self):
        with pytest.raises(InputError) as caught:
            filling().simulate(start="fill.csv")  # type: ignore[arg-type]
        assert caught.value.code == "circuit.no_recording"


class TestCopies:
    @pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda c: pickle.loads(pickle.dumps(c))])
    def test_circuit_can_be_copied_and_pickled_after_a_run(self, copied):
        circuit = valve_circuit(Steps([0.0, 1.0], [2e5, 3e5]))
        recording = circuit.simulate()
        assert np.array_equal(copied(circuit).simulate().values, recording.values)

    def test_repr_is_a_table_of_parts(self):
        lines = repr(valve_circuit(Constant(2e5))).splitlines()
        assert lines[0] == "Circuit '': 4 parts"
        assert lines[3] == "  valve   MainStage supply=supply, outlet=tank, exhaust=room"
        assert lines[-1] == "  driven: valve.pilot_pressure"


class TestNearestAddress:
    @pytest.mark.parametrize(
        ("given", "near"),
        [
            ("volume", "tank.volume"),
            ("volmue", "tank.volume"),
            ("tnak.volume", "tank.volume"),
            ("tank", "tank.volume"),
        ],
    )
    def test_suggestions_are_complete_addresses(self, given, near):
        with pytest.raises(InputError) as caught:
            filling().with_values({given: 1.0})
        assert caught.value.code == "address.meant"
        assert near in caught.value.facts["names"]

    def test_suggestion_for_a_valid_part(self):
        with pytest.raises(InputError) as caught:
            filling().with_values({"tank.volmue": 1.0})
        assert caught.value.code == "names.unknown"
        assert caught.value.facts["suggestion"].names[0] == "tank.volume"

    def test_no_suggestion_without_a_similar_address(self):
        with pytest.raises(InputError) as caught:
            filling().with_values({"qqq": 1.0})
        assert caught.value.code == "address.no_owner"
        assert caught.value.facts["owners"] == ["supply", "fill", "tank", "ambient", "gas", "run"]


def test_circuit_is_immutable():
    """A part that is added to a mapping of a circuit would not be simulated."""
    parts = {
        "tank": Chamber(volume="10 l", initial_pressure="3 bar"),
        "hole": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    signals = {"hole.opening": Steps([0.0, 1.0], [0.0, 1.0])}
    circuit = Circuit(parts, signals)
    parts["tank"] = Chamber(volume="1 l")
    signals.clear()
    assert float(circuit.numbers()["tank.volume"]) == pytest.approx(0.01)
    assert [*circuit.signals] == ["hole.opening"]
    for mapping in (circuit.parts, circuit.signals, circuit.connections):
        with pytest.raises(TypeError):
            mapping["tank"] = parts["tank"]
    restored = pickle.loads(pickle.dumps(copy.deepcopy(circuit)))
    assert restored.simulate("2 s").last() == circuit.simulate("2 s").last()


def test_addresses_of_wrong_type_are_rejected():
    circuit = Circuit(
        {"tank": Chamber(volume="10 l"), "hole": Orifice(from_="tank", to="ambient", effective_area=1e-6)}
    )
    with refused("address.no_owner"):
        circuit.with_values({1: 2})
