"""Estimator of a plant, and its use of samples."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.problem import Outcome
from poppet.engine.state_start import model_from_state
from poppet.monitoring.input_course import FilledSample, InputCourse
from poppet.monitoring.onsets import ONSETS
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.windows import Arrival

Array = NDArray[np.float64]


def make_estimator(plan: WatchPlan, fuses: bool, onsets: int = ONSETS) -> EstimatorCall:
    """Return the estimator of a plan, without an estimate."""
    instance, model = plan.instance, model_from_state(plan.instance.model)
    names = [name for name, _ in model.outputs]
    estimator = EstimatorCall(
        model, [names.index(channel.address) for channel in plan.channels], plan.free.places.tolist(),
        plan.touched_inputs.tolist(), plan.directions, plan.effects, onsets=onsets, faults=len(plan.faults),
        tolerance=plan.tolerance, fuses=fuses,
    )  # fmt: skip
    _, p = instance.start()
    numbers, u = instance.numbers(), instance.held_inputs({})
    estimator.p[: numbers.size] = numbers
    estimator.p[len(model.parameters) :] = p[numbers.size :]
    estimator.u[:] = u
    estimator.base[:] = np.append(estimator.p[plan.free.places], u[plan.touched_inputs])
    estimator.reference[:], estimator.low[:], estimator.high[:] = plan.reference, plan.low, plan.high
    estimator.noise[:] = [channel.noise**2 for channel in plan.channels]
    estimator.gates[:] = [channel.gate**2 for channel in plan.channels]
    n = len(model.states)
    estimator.walk[n:], estimator.cap[n:] = plan.walk, plan.cap**2
    return estimator


def use_last(estimator: EstimatorCall, inputs: InputCourse, history: Sequence[FilledSample]) -> bool:
    """Move the estimates to the last sample and use its readings; return False if this fails."""
    previous, sample = history[-2], history[-1]
    estimator.readings[:] = sample.readings
    step = sample.time - previous.time
    if inputs.is_held and sample.row is previous.row:
        return (estimator.update(step) if step > 0.0 else estimator.correct()) is Outcome.DONE
    if step > 0.0:
        for piece in inputs.pieces(history):
            estimator.u[0], estimator.u[1] = piece.begin, piece.end
            if estimator.advance(piece.duration) is not Outcome.DONE:
                return False
    estimator.u[:] = inputs.vector(history)
    return estimator.correct() is Outcome.DONE


class EstimateReplay:
    """Estimates between kept ones: the samples after a kept estimate are used again, without evidence for faults.

    Parameters
    ----------
    plan : WatchPlan
        Plan of the filter.
    noise : ndarray
        Standard deviations of the readings, (c,).
    inputs : InputCourse
        Course of the inputs of the filter.
    fuses : bool
        As for the filter.
    """

    def __init__(self, plan: WatchPlan, noise: Array, inputs: InputCourse, *, fuses: bool) -> None:
        self._plan, self._noise, self._inputs, self._fuses = plan, noise, inputs, fuses

    @cached_property
    def _estimator(self) -> EstimatorCall:
        estimator = make_estimator(self._plan, self._fuses, onsets=0)
        estimator.noise[:] = self._noise**2
        return estimator

    def __call__(self, start: Arrival, history: Sequence[FilledSample], time: float, walk: Array) -> Arrival:
        """Return the estimate after the last sample until a time [s], from one that is not later.

        `walk` contains the variances of the random walks in one second, (n + m,). If the estimator fails, the result is
        the start.
        """
        samples = [sample for sample in history if sample.time <= start.time]
        repeated = [sample for sample in history if start.time < sample.time <= time]
        if not repeated or not samples:
            return start
        estimator, n_memory = self._estimator, start.memory.size
        memory = estimator.p[estimator.p.size - n_memory :]
        estimator.mean[:], estimator.covariance[:], memory[:] = start.mean, start.covariance, start.memory
        estimator.walk[:], estimator.time[0], estimator.rejected[:] = walk, start.time, 0.0
        estimator.restart()
        estimator.u[:] = self._inputs.vector(samples)
        squares = start.squares
        for sample in repeated:
            samples.append(sample)
            if not use_last(estimator, self._inputs, samples):
                return start
            squares += estimator.nis
        return Arrival(repeated[-1].time, estimator.mean.copy(), estimator.covariance.copy(), memory.copy(), squares)
