"""Result of an ensemble, and functions that run it."""

from __future__ import annotations

import shutil
import tempfile
import warnings
import weakref
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.notebook import HtmlMixin
from poppet.ensemble.bands import Bands
from poppet.ensemble.dataset import Dataset
from poppet.ensemble.ensemble_plan import ALL, EnsemblePlan, read_plan
from poppet.ensemble.executors import run_missing
from poppet.ensemble.statistics import SobolIndex, Summary, TornadoRange, Yield, sobol_indices, summary_of, wilson
from poppet.ensemble.worst_cases import WorstCase, save_case, worst_of

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

MAX_EXACT_RUNS = 2**20
"""Maximum number of runs from which quantiles are computed, to limit the memory."""


@dataclass(frozen=True, eq=False)
class Ensemble(HtmlMixin):
    """Runs of a circuit with uncertain parameters.

    Parameters
    ----------
    plan : EnsemblePlan
        Settings of the ensemble.
    dataset : Dataset
        Stored results.
    is_whole : bool
        False if Ctrl-C stopped the ensemble.
    """

    plan: EnsemblePlan
    dataset: Dataset
    is_whole: bool = True

    @property
    def folder(self) -> Path:
        """Folder of the dataset."""
        return self.dataset.folder

    def to_pandas(self) -> Any:
        """Return parameters and metrics of all runs.

        Returns
        -------
        pandas.DataFrame
            One row for each run. The Parquet files and the manifest contain the units.
        """
        from poppet.core.errors import needed

        with needed("pandas", "A data frame", "data"):
            import pandas
        return pandas.DataFrame(self.dataset.columns("runs"))

    @property
    def done(self) -> int:
        """Number of stored runs."""
        return sum(len(shard["run"]) for shard in self.dataset.shards("runs", ["run"]))

    def outcomes(self) -> dict[str, int]:
        """Return the number of runs for each termination reason, by the code of the reason."""
        return self._counted("outcome")

    def noted(self) -> dict[str, int]:
        """Return the number of runs in which the kernel stalled, by the codes of the notes."""
        return {codes: count for codes, count in self._counted("notes").items() if codes}

    def remarks(self) -> tuple[Note, ...]:
        """Return notes on runs that failed or stalled, and on completed runs without a value of a metric.

        Notes on the plan come first.
        """
        runs, fine = self.done, ("run.done", "run.stopped")
        failed = [(code, count) for code, count in self.outcomes().items() if code not in fine]
        without = self._without_value()
        return (
            *self.plan.notes,
            *(Note("ensemble.failed", count=count, runs=runs, outcome=code) for code, count in failed),
            *(Note("ensemble.undefined", count=n, runs=runs, metric=name) for name, n in without.items() if n),
            *(Note("ensemble.noted", count=count, runs=runs, said=code) for code, count in self.noted().items()),
        )

    def _without_value(self) -> dict[str, int]:
        """Return, for each metric, the number of completed runs that have no value of the metric."""
        counts = {metric.name: 0 for metric in self.plan.metrics}
        for shard in self.dataset.shards("runs", ["done", *counts]):
            for name in counts:
                counts[name] += int(np.count_nonzero(shard["done"] & np.isnan(shard[name])))
        return counts

    def _counted(self, column: str) -> dict[str, int]:
        counts: dict[str, int] = {}
        for shard in self.dataset.shards("runs", [column]):
            for text, count in zip(*np.unique(shard[column].astype(str), return_counts=True), strict=True):
                counts[str(text)] = counts.get(str(text), 0) + int(count)
        return counts

    def yields(self) -> list[Yield]:
        """Return the yield of each requirement: the fraction of runs that meet it.

        If there are several requirements, the last yield is that of all together.

        Returns
        -------
        list of Yield
            With 95 % confidence intervals. A failed run meets no requirement.
        """
        requirements = self.plan.requirements
        n_good, runs = np.zeros(len(requirements) + 1, dtype=np.int64), 0
        for shard in self.dataset.shards("runs", ["done", *(requirement.metric for requirement in requirements)]):
            is_met = [r.met(shard[r.metric]) & shard["done"].astype(bool) for r in requirements]
            runs += len(shard["done"])
            counts = [np.count_nonzero(mask) for mask in is_met]
            n_good += np.array([*counts, np.count_nonzero(np.all(is_met, axis=0)) if is_met else 0])
        names = [(r.name, r.text) for r in requirements] + ([(ALL, "")] if len(requirements) > 1 else [])
        # The last count is that of all together.
        counted = zip(names, n_good.tolist(), strict=len(names) > len(requirements))
        return [Yield(*name, k, runs, *wilson(k, runs)) for name, k in counted]

    def summaries(self) -> list[Summary]:
        """Return statistics of each metric: moments, extremes and quantiles.

        They also contain the numbers of runs with a finite, an infinite and no value.
        """
        return [summary_of(self.dataset, metric, MAX_EXACT_RUNS) for metric in self.plan.metrics]

    def bands(self) -> Bands | None:
        """Return histograms of outputs, from which quantiles versus time are computed.

        The result is None unless `keep` is `bands`.
        """
        total: Bands | None = None
        for shard in self.dataset.shards("bands"):
            bands = Bands.read(shard)
            total = bands if total is None else total + bands
        return total

    def tornado(self) -> dict[str, list[TornadoRange]]:
        """Return the effect of each parameter alone on each metric, the largest effect first.

        Returns
        -------
        dict
            Metric to its value at the 5 and 95 % quantile of each parameter. All others have their median.
        """
        rows = self.dataset.columns("tornado")
        effects = {}
        for metric in self.plan.metrics if rows else ():
            values = rows[metric.name]
            ranges = [
                TornadoRange(address, *(float(v) for v in (values[0], values[1 + 2 * k], values[2 + 2 * k])))
                for k, address in enumerate(self.plan.addresses)
            ]
            effects[metric.name] = sorted(ranges, key=lambda effect: -effect.size)
        return effects

    def indices(self) -> dict[str, list[SobolIndex]]:
        """Return the Sobol indices of each metric; the result is empty if the plan has no runs for them.

        Returns
        -------
        dict
            Metric to first-order and total indices of every factor. All parameters of a fit are one factor.
        """
        rows, factors = self.dataset.columns("indices"), tuple(self.plan.factors)
        if not rows:
            return {}
        shape = len(factors) + 2, -1
        return {m.name: sobol_indices(rows[m.name].reshape(shape), factors) for m in self.plan.metrics}

    def worst(self, count: int = 3) -> dict[str, list[WorstCase]]:
        """Return the worst runs of each requirement.

        Parameters
        ----------
        count : int, optional
            Number of runs per requirement.

        Returns
        -------
        dict
            Requirement to its runs with the smallest margins; failed runs are first.
        """
        return {r.name: worst_of(self.dataset, self.plan, r, count) for r in self.plan.requirements}

    def save_worst(self, folder: str | Path, count: int = 3) -> list[Path]:
        """Write the worst runs as circuit files.

        Parameters
        ----------
        folder : str or Path
            Folder for the files; it is created if necessary.
        count : int, optional
            Number of runs per requirement.

        Returns
        -------
        list of Path
            `REQUIREMENT-1.toml` and so on.

        Raises
        ------
        InputError
            If there are no requirements, or the circuit differs from its file in more than its parameters.
        """
        target = Path(folder)
        if not self.plan.requirements:
            raise InputError("ensemble.no_requirements")
        target.mkdir(parents=True, exist_ok=True)
        cases = [(case, k) for worst in self.worst(count).values() for k, case in enumerate(worst, 1)]
        return [save_case(self.plan.circuit, case, target / f"{case.requirement}-{k}.toml") for case, k in cases]


