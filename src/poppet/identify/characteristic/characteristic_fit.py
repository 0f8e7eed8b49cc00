"""Curves C(x) and b(x) from tests at strokes: the weighted fit to what each says, the joint fit to all histories."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.identify.characteristic.characteristic_shapes import LARGEST_RATIO, Shape, start
from poppet.identify.characteristic.stroke_tests import StrokeRecording, TestEvidence, own_free
from poppet.identify.fit.experiment import FAILED, Experiment
from poppet.identify.fit.optima import NEARLY_ADIABATIC, NEARLY_ISOTHERMAL, kappa_of, thermal_units
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.gum import chi_square_probability, corrected_penalty, coverage_factor
from poppet.timeseries.checks import FloatArray as Array

Shapes = tuple[Shape, Shape]

DOUBT = 0.05
"""Probability of the misfit below which the tests scatter more than they should, and the intervals are widened."""
STATED = 8
"""Degrees of freedom of a stated uncertainty: as many as let it be wrong by a quarter (GUM, G.4.2)."""
SMALLEST = 1e-6
"""Smallest C of a trial, over the largest one: a search may step over zero, the model may not."""
PRECISION = 1e-10
ALIKE = 1.92
"""Half the sum of squares, beyond the least one, up to which another place is as good: half of chi-square at 95 %."""
APART = 0.01
"""Relative difference of C from which another place is another answer."""


class HistoryTerm:
    """A test by its recorded histories; its own fit gives the noise."""

    def __init__(self, test: StrokeRecording, evidence: TestEvidence) -> None:
        assert evidence.optimum is not None
        self.free, self.nuisance = own_free(test), test.free
        self.experiment = Experiment(test.circuit.instance, test.measurement, self.free)
        self.sigmas = np.array(evidence.optimum.sigmas) * math.sqrt(evidence.widening)
        self.largest = float(evidence.centre[0])

    def evaluate(self, z: Array, nuisance: Array) -> tuple[Array, Array]:
        """Residuals of all samples of all channels."""
        held = np.array([max(z[0], SMALLEST * self.largest), min(max(z[1], 0.0), LARGEST_RATIO)])
        series, slopes = self.experiment.outputs_and_slopes(by_name(self.free, (*held, *nuisance)))
        channels = self.experiment.measurement.channels
        weighted = [(y - c.values) / s for y, c, s in zip(series, channels, self.sigmas, strict=True)]
        residual = np.nan_to_num(np.concatenate(weighted), nan=FAILED)
        rows = np.vstack([slope / s for slope, s in zip(slopes, self.sigmas, strict=True)])
        return residual, np.nan_to_num(rows, nan=0.0, posinf=0.0, neginf=0.0)


@dataclass(frozen=True, eq=False)
class Misfit:
    """How far the tests lie from a curve, in their own uncertainties."""

    chi_square: float  # sum of squares beyond what the tests on their own leave
    freedom: int

    @property
    def probability(self) -> float:
        """Of a larger misfit when curves and uncertainties are right."""
        return chi_square_probability(self.chi_square, self.freedom)

    @property
    def widening(self) -> float:
        """Factor on the variances (Birge's ratio squared), 1 where the tests scatter no more than they should."""
        return max(1.0, self.chi_square / self.freedom) if self.probability < DOUBT else 1.0

    @property
    def coverage(self) -> float:
        """Half a 95 % interval over a standard uncertainty.

        The tests' own uncertainties are known as well: one degree of freedom of the misfit is not all there is.
        """
        return coverage_factor(self.freedom + STATED if self.widening > 1.0 else math.inf)


@dataclass(frozen=True, eq=False)
class CurveFit:
    """Curves after the fit."""

    shapes: Shapes  # of C and b
    theta: Array  # free numbers of both, then those of the bench over their scale
    nuisance: tuple[FreeParameter, ...]  # numbers of the bench
    # Of theta, widened; the bounds are left out of account, so that no constraint makes an interval narrower.
    covariance: Array
    misfits: tuple[Misfit, Misfit]  # of C and b; one and the same where they were fitted with their correlation
    common: tuple[float, float]  # relative standard uncertainty of all C together, and that of all b together
    evaluations: int  # of all tests with slopes
    cost: float = math.nan  # half the sum of squares
    twin: CurveFit | None = None  # other curves that the data cannot tell from these

    def part(self, which: int) -> slice:
        """Where the free numbers of C (0), b (1) or the bench (2) stand in theta."""
        first, second = self.shapes[0].size, self.shapes[0].size + self.shapes[1].size
        return (slice(0, first), slice(first, second), slice(second, self.theta.size))[which]

    def curve(self, which: int, x: Array) -> Array:
        """C (0) or b (1) at strokes, (n,)."""
        return self.shapes[which].values(self.theta[self.part(which)], x)

    def standard_uncertainty(self, which: int, x: Array) -> Array:
        """Of C (0) or b (1) at strokes by the delta method, what is common to all tests included, (n,)."""
        part = self.part(which)
        slopes = self.shapes[which].slopes(self.theta[part], x)
        variance = np.einsum("ij,jk,ik->i", slopes, self.covariance[part, part], slopes)
        shared = self.common[which] * (self.curve(0, x) if which == 0 else np.ones_like(x))
        return np.asarray(np.sqrt(np.maximum(variance, 0.0) + shared**2))

    @property
    def chi_square(self) -> float:
        """Misfit of both curves."""
        return sum(m.chi_square for m in dict.fromkeys(self.misfits))

    @property
    def freedom(self) -> int:
        """Degrees of freedom of the misfit of both curves."""
        return sum(m.freedom for m in dict.fromkeys(self.misfits))

    @property
    def size(self) -> int:
        """Number of free numbers of the curves."""
        return self.shapes[0].size + self.shapes[1].size

    def aicc(self) -> float:
        """Corrected information criterion of the curves with known noise; less is better."""
        return self.chi_square + corrected_penalty(self.size, self.freedom + self.size)


@dataclass
class _Objective:
    """Residuals of all tests as a function of theta."""

    terms: Sequence[TestEvidence | HistoryTerm]
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
            own = np.array([bench[f.name] for f in term.nuisance])
            residual, by_z = term.evaluate(np.array([curves[0][k], curves[1][k]]), own)
            bench_rows = np.zeros((residual.size, scales.size))
            for column, f in enumerate(term.nuisance):
                place = self.nuisance.index(f)
                bench_rows[:, place] = by_z[:, 2 + column] * scales[place]
            # The chain rule: a test knows two numbers, whatever the curves have.
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
    """Weighted fit of the curves to what each test says on its own."""
    strokes = np.array([e.stroke for e in evidence])
    objective = _Objective(evidence, strokes, shapes, ())
    centres = np.array([e.centre for e in evidence])
    weights = 1.0 / np.array([e.uncertainty for e in evidence])
    first = np.concatenate([start(s, strokes, centres[:, i], weights[:, i]) for i, s in enumerate(shapes)])
    return _fitted(objective, first, evidence, 0.0, common)


def fit_histories(
    tests: Sequence[Any],
    evidence: Sequence[TestEvidence],
    begin: CurveFit,
    progress: Callable[[int, float], Any] | None = None,
) -> CurveFit:
    """One fit of all coefficients to all recorded histories at once."""
    pairs = list(zip(tests, evidence, strict=True))
    terms = [HistoryTerm(t, e) if isinstance(t, StrokeRecording) else e for t, e in pairs]
    nuisance = tuple(dict.fromkeys(f for term in terms for f in term.nuisance))
    objective = _Objective(terms, np.array([e.stroke for e in evidence]), begin.shapes, nuisance, progress)
    bench = []
    for f in nuisance:
        own = [float(e.optimum.x[2 + t.free.index(f)]) for t, e in pairs if e.optimum is not None and f in t.free]
        bench.append(float(np.clip(np.median(own), f.low, f.high)) / f.scale)
    # What each test leaves on its own is no misfit of the curves.
    alone = sum(2.0 * e.optimum.cost / e.widening for e in evidence if e.optimum is not None)
    alone += sum(float(e.pull @ e.pull) for e in evidence if e.optimum is None)
    theta = np.concatenate([begin.theta, bench])
    fits = [_fitted(objective, theta, evidence, alone, begin.common)]
    fits += [_fitted(objective, other, evidence, alone, begin.common) for other in _other_ends(objective, fits[0])]
    best = min(fits, key=lambda fit: fit.cost)
    limit = best.cost + ALIKE * best.misfits[0].widening
    curves = {fit: fit.curve(0, objective.strokes) for fit in fits}
    rivals = [f for f in fits if f.cost < limit and np.max(np.abs(curves[f] / curves[best] - 1.0)) > APART]
    return replace(best, twin=min(rivals, key=lambda fit: fit.cost)) if rivals else best


def _other_ends(objective: _Objective, fit: CurveFit) -> Iterator[Array]:
    """Where to begin again with wall heat that only pressures speak of: at the end far from the one that was found.

    A charge is the same with an adiabatic tank and C as with an isothermal one and kappa C.
    """
    experiments = [term.experiment for term in objective.terms if isinstance(term, HistoryTerm)]
    for place, unit in thermal_units(experiments, objective.nuisance).items():
        theta, wall = fit.theta.copy(), fit.part(2).start + place
        kappa, scale = kappa_of(experiments[0]), objective.nuisance[place].scale
        is_adiabatic = theta[wall] * scale < unit
        theta[fit.part(0)] *= kappa if is_adiabatic else 1.0 / kappa
        theta[wall] = (NEARLY_ISOTHERMAL if is_adiabatic else NEARLY_ADIABATIC) * unit / scale
        yield theta


def _fitted(
    objective: _Objective, theta: Array, evidence: Sequence[TestEvidence], alone: float, common: tuple[float, float]
) -> CurveFit:
    from scipy.optimize import least_squares

    ends = [s.bounds for s in objective.shapes]
    bench = [(f.low / f.scale, f.high / f.scale) for f in objective.nuisance]
    ends.append((np.array([low for low, _ in bench]), np.array([high for _, high in bench])))
    low, high = (np.concatenate([pair[i] for pair in ends]) for i in (0, 1))
    found = least_squares(
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
    residual, rows = objective(found.x)
    misfits = _misfits(objective, evidence, residual, alone)
    widenings = [np.full(shape.size, m.widening) for shape, m in zip(objective.shapes, misfits, strict=True)]
    wide = np.sqrt(np.concatenate([*widenings, np.full(len(objective.nuisance), misfits[0].widening)]))
    # (J^T J)^-1 by singular values; directions without any information get a very large variance.
    _, s, vt = np.linalg.svd(rows, full_matrices=False)
    s = np.maximum(s, 1e-9 * max(float(s[0]), 1e-300))
    covariance = np.asarray((vt.T / s**2) @ vt) * np.outer(wide, wide)
    count, cost = objective.evaluations, 0.5 * float(residual @ residual)
    return CurveFit(objective.shapes, found.x, objective.nuisance, covariance, misfits, common, count, cost)


def _misfits(
    objective: _Objective, evidence: Sequence[TestEvidence], residual: Array, alone: float
) -> tuple[Misfit, Misfit]:
    """One misfit for both curves, or one each where no test couples them."""
    seen = np.isfinite([e.uncertainty for e in evidence]).sum(axis=0)
    sizes = [shape.size for shape in objective.shapes]
    if objective.nuisance or alone or any(e.root[0, 1] for e in evidence):
        saved = sum(sum(f in term.nuisance for term in objective.terms) - 1 for f in objective.nuisance)
        square = max(0.0, float(residual @ residual) - alone)
        both = Misfit(square, int(seen.sum()) - sum(sizes) + saved)
        return both, both
    squares = np.sum(residual.reshape(-1, 2) ** 2, axis=0)
    first, second = (Misfit(float(squares[i]), int(seen[i]) - sizes[i]) for i in (0, 1))
    return first, second


def bootstrap_bands(
    fit: CurveFit, evidence: Sequence[TestEvidence], x: Array, count: int, seed: int
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """95 % bands of C and b by a parametric bootstrap of the tests, bounds and constraints included."""
    generator = np.random.default_rng(seed)
    strokes = np.array([e.stroke for e in evidence])
    truth = np.column_stack([fit.curve(0, strokes), fit.curve(1, strokes)])
    wide = np.sqrt([m.widening for m in fit.misfits])
    found: tuple[list[Array], list[Array]] = ([], [])
    for _ in range(count):
        noise = generator.standard_normal((strokes.size, 2)) * wide
        drawn = [replace(e, centre=z, pull=n) for e, z, n in zip(evidence, truth, noise, strict=True)]
        again = fit_evidence(drawn, fit.shapes)
        shared = generator.standard_normal(2) * fit.common
        found[0].append(again.curve(0, x) * (1.0 + shared[0]))
        found[1].append(again.curve(1, x) + shared[1])
    ends = [np.quantile(np.array(curves), (0.025, 0.975), axis=0) for curves in found]
    return (ends[0][0], ends[0][1]), (ends[1][0], ends[1][1])
