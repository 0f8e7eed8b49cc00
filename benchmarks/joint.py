"""Speed on every example with a load, controllers and all, against SciPy's LSODA side by side.

LSODA gets right-hand sides of the same equations in plain floats (`joint_peer.py`, `spool_peer.py`, and
`drives_peer.py` where nothing is sampled). What counts as exact is a tight run of ours. Ours runs at its default
tolerance, and once more, as LSODA does, at the loosest with which it is as near to that as the default is, or within
what is wanted. Two runs of a valve with a dead band swing alike but not in step: for that, not for the integration,
joints are apart by 0.6e-3 to 4.4e-3 rad at tolerances from 1e-3 to 1e-8, and 3e-3 are wanted. The converters of the
valves are left out.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from drives_peer import CUSHIONED, LIFT, METER_OUT, VERTICAL
from joint_peer import joint_run, pair_run
from poppet import load
from spool_peer import spool_run

EXAMPLES = Path(__file__).parents[1] / "examples"
STEP = 1e-3
LOOSEST, DEFAULT, TIGHTEST = 1e-3, 1e-6, 1e-8
Peer = Callable[[dict[str, float], float, Mapping[str, Sequence[float]]], np.ndarray]


class Case(NamedTuple):
    """An example, its peer, the series compared, how near is near enough, samples between rows and in all."""

    example: str
    run: Peer
    series: str
    wanted: float
    rows: int
    valves: tuple[str, ...] = ()
    samples: int = 2000


CASES = (
    Case("muscle_joint", joint_run, "arm.position", 3e-3, 5, ("valve",)),
    Case("antagonistic_joint", pair_run, "joint.position", 3e-3, 5, ("flexor_valve", "extensor_valve")),
    Case("cylinder_position", spool_run, "slide.position", 1e-6, 2),
    Case("cylinder_meter_out", METER_OUT, "slide.position", 1e-6, 2, samples=4000),
    Case("vertical_load", VERTICAL, "load.position", 1e-6, 10, samples=60000),
    Case("muscle_lift", LIFT, "weight.position", 1e-6, 5, samples=5000),
    Case("cylinder_cushioned", CUSHIONED, "slide.position", 1e-6, 1, samples=2000),
)


def timed(run: Callable[[], object], rounds: int) -> list[float]:
    """Processor times, so that other work on the machine does not count."""
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        run()
        times.append(time.process_time() - begin)
    return times


def against(case: Case, samples: int, rounds: int) -> str:
    """A line of the table."""
    circuit = load(EXAMPLES / f"{case.example}.toml")
    circuit = circuit.with_values({f"{valve}.electronics.converter.bits": 0 for valve in case.valves})
    number, span, output = circuit.parameters, STEP * samples, STEP * case.rows
    times = [STEP * k + 1e-9 for k in range(samples)]
    driven = {name: signal.evaluate(times).tolist() for name, signal in circuit.signals.items()}
    held = {each: [number[each]] * samples for each in ("joint.load_torque",) if each in number and each not in driven}

    def ours(tolerance: float | None = None) -> np.ndarray:
        return circuit.simulate(span, output, relative_tolerance=tolerance)[case.series]

    def theirs(tolerance: float) -> np.ndarray:
        return case.run(number, tolerance, driven | held)

    tight, default = ours(1e-9), ours()

    def loosest(run: Callable[[float], np.ndarray], tightest: float) -> float:
        tolerance, enough = LOOSEST, max(case.wanted, float(np.max(np.abs(default - tight))))
        while np.max(np.abs(run(tolerance) - tight)) > enough and tolerance > tightest:
            tolerance /= 10.0**0.5
        return max(tolerance, tightest)

    peers, own = loosest(theirs, TIGHTEST), loosest(ours, DEFAULT)
    slow = min(timed(lambda: theirs(peers), rounds))
    times = [min(timed(lambda at=at: ours(at), 5 * rounds)) for at in (None, own)]  # type: ignore[misc]
    columns = "".join(f" {1e3 * each:8.1f} {span / each:9.0f} {slow / each:6.0f}" for each in times)
    return f"{case.example:20s} {span:5.2f} {1e3 * slow:8.0f} {peers:6.0e}{columns} {own:6.0e}"


def main(size: float = 1.0) -> None:
    """Print times, ratios and errors; `size` scales the span, the examples and the number of rounds."""
    print(f"{'':41s} {'ours, default':>25s} {'ours, loosest':>25s}")
    ours = f" {'ms':>8s} {'real time':>9s} {'ratio':>6s}"
    print(f"{'fastest runs':20s} {'s':>5s} {'LSODA ms':>8s} {'rtol':>6s}{ours}{ours} {'rtol':>6s}")
    for case in CASES[: max(1, round(len(CASES) * size))]:
        print(against(case, 10 * max(1, round(case.samples * size / 10)), max(1, round(3 * size))))


if __name__ == "__main__":
    main()
