"""A search of `poppet.identify.least_squares` for residuals with complex-step slopes, and SciPy's beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares

from poppet.identify.fit.residuals import costs_of, curvatures_of, weights_of
from poppet.identify.least_squares import LocalModel, SearchResult, search, triangular_factor

Array = np.ndarray[Any, np.dtype[np.float64]]


class Problem(NamedTuple):
    """Residuals as a function that takes complex numbers too, and where to begin."""

    residual: Callable[[Array], Array]
    begin: Array
    low: Array
    high: Array

    @property
    def units(self) -> Array:
        return np.where(self.begin == 0.0, 1.0, np.abs(self.begin))

    def at(self, x: Array) -> tuple[Array, Array]:
        """Residuals and slopes; what is not finite is a failure."""
        step, columns = 1e-20, []
        with np.errstate(all="ignore"):
            for k, unit in enumerate(self.units):
                moved = x.astype(complex)
                moved[k] += 1j * step * unit
                columns.append(np.imag(self.residual(moved)) / (step * unit))
            residual = np.nan_to_num(self.residual(x), nan=1e6, posinf=1e6, neginf=-1e6)
        return residual, np.nan_to_num(np.array(columns).T, nan=0.0, posinf=0.0, neginf=0.0)


def unbounded(residual: Callable[[Array], Array], begin: Any) -> Problem:
    begin = np.asarray(begin, dtype=float)
    return Problem(residual, begin, np.full(begin.size, -np.inf), np.full(begin.size, np.inf))


def found(problem: Problem, loss: str = "linear", **more: Any) -> SearchResult:
    """What our search finds."""

    def look(x: Array) -> LocalModel:
        residual, jacobian = problem.at(x)
        force, root = residual * weights_of(residual, loss), np.sqrt(curvatures_of(residual, loss))
        triangle = triangular_factor(np.asfortranarray(np.column_stack([jacobian * root[:, np.newaxis], force / root])))
        return LocalModel(triangle[:, :-1], triangle[:, -1], jacobian, force)

    def cost(x: Array) -> float:
        return float(np.sum(costs_of(problem.at(x)[0], loss)))

    return search(cost, look, problem.begin, problem.low, problem.high, problem.units, **more)


def found_by_scipy(problem: Problem, loss: str = "linear", precision: float = 1e-8, most: int = 200) -> Any:
    """What SciPy's finds; `x`, `cost` and `nfev` of it."""
    units = problem.units
    with np.errstate(all="ignore"):
        end = least_squares(
            lambda z: problem.at(z * units)[0],
            problem.begin / units,
            jac=lambda z: problem.at(z * units)[1] * units,
            bounds=(problem.low / units, problem.high / units),
            x_scale="jac",
            loss=loss,
            ftol=precision,
            xtol=precision,
            gtol=1e-14,
            max_nfev=most,
        )
    end.x = end.x * units
    return end
