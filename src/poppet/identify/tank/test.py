"""Description of a tank test, in Python or in a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import quantity

DIRECTIONS = ("discharge", "charge")
THERMAL = ("energy", "isothermal", "polytropic")
COMPARED = (*THERMAL, "adiabatic")
"""Laws that may be compared; adiabatic is the energy balance without wall heat."""
ROOM = 293.15
"""Temperature of a room of which nothing is said [K]."""
_RECORDINGS = Field(
    type="table",
    is_required=True,
    meaning="list of recordings",
    example="[recordings.NAME] with file, time and tank.pressure",
)


@dataclass(frozen=True, kw_only=True)
class TankTest:
    r"""Charge and discharge tests of one component with a tank.

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
    wall_heat_capacity : number
        Of the tank's wall, which warms and cools by the heat that it takes and gives [J/K]; default: it keeps its
        temperature.
    ambient_pressure : number
        Absolute; what gauge values refer to and a discharge ends at [Pa].
    ambient_temperature : number
        Around the tank [K]; default 20 degC, and intervals then allow for another one.
    valve_delay : number
        Time from `opens` until the component is open [s]; default 0, `free` for an unknown start time.
    leak_conductance : number
        Sonic conductance of a leak from the tank to the room [m^3/(s Pa)]; default 0.
    pressure_lag : number
        Time constant of a gauge whose channel does not state its own [s]; default 0.
    bore : number
        Diameter of the component's narrowest section, if it is known [m]: its conductance cannot exceed that of a
        nozzle of this bore.
    bore_uncertainty : number
        One sigma of it [m].
    pressure_offset : str
        `free` where the sensor's zero is not known: one for each recording; 0 where it is right. Left out, it is free
        where the valve closes within the recording, with a standard deviation of 1 % of the range, and where the
        pressure states its `offset`, with that one.
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
    compare : sequence of str
        Thermal laws under which the same recordings are fitted as well: `isothermal`, `adiabatic` (no wall heat),
        `energy`, `polytropic`.
    folder : str or Path
        What the files' paths refer to.

    Raises
    ------
    InputErrors
        With all mistakes.

    Notes
    -----
    A number is a value with its unit, which is kept; `free`; or a table `{ start, min, max, prior }`, which is free.
    What holds for the room and the bore are values.
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
    wall_heat_capacity: Any = None
    ambient_pressure: Any = "1 bar"
    ambient_temperature: Any = None
    valve_delay: Any = 0.0
    leak_conductance: Any = 0.0
    pressure_lag: Any = 0.0
    bore: Any = None
    bore_uncertainty: Any = 0.0
    pressure_offset: Any = None
    part: str = "valve"
    title: str = "Tank test"
    loss: str = "linear"
    starts: int = 1
    seed: int = 0
    compare: Sequence[str] = ()
    folder: str | Path = "."

    def __post_init__(self) -> None:
        with ErrorCollector() as errors:
            for name, valid in (("direction", DIRECTIONS), ("thermal", THERMAL)):
                argument = getattr(self, name)
                if argument not in valid:
                    errors.add(
                        "fields.not_an_option",
                        name,
                        value=argument,
                        meaning=name,
                        near=NameSuggestion(str(argument), valid),
                    )
            laws = tuple(self.compare) if isinstance(self.compare, list | tuple) else (self.compare,)
            object.__setattr__(self, "compare", laws)
            for name in laws:
                if name not in COMPARED:
                    errors.add(
                        "fields.not_an_option",
                        "compare",
                        value=name,
                        meaning="thermal law",
                        near=NameSuggestion(str(name), COMPARED),
                    )
            if self.pressure_offset not in ("free", 0.0, None):
                errors.add("tank.offset", "pressure_offset", value=self.pressure_offset)
            for name in ("bore", "bore_uncertainty"):
                with errors.collecting():
                    quantity(getattr(self, name) or 0.0, "m", name=name)
            if not isinstance(self.recordings, Mapping) or not self.recordings:
                errors.extend([missing_field("recordings", _RECORDINGS)])
            if self.part in ("tank", "supply", "leak") or not self.part.isidentifier():
                errors.add("tank.part", "part", value=self.part)

    @property
    def room(self) -> Any:
        """Ambient temperature, or 20 degC if it is not stated."""
        return ROOM if self.ambient_temperature is None else self.ambient_temperature


FILE_FIELDS = {f.name: Field() for f in fields(TankTest) if f.name != "folder"} | {
    "volume": Field(is_required=True, meaning="volume of the tank", example='volume = "16.2 l"'),
    "recordings": _RECORDINGS,
}
"""Fields of a tank test file."""


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
    file = TomlFile.read(path, "recordings")
    with file.errors():
        return read_test(file)


def read_test(file: TomlFile) -> TankTest:
    """Return the test of a file."""
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, FILE_FIELDS, table="tank test file")
    title = str(data.get("title", Path(file.name).stem))
    return TankTest(**{**data, "title": title}, folder=file.folder)
