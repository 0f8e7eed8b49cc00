"""Whether the data allow a C that never falls: the spline with and without the constraint, and the polynomials."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.identify.characteristic.fit import CurveFit
from poppet.identify.characteristic.stroke_tests import TestEvidence
from poppet.identify.gum import few_runs_probability

Array = NDArray[np.float64]

REJECTED = 0.01
"""Probability below which a constraint is rejected."""
FLAT = 1e-6
"""Increments over the largest C below which the constraint holds a curve; residuals in sigmas that count as zero."""


@dataclass(frozen=True)
class MonotoneVerdict:
    """What speaks for and against a C that never falls.

    Parameters
    ----------
    rejected : bool
        The data reject it.
    probability : float
        Of such a gain in fit by falling, if C never falls.
    gain : float
        By how much the misfit of C falls without the constraint, over the scatter that is left.
    held : int
        Number of increments that the constraint holds at zero.
    runs_probability : float
        Of as few runs of sign among the residuals of C over the stroke, where the constraint holds it.
    fall : float
        Fall of the unconstrained C beyond its maximum, relative.
    fall_from : float
        Stroke of the maximum [m].
    aicc_constrained, aicc_free : float
        Of the spline with and without the constraint.
    aicc_polynomial : float
        Of the polynomials; not-a-number where there are too few tests for them.
    """

    rejected: bool
    probability: float
    gain: float
    held: int
    runs_probability: float
    fall: float
    fall_from: float
    aicc_constrained: float
    aicc_free: float
    aicc_polynomial: float

    def content(self) -> dict[str, Any]:
        """Plain values for a file."""
        return asdict(self)


def judge_monotone(
    fit: CurveFit, free: CurveFit, rival: CurveFit | None, evidence: Sequence[TestEvidence]
) -> MonotoneVerdict:
    """Judge the constraint of a rising spline.

    Notes
    -----
    Under the constraint the gain follows a mixture of chi-square distributions with up to `held` degrees of
    freedom; taking all of them errs on the side of not rejecting. Misfit of the unconstrained spline is
    divided out: knots too far apart must not speak against the constraint.
    """
    from scipy.special import chdtrc

    held = _held(fit)
    scatter = max(1.0, free.misfits[0].chi_square / max(1, free.misfits[0].freedom))
    gain = max(0.0, fit.misfits[0].chi_square - free.misfits[0].chi_square) / scatter
    probability = float(chdtrc(int(held.sum()), gain)) if held.any() else 1.0
    runs = _runs_where_held(fit, held, evidence)
    fall, place = _fall(free)
    return MonotoneVerdict(
        bool(min(probability, runs) < REJECTED), probability, gain, int(held.sum()), runs, fall, place,
        fit.aicc(), free.aicc(), rival.aicc() if rival else math.nan,
    )  # fmt: skip


def _held(fit: CurveFit) -> NDArray[np.bool_]:
    """Which increments from knot to knot lie on their bound; the first number is a value."""
    theta = fit.theta[fit.part(0)]
    return np.asarray(theta[1:] <= FLAT * np.sum(theta))


def _runs_where_held(fit: CurveFit, held: NDArray[np.bool_], evidence: Sequence[TestEvidence]) -> float:
    knots = np.array(fit.shapes[0].knots)  # type: ignore[attr-defined]
    residual = curve_residuals(fit, evidence, 0)
    strokes = np.sort([e.stroke for e in evidence])
    inside = np.zeros(strokes.size, dtype=bool)
    for left, right, flat in zip(knots[:-1], knots[1:], held, strict=True):
        inside |= flat & (strokes >= left) & (strokes <= right)
    return few_runs_probability(residual[inside]) if inside.any() else 1.0


def _fall(free: CurveFit) -> tuple[float, float]:
    """How far the unconstrained C falls beyond its maximum, and where that is."""
    shape = free.shapes[0]
    knots = np.array(shape.knots)  # type: ignore[attr-defined]
    values = free.curve(0, knots)
    top = int(np.argmax(values))
    return float(1.0 - np.min(values[top:]) / values[top]), float(knots[top])


def curve_residuals(fit: CurveFit, evidence: Sequence[TestEvidence], which: int) -> Array:
    """Curve minus the tests' own values in their standard uncertainties, over the stroke."""
    ordered = sorted(evidence, key=lambda e: e.stroke)
    curve = fit.curve(which, np.array([e.stroke for e in ordered]))
    off = np.array([(y - e.centre[which]) / e.uncertainty[which] for y, e in zip(curve, ordered, strict=True)])
    return np.where(np.abs(off) < FLAT, 0.0, off)
