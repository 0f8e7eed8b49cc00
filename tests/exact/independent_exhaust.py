"""Machines after an event, by NumPy and SciPy only: exhaust times, travel after the event, and single faults of valves.

A machine is a table of numbers in SI units with gas volumes, flow paths, a regulator, valves, cylinders and a step
sequence. The equations are those of ISO 6358-1, of the energy balances and of Dupont et al. (2002), as printed in
`docs/equations.md`. No code of the package is used. `two_cylinders` is the machine that `poppet new machine` writes,
transcribed by hand; `small_circuit` is a tank with a 3/2 valve, a silencer and a cylinder without tubes.

From the time of an event on, a command or the pressure of a reservoir has a stated value, and a valve can have a fault.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import odeint

sys.path.insert(0, str(Path(__file__).parent))
from independent_sequences import AMBIENT, CV, GAS, KAPPA, WARM, flow, stop_force

Numbers = dict[str, Any]
BAR = 1e5
THRESHOLD = AMBIENT + 0.5 * BAR
SLOW = 10.0
LEAK = 0.05


def sonic_conductance(litres_per_minute: float, b: float, atmosphere: float = 1.01325e5) -> float:
    """Return C from a nominal flow at ANR from 6 to 5 bar gauge [m^3/(s Pa)]."""
    up, low = 6e5 + atmosphere, 5e5 + atmosphere
    r = (low / up - b) / (1.0 - b)
    return litres_per_minute / 6e4 / (up * math.sqrt(1.0 - r * r))


# Machines --------------------------------------------------------------------------------------------------------


def _drive(
    bore: float, rod: float, stroke: float, mass: float, coulomb: float, static: float, viscous: float
) -> Numbers:
    return {
        "bore": bore, "rod": rod, "stroke": stroke, "cap_dead": 15e-6, "rod_dead": 15e-6, "wall": 0.5, "position": 0.0,
        "cap_pressure": AMBIENT, "rod_pressure": 7 * BAR,
        "mass": mass, "coulomb": coulomb, "static": static, "viscous": viscous, "load": 0.0,
    }  # fmt: skip


def two_cylinders() -> Numbers:
    """Return the machine with two cylinders that clamps and punches."""
    size, ratio = sonic_conductance(300.0, 0.3), 0.3
    supply = sonic_conductance(1500.0, 0.3)
    throttle = 0.3e-8
    valve = {"edges": {"supply_a": (size, ratio), "supply_b": (size, ratio), "exhaust_a": (throttle, ratio),
                       "exhaust_b": (throttle, ratio)}, "supply": "rail", "on": 10e-3, "off": 10e-3}  # fmt: skip
    return {
        "reservoirs": {"supply": 9 * BAR, "ambient": AMBIENT},
        "chambers": {"bowl": (50e-6, 0.0, 9 * BAR), "rail": (200e-6, 0.5, 7 * BAR)},
        "paths": [("supply", "bowl", supply, 0.3)],
        "regulator": {"supply": "bowl", "outlet": "rail", "setpoint": 7 * BAR, "c": supply, "b": 0.3, "c_out": 0.2e-8,
                      "b_out": 0.3, "lag": 10e-3, "droop": BAR, "hysteresis": 0.05 * BAR, "relief": 0.1 * BAR},
        "valves": {
            "valveA": valve | {"a": "cylinderA.cap", "b": "cylinderA.rod", "commands": ("clamp",)},
            "valveB": valve | {"a": "cylinderB.cap", "b": "cylinderB.rod", "commands": ("punch", "lift")},
        },
        "drives": {
            "A": _drive(0.040, 0.016, 0.080, 3.0, 30.0, 45.0, 100.0),
            "B": _drive(0.050, 0.020, 0.050, 5.0, 50.0, 75.0, 150.0),
        },
        "sequence": _clamp_and_punch(),
        "starts": ((0.2, 0.3), (1.7, 1.8)),
    }  # fmt: skip


def _clamp_and_punch() -> Numbers:
    """Return outputs, transitions and timeout by step. A transition is a target and a function of the readings."""
    return {
        "wait": (("lift",), "A+", lambda r: r["start"] and r["rail"] > 6 * BAR, None),
        "A+": (("clamp", "lift"), "B+", lambda r: r["A"] > 0.078 and r["clamped"], 2.0),
        "B+": (("clamp", "punch"), "B-", lambda r: r["B"] > 0.048 and r["elapsed"] > 0.1 + 1e-7, 2.0),
        "B-": (("clamp", "lift"), "A-", lambda r: r["B"] < 0.002, 2.0),
        "A-": (("lift",), "wait", lambda r: r["A"] < 0.002, 2.0),
        "fault": (("lift",), "wait", lambda r: False, None),
    }


def small_circuit(command: float = 1.0) -> Numbers:
    """Return a tank, a 3/2 valve with a silencer, and a single-acting cylinder against a load."""
    size = sonic_conductance(400.0, 0.3)
    drive = _drive(0.032, 0.012, 0.1, 4.0, 15.0, 25.0, 60.0)
    return {
        "reservoirs": {"ambient": AMBIENT},
        "chambers": {"tank": (2e-3, 0.4, 7 * BAR), "port": (5e-6, 0.05, AMBIENT)},
        "paths": [("port", "ambient", 0.15e-8, 0.35), ("cylinder.rod", "ambient", 2e-8, 0.3)],
        "regulator": None,
        "valves": {"valve": {
            "edges": {"supply_a": (size, 0.3), "exhaust_a": (size, 0.3)}, "supply": "tank", "a": "cylinder.cap",
            "exhaust": "port", "on": 12e-3, "off": 20e-3, "commands": ("valve",),
        }},
        "drives": {"": drive | {"load": 120.0, "rod_pressure": AMBIENT}},
        "sequence": None,
        "constant": {"valve": command},
    }  # fmt: skip


def small_circuit_text(machine: Numbers, fields: str = "") -> str:
    """Write the small circuit as a circuit file without signals; `fields` are further lines of the valve."""
    valve, drive = machine["valves"]["valve"], machine["drives"][""]
    (size, ratio), (out, out_ratio) = valve["edges"]["supply_a"], valve["edges"]["exhaust_a"]
    (_, _, silencer, silencer_ratio), (_, _, vent, vent_ratio) = machine["paths"]
    (tank, tank_wall, tank_pressure), (port, port_wall, port_pressure) = machine["chambers"].values()
    return f"""
