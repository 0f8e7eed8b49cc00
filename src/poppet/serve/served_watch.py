"""Condition monitoring of a served circuit: the watch of a twin file, in a process of its own."""

from __future__ import annotations

import asyncio
import math
import multiprocessing
import signal
from collections import deque
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.monitoring.baseline import read_baseline
from poppet.monitoring.samples import Sample
from poppet.monitoring.twin_file import Twin, read_twin_file
from poppet.monitoring.watch import Watch, watch_of_twin
from poppet.serve.machine import Machine
from poppet.serve.points import PUBLISHED_FIRST, ServedCircuit

Array = NDArray[np.float64]
INTERVAL = 0.05
"""Time between two collections of rows [s]."""
MOST_SAMPLES = 100
"""Most samples of one call; others wait, and those that leave the ring of the machine are omitted."""
MOST_EVENTS = 50
SEED = 0
"""Seed of the noise of the sensors, so equal runs have equal readings."""


@dataclass(frozen=True)
class WatchResult:
    """Result of a watch after one or several samples.

    Parameters
    ----------
    time : float
        Time of the last sample [s].
    verdict : str
        Conclusion as a sentence.
    kind : str
        Kind of the conclusion, a code such as `watch.healthy`.
    alarm : str
        Names of the faults of the alarm, or an empty text.
    faults : mapping
        Mapping from the name of each fault to value, standard deviation, change from the baseline, and probability.
    events : tuple of str
        Messages on the samples, and starts and ends of alarms.
    """

    time: float
    verdict: str
    kind: str
    alarm: str
    faults: dict[str, tuple[float, float, float, float]]
    events: tuple[str, ...]


@dataclass
class SampleSelection:
    """Selection of the rows of a machine that are samples of its watch.

    Rows at multiples of `step` are samples. So are, once between two of them, the row at which a held input changes and
    the row before it: the watch then knows the time of the change.

    Parameters
    ----------
    step : int
        Number of periods between two samples.
    held : array of int
        Columns of the inputs that are constant between samples.
    """

    step: int
    held: NDArray[np.int64]
    _previous: Array | None = None
    _is_selected: bool = False  # True if the previous row is a sample
    _has_change: bool = False  # True after a change since the last multiple of `step`

    def select(self, first: int, rows: Array) -> list[Array]:
        """Return the samples among rows; `first` is the number of the first row."""
        samples = []
        for number, row in enumerate(rows, first):
            previous, is_regular = self._previous, number % self.step == 0
            has_changed = previous is not None and not np.array_equal(row[self.held], previous[self.held])
            is_change = has_changed and (is_regular or not self._has_change)
            if is_change and not self._is_selected:
                assert previous is not None
                samples.append(previous)
            if is_regular or is_change:
                samples.append(row)
            self._previous, self._is_selected = row, is_regular or is_change
            self._has_change = (is_change or self._has_change) and not is_regular
        return samples


