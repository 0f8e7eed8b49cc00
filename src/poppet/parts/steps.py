"""Steps of a sequence: reading, checks, and the numbers in their conditions."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Collection, Hashable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, ClassVar, NamedTuple

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number
from poppet.core.symbolic import is_symbolic
from poppet.parts.conditions import (
    WORDS,
    Condition,
    Flag,
    Internal,
    Literal,
    Names,
    Operand,
    Reading,
    Relation,
    parse_condition,
    written,
)
from poppet.parts.fields import NumberSpec, read_number

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}")
"""Form of the name of an output or an input of a sequence."""
STEP_NAME = re.compile(r"[A-Za-z0-9](?:[A-Za-z0-9 _+-]{0,62}[A-Za-z0-9_+-])?")
"""Form of the name of a step."""
COUNTER = re.compile(r"count_[0-9]+")
"""Form of the names of counters in the memory of a sequence."""
MAX_STEPS = 500
"""Maximum number of steps of a sequence."""
BUILT_IN_INPUTS = ("halt", "reset", "emergency", "input_fault")
BUILT_IN_OUTPUTS = ("step", "elapsed", "cycles")
_FIELDS = ("on", "set", "next", "timeout")
_RESERVED = (
    *BUILT_IN_INPUTS,
    *BUILT_IN_OUTPUTS,
    *WORDS,
    "sample",
    "sample_count",
    "elapsed_samples",
    "faulty_samples",
    "is_safe",
    "is_held",
)
_AFTER = NumberSpec("s", "time in the step", low=0.0)
_SET = NumberSpec("1", "value of an output", low=-1.0, high=1.0)


class Form(NamedTuple):
    """Fields of a sequence besides its steps: outputs, inputs, first step and emergency step."""

    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    start: str
    emergency: str


@dataclass(frozen=True)
class Transition:
    """Change to the step `target` if a condition is true."""

    target: str
    condition: Condition


@dataclass(frozen=True)
class Timeout:
    """Change to the step `target` after a time in the step [s]; `place` is the name of its parameter."""

    target: str
    place: str
    after: Number


@dataclass(frozen=True)
class SequenceStep:
    """Step of a sequence.

    `values` maps outputs to their values during the step: a number, or the name of its parameter. Other outputs are 0.
    """

    name: str
    values: Mapping[str, float | str]
    transitions: tuple[Transition, ...] = ()
    timeout: Timeout | None = None


@dataclass(frozen=True)
class SequenceProgram:
    """Steps of a sequence, in the order of declaration.

    Parameters
    ----------
    steps : tuple of SequenceStep
        The steps. The first has the number 1.
    form : Form
        Outputs, inputs, first step and emergency step of the sequence.
    values : mapping
        Mapping from the name of each parameter in the steps to its number.
    source : mapping
        Tables of the steps as the user wrote them.
    """

    steps: tuple[SequenceStep, ...]
    form: Form
    values: Mapping[str, Number]
    source: Mapping[str, Any] = dataclasses.field(repr=False)

    field: ClassVar[str] = "steps"
    """Field of the part that contains the steps."""

    @classmethod
    def read(cls, table: Any, form: Form) -> SequenceProgram:
        """Read and check the steps of a sequence; all errors are raised together."""
        if isinstance(table, cls):
            if table.form == form:
                return table
            table = table.table
        return _Reader(table, form).read()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the steps in the order of declaration."""
        return tuple(step.name for step in self.steps)

    @property
    def table(self) -> dict[str, Any]:
        """Tables of the steps with their present numbers, in the form of a circuit file."""
        result: dict[str, Any] = {}
        for step in self.steps:
            table = dict(self.source[step.name])
            if step.transitions:
                table["next"] = {t.target: t.condition.with_text(self.values) for t in step.transitions}
            if step.timeout is not None:
                table["timeout"] = {"after": written(self.values[step.timeout.place]), "to": step.timeout.target}
            if "set" in table:
                table["set"] = {
                    output: float(self.values[value].value) if isinstance(value, str) else value
                    for output, value in step.values.items()
                    if output in table["set"]
                }
            result[step.name] = table
        return result

    def number(self, name: str) -> int:
        """Return the number of a step, which begins at 1."""
        return self.names.index(name) + 1

    def numbers(self) -> dict[str, Number]:
        """Return the numbers in the steps by name, for example `extend A.next.extend B`."""
        return dict(self.values)

    def number_specs(self) -> dict[str, NumberSpec]:
        """Return the declarations of the numbers in the steps by name."""
        specs: dict[str, NumberSpec] = {}
        for step in self.steps:
            for output, value in step.values.items():
                if isinstance(value, str):
                    specs[value] = replace(_SET, doc=f"value of {output} in the step {step.name}")
            for transition in step.transitions:
                doc = f"number in the condition from {step.name} to {transition.target}"
                for literal in transition.condition.literals():
                    specs[literal.place] = NumberSpec(literal.number.unit, doc, kind=literal.kind)
            if step.timeout is not None:
                specs[step.timeout.place] = replace(_AFTER, doc=f"timeout of the step {step.name}")
        return specs

    def with_numbers(self, changes: Mapping[str, Number]) -> SequenceProgram:
        """Return a copy in which some numbers are replaced."""
        specs = self.number_specs()
        for name, number in changes.items():
            # A gauge value is in a condition, which has no limits.
            if not is_symbolic(number.value) and number.reference != "gauge":
                specs[name].check(name, number.value, number.display())
        return replace(self, values={**self.values, **changes})

    def operands(self) -> dict[Operand, str]:
        """Return the operands of all conditions, each with the address of its first condition."""
        result: dict[Operand, str] = {}
        for step in self.steps:
            for transition in step.transitions:
                for operand in transition.condition.operands():
                    result.setdefault(operand, f"{step.name}.next.{transition.target}")
        return result

    def readings(self) -> dict[str, tuple[Reading, str]]:
        """Return the outputs of the circuit that the conditions read, by the name of the input of the sequence.

        Each value contains the output and the address of the first condition that reads it.
        """
        result: dict[str, tuple[Reading, str]] = {}
        taken = {*_RESERVED, *self.form.outputs, *self.form.inputs}
        addresses: set[str] = set()
        for operand, place in self.operands().items():
            if isinstance(operand, Reading) and operand.address not in addresses:
                addresses.add(operand.address)
                first = name = re.sub(r"[^A-Za-z0-9_]", "_", operand.address)
                k = 1
                while name in taken or name in result:
                    k += 1
                    name = f"{first}_{k}"
                result[name] = operand, place
        return result

    def compared_as_integers(self) -> set[str]:
        """Return the addresses of the outputs that a condition compares by == or !=."""
        transitions = (transition for step in self.steps for transition in step.transitions)
        return set().union(*(transition.condition.compared_as_integers() for transition in transitions))

    def counted(self) -> tuple[str, ...]:
        """Return the steps whose entries a condition counts, in the order of declaration."""
        names = {operand.step for operand in self.operands() if isinstance(operand, Internal) and operand.step}
        return tuple(name for name in self.names if name in names)

    def structure(self) -> Hashable:
        """Return a key of the equations: everything except the values of the parameters."""
        trees = (
            (step.name, tuple(step.values.items()), step.timeout and step.timeout.target,
             tuple((t.target, _shape(t.condition.tree)) for t in step.transitions))
            for step in self.steps
        )  # fmt: skip
        return self.form, tuple(trees)


