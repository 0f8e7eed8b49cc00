"""Search for all equivalent optima of a fit, which have practically equal costs, and their estimates.

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

from poppet.core.codes import Note
from poppet.identify.fit.experiment import Experiment, channels_of
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.residuals import costs_of
from poppet.identify.fit.search import KnownOptimum, Optimum, SearchSettings, initial_sigmas, optimise, random_point
from poppet.identify.fit.statistics import RANK, UNFELT, channel_fits, estimates, influences, verdict
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.result import CONFIDENCE, DETERMINED, VERDICTS, Estimate
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import noise_of

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
WRONG_CHOICE = 1e-4
"""Probability by chance of the least evidence that excludes an optimum whose conductance differs by more than
`DETERMINED`. A wrong choice between such optima changes C by up to 40 %, so that the 5 % of an interval is too much."""
LARGEST_RATIO = 10.0
"""Largest factor of coarse resolution on that limit. Noise far below the resolution cannot be estimated."""
ALIKE = 0.02
"""Relative difference below which two conductances are reported as one."""
Local = Sequence[Mapping[str, Estimate]]
"""One mapping from address to estimate for each optimum; the optimum of lowest cost first."""


@dataclass
class _Searches:
    """Searches of a fit from several start points, with the optima that they reached."""

    plan: FitPlan
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
        """Run one search from a start point, and return the optimum.

        `name` is the name of the start point. The keyword `fixed` maps names of parameters to fixed values. The search
        ends early if it reaches an optimum in the keyword `joinable`. The keyword `weights` is the noise of each
        channel.
        """
        evaluations_before = self.evaluations

        def report(evaluations: int, cost: float) -> None:
            if self.progress:
                self.progress(evaluations_before + evaluations, min([cost, *(o.cost for o in self.optima)]))

        optimum = optimise(
            self.plan.experiments,
            self.plan.free,
            settings or replace(self.plan.settings, kicks=0),
            progress=report,
            sigmas=weights,
            fixed=fixed,
            start_point=start_point,
            joinable=[
                KnownOptimum(o.x, np.linalg.norm(influences(replace(o, inside=np.zeros((0, 0)))), axis=1), o.cost)
                for o in joinable
                if self.plan.settings.loss == "linear"
            ],
        )
        self.evaluations += optimum.evaluations
        self.is_stopped = self.is_stopped or optimum.interrupted
        return replace(
            optimum, name=name, start_point=start_point, fixed=dict(fixed or {}), evaluations=self.evaluations
        )

    def add(self, name: str, start_point: FloatArray, fixed: Mapping[str, float] | None = None) -> FloatArray:
        """Run one search, store its optimum, and return its end point.

        All stored searches use the same noise of the channels, so their costs are comparable. If the user has
        interrupted the search, the result is the start point. `fixed` maps names of parameters to fixed values.
        """
        if self.is_stopped:
            return start_point
        joinable = [] if fixed else self.optima
        self.optima.append(self.run(name, start_point, fixed=fixed, joinable=joinable, weights=self.weights))
        return self.optima[-1].x

    def lowest(self, optima: Sequence[Optimum]) -> Optimum:
        """Return the optimum with the lowest cost.

        If several optima have the same cost, it is the first one.
        """
        return min(optima, key=lambda o: round(float(np.sum(costs_of(o.residual, self.plan.settings.loss))), TIE))


def find_optima(plan: FitPlan, *, progress: Callable[[int, float], Any] | None = None) -> Optimum:
    """Search from several start points, and return the optimum with the lowest cost.

    The result contains all other optima that fit equally well.
    """
    experiments, free, settings = plan.experiments, plan.free, plan.settings
    searches = _Searches(plan, initial_sigmas(experiments), progress)
    start = np.array([f.start for f in free])
    if wall_units := typical_wall_conductances(experiments, free):
        _search_thermal_limits(searches, start, wall_units)
    searches.add("given", start)
    generator = np.random.default_rng(settings.seed)
    for _ in range(settings.starts - 1):
        searches.add("elsewhere", random_point(free, generator))
    if not any(e.samples for e in experiments):
        # If two flow paths are in series, their parameters can be exchanged: the fit is equally good.
        x = searches.lowest(searches.optima).x
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
                searches.add("swapped", np.clip(point, [f.low for f in free], [f.high for f in free]))
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


def typical_wall_conductances(experiments: Sequence[Experiment], free: Sequence[FreeParameter]) -> dict[int, float]:
    """Return a typical wall conductance for each tank whose temperature was not recorded [W/K].

    The keys are the indices of the free wall conductances. A typical value is the heat capacity of the gas, divided by
    the duration of the pressure change.
    """
    units: dict[int, float] = {}
    for k, f in enumerate(free if not any(e.samples for e in experiments) else ()):
        chamber = f.address.removesuffix(WALL)
        recordings = [
            (e, {channel.address: channel for channel in e.measurement.channels})
            for e in experiments
            if f.address.endswith(WALL) and f.recording in ("", e.name) and f"{chamber}.volume" in e.instance.parameters
        ]
        if any(f"{chamber}.temperature" in channels for _, channels in recordings):
            continue
        for e, channels in recordings:
            if (channel := channels.get(f"{chamber}.pressure")) is not None:
                change = np.abs(channel.values - channel.values[0])
                index = max(1, int(np.argmax(change >= 0.63 * change.max())))
                tau = float(channel.time[index] - channel.time[0])
                content = float(channel.values.max()) * e.instance.parameters[f"{chamber}.volume"]
                unit = content / ((isentropic_exponent_of(e) - 1.0) * e.instance.surroundings.temperature * tau)
                units[k] = max(units.get(k, 0.0), unit)
    return {k: unit for k, unit in units.items() if unit > 0.0}


def isentropic_exponent_of(experiment: Experiment) -> float:
    """Return the isentropic exponent of the gas in the circuit of a recording."""
    return float(experiment.instance.parameters["gas.isentropic_exponent"])


def _search_thermal_limits(searches: _Searches, start: FloatArray, walls: Mapping[int, float]) -> None:
    """Search from the adiabatic and the isothermal limit of the tanks, and from points near them.

    `walls` maps the indices of the free wall conductances to typical values. `start` is the start point of the first
    search.
    """
    free = searches.plan.free
    flows = [k for k, f in enumerate(free) if f.address.endswith(CONDUCTANCES)]

    def at(x: FloatArray, units: float, factor: float = 1.0) -> FloatArray:
        point = x.copy()
        point[list(walls)] = [units * unit for unit in walls.values()]
        point[flows] *= factor
        return np.clip(point, [f.low for f in free], [f.high for f in free])

    def fixed(x: FloatArray) -> dict[str, float]:
        return {free[k].name: float(x[k]) for k in walls}

    kappa = isentropic_exponent_of(searches.plan.experiments[0])
    # The start value of C is that of an isothermal tank.
    point = at(start, 0.0, 1.0 / kappa)
    adiabatic = searches.add("adiabatic", point, fixed(point))
    point = at(adiabatic, ISOTHERMAL, kappa)
    isothermal = searches.add("isothermal", point, fixed(point))
    searches.add("nearly_adiabatic", at(adiabatic, NEARLY_ADIABATIC))
    searches.add("nearly_isothermal", at(isothermal, NEARLY_ISOTHERMAL))


def _points_along_valley(
    free: Sequence[FreeParameter], optimum: Optimum
) -> Iterator[tuple[FloatArray, dict[str, float]]]:
    """Yield start points in the direction that the data determine least, each with one fixed parameter.

    The fixed parameter is the parameter with the largest change in this direction. It is set to twice and to half its
    value at the optimum. It is returned as a mapping from its name to this value.
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
    """Return the best optimum, with all optima that fit equally well.

    All promising searches are repeated with the noise of the optimum `best`. `least` is the lowest cost of the first
    searches, which used the first noise estimates. Optima that agree within their intervals are returned once.
    """
    plan, candidates = searches.plan, [best]
    # Use the weights of the best optimum; a single search has no others.
    for first in searches.optima if len(searches.optima) > 1 else []:
        if first.cost <= HOPELESS * least:
            joinable = [] if first.fixed else [best]
            refit = searches.run(first.name, first.x, fixed=first.fixed, joinable=joinable, weights=best.sigmas)
            candidates.append(replace(refit, start_point=first.start_point))
    for point, fixed in [] if any(e.samples for e in plan.experiments) else _points_along_valley(plan.free, best):
        candidates.append(searches.run("along", point, fixed=fixed, weights=best.sigmas))
    best = searches.lowest(candidates)
    spread = error_model_of(plan, best)
    near, distant = near_limit(plan, best), distant_limit(plan, best)
    equivalent: list[Optimum] = []
    distinct = [estimates(plan.free, best, spread, is_conditional=True)]
    for rival in sorted(candidates, key=lambda o: o.cost):
        rival_spread = error_model_of(plan, rival)
        excess = _evidence_against(plan, best, rival, {o.channel for s in (spread, rival_spread) for o in s.offsets})
        values = by_name(plan.free, rival.x)
        is_same = any(all(e.low <= values[name] <= e.high for name, e in table.items()) for table in distinct)
        limit = distant if is_distant(plan.free, best.x, rival.x) else near
        if excess < limit and not is_same:
            equivalent.append(replace(rival, excess=excess, limit=limit))
            distinct.append(estimates(plan.free, rival, rival_spread, is_conditional=True))
    is_stopped, evaluations = searches.is_stopped, searches.evaluations
    return replace(best, others=tuple(equivalent), limit=near, interrupted=is_stopped, evaluations=evaluations)


