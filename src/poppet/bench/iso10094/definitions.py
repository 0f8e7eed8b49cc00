"""What every figure of the bench means: one table, from which documents, results and reports take their words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

STATIC, DYNAMIC = "ISO 10094-1, -2: static tests", "ISO 10094-1, -2: dynamic tests"
TESTS: Mapping[str, str] = MappingProxyType(
    {
        "characteristic": "outlet pressure over a slow sweep of the setpoint, up and down, several cycles",
        "resolution": "the smallest change of the setpoint that moves the outlet, by a small staircase",
        "flow": "outlet pressure against flow drawn from the outlet and fed into it, there and back",
        "supply": "outlet pressure at a constant setpoint over a slow sweep of the supply pressure",
        "leakage": "flow from the supply while the outlet is closed and at rest",
        "step": "steps of the setpoint, both directions, several amplitudes and volumes",
        "frequency": "sines of the setpoint about a mean, one frequency after the other",
    }
)
"""Name of each test, as in `--tests`, and what is done in it."""

VERIFY = "verify against the standard"
RANGE = (10.0, 90.0)
"""Part of the setpoint's range in which the characteristic is judged [% FS]; dead zone and ends are outside."""
LOW, HIGH = 0.1, 0.9
"""Fractions of a step between which it rises."""
BAND = 0.05
"""Half width of the band in which a step has settled, as a fraction of the step."""
GAIN_DB, PHASE_DEG = -3.0, -90.0
"""Where the two bandwidths are read."""
DROOP = 10.0
"""Fall of the outlet at which the capacity is read [% FS]."""
_SPAN = f"between {RANGE[0]:g} and {RANGE[1]:g} % FS of the setpoint"


@dataclass(frozen=True)
class Definition:
    """One figure.

    Parameters
    ----------
    name : str
        As in a result.
    unit : str
        Of its value.
    text : str
        What it is.
    test : str
        In which test it is found.
    limits : str
        Rates, bands and limits on which it depends.
    part : str
        Part of the standard to which it belongs.
    was_read : bool
        False where the standard's own wording was not at hand: verify against the standard.
    """

    name: str
    unit: str
    text: str
    test: str
    limits: str
    part: str
    was_read: bool = False

    @property
    def full(self) -> str:
        """What it is, with its limits."""
        return f"{self.text} ({self.limits})"

    @property
    def standard(self) -> str:
        """Part of the standard, and whether its wording has to be compared."""
        return self.part if self.was_read else f"{self.part}; {VERIFY}"


def _definitions() -> tuple[Definition, ...]:
    return (*_characteristic(), *_resolution(), *_flow(), *_supply(), *_step(), *_frequency())


def _characteristic() -> tuple[Definition, ...]:
    sweep = f"slow sweep, rate stated with the result; {_SPAN}"
    rows = (
        (
            "linearity", "% FS",
            "largest distance of the mean characteristic (mean of all branches up and down) from the straight line "
            "that fits it best by least squares", sweep,
        ),
        (
            "hysteresis", "% FS",
            "largest difference between the mean branch down and the mean branch up at the same setpoint", sweep,
        ),
        (
            "repeatability", "% FS",
            "largest difference between branches of the same direction at the same setpoint, over all cycles",
            f"at least two cycles; {_SPAN}",
        ),
        (
            "accuracy", "% FS",
            "largest distance of any branch from the nominal line, which joins the ends of setpoint and pressure range",
            sweep,
        ),
        (
            "zero_suppression", "% FS",
            "setpoint, of its range, at which the outlet leaves zero on the way up: its rise, continued back to the "
            "pressure at setpoint zero", "mean of all cycles",
        ),
        ("zero_offset", "% FS", "outlet pressure at setpoint zero, above the lower end of the range", "end of a hold"),
        (
            "sweep_lag", "% FS",
            "how far the outlet is behind the setpoint because of the sweep's rate: what it still moves when the sweep "
            "stops", "holds at the upper end of the sweep; this lag is taken out of all figures of a sweep",
        ),
    )  # fmt: skip
    return tuple(Definition(*row[:3], "characteristic", row[3], STATIC) for row in rows)


def _resolution() -> tuple[Definition, ...]:
    stairs = "a stair held until the outlet rests; known to one stair"
    rows = (
        (
            "resolution", "% FS",
            "smallest change of the setpoint, in the direction of the last one, that moves the outlet; the largest "
            "found",
        ),
        (
            "reversal_threshold", "% FS",
            "smallest change of the setpoint, against the last direction, that moves the outlet; the largest found",
        ),
    )  # fmt: skip
    return tuple(Definition(*row, "resolution", stairs, STATIC) for row in rows)


