"""Execution of one shard (group of runs): parameter values, runs, metrics and files."""

from __future__ import annotations

import io
import math
import pickle
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.core.errors import InputError
from poppet.engine.batch import BatchRows, run_batch
from poppet.engine.lane_kernel import kernel_of_this_machine
from poppet.engine.members import Batch
from poppet.engine.problem import Outcome, Problem
from poppet.ensemble.bands import Bands, band_edges
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, Integers, varied_specs
from poppet.timeseries.tables.reading import arrow

REFUSED = "ensemble.refused_run"
"""Code of the outcome of a run whose parameter values contradict each other."""
PILOT = 256
"""Number of first runs that determine the limits of the histograms for bands."""
Codes = NDArray[np.object_]


class ShardResults(NamedTuple):
    """Results of all runs in one shard, a group of runs that is computed and stored together."""

    numbers: Array  # (m, n_numbers) SI, absolute
    metrics: Array  # (m, n_metrics), NaN of a run that failed
    outcomes: Codes
    notes: Codes  # codes of the notes of runs in which the kernel stalled, separated by commas
    is_done: NDArray[np.bool_]  # True for a completed run
    balance: Array  # (m,) maximum error of a balance relative to its tolerance
    curves: Array | None  # (m, n_curves, n_rows)


class PreparedPlan:
    """Settings of an ensemble with the compiled model of the circuit.

    Each process prepares them only once.
    """

    def __init__(self, plan: EnsemblePlan) -> None:
        self.plan, self.instance = plan, plan.circuit.instance
        self.problem = plan.circuit.problem(plan.circuit.run)
        names = [name for name, _ in self.problem.kernel.model.outputs]
        self.outputs = {address: names.index(address) for address in plan.outputs}
        self.kernel = self.problem.kernel
        # Stop conditions use the indices of all outputs.
        if not self.problem.stop_conditions:
            self.kernel = self.kernel.observing(list(self.outputs.values()))
            self.outputs = {address: k for k, address in enumerate(self.outputs)}
        inputs = self.instance.model.inputs
        self.held = tuple(
            (k, self.instance.place(item.default))
            for k, item in enumerate(inputs)
            if isinstance(item.default, str) and item.name not in self.instance.signals and not item.slope_of
        )

    @cached_property
    def units(self) -> dict[str, str]:
        """Mapping from each uncertain parameter and each metric to its unit."""
        specs = varied_specs(self.plan.circuit)
        units = {address: specs[address].unit for address in self.plan.addresses}
        return units | {metric.name: metric.unit for metric in self.plan.metrics}

    @cached_property
    def is_apart(self) -> bool:
        """True if the uncertain parameters change a delay: it shifts breakpoints, which all runs of a batch share."""
        delays = {item.delay for item in self.instance.model.inputs if item.delay}
        if delays & {*self.plan.addresses} or not self.has_dependent_parameters:
            return bool(delays & {*self.plan.addresses})
        try:
            parameters = self.instance.with_values(self.trial_values).parameters
        except InputError:  # the combination can be invalid
            return bool(delays)
        return any(parameters[address] != self.instance.parameters[address] for address in delays)

    @cached_property
    def trial_values(self) -> dict[str, float]:
        """Values of all uncertain parameters, as different from those of the circuit as possible."""
        plan = self.plan
        if plan.table is not None:
            # Use the rows that differ most from the circuit.
            nominal = np.array([self.instance.parameters.get(address, math.nan) for address in plan.addresses])
            rows = np.abs(plan.table[1] - nominal).argmax(axis=0)
            extremes = plan.table[1][rows, np.arange(len(rows))]
            return dict(zip(plan.addresses, extremes.tolist(), strict=True))
        return {address: plan.quantile(address, 0.37) for address in plan.addresses}

    @cached_property
    def has_dependent_parameters(self) -> bool:
        """True if other parameters of the circuit are computed from the uncertain parameters."""
        try:
            return bool(self.instance.tied(self.trial_values))
        except InputError:  # the combination can be invalid
            return True

    @cached_property
    def edges(self) -> Array:
        """Lower and upper limits of the histograms of outputs, (n_curves, n_times, 2).

        They follow from the first runs, and are equal in every process.
        """
        pilot = self.run(self.plan.sample(0, min(self.plan.runs, PILOT)))
        assert pilot.curves is not None
        return band_edges(self.plan, self.problem.grid, pilot.curves[pilot.is_done])

    def run(
        self, values: Array, *, threads: int | None = 1, progress: Callable[[int], Any] | None = None
    ) -> ShardResults:
        """Run the circuit once for each row of parameter values, (m, n_parameters).

        `threads` is the number of threads, None for one per processor, and `progress` a function that is called with
        the number of completed runs.
        """
        if self.is_apart:
            none = np.zeros(0, dtype=np.int64)
            runs: list[ShardResults] = []
            for row in values:
                changed = self._changed(row)
                problem = self.problem if changed is None else changed.problem(self.plan.circuit.run)
                results = self._run(problem, none, np.empty((1, 0)), row[np.newaxis])
                if progress is not None:
                    progress(len(runs) + 1)
                runs.append(_mark_refused(results, np.ones(1, dtype=np.bool_)) if changed is None else results)
            *arrays, curves = zip(*runs, strict=True)
            all_curves = None if curves[0] is None else np.concatenate(curves)
            return ShardResults._make([*(np.concatenate(parts) for parts in arrays), all_curves])
        if not self.has_dependent_parameters:
            indices = np.array([self.instance.place(address) for address in self.plan.addresses], dtype=np.int64)
            return self._run(self.problem, indices, values, values, threads, progress)
        # All parameters of each run, including the dependent ones. A rejected run uses those of the circuit, and its
        # results are discarded.
        parameters = np.tile(self.instance.numbers(), (len(values), 1))
        refused = np.zeros(len(values), dtype=np.bool_)
        for k, row in enumerate(values):
            changed = self._changed(row)
            if changed is None:
                refused[k] = True
            else:
                parameters[k] = changed.numbers()
        results = self._run(self.problem, np.arange(parameters.shape[1]), parameters, values, threads, progress)
        return results if not refused.any() else _mark_refused(results, refused)

    def run_parameters(self, parameters: Array, progress: Callable[[int], Any] | None = None) -> ShardResults:
        """Run the circuit once for each row of all its parameters, (m, n), on all processors."""
        return self._run(self.problem, np.arange(parameters.shape[1]), parameters, parameters, None, progress)

    def _changed(self, row: Array) -> Instance | None:
        try:
            return self.instance.with_values(dict(zip(self.plan.addresses, row.tolist(), strict=True)))
        except InputError:
            return None

    def _run(
        self, problem: Problem, indices: Integers, values: Array, numbers: Array, threads: int | None = 1,
        progress: Callable[[int], Any] | None = None,
    ) -> ShardResults:  # fmt: skip
        plan, m = self.plan, len(values)
        metrics = np.full((m, len(plan.metrics)), np.nan)
        curves = np.full((m, len(plan.curves), problem.grid.size), np.nan) if plan.curves else None

        def keep(rows: BatchRows) -> Array:
            metrics[rows.runs] = self._metrics(rows)
            if curves is not None:
                curves[rows.runs] = rows.values[:, [self.outputs[address] for address in plan.curves]]
            return np.empty((len(rows.runs), 0))

        problem = replace(problem, kernel=self.kernel)
        batch = run_batch(Batch(problem, indices, values, self.held), reduce=keep, threads=threads, progress=progress)
        # Look-up tables: a loop would take almost as long as the runs.
        outcomes, indices_of_outcomes = tuple(Outcome), batch.ends.counts[:, 5]
        if (indices_of_outcomes == outcomes.index(Outcome.INTERRUPTED)).any():
            raise KeyboardInterrupt
        # The last entry is for runs without a stop condition.
        failures = np.array([*(condition.is_failure for condition in problem.stop_conditions), False])
        has_left_domain = failures[batch.ends.stops]
        codes = np.array([outcome.value for outcome in outcomes], dtype=object)[indices_of_outcomes]
        codes[has_left_domain] = "run.left_domain"
        is_done = np.array([outcome.is_success for outcome in outcomes])[indices_of_outcomes] & ~has_left_domain
        notes = np.full(m, "", dtype=object)
        for run, notes_of_run in batch.notes.items():
            notes[run] = ", ".join(note.code for note in notes_of_run)
        errors = list(batch.residuals().values())
        balance = np.max(errors, axis=0) if errors else np.zeros(m)
        metrics[~is_done] = np.nan
        return ShardResults(numbers, metrics, codes, notes, is_done, balance, curves)

    def _metrics(self, rows: BatchRows) -> Array:
        """Return the metrics of all runs of a batch, (n_runs, n_metrics).

        Complete runs are evaluated together. Runs that ended earlier have different times, so they are evaluated one by
        one.
        """
        n = rows.time.size
        metrics = np.full((len(rows.runs), len(self.plan.metrics)), np.nan)
        is_whole = (rows.counts == n) & (rows.reached == rows.time[-1])
        groups = [(np.flatnonzero(is_whole), rows.time)] if is_whole.any() else []
        for k in np.flatnonzero(~is_whole & (rows.counts > 0)):
            # The last row of a stopped run is between the times of the grid.
            time = rows.time[: rows.counts[k]].copy()
            time[-1] = rows.reached[k]
            groups.append((np.array([k]), time))
        for runs, time in groups:
            values = rows.values if len(runs) == len(rows.runs) else rows.values[runs]
            series = {address: values[:, index, : time.size] for address, index in self.outputs.items()}
            for j, metric in enumerate(self.plan.metrics):
                metrics[runs, j] = metric.values(time, series)
        return metrics


