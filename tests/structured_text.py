"""Evaluator of the subset of structured text that `function_block` writes, for tests.

It is not a compiler of IEC 61131-3. It reads only the text, with a grammar of its own, and is stricter than a PLC: a
division by zero, the root of a negative number and an implicit conversion of types are errors.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

_TOKEN = re.compile(
    r"\s*(?:\(\*.*?\*\)\s*)*(?:(?P<real>\d+\.\d+(?:E[+-]?\d+)?)|(?P<whole>\d+)|(?P<word>[A-Za-z_]\w*)"
    r"|(?P<sign>:=|<=|>=|<>|[-+*/=<>();:,]))",
    re.DOTALL,
)
_TYPES = {"LREAL": float, "BOOL": bool, "INT": int, "LINT": int}
_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "SEL": lambda g, a, b: b if g else a,
    "MIN": min,
    "MAX": max,
    "ABS": abs,
    "SQRT": math.sqrt,
    "EXP": math.exp,
    "LN": math.log,
    "SIN": math.sin,
    "COS": math.cos,
    "TAN": math.tan,
    "ATAN": math.atan,
    "EXPT": math.pow,
    "LREAL_TO_LINT": round,
    "LREAL_TO_INT": round,
    "LINT_TO_LREAL": float,
}
Run = Callable[[dict[str, Any]], Any]
"""Function of the variables for an expression or a statement."""


class FunctionBlock:
    """Instance of the function block in a text.

    Parameters
    ----------
    text : str
        One function block after the functions that it calls.

    Examples
    --------
    >>> block = FunctionBlock('''FUNCTION_BLOCK twice
    ... VAR_INPUT
    ...   x : LREAL := 1.0;
    ... END_VAR
    ... VAR_OUTPUT
    ...   y : LREAL;
    ... END_VAR
    ... IF x > 0.0 THEN
    ...   y := 2.0 * x;
    ... END_IF;
    ... END_FUNCTION_BLOCK
    ... ''')
    >>> block(x=3.0)
    {'y': 6.0}
    """

    def __init__(self, text: str) -> None:
        reader = TextParser(text)
        while reader.word == "FUNCTION":
            reader.function()
        reader.expect("FUNCTION_BLOCK")
        self.name = reader.take()
        self.kinds = reader.declarations()
        self._body = reader.statements("END_FUNCTION_BLOCK")
        reader.expect("END_FUNCTION_BLOCK")
        reader.end()
        self.values: dict[str, Any] = {name: start for name, (_, _, start) in self.kinds.items()}

    def names(self, kind: str) -> list[str]:
        """Return the declared names of `VAR_INPUT` or `VAR_OUTPUT`."""
        return [name for name, (section, _, _) in self.kinds.items() if section == kind]

    def __call__(self, **inputs: Any) -> dict[str, Any]:
        """Call the block and return its outputs; omitted inputs keep their values."""
        for name, value in inputs.items():
            section, own, _ = self.kinds[name]
            assert section == "VAR_INPUT", name
            self.values[name] = own(value)
        # Temporary variables have no value from a previous call.
        for name in self.names("VAR_TEMP"):
            self.values[name] = None
        self._body(self.values)
        return {name: self.values[name] for name in self.names("VAR_OUTPUT")}


class TextParser:
    """Parser of a text; names are looked up in any case."""

    def __init__(self, text: str) -> None:
        self.tokens = list(_tokens(text))
        self.place = 0
        self.known: dict[str, str] = {}
        self.types: dict[str, type] = {}
        self.functions = dict(_FUNCTIONS)

    @property
    def word(self) -> str:
        """Next token in capitals."""
        return self.tokens[self.place].upper() if self.place < len(self.tokens) else ""

    def take(self) -> str:
        """Return the next token as written."""
        self.place += 1
        return self.tokens[self.place - 1]

    def expect(self, *words: str) -> None:
        """Read the expected words."""
        for word in words:
            if self.word != word:
                raise SyntaxError(f"{word} expected at {self.tokens[self.place : self.place + 8]}")
            self.place += 1

    def end(self) -> None:
        """Check that no token is left."""
        if self.word:
            raise SyntaxError(f"end expected at {self.word}")

    # Declarations ------------------------------------------------------------------------------------------------

    def function(self) -> None:
        """Read a function."""
        self.expect("FUNCTION")
        name = self.take()
        self.expect(":")
        kind = _TYPES[self.take().upper()]
        own = self.declarations({name: ("RESULT", kind, kind())})
        body = self.statements("END_FUNCTION")
        self.expect("END_FUNCTION")
        inputs = [each for each, (section, _, _) in own.items() if section == "VAR_INPUT"]

        def run(*given: Any) -> Any:
            values = {each: start for each, (_, _, start) in own.items()}
            values.update(zip(inputs, given, strict=True))
            body(values)
            return values[name]

        self.functions[name.upper()] = run

    def declarations(
        self, known: Mapping[str, tuple[str, type, Any]] | None = None
    ) -> dict[str, tuple[str, type, Any]]:
        """Read the declarations; return section, type and start value of each variable by name."""
        found = dict(known or {})
        while self.word in ("VAR", "VAR_INPUT", "VAR_OUTPUT", "VAR_TEMP"):
            section = self.take().upper()
            while self.word != "END_VAR":
                name = self.take()
                if name.upper() in {each.upper() for each in found}:
                    raise SyntaxError(f"{name} is declared twice")
                self.expect(":")
                kind = _TYPES[self.take().upper()]
                start = kind()
                if self.word == ":=":
                    self.take()
                    start = kind(self.expression()({}))
                self.expect(";")
                found[name] = (section, kind, start)
            self.expect("END_VAR")
        self.known = {name.upper(): name for name in found}
        self.types = {name: kind for name, (_, kind, _) in found.items()}
        return found

    # Statements --------------------------------------------------------------------------------------------------

    def statements(self, *ends: str) -> Run:
        """Read statements up to one of some words."""
        found: list[Run] = []
        while self.word not in ends:
            found.append(self._statement())

        def run(values: dict[str, Any]) -> None:
            for each in found:
                each(values)

        return run

    def _statement(self) -> Run:
        if self.word == "IF":
            return self._choice()
        if self.word == "CASE":
            return self._case()
        if self.word == ";":
            self.take()
            return lambda values: None
        if self.word == "WHILE":
            self.take()
            condition = self.expression()
            self.expect("DO")
            body = self.statements("END_WHILE")
            self.expect("END_WHILE", ";")

            def loop(values: dict[str, Any]) -> None:
                while condition(values):
                    body(values)

            return loop
        name = self._name()
        self.expect(":=")
        value = self.expression()
        self.expect(";")
        kind = self.types[name]

        def assign(values: dict[str, Any]) -> None:
            found = value(values)
            # There is no implicit conversion, as in the standard.
            if type(found) is not kind:
                raise TypeError(f"{name} is {kind.__name__}, not {found!r}")
            values[name] = found

        return assign

    def _choice(self) -> Run:
        cases: list[tuple[Run, Run]] = []
        otherwise: Run | None = None
        self.expect("IF")
        while True:
            condition = self.expression()
            self.expect("THEN")
            cases.append((condition, self.statements("ELSIF", "ELSE", "END_IF")))
            if self.word != "ELSIF":
                break
            self.take()
        if self.word == "ELSE":
            self.take()
            otherwise = self.statements("END_IF")
        self.expect("END_IF", ";")

        def run(values: dict[str, Any]) -> None:
            body = next((own for condition, own in cases if condition(values)), otherwise)
            if body is not None:
                body(values)

        return run

    def _case(self) -> Run:
        """Read a CASE statement whose labels are single integers."""
        self.expect("CASE")
        selector = self.expression()
        self.expect("OF")
        bodies: dict[int, Run] = {}
        while self.word != "END_CASE":
            label = int(self.take())
            self.expect(":")
            if label in bodies:
                raise SyntaxError(f"case {label} is written twice")
            start = self.place
            statements: list[Run] = []
            # A number begins the next case.
            while not (self.word.isdigit() or self.word == "END_CASE"):
                statements.append(self._statement())
            if self.place == start:
                raise SyntaxError(f"case {label} has no statement")
            bodies[label] = _in_order(statements)
        self.expect("END_CASE", ";")

        def run(values: dict[str, Any]) -> None:
            number = selector(values)
            if type(number) is not int:
                raise TypeError(f"the selector {number!r} is no INT")
            # Every step is a case: a number without one is an error of the printer.
            bodies[number](values)

        return run

    # Expressions, lowest precedence first -------------------------------------------------------------------------

    def expression(self) -> Run:
        """Read an expression with the precedence of the standard."""
        return self._joined(0)

    def _joined(self, level: int) -> Run:
        if level == len(_LEVELS):
            return self._single()
        left = self._joined(level + 1)
        while self.word in _LEVELS[level]:
            act, right, before = _LEVELS[level][self.take().upper()], self._joined(level + 1), left

            def left(values: dict[str, Any], act: Any = act, a: Run = before, b: Run = right) -> Any:
                return act(a(values), b(values))

        return left

    def _single(self) -> Run:
        word = self.take()
        if word == "-":
            inner = self._single()
            return lambda values: -inner(values)
        if word.upper() == "NOT":
            inner = self._single()
            return lambda values: not _flag(inner(values))
        if word == "(":
            inner = self.expression()
            self.expect(")")
            return inner
        if word.upper() in ("TRUE", "FALSE"):
            truth = word.upper() == "TRUE"
            return lambda _: truth
        if word[0].isdigit():
            number = int(word) if word.isdigit() else float(word)
            return lambda _: number
        if self.word == "(":
            return self._call(word)
        self.place -= 1
        name = self._name()
        return lambda values: values[name]

    def _call(self, word: str) -> Run:
        act, given = self.functions[word.upper()], list[Run]()
        while self.word in ("(", ","):
            self.take()
            given.append(self.expression())
        self.expect(")")
        return lambda values: act(*(each(values) for each in given))

    def _name(self) -> str:
        word = self.take()
        if word.upper() not in self.known:
            raise SyntaxError(f"{word} is not declared")
        return self.known[word.upper()]


def _in_order(statements: list[Run]) -> Run:
    def run(values: dict[str, Any]) -> None:
        for statement in statements:
            statement(values)

    return run


def _flag(value: Any) -> bool:
    if type(value) is not bool:
        raise TypeError(f"{value!r} is no BOOL")
    return value


_LEVELS: tuple[dict[str, Callable[[Any, Any], Any]], ...] = (
    {"OR": lambda a, b: _flag(a) | _flag(b)},
    {"AND": lambda a, b: _flag(a) & _flag(b)},
    {"=": lambda a, b: a == b, "<>": lambda a, b: a != b},
    {"<": lambda a, b: a < b, ">": lambda a, b: a > b, "<=": lambda a, b: a <= b, ">=": lambda a, b: a >= b},
    {"+": lambda a, b: a + b, "-": lambda a, b: a - b},
    {"*": lambda a, b: a * b, "/": lambda a, b: a / b},
)


def _tokens(text: str) -> Iterator[str]:
    place, rest = 0, re.sub(r"(?:\s|\(\*.*?\*\))*\Z", "", text, flags=re.DOTALL)
    while place < len(rest):
        found = _TOKEN.match(rest, place)
        if found is None:
            raise SyntaxError(f"not structured text: {rest[place : place + 30]!r}")
        place = found.end()
        yield found[found.lastgroup or 0]
