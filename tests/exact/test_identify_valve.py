"""Fits of parameters of a complete valve with sampled controller to noisy steps."""

from __future__ import annotations

import importlib.util
import re
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

from poppet import loads
from poppet.identify import identify_fit

BENCH = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
preset = "fast"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.tank]
kind = "chamber"
volume = "1 l"
wall_conductance = "1 W/K"
[signals."valve.setpoint"]
kind = "steps"
times = [0, 1, 2]
values = ["3 bar", "5 bar", "2 bar"]
[run]
duration = "3 s"
output_step = "5 ms"
"""
FIT = """
circuit = "bench.toml"
[recordings.steps]
file = "steps.csv"
time = { column = "t", unit = "s" }
"tank.pressure" = { column = "p", unit = "Pa", noise = "500 Pa" }
"valve.pilot_pressure" = { column = "pilot", unit = "Pa", noise = "500 Pa" }
[free]
"valve.pilot.fill.sonic_conductance" = { start = "1e-10 m^3/(s Pa)" }
"valve.pilot.vent.sonic_conductance" = { start = "3.5e-10 m^3/(s Pa)" }
"valve.pilot.volume" = { start = "8 cm^3" }
"valve.main_stage.exhaust_seat.sonic_conductance" = { start = "0.5e-8 m^3/(s Pa)" }
"""


@pytest.mark.slow  # tests/unit/identify/test_experiment.py always tests a smaller controller
@pytest.mark.parametrize("seed", [1, 2])
def test_fit_recovers_parameters_of_pilot_and_main_stage(tmp_path: Path, seed: int) -> None:
    circuit = loads(BENCH)
    run = circuit.simulate()
    noisy = [run[name] + np.random.default_rng([seed, k]).normal(0.0, 500.0, run.time.size)
             for k, name in enumerate(("tank.pressure", "valve.pilot_pressure"))]  # fmt: skip
    np.savetxt(
        tmp_path / "steps.csv", np.column_stack([run.time, *noisy]), delimiter=",", header="t,p,pilot", comments=""
    )
    (tmp_path / "bench.toml").write_text(BENCH)
    (tmp_path / "fit.toml").write_text(FIT)
    result = identify_fit(tmp_path / "fit.toml")
    for address, estimate in result.parameters.items():
        truth = float(circuit.numbers()[address])
        assert estimate.value == pytest.approx(truth, rel=0.015), address
    assert any("a program samples in the circuit" in sentence for sentence in result.findings)
    assert all(residual.nrmse < 0.003 for residual in result.residuals.values())


VALVE = Path(__file__).resolve().parents[2] / "examples" / "identify" / "valve"
PAGE = Path(__file__).resolve().parents[2] / "docs" / "fit_valve.md"


def truth() -> dict[str, float]:
    spec = importlib.util.spec_from_file_location("make_data", VALVE.parent / "make_data.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return dict(module.REGULATOR)


def test_steps_use_the_values_of_earlier_steps():
    """Each parameter in `set` and `start` has the same value in all files."""
    plans = [tomllib.loads((VALVE / name).read_text()) for name in ("1_flow.toml", "2_pilot.toml", "3_loops.toml")]
    last = tomllib.loads((VALVE / "4_all.toml").read_text())
    free = [set(plan["free"]) for plan in plans]
    assert [set(plan.get("set", {})) for plan in plans] == [set(), free[0], free[0] | free[1]]
    start_values = {name: table["start"] for name, table in last["free"].items() if "start" in table}
    assert set(start_values) == free[0] | free[1] | free[2]
    assert set(last["free"]) == set(truth()) == {*start_values, "valve.pilot.volume"}
    for plan in plans:
        assert plan.get("set", {}).items() <= start_values.items()


@pytest.mark.slow
@pytest.mark.parametrize("step", [1, 2, 3, 4])
def test_steps_give_the_results_of_the_page(step: int) -> None:
    section = PAGE.read_text(encoding="utf-8").partition("\n## Steps\n")[2]
    row = next(line for line in section.splitlines() if line.startswith(f"| {step} | "))
    expected_errors = [float(number) for number in re.findall(r"([+-][\d.]+)", row)]
    rms = [float(number) for number in re.findall(r"(\d+) Pa", row)]
    result = identify_fit(next(VALVE.glob(f"{step}_*.toml")))
    true_values = truth()
    errors = [100.0 * (e.value / true_values[name] - 1.0) for name, e in result.parameters.items()]
    order = [0, 1, 2, 4, 5, 3] if step == 4 else range(len(errors))  # the page has the volume last
    assert [errors[k] for k in order] == pytest.approx(expected_errors, abs=1.0)
    assert [summary.rms for summary in result.residuals.values()] == pytest.approx(rms, rel=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("with_pilot", [False, True])
def test_conductance_depends_on_the_fixed_volume(tmp_path: Path, with_pilot: bool) -> None:
    """The fitted conductance depends on the fixed volume, and the residuals are least at the true volume."""
    fill, noise = "valve.pilot.fill.sonic_conductance", 300.0
    lines = (VALVE / "2_pilot.toml").read_text().splitlines()
    text = "\n".join(line for line in lines if with_pilot or not line.startswith('"valve.pilot_pressure"'))
    true_values = {name: value for name, value in truth().items() if not name.startswith("valve.pilot")}
    for name in ("bench.toml", "steps.csv"):
        shutil.copy(VALVE / name, tmp_path)
    head, rest = text[: text.index("[set]")], text[text.index("[recordings") :]
    for volume, change in ((5.0e-6, -0.19), (6.5e-6, 0.0), (8.0e-6, 0.20)):
        fixed_values = "\n".join(
            f'"{name}" = {value!r}' for name, value in {**true_values, "valve.pilot.volume": volume}.items()
        )
        (tmp_path / "fit.toml").write_text(f"{head}[set]\n{fixed_values}\n\n{rest}\n")
        result = identify_fit(tmp_path / "fit.toml")
        assert result.parameters[fill].value == pytest.approx((1.0 + change) * truth()[fill], rel=0.04)
        rms = max(summary.rms for summary in result.residuals.values())
        assert (rms < 1.6 * noise) == (change == 0.0)
