"""Printer: what lanes need besides the model and a step that are printed on vectors: functions, errors, rows.

A number of lane l lies at l of an element of `width` doubles. Nothing here lets one lane see another.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from functools import cache
from typing import Any

from poppet.engine.job import (
    END,
    ERROR,
    FACTOR,
    GOAL,
    LENGTH,
    LOOK,
    MASKS,
    NEXT,
    REFUSED,
    ROOT,
    ROOT_BEFORE,
    SHRUNK,
    STEP_BEFORE,
    STOP,
    TAKEN,
    TAKES,
    TRIES,
    WANTED,
)
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.llvm import OF_ONE, OF_TWO, PRELUDE, Kind, Text, print_function
from poppet.engine.rosenbrock import GROWTH, SAFETY, SHRINK

_VECTOR_NAMES = {
    ("x86_64", 2): ("_ZGVbN2", "sse2"),
    ("x86_64", 4): ("_ZGVdN4", "avx2"),
    ("x86_64", 8): ("_ZGVeN8", "avx512f"),
    ("aarch64", 2): ("_ZGVnN2", "neon"),
}
"""Begin of the names of vector functions in glibc's libmvec by processor and width, and the feature that they need."""


@cache
def vector_functions(width: int) -> Mapping[str, tuple[str, int]]:
    """Functions that a vector library of this machine has: name to symbol and address."""
    import ctypes
    import platform

    import llvmlite.binding as llvm

    prefix, feature = _VECTOR_NAMES.get((platform.machine(), width), ("", ""))
    if not prefix or sys.platform != "linux" or not llvm.get_host_cpu_features().get(feature, False):
        return {}
    try:
        library = ctypes.CDLL("libmvec.so.1")
    except OSError:  # another C library
        return {}
    found = {}
    for name in (*OF_ONE, *OF_TWO):
        symbol = f"{prefix}{'v' if name in OF_ONE else 'vv'}_{name}"
        if hasattr(library, symbol):
            address = ctypes.cast(getattr(library, symbol), ctypes.c_void_p).value
            assert address is not None
            found[name] = symbol, address
    return found


def lanes_prelude(kind: Kind) -> str:
    """Declarations and functions of lanes that printed functions call; `PRELUDE` is part of it."""
    d, v = kind.number, kind.suffix
    declared = [f"declare {d} @llvm.{name}.{v}({d})" for name in ("sqrt", "fabs", "floor", "ceil")]
    declared.append(f"declare {d} @llvm.copysign.{v}({d}, {d})")
    known = vector_functions(kind.width)
    defined = [_of_library(kind, name, known.get(name, ("", 0))[0]) for name in (*OF_ONE, *OF_TWO)]
    return "\n".join([PRELUDE, *declared, *defined, _inverse(kind), _inverse_root(kind), _power(kind)])


def _of_library(kind: Kind, name: str, symbol: str) -> str:
    """A function of the mathematics library in lanes: of a vector library, or element by element."""
    d, arguments = kind.number, ("%a", "%b") if name in OF_TWO else ("%a",)
    formal = ", ".join(f"{d} {a}" for a in arguments)
    text, result = Text(kind), "undef"
    if symbol:
        declared = f"declare {d} @{symbol}({formal}) {_PURE}\n"
        return declared + _function(kind, f"{name}.v", formal, text, text.emit(f"call {d} @{symbol}({formal})"))
    for lane in range(kind.width):
        each = [text.emit(f"extractelement {d} {a}, i32 {lane}") for a in arguments]
        value = text.emit(f"call double @{name}({', '.join(f'double {e}' for e in each)})")
        result = text.emit(f"insertelement {d} {result}, double {value}, i32 {lane}")
    return _function(kind, f"{name}.v", formal, text, result)


_PURE = "nounwind willreturn memory(none)"


def _function(kind: Kind, name: str, formal: str, text: Text, result: str, how: str = "") -> str:
    """A function of lanes to lanes."""
    head = f"define internal {kind.number} @{name}({formal}) {how}{_PURE} {{"
    return "\n".join([head, *text.lines, f"  ret {kind.number} {result}", "}", ""])


