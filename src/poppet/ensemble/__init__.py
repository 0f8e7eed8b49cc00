"""Ensembles: runs of a circuit with uncertain parameters."""

import warnings

from poppet.ensemble.bands import Bands
from poppet.ensemble.catalogue_sizing import CatalogueSizing, CatalogueTrial, size_from_catalogue
from poppet.ensemble.ensemble_plan import EnsemblePlan
from poppet.ensemble.ensemble_result import Ensemble, WorstCase, plan_of, run_ensemble, run_plan
from poppet.ensemble.sizing import Sizing, size
from poppet.ensemble.statistics import SobolIndex, Summary, TornadoRange, Yield

__all__ = [
    "Bands",
    "CatalogueSizing",
    "CatalogueTrial",
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
    "size_from_catalogue",
]

_OLD_NAMES = {"Plan": EnsemblePlan, "Index": SobolIndex, "Range": TornadoRange, "Case": WorstCase}
"""Old names, which work until version 1.0."""


def __getattr__(name: str) -> object:
    if name not in _OLD_NAMES:
        raise AttributeError(f"module 'poppet.ensemble' has no attribute {name!r}")
    renamed = _OLD_NAMES[name]
    message = f"poppet.ensemble.{name} is now called {renamed.__name__}."
    warnings.warn(message, DeprecationWarning, stacklevel=2)
    return renamed
