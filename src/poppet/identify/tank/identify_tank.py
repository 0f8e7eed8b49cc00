"""`identify tank`: charge and discharge tests of ISO 6358-2, without writing a circuit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from poppet.core.toml_file import TomlFile
from poppet.identify.fit.identify_fit import Progress, run_fit
from poppet.identify.fit.intervals import Stages
from poppet.identify.result import Result
from poppet.identify.tank.caps import doubted
from poppet.identify.tank.laws import compared_laws
from poppet.identify.tank.tank_ambient import allowing_for_room
from poppet.identify.tank.tank_plan import tank_plan, tank_runs
from poppet.identify.tank.test import TankTest, test_of


def identify_tank(
    test: TankTest | str | Path,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
    contour: bool = False,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Find C, b and what else is free from charge and discharge tests.

    Parameters
    ----------
    test : TankTest, str or Path
        The test, or its file.
    profile : sequence of str, optional
        Free numbers whose interval is to be found by profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    contour : bool, optional
        Whether the misfit is wanted over conductance and wall heat: `contour` of the series, and findings.
    progress : callable, optional
        Called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Called with what follows the fit (profiles, bootstrap), how much of it is done, and of how much.

    Returns
    -------
    Result
        Estimates under `valve.sonic_conductance`, `valve.critical_ratio`, `tank.wall_conductance` ...; nuisance
        numbers of a recording under its name: `first.valve.delay`, `first.tank.pressure.offset`.

    Raises
    ------
    InputErrors
        If the test cannot be read, or a recording does not fit its direction: a pressure that rises in a discharge,
        one that hardly changes, one above its supply.

    Notes
    -----
    The integrated equations are fitted; no pressure is differentiated.

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
        runs = tank_runs(test)
        plan = tank_plan(test, runs)
    else:
        file = TomlFile.read(test, "recordings")
        with file.errors():
            test = test_of(file)
            runs = tank_runs(test)
            plan = tank_plan(test, runs)
    result = run_fit(plan, profile=profile, repeats=repeats, contour=contour, progress=progress, stages=stages)
    result = doubted(test, runs, plan, replace(result, method="tank"))
    if test.compare and not result.conditions["interrupted"]:
        result = compared_laws(test, runs, plan, result)
    return allowing_for_room(test, runs, result)
