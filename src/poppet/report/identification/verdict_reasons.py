"""Reasons for the verdicts on estimates, as text for a report."""

from __future__ import annotations

from poppet.core.message_format import sentence
from poppet.core.number_format import interval, readable_unit, with_unit
from poppet.identify.fit.statistics import OF_RATIOS
from poppet.identify.methods import METHODS
from poppet.identify.result import DETERMINED, WEAK, Result

WIDTH_CODES = ("finding.number.not_determined", "finding.number.weak", "flow.ratio_open")
"""Codes of the findings that state only that an interval is wide."""
CODES = (
    "finding.choking.throughout",
    "flow.choked_only",
    "flow.at_bound",
    "finding.number.bound",
    *WIDTH_CODES,
    "flow.scatter_only",
)
"""Codes of the findings that give the reason for a verdict, the most specific first."""


def verdict_limits(result: Result) -> dict[str, float]:
    """Return the limits of the verdicts in %, for parameters and for ratios such as b."""
    method = METHODS.get(result.method)
    ratios = OF_RATIOS if method and method.is_fit else (DETERMINED, WEAK)
    limits = {"determined": DETERMINED, "weak": WEAK, "ratio_determined": ratios[0], "ratio_weak": ratios[1]}
    return {name: 100.0 * limit for name, limit in limits.items()}


def verdict_reasons(result: Result) -> list[str]:
    """Return a text for each verdict other than `determined`.

    The text is the finding that explains the verdict. Without such a finding, it is the 95 % interval.
    """
    texts = []
    for name, estimate in result.parameters.items():
        if estimate.verdict == "determined":
            continue
        half, largest = 0.5 * (estimate.high - estimate.low), verdict_limits(result)["ratio_determined"]
        is_wide_ratio = name.endswith("critical_ratio") and estimate.verdict != "at bound" and half > 0.01 * largest
        limit = f" {sentence('identification.ratio', {'percent': largest, 'half': half})}" if is_wide_ratio else ""
        capping = result.conditions.get("capped", {}).get(name, ())
        reasons = (
            note
            for code in (*capping, *CODES)
            for note in result.remarks
            if note.code == code and (note.address == name or code in capping or name in note.facts.get("names", ()))
        )
        reason = next(reasons, None)
        if reason is not None:
            texts.append(f"{reason}{limit if reason.code in WIDTH_CODES else ''}")
        else:
            unit = readable_unit(estimate.unit, estimate.value)
            width = with_unit(interval(estimate.low, estimate.high, estimate.unit, unit), unit)
            texts.append(f"{name}: the 95 % interval is {width}.{limit}")
    return texts
