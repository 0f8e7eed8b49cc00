"""Direct fit of the flow law to the points of a bench, with errors in all readings.

Independent errors of the points enter as effective variances: the flow law propagates the error of each reading to
the flow. Errors that all points share (calibration, offset) are parameters of the fit. Each has a known standard
deviation and one residual. The covariance of the estimates therefore includes these common errors.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError
from poppet.identify.flow.points import CHANNELS, Effect, FlowPoints
from poppet.identify.gum import (
    chi_square_probability,
    corrected_penalty,
    coverage_factor,
    effective_degrees_of_freedom,
    gain,
)
from poppet.identify.result import VERDICTS, Estimate, Verdict, verdict_on_interval
from poppet.laws.iso6358 import mass_flow_rate
from poppet.timeseries.checks import FloatArray

UNITS = {"sonic_conductance": "m^3/(s Pa)", "critical_ratio": "1", "subsonic_index": "1", "cracking_pressure": "Pa"}
"""Parameters of the flow law, with their SI units."""

LARGEST_RATIO = 0.995
"""Upper bound of b in the fit; all points below p2/p1 = 0.995 are then choked."""

NO_ZONE = 1.0 - 1e-7
"""Laminar ratio: the regularised zone of the law is narrower than the resolution of a pressure sensor."""

LEAST_READING = 0.02
"""Fraction of the maximum flow below which a relative uncertainty becomes absolute."""

DOUBT = 0.01
"""Probability below which the residuals are too large for the stated uncertainties."""

DOUBTED = 0.2
"""Probability that the scatter is larger than the one with which the intervals are calculated."""

LARGEST_FACTOR = 2.0
"""Largest factor on a stated scatter that only few degrees of freedom cause."""

BETTER = 6.0
"""Reduction of AICc by one more free parameter above which the simpler law is rejected."""


@dataclass(frozen=True, eq=False)
class FlowModel:
    """Flow law of ISO 6358, with free and fixed parameters and common errors of the instruments.

    A common error is an error that all points share. The argument `x` of the methods contains the scaled free
    parameters of the law, then the common errors in standard deviations. If `x` has the shape (k, p), the result has
    one row for each of the k sets.
    """

    points: FlowPoints
    fixed: Mapping[str, float]  # fixed parameters of the law

    @cached_property
    def free(self) -> tuple[str, ...]:
        """Names of the free parameters of the flow law, in the order of the constant `UNITS`."""
        return tuple(name for name in UNITS if name not in self.fixed)

    @cached_property
    def effects(self) -> tuple[Effect, ...]:
        """Errors that all points share, each with its change of the readings.

        Each change is the effect of an error of one standard deviation.
        """
        return tuple(self.points.effects())

    @cached_property
    def scales(self) -> FloatArray:
        """Unit of each element of `x`, the vector of scaled free parameters and common errors.

        It is a typical size of a free parameter, and 1 for a common error.
        """
        sizes = {
            "sonic_conductance": float(np.max(self.points.effective_conductance)),
            "cracking_pressure": float(np.mean(self.points.pressure_1)),
        }
        return np.array([sizes.get(name, 1.0) for name in self.free] + [1.0] * len(self.effects))

    @cached_property
    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Lower and upper bounds of the scaled free parameters and of the common errors.

        A common error is within 8 standard deviations.
        """
        drop = float(np.max(self.points.pressure_1 - self.points.pressure_2) / np.mean(self.points.pressure_1))
        limits = {
            "sonic_conductance": (1e-6, 1e3),
            "critical_ratio": (0.0, LARGEST_RATIO),
            "subsonic_index": (0.05, 3.0),
            "cracking_pressure": (0.0, 0.99 * max(drop, 1e-6)),
        }
        pairs = [limits[name] for name in self.free] + [(-8.0, 8.0)] * len(self.effects)
        return np.array([low for low, _ in pairs]), np.array([high for _, high in pairs])

    def numbers(self, x: FloatArray) -> dict[str, Any]:
        """Return all parameters of the law by name, in SI units.

        `x` contains the scaled free parameters.
        """
        values = _elements_or_columns((x * self.scales)[..., : len(self.free)])
        return dict(self.fixed) | dict(zip(self.free, values, strict=True))

    def common_errors(self, x: FloatArray) -> list[tuple[Any, Effect]]:
        """Return pairs of the size of each common error, in standard deviations, and its effect on the readings.

        `x` contains the scaled free parameters, then these sizes.
        """
        return list(zip(_elements_or_columns(x[..., len(self.free) :]), self.effects, strict=True))

    def readings(self, x: FloatArray) -> dict[str, FloatArray]:
        """Return the readings of pressures and temperature by channel, corrected for the common errors in `x`."""
        shifted = {name: getattr(self.points, name) for name in CHANNELS if name != "mass_flow_rate"}
        for size, effect in self.common_errors(x):
            for channel in shifted.keys() & effect.channels:
                reading = getattr(self.points, channel)
                shifted[channel] = shifted[channel] - size * effect.shift(reading)
        return shifted

    def flow(self, x: FloatArray, **shifts: FloatArray) -> FloatArray:
        """Return the flow that the flow meter should read according to the model [kg/s].

        `x` contains the scaled free parameters and common errors. Each keyword argument is a value that is added to the
        readings of the channel with this name.
        """
        readings = self.readings(x)
        for channel, shift in shifts.items():
            readings[channel] = readings[channel] + shift
        flow = mass_flow_rate(
            np.maximum(readings["pressure_1"], 0.0),
            np.maximum(readings["pressure_2"], 0.0),
            readings["temperature_1"],
            laminar_ratio=NO_ZONE,
            **self.numbers(x),
        )
        reading = flow
        for size, effect in self.common_errors(x):
            if "mass_flow_rate" in effect.channels:
                reading = reading + size * effect.shift(flow)
        return np.asarray(reading)

    def variances(self, x: FloatArray, extra: float = 0.0, inflation: float = 1.0) -> dict[str, FloatArray]:
        """Return the variance of the flow at each point that each instrument causes, by source [kg^2/s^2].

        `x` contains the scaled free parameters and common errors. `extra` is a variance that is added to each point,
        and `inflation` a factor on the stated standard deviations.
        """
        meter = self.points.u_mass_flow_rate
        largest = float(np.max(self.points.mass_flow_rate))
        reading = np.maximum(self.flow(x), LEAST_READING * largest)
        flow_variance = inflation**2 * (meter.absolute**2 + (meter.relative * reading) ** 2) + extra
        variances = {"mass_flow_rate": flow_variance}
        for channel in CHANNELS:
            instrument = self.points.instrument(channel)
            if channel == "mass_flow_rate" or not instrument.is_noisy:
                continue
            reading = getattr(self.points, channel)
            sigma = np.sqrt(instrument.absolute**2 + (instrument.relative * reading) ** 2)
            # Secant over two standard deviations: near p2/p1 = 1 the slope of the law is infinite.
            difference = self.flow(x, **{channel: sigma}) - self.flow(x, **{channel: -sigma})
            variances[channel] = inflation**2 * (0.5 * difference) ** 2
        return variances

    def residuals(self, x: FloatArray, sigma: FloatArray) -> FloatArray:
        """Return the weighted residuals for the scaled parameters `x`.

        The residual of a point is model minus measurement, divided by `sigma`. Residuals of the common errors follow.
        """
        misfit = (self.flow(x) - self.points.mass_flow_rate) / sigma
        return np.concatenate((misfit, x[..., len(self.free) :]), axis=-1)

    def jacobian(self, x: FloatArray, sigma: FloatArray) -> FloatArray:
        """Return the derivatives of the weighted residuals with respect to the scaled parameters `x`.

        The derivatives are central differences within the bounds of the parameters. `sigma` contains the weights, as in
        `residuals`.
        """
        step, (low, high) = 1e-6 * np.eye(x.size), self.bounds
        up, down = np.minimum(x + step, high), np.maximum(x - step, low)
        # All columns in one call: the law spends more time on checking arguments than on a dozen points.
        upper, lower = np.split(self.residuals(np.concatenate((up, down)), sigma), 2)
        return np.ascontiguousarray(((upper - lower) / np.diag(up - down)[:, None]).T)


