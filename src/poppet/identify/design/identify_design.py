"""Method `identify design`: selection of the tests with the smallest predicted intervals."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.toml import ResultFileMixin
from poppet.identify.design.design_file import DesignPlan, TestCandidate, read_design_file
from poppet.identify.design.simulated_fits import (
    SimulatedEstimate,
    empty_measurement,
    noise_free_values,
    simulate_fits,
    with_values,
)
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_plan import offset_parameters, recording_parameters
from poppet.identify.fit.statistics import verdict
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.result import VERDICTS, Verdict
from poppet.timeseries.checks import FloatArray

TWO_SIDED = 1.96
ROUNDING = 1e-13
"""Lower limit on the eigenvalues of an information matrix with a unit diagonal."""
WIDER = 2.0
"""Ratio of the error in simulated fits to the predicted error above which a finding reports the difference."""
LOST = 1e-10
"""Relative limit below which a direction of the nuisance parameters counts as singular."""


@dataclass(frozen=True)
class Prediction:
    """Expected estimate of one parameter after one or several tests.

    Parameters
    ----------
    value : float
        Assumed value, in `unit`.
    unit : str
        SI unit.
    standard_error : float
        Standard error caused by noise and sensor offsets, in `unit`.
    typical : float
        Geometric mean of the standard errors at the assumed values and at all samples of the priors, in `unit`.
    largest : float
        Largest standard error over all samples of the priors, in `unit`.
    verdict : str
        Predicted verdict of a fit: `determined`, `weak` or `not determined`.
    scale : float
        Reference of relative errors, in `unit`: the assumed value, or the typical size of a parameter that is zero.
    """

    value: float
    unit: str
    standard_error: float
    typical: float
    largest: float
    verdict: Verdict
    scale: float = field(default=1.0, repr=False)

    @property
    def half(self) -> float:
        """Half width of the 95 % confidence interval of the parameter, in its unit."""
        return TWO_SIDED * self.standard_error

    @property
    def largest_half_width(self) -> float:
        """Half width of the 95 % interval at the least favourable sample of the priors."""
        return TWO_SIDED * self.largest

    @property
    def typical_half_width(self) -> float:
        """Geometric mean of the half widths of the 95 % intervals at all samples of the priors."""
        return TWO_SIDED * self.typical

    def __getattr__(self, name: str) -> float:
        former_names = {"half_at_most": "largest_half_width", "half_typical": "typical_half_width"}
        if name not in former_names:
            raise AttributeError(name)
        warnings.warn(f"Prediction.{name} is now called {former_names[name]}.", DeprecationWarning, stacklevel=2)
        return float(getattr(self, former_names[name]))


@dataclass(frozen=True)
class Design(ResultFileMixin):
    """Possible tests in the order of their benefit, with the recommended tests.

    Parameters
    ----------
    title : str
        Title of the design.
    criterion : str
        Minimised quantity: `intervals` (geometric mean of the relative standard errors), `worst` (largest relative
        standard error) or `volume` (volume of the joint confidence region). The errors are the geometric means over
        the assumed values and the samples of the priors.
    tests : mapping
        Mapping from the name of each candidate to its predictions by parameter, the best candidate first. A prediction
        uses this test and the prior information.
    chosen : tuple of str
        Recommended tests. A test can occur more than once.
    together : mapping
        Mapping from each parameter to its prediction from all recommended tests together.
    scores : mapping
        Mapping from the name of each candidate to the natural logarithm of its criterion; smaller is better.
    remarks : tuple of Note
        Findings.
    interrupted : bool
        True if the user interrupted the ranking before all candidates were evaluated, or the simulated fits.
    simulated : mapping
        Mapping from each parameter to its estimates in fits to simulated recordings of all recommended tests. It is
        empty if no fit was simulated.
    """

    title: str
    criterion: str
    tests: Mapping[str, Mapping[str, Prediction]]
    chosen: tuple[str, ...]
    together: Mapping[str, Prediction]
    scores: Mapping[str, float]
    remarks: tuple[Note, ...] = field(default=())
    interrupted: bool = False
    simulated: Mapping[str, SimulatedEstimate] = field(default_factory=dict)

    def ranked_by(self) -> dict[str, float]:
        """Return the criterion of each test, as the half width of a relative 95 % interval [%].

        For `intervals` it is the geometric mean over all parameters, and for `worst` their maximum. For `volume` it is
        the geometric mean of the semi-axes of the joint confidence region.
        """
        axes = len(self.together) if self.criterion == "volume" else 1
        return {test: 100.0 * TWO_SIDED * math.exp(score / axes) for test, score in self.scores.items()}

    def content(self) -> dict[str, Any]:
        """Return the content of the design result file as nested tables."""
        return {
            "method": "design",
            "title": self.title,
            "criterion": self.criterion,
            "chosen": list(self.chosen),
            "together": {name: vars(p).copy() for name, p in self.together.items()},
            "scores": dict(self.scores),
            "ranked_by": self.ranked_by(),
            "simulated": {name: vars(estimate).copy() for name, estimate in self.simulated.items()},
            "tests": {test: {name: vars(p).copy() for name, p in row.items()} for test, row in self.tests.items()},
            "interrupted": self.interrupted,
            "findings": [str(remark) for remark in self.remarks],
        }


def identify_design(plan: DesignPlan | str | Path, *, progress: Callable[[int, int, str], Any] | None = None) -> Design:
    r"""Rank possible tests by the predicted confidence intervals of a fit to their recordings.

    Parameters
    ----------
    plan : DesignPlan, str or Path
        Free parameters, sensors and candidates, or a design file.
    progress : callable, optional
        Function that is called with the number of evaluated candidates, their total number and the name of the next
        one.

    Returns
    -------
    Design
        Candidates with predicted standard errors, the best first, and the recommended tests.

    Notes
    -----
    The Fisher information of a test is

    .. math:: I = S^T S - S^T N (N^T N + P)^{-1} N^T S

    where S is the sensitivity of the noise-free recording to the free parameters, divided by the noise of each sample.
    N is the sensitivity to the nuisance parameters (initial values, lags, offsets of sensors), and P is their prior
    information. A fit estimates the same nuisance parameters with the same priors. The information of several tests
    adds up. A parameter without a prior has a prior standard deviation of 100 %. Tests that determine only some of the
    parameters are then comparable.

    The prediction is valid **if the circuit is correct and the assumed values are approximately correct**. The
    sensitivities are also computed at samples of the priors, and the criterion is the mean over all these points.
    The recommended tests are then simulated with noise and offsets, and fitted. These fits also search for other
    optima, which the sensitivities do not show.

    References
    ----------
    Atkinson, Donev & Tobias, Optimum Experimental Designs, with SAS, Oxford 2007.
    """
    plan = plan if isinstance(plan, DesignPlan) else read_design_file(plan)
    points, prior = _points_and_information(plan)
    informations: list[FloatArray] = []
    try:
        for k, candidate in enumerate(plan.candidates):
            if progress is not None:
                progress(k, len(plan.candidates), candidate.name)
            informations.append(np.array([_fisher_information(candidate, plan.free, point) for point in points]))
    except KeyboardInterrupt:
        if not informations:
            raise
    names = [candidate.name for candidate in plan.candidates]
    scores = [_criterion(plan, prior + information) for information in informations]
    order = sorted(range(len(informations)), key=lambda k: scores[k])
    tests = {names[k]: _predict(plan, prior + informations[k]) for k in order}
    selection = _select_tests(plan, prior, informations)
    together = _predict(plan, prior + sum(informations[k] for k in selection))
    interrupted = len(informations) < len(plan.candidates)
    simulated: dict[str, SimulatedEstimate] = {}
    if not interrupted:
        try:
            simulated = simulate_fits(
                plan,
                [plan.candidates[k] for k in selection],
                lambda done, total: progress and progress(done, total, "simulated fits of the selected tests"),
            )
        except KeyboardInterrupt:
            interrupted = True
    remarks = []
    for f in plan.free:
        joint = together[f.name]
        if all(row[f.name].verdict == "not determined" for row in tests.values()):
            remarks.append(Note("design.by_none", f.name))
        elif joint.verdict != "determined":
            code = "design.still_weak" if joint.verdict == "weak" else "design.still_open"
            remarks.append(Note(code, f.name, percent=100.0 * joint.half / f.scale))
        if joint.largest > 2.0 * joint.standard_error:
            remarks.append(Note("design.depends", f.name, times=joint.largest / joint.standard_error))
        if (fitted := simulated.get(f.name)) is not None:
            is_wider = fitted.standard_error > WIDER * joint.standard_error
            is_worse = VERDICTS.index(fitted.verdict) > VERDICTS.index(joint.verdict)
            if joint.verdict != "not determined" and (is_wider or is_worse):
                times = fitted.standard_error / joint.standard_error
                facts = {"fits": fitted.fits, "determined": fitted.determined, "times": times}
                remarks.append(Note("design.fits_differ", f.name, **facts))
    return Design(
        plan.title,
        plan.criterion,
        tests,
        tuple(names[k] for k in selection),
        together,
        {names[k]: scores[k] for k in order},
        tuple(remarks),
        interrupted,
        simulated,
    )


def _points_and_information(plan: DesignPlan) -> tuple[list[FloatArray], FloatArray]:
    """Return sample points of the priors, and the Fisher information before any new test.

    The points are the start values of the free parameters and random samples of their priors. The information, (n_free,
    n_free), comes from the priors and from an earlier result.
    """
    points = [np.array([f.start for f in plan.free])]
    generator = np.random.default_rng(plan.seed)
    for _ in range(plan.draws if any(f.prior for f in plan.free) else 0):
        sample = []
        for f in plan.free:
            value = f.start if f.prior is None else generator.normal(f.prior.mean, f.prior.sd)
            margin = 1e-3 * min(f.scale, f.high - f.low)
            sample.append(min(max(value, f.low + margin), f.high - margin))
        points.append(np.array(sample))
    information = np.diag(1.0 / np.square([f.prior.sd if f.prior else f.scale for f in plan.free]))
    if plan.known is not None:
        estimates = {name: e.standard_error for name, e in plan.known.parameters.items()}
        indices = [k for k, f in enumerate(plan.free) if math.isfinite(estimates.get(f.name, math.inf))]
        names = [plan.free[k].name for k in indices]
        errors = np.array([estimates[name] for name in names])
        joint = np.array([[plan.known.correlation.get(a, {}).get(b, float(a == b)) for b in names] for a in names])
        information[np.ix_(indices, indices)] += np.linalg.pinv(joint * np.outer(errors, errors), hermitian=True)
    return points, information


def _fisher_information(candidate: TestCandidate, free: Sequence[FreeParameter], point: FloatArray) -> FloatArray:
    """Return the Fisher information of one test on the free parameters, (n_free, n_free).

    `point` contains the values of these parameters. The nuisance parameters of the test (initial values, lags, offsets)
    are eliminated.
    """
    measurement, values = empty_measurement("test", candidate), by_name(free, point)
    if candidate.start or any(math.isinf(sensor.offset) for sensor in candidate.sensors):
        measurement = with_values(measurement, noise_free_values(measurement, candidate, values, free))
    arguments = [measurement], [candidate.circuit], ["fit"]
    nuisances = recording_parameters(*arguments) + offset_parameters(*arguments)
    experiment = Experiment(candidate.circuit.instance, measurement, (*free, *nuisances))
    slopes = experiment.slopes({**by_name(nuisances, [f.start for f in nuisances]), **values})
    whitened = np.vstack([slope / sensor.noise for slope, sensor in zip(slopes, candidate.sensors, strict=True)])
    shared, nuisance = whitened[:, : len(free)], whitened[:, len(free) :]
    priors = np.array([f.prior.sd**-2 if f.prior else 0.0 for f in nuisances])
    information = shared.T @ shared
    if nuisance.shape[1]:
        # Nuisance parameters of different units can be correlated: scale them before the inversion.
        size = np.maximum(np.linalg.norm(nuisance, axis=0), 1e-300)
        unit = nuisance / size
        inner = unit.T @ unit + np.diag(priors / size**2)
        cross = unit.T @ shared
        information = information - cross.T @ np.linalg.pinv(inner, rcond=LOST, hermitian=True) @ cross
    return np.asarray(0.5 * (information + information.T))


def _standard_errors(plan: DesignPlan, information: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the relative standard errors, (n_points, n_free), and the log determinants of the covariance, (n_points,).

    The points are samples of the priors. `information` is the Fisher information of tests and priors at each point,
    (n_points, n_free, n_free).
    """
    scale = np.array([f.scale for f in plan.free])
    relative = information * np.outer(scale, scale)
    # Scale to a unit diagonal: the variances differ by many orders of magnitude.
    size = np.sqrt(np.diagonal(relative, axis1=1, axis2=2))
    eigenvalues, vectors = np.linalg.eigh(relative / (size[:, :, np.newaxis] * size[:, np.newaxis]))
    # With priors, all eigenvalues are positive except for rounding errors.
    eigenvalues = np.maximum(eigenvalues, ROUNDING)
    volumes = -(np.sum(np.log(eigenvalues), axis=1) + 2.0 * np.sum(np.log(size), axis=1))
    return np.sqrt(np.sum(vectors**2 / eigenvalues[:, np.newaxis], axis=2)) / size, volumes


