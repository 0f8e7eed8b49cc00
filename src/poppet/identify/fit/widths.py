"""Searches over differences of several widths, for circuits in which a program samples.

The residuals of such a circuit are smooth in its numbers on the whole and broken in small pieces: which width of
differences sees the slope and not the pieces depends on the circuit, and a search may end in a piece. So it is made
with several, from the start and again from the best place found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Search = Callable[[Array], tuple[Array, float]]

WIDTHS = (0.1, 0.02, 0.002)
"""Relative widths of the differences. Fits of a complete valve came within 1 % of the truth with the first and stayed
10 % away from it with the last; fits of a loop with a steep gain did it the other way round."""


KICKS = 3
"""Most rounds of trying to leave a false minimum, where nothing is said."""


class Searched(Protocol):
    """What is searched: experiments whose width of differences can be changed, and results that are kept."""

    experiments: Sequence[Any]

    def forget(self) -> None:
        """Take no result from before."""


def over_widths(objective: Searched, x: Array, downhill: Search) -> tuple[Array, float]:
    """The best of searches with differences of several widths."""
    best, cost = x, np.inf
    for begins_again in (False, True):
        begin = best if begins_again else x
        for width in WIDTHS:
            with _width(objective, width):
                place, found = downhill(begin)
            if found < cost:
                best, cost = place, found
    return best, cost


def rounds(kicks: int | None, experiments: Sequence[Any]) -> int:
    """Most rounds of trying to leave a false minimum, as given or as the circuits ask for."""
    if kicks is not None:
        return kicks
    return 0 if any(each.samples for each in experiments) else KICKS


@contextmanager
def _width(objective: Searched, width: float) -> Iterator[None]:
    """Differences of another width for a while; results over the one before do not count on either side."""
    before = [each.width for each in objective.experiments]
    try:
        for each in objective.experiments:
            each.width = width
        objective.forget()
        yield
    finally:
        for each, own in zip(objective.experiments, before, strict=True):
            each.width = own
        objective.forget()
