"""What the house has to say, as a code with an address and its numbers; words are made of it last, in `wording.py`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any


class Note:
    """Something a reader has to know: a note, a finding, a suspicion, or how a run ended.

    Parameters
    ----------
    code : str
        Dotted name of what is said, `run.stalled`; its words stand in `core/messages/run.toml`.
    address : str, optional
        What it is about: a dotted path, or the name of a test or channel.
    **facts
        Numbers, names and lists of them that the words show: plain values, so that they can be written to files.

    Examples
    --------
    >>> str(Note("said", text="Recorded on a cold morning."))
    'Recorded on a cold morning.'
    """

    __slots__ = ("address", "code", "facts")

    def __init__(self, code: str, address: str = "", /, **facts: Any) -> None:
        self.code, self.address, self.facts = code, address, facts

    def __str__(self) -> str:
        from poppet.core.message_format import sentence

        return sentence(self.code, {**self.facts, "address": self.address})

    def __repr__(self) -> str:
        facts = "".join(f", {key}={value!r}" for key, value in self.facts.items())
        return f"Note({self.code!r}, {self.address!r}{facts})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Note) and self.plain() == other.plain()

    def __hash__(self) -> int:
        return hash((self.code, self.address))

    def plain(self) -> dict[str, Any]:
        """Code, address and facts as a table for a file: numbers, texts, and lists and tables of them."""
        return {"code": self.code, "address": self.address, **plain(self.facts)}

    def within(self, owner: str) -> Note:
        """The same, said about something inside `owner`: its name is put before the address."""
        # What is said about a table has a file as its address, which is no part of a recording as its channels are.
        joint = ": " if self.code.startswith("table.") else "."
        return Note(self.code, joint.join(filter(None, (owner, self.address))), **self.facts)


def plain(value: Any) -> Any:
    """A fact as files can hold it; what they have no type for becomes the words in which it would be shown."""
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    value = value.tolist() if hasattr(value, "tolist") else value  # of NumPy
    if isinstance(value, tuple | list | set | frozenset):
        return [plain(each) for each in value]
    if isinstance(value, Note):
        return value.plain()
    return value if value is None or isinstance(value, str | int | float) else str(value)


def notes_of(given: Iterable[Note | str | Mapping[str, Any]]) -> tuple[Note, ...]:
    """Notes from what a user typed (a sentence) or a file holds (a table of `Note.plain`)."""
    return tuple(_note(each) for each in given)


def _note(given: Note | str | Mapping[str, Any]) -> Note:
    from poppet.core.message_format import facts_of

    if isinstance(given, Note):
        return given
    if isinstance(given, str):
        return Note("said", text=given)
    # A file has lists for what was a tuple, and TOML has nothing for None.
    facts = {k: tuple(v) if isinstance(v, list) else v for k, v in given.items() if k not in ("code", "address")}
    return Note(
        given["code"], given.get("address", ""), **(dict.fromkeys(facts_of(given["code"]) - {"address"}) | facts)
    )