def _limit_of_increase(probability: float) -> float:
    """Return the increase in cost above its minimum that noise exceeds with a given probability.

    The cost is half a sum of squares; one parameter is tested.
    """
    from scipy.special import chdtri

    # The cost is half a sum of squares, whose increase is chi-square.
    return 0.5 * float(chdtri(1, probability))


def near_limit(plan: FitPlan, best: Optimum) -> float:
    """Return the excess of cost above which an optimum near `best` no longer counts as equivalent.

    Such an optimum has almost the same conductance as `best`.
    """
    return _limit_of_increase(1.0 - CONFIDENCE) * error_model_of(plan, best).variance_factor


def distant_limit(plan: FitPlan, best: Optimum) -> float:
    """Return the excess of cost above which an optimum far from `best` no longer counts as equivalent.

    Such an optimum has a clearly different conductance.
    """
    return _limit_of_increase(WRONG_CHOICE) * error_model_of(plan, best).variance_factor * rounding_ratio(plan, best)


def is_distant(free: Sequence[FreeParameter], x: FloatArray, other: FloatArray) -> bool:
    """Return True if two optima have clearly different conductances.

    `x` and `other` contain their parameter values. The relative difference must exceed the limit of the verdict
    `determined` on a conductance.
    """
    flows = [k for k, f in enumerate(free) if f.address.endswith(CONDUCTANCES)]
    return any(abs(other[k] - x[k]) > DETERMINED * abs(x[k]) for k in flows)


