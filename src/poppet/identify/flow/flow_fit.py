"""Direct fit of the flow law to the points of a bench, with errors in every reading, and its estimates.

Errors from point to point enter as effective variances: each reading's error is carried through the law to the
flow. Errors common to all points (calibration, zero offset) are numbers of the fit with a known spread, one
residual each, so that every estimate's covariance contains them with all their correlations.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from poppet.core.errors import InputError
from poppet.identify.flow.points import CHANNELS, Effect, FlowPoints
from poppet.identify.gum import (
    chi_square_probability,
    corrected_penalty,
    coverage_factor,
    effective_degrees_of_freedom,
    gain,
)
from poppet.identify.result import VERDICTS, Estimate, Verdict, judged
from poppet.laws.iso6358 import mass_flow_rate
from poppet.timeseries.checks import FloatArray

UNITS = {"sonic_conductance": "m^3/(s Pa)", "critical_ratio": "1", "subsonic_index": "1", "cracking_pressure": "Pa"}
"""Numbers of the law with SI units."""

LARGEST_RATIO = 0.995
"""Upper bound of b in the fit: with it every point below p2/p1 = 0.995 is choked."""

NO_ZONE = 1.0 - 1e-7
"""A bench knows no regularised zone; this one is narrower than any transducer can see."""

LEAST_READING = 0.02
"""Of the largest flow: a relative uncertainty is not followed below it, where no flow meter has one any more."""

DOUBT = 0.01
"""Probability below which residuals count as too large for the stated uncertainties."""

BETTER = 6.0
"""By so much lower an AICc of a law with one number more free says that the simpler one does not hold."""


@dataclass(frozen=True, eq=False)
class FlowModel:
    """The law with what is free, what is fixed and the common errors.

    The search moves a vector x: the free numbers of the law, then the common errors in standard deviations. Several
    vectors at once, (k, p), give several rows.
    """

    points: FlowPoints
    fixed: Mapping[str, float]  # every number of the law that is not free

    @cached_property
    def free(self) -> tuple[str, ...]:
        """Free numbers of the law, in the order of `UNITS`."""
        return tuple(name for name in UNITS if name not in self.fixed)

    @cached_property
    def effects(self) -> tuple[Effect, ...]:
        """Common errors."""
        return tuple(self.points.effects())

    @cached_property
    def scales(self) -> FloatArray:
        """Size of each number of the fit, common errors included; the search works in numbers of order one."""
        sizes = {
            "sonic_conductance": float(np.max(self.points.effective_conductance)),
            "cracking_pressure": float(np.mean(self.points.pressure_1)),
        }
        return np.array([sizes.get(name, 1.0) for name in self.free] + [1.0] * len(self.effects))

    @cached_property
    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Physical bounds in numbers of order one; common errors within 8 standard deviations."""
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
        """Numbers of the law in SI units."""
        values = _columns((x * self.scales)[..., : len(self.free)])
        return dict(self.fixed) | dict(zip(self.free, values, strict=True))

    def common_errors(self, x: FloatArray) -> list[tuple[Any, Effect]]:
        """Size of every common error, in its standard deviations."""
        return list(zip(_columns(x[..., len(self.free) :]), self.effects, strict=True))

    def readings(self, x: FloatArray) -> dict[str, FloatArray]:
        """Pressures and temperatures without the common errors."""
        shifted = {name: getattr(self.points, name) for name in CHANNELS if name != "mass_flow_rate"}
        for size, effect in self.common_errors(x):
            for channel in shifted.keys() & effect.channels:
                reading = getattr(self.points, channel)
                shifted[channel] = shifted[channel] - size * (effect.offset + effect.calibration * reading)
        return shifted

    def flow(self, x: FloatArray, **moved: FloatArray) -> FloatArray:
        """What the flow meter should read; `moved` adds to single readings."""
        readings = self.readings(x)
        for channel, shift in moved.items():
            readings[channel] = readings[channel] + shift
        true = mass_flow_rate(
            np.maximum(readings["pressure_1"], 0.0),
            np.maximum(readings["pressure_2"], 0.0),
            readings["temperature_1"],
            laminar_ratio=NO_ZONE,
            **self.numbers(x),
        )
        shown = true
        for size, effect in self.common_errors(x):
            if "mass_flow_rate" in effect.channels:
                shown = shown + size * (effect.offset + effect.calibration * true)
        return np.asarray(shown)

    def variances(self, x: FloatArray) -> dict[str, FloatArray]:
        """Variance of measured less modelled flow from point to point, by instrument [kg^2/s^2]."""
        meter = self.points.u_mass_flow_rate
        largest = float(np.max(self.points.mass_flow_rate))
        reading = np.maximum(self.flow(x), LEAST_READING * largest)
        found = {"mass_flow_rate": meter.absolute**2 + (meter.relative * reading) ** 2}
        for channel in CHANNELS:
            known = self.points.instrument(channel)
            if channel == "mass_flow_rate" or not known.is_noisy:
                continue
            reading = getattr(self.points, channel)
            spread = np.sqrt(known.absolute**2 + (known.relative * reading) ** 2)
            # a secant over two standard deviations: near p2/p1 = 1 the law has no finite slope
            moved = self.flow(x, **{channel: spread}) - self.flow(x, **{channel: -spread})
            found[channel] = (0.5 * moved) ** 2
        return found

    def residuals(self, x: FloatArray, sigma: FloatArray) -> FloatArray:
        """Standardised, model - measured; common errors last."""
        misfit = (self.flow(x) - self.points.mass_flow_rate) / sigma
        return np.concatenate((misfit, x[..., len(self.free) :]), axis=-1)

    def jacobian(self, x: FloatArray, sigma: FloatArray) -> FloatArray:
        """Derivative of the residuals by x: central differences that stay within the bounds."""
        step, (low, high) = 1e-6 * np.eye(x.size), self.bounds
        up, down = np.minimum(x + step, high), np.maximum(x - step, low)
        # All columns at once: checking its arguments costs the law more than some dozen points do.
        above, below = np.split(self.residuals(np.concatenate((up, down)), sigma), 2)
        return np.ascontiguousarray(((above - below) / np.diag(up - down)[:, None]).T)


