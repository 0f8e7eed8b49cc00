"""Flow after ISO 6358: law, inverse, conversions, combinations."""

from poppet.laws import iso6358 as _laws
from poppet.laws.iso6358 import *  # noqa: F403 - the names stand once, in the room

__all__ = []
__all__ += _laws.__all__
