"""Printer: the instructions of a traced function become statements of structured text (IEC 61131-3).

Numbers are `LREAL`, comparisons `BOOL`. A value that is used once stands in the statement that uses it; every other one
has a variable, `v1`, `v2` and so on. Results are assigned at the end, so that a function may write over what it reads.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from poppet.engine.printers.instructions import Instruction

LONGEST = 100
"""Characters of a value that may stand inside of another one."""

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
"""Operations whose form names an argument twice."""

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
"""What the standard has not, or not alike everywhere, by the name under which printed statements call it."""


class Unprintable(ValueError):
    """An operation or a constant that structured text has not."""


class Value(NamedTuple):
    """A value by its text: an atom can stand anywhere, and any other text wants parentheses."""

    text: str
    is_flag: bool = False
    is_atom: bool = True
    # of a choice, `SEL(condition, 0.0, value)`: both, and whether the condition is turned over
    choice: tuple[str, bool, str] | None = None
    turned: str = ""  # of a `not`: what it turns over

    @property
    def inner(self) -> str:
        """The text where something stands beside it."""
        return self.text if self.is_atom else f"({self.text})"

    @property
    def number(self) -> str:
        """The text of it as a number, where something stands beside it."""
        return f"SEL({self.text}, 0.0, 1.0)" if self.is_flag else self.inner

    @property
    def flag(self) -> str:
        """The text of it as a condition."""
        return self.inner if self.is_flag else f"({self.inner} <> 0.0)"


def literal(value: float) -> str:
    """A constant of which no digit is lost.

    Examples
    --------
    >>> literal(0.001), literal(1e300), literal(-5.0), literal(2e-5)
    ('0.001', '1.0E+300', '(-5.0)', '2.0E-05')
    """
    if not math.isfinite(value):
        raise Unprintable(str(value))
    head, mark, tail = repr(abs(value)).upper().partition("E")
    text = f"{head if '.' in head else head + '.0'}{mark}{tail}"
    return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text


class Statements:
    """Statements of one function, with the variables that they need.

    Parameters
    ----------
    inputs, outputs : sequence of sequence of str
        Name of each element of each argument and result.
    first : int
        Number of the first variable.
    flags : set of str
        Inputs that are `BOOL`.
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

    def read(self, every: Sequence[Instruction]) -> None:
        """Take the instructions of the function."""
        used = _uses(every)
        slots: dict[int, Value] = {}
        results: list[tuple[str, Value]] = []
        for number, each in enumerate(every):
            vector, element = each.place
            if each.operation == "output":
                results.append((self.outputs[vector][element], slots[each.arguments[0]]))
                continue
            value = self._value(each, [slots[slot] for slot in each.arguments])
            # A name or a constant is no work, and neither is to turn a flag over.
            is_plain = each.operation in ("const", "not") or value.text.isidentifier()
            if not is_plain and (used[number] != 1 or len(value.text) > LONGEST):
                value = self._kept(value)
            slots[each.result] = value
        self._assign(results)

    def _value(self, each: Instruction, given: list[Value]) -> Value:
        name = each.operation
        if name == "const":
            return Value(self.constants.get(each.constant) or literal(each.constant))
        if name == "input":
            own = self.inputs[each.place[0]][each.place[1]]
            return Value(own, own in self.flags)
        if name == "assign":
            return given[0]
        if name in _TWICE and not given[0].is_atom:
            given = [self._kept(given[0])]
        if name == "lt" and given[1].is_flag and given[0].text == "0.0":
            return given[1]
        if name in _LOGIC:
            text = _LOGIC[name].format(*(each.flag for each in given))
            return Value(text, True, False, turned=given[0].flag if name == "not" else "")
        if name in _FLAGS:
            return Value(_FLAGS[name].format(*(each.number for each in given)), True, False)
        if name == "if_else_zero":
            condition, value = given
            if value.is_flag:
                return Value(f"{condition.flag} AND {value.flag}", True, False)
            shown = condition.turned or condition.flag
            text = f"SEL({condition.text if condition.is_flag else condition.flag}, 0.0, {value.text})"
            return Value(text, choice=(shown, bool(condition.turned), value.text))
        if name == "add" and (chosen := _choice(*given)):
            return Value(chosen)
        if name not in _FORMS:
            raise Unprintable(name)
        text = _FORMS[name].format(*(_argument(_FORMS[name], each) for each in given))
        return Value(text, is_atom=text.endswith(")") and "(" in _FORMS[name] and not text.startswith("-"))

    def _kept(self, value: Value) -> Value:
        """The same value in a variable of its own."""
        self.count += 1
        name = f"v{self.count}"
        self.variables.append((name, "BOOL" if value.is_flag else "LREAL"))
        self.lines.append(f"{name} := {value.text};")
        return Value(name, value.is_flag, turned=value.turned if value.turned.isidentifier() else "")

    def _assign(self, results: list[tuple[str, Value]]) -> None:
        written = {target for target, _ in results}
        ready = []
        for target, value in results:
            if value.text == target:
                continue
            # What reads something that is written as well gets its value before any of them is written.
            ready.append((target, self._kept(value) if written & set(re.findall(r"\w+", value.text)) else value))
        self.lines += [f"{target} := {value.number if value.is_flag else value.text};" for target, value in ready]


def _argument(form: str, value: Value) -> str:
    """An argument of a form: between the parentheses of a call it wants none of its own."""
    return value.text if re.match(r"\w+\(\{0\}(, \{1\})?\)$", form) and not value.is_flag else value.number


def _choice(a: Value, b: Value) -> str:
    """The sum of two choices by one condition, of which one is turned over: one or the other."""
    if a.choice is None or b.choice is None or a.choice[0] != b.choice[0] or a.choice[1] == b.choice[1]:
        return ""
    yes, no = (b, a) if a.choice[1] else (a, b)
    assert yes.choice is not None
    assert no.choice is not None
    return f"SEL({yes.choice[0]}, {no.choice[2]}, {yes.choice[2]})"


def _uses(every: Sequence[Instruction]) -> list[int]:
    """How often the result of each instruction is read."""
    counts, last = [0] * len(every), dict[int, int]()
    for number, each in enumerate(every):
        for slot in each.arguments:
            counts[last[slot]] += 1
        if each.operation == "assign":
            last[each.result] = last[each.arguments[0]]
        elif each.operation != "output":
            last[each.result] = number
    return counts
