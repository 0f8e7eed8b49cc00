"""Main stage of a piloted pressure valve: plate, supply poppet and exhaust seat."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import maximum, smoothstep, sqrt, where
from poppet.laws.curves import Characteristic
from poppet.laws.physics import contact
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import FaultEffect, Valve
from poppet.parts.fields import NumberLike, group, laminar_limit, number, option, port, reference, subsonic_index_m
from poppet.parts.flow_path import characteristic_at, named_flow, read_characteristic
from poppet.parts.part import GasState, Input, Passage, PassageFlows, Quantities, Scope, State, Surroundings

_MODES = ("paper", "regulator")
# In the order of a recording: states, flows, then codes.
OUTPUTS = (
    "stroke", "velocity", "supply_mass_flow_rate", "exhaust_mass_flow_rate",
    "supply_regime", "exhaust_regime", "contact",
)  # fmt: skip
CLOSED = ".closed"
"""Default variant of a library characteristic: a closed poppet must not leak."""
LOOSER = 300.0
"""Tolerance of the mechanics per tolerance of the gas states.

On the paper's staircase it saves a quarter of the steps without a larger error of the pressure."""


@dataclass(frozen=True)
class Spring:
    """Parameters of a linear spring of a main stage.

    The preload is a length, not a force: the compression of the spring at stroke zero.
    """

    rate: NumberLike = number("N/m", doc="spring rate", low=0.0)
    preload: NumberLike = number("m", doc="compression at stroke zero", low=0.0)


@dataclass(frozen=True)
class Stop:
    """End stop of the plate by the law of Hunt and Crossley.

    The force is k d^1.5 with the stiffness k and the depth d of penetration, multiplied by a damping factor.
    """

    position: NumberLike = number("m", doc="stroke at the stop")
    stiffness: NumberLike = number("N/m^1.5", doc="contact stiffness", above=0.0)
    dissipation: NumberLike = number(
        "s/m", doc="contact dissipation; inverse of the speed at which damping saturates", low=0.0
    )


@dataclass(frozen=True)
class Contact:
    """Parameters of the contact between plate and poppet of a main stage at stroke zero.

    At positive strokes, the plate lifts the poppet, and the lower spring acts on the plate.
    """

    width: NumberLike = number(
        "m", doc="width of the contact; range of strokes below zero in which the lower spring force changes", above=0.0
    )
    dissipation: NumberLike = number(
        "s/m", doc="contact dissipation; inverse of the speed at which damping saturates", low=0.0
    )


@dataclass(frozen=True)
class Exhaust:
    """Parameters of the exhaust seat of a main stage.

    The seat opens at strokes below minus `overlap`, a field of the main stage. It is fully open after a further stroke
    of `opening`.
    """

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the exhaust", low=0.0)
    critical_ratio: NumberLike = number("1", doc="critical ratio b of the exhaust", low=0.0, below=1.0)
    opening: NumberLike = number("m", doc="stroke over which the exhaust opens", above=0.0)


@dataclass(frozen=True)
class Friction:
    """Parameters of the Stribeck friction of the plate of a main stage."""

    coulomb: NumberLike = number("N", 0.0, doc="Coulomb friction", low=0.0, note="none by default")
    static: NumberLike = number("N", optional=True, doc="breakaway friction", low=0.0)
    stribeck_velocity: NumberLike = number("m/s", "5 mm/s", doc="Stribeck velocity", above=0.0)
    smoothing_velocity: NumberLike = number("m/s", "0.5 mm/s", doc="velocity of full Coulomb friction", above=0.0)
    viscous: NumberLike = number("N s/m", 0.0, doc="viscous friction", low=0.0, note="none by default")


