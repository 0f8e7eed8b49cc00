"""Tests of a flow path at known strokes, and the values of C and b from each test."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import NumberRange
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_findings import residual_findings, widening_of
from poppet.identify.fit.fit_plan import is_same
from poppet.identify.fit.search import Optimum, optimise
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result
from poppet.timeseries.checks import FloatArray as Array
from poppet.timeseries.checks import not_finite

NUMBERS = ("sonic_conductance", "critical_ratio")
UNITS = {"sonic_conductance": "m^3/(s Pa)", "critical_ratio": "1"}
SYMBOLS = {"sonic_conductance": "C", "critical_ratio": "b"}
POINT_RANGES = {
    **{f"{u}{name}": NumberRange(unit=unit, above=0.0) for name, unit in UNITS.items() for u in ("", "u_")},
    "critical_ratio": NumberRange(unit="1", low=0.0, below=1.0),
    "correlation": NumberRange(unit="1", above=-1.0, below=1.0),
}
"""Limits of the numbers of a `StrokePoint`."""
SENSITIVITY_LIMIT = 1e-2
"""Sensitivity, in sigmas per relative change of 1, below which a test does not determine a parameter."""


@dataclass(frozen=True)
class StrokePoint:
    """Values of C and b of a flow path at one stroke.

    Parameters
    ----------
    stroke : float
        Stroke of the flow path during the test [m].
    sonic_conductance : float
        Sonic conductance C [m^3/(s Pa)].
    critical_ratio : float
        Critical back-pressure ratio b. If the test does not determine b, use NaN and an infinite `u_critical_ratio`.
    u_sonic_conductance : float
        Standard uncertainty of C, without the errors common to all tests [m^3/(s Pa)].
    u_critical_ratio : float
        Standard uncertainty of b.
    correlation : float
        Correlation of the errors of C and b.
    name : str
        Name for messages.
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
    """Recording of a tank that fills or empties through a flow path at a fixed stroke.

    Parameters
    ----------
    stroke : float
        Stroke of the flow path during the test [m].
    circuit : Circuit
        Circuit of the bench, in which the flow path is an orifice with C and b.
    measurement : Measurement
        Recorded pressures, and recorded temperatures if available.
    passage : str
        Name of the flow path in the circuit.
    free : tuple of FreeParameter
        Free parameters of the bench in addition to C and b, such as `tank.wall_conductance`. In a joint fit, each of
        these parameters has the same value in all tests.
    name : str
        Name of the test in messages; the default is the name of the measurement.
    """

    stroke: float
    circuit: BaseCircuit
    measurement: Any
    passage: str = "valve"
    free: tuple[FreeParameter, ...] = ()
    name: str = ""


StrokeTest = StrokePoint | StrokeRecording


@dataclass(frozen=True, eq=False)
class TestEvidence:
    r"""Values of C and b from one test, with their covariance in the form of two residuals.

    The residuals r are a linear function of z = (C, b), and have unit variance. z_0 is the estimate `centre`, R is
    `root`, and r_0 is `pull`.


    .. math:: r(z) = R\,(z - z_0) + r_0
    """

    __test__ = False  # not a test for pytest

    name: str
    stroke: float  # [m]
    centre: Array  # C and b of this test alone, (2,) [m^3/(s Pa), 1]
    root: Array  # upper triangular R, (2, 2), in inverse units of z
    pull: Array  # residuals at the centre, (2,); zero unless C or b is at a bound
    optimum: Optimum | None = None  # optimum of the fit to this test alone
    widening: float = 1.0  # variance factor for residuals that are not white or exceed the noise
    findings: tuple[Note, ...] = ()  # findings on the residuals of the test

    @property
    def nuisance(self) -> tuple[FreeParameter, ...]:
        """Free parameters of the test bench: none, because the fit of each single test accounts for them."""
        return ()

    def evaluate(self, z: Array, nuisance: Array) -> tuple[Array, Array]:
        """Return two residuals and their derivatives, which compare C and b with the values from one test.

        z contains C and b. The residuals have unit variance, and are not correlated. `nuisance` is not used.
        """
        return np.asarray(self.root @ (z - self.centre) + self.pull), self.root

    @property
    def uncertainty(self) -> Array:
        """Standard uncertainties of C and b, (2,).

        The uncertainty of a value that the test does not determine is infinite.
        """
        uncertainty = np.full(2, np.inf)
        scale = np.array([self.centre[0], 1.0])
        is_determined = np.linalg.norm(self.root * scale, axis=0) > SENSITIVITY_LIMIT
        inverse = np.linalg.pinv(self.root[:, is_determined] * scale[is_determined])
        uncertainty[is_determined] = np.linalg.norm(inverse, axis=1) * scale[is_determined]
        return uncertainty

    def decoupled(self) -> TestEvidence:
        """Return a copy in which the errors of C and b are not correlated, with the same standard uncertainties."""
        root = np.diag(1.0 / self.uncertainty)
        return replace(self, root=root, pull=np.zeros(2))


