"""Runs of circuits with FMUs: the circuit is the hub of a co-simulation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.notes import make_recording
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.cosim.fmu_slave import FmuFailure, FmuSetup
from poppet.cosim.master import MAX_PASSES, Master, Report, StepSizes, start_slaves
from poppet.engine.call import Call
from poppet.engine.problem import Outcome, Problem, RawRun, ending, is_failure
from poppet.timeseries.recording import Recording

if TYPE_CHECKING:
    from poppet.circuit.instance import Instance
    from poppet.engine.model import Model
    from poppet.parts.fmu import FMU

Array = NDArray[np.float64]


class CoupledVariables(NamedTuple):
    """Outputs y and inputs u of all FMUs in the model of their circuit."""

    addresses: tuple[str, ...]  # of y
    of_y: NDArray[np.int64]  # inputs of the model that are y
    columns_of_y: NDArray[np.int64]  # outputs of the model that are y
    of_u: NDArray[np.int64]  # outputs of the model that are u
    used: NDArray[np.bool_]  # True for a y that acts on the circuit or on an FMU
    is_held: NDArray[np.bool_]  # True for a y that keeps its value in a communication step

    @classmethod
    def of(cls, model: Model, fmus: Mapping[str, FMU], connections: Mapping[str, str]) -> CoupledVariables:
        """Return the variables of FMUs by name, with the connections of the circuit."""
        names = {item.name: k for k, item in enumerate(model.inputs)}
        columns = {name: k for k, (name, _) in enumerate(model.outputs)}
        outputs = [(f"{name}.{v.local}", part, v) for name, part in fmus.items() for v in part.description.outputs]
        inputs = [f"{name}.{v.local}" for name, part in fmus.items() for v in part.description.inputs]
        addresses, sources = tuple(address for address, _, _ in outputs), set(connections.values())
        return cls(
            addresses,
            np.array([names[address] for address in addresses], dtype=np.int64),
            np.array([columns[address] for address in addresses], dtype=np.int64),
            np.array([columns[address] for address in inputs], dtype=np.int64),
            np.array([address in sources for address in addresses], dtype=np.bool_),
            np.array([part.coupling == "sampled" or not v.is_continuous for _, part, v in outputs], dtype=np.bool_),
        )

    def start_numbers(self, y: Array) -> dict[str, float]:
        """Return the parameters with the values of y at the start, by address."""
        owners = (address.partition(".") for address in self.addresses)
        return {f"{name}.start.{local}": float(v) for (name, _, local), v in zip(owners, y, strict=True)}

    def start_values(self, numbers: Mapping[str, float]) -> Array:
        """Return the values of y at the start from the parameters of the circuit."""
        return np.array([numbers[key] for key in self.start_numbers(np.zeros(len(self.addresses)))])


class CircuitHub:
    """Circuit whose inputs include the outputs of FMUs, and whose outputs include their inputs.

    `fmus` contains the FMU parts by name, and `connections` those of the circuit.
    """

    def __init__(
        self, instance: Instance, problem: Problem, fmus: Mapping[str, FMU], connections: Mapping[str, str]
    ) -> None:  # fmt: skip
        self.instance, self.problem = instance, problem
        self.variables = CoupledVariables.of(problem.kernel.model, fmus, connections)
        self.used = self.variables.used
        self.x, self.p = problem.x0.copy(), problem.p.copy()
        self._rows, self._times = list[Array](), list[float]()
        self._extremes = np.stack([self.x, self.x])
        self._through, self._counts = np.zeros(self.x.size), [0, 0]
        self._candidate: tuple[Call, RawRun, float, Array] | None = None
        self.outcome, self.stop = Outcome.DONE, -1
        self._passive = replace(problem, stop_conditions=())

    # Interface of the master -------------------------------------------------------------------------------------

    def initial_inputs(self, y: Array) -> Array:
        """Return the inputs of the FMUs at t = 0 for given outputs."""
        problem, model = self.problem, self.problem.kernel.model
        x, p = self._start(y)
        u = np.zeros(max(1, len(model.inputs)))
        level, _, wave, _, _, phase, _ = problem.coefficients[problem.courses[0]].T
        u[: level.size] = level + wave * np.sin(phase)
        u[self.variables.of_y] = y
        outputs = np.empty(len(model.outputs))
        problem.kernel.call("outputs", np.zeros(1), x, u, p, outputs)
        return outputs[self.variables.of_u]

    def start(self, y: Array) -> None:
        """Start at t = 0 with the outputs of the FMUs."""
        self.x, self.p = self._start(y)
        # The balances refer to the initial state.
        self.problem = replace(self.problem, x0=self.x.copy(), p=self.p.copy())
        self._extremes = np.stack([self.x, self.x])

    def _start(self, y: Array) -> tuple[Array, Array]:
        return self.instance.with_numbers(self.variables.start_numbers(y)).start()

    def advance(self, begin: float, end: float, first: Array, y: Array) -> Array:
        """Advance from the last accepted point; return the inputs of the FMUs at three points of the step."""
        problem, middle = self._piece(self._passive, begin, end, first, y)
        call = Call(problem)
        raw = call.run()
        self._candidate = call, raw, end, y[-1]
        if raw.outcome is not Outcome.DONE:
            # The master accepts it, which ends the run.
            known = raw.values[:, -1] if raw.time.size else np.zeros(raw.values.shape[0])
            return np.tile(np.nan_to_num(known[self.variables.of_u]), (3, 1))
        return raw.values[self.variables.of_u][:, [0, middle, -1]].T

    def accept(self) -> bool:
        """Accept the last advance, with the stop conditions of the run."""
        assert self._candidate is not None
        call, raw, end, y = self._candidate
        if self.problem.stop_conditions:
            call = Call(replace(call.problem, stop_conditions=self.problem.stop_conditions))
            raw = call.run()
        self._store(raw, end, y)
        self.x = raw.x.copy()
        if call.problem.kernel.model.memory:
            self.p = call.p.copy()
        self.outcome, self.stop = raw.outcome, raw.stop
        return raw.outcome is Outcome.DONE

    def _piece(self, problem: Problem, begin: float, end: float, first: Array, y: Array) -> tuple[Problem, int]:
        """Return the problem of one communication step, with the segments of the signals in it.

        The second result is the index of the middle of the step in its output times.
        """
        half = 0.5 * (end - begin)
        middle = begin + half
        inner = problem.starts[
            np.searchsorted(problem.starts, begin, side="right") : np.searchsorted(problem.starts, end, side="left")
        ]
        # A start that differs from the middle only by rounding would give an empty segment.
        inner = inner[np.abs(inner - middle) > 1e-9 * half]
        starts = np.sort(np.concatenate([[begin, middle], inner]))
        segments = np.searchsorted(problem.starts, starts + 1e-9 * half, side="right") - 1
        coefficients = problem.coefficients[problem.courses[segments]].copy()
        is_second = starts >= middle
        halves = step_course(begin, end, first, y, self.variables.is_held)
        for is_in_half, course in zip((~is_second, is_second), halves, strict=True):
            coefficients[np.ix_(is_in_half.nonzero()[0], self.variables.of_y)] = course
        jumps = problem.jumps[segments] & np.isin(starts, inner)
        grid = problem.grid
        rows = grid[np.searchsorted(grid, begin, side="right") : np.searchsorted(grid, end, side="left")]
        rows = np.unique(np.concatenate([[begin, middle, end], rows]))
        piece = replace(
            problem, x0=self.x, p=self.p, starts=starts, courses=np.arange(starts.size, dtype=np.int64),
            coefficients=np.ascontiguousarray(coefficients), jumps=jumps, grid=rows,
        )  # fmt: skip
        return piece, int(np.searchsorted(rows, middle))

    # Results -----------------------------------------------------------------------------------------------------

    def _store(self, raw: RawRun, end: float, y: Array) -> None:
        """Keep the output rows of an accepted step, at whose end the FMUs have the outputs y."""
        grid, last = self.problem.grid, self.problem.grid[-1]
        requested = np.isin(raw.time, grid)
        for column, time in enumerate(raw.time.tolist()):
            is_last = column == raw.time.size - 1 and (raw.outcome is Outcome.STOPPED or end == last)
            # The value at the end of a step is that at the start of the next one, after jumps.
            if not is_last and (not requested[column] or time >= end):
                continue
            row = raw.values[:, column].copy()
            if time == end:
                row[self.variables.columns_of_y] = y
            self._rows.append(row)
            self._times.append(time)
        low, high = self._extremes
        self._extremes = np.stack([np.minimum(low, raw.extremes[0]), np.maximum(high, raw.extremes[1])])
        self._through = self._through + raw.through
        self._counts = [self._counts[0] + raw.accepted, self._counts[1] + raw.rejected]

    def result(self, outcome: Outcome) -> RawRun:
        """Return the accepted steps as the result of a solver."""
        count = len(self.problem.kernel.model.outputs)
        values = np.stack(self._rows, axis=1) if self._rows else np.empty((count, 0))
        return RawRun(
            outcome,
            np.array(self._times),
            values,
            self.x,
            self._extremes,
            self._through,
            self._counts[0],
            self._counts[1],
            self.stop,
        )


def step_course(begin: float, end: float, first: Array, y: Array, is_held: NDArray[np.bool_]) -> Array:
    """Return the coefficients of the outputs of FMUs in both halves of a communication step, (2, n, 7).

    Each half is the chord of the parabola through `first` and the rows of `y`, plus half a sine with the area between
    them. Outputs in the mask `is_held` keep the value `first`.
    """
    half = 0.5 * (end - begin)
    bow = np.where(is_held, 0.0, np.pi / 12.0 * (y[0] - 0.5 * (first + y[1])))
    zero = np.zeros(first.size)
    halves = []
    for origin, left, right in ((begin, first, y[0]), (begin + half, y[0], y[1])):
        slope = np.where(is_held, 0.0, (right - left) / half)
        course = [np.where(is_held, first, left), slope, bow, zero + 0.5 / half, zero, zero, zero + origin]
        halves.append(np.stack(course, axis=1))
    return np.stack(halves)


def run_coupled(
    circuit: Any, run: Any, *, allow_native: bool, progress: Callable[[float], Any] | None, throw: bool
) -> Recording:
    """Simulate a circuit with FMUs.

    The arguments are those of `Circuit.simulate`. Without `allow_native`, an error is raised before any native code is
    loaded.
    """
    fmus: Mapping[str, FMU] = circuit.fmus
    if not allow_native:
        require_permission(circuit)
    problem = circuit.run_data(run)
    steps = communication_steps(circuit, run, problem)
    hub = CircuitHub(circuit.unguarded_instance, problem, fmus, circuit.connections)
    failure, outcome, report = None, None, Report()
    try:
        with ExitStack() as stack:
            tolerance = problem.relative_tolerance
            master = Master(start_slaves(stack, fmu_setups(circuit, tolerance)), hub, tolerance)
            report = master.report
            master.initialise(hub.variables.start_values(circuit.parameters))
            master.run(steps, progress)
    except FmuFailure as error:
        failure = error.note
    except KeyboardInterrupt:
        if progress is None:
            raise
        outcome = Outcome.INTERRUPTED
    raw = hub.result(outcome or (Outcome.INTERRUPTED if failure or report.end else hub.outcome))
    solved = make_recording(circuit.unguarded_instance, hub.problem, raw)
    own = (*fmu_notes(circuit), *one_pass_notes(circuit, steps.step), *agreement_notes(report))
    fields: dict[str, Any] = solved.fields()
    fields["notes"] = lambda: (*solved.remarks, *own)
    fields["statistics"] = {
        **solved.statistics, "communication_steps": report.steps, "communication_passes": report.passes
    }  # fmt: skip
    if failure or report.end:
        fields["outcome"] = failure or report.end
    recording = Recording(**fields)
    if throw and report.end is None and is_failure(hub.problem, raw):
        raise SimulationError(failure or ending(hub.problem, raw), recording)
    return recording


def require_permission(circuit: Any) -> None:
    """Raise an error if a circuit has an FMU, whose native code nobody has permitted."""
    for name, part in circuit.fmus.items():
        raise InputError("fmu.native", f"parts.{name}", path=part.path)


def fmu_setups(circuit: Any, tolerance: float) -> list[FmuSetup]:
    """Return the FMUs of a circuit with the values of their parameters. `tolerance` is that of the run."""
    numbers = circuit.parameters
    return [part.setup(name, _of_part(numbers, name), tolerance) for name, part in circuit.fmus.items()]


def _of_part(numbers: Mapping[str, float], name: str) -> dict[str, float]:
    prefix = f"{name}."
    return {key.removeprefix(prefix): value for key, value in numbers.items() if key.startswith(prefix)}


def _outputs(fmus: Mapping[str, FMU]) -> Iterator[tuple[str, Any]]:
    for name, part in fmus.items():
        for variable in part.description.outputs:
            yield name, variable


def communication_steps(circuit: Any, run: Any, problem: Problem) -> StepSizes:
    """Return the communication points of a run: steps of the shortest `step` of all FMUs."""
    if run.solver != "rosenbrock":
        raise InputError("fmu.solver", "run.solver", value=run.solver)
    grid = problem.grid
    output_step = float(grid[1] - grid[0]) if grid.size > 1 else float(grid[-1])
    duration = float(grid[-1])
    steps = StepSizes.of(min(*requested_steps(circuit, output_step), duration), duration, grid)
    rigid = next((n for n, part in circuit.fmus.items() if not part.description.has_variable_step), None)
    if rigid is not None and not steps.has_equal_steps:
        raise InputError("fmu.constant_step", "run.duration", duration=duration, step=steps.step, part=rigid)
    return steps


def requested_steps(circuit: Any, default: float) -> list[float]:
    """Return the communication step of each FMU [s]: that of the circuit, of the FMU, or the default."""
    return [
        circuit.parameters.get(f"{name}.step") or part.description.step or default
        for name, part in circuit.fmus.items()
    ]  # fmt: skip


def one_pass_notes(circuit: Any, step: float) -> Iterator[Note]:
    """Yield notes on FMUs that cannot repeat a step. `step` is the communication step [s]."""
    for name, part in circuit.fmus.items():
        is_continuous = part.coupling != "sampled" and part.description.outputs and part.description.inputs
        if is_continuous and not part.description.can_roll_back:
            yield Note("fmu.one_pass", name, step=step)


def agreement_notes(report: Report) -> Iterator[Note]:
    """Yield a note on the communication steps whose values did not agree."""
    if report.not_converged:
        yield Note(
            "fmu.not_converged", report.worst, count=report.not_converged, steps=report.steps, most=MAX_PASSES,
            time=report.first_time,
        )  # fmt: skip


def fmu_notes(circuit: Any) -> Iterator[Note]:
    """Yield notes on FMUs that are known before a run: loops of direct dependences."""
    loop = find_loop(circuit.symbolic_model, circuit.fmus) if circuit.fmus else []
    if loop:
        parts = {address.partition(".")[0] for address in loop}
        can_iterate = all(circuit.fmus[name].description.can_roll_back for name in parts)
        yield Note("fmu.loop", "", names=loop, can_iterate=can_iterate, cannot_iterate=not can_iterate)


def find_loop(model: Model, fmus: Mapping[str, FMU]) -> list[str]:
    """Return the addresses of FMU variables that depend on each other without a state, or an empty list.

    An output of an FMU that states no dependences depends on all its inputs, as FMI defines.
    """
    import casadi as ca

    inputs = {item.name: k for k, item in enumerate(model.inputs)}
    outputs = {name: k for k, (name, _) in enumerate(model.outputs)}
    sparsity = ca.jacobian_sparsity(model.expressions["outputs"], model.symbols["u"]) if inputs else None
    dependences: dict[str, set[str]] = {}
    for name, part in fmus.items():
        description = part.description
        for v in description.outputs:
            stated = description.feedthrough.get(v.array)
            dependences[f"{name}.{v.local}"] = {
                f"{name}.{u.local}" for u in description.inputs if stated is None or u.array in stated
            }
        for u in description.inputs:
            row = outputs[f"{name}.{u.local}"]
            dependences[f"{name}.{u.local}"] = {
                f"{n}.{v.local}"
                for n, v in _outputs(fmus)
                if sparsity is not None and sparsity.has_nz(row, inputs[f"{n}.{v.local}"])
            }
    try:
        TopologicalSorter(dependences).prepare()
    except CycleError as error:
        return [*dict.fromkeys(error.args[1])]
    return []
