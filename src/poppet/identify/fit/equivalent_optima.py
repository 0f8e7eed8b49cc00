"""What optima of like cost make of a fit: intervals that hold all of them, verdicts, the test that tells them apart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.optima import CONDUCTANCES, WALL
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import estimates, shown, verdict
from poppet.identify.free_parameter import by_name
from poppet.identify.result import CONFIDENCE, VERDICTS, Estimate

ALIKE = 0.02
"""Conductances that differ by less are told as one."""
Local = Sequence[Mapping[str, Estimate]]
"""Estimates at each optimum, as if there were no other; the lowest one first."""


def local_estimates(plan: FitPlan, optimum: Optimum) -> list[dict[str, Estimate]]:
    """Estimates at each optimum; of those above the lowest, the interval that their own misfit leaves."""
    every = (optimum, *optimum.others)
    found = [estimates(plan.free, o, spread_of(plan.experiments, o, plan.settings)) for o in every]
    for table, o in zip(found, every, strict=True):
        left = float(np.sqrt(1.0 - o.excess / optimum.limit))
        for name, e in table.items():
            table[name] = replace(e, low=e.value - left * (e.value - e.low), high=e.value + left * (e.high - e.value))
    return found


def united(plan: FitPlan, local: Local) -> dict[str, Estimate]:
    """The estimates of the lowest optimum, their intervals and errors made to hold all others."""
    from scipy.special import ndtri

    result = {}
    for f in plan.free:
        best = local[0][f.name]
        low, high = min(table[f.name].low for table in local), max(table[f.name].high for table in local)
        half = max(best.value - low, high - best.value)
        words = verdict(f, best.value, half), best.verdict
        # At a bound of this optimum, not of all.
        word = words[0] if best.verdict == "at bound" else max(words, key=VERDICTS.index)
        error = max(best.standard_error, half / float(ndtri(0.5 + 0.5 * CONFIDENCE)))
        is_wider = (low, high) != (best.low, best.high)
        result[f.name] = replace(best, standard_error=error, low=low, high=high, verdict=word) if is_wider else best
    return result


def told(plan: FitPlan, optimum: Optimum) -> Iterator[Note]:
    """That the data are fitted alike at several places, and what tells these apart."""
    every = (optimum, *optimum.others)
    apart = {
        f.name: tuple(o.x[k] for o in every)
        for k, f in enumerate(plan.free)
        if verdict(f, optimum.x[k], max(abs(o.x[k] - optimum.x[k]) for o in every)) != "determined"
    }
    if not apart:
        return
    excess = max(o.excess for o in every)
    walls = next((values for name, values in apart.items() if name.endswith(WALL)), ())
    flow = next((f for f in plan.free if f.name in apart and f.address.endswith(CONDUCTANCES)), None)
    if walls and flow:
        # Along the isothermal end the wall heat is flat: several optima there are one answer.
        told_once: dict[float, float] = {}
        for value, wall in zip(apart[flow.name], walls, strict=True):
            if all(abs(value - other) > ALIKE * other for other in told_once):
                told_once[value] = wall
        facts = {"values": (*told_once,), "unit": flow.unit, "walls": (*told_once.values(),), "excess": excess}
        kappa = plan.experiments[0].instance.parameters["gas.isentropic_exponent"]
        factor = max(apart[flow.name]) / min(apart[flow.name])
        yield Note("finding.optima.heat", flow.name, **facts, factor=factor, kappa=kappa)
    else:
        yield Note("finding.optima.other", optima=len(every), numbers=apart, excess=excess)


def tables(plan: FitPlan, optimum: Optimum, local: Local) -> tuple[dict[str, Any], ...]:
    """The optima as plain tables, the lowest one first."""
    names = [f.name for f in plan.free]
    result = []
    for o, found in zip((optimum, *optimum.others), local, strict=True):
        begin = o.begin if o.begin.size else [f.start for f in plan.free]
        result.append(
            {
                "name": o.name,
                "cost": o.cost,
                "excess": o.excess,
                "values": by_name(plan.free, o.x),
                "low": {name: found[name].low for name in names},
                "high": {name: found[name].high for name in names},
                "start": by_name(plan.free, begin),
                "rms": {each.name: each.summary().rms for each in shown(plan.experiments, by_name(plan.free, o.x))},
            }
        )
    return tuple(result)


def searched(plan: FitPlan, optimum: Optimum) -> list[dict[str, Any]]:
    """Every search: the name of its start, its cost over the first weights, where it began and ended."""
    return [
        {"name": o.name, "cost": o.cost, "start": by_name(plan.free, o.begin), "end": by_name(plan.free, o.x)}
        for o in optimum.searches
    ]