def _mark_refused(results: ShardResults, refused: NDArray[np.bool_]) -> ShardResults:
    metrics, is_done = results.metrics.copy(), results.is_done & ~refused
    metrics[refused] = np.nan
    codes = results.outcomes.copy()
    codes[refused] = REFUSED
    return results._replace(metrics=metrics, is_done=is_done, outcomes=codes)


# --- Files ---


def shard_files(plan: EnsemblePlan, ready: PreparedPlan, kind: str, number: int) -> dict[str, bytes]:
    """Run one group of runs of an ensemble, and return its result files by relative path.

    `kind` is the kind of runs, and `number` the index of the group. `ready` contains the compiled model. The last file
    marks the group as complete.
    """
    size, shard_size = plan.counts(kind)
    first = number * shard_size
    last = min(first + shard_size, size)
    results = ready.run(plan.sample(first, last, kind))
    name, files = f"part-{number:05d}.parquet", {}
    if kind == "runs" and results.curves is not None:
        if plan.keep == "bands":
            bands = Bands.of(plan, ready.problem.grid, ready.edges, results.curves[results.is_done])
            files[f"bands/{name}"] = _parquet(bands.columns(), {})
        else:
            columns: dict[str, Any] = {"run": np.arange(first, last)}
            columns |= {address: list(results.curves[:, k]) for k, address in enumerate(plan.curves)}
            files[f"curves/{name}"] = _parquet(columns, {})
    columns = {"run": np.arange(first, last)}
    columns |= {address: results.numbers[:, k] for k, address in enumerate(plan.addresses)}
    columns |= {metric.name: results.metrics[:, k] for k, metric in enumerate(plan.metrics)}
    columns |= {
        "done": results.is_done,
        "outcome": results.outcomes,
        "notes": results.notes,
        "balance": results.balance,
    }
    files[f"{kind}/{name}"] = _parquet(columns, ready.units)
    return files


_CATEGORICAL = ["outcome", "notes", "curve", "counts.list.element"]
"""Columns with few distinct values."""


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
        # Dictionaries and statistics of random samples have no benefit and take half of the time.
        use_dictionary=_CATEGORICAL, write_statistics=["run"],
    )  # fmt: skip
    return stream.getvalue()


# --- In other threads and processes ---

_PLANS: dict[str, PreparedPlan] = {}


def run_shard(key: str, pickled: bytes, kind: str, number: int, kernel: str) -> dict[str, bytes]:
    """Run one group of runs of an ensemble in a worker thread or process, and return its result files.

    `pickled` is the pickled ensemble plan. It is unpickled only once for each `key`. `kind` is the kind of runs, and
    `number` the index of the group. `kernel` identifies the compiled code of the dataset. An error is raised if this
    machine compiles other code, because the last digits of its results would differ.
    """
    if kernel != (local_kernel := kernel_of_this_machine()):
        raise InputError("ensemble.other_kernel", kernel=kernel, own=local_kernel)
    if key not in _PLANS:
        _PLANS.clear()
        _PLANS[key] = PreparedPlan(pickle.loads(pickled))
    ready = _PLANS[key]
    return shard_files(ready.plan, ready, kind, number)
