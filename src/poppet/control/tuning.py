r"""Automatic tuning of PID controllers on the linear model of the plant, or on its answers to sines of a size.

The gains with the greatest integral gain K/T_i (of a proportional controller: the greatest K) whose sensitivities stay
below a bound, max(Ms, Mt) <= M, for every plant that is given: at each operating point that of the filling and that of
the venting valve, wherever the command rests. After Aastroem, Panagopoulos & Haegglund, Design of PI controllers based
on non-convex optimization, Automatica 34 (1998) 585-601, here for the sampled loop with its hold and delay, and by
search.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.control.describing_function import MeasuredLoop, MeasuredPlant, ProgressCallback, measured_loop
from poppet.control.extraction import plant_of
from poppet.control.loop import Gains, LoopPlant, Margins, SampledPlant, margins, step_response
from poppet.control.metrics import readable
from poppet.control.plant import OperatingPoint, Plant, place
from poppet.control.verification import Verification
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, SimulationError
from poppet.core.provenance import Number, Source
from poppet.core.units import convert
from poppet.parts.gain_schedule import GainSchedule
from poppet.parts.pid import PID
from poppet.parts.quantities import COMMANDS, OPENING, QUANTITIES, command_of, gain_unit
from poppet.parts.rows import as_numbers
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

FORMS = ("pi", "pid", "p")
_SIDES = {"fill": "filling", "vent": "venting", "command": "by one command", "back": "back"}
LEAST_BOUND, GREATEST_BOUND = 1.1, 3.0
_GRID = 400
_GAINS = 121
_TIMES = np.geomspace(2.0, 2e4, 33)
"""Integral times that are tried, in samples."""
_RATIOS = (0.1, 0.2, 0.3, 0.4, 0.5)
"""Derivative times that are tried, in integral times; the integral time of 4 T_d has a double zero."""
_FILTER = 0.125
"""Filter per derivative time: N = 8."""
_OVERSHOOT = 0.05
_WEIGHTS = (1.0, 0.8, 0.6, 0.4, 0.2, 0.0)
_SAMPLES = 20_000


@dataclass(frozen=True)
class TunedPoint:
    """Gains for one or several operating points, and what they achieve.

    Parameters
    ----------
    gains : Gains
        Of the controller.
    vent_factor : float
        Opening of the venting valve per negative command, where there is one.
    setpoint_weight : float
        The greatest of 1, 0.8, ..., 0 with which a step of the linear loop overshoots by 5 % at most.
    overshoot : float
        That it then has, the worst of all plants.
    margins : dict
        Where and which valve, `2 bar, fill`, to the margins there.
    values : tuple of float
        Operating points, SI.
    commands : tuple of float
        That hold them, SI; of openings positive where they fill, and not 0 where the plant leaks.
    plants : dict
        The names of the margins to the plants that were bounded.
    verified : tuple of Verification
        Steps of the plant as it is, of a tuning by sines.
    """

    gains: Gains
    vent_factor: float
    setpoint_weight: float
    overshoot: float
    margins: dict[str, Margins]
    values: tuple[float, ...]
    commands: tuple[float, ...]
    plants: Mapping[str, LoopPlant] = field(default_factory=dict, repr=False, compare=False)
    verified: tuple[Verification, ...] = ()

    @property
    def sides(self) -> tuple[str, ...]:
        """Which of `fill`, `vent`, `command` and `back`, or which sines keep the bound, at all operating points."""
        return tuple(dict.fromkeys(name.partition(", ")[2] for name in self.margins))

    @property
    def is_stable(self) -> bool:
        """True when the loop is stable everywhere."""
        return all(each.is_stable for each in self.margins.values())


@dataclass(frozen=True)
class Tuning:
    """The result of a tuning.

    Parameters
    ----------
    controller : str
        Name of the part.
    points : tuple of TunedPoint
        One for fixed gains, several for a schedule.
    sensitivity : float
        The bound that was asked for.
    form : str
        `pi`, `pid` or `p`.
    quantity, command_quantity : str
        What is controlled, and what commanded.
    notes : tuple of Note
        On the plant that was tuned for.
    """

    controller: str
    points: tuple[TunedPoint, ...]
    sensitivity: float
    form: str
    quantity: str = "pressure"
    command_quantity: str = OPENING
    notes: tuple[Note, ...] = ()

    @property
    def is_scheduled(self) -> bool:
        """True when the gains follow the operating point."""
        return len(self.points) > 1

    @property
    def is_verified(self) -> bool:
        """True for a tuning by sines, whose steps were run."""
        return bool(self.points[0].verified)

    @property
    def bounded(self) -> str:
        """The bound, the sides of the valves and the operating points at which the tuned loops keep it."""
        sides = " and ".join(_SIDES.get(side, f"by {side}") for side in self.points[0].sides)
        unit = QUANTITIES[self.quantity].unit
        shown = readable(unit)
        values = ", ".join(f"{convert(value, unit, shown):.4g}" for point in self.points for value in point.values)
        return f"Ms, Mt <= {self.sensitivity:g} {sides} at {values} {shown}"

    @property
    def held(self) -> str:
        """The commands that hold the operating points, in words."""
        commands = [command for point in self.points for command in point.commands]
        if not any(commands):
            return "at rest"
        unit = COMMANDS[self.command_quantity].unit
        shown = readable(unit)
        values = ", ".join(f"{convert(command, unit, shown):.3g}" for command in commands)
        return f"held by a command of {values}{'' if shown == '1' else f' {shown}'}"

    def fields(self) -> dict[str, Any]:
        """Fields of a `pid` part, with their source.

        Returns
        -------
        dict
            Field to number, schedule, or None for what gives way.
        """
        on = "answers to sines" if self.is_verified else "linear models"
        source = Source("fitted", note=f"tuned on {on} for {self.bounded}")

        def number(value: float, unit: str) -> Number:
            return Number(float(value), unit, source)

        gains = [point.gains for point in self.points]
        common = {
            "derivative_filter": number(max(each.derivative_filter for each in gains), "s"),
            "setpoint_weight": number(min(point.setpoint_weight for point in self.points), "1"),
        }
        columns = {
            "gain": ([each.gain for each in gains], gain_unit(self.quantity, self.command_quantity)),
            "integral_time": ([each.integral_time for each in gains], "s"),
            "derivative_time": ([each.derivative_time for each in gains], "s"),
        }
        if self.command_quantity == OPENING:
            columns["vent_factor"] = ([point.vent_factor for point in self.points], "1")
        if not self.is_scheduled:
            alone = {name: number(values[0], unit) for name, (values, unit) in columns.items()}
            return common | alone | {"schedule": None}
        points = {self.quantity: ([point.values[0] for point in self.points], QUANTITIES[self.quantity].unit)}
        table = {name: as_numbers(values, unit, source) for name, (values, unit) in (points | columns).items()}
        return (
            common | dict.fromkeys(columns) | {"schedule": GainSchedule(table, (self.quantity, self.command_quantity))}
        )

    def applied(self, circuit: Circuit) -> Circuit:
        """The circuit with the tuned controller.

        Parameters
        ----------
        circuit : Circuit
            That was tuned.

        Returns
        -------
        Circuit
            A new one.
        """
        part: PID = circuit.parts[self.controller]  # type: ignore[assignment]
        return replace(circuit, parts={**circuit.parts, self.controller: replace(part, **self.fields())})

    def text(self) -> str:
        """The fields as a table of a circuit file.

        Returns
        -------
        str
            TOML, which `poppet simulate --with` takes too.
        """
        lines = [f"[parts.{self.controller}]"]
        for name, value in self.fields().items():
            if isinstance(value, Number):
                lines.append(f"{name} = {_written(value)}")
            elif isinstance(value, GainSchedule):
                lines.append(f"\n[parts.{self.controller}.schedule]")
                lines += [f"{key} = [{', '.join(map(_written, column))}]" for key, column in value.columns.items()]
        return "\n".join(lines) + "\n"


def _written(number: Number) -> str:
    """A number as a circuit file has it."""
    if number.unit == "1":
        return f"{number.value:.6g}"
    shown = "ms" if number.unit == "s" else readable(number.unit)
    return f'"{convert(number.value, number.unit, shown):.6g} {shown}"'


def tune(
    circuit: Circuit, controller: str | None = None, *, at: Sequence[Any] | None = None, form: str = "pi",
    sensitivity: float = 1.4, amplitudes: Sequence[Any] = (), progress: ProgressCallback | None = None,
) -> Tuning:  # fmt: skip
    """One set of gains that holds the bound at all operating points, filling and venting.

    Parameters
    ----------
    circuit : Circuit
        With a part of kind `pid`; its sample time, delay and sensor count, its gains do not.
    controller : str, optional
        Name of that part; needed where there are several.
    at : sequence of float or str, optional
        Operating points of what is controlled; default the levels of the setpoint's steps.
    form : str, optional
        `pi`, `pid` or `p`.
    sensitivity : float, optional
        Bound M of Ms and Mt: 1.4 is cautious, 2 is fast.
    amplitudes : sequence of float or str, optional
        Sizes of sines of the command, in its unit. The plant then is what it answers to these, with its dead zones,
        friction and holds, instead of its linear model, and the bound is kept for each; a step there and back is run
        with the gains, and what goes wrong in it is among the notes. For plants without a linear model: the smallest
        command that should be followed, and a large one.
    progress : callable, optional
        Called with what is being simulated.

    Returns
    -------
    Tuning
        Gains and the margins that they achieve.

    Raises
    ------
    InputError
        If the circuit, the form, the bound or a size does not fit.
    SimulationError
        If no gains keep the bound; if the controller as it is does not hold the plant, or no sine comes back from it.

    Notes
    -----
    With `amplitudes` the controller of the circuit holds the plant while that is measured, at a part of its gain and
    without its integral: the gains have to be such that the loop comes to rest.
    """
    plant, points = _prepared(circuit, controller, at, form, sensitivity, amplitudes, progress)
    return _tuning(plant, (_tuned(plant, points, form, sensitivity),), sensitivity, form)


def schedule(
    circuit: Circuit, controller: str | None = None, *, at: Sequence[Any] | None = None, form: str = "pi",
    sensitivity: float = 1.4, amplitudes: Sequence[Any] = (), progress: ProgressCallback | None = None,
) -> Tuning:  # fmt: skip
    """Gains for each operating point, for a controller that interpolates between them.

    Parameters
    ----------
    circuit : Circuit
        With a part of kind `pid`.
    controller : str, optional
        Name of that part.
    at : sequence of float or str, optional
        Pressures of at least two operating points; default the levels of the setpoint's steps.
    form : str, optional
        `pi` or `pid`: the velocity form of a schedule needs an integral.
    sensitivity : float, optional
        Bound M of Ms and Mt.
    amplitudes, progress
        As `tune`.

    Returns
    -------
    Tuning
        With a point for each.

    Raises
    ------
    InputError
        As `tune`; and for fewer than two operating points, or a form without integral.
    """
    plant, points = _prepared(circuit, controller, at, form, sensitivity, amplitudes, progress)
    if form == "p":
        raise InputError("tuning.schedule_without_integral", form=form)
    if len(points) < 2:
        raise InputError("tuning.schedule_of_one", count=len(points))
    tuned = tuple(_tuned(plant, [point], form, sensitivity) for point in points)
    # One filter serves all points of a schedule: the slowest, with which each is judged again.
    slowest = max(each.gains.derivative_filter for each in tuned)
    if form == "pid":
        tuned = tuple(_tuned(plant, [p], form, sensitivity, filter_time=slowest) for p in points)
    return _tuning(plant, tuned, sensitivity, form)


def _tuning(plant: Plant, points: tuple[TunedPoint, ...], bound: float, form: str) -> Tuning:
    name, part = plant.controller, plant.part
    found = [note for point in points for run in point.verified for note in run.notes(name)]
    for point in points:
        for at, each in point.plants.items():
            if isinstance(each, MeasuredPlant) and not each.is_known_for(point.gains, bound):
                lowest, highest = each.known[[0, -1]].tolist()
                found.append(Note("tuning.beyond", name, at=at, lowest=lowest, highest=highest))
    return Tuning(name, points, bound, form, part.controls, command_of(part), (*plant.notes, *found))


def _prepared(
    circuit: Circuit, controller: str | None, at: Sequence[Any] | None, form: str, bound: float,
    amplitudes: Sequence[Any], progress: ProgressCallback | None,
) -> tuple[Plant, list[OperatingPoint]]:  # fmt: skip
    if form not in FORMS:
        near = NameSuggestion(form, FORMS)
        raise InputError("fields.not_an_option", "form", value=form, meaning="form of controller", near=near)
    if not LEAST_BOUND <= bound <= GREATEST_BOUND:
        raise OutOfRangeError("tuning.bound", bound=bound, low=LEAST_BOUND, high=GREATEST_BOUND)
    plant = measured_loop(circuit, controller, amplitudes, progress) if amplitudes else plant_of(circuit, controller)
    if not isinstance(plant.part, PID):
        raise InputError("tuning.no_pid", plant.controller, kind=plant.part.kind)
    values, setpoint = at, f"{plant.controller}.setpoint"
    if values is None:
        signal = circuit.signals.get(setpoint)
        levels = np.unique(signal.values).tolist() if isinstance(signal, Steps) else []
        values = levels or [circuit.parameters[setpoint]]
    if not values:
        raise InputError("tuning.no_point")
    points = [plant.operating_point(value) for value in values]
    return plant, sorted(points, key=lambda point: point.value)


def _tuned(
    plant: Plant, points: Sequence[OperatingPoint], form: str, bound: float, *, filter_time: float | None = None
) -> TunedPoint:
    factor = _vent_factor(plant, points)
    named = {
        place(plant, point.value, branch): plant.sampled(point, branch, factor if branch == "vent" else 1.0)
        for point in points
        for branch in point.models
    }
    loops = _Loops(list(named.values()), bound)
    gains, achieved = loops.held(loops.best(form, filter_time))
    by_name = dict(zip(named, achieved, strict=True))
    values, commands = zip(*((point.value, point.command) for point in points), strict=True)
    tuned = TunedPoint(gains, factor, 1.0, 0.0, by_name, values, commands, named)
    if isinstance(plant, MeasuredLoop):
        return _weighed(plant, replace(tuned, vent_factor=plant.vent_factor), bound, form)
    weight, overshoot = _setpoint_weight(list(named.values()), gains, achieved)
    return replace(tuned, setpoint_weight=weight, overshoot=overshoot)


def _weighed(plant: MeasuredLoop, point: TunedPoint, bound: float, form: str) -> TunedPoint:
    """The greatest weight without much overshoot in steps of the plant as it is, and these."""
    for weight in _weights(point.gains):
        point = replace(point, setpoint_weight=weight)
        circuit = _tuning(plant, (point,), bound, form).applied(plant.loop.circuit)
        runs = tuple(plant.verified(circuit, value, point.gains, point.margins) for value in point.values)
        point = replace(point, verified=tuple(itertools.chain(*runs)))
        point = replace(point, overshoot=max(run.overshoot for run in point.verified) / 100.0)
        if point.overshoot <= _OVERSHOOT:
            break
    return point


def _weights(gains: Gains) -> tuple[float, ...]:
    return _WEIGHTS if gains.integral_time > 0.0 else (1.0,)


def _vent_factor(plant: Plant, points: Sequence[OperatingPoint]) -> float:
    """What makes venting as strong as filling, well above the plant's own time constants; the mean of all points."""
    ratios = []
    for point in points:
        if {"fill", "vent"} <= set(point.models):
            fill, vent = (plant.sampled(point, branch) for branch in ("fill", "vent"))
            z = np.array([np.exp(0.1j)])
            ratios.append(np.log(np.abs(fill.response(z)[0] / vent.response(z)[0])))
    return float(np.exp(np.mean(ratios))) if ratios else 1.0