def _columns(x: FloatArray) -> list[Any]:
    """The numbers of one vector; of several, columns that broadcast over the points."""
    return x.tolist() if x.ndim == 1 else list(x.T[:, :, None])


@dataclass(frozen=True, eq=False)
class FlowFit:
    """Least squares and what belongs to it."""

    model: FlowModel
    x: FloatArray  # best numbers of order one, common errors last
    sigma: FloatArray  # of each residual of a point [kg/s]
    scatter: dict[str, FloatArray]  # variance of each residual by source, of sum sigma squared [kg^2/s^2]
    scatter_is_known: bool  # no part of it was estimated from the residuals
    inflation: float  # factor on the stated uncertainties from point to point that the residuals asked for
    stated: float  # probability of such residuals with the uncertainties as stated; not-a-number without

    @cached_property
    def values(self) -> dict[str, float]:
        """Numbers of the law, fixed ones included."""
        return self.model.numbers(self.x)

    @cached_property
    def modelled(self) -> FloatArray:
        """Flow of the model, with the common errors that the fit found [kg/s]."""
        return self.model.flow(self.x)

    @cached_property
    def residuals(self) -> FloatArray:
        """Standardised, model - measured; common errors last."""
        return self.model.residuals(self.x, self.sigma)

    @cached_property
    def chi_square(self) -> float:
        """Sum of squares of all residuals."""
        return float(self.residuals @ self.residuals)

    @property
    def degrees_of_freedom(self) -> int:
        """Points less free numbers of the law; a common error brings one residual and one number."""
        return len(self.model.points) - len(self.model.free)

    @property
    def scatter_freedom(self) -> float:
        """Degrees of freedom behind sigma."""
        return math.inf if self.scatter_is_known else float(max(self.degrees_of_freedom, 1))

    @cached_property
    def aicc(self) -> float:
        """Corrected information criterion; an estimated scatter is one number more."""
        likelihood = self.chi_square + float(np.sum(np.log(2.0 * math.pi * self.sigma**2)))  # -2 ln of it
        return likelihood + corrected_penalty(
            len(self.model.free) + (not self.scatter_is_known), len(self.model.points)
        )

    @cached_property
    def jacobian(self) -> FloatArray:
        """Derivative of the residuals by the numbers of order one."""
        return self.model.jacobian(self.x, self.sigma)

    @cached_property
    def gain(self) -> tuple[FloatArray, Any]:
        """See `poppet.identify.gum.gain`."""
        return gain(self.jacobian)