def _elements_or_columns(x: FloatArray) -> list[Any]:
    """Return the elements of a vector, or the columns of a matrix.

    A matrix `x` contains several sets of parameters, one in each row.
    """
    return x.tolist() if x.ndim == 1 else list(x.T[:, :, None])


@dataclass(frozen=True, eq=False)
class FlowFit:
    """Least-squares fit of the flow law, with its statistics."""

    model: FlowModel
    x: FloatArray  # scaled free parameters at the optimum; common errors last
    sigma: FloatArray  # standard deviation of each residual of a point [kg/s]
    scatter: dict[str, FloatArray]  # variance of each residual by source; the sum is sigma squared [kg^2/s^2]
    scatter_is_known: bool  # False if the scatter was estimated from the residuals
    inflation: float  # factor on the stated independent uncertainties, from the residuals
    stated_chi_square: float  # chi-square with the stated uncertainties; NaN if they are not stated

    @cached_property
    def values(self) -> dict[str, float]:
        """All parameters of the flow law by name, both fitted and fixed."""
        return self.model.numbers(self.x)

    @cached_property
    def modelled(self) -> FloatArray:
        """Flow according to the model with the fitted common errors [kg/s]."""
        return self.model.flow(self.x)

    @cached_property
    def misfit(self) -> float:
        """Norm of the differences between modelled and measured flow [kg/s]."""
        return float(np.linalg.norm(self.modelled - self.model.points.mass_flow_rate))

    @cached_property
    def residuals(self) -> FloatArray:
        """Weighted residuals of the points, followed by the residuals of the common errors.

        The residual of a point is model minus measurement, divided by `sigma`.
        """
        return self.model.residuals(self.x, self.sigma)

    @cached_property
    def chi_square(self) -> float:
        """Sum of the squares of all weighted residuals (chi-square)."""
        return float(self.residuals @ self.residuals)

    @property
    def degrees_of_freedom(self) -> int:
        """Number of points minus number of free parameters.

        Common errors do not change this difference: each adds one residual and one parameter.
        """
        return len(self.model.points) - len(self.model.free)

    @property
    def stated_probability(self) -> float:
        """Probability of a larger chi-square, if the stated uncertainties are correct.

        It is NaN if no uncertainties are stated.
        """
        return chi_square_probability(self.stated_chi_square, self.degrees_of_freedom)

    @property
    def scatter_factor(self) -> float:
        """Factor on the standard errors by scatter, at least 1, because a stated scatter can be too small.

        The factor is the upper limit of the scatter that the residuals permit. Few residuals determine the scatter
        poorly, so the factor is limited to 2 unless Birge's ratio is larger.
        """
        from scipy.special import chdtri

        freedom = self.degrees_of_freedom
        if not self.scatter_is_known or freedom < 1:
            return 1.0
        birge = math.sqrt(self.chi_square / freedom)
        upper = math.sqrt(self.chi_square / float(chdtri(freedom, 1.0 - DOUBTED)))
        return max(1.0, birge, min(upper, LARGEST_FACTOR))

    @property
    def scatter_freedom(self) -> float:
        """Degrees of freedom with which the scatter is known."""
        return math.inf if self.scatter_is_known else float(max(self.degrees_of_freedom, 1))

    @cached_property
    def aicc(self) -> float:
        """Information criterion AICc of the fit.

        If the scatter is estimated, it counts as one parameter.
        """
        likelihood = self.chi_square + float(np.sum(np.log(2.0 * math.pi * self.sigma**2)))  # -2 ln of it
        return likelihood + corrected_penalty(
            len(self.model.free) + (not self.scatter_is_known), len(self.model.points)
        )

    @cached_property
    def jacobian(self) -> FloatArray:
        """Derivatives of the weighted residuals with respect to the scaled free parameters and common errors."""
        return self.model.jacobian(self.x, self.sigma)

    @cached_property
    def gain(self) -> tuple[FloatArray, NDArray[np.bool_]]:
        """Derivatives of estimates with respect to weighted residuals, and a mask of determined parameters."""
        return gain(self.jacobian)

    @cached_property
    def budgets(self) -> dict[str, dict[str, Any]]:
        """Uncertainty budget of each free parameter by name.

        Scatter is of type A, and common errors are of type B.
        """
        n, budgets = len(self.model.points), {}
        # An estimated scatter has the same size at all points, but that of many flow meters is proportional to the
        # flow. The standard error HC3 is also valid then.
        left = 1.0 - np.einsum("ij,ji->i", self.jacobian, self.gain[0])[:n]
        robust_residuals = self.residuals[:n] / np.maximum(left, 0.1)
        for name, row, scale in zip(self.model.free, self.gain[0], self.model.scales.tolist(), strict=False):
            parts = {f"scatter of {source}": part / self.sigma**2 for source, part in self.scatter.items()}
            size = scale * self.scatter_factor
            scatter = {source: size * math.sqrt(float(np.sum(row[:n] ** 2 * part))) for source, part in parts.items()}
            effects = zip(self.model.effects, row[n:].tolist(), strict=True)
            common = {effect.source: scale * abs(u) for effect, u in effects}
            type_a, type_b = math.hypot(*scatter.values()), math.hypot(*common.values())
            robust = scale * float(np.linalg.norm(row[:n] * robust_residuals))
            if not self.scatter_is_known and 0.0 < type_a < robust:
                scatter = {source: u * robust / type_a for source, u in scatter.items()}
                type_a = robust
            freedom = effective_degrees_of_freedom([(type_a, self.scatter_freedom), (type_b, math.inf)])
            budgets[name] = {
                "type_a": type_a,
                "type_b": type_b,
                "degrees_of_freedom": freedom,
                "coverage_factor": coverage_factor(freedom),
                "sources": scatter | common,
            }
        return budgets


