"""Tests of `poppet size`."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from poppet.iso6358 import nominal_flow_from_conductance
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
    flow = re.search(r"; nominal flow ([\d.]+) l/min ANR with b = 0.3[;.]", out)
    assert flow is not None
    assert float(flow[1]) == pytest.approx(6e4 * nominal_flow_from_conductance(written["value"], 0.3), rel=1e-3)
    assert "fill &lt; 5 s" in page.read_text()
    assert poppet("size", str(file), "--free", C, "--between", "1e-12 m^3/(s Pa)", "1e-11 m^3/(s Pa)")[0] == 1
    assert poppet("size", str(file), "--free", C, "--between", "1 m", "2 m")[0] == 2


def test_answer_has_the_unit_of_the_question(poppet, tmp_path: Path):
    file = tmp_path / "charge.toml"
    sizes = 'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3', 'nominal_flow = "200 l/min ANR"'
    file.write_text(CHARGE.replace("THERMAL", "isothermal").replace(*sizes))
    flow = nominal_flow_from_conductance(EXACT, 0.3) * 60e3
    out = poppet("size", str(file), "--free", "fill.nominal_flow").out
    shown = re.search(r"Smallest fill.nominal_flow: ([\d.]+) l/min ANR", out)
    assert shown is not None
    assert float(shown[1]) == pytest.approx(flow, rel=1e-3)
    out = poppet("size", str(file), "--free", "fill.nominal_flow", "--between", "1 m^3/h ANR", "20 m^3/h ANR").out
    shown = re.search(r"Smallest fill.nominal_flow: ([\d.]+) m³/h ANR", out)
    assert shown is not None
    assert float(shown[1]) == pytest.approx(flow * 0.06, rel=1e-3)
    assert "nominal flow" not in out.partition(":")[2]
    assert re.search(r"Metrics at this value: fill (4\.99\d*|5) s", out)


def test_catalogue_of_a_template(poppet, tmp_path: Path):
    """The smallest valve of two, its metrics in text and page, and the exit codes."""
    assert poppet("new", "drive-sizing").code == 0
    arguments = ("size", "drive-sizing.toml", "--catalogue", "valve", "--find", "CKD, C < 2.35 dm^3/(s bar)")
    code, out, _ = poppet(*arguments, "-o", "size.toml", "--report", "size.html")
    assert code == 0
    written = tomllib.loads(Path("size.toml").read_text())
    assert written["component"] == "CKD M3GA2R/M4GA2R/M3GD2R/M4GD2R"
    assert "Smallest valve of the catalogue: CKD M3GA2R/M4GA2R/M3GD2R/M4GD2R, C = 2.3 dm³/(s bar)." in out
    assert "CKD M3GA2R/M4GA2R/M3GD2R/M4GD2R" in Path("size.html").read_text(encoding="utf-8")
    assert 'write model = "CKD M3GA2R/M4GA2R/M3GD2R/M4GD2R" in [parts.valve]' in out
    assert poppet(*arguments[:-1], "CKD, C < 1.2 dm^3/(s bar)").code == 1


@pytest.mark.parametrize(
    ("arguments", "codes"),
    [
        ((), ["size.subject"]),
        (("--free", "fill.nominal_flow"), ["size.other_capacity"]),
        (("--free", C, "--find", "5/2"), ["size.not_of_parameter"]),
        (("--catalogue", "fill", "--yield", "90 %", "--size", "1 l"), ["size.not_of_catalogue"] * 2),
        (("--catalogue", "fill", "--free", C), ["cli.usage"]),
    ],
)
def test_contradictory_options(poppet, tmp_path: Path, arguments, codes):
    file = tmp_path / "charge.toml"
    file.write_text(CHARGE.replace("THERMAL", "isothermal"))
    answer = poppet("size", str(file), *arguments)
    assert (answer.code, answer.codes) == (2, codes)
