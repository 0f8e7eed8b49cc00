"""Base class of objects that a notebook shows as HTML."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar


class HtmlMixin:
    """Object with an HTML representation in notebooks."""

    __slots__ = ()

    renderer: ClassVar[Callable[[Any], str | None] | None] = None
    """Function that returns the HTML of an object, or None for its text; set by the package above `report`."""

    def _repr_html_(self) -> str | None:
        """Return HTML for IPython, or None: IPython then shows `repr`."""
        renderer = type(self).renderer
        return None if renderer is None else renderer(self)
