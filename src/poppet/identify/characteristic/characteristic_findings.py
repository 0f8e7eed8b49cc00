"""Findings on the fitted curves of C and b, the most important first.

The test of the constraint that C does not fall compares three fits: splines with the constraint, splines without it,
and polynomials.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from poppet.core.codes import Note
from poppet.identify.characteristic.characteristic_fit import DOUBT, CurveFit
from poppet.identify.characteristic.characteristic_shapes import PolynomialShape
from poppet.identify.characteristic.stroke_tests import NUMBERS, SYMBOLS, TestEvidence
from poppet.identify.gum import few_runs_probability
from poppet.timeseries.checks import FloatArray as Array

GAP = 3.0
"""Distance of neighbouring strokes, relative to the median distance, above which a gap is reported."""
FAR = 4.0
"""Difference of repeated tests that is significant, in standard deviations."""
REJECTED = 0.01
"""Probability below which the constraint is rejected."""
FLAT = 1e-6
"""Relative increment of C below which the constraint is active; also the residual in sigmas below which it is zero."""


@dataclass(frozen=True)
class MonotoneVerdict:
    """Result of a statistical test of the constraint that the sonic conductance never falls with the stroke."""

    rejected: bool  # True if the data reject the constraint
    probability: float  # probability of this gain or a larger one if C does not fall
    gain: float  # reduction of chi-square of C without the constraint, relative to the scatter
    held: int  # number of increments that the constraint keeps at zero
    runs_probability: float  # probability of so few sign runs in the residuals of C at active constraints
    fall: float  # relative fall of the unconstrained C beyond its maximum
    fall_from: float  # stroke of the maximum [m]
    aicc_constrained: float
    aicc_free: float
    aicc_polynomial: float  # NaN if there are too few tests for the polynomials


def judge_monotone(
    fit: CurveFit, free: CurveFit, rival: CurveFit | None, evidence: Sequence[TestEvidence]
) -> MonotoneVerdict:
    """Test whether the data contradict the constraint that C never falls with the stroke.

    `fit` is the spline with the constraint, `free` the spline without it, and `rival` the polynomial. `evidence`
    contains C and b of the tests.

    Notes
    -----
    The gain is the reduction of chi-square if the constraint is removed. If the true C does not fall, the gain follows
    a mixture of chi-square distributions with at most as many degrees of freedom as active constraints. The test uses
    this largest number, which is conservative. The gain is divided by the lack of fit of the unconstrained spline.
    Otherwise a spline with too few knots could reject the constraint.
    """
    from scipy.special import chdtrc

    knots = np.array(fit.shapes[0].knots)  # type: ignore[union-attr]
    theta = fit.theta[fit.part(0)]
    is_active = theta[1:] <= FLAT * np.sum(theta)  # the first parameter is a value, the others are increments
    scatter = max(1.0, free.misfits[0].chi_square / max(1, free.misfits[0].freedom))
    gain = max(0.0, fit.misfits[0].chi_square - free.misfits[0].chi_square) / scatter
    probability = float(chdtrc(int(is_active.sum()), gain)) if is_active.any() else 1.0
    strokes = np.sort([e.stroke for e in evidence])
    is_constrained = np.zeros(strokes.size, dtype=bool)
    for left, right, flat in zip(knots[:-1], knots[1:], is_active, strict=True):
        is_constrained |= flat & (strokes >= left) & (strokes <= right)
    runs = few_runs_probability(curve_residuals(fit, evidence, 0)[is_constrained]) if is_constrained.any() else 1.0
    values = free.curve(0, knots)
    top = int(np.argmax(values))
    return MonotoneVerdict(
        rejected=bool(min(probability, runs) < REJECTED),
        probability=probability,
        gain=gain,
        held=int(is_active.sum()),
        runs_probability=runs,
        fall=float(1.0 - np.min(values[top:]) / values[top]),
        fall_from=float(knots[top]),
        aicc_constrained=fit.aicc(),
        aicc_free=free.aicc(),
        aicc_polynomial=rival.aicc() if rival else math.nan,
    )


def curve_residuals(fit: CurveFit, evidence: Sequence[TestEvidence], curve_index: int) -> Array:
    """Return curve minus test value at each test, divided by the standard uncertainty of the test.

    `evidence` contains C and b of the tests. The curve is C for `curve_index` 0 and b for 1. The residuals are in the
    order of the strokes.
    """
    ordered = sorted(evidence, key=lambda e: e.stroke)
    curve = fit.curve(curve_index, np.array([e.stroke for e in ordered]))
    residuals = np.array(
        [(y - e.centre[curve_index]) / e.uncertainty[curve_index] for y, e in zip(curve, ordered, strict=True)]
    )
    return np.where(np.abs(residuals) < FLAT, 0.0, residuals)  # rounding errors of an exact curve have no sign


def characteristic_findings(
    fit: CurveFit,
    by_test: CurveFit,
    evidence: Sequence[TestEvidence],
    verdict: MonotoneVerdict | None,
    domain: tuple[float, float],
    joint: bool,
) -> tuple[Note, ...]:
    """Return findings on the fitted curves of C and b and on the tests, the most important first.

    `evidence` contains the values of C and b from the single tests, and `by_test` the fit to these values. `verdict` is
    the test of the constraint that C never falls. `domain` is the range of strokes [m]. `joint` is True if a fit to the
    samples of all tests was requested.
    """
    notes = list[Note]()
    if verdict:
        numbers = {name: getattr(verdict, name) for name in ("gain", "probability", "runs_probability")}
        numbers |= {"constrained": verdict.aicc_constrained, "unconstrained": verdict.aicc_free}
        polynomial = verdict.aicc_polynomial
        numbers["polynomials"] = f"{polynomial:.1f}" if np.isfinite(polynomial) else None
        fall = {"fall": 100.0 * verdict.fall, "from_mm": 1e3 * verdict.fall_from} if verdict.rejected else {}
        code = "characteristic.falls" if verdict.rejected else "characteristic.may_never_fall"
        notes = [Note(code, "sonic_conductance", **fall, **numbers)]
        notes += [Note("characteristic.not_joint")] * (verdict.rejected and joint)
    if fit.twin:
        strokes = np.array([e.stroke for e in evidence])
        factor = float(np.mean(fit.twin.curve(0, strokes) / fit.curve(0, strokes)))
        wall = next(k for k, f in enumerate(fit.nuisance) if f.name.endswith(".wall_conductance"))
        walls = [float(f.theta[f.part(2)][wall] * f.nuisance[wall].scale) for f in (fit, fit.twin)]
        excess = fit.twin.cost - fit.cost
        notes.append(Note("characteristic.twin", "sonic_conductance", factor=factor, walls=walls, excess=excess))
    x = np.linspace(*domain, 401)
    conductance, ratio = fit.curve(0, x), fit.curve(1, x)
    for values, is_invalid, code in (
        (conductance, conductance < 0.0, "characteristic.negative_c"),
        (ratio, ratio < 0.0, "characteristic.negative_b"),
        (ratio, ratio >= 1.0, "characteristic.b_of_one"),
    ):
        if is_invalid.any():
            worst = int(np.argmax(np.where(is_invalid, np.abs(values), -1.0)))
            notes.append(Note(code, stroke_mm=1e3 * x[worst], value=float(values[worst])))
    for name, misfit in zip(NUMBERS, fit.misfits, strict=True):
        curve = "C(x) and b(x)" if fit.misfits[0] is fit.misfits[1] else f"{SYMBOLS[name]}(x)"
        if misfit.probability < DOUBT:
            facts = {"chi_square": misfit.chi_square, "freedom": misfit.freedom}
            notes.append(Note("characteristic.misfit", name, times=np.sqrt(misfit.widening), curve=curve, **facts))
    counts = {"of": len(evidence)}
    if blind := [e.name for e in evidence if not np.isfinite(e.uncertainty[1])]:
        notes.append(Note("characteristic.blind", "critical_ratio", count=len(blind), **counts, tests=blind))
    for stroke, group in groupby(sorted(evidence, key=lambda e: e.stroke), key=lambda e: e.stroke):
        tests = list(group)
        for curve_index, name in enumerate(NUMBERS):
            centres = np.array([e.centre[curve_index] for e in tests])
            errors = np.array([e.uncertainty[curve_index] for e in tests])
            low, high = int(np.argmin(centres)), int(np.argmax(centres))
            apart = (centres[high] - centres[low]) / np.hypot(errors[low], errors[high])
            if apart > FAR:
                numbers = {"stroke_mm": 1e3 * stroke, "apart": apart}
                repeated = [tests[low].name, tests[high].name]
                notes.append(Note("characteristic.not_repeated", name, **numbers, symbol=SYMBOLS[name], tests=repeated))
    strokes = np.unique([e.stroke for e in evidence])
    steps = np.diff(strokes)
    gaps = np.flatnonzero(steps > GAP * np.median(steps))
    notes += [Note("characteristic.gap", low_mm=1e3 * strokes[k], high_mm=1e3 * strokes[k + 1]) for k in gaps]
    for end, edge in zip(domain, (strokes[0], strokes[-1]), strict=True):
        if not np.isclose(end, edge, rtol=0.0, atol=1e-9):
            notes.append(Note("characteristic.continued", "domain", end_mm=1e3 * end, edge_mm=1e3 * edge))
    if fit is not by_test:
        shape = fit.shapes[0]
        ends = shape.domain if isinstance(shape, PolynomialShape) else (shape.knots[0], shape.knots[-1])
        x = np.linspace(*ends, 101)
        change = 100.0 * np.max(np.abs(fit.curve(0, x) / by_test.curve(0, x) - 1.0))
        difference = np.max(np.abs(fit.curve(1, x) - by_test.curve(1, x)))
        notes.append(Note("characteristic.two_ways", conductance=change, ratio=difference))
    points = [e.name for e in evidence if e.optimum is None]
    if 0 < len(points) < len(evidence):  # points among recordings
        notes.append(Note("characteristic.by_numbers", count=len(points), **counts, tests=points))
    return tuple(dict.fromkeys([*notes, *(note for e in evidence for note in e.findings)]))
