"""Identification of C(x) and b(x) of a flow path from tests at several strokes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field
from poppet.identify.characteristic.characteristic_file import read_characteristic_file
from poppet.identify.characteristic.characteristic_findings import (
    MonotoneVerdict,
    characteristic_findings,
    curve_residuals,
    judge_monotone,
)
from poppet.identify.characteristic.characteristic_fit import (
    CurveFit,
    Shapes,
    ambient_uncertainty,
    bootstrap_bands,
    fit_evidence,
    fit_recordings,
)
from poppet.identify.characteristic.characteristic_shapes import (
    LARGEST_RATIO,
    PolynomialShape,
    SplineShape,
    select_knots,
)
from poppet.identify.characteristic.stroke_tests import (
    NUMBERS,
    UNITS,
    StrokePoint,
    StrokeTest,
    TestEvidence,
    check_tests,
    determined_values,
    evaluate_test,
    test_name,
)
from poppet.identify.data_file import or_file
from poppet.identify.gum import add_relative_uncertainty, few_runs_probability
from poppet.identify.result import Estimate, ResidualSummary, Result, replace_uncertain_findings, verdict_on_interval
from poppet.timeseries.checks import FloatArray as Array

Form = Literal["polynomial", "spline"]
FORMS: tuple[Form, ...] = get_args(Form)
LETTERS = {"sonic_conductance": "k", "critical_ratio": "p"}
DRAWN = 201
"""Number of strokes of the curves and bands in a result."""
FEWEST_KNOTS = 4
BOUND = 1e-6
"""Relative distance from an upper bound below which a parameter is at the bound."""


@dataclass(frozen=True)
class _CurveOptions:
    """Checked options of `identify_characteristic`."""

    form: Form
    degrees: tuple[int, int]
    domain: tuple[float, float]
    strokes: Array
    knots: tuple[float, ...] | None
    bootstrap: int
    seed: int
    scale: float = 1.0


@or_file(read_characteristic_file)
def identify_characteristic(
    tests: Sequence[StrokeTest] | str | Path,
    *,
    form: Form = "polynomial",
    degree_conductance: int = 7,
    degree_ratio: int = 4,
    domain: tuple[float, float] | None = None,
    knots: Sequence[float] | None = None,
    joint: bool = True,
    common: tuple[float, float] = (0.0, 0.0),
    bootstrap: int = 0,
    seed: int = 0,
    part: str = "",
    title: str = "characteristic",
    notes: tuple[Note | str, ...] = (),
    progress: Callable[[int, float], Any] | None = None,
) -> Result:
    r"""Identify sonic conductance and critical ratio versus stroke, from tests at known strokes.

    .. math::

        \min_{\theta, \nu} \sum_i \left\| r_i\big(C(x_i; \theta), b(x_i; \theta), \nu\big) \right\|^2, \qquad
        \frac{\partial r_i}{\partial \theta} = \frac{\partial r_i}{\partial C} \frac{\partial C}{\partial \theta}
        + \frac{\partial r_i}{\partial b} \frac{\partial b}{\partial \theta}

    where theta are the coefficients of C(x) and b(x), nu are the free parameters of the bench, and r_i are the
    residuals of test i. If `joint` is True, these are the residuals of all recorded samples. Otherwise they are the
    residuals of the values of C and b from test i.

    Parameters
    ----------
    tests : sequence of StrokePoint or StrokeRecording, str or Path
        Tests, or a file that lists them; arguments override the options of the file. The number of distinct strokes
        must exceed the number of coefficients of each curve.
    form : str, optional
        `polynomial`, or `spline`: monotone piecewise cubics with C rising and 0 <= b < 1.
    degree_conductance, degree_ratio : int, optional
        Degrees of the polynomials; the paper uses 7 and 4.
    domain : tuple of float, optional
        First and last stroke of the curves; the default is the tested range [m].
    knots : sequence of float, optional
        Knots of the spline, at most one for each tested stroke. By default, AICc selects tested strokes [m].
    joint : bool, optional
        If True, fit all coefficients to the recorded samples of all tests together. If False, fit them to the values of
        C and b from each test.
    common : tuple of float, optional
        Standard uncertainties of errors that all tests share: of C (relative, for example from the volume or the flow
        meter) and of b.
    bootstrap : int, optional
        Number of bootstrap fits for the bands; 0 uses the delta method.
    seed : int, optional
        Seed of the bootstrap.
    part : str, optional
        Name of the part in a circuit; the estimates are then called `part.characteristic.sonic_conductance.k1`.
    title : str, optional
        Title of the result.
    notes : tuple of Note or str, optional
        Notes on the tests; the findings include them.
    progress : callable, optional
        Function that is called with the number of evaluations and the cost of the joint fit.

    Returns
    -------
    Result
        Coefficients of the stroke in mm, highest power first, or values at the knots, with intervals. `series` has the
        curves with 95 % bands, and the points of the tests. A band contains the true value at a stroke with a
        probability of 95 %, not the whole curve.

    Raises
    ------
    InputErrors
        All errors: too few strokes, strokes outside the domain, invalid values.

    Notes
    -----
    Powers of x are ill-conditioned. The search therefore uses Chebyshev polynomials over the domain and converts the
    coefficients at the end. The coefficients are strongly correlated: keep all digits, and use the band as the measure
    of uncertainty. If the data reject the constraint of a spline, it is fitted to the C and b of each test only.
    Otherwise b would compensate for the error of C.

    References
    ----------
    Varga & Keski-Honkola 2012, section 3, equations (3), (4) and Table 1.

    Examples
    --------
    >>> from poppet.library.varga2012 import printed_characteristic
    >>> table = printed_characteristic()
    >>> strokes = np.linspace(0.05e-3, 1e-3, 15)
    >>> tests = [
    ...     StrokePoint(x, table.sonic_conductance_at(x), table.critical_ratio_at(x), 2e-11, 0.002) for x in strokes
    ... ]
    >>> found = identify_characteristic(tests).parameters
    >>> f"{found['sonic_conductance.k8'].value:.4e}, {found['critical_ratio.p5'].value:.5f}"
    '5.0034e-09, 0.71748'
    """
    assert not isinstance(tests, str | Path)  # `or_file` has read a file
    degrees = {"degree_conductance": degree_conductance, "degree_ratio": degree_ratio}
    options = _check_options(tests, form, degrees, domain, knots, common, bootstrap, seed)
    evidence = [evaluate_test(test, test_name(test, k)) for k, test in enumerate(tests)]
    n_strokes = np.unique(determined_values(evidence, 1)[0]).size
    n_needed = degree_ratio + 1 if form == "polynomial" else FEWEST_KNOTS
    if n_strokes < n_needed:
        raise InputError("characteristic.ratio_unseen", strokes=n_strokes, of=options.strokes.size, needed=n_needed)
    options = replace(options, scale=max(float(e.centre[0]) for e in evidence))
    ambient = ambient_uncertainty(tests, evidence)
    if ambient:
        common = (math.hypot(common[0], ambient.conductance), common[1])
    verdict: MonotoneVerdict | None = None
    if form == "spline":
        fit, verdict = _fit_spline(options, evidence, common)
    else:
        fit = fit_evidence(evidence, _polynomial_shapes(options), common)
    by_test = fit
    recorded = [k for k, test in enumerate(tests) if not isinstance(test, StrokePoint)]
    if joint and recorded and not (verdict and verdict.rejected):
        fit = fit_recordings(tests, evidence, fit, progress)
    bands = _confidence_bands(fit, evidence, options)
    remarks = characteristic_findings(fit, by_test, evidence, verdict, options.domain, joint and bool(recorded))
    prefix = f"{part}.characteristic." if part else ""
    estimates = _estimates(fit, options, prefix)
    if ambient:
        names = [f.name for f in fit.nuisance if f.name in ambient.shares]
        estimates |= {name: add_relative_uncertainty(estimates[name], ambient.shares[name]) for name in names}
        remarks = (*remarks, ambient.note(("C(x)", *names)))
    if fit.twin:  # the intervals include those of the equivalent curves
        twin_bands = _confidence_bands(fit.twin, evidence, options)
        bands = [(np.minimum(a, c), np.maximum(b, d)) for (a, b), (c, d) in zip(bands, twin_bands, strict=True)]
        for name, twin in _estimates(fit.twin, options, prefix).items():
            e = estimates[name]
            verdict_of_both = "weak" if e.verdict == "determined" else e.verdict
            estimates[name] = replace(e, low=min(e.low, twin.low), high=max(e.high, twin.high), verdict=verdict_of_both)
    summaries = {}
    for index, name in enumerate(NUMBERS):
        strokes, measured, _ = determined_values(evidence, index)
        summaries[f"tests.{name}"] = ResidualSummary.of(fit.curve(index, strokes), measured, UNITS[name])

    return Result(
        method="characteristic",
        title=title,
        parameters=estimates,
        residuals=summaries,
        comparison=_comparison(fit, evidence, verdict),
        remarks=(*replace_uncertain_findings(remarks, estimates), *notes_of(notes)),
        conditions=_conditions(options, fit, evidence, fit is not by_test, common),
        series=_series(fit, evidence, options, bands),
    )


def _check_options(
    tests: Sequence[StrokeTest],
    form: Form,
    degrees: Mapping[str, int],
    domain: tuple[float, float] | None,
    knots: Sequence[float] | None,
    common: tuple[float, float],
    bootstrap: int,
    seed: int,
) -> _CurveOptions:
    """Check the tests and the options of `identify_characteristic`, and return the options."""
    with ErrorCollector() as errors:
        if form not in FORMS:
            near = NameSuggestion(str(form), FORMS)
            errors.add("fields.not_an_option", "form", value=form, meaning="form", suggestion=near)
        for name, degree in degrees.items():
            with errors.collecting():
                Field(type="integer", low=0, high=15).read(degree, name)
        if domain is not None and not -math.inf < domain[0] < domain[1] < math.inf:
            errors.add("characteristic.empty_domain", "domain", value=str(domain))
        if not all(0.0 <= u < math.inf for u in common):
            errors.extend([OutOfRangeError("characteristic.common", "common", value=str(common))])
        # With fewer fits, the ends of the 95 % band depend on two or three curves.
        if isinstance(bootstrap, bool) or not isinstance(bootstrap, int) or not (bootstrap == 0 or bootstrap >= 100):
            errors.add("characteristic.bootstrap", "bootstrap", value=bootstrap)
    check_tests(tests, domain)
    strokes, highest = np.unique([test.stroke for test in tests]), max(degrees.values())
    needed = (highest + 2) if form == "polynomial" else (len(knots) if knots else FEWEST_KNOTS + 1)
    if strokes.size < needed:
        facts: dict[str, Any] = {"tests": len(tests), "strokes": strokes.size, "needed": needed}
        raise InputError(f"characteristic.too_few_for_{form}", **facts, degrees=(*degrees.values(),))
    domain = domain or (float(strokes[0]), float(strokes[-1]))
    if knots is not None:
        positions = np.asarray(knots, dtype=float)
        rises = positions.ndim == 1 and positions.size >= 2 and np.all(np.diff(positions) > 0.0)
        if not (rises and strokes[0] <= positions[0] and positions[-1] <= strokes[-1]):
            ends = {"low_mm": 1e3 * strokes[0], "high_mm": 1e3 * strokes[-1]}
            raise InputError("characteristic.knots", "knots", value=str(list(knots)), **ends)
    sizes = degrees["degree_conductance"], degrees["degree_ratio"]
    return _CurveOptions(form, sizes, domain, strokes, tuple(knots) if knots is not None else None, bootstrap, seed)


def _polynomial_shapes(options: _CurveOptions) -> Shapes:
    first, second = options.degrees
    return PolynomialShape(first, options.domain, options.scale), PolynomialShape(second, options.domain)


def _fit_spline(
    options: _CurveOptions, evidence: Sequence[TestEvidence], common: tuple[float, float]
) -> tuple[CurveFit, MonotoneVerdict]:
    """Return the spline in which C never falls, and the result of a statistical test of this constraint.

    `evidence` contains C and b of each measurement, and `common` the errors that all measurements share.
    """
    decoupled = [e.decoupled() for e in evidence]
    if options.knots:
        candidates = [options.knots]
    else:
        # AICc decides between selections of knots; the largest one has all strokes at which tests determine b.
        strokes, determined = options.strokes, np.unique(determined_values(decoupled, 1)[0])
        selections = [select_knots(strokes, n) for n in range(FEWEST_KNOTS, strokes.size)]
        selections += [select_knots(determined, n) for n in range(FEWEST_KNOTS, determined.size + 1)]
        candidates = list(dict.fromkeys(selections))
    fits = (fit_evidence(decoupled, _spline_shapes(options, k, False)) for k in candidates)
    rivals = tuple(sorted(fits, key=CurveFit.aicc))
    free = rivals[0]
    knots = free.shapes[0].knots  # type: ignore[union-attr]
    constrained = replace(fit_evidence(decoupled, _spline_shapes(options, knots, True), common), rivals=rivals)
    polynomials = (
        fit_evidence(decoupled, _polynomial_shapes(options))
        if options.strokes.size > max(options.degrees) + 1
        else None
    )
    return constrained, judge_monotone(constrained, free, polynomials, decoupled)


def _spline_shapes(options: _CurveOptions, knots: tuple[float, ...], constrained: bool) -> Shapes:
    first, last = options.domain
    return (
        SplineShape(knots, True, constrained, scale=options.scale, first=first, last=last),
        SplineShape(knots, False, upper=LARGEST_RATIO, first=first, last=last),
    )


def _estimates(fit: CurveFit, options: _CurveOptions, prefix: str) -> dict[str, Estimate]:
    estimates: dict[str, Estimate] = {}
    for index, name in enumerate(NUMBERS):
        shape, part = fit.shapes[index], fit.part(index)
        values = shape.numbers(fit.theta[part])
        matrix = shape.scale * shape.numbers_matrix
        variance = np.einsum("ij,jk,ik->i", matrix, fit.covariance[part, part], matrix)
        letter, begin = (LETTERS[name], 1) if options.form == "polynomial" else ("y", 0)
        # A common error of b shifts the constant of a polynomial, but all knots of a spline.
        is_shifted = np.zeros_like(values)
        is_shifted[-1 if options.form == "polynomial" else slice(None)] = 1.0
        common_errors = fit.common[index] * (values if index == 0 else is_shifted)
        if isinstance(shape, SplineShape):
            variance = variance + fit.shape_variance(index, np.array(shape.table_knots))
        errors = np.sqrt(np.maximum(variance, 0.0) + common_errors**2)
        limits = (-math.inf, math.inf) if options.form == "polynomial" else (0.0, LARGEST_RATIO if index else math.inf)
        for k, (value, error) in enumerate(zip(values, errors, strict=True), start=begin):
            estimate = _estimate(float(value), UNITS[name], float(error), fit.misfits[index].coverage, limits)
            estimates[f"{prefix}{name}.{letter}{k}"] = estimate
    for f, value, variance in zip(
        fit.nuisance, fit.theta[fit.part(2)], np.diag(fit.covariance)[fit.part(2)], strict=True
    ):
        error = f.scale * math.sqrt(variance)
        estimates[f.name] = _estimate(f.scale * float(value), f.unit, error, fit.misfits[0].coverage, (f.low, f.high))
    return estimates


def _estimate(value: float, unit: str, error: float, coverage: float, limits: tuple[float, float]) -> Estimate:
    half, is_at_bound = coverage * error, value <= limits[0] or value >= limits[1] * (1.0 - BOUND)
    verdict = "at bound" if is_at_bound else verdict_on_interval(half, abs(value))
    return Estimate(value, unit, error, max(limits[0], value - half), min(limits[1], value + half), verdict)


def _comparison(fit: CurveFit, evidence: Sequence[TestEvidence], verdict: MonotoneVerdict | None) -> dict[str, Any]:
    statistics: dict[str, Any] = {
        "aicc": fit.aicc(),
        "free_numbers": fit.size,
        "samples": fit.freedom + fit.size,
        "chi_square": fit.chi_square,
        "degrees_of_freedom": fit.freedom,
        "chi_square_probability": [m.probability for m in fit.misfits],
        "runs_probability": [few_runs_probability(curve_residuals(fit, evidence, k)) for k in (0, 1)],
    }
    return statistics | ({"monotone": asdict(verdict)} if verdict else {})


def _confidence_bands(
    fit: CurveFit, evidence: Sequence[TestEvidence], options: _CurveOptions
) -> list[tuple[Array, Array]]:
    """Return lower and upper limits of the 95 % bands of C and b at evenly spaced strokes."""
    x = np.linspace(*options.domain, DRAWN)
    limits = ((0.0, np.inf), (0.0, 1.0))
    if options.bootstrap:
        bootstrap_evidence = [e.decoupled() for e in evidence] if options.form == "spline" else evidence
        bands = list(bootstrap_bands(fit, bootstrap_evidence, x, options.bootstrap, options.seed))
        for k, ends in enumerate(bands):  # all bootstrap fits have the same knots
            curve, shape = fit.curve(k, x), 1.96 * np.sqrt(np.maximum(fit.shape_variance(k, x), 0.0))
            bands[k] = (curve - np.hypot(curve - ends[0], shape), curve + np.hypot(ends[1] - curve, shape))
    else:
        halves = [fit.misfits[k].coverage * fit.standard_uncertainty(k, x) for k in (0, 1)]
        bands = [(fit.curve(k, x) - halves[k], fit.curve(k, x) + halves[k]) for k in (0, 1)]
    return [(np.clip(low, *limits[k]), np.clip(high, *limits[k])) for k, (low, high) in enumerate(bands)]


def _series(
    fit: CurveFit, evidence: Sequence[TestEvidence], options: _CurveOptions, bands: list[tuple[Array, Array]]
) -> dict[str, Any]:
    x = np.linspace(*options.domain, DRAWN)
    series = {}
    for index, name in enumerate(NUMBERS):
        strokes, points, errors = determined_values(evidence, index)
        series[name] = {
            "x": x,
            "y": fit.curve(index, x),
            "low": bands[index][0],
            "high": bands[index][1],
            "points_x": strokes,
            "points_y": points,
            "points_low": points - 1.96 * errors,
            "points_high": points + 1.96 * errors,
            "unit": UNITS[name],
            "x_unit": "m",
            "x_name": "stroke",
        }
    return series


def _conditions(
    options: _CurveOptions, fit: CurveFit, evidence: Sequence[TestEvidence], joint: bool, common: tuple[float, float]
) -> dict[str, Any]:
    knots = fit.shapes[0].table_knots if isinstance(fit.shapes[0], SplineShape) else ()
    names = [e.name for e in evidence]
    labels = [n if names.count(n) == 1 else f"{n} ({k + 1})" for k, n in enumerate(names)]
    return {
        "form": options.form,
        "way": "joint" if joint else "test by test",
        "domain": list(options.domain),
        "tested": [float(options.strokes[0]), float(options.strokes[-1])],
        **({"knots": list(knots)} if knots else {"argument_unit": "mm"}),
        "common_uncertainty": list(common),
        "bands": (f"bootstrap of {options.bootstrap}" if options.bootstrap else "delta method") + ", at each stroke",
        "evaluations": fit.evaluations,
        "tests": {
            label: [float(v) for v in (e.stroke, *e.centre, *e.uncertainty)]
            for label, e in zip(labels, evidence, strict=True)
        },
    }