def fit_flow(model: FlowModel) -> FlowFit:
    """Fit the law, renewing the weights until they agree with the fit.

    Notes
    -----
    Where the flow meter's scatter is not stated, one size for all points is estimated such that chi-square
    equals its degrees of freedom. Where it is stated and the residuals are too large for it (probability below
    0.01), all parts from point to point are enlarged by one factor in the same way (Birge's ratio).
    """
    x = start(model)
    if not model.points.u_mass_flow_rate.is_noisy:
        misfit = model.flow(x) - model.points.mass_flow_rate
        return _settled(model, x, _Weights(max(float(np.mean(misfit**2)), _smallest(model)), 1.0), adapt="extra")
    fit = _settled(model, x, _Weights(0.0, 1.0), adapt="")
    stated = chi_square_probability(fit.chi_square, fit.degrees_of_freedom)
    if not stated < DOUBT:  # not-a-number: no degrees of freedom to judge by
        return replace(fit, stated=stated)
    birge = math.sqrt(fit.chi_square / fit.degrees_of_freedom)
    return replace(_settled(model, fit.x, _Weights(0.0, birge), adapt="inflation"), stated=stated)


@dataclass(frozen=True)
class _Weights:
    extra: float  # variance added to every point [kg^2/s^2]
    inflation: float  # factor on the stated standard deviations

    def parts(self, model: FlowModel, x: FloatArray) -> dict[str, FloatArray]:
        found = {name: self.inflation**2 * v for name, v in model.variances(x).items()}
        if self.extra:
            found["mass_flow_rate"] = found["mass_flow_rate"] + self.extra
        return found


def _smallest(model: FlowModel) -> float:
    """Variance below that of any flow meter, for exact data [kg^2/s^2]."""
    return (1e-6 * float(np.max(model.points.mass_flow_rate))) ** 2


def _settled(model: FlowModel, x: FloatArray, weights: _Weights, adapt: str) -> FlowFit:
    """Alternate between weights and least squares until both stay."""
    # Without it points that fit exactly would have no sigma at all.
    floor = (1e-7 * float(np.max(model.points.mass_flow_rate))) ** 2
    for _ in range(30):
        sigma = np.sqrt(sum(weights.parts(model, x).values()) + floor)
        found = _least_squares(model, x, sigma)
        renewed = _adapted(model, found, weights, adapt)
        change = float(np.max(np.abs(found - x)))
        steady = math.isclose(renewed.extra, weights.extra, rel_tol=1e-3, abs_tol=1e-3 * floor)
        x, weights = found, renewed
        if change < 1e-6 and steady and math.isclose(renewed.inflation, weights.inflation, rel_tol=1e-3):
            break
    parts = weights.parts(model, x)
    sigma = np.sqrt(sum(parts.values()) + floor)
    return FlowFit(model, x, sigma, parts, adapt == "", weights.inflation, math.nan)


def _adapted(model: FlowModel, x: FloatArray, weights: _Weights, adapt: str) -> _Weights:
    """Weights with which chi-square, common errors included, would equal its degrees of freedom."""
    common, smallest = x[len(model.free) :], _smallest(model)
    freedom = len(model.points) - len(model.free) - float(common @ common)
    if not adapt or freedom <= 0.0:
        return weights
    misfit = (model.flow(x) - model.points.mass_flow_rate) ** 2
    stated = np.asarray(sum(model.variances(x).values())) + (smallest if adapt == "inflation" else 0.0)
    if adapt == "inflation":
        return _Weights(0.0, max(1.0, math.sqrt(float(np.sum(misfit / stated)) / freedom)))
    low, high = smallest, max(float(np.sum(misfit)) / freedom, smallest)
    for _ in range(50):  # chi-square falls with the added variance
        middle = math.sqrt(low * high)  # in logarithms: the ends lie decades apart
        low, high = (middle, high) if np.sum(misfit / (stated + middle)) > freedom else (low, middle)
    return _Weights(high, 1.0)


def start(model: FlowModel) -> FloatArray:
    """Best numbers of a coarse grid; C is linear in the law, so each node has its best C."""
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
    found = {
        "sonic_conductance": per_flow[best] / power[best],
        "critical_ratio": b[best, 0],
        "subsonic_index": m[best, 0],
        "cracking_pressure": cracking[best, 0],
    }
    law = np.array([found[name] for name in model.free])
    return np.concatenate((law, np.zeros(len(model.effects)))) / model.scales


