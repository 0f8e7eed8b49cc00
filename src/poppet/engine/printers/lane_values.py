"""Simplification of traced functions for lanes (runs that are computed simultaneously).

Divisions of vectors are expensive: eight divisions take the time of a hundred multiplications. Therefore

- a quotient is a product with an inverse, which divisions by the same value share; the inverse of a root is one
  operation, and the inverse of twice a number is half of its inverse;
- an expression that depends only on parameters is an additional element of p, which `derived` computes at the start of
  a run.

The results change only by rounding.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from poppet.engine.model import Model
from poppet.engine.printers.instructions import SIGNATURES, Instruction, InstructionList, instructions

_Key = tuple[Any, ...]
"""Operation and arguments; or `input`, vector and element; or `const` and value."""


class LaneListings(NamedTuple):
    """Simplified functions for simultaneous runs (lanes), by name.

    The function `derived` appends `n_derived` elements to p.
    """

    functions: dict[str, InstructionList]
    n_derived: int


def lane_listings(functions: Mapping[str, Any], model: Model) -> LaneListings:
    """Return the functions `rates`, `jacobian` and `jacobian_held` in a simplified form.

    `jacobian_held` is valid for constant inputs. The function `derived` computes the elements that are appended to p.
    """
    values, n_p = _Values(len(model.parameters)), len(model.parameters) + len(model.memory)
    results_of = {
        "rates": values.read(functions["rates"], "rates"),
        "jacobian": values.read(functions["jacobian"], "jacobian"),
        "jacobian_held": values.read(functions["jacobian"], "jacobian", zero=("slopes",)),
    }
    derived: dict[int, int] = {}
    listings = {
        name: values.list_function(results, name.removesuffix("_held"), n_p, derived)
        for name, results in results_of.items()
    }
    results = [((0, k), value) for value, k in derived.items()]
    listings["derived"] = InstructionList(values.order(results, {"p": 0}, n_p, {}), 1, 1)
    return LaneListings(listings, len(derived))


class _Values:
    """Table of all different values that some functions compute.

    A value is the result of an operation, and is represented by its index in the table.
    """

    def __init__(self, n_numbers: int) -> None:
        self.n_numbers = n_numbers
        self.keys: list[_Key] = []
        self.is_fixed: list[bool] = []  # True if the value depends only on parameters
        self._indices: dict[_Key, int] = {}

    def read(self, function: Any, name: str, zero: Sequence[str] = ()) -> list[tuple[tuple[int, int], int]]:
        """Add the instructions of a function to the table, and return its results.

        Each result is a pair. Its first item is the index of a result vector with the index of an element, and its
        second item is the index of the value. `zero` contains the names of arguments that are always zero.
        """
        vectors = SIGNATURES[name].partition("->")[0].split()
        slots: dict[int, int] = {}
        results = []
        for instruction in instructions(function):
            if instruction.operation == "output":
                results.append((instruction.place, slots[instruction.arguments[0]]))
            elif instruction.operation == "const":
                slots[instruction.result] = self.constant(instruction.constant)
            elif instruction.operation == "input":
                vector, element = vectors[instruction.place[0]], instruction.place[1]
                slots[instruction.result] = (
                    self.constant(0.0) if vector in zero else self._index("input", vector, element)
                )
            else:
                slots[instruction.result] = self.put(
                    instruction.operation, *(slots[slot] for slot in instruction.arguments)
                )
        return results

    def constant(self, value: float) -> int:
        """Add a constant, and return the index of its value.

        -0.0 and 0.0 are different constants.
        """
        return self._index("const", value, str(value))

    def put(self, operation: str, *arguments: int) -> int:
        """Add an operation in its simplest form, and return the index of its value.

        For example, x + 0 becomes x.
        """
        a, b = arguments[0], arguments[-1]
        match operation:
            case "assign":
                return a
            case "add" if self.is_number(a, 0.0):
                return b
            case "add" | "sub" if self.is_number(b, 0.0):
                return a
            case "sub" if self.is_number(a, 0.0):
                return self.put("neg", b)
            case "neg" | "twice" | "if_else_zero" if self.is_number(b, 0.0):
                return b
            case "mul":
                return self._put_product(a, b)
            case "div":
                while self.is_of(a, "twice") and self.is_of(b, "twice"):
                    a, b = self.keys[a][1], self.keys[b][1]
                return self._put_product(a, self.put("inverse", b))
            case "inv":
                return self.put("inverse", a)
            case "inverse":
                key = self.keys[a]
                if key[0] == "const" and key[1] != 0.0:
                    return self.constant(1.0 / key[1])
                if key[0] == "twice":
                    return self._put_product(self.constant(0.5), self.put("inverse", key[1]))
                if key[0] == "sqrt":
                    return self.put("inverse_root", key[1])
        return self._index(operation, *arguments)

    def _put_product(self, a: int, b: int) -> int:
        for left, right in ((a, b), (b, a)):
            if self.is_number(left, 0.0):
                return left
            if self.is_number(left, 1.0):
                return right
            # Parameters first, because their product is a parameter expression.
            if self.is_fixed[left] and not self.is_fixed[right] and self.is_of(right, "mul"):
                for first, second in ((c := self.keys[right][1:]), c[::-1]):
                    if self.is_fixed[first]:
                        return self._put_product(self._put_product(left, first), second)
        return self._index("mul", a, b) if a <= b else self._put_product(b, a)

    def _index(self, *key: Any) -> int:
        if key not in self._indices:
            self._indices[key] = len(self.keys)
            self.keys.append(key)
            if key[0] == "input":
                fixed = key[1] == "p" and key[2] < self.n_numbers
            else:
                fixed = key[0] == "const" or all(self.is_fixed[a] for a in key[1:])
            self.is_fixed.append(fixed)
        return self._indices[key]

    def is_of(self, value: int, operation: str) -> bool:
        """Return True if a value is the result of a given operation.

        `value` is an index.
        """
        return bool(self.keys[value][0] == operation)

    def is_number(self, value: int, number: float) -> bool:
        """Return True if a value is a given constant.

        `value` is an index.
        """
        key = self.keys[value]
        return bool(key[0] == "const" and key[1] == number)

    def list_function(self, results: Any, name: str, n_p: int, derived: dict[int, int]) -> InstructionList:
        """Return the instructions of the function `name`, which computes `results`.

        Expressions that depend only on parameters are added to `derived`, which maps a value to the index of its
        additional element in p. `n_p` is the original length of p.
        """
        arguments, _, outputs = SIGNATURES[name].partition("->")
        vectors = {vector: k for k, vector in enumerate(arguments.split())}
        for value in self._needed([value for _, value in results], stops=True):
            if self._is_derived(value):
                derived.setdefault(value, len(derived))
        return InstructionList(self.order(results, vectors, n_p, derived), len(vectors), len(outputs.split()))

    def _is_derived(self, value: int) -> bool:
        return self.is_fixed[value] and self.keys[value][0] not in ("input", "const")

    def _needed(self, results: Sequence[int], *, stops: bool) -> list[int]:
        """Return the indices of all values that are required for given results, in order of computation.

        If the keyword `stops` is True, operands of expressions that depend only on parameters are omitted.
        """
        needed, values = set(results), []
        for value in reversed(range(max(results, default=-1) + 1)):
            if value not in needed:
                continue
            values.append(value)
            key = self.keys[value]
            if key[0] not in ("input", "const") and not (stops and self._is_derived(value)):
                needed.update(key[1:])
        return values[::-1]

    def order(
        self, results: Any, vectors: Mapping[str, int], n_p: int, derived: Mapping[int, int]
    ) -> list[Instruction]:
        """Return the instructions that compute `results`, in the form that `read` returns.

        Values in `derived` are read from p instead of being computed. `vectors` contains the indices of the arguments,
        and `n_p` is the original length of p.
        """
        needed = self._needed([value for _, value in results], stops=bool(derived))
        last: dict[int, int] = {}
        for value in needed:
            if value not in derived and self.keys[value][0] not in ("input", "const"):
                last.update(dict.fromkeys(self.keys[value][1:], value))
        last.update({value: len(self.keys) for _, value in results})
        slots: dict[int, int] = {}
        free: list[int] = []
        listing, size = [], 0
        for value in needed:
            key = self.keys[value]
            arguments: tuple[int, ...] = ()
            if value not in derived and key[0] not in ("input", "const"):
                arguments = tuple(slots[a] for a in key[1:])
                free += [slots[a] for a in dict.fromkeys(key[1:]) if last[a] == value]
            if free:
                slots[value] = free.pop()
            else:
                slots[value], size = size, size + 1
            if value in derived:
                listing.append(Instruction("input", slots[value], (), place=(vectors["p"], n_p + derived[value])))
            elif key[0] == "input":
                listing.append(Instruction("input", slots[value], (), place=(vectors[key[1]], key[2])))
            else:
                constant = key[1] if key[0] == "const" else 0.0
                listing.append(Instruction(key[0], slots[value], arguments, constant))
        return listing + [Instruction("output", -1, (slots[value],), place=element) for element, value in results]
