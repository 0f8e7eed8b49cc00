"""Comparison of controllers on one plant with uncertain parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.control.extraction import plant_of
from poppet.control.metrics import StepMetric, metrics_in, step_metrics
from poppet.control.plant import Plant
from poppet.core.csv_cells import csv_text
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.files import by_suffix, write_whole
from poppet.core.tables import NumberRange
from poppet.engine.solve import solve
from poppet.parts.quantities import COMMANDS, OPENING, QUANTITIES, command_of
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.instance import Instance
    from poppet.circuit.options import Run

Array = NDArray[np.float64]

_SHARED = ("sample_time", "sensor.lag", "sensor.offset", "fill_limit", "vent_limit", "lower_limit", "upper_limit")
"""Parameters that must be equal in all controllers."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Responses of several controllers on one plant.

    The plant has its nominal parameters in one run, and random parameters in the other runs.

    Parameters
    ----------
    time : (n,) array
        Sample instants [s].
    setpoint : (n,) array
        Setpoint of all controllers, SI.
    responses : dict
        Mapping from the name of each controller to a (draws + 1, n) array of the measurement, SI. The first row is the
        nominal run. Values after the failure of a run are NaN.
    commands : dict
        Mapping from the name of each controller to an (n,) array of the command in the nominal run. The command is the
        fill opening minus the vent opening, or another quantity in SI.
    figures : dict
        Mapping from the name of each controller to a mapping from the name of each metric to a (draws + 1,) array. The
        first element is the nominal run.
    factors : dict
        Mapping from the address of each uncertain parameter to a (draws + 1,) array of factors.
    ranges : dict
        Mapping from the address of each uncertain parameter to the relative range of the factors.
    seed : int
        Seed of the random factors.
    quantity, command_quantity : str
        Controlled and commanded quantity.
    """

    time: Array
    setpoint: Array
    responses: Mapping[str, Array]
    commands: Mapping[str, Array]
    figures: Mapping[str, Mapping[str, Array]]
    factors: Mapping[str, Array]
    ranges: Mapping[str, float]
    seed: int
    quantity: str = "pressure"
    command_quantity: str = OPENING

    @property
    def units(self) -> tuple[str, str]:
        """SI unit of the controlled quantity and SI unit of the commanded quantity."""
        return QUANTITIES[self.quantity].unit, COMMANDS[self.command_quantity].unit

    @property
    def kinds(self) -> dict[str, StepMetric]:
        """Unit and meaning of each metric, by the name of the metric."""
        return metrics_in(*self.units)

    @property
    def draws(self) -> int:
        """Number of runs with random plant parameters per controller."""
        return len(next(iter(self.responses.values()))) - 1

    @property
    def failed(self) -> dict[str, int]:
        """Number of failed runs of each controller, by the name of the controller."""
        return {name: int(np.sum(np.isnan(rows[:, -1]))) for name, rows in self.responses.items()}

    def summary(self) -> dict[str, dict[str, tuple[float, float, float]]]:
        """Return nominal value, median and maximum of each metric for each controller.

        Median and maximum refer to the random runs.

        Returns
        -------
        dict
            Mapping from the name of each controller to a mapping from the name of each metric to the three values. If
            there are no random runs, all three are the nominal value.
        """

        def statistics(values: Array) -> tuple[float, float, float]:
            random_runs = values[1:] if len(values) > 1 else values
            return float(values[0]), float(np.median(random_runs)), float(np.max(random_runs))

        return {
            name: {key: statistics(values) for key, values in metrics.items()} for name, metrics in self.figures.items()
        }

    def save(self, path: str | Path) -> Path:
        """Write the metrics of all runs to a CSV file, one run in each row.

        The columns are the name of the controller, the index of the draw (0 for the nominal run), the factors and the
        metrics.

        Parameters
        ----------
        path : str or Path
            File name that ends in `.csv`.

        Returns
        -------
        Path
            Path of the file.
        """
        target = Path(path)
        by_suffix(target, {".csv": None})
        heads = [f"{key} [{metric.unit}]" for key, metric in self.kinds.items()]
        rows = [["controller", "draw", *self.factors, *heads]]
        for name, metrics in self.figures.items():
            for k in range(self.draws + 1):
                values = [*(factor[k] for factor in self.factors.values()), *(metrics[key][k] for key in self.kinds)]
                rows.append([name, str(k), *(f"{value:.10g}" for value in values)])
        return write_whole(target, lambda stream: stream.write(csv_text(rows).encode()))


def compare(
    circuits: Mapping[str, BaseCircuit], controller: str | None = None, *, vary: Mapping[str, float] | None = None,
    draws: int = 50, seed: int = 0, progress: Callable[[int, int], Any] | None = None,
) -> Comparison:  # fmt: skip
    """Run several controllers on one plant, with nominal and with random plant parameters.

    Only parameters of the plant and of the sensor are varied. A plant model inside a controller keeps its nominal
    parameters.

    Parameters
    ----------
    circuits : mapping
        Mapping from a name of each compared controller to the circuit with this controller. The circuits may differ in
        the controller only.
    controller : str, optional
        Name of the controller, the same in all circuits; required if there are several.
    vary : mapping, optional
        Mapping from the address of a parameter of the plant or of the sensor to a relative range. A range of 0.2 means
        that the factors are uniformly distributed from 0.8 to 1.2.
    draws : int, optional
        Number of random runs. If `vary` is omitted, only the nominal run is made.
    seed : int, optional
        Seed of the factors; equal seeds give equal plants.
    progress : callable, optional
        Function that is called with the count of finished runs and the total count.

    Returns
    -------
    Comparison
        Metrics of all runs.

    Raises
    ------
    InputErrors
        If circuits differ in more than the controller, or a parameter cannot be varied.
    """
    ranges = dict(vary or {})
    first = next(iter(circuits.values()), None)
    if first is None:
        raise InputError("control.no_circuits")
    controller_name = plant_of(first, controller).controller
    plants = {name: plant_of(circuit, controller_name) for name, circuit in circuits.items()}
    prefix = f"{controller_name}."
    with ErrorCollector() as errors:
        properties = {name: {**c.parameters, **_properties_to_compare(c, plants[name])} for name, c in circuits.items()}
        first_properties = next(iter(properties.values()))
        for name, circuit in circuits.items():
            for key in sorted({*properties[name], *first_properties}):
                of_controller = key.startswith(prefix) and key.removeprefix(prefix) not in _SHARED
                value, first_value = properties[name].get(key), first_properties.get(key)
                if not of_controller and value != first_value:
                    errors.add("control.unfair", key, value=value, first=first_value, circuit=name)
            # The metrics need steps: a ramp has no rise time.
            if not isinstance(circuit.signals.get(f"{prefix}setpoint"), Steps):
                errors.add("control.no_staircase", f"{prefix}setpoint", circuit=name)
        numbers, relative_range = first.numbers(), NumberRange(unit="1", above=0.0, below=1.0)
        sensor = {f"{controller_name}.sensor.lag", f"{controller_name}.sensor.offset"}
        for address, size in ranges.items():
            if address not in numbers:
                near = NameSuggestion(address, numbers)
                errors.add("names.unknown", address, meaning="a parameter of this circuit", suggestion=near)
            elif address.startswith(f"{controller_name}.") and address not in sensor:
                errors.add("control.vary.of_controller", address)
            elif first.parameters.get(address, 0.0) == 0.0:  # the range is relative to the value
                errors.add("control.vary.zero", address)
            else:
                with errors.collecting():
                    relative_range.check_range(address, size, f"{size:g}", "relative range")
        with errors.collecting():
            NumberRange(unit="1", low=0.0).check_range("draws", draws, str(draws), "count of random runs")
    count = draws if ranges else 0
    random_values = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, len(ranges)))
    columns = zip(ranges.items(), random_values.T, strict=True)
    factors = {address: np.concatenate([[1.0], 1.0 + size * values]) for (address, size), values in columns}
    runs = {name: _Contender(circuit.instance, circuit.run, plants[name]) for name, circuit in circuits.items()}
    total = len(runs) * (count + 1)
    for k in range(count + 1):
        for j, runner in enumerate(runs.values()):
            runner.run({address: float(values[k]) for address, values in factors.items()})
            if progress is not None:
                progress(k * len(runs) + j + 1, total)
    figures = {
        name: {key: np.array([row[key] for row in contender.figures]) for key in contender.kinds}
        for name, contender in runs.items()
    }
    responses = {name: np.array(contender.responses) for name, contender in runs.items()}
    commands = {name: contender.command for name, contender in runs.items()}
    time, setpoint, part = runner.time, runner.setpoint, runner.part  # equal in all circuits
    quantities = part.controls, command_of(part)
    return Comparison(time, setpoint, responses, commands, figures, factors, ranges, seed, *quantities)


class _Contender:
    """One of the compared controllers, with its circuit and the results of its runs."""

    def __init__(self, instance: Instance, options: Run, plant: Plant) -> None:
        controller, self.part = plant.controller, plant.part
        self.instance, self.kinds = instance, metrics_in(self.part.unit, self.part.command_unit)
        self.run_options = replace(options, output_step=instance.parameters[f"{controller}.sample_time"])
        self.time: Array = self.run_options.grid()
        self.setpoint: Array = np.asarray(instance.signals[f"{controller}.setpoint"].evaluate(self.time))
        names = [name for name, _ in instance.model.outputs]
        commands = ("fill_command", "vent_command") if self.part.is_of_openings else ("command",)
        self.rows = [names.index(address) for address in (plant.measurement, *(f"{controller}.{c}" for c in commands))]
        self.responses: list[Array] = []
        self.figures: list[dict[str, float]] = []
        self.command: Array = np.zeros(0)

    def run(self, factors: Mapping[str, float]) -> None:
        values = {address: factor * self.instance.parameters[address] for address, factor in factors.items()}
        changed = self.instance.with_values(values) if values else self.instance
        raw = solve(changed.problem(self.run_options), self.run_options.solver)
        missing = len(self.time) - raw.time.size  # rows after the end of a failed run
        measured, *commands = np.pad(raw.values[self.rows], ((0, 0), (0, missing)), constant_values=np.nan)
        if not self.responses:
            self.command = commands[0] - commands[1] if len(commands) > 1 else commands[0]
        self.responses.append(measured)
        metrics = step_metrics(self.time, self.setpoint, measured, *commands)
        # A failed run has the worst metrics.
        self.figures.append(dict.fromkeys(self.kinds, np.inf) if missing else metrics)


def _properties_to_compare(circuit: BaseCircuit, plant: Plant) -> dict[str, Any]:
    """Return the properties of a circuit that must be equal in all compared circuits.

    The result maps names of properties to values. Parameter values and the controller itself are not included.
    """
    return {
        "parts": [part.structure() for name, part in circuit.parts.items() if name != plant.controller],
        "acts": plant.part.acts,
        "quantity": (plant.part.controls, command_of(plant.part)),
        "measurement": plant.measurement,
        "commands": {key: sorted(plant.commands[key]) for key in sorted(plant.commands)},
        "signals": {
            address: [np.asarray(getattr(signal, name, default)).tolist() for name, default in (
                ("times", [0.0]), ("values", signal.bounds()),
            )]
            for address, signal in sorted(circuit.signals.items())
        },
        "duration": None if circuit.run.duration is None else float(circuit.run.duration),  # type: ignore[arg-type]
    }  # fmt: skip
