"""States at rest and linear models of a circuit, by exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.errors import InputError, MissingDependencyError, SimulationError, collect, suggestion
from poppet.model import InputInfo, Model
from poppet.recording_io import by_suffix, write_whole
from poppet.simulate import Outcome, Problem, RawRun, solve
from poppet.units import quantity

if TYPE_CHECKING:
    from poppet.circuit import Circuit
    from poppet.recording import Recording

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 1e3, 1e5, 1e7, 1e9)
"""Lengths of transient tried one after the other; what still moves after thirty years has no state at rest [s]."""
TRANSIENT_TOLERANCE = 1e-8
TRANSIENT_STEPS = 100_000
AT_REST = 1e-10
"""Rate of change at rest, per size of a state [1/s]; rounding of the rates is granted on top."""
ROUNDING = 1e3 * np.finfo(float).eps
NEWTON_STEPS, HALVINGS = 50, 12
SINGULAR = 1e-11
"""Singular values of the scaled Jacobian below this part of the largest one belong to conserved quantities."""


@dataclass(frozen=True, eq=False)
class SteadyState:
    """A state in which nothing changes while the inputs are held.

    Parameters
    ----------
    x : (n_states,) array
        Controlled states, in the order of `circuit.model.states`.
    y : dict
        Address of every output to its value, SI.
    u : dict
        Address of every input to its value, SI.
    residual : float
        Largest rate of change left, per size of the state [1/s].
    message : str
        How it was found.
    """

    x: Array
    y: dict[str, float]
    u: dict[str, float]
    residual: float
    message: str


@dataclass(frozen=True, eq=False)
class LinearModel:
    r"""A circuit for small changes about a point.

    .. math:: \dot{\delta x} = A\,\delta x + B\,\delta u, \qquad \delta y = C\,\delta x + D\,\delta u

    Parameters
    ----------
    A, B, C, D : (n, n), (n, n_u), (n_y, n), (n_y, n_u) arrays
        Exact derivatives of rates and outputs, SI.
    states, inputs, outputs : tuple of str
        Addresses, in the order of rows and columns.
    x, u, y : (n,), (n_u,), (n_y,) arrays
        The point, SI.
    rates : (n,) array
        x' at the point, SI per second: zero at rest. Away from rest it adds to the first equation.

    Notes
    -----
    Valid for amplitudes that change no regime of flow and cross no contact. Between two stores at rest this is the
    regularised zone of the flow law, 0.1 % of the upstream pressure by default (`laminar_ratio`): beyond it a passage
    is stiffer than its linear model says. On a kink the derivative is that of one side.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    x: Array
    u: Array
    y: Array
    rates: Array = field(repr=False)

    def eigenvalues(self) -> NDArray[np.complex128]:
        """Eigenvalues of A, slowest first.

        Returns
        -------
        (n,) array
            Complex [1/s]; a conserved quantity gives a zero.
        """
        scale = _balance(self.A)
        values = np.linalg.eigvals(self.A * scale[None, :] / scale[:, None]).astype(np.complex128)
        return values[np.lexsort((values.imag, np.abs(values)))]

    def frequency_response(self, frequencies: ArrayLike, input: str, output: str) -> NDArray[np.complex128]:
        r"""Response of one output to one input.

        .. math:: G(\mathrm{i}\omega) = C\,(\mathrm{i}\omega I - A)^{-1} B + D, \qquad \omega = 2\pi f

        Parameters
        ----------
        frequencies : (n,) array
            Positive frequencies f [Hz].
        input, output : str
            Addresses.

        Returns
        -------
        (n,) array
            Complex gain, unit of the output per unit of the input.

        Raises
        ------
        InputError
            If an address is unknown.
        """
        column, row = _place(self.inputs, input, "input"), _place(self.outputs, output, "output")
        identity = np.eye(len(self.states))
        gains = [
            self.C[row] @ np.linalg.solve(2j * np.pi * f * identity - self.A, self.B[:, column]) + self.D[row, column]
            for f in np.atleast_1d(np.asarray(frequencies, dtype=float))
        ]
        return np.array(gains, dtype=np.complex128)

    def to_control(self) -> Any:
        """The model for python-control.

        Returns
        -------
        control.StateSpace
            With named signals. Its names allow no dot: `tank.pressure` is called `tank__pressure`.

        Raises
        ------
        MissingDependencyError
            If python-control is not installed.
        """
        try:
            import control
        except ImportError as error:
            raise MissingDependencyError("control", "A control.StateSpace", "control") from error
        names = [[name.replace(".", "__") for name in group] for group in (self.states, self.inputs, self.outputs)]
        return control.ss(
            self.A, self.B, self.C, self.D, states=names[0], inputs=names[1], outputs=names[2], remove_useless_states=False
        )

    def save(self, path: str | Path) -> Path:
        """Write the matrices, names and point; an existing file is replaced as a whole or not at all.

        Parameters
        ----------
        path : str or Path
            Ends in `.json`, `.mat` or `.npz`.

        Returns
        -------
        Path
            Where it was written.
        """
        path = Path(path)
        writer = by_suffix(path, {".json": _write_json, ".mat": _write_mat, ".npz": _write_npz})
        return write_whole(path, lambda stream: writer(self, stream))


