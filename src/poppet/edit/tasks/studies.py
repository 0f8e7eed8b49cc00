"""Tasks that run the circuit with many values of its parameters: ensembles and sizing."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.number_format import USUAL
from poppet.core.units import convert, quantity
from poppet.edit.tasks.order import TaskOrder, TaskResult, default_range, sets_value, shown_unit, written_value
from poppet.edit.tasks.runs import sentences
from poppet.ensemble import plan_of, run_plan, size
from poppet.ensemble.ensemble_plan import varied_specs
from poppet.ensemble.metrics import METRIC_KINDS
from poppet.ensemble.shards import PreparedPlan
from poppet.ensemble.sizing import Sizing
from poppet.timeseries.plotting.figures import style

RUNS = 200
"""Default number of runs of an ensemble."""
POINTS = 41
"""Number of parameter values of a curve without a requirement."""
DIGITS = 4
"""Significant digits of a sized value, which is rounded to the side that meets the requirement."""


def run_ensemble(order: TaskOrder) -> TaskResult:
    """Run the circuit many times, with the distributions of the file or with the spreads that the user has stated."""
    from poppet.report.ensemble_report import metric_table, write_ensemble, yield_table

    style("A report of an ensemble")
    spreads = order.options.get("spreads", {})
    fields: dict[str, Any] = {key: order.options[key] for key in ("runs", "seed") if key in order.options}
    if spreads:
        parameters = {a: {"distribution": "uniform", "relative_range": spread} for a, spread in spreads.items()}
        fields |= {"parameters": parameters, "runs": fields.get("runs", RUNS), "sampling": "random"}
    fields |= _metric_fields(order, fields)
    plan = plan_of(order.circuit, **fields)
    ensemble = run_plan(plan, order.output.parent / "dataset", progress=order.count("runs"))
    order.report("report", 0.0, None)
    write_ensemble(ensemble, order.path("-ensemble.html"))
    columns = ensemble.dataset.columns("runs")
    with order.path("-ensemble.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(columns)
        writer.writerows(zip(*(np.asarray(column).tolist() for column in columns.values()), strict=True))
    tables = [table.text() for table in (yield_table(ensemble), metric_table(ensemble)) if table.rows]
    return TaskResult("\n\n".join(tables), sentences(ensemble.remarks()))


def size_parameter(order: TaskOrder) -> TaskResult:
    """Compute a metric versus one parameter; with a requirement, find the smallest or largest value that meets it."""
    if "requirement" in order.options or (
        "metric" not in order.options and "requirements" in order.circuit.origin.tables
    ):
        return _find_size(order)
    return _sweep(order)


def _find_size(order: TaskOrder) -> TaskResult:
    from poppet.report.ensemble_report import sizing_text

    options, address = order.options, order.options["address"]
    fields: dict[str, Any] = _metric_fields(order, {})
    if "requirement" in options:
        (name,) = fields["metrics"]
        fields["requirements"] = {name: f"{name} {options['requirement']}"}

    def sized(between: tuple[Any, Any] | None) -> Sizing:
        return size(
            order.circuit, address, between=between, largest=options.get("extreme") == "largest",
            progress=lambda done, total, kind: order.report(kind, done, total), **fields,
        )  # fmt: skip

    is_stated = "low" in options or "high" in options
    # A value of zero has no range around it.
    number = order.circuit.numbers().get(address)
    is_zero = number is not None and number.absolute(order.circuit.surroundings.pressure) <= 0.0
    sizing = sized(None if is_zero and not is_stated else _bounds(order))
    if not is_stated and not sizing.is_met:
        # The value may be beyond the default range; the end of the wide range, such as 700 bar, is no proposal.
        wide = sized(None)
        sizing = wide if wide.limiting else sizing
    # Only the metrics with bounds: a file can have many others.
    name = next(name for name in sizing.metrics if name in sizing.bounds)
    bounds = sizing.bounds[name]
    data = _curve(order, sizing.unit, sizing.values, name, sizing.units[name], sizing.metrics[name], bounds)
    operations: tuple[dict[str, Any], ...] = ()
    if sizing.is_met:
        value = _rounded(sizing.value, sizing.is_largest, sizing.holding)
        present, ambient = order.circuit.numbers()[address], order.circuit.surroundings.pressure
        shown = written_value(value, sizing.unit, present, digits=12, ambient=ambient)
        operation = {"op": "set", "address": address, "value": shown}
        operations = (operation,) if sets_value(order, [operation], address, value) else ()
        data["curve"]["value"] = _shown(order, [value], sizing.unit, data["curve"]["x_unit"] or "1")[0]
    return TaskResult(sizing_text(sizing), operations=operations, data=data)


def _sweep(order: TaskOrder) -> TaskResult:
    address = order.options["address"]
    low, high = _bounds(order)
    fields = _metric_fields(order, {})
    parameters = {address: {"distribution": "uniform", "low": low, "high": high}}
    plan = plan_of(order.circuit, parameters=parameters, runs=1, sampling="random", keep="metrics", indices=0, **fields)
    values = np.geomspace(low, high, POINTS) if low > 0.0 else np.linspace(low, high, POINTS)
    prepared, rows = PreparedPlan(plan), []
    for k, part in enumerate(np.array_split(values, 8)):
        order.report("values", k, 8)
        rows.append(prepared.run(part[:, np.newaxis]).metrics)
    metric = plan.metrics[0]
    unit = prepared.units[address]
    return TaskResult(data=_curve(order, unit, values, metric.name, metric.unit, np.concatenate(rows)[:, 0]))


def _metric_fields(order: TaskOrder, fields: Mapping[str, Any]) -> dict[str, Any]:
    """Return the table of the metric that the user has chosen; without one, those of the file apply."""
    metric = order.options.get("metric")
    if metric is None:
        return {}
    kind = metric.get("metric")
    # A function in a file would execute Python.
    if kind not in METRIC_KINDS:
        near = NameSuggestion(str(kind), METRIC_KINDS)
        raise InputError("fields.not_an_option", "metric", value=kind, meaning="metric", suggestion=near)
    si = METRIC_KINDS[kind].unit(dict(order.circuit.model.outputs).get(str(metric.get("of")), "1"))
    # The zero of a temperature scale does not apply to differences.
    unit = {} if si == "K" or kind == "overshoot" else {"unit": USUAL.get(si, si)}
    name = re.sub(r"\W", "_", f"{kind}_{metric.get('of', '')}")
    chosen: dict[str, Any] = {"metrics": {name: {**unit, **metric}}}
    # The requirements of the file refer to the metrics of the file.
    return chosen | ({"requirements": {}} if "requirements" not in fields else {})


def _bounds(order: TaskOrder) -> tuple[float, float]:
    """Return the range of the parameter in SI units, absolute."""
    circuit, address = order.circuit, order.options["address"]
    spec = varied_specs(circuit).get(address)
    if spec is None:
        near = NameSuggestion(address, varied_specs(circuit))
        raise InputError("names.unknown", address, meaning="a parameter of this circuit", suggestion=near)
    ambient = circuit.surroundings.pressure
    ends = []
    for key, default in zip(("low", "high"), default_range(circuit, address, spec), strict=True):
        if key not in order.options:
            ends.append(default)
            continue
        parsed = quantity(order.options[key], spec.unit, kind=spec.kind, name=key)
        value = parsed.value + (ambient if parsed.reference == "gauge" else 0.0)
        spec.check_range(key, value, str(order.options[key]), spec.meaning)
        ends.append(value)
    if not ends[0] < ends[1]:
        raise InputError("size.range", address, low=ends[0], high=ends[1], least=spec.ends[0], most=spec.ends[1])
    return ends[0], ends[1]


def _curve(
    order: TaskOrder, unit: str, x: Any, name: str, y_unit: str, y: Any, bounds: tuple[float, ...] = ()
) -> dict[str, Any]:
    """Return a curve for the page: the parameter in a display unit, and the metric.

    A metric without a finite value is null.
    """
    address = order.options["address"]
    shown = shown_unit(float(np.median(x)), unit, order.circuit.numbers()[address])
    metric = order.options.get("metric")
    name = f"{metric['metric'].replace('_', ' ')} of {metric['of']}" if metric else name
    numbers = [value if math.isfinite(value) else None for value in np.asarray(y, dtype=float).tolist()]
    return {
        "curve": {
            "address": address, "x_unit": "" if shown == "1" else shown, "x": _shown(order, x, unit, shown),
            "name": name, "y_unit": "" if y_unit == "1" else y_unit, "y": numbers,
            "bounds": [bound for bound in bounds if math.isfinite(bound)],
        }
    }  # fmt: skip


def _shown(order: TaskOrder, values: Any, unit: str, shown: str) -> list[float]:
    """Return absolute SI values in a display unit, which can be that of a gauge pressure."""
    ambient = order.circuit.surroundings.pressure
    numbers: list[float] = np.asarray(convert(np.asarray(values), unit, shown, ambient_pressure=ambient)).tolist()
    return numbers


def _rounded(value: float, is_largest: bool, holding: Any) -> float:
    """Return a value with few digits that still meets the requirements, or the value itself.

    `holding` contains the intervals in which the requirements are met.
    """
    step = 10.0 ** (math.floor(math.log10(abs(value))) + 1 - DIGITS) if value else 1.0
    rounded = (math.floor if is_largest else math.ceil)(value / step) * step
    rounded = float(f"{rounded:.{DIGITS}g}")
    return rounded if any(low <= rounded <= high for low, high in holding) else value
