"""Range of amplitudes in which the full model follows a linear model."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from poppet.bench.sine_rig import SineRig
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.linear_model import LinearModel
from poppet.core.errors import InputError
from poppet.parts.compound import Compound

__all__ = ["Agreement", "SineRig", "agreement", "without_bands"]

SCANNED = 13
"""Amplitudes that are tried first."""
BISECTIONS = 6

_BANDS = {
    "electronics": (
        "inner.hold_band", "inner.minimum_duty", "inner.vent_delay", "outer.dead_band", "outer.integral_band",
        "outer.integral_limit", "outer.correction_limit", "converter.bits",
    ),
    "pilot_stage": ("fill.opening_delay", "fill.closing_delay", "vent.opening_delay", "vent.closing_delay"),
}  # fmt: skip
"""By kind of part the numbers that are zero in a circuit without bands."""
_OPTIONS = {"pilot_stage": {"drive": "averaged"}}


@dataclass(frozen=True)
class Agreement:
    """Amplitudes at which the full model follows the linear model."""

    # Amplitudes of the input between which they agree, in its unit: 0 and infinity where they agree down and up to the
    # last one tried; both not a number where they agree nowhere.
    low: float
    high: float
    frequency: float  # of the sine [Hz]
    tolerance: float  # difference of the complex gains over that of the linear model that was allowed
    amplitudes: tuple[float, ...]  # what was tried
    differences: tuple[float, ...]  # and found


def without_bands(circuit: BaseCircuit) -> BaseCircuit:
    """Return the circuit with averaged solenoids and without bands, delays and quantisation."""
    changes: dict[str, float | str] = {}
    for name, part in circuit.parts.items():
        members = part.members if isinstance(part, Compound) else {"": part}
        for member, inner in members.items():
            path = f"{name}.{member}" if member else name
            changes |= {f"{path}.{key}": 0.0 for key in _BANDS.get(inner.kind, ())}
            changes |= {f"{path}.{key}": value for key, value in _OPTIONS.get(inner.kind, {}).items()}
    return circuit.with_values(changes)


def agreement(
    rig: SineRig, linear: LinearModel, frequency: float, amplitudes: tuple[float, float], *, tolerance: float = 0.1
) -> Agreement:
    """Return the range of amplitudes in which a circuit follows a linear model."""
    if not 0.0 < amplitudes[0] < amplitudes[1]:
        raise InputError("limits.amplitudes", given=amplitudes)
    model = rig.kernel.model
    names = model.inputs[rig.input].name, model.columns[0][rig.output]
    expected = complex(linear.frequency_response(frequency, *names)[0])

    def difference(amplitude: float) -> float:
        return float(abs(rig.response(amplitude, frequency).gain - expected) / abs(expected))

    candidates = np.geomspace(*amplitudes, SCANNED)
    differences = np.array([difference(a) for a in candidates])
    low = high = np.nan
    # First and last place of every unbroken run of amplitudes that agree.
    edges = np.flatnonzero(np.diff(np.concatenate([[0], (differences <= tolerance).astype(int), [0]])))
    if edges.size:
        first, end = max(zip(edges[::2], edges[1::2], strict=True), key=lambda run: run[1] - run[0])
        low = 0.0 if first == 0 else _edge(difference, candidates[first], candidates[first - 1], tolerance)
        high = np.inf if end == SCANNED else _edge(difference, candidates[end - 1], candidates[end], tolerance)
    return Agreement(low, high, frequency, tolerance, tuple(candidates.tolist()), tuple(differences.tolist()))


def _edge(difference: Callable[[float], float], inside: float, outside: float, tolerance: float) -> float:
    """Return the last amplitude that agrees, by bisection between `inside` and `outside`."""
    for _ in range(BISECTIONS):
        middle = float(np.sqrt(inside * outside))
        inside, outside = (middle, outside) if difference(middle) <= tolerance else (inside, middle)
    return inside
