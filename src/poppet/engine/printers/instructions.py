"""What printers read: the functions traced from a model, and each of them as a list of instructions, cut into blocks.

A traced function works on a vector w of doubles: an instruction reads some slots of it and writes one. The arguments of
a function are vectors, of which sparse ones hold their nonzeros column by column. A printer turns the instructions into
text of some language (`poppet.engine.printers.llvm`); nothing here knows of any.

Examples
--------
>>> import casadi as ca
>>> a, b = ca.SX.sym("a"), ca.SX.sym("b")
>>> for each in instructions(ca.Function("f", [a, b], [a * b + 2.0])):
...     print(each.operation, each.result, each.arguments)
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
from typing import Any, NamedTuple

from poppet.engine.derivatives import rates_and_derivatives
from poppet.engine.elimination import solver_functions
from poppet.engine.model import Model

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
"""Arguments and results of the traced functions: x' = f, y and the memory z as in `poppet.engine.model`; `slopes` are
the time derivatives of u and `drift` that of f; LU are the factors of ``shift I - J``; E the energies of the stores."""


def traced_functions(model: Model) -> dict[str, Any]:
    """The CasADi functions of a model, as `SIGNATURES` has them; `update` only with memory."""
    import casadi as ca

    s, e = model.symbols, model.expressions
    t, x, u, p = s["t"], s["x"], s["u"], s["p"]
    slopes = ca.SX.sym("slopes", u.shape[0])
    rates, matrix, drift = rates_and_derivatives(e["rates"], (t, x, u, p), slopes)
    factor, solve = solver_functions(matrix.sparsity())
    dense = ca.densify
    # CasADi drops structural zeros of sparse outputs, so J alone is left sparse.
    merged = ca.cse([dense(rates), matrix, dense(drift)])
    functions = {
        "rates": ca.Function("rates", [t, x, u, p], ca.cse([dense(e["rates"])])),
        "jacobian": ca.Function("jacobian", [t, x, u, slopes, p], merged),
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


def outputs_function(model: Model) -> Any:
    """The CasADi function `outputs` of a model."""
    import casadi as ca

    arguments = [model.symbols[name] for name in ("t", "x", "u", "p")]
    return ca.Function("outputs", arguments, ca.cse([ca.densify(model.expressions["outputs"])]))


class Instruction(NamedTuple):
    """One operation, ``w[result] = operation(w[arguments])``."""

    # `input`, `const`, `output`, or an operation under CasADi's name, in lower case: `add`, `sqrt`, `if_else_zero`
    operation: str
    result: int  # slot of w that is written; -1 for an output
    arguments: tuple[int, ...]  # slots that are read
    constant: float = 0.0  # value of a `const`
    place: tuple[int, int] = (0, 0)  # vector and element of an `input` or `output`


class InstructionList(NamedTuple):
    """A function as a printer wants it: its instructions, and the numbers of its arguments and results."""

    instructions: Sequence[Instruction]
    n_in: int
    n_out: int

    @classmethod
    def of(cls, function: Any) -> InstructionList:
        """A traced function."""
        return cls(instructions(function), function.n_in(), function.n_out())

    @property
    def size(self) -> int:
        """Elements of w."""
        return 1 + max((each.result for each in self.instructions), default=-1)


class Block(NamedTuple):
    """A stretch of instructions, and the slots written in it that a later block reads."""

    instructions: Sequence[Instruction]
    handed_on: frozenset[int]


@cache
def _operations() -> dict[int, str]:
    """CasADi's numbers of operations and their names."""
    import casadi

    names = {getattr(casadi, name): name.removeprefix("OP_").lower() for name in dir(casadi) if name.startswith("OP_")}
    return {**names, casadi.OP_CONSTPOW: "pow"}  # a constant exponent is nothing else


def instructions(function: Any) -> list[Instruction]:
    """The instructions of a traced function, in order."""
    names = _operations()
    found = []
    for k in range(function.n_instructions()):
        name = names[function.instruction_id(k)]
        inputs, outputs = function.instruction_input(k), function.instruction_output(k)
        if name == "const":
            found.append(Instruction(name, outputs[0], (), constant=function.instruction_constant(k)))
        elif name == "input":
            found.append(Instruction(name, outputs[0], (), place=(inputs[0], inputs[1])))
        elif name == "output":
            found.append(Instruction(name, -1, (inputs[0],), place=(outputs[0], outputs[1])))
        else:
            found.append(Instruction(name, outputs[0], tuple(inputs)))
    return found


def blocks(every: Sequence[Instruction], size: int) -> list[Block]:
    """The same list in stretches of at most `size`, for compilers whose time grows faster than a function's length."""
    found: list[Block] = []
    live: set[int] = set()
    # Backwards: what is read below is what a block has to hand on.
    for first in reversed(range(0, len(every), size)):
        stretch = every[first : first + size]
        written = {each.result for each in stretch}
        found.append(Block(stretch, frozenset(written & live)))
        for each in reversed(stretch):
            live.discard(each.result)
            live.update(each.arguments)
    return found[::-1]
