"""Printer: the instructions of a traced function become LLVM IR.

A printed function takes one pointer to doubles per input and per output, `void name(in0, in1, ..., out0, out1, ...)`,
and holds no state. Long lists are cut into blocks that hand their live values on through memory, so that compile time
grows linearly with the number of instructions.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from poppet.engine.printers.instructions import Block, Instruction, InstructionList, blocks

BLOCK_SIZE = 600
"""Instructions per block. LLVM's time per block grows faster than its length; measured best near this size."""

_FLAG = "select {b} {r}, {d} {one}, {d} {zero}"
_FORMS: dict[str, tuple[str, ...]] = {
    "assign": (),
    "add": ("fadd contract {d} {0}, {1}",),
    "sub": ("fsub contract {d} {0}, {1}",),
    "mul": ("fmul contract {d} {0}, {1}",),
    "div": ("fdiv contract {d} {0}, {1}",),
    "neg": ("fneg {d} {0}",),
    "sq": ("fmul contract {d} {0}, {0}",),
    "twice": ("fadd contract {d} {0}, {0}",),
    "inv": ("fdiv contract {d} {one}, {0}",),
    "fmin": ("fcmp olt {d} {0}, {1}", "select {b} {r}, {d} {0}, {d} {1}"),
    "fmax": ("fcmp ogt {d} {0}, {1}", "select {b} {r}, {d} {0}, {d} {1}"),
    "if_else_zero": ("fcmp une {d} {0}, {zero}", "select {b} {r}, {d} {1}, {d} {zero}"),
    "not": ("fcmp oeq {d} {0}, {zero}", _FLAG),
    "and": ("fcmp une {d} {0}, {zero}", "fcmp une {d} {1}, {zero}", "and {b} {s}, {r}", _FLAG),
    "or": ("fcmp une {d} {0}, {zero}", "fcmp une {d} {1}, {zero}", "or {b} {s}, {r}", _FLAG),
    "sign": (
        "fcmp one {d} {0}, {zero}",
        "call {d} @llvm.copysign.{v}({d} {one}, {d} {0})",
        "select {b} {s}, {d} {r}, {d} {zero}",
    ),
}
"""Lines of an operation: {0}, {1} are its arguments, {r} the result of the line before, {s} of that before it; the rest
are the words of a `Kind`."""
for _name in ("inverse", "inverse_root"):
    _FORMS[_name] = (f"call {{d}} @{_name}.v({{d}} {{0}})",)
for _name, _relation in (("lt", "olt"), ("le", "ole"), ("eq", "oeq"), ("ne", "une")):
    _FORMS[_name] = (f"fcmp {_relation} {{d}} {{0}}, {{1}}", _FLAG)
for _name in ("sqrt", "fabs", "floor", "ceil"):
    _FORMS[_name] = (f"call {{d}} @llvm.{_name}.{{v}}({{d}} {{0}})",)
OF_ONE, OF_TWO = ("exp", "log", "sin", "cos", "tan", "tanh", "atan"), ("atan2", "pow")
"""Functions of the mathematics library."""
for _name in OF_ONE:
    _FORMS[_name] = (f"call {{d}} @{_name}{{o}}({{d}} {{0}})",)
for _name, _callee in (("copysign", "llvm.copysign.{v}"), ("atan2", "atan2{o}"), ("pow", "power{o}")):
    _FORMS[_name] = (f"call {{d}} @{_callee}({{d}} {{0}}, {{d}} {{1}})",)


class Kind:
    """The kind of number that a text computes with: a double, or lanes of them side by side.

    Text for lanes reads and writes elements of `width` doubles, aligned to their size. It calls functions of its own
    (`poppet.engine.printers.llvm_lanes`), and divides by multiplication with an inverse, which those that divide by the
    same have in common, as `poppet.engine.printers.lane_values` does in the functions that it rewrites.
    """

    def __init__(self, width: int = 1) -> None:
        self.width = width
        lanes = f"<{width} x {{}}>" if width > 1 else "{}"
        self.number, self.flag = lanes.format("double"), lanes.format("i1")
        # Wide elements spill to aligned places only where the frame has a pointer from the start.
        self.attributes = 'nounwind "frame-pointer"="all"' if width > 1 else "nounwind"
        self.suffix, self.own = (f"v{width}f64", ".v") if width > 1 else ("f64", "")
        self.words = {"d": self.number, "b": self.flag, "v": self.suffix, "o": self.own}
        self.words |= {"one": self._alike("1.0"), "half": self._alike("0.5"), "zero": self._alike("0.0")}

    def _alike(self, constant: str) -> str:
        return constant if self.width == 1 else f"<{', '.join([f'double {constant}'] * self.width)}>"

    def constant(self, value: float) -> str:
        """A constant of which no digit is lost, the same in every lane."""
        return self._alike(literal(value))


SCALAR = Kind()

# The exponent of the flow law is a run-time number, nearly always 1/2; this keeps the usual case at the price of a
# square root without a new compilation when somebody changes it.
PRELUDE = """
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
"""Declarations shared by all printed functions of a module."""


def literal(value: float) -> str:
    """A constant of which no digit is lost."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


