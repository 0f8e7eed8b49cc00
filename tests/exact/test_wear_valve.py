"""The watch on a pneumatic valve whose leak grows; the truth has other laws than the twin."""

from __future__ import annotations

import numpy as np
import pytest

from exact.wear_valve_watch import FAULTS, PORT, conductance_per_area, evaluate
from poppet.iso6358 import conductance_from_effective_area


def test_conductance_of_a_port():
    # The closed form of the tests is the conversion of the package for an ideal nozzle, up to rounded constants.
    nozzle = conductance_from_effective_area(PORT, isentropic_exponent=1.4, gas_constant=8.314 / 28.01e-3)
    assert nozzle.sonic_conductance == pytest.approx(PORT * conductance_per_area(), rel=1e-3)


@pytest.mark.slow
def test_a_growing_leak_is_named_and_sized():
    start, growth = 200.0, 5e-10
    result = evaluate(growth, start, 600.0)
    is_alarm = np.array([bool(alarm) for alarm in result.alarms])
    assert not is_alarm[result.time < start].any()
    assert set(result.alarms) == {"", "bottom_leak"}
    first = result.true[int(np.argmax(is_alarm))]
    assert first * conductance_per_area() < 2.0 * FAULTS["bottom_leak"]["alarm"]
    # The estimate lags behind: it is that of a leak of at most 300 s before.
    assert result.true[-1] > result.size[-1] > growth * (result.time[-1] - start - 300.0)
