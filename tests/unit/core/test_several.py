"""Notes of one kind as one."""

from __future__ import annotations

from poppet.core.codes import Note
from poppet.core.note_groups import FEWEST, grouped


def held(address: str, time: float = 1.0) -> Note:
    return Note("signals.held_after", address, source="", value=1.0, time=time)


def missed(bar: float) -> Note:
    facts = {"target_bar": 3.0, "time": bar, "unpowered": False, "outlet_bar": 3.0 - bar, "missed_bar": bar}
    return Note("valve.not_reached", "valve", **facts)


def test_few_notes_are_not_combined():
    few = [held("a"), missed(0.1), held("b")]
    assert grouped(few) == few
    assert FEWEST == 3


def test_equal_notes_count_once():
    assert grouped([held("a"), held("a"), held("a"), held("a")]) == [held("a")]
    assert grouped(["Cold.", "Cold.", "Wet."]) == [Note("said", text="Cold."), Note("said", text="Wet.")]


def test_many_notes_become_the_first_with_the_addresses_of_the_others():
    (note,) = grouped([held(each) for each in "abcdefg"])
    assert (note.code, note.address, note.facts["kind"]) == ("several.alike", "a", "signals.held_after")
    assert (note.facts["more"], note.facts["places"], note.facts["others"]) == (6, ("b", "c", "d"), 3)
    assert note.facts["first"] == str(held("a"))


def test_all_addresses_are_named_if_they_are_few():
    (note,) = grouped([held("a"), held("a", 2.0), held("b")])
    assert (note.facts["more"], note.facts["places"], note.facts["others"]) == (2, ("b",), None)


def test_many_notes_with_a_size_become_the_first_and_the_worst():
    (note,) = grouped([missed(0.1), missed(0.4), missed(0.2)])
    assert (note.code, note.facts["more"], note.facts["size"]) == ("several.worst", 2, 0.4)
    assert (note.facts["first"], note.facts["worst"]) == (str(missed(0.1)), str(missed(0.4)))


def test_worst_note_is_not_repeated():
    (note,) = grouped([missed(0.4), missed(0.1), missed(0.2)])
    assert (note.code, note.facts["more"], note.facts["size"]) == ("several.none_worse", 2, 0.4)


def test_groups_have_the_position_of_their_first_note():
    shown = grouped([held("a"), missed(0.1), held("b"), held("c"), held("d")])
    assert [note.code for note in shown] == ["several.alike", "valve.not_reached"]


def test_notes_of_an_older_file_lack_facts():
    old = [Note("run.not_conserved", each, quantity="mass", error=None, unit="kg", allowed=1e-9) for each in "abc"]
    (note,) = grouped(old)
    assert (note.code, note.facts["more"], note.facts["size"]) == ("several.none_worse", 2, None)
