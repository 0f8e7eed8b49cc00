"""What the data say about fitted curves: whether C may never fall, and what a reader has to know, by importance.

Whether a C that never falls is allowed is judged by the spline with and without the constraint, and the polynomials.
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
"""Distance between neighbouring strokes, over the median one, from which a gap is worth a word."""
FAR = 4.0
"""Sigmas by which repeated tests differ beyond chance."""
REJECTED = 0.01
"""Probability below which a constraint is rejected."""
FLAT = 1e-6
"""Increments over the largest C below which the constraint holds a curve; residuals in sigmas that count as zero."""


@dataclass(frozen=True)
class MonotoneVerdict:
    """What speaks for and against a C that never falls."""

    rejected: bool  # by the data
    probability: float  # of such a gain in fit by falling, if C never falls
    gain: float  # by how much the misfit of C falls without the constraint, over the scatter that is left
    held: int  # number of increments that the constraint holds at zero
    runs_probability: float  # of as few runs of sign among the residuals of C where the constraint holds it
    fall: float  # of the unconstrained C beyond its maximum, relative
    fall_from: float  # stroke of the maximum [m]
    aicc_constrained: float
    aicc_free: float
    aicc_polynomial: float  # not-a-number where there are too few tests for the polynomials


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

    knots = np.array(fit.shapes[0].knots)  # type: ignore[union-attr]
    theta = fit.theta[fit.part(0)]
    held = theta[1:] <= FLAT * np.sum(theta)  # the first number is a value, the others increments
    scatter = max(1.0, free.misfits[0].chi_square / max(1, free.misfits[0].freedom))
    gain = max(0.0, fit.misfits[0].chi_square - free.misfits[0].chi_square) / scatter
    probability = float(chdtrc(int(held.sum()), gain)) if held.any() else 1.0
    strokes = np.sort([e.stroke for e in evidence])
    inside = np.zeros(strokes.size, dtype=bool)
    for left, right, flat in zip(knots[:-1], knots[1:], held, strict=True):
        inside |= flat & (strokes >= left) & (strokes <= right)
    runs = few_runs_probability(curve_residuals(fit, evidence, 0)[inside]) if inside.any() else 1.0
    values = free.curve(0, knots)
    top = int(np.argmax(values))
    return MonotoneVerdict(
        rejected=bool(min(probability, runs) < REJECTED),
        probability=probability,
        gain=gain,
        held=int(held.sum()),
        runs_probability=runs,
        fall=float(1.0 - np.min(values[top:]) / values[top]),
        fall_from=float(knots[top]),
        aicc_constrained=fit.aicc(),
        aicc_free=free.aicc(),
        aicc_polynomial=rival.aicc() if rival else math.nan,
    )


def curve_residuals(fit: CurveFit, evidence: Sequence[TestEvidence], which: int) -> Array:
    """Curve minus the tests' own values in their standard uncertainties, over the stroke."""
    ordered = sorted(evidence, key=lambda e: e.stroke)
    curve = fit.curve(which, np.array([e.stroke for e in ordered]))
    off = np.array([(y - e.centre[which]) / e.uncertainty[which] for y, e in zip(curve, ordered, strict=True)])
    return np.where(np.abs(off) < FLAT, 0.0, off)  # a curve through a point leaves rounding errors without a sign


def characteristic_findings(
    fit: CurveFit,
    by_test: CurveFit,
    evidence: Sequence[TestEvidence],
    verdict: MonotoneVerdict | None,
    domain: tuple[float, float],
    joint: bool,
) -> tuple[Note, ...]:
    """Findings on the curves and on the tests, the most important first."""
    said = _constraint(verdict, joint) if verdict else []
    said += _twin(fit, evidence) + _impossible(fit, domain) + _misfit(fit)
    blind = [e.name for e in evidence if not np.isfinite(e.uncertainty[1])]
    if blind:
        said.append(Note("characteristic.blind", "critical_ratio", count=len(blind), of=len(evidence), tests=blind))
    said += _repeats(evidence) + _coverage(evidence, domain)
    if fit is not by_test:
        said.append(_two_ways(fit, by_test))
    named = [e.name for e in evidence if e.optimum is None]
    if 0 < len(named) < len(evidence):  # numbers among recordings, of a flow bench's result, say
        said.append(Note("characteristic.by_numbers", count=len(named), of=len(evidence), tests=named))
    return tuple(dict.fromkeys([*said, *(note for e in evidence for note in e.findings)]))


