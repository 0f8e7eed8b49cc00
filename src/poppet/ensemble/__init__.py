"""Ensembles: runs of a circuit with uncertain parameters."""

from poppet.ensemble.bands import Bands
from poppet.ensemble.ensemble_plan import EnsemblePlan
from poppet.ensemble.ensemble_result import Ensemble, plan_of, run_ensemble, run_plan
from poppet.ensemble.influence import SobolIndex
from poppet.ensemble.sizing import Sizing, size
from poppet.ensemble.statistics import Summary, TornadoRange, Yield
from poppet.ensemble.worst_cases import WorstCase

__all__ = [
    "Bands",
    "Ensemble",
    "EnsemblePlan",
    "Sizing",
    "SobolIndex",
    "Summary",
    "TornadoRange",
    "WorstCase",
    "Yield",
    "plan_of",
    "run_ensemble",
    "run_plan",
    "size",
]
