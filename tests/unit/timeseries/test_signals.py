from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Chamber, Circuit, FlowSource, Run
from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors
from poppet.engine.reference_solvers.track import inputs_at
from poppet.signals import Chirp, Constant, Points, Prbs, Pwm, SampledSignal, Signal, Sine, Square, Steps, merge
from poppet.timeseries.segments import MergedSegments, SegmentTable, held

SETTINGS = settings(derandomize=True, deadline=None, max_examples=60)

SIGNALS = {
    "constant": Constant(3.0),
    "steps": Steps([0.0, 0.3, 2.0], [1.0, -1.0, 4.0]),
    "points": Points([0.5, 1.0, 2.5], [1.0, 3.0, -2.0]),
    "sampled": SampledSignal([0.0, 1.0, 1.1], [0.0, 1.0, 5.0], "bench.csv"),
    "sine": Sine(1.0, 2.0, 0.7, 0.3),
    "chirp": Chirp(1.0, 2.0, 0.2, 3.0, duration=1.7, phase=-0.4),
    "prbs": Prbs(-1.0, 2.0, 0.25, seed=3),
    "square": Square(-1.0, 2.0, 2.5, duty=0.3),
    "pwm": Pwm(2.0, Points([0.0, 2.0], [0.1, 0.9]), -1.0, 2.0),
    "delayed pwm": Pwm(2.0, 0.25, -1.0, 2.0).delayed(0.45),
    "delayed steps": Steps([0.0, 0.3, 2.0], [1.0, -1.0, 4.0]).delayed(0.2),
    "delayed chirp": Chirp(1.0, 2.0, 0.2, 3.0, duration=1.7, phase=-0.4).delayed(0.45),
}
every_signal = pytest.mark.parametrize("signal", SIGNALS.values(), ids=SIGNALS.keys())


def merged_at(merged: MergedSegments, i: int, t: np.ndarray) -> np.ndarray:
    """Return the definition: value + slope tau + amplitude sin(2 pi (f + c tau / 2) tau + phase)."""
    k = np.searchsorted(merged.starts, t, side="right") - 1
    value, slope, amplitude, frequency, rate, phase, origin = merged.coefficients[merged.courses[k], i].T
    tau = t - origin
    return value + slope * tau + amplitude * np.sin(2 * np.pi * (frequency + rate * tau / 2) * tau + phase)


@every_signal
def test_segments_begin_at_zero_increase_and_end_before_the_run(signal):
    table = signal.table(3.0)
    assert table.start[0] == 0.0
    assert np.all(np.diff(table.start) > 0.0)
    assert table.start[-1] < 3.0
    assert not table.jump[0]
    columns = (table.value, table.slope, table.amplitude, table.frequency, table.chirp_rate, table.phase)
    assert {len(column) for column in (*columns, table.jump)} == {len(table)}


@every_signal
def test_only_marked_starts_are_discontinuous(signal):
    table = signal.table(3.0)
    left_limits = signal.evaluate(np.nextafter(table.start[1:], 0.0))
    step = np.abs(signal.evaluate(table.start[1:]) - left_limits)
    np.testing.assert_array_equal(step > 1e-9, table.jump[1:])


@every_signal
def test_values_reach_but_do_not_exceed_the_bounds(signal):
    values = signal.evaluate(np.linspace(0.0, 8.0, 8001))
    low, high = signal.bounds()
    assert low <= np.min(values) <= low + 1e-3
    assert high - 1e-3 <= np.max(values) <= high


@every_signal
def test_the_run_and_the_evaluation_agree(signal):
    t = np.linspace(0.0, 2.99, 500)
    np.testing.assert_array_equal(signal.table(3.0).evaluate(t), signal.evaluate(t))


def test_constant():
    assert Constant(2).evaluate([0.0, 5.0]).tolist() == [2.0, 2.0]


def test_steps_are_right_continuous():
    steps = Steps([0.0, 20.0, 40.0], [1e5, 2e5, 0.0])
    assert steps.evaluate([0.0, 19.999, 20.0, 40.0, 100.0]).tolist() == [1e5, 1e5, 2e5, 0.0, 0.0]