def fit_flow(model: FlowModel) -> FlowFit:
    """Fit the flow law to the points of a flow bench by weighted least squares.

    The weights depend on the fitted law, so weights and parameters are updated in turn.

    Notes
    -----
    If the scatter of the flow meter is not stated, one variance for all points is estimated so that chi-square equals
    the degrees of freedom. If it is stated and the residuals are too large for it (probability below 0.01), one factor
    enlarges all independent uncertainties in the same way (Birge's ratio).
    """
    x = start_point(model)
    if not model.points.u_mass_flow_rate.is_noisy:
        misfit = model.flow(x) - model.points.mass_flow_rate
        return _iterate_weights(model, x, adapt="extra", extra=float(np.mean(misfit**2)))
    fit = _iterate_weights(model, x)
    fit = replace(fit, stated_chi_square=fit.chi_square)
    if not fit.stated_probability < DOUBT:  # NaN: there are no degrees of freedom
        return fit
    birge = math.sqrt(fit.chi_square / fit.degrees_of_freedom)
    wider = _iterate_weights(model, fit.x, adapt="inflation", inflation=birge)
    return replace(wider, stated_chi_square=fit.chi_square)


def _iterate_weights(
    model: FlowModel, x: FloatArray, *, adapt: str = "", extra: float = 0.0, inflation: float = 1.0
) -> FlowFit:
    """Return the fit after alternating updates of weights and parameters, starting from `x`.

    The keyword `adapt` is the name of the argument of `FlowModel.variances` that is adapted until chi-square equals its
    degrees of freedom. If `adapt` is empty, the variances are not adapted.
    """
    from scipy.optimize import least_squares

    # A variance smaller than that of any real flow meter, for exact data.
    smallest = (1e-6 * float(np.max(model.points.mass_flow_rate))) ** 2
    # Without it, points without residuals would have a sigma of zero.
    floor = 0.01 * smallest
    extra = max(extra, smallest) if adapt == "extra" else extra
    low, high = model.bounds
    for _ in range(30):
        sigma = np.sqrt(sum(model.variances(x, extra, inflation).values()) + floor)
        start = np.clip(x, low + 1e-9, high - 1e-9)  # the search must start within the bounds
        options = {"xtol": 1e-10, "ftol": 1e-10, "gtol": 1e-10}
        solution = least_squares(model.residuals, start, model.jacobian, (low, high), args=(sigma,), **options).x
        change, previous = float(np.max(np.abs(solution - x))), (extra, inflation)
        x, common = solution, solution[len(model.free) :]
        freedom = len(model.points) - len(model.free) - float(common @ common)
        if adapt and freedom > 0.0:
            misfit = (model.flow(x) - model.points.mass_flow_rate) ** 2
            stated = sum(model.variances(x).values())
            if adapt == "inflation":
                inflation = max(1.0, math.sqrt(float(np.sum(misfit / (stated + smallest))) / freedom))
            else:
                extra, lower = max(float(np.sum(misfit)) / freedom, smallest), smallest
                for _ in range(50):  # chi-square falls with the added variance
                    middle = math.sqrt(lower * extra)  # logarithmic: the ends differ by decades
                    is_low = np.sum(misfit / (stated + middle)) > freedom
                    lower, extra = (middle, extra) if is_low else (lower, middle)
        is_steady = math.isclose(extra, previous[0], rel_tol=1e-3, abs_tol=1e-3 * floor)
        if change < 1e-6 and is_steady and math.isclose(inflation, previous[1], rel_tol=1e-3):
            break
    variances = model.variances(x, extra, inflation)
    return FlowFit(model, x, np.sqrt(sum(variances.values()) + floor), variances, not adapt, inflation, math.nan)


