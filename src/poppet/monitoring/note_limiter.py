"""Limiter of messages that repeat, for programs that run for months."""

from __future__ import annotations

from collections.abc import Callable

from poppet.core.codes import Note
from poppet.core.errors import InputError

MOST_KINDS = 1000
"""Maximum number of kinds of messages that are counted; further kinds are dropped."""


class NoteLimiter:
    """Counter of messages that passes the first of each kind, and the 10th, 100th and so on with their number.

    Two messages are of one kind if they have the same code and the same address.

    Parameters
    ----------
    send : callable
        Function that is called with the messages to show.
    """

    def __init__(self, send: Callable[[Note | InputError], None]) -> None:
        self.send = send
        self.counts: dict[tuple[str, str], int] = {}

    def __call__(self, message: Note | InputError) -> None:
        """Count a message, and pass it on if it is the 1st, 10th, 100th and so on of its kind."""
        for single in message.problems if isinstance(message, InputError) else (message,):
            kind = single.code, single.address or ""
            if kind not in self.counts and len(self.counts) >= MOST_KINDS:
                continue
            count = self.counts[kind] = self.counts.get(kind, 0) + 1
            if count == 1:
                self.send(single)
            elif count >= 10 and not count % 10 ** (len(str(count)) - 1) and str(count)[0] == "1":
                self.send(Note("stream.repeated", count=count, text=str(single)))

    @property
    def total(self) -> int:
        """Number of counted messages."""
        return sum(self.counts.values())
