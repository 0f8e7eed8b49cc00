"""Uncertainty caused by temperatures that neither circuits nor recordings state."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.core.codes import Note
from poppet.identify.ambient import SPREAD
from poppet.identify.characteristic.characteristic_fit import HistoryTerm
from poppet.identify.characteristic.stroke_tests import StrokeRecording, StrokeTest, TestEvidence, free_parameters

TEMPERATURE = "temperature"


@dataclass(frozen=True)
class AmbientUncertainty:
    """Relative standard uncertainties caused by assumed temperatures."""

    unstated: tuple[str, ...]  # addresses of these temperatures
    conductance: float  # common to all C
    shares: dict[str, float]  # by free parameter of the bench

    def note(self, names: Sequence[str]) -> Note:
        """Return a finding for the parameters whose intervals include the uncertainty."""
        facts = {"percent": 100.0 * self.conductance / SPREAD, "spread": SPREAD, "untold": self.unstated}
        return Note("characteristic.room", "sonic_conductance", **facts, names=tuple(names))


def ambient_uncertainty(tests: Sequence[StrokeTest], evidence: Sequence[TestEvidence]) -> AmbientUncertainty | None:
    """Return the uncertainty caused by unstated temperatures, or None if all are stated."""
    unstated, largest = list[str](), dict[str, float]()
    for test, test_evidence in zip(tests, evidence, strict=True):
        if isinstance(test, StrokeRecording) and (defaults := _default_temperatures(test)):
            unstated += defaults
            for name, shift in _relative_shifts(test, test_evidence, defaults).items():
                largest[name] = max(shift, largest.get(name, 0.0))
    if not unstated:
        return None
    conductance = max(shift for name, shift in largest.items() if name.endswith(".sonic_conductance"))
    return AmbientUncertainty(tuple(dict.fromkeys(unstated)), conductance, largest)


def _default_temperatures(test: StrokeRecording) -> dict[str, float]:
    """Return the temperatures of a circuit that are defaults, or nothing if a temperature is recorded."""
    recorded = [c.address for c in (*test.measurement.channels, *test.measurement.inputs)] + [*test.measurement.start]
    if any(address.endswith(TEMPERATURE) for address in recorded):
        return {}
    numbers = test.circuit.numbers().items()
    return {address: n.value for address, n in numbers if address.endswith(TEMPERATURE) and n.source.kind == "standard"}


def _relative_shifts(test: StrokeRecording, evidence: TestEvidence, defaults: dict[str, float]) -> dict[str, float]:
    """Return the relative shift of each free parameter for temperatures that are `SPREAD` higher, to first order."""
    assert evidence.optimum is not None
    x = evidence.optimum.x
    warm = test.circuit.with_values({address: value + SPREAD for address, value in defaults.items()})
    evaluations = [HistoryTerm(t, evidence).evaluate(x[:2], x[2:]) for t in (test, replace(test, circuit=warm))]
    (cold, slopes), (warmer, _) = evaluations
    shifts = np.linalg.lstsq(slopes * x, cold - warmer, rcond=None)[0]
    return {f.name: abs(float(m)) for f, m in zip(free_parameters(test), shifts, strict=True)}
