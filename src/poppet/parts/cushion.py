"""Cushioning of a cylinder: near the end the piston's spear shuts the port, trapped air leaves by a throttle."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip, maximum, minimum, where
from poppet.laws.iso6358 import conductance_from_effective_area
from poppet.parts import moving_gas
from poppet.parts.fields import NumberLike, body, laminar_limit, number, option, port, subsonic_index_m
from poppet.parts.flow_path import iso_flow
from poppet.parts.part import SELF, GasBalance, GasState, Passage, PassageFlows, Scope, State, Store, Surroundings

CAP, ROD = "cap", "rod"
LEAST_LEFT = 0.01
"""Part of the dead volume that remains however far a piston is pressed into its stop."""


def depth_of(side: str, scope: Scope) -> tuple[Any, float]:
    """Distance of the piston from a cover, and the sign with which it grows with the piston's way from the cap."""
    from_cap = scope["offset"] + scope["direction"] * scope.body.position
    return (from_cap, 1.0) if side == CAP else (scope["stroke_length"] - from_cap, -1.0)


def ring_area(outer: Any, inner: Any) -> Any:
    """Area of a ring of these diameters."""
    return 0.25 * math.pi * (outer**2 - inner**2)


def spear_way(depth: Any, length: Any, closing_length: Any) -> tuple[Any, Any]:
    r"""Way of a spear in its bore, counted from the end of the stroke, and the part of the bore that it closes.

    Inside (depth y below the length L) the way is y and the bore closed; over the closing length l beyond, the way
    comes to rest and the bore opens as the cubic of s = (y - L)/l, of which the way is the integral: what the gas does
    on the spear is then exactly what the volumes say.
    """
    s = clip((depth - length) / closing_length, 0.0, 1.0)
    return minimum(depth, length) + closing_length * s * (1.0 - s * s * (1.0 - 0.5 * s)), 1.0 - s * s * (3.0 - 2.0 * s)


@dataclass(frozen=True)
class Cushion(Store, Passage):
    """The gas between a piston and its cover, and its ways to the port; a member of `Cylinder`.

    Parameters
    ----------
    body, side, port, outer_diameter, inner_diameter, stroke_length, offset, direction
        Told by the cylinder.
    length : number
        Way before the end of the stroke on which the spear shuts the port [m].
    diameter : number
        Diameter of the spear, which is that of its bore in the cover [m].
    dead_volume : number
        Trapped volume with the piston at the cover, part of that of the side [m^3].
    sonic_conductance, critical_ratio : number
        The throttle.
    check_conductance : number
        Sonic conductance of a check valve that lets air in for the start [m^3/(s Pa)].
    closing_length : number
        Way over which the spear closes its bore [m]; default a quarter of its diameter, where the ring between edge
        and spear is as large as the bore.
    open_conductance : number
        Sonic conductance of the open bore [m^3/(s Pa)]; default that of an ideal nozzle of its area.
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start; default those of the side.
    subsonic_index, laminar_ratio : number
        As in every passage.
    """

    kind: ClassVar[str] = "cushion"
    summary: ClassVar[str] = "the cushion of a cylinder"

    body: str | None = body("body of the cylinder")
    side: str = option(CAP, ROD, doc="side")
    port: str | None = port("space at the port")
    outer_diameter: NumberLike = number("m", doc="outer diameter of the ring under pressure", above=0.0)
    inner_diameter: NumberLike = number("m", 0.0, doc="inner diameter of the ring under pressure", low=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero")
    direction: NumberLike = number("1", 1.0, doc="direction")
    length: NumberLike = number("m", doc="length of the cushion", above=0.0)
    diameter: NumberLike = number("m", doc="diameter of the spear", above=0.0)
    dead_volume: NumberLike = number("m^3", doc="trapped volume at the end of the stroke", above=0.0)
    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the throttle", low=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0, note="of a small orifice")
    check_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="check valve's C", low=0.0, note="no check valve")
    closing_length: NumberLike = number("m", optional=True, doc="way over which the spear closes", above=0.0)
    open_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="C of the open bore", above=0.0)
    initial_pressure: NumberLike = number("Pa", optional=True, doc="initial pressure", kind="pressure", above=0.0)
    initial_temperature: NumberLike = number(
        "K", optional=True, doc="initial temperature", kind="temperature", above=0.0
    )
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("closing_length", 0.25 * values["diameter"])
        values["spear_area"] = ring_area(values["diameter"], values["inner_diameter"])
        if "open_conductance" not in values:
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            nozzle = conductance_from_effective_area(values["spear_area"], **gas)
            values["open_conductance"] = ambient.stated_size(nozzle.sonic_conductance, nozzle.critical_ratio)[0]
        return values

    def states(self) -> tuple[State, ...]:
        return moving_gas.STATES

    def start(self, scope: Scope) -> dict[str, Any]:
        return moving_gas.begun(scope, self._volume(scope)[0])

    def gas(self, scope: Scope) -> GasState:
        return moving_gas.state_of(scope, self._volume(scope)[0])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        volume, area = self._volume(scope)
        growth = area * scope["direction"] * scope.body.velocity
        return moving_gas.balance(scope, self.gas(scope), volume, growth, flows)

    def _volume(self, scope: Scope) -> tuple[Any, Any]:
        """Volume, and the area by which it grows with the piston's way from the cap."""
        area = ring_area(scope["outer_diameter"], scope["inner_diameter"])
        depth, sign = depth_of(self.side, scope)
        way, closed = spear_way(depth, scope["length"], scope["closing_length"])
        volume = scope["dead_volume"] + area * depth - scope["spear_area"] * way
        least = LEAST_LEFT * scope["dead_volume"]
        return maximum(volume, least), where(volume > least, sign * (area - scope["spear_area"] * closed), 0.0)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        ends = (gas["port"], self.gas(scope))
        _, closed = spear_way(depth_of(self.side, scope)[0], scope["length"], scope["closing_length"])
        inwards = where(ends[0].pressure > ends[1].pressure, scope["check_conductance"], 0.0)
        conductance = scope["sonic_conductance"] + (1.0 - closed) * scope["open_conductance"] + inwards
        size = conductance, scope["critical_ratio"]
        flow, outputs = iso_flow(scope, "mass_flow_rate", ("port", SELF), ends, size)
        return PassageFlows((flow,), outputs)
