"""Tests of a passage at known strokes, and what each of them says about C and b on its own."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_findings import residual_findings, widening_of
from poppet.identify.fit.fit_plan import is_same
from poppet.identify.fit.search import Optimum, optimise
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result
from poppet.timeseries.checks import FloatArray as Array

NUMBERS = ("sonic_conductance", "critical_ratio")
UNITS = {"sonic_conductance": "m^3/(s Pa)", "critical_ratio": "1"}
SYMBOLS = {"sonic_conductance": "C", "critical_ratio": "b"}
SEEN = 1e-2
"""Sigmas per relative change of one below which a test does not see a number at all."""


@dataclass(frozen=True)
class StrokePoint:
    """C and b of a passage at one stroke, extracted before.

    Parameters
    ----------
    stroke : float
        At which the passage was held [m].
    sonic_conductance : float
        C [m^3/(s Pa)].
    critical_ratio : float
        b; not-a-number where the test does not determine it (then `u_critical_ratio` is infinite).
    u_sonic_conductance : float
        Standard uncertainty of C, without what is common to all tests [m^3/(s Pa)].
    u_critical_ratio : float
        Standard uncertainty of b.
    correlation : float
        Of the errors of C and b in this test.
    name : str
        For messages.
    """

    stroke: float
    sonic_conductance: float
    critical_ratio: float
    u_sonic_conductance: float
    u_critical_ratio: float
    correlation: float = 0.0
    name: str = ""


@dataclass(frozen=True, eq=False)
class StrokeRecording:
    """One recording of a tank that fills or empties through the passage held at one stroke.

    Parameters
    ----------
    stroke : float
        At which the passage was held [m].
    circuit : Circuit
        The bench; the passage is an orifice with C and b.
    measurement : Measurement
        Recorded pressures, and temperatures where there are.
    passage : str
        Name of the passage in the circuit.
    free : tuple of Free
        Further free numbers of the bench, `tank.wall_conductance`; one joint fit shares them among all tests.
    name : str
        For messages; the name of the measurement when empty.
    """

    stroke: float
    circuit: Circuit
    measurement: Any
    passage: str = "valve"
    free: tuple[FreeParameter, ...] = ()
    name: str = ""


StrokeTest = StrokePoint | StrokeRecording


@dataclass(frozen=True, eq=False)
class TestEvidence:
    r"""What one test says about z = (C, b), as two residuals of unit variance.

    .. math:: r(z) = R\,(z - z_0) + r_0
    """

    __test__ = False  # no test of pytest

    name: str
    stroke: float  # [m]
    centre: Array  # C and b of the test on its own, (2,) [m^3/(s Pa), 1]
    root: Array  # upper triangular R, (2, 2), in inverse units of z
    pull: Array  # residuals left at the centre, (2,); zero unless a bound keeps it there
    optimum: Optimum | None = None  # of the fit of this test alone
    widening: float = 1.0  # factor on its variances, as its residuals are not white or larger than the noise
    findings: tuple[Note, ...] = ()  # about its residuals

    @property
    def nuisance(self) -> tuple[FreeParameter, ...]:
        """Free numbers of the bench: none, they are eliminated already."""
        return ()

    def evaluate(self, z: Array, nuisance: Array) -> tuple[Array, Array]:
        """Two residuals of unit variance at C, b, and their slopes."""
        return np.asarray(self.root @ (z - self.centre) + self.pull), self.root

    @property
    def uncertainty(self) -> Array:
        """Standard uncertainties of C and b, infinite where the test says nothing."""
        found = np.full(2, np.inf)
        scale = np.array([self.centre[0], 1.0])
        seen = np.linalg.norm(self.root * scale, axis=0) > SEEN
        inverse = np.linalg.pinv(self.root[:, seen] * scale[seen])
        found[seen] = np.linalg.norm(inverse, axis=1) * scale[seen]
        return found

    def decoupled(self) -> TestEvidence:
        """The same C and b with the same uncertainties, their correlation left out of account."""
        root = np.diag(1.0 / self.uncertainty)
        return replace(self, root=root, pull=np.zeros(2))

    @property
    def samples(self) -> int:
        """Number of numbers the test determines: C and b, or C alone."""
        return int(np.isfinite(self.uncertainty).sum())


def check_tests(tests: Sequence[StrokeTest], domain: tuple[float, float] | None) -> None:
    """Refuse tests that cannot be, all mistakes at once."""
    with ErrorCollector() as errors:
        recordings = [(k, test) for k, test in enumerate(tests) if isinstance(test, StrokeRecording)]
        for (k, one), (n, other) in itertools.combinations(recordings, 2):
            if is_same(one.measurement, other.measurement):
                errors.add("stroke.same_twice", test=name_of(other, n), other=name_of(one, k))
        for k, test in enumerate(tests):
            name = name_of(test, k)
            if not math.isfinite(test.stroke):
                errors.add("stroke.not_finite", test=name, value=test.stroke)
            elif domain and not domain[0] <= test.stroke <= domain[1]:
                low, high = 1e3 * domain[0], 1e3 * domain[1]
                facts: dict[str, Any] = {"stroke_mm": 1e3 * test.stroke, "low_mm": low, "high_mm": high}
                errors.extend([OutOfRangeError("stroke.outside", test=name, **facts)])
            if isinstance(test, StrokePoint):
                errors.extend(_point_problems(test, name))
            else:
                _check_recording(errors, test, name)


def seen(evidence: Sequence[TestEvidence], which: int) -> Array:
    """Strokes, values and standard uncertainties, (3, n), of the tests that say something of C (0) or b (1)."""
    rows = [(e.stroke, e.centre[which], e.uncertainty[which]) for e in evidence]
    return np.array([row for row in rows if math.isfinite(row[2])], dtype=float).reshape(-1, 3).T


def name_of(test: StrokeTest, place: int) -> str:
    """Name of a test for messages."""
    own = test.name or (str(test.measurement.name) if isinstance(test, StrokeRecording) else "")
    return own or f"test {place + 1}"


def _point_problems(point: StrokePoint, name: str) -> list[InputError]:
    blind = math.isinf(point.u_critical_ratio) and math.isnan(point.critical_ratio)
    checks = (
        ("sonic_conductance", 0.0 < point.sonic_conductance < math.inf),
        ("critical_ratio", blind or 0.0 <= point.critical_ratio < 1.0),
        ("u_sonic_conductance", 0.0 < point.u_sonic_conductance < math.inf),
        ("u_critical_ratio", point.u_critical_ratio > 0.0),
        ("correlation", abs(point.correlation) < 1.0),
    )
    wrong = [key for key, holds in checks if not holds]
    return [OutOfRangeError(f"stroke.{key}", test=name, value=getattr(point, key)) for key in wrong]


def _check_recording(errors: ErrorCollector, test: StrokeRecording, name: str) -> None:
    numbers = test.circuit.numbers()
    if test.passage not in test.circuit.parts:
        errors.add("stroke.unknown_passage", test=name, passage=test.passage, known=[*test.circuit.parts])
    elif any(f"{test.passage}.{number}" not in numbers for number in NUMBERS):
        errors.add("stroke.no_own_numbers", test=name, passage=test.passage)
    floating = [c.address for c in test.measurement.channels if c.lag is None]
    floating += [i.address for i in test.measurement.inputs if i.delay is None or i.lag is None]
    floating += [address for address, given in test.measurement.start.items() if given == "free"]
    if floating:
        errors.add("stroke.free_sensor", floating[0], test=name)


def evidence_of(test: StrokeTest, name: str) -> TestEvidence:
    """What a test says about C and b; a recording is fitted on its own for it."""
    if isinstance(test, StrokeRecording):
        return _of_recording(test, name)
    u_c, u_b, rho = test.u_sonic_conductance, test.u_critical_ratio, test.correlation
    if math.isinf(u_b):
        centre = np.array([test.sonic_conductance, 0.5])
        return TestEvidence(name, test.stroke, centre, np.diag([1.0 / u_c, 0.0]), np.zeros(2))
    # R with R^T R the inverse of the covariance: b on its own, then C given b.
    given_b = u_c * math.sqrt(1.0 - rho**2)
    root = np.array([[1.0 / given_b, -rho * u_c / (u_b * given_b)], [0.0, 1.0 / u_b]])
    centre = np.array([test.sonic_conductance, test.critical_ratio])
    return TestEvidence(name, test.stroke, centre, root, np.zeros(2))


def own_free(test: StrokeRecording) -> tuple[FreeParameter, ...]:
    """Free numbers of a recording on its own: C, b, then those of the bench."""
    return (*(read_free(f"{test.passage}.{number}", {}, test.circuit) for number in NUMBERS), *test.free)


def _of_recording(test: StrokeRecording, name: str) -> TestEvidence:
    free = own_free(test)
    optimum = optimise([Experiment(test.circuit.instance, test.measurement, free)], free)
    if optimum.interrupted:
        raise KeyboardInterrupt
    remarks, widening = _judged(test, optimum)
    rows = np.column_stack([optimum.jacobian[:, 2:], optimum.jacobian[:, :2], optimum.residual]) / math.sqrt(widening)
    # Eliminating the nuisance numbers first leaves C and b in the lower right corner.
    corner = np.linalg.qr(rows)[1][len(free) - 2 : len(free)]
    return TestEvidence(
        name, test.stroke, optimum.x[:2].copy(), corner[:, -3:-1], corner[:, -1], optimum, widening, tuple(remarks)
    )


def _judged(test: StrokeRecording, optimum: Optimum) -> tuple[list[Note], float]:
    """Findings on the residuals of a test, and the mean factor on its variances."""
    remarks: list[Note] = []
    weights, place = 0.0, 0
    for channel, sigma in zip(test.measurement.channels, optimum.sigmas, strict=True):
        piece = optimum.residual[place : place + channel.time.size]
        place += channel.time.size
        remarks += residual_findings(f"{test.measurement.name}.{channel.address}", piece, sigma, channel.unit)
        weights += widening_of(piece) * channel.time.size
    return remarks, weights / place


def point_of_result(result: Result, stroke: float, *, part: str = "", name: str = "") -> StrokePoint:
    """C and b at a stroke from the result of an identification, of a tank or a flow bench."""
    keys = [f"{part}.{number}" if part else number for number in NUMBERS]
    missing = [key for key in keys if key not in result.parameters]
    if missing:
        known = [*result.parameters]
        raise InputError("stroke.not_in_result", missing[0], test=name or result.title, known=known)
    conductance, ratio = (result.parameters[key] for key in keys)
    # A budget says which part is not common to all points of the bench: only that scatters from test to test.
    budget = result.comparison.get("uncertainty", {})
    errors = [float(budget.get(k, {}).get("type_a") or result.parameters[k].standard_error) for k in keys]
    errors[0] = math.sqrt(max(0.0, errors[0] ** 2 - (_room(result) * conductance.value) ** 2))
    blind = ratio.verdict in ("not determined", "at bound") or not math.isfinite(errors[1])
    correlation = float(result.correlation.get(keys[0], {}).get(keys[1], 0.0))
    return StrokePoint(
        stroke,
        conductance.value,
        math.nan if blind else ratio.value,
        errors[0],
        math.inf if blind else errors[1],
        0.0 if blind else max(-0.999, min(0.999, correlation)),
        name,
    )


def common_of_result(result: Result, *, part: str = "") -> tuple[float, float]:
    """Uncertainty that a result shares with all others of the same bench: gauges, and an unknown room."""
    keys = [f"{part}.{number}" if part else number for number in NUMBERS]
    budget = result.comparison.get("uncertainty", {})
    conductance, ratio = (float(budget.get(key, {}).get("type_b", 0.0)) for key in keys)
    value = result.parameters[keys[0]].value if keys[0] in result.parameters else math.nan
    shared = math.hypot(conductance / value if conductance else 0.0, _room(result))
    return shared, (ratio if math.isfinite(ratio) else 0.0)


def _room(result: Result) -> float:
    """Relative standard uncertainty of C by a room whose temperature a tank test does not know."""
    found = [note.facts for note in result.remarks if note.code == "finding.room"]
    return 1e-2 * found[0]["percent"] * found[0]["spread"] if found else 0.0
