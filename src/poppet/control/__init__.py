"""Controllers for circuits: tuning on the linear model, margins, python-control, fair comparison under uncertainty."""

from poppet.control.comparison import Comparison, compare
from poppet.control.extraction import plant_of
from poppet.control.loop import Gains, Margins, SampledPlant, margins
from poppet.control.metrics import METRICS, metrics_in, step_metrics
from poppet.control.plant import OperatingPoint, Plant
from poppet.control.tuning import TunedPoint, Tuning, schedule, tune

__all__ = [
    "METRICS",
    "Comparison",
    "Gains",
    "Margins",
    "OperatingPoint",
    "Plant",
    "SampledPlant",
    "TunedPoint",
    "Tuning",
    "compare",
    "margins",
    "metrics_in",
    "plant_of",
    "schedule",
    "step_metrics",
    "tune",
]
