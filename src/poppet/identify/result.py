"""Result of an identification: estimates, verdicts, residuals and findings."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, needed
from poppet.core.note_groups import grouped
from poppet.core.notebook import HtmlMixin
from poppet.core.number_format import readable_unit, scaled
from poppet.core.provenance import Number, Source
from poppet.core.toml import ResultFileMixin, from_json
from poppet.timeseries.checks import FloatArray

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

Verdict = Literal["determined", "weak", "not determined", "at bound"]
VERDICTS: tuple[Verdict, ...] = get_args(Verdict)
CONFIDENCE = 0.95
"""Level of the intervals `low` ... `high`."""
DETERMINED, WEAK = 0.1, 0.5
"""Limits of the relative half width of an interval: determined up to the first, not determined above the second."""


@dataclass(frozen=True)
class Estimate:
    """Estimate of a free parameter, with its interval and verdict.

    Parameters
    ----------
    value : float
        Best value, in `unit`.
    unit : str
        SI unit.
    standard_error : float
        Standard error; infinite if the data do not determine the parameter.
    low, high : float
        Lower and upper end of the 95 % confidence interval.
    verdict : str
        `determined`, `weak`, `not determined` or `at bound`.
    start : float
        Start value of the search.
    """

    value: float
    unit: str
    standard_error: float
    low: float
    high: float
    verdict: Verdict
    start: float = math.nan


@dataclass(frozen=True)
class ResidualSummary:
    """Statistics of the residuals (model - measurement) of one channel.

    Parameters
    ----------
    rms : float
        Root mean square, in `unit`.
    nrmse : float
        Ratio of `rms` to the range (max - min) of the measurement.
    bias : float
        Mean of model - measurement, in `unit`.
    unit : str
        SI unit.
    samples : int
        Number of samples compared.
    """

    rms: float
    nrmse: float
    bias: float
    unit: str
    samples: int

    @classmethod
    def of(cls, model: FloatArray, measured: FloatArray, unit: str) -> ResidualSummary:
        """Return statistics of the difference between a modelled and a measured series.

        Parameters
        ----------
        model, measured : (n,) array
            Values of the model and of the measurement, in `unit`.
        unit : str
            SI unit.

        Returns
        -------
        ResidualSummary
            Summary; `nrmse` is infinite if the measurement is constant.
        """
        difference, span = model - measured, float(np.ptp(measured))
        rms = float(np.sqrt(np.mean(difference**2)))
        nrmse = rms / span if span > 0.0 else math.inf
        return cls(rms, nrmse, float(np.mean(difference)), unit, int(measured.size))


@dataclass(frozen=True)
class Result(ResultFileMixin, HtmlMixin):
    """Result of an identification.

    Parameters
    ----------
    method : str
        Method: `fit`, `tank`, `flow`, `characteristic`, `muscle`, `friction`.
    title : str
        Title of the result.
    parameters : mapping
        Mapping from the address of each free parameter to its estimate.
    residuals : mapping
        Mapping from `recording.channel` to the statistics of the residuals.
    correlation : mapping
        Correlations: mapping from the address of one parameter to a mapping from another address to the correlation.
    comparison : mapping
        AICc, and comparisons with other models.
    remarks : tuple of Note
        Findings with codes, addresses and facts, the most important first.
    conditions : mapping
        Conditions of the test and the fit: files, noise, fixed parameters, samples.
    series : mapping
        Arrays for the report by name; the result file does not contain them. A channel is a table of `time` (or `x`
        with `x_unit` and `x_name`), `measured`, `model` and `unit`. Its 95 % confidence bands are `low` and `high` for
        the model, and `samples_low` and `samples_high` for single samples. A curve is a table of `x`, `y`, `low`,
        `high`, `points_x`, `points_y`, `points_low` and `points_high`. `contour` has the increase in chi-square `rise`
        at conductances `x`, (n_rows, n_columns), and wall conductances `y`, (n_rows,). `profile.ADDRESS` has it at
        values `x` of a parameter, (n,), with the `limit` of 95 % and the equivalent optima `answers`.
    optima : tuple of mappings
        Equivalent optima of a fit, the best one first: `values`, `low` and `high` (interval) and `start` by address,
        `cost` (half the sum of squares, in sigmas), `excess` (evidence against the optimum: a difference of cost),
        `rms` of each channel, `name` of the start point.
    """

    method: str
    title: str
    parameters: Mapping[str, Estimate]
    residuals: Mapping[str, ResidualSummary] = field(default_factory=dict)
    correlation: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    comparison: Mapping[str, Any] = field(default_factory=dict)
    remarks: tuple[Note, ...] = ()
    conditions: Mapping[str, Any] = field(default_factory=dict)
    series: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)
    optima: tuple[Mapping[str, Any], ...] = ()

    def __getitem__(self, address: str) -> Estimate:
        if address not in self.parameters:
            near = NameSuggestion(address, self.parameters)
            raise InputError("names.unknown", address, meaning="a parameter of this result", suggestion=near)
        return self.parameters[address]

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.parameters)

    @property
    def findings(self) -> tuple[str, ...]:
        """Findings of the identification as sentences."""
        return tuple(str(remark) for remark in self.remarks)

    def values(self) -> dict[str, Number]:
        """Return the fitted values by address, as an argument of `Circuit.with_values`.

        Returns
        -------
        dict
            Numbers with the source `fitted`, without the nuisance parameters of recordings (lags, delays) and without
            estimates that are not-a-number.
        """
        names = self.conditions.get("recordings", [])
        return {
            address: fitted_number(estimate, self.title)
            for address, estimate in self.parameters.items()
            if address.partition(".")[0] not in names and math.isfinite(estimate.value)
        }

    def summary(self) -> str:
        """Return the estimates, the residuals and all findings as text.

        Returns
        -------
        str
            One line for each estimate, each channel and each finding.
        """
        findings = [f"- {finding}" for finding in grouped(self.remarks)]
        return "\n".join([*filter(None, [self.title]), *self.lines(), *findings])

    @property
    def interrupted(self) -> bool:
        """True if the user interrupted the identification."""
        return bool(self.conditions.get("interrupted", False))

    def lines(self) -> list[str]:
        """Return one line of text for each estimate, and one for the residuals of each channel.

        Returns
        -------
        list of str
            The first line contains the headings of the estimates.
        """
        width = max((len(name) for name in ("parameter", *self.parameters)), default=0)
        headings = f"  {'parameter':<{width}}  value +/- standard uncertainty  [95 % interval]  verdict"
        lines = [headings] if self.parameters else []
        for name, e in self.parameters.items():
            error, interval = f"{e.standard_error:.2g}{unit_suffix(e.unit)}", f"[{e.low:.5g} ... {e.high:.5g}]"
            lines.append(f"  {name:<{width}}  {e.value:.6g} +/- {error}  {interval}  {e.verdict}")
        for name, r in self.residuals.items():
            unit = unit_suffix(r.unit)
            nrmse = f"NRMSE {100.0 * r.nrmse:.2f} %, " if math.isfinite(r.nrmse) else ""
            lines.append(f"  {name}: rms {r.rms:.4g}{unit}, {nrmse}bias {r.bias:.3g}{unit}")
        return lines

    def to_frame(self) -> pandas.DataFrame:
        """Return the estimates as a table.

        Returns
        -------
        pandas.DataFrame
            One row for each parameter: `value`, `unit`, `standard_error`, `low`, `high`, `verdict`, `start`.
        """
        with needed("pandas", "A pandas table", "data"):
            import pandas as pd
        return pd.DataFrame.from_dict({name: vars(e) for name, e in self.parameters.items()}, orient="index")

    def plot(self, path: str | Path | None = None) -> Figure:
        """Draw the measured series and the fitted curves with their 95 % confidence bands.

        Parameters
        ----------
        path : str or Path, optional
            File of the figure, `.png`, `.svg` or `.pdf`.

        Returns
        -------
        matplotlib.figure.Figure
            One panel for each series.

        Raises
        ------
        InputError
            If the result has no series, for example because it was read from a file.
        """
        from poppet.timeseries.plotting.plots import plot_fitted_series

        tables = {name: table for name, table in self.series.items() if "measured" in table}
        return plot_fitted_series(tables, path, title=self.title)

    def content(self) -> dict[str, Any]:
        """Return the content of the result file as nested tables."""
        return {
            "method": self.method,
            "title": self.title,
            "findings": list(self.findings),
            "parameters": {name: vars(e).copy() for name, e in self.parameters.items()},
            "residuals": {name: vars(r).copy() for name, r in self.residuals.items()},
            "comparison": dict(self.comparison),
            "correlation": {name: dict(row) for name, row in self.correlation.items()},
            "conditions": dict(self.conditions),
            "remarks": [remark.plain() for remark in self.remarks],
            "optima": [dict(optimum) for optimum in self.optima],
        }


DEPENDENT_FINDINGS = {
    "finding.choking.never": ("number", "finding.choking.perhaps_never"),
    "flow.none_choked": ("", "flow.none_choked_perhaps"),
    "flow.unusual_conductance": ("", ""),
}
"""Findings that need a determined parameter: fact with its address (or the address of the note), and the code of the
finding that replaces them otherwise."""


def replace_uncertain_findings(notes: Iterable[Note], estimates: Mapping[str, Estimate]) -> tuple[Note, ...]:
    """Replace or remove findings that refer to the value of a parameter that is not determined.

    `estimates` contains the verdicts on the parameters.
    """
    findings = []
    for note in notes:
        fact, replacement = DEPENDENT_FINDINGS.get(note.code, ("", ""))
        estimate = estimates.get(note.facts[fact] if fact else note.address)
        if note.code not in DEPENDENT_FINDINGS or estimate is None or estimate.verdict == "determined":
            findings.append(note)
        elif replacement:
            findings.append(Note(replacement, note.address, **note.facts))
    return tuple(findings)


def mark_interrupted(result: Result, note: Note, *remarks: Note) -> Result:
    """Return a result that is marked as interrupted by the user.

    `note` describes the interruption.
    """
    remarks = (*result.remarks, *remarks, note)
    return replace(result, conditions={**result.conditions, "interrupted": True}, remarks=remarks)


def fitted_number(estimate: Estimate, title: str) -> Number:
    """Return an estimate as a parameter value with the source `fitted`.

    `title` is the title of the fit, which the source states.
    """
    shown = readable_unit(estimate.unit, estimate.value)
    unit = "" if shown == "1" else f" {shown}"
    note = f"+/- {scaled(estimate.standard_error, estimate.unit, shown):.3g}{unit} ({estimate.verdict})"
    return Number(estimate.value, estimate.unit, Source("fitted", title, note))


def verdict_on_interval(half: float, size: float, limits: tuple[float, float] = (DETERMINED, WEAK)) -> Verdict:
    """Return the verdict on an estimate from the width of its interval: `determined`, `weak` or `not determined`.

    `half` is half the width, and `size` the value with which it is compared. `limits` contains the largest ratios of
    both for the verdicts `determined` and `weak`.
    """
    # In this order not-a-number and infinity are "not determined".
    return "determined" if half <= limits[0] * size else "weak" if half <= limits[1] * size else "not determined"


def unit_suffix(unit: str) -> str:
    """Return a unit with a leading space, as text that follows a value.

    The result is empty for a dimensionless quantity.

    Examples
    --------
    >>> f"0.3{unit_suffix('1')}, 5{unit_suffix('Pa')}"
    '0.3, 5 Pa'
    """
    return "" if unit == "1" else f" {unit}"


def read_result(path: str | Path) -> Result:
    """Read a result file.

    Parameters
    ----------
    path : str or Path
        `.toml` or `.json`, as `Result.save` writes it.

    Returns
    -------
    Result
        Result of the file; `series` is empty.

    Raises
    ------
    InputError
        If the file is not a result file.
    """
    from poppet.core.toml_file import TomlFile

    path = Path(path)
    file = TomlFile.read(path)
    try:
        data = from_json(json.loads(file.text)) if path.suffix.lower() == ".json" else file.tables
        parameters = {name: Estimate(**_floats(row)) for name, row in data["parameters"].items()}
        residuals = {name: ResidualSummary(**_floats(row)) for name, row in data.get("residuals", {}).items()}
        remarks = _remarks(data.get("findings", ()), data.get("remarks", ()))
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError("result.unreadable", path=str(path), problem=str(error)) from None
    for name, estimate in parameters.items():
        if estimate.verdict not in VERDICTS:
            near = NameSuggestion(str(estimate.verdict), VERDICTS)
            facts: dict[str, Any] = {"value": estimate.verdict, "meaning": "verdict", "suggestion": near}
            raise InputError("fields.not_an_option", f"parameters.{name}.verdict", **facts).located(file=str(path))
    return Result(
        data.get("method", "fit"),
        data.get("title", path.stem),
        parameters,
        residuals,
        data.get("correlation", {}),
        data.get("comparison", {}),
        remarks,
        data.get("conditions", {}),
        optima=tuple(data.get("optima", ())),
    )


def _remarks(sentences: Sequence[str], tables: Sequence[Mapping[str, Any]]) -> tuple[Note, ...]:
    """Return the findings in a result file.

    `tables` contains findings with codes, and `sentences` their texts. If this version of `poppet` cannot read a
    finding, its sentence is returned instead.
    """
    if len(tables) != len(sentences):
        return notes_of(sentences)
    remarks: list[Note] = []
    for sentence, table in zip(sentences, tables, strict=True):
        try:
            (remark,) = notes_of([table])
            str(remark)
        except (KeyError, IndexError, TypeError, ValueError, AssertionError, OSError):
            (remark,) = notes_of([sentence])
        remarks.append(remark)
    return tuple(remarks)


def _floats(row: Mapping[str, Any]) -> dict[str, Any]:
    return {key: float(v) if isinstance(v, int) and key != "samples" else v for key, v in row.items()}
