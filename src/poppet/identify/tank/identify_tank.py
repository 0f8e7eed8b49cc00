"""Method `identify tank`: charge and discharge tests according to ISO 6358-2."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from poppet.core.codes import Note
from poppet.core.toml_file import TomlFile
from poppet.identify.fit.identify_fit import Progress, identify_fit
from poppet.identify.fit.intervals import Stages
from poppet.identify.gum import SPREAD, widened
from poppet.identify.result import Result
from poppet.identify.tank.alternatives import compare_laws
from poppet.identify.tank.caps import apply_caps
from poppet.identify.tank.tank_plan import TankRun, plan_tank_fit, read_runs
from poppet.identify.tank.test import ROOM, TankTest, read_test

POWERS = {"sonic_conductance": 0.5, "wall_conductance": 1.0, "wall_heat_capacity": 1.0}
"""Exponents of the temperature: with all temperatures times r, C / r^0.5 and h A / r give the same pressures."""


def identify_tank(
    test: TankTest | str | Path,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
    contour: bool = False,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Fit C, b and other free parameters to charge and discharge tests of a tank.

    Parameters
    ----------
    test : TankTest, str or Path
        Tank test, or its file.
    profile : sequence of str, optional
        Free parameters whose intervals are computed from the profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    contour : bool, optional
        If True, add the chi-square contour over conductance and wall conductance to the series, and its findings.
    progress : callable, optional
        Called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Called with the stage after the fit (profiles, contour, bootstrap), the completed steps and their total number.

    Returns
    -------
    Result
        Estimates by address, such as `valve.sonic_conductance`, `valve.critical_ratio`, `tank.wall_conductance`. The
        name of a nuisance parameter begins with its recording: `first.valve.delay`, `first.tank.pressure.offset`.

    Raises
    ------
    InputErrors
        If the test is invalid, or if a recording contradicts its direction. Examples are a pressure that rises in a
        discharge, that is almost constant, or that exceeds the supply pressure.

    Notes
    -----
    The fit integrates the equations; it does not differentiate the recorded pressure.

    Examples
    --------
    >>> import numpy as np
    >>> from poppet import Chamber, Circuit, Orifice
    >>> tank = Chamber(volume="20 l", initial_pressure="7 bar", wall_conductance=5.0)
    >>> valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> truth = Circuit({"tank": tank, "valve": valve}).simulate("40 s", "0.1 s")
    >>> pressure = truth["tank.pressure"] + np.random.default_rng(1).normal(0.0, 500.0, truth.time.size)
    >>> test = TankTest(recordings={"a": {"time": truth.time, "tank.pressure": pressure}}, volume="20 l")
    >>> found = identify_tank(test).parameters["valve.sonic_conductance"]
    >>> found.verdict, bool(abs(found.value / 1e-8 - 1.0) < 0.005)
    ('determined', True)
    """
    if isinstance(test, TankTest):
        runs = read_runs(test)
        plan = plan_tank_fit(test, runs)
    else:
        file = TomlFile.read(test, "recordings")
        with file.errors():
            test = read_test(file)
            runs = read_runs(test)
            plan = plan_tank_fit(test, runs)
    result = identify_fit(plan, profile=profile, repeats=repeats, contour=contour, progress=progress, stages=stages)
    result = apply_caps(test, runs, plan, replace(result, method="tank"))
    if test.compare and not result.conditions["interrupted"]:
        result = compare_laws(test, runs, plan, result)
    return widen_for_ambient(test, runs, result)


def widen_for_ambient(test: TankTest, runs: Sequence[TankRun], result: Result) -> Result:
    """Widen the intervals of a result if the ambient temperature is unknown."""

    # The temperature of the flowing gas is that of the supply or that in the tank.
    is_known = all(
        run.supply_temperature is not None
        if run.direction == "charge"
        else test.initial_temperature is not None or run.has_temperature
        for run in runs
    )
    if test.ambient_temperature is not None or is_known:
        return result
    wider = {
        name: widened(estimate, POWERS[field] * SPREAD / ROOM)
        for name, estimate in result.parameters.items()
        if (field := name.rpartition(".")[2]) in POWERS and estimate.verdict in ("determined", "weak")
    }
    number = f"{test.part}.sonic_conductance"
    if number not in wider:
        return result
    facts = {"celsius": ROOM - 273.15, "percent": 50.0 / ROOM, "spread": SPREAD, "names": tuple(wider)}
    note = Note("finding.room", number, **facts)
    return replace(result, parameters={**result.parameters, **wider}, remarks=(note, *result.remarks))
