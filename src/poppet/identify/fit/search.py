"""Grey-box fit: free numbers of a circuit from recordings, by weighted least squares on the integrated equations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.ground.errors import InputError
from poppet.identify.fit.experiment import FAILED, Experiment
from poppet.identify.fit.whiteness import whiteness
from poppet.identify.fit.widths import over_widths, rounds
from poppet.identify.free import Free

Array = NDArray[np.float64]

LOSSES = ("linear", "soft_l1", "huber", "cauchy")
ROUNDS = 12
"""Rounds of weighing: where no noise is given, the residuals of a round say how large it is in the next."""
SUSPICIOUS = 0.05
"""Probability of white residuals below which other places are tried; a false alarm costs time only."""
PRECISION = 1e-8
"""Relative change of cost or numbers at which the search ends."""


@dataclass(frozen=True)
class Settings:
    """How to search.

    Parameters
    ----------
    loss : str
        `linear`, or a robust one: `soft_l1`, `huber`, `cauchy`.
    starts : int
        Number of places to begin at; the first is the given one.
    seed : int
        Of the other places.
    kicks : int or None
        Most rounds of trying to leave a false minimum, where the residuals are not white. None: 3, and none in circuits
        that sample, whose residuals are hardly ever white and whose runs take long.
    """

    loss: str = "linear"
    starts: int = 1
    seed: int = 0
    kicks: int | None = None

    def __post_init__(self) -> None:
        if self.loss not in LOSSES:
            from poppet.ground.errors import suggestion

            raise InputError(f"loss = {self.loss!r}", "is unknown.", suggestion(self.loss, LOSSES), address="loss")
        if isinstance(self.starts, bool) or not isinstance(self.starts, int) or not 1 <= self.starts <= 1000:
            raise InputError(
                f"starts = {self.starts!r}",
                "is not a number from 1 to 1000.",
                "Write starts = 8, say.",
                address="starts",
            )
        kicks = 0 if self.kicks is None else self.kicks
        if isinstance(kicks, bool) or not isinstance(kicks, int) or not 0 <= kicks <= 1000:
            raise InputError(
                f"kicks = {self.kicks!r}", "is not a number from 0 to 1000.", "Write kicks = 0 for none.",
                address="kicks",
            )  # fmt: skip


@dataclass
class Optimum:
    """Where a search ended.

    Parameters
    ----------
    x : (n_free,) array
        Values of the free numbers, SI.
    cost : float
        Half the sum of squares, in sigmas.
    jacobian : (n_samples, n_free) array
        Derivatives of the weighted residuals in SI units of the numbers, priors included.
    residual : (n_samples,) array
        Weighted residuals, priors included.
    sigmas : list of float
        Noise of each channel, in the order of experiments and channels.
    active : (n_free,) array of int
        -1 at the lower bound, 1 at the upper, 0 between.
    interrupted : bool
        The search was ended by the user.
    evaluations : int
        Runs of the search, slopes included.
    """

    x: Array
    cost: float
    jacobian: Array
    residual: Array
    sigmas: list[float]
    active: NDArray[np.int64]
    interrupted: bool = False
    evaluations: int = 0


@dataclass
class Objective:
    """Weighted residuals of all experiments as a function of the free numbers.

    Parameters
    ----------
    experiments : sequence of Experiment
        Recordings with their circuits.
    free : tuple of Free
        All free numbers, in the order of x.
    sigmas : list of float
        Noise of each channel.
    progress : callable, optional
        Called with the number of evaluations and the cost.
    evaluations : int
        Counted so far.
    held : mapping
        Free numbers that are held at a value, for profiles and trials.
    best : tuple of (float, (n_free,) array)
        Least cost so far, and where it was found; what an interrupt keeps.
    """

    experiments: Sequence[Experiment]
    free: tuple[Free, ...]
    sigmas: list[float]
    progress: Callable[[int, float], Any] | None = None
    evaluations: int = 0
    held: Mapping[str, float] = field(default_factory=dict)
    best: tuple[float, Array] = field(default_factory=lambda: (np.inf, np.zeros(0)))
    _last: tuple[bytes, Array, Array] | None = None

    def searched(self) -> NDArray[np.int64]:
        """Places of the numbers that are not held."""
        return np.array([k for k, f in enumerate(self.free) if f.name not in self.held], dtype=np.int64)

    def values(self, x: Array) -> dict[str, float]:
        """Free numbers by name."""
        return {f.name: float(v) for f, v in zip(self.free, x, strict=True)}

    def residual(self, x: Array) -> Array:
        """Weighted residuals, priors last."""
        values, pieces, k = self.values(x), [], 0
        for experiment in self.experiments:
            for channel, series in zip(experiment.measurement.channels, experiment.outputs(values), strict=True):
                pieces.append((series - channel.values) / self.sigmas[k])
                k += 1
        result = self._joined(pieces, x)
        self._note(x, result)
        return result

    def residual_if_new(self, x: Array) -> Array:
        """Weighted residuals, from the last slopes where they were made at x."""
        if self._last is not None and self._last[0] == x.tobytes():
            return self._last[1]
        return self.residual(x)

    def forget(self) -> None:
        """Take no result from before."""
        self._last = None

    def residual_and_jacobian(self, x: Array) -> tuple[Array, Array]:
        """Both, from runs over one step sequence."""
        key = x.tobytes()
        if self._last is not None and self._last[0] == key:
            return self._last[1], self._last[2]
        values, names = self.values(x), [f.name for f in self.free]
        pieces: list[Array] = []
        # Columns are written and read whole.
        jacobian = np.zeros((sum(sum(e.sizes) for e in self.experiments), x.size), order="F")
        k = row = 0
        for experiment in self.experiments:
            columns = [names.index(f.name) for f in experiment.free]
            series, slopes = experiment.outputs_and_slopes(values)
            for channel, model, slope in zip(experiment.measurement.channels, series, slopes, strict=True):
                rows = slice(row, row + model.size)
                for own, column in enumerate(columns):
                    jacobian[rows, column] = slope[:, own] / self.sigmas[k]
                pieces.append((model - channel.values) / self.sigmas[k])
                k, row = k + 1, rows.stop
        jacobian[~np.isfinite(jacobian)] = 0.0
        residual = self._joined(pieces, x)
        self._note(x, residual)
        priors = self._prior_rows()
        self._last = key, residual, np.vstack([jacobian, *priors]) if priors else jacobian
        return self._last[1], self._last[2]

    def _joined(self, pieces: list[Array], x: Array) -> Array:
        priors = [(v - f.prior.mean) / f.prior.sd for f, v in zip(self.free, x, strict=True) if f.prior]
        joined = np.concatenate([*pieces, priors])
        joined[~np.isfinite(joined)] = FAILED
        return joined

    def _prior_rows(self) -> list[Array]:
        rows = []
        for k, f in enumerate(self.free):
            if f.prior:
                row = np.zeros((1, len(self.free)))
                row[0, k] = 1.0 / f.prior.sd
                rows.append(row)
        return rows

    def _note(self, x: Array, residual: Array) -> None:
        self.evaluations += 1
        cost = 0.5 * float(residual @ residual)
        if cost < self.best[0]:
            self.best = cost, x.copy()
        if self.progress:
            self.progress(self.evaluations, self.best[0])


def optimise(
    experiments: Sequence[Experiment],
    free: tuple[Free, ...],
    settings: Settings | None = None,
    *,
    progress: Callable[[int, float], Any] | None = None,
    sigmas: list[float] | None = None,
    held: Mapping[str, float] | None = None,
) -> Optimum:
    """Find the free numbers that explain the recordings best."""
    settings = settings or Settings()
    given = [channel.noise for e in experiments for channel in e.measurement.channels]
    weights = (
        list(sigmas)
        if sigmas
        else [g if g else _estimated(c) for g, c in zip(given, _channels(experiments), strict=True)]
    )
    held = held or {}
    objective = Objective(experiments, free, weights, progress, held=held)
    x = np.array([held.get(f.name, f.start) for f in free])
    interrupted = False
    try:
        x = _searched(objective, x, settings)
        # Profiles and trials begin at the optimum: there is no false minimum to leave.
        x = x if held else _kicked(objective, x, settings)
        for _ in range(ROUNDS - 1 if sigmas is None and not all(given) else 0):
            refined = _refined(objective, x, given)
            settled = np.allclose(refined, objective.sigmas, rtol=0.02)
            objective = Objective(experiments, free, refined, progress, objective.evaluations, held)
            if settled:
                break
            x = _local(objective, x, settings)[0]
    except KeyboardInterrupt:
        interrupted = True
        x = objective.best[1] if objective.best[1].size else x
    residual, jacobian = objective.residual_and_jacobian(x)
    cost = 0.5 * float(residual @ residual)
    return Optimum(x, cost, jacobian, residual, objective.sigmas, _active(free, x), interrupted, objective.evaluations)


def _searched(objective: Objective, x: Array, settings: Settings) -> Array:
    """The best of local searches from several places."""
    best, cost = _local(objective, x, settings)
    generator = np.random.default_rng(settings.seed)
    for _ in range(settings.starts - 1):
        place = _elsewhere(objective.free, generator)
        searched = objective.searched()
        moved = x.copy()
        moved[searched] = place[searched]
        other, other_cost = _local(objective, moved, settings)
        if other_cost < cost:
            best, cost = other, other_cost
    return best


def _kicked(objective: Objective, x: Array, settings: Settings) -> Array:
    """Leave a false minimum: while the residuals are not white, try other places.

    Conductance and wall heat trade against each other, so that a discharge has a second, wrong minimum near the
    isothermal or the adiabatic limit; a misfit that is not noise gives it away.
    """
    most = rounds(settings.kicks, objective.experiments)
    if most == 0:
        return x
    cost, is_white = _cost(objective, x), not _is_suspicious(objective, x)
    for _ in range(most):
        before = cost
        for moved in [] if is_white else _kicks(objective, x):
            other, other_cost = _local(objective, moved, settings)
            if other_cost < cost * (1.0 - 1e-6):
                x, cost, is_white = other, other_cost, not _is_suspicious(objective, other)
            if is_white:
                break
        if cost > 0.999 * before:
            break
    return x


def _kicks(objective: Objective, x: Array) -> list[Array]:
    """Places to try: each number moved from where the search ended, and from where it began."""
    begin = np.array([objective.held.get(f.name, f.start) for f in objective.free])
    places = []
    for k in objective.searched():
        f = objective.free[k]
        for base, factor in ((x, 10.0), (x, 0.1), (begin, 10.0), (begin, 0.1), (begin, 1e-3)):
            moved = base.copy()
            moved[k] = np.clip((base[k] or 0.1 * f.scale) * factor, f.low, f.high)
            places.append(moved)
    return places


def _is_suspicious(objective: Objective, x: Array) -> bool:
    """True when the residuals of a channel are not white."""
    residual, k = objective.residual(x), 0
    for channel in _channels(objective.experiments):
        if whiteness(residual[k : k + channel.time.size]) < SUSPICIOUS:
            return True
        k += channel.time.size
    return False


def _local(objective: Objective, x: Array, settings: Settings) -> tuple[Array, float]:
    """The best of searches downhill from x: one, or several where a program samples."""
    if any(each.samples for each in objective.experiments):
        return over_widths(objective, x, lambda place: _downhill(objective, place, settings))
    return _downhill(objective, x, settings)


def _downhill(objective: Objective, x: Array, settings: Settings) -> tuple[Array, float]:
    """One search from x."""
    from scipy.optimize import least_squares

    places = objective.searched()
    if places.size == 0:
        return x, _cost(objective, x)
    scale = np.array([objective.free[k].scale for k in places])
    low = np.array([objective.free[k].low for k in places]) / scale
    high = np.array([objective.free[k].high for k in places]) / scale
    # The search needs room on both sides.
    room = 1e-3 * np.minimum(1.0, high - low)
    begin = np.clip(x[places] / scale, low + room, high - room)

    def whole(z: Array) -> Array:
        full = x.copy()
        full[places] = z * scale
        return full

    found = least_squares(
        lambda z: objective.residual_if_new(whole(z)),
        begin,
        jac=lambda z: objective.residual_and_jacobian(whole(z))[1].T[places].T * scale,
        bounds=(low, high),
        x_scale="jac",
        loss=settings.loss,
        ftol=PRECISION,
        xtol=PRECISION,
        gtol=1e-12,
        max_nfev=200,
    )
    return _snapped(objective, whole(found.x)), float(found.cost)


def _snapped(objective: Objective, x: Array) -> Array:
    """A search inside bounds ends a hair away from them; put it onto the bound where that is no worse."""
    result = x.copy()
    cost = _cost(objective, result)
    for k in objective.searched():
        f = objective.free[k]
        for bound in (f.low, f.high):
            if np.isfinite(bound) and 0.0 < abs(result[k] - bound) <= 1e-3 * f.scale:
                trial = result.copy()
                trial[k] = bound
                trial_cost = _cost(objective, trial)
                if trial_cost <= cost * (1.0 + 1e-9):
                    result, cost = trial, min(cost, trial_cost)
    return result


def _cost(objective: Objective, x: Array) -> float:
    residual = objective.residual(x)
    return 0.5 * float(residual @ residual)


def _elsewhere(free: tuple[Free, ...], generator: np.random.Generator) -> Array:
    """A random place: within finite bounds, else within a factor of ten of the start."""
    place = []
    for f in free:
        if np.isfinite(f.low) and np.isfinite(f.high) and f.low <= 0.0:
            place.append(generator.uniform(f.low, f.high) if f.high - f.low <= 100.0 * f.scale else f.start)
        else:
            place.append(np.clip(f.start * 10.0 ** generator.uniform(-1.0, 1.0), f.low, f.high))
    return np.array(place)


def _active(free: tuple[Free, ...], x: Array) -> NDArray[np.int64]:
    near = [
        (-1 if v <= f.low + 1e-6 * f.scale else 1 if v >= f.high - 1e-6 * f.scale else 0)
        for f, v in zip(free, x, strict=True)
    ]
    return np.array(near, dtype=np.int64)


def _channels(experiments: Sequence[Experiment]) -> list[Any]:
    return [channel for e in experiments for channel in e.measurement.channels]


def _estimated(channel: Any) -> float:
    """Noise of a channel from itself, never below what its resolution adds."""
    from poppet.series.measured import noise_of

    noise = max(noise_of(channel.values), channel.quantum / np.sqrt(12.0))
    return float(noise) if noise > 0.0 else 1e-6 * max(float(np.ptp(channel.values)), 1e-30)


def _refined(objective: Objective, x: Array, given: Sequence[float | None]) -> list[float]:
    """Noise of the channels that came without, from their residuals."""
    residual, k, refined = objective.residual(x), 0, []
    share = len(objective.free) / max(1, residual.size)
    for channel, sigma, known in zip(_channels(objective.experiments), objective.sigmas, given, strict=True):
        piece = residual[k : k + channel.time.size]
        k += channel.time.size
        refined.append(sigma if known else sigma * float(np.sqrt(np.mean(piece**2) / max(0.1, 1.0 - share))))
    return refined
