"""Printer (code generator) of traced functions as structured text (IEC 61131-3).

Numbers are `LREAL`, comparisons `BOOL`. A value that is used once becomes part of the statement that uses it; other
values become variables, `v1`, `v2` and so on. Results are assigned at the end: a function can overwrite its arguments.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from poppet.engine.printers.instructions import Instruction

LONGEST = 100
"""Maximum length of a value inside another value, in characters."""

_FORMS = {
    "add": "{0} + {1}", "sub": "{0} - {1}", "mul": "{0} * {1}", "div": "{0} / {1}", "neg": "-{0}", "sq": "{0} * {0}",
    "twice": "2.0 * {0}", "inv": "1.0 / {0}", "fmin": "MIN({0}, {1})", "fmax": "MAX({0}, {1})", "sqrt": "SQRT({0})",
    "fabs": "ABS({0})", "exp": "EXP({0})", "log": "LN({0})", "sin": "SIN({0})", "cos": "COS({0})", "tan": "TAN({0})",
    "atan": "ATAN({0})", "floor": "poppet_floor({0})", "ceil": "-poppet_floor(-{0})", "pow": "poppet_power({0}, {1})",
    "sign": "SEL({0} > 0.0, SEL({0} < 0.0, 0.0, -1.0), 1.0)",
}  # fmt: skip
_FLAGS = {"lt": "{0} < {1}", "le": "{0} <= {1}", "eq": "{0} = {1}", "ne": "{0} <> {1}"}
_LOGIC = {"and": "{0} AND {1}", "or": "{0} OR {1}", "not": "NOT {0}"}
_TWICE = ("sq", "sign")
"""Operations whose form contains an argument twice."""

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


class UnsupportedOperationError(ValueError):
    """Error of an operation or constant that structured text does not support."""


class Value(NamedTuple):
    """Expression in structured text.

    If it is not an atom, such as a name or a number, it needs parentheses inside other expressions.
    """

    text: str
    is_flag: bool = False
    is_atom: bool = True
    # of a choice, `SEL(condition, 0.0, value)`: condition, True if the condition is negated, value
    choice: tuple[str, bool, str] | None = None
    negated: str = ""  # argument of a `not`

    @property
    def operand(self) -> str:
        """Expression as an operand of another expression, in parentheses if necessary."""
        return self.text if self.is_atom else f"({self.text})"

    @property
    def number(self) -> str:
        """Expression as a number.

        A condition is converted to 0 or 1.
        """
        return f"SEL({self.text}, 0.0, 1.0)" if self.is_flag else self.operand

    @property
    def flag(self) -> str:
        """Expression as a condition.

        A number is compared with zero.
        """
        return self.operand if self.is_flag else f"({self.operand} <> 0.0)"


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


class Statements:
    """Statements and variables of one function in structured text.

    Parameters
    ----------
    inputs, outputs : sequence of sequence of str
        Names of the elements of each argument and result.
    first : int
        Number of the first variable.
    flags : set of str
        Inputs of type `BOOL`.
    constants : mapping, optional
        Names of constants.
    """

    def __init__(
        self,
        inputs: Sequence[Sequence[str]],
        outputs: Sequence[Sequence[str]],
        first: int = 1,
        flags: frozenset[str] = frozenset(),
        constants: Mapping[float, str] | None = None,
    ) -> None:
        self.inputs, self.outputs, self.count, self.flags = inputs, outputs, first - 1, flags
        self.constants = constants or {}
        self.lines: list[str] = []
        self.variables: list[tuple[str, str]] = []  # name and type

    def read(self, function: Sequence[Instruction]) -> None:
        """Add statements for the instructions of the function."""
        # Number of times that the result of each instruction is read, and the last instruction that wrote each slot.
        uses, last = [0] * len(function), dict[int, int]()
        for k, instruction in enumerate(function):
            for slot in instruction.arguments:
                uses[last[slot]] += 1
            if instruction.operation == "assign":
                last[instruction.result] = last[instruction.arguments[0]]
            elif instruction.operation != "output":
                last[instruction.result] = k
        slots: dict[int, Value] = {}
        results: list[tuple[str, Value]] = []
        for k, instruction in enumerate(function):
            vector, element = instruction.place
            if instruction.operation == "output":
                results.append((self.outputs[vector][element], slots[instruction.arguments[0]]))
                continue
            value = self._value(instruction, [slots[slot] for slot in instruction.arguments])
            # Names, constants and negations need no variable.
            is_simple = instruction.operation in ("const", "not") or value.text.isidentifier()
            if not is_simple and (uses[k] != 1 or len(value.text) > LONGEST):
                value = self._variable(value)
            slots[instruction.result] = value
        written = {target for target, _ in results}
        assignments = []
        for target, value in results:
            if value.text != target:
                # A value that reads a result is computed before the assignments.
                reads_result = written & set(re.findall(r"\w+", value.text))
                assignments.append((target, self._variable(value) if reads_result else value))
        self.lines += [f"{target} := {value.number if value.is_flag else value.text};" for target, value in assignments]

    def _value(self, instruction: Instruction, arguments: list[Value]) -> Value:
        name = instruction.operation
        if name == "const":
            return Value(self.constants.get(instruction.constant) or literal(instruction.constant))
        if name == "input":
            element = self.inputs[instruction.place[0]][instruction.place[1]]
            return Value(element, element in self.flags)
        if name == "assign":
            return arguments[0]
        if name in _TWICE and not arguments[0].is_atom:
            arguments = [self._variable(arguments[0])]
        if name == "lt" and arguments[1].is_flag and arguments[0].text == "0.0":
            return arguments[1]
        if name in _LOGIC:
            text = _LOGIC[name].format(*(argument.flag for argument in arguments))
            return Value(text, True, False, negated=arguments[0].flag if name == "not" else "")
        if name in _FLAGS:
            return Value(_FLAGS[name].format(*(argument.number for argument in arguments)), True, False)
        if name == "if_else_zero":
            condition, value = arguments
            if value.is_flag:
                return Value(f"{condition.flag} AND {value.flag}", True, False)
            text = f"SEL({condition.text if condition.is_flag else condition.flag}, 0.0, {value.text})"
            return Value(text, choice=(condition.negated or condition.flag, bool(condition.negated), value.text))
        if name == "add":
            a, b = (argument.choice for argument in arguments)
            if a is not None and b is not None and a[0] == b[0] and a[1] != b[1]:
                # The sum of two choices with opposite conditions is a single choice.
                yes, no = (b, a) if a[1] else (a, b)
                return Value(f"SEL({yes[0]}, {no[2]}, {yes[2]})")
        if name not in _FORMS:
            raise UnsupportedOperationError(name)
        # An argument in the parentheses of a call needs no parentheses.
        is_call = re.match(r"\w+\(\{0\}(, \{1\})?\)$", _FORMS[name])
        text = _FORMS[name].format(*(a.text if is_call and not a.is_flag else a.number for a in arguments))
        return Value(text, is_atom=text.endswith(")") and "(" in _FORMS[name] and not text.startswith("-"))

    def _variable(self, value: Value) -> Value:
        """Assign an expression to a new variable, and return the name of the variable."""
        self.count += 1
        name = f"v{self.count}"
        self.variables.append((name, "BOOL" if value.is_flag else "LREAL"))
        self.lines.append(f"{name} := {value.text};")
        return Value(name, value.is_flag, negated=value.negated if value.negated.isidentifier() else "")
