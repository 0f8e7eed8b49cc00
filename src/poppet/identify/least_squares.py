r"""Bounded least squares for few parameters with expensive residuals and available derivatives.

The method is a trust region method (Moré 1978) on R and q of the QR factors :math:`J = Q R`, :math:`r = Q q`. Each
step s solves

.. math:: \min_s \tfrac12 |R s + q|^2 + \tfrac12 s^T S s, \quad |D s| \le \Delta, \quad l \le x + s \le u

*Bounds*: each step solves a bounded problem with active sets (Stark and Parker, here with a radius). A search can
therefore follow bounds and end at them. The bounds of a step also limit each parameter to half and three times its
value. Far from the optimum, the derivatives describe correlated parameters badly, and a long step would lead to another
minimum.

*S* is the contribution of curved residuals to the curvature of the cost, estimated from changes of the derivatives
(Dennis, Gay and Welsch 1981). It is used only if steps reduce the cost little, and only while it predicts the cost
better than R alone. With R alone, steps would oscillate about the optimum if parameters are correlated.

*Non-monotone steps*: a strict decrease of the cost would make the steps short in curved valleys. The cost of a step
must be below the maximum of the last few (Toint 1996). The result is the point of least cost.

References
----------
Moré 1978, The Levenberg-Marquardt algorithm: implementation and theory, Lecture Notes in Mathematics 630, 105-116.
Dennis, Gay & Welsch 1981, ACM Trans. Math. Softw. 7, 348-368.
Stark & Parker 1995, Computational Statistics 10, 129-141.
Toint 1996, SIAM J. Sci. Comput. 17, 725-739.
Bates & Watts 1981, Technometrics 23, 179-183 (termination by the gain of a step relative to the cost).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

LOOKED_BACK = 3
"""Number of previous steps; their maximum cost limits the cost of the next step."""
LATE = 1e-2
"""Relative decrease of the cost by a step below which S is used. With small residuals, S is not necessary."""
SHRINKS, GROWS, SMALL = 0.5, 2.0, 0.1
"""Largest relative decrease and increase of a parameter in one step; smallest size to which they refer, in `units`."""


class LocalModel(NamedTuple):
    """Linear model of the residuals near one point, from which a search computes its next step.

    It contains factors of a QR decomposition, the Jacobian, and the derivative of the cost by each residual.
    """

    slopes: FloatArray  # R, (k, n): the curvature of the cost is R'R
    residual: FloatArray  # q, (k,): the gradient of the cost is R'q
    jacobian: FloatArray  # (m, n)
    force: FloatArray  # derivative of the cost by each residual, (m,): equals the residuals for a linear loss


class SearchResult(NamedTuple):
    """Result of a search: end point, cost, number of evaluations and termination reason."""

    x: FloatArray  # (n,)
    cost: float  # cost at x
    evaluations: int
    # termination reason: small change of the cost or of the parameters, or maximum number of evaluations
    reason: Literal["cost", "numbers", "evaluations"]


def triangular_factor(columns: FloatArray) -> FloatArray:
    """Return the triangular factor R of the QR decomposition of a matrix, (k, k).

    `columns` is the matrix, (m, k). The columns of R have the same inner products as the columns of the matrix.
    """
    from scipy.linalg.lapack import dgeqrf

    return np.triu(dgeqrf(columns)[0][: columns.shape[1]])


def search(
    cost: Callable[[FloatArray], float],
    look: Callable[[FloatArray], LocalModel],
    begin: FloatArray,
    low: FloatArray,
    high: FloatArray,
    units: FloatArray,
    *,
    inexact: float = 1e-7,
    precision: float = 1e-9,
    most: int = 200,
) -> SearchResult:
    """Minimise a cost within bounds and return the point with the least cost.

    Parameters
    ----------
    cost : callable
        Function of the parameters that returns half the sum of squares, or the cost of a robust loss.
    look : callable
        Function of the parameters that returns the local model. It is called after `cost` at accepted points.
    begin, low, high : ndarray
        Start point within the bounds, and bounds, (n,). A bound can be infinite.
    units : ndarray
        Typical size of each parameter, positive, (n,).
    inexact : float
        Relative error of the derivatives. Directions with smaller normalised singular values are ignored.
    precision : float
        Least predicted gain of a step, as a fraction of the cost. The least change of a parameter is a thousandth of
        it, in units.
    most : int
        Maximum number of evaluations of the cost.

    Returns
    -------
    SearchResult
        Evaluated point with the least cost.
    """
    x, last = begin, cost(begin)
    model = look(x)
    best, past, evaluations = (x, last), [last], 1
    scale = _norms(model.slopes)
    scale = np.where(scale > 0.0, scale, 1.0 / units)
    radius, bend, bends = _size(scale * x) or 1.0, np.zeros((x.size, x.size)), False
    reason: Literal["cost", "numbers", "evaluations"] = "evaluations"
    while evaluations < most:
        # The step limits the change of each parameter.
        size, down = np.maximum(np.abs(x), SMALL * units), np.where(x >= 0.0, SHRINKS, GROWS)
        nearest = np.maximum(low, x - down * size)
        farthest = np.minimum(high, x + (SHRINKS + GROWS - down) * size)
        least, greatest = (nearest - x) * scale, (farthest - x) * scale
        slopes, bent = model.slopes / scale, bend / (scale * scale[:, np.newaxis])
        z = _solve_step(slopes, model.residual, bent if bends else None, (least, greatest), radius, inexact**2)
        predicted = slopes @ z
        downhill = float(model.residual @ predicted)
        linear_gain = -downhill - 0.5 * float(predicted @ predicted)
        curved = linear_gain - 0.5 * float(z @ bent @ z)
        gain, length = curved if bends else linear_gain, _size(z)
        ends_by_cost = gain <= precision * last
        if ends_by_cost and bends:
            # A too large S makes steps short: check the termination with R alone.
            bends = False
            continue
        if ends_by_cost or (np.abs(z) <= 1e-3 * precision * scale * units).all():
            reason = "cost" if ends_by_cost else "numbers"
            break
        tried = np.where(z <= least, nearest, np.where(z >= greatest, farthest, x + z / scale))
        new = cost(tried)
        evaluations += 1
        best = (tried, new) if new < best[1] else best
        change, allowed = last - new, max(past[-LOOKED_BACK:])
        bends = linear_gain < LATE * last and abs(curved - change) < abs(linear_gain - change)
        ratio = max(change / gain, (allowed - new) / (allowed - last + gain))
        # A first step that is shorter than the radius sets the radius.
        radius = min(radius, length) if evaluations == 2 else radius
        if ratio < 0.25:
            # Minimum of the parabola through both costs with the slope at the first.
            radius = length * min(max(-0.5 * downhill / (-change - downhill), 0.1), 0.5)
        elif change > 0.75 * gain:
            radius = max(radius, 2.0 * length)
        if ratio > 1e-4:
            previous, model = model, look(tried)
            bend = _update_curvature(bend, tried - x, previous, model)
            x, last = tried, new
            past.append(last)
            scale = np.maximum(scale, _norms(model.slopes))
    return SearchResult(*best, evaluations, reason)


def _size(vector: FloatArray) -> float:
    return math.sqrt(vector @ vector)


def _norms(columns: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(np.add.reduce(columns * columns)))


def _update_curvature(bend: FloatArray, step: FloatArray, previous: LocalModel, now: LocalModel) -> FloatArray:
    """Return the updated estimate of S, the curvature of the cost that the Jacobian does not explain.

    `bend` is S before the step `step`. `previous` and `now` are the local models before and after it. The update scales
    S and then applies the smallest change that agrees with the observed change of the gradient.
    """
    gradient = now.residual @ now.slopes
    slope_change = gradient - previous.residual @ previous.slopes
    gradient_change = gradient - now.force @ previous.jacobian
    curvature = float(slope_change @ step)
    if curvature <= 0.0:
        return bend
    expected = float(step @ bend @ step)
    if expected != 0.0:
        bend = bend * min(1.0, abs(float(step @ gradient_change) / expected))
    missing, slope_change = gradient_change - bend @ step, slope_change / curvature
    update = missing[:, np.newaxis] * slope_change
    return bend + update + update.T - float(step @ missing) * (slope_change[:, np.newaxis] * slope_change)


def _solve_step(
    slopes: FloatArray,
    residual: FloatArray,
    bend: FloatArray | None,
    bounds: tuple[FloatArray, FloatArray],
    radius: float,
    unseen: float,
) -> FloatArray:
    """Return the step of a search that minimises the local model of the cost within a radius and bounds.

    The parameters are scaled. `slopes` and `residual` are R and q of `LocalModel`. `bend` is an additional curvature,
    or None. A parameter is fixed at a bound that stops the step. It becomes free again if the cost decreases away from
    the bound. Curvatures below the fraction `unseen` of the largest one are treated as not identifiable.
    """
    from scipy.linalg.lapack import dgesdd, dsyevd

    low, high = bounds
    z, gradient = np.zeros(low.size), residual @ slopes
    free = ((low < 0.0) | (gradient < 0.0)) & ((high > 0.0) | (gradient > 0.0))
    pulls = 1e-12 * float(np.abs(gradient).max())
    for _ in range(3 * z.size + 3):
        indices = np.flatnonzero(free)
        if indices.size == 0:
            break
        target = np.where(free, 0.0, z)
        # Principal curvatures, directions and gradients for the free parameters; the others are fixed.
        free_slopes, remaining = slopes, residual
        if indices.size < z.size:
            free_slopes, remaining = slopes[:, indices], residual + slopes @ target
        if bend is None:
            # Singular values resolve directions whose squares are equal within rounding.
            rows, sizes, right, _ = dgesdd(free_slopes, full_matrices=0)
            curvatures, directions, slopes_along = sizes**2, right.T, sizes * (remaining @ rows)
        else:
            curvatures, directions, _ = dsyevd(free_slopes.T @ free_slopes + bend[indices[:, np.newaxis], indices])
            slopes_along = (remaining @ free_slopes + (bend @ target)[indices]) @ directions
        # The fixed parameters use a part of the radius.
        left = max(radius**2 - float(target @ target), 1e-6 * radius**2) ** 0.5
        moves, damping = _steps_within(curvatures, slopes_along, left, unseen)
        target[indices] = directions @ moves
        if ((target >= low) & (target <= high)).all():
            z = target
            if indices.size == z.size:
                break
            force = gradient + (slopes @ z) @ slopes + damping * z
            force += 0.0 if bend is None else bend @ z
            wrong = ~free & (low < high) & (((z <= low) & (force < -pulls)) | ((z >= high) & (force > pulls)))
            if not wrong.any():
                break
            free[np.argmax(np.where(wrong, np.abs(force), 0.0))] = True
            continue
        direction = target - z
        with np.errstate(divide="ignore", invalid="ignore"):
            allowed_fraction = np.where(
                free & (direction != 0.0), (np.where(direction > 0.0, high, low) - z) / direction, np.inf
            )
        first = int(np.argmin(allowed_fraction))
        z = z + allowed_fraction[first] * direction
        z[first] = high[first] if direction[first] > 0.0 else low[first]
        free[first] = False
    return z


def _steps_within(
    curvatures: FloatArray, slopes_along: FloatArray, radius: float, unseen: float
) -> tuple[FloatArray, float]:
    """Return the steps along the principal directions that minimise a quadratic cost within a radius, and the damping.

    `curvatures` and `slopes_along` contain curvature and gradient of the cost along each direction. The damping is the
    curvature that is added so that the step has the length `radius`. Curvatures below the fraction `unseen` of the
    largest one are treated as not identifiable.
    """
    # The curvatures are sorted, in ascending or descending order.
    lowest, greatest = sorted((float(curvatures[0]), float(curvatures[-1])))
    floor = unseen * max(greatest, -lowest, 1e-290)
    if abs(lowest) <= floor:
        # Do not move in directions that are not identifiable.
        slopes_along = np.where(np.abs(curvatures) > floor, slopes_along, 0.0)
        curvatures = np.maximum(curvatures, floor)
    damping = least = floor - lowest if lowest < -floor else 0.0
    moves = -slopes_along / (curvatures + damping)
    size = _size(moves)
    # Newton's method for 1/|moves| (Moré); the radius is approximate.
    for _ in range(40 if size > radius else 0):
        if abs(size - radius) <= 0.05 * radius:
            break
        fall = float(moves @ (moves / (curvatures + damping)))
        damping = max(damping + (size / radius - 1.0) * size**2 / fall, 1e-3 * damping, least)
        moves = -slopes_along / (curvatures + damping)
        size = _size(moves)
    return moves * min(1.0, radius / size) if size > 0.0 else moves, damping
