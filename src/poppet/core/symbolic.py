"""Elementary functions and conditions for floats, NumPy arrays and CasADi symbols.

Operators work for all three; this module adds conditions and elementary functions. It recognises a symbol without an
import of CasADi. Both sides of a condition are always evaluated: clip the argument of a square root or a power to its
domain first, which also keeps derivatives finite.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np


def is_symbolic(*values: Any) -> bool:
    """Return True if any argument is a CasADi symbol or expression."""
    for value in values:  # noqa: SIM110 - a generator is much slower
        # Floats first: they are by far the most frequent.
        if type(value) is not float and type(value).__module__.startswith("casadi"):
            return True
    return False


def new_symbol(name: str) -> Any:
    """Return a new CasADi symbol."""
    return _casadi().SX.sym(name)


class SymbolicValueError(TypeError):
    """Error raised if a symbol is used in place of a float, for example in a check of its value."""


def is_certain(condition: Any) -> bool:
    """Return True if a condition is true.

    The result for a condition on symbols is False, because its truth value is unknown.
    """
    return not is_symbolic(condition) and bool(condition)


def is_array(*values: Any) -> bool:
    """Return True if any argument is a NumPy array, a list or a tuple."""
    return any(isinstance(value, (np.ndarray, list, tuple)) for value in values)


def _casadi() -> ModuleType:
    import casadi

    return casadi


def where(condition: Any, if_true: Any, if_false: Any) -> Any:
    """Return `if_true` where the condition is true, and `if_false` elsewhere.

    The arguments can be floats, arrays or symbols. Arrays are evaluated for each element.
    """
    if is_symbolic(condition, if_true, if_false):
        ca = _casadi()
        if not is_symbolic(condition):
            return if_true if condition else if_false
        return ca.if_else(condition, if_true, if_false)
    if is_array(condition, if_true, if_false):
        return np.where(condition, if_true, if_false)
    return if_true if condition else if_false


def minimum(a: Any, b: Any) -> Any:
    """Return the smaller of two values, for each element of arrays.

    The arguments can be floats, arrays or symbols. If two symbols are equal, the derivative is the derivative of one of
    them.
    """
    if is_symbolic(a, b):
        return _casadi().fmin(a, b)
    if is_array(a, b):
        return np.minimum(a, b)
    return a if a <= b else b


def maximum(a: Any, b: Any) -> Any:
    """Return the larger of two values, for each element of arrays.

    The arguments can be floats, arrays or symbols.
    """
    if is_symbolic(a, b):
        return _casadi().fmax(a, b)
    if is_array(a, b):
        return np.maximum(a, b)
    return a if a >= b else b


def clip(value: Any, low: Any, high: Any) -> Any:
    """Limit a value to the range from `low` to `high`.

    If `low` exceeds `high`, the result is `low`.
    """
    return maximum(minimum(value, high), low)


# `math` for floats: the functions of NumPy take ten times longer for one value.
def _elementary(name: str, float_function: Callable[[Any], float]) -> Callable[[Any], Any]:
    def apply(value: Any) -> Any:
        if is_symbolic(value):
            return getattr(_casadi(), name)(value)
        if is_array(value):
            return getattr(np, name)(value)
        return float_function(value)

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
fabs = _elementary("fabs", math.fabs)


def smoothstep(value: Any, low: Any, high: Any) -> Any:
    """Return a smooth transition from 0 at `low` to 1 at `high`.

    Between them, the result is 3 s^2 - 2 s^3 with s = (value - low)/(high - low). Below `low` it is 0, above `high` it
    is 1.
    """
    s = clip((value - low) / (high - low), 0.0, 1.0)
    return s * s * (3.0 - 2.0 * s)