class Text:
    """Lines of LLVM IR with fresh names."""

    def __init__(self, kind: Kind = SCALAR) -> None:
        self.kind = kind
        self.lines: list[str] = []
        self.count = self.loops = 0
        self._inverses: dict[str, str] = {}

    def emit(self, text: str) -> str:
        """A line whose result gets a name, which is given back."""
        self.count += 1
        name = f"%v{self.count}"
        self.lines.append(f"  {name} = {text}")
        return name

    def at(self, pointer: str, offset: int | str) -> str:
        """Address of an element."""
        return self.emit(f"getelementptr inbounds {self.kind.number}, ptr {pointer}, i64 {offset}")

    def load(self, pointer: str, offset: int | str) -> str:
        """An element."""
        return self.emit(f"load {self.kind.number}, ptr {self.at(pointer, offset)}")

    def store(self, value: str, pointer: str, offset: int | str) -> None:
        """Write an element."""
        self.lines.append(f"  store {self.kind.number} {value}, ptr {self.at(pointer, offset)}")

    def name(self, name: str, pointer: str, offset: int) -> None:
        """Give the address of an element a name."""
        self.lines.append(f"  {name} = getelementptr inbounds {self.kind.number}, ptr {pointer}, i64 {offset}")

    def times(self, factor: float, value: str) -> str:
        """A constant times a value."""
        return self.emit(f"fmul contract {self.kind.number} {self.kind.constant(factor)}, {value}")

    def multiply_add(self, a: str | float, b: str, c: str) -> str:
        """a b + c."""
        d, factor = self.kind.number, a if isinstance(a, str) else self.kind.constant(a)
        return self.emit(f"call {d} @llvm.fmuladd.{self.kind.suffix}({d} {factor}, {d} {b}, {d} {c})")

    def inverse(self, value: str) -> str:
        """One by a value, in text for lanes that does not branch."""
        if value not in self._inverses:
            self._inverses[value] = self.emit(f"call {self.kind.number} @inverse.v({self.kind.number} {value})")
        return self._inverses[value]

    @contextmanager
    def loop(self, n: int) -> Iterator[str]:
        """A loop of n > 0 rounds; gives its index."""
        self.loops += 1
        k, index = self.loops, f"%n{self.loops}"
        self.lines += [f"  br label %before{k}", f"before{k}:", f"  br label %loop{k}", f"loop{k}:"]
        self.lines.append(f"  {index} = phi i64 [ 0, %before{k} ], [ {index}.next, %loop{k} ]")
        yield index
        self.lines += [
            f"  {index}.next = add nuw nsw i64 {index}, 1",
            f"  {index}.done = icmp eq i64 {index}.next, {n}",
            f"  br i1 {index}.done, label %after{k}, label %loop{k}",
            f"after{k}:",
        ]


def print_function(function: Any, name: str, kind: Kind = SCALAR) -> str:
    """LLVM IR of one traced function, or of a `InstructionList` one."""
    listed = function if isinstance(function, InstructionList) else InstructionList.of(function)
    inputs = [f"%i{k}" for k in range(listed.n_in)]
    outputs = [f"%o{k}" for k in range(listed.n_out)]
    # noalias: inputs and outputs never overlap, so that loads may be moved over stores.
    formal = ", ".join(f"ptr noalias nocapture {a}" for a in [*inputs, *outputs])
    cut = blocks(listed.instructions, BLOCK_SIZE)
    # A function of one block needs no memory to hand values on, and no call.
    if len(cut) <= 1:
        lines = [line for block in cut for line in _printed(block, inputs, outputs, kind)]
        return "\n".join([f"define void @{name}({formal}) {kind.attributes} {{", *lines, "  ret void", "}", ""])
    text: list[str] = []
    for number, block in enumerate(cut):
        head = (
            f"define internal void @{name}.{number}({formal}, ptr noalias nocapture %w) noinline {kind.attributes} {{"
        )
        text += [head, *_printed(block, inputs, outputs, kind), "  ret void", "}", ""]
    actual = ", ".join(f"ptr {a}" for a in [*inputs, *outputs, "%w"])
    text += [
        f"define void @{name}({formal}) {kind.attributes} {{",
        f"  %w = alloca {kind.number}, i64 {listed.size}",
    ]
    text += [f"  call void @{name}.{number}({actual})" for number in range(len(cut))]
    return "\n".join([*text, "  ret void", "}", ""])


def _printed(block: Block, inputs: Sequence[str], outputs: Sequence[str], kind: Kind) -> list[str]:
    """Lines of one block: values of slots are loaded at first use, and those that are handed on stored at the end."""
    text = Text(kind)
    names: dict[int, str] = {}

    def value(slot: int) -> str:
        if slot not in names:
            names[slot] = text.load("%w", slot)
        return names[slot]

    for each in block.instructions:
        vector, element = each.place
        if each.operation == "output":
            text.store(value(each.arguments[0]), outputs[vector], element)
        elif each.operation == "input":
            names[each.result] = text.load(inputs[vector], element)
        elif each.operation == "const":
            names[each.result] = kind.constant(each.constant)
        else:
            names[each.result] = _operation(text, each, [value(slot) for slot in each.arguments])
    for slot in sorted(block.handed_on):
        text.store(names[slot], "%w", slot)
    return text.lines


def _operation(text: Text, instruction: Instruction, arguments: Sequence[str]) -> str:
    if instruction.operation in ("div", "inv") and text.kind.width > 1:
        inverse = text.inverse(arguments[-1])
        if instruction.operation == "inv":
            return inverse
        return text.emit(f"fmul contract {text.kind.number} {arguments[0]}, {inverse}")
    form = _FORMS.get(instruction.operation)
    if form is None:
        raise NotImplementedError(f"no LLVM form for the CasADi operation {instruction.operation}")
    before, result = "", arguments[0]  # `assign` has no lines: its result is its argument
    for line in form:
        before, result = result, text.emit(line.format(*arguments, r=result, s=before, **text.kind.words))
    return result
