"""Stop conditions: their texts, and the time at which they end a run."""

from __future__ import annotations

from typing import Any, ClassVar

import pytest

from poppet import Circuit, library
from poppet.circuit.stop_conditions import domain_conditions, parse_stop_condition
from poppet.core.errors import InputError
from poppet.parts import Chamber, Orifice, Reservoir
from poppet.signals import Points, Steps

OUTPUTS = {"tank.pressure": "Pa", "tank.temperature": "K", "supply.pressure": "Pa", "fill.mass_flow_rate": "kg/s"}


def filling(**options: Any) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "tank": Chamber(volume="10 l", thermal="isothermal"),
        },
        **options,
    )


def holds(text: str, **values: float) -> bool:
    """Return True if the condition is met by outputs such as `tank.pressure`, with _ for the dot."""
    condition = parse_stop_condition(text, OUTPUTS, 0.95e5)
    y = [values.get(name.replace(".", "_"), 0.0) for name in OUTPUTS]
    total = condition.weights[2] + sum(
        w * y[index] for index, w in zip(condition.places, condition.weights, strict=False) if index >= 0
    )
    return total > 0.0


@pytest.mark.parametrize(
    ("text", "limit"),
    [
        ("tank.pressure > 5 bar", 5e5),
        ("tank.pressure>5bar", 5e5),
        ("tank.pressure >= 500 kPa", 5e5),
        ("tank.pressure > 500000", 5e5),
        ("tank.pressure > 5e5", 5e5),
        ("tank.pressure > 4 bar g", 4.95e5),
        ("  tank.pressure  >  4 bar(g) ", 4.95e5),
    ],
)
def test_limits(text, limit):
    assert holds(text, tank_pressure=limit + 1.0)
    assert not holds(text, tank_pressure=limit - 1.0)


def test_below():
    assert holds("tank.temperature < 0 degC", tank_temperature=273.0)
    assert not holds("tank.temperature <= 0 degC", tank_temperature=273.3)


def test_mass_flow_as_volume_at_its_reference():
    assert holds("fill.mass_flow_rate < 60 l/min ANR", fill_mass_flow_rate=1.18e-3)
    assert not holds("fill.mass_flow_rate < 60 l/min ANR", fill_mass_flow_rate=1.19e-3)


def test_another_output():
    assert holds("tank.pressure > supply.pressure", tank_pressure=6.0, supply_pressure=5.0)
    assert not holds("tank.pressure > supply.pressure", tank_pressure=5.0, supply_pressure=6.0)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("tank.pressure", "stop.no_condition"),
        ("", "stop.no_condition"),
        ("tank.pressure = 5 bar", "stop.no_condition"),
        ("5 bar < tank.pressure", "stop.no_condition"),
        ("tank.presure > 5 bar", "stop.unknown_output"),
        ("tank.pressure > supply.presure", "stop.unknown_output"),
        ("tank.pressure > tank.temperature", "stop.other_unit"),
    ],
)
def test_invalid_arguments_are_rejected(text, code):
    with pytest.raises(InputError) as caught:
        parse_stop_condition(text, OUTPUTS, 1e5)
    assert (caught.value.code, caught.value.address, caught.value.facts["text"]) == (code, "run.stop_when", text)


@pytest.mark.parametrize("name", ["tank.presure", "supply.presure"])
def test_misspelt_output_has_a_suggestion(name):
    with pytest.raises(InputError) as caught:
        parse_stop_condition(f"tank.pressure > {name}", OUTPUTS, 1e5)
    assert name.replace("presure", "pressure") in caught.value.facts["suggestion"].names


@pytest.mark.parametrize(
    ("threshold", "code"),
    [
        ("5 m", "quantity.other_quantity"),
        ("much", "quantity.no_number"),
        ("nan", "quantity.not_finite"),
        ("inf", "quantity.not_finite"),
        ("-5 bar", "quantity.pressure_below_zero"),
        ("5,0 bar", "quantity.decimal_comma"),
    ],
)
def test_invalid_thresholds_are_rejected(threshold, code):
    with pytest.raises(InputError) as caught:
        parse_stop_condition(f"tank.pressure > {threshold}", OUTPUTS, 1e5)
    assert (caught.value.code, caught.value.facts["mistake"].code) == ("stop.no_threshold", code)
    assert caught.value.hint == caught.value.facts["mistake"].hint


