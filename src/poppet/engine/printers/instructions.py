"""Traced functions of a model as lists of instructions, for all printers (code generators).

A traced function uses a vector w of doubles: an instruction reads some slots and writes one. The arguments of a
function are vectors; sparse arguments contain their nonzeros in column order. A printer converts the instructions to
text in one language, for example `poppet.engine.printers.llvm`; this module does not depend on a language.

Examples
--------
>>> import casadi as ca
>>> a, b = ca.SX.sym("a"), ca.SX.sym("b")
>>> for instruction in instructions(ca.Function("f", [a, b], [a * b + 2.0])):
...     print(instruction.operation, instruction.result, instruction.arguments)
input 0 ()
input 1 ()
mul 0 (0, 1)
const 1 ()
add 0 (0, 1)
output -1 (0,)
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.engine.derivatives import differentiate_rates
from poppet.engine.elimination import solver_functions
from poppet.engine.model import Model

if TYPE_CHECKING:
    import casadi

SIGNATURES = {
    "rates": "t x u p -> f",
    "jacobian": "t x u slopes p -> f J drift",
    "factor": "J shift -> LU",
    "solve": "LU b -> x",
    "outputs": "t x u p -> y",
    "start": "p -> x z",
    "energy": "t x u p -> E",
    "update": "t x u p fired -> z",
}
"""Arguments and results of the traced functions: x' = f, outputs y and discrete states z of `poppet.engine.model`.

`slopes` is the time derivative of u, and `drift` that of f. LU are the factors of ``shift I - J``, E the energies."""


def trace_functions(model: Model) -> dict[str, Any]:
    """Return the CasADi functions of a model by name, for example `rates` and `outputs`.

    The names are keys of `SIGNATURES`. The function `update` is included only if the model has discrete states.
    """
    import casadi as ca

    s, e = model.symbols, model.expressions
    t, x, u, p = s["t"], s["x"], s["u"], s["p"]
    slopes = ca.SX.sym("slopes", u.shape[0])
    rates, matrix, drift = differentiate_rates(e["rates"], (t, x, u, p), slopes)
    factor, solve = solver_functions(matrix.sparsity())
    dense = ca.densify
    # Only J is sparse: CasADi drops structural zeros of sparse outputs.
    results = ca.cse([dense(rates), matrix, dense(drift)])
    functions = {
        # The rates of the Jacobian have no common subexpressions.
        "rates": ca.Function("rates", [t, x, u, p], [dense(rates)]),
        "jacobian": ca.Function("jacobian", [t, x, u, slopes, p], results),
        "factor": factor,
        "solve": solve,
        "outputs": outputs_function(model),
        "start": ca.Function("start", [p], [dense(e["start"]), dense(e["memory_start"])]),
        "energy": ca.Function("energy", [t, x, u, p], [dense(e["energy"])]),
    }
    if model.memory:
        update = ca.cse([dense(e["update"])])
        functions["update"] = ca.Function("update", [t, x, u, p, s["fired"]], update)
    return functions


def outputs_function(model: Model) -> casadi.Function:
    """Return the CasADi function that computes the outputs y of a model."""
    import casadi as ca

    arguments = [model.symbols[name] for name in ("t", "x", "u", "p")]
    return ca.Function("outputs", arguments, ca.cse([ca.densify(model.expressions["outputs"])]))


class Instruction(NamedTuple):
    """One instruction of a traced function: ``w[result] = operation(w[arguments])``."""

    operation: str  # `input`, `const`, `output`, or a CasADi operation in lower case: `add`, `sqrt`, `if_else_zero`
    result: int  # written slot of w; -1 for an output
    arguments: tuple[int, ...]  # read slots
    constant: float = 0.0  # value of a `const`
    place: tuple[int, int] = (0, 0)  # vector and element of an `input` or `output`


class InstructionList(NamedTuple):
    """Instructions of one function, with the counts of its arguments and results."""

    instructions: Sequence[Instruction]
    n_in: int
    n_out: int

    @classmethod
    def of(cls, function: Any) -> InstructionList:
        """Return the instructions of a CasADi function as a list."""
        return cls(instructions(function), function.n_in(), function.n_out())

    @property
    def size(self) -> int:
        """Length of the vector w of intermediate values."""
        return 1 + max((instruction.result for instruction in self.instructions), default=-1)


class Block(NamedTuple):
    """Sequence of instructions that is printed as one function.

    The instructions work on a vector w of intermediate values. `live_out` contains the elements of w that this block
    writes and later blocks read.
    """

    instructions: Sequence[Instruction]
    live_out: frozenset[int]


@cache
def _operations() -> dict[int, str]:
    """Return a mapping from the operation codes of CasADi to operation names."""
    import casadi

    names = {getattr(casadi, name): name.removeprefix("OP_").lower() for name in dir(casadi) if name.startswith("OP_")}
    return {**names, casadi.OP_CONSTPOW: "pow"}  # power with a constant exponent


def instructions(function: Any) -> list[Instruction]:
    """Return the instructions of a CasADi function in the order of execution."""
    names = _operations()
    result = []
    for k in range(function.n_instructions()):
        name = names[function.instruction_id(k)]
        inputs, outputs = function.instruction_input(k), function.instruction_output(k)
        if name == "const":
            result.append(Instruction(name, outputs[0], (), constant=function.instruction_constant(k)))
        elif name == "input":
            result.append(Instruction(name, outputs[0], (), place=(inputs[0], inputs[1])))
        elif name == "output":
            result.append(Instruction(name, -1, (inputs[0],), place=(outputs[0], outputs[1])))
        else:
            result.append(Instruction(name, outputs[0], tuple(inputs)))
    return result


def blocks(function: Sequence[Instruction], size: int) -> list[Block]:
    """Divide instructions into blocks of at most `size` instructions.

    Blocks limit the compilation time, which increases faster than linearly with the length of a function.
    """
    result: list[Block] = []
    live: set[int] = set()
    # In reverse order, to find the slots that later blocks read.
    for first in reversed(range(0, len(function), size)):
        block = function[first : first + size]
        written = {instruction.result for instruction in block}
        result.append(Block(block, frozenset(written & live)))
        for instruction in reversed(block):
            live.discard(instruction.result)
            live.update(instruction.arguments)
    return result[::-1]
