"""Printer of traced functions as readable statements, for all languages with expressions and variables.

A value that is used once becomes part of the statement that uses it. Other values become variables. Labelled values
keep their labels as names; the other variables are numbered, with the name of the labelled value or result that they
belong to. A comment states the meaning of each labelled value.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from poppet.engine.printers.instructions import Instruction

_LONGEST_IN_CASE = 100
"""Maximum length of an operand in a condition of a case, in characters."""
_NAME = re.compile(r"[A-Za-z_][\w.\[\]]*(->[\w.]+)?")


class UnsupportedOperationError(ValueError):
    """Error of an operation or constant that a language does not support."""


class BlockForms(NamedTuple):
    """Lines of statements that contain other statements. `{0}` is a condition, a selector, a number or a comment."""

    indent: str  # indentation of all statements
    variable: str  # statement that introduces a variable: {name}, {type}, {text}
    switch: str
    case: str  # {0} number, {1} comment
    end_case: Sequence[str]
    end_switch: Sequence[str]
    if_true: str
    else_if: str
    otherwise: str
    end_if: str
    has_last_else: bool  # True if a chain with `else_if` must end with `otherwise`


class Language(NamedTuple):
    """Syntax of a language. Each form contains its arguments as `{0}` and `{1}`."""

    operations: Mapping[str, str]  # forms of operations with a number as result
    comparisons: Mapping[str, str]  # forms of comparisons of numbers
    reversed: Mapping[str, str]  # forms of comparisons with the second argument on the left
    logic: Mapping[str, str]  # forms of operations on conditions
    literal: Callable[[float], str]  # text of a constant
    choice: str  # form of a choice: {0} condition, {1} value if it is true, {2} value if it is false
    non_zero: str  # form of the condition that the number {0} is not zero
    types: tuple[str, str]  # of a number and of a condition
    declaration: str  # line of a new variable: {name}, {type}, {text}
    assignment: str  # line that assigns {text} to {name}
    comment: str  # line of a comment: {text}
    blocks: BlockForms
    longest: int = 100  # maximum length of an expression inside another one, in characters


class Value(NamedTuple):
    """Expression in the text of a program.

    An expression that is not an atom (a name, a constant or a call) needs parentheses inside other expressions.
    """

    text: str
    is_flag: bool = False
    is_atom: bool = True
    # of a choice with zero: condition, True if the condition is negated, text of the value, value
    choice: tuple[str, bool, str, Value] | None = None
    negated: str = ""  # argument of a `not`
    alternatives: tuple[str, Value, Value] | None = None  # of a choice: condition, value if it is true or false
    magnitude: Value | None = None  # condition that is 1 if the magnitude of the value is 1
    rank: int = 0  # index of the last input in it; a comparison in a case has the operand of lower rank first

    @property
    def operand(self) -> str:
        """Expression as an operand of another expression, in parentheses if necessary."""
        return self.text if self.is_atom else f"({self.text})"


class ResultVariable(NamedTuple):
    """Variable to which a result of a function is assigned."""

    name: str
    is_flag: bool = False


class CaseStatement(NamedTuple):
    """Results that depend on the number of a case; they are zero or false unless the case sets them."""

    results: Sequence[ResultVariable]
    cases: Sequence[str]  # comments of the cases 1, 2, ...
    titles: Mapping[int, str]  # comments by the value of a result


class Statements:
    """Statements and variables of one function.

    Parameters
    ----------
    language : Language
        Syntax.
    inputs : sequence of sequence of Value
        Text of each element of each argument.
    outputs : sequence of sequence of Result
        Variables of the elements of each result, without the labels.
    new_name : callable
        Returns a valid and unused name that resembles a text.
    labels : sequence of (str, str), optional
        Name and meaning of each element of the last result, whose values are labelled and not assigned.
    constants : mapping, optional
        Names of constants.
    is_in_place : bool, optional
        True if results overwrite arguments; the values that read them are then computed first.
    unchanged : mapping, optional
        Expression of each result that has its value already and needs no assignment (default: its name).
    selections : sequence of CaseStatement, optional
        Selections, to which the first results of the function belong: the selector, then the results of each case. The
        function has the chosen results as inputs.
    """

    def __init__(
        self,
        language: Language,
        inputs: Sequence[Sequence[Value]],
        outputs: Sequence[Sequence[ResultVariable]],
        new_name: Callable[[str], str],
        *,
        labels: Sequence[tuple[str, str]] = (),
        constants: Mapping[float, str] | None = None,
        is_in_place: bool = False,
        unchanged: Mapping[str, str] | None = None,
        selections: Sequence[CaseStatement] = (),
    ) -> None:
        self.unchanged, self.selections = unchanged or {}, selections
        self.counts: Counter[str] = Counter()
        self.language, self.inputs, self.outputs, self.new_name = language, inputs, outputs, new_name
        self.labels, self.constants, self.is_in_place = labels, constants or {}, is_in_place
        self.lines: list[str] = []
        self.variables: list[tuple[str, bool]] = []  # name, and True for a condition

    def read(self, function: Sequence[Instruction]) -> None:
        """Add statements for the instructions of the function."""
        consumers, names, owners, needed, ends = self._plan(function)
        in_cases = self._instructions_in_cases(function, consumers, needed - {*names})
        slots: dict[int, Value] = {}
        selected: list[Value] = []
        results: list[tuple[ResultVariable, Value]] = []
        comment = ""
        for k, instruction in enumerate(function):
            vector, element = instruction.place
            if instruction.operation == "output":
                value = slots[instruction.arguments[0]]
                if vector < len(self.selections):
                    selected.append(value)
                    if len(selected) == 1 + len(self.selections[vector].results) * len(self.selections[vector].cases):
                        self._add_selection(self.selections[vector], selected)
                        selected = []
                elif (result := self._result(vector, element)) is not None:
                    results.append((result, value))
                continue
            if k not in needed:
                continue
            arguments = [slots[slot] for slot in instruction.arguments]
            condition = self._condition_of_case(instruction, arguments) if k in in_cases else None
            value = condition or self._value(instruction, arguments)
            rank = (
                instruction.place[1]
                if instruction.operation == "input"
                else max((a.rank for a in arguments), default=0)
            )
            value = value._replace(rank=rank)
            # Names, constants and negations need no variable.
            is_simple = instruction.operation in ("const", "input", "assign", "not") or _NAME.fullmatch(value.text)
            is_long = len(value.text) > self.language.longest and not ends[k]
            # A condition of a case is part of its statement, even if several cases have it.
            is_repeated = len(consumers[k]) != 1 and not (
                k in in_cases and (value.is_flag or value.alternatives is not None)
            )
            is_long = is_long and not (k in in_cases and (value.is_flag or len(value.text) <= _LONGEST_IN_CASE))
            if not is_simple and (is_repeated or k in names or is_long):
                owner = owners[k]
                meaning = dict(self.labels).get(owner, "")
                if meaning and meaning != comment:
                    self.lines.append(self.language.comment.format(text=meaning))
                    comment = meaning
                value = self._variable(value, owner, is_label=k in names)
            slots[instruction.result] = value
        self._assign(results)

    def _result(self, vector: int, element: int) -> ResultVariable | None:
        """Return the variable of a result.

        The output is None for a label, and for a result of a selection.
        """
        k = vector - len(self.selections)
        return self.outputs[k][element] if 0 <= k < len(self.outputs) else None

    def _instructions_in_cases(
        self, function: Sequence[Instruction], consumers: Sequence[Sequence[int]], candidates: set[int]
    ) -> set[int]:
        """Return the indices of those candidates on which only cases of selections depend.

        `consumers` contains the indices of the instructions that read each value.
        """
        in_cases = {
            k
            for k, instruction in enumerate(function)
            if instruction.operation == "output"
            and instruction.place[0] < len(self.selections)
            and instruction.place[1] > 0
        }
        n_vectors = len(self.selections) + len(self.outputs)
        results = {k for k, item in enumerate(function) if item.operation == "output" and item.place[0] < n_vectors}
        for k in reversed(range(len(function))):
            needing = [c for c in consumers[k] if c in candidates or c in in_cases or c in results]
            if k in candidates and needing and all(consumer in in_cases for consumer in needing):
                in_cases.add(k)
        return in_cases

    def _add_selection(self, selection: CaseStatement, values: Sequence[Value]) -> None:
        """Add the statement of a selection.

        `values` contains its selector, then the results of each case.
        """
        blocks, (selector, *others) = self.language.blocks, values
        if not _NAME.fullmatch(selector.text):
            selector = self._variable(selector, "case")
        for result in selection.results:
            self.variables.append((result.name, result.is_flag))
            kind = self.language.types[result.is_flag]
            self._add(blocks.variable.format(name=result.name, type=kind, text=self._default(result)))
        self._add(blocks.switch.format(self._number(selector)))
        count = len(selection.results)
        for k, title in enumerate(selection.cases):
            lines = [
                line
                for result, value in zip(selection.results, others[k * count : (k + 1) * count], strict=True)
                for line in self._case_lines(result, value, selection.titles)
            ]
            self._add(blocks.case.format(k + 1, self.language.comment.format(text=title).strip()), 1)
            if not (lines or blocks.end_case):  # some compilers reject a case without a statement
                lines = [self._assignment(result, self._default(result)) for result in selection.results]
            for line in (*lines, *blocks.end_case):
                self._add(line, 2)
        for line in blocks.end_switch:
            self._add(line)

    def _add(self, line: str, depth: int = 0) -> None:
        self.lines.append(f"{self.language.blocks.indent}{'  ' * depth}{line}")

    def _assignment(self, result: ResultVariable, text: str) -> str:
        return self.language.assignment.format(name=result.name, text=text).strip()

    def _default(self, result: ResultVariable) -> str:
        return self.language.logic["false"] if result.is_flag else self.language.literal(0.0)

    def _case_lines(self, result: ResultVariable, value: Value, titles: Mapping[int, str]) -> list[str]:
        """Return the statements that assign a value to a result of a selection.

        There are none if the result is zero.
        """
        blocks, default = self.language.blocks, self._default(result)
        text = self._flag(value) if result.is_flag else self._number(value, is_operand=False)
        if value.alternatives is None:
            if text == default:
                return []
            line = self._assignment(result, text)
            title = next((titles[k] for k in titles if text == self.language.literal(float(k))), "")
            return [f"{line} {self.language.comment.format(text=title).strip()}" if title else line]
        lines, form, n_branches = list[str](), blocks.if_true, 0
        unchanged = [self._assignment(result, default)]
        while value.alternatives is not None:
            condition, yes, value = value.alternatives
            branch = self._case_lines(result, yes, titles) or unchanged
            lines += [form.format(_bare(condition)), *(f"  {line}" for line in branch)]
            form, n_branches = blocks.else_if, n_branches + 1
        last = self._case_lines(result, value, titles) or (unchanged if blocks.has_last_else and n_branches > 1 else [])
        lines += [blocks.otherwise, *(f"  {line}" for line in last)] if last else []
        return [*lines, blocks.end_if]

    def _plan(
        self, function: Sequence[Instruction]
    ) -> tuple[list[list[int]], dict[int, str], list[str], set[int], list[bool]]:
        """Return data on the use of each instruction, by its index.

        The result has five items. The first three are the instructions that read the value, its label (if it has one),
        and the name of the result or label for which it is computed. The fourth item is the set of needed instructions.
        The last item is True for values whose expression can be long, because they are results or halves of a choice.
        """
        names, consumers = dict[int, str](), [list[int]() for _ in function]
        last: dict[int, int] = {}
        for k, instruction in enumerate(function):
            vector, element = instruction.place
            is_label = instruction.operation == "output" and vector >= len(self.selections) + len(self.outputs)
            for slot in instruction.arguments:
                if is_label:
                    names.setdefault(last[slot], self.labels[element][0])
                else:
                    consumers[last[slot]].append(k)
            if instruction.operation == "assign":
                last[instruction.result] = last[instruction.arguments[0]]
            elif instruction.operation != "output":
                last[instruction.result] = k
        owners, needed = [""] * len(function), set[int]()
        for k in reversed(range(len(function))):
            instruction = function[k]
            vector, element = instruction.place
            if instruction.operation == "output":
                if vector < len(self.selections):
                    results = self.selections[vector].results
                    result: ResultVariable | None = results[(element - 1) % len(results)]
                else:
                    result = self._result(vector, element)  # None for a label
                if result is not None:
                    owners[k] = re.split(r"\W+", result.name)[-1]
                    needed.add(k)
                continue
            needing = [consumer for consumer in consumers[k] if consumer in needed]
            if needing or instruction.operation == "assign":
                needed.add(k)
            owners[k] = names.get(k) or next((owners[consumer] for consumer in needing), "")
        ends = [
            all(function[c].operation == "output" for c in consumers[k])
            or (instruction.operation == "if_else_zero" and all(function[c].operation == "add" for c in consumers[k]))
            for k, instruction in enumerate(function)
        ]
        return consumers, names, owners, needed, ends

    def _assign(self, results: Sequence[tuple[ResultVariable, Value]]) -> None:
        """Add the statements that assign the results, except results that keep their values."""
        texts = {
            result.name: self._flag(value) if result.is_flag else self._number(value, is_operand=False)
            for result, value in results
        }
        remaining = {name: text for name, text in texts.items() if text != self.unchanged.get(name, name)}
        values = {result.name: value for result, value in results}
        reads = {name: set(re.findall(r"[\w.]+", text)) & {*remaining} - {name} for name, text in remaining.items()}
        while remaining:
            # A result that no other expression reads can be overwritten.
            free = [name for name in remaining if not any(name in reads[other] for other in remaining)]
            if self.is_in_place and not free:
                name = next(iter(remaining))
                variable = self._variable(values[name], name)
                remaining[name], reads[name] = variable.text, set()
                continue
            for name in free if self.is_in_place else [*remaining]:
                self.lines.append(self.language.assignment.format(name=name, text=remaining.pop(name)))

    def _number(self, value: Value, *, is_operand: bool = True) -> str:
        """Return an expression as a number.

        A condition becomes 0 or 1.
        """
        if not value.is_flag:
            return value.operand if is_operand else value.text
        one, zero = (self.language.literal(number) for number in (1.0, 0.0))
        text = self.language.choice.format(value.operand, one, zero)
        return text if (text.endswith(")") and not text.startswith("(")) or not is_operand else f"({text})"

    def _flag(self, value: Value) -> str:
        """Return an expression as a condition.

        A number is compared with zero.
        """
        if value.is_flag:
            return value.text
        if value.text == self.language.literal(1.0) or value.text == self.language.literal(0.0):
            return self.language.logic["true" if value.text == self.language.literal(1.0) else "false"]
        return self.language.non_zero.format(value.operand)

    def _operand_flag(self, value: Value) -> str:
        return value.operand if value.is_flag else f"({self._flag(value)})"

    def _value(self, instruction: Instruction, arguments: list[Value]) -> Value:
        name, language = instruction.operation, self.language
        if name == "const":
            return Value(self.constants.get(instruction.constant) or language.literal(instruction.constant))
        if name == "input":
            return self.inputs[instruction.place[0]][instruction.place[1]]
        if name == "assign":
            return arguments[0]
        # A condition is compared with a constant between false and true.
        thresholds = language.literal(0.0), language.literal(0.5)
        if name in ("lt", "le") and arguments[1].is_flag and arguments[0].text in thresholds:
            return arguments[1]
        if name in ("and", "or", "not"):
            # A condition that is always true, such as the first of a chain, adds nothing.
            true = language.literal(1.0)
            if name == "and" and true in (arguments[0].text, arguments[1].text):
                other = arguments[1] if arguments[0].text == true else arguments[0]
                return other if other.is_flag else Value(self._flag(other), True, False)
            text = language.logic[name].format(*(self._operand_flag(argument) for argument in arguments))
            return Value(text, True, False, negated=self._operand_flag(arguments[0]) if name == "not" else "")
        if name in language.comparisons:
            text = language.comparisons[name].format(*(self._number(argument) for argument in arguments))
            return Value(text, True, False)
        if name == "if_else_zero":
            condition, value = arguments
            flag = self._operand_flag(condition)
            chosen = self._number(value, is_operand="?" in language.choice)
            choice = condition.negated or flag, bool(condition.negated), chosen, value
            zero = Value(language.literal(0.0))
            halves = (zero, value) if condition.negated else (value, zero)
            alternatives = choice[0], *halves
            if value.is_flag:
                text = language.logic["and"].format(flag, value.operand)
                return Value(text, True, False, choice, alternatives=alternatives)
            if value.text == language.literal(1.0):
                return Value(flag, True, True, choice, alternatives=alternatives)
            text = language.choice.format(flag, chosen, language.literal(0.0))
            return Value(text, is_atom="?" not in language.choice, choice=choice, alternatives=alternatives)
        if name == "add" and (merged := self._merge(*arguments)):
            return merged
        if name not in language.operations:
            raise UnsupportedOperationError(name)
        form = language.operations[name]
        if form.count("{0}") > 1 and not _NAME.fullmatch(arguments[0].text):
            arguments = [self._variable(arguments[0], "value"), *arguments[1:]]
        # An argument in the parentheses of a call needs no parentheses.
        is_call = re.fullmatch(r"\w+\(\{0\}(, \{1\})?\)", form) is not None
        return Value(form.format(*(self._number(a, is_operand=not is_call) for a in arguments)), is_atom=is_call)

    def _condition_of_case(self, instruction: Instruction, arguments: Sequence[Value]) -> Value | None:
        """Return the expression of a condition as a user writes it.

        The measured value of a comparison is on the left, and minima and maxima of conditions become `and` and `or`.
        The result is None for other instructions.
        """
        name, language = instruction.operation, self.language
        if name in ("fmin", "fmax") and all(argument.is_flag for argument in arguments):
            logic = language.logic["and" if name == "fmin" else "or"]
            return Value(logic.format(*(self._operand_flag(argument) for argument in arguments)), True, False)
        if name == "not" and arguments[0].negated:
            return Value(arguments[0].negated, True)
        # The comparisons |c| < 0.5 and |c - 1| < 0.5 of a condition c.
        if name == "fabs" and (arguments[0].is_flag or arguments[0].magnitude is not None):
            return arguments[0].magnitude or arguments[0]
        if name == "sub" and arguments[0].is_flag and arguments[1].text == language.literal(1.0):
            return self._value(instruction, list(arguments))._replace(magnitude=self._negative(arguments[0]))
        if name in ("lt", "le") and arguments[0].is_flag and arguments[1].text == language.literal(0.5):
            return self._negative(arguments[0])
        thresholds = language.literal(0.0), language.literal(0.5)
        if name in ("lt", "le") and not any(argument.is_flag for argument in arguments):
            left, right = arguments
            is_constant = left.text[:1].isdigit() or left.text.startswith("(-")
            if (left.rank > right.rank or is_constant) and left.text not in thresholds:
                return Value(language.reversed[name].format(*map(self._number, arguments)), True, False)
        return None

    def _negative(self, value: Value) -> Value:
        """Return the negation of a condition."""
        if value.negated:
            return Value(value.negated, True)
        operand = self._operand_flag(value)
        return Value(self.language.logic["not"].format(operand), True, False, negated=operand)

    def _merge(self, a: Value, b: Value) -> Value | None:
        """Return the sum of two choices with opposite conditions as one choice.

        The result is None for other values.
        """
        if a.choice is None or b.choice is None or a.choice[0] != b.choice[0] or a.choice[1] == b.choice[1]:
            return None
        yes, no = (b, a) if a.choice[1] else (a, b)
        assert yes.choice is not None
        assert no.choice is not None
        alternatives = yes.choice[0], yes.choice[3], no.choice[3]
        if a.is_flag and b.is_flag:
            text = self.language.logic["or"].format(a.operand, b.operand)
            return Value(text, True, False, alternatives=alternatives)
        text = self.language.choice.format(yes.choice[0], yes.choice[2], no.choice[2])
        return Value(text, is_atom="?" not in self.language.choice, alternatives=alternatives)

    def _variable(self, value: Value, name: str, *, is_label: bool = False) -> Value:
        """Assign an expression to a new variable, and return the variable.

        If the name is a label, the variable has this name. Otherwise a number is added to the name.
        """
        self.counts[name] += not is_label
        name = self.new_name(name if is_label else f"{name}_{self.counts[name]}")
        self.variables.append((name, value.is_flag))
        kind = self.language.types[value.is_flag]
        self.lines.append(self.language.declaration.format(name=name, text=value.text, type=kind))
        return Value(name, value.is_flag, negated=value.negated if re.fullmatch(r"\w+", value.negated) else "")


def _bare(condition: str) -> str:
    """Return a condition without parentheses around the whole."""
    depth = 0
    for k, character in enumerate(condition):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if depth == 0 and k < len(condition) - 1:
            return condition
    return condition[1:-1] if condition.startswith("(") else condition
