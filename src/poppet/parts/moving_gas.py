"""Gas in a volume that a body changes, for cylinder chambers and muscles."""

from __future__ import annotations

from typing import Any

from poppet.laws.physics import gas as gas_law
from poppet.parts.part import GasBalance, GasState, Quantities, Scope, State

STATES = (State("energy", "J", 100.0, positive=True), State("mass", "kg", 1e-3, positive=True))
"""Internal energy and mass: the balances of mass and energy are linear in these states for any motion."""


def initial_states(scope: Scope, volume: Any) -> dict[str, Any]:
    """Return the states at the initial pressure and temperature."""
    pressure, gas = scope["initial_pressure"], scope.surroundings
    mass = gas_law.mass(pressure, volume, scope["initial_temperature"], gas.gas_constant)
    return {"energy": pressure * volume / (gas.isentropic_exponent - 1.0), "mass": mass}


def gas_state(scope: Scope, volume: Any) -> GasState:
    """Return the gas state in a volume."""
    energy, mass, gas = scope.states["energy"], scope.states["mass"], scope.surroundings
    return GasState((gas.isentropic_exponent - 1.0) * energy / volume, energy / (mass * gas.heat_capacity_volume))


def balance(scope: Scope, gas: GasState, volume: Any, growth: Any, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
    """Return rates and outputs by U' = sum of enthalpy flows + heat - p V', with `growth` V'."""
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
