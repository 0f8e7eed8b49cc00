"""Direct fit of the flow law to the points of a bench, with errors in every reading.

Errors from point to point enter as effective variances: each reading's error is carried through the law to the
flow. Errors common to all points (calibration, zero offset) are numbers of the fit with a known spread, one
residual each, so that every estimate's covariance contains them with all their correlations.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from poppet.ground.errors import InputError
from poppet.identify.flow.points import CHANNELS, Effect, FloatArray, FlowPoints
from poppet.identify.gum import chi_square_probability, gain
from poppet.laws.iso6358 import mass_flow_rate

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


@dataclass(frozen=True, eq=False)
class FlowModel:
    """The law with what is free, what is fixed and the common errors.

    Parameters
    ----------
    points : FlowPoints
        Measured.
    fixed : mapping
        Value of every number of the law that is not free.
    """

    points: FlowPoints
    fixed: Mapping[str, float]

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
        """Numbers of the law from the vector of the search."""
        values = (x * self.scales)[: len(self.free)].tolist()
        return dict(self.fixed) | dict(zip(self.free, values, strict=True))

    def readings(self, x: FloatArray) -> dict[str, FloatArray]:
        """Pressures and temperatures without the common errors."""
        shifted = {name: getattr(self.points, name) for name in CHANNELS if name != "mass_flow_rate"}
        for size, effect in zip(x[len(self.free) :].tolist(), self.effects, strict=True):
            for channel in effect.channels:
                if channel in shifted:
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
        for size, effect in zip(x[len(self.free) :].tolist(), self.effects, strict=True):
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


@dataclass(frozen=True, eq=False)
class FlowFit:
    """Least squares and what belongs to it.

    Parameters
    ----------
    model : FlowModel
        What was fitted.
    x : (p,) array
        Best numbers of order one, common errors last.
    sigma : (n,) array
        Standard deviation of each residual [kg/s].
    scatter : dict
        Variance of each residual by source; their sum is sigma squared [kg^2/s^2].
    scatter_is_known : bool
        False when (a part of) it was estimated from the residuals.
    inflation : float
        Factor on the stated uncertainties from point to point that the residuals asked for; 1 for none.
    stated : float
        Probability of such residuals with the uncertainties as stated; not-a-number when not stated.
    """

    model: FlowModel
    x: FloatArray
    sigma: FloatArray
    scatter: dict[str, FloatArray]
    scatter_is_known: bool
    inflation: float
    stated: float

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
        return _residuals(self.model, self.x, self.sigma)

    @cached_property
    def chi_square(self) -> float:
        """Sum of squares of all residuals."""
        return float(self.residuals @ self.residuals)

    @property
    def degrees_of_freedom(self) -> int:
        """Points less free numbers of the law; a common error brings one residual and one number."""
        return len(self.model.points) - len(self.model.free)

    @cached_property
    def jacobian(self) -> FloatArray:
        """Derivative of the residuals by the numbers of order one."""
        return _jacobian(self.model, self.x, self.sigma)

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
    known = model.points.u_mass_flow_rate.is_noisy
    x = start(model)
    fit = _settled(model, x, _Weights(0.0, 1.0) if known else _first_weights(model, x), adapt="" if known else "extra")
    if not known:
        return fit
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


def _first_weights(model: FlowModel, x: FloatArray) -> _Weights:
    misfit = model.flow(x) - model.points.mass_flow_rate
    smallest = (1e-6 * float(np.max(model.points.mass_flow_rate))) ** 2  # exact data: below any flow meter
    return _Weights(max(float(np.mean(misfit**2)), smallest), 1.0)


def _settled(model: FlowModel, x: FloatArray, weights: _Weights, adapt: str) -> FlowFit:
    """Alternate between weights and least squares until both stay."""
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
    common = x[len(model.free) :]
    freedom = len(model.points) - len(model.free) - float(common @ common)
    misfit = (model.flow(x) - model.points.mass_flow_rate) ** 2
    smallest = (1e-6 * float(np.max(model.points.mass_flow_rate))) ** 2
    stated = np.asarray(sum(model.variances(x).values())) + (smallest if adapt == "inflation" else 0.0)
    if not adapt or freedom <= 0.0:
        return weights
    if adapt == "inflation":
        return _Weights(0.0, max(1.0, math.sqrt(float(np.sum(misfit / stated)) / freedom)))
    low, high = smallest, max(float(np.sum(misfit)) / freedom, smallest)
    for _ in range(50):  # chi-square falls with the added variance
        middle = math.sqrt(low * high)
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
    unit = mass_flow_rate(
        points.pressure_1,
        points.pressure_2,
        points.temperature_1,
        sonic_conductance=1.0,
        critical_ratio=b,
        subsonic_index=m,
        cracking_pressure=cracking,
        laminar_ratio=NO_ZONE,
    )
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


def _residuals(model: FlowModel, x: FloatArray, sigma: FloatArray) -> FloatArray:
    misfit = (model.flow(x) - model.points.mass_flow_rate) / sigma
    return np.concatenate((misfit, x[len(model.free) :]))


def _jacobian(model: FlowModel, x: FloatArray, sigma: FloatArray) -> FloatArray:
    """Central differences that stay within the bounds."""
    low, high = model.bounds
    step, columns = 1e-6, []
    for k in range(x.size):
        up, down = x.copy(), x.copy()
        up[k], down[k] = min(x[k] + step, high[k]), max(x[k] - step, low[k])
        columns.append((_residuals(model, up, sigma) - _residuals(model, down, sigma)) / (up[k] - down[k]))
    return np.column_stack(columns)


def _least_squares(model: FlowModel, x: FloatArray, sigma: FloatArray) -> FloatArray:
    from scipy.optimize import least_squares

    low, high = model.bounds
    found = least_squares(
        lambda at: _residuals(model, at, sigma),
        np.clip(x, low + 1e-9, high - 1e-9),
        lambda at: _jacobian(model, at, sigma),
        bounds=(low, high),
        xtol=1e-10,
        ftol=1e-10,
        gtol=1e-10,
    )
    return np.asarray(found.x)
