"""Printer (code generator) of a model as a WebAssembly module, without LLVM.

Each instruction of a traced function becomes a few instructions of WebAssembly, which browsers optimise. The module has
the functions of a model, an integration step and its interpolant, with the operations of `poppet.engine.printers.llvm`
and `poppet.engine.printers.llvm_step` in the same order, so the results are equal. Long functions are divided into
blocks, which pass values in memory. The encoding is that of the WebAssembly core specification, section 5.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING

from poppet.deploy.live.wasm_format import (
    MAGIC,
    encode_name,
    encode_section,
    encode_signed,
    encode_unsigned,
    encode_vector,
)
from poppet.engine.printers.instructions import Block, blocks, instructions
from poppet.engine.printers.llvm import OF_ONE, OF_TWO
from poppet.engine.rosenbrock import ARGUMENT, COUPLING, DENSE, GAMMA, INPUT_TIMES, STAGE_DRIFT, STAGE_TIME

if TYPE_CHECKING:
    import casadi

BLOCK_SIZE = 2000
"""Instructions per block; browsers compile longer functions slowly."""
_TYPE, _IMPORT, _FUNCTION, _EXPORT, _ELEMENT, _CODE = 1, 2, 3, 7, 9, 10
_F64, _I32, _NOTHING = b"\x7c", b"\x7f", b"\x40"
_IF, _LOOP, _ELSE, _END, _BRANCH_IF = b"\x04", b"\x03", b"\x05", b"\x0b", b"\x0d\0"
_SELECT, _FROM_FLAG = b"\x1b", b"\xb7"  # a flag is an integer, and becomes 0.0 or 1.0
_ADD, _SUB, _MUL, _DIV, _SQRT = b"\xa0", b"\xa1", b"\xa2", b"\xa3", b"\x9f"
_EQ, _NE, _LT, _GT, _LE = b"\x61", b"\x62", b"\x63", b"\x64", b"\x65"
_ADD_INT, _SUB_INT, _LESS_INT, _AND_INT, _OR_INT = b"\x6a", b"\x6b", b"\x49", b"\x71", b"\x72"
_STACK_GET, _STACK_SET = b"\x23\0", b"\x24\0"
Form = tuple[int | bytes, ...]
"""Code of an operation; 0 and 1 are its arguments."""


def _constant(value: float) -> bytes:
    return b"\x44" + struct.pack("<d", value)


@cache
def _get(local: int) -> bytes:
    return b"\x20" + encode_unsigned(local)


@cache
def _set(local: int) -> bytes:
    return b"\x21" + encode_unsigned(local)


def _integer(value: int) -> bytes:
    return b"\x41" + encode_signed(value)


@cache
def _load(element: int) -> bytes:
    return b"\x2b\x03" + encode_unsigned(8 * element)


@cache
def _store(element: int) -> bytes:
    return b"\x39\x03" + encode_unsigned(8 * element)


def _call(function: int) -> bytes:
    return b"\x10" + encode_unsigned(function)


_ZERO, _ONE = _constant(0.0), _constant(1.0)
_LIBRARY = (*OF_ONE, *OF_TWO)
_POWER = len(_LIBRARY)
"""Index of the function `power`, the first after the imports."""
_FORMS: dict[str, Form] = {
    "assign": (0,),
    "add": (0, 1, _ADD),
    "sub": (0, 1, _SUB),
    "mul": (0, 1, _MUL),
    "div": (0, 1, _DIV),
    "neg": (0, b"\x9a"),
    "sq": (0, 0, _MUL),
    "twice": (0, 0, _ADD),
    "inv": (_ONE, 0, _DIV),
    "fmin": (0, 1, 0, 1, _LT, _SELECT),
    "fmax": (0, 1, 0, 1, _GT, _SELECT),
    "if_else_zero": (1, _ZERO, 0, _ZERO, _NE, _SELECT),
    "not": (0, _ZERO, _EQ, _FROM_FLAG),
    "and": (0, _ZERO, _NE, 1, _ZERO, _NE, _AND_INT, _FROM_FLAG),
    "or": (0, _ZERO, _NE, 1, _ZERO, _NE, _OR_INT, _FROM_FLAG),
    "sign": (_ONE, 0, b"\xa6", _ZERO, 0, _ZERO, _LT, 0, _ZERO, _GT, _OR_INT, _SELECT),
    "copysign": (0, 1, b"\xa6"),
    "lt": (0, 1, _LT, _FROM_FLAG),
    "le": (0, 1, _LE, _FROM_FLAG),
    "eq": (0, 1, _EQ, _FROM_FLAG),
    "ne": (0, 1, _NE, _FROM_FLAG),
    "sqrt": (0, _SQRT),
    "fabs": (0, b"\x99"),
    "floor": (0, b"\x9c"),
    "ceil": (0, b"\x9b"),
    **{name: (0, _call(_LIBRARY.index(name))) for name in OF_ONE},
    "atan2": (0, 1, _call(_LIBRARY.index("atan2"))),
    "pow": (0, 1, _call(_POWER)),
}


class PrintedFunctions:
    """Functions of a module, in the order of their indices: imports of the library, `power`, and those of the model."""

    def __init__(self) -> None:
        # Types: one and two numbers to a number; type 2 + n has n addresses and no result.
        self.types = [0] * len(OF_ONE) + [1] * len(OF_TWO) + [1]
        self.bodies = [_body([], [_power()])]
        self.places: dict[str, int] = {}

    def add(self, name: str, n_arguments: int, code: Sequence[bytes], numbers: int, integers: int = 0) -> int:
        """Add a function with local variables after its arguments: first numbers, then integers. Return its index."""
        groups = [encode_unsigned(n) + kind for n, kind in ((numbers, _F64), (integers, _I32)) if n]
        self.types.append(2 + n_arguments)
        self.bodies.append(_body(groups, code))
        self.places[name] = len(self.types) - 1
        return self.places[name]

    def call(self, name: str) -> bytes:
        """Return the code of a call."""
        return _call(self.places[name])


def _body(local_variables: Sequence[bytes], code: Sequence[bytes]) -> bytes:
    content = encode_vector(local_variables) + b"".join(code) + _END
    return encode_unsigned(len(content)) + content


def _power() -> bytes:
    """Return the code of the power x^e, with a square root for the exponents 1/2 and -1/2."""
    x, e, kind = _get(0), _get(1), _F64
    inverse = e + _constant(-0.5) + _EQ + _IF + kind + _ONE + x + _SQRT + _DIV + _ELSE
    general = x + e + _call(_LIBRARY.index("pow"))
    return e + _constant(0.5) + _EQ + _IF + kind + x + _SQRT + _ELSE + inverse + general + _END + _END


def print_module(
    functions: Mapping[str, casadi.Function],
    sizes: tuple[int, int, int],
    exports: Sequence[str],
    called: Sequence[str],
    *,
    memory: int,
) -> tuple[bytes, dict[str, int]]:
    """Return the module of a model, and the indices in the table of the functions that the integrator calls.

    Parameters
    ----------
    functions : mapping
        Traced functions by name.
    sizes : tuple of int
        Number of states, of states with error control, and of inputs.
    exports : sequence of str
        Functions that the page calls by name.
    called : sequence of str
        Functions that the integrator calls, from index 1 of the table. Those that a model does not have are left out.
    memory : int
        Smallest memory [pages].
    """
    module = PrintedFunctions()
    for name, function in functions.items():
        _add_function(module, name, function)
    if sizes[0]:
        _add_step(module, *sizes)
        _add_dense(module, sizes[0])
    tabled = [name for name in called if name in module.places]
    numbers = [b"\x60" + encode_vector([_F64] * n) + encode_vector([_F64]) for n in (1, 2)]
    most = max(module.types) - 1
    types = [*numbers, *(b"\x60" + encode_vector([_I32] * n) + encode_vector([]) for n in range(most))]
    imports = [
        encode_name("env") + encode_name(name) + b"\0" + encode_unsigned(module.types[k])
        for k, name in enumerate(_LIBRARY)
    ]
    shared = {"table": b"\x01\x70\0" + encode_unsigned(1 + len(tabled)), "memory": b"\x02\0" + encode_unsigned(memory)}
    shared["stack"] = b"\x03" + _I32 + b"\1"
    imports += [encode_name("shared") + encode_name(name) + entry for name, entry in shared.items()]
    entries = [encode_name(name) + b"\0" + encode_unsigned(module.places[name]) for name in exports]
    element = b"\0" + _integer(1) + _END + encode_vector([encode_unsigned(module.places[name]) for name in tabled])
    defined = module.types[len(_LIBRARY) :]
    sections = {
        _TYPE: types,
        _IMPORT: imports,
        _FUNCTION: [encode_unsigned(kind) for kind in defined],
        _EXPORT: entries,
        _ELEMENT: [element],
        _CODE: module.bodies,
    }
    code = b"".join(encode_section(kind, encode_vector(content)) for kind, content in sections.items())
    return MAGIC + code, {name: k + 1 for k, name in enumerate(tabled)}


def _add_function(module: PrintedFunctions, name: str, function: casadi.Function) -> None:
    """Add a traced function, whose arguments are the addresses of its inputs and outputs."""
    listing, n_in = instructions(function), function.n_in()
    n_arguments = n_in + function.n_out()
    parts = blocks(listing, BLOCK_SIZE)
    if len(parts) <= 1:
        code, n_locals = _block_code(parts[0], n_in, n_arguments) if parts else ([], 0)
        module.add(name, n_arguments, code, n_locals)
        return
    # The values that blocks pass are on the stack; their address is an additional argument.
    calls = []
    for k, block in enumerate(parts):
        code, n_locals = _block_code(block, n_in, n_arguments + 1)
        calls.append(_call(module.add(f"{name}.{k}", n_arguments + 1, code, n_locals)))
    size = _integer(8 * (1 + max(instruction.result for instruction in listing)))
    arguments = b"".join(map(_get, range(n_arguments + 1)))
    enter = [_STACK_GET, size, _SUB_INT, _set(n_arguments), _get(n_arguments), _STACK_SET]
    leave = [_get(n_arguments), size, _ADD_INT, _STACK_SET]
    module.add(name, n_arguments, [*enter, *(arguments + call for call in calls), *leave], 0, 1)


def _block_code(block: Block, n_in: int, n_arguments: int) -> tuple[list[bytes], int]:
    """Return the code of a sequence of instructions, and the number of its local variables.

    Values of previous blocks are loaded when they are first used. Values that later blocks read are stored at the end.
    The last argument is the address of these values.
    """
    code: list[bytes] = []
    local_of: dict[int, int] = {}
    passed = _get(n_arguments - 1)

    def own(slot: int) -> int:
        return local_of.setdefault(slot, n_arguments + len(local_of))

    def value(slot: int) -> bytes:
        if slot not in local_of:
            code.extend((passed, _load(slot), _set(own(slot))))
        return _get(local_of[slot])

    for operation, result, arguments, constant, (vector, element) in block.instructions:
        if operation == "output":
            read = value(arguments[0])
            code.extend((_get(n_in + vector), read, _store(element)))
            continue
        if operation == "input":
            code.extend((_get(vector), _load(element)))
        elif operation == "const":
            code.append(_constant(constant))
        elif operation in _FORMS:
            values = [value(slot) for slot in arguments]
            code.extend(values[piece] if isinstance(piece, int) else piece for piece in _FORMS[operation])
        else:
            raise NotImplementedError(f"no WebAssembly form for the CasADi operation {operation}")
        code.append(_set(own(result)))
    for slot in sorted(block.live_out):
        code.extend((passed, _get(local_of[slot]), _store(slot)))
    return code, len(local_of)


class _StepArray:
    """Array of a step: an argument with the address, and its first element there."""

    def __init__(self, argument: int, first: int = 0) -> None:
        self.argument, self.first = argument, first

    def address(self) -> bytes:
        return _get(self.argument) + (_integer(8 * self.first) + _ADD_INT if self.first else b"")

    def element(self, index: int) -> bytes:
        """Return the code of the element at the byte offset in the local variable `index`."""
        return _get(self.argument) + _get(index) + _ADD_INT + _load(self.first)

    def storing(self, index: int, value: bytes) -> bytes:
        return _get(self.argument) + _get(index) + _ADD_INT + value + _store(self.first)


def _loop(n: int, index: int, code: bytes) -> bytes:
    """Return the code of a loop over n elements; `index` is the local variable with the byte offset."""
    following = _get(index) + _integer(8) + _ADD_INT + _set(index) + _get(index) + _integer(8 * n) + _LESS_INT
    return _integer(0) + _set(index) + _LOOP + _NOTHING + code + following + _BRANCH_IF + _END


def _weighted_sum(stages: Sequence[_StepArray], index: int, weights: Sequence[float], start: bytes = b"") -> bytes:
    """Return the code of a weighted sum of solver stages, which is added to `start`."""
    total = start
    for stage, weight in zip(stages[: len(weights)], weights, strict=True):
        product = _constant(weight) + stage.element(index) + _MUL
        total = product + total + _ADD if total else product
    return total


def _add_step(module: PrintedFunctions, n_states: int, n_controlled: int, n_inputs: int) -> None:
    """Add the function `step`, see `poppet.engine.printers.llvm_step.print_step`."""
    th, x0, us, p, f0, j, ft, w, k, x1 = (_StepArray(argument) for argument in range(10))
    t, h, g, index = 10, 11, 12, 13  # local variables
    time, f1, right, lu = (_StepArray(w.argument, first) for first in (1, 2, 2 + n_states, 2 + 2 * n_states))
    stages = [_StepArray(k.argument, i * n_states) for i in range(6)]

    def drift(i: int, rates: bytes) -> bytes:
        if STAGE_DRIFT[i] == 0.0:
            return rates
        return _constant(STAGE_DRIFT[i]) + _get(h) + _MUL + ft.element(index) + _MUL + rates + _ADD

    def solve(stage: _StepArray) -> bytes:
        return lu.address() + right.address() + stage.address() + module.call("solve")

    code = [th.address(), _load(0), _set(t), th.address(), _load(1), _set(h), _ONE, _get(h), _DIV, _set(g)]
    code += [w.address(), _constant(1.0 / GAMMA), _get(g), _MUL, _store(0)]
    code += [j.address(), w.address(), lu.address(), module.call("factor")]
    code += [_loop(n_states, index, right.storing(index, drift(0, f0.element(index)))), solve(stages[0])]
    for i in range(1, 6):
        argument = _weighted_sum(stages, index, ARGUMENT[i], x0.element(index))
        n = n_controlled if i < 5 and n_controlled else n_states
        code.append(_loop(n, index, x1.storing(index, argument)))
        code += [time.address(), _constant(STAGE_TIME[i]), _get(h), _MUL, _get(t), _ADD, _store(0)]
        inputs = _StepArray(us.argument, INPUT_TIMES.index(STAGE_TIME[i]) * n_inputs)
        code += [each.address() for each in (time, x1, inputs, p, f1)]
        total = _get(g) + _weighted_sum(stages, index, COUPLING[i]) + _MUL + f1.element(index) + _ADD
        code += [module.call("rates"), _loop(n_states, index, right.storing(index, drift(i, total))), solve(stages[i])]
    code.append(_loop(n_states, index, x1.storing(index, x1.element(index) + stages[5].element(index) + _ADD)))
    module.add("step", 10, code, 3, 1)


def _add_dense(module: PrintedFunctions, n_states: int) -> None:
    """Add the function `dense`, the interpolant of a step."""
    index, stages = 2, [_StepArray(0, i * n_states) for i in range(5)]
    code = [
        _loop(n_states, index, _StepArray(1, k * n_states).storing(index, _weighted_sum(stages, index, DENSE[k])))
        for k in range(2)
    ]
    module.add("dense", 2, code, 0, 1)