def check_tests(tests: Sequence[StrokeTest], domain: tuple[float, float] | None) -> None:
    """Check the tests of a flow path at several strokes, and raise all errors together.

    `domain` is the range of strokes for the curves [m].
    """
    with ErrorCollector() as errors:
        recordings = [(k, test) for k, test in enumerate(tests) if isinstance(test, StrokeRecording)]
        for (k, first_test), (n, second_test) in itertools.combinations(recordings, 2):
            if is_same(first_test.measurement, second_test.measurement):
                errors.add("stroke.same_twice", test=test_name(second_test, n), other=test_name(first_test, k))
        for k, test in enumerate(tests):
            name = test_name(test, k)
            errors.extend(error.within(f"tests.{name}") for error in not_finite(stroke=test.stroke))
            if domain and math.isfinite(test.stroke) and not domain[0] <= test.stroke <= domain[1]:
                low, high = 1e3 * domain[0], 1e3 * domain[1]
                facts: dict[str, Any] = {"stroke_mm": 1e3 * test.stroke, "low_mm": low, "high_mm": high}
                errors.extend([OutOfRangeError("stroke.outside", test=name, **facts)])
            if isinstance(test, StrokePoint):
                # A test that does not determine b states NaN with an infinite uncertainty.
                is_infinite, is_missing = test.u_critical_ratio == math.inf, math.isnan(test.critical_ratio)
                omitted = {"u_critical_ratio": is_infinite, "critical_ratio": is_infinite and is_missing}
                for key, limits in POINT_RANGES.items():
                    value = float(getattr(test, key))
                    with errors.collecting():
                        if not omitted.get(key):
                            limits.check_range(f"tests.{name}.{key}", value, str(value), key.replace("_", " "))
                continue
            parameters, measurement = test.circuit.numbers(), test.measurement
            if test.passage not in test.circuit.parts:
                near = NameSuggestion(test.passage, test.circuit.parts)
                errors.add("names.unknown", f"tests.{name}.passage", meaning="a part of the circuit", suggestion=near)
            elif any(f"{test.passage}.{number}" not in parameters for number in NUMBERS):
                errors.add("stroke.no_own_numbers", test=name, passage=test.passage)
            floating = [c.address for c in measurement.channels if c.lag is None]
            floating += [i.address for i in measurement.inputs if i.delay is None or i.lag is None]
            floating += [address for address, start_value in measurement.start.items() if start_value == "free"]
            if floating:
                errors.add("stroke.free_sensor", floating[0], test=name)


def determined_values(evidence: Sequence[TestEvidence], index: int) -> Array:
    """Return the values of C or b from all tests that determine them, (3, n).

    The rows are stroke, value and standard uncertainty. `index` is 0 for C and 1 for b.
    """
    rows = [(e.stroke, e.centre[index], e.uncertainty[index]) for e in evidence]
    return np.array([row for row in rows if math.isfinite(row[2])], dtype=float).reshape(-1, 3).T


def test_name(test: StrokeTest, index: int) -> str:
    """Return the name of a test for messages.

    `index` is used if the test has no name.
    """
    name = test.name or (str(test.measurement.name) if isinstance(test, StrokeRecording) else "")
    return name or f"test {index + 1}"


