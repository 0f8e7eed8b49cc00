"""The Reference FMUs of the Modelica Association, against FMPy as an independent master.

`POPPET_REFERENCE_FMUS` is a folder with their FMUs in the folders `2.0` and `3.0`.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from poppet import FMU, Circuit, Run
from poppet.core.errors import InputError
from poppet.cosim.description import read_fmu

FOLDER = os.environ.get("POPPET_REFERENCE_FMUS", "")
pytestmark = pytest.mark.skipif(not FOLDER, reason="POPPET_REFERENCE_FMUS does not name the Reference FMUs")
CASES = {
    "BouncingBall": (0.01, 3.0),
    "Dahlquist": (0.1, 10.0),
    "Feedthrough": (0.1, 2.0),
    "Resource": (1.0, 5.0),
    "Roberts": (0.01, 1.0),
    "Stair": (0.2, 10.0),
    "StateSpace": (1.0, 10.0),
    "VanDerPol": (0.01, 5.0),
}
"""Communication step and duration of each FMU [s]."""


def path_of(version: str, name: str) -> Path:
    path = Path(FOLDER, version, f"{name}.fmu")
    if not path.exists():
        pytest.skip(f"{path.name} does not exist in FMI {version}")
    return path


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_results_are_those_of_fmpy(version, name):
    fmpy = pytest.importorskip("fmpy", reason="FMPy is the other master")
    path, (step, duration) = path_of(version, name), CASES[name]
    run = Run(duration=duration, output_step=step)
    recording = Circuit({"m": FMU(path, step=step)}, run=run).simulate(allow_native=True)
    expected = fmpy.simulate_fmu(
        str(path), fmi_type="CoSimulation", start_time=0.0, stop_time=duration, step_size=step, output_interval=step,
        relative_tolerance=1e-6, use_event_mode=False, early_return_allowed=False,
    )  # fmt: skip
    for variable in read_fmu(path).outputs:
        series = expected[variable.array].reshape(len(expected), -1)[:, variable.index]
        rows = np.searchsorted(expected["time"], recording.time - 1e-9)
        # Outputs of Roberts differ at some points, and are equal again at the next one.
        allowed = 1e-7 if name == "Roberts" else 0.0
        assert np.abs(recording[f"m.{variable.local}"] - series[rows]).max() <= allowed, variable.name


def test_all_types_pass_through():
    path = path_of("3.0", "Feedthrough")
    names = {"Float64_continuous": 1.5, "Float64_discrete": -2.5, "Int8": -8.0, "UInt16": 16.0, "Boolean": 1.0}
    start = {f"{name}_input": value for name, value in names.items()} | {"Int32_input": 32.0}
    circuit = Circuit({"m": FMU(path, step=0.1, start=start)}, run=Run(duration=0.5, output_step=0.1))
    recording = circuit.simulate(allow_native=True)
    for name, value in (names | {"Int32": 32.0}).items():
        assert recording[f"m.{name}_output"].tolist() == [value] * 6, name


def test_an_fmu_with_clocks_only():
    with pytest.raises(InputError) as error:
        FMU(path_of("3.0", "Clocks"))
    assert error.value.code == "fmu.no_cosimulation"
