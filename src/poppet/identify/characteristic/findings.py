"""What a reader of a fitted characteristic has to know, the most important first."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from poppet.ground.codes import Note
from poppet.identify.characteristic.fit import DOUBT, CurveFit
from poppet.identify.characteristic.stroke_tests import NUMBERS, SYMBOLS, TestEvidence
from poppet.identify.characteristic.verdict import MonotoneVerdict

Array = NDArray[np.float64]

GAP = 3.0
"""Distance between neighbouring strokes, over the median one, from which a gap is worth a word."""
FAR = 4.0
"""Sigmas by which repeated tests differ beyond chance."""


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
    said += _impossible(fit, domain) + _misfit(fit) + _blind(evidence) + _repeats(evidence)
    said += _coverage(evidence, domain) + _two_ways(fit, by_test) + _by_numbers(evidence)
    return tuple(dict.fromkeys([*said, *(note for e in evidence for note in e.findings)]))


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


def _blind(evidence: Sequence[TestEvidence]) -> list[Note]:
    blind = [e.name for e in evidence if not np.isfinite(e.uncertainty[1])]
    if not blind:
        return []
    return [Note("characteristic.blind", "critical_ratio", count=len(blind), of=len(evidence), tests=blind)]


def _by_numbers(evidence: Sequence[TestEvidence]) -> list[Note]:
    """Tests without a recording, where others have one: of a flow bench's result, say."""
    named = [e.name for e in evidence if e.optimum is None]
    if not named or len(named) == len(evidence):
        return []
    return [Note("characteristic.by_numbers", count=len(named), of=len(evidence), tests=named)]


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


def _two_ways(fit: CurveFit, by_test: CurveFit) -> list[Note]:
    """How far the joint fit and the fit test by test lie apart."""
    if fit is by_test:
        return []
    x = np.linspace(*_ends(fit), 101)
    conductance = np.max(np.abs(fit.curve(0, x) / by_test.curve(0, x) - 1.0))
    ratio = np.max(np.abs(fit.curve(1, x) - by_test.curve(1, x)))
    return [Note("characteristic.two_ways", conductance=100.0 * conductance, ratio=ratio)]


def _ends(fit: CurveFit) -> tuple[float, float]:
    shape = fit.shapes[0]
    ends = getattr(shape, "domain", None) or (shape.knots[0], shape.knots[-1])  # type: ignore[attr-defined]
    return float(ends[0]), float(ends[1])
