"""The rebuilt DAMADICS actuator against its statics, the definition of Kv, and the meaning of its faults."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_damadics import (
    AMBIENT,
    AREA,
    MASS,
    NOISE,
    PRELOAD,
    SCENARIOS,
    STIFFNESS,
    STROKE,
    Drive,
    Scenario,
    _valve,
    record,
)

STILL = Drive(command=(0.6, 0, 0.01, 0), upstream=(3.5e6, 0, 0.1, 0), downstream=(2.6e6, 0, 0.3, 0))


def test_there_are_27_scenarios():
    counts = {1: 3, 4: 1, 8: 3, 9: 1, 10: 3, 11: 2, 12: 3, 13: 4, 14: 3, 15: 1, 16: 3}
    assert {f: sum(s.fault == f for s in SCENARIOS) for f in counts} == counts
    assert len({s.name for s in SCENARIOS}) == sum(counts.values()) == 27


def test_kv_is_the_flow_of_water_at_one_bar():
    # 120 m^3/h through the open valve at 1 bar and a density of 1000 kg/m^3 (2 bar: cold water has 1000.1).
    flow, _ = _valve(0.0, 2e5, 1e5, 4.0)
    assert flow == pytest.approx(120.0, rel=1e-3)
    assert _valve(0.5, 2e5, 1e5, 4.0)[0] == pytest.approx(flow * np.exp(-2.5), rel=1e-9)


def test_the_forces_balance_at_rest():
    true = record(Scenario(0), 60.0, drive=STILL).true
    x = true["position"][-1]
    plug = (3.5e6 - 2.6e6) / np.interp(x, [0.6, 0.7], [0.67, 0.61]) * np.pi * 0.05**2 / 4
    balance = STIFFNESS * (x * STROKE + PRELOAD) + plug - MASS * 9.81
    # The noise of the command moves the stem by a few micrometres.
    assert AREA * (true["pressure"][-1] - AMBIENT) == pytest.approx(balance, abs=STIFFNESS * 50e-6)
    # The lever of the positioner has an arc sine, and its dead zone is half a per cent wide.
    assert x == pytest.approx(0.5 + np.sin(np.radians(60 * 0.1)), abs=0.006)


def test_the_noise_of_the_transducers():
    healthy = record(Scenario(0), 1500.0, seed=2)
    for name, span in {"P1": 4e6, "P2": 4e6, "T1": 200.0}.items():
        error = (healthy.measured[name] - healthy.true[name])[1:] / span
        assert error.std() == pytest.approx(np.sqrt(2e-6), rel=0.08)
        assert abs(error.mean()) < 5 * NOISE / np.sqrt(error.size)


@pytest.mark.parametrize(("fault", "has_effect"), [(8, False), (14, False), (12, True), (16, True)])
def test_effect_of_faults_on_the_readings(fault, has_effect):
    healthy = record(Scenario(0), 1500.0, seed=3).true
    sign = -1 if fault in (12, 14) else 1
    true = record(Scenario(fault, 0.75 * sign), seed=3).true
    effect = (true["X"] - healthy["X"])[900:].std()
    assert (effect > 10 * NOISE) if has_effect else (effect < 0.5 * NOISE)


def test_a_stop_limits_the_stem():
    true = record(Scenario(1, 0.5), seed=4).true
    assert true["position"][905:].max() == pytest.approx(0.5, abs=1e-9)


def test_a_sensor_that_reads_too_much_moves_the_stem_not_the_reading():
    true = record(Scenario(13, 0.25), 1500.0, seed=5).true
    assert true["X"][950:] == pytest.approx(1.3125 * true["position"][950:])
    healthy = record(Scenario(0), 1500.0, seed=5).true
    assert abs(true["X"] - healthy["X"])[950:].mean() < 0.01 < abs(true["position"] - healthy["position"])[950:].mean()


def test_a_leak_costs_air():
    # At rest, the supply replaces the leak of f9: 0.1 * 2e-6 sqrt(p - p_a) in total, whatever opens.
    true = record(Scenario(9, 1.0, 100.0), 1100.0, drive=STILL).true
    leak = 0.1 * 2e-6 * np.sqrt(true["pressure"] - AMBIENT)
    supply = 2.5e-6 * np.maximum(true["opening"], 0) * np.sqrt(6e5 - (true["pressure"] - AMBIENT))
    vent = 2.5e-6 * np.maximum(-true["opening"], 0) * np.sqrt(true["pressure"] - AMBIENT)
    assert (supply - vent)[1010:].mean() == pytest.approx(leak[1010:].mean(), rel=0.2)
    assert abs((supply - vent)[700:900].mean()) < 0.2 * leak[1010:].mean()


def test_the_same_seed_gives_the_same_noise():
    first, again, other = (record(Scenario(0), 400.0, seed=seed).measured for seed in (6, 6, 7))
    assert (first["X"] == again["X"]).all()
    assert np.std(first["P1"] - other["P1"]) == pytest.approx(np.sqrt(2) * NOISE * 4e6, rel=0.15)
