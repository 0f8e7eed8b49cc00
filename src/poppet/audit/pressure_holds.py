"""Reasons for which a volume keeps its pressure: closed elements, a supply, or a slow exhaust."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from poppet.audit.safety_result import FALLING, SUPPLIED, TRAPPED
from poppet.engine.call import Call
from poppet.engine.problem import Problem
from poppet.parts.faults import Valve
from poppet.parts.part import AMBIENT, Part
from poppet.parts.supply import PressureRegulator
from poppet.timeseries.checks import FloatArray

PROBE = 0.02
"""Relative change of the content of a volume with which a flow path is tested."""
CLOSED = 1e-6
"""Flow rate per content of a volume below which a flow path is closed [1/s]."""
EQUAL = 0.02
"""Relative difference of absolute pressures below which two volumes have the same pressure."""
_CONTENT = ("Pa", "kg", "J")
"""Units of the states that are proportional to the content of a volume."""


class Hold(NamedTuple):
    """Reason for which a volume keeps its pressure, and the parts that cause it."""

    reason: str
    by: tuple[str, ...]


class FinalState:
    """State at the end of a run, at which flow paths are tested.

    `problem` defines the run, and `parts` contains the parts of its circuit. `stuck` is the name of the valve that is
    stuck in the run; it is empty without such a valve.
    """

    def __init__(self, problem: Problem, parts: Mapping[str, Part], ambient_pressure: float, stuck: str = "") -> None:
        self.problem, self.model = problem, problem.kernel.model
        self.closing = {name for name, part in parts.items() if isinstance(part, Valve)}
        # A regulator that is closed at its setpoint opens as soon as the pressure falls, unless it is stuck.
        regulators = {name for name, part in parts.items() if isinstance(part, PressureRegulator)}
        self.regulators = regulators - {stuck}
        call = Call(replace(problem, grid=problem.grid[-1:]))
        run = call.run()
        self.is_valid = run.outcome.is_success and run.time.size == 1
        self.x, self.p = run.x.copy(), problem.p.copy()
        self.p[len(self.model.parameters) :] = call.memory
        names = [name for name, _ in self.model.outputs]
        final = dict(zip(names, run.values[:, -1].tolist(), strict=True)) if self.is_valid else {}
        self.u = np.array([final.get(item.name, 0.0) for item in self.model.inputs], dtype=np.float64)
        self.pressures = {AMBIENT: ambient_pressure}
        self.pressures |= {n[: -len(".pressure")]: v for n, v in final.items() if n.endswith(".pressure")}
        self.masses = {store.name: float(self.x[store.mass]) for store in self.model.stores}
        self.indices = {name: k for k, name in enumerate(names)}

    def flows(self, volume: str = "", factor: float = 1.0) -> dict[str, float]:
        """Return all mass flow rates [kg/s] by name, with the content of one volume multiplied by a factor."""
        x = self.x.copy()
        for k, state in enumerate(self.model.states):
            if state.name.rpartition(".")[0] == volume and state.unit in _CONTENT:
                x[k] *= factor
        y: FloatArray = np.empty(len(self.model.outputs))
        self.problem.kernel.call("outputs", np.array([self.problem.grid[-1]]), x, self.u, self.p, y)
        return {flow.name: float(y[self.indices[flow.name]]) for flow in self.model.flows}

    def hold(self, volume: str) -> Hold:
        """Return the reason for which a volume keeps its pressure.

        Volumes of the same pressure with an open flow path between them are one volume. The gas is supplied if such a
        volume is a reservoir, or if gas flows in from a higher pressure. It is trapped if every flow path to a lower
        pressure is closed.
        """
        supplies: list[str] = []
        exits: list[str] = []
        closed: list[str] = []
        group = [volume]
        for node in group:
            raised, lowered, present = self.flows(node, 1.0 + PROBE), self.flows(node, 1.0 - PROBE), self.flows()
            limit, pressure = CLOSED * self.masses[node], self.pressures[node]
            for flow in self.model.flows:
                if node not in (flow.source, flow.target):
                    continue
                neighbour = flow.target if flow.source == node else flow.source
                sign, part = (1.0 if flow.source == node else -1.0), flow.name.partition(".")[0]
                if neighbour is None or neighbour in group:
                    continue
                is_outlet, is_inlet = sign * raised[flow.name] > limit, -sign * lowered[flow.name] > limit
                difference = self.pressures[neighbour] - pressure
                if abs(difference) <= EQUAL * pressure and (is_outlet or is_inlet):
                    (group if neighbour in self.masses else supplies).append(neighbour)
                elif difference > 0.0 and (is_inlet or part in self.regulators):
                    supplies.append(part)
                elif difference < 0.0:
                    (exits if sign * present[flow.name] > limit else closed).append(part)
        for reason, parts in ((SUPPLIED, supplies), (FALLING, exits)):
            if parts:
                return Hold(reason, tuple(dict.fromkeys(parts)))
        # A cylinder or a tube without a leak is closed as well, but cannot open.
        valves = [part for part in closed if part in self.closing]
        return Hold(TRAPPED, tuple(dict.fromkeys(valves or closed)))
