"""Evaluation of CasADi functions with NumPy arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class ArrayFunction:
    """CasADi function that accepts and returns NumPy arrays.

    It has its own memory for dense arguments and results, so it is not thread-safe. A call with CasADi matrices would
    take ten times longer than the calculation itself.
    """

    def __init__(self, function: Any) -> None:
        self._arguments = [np.zeros(function.numel_in(k)) for k in range(function.n_in())]
        self._results = [np.zeros(function.numel_out(k)) for k in range(function.n_out())]
        self._shapes = [function.size_out(k) for k in range(function.n_out())]
        # The buffer contains only addresses; the arrays above keep the memory.
        self._buffer, self._evaluate = function.buffer()
        for arrays, set_address in ((self._arguments, self._buffer.set_arg), (self._results, self._buffer.set_res)):
            for k, array in enumerate(arrays):
                if array.size:
                    set_address(k, array.data)

    def __call__(self, *arguments: float | Array) -> list[Array]:
        """Evaluate the function for vectors or numbers, and return its results as arrays."""
        for array, value in zip(self._arguments, arguments, strict=True):
            array[:] = value
        self._evaluate()
        # In column order, as in CasADi; copied, because the next call overwrites them.
        return [
            array.reshape(shape, order="F").copy() for array, shape in zip(self._results, self._shapes, strict=True)
        ]
