"""Palette of the editor: kinds of parts with symbols, ports and fields, from their declarations.

Matplotlib and the libraries for simulations are not imported.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from poppet import library
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.units import exact_scale
from poppet.edit.port_places import PortPlace, arrange
from poppet.edit.svg_symbols import svg_text
from poppet.library.components import CatalogueComponent, components
from poppet.parts import KINDS
from poppet.parts.components import MODEL, numbers_of
from poppet.parts.compound import Compound
from poppet.parts.fields import (
    OFF_ON,
    BodySpec,
    GroupSpec,
    MemberSpec,
    NumberSpec,
    OptionSpec,
    PortSpec,
    ReferenceSpec,
    Spec,
    declared,
    specs,
)
from poppet.parts.part import TUBE, Body, Controller, Part, Store
from poppet.parts.symbols import Symbol, rectangle

Entry = dict[str, Any]

GROUPS: dict[str, tuple[str, ...]] = {
    "supply": ("reservoir", "compressor", "pressure_regulator", "filter", "flow_source"),
    "volumes": ("chamber", "tube"),
    "flow": ("orifice", "flow_control_valve", "check_valve", "piloted_check_valve", "relief_valve", "silencer"),
    "logic": ("shuttle_valve", "two_pressure_valve", "quick_exhaust_valve"),
    "valves": ("directional_valve", "spool_valve", "proportional_valve", "main_stage", "pilot_stage"),
    "actuators": ("cylinder", "rotary_actuator", "gripper", "muscle", "pressure_booster"),
    "vacuum": ("vacuum_ejector", "suction_cup"),
    "bodies": ("mass", "joint", "guide"),
    "control": (
        "sequence", "switch", "pid", "pressure_controller", "electronics", "inverse_muscle", "antagonist",
        "fmu",
    ),
}  # fmt: skip
"""Kinds of each group of the palette, in the order of the palette."""
OTHER = "other"
"""Group of the kinds of plugins."""

UNITS: dict[tuple[str, str], tuple[str, ...]] = {
    ("Pa", "pressure"): ("bar g", "bar", "mbar", "kPa", "MPa", "psi g", "Pa"),
    ("Pa", "pressure_difference"): ("bar", "mbar", "kPa", "MPa", "psi", "Pa"),
    ("Pa", "plain"): ("bar", "mbar", "kPa", "Pa"),
    ("K", "temperature"): ("degC", "K"),
    ("kg/s", "mass_flow"): ("l/min ANR", "g/s", "kg/h", "kg/s"),
    ("m^3/s ANR", "volume_flow_anr"): ("l/min ANR", "m^3/h ANR", "l/min N", "m^3/h N"),
    ("m^3/(s Pa)", "plain"): ("dm^3/(s bar)", "l/(min bar)", "m^3/(s Pa)"),
    ("m", "plain"): ("mm", "um", "cm", "m"),
    ("m^2", "plain"): ("mm^2", "cm^2", "m^2"),
    ("m^3", "plain"): ("l", "cm^3", "m^3"),
    ("m/s", "plain"): ("mm/s", "m/s"),
    ("s", "plain"): ("ms", "s", "min"),
    ("kg", "plain"): ("kg", "g"),
    ("N", "plain"): ("N", "kN"),
    ("rad", "plain"): ("deg", "rad"),
    ("rad/s", "plain"): ("deg/s", "rad/s"),
    ("1", "plain"): ("", "%"),
    ("N/Pa", "plain"): ("N/bar", "N/Pa"),
    ("1/Pa", "plain"): ("1/bar", "1/Pa"),
    ("m^3/rad", "plain"): ("cm^3/rad", "m^3/rad"),
    ("N/m", "plain"): ("N/mm", "N/m"),
    ("Hz", "plain"): ("Hz", "kHz"),
}
"""Units that the form of a field offers, by SI unit and kind of quantity; the first is the usual one."""


COMMON_UNITS = (
    "hPa",
    "psi",
    "psi a",
    "bar a",
    "kPa g",
    "MPa g",
    "mbar g",
    "degF",
    "Nl/min",
    "Nm^3/h",
    "in",
    "nm",
    "um",
    "us",
    "h",
    "Hz",
    "kHz",
    "V",
    "mV",
    "mA",
    "A",
    "t",
    "mN",
    "N m",
    "Nm",
    "N mm",
    "kg m^2",
    "g mm^2",
    "kg cm^2",
    "rpm",
    "mrad",
    "cm/s",
    "km/h",
    "kN/m",
    "N/cm",
    "m^3/h",
    "l/min",
    "l/s",
    "l/s ANR",
    "dm^3",
    "cm^3",
    "mm^3",
    "ml",
    "L",
    "l/(s bar)",
    "dm^3/(min bar)",
    "m^2",
    "cm^2",
    "W/K",
    "J/K",
    "kJ/K",
    "J",
    "kJ",
    "W",
    "kW",
    "1/s",
    "1/min",
    "1/bar",
    "1/m",
    "1/mm",
)
"""Further units that the form converts."""


def palette() -> list[Entry]:
    """Return one entry per kind of part, including kinds of plugins, in the order of the palette.

    All values can be converted to JSON. Lengths are in modules of ISO 1219-1, 1/8 of the side of a symbol; the origin
    is the centre of the symbol, and the vertical axis points down.

    Returns
    -------
    list of dict
        Keys of each entry: `kind`, `group`, `summary`; `box` (left end, top end, width, height); `svg` and
        `svg_driven`, the symbol without and with driven inputs (None if they are equal); `ports`, `fields`, `groups`
        (of fields) and `sizes`. Exactly one of the fields in `sizes` of a part or group states its size.

        Keys of a port: `name` (empty for the part itself), `type` (`port`, `tube`, `store`, `body`, `input` or
        `output`), `x`, `y`, `side`, `lead` (length of the line from the border to the symbol), `also` (further places),
        `doc` and `required`.

        Keys of a field: `name`, `group`, `type` (`number`, `option`, `switch`, `model` or `reference`), `doc` and
        `required`. A number also has `unit`, `quantity`, `units` (the usual one first), `default`, `source`, `note` and
        its finite limits `low`, `high`, `above` and `below`; other fields have `choices`. A model also has
        `components`: for each component its `names`, the fields that it `sets`, its `options` and its `source`.

    Examples
    --------
    >>> orifice = next(entry for entry in palette() if entry["kind"] == "orifice")
    >>> [(port["name"], port["x"], port["y"]) for port in orifice["ports"][:2]]
    [('from', -4, 0), ('to', 4, 0)]
    """
    order = {kind: (group, k) for k, (group, kind) in enumerate((g, kind) for g in GROUPS for kind in GROUPS[g])}
    entries = [_entry(name, KINDS[name], order.get(name, (OTHER, len(order)))[0]) for name in KINDS]
    return sorted(entries, key=lambda entry: order.get(entry["kind"], (OTHER, len(order)))[1])


def sections() -> dict[str, list[Entry]]:
    """Return the fields of the tables `run`, `ambient` and `gas`, with the keys of the fields of `palette`.

    Examples
    --------
    >>> [field["name"] for field in sections()["ambient"]]
    ['pressure', 'temperature']
    """
    tables = {name: list(_fields(owner)) for name, owner in {"run": Run, "ambient": Ambient, "gas": GasChoice}.items()}
    for field in (*tables["gas"], *tables["run"]):
        if field["name"] == "name":
            field["choices"] = list(library.gas_names())
        if field["name"] == "duration":
            field["units"] = ["s", "ms", "min"]
    return tables


def unit_table() -> dict[str, Entry]:
    """Return the exact scale of units, for conversions in the form of the editor.

    The SI value is `factor * (value + offset)`, plus the ambient pressure if `gauge` is True. Factors and offsets are
    pairs of integers, numerator and denominator, as texts. A flow in `ANR` or `N` has the factor of its mass flow.
    Units of one `dimension` can be converted to each other.

    Examples
    --------
    >>> unit_table()["mm"]
    {'factor': ['1', '1000'], 'offset': ['0', '1'], 'gauge': False, 'dimension': '1 0 0 0 0 0'}
    """
    names = {*COMMON_UNITS, *(name for (unit, _), names in UNITS.items() for name in (unit, *names))}
    for kind in KINDS.values():
        blank = blank_part(kind)
        names |= {field["unit"] for field in _fields(kind) if field["type"] == "number"}
        names |= {unit for _, unit in _inputs(blank)}
    names |= {field["unit"] for table in sections().values() for field in table if field["type"] == "number"}
    return {name: _scale(name) for name in sorted(names - {"", "1"})} | {"": _scale("-"), "1": _scale("-")}


def _scale(unit: str) -> Entry:
    scale, is_gauge = exact_scale(unit)
    factor, offset = ([str(x.numerator), str(x.denominator)] for x in (scale.scale, scale.offset))
    dimension = " ".join(str(exponent) for exponent in scale.dimension)
    return {"factor": factor, "offset": offset, "gauge": is_gauge, "dimension": dimension}


def symbol_of(part: Part, *, is_driven: bool = False) -> Entry:
    """Return the keys `box`, `svg` and `ports` of a valid part, which depend on its options.

    For example, the symbol of a spool valve depends on its function, and the ports of a sequence are its inputs and
    outputs. Ports that the palette has too are at the same height or at the same distance from the centre. If
    `is_driven` is True, a signal or a connection drives an input. An input that a field or a condition of the part
    connects to an output also has the key `source`, the address of the output.

    Examples
    --------
    >>> from poppet.parts import SpoolValve
    >>> valve = SpoolValve(supply="a", a="b", b="c", function="5/2 monostable", nominal_flow="500 l/min ANR")
    >>> [(port["name"], port["x"]) for port in symbol_of(valve)["ports"][:3]]
    [('supply', 0), ('a', -1), ('b', 1)]
    """
    symbol = _shown(part.symbol_for(is_driven))
    entry = _drawn(type(part), [symbol], _ports(type(part), part)) | {"svg": svg_text(symbol)}
    sources = _sources(part)
    for port in entry["ports"]:
        if port["type"] == "input" and port["name"] in sources:
            port["source"] = sources[port["name"]]
    return entry


def _entry(name: str, kind: type[Part], group: str) -> Entry:
    blank = blank_part(kind)
    symbols = [_shown(kind.symbol)]
    if _symbol_for(blank, True) != _symbol_for(blank, False):
        symbols.append(_symbol_for(blank, True))
    return {
        "kind": name,
        "group": group,
        "summary": kind.summary,
        "svg": svg_text(symbols[0]),
        "svg_driven": svg_text(symbols[1]) if len(symbols) == 2 else None,
        **_drawn(kind, symbols, _ports(kind, blank)),
        "fields": list(_fields(kind)),
        "groups": list(_groups(kind)),
        "sizes": list(kind.sizes),
    }


def _drawn(kind: type[Part], symbols: Sequence[Symbol], ports: list[Entry]) -> Entry:
    """Return the box that contains symbols, and the ports with their places on its border."""
    types = [(port["name"], port["type"]) for port in ports]
    box, places, second = arrange(kind.kind, types, symbols, issubclass(kind, Controller))
    for port in ports:
        also: list[PortPlace] = [second[port["name"]]] if port["name"] in second else []
        port.update(dataclasses.asdict(places[port["name"]]))
        port["also"] = [dataclasses.asdict(place) for place in also]
    return {"box": list(box), "ports": ports}


def blank_part(kind: Any, table: Mapping[str, Any] = MappingProxyType({})) -> Any:
    """Return a part without numbers: options, ports and references are those of a table, or have their defaults.

    It is not a valid part, but has the ports and inputs of its options.
    """
    part = object.__new__(kind)
    for name, attribute, spec in declared(kind):
        value = table.get(name)
        inner = value if isinstance(value, Mapping) else MappingProxyType({})
        default = None
        if isinstance(spec, OptionSpec):
            default = value if isinstance(value, str) and value in spec.choices else spec.choices[0]
        elif isinstance(spec, PortSpec | BodySpec | ReferenceSpec):
            default = value
        elif isinstance(spec, GroupSpec) and (not spec.optional or name in table):
            default = blank_part(spec.group, inner)
        elif isinstance(spec, MemberSpec):
            default = blank_part(spec.part, inner)
        object.__setattr__(part, attribute, default)
    return part


def _symbol_for(blank: Part, is_driven: bool) -> Symbol:
    try:
        return _shown(blank.symbol_for(is_driven))
    except (AttributeError, KeyError, TypeError):
        return _shown(blank.symbol)  # the symbol depends on values


def _shown(symbol: Symbol | str) -> Symbol:
    """Return a symbol, or a box for a text."""
    return rectangle(0.0, 0.25, 1.0, 0.5) if isinstance(symbol, str) else symbol


def _ports(kind: type[Part], part: Part) -> list[Entry]:
    """Return the ports of a part without their places."""
    ports = []
    if issubclass(kind, Store):
        ports.append(_port("", "store", "gas node", False))
    if issubclass(kind, Body):
        ports.append(_port("", "body", "body on which actuators act", False))
    for name, attribute, spec in declared(kind, PortSpec, BodySpec, MemberSpec):
        if isinstance(spec, BodySpec):
            ports.append(_port(name, "body", spec.doc, not spec.optional))
        elif isinstance(spec, PortSpec):
            ports.append(_port(name, "tube" if kind.kind == TUBE else "port", spec.doc, not spec.optional))
        elif spec.is_open and getattr(part, attribute) is not None:
            ports.append(_port(name, "store", spec.doc, False))
    used = {port["name"] for port in ports}
    ports += [_port(name, "input", unit, False) for name, unit in _inputs(part) if name not in used]
    if isinstance(part, Controller):
        # Only sequences declare their outputs; "output" stands for any output of the other controllers.
        ports += [_port(name, "output", "output of the controller", False) for name in _commands(part) or ("output",)]
    return ports


def _port(name: str, port_type: str, doc: str, required: bool) -> Entry:
    return {"name": name, "type": port_type, "doc": doc, "required": required}


def _inputs(blank: Part) -> Iterable[tuple[str, str]]:
    """Return the names of the inputs with the default options, and their units."""
    try:
        return [(item.name, item.unit) for item in blank.inputs()]
    except (AttributeError, KeyError, TypeError):
        # The inputs depend on values. The editor takes them from the part.
        return [(name, "") for name in blank.inlets] if isinstance(blank, Compound) else []


def _sources(part: Part) -> dict[str, str]:
    """Return the outputs that fields and conditions of a part name, by the name of the input."""
    try:
        return {name: connection.source for name, connection in part.connections().items()}
    except (AttributeError, KeyError, TypeError):
        return {}  # an incomplete part


def _commands(part: Controller) -> tuple[str, ...]:
    try:
        return part.commands()
    except TypeError:
        return ()  # a blank part has no list of outputs


def _fields(kind: Any, prefix: str = "", group: str = "", skipped: Iterable[str] = ()) -> Iterable[Entry]:
    """Yield the fields of a part, a group or a member, without ports and bodies."""
    fields = specs(kind)
    for name, spec in fields.items():
        address = f"{prefix}{name}"
        if name in skipped or isinstance(spec, PortSpec | BodySpec):
            continue
        if isinstance(spec, GroupSpec):
            yield from _fields(spec.group, f"{address}.", address)
        elif isinstance(spec, MemberSpec):
            yield from _fields(spec.part, f"{address}.", address, spec.inherited)
        else:
            yield {"name": address, "group": group, **_field(name, spec, kind)}


def _groups(kind: Any, prefix: str = "", skipped: Iterable[str] = ()) -> Iterable[Entry]:
    """Yield the groups and members of a part, and those within them."""
    for field, _, spec in declared(kind, GroupSpec, MemberSpec):
        if field not in skipped:
            is_member = isinstance(spec, MemberSpec)
            yield _group(f"{prefix}{field}", spec)
            yield from _groups(
                spec.part if is_member else spec.group, f"{prefix}{field}.", spec.inherited if is_member else ()
            )


def _group(name: str, spec: GroupSpec | MemberSpec) -> Entry:
    sizes: tuple[str, ...] = ()
    if isinstance(spec, MemberSpec):
        sizes = tuple(f"{name}.{size}" for size in spec.part.sizes if size not in spec.inherited)
    return {"name": name, "doc": spec.doc, "optional": spec.optional, "sizes": list(sizes)}


def _field(name: str, spec: Spec, owner: Any) -> Entry:
    """Return the declaration of one field of the class `owner`."""
    match spec:
        case NumberSpec():
            limits = {key: getattr(spec, key) for key in ("low", "high", "above", "below")}
            return {
                "type": "number",
                "doc": spec.doc,
                # A library set (`data`) or a component (`model`) can supply omitted values.
                "required": not spec.optional and spec.default is None and not {"data", MODEL} & specs(owner).keys(),
                "unit": spec.unit,
                "quantity": spec.kind,
                "units": list(UNITS.get((spec.unit, spec.kind), ("" if spec.unit == "1" else spec.unit,))),
                "varies": spec.varies is not None,
                "default": spec.default,
                "source": spec.source,
                "note": spec.note,
                **{key: limit for key, limit in limits.items() if math.isfinite(limit)},
            }
        case OptionSpec():
            return {
                "type": "switch" if spec.choices == OFF_ON else "option",
                "doc": spec.doc,
                "required": False,
                "choices": list(spec.choices),
                "default": spec.choices[0],
            }
        case ReferenceSpec():
            return {
                "type": "model" if name == MODEL else "reference",
                "doc": spec.doc,
                "required": False,
                "form": spec.form,
                **(component_choices(owner, components()) if name == MODEL else {"choices": _choices(name)}),
            }
    raise TypeError(spec)


def component_choices(kind: type[Part], items: Iterable[CatalogueComponent]) -> Entry:
    """Return the values of the field `model` for components: names, numbers, options and sources."""
    items = [component for component in items if kind.kind in component.kinds]
    return {
        "choices": sorted({name for component in items for name in component.names}),
        "components": [
            {
                "names": list(component.names),
                "sets": {field: number.display() for field, number in numbers_of(component, kind).items()},
                "options": {option: list(words) for option, words in component.options.items()},
                "source": component.locator,
            }
            for component in items
        ],
    }


def _choices(name: str) -> list[str]:
    """Return the names that a reference can contain."""
    match name:
        case "data":
            return [choice for choice in library.sets() if choice != "gases"]
        case "characteristic":
            return list(library.characteristics())
    return []