def start_point(model: FlowModel) -> FloatArray:
    """Return start values of the search, the best point of a coarse grid.

    The flow is proportional to C. Each point of the grid therefore uses its best C.
    """
    points = model.points
    drops = np.sort(
        (points.pressure_1 - points.pressure_2)[points.mass_flow_rate > 0.02 * np.max(points.mass_flow_rate)]
    )
    nodes = {
        "critical_ratio": np.linspace(0.0, 0.9, 37),
        "subsonic_index": np.array([0.35, 0.5, 0.7, 1.0]),
        "cracking_pressure": max(float(drops[0]), 0.0) * np.array([0.0, 0.3, 0.6, 0.9]),
    }
    axes = [nodes[name] if name in model.free else np.array([model.fixed[name]]) for name in nodes]
    b, m, cracking = (axis.ravel()[:, None] for axis in np.meshgrid(*axes, indexing="ij"))
    unit = _unit_flow(points, critical_ratio=b, subsonic_index=m, cracking_pressure=cracking, laminar_ratio=NO_ZONE)
    per_flow = np.sum(unit * points.mass_flow_rate, axis=1)
    power = np.sum(unit * unit, axis=1)
    if not np.max(per_flow) > 0.0:
        drop = float(np.max(points.pressure_1 - points.pressure_2))
        value = model.fixed.get("cracking_pressure", 0.0)
        raise InputError("flow.closed_everywhere", "cracking_pressure", value=value, drop=drop)
    best = int(np.argmax(per_flow**2 / np.maximum(power, 1e-300)))
    start_values = {
        "sonic_conductance": per_flow[best] / power[best],
        "critical_ratio": b[best, 0],
        "subsonic_index": m[best, 0],
        "cracking_pressure": cracking[best, 0],
    }
    law = np.array([start_values[name] for name in model.free])
    return np.concatenate((law, np.zeros(len(model.effects)))) / model.scales