def run_ensemble(
    circuit: BaseCircuit,
    output: str | Path | None = None,
    *,
    executor: Any = "threads",
    workers: int | None = None,
    progress: Callable[[int, int, str], Any] | None = None,
    requirements: Mapping[str, str] | None = None,
    **fields: Any,
) -> Ensemble:
    """Run an ensemble: see `Circuit.ensemble`."""
    plan = plan_of(circuit, requirements=requirements, **fields)
    if output is not None:
        return run_plan(plan, Path(output), executor, workers, progress)
    folder = tempfile.mkdtemp(prefix="poppet-")
    try:
        ensemble = run_plan(plan, Path(folder), executor, workers, progress)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    # Delete the folder when the dataset is no longer used.
    weakref.finalize(ensemble.dataset, shutil.rmtree, folder, ignore_errors=True)
    return ensemble


def plan_of(circuit: BaseCircuit, *, requirements: Mapping[str, str] | None = None, **fields: Any) -> EnsemblePlan:
    """Return the ensemble plan of a circuit from its tables.

    The keyword arguments `fields` replace fields of the table `ensemble`.
    """
    tables, folder = circuit.origin
    table = tables.get("ensemble", {})
    fields = with_parameters(fields)
    if isinstance(table, Mapping):
        # The file of an overridden sampling method is ignored.
        omitted = {"file"} if fields.get("sampling", "file") != "file" else set()
        omitted |= {"numbers", "parameters"} if "parameters" in fields else set()
        table = {key: value for key, value in table.items() if key not in omitted} | fields
    return read_plan(circuit, table, tables.get("requirements", {}) if requirements is None else requirements, folder)


def with_parameters(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keyword arguments with the old name `numbers` replaced by `parameters`."""
    renamed = dict(fields)
    if "numbers" in fields:
        if "parameters" in fields:
            raise InputError("ensemble.numbers_and_parameters", "ensemble.numbers")
        warnings.warn("The argument numbers is now called parameters.", DeprecationWarning, stacklevel=4)
        renamed["parameters"] = renamed.pop("numbers")
    return renamed


def run_plan(
    plan: EnsemblePlan,
    folder: Path,
    executor: Any = "threads",
    workers: int | None = None,
    progress: Callable[[int, int, str], Any] | None = None,
) -> Ensemble:
    """Run all missing shards of a plan, and store them in a folder."""
    dataset = Dataset.opened(folder, plan)
    is_whole = run_missing(plan, dataset, executor, workers, progress)
    return Ensemble(plan, dataset.sealed() if is_whole else dataset, is_whole)
