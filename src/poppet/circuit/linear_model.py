"""Linear model of a circuit with names and operating point.

It provides eigenvalues, frequency response, files, and the conversion to python-control.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, needed
from poppet.core.files import by_suffix, write_whole
from poppet.core.notebook import HtmlMixin

Array = NDArray[np.float64]


class ControlSystem(Protocol):
    """Interface of an input-output system of python-control, which has no type hints of its own."""

    name: str
    dt: float | bool | None  # sample time [s]; 0 in continuous time
    params: dict[str, float]
    ninputs: int
    noutputs: int
    nstates: int
    input_labels: list[str]
    output_labels: list[str]
    state_labels: list[str]

    def dynamics(self, t: float, x: Array, u: Array, params: dict[str, float] | None = None) -> Array:
        """Return the derivatives of the states x at the time t for the inputs u.

        In discrete time, the result contains the next states.
        """

    def output(self, t: float, x: Array, u: Array, params: dict[str, float] | None = None) -> Array:
        """Return the outputs for the states x and the inputs u at the time t."""

    def __getattr__(self, name: str) -> Any: ...


class ControlStateSpace(ControlSystem, Protocol):
    """Interface of a state-space model of python-control, `control.StateSpace`."""

    A: Array
    B: Array
    C: Array
    D: Array

    def poles(self) -> NDArray[np.complex128]:
        """Return the poles in the s-plane [1/s], or in the z-plane for discrete time."""

    def zeros(self) -> NDArray[np.complex128]:
        """Return the transmission zeros of the system."""


@dataclass(frozen=True, eq=False)
class SteadyState:
    """State of a circuit that remains constant if the inputs are constant.

    Parameters
    ----------
    x : (n_states,) array
        States in SI, in the order of `circuit.model.states`.
    y : dict
        Mapping from the address of each output to the value, SI.
    u : dict
        Mapping from the address of each input to the value, SI.
    residual : float
        Largest remaining rate of change, divided by the typical size of the state [1/s].
    found : tuple of Note
        Note on the method of the search. If the state is unstable, a second note describes the motion of the circuit.
    memory : dict
        Mapping from the address of each discrete state to the value, SI. Clocks have their values at the start of a
        run.
    notes : tuple of Note
        Notes on kinks (jumps in slope) near this state, which limit the validity of a linear model.
    is_stable : bool
        False if the circuit leaves the state after a small disturbance.
    """

    x: Array
    y: dict[str, float]
    u: dict[str, float]
    residual: float
    found: tuple[Note, ...]
    memory: dict[str, float] = field(default_factory=dict)
    notes: tuple[Note, ...] = ()
    is_stable: bool = True

    @property
    def message(self) -> str:
        """Text on how the steady state was found."""
        return " ".join(map(str, self.found))


@dataclass(frozen=True, eq=False)
class LinearModel(HtmlMixin):
    r"""Linear model of a circuit for small changes about an operating point.

    .. math:: \dot{\delta x} = A\,\delta x + B\,\delta u, \qquad \delta y = C\,\delta x + D\,\delta u

    Parameters
    ----------
    A, B, C, D : (n, n), (n, n_u), (n_y, n), (n_y, n_u) arrays
        Exact derivatives of rates and outputs, SI.
    states, inputs, outputs : tuple of str
        Addresses, in the order of rows and columns.
    x, u, y : (n,), (n_u,), (n_y,) arrays
        Operating point, SI.
    rates : (n,) array
        x' at the operating point, SI per second: zero for a steady state, otherwise a term of the first equation.

    Notes
    -----
    The model is valid for amplitudes that do not change the flow regime and do not open or close a contact. Between two
    gas nodes at equal pressure, it is valid in the regularised zone of the flow law, by default 0.1 % of the upstream
    pressure (`laminar_ratio`). Beyond it, the flow increases with the root of the pressure drop, more slowly than in
    the linear model. On a kink, the derivatives are valid for one side only.
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

    more: ClassVar[tuple[str, ...]] = ()
    """Names of additional attributes of a subclass that files contain."""

    def eigenvalues(self) -> NDArray[np.complex128]:
        """Return the eigenvalues of A, sorted from the slowest to the fastest."""
        # Without balancing, rounding errors of the largest elements exceed slow eigenvalues.
        scale = balancing_scale(self.A)
        values = np.linalg.eigvals(self.A * scale[None, :] / scale[:, None]).astype(np.complex128)
        return values[np.lexsort((values.imag, np.abs(values)))]

    def poles(self) -> NDArray[np.complex128]:
        """Return the poles of the model in the s-plane [1/s].

        These are the eigenvalues of A. A sampled model with eigenvalues z and sample time T has the poles ln(z)/T.
        """
        return self.eigenvalues()

    def frequency_response(self, frequencies: ArrayLike, input: str, output: str) -> NDArray[np.complex128]:
        r"""Return the frequency response of one output to one input.

        `frequencies` are in Hz, and `input` and `output` are addresses. The result contains one complex number per
        frequency, in SI units.

        .. math:: G(\mathrm{i}\omega) = C\,(\mathrm{i}\omega I - A)^{-1} B + D, \qquad \omega = 2\pi f
        """
        column, row = index_of(self.inputs, input, "input"), index_of(self.outputs, output, "output")
        identity = np.eye(len(self.states))
        gains = [
            # One solve per frequency: eigenvectors are inaccurate near a multiple eigenvalue.
            self.C[row] @ np.linalg.solve(2j * np.pi * f * identity - self.A, self.B[:, column]) + self.D[row, column]
            for f in np.atleast_1d(np.asarray(frequencies, dtype=float))
        ]
        return np.array(gains, dtype=np.complex128)

    def to_control(self) -> ControlStateSpace:
        """Return the model as a `control.StateSpace`."""
        with needed("control", "A control.StateSpace", "control"):
            import control
        groups = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        # In python-control, a dot separates system and signal.
        names = {kind: [name.replace(".", "__") for name in group] for kind, group in groups.items()}
        # States without influence on an output remain: they have names and eigenvalues.
        system: ControlStateSpace = control.ss(self.A, self.B, self.C, self.D, **names, remove_useless_states=False)
        return system

    def save(self, path: str | Path) -> Path:
        """Write matrices, names and operating point to a `.json`, `.mat` or `.npz` file.

        An existing file is replaced.
        """
        path = Path(path)
        writers: dict[str, Callable[..., None]] = {".json": _write_json, ".mat": _write_mat, ".npz": np.savez}
        writer = by_suffix(path, writers)
        content = {name: getattr(self, name) for name in (*LinearModel.__dataclass_fields__, *self.more)}
        return write_whole(path, lambda stream: writer(stream, **content))