@dataclass(eq=False)
class ServedWatch:
    """Watch of a served circuit, which adds the noise of the sensors to the outputs.

    Parameters
    ----------
    path : str
        Twin file.
    twin : Twin
        Its content.
    interval : float
        Time between two samples, which is that of the recording of the baseline [s].
    """

    path: str
    twin: Twin
    interval: float
    number: int = field(default=0, init=False)  # of results
    result: WatchResult | None = field(default=None, init=False)
    events: deque[tuple[int, str]] = field(default_factory=lambda: deque(maxlen=MOST_EVENTS), init=False)
    n_events: int = field(default=0, init=False)
    omitted: int = field(default=0, init=False)  # samples
    error: Note | None = field(default=None, init=False)

    @classmethod
    def of(cls, path: str, served: ServedCircuit) -> ServedWatch:
        """Return the watch of a twin file whose sensors and inputs are outputs of a served circuit."""
        twin = read_twin_file(path)
        baseline = read_baseline(twin.baseline, twin.plan)
        units = dict(zip(served.columns, served.column_units, strict=True))
        with ErrorCollector() as errors:
            for column in (*twin.plan.channels, *twin.plan.inputs):
                if column.address not in units:
                    suggestion = NameSuggestion(column.address, units)
                    errors.add("serve.watch_address", column.address, twin=twin.name, suggestion=suggestion)
                elif (units[column.address] or "1") != (column.si_unit or "1"):
                    facts = {"unit": units[column.address], "expected": column.si_unit}
                    errors.add("serve.watch_unit", column.address, twin=twin.name, **facts)
        return cls(path, twin, baseline.duration * len(twin.plan.channels) / max(1, baseline.readings))

    async def run(self, machine: Machine) -> None:
        """Process the rows of a machine until the task is cancelled."""
        plan, column_of = self.twin.plan, {name: k for k, name in enumerate(machine.row_names)}
        columns = np.array([column_of[item.address] for item in (*plan.channels, *plan.inputs)])
        held = np.array([column_of[item.address] for item in plan.inputs if item.hold], dtype=np.int64)
        selection = SampleSelection(max(1, round(self.interval / machine.period)), held)
        noise, random = np.array([channel.noise for channel in plan.channels]), np.random.default_rng(SEED)
        time_column, n_channels, loop = column_of[PUBLISHED_FIRST], len(plan.channels), asyncio.get_running_loop()
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(1, mp_context=context, initializer=_start_watch, initargs=(self.path,))
        index, waiting = 0, list[Sample]()
        try:
            while True:
                first, rows = machine.rows(index)
                if first > index:
                    self.omitted += (first - index) // selection.step
                    self._add_event(str(Note("serve.watch_slow", rows=first - index, period=machine.period)))
                index = first + len(rows)
                for row in selection.select(first, rows):
                    values = row[columns]
                    values[:n_channels] += noise * random.standard_normal(n_channels)
                    waiting.append(Sample(float(row[time_column]), values.tolist()))
                if not waiting:
                    await asyncio.sleep(INTERVAL)
                    continue
                batch, waiting = waiting[:MOST_SAMPLES], waiting[MOST_SAMPLES:]
                self._add(await loop.run_in_executor(pool, process_samples, batch))
                await asyncio.sleep(0 if waiting else INTERVAL)
        finally:
            pool.shutdown(wait=False, cancel_futures=True)

    def _add(self, result: WatchResult) -> None:
        for text in result.events:
            self._add_event(text)
        self.result = result
        self.number += 1

    def _add_event(self, text: str) -> None:
        self.n_events += 1
        self.events.append((self.n_events, text))


_watch: Watch
"""Watch of this process, which is one of `ServedWatch`."""


def _start_watch(path: str) -> None:
    """Start the watch of a twin file in this process."""
    global _watch
    # Ctrl-C ends the program, which ends this process.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    twin = read_twin_file(path)
    _watch = watch_of_twin(twin, read_baseline(twin.baseline, twin.plan))


def process_samples(samples: list[Sample]) -> WatchResult:
    """Process samples with the watch of this process, and return its result."""
    return evaluate(_watch, samples)


def evaluate(watch: Watch, samples: list[Sample]) -> WatchResult:
    """Process samples with a watch, and return its result after the last one."""
    events: list[str] = []
    for sample in samples:
        problems: list[InputError] = []
        before = watch.alarm_text
        watch.process(sample, problems)
        events += [f"{sample.time:.1f} s: {problem}" for problem in problems]
        if watch.alarm_text != before:
            facts = {"time": sample.time, "names": watch.alarm_text, "verdict": str(watch.verdict)}
            events.append(str(Note("serve.watch_alarm" if watch.alarm_text else "serve.watch_alarm_ended", **facts)))
    faults = {
        name: (estimate.value, estimate.sigma, estimate.change, estimate.probability)
        for name, estimate in watch.faults.items()
    }
    finite = {name: tuple(v if math.isfinite(v) else 0.0 for v in numbers) for name, numbers in faults.items()}
    verdict = watch.verdict
    return WatchResult(samples[-1].time, str(verdict), verdict.kind.value, watch.alarm_text, finite, tuple(events))  # type: ignore[arg-type]
