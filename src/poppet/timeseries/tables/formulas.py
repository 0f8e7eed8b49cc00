"""Check of conversion formulas in measured files.

The package that reads MDF files evaluates such a formula as program code, so it must be plain arithmetic.
"""

from __future__ import annotations

import re
from typing import Any

MAX_LENGTH, MAX_POWERS, MAX_EXPONENT = 500, 3, 99.0
"""Limits of a formula: characters, number of powers, and exponent. Nested powers take unlimited time."""
_FUNCTIONS = (
    "sin", "cos", "tan", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan", "exp", "expm1", "log", "log10", "log1p",
    "sqrt", "abs",
)  # fmt: skip
_NUMBER = r"(?:\d{1,20}\.?\d{0,20}|\.\d{1,20})(?:[eE][+-]?\d{1,3})?"
_TOKEN = re.compile(rf"\s*({_NUMBER}|X1?\b|(?:{'|'.join(_FUNCTIONS)})(?=\s*\()|\*\*|[-+*/()])")


def is_arithmetic(formula: str) -> bool:
    """Return True if a formula contains only numbers, the variable X, arithmetic signs and elementary functions.

    Examples
    --------
    >>> is_arithmetic("2.5 * (X1 - 0.1) ** 2"), is_arithmetic("__import__('os')"), is_arithmetic("9**9**9")
    (True, False, False)
    """
    if len(formula) > MAX_LENGTH:
        return False
    tokens: list[str] = []
    end = 0
    text = formula.strip()
    while end < len(text):
        match = _TOKEN.match(text, end)
        if match is None:
            return False
        tokens.append(match[1])
        end = match.end()
    powers = [k for k, token in enumerate(tokens) if token == "**"]
    for k in powers:
        exponent, following = [*tokens[k + 1 : k + 3], "", ""][:2]
        if not re.fullmatch(_NUMBER, exponent) or float(exponent) > MAX_EXPONENT or following == "**":
            return False
    try:
        compile(text, "formula", "eval")
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        return False
    return len(powers) <= MAX_POWERS


def formulas_of(conversion: Any) -> list[str]:
    """Return all formulas of a conversion of an MDF channel, including nested conversions."""
    formulas, waiting, known = [], [conversion], set()
    while waiting:
        block = waiting.pop()
        if block is None or isinstance(block, str | bytes) or id(block) in known:
            continue
        known.add(id(block))
        formula = getattr(block, "formula", "")
        if formula:
            formulas.append(formula.decode("latin-1") if isinstance(formula, bytes) else str(formula))
        waiting += (getattr(block, "referenced_blocks", None) or {}).values()
    return formulas
