"""Figures of a run with loads as people read them: a table of strokes, and one of air, work and efficiency."""

from __future__ import annotations

import math
from itertools import islice

from poppet.circuit.load_metrics import BodyStroke, LoadMetrics

MOST_STROKES = 12
STROKES = "Strokes; their time is that from 2 % to 98 % of the travel."
ENERGY = "Air, work and efficiency: work of the actuators over the exergy of the air drawn."
_SIZES = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi), "m/s": ("mm/s", 1e3), "rad/s": ("deg/s", 180.0 / math.pi)}


def stroke_rows(figures: LoadMetrics) -> list[list[str]]:
    """A heading and a row for each stroke; of many the first ones."""
    heads = ["body", "begins [s]", "travel", "time [s]", "mean speed", "peak speed", "at the end stop"]
    rows = [_stroke_row(figures, stroke) for stroke in islice(figures.strokes, MOST_STROKES)]
    more = len(figures.strokes) - len(rows)
    return [heads, *rows, *([[f"and {more} more", *[""] * 6]] if more > 0 else [])]


def _stroke_row(figures: LoadMetrics, stroke: BodyStroke) -> list[str]:
    speed = f"{stroke.unit}/s"
    met = figures.met(stroke)
    end = _shown(abs(met.velocity), met.unit) if met else "none met"
    speeds = (_shown(each, speed) for each in (stroke.mean_speed, stroke.peak_speed))
    times = f"{stroke.start:.4g}", _shown(stroke.travel, stroke.unit), f"{stroke.duration:.4g}"
    return [stroke.body, *times, *speeds, end]


def _shown(value: float, unit: str) -> str:
    usual, size = _SIZES[unit]
    return f"{value * size:.4g} {usual}"


def energy_rows(figures: LoadMetrics) -> list[list[str]]:
    """Rows of what, value and unit."""
    rows = [
        ["air used", f"{figures.air_used * 1e3:.4g}", "l ANR"],
        ["exergy of the air drawn", f"{figures.exergy:.4g}", "J"],
        ["work of the actuators", f"{figures.work:.4g}", "J"],
        ["efficiency", f"{100.0 * figures.efficiency:.3g}", "%"],
    ]
    rows = [row for row in rows if row[1] != "nan"]
    for work in figures.works:
        parts = {"on the load": work.on_load, "lost in friction and end stops": work.lost, "given back": work.returned}
        least = 1e-6 * (figures.work + abs(work.on_load))
        rows += [[f"{work.body}: {what}", f"{value:.4g}", "J"] for what, value in parts.items() if abs(value) > least]
    if not math.isnan(figures.stored):
        rows.append(["exergy that the volumes have gained", f"{figures.stored:.4g}", "J"])
    return rows
