"""An ensemble: its plan, its dataset, and what they tell."""

from __future__ import annotations

import shutil
import tempfile
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
from poppet.ensemble.influence import SobolIndex, sobol_indices
from poppet.ensemble.statistics import Summary, TornadoRange, Yield, summary_of, wilson
from poppet.ensemble.worst_cases import WorstCase, save_case, worst_of

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

MOST_EXACT = 2**20
"""Runs, from the first on, of which quantiles are taken: memory must not grow with the runs."""


@dataclass(frozen=True, eq=False)
class Ensemble(HtmlMixin):
    """Many runs of a circuit with uncertain numbers.

    Parameters
    ----------
    plan : Plan
        What was run.
    dataset : Dataset
        Where it lies.
    is_whole : bool
        False where Ctrl-C has ended it before its time.
    """

    plan: EnsemblePlan
    dataset: Dataset
    is_whole: bool = True

    @property
    def folder(self) -> Path:
        """Folder of the dataset."""
        return self.dataset.folder

    def to_pandas(self) -> Any:
        """Numbers and metrics of all runs.

        Returns
        -------
        pandas.DataFrame
            One row for each run; units stand in the Parquet files and in the manifest.
        """
        from poppet.core.errors import needed

        with needed("pandas", "A data frame", "data"):
            import pandas
        return pandas.DataFrame(self.dataset.columns("runs"))

    @property
    def done(self) -> int:
        """Runs that are there."""
        return sum(len(shard["run"]) for shard in self.dataset.shards("runs", ["run"]))

    def outcomes(self) -> dict[str, int]:
        """How many runs ended in which way, by code."""
        return self._counted("outcome")

    def noted(self) -> dict[str, int]:
        """How many runs the kernel did not make alone, by the codes of what was said about them."""
        return {codes: count for codes, count in self._counted("notes").items() if codes}

    def remarks(self) -> tuple[Note, ...]:
        """What a reader has to know: how many runs failed, have no value of a metric, or stalled."""
        runs, fine = self.done, ("run.done", "run.stopped")
        failed = [(code, count) for code, count in self.outcomes().items() if code not in fine]
        without = self._without_value()
        return (
            *(Note("ensemble.failed", count=count, runs=runs, outcome=code) for code, count in failed),
            *(Note("ensemble.undefined", count=n, runs=runs, metric=name) for name, n in without.items() if n),
            *(Note("ensemble.noted", count=count, runs=runs, said=code) for code, count in self.noted().items()),
        )

    def _without_value(self) -> dict[str, int]:
        """Of each metric how many runs came to their end and have none."""
        found = {metric.name: 0 for metric in self.plan.metrics}
        for shard in self.dataset.shards("runs", ["done", *found]):
            for name in found:
                found[name] += int(np.count_nonzero(shard["done"] & np.isnan(shard[name])))
        return found

    def _counted(self, column: str) -> dict[str, int]:
        found: dict[str, int] = {}
        for shard in self.dataset.shards("runs", [column]):
            for text, count in zip(*np.unique(shard[column].astype(str), return_counts=True), strict=True):
                found[str(text)] = found.get(str(text), 0) + int(count)
        return found

    def yields(self) -> list[Yield]:
        """Share of good runs, for each requirement and, where there are several, for all together.

        Returns
        -------
        list of Yield
            With intervals of 95 %; a run that failed meets no requirement.
        """
        wanted = self.plan.requirements
        good, runs = np.zeros(len(wanted) + 1, dtype=np.int64), 0
        for shard in self.dataset.shards("runs", ["done", *(each.metric for each in wanted)]):
            met = [each.met(shard[each.metric]) & shard["done"].astype(bool) for each in wanted]
            runs += len(shard["done"])
            counts = [np.count_nonzero(each) for each in met]
            good += np.array([*counts, np.count_nonzero(np.all(met, axis=0)) if met else 0])
        names = [(each.name, each.text) for each in wanted] + ([(ALL, "")] if len(wanted) > 1 else [])
        # The last count is that of all together.
        counted = zip(names, good.tolist(), strict=len(names) > len(wanted))
        return [Yield(*name, k, runs, *wilson(k, runs)) for name, k in counted]

    def summaries(self) -> list[Summary]:
        """Of each metric its moments, extremes and quantiles, with those runs counted that have no finite value."""
        return [summary_of(self.dataset, metric, MOST_EXACT) for metric in self.plan.metrics]

    def bands(self) -> Bands | None:
        """Quantiles of curves over time; None where `keep` is not `bands`."""
        found: Bands | None = None
        for shard in self.dataset.shards("bands"):
            own = Bands.read(shard)
            found = own if found is None else found + own
        return found

    def tornado(self) -> dict[str, list[TornadoRange]]:
        """Of each metric what each number does to it alone, the strongest first.

        Returns
        -------
        dict
            Name of a metric to its value at the 5 and 95 % quantile of each number, while all others have their median.
        """
        rows = self.dataset.columns("tornado")
        found = {}
        for metric in self.plan.metrics if rows else ():
            values = rows[metric.name]
            ranges = [
                TornadoRange(address, *(float(v) for v in (values[0], values[1 + 2 * k], values[2 + 2 * k])))
                for k, address in enumerate(self.plan.addresses)
            ]
            found[metric.name] = sorted(ranges, key=lambda each: -each.size)
        return found

    def indices(self) -> dict[str, list[SobolIndex]]:
        """Sobol indices of each metric; empty where the plan has no runs for them.

        Returns
        -------
        dict
            Name of a metric to first and total indices of every factor. Numbers of a fit are one factor together.
        """
        rows, factors = self.dataset.columns("indices"), tuple(self.plan.factors)
        if not rows:
            return {}
        shape = len(factors) + 2, -1
        return {m.name: sobol_indices(rows[m.name].reshape(shape), factors) for m in self.plan.metrics}

    def worst(self, count: int = 3) -> dict[str, list[WorstCase]]:
        """The worst runs of each requirement.

        Parameters
        ----------
        count : int, optional
            How many of each.

        Returns
        -------
        dict
            Name of a requirement to its runs with the smallest margins, failed ones first.
        """
        return {own.name: worst_of(self.dataset, self.plan, own, count) for own in self.plan.requirements}

    def save_worst(self, folder: str | Path, count: int = 3) -> list[Path]:
        """Write the worst runs as circuit files.

        Parameters
        ----------
        folder : str or Path
            Where to; made where it is not there.
        count : int, optional
            How many of each requirement.

        Returns
        -------
        list of Path
            `REQUIREMENT-1.toml` and so on.

        Raises
        ------
        InputError
            If there are no requirements, or the circuit is not that of a file with other numbers.
        """
        target = Path(folder)
        if not self.plan.requirements:
            raise InputError("ensemble.no_requirements")
        target.mkdir(parents=True, exist_ok=True)
        cases = [(case, k) for found in self.worst(count).values() for k, case in enumerate(found, 1)]
        return [save_case(self.plan.circuit, case, target / f"{case.requirement}-{k}.toml") for case, k in cases]