def rounding_ratio(plan: FitPlan, optimum: Optimum) -> float:
    """Return the ratio of the noise variance with rounding of the readings to that without.

    It is the largest ratio of all channels. The rounding errors are the same at all optima, so they are evidence
    neither for nor against one of them.
    """
    ratios = [1.0]
    for (_, channel, rows), sigma in zip(channels_of(plan.experiments), optimum.sigmas, strict=True):
        rounding = channel.quantum**2 / 12.0
        total = min(noise_of(channel.values, channel.time) ** 2, sigma**2 * float(np.mean(optimum.residual[rows] ** 2)))
        if rounding > 0.0:
            ratios.append(total / max(total - rounding, total / LARGEST_RATIO))
    return max(ratios)


def _evidence_against(plan: FitPlan, best: Optimum, rival: Optimum, offset_channels: Collection[int]) -> float:
    """Return the cost of the optimum `rival` minus the cost of the optimum `best`, at least 0.

    The difference excludes what an offset of the channels `offset_channels` explains. It also excludes samples at which
    the models differ by less than the resolution of a coarse sensor.
    """
    channels = channels_of(plan.experiments)
    is_visible = np.ones(best.residual.size, dtype=bool)
    for (_, channel, rows), sigma in zip(channels, best.sigmas, strict=True):
        if sigma < DITHERED * channel.quantum:
            # A long constant reading of a sensor of coarse resolution is a step, if no noise hides the resolution.
            changes = np.flatnonzero(np.diff(channel.values)) + 1
            lengths = np.diff([0, *changes, channel.values.size])
            difference_of_models = np.abs(rival.residual - best.residual)[rows] * sigma
            is_visible[rows] = (np.repeat(lengths, lengths) < STUCK) | (difference_of_models >= channel.quantum)
    excesses = []
    for offset_rows in ([], [channels[k].rows for k in offset_channels]):
        costs = []
        for optimum in (rival, best):
            residual = optimum.residual
            if offset_rows:
                # Remove a linear fit of the offsets and the free parameters.
                constants = np.zeros((residual.size, len(offset_rows)))
                for k, rows in enumerate(offset_rows):
                    constants[rows, k] = 1.0
                slopes = optimum.jacobian[:, optimum.active == 0]
                norms = np.linalg.norm(slopes, axis=0)
                basis = np.hstack([slopes[:, norms > 0.0] / norms[norms > 0.0], constants])
                residual = residual - basis @ np.linalg.lstsq(basis, residual, rcond=RANK)[0]
            costs.append(costs_of(residual, plan.settings.loss))
        excesses.append(float(np.sum((costs[0] - costs[1])[is_visible])))
    return max(0.0, min(excesses))


def local_estimates(plan: FitPlan, optimum: Optimum) -> list[dict[str, Estimate]]:
    """Return the estimates by name at each equivalent optimum, as if it were the only one.

    An optimum whose cost exceeds the lowest cost has narrower intervals, because its values are less likely. The limit
    of nearby optima applies to a parameter that has the same value at the best optimum.
    """
    optima = (optimum, *optimum.others)
    best, *rivals = [estimates(plan.free, o, error_model_of(plan, o)) for o in optima]
    for table, rival in zip(rivals, optimum.others, strict=True):
        for name, e in table.items():
            low, high = _likely_range(e, rival.excess, rival.limit)
            first = best[name]
            if first.low <= e.value <= first.high:
                nearby = _likely_range(e, rival.excess, optimum.limit)
                low, high = max(low, min(first.low, nearby[0])), min(high, max(first.high, nearby[1]))
            table[name] = replace(e, low=low, high=high)
    return [best, *rivals]


