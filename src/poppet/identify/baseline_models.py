"""Linear reference models, fitted to the same recordings for comparison with the circuit.

Two models are fitted to each channel and its command: a first-order lag with dead time by simulation, and a
second-order ARX model by least squares. Both then simulate the recording from its first measured value.
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
"""Upper limit on the dead time, as a fraction of the duration of the shortest recording."""
LEAST_DEAD_TIME = 0.4
"""Smallest upper limit on the dead time, itself limited to 20 % of the shortest recording [s]."""


@dataclass(frozen=True, eq=False)
class Response:
    """Recorded response of one output of a circuit to the input that commands it."""

    name: str  # `recording.channel`
    time: FloatArray  # times of the samples, strictly increasing, from 0, (n,) [s]
    measured: FloatArray  # measured channel, (n,)
    command_time: FloatArray  # start times of the commands, strictly increasing, possibly before 0, (m,) [s]
    command: FloatArray  # piecewise constant command, (m,)
    first: float  # smoothed value of the channel at time 0

    def commanded(self, time: FloatArray) -> FloatArray:
        """Return the recorded command at the times `time`.

        The command is constant between its changes. Before the first recorded command, the result is the first recorded
        command.
        """
        # At the sample instant of a new command, use the new one, in spite of rounding errors of both clocks.
        index = np.searchsorted(self.command_time, time + 1e-9, side="right") - 1
        command: FloatArray = self.command[np.maximum(index, 0)]
        return command

    def resample(self, step: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Resample the recorded command and response with a constant time step [s].

        The result contains the times, the command (constant between its changes) and the linearly interpolated
        response.
        """
        time = np.arange(0.0, self.time[-1] + 1e-9, step)
        return time, self.commanded(time), np.interp(time, self.time, self.measured)


@dataclass(frozen=True)
class FirstOrder:
    r"""First-order lag with dead time, gain and offset.

    .. math:: \tau \dot y + y = K u(t - \theta) + c

    Notes
    -----
    u is the command, y the output, tau the time constant, K the gain, theta the dead time and c the offset. Until
    the first recorded command takes effect, the output stays at its first value, because earlier commands are not
    available.
    """

    dead_time: float  # theta [s]
    time_constant: float  # tau [s]
    gain: float  # K
    offset: float  # c

    def simulate(self, response: Response) -> FloatArray:
        """Return the output of the first-order lag at the sample times of a recorded response.

        The simulation uses the recorded command, and starts from the first recorded value.
        """
        gain, offset, free = first_order_columns(response, self.dead_time, self.time_constant)
        return self.gain * gain + self.offset * offset + free


@dataclass(frozen=True, eq=False)
class SecondOrderArx:
    """Linear difference equation of second order, with dead time and a constant.

    y_k is the output at step k, u the command, d the dead time in steps, and c the constant.

    .. math:: y_k = a_1 y_{k-1} + a_2 y_{k-2} + b_1 u_{k-d} + b_2 u_{k-d-1} + c
    """

    step: float  # time between two values of the model [s]
    dead_steps: int  # d
    a: FloatArray  # coefficients of the channel, (2,)
    b: FloatArray  # coefficients of the command, (2,)
    constant: float  # c

    def simulate(self, response: Response) -> FloatArray:
        """Return the output of the difference equation at the sample times of a recorded response.

        The simulation uses the recorded command, and starts from the first recorded value.
        """
        from scipy.signal import lfilter, lfiltic

        time = np.arange(0.0, response.time[-1] + self.step, self.step)
        push = self._input_terms(response, time)
        denominator = np.concatenate([[1.0], -self.a])
        state = lfiltic([1.0], denominator, [response.first, response.first])
        # An unstable model overflows; its error is then not-a-number, and another dead time is selected.
        with np.errstate(over="ignore", invalid="ignore"):
            run = lfilter([1.0], denominator, push, zi=state)[0]
        simulated: FloatArray = np.interp(response.time, time, run)
        return simulated

    def one_step(self, response: Response) -> tuple[FloatArray, FloatArray]:
        """Return one-step-ahead predictions of a recorded response, and the measured values.

        The response is first interpolated at equal intervals, the time step of the model. Each prediction uses the two
        previous measured values.
        """
        time, _, measured = response.resample(self.step)
        predicted = self._input_terms(response, time)[2:] + self.a[0] * measured[1:-1] + self.a[1] * measured[:-2]
        return predicted, measured[2:]

    def _input_terms(self, response: Response, time: FloatArray) -> FloatArray:
        """Return the contribution of command and constant to each step of the difference equation.

        `time` contains the times of the steps. Until the first recorded command takes effect, the command is assumed to
        be the value that keeps the output at its first value.
        """
        first_time, second_time = (time - d * self.step for d in (self.dead_steps, self.dead_steps + 1))
        start, total = response.command_time[0] - 1e-9, float(np.sum(self.b))
        steady_command = response.commanded(np.zeros(1))[0]
        if total != 0.0:
            steady_command = ((1.0 - float(np.sum(self.a))) * response.first - self.constant) / total
        first, second = (
            np.where(delayed_time < start, steady_command, response.commanded(delayed_time))
            for delayed_time in (first_time, second_time)
        )
        push: FloatArray = self.b[0] * first + self.b[1] * second + self.constant
        return push


