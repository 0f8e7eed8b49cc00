"""Conversion of plants, controllers and linear models to and from python-control."""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.circuit.linear_model import LinearModel
from poppet.control.loop import Gains, SampledPlant
from poppet.core.errors import InputError, needed

if TYPE_CHECKING:
    import control

_ROUNDING = 1e-6


def _package() -> ModuleType:
    with needed("control", "python-control", "control"):
        import control
    package: ModuleType = control
    return package


def plant_to_control(plant: SampledPlant) -> control.StateSpace:
    """Convert a sampled plant with its delay to a discrete-time state space of python-control."""
    n, d = len(plant.B), plant.delay
    a, b, c = np.zeros((n + d, n + d)), np.zeros((n + d, 1)), np.zeros((1, n + d))
    a[:n, :n], c[0, :n] = plant.A, plant.C
    if d:
        a[:n, n], a[n : n + d - 1, n + 1 :], b[-1, 0] = plant.B, np.eye(d - 1), 1.0
    else:
        b[:, 0] = plant.B
    names = {"inputs": ["command"], "outputs": ["measurement"], "remove_useless_states": False}
    return _package().ss(a, b, c, np.zeros((1, 1)), plant.sample_time, **names)


def gains_to_control(gains: Gains, sample_time: float) -> control.TransferFunction:
    """Convert the gains of a controller to a discrete-time transfer function of python-control.

    The input is the error, and the output is the command.
    """
    z = _package().tf([1.0, 0.0], [1.0], sample_time)
    result = gains.gain * (z / z)
    if gains.integral_time > 0.0:
        result += gains.gain * sample_time / gains.integral_time / (z - 1.0)
    if gains.derivative_time > 0.0:
        filter_time = gains.derivative_filter
        result += gains.gain * gains.derivative_time * (z - 1.0) / ((filter_time + sample_time) * z - filter_time)
    return _package().minreal(result, verbose=False)


def gains_from_control(system: Any) -> Gains:
    """Convert a PID controller of python-control to the gains of the part `pid`.

    `system` is a discrete-time system; other systems are rejected.
    """
    control = _package()
    sample_time = system.dt
    if not isinstance(sample_time, float) or sample_time <= 0.0:
        raise InputError("control.no_sample_time", dt=sample_time)
    # Partial fractions of the transfer function, which must not have multiple poles.
    function = control.tf(system)
    numerator, denominator = (np.atleast_1d(np.squeeze(p[0][0])) for p in (function.num, function.den))
    numerator = np.trim_zeros(numerator, "f") if np.any(numerator) else numerator
    if len(numerator) > len(denominator):
        raise InputError("control.looks_ahead")
    direct = float(numerator[0] / denominator[0]) if len(numerator) == len(denominator) else 0.0
    remainder, slope = np.polysub(numerator, direct * denominator), np.polyder(denominator)
    poles = np.roots(denominator)
    residues = np.polyval(remainder, poles) / np.polyval(slope, poles)
    # A PID has at most a pole at 1, the integral, and a pole of the derivative filter.
    is_integrator = np.abs(poles - 1.0) < _ROUNDING
    filter_poles = np.flatnonzero(~is_integrator)
    if np.count_nonzero(is_integrator) > 1 or len(filter_poles) > 1:
        raise InputError("control.poles", poles=poles.tolist())
    integral = float(residues[is_integrator][0].real) if is_integrator.any() else 0.0
    derivative_gain, filter_pole = 0.0, 0.0
    if len(filter_poles):
        filter_pole = float(poles[filter_poles[0]].real)
        if not 0.0 <= filter_pole < 1.0:
            raise InputError("control.no_filter", pole=filter_pole)
        derivative_gain = float(residues[filter_poles[0]].real) / (filter_pole - 1.0)
    gain = direct - derivative_gain
    if gain == 0.0 or integral < 0.0 or derivative_gain < 0.0:
        raise InputError("control.signs", gain=gain)
    filter_time = sample_time * filter_pole / (1.0 - filter_pole)
    integral_time = gain * sample_time / integral if integral > 0.0 else 0.0
    return Gains(gain, integral_time, derivative_gain * (filter_time + sample_time) / gain, filter_time)


def model_from_control(system: Any) -> LinearModel:
    """Convert a continuous-time state space of python-control to a linear model.

    In names, two underscores become a dot, so that the names become addresses.
    """
    if system.dt:
        raise InputError("control.discrete", dt=system.dt)
    labels = system.state_labels, system.input_labels, system.output_labels
    states, inputs, outputs = (tuple(name.replace("__", ".") for name in names) for names in labels)
    a, b, c, d = (np.asarray(matrix, dtype=float) for matrix in (system.A, system.B, system.C, system.D))
    x, u, y = (np.zeros(len(names)) for names in (states, inputs, outputs))
    return LinearModel(a, b, c, d, states, inputs, outputs, x, u, y, np.zeros(len(states)))
