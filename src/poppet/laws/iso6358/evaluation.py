"""Evaluation of formulas for floats, arrays and symbols, with checks and broadcasting."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from poppet.core.symbolic import is_symbolic
from poppet.laws.iso6358.domain import DOMAINS, Domain, check

_BLOCK = 8192
"""Elements per block: a dozen temporaries of 64 KiB fit into the second-level cache of a core."""


def evaluate(
    law: Callable[..., tuple[Any, ...]], arguments: dict[str, Any], domains: dict[str, Domain] = DOMAINS
) -> tuple[Any, ...]:
    """Check the arguments of a formula, and return its results.

    The function `law` takes the arguments by name and returns a tuple. `domains` contains the valid intervals of the
    arguments. Arrays are broadcast to a common shape, and evaluated in blocks that fit into the cache of the processor.
    """
    values = {name: plain(value) for name, value in arguments.items()}
    check(values, domains)
    arrays = {name: value for name, value in values.items() if isinstance(value, np.ndarray)}
    if not arrays:
        return law(**values)
    shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    flat = {name: np.broadcast_to(array, shape).reshape(-1) for name, array in arrays.items()}
    size = math.prod(shape)
    results: tuple[Any, ...] = ()
    # Empty arrays need one block too, because the law determines the number of results.
    for start in range(0, max(size, 1), _BLOCK):
        part = slice(start, start + _BLOCK)
        block = law(**(values | {name: array[part] for name, array in flat.items()}))
        results = results or tuple(np.empty(size) for _ in block)
        for result, row in zip(results, block, strict=True):
            result[part] = row
    return tuple(result.reshape(shape) for result in results)


def plain(value: Any) -> Any:
    """Convert a value to a float or an array of floats.

    Sequences become arrays. Integers and zero-dimensional arrays become floats. Symbols and None are unchanged.
    """
    if type(value) is float or value is None or is_symbolic(value):
        return value
    array = np.asarray(value, dtype=float)
    return array if array.ndim else float(array)
