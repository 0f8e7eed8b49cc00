"""Printer (code generator) of traced functions as LLVM IR.

A printed function has one pointer to doubles per input and output, `void name(in0, in1, ..., out0, out1, ...)`, and no
state. Long functions are divided into blocks, which pass live values in memory, so the compilation time increases
linearly with the number of instructions.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from poppet.engine.printers.instructions import Block, InstructionList, blocks

BLOCK_SIZE = 600
"""Instructions per block: measured optimum, because the time of LLVM per block increases faster than linearly."""

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
"""Lines of an operation: {0} and {1} are its arguments, {r} and {s} the results of the last and the second last line.

Other fields are the words of a `Kind`."""
for _name in ("inverse", "inverse_root"):
    _FORMS[_name] = (f"call {{d}} @{_name}.v({{d}} {{0}})",)
for _name, _relation in (("lt", "olt"), ("le", "ole"), ("eq", "oeq"), ("ne", "une")):
    _FORMS[_name] = (f"fcmp {_relation} {{d}} {{0}}, {{1}}", _FLAG)
for _name in ("sqrt", "fabs", "floor", "ceil"):
    _FORMS[_name] = (f"call {{d}} @llvm.{_name}.{{v}}({{d}} {{0}})",)
OF_ONE, OF_TWO = ("exp", "log", "sin", "cos", "tan", "tanh", "atan"), ("atan2", "pow")
"""Functions of the mathematics library with one and two arguments."""
for _name in OF_ONE:
    _FORMS[_name] = (f"call {{d}} @{_name}{{o}}({{d}} {{0}})",)
for _name, _callee in (("copysign", "llvm.copysign.{v}"), ("atan2", "atan2{o}"), ("pow", "power{o}")):
    _FORMS[_name] = (f"call {{d}} @{_callee}({{d}} {{0}}, {{d}} {{1}})",)


class Kind:
    """Type of the numbers in printed LLVM IR: a double, or a vector with one double for each lane.

    A vector type changes the printed text in three ways. Array elements have `width` doubles and are aligned to their
    size. The text calls the functions of `poppet.engine.printers.llvm_lanes`. Divisions become products with an
    inverse, which divisions by the same value share.
    """

    def __init__(self, width: int = 1) -> None:
        self.width = width
        lanes = f"<{width} x {{}}>" if width > 1 else "{}"
        self.number, self.flag = lanes.format("double"), lanes.format("i1")
        # Wide elements are spilled to aligned memory only in a frame with a frame pointer.
        self.attributes = 'nounwind "frame-pointer"="all"' if width > 1 else "nounwind"
        self.suffix, self.own = (f"v{width}f64", ".v") if width > 1 else ("f64", "")
        self.words = {"d": self.number, "b": self.flag, "v": self.suffix, "o": self.own}
        self.words |= {"one": self._alike("1.0"), "half": self._alike("0.5"), "zero": self._alike("0.0")}

    def _alike(self, constant: str) -> str:
        return constant if self.width == 1 else f"<{', '.join([f'double {constant}'] * self.width)}>"

    def constant(self, value: float) -> str:
        """Return a constant in LLVM IR with all significant digits.

        The constant is equal in all lanes.
        """
        return self._alike(literal(value))


SCALAR = Kind()

# The exponent of the flow law is a run-time parameter, nearly always 1/2. This function needs only a square root for
# 1/2, and no compilation for another exponent.
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
"""Declarations for all printed functions of a module."""


def literal(value: float) -> str:
    """Return a constant in LLVM IR with all significant digits."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