def _shape(node: Any) -> Hashable:
    """Return a tree of a condition without the values of its parameters."""
    match node:
        case Literal():
            return node.place or float(node.number.value)
        case Relation():
            return _shape(node.left), node.relation, _shape(node.right), node.offset and _shape(node.offset)
        case Flag() | Reading() | Internal():
            return node
    terms = (node.term,) if hasattr(node, "term") else node.terms
    return type(node).__name__, tuple(map(_shape, terms))


def read_names(errors: ErrorCollector, value: Any, address: str, taken: Collection[str] = ()) -> tuple[str, ...]:
    """Return the valid names in a list of outputs or inputs, and collect errors in the others.

    The names in `taken` are not available.
    """
    if value is None:
        return ()
    if isinstance(value, str) or not isinstance(value, Sequence):
        errors.add("sequence.no_list", address, value=value)
        return ()
    names: dict[str, None] = {}
    for name in value:
        if not isinstance(name, str) or not NAME.fullmatch(name):
            errors.add("sequence.no_name", address, name=name)
        elif name in names or name in taken:
            errors.add("sequence.name_twice", address, name=name)
        elif name in _RESERVED or COUNTER.fullmatch(name):
            errors.add("sequence.reserved", address, name=name)
        else:
            names[name] = None
    return tuple(names)


