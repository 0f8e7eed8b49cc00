"""Plan of a watch: sensors, driven inputs, faults, nuisances and settings, read from tables."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.free_numbers import FreeNumbers, free_numbers
from poppet.circuit.instance import Instance
from poppet.circuit.number_specs import number_specs
from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.tables import Field, missing_field, read_fields
from poppet.monitoring.sensors import DrivenInput, SensorChannel, difference_kind, read_sensors
from poppet.parts.fields import NumberSpec, flatten
from poppet.timeseries.signals import Constant

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

DIRECTIONS = {"down": -1, "both": 0, "up": 1}
"""Sign of the change of a fault by the word in a file; 0 if both signs are faults."""
PRIOR, CAP = 1.0, 10.0
"""Prior standard deviation of a fault, and the largest one, in alarm sizes.

Larger faults are also found: readings outweigh the prior, and a step of a fault has no prior.
"""
SLOW = 1000.0
"""Number of windows in which a fault changes by its alarm size, in the sense of one standard deviation."""
HOUR = 3600.0
AMBIENT = "ambient.pressure"
ADDRESS = 'address = "cylinder.leakage.sonic_conductance"'
NAME = re.compile(r"[A-Za-z_][\w-]*")
"""Pattern of the names of faults, which are parts of column names."""
RESERVED = ("time", "nis", "alarm")
"""Names of columns of the results, which no fault can have."""
SETTINGS = {
    "window": Field(unit="s", above=0.0, default=60.0, meaning="duration of the window that a fit evaluates"),
    "alarm_delay": Field(unit="s", low=0.0, default=2.0, meaning="time for which a fault must be evident"),
    "hold": Field(type="boolean", default=True, meaning="inputs hold their value until the next sample"),
    "state_noise": Field(
        unit="1", low=0.0, default=3e-5,
        meaning="relative standard deviation of unexplained changes of the states in one second",
    ),
}  # fmt: skip
"""Fields of the table `watch`."""


@dataclass(frozen=True)
class Fault:
    """Parameter of the circuit whose change is a fault.

    Parameters
    ----------
    name : str
        Name in results and alarms.
    address : str
        Address of the parameter.
    unit : str
        SI unit.
    direction : int
        1 if only an increase is a fault, -1 if only a decrease is one, 0 for both.
    alarm : float
        Smallest change from the baseline that is reported [SI].
    """

    name: str
    address: str
    unit: str
    direction: int
    alarm: float


@dataclass(frozen=True)
class Nuisance:
    """Parameter of the circuit that can vary without being a fault.

    Parameters
    ----------
    address : str
        Address of the parameter.
    unit : str
        SI unit.
    sigma : float
        Standard deviation of the parameter [SI].
    drift : float
        Standard deviation of the change in one hour, a random walk [SI]; 0 for a constant. The standard deviation of
        the change in t hours is `drift` times the root of t, but not above `sigma`.
    """

    address: str
    unit: str
    sigma: float
    drift: float = 0.0


@dataclass(frozen=True, eq=False)
class WatchPlan:
    """All settings that determine the estimates of a watch.

    The free numbers theta are the faults, then the nuisances, then the offsets of the sensors that have one. All values
    are in SI units, and pressures and temperatures are absolute.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the values from which the estimates start.
    instance : Instance
        The circuit without the signals of inputs that the plant drives.
    channels : tuple of SensorChannel
        Sensors of outputs.
    inputs : tuple of DrivenInput
        Inputs of the circuit that samples drive.
    faults : tuple of Fault
        Changes to report.
    nuisances : tuple of Nuisance
        Parameters that vary without being a fault.
    free : FreeNumbers
        Faults and nuisances with their effect on the parameters and inputs of the model.
    window : float
        Duration of the window that a fit evaluates [s].
    alarm_delay : float
        Time for which a fault must be evident before its alarm [s].
    hold : bool
        True if inputs hold their value until the next sample, by default.
    state_noise : float
        Standard deviation of the change of each state in one second that the model does not explain, relative to the
        state. It covers the errors of integration and linearisation. It is no remedy for a wrong model: it hides the
        symptom, not the bias.
    """

    circuit: BaseCircuit = field(repr=False)
    instance: Instance = field(repr=False)
    channels: tuple[SensorChannel, ...]
    inputs: tuple[DrivenInput, ...]
    faults: tuple[Fault, ...]
    nuisances: tuple[Nuisance, ...]
    free: FreeNumbers = field(repr=False)
    window: float
    alarm_delay: float
    hold: bool = True
    state_noise: float = 3e-5

    @cached_property
    def offsets(self) -> tuple[int, ...]:
        """Indices of the channels whose sensor has an offset."""
        return tuple(k for k, channel in enumerate(self.channels) if channel.offset > 0.0)

    @property
    def tolerance(self) -> float:
        """Relative tolerance of the integration, which is that of the runs of the circuit."""
        return self.circuit.run.tolerance

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the free numbers: of the faults, addresses of the nuisances, and `offset of` a sensor."""
        offsets = (f"offset of {self.channels[k].address}" for k in self.offsets)
        return (*(f.name for f in self.faults), *(n.address for n in self.nuisances), *offsets)

    @cached_property
    def units(self) -> tuple[str, ...]:
        """SI units of the free numbers."""
        return (*self.free.units, *(self.channels[k].si_unit for k in self.offsets))

    @cached_property
    def reference(self) -> Array:
        """Values of the free numbers in the circuit, (m,)."""
        return np.concatenate([self.free.values, np.zeros(len(self.offsets))])

    @cached_property
    def prior(self) -> Array:
        """Prior standard deviations of the free numbers, (m,)."""
        faults = [PRIOR * fault.alarm for fault in self.faults]
        offsets = [self.channels[k].offset for k in self.offsets]
        return np.array([*faults, *(nuisance.sigma for nuisance in self.nuisances), *offsets])

    @cached_property
    def cap(self) -> Array:
        """Largest standard deviations of the free numbers, (m,).

        The random walk increases a standard deviation up to this value while the readings contain no information.
        """
        return self.prior * np.where(np.arange(self.prior.size) < len(self.faults), CAP / PRIOR, 1.0)

    @cached_property
    def _margin(self) -> Array:
        """Amount by which an estimate can exceed the limits of its parameter, (m,)."""
        return np.where(np.arange(self.prior.size) < len(self.faults), self.prior, 0.0)

    @cached_property
    def low(self) -> Array:
        """Lower limits of the estimates of the free numbers, (m,).

        The estimate of a fault can exceed the limit of its parameter by `prior`: the mean error of an estimate near the
        limit, such as a leak of zero, would otherwise not be zero, and other estimates would absorb it.
        """
        return np.concatenate([self.free.low, np.full(len(self.offsets), -math.inf)]) - self._margin

    @cached_property
    def high(self) -> Array:
        """Upper limits of the estimates of the free numbers, (m,); see `low`."""
        return np.concatenate([self.free.high, np.full(len(self.offsets), math.inf)]) + self._margin

    @cached_property
    def walk(self) -> Array:
        """Variances of the random walks of the free numbers per second, (m,).

        The standard deviation of the change of a fault within `SLOW` windows is its alarm size. The bank of onsets
        finds faster changes: with a walk that follows them, a fault would never be known well.
        """
        faults = [fault.alarm**2 / (SLOW * self.window) for fault in self.faults]
        nuisances = [nuisance.drift**2 / HOUR for nuisance in self.nuisances]
        return np.array([*faults, *nuisances, *(0.0 for _ in self.offsets)])

    @cached_property
    def _is_driven(self) -> NDArray[np.bool_]:
        """Mask of the touched inputs that samples drive, and the free numbers therefore do not."""
        return np.isin(self.free.inputs, [item.index for item in self.inputs])

    @cached_property
    def touched_inputs(self) -> Integers:
        """Indices of the inputs whose values depend on the free numbers, (j,)."""
        return self.free.inputs[~self._is_driven]

    @cached_property
    def directions(self) -> Array:
        """Derivatives of the touched parameters and inputs by the free numbers, (k + j, m)."""
        k = len(self.free.places)
        rows = np.concatenate([np.ones(k, dtype=bool), ~self._is_driven])
        return np.hstack([self.free.directions[rows], np.zeros((np.count_nonzero(rows), len(self.offsets)))])

    @cached_property
    def effects(self) -> Array:
        """Direct derivatives of the readings by the free numbers, (c, m).

        A gauge reads the difference to the ambient pressure, and an offset adds to the reading.
        """
        effects = np.zeros((len(self.channels), len(self.names)))
        for k, channel in enumerate(self.channels):
            for j, address in enumerate(self.free.addresses):
                if channel.is_gauge and address == AMBIENT:
                    effects[k, j] = -1.0
        for j, k in enumerate(self.offsets, len(self.free.addresses)):
            effects[k, j] = 1.0
        return effects


