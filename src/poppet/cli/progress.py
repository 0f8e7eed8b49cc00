"""Progress display on the terminal for commands that take longer than a second.

The display is a bar, a count or a text.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from types import TracebackType
from typing import Any, Self

PATIENCE = 0.6
"""Time from the start of a display to its first line [s]: with the start of the program, about a second."""
FIRST_TEXT = "The model is compiled"
"""Text of a command that has not reported progress after this time: the first run of a model compiles it."""
RUN_KINDS = {"runs": "runs", "tornado": "more for the tornado", "indices": "more for Sobol indices"}
"""Printed texts for the kinds of runs of an ensemble, by kind."""


class _Display:
    """Line on the terminal that shows the progress of a command.

    Nothing is shown if the standard error is not a terminal, or if the option --quiet is set.
    """

    def __init__(self, *, is_quiet: bool = False) -> None:
        # A log file would be full of bars, and so would the output of a notebook cell.
        self.is_shown = not is_quiet and sys.stderr.isatty() and "JPY_PARENT_PID" not in os.environ
        self.start_time = time.monotonic()
        self._line: Any = None
        self._task: Any = None
        self._lock = threading.Lock()
        self._latest: tuple[str, float, float | None] = (FIRST_TEXT, 0.0, None)
        self._timer = threading.Timer(PATIENCE, self._show_latest) if self.is_shown else None

    def __enter__(self) -> Self:
        if self._timer is not None:
            # Daemon: a failed command must not wait for the timer.
            self._timer.daemon = True
            self._timer.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._timer is not None:
            # Join as well: the timer may be printing its line.
            self._timer.cancel()
            self._timer.join()
        if self._line is not None:
            self._line.stop()

    @property
    def elapsed(self) -> float:
        """Time since the start of the command [s]."""
        return time.monotonic() - self.start_time

    def _show(self, text: str, done: float = 0.0, total: float | None = None) -> None:
        """Show a text with a spinner, or with a bar if `total` is known.

        `done` and `total` are amounts of work, for example numbers of runs.
        """
        self._latest = text, done, total
        if self.is_shown and self.elapsed >= PATIENCE:
            self._show_latest()

    def _show_latest(self) -> None:
        """Show the latest progress; a timer calls this method once, so a slow first step is visible as well."""
        with self._lock:
            text, done, total = self._latest
            if self._line is not None and (self._task is None) != (total is None):
                # From the spinner of the first step to a bar.
                self._line.stop()
                self._line = self._task = None
            if self._line is None:
                from rich.console import Console
                from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

                console = Console(stderr=True)
                if total is None:
                    self._line = console.status(text)
                else:
                    columns = BarColumn(), TextColumn("{task.description}"), TimeRemainingColumn()
                    self._line = Progress(*columns, console=console, transient=True)
                    self._task = self._line.add_task("", total=total)
                self._line.start()
            if total is None:
                self._line.update(text)
            else:
                self._line.update(self._task, completed=done, total=total, description=text)


class RunProgress(_Display):
    """Progress of a simulation, shown as simulated time."""

    def __init__(self, duration: float, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self.duration = duration

    def __call__(self, simulated_time: float) -> None:
        """Show the simulated time [s] that has been reached."""
        self._show(f"{simulated_time:.4g} of {self.duration:.4g} s", simulated_time, self.duration)


class FractionProgress(_Display):
    """Progress of a computation, shown as a percentage."""

    def __call__(self, fraction: float) -> None:
        """Show the fraction of the work that is done."""
        self._show(f"{100.0 * fraction:.0f} %", fraction, 1.0)


class PointProgress(_Display):
    """Progress of a computation at many points, shown as the number of computed points."""

    def __call__(self, done: int, total: int, following: str) -> None:
        """Show the number of computed points and a text on the next point.

        `done` of `total` points are computed. `following` is the text on the next point.
        """
        self._show(f"{done} of {total}, {following}; Ctrl-C keeps the computed points", done, total)


class CaseProgress(_Display):
    """Progress of several runs of different cases, shown as the number of completed runs."""

    def __call__(self, done: int, total: int, last: str) -> None:
        """Show the number of completed runs and the case of the last one.

        `done` of `total` runs are completed. `last` is the name of the case of the last run.
        """
        self._show(f"{done} of {total} runs, {last}; Ctrl-C keeps the completed runs", done, total)


class FitProgress(_Display):
    """Progress of a fit, shown as the number of evaluations and the lowest cost."""

    def __call__(self, count: int, cost: float) -> None:
        """Show the number of evaluations `count` and the lowest cost so far, `cost`."""
        self._show(f"Fit: {count} evaluations, cost {cost:.6g}; Ctrl-C keeps the best point")

    def stages(self, stage: str, done: int, total: int) -> None:
        """Show the progress of a stage after the search, such as the bootstrap, and the elapsed time.

        `stage` is the name of the stage. `done` and `total` are the numbers of its completed fits and of all its fits.
        """
        self._show(f"After the fit: {done} of {total} {stage}, {self.elapsed:.0f} s; Ctrl-C keeps the fit")


class BenchProgress(_Display):
    """Progress of the tests of a valve, shown as the name of the current test."""

    def __init__(self, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._count = 0

    def __call__(self, test: str) -> None:
        """Show the name of the test that starts now."""
        self._count += 1
        self._show(f"{test} (run {self._count}); Ctrl-C keeps the completed tests")


class Spinner(_Display):
    """Text with a spinner, for a computation that does not report progress.

    It appears if the computation takes longer than `PATIENCE`.
    """

    def __init__(self, text: str, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._latest = text, 0.0, None

    def __call__(self, text: str) -> None:
        """Show `text`, the name of the current operation, and the elapsed time."""
        self._show(f"{text}, {self.elapsed:.0f} s")


class SizingProgress(_Display):
    """Progress of a sizing, shown as the number of completed runs."""

    def __call__(self, done: int, total: int, kind: str) -> None:
        """Show the number of completed runs.

        `done` of about `total` runs are completed; the search decides how many are necessary. `kind` names them.
        """
        # Before the first completed runs, the model is compiled.
        self._show(f"{done} of about {total} {kind}" if done else FIRST_TEXT, done, total if done else None)


class EnsembleProgress(_Display):
    """Progress of an ensemble, shown as the number of completed runs and runs per second."""

    def __init__(self, *, is_quiet: bool = False) -> None:
        super().__init__(is_quiet=is_quiet)
        self._kind, self._n_stored, self._kind_start = "", 0, self.start_time

    def __call__(self, done: int, total: int, kind: str) -> None:
        """Show the number of completed runs and the runs per second.

        `done` of `total` runs of one kind are completed. `kind` is `runs` (of the ensemble), `tornado` or `indices`.
        The runs per second exclude runs that an earlier command has stored.
        """
        if kind != self._kind:
            self._kind, self._n_stored, self._kind_start = kind, done, time.monotonic()
        rate = (done - self._n_stored) / max(time.monotonic() - self._kind_start, 1e-3)
        rate_text = f"{rate:.0f}" if rate >= 10.0 else f"{rate:.2g}"
        self._show(f"{done} of {total} {RUN_KINDS[kind]}, {rate_text}/s; Ctrl-C keeps the completed runs", done, total)
