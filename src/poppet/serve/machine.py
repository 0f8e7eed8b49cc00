"""Machine: the side of a served circuit that protocols use to read values, to write inputs and to switch faults."""

from __future__ import annotations

import contextlib
import math
import threading
from collections.abc import Iterable, Mapping
from types import MappingProxyType, TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.units import quantity, sizes_of
from poppet.parts.faults import FAULTS, HEALTHY
from poppet.serve.coupled_plant import make_plant, steps_per_period
from poppet.serve.exchange import RECORDED, STATE, STOP, Exchange, ExchangeLayout
from poppet.serve.lateness import Lateness
from poppet.serve.plant import FAULT_CODES, ServedPlant, initial_commands
from poppet.serve.points import PUBLISHED_FIRST, PUBLISHED_LAST, Point, PointRole, ServedCircuit
from poppet.serve.snapshot import MachineState, PointValues, Snapshot
from poppet.timeseries.recording import Recording

Array = NDArray[np.float64]
DEFAULT_PERIOD = 0.01
"""Duration of a period, unless the user selects another one [s]."""
WORDS = (HEALTHY, *FAULTS)
"""Words of the faults in the order of their codes."""


class Machine:
    """Served circuit as protocols see it; all methods can be called by any thread.

    `Circuit.serve` starts a machine. This base class has no clock: `advance` runs its periods in the calling thread,
    for tests. The machine of `poppet serve` runs in a process of its own, see `poppet.serve.machine_process`.

    Parameters
    ----------
    served : ServedCircuit
        Circuit.
    period : float, optional
        Duration of a period [s].
    buffer : object with the buffer protocol, optional
        Block of memory for the exchange (default: one of this process).

    Attributes
    ----------
    points : tuple of Point
        Writable inputs, outputs and parameters.
    faults : mapping
        Mapping from the name of each valve to the faults that it can have.
    row_names, row_units : tuple of str
        Columns of `rows`: the time, all outputs of the circuit, and the lateness of the period.
    """

    def __init__(self, served: ServedCircuit, period: float = DEFAULT_PERIOD, buffer: Any = None) -> None:
        self.served, self.period, self.speed = served, check_period(period), math.inf
        if served.circuit.fmus:
            steps_per_period(served.circuit, period)
        self.points: tuple[Point, ...] = served.points
        self.faults: Mapping[str, tuple[str, ...]] = MappingProxyType(dict(served.faults))
        self.row_names = (PUBLISHED_FIRST, *served.columns, PUBLISHED_LAST)
        self.row_units = ("s", *served.column_units, "s")
        layout = layout_of(served)
        self.exchange = Exchange(layout, bytearray(layout.size) if buffer is None else buffer)
        self._note: Note | None = None
        self._indices = {point.address: k for k, point in enumerate(self.points)}
        self._n_inputs = len(served.writable)
        column = {address: k for k, address in enumerate(self.row_names)}
        outputs = [k for k, point in enumerate(self.points) if point.role is PointRole.OUTPUT]
        self._output_columns = np.array([column[self.points[k].address] for k in outputs], dtype=np.int64)
        self._outputs = slice(self._n_inputs, self._n_inputs + len(outputs))
        self._initial = np.array([point.initial for point in self.points])
        self._valves = {valve: self._n_inputs + k for k, valve in enumerate(served.faults)}
        self._commands = initial_commands(served)
        self._lock = threading.Lock()  # between threads of the protocols
        self.exchange.put_commands(self._commands)
        self.exchange.fields[RECORDED] = -1
        self._plant: ServedPlant | None = None
        self._last_notes = list[Note]()

    # Reading -----------------------------------------------------------------------------------------------------

    @property
    def state(self) -> MachineState:
        """State of the machine."""
        return MachineState(int(self.exchange.fields[STATE]))

    @property
    def note(self) -> Note | None:
        """Reason of a failure, or None."""
        return self._note

    def snapshot(self) -> Snapshot:
        """Return the values of all points at the last period; before the first period, outputs are NaN."""
        state = self.state
        count, row = self.exchange.last_row()
        values = self._initial.copy()
        values[: self._n_inputs] = self._commands[: self._n_inputs]
        values[self._outputs] = row[self._output_columns]
        time = float(row[0]) if count else 0.0
        n_late = self.exchange.lateness().late
        return Snapshot(time, PointValues(values, self._indices), values, count - 1, n_late, state, self.note)

    def rows(self, since: int = 0) -> tuple[int, Array]:
        """Return the rows from a number on, and the number of the first of them.

        The machine keeps the last rows only: if it has overwritten some of the requested ones, the number of the first
        row is above `since`. Continue with the number of the first row plus the number of rows.

        Parameters
        ----------
        since : int, optional
            Number of the first requested row; one row is published in each period, from 0.

        Returns
        -------
        first : int
            Number of the first row in the array.
        rows : (n, n_columns) array
            Rows with the columns `row_names`.
        """
        return self.exchange.rows(since)

    def recording(self, since: int = 0) -> Recording:
        """Return the outputs in the rows from a number on as a recording; see `rows`."""
        _, rows = self.rows(since)
        names, units = self.row_names[1:-1], self.row_units[1:-1]
        circuit = self.served.circuit
        return Recording(
            rows[:, 0], names, units, np.ascontiguousarray(rows[:, 1:-1].T), title=circuit.title,
            ambient_pressure=self.ambient_pressure,
        )  # fmt: skip

    def lateness(self) -> Lateness:
        """Return the statistics of the lateness of all periods."""
        return self.exchange.lateness()

    def fault_of(self, valve: str) -> str:
        """Return the fault of a valve, `none` or one of `faults`."""
        return WORDS[int(self._commands[self._valve(valve)])]

    # Writing -----------------------------------------------------------------------------------------------------

    def write(self, values: Mapping[str, Any], source: str = "") -> None:
        """Set inputs at the next period, all in the same one.

        Parameters
        ----------
        values : mapping
            Mapping from the address of an input to its value, in SI units or as text with a unit.
        source : str, optional
            Name of the client or protocol, for messages.

        Raises
        ------
        InputErrors
            If an address is unknown or not an input, a value is not finite or out of range, or the machine has failed
            or stopped. Nothing is written then.
        """
        self.command(values, {})

    def command(self, values: Mapping[str, Any], faults: Mapping[str, str]) -> None:
        """Set inputs and faults at the next period, all in the same one; see `write` and `set_fault`."""
        commands = self.check(values, faults)
        if not commands:
            return
        if self.state in (MachineState.FAILED, MachineState.STOPPED):
            raise InputError("serve.not_running", state=self.state.name.lower())
        with self._lock:
            # A new array: a reader of the previous one is not disturbed.
            changed = self._commands.copy()
            changed[list(commands)] = list(commands.values())
            self._commands = changed
            self.exchange.put_commands(changed)

    def check(self, values: Mapping[str, Any], faults: Mapping[str, str]) -> Mapping[int, float]:
        """Check inputs and faults as `command` does, and return their values by index, but set nothing."""
        commands: dict[int, float] = {}
        with ErrorCollector() as errors:
            for address, argument in values.items():
                with errors.collecting():
                    k = self._indices.get(address)
                    if k is None:
                        raise _unknown(address, self.served.writable, "an input of this circuit")
                    if self.points[k].role is not PointRole.INPUT:
                        raise self._not_writable(self.points[k])
                    commands[k] = self._read(self.points[k], argument)
            for valve, fault in faults.items():
                with errors.collecting():
                    k = self._valve(valve)
                    commands[k] = self._fault_code(valve, fault)
        return commands

    def _read(self, point: Point, argument: Any) -> float:
        """Return the value of an input in SI units, if it is in the range of the input."""
        value = math.nan
        # A truth value is a command, such as that of a valve, but no pressure.
        if isinstance(argument, int | float) and (point.high == 1.0 or not isinstance(argument, bool)):
            with contextlib.suppress(OverflowError):  # an integer with hundreds of digits
                value = float(argument)
        if not math.isfinite(value):
            item = self.served.circuit.inputs.get(point.address)
            kind: Any = "plain" if item is None else item.kind
            text = str(argument) if type(argument) is int else argument
            read = quantity(text, point.unit, kind=kind, name=point.address)
            value = read.value + (self.ambient_pressure if read.reference == "gauge" else 0.0)
        if not point.low <= value <= point.high:
            facts: dict[str, Any] = {"given": argument, "low": point.low, "high": point.high, "unit": point.unit}
            raise InputError("inputs.outside", point.address, **facts)
        if abs(value) > (most := sizes_of(point.unit)[1]):
            raise OutOfRangeError("quantity.too_large", point.address, shown=str(argument), most=most, unit=point.unit)
        return value

    def _not_writable(self, point: Point) -> InputError:
        """Return the error of a point that cannot be written."""
        item = self.served.circuit.inputs.get(point.address)
        if item is not None and not item.is_coupled:
            return InputError("serve.driven", point.address)
        suggestion = NameSuggestion(point.address, self.served.writable)
        return InputError("serve.not_writable", point.address, role=point.role.value, suggestion=suggestion)

    @property
    def ambient_pressure(self) -> float:
        """Absolute pressure to which gauge values refer [Pa]."""
        return float(self.served.circuit.surroundings.pressure)

    def set_fault(self, valve: str, fault: str) -> None:
        """Set the fault of a valve at the next period.

        Parameters
        ----------
        valve : str
            Name of a valve, a key of `faults`.
        fault : str
            One of its possible faults, or `none` to end the fault.

        Raises
        ------
        InputError
            If the valve is unknown or cannot have the fault.
        """
        self.command({}, {valve: fault})

    def _fault_code(self, valve: str, fault: str) -> float:
        possible = (HEALTHY, *self.faults[valve])
        if fault not in possible:
            facts: dict[str, Any] = {
                "value": fault,
                "meaning": "fault",
                "suggestion": NameSuggestion(str(fault), possible),
            }
            raise InputError("fields.not_an_option", f"{valve}.fault", **facts)
        return FAULT_CODES[fault]

    def _valve(self, name: str) -> int:
        if name not in self._valves:
            raise _unknown(name, self._valves, "a valve of this circuit")
        return self._valves[name]

    # Run ---------------------------------------------------------------------------------------------------------

    def advance(self, duration: Any) -> Snapshot:
        """Run the machine for a duration, and return the values at its end.

        Parameters
        ----------
        duration : float or str
            Duration [s], which is rounded to whole periods.

        Returns
        -------
        Snapshot

        Raises
        ------
        InputError
            If the machine runs by a clock of its own.
        """
        seconds = quantity(duration, "s", name="duration").value
        if self._plant is None:
            self._plant = make_plant(self.served, self.period)
            self.exchange.fields[STATE] = MachineState.RUNNING.value
            self._loop = PeriodLoop(self._plant, self.exchange)
            self._loop.publish(0.0)
        for _ in range(round(seconds / self.period)):
            if self.state is not MachineState.RUNNING:
                break
            if self._loop.advance():
                self._loop.publish(0.0)
            else:
                self._note = self._plant.failure
                self.exchange.fields[STATE] = MachineState.FAILED.value
        return self.snapshot()

    def request_stop(self) -> None:
        """Request the end of the machine without waiting for it; its state becomes STOPPED."""
        self.stop()

    @property
    def is_stopping(self) -> bool:
        """True if the end of the machine was requested."""
        return bool(self.exchange.fields[STOP])

    def take_notes(self) -> list[Note]:
        """Return the notes on the clock and, after the end, on the accuracy, since the last call."""
        notes, self._last_notes = self._last_notes, []
        return notes

    def stop(self) -> None:
        """Stop the machine. Its last values remain readable."""
        if self._plant is not None and not self.is_stopping:
            self._last_notes += self._plant.notes()
            self._plant.close()
        self.exchange.fields[STOP] = 1
        if self.state in (MachineState.RUNNING, MachineState.STARTING):
            self.exchange.fields[STATE] = MachineState.STOPPED.value

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()


