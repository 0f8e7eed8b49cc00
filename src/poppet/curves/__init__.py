"""Characteristics with a domain: curves over a stroke, and the C(x), b(x) of a variable passage."""

from poppet.curves.characteristic import EDGES, Characteristic
from poppet.curves.curve import Curve, rising_intervals
from poppet.curves.mapping import characteristic_from_mapping
from poppet.curves.pchip import pchip_slopes
from poppet.curves.shapes import ConstantCurve, PolynomialCurve, TableCurve

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
