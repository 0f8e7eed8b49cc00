"""Flow characteristics of variable flow paths: C and b as functions of the stroke."""

from poppet.laws.curves.characteristic import EDGES, Characteristic
from poppet.laws.curves.curve import Curve, rising_intervals
from poppet.laws.curves.mapping import characteristic_from_mapping
from poppet.laws.curves.pchip import pchip_slopes
from poppet.laws.curves.shapes import ConstantCurve, PolynomialCurve, TableCurve

__all__ = [
    "EDGES",
    "Characteristic",
    "ConstantCurve",
    "Curve",
    "PolynomialCurve",
    "TableCurve",
    "characteristic_from_mapping",
    "pchip_slopes",
    "rising_intervals",
]
