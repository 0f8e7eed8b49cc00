"""A plain ISO 6358 passage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.laws.curves.characteristic import ANYWHERE
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.flow_path import FlowPath, iso_flow
from poppet.parts.part import Flow, GasState, Input, PassageFlows, Quantities, Scope


def from_to(scope: Scope, gas: Mapping[str, GasState], size: tuple[Any, Any], **law: Any) -> PassageFlows:
    """The one flow of a passage whose ports are called `from` and `to`."""
    flow, outputs = iso_flow(scope, "mass_flow_rate", ("from", "to"), (gas["from"], gas["to"]), size, **law)
    return PassageFlows((flow,), outputs)


def way(
    scope: Scope, gas: Mapping[str, GasState], name: str, ends: tuple[str, str], size: tuple[Any, Any]
) -> tuple[Flow, Quantities]:
    """One of the flows of a part that has several; its outputs begin with its name."""
    first, second = ends
    return iso_flow(scope, f"{name}_mass_flow_rate", ends, (gas[first], gas[second]), size, regime=f"{name}_regime")


@dataclass(frozen=True)
class Orifice(FlowPath):
    """A restriction, fitting, line or valve seat with known sonic conductance and critical ratio.

    Parameters
    ----------
    from_ : str
        Store at the first port (`from` in a circuit file).
    to : str
        Store at the second port; flow from first to second is positive.
    sonic_conductance : number
        Sonic conductance C [m^3/(s Pa)], or one of the five other ways to say how much flows.
    critical_ratio : number
        Critical ratio b.
    opening : number
        Fraction of the conductance that is open, 0..1; also an input.
    stroke : number
        Stroke [m], with a characteristic; also an input.

    Examples
    --------
    >>> bleed = Orifice(from_="tank", to="room", sonic_conductance="1.2 dm^3/(s bar)", critical_ratio=0.3)
    >>> float(bleed.sonic_conductance)
    1.2e-08
    """

    kind: ClassVar[str] = "orifice"
    has_stroke: ClassVar[bool] = True
    summary: ClassVar[str] = "an ISO 6358 passage: C, b, m; or Kv, Cv, qNn, effective area, characteristic"

    from_: str | None = port("store at the first port")
    to: str | None = port("store at the second port")
    opening: NumberLike = number("1", 1.0, doc="opening", low=0.0, high=1.0, note="fully open by default")
    stroke: NumberLike = number("m", optional=True, doc="stroke")

    def check(self) -> None:
        super().check()
        if self.stroke is not None and self.characteristic is None:
            raise InputError("parts.idle_stroke", "stroke")

    def inputs(self) -> tuple[Input, ...]:
        opening = Input("opening", "1", "opening", low=0.0, high=1.0)
        if self.characteristic is None:
            return (opening,)
        return Input("stroke", "m", "stroke" if self.stroke is not None else 0.0), opening

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        return {"stroke": (self.characteristic, ANYWHERE)} if self.characteristic is not None else {}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, scope.inputs.get("stroke"))
        return from_to(scope, gas, (conductance * scope.inputs["opening"], ratio))
