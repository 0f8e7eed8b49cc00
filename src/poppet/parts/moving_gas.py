"""Gas in a volume that depends on the position of a body, for cylinder chambers and muscles."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar

from poppet.laws.physics import gas as gas_law
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State, Store

STATES = (State("energy", "J", 100.0, positive=True), State("mass", "kg", 1e-3, positive=True))
"""Internal energy and mass: the balances of mass and energy are linear in these states for any motion."""


def initial_states(scope: Scope, volume: Any) -> dict[str, Any]:
    """Return mass and energy of gas at its initial pressure and temperature.

    `volume` is the initial volume of the gas [m^3].
    """
    pressure, gas = scope["initial_pressure"], scope.surroundings
    mass = gas_law.mass(pressure, volume, scope["initial_temperature"], gas.gas_constant)
    return {"energy": pressure * volume / (gas.isentropic_exponent - 1.0), "mass": mass}


def gas_state(scope: Scope, volume: Any) -> GasState:
    """Return pressure and temperature of gas from its states and its volume."""
    energy, mass, gas = scope.states["energy"], scope.states["mass"], scope.surroundings
    return GasState((gas.isentropic_exponent - 1.0) * energy / volume, energy / (mass * gas.heat_capacity_volume))


def balance(scope: Scope, gas: GasState, volume: Any, growth: Any, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
    """Return rates and outputs of the gas in a changing volume.

    The energy balance is U' = sum of enthalpy flows + heat - p V'. `growth` is the rate of change V' of the volume.
    `flows` contains the mass flow rate and the enthalpy flow rate of each flow.
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
        """Return the gas volume, and its derivative by the travel of the body.

        The derivative is an area. The travel is positive in the direction of the part.
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
