"""Table of the differences between all export targets and the kernel, for the terminal and as an HTML report."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.cosim.archive import check_archive
from poppet.deploy.comparison import (
    MARGIN,
    change_effects,
    compare_runs,
    rounding_changes,
    tolerance_changes,
)
from poppet.deploy.parity.host_runs import kernel_checks
from poppet.deploy.parity.parity_check import KernelReference, NotRunError, ParityCheck
from poppet.deploy.targets import TARGETS
from poppet.engine.problem import Problem
from poppet.engine.solve import solve
from poppet.report.html_page import document, findings, head, write_page
from poppet.report.tables import Column, ReportTable

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit


SCOPES = {"all": "every output", "gas": "pressures and masses of gas"}
VERDICTS = {"rounding": "within rounding", "coarse": "step too long"}


@dataclass(frozen=True)
class ParityRow:
    """Result of one parity check, which compares a target with the kernel.

    The difference of an output at one time is the target minus the kernel, as a magnitude relative to the size of the
    output. Outputs are compared until the time `until`. Continuous states are compared in the whole run.

    Parameters
    ----------
    check : ParityCheck
        Definition of the check.
    seconds : float or None
        Computing time of the target [s]; None if the target was not run.
    greatest : float or None
        Maximum difference of the output `worst` until the time `until`; None if nothing is compared.
    worst : str
        Address of the output with the largest difference. If a difference exceeds the permitted difference, the address
        of the output with the largest ratio of difference to permitted difference.
    ratio : float
        Maximum of the difference divided by the permitted difference, for all outputs until the time `until` and for
        all continuous states in the whole run. The permitted difference is the limit of the check, or ten times the
        effect of small changes of the kernel if this is larger.
    until : float
        Time until which outputs are compared [s]. After this time, small changes of the kernel lead to a different run.
    share : float
        Fraction of the output values that is compared.
    overall : float or None
        Maximum difference of all outputs in the whole run; None if nothing is compared.
    drift : float or None
        Maximum difference of all continuous states in the whole run; None if states are not compared.
    moved : float or None
        Maximum difference of all continuous states between the kernel without and with small changes; None if no small
        changes were made.
    differences : dict
        Maximum difference of each output until the time `until`, by address.
    why : Note or None
        Reason why the target was not run; None if the target was run.
    """

    check: ParityCheck
    seconds: float | None = None
    greatest: float | None = None
    worst: str = ""
    ratio: float = 0.0
    until: float = 0.0
    share: float = 0.0
    overall: float | None = None
    drift: float | None = None
    moved: float | None = None
    differences: Mapping[str, float] = field(default_factory=dict)
    why: Note | None = None

    @property
    def name(self) -> str:
        """Name of the check."""
        return self.check.name

    @property
    def verdict(self) -> str:
        """Verdict on the agreement of the target with the simulation.

        It is `within` (the limit), `rounding` (beyond the limit, but explained by rounding), `coarse` (the fixed step
        is too long), `beyond`, `not run` or `not compared`.
        """
        if self.why is not None:
            return "not run"
        if self.greatest is None:
            return "not compared"
        if self.check.cause == "step":
            return "within" if self.greatest <= self.check.limit else "coarse"
        if self.ratio > 1.0:
            return "beyond"
        return "within" if self.greatest <= self.check.limit else "rounding"


@dataclass(frozen=True)
class Parity:
    """Results of all parity checks of one circuit.

    A parity check compares an export target with the kernel, poppet's own integrator.

    Parameters
    ----------
    title : str
        Title of the circuit.
    duration : float
        Duration of the run [s].
    seconds : float
        Computing time of the kernel [s].
    steps : int
        Accepted steps of the kernel.
    sizes : dict
        Maximum magnitude of each output by address, SI.
    rows : tuple of ParityRow
        One row per check.
    """

    title: str
    duration: float
    seconds: float
    steps: int
    sizes: dict[str, float]
    rows: tuple[ParityRow, ...]

    @property
    def is_within_limits(self) -> bool:
        """True if no verdict is `beyond`.

        Targets that were not run are ignored.
        """
        return all(row.verdict != "beyond" for row in self.rows)


def all_checks() -> dict[str, ParityCheck]:
    """Return all parity checks by name.

    Checks of poppet's own integrator come first, followed by checks of the export targets.
    """
    checks = [*kernel_checks(), *(check for target in TARGETS.values() for check in target.parity_checks())]
    return {check.name: check for check in checks}


def compare_targets(circuit: BaseCircuit, *, only: Sequence[str] = (), fmu: Path | None = None) -> Parity:
    """Run a circuit with every export target, and compare the results with the kernel.

    The kernel is poppet's own integrator.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.
    only : sequence of str, optional
        Names of the checks to make (default: all).
    fmu : Path, optional
        FMU of the circuit, which is then the only target and is run instead of new FMUs.

    Returns
    -------
    Parity

    Raises
    ------
    InputError
        If there is no such check.
    SimulationError
        If the run of the kernel fails.
    """
    checks = all_checks()
    # Name of the check before it evaluated the program instead of the printed text; accepted until version 1.0.
    selected = ["controllers" if name == "structured text" else name for name in only]
    for name in selected:
        if name not in checks:
            near = NameSuggestion(name, checks)
            raise InputError("fields.not_an_option", "target", value=name, meaning="target", suggestion=near)
    selected_checks = [check for check in checks.values() if not selected or check.name in selected]
    if fmu is not None:
        version = check_archive(fmu)
        selected_checks = [check for check in selected_checks if check.fmi == version]
    reference = run_kernel(circuit, fmu)
    with tempfile.TemporaryDirectory() as folder:
        rows = tuple(_run_check(check, reference, Path(folder)) for check in selected_checks)
    sizes = dict(zip(reference.names, reference.rows.sizes.tolist(), strict=True))
    run = reference.run
    return Parity(circuit.title, run.reached, reference.seconds, run.accepted, sizes, rows)


def run_kernel(circuit: BaseCircuit, fmu: Path | None = None) -> KernelReference:
    """Run a circuit with poppet's own integrator, and measure the computing time.

    If `fmu` is the path of an FMU, the checks use this file instead of newly exported FMUs.
    """
    circuit.require_equations()
    circuit.simulate()  # compiles everything, and raises the error of a run that fails
    problem = circuit.problem(circuit.run)
    seconds = []
    for _ in range(3):
        start_time = time.perf_counter()
        run = solve(problem)
        seconds.append(time.perf_counter() - start_time)
    return KernelReference(circuit, problem, run, min(seconds), fmu)


def _run_check(check: ParityCheck, reference: KernelReference, folder: Path) -> ParityRow:
    try:
        result = check.run(reference, folder)
    except NotRunError as reason:
        return ParityRow(check, why=reason.note)
    if result.differences is not None:
        worst = max(result.differences, key=result.differences.__getitem__)
        greatest, until = result.differences[worst], reference.run.reached
        return ParityRow(
            check, result.seconds, greatest, worst, greatest / check.limit, until, 1.0, greatest,
            differences=result.differences,
        )  # fmt: skip
    if check.reference == "points" and result.points is not None:
        run = reference.at_points(result.points)
    else:
        run = reference.exchange_run if check.reference == "sharp" else reference.rows
    # Changes of the size of rounding, or of the tolerance of another method, measure an acceptable difference.
    changes: list[Problem] = []
    if check.cause == "rounding":
        changes = [*rounding_changes(run.problem), replace(run.problem, kernel=reference.problem.kernel)]
    elif check.cause != "anything":
        changes = tolerance_changes(run.problem, check.limit)
    is_available = np.zeros(run.values.shape, dtype=np.bool_)
    is_available[list(result.outputs) or slice(None), result.first :] = True
    effects = change_effects(run, changes)
    comparison = compare_runs(result.values, run, effects, check.limit, is_available)
    max_differences = comparison.max_differences()
    differences = {name: d for name, d in zip(reference.names, max_differences.tolist(), strict=True) if d >= 0.0}
    until = float(run.problem.grid[comparison.n_rows - 1]) if comparison.n_rows else 0.0
    in_scope = run.gas if check.scope == "gas" else np.ones(len(reference.names), dtype=np.bool_)
    if not comparison.is_compared[in_scope].any():
        return ParityRow(check, result.seconds, until=until, differences=differences)
    # In the rest of the run, the allowed difference is the effect of small changes on the kernel.
    overall, states = comparison.max_differences(whole_run=True), in_scope & run.states
    ratios = np.where(in_scope, comparison.max_ratios(), -1.0)
    rest_ratios = overall / np.maximum(check.limit, MARGIN * effects[:, -1])
    # The worst output is the one beyond the allowed difference; otherwise the one with the largest difference.
    k = int((ratios if ratios.max() > 1.0 else np.where(in_scope, max_differences, -1.0)).argmax())
    share = float(comparison.is_compared[in_scope].sum() / comparison.is_available[in_scope].sum())
    return ParityRow(
        check, result.seconds, float(max_differences[k]), reference.names[k],
        max(float(ratios.max()), float(rest_ratios[states].max(initial=0.0))), until, share,
        float(overall[in_scope].max()), float(overall[states].max(initial=0.0)),
        float(effects[states, -1].max(initial=0.0)) if changes else None, differences,
    )  # fmt: skip


def results_table(parity: Parity, *, is_long: bool = False) -> ReportTable:
    """Return a table with one row for each parity check.

    If the keyword `is_long` is True, the rows also contain the descriptions and the compared outputs.
    """
    columns = [
        Column("target"), Column("time [ms]", ".4g"), Column("greatest difference", ".2e"), Column("of"),
        Column("limit", ".0e"), Column("compared until [s]", ".4g"), Column("states, whole run", ".1e"),
        Column("kernel changed", ".1e"), Column("verdict"),
    ]  # fmt: skip
    rows: list[tuple[str | float | None, ...]] = [("kernel", 1e3 * parity.seconds, *[None] * 7)]
    rows += [
        (
            row.name,
            None if row.seconds is None else 1e3 * row.seconds,
            row.greatest,
            row.worst if row.greatest else None,
            row.check.limit if np.isfinite(row.check.limit) else None,
            None if row.why else row.until,
            row.drift,
            row.moved,
            VERDICTS.get(row.verdict, row.verdict),
        )
        for row in parity.rows
    ]
    if is_long:
        columns[1:1] = [Column("what ran"), Column("what counts")]
        descriptions = [(row.check.description, SCOPES[row.check.scope]) for row in parity.rows]
        descriptions = [(f"the reference, {parity.steps} steps", ""), *descriptions]
        rows = [(row[0], *texts, *row[1:]) for row, texts in zip(rows, descriptions, strict=True)]
    return ReportTable(columns, rows, name="parity")


def outputs_table(parity: Parity) -> ReportTable:
    """Return a table of the largest difference of each output from the reference run.

    It has one column for each target that was run.
    """
    compared = [row for row in parity.rows if row.differences]
    names = list(dict.fromkeys([*parity.sizes, *(name for row in compared for name in row.differences)]))
    columns = Column("output"), Column("size", ".4g"), *(Column(row.name, ".1e") for row in compared)
    rows = tuple((name, parity.sizes.get(name), *(row.differences.get(name) for row in compared)) for name in names)
    return ReportTable(columns, rows, name="outputs")


def not_run_notes(parity: Parity) -> list[str]:
    """Return a sentence for each target that was not run, with the reason."""
    return [f"{row.name}: {row.why}" for row in parity.rows if row.why is not None]


def write_parity(parity: Parity, path: str | Path) -> Path:
    """Write the results of all parity checks as an HTML report."""
    return write_page(path, lambda: parity_page(parity))


def parity_page(parity: Parity) -> str:
    """Return the report of all parity checks as HTML."""
    title = f"{parity.title or 'A circuit'}: comparison of all export targets"
    n_run = sum(row.why is None for row in parity.rows)
    lead = (
        f"A run of {parity.duration:.6g} s. {n_run} of {len(parity.rows)} targets were compared with the kernel; "
        f"{'all of them are' if parity.is_within_limits else 'not all of them are'} within their limits."
    )
    explanation = (
        "<p>A difference is the maximum over the compared rows, relative to the size of the output. The size is the "
        "maximum magnitude in the run, or the nominal size of a state. Targets with the steps of the kernel must agree "
        "with a kernel without fused operations (FMA) up to rounding. For other methods, the limit follows from the "
        "tolerances, and only pressures and masses are compared. The comparison ends when small changes of the kernel "
        "lead to a different run. After that, the maximum difference of a state in the whole run is compared with the "
        "effect of these changes on the kernel: the verdict is beyond if it is more than ten times as large. Within "
        "rounding means: beyond the limit, but at most ten times the effect of rounding on the kernel. Times are the "
        "best of some runs on this machine, without preparation.</p>\n"
    )
    sections = [
        ("", head(title, lead)),
        ("Targets", results_table(parity, is_long=True).html() + explanation),
        ("Not run", findings(not_run_notes(parity))),
        ("Every output", outputs_table(parity).html()),
    ]
    return document(title, sections)
