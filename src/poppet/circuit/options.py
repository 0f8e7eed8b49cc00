"""Sections of a circuit file: ambient air, gas and run options."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.tables import Field, missing_field
from poppet.laws.iso6358 import factors_from_air
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.parts.fields import (
    NumberLike,
    NumberSpec,
    anr_pressure,
    anr_temperature,
    complete,
    declared,
    default_number,
    flatten,
    forget_library,
    number,
    option,
    reference,
)

MOST_ROWS = 20_000_000
DEFAULT_ROWS = 1000
ABOUT_CONDUCTANCES = ("options.conductances_from_air", "options.conductances_as_given")
"""Codes of notes on sonic conductances C, which were measured with air or with the gas of the circuit."""


class _OptionSection:
    """Base class of the sections `ambient`, `gas` and `run` of a circuit file.

    The fields of a section are declared in the same way as the fields of a part.
    """

    def numbers(self) -> dict[str, Number]:
        """Return a mapping from field names to values with unit and source."""
        return dict(self._numbers)

    @cached_property
    def _numbers(self) -> dict[str, Number]:
        # Cached: the circuits of a fit share their sections.
        return {name: value for name, _, value in flatten(self)}


@dataclass(frozen=True)
class Ambient(_OptionSection):
    """Pressure and temperature of the ambient air.

    Gauge pressures refer to this pressure. All plates and walls that are open to the ambient air have these conditions.

    Parameters
    ----------
    pressure : number
        Absolute pressure [Pa].
    temperature : number
        Temperature [K].
    """

    pressure: NumberLike = anr_pressure("ambient pressure")
    temperature: NumberLike = anr_temperature("ambient temperature")

    def __post_init__(self) -> None:
        complete(self, {})
        assert isinstance(self.pressure, Number)
        if self.pressure.reference == "gauge":
            raise InputError("options.gauge_ambient", "pressure", shown=self.pressure.display())


@dataclass(frozen=True)
class GasChoice(_OptionSection):
    """Gas in the circuit, modelled as an ideal gas with constant heat capacity.

    Parameters
    ----------
    name : str, optional
        Gas of the library, which supplies omitted values.
    gas_constant : number
        Specific gas constant R [J/(kg K)] (default: value of air).
    isentropic_exponent : number
        Ratio of heat capacities kappa (default: value of air).
    conductances : str
        `as given` (default): sonic conductances and critical ratios apply to this gas. `from air`: they were measured
        with air and are converted to this gas. Areas always apply to this gas; Kv, Cv and nominal flows are always
        converted.
    """

    name: Any = reference(doc="gas of the library")
    gas_constant: NumberLike = number(
        "J/(kg K)", AIR_GAS_CONSTANT, doc="gas constant", above=0.0, source="standard", note="air, ISO 2533"
    )
    isentropic_exponent: NumberLike = number(
        "1", AIR_ISENTROPIC_EXPONENT, doc="isentropic exponent", above=1.0, high=2.0, source="standard", note="air"
    )
    conductances: str = option("as given", "from air", doc="meaning of the sonic conductances")

    def __post_init__(self) -> None:
        defaults = {name: default_number(name, spec) for name, _, spec in declared(GasChoice, NumberSpec)}
        air = {name: value for name, value in defaults.items() if value}
        # After a change of the name, values of the previous gas must not remain.
        forget_library(self, [air, *map(_gas_numbers, library.gas_names())])
        try:
            values = {} if self.name is None else _gas_numbers(str(self.name))
        except InputError as error:
            raise error.located(address="name") from None
        complete(self, values)

    @classmethod
    def of(cls, gas: library.Gas) -> GasChoice:
        """Return the gas section of a circuit for a gas object.

        A gas of the library is stored by its name. Any other gas is stored by its values.
        """
        if gas in library.gases.GASES.values():
            return cls(name=gas.name)

        # With another source: values that equal those of a library gas are dropped if the name is missing.
        def with_note(number: Number) -> Number:
            return replace(number, source=replace(number.source, note=f"of the gas {gas.name!r}"))

        return cls(gas_constant=with_note(gas.gas_constant), isentropic_exponent=with_note(gas.isentropic_exponent))

    def values(self) -> tuple[float, float, float, float]:
        """Return gas constant [J/(kg K)], isentropic exponent, and the conversion of flow parameters.

        The conversion from air to this gas consists of a factor on the sonic conductance C and a shift of the critical
        ratio b.
        """
        return self._values

    @cached_property
    def _values(self) -> tuple[float, float, float, float]:
        constant, exponent = float(self.gas_constant), float(self.isentropic_exponent)  # type: ignore[arg-type]
        if self.conductances == "as given":
            return constant, exponent, 1.0, 0.0
        return constant, exponent, *factors_from_air(exponent, constant)

    def notes(self) -> tuple[Note, ...]:
        """Return notes on differences of the gas from air or from the library."""
        factor = self.values()[2]
        library_values = {} if self.name is None else _gas_numbers(str(self.name))
        unknown = () if self.of_library() else (Note("gas.unknown", "gas"),)
        # Values of the file override those of the library.
        changed = tuple(name for name, value in library_values.items() if float(getattr(self, name)) != float(value))
        if changed:
            return (Note("options.own_gas_numbers", "gas", numbers=changed, count=len(changed), name=str(self.name)),)
        if self.is_air:
            return ()
        if self.conductances == "from air":
            return (Note("options.conductances_from_air", "gas", factor=factor), *unknown)
        return (Note("options.conductances_as_given", "gas"), *unknown)

    @property
    def is_air(self) -> bool:
        """True if the gas has the gas constant and the isentropic exponent of air."""
        return self.values()[:2] == (AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT)

    def of_library(self) -> library.Gas | None:
        """Return the library gas that this section specifies, or None.

        Returns
        -------
        Gas or None
            None for a gas without a name that differs from air.
        """
        if self.name is None and not self.is_air:
            return None
        return library.gas("air" if self.name is None else str(self.name))


@lru_cache
def _gas_numbers(name: str) -> dict[str, Number]:
    gas = library.gas(name)
    return {"gas_constant": gas.gas_constant, "isentropic_exponent": gas.isentropic_exponent}


@dataclass(frozen=True)
class Run(_OptionSection):
    """Options of a run.

    Parameters
    ----------
    duration : number
        Duration [s].
    output_step : number
        Time between rows [s] (default: a thousandth of the duration).
    relative_tolerance : number
        Accuracy of the results.
    maximum_step : number
        Longest step of the integrator [s].
    stop_when : str or list of str
        Conditions that end the run early, for example `tank.pressure > 5 bar`.
    solver : str
        `rosenbrock`; or `cvodes`, `lsoda`, `bdf`, `radau` to check the result.
    """

    duration: NumberLike = number("s", optional=True, doc="duration", above=0.0)
    output_step: NumberLike = number("s", optional=True, doc="output step", above=0.0)
    relative_tolerance: NumberLike = number("1", 1e-6, doc="relative tolerance", low=1e-13, high=0.1)
    maximum_step: NumberLike = number("s", optional=True, doc="maximum step", above=0.0)
    stop_when: Any = reference(doc="conditions that end the run")
    solver: str = option("rosenbrock", "cvodes", "lsoda", "bdf", "radau", doc="solver")

    def __post_init__(self) -> None:
        complete(self, {})
        if self.stop_when is not None:
            # Hashable: a run is the key of cached problems.
            texts = tuple(self.stop_when) if isinstance(self.stop_when, list | tuple) else (self.stop_when,)
            if not all(isinstance(text, str) for text in texts):
                raise InputError("options.no_condition", "stop_when", value=self.stop_when)
            object.__setattr__(self, "stop_when", texts)

    @property
    def stop_texts(self) -> tuple[str, ...]:
        """Stop conditions of the run, each as text."""
        return self.stop_when or ()

    @property
    def tolerance(self) -> float:
        """Relative tolerance of the run as a float."""
        return float(self.relative_tolerance)  # type: ignore[arg-type]

    @property
    def longest_step(self) -> float:
        """Maximum step of the integrator [s].

        The value is infinite if there is no limit.
        """
        return math.inf if self.maximum_step is None else float(self.maximum_step)  # type: ignore[arg-type]

    def changed(self, **options: Any) -> Run:
        """Return a copy of the run options in which some options are replaced.

        An argument that is None leaves the option unchanged.

        Parameters
        ----------
        **options
            Fields of `Run`.
        """
        changes = {name: value for name, value in options.items() if value is not None}
        return replace(self, **changes) if changes else self

    def grid(self) -> NDArray[np.float64]:
        """Return the output times [s]: all multiples of the output step, and the duration."""
        if self.duration is None:
            raise missing_field("run.duration", Field(meaning="duration of a run", example='duration = "120 s"'))
        duration = float(self.duration)  # type: ignore[arg-type]
        step = duration / DEFAULT_ROWS if self.output_step is None else float(self.output_step)  # type: ignore[arg-type]
        # Before the arrays are created: a step in a wrong unit could need all memory.
        if duration / step > MOST_ROWS:
            rows = duration / step
            raise OutOfRangeError("options.too_many_rows", "run.output_step", step=step, rows=rows, most=MOST_ROWS)
        return _output_times(duration, step)


@lru_cache(maxsize=64)
def _output_times(duration: float, step: float) -> NDArray[np.float64]:
    # The tolerance includes a last step that rounding of the quotient would lose.
    count = math.floor(duration / step * (1.0 + 1e-12))
    times = np.arange(count + 1, dtype=np.float64)
    # Each multiple is rounded once from the exact decimal value. Rows then coincide with breakpoints written as
    # decimals: 3 * 0.1 differs from 0.3, but 3 / 10 does not. 10^22 is the largest power of ten, and 2^53 the largest
    # range of integers, that doubles represent exactly.
    _, digits, exponent = Decimal(repr(step)).as_tuple()
    mantissa = int("".join(map(str, digits)))
    is_exact = isinstance(exponent, int) and -22 <= exponent < 0 and mantissa * count < 2**53
    times = times * float(mantissa) / 10.0 ** -int(exponent) if is_exact else times * step
    if duration - times[-1] > 1e-9 * step:
        times = np.append(times, duration)
    # The last multiple can differ from the duration by rounding.
    times[-1] = duration
    # Read-only, because other runs share the cached array.
    times.flags.writeable = False
    return times
