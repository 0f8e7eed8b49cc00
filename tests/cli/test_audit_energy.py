"""Tests of `poppet audit energy`."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from unit.audit.test_energy import MACHINE


def test_the_command_writes_its_result(poppet, tmp_path: Path):
    file, output = tmp_path / "machine.toml", tmp_path / "result.toml"
    file.write_text(MACHINE)
    code, out, _ = poppet("audit", "energy", str(file), "-o", str(output))
    assert code == 0
    content = tomllib.loads(output.read_text())
    cycle = content["cycle"]
    assert {"duration_s", "air_l_anr", "exergy_supplied_j", "work_j"} <= cycle.keys()
    assert cycle["duration_s"] == 1.0
    assert sum(row["air_l_anr"] for row in content["parts"]) == pytest.approx(cycle["air_l_anr"], rel=1e-9)
    assert "supplied exergy" in out
    assert abs(cycle["exergy_residual"]) < 1e-9
    code, _, errors = poppet("audit", "energy", str(file), "--cycle", "3 s, 9 s")
    assert code == 2
    assert "after the end of the run" in errors


def test_the_tariff_and_its_assumptions_are_printed(poppet, tmp_path: Path):
    file = tmp_path / "machine.toml"
    file.write_text(MACHINE)
    out = poppet("audit", "energy", str(file), "--no-savings", "--tariff", "0.20 EUR/kWh").out
    rows = {line[: line.find("  ")]: line for line in out.splitlines()}
    assert "assumed" in rows["specific energy"]
    assert "assumed" in rows["hours"]
    assert "0.20 EUR/kWh" in rows["tariff"]
    assert "specific energy" not in poppet("audit", "energy", str(file), "--no-savings").out
