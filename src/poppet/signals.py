"""Signals: what drives the inputs of a circuit over time."""

from poppet.series import signals as _series
from poppet.series.signals import *  # noqa: F403 - the names stand once, in the room

__all__ = []
__all__ += _series.__all__
