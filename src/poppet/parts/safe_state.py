"""Safe state of sampled controllers: reaction to inputs that are not valid.

A program that calls a controller marks an invalid input, for example a broken sensor, with the input `input_fault` and
keeps the last valid value of the input. After `fault_time` the controller gives its `safe_command`. The first sample
with valid inputs ends this state.
"""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import where
from poppet.parts.part import DiscreteState, Input, Scope

FAULT_INPUT = Input("input_fault", "1", 0.0, low=0.0, high=1.0, is_flag=True)
FAULT_MEMORY = (DiscreteState("faulty_samples", "1"), DiscreteState("is_safe", "1"), DiscreteState("is_saturated", "1"))
"""Discrete states: samples since the first invalid input, safe state, and saturation of the command."""
NEVER_VALID = -1.0
"""Start value of `faulty_samples`: before the first valid sample, a fault causes the safe state immediately."""
_ROUNDING = 1e-6
"""Tolerance of `fault_time`, relative; it permits single precision."""


def fault_state(scope: Scope, period: Any) -> tuple[Any, dict[str, Any]]:
    """Return the safe state of a controller at a sample instant, and its new discrete states.

    Parameters
    ----------
    scope : Scope
        Symbols of the controller; `fault_time` [s] is one of its parameters.
    period : float or symbol
        Sample time [s].

    Returns
    -------
    is_safe : float or symbol
        1 if the command must be the safe command, otherwise 0.
    memory : dict
        New values of `faulty_samples` and `is_safe`.
    """
    is_faulty = scope.inputs["input_fault"] > 0.5
    count = scope.memory["faulty_samples"]
    was_valid = count > -0.5
    has_lasted = where(was_valid, count * period, scope["fault_time"]) >= scope["fault_time"] * (1.0 - _ROUNDING)
    is_safe = where(is_faulty, where(has_lasted, 1.0, 0.0), 0.0)
    scope.label("is_faulty", is_faulty, "true if an input is not valid")
    scope.label("is_now_safe", is_safe, "true if an input has not been valid for the fault time")
    return is_safe, {"faulty_samples": where(is_faulty, where(was_valid, count + 1.0, count), 0.0), "is_safe": is_safe}


def recovers(scope: Scope, is_safe: Any) -> Any:
    """Return 1 in the first sample after a safe state, and 0 in all other samples."""
    return where(is_safe > 0.5, 0.0, scope.memory["is_safe"])


def is_first_after_fault(scope: Scope) -> Any:
    """Return 1 in the first sample with valid inputs after a fault of any duration, otherwise 0.

    In this sample, the change of a measurement since the previous sample is not valid. The first sample of a run counts
    as well.
    """
    count = scope.memory["faulty_samples"]
    had_fault = where(count * count > 0.25, 1.0, 0.0)
    return where(scope.inputs["input_fault"] > 0.5, 0.0, had_fault)
