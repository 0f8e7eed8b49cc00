"""`poppet size`: closed forms of charging, yields, requirements that are not monotonic, rejected arguments."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet import InputError, loads
from poppet.ensemble import size
from poppet.identify.free_parameter import read_free
from refusals import refused

CHARGE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[parts.tank]
kind = "chamber"
volume = "10 l"
thermal = "THERMAL"
initial_pressure = "1 bar"
[run]
duration = "20 s"
[ensemble]
runs = 400
sampling = "sobol"
[ensemble.parameters]
"tank.volume" = { distribution = "normal", relative_sigma = 0.02 }
[ensemble.metrics]
fill = { of = "tank.pressure", metric = "time_to", value = "2 bar" }
[requirements]
fast = "fill < 5 s"
"""
C = "fill.sonic_conductance"
EXACT = 1e5 * 10e-3 / (1.185 * 7e5 * 287.05 * 293.15 * 5.0)
"""Choked from 1 to 2 bar: dp/dt = n R T rho0 C p1/V, with n = 1 isothermal and kappa adiabatic."""
Z = 1.6448536269514722


@pytest.mark.parametrize(("thermal", "exponent"), [("isothermal", 1.0), ("energy", 1.4)])
def test_closed_forms_of_charging(thermal: str, exponent: float) -> None:
    circuit = loads(CHARGE.replace("THERMAL", thermal))
    sizing = size(circuit, C)
    assert sizing.value == pytest.approx(EXACT / exponent, rel=1e-4)
    assert sizing.resolution < 1e-5
    assert (sizing.limiting, sizing.remarks) == ("fast", ())
    assert sizing.holding[0][0] == sizing.value
    largest = size(circuit, "tank.volume", largest=True)
    assert largest.value == pytest.approx(10e-3 * 1e-8 / (EXACT / exponent), rel=1e-4)
    assert 0.0 < sizing.margins["fast"] < 1e-3


def test_value_for_a_yield_has_the_margin_of_the_spread() -> None:
    """C is proportional to the volume: 95 % of a normal distribution are below 1 + 1.645 sigma."""
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    sizing = size(circuit, C, share=0.95, runs=200, between=(EXACT / 2.0, EXACT * 2.0))
    assert sizing.value == pytest.approx(EXACT * (1.0 + 0.02 * Z), rel=2e-3)
    assert sizing.interval[0] < 0.95 < sizing.interval[1]
    assert sizing.margins["fast"] > 0.0
    # If the free parameter is uncertain, its relative spread is constant.
    sizing = size(circuit, "tank.volume", share=0.95, largest=True, runs=200, between=("20 l", "60 l"))
    assert sizing.value == pytest.approx(10e-3 * 1e-8 / EXACT / (1.0 + 0.02 * Z), rel=2e-3)


def test_value_is_the_median_of_an_uncertain_parameter() -> None:
    """The value in the circuit has no effect: the margin depends only on the relative spread."""
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    numbers = {"tank.volume": {"distribution": "normal", "mean": "20 l", "relative_sigma": 0.02}}
    fields = {"share": 0.95, "largest": True, "runs": 200, "between": ("20 l", "60 l"), "parameters": numbers}
    sizing = size(circuit, "tank.volume", **fields)
    assert sizing.value == pytest.approx(10e-3 * 1e-8 / EXACT / (1.0 + 0.02 * Z), rel=2e-3)


def test_too_few_runs_for_the_yield_give_a_remark() -> None:
    sizing = size(loads(CHARGE.replace("THERMAL", "isothermal")), C, share=0.95, runs=1)
    assert sizing.interval == pytest.approx((0.2065, 1.0), abs=1e-4)
    assert [(note.code, note.facts["wanted"]) for note in sizing.remarks] == [("size.few", 20)]
    sizing = size(loads(CHARGE.replace("THERMAL", "isothermal")), C, share=0.9999, runs=1)
    assert [(note.code, note.facts["wanted"]) for note in sizing.remarks] == [("size.few", 10_000)]


def test_next_standard_size() -> None:
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    sizes = ["0.2 dm^3/(s bar)", "0.5 dm^3/(s bar)", "0.3 dm^3/(s bar)"]
    assert size(circuit, C, sizes=sizes).size == pytest.approx(0.3e-8)
    with refused("fields.out_of_range", value=-1e-9):
        size(circuit, C, sizes=["-0.1 dm^3/(s bar)"])
    without_size = size(circuit, C, sizes=["0.2 dm^3/(s bar)"])
    assert math.isnan(without_size.size)
    assert [note.code for note in without_size.remarks] == ["size.no_standard"]


