"""Fits of the curves C(x) and b(x), either to C and b of each test or to all recorded samples."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.characteristic.characteristic_shapes import LARGEST_RATIO, Shape, start_parameters
from poppet.identify.characteristic.stroke_tests import StrokeRecording, StrokeTest, TestEvidence, free_parameters
from poppet.identify.fit.experiment import FAILED, Experiment
from poppet.identify.fit.optima import (
    NEARLY_ADIABATIC,
    NEARLY_ISOTHERMAL,
    isentropic_exponent_of,
    typical_wall_conductances,
)
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.gum import SPREAD, chi_square_probability, coverage_factor
from poppet.timeseries.checks import FloatArray as Array

Shapes = tuple[Shape, Shape]

DOUBT = 0.05
"""Probability of the lack of fit below which the intervals are enlarged."""
STATED = 8
"""Degrees of freedom of a stated uncertainty, for a relative error of one quarter (GUM, G.4.2)."""
SMALLEST = 1e-6
"""Smallest C of a trial, relative to the maximum: the model needs a positive C."""
PRECISION = 1e-10
ALIKE = 1.92
"""Increase in cost up to which optima are equivalent: half of chi-square at 95 %."""
APART = 0.01
"""Relative difference of C above which optima are distinct."""


class RecordingTerm:
    """Residuals of the samples of one recorded test, as a function of C, b and parameters of the test bench.

    They are divided by the noise that a fit to this test alone has estimated.
    """

    def __init__(self, test: StrokeRecording, evidence: TestEvidence) -> None:
        assert evidence.optimum is not None
        self.free, self.nuisance = free_parameters(test), test.free
        self.experiment = Experiment(test.circuit.instance, test.measurement, self.free)
        self.sigmas = np.array(evidence.optimum.sigmas) * math.sqrt(evidence.widening)
        self.largest = float(evidence.centre[0])

    def evaluate(self, z: Array, nuisance: Array) -> tuple[Array, Array]:
        """Return the weighted residuals of all samples of a test, (n,), and their derivatives, (n, 2 + n_nuisance).

        `z` contains C and b at the stroke of the test. `nuisance` contains the free parameters of the bench, such as a
        wall conductance.
        """
        law_values = np.array([max(z[0], SMALLEST * self.largest), min(max(z[1], 0.0), LARGEST_RATIO)])
        values = by_name(self.free, (*law_values, *nuisance))
        series, slopes = self.experiment.outputs(values), self.experiment.slopes(values)
        channels = self.experiment.measurement.channels
        weighted = [(y - c.values) / s for y, c, s in zip(series, channels, self.sigmas, strict=True)]
        residual = np.nan_to_num(np.concatenate(weighted), nan=FAILED)
        rows = np.vstack([slope / s for slope, s in zip(slopes, self.sigmas, strict=True)])
        return residual, np.nan_to_num(rows, nan=0.0, posinf=0.0, neginf=0.0)


@dataclass(frozen=True, eq=False)
class LackOfFit:
    """Chi-square of the deviations between tests and curves, with its degrees of freedom."""

    chi_square: float  # sum of squared residuals minus that of the separate fits to the tests
    freedom: int

    @property
    def probability(self) -> float:
        """Probability of a larger chi-square, if the curves and the stated uncertainties are correct."""
        return chi_square_probability(self.chi_square, self.freedom)

    @property
    def widening(self) -> float:
        """Factor by which the lack of fit increases the variances (square of Birge's ratio).

        The factor is 1 if the deviations agree with the stated uncertainties.
        """
        return max(1.0, self.chi_square / self.freedom) if self.probability < DOUBT else 1.0

    @property
    def coverage(self) -> float:
        """Ratio of the half width of a 95 % interval to the standard uncertainty.

        The ratio belongs to the normal distribution, or to Student's t distribution if the lack of fit enlarges the
        uncertainty. Its degrees of freedom are then the degrees of freedom of the lack of fit, plus a constant for the
        stated uncertainties.
        """
        return coverage_factor(self.freedom + STATED if self.widening > 1.0 else math.inf)


@dataclass(frozen=True, eq=False)
class CurveFit:
    """Fitted curves of sonic conductance C and critical ratio b versus stroke."""

    shapes: Shapes  # shapes of C and b
    theta: Array  # free parameters of C, of b, then the scaled parameters of the bench
    nuisance: tuple[FreeParameter, ...]  # parameters of the bench
    # Covariance of theta, with the variance factor. Bounds are ignored: a constraint must not make intervals narrower.
    covariance: Array
    misfits: tuple[LackOfFit, LackOfFit]  # lack of fit of C and b; the same object if a test couples C and b
    common: tuple[float, float]  # standard uncertainties of errors that all tests share: of C (relative) and of b
    evaluations: int  # number of evaluations of all tests
    cost: float = math.nan  # half the sum of squared residuals
    twin: CurveFit | None = None  # equivalent curves
    rivals: tuple[CurveFit, ...] = ()  # unconstrained splines with all compared selections of knots, the best one first
    strokes: tuple[Array, Array] = (np.empty(0), np.empty(0))  # strokes of the tests that determine C and b, ascending

    def part(self, index: int) -> slice:
        """Return the slice of `theta`, the vector of free parameters, that belongs to C, b or the test bench.

        `index` is 0 for C, 1 for b and 2 for the bench.
        """
        first, second = self.shapes[0].size, self.shapes[0].size + self.shapes[1].size
        return (slice(0, first), slice(first, second), slice(second, self.theta.size))[index]

    def curve(self, index: int, x: Array) -> Array:
        """Return C or b at the strokes `x`, (n,).

        `index` is 0 for C and 1 for b.
        """
        return self.shapes[index].values(self.theta[self.part(index)], x)

    def standard_uncertainty(self, index: int, x: Array) -> Array:
        """Return the standard uncertainty of C or b at the strokes `x`, (n,).

        `index` is 0 for C and 1 for b. The uncertainty includes the errors that all tests share, and the unknown shape
        of the curve.
        """
        shared = self.common[index] * (self.curve(0, x) if index == 0 else np.ones_like(x))
        variance = self._variance(index, x) + self.shape_variance(index, x)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0) + shared**2))

    def _variance(self, index: int, x: Array) -> Array:
        """Return the variance of C or b at the strokes `x`, (n,), if the shape of the curve is correct.

        `index` is 0 for C and 1 for b.
        """
        part = self.part(index)
        slopes = self.shapes[index].slopes(self.theta[part], x)
        return np.asarray(np.einsum("ij,jk,ik->i", slopes, self.covariance[part, part], slopes))

    def shape_variance(self, index: int, x: Array) -> Array:
        r"""Return the variance caused by the unknown shape of C or b at the strokes `x`, (n,).

        `index` is 0 for C and 1 for b. In the formula, y is the fitted curve, and l the straight lines between the
        tests. y_k is a spline with another selection k of knots, and u_k its standard uncertainty. k = 0 is the best
        selection.

        .. math::

            (y - \ell)^2 + \sum_k w_k \left[(y_k - y_0)^2 + u_k^2\right] - u_0^2, \qquad
            w_k \propto e^{-(\mathrm{AIC}_k - \mathrm{AIC}_0)/2}

        Notes
        -----
        The first term is the uncertainty of the interpolation between the tests. Polynomials that describe the tests
        do not have it. The other terms are the uncertainty of the selection of knots. They can be slightly negative.

        References
        ----------
        Burnham & Anderson 2002, Model Selection and Multimodel Inference, section 4.3.2.
        """
        variance = np.zeros_like(x)
        if self.rivals or self.misfits[index].widening > 1.0:
            strokes = self.strokes[index]
            variance += (self.curve(index, x) - np.interp(x, strokes, self.curve(index, strokes))) ** 2
        if self.rivals:
            best, aicc = self.rivals[0], np.array([rival.aicc() for rival in self.rivals])
            shifts = np.array([rival.curve(index, x) - best.curve(index, x) for rival in self.rivals])
            sampling = np.array([rival._variance(index, x) for rival in self.rivals])
            variance += np.average(shifts**2 + sampling, axis=0, weights=np.exp(0.5 * (aicc[0] - aicc))) - sampling[0]
        return np.asarray(variance)

    @property
    def chi_square(self) -> float:
        """Sum of the squared, normalised deviations of all tests from the curves of C and b."""
        return sum(m.chi_square for m in dict.fromkeys(self.misfits))

    @property
    def freedom(self) -> int:
        """Degrees of freedom of `chi_square`, which measures the lack of fit of the curves of C and b."""
        return sum(m.freedom for m in dict.fromkeys(self.misfits))

    @property
    def size(self) -> int:
        """Number of free parameters of the curves of C and b together."""
        return self.shapes[0].size + self.shapes[1].size

    def aicc(self) -> float:
        """Return the information criterion AICc of the curves of C and b.

        The correction of Akaike's criterion for small samples applies only if the variance is estimated. Here the
        variances are known, so the correction is zero.
        """
        return self.chi_square + 2.0 * self.size


@dataclass
class _CurveObjective:
    """Function object that returns the residuals of all tests and their derivatives.

    Its argument is the vector of the free parameters of the curves of C and b, followed by the free parameters of the
    bench.
    """

    terms: Sequence[TestEvidence | RecordingTerm]
    strokes: Array
    shapes: Shapes
    nuisance: tuple[FreeParameter, ...]
    progress: Callable[[int, float], Any] | None = None
    evaluations: int = 0
    _last: tuple[bytes, Array, Array] | None = None

    def __call__(self, theta: Array) -> tuple[Array, Array]:
        if self._last is not None and self._last[0] == theta.tobytes():
            return self._last[1], self._last[2]
        first, second = self.shapes
        thetas = theta[: first.size], theta[first.size : first.size + second.size]
        scales = np.array([f.scale for f in self.nuisance])
        bench = dict(zip([f.name for f in self.nuisance], theta[first.size + second.size :] * scales, strict=True))
        curves = [s.values(t, self.strokes) for s, t in zip(self.shapes, thetas, strict=True)]
        slopes = [s.slopes(t, self.strokes) for s, t in zip(self.shapes, thetas, strict=True)]
        pieces, rows = [], []
        for k, term in enumerate(self.terms):
            bench_values = np.array([bench[f.name] for f in term.nuisance])
            residual, by_z = term.evaluate(np.array([curves[0][k], curves[1][k]]), bench_values)
            bench_rows = np.zeros((residual.size, scales.size))
            for column, f in enumerate(term.nuisance):
                index = self.nuisance.index(f)
                bench_rows[:, index] = by_z[:, 2 + column] * scales[index]
            # Chain rule: a test depends on C and b only.
            rows.append(np.hstack([np.outer(by_z[:, i], slopes[i][k]) for i in (0, 1)] + [bench_rows]))
            pieces.append(residual)
        self.evaluations += 1
        self._last = theta.tobytes(), np.concatenate(pieces), np.vstack(rows)
        if self.progress:
            self.progress(self.evaluations, 0.5 * float(self._last[1] @ self._last[1]))
        return self._last[1], self._last[2]


def fit_evidence(
    evidence: Sequence[TestEvidence], shapes: Shapes, common: tuple[float, float] = (0.0, 0.0)
) -> CurveFit:
    """Fit curves versus stroke to the values of C and b from the single tests.

    `evidence` contains these values, and `shapes` the forms of the curves. `common` contains the standard uncertainties
    of the errors that all tests share: of C (relative) and of b.
    """
    strokes = np.array([e.stroke for e in evidence])
    objective = _CurveObjective(evidence, strokes, shapes, ())
    centres = np.array([e.centre for e in evidence])
    weights = 1.0 / np.array([e.uncertainty for e in evidence])
    first = np.concatenate([start_parameters(s, strokes, centres[:, i], weights[:, i]) for i, s in enumerate(shapes)])
    return _fit_curves(objective, first, evidence, 0.0, common)


def fit_recordings(
    tests: Sequence[Any],
    evidence: Sequence[TestEvidence],
    first_fit: CurveFit,
    progress: Callable[[int, float], Any] | None = None,
) -> CurveFit:
    """Fit the curves of C and b to the recorded samples of all tests together.

    The search starts from `first_fit`, the fit to the values of C and b from the single tests (`evidence`).
    """
    pairs = list(zip(tests, evidence, strict=True))
    terms = [RecordingTerm(t, e) if isinstance(t, StrokeRecording) else e for t, e in pairs]
    nuisance = tuple(dict.fromkeys(f for term in terms for f in term.nuisance))
    objective = _CurveObjective(terms, np.array([e.stroke for e in evidence]), first_fit.shapes, nuisance, progress)
    bench = []
    for f in nuisance:
        single_values = [
            float(e.optimum.x[2 + t.free.index(f)]) for t, e in pairs if e.optimum is not None and f in t.free
        ]
        bench.append(float(np.clip(np.median(single_values), f.low, f.high)) / f.scale)
    # The residuals of the single tests are not a lack of fit of the curves.
    single_cost = sum(2.0 * e.optimum.cost / e.widening for e in evidence if e.optimum is not None)
    single_cost += sum(float(e.pull @ e.pull) for e in evidence if e.optimum is None)
    theta = np.concatenate([first_fit.theta, bench])
    fits = [_fit_curves(objective, theta, evidence, single_cost, first_fit.common)]
    # If no recorded temperature determines a wall conductance, search at the opposite thermal limit of the tank too: an
    # adiabatic charge with conductance C has the pressure of an isothermal charge with kappa C.
    experiments = [term.experiment for term in terms if isinstance(term, RecordingTerm)]
    for index, unit in typical_wall_conductances(experiments, nuisance).items():
        theta, wall = fits[0].theta.copy(), fits[0].part(2).start + index
        kappa, scale = isentropic_exponent_of(experiments[0]), nuisance[index].scale
        is_adiabatic = theta[wall] * scale < unit
        theta[fits[0].part(0)] *= kappa if is_adiabatic else 1.0 / kappa
        theta[wall] = (NEARLY_ISOTHERMAL if is_adiabatic else NEARLY_ADIABATIC) * unit / scale
        fits.append(_fit_curves(objective, theta, evidence, single_cost, first_fit.common))
    best = min(fits, key=lambda fit: fit.cost)
    limit = best.cost + ALIKE * best.misfits[0].widening
    curves = {fit: fit.curve(0, objective.strokes) for fit in fits}
    equivalent = [f for f in fits if f.cost < limit and np.max(np.abs(curves[f] / curves[best] - 1.0)) > APART]
    twin = min(equivalent, key=lambda fit: fit.cost, default=None)
    return replace(best, twin=twin and replace(twin, rivals=first_fit.rivals), rivals=first_fit.rivals)


def _fit_curves(
    objective: _CurveObjective,
    theta: Array,
    evidence: Sequence[TestEvidence],
    single_cost: float,
    common: tuple[float, float],
) -> CurveFit:
    """Return the fit of the curves of C and b from a search that starts at `theta`.

    `objective` returns the residuals of all tests. `single_cost` is the sum of squares that remains after separate fits
    to the tests; it is not a lack of fit of the curves. `common` contains the errors that all tests share.
    """
    from scipy.optimize import least_squares

    ends = [s.bounds for s in objective.shapes]
    bench = [(f.low / f.scale, f.high / f.scale) for f in objective.nuisance]
    ends.append((np.array([low for low, _ in bench]), np.array([high for _, high in bench])))
    low, high = (np.concatenate([pair[i] for pair in ends]) for i in (0, 1))
    solution = least_squares(
        lambda t: objective(t)[0],
        np.clip(theta, low, high),
        jac=lambda t: objective(t)[1],
        bounds=(low, high),
        x_scale="jac",
        ftol=PRECISION,
        xtol=PRECISION,
        gtol=PRECISION,
        max_nfev=200,
    )
    residual, rows = objective(solution.x)
    is_determined = np.isfinite([e.uncertainty for e in evidence])
    n_determined = is_determined.sum(axis=0)
    sizes = [shape.size for shape in objective.shapes]
    if objective.nuisance or single_cost or any(e.root[0, 1] for e in evidence):  # a test couples C and b
        saved = sum(sum(f in term.nuisance for term in objective.terms) - 1 for f in objective.nuisance)
        square = max(0.0, float(residual @ residual) - single_cost)
        misfits = (LackOfFit(square, int(n_determined.sum()) - sum(sizes) + saved),) * 2
    else:
        squares = np.sum(residual.reshape(-1, 2) ** 2, axis=0)
        first, second = (LackOfFit(float(squares[i]), int(n_determined[i]) - sizes[i]) for i in (0, 1))
        misfits = first, second
    widenings = [np.full(shape.size, m.widening) for shape, m in zip(objective.shapes, misfits, strict=True)]
    wide = np.sqrt(np.concatenate([*widenings, np.full(len(objective.nuisance), misfits[0].widening)]))
    # (J^T J)^-1 from singular values; directions without information have a very large variance.
    _, s, vt = np.linalg.svd(rows, full_matrices=False)
    s = np.maximum(s, 1e-9 * max(float(s[0]), 1e-300))
    covariance = np.asarray((vt.T / s**2) @ vt) * np.outer(wide, wide)
    first_strokes, second_strokes = (np.unique(objective.strokes[mask]) for mask in is_determined.T)
    return CurveFit(
        objective.shapes,
        solution.x,
        objective.nuisance,
        covariance,
        misfits,
        common,
        objective.evaluations,
        cost=0.5 * float(residual @ residual),
        strokes=(first_strokes, second_strokes),
    )


def bootstrap_bands(
    fit: CurveFit, evidence: Sequence[TestEvidence], x: Array, count: int, seed: int
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Return the lower and upper limits of the 95 % bands of C and b at the strokes `x`.

    The bands are from a parametric bootstrap with `count` fits. Each fit uses random errors of all tests, and satisfies
    all constraints of the curves.
    """
    generator = np.random.default_rng(seed)
    strokes = np.array([e.stroke for e in evidence])
    truth = np.column_stack([fit.curve(0, strokes), fit.curve(1, strokes)])
    wide = np.sqrt([m.widening for m in fit.misfits])
    curve_samples: tuple[list[Array], list[Array]] = ([], [])
    for _ in range(count):
        noise = generator.standard_normal((strokes.size, 2)) * wide
        samples = [replace(e, centre=z, pull=n) for e, z, n in zip(evidence, truth, noise, strict=True)]
        refit = fit_evidence(samples, fit.shapes)
        shared = generator.standard_normal(2) * fit.common
        curve_samples[0].append(refit.curve(0, x) * (1.0 + shared[0]))
        curve_samples[1].append(refit.curve(1, x) + shared[1])
    ends = [np.quantile(np.array(curves), (0.025, 0.975), axis=0) for curves in curve_samples]
    return (ends[0][0], ends[0][1]), (ends[1][0], ends[1][1])


TEMPERATURE = "temperature"


@dataclass(frozen=True)
class AmbientUncertainty:
    """Relative standard uncertainties that result from assumed temperatures.

    A temperature is assumed if it is neither stated nor recorded.
    """

    unstated: tuple[str, ...]  # addresses of the temperatures that are not stated
    conductance: float  # relative standard uncertainty that all values of C share
    shares: dict[str, float]  # relative standard uncertainty by free parameter

    def note(self, names: Sequence[str]) -> Note:
        """Return a finding that the uncertainty of assumed temperatures is included in intervals.

        `names` contains the parameters with these intervals.
        """
        facts = {"percent": 100.0 * self.conductance / SPREAD, "spread": SPREAD, "untold": self.unstated}
        return Note("characteristic.room", "sonic_conductance", **facts, names=tuple(names))


def ambient_uncertainty(tests: Sequence[StrokeTest], evidence: Sequence[TestEvidence]) -> AmbientUncertainty | None:
    """Return the uncertainty that results from temperatures that are neither stated nor recorded.

    The result is None if no recorded test has such a temperature.
    """
    unstated, largest = list[str](), dict[str, float]()
    for test, test_evidence in zip(tests, evidence, strict=True):
        if not isinstance(test, StrokeRecording) or test_evidence.optimum is None:
            continue
        channels = *test.measurement.channels, *test.measurement.inputs
        recorded = [c.address for c in channels] + [*test.measurement.start]
        defaults = {
            address: number.value
            for address, number in test.circuit.numbers().items()
            if address.endswith(TEMPERATURE) and number.source.kind == "standard"
        }
        if not defaults or any(address.endswith(TEMPERATURE) for address in recorded):
            continue
        unstated += defaults
        # Relative changes of the free parameters if the default temperatures rise by `SPREAD`, to first order.
        x = test_evidence.optimum.x
        warm = test.circuit.with_values({address: value + SPREAD for address, value in defaults.items()})
        (cold, slopes), (warmer, _) = (
            RecordingTerm(t, test_evidence).evaluate(x[:2], x[2:]) for t in (test, replace(test, circuit=warm))
        )
        shifts = np.linalg.lstsq(slopes * x, cold - warmer, rcond=None)[0]
        for f, shift in zip(free_parameters(test), shifts, strict=True):
            largest[f.name] = max(abs(float(shift)), largest.get(f.name, 0.0))
    if not unstated:
        return None
    conductance = max(shift for name, shift in largest.items() if name.endswith(".sonic_conductance"))
    return AmbientUncertainty(tuple(dict.fromkeys(unstated)), conductance, largest)
