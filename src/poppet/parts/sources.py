"""Reservoirs and flow sources: prescribed gas states and mass flow rates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, anr_temperature, number, port
from poppet.parts.part import Flow, GasBalance, GasState, Input, Passage, PassageFlows, Scope, Store


@dataclass(frozen=True)
class Reservoir(Store):
    """Gas node with prescribed pressure and temperature, such as a supply line or the ambient.

    Notes
    -----
    The output `mass_flow_rate` [kg/s] is the sum of the flows out of the reservoir. It is positive for a supply, and
    negative if gas flows into the reservoir, for example from a silencer.

    Examples
    --------
    >>> Reservoir(pressure="6 bar g").pressure.display()
    '6 bar g'
    """

    kind: ClassVar[str] = "reservoir"
    symbol: ClassVar[symbols.Symbol | str] = symbols.RESERVOIR
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


@dataclass(frozen=True)
class FlowSource(Passage):
    """Source with a prescribed mass flow rate into a gas node.

    A negative flow rate removes gas from the node. This gas has the temperature of the node. A volume flow must be
    stated with its reference condition, for example `10 l/min ANR`.

    Examples
    --------
    >>> float(FlowSource(to="tank", mass_flow_rate="60 g/min").mass_flow_rate)
    0.001
    """

    kind: ClassVar[str] = "flow_source"
    symbol: ClassVar[symbols.Symbol | str] = symbols.FLOW_SOURCE
    summary: ClassVar[str] = "a prescribed mass flow rate into a store"

    to: str | None = port("gas node that receives the flow")
    mass_flow_rate: NumberLike = number("kg/s", 0.0, doc="mass flow rate", kind="mass_flow", note="no flow by default")
    temperature: NumberLike = anr_temperature("temperature of the gas that flows in")
    delay: NumberLike = number("s", 0.0, doc="delay of the signal", low=0.0, note="no delay by default")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return ["flow source"] if "mass_flow_rate" in numbers.signals else [numbers.text(self.mass_flow_rate)]

    def inputs(self) -> tuple[Input, ...]:
        return (Input("mass_flow_rate", "kg/s", "mass_flow_rate", kind="mass_flow", delay="delay"),)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        mass = scope.inputs["mass_flow_rate"]
        temperature = where(mass > 0.0, scope["temperature"], gas["to"].temperature)
        enthalpy = scope.surroundings.heat_capacity_pressure * temperature * mass
        return PassageFlows((Flow("mass_flow_rate", None, "to", mass, enthalpy),), {"mass_flow_rate": (mass, "kg/s")})
