"""Uncertainty budget of a tank test: volume, supply pressure, a small leak, and scale and zero of the gauge."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, UnitError
from poppet.core.tables import Field, read_fields
from poppet.core.units import Kind
from poppet.identify.fit.experiment import Experiment, FittedChannel, channels_of
from poppet.identify.fit.fit_findings import parameter_notes, widening_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.search import FitObjective, Optimum
from poppet.identify.fit.statistics import influences, verdict
from poppet.identify.free_parameter import by_name
from poppet.identify.gum import coverage_factor
from poppet.identify.result import VERDICTS, Result
from poppet.identify.tank.tank_plan import (
    COMMON_RATIO,
    LEAK_ADDRESS,
    NEARLY_TIGHT,
    PRESSURE,
    SUPPLY,
    TankRun,
    has_leak,
    is_free,
    plan_tank_fit,
)
from poppet.identify.tank.test import TankTest
from poppet.timeseries.checks import FloatArray

VOLUME, LEAK_RATIO = "tank.volume", "leak.critical_ratio"
FIELDS = dict.fromkeys(("volume", "supply_pressure", "leak", "gauge_scale", "gauge_zero"), Field())
"""Keys of the table `uncertainties` of a tank test."""
DEFAULTS = {"volume": 0.005, "supply_pressure": 0.003, "leak": 0.015, "gauge_scale": 0.003}
r"""Relative standard uncertainties that are assumed if a tank test does not state them.

| quantity | default | source |
|---|---|---|
| volume | 0.5 % | assumed: filling with water on a scale, lines and fittings included |
| supply pressure (absolute) | 0.3 % | assumed: limits of ±0.5 %, rectangular distribution (GUM 4.3.7) |
| leak (fraction of C) | 1.5 % | assumed: small leaks of fittings, 95 % of them below 3 % of C |
| gauge scale (gauge pressure) | 0.3 % | assumed: limits of ±0.5 %, rectangular distribution (GUM 4.3.7) |
"""
DEFAULT_ZERO = 0.0006
"""Default standard uncertainty of the gauge zero, as a fraction of the range of the recording.

