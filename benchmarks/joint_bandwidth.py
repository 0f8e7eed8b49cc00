"""Bandwidth of the muscle joint, and which part limits it: the parts are made ideal one by one, and all of them.

Each variant gets the fastest controller of one family: gain, integral and derivative follow from one number s,
K T_d r/J = 2 s, T_d = 1/s, T_i = 3/s, and s is the highest in steps of a tenth at which a step of 20 degrees overshoots
by less than a tenth, and swings by less than half a degree in the end. Then the angle's answer to sines of the setpoint
of 3 degrees gives the frequencies at which it is 3 dB down and 90 degrees late.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet import Circuit, Orifice, Recording, Reservoir, load
from poppet.signals import Sine, Steps

EXAMPLE = Path(__file__).parents[1] / "examples" / "muscle_joint.toml"
SLOWEST, FASTEST, GROWTH = 15.0, 120.0, 1.1
MIDDLE, SWING = math.radians(30.0), math.radians(3.0)


def remade(circuit: Circuit, *dropped: str, links: Mapping[str, str] | None = None, **parts: Any) -> Circuit:
    """A circuit without some parts and their connections, with others in their place."""
    kept = {name: part for name, part in circuit.parts.items() if name not in dropped}
    joined = {target: at for target, at in circuit.connections.items() if target.partition(".")[0] not in dropped}
    return replace(circuit, parts={**kept, **parts}, connections={**joined, **(links or {})})


def changed(circuit: Circuit, name: str, **fields: Any) -> Circuit:
    """A circuit with other fields of one part."""
    part: Any = circuit.parts[name]
    return remade(circuit, **{name: replace(part, **fields)})


def ideal_valve(circuit: Circuit) -> Circuit:
    """The pressure behind the valve is its setpoint, at once and whatever flows."""
    parts: dict[str, Any] = {"line": Reservoir(pressure="3 bar")}
    if "hose" in circuit.parts:
        hose: Any = circuit.parts["hose"]
        parts["hose"] = replace(hose, from_="line")
    else:
        parts["fitting"] = Orifice(from_="line", to="muscle", sonic_conductance="20 dm^3/(s bar)", critical_ratio=0.3)
    return remade(circuit, "valve", "supply", links={"line.pressure": "inverse.pressure"}, **parts)


def no_tube(circuit: Circuit) -> Circuit:
    """The valve sits at the muscle."""
    valve: Any = circuit.parts["valve"]
    return remade(circuit, "hose", valve=replace(valve, outlet="muscle"))


def ideal_muscle(circuit: Circuit) -> Circuit:
    """Its force is the law's: no hysteresis, no damping; its gas keeps the temperature of the wall."""
    return changed(circuit, "muscle", hysteresis=None, damping=0.0, wall_conductance=50.0)


def light_load(circuit: Circuit) -> Circuit:
    """Half of the inertia, and no friction."""
    return changed(circuit, "arm", inertia=0.5 * float(circuit.numbers()["arm.inertia"]), friction={"kind": "none"})


def all_ideal(circuit: Circuit) -> Circuit:
    """Nothing left but the controller, its law, and the load."""
    return ideal_muscle(ideal_valve(no_tube(circuit)))


VARIANTS: dict[str, Callable[[Circuit], Circuit]] = {
    "as it is": lambda circuit: circuit,
    "ideal valve": ideal_valve,
    "no tube": no_tube,
    "ideal muscle": ideal_muscle,
    "half the inertia": light_load,
    "valve, tube, muscle ideal": all_ideal,
}


def tuned(circuit: Circuit, speed: float) -> Circuit:
    """With the controller of the family at a speed [1/s]."""
    inertia, radius = (float(circuit.numbers()[f"arm.{name}"]) for name in ("inertia", "pulley_radius"))
    gain = 2.0 * speed**2 * inertia / radius
    return changed(circuit, "position", gain=gain, derivative_time=1.0 / speed, integral_time=3.0 / speed)


def is_calm(circuit: Circuit) -> bool:
    """True where a step of 20 degrees is answered without much overshoot, and comes to rest."""
    step = Steps([0.0, 0.3], [math.radians(20.0), math.radians(40.0)])
    run = replace(circuit, signals={"position.setpoint": step}).simulate("1.6 s", "5 ms")
    angle = np.degrees(run["arm.position"])
    return bool(angle.max() < 42.0 and np.ptp(angle[run.time > 1.3]) < 0.5)


