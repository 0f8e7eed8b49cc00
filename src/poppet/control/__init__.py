"""Controllers for circuits: tuning on the linear model, margins, python-control, fair comparison under uncertainty."""

from poppet.control.comparison import Comparison, compare
from poppet.control.extraction import plant_of
from poppet.control.loop import Gains, Margins, SampledPlant, margins
from poppet.control.metrics import FIGURES, figures_in, figures_of
from poppet.control.plant import OperatingPoint, Plant
from poppet.control.tuning import TunedPoint, Tuning, schedule, tune

__all__ = [
    "FIGURES",
    "Comparison",
    "Gains",
    "Margins",
    "OperatingPoint",
    "Plant",
    "SampledPlant",
    "TunedPoint",
    "Tuning",
    "compare",
    "figures_in",
    "figures_of",
    "margins",
    "plant_of",
    "schedule",
    "tune",
]
