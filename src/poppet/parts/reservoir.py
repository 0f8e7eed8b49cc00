"""Reservoir: gas at a prescribed pressure and temperature."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, anr_temperature, number
from poppet.parts.part import GasBalance, GasState, Input, Scope, Store


@dataclass(frozen=True)
class Reservoir(Store):
    """Gas at a prescribed state, such as a supply line or the ambient.

    Notes
    -----
    The output `mass_flow_rate` [kg/s] is the sum of the flows out of the reservoir: positive for a supply, negative if
    gas flows in, as behind a silencer.

    Examples
    --------
    >>> Reservoir(pressure="6 bar g").pressure.display()
    '6 bar g'
    """

    kind: ClassVar[str] = "reservoir"
    summary: ClassVar[str] = "gas at a prescribed pressure and temperature"
    internal_outputs: ClassVar[tuple[str, ...]] = ("mass_flow_rate",)

    pressure: NumberLike = number("Pa", doc="pressure", kind="pressure", low=0.0)
    temperature: NumberLike = anr_temperature("temperature")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [numbers.text(self.pressure), numbers.text(self.temperature)]

    def inputs(self) -> tuple[Input, ...]:
        return (
            Input("pressure", "Pa", "pressure", kind="pressure", low=0.0),
            Input("temperature", "K", "temperature", kind="temperature", low=1.0),
        )

    def gas(self, scope: Scope) -> GasState:
        return GasState(scope.inputs["pressure"], scope.inputs["temperature"])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        # The state is prescribed: flows change the flow rate output only.
        return GasBalance({}, totals={"mass_flow_rate": (-sum(mass for mass, _ in flows), "kg/s")})
