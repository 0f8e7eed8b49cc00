"""The few functions with which a law is written once for floats, NumPy arrays and CasADi symbols.

Plain operators work on all three already; this module adds choices and elementary functions. A symbol is recognised
without importing CasADi. Conditions are evaluated on both sides everywhere, so keep the argument of a square root or a
power in its domain (clip first): that is what makes derivatives finite too.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def is_symbolic(*values: Any) -> bool:
    """True when any value is a CasADi symbol."""
    return any(type(value).__module__.startswith("casadi") for value in values)


def is_array(*values: Any) -> bool:
    """True when any value is a NumPy array (or a sequence NumPy would take as one)."""
    return any(isinstance(value, (np.ndarray, list, tuple)) for value in values)


def _casadi() -> Any:
    import casadi

    return casadi


def where(condition: Any, if_true: Any, if_false: Any) -> Any:
    """`if_true` where the condition holds, else `if_false`."""
    if is_symbolic(condition, if_true, if_false):
        ca = _casadi()
        if not is_symbolic(condition):
            return if_true if condition else if_false
        return ca.if_else(condition, if_true, if_false)
    if is_array(condition, if_true, if_false):
        return np.where(condition, if_true, if_false)
    return if_true if condition else if_false


def minimum(a: Any, b: Any) -> Any:
    """The smaller of two, elementwise; on a tie of a symbol the derivative is that of one side."""
    if is_symbolic(a, b):
        return _casadi().fmin(a, b)
    if is_array(a, b):
        return np.minimum(a, b)
    return a if a <= b else b


def maximum(a: Any, b: Any) -> Any:
    """The larger of two, elementwise."""
    if is_symbolic(a, b):
        return _casadi().fmax(a, b)
    if is_array(a, b):
        return np.maximum(a, b)
    return a if a >= b else b


def clip(value: Any, low: Any, high: Any) -> Any:
    """`value` held between `low` and `high`; `low` wins where the two cross."""
    return maximum(minimum(value, high), low)


# Plain floats go to `math`: NumPy's functions of one number take ten times as long.
def _elementary(name: str, plain: Any) -> Any:
    def apply(value: Any) -> Any:
        if is_symbolic(value):
            return getattr(_casadi(), name)(value)
        if is_array(value):
            return getattr(np, name)(value)
        return plain(value)

    apply.__name__ = apply.__qualname__ = name
    apply.__doc__ = f"{name} of a float, array or symbol."
    return apply


sqrt = _elementary("sqrt", math.sqrt)
exp = _elementary("exp", math.exp)
log = _elementary("log", math.log)
sin = _elementary("sin", math.sin)
cos = _elementary("cos", math.cos)
tanh = _elementary("tanh", math.tanh)
floor = _elementary("floor", math.floor)


def smoothstep(value: Any, low: Any, high: Any) -> Any:
    """Zero below `low`, one above `high`, the C1 cubic 3 s^2 - 2 s^3 between."""
    s = clip((value - low) / (high - low), 0.0, 1.0)
    return s * s * (3.0 - 2.0 * s)