def _criterion(plan: DesignPlan, information: FloatArray) -> float:
    """Return the logarithm of the criterion for the choice of tests.

    A lower value is better. The result is averaged over samples of the priors. `information` is the Fisher information
    at each sample, (n_points, n_free, n_free).
    """
    errors, volumes = _standard_errors(plan, information)
    if plan.criterion == "volume":
        return float(np.mean(0.5 * volumes))
    logarithms = np.log(errors)
    # The same means over the points as in the table, so that the criterion agrees with the table.
    typical = np.mean(logarithms, axis=0)
    return float(np.max(typical) if plan.criterion == "worst" else np.mean(typical))


def _select_tests(plan: DesignPlan, prior: FloatArray, informations: Sequence[FloatArray]) -> list[int]:
    """Return the indices of the recommended tests.

    Tests are first added one by one, always the best one. Single tests are then exchanged while this improves the
    criterion. `prior` and `informations` contain the Fisher information of the priors and of each test.
    """

    def score(tests: Sequence[int]) -> float:
        return _criterion(plan, prior + sum(informations[k] for k in tests))

    def add_best(tests: Sequence[int]) -> list[int]:
        return [*tests, min(range(len(informations)), key=lambda k: score([*tests, k]))]

    selection: list[int] = []
    for _ in range(plan.select):
        selection = add_best(selection)
    improved = plan.select > 1
    while improved:
        improved = False
        for position in range(len(selection)):
            exchanged = add_best(selection[:position] + selection[position + 1 :])
            if score(exchanged) < score(selection) - 1e-9:
                selection, improved = exchanged, True
    return selection


def _predict(plan: DesignPlan, information: FloatArray) -> dict[str, Prediction]:
    predictions = {}
    for f, errors in zip(plan.free, _standard_errors(plan, information)[0].T, strict=True):
        error, largest = f.scale * float(errors[0]), f.scale * float(np.max(errors))
        typical = f.scale * float(np.exp(np.mean(np.log(errors))))
        level = verdict(f, f.start, TWO_SIDED * error)
        predictions[f.name] = Prediction(f.start, f.unit, error, typical, largest, level, f.scale)
    return predictions
