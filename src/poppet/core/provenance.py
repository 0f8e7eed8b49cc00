"""Values of parameters with unit, reference and source."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, get_args

from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, UnitError
from poppet.core.symbolic import SymbolicValueError, is_symbolic

SourceKind = Literal["paper", "standard", "measured", "fitted", "datasheet", "assumed", "given"]
SOURCE_KINDS: tuple[SourceKind, ...] = get_args(SourceKind)
LEAST_CERTAIN_FIRST: tuple[SourceKind, ...] = (
    "assumed", "datasheet", "fitted", "measured", "given", "paper", "standard",
)  # fmt: skip

Reference = Literal["absolute", "gauge", "difference", ""]
REFERENCES: tuple[Reference, ...] = get_args(Reference)


@dataclass(frozen=True, slots=True)
class Source:
    """Source of a parameter value, for example a paper or an assumption.

    Parameters
    ----------
    kind : str
        One of `SOURCE_KINDS`; `given` is a value of the user.
    locator : str, optional
        Location in the source: work, table, page, equation, file.
    note : str, optional
        Note for the reader, for example the reason for an assumption.

    Examples
    --------
    >>> str(Source("paper", "Varga & Keski-Honkola 2012, Table 1"))
    'paper: Varga & Keski-Honkola 2012, Table 1'
    """

    kind: SourceKind
    locator: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        if self.kind not in SOURCE_KINDS:
            suggestion = NameSuggestion(str(self.kind), SOURCE_KINDS)
            raise InputError(
                "fields.not_an_option", "kind", value=self.kind, meaning="kind of source", suggestion=suggestion
            )

    def __str__(self) -> str:
        text = f"{self.kind}: {self.locator}" if self.locator else self.kind
        return f"{text} ({self.note})" if self.note else text


@dataclass(frozen=True, slots=True)
class ComponentSource(Source):
    """Source of a number that a component of a catalogue states.

    Parameters
    ----------
    kind, locator, note : str
        As in `Source`.
    component : str
        Manufacturer and model.
    stated : float
        The stated value, by which a changed number is recognised.
    doubts : tuple of str
        Reasons why the number is uncertain.

    Examples
    --------
    >>> str(ComponentSource("datasheet", "SMC SY5000: catalogue", component="SMC SY5000", stated=2.8e-8))
    'datasheet: SMC SY5000: catalogue'
    """

    component: str = ""
    stated: float = float("nan")
    doubts: tuple[str, ...] = ()

    def __str__(self) -> str:
        return Source.__str__(self)


@dataclass(frozen=True, slots=True)
class Number:
    """Value with unit, reference and source.

    Parameters
    ----------
    value : float
        The value in the SI unit `unit`; for a gauge pressure the gauge value.
    unit : str
        An SI unit as `poppet.core.units` writes it, `m^3/(s Pa)`.
    source : Source
        Source of the value.
    reference : str, optional
        `absolute`, `gauge` or `difference` for pressures and temperatures, else empty.
    text : str, optional
        Text of the user, `6 bar g`; displayed instead of the SI value.

    Notes
    -----
    A gauge pressure requires the ambient pressure for its absolute value: `float(number)` raises an error.

    Examples
    --------
    >>> supply = Number(6e5, "Pa", Source("given"), "gauge", "6 bar g")
    >>> supply.absolute(1.0e5)
    700000.0
    >>> supply.display()
    '6 bar g'
    """

    value: float
    unit: str
    source: Source
    reference: Reference = ""
    text: str = ""

    def __post_init__(self) -> None:
        if self.reference not in REFERENCES:
            suggestion = NameSuggestion(str(self.reference), filter(None, REFERENCES))
            facts: dict[str, Any] = {"meaning": "reference of a pressure", "suggestion": suggestion}
            raise InputError("fields.not_an_option", "reference", value=self.reference, **facts)

    def __float__(self) -> float:
        if self.reference == "gauge":
            raise UnitError("numbers.gauge", shown=self.display())
        if is_symbolic(self.value):
            raise SymbolicValueError(self.text)
        return float(self.value)

    def absolute(self, ambient_pressure: float) -> float:
        """Return the value; a gauge pressure becomes an absolute pressure.

        Parameters
        ----------
        ambient_pressure : float
            Absolute pressure of the surroundings [Pa].

        Returns
        -------
        float
            Value in `unit`, absolute.
        """
        if is_symbolic(self.value, ambient_pressure):
            return self.value + ambient_pressure if self.reference == "gauge" else self.value
        if self.reference != "gauge":
            return float(self.value)
        result = self.value + ambient_pressure
        if result < 0.0:
            raise OutOfRangeError("numbers.below_vacuum", shown=self.display(), lowest=-ambient_pressure)
        return float(result)

    def display(self) -> str:
        """Return the value as text with its unit.

        If the user wrote the value as text, the result is this text.
        """
        if self.text:
            try:
                float(self.text)
            except ValueError:
                return self.text  # not a value without its unit
        unit = "" if self.unit in ("", "1") else f" {self.unit}"
        value = str(self.value) if is_symbolic(self.value) else format(self.value, ".12g")
        return f"{self.text or value}{unit}{' g' if self.reference == 'gauge' else ''}"

    def __str__(self) -> str:
        return self.display()


def assumed(value: float, unit: str, note: str, *, reference: Reference = "") -> Number:
    """Return a value whose source is an assumption; `note` contains its reason.

    Examples
    --------
    >>> print(assumed(0.35, "1", "no exhaust ratio is printed").source)
    assumed (no exhaust ratio is printed)
    """
    return Number(value, unit, Source("assumed", note=note), reference)


def printed(value: float, unit: str, locator: str, note: str = "", *, reference: Reference = "") -> Number:
    """Return a value from a paper; `locator` is its location in the paper.

    Examples
    --------
    >>> printed(5.0034e-9, "m^3/(s Pa)", "Varga & Keski-Honkola 2012, Table 1").display()
    '5.0034e-09 m^3/(s Pa)'
    """
    return Number(value, unit, Source("paper", locator, note), reference)
