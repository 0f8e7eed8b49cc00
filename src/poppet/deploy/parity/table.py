"""The same run by every target: greatest difference of each output, time, and whether that is within the limits."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.deploy.comparison import GROWN, ReferenceRun, compare, grown, loosened, rounded
from poppet.deploy.fmu.hosts import fmi_version
from poppet.deploy.parity import targets
from poppet.deploy.parity.targets import NotRun, Reference, TargetResult
from poppet.engine.problem import Problem
from poppet.engine.solve import solve

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]


class Target(NamedTuple):
    """A row of the table: what it is, its limit, and which outputs that is for."""

    name: str
    what: str
    # Greatest difference by the size of an output. The same method with the same tolerance is held to its digits;
    # another method, to what the tolerance of both is worth.
    limit: float
    of: str  # `all` outputs, or `gas`: states that are always positive, pressures and masses
    run: Callable[[Reference, Path], TargetResult]
    beside: str = "rows"  # which run of the kernel
    # What makes it differ: `rounding`, the errors of its `method`, the length of a `step`, or `anything`.
    errs: str = "rounding"


TARGETS = (
    # No target can be nearer to the kernel than the kernel is to itself: a loop that hunts makes much of a last digit.
    Target("kernel fused", "the kernel as `simulate` runs it", np.inf, "all", targets.kernel_fused, errs="anything"),
    Target(
        "kernel moved", "the kernel, its start moved by 1e-14", np.inf, "all", targets.kernel_moved, errs="anything"
    ),
    Target("scipy", "LSODA of SciPy on the compiled functions", 1e-5, "gas", targets.scipy, errs="method"),
    Target("cvodes", "CVODES of SUNDIALS on the traced expressions", 1e-5, "gas", targets.cvodes, errs="method"),
    Target("c adaptive", "the exported C, with error control", 1e-9, "all", targets.c_adaptive),
    Target("c 1 kHz", "the exported C, fixed step of 1 ms", 1e-3, "gas", targets.c_slow, errs="step"),
    Target("c 10 kHz", "the exported C, fixed step of 0.1 ms", 1e-4, "gas", targets.c_fast, errs="step"),
    Target(
        "c 1 kHz / 100", "the exported C, fixed step of 1 ms in a hundred", 1e-4, "gas", targets.c_parted, errs="step"
    ),
    Target(
        "fmu cs", "FMI 2.0 co-simulation in FMPy, which meets the kernel at every row", 1e-10, "all",
        targets.fmu_co_simulation, "points",
    ),
    Target("fmu 3 cs", "the same with FMI 3.0", 1e-10, "all", targets.fmu_3_co_simulation, "points"),
    Target(
        "fmu cs (second host)", "FMI 2.0 co-simulation in libcosim", 1e-10, "all", targets.fmu_second_host, "points"
    ),
    Target(
        "fmu me", "FMI 2.0 model exchange, by CVODE of FMPy; the kernel at 1e-9", 1e-5, "gas",
        targets.fmu_model_exchange, "sharp", "method",
    ),
    Target(
        "fmu 3 me", "the same with FMI 3.0", 1e-5, "gas", targets.fmu_3_model_exchange, "sharp", "method"
    ),
    Target("wasm", "WebAssembly of the live page, in node", 1e-9, "all", targets.web_assembly),
    Target("structured text", "the controllers, by an evaluator of our own", 1e-9, "all", targets.structured_text),
)  # fmt: skip
"""What is run beside the kernel, in the order of the table."""
OF_FMUS = {"fmu cs": 2, "fmu 3 cs": 3, "fmu cs (second host)": 2, "fmu me": 2, "fmu 3 me": 3}
"""Targets that run an FMU, with its version."""


@dataclass(frozen=True)
class Row:
    """What one target gave.

    Parameters
    ----------
    target : Target
    seconds : float or None
        Of the run alone; None where it was not run.
    greatest : float or None
        Greatest difference that is compared, by the size of the output; None where nothing is.
    worst : str
        That output.
    ratio : float
        Greatest difference by what is allowed: the limit, or ten times what small changes become in that output; of
        states in the rest of the run too, where that is what they become anywhere in it.
    until : float
        Up to when it is compared [s]: from there on the kernel, changed by as little as this target differs, is
        another run.
    share : float
        Of the numbers of those outputs that are compared.
    overall : float or None
        Greatest difference in the whole run.
    drift : float or None
        Greatest difference of a state in the whole run.
    moved : float or None
        The same of the kernel, of which as little is changed as by that target; None where nothing was changed.
    differences : dict
        Address of every output to its greatest difference that is compared, by its size.
    why : Note or None
        Why it was not run.
    """

    target: Target
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
        """Of the target."""
        return self.target.name

    @property
    def verdict(self) -> str:
        """`within` its limit, or `rounding`: within what that becomes; `coarse`: a step too long; or `beyond`."""
        if self.why is not None:
            return "not run"
        if self.greatest is None:
            return "not compared"
        if self.target.errs == "step":
            return "within" if self.greatest <= self.target.limit else "coarse"
        if self.ratio > 1.0:
            return "beyond"
        return "within" if self.greatest <= self.target.limit else "rounding"

    @property
    def is_well(self) -> bool:
        """False where it was run and is further from the kernel than its limit and than rounding."""
        return self.verdict != "beyond"


@dataclass(frozen=True)
class Parity:
    """The table of one circuit.

    Parameters
    ----------
    title : str
        Of the circuit.
    duration : float
        Of the run [s].
    seconds : float
        The kernel's time.
    steps : int
        The kernel's accepted steps.
    sizes : dict
        Address of every output to its greatest magnitude in the run, SI.
    rows : tuple of Row
        One for each target.
    """

    title: str
    duration: float
    seconds: float
    steps: int
    sizes: dict[str, float]
    rows: tuple[Row, ...]

    @property
    def is_well(self) -> bool:
        """True where no target that was run is beyond its limit."""
        return all(row.is_well for row in self.rows)


def parity(circuit: Circuit, *, only: Sequence[str] = (), fmu: Path | None = None) -> Parity:
    """Run a circuit by every target, and compare each with the kernel.

    Parameters
    ----------
    circuit : Circuit
        With a duration.
    only : sequence of str, optional
        Names of targets; default all.
    fmu : Path, optional
        An FMU of the circuit, which is run in place of those that would be made, and no other target.

    Returns
    -------
    Parity

    Raises
    ------
    InputError
        If there is no such target.
    SimulationError
        If the kernel's own run fails.
    """
    known = {each.name: each for each in TARGETS}
    for name in only:
        if name not in known:
            near = NameSuggestion(name, known)
            raise InputError("fields.not_an_option", "target", value=name, meaning="target", near=near)
    chosen = [each for each in TARGETS if not only or each.name in only]
    if fmu is not None:
        version = fmi_version(fmu)
        chosen = [each for each in chosen if OF_FMUS.get(each.name) == version]
    reference = _reference(circuit, fmu)
    with tempfile.TemporaryDirectory() as folder:
        rows = tuple(_row(each, reference, Path(folder)) for each in chosen)
    sizes = dict(zip(reference.names, reference.rows.sizes.tolist(), strict=True))
    return Parity(circuit.title, reference.run.reached, reference.seconds, reference.run.accepted, sizes, rows)


def _reference(circuit: Circuit, fmu: Path | None = None) -> Reference:
    circuit.simulate()  # what fails says so here; and everything is compiled
    problem = circuit.problem(circuit.run)
    seconds = []
    for _ in range(3):
        began = time.perf_counter()
        run = solve(problem)
        seconds.append(time.perf_counter() - began)
    return Reference(circuit, problem, run, min(seconds), fmu)


def _beside(target: Target, reference: Reference, found: TargetResult) -> ReferenceRun:
    if target.beside == "points" and found.points is not None:
        return reference.meeting(found.points)
    return reference.sharp if target.beside == "sharp" else reference.rows


def _changes(target: Target, reference: Reference, of: ReferenceRun) -> list[Problem]:
    """Changes of the kernel's problem as small as those by which a target differs."""
    if target.errs == "anything":
        return []
    if target.errs == "rounding":
        return [*rounded(of.problem), replace(of.problem, kernel=reference.problem.kernel)]
    return loosened(of.problem, target.limit)


