"""Write the recordings of these examples: simulations with realistic sensor errors and a fixed seed."""

from __future__ import annotations

import copy
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import poppet
from poppet.identify.fit.fit_series import apply_lag
from poppet.iso6358 import mass_flow_rate
from poppet.signals import Steps

Array = NDArray[np.float64]

SEED = 20260101
HERE = Path(__file__).parent
CONDUCTANCE, RATIO, WALL, LAG = 1.1e-8, 0.35, 6.0, 0.8
"""True values of the discharge: C [m^3/(s Pa)], b, wall conductance [W/K], lag of the thermocouple [s]."""
VALVE = (2.1e-8, 0.28)
"""True values of the flow bench and of the tank test: C [m^3/(s Pa)] and b."""
REGULATOR = {
    "valve.main_stage.exhaust_seat.sonic_conductance": 7e-9,
    "valve.pilot.fill.sonic_conductance": 1.5e-10,
    "valve.pilot.vent.sonic_conductance": 2.6e-10,
    "valve.pilot.volume": 6.5e-6,
    "valve.electronics.inner.gain": 3e-5,
    "valve.electronics.outer.gain": 1.3,
}
"""True values of the complete valve that differ from the library."""
FRICTION = {"coulomb": 6.0, "static": 9.0, "stribeck": 8e-3, "viscous": 40.0, "seal": 8e-6, "bristles": 3e4}
"""True values of the pulled cylinder, in SI units."""
RESOLUTION, TEMPERATURE_NOISE = 0.002, 0.2
"""Resolution of the pressure [bar], standard deviation of the temperature [K]."""


def recorded(values: Array, noise: float, step: float, generator: np.random.Generator) -> Array:
    """Return noisy sensor values, rounded to the resolution."""
    return np.asarray(np.round((values + noise * generator.standard_normal(values.size)) / step) * step)


def write(folder: Path, name: str, **columns: Array) -> None:
    """Write a table with a heading line and comma-separated columns."""
    np.savetxt(
        folder / name, np.column_stack(list(columns.values())), "%.8g", ",", header=",".join(columns), comments=""
    )


def discharge(folder: Path, name: str, start: str, generator: np.random.Generator) -> None:
    """Write the discharge of the vessel of `bench.toml`."""
    truth = {
        "outlet.sonic_conductance": CONDUCTANCE,
        "outlet.critical_ratio": RATIO,
        "tank.wall_conductance": WALL,
        "tank.initial_pressure": start,
    }
    circuit = poppet.load(HERE / "bench.toml").with_values(truth)
    run = circuit.simulate()
    pressure = (run["tank.pressure"] - circuit.surroundings.pressure) / 1e5
    temperature = apply_lag(run.time, run["tank.temperature"], LAG) - 273.15
    write(
        folder,
        name,
        t=run.time,
        p_tank=recorded(pressure, 0.003, RESOLUTION, generator),
        T_gas=recorded(temperature, TEMPERATURE_NOISE, 0.1, generator),
    )


def flow_bench(folder: Path, generator: np.random.Generator) -> None:
    """Write 13 points of a valve at 6 bar g, from choked flow to a pressure ratio of 0.95."""
    ambient, upstream = 0.987e5, 6.987e5
    downstream = np.linspace(0.16, 0.95, 13) * upstream
    flow = mass_flow_rate(upstream, downstream, 294.15, sonic_conductance=VALVE[0], critical_ratio=VALVE[1])
    scatter = 1.0 + 0.003 * generator.standard_normal(downstream.size)
    write(
        folder,
        "flow_points.csv",
        flow=np.round(flow / 1.185 * 6e4 * scatter, 1),
        p1=recorded((upstream - ambient) / 1e5 + np.zeros(13), 0.003, 0.001, generator),
        p2=recorded((downstream - ambient) / 1e5, 0.003, 0.001, generator),
        T1=recorded(np.full(13, 21.0), 0.2, 0.1, generator),
    )


def charged_and_discharged(folder: Path, generator: np.random.Generator) -> None:
    """Write a test in which a 20 l tank fills through the valve for 8 s and then empties."""
    surroundings = poppet.Ambient(pressure="0.987 bar", temperature="21 degC")
    valve = {"sonic_conductance": VALVE[0], "critical_ratio": VALVE[1]}
    tank: dict[str, Any] = {"volume": "20 l", "wall_conductance": 5.0, "initial_temperature": "21 degC"}
    for name, start, beyond, ports, closes in (
        ("charge", "0 bar g", "7 bar g", ("beyond", "tank"), 8.0),
        ("discharge", "6.5 bar g", "0 bar g", ("tank", "beyond"), 100.0),
    ):
        circuit = poppet.Circuit(
            parts={
                "beyond": poppet.Reservoir(pressure=beyond, temperature="21 degC"),
                "tank": poppet.Chamber(initial_pressure=start, **tank),
                "valve": poppet.Orifice(from_=ports[0], to=ports[1], **valve),
            },
            signals={"valve.opening": Steps([0.0, closes], [1.0, 0.0])},
            ambient=surroundings,
            run=poppet.Run(duration="25 s", output_step="0.1 s"),
        )
        run = circuit.simulate()
        pressure = (run["tank.pressure"] - 0.987e5) / 1e5
        measured = recorded(pressure, 0.003, RESOLUTION, generator)
        write(folder, f"tank_{name}.csv", t=run.time, p_tank=measured)


