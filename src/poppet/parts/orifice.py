"""Orifice: a flow path after ISO 6358 between two ports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.laws.curves.characteristic import ANYWHERE
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.flow_path import FlowPath, iso_flow
from poppet.parts.part import Flow, GasState, Input, PassageFlows, Quantities, Scope


def single_flow(scope: Scope, gas: Mapping[str, GasState], size: tuple[Any, Any], **law: Any) -> PassageFlows:
    """Return the flow of a flow path with the ports `from` and `to`."""
    flow, outputs = iso_flow(scope, "mass_flow_rate", ("from", "to"), (gas["from"], gas["to"]), size, **law)
    return PassageFlows((flow,), outputs)


def named_flow(
    scope: Scope, gas: Mapping[str, GasState], name: str, ends: tuple[str, str], size: tuple[Any, Any]
) -> tuple[Flow, Quantities]:
    """Return one of several flows of a part; the names of its outputs begin with its name."""
    first, second = ends
    return iso_flow(scope, f"{name}_mass_flow_rate", ends, (gas[first], gas[second]), size, regime=f"{name}_regime")


@dataclass(frozen=True)
class Orifice(FlowPath):
    """Restriction, fitting, line or valve seat with a sonic conductance and a critical ratio.

    Flow from the first to the second port is positive. A characteristic needs a stroke.

    Examples
    --------
    >>> bleed = Orifice(from_="tank", to="room", sonic_conductance="1.2 dm^3/(s bar)", critical_ratio=0.3)
    >>> float(bleed.sonic_conductance)
    1.2e-08
    """

    kind: ClassVar[str] = "orifice"
    symbol: ClassVar[symbols.Symbol | str] = symbols.RESTRICTION
    has_stroke: ClassVar[bool] = True
    summary: ClassVar[str] = "an ISO 6358 flow path: C, b, m; or Kv, Cv, qNn, effective area, characteristic"

    from_: str | None = port("gas node at the first port")
    to: str | None = port("gas node at the second port")
    opening: NumberLike = number("1", 1.0, doc="opening", low=0.0, high=1.0, note="fully open by default")
    stroke: NumberLike = number("m", optional=True, doc="stroke")

    def check(self) -> None:
        super().check()
        if self.stroke is not None and self.characteristic is None:
            raise InputError("parts.idle_stroke", "stroke")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        has_fixed_stroke = self.stroke is not None and "stroke" not in numbers.signals
        return super().caption(numbers) + ([f"x = {numbers.text(self.stroke)}"] if has_fixed_stroke else [])

    def symbol_for(self, is_driven: bool) -> symbols.Symbol | str:
        is_variable = is_driven or self.characteristic is not None
        return symbols.VARIABLE_RESTRICTION if is_variable and self.symbol is symbols.RESTRICTION else self.symbol

    def inputs(self) -> tuple[Input, ...]:
        opening = Input("opening", "1", "opening", low=0.0, high=1.0)
        if self.characteristic is None:
            return (opening,)
        return Input("stroke", "m", "stroke" if self.stroke is not None else 0.0), opening

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        return {"stroke": (self.characteristic, ANYWHERE)} if self.characteristic is not None else {}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, scope.inputs.get("stroke"))
        return single_flow(scope, gas, (conductance * scope.inputs["opening"], ratio))
