r"""Virtual valve with known characteristic values, for tests of the bench.

.. math:: T \dot y + y = f(\mathrm{play}(w(t - T_d))) \qquad
    \text{or} \qquad \ddot y + 2 D \omega \dot y + \omega^2 y = \omega^2 f(\ldots), \quad \omega = 1/T
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from poppet.bench.iso10094.evaluation import Trial
from poppet.bench.iso10094.scale import FloatArray, Record, Scale

_MOST = 3_000_000
_FINE = 1500.0  # steps per time constant


_SCALE = Scale(1e5, 7e5, "Pa", 1e5, 7e5)


@dataclass(frozen=True)
class VirtualValve:
    """Virtual valve with known characteristic values, for tests of the bench.

    The valve is of first or second order, with backlash, threshold, dead zone and dead time. Its fields are the true
    characteristic values, with which the results of the bench can be compared.
    """

    scale: Scale = _SCALE
    supply: float = 9e5  # absolute [Pa]
    time_constant: float = 0.05  # T, with the reference volume [s]
    damping: float = 1.0  # D; a value of 1 or more gives a first-order valve
    dead_time: float = 0.0  # T_d [s]
    play: float = 0.0  # width of the backlash, equal to the hysteresis [% FS]
    threshold: float = 0.0  # smallest change after the backlash that the valve follows [% FS]
    dead_zone: float = 0.0  # setpoint below which the outlet is zero [% FS]
    bow: float = 0.0  # parabolic deviation from the straight line in the middle of the range [% FS]
    scatter: float = 0.0  # offset of every second cycle, which begins at setpoint zero [% FS]
    offset: float = 0.0  # outlet at setpoint zero [% FS]
    droop: float = 0.0  # fall of the outlet at the full flow out of it [% FS]
    rise: float = 0.0  # rise of the outlet at the full flow into it [% FS]
    flow_play: float = 0.0  # width of the backlash of the flow, relative to the full flow
    full_flow: float = 0.01  # mass flow rate at a load of one [kg/s]
    supply_sensitivity: float = 0.0  # change of the outlet per change of the supply pressure
    leak: float = 0.0  # mass flow rate from the supply [kg/s]
    hum: float = 0.0  # amplitude of a limit cycle [% FS]
    hum_frequency: float = 20.0  # frequency of the limit cycle [Hz]
    reference_volume: float = 1e-3  # volume for `time_constant`; T is proportional to the volume [m^3]
    title: str = "stand-in"

    def respond(self, trial: Trial) -> Record:
        """Simulate a trial, and return the recorded channels."""
        constant = self.time_constant * trial.volume / self.reference_volume
        rows = round(trial.duration / trial.step)
        # Jumps become ramps over one step; signals without jumps need no small step.
        fine = _FINE if trial.kind in ("step", "resolution") else 20.0
        finer = max(1, min(math.ceil(fine * trial.step / constant), _MOST // rows))
        time: FloatArray = np.arange(rows * finer + 1, dtype=np.float64) * (trial.step / finer)
        setpoint = trial.setpoint.evaluate(np.maximum(time - self.dead_time, 0.0))
        target = self.static(self.scale.setpoint_percent(setpoint))
        load = np.zeros_like(time) if trial.load is None else trial.load.evaluate(time)
        supply = np.full_like(time, self.supply) if trial.supply is None else trial.supply.evaluate(time)
        sign, slope = (1.0, self.droop) if float(np.max(load)) > 0.0 else (-1.0, self.rise)
        effect = -sign * slope * apply_backlash(sign * load, self.flow_play)  # of the flow on the outlet [% FS]
        target += effect + 100.0 * self.supply_sensitivity * (supply - self.supply) / self.scale.span
        y = _linear_response(target, trial.step / finer, constant, self.damping)
        y += self.offset + self.hum * np.sin(2.0 * math.pi * self.hum_frequency * time)
        rows_shown = np.arange(rows + 1) * finer
        rows_shown = rows_shown[time[rows_shown] >= trial.lead - 1e-9 * trial.step]
        clock = time[rows_shown]
        return Record(
            trial.name, trial.kind, clock - clock[0], trial.setpoint.evaluate(clock),
            self.scale.pressure(y[rows_shown]), supply[rows_shown], self.full_flow * load[rows_shown],
            np.full(clock.size, self.leak), trial.volume, is_exact=True,
        )  # fmt: skip

    def static(self, setpoint: FloatArray) -> FloatArray:
        """Return the steady-state outlet pressure [% FS] for setpoints [% FS]."""
        input_ = apply_backlash(setpoint, self.play)
        if self.threshold > 0.0:
            # The position stays constant until the input differs from it by the threshold, then jumps to the input.
            changes = np.flatnonzero(np.diff(input_, prepend=np.nan))
            levels = input_[changes]
            position = float(levels[0])
            for k, value in enumerate(levels.tolist()):
                if abs(value - position) >= self.threshold * (1.0 - 1e-9):
                    position = value
                levels[k] = position
            input_ = np.repeat(levels, np.diff(changes, append=input_.size))
        effective = np.maximum(input_ - self.dead_zone, 0.0) * 100.0 / (100.0 - self.dead_zone)
        part = effective / 100.0
        result = effective + 4.0 * self.bow * part * (1.0 - part)
        if self.scatter:
            at_zero = setpoint <= 0.1
            cycle = np.cumsum(np.diff(at_zero.astype(int), prepend=1) > 0)
            result += np.where((cycle % 2 == 1) & (effective > 0.0), self.scatter, 0.0)
        return np.asarray(result)


def apply_backlash(values: FloatArray, width: float) -> FloatArray:
    """Return the output of a backlash element for an input series.

    `width` is the width of the backlash. The output stays within half of `width` of the input.

    Examples
    --------
    >>> apply_backlash(np.array([0.0, 5.0, 5.0, 4.5, 0.0]), 2.0).tolist()
    [0.0, 4.0, 4.0, 4.0, 1.0]
    """
    half = 0.5 * width
    result = np.empty_like(values)
    last, begin = float(values[0]), 0
    # Between two turning points, the backlash is pushed in one direction only.
    turns = np.flatnonzero(np.diff(np.sign(np.diff(values)))) + 2
    for end in (*turns.tolist(), values.size):
        part = values[begin:end]
        result[begin:end] = np.maximum(last, part - half) if part[-1] - half > last else np.minimum(last, part + half)
        last, begin = float(result[end - 1]), end
    return result


def _linear_response(target: FloatArray, step: float, constant: float, damping: float) -> FloatArray:
    """Return the exact response of the linear dynamics to a piecewise linear input.

    `target` is the input, `step` the time between its points [s], and `constant` the time constant [s]. The response
    starts in steady state. A damping of 1 or more gives a first-order response.
    """
    from scipy.signal import lfilter

    if damping >= 1.0:
        poles = [complex(-1.0 / constant)]
        residues = [complex(1.0 / constant)]
    else:
        pole = complex(-damping, math.sqrt(1.0 - damping**2)) / constant
        poles, residues = [pole], [2.0 / constant**2 / (pole - pole.conjugate())]
    result = np.zeros_like(target)
    rise = target - target[0]
    for pole, residue in zip(poles, residues, strict=True):
        z = pole * step
        grown = complex(np.expm1(z))
        later = (grown - z) / (pole * z)
        now = grown / pole - later
        part = lfilter([later, now], [1.0, -np.exp(z)], rise.astype(complex))
        result += (residue * part).real
    return np.asarray(result + target[0])
