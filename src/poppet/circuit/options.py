"""What surrounds the parts of a circuit: ambient, gas, and how to run."""

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
"""Codes of what is said about numbers of C, which may hold for air or for the gas."""


class _Section:
    """A section of a circuit file whose fields are declared as those of parts are."""

    def numbers(self) -> dict[str, Number]:
        """Numbers by name."""
        return dict(self._numbers)

    @cached_property
    def _numbers(self) -> dict[str, Number]:
        # Kept: a fit makes many circuits that share their sections, and each of them asks.
        return {name: value for name, _, value in flatten(self)}


@dataclass(frozen=True)
class Ambient(_Section):
    """The surroundings: what gauge pressures, open plates and open walls refer to.

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
class GasChoice(_Section):
    """The gas in the circuit, an ideal gas of constant heat capacity.

    Parameters
    ----------
    name : str, optional
        A gas of the library, whose numbers are used where none are given.
    gas_constant : number
        Specific gas constant R [J/(kg K)]; default that of air.
    isentropic_exponent : number
        Ratio of heat capacities kappa; default that of air.
    conductances : str
        `as given` (default): sonic conductances and critical ratios hold for this gas. `from air`: they were measured
        with air, and are turned into those of this gas. What is given as an area is always one of this gas, and a Kv, a
        Cv and a nominal flow are always turned.
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
        # A changed name must not leave the numbers of the old gas behind as if they had been given.
        forget_library(self, [air, *map(_gas_numbers, library.gas_names())])
        try:
            known = {} if self.name is None else _gas_numbers(str(self.name))
        except InputError as error:
            raise error.located(address="name") from None
        complete(self, known)

    @classmethod
    def of(cls, gas: library.Gas) -> GasChoice:
        """A gas as `poppet.library.gas` returns it, or one that somebody made of numbers of their own."""
        if gas in library.gases.GASES.values():
            return cls(name=gas.name)

        # With a source of their own: numbers of the library's gases are dropped when a name is missing.
        def own(number: Number) -> Number:
            return replace(number, source=replace(number.source, note=f"of the gas {gas.name!r}"))

        return cls(gas_constant=own(gas.gas_constant), isentropic_exponent=own(gas.isentropic_exponent))

    def values(self) -> tuple[float, float, float, float]:
        """Gas constant [J/(kg K)], isentropic exponent, factor on sonic conductances, shift of critical ratios."""
        return self._values

    @cached_property
    def _values(self) -> tuple[float, float, float, float]:
        constant, exponent = float(self.gas_constant), float(self.isentropic_exponent)  # type: ignore[arg-type]
        if self.conductances == "as given":
            return constant, exponent, 1.0, 0.0
        return constant, exponent, *factors_from_air(exponent, constant)

    def notes(self) -> tuple[Note, ...]:
        """What to know when the gas is not air, or is given twice."""
        factor = self.values()[2]
        known = {} if self.name is None else _gas_numbers(str(self.name))
        # Both were given, the gas and some numbers of its own: these win, and a note says so.
        unknown = () if self.of_library() else (Note("gas.unknown", "gas"),)
        over = tuple(name for name, value in known.items() if float(getattr(self, name)) != float(value))
        if over:
            return (Note("options.own_gas_numbers", "gas", numbers=over, count=len(over), name=str(self.name)),)
        if self.is_air:
            return ()
        if self.conductances == "from air":
            return (Note("options.conductances_from_air", "gas", factor=factor), *unknown)
        return (Note("options.conductances_as_given", "gas"), *unknown)

    @property
    def is_air(self) -> bool:
        """True when its numbers are those of air."""
        return self.values()[:2] == (AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT)

    def of_library(self) -> library.Gas | None:
        """The gas by name, or air by its numbers.

        Returns
        -------
        Gas or None
            None of a gas that is known by other numbers alone.
        """
        if self.name is None and not self.is_air:
            return None
        return library.gas("air" if self.name is None else str(self.name))


