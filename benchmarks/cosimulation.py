"""Coupling of two FMUs: error and time beside libcosim, with the same binaries and steps.

Two integrators form an oscillator of 1 Hz, whose solution is a cosine. libcosim takes each step once, with constant
inputs (its fixed-step algorithm), in one process. poppet runs each FMU in a process of its own, and repeats the steps
of FMUs that can return to an earlier state.
"""

from __future__ import annotations

import sys
import tempfile
import time
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

STEPS = 10e-3, 5e-3, 2.5e-3
PERIODS = 10
"""Periods of the oscillator, of 1 s each."""


def error_of(time: np.ndarray, values: np.ndarray) -> float:
    """Return the maximum difference from the cosine."""
    return float(np.abs(values - np.cos(2.0 * np.pi * time)).max())


def run_poppet(path: Path, step: float, duration: float) -> tuple[float, float]:
    """Return the error of poppet, and the time of its run [s]."""
    circuit = import_module("coupled_circuits").oscillator(path, step)
    begin = time.perf_counter()
    recording = circuit.simulate(duration, step, allow_native=True)
    return error_of(recording.time, recording["x.y"]), time.perf_counter() - begin


def run_libcosim(path: Path, step: float, duration: float) -> tuple[float, float]:
    """Return the error of libcosim, and the time of its run [s]."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    log_output_level(CosimLogLevel.FATAL)
    begin = time.perf_counter()
    execution: Any = CosimExecution.from_step_size(round(1e9 * step))
    observer = CosimObserver.create_last_value()
    indices = [execution.add_local_slave(CosimLocalSlave(str(path), name)) for name in ("x", "v")]
    execution.add_observer(observer)
    references = {v.name.decode(): v.reference for v in execution.slave_variables(indices[0])}
    u, y = references["u"], references["y"]
    omega = 2.0 * np.pi
    for index, rate, start in zip(indices, (omega, -omega), (1.0, 0.0), strict=True):
        execution.real_initial_value(index, references["rate"], rate)
        execution.real_initial_value(index, references["initial[y]"], start)
    for source, target in (indices, indices[::-1]):
        execution.connect_real_variables(source, y, target, u)
    count = round(duration / step)
    values = np.empty(count)
    for k in range(count):
        if not execution.step():
            raise RuntimeError(f"libcosim has stopped at {k * step} s")
        (values[k],) = observer.last_real_values(indices[0], [y])
    return error_of(step * np.arange(1, count + 1), values), time.perf_counter() - begin


def main(size: float = 1.0) -> None:
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    if find_spec("fmpy") is None or import_module("c_compiler").COMPILER is None:
        print("no FMU was coupled:\nFMPy or a C compiler is missing")
        return
    write = import_module("small_fmus").write_integrator
    duration = max(0.2, PERIODS * size)
    with tempfile.TemporaryDirectory() as folder:
        methods: dict[str, Any] = {
            "iteration and interpolation": (run_poppet, write(Path(folder), "a.fmu")),
            "iteration only": (run_poppet, write(Path(folder), "b.fmu", interpolates=False)),
            "interpolation only": (run_poppet, write(Path(folder), "c.fmu", rolls=False)),
        }
        if find_spec("libcosimpy") is not None:
            methods["libcosim"] = run_libcosim, methods["iteration and interpolation"][1]
        print(f"oscillator of two FMUs, {duration:g} periods: maximum error, ms per communication step")
        for step in STEPS if size >= 0.1 else STEPS[:1]:
            for name, (run, path) in methods.items():
                error, seconds = run(path, step, duration)
                print(
                    f"{1e3 * step:4g} ms  {name:27s} {error:8.1e}  {1e3 * seconds * step / duration:6.3f}", flush=True
                )


if __name__ == "__main__":
    main()