def _unit_flow(points: FlowPoints, **law: Any) -> FloatArray:
    """Flow at the points per C, in which the law is linear; a row for each column of numbers."""
    readings = (getattr(points, channel) for channel in CHANNELS if channel != "mass_flow_rate")
    return np.asarray(mass_flow_rate(*readings, sonic_conductance=1.0, **law))


def _least_squares(model: FlowModel, x: FloatArray, sigma: FloatArray) -> FloatArray:
    from scipy.optimize import least_squares

    low, high = model.bounds
    found = least_squares(
        lambda at: model.residuals(at, sigma),
        np.clip(x, low + 1e-9, high - 1e-9),  # the search wants to begin inside
        lambda at: model.jacobian(at, sigma),
        bounds=(low, high),
        xtol=1e-10,
        ftol=1e-10,
        gtol=1e-10,
    )
    return np.asarray(found.x)


def all_choked(fit: FlowFit) -> FlowFit | None:
    """The fit with every point choked, where the data do not contradict it."""
    if np.max(fit.model.points.pressure_ratio) >= LARGEST_RATIO:
        return None
    fixed = dict(fit.model.fixed) | {"critical_ratio": LARGEST_RATIO, "subsonic_index": 0.5, "cracking_pressure": 0.0}
    other = replace(fit_flow(FlowModel(fit.model.points, fixed)), stated=fit.stated)
    # With the weights of the free fit, else the two cannot be compared.
    misfit = (other.modelled - fit.model.points.mass_flow_rate) / fit.sigma
    common = other.x[len(other.model.free) :]
    allowed = coverage_factor(fit.scatter_freedom) ** 2
    return other if float(misfit @ misfit + common @ common) - fit.chi_square <= allowed else None


def law_estimates(fit: FlowFit) -> dict[str, Estimate]:
    """Estimates with 95 % intervals of the free numbers of the law."""
    low, high = fit.model.bounds
    began = start(fit.model) * fit.model.scales
    found = {}
    for k, name in enumerate(fit.model.free):
        scale = float(fit.model.scales[k])
        bounds = float(low[k]) * scale, float(high[k]) * scale
        at_bound = min(fit.x[k] - low[k], high[k] - fit.x[k]) < 1e-4
        value = min(bounds, key=lambda end: abs(end - fit.x[k] * scale)) if at_bound else float(fit.x[k]) * scale
        budget = _budget(fit, k)
        error = math.sqrt(math.fsum(u * u for u in budget.sources.values())) * scale if fit.gain[1][k] else math.inf
        half = budget.coverage * error
        found[name] = Estimate(
            value,
            UNITS[name],
            error,
            max(value - half, bounds[0]),
            min(value + half, bounds[1] if name != "critical_ratio" else 1.0),
            _verdict(name, value, half, at_bound, scale),
            float(began[k]),
        )
    return found


def _verdict(name: str, value: float, half: float, at_bound: bool, scale: float) -> Verdict:
    """Half the interval against the number's size; for b and m against 1, for the cracking pressure against p1/10."""
    if at_bound:
        return "at bound"
    size = {"sonic_conductance": value, "cracking_pressure": max(value, 0.1 * scale)}.get(name, 1.0)
    return judged(half, size)


def choked_estimates(fit: FlowFit, choked: FlowFit) -> dict[str, Estimate]:
    """Estimates when all points may be choked: C with the range that an unknown b leaves, and b from below."""
    points = choked.model.points
    ratios = np.linspace(0.0, 0.99, 199)
    unit = _unit_flow(points, critical_ratio=ratios[:, None], subsonic_index=fit.values["subsonic_index"])
    # C is linear in the law: for each b the best C follows without a search.
    weighted, measured = unit / fit.sigma, points.mass_flow_rate / fit.sigma
    conductance = weighted @ measured / np.sum(weighted**2, axis=1)
    misfit = np.sum((conductance[:, None] * weighted - measured) ** 2, axis=1)
    possible = misfit - np.min(misfit) <= coverage_factor(fit.scatter_freedom) ** 2
    narrow = law_estimates(choked)["sonic_conductance"]
    half = narrow.high - narrow.value
    low = min(float(np.min(conductance[possible])), narrow.value) - half
    high = max(float(np.max(conductance[possible])), narrow.value) + half
    widest = max(high - narrow.value, narrow.value - low)
    verdict = _verdict("sonic_conductance", narrow.value, widest, False, 1.0)
    found = {"sonic_conductance": replace(narrow, low=low, high=high, verdict=verdict)}
    lowest = {"critical_ratio": float(np.min(ratios[possible]))}
    highest = {"critical_ratio": 1.0, "subsonic_index": 3.0, "cracking_pressure": float(np.max(points.pressure_1))}
    for name in fit.model.free[1:]:
        found[name] = Estimate(math.nan, UNITS[name], math.inf, lowest.get(name, 0.0), highest[name], "not determined")
    return found


