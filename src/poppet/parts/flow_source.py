"""A flow source: a prescribed mass flow rate, from a number, a signal or a recording."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from poppet.core.symbolic import where
from poppet.parts.fields import NumberLike, anr_temperature, number, port
from poppet.parts.part import Flow, GasState, Input, Passage, PassageFlows, Scope


@dataclass(frozen=True)
class FlowSource(Passage):
    """A prescribed mass flow rate into a store (negative: out of it).

    Parameters
    ----------
    to : str
        The store that it feeds.
    mass_flow_rate : number
        Mass flow rate into the store [kg/s]; also an input. Volumetric flow needs its reference: `10 l/min ANR`.
    temperature : number
        Temperature of the gas that flows in [K]; gas drawn out leaves with the temperature of the store.
    delay : number
        Time by which a signal arrives later [s], as behind a slow flow meter.

    Examples
    --------
    >>> float(FlowSource(to="tank", mass_flow_rate="60 g/min").mass_flow_rate)
    0.001
    """

    kind: ClassVar[str] = "flow_source"
    summary: ClassVar[str] = "a prescribed mass flow rate into a store"

    to: str | None = port("store that is fed")
    mass_flow_rate: NumberLike = number("kg/s", 0.0, doc="mass flow rate", kind="mass_flow", note="no flow by default")
    temperature: NumberLike = anr_temperature("temperature")
    delay: NumberLike = number("s", 0.0, doc="delay of the signal", low=0.0, note="no delay by default")

    def inputs(self) -> tuple[Input, ...]:
        return (Input("mass_flow_rate", "kg/s", "mass_flow_rate", kind="mass_flow", delay="delay"),)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        mass = scope.inputs["mass_flow_rate"]
        temperature = where(mass > 0.0, scope["temperature"], gas["to"].temperature)
        enthalpy = scope.surroundings.heat_capacity_pressure * temperature * mass
        return PassageFlows((Flow("mass_flow_rate", None, "to", mass, enthalpy),), {"mass_flow_rate": (mass, "kg/s")})
