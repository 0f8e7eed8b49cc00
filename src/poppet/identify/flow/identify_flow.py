"""Identification of C, b, m and cracking pressure from a steady flow bench (ISO 6358-1)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import notes_of
from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.data_file import or_file
from poppet.identify.flow.flow_file import read_flow_file
from poppet.identify.flow.flow_findings import findings, influence_of, limit_verdicts, suspicions
from poppet.identify.flow.flow_fit import (
    UNITS,
    FlowFit,
    FlowModel,
    choked_estimates,
    find_other_law,
    fit_all_choked,
    fit_flow,
    law_estimates,
    widen_estimates,
)
from poppet.identify.flow.points import CHANNELS, FlowPoints, conductance_of, reject_rising_flow
from poppet.identify.flow.standard_formulas import Free, evaluate_by_standard, standard_uncertainties
from poppet.identify.gum import correlations, few_runs_probability
from poppet.identify.result import ResidualSummary, Result, Verdict, replace_uncertain_findings
from poppet.laws.iso6358.domain import DOMAINS, problem


@or_file(read_flow_file)
def identify_flow(
    points: FlowPoints | str | Path,
    *,
    subsonic_index: float | Free = 0.5,
    cracking_pressure: float | Free = 0.0,
    part: str = "",
    title: str = "flow bench",
    notes: tuple[str, ...] = (),
) -> Result:
    r"""Fit the flow-rate characteristics of a flow path to the points of a steady flow bench.

    .. math::

        \min_{C, b, m, \Delta p_c, \delta}
        \sum_i \frac{[q_m(p_{1,i}, p_{2,i}, T_{1,i}; \delta) - q_{m,i}]^2}{\sigma_i^2} + \sum_k \delta_k^2, \qquad
        \sigma_i^2 = u_q^2 + \sum_x \left(\frac{\partial q_m}{\partial x} u_x\right)^2

    Parameters
    ----------
    points : FlowPoints, str or Path
        Points of one flow path at one opening, or a flow bench file. Arguments override the options of the file.
    subsonic_index : float or "free", optional
        m; 0.5 is the ellipse of the 1989 edition.
    cracking_pressure : float or "free", optional
        Pressure drop below which the passage is closed [Pa].
    part : str, optional
        Name of the part in a circuit; the estimates are then called `part.sonic_conductance` and so on.
    title : str, optional
        Title of the result.
    notes : tuple of Note or str, optional
        Notes on the points; the findings include them.

    Returns
    -------
    Result
        Parameters from the direct fit: `sonic_conductance` [m^3/(s Pa)], `critical_ratio` and, if free,
        `subsonic_index` and `cracking_pressure` [Pa]. `comparison` has the results of the standard's formulas, the
        uncertainty budget, tests of the residuals and the influence of each point.

    Raises
    ------
    InputError
        Too few points, or flow that rises with p2/p1.

    Notes
    -----
    Common errors (calibration, offset: delta above, in standard deviations) are free parameters with their stated
    standard deviation; the intervals therefore contain them. If the scatter is not stated, the residuals give it, and
    the intervals use Student's t. A stated scatter can be too small: the intervals use its upper limit according to the
    residuals, and a finding reports a scatter that is certainly too small. Choked points do not determine b: its value
    is then NaN, and `low` is the limit below which the data exclude it.

    The law is valid for steady flow of an ideal gas through a flow path that does not change, not for regulators.

    References
    ----------
    ISO 6358-1:2013; JCGM 100:2008 (GUM). Effective variances: Orear 1982, Least squares when both variables have
    uncertainties, American Journal of Physics 50, 912-916.

    Examples
    --------
    >>> import numpy as np
    >>> from poppet.identify.flow.points import Instrument
    >>> from poppet.laws.iso6358 import mass_flow_rate
    >>> p_2 = np.linspace(0.5e5, 6.5e5, 13)
    >>> q = mass_flow_rate(7e5, p_2, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    >>> scale, sensor = Instrument(relative=0.003, calibration=0.005), Instrument(offset=500.0)
    >>> points = FlowPoints(q, 7e5, p_2, 293.15, scale, sensor, sensor, is_absolute=True)
    >>> result = identify_flow(points)
    >>> found = result.parameters
    >>> round(found["sonic_conductance"].value * 1e8, 4), round(found["critical_ratio"].value, 4)
    (2.0, 0.3)
    >>> found["critical_ratio"].verdict
    'determined'
    """
    assert isinstance(points, FlowPoints)  # `or_file` has read a file
    law = {"subsonic_index": subsonic_index, "cracking_pressure": cracking_pressure}
    with ErrorCollector() as errors:
        for name, value in law.items():
            if isinstance(value, str) and value != "free":
                errors.add("flow.number_or_free", name, value=value)
            elif value != "free" and (range_error := problem(name, float(value), DOMAINS[name])):
                errors.extend([range_error])
    fixed = {name: float(value) for name, value in law.items() if value != "free"}
    model = FlowModel(points, fixed)
    count, free = len(points), len(model.free)
    if count <= free:
        raise InputError("flow.too_few_points", count=count, free=free, names=[*model.free], least=free + 1)
    reject_rising_flow(points)
    fit = fit_flow(model)
    choked = fit_all_choked(fit)
    estimates = choked_estimates(fit, choked) if choked else law_estimates(fit)
    accepted = choked or fit
    influence = influence_of(accepted)
    order = np.argsort(points.pressure_ratio, kind="stable")
    tests: dict[str, Any] = {
        "chi_square": accepted.chi_square if math.isnan(accepted.stated_chi_square) else accepted.stated_chi_square,
        "degrees_of_freedom": accepted.degrees_of_freedom,
        "chi_square_probability": accepted.stated_probability,
        "scatter_factor": accepted.inflation * accepted.scatter_factor,
        "scatter_from_residuals": not accepted.scatter_is_known,
        "runs_probability": few_runs_probability(accepted.residuals[:count][order]),
        "aicc": accepted.aicc,
    }
    alternative = None if choked else find_other_law(fit)
    if alternative:
        name, better = alternative
        other_estimates = law_estimates(better)
        estimates = widen_estimates(estimates, other_estimates)
        row = {key: {"value": e.value, "low": e.low, "high": e.high} for key, e in other_estimates.items()}
        tests["alternatives"] = {name: {"aicc_difference": better.aicc - fit.aicc, "free": row}}
    doubts = tuple(suspicions(fit, estimates, tests, alternative))
    remarks = replace_uncertain_findings(
        [*doubts, *findings(accepted, estimates, tests, influence, choked is not None, alternative)], estimates
    )
    if doubts:  # independent of the width of the intervals
        weaker: dict[Verdict, Verdict] = {"determined": "weak"}
        estimates = {name: replace(e, verdict=weaker.get(e.verdict, e.verdict)) for name, e in estimates.items()}
    estimates = limit_verdicts(estimates, remarks)
    evaluation = evaluate_by_standard(points, subsonic_index, cracking_pressure)
    errors_by_standard = standard_uncertainties(points, evaluation, subsonic_index, cracking_pressure)
    is_bound = fit.values["critical_ratio"] < float(np.min(points.pressure_ratio))
    standard: dict[str, Any] = {"note": "No point is saturated: C is a lower and b an upper bound." if is_bound else ""}
    for name, error in zip(UNITS, errors_by_standard.tolist(), strict=True):
        standard |= {name: getattr(evaluation, name), f"u_{name}": error}
    standard |= {"saturated_points": [*evaluation.saturated], "subsonic_points": [*evaluation.subsonic]}
    prefix, rows = f"{part}." if part else "", accepted.gain[0][: len(accepted.model.free)]
    order = np.argsort(points.pressure_ratio, kind="stable")
    modelled = conductance_of(accepted.modelled, points.pressure_1, points.temperature_1)
    return Result(
        method="flow",
        title=title,
        parameters={f"{prefix}{name}": estimate for name, estimate in estimates.items()},
        residuals={"points.mass_flow_rate": ResidualSummary.of(accepted.modelled, points.mass_flow_rate, "kg/s")},
        correlation=correlations([f"{prefix}{name}" for name in accepted.model.free], rows @ rows.T),
        comparison=tests
        | {
            "standard_formulas": standard,
            "uncertainty": {f"{prefix}{name}": row for name, row in accepted.budgets.items()},
            "common_errors": {effect.source: size for size, effect in accepted.model.common_errors(accepted.x)},
            "influence": influence,
        },
        remarks=remarks + notes_of(notes),
        conditions=_conditions(accepted, fixed),
        series={
            "points.effective_conductance": {
                "x": points.pressure_ratio[order],
                "measured": points.effective_conductance[order],
                "model": modelled[order],
                "unit": "m^3/(s Pa)",
                "x_unit": "1",
                "x_name": "p2/p1",
            }
        },
    )


def _conditions(fit: FlowFit, fixed: Mapping[str, float]) -> dict[str, Any]:
    points = fit.model.points
    stated = {c: {k: v for k, v in vars(points.instrument(c)).items() if v} for c in CHANNELS}
    return {
        "samples": len(points),
        "fixed": dict(fixed),
        **{
            name: [float(np.min(getattr(points, name))), float(np.max(getattr(points, name)))]
            for name in ("pressure_ratio", "pressure_1", "temperature_1")
        },
        "standard_uncertainties": {channel: row for channel, row in stated.items() if row},
    }
