"""Printer: the instruction list of a traced CasADi function becomes LLVM IR text.

A printed function takes one pointer to doubles per input and per output, `void name(in0, in1, ..., out0, out1, ...)`,
and holds no state. Long lists are cut into blocks of bounded size that hand their live values on through memory, so
that compile time grows linearly with the number of instructions.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

BLOCK_SIZE = 600
"""Instructions per block. LLVM's time per block grows faster than its length; measured best near this size."""

_BINARY = {"OP_ADD": "fadd", "OP_SUB": "fsub", "OP_MUL": "fmul", "OP_DIV": "fdiv"}
_COMPARE = {"OP_LT": "olt", "OP_LE": "ole", "OP_EQ": "oeq", "OP_NE": "une"}
_INTRINSIC = {
    "OP_SQRT": "llvm.sqrt.f64",
    "OP_FABS": "llvm.fabs.f64",
    "OP_FLOOR": "llvm.floor.f64",
    "OP_CEIL": "llvm.ceil.f64",
    "OP_COPYSIGN": "llvm.copysign.f64",
}
_LIBM = {
    "OP_EXP": "exp",
    "OP_LOG": "log",
    "OP_SIN": "sin",
    "OP_COS": "cos",
    "OP_TAN": "tan",
    "OP_TANH": "tanh",
    "OP_ATAN": "atan",
    "OP_ATAN2": "atan2",
}
_POWERS = ("OP_POW", "OP_CONSTPOW")

# The exponent of the flow law is a run-time number, nearly always 1/2; this keeps the usual case at the price of a
# square root without a new compilation when somebody changes it.
_PRELUDE = """
declare double @llvm.sqrt.f64(double)
declare double @llvm.fabs.f64(double)
declare double @llvm.floor.f64(double)
declare double @llvm.ceil.f64(double)
declare double @llvm.copysign.f64(double, double)
declare double @exp(double) nounwind willreturn memory(none)
declare double @log(double) nounwind willreturn memory(none)
declare double @sin(double) nounwind willreturn memory(none)
declare double @cos(double) nounwind willreturn memory(none)
declare double @tan(double) nounwind willreturn memory(none)
declare double @tanh(double) nounwind willreturn memory(none)
declare double @atan(double) nounwind willreturn memory(none)
declare double @atan2(double, double) nounwind willreturn memory(none)
declare double @pow(double, double) nounwind willreturn memory(none)

define internal double @power(double %x, double %e) alwaysinline nounwind willreturn memory(none) {
  %half = fcmp oeq double %e, 5.0e-1
  br i1 %half, label %root, label %next
root:
  %s = call double @llvm.sqrt.f64(double %x)
  ret double %s
next:
  %minus = fcmp oeq double %e, -5.0e-1
  br i1 %minus, label %inverse, label %general
inverse:
  %q = call double @llvm.sqrt.f64(double %x)
  %r = fdiv double 1.0, %q
  ret double %r
general:
  %g = call double @pow(double %x, double %e)
  ret double %g
}
"""


@dataclass
class _Instruction:
    name: str
    result: int
    arguments: tuple[int, ...]
    constant: float = 0.0
    place: tuple[int, int] = (0, 0)


def _operation_names() -> dict[int, str]:
    import casadi

    return {getattr(casadi, name): name for name in dir(casadi) if name.startswith("OP_")}


def _instructions(function: Any) -> Iterator[_Instruction]:
    names = _operation_names()
    for k in range(function.n_instructions()):
        name = names[function.instruction_id(k)]
        inputs, outputs = function.instruction_input(k), function.instruction_output(k)
        if name == "OP_CONST":
            yield _Instruction(name, outputs[0], (), constant=function.instruction_constant(k))
        elif name == "OP_INPUT":
            yield _Instruction(name, outputs[0], (), place=(inputs[0], inputs[1]))
        elif name == "OP_OUTPUT":
            yield _Instruction(name, -1, (inputs[0],), place=(outputs[0], outputs[1]))
        else:
            yield _Instruction(name, outputs[0], tuple(inputs))


@dataclass
class _Block:
    """Text of one block: the SSA names of the work vector's values, loads at first use, stores at the end."""

    lines: list[str] = field(default_factory=list)
    names: dict[int, str] = field(default_factory=dict)
    written: set[int] = field(default_factory=set)
    count: int = 0

    def fresh(self) -> str:
        self.count += 1
        return f"%v{self.count}"

    def emit(self, text: str) -> str:
        name = self.fresh()
        self.lines.append(f"  {name} = {text}")
        return name

    def address(self, pointer: str, offset: int) -> str:
        if offset == 0:
            return pointer
        return self.emit(f"getelementptr inbounds double, ptr {pointer}, i64 {offset}")

    def value(self, slot: int) -> str:
        if slot not in self.names:
            self.names[slot] = self.emit(f"load double, ptr {self.address('%w', slot)}")
        return self.names[slot]

    def assign(self, slot: int, name: str) -> None:
        self.names[slot] = name
        self.written.add(slot)


def _literal(value: float) -> str:
    import struct

    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


def _as_flag(block: _Block, compared: str) -> str:
    return block.emit(f"select i1 {compared}, double 1.0, double 0.0")


def _is_true(block: _Block, value: str) -> str:
    return block.emit(f"fcmp une double {value}, 0.0")


