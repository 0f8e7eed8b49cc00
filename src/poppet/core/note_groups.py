"""Combination of similar notes into one line for display."""

from __future__ import annotations

from collections.abc import Iterable

from poppet.core.codes import Note, notes_of

FEWEST = 3
"""Minimum number of notes of one code that form a group."""
SIZES = {
    "bench.step.coarse": "error",
    "bench.step.swings": "amplitude",
    "curves.left_domain": "beyond_mm",
    "finding.held_out": "percent",
    "measured.empty_cells": "lost",
    "measured.repeated_stamps": "count",
    "run.not_conserved": "error",
    "valve.not_held": "swing_bar",
    "valve.not_reached": "missed_bar",
}
"""Mapping from message codes to the fact that measures the severity of a note."""


MAX_EXPLAINED = 3
"""Maximum number of codes in the command that explains messages."""


def explain_command(codes: Iterable[str]) -> str:
    """Return the command that explains the first of the given message codes.

    Texts of users, which have the code `said`, are omitted. The result is empty if no code remains.

    Examples
    --------
    >>> explain_command(["finding.capped", "said", "finding.capped", "finding.room"])
    'poppet explain finding.capped finding.room'
    """
    unique_codes = [code for code in dict.fromkeys(codes) if code != "said"]
    return f"poppet explain {' '.join(unique_codes[:MAX_EXPLAINED])}" if unique_codes else ""


def code_of(note: Note) -> str:
    """Return the code of a note, or of the notes that are combined into it."""
    return str(note.facts.get("kind", note.code)) if note.code.startswith("several.") else note.code


def grouped(notes: Iterable[Note | str]) -> list[Note]:
    """Combine three or more notes with the same code into one note.

    Parameters
    ----------
    notes : iterable of Note or str
        Notes in order. Equal notes count once.

    Returns
    -------
    list of Note
        Notes in the order of the first note of each code. Three or more notes with one code are combined into a note
        that contains the first of them and the number of the others. Its code is `several.worst` if another note is
        worse, and `several.none_worse` if the first is the worst. If the severity cannot be measured, its code is
        `several.alike`, and it contains the addresses of the others.

    Examples
    --------
    >>> print(*grouped([Note("bench.doubtful", name) for name in "abcdefg"]))
    The measurement uncertainty of a could not be determined.
    There are 6 further notes of this kind, on b, c, d and 3 others.
    """
    unique_notes = list(dict.fromkeys(notes_of(notes)))
    kinds: dict[str, list[Note]] = {}
    for note in unique_notes:
        kinds.setdefault(_kind(note), []).append(note)
    is_many = {kind: len(alike) >= FEWEST for kind, alike in kinds.items()}
    firsts = [note for note in unique_notes if not is_many[_kind(note)] or note is kinds[_kind(note)][0]]
    return [_several(kinds[_kind(note)]) if is_many[_kind(note)] else note for note in firsts]


def _kind(note: Note) -> str:
    # Texts of users have one code but are different.
    return str(note.facts["text"]) if note.code == "said" else note.code


def _several(alike: list[Note]) -> Note:
    first, *rest_of_notes = alike
    facts = {"first": str(first), "more": len(rest_of_notes), "kind": first.code}
    size = SIZES.get(first.code)
    if size is not None:
        # Files of older versions may not contain the fact.
        worst = max(alike, key=lambda note: abs(note.facts.get(size) or 0.0))
        facts["size"] = worst.facts.get(size)
        if worst is first:
            return Note("several.none_worse", first.address, **facts)
        return Note("several.worst", worst.address, **facts, worst=str(worst))
    addresses = [
        address for address in dict.fromkeys(note.address for note in rest_of_notes) if address != first.address
    ]
    first_addresses = tuple(addresses[:3]) if len(addresses) > 4 else tuple(addresses)
    return Note(
        "several.alike",
        first.address,
        **facts,
        places=first_addresses,
        others=len(addresses) - len(first_addresses) or None,
    )