def fastest(circuit: Circuit) -> float:
    """The highest calm speed of the family [1/s], whose lower neighbour is calm too."""
    speeds = SLOWEST * GROWTH ** np.arange(round(math.log(FASTEST / SLOWEST) / math.log(GROWTH)))
    calm = [is_calm(tuned(circuit, speed)) for speed in speeds]
    return float(max(speed for k, speed in enumerate(speeds) if calm[k] and calm[k - 1] and k))


def harmonic(run: Recording, name: str, frequency: float) -> complex:
    """Amplitude and phase of a series over the whole periods of the last second and more."""
    span = math.ceil(frequency) / frequency
    k = run.time > run.time[-1] - span + 1e-9
    return complex(np.mean(run[name][k] * np.exp(-2j * math.pi * frequency * run.time[k])))


def answer(circuit: Circuit, frequency: float) -> Recording:
    """A run with a sine of the setpoint, long enough to forget its beginning."""
    span = math.ceil(frequency) / frequency
    duration = 1.0 + span
    wave = Sine(mean=MIDDLE, amplitude=SWING, frequency=frequency)
    moved = replace(circuit, signals={"position.setpoint": wave})
    return moved.simulate(duration, span / round(span / 1e-3))


def response(circuit: Circuit, frequency: float) -> complex:
    """Angle over setpoint."""
    run = answer(circuit, frequency)
    return harmonic(run, "arm.position", frequency) / harmonic(run, "position.setpoint", frequency)


def bandwidth(circuit: Circuit, finest: float = 1.15) -> tuple[float, float]:
    """Frequencies at which the angle is 3 dB down and 90 degrees late [Hz]."""
    frequencies, answers = [0.5], [response(circuit, 0.5)]
    while frequencies[-1] < 60.0:
        frequencies.append(frequencies[-1] * finest)
        answers.append(response(circuit, frequencies[-1]))
        lag = -np.unwrap(np.angle(answers))[-1]
        if abs(answers[-1]) < 0.6 and lag > 0.55 * math.pi:
            break
    levels, lags = -np.abs(answers), -np.unwrap(np.angle(answers))

    def crossing(values: Any, level: float) -> float:
        k = int(np.argmax(np.asarray(values) > level))
        share = (level - values[k - 1]) / (values[k] - values[k - 1])
        return float(np.exp(np.interp(share, [0.0, 1.0], np.log(frequencies[k - 1 : k + 1]))))

    return crossing(levels, -math.sqrt(0.5)), crossing(lags, 0.5 * math.pi)


def lags(circuit: Circuit, frequency: float) -> dict[str, float]:
    """How much later the pressure behind valve and tube is than that before [deg]."""
    run = answer(circuit, frequency)
    chain = {"valve": ("inverse.pressure", "hose.1.pressure"), "tube": ("hose.1.pressure", "muscle.pressure")}
    return {
        part: math.degrees(np.angle(harmonic(run, before, frequency) / harmonic(run, after, frequency)))
        for part, (before, after) in chain.items()
    }


def main(size: float = 1.0) -> None:
    """Print the table; `size` scales the number of variants."""
    circuit = load(EXAMPLE)
    print(f"{'variant':28s} {'s 1/s':>6s} {'-3 dB Hz':>9s} {'-90 deg Hz':>11s}")
    for name, made in list(VARIANTS.items())[: max(1, round(len(VARIANTS) * size))]:
        variant = made(circuit)
        speed = fastest(variant) if size >= 1.0 else 20.0
        drop, late = bandwidth(tuned(variant, speed), 1.15 if size >= 1.0 else 3.0)
        print(f"{name:28s} {speed:6.1f} {drop:9.2f} {late:11.2f}")
    for frequency in (2.0, 4.0)[: max(1, round(2 * size))]:
        found = lags(circuit, frequency)
        print(f"lags at {frequency:g} Hz: " + ", ".join(f"{part} {lag:.1f} deg" for part, lag in found.items()))


if __name__ == "__main__":
    main()
