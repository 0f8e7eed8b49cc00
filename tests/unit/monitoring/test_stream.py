"""Lines of a stream: JSON objects, CSV rows, and everything else."""

from __future__ import annotations

import contextlib
import tracemalloc

import numpy as np
import pytest

from poppet.core.errors import InputError
from poppet.monitoring.note_limiter import NoteLimiter
from poppet.monitoring.stream import LONGEST_LINE, HeadingError, LineReader, lines_of
from refusals import refused

UNITS = {"t": "s", "p_A": "bar g", "u": "1"}


@pytest.fixture
def reader():
    return LineReader("t", UNITS)


def test_json_objects_are_tables(reader):
    assert reader.read(b'{"t": 1, "p_A": 6.5, "x": null}\n') == {"t": 1, "p_A": 6.5, "x": None}
    assert reader.read(b"  \r\n") is None


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_rows_follow_a_heading(reader, separator):
    decimal = "." if separator == "," else ","
    assert reader.read(separator.join(["t [s]", "note", "u", "p_A (bar g)"]).encode()) is None
    values = reader.read(separator.join([f"1{decimal}5", "warm", "", f"6{decimal}25"]).encode())
    assert values == {"t": 1.5, "u": None, "p_A": 6.25}


def test_a_heading_can_have_a_byte_order_mark_and_quotes(reader):
    assert reader.read('\ufeff"t","p_A","u"\n'.encode()) is None
    assert reader.read(b'"1","2","3"\n') == {"t": 1.0, "p_A": 2.0, "u": 3.0}


def test_a_later_heading_reorders_the_columns(reader):
    reader.read(b"t,p_A,u")
    assert reader.read(b"u,t,p_A") is None
    assert reader.read(b"1,2,3") == {"t": 2.0, "p_A": 3.0, "u": 1.0}


def test_text_cells_and_python_numbers_remain_text(reader):
    reader.read(b"t,p_A,u")
    assert reader.read(b"1,1_000,open") == {"t": 1.0, "p_A": "1_000", "u": "open"}


@pytest.mark.parametrize(
    ("heading", "code", "column"),
    [
        (b"t,p_B,u", "stream.no_column", "p_A"),
        (b"t,p_A [mbar g],u", "stream.other_unit", "p_A"),
        (b"t [ms],p_A,u", "stream.other_unit", "t"),
    ],
)
def test_the_first_heading_must_agree_with_the_twin_file(reader, heading, code, column):
    with refused(code, column, kind=HeadingError):
        reader.read(heading)
    with refused("stream.no_heading"):
        reader.read(b"1,2,3")


def test_a_later_heading_keeps_the_columns_that_agree(reader):
    reader.read(b"t,p_A,u")
    with refused("stream.other_unit", "p_A", written="mbar g") as caught:
        reader.read(b"t,p_A [mbar g],u")
    assert not isinstance(caught.value, HeadingError)
    assert reader.read(b"1,6000,0") == {"t": 1.0, "u": 0.0}


@pytest.mark.parametrize("damaged", [b"t", b"t,p_A", b"x,t,y"])
def test_a_damaged_heading_does_not_replace_the_present_one(reader, damaged):
    reader.read(b"t,p_A,u")
    with refused("stream.no_column", "u"):
        reader.read(damaged)
    assert reader.read(b"1,2,3") == {"t": 1.0, "p_A": 2.0, "u": 3.0}


@pytest.mark.parametrize(
    ("line", "code"),
    [
        (b'{"t": 1, "p_A": 6.5', "stream.no_json"),
        (b'{"t": ' + b"[" * 100_000 + b"}", "stream.no_json"),
        (b'{"t": ' + b"9" * 10_000 + b"}", "stream.no_json"),
        (b'[{"t": 1}]', "stream.no_heading"),
        (b"hello", "stream.no_heading"),
        (b"\x00\x01\x02", "stream.no_text"),
        (b"\xff\xfe{\x00", "stream.no_text"),
        (b" " * (LONGEST_LINE + 1), "stream.long_line"),
    ],
)
def test_other_lines_are_rejected(reader, line, code):
    with refused(code):
        reader.read(line)


def test_short_and_long_rows_are_rejected(reader):
    reader.read(b"t,p_A,u")
    for row, count in ((b"1,2", 2), (b"1,2,3,4", 4)):
        with refused("stream.width", count=count, expected=3):
            reader.read(row)


class LongLine:
    """Stream with one line of 100 MB and a short one, of which no more than a piece exists."""

    def __init__(self):
        self.left, self.rest = 100_000_000, [b"{}"]

    def readline(self, size):
        count = min(size, self.left)
        self.left -= count
        if count:
            return b"x" * count + (b"\n" if count < size else b"")
        return self.rest.pop(0) if self.rest else b""


def test_a_line_of_100_mb_needs_little_memory():
    tracemalloc.start()
    lengths = [len(line) for line in lines_of(LongLine())]
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert lengths == [LONGEST_LINE + 1, 2]
    assert peak < 8 * LONGEST_LINE


def test_garbage_does_not_stop_the_reader(reader):
    generator = np.random.default_rng(1)
    for _ in range(2000):
        line = generator.integers(0, 256, generator.integers(0, 200), dtype=np.uint8).tobytes()
        with contextlib.suppress(InputError):
            reader.read(line.replace(b"t", b"-"))
    assert reader.read(b'{"t": 1}') == {"t": 1}


def test_repeated_messages_are_counted():
    shown = []
    limiter = NoteLimiter(shown.append)
    for _ in range(2500):
        limiter(InputError("stream.no_text"))
    limiter(InputError("stream.no_number", "p_A", value="'x'"))
    assert [message.code for message in shown] == ["stream.no_text", *["stream.repeated"] * 3, "stream.no_number"]
    assert [message.facts["count"] for message in shown[1:4]] == [10, 100, 1000]
    assert limiter.total == 2501


def test_kinds_of_messages_are_limited():
    shown = []
    limiter = NoteLimiter(shown.append)
    for k in range(5000):
        limiter(InputError("stream.no_number", f"column {k}", value="'x'"))
    assert len(shown) == len(limiter.counts) == 1000
