"""Units in an FMU: exponents of the SI base units, and units to be shown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from poppet.core.unit_table import read_unit

BASE = ("m", "kg", "s", "K", "A", "rad")
SHOWN = {
    "Pa": "bar",
    "K": "degC",
    "m": "mm",
    "m^3": "l",
    "kg": "g",
    "kg/s": "g/s",
    "m^3/(s Pa)": "l/(s bar)",
    "rad": "deg",
    "m^2": "mm^2",
}
"""By SI unit the one that a host may show."""


def definitions(units: Iterable[str]) -> Iterator[tuple[str, dict[str, str], tuple[str, dict[str, str]] | None]]:
    """Of each unit its name, the attributes of its base unit, and name and attributes of the unit to be shown."""
    for name in sorted(set(units) - {"", "1"}):
        unit = read_unit(name)
        base = {symbol: str(int(e)) for symbol, e in zip(BASE, unit.dimension, strict=True) if e}
        # FMI has whole exponents only; another unit has a name and no more.
        base = {} if any(e.denominator != 1 for e in unit.dimension) else base
        if base and unit.scale != 1:
            base["factor"] = repr(float(unit.scale))
        shown = None
        if name in SHOWN:
            other = read_unit(SHOWN[name])
            attributes = {} if other.scale == unit.scale else {"factor": repr(float(unit.scale / other.scale))}
            attributes |= {"offset": repr(-float(other.offset))} if other.offset else {}
            shown = SHOWN[name], attributes
        yield name, base, shown


def shown_unit(name: str, unit: str) -> str:
    """Unit in which a variable is to be shown; empty for its own."""
    if unit == "K" and not name.endswith("temperature"):  # a difference of temperatures has no offset
        return ""
    return SHOWN.get(unit, "")
