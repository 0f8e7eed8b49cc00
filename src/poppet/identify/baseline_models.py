"""Baselines: what plain linear models make of the same recordings, so that a physical one has something to beat.

Two are fitted to each channel and its command: a first-order lag with dead time, by simulation, and a second-order
ARX, by least squares. Both are then left to run freely from the first measured value, as a circuit is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from poppet.core.errors import InputError, NameSuggestion
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.fit_series import first_value, recursion
from poppet.identify.result import ResidualSummary, Result
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Measurement

GREY_BOX, FIRST_ORDER, ARX, ONE_STEP = "circuit", "first order + dead time", "ARX", "ARX, one step"
LONGEST_DEAD_TIME = 0.1
"""Of the training window; longer ones are not tried."""
LEAST_DEAD_TIME = 0.4
"""A dead time up to this is always tried where the window is ten times as long or more [s]."""


@dataclass(frozen=True, eq=False)
class Response:
    """What a channel answered to its command within one window of a recording."""

    name: str  # `recording.channel`
    time: FloatArray  # of the samples, strictly increasing, from 0, (n,) [s]
    measured: FloatArray  # the channel, (n,)
    command_time: FloatArray  # when each value begins, strictly increasing; before 0 is history, (m,) [s]
    command: FloatArray  # held from sample to sample, as a computer writes it, (m,)
    first: float  # the channel at 0, freed of noise as far as can be

    def commanded(self, time: FloatArray) -> FloatArray:
        """The command at some times [s]; its first value before it begins."""
        # A sample at the very instant of a command sees the new one, whatever rounding did to either clock.
        place = np.searchsorted(self.command_time, time + 1e-9, side="right") - 1
        held: FloatArray = self.command[np.maximum(place, 0)]
        return held

    def even(self, step: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Times at a constant step [s], the command held there, and the channel, straight between its samples."""
        time = np.arange(0.0, self.time[-1] + 1e-9, step)
        return time, self.commanded(time), np.interp(time, self.time, self.measured)


@dataclass(frozen=True)
class FirstOrder:
    r"""A first-order lag with dead time, gain and offset.

    .. math:: \tau \dot y + y = K u(t - \theta) + c

    Notes
    -----
    Before its first command can have arrived the channel rests at its first value: nothing is known of what was
    commanded before a record begins.
    """

    dead_time: float  # theta [s]
    time_constant: float  # tau [s]
    gain: float  # K
    offset: float  # c

    def simulate(self, response: Response) -> FloatArray:
        """The channel by this model alone, from its first value, at the times of the samples."""
        gain, offset, free = first_order_columns(response, self.dead_time, self.time_constant)
        return self.gain * gain + self.offset * offset + free


@dataclass(frozen=True, eq=False)
class SecondOrderArx:
    r"""A linear second-order difference equation with dead time and a constant.

    .. math:: y_k = a_1 y_{k-1} + a_2 y_{k-2} + b_1 u_{k-d} + b_2 u_{k-d-1} + c
    """

    step: float  # between samples [s]
    dead_steps: int  # d
    a: FloatArray  # of the channel, (2,)
    b: FloatArray  # of the command, (2,)
    constant: float  # c

    def simulate(self, response: Response) -> FloatArray:
        """The channel by this model alone, from its first value, at the times of the samples."""
        from scipy.signal import lfilter, lfiltic

        time = np.arange(0.0, response.time[-1] + self.step, self.step)
        push = self._push(response, time)
        denominator = np.concatenate([[1.0], -self.a])
        state = lfiltic([1.0], denominator, [response.first, response.first])
        # An unstable model runs away; its error is then no number, and another dead time wins.
        with np.errstate(over="ignore", invalid="ignore"):
            run = lfilter([1.0], denominator, push, zi=state)[0]
        shown: FloatArray = np.interp(response.time, time, run)
        return shown

    def one_step(self, response: Response) -> tuple[FloatArray, FloatArray]:
        """Prediction of each sample of the even grid from the two measured before it, and that sample."""
        time, _, measured = response.even(self.step)
        known = self._push(response, time)[2:] + self.a[0] * measured[1:-1] + self.a[1] * measured[:-2]
        return known, measured[2:]

    def _push(self, response: Response, time: FloatArray) -> FloatArray:
        """What the command adds at each time; before the first one can have arrived, what keeps the channel at rest."""
        late, later = (time - d * self.step for d in (self.dead_steps, self.dead_steps + 1))
        begin, total = response.command_time[0] - 1e-9, float(np.sum(self.b))
        rest = response.commanded(np.zeros(1))[0]
        if total != 0.0:
            rest = ((1.0 - float(np.sum(self.a))) * response.first - self.constant) / total
        first, second = (np.where(at < begin, rest, response.commanded(at)) for at in (late, later))
        push: FloatArray = self.b[0] * first + self.b[1] * second + self.constant
        return push


