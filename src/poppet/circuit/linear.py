"""States at rest and linear models of a circuit, by exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import LinearModel, SteadyState
from poppet.circuit.sampled.model import sampled_model
from poppet.circuit.sampled.rest import sampled_steady_state
from poppet.engine.model import Model
from poppet.engine.problem import Outcome, Problem, RawRun
from poppet.engine.solve import solve
from poppet.ground.errors import InputError, SimulationError
from poppet.series.recording import Recording

__all__ = ["LinearModel", "SteadyState", "linearise", "steady_state"]

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 1e3, 1e5, 1e7, 1e9)
"""Lengths of transient tried one after the other; what still moves after thirty years has no state at rest [s]."""
TRANSIENT_TOLERANCE = 1e-8
TRANSIENT_STEPS = 100_000
SLOWED = 1e-4
"""Rate of gas and walls, per their own, where a transient hunts: fast mechanics follow them without oscillation."""
SLOWED_STEPS = 10_000
AT_REST = 1e-10
"""Rate of change at rest, per size of a state [1/s]; rounding of the rates is granted on top."""
ROUNDING = 1e3 * np.finfo(float).eps
NEWTON_STEPS, HALVINGS = 50, 12
SINGULAR = 1e-11
"""Singular values of the scaled Jacobian below this part of the largest one belong to conserved quantities."""


def steady_state(instance: Instance, inputs: Mapping[str, Any] | None = None) -> SteadyState:
    """See `Circuit.steady_state`."""
    u = instance.held_inputs(inputs or {})
    if instance.model.memory:
        return sampled_steady_state(instance, u)
    point = _Point(instance, u)
    x, duration, run = _settled(point)
    found = f"At rest after a transient of {duration:.3g} s and Newton's method."
    if run.outcome is Outcome.TOO_MANY:
        x = _slowed(point)
        found = (
            f"The transient oscillates for {duration:.3g} s and on; found with the gas slowed down. It may be unstable."
        )
    x = _polished(point, x)
    residual, allowed = point.residual(x)
    if not np.all(residual <= allowed):
        raise SimulationError(_restless(point, x, residual, duration, run))
    inputs_used = dict(zip(point.names, point.u.tolist(), strict=True))
    return SteadyState(x, point.outputs(x), inputs_used, float(np.max(residual, initial=0.0)), found)


def linearise(
    instance: Instance, inputs: Mapping[str, Any] | None = None, *, at: Recording | None = None
) -> LinearModel:
    """See `Circuit.linearise`."""
    if instance.model.memory:
        if at is not None:
            raise InputError(
                f"at = {at.title or 'a recording'!r}", "does not hold the memory of a sampled circuit.",
                "Linearise at rest: leave it out.",
            )  # fmt: skip
        rest = steady_state(instance, inputs)
        return sampled_model(instance, rest)
    if at is None:
        rest = steady_state(instance, inputs)
        return _linear_model(_Point(instance, np.array(list(rest.u.values()))), rest.x)
    units = {item.name: item.unit for item in instance.model.inputs if item.name in at}
    recorded = at.select(units).converted(units).last() if units else {}
    start = instance.resume(at)
    point = _Point(start, start.held_inputs(recorded | dict(inputs or {})))
    return _linear_model(point, point.start)


class _Point:
    """A circuit with held inputs: its rates, outputs and derivatives."""

    def __init__(self, instance: Instance, u: Array) -> None:
        self.kernel, self.u = instance.kernel, u
        self.model: Model = instance.model
        self.names, self.p = instance.input_names, instance.numbers()
        self.n = len(self.model.states)
        self.start: Array = self.kernel.start(self.p)[: self.n]
        # Only what must stay positive has its size in its first value: a stroke may begin at a nanometre.
        nominal = np.array([state.nominal for state in self.model.states])
        positive = np.array([state.positive for state in self.model.states], dtype=bool)
        self.size = np.where(positive, np.abs(self.start), nominal)
        self._function = self.model.linear_functions()

    def linear(self, x: Array) -> list[Array]:
        """f, y, A, B, C, D."""
        found = self._function(0.0, self.padded(x), self.u, self.p)
        shapes = [(self.n,), (len(self.model.outputs),)]
        return [value.full().reshape(shape) for value, shape in zip(found[:2], shapes, strict=True)] + [
            value.full() for value in found[2:]
        ]

    def padded(self, x: Array) -> Array:
        """States with quadratures of zero behind them."""
        return np.concatenate([x, np.zeros(self.model.n_quadratures)])

    def outputs(self, x: Array) -> dict[str, float]:
        """Outputs by address."""
        return dict(zip(self.model.columns[0], self.linear(x)[1].tolist(), strict=True))

    def scaled(self, x: Array) -> tuple[Array, Array]:
        """Rates and Jacobian of the states in units of their sizes."""
        f, _, jacobian, *_ = self.linear(x)
        return f / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def residual(self, x: Array) -> tuple[Array, Array]:
        """Rate of each state per size, and what of it counts as rest [1/s]."""
        f, jacobian = self.scaled(x)
        return np.abs(f), AT_REST + ROUNDING * np.abs(jacobian) @ (np.abs(x) / self.size)

    def is_at_rest(self, x: Array) -> bool:
        """True when no state changes any more."""
        residual, allowed = self.residual(x)
        return bool(np.all(residual <= allowed))


def _settled(point: _Point) -> tuple[Array, float, RawRun]:
    """The end of the first transient that rests or fails, or of the longest one.

    Each begins at the initial state: the absolute tolerances of a run follow the sizes of its first state, and those of
    a state nearly at rest mean nothing.
    """
    for duration in TRANSIENTS:
        run = _transient(point, duration)
        x = run.x[: point.n]
        if not run.outcome.is_success or point.is_at_rest(x):
            break
    return x, duration, run


def _transient(point: _Point, duration: float) -> RawRun:
    held = np.zeros((1, max(1, point.u.size), 6))
    held[0, : point.u.size, 0] = point.u
    problem = Problem(
        point.kernel, point.p, point.padded(point.start), np.zeros(1), held, np.zeros(1, dtype=bool),
        np.array([duration]), TRANSIENT_TOLERANCE, most_attempts=TRANSIENT_STEPS,
    )  # fmt: skip
    return solve(problem)


def _slowed(point: _Point) -> Array:
    """Where a circuit comes to when its gas moves slowly against its mechanics; rests are the same."""
    from scipy.integrate import Radau

    rate = np.where([state.positive for state in point.model.states], SLOWED, 1.0)
    method = Radau(
        lambda _, z: rate * point.scaled(z * point.size)[0], 0.0, point.start / point.size, TRANSIENTS[-1],
        jac=lambda _, z: rate[:, None] * point.scaled(z * point.size)[1], rtol=1e-6, atol=1e-9,
    )  # fmt: skip
    for _ in range(SLOWED_STEPS):
        if method.status == "running":
            method.step()
    return np.asarray(method.y) * point.size


def _polished(point: _Point, x: Array) -> Array:
    """Newton's method, with steps halved until they lower the rates and keep positive states positive."""
    for _ in range(NEWTON_STEPS):
        f, jacobian = point.scaled(x)
        if not np.all(np.isfinite(jacobian)):
            break
        lower = _lowered(point, x, _conserving_step(f, jacobian) * point.size, np.max(np.abs(f), initial=0.0))
        if lower is None:
            break
        x = lower
    return x


