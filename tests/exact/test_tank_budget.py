"""Uncertainty budget of tank tests, with stated quantities that are wrong by random amounts.

The recordings are from an independent simulator.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.stats import binom

from exact.independent_edge_tanks import EdgeTank, simulate
from exact.independent_tanks import AIR, ROOM, Tank, drawn, recorded
from poppet.core.errors import InputError
from poppet.identify import Result, TankTest, identify_tank, read_result
from poppet.report.identification.headline import result_summary

C, B = "valve.sonic_conductance", "valve.critical_ratio"
VOLUME, SUPPLY, SCALE, ZERO = 0.005, 0.003, 0.003, 0.0006
"""Standard uncertainties that the product assumes; that of the zero is a fraction of the range."""
FEW, MANY = 10, 200
COVERED, CHANCE = 0.93, 0.001


def clean(seed: int, **changes: Any) -> Tank:
    """Return a tank test with wall heat, a fine gauge without an offset, and pressure only."""
    fine = {"is_coarse": False, "offset": 0.0, "temperature_noise": None, "noise": 200.0}
    tank = drawn(seed, stream=2402)
    return replace(tank, **{**fine, "wall": max(tank.wall, 5.0), **changes})


def stated_test(tank: Tank, seed: int, errors: Any = (0.0, 0.0, 0.0, 0.0), **changes: Any) -> TankTest:
    """Return the description of a test; the errors are those of volume, supply, gauge scale and gauge zero."""
    record, (volume, supply, scale, zero) = recorded(tank, seed), errors
    pressure = AIR + (record["pressure"] - AIR) * (1.0 + scale) + zero * float(np.ptp(record["pressure"]))
    recording = {"time": record["time"], "tank.pressure": pressure, "closes": tank.closes}
    return TankTest(
        **{
            "recordings": {"test": recording},
            "volume": tank.volume * (1.0 + volume),
            "direction": "charge" if tank.is_charge else "discharge",
            "supply_pressure": tank.outside * (1.0 + supply) if tank.is_charge else None,
            "ambient_pressure": AIR,
            "ambient_temperature": ROOM,
            **changes,
        }
    )


@cache
def pair(seed: int) -> tuple[Tank, Result, Result]:
    """Return a tank and the results with and without the budget, for random errors of the stated quantities."""
    tank = clean(seed)
    errors = np.random.default_rng([2402, 1, seed]).normal(0.0, [VOLUME, SUPPLY, SCALE, ZERO])
    test = stated_test(tank, seed, errors)
    return tank, identify_tank(test), identify_tank(replace(test, uncertainties=0))


def check_coverage(count: int) -> None:
    held = {name: [0, 0, 0] for name in (C, B)}
    for seed in range(count):
        tank, *results = pair(seed)
        for name, truth in ((C, tank.conductance), (B, tank.ratio)):
            with_budget, without = (result.parameters[name] for result in results)
            assert with_budget.value == without.value
            held[name][0] += with_budget.low <= truth <= with_budget.high
            held[name][1] += without.low <= truth <= without.high
            held[name][2] += with_budget.verdict == "determined"
    for name, (covered, noise_only, determined) in held.items():
        print(f"{name}: {covered} of {count} covered with the budget, {noise_only} without; {determined} determined")
        assert covered >= binom.ppf(CHANCE, count, COVERED)
    assert held[C][1] < 0.5 * count


def test_few_intervals_cover_errors_of_stated_quantities() -> None:
    check_coverage(FEW)


@pytest.mark.slow
def test_many_intervals_cover_errors_of_stated_quantities() -> None:
    check_coverage(MANY)


def test_volume_has_share_that_scaling_requires() -> None:
    """C is proportional to the volume, and b does not depend on it."""
    result = identify_tank(stated_test(clean(1), 1, uncertainties={"volume": "1 %", "supply_pressure": 0}))
    budget = result.comparison["uncertainty"]
    estimate = result.parameters[C]
    assert budget[C]["sources"]["volume"] == pytest.approx(0.01 * estimate.value, rel=1e-3)
    assert budget[B]["sources"]["volume"] < 1e-3 * result.parameters[B].standard_error
    for name, row in budget.items():
        total = np.linalg.norm([*row["sources"].values()])
        assert total == pytest.approx(result.parameters[name].standard_error, rel=1e-6)


def test_supply_moves_estimate_by_its_share() -> None:
    """A supply that is wrong by one standard uncertainty changes C by the contribution, if the data do not show it."""
    tank = clean(2, noise=1500.0)
    quiet = dict.fromkeys(("volume", "gauge_scale", "gauge_zero"), 0)
    test = stated_test(tank, 2, uncertainties={**quiet, "supply_pressure": "0.05 %"})
    result = identify_tank(test)
    assert isinstance(test.supply_pressure, float)
    shifted = identify_tank(replace(test, supply_pressure=1.0005 * test.supply_pressure))
    share = result.comparison["uncertainty"][C]["sources"]["supply pressure"]
    assert share == pytest.approx(abs(shifted.parameters[C].value - result.parameters[C].value), rel=0.1)


DISCHARGE = EdgeTank(
    *(False, 20e-3, 7e-8, 0.35, 300.0, 7.5e5, 1e5, 1e5, 293.15, 8.0, 12.0, 600, 200.0),
    leak=0.02 * 7e-8,
)
"""Discharge with a leak of 2 % of C."""


def identify_discharge(tank: EdgeTank, rest: float = 0.0, scale: float = 0.0, **changes: Any) -> Result:
    """Identify a discharge that begins after a rest at constant pressure, of `rest` times its duration.

    `scale` is the relative error of the gauge scale.
    """
    time = np.linspace(0.0, tank.duration, tank.samples)
    count = round(rest * tank.samples)
    pressure = np.append(np.full(count, tank.begin), simulate(tank, time))
    pressure = pressure + np.random.default_rng(2404).normal(0.0, tank.noise, pressure.size)
    pressure = AIR + (pressure - AIR) * (1.0 + scale)
    opens = count * float(time[1])
    times = {"time": time[1] * np.arange(pressure.size), "opens": opens, "closes": opens + tank.closes}
    return identify_tank(
        TankTest(
            recordings={"test": {"tank.pressure": pressure, **times}},
            volume=tank.volume,
            ambient_temperature=tank.temperature,
            **changes,
        )
    )


def test_interval_of_discharge_covers_leak() -> None:
    with_leak, tight = identify_discharge(DISCHARGE), identify_discharge(DISCHARGE, uncertainties={"leak": 0})
    estimate = with_leak.parameters[C]
    assert estimate.verdict == "determined"
    assert estimate.low <= DISCHARGE.conductance <= estimate.high
    assert not tight.parameters[C].low <= DISCHARGE.conductance <= tight.parameters[C].high
    assert estimate.value == tight.parameters[C].value


def test_rest_before_discharge_excludes_leak() -> None:
    tank = replace(DISCHARGE, leak=0.0)
    shares = [
        identify_discharge(tank, rest).comparison["uncertainty"][C]["sources"]["leak"] / tank.conductance
        for rest in (0.0, 0.3)
    ]
    assert shares[0] == pytest.approx(0.015, rel=0.2)
    assert shares[1] < 0.1 * shares[0]


@pytest.mark.parametrize("leak", ["free", 0.02 * 7e-8])
def test_free_or_stated_leak_is_no_source(leak: Any) -> None:
    result = identify_discharge(DISCHARGE, leak_conductance=leak)
    (note,) = (note for note in result.remarks if note.code == "finding.budget")
    assert note.facts["leak"] is None
    assert ("leak" in note.facts["exact"]) == (leak != "free")
    assert not any("leak" in row["sources"] for row in result.comparison["uncertainty"].values())


@pytest.mark.parametrize(("scale", "samples"), [(0.0003, 100), (0.003, 1600), (0.01, 1600)])
def test_contribution_of_gauge_scale_equals_change_of_fits(scale: float, samples: int) -> None:
    """The contribution is proportional to the uncertainty, and does not grow with the number of samples."""
    tank = replace(DISCHARGE, leak=0.0, samples=samples, noise=1500.0)
    sizes = {"volume": 0, "leak": 0, "gauge_scale": scale, "gauge_zero": 0}
    budget = identify_discharge(tank, uncertainties=sizes).comparison["uncertainty"]
    above, below = (identify_discharge(tank, scale=k * scale, uncertainties=0).parameters for k in (1.0, -1.0))
    for name in (C, "tank.initial_pressure"):
        change = 0.5 * abs(above[name].value - below[name].value)
        size = budget[name]["sources"]["gauge scale"]
        print(f"{scale:g}, {samples} samples, {name}: budget {size:.4g}, fits {change:.4g}")
        assert size == pytest.approx(change, rel=0.15)


@pytest.mark.parametrize("leak", [None, 0.0, "0 l/(min bar)", "0 m^3/(s Pa)"])
def test_zero_leak_is_no_measured_leak(leak: Any) -> None:
    result = identify_discharge(DISCHARGE, leak_conductance=leak)
    (note,) = (note for note in result.remarks if note.code == "finding.budget")
    assert note.facts["leak"] == 0.015
    assert "leak" not in note.facts["exact"]


def test_invalid_leak_has_its_own_name() -> None:
    with pytest.raises(InputError) as caught:
        identify_discharge(DISCHARGE, leak_conductance="1 %")
    assert caught.value.address == "leak_conductance"


def test_sizes_of_zero_are_not_shown() -> None:
    sizes = {"volume": 0, "gauge_scale": 0, "leak": 0}
    result = identify_discharge(DISCHARGE, uncertainties={**sizes, "gauge_zero": "100 Pa"})
    (note,) = (note for note in result.remarks if note.code == "finding.budget")
    assert "uncertainties: gauge zero 100 Pa. " in str(note)
    assert note.facts["exact"][:3] == ("volume", "leak", "gauge scale")
    result = identify_discharge(DISCHARGE, uncertainties={**sizes, "gauge_zero": 0, "leak": "1 %"})
    (note,) = (note for note in result.remarks if note.code == "finding.budget")
    assert "uncertainties: leak 1 % of C. " in str(note)


def test_budget_is_always_shown(tmp_path: Any) -> None:
    _, result, without = pair(0)
    (note,) = (note for note in result.remarks if note.code == "finding.budget")
    assert sum(note.facts["shares"].values()) == pytest.approx(1.0)
    assert set(note.facts["assumed"]) == {"volume", "supply pressure", "leak", "gauge scale", "gauge zero"}
    assert str(note) in result_summary(result, 0)
    (exact,) = (note for note in without.remarks if note.code in ("finding.budget", "finding.exact"))
    assert exact.code == "finding.exact"
    assert str(exact) in result_summary(without, 0)
    assert exact.facts["exact"][0] == "volume"
    result.save(tmp_path / "result.toml")
    assert read_result(tmp_path / "result.toml").comparison["uncertainty"] == result.comparison["uncertainty"]


def test_absolute_values_equal_fractions() -> None:
    tank = clean(0)
    fractions = identify_tank(stated_test(tank, 0, uncertainties={"volume": "0.2 %", "supply_pressure": 0.001}))
    sizes = {"volume": 0.002 * tank.volume * 1e3, "supply_pressure": 0.001 * tank.outside}
    texts = {"volume": f"{sizes['volume']!r} l", "supply_pressure": f"{sizes['supply_pressure']!r} Pa"}
    absolute = identify_tank(stated_test(tank, 0, uncertainties=texts))
    assert absolute.parameters[C].high == pytest.approx(fractions.parameters[C].high, rel=1e-9)


@pytest.mark.parametrize(
    ("uncertainties", "code", "address"),
    [
        ({"volumes": "1 %"}, "fields.unknown", "uncertainties.volumes"),
        ({"volume": "-1 %"}, "fields.out_of_range", "uncertainties.volume"),
        ({"leak": "-1 %"}, "fields.out_of_range", "uncertainties.leak"),
        ({"leak": "1e-10 m^3/(s Pa)"}, "quantity.other_quantity", "uncertainties.leak"),
        ({"gauge_scale": "60 %"}, "fields.out_of_range", "uncertainties.gauge_scale"),
        ({"gauge_zero": "1 K"}, "quantity.other_quantity", "uncertainties.gauge_zero"),
    ],
)
def test_invalid_uncertainties_are_rejected(uncertainties: dict[str, Any], code: str, address: str) -> None:
    with pytest.raises(InputError) as caught:
        identify_tank(stated_test(clean(1), 1, uncertainties=uncertainties))
    assert (caught.value.code, caught.value.address) == (code, address)


def test_ratio_above_ideal_nozzle_is_reported() -> None:
    codes = [note.code for note in identify_tank(stated_test(clean(1, ratio=0.6), 1)).remarks]
    assert codes.count("finding.unusual.ratio") == 1
    assert "finding.unusual.ratio" not in {
        note.code for note in identify_tank(stated_test(clean(1, ratio=0.4), 1)).remarks
    }