def _unit_flow(points: FlowPoints, **law: Any) -> FloatArray:
    """Return the flow at all points for a sonic conductance C of 1.

    The keyword arguments are the other parameters of the flow law. If they are columns, the result has one row for each
    set.
    """
    readings = (getattr(points, channel) for channel in CHANNELS if channel != "mass_flow_rate")
    return np.asarray(mass_flow_rate(*readings, sonic_conductance=1.0, **law))


def fit_all_choked(fit: FlowFit) -> FlowFit | None:
    """Return a fit under the assumption that the flow is choked at all points.

    The result is None if the data reject this assumption.
    """
    if np.max(fit.model.points.pressure_ratio) >= LARGEST_RATIO:
        return None
    fixed = dict(fit.model.fixed) | {"critical_ratio": LARGEST_RATIO, "subsonic_index": 0.5, "cracking_pressure": 0.0}
    choked = replace(fit_flow(FlowModel(fit.model.points, fixed)), stated_chi_square=fit.stated_chi_square)
    # The comparison requires the weights of the free fit.
    misfit = (choked.modelled - fit.model.points.mass_flow_rate) / fit.sigma
    common = choked.x[len(choked.model.free) :]
    allowed = coverage_factor(fit.scatter_freedom) ** 2
    return choked if float(misfit @ misfit + common @ common) - fit.chi_square <= allowed else None


def law_estimates(fit: FlowFit) -> dict[str, Estimate]:
    """Return the estimates of the free parameters of the flow law by name, with 95 % confidence intervals."""
    low, high = fit.model.bounds
    start_values = start_point(fit.model) * fit.model.scales
    estimates = {}
    for k, name in enumerate(fit.model.free):
        scale = float(fit.model.scales[k])
        bounds = float(low[k]) * scale, float(high[k]) * scale
        at_bound = min(fit.x[k] - low[k], high[k] - fit.x[k]) < 1e-4
        value = min(bounds, key=lambda end: abs(end - fit.x[k] * scale)) if at_bound else float(fit.x[k]) * scale
        budget = fit.budgets[name]
        error = math.hypot(*budget["sources"].values()) if fit.gain[1][k] else math.inf
        half = budget["coverage_factor"] * error
        estimates[name] = Estimate(
            value,
            UNITS[name],
            error,
            max(value - half, bounds[0]),
            min(value + half, bounds[1] if name != "critical_ratio" else 1.0),
            _law_verdict(name, value, half, at_bound, scale),
            float(start_values[k]),
        )
    return estimates


