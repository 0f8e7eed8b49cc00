"""Estimates of a flow bench with their intervals, verdicts and uncertainty budgets."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.identify.flow.fit import LARGEST_RATIO, UNITS, FlowFit, FlowModel, fit_flow, start
from poppet.identify.gum import coverage_factor, effective_degrees_of_freedom
from poppet.identify.result import Estimate, Verdict
from poppet.laws.iso6358 import mass_flow_rate

DETERMINED, WEAK = 0.1, 0.5
"""Half an interval over the size of the number: at most the first is determined, above the second is not."""


def all_choked(fit: FlowFit) -> FlowFit | None:
    """The fit with every point choked, where the data do not contradict it."""
    if np.max(fit.model.points.pressure_ratio) >= LARGEST_RATIO:
        return None
    fixed = dict(fit.model.fixed) | {"critical_ratio": LARGEST_RATIO, "subsonic_index": 0.5, "cracking_pressure": 0.0}
    other = replace(fit_flow(FlowModel(fit.model.points, fixed)), stated=fit.stated)
    misfit = (other.modelled - fit.model.points.mass_flow_rate) / fit.sigma
    common = other.x[len(other.model.free) :]
    allowed = coverage_factor(_scatter_freedom(fit)) ** 2
    return other if float(misfit @ misfit + common @ common) - fit.chi_square <= allowed else None


def _scatter_freedom(fit: FlowFit) -> float:
    return math.inf if fit.scatter_is_known else float(max(fit.degrees_of_freedom, 1))


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
        error = math.sqrt(math.fsum(u * u for u in budget.values())) * scale if fit.gain[1][k] else math.inf
        half = _coverage(fit, budget)[1] * error
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
    if not half <= WEAK * size:
        return "not determined"
    return "determined" if half <= DETERMINED * size else "weak"


def choked_estimates(fit: FlowFit, choked: FlowFit) -> dict[str, Estimate]:
    """Estimates when all points may be choked: C with the range that an unknown b leaves, and b from below."""
    points = choked.model.points
    ratios = np.linspace(0.0, 0.99, 199)
    unit = mass_flow_rate(
        points.pressure_1,
        points.pressure_2,
        points.temperature_1,
        sonic_conductance=1.0,
        critical_ratio=ratios[:, None],
        subsonic_index=fit.values["subsonic_index"],
    )
    weighted, measured = unit / fit.sigma, points.mass_flow_rate / fit.sigma
    conductance = weighted @ measured / np.sum(weighted**2, axis=1)
    misfit = np.sum((conductance[:, None] * weighted - measured) ** 2, axis=1)
    possible = misfit - np.min(misfit) <= coverage_factor(_scatter_freedom(fit)) ** 2
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


def _budget(fit: FlowFit, k: int) -> dict[str, float]:
    """Standard uncertainty of number k by source, in its number of order one."""
    row, n = fit.gain[0][k], len(fit.model.points)
    variance = fit.sigma**2
    found = {
        f"scatter of {channel}": math.sqrt(float(np.sum(row[:n] ** 2 * part / variance)))
        for channel, part in fit.scatter.items()
    }
    return found | {effect.source: abs(float(u)) for effect, u in zip(fit.model.effects, row[n:], strict=True)}


def _coverage(fit: FlowFit, budget: Mapping[str, float]) -> tuple[float, float]:
    """Effective degrees of freedom and coverage factor."""
    scatter = math.hypot(*(u for source, u in budget.items() if source.startswith("scatter")))
    common = math.hypot(*(u for source, u in budget.items() if not source.startswith("scatter")))
    freedom = effective_degrees_of_freedom([(scatter, _scatter_freedom(fit)), (common, math.inf)])
    return freedom, coverage_factor(freedom)


def budgets(fit: FlowFit) -> dict[str, dict[str, Any]]:
    """Uncertainty budgets of the free numbers of the law."""
    rows = {}
    for k, name in enumerate(fit.model.free):
        budget, scale = _budget(fit, k), float(fit.model.scales[k])
        freedom, factor = _coverage(fit, budget)
        rows[name] = {
            "type_a": scale * math.hypot(*(u for source, u in budget.items() if source.startswith("scatter"))),
            "type_b": scale * math.hypot(*(u for source, u in budget.items() if not source.startswith("scatter"))),
            "degrees_of_freedom": freedom,
            "coverage_factor": factor,
            "sources": {source: scale * u for source, u in budget.items()},
        }
    return rows
