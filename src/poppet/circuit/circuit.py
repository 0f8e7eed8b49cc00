"""A circuit: named parts, signals and run options, joined into a model that runs."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping
from dataclasses import InitVar, dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np

from poppet.circuit.addresses import replaced
from poppet.circuit.ideal_gas import far_from_ideal
from poppet.circuit.instance import Array, Drive, Instance, Series
from poppet.circuit.options import ABOUT_CONDUCTANCES, Ambient, GasChoice, Run
from poppet.circuit.placed_part import PlacedPart, doubtful_numbers, doubtful_signals
from poppet.circuit.trace import SURROUNDINGS
from poppet.circuit.wiring import (
    PartWiring,
    check_connections,
    check_kinds,
    check_signals,
    check_starts,
    check_wiring,
    met_at_cells,
)
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, SimulationError
from poppet.core.notebook import HtmlMixin
from poppet.core.provenance import Number
from poppet.core.units import counted_at
from poppet.engine.lru_cache import LruCache
from poppet.library import Gas
from poppet.parts.compound import number_spec
from poppet.parts.part import Controller, Input, Part, Store, Surroundings
from poppet.timeseries.signals import Signal

if TYPE_CHECKING:
    from poppet.circuit.linear_model import LinearModel, SteadyState
    from poppet.engine.kernel import Kernel
    from poppet.engine.model import Model
    from poppet.engine.problem import Problem
    from poppet.timeseries.recording import Recording

_SECTIONS = ("ambient", "gas", "run")
RUNS = 4
"""Runs of a circuit whose arrays are kept: most repeat the last one."""


class Origin(NamedTuple):
    """The tables of a circuit file as they were written, and the folder to which paths in them refer."""

    tables: Mapping[str, Any]
    folder: Path


NOWHERE = Origin({}, Path())


@dataclass(frozen=True, eq=False)
class BaseCircuit(HtmlMixin):
    """Parts joined into a network: wiring checks, model, runs and steady states.

    Parameters
    ----------
    parts, signals, run, ambient, gas, title, connections, origin, like : optional
        See `poppet.Circuit`, which adds the methods of the packages above.

    Raises
    ------
    InputErrors
        With all wiring errors.
    """

    parts: Mapping[str, Part]
    signals: Mapping[str, Signal] = field(default_factory=dict)
    run: Run = field(default_factory=Run)
    ambient: Ambient = field(default_factory=Ambient)
    gas: GasChoice = field(default_factory=GasChoice)
    title: str = ""
    connections: Mapping[str, str] = field(default_factory=dict)
    origin: Origin = field(default=NOWHERE, repr=False)
    like: InitVar[BaseCircuit | None] = None

    _placed: Mapping[str, PlacedPart] = field(init=False, repr=False)
    _drive: Drive = field(init=False, repr=False)
    _problems: LruCache[Problem] = field(init=False, repr=False)

    def __post_init__(self, like: BaseCircuit | None) -> None:
        if isinstance(self.gas, Gas):
            object.__setattr__(self, "gas", GasChoice.of(self.gas))
        # Alone and first: what follows takes the fields for what they are declared to be.
        check_kinds(self)
        # Whoever holds what was given may change it, and a circuit stays as it was made.
        object.__setattr__(self, "parts", MappingProxyType(met_at_cells(self.parts)))
        for name in ("signals", "connections"):
            if not isinstance(given := getattr(self, name), MappingProxyType):
                object.__setattr__(self, name, MappingProxyType(dict(given)))
        # Gauge values of a part are referred to the surroundings: with others every part is placed anew.
        is_near = like is not None and like.surroundings == self.surroundings
        known = like._placed if like is not None and is_near else {}
        placed: dict[str, PlacedPart] = {}
        with ErrorCollector() as errors:
            for name, part in self.parts.items():
                if name in known and known[name].part is part:
                    placed[name] = known[name]
                    continue
                with errors.collecting(name):
                    placed[name] = PlacedPart.of(name, part, self.surroundings)
        is_driven_alike = like is not None and like.signals is self.signals
        drive = like._drive if like is not None and is_driven_alike else Drive(self.signals)
        # The only way to set a field of a frozen dataclass.
        for attribute, value in {"_placed": placed, "_drive": drive, "_problems": LruCache(RUNS)}.items():
            object.__setattr__(self, attribute, value)
        self._check(like, {name for name in placed if is_driven_alike and placed[name] is known.get(name)})

    def _check(self, like: BaseCircuit | None, checked: set[str]) -> None:
        """Refuse wrong names, ports, connections, and signals of parts that were not `checked` with them before."""
        with ErrorCollector() as errors:
            # A fit makes a new circuit for every number that others follow from; its wiring was right before.
            if like is None or like._wiring != self._wiring or like.connections is not self.connections:
                check_wiring(errors, self._wiring)
                check_connections(errors, self.connections, self.parts, self.inputs, self.signals)
            check_starts(errors, self.parts, self.signals)
            signals = {a: signal for a, signal in self.signals.items() if a.partition(".")[0] not in checked}
            check_signals(errors, signals, self.inputs, self.parameters)

    def __reduce__(self) -> Any:
        """The fields alone, for copies and other processes: what follows from them is worked out anew there."""
        given = (getattr(self, f.name) for f in fields(self) if f.init)
        return type(self), tuple(dict(each) if isinstance(each, MappingProxyType) else each for each in given)

    def __repr__(self) -> str:
        lines = [f"Circuit {self.title!r}: {len(self.parts)} parts"]
        width = max(map(len, self.parts))
        for name, part in self.parts.items():
            ports = ", ".join(f"{port}={store}" for port, store in part.ports().items())
            lines.append(f"  {name:<{width}}  {type(part).__name__} {ports}".rstrip())
        return "\n".join([*lines, *(f"  driven: {address}" for address in self.signals)])

    # What is in it -----------------------------------------------------------------------------------------------

    @cached_property
    def surroundings(self) -> Surroundings:
        """Ambient state and gas as plain floats."""
        pressure, temperature = float(self.ambient.pressure), float(self.ambient.temperature)  # type: ignore[arg-type]
        return Surroundings(pressure, temperature, *self.gas.values())

    @cached_property
    def parameters(self) -> dict[str, float]:
        """Run-time value of every number by its address, SI and absolute."""
        values = {address: value for each in self._placed.values() for address, value in each.parameters.items()}
        s = self.surroundings
        # What the gas makes of C and b follows from it: it has places in p and stands in no section.
        return values | dict(zip(SURROUNDINGS, (getattr(s, f.name) for f in fields(s)), strict=True))

    def numbers(self) -> dict[str, Number]:
        """Every number with its unit and source, by address.

        Returns
        -------
        dict
            Parts in file order, then the surroundings.
        """
        own = {address: n for each in self._placed.values() for address, n in each.numbers.items()}
        return own | self._shared_numbers()

    def _shared_numbers(self) -> dict[str, Number]:
        own = {f"ambient.{key}": n for key, n in self.ambient.numbers().items()}
        return own | {f"gas.{key}": n for key, n in self.gas.numbers().items()}

    @cached_property
    def inputs(self) -> dict[str, Input]:
        """Every input of a part by its address, connected ones among them."""
        return {address: item for each in self._placed.values() for address, item in each.inputs.items()}

    @cached_property
    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        """Address of each stroke to the characteristic that holds over a range of it, and its end stops."""
        return {address: curve for each in self._placed.values() for address, curve in each.domains.items()}

    @property
    def _wiring(self) -> dict[str, PartWiring]:
        return {name: each.wired for name, each in self._placed.items()}

    @cached_property
    def structure(self) -> Hashable:
        """What decides the model: kinds, options, wiring, names. Numbers are not in it."""
        parts = tuple(each.structure for each in self._placed.values())
        return parts, tuple(sorted(self.connections.items()))

    @cached_property
    def static_notes(self) -> tuple[Note, ...]:
        """What a reader of any result has to know about the circuit's numbers."""
        of_parts = (note for each in self._placed.values() for note in each.notes)
        doubts = (
            *self._volumes_of_air(),
            *self._heat_as_of_air(),
            *doubtful_numbers(self._shared_numbers()),
            *doubtful_signals(self.signals, self.inputs),
        )
        gas_notes = self.gas.notes()
        # Areas, Kv, Cv and nominal flows have one meaning each.
        if not any(n.unit == "m^3/(s Pa)" for each in self._placed.values() for n in each.numbers.values()):
            gas_notes = tuple(note for note in gas_notes if note.code not in ABOUT_CONDUCTANCES)
        return *gas_notes, *self._far_from_ideal(self._at_start), *of_parts, *doubts, *self._uncontrolled()

    def _at_start(self, address: str) -> Array:
        name, _, quantity = address.partition(".")
        values = self._placed[name].parameters
        return np.array([values.get(f"{name}.initial_{quantity}", values.get(address, 0.0))])

    def _far_from_ideal(self, series: Series) -> Iterator[Note]:
        """Stores whose gas is not ideal; `series` has their pressures and temperatures."""
        gas = self.gas.of_library()
        for name, part in self.parts.items():
            if gas is not None and isinstance(part, Store):
                yield from far_from_ideal(name, series(f"{name}.pressure"), series(f"{name}.temperature"), gas)

    def _volumes_of_air(self) -> Iterator[Note]:
        """Mass flow rates that were written as flows at ANR or normal, where something else than air flows."""
        for address, number in {} if self.gas.is_air else self.numbers().items():
            if number.unit == "kg/s" and counted_at(number.text):
                yield Note("gas.volume_of_air", address, shown=number.text, mass_flow_rate=number.value)

    def _heat_as_of_air(self) -> Iterator[Note]:
        """Walls whose heat transfer is reckoned with the viscosity and conductivity of air, beside another gas."""
        gas = self.gas.of_library()
        for name, part in self.parts.items() if gas is None or not gas.is_like_air else ():
            law, thermal = (part.options().get(key, "") for key in ("heat_transfer", "thermal"))
            if thermal == "energy" and law not in ("", "constant"):
                yield Note("gas.heat_as_of_air", f"{name}.heat_transfer", law=law)

    def _uncontrolled(self) -> Iterator[Note]:
        """Controllers that nobody tells what they are to measure."""
        for name, part in self.parts.items():
            for local in part.measured if isinstance(part, Controller) else ():
                address = f"{name}.{local}"
                if address not in self.signals and address not in self.connections:
                    item = self.inputs[address]
                    default = item.default
                    value = self.parameters[f"{name}.{default}"] if isinstance(default, str) else default
                    yield Note("circuit.uncontrolled", address, value=value, unit=item.unit)

    # Variations --------------------------------------------------------------------------------------------------

    def with_values(self, values: Mapping[str, Any]) -> Self:
        """The same circuit with other numbers or options.

        Parameters
        ----------
        values : mapping
            Address to value, text with unit or `Number`: ``{"tank.volume": "0.1 m^3"}``.

        Returns
        -------
        Circuit
            A new circuit; this one is unchanged.

        Raises
        ------
        InputError
            If an address is unknown or a value impossible.
        """
        sections = {name: getattr(self, name) for name in _SECTIONS}
        changed = replaced({**self.parts, **sections}, values)
        parts = {name: changed[name] for name in self.parts}
        return replace(self, parts=parts, like=self, **{name: changed[name] for name in _SECTIONS})

    def with_signals(self, signals: Mapping[str, Signal]) -> Self:
        """Return the circuit with these signals in place of its own.

        Parameters
        ----------
        signals : mapping
            Address of an input to its signal in SI units.
        """
        return replace(self, signals=signals, like=self)

    def resumed(self, recording: Recording) -> Self:
        """The same circuit starting where a recording ends.

        Parameters
        ----------
        recording : Recording
            Holds the states' series under this circuit's names, in any units.

        Returns
        -------
        Circuit
            With initial values taken from the last row. Its signals, and the clocks of what is sampled or switched,
            begin anew at t = 0; of sampled memory the integrals go on.

        Raises
        ------
        InputError
            If the recording lacks a series that a state needs.
        """
        if not hasattr(recording, "names"):
            raise InputError("circuit.no_recording", value=recording)
        # Parts without states or memory have nothing to go on with.
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
        return self.with_values(
            {f"{name}.{key}": self._within(name, key, last[address]) for address, (name, key) in targets.items()}
        )

    def _within(self, name: str, key: str, value: float) -> float:
        """A state as an initial value: the integrator's error may have carried it a hair past its limits."""
        spec = number_spec(self.parts[name], key)
        held = min(max(value, spec.low), spec.high)
        return held if abs(value - held) <= 1e-6 * (abs(held) + spec.high - spec.low) else value

    # The model ---------------------------------------------------------------------------------------------------

    @property
    def kernel(self) -> Kernel:
        """The compiled model; compiled once for every structure."""
        from poppet.engine.kernel import KERNELS

        # By structure, not by identity: a changed number is another circuit with the same kernel.
        return KERNELS.get(self.structure, self._compiled)

    def _compiled(self) -> Kernel:
        from poppet.circuit.trace import trace
        from poppet.engine.kernel import compile_kernel

        return compile_kernel(trace(self.parts, tuple(self.parameters), self.connections))

    @property
    def model(self) -> Model:
        """The traced model: states, inputs, parameters, outputs and their symbolic expressions."""
        return self.kernel.model

    @cached_property
    def instance(self) -> Instance:
        """Compiled model with the parameters and signals of this circuit, without its parts."""
        placed = self._placed.values()
        return Instance(
            kernel=self.kernel,
            parameters=self.parameters,
            drive=self._drive,
            surroundings=self.surroundings,
            circuit=self,
            title=self.title,
            notes=self.static_notes,
            domains=self.domains,
            initial={output: number for part in placed for output, number in part.initial.items()},
            inner=frozenset(self.connections).union(*(part.inner for part in placed)),
            sources={address: number for part in placed for address, number in part.numbers.items()},
            bodies={name: part.body for name, part in self._wiring.items() if part.body},
        )

    def result_notes(self, series: Series) -> Iterator[Note]:
        """Yield notes of gases and parts on the results of a run.

        Parameters
        ----------
        series : callable
            Function from the address of an output, or `time`, to its values at the rows of the run.
        """
        yield from self._far_from_ideal(series)
        for name, part in self.parts.items():
            for remark in part.remarks(name, series):
                yield remark.within(name)

    def problem(self, run: Run) -> Problem:
        """The plain arrays of one run, to be handed to `poppet.engine.solve.solve`.

        Parameters
        ----------
        run : Run
            With a duration.

        Returns
        -------
        Problem
        """
        return self._problems.get(run, lambda: self.instance.problem(run))

    # Running -----------------------------------------------------------------------------------------------------

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
    ) -> Recording:
        """Run the circuit.

        Parameters
        ----------
        duration : float or str, optional
            Length of the run [s]; default that of `run`.
        output_step : float or str, optional
            Time between rows [s]; default a thousandth of the duration.
        relative_tolerance : float, optional
            Results are within about ten times this of the exact solution; default 1e-6.
        stop_when : str or list of str, optional
            Conditions that end the run early, `tank.pressure > 5 bar`.
        solver : str, optional
            `rosenbrock`, or for a check `cvodes`, `lsoda`, `bdf`, `radau`.
        start : Recording, optional
            Start where it ends.
        progress : callable, optional
            Called with the time reached [s]; also makes Ctrl-C end the run with a partial result.
        throw : bool, optional
            Raise when the run fails; else return the partial recording, whose `outcome` says why.

        Returns
        -------
        Recording
            Every state, output and input of every part, SI and absolute.

        Raises
        ------
        SimulationError
            If the run ended before its time; it holds the partial recording.
        """
        from poppet.circuit.notes import make_recording
        from poppet.engine.problem import ending, is_failure
        from poppet.engine.solve import solve

        circuit = self if start is None else self.resumed(start)
        run = self.run.changed(
            duration=duration, output_step=output_step, relative_tolerance=relative_tolerance, stop_when=stop_when,
            solver=solver,
        )  # fmt: skip
        problem = circuit.problem(run)
        raw = solve(problem, run.solver, progress)
        recording = make_recording(circuit.instance, problem, raw)
        if throw and is_failure(problem, raw):
            raise SimulationError(ending(problem, raw), recording)
        return recording

    def steady_state(self, inputs: Mapping[str, Any] | None = None) -> SteadyState:
        r"""The state at rest that the circuit reaches from its initial state while its inputs are held.

        .. math:: f(x, u) = 0

        Parameters
        ----------
        inputs : mapping, optional
            Address to value, SI or text with a unit; default what each input is at the start of a run.

        Returns
        -------
        SteadyState
            States and outputs.

        Raises
        ------
        SimulationError
            If it comes to no rest.

        Notes
        -----
        A transient of growing length, up to 30 years of model time, brings the circuit near its rest; Newton's method
        with the exact Jacobian does the rest. What the network conserves (the gas in a closed network) keeps the value
        of the initial state. Where a valve has a dead zone, any state in it is one of rest: the one is found at which
        the transient arrives. Where the transient never ends, as with a valve that hunts, the rest is sought with the
        gas slowed down, which moves no rest but lets the mechanics follow; the message then says so.

        With sampled memory the rest is one of the states and of the memory alike: no instant changes anything any
        more, clocks and their counters left aside.

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
        r"""Linear model at rest, or where a recording ends, by exact derivatives.

        .. math::
            A = \frac{\partial f}{\partial x}, \quad B = \frac{\partial f}{\partial u}, \quad
            C = \frac{\partial g}{\partial x}, \quad D = \frac{\partial g}{\partial u}

        Parameters
        ----------
        inputs : mapping, optional
            Address to value, SI or text with a unit.
        at : Recording, optional
            Where it ends; default the state at rest.

        Returns
        -------
        LinearModel
            With names and units; a `SampledModel` of a circuit with sampled memory.

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


# Name in the packages below the public class.
Circuit = BaseCircuit