def _inverse(kind: Kind) -> str:
    """`inverse`: with AVX-512 from an estimate of 14 bits by two steps of Newton's method, else as it is.

    Within 1 ulp, beside other work in a third of the time that the processor takes to round the last half of one. What
    is infinite or no number stays so.
    """
    d, one = kind.number, kind.words["one"]
    if not _estimates(kind):
        text = Text(kind)
        return _function(kind, "inverse.v", f"{d} %x", text, text.emit(f"fdiv {d} {one}, %x"), "alwaysinline ")
    text, first = _estimate(kind, "rcp14")
    error = _fused(text, text.emit(f"fneg {d} %x"), first, one)
    # Of the second step's error, the square of this one, no more than its size is needed.
    square = text.emit(f"fmul {d} {error}, {error}")
    r = _fused(text, first, error, first)
    r = _kept(text, error, first, _fused(text, r, square, r))
    declared = f"declare {d} @llvm.x86.avx512.rcp14.pd.512({d}, {d}, i8)\n"
    declared += f"declare {d} @llvm.fma.{kind.suffix}({d}, {d}, {d})\n"
    return declared + _function(kind, "inverse.v", f"{d} %x", text, r, "alwaysinline ")


def _inverse_root(kind: Kind) -> str:
    """`inverse_root`, like `inverse`, which leaves the divider to the roots themselves."""
    d = kind.number
    if not _estimates(kind):
        text = Text(kind)
        root = text.emit(f"call {d} @llvm.sqrt.{kind.suffix}({d} %x)")
        result = text.emit(f"fdiv {d} {kind.words['one']}, {root}")
        return _function(kind, "inverse_root.v", f"{d} %x", text, result, "alwaysinline ")
    text, first = _estimate(kind, "rsqrt14")
    root = text.emit(f"fmul {d} %x, {first}")
    error = _fused(text, text.emit(f"fneg {d} {root}"), first, kind.words["one"])
    # The series of (1 - e)**-0.5 - 1, to its cube.
    series = _fused(text, error, kind.constant(0.3125), kind.constant(0.375))
    series = _fused(text, error, series, kind.words["half"])
    r = _fused(text, text.emit(f"fmul {d} {error}, {first}"), series, first)
    declared = f"declare {d} @llvm.x86.avx512.rsqrt14.pd.512({d}, {d}, i8)\n"
    return declared + _function(kind, "inverse_root.v", f"{d} %x", text, _kept(text, error, first, r), "alwaysinline ")


def _estimates(kind: Kind) -> bool:
    """Whether the processor has estimates of inverses that are good for doubles."""
    import llvmlite.binding as llvm

    return kind.width == 8 and bool(llvm.get_host_cpu_features().get("avx512f", False))


def _estimate(kind: Kind, name: str) -> tuple[Text, str]:
    """A text that begins with an estimate for %x."""
    text, d, zero = Text(kind), kind.number, kind.words["zero"]
    return text, text.emit(f"call {d} @llvm.x86.avx512.{name}.pd.512({d} %x, {d} {zero}, i8 -1)")


def _fused(text: Text, a: str, b: str, c: str) -> str:
    """a b + c, rounded once."""
    d = text.kind.number
    return text.emit(f"call {d} @llvm.fma.{text.kind.suffix}({d} {a}, {d} {b}, {d} {c})")


def _kept(text: Text, error: str, first: str, refined: str) -> str:
    """The estimate where its error is no number: of zero, what is infinite or no number there is nothing to refine."""
    d = text.kind.number
    bad = text.emit(f"fcmp uno {d} {error}, {error}")
    return text.emit(f"select {text.kind.flag} {bad}, {d} {first}, {d} {refined}")