def steady_state(circuit: Circuit, inputs: Mapping[str, Any] | None = None) -> SteadyState:
    r"""The state at rest that a circuit reaches from its initial state while its inputs are held.

    .. math:: f(x, u) = 0

    Parameters
    ----------
    circuit : Circuit
        Parts and numbers; its signals give the inputs that are not named, at their value at t = 0.
    inputs : mapping, optional
        Address of an input to its value, SI or text with a unit: ``{"valve.pilot_pressure": "2 bar g"}``.

    Returns
    -------
    SteadyState
        States, outputs, inputs, what is left of the rates.

    Raises
    ------
    InputError
        If an input is unknown or its value impossible.
    SimulationError
        If nothing comes to rest, as in a closed tank that is fed.

    Notes
    -----
    A transient of growing length, up to 30 years of model time, brings the circuit near its rest; Newton's method with
    the exact Jacobian does the rest. What the network conserves (the gas in a closed network) keeps the value of the
    initial state. Where a valve has a dead zone, any state in it is one of rest: the one is found at which the
    transient arrives. A rest that no transient reaches, an unstable one, is found only if Newton's method converges
    from where the transient was cut off; the message then says so.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", wall_conductance=1.0)
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> rest = steady_state(Circuit({"tank": tank, "vent": vent}))
    >>> round(rest.y["tank.pressure"], 3), round(rest.y["tank.temperature"], 3)
    (100000.0, 293.15)
    """
    point = _Point(circuit, _input_values(circuit, inputs or {}))
    x, duration, run = _settled(point)
    x = _polished(point, x)
    residual, allowed = point.residual(x)
    if np.any(residual > allowed):
        raise SimulationError(_restless(point, x, residual, duration, run))
    message = f"At rest after a transient of {duration:.3g} s and Newton's method."
    if not run.outcome.is_success:
        message = f"Found by Newton's method from a transient of {duration:.3g} s that was cut off: it may be unstable."
    return SteadyState(
        x, point.outputs(x), dict(zip(point.names, point.u.tolist(), strict=True)), float(np.max(residual, initial=0.0)), message
    )


def linearise(circuit: Circuit, inputs: Mapping[str, Any] | None = None, *, at: Recording | None = None) -> LinearModel:
    r"""Linear model of a circuit at rest, or where a recording ends.

    .. math::
        A = \frac{\partial f}{\partial x}, \quad B = \frac{\partial f}{\partial u}, \quad
        C = \frac{\partial g}{\partial x}, \quad D = \frac{\partial g}{\partial u}

    Parameters
    ----------
    circuit : Circuit
        Parts and numbers.
    inputs : mapping, optional
        Address of an input to its value, SI or text with a unit. Others take their value in `at` where there is one, else
        that of their signal at t = 0.
    at : Recording, optional
        Linearise at its last row instead of at rest.

    Returns
    -------
    LinearModel
        Exact derivatives.

    Raises
    ------
    InputError
        If an input is unknown, its value impossible, or the recording lacks a state.
    SimulationError
        If there is no state at rest.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> tank = Chamber(volume="1 l", thermal="isothermal")
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> model = linearise(Circuit({"tank": tank, "vent": vent}))
    >>> model.states, model.eigenvalues().real.round(1).tolist()
    (('tank.mass',), [-56.5])
    """
    if at is None:
        rest = steady_state(circuit, inputs)
        return _linear_model(_Point(circuit, np.array(list(rest.u.values()))), rest.x)
    units = {item.name: item.unit for item in circuit.model.inputs if item.name in at}
    recorded = at.select(units).converted(units).last() if units else {}
    start = circuit.resumed(at)
    point = _Point(start, _input_values(start, recorded | dict(inputs or {})))
    return _linear_model(point, point.start)


