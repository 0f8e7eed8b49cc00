"""Files of baselines: round trip, changes that keep a baseline valid, and errors of files that do not belong."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import load
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.monitoring.baseline import Baseline, ChannelMisfit, fixed_parameters, read_baseline
from poppet.monitoring.plan import WatchPlan, read_plan
from watched_tank import TABLES, TANK, plan_of_tank, watched_tank


def baseline_of(plan: WatchPlan) -> Baseline:
    values = plan.reference * 1.01 + 1e-12
    note = Note("baseline.outliers", "tank.pressure", fraction=0.02)
    return Baseline(
        plan, values, 0.1 * plan.prior, (ChannelMisfit(1.2, 4.0, 500.0),), 1.3, 1.1, 600.0, 6000, "healthy.csv", (note,)
    )


@pytest.fixture
def path(tmp_path: Path) -> Path:
    baseline_of(plan_of_tank()).save(tmp_path / "healthy.toml")
    return tmp_path / "healthy.toml"


def problems(path: Path, plan: WatchPlan) -> dict[str, InputError]:
    with pytest.raises(InputError) as error:
        read_baseline(path, plan)
    return {problem.code: problem for problem in error.value.problems}


def edited(path: Path, old: str, new: str) -> Path:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    return path


def with_tables(**changes: Any) -> WatchPlan:
    return plan_of_tank(**{name: {**TABLES[name], **table} for name, table in changes.items()})


def test_a_file_restores_the_baseline(path: Path) -> None:
    plan = plan_of_tank()
    written, read = baseline_of(plan), read_baseline(path, plan)
    assert read.values.tolist() == written.values.tolist()
    assert read.sigmas.tolist() == written.sigmas.tolist()
    for name in ("misfit", "temper", "healthy_nis", "duration", "readings", "recording", "remarks"):
        assert getattr(read, name) == getattr(written, name)
    assert 'source = "fitted"' in path.read_text()


def test_the_misfit_increases_the_noise() -> None:
    baseline = baseline_of(plan_of_tank())
    # 1.2 times the noise, and a quarter of the independent readings.
    assert baseline.noise.tolist() == pytest.approx([500.0 * 1.2 * 2.0])
    assert ChannelMisfit(0.5, 1.0).factor == 1.0


@pytest.mark.parametrize(("stated", "effective"), [("0.5 mbar", 1200.0), ("5 mbar", 1200.0), ("50 mbar", 5000.0)])
def test_another_stated_noise_does_not_change_the_lack_of_fit(path: Path, stated: str, effective: float) -> None:
    plan = with_tables(measured={"tank.pressure": {**TABLES["measured"]["tank.pressure"], "noise": stated}})
    assert read_baseline(path, plan).noise.tolist() == pytest.approx([effective])


def test_the_circuit_itself_can_be_the_baseline() -> None:
    plan = plan_of_tank()
    baseline = Baseline.of_circuit(plan)
    assert baseline.values.tolist() == plan.reference.tolist()
    assert baseline.noise.tolist() == pytest.approx([500.0])
    assert baseline.faults.shape == (2,)


def test_noise_alarm_sizes_and_settings_can_change(path: Path) -> None:
    plan = with_tables(
        measured={"tank.pressure": {"column": "q", "unit": "mbar g", "noise": "8 mbar", "offset": "1 mbar"}},
        faults={"leak": {**TABLES["faults"]["leak"], "alarm": "3e-10 m^3/(s Pa)", "direction": "both"}},
        settings={"window": "90 s", "alarm_delay": "5 s"},
    )
    # The lack of fit of the healthy recording, which had a noise of 5 mbar.
    assert read_baseline(path, plan).noise.tolist() == pytest.approx([500.0 * 1.2 * 2.0])


def test_initial_values_and_free_parameters_can_change(path: Path) -> None:
    text = TANK.replace('initial_pressure = "5 bar"', 'initial_pressure = "3 bar"').replace(
        'pressure = "7 bar"', 'pressure = "7.2 bar"'
    )
    plan = plan_of_tank(watched_tank(text))
    assert np.all(read_baseline(path, plan).values == baseline_of(plan_of_tank()).values)


def test_a_missing_file_is_to_be_commissioned(tmp_path: Path) -> None:
    assert [*problems(tmp_path / "none.toml", plan_of_tank())] == ["baseline.no_file"]


def test_another_file_is_no_baseline(tmp_path: Path) -> None:
    (tmp_path / "tank.toml").write_text(TANK)
    assert [*problems(tmp_path / "tank.toml", plan_of_tank())] == ["baseline.other_kind"]


def test_another_volume_is_another_plant(path: Path) -> None:
    found = problems(path, plan_of_tank(watched_tank(TANK.replace("10 l", "12 l"))))
    assert [*found] == ["baseline.other_values"]
    assert found["baseline.other_values"].facts["changed"] == ["tank.volume 0.01 -> 0.012"]


def test_another_delay_of_an_input_is_another_plant() -> None:
    circuit = load(Path(__file__).parents[3] / "examples/cylinder_cushioned.toml")
    plans = [
        read_plan(
            circuit.with_values({"valve.delay": delay}),
            {"slide.position": {"noise": "0.1 mm"}, "valve.command": {}},
            {"supply_low": {"address": "supply.pressure", "alarm": "0.3 bar"}},
        )
        for delay in ("10 ms", "50 ms")
    ]
    first, second = map(fixed_parameters, plans)
    assert {name for name in first if first[name] != second[name]} == {"valve.delay"}


def test_another_structure_is_another_plant(path: Path) -> None:
    text = TANK.replace('thermal = "energy"', 'thermal = "isothermal"').replace('wall_conductance = "2 W/K"\n', "")
    assert [*problems(path, plan_of_tank(watched_tank(text)))] == ["baseline.other_circuit"]


def test_all_differences_from_the_twin_file_are_reported(path: Path) -> None:
    plan = with_tables(
        measured={
            "tank.pressure": {"column": "p", "unit": "bar", "noise": "5 mbar", "offset": "2 mbar"},
            "tank.temperature": {"column": "T", "unit": "degC", "noise": "0.5 K"},
            "valve.opening": {"column": "v", "unit": "%"},
        },
        nuisances={"tank.wall_conductance": {"relative_sigma": 0.2}},
    )
    with pytest.raises(InputError) as error:
        read_baseline(path, plan)
    missing = [p.facts["missing"] for p in error.value.problems if p.code == "baseline.other_names"]
    assert sorted(missing) == [["tank.temperature"], ["tank.wall_conductance"], ["valve.opening"]]
    assert "baseline.other_gauge" in [problem.code for problem in error.value.problems]
    assert all(problem.line for problem in error.value.problems)


def test_a_fault_with_another_address_is_another_number(path: Path) -> None:
    plan = with_tables(faults={"leak": {"address": "consumer.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)"}})
    assert "baseline.other_number" in problems(path, plan)


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("temper = 1.3", "temper = 0.5", "fields.out_of_range"),
        ("temper = 1.3", "tempo = 1.3", "fields.unknown"),
        ("duration = 600.0", "duration = -1", "fields.out_of_range"),
        ("healthy_nis = 1.1\n", "", "fields.missing"),
        ("[commissioning]", "[commission]", "fields.unknown"),
        ("correlation_time = 4.0", "correlation_time = nan", "quantity.not_finite"),
        ('source = "fitted"', 'source = "fitted"\nvalues = 2', "fields.unknown"),
        ("sensors.", "sensor.", "fields.unknown"),
    ],
)
def test_errors_of_a_file_have_their_line(path: Path, old: str, new: str, code: str) -> None:
    found = problems(edited(path, old, new), plan_of_tank())
    assert code in found
    assert found[code].file == str(path)


@pytest.mark.parametrize(
    ("key", "value", "code"),
    [
        ("value", "nan", "fields.other_type"),
        ("value", '"2 bar"', "fields.other_type"),
        ("sigma", "-1.0", "fields.out_of_range"),
    ],
)
def test_an_impossible_number_is_rejected(path: Path, key: str, value: str, code: str) -> None:
    line = next(line for line in path.read_text().splitlines() if line.startswith(key))
    assert [*problems(edited(path, line, f"{key} = {value}"), plan_of_tank())] == [code]


def test_no_value_of_a_file_is_lost_by_rounding(path: Path) -> None:
    plan = plan_of_tank()
    again = path.with_name("again.toml")
    read_baseline(path, plan).save(again)
    assert again.read_text() == path.read_text()
    assert math.isfinite(float(read_baseline(again, plan).values.sum()))
