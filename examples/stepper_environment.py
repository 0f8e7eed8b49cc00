"""An environment for reinforcement learning with the interface of Gymnasium: the pressure of a tank between two valves.

Gymnasium itself is not needed. To register the class there, derive it from `gymnasium.Env` and declare the spaces
`Box(0.0, 1.0, (2,))` for actions and `Box(0.0, 12e5, (2,))` for observations.

Run: python examples/stepper_environment.py
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet import Chamber, Circuit, Orifice, Reservoir

Array = NDArray[np.float64]
PERIOD, LENGTH = 0.01, 200
"""Time between two actions [s], and number of actions of an episode."""
SIZE: dict[str, Any] = {"sonic_conductance": "0.5 dm^3/(s bar)", "critical_ratio": 0.35}


def tank() -> Circuit:
    """Return a tank of one litre that two proportional valves fill and vent, with a leak."""
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", **SIZE),
            "vent": Orifice(from_="tank", to="ambient", **SIZE),
            "tank": Chamber(volume="1 l", wall_conductance="1.5 W/K", initial_pressure="2 bar"),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=0.0, critical_ratio=0.3),
        }
    )


class TankPressure:
    """Episodes in which the pressure shall reach a random setpoint, with a random leak and a random supply pressure.

    An action contains the openings of both valves, from 0 to 1. An observation contains pressure and setpoint [Pa]. The
    reward is the negative deviation from the setpoint [bar].
    """

    def __init__(self) -> None:
        self.stepper = tank().stepper(["leak.sonic_conductance", "supply.pressure"], outputs=["tank.pressure"])
        self.openings = [self.stepper.inputs.index(f"{valve}.opening") for valve in ("fill", "vent")]
        self.generator = np.random.default_rng()

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Begin an episode; return the first observation."""
        if seed is not None:
            self.generator = np.random.default_rng(seed)
        self.x, self.u, self.count = self.stepper.start(), self.stepper.default_inputs(), 0
        self.free = np.array([self.generator.uniform(0.0, 4e-10), self.generator.uniform(6.5e5, 7.5e5)])
        self.setpoint = self.generator.uniform(2e5, 6e5)
        self.u[self.openings] = 0.0
        return self._observation(), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Apply an action for one period; return observation, reward, and whether the episode has ended."""
        self.u[self.openings] = np.clip(action, 0.0, 1.0)
        self.x = self.stepper.step(self.x, PERIOD, u=self.u, free=self.free)
        self.count += 1
        observation = self._observation()
        reward = -abs(observation[0] - observation[1]) / 1e5
        return observation, reward, False, self.count >= LENGTH, {}

    def _observation(self) -> Array:
        return np.append(self.stepper.outputs_at(self.x, u=self.u, free=self.free), self.setpoint)


def play(gain: float, seed: int) -> float:
    """Return the mean reward of an episode with a proportional controller; `gain` is the opening per bar."""
    environment, rewards, ends = TankPressure(), [], False
    observation, _ = environment.reset(seed=seed)
    while not ends:
        opening = gain * (observation[1] - observation[0]) / 1e5
        observation, reward, _, ends, _ = environment.step(np.array([opening, -opening]))
        rewards.append(reward)
    return float(np.mean(rewards))


if __name__ == "__main__":
    for gain in (0.1, 0.5, 2.0):
        print(f"gain {gain:.1f} per bar: mean reward {np.mean([play(gain, seed) for seed in range(5)]):.3f} bar")
