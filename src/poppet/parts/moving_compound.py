"""Base class of compound parts with a body, such as grippers and rotary actuators."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.provenance import Number
from poppet.parts.bodies import MovingBody
from poppet.parts.compound import Compound


class MovingCompound(Compound):
    """Compound part with one body among its members.

    It publishes the outputs of the body, and reports the notes of the body. Its initial motion can resume a run.
    """

    moving: ClassVar[str]
    """Name of the member that is the body."""

    @property
    def moving_body(self) -> MovingBody:
        """Body of the compound."""
        body: MovingBody = self.members[self.moving]  # type: ignore[assignment]
        return body

    def outside(self) -> dict[str, str]:
        outputs = (f"{self.moving}.{name}" for name in self.moving_body.list_outputs())
        return super().outside() | {name: name for name in outputs}

    def list_internal_outputs(self) -> tuple[str, ...]:
        inner = (f"{self.moving}.{name}" for name in self.moving_body.list_internal_outputs())
        return (*super().list_internal_outputs(), *inner)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        notes = self.moving_body.remarks(f"{name}.{self.moving}", series)
        return tuple(note.within(self.moving) for note in notes)


def values_of(*numbers: Any) -> list[Any] | None:
    """Return the values of several numbers, or None if one of them is missing or invalid.

    The compound reports such a number itself.
    """
    return [number.value for number in numbers] if all(isinstance(number, Number) for number in numbers) else None


def stop_at(position: Any, contact: Any) -> dict[str, Any]:
    """Return the fields of an end stop.

    `position` is its position, and `contact` the group of numbers with its stiffness and dissipation.
    """
    names = ("stiffness", "dissipation") if hasattr(contact, "stiffness") else ()
    return {"position": position} | {name: getattr(contact, name) for name in names}
