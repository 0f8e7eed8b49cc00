"""Headline, verdicts and recommended next step of an identification."""

from __future__ import annotations

from collections.abc import Iterable

from poppet.core.codes import Note
from poppet.core.message_format import sentence
from poppet.core.note_groups import code_of, explain_command, grouped
from poppet.core.number_format import number, pretty, readable_unit, scaled, value_with_error
from poppet.identify.methods import METHODS
from poppet.identify.result import VERDICTS, Result, unit_suffix

SYMBOLS = {"sonic_conductance": "C", "critical_ratio": "b"}
"""Symbols of the parameters in a headline; without such a parameter it shows the first two of the circuit."""
ALWAYS = ("finding.budget", "finding.exact")
"""Codes of findings that a terminal always shows."""
READING_CODES = ("table", "measured", "series", "signals")
"""First words of the codes on reading a recording."""
NEXT = {
    "interrupted": ("finding.interrupted",),
    "time": ("finding.unusual.closes", "finding.unusual.time", "suspicion.milliseconds"),
    "unexplained": ("finding.unexplained",),
    "gauge": ("finding.gauge", "suspicion.read_as_absolute", "suspicion.read_as_gauge"),
    "heat": ("finding.optima.heat", "finding.laws.several"),
    "": (
        "finding.other_model.clear",
        "finding.other_model.several",
        "finding.other_model.doubt",
        "finding.other_model.alike",
        "finding.tell_apart",
    ),
    "choked": ("finding.choking.throughout", "flow.choked_only"),
    "unchoked": ("finding.choking.never", "flow.none_choked"),
    "offset": ("finding.offset.widens",),
    "misfit": ("finding.residuals", "finding.local", "flow.residuals_too_large", "characteristic.misfit"),
    "bound": ("finding.number.bound", "flow.at_bound"),
    "longer": ("finding.number.not_determined", "finding.number.weak"),
}
"""Next step by the codes of findings, the most urgent first; empty if the finding itself names the step."""


def headline(result: Result, *, is_plain: bool = False) -> str:
    """Return the main parameters with their errors, and the verdicts, as one line of text.

    The main parameters are the sonic conductance C and the critical ratio b if they were identified. With the keyword
    `is_plain`, the text contains only ASCII characters.

    Examples
    --------
    >>> from poppet.identify import Estimate
    >>> good = Estimate(1.1e-8, "m^3/(s Pa)", 1e-11, 1.08e-8, 1.12e-8, "determined")
    >>> poor = Estimate(0.3, "1", 0.2, 0.0, 0.7, "not determined")
    >>> headline(Result("fit", "", {"valve.sonic_conductance": good, "valve.critical_ratio": poor}))
    'C = 1.1000 ± 0.0010 dm³/(s bar), b = 0.30 ± 0.20 (not determined). Of 2 parameters, 1 is determined, 1 is not.'
    """
    # Single coefficients of a curve have little meaning.
    method, recordings = METHODS.get(result.method), result.conditions.get("recordings", ())
    names = [name for name in result.parameters if name.partition(".")[0] not in recordings]
    names = [name for name in names if name.rpartition(".")[2] in SYMBOLS][:4] or names[:2]
    names = [] if method and method.has_coefficients else names
    fields = [name.rpartition(".")[2] for name in names]
    texts = []
    for name, field in zip(names, fields, strict=True):
        e = result.parameters[name]
        unit = readable_unit(e.unit, e.value)
        symbol = SYMBOLS.get(field, name)
        label = f"{symbol} of {name.rpartition('.')[0]}" if field in SYMBOLS and fields.count(field) > 1 else symbol
        verdict = "" if e.verdict == "determined" else f" ({e.verdict})"
        size = value_with_error(e.value, e.standard_error, e.unit, unit)
        distinct: list[float] = []  # values at equivalent optima that differ by more than 2 %
        for optimum in result.optima if verdict else ():
            value = float(optimum["values"][name])
            if all(abs(value - previous) > 0.02 * abs(previous) for previous in distinct):
                distinct.append(value)
        if len(distinct) > 1:
            size, verdict = " or ".join(number(scaled(value, e.unit, unit)) for value in distinct), ""
        texts.append(f"{label} = {size}{unit_suffix(unit if is_plain else pretty(unit))}{verdict}")
    text = f"{', '.join(texts)}. {verdict_counts(result)}" if texts else verdict_counts(result)
    return text.replace("±", "+/-") if is_plain else text


