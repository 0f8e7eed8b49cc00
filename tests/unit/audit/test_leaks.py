"""Leak survey: numbers of the unit tests of AMO-Tools-Suite (ORNL), in their units, and its limits."""

from __future__ import annotations

import math

import pytest

from poppet.audit.leaks import PlantLeak, bag_flow, decibel_flow, orifice_flow, survey_leaks
from poppet.audit.tariff import read_tariff
from poppet.core.errors import OutOfRangeError
from poppet.core.toml import toml_text
from refusals import refused

INCH, CUBIC_FOOT = 0.0254, 0.3048**3
CFM, PSI = CUBIC_FOOT / 60.0, 0.45359237 * 9.80665 / 0.0254**2
TABLE = {"pressures": (150.0, 125.0), "levels": (20.0, 30.0), "flows": ((1.04, 1.2), (1.85, 1.65))}
ORIFICE = {"temperature": (550.0 + 459.67) / 1.8, "discharge_coefficient": 1.0, "ambient_pressure": 14.7 * PSI}
# hours, flow of one leak [m^3/s], count; kWh, cost, cfm and cubic feet per year as the test of the suite has them
CASES = {
    "estimate, 8640 h": (8640, 0.1 * CFM, 1, 138.24, 16.5888, 0.1, 51840.0),
    "estimate, 3840 h": (3840, 0.1 * CFM, 1, 61.44, 7.3728, 0.1, 23040.0),
    "estimate, 8760 h": (8760, 100.0 * CFM, 1, 140160.0, 16819.2, 100.0, 52560000.0),
    "decibel": (8640, decibel_flow(130.0, 25.0, **TABLE) * CFM, 1, 1975.4496, 237.053952, 1.429, 740793.6),
    "bag": (8640, bag_flow(10 * INCH, 15 * INCH, 12.0), 2, 9424.7779607694, 1130.9733552923, 6.8176923906,
            3534291.73528),
    "orifice": (8640, orifice_flow(0.375 * INCH, 114.7 * PSI, **ORIFICE), 4, 1790380.8424647334, 214845.701095768,
                1295.1250307181, 671392815.9242750406),
}  # fmt: skip


def tariff(hours: int, **fields: object):
    specific_energy = f"{0.16 / CFM / 3600.0!r} kWh/m^3"  # 0.16 kW per cfm
    return read_tariff({"tariff": "0.12 USD/kWh", "specific_energy": specific_energy, "hours": f"{hours} h", **fields})


@pytest.mark.parametrize("case", CASES)
def test_numbers_of_amo_tools(case):
    hours, flow, count, *expected = CASES[case]
    total = survey_leaks([PlantLeak(case, flow, count)], tariff(hours)).total
    results = total.electricity / 3.6e6, total.cost, total.flow / CFM, total.volume / CUBIC_FOOT
    assert results == pytest.approx(expected, rel=1e-9)


def test_a_price_of_air_needs_no_electricity():
    """The flow-meter case of the suite: 200 cfm in 8640 h at 0.12 per cubic foot."""
    price = read_tariff({"tariff": f"{0.12 / CUBIC_FOOT!r} USD/m^3", "hours": "8640 h"})
    assert survey_leaks([PlantLeak("all", 200.0 * CFM)], price).total.cost == pytest.approx(12441600.0, rel=1e-9)


def test_the_choked_nozzle_is_that_of_gas_dynamics():
    """Mass flow C_d A p sqrt(k/(R T)) (2/(k + 1))^((k + 1)/(2(k - 1))), divided by the density p_a/(R T)."""
    k, r, t, p, pa, d = 1.4, 287.0, 300.0, 8e5, 1e5, 2e-3
    mass_flow = 0.6 * math.pi / 4.0 * d**2 * p * math.sqrt(k / (r * t)) * (2.0 / (k + 1.0)) ** ((k + 1) / (2 * (k - 1)))
    flow = orifice_flow(d, p, temperature=t, discharge_coefficient=0.6, ambient_pressure=pa, gas_constant=r)
    assert flow == pytest.approx(mass_flow * r * t / pa, rel=1e-12)


def test_the_survey_sorts_and_sums():
    leaks = [PlantLeak("small", 1e-5, 3), PlantLeak("large", 1e-3)]
    survey = survey_leaks(leaks, tariff(4000, emission="0.4 kg/kWh"), title="Hall", control_fraction=0.25)
    assert [row.leak.name for row in survey.leaks] == ["large", "small"]
    for name in ("flow", "volume", "electricity", "cost", "co2", "saved_cost"):
        assert getattr(survey.total, name) == pytest.approx(sum(getattr(row, name) for row in survey.leaks), rel=1e-14)
    assert survey.total.saved_cost == pytest.approx(0.25 * survey.total.cost, rel=1e-14)
    assert survey.total.co2 == pytest.approx(survey.total.electricity / 3.6e6 * 0.4, rel=1e-14)


def test_without_a_price_the_file_has_no_cost():
    content = survey_leaks([PlantLeak("a", 1e-4)], read_tariff({})).content()
    assert content["total"]["cost_per_year"] is None
    assert "cost" not in toml_text(content)
    assert content["total"]["air_m3_anr_per_year"] == pytest.approx(1e-4 * 4000 * 3600)


@pytest.mark.parametrize(
    ("measured", "code", "address"),
    [((160.0, 25.0), "leaks.outside_table", "pressure"), ((130.0, 31.0), "leaks.outside_table", "level")],
)
def test_the_table_of_the_detector_is_not_extrapolated(measured, code, address):
    with refused(code, address):
        decibel_flow(*measured, **TABLE)


def test_errors_of_the_table_have_units():
    with pytest.raises(OutOfRangeError, match=r"pressure = 10 bar must be between .* 6 bar and 8 bar"):
        decibel_flow(10.0, 25.0, **{**TABLE, "pressures": (6.0, 8.0)}, pressure_unit="bar")
    with pytest.raises(OutOfRangeError, match=r"level = 31 dB must be between .* 20 dB and 30 dB"):
        decibel_flow(130.0, 31.0, **TABLE)


def test_a_table_needs_two_different_values():
    with refused("leaks.equal_values", "levels"):
        decibel_flow(130.0, 20.0, **{**TABLE, "levels": (20.0, 20.0)})


def test_flow_below_the_critical_pressure_is_rejected():
    with refused("leaks.not_choked", "pressure"):
        orifice_flow(1e-3, 1.5e5, temperature=293.15, discharge_coefficient=1.0, ambient_pressure=1e5)


@pytest.mark.parametrize(("arguments", "name"), [((0.0, 1.0, 1.0), "diameter"), ((1.0, 1.0, math.inf), "fill_time")])
def test_sizes_are_above_zero(arguments, name):
    with refused("leaks.not_positive", name):
        bag_flow(*arguments)


def test_the_fraction_of_the_control_is_a_fraction():
    with refused("leaks.fraction", "control_fraction"):
        survey_leaks([], tariff(4000), control_fraction=25.0)