def _law_verdict(name: str, value: float, half: float, at_bound: bool, scale: float) -> Verdict:
    """Return the verdict on an estimate of the flow law, such as `determined`.

    `half` is half the width of the interval. It is compared with C itself, with 1 for b and m, and with at least a
    tenth of `scale`, the upstream pressure, for the cracking pressure.
    """
    if at_bound:
        return "at bound"
    size = {"sonic_conductance": value, "cracking_pressure": max(value, 0.1 * scale)}.get(name, 1.0)
    return verdict_on_interval(half, size)


def choked_estimates(fit: FlowFit, choked: FlowFit) -> dict[str, Estimate]:
    """Return the estimates of a flow law if all points may be choked.

    `choked` is the fit under this assumption. The estimate of C is then a range, and the estimate of b is only a lower
    limit.
    """
    points = choked.model.points
    ratios = np.linspace(0.0, 0.99, 199)
    unit = _unit_flow(points, critical_ratio=ratios[:, None], subsonic_index=fit.values["subsonic_index"])
    # The flow is linear in C: the best C for each b needs no search.
    weighted, measured = unit / fit.sigma, points.mass_flow_rate / fit.sigma
    conductance = weighted @ measured / np.sum(weighted**2, axis=1)
    misfit = np.sum((conductance[:, None] * weighted - measured) ** 2, axis=1)
    possible = misfit - np.min(misfit) <= coverage_factor(fit.scatter_freedom) ** 2
    narrow = law_estimates(choked)["sonic_conductance"]
    half = narrow.high - narrow.value
    low = min(float(np.min(conductance[possible])), narrow.value) - half
    high = max(float(np.max(conductance[possible])), narrow.value) + half
    widest = max(high - narrow.value, narrow.value - low)
    verdict = _law_verdict("sonic_conductance", narrow.value, widest, False, 1.0)
    estimates = {"sonic_conductance": replace(narrow, low=low, high=high, verdict=verdict)}
    lowest = {"critical_ratio": float(np.min(ratios[possible]))}
    highest = {"critical_ratio": 1.0, "subsonic_index": 3.0, "cracking_pressure": float(np.max(points.pressure_1))}
    for name in fit.model.free[1:]:
        estimates[name] = Estimate(
            math.nan, UNITS[name], math.inf, lowest.get(name, 0.0), highest[name], "not determined"
        )
    return estimates


def find_other_law(fit: FlowFit) -> tuple[str, FlowFit] | None:
    """Return the name of a fixed parameter that should be free, and the fit in which it is free.

    The result is None if no fixed parameter improves the fit clearly when it is free.
    """
    alternatives = []
    for name in ("subsonic_index", "cracking_pressure"):
        fixed = {key: value for key, value in fit.model.fixed.items() if key != name}
        richer = FlowModel(fit.model.points, fixed)
        if name not in fit.model.fixed or len(richer.points) <= len(richer.free):
            continue
        # Decrease of -2 ln L if the parameter becomes free, predicted from the derivatives at the optimum.
        index = richer.free.index(name)
        x = np.insert(fit.x, index, fit.model.fixed[name] / richer.scales[index])
        jacobian = richer.jacobian(x, fit.sigma)
        basis = np.linalg.qr(np.delete(jacobian, index, axis=1))[0]
        column = jacobian[:, index] - basis @ (basis.T @ jacobian[:, index])
        fraction = float(column @ fit.residuals) ** 2 / max(float(column @ column) * fit.chi_square, 1e-300)
        if -len(fit.model.points) * math.log1p(-min(fraction, 1.0 - 1e-12)) > BETTER:
            alternatives.append((name, fit_flow(richer)))
    best = min(alternatives, key=lambda pair: pair[1].aicc, default=None)
    return best if best and fit.aicc - best[1].aicc > BETTER else None


def widen_estimates(estimates: Mapping[str, Estimate], other_estimates: Mapping[str, Estimate]) -> dict[str, Estimate]:
    """Return estimates whose intervals also cover the fit of another law.

    `other_estimates` are the estimates of the other law.
    """
    widened = {}
    for name, e in estimates.items():
        low, high = min(e.low, other_estimates[name].low), max(e.high, other_estimates[name].high)
        verdict = _law_verdict(name, e.value, max(high - e.value, e.value - low), e.verdict == "at bound", 1.0)
        widened[name] = replace(e, low=low, high=high, verdict=max(verdict, e.verdict, key=VERDICTS.index))
    return widened
