"""Vacuum ejector and suction cup: defaults, limits, second law, steps of settled circuits, continued runs."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from poppet import Chamber, Circuit, Orifice, Reservoir, SuctionCup, Tube, VacuumEjector, loads
from poppet.circuit.options import Ambient
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
CP, R = 1004.675, 287.05
GASES = st.builds(GasState, st.floats(1e3, 1e6), st.floats(250.0, 400.0))
CUP: dict[str, Any] = {"port": "hose", "volume": "5 cm^3", "diameter": "40 mm", "thermal": "isothermal"}
AREA = 0.25 * math.pi * 0.04**2
CURVE = {"pressure": ["-0.8 bar g", "-0.4 bar g", "0 bar g"], "suction_flow": [0, "20 l/min ANR", "35 l/min ANR"]}


def ejector(**fields: Any) -> VacuumEjector:
    size = {} if "nozzle_conductance" in fields else {"air_consumption": "60 l/min ANR"}
    return VacuumEjector(supply="net", vacuum="hose", **{**size, **fields})


def handling(supply: Any = 6e5, cup: dict[str, Any] | None = None, **fields: Any) -> Circuit:
    parts = {
        "net": Reservoir(pressure=6e5),
        "ejector": ejector(**fields),
        "hose": Chamber(volume="20 cm^3", thermal="isothermal"),
        "cup": SuctionCup(**CUP, **(cup or {})),
    }
    return Circuit(parts, {"net.pressure": Steps([0.0], [supply]) if isinstance(supply, float) else supply})


def flows_of(part: Any, *gas: GasState) -> Any:
    numbers = part.parameters(AIR)
    return part.flows(Scope(numbers, {}, {}, AIR), dict(zip(part.ports(), gas, strict=True)))


def entropy_production(flows: Any, gas: dict[str, GasState]) -> float:
    """Entropy that all gas nodes gain per time, from their masses and energies [W/K]."""
    total = 0.0
    for flow in flows:
        for end, sign in ((flow.source, -1.0), (flow.target, 1.0)):
            state = gas[end]
            entropy = CP * math.log(state.temperature) - R * math.log(state.pressure)
            total += sign * (flow.enthalpy / state.temperature - flow.mass * (CP - entropy))
    return total


class TestEjector:
    def test_air_consumption_is_choked_flow_at_the_nominal_pressure(self):
        part = ejector(nominal_pressure="4.5 bar g")
        assert part.parameters(AIR)["nozzle_conductance"] == pytest.approx(1e-3 / 5.5e5)
        result = flows_of(part, GasState(5.5e5, 293.15), GasState(1e5, 293.15), GasState(1e5, 293.15))
        assert result.outputs["supply_mass_flow_rate"][0] == pytest.approx(1e-3 * 1.185)

    def test_another_gas(self):
        """Choked flow is proportional to 1/sqrt(R) for equal exponents, suction to the density."""
        light = dataclasses.replace(AIR, gas_constant=4 * 287.05)
        part = ejector(nominal_pressure="5 bar g", max_suction_flow="30 l/min ANR")
        numbers = part.parameters(light)
        scope = Scope(numbers, {}, {}, light)
        states = [GasState(pressure, 293.15) for pressure in (6e5, 1e5, 1e5)]
        outputs = part.flows(scope, dict(zip(part.ports(), states, strict=True))).outputs
        assert outputs["supply_mass_flow_rate"][0] == pytest.approx(1e-3 * 1.185 / 2.0)
        assert outputs["vacuum_mass_flow_rate"][0] == pytest.approx(0.5e-3 * 1.185 / 4.0)

    def test_assumed_values(self):
        numbers = ejector().parameters(AIR)
        assert numbers["max_suction_flow"] == pytest.approx(0.5e-3)
        assert numbers["max_vacuum"] == pytest.approx(0.85e5)
        assert numbers["vacuum_conductance"] == pytest.approx(2.0 * numbers["nozzle_conductance"])
        (note,) = ejector().notes()
        assert (note.code, note.facts["assumed"]) == ("vacuum.generic_curve", ["max_suction_flow", "max_vacuum"])
        (note,) = ejector(max_suction_flow="30 l/min ANR", max_vacuum="0.8 bar").notes()
        assert note.facts["assumed"] == []
        assert ejector(suction_curve=CURVE).notes() == ()

    def test_max_vacuum_follows_the_ambient_pressure(self):
        thin = dataclasses.replace(AIR, pressure=0.8e5)
        assert ejector().parameters(thin)["max_vacuum"] == pytest.approx(0.68e5)

    @pytest.mark.parametrize(("pressure", "flow"), [(1e5, 35), (0.6e5, 20), (0.4e5, 10), (0.2e5, 0), (0.3e5, 5)])
    def test_a_measured_curve(self, pressure, flow):
        result = flows_of(
            ejector(suction_curve=CURVE), GasState(6e5, 293.0), GasState(pressure, 293.0), GasState(1e5, 293.0)
        )
        assert result.outputs["vacuum_mass_flow_rate"][0] == pytest.approx(flow / 60e3 * 1.185, abs=1e-12)

    def test_errors(self):
        with refused("vacuum.no_nozzle", "nozzle_conductance"):
            VacuumEjector(supply="net", vacuum="hose")
        with refused("vacuum.two_nozzles", "air_consumption"):
            ejector(nozzle_conductance=1e-9, air_consumption="60 l/min ANR")
        for name in ("max_vacuum", "max_suction_flow"):
            with refused("vacuum.idle_generic", name):
                ejector(suction_curve=CURVE, **{name: 1e-3})
        with refused("vacuum.open_curve", "suction_curve.suction_flow_1"):
            ejector(suction_curve={"pressure": [2e4, 1e5], "suction_flow": [1e-4, 1e-3]})
        with refused("schedule.not_rising", "suction_curve.pressure"):
            ejector(suction_curve={"pressure": [1e5, 2e4], "suction_flow": [0.0, 1e-3]}).parameters(AIR)
        with refused("fields.missing", "suction_curve.suction_flow"):
            ejector(suction_curve={"pressure": [1e5, 2e4]})
        for vacuum in ("1 bar", "1.2 bar"):
            with refused("vacuum.above_ambient", "max_vacuum"):
                ejector(max_vacuum=vacuum).parameters(AIR)
        with refused("vacuum.nominal_below_ambient", "nominal_pressure"):
            ejector(nominal_pressure="0.9 bar").parameters(AIR)

    def test_errors_are_reported_together(self):
        with refused("vacuum.two_nozzles") as caught:
            ejector(nozzle_conductance=1e-9, air_consumption="60 l/min ANR", suction_curve=CURVE, max_vacuum="0.8 bar")
        assert [problem.code for problem in caught.value.problems] == ["vacuum.two_nozzles", "vacuum.idle_generic"]

    def test_a_curve_in_a_file(self):
        text = """
            [parts.net]
            kind = "reservoir"
            pressure = "5 bar g"
            [parts.ejector]
            kind = "vacuum_ejector"
            supply = "net"
            vacuum = "vessel"
            nozzle_conductance = "0.2 dm^3/(s bar)"
            [parts.ejector.suction_curve]
            pressure = ["-0.8 bar g", "-0.4 bar g", "0 bar g"]
            suction_flow = [0, "20 l/min ANR", "35 l/min ANR"]
            [parts.vessel]
            kind = "chamber"
            volume = "1 l"
            [run]
            duration = "30 s"
        """
        circuit = loads(text)
        assert circuit.simulate()["vessel.pressure"][-1] == pytest.approx(0.2e5, rel=1e-3)
        stronger = circuit.with_values({"ejector.suction_curve.pressure_1": 0.1e5})
        assert stronger.simulate()["vessel.pressure"][-1] == pytest.approx(0.1e5, rel=1e-2)

    def test_no_suction_without_supply(self):
        for supply in (1e5, 0.5e5):
            result = flows_of(ejector(), GasState(supply, 293.0), GasState(0.9e5, 293.0), GasState(1e5, 293.0))
            assert result.outputs["vacuum_mass_flow_rate"][0] < 0.0
            closed = ejector(check_valve=True)
            result = flows_of(closed, GasState(supply, 293.0), GasState(0.9e5, 293.0), GasState(1e5, 293.0))
            assert result.outputs["vacuum_mass_flow_rate"][0] == 0.0

    @given(
        st.lists(GASES, min_size=3, max_size=3),
        st.floats(1e-6, 1.0),
        st.floats(0.01, 0.999),
        st.floats(1.01e5, 1e6),
        st.booleans(),
    )
    def test_entropy_does_not_decrease(self, states, suction, vacuum, nominal, closed):
        """Also for suction curves that no ejector can have, where the limit of the second law acts."""
        part = ejector(
            nozzle_conductance=1e-9, max_suction_flow=suction, max_vacuum=vacuum * 1e5, nominal_pressure=nominal,
            check_valve=closed,
        )  # fmt: skip
        result = flows_of(part, *states)
        gas = dict(zip(part.ports(), states, strict=True))
        scale = sum(abs(flow.mass) for flow in result.flows) * R
        assert entropy_production(result.flows, gas) >= -1e-9 * scale - 1e-300

    def test_an_impossible_curve_is_limited_to_the_reversible_flow(self):
        part = ejector(nozzle_conductance=1e-9, max_suction_flow=1.0)
        states = GasState(6e5, 293.15), GasState(0.5e5, 293.15), GasState(1e5, 293.15)
        result = flows_of(part, *states)
        flow = 1e-9 * 1.185 * 6e5 * math.log(6.0) / math.log(2.0)
        assert result.outputs["vacuum_mass_flow_rate"][0] == pytest.approx(flow)
        assert entropy_production(result.flows, dict(zip(part.ports(), states, strict=True))) == pytest.approx(
            0.0, abs=1e-12
        )


class TestCup:
    def test_defaults(self):
        numbers = SuctionCup(**CUP).parameters(AIR)
        assert numbers["lip_conductance"] == pytest.approx(0.1992e-8 * AREA * 1e6, rel=1e-3)
        assert numbers["port_conductance"] == pytest.approx(0.01 * numbers["lip_conductance"])
        assert numbers["initial_gripped"] == 0.0
        assert SuctionCup(**CUP).parameters(dataclasses.replace(AIR, pressure=1.013e5))["initial_pressure"] == 1.013e5

    @pytest.mark.parametrize(
        ("fields", "address"),
        [({"volume": 0.0}, "volume"), ({"diameter": "0 mm"}, "diameter"), ({"sealed": 1.2}, "sealed")],
    )
    def test_values_outside_the_limits_are_rejected(self, fields, address):
        with refused("fields.out_of_range", address):
            SuctionCup(**{**CUP, **fields})

    def test_a_constant_load_is_held_as_soon_as_the_force_suffices(self):
        run = handling(cup={"load_force": "50 N"}, max_vacuum="0.8 bar").simulate(1.0, 1e-4)
        held, force = run["cup.held"] > 0.5, run["cup.holding_force"]
        assert force[int(np.argmax(held))] == pytest.approx(50.0, abs=3.0)
        assert held[-1]
        assert force[-1] == pytest.approx(0.8e5 * AREA, rel=1e-3)

    def test_a_load_beyond_the_largest_force_is_never_held(self):
        run = handling(cup={"load_force": "110 N"}, max_vacuum="0.8 bar").simulate(2.0)
        assert run["cup.held"].max() < 1e-6
        assert run["cup.pressure"][-1] == pytest.approx(0.2e5, rel=1e-3)  # it stays on its support

    def test_a_pulling_load_needs_vacuum_and_a_pressing_one_does_not(self):
        for load, held in ((1.0, 0.0), (-1.0, 1.0)):
            run = handling(1e5, cup={"load_force": load}).simulate(0.5)
            assert run["cup.held"][-1] == pytest.approx(held, abs=1e-6)

    def test_overpressure_in_the_cup_ejects_the_workpiece(self):
        parts = {
            "hose": Chamber(volume="1 l", thermal="isothermal", initial_pressure="2 bar"),
            "cup": SuctionCup(**CUP, initial_pressure="0.2 bar", load_force="1 N"),
        }
        run = Circuit(parts).simulate(0.5, 1e-4)
        assert run["cup.held"][0] == 1.0
        assert run["cup.held"][-1] == pytest.approx(0.0, abs=1e-9)
        assert run["cup.pressure"][-1] == pytest.approx(1e5, rel=2e-3)

    def test_barometric_pressure_is_no_vacuum(self):
        """The ambient of 1.013 bar does not hold a workpiece, so none drops."""
        circuit = dataclasses.replace(handling(cup={"load_force": "20 N"}), ambient=Ambient(pressure="1.013 bar"))
        run = circuit.simulate(1.0)
        assert [note.code for note in run.remarks if note.code == "vacuum.dropped"] == []
        assert run["cup.held"][-1] == pytest.approx(1.0)

    def test_a_cup_at_a_hose(self):
        parts = {
            "net": Reservoir(pressure=6e5),
            "ejector": ejector(),
            "hose": Tube(
                from_="ejector.vacuum", to="cup.port", length="2 m", bore="4 mm", cells=3, wall_conductance=1.0
            ),
            "cup": SuctionCup(**CUP, load_force="50 N"),
        }
        run = Circuit(parts).simulate(2.0)
        assert run["cup.held"][-1] == pytest.approx(1.0)
        assert run["cup.pressure"][-1] == pytest.approx(0.15e5, rel=1e-3)

    def test_a_run_continues(self):
        circuit = handling(Steps([0.0, 0.3], [6e5, 1e5]), cup={"load_force": "30 N", "leak_conductance": 1e-11})
        whole, first = circuit.simulate(0.5), circuit.simulate(0.25)
        assert first["cup.held"][-1] == pytest.approx(1.0)
        rest = dataclasses.replace(circuit.resumed(first), signals={"net.pressure": Steps([0.0, 0.05], [6e5, 1e5])})
        second = rest.simulate(0.25)
        for name in ("cup.pressure", "cup.held", "hose.pressure"):
            assert second[name][-1] == pytest.approx(whole[name][-1], rel=1e-3, abs=1e-6)
        assert whole["cup.held"][-1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    ("supply", "cup"),
    [
        (6e5, {"load_force": "50 N"}),
        (6e5, {"load_force": "50 N", "leak_conductance": 1e-10}),
        (6e5, {"load_force": "50 N", "sealed": 0.98}),
        (Steps([0.0, 1.0], [6e5, 1e5]), {"load_force": "50 N"}),
        (Steps([0.0, 1.0], [6e5, 3e5]), {"load_force": "50 N", "leak_conductance": 1e-10}),
    ],
)
def test_a_settled_circuit_takes_few_steps(supply, cup):
    circuit = handling(supply, cup)
    short, long = (circuit.simulate(duration) for duration in (10.0, 1000.0))
    assert long.statistics["accepted_steps"] < short.statistics["accepted_steps"] + 30


def test_entropy_of_a_closed_circuit_never_falls():
    """Random vessels without heat at all ports of an ejector: the entropy of the gas rises in each interval."""
    generator = np.random.default_rng(1219)
    for _ in range(30):
        vessels = {
            name: Chamber(
                volume=10.0 ** generator.uniform(-5.0, -2.0),
                initial_pressure=10.0 ** generator.uniform(4.0, 6.0),
                initial_temperature=generator.uniform(250.0, 400.0),
            )
            for name in ("net", "hose", "exhaust")
        }
        part = ejector(
            nozzle_conductance=10.0 ** generator.uniform(-10.0, -8.0), exhaust="exhaust",
            max_suction_flow=10.0 ** generator.uniform(-4.0, -1.0), max_vacuum=generator.uniform(0.1e5, 0.99e5),
            nominal_pressure=generator.uniform(2e5, 8e5), check_valve=bool(generator.integers(2)),
        )  # fmt: skip
        leak = Orifice(from_="exhaust", to="net", sonic_conductance=generator.choice([0.0, 1e-10]), critical_ratio=0.3)
        run = Circuit({**vessels, "ejector": part, "leak": leak}).simulate(20.0, 0.02, 1e-8)
        entropy = sum(
            run[f"{name}.mass"] * (CP * np.log(run[f"{name}.temperature"]) - R * np.log(run[f"{name}.pressure"]))
            for name in vessels
        )
        scale = R * sum(run[f"{name}.mass"] for name in vessels).max()
        assert np.diff(entropy).min() > -1e-7 * scale
        energy = sum(run[f"{name}.mass"] * run[f"{name}.temperature"] for name in vessels)
        assert np.ptp(energy) < 1e-9 * energy[0]
