"""Test of the Windows library of an FMU in Wine: its values equal those of the Linux library."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from poppet.deploy.fmu.package import build_fmu, zip_bytes
from unit.deploy.fmus import example

WINE = shutil.which("wine64") or shutil.which("wine") or shutil.which("/usr/lib/wine/wine64")
STEP, COUNT = 0.01, 200
OUTPUTS = {
    "fill_staircase": ("tank.pressure", "tank.mass", "valve.stroke", "valve.supply_mass_flow_rate"),
    "pressure_control": ("tank.pressure", "regulator.fill_command", "regulator.integral"),
}


@pytest.mark.slow
@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", OUTPUTS)
def test_windows_and_linux_libraries_give_the_same_values(name: str, fmi: int, tmp_path: Path) -> None:
    pytest.importorskip("ziglang", reason="the extra fmu is not installed")
    if WINE is None:
        pytest.skip("there is no Wine on this machine")
    path = tmp_path / "it.fmu"
    path.write_bytes(zip_bytes(build_fmu(example(name), fmi=fmi, platforms=("linux64", "win64")).content))
    with zipfile.ZipFile(path) as archive:
        archive.extractall(tmp_path)
    root = ElementTree.parse(tmp_path / "modelDescription.xml").getroot()
    token = root.get("guid" if fmi == 2 else "instantiationToken")
    references = {v.get("name"): v.get("valueReference") for v in root.find("ModelVariables")}
    arguments = [token, repr(STEP), str(COUNT), *(references[each] for each in ("follow_signals", *OUTPUTS[name]))]
    rows = []
    for target, ending, runner in (("x86_64-linux-gnu", ".so", []), ("x86_64-windows-gnu", ".dll", [WINE])):
        host = tmp_path / f"host{ending}.exe"
        command = [
            sys.executable,
            "-m",
            "ziglang",
            "cc",
            "-target",
            target,
            "-O1",
            f"-DFMI={fmi}",
            f"-I{tmp_path}/sources",
        ]
        subprocess.run([*command, "-o", host, Path(__file__).with_name("fmu_loader.c")], check=True)
        (library,) = tmp_path.rglob(f"*{ending}")
        own = {**os.environ, "WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
        ran = subprocess.run(
            [*runner, host, library.relative_to(tmp_path), *arguments],
            cwd=tmp_path,
            env=own,
            capture_output=True,
            text=True,
            check=False,
        )
        assert ran.returncode == 0, ran.stderr[-500:]
        rows.append(np.array([[float(word) for word in line.split()] for line in ran.stdout.splitlines()]))
    linux, windows = rows
    assert linux.shape == (COUNT + COUNT // 2, len(OUTPUTS[name]))
    assert np.ptp(linux[:COUNT], axis=0).min() > 0.0
    # Going back gives the same bits, on both.
    for found in rows:
        assert np.array_equal(found[COUNT:], found[COUNT // 2 : COUNT])
    assert np.array_equal(windows, linux), float(np.abs(windows / linux - 1.0).max())