def _flow() -> tuple[Definition, ...]:
    at = "at the rated flow; without one at half of the largest flow that was tested"
    rows = (
        (
            "flow_droop", "% FS",
            "fall of the outlet pressure from no flow to the rated flow out of the outlet, the largest of all "
            "setpoints; mean of there and back", at,
        ),
        (
            "flow_hysteresis", "% FS",
            "largest difference of the outlet pressure between falling and rising flow out of the outlet",
            "between 10 and 90 % of the largest flow, or of that at which the valve reaches its limit",
        ),
        (
            "flow_capacity", "kg/s",
            f"flow out of the outlet at which its pressure has fallen by {DROOP:g} % FS, the smallest of all setpoints",
            "on the way to larger flow",
        ),
        (
            "relief_rise", "% FS",
            "rise of the outlet pressure from no flow to the rated flow into the outlet, the largest of all setpoints; "
            "mean of there and back", at,
        ),
        (
            "relief_hysteresis", "% FS",
            "largest difference of the outlet pressure between falling and rising flow into the outlet",
            "between 10 and 90 % of the largest flow, or of that at which the valve reaches its limit",
        ),
    )  # fmt: skip
    return tuple(Definition(*row[:3], "flow", row[3], STATIC) for row in rows)


def _supply() -> tuple[Definition, ...]:
    sweep = "slow sweep of the supply, at least 10 % FS above the outlet, with a small flow out of it"
    return (
        Definition(
            "supply_sensitivity", "1",
            "change of the outlet pressure per change of the supply pressure at a constant setpoint: slope of the "
            "straight line that fits best, the steepest of all setpoints", "supply", sweep, STATIC,
        ),
        Definition(
            "supply_hysteresis", "% FS",
            "largest difference of the outlet pressure between rising and falling supply pressure", "supply", sweep,
            STATIC,
        ),
        Definition(
            "leakage", "kg/s",
            "flow from the supply with the outlet closed and at rest, the largest of all setpoints", "leakage",
            "mean over the second half of a hold", STATIC,
        ),
    )  # fmt: skip


def _step() -> tuple[Definition, ...]:
    reference = "the largest step at the first volume"
    settled, low, high = f"{100 * BAND:g} %", f"{100 * LOW:g} %", f"{100 * HIGH:g} %"
    final = "of the change of the outlet from rest to rest"
    rows = [
        ("delay", "s", f"time from the step of the setpoint to {low} {final}, the longer one of up and down", reference)
    ]
    for way in ("up", "down"):
        rows += [
            (f"rise_time_{way}", "s", f"time from {low} to {high} {final}, step {way}", reference),
            (
                f"response_time_{way}",
                "s",
                f"time from the step of the setpoint to {high} {final}, step {way}",
                reference,
            ),
        ]
    rows += [
        (
            "settling_time", "s",
            f"time from the step of the setpoint until the outlet stays within {settled} of the step about its final "
            "value, the longest", f"all steps at the first volume; band +/- {settled} of the step",
        ),
        (
            "overshoot", "%",
            "how far the outlet goes beyond its final value, of the step, the largest of all steps at the first volume",
            "all amplitudes, up and down",
        ),
        (
            "hum_amplitude", "% FS",
            "half of the swing from top to bottom of a periodic motion of the outlet at rest, the largest found",
            "last fifth of each hold; a line of its spectrum that noise does not explain (one in 10 000)",
        ),
        ("hum_frequency", "Hz", "frequency of that motion", "as above"),
    ]  # fmt: skip
    return tuple(Definition(*row[:3], "step", row[3], DYNAMIC) for row in rows)


def _frequency() -> tuple[Definition, ...]:
    sines = "sine of the stated amplitude about the stated mean; relative to the lowest frequency"
    rows = (
        (
            "bandwidth_gain", "Hz",
            f"frequency at which the amplitude of the outlet has fallen by {-GAIN_DB:g} dB, from the fundamental wave",
        ),
        (
            "bandwidth_phase", "Hz",
            f"frequency at which the fundamental wave of the outlet is {-PHASE_DEG:g} deg behind the setpoint",
        ),
        (
            "distortion", "%",
            "root of the sum of squares of harmonics 2 to 5 of the outlet over its fundamental wave, the largest "
            "up to the bandwidth_gain",
        ),
    )  # fmt: skip
    return tuple(Definition(*row, "frequency", sines, DYNAMIC) for row in rows)


DEFINITIONS: Mapping[str, Definition] = MappingProxyType({each.name: each for each in _definitions()})
"""All figures by name, in the order of the tests."""