class _Point:
    """A circuit with held inputs: its rates, outputs and derivatives."""

    def __init__(self, circuit: Circuit, u: Array) -> None:
        self.kernel, self.u = circuit.kernel, u
        self.model: Model = circuit.kernel.model
        self.names = tuple(item.name for item in self.model.inputs)
        self.p = np.array(list(circuit.parameters.values()))
        self.n = len(self.model.states)
        self.start: Array = self.kernel.start(self.p)[: self.n]
        sizes = np.array([state.nominal for state in self.model.states])
        self.size = np.where(self.start != 0.0, np.abs(self.start), sizes)
        self._function = self.model.linear_functions()

    def linear(self, x: Array) -> list[Array]:
        """f, y, A, B, C, D."""
        found = self._function(0.0, self.padded(x), self.u, self.p)
        shapes = [(self.n,), (len(self.model.outputs),)]
        return [value.full().reshape(shape) for value, shape in zip(found[:2], shapes, strict=True)] + [
            value.full() for value in found[2:]
        ]

    def padded(self, x: Array) -> Array:
        """States with quadratures of zero behind them."""
        return np.concatenate([x, np.zeros(self.model.n_quadratures)])

    def outputs(self, x: Array) -> dict[str, float]:
        """Outputs by address."""
        return dict(zip(self.model.columns[0], self.linear(x)[1].tolist(), strict=True))

    def scaled(self, x: Array) -> tuple[Array, Array]:
        """Rates and Jacobian of the states in units of their sizes."""
        f, _, jacobian, *_ = self.linear(x)
        return f / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def residual(self, x: Array) -> tuple[Array, Array]:
        """Rate of each state per size, and what of it counts as rest [1/s]."""
        f, jacobian = self.scaled(x)
        return np.abs(f), AT_REST + ROUNDING * np.abs(jacobian) @ (np.abs(x) / self.size)

    def is_at_rest(self, x: Array) -> bool:
        """True when no state changes any more."""
        residual, allowed = self.residual(x)
        return bool(np.all(residual <= allowed))


def _settled(point: _Point) -> tuple[Array, float, RawRun]:
    """The end of the first transient that rests or fails, or of the longest one.

    Each begins at the initial state: the absolute tolerances of a run follow the sizes of its first state, and those of
    a state nearly at rest mean nothing.
    """
    for duration in TRANSIENTS:
        run = _transient(point, duration)
        x = run.x[: point.n]
        if not run.outcome.is_success or point.is_at_rest(x):
            break
    return x, duration, run


def _transient(point: _Point, duration: float) -> RawRun:
    coefficients = np.zeros((1, max(1, point.u.size), 6))
    coefficients[0, : point.u.size, 0] = point.u
    problem = Problem(
        point.kernel, point.p, point.padded(point.start), np.zeros(1), coefficients, np.zeros(1, dtype=bool), np.array([duration]),
        TRANSIENT_TOLERANCE, most_attempts=TRANSIENT_STEPS,
    )  # fmt: skip
    return solve(problem)


def _polished(point: _Point, x: Array) -> Array:
    """Newton's method, with steps halved until they lower the rates and keep positive states positive."""
    for _ in range(NEWTON_STEPS):
        f, jacobian = point.scaled(x)
        lower = _lowered(point, x, _conserving_step(f, jacobian) * point.size, np.max(np.abs(f), initial=0.0))
        if lower is None:
            break
        x = lower
    return x


def _lowered(point: _Point, x: Array, step: Array, rate: float) -> Array | None:
    """A state along a Newton step at which the largest rate is lower, or None."""
    positive = np.array([state.positive for state in point.model.states], dtype=bool)
    for halvings in range(HALVINGS):
        trial = x + step * 0.5**halvings
        if np.all(trial[positive] > 0.0) and np.max(np.abs(point.scaled(trial)[0]), initial=0.0) < rate:
            return trial
    return None


