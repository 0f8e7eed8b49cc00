"""Texts of a bench report: headings, captions, verdict sentences and formatted values."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.characteristic import RANGE
from poppet.bench.iso10094.evaluation import CharacteristicValue
from poppet.bench.iso10094.flow import DROOP
from poppet.bench.iso10094.frequency import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.step import HIGH
from poppet.core.number_format import readable_unit, scaled, with_unit

NOTHING = 1e-4
"""Percentage below which a value is rounding of the solver."""
MIN_UNCERTAINTY = 1e-4
"""Minimum relative uncertainty that a report shows."""
_RELEVANT = 0.05
"""Minimum percentage for a sentence of the verdict."""
_CONDITIONS = {
    "from": "step {from:.3g} to {to:.3g} % FS",
    "at": "at {at:.3g} % FS",
    "setpoint": "setpoint {setpoint:.3g} % FS",
    "amplitude": "± {amplitude:.3g} % FS about {mean:.3g} % FS",
    "volume": "{volume}",
    "flow": "{flow}",
    "frequency": "{frequency}",
    "stair": "stairs of {stair:.2g} % FS",
    "cycles": "{cycles} cycles",
    "lowest_supply": "supply {lowest_supply} to {highest_supply}",
}
_SIGNS = {"at most": "≤ ", "at least": "≥ ", "": ""}


def value_text(value: float, unit: str, bound: str = "") -> str:
    """Return a value with a readable unit.

    `bound` is `at most` or `at least` if the value is a limit.

    Examples
    --------
    >>> value_text(0.0123, "s"), value_text(0.5, "% FS", "at most")
    ('12.3 ms', '≤ 0.5 % FS')
    """
    # Round first: otherwise 999.9999 Pa is not shown as 1 kPa.
    readable = readable_unit(unit, float(f"{value:.3g}"))
    if unit in ("% FS", "%") and abs(value) < NOTHING:
        value = 0.0
    return with_unit(f"{_SIGNS[bound]}{scaled(value, unit, readable):.3g}", readable)


def figure_text(figure: CharacteristicValue | None) -> str:
    """Return a characteristic value with its 95 % confidence interval, or a dash for None.

    The interval is omitted if it is negligible.

    Examples
    --------
    >>> figure_text(CharacteristicValue(0.01234, "s", "", uncertainty=5e-4, interval=(0.01136, 0.01332)))
    '12.34 ± 0.98 ms'
    """
    if figure is None:
        return "-"
    half = 0.5 * (figure.interval[1] - figure.interval[0]) if figure.interval is not None else 0.0
    if figure.interval is None or not half > MIN_UNCERTAINTY * abs(figure.value):
        return value_text(figure.value, figure.unit, figure.bound)
    readable = readable_unit(figure.unit, float(f"{figure.value:.3g}"))
    value, low, high = (scaled(size, figure.unit, readable) for size in (figure.value, *figure.interval))
    # Two significant digits of the uncertainty.
    digits = max(0, 1 - math.floor(math.log10(0.5 * (high - low))))
    if max(high - value, value - low) > 1.5 * min(high - value, value - low):
        return with_unit(f"{value:.{digits}f} +{high - value:.{digits}f} -{value - low:.{digits}f}", readable)
    return with_unit(f"{value:.{digits}f} ± {0.5 * (high - low):.{digits}f}", readable)


def conditions_text(figure: CharacteristicValue) -> str:
    """Return the test conditions of a characteristic value as text."""
    units = {"volume": "m^3", "flow": "kg/s", "frequency": "Hz", "lowest_supply": "Pa", "highest_supply": "Pa"}
    c = {key: value_text(value, units[key]) if key in units else value for key, value in figure.conditions.items()}
    return ", ".join(form.format_map(c) for key, form in _CONDITIONS.items() if key in c)


class _Sentences(NamedTuple):
    """Function object that inserts characteristic values into sentences.

    The result is empty if a value is missing. A phrase in square brackets is omitted if one of its values is missing.
    """

    figures: Mapping[str, CharacteristicValue]

    def __call__(self, form: str) -> str:
        form = re.sub(r"\[(.*?)\]", lambda part: part[1] if self._has_values(part[1]) else "", form)
        return re.sub(r"{(\w+)}", lambda name: _bounded(self.figures[name[1]]), form) if self._has_values(form) else ""

    def _has_values(self, form: str) -> bool:
        return set(re.findall(r"{(\w+)}", form)) <= set(self.figures)

    def value(self, name: str) -> float:
        """Return a characteristic value, or NaN if it is missing."""
        return self.figures[name].value if name in self.figures else math.nan


def _bounded(figure: CharacteristicValue) -> str:
    """Return a characteristic value for a sentence, for example `at most 0.5 % FS`."""
    return f"{figure.bound} {value_text(figure.value, figure.unit)}".strip()


def verdict(result: BenchResult, test: str) -> str:
    """Return the sentences that assess the results of one test."""
    return " ".join(sentence for sentence in DESCRIPTIONS[test].verdict(_Sentences(result.figures)) if sentence)


def _characteristic(w: _Sentences) -> Iterable[str]:
    span = f"Between {RANGE[0]:g} and {RANGE[1]:g} % FS the outlet is within"
    yield w(span + " {linearity} of a straight line, and within {accuracy} of the nominal line.")
    yield w("At the same setpoint, up and down differ by {hysteresis}[, and cycles by {repeatability}].")
    if w.value("zero_suppression") > _RELEVANT:
        yield w("The outlet leaves zero at a setpoint of {zero_suppression}.")
    if abs(w.value("zero_offset")) > _RELEVANT:
        yield w("At setpoint zero the outlet is at {zero_offset}.")


def _resolution(w: _Sentences) -> Iterable[str]:
    yield w("A change of the setpoint by {resolution} in the same direction moves the outlet.")
    yield w("A reversal takes a change of {reversal_threshold}.")


def _flow(w: _Sentences) -> Iterable[str]:
    yield w("At the rated forward flow the outlet pressure falls by {flow_droop}.")
    yield w(f"It has fallen by {DROOP:g} % FS at " + "{flow_capacity}.")
    yield w("At the rated relief flow the outlet pressure rises by {relief_rise}.")
    yield w("Increasing and decreasing flow differ by {flow_hysteresis} forward[ and {relief_hysteresis} in relief].")


def _supply(w: _Sentences) -> Iterable[str]:
    figure = w.figures.get("supply_sensitivity")
    if figure is not None:
        change = replace(figure, value=1e5 * abs(figure.value), unit="Pa")
        yield f"A change of the supply by 1 bar changes the outlet by {_bounded(change)}."


def _leakage(w: _Sentences) -> Iterable[str]:
    no_flow = "At rest there is no flow from the supply."
    yield no_flow if w.value("leakage") == 0.0 else w("At rest the valve takes {leakage} from the supply.")


def _step(w: _Sentences) -> Iterable[str]:
    case = w.figures.get("response_time_up") or w.figures.get("response_time_down")
    c = case.conditions if case else {}
    size = f" of {abs(c['to'] - c['from']):.3g} % FS" if "from" in c else ""
    times = " and ".join(filter(None, (w("{response_time_up} up"), w("{response_time_down} down"))))
    yield f"The step{size} takes {times} to {100 * HIGH:g} % of the change." if times else ""
    overshoots = "overshoots its end value by {overshoot} of a step"
    calm = "does not overshoot its end value"
    if "overshoot" in w.figures:
        yield w(f"The outlet {overshoots if w.value('overshoot') > _RELEVANT else calm}.")
    yield w("All steps settle within {settling_time}.")
    yield w("At rest the outlet oscillates by ± {hum_amplitude} at {hum_frequency}.")


def _frequency(w: _Sentences) -> Iterable[str]:
    figure = w.figures.get("bandwidth_gain") or w.figures.get("bandwidth_phase")
    case = f"For a sine of {conditions_text(figure)}" if figure else ""
    gain = f"{case} the amplitude has fallen by {-GAIN_DB:g} dB at "
    lag = f", and the outlet lags by {-PHASE_DEG:g}° at "
    yield w(gain + "{bandwidth_gain}[" + lag + "{bandwidth_phase}].")
    yield w("Harmonics reach {distortion} of the fundamental.")


_UNITS = {
    **dict.fromkeys(("largest_drawn", "capacity", "largest_fed", "flow"), "kg/s"),
    **dict.fromkeys(("lowest_supply", "highest_supply"), "Pa"),
    **dict.fromkeys(("delay", "rise_time", "response_time", "settling_time"), "s"),
    **dict.fromkeys(("overshoot", "distortion"), "%"),
    "record": "word", "sensitivity": "1", "volume": "m^3", "frequency": "Hz", "gain_db": "dB", "phase": "deg",
}  # fmt: skip
_HEADINGS = {
    "hysteresis_drawn": "hysteresis", "hysteresis_fed": "hysteresis", "largest_drawn": "largest forward flow",
    "largest_fed": "largest relief flow", "lowest_supply": "supply from", "highest_supply": "to",
    "sensitivity": "change of outlet per supply", "flow": "flow from the supply", "rise_time": "rise 10 - 90 %",
    "response_time": "response to 90 %", "settling_time": "settling", "outlet_to": "end value",
    "hum_amplitude": "hum ±", "amplitude": "setpoint ±", "outlet_amplitude": "outlet ±", "gain_db": "gain",
}  # fmt: skip
"""Headings of columns that differ from the words of their key."""


class SectionText(NamedTuple):
    """Texts of the section on one test: title, caption, verdict and table columns."""

    title: str
    caption: str
    verdict: Callable[[_Sentences], Iterable[str]]
    columns: tuple[str, ...] = ()  # keys of the table of cases
    headings: Mapping[str, str] = MappingProxyType({})

    def column(self, key: str) -> tuple[str, str]:
        """Return the heading and the unit of a table column.

        The unit of a column with texts is `word`.
        """
        return {**_HEADINGS, **self.headings}.get(key, key.replace("_", " ")), _UNITS.get(key, "% FS")


DESCRIPTIONS: Mapping[str, SectionText] = {
    "characteristic": SectionText(
        "Characteristic",
        "Left: mean of all cycles. Right: distance from the nominal line; faint: single cycles. The grey ends are not "
        "evaluated. The lag of the sweep is compensated.",
        _characteristic,
    ),
    "resolution": SectionText(
        "Resolution",
        "Small staircase of the setpoint, and the outlet.",
        _resolution,
        ("record", "stair", "resolution", "reversal_threshold"),
    ),
    "flow": SectionText(
        "Flow and relief",
        "Outlet pressure versus flow at several setpoints; thick: increasing flow, thin: decreasing flow.",
        _flow,
        (
            "setpoint", "outlet", "largest_drawn", "droop", "capacity", "hysteresis_drawn", "largest_fed", "rise",
            "hysteresis_fed",
        ),
        {"outlet": "outlet at rest"},
    ),
    "supply": SectionText(
        "Pressure regulation",
        "Change of the outlet versus the supply pressure at several setpoints; thick: rising, thin: falling.",
        _supply,
        ("record", "setpoint", "lowest_supply", "highest_supply", "sensitivity", "hysteresis"),
    ),
    "leakage": SectionText("Leakage", "", _leakage, ("record", "setpoint", "outlet", "flow")),
    "step": SectionText(
        "Step response",
        "Steps of several sizes, relative to the change of the outlet. Grey: settling band.",
        _step,
        (
            "volume", "from", "to", "delay", "rise_time", "response_time", "settling_time", "overshoot", "outlet_to",
            "hum_amplitude",
        ),
    ),
    "frequency": SectionText(
        "Frequency response",
        "Fundamental of the outlet relative to that of the setpoint. The lines mark -3 dB and -90°.",
        _frequency,
        ("frequency", "amplitude", "outlet_amplitude", "gain_db", "phase", "distortion"),
    ),
}  # fmt: skip
"""Mapping from the name of a test to the texts of its section."""
