"""Hosts that run an FMU here: FMPy, model exchange and co-simulation, and libcosim, co-simulation of FMI 2.0."""

from __future__ import annotations

import time
import xml.etree.ElementTree as ElementTree
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, needed
from poppet.deploy.fmu.fmu_layout import FOLLOWS

Array = NDArray[np.float64]
EXCHANGE_TOLERANCE = 1e-9
"""Relative tolerance of the host's CVODE, whose errors add up over a run."""
NANOSECOND = 1e-9
"""In which libcosim counts time."""


class Hosted(NamedTuple):
    """A run of an FMU, its inputs following the circuit's own signals."""

    values: Array  # (n_names, n_times)
    points: Array  # (n_times,) where the steps of the host ended [s]
    first: int  # row that is shown first
    seconds: float


def fmi_version(path: Path) -> int:
    """Of FMI, 2 or 3; the file is read and not run.

    Raises
    ------
    InputError
        Where it cannot be read, or is no FMU.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            root = ElementTree.fromstring(archive.read("modelDescription.xml"))
        return {"2": 2, "3": 3}[root.attrib["fmiVersion"].partition(".")[0]]
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from problem
    except zipfile.BadZipFile as problem:
        raise InputError("deploy.fmu.no_archive", name=path.name) from problem
    except (KeyError, ElementTree.ParseError) as problem:
        raise InputError("deploy.fmu.no_fmu", name=path.name) from problem


def described(path: Path) -> tuple[list[str], list[str]]:
    """Names of all variables of an FMU, and what FMPy's validation finds wrong with its description."""
    with needed("FMPy", "running an FMU", "check"):
        import fmpy as host
        from fmpy.validation import validate_fmu

    return [v.name for v in host.read_model_description(str(path)).modelVariables], list(validate_fmu(str(path)))


def in_fmpy(path: Path, kind: str, grid: Array, names: Sequence[str]) -> Hosted:
    """Rows of a run by FMPy, `CoSimulation`, or `ModelExchange` by its CVODE."""
    import fmpy as host

    own = {v.name for v in host.read_model_description(str(path)).modelVariables}
    step = float(grid[1] - grid[0])
    more = {} if kind == "CoSimulation" else {"solver": "CVode", "relative_tolerance": EXCHANGE_TOLERANCE}
    began = time.perf_counter()
    rows = host.simulate_fmu(
        str(path), fmi_type=kind, start_time=0.0, stop_time=float(grid[-1]), output_interval=step,
        start_values={FOLLOWS: True} if FOLLOWS in own else {}, output=list(names), **more,
    )  # fmt: skip
    took = time.perf_counter() - began
    # Of rows at one time, before and after an event, the last.
    times = rows["time"]
    grid = grid[grid <= times[-1] + 1e-6 * step]
    places = np.searchsorted(times, grid + 1e-6 * step, side="right") - 1
    points = times[places]
    # Where the sum of a point and the step from there to the next is rounded to.
    points[1:] = points[:-1] + np.diff(points)
    return Hosted(np.array([rows[name][places] for name in names]), points, 0, took)


def in_libcosim(path: Path, grid: Array, names: Sequence[str]) -> Hosted:
    """Rows of a run by libcosim, which shows them from the end of the first step on."""
    with needed("libcosimpy", "running an FMU in a second host", "check"):
        from libcosimpy.CosimExecution import CosimExecution
        from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
        from libcosimpy.CosimObserver import CosimObserver
        from libcosimpy.CosimSlave import CosimLocalSlave

    # Of its messages one is an error that is none: its reader wants a start of the time.
    log_output_level(CosimLogLevel.FATAL)
    execution: Any = CosimExecution.from_step_size(round((grid[1] - grid[0]) / NANOSECOND))
    slave, observer = CosimLocalSlave(str(path), "it"), CosimObserver.create_last_value()
    place = execution.add_local_slave(slave)
    execution.add_observer(observer)
    references = {v.name.decode(): v.reference for v in execution.slave_variables(place)}
    if FOLLOWS in references:
        execution.boolean_initial_value(place, references[FOLLOWS], True)
    wanted = [references[name] for name in names]
    rows = np.full((len(names), grid.size), np.nan)
    began = time.perf_counter()
    for k in range(1, grid.size):
        if not execution.step():
            return Hosted(rows[:, :k], grid[:k], 1, time.perf_counter() - began)
        rows[:, k] = observer.last_real_values(place, wanted)
    return Hosted(rows, grid, 1, time.perf_counter() - began)
