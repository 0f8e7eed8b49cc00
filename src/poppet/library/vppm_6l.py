"""Complete pressure valve of class VPPM-6L: main stage, pilot stage and electronics.

The flow characteristic is the published one of the main stage (`varga2012`). Values of a datasheet are quoted from
memory and have a note. All other values are assumed: the solenoids fill the pilot volume in a fraction of a second, and
the loops are stable for 0.1 to 200 litres. No measured response time is available: fit the parameters to tests of your
valve.
"""

from __future__ import annotations

from collections.abc import Mapping

from poppet.core.provenance import Number, Reference, Source, assumed
from poppet.library import varga2012

NAME = "vppm_6l"
REFERENCE = "assumed around the characteristic of Varga & Keski-Honkola 2012; datasheet figures as remembered"
DATASHEET = "Festo VPPM-6L-L-1-G18-0L6H"
REMEMBERED = "as remembered; verify before use"


def _datasheet(value: float, unit: str, note: str, reference: Reference = "") -> Number:
    return Number(value, unit, Source("datasheet", DATASHEET, f"{note}; {REMEMBERED}"), reference)


C = "m^3/(s Pa)"

MAIN_STAGE: Mapping[str, Number] = varga2012.REGULATOR

_SOLENOID: Mapping[str, Number] = {
    "sonic_conductance": assumed(2e-10, C, "a bore of 0.35 mm: 6 bar in 5 cm3 take 0.2 s"),
    "critical_ratio": assumed(0.3, "1", "a small sharp-edged seat"),
    "frequency": assumed(100.0, "Hz", "within the usual 50..200 Hz"),
    "opening_delay": assumed(1e-3, "s", "lower end of the usual 1..5 ms"),
    "closing_delay": assumed(0.8e-3, "s", "a little shorter than opening"),
}

PILOT_STAGE: Mapping[str, Number] = {
    "volume": assumed(5e-6, "m^3", "a membrane of 30 mm with 7 mm above it"),
    "wall_conductance": assumed(0.1, "W/K", "20 cm2 at 50 W/(m2 K): the gas takes the wall's temperature in 0.2 s"),
    "polytropic_exponent": assumed(1.2, "1", "between isothermal and isentropic"),
    **{f"fill.{name}": value for name, value in _SOLENOID.items()},
    **{f"vent.{name}": value for name, value in _SOLENOID.items()},
    "supply_leak.sonic_conductance": assumed(0.0, C, "tight"),
    "exhaust_leak.sonic_conductance": assumed(1e-13, C, "a twentieth of a per cent of a solenoid"),
}

_ELECTRONICS: Mapping[str, Number] = {
    "scaling.low": _datasheet(0.0, "Pa", "0 bar g at 0 %", "gauge"),
    "scaling.high": _datasheet(6e5, "Pa", "version 0.06..6 bar", "gauge"),
    "zero_suppression": _datasheet(0.01, "1", "regulating range begins at 0.06 bar of 6 bar"),
    "outlet_sensor.lag": assumed(2e-3, "s", "within the usual 1..5 ms"),
    "pilot_sensor.lag": assumed(1e-3, "s", "lower end of the usual 1..5 ms: it sits in the pilot volume"),
    "converter.bits": assumed(12.0, "1", "usual for such valves"),
    "converter.span": assumed(1e6, "Pa", "sensors of 10 bar"),
    "outer.feed_forward": assumed(1.0, "1", "the plate balances pilot and outlet pressure one to one"),
    "outer.bias": assumed(1.13e4, "Pa", "middle of the dead zone of the springs: 2 N to 14 N on 7.07 cm2"),
    "outer.integral_band": assumed(2e4, "Pa", "the integral trims; it does not fill the tank"),
    "outer.integral_limit": assumed(1e4, "Pa", "a little more than half the dead zone, which it has to cross"),
    "outer.pilot_limit": assumed(
        7.5e5, "Pa", "headroom over 6 bar g for the springs; the supply limits it as well", reference="gauge"
    ),
    "outer.sample_time": assumed(1e-3, "s", "usual for such valves"),
    "inner.sample_time": assumed(1e-3, "s", "usual for such valves"),
}


_TUNED = (
    ("outer.gain", "1"),
    ("outer.integral_time", "s"),
    ("outer.derivative_time", "s"),
    ("outer.derivative_filter", "s"),
    ("outer.dead_band", "Pa"),
    ("outer.dead_zone", "Pa"),
    ("outer.correction_limit", "Pa"),
    ("inner.gain", "1/Pa"),
    ("inner.hold_band", "Pa"),
    ("inner.minimum_duty", "1"),
)


def _preset(note: str, *values: float) -> Mapping[str, Number]:
    return {name: assumed(value, unit, note) for (name, unit), value in zip(_TUNED, values, strict=True)}


PRESETS: Mapping[str, Mapping[str, Number]] = {
    "universal": _preset("preset universal", 1.0, 1.0, 0.02, 5e-3, 4e2, 8e3, 1.2e4, 2e-5, 1.5e3, 0.05),
    "fast": _preset(
        "preset fast: a quick pilot that brakes late and leads far",
        1.0, 0.5, 0.018, 5e-3, 5e2, 8e3, 1.6e4, 3e-5, 1.5e3, 0.05,
    ),
    "precise": _preset(
        "preset precise: a slow pilot that brakes early, narrow bands",
        2.0, 0.6, 0.035, 1e-2, 3e2, 7e3, 8.6e3, 1.1e-5, 1e3, 0.1,
    ),
}  # fmt: skip
"""Presets of the electronics; they are not manufacturer data.

They were tuned with steps between 2 and 4 bar and small steps, for 0.1 to 200 litres, with and without a consumer, and
with averaged and switched solenoids. The dead zone between the seats is 17 kPa (12 N of the lower spring on 7.07 cm2);
a little less than half of it is crossed with the sign of the error. A correction of 8.5 kPa closes the main stage at
the setpoint. The dead band of the solenoids is a duty of 0.1 (1 ms at 100 Hz); partial compensation reduces limit
cycles of switched solenoids."""

ELECTRONICS: Mapping[str, Mapping[str, Number]] = {
    name: {**_ELECTRONICS, **numbers} for name, numbers in PRESETS.items()
}
