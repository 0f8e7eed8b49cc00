"""Gas in a volume that a body changes: what cylinder chambers and muscles share."""

from __future__ import annotations

from typing import Any

from poppet.laws.physics import gas as gas_law
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State

STATES = (State("energy", "J", 100.0, positive=True), State("mass", "kg", 1e-3, positive=True))
"""Internal energy and mass: with them the balances of mass and energy are linear in the states, whatever moves."""


def begun(scope: Scope, volume: Any) -> dict[str, Any]:
    """The states at the initial pressure and temperature."""
    pressure, air = scope["initial_pressure"], scope.surroundings
    mass = gas_law.mass(pressure, volume, scope["initial_temperature"], air.gas_constant)
    return {"energy": pressure * volume / (air.isentropic_exponent - 1.0), "mass": mass}


def state_of(scope: Scope, volume: Any) -> GasState:
    """Pressure and temperature in that volume."""
    energy, mass, air = scope.states["energy"], scope.states["mass"], scope.surroundings
    return GasState((air.isentropic_exponent - 1.0) * energy / volume, energy / (mass * air.heat_capacity_volume))


def balance(scope: Scope, gas: GasState, volume: Any, growth: Any, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
    """U' = sum of enthalpy flows + heat - p V', with `growth` V'."""
    heat = scope["wall_conductance"] * (scope["wall_temperature"] - gas.temperature)
    work = -gas.pressure * growth
    rates = {
        "mass": sum(mass for mass, _ in flows),
        "energy": sum(enthalpy for _, enthalpy in flows) + heat + work,
    }
    outputs: Quantities = {
        "pressure": (gas.pressure, "Pa"),
        "temperature": (gas.temperature, "K"),
        "mass": (scope.states["mass"], "kg"),
        "volume": (volume, "m^3"),
        "heat_flow_rate": (heat, "W"),
        "work_rate": (work, "W"),
    }
    return GasBalance(outputs, rates, heat, scope.states["energy"], work)
