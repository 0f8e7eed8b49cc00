"""Result of an ensemble, and functions that run it."""

from __future__ import annotations

import os
import shutil
import tempfile
import warnings
import weakref
from collections.abc import Callable, Mapping
from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import ABOVE, loads
from poppet.core.codes import Note
from poppet.core.errors import InputError, needed
from poppet.core.files import make_folder, write_whole
from poppet.core.notebook import HtmlMixin
from poppet.core.toml import toml_text
from poppet.ensemble.bands import Bands
from poppet.ensemble.dataset import Dataset, fingerprint
from poppet.ensemble.ensemble_plan import ALL, EnsemblePlan, read_plan, varied_specs
from poppet.ensemble.executors import run_missing
from poppet.ensemble.statistics import SobolIndex, Summary, TornadoRange, Yield, sobol_indices, summary_of, wilson
from poppet.parts.steps import SequenceProgram

if TYPE_CHECKING:
    import pandas

MAX_EXACT_RUNS = 2**20
"""Maximum number of runs from which quantiles are computed, to limit the memory."""


_PATHS = ("path", "characteristic")
"""Fields that can contain the path of a file."""


@dataclass(frozen=True)
class WorstCase:
    """Run that violates a requirement by one of the largest amounts."""

    requirement: str
    run: int
    value: float  # of the metric, in its unit; NaN of a run that failed
    margin: float  # distance to the bound, positive if met; -inf for a failed run
    outcome: str
    numbers: Mapping[str, float]  # SI, absolute


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

    def to_pandas(self) -> pandas.DataFrame:
        """Return parameters and metrics of all runs as a data frame.

        Returns
        -------
        pandas.DataFrame
            One row for each run. The Parquet files and the manifest contain the units.
        """
        with needed("pandas", "A data frame", "data"):
            import pandas
        return pandas.DataFrame(self.dataset.columns("runs"))

    @property
    def done(self) -> int:
        """Number of stored runs."""
        return sum(len(shard["run"]) for shard in self.dataset.shards("runs", ["run"]))

    def outcomes(self) -> dict[str, int]:
        """Return the number of runs by termination reason.

        The keys are the message codes of the reasons.
        """
        return self._counted("outcome")

    def noted(self) -> dict[str, int]:
        """Return the number of runs with a note that the solver stalled.

        The keys are the codes of these notes, separated by commas.
        """
        return {codes: count for codes, count in self._counted("notes").items() if codes}

    def remarks(self) -> tuple[Note, ...]:
        """Return notes on the ensemble tables, on failed runs and on missing metric values.

        They include the executed Python functions, runs in which the solver stalled, and completed runs without a value
        of a metric.
        """
        runs, fine = self.done, ("run.done", "run.stopped")
        failed = [(code, count) for code, count in self.outcomes().items() if code not in fine]
        # The number of completed runs that have no value of a metric.
        without = {metric.name: 0 for metric in self.plan.metrics}
        for shard in self.dataset.shards("runs", ["done", *without]):
            for name in without:
                without[name] += int(np.count_nonzero(shard["done"] & np.isnan(shard[name])))
        functions = self.plan.python_functions
        return (
            *self.plan.notes,
            *([Note("ensemble.executed", functions=functions)] if functions else ()),
            *(Note("ensemble.failed", count=count, runs=runs, outcome=code) for code, count in failed),
            *(Note("ensemble.undefined", count=n, runs=runs, metric=name) for name, n in without.items() if n),
            *(Note("ensemble.noted", count=count, runs=runs, said=code) for code, count in self.noted().items()),
        )

    def _counted(self, column: str) -> dict[str, int]:
        counts: dict[str, int] = {}
        for shard in self.dataset.shards("runs", [column]):
            for text, count in zip(*np.unique(shard[column].astype(str), return_counts=True), strict=True):
                counts[str(text)] = counts.get(str(text), 0) + int(count)
        return counts

    def yields(self) -> list[Yield]:
        """Return the yield of each requirement: the fraction of runs that meet it.

        If there are several requirements, the last yield is the fraction of runs that meet all of them.

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
        """Return statistics of each metric over all runs.

        The statistics are moments, extremes and quantiles. They also contain the number of runs with a finite value,
        with an infinite value and without a value.
        """
        return [summary_of(self.dataset, metric, MAX_EXACT_RUNS) for metric in self.plan.metrics]

    def bands(self) -> Bands | None:
        """Return histograms of outputs, from which quantiles versus time are computed.

        The result is None unless the setting `keep` of the ensemble is `bands`.
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
            Mapping from each metric to one range for each parameter: the values of the metric if this parameter has its
            5 % quantile, its median and its 95 % quantile, and all others have their medians.
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
        """Return the Sobol indices of each metric.

        The result is empty if the ensemble has no runs for these indices.

        Returns
        -------
        dict
            Mapping from each metric to the first-order and total indices of every factor. A factor is one parameter, or
            all parameters of the table `from_fit` together.
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
            Mapping from each requirement to its runs with the smallest margins; failed runs are first.
        """
        worst = {}
        for requirement in self.plan.requirements:
            cases: list[WorstCase] = []
            for shard in self.dataset.shards("runs"):
                values = shard[requirement.metric]
                margins = np.where(shard["done"].astype(bool), requirement.margin(values), -np.inf)
                margins = np.where(np.isnan(margins), -np.inf, margins)
                for k in np.argsort(margins, kind="stable")[:count].tolist():
                    run, outcome = int(shard["run"][k]), str(shard["outcome"][k])
                    numbers = {address: float(shard[address][k]) for address in self.plan.addresses}
                    cases.append(
                        WorstCase(requirement.name, run, float(values[k]), float(margins[k]), outcome, numbers)
                    )
                cases = sorted(cases, key=lambda case: (case.margin, case.run))[:count]
            worst[requirement.name] = cases
        return worst

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
        make_folder(target)
        circuit, paths = self.plan.circuit, []
        for worst in self.worst(count).values():
            for k, case in enumerate(worst, 1):
                title = f"{circuit.title}, run {case.run} ({case.requirement})"
                content = circuit_text(replace(circuit.with_values(case.numbers), title=title), target).encode("utf-8")
                path = target / f"{case.requirement}-{k}.toml"
                paths.append(write_whole(path, lambda stream, content=content: stream.write(content)))  # type: ignore[misc]
        return paths


