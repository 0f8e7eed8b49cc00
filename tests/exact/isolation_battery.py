"""Isolation of faults on an independent cylinder: one cycle for each draw, and the probabilities of all faults.

`python -m exact.watch_tables FOLDER isolation` in the folder `tests` computes the draws of the documentation, and
`python -m exact.isolation_battery FOLDER/isolation.jsonl figure.svg` prints their scores and draws the reliability
diagram.
"""

from __future__ import annotations

import itertools
import json
import math
import sys
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from exact.independent_watch_cylinder import CHANNELS, CIRCUIT, FAULTS, HEALTHY, Cylinder, cycles, simulate, varied
from poppet import loads
from poppet.monitoring.evidence import Hypothesis, HypothesisComparison, WindowEvidence
from poppet.monitoring.fault_statistics import chi_square_limit, fault_probabilities, probable_set
from poppet.monitoring.hypotheses import HypothesisSearch
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.verdicts import RISE
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Arrival, Window

Array = np.ndarray

NOISE = {"cap": 500.0, "rod": 500.0, "position": 1e-4, "rail": 500.0, "flow": 1e-5}
OFFSET = {"cap": 1e3, "rod": 1e3, "position": 1e-4, "rail": 1e3, "flow": 0.0}
NUISANCES = {"supply.pressure": {"relative_sigma": 0.005}, "slide.load_force": {"sigma": "2 N"}}
NAMES = tuple(name for name in FAULTS if name not in ("load", "supply_low"))
"""Faults whose parameters are no nuisances."""
SENSORS = ("cap", "rod", "position"), ("cap", "rod"), ("position",)
SIZES = 0.0, 0.3, 1.0, 3.0
EDGES = np.array([0.0, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0])
"""Limits of the classes of stated probabilities."""
START = 0.01
"""Standard deviation of the states at the start, relative to their typical sizes."""


def plan_of_cylinder(
    sensors: Sequence[str], names: Sequence[str] = NAMES, *, alarm: float = 1.0, **tables: Any
) -> WatchPlan:
    """Plan with some sensors and faults; `alarm` is the alarm size in the units of the faults."""
    measured: dict[str, Any] = {
        CHANNELS[s]: {"noise": NOISE[s], **({"offset": OFFSET[s]} if OFFSET[s] else {})} for s in sensors
    }
    faults = {
        name: {
            "address": FAULTS[name].address,
            "alarm": alarm * abs(FAULTS[name].unit),
            "direction": "up" if FAULTS[name].unit > 0.0 else "down",
        }
        for name in names
    }
    nuisances = tables.pop("nuisances", NUISANCES)
    return read_plan(loads(CIRCUIT), {**measured, "valve.command": {}}, faults, nuisances, tables)


def readings_of(channels: Mapping[str, Array], sensors: Sequence[str], seed: int) -> Array:
    """Readings with noise and a constant offset, (n, c)."""
    generator = np.random.default_rng([35, seed])
    columns = [
        channels[s] + NOISE[s] * generator.normal(size=channels[s].size) + OFFSET[s] * generator.normal()
        for s in sensors
    ]
    return np.array(columns).T


def plant_of(changes: Mapping[str, float]) -> Cylinder:
    """Cylinder with faults of some units."""
    plant = HEALTHY
    for name, size in changes.items():
        plant = FAULTS[name].plant(size, plant)
    return plant


@dataclass(frozen=True)
class Draw:
    """Result for one cycle of a cylinder with a fault."""

    sensors: tuple[str, ...]
    fault: str  # empty for a healthy cylinder
    size: float
    z: tuple[float, ...]
    sizes: tuple[float, ...]
    rests: tuple[float, ...]
    probabilities: tuple[float, ...]
    misfit: float
    evaluations: int
    pair: tuple[str, ...] = ()

    @property
    def is_alarm(self) -> bool:
        """True if the evidence for a fault suffices for an alarm."""
        return max(self.z) > RISE

    @property
    def named(self) -> tuple[str, ...]:
        """Faults of the 95 % set, the most probable first."""
        return tuple(NAMES[k] for k in probable_set(np.array(self.probabilities)))


class CycleJudge:
    """Comparison of all hypotheses on one cycle, with the start at rest known to 1 %."""

    def __init__(self, sensors: Sequence[str]) -> None:
        self.sensors, self.plan = tuple(sensors), plan_of_cylinder(sensors)
        self.window = Window(self.plan)
        x, _ = self.plan.instance.start()
        states = self.plan.instance.model.states
        sigmas = [START * state.nominal for state in states]
        mean = np.append(x[: len(states)], self.plan.reference)
        self.arrival = Arrival(-1e-9, mean, np.diag(np.append(sigmas, self.plan.prior) ** 2))

    def judge(self, fault: str, size: float, seed: int, other: Mapping[str, float] | None = None) -> Draw:
        """Simulate a cycle with a fault, and compare all hypotheses."""
        plant = plant_of({**({fault: size} if fault else {}), **(other or {})})
        course = simulate(plant, cycles(1), courses=varied(1, seed, plant))
        samples = Samples(course.time, readings_of(course.channels, self.sensors, seed), course.command[:, None])
        search = HypothesisSearch(self.window, samples, self.arrival)

        def refit(
            since: float, hypotheses: Sequence[Hypothesis], steps: Array, *, is_quick: bool = False
        ) -> WindowEvidence:
            return WindowEvidence(search.fit(hypotheses), search.n_readings)

        alarms = np.array([item.alarm for item in self.plan.faults])
        directions = np.array([item.direction for item in self.plan.faults])
        comparison = HypothesisComparison(alarms, directions, refit, temper=1.0, healthy_nis=1.0)
        evidence = comparison.evidence(0.0, np.zeros(len(NAMES)), is_noisy=True)
        assert evidence is not None
        misfit = evidence.squares / evidence.n_readings
        evidence = evidence.tempered()
        pair: tuple[str, ...] = ()
        if min(evidence.rests) > chi_square_limit(len(NAMES) - 1):
            best = min(evidence.pairs().items(), key=lambda item: item[1].rest)
            if best[1].rest <= chi_square_limit(len(NAMES) - 2):
                pair = tuple(NAMES[k] for k in best[0])
        probabilities = fault_probabilities(evidence.z, evidence.joint, evidence.rests)
        arrays = (evidence.z, evidence.sizes, evidence.rests, probabilities)
        return Draw(self.sensors, fault, size, *(tuple(a.tolist()) for a in arrays), misfit, search.evaluations, pair)


