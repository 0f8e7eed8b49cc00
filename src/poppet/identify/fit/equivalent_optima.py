"""Intervals, verdicts and notes for fits with several equivalent optima."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.optima import CONDUCTANCES, WALL
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import channel_fits, estimates, verdict
from poppet.identify.free_parameter import by_name
from poppet.identify.result import CONFIDENCE, VERDICTS, Estimate

ALIKE = 0.02
"""Relative difference below which two conductances are reported as one."""
Local = Sequence[Mapping[str, Estimate]]
"""One mapping from address to estimate for each optimum; the optimum of lowest cost first."""


def local_estimates(plan: FitPlan, optimum: Optimum) -> list[dict[str, Estimate]]:
    """Return the estimates at each equivalent optimum, as if it were the only one.

    An optimum whose cost exceeds the lowest cost has narrower intervals, because its values are less likely.
    """
    optima = (optimum, *optimum.others)
    optimum_tables = [estimates(plan.free, o, error_model_of(plan.experiments, o, plan.settings)) for o in optima]
    for table, o in zip(optimum_tables, optima, strict=True):
        left = float(np.sqrt(1.0 - o.excess / optimum.limit))
        for name, e in table.items():
            table[name] = replace(e, low=e.value - left * (e.value - e.low), high=e.value + left * (e.high - e.value))
    return optimum_tables


def unite_estimates(plan: FitPlan, local: Local) -> dict[str, Estimate]:
    """Return the estimates at the lowest optimum, with intervals that include those of all optima."""
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
    """Yield a note if equivalent optima have different parameter values."""
    optima = (optimum, *optimum.others)
    differing = {
        f.name: tuple(o.x[k] for o in optima)
        for k, f in enumerate(plan.free)
        if verdict(f, optimum.x[k], max(abs(o.x[k] - optimum.x[k]) for o in optima)) != "determined"
    }
    if not differing:
        return
    excess = max(o.excess for o in optima)
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
    """Return one plain table for each equivalent optimum, the one of lowest cost first."""
    names = [f.name for f in plan.free]
    result = []
    for o, local_estimates_k in zip((optimum, *optimum.others), local, strict=True):
        start = o.start_point if o.start_point.size else [f.start for f in plan.free]
        result.append(
            {
                "name": o.name,
                "cost": o.cost,
                "excess": o.excess,
                "values": by_name(plan.free, o.x),
                "low": {name: local_estimates_k[name].low for name in names},
                "high": {name: local_estimates_k[name].high for name in names},
                "start": by_name(plan.free, start),
                "rms": {
                    channel.name: channel.summary().rms
                    for channel in channel_fits(plan.experiments, by_name(plan.free, o.x))
                },
            }
        )
    return tuple(result)


def search_tables(plan: FitPlan, optimum: Optimum) -> list[dict[str, Any]]:
    """Return one table for each search: start point, name of the start point, end point and cost."""
    return [
        {"name": o.name, "cost": o.cost, "start": by_name(plan.free, o.start_point), "end": by_name(plan.free, o.x)}
        for o in optimum.searches
    ]
