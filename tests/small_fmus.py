"""Small FMUs for tests: an integrator in C, and packages with any model description."""

from __future__ import annotations

import subprocess
import zipfile
from functools import cache
from pathlib import Path

import pytest

from c_compiler import COMPILER
from poppet.cosim.description import present_platform

SOURCE = Path(__file__).with_name("integrator.c")
DESCRIPTION = """<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="integrator" guid="none" numberOfEventIndicators="0">
  <CoSimulation modelIdentifier="integrator" canHandleVariableCommunicationStepSize="{variable}"
    canInterpolateInputs="{interpolates}" canGetAndSetFMUstate="{rolls}"/>
  <ModelVariables>
    <ScalarVariable name="u" valueReference="0" causality="input"><Real start="0"/></ScalarVariable>
    <ScalarVariable name="y" valueReference="1" causality="output"><Real/></ScalarVariable>
    <ScalarVariable name="z" valueReference="2" causality="output"><Real/></ScalarVariable>
    <ScalarVariable name="rate" valueReference="3" causality="parameter" variability="tunable"><Real start="1"/>
    </ScalarVariable>
    <ScalarVariable name="gain" valueReference="4" causality="parameter" variability="tunable"><Real start="0"/>
    </ScalarVariable>
    <ScalarVariable name="fault_time" valueReference="5" causality="parameter" variability="fixed"><Real start="0.5"/>
    </ScalarVariable>
    <ScalarVariable name="initial[y]" valueReference="1" causality="parameter" variability="fixed"><Real start="0"/>
    </ScalarVariable>
    <ScalarVariable name="fault" valueReference="6" causality="parameter" variability="fixed"><Integer start="0"/>
    </ScalarVariable>
  </ModelVariables>
  <ModelStructure><Outputs><Unknown index="2" dependencies=""/><Unknown index="3" dependencies="1"/></Outputs>
  </ModelStructure>
</fmiModelDescription>
"""


@cache
def _library(folder: Path) -> bytes:
    target = folder / "integrator.so"
    command = [str(COMPILER), "-shared", "-fPIC", "-O1", "-o", str(target), str(SOURCE), "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    return target.read_bytes()


def write_integrator(
    folder: Path, name: str = "integrator.fmu", *, rolls: bool = True, interpolates: bool = True, variable: bool = True
) -> Path:
    """Write the FMU of `integrator.c`; skip the test without a C compiler or FMPy."""
    pytest.importorskip("fmpy", reason="running an FMU needs FMPy")
    if COMPILER is None:
        pytest.skip("an FMU for tests needs a C compiler")
    flags = {"rolls": rolls, "interpolates": interpolates, "variable": variable}
    text = DESCRIPTION.format(**{key: str(value).lower() for key, value in flags.items()})
    entries = {f"binaries/{present_platform(2)}/integrator.so": _library(folder)}
    return write_fmu(folder / name, text, entries)


def write_fmu(path: Path, description: str, entries: dict[str, bytes] | None = None) -> Path:
    """Write an FMU with a model description and further entries."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("modelDescription.xml", description)
        for name, content in (entries or {}).items():
            archive.writestr(name, content)
    return path