def _power(kind: Kind) -> str:
    """`power` of the scalar text: exponents of a half are roots in every lane, whatever the neighbours have."""
    d, b, v, n = kind.number, kind.flag, kind.suffix, kind.width
    half, minus = kind.constant(0.5), kind.constant(-0.5)
    return f"""
declare i1 @llvm.vector.reduce.and.v{n}i1({b})
define internal {d} @power.v({d} %x, {d} %e) alwaysinline nounwind willreturn memory(none) {{
  %half = fcmp oeq {d} %e, {half}
  %halves = call i1 @llvm.vector.reduce.and.v{n}i1({b} %half)
  br i1 %halves, label %root, label %next
root:
  %s = call {d} @llvm.sqrt.{v}({d} %x)
  ret {d} %s
next:
  %minus = fcmp oeq {d} %e, {minus}
  %minuses = call i1 @llvm.vector.reduce.and.v{n}i1({b} %minus)
  br i1 %minuses, label %inverse, label %general
inverse:
  %u = call {d} @llvm.sqrt.{v}({d} %x)
  %v = call {d} @inverse.v({d} %u)
  ret {d} %v
general:
  %t = call {d} @llvm.sqrt.{v}({d} %x)
  %q = call {d} @inverse.v({d} %t)
  %g = call {d} @pow.v({d} %x, {d} %e)
  %first = select {b} %minus, {d} %q, {d} %g
  %r = select {b} %half, {d} %t, {d} %first
  ret {d} %r
}}
"""


def print_judge(n_controlled: int, kind: Kind) -> str:
    """LLVM IR of `judge`: errors of a step, and factors for the next.

    As `error` and `growth` of `poppet.engine.stepping`, but with roots in place of powers. Given are relative and
    absolute tolerances, what states must exceed, the state, the new one, the estimate, time and length; read and
    written are rows of `control`.
    """
    text, d, b = Text(kind), kind.number, kind.flag
    infinite, one, zero = kind.constant(float("inf")), kind.words["one"], kind.words["zero"]

    def call(name: str, value: str) -> str:
        return text.emit(f"call {d} @llvm.{name}.{kind.suffix}({d} {value})")

    def choose(relation: str, x: str, y: str, then: str = "", other: str = "") -> str:
        flag = text.emit(f"fcmp {relation} {d} {x}, {y}")
        return text.emit(f"select {b} {flag}, {d} {then or x}, {d} {other or y}")

    def divided(x: str, y: str) -> str:
        return text.emit(f"fmul {d} {x}, {text.emit(f'call {d} @inverse.v({d} {y})')}")

    text.lines += [f"  %worst = alloca {d}", f"  store {d} {zero}, ptr %worst"]
    text.name("%absolute", "%tolerances", n_controlled)
    with text.loop(n_controlled) as index:
        new, low, estimate = (text.load(f"%{name}", index) for name in ("new", "low", "estimate"))
        larger = choose("ogt", call("fabs", text.load("%x", index)), size := call("fabs", new))
        allowed = text.multiply_add(text.load("%tolerances", index), larger, text.load("%absolute", index))
        error = choose("ogt", new, low, divided(call("fabs", estimate), allowed), infinite)
        error = choose("olt", size, infinite, error, infinite)
        # What is no number is the worst.
        error = choose("olt", error, infinite)
        text.store(choose("ogt", error, text.load("%worst", 0)), "%worst", 0)
    error = text.load("%worst", 0)
    text.store(error, "%control", ERROR)
    root = call("sqrt", call("sqrt", choose("ogt", error, kind.constant(1e-10))))
    plain = divided(kind.constant(SAFETY), root)
    text.store(choose("ogt", choose("olt", plain, kind.constant(0.8)), kind.constant(SHRINK)), "%control", SHRUNK)
    # Without a step before it the quotient is infinite, and the plain factor the lesser.
    ratio = divided(text.load("%th", 1), text.load("%control", STEP_BEFORE))
    ratio = text.emit(f"fmul {d} {text.times(SAFETY, ratio)}, {text.load('%control', ROOT_BEFORE)}")
    predicted = divided(ratio, text.emit(f"fmul {d} {root}, {root}"))
    factor = choose("olt", predicted, plain)
    factor = choose("ogt", choose("olt", factor, kind.constant(GROWTH)), kind.constant(SHRINK))
    text.store(factor, "%control", FACTOR)
    text.store(choose("ogt", root, kind.constant(0.01**0.25)), "%control", ROOT)
    text.store(taken := choose("ole", error, one, one, zero), "%control", TAKEN)
    due = text.emit(f"fcmp olt {d} {text.load('%control', NEXT)}, {text.load('%control', END)}")
    due = text.emit(f"and {b} {due}, {text.emit(f'fcmp une {d} {taken}, {zero}')}")
    _store_mask(text, due, 0)
    names = ("tolerances", "low", "x", "new", "estimate", "th", "control")
    head = f"define void @judge({', '.join(f'ptr noalias nocapture %{name}' for name in names)}) {kind.attributes} {{"
    return "\n".join([head, *text.lines, "  ret void", "}", ""])


