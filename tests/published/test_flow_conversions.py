"""Worked numbers of catalogues, standards and the literature."""

from __future__ import annotations

import pytest

from poppet.core.units import ANR, NORMAL
from poppet.iso6358 import (
    conductance_from_effective_area,
    conductance_from_flow_coefficient_cv,
    conductance_from_nominal_flow,
    flow_coefficient_kv_from_conductance,
    mass_flow_rate,
    mass_from_volume_flow_rate,
    nominal_flow_from_conductance,
    nozzle_critical_ratio,
    parallel,
    series,
    tube,
    volume_from_mass_flow_rate,
)

LITRES_PER_MINUTE = 1e-3 / 60.0
DM3_PER_S_BAR = 1e-8


def test_catalogue_example_from_four_to_three_bar_gauge():
    """C = 2 dm3/(s bar), b = 0.3, 20 degC, atmosphere 1.0 bar: 420 l/min; choked 600 l/min."""
    valve = {"sonic_conductance": 2.0 * DM3_PER_S_BAR, "critical_ratio": 0.3}
    subsonic = volume_from_mass_flow_rate(mass_flow_rate(5e5, 4e5, 293.15, **valve)) / LITRES_PER_MINUTE
    choked = volume_from_mass_flow_rate(mass_flow_rate(5e5, 1e5, 293.15, **valve)) / LITRES_PER_MINUTE
    assert subsonic == pytest.approx(419.91, abs=5e-3)
    assert choked == pytest.approx(600.0, rel=1e-12)


def test_effective_area():
    given = conductance_from_effective_area(1e-6)
    assert given.sonic_conductance / DM3_PER_S_BAR == pytest.approx(0.1992, abs=5e-5)
    assert given.critical_ratio == nozzle_critical_ratio() == pytest.approx(0.5283, abs=5e-5)


@pytest.mark.parametrize(("ratio", "printed"), [(0.2, 4.23), (0.3, 3.96), (0.4, 3.66), (0.5, 3.34)])
def test_pneumatic_cv(ratio, printed):
    given = conductance_from_flow_coefficient_cv(1.0, critical_ratio=ratio)
    assert given.sonic_conductance / DM3_PER_S_BAR == pytest.approx(printed, abs=5e-3)
    assert given.sonic_conductance / DM3_PER_S_BAR == pytest.approx(4.73 * (1.0 - ratio) ** 0.5, rel=1e-3)


def test_pneumatic_cv_is_its_own_formula_at_small_drops():
    """Q = 114.5 Cv sqrt(dp p2/T1), Q in dm3/s ANR, pressures in bar, at dp = 1e-3 bar."""
    given = conductance_from_flow_coefficient_cv(0.7, critical_ratio=0.35)
    mass_flow = mass_flow_rate(
        6.001e5,
        6e5,
        310.0,
        sonic_conductance=given.sonic_conductance,
        critical_ratio=given.critical_ratio,
        laminar_ratio=1.0 - 1e-5,
    )
    printed = 114.5 * 0.7 * (1e-3 * 6.0 / 310.0) ** 0.5
    assert volume_from_mass_flow_rate(mass_flow) * 1e3 == pytest.approx(printed, rel=3e-4)


def test_liquid_cv_is_the_liquid_law_at_small_drops():
    """Kv m3/h at 1 bar and 1000 kg/m3, applied to air of constant density at dp = 1e-3 bar."""
    given = conductance_from_flow_coefficient_cv(1.0, critical_ratio=0.35, definition="small_dp")
    mass_flow = mass_flow_rate(
        6.001e5,
        6e5,
        310.0,
        sonic_conductance=given.sonic_conductance,
        critical_ratio=given.critical_ratio,
        laminar_ratio=1.0 - 1e-5,
    )
    density = 6e5 / (287.05 * 310.0)
    volume_flow = 0.865 / 3600.0 * (1e-3 * 1000.0 / density) ** 0.5
    assert mass_flow == pytest.approx(density * volume_flow, rel=3e-4)