def evaluate_test(test: StrokeTest, name: str) -> TestEvidence:
    """Return the values of C and b from one test, with their covariance.

    If the test is a recording, a separate fit to it gives these values. `name` is the name of the test.
    """
    if isinstance(test, StrokeRecording):
        free = free_parameters(test)
        optimum = optimise([Experiment(test.circuit.instance, test.measurement, free)], free)
        if optimum.interrupted:
            raise KeyboardInterrupt
        findings, weights, n_samples = list[Note](), 0.0, 0
        for channel, sigma in zip(test.measurement.channels, optimum.sigmas, strict=True):
            piece = optimum.residual[n_samples : n_samples + channel.time.size]
            n_samples += channel.time.size
            findings += residual_findings(f"{test.measurement.name}.{channel.address}", piece, sigma, channel.unit)
            weights += widening_of(piece) * channel.time.size
        widening = weights / n_samples
        rows = np.column_stack([optimum.jacobian[:, 2:], optimum.jacobian[:, :2], optimum.residual])
        # QR eliminates the parameters of the bench first: C and b are in the lower right corner.
        corner = np.linalg.qr(rows / math.sqrt(widening))[1][len(free) - 2 : len(free)]
        centre, root, pull = optimum.x[:2].copy(), corner[:, -3:-1], corner[:, -1]
        return TestEvidence(name, test.stroke, centre, root, pull, optimum, widening, tuple(findings))
    u_c, u_b, rho = test.u_sonic_conductance, test.u_critical_ratio, test.correlation
    if math.isinf(u_b):
        centre = np.array([test.sonic_conductance, 0.5])
        return TestEvidence(name, test.stroke, centre, np.diag([1.0 / u_c, 0.0]), np.zeros(2))
    # R^T R is the inverse of the covariance: b alone, then C for a given b.
    given_b = u_c * math.sqrt(1.0 - rho**2)
    root = np.array([[1.0 / given_b, -rho * u_c / (u_b * given_b)], [0.0, 1.0 / u_b]])
    centre = np.array([test.sonic_conductance, test.critical_ratio])
    return TestEvidence(name, test.stroke, centre, root, np.zeros(2))


def free_parameters(test: StrokeRecording) -> tuple[FreeParameter, ...]:
    """Return the free parameters of the fit to one recorded test.

    C and b come first. Free parameters of the test bench, such as a wall conductance, follow.
    """
    return (*(read_free(f"{test.passage}.{number}", {}, test.circuit) for number in NUMBERS), *test.free)


def point_of_result(result: Result, stroke: float, *, part: str = "", name: str = "") -> StrokePoint:
    """Return the C and b of an earlier identification as a test at the stroke `stroke` [m].

    `result` is the result of a tank test or a flow bench. The keyword `part` is the name of the flow path in this
    result. The uncertainties exclude errors that all tests on a bench have in common.
    """
    keys = [f"{part}.{number}" if part else number for number in NUMBERS]
    missing = [key for key in keys if key not in result.parameters]
    if missing:
        addresses = [*result.parameters]
        raise InputError("stroke.not_in_result", missing[0], test=name or result.title, known=addresses)
    conductance, ratio = (result.parameters[key] for key in keys)
    # The independent part of the budget is the only part that differs between tests.
    budget = result.comparison.get("uncertainty", {})
    errors = [float(budget.get(k, {}).get("type_a") or result.parameters[k].standard_error) for k in keys]
    errors[0] = math.sqrt(max(0.0, errors[0] ** 2 - (_ambient_uncertainty(result) * conductance.value) ** 2))
    is_uninformative = ratio.verdict in ("not determined", "at bound") or not math.isfinite(errors[1])
    correlation = float(result.correlation.get(keys[0], {}).get(keys[1], 0.0))
    return StrokePoint(
        stroke,
        conductance.value,
        math.nan if is_uninformative else ratio.value,
        errors[0],
        math.inf if is_uninformative else errors[1],
        0.0 if is_uninformative else max(-0.999, min(0.999, correlation)),
        name,
    )


def common_of_result(result: Result, *, part: str = "") -> tuple[float, float]:
    """Return the standard uncertainties of the errors that all tests on a bench share, of C (relative) and b.

    Their sources are the sensors and an unknown ambient temperature. `result` is the result of a tank test or a flow
    bench. The keyword `part` is the name of the flow path in this result.
    """
    keys = [f"{part}.{number}" if part else number for number in NUMBERS]
    budget = result.comparison.get("uncertainty", {})
    conductance, ratio = (float(budget.get(key, {}).get("type_b", 0.0)) for key in keys)
    value = result.parameters[keys[0]].value if keys[0] in result.parameters else math.nan
    shared = math.hypot(conductance / value if conductance else 0.0, _ambient_uncertainty(result))
    return shared, (ratio if math.isfinite(ratio) else 0.0)


def _ambient_uncertainty(result: Result) -> float:
    """Return the relative uncertainty of C that results from an unknown ambient temperature."""
    facts = [note.facts for note in result.remarks if note.code == "finding.room"]
    return 1e-2 * facts[0]["percent"] * facts[0]["spread"] if facts else 0.0
