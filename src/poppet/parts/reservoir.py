"""A reservoir: gas at a prescribed pressure and temperature, however much flows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.parts.fields import NumberLike, anr_temperature, number
from poppet.parts.part import GasBalance, GasState, Input, Scope, Store


@dataclass(frozen=True)
class Reservoir(Store):
    """Gas at a prescribed state: a supply line, the open air.

    Parameters
    ----------
    pressure : number
        Absolute pressure [Pa]; also an input, so that a signal may drive it.
    temperature : number
        Temperature [K]; also an input.

    Notes
    -----
    Its output `mass_flow_rate` [kg/s] is what it gives to all that it is joined to: positive from a supply, negative
    where gas flows into it, as into the open air behind a silencer.

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

    def inputs(self) -> tuple[Input, ...]:
        return (
            Input("pressure", "Pa", "pressure", kind="pressure", low=0.0),
            Input("temperature", "K", "temperature", kind="temperature", low=1.0),
        )

    def gas(self, scope: Scope) -> GasState:
        return GasState(scope.inputs["pressure"], scope.inputs["temperature"])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        # Its state is prescribed, so flows change nothing but what a flow meter beside it would show.
        return GasBalance({}, totals={"mass_flow_rate": (-sum(mass for mass, _ in flows), "kg/s")})
