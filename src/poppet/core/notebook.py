"""Base class of objects that a notebook displays as HTML."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar


class HtmlMixin:
    """Base class of objects with an HTML representation in notebooks."""

    __slots__ = ()

    renderer: ClassVar[Callable[[Any], str | None] | None] = None
    """Function that returns the HTML of an object, or None for its text; set by the package above `report`."""

    def _repr_html_(self) -> str | None:
        """Return the object as HTML for IPython.

        The result is None if there is no HTML. IPython then shows the text from `repr`.
        """
        renderer = type(self).renderer
        return None if renderer is None else renderer(self)
