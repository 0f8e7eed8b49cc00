"""Formulas of ISO 6358-1: C from the saturated points, and b from each subsonic point."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import chain
from typing import Literal, TypeVar

import numpy as np

from poppet.identify.flow.points import CHANNELS, FlowPoints, conductance_of
from poppet.timeseries.checks import FloatArray

PLATEAU = 0.005
"""Largest relative deviation below the mean of the saturated points at which a point is saturated."""

Free = Literal["free"]
Values = TypeVar("Values", float, FloatArray)


def conductance_uncertainty(u_flow: Values, u_pressure: Values | float, u_temperature: Values | float) -> Values:
    r"""Return the relative standard uncertainty of C from the readings of one choked point.

    The arguments are the relative standard uncertainties of flow, pressure and temperature: u_q, u_p and u_T.

    .. math:: \frac{u(C)}{C} = \sqrt{u_q^2 + u_p^2 + (u_T/2)^2}

    References
    ----------
    JCGM 100:2008 (GUM), equation (12), for the law of ISO 6358-1:2013.

    Examples
    --------
    >>> print(round(conductance_uncertainty(0.01, 0.002, 0.004), 5))
    0.01039
    """
    uncertainty: Values = np.sqrt(u_flow**2 + u_pressure**2 + (0.5 * u_temperature) ** 2)
    return uncertainty


def critical_ratio_uncertainty(
    pressure_ratio: Values,
    flow_ratio: Values,
    u_pressure_ratio: Values | float,
    u_flow_ratio: Values | float,
    subsonic_index: float = 0.5,
) -> Values:
    r"""Return the standard uncertainty of b from the readings of one subsonic point.

    r is the pressure ratio p2/p1, phi is the flow relative to choked flow, and u_r and u_phi are their standard
    uncertainties. m is the subsonic index.

    .. math::

        u(b)^2 = \left(\frac{u_r}{1 - s}\right)^2
               + \left(\frac{1 - r}{(1 - s)^2} \frac{\varphi^{1/m - 1}}{2 m s} u_\varphi\right)^2,
        \quad s = \sqrt{1 - \varphi^{1/m}}

    Notes
    -----
    The formula is of first order, without a cracking pressure, for independent errors of r and phi. The uncertainty is
    largest near r = 1 and near phi = 1; the formula is also least accurate there.

    Examples
    --------
    >>> print(round(critical_ratio_uncertainty(0.8, 0.699854, 0.001, 0.005), 4))
    0.0125
    """
    s = np.sqrt(1.0 - flow_ratio ** (1.0 / subsonic_index))
    by_flow = flow_ratio ** (1.0 / subsonic_index - 1.0) / (2.0 * subsonic_index * s)
    from_flow = (1.0 - pressure_ratio) / (1.0 - s) ** 2 * by_flow * u_flow_ratio
    uncertainty: Values = np.hypot(u_pressure_ratio / (1.0 - s), from_flow)
    return uncertainty


@dataclass(frozen=True)
class StandardEvaluation:
    """Parameters of a flow path according to the formulas of ISO 6358-1."""

    sonic_conductance: float  # mean over the saturated points [m^3/(s Pa)]
    critical_ratio: float  # weighted mean over the subsonic points; NaN without these
    subsonic_index: float
    cracking_pressure: float  # [Pa]
    saturated: tuple[int, ...]  # indices of the choked points
    subsonic: tuple[int, ...]  # indices of the points that give b

    @property
    def numbers(self) -> FloatArray:
        """Values of C, b, m and cracking pressure, in this order."""
        return np.array([self.sonic_conductance, self.critical_ratio, self.subsonic_index, self.cracking_pressure])


def evaluate_by_standard(
    points: FlowPoints, subsonic_index: float | Free = 0.5, cracking_pressure: float | Free = 0.0
) -> StandardEvaluation:
    r"""Return C, b, m and cracking pressure from the formulas of ISO 6358-1.

    .. math::

        C = \overline{C_e}, \qquad b_i = \frac{r_i - s_i k_i}{1 - s_i}, \quad
        s_i = \sqrt{1 - (C_{e,i}/C)^{1/m}}, \quad k_i = 1 - \Delta p_c/p_1

    Notes
    -----
    The points are taken in ascending order of p2/p1. A point is saturated if its effective conductance is at most
    0.5 % (or three times the scatter of the flow meter) below the mean of all previous points. If only one point is
    saturated, C is a lower bound. b is the weighted mean of the values b_i of the subsonic points. The weights follow
    from `critical_ratio_uncertainty`, with equal relative errors if none are stated. Noise and the selection of the
    saturated points reduce C by up to half the tolerance. The direct fit does not have this bias.

    References
    ----------
    ISO 6358-1:2013, calculation of the sonic conductance, the critical back-pressure ratio and the subsonic
    index.

    Examples
    --------
    >>> points = FlowPoints([0.0118500, 0.0118500, 0.00829327], 5e5, [0.5e5, 1e5, 4e5], 293.15)
    >>> found = evaluate_by_standard(points)
    >>> found.saturated, round(found.sonic_conductance * 1e8, 4), round(found.critical_ratio, 3)
    ((0, 1), 2.0, 0.3)
    """
    order = np.argsort(points.pressure_ratio, kind="stable")
    conductance = points.effective_conductance[order]
    meter = points.u_mass_flow_rate
    scatter = math.hypot(meter.relative, meter.absolute / float(np.max(points.mass_flow_rate)))
    tolerance, count = max(PLATEAU, 3.0 * scatter), 1
    while count < order.size and conductance[count] > np.mean(conductance[:count]) * (1.0 - tolerance):
        count += 1
    saturated = order[:count]
    flow_ratio = points.effective_conductance / float(np.mean(points.effective_conductance[saturated]))
    is_subsonic = (
        ~np.isin(np.arange(len(points)), saturated) & (flow_ratio > tolerance) & (flow_ratio < 1.0 - tolerance)
    )
    subsonic = np.flatnonzero(is_subsonic & (points.pressure_ratio < 1.0))
    sets = tuple(saturated.tolist()), tuple(subsonic.tolist())
    return _evaluate_readings(points, {}, *sets, subsonic_index, cracking_pressure)


def standard_uncertainties(
    points: FlowPoints,
    evaluation: StandardEvaluation,
    subsonic_index: float | Free = 0.5,
    cracking_pressure: float | Free = 0.0,
) -> FloatArray:
    r"""Return the standard uncertainties of C, b, m and cracking pressure.

    Each reading x_i is shifted by its standard uncertainty u_i, and the results y are computed again.

    .. math:: u^2(y) = \sum_i [y(x_i + u_i) - y(x_i)]^2

    References
    ----------
    JCGM 100:2008 (GUM), 5.1.3, note 2: numerical evaluation of the combined uncertainty.
    """
    sets = evaluation.saturated, evaluation.subsonic
    warm = (evaluation.critical_ratio, evaluation.subsonic_index, evaluation.cracking_pressure)
    sigmas = {}
    for channel in CHANNELS:
        reading, instrument = getattr(points, channel), points.instrument(channel)
        sigma = np.hypot(instrument.absolute, instrument.relative * reading)
        if channel == "mass_flow_rate" and not instrument.is_noisy and len(evaluation.saturated) > 1:
            plateau = points.effective_conductance[list(evaluation.saturated)]
            sigma = np.full(len(points), np.std(plateau, ddof=1) / np.mean(plateau) * np.max(reading))
        if sigma.any():
            sigmas[channel] = sigma
    # First the errors of each single reading, then those that all points share.
    indices, row = [*evaluation.saturated, *evaluation.subsonic], np.arange(len(points))
    errors = ({channel: np.where(row == k, sigma, 0.0)} for channel, sigma in sigmas.items() for k in indices)
    common = ({c: effect.shift(getattr(points, c)) for c in effect.channels} for effect in points.effects())
    total = np.zeros(4)
    for shifts in chain(errors, common):
        shifted = _evaluate_readings(points, shifts, *sets, subsonic_index, cracking_pressure, warm)
        total += (shifted.numbers - evaluation.numbers) ** 2
    return np.sqrt(total)


def _evaluate_readings(
    points: FlowPoints,
    shifts: Mapping[str, FloatArray],
    saturated: tuple[int, ...],
    subsonic: tuple[int, ...],
    subsonic_index: float | Free,
    cracking_pressure: float | Free,
    warm: tuple[float, float, float] = (0.3, 0.5, 0.0),
) -> StandardEvaluation:
    """Return the results of the standard formulas for slightly changed readings.

    `shifts` maps channels to the changes of their readings. The readings are not checked, because a change can make
    them slightly invalid. `saturated` and `subsonic` are the indices of the choked and the subsonic points. `warm`
    contains start values of b, m and cracking pressure.
    """
    flow, p_1, p_2, temperature = (getattr(points, channel) + shifts.get(channel, 0.0) for channel in CHANNELS)
    effective, indices = conductance_of(flow, p_1, temperature), list(subsonic)
    conductance = float(np.mean(effective[list(saturated)]))
    conductances, ratio, pressure = effective[indices], (p_2 / p_1)[indices], p_1[indices]
    flow_ratio = conductances / conductance
    is_free = [True, subsonic_index == "free", cracking_pressure == "free"]
    index = warm[1] if subsonic_index == "free" else subsonic_index
    cracking = warm[2] if cracking_pressure == "free" else cracking_pressure
    if len(subsonic) < sum(is_free):
        return StandardEvaluation(conductance, math.nan, index, cracking, saturated, subsonic)
    if any(is_free[1:]):
        numbers = _fit_ratio(ratio, flow_ratio, pressure, (warm[0], index, cracking), is_free)
    else:
        phi = np.minimum(flow_ratio, 1.0 - 1e-12)
        # If m is very small, the points do not determine b, and the result is NaN.
        with np.errstate(all="ignore"):
            s = np.sqrt(1.0 - phi ** (1.0 / index))
            ratios = (ratio - s * (1.0 - cracking / pressure)) / (1.0 - s)
            weight = critical_ratio_uncertainty(ratio, phi, 1e-3 * ratio, 1e-3, index) ** -2.0
            numbers = float(np.sum(weight * ratios) / np.sum(weight)), index, cracking
    return StandardEvaluation(conductance, *numbers, saturated, subsonic)


def _fit_ratio(
    ratio: FloatArray,
    flow_ratio: FloatArray,
    pressure: FloatArray,
    warm: tuple[float, float, float],
    is_free: list[bool],
) -> tuple[float, float, float]:
    """Fit b, and m or the cracking pressure or both, to the flow ratios of the subsonic points.

    The arrays have one element for each point: p2/p1, flow relative to choked flow, and p1. `warm` contains start
    values of b, m and cracking pressure, and `is_free` states which of them are free. The result contains all three.
    """
    from scipy.optimize import least_squares

    size = float(np.mean(pressure))
    start = np.array([warm[0], warm[1], warm[2] / size])
    highest = 0.99 * float(np.min((1.0 - ratio) * pressure)) / size
    low, high = np.array([-1.0, 0.05, 0.0]), np.array([0.99, 3.0, max(highest, 1e-6)])

    def numbers(free_values: FloatArray) -> FloatArray:
        full = start.copy()
        full[is_free] = free_values
        return full

    def misfit(free_values: FloatArray) -> FloatArray:
        b, m, cracking = numbers(free_values)
        opens = 1.0 - cracking * size / pressure
        position = np.clip((1.0 - ratio - cracking * size / pressure) / (opens - b), 0.0, 1.0)
        return np.asarray((position * (2.0 - position)) ** m - flow_ratio)

    start_point, bounds = np.clip(start, low + 1e-9, high - 1e-9)[is_free], (low[is_free], high[is_free])
    solution = numbers(least_squares(misfit, start_point, bounds=bounds, xtol=1e-12, ftol=1e-12).x)
    return float(solution[0]), float(solution[1]), float(solution[2] * size)
