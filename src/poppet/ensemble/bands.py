"""Quantile bands of outputs versus time, computed from histograms.

A histogram counts the values of all runs at one time. Histograms of shards (groups of runs) can be added in any order.
Their memory does not depend on the number of runs.

Histograms of shards are added in any order, and their memory does not depend on the number of runs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, Integers

TIMES = 201
"""Maximum number of times at which bands are computed."""
BINS = 128
_MARGIN = 0.5
"""Margin on either side of the histogram, relative to the range of values in the first runs."""


def band_rows(grid: Array) -> Integers:
    """Return the indices of the output times at which histograms are counted.

    `grid` contains all output times. At most `TIMES` of them are selected, evenly by index.
    """
    return np.unique(np.linspace(0, grid.size - 1, min(TIMES, grid.size)).round().astype(np.int64))


def band_edges(plan: EnsemblePlan, grid: Array, pilot: Array) -> Array:
    """Return the lower and upper limits of the histograms, (n_curves, n_times, 2).

    `pilot` contains the outputs of the first runs, (m, n_curves, n_rows), at the output times `grid`, (n_rows,). The
    limits are the extremes of these outputs, widened on both sides. `band_rows` selects the n_times times of the
    histograms.
    """
    limits = np.zeros((len(plan.curves), band_rows(grid).size, 2))
    if len(pilot):
        samples = pilot[:, :, band_rows(grid)]
        low, high = np.nanmin(samples, axis=0), np.nanmax(samples, axis=0)
        # If all runs agree, the width of the bins is that of rounding.
        margin = np.maximum(_MARGIN * (high - low), 1e-9 * np.maximum(np.abs(low), np.abs(high)) + 1e-30)
        limits[..., 0], limits[..., 1] = low - margin, high + margin
    return limits


@dataclass(frozen=True)
class Bands:
    """Histograms of outputs over all runs: one histogram for each output and time."""

    curves: tuple[str, ...]
    time: Array  # (n_times,) [s]
    edges: Array  # (n_curves, n_times, 2)
    counts: NDArray[np.int64]  # (n_curves, n_times, BINS + 2); the first and the last count values outside the bins

    @staticmethod
    def of(plan: EnsemblePlan, grid: Array, limits: Array, values: Array) -> Bands:
        """Return the histograms of the outputs of several runs.

        `values` contains the outputs, (m, n_curves, n_rows), at the output times `grid`. `limits` contains the limits
        of the histograms, (n_curves, n_times, 2). Times after the end of a stopped run are not counted.
        """
        rows = band_rows(grid)
        counts = np.zeros((*limits.shape[:2], BINS + 2), dtype=np.int64)
        low, high = limits[..., 0], limits[..., 1]
        with np.errstate(invalid="ignore"):
            position = np.floor((values[:, :, rows] - low) / (high - low) * BINS)
        # Rows after the end of a stopped run are NaN and are not counted.
        for curve in range(counts.shape[0]):
            for k in range(rows.size):
                bins_of_runs = position[:, curve, k]
                bins = np.clip(bins_of_runs[~np.isnan(bins_of_runs)], -1, BINS).astype(np.int64) + 1
                counts[curve, k] = np.bincount(bins, minlength=BINS + 2)
        return Bands(plan.curves, grid[rows], limits, counts)

    def columns(self) -> dict[str, Any]:
        """Return the histograms as table columns by name, with one row for each output and time."""
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
        """Create histograms from the table columns that `Bands.columns` returns."""
        curves = tuple(dict.fromkeys(columns["curve"]))
        n = len(columns["curve"]) // max(len(curves), 1)
        limits = np.stack([np.asarray(columns["low"]), np.asarray(columns["high"])], axis=-1)
        counts = np.array(list(columns["counts"]), dtype=np.int64).reshape(len(curves), n, BINS + 2)
        return Bands(curves, np.asarray(columns["time"])[:n], limits.reshape(len(curves), n, 2), counts)

    def __add__(self, other: Bands) -> Bands:
        return Bands(self.curves, self.time, self.edges, self.counts + other.counts)

    def quantile(self, curve: str, u: float) -> Array:
        """Return a quantile of one output over all runs at each time, (n_times,).

        `curve` is the address of the output, and `u` is the probability from 0 to 1. Values are interpolated within a
        histogram bin. The result is infinite if the quantile is outside the limits of the histogram, and NaN if no run
        has a value.
        """
        index = self.curves.index(curve)
        counts, (low, high) = self.counts[index], self.edges[index].T
        total = counts.cumsum(axis=1)
        target = u * total[:, -1:]
        k = (total >= np.maximum(target, 1e-9)).argmax(axis=1)
        rows = np.arange(len(k))
        previous = np.where(k > 0, total[rows, np.maximum(k - 1, 0)], 0)
        with np.errstate(divide="ignore", invalid="ignore"):
            fraction = (target[:, 0] - previous) / counts[rows, k]
        value = low + (k - 1 + fraction) * (high - low) / BINS
        return np.where(total[:, -1] == 0, np.nan, np.where(k == 0, -np.inf, np.where(k == BINS + 1, np.inf, value)))
