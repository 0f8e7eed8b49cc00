"""Worst runs of a requirement, and their circuit files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import ABOVE, loads
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.toml import toml_text
from poppet.ensemble.dataset import Dataset, fingerprint
from poppet.ensemble.ensemble_plan import EnsemblePlan, varied_specs
from poppet.ensemble.metrics import Requirement

_PATHS = ("path", "characteristic")
"""Fields that can contain the path of a file."""


@dataclass(frozen=True)
class WorstCase:
    """One of the worst runs of a requirement."""

    requirement: str
    run: int
    value: float  # of the metric, in its unit; NaN of a run that failed
    margin: float  # distance to the bound, positive if met; -inf for a failed run
    outcome: str
    numbers: Mapping[str, float]  # SI, absolute


def worst_of(dataset: Dataset, plan: EnsemblePlan, requirement: Requirement, count: int) -> list[WorstCase]:
    """Return the runs with the smallest margins for a requirement.

    Runs that failed come first.
    """
    cases: list[WorstCase] = []
    for shard in dataset.shards("runs"):
        values = shard[requirement.metric]
        margins = np.where(shard["done"].astype(bool), requirement.margin(values), -np.inf)
        margins = np.where(np.isnan(margins), -np.inf, margins)
        for k in np.argsort(margins, kind="stable")[:count].tolist():
            numbers = {address: float(shard[address][k]) for address in plan.addresses}
            case = requirement.name, int(shard["run"][k]), float(values[k]), float(margins[k]), str(shard["outcome"][k])
            cases.append(WorstCase(*case, numbers))
        cases = sorted(cases, key=lambda case: (case.margin, case.run))[:count]
    return cases


def save_case(circuit: BaseCircuit, case: WorstCase, path: Path) -> Path:
    """Write a circuit file with the parameters of a worst case.

    The written file is read again to check that it gives the same circuit.
    """
    changed = replace(circuit.with_values(case.numbers), title=f"{circuit.title}, run {case.run} ({case.requirement})")
    text = circuit_text(changed, path.parent)
    return write_whole(path, lambda stream: stream.write(text.encode("utf-8")))


def circuit_text(circuit: BaseCircuit, folder: Path) -> str:
    """Return the text of a circuit's original file with the changed parameters.

    A circuit with other changes is rejected.
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
            _write_number(content, address, value)
    _move_paths(content, origin, folder)
    text = toml_text(content)
    if fingerprint(loads(text, folder=folder)) != fingerprint(circuit):
        raise InputError("ensemble.not_its_file", title=circuit.title)
    return text


def _write_number(content: dict[str, Any], address: str, value: Any) -> None:
    """Write the value of a parameter to the tables of a circuit file.

    An error due to an unexpected table structure is found by the check in `circuit_text`.
    """
    owner, *path, last = address.split(".")
    table = content.setdefault(owner, {}) if owner in ("ambient", "gas", "run") else content["parts"][owner]
    if owner == "gas" and isinstance(table, str):
        table = content["gas"] = {"name": table}
    for key in path:
        table = table.setdefault(key, {}) if isinstance(table, dict) else {}
    if isinstance(table, dict):
        table[last] = value


def _move_paths(table: Any, old: Path, new: Path) -> None:
    """Adapt relative file paths in the tables to a new folder.

    The paths are relative to `old` before and to `new` after the change.
    """
    for key, value in table.items() if isinstance(table, dict) else ():
        if key in _PATHS and isinstance(value, str) and (old / value).is_file():
            table[key] = os.path.relpath(old / value, new)
        _move_paths(value, old, new)
