"""Sensors of a running plant: measured outputs, and measured inputs that drive the circuit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.circuit.instance import Instance
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.tables import Field, read_fields
from poppet.core.units import Kind, convert, exact_scale, same_dimension, with_state
from poppet.timeseries.measurements.mapping import DIFFERENCE_KINDS

COLUMN = Field(type="string", meaning="name of the column or key of the readings")
UNIT = Field(type="string", meaning="unit of the readings")
GATE = 3.3
"""Default of the field `gate`: one reading of a thousand is outside."""


@dataclass(frozen=True)
class Readings:
    """Column of a recording or a stream, and the conversion of its values to SI.

    Parameters
    ----------
    address : str
        Address of an output or an input of the circuit.
    column : str
        Name of the column, or key of the samples.
    unit : str
        Unit of the readings.
    si_unit : str
        Unit of the output or the input in the circuit.
    scale, shift : float
        A reading r is `scale * r + shift` in SI. The shift of a gauge pressure is the ambient pressure.
    is_gauge : bool
        True if the readings are gauge pressures.
    """

    address: str
    column: str
    unit: str
    si_unit: str
    scale: float
    shift: float
    is_gauge: bool

    def to_si(self, reading: float) -> float:
        """Return a reading in SI, with an absolute pressure for a gauge pressure."""
        return self.scale * reading + self.shift

    def from_si(self, value: float) -> float:
        """Return the reading in the unit of the column for a value in SI."""
        return (value - self.shift) / self.scale


@dataclass(frozen=True)
class SensorChannel(Readings):
    """Sensor of an output of the circuit.

    Parameters
    ----------
    noise : float
        Standard deviation of one reading, without a common offset [SI].
    offset : float
        Standard deviation of the constant offset of the sensor [SI]; 0 if the sensor has no offset.
    gate : float
        Deviation from the expected reading above which a single reading is an outlier, in standard deviations.
    """

    noise: float
    offset: float = 0.0
    gate: float = GATE


@dataclass(frozen=True)
class DrivenInput(Readings):
    """Input of the circuit that the readings of a sensor, or the samples of a command, drive.

    Parameters
    ----------
    index : int
        Index in the input vector u.
    low, high : float
        Limits of the input [SI].
    delay : float
        Time from a sample to its effect in the circuit [s].
    hold : bool
        True if the input is constant until the next sample. Otherwise it changes linearly to the next sample.
    """

    index: int
    low: float
    high: float
    delay: float
    hold: bool


def read_sensors(
    measured: Mapping[str, Any], instance: Instance, *, hold: bool = True
) -> tuple[tuple[SensorChannel, ...], tuple[DrivenInput, ...]]:
    """Read the table of the measured quantities.

    A quantity with a noise is a sensor of an output. An input of the circuit without a noise drives the circuit.

    Parameters
    ----------
    measured : mapping
        Table of each measured address with the fields `column`, `unit`, `noise` and `offset`, or `hold` for an input.
    instance : Instance
        Circuit without the signals that the inputs replace.
    hold : bool, optional
        Default of the field `hold`.

    Returns
    -------
    tuple of sensors and driven inputs

    Raises
    ------
    InputErrors
        All errors of the table.
    """
    outputs = dict(instance.model.outputs)
    inputs = {item.name: k for k, item in enumerate(instance.model.inputs) if not item.slope_of}
    channels: list[SensorChannel] = []
    driven: list[DrivenInput] = []
    with ErrorCollector() as errors:
        for address, raw in measured.items():
            location = f"measured.{address}"
            if address not in outputs and address not in inputs:
                if (
                    isinstance(raw, Mapping) and "." not in address
                ):  # TOML reads tank.pressure without quotes as a table
                    errors.add("watch.unquoted", location, key=address)
                    continue
                suggestion = NameSuggestion(address, {**outputs, **inputs})
                meaning = "an output or input of this circuit"
                errors.add("names.unknown", location, meaning=meaning, suggestion=suggestion)
                continue
            if not isinstance(raw, Mapping):
                errors.add("fields.no_table", location, value=raw)
                continue
            with errors.collecting():
                if address in inputs and ("noise" not in raw or address not in outputs):
                    driven.append(_driven_input(address, raw, location, instance, inputs[address], hold))
                else:
                    channels.append(_channel(address, raw, location, outputs[address], instance))
        _check_columns(errors, measured)
        if not channels and not errors.collected:
            errors.add("watch.no_sensor", "measured")
    return tuple(channels), tuple(driven)


def difference_kind(unit: str, kind: Kind = "plain") -> Kind:
    """Return the kind of a difference of two quantities with a unit; `kind` is the kind of the quantities."""
    return DIFFERENCE_KINDS.get(unit, kind)


def _channel(address: str, raw: Mapping[str, Any], location: str, unit: str, instance: Instance) -> SensorChannel:
    deviation = Field(unit=unit, kind=difference_kind(unit), above=0.0, meaning="standard deviation of the noise")
    fields = {
        "column": COLUMN,
        "unit": UNIT,
        "noise": Field(**{**vars(deviation), "is_required": True, "example": 'noise = "5 mbar"'}),
        "offset": Field(**{**vars(deviation), "meaning": "standard deviation of the offset of the sensor"}),
        "gate": Field(unit="1", low=2.0, default=GATE, meaning="deviation of an outlier in standard deviations"),
    }
    with ErrorCollector() as errors:
        read = read_fields(errors, raw, fields, location, table="sensor")
        readings = _readings(errors, address, read, location, unit, instance.surroundings.pressure)
    return SensorChannel(**readings, noise=read["noise"], offset=read.get("offset", 0.0), gate=read["gate"])


def _driven_input(
    address: str, raw: Mapping[str, Any], location: str, instance: Instance, index: int, hold: bool
) -> DrivenInput:
    fields = {"column": COLUMN, "unit": UNIT, "hold": Field(type="boolean", default=hold)}
    item, parameters = instance.model.inputs[index], instance.parameters
    with ErrorCollector() as errors:
        read = read_fields(errors, raw, fields, location, table="driven input")
        readings = _readings(errors, address, read, location, item.unit, instance.surroundings.pressure)
    low, high = (parameters[limit] if isinstance(limit, str) else limit for limit in (item.low, item.high))
    delay = parameters[item.delay] if item.delay else 0.0
    return DrivenInput(**readings, index=index, low=low, high=high, delay=delay, hold=read["hold"])


def _readings(
    errors: ErrorCollector, address: str, read: Mapping[str, Any], location: str, si_unit: str, ambient_pressure: float
) -> dict[str, Any]:
    """Return the fields of `Readings`; collect the error of a unit that cannot be converted."""
    unit = with_state(read.get("unit", si_unit))
    with errors.collecting():
        try:
            convert(0.0, unit, si_unit)
        except InputError as problem:
            raise problem.at(f"{location}.unit") from None
    if not same_dimension(unit, si_unit):
        return {}
    scale, is_gauge = exact_scale(unit)
    # A reading in degC has an offset; a gauge pressure has the ambient pressure.
    shift = float(scale.offset * scale.scale) + (ambient_pressure if is_gauge else 0.0)
    return {
        "address": address,
        "column": read.get("column", address),
        "unit": unit,
        "si_unit": si_unit,
        "scale": float(scale.scale),
        "shift": shift,
        "is_gauge": is_gauge,
    }


def _check_columns(errors: ErrorCollector, measured: Mapping[str, Any]) -> None:
    """Collect an error for each column that two quantities share."""
    owners: dict[str, str] = {}
    for address, raw in measured.items():
        column = raw.get("column", address) if isinstance(raw, Mapping) else address
        if isinstance(column, str) and owners.setdefault(column, address) != address:
            errors.add("watch.same_column", f"measured.{address}.column", column=column, other=owners[column])