def test_volume_flow_without_reference_state_is_rejected():
    with pytest.raises(InputError) as caught:
        parse_stop_condition("fill.mass_flow_rate > 60 l/min", OUTPUTS, 1e5)
    assert caught.value.facts["mistake"].code == "quantity.flow_without_state"


def test_run_ends_when_the_condition_is_met():
    """Isothermal and choked: p = p0 + C rho0 R T ps t / V."""
    recording = filling().simulate("20 s", stop_when="tank.pressure > 2 bar")
    instant = 1e5 * 10e-3 / (1e-8 * 1.185 * 287.05 * 293.15 * 7e5)
    assert recording.time[-1] == pytest.approx(instant, rel=1e-9)
    assert recording["tank.pressure"][-1] == pytest.approx(2e5, rel=1e-9)
    assert recording.ending.code == "run.condition_met"
    assert recording.ending.facts == {"condition": "tank.pressure > 2 bar", "time": recording.time[-1]}
    assert recording.time[-2] < recording.time[-1] < recording.time[-2] + 0.02


def test_the_first_of_several_ends_the_run():
    recording = filling().simulate("20 s", stop_when=["tank.pressure > 3 bar", "tank.pressure > 2 bar"])
    assert recording.ending.facts["condition"] == "tank.pressure > 2 bar"


def test_condition_met_at_the_start():
    recording = filling().simulate("20 s", stop_when="tank.pressure < 2 bar")
    assert recording.time.tolist() == [0.0]
    assert recording.ending.facts["time"] == 0.0


def test_a_condition_met_by_a_jump_of_an_input():
    signal = {"supply.pressure": Steps([0.0, 1.0], [7e5, 2e5])}
    recording = filling(signals=signal).simulate("20 s", "0.1 s", stop_when="supply.pressure < 5 bar")
    assert recording.time[-1] == 1.0
    assert recording["supply.pressure"][-2:].tolist() == [7e5, 2e5]


def test_a_condition_never_met():
    assert filling().simulate("2 s", stop_when="tank.pressure > 9 bar").ending.code == "run.done"


def test_all_solvers_stop_at_the_same_time():
    instants = [
        filling().simulate("5 s", "0.01 s", stop_when="tank.pressure > 2 bar", solver=s).time[-1]
        for s in ("rosenbrock", "lsoda", "radau", "cvodes")
    ]
    assert instants == pytest.approx([instants[0]] * 4, rel=1e-6)


class TestDomain:
    table: ClassVar[dict[str, Any]] = {
        "kind": "table",
        "stroke": ["0 mm", "1 mm"],
        "sonic_conductance": ["1e-9 m^3/(s Pa)", "1e-8 m^3/(s Pa)"],
        "critical_ratio": [0.3, 0.3],
        "edge": "error",
    }

    def test_closed_flow_path_has_no_lower_limit(self):
        outputs = {"o.stroke": "m"}
        assert len(domain_conditions("o.stroke", library.characteristic("varga2012").limits(), outputs)) == 2
        assert len(domain_conditions("o.stroke", library.characteristic("varga2012.closed").limits(), outputs)) == 1

    def test_stroke_outside_the_domain_ends_the_run(self):
        parts = {**filling().parts, "fill": Orifice(from_="supply", to="tank", characteristic=self.table)}
        circuit = Circuit(parts, {"fill.stroke": Points([0.0, 2.0], [0.0, 2e-3])})
        recording = circuit.simulate("2 s", throw=False)
        assert recording.time[-1] == pytest.approx(1.01, abs=1e-9)
        assert (recording.ending.code, recording.ending.address) == ("run.left_domain", "fill.stroke")