def other_law(fit: FlowFit) -> tuple[str, FlowFit] | None:
    """The held number of the law with which free the points are explained best, if clearly better, and that fit."""
    found = []
    for name in ("subsonic_index", "cracking_pressure"):
        rest = {key: value for key, value in fit.model.fixed.items() if key != name}
        richer = FlowModel(fit.model.points, rest)
        if name in fit.model.fixed and len(richer.points) > len(richer.free) and _asked_for(fit, richer, name) > BETTER:
            found.append((name, fit_flow(richer)))
    best = min(found, key=lambda pair: pair[1].aicc, default=None)
    return best if best and fit.aicc - best[1].aicc > BETTER else None


def _asked_for(fit: FlowFit, richer: FlowModel, name: str) -> float:
    """By how much -2 ln L would fall with one number more, by the slopes where the fit ended."""
    place = richer.free.index(name)
    x = np.insert(fit.x, place, fit.model.fixed[name] / richer.scales[place])
    jacobian = richer.jacobian(x, fit.sigma)
    basis = np.linalg.qr(np.delete(jacobian, place, axis=1))[0]
    own = jacobian[:, place] - basis @ (basis.T @ jacobian[:, place])
    share = float(own @ fit.residuals) ** 2 / max(float(own @ own) * fit.chi_square, 1e-300)
    return -len(fit.model.points) * math.log1p(-min(share, 1.0 - 1e-12))


def united(estimates: Mapping[str, Estimate], others: Mapping[str, Estimate]) -> dict[str, Estimate]:
    """The estimates, with intervals that hold those under another law too."""
    found = {}
    for name, e in estimates.items():
        low, high = min(e.low, others[name].low), max(e.high, others[name].high)
        verdict = _verdict(name, e.value, max(high - e.value, e.value - low), e.verdict == "at bound", 1.0)
        found[name] = replace(e, low=low, high=high, verdict=max(verdict, e.verdict, key=VERDICTS.index))
    return found


class _Budget(NamedTuple):
    """Standard uncertainty of a number of order one: by source, of the scatter, common to all points."""

    sources: dict[str, float]
    type_a: float
    type_b: float
    freedom: float
    coverage: float


def _budget(fit: FlowFit, k: int) -> _Budget:
    row, n = fit.gain[0][k], len(fit.model.points)
    variance = fit.sigma**2
    scatter = {
        f"scatter of {channel}": math.sqrt(float(np.sum(row[:n] ** 2 * part / variance)))
        for channel, part in fit.scatter.items()
    }
    common = {effect.source: abs(float(u)) for effect, u in zip(fit.model.effects, row[n:], strict=True)}
    type_a, type_b = math.hypot(*scatter.values()), math.hypot(*common.values())
    freedom = effective_degrees_of_freedom([(type_a, fit.scatter_freedom), (type_b, math.inf)])
    return _Budget(scatter | common, type_a, type_b, freedom, coverage_factor(freedom))


def budgets(fit: FlowFit) -> dict[str, dict[str, Any]]:
    """Uncertainty budgets of the free numbers of the law, for the result."""
    rows = {}
    for k, name in enumerate(fit.model.free):
        budget, scale = _budget(fit, k), float(fit.model.scales[k])
        rows[name] = {
            "type_a": scale * budget.type_a,
            "type_b": scale * budget.type_b,
            "degrees_of_freedom": budget.freedom,
            "coverage_factor": budget.coverage,
            "sources": {source: scale * u for source, u in budget.sources.items()},
        }
    return rows
