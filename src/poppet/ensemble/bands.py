"""Quantile bands of curves from counts: shards add up in any order, and memory does not grow with the runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, Integers

TIMES = 201
"""Rows of a curve at which bands are kept, at most."""
BINS = 128
_MARGIN = 0.5
"""By which part of the spread of the first runs the bins reach beyond them, on either side."""


def rows_of(grid: Array) -> Integers:
    """Which rows bands have."""
    return np.unique(np.linspace(0, grid.size - 1, min(TIMES, grid.size)).round().astype(np.int64))


def edges(plan: EnsemblePlan, grid: Array, pilot: Array) -> Array:
    """Lowest and highest edge of the bins, (n_curves, n_times, 2), from some runs, (m, n_curves, n_rows)."""
    found = np.zeros((len(plan.curves), rows_of(grid).size, 2))
    if len(pilot):
        seen = pilot[:, :, rows_of(grid)]
        low, high = np.nanmin(seen, axis=0), np.nanmax(seen, axis=0)
        # Where all runs agree, bins as wide as rounding.
        margin = np.maximum(_MARGIN * (high - low), 1e-9 * np.maximum(np.abs(low), np.abs(high)) + 1e-30)
        found[..., 0], found[..., 1] = low - margin, high + margin
    return found


@dataclass(frozen=True)
class Bands:
    """How many runs pass through each bin, and beside them all."""

    curves: tuple[str, ...]
    time: Array  # (n_times,) [s]
    edges: Array  # (n_curves, n_times, 2)
    counts: NDArray[np.int64]  # (n_curves, n_times, BINS + 2), the first and last beyond the bins

    @staticmethod
    def of(plan: EnsemblePlan, grid: Array, limits: Array, values: Array) -> Bands:
        """Of some runs, (m, n_curves, n_rows)."""
        rows = rows_of(grid)
        counts = np.zeros((*limits.shape[:2], BINS + 2), dtype=np.int64)
        low, high = limits[..., 0], limits[..., 1]
        with np.errstate(invalid="ignore"):
            place = np.floor((values[:, :, rows] - low) / (high - low) * BINS)
        # Rows behind the end of a run that stopped are not numbers and count nowhere.
        for curve in range(counts.shape[0]):
            for k in range(rows.size):
                own = place[:, curve, k]
                bins = np.clip(own[~np.isnan(own)], -1, BINS).astype(np.int64) + 1
                counts[curve, k] = np.bincount(bins, minlength=BINS + 2)
        return Bands(plan.curves, grid[rows], limits, counts)

    def columns(self) -> dict[str, Any]:
        """As columns of a table, one row for each curve and time."""
        n = self.time.size
        return {
            "curve": [name for name in self.curves for _ in range(n)],
            "time": np.tile(self.time, len(self.curves)),
            "low": self.edges[..., 0].ravel(),
            "high": self.edges[..., 1].ravel(),
            "counts": list(self.counts.reshape(-1, BINS + 2)),
        }

    @staticmethod
    def read(columns: Mapping[str, Any]) -> Bands:
        """From such columns."""
        curves = tuple(dict.fromkeys(columns["curve"]))
        n = len(columns["curve"]) // max(len(curves), 1)
        limits = np.stack([np.asarray(columns["low"]), np.asarray(columns["high"])], axis=-1)
        counts = np.array(list(columns["counts"]), dtype=np.int64).reshape(len(curves), n, BINS + 2)
        return Bands(curves, np.asarray(columns["time"])[:n], limits.reshape(len(curves), n, 2), counts)

    def __add__(self, other: Bands) -> Bands:
        return Bands(self.curves, self.time, self.edges, self.counts + other.counts)

    def quantile(self, curve: str, u: float) -> Array:
        """A quantile at every time, (n_times,), straight within a bin; infinite where it lies beside the bins."""
        at = self.curves.index(curve)
        counts, (low, high) = self.counts[at], self.edges[at].T
        total = counts.cumsum(axis=1)
        wanted = u * total[:, -1:]
        k = (total >= np.maximum(wanted, 1e-9)).argmax(axis=1)
        each = np.arange(len(k))
        before = np.where(k > 0, total[each, np.maximum(k - 1, 0)], 0)
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (wanted[:, 0] - before) / counts[each, k]
        value = low + (k - 1 + part) * (high - low) / BINS
        return np.where(total[:, -1] == 0, np.nan, np.where(k == 0, -np.inf, np.where(k == BINS + 1, np.inf, value)))