@dataclass(frozen=True)
class Score:
    """How far one model is from one channel.

    Parameters
    ----------
    response : str
        `recording.channel`.
    model : str
        Which one.
    held_out : bool
        The model has not seen this window.
    rms : float
        Root mean square of model - measured.
    nrmse : float
        rms over the range (max - min) of the measurement.
    fit : float
        100 (1 - |model - measured| / |measured - its mean|) [%].
    samples : int
        Compared.
    """

    response: str
    model: str
    held_out: bool
    rms: float
    nrmse: float
    fit: float
    samples: int


def scored(response: str, model: str, held_out: bool, shown: FloatArray, measured: FloatArray) -> Score:
    """Compare a model with a measurement.

    Examples
    --------
    >>> score = scored("a.p", "mean", False, np.array([1.0, 1.0]), np.array([0.0, 2.0]))
    >>> score.nrmse, score.fit
    (0.5, 0.0)
    """
    found, spread = ResidualSummary.of(shown, measured, ""), float(np.linalg.norm(measured - np.mean(measured)))
    fit = 100.0 * (1.0 - float(np.linalg.norm(shown - measured)) / spread) if spread > 0.0 else float("-inf")
    return Score(response, model, held_out, found.rms, found.nrmse, fit, found.samples)


def first_order_columns(
    response: Response, dead_time: float, time_constant: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """What gain and offset of a first-order lag are multiplied by, and what its first value leaves."""
    begin = max(0.0, float(response.command_time[0]) + dead_time)
    # Between arrivals of commands the answer is an exponential: exact on a grid of these and of the samples.
    arrival = response.command_time + dead_time
    inside = (arrival > begin) & (arrival < response.time[-1])
    grid = np.unique(np.concatenate([[begin], arrival[inside], response.time[response.time > begin]]))
    decay = np.exp(-np.diff(grid) / time_constant)
    pushed = response.commanded(grid[:-1] - dead_time) * (1.0 - decay)
    answer = recursion(np.concatenate([[0.0], decay]), np.concatenate([[0.0], pushed]))
    left = np.exp(-np.maximum(response.time - begin, 0.0) / time_constant)
    return np.interp(response.time, grid, answer), 1.0 - left, response.first * left


def fit_first_order(responses: Sequence[Response]) -> FirstOrder:
    """The first-order lag with dead time that, running freely, comes nearest to the responses.

    Examples
    --------
    >>> t = np.linspace(0.0, 4.0, 81)
    >>> true = FirstOrder(0.3, 0.5, 2.0, 1.0)
    >>> blank = Response("a.p", t, np.zeros(81), np.array([0.0, 1.0]), np.array([0.0, 1.0]), 1.0)
    >>> found = fit_first_order([Response("a.p", t, true.simulate(blank), blank.command_time, blank.command, 1.0)])
    >>> round(found.dead_time, 3), round(found.time_constant, 3), round(found.gain, 3)
    (0.3, 0.5, 2.0)
    """
    from scipy.optimize import minimize

    longest = _longest_dead_time(responses)
    span = max(float(r.time[-1]) for r in responses)

    def linear(dead_time: float, time_constant: float) -> tuple[float, FloatArray]:
        parts = [first_order_columns(r, dead_time, time_constant) for r in responses]
        matrix = np.vstack([np.column_stack(each[:2]) for each in parts])
        target = np.concatenate([r.measured - each[2] for r, each in zip(responses, parts, strict=True)])
        solution = np.linalg.lstsq(matrix, target, rcond=None)[0]
        return float(np.sum((matrix @ solution - target) ** 2)), solution

    def cost(place: FloatArray) -> float:
        return linear(float(np.clip(place[0], 0.0, longest)), float(np.exp(place[1])))[0]

    # Gain and offset follow by linear least squares, so that the search has two dimensions; a grid finds its basin.
    lags = np.log(np.geomspace(1e-3 * span, 0.5 * span, 20))
    place = min((np.array([d, lag]) for d in np.linspace(0.0, longest, 16) for lag in lags), key=cost)
    end = minimize(cost, place, method="Nelder-Mead", options={"xatol": 1e-6, "fatol": 0.0, "maxiter": 2000}).x
    dead_time, time_constant = float(np.clip(end[0], 0.0, longest)), float(np.exp(end[1]))
    gain, offset = linear(dead_time, time_constant)[1]
    return FirstOrder(dead_time, time_constant, float(gain), float(offset))


def fit_arx(responses: Sequence[Response]) -> SecondOrderArx:
    """The second-order ARX model of least one-step error."""
    step = float(np.median(np.concatenate([np.diff(r.time) for r in responses])))
    best, least = None, np.inf
    for dead_steps in range(int(_longest_dead_time(responses) / step) + 1):
        model = _arx_at(responses, step, dead_steps)
        error = float(sum(np.sum((model.simulate(r) - r.measured) ** 2) for r in responses))
        if best is None or error < least:
            best, least = model, error
    assert best is not None
    return best


def _longest_dead_time(responses: Iterable[Response]) -> float:
    shortest = min(float(r.time[-1]) for r in responses)
    return max(LONGEST_DEAD_TIME * shortest, min(LEAST_DEAD_TIME, 0.2 * shortest))


def _arx_at(responses: Sequence[Response], step: float, dead_steps: int) -> SecondOrderArx:
    rows, target = [], []
    for r in responses:
        _, command, measured = r.even(step)
        k = np.arange(max(2, dead_steps + 1), measured.size)
        driven = command[k - dead_steps], command[k - dead_steps - 1]
        rows.append(np.column_stack((measured[k - 1], measured[k - 2], *driven, np.ones(k.size))))
        target.append(measured[k])
    a1, a2, b1, b2, constant = np.linalg.lstsq(np.vstack(rows), np.concatenate(target), rcond=None)[0]
    return SecondOrderArx(step, dead_steps, np.array([a1, a2]), np.array([b1, b2]), float(constant))


def responses_of(measurement: Measurement, commands: Mapping[str, str]) -> list[Response]:
    """Every channel of a recording that has a command."""
    inputs = {item.address: item for item in measurement.inputs}
    found = []
    for channel in measurement.channels:
        if channel.address not in commands:
            continue
        wanted = commands[channel.address]
        if wanted not in inputs:
            where = f"recordings.{measurement.name}.{channel.address}"
            raise InputError("baseline.no_input", where, wanted=wanted, near=NameSuggestion(wanted, inputs))
        item = inputs[wanted]
        name = f"{measurement.name}.{channel.address}"
        found.append(Response(name, channel.time, channel.values, item.time, item.values, first_value(channel)))
    return found


def baselines(plan: FitPlan, commands: Mapping[str, str], result: Result | None = None) -> list[Score]:
    """Both baselines, fitted and held out on the windows of a fit file, beside the circuit.

    Parameters
    ----------
    plan : FitPlan
        Its recordings: those with `use = "validation"` are held out.
    commands : mapping
        Address of a channel to that of the input which commands it.
    result : Result, optional
        What the circuit made of the same plan.

    Returns
    -------
    list of Score
        For every channel and window the circuit, the first-order lag, and the ARX model running freely and
        predicting one step.

    Examples
    --------
    >>> from poppet.identify import read_fit_file  # doctest: +SKIP
    >>> print(score_table(baselines(read_fit_file("fit.toml"), {"arm.pressure": "valve.setpoint"})))  # doctest: +SKIP
    """
    fitted = [r for e in plan.experiments for r in responses_of(e.measurement, commands)]
    compared = [r for e in plan.validation for r in responses_of(e.measurement, commands)]
    scores = []
    for channel in commands:
        seen, unseen = ([r for r in each if r.name.endswith(f".{channel}")] for each in (fitted, compared))
        if not seen:
            raise InputError("baseline.no_channel", channel)
        lag, arx = fit_first_order(seen), fit_arx(seen)
        for r, held_out in [*((r, False) for r in seen), *((r, True) for r in unseen)]:
            shown = {FIRST_ORDER: (lag.simulate(r), r.measured), ARX: (arx.simulate(r), r.measured)}
            shown[ONE_STEP] = arx.one_step(r)
            if result is not None:
                series = result.series[r.name]
                shown = {GREY_BOX: (series["model"], series["measured"]), **shown}
            scores += [scored(r.name, model, held_out, *pair) for model, pair in shown.items()]
    return scores


def score_table(scores: Sequence[Score]) -> str:
    """Scores as a table of text, NRMSE and fit of every model in one row for each channel and window.

    Parameters
    ----------
    scores : sequence of Score
        From `baselines`.

    Returns
    -------
    str
        A table as Markdown knows it.

    Examples
    --------
    >>> print(score_table([Score("a.p", "ARX", True, 2.0, 0.05, 81.26, 100)]))
    | recording and channel | use | ARX |
    |---|---|---|
    | a.p | held out | 5.00 % (81.3) |
    """
    models = list(dict.fromkeys(s.model for s in scores))
    head = ["recording and channel", "use", *models]
    lines = [head, ["---"] * len(head)]
    for name in dict.fromkeys(s.response for s in scores):
        own = {s.model: s for s in scores if s.response == name}
        use = "held out" if next(iter(own.values())).held_out else "fitted"
        cells = (f"{100.0 * own[m].nrmse:.2f} % ({own[m].fit:.1f})" if m in own else "" for m in models)
        lines.append([name, use, *cells])
    return "\n".join("|" + "|".join(f" {cell} " if cell != "---" else cell for cell in line) + "|" for line in lines)
