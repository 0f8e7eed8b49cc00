"""A progress bar for runs that last, and a word where there is no telling how long something will last."""

from __future__ import annotations

import sys
import threading
import time
from types import TracebackType
from typing import Any, Self

PATIENCE = 1.0
"""Time after which a person wants to see something move [s]."""


class Progress:
    """Shows the time reached on stderr, when that is a terminal and the run lasts longer than a second.

    Parameters
    ----------
    duration : float
        Length of the run [s].
    is_quiet : bool, optional
        Never show it.
    """

    def __init__(self, duration: float, *, is_quiet: bool = False) -> None:
        self.duration = duration
        self.is_shown = not is_quiet and sys.stderr.isatty()
        self.began = time.monotonic()
        self._bar: Any = None
        self._task: Any = None

    def __enter__(self) -> Progress:
        return self

    def __call__(self, reached: float) -> None:
        """Show the time reached [s]."""
        if not self.is_shown or time.monotonic() - self.began < PATIENCE:
            return
        if self._bar is None:
            self._start()
        self._bar.update(self._task, completed=reached)

    def _start(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as Bar

        columns = BarColumn(), TextColumn("{task.completed:.4g} of {task.total:.4g} s"), TimeRemainingColumn()
        self._bar = Bar(*columns, console=Console(stderr=True), transient=True)
        self._task = self._bar.add_task("", total=self.duration)
        self._bar.start()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()


class Waiting:
    """Says what is being done, on stderr when that is a terminal, once it lasts longer than a second.

    Parameters
    ----------
    what : str
        What is being done.
    is_quiet : bool, optional
        Never say it.
    """

    def __init__(self, what: str, *, is_quiet: bool = False) -> None:
        self.what = what
        self._status: Any = None
        # A thread of its own: what is waited for does not call back.
        self._timer = threading.Timer(PATIENCE, self._start) if not is_quiet and sys.stderr.isatty() else None

    def __enter__(self) -> Waiting:
        if self._timer is not None:
            self._timer.daemon = True
            self._timer.start()
        return self

    def _start(self) -> None:
        from rich.console import Console

        self._status = Console(stderr=True).status(self.what)
        self._status.start()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer.join()
        if self._status is not None:
            self._status.stop()


class _Spinner:
    """A line on stderr that changes, when that is a terminal and it lasts longer than a second."""

    def __init__(self, *, is_quiet: bool) -> None:
        self.is_shown = not is_quiet and sys.stderr.isatty()
        self.began = time.monotonic()
        self._status: Any = None

    def __enter__(self) -> Self:
        return self

    def _show(self, text: str) -> None:
        if not self.is_shown or time.monotonic() - self.began < PATIENCE:
            return
        if self._status is None:
            from rich.console import Console

            self._status = Console(stderr=True).status(text)
            self._status.start()
        self._status.update(text)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._status is not None:
            self._status.stop()


class Counting(_Spinner):
    """Counts on stderr, when that is a terminal and it lasts longer than a second; the end may not be known before.

    Parameters
    ----------
    what : str
        What is counted.
    is_quiet : bool, optional
        Never show it.
    """

    def __init__(self, what: str, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self.what = what

    def __call__(self, count: int, cost: float) -> None:
        """Show the count and the least cost so far."""
        self._show(f"{count} {self.what}, misfit {cost:.6g}; Ctrl-C keeps the best so far")

    def stages(self, what: str, done: int, total: int) -> None:
        """Show how much is done of what is counted to an end, and for how long all has lasted."""
        elapsed = time.monotonic() - self.began
        self._show(f"{done} of {total} {what}, {elapsed:.0f} s; Ctrl-C keeps the fit")


class Naming(_Spinner):
    """Names on stderr what is being done, when that is a terminal and it lasts longer than a second.

    Parameters
    ----------
    is_quiet : bool, optional
        Never show it.
    """

    def __init__(self, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._count = 0

    def __call__(self, what: str) -> None:
        """Show what begins now."""
        self._count += 1
        self._show(f"{what} (run {self._count}); Ctrl-C keeps the tests that are done")


class Points:
    """Shows points of a map that are done, on stderr, when that is a terminal and it lasts longer than a second.

    Parameters
    ----------
    is_quiet : bool, optional
        Never show them.
    """

    def __init__(self, *, is_quiet: bool = False) -> None:
        self.is_shown = not is_quiet and sys.stderr.isatty()
        self.began = time.monotonic()
        self._bar: Any = None
        self._task: Any = None

    def __enter__(self) -> Points:
        return self

    def __call__(self, done: int, total: int, what: str) -> None:
        """Show how many are done, and which comes next."""
        if not self.is_shown or time.monotonic() - self.began < PATIENCE:
            return
        if self._bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
            from rich.progress import Progress as Bar

            columns = BarColumn(), TextColumn("{task.completed:.0f} of {task.total:.0f}, {task.description}")
            self._bar = Bar(*columns, TimeRemainingColumn(), console=Console(stderr=True), transient=True)
            self._task = self._bar.add_task("", total=total)
            self._bar.start()
        self._bar.update(self._task, completed=done, description=f"{what}; Ctrl-C keeps what is there")

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
