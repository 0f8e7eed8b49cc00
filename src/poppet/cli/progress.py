"""Something moves on a terminal once a command lasts longer than a second: a bar, a count, or a word."""

from __future__ import annotations

import os
import sys
import threading
import time
from types import TracebackType
from typing import Any, Self

PATIENCE = 1.0
"""Time after which a person wants to see something move [s]."""


class _Display:
    """A line on stderr, where that is a terminal and nobody asked for quiet."""

    def __init__(self, *, is_quiet: bool = False) -> None:
        # A log file would be full of bars, and so would a notebook, whose cells take what is written as text.
        self.is_shown = not is_quiet and sys.stderr.isatty() and "JPY_PARENT_PID" not in os.environ
        self.began = time.monotonic()
        self._line: Any = None
        self._task: Any = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._line is not None:
            self._line.stop()

    def _is_due(self) -> bool:
        return self.is_shown and time.monotonic() - self.began >= PATIENCE

    def _say(self, text: str) -> None:
        """Show a spinner with a text."""
        if self._line is None:
            from rich.console import Console

            self._line = Console(stderr=True).status(text)
            self._line.start()
        self._line.update(text)

    def _fill(self, done: float, total: float, text: str) -> None:
        """Show a bar with a text."""
        if self._line is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

            columns = BarColumn(), TextColumn("{task.description}"), TimeRemainingColumn()
            self._line = Progress(*columns, console=Console(stderr=True), transient=True)
            self._task = self._line.add_task("", total=total)
            self._line.start()
        self._line.update(self._task, completed=done, total=total, description=text)


class Progress(_Display):
    """The time that a run of a length [s] has reached."""

    def __init__(self, duration: float, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self.duration = duration

    def __call__(self, reached: float) -> None:
        """Show the time reached [s]."""
        if self._is_due():
            self._fill(reached, self.duration, f"{reached:.4g} of {self.duration:.4g} s")


class Points(_Display):
    """Points of a map that are done."""

    def __call__(self, done: int, total: int, what: str) -> None:
        """Show how many are done, and which comes next."""
        if self._is_due():
            self._fill(done, total, f"{done} of {total}, {what}; Ctrl-C keeps what is there")


class Counting(_Display):
    """A count of what may have no end that is known before."""

    def __init__(self, what: str, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self.what = what

    def __call__(self, count: int, cost: float) -> None:
        """Show the count and the least cost so far."""
        if self._is_due():
            self._say(f"{count} {self.what}, misfit {cost:.6g}; Ctrl-C keeps the best so far")

    def stages(self, what: str, done: int, total: int) -> None:
        """Show how much is done of what is counted to an end, and for how long all has lasted."""
        if self._is_due():
            self._say(f"{done} of {total} {what}, {time.monotonic() - self.began:.0f} s; Ctrl-C keeps the fit")


class Naming(_Display):
    """What is being done, by name."""

    def __init__(self, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._count = 0

    def __call__(self, what: str) -> None:
        """Show what begins now."""
        self._count += 1
        if self._is_due():
            self._say(f"{what} (run {self._count}); Ctrl-C keeps the tests that are done")


class Waiting(_Display):
    """What is being done, where that may not call back: a timer of its own shows it."""

    def __init__(self, what: str, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._timer = threading.Timer(PATIENCE, self._say, [what]) if self.is_shown else None

    def __enter__(self) -> Self:
        if self._timer is not None:
            # A command that fails must not wait for its spinner.
            self._timer.daemon = True
            self._timer.start()
        return self

    def __call__(self, what: str) -> None:
        """Show what begins now."""
        if self._is_due():
            self._say(f"{what}, {time.monotonic() - self.began:.0f} s")

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._timer is not None:
            # Joined as well: it may be showing its line just now.
            self._timer.cancel()
            self._timer.join()
        super().__exit__(kind, error, trace)


class Running(_Display):
    """Runs of an ensemble, and how fast they come."""

    def __init__(self, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._kind, self._first, self._since = "", 0, self.began

    def __call__(self, done: int, total: int, kind: str) -> None:
        """Show how many of a kind are done; what lay there already has no part in the rate."""
        if kind != self._kind:
            self._kind, self._first, self._since = kind, done, time.monotonic()
        if self._is_due():
            rate = (done - self._first) / max(time.monotonic() - self._since, 1e-3)
            told = f"{rate:.0f}" if rate >= 10.0 else f"{rate:.2g}"
            self._fill(done, total, f"{done} of {total} {OF_ENSEMBLES[kind]}, {told}/s; Ctrl-C keeps what is done")


OF_ENSEMBLES = {"runs": "runs", "tornado": "more for the tornado", "indices": "more for Sobol indices"}
"""Runs of an ensemble by their kind."""
