"""Flow capacity of components, the check of their printed flows, and the search by properties."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import ANR, quantity
from poppet.laws import iso6358
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.library.components import CatalogueComponent
from poppet.parts import KINDS
from poppet.parts.components import MODEL, numbers_of
from poppet.parts.fields import NumberSpec, specs

NAMES = {
    "C": "sonic_conductance",
    "b": "critical_ratio",
    "qNn": "nominal_flow",
    "flow": "nominal_flow",
    "Cv": "flow_coefficient_cv",
    "stroke": "stroke_length",
    "rod": "rod_diameter",
    "t_on": "switching_time",
    "t_off": "closing_time",
}
"""Short names of fields in a search."""
_RELATIONS: Mapping[str, Callable[[float, float], bool]] = {
    "<=": operator.le, ">=": operator.ge, "<": operator.lt, ">": operator.gt, "=": operator.eq,
}  # fmt: skip
_TERM = re.compile(r"(?P<name>\w+)\s*(?P<relation><=|>=|<|>|=)\s*(?P<value>\S.*)")
_QUANTITY_WITHOUT_RELATION = re.compile(rf"({'|'.join(NAMES)}|bore|volume)\s+[\d.]")


@dataclass(frozen=True)
class FlowCapacity:
    """C [m^3/(s Pa)] and b [1] of a component for air; `is_assumed` is True if its document does not state b."""

    sonic_conductance: float
    critical_ratio: float
    is_assumed: bool

    def flow(self, inlet_pressure: float, outlet_pressure: float) -> float:
        """Return the flow between two absolute pressures [Pa] at 20 degC [m^3/s ANR]."""
        mass_flow_rate = iso6358.mass_flow_rate(
            inlet_pressure,
            outlet_pressure,
            ANR.temperature,
            sonic_conductance=self.sonic_conductance,
            critical_ratio=self.critical_ratio,
        )
        return float(mass_flow_rate) / ANR.density


def flow_capacity(component: CatalogueComponent) -> FlowCapacity | None:
    """Return C and b of the main flow path of a component, or None if it states no flow capacity."""
    numbers = {name: float(number) for name, number in numbers_of(component, KINDS[component.kinds[0]]).items()
               if number.reference != "gauge"}  # fmt: skip
    ratio = numbers.get("critical_ratio")
    if "sonic_conductance" in numbers:
        b = iso6358.ASSUMED_CRITICAL_RATIO if ratio is None else ratio
        return FlowCapacity(numbers["sonic_conductance"], b, ratio is None)
    if "effective_area" in numbers:
        air = {"isentropic_exponent": AIR_ISENTROPIC_EXPONENT, "gas_constant": AIR_GAS_CONSTANT}
        nozzle = iso6358.conductance_from_effective_area(numbers["effective_area"], **air)
        return FlowCapacity(nozzle.sonic_conductance, nozzle.critical_ratio, True)
    conversions: Mapping[str, Callable[..., iso6358.Conductance]] = {
        "flow_coefficient_kv": iso6358.conductance_from_flow_coefficient_kv,
        "flow_coefficient_cv": iso6358.conductance_from_flow_coefficient_cv,
        "nominal_flow": iso6358.conductance_from_nominal_flow,
    }
    for name, conversion in conversions.items():
        if name in numbers:
            result = conversion(numbers[name], critical_ratio=ratio)
            return FlowCapacity(result.sonic_conductance, result.critical_ratio, ratio is None)
    return None


def printed_flow_deviation(component: CatalogueComponent) -> tuple[float, float] | None:
    """Return the flow from C and b at the pressures of the printed flow, and its relative deviation.

    The flow has the unit m^3/s ANR, and the deviation refers to the printed flow. The result is None if the document
    states no flow with its pressures.
    """
    capacity, printed = flow_capacity(component), component.flow
    if capacity is None or printed is None:
        return None
    flow = capacity.flow(printed.inlet_pressure, printed.outlet_pressure)
    return flow, flow / printed.value - 1.0


def search(text: str, components: Iterable[CatalogueComponent]) -> list[CatalogueComponent]:
    """Return the components that fulfil all conditions of a text.

    Parameters
    ----------
    text : str
        Conditions, separated by commas: words (function, kind, manufacturer, series) and comparisons of a quantity with
        a value, such as `5/2, C > 3 dm^3/(s bar)`.
    components : iterable of CatalogueComponent
        Components to search.

    Returns
    -------
    list of CatalogueComponent
        Components in the given order.

    Raises
    ------
    InputError
        If a condition has a wrong form, an unknown quantity or unit, or a word of no component.
    """
    found = [*components]
    everything = found
    for term in (term.strip() for term in text.split(",")):
        match = _TERM.fullmatch(term)
        if match:
            holds = _comparison(match["name"], match["relation"], match["value"].strip())
            found = [component for component in found if holds(component)]
        # "bore 40" is also part of a few names, but whoever writes it means a comparison.
        elif not term or re.search(r"[<>=]", term) or _QUANTITY_WITHOUT_RELATION.match(term):
            raise InputError("components.no_condition", text=term)
        else:
            # A condition cannot contain a comma.
            words = {word for component in everything for text in _words(component) for word in text.split(", ")}
            if not any(_has_word(component, term) for component in everything):
                raise InputError("components.no_word", text=term, names=NameSuggestion(term, words).names)
            found = [component for component in found if _has_word(component, term)]
    return found


def _words(component: CatalogueComponent) -> tuple[str, ...]:
    options = (word for words in component.options.values() for word in words)
    kinds = (kind.replace("_", " ") for kind in component.kinds)
    function = str(component.printed.get("function", ""))
    return tuple(filter(None, (component.manufacturer, component.series, *kinds, *options, function)))


def _has_word(component: CatalogueComponent, word: str) -> bool:
    texts = (*_words(component), component.model, *component.aliases)
    # A whole word of a text: "5/2" is in "5/2 monostable".
    key = f" {word.replace('_', ' ').casefold()} "
    return any(key in f" {text.casefold().replace(',', ' ')} " for text in texts)


def _comparison(name: str, relation: str, value: str) -> Callable[[CatalogueComponent], bool]:
    """Return a function that compares a quantity of a component with a value."""
    valid = {
        field: spec
        for kind in KINDS.values()
        if MODEL in specs(kind)
        for field, spec in specs(kind).items()
        if isinstance(spec, NumberSpec)
    }
    field = NAMES.get(name, name)
    if field not in valid:
        raise InputError("components.no_quantity", text=name, names=NameSuggestion(name, [*NAMES, *valid]).names)
    spec = valid[field]
    try:
        limit = quantity(value, spec.unit, kind=spec.kind, name=name).value
    except InputError as error:
        raise error.located(address=name) from None
    compare = _RELATIONS[relation]

    def holds(component: CatalogueComponent) -> bool:
        own = value_of(component, field)
        return own is not None and compare(own, limit)

    return holds


def value_of(component: CatalogueComponent, field: str) -> float | None:
    """Return the value of a field of a component in SI units, or None if its document does not determine it.

    C, b and the nominal flow are computed from any flow capacity.
    """
    capacity = flow_capacity(component)
    if capacity is not None and field in ("sonic_conductance", "critical_ratio", "nominal_flow"):
        if field == "nominal_flow":
            return iso6358.nominal_flow_from_conductance(capacity.sonic_conductance, capacity.critical_ratio)
        if field == "critical_ratio":
            return None if capacity.is_assumed else capacity.critical_ratio
        return capacity.sonic_conductance
    for kind in component.kinds:
        if number := numbers_of(component, KINDS[kind]).get(field):
            return float(number.value)
    return None
