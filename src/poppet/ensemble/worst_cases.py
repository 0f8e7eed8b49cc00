"""The worst runs of a requirement, and circuit files of them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.circuit.file import ABOVE, loads
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.toml import toml_text
from poppet.ensemble.dataset import Dataset, fingerprint
from poppet.ensemble.ensemble_plan import EnsemblePlan, varied_specs
from poppet.ensemble.requirements import Requirement

_PATHS = ("path", "characteristic")
"""Fields that may hold the path of a file."""


@dataclass(frozen=True)
class WorstCase:
    """A run that is among the worst."""

    requirement: str
    run: int
    value: float  # of the metric, in its unit; NaN of a run that failed
    margin: float  # by which it is on the good side; -inf of a run that failed
    outcome: str
    numbers: Mapping[str, float]  # SI, absolute


def worst_of(dataset: Dataset, plan: EnsemblePlan, requirement: Requirement, count: int) -> list[WorstCase]:
    """The runs with the smallest margins, failed ones first; of equal ones the first."""
    found: list[WorstCase] = []
    for shard in dataset.shards("runs"):
        values = shard[requirement.metric]
        margins = np.where(shard["done"].astype(bool), requirement.margin(values), -np.inf)
        margins = np.where(np.isnan(margins), -np.inf, margins)
        for k in np.argsort(margins, kind="stable")[:count].tolist():
            numbers = {address: float(shard[address][k]) for address in plan.addresses}
            case = requirement.name, int(shard["run"][k]), float(values[k]), float(margins[k]), str(shard["outcome"][k])
            found.append(WorstCase(*case, numbers))
        found = sorted(found, key=lambda case: (case.margin, case.run))[:count]
    return found


def save_case(circuit: Circuit, case: WorstCase, path: Path) -> Path:
    """Write the circuit of a case as a file of its own, and see that it is the same."""
    wanted = replace(circuit.with_values(case.numbers), title=f"{circuit.title}, run {case.run} ({case.requirement})")
    text = circuit_text(wanted, path.parent)
    return write_whole(path, lambda stream: stream.write(text.encode("utf-8")))


def circuit_text(circuit: Circuit, folder: Path) -> str:
    """A circuit as a file in a folder: its own file, with the numbers that differ; refused where that is not all."""
    tables, origin = circuit.origin
    if not tables:
        raise InputError("ensemble.not_of_a_file", title=circuit.title)
    content = {key: deepcopy(value) for key, value in tables.items() if key not in ABOVE} | {"title": circuit.title}
    plain = loads(toml_text(content), folder=origin)
    specs = varied_specs(circuit)
    for address, number in circuit.numbers().items():
        before = plain.numbers().get(address)
        if before is None or before.value != number.value or before.reference != number.reference:
            unit = specs[address].unit if address in specs else number.unit
            mark = " g" if number.reference == "gauge" else ""
            given = float(number.value) if unit == "1" else f"{float(number.value)!r} {unit}{mark}"
            _put(content, address, given)
    _move(content, origin, folder)
    text = toml_text(content)
    if fingerprint(loads(text, folder=folder)) != fingerprint(circuit):
        raise InputError("ensemble.not_its_file", title=circuit.title)
    return text


def _put(content: dict[str, Any], address: str, given: Any) -> None:
    """Write a number where a file has it; where that is no table, what is checked afterwards differs."""
    owner, *path, last = address.split(".")
    table = content.setdefault(owner, {}) if owner in ("ambient", "gas", "run") else content["parts"][owner]
    if owner == "gas" and isinstance(table, str):
        table = content["gas"] = {"name": table}
    for key in path:
        table = table.setdefault(key, {}) if isinstance(table, dict) else {}
    if isinstance(table, dict):
        table[last] = given


def _move(table: Any, old: Path, new: Path) -> None:
    """Paths of files beside the one folder as paths from the other."""
    for key, value in table.items() if isinstance(table, dict) else ():
        if key in _PATHS and isinstance(value, str) and (old / value).is_file():
            table[key] = os.path.relpath(old / value, new)
        _move(value, old, new)
