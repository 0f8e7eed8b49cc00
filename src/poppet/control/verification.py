"""A tuned loop on the plant as it is: a step of its setpoint there and back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.loop import Array, Gains
from poppet.control.metrics import step_metrics
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.timeseries.recording import Recording

_LENGTHS, _MOST = 20.0, 20_000
"""Length of a step in integral times or times of the crossover, and in samples at most."""
_ROWS = 2000
_SWINGS, _GROWS, _OVERSHOOTS = 0.05, 1.1, 25.0
"""Parts of a step: what still swings in the end, by which it has grown; overshoot that is too much [%]."""


@dataclass(frozen=True)
class Verification:
    """What a tuned loop does in a step of its setpoint there and back.

    Parameters
    ----------
    at : str
        Operating point and size, `100 mm, sines of 0.05`.
    step : float
        Size of the step, for which the proportional part asks for the command's sine, SI.
    overshoot : float
        The greater of both ways [%].
    settling_time : float
        Until it stays within 2 % of the step, the longer [s]; inf for never.
    swing : float
        What it still moves to each side in the last quarter of a step, in parts of it.
    growth : float
        That over the same of the quarter before.
    time, setpoint, measured : (n,) array
        The run from just before the first step [s], SI.
    """

    at: str
    step: float
    overshoot: float
    settling_time: float
    swing: float
    growth: float
    time: Array = field(repr=False, compare=False)
    setpoint: Array = field(repr=False, compare=False)
    measured: Array = field(repr=False, compare=False)

    def notes(self, address: str) -> tuple[Note, ...]:
        """What is wrong with the gains on the plant as it is; nothing where they hold.

        Parameters
        ----------
        address : str
            Of the controller.

        Returns
        -------
        tuple of Note
        """
        facts: dict[str, Any] = {"at": self.at, "swing": 100.0 * self.swing, "overshoot": self.overshoot}
        code = ""
        if self.swing > _SWINGS:
            code = "grows" if self.growth > _GROWS else "swings"
        elif self.overshoot > _OVERSHOOTS:
            code = "overshoots"
        elif not np.isfinite(self.settling_time):
            code = "unsettled"
        return (Note(f"tuning.{code}", address, **facts),) if code else ()


def verified(
    circuit: Circuit, controller: str, rest: Recording, value: float, size: float, gains: Gains, crossover: float,
    at: str,
) -> Verification:  # fmt: skip
    """Run a tuned loop from a rest through a step of its setpoint and back."""
    part = circuit.parts[controller]
    sample = part.parameters(circuit.surroundings)["sample_time"]
    shown = f"{controller}.sensor_{part.controls}"  # type: ignore[attr-defined]
    length = _LENGTHS * max(gains.integral_time, 1.0 / (2.0 * np.pi * max(crossover, 1e-9)))
    hold = min(length, _MOST * sample)
    step = size / abs(gains.gain)
    signals = {a: s for a, s in circuit.signals.items() if a.partition(".")[0] != controller}
    signals[f"{controller}.setpoint"] = Steps([0.0, 0.5 * hold, 1.5 * hold], [value, value + step, value])
    try:
        run = replace(circuit, signals=signals, run=replace(circuit.run, stop_when=None)).simulate(
            2.5 * hold, hold / _ROWS, start=rest
        )
    except SimulationError as error:
        raise SimulationError(Note("tuning.broke_off", controller, at=at, why=error.note)) from error
    own = slice(_ROWS // 2 - 1, None)  # from one row before the first step
    time, setpoint, measured = run.time[own], run[f"{controller}.setpoint"][own], run[shown][own]
    found = step_metrics(time, setpoint, measured, run[f"{controller}.command"][own])
    swings = [[_swing(measured[k : k + _ROWS // 4]) for k in _quarters(begin)] for begin in (0, _ROWS)]
    last = max(late for _, late in swings)
    before = max(early for early, _ in swings)
    return Verification(
        at, step, found["overshoot"], found["settling_time"], last / abs(step), last / max(before, 1e-300), time,
        setpoint, measured,
    )  # fmt: skip


def _quarters(begin: int) -> Sequence[int]:
    """Where the last two quarters of a step begin."""
    return begin + _ROWS // 2, begin + 3 * _ROWS // 4


def _swing(values: Array) -> float:
    """Half of what moves beside a drift."""
    line = np.linspace(values[0], values[-1], values.size)
    return 0.5 * float(np.ptp(values - line))