class _Reader:
    """Reader of the steps of one sequence, which collects all errors."""

    def __init__(self, table: Any, form: Form) -> None:
        self.table, self.form = table, form
        self.errors = ErrorCollector()
        self.values: dict[str, Number] = {}

    def read(self) -> SequenceProgram:
        if not isinstance(self.table, Mapping) or not self.table:
            raise InputError("sequence.no_steps", "steps", value=self.table)
        if len(self.table) > MAX_STEPS:
            raise InputError("sequence.too_many", "steps", value=len(self.table), most=MAX_STEPS)
        with self.errors as errors:
            if not self.form.start:
                errors.add("sequence.no_start", "start", example=next(iter(self.table)))
            for name, key in ((self.form.start, "start"), (self.form.emergency, "emergency")):
                if name and not self._is_step(name):
                    self._unknown_step(key, name)
            steps = tuple(self._step(name, table) for name, table in self.table.items())
            if self._is_step(self.form.start):
                self._check_reached(steps)
            self._check_units(steps)
        return SequenceProgram(steps, self.form, self.values, dict(self.table))

    def _is_step(self, name: Any) -> bool:
        # A file can contain a list or a table instead of a name.
        return isinstance(name, str) and name in self.table

    def _unknown_step(self, address: str, name: Any) -> None:
        near = NameSuggestion(str(name), self.table)
        self.errors.add("sequence.unknown_step", address, name=name, suggestion=near)

    def _step(self, name: Any, table: Any) -> SequenceStep:
        if not isinstance(name, str) or not STEP_NAME.fullmatch(name):
            self.errors.add("sequence.no_step_name", "steps", name=name)
            return SequenceStep(str(name), {})
        address = f"steps.{name}"
        if not isinstance(table, Mapping):
            self.errors.add("sequence.no_table", address, value=table)
            return SequenceStep(name, {})
        for key in table:
            if key not in _FIELDS:
                near = NameSuggestion(str(key), _FIELDS)
                self.errors.add("fields.unknown", f"{address}.{key}", table="step", suggestion=near)
        values = self._values(address, table)
        return SequenceStep(
            name, values, self._transitions(address, table.get("next", {})), self._timeout(address, table)
        )

    def _values(self, address: str, table: Mapping[str, Any]) -> dict[str, float | str]:
        values: dict[str, float | str] = {}
        with self.errors.collecting():
            on = table.get("on", ())
            if isinstance(on, str) or not isinstance(on, Sequence):
                raise InputError("sequence.no_list", f"{address}.on", value=on)
            for output in on:
                if self._is_output(f"{address}.on", output):
                    values[output] = 1.0
        with self.errors.collecting():
            given = table.get("set", {})
            if not isinstance(given, Mapping):
                raise InputError("sequence.no_mapping", f"{address}.set", value=given, example="{ valve = -1 }")
            for output, value in given.items():
                if not self._is_output(f"{address}.set", output):
                    continue
                if output in values:
                    self.errors.add("sequence.set_twice", f"{address}.set", name=output)
                    continue
                with self.errors.collecting():
                    place = f"{address.partition('.')[2]}.set.{output}"
                    self.values[place] = read_number(f"{address}.set.{output}", _SET, value)
                    values[output] = place
        return values

    def _is_output(self, address: str, output: Any) -> bool:
        if output in self.form.outputs:
            return True
        near = NameSuggestion(str(output), self.form.outputs)
        self.errors.add("sequence.unknown_output", address, name=output, suggestion=near)
        return False

    def _transitions(self, address: str, table: Any) -> tuple[Transition, ...]:
        if not isinstance(table, Mapping):
            example = '{ "extend B" = "slideA.position > 98 mm" }'
            self.errors.add("sequence.no_mapping", f"{address}.next", value=table, example=example)
            return ()
        inputs = [*self.form.inputs, *(["emergency"] if self.form.emergency else [])]
        names, transitions = Names(inputs, [str(name) for name in self.table]), []
        for target, text in table.items():
            place = f"{address.partition('.')[2]}.next.{target}"
            if target not in self.table:
                self._unknown_step(f"{address}.next.{target}", target)
            with self.errors.collecting("steps"):
                condition = parse_condition(text, names, place)
                self.values |= {literal.place: literal.number for literal in condition.literals()}
                transitions.append(Transition(target, condition))
        return tuple(transitions)

    def _timeout(self, address: str, table: Mapping[str, Any]) -> Timeout | None:
        if "timeout" not in table:
            return None
        value, address = table["timeout"], f"{address}.timeout"
        if isinstance(value, Mapping) and {*value} != {"after", "to"}:
            self.errors.add("sequence.no_timeout", address, value=dict(value))
            return None
        if not isinstance(value, Mapping):
            example = '{ after = "3 s", to = "stop" }'
            self.errors.add("sequence.no_mapping", address, value=value, example=example)
            return None
        if not self._is_step(value["to"]):
            self._unknown_step(f"{address}.to", value["to"])
        with self.errors.collecting():
            place = f"{address.partition('.')[2]}.after"
            after = read_number(f"{address}.after", _AFTER, value["after"])
            self.values[place] = after
            return Timeout(value["to"], place, after)
        return None

    def _check_reached(self, steps: Sequence[SequenceStep]) -> None:
        """Collect an error for each step to which no transition leads."""
        # From the raw tables: an invalid condition does not make its step unreachable.
        targets: dict[str, set[str]] = {}
        for name, table in self.table.items():
            following = table.get("next") if isinstance(table, Mapping) else None
            timeout = table.get("timeout") if isinstance(table, Mapping) else None
            targets[name] = {key for key in following if key in self.table} if isinstance(following, Mapping) else set()
            if isinstance(timeout, Mapping) and self._is_step(timeout.get("to")):
                targets[name].add(timeout["to"])
        reached = {self.form.start} | ({self.form.emergency} if self._is_step(self.form.emergency) else set())
        while added := {target for name in reached for target in targets[name]} - reached:
            reached |= added
        # A misspelt target is one error: the similar step counts as reached.
        unknown = [problem for problem in self.errors.collected if problem.code == "sequence.unknown_step"]
        near = {name for problem in unknown for name in problem.facts["suggestion"].names}
        while added := {target for name in near for target in targets[name]} - near:
            near |= added
        for step in steps:
            if step.name not in reached | near:
                self.errors.add("sequence.unreachable", f"steps.{step.name}", start=self.form.start)

    def _check_units(self, steps: Sequence[SequenceStep]) -> None:
        """Collect an error for each output that two conditions read with different units."""
        first: dict[str, tuple[str, str]] = {}
        reported: set[str] = set()
        for step in steps:
            for transition in step.transitions:
                place = f"steps.{step.name}.next.{transition.target}"
                for operand in transition.condition.operands():
                    if not isinstance(operand, Reading) or operand.address in reported:
                        continue
                    other, other_place = first.setdefault(operand.address, (operand.unit, place))
                    if other == operand.unit:
                        continue
                    reported.add(operand.address)
                    # A missing unit is the probable error.
                    (unit, wrong), (other, _) = (
                        ((other, other_place), (operand.unit, place))
                        if other == "1"
                        else ((operand.unit, place), (other, other_place))
                    )
                    facts = {"unit": "" if unit == "1" else unit, "is_bare": unit == "1", "other": other}
                    self.errors.add("sequence.two_units", wrong, output=operand.address, **facts)


def stated_conditions(table: Mapping[str, Any]) -> Iterator[tuple[str, Condition]]:
    """Yield the valid conditions in the table of a sequence, each with its address in the part.

    The table can have other errors.
    """
    steps, inputs = table.get("steps"), table.get("inputs")
    if not isinstance(steps, Mapping):
        return
    listed = inputs if isinstance(inputs, Sequence) and not isinstance(inputs, str) else ()
    names = Names([str(name) for name in (*listed, "emergency")], [str(name) for name in steps])
    for place, text in condition_texts(table):
        with suppress(InputError):
            yield place, parse_condition(text, names, place)


def condition_texts(table: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the texts of all conditions in the table of a sequence, valid or not, each with its address in the part."""
    steps = table.get("steps")
    for name, step in steps.items() if isinstance(steps, Mapping) else ():
        transitions = step.get("next") if isinstance(step, Mapping) else None
        for target, text in transitions.items() if isinstance(transitions, Mapping) else ():
            yield f"steps.{name}.next.{target}", text
