"""Runs of an FMU in importers (FMPy and libcosim), and the circuit file inside an FMU."""

from __future__ import annotations

import json
import tempfile
import time
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, needed
from poppet.core.toml_file import LARGEST, TomlFile
from poppet.cosim.archive import check_entries, open_archive
from poppet.deploy.fmu.fmu_layout import FOLLOWS

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

Array = NDArray[np.float64]
EXCHANGE_TOLERANCE = 1e-9
"""Relative tolerance of the solver CVODE in the importer. It is small, because errors accumulate over a run."""
NANOSECOND = 1e-9
"""Duration of one time unit of libcosim [s]."""
CIRCUIT, CHANGES, PARAMETERS = "resources/circuit.toml", "resources/changes.toml", "resources/numbers"


class ImporterRun(NamedTuple):
    """Results of an FMU, simulated by an importer with the signals of the circuit."""

    values: Array  # (n_names, n_times)
    points: Array  # (n_times,) ends of the importer's steps [s]
    first: int  # first available row
    seconds: float


def read_description(path: Path) -> tuple[list[str], list[str]]:
    """Return the names of all variables of an FMU, and the errors in its description.

    The package FMPy finds the errors.
    """
    with needed("FMPy", "running an FMU", "check"):
        import fmpy
        from fmpy.validation import validate_fmu

    return [v.name for v in fmpy.read_model_description(str(path)).modelVariables], list(validate_fmu(str(path)))


def run_in_fmpy(path: Path, kind: str, grid: Array, names: Sequence[str]) -> ImporterRun:
    """Simulate an FMU in FMPy, and return the values of some variables.

    `kind` is `CoSimulation`, or `ModelExchange` with the solver CVODE. `grid` contains the output times [s], and
    `names` the variables.
    """
    import fmpy

    variables = {v.name for v in fmpy.read_model_description(str(path)).modelVariables}
    step = float(grid[1] - grid[0])
    solver = {} if kind == "CoSimulation" else {"solver": "CVode", "relative_tolerance": EXCHANGE_TOLERANCE}
    start_time = time.perf_counter()
    rows = fmpy.simulate_fmu(
        str(path), fmi_type=kind, start_time=0.0, stop_time=float(grid[-1]), output_interval=step,
        start_values={FOLLOWS: True} if FOLLOWS in variables else {}, output=list(names), **solver,
    )  # fmt: skip
    seconds = time.perf_counter() - start_time
    # Of several rows at one time, before and after an event, the last is used.
    times = rows["time"]
    grid = grid[grid <= times[-1] + 1e-6 * step]
    indices = np.searchsorted(times, grid + 1e-6 * step, side="right") - 1
    points = times[indices]
    # The kernel has the rounding of the sum of a point and the step after it.
    points[1:] = points[:-1] + np.diff(points)
    return ImporterRun(np.array([rows[name][indices] for name in names]), points, 0, seconds)


def run_in_libcosim(path: Path, grid: Array, names: Sequence[str]) -> ImporterRun:
    """Simulate an FMU in libcosim, and return the values of some variables.

    `grid` contains the output times [s], and `names` the variables. The values at the first time are NaN, because
    libcosim returns values at the ends of steps only.
    """
    with needed("libcosimpy", "running an FMU in a second host", "check"):
        from libcosimpy.CosimExecution import CosimExecution
        from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
        from libcosimpy.CosimObserver import CosimObserver
        from libcosimpy.CosimSlave import CosimLocalSlave

    # Suppress a false error about a missing start of the time.
    log_output_level(CosimLogLevel.FATAL)
    execution: Any = CosimExecution.from_step_size(round((grid[1] - grid[0]) / NANOSECOND))
    slave, observer = CosimLocalSlave(str(path), "it"), CosimObserver.create_last_value()
    index = execution.add_local_slave(slave)
    execution.add_observer(observer)
    references = {v.name.decode(): v.reference for v in execution.slave_variables(index)}
    if FOLLOWS in references:
        execution.boolean_initial_value(index, references[FOLLOWS], True)
    selected = [references[name] for name in names]
    rows = np.full((len(names), grid.size), np.nan)
    start_time = time.perf_counter()
    for k in range(1, grid.size):
        if not execution.step():
            return ImporterRun(rows[:, :k], grid[:k], 1, time.perf_counter() - start_time)
        rows[:, k] = observer.last_real_values(index, selected)
    return ImporterRun(rows, grid, 1, time.perf_counter() - start_time)


def circuit_resources(text: str, changes: Mapping[str, float | str], result: str | None) -> dict[str, bytes]:
    """Return the files inside an FMU from which its circuit can be read.

    The result maps paths to contents. `text` is the circuit file, `changes` maps addresses to values that were changed
    before the export, and `result` is the path of a file with identified parameters. The result is empty without
    `text`.
    """
    if not text:
        return {}
    # Strings and numbers of JSON are valid in TOML.
    table = "".join(f"{json.dumps(address)} = {json.dumps(value)}\n" for address, value in changes.items())
    resources = {CIRCUIT: text.encode()} | ({CHANGES: table.encode()} if table else {})
    if result:
        resources[f"{PARAMETERS}{Path(result).suffix}"] = Path(result).read_bytes()
    return resources


def read_circuit(path: Path) -> BaseCircuit:
    """Read the circuit that is stored inside an FMU.

    Raises
    ------
    InputError
        If the FMU contains no circuit, or the circuit needs files that are missing.
    """
    from poppet.circuit.file import loads
    from poppet.identify.parameter_file import with_numbers

    with open_archive(path) as archive:
        check_entries(archive, path.name)
        names = set(archive.namelist())
        if CIRCUIT not in names:
            raise InputError("deploy.fmu.no_circuit", name=path.name)
        text = _text(archive, CIRCUIT, path.name)
        changes = {}
        if CHANGES in names:
            file = TomlFile(_text(archive, CHANGES, path.name), f"{path.name}: {CHANGES}")
            with file.errors():
                changes = file.content
        circuit = loads(text, name=path.name, folder=path.parent)
        for name in {f"{PARAMETERS}.toml", f"{PARAMETERS}.json"} & names:
            with tempfile.TemporaryDirectory() as folder:
                circuit, _ = with_numbers(circuit, archive.extract(name, folder))
    return circuit.with_values(changes)


def _text(archive: zipfile.ZipFile, entry: str, name: str) -> str:
    """Return a text file of an archive with the given file name."""
    if archive.getinfo(entry).file_size > LARGEST:
        raise InputError("toml.too_large", path=f"{name}: {entry}", most=LARGEST // 2**20)
    try:
        return archive.read(entry).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError("toml.no_text", path=f"{name}: {entry}") from None
