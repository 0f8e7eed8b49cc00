"""Traced functions, rewritten for lanes: what numbers alone decide is worked out once a run, and fewer divisions.

Vectors do not forgive divisions: eight of them take the time of a hundred multiplications. So

- a quotient is a product with an inverse, which all that divide by the same share; the inverse of a root is one
  operation, and that of twice a number half of one;
- what depends on nothing but the numbers in p is an element behind p, written by `derived` when a lane takes a run.

None of this moves a result by more than rounding.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from poppet.engine.model import Model
from poppet.engine.printers.instructions import SIGNATURES, Instruction, InstructionList, instructions

_Key = tuple[Any, ...]
"""An operation and its arguments, `input`, name of the vector and element, or `const` and value."""


class LaneListings(NamedTuple):
    """Functions by name, and how many elements `derived` puts behind p."""

    functions: dict[str, InstructionList]
    n_derived: int


def lane_listings(functions: Mapping[str, Any], model: Model) -> LaneListings:
    """`rates`, `jacobian`, and `jacobian_held` for inputs that hold still, all with `derived` behind p."""
    values, n_p = _Values(len(model.parameters)), len(model.parameters) + len(model.memory)
    made = {
        "rates": values.read(functions["rates"], "rates"),
        "jacobian": values.read(functions["jacobian"], "jacobian"),
        "jacobian_held": values.read(functions["jacobian"], "jacobian", nought=("slopes",)),
    }
    behind: dict[int, int] = {}
    listed = {name: values.listed(results, name.removesuffix("_held"), n_p, behind) for name, results in made.items()}
    results = [((0, k), value) for value, k in behind.items()]
    listed["derived"] = InstructionList(values.ordered(results, {"p": 0}, n_p, {}), 1, 1)
    return LaneListings(listed, len(behind))


class _Values:
    """Values of several functions, each of which is there once."""

    def __init__(self, n_numbers: int) -> None:
        self.n_numbers = n_numbers
        self.keys: list[_Key] = []
        self.is_fixed: list[bool] = []  # whether it depends on nothing but numbers
        self._places: dict[_Key, int] = {}

    def read(self, function: Any, name: str, nought: Sequence[str] = ()) -> list[tuple[tuple[int, int], int]]:
        """Take a function whose arguments have the names of `SIGNATURES`; places of its results, and their values."""
        given = SIGNATURES[name].partition("->")[0].split()
        slots: dict[int, int] = {}
        found = []
        for each in instructions(function):
            if each.operation == "output":
                found.append((each.place, slots[each.arguments[0]]))
            elif each.operation == "const":
                slots[each.result] = self.constant(each.constant)
            elif each.operation == "input":
                vector, element = given[each.place[0]], each.place[1]
                is_nought = vector in nought
                slots[each.result] = self.constant(0.0) if is_nought else self._known("input", vector, element)
            else:
                slots[each.result] = self.put(each.operation, *(slots[slot] for slot in each.arguments))
        return found

    def constant(self, value: float) -> int:
        """A constant; -0.0 is another one than 0.0."""
        return self._known("const", value, str(value))

    def put(self, operation: str, *arguments: int) -> int:
        """The value of an operation, in its simplest form."""
        simpler = _RULES.get(operation)
        found = simpler(self, *arguments) if simpler else None
        return self._known(operation, *arguments) if found is None else found

    def _known(self, *key: Any) -> int:
        if key not in self._places:
            self._places[key] = len(self.keys)
            self.keys.append(key)
            if key[0] == "input":
                fixed = key[1] == "p" and key[2] < self.n_numbers
            else:
                fixed = key[0] == "const" or all(self.is_fixed[a] for a in key[1:])
            self.is_fixed.append(fixed)
        return self._places[key]

    def is_of(self, value: int, operation: str) -> bool:
        """Whether a value is the result of an operation."""
        return bool(self.keys[value][0] == operation)

    def is_number(self, value: int, number: float) -> bool:
        """Whether a value is this constant."""
        key = self.keys[value]
        return bool(key[0] == "const" and key[1] == number)

    def listed(self, results: Any, name: str, n_p: int, behind: dict[int, int]) -> InstructionList:
        """A function of some values, with those of numbers alone behind p, where `behind` says or comes to say."""
        given, _, made = SIGNATURES[name].partition("->")
        vectors = {vector: k for k, vector in enumerate(given.split())}
        wanted = self._needed([value for _, value in results], stops=True)
        for value in wanted:
            if self._is_derived(value):
                behind.setdefault(value, len(behind))
        return InstructionList(self.ordered(results, vectors, n_p, behind), len(vectors), len(made.split()))

    def _is_derived(self, value: int) -> bool:
        return self.is_fixed[value] and self.keys[value][0] not in ("input", "const")

    def _needed(self, results: Sequence[int], *, stops: bool) -> list[int]:
        """Values that these need, in order; where it `stops`, none below one of numbers alone."""
        wanted, found = set(results), []
        for value in reversed(range(max(results, default=-1) + 1)):
            if value not in wanted:
                continue
            found.append(value)
            key = self.keys[value]
            if key[0] not in ("input", "const") and not (stops and self._is_derived(value)):
                wanted.update(key[1:])
        return found[::-1]

    def ordered(
        self, results: Any, vectors: Mapping[str, int], n_p: int, behind: Mapping[int, int]
    ) -> list[Instruction]:
        """Instructions of some values, those of `behind` read from there."""
        needed = self._needed([value for _, value in results], stops=bool(behind))
        last: dict[int, int] = {}
        for value in needed:
            if value not in behind and self.keys[value][0] not in ("input", "const"):
                last.update(dict.fromkeys(self.keys[value][1:], value))
        last.update({value: len(self.keys) for _, value in results})
        slots: dict[int, int] = {}
        free: list[int] = []
        found, size = [], 0
        for value in needed:
            key = self.keys[value]
            arguments: tuple[int, ...] = ()
            if value not in behind and key[0] not in ("input", "const"):
                arguments = tuple(slots[a] for a in key[1:])
                free += [slots[a] for a in dict.fromkeys(key[1:]) if last[a] == value]
            if free:
                slots[value] = free.pop()
            else:
                slots[value], size = size, size + 1
            if value in behind:
                found.append(Instruction("input", slots[value], (), place=(vectors["p"], n_p + behind[value])))
            elif key[0] == "input":
                found.append(Instruction("input", slots[value], (), place=(vectors[key[1]], key[2])))
            else:
                constant = key[1] if key[0] == "const" else 0.0
                found.append(Instruction(key[0], slots[value], arguments, constant))
        return found + [Instruction("output", -1, (slots[value],), place=place) for place, value in results]


# --- Rules: the value, or None where an operation is as simple as it gets ---


def _product(values: _Values, a: int, b: int) -> int | None:
    for one, other in ((a, b), (b, a)):
        if values.is_number(one, 0.0):
            return one
        if values.is_number(one, 1.0):
            return other
        # Numbers first, for their product is one of them.
        if values.is_fixed[one] and not values.is_fixed[other] and values.is_of(other, "mul"):
            for first, second in ((c := values.keys[other][1:]), c[::-1]):
                if values.is_fixed[first]:
                    return values.put("mul", values.put("mul", one, first), second)
    return None if a <= b else values.put("mul", b, a)


def _sum(values: _Values, a: int, b: int) -> int | None:
    if values.is_number(a, 0.0):
        return b
    return a if values.is_number(b, 0.0) else None


def _difference(values: _Values, a: int, b: int) -> int | None:
    if values.is_number(b, 0.0):
        return a
    return values.put("neg", b) if values.is_number(a, 0.0) else None


def _nought(values: _Values, *arguments: int) -> int | None:
    return arguments[-1] if values.is_number(arguments[-1], 0.0) else None


def _quotient(values: _Values, a: int, b: int) -> int:
    while values.is_of(a, "twice") and values.is_of(b, "twice"):
        a, b = values.keys[a][1], values.keys[b][1]
    return values.put("mul", a, values.put("inverse", b))


def _inverse(values: _Values, a: int) -> int | None:
    key = values.keys[a]
    if key[0] == "const" and key[1] != 0.0:
        return values.constant(1.0 / key[1])
    if key[0] == "twice":
        return values.put("mul", values.constant(0.5), values.put("inverse", key[1]))
    return values.put("inverse_root", key[1]) if key[0] == "sqrt" else None


_RULES: dict[str, Any] = {
    "assign": lambda _, a: a,
    "add": _sum,
    "sub": _difference,
    "mul": _product,
    "div": _quotient,
    "inv": lambda values, a: values.put("inverse", a),
    "inverse": _inverse,
    "neg": _nought,
    "twice": _nought,
    "if_else_zero": _nought,
}
