"""All places at which a fit is as good as it gets: the lowest one, and those that the data cannot tell from it.

A tank that fills without wall heat and one that is isothermal have the same pressure at all times where the flow
comes from a supply of fixed temperature and C differs by kappa T_s/T_w. No local analysis sees that: every fit of wall
heat from pressures alone is begun from both ends.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

import numpy as np

from poppet.identify.fit.experiment import Experiment, channels_of
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.losses import costs_of
from poppet.identify.fit.search import KnownOptimum, Optimum, SearchSettings, elsewhere, first_weights, optimise
from poppet.identify.fit.statistics import RANK, UNFELT, errors, estimates
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.result import CONFIDENCE
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel

WALL, CONDUCTANCES = ".wall_conductance", (".sonic_conductance", ".effective_area")
ISOTHERMAL, NEARLY_ISOTHERMAL, NEARLY_ADIABATIC = 1e4, 10.0, 0.01
"""Transfer units h A tau/(m c_v): of the isothermal limit, and where searches begin. One or the other search from the
last two found the best optimum of each of 78 seeded charges and discharges; alone each found two thirds."""
TIE = 2
"""Decimals of the cost to which exact twins are equal: the adiabatic one is then the answer."""
HOPELESS = 4.0
"""Times the least cost above which a place is not looked at again: twice the misfit."""
SHALLOW = 0.01
"""Least singular value of the slopes, each over its norm, below which a valley may be longer than its slopes say."""
DITHERED, STUCK = 0.5, 5
"""Noise over the step of a gauge below which it does not blur the steps, and equal samples in a row of a gauge that
stands on one: a difference of models below a step is no evidence there."""


@dataclass
class _Searches:
    """Searches over the same residuals from several places; where each one ended."""

    experiments: Sequence[Experiment]
    free: tuple[FreeParameter, ...]
    settings: SearchSettings
    weights: list[float]
    progress: Callable[[int, float], Any] | None = None
    found: list[Optimum] = field(default_factory=list)
    is_stopped: bool = False
    evaluations: int = 0

    def run(
        self,
        name: str,
        begin: FloatArray,
        *,
        held: Mapping[str, float] | None = None,
        settings: SearchSettings | None = None,
        known: Sequence[Optimum] = (),
        weights: list[float] | None = None,
    ) -> Optimum:
        """One search; with weights of its own it comes to an end of its own."""
        before = self.evaluations

        def told(evaluations: int, cost: float) -> None:
            if self.progress:
                self.progress(before + evaluations, min([cost, *(o.cost for o in self.found)]))

        optimum = optimise(
            self.experiments,
            self.free,
            settings or replace(self.settings, kicks=0),
            progress=told,
            sigmas=weights,
            held=held,
            begin=begin,
            known=[KnownOptimum(o.x, errors(o), o.cost) for o in known if self.settings.loss == "linear"],
        )
        self.evaluations += optimum.evaluations
        self.is_stopped = self.is_stopped or optimum.interrupted
        return replace(optimum, name=name, begin=begin, held=dict(held or {}), evaluations=self.evaluations)

    def add(self, name: str, begin: FloatArray, held: Mapping[str, float] | None = None) -> FloatArray:
        """One more search over the first weights, unless the user has had enough; where it ended."""
        if self.is_stopped:
            return begin
        known = [] if held else self.found
        self.found.append(self.run(name, begin, held=held, known=known, weights=self.weights))
        return self.found[-1].x

    def lowest(self, found: Sequence[Optimum]) -> Optimum:
        """The first of those with the least cost."""
        return min(found, key=lambda o: round(float(np.sum(costs_of(o.residual, self.settings.loss))), TIE))


def optima(
    experiments: Sequence[Experiment],
    free: tuple[FreeParameter, ...],
    settings: SearchSettings,
    *,
    progress: Callable[[int, float], Any] | None = None,
) -> Optimum:
    """The lowest optimum, with all others that the data cannot tell from it."""
    searches = _Searches(experiments, free, settings, first_weights(experiments), progress)
    start = np.array([f.start for f in free])
    if walls := thermal_units(experiments, free):
        _from_thermal_ends(searches, start, walls)
    searches.add("given", start)
    generator = np.random.default_rng(settings.seed)
    for _ in range(settings.starts - 1):
        searches.add("elsewhere", elsewhere(free, generator))
    if not any(e.samples for e in experiments):
        for place in _swapped(free, searches.lowest(searches.found).x):
            searches.add("swapped", place)
    lowest = searches.lowest(searches.found)
    if searches.is_stopped:
        return replace(lowest, interrupted=True)
    # Now with the noise as the residuals show it, and kicks where these are not white.
    best = replace(searches.run(lowest.name, lowest.x, settings=settings, known=searches.found), begin=lowest.begin)
    if not searches.is_stopped:
        best = _with_rivals(searches, best, lowest.cost)
    return replace(best, searches=tuple(searches.found))


# Where to begin ---------------------------------------------------------------------------------------------------


def thermal_units(experiments: Sequence[Experiment], free: Sequence[FreeParameter]) -> dict[int, float]:
    """Places of the wall conductances that only pressures speak of, with that of one transfer unit [W/K]."""
    if any(e.samples for e in experiments):
        return {}
    units = {k: _one_unit(experiments, f) for k, f in enumerate(free) if f.address.endswith(WALL)}
    return {k: one for k, one in units.items() if one > 0.0}


def _one_unit(experiments: Sequence[Experiment], wall: FreeParameter) -> float:
    """Heat capacity of the gas over the time of most of its change [W/K]; 0 where its temperature was recorded."""
    chamber, found = wall.address.removesuffix(WALL), 0.0
    for e in experiments:
        channels = {c.address: c for c in e.measurement.channels}
        if wall.recording not in ("", e.name) or f"{chamber}.volume" not in e.instance.parameters:
            continue
        if f"{chamber}.temperature" in channels:
            return 0.0
        if (channel := channels.get(f"{chamber}.pressure")) is None:
            continue
        moved = np.abs(channel.values - channel.values[0])
        tau = float(channel.time[max(1, int(np.argmax(moved >= 0.63 * moved.max())))] - channel.time[0])
        content = float(channel.values.max()) * e.instance.parameters[f"{chamber}.volume"]
        found = max(found, content / ((kappa_of(e) - 1.0) * e.instance.surroundings.temperature * tau))
    return found


def kappa_of(experiment: Experiment) -> float:
    """Isentropic exponent of the gas in a recording."""
    return float(experiment.instance.parameters["gas.isentropic_exponent"])


def _from_thermal_ends(searches: _Searches, start: FloatArray, walls: Mapping[int, float]) -> None:
    """Searches in both thermal limits, and from near them."""
    free = searches.free
    flows = [k for k, f in enumerate(free) if f.address.endswith(CONDUCTANCES)]

    def at(x: FloatArray, units: float, factor: float = 1.0) -> FloatArray:
        moved = x.copy()
        moved[list(walls)] = [units * one for one in walls.values()]
        moved[flows] *= factor
        return np.clip(moved, [f.low for f in free], [f.high for f in free])

    def held(x: FloatArray) -> dict[str, float]:
        return {free[k].name: float(x[k]) for k in walls}

    kappa = kappa_of(searches.experiments[0])
    # C of the start is that of an isothermal tank.
    begin = at(start, 0.0, 1.0 / kappa)
    adiabatic = searches.add("adiabatic", begin, held(begin))
    begin = at(adiabatic, ISOTHERMAL, kappa)
    isothermal = searches.add("isothermal", begin, held(begin))
    searches.add("nearly_adiabatic", at(adiabatic, NEARLY_ADIABATIC))
    searches.add("nearly_isothermal", at(isothermal, NEARLY_ISOTHERMAL))


def _swapped(free: Sequence[FreeParameter], x: FloatArray) -> Iterator[FloatArray]:
    """Places with the numbers of two parts exchanged: passages in series may be alike in either order."""
    parts: dict[str, dict[str, int]] = {}
    for k, f in enumerate(free):
        part, _, local = f.name.rpartition(".")
        if f.role == "number":
            parts.setdefault(part, {})[local] = k
    for one, other in combinations(parts.values(), 2):
        if set(one) == set(other) and any(f".{local}" in CONDUCTANCES for local in one):
            moved = x.copy()
            for local in one:
                moved[one[local]], moved[other[local]] = x[other[local]], x[one[local]]
            yield np.clip(moved, [f.low for f in free], [f.high for f in free])


def _along(free: Sequence[FreeParameter], optimum: Optimum) -> Iterator[tuple[FloatArray, dict[str, float]]]:
    """Places farther along a direction that is hardly seen: what moves most is twice, or half, of what it was."""
    inside = np.flatnonzero((optimum.active == 0) & (optimum.x != 0.0))
    slopes = optimum.jacobian[:, inside] * optimum.x[inside]
    norms = np.linalg.norm(slopes, axis=0)
    inside, slopes, norms = inside[norms > UNFELT], slopes[:, norms > UNFELT], norms[norms > UNFELT]
    if inside.size < 2:
        return
    _, sizes, directions = np.linalg.svd(slopes / norms, full_matrices=False)
    # What is not seen at all needs no search: it is not determined.
    if not RANK * sizes[0] < sizes[-1] < SHALLOW * sizes[0]:
        return
    direction = directions[-1] / norms
    most = int(np.argmax(np.abs(direction)))
    for factor in (2.0, 0.5):
        moved = optimum.x.copy()
        moved[inside] *= factor ** (direction / direction[most])
        moved = np.clip(moved, [f.low for f in free], [f.high for f in free])
        yield moved, {free[inside[most]].name: float(moved[inside[most]])}


# What the data cannot tell apart ----------------------------------------------------------------------------------


def _with_rivals(searches: _Searches, best: Optimum, least: float) -> Optimum:
    """The best of all places, with the others of like cost, each once; `least` is the least cost over first weights."""
    from scipy.special import chdtri

    every = [best]
    # Over the weights of the best; a single search has led to the best.
    for first in searches.found if len(searches.found) > 1 else []:
        if first.cost <= HOPELESS * least:
            known = [] if first.held else [best]
            again = searches.run(first.name, first.x, held=first.held, known=known, weights=best.sigmas)
            every.append(replace(again, begin=first.begin))
    for place, held in [] if any(e.samples for e in searches.experiments) else _along(searches.free, best):
        every.append(searches.run("along", place, held=held, weights=best.sigmas))
    best = searches.lowest(every)
    spread = spread_of(searches.experiments, best, searches.settings)
    # The cost is half a sum of squares, which exceeds its least value by chi-square.
    limit = 0.5 * float(chdtri(1, 1.0 - CONFIDENCE)) * spread.widening
    found: list[Optimum] = []
    for rival in sorted(every, key=lambda o: o.cost):
        off = {
            o.channel for s in (spread, spread_of(searches.experiments, rival, searches.settings)) for o in s.offsets
        }
        excess = evidence(searches.experiments, best, rival, searches.settings.loss, off)
        if excess < limit and not any(_is_same(searches, o, rival) for o in (best, *found)):
            found.append(replace(rival, excess=excess))
    is_stopped, evaluations = searches.is_stopped, searches.evaluations
    return replace(best, others=tuple(found), limit=limit, interrupted=is_stopped, evaluations=evaluations)


def evidence(
    experiments: Sequence[Experiment], best: Optimum, other: Optimum, loss: str = "linear", off: Collection[int] = ()
) -> float:
    """By how much the data speak for one place against another, as a difference of cost, never negative.

    Whatever a constant in the channels that are `off` explains is no evidence, nor what a coarse gauge does not show.
    """
    channels = channels_of(experiments)
    shown = np.ones(best.residual.size, dtype=bool)
    for each, sigma in zip(channels, best.sigmas, strict=True):
        moved = np.abs(other.residual - best.residual)[each.rows] * sigma
        shown[each.rows] = ~_is_standing(each.channel, sigma) | (moved >= each.channel.quantum)
    found = []
    for rows in ([], [channels[k].rows for k in off]):
        difference = costs_of(_explained(other, rows), loss) - costs_of(_explained(best, rows), loss)
        found.append(float(np.sum(difference[shown])))
    return max(0.0, min(found))


def _explained(optimum: Optimum, off: Sequence[slice]) -> FloatArray:
    """Residuals that constants over some rows leave, the numbers fitted along."""
    constants = np.zeros((optimum.residual.size, len(off)))
    for k, rows in enumerate(off):
        constants[rows, k] = 1.0
    if constants.size == 0:
        return optimum.residual
    slopes = optimum.jacobian[:, optimum.active == 0]
    norms = np.linalg.norm(slopes, axis=0)
    known = np.hstack([slopes[:, norms > 0.0] / norms[norms > 0.0], constants])
    return np.asarray(optimum.residual - known @ np.linalg.lstsq(known, optimum.residual, rcond=RANK)[0])


def _is_standing(channel: Channel, sigma: float) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Samples at which a coarse gauge stands on a step that noise does not blur."""
    result = np.zeros(channel.values.size, dtype=bool)
    if sigma < DITHERED * channel.quantum:
        changes = np.flatnonzero(np.diff(channel.values)) + 1
        for begin, end in zip([0, *changes], [*changes, result.size], strict=True):
            result[begin:end] = end - begin >= STUCK
    return result


def _is_same(searches: _Searches, one: Optimum, other: Optimum) -> bool:
    """Whether every number of one place lies in the interval of the other."""
    found = estimates(searches.free, one, spread_of(searches.experiments, one, searches.settings))
    return all(found[f.name].low <= x <= found[f.name].high for f, x in zip(searches.free, other.x, strict=True))
