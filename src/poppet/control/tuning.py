r"""Automatic tuning of PID controllers with linear models or with responses to sines.

The gains maximise the integral gain K/T_i (for a proportional controller: K) under a bound of the sensitivities,
max(Ms, Mt) <= M, for all plants: at each operating point for the fill and the vent valve. After Aastroem, Panagopoulos
& Haegglund, Design of PI controllers based on non-convex optimization, Automatica 34 (1998) 585-601, here for the
sampled loop with its hold and delay, and by search.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.control.describing_function import MeasuredLoop, MeasuredPlant, ProgressCallback, make_measured_loop
from poppet.control.extraction import plant_of
from poppet.control.loop import Gains, LoopPlant, Margins, SampledPlant, margins, step_response
from poppet.control.metrics import readable_unit_of
from poppet.control.plant import OperatingPoint, Plant, point_label
from poppet.control.verification import Verification
from poppet.control.working_step import largest_step, verify_working_step
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, SimulationError
from poppet.core.notebook import HtmlMixin
from poppet.core.provenance import Number, Source
from poppet.core.tables import NumberRange
from poppet.core.units import convert
from poppet.parts.part import Scope
from poppet.parts.pid import PID
from poppet.parts.quantities import COMMANDS, OPENING, QUANTITIES, command_of, gain_unit
from poppet.parts.rows import GainSchedule, as_numbers
from poppet.timeseries.signals import Steps

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import BaseCircuit

FORMS = ("pi", "pid", "p")
_SIDES = {"fill": "filling", "vent": "venting", "command": "by one command", "back": "back"}
MIN_BOUND, MAX_BOUND = 1.1, 3.0
_GRID = 400
_GAINS = 121
_TIMES = np.geomspace(2.0, 2e4, 33)
"""Evaluated integral times [samples]."""
_RATIOS = (0.1, 0.2, 0.3, 0.4, 0.5)
"""Evaluated derivative times as fractions of the integral time; T_i = 4 T_d has a double zero."""
_FILTER = 0.125
"""Filter time per derivative time: N = 8."""
_OVERSHOOT = 0.05
_WEIGHTS = (1.0, 0.8, 0.6, 0.4, 0.2, 0.0)
_SAMPLES = 20_000
_SAME = 1e-9
"""Relative difference of vent factors that counts as zero."""


@dataclass(frozen=True)
class TunedPoint:
    """Gains that are tuned for one or several operating points, with the margins of all loops.

    Parameters
    ----------
    gains : Gains
        Gains of the controller.
    vent_factor : float
        Opening of the vent valve per unit of negative command.
    setpoint_weight : float
        Factor on the setpoint in the proportional term: the largest of 1, 0.8, ..., 0 with an overshoot of at most 5 %.
    overshoot : float
        Maximum overshoot of all plants, as a fraction of the step.
    margins : dict
        Margins by the label of an operating point and a side, such as `2 bar, fill`.
    values : tuple of float
        Values of the measurement at the operating points, SI.
    commands : tuple of float
        Commands at these operating points, SI; positive openings fill.
    plants : dict
        Plants by the label of an operating point and a side.
    verified : tuple of Verification
        Simulated setpoint steps that verify a tuning by sines; empty for other tunings.
    vents : frozenset of str
        Labels of the plants of a vent valve.
    plant_values : dict
        Values of the measurement by the labels of the plants, SI.
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
    vents: frozenset[str] = frozenset()
    plant_values: Mapping[str, float] = field(default_factory=dict, repr=False, compare=False)

    @property
    def sides(self) -> tuple[str, ...]:
        """Names of the sides (signs) of the command at which the margins keep the bound.

        For a plant that was measured with sines, the names are labels of the sines instead.
        """
        return tuple(dict.fromkeys(name.partition(", ")[2] for name in self.margins))

    @property
    def is_stable(self) -> bool:
        """True if the loops at all operating points are stable."""
        return all(loop_margins.is_stable for loop_margins in self.margins.values())


