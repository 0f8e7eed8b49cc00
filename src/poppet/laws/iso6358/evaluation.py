"""From a formula to a function of floats, arrays or symbols: check, broadcast, evaluate block by block."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from poppet.core.symbolic import is_symbolic
from poppet.laws.iso6358.domain import DOMAINS, Domain, check

_BLOCK = 8192
"""Elements evaluated at a time: a block's dozen temporaries of 64 KiB stay in a core's second-level cache."""


def evaluate(
    law: Callable[..., tuple[Any, ...]], given: dict[str, Any], domains: dict[str, Domain] = DOMAINS
) -> tuple[Any, ...]:
    """Check what can be checked, then evaluate at once (floats, symbols) or in blocks (arrays)."""
    number = {name: plain(value) for name, value in given.items()}
    check(number, domains)
    arrays = {name: value for name, value in number.items() if isinstance(value, np.ndarray)}
    return _in_blocks(law, number, arrays) if arrays else law(**number)


def plain(value: Any) -> Any:
    """Sequences as float arrays, zero-dimensional arrays and integers as floats, symbols untouched."""
    if type(value) is float or value is None or is_symbolic(value):
        return value
    array = np.asarray(value, dtype=float)
    return array if array.ndim else float(array)


def _in_blocks(law: Callable[..., tuple[Any, ...]], number: dict[str, Any], arrays: dict[str, Any]) -> tuple[Any, ...]:
    """Evaluate element-wise in blocks that stay in cache; each result has the broadcast shape."""
    shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    flat = {name: np.broadcast_to(array, shape).reshape(-1) for name, array in arrays.items()}
    size = math.prod(shape)
    results: tuple[Any, ...] = ()
    # One block for no elements as well: only the law knows how many results there are.
    for start in range(0, max(size, 1), _BLOCK):
        part = slice(start, start + _BLOCK)
        values = law(**(number | {name: array[part] for name, array in flat.items()}))
        results = results or tuple(np.empty(size) for _ in values)
        for result, value in zip(results, values, strict=True):
            result[part] = value
    return tuple(result.reshape(shape) for result in results)
