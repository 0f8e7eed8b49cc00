"""Public circuit class, which joins the packages below, and its readers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import read_circuit
from poppet.core.toml_file import TomlFile

if TYPE_CHECKING:
    from poppet.circuit.linear_model import ControlStateSpace, ControlSystem
    from poppet.deploy.casadi_export import CasadiModel
    from poppet.deploy.ode import Ode
    from poppet.ensemble.ensemble_result import Ensemble

LISTED = (
    *("parts", "signals", "connections", "run", "ambient", "gas", "title"),
    *("numbers", "inputs", "parameters", "static_notes", "model"),
    *("with_values", "with_signals", "resumed", "simulate", "steady_state", "linearise", "ensemble"),
    *("to_ode", "to_casadi", "to_control"),
)
"""Names of a circuit that editors list: fields, contents, variants, analyses, conversions."""


class _ListedNames(type):
    """Metaclass that lists only the names in `LISTED`: editors inspect the class as well as its objects."""

    def __dir__(cls) -> list[str]:
        return sorted(LISTED)


class Circuit(BaseCircuit, metaclass=_ListedNames):
    """Parts joined into a network, ready to run.

    Parameters
    ----------
    parts : mapping
        Name to part. Ports contain names of gas nodes, or `ambient` for the ambient air.
    signals : mapping, optional
        Address of an input, `valve.pilot_pressure`, to its signal in SI units.
    run : Run, optional
        Duration, output step, tolerance, stop conditions.
    ambient : Ambient, optional
        Pressure and temperature of the surroundings.
    gas : GasChoice or Gas, optional
        Gas constant and isentropic exponent, or a gas from `poppet.library.gas`.
    title : str, optional
        Title of all results.
    connections : mapping, optional
        Address of an input to the connected output: ``{"main.pilot_pressure": "pilot.pressure"}``.
    origin : Origin, optional
        Tables and folder of the circuit file.
    like : Circuit, optional
        A similar circuit, already checked. Unchanged parts are reused and not checked again.

    Raises
    ------
    InputErrors
        With all wiring errors.

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

    def __dir__(self) -> list[str]:
        return sorted(LISTED)

    def ensemble(
        self,
        output: str | Path | None = None,
        *,
        executor: Any = "threads",
        workers: int | None = None,
        progress: Callable[[int, int, str], Any] | None = None,
        requirements: Mapping[str, str] | None = None,
        **fields: Any,
    ) -> Ensemble:
        """Run the circuit many times with uncertain parameters.

        Parameters
        ----------
        output : str or Path, optional
            Folder of the dataset; default a temporary folder. An incomplete dataset in the folder is completed.
        executor : str or object, optional
            `threads`, `processes`, the address of a Dask scheduler, a `distributed.Client`, or any
            `concurrent.futures.Executor`. The results are identical for all executors.
        workers : int, optional
            Number of threads or processes; default one per processor.
        progress : callable, optional
            Called with the number of completed runs, the total, and the kind of run: `runs`, `tornado` or `indices`.
        requirements : mapping, optional
            Name to requirement, `fill_time < 12 s`; default the table `requirements` of the circuit file.
        **fields
            Fields of the table `ensemble` of a circuit file: `runs`, `seed`, `sampling`, `numbers`, `metrics`, `keep`,
            `curves`, `indices`, `levels`, `file`. They override the fields of the circuit file.

        Returns
        -------
        Ensemble
            Dataset, yield, bands, influence of each parameter, worst cases.

        Raises
        ------
        InputErrors
            With all errors of the tables; or if the folder contains other data.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", wall_conductance=1.0)
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> ensemble = Circuit({"tank": tank, "vent": vent}).with_values({"run.duration": "1 s"}).ensemble(
        ...     runs=200,
        ...     numbers={"tank.volume": {"distribution": "uniform", "relative_range": 0.1}},
        ...     metrics={"end": {"of": "tank.pressure", "metric": "final", "unit": "bar"}},
        ...     requirements={"low": "end < 1.4 bar"},
        ... )
        >>> ensemble.yields()[0].good, ensemble.yields()[0].runs
        (200, 200)
        """
        from poppet.ensemble.ensemble_result import run_ensemble

        return run_ensemble(
            self, output, executor=executor, workers=workers, progress=progress, requirements=requirements, **fields
        )

    def to_ode(self, duration: Any = None) -> Ode:
        r"""Return the circuit with its signals as plain functions, :math:`\dot x = f(t, x)`, for any solver.

        Parameters
        ----------
        duration : float or str, optional
            Time range of the signals [s]; default that of `run`.

        Returns
        -------
        Ode
            `f(t, x)`, `jac(t, x)`, `outputs(t, x)`, `x0`, names and tolerances; `stretch` for sampled circuits.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", thermal="isothermal")
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> ode = Circuit({"tank": tank, "vent": vent}).to_ode("1 s")
        >>> ode.states, bool(ode.f(0.0, ode.x0)[0] < 0.0)
        (('tank.mass',), True)
        """
        from poppet.deploy.ode import to_ode

        return to_ode(self, duration)

    def to_casadi(
        self,
        *,
        inputs: Sequence[str] | None = None,
        numbers: Sequence[str] = (),
        without: str | Sequence[str] = (),
    ) -> CasadiModel:
        r"""Return the circuit as CasADi functions, :math:`\dot x = f(x, u, p)`, :math:`y = g(x, u, p)`.

        Parameters
        ----------
        inputs : sequence of str, optional
            Addresses of the inputs in u; default all. Other inputs are constant at their values at the start of a run.
        numbers : sequence of str, optional
            Addresses of the parameters in p. Other parameters keep their values.
        without : str or sequence of str, optional
            Controllers to omit. Inputs that they set become free.

        Returns
        -------
        CasadiModel
            `f`, `g`, `start`, names, units, values at the start.

        Raises
        ------
        InputErrors
            If an address is unknown, other parameters depend on one in p, or the circuit is sampled or switched.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", thermal="isothermal")
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> model = Circuit({"tank": tank, "vent": vent}).to_casadi(numbers=["tank.volume"])
        >>> print(model.f)
        f:(x,u,p)->(rates) SXFunction
        """
        from poppet.deploy.casadi_export import to_casadi

        return to_casadi(self, inputs=inputs, numbers=numbers, without=without)

    @overload
    def to_control(
        self,
        *,
        linear: Literal[False] = False,
        inputs: Sequence[str] | None = None,
        numbers: Sequence[str] = (),
        without: str | Sequence[str] = (),
    ) -> ControlSystem: ...
    @overload
    def to_control(self, *, linear: Literal[True], without: str | Sequence[str] = ()) -> ControlStateSpace: ...
    @overload
    def to_control(
        self,
        *,
        linear: bool,
        inputs: Sequence[str] | None = None,
        numbers: Sequence[str] = (),
        without: str | Sequence[str] = (),
    ) -> ControlSystem: ...
    def to_control(
        self,
        *,
        linear: bool = False,
        inputs: Sequence[str] | None = None,
        numbers: Sequence[str] = (),
        without: str | Sequence[str] = (),
    ) -> ControlSystem:
        """Return the circuit as a system of python-control.

        Parameters
        ----------
        linear : bool, optional
            Return the linear model at the steady state; in discrete time if the circuit is sampled.
        inputs, numbers, without : optional
            See `to_casadi`; numbers become `params`.

        Returns
        -------
        control.NonlinearIOSystem or control.StateSpace
            Names contain a double underscore for each dot.

        Raises
        ------
        InputErrors
            See `to_casadi`.
        """
        from poppet.deploy.casadi_export import to_control

        return to_control(self, linear=linear, inputs=inputs, numbers=numbers, without=without)


def load(path: str | Path) -> Circuit:
    """Read a circuit file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/circuit_file.md`.

    Returns
    -------
    Circuit
        Checked and ready to run.

    Raises
    ------
    InputErrors
        With all errors of the file and their line numbers, if available.
    """
    return read_circuit(TomlFile.read(path, "parts"), Circuit)


def loads(text: str, *, name: str = "circuit", folder: Path | None = None) -> Circuit:
    """Read a circuit from text.

    Parameters
    ----------
    text : str
        Content of a circuit file.
    name : str, optional
        File name in error messages.
    folder : Path, optional
        Folder for relative paths; default the working directory.

    Returns
    -------
    Circuit
        Checked and ready to run.
    """
    return read_circuit(TomlFile(text, name, folder or Path()), Circuit)
