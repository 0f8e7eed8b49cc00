"""CasADi functions called on NumPy arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Evaluation:
    """A CasADi function of dense arguments and results, each a matrix, in memory of its own.

    A call through CasADi's matrices takes ten times as long as the arithmetic in it. Not for several threads at once.
    """

    def __init__(self, function: Any) -> None:
        self._given = [np.zeros(function.numel_in(k)) for k in range(function.n_in())]
        self._found = [np.zeros(function.numel_out(k)) for k in range(function.n_out())]
        self._shapes = [function.size_out(k) for k in range(function.n_out())]
        # The buffer knows addresses only: the arrays above live as long as it does.
        self._buffer, self._evaluate = function.buffer()
        for place, memory, set_one in (
            *((k, each, self._buffer.set_arg) for k, each in enumerate(self._given)),
            *((k, each, self._buffer.set_res) for k, each in enumerate(self._found)),
        ):
            if memory.size:
                set_one(place, memory.data)

    def __call__(self, *given: float | Array) -> list[Array]:
        """Results for vectors or numbers."""
        for memory, value in zip(self._given, given, strict=True):
            memory[:] = value
        self._evaluate()
        # Column by column, as CasADi keeps them; copied, for the next call writes over them.
        return [found.reshape(shape, order="F").copy() for found, shape in zip(self._found, self._shapes, strict=True)]
