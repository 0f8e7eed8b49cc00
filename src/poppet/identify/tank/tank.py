"""`identify tank`: charge and discharge tests of ISO 6358-2, without writing a circuit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from poppet.ground.errors import InputError, collect, suggestion
from poppet.identify.fit.file import read_located
from poppet.identify.fit.intervals import Stages
from poppet.identify.fit.run import Progress, fit_plan
from poppet.identify.result import Result
from poppet.identify.tank.plan import DIRECTIONS, THERMAL, tank_plan


@dataclass(frozen=True, kw_only=True)
class TankTest:
    r"""Charge and discharge tests of one component: a tank of known volume that fills or empties through it.

    .. math:: \frac{V \dot p}{\kappa - 1} = \pm c_p T_1 q_m(C, b, m) + h A (T_w - T)

    Parameters
    ----------
    recordings : mapping
        Name to recording: a table as in a fit file (`file`, `time`, `"tank.pressure"`, `"tank.temperature"`, `skip`,
        `until`, `inputs`, `start` ...), or one with arrays in SI units: `time` [s], `"tank.pressure"` [Pa],
        `"tank.temperature"` [K], each (n,). It may name its own `direction`, `volume`, `supply_pressure`,
        `supply_temperature`, `opens`, `closes` and `use = "validation"`.
    volume : number
        Of the tank with its lines [m^3].
    direction : str
        `discharge` to the ambient air or `charge` from a supply.
    thermal : str
        `energy` (default: wall heat is fitted as well), `isothermal` or `polytropic`.
    sonic_conductance : number
        C [m^3/(s Pa)]; free unless given.
    critical_ratio : number
        b; free unless given.
    subsonic_index : number
        m; default 0.5.
    wall_conductance : number
        h A, with `energy` [W/K]; free unless given. One for all recordings of the same direction and volume, else one
        for each.
    polytropic_exponent : number
        n, with `polytropic`; free unless given.
    supply_pressure : number
        Absolute pressure of the supply of a charge [Pa].
    supply_temperature : number
        Its temperature [K]; default the ambient one.
    initial_temperature : number
        Of the gas in the tank [K]; default the first sample of a recorded temperature, else the ambient one.
    wall_temperature : number
        Of the tank's wall [K]; default the ambient one.
    ambient_pressure : number
        Absolute; what gauge values refer to and a discharge ends at [Pa].
    ambient_temperature : number
        Around the tank [K].
    valve_delay : number
        Time from `opens` until the component is open [s]; default 0, `free` for an unknown start time.
    pressure_offset : str
        `free` where the sensor's zero is not known: one for each recording; default 0.
    part : str
        What the component is called in the result: `valve`.
    title : str
        For people.
    loss : str
        `linear`, or a robust one.
    starts : int
        Places to begin the search at.
    seed : int
        Of the other places.
    folder : str or Path
        What the files' paths refer to.

    Raises
    ------
    InputErrors
        With all mistakes.

    Notes
    -----
    A number is a value with its unit, which is kept; `free`; or a table `{ start, min, max, prior }`, which is free.
    The initial pressure is free unless `start` says otherwise. The component is open from the first used sample on;
    `opens` and `closes` [s] are the times of the command, `"tank.temperature"` may have `lag = "free"`. Not for
    components with internal feedback (regulators) or a cracking pressure, as ISO 6358-2 says.

    References
    ----------
    ISO 6358-2:2013, clauses 5 and 6 (discharge and charge tests).
    """

    recordings: Mapping[str, Any]
    volume: Any
    direction: str = "discharge"
    thermal: str = "energy"
    sonic_conductance: Any = "free"
    critical_ratio: Any = "free"
    subsonic_index: Any = 0.5
    wall_conductance: Any = "free"
    polytropic_exponent: Any = "free"
    supply_pressure: Any = None
    supply_temperature: Any = None
    initial_temperature: Any = None
    wall_temperature: Any = None
    ambient_pressure: Any = "1 bar"
    ambient_temperature: Any = "20 degC"
    valve_delay: Any = 0.0
    pressure_offset: Any = 0.0
    part: str = "valve"
    title: str = "Tank test"
    loss: str = "linear"
    starts: int = 1
    seed: int = 0
    folder: str | Path = "."

    def __post_init__(self) -> None:
        problems = [
            InputError(f"{name} = {given!r}", "is unknown.", suggestion(str(given), known), address=name)
            for name, given, known in (
                ("direction", self.direction, DIRECTIONS),
                ("thermal", self.thermal, THERMAL),
            )
            if given not in known
        ]
        if self.pressure_offset not in ("free", 0.0):
            cure = 'Write "free", or subtract it from the recording.'
            given = f"pressure_offset = {self.pressure_offset!r}"
            problems.append(InputError(given, "is neither 0 nor free.", cure, address="pressure_offset"))
        if not isinstance(self.recordings, Mapping) or not self.recordings:
            cure = "Write [recordings.NAME] with file, time and tank.pressure."
            problems.append(InputError("recordings", "are missing.", cure, address="recordings"))
        if self.part == "tank" or not self.part.isidentifier():
            cure = 'Choose a word such as "valve".'
            problems.append(InputError(f"part = {self.part!r}", "is no name for the component.", cure, address="part"))
        collect(problems)


def read_tank_file(path: str | Path) -> TankTest:
    """Read a tank test file.

    Parameters
    ----------
    path : str or Path
        A TOML file as in the example; its keys are the parameters of `TankTest`.

    Returns
    -------
    TankTest
        Not yet fitted; the recordings are read by `identify_tank`.

    Raises
    ------
    InputErrors
        With all mistakes, each with its line where it can be told.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... direction = "discharge"
    ... volume = "16.2 l"                      # "free" or { start = "16 l" } where it is not known
    ... ambient_pressure = "1.013 bar"
    ... initial_temperature = "25 degC"
    ... [recordings.first]
    ... file = "pressure.csv"
    ... time = { column = "t", unit = "s" }
    ... "tank.pressure" = { column = "p", unit = "bar g" }
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = (Path(folder) / "tank.toml").write_text(text)
    ...     test = read_tank_file(Path(folder) / "tank.toml")
    >>> test.volume, list(test.recordings)
    ('16.2 l', ['first'])
    """
    path = Path(path)
    return read_located(path, lambda data: _test(data, path))


def _test(data: Mapping[str, Any], path: Path) -> TankTest:
    known = [f.name for f in fields(TankTest) if f.name != "folder"]
    problems = [
        InputError(key, "is not a part of a tank test file.", suggestion(key, known), address=key)
        for key in data
        if key not in known
    ]
    problems += [
        InputError(f"{key} is missing:", f"a tank test needs {what}.", cure, address=key)
        for key, what, cure in (
            ("volume", "the tank's volume, or a place to begin", 'Write volume = "16.2 l".'),
            ("recordings", "data", "Write [recordings.NAME] with file, time and tank.pressure."),
        )
        if key not in data
    ]
    collect(problems)
    return TankTest(**{"title": path.stem, **data}, folder=path.parent)


def identify_tank(
    test: TankTest | str | Path,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
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
        plan = tank_plan(test)
    else:
        path = Path(test)
        plan = read_located(path, lambda data: tank_plan(_test(data, path)))
    result = fit_plan(plan, profile=profile, repeats=repeats, progress=progress, stages=stages)
    return replace(result, method="tank")
