"""A linear model: matrices, names and point; eigenvalues, frequency response, files, python-control."""

from __future__ import annotations

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
    """Input-output system of python-control, which has no type hints; other attributes have type `Any`."""

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
        """Return the rates of the states, or the next states in discrete time."""

    def output(self, t: float, x: Array, u: Array, params: dict[str, float] | None = None) -> Array:
        """Return the outputs."""

    def __getattr__(self, name: str) -> Any: ...


class ControlStateSpace(ControlSystem, Protocol):
    """State-space model of python-control, `control.StateSpace`."""

    A: Array
    B: Array
    C: Array
    D: Array

    def poles(self) -> NDArray[np.complex128]:
        """Return the poles [1/s], or of the z-plane in discrete time."""

    def zeros(self) -> NDArray[np.complex128]:
        """Return the transmission zeros."""


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
    found : tuple of Note
        How it was found, and what the circuit does instead of staying there where it would not.
    memory : dict
        Address of every element of the sampled memory to its value, SI; clocks as they are at the start of a run.
    notes : tuple of Note
        Kinks at this point, beyond which a linear model does not hold.
    is_stable : bool
        False where the circuit would not stay there.
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
        """How it was found, in words."""
        return " ".join(map(str, self.found))


@dataclass(frozen=True, eq=False)
class LinearModel(HtmlMixin):
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
    regularised zone of the flow law, 0.1 % of the upstream pressure by default (`laminar_ratio`): beyond it the flow
    grows with the root of the pressure drop, slower than the linear model says. On a kink the derivative is that of
    one side.
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
    """Further attributes that a file of it holds."""

    def eigenvalues(self) -> NDArray[np.complex128]:
        """Eigenvalues of A, slowest first."""
        # Unbalanced, the rounding of the largest entries would drown slow eigenvalues.
        scale = balance(self.A)
        values = np.linalg.eigvals(self.A * scale[None, :] / scale[:, None]).astype(np.complex128)
        return values[np.lexsort((values.imag, np.abs(values)))]

    def poles(self) -> NDArray[np.complex128]:
        """Poles of the motion in time: here the eigenvalues of A, of a sampled model ln(z)/T."""
        return self.eigenvalues()

    def frequency_response(self, frequencies: ArrayLike, input: str, output: str) -> NDArray[np.complex128]:
        r"""Response of one output to one input.

        .. math:: G(\mathrm{i}\omega) = C\,(\mathrm{i}\omega I - A)^{-1} B + D, \qquad \omega = 2\pi f
        """
        column, row = place(self.inputs, input, "input"), place(self.outputs, output, "output")
        identity = np.eye(len(self.states))
        gains = [
            # One solve for each frequency instead of eigenvectors, which are useless near a multiple eigenvalue.
            self.C[row] @ np.linalg.solve(2j * np.pi * f * identity - self.A, self.B[:, column]) + self.D[row, column]
            for f in np.atleast_1d(np.asarray(frequencies, dtype=float))
        ]
        return np.array(gains, dtype=np.complex128)

    def to_control(self) -> ControlStateSpace:
        """Return the model as a `control.StateSpace`."""
        with needed("control", "A control.StateSpace", "control"):
            import control
        groups = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        # python-control takes a dot for the border between system and signal.
        names = {kind: [name.replace(".", "__") for name in group] for kind, group in groups.items()}
        # States that do not reach an output are of interest here: they have names and eigenvalues.
        system: ControlStateSpace = control.ss(self.A, self.B, self.C, self.D, **names, remove_useless_states=False)
        return system

    def save(self, path: str | Path) -> Path:
        """Write the matrices, names and point; an existing file is replaced as a whole or not at all."""
        path = Path(path)
        writer = by_suffix(path, {".json": _write_json, ".mat": _write_mat, ".npz": _write_npz})
        return write_whole(path, lambda stream: writer(self, stream))


def place(names: tuple[str, ...], name: str, kind: str) -> int:
    """Place of an address, or an error that names the nearest."""
    if name not in names:
        raise InputError("linear.unknown", name, kind=kind, near=NameSuggestion(name, names))
    return names.index(name)


def balance(matrix: Array) -> Array:
    """Sizes that make rows and columns alike: pressures and masses are ten decades apart."""
    from scipy.linalg import matrix_balance

    if not matrix.size:
        return np.ones(0)
    # SciPy makes integers of the sizes as well, for the permutations that are not asked for.
    with np.errstate(invalid="ignore"):
        return np.asarray(matrix_balance(matrix, permute=False, separate=True)[1][0])


def _content(model: LinearModel) -> dict[str, Any]:
    return {name: getattr(model, name) for name in (*LinearModel.__dataclass_fields__, *model.more)}


def _write_json(model: LinearModel, stream: Any) -> None:
    import json

    plain = {key: np.array(value).tolist() for key, value in _content(model).items()}
    stream.write((json.dumps(plain, indent=1) + "\n").encode())


def _write_mat(model: LinearModel, stream: Any) -> None:
    from scipy.io import savemat

    # Objects become cell arrays in MATLAB; text arrays would be padded with blanks.
    content = {k: v if isinstance(v, np.ndarray) else np.array(v, dtype=object) for k, v in _content(model).items()}
    savemat(stream, content, oned_as="column")


def _write_npz(model: LinearModel, stream: Any) -> None:
    arrays: dict[str, Any] = {key: np.array(value) for key, value in _content(model).items()}
    np.savez(stream, **arrays)
