"""Passports and lists of components as text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from poppet.core.number_format import aligned
from poppet.core.units import convert
from poppet.library.components import CatalogueComponent
from poppet.parts import KINDS
from poppet.parts.component_search import flow_capacity, printed_flow_deviation
from poppet.parts.components import numbers_of
from poppet.parts.fields import specs


def passports(components: Iterable[CatalogueComponent]) -> str:
    """Return the passports of several components, for example of all functions of a valve."""
    return "\n\n\n".join(map(passport, components))


def passport(component: CatalogueComponent) -> str:
    """Return all numbers of a component with their document, doubts, assumptions and the check of its printed flow."""
    blocks = [component.name, _table(_origin(component))]
    for kind in component.kinds:
        options = [f"{name} = {', '.join(words)}" for name, words in component.options.items()]
        head = f"as {kind}" + (f" ({'; '.join(options)})" if options else "")
        numbers = numbers_of(component, KINDS[kind])
        # Doubts are listed below, once.
        rows = [(name, n.display(), "; ".join(filter(None, (_of_file(component, name), *_kind(n.source.kind)))))
                for name, n in numbers.items()]  # fmt: skip
        blocks.append(f"{head}\n{_table(rows)}")
    if flow := [*_flow(component)]:
        blocks.append(f"nominal flow\n{_table(flow)}")
    if component.printed:
        blocks.append(f"also in the document\n{_table((name, str(text)) for name, text in component.printed.items())}")
    for title, texts in (
        ("assumed", _assumptions(component)),
        ("doubts", component.doubts),
        ("remarks", component.remarks),
    ):
        if texts:
            blocks.append("\n".join([title, *(f"  {text}" for text in texts)]))
    return "\n\n".join(blocks)


def component_list(components: Iterable[CatalogueComponent]) -> str:
    """Return a table of components: name, kinds, function, C, b and further numbers."""
    rows = [["component (?: with doubts)", "kind", "function", "C [dm^3/(s bar)]", "b", "further numbers"]]
    for component in components:
        capacity = flow_capacity(component)
        function = component.printed.get("function") or ", ".join(
            word for words in component.options.values() for word in words
        )
        size = ["", ""]
        if capacity is not None:
            size = [f"{1e8 * capacity.sonic_conductance:.4g}", f"{capacity.critical_ratio:.3g}"]
            size[1] += " assumed" if capacity.is_assumed else ""
        numbers = numbers_of(component, KINDS[component.kinds[0]])
        others = [
            f"{name.replace('_', ' ')} {number.display()}"
            for name, number in numbers.items()
            if name not in ("sonic_conductance", "critical_ratio")
        ]
        doubt = "?" if component.doubts else ""
        rows.append(
            [f"{component.name} {doubt}".rstrip(), ", ".join(component.kinds), function, *size, ", ".join(others)]
        )
    return aligned(rows, [3])


def _table(rows: Iterable[tuple[str, ...]]) -> str:
    return aligned([(f"  {name}", *rest) for name, *rest in rows], [])


def _origin(component: CatalogueComponent) -> Iterator[tuple[str, str]]:
    entries = {
        "other names": ", ".join(component.aliases),
        "series": component.series,
        "document": component.document,
        "date": component.year,
        "page": component.page,
        "read from": component.copy,
    }
    return ((name, text) for name, text in entries.items() if text)


def _of_file(component: CatalogueComponent, name: str) -> str:
    value = component.fields[name]
    return str(value.get("note", "")) if isinstance(value, dict) else ""


def _kind(kind: str) -> tuple[str, ...]:
    return () if kind == "datasheet" else (kind,)


def _flow(component: CatalogueComponent) -> Iterator[tuple[str, str]]:
    printed, computed = component.flow, printed_flow_deviation(component)
    if printed is None:
        return
    texts = printed.texts
    condition = f"from {texts['inlet_pressure']} to {texts['outlet_pressure']}"
    yield "printed", f"{texts['value']} {condition} ({_litres(printed.value)})"
    if computed is not None:
        flow, deviation = computed
        yield "from C and b", f"{_litres(flow)}, deviation {100.0 * deviation:+.2f} %"


def _litres(flow: float) -> str:
    return f"{convert(flow, 'm^3/s ANR', 'l/min ANR'):.4g} l/min ANR"


def _assumptions(component: CatalogueComponent) -> list[str]:
    capacity, texts = flow_capacity(component), []
    if capacity is not None and capacity.is_assumed:
        texts.append(f"critical back-pressure ratio b = {capacity.critical_ratio:.3g}: the document does not state it")
    if capacity is not None and _has_assumed_exhaust(component):
        texts.append("flow capacity of the exhaust: the document does not state it, so that of the supply path is used")
    return texts


def _has_assumed_exhaust(component: CatalogueComponent) -> bool:
    """Return True if a component has a flow path to an exhaust whose flow capacity its document does not state."""
    has_port = not component.ports or any(port.startswith("exhaust") for port in component.ports)
    declared = {name for kind in component.kinds for name in specs(KINDS[kind])}
    fields = declared & {"exhaust_conductance", "exhaust_a_conductance"}
    return has_port and bool(fields) and not fields & component.fields.keys()