def _lowered(point: _Point, x: Array, step: Array, rate: float) -> Array | None:
    """A state along a Newton step at which the largest rate is lower, or None."""
    positive = np.array([state.positive for state in point.model.states], dtype=bool)
    for halvings in range(HALVINGS):
        trial = x + step * 0.5**halvings
        if np.all(trial[positive] > 0.0) and np.max(np.abs(point.scaled(trial)[0]), initial=0.0) < rate:
            return trial
    return None


def _conserving_step(f: Array, jacobian: Array) -> Array:
    """The Newton step that leaves alone what the Jacobian says is conserved (its left null space)."""
    if not f.size:
        return f
    left, singular, _ = np.linalg.svd(jacobian)
    conserved = left[:, singular <= SINGULAR * singular[0]].T
    step: Array = np.linalg.lstsq(
        np.vstack([jacobian, conserved * singular[0]]), np.concatenate([-f, np.zeros(len(conserved))]), rcond=SINGULAR
    )[0]
    return step


def _restless(point: _Point, x: Array, residual: Array, duration: float, run: RawRun) -> str:
    """Why there is no state at rest, for a person."""
    worst = int(np.argmax(residual))
    state = point.model.states[worst]
    rate = float(point.linear(x)[0][worst])
    moving = f"{state.name} = {x[worst]:.6g} {state.unit} still changes by {rate:.3g} {state.unit} per second"
    if run.outcome is Outcome.TOO_MANY:
        cure = "It oscillates: see simulate(), add damping, or linearise where a recording ends (at=...)."
    elif not run.outcome.is_success:
        cure = "A flow source may be drawing an empty store: give it gas from elsewhere, or hold its flow at zero."
    else:
        cure = "Something feeds or drains a store for ever: close it, vent it, or linearise at a recording (at=...)."
    return f"The circuit comes to no rest: within {duration:.3g} s {moving}. {cure}"


def _linear_model(point: _Point, x: Array) -> LinearModel:
    f, y, a, b, c, d = point.linear(x)
    names = tuple(state.name for state in point.model.states), point.names, point.model.columns[0]
    return LinearModel(a, b, c, d, *names, x, point.u, y, f)