def strokes(folder: Path, generator: np.random.Generator) -> None:
    """Write tests in which a 10 l tank fills through the valve seat of the paper at eleven strokes."""
    seat = poppet.library.characteristic("varga2012")
    (folder / "strokes").mkdir(exist_ok=True)
    for stroke in np.linspace(0.05e-3, 1e-3, 11):
        truth = {
            "valve.sonic_conductance": float(seat.sonic_conductance_at(stroke)),
            "valve.critical_ratio": float(seat.critical_ratio_at(stroke)),
            "tank.wall_conductance": 4.0,
        }
        run = poppet.load(HERE / "stroke_bench.toml").with_values(truth).simulate()
        measured = recorded(run["tank.pressure"] / 1e5, 0.005, RESOLUTION, generator)
        write(folder, f"strokes/{1e6 * stroke:.0f}.csv", t=run.time, p_tank=measured)


def muscle_map(folder: Path, generator: np.random.Generator) -> None:
    """Write the force of a 10 mm muscle at eight pressures and seven lengths, zero if slack."""
    law = poppet.Muscle(body="rig", data="dmsp_10_250").force_law()
    pressure, contraction = (
        each.ravel() for each in np.meshgrid(np.linspace(1e5, 7e5, 8), np.linspace(0.01, 0.22, 7), indexing="ij")
    )
    force = law.force(pressure, contraction)
    measured = np.where(force > 3.0, recorded(force, 1.0, 0.1, generator), 0.0)
    write(folder, "muscle_map.csv", p=pressure / 1e5, L=np.round(250.0 * (1.0 - contraction), 2), F=measured)


def pulled(folder: Path, pressure: float, generator: np.random.Generator) -> None:
    """Write pull tests of a 25 mm cylinder at five speeds, with reversals within 20 ms."""
    ways = [sign * speed for speed in (2e-3, 5e-3, 12e-3, 30e-3, 80e-3) for sign in (1.0, -1.0)]
    ends = np.cumsum([0.02 / abs(way) for way in ways])
    knots = [0.0, 0.02, *np.ravel([[end, end + 0.02] for end in ends[:-1]]), ends[-1]]
    fine = np.arange(0.0, ends[-1], 1e-3)
    speed = np.interp(fine, knots, [0.0, *np.repeat(ways, 2)])
    position = np.cumsum(speed) * 1e-3
    level = FRICTION["coulomb"] + FRICTION["seal"] * pressure
    level = level + (FRICTION["static"] - FRICTION["coulomb"]) * np.exp(-((speed / FRICTION["stribeck"]) ** 2))
    bent, held = np.zeros(fine.size), 0.0
    for k in range(1, fine.size):  # the LuGre model, exact over a step at one speed
        held_at = np.sign(speed[k]) * level[k]
        held = held_at + (held - held_at) * np.exp(-FRICTION["bristles"] * abs(speed[k]) * 1e-3 / level[k])
        bent[k] = held
    force = bent + FRICTION["viscous"] * speed + 0.25 * np.pi * 0.025**2 * pressure + 1.5
    every = slice(None, None, 20)
    write(
        folder,
        f"friction_{pressure / 1e5:.0f}bar.csv",
        t=1e3 * fine[every],
        x=recorded(1e3 * position[every], 0.01, 0.01, generator),
        p=recorded(np.full(fine[every].size, pressure / 1e5), 0.002, RESOLUTION, generator),
        F=recorded(force[every], 0.05, 0.02, generator),
    )


def regulator(folder: Path, generator: np.random.Generator) -> None:
    """Write four setpoint steps of a complete valve with a 1 l volume, with two pressure gauges."""
    (folder / "valve").mkdir(exist_ok=True)
    run = poppet.load(HERE / "valve" / "bench.toml").with_values(dict(REGULATOR)).simulate()
    shown = {"p_tank": "tank.pressure", "p_pilot": "valve.pilot_pressure"}
    measured = {name: recorded(run[series] / 1e5, 0.003, RESOLUTION, generator) for name, series in shown.items()}
    write(folder, "valve/steps.csv", t=run.time, **measured)


def main(folder: Path) -> None:
    """Write all files."""
    generator = np.random.default_rng(SEED)
    discharge(folder, "discharge.csv", "7 bar g", generator)
    discharge(folder, "again.csv", "5 bar g", generator)
    flow_bench(folder, generator)
    charged_and_discharged(folder, generator)
    strokes(folder, generator)
    # A separate generator keeps the following files unchanged.
    muscle_map(folder, copy.deepcopy(generator))
    own = copy.deepcopy(generator)
    for pressure in (1e5, 3e5, 5e5, 7e5):
        pulled(folder, pressure, own)
    regulator(folder, generator)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
