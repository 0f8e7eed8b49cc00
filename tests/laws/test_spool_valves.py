"""Spool valves of all functions: gas flows towards the lower pressure, and through no pilot port."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import SpoolValve
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.parts.spool_edges import EDGES
from poppet.parts.spool_functions import FUNCTIONS

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)


def random_valve(generator):
    function = str(generator.choice(list(FUNCTIONS)))
    fields = {"sonic_conductance": generator.uniform(0.0, 5e-8), "critical_ratio": generator.uniform(0.0, 0.6)}
    if generator.random() < 0.4:
        positions = [-1.0, *np.sort(generator.uniform(-0.9, 0.9, 3)), 1.0]
        fields = {"characteristic": {
            "position": positions, "sonic_conductance": list(generator.uniform(0.0, 5e-8, 5)),
            "critical_ratio": list(generator.uniform(0.0, 0.9, 5)),
        }}  # fmt: skip
    elif not function.startswith("5/3"):
        fields |= {"overlap": generator.uniform(-0.5, 0.5), "exhaust_overlap": generator.uniform(-0.5, 0.5)}
    pilots = {name: "line" for name in FUNCTIONS[function].pilots if generator.random() < 0.5}
    return SpoolValve(supply="rail", a="first", b="second", function=function, **fields, **pilots)


@pytest.mark.parametrize("seed", range(10))
def test_gas_flows_towards_the_lower_pressure(seed):
    generator = np.random.default_rng(seed)
    for _ in range(30):
        valve = random_valve(generator)
        gas = {port: GasState(*generator.uniform([0.5e5, 250.0], [9e5, 400.0])) for port in valve.ports()}
        commands = {item.name: generator.uniform(item.low, item.high) for item in valve.inputs()}
        scope = Scope(valve.parameters(AIR), {"position": generator.uniform(-1.2, 1.2)}, commands, AIR)
        result = valve.flows(scope, gas)
        assert {(flow.source, flow.target) for flow in result.flows} == {ends[:2] for ends in EDGES.values()}
        for flow in result.flows:
            difference = gas[flow.source].pressure - gas[flow.target].pressure
            assert flow.mass * difference >= 0.0
            upstream = gas[flow.source if flow.mass > 0.0 else flow.target]
            assert flow.enthalpy == pytest.approx(flow.mass * 1.4 / 0.4 * 287.05 * upstream.temperature, rel=1e-12)
