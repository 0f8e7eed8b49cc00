"""Two models of the same recordings, judged by the corrected information criterion."""

from __future__ import annotations

from dataclasses import replace

from poppet.ground.codes import notes_of
from poppet.ground.errors import InputError
from poppet.identify.result import Result

CLEAR, STRONG = 2.0, 10.0
"""Differences of AICc below which two models are alike, and above which one is clearly better."""


def compared(first: Result, second: Result, name: str) -> Result:
    """The first result with the comparison added."""
    if first.comparison["samples"] != second.comparison["samples"] or set(first.residuals) != set(second.residuals):
        raise InputError(
            f"compare = {name}",
            "was not fitted to the same channels and samples.",
            "Use the same [recordings] in both.",
        )
    difference = float(second.comparison["aicc"]) - float(first.comparison["aicc"])
    sentence = _sentence(first.title, f"{second.title} ({name})", difference)
    rms = {channel: summary.rms for channel, summary in second.residuals.items()}
    comparison = {
        **first.comparison,
        "other": name,
        "other_aicc": float(second.comparison["aicc"]),
        "other_free_numbers": second.comparison["free_numbers"],
        "aicc_difference": difference,
        "other_rms": rms,
        "verdict": sentence,
    }
    return replace(first, comparison=comparison, remarks=(*notes_of([sentence]), *first.remarks))


def _sentence(first: str, second: str, difference: float) -> str:
    size = abs(difference)
    if size < CLEAR:
        return f"{first} and {second} explain these data alike (AICc differs by {size:.1f})."
    better, worse = (first, second) if difference > 0.0 else (second, first)
    word = "clearly better than" if size > STRONG else "somewhat better than"
    return f"{better} explains these data {word} {worse} (AICc lower by {size:.1f})."