@cache
def judge_of(sensors: tuple[str, ...]) -> CycleJudge:
    """Return the comparison for some sensors."""
    return CycleJudge(sensors)


def draws(
    judge: CycleJudge, sizes: Sequence[float], seeds: Iterable[int], names: Sequence[str] = NAMES
) -> Iterator[Draw]:
    """Yield the results of all faults with some sizes; a size of 0 is a healthy cylinder."""
    for seed, size in itertools.product(seeds, sizes):
        for name in names if size else ("",):
            yield judge.judge(name, size, zlib.crc32(f"{name} {size} {seed}".encode()))


@dataclass(frozen=True)
class Score:
    """Hit rates of several draws with a fault."""

    count: int
    named: float  # fraction whose most probable fault is the true one
    contained: float  # fraction whose 95 % set contains the true one
    set_size: float
    stated: float  # mean of the largest probability

    @classmethod
    def of(cls, results: Sequence[Draw]) -> Score:
        """Score of draws with a fault."""
        return cls(
            len(results),
            float(np.mean([draw.named[:1] == (draw.fault,) for draw in results])),
            float(np.mean([draw.fault in draw.named for draw in results])),
            float(np.mean([len(draw.named) for draw in results])),
            float(np.mean([max(draw.probabilities) for draw in results])),
        )


def reliability(results: Sequence[Draw], edges: Array) -> list[tuple[float, float, int]]:
    """Return the mean stated probability, the hit rate and the number of statements of each class."""
    stated = np.concatenate([draw.probabilities for draw in results])
    hits = np.concatenate([np.array(NAMES) == draw.fault for draw in results])
    classes = np.digitize(stated, edges)
    members = [classes == k for k in range(1, edges.size)]
    return [(float(np.mean(stated[m])), float(np.mean(hits[m])), int(np.count_nonzero(m))) for m in members if m.any()]


def read_draws(path: Path) -> list[Draw]:
    """Read stored rows of draws."""
    rows = [row for line in path.read_text(encoding="utf-8").splitlines() for row in json.loads(line)["draws"]]
    return [Draw(**{key: tuple(v) if isinstance(v, list) else v for key, v in row.items()}) for row in rows]


def draw_reliability(results: Sequence[Draw], path: Path) -> None:
    """Draw stated probabilities and hit rates, with 95 % intervals of the hit rates."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 4.8), layout="constrained")
    axes = figure.add_subplot()
    axes.plot([0.0, 1.0], [0.0, 1.0], color="0.5", linewidth=1.0, label="stated = hit rate")
    axes.fill_between([0.05, 1.0], [0.0, 0.95], color="0.5", alpha=0.15, linewidth=0.0, label="overstated by 0.05")
    for stated, hits, count in reliability(results, EDGES):
        # Wilson interval.
        centre, z = hits + 1.92 / count, 1.96
        half = z * math.sqrt(hits * (1.0 - hits) / count + 0.96 / count**2)
        low, high = ((centre + sign * half) / (1.0 + 3.84 / count) for sign in (-1.0, 1.0))
        axes.plot([stated, stated], [low, high], color="tab:blue")
        axes.plot(stated, hits, "o", color="tab:blue")
        axes.annotate(f" {count}", (stated, hits), va="top", fontsize=9)
    axes.set(xlabel="stated probability", ylabel="hit rate", xlim=(-0.02, 1.04), ylim=(-0.02, 1.04))
    axes.legend(frameon=False)
    figure.savefig(path, metadata={"Date": None})


def score_row(results: Sequence[Draw], sensors: tuple[str, ...], size: float) -> str:
    """Return the scores of some sensors and a size as a row of the table in the documentation."""
    chosen = [draw for draw in results if draw.sensors == sensors and draw.size == size]
    if not size:
        return f"| {', '.join(sensors)} | healthy | {len(chosen)} | {sum(draw.is_alarm for draw in chosen)} alarms |"
    score, alarms = Score.of(chosen), [draw for draw in chosen if draw.is_alarm]
    right = np.mean([draw.named[:1] == (draw.fault,) for draw in alarms]) if alarms else math.nan
    numbers = score.named, score.contained, score.set_size, len(alarms) / len(chosen), right
    return f"| {', '.join(sensors)} | {size:g} | {len(chosen)} | " + " | ".join(f"{n:.2f}" for n in numbers) + " |"


def main(path: Path, figure: Path) -> None:
    """Print the scores of stored draws, and draw their reliability diagram."""
    results = read_draws(path)
    for sensors in SENSORS:
        for size in SIZES:
            print(score_row(results, sensors, size))
    for stated, hits, count in reliability(results, EDGES):
        print(f"stated {stated:.3f}, hit rate {hits:.3f}, {count} statements")
    draw_reliability(results, figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
