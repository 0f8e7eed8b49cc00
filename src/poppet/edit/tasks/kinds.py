"""Declarations of the tasks: their functions and their options."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.plugins import import_object
from poppet.core.tables import Field, read_fields

if TYPE_CHECKING:
    from poppet.edit.tasks.order import TaskOrder, TaskResult

# Nothing heavy is imported here: the server reads these declarations.


class TaskKind(NamedTuple):
    """Declaration of a task.

    The function of a task is imported at its first use, in the process of the task.
    """

    function: str  # `module:function` of `poppet.edit.tasks`; it takes a `TaskOrder` and returns a `TaskResult`
    options: Mapping[str, Field] = {}

    def run(self, order: TaskOrder) -> TaskResult:
        """Run the task."""
        function: Callable[[TaskOrder], TaskResult] = import_object(f"poppet.edit.tasks.{self.function}")
        return function(order)


_ADDRESS = Field(type="string", is_required=True, meaning="address of a parameter")
_RECORDING = Field(type="string", is_required=True, meaning="name of the recording")
_STATEMENTS = Field(type="table", meaning="mapping from questions to answers")
_METRIC = Field(type="table", meaning="metric")

TASKS = {
    "report": TaskKind("runs:write_report"),
    "tune": TaskKind(
        "fits:tune_controller",
        {
            "controller": Field(type="string"),
            "form": Field(choices=("pi", "pid", "p")),
            "sensitivity": Field(type="number"),
            "schedule": Field(type="boolean"),
        },
    ),
    "columns": TaskKind("fits:list_columns", {"recording": _RECORDING}),
    "identify": TaskKind(
        "fits:fit_parameters",
        {
            "recording": _RECORDING,
            "time": Field(type="table", is_required=True, meaning="column of the time"),
            "columns": Field(type="table", is_required=True, meaning="mapping from quantities to columns"),
            "free": Field(is_required=True, meaning="list of free parameters"),
            "start": Field(choices=("first", "free", "circuit")),
        },
    ),
    "interpret": TaskKind("tank_tests:interpret_recording", {"recording": _RECORDING, "statements": _STATEMENTS}),
    "tank": TaskKind(
        "tank_tests:fit_tank_test",
        {"recording": _RECORDING, "statements": _STATEMENTS, "part": Field(type="string", meaning="flow path")},
    ),
    "ensemble": TaskKind(
        "studies:run_ensemble",
        {
            "runs": Field(type="integer", low=1, high=1_000_000),
            "seed": Field(type="integer", low=0, high=2**63),
            "spreads": Field(type="table", meaning="mapping from parameters to relative spreads"),
            "metric": _METRIC,
        },
    ),
    "size": TaskKind(
        "studies:size_parameter",
        {
            "address": _ADDRESS,
            "low": Field(meaning="smallest value"),
            "high": Field(meaning="largest value"),
            "metric": _METRIC,
            "requirement": Field(type="string"),
            "extreme": Field(choices=("smallest", "largest")),
        },
    ),
    "energy": TaskKind("runs:audit_energy", {"cycle": Field(type="string", meaning="start and end of the cycle")}),
    "safety": TaskKind(
        "runs:audit_safety", {"event": Field(type="table", is_required=True, meaning="values of inputs at the event")}
    ),
    "faults": TaskKind("runs:list_faults"),
    "export": TaskKind(
        "runs:export_circuit",
        {
            "target": Field(type="string", is_required=True, meaning="target of the export"),
            "part": Field(type="string"),
            "fmi": Field(choices=("2", "3")),
            "precision": Field(choices=("double", "single")),
        },
    ),
}
"""Tasks by name."""


def read_task(name: Any, options: Any) -> dict[str, Any]:
    """Check the name and the options of a task, and return the options.

    Examples
    --------
    >>> read_task("export", {"target": "st", "part": "controller"})
    {'target': 'st', 'part': 'controller'}
    """
    if not isinstance(name, str) or name not in TASKS:
        near = NameSuggestion(str(name), TASKS)
        raise InputError("fields.not_an_option", "task", value=name, meaning="task", suggestion=near)
    with ErrorCollector() as errors:
        return read_fields(errors, options, TASKS[name].options, table=f"task {name}")
