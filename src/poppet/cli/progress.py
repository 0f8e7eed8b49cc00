"""A progress bar for runs that last."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any

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
