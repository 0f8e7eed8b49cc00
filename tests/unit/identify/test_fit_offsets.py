"""Free sensor offsets in fit files and in `Circuit.fit`: forms of the field, priors, bounds, invalid input."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Recording
from poppet.identify import Result, identify_fit, read_fit_file
from poppet.identify.free_parameter import NormalPrior
from refusals import refused

VALVE, OFFSET = "valve.sonic_conductance", "a.tank.pressure.offset"
START = {"tank.initial_pressure": "free"}
BENCH = """
[parts.tank]
kind = "chamber"
volume = "5 l"
initial_pressure = "7 bar"
thermal = "isothermal"
[parts.valve]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
"""


def tank() -> Circuit:
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    return Circuit({"tank": Chamber(volume="5 l", initial_pressure="7 bar", thermal="isothermal"), "valve": valve})


@cache
def measured(offset: float) -> Recording:
    run = tank().simulate(duration="12 s", output_step="0.1 s")
    noise = np.random.default_rng(10).normal(0.0, 300.0, run.time.size)
    return Recording.from_series(run.time, {"tank.pressure [Pa]": run["tank.pressure"] + noise + offset})


def fit(offset: Any, true_offset: float = 2e3, **arguments: Any) -> Result:
    settings = {"start": START, "noise": {"tank.pressure": 300.0}} | arguments
    return tank().fit({"a": measured(true_offset)}, [VALVE], offsets={"tank.pressure": offset}, **settings)


def write_fit(folder: Path, field: str, start: str = "free") -> Path:
    (folder / "bench.toml").write_text(BENCH)
    recording = measured(2e3)
    table = np.column_stack([recording.time, recording["tank.pressure"]])
    np.savetxt(folder / "a.csv", table, delimiter=",", header="time,p", comments="")
    (folder / "fit.toml").write_text(
        f'circuit = "bench.toml"\n[recordings.a]\nfile = "a.csv"\nstart = {{ "tank.initial_pressure" = "{start}" }}\n'
        f'"tank.pressure" = {{ column = "p", unit = "Pa", noise = "300 Pa"{field} }}\n[free]\n"{VALVE}" = 1e-8\n'
    )
    return folder / "fit.toml"


@pytest.mark.parametrize(
    ("field", "argument", "prior"),
    [
        (', offset = "2 kPa"', "2 kPa", NormalPrior(0.0, 2e3)),
        (', offset = { mean = "1 kPa", sd = "2 kPa" }', ("1 kPa", "2 kPa"), NormalPrior(1e3, 2e3)),
        (', offset = { sd = "20 mbar" }', {"sd": 2e3}, NormalPrior(0.0, 2e3)),
        (', offset = "free"', "free", None),
    ],
)
def test_forms_of_an_offset(tmp_path: Path, field: str, argument: Any, prior: NormalPrior | None) -> None:
    path = write_fit(tmp_path, field)
    parameter = read_fit_file(path).free[-1]
    assert (parameter.name, parameter.role, parameter.unit) == (OFFSET, "offset", "Pa")
    assert parameter.prior == prior
    if prior is not None:
        assert parameter.bounds == pytest.approx((prior.mean - 5.0 * prior.sd, prior.mean + 5.0 * prior.sd))
    from_file, result = identify_fit(path).parameters, fit(argument)
    assert from_file[OFFSET].low < 2e3 < from_file[OFFSET].high
    for name, estimate in from_file.items():
        assert result[name].value == pytest.approx(estimate.value, rel=1e-6), name
        assert result[name].standard_error == pytest.approx(estimate.standard_error, rel=1e-5), name


def test_without_the_field_no_offset_is_free(tmp_path: Path) -> None:
    assert [f.name for f in read_fit_file(write_fit(tmp_path, "")).free] == [VALVE, "tank.initial_pressure"]


def test_offset_of_four_standard_deviations_does_not_reach_a_bound() -> None:
    result = fit("1 kPa", true_offset=4e3)
    assert result[OFFSET].verdict != "at bound"
    assert result[VALVE].low < 1e-8 < result[VALVE].high


def test_bootstrap_includes_the_prior_of_an_offset() -> None:
    """A short choked discharge does not determine the offset: its error is that of the prior."""
    recording = measured(2e3)
    short = Recording.from_series(recording.time[:15], {"tank.pressure [Pa]": recording["tank.pressure"][:15]})
    result = tank().fit(
        {"a": short}, [VALVE], start=START, noise={"tank.pressure": 300.0}, offsets={"tank.pressure": 2e3},
        bootstrap=60, kicks=0,
    )  # fmt: skip
    assert result[OFFSET].standard_error == pytest.approx(2e3, rel=0.1)
    facts = next(r.facts for r in result.remarks if (r.code, r.address) == ("finding.bootstrap", OFFSET))
    assert facts["high"] - facts["low"] == pytest.approx(2.0 * 1.96 * 2e3, rel=0.35)


def test_first_sample_with_an_unknown_offset_is_rejected(tmp_path: Path) -> None:
    location = "recordings.a.start.tank.initial_pressure"
    with refused("fit.first_of_offset", location, channel="tank.pressure"):
        read_fit_file(write_fit(tmp_path, ', offset = "1 kPa"', start="first"))
    with refused("fit.first_of_offset", location):
        fit("1 kPa", start={"tank.initial_pressure": "first"})


@pytest.mark.parametrize(
    ("offset", "code"),
    [
        ("-1 kPa", "fields.out_of_range"),
        ((0.0, "-1 kPa"), "fields.out_of_range"),
        ((0.0, 1e3, 2e3), "fit.no_pair"),
        ({"mean": 0.0}, "fields.missing"),
        ({"sd": 1e3, "spread": 1.0}, "fields.unknown"),
        ("often", "quantity.no_number"),
    ],
)
def test_invalid_offsets_are_rejected(offset: Any, code: str) -> None:
    with refused(code):
        fit(offset)