def test_two_requirements_met_in_an_interval() -> None:
    """The filling time needs a large valve, the peak flow a small one: both are met in an interval only."""
    text = CHARGE.replace("THERMAL", "isothermal").replace(
        "[requirements]", 'peak = { of = "fill.mass_flow_rate", metric = "max", unit = "g/s" }\n[requirements]'
    )
    circuit = loads(text + 'quiet = "peak < 5 g/s"\n')
    small, large = size(circuit, C), size(circuit, C, largest=True)
    exact = 5e-3 / (1.185 * 7e5)
    assert small.value == pytest.approx(EXACT, rel=1e-4)
    assert large.value == pytest.approx(exact, rel=1e-4)
    assert (small.limiting, large.limiting) == ("fast", "quiet")
    assert size(circuit, C, meet=["quiet"]).remarks[0].code == "size.end"
    # Both requirements together cannot be met.
    none = size(loads(text + 'quiet = "peak < 1 g/s"\n'), C)
    assert not none.is_met
    assert [note.code for note in none.remarks] == ["size.none_inside"]


@pytest.mark.parametrize("width", [1e-2, 1e-4])
def test_narrow_interval_between_two_values_is_found(width: float) -> None:
    """The first values differ by 15 %; the required filling time is met in a much narrower interval."""
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    fields = {"requirements": {"just": f"{5.0 * (1.0 - width)} s < fill < 5 s"}}
    small, large = size(circuit, C, **fields), size(circuit, C, largest=True, **fields)
    assert small.value == pytest.approx(EXACT, rel=1e-5)
    assert large.value == pytest.approx(EXACT / (1.0 - width), rel=1e-5)
    assert small.remarks == large.remarks == ()
    uncertain = size(circuit, C, share=0.2, runs=64, **fields)
    assert uncertain.is_met == (width > 5e-3)  # 64 tanks of 2 % spread over 8 % of time
    none = size(circuit, C, requirements={"no": "5 s < fill < 5 s"})
    assert [note.code for note in none.remarks] == ["size.none_inside"]
    assert none.remarks[0].facts["value"] == pytest.approx(EXACT, rel=1e-5)


def test_parameter_file_of_the_circuit_is_used_for_yields_only(tmp_path) -> None:
    (tmp_path / "numbers.csv").write_text("tank.volume [l]\n9.9\n10.1\n", encoding="utf-8")
    text = CHARGE.replace("THERMAL", "isothermal").partition("[ensemble]")[0]
    table = '[ensemble]\nsampling = "file"\nfile = "numbers.csv"\n[ensemble.metrics]'
    circuit = loads(text + table + CHARGE.partition("[ensemble.metrics]")[2], folder=tmp_path)
    assert size(circuit, C).value == pytest.approx(EXACT, rel=1e-4)
    # Both tanks must meet the requirement, also the larger one.
    assert size(circuit, C, share=0.9).value == pytest.approx(1.01 * EXACT, rel=1e-4)


def wave_metric(time: np.ndarray, pressure: np.ndarray) -> float:
    """Return a metric that oscillates with the final pressure."""
    return math.cos(math.pi * float(pressure[-1]) / 1e5)


def test_two_intervals_give_a_remark() -> None:
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    metrics = {"wave": {"of": "tank.pressure", "metric": wave_metric}}
    fields = {"metrics": metrics, "requirements": {"high": "wave > 0.5"}}
    sizing = size(circuit, C, between=("0.01 dm^3/(s bar)", "0.3 dm^3/(s bar)"), **fields)
    # The pressure ends at 2 bar a fourth of the time later; waves are high from 5/3 to 7/3 bar and from 11/3.
    rate = EXACT * 5.0 / 20.0
    expected = [(2.0 / 3.0 * rate, 4.0 / 3.0 * rate)]
    assert sizing.value == pytest.approx(expected[0][0], rel=1e-4)
    assert sizing.holding[0][1] == pytest.approx(expected[0][1], rel=0.05)
    assert [note.code for note in sizing.remarks] == ["size.several"]


