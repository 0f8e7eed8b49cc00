"""Published parameter sets, one file per source."""

from __future__ import annotations

from collections.abc import Mapping

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.provenance import Number
from poppet.laws.curves import Characteristic
from poppet.library import dmsp, gases, varga2012, vppm_6l
from poppet.library.gases import Gas

__all__ = [
    "Gas",
    "characteristic",
    "characteristics",
    "describe",
    "gas",
    "gas_names",
    "main_stage",
    "numbers",
    "sets",
]

_REFERENCES = {varga2012.NAME: varga2012.REFERENCE, vppm_6l.NAME: vppm_6l.REFERENCE, **dmsp.REFERENCES}
_NUMBERS: dict[str, dict[str, Mapping[str, Mapping[str, Number]]]] = {
    varga2012.NAME: {"main_stage": varga2012.MAIN_STAGES},
    vppm_6l.NAME: {
        "main_stage": {"regulator": vppm_6l.MAIN_STAGE},
        "pilot_stage": {"": vppm_6l.PILOT_STAGE},
        "electronics": vppm_6l.ELECTRONICS,
    },
    **{name: {"muscle": {"": numbers}} for name, numbers in dmsp.SETS.items()},
}
"""Set to kind of part to variant (mode, preset) to numbers."""
_VARIANTS = {"main_stage": "mode", "electronics": "preset"}
_CHARACTERISTICS = {**varga2012.CHARACTERISTICS, f"{vppm_6l.NAME}.closed": varga2012.closed_characteristic}


def sets() -> tuple[str, ...]:
    """Names of the parameter sets.

    Returns
    -------
    tuple of str
        `gases` and one name for each published valve or muscle.

    Examples
    --------
    >>> sets()
    ('gases', 'dmsp_10_250', 'dmsp_20_300', 'dmsp_40_300', 'varga2012', 'vppm_6l')
    """
    return ("gases", *sorted(_REFERENCES))


def characteristics() -> tuple[str, ...]:
    """Names of the flow characteristics.

    Returns
    -------
    tuple of str
        Each can be given to `characteristic`.

    Examples
    --------
    >>> "varga2012.closed" in characteristics()
    True
    """
    return tuple(sorted(_CHARACTERISTICS))


def gas_names() -> tuple[str, ...]:
    """Names of the gases.

    Returns
    -------
    tuple of str
        Each can be given to `gas`.

    Examples
    --------
    >>> gas_names()[:2]
    ('air', 'argon')
    """
    return tuple(gases.GASES)


def characteristic(name: str) -> Characteristic:
    """A published flow characteristic.

    Parameters
    ----------
    name : str
        `varga2012` (as printed, also `varga2012.printed`), `varga2012.closed`, `.monotone` or `.table`.

    Returns
    -------
    Characteristic
        With the source of every number.

    Raises
    ------
    InputError
        There is none of that name.

    Examples
    --------
    >>> print(f"{characteristic('varga2012').critical_ratio_at(0.5e-3):.5f}")
    0.42736
    """
    if name not in _CHARACTERISTICS:
        raise _unknown("characteristic", name, _CHARACTERISTICS)
    return _CHARACTERISTICS[name](name)


def main_stage(name: str, mode: str) -> Mapping[str, Number]:
    """Mechanics and exhaust of a published main stage.

    Parameters
    ----------
    name : str
        Parameter set, `varga2012`.
    mode : str
        `paper` for the printed equations of motion, `regulator` for the balance of pilot and output pressure.

    Returns
    -------
    mapping of str to Number
        Fields of the part `main_stage` under their dotted names.

    Raises
    ------
    InputError
        There is no such set or mode.

    Examples
    --------
    >>> print(main_stage("varga2012", "paper")["plate_area"])
    0.0004909 m^2
    """
    return numbers(name, "main_stage", mode)


def numbers(name: str, kind: str, variant: str = "") -> Mapping[str, Number]:
    """Numbers of a part in a published set.

    Parameters
    ----------
    name : str
        Parameter set, `vppm_6l`.
    kind : str
        Kind of part, `pilot_stage`.
    variant : str, optional
        Mode of a main stage, preset of electronics.

    Returns
    -------
    mapping of str to Number
        Fields of the part under their dotted names.

    Raises
    ------
    InputError
        There is no such set, or it has no such part or variant.

    Examples
    --------
    >>> print(numbers("vppm_6l", "pilot_stage")["volume"])
    5e-06 m^3
    """
    with_kind = [each for each, parts in _NUMBERS.items() if kind in parts]
    if name not in with_kind:
        raise _unknown("data", name, tuple(with_kind))
    variants = _NUMBERS[name][kind]
    if variant not in variants:
        raise _unknown(_VARIANTS[kind], variant, variants)
    return variants[variant]


