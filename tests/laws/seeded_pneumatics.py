"""Seeded random circuits of all flow paths and gas nodes: logic valves, regulators, ejectors, cylinders, tubes.

The shape of a circuit (parts, wiring, options) and its numbers have generators of their own: circuits of one shape need
one compilation. A closed circuit is adiabatic and has no port to the ambient or to a supply.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet import Circuit
from poppet.library.gases import GASES
from poppet.parts import KINDS
from poppet.timeseries.recording import Recording
from poppet.timeseries.signals import Steps

AMBIENT, WARM = 1e5, 293.15

Draw = Callable[[np.random.Generator], Any]
Fields = dict[str, Any]


def uniform(low: float, high: float) -> Draw:
    return lambda numbers: float(numbers.uniform(low, high))


def logarithmic(low: float, high: float) -> Draw:
    return lambda numbers: float(np.exp(numbers.uniform(math.log(low), math.log(high))))


def either(*values: Any) -> Draw:
    """One of the values, each a number or a draw."""

    def draw(numbers: np.random.Generator) -> Any:
        value = values[numbers.integers(len(values))]
        return value(numbers) if callable(value) else value

    return draw


CONDUCTANCE, RATIO, BAR = logarithmic(1e-10, 3e-8), uniform(0.05, 0.6), 1e5
SIZE: Fields = {"sonic_conductance": CONDUCTANCE, "critical_ratio": RATIO}
OPEN, SWITCHED = uniform(0.0, 1.0), either(0.0, 1.0)
CRACKING = either(0.0, logarithmic(1e3, 1e5))
SWITCHING: Fields = {"switching_pressure": logarithmic(5e2, 2e4), "switching_time": logarithmic(1e-3, 2e-2)}


@dataclass(frozen=True)
class PassageKind:
    """Ports and flows of a kind of flow path, the draws of its fields, and its inputs."""

    kind: str
    flows: dict[str, tuple[str, str]]  # output of a flow: its ports
    fields: Fields
    inputs: Fields
    pilots: tuple[str, ...] = ()  # ports without flow
    options: tuple[Fields, ...] = ({},)  # part of the shape

    @property
    def ports(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(port for ends in self.flows.values() for port in ends)) + self.pilots


_PATH = {"mass_flow_rate": ("from_", "to")}
_THREE_WAY = {"supply_mass_flow_rate": ("supply", "outlet"), "exhaust_mass_flow_rate": ("outlet", "exhaust")}
_SPOOL = {
    "supply_a_mass_flow_rate": ("supply", "a"),
    "supply_b_mass_flow_rate": ("supply", "b"),
    "exhaust_a_mass_flow_rate": ("a", "exhaust_a"),
    "exhaust_b_mass_flow_rate": ("b", "exhaust_b"),
}
PASSAGES = (
    PassageKind("orifice", _PATH, SIZE, {"opening": OPEN}),
    PassageKind("check_valve", _PATH, SIZE | {"cracking_pressure": CRACKING}, {}),
    PassageKind("relief_valve", _PATH, SIZE | {"set_pressure": uniform(2 * BAR, 6 * BAR)}, {}),
    PassageKind("silencer", _PATH, SIZE | {"clogging": OPEN}, {}),
    PassageKind("directional_valve", _THREE_WAY, SIZE, {"command": SWITCHED}),
    PassageKind(
        "spool_valve", _SPOOL, SIZE | {"leak_conductance": either(0.0, 1e-11)}, {"command": uniform(-1.0, 1.0)},
        options=({}, {"overlap": 0.1}, {"overlap": -0.1}, {"dynamics": "second_order"}),
    ),
)  # fmt: skip
_CHAMBERS: tuple[Fields, ...] = (
    {"thermal": "energy"},
    {"thermal": "energy"},
    {"thermal": "energy", "heat_transfer": "natural", "wall_area": 0.05, "height": 0.1},
    {"thermal": "energy", "wall_heat_capacity": 100.0, "outer_conductance": 1.0},
    {"thermal": "isothermal"},
    {"thermal": "polytropic", "polytropic_exponent": 1.2},
    {"thermal": "isentrope"},
)


@dataclass(frozen=True)
class RandomCircuit:
    """A circuit, its flows as (output, first node, second node), and its gas nodes with a mass."""

    circuit: Circuit
    flows: tuple[tuple[str, str, str], ...]
    stores: tuple[str, ...]
    duration: float
    is_closed: bool
    kinds: frozenset[str]

    @property
    def gas(self) -> tuple[float, float]:
        """Gas constant and specific heat capacity at constant pressure [J/(kg K)]."""
        gas = self.circuit.gas
        constant, exponent = float(gas.gas_constant), float(gas.isentropic_exponent)
        return constant, exponent * constant / (exponent - 1.0)


def draw_fields(fields: Fields, numbers: np.random.Generator) -> Fields:
    return {
        name: draw_fields(value, numbers) if isinstance(value, dict) else value(numbers) if callable(value) else value
        for name, value in fields.items()
    }


def random_circuit(shape: np.random.Generator, numbers: np.random.Generator) -> RandomCircuit:
    """Return a circuit of two to six gas volumes, and three to eight flow paths of random kinds between them."""
    is_closed = bool(shape.random() < 0.3)
    parts: dict[str, Any] = {}
    stores: list[str] = []
    for k in range(int(shape.integers(2, 5))):
        options = {} if is_closed else dict(_CHAMBERS[shape.integers(len(_CHAMBERS))])
        has_wall = options.get("thermal") == "energy" and "heat_transfer" not in options
        parts[f"tank{k}"] = KINDS["chamber"](
            volume=logarithmic(1e-5, 1e-2)(numbers), initial_pressure=logarithmic(0.5 * BAR, 9 * BAR)(numbers),
            **({} if options.get("thermal") == "isothermal" else {"initial_temperature": uniform(270, 340)(numbers)}),
            **({"wall_conductance": either(0.0, logarithmic(1e-2, 10.0))(numbers)} if has_wall else {}), **options,
        )  # fmt: skip
        stores.append(f"tank{k}")
    signals: dict[str, Any] = {}
    if shape.random() < 0.4:
        _add_cylinder(parts, signals, numbers)
        stores += ["cylinder.cap", "cylinder.rod"]
    if not is_closed and shape.random() < 0.15:
        _add_muscle(parts, signals, numbers)
        stores.append("muscle")
    if shape.random() < 0.25:
        parts["hose"] = KINDS["tube"](
            from_=stores[shape.integers(len(stores))], length=uniform(0.3, 3.0)(numbers), cells=2,
            bore=uniform(3e-3, 8e-3)(numbers), initial_pressure=uniform(1 * BAR, 6 * BAR)(numbers),
        )  # fmt: skip
        stores += ["hose.1", "hose.2"]
    nodes = list(stores)
    if not is_closed:
        parts["supply"] = KINDS["reservoir"](
            pressure=uniform(3 * BAR, 9 * BAR)(numbers), temperature=uniform(280, 310)(numbers)
        )
        nodes += ["supply", "ambient"]
    flows: list[tuple[str, str, str]] = []
    if shape.random() < 0.15:
        ends = dict(zip(("supply", "exhaust"), _pick(shape, nodes, 2), strict=True))
        parts["pilot"] = KINDS["pilot_stage"](**ends, data="vppm_6l", wall_conductance=0.0)
        flows += [("pilot.fill_mass_flow_rate", ends["supply"], "pilot")]
        flows += [("pilot.vent_mass_flow_rate", "pilot", ends["exhaust"])]
        signals |= {"pilot.fill_duty": OPEN, "pilot.vent_duty": OPEN}
        stores.append("pilot")
    kinds: set[str] = set()
    for k in range(int(shape.integers(3, 9))):
        item = PASSAGES[shape.integers(len(PASSAGES))]
        if len(item.ports) > len(nodes) + 1:
            continue
        ends = dict(zip(item.ports, _pick(shape, nodes, len(item.ports)), strict=True))
        option = item.options[shape.integers(len(item.options))]
        name = f"{item.kind}{k}"
        parts[name] = KINDS[item.kind](**ends, **draw_fields(item.fields | option, numbers))
        flows += [(f"{name}.{output}", ends[a], ends[b]) for output, (a, b) in item.flows.items()]
        kinds.add(item.kind)
        signals |= {f"{name}.{address}": draw for address, draw in item.inputs.items()}
    used = {node for flow in flows for node in flow[1:]}
    for node in (node for node in nodes if node not in used and node != "ambient"):
        other = next(iter(_pick(shape, [n for n in nodes if n != node], 1)))
        parts[f"link_{node.replace('.', '_')}"] = KINDS["orifice"](from_=node, to=other, **draw_fields(SIZE, numbers))
        flows.append((f"link_{node.replace('.', '_')}.mass_flow_rate", node, other))
    volumes = [float(part.volume) for part in parts.values() if part.kind == "chamber"]
    duration = float(np.median(volumes)) / (1e-9 * 1.185 * 287.0 * WARM) * logarithmic(0.03, 3.0)(numbers)
    times = [0.0, 0.2 * duration, 0.5 * duration, 0.8 * duration]
    drawn = {address: Steps(times, [draw(numbers) for _ in times]) for address, draw in signals.items()}
    gas = GASES[sorted(GASES)[numbers.integers(len(GASES))]]
    return RandomCircuit(
        Circuit(parts, drawn, gas=gas), tuple(flows), tuple(stores), duration, is_closed, frozenset(kinds)
    )


def _pick(shape: np.random.Generator, nodes: list[str], count: int) -> Iterator[str]:
    """Yield nodes at random, different ones as far as there are enough."""
    order = [nodes[k] for k in shape.permutation(len(nodes))]
    for k in range(count):
        yield order[k % len(order)]


def _add_cylinder(parts: dict[str, Any], signals: dict[str, Any], numbers: np.random.Generator) -> None:
    bore, stroke = logarithmic(0.01, 0.05)(numbers), uniform(0.02, 0.2)(numbers)
    dead = 0.25 * math.pi * bore**2 * stroke * 0.1
    force = 0.25 * math.pi * bore**2 * 6e5
    side = {"dead_volume": dead, "initial_pressure": uniform(1 * BAR, 6 * BAR)(numbers)}
    parts["slide"] = KINDS["mass"](
        mass=force / 100.0,
        friction={"kind": "viscous", "viscous_coefficient": force / 2.0},
        initial_position=0.5 * stroke,
    )
    parts["cylinder"] = KINDS["cylinder"](
        body="slide", bore=bore, rod_diameter=0.4 * bore, stroke_length=stroke, cap=side, rod=side,
        leakage={"sonic_conductance": either(0.0, 1e-11)(numbers)},
    )  # fmt: skip
    signals["slide.load_force"] = uniform(-0.3 * force, 0.3 * force)


def _add_muscle(parts: dict[str, Any], signals: dict[str, Any], numbers: np.random.Generator) -> None:
    parts["weight"] = KINDS["mass"](
        mass=uniform(5.0, 40.0)(numbers), inclination="90 deg", lower_stop={"position": 0.0}
    )
    parts["muscle"] = KINDS["muscle"](body="weight", data="dmsp_20_300", dead_volume=5e-6, damping=200.0)


def state_of(recording: Recording, node: str) -> tuple[Any, Any]:
    """Return pressure and temperature of a gas node."""
    if node == "ambient":
        return AMBIENT, WARM
    return recording[f"{node}.pressure"], recording[f"{node}.temperature"]


def entropy_production(item: RandomCircuit, recording: Recording, flow: tuple[str, str, str]) -> Any:
    """Return the entropy that a flow produces on its way and in the node that it enters [W/K], and its scale.

    The gas leaves the upstream node with its temperature and mixes with the downstream node.
    """
    (gas, capacity), rate = item.gas, recording[flow[0]]
    (p1, t1), (p2, t2) = (state_of(recording, node) for node in flow[1:])
    is_forward = rate >= 0.0
    up, down = np.where(is_forward, p1, p2), np.where(is_forward, p2, p1)
    hot, cold = np.where(is_forward, t1, t2), np.where(is_forward, t2, t1)
    production = gas * np.log(up / down) + capacity * (hot / cold - 1.0 - np.log(hot / cold))
    return np.abs(rate) * production, np.abs(rate) * gas


def gas_entropy(item: RandomCircuit, recording: Recording) -> Any:
    """Return the entropy of all gas in the circuit [J/K], and its mass times the gas constant."""
    gas, capacity = item.gas
    total, scale = np.zeros(recording.time.size), np.zeros(recording.time.size)
    for node in item.stores:
        pressure, temperature = state_of(recording, node)
        mass = recording[f"{node}.mass"]
        total += mass * (capacity * np.log(temperature / WARM) - gas * np.log(pressure / AMBIENT))
        scale += mass * gas
    return total, scale