[parts.tank]
kind = "chamber"
volume = {tank}
wall_conductance = {tank_wall}
initial_pressure = {tank_pressure}
[parts.port]
kind = "chamber"
volume = {port}
wall_conductance = {port_wall}
initial_pressure = {port_pressure}
[parts.valve]
kind = "directional_valve"
supply = "tank"
outlet = "cylinder.cap"
exhaust = "port"
command = {machine["constant"]["valve"]}
switching_time = {valve["on"]}
closing_time = {valve["off"]}
sonic_conductance = {size}
critical_ratio = {ratio}
exhaust_conductance = {out}
exhaust_ratio = {out_ratio}
{fields}
[parts.silencer]
kind = "silencer"
from = "port"
to = "ambient"
sonic_conductance = {silencer}
critical_ratio = {silencer_ratio}
[parts.vent]
kind = "orifice"
from = "cylinder.rod"
to = "ambient"
sonic_conductance = {vent}
critical_ratio = {vent_ratio}
[parts.cylinder]
kind = "cylinder"
body = "slide"
bore = {drive["bore"]}
rod_diameter = {drive["rod"]}
stroke_length = {drive["stroke"]}
cap = {{ dead_volume = {drive["cap_dead"]}, wall_conductance = {drive["wall"]} }}
rod = {{ dead_volume = {drive["rod_dead"]}, wall_conductance = {drive["wall"]} }}
[parts.slide]
kind = "mass"
mass = {drive["mass"]}
load_force = {drive["load"]}
[parts.slide.friction]
kind = "elasto_plastic"
coulomb_force = {drive["coulomb"]}
static_force = {drive["static"]}
viscous_coefficient = {drive["viscous"]}
"""


# Simulation ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Event:
    """Value of a command of a valve, or pressure of a reservoir, from a time on."""

    time: float
    commands: Mapping[str, tuple[float, ...]]
    reservoirs: Mapping[str, float]


@dataclass(frozen=True)
class Fault:
    """Fault of a valve or of the regulator from a time on: stuck_open, stuck_closed, stuck, slow or leak."""

    valve: str
    word: str
    time: float


@dataclass(frozen=True)
class Run:
    """Pressures of the volumes, positions of the pistons and spools, and the steps of a run."""

    time: np.ndarray
    pressures: Mapping[str, np.ndarray]
    positions: Mapping[str, np.ndarray]
    spools: Mapping[str, np.ndarray]
    steps: tuple[tuple[float, str], ...]
    states: np.ndarray = field(default_factory=lambda: np.empty(0))

    def exhaust_time(self, volume: str, event: float, threshold: float = THRESHOLD) -> float:
        """Return the time after the event at which a pressure falls below a threshold for good."""
        pressure = self.pressures[volume]
        above = np.flatnonzero(pressure >= threshold)
        if not above.size or self.time[above[-1]] < event:
            return 0.0
        k = int(above[-1])
        if k == self.time.size - 1:
            return math.inf
        fraction = (pressure[k] - threshold) / (pressure[k] - pressure[k + 1])
        return float(self.time[k] + fraction * (self.time[k + 1] - self.time[k]) - event)

    def travel(self, drive: str, event: float) -> tuple[float, float]:
        """Return the path and the net displacement of a piston after an event."""
        position = self.positions[drive][self.time >= event - 1e-12]
        return float(np.sum(np.abs(np.diff(position)))), float(position[-1] - position[0])


@dataclass(frozen=True)
class Passage:
    """Flow of mass and enthalpy through a path."""

    name: str
    source: str
    target: str
    mass: float
    enthalpy: float


class Plant:
    """Right-hand side of a machine. The states are energy and mass of each volume, then regulator, spools, pistons."""

    def __init__(self, machine: Numbers) -> None:
        self.machine = machine
        self.pressures = dict(machine["reservoirs"])  # the values of reservoirs; volumes are added at each call
        self.volumes = [*machine["chambers"]]
        for name in machine["drives"]:
            self.volumes += [f"cylinder{name}.cap", f"cylinder{name}.rod"]
        self.first_spool = 2 * len(self.volumes) + 1
        self.first_drive = self.first_spool + len(machine["valves"])
        self.commands: dict[str, tuple[float, ...]] = {}
        self.faults: dict[str, str] = {}

    def start(self) -> np.ndarray:
        y: list[float] = []
        for volume, _, pressure in self.machine["chambers"].values():
            y += [pressure * volume / (KAPPA - 1.0), pressure * volume / (GAS * WARM)]
        for drive in self.machine["drives"].values():
            cap, ring = self.areas(drive)
            sizes = (drive["cap_dead"] + cap * drive["position"],
                     drive["rod_dead"] + ring * (drive["stroke"] - drive["position"]))  # fmt: skip
            for side, volume in zip(("cap", "rod"), sizes, strict=True):
                pressure = drive[f"{side}_pressure"]
                y += [pressure * volume / (KAPPA - 1.0), pressure * volume / (GAS * WARM)]
        y.append(0.0)
        y += [1.0 if self.machine.get("constant", {}).get(name) else -1.0 for name in self.machine["valves"]]
        for drive in self.machine["drives"].values():
            y += [drive["position"], 0.0, 0.0]
        return np.array(y)

    @staticmethod
    def areas(drive: Numbers) -> tuple[float, float]:
        """Return the areas of the cap side and of the rod side."""
        cap = 0.25 * math.pi * drive["bore"] ** 2
        return cap, cap - 0.25 * math.pi * drive["rod"] ** 2

    def gas(self, y: list[float]) -> tuple[dict[str, float], dict[str, float]]:
        """Return pressure and temperature by volume and reservoir."""
        p, t = dict(self.pressures), dict.fromkeys(self.pressures, WARM)
        sizes = [volume for volume, _, _ in self.machine["chambers"].values()]
        for k, drive in enumerate(self.machine["drives"].values()):
            cap, ring = self.areas(drive)
            x = y[self.first_drive + 3 * k]
            sizes += [drive["cap_dead"] + cap * x, drive["rod_dead"] + ring * (drive["stroke"] - x)]
        for k, (name, size) in enumerate(zip(self.volumes, sizes, strict=True)):
            energy, mass = y[2 * k], y[2 * k + 1]
            p[name], t[name] = (KAPPA - 1.0) * energy / size, energy / (mass * CV)
        return p, t

    def flows(self, y: list[float], p: dict[str, float], t: dict[str, float]) -> list[Passage]:
        """Return the flow through each path, positive from its source to its target."""
        passages = []
        for name, source, target, c, b in self._paths(y):
            q, h = flow(p[source], p[target], t[source], t[target], c, b) if c > 0.0 else (0.0, 0.0)
            passages.append(Passage(name, source, target, q, h))
        return passages

    def _paths(self, y: list[float]) -> Iterator[tuple[str, str, str, float, float]]:
        """Yield name, source, target, C and b of each flow path."""
        machine = self.machine
        for source, target, c, b in machine["paths"]:
            yield f"{source} to {target}", source, target, c, b
        if r := machine["regulator"]:
            z, relief = y[self.first_spool - 1], r["relief"] / r["droop"]
            filling = self.leaking("regulator", min(max(z, 0.0), 1.0))
            yield "regulator.supply", r["supply"], r["outlet"], r["c"] * filling, r["b"]
            relieving = self.leaking("regulator", min(max(-z - relief, 0.0), 1.0))
            yield "regulator.exhaust", r["outlet"], "ambient", r["c_out"] * relieving, r["b_out"]
        for k, (name, valve) in enumerate(machine["valves"].items()):
            s = y[self.first_spool + k]
            forward, back = (self.leaking(name, min(max(side, 0.0), 1.0)) for side in (s, -s))
            exhaust = valve.get("exhaust", "ambient")
            ways = {"supply_a": (valve["supply"], valve["a"], forward), "exhaust_a": (valve["a"], exhaust, back),
                    "supply_b": (valve["supply"], valve.get("b"), back),
                    "exhaust_b": (valve.get("b"), exhaust, forward)}  # fmt: skip
            for edge, (c, b) in valve["edges"].items():
                source, target, opening = ways[edge]
                yield f"{name}.{edge}", source, target, c * opening, b

    def leaking(self, valve: str, opening: float) -> float:
        """Return an opening of a valve, with the leak if it has one."""
        return opening + (LEAK * (1.0 - opening) if self.faults.get(valve) == "leak" else 0.0)

    def heats(self, t: dict[str, float]) -> dict[str, float]:
        """Return the heat flow from the wall to the gas in each volume."""
        walls = {name: wall for name, (_, wall, _) in self.machine["chambers"].items()}
        for name, drive in self.machine["drives"].items():
            walls |= dict.fromkeys((f"cylinder{name}.cap", f"cylinder{name}.rod"), drive["wall"])
        return {name: wall * (WARM - t[name]) for name, wall in walls.items()}

    def rates(self, y: list[float]) -> list[float]:
        p, t = self.gas(y)
        heat, mass = dict.fromkeys(p, 0.0) | self.heats(t), dict.fromkeys(p, 0.0)
        for passage in self.flows(y, p, t):
            mass[passage.source] -= passage.mass
            mass[passage.target] += passage.mass
            heat[passage.source] -= passage.enthalpy
            heat[passage.target] += passage.enthalpy
        z_rate = self._regulator_rate(y[self.first_spool - 1], p) if self.machine["regulator"] else 0.0
        spool_rates = [self._spool_rate(name, y[self.first_spool + k]) for k, name in enumerate(self.machine["valves"])]
        motion: list[float] = []
        for k, (name, drive) in enumerate(self.machine["drives"].items()):
            x, v, z = y[self.first_drive + 3 * k : self.first_drive + 3 * k + 3]
            motion += self._motion(name, drive, (x, v, z), p, heat)
        stored = [value for name in self.volumes for value in (heat[name], mass[name])]
        return [*stored, z_rate, *spool_rates, *motion]

    def _regulator_rate(self, z: float, p: dict[str, float]) -> float:
        r, fault = self.machine["regulator"], self.faults.get("regulator")
        if fault == "stuck":
            return 0.0
        if fault in ("stuck_open", "stuck_closed"):
            return ((fault == "stuck_open") - z) / r["lag"]
        error = (r["setpoint"] - p[r["outlet"]]) / r["droop"]
        half, relief = 0.5 * r["hysteresis"] / r["droop"], r["relief"] / r["droop"]
        rising, falling = min(error - half, 1.0) - z, max(error + half, -relief - 1.0) - z
        return (max(rising, 0.0) + min(falling, 0.0)) / r["lag"] / (SLOW if fault == "slow" else 1.0)

    def _spool_rate(self, name: str, s: float) -> float:
        valve, fault, commands = self.machine["valves"][name], self.faults.get(name), self.commands[name]
        first, second = commands if len(commands) == 2 else (commands[0], 1.0 - commands[0])
        wanted = first - second if first != second else math.copysign(1.0, s)
        if fault == "stuck":
            return 0.0
        if fault in ("stuck_open", "stuck_closed"):
            wanted = 1.0 if fault == "stuck_open" else -1.0
        speed = min(max(25.0 * (wanted - s), -1.0), 1.0)
        return 2.0 * speed / (valve["on"] if speed > 0.0 else valve["off"]) / (SLOW if fault == "slow" else 1.0)

    def _motion(
        self, name: str, drive: Numbers, state: tuple[float, float, float], p: dict[str, float], heat: dict[str, float]
    ) -> list[float]:
        """Return the rates of position, velocity and bristle, and add the work of the gas to the heat balances."""
        x, v, z = state
        cap, ring = self.areas(drive)
        p1, p2 = p[f"cylinder{name}.cap"], p[f"cylinder{name}.rod"]
        heat[f"cylinder{name}.cap"] -= p1 * cap * v
        heat[f"cylinder{name}.rod"] += p2 * ring * v
        friction, bristle_rate = elasto_plastic(drive, v, z)
        force = p1 * cap - p2 * ring - AMBIENT * (cap - ring) - friction - drive["load"]
        force += stop_force(-x, -v) - stop_force(x - drive["stroke"], v)
        return [v, force / drive["mass"], bristle_rate]


def elasto_plastic(drive: Numbers, v: float, z: float) -> tuple[float, float]:
    """Return the friction force, and the rate of the deflection of the bristles (Dupont et al. 2002)."""
    stiffness = max(drive["static"], drive["coulomb"]) / 1e-5
    fading = math.exp(-((v / 0.01) ** 2))
    steady = (drive["coulomb"] + (drive["static"] - drive["coulomb"]) * fading) / stiffness
    elastic = 0.95 * drive["coulomb"] / stiffness
    if v * z <= 0.0 or abs(z) <= elastic:
        alpha = 0.0
    elif abs(z) >= steady:
        alpha = 1.0
    else:
        alpha = 0.5 + 0.5 * math.sin(math.pi * (abs(z) - 0.5 * (steady + elastic)) / (steady - elastic))
    rate = v - alpha * abs(v) * z / steady
    damping = 2.0 * math.sqrt(stiffness * drive["mass"]) * fading
    return stiffness * z + damping * rate + drive["viscous"] * v, rate


class Controller:
    """Step sequence with a sample time of 5 ms, and a pressure switch with 1 ms; both read the values before."""

    def __init__(self, machine: Numbers) -> None:
        self.machine, self.step, self.samples, self.is_clamped = machine, "wait", -1, False
        self.log: list[tuple[float, str]] = [(0.0, "wait")]

    def commands(self) -> dict[str, tuple[float, ...]]:
        outputs = self.machine["sequence"][self.step][0]
        return {
            name: tuple(float(output in outputs) for output in valve["commands"])
            for name, valve in self.machine["valves"].items()
        }

    def sample(self, k: int, p: dict[str, float], positions: dict[str, float]) -> bool:
        """Act at the instant of k milliseconds, and return whether a step begins."""
        was_clamped, pressure = self.is_clamped, p["cylinderA.cap"]
        self.is_clamped = pressure > 5.5 * BAR or (self.is_clamped and pressure >= 5.0 * BAR)
        if k % 5:
            return False
        self.samples += 1
        is_started = any(start <= (k + 1e-6) * 1e-3 < end for start, end in self.machine["starts"])
        elapsed = 5e-3 * self.samples
        readings = positions | {"rail": p["rail"], "clamped": was_clamped, "start": is_started, "elapsed": elapsed}
        _, target, condition, timeout = self.machine["sequence"][self.step]
        if condition(readings):
            self.step = target
        elif timeout is not None and elapsed >= timeout - 1e-6:
            self.step = "fault"
        else:
            return False
        self.samples = 0
        self.log.append((1e-3 * k, self.step))
        return True


def simulate(
    machine: Numbers,
    duration: float,
    event: Event | None = None,
    fault: Fault | None = None,
    tolerance: float = 1e-8,
    rows_per_ms: int = 1,
) -> Run:
    """Simulate a machine; the times of event and fault are whole milliseconds."""
    plant = Plant(machine)
    controller = Controller(machine) if machine["sequence"] else None
    scale = [*([100.0, 1e-3] * len(plant.volumes)), 1.0, *[1.0] * len(machine["valves"])]
    scale += [0.1, 1.0, 1e-5] * len(machine["drives"])
    sizes = np.array(scale)
    y = plant.start()
    rows, last, chunk, k = [y], round(1e3 * duration), 16, 0
    marks = sorted(round(1e3 * item.time) for item in (event, fault) if item is not None)

    def act(k: int, y: np.ndarray) -> bool:
        p, _ = plant.gas(y.tolist())
        positions = {name: float(y[plant.first_drive + 3 * j]) for j, name in enumerate(machine["drives"])}
        is_changed = controller.sample(k, p, positions) if controller else False
        plant.commands = controller.commands() if controller else {n: (v,) for n, v in machine["constant"].items()}
        if event is not None and k >= round(1e3 * event.time):
            plant.commands |= event.commands
            plant.pressures |= event.reservoirs
        if fault is not None and k >= round(1e3 * fault.time):
            plant.faults = {fault.valve: fault.word}
        return is_changed or k in marks

    act(0, y)
    while k < last:
        end = min([k + chunk, last, *(mark for mark in marks if mark > k)])
        found = odeint(
            lambda t, y: plant.rates(y.tolist()), y, np.linspace(1e-3 * k, 1e-3 * end, (end - k) * rows_per_ms + 1),
            rtol=tolerance, atol=tolerance * sizes, tfirst=True, mxstep=100000,
        )  # fmt: skip
        chunk = min(2 * chunk, 128)
        for n in range(rows_per_ms, len(found), rows_per_ms):
            k, y = k + 1, found[n]
            rows.extend(found[n - rows_per_ms + 1 : n + 1])
            if act(k, y):
                chunk = 16
                break
    return _run(plant, 1e-3 / rows_per_ms, np.array(rows), tuple(controller.log) if controller else ())


def _run(plant: Plant, step: float, rows: np.ndarray, steps: tuple[tuple[float, str], ...]) -> Run:
    gas = [plant.gas(row.tolist())[0] for row in rows]
    drives, valves = plant.machine["drives"], plant.machine["valves"]
    return Run(
        time=step * np.arange(len(rows)),
        pressures={name: np.array([p[name] for p in gas]) for name in plant.volumes},
        positions={name: rows[:, plant.first_drive + 3 * k] for k, name in enumerate(drives)},
        spools={name: rows[:, plant.first_spool + k] for k, name in enumerate(valves)},
        steps=steps,
        states=rows,
    )