def complete_sets(kind: str) -> tuple[str, ...]:
    """Sets that have numbers for all parts of a part made of parts, `proportional_valve`."""
    needed = {"proportional_valve": {"main_stage", "pilot_stage", "electronics"}}[kind]
    return tuple(name for name, parts in _NUMBERS.items() if needed <= set(parts))


def every_set(kind: str) -> list[Mapping[str, Number]]:
    """Numbers of a kind of part in all sets and variants."""
    return [each for parts in _NUMBERS.values() for each in parts.get(kind, {}).values()]


def gas(name: str) -> Gas:
    """A gas as an ideal gas.

    Parameters
    ----------
    name : str
        `air`, `nitrogen`, ...; upper and lower case, blanks and underscores are alike.

    Returns
    -------
    Gas
        Gas constant and isentropic exponent with their sources.

    Raises
    ------
    InputError
        There is none of that name.

    Examples
    --------
    >>> print(f"{float(gas('nitrogen').gas_constant):.2f} J/(kg K)")
    296.80 J/(kg K)
    """
    plain = name.replace("_", " ").casefold()
    plain = gases.ALIASES.get(plain, plain)
    if plain not in gases.GASES:
        raise _unknown("gas", name, gases.GASES)
    return gases.GASES[plain]


def describe(name: str) -> str:
    """A set, a characteristic or a gas as text: every number with its unit and source.

    Parameters
    ----------
    name : str
        One of `sets()`, `characteristics()` or `gas_names()`.

    Returns
    -------
    str
        Several lines.

    Raises
    ------
    InputError
        There is nothing of that name.

    Examples
    --------
    >>> print(describe("argon").splitlines()[0])
    argon: an ideal gas
    """
    if name == "gases":
        return "\n\n".join(_gas_text(each) for each in gases.GASES.values())
    if name in _REFERENCES:
        return _valve_text(name)
    if name in _CHARACTERISTICS:
        return _characteristic_text(characteristic(name))
    if name in gases.GASES:
        return _gas_text(gases.GASES[name])
    raise _unknown("data", name, (*sets(), *characteristics(), *gases.GASES))


def _valve_text(name: str) -> str:
    shown = [each for each in characteristics() if each.split(".")[0] == name]
    stages = [
        kind + (f', {_VARIANTS[kind]} = "{variant}"' if variant else "") + f"\n{_number_lines(own)}"
        for kind, variants in _NUMBERS[name].items()
        for variant, own in variants.items()
    ]
    head = f"{name}: {_REFERENCES[name]}"
    if shown:
        return "\n\n".join(
            [f"{head}\ncharacteristics: {', '.join(shown)}", _characteristic_text(characteristic(shown[0])), *stages]
        )
    return "\n\n".join([head, *stages])


def _characteristic_text(shown: Characteristic) -> str:
    low, high = shown.domain
    options = [f"domain {1e3 * low:g} ... {1e3 * high:g} mm", f"edge {shown.edge}"]
    options += ["running maximum of C"] if shown.monotone else []
    return f"{shown.name}: C(x), b(x); {', '.join(options)}; {shown.source}\n{_number_lines(shown.numbers())}"


def _gas_text(shown: Gas) -> str:
    return f"{shown.name}: an ideal gas\n{_number_lines(shown.numbers())}\n  {shown.note}"


def _number_lines(numbers: Mapping[str, Number]) -> str:
    width = max(len(name) for name in numbers)
    values = {name: number.display() for name, number in numbers.items()}
    longest = max(len(value) for value in values.values())
    return "\n".join(
        f"  {name:<{width}}  {values[name]:<{longest}}  {number.source}" for name, number in numbers.items()
    )


def _unknown(field: str, name: str, known: Mapping[str, object] | tuple[str, ...]) -> InputError:
    return InputError("library.unknown", field=field, name=name, near=NameSuggestion(name, known))
