"""HTML report of a bench test on a valve: verdict, characteristic values, tests and conditions."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.bench.iso10094.bench_result import TESTS, BenchResult
from poppet.bench.iso10094.characteristic import RANGE
from poppet.bench.iso10094.evaluation import VERIFY, CharacteristicValue
from poppet.bench.iso10094.flow import DROOP
from poppet.bench.iso10094.frequency import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.step import HIGH
from poppet.core.number_format import readable_unit, scaled, with_unit
from poppet.report.bench import bench_figures
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, numeric, with_detail
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
    """Return a value with a readable unit as text.

    `bound` is `at most` or `at least` if the value is a bound, which the text shows by a sign.

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
    """Return a characteristic value with its 95 % confidence interval as text.

    The interval is omitted if it is negligible. The text for None is a dash.

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
    """Return the operating conditions of a characteristic value as text."""
    units = {"volume": "m^3", "flow": "kg/s", "frequency": "Hz", "lowest_supply": "Pa", "highest_supply": "Pa"}
    c = {key: value_text(value, units[key]) if key in units else value for key, value in figure.conditions.items()}
    return ", ".join(form.format_map(c) for key, form in _CONDITIONS.items() if key in c)


class _SentenceBuilder(NamedTuple):
    """Function object that inserts characteristic values into sentences.

    A sentence becomes empty if one of its values is missing. A phrase in square brackets is omitted if one of its own
    values is missing.
    """

    figures: Mapping[str, CharacteristicValue]

    def __call__(self, form: str, *, is_relevant: bool = True) -> str:
        if not is_relevant:
            return ""
        form = re.sub(r"\[(.*?)\]", lambda part: part[1] if self._has_values(part[1]) else "", form)
        return (
            re.sub(r"{(\w+)}", lambda name: _value_or_bound(self.figures[name[1]]), form)
            if self._has_values(form)
            else ""
        )

    def _has_values(self, form: str) -> bool:
        return set(re.findall(r"{(\w+)}", form)) <= set(self.figures)

    def value(self, name: str) -> float:
        """Return the characteristic value with the name `name`, or NaN if it is missing."""
        return self.figures[name].value if name in self.figures else math.nan


def _value_or_bound(figure: CharacteristicValue) -> str:
    """Return a characteristic value as text, such as `at most 0.5 % FS`."""
    return f"{figure.bound} {value_text(figure.value, figure.unit)}".strip()


def verdict_text(result: BenchResult, test: str) -> str:
    """Return sentences that summarise the results of one test."""
    w = _SentenceBuilder(result.figures)
    span = f"Between {RANGE[0]:g} and {RANGE[1]:g} % FS the outlet is within"
    sensitivity = w.figures.get("supply_sensitivity")
    change = replace(sensitivity, value=1e5 * abs(sensitivity.value), unit="Pa") if sensitivity else None
    step = w.figures.get("response_time_up") or w.figures.get("response_time_down")
    c = step.conditions if step else {}
    size = f" of {abs(c['to'] - c['from']):.3g} % FS" if "from" in c else ""
    times = " and ".join(filter(None, (w("{response_time_up} up"), w("{response_time_down} down"))))
    has_overshoot = w.value("overshoot") > _RELEVANT
    overshoot = (
        "overshoots its end value by {overshoot} of a step" if has_overshoot else "does not overshoot its end value"
    )
    sine = w.figures.get("bandwidth_gain") or w.figures.get("bandwidth_phase")
    case = f"For a sine of {conditions_text(sine)}" if sine else ""
    gain = f"{case} the amplitude has fallen by {-GAIN_DB:g} dB at "
    lag = f", and the outlet lags by {-PHASE_DEG:g}° at "
    flow_difference = "Increasing and decreasing flow differ by {flow_hysteresis} forward"
    sentences = {
        "characteristic": (
            w(span + " {linearity} of a straight line, and within {accuracy} of the nominal line."),
            w("At the same setpoint, up and down differ by {hysteresis}[, and cycles by {repeatability}]."),
            w(
                "The outlet leaves zero at a setpoint of {zero_suppression}.",
                is_relevant=w.value("zero_suppression") > _RELEVANT,
            ),
            w("At setpoint zero the outlet is at {zero_offset}.", is_relevant=abs(w.value("zero_offset")) > _RELEVANT),
        ),
        "resolution": (
            w("A change of the setpoint by {resolution} in the same direction moves the outlet."),
            w("A reversal takes a change of {reversal_threshold}."),
        ),
        "flow": (
            w("At the rated forward flow the outlet pressure falls by {flow_droop}."),
            w(f"It has fallen by {DROOP:g} % FS at " + "{flow_capacity}."),
            w("At the rated relief flow the outlet pressure rises by {relief_rise}."),
            w(flow_difference + "[ and {relief_hysteresis} in relief]."),
        ),
        "supply": (
            f"A change of the supply by 1 bar changes the outlet by {_value_or_bound(change)}." if change else "",
        ),
        "leakage": (
            "At rest there is no flow from the supply."
            if w.value("leakage") == 0.0
            else w("At rest the valve takes {leakage} from the supply."),
        ),
        "step": (
            f"The step{size} takes {times} to {100 * HIGH:g} % of the change." if times else "",
            w(f"The outlet {overshoot}.", is_relevant="overshoot" in w.figures),
            w("All steps settle within {settling_time}."),
            w("At rest the outlet oscillates by ± {hum_amplitude} at {hum_frequency}."),
        ),
        "frequency": (
            w(gain + "{bandwidth_gain}[" + lag + "{bandwidth_phase}]."),
            w("Harmonics reach {distortion} of the fundamental."),
        ),
    }
    return " ".join(filter(None, sentences[test]))


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
    """Texts of one section of the bench report: title, caption and table columns."""

    title: str
    caption: str
    columns: tuple[str, ...] = ()  # keys of the table of cases
    headings: Mapping[str, str] = MappingProxyType({})

    def column(self, key: str) -> tuple[str, str]:
        """Return heading and unit of a table column.

        `key` is the name of the value in the column. The unit of a column of texts is `word`.
        """
        return {**_HEADINGS, **self.headings}.get(key, key.replace("_", " ")), _UNITS.get(key, "% FS")


DESCRIPTIONS: Mapping[str, SectionText] = {
    "characteristic": SectionText(
        "Characteristic",
        "Left: mean of all cycles. Right: distance from the nominal line; faint: single cycles. The grey ends are not "
        "evaluated. The lag of the sweep is compensated.",
    ),
    "resolution": SectionText(
        "Resolution",
        "Small staircase of the setpoint, and the outlet.",
        ("record", "stair", "resolution", "reversal_threshold"),
    ),
    "flow": SectionText(
        "Flow and relief",
        "Outlet pressure versus flow at several setpoints; thick: increasing flow, thin: decreasing flow.",
        (
            "setpoint", "outlet", "largest_drawn", "droop", "capacity", "hysteresis_drawn", "largest_fed", "rise",
            "hysteresis_fed",
        ),
        {"outlet": "outlet at rest"},
    ),
    "supply": SectionText(
        "Pressure regulation",
        "Change of the outlet versus the supply pressure at several setpoints; thick: rising, thin: falling.",
        ("record", "setpoint", "lowest_supply", "highest_supply", "sensitivity", "hysteresis"),
    ),
    "leakage": SectionText("Leakage", "", ("record", "setpoint", "outlet", "flow")),
    "step": SectionText(
        "Step response",
        "Steps of several sizes, relative to the change of the outlet. Grey: settling band.",
        (
            "volume", "from", "to", "delay", "rise_time", "response_time", "settling_time", "overshoot", "outlet_to",
            "hum_amplitude",
        ),
    ),
    "frequency": SectionText(
        "Frequency response",
        "Fundamental of the outlet relative to that of the setpoint. The lines mark -3 dB and -90°.",
        ("frequency", "amplitude", "outlet_amplitude", "gain_db", "phase", "distortion"),
    ),
}  # fmt: skip
"""Mapping from the name of a test to the texts of its section."""

_FIGURES: Mapping[str, Callable[[BenchResult, BenchResult | None], Figure]] = {
    "characteristic": bench_figures.characteristic_figure,
    "resolution": bench_figures.resolution_figure,
    "flow": bench_figures.flow_figure,
    "supply": bench_figures.supply_figure,
    "step": bench_figures.step_figure,
    "frequency": bench_figures.bode_figure,
}
_SOURCES = {
    "circuit": "Virtual test bench: characteristic values of a simulated model.",
    "recordings": "Characteristic values of a valve from recordings of a bench.",
    "stand-in": "Characteristic values of a virtual valve with known properties.",
}
_WARNINGS = {"failed": "A test was not completed.", "interrupted": "The bench was interrupted."}
_STANDARD = (
    "<p>The tests follow the ideas of ISO 10094-1 and -2 (Pneumatic fluid power, electro-pneumatic pressure control "
    "valves). The definitions on this page were written without access to the standard. To state values according to "
    f"it, {VERIFY} first. The table above contains the definitions, bands and rates of these tests.</p>\n"
)


def write_bench(result: BenchResult, path: str | Path, other: BenchResult | None = None) -> Path:
    """Write the report of a bench result as HTML.

    `other` is the result of a second valve for comparison. Equal results give equal bytes.
    """
    return write_page(path, lambda: bench_page(result, other))


def bench_page(result: BenchResult, other: BenchResult | None = None) -> str:
    """Return the report of a bench result as HTML.

    `other` is the result of a second valve, whose values are also shown.
    """
    with style("A report of a bench"):
        tests = [test for test in TESTS if test in result.rows]
        c = result.conditions
        unit = str(c.get("setpoint_unit", ""))
        formats: tuple[tuple[str, str, Callable[[Any], str]], ...] = (
            ("setpoint_range", "setpoint range", lambda ends: _range(ends, unit)),
            ("full_scale", "full scale", lambda ends: f"{_range(ends, 'Pa')}, absolute"),
            ("supply_pressure", "supply pressure", lambda value: f"{value_text(value, 'Pa')}, absolute"),
            ("volumes", "volumes at the outlet", lambda values: ", ".join(value_text(v, "m^3") for v in values)),
            ("circuit", "circuit", str),
            ("valve", "valve", str),
            ("changed", "changed", ", ".join),
        )
        rows = [(heading, text(c[key])) for key, heading, text in formats if key in c]
        rows += [(f"recordings, {test}", ", ".join(names)) for test, names in c.get("recordings", {}).items()]
        sweep, flow = c.get("characteristic", {}), c.get("flow", {})
        if "sweep_rate" in sweep:
            branches = f"{sweep['branches_up']} up, {sweep['branches_down']} down"
            rows.append(("sweep of the setpoint", f"{sweep['sweep_rate']:.3g} % FS/s, {branches}"))
        directions = ("flow_drawn", "out"), ("flow_fed", "in")
        rows += [(f"rated flow {text}", value_text(flow[key], "kg/s")) for key, text in directions if key in flow]
        condition_table = ReportTable(("", ""), rows)
        sections = [
            Section("", _head(result, other, tests)),
            Section("Characteristic values", figure_table(result, other)),
            *(Section(DESCRIPTIONS[test].title, _test_section(result, other, test)) for test in tests),
            Section("Conditions", condition_table),
            Section("About the standard", _STANDARD),
        ]
    return document(result.title, sections, style=stylesheet("bench"))


def _head(result: BenchResult, reference: BenchResult | None, tests: list[str]) -> str:
    lines = "".join(
        f"<p><strong>{DESCRIPTIONS[test].title}</strong> <span>{html.escape(text)}</span></p>\n"
        for test in tests
        if (text := verdict_text(result, test))
    )
    lead = _SOURCES.get(result.source, result.source) + (f" Compared with: {reference.title}." if reference else "")
    notes = [*result.notes.get("bench", ()), *result.comparison.get("notes", ())]
    warning = paragraph(_WARNINGS.get(result.outcome, ""), bold=True)
    return f'{head(result.title, lead)}{warning}<div class="summary">{lines}</div>\n{findings(notes)}'


def _test_section(result: BenchResult, reference: BenchResult | None, test: str) -> list[str | ReportTable]:
    """Return the section of the report on one test: text, figure, notes and table.

    The table has one row for each case (test condition). `reference` is the result of a second valve for comparison.
    """
    description, meaning, rows = DESCRIPTIONS[test], TESTS[test].meaning, result.rows.get(test, ())
    figure = ""
    if result.curves.get(test) and test in _FIGURES:
        has_reference = reference is not None and reference.curves.get(test)
        caption = description.caption + (f" Dashed: {reference.title}." if reference and has_reference else "")
        figure = picture(_FIGURES[test](result, reference), test, caption, label=description.title)
    keys = [key for key in description.columns if any(key in row for row in rows)]
    columns = [description.column(key) for key in keys]
    cells = [
        [
            "-" if key not in row
            else _on_one_line(str(row[key]))
            if unit == "word"
            else _on_one_line(value_text(row[key], unit, row.get(f"{key}_bound", "")))
            for key, (_, unit) in zip(keys, columns, strict=True)
        ]
        for row in rows
    ]  # fmt: skip
    headings = [Column(heading, "" if unit == "word" else "s") for heading, unit in columns]
    text = paragraph(meaning)
    return [text, figure, findings(result.notes.get(test, ())), ReportTable(headings, cells if keys else ())]


def figure_table(result: BenchResult, reference: BenchResult | None = None) -> ReportTable:
    """Return a table of all characteristic values with their definitions.

    If `reference`, the result of a second valve, is given, further columns contain its values and the ratios.
    """
    rows: list[list[Any]] = []
    headings = ["value ± 95 %"]
    if reference is not None:
        titles = result.title, reference.title
        headings = [*(title if len(title) <= 28 else f"{title[:27]}…" for title in titles), "ratio"]
    for test, definition in TESTS.items():
        names = [name for name in definition.definitions if any(name in r.figures for r in (result, reference) if r)]
        if names:
            title = Markup(f"<strong>{html.escape(DESCRIPTIONS[test].title)}</strong>")
            rows.append([title, *([""] * (len(headings) + 1))])
        for name in names:
            values = [None if valve is None else valve.figures.get(name) for valve in (result, reference)]
            first, second = values
            value = first or second
            assert value is not None
            cells = [_on_one_line(figure_text(v)) for v in values[: 1 if reference is None else 2]]
            if reference is not None:
                ratio = "-"
                if first is not None and second is not None and not (first.bound or second.bound):
                    # A percentage at the level of rounding has no meaningful ratio.
                    is_zero = second.value == 0.0 or (second.unit in ("% FS", "%") and abs(second.value) < NOTHING)
                    ratio = "-" if is_zero else f"{first.value / second.value:.2f}"
                cells.append(ratio)
            rows.append([name.replace("_", " "), *cells, with_detail(conditions_text(value), value.definition)])
    return ReportTable(("quantity", *numeric(*headings), "conditions; definition"), rows, css_class="figures")


def _on_one_line(text: str) -> str:
    """Return a text with non-breaking spaces, so that it stays on one line."""
    return text.replace(" ", "\N{NO-BREAK SPACE}")


def _range(ends: Any, unit: str) -> str:
    return f"{value_text(float(ends[0]), unit)} to {value_text(float(ends[1]), unit)}"
