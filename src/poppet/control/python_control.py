"""To python-control and back: plants, controllers, and linear models."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.circuit.linear_model import LinearModel
from poppet.control.loop import Gains, SampledPlant
from poppet.core.errors import InputError, needed

_ROUNDING = 1e-6


def _package() -> Any:
    with needed("control", "python-control", "control"):
        import control
    return control


def plant_to_control(plant: SampledPlant) -> Any:
    """A sampled plant, its delay included, as a discrete-time state space."""
    n, d = len(plant.B), plant.delay
    a, b, c = np.zeros((n + d, n + d)), np.zeros((n + d, 1)), np.zeros((1, n + d))
    a[:n, :n], c[0, :n] = plant.A, plant.C
    if d:
        a[:n, n], a[n : n + d - 1, n + 1 :], b[-1, 0] = plant.B, np.eye(d - 1), 1.0
    else:
        b[:, 0] = plant.B
    names = {"inputs": ["command"], "outputs": ["measurement"], "remove_useless_states": False}
    return _package().ss(a, b, c, np.zeros((1, 1)), plant.sample_time, **names)


def gains_to_control(gains: Gains, sample_time: float) -> Any:
    r"""A controller as a discrete-time transfer function from the error to the command."""
    z = _package().tf([1.0, 0.0], [1.0], sample_time)
    result = gains.gain * (z / z)
    if gains.integral_time > 0.0:
        result += gains.gain * sample_time / gains.integral_time / (z - 1.0)
    if gains.derivative_time > 0.0:
        slow = gains.derivative_filter
        result += gains.gain * gains.derivative_time * (z - 1.0) / ((slow + sample_time) * z - slow)
    return _package().minreal(result, verbose=False)


def gains_from_control(system: Any) -> Gains:
    """Numbers of the part `pid` from a controller that was designed with python-control."""
    control = _package()
    time = system.dt
    if not isinstance(time, float) or time <= 0.0:
        raise InputError("control.no_sample_time", dt=time)
    poles, direct, residues = _fractions(control.tf(system))
    # One pole at 1 is the integral, another one the filter of the derivative; a PID has no more.
    held = np.abs(poles - 1.0) < _ROUNDING
    others = np.flatnonzero(~held)
    if np.count_nonzero(held) > 1 or len(others) > 1:
        raise InputError("control.poles", poles=poles.tolist())
    integral = float(residues[held][0].real) if held.any() else 0.0
    push, share = 0.0, 0.0
    if len(others):
        share = float(poles[others[0]].real)
        if not 0.0 <= share < 1.0:
            raise InputError("control.no_filter", pole=share)
        push = float(residues[others[0]].real) / (share - 1.0)
    gain = direct - push
    if gain == 0.0 or integral < 0.0 or push < 0.0:
        raise InputError("control.signs", gain=gain)
    slow = time * share / (1.0 - share)
    return Gains(gain, gain * time / integral if integral > 0.0 else 0.0, push * (slow + time) / gain, slow)


def _fractions(system: Any) -> tuple[Any, float, Any]:
    """Poles, direct part and residues of a transfer function with single poles."""
    numerator, denominator = (np.atleast_1d(np.squeeze(each[0][0])) for each in (system.num, system.den))
    numerator = np.trim_zeros(numerator, "f") if np.any(numerator) else numerator
    if len(numerator) > len(denominator):
        raise InputError("control.looks_ahead")
    direct = float(numerator[0] / denominator[0]) if len(numerator) == len(denominator) else 0.0
    rest = np.polysub(numerator, direct * denominator)
    poles = np.roots(denominator)
    slope = np.polyder(np.poly1d(denominator))
    return poles, direct, np.array([np.polyval(rest, p) / slope(p) for p in poles])


def model_from_control(system: Any) -> LinearModel:
    """A linear model from a continuous state space of python-control."""
    if system.dt:
        raise InputError("control.discrete", dt=system.dt)
    labels = system.state_labels, system.input_labels, system.output_labels
    states, inputs, outputs = (tuple(name.replace("__", ".") for name in names) for names in labels)
    a, b, c, d = (np.asarray(each, dtype=float) for each in (system.A, system.B, system.C, system.D))
    x, u, y = (np.zeros(len(names)) for names in (states, inputs, outputs))
    return LinearModel(a, b, c, d, states, inputs, outputs, x, u, y, np.zeros(len(states)))