def _print_arithmetic(block: _Block, name: str, a: list[str]) -> str:
    if name in _BINARY:
        return block.emit(f"{_BINARY[name]} contract double {a[0]}, {a[1]}")
    if name in _COMPARE:
        return _as_flag(block, block.emit(f"fcmp {_COMPARE[name]} double {a[0]}, {a[1]}"))
    if name in _POWERS:
        return block.emit(f"call double @power(double {a[0]}, double {a[1]})")
    callee = _INTRINSIC.get(name) or _LIBM.get(name)
    if callee:
        return block.emit(f"call double @{callee}({', '.join(f'double {v}' for v in a)})")
    return _print_special(block, name, a)


def _print_special(block: _Block, name: str, a: list[str]) -> str:
    match name:
        case "OP_ASSIGN":
            return a[0]
        case "OP_NEG":
            return block.emit(f"fneg double {a[0]}")
        case "OP_SQ":
            return block.emit(f"fmul contract double {a[0]}, {a[0]}")
        case "OP_TWICE":
            return block.emit(f"fadd contract double {a[0]}, {a[0]}")
        case "OP_INV":
            return block.emit(f"fdiv contract double 1.0, {a[0]}")
        case "OP_FMIN" | "OP_FMAX":
            relation = "olt" if name == "OP_FMIN" else "ogt"
            compared = block.emit(f"fcmp {relation} double {a[0]}, {a[1]}")
            return block.emit(f"select i1 {compared}, double {a[0]}, double {a[1]}")
        case "OP_IF_ELSE_ZERO":
            return block.emit(f"select i1 {_is_true(block, a[0])}, double {a[1]}, double 0.0")
        case "OP_NOT":
            return _as_flag(block, block.emit(f"fcmp oeq double {a[0]}, 0.0"))
        case "OP_AND" | "OP_OR":
            word = "and" if name == "OP_AND" else "or"
            both = block.emit(f"{word} i1 {_is_true(block, a[0])}, {_is_true(block, a[1])}")
            return _as_flag(block, both)
        case "OP_SIGN":
            up = _as_flag(block, block.emit(f"fcmp ogt double {a[0]}, 0.0"))
            down = _as_flag(block, block.emit(f"fcmp olt double {a[0]}, 0.0"))
            return block.emit(f"fsub double {up}, {down}")
    raise NotImplementedError(f"no LLVM form for the CasADi operation {name}")


def _print_instruction(block: _Block, instruction: _Instruction, inputs: list[str], outputs: list[str]) -> None:
    name = instruction.name
    if name == "OP_OUTPUT":
        index, offset = instruction.place
        value = block.value(instruction.arguments[0])
        block.lines.append(f"  store double {value}, ptr {block.address(outputs[index], offset)}")
    elif name == "OP_INPUT":
        index, offset = instruction.place
        block.assign(instruction.result, block.emit(f"load double, ptr {block.address(inputs[index], offset)}"))
    elif name == "OP_CONST":
        block.assign(instruction.result, _literal(instruction.constant))
    else:
        arguments = [block.value(slot) for slot in instruction.arguments]
        block.assign(instruction.result, _print_arithmetic(block, name, arguments))


def _live_after(blocks: list[list[_Instruction]]) -> list[set[int]]:
    """Slots of the work vector that a later block reads before writing them."""
    live: set[int] = set()
    result: list[set[int]] = []
    for block in reversed(blocks):
        result.append(set(live))
        for instruction in reversed(block):
            live.discard(instruction.result)
            live.update(instruction.arguments)
    return result[::-1]


def print_function(function: Any, name: str) -> str:
    """LLVM IR of one traced function."""
    inputs = [f"%i{k}" for k in range(function.n_in())]
    outputs = [f"%o{k}" for k in range(function.n_out())]
    formal = ", ".join(f"ptr noalias nocapture {a}" for a in [*inputs, *outputs])
    every = list(_instructions(function))
    cuts = [every[k : k + BLOCK_SIZE] for k in range(0, len(every), BLOCK_SIZE)]
    if len(cuts) <= 1:
        block = _Block()
        for instruction in every:
            _print_instruction(block, instruction, inputs, outputs)
        return "\n".join([f"define void @{name}({formal}) nounwind {{", *block.lines, "  ret void", "}", ""])
    return _print_blocks(cuts, name, function.sz_w(), inputs, outputs)


def _print_blocks(cuts: list[list[_Instruction]], name: str, size: int, inputs: list[str], outputs: list[str]) -> str:
    formal = ", ".join(f"ptr noalias nocapture {a}" for a in [*inputs, *outputs])
    actual = ", ".join(f"ptr {a}" for a in [*inputs, *outputs, "%w"])
    text: list[str] = []
    for number, (cut, live) in enumerate(zip(cuts, _live_after(cuts), strict=True)):
        block = _Block()
        for instruction in cut:
            _print_instruction(block, instruction, inputs, outputs)
        for slot in sorted(block.written & live):
            block.lines.append(f"  store double {block.names[slot]}, ptr {block.address('%w', slot)}")
        head = f"define internal void @{name}.{number}({formal}, ptr noalias nocapture %w) noinline nounwind {{"
        text += [head, *block.lines, "  ret void", "}", ""]
    text.append(f"define void @{name}({formal}) nounwind {{")
    text.append(f"  %w = alloca double, i64 {size}")
    text += [f"  call void @{name}.{number}({actual})" for number in range(len(cuts))]
    return "\n".join([*text, "  ret void", "}", ""])


def prelude() -> str:
    """Declarations shared by all printed functions of a module."""
    return _PRELUDE
