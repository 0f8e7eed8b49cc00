"""One shard: numbers from the seed, runs, metrics, the bytes of its files. What a worker does, wherever it works."""

from __future__ import annotations

import io
import math
import pickle
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.core.errors import InputError
from poppet.engine.batch import BatchRows, run_batch
from poppet.engine.lane_kernel import kernel_of_this_machine
from poppet.engine.members import Batch, RunEnds
from poppet.engine.problem import Outcome, Problem
from poppet.ensemble.bands import Bands, edges
from poppet.ensemble.designs import design_of
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, Integers, varied_specs
from poppet.timeseries.tables.parquet import arrow

REFUSED = "ensemble.refused_run"
"""Outcome of a run whose numbers contradict each other, so that no part can be made of them."""


PILOT = 256
"""Runs that say where bands lie."""


Codes = NDArray[np.object_]


class ShardResults(NamedTuple):
    """What some runs came to."""

    numbers: Array  # (m, n_numbers) SI, absolute
    metrics: Array  # (m, n_metrics), NaN of a run that failed
    outcomes: Codes
    notes: Codes  # of runs on which the kernel stalled: what a single run would say, codes with commas between them
    is_done: NDArray[np.bool_]  # whether a run came to its end
    balance: Array  # (m,) the largest error of a balance, in parts of what is allowed
    curves: Array | None  # (m, n_curves, n_rows)


