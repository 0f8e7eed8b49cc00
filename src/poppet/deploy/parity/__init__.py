"""One table of truth: the same run by every target, and how far each is from the kernel."""

from poppet.deploy.parity.table import Parity, Row, parity

__all__ = ["Parity", "Row", "parity"]