class _Loops:
    """Plants that have to share their gains, and the bound that all of them keep."""

    def __init__(self, plants: Sequence[LoopPlant], bound: float) -> None:
        self.plants, self.bound, self.time = plants, bound, plants[0].sample_time
        z = plants[0].at(plants[0].frequencies)
        self.dense = [plant.response(z) for plant in plants]
        every = len(z) // _GRID
        self.z, self.responses = z[::every], np.array([response[::every] for response in self.dense])
        # From a gain with which nothing crosses over to one with which everything does.
        size = np.abs(self.responses)
        low, high = 0.3 / np.max(size), 3.0 / np.min(size[size > 0.0])
        # Answers to sines fall by more decades, over which as many gains would lie too far apart.
        count = _GAINS if isinstance(plants[0], SampledPlant) else 3 * _GAINS
        self.gains = np.geomspace(low, high, count)

    def best(self, form: str, filter_time: float | None) -> Gains:
        """The gains with the greatest integral gain; of a proportional controller the greatest gain."""
        if form == "p":
            return Gains(self.greatest(Gains(1.0)))
        best, goal = Gains(0.0), 0.0

        def tried(integral_time: float, ratio: float) -> tuple[float, Gains]:
            ahead = ratio * integral_time
            smooth = filter_time if filter_time is not None else max(_FILTER * ahead, self.time)
            unit = Gains(1.0, integral_time, ahead, smooth if ahead > 0.0 else self.time)
            gain = self.greatest(unit)
            return gain / integral_time, replace(unit, gain=gain)

        for ratio in _RATIOS if form == "pid" else (0.0,):
            found = [tried(self.time * count, ratio) for count in _TIMES.tolist()]
            k = int(np.argmax([value for value, _ in found]))
            near = np.geomspace(_TIMES[max(k - 1, 0)], _TIMES[min(k + 1, len(_TIMES) - 1)], 17).tolist()
            for value, gains in [*found, *(tried(self.time * count, ratio) for count in near)]:
                if value > goal:
                    best, goal = gains, value
        return best

    def held(self, gains: Gains) -> tuple[Gains, list[Margins]]:
        """Gains with which the bound holds on the dense grid as well, to a thousandth, and their margins."""
        if gains.gain <= 0.0:
            raise SimulationError(Note("tuning.no_gains", bound=self.bound))
        for _ in range(100):
            pairs = zip(self.plants, self.dense, strict=True)
            found = [margins(plant, gains, response=response) for plant, response in pairs]
            if all(max(each.sensitivity, each.complementary) <= self.bound and each.is_stable for each in found):
                return gains, found
            gains = replace(gains, gain=gains.gain * 0.999)
        raise SimulationError(Note("tuning.not_kept", bound=self.bound))

    def peaks(self, unit: Gains, gains: NDArray[np.float64]) -> NDArray[np.float64]:
        """The greatest of Ms and Mt over all plants for each gain."""
        shape, k = unit.response(self.z, self.time), gains[:, None]
        worst = np.zeros(len(gains))
        for response in self.responses:
            loop = shape * response
            # Squares of |K L| and |1 + K L| by real numbers alone, which is most of the time of a tuning.
            size = k**2 * np.abs(loop) ** 2
            away = 1.0 + k * (2.0 * loop.real) + size
            worst = np.maximum(worst, np.max(np.maximum(1.0, size) / away, axis=1))
        return np.sqrt(worst)

    def greatest(self, unit: Gains) -> float:
        """The greatest gain that keeps the bound in a stable loop; 0 where none does."""
        fit = np.flatnonzero(self.peaks(unit, self.gains) <= self.bound)
        # Loops that have long been unstable keep the bound too: they run around -1, far from it.
        for k in fit[::-1]:
            low = float(self.gains[k])
            if not all(plant.is_stable_with(replace(unit, gain=low)) for plant in self.plants):
                continue
            if k + 1 == len(self.gains):
                return low
            inner = np.geomspace(low, self.gains[k + 1], 33)
            inside = self.peaks(unit, inner) <= self.bound
            return float(inner[int(np.argmin(inside)) - 1] if not inside.all() else inner[-1])
        return 0.0


def _setpoint_weight(plants: Sequence[SampledPlant], gains: Gains, achieved: Sequence[Margins]) -> tuple[float, float]:
    """The greatest weight without much overshoot, and the overshoot."""
    worst = 0.0
    for weight in _weights(gains):
        worst = 0.0
        for plant, found in zip(plants, achieved, strict=True):
            length = max(gains.integral_time, 1.0 / (2.0 * np.pi * max(found.crossover, 1e-9)))
            samples = min(_SAMPLES, int(20.0 * length / plant.sample_time))
            worst = max(worst, float(np.max(step_response(plant, gains, weight, samples))) - 1.0)
        if worst <= _OVERSHOOT:
            break
    return weight, max(worst, 0.0)
