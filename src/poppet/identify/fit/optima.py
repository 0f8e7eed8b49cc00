"""Search for all equivalent optima of a fit, which have practically equal costs.

An adiabatic and an isothermal tank have the same pressure curve if the supply temperature is constant and C differs by
the factor kappa T_s/T_w. A local analysis cannot detect this. Each fit of a wall conductance from pressures alone
therefore starts from both limits.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

import numpy as np

from poppet.identify.fit.experiment import Experiment, channels_of
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.residuals import costs_of
from poppet.identify.fit.search import KnownOptimum, Optimum, SearchSettings, initial_sigmas, optimise, random_point
from poppet.identify.fit.statistics import RANK, UNFELT, errors, estimates
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.result import CONFIDENCE
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel

WALL, CONDUCTANCES = ".wall_conductance", (".sonic_conductance", ".effective_area")
ISOTHERMAL, NEARLY_ISOTHERMAL, NEARLY_ADIABATIC = 1e4, 10.0, 0.01
"""Transfer units h A tau/(m c_v) of the isothermal limit and of two start points. In each of 78 simulated charges and
discharges, one of the two start points led to the best optimum; either one alone did so in two thirds of them."""
TIE = 2
"""Number of decimals to which costs are compared. Of equal optima, the first one is selected: the adiabatic optimum."""
HOPELESS = 4.0
"""Ratio of cost to least cost above which a search is not repeated from an optimum: twice the rms of the residuals."""
SHALLOW = 0.01
"""Relative singular value of the normalised Jacobian below which the linear model can underestimate a valley."""
DITHERED, STUCK = 0.5, 5
"""Ratio of noise to sensor resolution below which the steps are visible; equal successive samples that make a step. A
difference of models below the resolution is not evidence there."""


@dataclass
class _Searches:
    """Searches over the same residuals from several start points, and the optima they reached."""

    experiments: Sequence[Experiment]
    free: tuple[FreeParameter, ...]
    settings: SearchSettings
    weights: list[float]
    progress: Callable[[int, float], Any] | None = None
    optima: list[Optimum] = field(default_factory=list)
    is_stopped: bool = False
    evaluations: int = 0

    def run(
        self,
        name: str,
        start_point: FloatArray,
        *,
        fixed: Mapping[str, float] | None = None,
        settings: SearchSettings | None = None,
        joinable: Sequence[Optimum] = (),
        weights: list[float] | None = None,
    ) -> Optimum:
        """Run one search from `start_point` and return the optimum."""
        evaluations_before = self.evaluations

        def report(evaluations: int, cost: float) -> None:
            if self.progress:
                self.progress(evaluations_before + evaluations, min([cost, *(o.cost for o in self.optima)]))

        optimum = optimise(
            self.experiments,
            self.free,
            settings or replace(self.settings, kicks=0),
            progress=report,
            sigmas=weights,
            fixed=fixed,
            start_point=start_point,
            joinable=[KnownOptimum(o.x, errors(o), o.cost) for o in joinable if self.settings.loss == "linear"],
        )
        self.evaluations += optimum.evaluations
        self.is_stopped = self.is_stopped or optimum.interrupted
        return replace(
            optimum, name=name, start_point=start_point, fixed=dict(fixed or {}), evaluations=self.evaluations
        )

    def add(self, name: str, start_point: FloatArray, fixed: Mapping[str, float] | None = None) -> FloatArray:
        """Run a search with the initial sigmas, store the optimum and return the end point.

        After an interruption by the user, the result is the start point.
        """
        if self.is_stopped:
            return start_point
        joinable = [] if fixed else self.optima
        self.optima.append(self.run(name, start_point, fixed=fixed, joinable=joinable, weights=self.weights))
        return self.optima[-1].x

    def lowest(self, optima: Sequence[Optimum]) -> Optimum:
        """Return the optimum of lowest cost; of equal optima, the first one."""
        return min(optima, key=lambda o: round(float(np.sum(costs_of(o.residual, self.settings.loss))), TIE))


def find_optima(
    experiments: Sequence[Experiment],
    free: tuple[FreeParameter, ...],
    settings: SearchSettings,
    *,
    progress: Callable[[int, float], Any] | None = None,
) -> Optimum:
    """Return the optimum of lowest cost, with all equivalent optima."""
    searches = _Searches(experiments, free, settings, initial_sigmas(experiments), progress)
    start = np.array([f.start for f in free])
    if wall_units := thermal_units(experiments, free):
        _search_thermal_limits(searches, start, wall_units)
    searches.add("given", start)
    generator = np.random.default_rng(settings.seed)
    for _ in range(settings.starts - 1):
        searches.add("elsewhere", random_point(free, generator))
    if not any(e.samples for e in experiments):
        for point in _swapped_points(free, searches.lowest(searches.optima).x):
            searches.add("swapped", point)
    lowest = searches.lowest(searches.optima)
    if searches.is_stopped:
        return replace(lowest, interrupted=True)
    # Repeat with the noise of the residuals, and with restarts if these are not white.
    best = replace(
        searches.run(lowest.name, lowest.x, settings=settings, joinable=searches.optima), start_point=lowest.start_point
    )
    if not searches.is_stopped:
        best = _add_equivalent_optima(searches, best, lowest.cost)
    return replace(best, searches=tuple(searches.optima))


# Start points -----------------------------------------------------------------------------------------------------


def thermal_units(experiments: Sequence[Experiment], free: Sequence[FreeParameter]) -> dict[int, float]:
    """Return the wall conductances of tanks without temperature data.

    The result maps the index of each such free parameter to the wall conductance of one transfer unit [W/K].
    """
    if any(e.samples for e in experiments):
        return {}
    units = {k: _one_unit(experiments, f) for k, f in enumerate(free) if f.address.endswith(WALL)}
    return {k: unit for k, unit in units.items() if unit > 0.0}


def _one_unit(experiments: Sequence[Experiment], wall: FreeParameter) -> float:
    """Return the heat capacity of the gas, divided by the duration of the pressure change [W/K].

    This is the wall conductance of one transfer unit. The result is 0 if the temperature of the gas was recorded.
    """
    chamber, unit = wall.address.removesuffix(WALL), 0.0
    for e in experiments:
        channels = {c.address: c for c in e.measurement.channels}
        if wall.recording not in ("", e.name) or f"{chamber}.volume" not in e.instance.parameters:
            continue
        if f"{chamber}.temperature" in channels:
            return 0.0
        if (channel := channels.get(f"{chamber}.pressure")) is None:
            continue
        change = np.abs(channel.values - channel.values[0])
        tau = float(channel.time[max(1, int(np.argmax(change >= 0.63 * change.max())))] - channel.time[0])
        content = float(channel.values.max()) * e.instance.parameters[f"{chamber}.volume"]
        unit = max(unit, content / ((kappa_of(e) - 1.0) * e.instance.surroundings.temperature * tau))
    return unit


def kappa_of(experiment: Experiment) -> float:
    """Return the isentropic exponent of the gas in a recording."""
    return float(experiment.instance.parameters["gas.isentropic_exponent"])


def _search_thermal_limits(searches: _Searches, start: FloatArray, walls: Mapping[int, float]) -> None:
    """Search at the adiabatic and the isothermal limit, then from points near these limits."""
    free = searches.free
    flows = [k for k, f in enumerate(free) if f.address.endswith(CONDUCTANCES)]

    def at(x: FloatArray, units: float, factor: float = 1.0) -> FloatArray:
        point = x.copy()
        point[list(walls)] = [units * unit for unit in walls.values()]
        point[flows] *= factor
        return np.clip(point, [f.low for f in free], [f.high for f in free])

    def fixed(x: FloatArray) -> dict[str, float]:
        return {free[k].name: float(x[k]) for k in walls}

    kappa = kappa_of(searches.experiments[0])
    # The start value of C is that of an isothermal tank.
    point = at(start, 0.0, 1.0 / kappa)
    adiabatic = searches.add("adiabatic", point, fixed(point))
    point = at(adiabatic, ISOTHERMAL, kappa)
    isothermal = searches.add("isothermal", point, fixed(point))
    searches.add("nearly_adiabatic", at(adiabatic, NEARLY_ADIABATIC))
    searches.add("nearly_isothermal", at(isothermal, NEARLY_ISOTHERMAL))


def _swapped_points(free: Sequence[FreeParameter], x: FloatArray) -> Iterator[FloatArray]:
    """Yield start points in which the parameters of two parts are exchanged.

    If two flow paths are in series, the exchanged parameters can fit equally well.
    """
    parts: dict[str, dict[str, int]] = {}
    for k, f in enumerate(free):
        part, _, local = f.name.rpartition(".")
        if f.role == "number":
            parts.setdefault(part, {})[local] = k
    for first, second in combinations(parts.values(), 2):
        if set(first) == set(second) and any(f".{local}" in CONDUCTANCES for local in first):
            point = x.copy()
            for local in first:
                point[first[local]], point[second[local]] = x[second[local]], x[first[local]]
            yield np.clip(point, [f.low for f in free], [f.high for f in free])


def _points_along_valley(
    free: Sequence[FreeParameter], optimum: Optimum
) -> Iterator[tuple[FloatArray, dict[str, float]]]:
    """Yield start points along the direction that the data determine least, and the fixed parameter.

    The parameter with the largest change is twice or half its value at the optimum. It is fixed at this value in the
    search.
    """
    indices = np.flatnonzero((optimum.active == 0) & (optimum.x != 0.0))
    slopes = optimum.jacobian[:, indices] * optimum.x[indices]
    norms = np.linalg.norm(slopes, axis=0)
    indices, slopes, norms = indices[norms > UNFELT], slopes[:, norms > UNFELT], norms[norms > UNFELT]
    if indices.size < 2:
        return
    _, sizes, directions = np.linalg.svd(slopes / norms, full_matrices=False)
    # A direction that is not identifiable needs no search.
    if not RANK * sizes[0] < sizes[-1] < SHALLOW * sizes[0]:
        return
    direction = directions[-1] / norms
    dominant = int(np.argmax(np.abs(direction)))
    for factor in (2.0, 0.5):
        point = optimum.x.copy()
        point[indices] *= factor ** (direction / direction[dominant])
        point = np.clip(point, [f.low for f in free], [f.high for f in free])
        yield point, {free[indices[dominant]].name: float(point[indices[dominant]])}


# Equivalent optima ----------------------------------------------------------------------------------------------


def _add_equivalent_optima(searches: _Searches, best: Optimum, least: float) -> Optimum:
    """Return the optimum of lowest cost, with all equivalent optima.

    `least` is the least cost of the first searches, with the initial sigmas. Optima that agree within their intervals
    are returned once.
    """
    from scipy.special import chdtri

    candidates = [best]
    # Use the weights of the best optimum; a single search has no others.
    for first in searches.optima if len(searches.optima) > 1 else []:
        if first.cost <= HOPELESS * least:
            joinable = [] if first.fixed else [best]
            refit = searches.run(first.name, first.x, fixed=first.fixed, joinable=joinable, weights=best.sigmas)
            candidates.append(replace(refit, start_point=first.start_point))
    for point, fixed in (
        [] if any(e.samples for e in searches.experiments) else _points_along_valley(searches.free, best)
    ):
        candidates.append(searches.run("along", point, fixed=fixed, weights=best.sigmas))
    best = searches.lowest(candidates)
    spread = error_model_of(searches.experiments, best, searches.settings)
    # The cost is half a sum of squares, whose increase is chi-square.
    limit = 0.5 * float(chdtri(1, 1.0 - CONFIDENCE)) * spread.variance_factor
    equivalent: list[Optimum] = []
    for rival in sorted(candidates, key=lambda o: o.cost):
        offset_channels = {
            o.channel
            for s in (spread, error_model_of(searches.experiments, rival, searches.settings))
            for o in s.offsets
        }
        excess = evidence(searches.experiments, best, rival, searches.settings.loss, offset_channels)
        if excess < limit and not any(_is_same(searches, o, rival) for o in (best, *equivalent)):
            equivalent.append(replace(rival, excess=excess))
    is_stopped, evaluations = searches.is_stopped, searches.evaluations
    return replace(best, others=tuple(equivalent), limit=limit, interrupted=is_stopped, evaluations=evaluations)


def evidence(
    experiments: Sequence[Experiment], best: Optimum, rival: Optimum, loss: str = "linear", off: Collection[int] = ()
) -> float:
    """Return the evidence against another optimum: the difference of costs, at least 0.

    `off` contains the indices of channels with a possible offset. The difference excludes what such an offset explains,
    and differences of the models that are below the resolution of a sensor.
    """
    channels = channels_of(experiments)
    is_visible = np.ones(best.residual.size, dtype=bool)
    for fitted, sigma in zip(channels, best.sigmas, strict=True):
        difference_of_models = np.abs(rival.residual - best.residual)[fitted.rows] * sigma
        is_visible[fitted.rows] = ~_is_on_step(fitted.channel, sigma) | (difference_of_models >= fitted.channel.quantum)
    excesses = []
    for rows in ([], [channels[k].rows for k in off]):
        difference = costs_of(_residuals_without_offsets(rival, rows), loss) - costs_of(
            _residuals_without_offsets(best, rows), loss
        )
        excesses.append(float(np.sum(difference[is_visible])))
    return max(0.0, min(excesses))


def _residuals_without_offsets(optimum: Optimum, offset_rows: Sequence[slice]) -> FloatArray:
    """Return the residuals after a linear fit of channel offsets and free parameters."""
    constants = np.zeros((optimum.residual.size, len(offset_rows)))
    for k, rows in enumerate(offset_rows):
        constants[rows, k] = 1.0
    if constants.size == 0:
        return optimum.residual
    slopes = optimum.jacobian[:, optimum.active == 0]
    norms = np.linalg.norm(slopes, axis=0)
    basis = np.hstack([slopes[:, norms > 0.0] / norms[norms > 0.0], constants])
    return np.asarray(optimum.residual - basis @ np.linalg.lstsq(basis, optimum.residual, rcond=RANK)[0])


def _is_on_step(channel: Channel, sigma: float) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Return a mask of the samples in long constant readings of a sensor of coarse resolution.

    The mask contains no sample if the noise is large enough to hide the resolution.

    The mask is empty if the noise is large enough to hide the resolution.
    """
    result = np.zeros(channel.values.size, dtype=bool)
    if sigma < DITHERED * channel.quantum:
        changes = np.flatnonzero(np.diff(channel.values)) + 1
        for start_point, end in zip([0, *changes], [*changes, result.size], strict=True):
            result[start_point:end] = end - start_point >= STUCK
    return result


def _is_same(searches: _Searches, first: Optimum, second: Optimum) -> bool:
    """Return True if all parameters of the second optimum are in the intervals of the first."""
    intervals = estimates(searches.free, first, error_model_of(searches.experiments, first, searches.settings))
    return all(
        intervals[f.name].low <= x <= intervals[f.name].high for f, x in zip(searches.free, second.x, strict=True)
    )
