"""Machines with cylinders, valves and a step sequence by NumPy and SciPy only; shares no code with the package.

The equations are those of ISO 6358-1 and of the energy balances in `docs/equations.md`; the parts have the fields of
`docs/circuit_file.md`. The integration ends and restarts at each transition of the sequence. A machine is a table of
numbers: `circuit_text` writes it as a circuit file, `simulate_machine` runs it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from scipy.integrate import odeint

GAS, KAPPA, WARM, AMBIENT = 287.05, 1.4, 293.15, 1e5
CV = GAS / (KAPPA - 1.0)
CP = KAPPA * CV
DENSITY, LAMINAR = 1.185, 0.999
STOP, LOSS = 1e8, 5.0  # stiffness and dissipation of covers
STATES = 8  # of a drive: energy and mass of both chambers, position, velocity, spool, deflection of the bristles

Condition = tuple[Any, ...]


def flow(p1: float, p2: float, t1: float, t2: float, c: float, b: float) -> tuple[float, float]:
    """Mass flow rate from 1 to 2, and the enthalpy flow that it carries."""
    up, low, sign, t = (p1, p2, 1.0, t1) if p1 >= p2 else (p2, p1, -1.0, t2)
    q = sign * c * DENSITY * up * math.sqrt(WARM / t)
    r = low / up
    if r > LAMINAR:
        u = (LAMINAR - b) / (1.0 - b)
        edge = 1.0 - u * u
        slope, z = (1.0 - LAMINAR) * u / ((1.0 - b) * edge), (1.0 - r) / (1.0 - LAMINAR)
        q *= math.sqrt(edge) * z * (1.0 + 0.5 * (1.0 - z * z) * (1.0 - slope))
    elif r > b:
        u = (r - b) / (1.0 - b)
        q *= math.sqrt(1.0 - u * u)
    return q, CP * t * q


def stop_force(depth: float, speed: float) -> float:
    """Contact force of a cover."""
    if depth <= 0.0:
        return 0.0
    u = LOSS * speed
    return STOP * depth**1.5 * (1.0 + u / math.sqrt(1.0 + u * u))


def drive_rates(drive: dict[str, Any]) -> Callable[..., tuple[list[float], float, float]]:
    """Return the rates of one drive as a function of its states, the rail and the commands.

    The function also returns the flows of mass and enthalpy out of the rail.
    """
    area, rod_area = 0.25 * math.pi * drive["bore"] ** 2, 0.25 * math.pi * drive["rod"] ** 2
    ring, stroke, dead1, dead2 = area - rod_area, drive["stroke"], drive["cap_dead"], drive["rod_dead"]
    wall, mass, load = drive["wall"], drive["mass"], drive["load"]
    law, coulomb, static = drive["friction"], drive["coulomb"], drive["static"]
    stribeck, viscous, transition = drive["stribeck"], drive["viscous"], drive["transition"]
    bristle = max(static, coulomb, 1e-2) / 1e-5
    micro = 2.0 * math.sqrt(bristle * mass)
    c, b, c_out, b_out = drive["conductance"], drive["ratio"], drive["exhaust_conductance"], drive["exhaust_ratio"]
    spool_rate = switched_spool(drive["on_time"], drive["off_time"])

    def rates(y: list[float], p0: float, t0: float, commands: tuple[float, ...]) -> tuple[list[float], float, float]:
        u1, m1, u2, m2, x, v, s, z = y
        v1, v2 = dead1 + area * x, dead2 + ring * (stroke - x)
        p1, p2, t1, t2 = (KAPPA - 1.0) * u1 / v1, (KAPPA - 1.0) * u2 / v2, u1 / (m1 * CV), u2 / (m2 * CV)
        opening = min(abs(s), 1.0)
        if s > 0.0:  # supply to a, b to exhaust
            q1, h1 = flow(p0, p1, t0, t1, c * opening, b)
            q2, h2 = flow(AMBIENT, p2, WARM, t2, c_out * opening, b_out)
            q0, h0 = q1, h1
        else:
            q1, h1 = flow(AMBIENT, p1, WARM, t1, c_out * opening, b_out)
            q2, h2 = flow(p0, p2, t0, t2, c * opening, b)
            q0, h0 = q2, h2
        fading = math.exp(-((v / stribeck) ** 2))
        level = coulomb + (static - coulomb) * fading
        slip = 0.0
        friction = viscous * v
        if law == "stribeck":
            friction += level * math.tanh(v / transition)
        elif law == "lugre":
            slip = v - bristle * abs(v) / level * z
            friction += bristle * z + micro * fading * slip
        force = p1 * area - p2 * ring - AMBIENT * rod_area - friction - load
        force += stop_force(-x, -v) - stop_force(x - stroke, v)
        return (
            [
                h1 + wall * (WARM - t1) - p1 * area * v, q1, h2 + wall * (WARM - t2) + p2 * ring * v, q2,
                v, force / mass, spool_rate(s, commands), slip,
            ],
            q0, h0,
        )  # fmt: skip

    return rates


def switched_spool(on_time: float, off_time: float) -> Callable[[float, tuple[float, ...]], float]:
    """Return the speed of the spool of a 5/2 valve between -1 and 1.

    It moves at constant speed, and exponentially in the last 1/50 of its travel. With one command, a spring returns it.
    With two commands, it moves on to the end that is nearer if both or none is set.
    """

    def rate(s: float, commands: tuple[float, ...]) -> float:
        first, second = commands if len(commands) == 2 else (commands[0], 1.0 - commands[0])
        wanted = first - second if first != second else math.copysign(1.0, s)
        speed = min(max(25.0 * (wanted - s), -1.0), 1.0)
        return 2.0 * speed / (on_time if speed > 0.0 else off_time)

    return rate


def machine_rates(machine: dict[str, Any]) -> Callable[..., list[float]]:
    """Return the rates of the rail and of all drives for constant commands."""
    supply, volume, feed, ratio = (machine[name] for name in ("supply", "volume", "feed", "feed_ratio"))
    drives = [drive_rates(drive) for drive in machine["drives"]]

    def rates(y: list[float], commands: list[tuple[float, ...]]) -> list[float]:
        energy, mass = y[0], y[1]
        p0, t0 = (KAPPA - 1.0) * energy / volume, energy / (mass * CV)
        q, h = flow(supply, p0, WARM, t0, feed, ratio)
        result = [h, q]
        for k, drive in enumerate(drives):
            part, q0, h0 = drive(y[2 + STATES * k : 2 + STATES * (k + 1)], p0, t0, commands[k])
            result[0] -= h0
            result[1] -= q0
            result += part
        return result

    return rates


def start_of(machine: dict[str, Any]) -> np.ndarray:
    """Return the initial states: the rail at the supply pressure, pistons at the cap, pressure at the rod."""
    p, v = machine["supply"], machine["volume"]
    y = [p * v / (KAPPA - 1.0), p * v / (GAS * WARM)]
    for drive in machine["drives"]:
        ring = 0.25 * math.pi * (drive["bore"] ** 2 - drive["rod"] ** 2)
        volumes = drive["cap_dead"], drive["rod_dead"] + ring * drive["stroke"]
        for pressure, volume in zip((AMBIENT, p), volumes, strict=True):
            y += [pressure * volume / (KAPPA - 1.0), pressure * volume / (GAS * WARM)]
        y += [0.0, 0.0, -1.0, 0.0]
    return np.array(y)


def readings(machine: dict[str, Any], y: np.ndarray) -> dict[str, float]:
    """Return the outputs that conditions read, by their addresses in the circuit file."""
    values = {"rail.pressure": (KAPPA - 1.0) * y[0] / machine["volume"]}
    for k, drive in enumerate(machine["drives"]):
        u1, _, u2, _, x, v, _, _ = y[2 + STATES * k : 2 + STATES * (k + 1)]
        area = 0.25 * math.pi * drive["bore"] ** 2
        ring = area - 0.25 * math.pi * drive["rod"] ** 2
        name = drive["name"]
        values[f"slide{name}.position"], values[f"slide{name}.velocity"] = x, v
        values[f"cylinder{name}.cap.pressure"] = (KAPPA - 1.0) * u1 / (drive["cap_dead"] + area * x)
        values[f"cylinder{name}.rod.pressure"] = (KAPPA - 1.0) * u2 / (drive["rod_dead"] + ring * (drive["stroke"] - x))
    return values


def holds(condition: Condition, values: dict[str, float], elapsed: float, counts: dict[str, int]) -> bool:
    """Evaluate a condition, a nested tuple."""
    match condition:
        case ("above", address, limit, _):
            return values[address] > limit
        case ("below", address, limit, _):
            return values[address] < limit
        case ("input", name):
            return values[name] > 0.5
        case ("elapsed", limit):
            return elapsed > limit
        case ("count", step, limit):
            return counts[step] >= limit
        case ("not", inner):
            return not holds(inner, values, elapsed, counts)
        case ("and", *inners):
            return all(holds(inner, values, elapsed, counts) for inner in inners)
        case ("or", *inners):
            return any(holds(inner, values, elapsed, counts) for inner in inners)
    raise ValueError(condition)


class Sequencer:
    """The step sequence of a machine: step, samples in the step, cycles and counters."""

    def __init__(self, machine: dict[str, Any]) -> None:
        self.machine, self.sequence = machine, machine["sequence"]
        self.steps: dict[str, Any] = self.sequence["steps"]
        self.first = next(iter(self.steps))
        self.step, self.samples, self.cycles = self.first, -1, 0
        self.counts = {name: int(name == self.first) for name in self.steps}

    @property
    def commands(self) -> list[tuple[float, ...]]:
        """The commands of each valve."""
        on = self.steps[self.step]["on"]
        return [tuple(1.0 if name in on else 0.0 for name in drive["outputs"]) for drive in self.machine["drives"]]

    def sample(self, k: int, y: np.ndarray) -> bool:
        """Act at the sample instant k, and return whether a step begins."""
        time = (k + 1e-6) * self.sequence["sample_time"]
        is_set = {
            name: any(start <= time < end for start, end in spans)
            for name, spans in self.sequence.get("events", {}).items()
        }
        if is_set.get("emergency"):
            self.samples += 1
            return self._enter(self.sequence["emergency"]) if self.step != self.sequence["emergency"] else False
        if is_set.get("halt"):
            return False
        self.samples += 1
        if is_set.get("reset"):
            self._enter(self.first)
            self.cycles, self.counts = 0, {name: int(name == self.first) for name in self.steps}
            return True
        target = self._target(y, self.samples * self.sequence["sample_time"], is_set)
        return self._enter(target) if target is not None else False

    def _enter(self, step: str) -> bool:
        self.step, self.samples = step, 0
        self.counts[step] += 1
        self.cycles += step == self.first
        return True

    def _target(self, y: np.ndarray, elapsed: float, is_set: dict[str, bool]) -> str | None:
        """The first true condition decides, then the timeout."""
        values = readings(self.machine, y) | {name: float(value) for name, value in is_set.items()}
        step = self.steps[self.step]
        for target, condition in step["next"].items():
            if holds(condition, values, elapsed, self.counts):
                return str(target)
        timeout = step.get("timeout")
        return str(timeout[1]) if timeout and elapsed >= timeout[0] else None


def simulate_machine(
    machine: dict[str, Any], duration: float, tolerance: float = 1e-9
) -> tuple[list[tuple[str, float, int]], np.ndarray]:
    """Return step, time in the step and cycles after each sample instant, and the states at these instants."""
    sample_time = machine["sequence"]["sample_time"]
    rates, y, sequencer = machine_rates(machine), start_of(machine), Sequencer(machine)
    sizes = np.array([100.0, 1e-3, *([100.0, 1e-3, 100.0, 1e-3, 0.1, 1.0, 1.0, 1e-5] * len(machine["drives"]))])
    log: list[tuple[str, float, int]] = []
    rows = [y]

    def sample(k: int, y: np.ndarray) -> bool:
        is_changed = sequencer.sample(k, y)
        log.append((sequencer.step, max(sequencer.samples, 0) * sample_time, sequencer.cycles))
        return is_changed

    k, chunk, samples = 0, 16, round(duration / sample_time)
    sample(k, y)
    while k < samples:
        commands = sequencer.commands
        times = sample_time * np.arange(k, min(k + chunk, samples) + 1)
        found = odeint(
            lambda t, y, commands=commands: rates(y.tolist(), commands),
            y, times, rtol=tolerance, atol=tolerance * sizes, tfirst=True, mxstep=100000,
        )  # fmt: skip
        chunk = min(2 * chunk, 128)
        for row in found[1:]:
            k, y = k + 1, row
            rows.append(row)
            if sample(k, row):
                chunk = 16
                break
    return log, np.array(rows)


def draw_machine(seed: int, sample_time: float = 5e-3) -> dict[str, Any]:
    """Return a machine of two to four cylinders with random sizes, frictions, loads and a random sequence."""
    generator = np.random.default_rng(seed)
    drives: list[dict[str, Any]] = []
    for name in "ABCD"[: int(generator.integers(2, 5))]:
        bore = float(generator.choice([0.02, 0.025, 0.032, 0.04]))
        stroke = float(generator.choice([0.025, 0.05, 0.08, 0.1, 0.16]))
        force = 6e5 * 0.25 * math.pi * bore**2
        coulomb = force * generator.uniform(0.02, 0.08)
        volume = 0.25 * math.pi * bore**2 * stroke
        conductance = volume / 0.04 / 1e5 * generator.uniform(0.5, 1.5)
        is_bistable = bool(generator.random() < 0.3)
        drive = {
            "name": name, "bore": bore, "rod": 0.4 * bore, "stroke": stroke,
            "cap_dead": volume * generator.uniform(0.05, 0.2), "rod_dead": volume * generator.uniform(0.05, 0.2),
            "wall": generator.uniform(0.0, 1.0), "mass": force / 200.0 * generator.uniform(0.3, 3.0),
            "load": force * generator.uniform(-0.2, 0.2),
            "friction": str(generator.choice(["viscous", "stribeck", "lugre"])),
            "coulomb": coulomb, "static": coulomb * generator.uniform(1.0, 1.6), "stribeck": 0.01,
            "viscous": force / 6.0 * generator.uniform(0.1, 0.5), "transition": 5e-3,
            "conductance": conductance, "ratio": generator.uniform(0.15, 0.45),
            "exhaust_conductance": conductance * generator.uniform(0.3, 1.2),
            "exhaust_ratio": generator.uniform(0.15, 0.45),
            "on_time": generator.uniform(6e-3, 20e-3), "off_time": generator.uniform(6e-3, 40e-3),
            "outputs": [f"{name}1", f"{name}0"] if is_bistable else [f"{name}1"],
        }  # fmt: skip
        drives.append(drive)
    largest = max(0.25 * math.pi * drive["bore"] ** 2 * drive["stroke"] for drive in drives)
    machine = {
        "supply": generator.uniform(5e5, 8e5), "volume": largest * generator.uniform(2.0, 20.0),
        "feed": max(drive["conductance"] for drive in drives) * generator.uniform(1.0, 4.0),
        "feed_ratio": generator.uniform(0.2, 0.5), "drives": drives,
    }  # fmt: skip
    machine["sequence"] = _draw_sequence(generator, machine, sample_time)
    return machine


def _draw_sequence(generator: np.random.Generator, machine: dict[str, Any], sample_time: float) -> dict[str, Any]:
    """Return a closed sequence of moves with conditions on positions, pressures, times and counts of steps."""
    names = [drive["name"] for drive in machine["drives"]]
    by_name = {drive["name"]: drive for drive in machine["drives"]}
    out: set[str] = set()
    moves: list[list[str]] = []
    for _ in range(int(generator.integers(3, 6))):
        moved = [str(name) for name in generator.choice(names, 2 if generator.random() < 0.25 else 1, replace=False)]
        moves.append(moved)
        out ^= set(moved)
    rest = sorted(out)
    moves += [rest] if rest and generator.random() < 0.3 else [[name] for name in rest]
    steps: dict[str, Any] = {}
    out, labels = set(), []
    for number, moved in enumerate(moves, 1):
        out ^= set(moved)
        label = " ".join(f"{name}{'+' if name in out else '-'}" for name in moved)
        labels.append(label if label not in labels else f"{label} {number}")
        on = []
        for name, drive in by_name.items():
            if len(drive["outputs"]) == 1:
                on += drive["outputs"] if name in out else []
            elif name in moved or generator.random() < 0.3:  # a bistable valve keeps its position without a command
                on.append(drive["outputs"][0 if name in out else 1])
        steps[labels[-1]] = {"on": on, "next": {}}
    out = set()
    for number, moved in enumerate(moves):
        out ^= set(moved)
        step, following = steps[labels[number]], labels[(number + 1) % len(moves)]
        condition = _draw_condition(generator, machine, moved, out, sample_time)
        step["next"][following] = condition
        if generator.random() < 0.15:
            after = sample_time * (int(generator.integers(4, 40)) - 0.5)
            step["timeout"] = (after, following)
        if number > 0 and generator.random() < 0.2:  # the step repeats the one before it until it was counted
            times = int(generator.integers(2, 4))
            step["next"] = {
                following: ("and", ("count", labels[number], times), condition),
                labels[number - 1]: condition,
            }
    sequence = {
        "sample_time": sample_time, "outputs": [output for drive in machine["drives"] for output in drive["outputs"]],
        "steps": steps,
    }  # fmt: skip
    return sequence | _draw_events(generator, steps, sample_time)


def _draw_events(generator: np.random.Generator, steps: dict[str, Any], sample_time: float) -> dict[str, Any]:
    """Add an emergency step to the steps, and return times at which the inputs of the sequence are 1."""

    def spans(low: int, high: int) -> list[tuple[float, float]]:
        first, length = int(generator.integers(100, 300)), int(generator.integers(low, high))
        return [(sample_time * (first + 0.5), sample_time * (first + length + 0.5))]

    events = {"halt": spans(5, 60)} if generator.random() < 0.4 else {}
    if generator.random() < 0.3:
        events["reset"] = spans(1, 2)
    if generator.random() >= 0.3:
        return {"events": events, "inputs": []}
    steps["emergency"] = {"on": [], "next": {next(iter(steps)): ("input", "start")}}
    events["emergency"] = spans(2, 30)
    (_, end), *_ = events["emergency"]
    events["start"] = [(end + 10 * sample_time, end + 20 * sample_time)]
    return {"events": events, "inputs": ["start"], "emergency": "emergency"}


def _draw_condition(
    generator: np.random.Generator, machine: dict[str, Any], moved: list[str], out: set[str], sample_time: float
) -> Condition:
    parts: list[Condition] = []
    for name in moved:
        stroke = next(drive["stroke"] for drive in machine["drives"] if drive["name"] == name)
        address, pressure = f"slide{name}.position", f"cylinder{name}.{'cap' if name in out else 'rod'}.pressure"
        share, chance = generator.uniform(0.8, 0.995), generator.random()
        if name in out:
            limit = round(1e3 * stroke * share, 3)
            end: Condition = ("above", address, limit * 1e-3, f"{limit} mm")
            still: Condition = ("below", address, limit * 1e-3, f"{limit} mm")
        else:
            limit = round(1e3 * stroke * (1.0 - share), 3)
            end = ("below", address, limit * 1e-3, f"{limit} mm")
            still = ("above", address, limit * 1e-3, f"{limit} mm")
        bar = round(machine["supply"] / 1e5 * generator.uniform(0.6, 0.85), 3)
        pressed: Condition = ("above", pressure, bar * 1e5, f"{bar} bar")
        parts.append(end if chance < 0.6 else ("not", still) if chance < 0.75 else ("and", end, pressed))

    def half(low: int, high: int) -> float:
        return sample_time * (int(generator.integers(low, high)) + 0.5)

    chance = generator.random()
    if chance < 0.25:
        parts.append(("elapsed", half(5, 60)))
    elif chance < 0.35:
        bar = round(machine["supply"] / 1e5 * generator.uniform(0.85, 0.95), 3)
        parts.append(("above", "rail.pressure", bar * 1e5, f"{bar} bar"))
    condition: Condition = ("and", *parts) if len(parts) > 1 else parts[0]
    return ("or", condition, ("elapsed", half(100, 160)))


def condition_text(condition: Condition, inside: bool = False) -> str:
    """Write a condition in the grammar of the circuit file."""
    match condition:
        case ("above" | "below" as kind, address, _, limit):
            return f"{address} {'>' if kind == 'above' else '<'} {limit}"
        case ("input", name):
            return str(name)
        case ("elapsed", limit):
            return f"elapsed > {1e3 * limit:.6g} ms"
        case ("count", step, limit):
            return f'count("{step}") >= {limit}'
        case ("not", inner):
            return f"not {condition_text(inner, True)}"
        case (word, *inners):
            text = f" {word} ".join(condition_text(inner, True) for inner in inners)
            return f"({text})" if inside else text
    raise ValueError(condition)


def circuit_text(machine: dict[str, Any], duration: float, tolerance: float = 1e-9) -> str:
    """Write a machine as a circuit file."""
    return "\n".join(_lines(machine, duration, tolerance)) + "\n"


def _lines(machine: dict[str, Any], duration: float, tolerance: float) -> Iterator[str]:
    yield from ("[parts.supply]", 'kind = "reservoir"', f"pressure = {machine['supply']!r}")
    yield from ("[parts.feed]", 'kind = "orifice"', 'from = "supply"', 'to = "rail"')
    yield from (f"sonic_conductance = {machine['feed']!r}", f"critical_ratio = {machine['feed_ratio']!r}")
    yield from ("[parts.rail]", 'kind = "chamber"', f"volume = {machine['volume']!r}")
    yield f"initial_pressure = {machine['supply']!r}"
    connections = []
    for drive in machine["drives"]:
        name, is_bistable = drive["name"], len(drive["outputs"]) == 2
        function = "bistable" if is_bistable else "monostable"
        yield from (f"[parts.valve{name}]", 'kind = "spool_valve"', 'supply = "rail"')
        yield from (f'a = "cylinder{name}.cap"', f'b = "cylinder{name}.rod"')
        yield f'function = "5/2 {function}"'
        yield from (f"switching_time = {drive['on_time']!r}", f"closing_time = {drive['off_time']!r}")
        yield from (f"sonic_conductance = {drive['conductance']!r}", f"critical_ratio = {drive['ratio']!r}")
        yield f"exhaust_a_conductance = {drive['exhaust_conductance']!r}"
        yield f"exhaust_a_ratio = {drive['exhaust_ratio']!r}"
        yield f"supply_b_conductance = {drive['conductance']!r}"
        yield "initial_position = -1"
        inputs = ("command_a", "command_b") if is_bistable else ("command",)
        connections += [f'"valve{name}.{i}" = "plc.{o}"' for i, o in zip(inputs, drive["outputs"], strict=True)]
        yield from (
            f"[parts.cylinder{name}]",
            'kind = "cylinder"',
            f'body = "slide{name}"',
            f"bore = {drive['bore']!r}",
        )
        yield from (f"rod_diameter = {drive['rod']!r}", f"stroke_length = {drive['stroke']!r}")
        yield f"cap = {{dead_volume = {drive['cap_dead']!r}, wall_conductance = {drive['wall']!r}}}"
        yield f"rod = {{dead_volume = {drive['rod_dead']!r}, wall_conductance = {drive['wall']!r}, " + (
            f"initial_pressure = {machine['supply']!r}}}"
        )
        yield from (f"[parts.slide{name}]", 'kind = "mass"', f"mass = {drive['mass']!r}")
        yield f"load_force = {drive['load']!r}"
        law = {"kind": f'"{drive["friction"]}"', "viscous_coefficient": drive["viscous"]}
        if drive["friction"] != "viscous":
            law |= {"coulomb_force": drive["coulomb"], "static_force": drive["static"]}
        if drive["friction"] == "stribeck":
            law |= {"transition_velocity": drive["transition"]}
        yield f"friction = {{{', '.join(f'{key} = {value}' for key, value in law.items())}}}"
    sequence = machine["sequence"]
    first = next(iter(sequence["steps"]))
    yield from ("[parts.plc]", 'kind = "sequence"', f"sample_time = {sequence['sample_time']!r}")
    yield from (f"outputs = {_listed(sequence['outputs'])}", f'start = "{first}"')
    if "emergency" in sequence:
        yield from (f'emergency = "{sequence["emergency"]}"', f"inputs = {_listed(sequence['inputs'])}")
    for name, step in sequence["steps"].items():
        yield f'[parts.plc.steps."{name}"]'
        yield f"on = {_listed(step['on'])}"
        targets = ", ".join(f'"{target}" = {_quoted(condition_text(limit))}' for target, limit in step["next"].items())
        yield f"next = {{ {targets} }}"
        if "timeout" in step:
            yield f'timeout = {{ after = {step["timeout"][0]!r}, to = "{step["timeout"][1]}" }}'
    yield from ("[connections]", *connections)
    for name, spans in sequence.get("events", {}).items():
        times = [0.0, *(time for span in spans for time in span)]
        values = [0, *([1, 0] * len(spans))]
        yield from (f'[signals."plc.{name}"]', 'kind = "steps"', f"times = {times}", f"values = {values}")
    yield from ("[run]", f"duration = {duration!r}", f"output_step = {sequence['sample_time']!r}")
    yield f"relative_tolerance = {tolerance!r}"


def _listed(names: list[str]) -> str:
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def _quoted(text: str) -> str:
    return f"'{text}'" if '"' in text else f'"{text}"'
