"""End cushion of a cylinder: near the end of the stroke, air leaves only through a throttle."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip, maximum, minimum, where
from poppet.laws.iso6358 import conductance_from_effective_area
from poppet.parts.fields import NumberLike, body, laminar_limit, number, option, port, subsonic_index_m
from poppet.parts.flow_path import iso_flow
from poppet.parts.moving_gas import MovingGasStore
from poppet.parts.part import SELF, GasState, Passage, PassageFlows, Scope, Surroundings

CAP, ROD = "cap", "rod"
MIN_DEAD_FRACTION = 0.01
"""Fraction of the dead volume that remains if the piston compresses its stop."""


def cover_distance(side: str, scope: Scope) -> tuple[Any, float]:
    """Return the distance of the piston from one cover [m], and its derivative.

    `side` is `cap` or `rod`, the side of the cover. The derivative with respect to the piston position is 1 or -1.
    """
    from_cap = scope["offset"] + scope["direction"] * scope.body.position
    return (from_cap, 1.0) if side == CAP else (scope["stroke_length"] - from_cap, -1.0)


def ring_area(outer: Any, inner: Any) -> Any:
    """Return the area of a ring with the diameters `outer` and `inner`."""
    return 0.25 * math.pi * (outer**2 - inner**2)


def spear_travel(depth: Any, length: Any, closing_length: Any) -> tuple[Any, Any]:
    r"""Return the effective travel of a spear in its bore, and the closed fraction of the bore.

    A spear is a plug on the piston that closes the bore of the port near the end of the stroke. `depth` is the distance
    y of the piston from the end of the stroke, `length` the length L of the spear, and `closing_length` the length l of
    the transition between the closed and the open bore.

    Up to y = L the travel is y, and the bore is closed. From L to L + l the closed fraction decreases to 0 by a cubic
    polynomial of s = (y - L)/l. The travel is the integral of the closed fraction over y, so the work of the gas on the
    spear is consistent with the volumes.
    """
    s = clip((depth - length) / closing_length, 0.0, 1.0)
    return minimum(depth, length) + closing_length * s * (1.0 - s * s * (1.0 - 0.5 * s)), 1.0 - s * s * (3.0 - 2.0 * s)


@dataclass(frozen=True)
class Cushion(MovingGasStore, Passage):
    """Gas between a piston and its cover, with its flow path to the port.

    It is a member part of `Cylinder`. The default of `closing_length` is a quarter of the spear diameter: at this
    distance, the gap between the spear and the edge of its bore has the area of the bore. The default of
    `open_conductance` is the conductance of an ideal nozzle with the area of the bore. The default initial pressure and
    temperature are the same as in the chamber on the same side.
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
    length: NumberLike = number("m", doc="length of the cushion before the end of the stroke", above=0.0)
    diameter: NumberLike = number("m", doc="diameter of the spear and its bore", above=0.0)
    dead_volume: NumberLike = number("m^3", doc="trapped part of the dead volume", above=0.0)
    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the throttle", low=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0, note="of a small orifice")
    check_conductance: NumberLike = number(
        "m^3/(s Pa)", 0.0, doc="check valve's sonic conductance C", low=0.0, note="no check valve"
    )
    closing_length: NumberLike = number("m", optional=True, doc="travel over which the spear closes", above=0.0)
    open_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="open bore's sonic conductance", above=0.0)
    initial_pressure: NumberLike = number("Pa", optional=True, doc="initial pressure", kind="pressure", above=0.0)
    initial_temperature: NumberLike = number(
        "K", optional=True, doc="initial temperature", kind="temperature", above=0.0
    )
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("closing_length", 0.25 * values["diameter"])
        values["spear_area"] = ring_area(values["diameter"], values["inner_diameter"])
        if "open_conductance" not in values:
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            nozzle = conductance_from_effective_area(values["spear_area"], **gas)
            values["open_conductance"] = ambient.capacity_as_stated(nozzle.sonic_conductance, nozzle.critical_ratio)[0]
        return values

    def volume_and_area(self, scope: Scope) -> tuple[Any, Any]:
        area = ring_area(scope["outer_diameter"], scope["inner_diameter"])
        depth, sign = cover_distance(self.side, scope)
        travel, closed = spear_travel(depth, scope["length"], scope["closing_length"])
        volume = scope["dead_volume"] + area * depth - scope["spear_area"] * travel
        smallest = MIN_DEAD_FRACTION * scope["dead_volume"]
        return maximum(volume, smallest), where(volume > smallest, sign * (area - scope["spear_area"] * closed), 0.0)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        ends = (gas["port"], self.gas(scope))
        _, closed = spear_travel(cover_distance(self.side, scope)[0], scope["length"], scope["closing_length"])
        check_valve = where(ends[0].pressure > ends[1].pressure, scope["check_conductance"], 0.0)
        conductance = scope["sonic_conductance"] + (1.0 - closed) * scope["open_conductance"] + check_valve
        size = conductance, scope["critical_ratio"]
        flow, outputs = iso_flow(scope, "mass_flow_rate", ("port", SELF), ends, size)
        return PassageFlows((flow,), outputs)
