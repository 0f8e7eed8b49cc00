"""Structured text (IEC 61131-3) of traced functions.

Numbers are `LREAL`, conditions `BOOL`. The statements are those of `poppet.engine.printers.statements`.
"""

from __future__ import annotations

import math

from poppet.engine.printers.statements import BlockForms, Language, UnsupportedOperationError

_OPERATIONS = {
    "add": "{0} + {1}", "sub": "{0} - {1}", "mul": "{0} * {1}", "div": "{0} / {1}", "neg": "-{0}", "sq": "{0} * {0}",
    "twice": "2.0 * {0}", "inv": "1.0 / {0}", "fmin": "MIN({0}, {1})", "fmax": "MAX({0}, {1})", "sqrt": "SQRT({0})",
    "fabs": "ABS({0})", "exp": "EXP({0})", "log": "LN({0})", "sin": "SIN({0})", "cos": "COS({0})", "tan": "TAN({0})",
    "atan": "ATAN({0})", "floor": "poppet_floor({0})", "ceil": "-poppet_floor(-{0})", "pow": "poppet_power({0}, {1})",
    "sign": "SEL({0} > 0.0, SEL({0} < 0.0, 0.0, -1.0), 1.0)",
}  # fmt: skip

FUNCTIONS = {
    "poppet_floor": """\
FUNCTION poppet_floor : LREAL
VAR_INPUT
  x : LREAL;
END_VAR
VAR
  r : LREAL;
END_VAR
(* Whatever way the conversion rounds; beyond 2**52 every number is whole. *)
r := x;
IF ABS(x) < 4.5E+15 THEN
  r := LINT_TO_LREAL(LREAL_TO_LINT(x));
  IF r > x THEN
    r := r - 1.0;
  END_IF;
END_IF;
poppet_floor := r;
END_FUNCTION
""",
    "poppet_power": """\
FUNCTION poppet_power : LREAL
VAR_INPUT
  x : LREAL;
  e : LREAL;
END_VAR
IF e = 0.5 THEN
  poppet_power := SQRT(x);
ELSIF e = -0.5 THEN
  poppet_power := 1.0 / SQRT(x);
ELSE
  poppet_power := EXPT(x, e);
END_IF;
END_FUNCTION
""",
}
"""Functions that the standard lacks or that differ between implementations, by their names in printed statements."""


def literal(value: float) -> str:
    """Return the structured text of a constant with all significant digits.

    Examples
    --------
    >>> literal(0.001), literal(1e300), literal(-5.0), literal(2e-5)
    ('0.001', '1.0E+300', '(-5.0)', '2.0E-05')
    """
    if not math.isfinite(value):
        raise UnsupportedOperationError(str(value))
    head, mark, tail = repr(abs(value)).upper().partition("E")
    text = f"{head if '.' in head else head + '.0'}{mark}{tail}"
    return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text


STRUCTURED_TEXT = Language(
    operations=_OPERATIONS,
    comparisons={"lt": "{0} < {1}", "le": "{0} <= {1}", "eq": "{0} = {1}", "ne": "{0} <> {1}"},
    reversed={"lt": "{1} > {0}", "le": "{1} >= {0}"},
    logic={"and": "{0} AND {1}", "or": "{0} OR {1}", "not": "NOT {0}", "true": "TRUE", "false": "FALSE"},
    literal=literal,
    choice="SEL({0}, {2}, {1})",
    non_zero="{0} <> 0.0",
    types=("LREAL", "BOOL"),
    declaration="{name} := {text};",
    assignment="{name} := {text};",
    comment="(* {text} *)",
    blocks=BlockForms(
        indent="",
        variable="{name} := {text};",
        switch="CASE LREAL_TO_INT({0}) OF",
        case="{0}: {1}",
        end_case=(),
        end_switch=("END_CASE;",),
        if_true="IF {0} THEN",
        else_if="ELSIF {0} THEN",
        otherwise="ELSE",
        end_if="END_IF;",
        has_last_else=False,
    ),
)
