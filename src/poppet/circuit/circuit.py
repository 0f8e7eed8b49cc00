"""A circuit: named parts, signals and run options, joined into a model that runs."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from poppet.circuit.addresses import replaced
from poppet.circuit.doubts import doubtful_numbers, doubtful_signals
from poppet.circuit.instance import Instance, Series
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.trace import SURROUNDINGS
from poppet.circuit.wiring import connection_mistakes, kind_mistakes, signal_mistakes, wiring_mistakes
from poppet.ground.codes import Note, notes_of
from poppet.ground.errors import InputError, SimulationError, collect, prefixed
from poppet.ground.provenance import Number
from poppet.parts.compound import number_spec
from poppet.parts.part import Controller, Part, Surroundings
from poppet.series.signals import Signal

if TYPE_CHECKING:
    from poppet.circuit.linear_model import LinearModel, SteadyState
    from poppet.engine.kernel import Kernel
    from poppet.engine.model import Model
    from poppet.engine.problem import Problem
    from poppet.series.recording import Recording

_SECTIONS = ("ambient", "gas", "run")


@dataclass(frozen=True, eq=False)
class Circuit:
    """Parts joined into a network, ready to run.

    Parameters
    ----------
    parts : mapping
        Name to part; ports hold names of stores, or `ambient` for the open air.
    signals : mapping, optional
        Address of an input, `valve.pilot_pressure`, to its signal in SI units.
    run : Run, optional
        Duration, output step, tolerance, stop conditions.
    ambient : Ambient, optional
        Pressure and temperature of the surroundings.
    gas : GasChoice, optional
        Gas constant and isentropic exponent.
    title : str, optional
        Shown with every result.
    connections : mapping, optional
        Address of an input to the output that it takes: ``{"main.pilot_pressure": "pilot.pressure"}``.

    Raises
    ------
    InputErrors
        With all wiring mistakes at once.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice, Reservoir
    >>> circuit = Circuit({
    ...     "supply": Reservoir(pressure="7 bar"),
    ...     "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    ...     "tank": Chamber(volume="10 l"),
    ... })
    >>> recording = circuit.simulate(duration="20 s")
    >>> round(float(recording["tank.pressure"][-1]))
    700000
    """

    parts: Mapping[str, Part]
    signals: Mapping[str, Signal] = field(default_factory=dict)
    run: Run = field(default_factory=Run)
    ambient: Ambient = field(default_factory=Ambient)
    gas: GasChoice = field(default_factory=GasChoice)
    title: str = ""
    connections: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        collect(kind_mistakes(self))
        wiring = {name: (type(part), part.ports()) for name, part in self.parts.items()}
        mistakes = wiring_mistakes(wiring)
        mistakes += connection_mistakes(self.connections, self.parts, self.signals)
        collect([*mistakes, *signal_mistakes(self.signals, self.parts, float(self.ambient.pressure))])  # type: ignore[arg-type]

    def __repr__(self) -> str:
        lines = [f"Circuit {self.title!r}: {len(self.parts)} parts"]
        width = max(map(len, self.parts))
        for name, part in self.parts.items():
            ports = ", ".join(f"{port}={store}" for port, store in part.ports().items())
            lines.append(f"  {name:<{width}}  {type(part).__name__} {ports}".rstrip())
        return "\n".join([*lines, *(f"  driven: {address}" for address in self.signals)])

    def __getstate__(self) -> dict[str, Any]:
        """The fields alone, for copies and other processes: what follows from them is worked out anew there."""
        return {f.name: getattr(self, f.name) for f in fields(self)}

    # What is in it -----------------------------------------------------------------------------------------------

    @cached_property
    def surroundings(self) -> Surroundings:
        """Ambient state and gas as plain floats."""
        pressure, temperature = float(self.ambient.pressure), float(self.ambient.temperature)  # type: ignore[arg-type]
        return Surroundings(pressure, temperature, *self.gas.values())

    @cached_property
    def parameters(self) -> dict[str, float]:
        """Run-time value of every number by its address, SI and absolute."""
        values: dict[str, float] = {}
        for name, part in self.parts.items():
            try:
                own = part.parameters(self.surroundings)
            except InputError as error:
                raise prefixed(error, f"{name}.") from None
            values |= {f"{name}.{local}": value for local, value in own.items()}
        s = self.surroundings
        shared = (s.pressure, s.temperature, s.gas_constant, s.isentropic_exponent, s.conductance_factor)
        return values | dict(zip(SURROUNDINGS, shared, strict=True))

    def numbers(self) -> dict[str, Number]:
        """Every number with its unit and source, by address.

        Returns
        -------
        dict
            Parts in file order, then the surroundings.
        """
        own = {f"{name}.{key}": n for name, part in self.parts.items() for key, n in part.numbers().items()}
        own |= {f"ambient.{key}": n for key, n in self.ambient.numbers().items()}
        return own | {f"gas.{key}": n for key, n in self.gas.numbers().items()}

    @cached_property
    def structure(self) -> Hashable:
        """What decides the model: kinds, options, wiring, names. Numbers are not in it."""
        parts = tuple((name, part.structure()) for name, part in self.parts.items())
        return parts, tuple(self.parameters), tuple(sorted(self.connections.items()))

    @cached_property
    def static_notes(self) -> tuple[Note, ...]:
        """What a reader of any result has to know about the circuit's numbers."""
        result: list[Note | str] = list(self.gas.notes())
        result += [note.within(name) for name, part in self.parts.items() for note in part.notes()]
        for address, value in self.numbers().items():
            if (
                address.endswith(".critical_ratio")
                and value.source.kind == "assumed"
                and "assumed" in value.source.note
            ):
                result.append(f"{address}: {value.source.note}.")
        result += doubtful_numbers(self.numbers())
        inputs = {f"{name}.{item.name}": item for name, part in self.parts.items() for item in part.inputs()}
        result += doubtful_signals(self.signals, inputs)
        for name, part in self.parts.items():
            for item in part.measured if isinstance(part, Controller) else ():
                if (address := f"{name}.{item}") not in {**self.signals, **self.connections}:
                    stays = self.parameters[f"{name}.{inputs[address].default}"] / 1e5
                    result.append(Note("circuit.uncontrolled", address, value=stays))
        return notes_of(result)

    # Variations --------------------------------------------------------------------------------------------------

    def with_values(self, values: Mapping[str, Any]) -> Circuit:
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
        return replace(self, parts=parts, **{name: changed[name] for name in _SECTIONS})

    def resumed(self, recording: Recording) -> Circuit:
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
            raise InputError(f"start = {recording!r}", "is not a recording.", "Read it: poppet.Recording.read(file).")
        targets = {
            f"{name}.{output}": (name, target)
            for name, part in self.parts.items()
            for output, target in part.resume.items()
            if (part.states() or part.memory()) and part.can_resume(target)
        }
        missing = [address for address in targets if address not in recording]
        if missing or not recording.time.size:
            raise InputError(
                f"start from {recording.title or 'a recording'}:",
                f"it has no {'series ' + ', '.join(missing) if missing else 'rows'}.",
                f"It has: {', '.join(recording.names)}.",
            )
        units = dict(self.model.outputs)
        last = (
            recording.select(targets).converted({address: units[address] for address in targets}).last()
            if targets
            else {}
        )
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

        return KERNELS.get(self.structure, self._compiled)

    def _compiled(self) -> Kernel:
        from poppet.circuit.trace import trace
        from poppet.engine.kernel import compile_kernel

        return compile_kernel(trace(self.parts, tuple(self.parameters), self.connections))

    @property
    def model(self) -> Model:
        """The traced model: states, inputs, parameters, outputs and their symbolic expressions."""
        return self.kernel.model

    @property
    def instance(self) -> Instance:
        """The compiled model with the numbers and signals of this circuit, without its parts."""
        return Instance(
            self.kernel, self.parameters, self.signals, self.surroundings, self._remarks, self._varied,
            lambda recording: self.resumed(recording).instance, self.title, self.static_notes, self.domains,
        )  # fmt: skip

    def _varied(self, values: Mapping[str, Any] | None = None, signals: Mapping[str, Signal] | None = None) -> Instance:
        circuit = self.with_values(values) if values else self
        return (circuit if signals is None else replace(circuit, signals=signals)).instance

    def _remarks(self, series: Series) -> Iterator[Note]:
        """What the parts have to say about the results of a run."""
        for name, part in self.parts.items():
            for remark in part.remarks(name, series):
                yield remark.within(name)

    def problem(self, run: Run) -> Problem:
        """The plain arrays of one run.

        Parameters
        ----------
        run : Run
            With a duration.

        Returns
        -------
        Problem
            To be handed to `poppet.engine.solve.solve`.
        """
        cached: Problem | None = self._problems.get(run)
        if cached is None:
            cached = self._problems[run] = self.instance.problem(run)
        return cached

    @cached_property
    def _problems(self) -> dict[Run, Problem]:
        return {}

    @cached_property
    def domains(self) -> dict[str, Any]:
        """Address of each stroke to the characteristic that holds over a range of it."""
        return {f"{name}.{key}": curve for name, part in self.parts.items() for key, curve in part.domains().items()}

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
        if start is not None:
            return self.resumed(start).simulate(
                duration,
                output_step,
                relative_tolerance,
                stop_when=stop_when,
                solver=solver,
                progress=progress,
                throw=throw,
            )
        from poppet.circuit.notes import recording_of
        from poppet.engine.problem import ending, is_failure
        from poppet.engine.solve import solve

        run = self.run.changed(duration, output_step, relative_tolerance, stop_when, solver)
        problem = self.problem(run)
        raw = solve(problem, run.solver, progress)
        recording = recording_of(self.instance, problem, raw)
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
