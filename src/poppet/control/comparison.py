"""Controllers compared on one plant: the same setpoint, sample time, delay, sensor, limits and uncertain numbers."""

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
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.files import by_suffix, write_whole
from poppet.engine.solve import solve
from poppet.parts.quantities import COMMANDS, OPENING, QUANTITIES, command_of
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.circuit.instance import Instance
    from poppet.circuit.options import Run

Array = NDArray[np.float64]

_SHARED = ("sample_time", "sensor.lag", "sensor.offset", "fill_limit", "vent_limit", "lower_limit", "upper_limit")
"""Numbers of the controllers in which a fair comparison allows no difference."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Controllers on one plant, with its nominal numbers and with drawn ones.

    Parameters
    ----------
    time : (n,) array
        Sampling instants [s].
    setpoint : (n,) array
        Of all controllers, SI.
    responses : dict
        Controller to a (draws + 1, n) array of what is measured, the nominal run first; rows of failed runs are not
        numbers. SI.
    commands : dict
        Controller to its command in the nominal run, an (n,) array: the opening that fills less the one that vents, or
        in SI.
    figures : dict
        Controller to figure to a (draws + 1,) array, the nominal run first, as `kinds` says.
    factors : dict
        Address of each uncertain number to a (draws + 1,) array of factors on it.
    ranges : dict
        Address to the relative range that was drawn from.
    seed : int
        Of the draws.
    quantity, command_quantity : str
        What is controlled, and what commanded.
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
        """SI units of what is controlled and commanded."""
        return QUANTITIES[self.quantity].unit, COMMANDS[self.command_quantity].unit

    @property
    def kinds(self) -> dict[str, StepMetric]:
        """The figures with their units and meanings."""
        return metrics_in(*self.units)

    @property
    def draws(self) -> int:
        """Number of draws beside the nominal run."""
        return len(next(iter(self.responses.values()))) - 1

    @property
    def failed(self) -> dict[str, int]:
        """How many runs of each controller did not reach their end."""
        return {name: int(np.sum(np.isnan(rows[:, -1]))) for name, rows in self.responses.items()}

    def summary(self) -> dict[str, dict[str, tuple[float, float, float]]]:
        """Nominal value, median of the draws and the worst of them.

        Returns
        -------
        dict
            Controller to figure to the three; without draws all are nominal.
        """
        return {
            name: {
                key: (float(values[0]), float(np.median(_drawn(values))), float(np.max(_drawn(values))))
                for key, values in own.items()
            }
            for name, own in self.figures.items()
        }

    def save(self, path: str | Path) -> Path:
        """Write one row per run: controller, draw, factors, figures.

        Parameters
        ----------
        path : str or Path
            Ends in `.csv`.

        Returns
        -------
        Path
            Where it was written.
        """
        target = Path(path)
        writer = by_suffix(target, {".csv": self._csv})
        return write_whole(target, lambda stream: stream.write(writer().encode()))

    def _csv(self) -> str:
        heads = [f"{key} [{each.unit}]" for key, each in self.kinds.items()]
        rows = [["controller", "draw", *self.factors, *heads]]
        for name, own in self.figures.items():
            for k in range(self.draws + 1):
                values = [*(factor[k] for factor in self.factors.values()), *(own[key][k] for key in self.kinds)]
                rows.append([name, str(k), *(f"{value:.10g}" for value in values)])
        return "".join(",".join(row) + "\n" for row in rows)


def _drawn(values: Array) -> Array:
    return values[1:] if len(values) > 1 else values


def compare(
    circuits: Mapping[str, Circuit], controller: str | None = None, *, vary: Mapping[str, float] | None = None,
    draws: int = 50, seed: int = 0, progress: Callable[[int, int], Any] | None = None,
) -> Comparison:  # fmt: skip
    """Run several controllers on one plant, nominal and with uncertain numbers; none of them knows the draws.

    Parameters
    ----------
    circuits : mapping
        Name of each contender to its circuit; they may differ in the controller only.
    controller : str, optional
        Name of the controller's part, the same in all; needed where there are several.
    vary : mapping, optional
        Address of a number of the plant, or of the sensor, to its relative range: 0.2 draws between 0.8 and 1.2 times
        the nominal value, evenly.
    draws : int, optional
        How many; without `vary` the nominal run stands alone.
    seed : int, optional
        The same seed draws the same plants.
    progress : callable, optional
        Called with the number of runs done and their total.

    Returns
    -------
    Comparison
        Figures of every run.

    Raises
    ------
    InputErrors
        With every difference that makes it unfair, and every number that cannot be varied.
    """
    ranges = dict(vary or {})
    first = next(iter(circuits.values()), None)
    if first is None:
        raise InputError("control.no_circuits")
    named = plant_of(first, controller).controller
    plants = {name: plant_of(circuit, named) for name, circuit in circuits.items()}
    with ErrorCollector() as errors:
        shape = _shape(first, next(iter(plants.values())))
        for name, circuit in circuits.items():
            _check_fair(errors, name, (circuit, _shape(circuit, plants[name])), (first, shape), named)
        _check_varied(errors, first, named, ranges)
        if draws < 0:
            errors.extend([OutOfRangeError("control.draws", draws=draws)])
    count = draws if ranges else 0
    drawn = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, len(ranges)))
    factors = {
        address: np.concatenate([[1.0], 1.0 + size * drawn[:, k]]) for k, (address, size) in enumerate(ranges.items())
    }
    runs = {name: _Contender(circuit.instance, circuit.run, plants[name]) for name, circuit in circuits.items()}
    total = len(runs) * (count + 1)
    for k in range(count + 1):
        for j, runner in enumerate(runs.values()):
            runner.run({address: float(values[k]) for address, values in factors.items()})
            if progress is not None:
                progress(k * len(runs) + j + 1, total)
    some = next(iter(runs.values()))
    return Comparison(
        some.time, some.setpoint, {name: np.array(each.responses) for name, each in runs.items()},
        {name: each.command for name, each in runs.items()},
        {name: {key: np.array([f[key] for f in each.figures]) for key in some.kinds} for name, each in runs.items()},
        factors, ranges, seed, some.part.controls, command_of(some.part),
    )  # fmt: skip


class _Contender:
    """One circuit, run again and again with numbers multiplied."""

    def __init__(self, instance: Instance, options: Run, plant: Plant) -> None:
        own, self.part = plant.controller, plant.part
        self.instance, self.kinds = instance, metrics_in(self.part.unit, self.part.command_unit)
        self.run_options = replace(options, output_step=instance.parameters[f"{own}.sample_time"])
        self.time: Array = self.run_options.grid()
        self.setpoint: Array = np.asarray(instance.signals[f"{own}.setpoint"].evaluate(self.time))
        names = [name for name, _ in instance.model.outputs]
        commands = ("fill_command", "vent_command") if self.part.is_of_openings else ("command",)
        self.rows = [names.index(address) for address in (plant.measurement, *(f"{own}.{c}" for c in commands))]
        self.responses: list[Array] = []
        self.figures: list[dict[str, float]] = []
        self.command: Array = np.zeros(0)

    def run(self, factors: Mapping[str, float]) -> None:
        values = {address: factor * self.instance.parameters[address] for address, factor in factors.items()}
        changed = self.instance.with_values(values) if values else self.instance
        raw = solve(changed.problem(self.run_options), self.run_options.solver)
        missing = len(self.time) - raw.time.size  # rows that a run which failed did not reach
        measured, *given = np.pad(raw.values[self.rows], ((0, 0), (0, missing)), constant_values=np.nan)
        if not self.responses:
            self.command = given[0] - given[1] if len(given) > 1 else given[0]
        self.responses.append(measured)
        found = step_metrics(self.time, self.setpoint, measured, *given)
        # A run that failed is worse than any other.
        self.figures.append(dict.fromkeys(self.kinds, np.inf) if missing else found)


def _check_fair(
    errors: ErrorCollector, name: str, own: tuple[Circuit, Any], first: tuple[Circuit, Any], controller: str
) -> None:
    """What in a circuit differs from the first beside the controller's own law; each with its shape."""
    here, there = ({**circuit.parameters, **shape} for circuit, shape in (own, first))
    for what in sorted({*here, *there}):
        of_controller = what.startswith(f"{controller}.") and what.removeprefix(f"{controller}.") not in _SHARED
        if not of_controller and here.get(what) != there.get(what):
            errors.add("control.unfair", what, value=here.get(what), first=there.get(what), circuit=name)
    # Figures are those of steps: a ramp has no rise time.
    if not isinstance(own[0].signals.get(f"{controller}.setpoint"), Steps):
        errors.add("control.no_staircase", f"{controller}.setpoint", circuit=name)


def _shape(circuit: Circuit, plant: Plant) -> dict[str, Any]:
    """What has to be equal beside the numbers; it is the parts that are compared, which no instance knows."""
    return {
        "parts": [each.structure() for name, each in circuit.parts.items() if name != plant.controller],
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


def _check_varied(errors: ErrorCollector, circuit: Circuit, controller: str, ranges: Mapping[str, float]) -> None:
    numbers = circuit.numbers()
    sensor = {f"{controller}.sensor.lag", f"{controller}.sensor.offset"}
    for address, size in ranges.items():
        if address not in numbers:
            errors.add(
                "names.unknown", address, meaning="a parameter of this circuit", near=NameSuggestion(address, numbers)
            )
        elif address.startswith(f"{controller}.") and address not in sensor:
            errors.add("control.vary.of_controller", address)
        elif circuit.parameters.get(address, 0.0) == 0.0:  # a range is a part of the value
            errors.add("control.vary.zero", address)
        elif not 0.0 < size < 1.0:
            errors.extend([OutOfRangeError("control.vary.range", address, size=size)])
