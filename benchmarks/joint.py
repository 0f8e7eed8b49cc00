"""Speed on the muscle joint, its valve, tube and both controllers, against SciPy's LSODA; and all moving examples.

LSODA gets a right-hand side of the same equations in plain floats (`joint_peer.py`) and the loosest tolerance with
which its angle is as near to a tight run of ours as ours is at its default tolerance. The valve has a dead band, within
which two runs swing alike but not in step: that, not the integration, is what they are apart by. The converter of the
valve is left out.
"""

from __future__ import annotations

import math
import statistics
import time
from pathlib import Path

import numpy as np

from joint_peer import peer_run
from poppet import load

EXAMPLES = Path(__file__).parents[1] / "examples"
MOVING = (
    "muscle_joint",
    "antagonistic_joint",
    "cylinder_position",
    "cylinder_meter_out",
    "vertical_load",
    "muscle_lift",
)
BEGINS = 1.0
"""Time of the step [s]."""


def wanted(t: float) -> float:
    """The setpoint of the example's first two seconds [rad]."""
    return math.radians(10.0 if t < BEGINS - 1e-9 else 40.0)


def main(size: float = 1.0) -> None:
    """Print times, errors and ratios; `size` scales the span and the number of rounds."""
    circuit = load(EXAMPLES / "muscle_joint.toml").with_values({"valve.electronics.converter.bits": 0})
    number, samples = circuit.parameters, 5 * max(2, round(400 * size))
    span = 1e-3 * samples
    tight = circuit.simulate(span, relative_tolerance=1e-9)["arm.position"]

    def apart(angle: np.ndarray) -> float:
        return float(np.degrees(np.max(np.abs(angle - tight))))

    ours, tolerance = apart(circuit.simulate(span)["arm.position"]), 1e-3
    while apart(peer_run(number, tolerance, samples, wanted)) > max(ours, 0.05) and tolerance > 1e-9:
        tolerance /= 10.0
    times: dict[str, list[float]] = {"SciPy LSODA": [], "circuit.simulate()": []}
    for _ in range(max(1, round(3 * size))):
        begin = time.process_time()
        peer_run(number, tolerance, samples, wanted)
        times["SciPy LSODA"].append(time.process_time() - begin)
        for _ in range(5):
            begin = time.process_time()
            circuit.simulate(span)
            times["circuit.simulate()"].append(time.process_time() - begin)
    print(f"{f'{span:g} s of a muscle joint':24s} {'median ms':>10s} {'fastest ms':>11s} {'times real time':>16s}")
    for name, each in times.items():
        print(f"{name:24s} {1e3 * statistics.median(each):10.1f} {1e3 * min(each):11.1f} {span / min(each):16.1f}")
    ratio = min(times["SciPy LSODA"]) / min(times["circuit.simulate()"])
    print(f"ratio of the fastest {ratio:.0f}; ours {ours:.2g} deg from a tight run, LSODA at rtol {tolerance:.0e}")
    for example in MOVING[: max(1, round(len(MOVING) * size))]:
        circuit = load(EXAMPLES / f"{example}.toml")
        circuit.simulate()
        runs = []
        for _ in range(max(1, round(5 * size))):
            begin = time.process_time()
            circuit.simulate()
            runs.append(time.process_time() - begin)
        span = float(circuit.run.duration)  # type: ignore[arg-type]
        print(f"{example:24s} {1e3 * statistics.median(runs):10.1f} {1e3 * min(runs):11.1f} {span / min(runs):16.0f}")


if __name__ == "__main__":
    main()