@lru_cache
def _gas_numbers(name: str) -> dict[str, Number]:
    gas = library.gas(name)
    return {"gas_constant": gas.gas_constant, "isentropic_exponent": gas.isentropic_exponent}


@dataclass(frozen=True)
class Run(_Section):
    """How to run a circuit.

    Parameters
    ----------
    duration : number
        Length of the run [s].
    output_step : number
        Time between rows [s]; default a thousandth of the duration.
    relative_tolerance : number
        Accuracy of the results.
    maximum_step : number
        Longest step of the integrator [s].
    stop_when : str or list of str
        Conditions that end the run early, `tank.pressure > 5 bar`.
    solver : str
        `rosenbrock`, or for a check `cvodes`, `lsoda`, `bdf`, `radau`.
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
            # A tuple, for a run is the key of the problems that are kept.
            texts = tuple(self.stop_when) if isinstance(self.stop_when, list | tuple) else (self.stop_when,)
            if not all(isinstance(text, str) for text in texts):
                raise InputError("options.no_condition", "stop_when", value=self.stop_when)
            object.__setattr__(self, "stop_when", texts)

    @property
    def stop_texts(self) -> tuple[str, ...]:
        """Stop conditions as written."""
        return self.stop_when or ()

    @property
    def tolerance(self) -> float:
        """Relative tolerance."""
        return float(self.relative_tolerance)  # type: ignore[arg-type]

    @property
    def longest_step(self) -> float:
        """Longest step [s], infinite when not limited."""
        return math.inf if self.maximum_step is None else float(self.maximum_step)  # type: ignore[arg-type]

    def changed(self, **options: Any) -> Run:
        """This run with the options that are not None; itself when none is given.

        Parameters
        ----------
        **options
            As in `Run`.
        """
        changes = {name: value for name, value in options.items() if value is not None}
        return replace(self, **changes) if changes else self

    def grid(self) -> NDArray[np.float64]:
        """Output times: 0, step, 2 step, ..., and the duration always [s]."""
        return self._grid

    @cached_property
    def _grid(self) -> NDArray[np.float64]:
        if self.duration is None:
            raise InputError("options.no_duration", "run.duration")
        duration = float(self.duration)  # type: ignore[arg-type]
        step = duration / DEFAULT_ROWS if self.output_step is None else float(self.output_step)  # type: ignore[arg-type]
        # Before the arrays are made: a step in the wrong unit would ask for all memory.
        if duration / step > MOST_ROWS:
            rows = duration / step
            raise OutOfRangeError("options.too_many_rows", "run.output_step", step=step, rows=rows, most=MOST_ROWS)
        return _output_times(duration, step)


def _multiples(step: float, count: int) -> NDArray[np.float64]:
    """0, step, ..., count step, each the double nearest to the decimal that is meant.

    A row then falls on a breakpoint written as a decimal: 3 * 0.1 is not 0.3, but 3 / 10 is.
    """
    _, digits, exponent = Decimal(repr(step)).as_tuple()
    whole = int("".join(map(str, digits)))
    # 10^22 is the largest power of ten that a double holds exactly, and 2^53 the last whole number without gaps.
    if isinstance(exponent, int) and -22 <= exponent < 0 and whole * count < 2**53:
        return np.arange(count + 1, dtype=np.float64) * float(whole) / 10.0**-exponent
    return np.arange(count + 1, dtype=np.float64) * step


@lru_cache(maxsize=64)
def _output_times(duration: float, step: float) -> NDArray[np.float64]:
    # A whole number of steps is one, whatever rounding makes of the quotient.
    count = math.floor(duration / step * (1.0 + 1e-12))
    times = _multiples(step, count)
    if duration - times[-1] > 1e-9 * step:
        times = np.append(times, duration)
    # Also where the last multiple differs from it by rounding only.
    times[-1] = duration
    # Cached: whoever wrote into them would change the rows of other runs.
    times.flags.writeable = False
    return times
