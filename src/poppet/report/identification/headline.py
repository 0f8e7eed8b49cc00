"""An identification in short, for page and terminal: what was found, how well, and what to do next."""

from __future__ import annotations

from collections.abc import Iterable

from poppet.core.codes import Note
from poppet.core.message_format import sentence
from poppet.core.number_format import number, pretty, readable_unit, scaled, value_with_error
from poppet.identify import Result
from poppet.identify.result import VERDICTS, behind

SYMBOLS = {"sonic_conductance": "C", "critical_ratio": "b"}
"""What a headline shows of a passage; where nothing of it was sought, the first two numbers of the circuit."""
MINOR = ("table", "measured", "series", "signals")
"""First words of codes that say how a recording was read."""
NEXT = {
    "interrupted": ("finding.interrupted",),
    "unexplained": ("finding.unexplained",),
    "gauge": ("finding.gauge", "suspicion.read_as_absolute", "suspicion.read_as_gauge"),
    "heat": ("finding.optima.heat", "finding.laws.several"),
    "": ("finding.other_model.clear", "finding.other_model.doubt", "finding.other_model.alike", "finding.tell_apart"),
    "choked": ("finding.choking.throughout", "flow.choked_only"),
    "unchoked": ("finding.choking.never", "flow.none_choked"),
    "offset": ("finding.offset.widens",),
    "misfit": ("finding.residuals", "finding.local", "flow.residuals_too_large", "characteristic.misfit"),
    "bound": ("finding.number.bound", "flow.at_bound"),
    "longer": ("finding.number.not_determined", "finding.number.weak"),
}
"""What to do next by what was said, the most urgent first; nothing where the finding says it itself."""


def headline(result: Result, *, is_plain: bool = False) -> str:
    """C and b with their errors, and the verdict of all numbers; `is_plain` keeps to ASCII.

    Examples
    --------
    >>> from poppet.identify import Estimate
    >>> good = Estimate(1.1e-8, "m^3/(s Pa)", 1e-11, 1.08e-8, 1.12e-8, "determined")
    >>> poor = Estimate(0.3, "1", 0.2, 0.0, 0.7, "not determined")
    >>> headline(Result("fit", "", {"valve.sonic_conductance": good, "valve.critical_ratio": poor}))
    'C = 1.1000 ± 0.0010 dm³/(s bar), b = 0.30 ± 0.20 (not determined). Of 2 numbers 1 is determined, 1 is not.'
    """
    names = _shown(result)
    parts = [name.rpartition(".") for name in names]
    symbols = [SYMBOLS.get(local, "") for _, _, local in parts]
    texts = []
    for name, symbol, (owner, _, _) in zip(names, symbols, parts, strict=True):
        e = result.parameters[name]
        unit = readable_unit(e.unit, e.value)
        label = f"{symbol} of {owner}" if symbols.count(symbol) > 1 else symbol
        doubt = "" if e.verdict == "determined" else f" ({e.verdict})"
        size = value_with_error(e.value, e.standard_error, e.unit, unit)
        if apart := _apart(result, name):
            size, doubt = " or ".join(number(scaled(value, e.unit, unit)) for value in apart), ""
        texts.append(f"{label if symbol else name} = {size}{behind(unit if is_plain else pretty(unit))}{doubt}")
    text = f"{', '.join(texts)}. {verdicts(result)}" if texts else verdicts(result)
    return text.replace("±", "+/-") if is_plain else text


def _shown(result: Result) -> list[str]:
    if result.method == "characteristic":
        return []  # its coefficients mean little one by one
    recordings = result.conditions.get("recordings", ())
    own = [name for name in result.parameters if name.partition(".")[0] not in recordings]
    flow = [name for name in own if name.rpartition(".")[2] in SYMBOLS]
    return flow[:4] or own[:2]


def _apart(result: Result, name: str) -> list[float]:
    """Values of a number at places that fit alike, where these matter; what differs by less than 2 % is one."""
    found: list[float] = []
    if result.parameters[name].verdict != "determined":
        for optimum in result.optima:
            value = float(optimum["values"][name])
            if all(abs(value - other) > 0.02 * abs(other) for other in found):
                found.append(value)
    return found if len(found) > 1 else []


def verdicts(result: Result) -> str:
    """The verdict of all numbers in one sentence.

    Examples
    --------
    >>> from poppet.identify import Estimate
    >>> good = Estimate(1.0, "s", 0.01, 0.98, 1.02, "determined")
    >>> poor = Estimate(1.0, "s", 9.0, 0.0, 19.0, "not determined")
    >>> verdicts(Result("fit", "test", {"a": good, "b": poor}))
    'Of 2 numbers 1 is determined, 1 is not.'
    >>> verdicts(Result("fit", "test", {"a": good}))
    'The one number sought is determined.'
    """
    found = [e.verdict for e in result.parameters.values()]
    total = len(found)
    if not total:
        return "No number was sought."
    counts = {verdict: found.count(verdict) for verdict in VERDICTS if verdict in found}
    words = {"weak": "weakly determined", "at bound": "at a bound"}
    if len(counts) == 1:
        (verdict,) = counts
        if verdict == "not determined" and total > 1:
            return f"None of the {total} numbers is determined."
        who = "The one number sought is" if total == 1 else f"All {total} numbers are"
        return f"{who} {words.get(verdict, verdict)}."
    if list(counts) == ["determined", "not determined"]:  # no word twice
        words["not determined"] = "not"
    texts = [f"{n} {'is' if n == 1 else 'are'} {words.get(verdict, verdict)}" for verdict, n in counts.items()]
    return f"Of {total} numbers {', '.join(texts)}."


def next_step(result: Result) -> str:
    """What to do next, by the most urgent finding."""
    for word, codes in NEXT.items():
        for remark in result.remarks:
            if any(remark.code == code or remark.code.startswith(f"{code}.") for code in codes):
                return sentence(f"identification.next.{word}", {}) if word else str(remark)
    if result.method not in ("fit", "tank") or result.conditions.get("validation"):
        return ""
    return sentence("identification.next.held_out", {})


def sorted_out(remarks: Iterable[Note]) -> tuple[list[Note], list[Note]]:
    """What a reader has to know, and what only tells how the recordings were read."""
    given = list(remarks)
    is_minor = [remark.code.partition(".")[0] in MINOR for remark in given]
    major, minor = (
        [each for each, own in zip(given, is_minor, strict=True) if own is wanted] for wanted in (False, True)
    )
    return major, minor
