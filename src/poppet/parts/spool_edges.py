"""Flow capacity of the four metering edges of a spool valve with five ports."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import ErrorCollector
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, is_symbolic
from poppet.laws.curves import Characteristic
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import FaultEffect, Valve
from poppet.parts.fields import NumberLike, NumberSpec, number, option, reference, specs
from poppet.parts.flow_path import FlowPath, characteristic_at
from poppet.parts.part import Scope, Surroundings
from poppet.parts.spool_functions import (
    FIELDS,
    FUNCTIONS,
    SpoolFunction,
    edge_opening,
    function_of,
    possible_defaults,
    used_field,
)

EDGES = {
    "supply_a": ("supply", "a", 1.0),
    "supply_b": ("supply", "b", -1.0),
    "exhaust_a": ("a", "exhaust_a", -1.0),
    "exhaust_b": ("b", "exhaust_b", 1.0),
}
"""Mapping from each metering edge to the ports that it connects and the side of the centre on which it opens."""
_INHERITS = {"supply_b": "supply_a", "exhaust_a": "supply_a", "exhaust_b": "exhaust_a"}
EDGE_TABLES = tuple(f"{edge}_characteristic" for edge in _INHERITS)
"""Fields with the tables of the edges that have a default."""
_CURVES = {"supply_a": "characteristic", **dict(zip(_INHERITS, EDGE_TABLES, strict=True))}
"""Field with the table of C and b for each edge."""
_SCALARS = {"conductance": "sonic_conductance", "ratio": "critical_ratio"}
"""Fields for the edge from the supply to port a; those of the other edges begin with the name of the edge."""
_IN_TABLES = ("overlap", "exhaust_overlap", "centre_conductance", "centre_ratio", "leak_conductance")
"""Fields without effect if all edges have a table."""


@dataclass(frozen=True)
class MeteringEdges(Valve, FlowPath):
    """Base class of spool valves: function, and flow capacities of the edges from supply and ports to exhausts."""

    has_stroke: ClassVar[bool] = True

    function: str = option(*FUNCTIONS, doc="function; positions and inputs")
    overlap: NumberLike = number(
        "1", 0.0, doc="overlap o of the supply edges", low=-1.0, below=1.0, note="none", varies=used_field("overlap")
    )
    exhaust_overlap: NumberLike = number("1", optional=True, doc="overlap o of the exhaust edges", low=-1.0, below=1.0)
    supply_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 1 to 2", low=0.0)
    supply_b_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 1 to 2", low=0.0, below=1.0)
    supply_b_characteristic: Any = reference(doc="C and b from 1 to 2 at positions of the spool; table or .toml file")
    exhaust_a_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 4 to 5", low=0.0)
    exhaust_a_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 4 to 5", low=0.0, below=1.0)
    exhaust_a_characteristic: Any = reference(doc="C and b from 4 to 5 at positions of the spool; table or .toml file")
    exhaust_b_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C from 2 to 3", low=0.0)
    exhaust_b_ratio: NumberLike = number("1", optional=True, doc="critical ratio b from 2 to 3", low=0.0, below=1.0)
    exhaust_b_characteristic: Any = reference(doc="C and b from 2 to 3 at positions of the spool; table or .toml file")
    centre_conductance: NumberLike = number(
        "m^3/(s Pa)", optional=True, doc="conductance C of the open edges at the centre", low=0.0
    )
    centre_ratio: NumberLike = number(
        "1", optional=True, doc="critical ratio b of the open edges at the centre", low=0.0, below=1.0
    )
    leak_conductance: NumberLike = number(
        "m^3/(s Pa)", 0.0, doc="conductance C of a closed edge", low=0.0, note="tight"
    )

    def check(self) -> None:
        super().check()
        with ErrorCollector() as errors:
            for name in self._curves():
                with errors.collecting():
                    object.__setattr__(self, name, self.read_curve(name))
            for edge, parent in _INHERITS.items():
                curve = self._curve_of(edge)
                for size in _SCALARS:
                    if curve is not None and getattr(self, f"{edge}_{size}") is not None:
                        errors.add("spool.two_sizes", f"{edge}_{size}", curve=curve[0])
                if curve is None and getattr(self, f"{edge}_ratio") is None and self._curve_of(parent) is not None:
                    errors.add("spool.no_ratio", f"{edge}_ratio")
            if all(self._curve_of(edge) is not None for edge in EDGES):
                for name in _IN_TABLES:
                    value, spec = getattr(self, name), specs(type(self))[name]
                    assert isinstance(spec, NumberSpec)
                    is_default = value is None or is_symbolic(value.value) or value in possible_defaults(name, spec)
                    if not is_default:
                        errors.add("spool.idle_with_curves", name)

    @property
    def spool_function(self) -> SpoolFunction:
        """Inputs and positions of the function of the valve."""
        return function_of(self)

    def _curves(self) -> dict[str, Characteristic]:
        """Return the tables of the edges by field."""
        return {name: curve for name in _CURVES.values() if (curve := getattr(self, name)) is not None}

    def _curve_of(self, edge: str) -> tuple[str, float] | None:
        """Return the field with the table of an edge, and the factor on the position of the spool.

        The factor is -1 for the table of an edge that opens on the other side. The result is None without a table.
        """
        if getattr(self, field := _CURVES[edge]) is not None:
            return field, 1.0
        if edge not in _INHERITS or getattr(self, f"{edge}_conductance") is not None:
            return None
        inherited = self._curve_of(_INHERITS[edge])
        return None if inherited is None else (inherited[0], -inherited[1])

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return super().caption(numbers) if self.characteristic is None else ["C and b: tables of the position"]

    def numbers(self) -> dict[str, Number]:
        values = super().numbers()
        for name, curve in self._curves().items():
            values |= {f"{name}.{key}": value for key, value in curve.numbers().items()}
        return values

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        for name, curve in self._curves().items():
            values |= {f"{name}.{key}": value for key, value in curve.parameters().items()}
        for edge, parent in _INHERITS.items():
            for size, first in _SCALARS.items() if self._curve_of(edge) is None else ():
                source = first if parent == "supply_a" else f"{parent}_{size}"
                if f"{edge}_{size}" not in values:
                    values[f"{edge}_{size}"] = values[source]
        if "overlap" in values:
            values.setdefault("exhaust_overlap", values["overlap"])
        return values

    def structure(self) -> Hashable:
        at_centre = tuple(name for name in ("centre_conductance", "centre_ratio") if getattr(self, name) is not None)
        tables = tuple((name, curve.structure()) for name, curve in self._curves().items())
        scalars = tuple(edge for edge in EDGES if self._curve_of(edge) is None)
        return super().structure(), at_centre, tables, scalars

    def edge_size(self, scope: Scope, edge: str) -> tuple[Any, Any]:
        """Return sonic conductance [m^3/(s Pa)] and critical pressure ratio [1] of an edge at the present position."""
        position, curve, fault = scope.states["position"], self._curve_of(edge), FaultEffect.of(scope)
        (_, _, side), kind = EDGES[edge], edge.partition("_")[0]
        if curve is not None:
            field, factor = curve
            table, prefix = getattr(self, field), f"{field}."
            conductance, ratio = characteristic_at(table, scope, prefix, factor * position)
            open_conductance, _ = characteristic_at(table, scope, prefix, factor * side)
            return fault.leaking(conductance, open_conductance), ratio
        names = _SCALARS if edge == "supply_a" else {size: f"{edge}_{size}" for size in _SCALARS}
        conductance, ratio = (scope[name] for name in names.values())
        travel, open_conductance = side * position, conductance
        if kind == self.spool_function.open_at_centre:
            fraction = clip(travel, 0.0, 1.0)
            if self.centre_conductance is not None:
                conductance = scope["centre_conductance"] + (conductance - scope["centre_conductance"]) * fraction
            if self.centre_ratio is not None:
                ratio = scope["centre_ratio"] + (ratio - scope["centre_ratio"]) * fraction
        overlap = "overlap" if kind == "supply" else "exhaust_overlap"
        start = scope[overlap] if self.function in FIELDS[overlap] else 0.0
        opening, leak = edge_opening(self.spool_function, kind, travel, start), scope["leak_conductance"]
        return fault.leaking(leak + (conductance - leak) * opening, open_conductance), ratio
