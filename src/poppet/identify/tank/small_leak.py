"""Effect of a small leak on a tank test that takes the tank as tight.

A leak from the tank shares the flow with the valve. In a discharge without a rest, its conductance adds to C. The data
cannot distinguish them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.search import FitObjective, Optimum
from poppet.identify.fit.statistics import influences, verdict
from poppet.identify.free_parameter import NormalPrior
from poppet.identify.gum import coverage_factor
from poppet.identify.result import VERDICTS, Result
from poppet.identify.tank.tank_plan import TankRun, plan_tank_fit
from poppet.identify.tank.test import TankTest

LEAK = 0.015
"""Assumed standard uncertainty of the conductance of a leak, as a fraction of C. A leak cannot be negative: 95 % of such
leaks are below 3 % of C."""
LEAK_ADDRESS = "leak.sonic_conductance"
NEGLIGIBLE = 0.05
"""Effect of the leak, as a fraction of the half width of an interval, that is not reported."""


def widen_for_leak(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> Result:
    """Extend the intervals of a result by the effect of a small leak that the data do not exclude.

    The effect is linear, with a normal prior of the leak. Each interval grows only on the side of a positive leak.
    """
    number = f"{test.part}.sonic_conductance"
    if test.leak_conductance not in (None, 0.0) or result.interrupted or number not in result.parameters:
        return result
    effects = leak_effects(test, runs, plan, result, number)
    parameters, factor = dict(result.parameters), coverage_factor(np.inf)
    for f in plan.free:
        shift, error = effects.get(f.name, (0.0, 0.0))
        e = parameters[f.name]
        below, above = e.value - e.low, e.high - e.value
        if not np.isfinite([shift, error, below, above]).all() or e.verdict == "at bound":
            continue
        # `error` has the sign of the change that a positive leak causes.
        reach = shift + float(np.sign(error)) * float(np.hypot(below if error < 0.0 else above, factor * error))
        low, high = min(e.low, max(f.low, e.value + reach)), max(e.high, min(f.high, e.value + reach))
        half = max(e.value - low, high - e.value)
        joint = max(verdict(f, e.value, half), e.verdict, key=VERDICTS.index)
        total = float(np.sqrt(e.standard_error**2 + shift**2 + error**2))
        parameters[f.name] = replace(e, low=low, high=high, standard_error=total, verdict=joint)
    before, after = result.parameters[number], parameters[number]
    if after.high - after.low <= (1.0 + NEGLIGIBLE) * (before.high - before.low):
        return replace(result, parameters=parameters)
    facts: dict[str, Any] = {"leak": 100.0 * LEAK, "low": after.low, "high": after.high, "unit": after.unit}
    facts |= {"before_low": before.low, "before_high": before.high}
    return replace(result, parameters=parameters, remarks=(*result.remarks, Note("finding.leak", number, **facts)))


def leak_effects(
    test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result, number: str
) -> dict[str, tuple[float, float]]:
    """Return the change and the signed standard uncertainty of each parameter that a leak causes.

    The leak is the most probable one of the data and its prior, and at least 0.
    """
    leaky = plan_tank_fit(replace(test, leak_conductance="free"), runs)
    sd = LEAK * result.parameters[number].value
    before = {f.name: f for f in plan.free}
    free = tuple(
        replace(before.get(f.name, f), prior=NormalPrior(0.0, sd) if f.address == LEAK_ADDRESS else f.prior)
        for f in leaky.free
    )
    x = np.array([result.parameters[f.name].value if f.name in before else 0.0 for f in free])
    sigmas = [float(result.conditions["noise"][fitted.name]) for fitted in channels_of(plan.experiments)]
    residual, jacobian = FitObjective(leaky.experiments, free, sigmas).residual_and_jacobian(x)
    index = [f.address for f in free].index(LEAK_ADDRESS)
    active = np.array(
        [int(f.name in before and result.parameters[f.name].verdict == "at bound") for f in free], dtype=np.int64
    )
    # Scales: the influence of a parameter with the value 0 is absolute.
    rows = influences(Optimum(np.where(np.arange(x.size) == index, sd, x), 0.0, jacobian, residual, sigmas, active))
    if not np.isfinite(rows[index]).all():
        return {}
    shift = -float(rows[index] @ residual)
    error = float(np.linalg.norm(rows[index]))
    # With a fixed leak, the other parameters follow it along the least-squares solution.
    others = [k for k in range(x.size) if k != index and active[k] == 0 and np.isfinite(rows[k]).all()]
    scales = np.where(x == 0.0, 1.0, np.abs(x))[others]
    slopes = -np.linalg.lstsq(jacobian[:, others] * scales, jacobian[:, index], rcond=1e-9)[0] * scales
    size = max(0.0, shift)
    return {free[k].name: (size * slope, error * slope) for k, slope in zip(others, slopes, strict=True)}