def circuit_text(circuit: BaseCircuit, folder: Path) -> str:
    """Return the text of a circuit file with the present parameter values of a circuit.

    File paths in the text are relative to `folder`. The text is read again to check that it gives the same circuit. If
    the circuit differs from its file in more than its parameters, an error is raised.
    """
    tables, origin = circuit.origin
    if not tables:
        raise InputError("ensemble.not_of_a_file", title=circuit.title)
    content = {key: deepcopy(value) for key, value in tables.items() if key not in ABOVE} | {"title": circuit.title}
    original = loads(toml_text(content), folder=origin)
    specs = varied_specs(circuit)
    for address, number in circuit.numbers().items():
        previous = original.numbers().get(address)
        if previous is None or previous.value != number.value or previous.reference != number.reference:
            unit = specs[address].unit if address in specs else number.unit
            mark = " g" if number.reference == "gauge" else ""
            value = float(number.value) if unit == "1" else f"{float(number.value)!r} {unit}{mark}"
            # The check below finds an error due to an unexpected table structure.
            owner, *path, last = address.split(".")
            program = getattr(circuit.parts.get(owner), path[0], None) if path else None
            if isinstance(program, SequenceProgram):
                # The number is inside the text of a condition.
                content["parts"][owner][program.field] = program.table
                continue
            table = content.setdefault(owner, {}) if owner in ("ambient", "gas", "run") else content["parts"][owner]
            if owner == "gas" and isinstance(table, str):
                table = content["gas"] = {"name": table}
            for key in path:
                table = table.setdefault(key, {}) if isinstance(table, dict) else {}
            if isinstance(table, dict):
                table[last] = value
    _move_paths(content, origin, folder)
    text = toml_text(content)
    if fingerprint(loads(text, folder=folder)) != fingerprint(circuit):
        raise InputError("ensemble.not_its_file", title=circuit.title)
    return text


def _move_paths(table: Any, old: Path, new: Path) -> None:
    """Change the relative file paths in nested tables, in place, after a change of folder.

    The paths are relative to the folder `old` before, and to the folder `new` after the change.
    """
    for key, value in table.items() if isinstance(table, dict) else ():
        if key in _PATHS and isinstance(value, str) and (old / value).is_file():
            table[key] = os.path.relpath(old / value, new)
        elif key == "components" and isinstance(value, list):
            table[key] = [os.path.relpath(old / path, new) for path in value]
        _move_paths(value, old, new)


def run_ensemble(
    circuit: BaseCircuit,
    output: str | Path | None = None,
    *,
    executor: Any = "threads",
    workers: int | None = None,
    progress: Callable[[int, int, str], Any] | None = None,
    requirements: Mapping[str, str] | None = None,
    allow_python: bool = False,
    **fields: Any,
) -> Ensemble:
    """Run a circuit many times with uncertain parameters, and return the stored results.

    The public method `Circuit.ensemble` describes the arguments.
    """
    plan = plan_of(circuit, requirements=requirements, allow_python=allow_python, **fields)
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


def plan_of(
    circuit: BaseCircuit,
    *,
    requirements: Mapping[str, str] | None = None,
    allow_python: bool = False,
    is_nominal: bool = False,
    **fields: Any,
) -> EnsemblePlan:
    """Return the settings of an ensemble from the tables of a circuit.

    The keyword `allow_python` permits Python functions in files, which the runs execute, but not this function. If the
    keyword `is_nominal` is True, the plan has no uncertain parameters. All other keyword arguments replace fields of
    the table `ensemble`.
    """
    tables, folder = circuit.origin
    table = tables.get("ensemble", {})
    fields = with_parameters(fields)
    if is_nominal:
        fields |= {"parameters": {}, "sampling": "random", "runs": 1, "keep": "metrics", "indices": 0}
    if isinstance(table, Mapping):
        # The file of an overridden sampling method is ignored.
        omitted = {"file"} if fields.get("sampling", "file") != "file" else set()
        omitted |= {"numbers", "parameters"} if "parameters" in fields else set()
        table = {key: value for key, value in table.items() if key not in omitted} | fields
    if requirements is None:
        requirements = tables.get("requirements", {})
    return read_plan(circuit, table, requirements, folder, allow_python=allow_python, is_nominal=is_nominal)


def with_parameters(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Return keyword arguments of an ensemble, with `numbers` renamed to `parameters`.

    `numbers` is the former name. Its use causes a warning.
    """
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
    """Run all runs of an ensemble that are not yet stored in a folder, and store them."""
    dataset = Dataset.open(folder, plan)
    is_whole = run_missing(plan, dataset, executor, workers, progress)
    return Ensemble(plan, dataset.seal() if is_whole else dataset, is_whole)
