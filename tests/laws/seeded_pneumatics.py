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
from poppet.parts.faults import Valve
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
BOOSTER_FRICTION: Fields = {"kind": "viscous", "viscous_coefficient": logarithmic(50.0, 1000.0)}
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
    is_driven: bool = False  # one flow does work on another

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
_SWITCHED_SPOOL: Fields = {"switching_time": logarithmic(2e-3, 5e-2), "closing_time": logarithmic(2e-3, 5e-2)}
_EJECTOR = {"supply_mass_flow_rate": ("supply", "exhaust"), "vacuum_mass_flow_rate": ("vacuum", "exhaust")}
_TWO_INLETS = {"a_mass_flow_rate": ("a", "outlet"), "b_mass_flow_rate": ("b", "outlet")}
_QUICK_EXHAUST = {"inlet_mass_flow_rate": ("inlet", "outlet"), "exhaust_mass_flow_rate": ("outlet", "exhaust")}
PASSAGES = (
    PassageKind("orifice", _PATH, SIZE, {"opening": OPEN}),
    PassageKind("check_valve", _PATH, SIZE | {"cracking_pressure": CRACKING}, {}),
    PassageKind("relief_valve", _PATH, SIZE | {"set_pressure": uniform(2 * BAR, 6 * BAR)}, {}),
    PassageKind("silencer", _PATH, SIZE | {"clogging": OPEN}, {}),
    PassageKind("filter", _PATH, SIZE, {"clogging": OPEN}),
    PassageKind("directional_valve", _THREE_WAY, SIZE, {"command": SWITCHED}),
    PassageKind(
        "spool_valve", _SPOOL, SIZE | {"leak_conductance": either(0.0, 1e-11)}, {"command": uniform(-1.0, 1.0)},
        options=({}, {"overlap": 0.1}, {"overlap": -0.1}, {"dynamics": "second_order"}),
    ),
    PassageKind(
        "spool_valve", _SPOOL, SIZE | _SWITCHED_SPOOL, {"command": SWITCHED}, options=({"function": "5/2 monostable"},)
    ),
    PassageKind(
        "spool_valve", _SPOOL, SIZE | _SWITCHED_SPOOL, {"command_a": SWITCHED, "command_b": SWITCHED},
        options=tuple(
            {"function": name} for name in ("5/2 bistable", "5/3 closed", "5/3 exhausted", "5/3 pressurised")
        ),
    ),
    PassageKind(
        "spool_valve", _SPOOL, SIZE | _SWITCHED_SPOOL | {"pilot_pressure": uniform(2.2 * BAR, 5 * BAR)}, {},
        pilots=("pilot_a", "pilot_b"), options=({"function": "5/2 bistable"}, {"function": "5/3 closed"}),
    ),
    PassageKind(
        "main_stage", _THREE_WAY, {"data": "varga2012", "leak_conductance": either(0.0, logarithmic(1e-12, 1e-9))},
        {"pilot_pressure": uniform(1 * BAR, 6 * BAR)},
    ),
    PassageKind(
        "pressure_regulator", _THREE_WAY,
        SIZE | {"exhaust_conductance": CONDUCTANCE, "droop": logarithmic(5e3, 1e5), "hysteresis": either(0.0, 5e3)},
        {"setpoint": uniform(1.5 * BAR, 7 * BAR)},
    ),
    PassageKind(
        "vacuum_ejector", _EJECTOR,
        {
            "nozzle_conductance": logarithmic(3e-11, 3e-9), "max_suction_flow": logarithmic(1e-5, 1e-2),
            "max_vacuum": uniform(3e4, 9e4),
        },
        {}, options=({}, {"check_valve": "true"}), is_driven=True,
    ),
    PassageKind("shuttle_valve", _TWO_INLETS, SIZE | SWITCHING, {}),
    PassageKind("two_pressure_valve", _TWO_INLETS, SIZE | SWITCHING, {}),
    PassageKind("quick_exhaust_valve", _QUICK_EXHAUST, SIZE | SWITCHING | {"exhaust_conductance": CONDUCTANCE}, {}),
    PassageKind(
        "flow_control_valve", _PATH, SIZE | {"cracking_pressure": CRACKING, "throttle_conductance": CONDUCTANCE},
        {"opening": OPEN},
    ),
    PassageKind(
        "piloted_check_valve", _PATH, SIZE | {"cracking_pressure": CRACKING, "pilot_ratio": uniform(1.0, 5.0)}, {},
        pilots=("pilot",),
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
    """A circuit, its flows as (output, first node, second node), and its gas nodes with a mass.

    The flows are in groups: only the total entropy production of a group is not negative.
    """

    circuit: Circuit
    groups: tuple[tuple[tuple[str, str, str], ...], ...]
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


def random_circuit(
    shape: np.random.Generator, numbers: np.random.Generator, *, has_faults: bool = False
) -> RandomCircuit:
    """Return a circuit of two to six gas volumes, and flow paths of random kinds between them.

    With `has_faults`, all valves have a random fault, from a random time on or as far as a random signal.
    """
    builder = _Builder(shape, numbers, has_faults)
    builder.add_volumes()
    for k in range(int(shape.integers(3, 9))):
        item = PASSAGES[shape.integers(len(PASSAGES))]
        if len(item.ports) <= len(builder.nodes):
            builder.add_passage(f"{item.kind}{k}", item)
    builder.add_links()
    return builder.circuit()


class _Builder:
    """Parts, signals and flows of a random circuit."""

    def __init__(self, shape: np.random.Generator, numbers: np.random.Generator, has_faults: bool) -> None:
        self.shape, self.numbers, self.has_faults = shape, numbers, has_faults
        self.is_closed = bool(shape.random() < 0.3)
        self.parts: dict[str, Any] = {}
        self.stores: list[str] = []
        self.signals: dict[str, Draw] = {}
        self.groups: list[tuple[tuple[str, str, str], ...]] = []

    def add(self, name: str, kind: str, stores: tuple[str, ...] = (), **fields: Any) -> None:
        self.parts[name] = KINDS[kind](**draw_fields(fields, self.numbers))
        self.stores += stores

    def is_drawn(self, probability: float) -> bool:
        return bool(self.shape.random() < probability)

    @property
    def nodes(self) -> list[str]:
        return [*self.open_stores, *([] if self.is_closed else ["supply", "ambient"])]

    @property
    def open_stores(self) -> list[str]:
        # No other part connects to the chambers of a booster.
        return [name for name in self.stores if not name.startswith("booster.")]

    def add_volumes(self) -> None:
        for k in range(int(self.shape.integers(2, 5))):
            self._add_chamber(f"tank{k}")
        if not self.is_closed:
            self.add("supply", "reservoir", pressure=uniform(3 * BAR, 9 * BAR), temperature=uniform(280, 310))
            if self.is_drawn(0.15):
                self._add_muscle()
            if self.is_drawn(0.2):
                self._add_compressor()
            if self.is_drawn(0.2):
                self._add_cup()
        for probability, add in (
            (0.4, self._add_cylinder),
            (0.15, self._add_gripper),
            (0.15, self._add_rotary_actuator),
        ):
            if self.is_drawn(probability):
                add()
        if self.is_drawn(0.15) and len(self.nodes) >= 3:
            self._add_booster()
        if self.is_drawn(0.25):
            end = self.open_stores[self.shape.integers(len(self.open_stores))]
            sizes = {"length": uniform(0.3, 3.0), "bore": uniform(3e-3, 8e-3)}
            self.add("hose", "tube", ("hose.1", "hose.2"), from_=end, cells=2,
                     initial_pressure=uniform(1 * BAR, 6 * BAR), **sizes)  # fmt: skip
        if self.is_drawn(0.15):
            ends = dict(zip(("supply", "exhaust"), _pick(self.shape, self.nodes, 2), strict=True))
            self.add("pilot", "pilot_stage", ("pilot",), data="vppm_6l", wall_conductance=0.0, **ends)
            self.groups.append((("pilot.fill_mass_flow_rate", ends["supply"], "pilot"),))
            self.groups.append((("pilot.vent_mass_flow_rate", "pilot", ends["exhaust"]),))
            self.signals |= {"pilot.fill_duty": OPEN, "pilot.vent_duty": OPEN}

    def _add_chamber(self, name: str) -> None:
        options = {} if self.is_closed else dict(_CHAMBERS[self.shape.integers(len(_CHAMBERS))])
        if options.get("thermal") == "energy" and "heat_transfer" not in options:
            options["wall_conductance"] = either(0.0, logarithmic(1e-2, 10.0))
        if options.get("thermal") != "isothermal":
            options["initial_temperature"] = uniform(270, 340)
        pressure = logarithmic(0.5 * BAR, 9 * BAR)
        self.add(name, "chamber", (name,), volume=logarithmic(1e-5, 1e-2), initial_pressure=pressure, **options)

    def _add_cylinder(self) -> None:
        bore, stroke = logarithmic(0.01, 0.05)(self.numbers), uniform(0.02, 0.2)(self.numbers)
        area = 0.25 * math.pi * bore**2
        friction = {"kind": "viscous", "viscous_coefficient": 3e5 * area}
        self.add("slide", "mass", mass=6e3 * area, friction=friction, initial_position=0.5 * stroke)
        side = {"dead_volume": 0.1 * area * stroke, "initial_pressure": uniform(1 * BAR, 6 * BAR)}
        self.add(
            "cylinder", "cylinder", ("cylinder.cap", "cylinder.rod"), body="slide", bore=bore, rod_diameter=0.4 * bore,
            stroke_length=stroke, cap=side, rod=side, leakage={"sonic_conductance": either(0.0, 1e-11)},
        )  # fmt: skip
        self.signals["slide.load_force"] = uniform(-2e5 * area, 2e5 * area)

    def _add_gripper(self) -> None:
        side = {"dead_volume": logarithmic(1e-6, 1e-4), "initial_pressure": uniform(1 * BAR, 6 * BAR)}
        self.add(
            "gripper", "gripper", ("gripper.cap", "gripper.rod"), bore=uniform(0.01, 0.04), cap=side, rod=side,
            jaws={"mass": uniform(0.1, 1.0), "friction": {"kind": "viscous", "viscous_coefficient": 50.0}},
            jaw_stroke=uniform(2e-3, 2e-2), workpiece={"width": 5e-3},
        )  # fmt: skip
        self.signals |= {"gripper.workpiece": SWITCHED, "gripper.jaws.load_force": uniform(-10.0, 10.0)}

    def _add_rotary_actuator(self) -> None:
        side = {"dead_volume": logarithmic(1e-6, 1e-4), "initial_pressure": uniform(1 * BAR, 6 * BAR)}
        friction = {"kind": "viscous", "viscous_coefficient": uniform(0.05, 1.0)}
        self.add(
            "rotary", "rotary_actuator", ("rotary.forward", "rotary.backward"), displacement=logarithmic(1e-6, 3e-5),
            swivel_angle=uniform(0.5, 4.0), shaft={"inertia": logarithmic(1e-3, 1e-1), "friction": friction},
            forward=side, backward=side,
        )  # fmt: skip
        self.signals["rotary.shaft.load_torque"] = uniform(-1.0, 1.0)

    def _add_booster(self) -> None:
        ends = dict(zip(("supply", "outlet", "exhaust"), _pick(self.shape, self.nodes, 3), strict=True))
        valve = {"sonic_conductance": logarithmic(1e-9, 3e-8), "critical_ratio": RATIO}
        self.add(
            "booster", "pressure_booster", (), pressure_ratio=uniform(1.5, 4.0), bore=uniform(0.02, 0.06),
            stroke_length=uniform(0.02, 0.1), piston={"mass": uniform(0.5, 3.0), "friction": BOOSTER_FRICTION},
            valve=valve, checks=valve, **ends,
        )  # fmt: skip
        for side in "ab":
            drive, boost = f"booster.drive_{side}", f"booster.boost_{side}"
            self.stores += [drive, boost]
            flows = {
                "supply": (ends["supply"], drive), "exhaust": (drive, ends["exhaust"]),
                "intake": (ends["supply"], boost), "delivery": (boost, ends["outlet"]),
            }  # fmt: skip
            self.groups += [((f"booster.{name}_{side}_mass_flow_rate", *nodes),) for name, nodes in flows.items()]

    def _add_muscle(self) -> None:
        stop = {"position": 0.0}
        self.add("weight", "mass", mass=uniform(5.0, 40.0), inclination="90 deg", lower_stop=stop)
        self.add("muscle", "muscle", ("muscle",), body="weight", data="dmsp_20_300", dead_volume=5e-6, damping=200.0)

    def _add_compressor(self) -> None:
        limits = {"start_pressure": uniform(4 * BAR, 6 * BAR), "stop_pressure": uniform(7 * BAR, 9 * BAR)}
        cooling = "aftercooler" if self.is_drawn(0.5) else "none"
        self.add("compressor", "compressor", outlet="tank0", free_air_delivery=logarithmic(1e-4, 1e-2), cooling=cooling,
                 efficiency=uniform(0.4, 1.0), **limits)  # fmt: skip

    def _add_cup(self) -> None:
        end = self.stores[self.shape.integers(len(self.stores))]
        fields = {"volume": logarithmic(1e-6, 1e-4), "diameter": uniform(0.01, 0.08)}
        self.add(
            "cup", "suction_cup", ("cup",), port=end, leak_conductance=either(0.0, logarithmic(1e-12, 1e-9)), **fields
        )
        self.groups += [(("cup.port_mass_flow_rate", end, "cup"),), (("cup.leak_mass_flow_rate", "ambient", "cup"),)]
        self.signals |= {"cup.sealed": SWITCHED, "cup.load_force": uniform(0.0, 100.0)}

    def _add_void(self, name: str) -> str:
        """Add a small volume that an ejector can evacuate, with a leak."""
        pressure = uniform(0.3 * BAR, 1.1 * BAR)
        self.add(name, "chamber", (name,), volume=logarithmic(1e-5, 1e-3), initial_pressure=pressure)
        leak = SIZE | {"sonic_conductance": logarithmic(1e-10, 1e-7)}
        self.add(f"{name}_leak", "orifice", from_="ambient", to=name, **leak)
        self.groups.append(((f"{name}_leak.mass_flow_rate", "ambient", name),))
        return name

    def add_passage(self, name: str, item: PassageKind) -> None:
        ends = dict(zip(item.ports, _pick(self.shape, self.nodes, len(item.ports)), strict=True))
        if item.is_driven and not self.is_closed and self.is_drawn(0.8):
            ends = {"supply": "supply", "vacuum": self._add_void(f"void_{name}"), "exhaust": "ambient"}
        option = item.options[self.shape.integers(len(item.options))]
        fault: Fields = {}
        if self.has_faults and issubclass(KINDS[item.kind], Valve):
            # The words have the same equations, so they are numbers.
            fault = {"fault": either(*KINDS[item.kind].faults), "slow_factor": logarithmic(1.0, 30.0),
                     "leak_fraction": uniform(0.0, 1.0)}  # fmt: skip
            if self.is_drawn(0.4):
                self.signals[f"{name}.fault"] = either(0.0, 1.0, uniform(0.0, 1.0))
            else:
                fault["fault_start"] = either(0.0, logarithmic(1e-3, 1.0))
        self.add(name, item.kind, **ends, **item.fields, **option, **fault)
        flows = [(f"{name}.{output}", ends[first], ends[second]) for output, (first, second) in item.flows.items()]
        self.groups += [tuple(flows)] if item.is_driven else [(flow,) for flow in flows]
        self.signals |= {f"{name}.{address}": draw for address, draw in item.inputs.items()}

    def add_links(self) -> None:
        """Connect the gas nodes that no flow path uses."""
        used = {node for group in self.groups for flow in group for node in flow[1:]}
        link = next(item for item in PASSAGES if item.kind == "orifice")
        for node in (node for node in self.nodes if node not in used and node != "ambient"):
            other = next(_pick(self.shape, [name for name in self.nodes if name != node], 1))
            name = f"link_{node.replace('.', '_')}"
            self.add(name, "orifice", from_=node, to=other, **link.fields)
            self.groups.append(((f"{name}.mass_flow_rate", node, other),))

    def circuit(self) -> RandomCircuit:
        volumes = [float(part.volume) for part in self.parts.values() if part.kind == "chamber"]
        # Multiples of a time constant with C of 0.1 dm^3/(s bar).
        duration = float(np.median(volumes)) / (1e-9 * 1e5) * logarithmic(0.03, 3.0)(self.numbers)
        times = [0.0, 0.2 * duration, 0.5 * duration, 0.8 * duration]
        signals = {address: Steps(times, [draw(self.numbers) for _ in times]) for address, draw in self.signals.items()}
        gas = GASES[sorted(GASES)[self.numbers.integers(len(GASES))]]
        circuit = Circuit(self.parts, signals, gas=gas)
        groups, stores, kinds = (
            tuple(self.groups),
            tuple(self.stores),
            frozenset(part.kind for part in self.parts.values()),
        )
        return RandomCircuit(circuit, groups, stores, duration, self.is_closed, kinds)


def _pick(shape: np.random.Generator, nodes: list[str], count: int) -> Iterator[str]:
    """Yield nodes at random, different ones as far as there are enough."""
    order = [nodes[k] for k in shape.permutation(len(nodes))]
    for k in range(count):
        yield order[k % len(order)]


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
