"""Runs per second of batches: lanes and threads against single runs of the scalar kernel and against SciPy's LSODA.

First the paper's staircase with eight numbers varied by 10 %; of each run the final pressure and the time at which the
tank first has 90 % of its greatest pressure, read off rows every 0.1 s. LSODA is that of `staircase.py`, held to 1e-6
there and here. Then a complete valve sampled at 1 kHz for 2 s, and 32 chambers in a row for 20 s, with the same kind of
result. Times are of the processor in one thread, the least of several turns; those of threads are of the clock on the
wall.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from itertools import cycle

import numpy as np

import poppet
from chain import chain
from peer import NUMBERS, START, peer_rates, peer_run
from poppet import Circuit, loads
from poppet.circuit.options import Run
from poppet.engine.batch import BatchRows, run_batch, usable_cores
from poppet.engine.lane_kernel import WIDTHS, lane_functions, usual_width
from poppet.engine.members import Batch
from poppet.engine.problem import Array
from sampled_control import CIRCUIT as SAMPLED
from staircase import CIRCUIT as STAIRCASE

VARIED = (
    *("tank.volume", "tank.wall_conductance", "valve.plate_area", "valve.moving_mass", "valve.damping"),
    *("valve.upper_spring.rate", "valve.lower_spring.rate", "valve.exhaust_seat.sonic_conductance"),
)
SPREAD, TURNS = 0.1, 5


def final_and_rise(rows: BatchRows) -> Array:
    """Last value of the first output, and the time at which it first has 90 % of its greatest value."""
    values = rows.values[:, 0]
    reached = np.argmax(values >= 0.9 * values.max(axis=1, keepdims=True), axis=1)
    return np.stack([values[:, -1], rows.time[reached]], axis=1)


def batch_of(circuit: Circuit, output: str, varied: tuple[str, ...], runs: int, run: Run | None = None) -> Batch:
    """Runs of a circuit, one output observed."""
    problem, names = circuit.problem(run or circuit.run), circuit.model.parameters
    kernel = problem.kernel.observing([[name for name, _ in circuit.model.outputs].index(output)])
    places = np.array([names.index(name) for name in varied])
    factors = 1.0 + SPREAD * np.random.default_rng(1).uniform(-1.0, 1.0, (runs, places.size))
    return Batch(replace(problem, kernel=kernel), places, problem.p[places] * factors)


def least(contestants: dict[str, Callable[[], int]], turns: int, clock: Callable[[], float]) -> dict[str, float]:
    """Least time of each contestant for one run [s]; a contestant says how many it has made."""
    best = dict.fromkeys(contestants, np.inf)
    for _ in range(turns):
        for name, made in contestants.items():
            begin = clock()
            runs = made()
            best[name] = min(best[name], (clock() - begin) / runs)
    return best


def in_lanes(batch: Batch, lanes: int, threads: int = 1) -> Callable[[], int]:
    """Run a batch, or of the scalar kernel, which needs no long slices, an eighth of it."""
    part = batch if lanes > 1 or threads > 1 else replace(batch, values=batch.values[: max(1, batch.size // 8)])
    return lambda: run_batch(part, reduce=final_and_rise, threads=threads, lanes=lanes).batch.size


def compare(title: str, batch: Batch, turns: int, others: dict[str, Callable[[], int]] | None = None) -> None:
    """Print runs per second and ratios."""
    print(f"\n{title}: {batch.size} runs")
    # A look at whether this runs, with few turns, is spared the narrower ones.
    widths = [width for width in WIDTHS[1:] if width <= usual_width()][0 if turns > 1 else -1 :]
    for width in widths:
        begin = time.process_time()
        lane_functions(batch.problem.kernel, width)
        print(f"{width} lanes compiled, or found, in {time.process_time() - begin:.2f} s")
    scalar = "scalar kernel"
    contestants = {scalar: in_lanes(batch, 1)} | {f"{width} lanes": in_lanes(batch, width) for width in widths}
    best = least(contestants | (others or {}), turns, time.process_time)
    for name, took in best.items():
        ratios = "".join(
            f", {best[other] / took:7.2f} times {other}" for other in (scalar, *(others or {})) if other != name
        )
        print(f"{name:15s} {1.0 / took:9.0f} runs/s of one core{ratios}")
    cores, width = usable_cores(), usual_width()
    on_wall = least({str(n): in_lanes(batch, width, n) for n in (1, cores)}, turns, time.perf_counter)
    print(f"{cores} threads are {on_wall['1'] / on_wall[str(cores)]:.2f} times as fast as one")
    one, many = (run_batch(batch, reduce=final_and_rise, lanes=lanes) for lanes in (1, width))
    assert one.reduced is not None
    assert many.reduced is not None
    apart = np.max(np.abs(many.reduced - one.reduced), axis=0) / np.maximum(np.max(np.abs(one.reduced), axis=0), 1e-300)
    print(
        f"final value and 90 % time differ from those of the scalar kernel by {apart[0]:.1e} and {apart[1]:.1e};",
        end=" ",
    )
    print(f"balances {max(float(part.max()) for part in many.residuals().values()):.1e} of what is allowed")


def lsoda(circuit: Circuit, batch: Batch) -> Callable[[], int]:
    """One run of the staircase by the peer, with the numbers of the next member."""
    members, tolerance = cycle(batch.values), 1e-5
    tight = circuit.simulate(relative_tolerance=1e-12)["tank.pressure"]
    while np.max(np.abs(peer_run(peer_rates(NUMBERS), START, tolerance)[2] / tight - 1.0)) > 1e-6:
        tolerance /= 2.0
    print(f"LSODA needs a relative tolerance of {tolerance:.2g}")

    def made() -> int:
        numbers = {**NUMBERS, **dict(zip(VARIED, next(members).tolist(), strict=True))}
        start = [*START[:3], START[3] * numbers["tank.volume"] / NUMBERS["tank.volume"], START[4]]
        pressure = peer_run(peer_rates(numbers), start, tolerance)[2]
        return int(pressure.size > 0)

    return made


def main(size: float = 1.0) -> None:
    """Print speeds and ratios; `size` scales the number of runs."""
    turns = max(1, round(TURNS * size))
    print(f"poppet {poppet.__version__}; {usual_width()} lanes fill a register of this processor")
    circuit = loads(STAIRCASE)
    staircase = batch_of(circuit, "tank.pressure", VARIED, max(16, round(2048 * size)))
    compare("paper staircase, 120 s", staircase, turns, {"SciPy LSODA": lsoda(circuit, staircase)})
    sampled = batch_of(
        loads(SAMPLED), "tank.pressure", ("tank.volume", "tank.wall_conductance"), max(8, round(128 * size)),
        Run(duration=max(0.02, 2.0 * size), output_step=0.01),
    )  # fmt: skip
    compare("valve sampled at 1 kHz, 2 s", sampled, turns)
    length = max(3, round(32 * size))
    varied = tuple(f"c{k}.volume" for k in range(length))
    chambers = batch_of(
        chain(length), f"c{length - 1}.pressure", varied, max(8, round(512 * size)), Run(duration=20.0, output_step=0.1)
    )
    compare(f"{length} chambers, 20 s", chambers, turns)


if __name__ == "__main__":
    main()
