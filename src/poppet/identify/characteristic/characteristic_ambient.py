"""Temperatures that nobody states, among recordings at known strokes: how far they would move what is found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.core.codes import Note
from poppet.identify.ambient import SPREAD
from poppet.identify.characteristic.characteristic_fit import HistoryTerm
from poppet.identify.characteristic.stroke_tests import StrokeRecording, StrokeTest, TestEvidence, own_free

TEMPERATURE = "temperature"


@dataclass(frozen=True)
class AmbientUncertainty:
    """Relative standard uncertainties by temperatures that were taken as usual."""

    untold: tuple[str, ...]  # addresses of these temperatures
    conductance: float  # of all C together
    shares: dict[str, float]  # of each free number of the bench

    def note(self, names: Sequence[str]) -> Note:
        """What is said, of the numbers whose intervals allow for it."""
        facts = {"percent": 100.0 * self.conductance / SPREAD, "spread": SPREAD, "untold": self.untold}
        return Note("characteristic.room", "sonic_conductance", **facts, names=tuple(names))


def room_of(tests: Sequence[StrokeTest], evidence: Sequence[TestEvidence]) -> AmbientUncertainty | None:
    """What the temperatures change that neither circuits nor recordings state, if there are any."""
    untold, largest = list[str](), dict[str, float]()
    for test, own in zip(tests, evidence, strict=True):
        if isinstance(test, StrokeRecording) and (usual := _untold(test)):
            untold += usual
            for name, share in _shares(test, own, usual).items():
                largest[name] = max(share, largest.get(name, 0.0))
    if not untold:
        return None
    conductance = max(share for name, share in largest.items() if name.endswith(".sonic_conductance"))
    return AmbientUncertainty(tuple(dict.fromkeys(untold)), conductance, largest)


def _untold(test: StrokeRecording) -> dict[str, float]:
    """Temperatures of the circuit that are the usual one because nobody wrote another, if none was recorded."""
    recorded = [c.address for c in (*test.measurement.channels, *test.measurement.inputs)] + [*test.measurement.start]
    if any(address.endswith(TEMPERATURE) for address in recorded):
        return {}
    numbers = test.circuit.numbers().items()
    return {address: n.value for address, n in numbers if address.endswith(TEMPERATURE) and n.source.kind == "standard"}


def _shares(test: StrokeRecording, own: TestEvidence, usual: dict[str, float]) -> dict[str, float]:
    """By how much of itself each free number of a test moves, to first order, where all of them are `SPREAD` higher."""
    assert own.optimum is not None
    x = own.optimum.x
    warm = test.circuit.with_values({address: value + SPREAD for address, value in usual.items()})
    both = [HistoryTerm(t, own).evaluate(x[:2], x[2:]) for t in (test, replace(test, circuit=warm))]
    (cold, slopes), (warmer, _) = both
    moved = np.linalg.lstsq(slopes * x, cold - warmer, rcond=None)[0]
    return {f.name: abs(float(m)) for f, m in zip(own_free(test), moved, strict=True)}
