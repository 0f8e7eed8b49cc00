"""Faults that the sensors of a plant can distinguish, predicted from exact sensitivities before any data exist."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.number_format import aligned, readable_unit, scaled
from poppet.core.toml import ResultFileMixin
from poppet.engine.problem import Problem
from poppet.identify.result import unit_suffix
from poppet.monitoring.fault_statistics import SCATTER
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.sensitivities import Sensitivities, sensitivities
from poppet.monitoring.separation import (
    effect_angles,
    free_deviations,
    remaining_effects,
    separations,
    with_scatter,
)
from poppet.timeseries.signals import SampledSignal, Steps

Array = NDArray[np.float64]

VISIBLE = 5.0
"""Effect of a fault of its alarm size from which it is visible, in standard deviations, as for an alarm."""
SEPARATE = 4.0
"""Rest of this effect, which another fault cannot explain, from which the two are isolable, in standard deviations.

In nine cases of ten, the other fault then has a probability below 5 %.
"""
START = 1.0
"""Prior standard deviation of an initial state, in nominal sizes of the state."""


class GaugeKind(NamedTuple):
    """Kind of an additional sensor, with its assumed accuracy if the plan has no sensor of this kind."""

    word: str
    noise: float  # standard deviation of one reading [SI], or fraction of the largest flow
    is_relative: bool = False


GAUGES = {
    "Pa": GaugeKind("gauge", 500.0),
    "m": GaugeKind("position sensor", 1e-4),
    "kg/s": GaugeKind("flow meter", 0.01, is_relative=True),
}
"""Additional sensors by the unit of their output: 5 mbar, 0.1 mm, 1 % of the largest flow; equal offsets."""


@dataclass(frozen=True)
class AddedSensor:
    """Additional sensor that separates two faults.

    Parameters
    ----------
    address : str
        Address of the measured output.
    word : str
        Kind of the sensor: `gauge`, `position sensor` or `flow meter`.
    noise, offset : float
        Assumed standard deviations of one reading and of the constant offset, in `unit`.
    unit : str
        SI unit.
    separation : float
        Effect that remains if the other fault explains the first one at its alarm size, in standard deviations.
    """

    address: str
    word: str
    noise: float
    offset: float
    unit: str
    separation: float


@dataclass(frozen=True)
class FaultIsolability:
    """Predicted visibility of one fault, and the faults from which it cannot be distinguished.

    Parameters
    ----------
    name, address, unit : str
        Name and address of the fault, and its SI unit.
    alarm : float
        Alarm size, in `unit`.
    sd_alone : float
        Standard deviation if only this fault is possible, in `unit`; infinite if it has no effect on any sensor.
    sd_free : float
        Standard deviation if all other faults can be present too, in `unit`. It is infinite if other faults have
        exactly the same effect.
    nearest : str
        Fault with the most similar effect, or an empty text.
    angle : float
        Angle between the two effects [deg]: 0 for equal effects, 90 for unrelated ones. Above 90 the effects are
        opposite and the directions of both faults are known.
    confused_with : tuple of str
        Faults that can explain this one at its alarm size, the most similar first.
    separating : mapping
        Mapping from each of these faults to the best additional sensor, or None if no single one separates the two.
    """

    name: str
    address: str
    unit: str
    alarm: float
    sd_alone: float
    sd_free: float
    nearest: str
    angle: float
    confused_with: tuple[str, ...] = ()
    separating: Mapping[str, AddedSensor | None] = field(default_factory=dict)

    @property
    def is_visible(self) -> bool:
        """True if a change of the alarm size exceeds the noise clearly."""
        return VISIBLE * self.sd_alone <= self.alarm

    @property
    def is_isolable(self) -> bool:
        """True if no other fault can explain a change of the alarm size."""
        return self.is_visible and not self.confused_with

    @property
    def note(self) -> Note:
        """Verdict on this fault, with the additional sensors that would change it."""
        if math.isinf(self.sd_alone):
            return Note("watch.no_effect", self.name)
        if not self.is_visible:
            return Note("watch.not_visible", self.name, times=VISIBLE * self.sd_alone / self.alarm)
        if self.is_isolable:
            return Note("watch.isolable", self.name)
        added = {sensor.address: sensor for sensor in self.separating.values() if sensor is not None}
        if not added:
            return Note("watch.not_isolable", self.name, others=self.confused_with)
        without = [name for name, sensor in self.separating.items() if sensor is None]
        sensors = [f"a {sensor.word} at {address}" for address, sensor in added.items()]
        return Note("watch.isolable_with", self.name, others=self.confused_with, sensors=sensors, without=without)


@dataclass(frozen=True)
class Isolability(ResultFileMixin):
    """Faults that the sensors of a plant can distinguish during one run.

    Parameters
    ----------
    faults : mapping
        Mapping from the name of each fault to its predicted visibility.
    angles : (f, f) array
        Angles between the effects of the faults [deg].
    sensors : tuple of str
        Addresses of the measured outputs.
    duration : float
        Duration of the run [s].
    samples : int
        Number of readings of each sensor.
    time : (n,) array
        Times of the readings [s].
    signatures : mapping
        Mapping from each fault to the change of the readings at its alarm size, (c, n), in SI.
    noise : (c,) array
        Standard deviation of one reading of each sensor, in SI.
    remarks : tuple of Note
        Verdict on each fault, and on the run.
    """

    faults: Mapping[str, FaultIsolability]
    angles: Array
    sensors: tuple[str, ...]
    duration: float
    samples: int
    time: Array = field(repr=False)
    signatures: Mapping[str, Array] = field(repr=False)
    noise: Array = field(repr=False)
    remarks: tuple[Note, ...] = ()

    def content(self) -> dict[str, Any]:
        """Return the content of the result file as nested tables."""
        faults = {}
        for name, fault in self.faults.items():
            separating = {key: vars(s) for key, s in fault.separating.items() if s is not None}
            faults[name] = {**vars(fault), "confused_with": list(fault.confused_with), "separating": separating}
        return {
            "sensors": list(self.sensors),
            "duration": self.duration,
            "samples": self.samples,
            "faults": faults,
            "angles": self.angles.tolist(),
            "findings": [str(remark) for remark in self.remarks],
        }

    def summary(self) -> str:
        """Return the table and the verdicts as text.

        Returns
        -------
        str
            One line for each fault with its standard deviations, in its unit and in alarm sizes, and the nearest
            other fault. The verdicts follow.
        """
        rows = [["fault", "alarm size", "sd alone", "sd if all are free", "nearest fault"]]
        for fault in self.faults.values():
            unit = readable_unit(fault.unit, fault.alarm)
            nearest = f"{fault.nearest} ({fault.angle:.3g} deg)" if fault.nearest else "-"
            alarm = f"{scaled(fault.alarm, fault.unit, unit):.3g}{unit_suffix(unit)}"
            sds = [
                f"{scaled(sd, fault.unit, unit):.3g}{unit_suffix(unit)} ({sd / fault.alarm:.2g} x alarm)"
                if math.isfinite(sd) else "infinite"
                for sd in (fault.sd_alone, fault.sd_free)
            ]  # fmt: skip
            rows.append([fault.name, alarm, *sds, nearest])
        counts = f"{self.samples} readings of each sensor in {self.duration:.4g} s"
        sensors = f"Sensors: {', '.join(self.sensors)}; {counts}"
        return "\n".join([sensors, aligned(rows, ()), *(f"- {remark}" for remark in self.remarks)])

    def __str__(self) -> str:
        return self.summary()


@dataclass(frozen=True)
class _Effects:
    """Effects of faults at their alarm sizes, and of nuisances at one standard deviation, on all simulated outputs."""

    run: Sensitivities
    faults: Array  # (f, n_outputs, n)
    nuisances: Array  # (q, n_outputs, n) nuisances, offsets of sensors, initial states

    def whitened(self, outputs: list[int], noise: Array) -> tuple[Array, Array]:
        """Return the effects of faults, (k, f), and nuisances, (k, q), on outputs, divided by their noise."""
        tables = (effects[:, outputs] / noise[:, np.newaxis] for effects in (self.faults, self.nuisances))
        faults, nuisances = (table.reshape(len(table), -1).T for table in tables)
        return faults, nuisances


def isolable(
    plan: WatchPlan, *, time: Array | None = None, inputs: Array | None = None, sample_time: float | None = None
) -> Isolability:
    r"""Predict which faults the sensors of a plan can distinguish, before any data exist.

    Parameters
    ----------
    plan : WatchPlan
        Sensors with their noise, faults and nuisances.
    time : (n,) array, optional
        Times of a healthy recording [s]. Without it, the run has the signals and the duration of the circuit.
    inputs : (n, n_inputs) array, optional
        Driven inputs of the recording in SI, in the order of `plan.inputs`.
    sample_time : float, optional
        Time between the readings of all sensors [s] (default: that of the recording, or the output step of the
        circuit).

    Returns
    -------
    Isolability
        Standard deviations, angles and verdicts, with the additional sensors that separate faults.

    Raises
    ------
    InputError
        If the circuit has no duration, and no recording is given.
    SimulationError
        If the healthy plant cannot be simulated.

    Notes
    -----
    A fault :math:`\theta_i` changes the readings of one run by :math:`J_i \theta_i`. Nuisances, offsets and initial
    states z with prior standard deviations s change them by N z. Noise has the covariance R. The information on the
    faults that remains is

    .. math:: \Lambda_0 = J^T S^{-1} J, \qquad S = R + N \, \mathrm{diag}(s^2) \, N^T

    Each fault number of a healthy plant scatters by 2 % of its alarm size, as in the verdicts of a watch, which adds a
    diagonal matrix to the inverse of :math:`\Lambda_0` and gives :math:`\Lambda`.

    The standard deviation of a fault is :math:`\Lambda_{ii}^{-1/2}` if it occurs alone, and
    :math:`(\Lambda^{-1})_{ii}^{1/2}` if all others are free. The angle of two faults has the cosine
    :math:`\Lambda_{ij} / \sqrt{\Lambda_{ii} \Lambda_{jj}}`. At its alarm size :math:`a_i`, a fault is distinguishable
    from another one if :math:`a_i \sqrt{\Lambda_{ii}} \sin \alpha` is at least 4. It is visible if
    :math:`a_i \sqrt{\Lambda_{ii}}` is at least 5.

    The derivatives are those of the healthy plant, and the model is assumed to be correct. Large faults have other
    effects, and lack of fit makes faults less distinguishable than predicted.
    """
    problem, names = _healthy_run(plan, time, inputs, sample_time)
    n_channels, noise = len(plan.channels), np.array([channel.noise for channel in plan.channels])
    effects = _effects(plan, problem)
    whitened = effects.whitened(list(range(n_channels)), noise)
    remaining = with_scatter(remaining_effects(*whitened), SCATTER)
    directions = [fault.direction for fault in plan.faults]
    angles = effect_angles(remaining, directions)
    with np.errstate(divide="ignore"):
        sds = 1.0 / np.linalg.norm(remaining.columns, axis=0)
    is_confused = (separations(remaining, angles) < SEPARATE) & (VISIBLE * sds <= 1.0)[:, np.newaxis]
    is_confused &= np.isfinite(angles) & ~np.eye(sds.size, dtype=bool)
    added: dict[tuple[int, int], AddedSensor] = {}
    if is_confused.any():
        compact: Array = np.linalg.qr(np.hstack(whitened), mode="r")  # type: ignore[assignment]
        for row, sensor in _candidates(plan, effects.run, names):
            reached = _separations_with(effects, compact, row, sensor, directions)
            for i, j in np.argwhere(is_confused & (reached >= SEPARATE)).tolist():
                if (i, j) not in added or added[i, j].separation < reached[i, j]:
                    added[i, j] = replace(sensor, separation=float(reached[i, j]))
    free = free_deviations(remaining)
    faults: dict[str, FaultIsolability] = {}
    for i, fault in enumerate(plan.faults):
        order = [j for j in np.argsort(angles[i]).tolist() if j != i and math.isfinite(angles[i, j])]
        confused = [j for j in order if is_confused[i, j]]
        faults[fault.name] = FaultIsolability(
            fault.name, fault.address, fault.unit, fault.alarm,
            sd_alone=fault.alarm * float(sds[i]), sd_free=fault.alarm * float(free[i]),
            nearest=plan.faults[order[0]].name if order else "", angle=float(angles[i, order[0]]) if order else 90.0,
            confused_with=tuple(plan.faults[j].name for j in confused),
            separating={plan.faults[j].name: added.get((i, j)) for j in confused},
        )  # fmt: skip
    remarks = [fault.note for fault in faults.values()]
    if np.all(np.ptp(effects.run.outputs[:n_channels], axis=1) < noise):
        remarks.insert(0, Note("watch.still_run"))
    return Isolability(
        faults, angles, tuple(channel.address for channel in plan.channels), float(problem.grid[-1]),
        problem.grid.size, problem.grid,
        {fault.name: effects.faults[i, :n_channels] for i, fault in enumerate(plan.faults)}, noise, tuple(remarks),
    )  # fmt: skip


def _healthy_run(
    plan: WatchPlan, time: Array | None, inputs: Array | None, sample_time: float | None
) -> tuple[Problem, list[str]]:
    """Return the run of the healthy plant, and the addresses of its outputs: the sensors, then possible ones."""
    circuit = plan.circuit
    run = circuit.run.changed(output_step=sample_time)
    if time is not None and inputs is not None:
        time = time - time[0]
        signals = {
            item.address: _held(time, values) if item.hold else SampledSignal(time, values, item.address)
            for item, values in zip(plan.inputs, inputs.T, strict=True)
        }
        circuit = circuit.with_signals({**circuit.signals, **signals})
        step = sample_time or float(np.median(np.diff(time)))
        run = run.changed(duration=float(time[-1]), output_step=step)
    instance = circuit.instance
    outputs = [name for name, _ in instance.model.outputs]
    measured = [channel.address for channel in plan.channels]
    possible = [
        name for name, unit in instance.model.outputs
        if unit in GAUGES and name not in measured and name not in instance.inner
    ]  # fmt: skip
    names = [*measured, *possible]
    kernel = instance.kernel.observing(tuple(outputs.index(name) for name in names))
    return replace(instance.problem(run), kernel=kernel, stop_conditions=()), names


def _held(time: Array, values: Array) -> Steps:
    is_changed = np.diff(values, prepend=np.nan) != 0.0
    return Steps(time[is_changed], values[is_changed])


def _effects(plan: WatchPlan, problem: Problem) -> _Effects:
    """Simulate the healthy run and its sensitivities, scaled to alarm sizes and standard deviations."""
    n_faults, n_channels = len(plan.faults), len(plan.channels)
    sizes = np.array([*(fault.alarm for fault in plan.faults), *(nuisance.sigma for nuisance in plan.nuisances)])
    run = sensitivities(plan, problem, sizes)
    by_free = run.by_free.copy()
    by_free[:, :n_channels] += plan.effects.T[: sizes.size, :, np.newaxis]
    by_free *= sizes[:, np.newaxis, np.newaxis]
    offsets = np.zeros((len(plan.offsets), *run.outputs.shape))
    for k, channel in enumerate(plan.offsets):
        offsets[k, channel] = plan.channels[channel].offset
    return _Effects(run, by_free[:n_faults], np.concatenate([by_free[n_faults:], offsets, START * run.by_start]))


def _candidates(plan: WatchPlan, run: Sensitivities, names: Sequence[str]) -> Iterator[tuple[int, AddedSensor]]:
    """Yield the index of each output that could be measured too, and its sensor.

    The sensor has the noise and the offset of the sensors of the plan with the same unit.
    """
    units = dict(plan.circuit.instance.model.outputs)
    flows = [row for row, name in enumerate(names) if units[name] == "kg/s"]
    largest_flow = float(np.max(np.abs(run.outputs[flows]), initial=0.0))
    for row in range(len(plan.channels), len(names)):
        unit = units[names[row]]
        gauge, alike = GAUGES[unit], [channel for channel in plan.channels if channel.si_unit == unit]
        noise = offset = gauge.noise * (largest_flow if gauge.is_relative else 1.0)
        if alike:
            noise, offset = (max(getattr(channel, name) for channel in alike) for name in ("noise", "offset"))
        if noise > 0.0:
            yield row, AddedSensor(names[row], gauge.word, noise, offset, unit, 0.0)


def _separations_with(
    effects: _Effects, compact: Array, row: int, sensor: AddedSensor, directions: Sequence[int]
) -> Array:
    """Return the separations of all faults with an additional sensor, (f, f).

    `compact` contains the information of the present sensors on faults and nuisances, and `row` is the index of the
    additional output.
    """
    faults, nuisances = effects.whitened([row], np.array([sensor.noise]))
    n_faults = faults.shape[1]
    offset = np.full((len(faults), 1), sensor.offset / sensor.noise)
    previous = np.hstack([compact[:, n_faults:], np.zeros((len(compact), 1))])
    all_faults = np.vstack([compact[:, :n_faults], faults])
    all_nuisances = np.vstack([previous, np.hstack([nuisances, offset])])
    remaining = with_scatter(remaining_effects(all_faults, all_nuisances), SCATTER)
    return separations(remaining, effect_angles(remaining, directions))