def _store_mask(text: Text, flags: str, number: int) -> None:
    """Write a bit for each lane into a whole number of the control."""
    n = text.kind.width
    bits = text.emit(f"bitcast {text.kind.flag} {flags} to i{n}")
    wide = text.emit(f"zext i{n} {bits} to i64")
    at = text.emit(f"getelementptr inbounds i64, ptr %control, i64 {MASKS * n + number}")
    text.lines.append(f"  store i64 {wide}, ptr {at}")


def print_choose(kind: Kind) -> str:
    """LLVM IR of `choose`: lengths of the steps, as `length` of `poppet.engine.stepping`, and where they end."""
    text, d, b = Text(kind), kind.number, kind.flag

    def choose(relation: str, x: str, y: str, then: str, other: str) -> str:
        flag = text.emit(f"fcmp {relation} {d} {x}, {y}")
        return text.emit(f"select {b} {flag}, {d} {then}, {d} {other}")

    t, goal, h = text.load("%th", 0), text.load("%control", GOAL), text.load("%control", LENGTH)
    first = text.emit(f"insertelement {d} undef, double {text.emit('load double, ptr %limits')}, i32 0")
    longest = text.emit(f"shufflevector {d} {first}, {d} undef, <{kind.width} x i32> zeroinitializer")
    text.store(wanted := choose("olt", h, longest, h, longest), "%control", WANTED)
    rest = text.emit(f"fsub {d} {goal}, {t}")
    half = text.emit(f"fmul {d} {kind.words['half']}, {rest}")
    h = choose("olt", wanted, half, wanted, choose("olt", wanted, rest, half, rest))
    text.store(h, "%th", 1)
    least = text.emit(f"fmul {d} {rest}, {kind.constant(1.0 - 1e-12)}")
    text.store(choose("oge", h, least, goal, text.emit(f"fadd {d} {t}, {h}")), "%control", END)
    names = ("control", "th", "limits")
    head = f"define void @choose({', '.join(f'ptr noalias nocapture %{name}' for name in names)}) {kind.attributes} {{"
    return "\n".join([head, *text.lines, "  ret void", "}", ""])


def print_settle(kind: Kind) -> str:
    """LLVM IR of `settle`: times and the lengths of the next steps, taken or not, and who is to be looked at."""
    text, d, b = Text(kind), kind.number, kind.flag
    one, zero = kind.words["one"], kind.words["zero"]

    def compare(relation: str, x: str, y: str) -> str:
        return text.emit(f"fcmp {relation} {d} {x}, {y}")

    def choose(flag: str, then: str, other: str) -> str:
        return text.emit(f"select {b} {flag}, {d} {then}, {d} {other}")

    def times(x: str, y: str) -> str:
        return text.emit(f"fmul {d} {x}, {y}")

    rows = {k: text.load("%control", k) for k in (TAKEN, WANTED, FACTOR, SHRUNK, ROOT, END, STOP, REFUSED, LOOK)}
    t, h, wanted, factor = text.load("%th", 0), text.load("%th", 1), rows[WANTED], rows[FACTOR]
    taken = compare("une", rows[TAKEN], zero)
    careful = choose(compare("olt", factor, one), factor, one)
    usual = times(h, choose(compare("une", rows[REFUSED], zero), careful, factor))
    grown = times(h, factor)
    # A step that was cut at the end of the segment says nothing against the longer one that was wanted.
    cut = choose(compare("ogt", wanted, grown), wanted, grown)
    length = choose(taken, choose(compare("olt", h, wanted), cut, usual), times(h, rows[SHRUNK]))
    text.store(length, "%control", LENGTH)
    text.store(choose(taken, zero, one), "%control", REFUSED)
    for k, value in ((STEP_BEFORE, h), (ROOT_BEFORE, rows[ROOT])):
        text.store(choose(taken, value, text.load("%control", k)), "%control", k)
    text.store(now := choose(taken, rows[END], t), "%th", 0)
    tries = text.emit(f"fadd {d} {text.load('%control', TRIES)}, {one}")
    text.store(tries, "%control", TRIES)
    text.store(text.emit(f"fadd {d} {text.load('%control', TAKES)}, {rows[TAKEN]}"), "%control", TAKES)
    has_ended = compare("uge", now, rows[STOP])
    stalls = compare("ule", text.emit(f"fadd {d} {now}, {length}"), now)
    stalls = text.emit(f"or {b} {stalls}, {compare('olt', length, kind.constant(1e-300))}")
    looks = compare("oge", tries, rows[LOOK])
    _store_mask(text, text.emit(f"or {b} {has_ended}, {text.emit(f'or {b} {stalls}, {looks}')}"), 1)
    names = ("control", "th")
    head = f"define void @settle({', '.join(f'ptr noalias nocapture %{name}' for name in names)}) {kind.attributes} {{"
    return "\n".join([head, *text.lines, "  ret void", "}", ""])


