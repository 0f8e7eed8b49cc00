"""Computation of steady states and linear models of a circuit, with exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import LinearModel, SteadyState
from poppet.circuit.newton import refine_steady_state, scaled_residual
from poppet.circuit.sampled.sampled_model import sampled_model
from poppet.circuit.sampled.sampled_steady_state import find_sampled_steady_state
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.engine.model_evaluation import ArrayFunction
from poppet.engine.problem import Outcome, constant_input_problem
from poppet.engine.solve import solve
from poppet.timeseries.recording import Recording

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 1e3, 1e5, 1e7, 1e9)
"""Durations of the successive transients [s].

A circuit that still changes after the longest one, thirty years, has no steady state."""
TRANSIENT_TOLERANCE = 1e-8
TRANSIENT_STEPS = 100_000
SLOW_GAS = 1e-4
"""Factor on the rates of gas and walls if a transient oscillates without end.

Fast mechanics follow slow gas without oscillation."""
SLOW_GAS_STEPS = 2_000


def steady_state(instance: Instance, inputs: Mapping[str, Any] | None = None) -> SteadyState:
    """Return the steady state of an instance with constant inputs.

    The public method `Circuit.steady_state` describes the method and the arguments.
    """
    u = instance.held_inputs(inputs or {})
    if instance.model.memory:
        return find_sampled_steady_state(instance, u)
    point = _LinearisationPoint(instance, u)
    limits = {"relative_tolerance": TRANSIENT_TOLERANCE, "most_attempts": TRANSIENT_STEPS}
    for duration in TRANSIENTS:
        # Each transient begins at the initial state: the absolute tolerances of a run depend on its first state.
        start = point.padded(point.start)
        run = solve(constant_input_problem(point.kernel, point.p, start, point.u, np.array([duration]), **limits))
        x = run.x[: point.start.size]
        if not run.outcome.is_success:
            break
        residual, limit = scaled_residual(point.scaled, x, point.size)
        if np.all(residual <= limit):
            break
    method = Note("rest.settled", duration=duration)
    if run.outcome is Outcome.TOO_MANY and not np.all(point.positive):
        from scipy.integrate import Radau

        # The circuit hunts: the fast mechanics do not settle, although a steady state exists.
        # Slower gas dynamics do not change the steady states, and do not excite the mechanics.
        rate = np.where(point.positive, SLOW_GAS, 1.0)
        transient = Radau(
            lambda _, z: rate * point.scaled(z * point.size)[0], 0.0, point.start / point.size, TRANSIENTS[-1],
            jac=lambda _, z: rate[:, None] * point.scaled(z * point.size)[1], rtol=1e-6, atol=1e-9,
        )  # fmt: skip
        # Not `solve_ivp`, which stores all steps and has no limit of steps.
        for _ in range(SLOW_GAS_STEPS):
            if transient.status == "running":
                transient.step()
        x, method = np.asarray(transient.y) * point.size, Note("rest.slowed", duration=duration)
    x = refine_steady_state(point.scaled, x, point.size, point.positive, conserves=True)
    # Newton's method can stop early: the residual decides.
    residual, limit = scaled_residual(point.scaled, x, point.size)
    if not np.all(residual <= limit):
        worst = int(np.argmax(residual))
        state = point.model.states[worst]
        facts = {"value": float(x[worst]), "unit": state.unit, "rate": float(point.linear(x)[0][worst])}
        code = "rest.endless" if run.outcome.is_success else "rest.emptied"
        code = "rest.oscillates" if run.outcome is Outcome.TOO_MANY else code
        raise SimulationError(Note(code, state.name, duration=duration, **facts))
    y = dict(zip(point.model.columns[0], point.linear(x)[1].tolist(), strict=True))
    inputs_used = dict(zip(instance.input_names, u.tolist(), strict=True))
    return SteadyState(x, y, inputs_used, float(np.max(residual, initial=0.0)), (method,))


def linearise(
    instance: Instance, inputs: Mapping[str, Any] | None = None, *, at: Recording | None = None
) -> LinearModel:
    """Return the linear model of an instance at an operating point.

    The public method `Circuit.linearise` describes the arguments.
    """
    if instance.model.memory:
        if at is not None:
            raise InputError("linear.no_memory", title=at.title or "a recording")
        return sampled_model(instance, steady_state(instance, inputs))
    if at is None:
        steady = steady_state(instance, inputs)
        return _LinearisationPoint(instance, np.array(list(steady.u.values()))).linear_model(steady.x)
    units = {item.name: item.unit for item in instance.model.inputs if item.name in at}
    recorded = at.select(units).converted(units).last() if units else {}
    # Inputs have their values at the end of the recording, unless `inputs` contains them.
    start = instance.resumed(at)
    point = _LinearisationPoint(start, start.held_inputs(recorded | dict(inputs or {})))
    # The end of the recording is the operating point, whether steady or not.
    return point.linear_model(point.start)


class _LinearisationPoint:
    """Circuit with constant inputs, for which rates, outputs and derivatives are evaluated.

    The argument x of the methods contains the states, (n,), without the quadratures (integrals of flows).
    """

    def __init__(self, instance: Instance, u: Array) -> None:
        self.kernel, self.model, self.u = instance.kernel, instance.model, u
        start, self.p = instance.start()
        self.start: Array = start[: len(self.model.states)]
        self.positive = self.kernel.positive
        # Only positive states have a typical initial value: a stroke can start at a nanometre.
        nominal = np.array([state.nominal for state in self.model.states])
        self.size = np.where(self.positive, np.abs(self.start), nominal)
        self._function = ArrayFunction(self.model.linear_function)

    def linear(self, x: Array) -> list[Array]:
        """Return rates f, outputs y and the matrices A to D at the state x."""
        f, y, *matrices = self._function(0.0, self.padded(x), self.u, self.p)
        return [f.ravel(), y.ravel(), *matrices]

    def padded(self, x: Array) -> Array:
        """Return a state vector with a zero for each quadrature after the states x.

        Quadratures are integrals of flows, which do not affect the rates.
        """
        return np.concatenate([x, np.zeros(self.model.n_quadratures)])

    def scaled(self, x: Array) -> tuple[Array, Array]:
        """Return the rates and their Jacobian at the state x, scaled by the typical size of each state [1/s]."""
        f, _, jacobian, *_ = self.linear(x)
        return f / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def linear_model(self, x: Array) -> LinearModel:
        """Return the linear model with names and operating point at the state x."""
        f, y, a, b, c, d = self.linear(x)
        names = tuple(s.name for s in self.model.states), tuple(i.name for i in self.model.inputs)
        return LinearModel(a, b, c, d, *names, self.model.columns[0], x, self.u, y, f)
