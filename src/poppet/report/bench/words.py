"""What a bench has found, in words: one verdict per test, and figures as people write them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from poppet.bench.iso10094.definitions import DEFINITIONS, DROOP, GAIN_DB, HIGH, PHASE_DEG, RANGE
from poppet.bench.iso10094.evaluation import Figure
from poppet.bench.iso10094.result import BenchResult
from poppet.report.wording import readable_unit, scaled, with_unit

TITLES: Mapping[str, str] = {
    "characteristic": "Characteristic",
    "resolution": "Resolution",
    "flow": "Flow and relief",
    "supply": "Pressure regulation",
    "leakage": "Leakage",
    "step": "Step response",
    "frequency": "Frequency response",
}
_NOTHING = 1e-4
"""Per cent that nobody sees: the rounding of a solver."""
_SEEN = 0.05
"""Per cent from which a figure is worth a sentence."""
_SIGNS = {"at most": "≤ ", "at least": "≥ ", "": ""}


def value_text(value: float, unit: str, bound: str = "") -> str:
    """A figure with its unit and bound.

    Examples
    --------
    >>> value_text(0.0123, "s"), value_text(0.5, "% FS", "at most")
    ('12.3 ms', '≤ 0.5 % FS')
    """
    shown = readable_unit(unit, value)
    if unit in ("% FS", "%") and abs(value) < _NOTHING:
        value = 0.0
    return with_unit(f"{_SIGNS[bound]}{scaled(value, unit, shown):.3g}", shown)


def figure_text(figure: Figure | None) -> str:
    """A figure, or a dash for none."""
    return value_text(figure.value, figure.unit, figure.bound) if figure is not None else "-"


def conditions_text(figure: Figure) -> str:
    """What a figure holds for, in words."""
    c = figure.conditions
    parts = []
    if "from" in c:
        parts.append(f"step {c['from']:.3g} to {c['to']:.3g} % FS")
    if "at" in c:
        parts.append(f"at {c['at']:.3g} % FS")
    if "setpoint" in c:
        parts.append(f"setpoint {c['setpoint']:.3g} % FS")
    if "amplitude" in c:
        parts.append(f"± {c['amplitude']:.3g} % FS about {c['mean']:.3g} % FS")
    parts += [
        value_text(c[key], unit) for key, unit in (("volume", "m^3"), ("flow", "kg/s"), ("frequency", "Hz")) if key in c
    ]
    if "stair" in c:
        parts.append(f"stairs of {c['stair']:.2g} % FS")
    if "cycles" in c:
        parts.append(f"{c['cycles']} cycles")
    if "lowest_supply" in c:
        parts.append(f"supply {value_text(c['lowest_supply'], 'Pa')} to {value_text(c['highest_supply'], 'Pa')}")
    return ", ".join(parts)


def verdict(result: BenchResult, test: str) -> str:
    """What a test says of the valve."""
    return " ".join(sentence for sentence in _VERDICTS[test](_Words(result.figures)) if sentence)


class _Words:
    """Figures by name, as texts; a sentence of which a figure is missing is none."""

    def __init__(self, figures: Mapping[str, Figure]) -> None:
        self.figures = figures

    def say(self, form: str, *names: str) -> str:
        if any(name not in self.figures for name in names):
            return ""
        texts = []
        for name in names:
            figure = self.figures[name]
            text = value_text(figure.value, figure.unit)
            texts.append(f"{figure.bound} {text}".strip())
        return form.format(*texts)

    def value(self, name: str) -> float:
        return self.figures[name].value if name in self.figures else math.nan


def _ended(first: str, second: str = "") -> str:
    """A sentence with or without its second half; none without the first."""
    return f"{first}{second}." if first else ""


def _characteristic(w: _Words) -> list[str]:
    span = f"Between {RANGE[0]:g} and {RANGE[1]:g} % FS the outlet keeps within"
    sentences = [
        w.say(f"{span} {{}} of a straight line, and within {{}} of the nominal one.", "linearity", "accuracy"),
        _ended(
            w.say("Up and down differ by {} at the same setpoint", "hysteresis"),
            w.say(", cycles by {}", "repeatability"),
        ),
    ]
    if w.value("zero_suppression") > _SEEN:
        sentences.append(w.say("The outlet leaves zero at a setpoint of {}.", "zero_suppression"))
    if abs(w.value("zero_offset")) > _SEEN:
        sentences.append(w.say("At setpoint zero it stands at {}.", "zero_offset"))
    return sentences


def _resolution(w: _Words) -> list[str]:
    return [
        w.say("A change of the setpoint by {} in the same direction moves the outlet.", "resolution"),
        w.say("To turn it back takes {}.", "reversal_threshold"),
    ]


def _flow(w: _Words) -> list[str]:
    return [
        w.say("At the rated flow out of the outlet its pressure falls by {}.", "flow_droop"),
        w.say(f"It has fallen by {DROOP:g} % FS at {{}}.", "flow_capacity"),
        w.say("At the rated flow into it the pressure rises by {}.", "relief_rise"),
        _ended(
            w.say("There and back differ by {} out of the outlet", "flow_hysteresis"),
            w.say(" and {} into it", "relief_hysteresis"),
        ),
    ]


def _supply(w: _Words) -> list[str]:
    figure = w.figures.get("supply_sensitivity")
    if figure is None:
        return []
    change = value_text(1e5 * abs(figure.value), "Pa")
    return [f"A change of the supply by 1 bar changes the outlet by {f'{figure.bound} {change}'.strip()}."]


def _leakage(w: _Words) -> list[str]:
    if w.value("leakage") == 0.0:
        return ["At rest nothing flows from the supply."]
    return [w.say("At rest the valve takes {} from the supply.", "leakage")]


def _step(w: _Words) -> list[str]:
    case = w.figures.get("response_time_up") or w.figures.get("response_time_down")
    has_case = case is not None and "from" in case.conditions
    size = f" of {abs(case.conditions['to'] - case.conditions['from']):.3g} % FS" if case and has_case else ""
    ways = [w.say("{} up", "response_time_up"), w.say("{} down", "response_time_down")]
    taken = " and ".join(text for text in ways if text)
    sentences = [f"The step{size} takes {taken} to {100 * HIGH:g} % of the change." if taken else ""]
    if w.value("overshoot") > _SEEN:
        sentences.append(w.say("The outlet goes beyond its end value by {} of a step.", "overshoot"))
    else:
        sentences.append(w.say("The outlet does not go beyond its end value.", "overshoot"))
    sentences.append(w.say("All steps have settled after {} at the latest.", "settling_time"))
    sentences.append(w.say("At rest the outlet swings by ± {} at {}.", "hum_amplitude", "hum_frequency"))
    return sentences


def _frequency(w: _Words) -> list[str]:
    figure = w.figures.get("bandwidth_gain") or w.figures.get("bandwidth_phase")
    case = f"For a sine of {conditions_text(figure)}" if figure else ""
    return [
        _ended(
            w.say(f"{case} the amplitude has fallen by {-GAIN_DB:g} dB at {{}}", "bandwidth_gain"),
            w.say(f", and the outlet is {-PHASE_DEG:g}° late at {{}}", "bandwidth_phase"),
        ),
        w.say("Harmonics reach {} of the fundamental wave.", "distortion"),
    ]


_VERDICTS: Mapping[str, Callable[[_Words], list[str]]] = {
    "characteristic": _characteristic,
    "resolution": _resolution,
    "flow": _flow,
    "supply": _supply,
    "leakage": _leakage,
    "step": _step,
    "frequency": _frequency,
}


def name_text(name: str) -> str:
    """The name of a figure as people say it.

    Examples
    --------
    >>> name_text("rise_time_up")
    'rise time up'
    """
    assert name in DEFINITIONS
    return name.replace("_", " ")
