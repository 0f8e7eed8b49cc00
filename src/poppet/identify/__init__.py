"""Identification: from bench recordings to numbers with honest intervals."""

from poppet.identify.fit import Settings
from poppet.identify.free import Free, Prior
from poppet.identify.grey_box import identify_fit
from poppet.identify.result import Estimate, ResidualSummary, Result, read_result

__all__ = ["Estimate", "Free", "Prior", "ResidualSummary", "Result", "Settings", "identify_fit", "read_result"]