def test_requirements_that_no_value_meets() -> None:
    circuit = loads(CHARGE.replace("THERMAL", "isothermal"))
    low = size(circuit, C, between=("0.01 dm^3/(s bar)", "0.1 dm^3/(s bar)"))
    assert [note.code for note in low.remarks] == ["size.none_upper"]
    shown = "0.1 dm^3/(s bar)"
    assert low.remarks[0].facts == {"value": pytest.approx(1e-9), "unit": "m^3/(s Pa)", "shown": shown}
    narrow = loads(CHARGE.replace("THERMAL", "isothermal").replace("1 dm^3/(s bar)", "0.1 dm^3/(s bar)"))
    in_other_unit = size(narrow, "supply.temperature", between=("-10 degC", "60 degC"))
    assert [note.code for note in in_other_unit.remarks] == ["size.none_lower"]
    assert "supply.temperature = -10 degC." in str(in_other_unit.remarks[0])
    with pytest.raises(InputError) as caught:
        size(circuit, C, between=(0.5, "5 dm^3/(s bar)"))  # a number is in SI
    assert caught.value.code == "size.range"
    with pytest.raises(InputError, match=r'Write "0.5 dm\^3/\(s bar\)"') as caught:
        size(circuit, C, between=("0.5", "5 dm^3/(s bar)"))
    assert caught.value.code == "quantity.no_unit"
    never = size(circuit, C, between=("1e-4 dm^3/(s bar)", "1e-3 dm^3/(s bar)"))
    assert [note.code for note in never.remarks] == ["size.none_known"]
    reversed_ = size(circuit, "tank.volume", between=("50 l", "90 l"))
    assert [note.code for note in reversed_.remarks] == ["size.none_lower"]


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"free": "fill.sonic_conductanc"}, "names.unknown"),
        ({"meet": ["quick"]}, "names.unknown"),
        ({"between": ("2 l", "1 l"), "free": "tank.volume"}, "size.range"),
        ({"between": ("-1 l", "1 l"), "free": "tank.volume"}, "size.range"),
        ({"share": 1.5}, "fields.out_of_range"),
        ({"requirements": {}}, "size.no_requirement"),
        ({"free": "tank.wall_conductance"}, "size.no_range"),
        ({"share": 0.9, "runs": 2**20}, "size.too_many"),
    ],
)
def test_invalid_arguments_are_rejected(change: dict, code: str) -> None:
    circuit = loads(CHARGE.replace("THERMAL", "energy"))
    with refused(code):
        size(circuit, **{"free": C, **change})


LIFT = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.fill]
kind = "orifice"
from = "supply"
to = "cylinder.cap"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[parts.cylinder]
kind = "cylinder"
bore = "21 mm"
stroke_length = "100 mm"
acting = "single"
body = "slide"
spring = { rate = "2 N/mm" }
[parts.cylinder.cap]
dead_volume = "20 cm^3"
[parts.slide]
kind = "mass"
mass = "10 kg"
inclination = "90 deg"
friction = { kind = "viscous", viscous_coefficient = "2 kN s/m" }
[run]
duration = "20 s"
output_step = "0.1 s"
[ensemble]
runs = 6
[ensemble.parameters]
"cylinder.bore" = { distribution = "normal", relative_sigma = 0.02 }
[ensemble.metrics]
way = { of = "slide.position", metric = "final" }
[requirements]
lifts = "way > 50 mm"
"""


def test_median_of_zero_is_rejected() -> None:
    numbers = {"slide.load_force": {"distribution": "normal", "mean": "0 N", "sigma": "1 N"}}
    with refused("size.about_zero", "slide.load_force"):
        size(loads(LIFT), "slide.load_force", share=0.5, between=("1 N", "50 N"), parameters=numbers)


def test_bore_of_a_cylinder() -> None:
    """A parameter of a compound part is a valid address: p A balances the weight and the spring at 50 mm."""
    sizing = size(loads(LIFT), "cylinder.bore", between=("15 mm", "40 mm"))
    force = 10.0 * 9.80665 + 2e3 * 0.05
    assert sizing.value == pytest.approx(2.0 * math.sqrt(force / (6e5 * math.pi)), rel=1e-3)


def test_runs_with_compound_parameters_equal_single_runs(tmp_path) -> None:
    circuit = loads(LIFT)
    rows = circuit.ensemble(tmp_path / "lift").to_pandas()
    single_runs = [circuit.with_values({"cylinder.bore": bore}).simulate() for bore in rows["cylinder.bore"]]
    assert rows["way"].tolist() == pytest.approx([run["slide.position"][-1] for run in single_runs], rel=1e-6)
    assert rows["way"].std() > 1e-3


def test_inherited_parameter_of_a_member_is_rejected() -> None:
    """A piston with a bore different from that of its chambers would violate energy conservation."""
    with refused("names.unknown", "cylinder.piston.bore"):
        size(loads(LIFT), "cylinder.piston.bore", between=("15 mm", "40 mm"))
    with refused("names.unknown", "free.cylinder.piston.bore"):
        read_free("cylinder.piston.bore", {}, loads(LIFT))
