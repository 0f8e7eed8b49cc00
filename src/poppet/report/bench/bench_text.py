"""What a bench has found, in words: headings, captions and verdicts of its tests, and figures as people write them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.characteristic import RANGE
from poppet.bench.iso10094.definitions import DEFINITIONS
from poppet.bench.iso10094.evaluation import CharacteristicValue
from poppet.bench.iso10094.flow import DROOP
from poppet.bench.iso10094.frequency import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.step import HIGH
from poppet.core.number_format import readable_unit, scaled, with_unit

NOTHING = 1e-4
"""Per cent that nobody sees: the rounding of a solver."""
UNSEEN = 1e-4
"""Part of a figure by which nobody sees it move."""
_SEEN = 0.05
"""Per cent from which a figure is worth a sentence."""
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
    """A figure with its unit and bound.

    Examples
    --------
    >>> value_text(0.0123, "s"), value_text(0.5, "% FS", "at most")
    ('12.3 ms', '≤ 0.5 % FS')
    """
    # Rounded first: what is shown as 1 kPa must not be taken for 999.9999 Pa.
    shown = readable_unit(unit, float(f"{value:.3g}"))
    if unit in ("% FS", "%") and abs(value) < NOTHING:
        value = 0.0
    return with_unit(f"{_SIGNS[bound]}{scaled(value, unit, shown):.3g}", shown)


def figure_text(figure: CharacteristicValue | None) -> str:
    """A figure with what it may be off by in 95 of 100 cases, where that is seen; a dash for none.

    Examples
    --------
    >>> figure_text(CharacteristicValue(0.01234, "s", "", uncertainty=5e-4, interval=(0.01136, 0.01332)))
    '12.34 ± 0.98 ms'
    """
    if figure is None:
        return "-"
    half = half_width(figure)
    if not half > UNSEEN * abs(figure.value) or figure.interval is None:
        return value_text(figure.value, figure.unit, figure.bound)
    shown = readable_unit(figure.unit, float(f"{figure.value:.3g}"))
    value, low, high = (scaled(each, figure.unit, shown) for each in (figure.value, *figure.interval))
    # As many digits as two of what is not known.
    digits = max(0, 1 - math.floor(math.log10(0.5 * (high - low))))
    if max(high - value, value - low) > 1.5 * min(high - value, value - low):
        return with_unit(f"{value:.{digits}f} +{high - value:.{digits}f} -{value - low:.{digits}f}", shown)
    return with_unit(f"{value:.{digits}f} ± {0.5 * (high - low):.{digits}f}", shown)


def half_width(figure: CharacteristicValue) -> float:
    """Half of the interval of 95 %, in the unit of the figure; 0 where there is none."""
    return 0.5 * (figure.interval[1] - figure.interval[0]) if figure.interval is not None else 0.0


def conditions_text(figure: CharacteristicValue) -> str:
    """What a figure holds for, in words."""
    units = {"volume": "m^3", "flow": "kg/s", "frequency": "Hz", "lowest_supply": "Pa", "highest_supply": "Pa"}
    c = {key: value_text(value, units[key]) if key in units else value for key, value in figure.conditions.items()}
    return ", ".join(form.format_map(c) for key, form in _CONDITIONS.items() if key in c)


def name_text(name: str) -> str:
    """The name of a figure as people say it.

    Examples
    --------
    >>> name_text("rise_time_up")
    'rise time up'
    """
    assert name in DEFINITIONS
    return name.replace("_", " ")


class _Words(NamedTuple):
    """Makes sentences of figures: one of which a figure is missing is none, and so is such a part in brackets."""

    figures: Mapping[str, CharacteristicValue]

    def __call__(self, form: str) -> str:
        form = re.sub(r"\[(.*?)\]", lambda part: part[1] if self._knows(part[1]) else "", form)
        return re.sub(r"{(\w+)}", lambda name: _bounded(self.figures[name[1]]), form) if self._knows(form) else ""

    def _knows(self, form: str) -> bool:
        return set(re.findall(r"{(\w+)}", form)) <= set(self.figures)

    def value(self, name: str) -> float:
        return self.figures[name].value if name in self.figures else math.nan


def _bounded(figure: CharacteristicValue) -> str:
    """A figure within a sentence, with its bound in words."""
    return f"{figure.bound} {value_text(figure.value, figure.unit)}".strip()


def verdict(result: BenchResult, test: str) -> str:
    """What a test says of the valve."""
    return " ".join(sentence for sentence in SECTIONS[test].verdict(_Words(result.figures)) if sentence)


def _characteristic(w: _Words) -> Iterable[str]:
    span = f"Between {RANGE[0]:g} and {RANGE[1]:g} % FS the outlet keeps within"
    yield w(span + " {linearity} of a straight line, and within {accuracy} of the nominal one.")
    yield w("Up and down differ by {hysteresis} at the same setpoint[, cycles by {repeatability}].")
    if w.value("zero_suppression") > _SEEN:
        yield w("The outlet leaves zero at a setpoint of {zero_suppression}.")
    if abs(w.value("zero_offset")) > _SEEN:
        yield w("At setpoint zero it stands at {zero_offset}.")


def _resolution(w: _Words) -> Iterable[str]:
    yield w("A change of the setpoint by {resolution} in the same direction moves the outlet.")
    yield w("To turn it back takes {reversal_threshold}.")


def _flow(w: _Words) -> Iterable[str]:
    yield w("At the rated flow out of the outlet its pressure falls by {flow_droop}.")
    yield w(f"It has fallen by {DROOP:g} % FS at " + "{flow_capacity}.")
    yield w("At the rated flow into it the pressure rises by {relief_rise}.")
    yield w("There and back differ by {flow_hysteresis} out of the outlet[ and {relief_hysteresis} into it].")


def _supply(w: _Words) -> Iterable[str]:
    figure = w.figures.get("supply_sensitivity")
    if figure is not None:
        change = replace(figure, value=1e5 * abs(figure.value), unit="Pa")
        yield f"A change of the supply by 1 bar changes the outlet by {_bounded(change)}."


def _leakage(w: _Words) -> Iterable[str]:
    nothing = "At rest nothing flows from the supply."
    yield nothing if w.value("leakage") == 0.0 else w("At rest the valve takes {leakage} from the supply.")


def _step(w: _Words) -> Iterable[str]:
    case = w.figures.get("response_time_up") or w.figures.get("response_time_down")
    c = case.conditions if case else {}
    size = f" of {abs(c['to'] - c['from']):.3g} % FS" if "from" in c else ""
    taken = " and ".join(filter(None, (w("{response_time_up} up"), w("{response_time_down} down"))))
    yield f"The step{size} takes {taken} to {100 * HIGH:g} % of the change." if taken else ""
    beyond = "goes beyond its end value by {overshoot} of a step"
    calm = "does not go beyond its end value"
    if "overshoot" in w.figures:
        yield w(f"The outlet {beyond if w.value('overshoot') > _SEEN else calm}.")
    yield w("All steps have settled after {settling_time} at the latest.")
    yield w("At rest the outlet swings by ± {hum_amplitude} at {hum_frequency}.")


def _frequency(w: _Words) -> Iterable[str]:
    figure = w.figures.get("bandwidth_gain") or w.figures.get("bandwidth_phase")
    case = f"For a sine of {conditions_text(figure)}" if figure else ""
    fallen = f"{case} the amplitude has fallen by {-GAIN_DB:g} dB at "
    late = f", and the outlet is {-PHASE_DEG:g}° late at "
    yield w(fallen + "{bandwidth_gain}[" + late + "{bandwidth_phase}].")
    yield w("Harmonics reach {distortion} of the fundamental wave.")


_UNITS = {
    **dict.fromkeys(("largest_drawn", "capacity", "largest_fed", "flow"), "kg/s"),
    **dict.fromkeys(("lowest_supply", "highest_supply"), "Pa"),
    **dict.fromkeys(("delay", "rise_time", "response_time", "settling_time"), "s"),
    **dict.fromkeys(("overshoot", "distortion"), "%"),
    "record": "word", "sensitivity": "1", "volume": "m^3", "frequency": "Hz", "gain_db": "dB", "phase": "deg",
}  # fmt: skip
_HEADINGS = {
    "hysteresis_drawn": "hysteresis", "hysteresis_fed": "hysteresis", "largest_drawn": "largest flow out",
    "largest_fed": "largest flow in", "lowest_supply": "supply from", "highest_supply": "to",
    "sensitivity": "change of outlet per supply", "flow": "flow from the supply", "rise_time": "rise 10 - 90 %",
    "response_time": "response to 90 %", "settling_time": "settling", "outlet_to": "end value",
    "hum_amplitude": "hum ±", "amplitude": "setpoint ±", "outlet_amplitude": "outlet ±", "gain_db": "gain",
}  # fmt: skip
"""Headings of columns that are not the words of their key."""


class Section(NamedTuple):
    """What a page says of a test; `columns` are the keys that the table of its cases shows, some by other headings."""

    title: str
    caption: str
    verdict: Callable[[_Words], Iterable[str]]
    columns: tuple[str, ...] = ()
    headings: Mapping[str, str] = MappingProxyType({})

    def column(self, key: str) -> tuple[str, str]:
        """Heading and unit of a column, % FS for most; the unit `word` is that of texts."""
        return {**_HEADINGS, **self.headings}.get(key, key.replace("_", " ")), _UNITS.get(key, "% FS")


SECTIONS: Mapping[str, Section] = {
    "characteristic": Section(
        "Characteristic",
        "Left: the mean of all cycles. Right: its distance from the nominal line, magnified; faint: each cycle. The "
        "grey ends are not judged. The lag of the sweep is taken out.",
        _characteristic,
    ),
    "resolution": Section(
        "Resolution",
        "The small staircase of the setpoint and what the outlet makes of it.",
        _resolution,
        ("record", "stair", "resolution", "reversal_threshold"),
    ),
    "flow": Section(
        "Flow and relief",
        "Outlet pressure against flow at several setpoints; thick: to larger flow, thin: back.",
        _flow,
        (
            "setpoint", "outlet", "largest_drawn", "droop", "capacity", "hysteresis_drawn", "largest_fed", "rise",
            "hysteresis_fed",
        ),
        {"outlet": "outlet at rest"},
    ),
    "supply": Section(
        "Pressure regulation",
        "Change of the outlet over the supply pressure at several setpoints; thick: rising, thin: falling.",
        _supply,
        ("record", "setpoint", "lowest_supply", "highest_supply", "sensitivity", "hysteresis"),
    ),
    "leakage": Section("Leakage", "", _leakage, ("record", "setpoint", "outlet", "flow")),
    "step": Section(
        "Step response",
        "Steps of several sizes as parts of the change that the outlet makes. The grey band is that of settling.",
        _step,
        (
            "volume", "from", "to", "delay", "rise_time", "response_time", "settling_time", "overshoot", "outlet_to",
            "hum_amplitude",
        ),
    ),
    "frequency": Section(
        "Frequency response",
        "Fundamental wave of the outlet against that of the setpoint. The lines mark - 3 dB and - 90°.",
        _frequency,
        ("frequency", "amplitude", "outlet_amplitude", "gain_db", "phase", "distortion"),
    ),
}  # fmt: skip
"""Test to its part of the page."""
