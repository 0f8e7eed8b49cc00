"""Smallest or largest component of a catalogue with which a circuit meets its requirements."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.component_files import read_circuit_components
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.provenance import ComponentSource
from poppet.core.toml import ResultFileMixin
from poppet.ensemble.ensemble_result import plan_of
from poppet.ensemble.executors import Progress
from poppet.ensemble.shards import PreparedPlan
from poppet.ensemble.sizing import selected_requirements
from poppet.library.components import CatalogueComponent, components
from poppet.parts.component_search import search, value_of
from poppet.parts.components import MODEL, numbers_of
from poppet.parts.fields import attribute, specs
from poppet.parts.flow_path import FlowPath
from poppet.parts.part import Part

MEASURES = {"sonic_conductance": "m^3/(s Pa)", "bore": "m", "volume": "m^3"}
"""Fields that order the components by size, with their SI units: the first one that components of a kind state."""


@dataclass(frozen=True)
class CatalogueTrial:
    """Run of a circuit with one component of a catalogue.

    Parameters
    ----------
    component : CatalogueComponent
        The component.
    size : float
        Value that orders the components, SI.
    is_met : bool
        True if the run meets all requirements.
    margins : mapping
        Mapping from each requirement to its margin, in the unit of its metric; negative if it is not met.
    metrics : mapping
        Mapping from each metric to its value.
    outcome : str
        Code of the termination reason of the run.
    """

    component: CatalogueComponent
    size: float
    is_met: bool
    margins: Mapping[str, float]
    metrics: Mapping[str, float]
    outcome: str


@dataclass(frozen=True)
class CatalogueSizing(ResultFileMixin):
    """Result of a search in a catalogue: one trial per component, in ascending order of size.

    Parameters
    ----------
    title : str
        Title of the circuit.
    part : str
        Name of the part.
    measure, unit : str
        Field that orders the components, and its SI unit.
    is_largest : bool
        True if the largest component was requested instead of the smallest.
    trials : tuple of CatalogueTrial
        Trials in ascending order of size.
    requirements, bounded : mapping
        Text and metric of each requirement.
    units : mapping
        Unit of each metric.
    bounds : mapping
        Bounds of the requirements on each metric, in its unit.
    remarks : tuple of Note
        Notes on the result.
    """

    title: str
    part: str
    measure: str
    unit: str
    is_largest: bool
    trials: tuple[CatalogueTrial, ...]
    requirements: Mapping[str, str]
    bounded: Mapping[str, str]
    units: Mapping[str, str]
    bounds: Mapping[str, tuple[float, ...]]
    remarks: tuple[Note, ...] = ()

    @property
    def selected(self) -> CatalogueTrial | None:
        """Smallest (or largest) component that meets all requirements, or None if there is none."""
        trials = reversed(self.trials) if self.is_largest else iter(self.trials)
        return next((trial for trial in trials if trial.is_met), None)

    @property
    def neighbour(self) -> CatalogueTrial | None:
        """Next smaller (or larger) component than the selected one, or None; it does not meet all requirements.

        The sizes of both differ.
        """
        if (selected := self.selected) is None:
            return None
        if self.is_largest:
            return next((trial for trial in self.trials if trial.size > selected.size), None)
        return next((trial for trial in reversed(self.trials) if trial.size < selected.size), None)

    @property
    def is_met(self) -> bool:
        """True if a component meets all requirements."""
        return self.selected is not None

    def content(self) -> dict[str, Any]:
        """Return the content of the result file of a search as nested tables."""
        selected = self.selected
        return {
            "method": "size",
            "title": self.title,
            "part": self.part,
            "measure": self.measure,
            "unit": self.unit,
            "is_largest": self.is_largest,
            "component": selected.component.name if selected else "",
            "requirements": dict(self.requirements),
            "units": dict(self.units),
            "findings": [str(remark) for remark in self.remarks],
            "trials": [
                {
                    "component": trial.component.name,
                    "size": trial.size,
                    "is_met": trial.is_met,
                    "outcome": trial.outcome,
                    "margins": dict(trial.margins),
                    "metrics": dict(trial.metrics),
                }
                for trial in self.trials
            ],
        }


def size_from_catalogue(
    circuit: BaseCircuit,
    part: str,
    *,
    find: str = "",
    meet: Sequence[str] = (),
    largest: bool = False,
    progress: Progress | None = None,
    allow_python: bool = False,
    **fields: Any,
) -> CatalogueSizing:
    """Find the smallest or largest component of the catalogue that meets the requirements.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the tables `ensemble` (metrics) and `requirements`, unless `fields` contains them.
    part : str
        Name of the part whose component is sought.
    find : str, optional
        Conditions on the components, such as `CKD, C < 3 dm^3/(s bar)` (default: all that suit the part).
    meet : sequence of str, optional
        Names of the requirements (default: all).
    largest : bool, optional
        Find the largest component instead of the smallest.
    progress : callable, optional
        Function that is called with the number of completed runs, their total number, and the kind `runs`.
    allow_python : bool, optional
        Permit metrics by Python functions in files, `FILE.py:FUNCTION`, which executes these files.
    **fields
        Fields of the table `ensemble`, and `requirements`; they replace the entries of the file.

    Returns
    -------
    CatalogueSizing
        One run per component, in ascending order of size.

    Raises
    ------
    InputError
        For an unknown part or name, invalid conditions, or a part that no component suits.

    Notes
    -----
    The candidates are the components of the library, of plugins and of the component files of the circuit that suit the
    kind, the options and the ports of the part. Each replaces the size of the part: all fields that specify a flow
    capacity with its critical ratio, or the fields that the component states, such as a bore. All other fields of the
    circuit apply to all candidates. The order is that of the sonic conductance, otherwise of bore or volume.
    """
    if part not in circuit.parts:
        raise InputError("names.unknown", part, meaning="a part", suggestion=NameSuggestion(part, circuit.parts))
    measure, circuits = _candidates(circuit, part, find)
    plan = plan_of(circuit, allow_python=allow_python, is_nominal=True, **fields)
    requirements = selected_requirements(plan, meet)
    # Circuits of one structure share the compiled model and are run together, unless their delays differ: these shift
    # breakpoints, which all runs of a batch share.
    groups: dict[Hashable, list[CatalogueComponent]] = {}
    for component, changed in circuits.items():
        delays = tuple(changed.parameters[item.delay] for item in changed.instance.model.inputs if item.delay)
        groups.setdefault((changed.structure, delays), []).append(component)
    trials, done = [], 0
    for group in groups.values():
        if progress is not None:
            progress(done, len(circuits), "runs")
        first = circuits[group[0]]
        ready = PreparedPlan(plan_of(first, allow_python=allow_python, is_nominal=True, **fields))
        parameters = np.array([circuits[component].instance.numbers() for component in group])
        completed = done

        def report(count: int, completed: int = completed) -> None:
            if progress is not None:
                progress(completed + count, len(circuits), "runs")

        results = ready.run_parameters(parameters, report)
        done += len(group)
        names = [metric.name for metric in plan.metrics]
        for component, row, outcome in zip(group, results.metrics, results.outcomes, strict=True):
            values = dict(zip(names, row.tolist(), strict=True))
            margins = {r.name: float(r.margin(np.array(values[r.metric]))) for r in requirements}
            is_met = all(bool(r.met(np.array(values[r.metric]))) for r in requirements)
            trials.append(CatalogueTrial(component, _size(component, measure), is_met, margins, values, str(outcome)))
    trials.sort(key=lambda trial: (trial.size, trial.component.name))
    bounds: dict[str, tuple[float, ...]] = {}
    for r in requirements:
        bounds[r.metric] = (*bounds.get(r.metric, ()), *(bound for _, bound in r.bounds))
    sizing = CatalogueSizing(
        circuit.title, part, measure, MEASURES[measure], largest, tuple(trials),
        {r.name: r.text for r in requirements}, {r.name: r.metric for r in requirements},
        {metric.name: metric.unit for metric in plan.metrics}, bounds,
    )  # fmt: skip
    return dataclasses.replace(sizing, remarks=_remarks(sizing, circuit, circuits))


def _candidates(circuit: BaseCircuit, part: str, find: str) -> tuple[str, dict[CatalogueComponent, BaseCircuit]]:
    """Return the field that orders the components, and the circuit with each component that suits a part."""
    tables, folder = circuit.origin
    present = circuit.parts[part]
    everything = [*components(), *read_circuit_components(tables.get("components", []), folder)]
    suitable = [component for component in everything if present.kind in component.kinds]
    if not suitable or MODEL not in specs(type(present)):
        raise InputError("size.no_component", part, kind=present.kind)
    try:
        conditions = search(find, suitable) if find else suitable
    except InputError as error:
        raise error.located(address="find") from None
    measure = next((name for name in MEASURES if any(value_of(c, name) is not None for c in conditions)), "")
    circuits = {}
    for component in conditions if measure else ():
        if value_of(component, measure) is None:
            continue
        try:
            parts = {**circuit.parts, part: _with_component(present, component)}
            circuits[component] = dataclasses.replace(circuit, parts=parts, like=circuit)
        except InputError as error:
            # Options or ports of the part that the component does not have.
            if not error.code.startswith("components."):
                raise
    if not circuits:
        raise InputError("size.no_candidate", part, kind=present.kind, count=len(suitable))
    return measure, circuits


def _with_component(part: Part, component: CatalogueComponent) -> Part:
    """Return a copy of a part whose size is that of a component."""
    changes: dict[str, Any] = dict.fromkeys((attribute(name) for name in _sizes(part, component)), None)
    # Every part is a dataclass, although `Part` itself is not.
    return cast(Part, dataclasses.replace(cast(Any, part), **changes, model=component))


def _sizes(part: Part, component: CatalogueComponent) -> tuple[str, ...]:
    """Return the fields of a part that a component replaces."""
    if isinstance(part, FlowPath):
        return (*type(part).sizes, "critical_ratio")
    return tuple(numbers_of(component, type(part)))


def _size(component: CatalogueComponent, measure: str) -> float:
    size = value_of(component, measure)
    return math.nan if size is None else size


def _remarks(
    sizing: CatalogueSizing, circuit: BaseCircuit, circuits: Mapping[CatalogueComponent, BaseCircuit]
) -> tuple[Note, ...]:
    """Return notes on the result: missing components, doubts of the selected one, and fields of the circuit."""
    remarks = []
    selected = sizing.selected
    if selected is None:
        best = max(sizing.trials, key=lambda trial: _worst_margin(sizing, trial))
        # If an event never occurs in a run, the margin has no distance to compare.
        name = best.component.name if math.isfinite(_worst_margin(sizing, best)) else ""
        remarks.append(Note("size.no_component_meets", sizing.part, count=len(sizing.trials), best=name))
    else:
        remarks.append(_use_note(circuit.parts[sizing.part], sizing.part, selected.component))
        remarks += [note for note in circuits[selected.component].static_notes if _concerns(note, sizing.part)]
        if sizing.neighbour is None:
            remarks.append(
                Note("size.component_end", sizing.part, extreme="largest" if sizing.is_largest else "smallest")
            )
    parts = [(component, changed.parts[sizing.part].numbers()) for component, changed in circuits.items()]
    kept = {
        name: number.display()
        for name, number in circuit.parts[sizing.part].numbers().items()
        if not isinstance(number.source, ComponentSource)
        and any(name in component.fields and numbers.get(name) == number for component, numbers in parts)
    }
    if kept:
        remarks.append(Note("size.fields_of_circuit", sizing.part, values=kept))
    return tuple(remarks)


def _worst_margin(sizing: CatalogueSizing, trial: CatalogueTrial) -> float:
    """Return the smallest margin of a trial, relative to the bounds of the requirement; -inf without a value."""
    sizes = {name: max(map(abs, sizing.bounds[metric])) or 1.0 for name, metric in sizing.bounded.items()}
    margins = [margin / sizes[name] for name, margin in trial.margins.items()]
    return min((margin if math.isfinite(margin) else -math.inf for margin in margins), default=-math.inf)


def _use_note(part: Part, name: str, component: CatalogueComponent) -> Note:
    """Return a note on the lines of the circuit file that the component replaces."""
    present = part.numbers()
    fields = [field for field in _sizes(part, component) if field in present]
    fields += [MODEL] if getattr(part, MODEL) is not None else []
    return Note("size.use_component", name, name=component.name, fields=fields)


def _concerns(note: Note, part: str) -> bool:
    return note.address == part or note.address.startswith(f"{part}.")
