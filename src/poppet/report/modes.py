"""The modes of a linear model as people read them: eigenvalues with time constants, frequencies and damping."""

from __future__ import annotations

import math

from poppet.circuit.linear_model import LinearModel

ROUNDING = 1e-13
"""Share of the largest eigenvalue below which a real one is zero."""


def mode_rows(linear: LinearModel) -> list[list[str]]:
    """A heading and a row for each real eigenvalue or conjugate pair, of a sampled model for its poles in time."""
    is_sampled = bool(getattr(linear, "sample_time", 0.0))
    rows = [["pole [1/s]" if is_sampled else "eigenvalue [1/s]", "time constant [s]", "frequency [Hz]", "damping"]]
    # Of a conjugate pair the upper one stands for both.
    modes = [complex(value) for value in linear.poles()]
    zero = ROUNDING * max(map(abs, modes), default=0.0)
    return rows + [_mode(value, zero) for value in modes if value.imag >= 0.0]


def _mode(value: complex, zero: float) -> list[str]:
    """One line per real eigenvalue or conjugate pair; what is not larger than `zero` is rounding."""
    size = abs(value)
    decay = -1.0 / value.real if value.real else math.inf
    if value.imag == 0.0:
        if size <= zero:
            return ["0", "integrates", "", ""]
        word = f"{decay:.5g}" if value.real < 0.0 else f"unstable, {-decay:.5g}"
        return [f"{value.real:.6g}", word, "", ""]
    shown = f"{decay:.5g}" if value.real < 0.0 else "unstable"
    return [
        f"{value.real:.6g} +- {value.imag:.6g}i",
        shown,
        f"{size / (2.0 * math.pi):.5g}",
        f"{-value.real / size:.4g}",
    ]
