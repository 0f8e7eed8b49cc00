"""Command `poppet watch`: condition monitoring of a running plant, from a recording or from lines."""

from __future__ import annotations

import argparse
import contextlib
import json
import sys
from typing import TYPE_CHECKING, BinaryIO

from poppet.cli.main import INTERRUPTED
from poppet.cli.progress import FractionProgress, Spinner
from poppet.cli.summary import print_notes, print_written, require_matplotlib
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.number_format import printable

if TYPE_CHECKING:
    from poppet.monitoring.baseline import Baseline
    from poppet.monitoring.twin_file import Twin
    from poppet.monitoring.watch import Watch

WINDOWS = 10.0
"""Part of a recording in windows for which the report states what the sensors can distinguish."""

IDLE_OPTIONS = {"commission": ("isolable", "recording", "output", "report"), "isolable": ("output", "report")}
"""Options of other tasks, by the option of a task."""


def execute(options: argparse.Namespace) -> int:
    """Run the command `watch`, and return the exit code."""
    from poppet.monitoring.baseline import read_baseline
    from poppet.monitoring.twin_file import read_twin_file
    from poppet.monitoring.watch import watch_of_twin

    for task, idle in IDLE_OPTIONS.items():
        for name in idle:
            if getattr(options, task) and getattr(options, name):
                raise InputError("twin.idle_option", option=f"--{name}", task=f"--{task}")
    for name in ("output", "report"):
        if getattr(options, name) and not options.recording:
            raise InputError("twin.needs_recording", option=f"--{name}")
    require_matplotlib(options.report)
    twin = read_twin_file(options.file)
    if options.commission:
        return _commission(options, twin)
    if options.isolable:
        with Spinner("simulating the healthy plant", is_quiet=options.quiet):
            result = watch_of_twin(twin).isolable(options.recording)
        print(result.summary())
        return 0
    baseline = read_baseline(twin.baseline, twin.plan)
    watch = watch_of_twin(twin, baseline)
    return _run_recording(options, watch, baseline) if options.recording else _run_stream(options, watch)


def _commission(options: argparse.Namespace, twin: Twin) -> int:
    """Write the baseline of a healthy recording."""
    from poppet.core.files import check_folder, check_path
    from poppet.monitoring.baseline import is_baseline
    from poppet.monitoring.watch import watch_of_twin
    from poppet.report.watch_text import baseline_summary

    check_path(twin.baseline)
    check_folder(twin.baseline, twin.baseline.parent)
    if twin.baseline.exists():
        if not is_baseline(twin.baseline):
            raise InputError("twin.no_baseline_file", "baseline", path=str(twin.baseline), file=options.file)
        if not options.force:
            raise InputError("twin.baseline_exists", "baseline", path=str(twin.baseline), file=options.file)
    watch = watch_of_twin(twin)
    with FractionProgress(is_quiet=options.quiet) as progress:
        baseline = watch.commission(options.commission, progress=progress)
    baseline.save(twin.baseline)
    print_notes(baseline.remarks)
    print(baseline_summary(baseline))
    print_written(twin.baseline)
    return 0


def _run_recording(options: argparse.Namespace, watch: Watch, baseline: Baseline) -> int:
    """Process a recording, and write or print its estimates."""
    from poppet.monitoring.note_limiter import NoteLimiter
    from poppet.report.watch_text import record_summary

    problems: list[InputError] = []
    with FractionProgress(is_quiet=options.quiet) as progress:
        record = watch.run(options.recording, progress=progress, problems=problems)
    limiter = NoteLimiter(_print_message)
    for problem in problems:
        limiter(problem)
    print_notes(record.notes)
    if not len(record) and record.is_complete:
        raise InputError("stream.nothing", lines=0, columns=tuple(watch.reader.units))
    print(record_summary(record, baseline), flush=True)
    if options.output:
        record.save(options.output)
    if options.report:
        from poppet.report.watch_report import write_watch

        with Spinner("simulating the healthy plant", is_quiet=options.quiet):
            isolability = (
                watch.isolable(options.recording, longest=WINDOWS * watch.plan.window) if len(record) else None
            )
        write_watch(record, baseline, options.report, isolability)
    print_written(options.output, options.report)
    if not record.is_complete:
        last = float(record.time[-1]) if len(record) else 0.0
        _print_message(Note("stream.interrupted", rows=len(record), time=last))
    return 0 if record.is_complete else INTERRUPTED


def _run_stream(options: argparse.Namespace, watch: Watch) -> int:
    """Process the lines of the standard input, and print one JSON line for each sample."""
    from poppet.monitoring.note_limiter import NoteLimiter
    from poppet.monitoring.stream import HeadingError, LineReader, lines_of

    reader, limiter = LineReader(watch.clock.column, watch.reader.units), NoteLimiter(_print_message)
    verdicts = VerdictPrinter(watch, is_quiet=options.quiet)
    source: BinaryIO = sys.stdin.buffer
    if source.isatty() and not options.quiet:
        _print_message(Note("stream.terminal", columns=tuple(watch.reader.units)))
    code, n_lines, n_used = 0, 0, 0
    try:
        for line in lines_of(source):
            n_lines += 1
            problems: list[InputError] = []
            try:
                values = reader.read(line)
                is_used = values is not None and watch.process(watch.reader.read(values, problems), problems)
            except HeadingError:
                raise
            except InputError as error:
                is_used = False
                problems.append(error)
            if is_used:
                n_used += 1
                # The output of --quiet is suppressed, but these lines are the result.
                print(json.dumps(watch.row(), allow_nan=False), file=options.stdout, flush=True)
                verdicts.show()
            for problem in problems:
                limiter(problem)
    except KeyboardInterrupt:
        code = INTERRUPTED
    if not options.quiet:
        _print_message(Note("stream.summary", lines=n_lines, used=n_used, messages=limiter.total))
    if not n_used and code == 0:
        raise InputError("stream.nothing", lines=n_lines, columns=tuple(watch.reader.units))
    return code


class VerdictPrinter:
    """Printer of the verdicts of a stream to the standard error when they change.

    A verdict without an alarm is printed once per window at most.
    """

    def __init__(self, watch: Watch, *, is_quiet: bool) -> None:
        self.watch, self.is_quiet = watch, is_quiet
        self._verdict: object = None
        self._printed: dict[str, float] = {}

    def show(self) -> None:
        """Print the present verdict if it is another one than before."""
        verdict = self.watch.verdict
        if verdict is self._verdict or self.is_quiet:
            return
        self._verdict = verdict
        time, code = self.watch.time, verdict.note.code
        if verdict.names or time - self._printed.get(code, -float("inf")) >= self.watch.plan.window:
            self._printed[code] = time
            _print_message(Note("stream.verdict", time=time, text=str(verdict.note)))


def _print_message(message: Note | InputError) -> None:
    """Print a message to the standard error, which can be closed while the results are still read."""
    with contextlib.suppress(OSError):
        print(f"note: {printable(str(message))}", file=sys.stderr, flush=True)
