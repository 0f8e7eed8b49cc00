"""Calendar and clock times in text files: ISO 8601, `dd.mm.yyyy hh:mm:ss,fff`, `hh:mm:ss,fff`, with AM or PM."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta, timezone, tzinfo

import numpy as np

from poppet.timeseries.checks import FloatArray

_STAMP = re.compile(
    r"(?<![\w.:-])(?:(?P<year>\d{4})(?P<sign>[-/])(?P<month>\d\d?)(?P=sign)(?P<day>\d\d?)"
    r"|(?P<day_first>\d\d?)\.(?P<month_second>\d\d?)\.(?P<year_last>\d{4}))"
    r"(?:[ T]+)(?P<hour>\d\d?):(?P<minute>\d\d)(?::(?P<second>\d\d)"
    # A comma is a decimal sign if the stamp ends its cell: the next character is not a comma or a point.
    r"(?:\.(?P<point>\d{1,9})|,(?P<comma>\d{1,9})(?![\d,.]))?)?"
    r"[ ]?(?P<zone>Z|[+-]\d\d:?\d\d)?(?![\w:])"
)
_CLOCK = re.compile(
    r"(?<![\w.:,+-])(?<!/\d\d )(?<!/\d{4} )(?P<hour>[01]?\d|2[0-3]):(?P<minute>[0-5]\d):(?P<second>[0-5]\d)"
    r"(?:\.(?P<point>\d{1,9})|,(?P<comma>\d{1,9})(?![\d,.]))?(?:[ ]?(?P<half>[AaPp])[Mm])?(?![\w:])"
)
"""Time of day without a date, or with its date in another column; a date with strokes before it is not readable."""
_DAY = 86400 * 10**9
"""Period of a clock without a date [ns]; samples are less than half a day apart."""
_MOST = 0.5
"""Fraction of the last lines that must contain a time stamp."""
_LAST = 60
_FORM = "{}e-9"
"""Form of a stamp in the converted lines; a number in files with a decimal point and with a decimal comma [s]."""
CONVERTED = re.compile(r"-?\d+e-9")

SERIAL_DAYS = 30000.0, 80000.0
"""Serial numbers of Excel for the years 1982 to 2119 [d]."""
LONGEST_DAYS = 31.0
"""Longest recording in serial numbers [d]."""


def convert_stamps(lines: Sequence[tuple[int, str]]) -> tuple[list[tuple[int, str]], str]:
    """Replace the time stamps in text lines with seconds since the first stamp.

    Returns
    -------
    lines : list of tuple
        Line numbers and texts. If most of the last lines contain no time stamp, the texts are unchanged.
    first : str
        First time stamp; empty if there is none.
    """
    last = [text for _, text in lines[-_LAST:]]
    counts = [(sum(pattern.search(text) is not None for text in last), pattern) for pattern in (_STAMP, _CLOCK)]
    pattern = next((pattern for count, pattern in counts if last and count >= _MOST * len(last)), None)
    if pattern is None:
        return list(lines), ""
    start, first, previous, converted = None, "", 0, []
    for number, text in lines:
        match = pattern.search(text)
        if match and match["comma"] and match.group() == text.strip():
            match = pattern.search(text[: match.start("comma") - 1])  # the comma separates the only two columns
        nanoseconds = None if match is None else _time_in_nanoseconds(match)
        if match is None or nanoseconds is None:
            converted.append((number, text))
            continue
        if start is None:
            start, first = nanoseconds, match.group()
        elif pattern is _CLOCK:
            nanoseconds += round((previous - nanoseconds) / _DAY) * _DAY
        previous = nanoseconds
        converted.append((number, f"{text[: match.start()]}{_FORM.format(nanoseconds - start)}{text[match.end() :]}"))
    return converted, first


def nanoseconds_of(text: str) -> int | None:
    """Return the time of a time stamp since 1970 [ns], or None if the text is no time stamp.

    Examples
    --------
    >>> nanoseconds_of("1970-01-01T00:00:01.5Z"), nanoseconds_of("6.1 bar")
    (1500000000, None)
    """
    match = _STAMP.fullmatch(text.strip())
    return None if match is None else _time_in_nanoseconds(match)


def _time_in_nanoseconds(match: re.Match[str]) -> int | None:
    """Return the time of a time stamp since 1970 [ns].

    `match` is the result of the regular expression for time stamps. The result is None if the date does not exist.
    """
    zone: tzinfo = UTC
    year, month, day = 1970, 1, 1
    if match.re is _STAMP:
        year, month, day = (
            int(match[name] or match[other])
            for name, other in (("year", "year_last"), ("month", "month_second"), ("day", "day_first"))
        )
    if match.re is _STAMP and match["zone"] and match["zone"] != "Z":
        digits = match["zone"].replace(":", "")
        offset = timedelta(hours=int(digits[1:3]), minutes=int(digits[3:5]))
        zone = timezone(-offset if digits[0] == "-" else offset)
    hour = int(match["hour"])
    if half := match["half"] if match.re is _CLOCK else "":
        hour = hour % 12 + (12 if half in "Pp" else 0)
    try:
        moment = datetime(year, month, day, hour, int(match["minute"]), int(match["second"] or 0), tzinfo=zone)
    except ValueError:
        return None
    fraction = (match["point"] or match["comma"] or "").ljust(9, "0")
    since = moment - datetime(1970, 1, 1, tzinfo=UTC)
    return (since.days * 86400 + since.seconds) * 10**9 + int(fraction)


def is_serial(column: FloatArray) -> bool:
    """Return True if a column without a unit seems to contain day numbers of Excel.

    Examples
    --------
    >>> is_serial(45987.25 + np.arange(20) * 0.1 / 86400.0), is_serial(45987.0 + np.arange(200.0))
    (True, False)
    """
    times = column[np.isfinite(column)]
    if times.size < 3 or not SERIAL_DAYS[0] <= np.min(times) <= np.max(times) <= SERIAL_DAYS[1]:
        return False
    # Seconds of a logger that has run for hours are in the same range; 2e-5 d are 1.7 s.
    return float(np.ptp(times)) < LONGEST_DAYS and 0.0 < float(np.median(np.abs(np.diff(times)))) < 2e-5
