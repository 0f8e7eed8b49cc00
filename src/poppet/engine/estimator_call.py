"""Estimator of states and free numbers of a compiled model, with little overhead per update."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.compiled import CompiledFunctions, compile_functions, estimator
from poppet.engine.derivatives import differentiate_rates
from poppet.engine.estimator_job import CORRECT, PREDICT, EstimatorJob, memory_size
from poppet.engine.job import Job, address
from poppet.engine.kernel import LARGE, Kernel, compile_kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.model import Model
from poppet.engine.problem import Outcome

Array = NDArray[np.float64]
KERNELS: LruCache[Kernel] = LruCache(100)
"""Compiled models by model and by fusing of operations."""
DERIVATIVES: LruCache[CompiledFunctions] = LruCache(100)
"""Compiled derivatives by kernel, outputs and touched elements."""
SIGNATURES = {"linear": "t x u p -> A B", "observe": "t x u p -> y C D"}
"""Arguments and results of the derivatives: the matrices of x' = A x + B v, y = C x + D v, with touched elements v."""
MOST_ATTEMPTS = 10_000
"""Maximum number of attempted steps per prediction."""


def derivative_functions(
    model: Model, outputs: Sequence[int], places: Sequence[int], inputs: Sequence[int]
) -> dict[str, Any]:
    """Return the CasADi functions `linear` and `observe` of a model without quadratures.

    Their arguments are (t, x, u, p). `linear` returns the derivatives of the rates by x and by the touched elements:
    p with the indices `places`, then u with the indices `inputs`. `observe` returns the selected outputs and their
    derivatives. Matrices are dense.
    """
    import casadi as ca

    t, x, u, p = (model.symbols[name] for name in ("t", "x", "u", "p"))
    variables = ca.vertcat(x, *(p[k] for k in places), *(u[k] for k in inputs))
    # A function must not have a symbol in two of its arguments.
    other_u, other_p = ca.SX(u), ca.SX(p)
    for vector, indices in ((other_u, inputs), (other_p, places)):
        for k in indices:
            vector[k] = ca.SX.sym("unused")
    n = x.numel()

    def differentiate(expression: Any) -> list[Any]:
        values, matrix, _ = differentiate_rates(expression, (t, variables, other_u, other_p), ca.SX.zeros(u.numel()))
        return [values, ca.densify(matrix[:, :n]), ca.densify(matrix[:, n:])]

    selected = ca.vertcat(ca.SX(0, 1), *(model.expressions["outputs"][k] for k in outputs))
    arguments = [t, x, u, p]
    return {
        "linear": ca.Function("linear", arguments, ca.cse(differentiate(model.expressions["rates"])[1:])),
        "observe": ca.Function("observe", arguments, ca.cse(differentiate(selected))),
    }