def _row(target: Target, reference: Reference, folder: Path) -> Row:
    try:
        found = target.run(reference, folder)
    except NotRun as reason:
        return Row(target, why=reason.note)
    if found.differences is not None:
        worst = max(found.differences, key=found.differences.__getitem__)
        greatest, until = found.differences[worst], reference.run.reached
        return Row(
            target, found.seconds, greatest, worst, greatest / target.limit, until, 1.0, greatest,
            differences=found.differences,
        )  # fmt: skip
    of = _beside(target, reference, found)
    counted = np.zeros(of.values.shape, dtype=np.bool_)
    counted[list(found.outputs) or slice(None), found.first :] = True
    changes = _changes(target, reference, of)
    moved = grown(of, changes)
    compared = compare(found.values, of, moved, target.limit, counted)
    greatest_of = compared.greatest()
    differences = {name: d for name, d in zip(reference.names, greatest_of.tolist(), strict=True) if d >= 0.0}
    until = float(of.problem.grid[compared.rows - 1]) if compared.rows else 0.0
    judged = of.gas if target.of == "gas" else np.ones(len(reference.names), dtype=np.bool_)
    if not compared.is_followed[judged].any():
        return Row(target, found.seconds, until=until, differences=differences)
    # A run that is not followed to its end is as far away, in the rest of it, as the kernel is from itself.
    anywhere, states = compared.greatest(is_all=True), judged & of.states
    ratios = np.where(judged, compared.ratios(), -1.0)
    rest = anywhere / np.maximum(target.limit, GROWN * moved[:, -1])
    # Of one that is beyond what is allowed, that output; else the one that differs most.
    k = int((ratios if ratios.max() > 1.0 else np.where(judged, greatest_of, -1.0)).argmax())
    share = float(compared.is_followed[judged].sum() / compared.counted[judged].sum())
    return Row(
        target, found.seconds, float(greatest_of[k]), reference.names[k],
        max(float(ratios.max()), float(rest[states].max(initial=0.0))), until, share, float(anywhere[judged].max()),
        float(anywhere[states].max(initial=0.0)), float(moved[states, -1].max(initial=0.0)) if changes else None,
        differences,
    )  # fmt: skip
