"""States at rest and linear models of a circuit, by exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import LinearModel, SteadyState
from poppet.circuit.newton import polished, residual_of
from poppet.circuit.sampled.sampled_model import sampled_model
from poppet.circuit.sampled.sampled_steady_state import sampled_steady_state
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.engine.model_evaluation import Evaluation
from poppet.engine.problem import Outcome, RawRun, held_problem
from poppet.engine.solve import solve
from poppet.timeseries.recording import Recording

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 1e3, 1e5, 1e7, 1e9)
"""Lengths of transient tried one after the other; what still moves after thirty years has no state at rest [s]."""
TRANSIENT_TOLERANCE = 1e-8
TRANSIENT_STEPS = 100_000
SLOWED = 1e-4
"""Rate of gas and walls, per their own, where a transient hunts: fast mechanics follow them without oscillation."""
SLOWED_STEPS = 2_000


def steady_state(instance: Instance, inputs: Mapping[str, Any] | None = None) -> SteadyState:
    """See `Circuit.steady_state`."""
    u = instance.held_inputs(inputs or {})
    if instance.model.memory:
        return sampled_steady_state(instance, u)
    point = _Point(instance, u)
    x, duration, run = _settled(point)
    how = Note("rest.settled", duration=duration)
    if run.outcome is Outcome.TOO_MANY and not np.all(point.positive):
        # It hunts: the fast mechanics never come to rest on their own, though a rest exists.
        x, how = _slowed(point), Note("rest.slowed", duration=duration)
    x = polished(point.scaled, x, point.size, point.positive, conserves=True)
    # Newton may have stopped anywhere; what counts is whether anything still moves.
    residual, allowed = residual_of(point.scaled, x, point.size)
    if not np.all(residual <= allowed):
        raise SimulationError(_restless(point, x, residual, duration, run))
    y = dict(zip(point.model.columns[0], point.linear(x)[1].tolist(), strict=True))
    inputs_used = dict(zip(instance.input_names, u.tolist(), strict=True))
    return SteadyState(x, y, inputs_used, float(np.max(residual, initial=0.0)), (how,))


def linearise(
    instance: Instance, inputs: Mapping[str, Any] | None = None, *, at: Recording | None = None
) -> LinearModel:
    """See `Circuit.linearise`."""
    if instance.model.memory:
        if at is not None:
            raise InputError("linear.no_memory", title=at.title or "a recording")
        return sampled_model(instance, steady_state(instance, inputs))
    if at is None:
        rest = steady_state(instance, inputs)
        return _Point(instance, np.array(list(rest.u.values()))).linear_model(rest.x)
    units = {item.name: item.unit for item in instance.model.inputs if item.name in at}
    recorded = at.select(units).converted(units).last() if units else {}
    # Inputs are held as they were when the recording ended, but for those that are given.
    start = instance.resumed(at)
    point = _Point(start, start.held_inputs(recorded | dict(inputs or {})))
    # No search for a rest: the slopes are wanted where the recording ends, at rest or not.
    return point.linear_model(point.start)


class _Point:
    """An instance with held inputs: its rates, outputs and derivatives at any state x, (n,), without quadratures."""

    def __init__(self, instance: Instance, u: Array) -> None:
        self.kernel, self.model, self.u = instance.kernel, instance.model, u
        whole, self.p = instance.start()
        self.start: Array = whole[: len(self.model.states)]
        self.positive = self.kernel.positive
        # Only what must stay positive has its size in its first value: a stroke may begin at a nanometre.
        nominal = np.array([state.nominal for state in self.model.states])
        self.size = np.where(self.positive, np.abs(self.start), nominal)
        self._function = Evaluation(self.model.linear_function)

    def linear(self, x: Array) -> list[Array]:
        """f, y, A, B, C, D."""
        f, y, *matrices = self._function(0.0, self.padded(x), self.u, self.p)
        return [f.ravel(), y.ravel(), *matrices]

    def padded(self, x: Array) -> Array:
        """States with quadratures of zero behind them."""
        return np.concatenate([x, np.zeros(self.model.n_quadratures)])

    def scaled(self, x: Array) -> tuple[Array, Array]:
        """Rates and Jacobian of the states in units of their sizes."""
        f, _, jacobian, *_ = self.linear(x)
        return f / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def linear_model(self, x: Array) -> LinearModel:
        """The linear model at a state."""
        f, y, a, b, c, d = self.linear(x)
        names = tuple(s.name for s in self.model.states), tuple(i.name for i in self.model.inputs)
        return LinearModel(a, b, c, d, *names, self.model.columns[0], x, self.u, y, f)


def _settled(point: _Point) -> tuple[Array, float, RawRun]:
    """The end of the first transient that rests or fails, or of the longest one.

    Each begins at the initial state: the absolute tolerances of a run follow the sizes of its first state, and those of
    a state nearly at rest mean nothing.
    """
    limits = {"relative_tolerance": TRANSIENT_TOLERANCE, "most_attempts": TRANSIENT_STEPS}
    for duration in TRANSIENTS:
        begin = point.padded(point.start)
        run = solve(held_problem(point.kernel, point.p, begin, point.u, np.array([duration]), **limits))
        x = run.x[: point.start.size]
        if not run.outcome.is_success:
            break
        residual, allowed = residual_of(point.scaled, x, point.size)
        if np.all(residual <= allowed):
            break
    return x, duration, run


def _slowed(point: _Point) -> Array:
    """Where a circuit comes to when its gas moves slowly against its mechanics; rests are the same."""
    from scipy.integrate import Radau

    rate = np.where(point.positive, SLOWED, 1.0)
    method = Radau(
        lambda _, z: rate * point.scaled(z * point.size)[0], 0.0, point.start / point.size, TRANSIENTS[-1],
        jac=lambda _, z: rate[:, None] * point.scaled(z * point.size)[1], rtol=1e-6, atol=1e-9,
    )  # fmt: skip
    # Radau is stepped by hand, for `solve_ivp` would keep every step and has no limit of them.
    for _ in range(SLOWED_STEPS):
        if method.status == "running":
            method.step()
    return np.asarray(method.y) * point.size


def _restless(point: _Point, x: Array, residual: Array, duration: float, run: RawRun) -> Note:
    """Why there is no state at rest."""
    worst = int(np.argmax(residual))
    state = point.model.states[worst]
    facts = {"value": float(x[worst]), "unit": state.unit, "rate": float(point.linear(x)[0][worst])}
    if run.outcome is Outcome.TOO_MANY:
        return Note("rest.oscillates", state.name, duration=duration, **facts)
    if not run.outcome.is_success:
        return Note("rest.emptied", state.name, duration=duration, **facts)
    return Note("rest.endless", state.name, duration=duration, **facts)