@dataclass(frozen=True)
class MainStage(Valve, Passage):
    r"""Main stage of a piloted pressure valve by the equations of Varga & Keski-Honkola 2012.

    One coordinate, the stroke x of the plate, describes filling, overlap and emptying.

    A stroke x > 0 lifts the supply poppet against both springs. A stroke x < 0 opens the exhaust seat against the upper
    spring alone. Between 0 and minus the overlap both seats are closed.

    .. math:: m_p \ddot x + d \dot x + k_1 (h_1 + x) + k_2 (h_2 + x) = S p_p \quad (x > 0)

    .. math:: m_o \ddot x + d \dot x + k_1 (h_1 + x) = S p_o \quad (x < 0)

    Notes
    -----
    In the mode `paper`, the equations are eqs (5)-(8) of the reference; the gauge pressure of the pilot is the only
    drive. In the mode `regulator`, the outlet pressure acts against the pilot pressure, and the pressure drop of the
    supply seat acts on the poppet. The leaks are parallel to the seats, with the same critical ratio. Each increases
    the conductance of its seat at all strokes. By default, both are equal. The default characteristic has the name in
    `data` with the suffix `.closed`; its C is 0 for strokes up to 0. The default pilot pressure is the ambient
    pressure.

    Fig. 5 of the reference shows the spring force k2 (h2 - x), but eq. (5) contains k2 (h2 + x); the model follows the
    equation. At a stroke of 0, the force of the lower spring is discontinuous in the equations. In the model, it
    changes over the range of strokes `contact.width` below zero, with the dissipation of Hunt and Crossley.

    References
    ----------
    Varga & Keski-Honkola 2012, eqs (5)-(8) and fig. 2.
    """

    kind: ClassVar[str] = "main_stage"
    regimes: ClassVar[tuple[str, ...]] = ("supply_regime", "exhaust_regime")
    symbol: ClassVar[symbols.Symbol | str] = symbols.MAIN_STAGE
    internal_outputs: ClassVar[tuple[str, ...]] = ("velocity",)
    summary: ClassVar[str] = "main stage of a piloted pressure valve: C(x), b(x), poppet mechanics"

    supply: str | None = port("gas node at port 1")
    outlet: str | None = port("gas node at port 2")
    exhaust: str | None = port("gas node at port 3")
    data: Any = reference(doc="name of a parameter set of the library")
    mode: str = option(*_MODES, doc="mode; equations of the paper, or a pressure regulator")
    characteristic: Any = reference(doc="C(x), b(x): library name, .toml file or table")
    pilot_pressure: NumberLike = number("Pa", optional=True, doc="pilot pressure", kind="pressure", low=0.0)
    plate_area: NumberLike = number("m^2", doc="plate area S", above=0.0)
    moving_mass: NumberLike = number("kg", doc="moving mass m_p while filling", above=0.0)
    emptying_mass: NumberLike = number("kg", doc="moving mass m_o while emptying", above=0.0)
    damping: NumberLike = number("N s/m", doc="damping constant d", low=0.0)
    upper_spring: Any = group(Spring, doc="upper spring k1, h1; includes the membrane")
    lower_spring: Any = group(Spring, doc="lower spring k2, h2")
    seat_area: NumberLike = number("m^2", optional=True, doc="area of the supply seat; mode `regulator`", low=0.0)
    seat_balance: NumberLike = number("1", optional=True, doc="unbalanced fraction of the seat area", low=0.0, high=1.0)
    overlap: NumberLike = number("m", doc="overlap; stroke with both seats closed", low=0.0)
    exhaust_seat: Any = group(Exhaust, doc="exhaust seat")
    leak_conductance: NumberLike = number(
        "m^3/(s Pa)", 0.0, doc="leak from the supply to the outlet; conductance C", low=0.0, note="tight"
    )
    exhaust_leak_conductance: NumberLike = number(
        "m^3/(s Pa)", optional=True, doc="leak from the outlet to the exhaust; conductance C", low=0.0
    )
    upper_stop: Any = group(Stop, doc="upper end stop")
    lower_stop: Any = group(Stop, doc="lower end stop")
    contact: Any = group(Contact, doc="contact at stroke zero")
    friction: Any = group(Friction, doc="friction", optional=True)
    initial_stroke: NumberLike = number("m", 0.0, doc="initial stroke", note="both seats closed")
    initial_velocity: NumberLike = number("m/s", 0.0, doc="initial velocity", note="at rest")
    subsonic_index: NumberLike = subsonic_index_m("paper", "eq. (2): the ellipse")
    laminar_ratio: NumberLike = laminar_limit()

    resume: ClassVar[dict[str, str]] = {"stroke": "initial_stroke", "velocity": "initial_velocity"}

    def variant(self) -> str:
        # An invalid mode is reported by its own check, not by all numbers that would be missing.
        return self.mode if self.mode in _MODES else _MODES[0]

    def check(self) -> None:
        super().check()
        curve = self.characteristic
        if curve is None and self.data is None:
            raise InputError("parts.no_characteristic", "characteristic")
        curve = read_characteristic(f"{self.data}{CLOSED}" if curve is None else curve, "characteristic")
        object.__setattr__(self, "characteristic", curve)
        if float(self.lower_stop.position) >= float(self.upper_stop.position):
            low, high = self.lower_stop.position.display(), self.upper_stop.position.display()
            raise InputError("parts.stops_exchanged", "lower_stop.position", shown=low, upper=high)

    @property
    def curve(self) -> Characteristic:
        """Flow characteristic of the supply seat: C and b as functions of the stroke."""
        result: Characteristic = self.characteristic
        return result

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        seat = self.exhaust_seat
        exhaust = f"exhaust C = {numbers.text(seat.sonic_conductance)}, b = {numbers.text(seat.critical_ratio)}"
        return [f"main stage, {self.mode} mode", f"C(x), b(x): {self.curve.name}", exhaust]

    def numbers(self) -> dict[str, Number]:
        values = super().numbers()
        values.update({f"characteristic.{name}": value for name, value in self.curve.numbers().items()})
        return values

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values = {"pilot_pressure": ambient.pressure, "seat_area": 0.0, "seat_balance": 0.0} | values
        values.setdefault("exhaust_leak_conductance", values["leak_conductance"])
        if self.friction is not None:
            values.setdefault("friction.static", values["friction.coulomb"])
        return values | {f"characteristic.{k}": v for k, v in self.curve.parameters().items()}

    def structure(self) -> Hashable:
        return super().structure(), self.curve.structure(), self.friction is not None

    def states(self) -> tuple[State, ...]:
        return State("stroke", "m", 1e-3, LOOSER, 1.0), State("velocity", "m/s", 0.1, LOOSER, 1.0)

    def inputs(self) -> tuple[Input, ...]:
        pilot = Input("pilot_pressure", "Pa", "pilot_pressure", kind="pressure", low=0.0, is_command=True)
        return (pilot, *super().inputs())

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"stroke": scope["initial_stroke"], "velocity": scope["initial_velocity"]}

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        return {"stroke": (self.curve, (float(self.lower_stop.position), float(self.upper_stop.position)))}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        fault, stroke = FaultEffect.of(scope), scope.states["stroke"]
        # All forces are those of the healthy plate, which moves faster.
        velocity = scope.states["velocity"] * fault.slowness
        # The fraction of the poppet force that acts on the plate; it is 1 for positive strokes.
        lifted = contact.seat_fraction(stroke, scope["contact.width"])
        mass = scope["emptying_mass"] + (scope["moving_mass"] - scope["emptying_mass"]) * lifted
        back_pressure = scope.surroundings.pressure if self.mode == "paper" else gas["outlet"].pressure
        drive = scope["plate_area"] * (scope.inputs["pilot_pressure"] - back_pressure)
        resistance = scope["damping"] * velocity
        if self.friction is not None:
            names = ("coulomb", "static", "stribeck_velocity", "smoothing_velocity", "viscous")
            friction = contact.stribeck_friction(velocity, *(scope[f"friction.{name}"] for name in names))
            resistance = resistance + friction
        # Forces of both springs and of the pressure on the supply seat.
        upper = scope["upper_spring.rate"] * (scope["upper_spring.preload"] + stroke)
        lower = scope["lower_spring.rate"] * (scope["lower_spring.preload"] + maximum(stroke, 0.0))
        if self.mode == "regulator":
            difference = gas["supply"].pressure - gas["outlet"].pressure
            lower = lower + scope["seat_balance"] * scope["seat_area"] * difference
        # Damped on the ramp of the seat only: 0 at its ends, 1 in its middle.
        contact_fraction = lifted * (1.0 - lifted) * 4.0
        damped = 1.0 + contact_fraction * contact.saturation(scope["contact.dissipation"] * velocity)
        force = drive - (upper + lifted * lower * damped) - resistance
        acceleration = (force + self._stops(scope, velocity)) / (mass * fault.slowness * fault.slowness)
        rates = self._rates_with_fault(scope, fault, acceleration)
        conductance, ratio = characteristic_at(self.curve, scope, "characteristic.", stroke)
        open_conductance, _ = characteristic_at(self.curve, scope, "characteristic.", scope["upper_stop.position"])
        size = fault.leaking(conductance, open_conductance) + scope["leak_conductance"], ratio
        supply, outputs = named_flow(scope, gas, "supply", ("supply", "outlet"), size)
        opening = smoothstep(-stroke - scope["overlap"], 0.0, scope["exhaust_seat.opening"])
        conductance = scope["exhaust_seat.sonic_conductance"] * fault.leaking(opening)
        size = conductance + scope["exhaust_leak_conductance"], scope["exhaust_seat.critical_ratio"]
        exhaust, exhaust_outputs = named_flow(scope, gas, "exhaust", ("outlet", "exhaust"), size)
        outputs |= exhaust_outputs | {"stroke": (stroke, "m"), "velocity": (scope.states["velocity"], "m/s")}
        # -2 at the lower stop, -1 exhaust open, 0 both seats closed, 1 supply open, 2 at the upper stop. The stops take
        # precedence over the seats.
        code = where(stroke > 0.0, 1.0, where(stroke < -scope["overlap"], -1.0, 0.0))
        code = where(stroke >= scope["upper_stop.position"], 2.0, code)
        outputs["contact"] = where(stroke <= scope["lower_stop.position"], -2.0, code), "1"
        # Inputs of a pilot stage and of electronics; recordings have the pressure as an output of the outlet.
        hidden: Quantities = {"displacement": (scope["plate_area"] * stroke, "m^3")}
        hidden["outlet_pressure"] = gas["outlet"].pressure, "Pa"
        return PassageFlows((supply, exhaust), {name: outputs[name] for name in OUTPUTS}, rates, hidden)

    def _rates_with_fault(self, scope: Scope, fault: FaultEffect, acceleration: Any) -> dict[str, Any]:
        """Return the time derivatives of both states for the acceleration of the plate without a stuck plate.

        A plate that is stuck at a seat or at a stop moves there like a critically damped oscillator. Its spring has the
        force of the ambient pressure on the plate at the stroke between the stops.
        """
        stroke, velocity = scope.states["stroke"], scope.states["velocity"]
        travel = scope["upper_stop.position"] - scope["lower_stop.position"]
        stiffness = scope["plate_area"] * scope.surroundings.pressure / travel
        omega = sqrt(stiffness / scope["moving_mass"])

        def approach(target: Any) -> Any:
            return -omega * (omega * (stroke - target) + 2.0 * velocity)

        open_stroke, closed_stroke = scope["upper_stop.position"], -0.5 * scope["overlap"]
        acceleration = fault.forced(acceleration, approach(open_stroke), approach(closed_stroke))
        # A plate that is released starts from rest.
        acceleration = fault.held(acceleration) - fault.holds * omega * velocity
        return {"stroke": fault.held(velocity), "velocity": acceleration}

    def _stops(self, scope: Scope, velocity: Any) -> Any:
        stroke = scope.states["stroke"]

        def force(name: str, depth: Any, speed: Any) -> Any:
            return contact.stop_force(depth, speed, scope[f"{name}.stiffness"], scope[f"{name}.dissipation"])

        upper_force = force("upper_stop", stroke - scope["upper_stop.position"], velocity)
        lower_force = force("lower_stop", scope["lower_stop.position"] - stroke, -velocity)
        return lower_force - upper_force
