"""The sampled linear model against the full one: frequency, damping and response of small motions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

from poppet import Circuit
from poppet.bench.sine_rig import SineRig, without_bands
from poppet.circuit.linear_model import LinearModel, SteadyState
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sampled_model import SampledModel, sampled_model
from poppet.engine.problem import Problem, constant_coefficients
from poppet.engine.solve import solve
from poppet.parts import Chamber, Orifice, ProportionalValve, Reservoir
from poppet.signals import Constant

SMOOTH = {
    "valve.electronics.inner.hold_band": 0.0, "valve.electronics.inner.minimum_duty": 0.0,
    "valve.electronics.outer.dead_band": 0.0, "valve.electronics.outer.integral_band": 0.0,
    "valve.electronics.outer.integral_limit": 0.0, "valve.electronics.outer.correction_limit": 0.0,
    "valve.electronics.converter.bits": 0.0,
    "valve.pilot.fill.opening_delay": 0.0, "valve.pilot.fill.closing_delay": 0.0,
    "valve.pilot.vent.opening_delay": 0.0, "valve.pilot.vent.closing_delay": 0.0,
}  # fmt: skip
SETPOINT, OUTLET = "valve.setpoint", "tank.pressure"
SCANNED = 13  # number of amplitudes before the bisection
BISECTIONS = 6


def circuit(volume: str = "1 l", **changes) -> Circuit:
    """A valve that feeds a consumer, with so much pilot leak that the rest lies far on the filling side."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l"),
        "tank": Chamber(volume=volume, wall_conductance=1.0, initial_pressure="4 bar"),
        "load": Orifice(from_="tank", to="ambient", sonic_conductance=2e-9, critical_ratio=0.3),
    }
    whole = Circuit(parts, {SETPOINT: Constant(4e5)})
    leak = {"valve.pilot.exhaust_leak.sonic_conductance": 2e-11}
    return whole.with_values(SMOOTH | leak | changes)


CASES = {
    "hunting": circuit("0.3 l"),
    "small": circuit("0.3 l", **{"valve.main_stage.damping": 30.0}),
    "medium": circuit("1 l"),
    "large": circuit("10 l"),
    "two clocks": circuit(
        "1 l", **{"valve.electronics.outer.sample_time": 3e-3, "valve.electronics.inner.sample_time": 2e-3}
    ),
    "derivative": circuit("1 l", **{"valve.electronics.outer.derivative_time": 2e-3}),
}


CALM = [name for name in CASES if name != "hunting"]


@cache
def at_rest(name: str) -> tuple[SteadyState, SampledModel]:
    """Rest and linear model; a valve that hunts takes many seconds to be found."""
    rest = CASES[name].steady_state()
    return rest, sampled_model(CASES[name].instance, rest)


@pytest.mark.parametrize("name", CALM)
def test_rest_is_where_the_full_model_stays(name):
    """A run from the rest keeps every output to rounding."""
    case = CASES[name]
    rest, _ = at_rest(name)
    rig = SineRig(case.instance, SETPOINT, OUTLET, rest)
    run = rig.run(0.0, 1.0, np.linspace(0.0, 2.0, 201))
    size = {"Pa": 1.0, "m": 1e-7, "1": 1e-4, "kg": 1e-8, "kg/s": 1e-7, "K": 1e-3, "m/s": 1e-6, "m^3": 1e-9, "W": 1e-6}
    for k, (name, unit) in enumerate(case.model.outputs):
        assert np.max(np.abs(run.values[k] - rest.y[name])) < size[unit], name


