"""Declaration of the table `[modbus]` of circuit files, which assigns Modbus addresses to quantities of the circuit."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from poppet.core.tables import Field, table_schema

AREAS = {"coil": "0", "discrete": "1", "input": "3", "holding": "4"}
"""Areas of Modbus addresses, with the first digit of their usual six-digit numbers."""
MAX_ADDRESS = 65535


class RegisterType(NamedTuple):
    """Number type of one or more registers."""

    code: str  # of the module `struct`
    words: int  # number of registers
    low: float
    high: float
    is_integer: bool = True


TYPES = {
    "uint16": RegisterType("H", 1, 0, 2**16 - 1),
    "int16": RegisterType("h", 1, -(2**15), 2**15 - 1),
    "uint32": RegisterType("I", 2, 0, 2**32 - 1),
    "int32": RegisterType("i", 2, -(2**31), 2**31 - 1),
    "float32": RegisterType("f", 2, -3.4028234663852886e38, 3.4028234663852886e38, is_integer=False),
    "float64": RegisterType("d", 4, -math.inf, math.inf, is_integer=False),
}
WORD_ORDERS = ("big", "little")
"""Orders of the words of a value: the most significant word first, or last. The bytes of a word are big-endian."""


def _address(meaning: str) -> Field:
    return Field(type="integer", low=0, high=MAX_ADDRESS, meaning=meaning)


REGISTER_FIELDS = {
    "coil": _address("address of a bit that clients read and write"),
    "discrete": _address("address of a bit that clients read"),
    "input": _address("first register that clients read"),
    "holding": _address("first register that clients read and write"),
    "type": Field(choices=tuple(TYPES), meaning="number type; float32 by default, int16 with raw"),
    "unit": Field(type="string", meaning="unit of the number in the registers; SI by default"),
    "raw": Field(meaning="integers at the ends of range, such as [0, 27648]"),
    "range": Field(meaning='values at the ends of raw, such as ["0 bar", "10 bar"]'),
    "word_order": Field(choices=WORD_ORDERS, meaning="order of the words of a number"),
}
"""Fields of one entry of `registers`."""
FIELDS = {
    "registers": Field(type="table", meaning="address of the quantity to its registers"),
    "word_order": Field(choices=WORD_ORDERS, default="big", meaning="order of the words of numbers"),
}
"""Fields of the table `modbus`."""


def modbus_schema() -> dict[str, Any]:
    """Return the JSON schema of the table."""
    entry = table_schema(REGISTER_FIELDS)
    pair = {"type": "array", "minItems": 2, "maxItems": 2}
    entry["properties"]["raw"] |= pair | {"items": {"type": "integer"}}
    entry["properties"]["range"] |= pair | {"items": {"type": ["number", "string"]}}
    entry["oneOf"] = [{"required": [area]} for area in AREAS]
    schema = table_schema(FIELDS)
    schema["properties"]["registers"] |= {"additionalProperties": entry}
    return schema | {"description": "registers of a served circuit; no effect on a run"}