class PreparedPlan:
    """A plan with its model made ready, in one process."""

    def __init__(self, plan: EnsemblePlan) -> None:
        self.plan, self.instance = plan, plan.circuit.instance
        self.problem = plan.circuit.problem(plan.circuit.run)
        names = [name for name, _ in self.problem.kernel.model.outputs]
        self.outputs = {address: names.index(address) for address in plan.outputs}
        self.kernel = self.problem.kernel
        # Conditions look at outputs by their places, and want all of them.
        if not self.problem.stop_conditions:
            self.kernel = self.kernel.observing(list(self.outputs.values()))
            self.outputs = {address: k for k, address in enumerate(self.outputs)}
        inputs = self.instance.model.inputs
        delays = {item.delay for item in inputs if item.delay}
        # A delay moves breakpoints, and these are shared by a batch.
        self.is_apart = bool(delays & {*plan.addresses})
        self.held = tuple(
            (k, self.instance.place(item.default))
            for k, item in enumerate(inputs)
            if isinstance(item.default, str) and item.name not in self.instance.signals and not item.slope_of
        )

    @cached_property
    def units(self) -> dict[str, str]:
        """Units of numbers and metrics."""
        specs = varied_specs(self.plan.circuit)
        found = {address: specs[address].unit for address in self.plan.addresses}
        return found | {metric.name: metric.unit for metric in self.plan.metrics}

    @cached_property
    def is_tied(self) -> bool:
        """Whether other numbers follow from varied ones."""
        plan = self.plan
        if plan.table is not None:
            # Where a file repeats the numbers of the circuit, what they do shows in other rows.
            nominal = np.array([self.instance.parameters.get(address, math.nan) for address in plan.addresses])
            far = np.abs(plan.table[1] - nominal).argmax(axis=0)
            moved = {
                a: float(plan.table[1][row, k]) for k, (a, row) in enumerate(zip(plan.addresses, far, strict=True))
            }
        else:
            moved = {address: plan.quantile(address, 0.37) for address in plan.addresses}
        try:
            return bool(self.instance.tied(moved))
        except InputError:  # all of them together may be impossible
            return True

    @cached_property
    def edges(self) -> Array:
        """Edges of the bins of bands, from the first runs: the same in every process."""
        pilot = self.run(self.plan.sample(0, min(self.plan.runs, PILOT)))
        assert pilot.curves is not None
        return edges(self.plan, self.problem.grid, pilot.curves[pilot.is_done])

    def run(self, values: Array) -> ShardResults:
        """Run with these numbers, (m, n_numbers)."""
        if self.is_apart:
            return _joined([self._run_apart(row) for row in values])
        if not self.is_tied:
            places = np.array([self.instance.place(address) for address in self.plan.addresses], dtype=np.int64)
            return self._run(self.problem, places, values, values)
        followed, refused = self._followed(values)
        # A run that is refused is run with the numbers of the circuit, and what it gives is thrown away.
        found = self._run(self.problem, np.arange(followed.shape[1]), followed, values)
        return found if not refused.any() else _without(found, refused)

    def _followed(self, values: Array) -> tuple[Array, NDArray[np.bool_]]:
        """All numbers, with those that follow from the varied ones, and which runs are refused."""
        found = np.tile(self.instance.numbers(), (len(values), 1))
        refused = np.zeros(len(values), dtype=np.bool_)
        for k, row in enumerate(values):
            changed = self._changed(row)
            if changed is None:
                refused[k] = True
            else:
                found[k] = changed.numbers()
        return found, refused

    def _changed(self, row: Array) -> Instance | None:
        try:
            return self.instance.with_values(dict(zip(self.plan.addresses, row.tolist(), strict=True)))
        except InputError:
            return None

    def _run_apart(self, row: Array) -> ShardResults:
        changed = self._changed(row)
        problem = self.problem if changed is None else changed.problem(self.plan.circuit.run)
        none = np.zeros(0, dtype=np.int64)
        found = self._run(problem, none, np.empty((1, 0)), row[np.newaxis])
        return found if changed is not None else _without(found, np.ones(1, dtype=np.bool_))

    def _run(self, problem: Problem, places: Integers, values: Array, numbers: Array) -> ShardResults:
        plan, m = self.plan, len(values)
        metrics = np.full((m, len(plan.metrics)), np.nan)
        curves = np.full((m, len(plan.curves), problem.grid.size), np.nan) if plan.curves else None

        def keep(rows: BatchRows) -> Array:
            # Into arrays of this shard: every run has a row of its own.
            metrics[rows.runs] = self._metrics(rows)
            if curves is not None:
                curves[rows.runs] = rows.values[:, [self.outputs[address] for address in plan.curves]]
            return np.empty((len(rows.runs), 0))

        problem = replace(problem, kernel=self.kernel)
        found = run_batch(Batch(problem, places, values, self.held), reduce=keep, threads=1)
        is_done, codes = _endings(problem, found.ends)
        notes = np.full(m, "", dtype=object)
        for run, said in found.notes.items():
            notes[run] = ", ".join(note.code for note in said)
        errors = list(found.residuals().values())
        balance = np.max(errors, axis=0) if errors else np.zeros(m)
        metrics[~is_done] = np.nan
        return ShardResults(numbers, metrics, codes, notes, is_done, balance, curves)

    def _metrics(self, rows: BatchRows) -> Array:
        """Metrics of some runs: at once of those that have all rows of the grid, of the others one by one."""
        n = rows.time.size
        found = np.full((len(rows.runs), len(self.plan.metrics)), np.nan)
        is_whole = (rows.counts == n) & (rows.reached == rows.time[-1])
        groups = [(np.flatnonzero(is_whole), rows.time)] if is_whole.any() else []
        for k in np.flatnonzero(~is_whole & (rows.counts > 0)):
            # The last row of a run that stopped lies between the times of the grid.
            time = rows.time[: rows.counts[k]].copy()
            time[-1] = rows.reached[k]
            groups.append((np.array([k]), time))
        for runs, time in groups:
            of = rows.values if len(runs) == len(rows.runs) else rows.values[runs]
            series = {address: of[:, place, : time.size] for address, place in self.outputs.items()}
            for j, metric in enumerate(self.plan.metrics):
                found[runs, j] = metric.values(time, series)
        return found


