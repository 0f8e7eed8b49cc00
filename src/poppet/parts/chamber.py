"""Gas chamber of constant volume with a choice of thermal laws."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.symbolic import maximum
from poppet.laws.physics import gas as gas_law
from poppet.laws.physics import heat_transfer
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, anr_pressure, anr_temperature, model, number, option
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State, Store, Surroundings

_ONLY_ENERGY = (
    "wall_conductance", "wall_temperature", "wall_heat_capacity", "outer_conductance", "ambient_temperature"
)  # fmt: skip
_CORRELATION = ("wall_area", "height", "inlet_diameter", "nusselt_prefactor")
_REQUIRED = {"constant": (), "natural": _CORRELATION[:2], "woodfield": _CORRELATION[:3]}
_WITH_DEFAULT = {"constant": ("wall_conductance",), "natural": ("nusselt_prefactor",), "woodfield": ()}
"""Required fields of each law of heat transfer, and the fields of each law that have a default."""


@dataclass(frozen=True)
class Chamber(Store):
    r"""Tank, line or dead volume: mass balance and one of four thermal laws.

    .. math:: \dot m = \sum q, \qquad
              \frac{V \dot p}{\kappa - 1} = \sum c_p T_{up} q + h A (T_w - T)

    Notes
    -----
    The thermal law `energy` is the energy balance above. `isentrope` is the tank model of Varga & Keski-Honkola 2012:
    the gas follows the isentrope of a constant mass, which is not valid for charging. The heat-transfer law `natural`
    is free convection with Nu = c Ra^(1/3); `woodfield` is free convection with the jet of a charged vessel.

    The defaults of `wall_temperature` and `ambient_temperature` are the ambient temperature of the circuit. If the wall
    has a heat capacity, `wall_temperature` is its initial temperature.

    The states are the mass and, with the law `energy`, the pressure. Mass and energy are linear in these states, so the
    integrator conserves both except for rounding errors.

    References
    ----------
    Varga & Keski-Honkola 2012, section 3, for the isentropic tank; section 5 suggests a polytropic tank.
    """

    kind: ClassVar[str] = "chamber"
    symbol: ClassVar[symbols.Symbol | str] = symbols.CHAMBER
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
        "K", optional=True, doc="outside temperature", kind="temperature", above=0.0
    )
    heat_transfer: str = option("constant", "natural", "woodfield", doc="heat-transfer law")
    nusselt_prefactor: NumberLike = number("1", optional=True, doc="Nusselt prefactor", low=0.0)
    wall_area: NumberLike = number("m^2", optional=True, doc="wall area", above=0.0)
    height: NumberLike = number("m", optional=True, doc="height of the vessel", above=0.0)
    inlet_diameter: NumberLike = number("m", optional=True, doc="inlet diameter", above=0.0)
    model: Any = model()
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
        for name in _REQUIRED[self.heat_transfer]:
            if getattr(self, name) is None:
                required = [*_REQUIRED[self.heat_transfer]]
                raise InputError("chamber.correlation_needs", name, law=self.heat_transfer, needed=required)
        if self.outer_conductance is not None and self.wall_heat_capacity is None:
            raise InputError("chamber.no_wall_heat_capacity", "outer_conductance")

    def notes(self) -> tuple[Note, ...]:
        # Notes, not errors: a circuit can keep the parameters of all laws, so that one word selects the law.
        result = [] if self.thermal == "polytropic" else self._unused(("polytropic_exponent",), "thermal")
        if self.thermal != "energy":
            return (*result, *self._unused((*_ONLY_ENERGY, *_CORRELATION), "thermal"))
        effective = (*_REQUIRED[self.heat_transfer], *_WITH_DEFAULT[self.heat_transfer])
        unused = tuple(name for name in ("wall_conductance", *_CORRELATION) if name not in effective)
        return (*result, *self._unused(unused, "heat_transfer"))

    def _unused(self, names: tuple[str, ...], option: str) -> list[Note]:
        """Return a list with a note on fields that are specified but have no effect.

        `names` are fields that have no effect with the present choice of the option `option`. The list is empty if none
        of them is specified.
        """
        specified = [name for name in names if getattr(self, name) is not None]
        if "wall_conductance" in specified and float(self.wall_conductance) == 0.0:  # type: ignore[arg-type]
            specified.remove("wall_conductance")
        if not specified:
            return []
        return [Note("chamber.no_effect", specified[0], others=specified[1:], option=option, law=getattr(self, option))]

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        text, law = numbers.text, str(self.thermal)
        if self.thermal == "polytropic":
            law = f"polytropic, n = {text(self.polytropic_exponent)}"
        elif self.thermal == "isentrope":
            law = "isentrope (closed gas)"
        elif self.thermal == "energy" and self.heat_transfer != "constant":
            law = f"energy, {self.heat_transfer} convection"
        elif self.thermal == "energy":
            is_adiabatic = float(self.wall_conductance) == 0.0  # type: ignore[arg-type]
            law = "energy, adiabatic" if is_adiabatic else f"energy, h A = {text(self.wall_conductance)}"
        start = f"starts at {text(self.initial_pressure)}, {text(self.initial_temperature)}"
        return [text(self.volume), law, start]

    def structure(self) -> Hashable:
        return super().structure(), self._has_wall_state

    @property
    def _has_wall_state(self) -> bool:
        return self.thermal == "energy" and self.wall_heat_capacity is not None

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self.thermal == "energy":
            defaults = {"wall_temperature": ambient.temperature, "ambient_temperature": ambient.temperature}
            values = {**defaults, "outer_conductance": 0.0, **values}
        if self.heat_transfer == "natural":
            values.setdefault("nusselt_prefactor", 0.13)
        return values

    def states(self) -> tuple[State, ...]:
        # Pressure first: it is fast, and the elimination without pivoting resolves ties in this order.
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
        pressure, temperature = scope["initial_pressure"], scope["initial_temperature"]
        return gas_law.mass(pressure, scope["volume"], temperature, scope.surroundings.gas_constant)

    def gas(self, scope: Scope) -> GasState:
        mass, gas_constant = scope.states["mass"], scope.surroundings.gas_constant
        if self.thermal == "energy":
            pressure = scope.states["pressure"]
            return GasState(pressure, gas_law.temperature(pressure, scope["volume"], mass, gas_constant))
        temperature = scope["initial_temperature"]
        if self.thermal != "isothermal":
            exponent = self._exponent(scope)
            # In a constant volume the density is proportional to the mass.
            temperature = temperature * (mass / self._initial_mass(scope)) ** (exponent - 1.0)
        return GasState(mass * gas_constant * temperature / scope["volume"], temperature)

    def _exponent(self, scope: Scope) -> Any:
        """Return the exponent n of the law p ~ m^n at constant volume.

        p is the pressure and m the mass of the gas.
        """
        if self.thermal == "isothermal":
            return 1.0
        return scope["polytropic_exponent"] if self.thermal == "polytropic" else scope.surroundings.isentropic_exponent

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        mass_rate = sum(mass for mass, _ in flows)
        enthalpy_rate = sum(enthalpy for _, enthalpy in flows)
        gas, surroundings = self.gas(scope), scope.surroundings
        rates: dict[str, Any] = {"mass": mass_rate}
        outputs: Quantities = {
            "pressure": (gas.pressure, "Pa"),
            "temperature": (gas.temperature, "K"),
            "mass": (scope.states["mass"], "kg"),
        }
        if self.thermal == "energy":
            wall = (scope.states if self._has_wall_state else scope)["wall_temperature"]
            vessel = gas.pressure, gas.temperature, wall
            properties = {name: getattr(surroundings, name) for name in ("gas_constant", "isentropic_exponent")}
            if self.heat_transfer == "constant":
                conductance = scope["wall_conductance"]
            elif self.heat_transfer == "natural":
                sizes = scope["wall_area"], scope["height"]
                conductance = heat_transfer.natural_conductance(
                    *vessel, *sizes, scope["nusselt_prefactor"], **properties
                )
            else:
                inflow = sum(maximum(mass, 0.0) for mass, _ in flows)
                sizes = scope["wall_area"], scope["height"]
                diameter = scope["inlet_diameter"]
                conductance = heat_transfer.charging_conductance(*vessel, *sizes, inflow, diameter, **properties)
            heat = conductance * (wall - gas.temperature)
            if self._has_wall_state:
                outer_heat = scope["outer_conductance"] * (scope["ambient_temperature"] - wall)
                rates["wall_temperature"] = (outer_heat - heat) / scope["wall_heat_capacity"]
                outputs["wall_temperature"] = (wall, "K")
            rates["pressure"] = (surroundings.isentropic_exponent - 1.0) / scope["volume"] * (enthalpy_rate + heat)
            energy = scope.states["pressure"] * scope["volume"] / (surroundings.isentropic_exponent - 1.0)
        else:
            # The law sets the temperature, the energy balance the heat: d(m cv T) = n cv T dm.
            internal_rate = self._exponent(scope) * surroundings.heat_capacity_volume * gas.temperature * mass_rate
            heat, energy = internal_rate - enthalpy_rate, None
        outputs["heat_flow_rate"] = (heat, "W")
        return GasBalance(outputs, rates, heat, energy)