def test_step_of_zero_height_is_no_jump():
    assert Steps([0.0, 1.0, 2.0], [1.0, 1.0, 2.0]).table(3.0).jump.tolist() == [False, False, True]


def test_points_hold_their_ends():
    points = Points([1.0, 3.0], [2.0, 6.0])
    assert points.evaluate([0.0, 1.0, 2.0, 3.0, 9.0]).tolist() == [2.0, 2.0, 4.0, 6.0, 6.0]
    assert Points([0.0], [2.0]).evaluate(7.0) == 2.0


def test_sine_is_the_formula():
    t = np.linspace(0.0, 3.0, 50)
    expected = 1.0 + 2.0 * np.sin(2 * np.pi * 0.7 * t + 0.3)
    np.testing.assert_allclose(Sine(1.0, 2.0, 0.7, 0.3).evaluate(t), expected, rtol=0, atol=1e-14)


def test_chirp_sweeps_and_then_holds_its_end_frequency():
    f0, f1, span = 0.5, 4.0, 2.0
    t = np.linspace(0.0, 5.0, 400)
    sweep = np.minimum(t, span)
    turns = f0 * sweep + 0.5 * (f1 - f0) / span * sweep**2 + f1 * np.maximum(t - span, 0.0)
    expected = np.sin(2 * np.pi * turns)
    np.testing.assert_allclose(Chirp(0.0, 1.0, f0, f1, duration=span).evaluate(t), expected, atol=1e-12)


def test_default_duration_of_a_chirp_is_the_run():
    chirp = Chirp(0.0, 1.0, 0.5, 4.0)
    assert len(chirp.table(10.0)) == 1
    assert chirp.table(10.0).chirp_rate[0] == 0.35
    np.testing.assert_array_equal(chirp.evaluate([1.0], duration=10.0), chirp.table(10.0).evaluate([1.0]))
    with pytest.raises(InputError) as caught:
        chirp.evaluate(1.0)
    assert caught.value.code == "signals.chirp_duration"


def test_prbs_is_repeatable_and_continues_in_longer_runs():
    t = np.arange(0.05, 50.0, 0.1)
    bits = Prbs(0.0, 1.0, 0.1, seed=7).evaluate(t)
    np.testing.assert_array_equal(Prbs(0.0, 1.0, 0.1, seed=7).table(50.0).evaluate(t), bits)
    np.testing.assert_array_equal(Prbs(0.0, 1.0, 0.1, seed=7).table(500.0).evaluate(t), bits)
    assert set(bits) == {0.0, 1.0}
    assert np.any(Prbs(0.0, 1.0, 0.1, seed=8).evaluate(t) != bits)


def test_prbs_bits_equal_the_raw_stream():
    expected = np.random.PCG64(7).random_raw(20) >> np.uint64(63)
    np.testing.assert_array_equal(Prbs(0.0, 1.0, 1.0, seed=7).evaluate(np.arange(20.0)), expected)


def test_prbs_refuses_a_run_of_too_many_bits():
    with pytest.raises(InputError) as caught:
        Prbs(0.0, 1.0, 1e-9).table(100.0)
    assert caught.value.code == "signals.too_many_bits"
    assert caught.value.facts["bits"] == pytest.approx(1e11)


def test_delayed_signal_holds_its_first_value():
    signal = Steps([0.0, 1.0], [1.0, 5.0]).delayed(0.5)
    assert signal.evaluate([0.0, 0.5, 1.4, 1.5]).tolist() == [1.0, 1.0, 1.0, 5.0]
    assert Constant(1.0).delayed(0.0) == Constant(1.0)
    assert len(signal.table(0.4)) == 1
    sine = Sine(0.0, 1.0, 1.0, phase=math.pi / 2)
    np.testing.assert_allclose(sine.delayed(0.5).evaluate([0.2, 1.0]), [1.0, -1.0], atol=1e-14)


@SETTINGS
@given(times=st.lists(st.integers(1, 50), max_size=6, unique=True), delay=st.floats(1e-9, 3.0))
def test_a_delayed_step_is_never_lost(times, delay):
    steps = Steps([0.0, *(k / 10 for k in sorted(times))], np.arange(len(times) + 1.0))
    shifted = np.asarray(steps.times) + delay
    np.testing.assert_array_equal(steps.delayed(delay).evaluate(shifted), steps.values)
    assert all(steps.delayed(delay).table(end).start[-1] < end for end in shifted)


