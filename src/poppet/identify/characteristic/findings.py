"""What a reader of a fitted characteristic has to know, in sentences with numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from poppet.ground.codes import Note, notes_of
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
    return tuple(dict.fromkeys(notes_of([*said, *(note for e in evidence for note in e.findings)])))


def _constraint(verdict: MonotoneVerdict, joint: bool) -> list[str]:
    """The outcome for the rising spline, said even where it is good."""
    numbers = (
        f"allowing it to fall improves the misfit by {verdict.gain:.3g} of chi-square (probability "
        f"{verdict.probability:.2g}), runs test over the stroke {verdict.runs_probability:.2g}, AICc "
        f"{verdict.aicc_constrained:.1f} with the constraint, {verdict.aicc_free:.1f} without"
    )
    if np.isfinite(verdict.aicc_polynomial):
        numbers += f", {verdict.aicc_polynomial:.1f} with polynomials"
    if not verdict.rejected:
        return [f"The data do not reject a C that never falls: {numbers}."]
    said = [
        f"The data reject a C that never falls: C falls by {100.0 * verdict.fall:.1f} % beyond "
        f"{1e3 * verdict.fall_from:.3g} mm; {numbers}. Use the polynomial form, or find out why C falls."
    ]
    if joint:
        said.append("The joint fit was left out: b would bend to make up for the C that the constraint holds up.")
    return said


def _impossible(fit: CurveFit, domain: tuple[float, float]) -> list[str]:
    """Curves that leave what is possible inside the domain."""
    x = np.linspace(*domain, 401)
    conductance, ratio = fit.curve(0, x), fit.curve(1, x)
    said = []
    for values, wrong, text in (
        (conductance, conductance < 0.0, "C is negative"),
        (ratio, ratio < 0.0, "b is negative"),
        (ratio, ratio >= 1.0, "b is 1 or more"),
    ):
        if wrong.any():
            worst = int(np.argmax(np.where(wrong, np.abs(values), -1.0)))
            said.append(
                f"{text} at {1e3 * x[worst]:.3g} mm ({values[worst]:.3g}), which cannot be: shorten the domain to the "
                "strokes tested, lower the degree, or use the spline."
            )
    return said


def _misfit(fit: CurveFit) -> list[str]:
    said = []
    for name, misfit in zip(NUMBERS, fit.misfits, strict=True):
        what = "C(x) and b(x)" if fit.misfits[0] is fit.misfits[1] else f"{SYMBOLS[name]}(x)"
        if misfit.probability < DOUBT:
            said.append(
                f"The tests lie {np.sqrt(misfit.widening):.2g} times further from {what} than their own uncertainties "
                f"say (chi-square {misfit.chi_square:.3g} for {misfit.freedom}): the shape does not fit, or the "
                "strokes or the bench varied; the bands are widened by as much."
            )
    return said


def _blind(evidence: Sequence[TestEvidence]) -> list[str]:
    blind = [e.name for e in evidence if not np.isfinite(e.uncertainty[1])]
    if not blind:
        return []
    return [
        f"{len(blind)} of {len(evidence)} tests say nothing about b ({', '.join(blind)}): choked throughout, or b not "
        "determined. b(x) rests on the others; go on until the pressures are nearly equal."
    ]


def _by_numbers(evidence: Sequence[TestEvidence]) -> list[str]:
    """Tests without a recording, where others have one: of a flow bench's result, say."""
    named = [e.name for e in evidence if e.optimum is None]
    if not named or len(named) == len(evidence):
        return []
    return [
        f"{len(named)} of {len(evidence)} tests enter through C and b with their uncertainties alone "
        f"({', '.join(named)}): their own samples, an m other than the bench's and a cracking pressure do not count."
    ]


def _repeats(evidence: Sequence[TestEvidence]) -> list[str]:
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
                said.append(
                    f"Tests repeated at {1e3 * stroke:.4g} mm differ by {apart:.2g} standard uncertainties in "
                    f"{SYMBOLS[name]} ({tests[low].name} and {tests[high].name}): the stroke or the bench does not "
                    "repeat."
                )
    return said


def _coverage(evidence: Sequence[TestEvidence], domain: tuple[float, float]) -> list[str]:
    """Parts of the domain without tests."""
    strokes = np.unique([e.stroke for e in evidence])
    steps = np.diff(strokes)
    said = []
    gaps = np.flatnonzero(steps > GAP * np.median(steps))
    said += [
        f"No test lies between {1e3 * strokes[k]:.4g} and {1e3 * strokes[k + 1]:.4g} mm: the curve there is a guess "
        "of its shape."
        for k in gaps
    ]
    for end, edge in zip(domain, (strokes[0], strokes[-1]), strict=True):
        if not np.isclose(end, edge, rtol=0.0, atol=1e-9):
            said.append(
                f"The domain reaches to {1e3 * end:.4g} mm, the tests only to {1e3 * edge:.4g} mm: the curves between "
                "are continued, not measured."
            )
    return said


def _two_ways(fit: CurveFit, by_test: CurveFit) -> list[str]:
    """How far the joint fit and the fit test by test lie apart."""
    if fit is by_test:
        return []
    x = np.linspace(*_ends(fit), 101)
    conductance = np.max(np.abs(fit.curve(0, x) / by_test.curve(0, x) - 1.0))
    ratio = np.max(np.abs(fit.curve(1, x) - by_test.curve(1, x)))
    return [
        f"The joint fit and the fit test by test differ by at most {100.0 * conductance:.2g} % in C and {ratio:.2g} "
        "in b."
    ]


def _ends(fit: CurveFit) -> tuple[float, float]:
    shape = fit.shapes[0]
    ends = getattr(shape, "domain", None) or (shape.knots[0], shape.knots[-1])  # type: ignore[attr-defined]
    return float(ends[0]), float(ends[1])
