"""The main stage of a piloted pressure valve: one plate, a supply poppet, an exhaust seat."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import maximum, smoothstep, where
from poppet.laws.curves import Characteristic
from poppet.laws.physics import contact
from poppet.parts.fields import NumberLike, group, laminar_limit, number, option, port, reference, subsonic_index_m
from poppet.parts.flow_path import characteristic_at, read_characteristic
from poppet.parts.orifice import way
from poppet.parts.part import GasState, Input, Passage, PassageFlows, Quantities, Scope, State, Surroundings

_MODES = ("paper", "regulator")
# In the order of the columns of a recording: states, flows, then codes.
OUTPUTS = (
    "stroke", "velocity", "supply_mass_flow_rate", "exhaust_mass_flow_rate",
    "supply_regime", "exhaust_regime", "contact",
)  # fmt: skip
CLOSED = ".closed"
"""Variant of a library characteristic that a valve takes by default: a poppet on its seat must not leak."""
LOOSER = 300.0
"""Tolerance of the mechanics per tolerance of the gas. On the paper's staircase it saves a quarter of the steps and
leaves the error in pressure where it was."""


@dataclass(frozen=True)
class Spring:
    """A linear spring that is compressed by `preload` at stroke zero."""

    rate: NumberLike = number("N/m", doc="spring rate", low=0.0)
    preload: NumberLike = number("m", doc="compression at stroke zero", low=0.0)


@dataclass(frozen=True)
class Stop:
    """An end stop after Hunt and Crossley: force k d^1.5, damped while in contact."""

    position: NumberLike = number("m", doc="stroke at which the stop is met")
    stiffness: NumberLike = number("N/m^1.5", doc="contact stiffness", above=0.0)
    dissipation: NumberLike = number("s/m", doc="contact dissipation", low=0.0)


@dataclass(frozen=True)
class Contact:
    """The contact of plate and poppet at stroke zero, where the lower spring takes over."""

    width: NumberLike = number("m", doc="width of the contact", above=0.0)
    dissipation: NumberLike = number("s/m", doc="contact dissipation", low=0.0)


@dataclass(frozen=True)
class Exhaust:
    """The exhaust seat: it opens over `opening` below the overlap, to a constant size."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the exhaust", low=0.0)
    critical_ratio: NumberLike = number("1", doc="critical ratio b of the exhaust", low=0.0, below=1.0)
    opening: NumberLike = number("m", doc="stroke over which the exhaust opens", above=0.0)


@dataclass(frozen=True)
class Friction:
    """Stribeck friction of the plate; left out when not given."""

    coulomb: NumberLike = number("N", 0.0, doc="Coulomb friction", low=0.0, note="none by default")
    static: NumberLike = number("N", optional=True, doc="breakaway friction", low=0.0)
    stribeck_velocity: NumberLike = number("m/s", "5 mm/s", doc="Stribeck velocity", above=0.0)
    smoothing_velocity: NumberLike = number("m/s", "0.5 mm/s", doc="velocity of full Coulomb friction", above=0.0)
    viscous: NumberLike = number("N s/m", 0.0, doc="viscous friction", low=0.0, note="none by default")


