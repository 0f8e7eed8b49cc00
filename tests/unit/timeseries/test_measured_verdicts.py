"""Plausibility findings: each is reported if it applies, and a valid recording has none."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet.core.codes import Note
from poppet.timeseries.measurements import Channel, InputChannel, noise_of, quantum_of
from poppet.timeseries.measurements.verdicts import verdicts

AMBIENT = 101325.0
TIME = 0.1 * np.arange(900)


def pressure(values: np.ndarray, time: np.ndarray = TIME) -> Channel:
    return Channel("tank.pressure", time, values, "Pa", quantum=quantum_of(values))


def temperature(values: np.ndarray) -> Channel:
    return Channel("tank.temperature", TIME, values, "K", quantum=quantum_of(values))


def discharge(sigma: float = 500.0, end: float = AMBIENT) -> np.ndarray:
    noise = np.random.default_rng(3).normal(0.0, sigma, TIME.size)
    return end + 6e5 * np.exp(-TIME / 20.0) + noise


def judged(*channels: Channel, gauge: bool = False, inputs: tuple[InputChannel, ...] = ()) -> list[Note]:
    addresses = frozenset(channel.address for channel in channels if gauge)
    return verdicts(channels, inputs, AMBIENT, addresses)


def only(findings: list[Note]) -> Note:
    assert len(findings) == 1, findings
    return findings[0]


def test_a_sound_recording_has_no_findings() -> None:
    assert judged(pressure(discharge())) == []
    assert judged(pressure(discharge()), gauge=True) == []


def test_gauge_pressure_read_as_absolute_is_a_finding() -> None:
    long = np.where(TIME > 80.0, 2e3, 6e5 * np.exp(-TIME / 20.0) + 2e3)
    note = only(judged(pressure(long + np.random.default_rng(1).normal(0.0, 200.0, TIME.size))))
    assert (note.code, note.address, note.facts["ambient"]) == ("suspicion.read_as_absolute", "tank.pressure", AMBIENT)
    assert 0.0 < note.facts["lowest"] < 1e4


@pytest.mark.parametrize(("begin", "end"), [(2e4, 6e5), (500.0, AMBIENT)])
def test_evacuated_tank_is_no_finding(begin: float, end: float) -> None:
    rising = end + (begin - end) * np.exp(-TIME / 60.0) + np.random.default_rng(3).normal(0.0, 100.0, TIME.size)
    assert judged(pressure(rising)) == []
    from_zero = rising - begin + 4e5 * (end == AMBIENT) * (1.0 - np.exp(-TIME / 60.0))
    assert only(judged(pressure(np.abs(from_zero)))).code == "suspicion.read_as_absolute"


def test_a_negative_absolute_pressure() -> None:
    note = only(judged(pressure(discharge(end=-3e4) - 5e3)))
    assert note.code == "suspicion.read_as_absolute"
    assert note.facts["lowest"] == pytest.approx(-2.8e4, abs=3e3)
    assert only(judged(pressure(discharge(end=-3e4) - 5e3), gauge=True)).code == "suspicion.below_vacuum"


def test_an_absolute_pressure_read_as_gauge() -> None:
    slow_discharge = discharge(end=AMBIENT + 1.0e5) - 6e5 * np.exp(-TIME[-1] / 20.0)
    assert only(judged(pressure(slow_discharge), gauge=True)).code == "suspicion.read_as_gauge"
    assert judged(pressure(slow_discharge)) == []


def test_swapped_columns() -> None:
    kelvin_as_bar = pressure(1e5 * (293.0 - 0.2 * TIME))
    bar_as_celsius = temperature(1e-5 * discharge())
    first, second = judged(kelvin_as_bar, bar_as_celsius)
    assert (first.code, second.code) == ("suspicion.high_pressure", "suspicion.no_temperature")


def test_a_clipped_channel() -> None:
    clipped = np.minimum(discharge(), 6.0e5)
    note = only(judged(pressure(clipped)))
    assert (note.code, note.facts["which"], note.facts["value"]) == ("suspicion.clipped", "highest", 6e5)
    assert note.facts["samples"] > 20
    peaks = 3e5 + np.minimum(1e5 * np.sin(TIME), 0.9e5)  # without noise
    assert ("suspicion.clipped", "highest") in {(n.code, n.facts.get("which")) for n in judged(pressure(peaks))}


def test_constant_level_is_not_clipping() -> None:
    step = 700.0
    rounded = step * np.round(np.where(TIME < 20.0, 6e5, AMBIENT + 5e5 * np.exp((20.0 - TIME) / 20.0)) / step)
    assert "suspicion.clipped" not in {note.code for note in judged(pressure(rounded))}


def test_a_coarsely_recorded_channel() -> None:
    step = 1e4
    note = only(judged(pressure(step * np.round(discharge() / step))))
    assert (note.code, note.facts["step"]) == ("suspicion.coarse", pytest.approx(step))


def test_missing_and_uneven_samples() -> None:
    keep = np.ones(TIME.size, dtype=bool)
    keep[300:340] = False
    note = only(judged(pressure(discharge()[keep], TIME[keep])))
    assert (note.code, note.facts["count"], note.facts["limit"]) == ("suspicion.gaps", 1, 3.0)
    assert [note.facts[name] for name in ("median", "longest", "start")] == pytest.approx([0.1, 4.1, 29.9])
    jitter = TIME + np.random.default_rng(1).uniform(0.0, 0.09, TIME.size)
    assert only(judged(pressure(discharge(), jitter))).code == "suspicion.uneven"


def test_milliseconds_read_as_seconds() -> None:
    stamps = np.cumsum(np.random.default_rng(1).integers(9, 12, TIME.size)).astype(float)
    assert only(judged(pressure(discharge(), stamps))).code == "suspicion.milliseconds"
    assert judged(pressure(discharge(), 10.0 * np.arange(TIME.size))) == []


def filled(delay: float, sigma: float) -> tuple[InputChannel, Channel]:
    """Return an isothermal tank: the pressure is the integral of the flow, which is recorded late."""
    flow = np.where((TIME > 20.0) & (TIME < 60.0), 6e-4 * (1.0 + 0.3 * np.sin(TIME)), 0.0)
    mass = np.concatenate([[0.0], np.cumsum(0.05 * (flow[1:] + flow[:-1]))])
    noise = np.random.default_rng(1).normal(0.0, sigma, TIME.size)
    delayed_flow = np.interp(TIME - delay, TIME, flow)
    level = AMBIENT + 1.1e7 * mass + noise
    return InputChannel("inlet.mass_flow_rate", TIME, delayed_flow, "kg/s"), pressure(level)


@pytest.mark.parametrize("sigma", [0.0, 300.0, 1500.0])
@pytest.mark.parametrize("delay", [1.3, -0.8])
def test_late_input_is_reported_with_its_delay(sigma: float, delay: float) -> None:
    item, channel = filled(delay, sigma)
    note = only(judged(channel, inputs=(item,)))
    assert note.code == ("suspicion.recorded_late" if delay > 0.0 else "suspicion.recorded_early")
    assert note.facts["shift"] == pytest.approx(abs(delay), abs=0.15)
    assert (note.facts["silent_until"] is not None) == (delay > 0)


@pytest.mark.parametrize("sigma", [0.0, 300.0, 1500.0])
def test_input_without_delay_is_no_finding(sigma: float) -> None:
    item, channel = filled(0.0, sigma)
    assert judged(channel, inputs=(item,)) == []
    item, channel = filled(1.3, sigma)
    corrected = InputChannel(item.address, item.time, item.values, item.unit, delay=1.3)
    assert judged(channel, inputs=(corrected,)) == []


def test_late_input_is_reported_in_a_fast_recording() -> None:
    item, channel = filled(1.3, 0.0)
    fast = np.arange(0.0, TIME[-1], 0.002)
    level = np.interp(fast, TIME, channel.values) + np.random.default_rng(1).normal(0.0, 1e3, fast.size)
    flow = InputChannel(item.address, fast, np.interp(fast, TIME, item.values), item.unit)
    note = only(judged(pressure(level, fast), inputs=(flow,)))
    assert (note.code, note.facts["shift"]) == ("suspicion.recorded_late", pytest.approx(1.3, abs=0.05))


def test_an_input_that_ends_too_early() -> None:
    item, channel = filled(0.0, 300.0)
    short = InputChannel(item.address, item.time[:700], item.values[:700], item.unit)
    note = only(judged(channel, inputs=(short,)))
    assert note.code == "suspicion.coverage"
    assert [note.facts[name] for name in ("start", "stop", "end")] == pytest.approx([0.0, 69.9, 89.9])


def test_slow_thermometer_is_a_finding() -> None:
    level = discharge(sigma=200.0)
    gas = 293.0 * (level / level[0]) ** (0.4 / 1.4)
    quick = temperature(gas)
    assert judged(pressure(level), quick) == []
    slow = np.empty_like(gas)
    slow[0] = gas[0]
    for k in range(1, gas.size):
        slow[k] = slow[k - 1] + (gas[k] - slow[k - 1]) * 0.1 / 6.0
    assert only(judged(pressure(level), temperature(slow))).code == "suspicion.slow_sensor"
    freed = Channel("tank.temperature", TIME, slow, "K", lag=None)
    assert judged(pressure(level), freed) == []


# Noise and steps


@settings(derandomize=True, deadline=None, max_examples=40)
@given(
    sigma=st.floats(0.01, 10.0),
    slope=st.floats(-5.0, 5.0),
    seed=st.integers(0, 1000),
)
def test_noise_does_not_depend_on_the_trend(sigma: float, slope: float, seed: int) -> None:
    values = slope * np.arange(2000.0) + np.random.default_rng(seed).normal(0.0, sigma, 2000)
    assert abs(noise_of(values) / sigma - 1.0) < 0.12


def test_noise_of_uneven_samples_needs_their_times() -> None:
    rng = np.random.default_rng(2)
    time = np.cumsum(rng.uniform(0.5, 1.5, 2000))
    values = 50.0 * time + rng.normal(0.0, 1.0, 2000)
    assert noise_of(values, time) == pytest.approx(1.0, rel=0.1)
    assert noise_of(values) > 5.0


def test_jumps_are_not_noise() -> None:
    values = np.random.default_rng(2).normal(0.0, 1.0, 2000)
    values[1000:] += 500.0
    values[300] += 200.0
    assert noise_of(values) == pytest.approx(1.0, rel=0.1)


def test_noise_is_at_least_that_of_rounding() -> None:
    ramp = np.round(np.linspace(0.0, 30.0, 4000))
    assert noise_of(ramp) == pytest.approx(1.0 / np.sqrt(12.0))
    assert noise_of(np.array([1.0, 2.0])) == 0.0


@settings(derandomize=True, deadline=None, max_examples=40)
@given(step=st.floats(1e-3, 1e4), offset=st.floats(-1e5, 1e5), seed=st.integers(0, 1000))
def test_resolution_of_a_recording(step: float, offset: float, seed: int) -> None:
    counts = np.random.default_rng(seed).integers(0, 60, 400)
    assert quantum_of(offset + step * counts) == pytest.approx(step, rel=1e-3)


def test_smooth_or_short_recordings_have_no_resolution() -> None:
    assert quantum_of(np.random.default_rng(0).normal(0.0, 1.0, 600)) == 0.0
    assert quantum_of(np.array([1.0, 5.0, 1.0, 5.0])) == 0.0
    assert quantum_of(np.full(20, 3.0)) == 0.0
    assert quantum_of(np.linspace(0.0, 1.0, 101)) == 0.0