def print_commit(n_states: int, kind: Kind) -> str:
    """LLVM IR of `commit`: in lanes that are taken the new state becomes the state, and the books are kept."""
    text, d, b = Text(kind), kind.number, kind.flag
    text.lines.append(f"  %is = fcmp une {d} {text.load('%control', TAKEN)}, {kind.words['zero']}")
    for k, name in enumerate(("%least", "%greatest", "%through")):
        text.name(name, "%books", k * n_states)

    def write(name: str, index: str, flag: str, then: str, other: str) -> None:
        text.store(text.emit(f"select {b} {flag}, {d} {then}, {d} {other}"), name, index)

    with text.loop(n_states) as index:
        x = text.load("%x", index)
        new = text.emit(f"select {b} %is, {d} {text.load('%new', index)}, {d} {x}")
        text.store(new, "%x", index)
        moved = text.emit(f"call {d} @llvm.fabs.{kind.suffix}({d} {text.emit(f'fsub {d} {new}, {x}')})")
        text.store(text.emit(f"fadd {d} {text.load('%through', index)}, {moved}"), "%through", index)
        for name, relation in (("%least", "olt"), ("%greatest", "ogt")):
            before = text.load(name, index)
            write(name, index, text.emit(f"fcmp {relation} {d} {new}, {before}"), new, before)
    head = "define void @commit(ptr noalias nocapture %control, ptr noalias nocapture %x, ptr noalias nocapture %new, "
    return "\n".join([f"{head}ptr noalias nocapture %books) {kind.attributes} {{", *text.lines, "  ret void", "}", ""])


def print_rows(outputs: Any, n_states: int, kind: Kind) -> str:
    """LLVM IR of `outputs` in lanes, and of `rows` and `rows_held`, which write rows of *one* lane, `width` at a time.

    Given are the first time of the grid, which ends in infinities, and the first element of the table; the next column,
    also written, the number of rows, and a time that rows lie before; begin and length of the step, state, new state
    and interpolant, inputs, numbers, each at its lane. `rows` has inputs for each row (and writes `width` rows at
    most), `rows_held` those of its lane.
    """
    text = print_function(outputs, "row", kind).replace("define void", "define internal void", 1)
    return text + _print_rows(outputs, n_states, kind, "rows_held") + _print_rows(outputs, n_states, kind, "rows")