def _conserving_step(f: Array, jacobian: Array) -> Array:
    """The Newton step that leaves alone what the Jacobian says is conserved (its left null space)."""
    if not f.size:
        return f
    left, singular, _ = np.linalg.svd(jacobian)
    conserved = left[:, singular <= SINGULAR * singular[0]].T
    step: Array = np.linalg.lstsq(
        np.vstack([jacobian, conserved * singular[0]]), np.concatenate([-f, np.zeros(len(conserved))]), rcond=SINGULAR
    )[0]
    return step


def _restless(point: _Point, x: Array, residual: Array, duration: float, run: RawRun) -> str:
    """Why there is no state at rest, for a person."""
    worst = int(np.argmax(residual))
    state = point.model.states[worst]
    rate = float(point.linear(x)[0][worst])
    moving = f"{state.name} = {x[worst]:.6g} {state.unit} still changes by {rate:.3g} {state.unit} per second"
    if run.outcome is Outcome.TOO_MANY:
        cure = "It oscillates: see simulate(), add damping, or linearise where a recording ends (at=...)."
    elif not run.outcome.is_success:
        cure = "A flow source may be drawing an empty store: give it gas from elsewhere, or hold its flow at zero."
    else:
        cure = "Something feeds or drains a store for ever: close it, vent it, or linearise at a recording (at=...)."
    return f"The circuit comes to no rest: within {duration:.3g} s {moving}. {cure}"


def _input_values(circuit: Circuit, given: Mapping[str, Any]) -> Array:
    """Every input, in the order of the model: as given, else as its signal is at t = 0, else its number."""
    known = {item.name: item for item in circuit.model.inputs}
    problems = [
        InputError(f"inputs: {name}", "is no input of this circuit.", suggestion(name, known), address=name)
        for name in given
        if name not in known
    ]
    values = []
    for name, item in known.items():
        try:
            values.append(_given_value(circuit, item, given[name]) if name in given else _default_value(circuit, item))
        except InputError as error:
            problems.append(error)
    collect(problems)
    return np.array(values, dtype=float)


def _given_value(circuit: Circuit, item: InputInfo, given: Any) -> float:
    read = quantity(given, item.unit, kind=item.kind, name=item.name)  # type: ignore[arg-type]
    value = read.value + (circuit.surroundings.pressure if read.reference == "gauge" else 0.0)
    if not item.low <= value <= item.high:
        raise InputError(
            f"inputs: {item.name} = {given}",
            f"is outside {item.low:g} ... {item.high:g} {item.unit}.",
            "Give a value inside.",
            address=item.name,
        )
    return value


def _default_value(circuit: Circuit, item: InputInfo) -> float:
    signal = circuit.signals.get(item.name)
    if signal is not None:
        return float(signal.table(1.0).evaluate(0.0))
    return circuit.parameters[item.default] if isinstance(item.default, str) else item.default


def _linear_model(point: _Point, x: Array) -> LinearModel:
    f, y, a, b, c, d = point.linear(x)
    return LinearModel(
        a, b, c, d, tuple(state.name for state in point.model.states), point.names, point.model.columns[0], x, point.u, y, f
    )


def _place(names: tuple[str, ...], name: str, kind: str) -> int:
    if name not in names:
        raise InputError(f"{kind} = {name!r}", f"is no {kind} of the linear model.", suggestion(name, names))
    return names.index(name)


def _balance(matrix: Array) -> Array:
    """Sizes that make rows and columns alike: pressures and masses are ten decades apart."""
    from scipy.linalg import matrix_balance

    return np.asarray(matrix_balance(matrix, permute=False, separate=True)[1][0]) if matrix.size else np.ones(0)


def _content(model: LinearModel) -> dict[str, Any]:
    return {name: getattr(model, name) for name in LinearModel.__dataclass_fields__}


def _write_json(model: LinearModel, stream: Any) -> None:
    import json

    plain = {key: value.tolist() if isinstance(value, np.ndarray) else list(value) for key, value in _content(model).items()}
    stream.write((json.dumps(plain, indent=1) + "\n").encode())


def _write_mat(model: LinearModel, stream: Any) -> None:
    from scipy.io import savemat

    content = {k: v if isinstance(v, np.ndarray) else np.array(v, dtype=object) for k, v in _content(model).items()}
    savemat(stream, content, oned_as="column")


def _write_npz(model: LinearModel, stream: Any) -> None:
    np.savez(stream, **{key: np.array(value) for key, value in _content(model).items()})
