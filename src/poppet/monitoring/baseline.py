"""Baseline of a plant: healthy values of its free numbers, and the lack of fit of its model, with their file.

A baseline belongs to one circuit with its parameter values and one set of sensors, inputs, faults and nuisances. The
noise of the sensors, the alarm sizes and the settings of a watch can change later.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.options import Run
from poppet.core.codes import Note, notes_of
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.tables import Field, read_fields
from poppet.core.toml import ResultFileMixin
from poppet.core.toml_file import TomlFile
from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]

SHOWN = 5
"""Maximum number of differences in an error message."""
SAME = 1e-9
"""Relative difference of equal parameter values."""
REFERENCES = {True: "a gauge pressure", False: "an absolute pressure"}
TABLES = "commissioning", "numbers", "sensors", "circuit", "remarks"
COMMISSIONING = {
    "recording": Field(type="string", default=""),
    "duration": Field(unit="s", above=0.0, is_required=True),
    "readings": Field(type="integer", low=1, high=2**63 - 1, is_required=True),
    "temper": Field(unit="1", low=1.0, is_required=True),
    "healthy_nis": Field(unit="1", above=0.0, is_required=True),
}
MISFIT = {
    "ratio": Field(unit="1", low=0.0, is_required=True),
    "correlation_time": Field(unit="1", low=1.0, is_required=True),
    "noise": Field(type="number", low=0.0, is_required=True),
    "gauge": Field(type="boolean", default=False),
}


class ChannelMisfit(NamedTuple):
    """Residuals of one sensor on the healthy recording.

    The factor is that of the standard deviation of the noise. Independent readings with this noise determine the
    free numbers as well as the real readings, whose residuals are larger and correlated.
    """

    ratio: float  # root mean square of the residuals in standard deviations of the noise
    correlation_time: float  # autocorrelation time [samples], at least 1
    noise: float = 0.0  # stated standard deviation of one reading on the healthy recording [SI]

    @property
    def factor(self) -> float:
        """Factor on the noise of the sensor in all estimates, at least 1."""
        return max(1.0, self.ratio * math.sqrt(self.correlation_time))

    @property
    def size(self) -> float:
        """Standard deviation of independent readings with the same information [SI]."""
        return self.noise * self.ratio * math.sqrt(self.correlation_time)


@dataclass(frozen=True, eq=False)
class Baseline(ResultFileMixin):
    """Healthy state of a plant, from which a watch measures changes.

    Parameters
    ----------
    plan : WatchPlan
        Plan of the watch.
    values, sigmas : ndarray
        Healthy values of the free numbers of the plan and their standard deviations, (m,) [SI].
    misfit : tuple of ChannelMisfit
        Lack of fit of each sensor.
    temper : float
        Factor on the variances of the fault numbers, at least 1: the ratio of their statistics on the healthy recording
        to the expected ones.
    healthy_nis : float
        Mean normalised squared innovation of one reading on the healthy recording.
    duration : float
        Duration of the recording [s].
    readings : int
        Number of its readings.
    recording : str
        Name of the recording.
    remarks : tuple of Note
        Findings on the recording and the estimates.
    """

    plan: WatchPlan
    values: Array
    sigmas: Array
    misfit: tuple[ChannelMisfit, ...]
    temper: float = 1.0
    healthy_nis: float = 1.0
    duration: float = 0.0
    readings: int = 0
    recording: str = ""
    remarks: tuple[Note, ...] = ()

    @classmethod
    def of_circuit(cls, plan: WatchPlan) -> Baseline:
        """Return the baseline of a plant that equals its circuit, for simulated plants and tests."""
        exact = tuple(ChannelMisfit(1.0, 1.0) for _ in plan.channels)
        return cls(plan, plan.reference, np.zeros(len(plan.names)), exact)

    @property
    def noise(self) -> Array:
        """Standard deviations of the readings for estimates, which include the lack of fit, (n_channels,) [SI]."""
        return np.array([max(c.noise, m.size) for c, m in zip(self.plan.channels, self.misfit, strict=True)])

    @property
    def faults(self) -> Array:
        """Healthy values of the fault numbers, (n_faults,) [SI]."""
        return self.values[: len(self.plan.faults)]

    def content(self) -> dict[str, Any]:
        """Return the content of the baseline file as nested tables."""
        plan = self.plan
        columns = zip(plan.names, self.values, plan.units, self.sigmas, strict=True)
        return {
            "kind": "baseline",
            "commissioning": {
                "recording": self.recording, "duration": self.duration, "readings": self.readings,
                "temper": self.temper, "healthy_nis": self.healthy_nis,
            },
            "numbers": {
                name: {"address": address, "value": value, "unit": unit, "sigma": sigma, "source": "fitted"}
                for (name, value, unit, sigma), address in zip(columns, _addresses(plan), strict=True)
            },
            "sensors": {
                channel.address: {**misfit._asdict(), "gauge": channel.is_gauge}
                for channel, misfit in zip(plan.channels, self.misfit, strict=True)
            },
            "circuit": {
                "structure": structure_hash(plan),
                "inputs": [item.address for item in plan.inputs],
                "parameters": fixed_parameters(plan),
            },
            "remarks": [remark.plain() for remark in self.remarks],
        }  # fmt: skip


def structure_hash(plan: WatchPlan) -> str:
    """Return a hash of the equations of the circuit: kinds, options, names and connections of its parts."""
    return hashlib.sha256(repr(plan.circuit.structure).encode()).hexdigest()


def fixed_parameters(plan: WatchPlan) -> dict[str, float]:
    """Return the values on which the baseline depends, and which neither the free numbers nor the samples change [SI].

    Initial values of the parts are not among them.
    """
    model, parameters = plan.instance.model, plan.instance.parameters
    read_parameters, read_inputs = model.influences
    names = list(parameters)
    fixed = {names[k]: parameters[names[k]] for k in sorted(read_parameters - set(plan.free.places.tolist()))}
    coefficients = plan.instance.problem(Run(duration=1.0)).coefficients[0]
    changing = {item.index for item in plan.inputs} | set(plan.free.inputs.tolist())
    constant = sorted(read_inputs - changing)
    fixed |= {model.inputs[k].name: float(coefficients[k, 0]) for k in constant if not model.inputs[k].slope_of}
    # No equation contains the delay of a signal.
    delays = {item.name: item.delay for item in model.inputs if item.delay}
    return fixed | {delays[i.address]: parameters[delays[i.address]] for i in plan.inputs if i.address in delays}


def _addresses(plan: WatchPlan) -> list[str]:
    return [*plan.free.addresses, *(plan.channels[k].address for k in plan.offsets)]


def read_baseline(path: str | Path, plan: WatchPlan) -> Baseline:
    """Read a baseline file.

    Parameters
    ----------
    path : str or Path
        File that `Baseline.save` has written (`.toml`).
    plan : WatchPlan
        Plan to which the baseline must belong.

    Raises
    ------
    InputErrors
        If the file does not exist or is not a baseline, or if it belongs to another circuit, to other parameter values,
        or to other sensors, inputs, faults or nuisances.
    """
    if not Path(path).exists():
        raise InputError("baseline.no_file", path=str(path))
    file = TomlFile.read(path)
    content = file.content
    if content.get("kind") != "baseline":
        raise InputError("baseline.other_kind", path=str(path))
    with file.errors() as errors:
        for key in content.keys() - {"kind", *TABLES}:
            errors.add("fields.unknown", key, table="baseline file", suggestion=NameSuggestion(key, TABLES))
        tables: dict[str, Any] = {name: content.get(name) for name in TABLES}
        tables["remarks"] = content.get("remarks", [])
        for name, table in tables.items():
            if not isinstance(table, list if name == "remarks" else Mapping):
                errors.add("fields.no_table", name, value=table)
    with file.errors() as errors:
        general = read_fields(
            errors, tables["commissioning"], COMMISSIONING, "commissioning", table="table [commissioning]"
        )
        numbers = _read_numbers(errors, tables["numbers"], plan)
        misfit = _read_misfit(errors, tables["sensors"], plan)
        _check_circuit(errors, tables["circuit"], plan)
    values, sigmas = np.array(numbers).reshape(-1, 2).T
    return Baseline(plan, values, sigmas, tuple(misfit), **general, remarks=notes_of(tables["remarks"]))


def is_baseline(path: Path) -> bool:
    """Return True if a file is a baseline, so that a new one can replace it."""
    try:
        return TomlFile.read(path).content.get("kind") == "baseline"
    except InputError:
        return False


def _read_numbers(errors: ErrorCollector, table: Mapping[str, Any], plan: WatchPlan) -> list[tuple[float, float]]:
    """Return value and standard deviation of each free number of the plan."""
    numbers = []
    _check_names(errors, "numbers", table, plan.names)
    fields = {
        "address": Field(type="string", is_required=True),
        "value": Field(type="number", is_required=True),
        "unit": Field(type="string", is_required=True),
        "sigma": Field(type="number", is_required=True, meaning="standard deviation"),
        "source": Field(type="string", default="fitted"),
    }
    for name, address, unit in zip(plan.names, _addresses(plan), plan.units, strict=True):
        if name not in table:
            continue
        location = f"numbers.{name}"
        read = read_fields(errors, table[name], fields, location, table="number")
        if read.get("address", address) != address or read.get("unit", unit) != unit:
            entry = f"{read.get('address')} [{read.get('unit')}]"
            errors.add("baseline.other_number", location, given=entry, expected=f"{address} [{unit}]")
        sigma = float(read.get("sigma", 0.0))
        with errors.collecting():
            Field(low=0.0).check_range(f"{location}.sigma", sigma, str(sigma), "standard deviation")
        numbers.append((float(read.get("value", 0.0)), sigma))
    return numbers


def _read_misfit(errors: ErrorCollector, table: Mapping[str, Any], plan: WatchPlan) -> list[ChannelMisfit]:
    """Return the lack of fit of each sensor of the plan."""
    misfit = []
    _check_names(errors, "sensors", table, [channel.address for channel in plan.channels])
    for channel in plan.channels:
        if channel.address not in table:
            continue
        location = f"sensors.{channel.address}"
        read = read_fields(errors, table[channel.address], MISFIT, location, table="sensor of a baseline")
        if read.get("gauge", channel.is_gauge) != channel.is_gauge:
            former, present = (REFERENCES[is_gauge] for is_gauge in (not channel.is_gauge, channel.is_gauge))
            errors.add("baseline.other_gauge", location, before=former, now=present)
        values = {key: float(read.get(key, 1.0)) for key in ("ratio", "correlation_time", "noise")}
        misfit.append(ChannelMisfit(**values))
    return misfit


def _check_circuit(errors: ErrorCollector, table: Mapping[str, Any], plan: WatchPlan) -> None:
    """Collect an error if the baseline belongs to another circuit, to other inputs or to other parameter values."""
    if table.get("structure") != structure_hash(plan):
        errors.add("baseline.other_circuit", "circuit.structure")
        return
    inputs = table.get("inputs", [])
    _check_names(errors, "circuit.inputs", inputs if isinstance(inputs, list) else [], [i.address for i in plan.inputs])
    stored, present = table.get("parameters"), fixed_parameters(plan)
    if not isinstance(stored, Mapping):
        errors.add("fields.no_table", "circuit.parameters", value=stored)
        return
    changed = [
        f"{name} {stored.get(name)} -> {value}"
        for name, value in present.items()
        if not isinstance(stored.get(name), int | float)
        or not math.isclose(stored[name], value, rel_tol=SAME, abs_tol=0.0)
    ]
    if changed:
        errors.add("baseline.other_values", "circuit.parameters", changed=changed[:SHOWN], count=len(changed))


def _check_names(errors: ErrorCollector, location: str, stored: Any, expected: Any) -> None:
    """Collect an error if a table or list of the file has other names than the plan."""
    missing = [name for name in expected if name not in stored]
    surplus = [str(name) for name in stored if name not in expected]
    if missing or surplus:
        errors.add("baseline.other_names", location, missing=missing, surplus=surplus)