The value is assumed: limits of ±0.1 %, rectangular distribution (GUM 4.3.7)."""
RATIO = 0.17
"""Assumed standard uncertainty of the critical ratio of a leak: 0 to 0.6, rectangular distribution."""
LARGEST = 0.5
"""Largest relative standard uncertainty that the linear propagation accepts."""
LARGEST_STEP = 0.005
"""Largest relative change of a parameter for its central difference."""
PARAMETER_NOTES = "finding.number."
"""Prefix of the codes of notes on single parameters."""
EXACT = "time", "temperatures", "ambient pressure"
"""Stated quantities without an uncertainty."""
NOISE, AMBIENT = "noise and lack of fit", "ambient temperature"
SOURCES = {
    "volume": "volume",
    "supply_pressure": "supply pressure",
    "leak": "leak",
    "leak_ratio": "leak",
    "gauge_scale": "gauge scale",
    "gauge_zero": "gauge zero",
}
"""Names of the sources in the budget."""


@dataclass(frozen=True)
class Uncertainties:
    """Standard uncertainties of quantities that a tank test states, such as the volume.

    The uncertainty of an exact quantity is 0.
    """

    volume: float  # relative
    supply_pressure: float  # relative, of the absolute pressure
    leak: float  # sonic conductance of the leak, as a fraction of C
    gauge_scale: float  # relative, of the gauge pressure
    gauge_zero: float  # [Pa]
    assumed: tuple[str, ...]  # quantities with a default


def read_uncertainties(test: TankTest, plan: FitPlan) -> Uncertainties:
    """Return the standard uncertainties of the quantities that a tank test states, such as the volume.

    If an uncertainty is not stated, it has a default. Those of volume and supply pressure can be fractions or absolute
    values.
    """
    if isinstance(test.uncertainties, int | float) and test.uncertainties == 0:
        return Uncertainties(0.0, 0.0, 0.0, 0.0, 0.0, ())
    parameters = [e.instance.parameters for e in plan.experiments]
    references = {
        "volume": ("m^3", min(values[VOLUME] for values in parameters)),
        "supply_pressure": ("Pa", min((values[SUPPLY] for values in parameters if SUPPLY in values), default=1.0)),
        "leak": ("1", 1.0),
        "gauge_scale": ("1", 1.0),
    }
    # A stated leak was measured.
    defaults = DEFAULTS | ({"leak": 0.0} if has_leak(test) else {})
    sizes: dict[str, float] = {}
    with ErrorCollector() as errors:
        stated = read_fields(errors, test.uncertainties or {}, FIELDS, "uncertainties", table="table of uncertainties")
        for name, (unit, reference) in references.items():
            with errors.collecting():
                sizes[name] = (
                    _relative_uncertainty(stated[name], name, unit, reference) if name in stated else defaults[name]
                )
        with errors.collecting():
            ranges = [float(np.ptp(c.channel.values)) for c in _gauges(plan)]
            zero = Field(unit="Pa", kind="pressure_difference", low=0.0, meaning="standard uncertainty")
            is_stated = "gauge_zero" in stated
            sizes["gauge_zero"] = (
                zero.read(stated["gauge_zero"], "uncertainties.gauge_zero") if is_stated else DEFAULT_ZERO * max(ranges)
            )
    return Uncertainties(**sizes, assumed=tuple(name for name in FIELDS if name not in stated))


def _relative_uncertainty(argument: Any, name: str, unit: str, reference: float) -> float:
    """Return a standard uncertainty as a fraction of the value `reference`.

    `argument` is the fraction, or an absolute uncertainty in units such as `unit`. `name` is the name of the quantity
    for messages.
    """
    location, meaning = f"uncertainties.{name}", "standard uncertainty"
    fraction = Field(unit="1", low=0.0, high=LARGEST, meaning=meaning)
    try:
        return float(fraction.read(argument, location))
    except UnitError:
        if unit == "1":
            raise
    kind: Kind = "pressure_difference" if unit == "Pa" else "plain"
    absolute = Field(unit=unit, kind=kind, low=0.0, high=LARGEST * reference, meaning=meaning)
    return float(absolute.read(argument, location)) / reference


def add_budget(
    test: TankTest,
    uncertainties: Uncertainties,
    runs: Sequence[TankRun],
    plan: FitPlan,
    result: Result,
    ambient: Result,
) -> Result:
    """Add the uncertainties of stated quantities to the standard errors and intervals of a tank test.

    `result` has the intervals of the fit. `ambient` has intervals that also include the uncertainty of the ambient
    temperature. The Jacobian of the fit propagates the errors linearly.
    """
    number = f"{test.part}.sonic_conductance"
    changes = _residual_changes(test, runs, plan, result, uncertainties)
    stated = _stated_quantities(test, runs)
    exact = tuple(SOURCES[name] for name in FIELDS if name in stated and not getattr(uncertainties, name)) + EXACT
    if not changes:
        return replace(ambient, remarks=(*ambient.remarks, Note("finding.exact", number, exact=exact)))
    errors = np.column_stack([*changes.values()])
    rows, moments = _local_model(plan, result, errors)
    budget: dict[str, dict[str, Any]] = {}
    parameters = dict(ambient.parameters)
    for f, row in zip(plan.free, rows, strict=True):
        estimate, fitted = parameters[f.name], result.parameters[f.name]
        is_finite = math.isfinite(fitted.standard_error) and bool(np.all(np.isfinite(row)))
        # The offset is the correction of the readings, whatever its cause.
        if not is_finite or fitted.verdict == "at bound" or f.role == "offset":
            continue
        # Errors that are correlated given the data: a negative contribution reduces the others.
        sensitivities = row @ errors
        products = sensitivities * (moments @ sensitivities)
        variances = np.maximum(products, 0.0)
        total = float(np.sum(variances))
        sizes = np.sqrt(variances * (max(0.0, float(np.sum(products))) / total)) if total > 0.0 else variances
        shares = dict.fromkeys((SOURCES[name] for name in changes), 0.0)
        for name, size in zip(changes, sizes, strict=True):
            shares[SOURCES[name]] = math.hypot(shares[SOURCES[name]], size)
        sources = {NOISE: fitted.standard_error}
        if estimate.standard_error > fitted.standard_error:
            sources[AMBIENT] = math.sqrt(estimate.standard_error**2 - fitted.standard_error**2)
        budget[f.name] = {"sources": sources | shares}
        value, error = estimate.value, math.hypot(*shares.values())
        half = coverage_factor(math.inf) * error
        low = max(f.low, value - math.hypot(value - estimate.low, half))
        high = min(f.high, value + math.hypot(estimate.high - value, half))
        joint = max(verdict(f, value, max(high - value, value - low)), estimate.verdict, key=VERDICTS.index)
        total_error = math.hypot(estimate.standard_error, error)
        parameters[f.name] = replace(estimate, standard_error=total_error, low=low, high=high, verdict=joint)
    comparison = {**ambient.comparison, "uncertainty": budget}
    result = replace(ambient, parameters=parameters, comparison=comparison)
    if number not in budget:
        return result
    sources = budget[number]["sources"]
    variance = sum(size**2 for size in sources.values())
    fractions = {SOURCES[name]: getattr(uncertainties, name) for name in DEFAULTS if name in changes and name != "leak"}
    facts = {
        "sizes": fractions,
        "leak": uncertainties.leak if "leak" in changes else None,
        "zero": uncertainties.gauge_zero if "gauge_zero" in changes else None,
        "others": bool(fractions) or "leak" in changes,
        "assumed": tuple(SOURCES[name] for name in uncertainties.assumed if name in changes),
        "shares": {name: size**2 / variance for name, size in sources.items()},
        "exact": exact,
    }
    return replace(result, remarks=(*result.remarks, Note("finding.budget", number, **facts)))


def _stated_quantities(test: TankTest, runs: Sequence[TankRun]) -> set[str]:
    """Return the names of the quantities with an uncertainty that the fit treats as known, such as the volume."""
    fitted_runs = [run for run in runs if run.use == "fit"]
    is_stated = {
        "volume": not any(is_free(run.volume) for run in fitted_runs),
        "supply_pressure": any(run.direction == "charge" for run in fitted_runs)
        and not any(is_free(run.supply_pressure) for run in fitted_runs),
        "leak": not is_free(test.leak_conductance),
    }
    return {name for name in FIELDS if is_stated.get(name, True)}


def update_parameter_notes(plan: FitPlan, result: Result) -> Result:
    """Return a result whose notes on single parameters agree with its final intervals and verdicts.

    Parameters with a verdict that was limited to `weak` have a separate finding.
    """
    capped = result.conditions.get("capped", {})
    free = [f for f in plan.free if f.name not in capped]
    remarks = [note for note in result.remarks if not note.code.startswith(PARAMETER_NOTES)]
    index = next((k for k, note in enumerate(result.remarks) if note.code.startswith(PARAMETER_NOTES)), len(remarks))
    remarks[index:index] = parameter_notes(free, result.parameters)
    return replace(result, remarks=tuple(remarks))


def _gauges(plan: FitPlan) -> list[FittedChannel]:
    return [fitted for fitted in channels_of(plan.experiments) if fitted.channel.address == PRESSURE]


def _sigmas(plan: FitPlan, result: Result) -> list[float]:
    return [float(result.conditions["noise"][fitted.name]) for fitted in channels_of(plan.experiments)]


def _local_model(plan: FitPlan, result: Result, errors: FloatArray) -> tuple[FloatArray, FloatArray]:
    r"""Return the derivatives of the estimates by the residuals, and the second moments of the errors given the data.

    `errors` contains the changes of the residuals by the errors e of stated quantities, (n_rows, n_errors). Each error
    has the size of its standard uncertainty. A large error would be visible in the residuals r. Its moments are
    therefore computed from the posterior distribution with a standard normal prior:

    .. math:: \Sigma = (1 + C^T C / w)^{-1}, \quad m = -\Sigma C^T r / w, \quad E[e e^T] = \Sigma + m m^T

    C is `errors` without the fraction that the free parameters can compensate, and w is the variance factor. Each
    element of m is limited to -1 to 1: a larger mean indicates a lack of fit instead of an error.
    """
    x = np.array([result.parameters[f.name].value for f in plan.free])
    sigmas = _sigmas(plan, result)
    residual, jacobian = FitObjective(plan.experiments, plan.free, sigmas).residual_and_jacobian(x)
    active = np.array([int(result.parameters[f.name].verdict == "at bound") for f in plan.free], dtype=np.int64)
    rows = influences(Optimum(x, 0.0, jacobian, residual, sigmas, active))
    norms = np.linalg.norm(jacobian, axis=0)
    is_used = (active == 0) & (norms > 0.0)
    basis = np.linalg.qr(jacobian[:, is_used] / norms[is_used])[0]
    visible = errors - basis @ (basis.T @ errors)
    pieces = [residual[fitted.rows] for fitted in channels_of(plan.experiments)]
    factor = float(np.average([*map(widening_of, pieces)], weights=[piece.size for piece in pieces]))
    covariance = np.linalg.inv(np.eye(errors.shape[1]) + visible.T @ visible / factor)
    mean = np.clip(-covariance @ (visible.T @ residual) / factor, -1.0, 1.0)
    return rows, covariance + np.outer(mean, mean)


def _residual_changes(
    test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result, uncertainties: Uncertainties
) -> dict[str, FloatArray]:
    """Return the change of all residuals with each stated quantity, by name of the quantity.

    A quantity changes by one standard uncertainty. Quantities that are exact, free or without effect are omitted.
    """
    stated = _stated_quantities(test, runs)
    channels = channels_of(plan.experiments)
    sigmas = np.repeat(_sigmas(plan, result), [c.channel.values.size for c in channels])
    n_priors = sum(f.prior is not None for f in plan.free)
    values = by_name(plan.free, [result.parameters[f.name].value for f in plan.free])
    changes: dict[str, FloatArray] = {}

    def outputs(experiments: Sequence[Experiment]) -> FloatArray:
        return np.concatenate([series for e in experiments for series in e.outputs(values)])

    for name in ("volume", "supply_pressure"):
        size = getattr(uncertainties, name)
        if size > 0.0 and name in stated:
            step = min(size, LARGEST_STEP)
            above, below = (
                outputs([_scaled_experiment(e, plan, name, times) for e in plan.experiments])
                for times in (1.0 + step, 1.0 - step)
            )
            changes[name] = (above - below) * (0.5 * size / step) / sigmas
    # Not the readings: their noise would correlate with the residuals.
    model = outputs(plan.experiments)
    for name, size in (("gauge_scale", uncertainties.gauge_scale), ("gauge_zero", uncertainties.gauge_zero)):
        if size > 0.0:
            readings = np.zeros(sigmas.size)
            experiments = [e for e in plan.experiments for _ in e.measurement.channels]
            for fitted, e in zip(channels, experiments, strict=True):
                if fitted.channel.address == PRESSURE:
                    gauge = model[fitted.rows] - float(e.measurement.ambient_pressure)
                    readings[fitted.rows] = size * (gauge if name == "gauge_scale" else 1.0)
            changes[name] = -readings / sigmas
    changes = {name: np.append(change, np.zeros(n_priors)) for name, change in changes.items()}
    if uncertainties.leak > 0.0 and "leak" in stated:
        leaky = plan_tank_fit(replace(test, leak_conductance="free"), runs)
        parameters, number = plan.experiments[0].instance.parameters, f"{test.part}.sonic_conductance"
        conductance = values.get(number, parameters[number])
        size = uncertainties.leak * conductance
        leak = max(parameters.get(LEAK_ADDRESS, 0.0), NEARLY_TIGHT * conductance)
        x = np.array([values.get(f.name, leak) for f in leaky.free])
        index = [f.address for f in leaky.free].index(LEAK_ADDRESS)
        for name, ratio in (("leak", COMMON_RATIO), ("leak_ratio", COMMON_RATIO + RATIO)):
            experiments = [
                Experiment(e.instance.with_values({LEAK_RATIO: ratio}), e.measurement, leaky.free)
                for e in leaky.experiments
            ]
            objective = FitObjective(experiments, leaky.free, _sigmas(plan, result))
            changes[name] = size * objective.residual_and_jacobian(x)[1][:, index]
        changes["leak_ratio"] = changes["leak_ratio"] - changes["leak"]
    return changes


def _scaled_experiment(experiment: Experiment, plan: FitPlan, name: str, factor: float) -> Experiment:
    """Return a recording with its model in which the tank volume or the supply pressure is multiplied by `factor`.

    `name` is `volume` or `supply_pressure`. A recorded supply pressure is scaled as well.
    """
    address = VOLUME if name == "volume" else SUPPLY
    parameters, measurement = experiment.instance.parameters, experiment.measurement
    instance = experiment.instance
    if address in parameters:
        instance = instance.with_values({address: factor * parameters[address]})
    inputs = tuple(
        replace(item, values=factor * item.values) if item.address == address else item for item in measurement.inputs
    )
    return Experiment(instance, replace(measurement, inputs=inputs), plan.free)