class EstimatorCall:
    """Extended Kalman filter for the states x and the free numbers theta of a model, as prepared calls.

    The model has no quadratures (`poppet.engine.state_start.model_from_state`). The arrays are read and written in
    place. The touched elements of p and u are ``base + directions @ (theta - reference)``, and the readings are
    ``outputs + effects @ (theta - reference)`` plus noise. `poppet.engine.estimator_job.EstimatorJob` describes all
    arrays. Before the first call, set `p` (with the discrete states at its end), `u`, `mean`, `covariance` and `noise`.

    Parameters
    ----------
    model : Model
        Symbolic model without quadratures.
    outputs : sequence of int
        Indices of the measured outputs, one for each channel.
    places, inputs : sequence of int
        Indices of the touched elements of p and of u.
    directions : array
        (k + j, m)
    effects : array
        (channels, m)
    onsets, faults : int
        Size of the bank of onsets, and number of the free numbers that are faults; they are the first ones.
    tolerance : float
        Relative tolerance of the integration.
    fuses : bool
        True if the processor can use fused multiply-add operations. If False, the results have identical bits in C.
    """

    def __init__(
        self,
        model: Model,
        outputs: Sequence[int],
        places: Sequence[int],
        inputs: Sequence[int],
        directions: Array,
        effects: Array,
        *,
        onsets: int = 0,
        faults: int = 0,
        tolerance: float = 1e-6,
        fuses: bool = True,
    ) -> None:
        assert model.n_quadratures == 0, "a filter carries no quadratures"
        kernel = KERNELS.get((model, fuses), lambda: compile_kernel(model, fuses=fuses))
        kernel.optimise()
        self.kernel = kernel
        self._code = _compile_derivatives(kernel, outputs, places, inputs, fuses)
        job = kernel.job
        n, n_u, n_z, n_p = job["n_states"], job["n_inputs"], job["n_memory"], job["n_numbers"]
        touched, m = np.shape(directions)
        channels, total = len(outputs), n + m
        shapes = {
            "clock": (2,), "mean": (total,), "covariance": (total, total), "u": (2, n_u), "p": (n_p + n_z,),
            "base": (touched,), "directions": (touched, m), "reference": (m,), "low": (m,), "high": (m,),
            "effects": (channels, m), "readings": (channels,), "noise": (channels,), "gates": (channels,),
            "walk": (total,), "cap": (total,), "expected": (channels,), "innovations": (channels,),
            **dict.fromkeys(("deviations", "used", "rejected", "outside"), (channels,)), "scores": (1,),
            "transition": (n, total),
            "signatures": (total, onsets * faults), "numerators": (onsets, faults), "gram": (onsets, faults * faults),
            "x": (n,),
            "limits": (4,), "counts": (5,), "scratch": (kernel.memory_size,),
            "memory": (memory_size(n, m, touched, channels, n_u, n_z, onsets * faults),),
        }  # fmt: skip
        # Adjacent arrays, because the address of each array takes time.
        offsets = list(accumulate((int(np.prod(shape)) for shape in shapes.values()), initial=0))
        self._block = np.zeros(offsets[-1])
        arrays = {
            name: self._block[a:b].reshape(shape)
            for (name, shape), (a, b) in zip(shapes.items(), pairwise(offsets), strict=True)
        }
        addresses = {name: address(self._block) + 8 * a for name, a in zip(shapes, offsets, strict=False)}
        self.time, self._interval = arrays["clock"][:1], arrays["clock"][1:]
        self.mean, self.covariance, self.transition = (arrays[k] for k in ("mean", "covariance", "transition"))
        self.p, self.u = arrays["p"], arrays["u"][:, : len(model.inputs)]
        self.base, self.directions, self.reference = (arrays[k] for k in ("base", "directions", "reference"))
        self.low, self.high, self.effects = (arrays[k] for k in ("low", "high", "effects"))
        self.readings, self.noise, self.gates = (arrays[k] for k in ("readings", "noise", "gates"))
        self.walk, self.cap, self.expected = (arrays[k] for k in ("walk", "cap", "expected"))
        self.innovations, self.deviations, self.used = (arrays[k] for k in ("innovations", "deviations", "used"))
        self.rejected, self.signatures, self.numerators = (arrays[k] for k in ("rejected", "signatures", "numerators"))
        self.gram = arrays["gram"].reshape(onsets, faults, faults)
        # Adjacent: time, interval, mean and covariance.
        self.estimate = self._block[: 2 + total + total * total]
        self._n = n
        self._scores, self._limits, self._counts = arrays["scores"], arrays["limits"], arrays["counts"].view(np.int64)
        self.tolerance = tolerance
        self._places, self._inputs = np.array(places, dtype=np.int64), np.array(inputs, dtype=np.int64)
        self.directions[:], self.effects[:] = directions, effects
        self.low[:], self.high[:], self.gates[:], self.cap[:] = -np.inf, np.inf, np.inf, np.inf
        self.readings[:] = np.nan
        self.restart()
        run = dict.fromkeys(Job._fields, 0) | job
        run |= {name: addresses[name] for name in ("p", "x", "limits", "counts")} | {"memory": addresses["scratch"]}
        self._run = np.array(Job(**run), dtype=np.int64)
        fields = {name: addresses[name] for name in EstimatorJob._fields if name in addresses}
        fields |= self._code.addresses
        fields |= {"run": address(self._run), "places": address(self._places), "touched_inputs": address(self._inputs)}
        fields |= {"n_free": m, "n_places": len(places), "n_touched_inputs": len(inputs), "n_channels": channels}
        fields |= {"n_onsets": onsets, "n_faults": faults}
        actions = PREDICT, CORRECT, PREDICT + CORRECT
        self._jobs = [np.array(EstimatorJob(action, **fields), dtype=np.int64) for action in actions]
        self._predict, self._correct, self._update = (address(row) for row in self._jobs)
        self._function = estimator()

    def restart(self) -> None:
        """Select tolerances and step length again in the next prediction, as in the first one."""
        self._limits[:] = np.inf, MOST_ATTEMPTS, 0.0, self.tolerance

    def advance(self, dt: float) -> Outcome:
        """Predict the estimate at the end of an interval dt [s], and return the outcome.

        The inputs are linear from u[0] to u[1]. `transition` is the derivative of the states at the end by states at
        the start and free numbers. If the outcome is not `Outcome.DONE`, the estimate, its covariance, the discrete
        states and the time are unchanged.
        """
        self._interval[0] = dt
        return _OUTCOMES[self._function(self._predict)]

    def correct(self) -> Outcome:
        """Correct the estimate with the readings at the present time, and return the outcome.

        The inputs are u[1]. If the outcome is not `Outcome.DONE`, the estimate and its covariance are unchanged.
        """
        return _OUTCOMES[self._function(self._correct)]

    def update(self, dt: float) -> Outcome:
        """Predict over an interval dt [s], then correct, and return the outcome.

        If the prediction fails, the readings are not used.
        """
        self._interval[0] = dt
        return _OUTCOMES[self._function(self._update)]

    def renew(self, onset: int) -> None:
        """Let the onset with the given index begin at the present time, without evidence.

        Column ``onset * faults + i`` of `signatures` is a step of the fault i.
        """
        faults = self.numerators.shape[1]
        columns = slice(onset * faults, (onset + 1) * faults)
        self.signatures[:, columns] = 0.0
        self.signatures[self._n : self._n + faults, columns] = np.eye(faults)
        self.numerators[onset] = 0.0
        self.gram[onset] = 0.0

    @property
    def nis(self) -> float:
        """Joint squared normalised innovation of the used readings of the last correction."""
        return float(self._scores[0])

    @property
    def steps(self) -> tuple[int, int]:
        """Numbers of accepted and of attempted steps of the last prediction."""
        return int(self._counts[0]), int(self._counts[1])


_OUTCOMES = tuple(Outcome)


def _compile_derivatives(
    kernel: Kernel, outputs: Sequence[int], places: Sequence[int], inputs: Sequence[int], fuses: bool
) -> CompiledFunctions:
    def compile_code() -> CompiledFunctions:
        functions = derivative_functions(kernel.model, outputs, places, inputs)
        size = sum(function.n_instructions() for function in functions.values())
        return compile_functions(functions, fuses=fuses and size <= LARGE)

    return DERIVATIVES.get((kernel, fuses, tuple(outputs), tuple(places), tuple(inputs)), compile_code)
