"""Representation of values in Modbus registers: number types, word order, units and raw ranges."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass

from poppet.circuit.modbus_table import RegisterType


@dataclass(frozen=True)
class Representation:
    """Representation of a quantity in registers.

    The SI value is `scale` times the number in the registers, plus `zero`. Numbers outside `low` to `high` saturate in
    readings, and are invalid in writings. A value that is not a number is NaN, or the integer that SunSpec defines for
    it: the smallest one of a signed type, and the largest one of an unsigned type.
    """

    type: RegisterType
    scale: float = 1.0
    zero: float = 0.0
    low: float = -math.inf
    high: float = math.inf
    is_little: bool = False  # the least significant word is the first

    def encode(self, value: float) -> bytes:
        """Return the bytes of the registers for an SI value."""
        number = (value - self.zero) / self.scale
        if not math.isnan(number):
            number = min(max(number, self.low, self.type.low), self.high, self.type.high)
        elif self.type.is_integer:
            number = self.type.low or self.type.high
        data = struct.pack(f">{self.type.code}", round(number) if self.type.is_integer else number)
        return self._reordered(data)

    def decode(self, data: bytes) -> float | None:
        """Return the SI value of the bytes of the registers, or None if it is invalid."""
        number: float = struct.unpack(f">{self.type.code}", self._reordered(data))[0]
        if not (math.isfinite(number) and self.low <= number <= self.high):
            return None
        return self.zero + self.scale * number

    def _reordered(self, data: bytes) -> bytes:
        if not self.is_little:
            return data
        return b"".join(data[k : k + 2] for k in range(len(data) - 2, -2, -2))
