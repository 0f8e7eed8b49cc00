"""What the presets of the valve's electronics do: steps up and down, large and small, into 0.1 to 200 litres.

Its rows are in docs/valve_presets.md. Supply 7 bar; the walls take 45 W/K at 0.2 m3, less in proportion to the surface.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from poppet import Chamber, Circuit, Recording, Reservoir
from poppet.parts import ProportionalValve
from poppet.signals import Steps

PRESETS = ("fast", "universal", "precise")
VOLUMES = {1e-4: 2.0, 3e-4: 2.0, 1e-3: 2.5, 3e-3: 4.0, 1e-2: 10.0, 3e-2: 30.0, 0.2: 180.0}
"""Volume [m3] and the time of its large steps [s]; small ones take a quarter of it."""
STEPS = ((2e5, 4e5), (4e5, 2e5), (3e5, 3.3e5), (3.3e5, 3e5))
BEGIN, ROW, SPAN, SHORTEST, LARGE = 0.5, 1e-3, 6e5, 1.5, 1e5


@dataclass(frozen=True)
class Step:
    """Figures of one step."""

    rise: float  # from the change of the setpoint to 90 % of the step [s]
    overshoot: float  # beyond the setpoint, in parts of the step
    settling: float  # until the error stays within 1 % of the span [s]
    left: float  # greatest error later than a second after that [Pa]


def circuit_of(preset: str, volume: float, low: float, high: float) -> Circuit:
    """A closed tank at rest whose setpoint steps."""
    pilot = {"initial_pressure": low + 1.13e4}
    ports = {"supply": "supply", "outlet": "tank", "exhaust": "ambient"}
    wall = 45.0 * (volume / 0.2) ** (2.0 / 3.0)
    parts = {
        "supply": Reservoir(pressure=7e5),
        "valve": ProportionalValve(**ports, data="vppm_6l", preset=preset, pilot=pilot),
        "tank": Chamber(volume=volume, wall_conductance=wall, initial_pressure=low),
    }
    return Circuit(parts, {"valve.setpoint": Steps([0.0, BEGIN], [low, high])})


def figures(run: Recording, low: float, high: float) -> Step:
    """The figures of a run of it."""
    since, pressure = run.time - BEGIN, run["tank.pressure"]
    share, error = (pressure - low) / (high - low), np.abs(pressure - high)
    outside = since[error > 0.01 * SPAN]
    settling = float(outside[-1]) if outside.size else 0.0
    late = since >= settling + 1.0
    return Step(
        float(since[np.argmax(share >= 0.9)]) if np.any(share >= 0.9) else math.inf,
        max(0.0, float(np.max(share[since > 0.0])) - 1.0),
        settling,
        float(np.max(error[late])) if np.any(late) else math.inf,
    )


def step(preset: str, volume: float, low: float, high: float) -> Step:
    """One step."""
    large = abs(high - low) > LARGE
    length = VOLUMES[volume] if large else max(SHORTEST, VOLUMES[volume] / 4.0)
    run = circuit_of(preset, volume, low, high).simulate(BEGIN + length, max(ROW, length / 20_000))
    return figures(run, low, high)


def row(volume: float, low: float, high: float, found: list[Step]) -> str:
    """A line of the table; each cell holds the figures of all presets."""
    cells = (
        f"{low / 1e5:g} to {high / 1e5:g}",
        f"{1e3 * volume:g}",
        " / ".join(f"{each.rise:.3g}" for each in found),
        " / ".join(f"{100.0 * each.overshoot:.1f}" for each in found),
        " / ".join(f"{each.settling:.3g}" for each in found),
        " / ".join(f"{each.left / 100.0:.0f}" for each in found),
    )
    return f"| {' | '.join(cells)} |"


def rows(volumes: list[float]) -> Iterator[str]:
    """The table of some volumes."""
    for low, high in STEPS:
        for volume in volumes:
            yield row(volume, low, high, [step(preset, volume, low, high) for preset in PRESETS])


def main(size: float = 1.0) -> None:
    print(f"Each cell: {' / '.join(PRESETS)}\n")
    print("| step [bar] | volume [l] | 90 % after [s] | overshoot [%] | within 1 % FS after [s] | remaining [mbar] |")
    print("|---|---|---|---|---|---|")
    for line in rows(list(VOLUMES)[: max(1, round(len(VOLUMES) * size))]):
        print(line, flush=True)


if __name__ == "__main__":
    main()
