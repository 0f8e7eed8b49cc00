"""Conversions between C and catalogue numbers: what is assumed is said, mistakes are named."""

from __future__ import annotations

import pytest

from poppet.core.errors import OutOfRangeError
from poppet.core.units import ANR, NORMAL
from poppet.iso6358 import (
    ASSUMED_CRITICAL_RATIO,
    conductance_from_effective_area,
    conductance_from_flow_coefficient_cv,
    conductance_from_flow_coefficient_kv,
    conductance_from_nominal_flow,
    flow_coefficient_cv_from_conductance,
    mass_from_volume_flow_rate,
    nominal_flow_from_conductance,
    nozzle_mass_flow_rate,
    volume_from_mass_flow_rate,
)
from refusals import refused


@pytest.mark.parametrize(
    "convert",
    [
        conductance_from_flow_coefficient_cv,
        conductance_from_flow_coefficient_kv,
        conductance_from_nominal_flow,
    ],
)
def test_assumed_ratio_is_said(convert):
    assumed = convert(0.01)
    assert assumed.critical_ratio_assumed
    assert assumed.critical_ratio == ASSUMED_CRITICAL_RATIO == 0.3
    assert "b = 0.3 is assumed" in assumed.note
    given = convert(0.01, critical_ratio=0.3)
    assert not given.critical_ratio_assumed
    assert "assumed" not in given.note
    assert given.sonic_conductance == assumed.sonic_conductance


def test_effective_area_takes_the_nozzle_s_ratio():
    assumed = conductance_from_effective_area(16e-6)
    assert assumed.critical_ratio_assumed
    assert assumed.critical_ratio == pytest.approx(0.5283, abs=5e-5)
    given = conductance_from_effective_area(16e-6, critical_ratio=0.4)
    assert (given.critical_ratio, given.critical_ratio_assumed) == (0.4, False)
    assert "assumed" not in given.note


def test_note_names_definition_and_atmosphere():
    assert "pneumatic" in conductance_from_flow_coefficient_kv(1.0).note
    assert "liquid" in conductance_from_flow_coefficient_kv(1.0, definition="small_dp").note
    assert "atmosphere of 1.01325 bar" in conductance_from_nominal_flow(0.01).note
    assert "atmosphere of 1 bar" in conductance_from_nominal_flow(0.01, atmosphere=1e5).note


def test_unknown_definition_offers_the_near_one():
    with refused("fields.not_an_option", "definition"):
        flow_coefficient_cv_from_conductance(1e-8, 0.3, definition="pneumatik")  # type: ignore[arg-type]
    with refused("fields.not_an_option", "definition"):
        conductance_from_flow_coefficient_kv(1.0, definition="liquid")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: conductance_from_effective_area(-1e-6), "iso6358.area"),
        (
            lambda: conductance_from_effective_area(1e-6, isentropic_exponent=1.0),
            "iso6358.isentropic_exponent",
        ),
        (lambda: conductance_from_flow_coefficient_cv(-1.0), "iso6358.flow_coefficient"),
        (lambda: conductance_from_flow_coefficient_kv(1.0, critical_ratio=1.0), "iso6358.critical_ratio"),
        (lambda: conductance_from_nominal_flow(-1.0), "iso6358.nominal_flow"),
        (lambda: nominal_flow_from_conductance(1e-8, 0.3, atmosphere=0.0), "iso6358.atmosphere"),
        (lambda: nozzle_mass_flow_rate(-1.0, 1e5, 293.15, effective_area=1e-6), "iso6358.pressure"),
    ],
)
def test_numbers_outside_their_domain(call, message):
    with refused(message, kind=OutOfRangeError):
        call()


def test_mass_survives_the_change_of_atmosphere():
    mass = mass_from_volume_flow_rate(0.01, ANR)
    assert mass == pytest.approx(0.01185)
    assert mass_from_volume_flow_rate(volume_from_mass_flow_rate(mass, NORMAL), NORMAL) == pytest.approx(mass)


def test_nozzle_both_ways():
    area = {"effective_area": 1e-6}
    forward = nozzle_mass_flow_rate(5e5, [1e5, 4e5, 5e5], 293.15, 350.0, **area)
    backward = nozzle_mass_flow_rate([1e5, 4e5, 5e5], 5e5, 350.0, 293.15, **area)
    assert forward.tolist() == pytest.approx((-backward).tolist(), rel=1e-15, abs=0.0)
    assert nozzle_mass_flow_rate(0.0, 0.0, 293.15, **area) == 0.0