def test_held_values_give_a_note():
    name = "valve.pilot_pressure"
    points = Points([0.0, 40.0], [0.0, 2e5])
    assert points.notes(120.0, name) == (Note("signals.held_after", name, source="", value=2e5, time=40.0),)
    assert points.notes(40.0, name) == ()
    assert points.delayed(1.0).notes(120.0, name)[0].facts["time"] == 41.0
    sampled = SampledSignal([1.0, 40.0], [1e5, 2e5], "bench.csv")
    assert sampled.notes(120.0, name) == (
        Note("signals.held_before", name, source="bench.csv", value=1e5, time=1.0),
        Note("signals.held_after", name, source="bench.csv", value=2e5, time=40.0),
    )
    assert Constant(1.0).notes(1.0, name) == ()


def test_steps_after_the_run_give_a_note():
    steps = Steps([0.0, 20.0, 40.0], [1.0, 2.0, 3.0])
    assert steps.notes(40.0, "a") == (Note("signals.steps_unused", "a", unused=1, total=3, end=40.0),)
    assert steps.notes(41.0, "a") == ()
    assert steps.delayed(1.0).notes(41.0, "a")[0].facts["unused"] == 1


def test_merge_of_nothing_is_one_segment():
    starts, courses, coefficients, jumps = merge([])
    assert starts.tolist() == [0.0]
    assert courses.tolist() == [0]
    assert coefficients.shape == (1, 0, 7)
    assert jumps.tolist() == [False]


def test_merge_does_not_change_signals():
    tables = [signal.table(3.0) for signal in SIGNALS.values()]
    merged = merge(tables)
    t = np.linspace(0.0, 2.999, 2000)
    for i, table in enumerate(tables):
        np.testing.assert_allclose(merged_at(merged, i, t), table.evaluate(t), rtol=0, atol=1e-12)


def test_merge_marks_the_jumps_of_any_input():
    starts, _, _, jumps = merge([SIGNALS["steps"].table(3.0), SIGNALS["points"].table(3.0)])
    assert starts.tolist() == [0.0, 0.3, 0.5, 1.0, 2.0, 2.5]
    assert jumps.tolist() == [False, True, False, False, True, False]


def test_merge_joins_starts_that_differ_by_rounding():
    rounded = 0.1 + 0.2  # 0.30000000000000004
    starts, courses, coefficients, jumps = merge(
        [Steps([0.0, 0.3], [0.0, 1.0]).table(1.0), Steps([0.0, rounded], [0.0, 2.0]).table(1.0)]
    )
    assert starts.tolist() == [0.0, 0.3]
    assert coefficients[courses[1], :, 0].tolist() == [1.0, 2.0]
    assert jumps.tolist() == [False, True]


def test_merge_keeps_the_phase_of_a_fast_sine_late_in_a_run():
    tables = [Sine(0.0, 1.0, 1000.0).table(2000.0), Steps([0.0, 1234.5], [0.0, 1.0]).table(2000.0)]
    merged = merge(tables)
    assert merged.starts[1] == 1234.5
    circuit = Circuit(
        {"source": FlowSource(to="tank"), "tank": Chamber(volume="1 l", thermal="isothermal")},
        {"source.mass_flow_rate": Sine(0.0, 1e-6, 1000.0)},
    )
    problem = circuit.problem(Run(duration=2000.0))
    assert abs(inputs_at(problem, 0, 1234.5)[0]) < 1e-6 * 1e-11


def test_repeated_segments_are_stored_once():
    tables = [Square(0.0, 1.0, 1e4).table(5.0), Sine(0.0, 1.0, 50.0).table(5.0), Constant(3.0).table(5.0)]
    merged = merge(tables)
    assert merged.starts.size == 100_000
    assert merged.coefficients.shape == (2, 3, 7)
    assert sum(array.nbytes for array in merged) <= 17 * merged.starts.size + 2000
    t = np.linspace(0.0, 4.999, 3001)
    np.testing.assert_array_equal(merged_at(merged, 0, t), tables[0].evaluate(t))


