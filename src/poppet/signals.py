"""Signals for the inputs of a circuit over time."""

import warnings

# The list of public names is that of the module; a copy here could become outdated.
from poppet.timeseries.signals import *  # noqa: F403
from poppet.timeseries.signals import SampledSignal
from poppet.timeseries.signals import __all__ as __all__


def __getattr__(name: str) -> type[SampledSignal]:
    if name == "Sampled":
        warnings.warn("poppet.signals.Sampled is now called SampledSignal.", DeprecationWarning, stacklevel=2)
        return SampledSignal
    raise AttributeError(f"module 'poppet.signals' has no attribute {name!r}")