def motion(name: str, pole: complex, count: int) -> np.ndarray:
    """Outlet pressure at the samples after a small push along one mode of the linear model, from the full model."""
    rest, model = at_rest(name)
    point = SampledPoint(CASES[name].instance, model.u)
    values, vectors = np.linalg.eig(model.A * model.sizes[None, :] / model.sizes[:, None])
    mode = vectors[:, np.argmin(np.abs(np.log(np.where(values == 0.0, 1e-30, values)) / model.sample_time - pole))].real
    v = model.x + 1e-5 * mode / np.max(np.abs(mode)) * model.sizes
    x0, p = point.at_clock(v)
    begin = point.clock.start
    held = constant_coefficients(np.array(list(rest.u.values())), begin)
    grid = model.sample_time * np.arange(count)
    grid[1:] += 1e-9  # just after the instants
    once = np.array([begin]), np.zeros(1, dtype=np.int64)
    run = solve(Problem(point.kernel, p, x0, *once, held, np.zeros(1, dtype=bool), begin + grid, 1e-10))
    place = model.outputs.index(OUTLET)
    return run.values[place] - rest.y[OUTLET]


@pytest.mark.parametrize("name", CALM)
def test_frequency_and_damping_are_those_of_the_full_model(name):
    """A mode that is pushed obeys y(k+2) = 2 Re(z) y(k+1) - |z|^2 y(k)."""
    _, model = at_rest(name)
    # What has all but gone after a sample has no frequency to be seen.
    modes = [pole for pole in model.poles() if pole.imag > 0.0 and np.exp(pole.real * model.sample_time) > 0.1]
    assert len(modes) >= 2
    for pole in modes:
        y = motion(name, pole, 12)
        rows = np.column_stack([y[1:-1], y[:-2]])
        a, b = np.linalg.lstsq(rows, y[2:], rcond=None)[0]
        found = np.log(np.roots([1.0, -a, -b]).astype(complex)) / model.sample_time
        found = found[np.argmax(found.imag)]
        assert abs(found) == pytest.approx(abs(pole), rel=0.02)
        assert -found.real / abs(found) == pytest.approx(-pole.real / abs(pole), rel=0.02)


@pytest.mark.parametrize("name", CALM)
def test_frequency_response_is_that_of_the_full_model(name):
    case = CASES[name]
    rest, model = at_rest(name)
    for output in (OUTLET, "valve.fill_duty", "valve.pilot_setpoint"):
        rig = SineRig(case.instance, SETPOINT, output, rest)
        for frequency in (2.0, 17.0, 60.0, 130.0):
            full = rig.response(10.0, frequency, rows=400).gain
            linear = model.frequency_response(frequency, SETPOINT, output)[0]
            assert abs(full - linear) <= 0.01 * abs(linear), (output, frequency, full, linear)


def test_response_to_an_input_that_acts_between_the_instants():
    """The supply pressure moves on while the memory is held."""
    case = CASES["two clocks"]
    rest, model = at_rest("two clocks")
    rig = SineRig(case.instance, "supply.pressure", OUTLET, rest)
    for frequency in (5.0, 40.0, 110.0):
        full = rig.response(20.0, frequency).gain
        linear = model.frequency_response(frequency, "supply.pressure", OUTLET)[0]
        assert abs(full - linear) <= 0.01 * abs(linear)


def test_hum_of_a_small_tank_grows_as_the_linear_model_says():
    """Unstable: the push grows at the rate and with the frequency of the unstable pole, then a limit cycle stays."""
    rest, model = at_rest("hunting")
    assert not rest.is_stable
    assert rest.found[-1].code == "rest.unstable"
    pole = max(model.poles(), key=lambda s: s.real)
    assert pole.real > 100.0
    y = motion("hunting", pole, 12)
    a, b = np.linalg.lstsq(np.column_stack([y[1:-1], y[:-2]]), y[2:], rcond=None)[0]
    found = np.log(np.roots([1.0, -a, -b]).astype(complex)) / model.sample_time
    assert np.max(found.real) == pytest.approx(pole.real, rel=0.02)
    assert np.max(found.imag) == pytest.approx(abs(pole.imag), rel=0.02)


