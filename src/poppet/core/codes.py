"""Notes: messages as a code with an address and facts.

`message_format.py` converts them to text.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from poppet.core import message_format


class Note:
    """Message to the user that is not an error, such as a finding.

    Parameters
    ----------
    code : str
        Dotted name of the message, `run.stalled`; its template is in `core/messages/run.toml`.
    address : str, optional
        Address of the subject: a dotted path, or the name of a test or channel.
    **facts
        Values that the text shows: numbers, texts, other notes, or lists of these.

    Examples
    --------
    >>> str(Note("said", text="Recorded on a cold morning."))
    'Recorded on a cold morning.'
    """

    __slots__ = ("address", "code", "facts")

    def __init__(self, code: str, address: str = "", /, **facts: Any) -> None:
        self.code, self.address, self.facts = code, address, facts

    def __str__(self) -> str:
        return message_format.sentence(self.code, {**self.facts, "address": self.address})

    def __repr__(self) -> str:
        facts = "".join(f", {key}={value!r}" for key, value in self.facts.items())
        return f"Note({self.code!r}, {self.address!r}{facts})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Note) and self.plain() == other.plain()

    def __hash__(self) -> int:
        return hash((self.code, self.address))

    def plain(self) -> dict[str, Any]:
        """Return the note as a dictionary that TOML and JSON files can contain.

        The keys are `code`, `address` and the names of the facts.
        """
        return {"code": self.code, "address": self.address, **plain(self.facts)}

    def within(self, owner: str) -> Note:
        """Return a copy of the note with a prefix before its address.

        `owner` is this prefix, for example the name of the part to which the address belongs.
        """
        # The address of a note on a table is a file, not a channel of a recording.
        joint = ": " if self.code.startswith("table.") else "."
        return Note(self.code, joint.join(filter(None, (owner, self.address))), **self.facts)


def plain(value: Any) -> Any:
    """Convert a value to types that TOML and JSON files can contain.

    Arrays, tuples and sets become lists, and notes become dictionaries. An object of any other type becomes text.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(member) for key, member in value.items()}
    value = value.tolist() if hasattr(value, "tolist") else value  # of NumPy
    if isinstance(value, tuple | list | set | frozenset):
        return [plain(member) for member in value]
    if isinstance(value, Note):
        return value.plain()
    return value if value is None or isinstance(value, str | int | float) else str(value)


def notes_of(arguments: Iterable[Note | str | Mapping[str, Any]]) -> tuple[Note, ...]:
    """Convert texts and dictionaries to notes.

    A text becomes the complete text of a note. A dictionary is the result of `Note.plain`. Notes are unchanged.
    """
    notes = []
    for argument in arguments:
        if isinstance(argument, Note):
            notes.append(argument)
        elif isinstance(argument, str):
            notes.append(Note("said", text=argument))
        else:
            # Files contain lists in place of tuples, and TOML cannot contain None.
            code, address = argument["code"], argument.get("address", "")
            facts = dict.fromkeys(message_format.facts_of(code) - {"address"})
            facts |= {key: tuple(value) if isinstance(value, list) else value for key, value in argument.items()}
            notes.append(Note(code, address, **{k: v for k, v in facts.items() if k not in ("code", "address")}))
    return tuple(notes)
