"""Base class of compound parts with a body, such as grippers and rotary actuators."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from poppet.core.codes import Note
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
