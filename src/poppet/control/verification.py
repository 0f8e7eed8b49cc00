"""Verification of a tuned loop by a setpoint step and its reverse."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.loop import Array, Gains
from poppet.control.metrics import step_metrics
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

_LENGTHS, _MOST = 20.0, 20_000
"""Duration of a step in integral times or time constants of the crossover; maximum in samples."""
_ROWS = 2000
_SWINGS, _GROWS, _OVERSHOOTS = 0.05, 1.1, 25.0
"""Limits of the final oscillation, as a fraction of the step, of its growth, and of the overshoot [%]."""


@dataclass(frozen=True)
class Verification:
    """Simulated response of a tuned loop to a setpoint step and the reverse step.

    Parameters
    ----------
    at : str
        Label of the run, such as `100 mm, sines of 0.05`: the operating point, and the sines or the size of the step.
    step : float
        Size of the step, SI.
    overshoot : float
        Maximum of both steps [%].
    settling_time : float
        Time until the measurement remains within 2 % of the step, maximum of both steps [s]. It is infinite if the
        measurement does not settle.
    swing : float
        Amplitude of the oscillation in the last quarter of a step, as a fraction of the step.
    growth : float
        Ratio of the amplitudes of the oscillation in the last and in the third quarter of a step.
    time, setpoint, measured : (n,) array
        Times [s], setpoint and measurement [SI]; the first row is immediately before the first step.
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
        """Return a note if the response oscillates, overshoots too much or does not settle.

        Parameters
        ----------
        address : str
            Address of the controller.

        Returns
        -------
        tuple of Note
            One note, or none.
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


def verify_step(
    circuit: BaseCircuit, controller: str, steady_run: Recording | None, value: float, step: float, gains: Gains,
    crossover: float, label: str,
) -> Verification:  # fmt: skip
    """Simulate a tuned loop with a setpoint step and the reverse step.

    The run continues `steady_run`, a run to the steady state at the setpoint `value`. If `steady_run` is None, the run
    starts at the initial state of the circuit. `step` is the size of the step, and `label` describes the run. The
    crossover frequency `crossover` [Hz] determines the duration.
    """
    part = circuit.parts[controller]
    sample_time = part.parameters(circuit.surroundings)["sample_time"]
    output = f"{controller}.sensor_{part.controls}"  # type: ignore[attr-defined]
    length = _LENGTHS * max(gains.integral_time, 1.0 / (2.0 * np.pi * max(crossover, 1e-9)))
    hold = min(length, _MOST * sample_time)
    signals = {a: s for a, s in circuit.signals.items() if a.partition(".")[0] != controller}
    signals[f"{controller}.setpoint"] = Steps([0.0, 0.5 * hold, 1.5 * hold], [value, value + step, value])
    try:
        driven = replace(circuit, signals=signals, run=replace(circuit.run, stop_when=None))
        run = driven.simulate(2.5 * hold, hold / _ROWS, start=steady_run)
    except SimulationError as error:
        raise SimulationError(Note("tuning.broke_off", controller, at=label, why=error.note)) from error
    rows = slice(_ROWS // 2 - 1, None)  # from the row before the first step
    time, setpoint, measured = run.time[rows], run[f"{controller}.setpoint"][rows], run[output][rows]
    metrics = step_metrics(time, setpoint, measured, run[f"{controller}.command"][rows])

    def swing(quarter: int) -> float:
        """Return the amplitude of the oscillation in one quarter of a step.

        It is half the range of the response after subtraction of a straight line. The result is the larger value of
        both steps.
        """
        starts = (begin + quarter * _ROWS // 4 for begin in (0, _ROWS))
        quarters = [measured[k : k + _ROWS // 4] for k in starts]
        return max(0.5 * float(np.ptp(values - np.linspace(values[0], values[-1], values.size))) for values in quarters)

    last, overshoot, settling_time = swing(3), metrics["overshoot"], metrics["settling_time"]
    size, growth = last / abs(step), last / max(swing(2), 1e-300)
    return Verification(label, step, overshoot, settling_time, size, growth, time, setpoint, measured)