@dataclass(frozen=True)
class Tuning(HtmlMixin):
    """Result of a tuning: gains for one or several operating points, with margins.

    Parameters
    ----------
    controller : str
        Name of the controller.
    points : tuple of TunedPoint
        One point for fixed gains, several for a schedule.
    sensitivity : float
        Bound of Ms and Mt, the maxima of the sensitivity functions.
    form : str
        `pi`, `pid` or `p`.
    quantity, command_quantity : str
        Controlled and commanded quantity.
    notes : tuple of Note
        Notes on the plant, and on the runs that verify the gains.
    working_step : Verification or None
        Run with the largest setpoint step from an operating point to a level of the setpoint signal in the circuit. It
        is None if the circuit has no such signal, or if the run failed.
    """

    controller: str
    points: tuple[TunedPoint, ...]
    sensitivity: float
    form: str
    quantity: str = "pressure"
    command_quantity: str = OPENING
    notes: tuple[Note, ...] = ()
    working_step: Verification | None = None

    @property
    def is_scheduled(self) -> bool:
        """True if the gains depend on the operating point (gain schedule)."""
        return len(self.points) > 1

    @property
    def is_verified(self) -> bool:
        """True if the plant was measured with sines, and setpoint steps verified the gains."""
        return bool(self.points[0].verified)

    @property
    def bound_text(self) -> str:
        """Text with the bound of Ms and Mt, and the sides and operating points."""
        sides = " and ".join(_SIDES.get(side, f"by {side}") for side in self.points[0].sides)
        unit = QUANTITIES[self.quantity].unit
        readable_unit = readable_unit_of(unit)
        points = [value for point in self.points for value in point.values]
        values = ", ".join(f"{convert(value, unit, readable_unit):.4g}" for value in points)
        return f"Ms, Mt <= {self.sensitivity:g} {sides} at {values} {readable_unit}"

    @property
    def command_text(self) -> str:
        """Text with the constant commands that keep the plant at the operating points."""
        commands = [command for point in self.points for command in point.commands]
        if not any(commands):
            return "at rest"
        unit = COMMANDS[self.command_quantity].unit
        readable_unit = readable_unit_of(unit)
        values = ", ".join(f"{convert(command, unit, readable_unit):.3g}" for command in commands)
        return f"held by a command of {values}{'' if readable_unit == '1' else f' {readable_unit}'}"

    def margins_of(self, circuit: BaseCircuit) -> dict[str, Margins]:
        """Return the margins of the tuned loops with the gains of a circuit.

        Parameters
        ----------
        circuit : Circuit
            Circuit with the same plant, whose controller has the gains.

        Returns
        -------
        dict
            Margins by the label of an operating point and a side. Loops that `gains_of` omits have no margins.
        """
        gains = self.gains_of(circuit)
        return {
            label: margins(plant, gains[label])
            for point in self.points
            for label, plant in point.plants.items()
            if label in gains
        }

    def gains_of(self, circuit: BaseCircuit) -> dict[str, Gains]:
        """Return the gains of a circuit for the plants of the tuned loops.

        Parameters
        ----------
        circuit : Circuit
            Circuit with the same plant, whose controller has the gains.

        Returns
        -------
        dict
            Gains by the label of an operating point and a side: those of a schedule at the operating point. For a plant
            of a vent valve, the gain is multiplied by the ratio of the vent factors of the circuit and of the tuning. A
            plant that was measured with sines is omitted if these vent factors differ.
        """
        return {label: gains for label, gains, vent_factor in self._gains_at_points(circuit) if vent_factor is None}

    def margin_notes(self, circuit: BaseCircuit) -> tuple[Note, ...]:
        """Return notes on the margins with the gains of a circuit, for plants that were measured with sines.

        Parameters
        ----------
        circuit : Circuit
            Circuit with the same plant, whose controller has the gains.

        Returns
        -------
        tuple of Note
            Notes on loops that `gains_of` omits, and on loops that act outside the measured frequencies.
        """
        notes, loops = [], self.margins_of(circuit)
        plants = {label: plant for point in self.points for label, plant in point.plants.items()}
        factors = {label: point.vent_factor for point in self.points for label in point.plants}
        for label, gains, vent_factor in self._gains_at_points(circuit):
            plant = plants[label]
            if vent_factor is not None:
                facts = {"measured": factors[label], "present": vent_factor}
                notes.append(Note("tuning.other_vent_factor", self.controller, at=label, **facts))
            elif isinstance(plant, MeasuredPlant) and loops[label].is_stable:
                peak = max(loops[label].sensitivity, loops[label].complementary)
                if not plant.keeps_bound_outside(gains, max(peak, self.sensitivity)):
                    lowest, highest = plant.known_frequencies[[0, -1]].tolist()
                    notes.append(Note("tuning.extrapolated", self.controller, at=label, lowest=lowest, highest=highest))
        return tuple(notes)

    def _gains_at_points(self, circuit: BaseCircuit) -> Iterator[tuple[str, Gains, float | None]]:
        """Yield label, gains and vent factor of each plant with the gains of a circuit.

        The vent factor is None unless the plant was measured with sines and another vent factor.
        """
        part: PID = circuit.parts[self.controller]  # type: ignore[assignment]
        numbers = part.parameters(circuit.surroundings)
        scope = Scope(numbers, {}, {}, circuit.surroundings)
        for point in self.points:
            for label, value in point.plant_values.items():
                values = {name: float(number) for name, number in part.gains_at(scope, value, value).items()}
                vent_factor = values.get("vent_factor", 1.0)
                ratio = vent_factor / point.vent_factor
                gains = Gains(
                    values["gain"] * (ratio if label in point.vents else 1.0), values["integral_time"],
                    values["derivative_time"], numbers["derivative_filter"],
                )  # fmt: skip
                is_other = isinstance(point.plants[label], MeasuredPlant) and abs(ratio - 1.0) > _SAME
                yield label, gains, vent_factor if is_other else None

    def plot(self, path: str | Path | None = None) -> Figure:
        """Draw the Bode plots and the step responses in one figure.

        Parameters
        ----------
        path : str or Path, optional
            Output file: .png, .svg or .pdf.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from poppet.control.loop_figures import tuning_figure

        return tuning_figure(self, path)

    def plot_bode(self, path: str | Path | None = None) -> Figure:
        """Draw the Bode plots of the open loops with their margins, and the sensitivities.

        Parameters
        ----------
        path : str or Path, optional
            Output file: .png, .svg or .pdf.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from poppet.control.loop_figures import bode_figure

        return bode_figure(self, path)

    def plot_steps(self, path: str | Path | None = None) -> Figure:
        """Draw the responses of the loops to steps of the setpoint and of a disturbance of the command.

        Parameters
        ----------
        path : str or Path, optional
            Output file: .png, .svg or .pdf.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from poppet.control.loop_figures import step_figure

        return step_figure(self, path)

    def fields(self) -> dict[str, Any]:
        """Return the tuned fields of the `pid` part.

        Each tuned number has the kind of source `fitted`, and a note on the tuning.

        Returns
        -------
        dict
            Mapping from the name of each field to a tuned number or a gain schedule. The value None means that the
            field must be removed from the part.
        """
        basis = "answers to sines" if self.is_verified else "linear models"
        source = Source("fitted", note=f"tuned on {basis} for {self.bound_text}")

        def number(value: float, unit: str) -> Number:
            return Number(float(value), unit, source)

        gains = [point.gains for point in self.points]
        common = {
            "derivative_filter": number(max(point_gains.derivative_filter for point_gains in gains), "s"),
            "setpoint_weight": number(min(point.setpoint_weight for point in self.points), "1"),
        }
        columns = {
            "gain": ([point_gains.gain for point_gains in gains], gain_unit(self.quantity, self.command_quantity)),
            "integral_time": ([point_gains.integral_time for point_gains in gains], "s"),
            "derivative_time": ([point_gains.derivative_time for point_gains in gains], "s"),
        }
        if self.command_quantity == OPENING:
            columns["vent_factor"] = ([point.vent_factor for point in self.points], "1")
        if not self.is_scheduled:
            fixed = {name: number(values[0], unit) for name, (values, unit) in columns.items()}
            return common | fixed | {"schedule": None}
        points = {self.quantity: ([point.values[0] for point in self.points], QUANTITIES[self.quantity].unit)}
        table = {name: as_numbers(values, unit, source) for name, (values, unit) in (points | columns).items()}
        schedule = GainSchedule(table, (self.quantity, self.command_quantity))
        return common | dict.fromkeys(columns) | {"schedule": schedule}

    def applied(self, circuit: BaseCircuit) -> BaseCircuit:
        """Return a copy of the circuit in which the controller has the tuned gains.

        Parameters
        ----------
        circuit : Circuit
            Circuit that was tuned.

        Returns
        -------
        Circuit
            New circuit.
        """
        part: PID = circuit.parts[self.controller]  # type: ignore[assignment]
        return replace(circuit, parts={**circuit.parts, self.controller: replace(part, **self.fields())})

    def text(self) -> str:
        """Return the tuned fields as a TOML table of a circuit file.

        Returns
        -------
        str
            TOML, also for `poppet simulate --with`.
        """
        lines = [f"[parts.{self.controller}]"]
        for name, value in self.fields().items():
            if isinstance(value, Number):
                lines.append(f"{name} = {_value_text(value)}")
            elif isinstance(value, GainSchedule):
                lines.append(f"\n[parts.{self.controller}.schedule]")
                lines += [f"{key} = [{', '.join(map(_value_text, column))}]" for key, column in value.columns.items()]
        return "\n".join(lines) + "\n"


def _value_text(number: Number) -> str:
    """Format a number as a value in a circuit file."""
    if number.unit == "1":
        return f"{number.value:.6g}"
    readable_unit = "ms" if number.unit == "s" else readable_unit_of(number.unit)
    return f'"{convert(number.value, number.unit, readable_unit):.6g} {readable_unit}"'


def tune(
    circuit: BaseCircuit, controller: str | None = None, *, at: Sequence[Any] | None = None, form: str = "pi",
    sensitivity: float = 1.4, amplitudes: Sequence[Any] = (), progress: ProgressCallback | None = None,
) -> Tuning:  # fmt: skip
    """Tune one set of gains whose margins keep the bound at all operating points.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a `pid`; its gains do not affect a tuning by linear models.
    controller : str, optional
        Name of the controller; required if there are several.
    at : sequence of float or str, optional
        Values of the measurement at the operating points (default: the levels of the setpoint steps).
    form : str, optional
        `pi`, `pid` or `p`.
    sensitivity : float, optional
        Bound M of Ms and Mt, the maxima of the sensitivity functions: 1.4 is cautious, 2 is fast.
    amplitudes : sequence of float or str, optional
        Amplitudes of sines in the command, in its unit, for plants without a useful linear model. The responses to the
        sines include dead zones and friction and replace the linear models. The bound is kept for each amplitude. Use
        the smallest relevant command and a large one. Setpoint steps verify the gains; `notes` reports problems.
    progress : callable, optional
        Function that is called with a text about the current run.

    Returns
    -------
    Tuning
        Gains and their margins.

    Raises
    ------
    InputError
        If the circuit, the form, the bound or an amplitude is invalid.
    SimulationError
        If no gains keep the bound, the initial controller does not reach a steady state, or a response is not a sine.

    Notes
    -----
    With `amplitudes`, the controller of the circuit is active during the measurement, with a fraction of its gain and
    without its integral. Its initial gains must lead to a steady state.
    """
    plant, points = _prepare(circuit, controller, at, form, sensitivity, amplitudes, progress)
    tuning = _make_tuning(plant, (_tune_points(plant, points, form, sensitivity),), sensitivity, form)
    return _add_working_step(plant, circuit, tuning)


def schedule(
    circuit: BaseCircuit, controller: str | None = None, *, at: Sequence[Any] | None = None, form: str = "pi",
    sensitivity: float = 1.4, amplitudes: Sequence[Any] = (), progress: ProgressCallback | None = None,
) -> Tuning:  # fmt: skip
    """Tune a gain schedule with one set of gains for each operating point.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a `pid`.
    controller : str, optional
        Name of the controller; required if there are several.
    at : sequence of float or str, optional
        Values of the measurement at two or more operating points (default: the levels of the setpoint steps).
    form : str, optional
        `pi` or `pid`; the velocity form of a schedule needs an integral.
    sensitivity : float, optional
        Largest permitted value of Ms and Mt; the function `tune` describes both.
    amplitudes, progress
        Same arguments as in `tune`.

    Returns
    -------
    Tuning
        Tuning with a point for each operating point.

    Raises
    ------
    InputError
        In the same cases as in `tune`, for fewer than two operating points, and for a form without an integral part.
    """
    plant, points = _prepare(circuit, controller, at, form, sensitivity, amplitudes, progress)
    if form == "p":
        raise InputError("tuning.schedule_without_integral", form=form)
    if len(points) < 2:
        raise InputError("tuning.schedule_of_one", count=len(points))
    tuned = tuple(_tune_points(plant, [point], form, sensitivity) for point in points)
    # A schedule has one filter: the slowest one, with which all points are tuned again.
    slowest = max(tuned_point.gains.derivative_filter for tuned_point in tuned)
    if form == "pid":
        tuned = tuple(_tune_points(plant, [p], form, sensitivity, filter_time=slowest) for p in points)
    return _add_working_step(plant, circuit, _make_tuning(plant, tuned, sensitivity, form))


def _add_working_step(plant: Plant, circuit: BaseCircuit, tuning: Tuning) -> Tuning:
    """Return the tuning with a simulated large setpoint step and its notes.

    The step is the largest one from an operating point to a level of the setpoint signal.
    """
    by_value = {value: point for point in tuning.points for value in point.values}
    value, step = largest_step(circuit, tuning.controller, list(by_value))
    if step == 0.0:
        return tuning
    point, label = by_value[value], point_label(plant, value, "")
    crossover = min(m.crossover for name, m in point.margins.items() if name.startswith(label))
    applied = tuning.applied(plant.loop.circuit if isinstance(plant, MeasuredLoop) else circuit)
    run, notes = verify_working_step(plant, applied, (value, step), point.gains, crossover)
    return replace(tuning, working_step=run, notes=(*tuning.notes, *notes))


def _make_tuning(plant: Plant, points: tuple[TunedPoint, ...], bound: float, form: str) -> Tuning:
    name, part = plant.controller, plant.part
    notes = [note for point in points for verification in point.verified for note in verification.notes(name)]
    for point in points:
        for label, plant_at in point.plants.items():
            if isinstance(plant_at, MeasuredPlant) and not plant_at.keeps_bound_outside(point.gains, bound):
                lowest, highest = plant_at.known_frequencies[[0, -1]].tolist()
                notes.append(Note("tuning.beyond", name, at=label, lowest=lowest, highest=highest))
    return Tuning(name, points, bound, form, part.controls, command_of(part), (*plant.notes, *notes))


def _prepare(
    circuit: BaseCircuit, controller: str | None, at: Sequence[Any] | None, form: str, bound: float,
    amplitudes: Sequence[Any], progress: ProgressCallback | None,
) -> tuple[Plant, list[OperatingPoint]]:  # fmt: skip
    if form not in FORMS:
        suggestion = NameSuggestion(form, FORMS)
        raise InputError(
            "fields.not_an_option", "form", value=form, meaning="form of controller", suggestion=suggestion
        )
    limits = NumberRange(unit="1", low=MIN_BOUND, high=MAX_BOUND)
    limits.check_range("sensitivity", bound, f"{bound:g}", "bound of Ms and Mt")
    measured = make_measured_loop(circuit, controller, amplitudes, progress) if amplitudes else None
    plant = measured or plant_of(circuit, controller)
    if not isinstance(plant.part, PID):
        raise InputError("tuning.no_pid", plant.controller, kind=plant.part.kind)
    if plant.part.acceleration_time is not None:
        raise InputError("tuning.acceleration", f"{plant.controller}.acceleration_time")
    values, setpoint = at, f"{plant.controller}.setpoint"
    if values is None:
        signal = circuit.signals.get(setpoint)
        levels = np.unique(signal.values).tolist() if isinstance(signal, Steps) else []
        values = levels or [circuit.parameters[setpoint]]
    if not values:
        raise InputError("tuning.no_point")
    points = [plant.operating_point(value) for value in values]
    return plant, sorted(points, key=lambda point: point.value)


def _tune_points(
    plant: Plant, points: Sequence[OperatingPoint], form: str, bound: float, *, filter_time: float | None = None
) -> TunedPoint:
    # Ratio of the responses to fill and vent commands at high frequency: the geometric mean over the operating points
    # with both sides.
    ratios, z = [], np.array([np.exp(0.1j)])
    for point in points:
        if {"fill", "vent"} <= set(point.models):
            fill, vent = (plant.sampled(point, branch) for branch in ("fill", "vent"))
            ratios.append(np.log(np.abs(fill.response(z)[0] / vent.response(z)[0])))
    factor = float(np.exp(np.mean(ratios))) if ratios else 1.0
    plants = {
        point_label(plant, point.value, branch): plant.sampled(point, branch, factor if branch == "vent" else 1.0)
        for point in points
        for branch in point.models
    }
    vents = frozenset(point_label(plant, point.value, "vent") for point in points if "vent" in point.models)
    plant_values = {point_label(plant, point.value, branch): point.value for point in points for branch in point.models}
    loops = _GainSearch(list(plants.values()), bound)
    gains, loop_margins = loops.reduce_gain(loops.best(form, filter_time))
    by_name = dict(zip(plants, loop_margins, strict=True))
    values, commands = zip(*((point.value, point.command) for point in points), strict=True)
    result = TunedPoint(gains, factor, 1.0, 0.0, by_name, values, commands, plants, (), vents, plant_values)
    # The largest setpoint weight with an acceptable overshoot; a measured loop is tested in verification runs.
    for weight in _weights(gains):
        if isinstance(plant, MeasuredLoop):
            result = replace(result, vent_factor=plant.vent_factor, setpoint_weight=weight)
            circuit = _make_tuning(plant, (result,), bound, form).applied(plant.loop.circuit)
            verifications = [plant.verify(circuit, value, gains, by_name) for value in values]
            result = replace(result, verified=tuple(itertools.chain(*verifications)))
            overshoot = max(verification.overshoot for verification in result.verified) / 100.0
        else:
            overshoot = 0.0
            for sampled, sampled_margins in zip(plants.values(), loop_margins, strict=True):
                length = max(gains.integral_time, 1.0 / (2.0 * np.pi * max(sampled_margins.crossover, 1e-9)))
                samples = min(_SAMPLES, int(20.0 * length / sampled.sample_time))
                overshoot = max(overshoot, float(np.max(step_response(sampled, gains, weight, samples))) - 1.0)
        if overshoot <= _OVERSHOOT:
            break
    return replace(result, setpoint_weight=weight, overshoot=overshoot)


def _weights(gains: Gains) -> tuple[float, ...]:
    return _WEIGHTS if gains.integral_time > 0.0 else (1.0,)


class _GainSearch:
    """Search for gains of one controller that are suitable for several plants.

    `bound` is the largest permitted value of Ms and Mt, the maxima of the sensitivity functions.
    """

    def __init__(self, plants: Sequence[LoopPlant], bound: float) -> None:
        self.plants, self.bound, self.time = plants, bound, plants[0].sample_time
        z = plants[0].at(plants[0].frequencies)
        self.dense = [plant.response(z) for plant in plants]
        decimation = len(z) // _GRID
        self.z, self.responses = z[::decimation], np.array([response[::decimation] for response in self.dense])
        # From a gain without crossovers to one that exceeds all of them.
        size = np.abs(self.responses)
        low, high = 0.3 / np.max(size), 3.0 / np.min(size[size > 0.0])
        # Where the measured body sticks, the response while it slides is unknown: any phase is possible.
        self.ends = [
            (plant.at(plant.known_frequencies[-1:]), float(np.abs(plant.responses[-1])))
            for plant in plants
            if isinstance(plant, MeasuredPlant) and plant.sticks_above
        ]
        # Responses to sines cover more decades and need more gains.
        n_gains = _GAINS if isinstance(plants[0], SampledPlant) else 3 * _GAINS
        self.gains = np.geomspace(low, high, n_gains)

    def best(self, form: str, filter_time: float | None) -> Gains:
        """Return the gains with the largest integral gain that keep the bound.

        The form `p` has no integral part. For this form, the result has the largest proportional gain. `filter_time` is
        the filter time of the derivative [s]. If it is None, an eighth of the derivative time is used, but at least one
        sample.
        """
        if form == "p":
            return Gains(self.largest_gain(Gains(1.0)))
        best_gains, best_value = Gains(0.0), 0.0

        def evaluate(integral_time: float, ratio: float) -> tuple[float, Gains]:
            derivative_time = ratio * integral_time
            filter_value = filter_time if filter_time is not None else max(_FILTER * derivative_time, self.time)
            unit = Gains(1.0, integral_time, derivative_time, filter_value if derivative_time > 0.0 else self.time)
            gain = self.largest_gain(unit)
            return gain / integral_time, replace(unit, gain=gain)

        for ratio in _RATIOS if form == "pid" else (0.0,):
            candidates = [evaluate(self.time * count, ratio) for count in _TIMES.tolist()]
            k = int(np.argmax([value for value, _ in candidates]))
            finer_times = np.geomspace(_TIMES[max(k - 1, 0)], _TIMES[min(k + 1, len(_TIMES) - 1)], 17).tolist()
            for value, gains in [*candidates, *(evaluate(self.time * count, ratio) for count in finer_times)]:
                if value > best_value:
                    best_gains, best_value = gains, value
        return best_gains

    def reduce_gain(self, gains: Gains) -> tuple[Gains, list[Margins]]:
        """Reduce the gain until the margins at all frequencies keep the bound.

        The result contains the gains, and the margins of the loop with each plant.
        """
        if gains.gain <= 0.0:
            raise SimulationError(Note("tuning.no_gains", bound=self.bound))
        for _ in range(100):
            pairs = zip(self.plants, self.dense, strict=True)
            loop_margins = [margins(plant, gains, response=response) for plant, response in pairs]
            if all(max(m.sensitivity, m.complementary) <= self.bound and m.is_stable for m in loop_margins):
                return gains, loop_margins
            gains = replace(gains, gain=gains.gain * 0.999)
        raise SimulationError(Note("tuning.not_kept", bound=self.bound))

    def peaks(self, unit: Gains, gains: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the maximum of Ms and Mt over all plants for each of several gains.

        Ms and Mt are the maxima of the sensitivity functions. `unit` is the controller with a gain of 1, and `gains`
        contains the factors on this gain.
        """
        unit_response, k = unit.response(self.z, self.time), gains[:, None]
        worst = np.zeros(len(gains))
        for response in self.responses:
            loop = unit_response * response
            # Squares of |K L| and |1 + K L| in real arithmetic: most of the time of a tuning.
            size = k**2 * np.abs(loop) ** 2
            squared_distance = 1.0 + k * (2.0 * loop.real) + size
            worst = np.maximum(worst, np.max(np.maximum(1.0, size) / squared_distance, axis=1))
        for z, size in self.ends:
            loop_size = gains * size * float(np.abs(unit.response(z, self.time))[0])
            worst = np.maximum(worst, 1.0 / np.maximum(1.0 - loop_size, 1e-9) ** 2)
        return np.sqrt(worst)

    def largest_gain(self, unit: Gains) -> float:
        """Return the largest gain for which all loops are stable and keep the bound.

        `unit` is the controller with a gain of 1. The result is 0 if there is no such gain.
        """
        feasible = np.flatnonzero(self.peaks(unit, self.gains) <= self.bound)
        # Unstable loops can keep the bound too: they encircle -1 at a distance.
        for k in feasible[::-1]:
            low = float(self.gains[k])
            if not all(plant.is_stable_with(replace(unit, gain=low)) for plant in self.plants):
                continue
            if k + 1 == len(self.gains):
                return low
            inner = np.geomspace(low, self.gains[k + 1], 33)
            is_within = self.peaks(unit, inner) <= self.bound
            return float(inner[int(np.argmin(is_within)) - 1] if not is_within.all() else inner[-1])
        return 0.0