def test_the_two_definitions_differ_by_four_and_a_half_percent():
    pneumatic = conductance_from_flow_coefficient_cv(1.0, critical_ratio=0.0).sonic_conductance
    liquid = conductance_from_flow_coefficient_cv(1.0, critical_ratio=0.0, definition="small_dp")
    assert pneumatic / DM3_PER_S_BAR == pytest.approx(4.73, abs=5e-3)
    assert liquid.sonic_conductance / DM3_PER_S_BAR == pytest.approx(4.94, abs=5e-3)
    assert liquid.sonic_conductance / pneumatic - 1.0 == pytest.approx(0.045, abs=1e-3)


def test_kv_per_cv():
    given = conductance_from_flow_coefficient_cv(1.0, critical_ratio=0.3)
    kv = flow_coefficient_kv_from_conductance(given.sonic_conductance, 0.3)
    assert kv == pytest.approx(0.865, rel=1e-12)
    # from the definitions: US gallon 3.785411784 l, psi 6894.757 Pa
    assert kv == pytest.approx(3.785411784e-3 * 60.0 / 0.06894757**0.5, rel=1e-4)


@pytest.mark.parametrize(("ratio", "printed"), [(0.2, 240.0), (0.3, 255.0), (0.4, 272.0), (0.5, 294.0)])
def test_nominal_flow_per_conductance(ratio, printed):
    """l/min ANR per dm3/(s bar), 6 to 5 bar gauge, atmosphere 1.01325 bar."""
    found = nominal_flow_from_conductance(DM3_PER_S_BAR, ratio) / LITRES_PER_MINUTE
    assert found == pytest.approx(printed, abs=0.7)


def test_nominal_flow_with_an_atmosphere_of_one_bar():
    found = nominal_flow_from_conductance(DM3_PER_S_BAR, 0.3, atmosphere=1e5) / LITRES_PER_MINUTE
    assert found == pytest.approx(254.3, abs=0.05)


def test_nominal_flow_of_380_litres_assumes_a_ratio_aloud():
    given = conductance_from_nominal_flow(380.0 * LITRES_PER_MINUTE)
    assert given.sonic_conductance / DM3_PER_S_BAR == pytest.approx(380.0 / 254.5, rel=1e-3)
    assert (given.critical_ratio, given.critical_ratio_assumed) == (0.3, True)


def test_reference_to_normal_atmosphere():
    mass_flow = mass_from_volume_flow_rate(1.0, ANR)
    assert mass_flow == 1.185
    assert volume_from_mass_flow_rate(mass_flow, NORMAL) == pytest.approx(0.9196, abs=5e-5)


def test_series_of_the_paper_s_valve_and_a_silencer():
    conductance, ratio = series(1.65e-8, 0.43, 3e-8, 0.3)
    assert (conductance * 1e8, ratio) == pytest.approx((1.6191, 0.247), abs=5e-4)
    conductance, ratio = series(3e-8, 0.3, 1.65e-8, 0.43)
    assert (conductance * 1e8, ratio) == pytest.approx((1.4961, 0.357), abs=5e-4)
    shortcut = (1.65**-2 + 3.0**-2) ** -0.5
    assert 0.01 < 1.0 - shortcut / 1.4961 < 1.0 - shortcut / 1.6191 < 0.115


def test_parallel():
    conductance, ratio = parallel(1e-8, 0.2, 2e-8, 0.5)
    assert conductance == pytest.approx(3e-8, rel=1e-15)
    assert ratio == pytest.approx(0.4221, abs=5e-5)


def test_tube_of_four_millimetres():
    conductance, ratio = tube(1.0, 4e-3)
    assert conductance == pytest.approx(1.196e-8, abs=5e-12)
    assert ratio == pytest.approx(0.354, abs=5e-4)