def run_ensemble(
    circuit: Circuit,
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
        found = run_plan(plan, Path(folder), executor, workers, progress)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    # It goes with the dataset, which whoever reads holds.
    weakref.finalize(found.dataset, shutil.rmtree, folder, ignore_errors=True)
    return found


def plan_of(circuit: Circuit, *, requirements: Mapping[str, str] | None = None, **fields: Any) -> EnsemblePlan:
    """The plan of a circuit's own tables and of fields that go before them."""
    tables, folder = circuit.origin
    own = tables.get("ensemble", {})
    if isinstance(own, Mapping):
        # The table of a way that is not gone is nothing to complain about.
        is_other = fields.get("sampling", "file") != "file"
        own = {key: value for key, value in own.items() if not (is_other and key == "file")} | fields
    return read_plan(circuit, own, tables.get("requirements", {}) if requirements is None else requirements, folder)


def run_plan(
    plan: EnsemblePlan,
    folder: Path,
    executor: Any = "threads",
    workers: int | None = None,
    progress: Callable[[int, int, str], Any] | None = None,
) -> Ensemble:
    """Run what is missing of a plan in a folder."""
    dataset = Dataset.opened(folder, plan)
    is_whole = run_missing(plan, dataset, executor, workers, progress)
    return Ensemble(plan, dataset.sealed() if is_whole else dataset, is_whole)
