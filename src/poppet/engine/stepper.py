"""Single steps of a compiled model from given states, and its compiled derivatives.

Callers write the arguments into arrays, and read the results from arrays. The kernels are those of
`poppet.engine.state_start`: their states are the controlled states, without quadratures.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from poppet.engine.call import Call
from poppet.engine.compiled import CompiledFunctions, compile_functions
from poppet.engine.estimator_call import derivative_functions
from poppet.engine.job import address
from poppet.engine.kernel import Kernel
from poppet.engine.lane_kernel import Lanes, lane_functions, usual_width
from poppet.engine.lru_cache import LruCache
from poppet.engine.members import Batch, Integers, RunEnds
from poppet.engine.model import Model
from poppet.engine.problem import Array, Outcome, constant_input_problem
from poppet.engine.state_start import INPUT, START

DERIVATIVES: LruCache[CompiledFunctions] = LruCache(100)
"""Compiled derivatives by kernel and indices of the touched parameters."""
MANY = 4000
"""Number of instructions above which derivatives are compiled without optimisation, which would take seconds."""


class StepCall:
    """Prepared step of a model, with its own arrays.

    Write the state into `x`, the parameters into `p` and the discrete state into `memory`, and call `hold` or `ramp`
    for the inputs. Then `run` replaces the state and the discrete state by those at the end of the step.
    """

    def __init__(self, kernel: Kernel, p: Array, u: Array, tolerance: float) -> None:
        kernel.optimise()
        self.problem = problem = constant_input_problem(
            kernel, p.copy(), np.zeros(kernel.model.size), u, np.ones(1), relative_tolerance=tolerance
        )
        coefficients = problem.coefficients[0, : u.size]
        self._levels, self._slopes, self._begins = (coefficients[:, k] for k in (0, 1, 6))
        self._call = Call(problem)
        self.x, self.p, self.memory = self._call.x, self._call.p, self._call.memory

    def hold(self, u: Array) -> None:
        """Set inputs that are constant during the next step, (n_inputs,)."""
        self._levels[:], self._slopes[:] = u, 0.0

    def ramp(self, first: Array, last: Array, dt: float) -> None:
        """Set inputs that change linearly during the next step of the duration `dt`."""
        self._levels[:], self._slopes[:] = first, (last - first) / dt

    def run(self, t: float, dt: float) -> Outcome:
        """Integrate from the time t for the duration `dt`."""
        problem = self.problem
        problem.starts[0], problem.grid[0], self._begins[:] = t, t + dt, t
        return self._call.proceed()


class LaneSteps:
    """Steps of several states at once, each in one lane of a register, with constant inputs.

    The columns of `states`, `parameters` and `inputs`, which the caller writes, are the states, the parameters with the
    indices `places`, and the inputs of each lane.
    """

    def __init__(self, call: StepCall, count: int, dt: float, places: Integers) -> None:
        kernel, model = call.problem.kernel, call.problem.kernel.model
        n, n_u = model.size, len(model.inputs)
        starts = model.parameters.index(f"{START}{model.states[0].name}") + np.arange(n)
        input_indices = (model.parameters.index(f"{INPUT}{model.inputs[0].name}") if n_u else 0) + np.arange(n_u)
        problem = constant_input_problem(
            kernel, call.p.copy(), np.zeros(n), np.zeros(n_u), np.array([dt]),
            relative_tolerance=call.problem.relative_tolerance,
        )  # fmt: skip
        indices = np.concatenate([starts, places, input_indices]).astype(np.int64)
        values = np.empty((count, indices.size))
        batch = Batch(problem, indices, values, tuple(enumerate(input_indices.tolist())))
        self._ends, self._count, width = RunEnds.of(batch), count, usual_width()
        self._lanes = Lanes(batch, self._ends, lane_functions(kernel, width), width)
        self.states, self.parameters, self.inputs = np.split(values, [n, n + places.size], axis=1)

    def run(self) -> tuple[Array, list[Outcome]]:
        """Return the states at the end, (count, n), which the next call overwrites, and the outcome of each lane."""
        self._lanes.run(0, self._count, None)
        return self._ends.x, self._ends.outcomes


class DerivativeCall:
    """Prepared evaluation of rates, outputs and their derivatives, with its own arrays.

    Write the arguments into `x`, `u` and `p`, and call `run`. `rates_by` and `outputs_by` are the derivatives of
    `rates` and `outputs` by the states, by the parameters with the indices `places`, and by the inputs, as columns of
    one matrix. The next call overwrites them. The kernel computes the outputs.
    """

    def __init__(self, kernel: Kernel, places: Integers) -> None:
        model = kernel.model
        n, n_u, n_y = len(model.states), len(model.inputs), len(model.outputs)
        code = DERIVATIVES.get((kernel, tuple(places.tolist())), lambda: _compile_derivatives(model, places))
        self.x, self.u, self.p = np.zeros(n), np.zeros(n_u), np.zeros(len(model.parameters) + len(model.memory))
        self.rates, self.outputs = np.zeros(n), np.zeros(n_y)
        # The compiled functions write matrices in column order.
        columns = n + places.size + n_u
        by_rates, by_outputs = np.zeros(n * columns), np.zeros(n_y * columns)
        self.rates_by, self.outputs_by = by_rates.reshape(columns, n).T, by_outputs.reshape(columns, n_y).T
        arguments = [np.zeros(1), self.x, self.u, self.p]
        split = n * n, n_y * n
        self._calls = [
            kernel.caller("rates", *arguments, self.rates),
            _caller(code, "linear", *arguments, by_rates[: split[0]], by_rates[split[0] :]),
            _caller(code, "observe", *arguments, self.outputs, by_outputs[: split[1]], by_outputs[split[1] :]),
        ]
        self._arrays = arguments, by_rates, by_outputs

    def run(self) -> None:
        """Evaluate the model."""
        for call in self._calls:
            call()


def _caller(code: CompiledFunctions, name: str, *arrays: Array) -> Callable[[], None]:
    import ctypes

    function: Any = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * len(arrays))(code.addresses[name])
    function.owner = code.owner
    return partial(function, *map(address, arrays))


def _compile_derivatives(model: Model, places: Integers) -> CompiledFunctions:
    functions = derivative_functions(model, range(len(model.outputs)), places.tolist(), range(len(model.inputs)))
    size = sum(function.n_instructions() for function in functions.values())
    return compile_functions(functions, optimises=size <= MANY)