@pytest.mark.parametrize("frequency", [10.0, 7.0, 1234.5])
def test_edges_of_pulses_are_correctly_rounded(frequency):
    start = Square(-1.0, 1.0, frequency, duty=0.25).table(500.5 / frequency).start
    assert start.size == 1002  # the last period has begun, and its fall too
    periods = [Fraction(k) / Fraction(frequency) for k in range(501)]
    assert start[0::2].tolist() == [float(start_time) for start_time in periods]
    falls = [float(start_time + Fraction(1, 4) / Fraction(frequency)) for start_time in periods]
    np.testing.assert_array_max_ulp(start[1::2], np.array(falls), 1)


def test_duty_at_the_start_of_a_period_is_used():
    duty = Points([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 1.0, 0.0])
    signal = Pwm(8.0, duty, low=2.0, high=5.0)
    t = (np.arange(4000) + 0.5) / 1000.0
    expected = []
    for time in t:
        begin = math.floor(time * 8.0) / 8.0
        width = float(duty.evaluate(begin)) / 8.0
        expected.append(5.0 if time < begin + width else 2.0)
    assert signal.evaluate(t).tolist() == expected
    table = signal.table(4.0)
    # None in the first period, whose duty is 0; from 1 s to 2.125 s all is high, without an edge.
    assert table.start[1] == 0.125
    assert not np.any((table.start > 1.0) & (table.start < 2.125))
    assert table.jump[1:].all()
    assert [note.code for note in signal.notes(4.0, "valve.opening")] == ["signals.held_after"]


@pytest.mark.parametrize(("duty", "value"), [(0.0, 1.0), (1.0, 4.0)])
def test_pulses_that_never_end_or_begin_have_no_edges(duty, value):
    table = Square(1.0, 4.0, 50.0, duty).table(10.0)
    assert table.start.tolist() == [0.0]
    assert table.value.tolist() == [value]


@pytest.mark.parametrize("tolerance", [1e-6, 0.1])
def test_long_steps_miss_no_pulse(tolerance):
    """The mass from short pulses into a closed tank is the rate times the sum of their widths, to round-off."""
    width = Points([0.0, 1000.0], [1e-3, 1e-2])
    circuit = Circuit(
        {"source": FlowSource(to="tank"), "tank": Chamber(volume="1 m^3", thermal="isothermal")},
        {"source.mass_flow_rate": Pwm(1.0, width, 0.0, 0.01)},
    )
    run = circuit.simulate(duration=1000.0, output_step=1000.0, relative_tolerance=tolerance)
    mass = run["tank.mass"]
    expected = 0.01 * sum(1e-3 + 9e-3 * k / 1000.0 for k in range(1000))
    assert mass[-1] - mass[0] == pytest.approx(expected, rel=1e-11)
    assert run.statistics["accepted_steps"] >= 2000


@pytest.mark.slow
def test_a_million_edges_need_little_memory():
    circuit = Circuit(
        {"source": FlowSource(to="tank"), "tank": Chamber(volume="1 m^3", thermal="isothermal")},
        {"source.mass_flow_rate": Pwm(1000.0, Sine(0.5, 0.4, 0.1), 0.0, 0.001)},
    )
    problem = circuit.problem(Run(duration=500.0, output_step=1.0))
    assert problem.starts.size == 1_000_000
    arrays = (problem.starts, problem.courses, problem.coefficients, problem.jumps)
    assert sum(array.nbytes for array in arrays) < 17.1e6
    mass = circuit.simulate(duration=500.0, output_step=1.0)["tank.mass"]
    duty = 0.5 + 0.4 * np.sin(2.0 * np.pi * 0.1 * np.arange(500_000) / 1000.0)
    assert mass[-1] - mass[0] == pytest.approx(1e-6 * duty.sum(), rel=1e-9)


def test_held_is_one_segment():
    table = held(2)
    assert isinstance(table, SegmentTable)
    assert table.evaluate([0.0, 9.0]).tolist() == [2.0, 2.0]


