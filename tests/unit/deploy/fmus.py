"""FMUs for tests: made once, by the compiler of this machine, and instances of them in FMPy."""

from __future__ import annotations

import shutil
import tempfile
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from poppet import Circuit, load
from poppet.deploy.fmu import binaries
from poppet.deploy.fmu.package import build_fmu, zip_bytes
from poppet.deploy.parity.parity_table import ParityRow, compare_targets

EXAMPLES = Path(__file__).parents[3] / "examples"
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
FOLDER = Path(tempfile.mkdtemp(prefix="fmus"))


@cache
def example(name: str, duration: float | None = None) -> Circuit:
    """A circuit of the examples, or the begin of its run."""
    circuit = load(EXAMPLES / f"{name}.toml")
    return circuit if duration is None else circuit.with_values({"run.duration": duration})


def build(circuit: Circuit, fmi: int, path: Path, inputs: tuple[str, ...] = ()) -> Path:
    """The FMU of a circuit for this machine."""
    pytest.importorskip("fmpy", reason="FMPy is not installed")
    if COMPILER is None:
        pytest.skip("no C compiler here")
    with pytest.MonkeyPatch.context() as patch:
        # The host's compiler is faster at its first run; Zig has tests of its own.
        patch.setattr(binaries, "has_zig", lambda: False)
        path.write_bytes(zip_bytes(build_fmu(circuit, fmi=fmi, inputs=inputs).content))
    return path


@cache
def built(name: str, fmi: int, duration: float | None = None, inputs: tuple[str, ...] = ()) -> Path:
    """The FMU of an example."""
    return build(example(name, duration), fmi, FOLDER / f"{name}{fmi}{duration}{len(inputs)}.fmu", inputs)


def fmpy_run(path: Path, kind: str, stop: float) -> Any:
    """Rows of a run by FMPy, a second apart."""
    import fmpy

    return fmpy.simulate_fmu(str(path), fmi_type=kind, stop_time=stop, output_interval=1.0, relative_tolerance=1e-8)


def held(path: Path, circuit: Circuit, target: str, fmi: int = 2) -> ParityRow:
    """An FMU beside the kernel, in the row of a target."""
    name = target.replace("fmu", f"fmu {fmi}") if fmi == 3 else target
    (row,) = compare_targets(circuit, only=[name], fmu=path).rows
    return row


class Host:
    """An instance of an FMU in FMPy, by the names of its variables."""

    def __init__(self, path: Path, kind: str = "CoSimulation", *, follows: bool = True) -> None:
        import fmpy
        from fmpy.simulation import instantiate_fmu

        self.description = fmpy.read_model_description(str(path))
        self.folder = fmpy.extract(str(path))
        self.log: list[tuple[int, str]] = []

        def logged(*told: Any) -> None:
            """Status and text, behind which FMI 2.0 may have more."""
            *_, status, _, text = told[:5] if self.is_2 else told
            self.log.append((status, text.decode()))

        self.is_2 = self.description.fmiVersion == "2.0"
        self.fmu: Any = instantiate_fmu(self.folder, self.description, kind, logger=logged)
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}
        self.follows, self.kind = follows, kind

    def __enter__(self) -> Host:
        return self

    def __exit__(self, *_: object) -> None:
        self.fmu.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)

    def begin(self, start: float = 0.0, **values: float) -> Host:
        """Set values, and initialise."""
        if self.follows:
            self.fmu.setBoolean([self.references["follow_signals"]], [True])
        for name, value in values.items():
            self.set(name, value)
        if self.is_2:
            self.fmu.setupExperiment(startTime=start)
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(startTime=start)
        self.fmu.exitInitializationMode()
        return self

    def set(self, name: str, value: float) -> None:
        """Set a number; a dot may be written as two underscores."""
        references = [self.references[name.replace("__", ".")]]
        (self.fmu.setReal if self.is_2 else self.fmu.setFloat64)(references, [value])

    def get(self, *names: str) -> list[float]:
        """Values of numbers."""
        references = [self.references[name] for name in names]
        return list((self.fmu.getReal if self.is_2 else self.fmu.getFloat64)(references))

    def step(self, begin: float, length: float) -> Any:
        """A step of co-simulation."""
        return self.fmu.doStep(currentCommunicationPoint=begin, communicationStepSize=length)

    def run(self, points: list[float], *names: str) -> list[list[float]]:
        """Values at each point after the first."""
        rows = []
        for begin, end in pairwise(points):
            self.step(begin, end - begin)
            rows.append(self.get(*names))
        return rows
