"""Many runs of a circuit with uncertain numbers: what they are, where they lie, what they tell."""

from poppet.ensemble.bands import Bands
from poppet.ensemble.influence import Index
from poppet.ensemble.plan import Plan
from poppet.ensemble.result import Ensemble, plan_of, run_ensemble, run_plan
from poppet.ensemble.sizing import Sizing, size
from poppet.ensemble.statistics import Range, Summary, Yield
from poppet.ensemble.worst import Case

__all__ = [
    "Bands",
    "Case",
    "Ensemble",
    "Index",
    "Plan",
    "Range",
    "Sizing",
    "Summary",
    "Yield",
    "plan_of",
    "run_ensemble",
    "run_plan",
    "size",
]