def _endings(problem: Problem, ends: RunEnds) -> tuple[NDArray[np.bool_], Codes]:
    """Which runs came to their end, and how each of them ended, as codes."""
    # By tables, for a run takes little longer than a look at one outcome.
    every, places = tuple(Outcome), ends.counts[:, 5]
    if (places == every.index(Outcome.INTERRUPTED)).any():
        raise KeyboardInterrupt
    # The last one is that of runs that no condition stopped.
    left = np.array([*(condition.is_failure for condition in problem.stop_conditions), False])[ends.stops]
    codes = np.array([outcome.value for outcome in every], dtype=object)[places]
    codes[left] = "run.left_domain"
    return np.array([outcome.is_success for outcome in every])[places] & ~left, codes


def _without(found: ShardResults, refused: NDArray[np.bool_]) -> ShardResults:
    metrics, is_done = found.metrics.copy(), found.is_done & ~refused
    metrics[refused] = np.nan
    codes = found.outcomes.copy()
    codes[refused] = REFUSED
    return found._replace(metrics=metrics, is_done=is_done, outcomes=codes)


def _joined(found: list[ShardResults]) -> ShardResults:
    *arrays, curves = zip(*found, strict=True)
    together = None if curves[0] is None else np.concatenate(curves)
    return ShardResults._make([*(np.concatenate(each) for each in arrays), together])


# --- Files ---


def shard_files(plan: EnsemblePlan, ready: PreparedPlan, kind: str, number: int) -> dict[str, bytes]:
    """Files of one shard of the runs of a kind, by their place in the dataset; the last one says that it is done."""
    design = design_of(plan, kind)
    first = number * design.shard
    last = min(first + design.shard, design.size)
    found = ready.run(design.values(first, last))
    name, files = f"part-{number:05d}.parquet", {}
    if kind == "runs" and found.curves is not None:
        if plan.keep == "bands":
            bands = Bands.of(plan, ready.problem.grid, ready.edges, found.curves[found.is_done])
            files[f"bands/{name}"] = _parquet(bands.columns(), {})
        else:
            columns: dict[str, Any] = {"run": np.arange(first, last)}
            columns |= {address: list(found.curves[:, k]) for k, address in enumerate(plan.curves)}
            files[f"curves/{name}"] = _parquet(columns, {})
    columns = {"run": np.arange(first, last)}
    columns |= {address: found.numbers[:, k] for k, address in enumerate(plan.addresses)}
    columns |= {metric.name: found.metrics[:, k] for k, metric in enumerate(plan.metrics)}
    columns |= {"done": found.is_done, "outcome": found.outcomes, "notes": found.notes, "balance": found.balance}
    files[f"{kind}/{name}"] = _parquet(columns, ready.units)
    return files


_REPEATED = ["outcome", "notes", "curve", "counts.list.element"]
"""Columns with few different values."""


def _parquet(columns: Mapping[str, Any], units: Mapping[str, str]) -> bytes:
    pa = arrow()
    arrays = [pa.array(values) for values in columns.values()]
    fields = [
        pa.field(name, array.type, metadata={"unit": units[name]} if name in units else None)
        for name, array in zip(columns, arrays, strict=True)
    ]
    stream = io.BytesIO()
    pa.parquet.write_table(
        pa.Table.from_arrays(arrays, schema=pa.schema(fields)), stream, compression="zstd",
        # Draws do not repeat, and their extremes tell no shard from another: looking for that takes half the time.
        use_dictionary=_REPEATED, write_statistics=["run"],
    )  # fmt: skip
    return stream.getvalue()


# --- In other threads and processes ---

_READY: dict[str, PreparedPlan] = {}


def work(key: str, pickled: bytes, kind: str, number: int, kernel: str) -> dict[str, bytes]:
    """One shard in whatever process this is; the plan is unpacked once for each of them.

    The dataset's `kernel` has to be that of this machine, or the last digits would tell which worker made a shard.
    """
    if kernel != (own := kernel_of_this_machine()):
        raise InputError("ensemble.other_kernel", kernel=kernel, own=own)
    if key not in _READY:
        _READY.clear()
        _READY[key] = PreparedPlan(pickle.loads(pickled))
    ready = _READY[key]
    return shard_files(ready.plan, ready, kind, number)
