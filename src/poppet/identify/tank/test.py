"""Description of a tank test, as Python arguments or as a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import quantity
from poppet.parts.fields import NumberLike

DIRECTIONS = ("discharge", "charge")
THERMAL = ("energy", "isothermal", "polytropic")
COMPARED = (*THERMAL, "adiabatic")
"""Thermal laws for a comparison; adiabatic is the energy balance without wall heat."""
ROOM = 293.15
"""Default ambient temperature [K]."""
_RECORDINGS = Field(
    type="table",
    is_required=True,
    meaning="list of recordings",
    example="[recordings.NAME] with file, time and tank.pressure",
)


@dataclass(frozen=True, kw_only=True)
class TankTest:
    r"""Description of charge and discharge tests of one component with a tank.

    .. math:: \frac{V \dot p}{\kappa - 1} = \pm c_p T_1 q_m(C, b, m) + h A (T_w - T)

    Parameters
    ----------
    recordings : mapping
        Recordings by name. A recording is a table as in a fit file (`file`, `time`, `"tank.pressure"`,
        `"tank.temperature"`, `skip`, `until`, `inputs`, `start` ...), or a table of arrays in SI units, (n,) each:
        `time` [s], `"tank.pressure"` [Pa], `"tank.temperature"` [K]. It can also have `direction`, `volume`,
        `supply_pressure`, `supply_temperature`, `opens`, `closes` and `use = "validation"`.
    volume : number
        Volume of the tank with its lines [m^3].
    direction : str
        `discharge` to the ambient air or `charge` from a supply.
    thermal : str
        Thermal law: `energy` (default, with a fitted wall conductance), `isothermal` or `polytropic`.
    sonic_conductance : number
        Sonic conductance C [m^3/(s Pa)] (default: `free`).
    critical_ratio : number
        Critical back-pressure ratio b (default: `free`).
    subsonic_index : number
        Subsonic index m (default: 0.5).
    wall_conductance : number
        Wall conductance h A for `energy` [W/K] (default: `free`). If all recordings have the same direction and
        volume, they share one value. Otherwise, each recording has its own value.
    polytropic_exponent : number
        Exponent n for `polytropic` (default: `free`).
    supply_pressure : number
        Absolute supply pressure of a charge [Pa].
    supply_temperature : number
        Supply temperature of a charge [K] (default: ambient temperature).
    initial_temperature : number
        Initial gas temperature in the tank [K]. The default is the first sample of a recorded temperature, else the
        ambient temperature.
    wall_temperature : number
        Temperature of the tank wall [K] (default: ambient temperature).
    wall_heat_capacity : number
        Heat capacity of the tank wall [J/K]. By default the wall temperature is constant.
    ambient_pressure : number
        Absolute ambient pressure, the reference of gauge values and the outlet pressure of a discharge [Pa].
    ambient_temperature : number
        Ambient temperature [K]. The default is 20 degC with wider intervals for its uncertainty.
    valve_delay : number
        Time from `opens` until the component is open [s] (default: 0). It is `free` if the start time is unknown.
    leak_conductance : number
        Sonic conductance of a leak from the tank to the ambient [m^3/(s Pa)] (default: 0).
    pressure_lag : number
        Time constant of the pressure sensor [s] (default: 0). It applies to channels that state no time constant.
    bore : number
        Diameter of the narrowest section of the component, optional [m]. The conductance cannot exceed the conductance
        of a nozzle of this bore.
    bore_uncertainty : number
        Standard deviation of the bore [m].
    pressure_offset : str
        Offset of the pressure sensor: `free` (one for each recording) or 0. By default it is free in two cases: if the
        pressure states its `offset`, with that standard deviation, and if the valve closes within the recording, with
        a standard deviation of 1 % of the range.
    uncertainties : mapping or 0
        Standard uncertainties of the stated quantities, which the intervals include: `volume` and `supply_pressure`
        (a fraction such as "0.5 %", or a value), `leak` (fraction of C), `gauge_scale` (fraction of the gauge pressure)
        and `gauge_zero` [Pa]. A value of 0 takes a quantity as exact; `leak = 0` is a tight tank. Defaults, all
        assumed: 0.5 %, 0.3 %, 1.5 %, 0.3 %, and 0.06 % of the range of the recorded pressure. A stated leak has the
        default 0. With `uncertainties = 0`, the intervals include noise and lack of fit alone.
    part : str
        Name of the component in the result (default: `valve`).
    title : str
        Title of the result.
    loss : str
        Loss function: `linear` or a robust one.
    starts : int
        Number of start points of the search.
    seed : int
        Seed of the random start points.
    compare : sequence of str
        Thermal laws that are also fitted for comparison: `isothermal`, `adiabatic` (no wall heat), `energy`,
        `polytropic`.
    folder : str or Path
        Base folder of relative file paths.

    Raises
    ------
    InputErrors
        If a field is invalid. The exception contains all errors.

    Notes
    -----
    A number is a value with its unit, `free`, or a table `{ start, min, max, prior }` for a free parameter. The ambient
    conditions and the bore must be values. The initial pressure is free unless `start` sets it. The component is open
    from the first used sample. `opens` and `closes` [s] are the times of the command. `"tank.temperature"` can have
    `lag = "free"`. According to ISO 6358-2, the method is not applicable to components with internal feedback
    (regulators) or a cracking pressure.

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
    uncertainties: Any = None
    part: str = "valve"
    title: str = "Tank test"
    loss: str = "linear"
    starts: int = 1
    seed: int = 0
    compare: Sequence[str] = ()
    folder: str | Path = "."

    def __post_init__(self) -> None:
        with ErrorCollector() as errors:
            laws = tuple(self.compare) if isinstance(self.compare, list | tuple) else (self.compare,)
            object.__setattr__(self, "compare", laws)
            for name, meaning, argument, valid in (
                ("direction", "direction", self.direction, DIRECTIONS),
                ("thermal", "thermal", self.thermal, THERMAL),
                *(("compare", "thermal law", law, COMPARED) for law in laws),
            ):
                if argument not in valid:
                    near = NameSuggestion(str(argument), valid)
                    errors.add("fields.not_an_option", name, value=argument, meaning=meaning, suggestion=near)
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
    def effective_ambient_temperature(self) -> NumberLike:
        """Ambient temperature of the test.

        The value is 293.15 K if the test does not state it.
        """
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
        Tank test; `identify_tank` reads its recordings.

    Raises
    ------
    InputErrors
        If the file is invalid. The exception contains all errors, each with its line if available.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... direction = "discharge"
    ... volume = "16.2 l"                      # "free" or { start = "16 l" } if it is unknown
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
    """Return the tank test that the content of an input file describes."""
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, FILE_FIELDS, table="tank test file")
    title = str(data.get("title", Path(file.name).stem))
    return TankTest(**{**data, "title": title}, folder=file.folder)