@dataclass(frozen=True)
class Score:
    """Errors of one model for one measured channel.

    Parameters
    ----------
    response : str
        `recording.channel`.
    model : str
        Name of the model.
    held_out : bool
        True if the recording was withheld from the fit for validation.
    rms : float
        Root mean square of model - measured, in the SI unit of the channel.
    nrmse : float
        Ratio of `rms` to the range (max - min) of the measurement.
    fit : float
        100 (1 - |model - measured| / |measured - its mean|) [%].
    samples : int
        Number of compared samples.
    """

    response: str
    model: str
    held_out: bool
    rms: float
    nrmse: float
    fit: float
    samples: int


def score_model(response: str, model: str, held_out: bool, simulated: FloatArray, measured: FloatArray) -> Score:
    """Return the errors of a simulated response relative to its measurement.

    `response` and `model` are the names of the response and of the model. `held_out` is True for validation data.

    Examples
    --------
    >>> score = score_model("a.p", "mean", False, np.array([1.0, 1.0]), np.array([0.0, 2.0]))
    >>> score.nrmse, score.fit
    (0.5, 0.0)
    """
    summary, spread = ResidualSummary.of(simulated, measured, ""), float(np.linalg.norm(measured - np.mean(measured)))
    fit = 100.0 * (1.0 - float(np.linalg.norm(simulated - measured)) / spread) if spread > 0.0 else float("-inf")
    return Score(response, model, held_out, summary.rms, summary.nrmse, fit, summary.samples)