def _print_rows(outputs: Any, n_states: int, kind: Kind, name: str) -> str:
    text, d, n = Text(kind), kind.number, kind.width
    used: list[set[int]] = [set() for _ in range(4)]
    for each in instructions(outputs):
        if each.operation == "input":
            used[each.place[0]].add(each.place[1])

    def alike(pointer: str, element: int) -> str:
        """A number of the lane, in all lanes."""
        at = text.emit(f"getelementptr inbounds double, ptr {pointer}, i64 {element * n}")
        value = text.emit(f"load double, ptr {at}")
        first = text.emit(f"insertelement {d} undef, double {value}, i32 0")
        return text.emit(f"shufflevector {d} {first}, {d} undef, <{n} x i32> zeroinitializer")

    n_y = outputs.nnz_out(0)
    for local, size in (("%xs", n_states), ("%us", outputs.nnz_in(2)), ("%ps", outputs.nnz_in(3)), ("%y", n_y)):
        text.lines.append(f"  {local} = alloca {d}, i64 {max(1, size)}")
    text.lines += [f"  %time = alloca {d}", "  %n = load i64, ptr %n_rows", "  %from = load i64, ptr %column"]
    until, begin, length = alike("%before", 0), alike("%th", 0), alike("%th", 1)
    for k in sorted(used[3]):
        text.store(alike("%p", k), "%ps", k)
    if name == "rows_held":
        for k in sorted(used[2]):
            text.store(alike("%u", k), "%us", k)
    parts = {
        k: [alike(pointer, at) for pointer, at in (("%x0", k), ("%x1", k), ("%d", k), ("%d", n_states + k))]
        for k in sorted(used[1])
    }
    text.lines += ["  br label %next", "next:", "  %c = phi i64 [ %from, %0 ], [ %further, %next ]"]
    text.lines.append("  %first = getelementptr inbounds double, ptr %grid, i64 %c")
    time = text.emit(f"load {d}, ptr %first, align 8")
    mask = text.emit(f"fcmp olt {d} {time}, {until}")
    text.store(time, "%time", 0)
    theta = text.emit(f"fdiv {d} {text.emit(f'fsub {d} {time}, {begin}')}, {length}")
    flag = text.emit(f"fcmp ogt {d} {theta}, {kind.words['zero']}")
    theta = text.emit(f"select {kind.flag} {flag}, {d} {theta}, {d} {kind.words['zero']}")
    rest = text.emit(f"fsub {d} {kind.words['one']}, {theta}")
    for k, (x0, x1, d0, d1) in parts.items():
        inner = text.multiply_add(rest, text.multiply_add(theta, d1, d0), x1)
        text.store(text.multiply_add(theta, inner, text.emit(f"fmul {d} {rest}, {x0}")), "%xs", k)
    if name == "rows":
        for k in sorted(used[2]):
            text.store(text.load("%u", k), "%us", k)
    text.lines.append("  call void @row(ptr %time, ptr %xs, ptr %us, ptr %ps, ptr %y)")
    for k in range(n_y):
        place = text.emit(f"add i64 {text.emit(f'mul i64 %n, {k}')}, %c")
        at = text.emit(f"getelementptr inbounds double, ptr %table, i64 {place}")
        what = f"{d} {text.load('%y', k)}, ptr {at}, i32 8, {kind.flag} {mask}"
        text.lines.append(f"  call void @llvm.masked.store.{kind.suffix}.p0({what})")
    bits = text.emit(f"bitcast {kind.flag} {mask} to i{n}")
    wide = text.emit(f"zext i{n} {bits} to i64")
    written = text.emit(f"call i64 @llvm.ctpop.i64(i64 {wide})")
    text.lines.append(f"  %further = add i64 %c, {written}")
    more = text.emit(f"icmp eq i64 {written}, {n if name == 'rows_held' else n + 1}")
    text.lines += [f"  br i1 {more}, label %next, label %done", "done:", "  store i64 %further, ptr %column"]
    names = ("grid", "table", "column", "n_rows", "before", "th", "x0", "x1", "d", "u", "p")
    head = f"define void @{name}({', '.join(f'ptr noalias nocapture %{each}' for each in names)}) {kind.attributes} {{"
    declared = [f"declare void @llvm.masked.store.{kind.suffix}.p0({d}, ptr, i32, {kind.flag})"]
    declared.append("declare i64 @llvm.ctpop.i64(i64)")
    lines = [head, *text.lines, "  ret void", "}", ""]
    return "\n".join(lines if name == "rows" else [*declared, *lines])
