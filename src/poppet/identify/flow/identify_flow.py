"""Steady flow bench of ISO 6358-1: C, b, m and cracking pressure with their uncertainty and a verdict."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import notes_of
from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.file_argument import or_file
from poppet.identify.flow.flow_file import read_flow_file
from poppet.identify.flow.flow_findings import findings, suspicions
from poppet.identify.flow.flow_fit import (
    UNITS,
    FlowFit,
    FlowModel,
    all_choked,
    budgets,
    choked_estimates,
    fit_flow,
    law_estimates,
    other_law,
    united,
)
from poppet.identify.flow.points import CHANNELS, FlowPoints, conductance_of, refuse_rising_flow
from poppet.identify.flow.standard_formulas import Free, evaluate_by_standard, standard_uncertainties
from poppet.identify.gum import (
    chi_square_probability,
    correlations,
    few_runs_probability,
    leave_one_out,
)
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
    r"""Flow-rate characteristics of a passage from the points of a steady flow bench.

    .. math::

        \min_{C, b, m, \Delta p_c, \delta}
        \sum_i \frac{[q_m(p_{1,i}, p_{2,i}, T_{1,i}; \delta) - q_{m,i}]^2}{\sigma_i^2} + \sum_k \delta_k^2, \qquad
        \sigma_i^2 = u_q^2 + \sum_x \left(\frac{\partial q_m}{\partial x} u_x\right)^2

    Parameters
    ----------
    points : FlowPoints, str or Path
        Of one passage at one opening, with the uncertainties of the instruments; or a flow bench file, whose options
        hold where no other is given here.
    subsonic_index : float or "free", optional
        m; 0.5 is the ellipse of the 1989 edition.
    cracking_pressure : float or "free", optional
        Pressure drop below which the passage is closed [Pa].
    part : str, optional
        Name of the part in a circuit; the estimates are then called `part.sonic_conductance` and so on.
    title : str, optional
        For people.
    notes : tuple of Note or str, optional
        What is known about the points already; added to the findings.

    Returns
    -------
    Result
        Parameters from the direct fit: `sonic_conductance` [m^3/(s Pa)], `critical_ratio` and, where free,
        `subsonic_index` and `cracking_pressure` [Pa]; the standard's formulas, the uncertainty budget, tests on
        the residuals and the influence of every point under `comparison`.

    Raises
    ------
    InputError
        Too few points, or flow that rises with p2/p1.

    Notes
    -----
    Errors common to all points (calibration, offset: the delta above, in standard deviations) are fitted along
    with their stated spread, so the intervals contain them. Scatter that is not stated is estimated from the
    residuals and widens the intervals by Student's t; scatter stated too small is enlarged and said so. Choked
    data do not determine b: its value is then not-a-number and `low` what the data exclude.

    Steady flow of an ideal gas through a passage that does not change: no regulators.

    References
    ----------
    ISO 6358-1:2013; JCGM 100:2008 (GUM). Effective variances: Orear 1982, Least squares when both variables have
    uncertainties, American Journal of Physics 50, 912-916.

    Examples
    --------
    >>> import numpy as np
    >>> from poppet.laws.iso6358 import mass_flow_rate
    >>> p_2 = np.linspace(0.5e5, 6.5e5, 13)
    >>> q = mass_flow_rate(7e5, p_2, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    >>> result = identify_flow(FlowPoints(q, 7e5, p_2, 293.15))
    >>> found = result.parameters
    >>> round(found["sonic_conductance"].value * 1e8, 4), round(found["critical_ratio"].value, 4)
    (2.0, 0.3)
    >>> found["critical_ratio"].verdict
    'determined'
    """
    assert isinstance(points, FlowPoints)  # a file was read at the door
    given = {"subsonic_index": subsonic_index, "cracking_pressure": cracking_pressure}
    fixed = _fixed(given)
    model = FlowModel(points, fixed)
    count, free = len(points), len(model.free)
    if count <= free:
        raise InputError("flow.too_few_points", count=count, free=free, names=[*model.free], least=free + 1)
    refuse_rising_flow(points)
    fit = fit_flow(model)
    choked = all_choked(fit)
    estimates = choked_estimates(fit, choked) if choked else law_estimates(fit)
    used = choked or fit
    other = None if choked else other_law(fit)
    if other:
        estimates = united(estimates, law_estimates(other[1]))
    tests, influence = _tests(used), _influence(used)
    doubts = suspicions(fit, estimates, tests, other)
    found = doubts + findings(used, estimates, tests, influence, choked is not None)
    remarks = replace_uncertain_findings(found, estimates) + notes_of(notes)
    if doubts:  # however narrow the intervals are
        weaker: dict[Verdict, Verdict] = {"determined": "weak"}
        estimates = {name: replace(e, verdict=weaker.get(e.verdict, e.verdict)) for name, e in estimates.items()}
    prefix, rows = f"{part}." if part else "", used.gain[0][: len(used.model.free)]
    return Result(
        method="flow",
        title=title,
        parameters={f"{prefix}{name}": estimate for name, estimate in estimates.items()},
        residuals={"points.mass_flow_rate": ResidualSummary.of(used.modelled, points.mass_flow_rate, "kg/s")},
        correlation=correlations([f"{prefix}{name}" for name in used.model.free], rows @ rows.T),
        comparison=tests
        | ({"alternatives": _alternative(fit, *other)} if other else {})
        | {
            "standard_formulas": _by_standard(fit, subsonic_index, cracking_pressure),
            "uncertainty": {f"{prefix}{name}": row for name, row in budgets(used).items()},
            "common_errors": {effect.source: size for size, effect in used.model.common_errors(used.x)},
            "influence": influence,
        },
        remarks=remarks,
        conditions=_conditions(used, fixed),
        series=_series(used),
    )


def _fixed(given: Mapping[str, float | Free]) -> dict[str, float]:
    fixed = {}
    with ErrorCollector() as errors:
        for name, value in given.items():
            if not isinstance(value, str):
                fixed[name] = float(value)
                outside = problem(name, float(value), DOMAINS[name])
                errors.extend([outside] if outside else [])
            elif value != "free":
                errors.add("flow.number_or_free", name, value=value)
    return fixed


def _tests(fit: FlowFit) -> dict[str, Any]:
    """Chi-square, runs and information criterion of the residuals."""
    n = len(fit.model.points)
    order = np.argsort(fit.model.points.pressure_ratio, kind="stable")
    return {
        "chi_square": fit.chi_square,
        "degrees_of_freedom": fit.degrees_of_freedom,
        "chi_square_probability": (
            chi_square_probability(fit.chi_square, fit.degrees_of_freedom) if fit.scatter_is_known else fit.stated
        ),
        "scatter_factor": fit.inflation,
        "scatter_from_residuals": not fit.scatter_is_known,
        "runs_probability": few_runs_probability(fit.residuals[:n][order]),
        "aicc": fit.aicc,
    }


def _alternative(fit: FlowFit, name: str, other: FlowFit) -> dict[str, Any]:
    """The law that explains the points better, as `identify tank` writes it."""
    row = {key: {"value": e.value, "low": e.low, "high": e.high} for key, e in law_estimates(other).items()}
    return {name: {"aicc_difference": other.aicc - fit.aicc, "free": row}}


def _influence(fit: FlowFit) -> dict[str, list[float]]:
    """Shift of each number when a point is left out, in its standard errors, by point."""
    shifts = leave_one_out(fit.jacobian, fit.residuals, fit.gain[0])[:, : len(fit.model.points)]
    shifts /= np.maximum(np.linalg.norm(fit.gain[0], axis=1), 1e-300)[:, None]
    # Common errors stand behind the free numbers, and are of no interest here.
    return {name: row.tolist() for name, row in zip(fit.model.free, shifts, strict=False)}


def _by_standard(fit: FlowFit, subsonic_index: float | Free, cracking_pressure: float | Free) -> dict[str, Any]:
    points = fit.model.points
    found = evaluate_by_standard(points, subsonic_index, cracking_pressure)
    errors = standard_uncertainties(points, found, subsonic_index, cracking_pressure)
    doubtful = fit.values["critical_ratio"] < float(np.min(points.pressure_ratio))
    row: dict[str, Any] = {"note": "No point is saturated: C is a lower and b an upper bound." if doubtful else ""}
    for name, error in zip(UNITS, errors, strict=True):
        row |= {name: getattr(found, name), f"u_{name}": float(error)}
    return row | {"saturated_points": list(found.saturated), "subsonic_points": list(found.subsonic)}


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


def _series(fit: FlowFit) -> dict[str, Any]:
    """Measured and modelled effective conductance over the pressure ratio."""
    points = fit.model.points
    order = np.argsort(points.pressure_ratio, kind="stable")
    modelled = conductance_of(fit.modelled, points.pressure_1, points.temperature_1)
    return {
        "points.effective_conductance": {
            "x": points.pressure_ratio[order],
            "measured": points.effective_conductance[order],
            "model": modelled[order],
            "unit": "m^3/(s Pa)",
            "x_unit": "1",
            "x_name": "p2/p1",
        }
    }
