"""Windows of signals, for runs without an end."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Chirp, Constant, Points, Prbs, Pwm, Sine, Square, Steps

SIGNALS: dict[str, Signal] = {
    "constant": Constant(2.0),
    "steps": Steps([0.0, 1.0, 2.5, 7.0], [0.0, 1.0, 0.5, 2.0]),
    "points": Points([1.0, 3.0, 8.0], [0.0, 4.0, -1.0]),
    "sine": Sine(1.0, 0.5, 3.0),
    "chirp": Chirp(0.0, 1.0, 0.5, 5.0, duration=6.0),
    "chirp of the run": Chirp(0.0, 1.0, 0.5, 5.0),
    "prbs": Prbs(0.0, 1.0, 0.07, seed=3),
    "square": Square(0.0, 1.0, 7.0, duty=0.3),
    "pwm": Pwm(13.0, Steps([0.0, 2.0, 5.0], [0.2, 1.0, 0.0])),
    "pwm of a sine": Pwm(13.0, Sine(0.5, 0.4, 0.3)),
    "pwm of a square": Pwm(13.0, Square(0.2, 0.9, 0.4)),
}
WINDOWS = ((0.0, 1e-3), (0.0, 2.0), (0.5, 0.6), (1.0, 3.0), (2.0, 2.0 + 1e-9), (4.9, 9.0), (6.0, 20.0))
DURATION = 10.0


@pytest.mark.parametrize("delay", [0.0, 0.3, 2.0])
@pytest.mark.parametrize("name", SIGNALS)
def test_windows_have_the_segments_of_the_signal(name, delay):
    signal = SIGNALS[name].delayed(delay)
    for begin, end in WINDOWS:
        window, whole = signal.window(begin, end, DURATION), signal.segments(end, DURATION)
        assert window.start[0] <= begin
        times = np.concatenate([np.linspace(begin, np.nextafter(end, 0.0), 97), whole.start[whole.start >= begin]])
        assert np.array_equal(window.evaluate(times), whole.evaluate(times))
        # The jumps within the window are those of the signal.
        inside = window.start > begin
        jumps = set(whole.start[whole.jump & (whole.start > begin)])
        assert set(window.start[inside & window.jump]) == jumps


@pytest.mark.parametrize("name", ["sine", "prbs", "square", "pwm of a sine"])
def test_the_size_of_a_window_does_not_depend_on_its_time(name):
    sizes = [len(SIGNALS[name].delayed(0.3).window(begin, begin + 2.0, None)) for begin in (10.0, 1e6, 3e7)]
    assert max(sizes) <= 70
