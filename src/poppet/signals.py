"""Signals: what drives the inputs of a circuit over time."""

# The room's own list of names is the one that counts; repeated here it could only fall behind.
from poppet.series.signals import *  # noqa: F403
from poppet.series.signals import __all__ as __all__
