"""Things that show themselves in a notebook. Who draws them stands floors above, and is named by the front door."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

_drawn: Callable[[Any], str | None] | None = None


def drawn_by(draw: Callable[[Any], str | None]) -> None:
    """Name who makes HTML of a `HtmlMixin` thing; None of it means that its text will do."""
    global _drawn
    _drawn = draw


class HtmlMixin:
    """Something that a notebook shows as HTML."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        """For IPython, which takes `repr` where this is None."""
        return None if _drawn is None else _drawn(self)