def _likely_range(estimate: Estimate, excess: float, limit: float) -> tuple[float, float]:
    """Return the interval of an estimate at an optimum with the evidence `excess` against it.

    The width of the interval is zero if the evidence reaches `limit`.
    """
    value = estimate.value
    if excess >= limit:
        return value, value
    left = float(np.sqrt(1.0 - excess / limit))
    return value - left * (value - estimate.low), value + left * (estimate.high - value)


def unite_estimates(plan: FitPlan, local: Local) -> dict[str, Estimate]:
    """Return the estimates at the best optimum, with intervals that cover all equivalent optima.

    `local` contains the estimates at each of these optima, the best first.
    """
    from scipy.special import ndtri

    result = {}
    for f in plan.free:
        best = local[0][f.name]
        low, high = min(table[f.name].low for table in local), max(table[f.name].high for table in local)
        half = max(best.value - low, high - best.value)
        verdicts = verdict(f, best.value, half), best.verdict
        # The bound is active at this optimum only.
        joint_verdict = verdicts[0] if best.verdict == "at bound" else max(verdicts, key=VERDICTS.index)
        error = max(best.standard_error, half / float(ndtri(0.5 + 0.5 * CONFIDENCE)))
        is_wider = (low, high) != (best.low, best.high)
        result[f.name] = (
            replace(best, standard_error=error, low=low, high=high, verdict=joint_verdict) if is_wider else best
        )
    return result


def optima_notes(plan: FitPlan, optimum: Optimum) -> Iterator[Note]:
    """Yield a note if equivalent optima have clearly different parameter values."""
    optima = (optimum, *optimum.others)
    differing = {
        f.name: tuple(o.x[k] for o in optima)
        for k, f in enumerate(plan.free)
        if verdict(f, optimum.x[k], max(abs(o.x[k] - optimum.x[k]) for o in optima)) != "determined"
    }
    if not differing:
        return
    # The rms in percent has a meaning for readers, a difference of costs does not.
    sizes = [float(np.sqrt(np.mean(o.residual**2))) for o in optima]
    excess = 100.0 * (max(sizes) / max(min(sizes), 1e-300) - 1.0)
    walls = next((values for name, values in differing.items() if name.endswith(WALL)), ())
    flow = next((f for f in plan.free if f.name in differing and f.address.endswith(CONDUCTANCES)), None)
    if walls and flow:
        # Near the isothermal limit the cost does not depend on the wall conductance: merge these optima.
        distinct: dict[float, float] = {}
        for value, wall in zip(differing[flow.name], walls, strict=True):
            if all(abs(value - conductance) > ALIKE * conductance for conductance in distinct):
                distinct[value] = wall
        facts = {"values": (*distinct,), "unit": flow.unit, "walls": (*distinct.values(),), "excess": excess}
        kappa = plan.experiments[0].instance.parameters["gas.isentropic_exponent"]
        factor = max(differing[flow.name]) / min(differing[flow.name])
        yield Note("finding.optima.heat", flow.name, **facts, factor=factor, kappa=kappa)
    else:
        yield Note("finding.optima.other", optima=len(optima), numbers=differing, excess=excess)


def optimum_tables(plan: FitPlan, optimum: Optimum, local: Local) -> tuple[dict[str, Any], ...]:
    """Return one table for each equivalent optimum, the best first, for the result of a fit.

    `local` contains the estimates at each optimum.
    """
    tables = []
    for o, table in zip((optimum, *optimum.others), local, strict=True):
        values = by_name(plan.free, o.x)
        start = o.start_point if o.start_point.size else [f.start for f in plan.free]
        tables.append(
            {
                "name": o.name,
                "cost": o.cost,
                "excess": o.excess,
                "values": values,
                "low": {name: e.low for name, e in table.items()},
                "high": {name: e.high for name, e in table.items()},
                "start": by_name(plan.free, start),
                "rms": {fit.name: fit.summary().rms for fit in channel_fits(plan.experiments, values)},
            }
        )
    return tuple(tables)


def search_tables(plan: FitPlan, optimum: Optimum) -> list[dict[str, Any]]:
    """Return one table for each search: its name, cost, start point and end point."""
    return [
        {"name": o.name, "cost": o.cost, "start": by_name(plan.free, o.start_point), "end": by_name(plan.free, o.x)}
        for o in optimum.searches
    ]
