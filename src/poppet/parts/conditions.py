"""Conditions of step sequences: grammar, parser and evaluation.

A condition compares outputs of the circuit, inputs of the sequence, and its own step time and counters::

    condition  = conjunction { "or" conjunction }
    conjunction = negation { "and" negation }
    negation   = "not" negation | "(" condition ")" | comparison
    comparison = operand [ relation operand [ ("+" | "-") number ] ]
    operand    = address | input | number | "elapsed" | "cycles" | "count" "(" text ")" | text
    relation   = "<" | "<=" | ">" | ">=" | "==" | "!="

A number has a unit, such as `98 mm`. A text in quotes is the name of a step. The parser builds a tree of plain data;
nothing is executed as code.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import fabs, maximum, minimum, where
from poppet.core.units import Kind, quantity, same_dimension
from poppet.parts.quantities import QUANTITIES

MAX_LENGTH = 1000
"""Maximum number of characters of a condition."""
MAX_DEPTH = 20
"""Maximum depth of nested brackets and negations in a condition."""
RELATIONS = ("<=", ">=", "==", "!=", "<", ">")
_OPPOSITES = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
WORDS = ("and", "or", "not", "elapsed", "cycles", "count")
"""Words with a meaning in conditions; an input of a sequence cannot have one of these names."""
STEP = "step"
"""Name of the output of a sequence that contains the number of its step."""
_ROUNDING = 1e-6
"""Relative tolerance of comparisons with the step time; it permits single precision."""
_SI_UNITS = (
    "1", "Pa", "m", "s", "K", "m/s", "N", "kg/s", "rad", "rad/s", "kg", "m^3", "m^3/s", "m^2", "J", "W", "V", "A", "Hz",
    "m/s^2", "rad/s^2", "N/m", "m^3/(s Pa)", "J/K", "W/K",
)  # fmt: skip
KIND_OF_UNIT: dict[str, Kind] = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}
"""Kind of a threshold by its SI unit; `plain` for other units."""
_DIFFERENCES: dict[str, Kind] = {"Pa": "pressure_difference", "K": "temperature_difference", "kg/s": "mass_flow"}
_TOKEN = re.compile(
    r"""\s*(?:
    (?P<number>(?:\d+(?:[.,]\d*)?|\.\d+)(?:[eE][+-]?\d+)?)
    |(?P<name>[A-Za-z_][A-Za-z0-9_-]*(?:\.[A-Za-z0-9_][A-Za-z0-9_-]*)*)
    |"(?P<text>[^"]*)"
    |(?P<sign><=|>=|==|!=|<|>|\(|\)|\+|-)
    )""",
    re.VERBOSE,
)
_NEXT_WORD = re.compile(r"\s+(?:(?:and|or|not)\b|[+-])")


# --- Tree of a condition ---


@dataclass(frozen=True)
class Literal:
    """Number in a condition, with its unit and its location in the text.

    `place` is the name of its parameter in the sequence; it is empty if the number is a constant.
    """

    number: Number
    kind: Kind
    start: int
    end: int
    place: str = ""


@dataclass(frozen=True)
class Reading:
    """Output of the circuit that a condition reads, `slideA.position`."""

    address: str
    unit: str


@dataclass(frozen=True)
class Flag:
    """Input of the sequence, which is 0 or 1."""

    name: str


@dataclass(frozen=True)
class Internal:
    """Value of the sequence itself: `elapsed` [s], `cycles`, or `count` with the name of a step."""

    name: str
    step: str = ""


Operand = Literal | Reading | Flag | Internal


@dataclass(frozen=True)
class Relation:
    """Relation of two operands; `offset` is added to the right operand."""

    left: Operand
    relation: str
    right: Operand
    offset: Literal | None = None


@dataclass(frozen=True)
class Not:
    """Negation of a condition."""

    term: Node


@dataclass(frozen=True)
class AllOf:
    """Conjunction of conditions, joined by `and`."""

    terms: tuple[Node, ...]


@dataclass(frozen=True)
class AnyOf:
    """Disjunction of conditions, joined by `or`."""

    terms: tuple[Node, ...]


Node = Relation | Flag | Reading | Not | AllOf | AnyOf


@dataclass(frozen=True)
class Condition:
    """Condition with its text and its tree.

    Parameters
    ----------
    text : str
        Text of the user.
    tree : Node
        Tree of comparisons; a `Flag` or a `Reading` alone is true if its value exceeds 0.5.
    """

    text: str
    tree: Node

    def operands(self) -> Iterator[Operand]:
        """Yield all operands in the order of the text."""
        yield from _operands(self.tree)

    def literals(self) -> list[Literal]:
        """Return the numbers of the condition that are parameters, in the order of the text."""
        return [operand for operand in self.operands() if isinstance(operand, Literal) and operand.place]

    def relations(self) -> Iterator[Relation]:
        """Yield all comparisons in the order of the text."""
        yield from _relations(self.tree)

    def compared_as_integers(self) -> set[str]:
        """Return the addresses of the outputs that the condition compares by == or !=."""
        return {
            side.address
            for relation in self.relations()
            if relation.relation in ("==", "!=")
            for side in (relation.left, relation.right)
            if isinstance(side, Reading)
        }

    def with_text(self, numbers: Mapping[str, Number]) -> str:
        """Return the text with other numbers; `numbers` maps the names of parameters to numbers."""
        text = self.text
        for literal in reversed(self.literals()):
            number = numbers[literal.place]
            if number != literal.number:
                value = written(number)
                # An offset keeps its sign.
                sign = "+" if text[literal.start] in "+-" and not value.startswith(("+", "-")) else ""
                text = f"{text[: literal.start]}{sign}{value}{text[literal.end :]}"
        return text

    def evaluate(self, value: Callable[[Operand], Any]) -> Any:
        """Return 1 if the condition is true, otherwise 0, for floats or symbols.

        `value` returns the value of an operand in SI units.
        """
        return _evaluate(self.tree, value, False)


def written(number: Number) -> str:
    """Return a number as text that the parser converts to the same number."""
    if number.text and number.display() == number.text:
        return number.text
    gauge = " g" if number.reference == "gauge" else ""
    return f"{float(number.value)!r}{'' if number.unit == '1' else f' {number.unit}'}{gauge}"


def _operands(node: Node | Operand) -> Iterator[Operand]:
    match node:
        case Relation():
            yield node.left
            yield node.right
            if node.offset is not None:
                yield node.offset
        case Not():
            yield from _operands(node.term)
        case AllOf() | AnyOf():
            for term in node.terms:
                yield from _operands(term)
        case _:
            yield node


def _relations(node: Node) -> Iterator[Relation]:
    match node:
        case Relation():
            yield node
        case Not():
            yield from _relations(node.term)
        case AllOf() | AnyOf():
            for term in node.terms:
                yield from _relations(term)


def never_true(relation: Relation) -> str:
    """Return the name of an input of which a comparison is false for both 0 and 1; otherwise the text is empty."""
    sides = relation.left, relation.right
    flag = next((side for side in sides if isinstance(side, Flag)), None)
    if flag is None or not any(isinstance(side, Literal) for side in sides):
        return ""

    def value_at(state: float) -> Callable[[Operand], Any]:
        return lambda operand: float(operand.number.value) if isinstance(operand, Literal) else state

    return "" if any(_compare(relation, value_at(state)) > 0.5 for state in (0.0, 1.0)) else flag.name


def _shown_unit(unit: str) -> str:
    """Return a unit for a message; the text is empty for a value without a unit."""
    return "" if unit == "1" else unit


def _evaluate(node: Node, value: Callable[[Operand], Any], is_negated: bool) -> Any:
    """Return 1 if a condition is true, otherwise 0; or the opposite if `is_negated` is True.

    A negation changes the relations, and it exchanges `and` and `or`: one compiler of structured text cannot negate an
    `AND` of comparisons.
    """
    match node:
        case Relation():
            relation = _OPPOSITES[node.relation] if is_negated else node.relation
            return _compare(replace(node, relation=relation), value)
        case Not():
            return _evaluate(node.term, value, not is_negated)
        case AllOf() | AnyOf():
            join = minimum if isinstance(node, AllOf) is not is_negated else maximum
            result = _evaluate(node.terms[0], value, is_negated)
            for term in node.terms[1:]:
                result = join(result, _evaluate(term, value, is_negated))
            return result
    return where(value(node) > 0.5, *((0.0, 1.0) if is_negated else (1.0, 0.0)))


def _compare(node: Relation, value: Callable[[Operand], Any]) -> Any:
    left, right, relation = value(node.left), value(node.right), node.relation
    if node.offset is not None:
        right = right + value(node.offset)
    if relation in ("==", "!="):
        # Both are integers: flags, steps or counters.
        difference = fabs(left - right)
        return where(difference < 0.5 if relation == "==" else difference >= 0.5, 1.0, 0.0)
    low = high = right
    # The step time is a multiple of the sample time, with rounding errors.
    if isinstance(node.left, Internal) and node.left.name == "elapsed":
        low, high = right * (1.0 - _ROUNDING), right * (1.0 + _ROUNDING)
    elif isinstance(node.right, Internal) and node.right.name == "elapsed":
        low, high = right - _ROUNDING * left, right + _ROUNDING * left
    match relation:
        case "<":
            return where(left < low, 1.0, 0.0)
        case "<=":
            return where(left <= high, 1.0, 0.0)
        case ">":
            return where(left > high, 1.0, 0.0)
    return where(left >= low, 1.0, 0.0)


def read_literal(text: str, *, is_difference: bool = False) -> tuple[Number, Kind]:
    """Return a number with the SI unit that follows from its written unit, and the kind of its quantity.

    A text without a unit is dimensionless. If the keyword `is_difference` is True, a pressure or temperature is a
    difference.
    """
    stripped = re.sub(r"^\s*[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?", "", text).strip()
    unit = next((si for si in _SI_UNITS if stripped and same_dimension(stripped, si)), "1")
    kind = (_DIFFERENCES if is_difference else KIND_OF_UNIT).get(unit, "plain")
    parsed = quantity(text, unit, kind=kind)
    return Number(parsed.value, unit, Source("given"), parsed.reference, text), kind


# --- Parser ---


class Names(NamedTuple):
    """Names that a condition can contain besides addresses: inputs and steps of the sequence."""

    inputs: Collection[str]
    steps: Collection[str]


class _Token(NamedTuple):
    kind: str  # number, name, text, sign or end
    text: str
    start: int
    end: int


def parse_condition(text: Any, names: Names, place: str) -> Condition:
    """Parse a condition.

    Parameters
    ----------
    text : str
        The condition, for example `slideA.position > 98 mm and elapsed > 50 ms`.
    names : Names
        Inputs and steps of the sequence.
    place : str
        Address of the condition within the part. Its parameters have this name, with a number if there are several.

    Returns
    -------
    Condition

    Raises
    ------
    InputError
        If the text is not a condition; the error contains the position, the text there and the cause.
    """
    if not isinstance(text, str):
        raise InputError("condition.no_text", place, value=text)
    if len(text) > MAX_LENGTH:
        raise InputError("condition.too_long", place, length=len(text), most=MAX_LENGTH)
    try:
        condition = Condition(text, _Parser(text, names, place).parse())
    except InputError as error:
        # The text of the error contains the condition, but not its address.
        raise error.at(place) from None
    return _with_places(condition, place)


def _with_places(condition: Condition, place: str) -> Condition:
    """Return the condition in which each number that can change has the name of its parameter."""
    numbers = [operand for operand in condition.operands() if isinstance(operand, Literal)]
    # An integer of a flag, a step or a counter is a constant only if it is compared for equality.
    variable = [literal for literal in numbers if not _is_constant(condition.tree, literal)]
    names = {
        literal.start: f"{place}.{k}" if len(variable) > 1 else place for k, literal in enumerate(variable, 1)
    }  # fmt: skip

    def placed(node: Any) -> Any:
        match node:
            case Literal():
                return replace(node, place=names.get(node.start, ""))
            case Relation():
                offset = None if node.offset is None else placed(node.offset)
                return replace(node, left=placed(node.left), right=placed(node.right), offset=offset)
            case Not():
                return Not(placed(node.term))
            case AllOf() | AnyOf():
                return type(node)(tuple(map(placed, node.terms)))
        return node

    return replace(condition, tree=placed(condition.tree))


def _is_constant(node: Node, literal: Literal) -> bool:
    match node:
        case Relation():
            return node.relation in ("==", "!=") and literal in (node.left, node.right)
        case Not():
            return _is_constant(node.term, literal)
        case AllOf() | AnyOf():
            return any(_is_constant(term, literal) for term in node.terms)
    return False


class _Parser:
    """Recursive-descent parser of one condition."""

    def __init__(self, text: str, names: Names, place: str) -> None:
        self.text, self.names, self.place = text, names, place
        self.tokens = list(self._tokens())
        self.index, self.depth = 0, 0

    def _error(self, code: str, token: _Token, **facts: Any) -> InputError:
        found = "" if token.kind == "end" else self.text[token.start : token.end]
        return InputError(
            f"condition.{code}", self.place, text=self.text, column=token.start + 1, found=found, **facts
        )  # fmt: skip

    def _tokens(self) -> Iterator[_Token]:
        position = 0
        while position < len(self.text.rstrip()):
            match = _TOKEN.match(self.text, position)
            if match is None or match.lastgroup is None:
                start = position + len(self.text[position:]) - len(self.text[position:].lstrip())
                raise self._error("character", _Token("sign", self.text[start], start, start + 1))
            kind = match.lastgroup
            start, end = match.span(kind)
            if kind == "number":
                # The unit of a number can contain spaces and brackets.
                depth, unit = 0, end
                while end < len(self.text):
                    character = self.text[end]
                    if character in '<>=!"' or (depth == 0 and (character == ")" or _NEXT_WORD.match(self.text, end))):
                        break
                    depth += {"(": 1, ")": -1}.get(character, 0)
                    end += 1
                end = unit + len(self.text[unit:end].rstrip())
            content = self.text[start:end]
            if kind == "text":  # with its quotes
                start, end = start - 1, end + 1
            yield _Token(kind, content, start, end)
            position = end
        yield _Token("end", "", len(self.text), len(self.text))

    @property
    def token(self) -> _Token:
        return self.tokens[self.index]

    def _accept(self, *texts: str) -> _Token | None:
        token = self.token
        if token.text in texts and token.kind in ("sign", "name"):
            self.index += 1
            return token
        return None

    def parse(self) -> Node:
        if self.token.kind == "end":
            raise self._error("empty", self.token)
        tree = self._disjunction()
        if self.token.kind != "end":
            code = "closing" if self.token.text == ")" else "no_end"
            raise self._error(code, self.token)
        return tree

    def _disjunction(self) -> Node:
        terms = [self._conjunction()]
        while self._accept("or"):
            terms.append(self._conjunction())
        return terms[0] if len(terms) == 1 else AnyOf(tuple(terms))

    def _conjunction(self) -> Node:
        terms = [self._negation()]
        while self._accept("and"):
            terms.append(self._negation())
        return terms[0] if len(terms) == 1 else AllOf(tuple(terms))

    def _negation(self) -> Node:
        token = self.token
        opening = self._accept("not", "(")
        if opening is None:
            return self._comparison()
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self._error("too_deep", token, most=MAX_DEPTH)
        if opening.text == "not":
            node: Node = Not(self._negation())
        else:
            node = self._disjunction()
            if self._accept(")") is None:
                raise self._error("no_bracket", self.token, opening=opening.start + 1)
        self.depth -= 1
        return node

    def _comparison(self) -> Node:
        first = self.token
        left = self._operand()
        sign = self._accept(*RELATIONS)
        if sign is None:
            if isinstance(left, Flag) or (isinstance(left, Reading) and left.unit in ("", "1")):
                return replace(left, unit="1") if isinstance(left, Reading) else left
            raise self._error("no_relation", self.token, operand=self.text[first.start : first.end])
        second = self.token
        right = self._operand()
        offset = self._offset(right)
        if self.token.kind == "sign" and self.token.text in RELATIONS:
            raise self._error("chained", self.token)
        return self._checked(Relation(left, sign.text, right, offset), first, second)

    def _offset(self, operand: Any) -> Literal | None:
        sign = self._accept("+", "-")
        if sign is None:
            return None
        if not isinstance(operand, Reading):
            raise self._error("no_offset", sign)
        if self.token.kind != "number":
            raise self._error("no_number", self.token)
        token = self.token
        self.index += 1
        return self._literal(token, "-" if sign.text == "-" else "", sign.start, is_difference=True)

    def _operand(self) -> Any:
        token = self.token
        if token.kind == "end" or token.text in (")", "and", "or", "not", *RELATIONS):
            raise self._error("no_operand", token)
        self.index += 1
        match token.kind:
            case "number":
                return self._literal(token)
            case "sign" if token.text in "+-" and self.token.kind == "number":
                number = self.token
                self.index += 1
                return self._literal(number, token.text.strip("+"), token.start)
            case "text":
                return token
            case "name":
                return self._name(token)
        raise self._error("no_operand", token)

    def _name(self, token: _Token) -> Operand:
        if "." in token.text:
            return Reading(token.text, "")
        if token.text in self.names.inputs:
            return Flag(token.text)
        if token.text in ("elapsed", "cycles"):
            return Internal(token.text)
        if token.text == "count":
            step = self.tokens[self.index + 1] if self.token.text == "(" else self.token
            if self.token.text != "(" or step.kind != "text" or self.tokens[self.index + 2].text != ")":
                raise self._error("no_count", token)
            self.index += 3
            if step.text not in self.names.steps:
                raise self._error("unknown_step", step, suggestion=NameSuggestion(step.text, self.names.steps))
            return Internal("count", step.text)
        known = [*self.names.inputs, "elapsed", "cycles"]
        raise self._error("unknown_name", token, suggestion=NameSuggestion(token.text, known))

    def _literal(self, token: _Token, sign: str = "", start: int = -1, *, is_difference: bool = False) -> Literal:
        start, text = token.start if start < 0 else start, f"{sign}{token.text}"
        try:
            number, kind = read_literal(text, is_difference=is_difference)
        except InputError as cause:
            raise self._error("no_value", token._replace(start=start), cause=cause) from None
        return Literal(number, kind, start, token.end)

    def _checked(self, node: Relation, first: _Token, second: _Token) -> Relation:
        """Return a comparison in which both operands have a unit, after a check of its types."""
        left, right = (self._step_reading(a, b) for a, b in ((node.left, node.right), (node.right, node.left)))
        if isinstance(left, _Token) or isinstance(right, _Token):
            raise self._error("no_step", next(token for token in (left, right) if isinstance(token, _Token)))
        node = replace(node, left=left, right=right)
        if isinstance(left, Literal) and isinstance(right, Literal):
            raise self._error("constant", first)
        units = [_unit_of(operand) for operand in (left, right, node.offset) if operand is not None]
        # A pressure compared with another pressure: the unit follows from the names.
        names = (re.split(r"[._:]", item.address)[-1] for item in (left, right) if isinstance(item, Reading))
        named = [QUANTITIES[name].unit for name in names if name in QUANTITIES]
        # Integers have no unit.
        unit = next((unit for unit in (*units, *named) if unit), "1" if node.relation in ("==", "!=") else "")
        if not unit:
            raise self._error("no_unit", first)
        wrong = next((unit_of for unit_of in units if unit_of and not same_dimension(unit_of, unit)), None)
        if wrong is not None:
            units_of = {"unit": _shown_unit(unit), "other": _shown_unit(wrong)}
            raise self._error("other_unit", second, **units_of, is_bare=wrong == "1", is_other_bare=unit == "1")
        if node.relation in ("==", "!=") and not (unit == "1" and all(map(_is_integer, (left, right)))):
            raise self._error("no_integers", first)
        left, right = (replace(o, unit=unit) if isinstance(o, Reading) else o for o in (left, right))
        return replace(node, left=left, right=right)

    def _step_reading(self, operand: Any, other: Any) -> Any:
        """Return the operand, in which the step of another sequence and the name of a step become flags.

        `other.step == "clamp"` reads the output `other.step:clamp`, which is 1 during this step.
        """
        if isinstance(other, _Token) and isinstance(operand, Reading) and operand.address.endswith(f".{STEP}"):
            return Reading(f"{operand.address}:{other.text}", "1")
        if isinstance(operand, _Token) and isinstance(other, Reading) and other.address.endswith(f".{STEP}"):
            one = Number(1.0, "1", Source("given"), "", "1")
            return Literal(one, "plain", operand.start, operand.end)
        return operand


def _unit_of(operand: Operand) -> str:
    match operand:
        case Literal():
            return operand.number.unit
        case Reading():
            return operand.unit
        case Internal(name="elapsed"):
            return "s"
    return "1"


def _is_integer(operand: Operand) -> bool:
    if isinstance(operand, Literal):
        return float(operand.number.value).is_integer()
    return not (isinstance(operand, Internal) and operand.name == "elapsed")
