"""Control design: tuning, stability margins, python-control, and comparison under uncertainty."""

import warnings

from poppet.control.comparison import Comparison, compare
from poppet.control.extraction import plant_of
from poppet.control.loop import Gains, Margins, SampledPlant, margins
from poppet.control.metrics import METRICS, metrics_in, step_metrics
from poppet.control.plant import OperatingPoint, Plant
from poppet.control.tuning import TunedPoint, Tuning, schedule, tune

__all__ = [
    "METRICS", "Comparison", "Gains", "Margins", "OperatingPoint", "Plant", "SampledPlant", "TunedPoint", "Tuning",
    "compare", "margins", "metrics_in", "plant_of", "schedule", "step_metrics", "tune",
]  # fmt: skip
_FORMER_NAMES = {"FIGURES": "METRICS", "figures_of": "step_metrics", "figures_in": "metrics_in"}


def __getattr__(name: str) -> object:
    if name not in _FORMER_NAMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    warnings.warn(f"poppet.control.{name} is now called {_FORMER_NAMES[name]}.", DeprecationWarning, stacklevel=2)
    return globals()[_FORMER_NAMES[name]]
