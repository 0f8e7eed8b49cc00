"""A chamber of constant volume, with a choice of thermal laws."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.symbolic import maximum
from poppet.laws.physics import gas as gas_law
from poppet.laws.physics import heat_transfer
from poppet.parts.fields import NumberLike, anr_pressure, anr_temperature, number, option
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State, Store, Surroundings

_ONLY_ENERGY = (
    "wall_conductance", "wall_temperature", "wall_heat_capacity", "outer_conductance", "ambient_temperature"
)  # fmt: skip
_CORRELATION = ("wall_area", "height", "inlet_diameter", "nusselt_prefactor")
_NEEDED = {"constant": (), "natural": _CORRELATION[:2], "woodfield": _CORRELATION[:3]}
_OTHERWISE = {"constant": ("wall_conductance",), "natural": ("nusselt_prefactor",), "woodfield": ()}
"""Fields of a law of heat transfer that it cannot do without, and those that have a default."""


@dataclass(frozen=True)
class Chamber(Store):
    r"""A tank, a line or a dead volume: mass balance and one of four thermal laws.

    .. math:: \dot m = \sum q, \qquad
              \frac{V \dot p}{\kappa - 1} = \sum c_p T_{up} q + h A (T_w - T)

    Parameters
    ----------
    volume : number
        Volume of the gas [m^3].
    thermal : str
        `energy` (default, the balance above), `isothermal`, `polytropic`, or `isentrope` (the paper's tank:
        a closed gas on one isentrope, which charging does not follow).
    polytropic_exponent : number
        Exponent n of `polytropic`.
    wall_conductance : number
        Product h A of heat transfer between gas and wall [W/K]; 0 is adiabatic.
    wall_temperature : number
        Temperature of the wall, its initial one when it has a heat capacity [K]; default the ambient temperature.
    wall_heat_capacity : number
        Makes the temperature of the wall a state [J/K].
    outer_conductance : number
        Heat transfer between wall and surroundings [W/K].
    ambient_temperature : number
        Temperature outside the wall [K]; default the ambient temperature.
    heat_transfer : str
        `constant` (wall_conductance), `natural` (free convection) or `woodfield` (charging jet and free convection).
    nusselt_prefactor : number
        Prefactor of Nu = c Ra^(1/3) for `natural`.
    wall_area, height, inlet_diameter : number
        Inner surface [m^2] and height [m] of the vessel for both correlations, bore of the inlet for `woodfield` [m].
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start.

    Notes
    -----
    States are mass, and with `energy` the pressure: mass and energy are then linear in the states, and the integrator
    conserves both to round-off.

    References
    ----------
    Varga & Keski-Honkola 2012, section 3 (the isentropic tank) and section 5 (the wish for a polytropic one).
    """

    kind: ClassVar[str] = "chamber"
    summary: ClassVar[str] = "a volume of gas: isothermal, polytropic, the paper's isentrope, or energy balance"

    internal_outputs: ClassVar[tuple[str, ...]] = ("mass", "heat_flow_rate")

    volume: NumberLike = number("m^3", doc="volume", above=0.0)
    thermal: str = option("energy", "isothermal", "polytropic", "isentrope", doc="thermal law")
    polytropic_exponent: NumberLike = number("1", optional=True, doc="polytropic exponent", low=0.5, high=2.0)
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    wall_heat_capacity: NumberLike = number("J/K", optional=True, doc="heat capacity of the wall", above=0.0)
    outer_conductance: NumberLike = number("W/K", optional=True, doc="outer wall conductance", low=0.0)
    ambient_temperature: NumberLike = number(
        "K", optional=True, doc="temperature outside the wall", kind="temperature", above=0.0
    )
    heat_transfer: str = option("constant", "natural", "woodfield", doc="heat-transfer law")
    nusselt_prefactor: NumberLike = number("1", optional=True, doc="Nusselt prefactor", low=0.0)
    wall_area: NumberLike = number("m^2", optional=True, doc="wall area", above=0.0)
    height: NumberLike = number("m", optional=True, doc="height of the vessel", above=0.0)
    inlet_diameter: NumberLike = number("m", optional=True, doc="inlet diameter", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    resume: ClassVar[dict[str, str]] = {
        "pressure": "initial_pressure",
        "temperature": "initial_temperature",
        "wall_temperature": "wall_temperature",
    }

    def check(self) -> None:
        if self.thermal == "polytropic" and self.polytropic_exponent is None:
            raise InputError("chamber.no_exponent", "polytropic_exponent")
        if self.thermal != "energy":
            return
        for name in _NEEDED[self.heat_transfer]:
            if getattr(self, name) is None:
                needed = [*_NEEDED[self.heat_transfer]]
                raise InputError("chamber.correlation_needs", name, law=self.heat_transfer, needed=needed)
        if self.outer_conductance is not None and self.wall_heat_capacity is None:
            raise InputError("chamber.no_wall_heat_capacity", "outer_conductance")

    def notes(self) -> tuple[Note, ...]:
        # Not mistakes: a circuit keeps the numbers of every law, so that one word exchanges the law.
        result = [] if self.thermal == "polytropic" else self._unused(("polytropic_exponent",), "thermal")
        if self.thermal != "energy":
            return (*result, *self._unused((*_ONLY_ENERGY, *_CORRELATION), "thermal"))
        used = (*_NEEDED[self.heat_transfer], *_OTHERWISE[self.heat_transfer])
        idle = tuple(name for name in ("wall_conductance", *_CORRELATION) if name not in used)
        return (*result, *self._unused(idle, "heat_transfer"))

    def _unused(self, names: tuple[str, ...], option: str) -> list[Note]:
        """The note on those of the fields that were given but say nothing under a law."""
        given = [name for name in names if getattr(self, name) is not None]
        if "wall_conductance" in given and float(self.wall_conductance) == 0.0:  # type: ignore[arg-type]
            given.remove("wall_conductance")
        if not given:
            return []
        return [Note("chamber.no_effect", given[0], others=given[1:], option=option, law=getattr(self, option))]

    def structure(self) -> Hashable:
        return super().structure(), self._has_wall_state

    @property
    def _has_wall_state(self) -> bool:
        return self.thermal == "energy" and self.wall_heat_capacity is not None

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self.thermal == "energy":
            around = {"wall_temperature": ambient.temperature, "ambient_temperature": ambient.temperature}
            values = {**around, "outer_conductance": 0.0, **values}
        if self.heat_transfer == "natural":
            values.setdefault("nusselt_prefactor", 0.13)
        return values

    def states(self) -> tuple[State, ...]:
        # Pressure first: it is the fast one, and the elimination without pivoting takes ties in this order.
        result = [State("pressure", "Pa", 1e5, positive=True)] if self.thermal == "energy" else []
        result.append(State("mass", "kg", 1e-3, positive=True))
        if self._has_wall_state:
            result.append(State("wall_temperature", "K", 293.15, positive=True))
        return tuple(result)

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"mass": self._initial_mass(scope)}
        if self.thermal == "energy":
            values["pressure"] = scope["initial_pressure"]
        if self._has_wall_state:
            values["wall_temperature"] = scope["wall_temperature"]
        return values

    def _initial_mass(self, scope: Scope) -> Any:
        first = scope["initial_pressure"], scope["volume"], scope["initial_temperature"]
        return gas_law.mass(*first, scope.surroundings.gas_constant)

    def gas(self, scope: Scope) -> GasState:
        mass, gas_constant = scope.states["mass"], scope.surroundings.gas_constant
        if self.thermal == "energy":
            pressure = scope.states["pressure"]
            return GasState(pressure, gas_law.temperature(pressure, scope["volume"], mass, gas_constant))
        temperature = scope["initial_temperature"]
        if self.thermal != "isothermal":
            exponent = self._exponent(scope)
            # In a constant volume the density goes with the mass.
            temperature = temperature * (mass / self._initial_mass(scope)) ** (exponent - 1.0)
        return GasState(mass * gas_constant * temperature / scope["volume"], temperature)

    def _exponent(self, scope: Scope) -> Any:
        """Exponent n of p ~ m^n in a constant volume."""
        if self.thermal == "isothermal":
            return 1.0
        return scope["polytropic_exponent"] if self.thermal == "polytropic" else scope.surroundings.isentropic_exponent

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        mass_rate = sum(mass for mass, _ in flows)
        enthalpy_rate = sum(enthalpy for _, enthalpy in flows)
        gas, air = self.gas(scope), scope.surroundings
        rates: dict[str, Any] = {"mass": mass_rate}
        outputs: Quantities = {
            "pressure": (gas.pressure, "Pa"),
            "temperature": (gas.temperature, "K"),
            "mass": (scope.states["mass"], "kg"),
        }
        if self.thermal == "energy":
            heat = self._wall_heat(scope, gas, flows, rates, outputs)
            rates["pressure"] = (air.isentropic_exponent - 1.0) / scope["volume"] * (enthalpy_rate + heat)
            energy = scope.states["pressure"] * scope["volume"] / (air.isentropic_exponent - 1.0)
        else:
            # The law prescribes the temperature; the heat follows from the energy balance: d(m cv T) = n cv T dm.
            heat = self._exponent(scope) * air.heat_capacity_volume * gas.temperature * mass_rate - enthalpy_rate
            energy = None
        outputs["heat_flow_rate"] = (heat, "W")
        return GasBalance(outputs, rates, heat, energy)

    def _wall_heat(
        self,
        scope: Scope,
        gas: GasState,
        flows: tuple[tuple[Any, Any], ...],
        rates: dict[str, Any],
        outputs: Quantities,
    ) -> Any:
        """Heat from wall to gas; adds the wall's own rate and output where it has a temperature of its own."""
        is_state = self._has_wall_state
        wall = scope.states["wall_temperature"] if is_state else scope["wall_temperature"]
        heat = self._conductance(scope, gas, wall, flows) * (wall - gas.temperature)
        if is_state:
            outside = scope["outer_conductance"] * (scope["ambient_temperature"] - wall)
            rates["wall_temperature"] = (outside - heat) / scope["wall_heat_capacity"]
            outputs["wall_temperature"] = (wall, "K")
        return heat

    def _conductance(self, scope: Scope, gas: GasState, wall: Any, flows: tuple[tuple[Any, Any], ...]) -> Any:
        if self.heat_transfer == "constant":
            return scope["wall_conductance"]
        around = scope.surroundings
        gas_numbers = {"gas_constant": around.gas_constant, "isentropic_exponent": around.isentropic_exponent}
        vessel = gas.pressure, gas.temperature, wall, scope["wall_area"], scope["height"]
        if self.heat_transfer == "natural":
            return heat_transfer.natural_conductance(*vessel, scope["nusselt_prefactor"], **gas_numbers)
        inflow = sum(maximum(mass, 0.0) for mass, _ in flows)
        return heat_transfer.charging_conductance(*vessel, inflow, scope["inlet_diameter"], **gas_numbers)