@dataclass(frozen=True)
class Agreement:
    """Range of amplitudes in which the nonlinear model behaves like the linear model."""

    # Limits of the input amplitudes for which the models agree, in the unit of the input. `low` is 0 if they agree for
    # the smallest tested amplitude, `high` is infinite if they agree for the largest; both are NaN without agreement.
    low: float
    high: float
    frequency: float  # frequency of the sine [Hz]
    tolerance: float  # largest permitted difference of the complex gains, relative to the linear model
    amplitudes: tuple[float, ...]  # tested amplitudes of the input
    differences: tuple[float, ...]  # relative difference of the gains at each tested amplitude


def find_agreement(
    rig: SineRig, linear: LinearModel, frequency: float, amplitudes: tuple[float, float], *, tolerance: float = 0.1
) -> Agreement:
    """Find the range of amplitudes in which a circuit behaves like its linear model.

    `amplitudes` are the limits of the search, and `tolerance` is the largest permitted difference of the complex gains,
    relative to the linear model.
    """
    model = rig.kernel.model
    names = model.inputs[rig.input].name, model.columns[0][rig.output]
    expected = complex(linear.frequency_response(frequency, *names)[0])

    def difference(amplitude: float) -> float:
        return float(abs(rig.response(amplitude, frequency).gain - expected) / abs(expected))

    candidates = np.geomspace(*amplitudes, SCANNED)
    differences = np.array([difference(a) for a in candidates])
    low = high = np.nan
    # Start and end index of every range of consecutive amplitudes that agree.
    edges = np.flatnonzero(np.diff(np.concatenate([[0], (differences <= tolerance).astype(int), [0]])))
    if edges.size:
        first, end = max(zip(edges[::2], edges[1::2], strict=True), key=lambda run: run[1] - run[0])
        low = 0.0 if first == 0 else _end_of_agreement(difference, candidates[first], candidates[first - 1], tolerance)
        high = (
            np.inf if end == SCANNED else _end_of_agreement(difference, candidates[end - 1], candidates[end], tolerance)
        )
    return Agreement(low, high, frequency, tolerance, tuple(candidates.tolist()), tuple(differences.tolist()))


def _end_of_agreement(difference: Callable[[float], float], inside: float, outside: float, tolerance: float) -> float:
    """Return the amplitude at which the agreement with the linear model ends.

    `difference` returns the deviation from the linear model at an amplitude. The bisection starts between the amplitude
    `inside`, which agrees, and `outside`, which does not.
    """
    for _ in range(BISECTIONS):
        middle = float(np.sqrt(inside * outside))
        inside, outside = (middle, outside) if difference(middle) <= tolerance else (inside, middle)
    return inside


def test_bands_set_a_least_amplitude_and_saturation_a_greatest():
    """Without bands the models agree down to nothing; with bands they part below an amplitude that is found."""
    smooth = CASES["medium"]
    default = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l").numbers()
    bands = {name: default[name.partition(".")[2]] for name in SMOOTH}
    rough = smooth.with_values(bands)
    assert {name: n.value for name, n in without_bands(rough).numbers().items()} == {
        name: n.value for name, n in smooth.numbers().items()
    }
    linear = at_rest("medium")[1]
    free = find_agreement(SineRig(smooth.instance, SETPOINT, OUTLET), linear, 5.0, (10.0, 1e5), tolerance=0.25)
    assert free.low == 0.0
    assert 3e3 < free.high < 1e5
    banded = find_agreement(SineRig(rough.instance, SETPOINT, OUTLET), linear, 5.0, (10.0, 1e5), tolerance=0.25)
    assert 1e3 < banded.low < 1e4 < banded.high < 1e5
    below = [each for a, each in zip(banded.amplitudes, banded.differences, strict=True) if 20.0 < a < 0.5 * banded.low]
    assert min(below) > 0.25
    inside = SineRig(rough.instance, SETPOINT, OUTLET).response(float(np.sqrt(banded.low * banded.high)), 5.0).gain
    assert inside == pytest.approx(complex(linear.frequency_response(5.0, SETPOINT, OUTLET)[0]), rel=0.25)
