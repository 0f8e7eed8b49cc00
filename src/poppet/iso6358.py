"""Flow after ISO 6358: law, inverse, conversions, combinations."""

# The room's own list of names is the one that counts; repeated here it could only fall behind.
from poppet.laws.iso6358 import *  # noqa: F403
from poppet.laws.iso6358 import __all__ as __all__
