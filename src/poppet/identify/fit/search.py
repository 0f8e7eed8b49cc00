"""Grey-box fit: free numbers of a circuit from recordings, by weighted least squares on the integrated equations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, NameSuggestion, collect
from poppet.identify.fit.experiment import FAILED, SAMPLED_DIFFERENCE, Experiment, channels_of
from poppet.identify.fit.losses import LOSSES, costs_of, curvatures_of, weights_of
from poppet.identify.fit.whiteness import whiteness
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.least_squares import LocalModel, condensed, search
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, noise_of

ROUNDS = 12
"""Rounds of weighing: where no noise is given, the residuals of a round say how large it is in the next."""
KICKS = 3
"""Most rounds of trying to leave a false minimum, where nothing is said."""
SUSPICIOUS = 0.05
"""Probability of white residuals below which other places are tried; a false alarm costs time only."""
JOINED = 0.1
"""Part of a sigma, and of the cost, within which a search has come to where another one ended."""
INEXACT = 1e-5
"""Part of the slopes that is not right, as differences have it."""
WIDTHS = (SAMPLED_DIFFERENCE, 0.02, 0.002)
"""Relative widths of the differences where a program samples: the residuals are smooth in the numbers on the whole and
broken in small pieces. Fits of a complete valve came within 1 % of the truth with the first and stayed 10 % away from
it with the last; fits of a loop with a steep gain did it the other way round."""


Places = NDArray[np.int64] | slice


@dataclass(frozen=True)
class SearchSettings:
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
        problems = []
        if self.loss not in LOSSES:
            problems.append(
                InputError(
                    "fields.not_an_option",
                    "loss",
                    value=self.loss,
                    meaning="loss function",
                    near=NameSuggestion(str(self.loss), LOSSES),
                )
            )
        for name, low, high in (("starts", 1, 1000), ("seed", 0, 2**63 - 1), ("kicks", 0, 1000)):
            value = getattr(self, name)
            is_whole = isinstance(value, int) and not isinstance(value, bool)
            if not ((is_whole and low <= value <= high) or (name == "kicks" and value is None)):
                problems.append(InputError(f"search.{name}", name, value=value))
        collect(problems)


class KnownOptimum(NamedTuple):
    """Where another search over the same residuals has ended."""

    x: FloatArray
    errors: FloatArray  # one sigma of each number, infinite where it is not felt
    cost: float

    def holds(self, x: FloatArray, cost: float) -> bool:
        """Whether a search at x goes down to this place: within a tenth of a sigma, where the cost shows no other."""
        near = np.abs(x - self.x) <= JOINED * np.where(np.isfinite(self.errors), self.errors, np.inf)
        return bool(np.all(near)) and abs(cost - self.cost) <= JOINED


class _JoinedError(Exception):
    """A search has come to a place where another one has ended."""


@dataclass
class Optimum:
    """Where a search ended; priors stand behind the samples."""

    x: FloatArray  # values of the free numbers, (n_free,), SI
    cost: float  # half the sum of squares, in sigmas
    jacobian: FloatArray  # derivatives of the weighted residuals, (n_samples, n_free), in SI units of the numbers
    residual: FloatArray  # weighted residuals, (n_samples,)
    sigmas: list[float]  # noise of each channel, in the order of experiments and channels
    active: NDArray[np.int64]  # -1 at the lower bound, 1 at the upper, 0 between, (n_free,)
    interrupted: bool = False  # by the user
    evaluations: int = 0  # runs of the search, slopes included
    name: str = "given"  # of the place where its search began
    begin: FloatArray = field(default_factory=lambda: np.zeros(0))  # that place
    held: Mapping[str, float] = field(default_factory=dict)  # numbers that were held there
    excess: float = 0.0  # by how much the data speak for the lowest optimum, as a difference of cost
    limit: float = np.inf  # of the excess, up to which 95 % of the truth lies
    others: tuple[Optimum, ...] = ()  # places that the data cannot tell from this one
    searches: tuple[Optimum, ...] = ()  # all that were made over the first weights, in their order


@dataclass
class Objective:
    """Weighted residuals of all experiments, priors last, as a function of the free numbers."""

    experiments: Sequence[Experiment]
    free: tuple[FreeParameter, ...]  # in the order of x
    sigmas: list[float]  # noise of each channel
    progress: Callable[[int, float], Any] | None = None  # told the number of evaluations and the least cost
    evaluations: int = 0
    held: Mapping[str, float] = field(default_factory=dict)  # free numbers held at a value, for profiles and trials
    known: Sequence[KnownOptimum] = ()
    # Least cost so far, and where it was found: what an interrupt keeps.
    best: tuple[float, FloatArray] = field(default_factory=lambda: (np.inf, np.zeros(0)))
    _told: tuple[bytes, FloatArray, float] = (
        b"",
        np.zeros(0),
        np.inf,
    )  # the last place, its residuals, half their squares
    _slopes: tuple[tuple[bytes, float], FloatArray] = ((b"", 0.0), np.zeros((0, 0)))  # with their place and width

    def __post_init__(self) -> None:
        self.channels = channels_of(self.experiments)
        self._measured = np.concatenate([each.channel.values for each in self.channels])
        sizes = [each.channel.values.size for each in self.channels]
        self._weights = 1.0 / np.repeat(self.sigmas, sizes)
        self._priors = [(k, f.prior) for k, f in enumerate(self.free) if f.prior]

    def searched(self) -> NDArray[np.int64]:
        """Places of the numbers that are not held."""
        return np.array([k for k, f in enumerate(self.free) if f.name not in self.held], dtype=np.int64)

    def cost(self, x: FloatArray, loss: str = "linear") -> float:
        """Half the sum of squares, or what a robust loss makes of it."""
        residual = self.residual(x)
        return self._told[2] if loss == "linear" else float(np.sum(costs_of(residual, loss)))

    def residual(self, x: FloatArray) -> FloatArray:
        """Weighted residuals."""
        key = x.tobytes()
        if self._told[0] != key:
            values = by_name(self.free, x)
            model = np.concatenate([series for e in self.experiments for series in e.outputs(values)])
            residual = (model - self._measured) * self._weights
            if self._priors:
                residual = np.append(residual, [(x[k] - prior.mean) / prior.sd for k, prior in self._priors])
            cost = 0.5 * float(residual @ residual)
            if not cost < np.inf:
                residual[~np.isfinite(residual)] = FAILED
                cost = 0.5 * float(residual @ residual)
            self._told = key, residual, cost
            self.evaluations += 1
            if cost < self.best[0]:
                self.best = cost, x.copy()
            if self.progress:
                self.progress(self.evaluations, self.best[0])
        return self._told[1]

    def residual_and_jacobian(self, x: FloatArray, width: float = SAMPLED_DIFFERENCE) -> tuple[FloatArray, FloatArray]:
        """Both, from runs over one step sequence; `width` is that of the differences where a program samples."""
        residual = self.residual(x)
        return residual, self._beside(x, width)[:, :-1]

    def seen(self, x: FloatArray, width: float, loss: str, places: Places) -> LocalModel:
        """Slopes and residuals as a search over some of the numbers sees them."""
        both, residual = self._beside(x, width), self.residual(x)
        both[:, -1] = residual
        if loss == "linear":
            triangle, force = condensed(both), residual
        else:
            force, root = residual * weights_of(residual, loss), np.sqrt(curvatures_of(residual, loss))
            rows = both * root[:, np.newaxis]
            rows[:, -1] = force / root
            triangle = condensed(rows)
        return LocalModel(triangle[:, places], triangle[:, -1], both[:, places], force)

    def _beside(self, x: FloatArray, width: float) -> FloatArray:
        """Slopes of the weighted residuals, and room for one more column."""
        key = x.tobytes(), width
        if self._slopes[0] != key:
            values, places = by_name(self.free, x), {f.name: k for k, f in enumerate(self.free)}
            # Columns are written and read whole.
            both = np.zeros((self._measured.size + len(self._priors), x.size + 1), order="F")
            for row, (k, prior) in enumerate(self._priors, start=self._measured.size):
                both[row, k] = 1.0 / prior.sd
            row = 0
            for experiment in self.experiments:
                columns = [places[f.name] for f in experiment.free]
                for own in experiment.slopes(values, width):
                    rows = slice(row, row + len(own))
                    if columns == list(range(x.size)):
                        np.multiply(own, self._weights[rows, np.newaxis], out=both[rows, :-1])
                    else:
                        both[rows, columns] = own * self._weights[rows, np.newaxis]
                    row = rows.stop
            entries = both.ravel(order="K")
            if not entries @ entries < np.inf:
                both[~np.isfinite(both)] = 0.0
            self._slopes = key, both
        return self._slopes[1]


def kick_rounds(settings: SearchSettings, experiments: Sequence[Experiment]) -> int:
    """Most rounds of trying to leave a false minimum, as given or as the circuits ask for."""
    if settings.kicks is not None:
        return settings.kicks
    return 0 if any(each.samples for each in experiments) else KICKS


def optimise(
    experiments: Sequence[Experiment],
    free: tuple[FreeParameter, ...],
    settings: SearchSettings | None = None,
    *,
    progress: Callable[[int, float], Any] | None = None,
    sigmas: list[float] | None = None,
    held: Mapping[str, float] | None = None,
    begin: FloatArray | None = None,
    known: Sequence[KnownOptimum] = (),
) -> Optimum:
    """Find the free numbers that explain the recordings best, from their starts or from `begin`.

    `sigmas` are those of an earlier search; one that comes to a `known` place ends there.
    """
    settings = settings or SearchSettings()
    given = [each.channel.noise for each in channels_of(experiments)]
    weights = sigmas or first_weights(experiments)
    held = held or {}
    objective = Objective(experiments, free, list(weights), progress, held=held, known=known)
    begun = [f.start for f in free] if begin is None else begin
    x = np.array([held.get(f.name, v) for f, v in zip(free, begun, strict=True)])
    interrupted = False
    try:
        x = _local(objective, x, settings)[0]
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


def elsewhere(free: tuple[FreeParameter, ...], generator: np.random.Generator) -> FloatArray:
    """A random place: within finite bounds, else within a factor of ten of the start."""
    place = []
    for f in free:
        if np.isfinite(f.low) and np.isfinite(f.high) and f.low <= 0.0:
            place.append(generator.uniform(f.low, f.high) if f.high - f.low <= 100.0 * f.scale else f.start)
        else:
            place.append(np.clip(f.start * 10.0 ** generator.uniform(-1.0, 1.0), f.low, f.high))
    return np.array(place)


def _kicked(objective: Objective, x: FloatArray, settings: SearchSettings) -> FloatArray:
    """Leave a false minimum: while the residuals are not white, try other places.

    Conductance and wall heat trade against each other, so that a discharge has a second, wrong minimum near the
    isothermal or the adiabatic limit; a misfit that is not noise gives it away.
    """
    most = kick_rounds(settings, objective.experiments)
    if most == 0:
        return x
    cost, is_white = objective.cost(x), not _is_suspicious(objective, x)
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


def _kicks(objective: Objective, x: FloatArray) -> Iterator[FloatArray]:
    """Places to try: each number moved from where the search ended, and from where it began."""
    begin = np.array([objective.held.get(f.name, f.start) for f in objective.free])
    for k in objective.searched():
        f = objective.free[k]
        for base, factor in ((x, 10.0), (x, 0.1), (begin, 10.0), (begin, 0.1), (begin, 1e-3)):
            moved = base.copy()
            moved[k] = np.clip((base[k] or 0.1 * f.scale) * factor, f.low, f.high)
            yield moved


def _is_suspicious(objective: Objective, x: FloatArray) -> bool:
    """True when the residuals of a channel are not white."""
    residual = objective.residual(x)
    return any(whiteness(residual[each.rows]) < SUSPICIOUS for each in objective.channels)


def _local(objective: Objective, x: FloatArray, settings: SearchSettings) -> tuple[FloatArray, float]:
    """The best of searches downhill from x: one, or several where a program samples.

    Which width of differences sees the slope and not the pieces depends on the circuit, and a search may end in a
    piece: all are tried, from x and again from the best place found.
    """
    if not any(each.samples for each in objective.experiments):
        return _downhill(objective, x, settings, SAMPLED_DIFFERENCE)
    best, cost = x, np.inf
    for begins_again in (False, True):
        begin = best if begins_again else x
        for width in WIDTHS:
            place, found = _downhill(objective, begin, settings, width)
            if found < cost:
                best, cost = place, found
    return best, cost


def _downhill(objective: Objective, x: FloatArray, settings: SearchSettings, width: float) -> tuple[FloatArray, float]:
    """One search from x."""
    places = objective.searched()
    if places.size == 0:
        return x, objective.cost(x)
    units, low, high = np.array([(f.scale, f.low, f.high) for f in objective.free])[places].T
    # A view where none is held.
    own = slice(places.size) if places.size == x.size else places
    joined: KnownOptimum | None = None

    def whole(some: FloatArray) -> FloatArray:
        full = x.copy()
        full[places] = some
        return full

    def cost(some: FloatArray) -> float:
        return objective.cost(whole(some), settings.loss)

    def look(some: FloatArray) -> LocalModel:
        nonlocal joined
        full = whole(some)
        joined = next((known for known in objective.known if known.holds(full, objective.cost(full))), None)
        if joined is not None:
            raise _JoinedError
        return objective.seen(full, width, settings.loss, own)

    try:
        found = search(cost, look, x[places], low, high, units, inexact=INEXACT)
    except _JoinedError:
        assert joined is not None
        return joined.x, joined.cost
    return whole(found.x), found.cost


def first_weights(experiments: Sequence[Experiment]) -> list[float]:
    """Noise of every channel, as it was given or as the channel itself shows it."""
    return [each.channel.noise or _estimated(each.channel) for each in channels_of(experiments)]


def _active(free: tuple[FreeParameter, ...], x: FloatArray) -> NDArray[np.int64]:
    low, high, scale = np.array([(f.low, f.high, f.scale) for f in free]).reshape(-1, 3).T
    return np.where(x <= low + 1e-6 * scale, -1, np.where(x >= high - 1e-6 * scale, 1, 0))


def _estimated(channel: Channel) -> float:
    """Noise of a channel from itself, never below what its resolution adds."""
    noise = max(noise_of(channel.values), channel.quantum / np.sqrt(12.0))
    return float(noise) if noise > 0.0 else 1e-6 * max(float(np.ptp(channel.values)), 1e-30)


def _refined(objective: Objective, x: FloatArray, given: Sequence[float | None]) -> list[float]:
    """Noise of the channels that came without, from their residuals."""
    residual = objective.residual(x)
    # Every free number takes its part of the noise away.
    left = max(0.1, 1.0 - len(objective.free) / max(1, residual.size))
    return [
        sigma if known else sigma * float(np.sqrt(np.mean(residual[each.rows] ** 2) / left))
        for each, sigma, known in zip(objective.channels, objective.sigmas, given, strict=True)
    ]