class Text:
    """Lines of LLVM IR, in which each value has a unique name.

    Most methods add lines and return the name of the result.
    """

    def __init__(self, kind: Kind = SCALAR) -> None:
        self.kind = kind
        self.lines: list[str] = []
        self.count = self.loops = 0
        self._inverses: dict[str, str] = {}

    def emit(self, text: str) -> str:
        """Add a line that computes a value, and return the name of the value."""
        self.count += 1
        name = f"%v{self.count}"
        self.lines.append(f"  {name} = {text}")
        return name

    def at(self, pointer: str, offset: int | str) -> str:
        """Add lines that compute the address of an array element.

        The result is the name of the address.
        """
        return self.emit(f"getelementptr inbounds {self.kind.number}, ptr {pointer}, i64 {offset}")

    def load(self, pointer: str, offset: int | str) -> str:
        """Add a line that reads an array element, and return the name of the value."""
        return self.emit(f"load {self.kind.number}, ptr {self.at(pointer, offset)}")

    def store(self, value: str, pointer: str, offset: int | str) -> None:
        """Add a line that writes a value into an array element."""
        self.lines.append(f"  store {self.kind.number} {value}, ptr {self.at(pointer, offset)}")

    def name(self, name: str, pointer: str, offset: int) -> None:
        """Add the address of an array element under a given name."""
        self.lines.append(f"  {name} = getelementptr inbounds {self.kind.number}, ptr {pointer}, i64 {offset}")

    def times(self, factor: float, value: str) -> str:
        """Add the product of a constant and a value.

        The result is the name of the product.
        """
        return self.emit(f"fmul contract {self.kind.number} {self.kind.constant(factor)}, {value}")

    def multiply_add(self, a: str | float, b: str, c: str) -> str:
        """Add the expression a b + c, and return the name of its result."""
        d, factor = self.kind.number, a if isinstance(a, str) else self.kind.constant(a)
        return self.emit(f"call {d} @llvm.fmuladd.{self.kind.suffix}({d} {factor}, {d} {b}, {d} {c})")

    def inverse(self, value: str) -> str:
        """Add the inverse 1/x of a value, and return its name.

        Each inverse is computed only once. The text must be for lanes and have no branches.
        """
        if value not in self._inverses:
            self._inverses[value] = self.emit(f"call {self.kind.number} @inverse.v({self.kind.number} {value})")
        return self._inverses[value]

    def define(self, name: str, arguments: str) -> str:
        """Return the definition of a function whose body consists of these lines.

        `arguments` contains the names of its arguments, which are pointers.
        """
        formal = ", ".join(f"ptr noalias nocapture {argument}" for argument in arguments.split())
        head = f"define void @{name}({formal}) {self.kind.attributes} {{"
        return "\n".join([head, *self.lines, "  ret void", "}", ""])

    @contextmanager
    def loop(self, n: int) -> Iterator[str]:
        """Add a loop of n iterations around the lines of a `with` block.

        The context manager yields the name of the loop index. n must be above 0.
        """
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
    """Return the LLVM IR of a CasADi function or of a list of instructions.

    `name` is the name of the function, and `kind` the type of its numbers.
    """
    listing = function if isinstance(function, InstructionList) else InstructionList.of(function)
    inputs = [f"%i{k}" for k in range(listing.n_in)]
    outputs = [f"%o{k}" for k in range(listing.n_out)]
    # noalias: inputs and outputs do not overlap, so LLVM can move loads across stores.
    formal = ", ".join(f"ptr noalias nocapture {a}" for a in [*inputs, *outputs])
    parts = blocks(listing.instructions, BLOCK_SIZE)
    # A function of one block needs no memory for live values, and no call.
    if len(parts) <= 1:
        lines = [line for block in parts for line in _print_block(block, inputs, outputs, kind)]
        return "\n".join([f"define void @{name}({formal}) {kind.attributes} {{", *lines, "  ret void", "}", ""])
    text: list[str] = []
    for k, block in enumerate(parts):
        head = f"define internal void @{name}.{k}({formal}, ptr noalias nocapture %w) noinline {kind.attributes} {{"
        text += [head, *_print_block(block, inputs, outputs, kind), "  ret void", "}", ""]
    actual = ", ".join(f"ptr {a}" for a in [*inputs, *outputs, "%w"])
    text += [f"define void @{name}({formal}) {kind.attributes} {{", f"  %w = alloca {kind.number}, i64 {listing.size}"]
    text += [f"  call void @{name}.{k}({actual})" for k in range(len(parts))]
    return "\n".join([*text, "  ret void", "}", ""])


def _print_block(block: Block, inputs: Sequence[str], outputs: Sequence[str], kind: Kind) -> list[str]:
    """Return the lines of LLVM IR for a sequence of instructions.

    Values from earlier blocks are loaded when they are first used. Values that later blocks read are stored at the end.
    """
    text = Text(kind)
    names: dict[int, str] = {}

    def value(slot: int) -> str:
        if slot not in names:
            names[slot] = text.load("%w", slot)
        return names[slot]

    for instruction in block.instructions:
        vector, element = instruction.place
        if instruction.operation == "output":
            text.store(value(instruction.arguments[0]), outputs[vector], element)
        elif instruction.operation == "input":
            names[instruction.result] = text.load(inputs[vector], element)
        elif instruction.operation == "const":
            names[instruction.result] = kind.constant(instruction.constant)
        elif instruction.operation in ("div", "inv") and kind.width > 1:
            arguments = [value(slot) for slot in instruction.arguments]
            result = text.inverse(arguments[-1])
            if instruction.operation == "div":
                result = text.emit(f"fmul contract {kind.number} {arguments[0]}, {result}")
            names[instruction.result] = result
        elif instruction.operation in _FORMS:
            arguments = [value(slot) for slot in instruction.arguments]
            previous, result = "", arguments[0]  # `assign` has no lines: its result is its argument
            for line in _FORMS[instruction.operation]:
                previous, result = result, text.emit(line.format(*arguments, r=result, s=previous, **kind.words))
            names[instruction.result] = result
        else:
            raise NotImplementedError(f"no LLVM form for the CasADi operation {instruction.operation}")
    for slot in sorted(block.live_out):
        text.store(names[slot], "%w", slot)
    return text.lines
