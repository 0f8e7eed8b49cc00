"""The same run by every target: greatest difference of each output, time, and whether that is within the limits."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.deploy.parity import targets
from poppet.deploy.parity.targets import Found, NotRun, Reference
from poppet.engine.solve import solve
from poppet.ground.codes import Note
from poppet.ground.errors import InputError, Near

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
    run: Callable[[Reference, Path], Found]


TARGETS = (
    # No target can be nearer to the kernel than the kernel is to itself: a loop that hunts makes much of a last digit.
    Target("kernel moved", "the kernel, its start moved by 1e-14", np.inf, "all", targets.kernel_moved),
    Target("scipy", "LSODA of SciPy on the compiled functions", 1e-5, "gas", targets.scipy),
    Target("cvodes", "CVODES of SUNDIALS on the traced expressions", 1e-5, "gas", targets.cvodes),
    Target("c adaptive", "the exported C, with error control", 1e-9, "all", targets.c_adaptive),
    Target("c 1 kHz", "the exported C, fixed step of 1 ms", 1e-3, "gas", targets.c_slow),
    Target("c 10 kHz", "the exported C, fixed step of 0.1 ms", 1e-4, "gas", targets.c_fast),
    Target(
        "fmu cs",
        "FMI 2.0 co-simulation in FMPy, which meets the kernel at every row",
        1e-10,
        "all",
        targets.fmu_co_simulation,
    ),
    Target(
        "fmu me",
        "FMI 2.0 model exchange, by CVODE of FMPy; the kernel at 1e-9",
        1e-5,
        "gas",
        targets.fmu_model_exchange,
    ),
    Target("wasm", "WebAssembly of the live page, in node", 1e-9, "all", targets.web_assembly),
    Target("structured text", "the controllers, by an evaluator of our own", 1e-9, "all", targets.structured_text),
)
"""What is run beside the kernel, in the order of the table."""

GROWN = 10.0
"""Times what one moved start becomes, that another rounding may become."""


@dataclass(frozen=True)
class Row:
    """What one target gave.

    Parameters
    ----------
    name, what : str
        Of the target.
    limit : float
        Greatest difference that is allowed, by the size of an output.
    counted : str
        Which outputs the limit is for: `all`, or `gas`, pressures and masses.
    seconds : float or None
        Of the run alone; None where it was not run.
    greatest : float or None
        Greatest difference of an output that counts, by its size.
    worst : str
        That output.
    differences : dict
        Address of every output to its greatest difference, by its size.
    why : Note or None
        Why it was not run.
    rounding : float
        Ten times what a start that is moved by 1e-14 becomes in that output.
    """

    name: str
    what: str
    limit: float
    counted: str
    seconds: float | None
    greatest: float | None
    worst: str
    differences: dict[str, float]
    why: Note | None = None
    rounding: float = 0.0

    @property
    def is_well(self) -> bool:
        """False where it was run and is further from the kernel than its limit and than rounding."""
        return self.greatest is None or self.greatest <= max(self.limit, self.rounding)


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


def parity(circuit: Circuit, *, only: Sequence[str] = ()) -> Parity:
    """Run a circuit by every target, and compare each with the kernel.

    Parameters
    ----------
    circuit : Circuit
        With a duration.
    only : sequence of str, optional
        Names of targets; default all.

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
            raise InputError("deploy.parity.unknown", name, near=Near(name, known))
    reference = _reference(circuit)
    with tempfile.TemporaryDirectory() as folder:
        rounding = differences_of(targets.kernel_moved(reference, Path(folder)), reference)
        chosen = [each for each in TARGETS if not only or each.name in only]
        rows = tuple(_row(each, reference, Path(folder), rounding) for each in chosen)
    sizes = dict(zip(reference.names, reference.sizes.tolist(), strict=True))
    run = reference.run
    return Parity(circuit.title, run.reached, reference.seconds, run.accepted, sizes, rows)


def _reference(circuit: Circuit) -> Reference:
    circuit.simulate()  # what fails says so here; and everything is compiled
    problem = circuit.problem(circuit.run)
    seconds = []
    for _ in range(3):
        began = time.perf_counter()
        run = solve(problem)
        seconds.append(time.perf_counter() - began)
    model = problem.kernel.model
    nominal = {state.name: state.nominal for state in model.states}
    sizes = np.abs(run.values).max(axis=1, initial=0.0)
    sizes = np.array([max(size, nominal.get(name, 0.0)) for name, size in zip(model.columns[0], sizes, strict=True)])
    return Reference(circuit, problem, run, min(seconds), sizes)


def _row(target: Target, reference: Reference, folder: Path, rounding: Mapping[str, float]) -> Row:
    about = target.name, target.what, target.limit, target.of
    try:
        found = target.run(reference, folder)
    except NotRun as reason:
        return Row(*about, None, None, "", {}, reason.note)
    differences = dict(found.differences or differences_of(found, reference))
    gas = {state.name for state in reference.problem.kernel.model.states if state.positive}
    counted = {name: value for name, value in differences.items() if target.of == "all" or name in gas}
    # Each output may differ by what rounding alone becomes in it.
    grown = {name: GROWN * rounding.get(name, 0.0) for name in counted}
    allowed = {name: max(target.limit, grown[name]) if np.isfinite(target.limit) else 1.0 for name in counted}
    worst = max(counted, key=lambda name: counted[name] / allowed[name], default="")
    return Row(*about, found.seconds, counted.get(worst, 0.0), worst, differences, rounding=grown.get(worst, 0.0))


def differences_of(found: Found, reference: Reference) -> dict[str, float]:
    """Greatest difference of every output from the kernel's, by its size; something that is no number is infinite."""
    # The last row of a run that a condition ends lies where each target finds it, and one on which an instant falls is
    # before it for the kernel and after it for others.
    n = min(found.values.shape[1], reference.run.time.size)
    n -= n < reference.problem.grid.size or bool(reference.problem.kernel.model.memory)
    apart = np.abs(found.values[:, :n] - reference.run.values[:, :n]).max(axis=1, initial=0.0)
    by_size = np.divide(apart, reference.sizes, out=apart.copy(), where=reference.sizes > 0.0)
    by_size = np.where(np.isfinite(by_size), by_size, np.inf)
    return dict(zip(reference.names, by_size.tolist(), strict=True))