def read_plan(
    circuit: BaseCircuit,
    measured: Mapping[str, Any],
    faults: Mapping[str, Any],
    nuisances: Mapping[str, Any] | None = None,
    settings: Mapping[str, Any] | None = None,
) -> WatchPlan:
    """Read the tables of a watch, and check all values.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the values of the healthy plant.
    measured : mapping
        Table of each measured output or input: `column`, `unit`, `noise` and `offset`, or `hold` for an input.
    faults : mapping
        Table of each fault by name: `address`, `alarm` and `direction` (`up`, `down` or `both`, the default).
    nuisances : mapping, optional
        Table of each parameter that can vary: `sigma` or `relative_sigma`, and `drift` or `relative_drift`, the
        standard deviation of its change in one hour.
    settings : mapping, optional
        Fields `window`, `alarm_delay` and `hold`.

    Returns
    -------
    WatchPlan

    Raises
    ------
    InputErrors
        All errors of the tables.
    """
    tables = {"measured": measured, "faults": faults, "nuisance": nuisances or {}, "watch": settings or {}}
    return _PlanReader(circuit, tables).plan()


class _PlanReader:
    """Reader of the tables of a watch, which continues after an error and raises all errors together."""

    def __init__(self, circuit: BaseCircuit, tables: Mapping[str, Any]) -> None:
        self.circuit, self.errors = circuit, ErrorCollector()
        self.tables: dict[str, Mapping[str, Any]] = {}
        for name, table in tables.items():
            self.tables[name] = table if isinstance(table, Mapping) else {}
            if table is not self.tables[name]:
                self.errors.add("fields.no_table", name, value=table)
        self.numbers = circuit.numbers()
        sections = {"ambient": circuit.ambient, "gas": circuit.gas}
        specs: dict[str, NumberSpec] = number_specs(circuit)
        specs |= {f"{name}.{key}": spec for name, part in sections.items() for key, spec, _ in flatten(part)}
        # Fields that a part sets in its members have no number: a change of one alone would make them inconsistent.
        self.specs = {address: spec for address, spec in specs.items() if address in self.numbers}
        inputs = {item.name for item in circuit.model.inputs}
        # A noise makes the readings of an input, such as the supply pressure, measurements of an output.
        self.driven = {
            address
            for address, raw in self.tables["measured"].items()
            if address in inputs and isinstance(raw, Mapping) and "noise" not in raw
        }

    def plan(self) -> WatchPlan:
        with self.errors:
            settings = read_fields(self.errors, self.tables["watch"], SETTINGS, "watch", table="table [watch]")
            instance = self._undriven_instance()
            channels, inputs = tuple[SensorChannel, ...](), tuple[DrivenInput, ...]()
            with self.errors.collecting():
                channels, inputs = read_sensors(self.tables["measured"], instance, hold=settings.get("hold", True))
            is_ambient_free = AMBIENT in self.tables["nuisance"] or any(
                isinstance(raw, Mapping) and raw.get("address") == AMBIENT for raw in self.tables["faults"].values()
            )
            for item in inputs if is_ambient_free else ():
                if item.is_gauge:
                    self.errors.add("watch.gauge_drives", f"measured.{item.address}", unit=item.unit)
            faults = [self._fault(name, raw) for name, raw in self.tables["faults"].items()]
            nuisances = [self._nuisance(address, raw) for address, raw in self.tables["nuisance"].items()]
            if not faults and not self.errors.collected:
                self.errors.add("watch.no_fault", "faults")
        read_faults = tuple(fault for fault in faults if fault is not None)
        read_nuisances = tuple(nuisance for nuisance in nuisances if nuisance is not None)
        addresses = [*(fault.address for fault in read_faults), *(nuisance.address for nuisance in read_nuisances)]
        free = free_numbers(instance, addresses)
        return WatchPlan(self.circuit, instance, channels, inputs, read_faults, read_nuisances, free, **settings)

    def _undriven_instance(self) -> Instance:
        """Return the circuit without the signals that samples replace; collect an error for other signals."""
        signals = {a: signal for a, signal in self.circuit.signals.items() if a not in self.driven}
        for address, signal in signals.items():
            # The time of a plant has no common origin with a waveform.
            if not isinstance(signal, Constant):
                self.errors.add("watch.signal", f"signals.{address}", name=address)
        return self.circuit.with_signals(signals).instance

    def _fault(self, name: str, raw: Any) -> Fault | None:
        location, errors = f"faults.{name}", ErrorCollector()
        if not isinstance(name, str) or not NAME.fullmatch(name) or name in RESERVED:
            errors.add("watch.fault_name", location, name=name, reserved=RESERVED)
        address = raw.get("address") if isinstance(raw, Mapping) else None
        spec = self._spec(errors, address, f"{location}.address") if address is not None else None
        for other, table in self.tables["faults"].items():
            if other == name:
                break
            if spec is not None and isinstance(table, Mapping) and table.get("address") == address:
                errors.add("watch.same_address", f"{location}.address", parameter=address, other=other)
        fields = {
            "address": Field(type="string", is_required=True, meaning="address of the parameter", example=ADDRESS),
            "alarm": _difference(spec, "smallest change to report", is_required=True) if spec else Field(),
            "direction": Field(choices=tuple(DIRECTIONS), default="both", meaning="direction of the change"),
        }
        read = read_fields(errors, raw, fields, location, table="fault")
        if errors.collected or spec is None:
            self.errors.extend(errors.collected)
            return None
        return Fault(name, read["address"], spec.unit, DIRECTIONS[read["direction"]], read["alarm"])

    def _nuisance(self, address: str, raw: Any) -> Nuisance | None:
        location, errors = f"nuisance.{address}", ErrorCollector()
        spec = self._spec(errors, address, location)
        for name, fault in self.tables["faults"].items():
            if isinstance(fault, Mapping) and fault.get("address") == address:
                errors.add("watch.fault_and_nuisance", location, fault=name)
        if spec is None:
            self.errors.extend(errors.collected)
            return None
        fields = {
            "sigma": _difference(spec, "standard deviation of the parameter"),
            "relative_sigma": Field(unit="1", above=0.0, meaning="standard deviation relative to the value"),
            "drift": _difference(spec, "standard deviation of the change in one hour"),
            "relative_drift": Field(unit="1", above=0.0, meaning="standard deviation of the change in one hour"),
        }
        read = read_fields(errors, raw, fields, location, table="nuisance")
        # A relative value of a gauge pressure refers to the gauge value.
        size = abs(self.numbers[address].value)
        for key in ("sigma", "drift"):
            if key in read and f"relative_{key}" in read:
                errors.add("watch.given_twice", location, names=[key, f"relative_{key}"])
            elif f"relative_{key}" in read and size == 0.0:
                errors.add("watch.relative_to_zero", f"{location}.relative_{key}", key=key)
            elif f"relative_{key}" in read:
                read[key] = read[f"relative_{key}"] * size
        if "sigma" not in read and not errors.collected:
            example = f'sigma = "... {spec.unit}"' if spec.unit != "1" else "sigma = 0.01"
            errors.extend([missing_field(f"{location}.sigma", replace(fields["sigma"], example=example))])
        if errors.collected:
            self.errors.extend(errors.collected)
            return None
        return Nuisance(address, spec.unit, read["sigma"], read.get("drift", 0.0))

    def _spec(self, errors: ErrorCollector, address: Any, location: str) -> NumberSpec | None:
        """Return the declaration of a parameter; collect an error if samples drive it or it does not exist."""
        if address in self.driven:
            errors.add("watch.driven_and_free", location, parameter=address)
        elif address in self.specs:
            return self.specs[address]
        else:
            suggestion = NameSuggestion(str(address), self.specs)
            errors.add("names.unknown", location, meaning="a parameter of this circuit", suggestion=suggestion)
        return None


def _difference(spec: NumberSpec, meaning: str, is_required: bool = False) -> Field:
    """Return the field of a positive difference of two values of a parameter."""
    example = "" if spec.unit == "1" else f'"... {spec.unit}"'
    kind = difference_kind(spec.unit, spec.kind)
    return Field(unit=spec.unit, kind=kind, above=0.0, meaning=meaning, is_required=is_required, example=example)