class PeriodLoop:
    """Periods of a plant: reads the commands, publishes the outputs, integrates.

    Parameters
    ----------
    plant : ServedPlant
        Model.
    exchange : Exchange
        Exchange with the protocols.
    """

    def __init__(self, plant: ServedPlant, exchange: Exchange) -> None:
        self._plant, self._exchange = plant, exchange
        self._commands, self._version = np.zeros(exchange.layout.n_commands), 0
        self._row = np.zeros(exchange.layout.n_columns)
        self._version = exchange.take_commands(self._commands, 0)

    def publish(self, lateness: float) -> None:
        """Begin a period: apply the commands, and publish the outputs at this time."""
        self._version = self._exchange.take_commands(self._commands, self._version)
        self._plant.begin(self._commands)
        self._row[0], self._row[1:-1], self._row[-1] = self._plant.t, self._plant.outputs, lateness
        self._exchange.publish(self._row)

    def advance(self) -> bool:
        """Integrate to the end of the period, and return False after a failure."""
        self._plant.advance()
        return self._plant.failure is None


def layout_of(served: ServedCircuit) -> ExchangeLayout:
    """Return the sizes of the exchange of a circuit."""
    return ExchangeLayout(len(served.writable) + len(served.faults), len(served.columns) + 2)


def check_period(period: float) -> float:
    """Return a period if it is a positive, finite duration [s]."""
    if not 0.0 < period < math.inf:
        raise InputError("serve.period", "period", value=period)
    return period


def _unknown(name: str, names: Iterable[str], meaning: str) -> InputError:
    return InputError("names.unknown", name, meaning=meaning, suggestion=NameSuggestion(name, names))