def index_of(names: tuple[str, ...], name: str, kind: str) -> int:
    """Return the index of an input or output of a linear model.

    `names` contains the valid addresses. An address that is not among them raises an error with a suggestion. `kind` is
    the word for the address in this error, for example "input".
    """
    if name not in names:
        suggestion = NameSuggestion(name, names)
        raise InputError("names.unknown", name, meaning=f"an {kind} of the linear model", suggestion=suggestion)
    return names.index(name)


def balancing_scale(matrix: Array) -> Array:
    """Return scale factors of the states that balance rows and columns of a matrix.

    The scaling is necessary because pressures, masses and strokes in SI units differ by ten orders of magnitude.
    """
    from scipy.linalg import matrix_balance

    if not matrix.size:
        return np.ones(0)
    # SciPy also converts the factors to integers, for permutations that are not used here.
    with np.errstate(invalid="ignore"):
        return np.asarray(matrix_balance(matrix, permute=False, separate=True)[1][0])


def _write_json(stream: Any, **content: Any) -> None:
    import json

    lists = {key: np.array(value).tolist() for key, value in content.items()}
    stream.write((json.dumps(lists, indent=1) + "\n").encode())


def _write_mat(stream: Any, **content: Any) -> None:
    from scipy.io import savemat

    # Objects become cell arrays in MATLAB; text arrays would be padded with blanks.
    arrays = {k: v if isinstance(v, np.ndarray) else np.array(v, dtype=object) for k, v in content.items()}
    savemat(stream, arrays, oned_as="column")