@dataclass(frozen=True)
class MainStage(Passage):
    r"""The main stage, after eqs (5)-(8), with one coordinate for filling, overlap and emptying.

    A stroke x > 0 lifts the supply poppet against both springs, x < 0 opens the exhaust seat against the upper spring
    alone; between 0 and minus the overlap both seats are closed.

    .. math:: m_p \ddot x + d \dot x + k_1 (h_1 + x) + k_2 (h_2 + x) = S p_p \quad (x > 0)

    .. math:: m_o \ddot x + d \dot x + k_1 (h_1 + x) = S p_o \quad (x < 0)

    Parameters
    ----------
    supply, outlet, exhaust : str
        Stores at ports 1, 2 and 3.
    data : str
        A library set; fields given here override it.
    mode : str
        `paper` (default): literally eqs (5)-(8), driven by the pilot gauge pressure, without feedback.
        `regulator`: the outlet pressure acts against the pilot, and the seat pressure on the poppet.
    characteristic : str or mapping
        C(x), b(x) of the supply seat; default the closed variant of `data`.
    pilot_pressure : number
        Absolute pilot pressure [Pa]; also an input. Default: the ambient pressure.
    plate_area : number
        Area S of the plate [m^2].
    moving_mass, emptying_mass : number
        Moving masses m_p and m_o [kg].
    damping : number
        Damping constant d [N s/m].
    upper_spring, lower_spring : group
        rate k1, k2 [N/m] and preload h1, h2 [m].
    seat_area, seat_balance : number
        Area of the supply seat [m^2] and the part of it, 0..1, that is not pressure-balanced (`regulator`).
    overlap : number
        Stroke below zero over which both seats are closed [m].
    exhaust_seat : group
        sonic_conductance, critical_ratio, opening of the exhaust.
    upper_stop, lower_stop, contact, friction : group
        End stops, the contact at stroke zero, friction (optional).
    initial_stroke, initial_velocity : number
        Where the plate starts [m], [m/s].
    subsonic_index, laminar_ratio : number
        Subsonic index m of both seats, and pressure ratio at which the regularised zone begins.

    Notes
    -----
    Fig. 5 of the paper shows k2 (h2 - x) where eq. (5) prints k2 (h2 + x); the equation is followed.
    The seat's contact is a ramp of the lower spring's force over `contact.width` below zero, with the dissipation
    of Hunt and Crossley, so that the discontinuity of the literal equations is stiff, damped and differentiable.

    References
    ----------
    Varga & Keski-Honkola 2012, eqs (5)-(8) and fig. 2.
    """

    kind: ClassVar[str] = "main_stage"
    internal_outputs: ClassVar[tuple[str, ...]] = ("velocity",)
    summary: ClassVar[str] = "main stage of a piloted pressure valve: C(x), b(x), poppet mechanics"

    supply: str | None = port("store at port 1")
    outlet: str | None = port("store at port 2")
    exhaust: str | None = port("store at port 3")
    data: Any = reference(doc="library set")
    mode: str = option(*_MODES, doc="mode")
    characteristic: Any = reference(doc="C(x), b(x): library name, .toml file or table")
    pilot_pressure: NumberLike = number("Pa", optional=True, doc="pilot pressure", kind="pressure", low=0.0)
    plate_area: NumberLike = number("m^2", doc="plate area S", above=0.0)
    moving_mass: NumberLike = number("kg", doc="moving mass while filling", above=0.0)
    emptying_mass: NumberLike = number("kg", doc="moving mass while emptying", above=0.0)
    damping: NumberLike = number("N s/m", doc="damping constant", low=0.0)
    upper_spring: Any = group(Spring, doc="the upper spring, membrane included")
    lower_spring: Any = group(Spring, doc="the lower spring")
    seat_area: NumberLike = number("m^2", optional=True, doc="area of the supply seat", low=0.0)
    seat_balance: NumberLike = number("1", optional=True, doc="unbalanced part of the seat area", low=0.0, high=1.0)
    overlap: NumberLike = number("m", doc="overlap", low=0.0)
    exhaust_seat: Any = group(Exhaust, doc="the exhaust seat")
    upper_stop: Any = group(Stop, doc="the upper end stop")
    lower_stop: Any = group(Stop, doc="the lower end stop")
    contact: Any = group(Contact, doc="the contact at stroke zero")
    friction: Any = group(Friction, doc="friction", optional=True)
    initial_stroke: NumberLike = number("m", 0.0, doc="initial stroke", note="both seats closed")
    initial_velocity: NumberLike = number("m/s", 0.0, doc="initial velocity", note="at rest")
    subsonic_index: NumberLike = subsonic_index_m("paper", "eq. (2): the ellipse")
    laminar_ratio: NumberLike = laminar_limit()

    resume: ClassVar[dict[str, str]] = {"stroke": "initial_stroke", "velocity": "initial_velocity"}

    def variant(self) -> str:
        # A misspelt mode is reported by its own check, not by every number that it would leave missing.
        return self.mode if self.mode in _MODES else _MODES[0]

    def check(self) -> None:
        given = self.characteristic
        if given is None and self.data is None:
            raise InputError("parts.no_characteristic", "characteristic")
        curve = read_characteristic(given if given is not None else f"{self.data}{CLOSED}", "characteristic")
        object.__setattr__(self, "characteristic", curve)
        if float(self.lower_stop.position) >= float(self.upper_stop.position):
            low, high = self.lower_stop.position.display(), self.upper_stop.position.display()
            raise InputError("parts.stops_exchanged", "lower_stop.position", shown=low, upper=high)

    @property
    def curve(self) -> Characteristic:
        """The characteristic of the supply seat."""
        result: Characteristic = self.characteristic
        return result

    def numbers(self) -> dict[str, Number]:
        values = super().numbers()
        values.update({f"characteristic.{name}": value for name, value in self.curve.numbers().items()})
        return values

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values = {"pilot_pressure": ambient.pressure, "seat_area": 0.0, "seat_balance": 0.0} | values
        if self.friction is not None:
            values.setdefault("friction.static", values["friction.coulomb"])
        return values | {f"characteristic.{k}": v for k, v in self.curve.parameters().items()}

    def structure(self) -> Hashable:
        return super().structure(), self.curve.structure(), self.friction is not None

    def states(self) -> tuple[State, ...]:
        return State("stroke", "m", 1e-3, LOOSER, 1.0), State("velocity", "m/s", 0.1, LOOSER, 1.0)

    def inputs(self) -> tuple[Input, ...]:
        return (Input("pilot_pressure", "Pa", "pilot_pressure", kind="pressure", low=0.0),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"stroke": scope["initial_stroke"], "velocity": scope["initial_velocity"]}

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        return {"stroke": (self.curve, (float(self.lower_stop.position), float(self.upper_stop.position)))}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        stroke, velocity = scope.states["stroke"], scope.states["velocity"]
        lifted = contact.seat_fraction(stroke, scope["contact.width"])
        mass = scope["emptying_mass"] + (scope["moving_mass"] - scope["emptying_mass"]) * lifted
        against = scope.surroundings.pressure if self.mode == "paper" else gas["outlet"].pressure
        drive = scope["plate_area"] * (scope.inputs["pilot_pressure"] - against)
        force = drive - self._springs(scope, gas, lifted) - self._resistance(scope)
        rates = {"stroke": velocity, "velocity": (force + self._stops(scope)) / mass}
        size = characteristic_at(self.curve, scope, "characteristic.", stroke)
        supply, outputs = way(scope, gas, "supply", ("supply", "outlet"), size)
        exhaust, more = way(scope, gas, "exhaust", ("outlet", "exhaust"), self._exhaust_size(scope))
        shown = outputs | more | {"stroke": (stroke, "m"), "velocity": (velocity, "m/s")}
        shown["contact"] = self._contact(scope), "1"
        # What a pilot stage and electronics of the valve read; the pressure stands as the outlet's own already.
        shared: Quantities = {"displacement": (scope["plate_area"] * stroke, "m^3")}
        shared["outlet_pressure"] = gas["outlet"].pressure, "Pa"
        return PassageFlows((supply, exhaust), {name: shown[name] for name in OUTPUTS}, rates, hidden=shared)

    def _springs(self, scope: Scope, gas: Mapping[str, GasState], lifted: Any) -> Any:
        """Force of both springs and of the seat pressure; the poppet's part acts once the plate has met it."""
        stroke = scope.states["stroke"]
        upper = scope["upper_spring.rate"] * (scope["upper_spring.preload"] + stroke)
        above = maximum(stroke, 0.0)
        lower = scope["lower_spring.rate"] * (scope["lower_spring.preload"] + above)
        if self.mode == "regulator":
            lower = lower + scope["seat_balance"] * scope["seat_area"] * (
                gas["supply"].pressure - gas["outlet"].pressure
            )
        # Damped only on the ramp of the seat: 0 at both of its ends, 1 in its middle.
        held = lifted * (1.0 - lifted) * 4.0
        damped = 1.0 + held * contact.saturation(scope["contact.dissipation"] * scope.states["velocity"])
        return upper + lifted * lower * damped

    def _resistance(self, scope: Scope) -> Any:
        velocity = scope.states["velocity"]
        damping = scope["damping"] * velocity
        if self.friction is None:
            return damping
        names = ("coulomb", "static", "stribeck_velocity", "smoothing_velocity", "viscous")
        return damping + contact.stribeck_friction(velocity, *(scope[f"friction.{name}"] for name in names))

    def _stops(self, scope: Scope) -> Any:
        stroke, velocity = scope.states["stroke"], scope.states["velocity"]

        def force(name: str, depth: Any, speed: Any) -> Any:
            return contact.stop_force(depth, speed, scope[f"{name}.stiffness"], scope[f"{name}.dissipation"])

        above = force("upper_stop", stroke - scope["upper_stop.position"], velocity)
        below = force("lower_stop", scope["lower_stop.position"] - stroke, -velocity)
        return below - above

    def _exhaust_size(self, scope: Scope) -> tuple[Any, Any]:
        below = -scope.states["stroke"] - scope["overlap"]
        opening = smoothstep(below, 0.0, scope["exhaust_seat.opening"])
        return scope["exhaust_seat.sonic_conductance"] * opening, scope["exhaust_seat.critical_ratio"]

    def _contact(self, scope: Scope) -> Any:
        """-2 lower stop, -1 exhaust open, 0 both seats closed, 1 supply open, 2 upper stop."""
        stroke = scope.states["stroke"]
        # The stops last: they have precedence over the seats.
        code = where(stroke > 0.0, 1.0, where(stroke < -scope["overlap"], -1.0, 0.0))
        code = where(stroke >= scope["upper_stop.position"], 2.0, code)
        return where(stroke <= scope["lower_stop.position"], -2.0, code)