@pytest.mark.parametrize("kind", [Steps, Points, lambda t, v: SampledSignal(t, v, "bench.csv")])
@pytest.mark.parametrize(
    ("times", "values", "code", "facts"),
    [
        ([0.0, 2.0, 1.0], [0.0, 1.0, 2.0], "series.time.not_increasing", {"place": 1, "time": 2.0, "next": 1.0}),
        ([0.0, 1.0, 1.0], [0.0, 1.0, 2.0], "series.time.not_increasing", {"place": 1}),
        ([0.0, 1.0], [0.0], "signals.lengths", {"times": 2, "values": 1}),
        ([0.0, math.nan], [0.0, 1.0], "series.time.not_finite", {"place": 1}),
        ([0.0, 1.0], [0.0, math.inf], "signals.not_finite", {"place": 1, "value": math.inf}),
        ([], [], "series.time.shape", {"shape": (0,)}),
        ([-1.0, 1.0], [0.0, 1.0], "signals.before_run", {"time": -1.0}),
        (["0 s", "1 s"], [0.0, 1.0], "series.numbers", {}),
        ([[0.0, 1.0]], [[0.0, 1.0]], "signals.lengths", {}),
    ],
)
def test_paths_are_checked(kind, times, values, code, facts):
    with pytest.raises(InputError) as caught:
        kind(times, values)
    assert caught.value.code == code
    assert facts.items() <= caught.value.facts.items()


def test_all_errors_of_a_path_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        Steps([0.0, 0.0], [math.nan, 1.0])
    codes = [problem.code for problem in caught.value.problems]
    assert codes == ["series.time.not_increasing", "signals.not_finite"]


def test_steps_begin_at_zero():
    with pytest.raises(InputError) as caught:
        Steps([1.0, 2.0], [0.0, 1.0])
    assert (caught.value.code, caught.value.facts) == ("signals.no_first_step", {"time": 1.0})


@pytest.mark.parametrize(
    ("build", "code", "field"),
    [
        (lambda: Constant(math.nan), "numbers.not_finite", "value"),
        (lambda: Constant("1 bar"), "numbers.not_finite", "value"),
        (lambda: Sine(0.0, 1.0, 0.0), "numbers.not_positive", "frequency"),
        (lambda: Sine(0.0, math.inf, 1.0), "numbers.not_finite", "amplitude"),
        (lambda: Chirp(0.0, 1.0, 1.0, -1.0), "numbers.not_positive", "end_frequency"),
        (lambda: Chirp(0.0, 1.0, 1.0, 1.0, duration=0.0), "numbers.not_positive", "duration"),
        (lambda: Prbs(0.0, 1.0, 0.0), "numbers.not_positive", "bit_time"),
        (lambda: Prbs(1.0, 1.0, 1.0), "signals.order", None),
        (lambda: Prbs(0.0, 1.0, 1.0, seed=-1), "signals.seed", None),
        (lambda: Square(1.0, 0.0, 1.0), "signals.order", None),
        (lambda: Square(0.0, 1.0, 0.0), "numbers.not_positive", "frequency"),
        (lambda: Square(0.0, 1.0, 1.0, 1.5), "signals.duty", None),
        (lambda: Square(0.0, 1.0, 1.0, math.nan), "numbers.not_finite", "duty"),
        (lambda: Pwm(1.0, Sine(0.5, 0.6, 1.0)), "signals.duty", None),
        (lambda: Square(0.0, 1.0, 1e6).table(1e3), "signals.too_many_periods", None),
        (lambda: Constant(1.0).delayed(-1.0), "signals.delay", None),
        (lambda: Constant(1.0).table(0.0), "signals.duration", None),
        (lambda: Constant(1.0).evaluate(-1.0), "signals.times", None),
    ],
)
def test_fields_are_checked(build, code, field):
    with pytest.raises(InputError) as caught:
        build()
    assert (caught.value.code, caught.value.address) == (code, field)


def test_signals_are_immutable():
    times = np.array([0.0, 1.0])
    steps = Steps(times, [1.0, 2.0])
    times[1] = 9.0
    assert steps.times[1] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        steps.times[1] = 5.0


def test_signal_class_without_segments_is_abstract():
    with pytest.raises(TypeError, match="abstract"):
        Signal()
