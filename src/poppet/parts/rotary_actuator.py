"""Rotary actuator: a vane or pistons with a rack turn a shaft between two end stops."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import maximum, where
from poppet.parts import symbols
from poppet.parts.bodies import Joint
from poppet.parts.captions import CaptionNumbers
from poppet.parts.cushion import MIN_DEAD_FRACTION
from poppet.parts.cylinder import Leakage
from poppet.parts.fields import (
    NumberLike,
    anr_pressure,
    anr_temperature,
    body,
    group,
    laminar_limit,
    member,
    model,
    number,
    option,
    port,
    subsonic_index_m,
)
from poppet.parts.flow_path import iso_flow
from poppet.parts.moving_compound import MovingCompound, stop_at, values_of
from poppet.parts.moving_gas import MovingGasStore
from poppet.parts.part import (
    Actuator,
    ActuatorForce,
    GasState,
    Passage,
    PassageFlows,
    Quantities,
    Scope,
    Surroundings,
)

FORWARD, BACKWARD = "forward", "backward"
LEVER = 1.0
"""Radius at which the actuator acts on its shaft [m]: the travel in metres is the angle in radians."""
_GAS_OUTPUTS = ("pressure", "temperature", "mass", "volume", "heat_flow_rate", "work_rate")
_SHARED = ("body", "displacement", "swivel_angle")


@dataclass(frozen=True)
class RotaryStop:
    """Parameters of the end stops of a rotary actuator, by the law of Hunt and Crossley."""

    stiffness: NumberLike = number("N m/rad^1.5", 1e5, doc="contact stiffness", above=0.0, note="an elastic bumper")
    dissipation: NumberLike = number(
        "s/rad",
        1.0,
        doc="contact dissipation; inverse of the speed at which damping saturates",
        low=0.0,
        note="half of the energy",
    )


@dataclass(frozen=True)
class RotaryChamber(MovingGasStore):
    """Gas chamber on one side of the vane.

    It is a member part of `RotaryActuator`.
    """

    kind: ClassVar[str] = "rotary_chamber"
    summary: ClassVar[str] = "one side of a rotary actuator"

    body: str | None = body("shaft of the actuator")
    side: str = option(FORWARD, BACKWARD, doc="side of the vane")
    displacement: NumberLike = number("m^3/rad", doc="displacement per angle", above=0.0)
    swivel_angle: NumberLike = number("rad", doc="swivel angle", above=0.0)
    dead_volume: NumberLike = number("m^3", doc="volume with the vane at this end; includes lines", above=0.0)
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        # The volume of both sides is a function of the angle of the shaft.
        return {"wall_temperature": ambient.temperature, **super().parameters(ambient), "direction": 1.0}

    def volume_and_area(self, scope: Scope) -> tuple[Any, Any]:
        angle, area = scope.body.position / LEVER, scope["displacement"] / LEVER
        depth, sign = (angle, 1.0) if self.side == FORWARD else (scope["swivel_angle"] - angle, -1.0)
        volume, smallest = (
            scope["dead_volume"] + scope["displacement"] * depth,
            MIN_DEAD_FRACTION * scope["dead_volume"],
        )
        return maximum(volume, smallest), where(volume > smallest, sign * area, 0.0)


@dataclass(frozen=True)
class Vane(Actuator, Passage):
    """Vane, or pistons with a rack, which exert a torque on the shaft.

    It is a member part of `RotaryActuator`, and includes the leakage between both chambers.
    """

    kind: ClassVar[str] = "vane"
    regimes: ClassVar[tuple[str, ...]] = ("leakage_regime",)
    summary: ClassVar[str] = "vane of a rotary actuator"

    forward: str | None = port("chamber whose pressure turns towards larger angles")
    backward: str | None = port("chamber whose pressure turns towards smaller angles")
    body: str | None = body("shaft of the actuator")
    displacement: NumberLike = number("m^3/rad", doc="displacement per angle", above=0.0)
    seal_friction: NumberLike = number("N m/Pa", 0.0, doc="seal friction per pressure difference", low=0.0)
    leakage: Any = group(Leakage, doc="leakage past the vane")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        size = scope["leakage.sonic_conductance"], scope["leakage.critical_ratio"]
        ends, states = (FORWARD, BACKWARD), (gas[FORWARD], gas[BACKWARD])
        flow, outputs = iso_flow(scope, "leakage_mass_flow_rate", ends, states, size, regime="leakage_regime")
        return PassageFlows((flow,), outputs)

    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        difference = gas[FORWARD].pressure - gas[BACKWARD].pressure
        torque = scope["displacement"] * difference
        outputs: Quantities = {"torque": (torque, "N m")}
        return ActuatorForce(torque / LEVER, outputs, friction=scope["seal_friction"] * abs(difference) / LEVER)


@dataclass(frozen=True)
class RotaryActuator(MovingCompound):
    r"""Rotary actuator with a vane, or with pistons and a rack, that turns a shaft.

    .. math:: M = D (p_f - p_b), \qquad V_f = V_{0,f} + D \varphi, \qquad V_b = V_{0,b} + D (\varphi_s - \varphi)

    Notes
    -----
    D is the displacement per angle, p_f and p_b are the pressures in the chambers `forward` and `backward`, and phi_s
    is the swivel angle. Ports of other parts are connected to the chambers by the names `NAME.forward` and
    `NAME.backward`, where NAME is the name of the actuator. The shaft is a `joint` with angle 0 at one end and
    `swivel_angle` at the other end. Its inertia includes that of the load.

    Catalogues state the torque at a pressure, often 6 bar: `rated_torque` and `rated_pressure` give the displacement
    D = M/p. A catalogue torque usually includes the friction, so this displacement is a lower bound.

    The output `torque` is the torque of the gas on the vane, without friction and end stops.

    Examples
    --------
    >>> actuator = RotaryActuator(
    ...     rated_torque="12 N m", swivel_angle="180 deg", shaft={"inertia": "0.01 kg m^2"},
    ...     forward={"dead_volume": "10 cm^3"}, backward={"dead_volume": "10 cm^3"},
    ... )
    >>> print(actuator.effective_displacement)
    2e-05 m^3/rad
    """

    kind: ClassVar[str] = "rotary_actuator"
    sizes: ClassVar[tuple[str, ...]] = ("displacement", "rated_torque")
    symbol: ClassVar[symbols.Symbol | str] = symbols.ROTARY_ACTUATOR
    summary: ClassVar[str] = "a rotary actuator: two chambers, vane or rack, shaft, end stops"
    moving: ClassVar[str] = "shaft"

    displacement: NumberLike = number("m^3/rad", optional=True, doc="displacement per angle", above=0.0)
    rated_torque: NumberLike = number(
        "N m", optional=True, doc="torque at the rated pressure; in place of `displacement`", above=0.0
    )
    rated_pressure: NumberLike = number(
        "Pa", "6 bar", doc="pressure difference of `rated_torque`", kind="pressure_difference", above=0.0,
        note="usual in catalogues",
    )  # fmt: skip
    swivel_angle: NumberLike = number("rad", doc="swivel angle", above=0.0)
    seal_friction: NumberLike = number("N m/Pa", 0.0, doc="seal friction per pressure difference", low=0.0, note="none")
    model: Any = model()
    leakage: Any = group(Leakage, doc="leakage past the vane")
    end_stop: Any = group(RotaryStop, doc="end stops")
    shaft: Any = member(Joint, doc="shaft with its load", inherited=("pulley_radius", "lower_stop", "upper_stop"))
    forward: Any = member(
        RotaryChamber, doc="chamber that turns towards larger angles", inherited=("side", *_SHARED), is_open=True
    )
    backward: Any = member(
        RotaryChamber, doc="chamber that turns towards smaller angles", inherited=("side", *_SHARED), is_open=True
    )
    vane: Any = member(
        Vane, doc="vane", inherited=(FORWARD, BACKWARD, "body", "displacement", "seal_friction", "leakage")
    )

    inlets: ClassVar[Mapping[str, str]] = {"shaft.load_torque": "shaft.load_torque"}
    outlets: ClassVar[Mapping[str, str]] = {
        **{f"{side}.{name}": f"{side}.{name}" for side in (FORWARD, BACKWARD) for name in _GAS_OUTPUTS},
        **{name: f"vane.{name}" for name in ("torque", "leakage_mass_flow_rate", "leakage_regime")},
    }
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *(f"{side}.{name}" for side in (FORWARD, BACKWARD) for name in _GAS_OUTPUTS[2:]),
        "leakage_mass_flow_rate", "leakage_regime",
    )  # fmt: skip
    resume: ClassVar[dict[str, str]] = {
        **{f"shaft.{name}": f"shaft.initial_{name}" for name in ("position", "velocity")},
        **{f"{side}.{n}": f"{side}.initial_{n}" for side in (FORWARD, BACKWARD) for n in ("pressure", "temperature")},
    }

    @property
    def effective_displacement(self) -> Number | None:
        """Displacement per angle, from the rated torque if that is given; None if both are missing."""
        values = values_of(self.rated_torque, self.rated_pressure)
        if values is None or self.displacement is not None:
            return self.displacement  # type: ignore[return-value]
        return Number(values[0] / values[1], "m^3/rad", Source("given"))

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        torque, pressure = self.rated_torque, self.rated_pressure
        size = (
            numbers.text(self.displacement) if torque is None else f"{numbers.text(torque)} at {numbers.text(pressure)}"
        )
        return ["rotary actuator", size, numbers.text(self.swivel_angle), numbers.text(self.shaft.inertia)]

    def check(self) -> None:
        if self.displacement is not None and self.rated_torque is not None:
            raise InputError("compounds.displacement_twice", "rated_torque")

    def inherited_fields(self, member: str) -> dict[str, Any]:
        shared = {"body": ".shaft", "displacement": self.effective_displacement}
        match member:
            case "shaft":
                lower, upper = (stop_at(angle, self.end_stop) for angle in (0.0, self.swivel_angle))
                return {"pulley_radius": LEVER, "lower_stop": lower, "upper_stop": upper}
            case "vane":
                own = {name: getattr(self, name) for name in ("seal_friction", "leakage")}
                return shared | own | {FORWARD: f".{FORWARD}", BACKWARD: f".{BACKWARD}"}
            case _:
                return shared | {"swivel_angle": self.swivel_angle, "side": member}
