"""Fits of hypotheses to the readings since a fault began, for the verdicts of a watch."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from poppet.monitoring.baseline import Baseline
from poppet.monitoring.evidence import Hypothesis, WindowEvidence
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.hypotheses import fit_hypotheses
from poppet.monitoring.onsets import PER_DELAY
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.windows import Window

Array = NDArray[np.float64]


class WindowRefit:
    """Fits of hypotheses to the last readings of a filter.

    Each fit starts from the estimate of the filter before the fault, so it also uses the readings before it.

    Parameters
    ----------
    plan : WatchPlan
        Plan of the watch.
    baseline : Baseline
        Healthy values and noise.
    filter : PlantFilter
        Filter with its last readings.
    """

    def __init__(self, plan: WatchPlan, baseline: Baseline, filter: PlantFilter) -> None:
        self.plan, self.baseline, self.filter = plan, baseline, filter

    @cached_property
    def _window(self) -> Window:
        # Compiled at the first suspicion of a fault.
        return Window(self.plan, healthy=self.baseline.values, noise=self.baseline.noise)

    @cached_property
    def _growing_window(self) -> Window:
        return Window(self.plan, healthy=self.baseline.values, noise=self.baseline.noise, grows=True)

    def __call__(
        self, since: float, hypotheses: Sequence[Hypothesis], steps: Array, *, is_quick: bool = False
    ) -> WindowEvidence | None:
        """Return the fits of hypotheses to the readings since a time [s]; `steps` are approximate sizes, (f,) [SI].

        In a hypothesis, the index f + k means that fault k grows. If `is_quick`, only the best fit is accurate.

        The result is None if there are no readings, or if the model cannot be simulated.
        """
        arrival = self.filter.snapshot(since)
        samples = self.filter.samples(arrival.time)
        if not np.isfinite(samples.readings[samples.times > arrival.time]).any():
            return None
        spread = since - arrival.time + self.plan.alarm_delay / PER_DELAY
        grows = any(k >= len(self.plan.faults) for h in hypotheses for k in h)
        window = self._growing_window if grows else self._window
        evidence = fit_hypotheses(window, samples, arrival, hypotheses, steps, spread, is_quick=is_quick)
        return None if evidence is None else evidence._replace(before=arrival.squares)