def first_order_columns(
    response: Response, dead_time: float, time_constant: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return three series, (n,) each, from which the output of a first-order lag is composed.

    They are the response to the command per unit gain, the response per unit offset, and the decay of the first value.
    The output is gain times the first series plus offset times the second plus the third.
    """
    start = max(0.0, float(response.command_time[0]) + dead_time)
    # Between commands the response is exponential: a grid of commands and samples makes it exact.
    arrival = response.command_time + dead_time
    is_between = (arrival > start) & (arrival < response.time[-1])
    grid = np.unique(np.concatenate([[start], arrival[is_between], response.time[response.time > start]]))
    decay = np.exp(-np.diff(grid) / time_constant)
    pushed = response.commanded(grid[:-1] - dead_time) * (1.0 - decay)
    answer = recursion(np.concatenate([[0.0], decay]), np.concatenate([[0.0], pushed]))
    remaining = np.exp(-np.maximum(response.time - start, 0.0) / time_constant)
    return np.interp(response.time, grid, answer), 1.0 - remaining, response.first * remaining


def fit_first_order(responses: Sequence[Response]) -> FirstOrder:
    """Fit a first-order lag with dead time to measured channels.

    The fit minimises the simulation error.

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
        matrix = np.vstack([np.column_stack(columns[:2]) for columns in parts])
        target = np.concatenate([r.measured - columns[2] for r, columns in zip(responses, parts, strict=True)])
        solution = np.linalg.lstsq(matrix, target, rcond=None)[0]
        return float(np.sum((matrix @ solution - target) ** 2)), solution

    def cost(point: FloatArray) -> float:
        return linear(float(np.clip(point[0], 0.0, longest)), float(np.exp(point[1])))[0]

    # Gain and offset follow by linear least squares; the search has two dimensions and starts from a grid.
    lags = np.log(np.geomspace(1e-3 * span, 0.5 * span, 20))
    point = min((np.array([d, lag]) for d in np.linspace(0.0, longest, 16) for lag in lags), key=cost)
    end = minimize(cost, point, method="Nelder-Mead", options={"xatol": 1e-6, "fatol": 0.0, "maxiter": 2000}).x
    dead_time, time_constant = float(np.clip(end[0], 0.0, longest)), float(np.exp(end[1]))
    gain, offset = linear(dead_time, time_constant)[1]
    return FirstOrder(dead_time, time_constant, float(gain), float(offset))


def fit_arx(responses: Sequence[Response]) -> SecondOrderArx:
    """Fit a second-order ARX model to measured channels.

    Linear least squares on the one-step errors gives the coefficients for each dead time. The selected dead time has
    the smallest simulation error.
    """
    step = float(np.median(np.concatenate([np.diff(r.time) for r in responses])))
    best, least = None, np.inf
    for dead_steps in range(int(_longest_dead_time(responses) / step) + 1):
        rows, target = [], []
        for r in responses:
            _, command, measured = r.resample(step)
            k = np.arange(max(2, dead_steps + 1), measured.size)
            driven = command[k - dead_steps], command[k - dead_steps - 1]
            rows.append(np.column_stack((measured[k - 1], measured[k - 2], *driven, np.ones(k.size))))
            target.append(measured[k])
        a1, a2, b1, b2, constant = np.linalg.lstsq(np.vstack(rows), np.concatenate(target), rcond=None)[0]
        model = SecondOrderArx(step, dead_steps, np.array([a1, a2]), np.array([b1, b2]), float(constant))
        error = float(sum(np.sum((model.simulate(r) - r.measured) ** 2) for r in responses))
        if best is None or error < least:
            best, least = model, error
    assert best is not None
    return best


def _longest_dead_time(responses: Iterable[Response]) -> float:
    shortest = min(float(r.time[-1]) for r in responses)
    return max(LONGEST_DEAD_TIME * shortest, min(LEAST_DEAD_TIME, 0.2 * shortest))


def responses_of(measurement: Measurement, commands: Mapping[str, str]) -> list[Response]:
    """Return the recorded responses of all channels that are listed in `commands`.

    `commands` maps the address of a channel to the address of the input that commands it.
    """
    inputs = {item.address: item for item in measurement.inputs}
    responses = []
    for channel in measurement.channels:
        if channel.address not in commands:
            continue
        command = commands[channel.address]
        if command not in inputs:
            near = NameSuggestion(command, inputs)
            location = f"recordings.{measurement.name}.inputs.{command}"
            raise InputError("names.unknown", location, meaning="an input of this recording", suggestion=near)
        item = inputs[command]
        name = f"{measurement.name}.{channel.address}"
        responses.append(Response(name, channel.time, channel.values, item.time, item.values, first_value(channel)))
    return responses


def baselines(plan: FitPlan, commands: Mapping[str, str], result: Result | None = None) -> list[Score]:
    """Return the errors of both linear models and, if available, of the circuit.

    The circuit is included if `result` is given.

    Parameters
    ----------
    plan : FitPlan
        Plan with the recordings. Recordings with `use = "validation"` are the validation data.
    commands : mapping
        Mapping from the address of each channel to the address of its command.
    result : Result, optional
        Result of the fit of the circuit to the same plan.

    Returns
    -------
    list of Score
        Scores of the circuit, of the first-order lag, and of the ARX model (simulation and one-step prediction), for
        each channel of each recording.

    Examples
    --------
    >>> from poppet.identify import read_fit_file  # doctest: +SKIP
    >>> print(score_table(baselines(read_fit_file("fit.toml"), {"arm.pressure": "valve.setpoint"})))  # doctest: +SKIP
    """
    fitted = [r for e in plan.experiments for r in responses_of(e.measurement, commands)]
    compared = [r for e in plan.validation for r in responses_of(e.measurement, commands)]
    scores = []
    for channel in commands:
        training, validation = (
            [r for r in windows if r.name.endswith(f".{channel}")] for windows in (fitted, compared)
        )
        if not training:
            near = NameSuggestion(channel, {r.name.partition(".")[2] for r in fitted})
            raise InputError("names.unknown", channel, meaning="a channel of a fitted recording", suggestion=near)
        lag, arx = fit_first_order(training), fit_arx(training)
        for r, held_out in [*((r, False) for r in training), *((r, True) for r in validation)]:
            pairs = {FIRST_ORDER: (lag.simulate(r), r.measured), ARX: (arx.simulate(r), r.measured)}
            pairs[ONE_STEP] = arx.one_step(r)
            if result is not None:
                series = result.series[r.name]
                pairs = {GREY_BOX: (series["model"], series["measured"]), **pairs}
            scores += [score_model(r.name, model, held_out, *pair) for model, pair in pairs.items()]
    return scores


def score_table(scores: Sequence[Score]) -> str:
    """Return a Markdown table with the NRMSE and the fit of each model.

    Parameters
    ----------
    scores : sequence of Score
        Scores from `baselines`.

    Returns
    -------
    str
        Markdown table.

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
        scores_by_model = {s.model: s for s in scores if s.response == name}
        use = "held out" if next(iter(scores_by_model.values())).held_out else "fitted"
        cells = (
            f"{100.0 * scores_by_model[m].nrmse:.2f} % ({scores_by_model[m].fit:.1f})" if m in scores_by_model else ""
            for m in models
        )
        lines.append([name, use, *cells])
    return "\n".join("|" + "|".join(f" {cell} " if cell != "---" else cell for cell in line) + "|" for line in lines)
