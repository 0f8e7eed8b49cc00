"""Published parameter sets, one file per source."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.plugins import Registry
from poppet.core.provenance import Number
from poppet.laws.curves import Characteristic
from poppet.library import dmsp, gases, varga2012, vppm_6l
from poppet.library.gases import Gas

__all__ = [
    "Gas",
    "ParameterSet",
    "characteristic",
    "characteristics",
    "describe",
    "gas",
    "gas_names",
    "main_stage",
    "numbers",
    "sets",
]


@dataclass(frozen=True)
class ParameterSet:
    """Published parameters of one valve or muscle, or of parts of it.

    Parameters
    ----------
    reference : str
        Publication from which the parameters come.
    parts : mapping
        Parameters by dotted name, for each kind of part and each variant of it: `parts[kind][variant][name]`. The
        variant is the mode of a main stage or the preset of electronics; it is empty for other kinds.
    characteristics : mapping, optional
        Function for each flow characteristic by name, such as `varga2012.closed`. The function takes the name and
        returns the characteristic.
    """

    reference: str
    parts: Mapping[str, Mapping[str, Mapping[str, Number]]]
    characteristics: Mapping[str, Callable[[str], Characteristic]] = field(default_factory=dict)


_SETS: Registry[ParameterSet] = Registry(
    "poppet.library",
    {
        **{name: ParameterSet(dmsp.REFERENCES[name], {"muscle": {"": muscle}}) for name, muscle in dmsp.SETS.items()},
        varga2012.NAME: ParameterSet(
            varga2012.REFERENCE, {"main_stage": varga2012.MAIN_STAGES}, varga2012.CHARACTERISTICS
        ),
        vppm_6l.NAME: ParameterSet(
            vppm_6l.REFERENCE,
            {
                "main_stage": {"regulator": vppm_6l.MAIN_STAGE},
                "pilot_stage": {"": vppm_6l.PILOT_STAGE},
                "electronics": vppm_6l.ELECTRONICS,
            },
            {f"{vppm_6l.NAME}.closed": varga2012.closed_characteristic},
        ),
    },
    lambda name, value: isinstance(value, ParameterSet),
)
_VARIANTS = {"main_stage": "mode", "electronics": "preset"}


def sets() -> tuple[str, ...]:
    """Return the names of all parameter sets.

    Returns
    -------
    tuple of str
        The name `gases`, and one name for each published valve or muscle.

    Examples
    --------
    >>> sets()
    ('gases', 'dmsp_10_250', 'dmsp_20_300', 'dmsp_40_300', 'varga2012', 'vppm_6l')
    """
    return ("gases", *sorted(_SETS))


def characteristics() -> tuple[str, ...]:
    """Return the names of all published flow characteristics.

    Returns
    -------
    tuple of str
        Valid arguments of the function `characteristic`.

    Examples
    --------
    >>> "varga2012.closed" in characteristics()
    True
    """
    return tuple(sorted(name for parameter_set in _SETS.values() for name in parameter_set.characteristics))


def gas_names() -> tuple[str, ...]:
    """Return the names of all gases in the library.

    Returns
    -------
    tuple of str
        Valid arguments of the function `gas`.

    Examples
    --------
    >>> gas_names()[:2]
    ('air', 'argon')
    """
    return tuple(gases.GASES)


def characteristic(name: str) -> Characteristic:
    """Return a published flow characteristic by name.

    Parameters
    ----------
    name : str
        `varga2012` or `varga2012.printed` (polynomials as printed), `varga2012.closed` (C is zero for strokes up to 0),
        `varga2012.monotone` (C also never decreases with the stroke) or `varga2012.table` (interpolated table).

    Returns
    -------
    Characteristic
        Characteristic whose parameters state their sources.

    Raises
    ------
    InputError
        If the name is not valid.

    Examples
    --------
    >>> print(f"{characteristic('varga2012').critical_ratio_at(0.5e-3):.5f}")
    0.42736
    """
    owner = name.partition(".")[0]
    if owner not in _SETS or name not in _SETS[owner].characteristics:
        raise _unknown("characteristic", name, characteristics())
    return _SETS[owner].characteristics[name](name)


def main_stage(name: str, mode: str) -> Mapping[str, Number]:
    """Return the mechanical and exhaust parameters of a published main stage.

    Parameters
    ----------
    name : str
        Name of a parameter set, for example `varga2012`.
    mode : str
        Mode of the part: `paper` for the printed equations of motion, `regulator` for a balance of pilot pressure and
        outlet pressure.

    Returns
    -------
    mapping of str to Number
        Fields of the part `main_stage` by dotted name.

    Raises
    ------
    InputError
        If the set or the mode is not valid.

    Examples
    --------
    >>> print(main_stage("varga2012", "paper")["plate_area"])
    0.0004909 m^2
    """
    return numbers(name, "main_stage", mode)


def numbers(name: str, kind: str, variant: str = "") -> Mapping[str, Number]:
    """Return the parameters for one kind of part in a published set.

    Parameters
    ----------
    name : str
        Name of a parameter set, for example `vppm_6l`.
    kind : str
        Kind of part, for example `pilot_stage`.
    variant : str, optional
        Mode of a main stage or preset of electronics; empty for other kinds.

    Returns
    -------
    mapping of str to Number
        Fields of the part by dotted name.

    Raises
    ------
    InputError
        If the set does not exist, or has no parameters for the kind or the variant.

    Examples
    --------
    >>> print(numbers("vppm_6l", "pilot_stage")["volume"])
    5e-06 m^3
    """
    if name not in _SETS or kind not in _SETS[name].parts:
        raise _unknown("data", name, [key for key, parameter_set in _SETS.items() if kind in parameter_set.parts])
    variants = _SETS[name].parts[kind]
    if variant not in variants:
        raise _unknown(_VARIANTS.get(kind, "data"), variant, variants)
    return variants[variant]


def complete_sets(*kinds: str) -> tuple[str, ...]:
    """Return the names of the parameter sets that contain parameters for all given kinds of parts."""
    return tuple(name for name, parameter_set in _SETS.items() if set(kinds) <= set(parameter_set.parts))


def every_set(kind: str) -> list[Mapping[str, Number]]:
    """Return the parameters for one kind of part in all loaded parameter sets.

    The result contains one mapping for each variant of each set. Sets of plugins that are not loaded are omitted.
    """
    # A part has numbers of loaded sets only. Each part that is made calls this function: it does not read plugins.
    loaded = [parameter_set.parts.get(kind, {}) for parameter_set in _SETS.data.values()]
    return [numbers for variants in loaded for numbers in variants.values()]


def gas(name: str) -> Gas:
    """Return an ideal gas by name.

    Parameters
    ----------
    name : str
        Name such as `air` or `carbon_dioxide`; case is ignored, and blanks and underscores are equivalent.

    Returns
    -------
    Gas
        Gas constant and isentropic exponent with their sources.

    Raises
    ------
    InputError
        If the name is not valid.

    Examples
    --------
    >>> print(f"{float(gas('nitrogen').gas_constant):.2f} J/(kg K)")
    296.80 J/(kg K)
    """
    normalised = name.replace("_", " ").casefold()
    normalised = gases.ALIASES.get(normalised, normalised)
    if normalised not in gases.GASES:
        raise _unknown("gas", name, gases.GASES)
    return gases.GASES[normalised]


def describe(name: str) -> str:
    """Return a text with all parameters of a set, a characteristic or a gas.

    The text contains their values, units and sources.

    Parameters
    ----------
    name : str
        One of `sets()`, `characteristics()` or `gas_names()`.

    Returns
    -------
    str
        Text of several lines.

    Raises
    ------
    InputError
        If the name is not valid.

    Examples
    --------
    >>> print(describe("argon").splitlines()[0])
    argon: an ideal gas
    """
    if name == "gases":
        return "\n\n".join(_gas_text(gas) for gas in gases.GASES.values())
    if name in gases.GASES:
        return _gas_text(gases.GASES[name])
    if name in _SETS:
        parameter_set = _SETS[name]
        blocks = [f"{name}: {parameter_set.reference}"]
        if parameter_set.characteristics:
            names = sorted(parameter_set.characteristics)
            blocks[0] += f"\ncharacteristics: {', '.join(names)}"
            blocks.append(_characteristic_text(characteristic(names[0])))
        for kind, variants in parameter_set.parts.items():
            for variant, values in variants.items():
                option = f', {_VARIANTS.get(kind, "variant")} = "{variant}"' if variant else ""
                blocks.append(f"{kind}{option}\n{_number_lines(values)}")
        return "\n\n".join(blocks)
    if name in characteristics():
        return _characteristic_text(characteristic(name))
    raise _unknown("data", name, (*sets(), *characteristics(), *gases.GASES))


def _characteristic_text(curve: Characteristic) -> str:
    low, high = curve.domain
    options = [f"domain {1e3 * low:g} ... {1e3 * high:g} mm", f"edge {curve.edge}"]
    options += ["running maximum of C"] if curve.monotone else []
    return f"{curve.name}: C(x), b(x); {', '.join(options)}; {curve.source}\n{_number_lines(curve.numbers())}"


def _gas_text(gas: Gas) -> str:
    return f"{gas.name}: an ideal gas\n{_number_lines(gas.numbers())}\n  {gas.note}"


def _number_lines(numbers: Mapping[str, Number]) -> str:
    width = max(len(name) for name in numbers)
    values = {name: number.display() for name, number in numbers.items()}
    longest = max(len(value) for value in values.values())
    return "\n".join(
        f"  {name:<{width}}  {values[name]:<{longest}}  {number.source}" for name, number in numbers.items()
    )


def _unknown(field_name: str, name: str, valid: Iterable[str]) -> InputError:
    return InputError("library.unknown", field=field_name, name=name, suggestion=NameSuggestion(name, tuple(valid)))