def _twin(fit: CurveFit, evidence: Sequence[TestEvidence]) -> list[Note]:
    """Other curves, with another wall heat, that the recordings fit as well."""
    if fit.twin is None:
        return []
    strokes = np.array([e.stroke for e in evidence])
    factor = float(np.mean(fit.twin.curve(0, strokes) / fit.curve(0, strokes)))
    walls = [k for k, f in enumerate(fit.nuisance) if f.name.endswith(".wall_conductance")]
    values = [[float(f.theta[f.part(2)][k] * f.nuisance[k].scale) for f in (fit, fit.twin)] for k in walls]
    excess = fit.twin.cost - fit.cost
    return [Note("characteristic.twin", "sonic_conductance", factor=factor, walls=values[0], excess=excess)]


def _constraint(verdict: MonotoneVerdict, joint: bool) -> list[Note]:
    """The outcome for the rising spline, said even where it is good."""
    numbers = {name: getattr(verdict, name) for name in ("gain", "probability", "runs_probability")}
    numbers |= {"constrained": verdict.aicc_constrained, "unconstrained": verdict.aicc_free}
    polynomial = verdict.aicc_polynomial
    numbers["polynomials"] = f"{polynomial:.1f}" if np.isfinite(polynomial) else None
    if not verdict.rejected:
        return [Note("characteristic.may_never_fall", "sonic_conductance", **numbers)]
    fall = {"fall": 100.0 * verdict.fall, "from_mm": 1e3 * verdict.fall_from}
    said = [Note("characteristic.falls", "sonic_conductance", **fall, **numbers)]
    return [*said, Note("characteristic.not_joint")] if joint else said


def _impossible(fit: CurveFit, domain: tuple[float, float]) -> list[Note]:
    """Curves that leave what is possible inside the domain."""
    x = np.linspace(*domain, 401)
    conductance, ratio = fit.curve(0, x), fit.curve(1, x)
    said = []
    for values, wrong, code in (
        (conductance, conductance < 0.0, "characteristic.negative_c"),
        (ratio, ratio < 0.0, "characteristic.negative_b"),
        (ratio, ratio >= 1.0, "characteristic.b_of_one"),
    ):
        if wrong.any():
            worst = int(np.argmax(np.where(wrong, np.abs(values), -1.0)))
            said.append(Note(code, stroke_mm=1e3 * x[worst], value=float(values[worst])))
    return said


def _misfit(fit: CurveFit) -> list[Note]:
    said = []
    for name, misfit in zip(NUMBERS, fit.misfits, strict=True):
        what = "C(x) and b(x)" if fit.misfits[0] is fit.misfits[1] else f"{SYMBOLS[name]}(x)"
        if misfit.probability < DOUBT:
            facts = {"chi_square": misfit.chi_square, "freedom": misfit.freedom}
            said.append(Note("characteristic.misfit", name, times=np.sqrt(misfit.widening), curve=what, **facts))
    return said


def _repeats(evidence: Sequence[TestEvidence]) -> list[Note]:
    """Repeated tests that differ by more than they should."""
    said = []
    for stroke, group in groupby(sorted(evidence, key=lambda e: e.stroke), key=lambda e: e.stroke):
        tests = list(group)
        for which, name in enumerate(NUMBERS):
            values = np.array([e.centre[which] for e in tests])
            errors = np.array([e.uncertainty[which] for e in tests])
            low, high = int(np.argmin(values)), int(np.argmax(values))
            apart = (values[high] - values[low]) / np.hypot(errors[low], errors[high])
            if apart > FAR:
                facts = {"stroke_mm": 1e3 * stroke, "apart": apart, "symbol": SYMBOLS[name]}
                said.append(
                    Note("characteristic.not_repeated", name, **facts, tests=[tests[low].name, tests[high].name])
                )
    return said


def _coverage(evidence: Sequence[TestEvidence], domain: tuple[float, float]) -> list[Note]:
    """Parts of the domain without tests."""
    strokes = np.unique([e.stroke for e in evidence])
    steps = np.diff(strokes)
    said = []
    gaps = np.flatnonzero(steps > GAP * np.median(steps))
    said += [Note("characteristic.gap", low_mm=1e3 * strokes[k], high_mm=1e3 * strokes[k + 1]) for k in gaps]
    for end, edge in zip(domain, (strokes[0], strokes[-1]), strict=True):
        if not np.isclose(end, edge, rtol=0.0, atol=1e-9):
            said.append(Note("characteristic.continued", "domain", end_mm=1e3 * end, edge_mm=1e3 * edge))
    return said


def _two_ways(fit: CurveFit, by_test: CurveFit) -> Note:
    """How far the joint fit and the fit test by test lie apart."""
    shape = fit.shapes[0]
    ends = shape.domain if isinstance(shape, PolynomialShape) else (shape.knots[0], shape.knots[-1])
    x = np.linspace(*ends, 101)
    conductance = np.max(np.abs(fit.curve(0, x) / by_test.curve(0, x) - 1.0))
    ratio = np.max(np.abs(fit.curve(1, x) - by_test.curve(1, x)))
    return Note("characteristic.two_ways", conductance=100.0 * conductance, ratio=ratio)
