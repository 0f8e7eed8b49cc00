"""Class `BaseCircuit`: named parts, signals and run options, with the model that they define."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterator, Mapping
from dataclasses import InitVar, dataclass, field, fields, replace
from functools import cached_property, partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np

from poppet.circuit.addresses import change_values
from poppet.circuit.component_files import with_own_components
from poppet.circuit.ideal_gas import real_gas_notes
from poppet.circuit.instance import Array, Drive, Instance, Series
from poppet.circuit.onset import ONSET, check_onsets, onset_inputs
from poppet.circuit.options import ABOUT_CONDUCTANCES, Ambient, GasChoice, Run
from poppet.circuit.placed_part import PlacedPart, signal_notes, value_notes
from poppet.circuit.trace import SURROUNDINGS
from poppet.circuit.wiring import (
    PartWiring,
    check_bodies,
    check_connections,
    check_kinds,
    check_signals,
    check_starts,
    check_wiring,
    connect_tube_cells,
    find_drives,
    merge_connections,
    part_connections,
)
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, SimulationError
from poppet.core.notebook import HtmlMixin
from poppet.core.provenance import Number
from poppet.core.units import counted_at
from poppet.engine.lru_cache import LruCache
from poppet.library import Gas
from poppet.parts.compound import number_spec
from poppet.parts.part import Controller, Input, Part, PartConnection, Store, Surroundings
from poppet.timeseries.signals import Signal

if TYPE_CHECKING:
    from poppet.circuit.linear_model import LinearModel, SteadyState
    from poppet.engine.kernel import Kernel
    from poppet.engine.model import Model
    from poppet.engine.problem import Problem
    from poppet.parts.fmu import FMU
    from poppet.timeseries.recording import Recording

_SECTIONS = ("ambient", "gas", "run")
RUNS = 4
"""Number of run options for which the arrays of a run are cached."""
MODELS: LruCache[Model] = LruCache(8)
"""Symbolic models by structure."""


class Origin(NamedTuple):
    """Circuit file from which a circuit was read: its tables and its folder.

    Relative paths in the file refer to this folder.
    """

    tables: Mapping[str, Any]
    folder: Path


@dataclass(frozen=True, eq=False)
class BaseCircuit(HtmlMixin):
    """Network of parts with wiring checks, model, runs and steady states.

    Parameters
    ----------
    parts, signals, run, ambient, gas, title, connections, origin : optional
        The subclass `poppet.Circuit`, which adds the methods of other packages, describes these arguments.
    is_excerpt : bool, optional
        True if the parts belong to a larger circuit. Inputs that absent parts drive are then free.
    like : Circuit, optional
        Similar circuit. Parts that are the same objects in both circuits are not checked again.

    Raises
    ------
    InputErrors
        If the wiring is invalid. The exception contains all errors.
    """

    parts: Mapping[str, Part]
    signals: Mapping[str, Signal] = field(default_factory=dict)
    run: Run = field(default_factory=Run)
    ambient: Ambient = field(default_factory=Ambient)
    gas: GasChoice = field(default_factory=GasChoice)
    title: str = ""
    connections: Mapping[str, str] = field(default_factory=dict)
    origin: Origin = field(default=Origin({}, Path()), repr=False)
    is_excerpt: bool = field(default=False, repr=False, kw_only=True)
    like: InitVar[BaseCircuit | None] = None

    _placed: Mapping[str, PlacedPart] = field(init=False, repr=False)
    _declared: Mapping[str, PartConnection] = field(init=False, repr=False)
    _drive: Drive = field(init=False, repr=False)
    _problems: LruCache[Problem] = field(init=False, repr=False)

    def __post_init__(self, like: BaseCircuit | None) -> None:
        if isinstance(self.gas, Gas):
            object.__setattr__(self, "gas", GasChoice.of(self.gas))
        # First: the code below relies on the declared types of the fields.
        check_kinds(self)
        # Copies: the caller can change its mappings, a circuit is immutable.
        object.__setattr__(self, "parts", MappingProxyType(connect_tube_cells(self.parts)))
        if not isinstance(self.signals, MappingProxyType):
            object.__setattr__(self, "signals", MappingProxyType(dict(self.signals)))
        object.__setattr__(self, "connections", self._all_connections(like))
        # Gauge values of parts depend on the surroundings: parts are reused only if the surroundings are equal.
        reusable = like._placed if like is not None and like.surroundings == self.surroundings else {}
        placed: dict[str, PlacedPart] = {}
        with ErrorCollector() as errors:
            for name, part in self.parts.items():
                if name in reusable and reusable[name].part is part:
                    placed[name] = reusable[name]
                    continue
                with errors.collecting(name):
                    placed[name] = PlacedPart.of(name, part, self.surroundings)
        has_same_signals = like is not None and like.signals is self.signals
        # The dataclass is frozen.
        for attribute, value in {"_placed": placed, "_problems": LruCache(RUNS)}.items():
            object.__setattr__(self, attribute, value)
        onsets = onset_inputs(self.inputs, self.signals, self.connections)
        driven = {**self.signals, **dict.fromkeys(onsets, ONSET)}
        is_reusable = has_same_signals and like is not None and like._drive.signals.keys() == driven.keys()
        drive = like._drive if like is not None and is_reusable else Drive(driven)
        object.__setattr__(self, "_drive", drive)
        checked = {name for name in placed if has_same_signals and placed[name] is reusable.get(name)}
        with ErrorCollector() as errors:
            # A fit creates many circuits with the same wiring, which is checked once.
            is_same = like is not None and like._wiring == self._wiring and like.connections is self.connections
            if not is_same:
                check_wiring(errors, self._wiring)
                check_bodies(errors, self._wiring)
            if not is_same or not has_same_signals:
                check_connections(
                    errors, self.connections, self.parts, self.inputs, self.signals, self._declared
                )  # fmt: skip
            check_starts(errors, self.parts, self.signals)
            signals = {a: signal for a, signal in self.signals.items() if a.partition(".")[0] not in checked}
            check_signals(errors, signals, self.inputs, self.parameters, self.parts)
            check_onsets(errors, self.inputs, {*self.signals, *self.connections}, self.parameters)
        # Parts name outputs, whose names and units only the model contains.
        if self._declared and (like is None or like.structure != self.structure):
            _ = self.symbolic_model

    def _all_connections(self, like: BaseCircuit | None) -> Mapping[str, str]:
        """Return the connections of the user, and the connections that parts declare.

        The result is the object of the circuit `like` if the connections are unchanged.
        """
        declared = part_connections(self.parts)
        object.__setattr__(self, "_declared", declared)
        given = self.connections
        if like is not None and like.connections is given:
            if like._declared == declared:
                return given
            # The parts have changed: their previous connections no longer apply.
            given = {t: s for t, s in given.items() if t not in like._declared or like._declared[t].source != s}
        if not declared and isinstance(given, MappingProxyType):
            return given
        return MappingProxyType(merge_connections(given, declared, self.parts, is_excerpt=self.is_excerpt))

    def __reduce__(self) -> tuple[Any, ...]:
        # Copies and other processes get only the fields and derive the rest.
        values = {f.name: getattr(self, f.name) for f in fields(self) if f.init}
        plain: dict[str, Any] = {k: dict(v) if isinstance(v, MappingProxyType) else v for k, v in values.items()}
        return partial(type(self), **plain), ()

    def __repr__(self) -> str:
        lines = [f"Circuit {self.title!r}: {len(self.parts)} parts"]
        width = max(map(len, self.parts))
        for name, part in self.parts.items():
            ports = ", ".join(f"{port}={store}" for port, store in part.ports().items())
            lines.append(f"  {name:<{width}}  {type(part).__name__} {ports}".rstrip())
        return "\n".join([*lines, *(f"  driven: {address}" for address in self.signals)])

    # Contents ----------------------------------------------------------------------------------------------------

    @cached_property
    def surroundings(self) -> Surroundings:
        """Ambient pressure and temperature, and properties of the gas, as floats in SI."""
        pressure, temperature = float(self.ambient.pressure), float(self.ambient.temperature)  # type: ignore[arg-type]
        return Surroundings(pressure, temperature, *self.gas.values())

    @cached_property
    def parameters(self) -> dict[str, float]:
        """Mapping from the address of each parameter to its value in a run.

        The values are in SI units, and pressures are absolute.
        """
        values = {address: value for part in self._placed.values() for address, value in part.parameters.items()}
        s = self.surroundings
        # Includes the factors of the gas on C and b, which no section of the file contains.
        return values | dict(zip(SURROUNDINGS, (getattr(s, f.name) for f in fields(s)), strict=True))

    def numbers(self) -> dict[str, Number]:
        """Return a mapping from addresses to values with unit and source.

        Returns
        -------
        dict
            Parts in file order, then the surroundings.
        """
        return {a: n for part in self._placed.values() for a, n in part.numbers.items()} | self._shared_numbers()

    def _shared_numbers(self) -> dict[str, Number]:
        sections = {"ambient": self.ambient, "gas": self.gas}
        return {f"{name}.{key}": n for name, section in sections.items() for key, n in section.numbers().items()}

    @cached_property
    def inputs(self) -> dict[str, Input]:
        """Mapping from the address of each input to its declaration.

        Inputs that are connected to an output are included.
        """
        return {address: item for part in self._placed.values() for address, item in part.inputs.items()}

    @cached_property
    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        """Characteristic and end stops of each stroke with a limited domain, by address.

        The domain is the range of strokes for which a characteristic is valid. The end stops are the lowest and the
        highest position of the stroke.
        """
        return {address: curve for part in self._placed.values() for address, curve in part.domains.items()}

    @cached_property
    def inner(self) -> frozenset[str]:
        """Addresses of the internal outputs, which figures omit by default."""
        return frozenset(self.connections).union(*(part.inner for part in self._placed.values()))

    @property
    def _wiring(self) -> dict[str, PartWiring]:
        return {name: part.wired for name, part in self._placed.items()}

    def drives(self) -> dict[str, dict[str, bool]]:
        """Return the inputs that can move each body, by body.

        The inner mapping contains the addresses of inputs that a signal, a sequence or a switch drives. A value is True
        if the input is a command, and False otherwise, for example for a load.
        """
        switched = {
            target for target, source in self.connections.items() if self.parts[source.partition(".")[0]].is_switching
        }
        driven = {a: item for a, item in self.inputs.items() if a in self.signals or a in switched}
        found = find_drives(self._wiring, self.connections, driven)
        return {body: {address: driven[address].is_command for address in drives} for body, drives in found.items()}

    @cached_property
    def structure(self) -> Hashable:
        """Hashable key that determines the equations of the circuit.

        The key contains kinds, options, names and connections of the parts, but no parameter values. Circuits with
        equal keys share one compiled model.
        """
        parts = tuple(part.structure for part in self._placed.values())
        return parts, tuple(sorted(self.connections.items()))

    @cached_property
    def static_notes(self) -> tuple[Note, ...]:
        """Notes that are known before a run.

        They concern the values of parameters, the signals and the gas. Every result of the circuit contains them.
        """
        placed = self._placed.values()
        gas_notes = self.gas.notes()
        # Areas, Kv, Cv and nominal flows do not depend on the gas of the measurement.
        if not any(number.unit == "m^3/(s Pa)" for part in placed for number in part.numbers.values()):
            gas_notes = tuple(note for note in gas_notes if note.code not in ABOUT_CONDUCTANCES)

        def initial_value(address: str) -> Array:
            name, _, quantity = address.partition(".")
            values = self._placed[name].parameters
            return np.array([values.get(f"{name}.initial_{quantity}", values.get(address, 0.0))])

        notes = [*gas_notes, *self._real_gas_notes(initial_value), *(note for part in placed for note in part.notes)]
        # Values of air in a circuit with another gas: volume flows at ANR and heat transfer laws.
        for address, number in {} if self.gas.is_air else self.numbers().items():
            if number.unit == "kg/s" and counted_at(number.text):
                notes.append(Note("gas.volume_of_air", address, shown=number.text, mass_flow_rate=number.value))
        gas = self.gas.of_library()
        for name, part in self.parts.items() if gas is None or not gas.is_like_air else ():
            law, thermal = (part.options().get(key, "") for key in ("heat_transfer", "thermal"))
            if thermal == "energy" and law not in ("", "constant"):
                notes.append(Note("gas.heat_as_of_air", f"{name}.heat_transfer", law=law))
        notes += [*value_notes(self._shared_numbers()), *signal_notes(self.signals, self.inputs)]
        # Controllers whose measured input has neither a signal nor a connection.
        for name, part in self.parts.items():
            for local in part.measured if isinstance(part, Controller) else ():
                address = f"{name}.{local}"
                if address not in self.signals and address not in self.connections:
                    item = self.inputs[address]
                    value = self.parameters[f"{name}.{item.default}"] if isinstance(item.default, str) else item.default
                    notes.append(Note("circuit.uncontrolled", address, value=value, unit=item.unit))
        # Commands that drive nothing. A controller without a circuit has no connections.
        sources = set(self.connections.values())
        is_machine = not all(isinstance(part, Controller) for part in self.parts.values())
        for name, part in self.parts.items() if is_machine else ():
            unused = [f"{name}.{local}" for local in part.commands()] if isinstance(part, Controller) else []
            notes += [Note("sequence.unused_output", address) for address in unused if address not in sources]
        # Connected outputs whose range exceeds the limits of the input.
        for target, source, low, high in self._limited_connections():
            lowest, highest = self._output_range(source) or (low, high)
            if lowest < low or highest > high:
                facts = {"source": source, "lowest": lowest, "highest": highest, "low": low, "high": high}
                notes.append(Note("circuit.limited_input", target, unit=self.inputs[target].unit, **facts))
        return tuple(notes)

    def _output_range(self, source: str) -> tuple[float, float] | None:
        """Return the range of an output or a recorded input, or None if it is not limited."""
        name, _, local = source.partition(".")
        ends = self.parts[name].output_ranges().get(local) if name in self.parts else None
        if source in self.inputs:
            ends = self.inputs[source].low, self.inputs[source].high
        if ends in (None, (-math.inf, math.inf)):
            return None
        low, high = (
            (-1.0 if end[0] == "-" else 1.0) * self.parameters[f"{name}.{end.lstrip('-')}"]
            if isinstance(end, str)
            else end
            for end in ends or ()
        )
        return low, high

    def _limited_connections(self) -> Iterator[tuple[str, str, float, float]]:
        """Yield target, source and limits of each connection to an input with limits."""
        for target, source in self.connections.items():
            item, owner = self.inputs[target], target.rpartition(".")[0]
            low, high = (
                self.parameters.get(f"{owner}.{end}", math.nan) if isinstance(end, str) else end
                for end in (item.low, item.high)
            )
            if low > -math.inf or high < math.inf:
                yield target, source, low, high

    def _real_gas_notes(self, series: Series) -> Iterator[Note]:
        """Yield notes on volumes in which the gas deviates considerably from an ideal gas.

        The function `series` returns the values of an output over time for its address.
        """
        gas = self.gas.of_library()
        for name, part in self.parts.items():
            if gas is not None and isinstance(part, Store):
                yield from real_gas_notes(name, series(f"{name}.pressure"), series(f"{name}.temperature"), gas)

    # Variants ----------------------------------------------------------------------------------------------------

    def with_values(self, values: Mapping[str, Any]) -> Self:
        """Return a copy of the circuit with other values or options.

        Parameters
        ----------
        values : mapping
            Mapping from address to value, text with unit or `Number`: ``{"tank.volume": "0.1 m^3"}``.

        Returns
        -------
        Circuit
            A new circuit; this one is unchanged.

        Raises
        ------
        InputError
            If an address is unknown or a value is invalid.
        """
        sections = {name: getattr(self, name) for name in _SECTIONS}
        if isinstance(values, Mapping):
            values = with_own_components(values, *self.origin)
        changed = change_values({**self.parts, **sections}, values)
        parts = {name: changed[name] for name in self.parts}
        return replace(self, parts=parts, like=self, **{name: changed[name] for name in _SECTIONS})

    def with_signals(self, signals: Mapping[str, Signal]) -> Self:
        """Return a copy of the circuit in which the given signals replace all previous signals.

        Parameters
        ----------
        signals : mapping
            Mapping from the address of an input to a signal in SI units.
        """
        return replace(self, signals=signals, like=self)

    def resumed(self, recording: Recording) -> Self:
        """Return a copy of the circuit that starts in the final state of a recording.

        Parameters
        ----------
        recording : Recording
            Recording that contains a series for each state, in any unit.

        Returns
        -------
        Circuit
            Copy of the circuit. Signals and clocks restart at t = 0. Other discrete states, such as the integral of a
            controller, start with the last values in the recording.

        Raises
        ------
        InputError
            If the recording lacks the series of a state, or the circuit has a discrete state that a recording does not
            contain, for example a counter of a step sequence.
        """
        if not hasattr(recording, "names"):
            raise InputError("circuit.no_recording", value=recording)
        for name, part in self.parts.items():
            if counters := part.lost_at_resume():
                raise InputError("sequence.no_resume", name, counters=list(counters))
        # Only parts with states or discrete states have initial values.
        targets = {
            f"{name}.{output}": (name, target)
            for name, part in self.parts.items()
            for output, target in part.resume.items()
            if (part.states() or part.memory()) and part.can_resume(target)
        }
        missing = [address for address in targets if address not in recording]
        if missing or not recording.time.size:
            code = "circuit.no_series" if missing else "circuit.no_rows"
            title = recording.title or "a recording"
            raise InputError(code, title=title, missing=missing, names=recording.names)
        if not targets:
            return self
        units = dict(self.model.outputs)
        last = recording.select(targets).converted({address: units[address] for address in targets}).last()
        values = {}
        for address, (name, key) in targets.items():
            spec, value = number_spec(self.parts[name], key), last[address]
            # The error of the integrator can move a state slightly beyond its limits.
            limited = min(max(value, spec.low), spec.high)
            is_close = abs(value - limited) <= 1e-6 * (abs(limited) + spec.high - spec.low)
            values[f"{name}.{key}"] = limited if is_close else value
        return self.with_values(values)

    # Model -------------------------------------------------------------------------------------------------------

    @property
    def kernel(self) -> Kernel:
        """Compiled model of the circuit.

        The model is compiled when it is first needed. Circuits that differ only in values share one kernel.
        """
        from poppet.engine.kernel import KERNELS, compile_kernel

        # Circuits that differ only in values have the same structure and share the kernel.
        return KERNELS.get(self.structure, lambda: compile_kernel(self.symbolic_model))

    @cached_property
    def symbolic_model(self) -> Model:
        """Symbolic model of the circuit, for which no machine code is compiled."""
        from poppet.circuit.trace import trace

        # A circuit that is edited is read again and again, mostly with the same structure.
        return MODELS.get(self.structure, lambda: trace(self.parts, tuple(self.parameters), self.connections))

    @property
    def model(self) -> Model:
        """Symbolic model: states, inputs, parameters, outputs and their expressions."""
        return self.kernel.model

    @cached_property
    def instance(self) -> Instance:
        """Compiled model with the parameter values and signals of this circuit."""
        return self.instance_of(self.kernel)

    def instance_of(self, kernel: Kernel) -> Instance:
        """Return the parameter values and signals of this circuit with another kernel of its model."""
        self.require_equations()
        return self._instance_of(kernel)

    def require_equations(self) -> None:
        """Raise an error if the circuit has an FMU, whose equations are not accessible."""
        for name in self.fmus:
            raise InputError("fmu.unavailable", f"parts.{name}")

    @cached_property
    def unguarded_instance(self) -> Instance:
        """Compiled model whose inputs include the outputs of FMUs, for a co-simulation."""
        return self._instance_of(self.kernel)

    @cached_property
    def fmus(self) -> dict[str, FMU]:
        """Mapping from names to those parts that are FMUs."""
        return {name: part for name, part in self.parts.items() if part.kind == "fmu"}  # type: ignore[misc]

    def _instance_of(self, kernel: Kernel) -> Instance:
        placed = self._placed.values()
        return Instance(
            kernel=kernel,
            parameters=self.parameters,
            drive=self._drive,
            surroundings=self.surroundings,
            circuit=self,
            title=self.title,
            notes=self.static_notes,
            domains=self.domains,
            initial={output: number for part in placed for output, number in part.initial.items()},
            inner=self.inner,
            sources={address: number for part in placed for address, number in part.numbers.items()},
            bodies={name: body for name, part in self._wiring.items() if (body := part.acts_on(name)) is not None},
        )

    def result_notes(self, series: Series) -> Iterator[Note]:
        """Yield notes on the results of a run, concerning the gas and the parts.

        Parameters
        ----------
        series : callable
            Function from the address of an output, or `time`, to its values at the rows of the run.
        """
        yield from self._real_gas_notes(series)
        # The names do not need machine code.
        outputs = {name for name, _ in self.symbolic_model.outputs}
        for target, source, low, high in self._limited_connections():
            if source in outputs:
                values = series(source)
                excess = np.maximum(low - values, values - high)
                size = max(abs(end) for end in (low, high) if math.isfinite(end)) or 1.0
                rows = np.flatnonzero(excess > 1e-9 * size)
                if rows.size:
                    time, k = float(series("time")[rows[0]]), int(np.nanargmax(excess))
                    facts = {"source": source, "time": time, "value": float(values[k]), "low": low, "high": high}
                    yield Note("circuit.saturated", target, unit=self.inputs[target].unit, **facts)
        for name, part in self.parts.items():
            for remark in part.remarks(name, series):
                yield remark.within(name)

    def problem(self, run: Run) -> Problem:
        """Return the data of one run as arrays for `poppet.engine.solve.solve`.

        Parameters
        ----------
        run : Run
            Run options with a duration.

        Returns
        -------
        Problem
        """
        return self._problems.get(run, lambda: self.instance.problem(run))

    def run_data(self, run: Run) -> Problem:
        """Return the data of a simulation, which a circuit with an FMU has too.

        The outputs of FMUs are inputs in it.
        """
        return self._problems.get(run, lambda: self.unguarded_instance.problem(run)) if self.fmus else self.problem(run)

    # Analyses ----------------------------------------------------------------------------------------------------

    def simulate(
        self,
        duration: Any = None,
        output_step: Any = None,
        relative_tolerance: float | None = None,
        *,
        stop_when: Any = None,
        solver: str | None = None,
        start: Recording | None = None,
        progress: Callable[[float], Any] | None = None,
        throw: bool = True,
        allow_native: bool = False,
    ) -> Recording:
        """Simulate the circuit over a period and return the recording.

        Parameters
        ----------
        duration : float or str, optional
            Duration [s] (default: duration in the run options).
        output_step : float or str, optional
            Time between rows [s] (default: a thousandth of the duration).
        relative_tolerance : float, optional
            Relative tolerance of the solver (default: 1e-6). The error of the results is at most about ten times this
            value.
        stop_when : str or list of str, optional
            Conditions that end the run early, for example `tank.pressure > 5 bar`.
        solver : str, optional
            `rosenbrock`; or `cvodes`, `lsoda`, `bdf`, `radau` to check the result.
        start : Recording, optional
            Recording whose last row is the initial state.
        progress : callable, optional
            Function that is called with the time reached [s]. If it is given, Ctrl-C ends the run with a partial
            result.
        throw : bool, optional
            If True, a failed run raises an error. Otherwise the result is the partial recording, and `outcome` states
            the reason.
        allow_native : bool, optional
            Permit the FMUs of the circuit to execute native code, which has all rights of the user.

        Returns
        -------
        Recording
            All states, outputs and inputs of all parts, SI and absolute.

        Raises
        ------
        SimulationError
            If the run failed. Its `recording` contains the partial result.
        """
        from poppet.circuit.notes import make_recording
        from poppet.engine.problem import ending, is_failure
        from poppet.engine.solve import solve

        circuit = self if start is None else self.resumed(start)
        run = self.run.changed(
            duration=duration, output_step=output_step, relative_tolerance=relative_tolerance, stop_when=stop_when,
            solver=solver,
        )  # fmt: skip
        if circuit.fmus:
            from poppet.circuit.coupled_run import run_coupled

            return run_coupled(circuit, run, allow_native=allow_native, progress=progress, throw=throw)
        problem = circuit.problem(run)
        raw = solve(problem, run.solver, progress)
        recording = make_recording(circuit.instance, problem, raw)
        if throw and is_failure(problem, raw):
            raise SimulationError(ending(problem, raw), recording)
        return recording

    def steady_state(self, inputs: Mapping[str, Any] | None = None) -> SteadyState:
        r"""Return the steady state that the circuit reaches from its initial state with constant inputs.

        .. math:: f(x, u) = 0

        Parameters
        ----------
        inputs : mapping, optional
            Mapping from the address of an input to its value, in SI units or as text with a unit (default: value of
            each input at the start of a run).

        Returns
        -------
        SteadyState
            States and outputs.

        Raises
        ------
        SimulationError
            If the circuit has no steady state or none was found.

        Notes ----- A transient of increasing length, up to 30 years of model time, approaches the steady state.
        Newton's method with the exact Jacobian then refines it. Conserved quantities (the gas in a closed network) keep
        their initial values. In the dead zone of a valve, all states are steady. The result is then the state that the
        transient reaches. If the transient does not end, because a valve hunts, the search continues with slower gas
        dynamics. Slower gas does not change the steady state, but the mechanics can follow it. A note reports this
        method.

        If the circuit is sampled, states and discrete states are both steady: no sample instant changes them, except
        for clocks and their counters.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", wall_conductance=1.0)
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> rest = Circuit({"tank": tank, "vent": vent}).steady_state()
        >>> round(rest.y["tank.pressure"], 3), round(rest.y["tank.temperature"], 3)
        (100000.0, 293.15)
        """
        from poppet.circuit.linear import steady_state

        return steady_state(self.instance, inputs)

    def linearise(self, inputs: Mapping[str, Any] | None = None, *, at: Recording | None = None) -> LinearModel:
        r"""Return the linear model at the steady state or at the end of a recording.

        The matrices are exact derivatives of the rates f and the outputs g.

        .. math::
            A = \frac{\partial f}{\partial x}, \quad B = \frac{\partial f}{\partial u}, \quad
            C = \frac{\partial g}{\partial x}, \quad D = \frac{\partial g}{\partial u}

        Parameters
        ----------
        inputs : mapping, optional
            Mapping from the address of an input to its value, in SI units or as text with a unit.
        at : Recording, optional
            Recording whose last row is the operating point (default: the steady state).

        Returns
        -------
        LinearModel
            Matrices with names and units. If the circuit is sampled, it is a `SampledModel`.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", thermal="isothermal")
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> model = Circuit({"tank": tank, "vent": vent}).linearise()
        >>> model.states, model.eigenvalues().real.round(1).tolist()
        (('tank.mass',), [-66.6])
        """
        from poppet.circuit.linear import linearise

        return linearise(self.instance, inputs, at=at)
