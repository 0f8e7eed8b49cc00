"""Tanks of Cantera, whose reactors and valves share no line with this code."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.iso6358 import mass_flow_rate

ct = pytest.importorskip("cantera", reason="Cantera, the independent code, is not installed")

GAS_CONSTANT, KAPPA = 287.05, 1.4
SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def ideal_gas(pressure: float, temperature: float):
    """One species of constant heat capacity, whose atomic weight gives the gas constant."""
    heat_capacity = KAPPA / (KAPPA - 1.0) * ct.gas_constant
    gas = ct.Solution(
        yaml=f"""
elements:
- {{symbol: Pneu, atomic-weight: {ct.gas_constant / GAS_CONSTANT}}}
phases:
- {{name: air, thermo: ideal-gas, elements: [Pneu], species: [Pneu]}}
species:
- name: Pneu
  composition: {{Pneu: 1}}
  thermo: {{model: constant-cp, T0: 293.15 K, h0: 0 J/kmol, s0: 0 J/kmol/K, cp0: {heat_capacity} J/kmol/K}}
"""
    )
    gas.TP = temperature, pressure
    return gas


def reservoir(pressure: float):
    return ct.Reservoir(ideal_gas(pressure, 293.15), clone=False)


def tank(volume: float, pressure: float, temperature: float = 293.15):
    return ct.IdealGasReactor(ideal_gas(pressure, temperature), volume=volume, clone=False)


def joined(upstream, downstream):
    """A valve whose flow is the law's; only forward, as all these runs are."""

    def flow(drop: float) -> float:
        pressure = downstream.phase.P
        return mass_flow_rate(pressure + drop, pressure, upstream.T, downstream.T, **SIZE)

    valve = ct.Valve(upstream, downstream, K=1.0)
    valve.pressure_function = flow
    return valve


def advanced(reactors, times):
    """Pressure, temperature and mass of each reactor, (n_times, n_reactors, 3)."""
    net = ct.ReactorNet(list(reactors))
    net.rtol, net.atol = 1e-11, 1e-16
    rows = []
    for time in times:
        if time > 0.0:
            net.advance(time)
        rows.append([(reactor.phase.P, reactor.T, reactor.mass) for reactor in reactors])
    return np.array(rows)