def verdict_counts(result: Result) -> str:
    """Return a sentence on how many parameters are determined.

    Examples
    --------
    >>> from poppet.identify import Estimate
    >>> good = Estimate(1.0, "s", 0.01, 0.98, 1.02, "determined")
    >>> poor = Estimate(1.0, "s", 9.0, 0.0, 19.0, "not determined")
    >>> verdict_counts(Result("fit", "test", {"a": good, "b": poor}))
    'Of 2 parameters, 1 is determined, 1 is not.'
    >>> verdict_counts(Result("fit", "test", {"a": good}))
    'The parameter is determined.'
    """
    names = [e.verdict for e in result.parameters.values()]
    total = len(names)
    if not total:
        return "There are no free parameters."
    counts = {verdict: names.count(verdict) for verdict in VERDICTS if verdict in names}
    phrases = {"weak": "weakly determined", "at bound": "at a bound"}
    if len(counts) == 1:
        (verdict,) = counts
        if verdict == "not determined" and total > 1:
            return f"None of the {total} parameters is determined."
        subject = "The parameter is" if total == 1 else f"All {total} parameters are"
        return f"{subject} {phrases.get(verdict, verdict)}."
    if list(counts) == ["determined", "not determined"]:
        phrases["not determined"] = "not"
    texts = [f"{n} {'is' if n == 1 else 'are'} {phrases.get(verdict, verdict)}" for verdict, n in counts.items()]
    return f"Of {total} parameters, {', '.join(texts)}."


def next_step(result: Result) -> str:
    """Return the next step that the most urgent finding suggests, as a sentence.

    If no finding suggests a step, the sentence suggests a validation. It is empty if the method is not a fit, or if the
    result includes a validation.
    """
    for key, codes in NEXT.items():
        for remark in result.remarks:
            if any(remark.code == code or remark.code.startswith(f"{code}.") for code in codes):
                return sentence(f"identification.next.{key}", {}) if key else str(remark)
    method = METHODS.get(result.method)
    if not (method and method.is_fit) or result.conditions.get("validation"):
        return ""
    return sentence("identification.next.held_out", {})


def split_notes(notes: Iterable[Note]) -> tuple[list[Note], list[Note]]:
    """Divide notes into findings, and notes about the reading of the recordings."""
    major: list[Note] = []
    minor: list[Note] = []
    for note in notes:
        (minor if note.code.partition(".")[0] in READING_CODES else major).append(note)
    return major, minor


def result_summary(result: Result, max_findings: int | None = None) -> str:
    """Return an identification result as text for a terminal.

    `max_findings` is the largest number of findings. If it is None, all findings are included.
    """
    step = next_step(result)
    lines = [result.title] * bool(result.title) + [headline(result, is_plain=True)]
    lines += [f"Next: {step}"] * bool(step) + result.lines()
    major, minor = split_notes(result.remarks)
    notes = [*major, *minor] if max_findings is None else [*grouped(major), *grouped(minor)]
    shown = [note for k, note in enumerate(notes) if max_findings is None or k < max_findings or note.code in ALWAYS]
    lines += [f"- {note}" for note in shown]
    if len(notes) > len(shown):
        lines.append(f"  ({len(notes) - len(shown)} more: --all, the page and the result file)")
    command = explain_command(map(code_of, shown))
    lines += [f"more: {command}"] * bool(command)
    return "\n".join(lines)
