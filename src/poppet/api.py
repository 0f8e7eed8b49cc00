"""Public class `Circuit`, and the functions that read it from files and texts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self, overload

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import read_circuit
from poppet.core.toml_file import TomlFile

if TYPE_CHECKING:
    from poppet.circuit.linear_model import ControlStateSpace, ControlSystem
    from poppet.circuit.stepper import Stepper
    from poppet.deploy.casadi_export import CasadiModel
    from poppet.deploy.ode import Ode
    from poppet.ensemble.ensemble_result import Ensemble
    from poppet.identify.fit.fit_circuit import Data as RecordedData
    from poppet.identify.fit.fit_circuit import FitResult
    from poppet.serve.machine import Machine

LISTED = (
    *("parts", "signals", "connections", "run", "ambient", "gas", "title"),
    *("numbers", "inputs", "parameters", "static_notes", "model"),
    *("with_values", "with_signals", "resumed", "simulate", "steady_state", "linearise", "stepper", "fit", "ensemble"),
    "serve",
    *("to_ode", "to_casadi", "to_control"),
)
"""Names of a circuit that editors list: fields, contents, variants, analyses, conversions."""


class _ListedNames(type):
    """Metaclass of `Circuit`, with which editors suggest only the names in `LISTED` for the class."""

    def __dir__(cls) -> list[str]:
        return sorted(LISTED)


class Circuit(BaseCircuit, metaclass=_ListedNames):
    """Network of parts with signals, connections and run options, ready to run.

    Parameters
    ----------
    parts : mapping
        Mapping from name to part. The ports of a part are names of gas nodes, or `ambient` for the ambient air.
    signals : mapping, optional
        Mapping from the address of an input, for example `valve.pilot_pressure`, to a signal in SI units.
    run : Run, optional
        Duration, output step, tolerance, stop conditions.
    ambient : Ambient, optional
        Pressure and temperature of the surroundings.
    gas : GasChoice or Gas, optional
        Gas constant and isentropic exponent, or a gas from `poppet.library.gas`.
    title : str, optional
        Title of all results.
    connections : mapping, optional
        Mapping from the address of an input to that of an output: ``{"main.pilot_pressure": "pilot.pressure"}``.
    origin : Origin, optional
        Tables of the circuit file and its folder, to which relative paths refer.
    like : Circuit, optional
        Similar circuit. Parts that are the same objects in both circuits are not checked again.

    Raises
    ------
    InputErrors
        If the wiring is invalid; all errors are reported together.

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

    def fit(
        self,
        recordings: RecordedData | Mapping[str, RecordedData],
        free: Sequence[str] | Mapping[str, Any],
        *,
        outputs: Sequence[str] | None = None,
        bounds: Mapping[str, Sequence[Any]] | None = None,
        priors: Mapping[str, Sequence[Any]] | None = None,
        start: Mapping[str, Any] | None = None,
        noise: Mapping[str, str | float] | None = None,
        offsets: Mapping[str, Any] | None = None,
        hold: bool = True,
        validation: Sequence[str] = (),
        loss: Literal["linear", "soft_l1", "huber", "cauchy"] = "linear",
        starts: int = 1,
        seed: int = 0,
        kicks: int | None = None,
        profile: Sequence[str] = (),
        bootstrap: int = 0,
        contour: bool = False,
        title: str | None = None,
        progress: Callable[[int, float], Any] | None = None,
        stages: Callable[[str, int, int], Any] | None = None,
    ) -> FitResult[Self]:
        """Fit parameters of the circuit to recordings.

        Parameters
        ----------
        recordings : Recording, DataFrame or mapping
            One recording, or a mapping from names to recordings. A `pandas.DataFrame` has addresses as column labels,
            with or without a unit: ``"tank.pressure [bar g]"``. A column without a unit is in SI units. The time is the
            column ``time [s]`` or the index.
        free : sequence of str or mapping
            Addresses of the free parameters, or a mapping from these addresses to start values of the search. A start
            value is a number in SI units, a text with a unit, or a table with `start`, `min`, `max`. The default is the
            value in the circuit.
        outputs : sequence of str, optional
            Addresses of the recorded series that are compared with the model. By default they are all series that are
            outputs of the circuit and change; a series that is no output or input of the circuit is then an error.
        bounds : mapping, optional
            Mapping from the address of a free parameter to ``(min, max)``. None stands for the physical limit.
        priors : mapping, optional
            Mapping from the address of a free parameter to ``(mean, standard deviation)`` of its normal prior.
        start : mapping, optional
            Mapping from the address of an initial value to a value, ``"first"`` (first value of the recorded series) or
            ``"free"`` (fitted for each recording). ``{name: {address: value}}`` applies to the recording `name` only.
        noise : mapping, optional
            Mapping from the address of an output to the standard deviation of its noise. By default it is estimated
            from the residuals.
        offsets : mapping, optional
            Mapping from the address of an output to the prior of the offset of its sensor, which is then fitted: a
            standard deviation, ``(mean, standard deviation)``, or ``"free"`` for no prior.
        hold : bool, optional
            If True, a recorded input is constant from each row to the next. If False, it is interpolated linearly.
        validation : sequence of str, optional
            Names of recordings that are compared with the model, but not fitted.
        loss : str, optional
            `linear`, or a robust loss: `soft_l1`, `huber`, `cauchy`.
        starts : int, optional
            Number of start points of the search.
        seed : int, optional
            Seed of the random numbers for start points and bootstrap.
        kicks : int, optional
            Maximum number of rounds of restarts near the optimum. The default is 3, or 0 for sampled circuits.
        profile : sequence of str, optional
            Names of parameters whose intervals are computed by profile likelihood.
        bootstrap : int, optional
            Number of bootstrap fits.
        contour : bool, optional
            If True, compute the chi-square contour over sonic conductance and wall conductance.
        title : str, optional
            Title of the result (default: title of the circuit).
        progress : callable, optional
            Function that is called with the number of evaluations and the lowest cost.
        stages : callable, optional
            Function that is called during profiles and bootstrap with the name of the stage, the number of completed
            fits and their total.

        Returns
        -------
        FitResult
            Estimates with 95 % confidence intervals and verdicts, findings, and the fitted circuit.

        Raises
        ------
        InputErrors
            If an address or a unit is invalid, a recording has no usable samples, an input is missing, input and
            outputs do not overlap in time, or a free parameter changes no compared output.

        Notes
        -----
        A recorded input drives the model; an input without a recorded series has the signal of the circuit. The first
        used row of a recording is the time t = 0 of the simulation.

        Examples
        --------
        >>> import numpy as np
        >>> from poppet import Chamber, Circuit, Orifice, Recording
        >>> valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> tank = Chamber(volume="20 l", initial_pressure="7 bar", wall_conductance="5 W/K")
        >>> circuit = Circuit({"tank": tank, "valve": valve})
        >>> run = circuit.simulate("40 s", "0.1 s")
        >>> pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, 500.0, run.time.size)
        >>> measured = Recording.from_series(run.time, {"tank.pressure [Pa]": pressure})
        >>> result = circuit.fit(measured, {"valve.sonic_conductance": 2e-8, "valve.critical_ratio": 0.2})
        >>> round(1e8 * result["valve.sonic_conductance"].value, 2), result["valve.critical_ratio"].verdict
        (1.0, 'determined')
        >>> fitted = result.circuit.simulate("40 s")
        """
        from poppet.identify.fit.fit_circuit import fit_circuit

        return fit_circuit(
            self, recordings, free, outputs=outputs, bounds=bounds, priors=priors, start=start, noise=noise,
            offsets=offsets, hold=hold, validation=validation, loss=loss, starts=starts, seed=seed, kicks=kicks,
            profile=profile, bootstrap=bootstrap, contour=contour, title=title, progress=progress, stages=stages,
        )  # fmt: skip

    def ensemble(
        self,
        output: str | Path | None = None,
        *,
        executor: Any = "threads",
        workers: int | None = None,
        progress: Callable[[int, int, str], Any] | None = None,
        requirements: Mapping[str, str] | None = None,
        allow_python: bool = False,
        **fields: Any,
    ) -> Ensemble:
        """Run the circuit many times with uncertain parameters.

        Parameters
        ----------
        output : str or Path, optional
            Folder for the dataset of all runs (default: a temporary folder). An incomplete dataset in the folder is
            completed.
        executor : str or object, optional
            `threads`, `processes`, the address of a Dask scheduler, a `distributed.Client`, or any
            `concurrent.futures.Executor`. The results are identical for all executors.
        workers : int, optional
            Number of threads or processes (default: one per processor).
        progress : callable, optional
            Function that is called with the number of completed runs, the total, and the kind of run: `runs`, `tornado`
            or `indices`.
        requirements : mapping, optional
            Mapping from names to requirements such as `fill_time < 12 s` (default: table `requirements` of the
            circuit file).
        allow_python : bool, optional
            Permit metrics by Python functions in files, `FILE.py:FUNCTION`, which executes these files.
        **fields
            Fields of the table `ensemble` of a circuit file: `runs`, `seed`, `sampling`, `parameters`, `metrics`,
            `keep`, `curves`, `indices`, `levels`, `file`. They override the fields of the circuit file.

        Returns
        -------
        Ensemble
            Result with the dataset, the yield, percentile bands, the influence of each parameter and the worst runs.

        Raises
        ------
        InputErrors
            If a field is invalid, or if the folder contains other data. All errors are reported together.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", wall_conductance=1.0)
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> ensemble = Circuit({"tank": tank, "vent": vent}).with_values({"run.duration": "1 s"}).ensemble(
        ...     runs=200,
        ...     parameters={"tank.volume": {"distribution": "uniform", "relative_range": 0.1}},
        ...     metrics={"end": {"of": "tank.pressure", "metric": "final", "unit": "bar"}},
        ...     requirements={"low": "end < 1.4 bar"},
        ... )
        >>> ensemble.yields()[0].good, ensemble.yields()[0].runs
        (200, 200)
        """
        from poppet.ensemble.ensemble_result import run_ensemble

        return run_ensemble(
            self, output, executor=executor, workers=workers, progress=progress, requirements=requirements,
            allow_python=allow_python, **fields,
        )  # fmt: skip

    def stepper(
        self, free: Sequence[str] = (), *, outputs: Sequence[str] | None = None, tolerance: float = 1e-6
    ) -> Stepper:
        """Return the circuit as an object that steps from any state, for controllers, estimators and environments.

        Parameters
        ----------
        free : sequence of str, optional
            Addresses of free parameters, which can have other values in each step (default: none).
        outputs : sequence of str, optional
            Addresses of the outputs (default: all).
        tolerance : float, optional
            Relative tolerance of the solver.

        Returns
        -------
        Stepper
            Object with the methods `step`, `steps`, `outputs_at`, `derivatives` and `transition`.

        Raises
        ------
        InputErrors
            If an address is unknown, or other parameters depend nonlinearly on a free parameter.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, Orifice
        >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", thermal="isothermal")
        >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
        >>> circuit = Circuit({"tank": tank, "vent": vent})
        >>> stepper = circuit.stepper(["vent.sonic_conductance"], outputs=["tank.pressure"])
        >>> x = stepper.step(stepper.start(), 0.01)
        >>> stepper.outputs_at(x).round(-2).tolist()
        [297000.0]
        >>> x = stepper.step(x, 0.01, free=[2e-8])
        >>> stepper.outputs_at(x).round(-2).tolist()
        [291200.0]
        """
        from poppet.circuit.stepper import Stepper

        return Stepper(self.instance, free, outputs, tolerance)

    def serve(
        self, period: Any = 0.01, *, speed: float = 1.0, clock: bool = True, allow_native: bool = False
    ) -> Machine:
        """Start the circuit as a virtual device, whose inputs can be written while it runs.

        Parameters
        ----------
        period : float or str, optional
            Time between two exchanges of values [s].
        speed : float, optional
            Ratio of the time of the machine to real time; `math.inf` for a machine that does not wait.
        clock : bool, optional
            If True, the machine runs in real time in a process of its own until it is stopped. If False, only the
            method `advance` runs it, in the calling thread: the same calls then give the same values.
        allow_native : bool, optional
            Permit the FMUs of the circuit to execute native code, which has all rights of the user.

        Returns
        -------
        Machine
            Context manager that stops the machine at its end.

        Raises
        ------
        InputErrors
            If the period or the speed is invalid.

        Notes
        -----
        The machine runs until it is stopped: `run.duration` and the stop conditions of the circuit are ignored. A
        script that starts a machine with a clock needs the line ``if __name__ == "__main__":``, because the new process
        imports the script.

        Examples
        --------
        >>> from poppet import Chamber, Circuit, DirectionalValve, Reservoir
        >>> circuit = Circuit({
        ...     "supply": Reservoir(pressure="7 bar"),
        ...     "valve": DirectionalValve(
        ...         supply="supply", outlet="tank", exhaust="ambient", sonic_conductance=1e-8, critical_ratio=0.3
        ...     ),
        ...     "tank": Chamber(volume="1 l"),
        ... })
        >>> with circuit.serve(clock=False) as machine:
        ...     machine.write({"valve.command": 1.0})
        ...     machine.set_fault("valve", "stuck_closed")
        ...     closed = machine.advance("1 s")["tank.pressure"]
        ...     machine.set_fault("valve", "none")
        ...     filled = machine.advance("1 s")["tank.pressure"]
        >>> round(closed), filled > 6e5
        (100000, True)
        """
        from poppet.serve.start import start_machine

        return start_machine(self, period, speed, has_clock=clock, allow_native=allow_native)

    def to_ode(self, duration: Any = None) -> Ode:
        r"""Return the circuit with its signals as functions of a differential equation.

        .. math:: \dot x = f(t, x)

        Parameters
        ----------
        duration : float or str, optional
            Time range of the signals [s] (default: duration in the run options of the circuit).

        Returns
        -------
        Ode
            Object with the functions `f(t, x)`, `jac(t, x)` (Jacobian) and `outputs(t, x)`, the initial state `x0`,
            names and tolerances. For sampled circuits, its method `stretch` returns the interval up to the next
            discrete change.

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
        r"""Return the circuit as CasADi functions of states x, inputs u and parameters p.

        .. math:: \dot x = f(x, u, p), \qquad y = g(x, u, p)

        Parameters
        ----------
        inputs : sequence of str, optional
            Addresses of the inputs in u (default: all). Other inputs are constant, with their values at the start of a
            run.
        numbers : sequence of str, optional
            Addresses of the parameters in p (default: none). Other parameters are constant.
        without : str or sequence of str, optional
            Names of controllers to omit. The inputs that they drive can then be in u.

        Returns
        -------
        CasadiModel
            Functions `f` and `g`, initial state `start`, and names, units and initial values of x, u, p and y.

        Raises
        ------
        InputErrors
            If an address is unknown, other parameters depend on one in p, or the circuit contains sampled or switched
            parts.

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
            If True, return the linear model at the steady state, in discrete time if the circuit is sampled.
        inputs, numbers, without : optional
            Same arguments as in `to_casadi`. The parameters in `numbers` are the `params` of the system.

        Returns
        -------
        control.NonlinearIOSystem or control.StateSpace
            System whose signal names are addresses with a double underscore for each dot.

        Raises
        ------
        InputErrors
            In the same cases as in `to_casadi`.
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
        Circuit that is checked and ready to run.

    Raises
    ------
    InputErrors
        If the file is invalid; all errors are reported together, with line numbers if available.
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
        Folder for relative paths (default: working directory).

    Returns
    -------
    Circuit
        Circuit that is checked and ready to run.
    """
    return read_circuit(TomlFile(text, name, folder or Path()), Circuit)
