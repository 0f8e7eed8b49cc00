"""Tests of `poppet size`."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from unit.ensemble.test_sizing import CHARGE, EXACT, C


def test_size_prints_and_writes_its_result(poppet, tmp_path: Path):
    file = tmp_path / "charge.toml"
    file.write_text(CHARGE.replace("THERMAL", "isothermal"))
    result, page = tmp_path / "size.toml", tmp_path / "size.html"
    arguments = ("size", str(file), "--free", C, "--yield", "90 %", "--size", "0.5 dm^3/(s bar)")
    code, out, _ = poppet(*arguments, "-o", str(result), "--report", str(page))
    assert code == 0
    written = tomllib.loads(result.read_text())
    assert written["value"] == pytest.approx(EXACT * 1.0256, rel=3e-3)
    assert "0.5 dm³/(s bar)" in out
    assert "fill &lt; 5 s" in page.read_text()
    assert poppet("size", str(file), "--free", C, "--between", "1e-12 m^3/(s Pa)", "1e-11 m^3/(s Pa)")[0] == 1
    assert poppet("size", str(file), "--free", C, "--between", "1 m", "2 m")[0] == 2
