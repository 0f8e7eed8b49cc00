"""Gas in a volume that depends on the position of a body, for cylinder chambers and muscles."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar

from poppet.laws.physics import gas as gas_law
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State, Store

STATES = (State("energy", "J", 100.0, positive=True), State("mass", "kg", 1e-3, positive=True))
"""Internal energy and mass: the balances of mass and energy are linear in these states for any motion."""


def initial_states(scope: Scope, volume: Any) -> dict[str, Any]:
    """Return the initial values of the states `mass` [kg] and `energy` [J] of the gas in a part.

    `volume` is the initial volume of the gas [m^3]. Initial pressure and temperature are parameters in `scope`.
    """
    pressure, gas = scope["initial_pressure"], scope.surroundings
    mass = gas_law.mass(pressure, volume, scope["initial_temperature"], gas.gas_constant)
    return {"energy": pressure * volume / (gas.isentropic_exponent - 1.0), "mass": mass}


def gas_state(scope: Scope, volume: Any) -> GasState:
    """Return pressure and temperature of the gas in a part, computed from its states and its volume [m^3]."""
    energy, mass, gas = scope.states["energy"], scope.states["mass"], scope.surroundings
    return GasState((gas.isentropic_exponent - 1.0) * energy / volume, energy / (mass * gas.heat_capacity_volume))


def balance(scope: Scope, gas: GasState, volume: Any, growth: Any, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
    """Return the outputs of the gas in a changing volume, and the time derivatives of its states.

    The energy balance is U' = sum of enthalpy flows + heat - p V'. `growth` is the rate of change V' of the volume
    [m^3/s]. `flows` contains the mass flow rate [kg/s] and the enthalpy flow rate [W] of each flow into the volume.
    """
    heat = scope["wall_conductance"] * (scope["wall_temperature"] - gas.temperature)
    work = -gas.pressure * growth
    rates = {"mass": sum(mass for mass, _ in flows), "energy": sum(enthalpy for _, enthalpy in flows) + heat + work}
    outputs: Quantities = {
        "pressure": (gas.pressure, "Pa"),
        "temperature": (gas.temperature, "K"),
        "mass": (scope.states["mass"], "kg"),
        "volume": (volume, "m^3"),
        "heat_flow_rate": (heat, "W"),
        "work_rate": (work, "W"),
    }
    return GasBalance(outputs, rates, heat, scope.states["energy"], work)


class MovingGasStore(Store):
    """Gas node whose volume depends on the position of a body."""

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    @abstractmethod
    def volume_and_area(self, scope: Scope) -> tuple[Any, Any]:
        """Return the gas volume [m^3], and its derivative with respect to the travel of the actuator [m^2].

        The travel of the actuator is the travel of the body, with the sign of the field `direction`.
        """

    def states(self) -> tuple[State, ...]:
        return STATES

    def start(self, scope: Scope) -> dict[str, Any]:
        return initial_states(scope, self.volume_and_area(scope)[0])

    def gas(self, scope: Scope) -> GasState:
        return gas_state(scope, self.volume_and_area(scope)[0])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        volume, area = self.volume_and_area(scope)
        return balance(scope, self.gas(scope), volume, area * scope["direction"] * scope.body.velocity, flows)
