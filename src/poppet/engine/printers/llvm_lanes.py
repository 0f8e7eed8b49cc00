"""Printer (code generator) of library functions, error control and output rows for lanes.

An element consists of `width` doubles, one per lane. Lanes do not affect each other.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from functools import cache
from typing import Any

from poppet.engine import job
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.llvm import OF_ONE, OF_TWO, PRELUDE, Kind, Text, print_function
from poppet.engine.rosenbrock import GROWTH, SAFETY, SHRINK

_VECTOR_NAMES = {
    ("x86_64", 2): ("_ZGVbN2", "sse2"),
    ("x86_64", 4): ("_ZGVdN4", "avx2"),
    ("x86_64", 8): ("_ZGVeN8", "avx512f"),
    ("aarch64", 2): ("_ZGVnN2", "neon"),
}
"""Prefix of vector functions in glibc's libmvec, and required processor feature, by processor and width."""


@cache
def vector_functions(width: int) -> Mapping[str, tuple[str, int]]:
    """Return the functions of the vector math library, by name.

    Each value contains the symbol and the address of the function. The mapping is empty if this machine has no such
    library.
    """
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
    functions = {}
    for name in (*OF_ONE, *OF_TWO):
        symbol = f"{prefix}{'v' if name in OF_ONE else 'vv'}_{name}"
        if hasattr(library, symbol):
            address = ctypes.cast(getattr(library, symbol), ctypes.c_void_p).value
            assert address is not None
            functions[name] = symbol, address
    return functions


def lanes_prelude(kind: Kind) -> str:
    """Return the LLVM IR of all declarations and helper functions for lanes."""
    d, v = kind.number, kind.suffix
    declared = [f"declare {d} @llvm.{name}.{v}({d})" for name in ("sqrt", "fabs", "floor", "ceil")]
    declared.append(f"declare {d} @llvm.copysign.{v}({d}, {d})")
    defined, available = [], vector_functions(kind.width)
    for name in (*OF_ONE, *OF_TWO):
        arguments, text, result = ("%a", "%b") if name in OF_TWO else ("%a",), Text(kind), "undef"
        formal = ", ".join(f"{d} {a}" for a in arguments)
        if name in available:
            symbol = available[name][0]
            defined.append(f"declare {d} @{symbol}({formal}) {_PURE}")
            result = text.emit(f"call {d} @{symbol}({formal})")
        # Without a vector library, the scalar function is called for each lane.
        for lane in range(kind.width) if name not in available else ():
            elements = [text.emit(f"extractelement {d} {a}, i32 {lane}") for a in arguments]
            value = text.emit(f"call double @{name}({', '.join(f'double {element}' for element in elements)})")
            result = text.emit(f"insertelement {d} {result}, double {value}, i32 {lane}")
        defined.append(_define_function(kind, f"{name}.v", formal, text, result))
    return "\n".join(
        [PRELUDE, *declared, *defined, _define_inverse(kind), _define_inverse_root(kind), _define_power(kind)]
    )


_PURE = "nounwind willreturn memory(none)"


def _define_function(kind: Kind, name: str, formal: str, text: Text, result: str, attributes: str = "") -> str:
    """Return the LLVM IR of a complete function for simultaneous runs (lanes).

    `formal` is the text of the declared arguments. `text` contains the lines, and `result` is the name of the result.
    """
    head = f"define internal {kind.number} @{name}({formal}) {attributes}{_PURE} {{"
    return "\n".join([head, *text.lines, f"  ret {kind.number} {result}", "}", ""])


def _define_inverse(kind: Kind) -> str:
    """Return LLVM IR of the function `inverse`.

    With AVX-512, the function takes two Newton steps from an estimate of 14 bits. Otherwise it divides.

    The error is at most 1 ulp. A division has an error of half an ulp, but takes three times longer. For infinite
    values and NaN, the result is the same as in a division.
    """
    d, unity = kind.number, kind.words["one"]
    if not _has_estimates(kind):
        text = Text(kind)
        return _define_function(kind, "inverse.v", f"{d} %x", text, text.emit(f"fdiv {d} {unity}, %x"), "alwaysinline ")
    text, first = _begin_with_estimate(kind, "rcp14")
    error = _add_fused(text, text.emit(f"fneg {d} %x"), first, unity)
    # The error of the second step is the square of this error.
    square = text.emit(f"fmul {d} {error}, {error}")
    r = _add_fused(text, first, error, first)
    r = _keep_estimate(text, error, first, _add_fused(text, r, square, r))
    declared = f"declare {d} @llvm.x86.avx512.rcp14.pd.512({d}, {d}, i8)\n"
    declared += f"declare {d} @llvm.fma.{kind.suffix}({d}, {d}, {d})\n"
    return declared + _define_function(kind, "inverse.v", f"{d} %x", text, r, "alwaysinline ")


def _define_inverse_root(kind: Kind) -> str:
    """Return LLVM IR of the function `inverse_root`, the inverse of a square root.

    Like `inverse`, it does not use the divider of the processor, which computes other roots.
    """
    d = kind.number
    if not _has_estimates(kind):
        text = Text(kind)
        root = text.emit(f"call {d} @llvm.sqrt.{kind.suffix}({d} %x)")
        result = text.emit(f"fdiv {d} {kind.words['one']}, {root}")
        return _define_function(kind, "inverse_root.v", f"{d} %x", text, result, "alwaysinline ")
    text, first = _begin_with_estimate(kind, "rsqrt14")
    root = text.emit(f"fmul {d} %x, {first}")
    error = _add_fused(text, text.emit(f"fneg {d} {root}"), first, kind.words["one"])
    # Series of (1 - e)**-0.5 - 1 up to the cube.
    series = _add_fused(text, error, kind.constant(0.3125), kind.constant(0.375))
    series = _add_fused(text, error, series, kind.words["half"])
    r = _add_fused(text, text.emit(f"fmul {d} {error}, {first}"), series, first)
    declared = f"declare {d} @llvm.x86.avx512.rsqrt14.pd.512({d}, {d}, i8)\n"
    result = _keep_estimate(text, error, first, r)
    return declared + _define_function(kind, "inverse_root.v", f"{d} %x", text, result, "alwaysinline ")


def _has_estimates(kind: Kind) -> bool:
    """Return True if the processor can estimate inverses with one instruction."""
    import llvmlite.binding as llvm

    return kind.width == 8 and bool(llvm.get_host_cpu_features().get("avx512f", False))


def _begin_with_estimate(kind: Kind, name: str) -> tuple[Text, str]:
    """Return lines of LLVM IR that compute an estimate of a function of %x, and its name.

    `name` selects the instruction of the processor, for example for the inverse. More lines can be added.
    """
    text, d, zero = Text(kind), kind.number, kind.words["zero"]
    return text, text.emit(f"call {d} @llvm.x86.avx512.{name}.pd.512({d} %x, {d} {zero}, i8 -1)")


def _add_fused(text: Text, a: str, b: str, c: str) -> str:
    """Add the expression a b + c with a single rounding, and return its name."""
    d = text.kind.number
    return text.emit(f"call {d} @llvm.fma.{text.kind.suffix}({d} {a}, {d} {b}, {d} {c})")


def _keep_estimate(text: Text, error: str, first: str, refined: str) -> str:
    """Add the refined value, or the first estimate if the error is NaN.

    The result is the name of the value. `first` is the estimate, and `error` its error. The error is NaN for zero,
    infinite values and NaN.
    """
    d = text.kind.number
    is_nan = text.emit(f"fcmp uno {d} {error}, {error}")
    return text.emit(f"select {text.kind.flag} {is_nan}, {d} {first}, {d} {refined}")


def _define_power(kind: Kind) -> str:
    """Return LLVM IR of the function `power`.

    An exponent of 1/2 is computed as a root, in each lane independently of the other lanes.
    """
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
    """Return LLVM IR of `judge`, which computes the error of a step and factors on the step length.

    The functions `error` and `growth` in `poppet.engine.stepping` use the same formulas, but powers instead of square
    roots. The arguments are tolerances, lower limits of the states, state, new state, error estimate, time with step
    length, and `control`. The results are rows of `control`.
    """
    text, d, b = Text(kind), kind.number, kind.flag
    infinite, unity, zero = kind.constant(float("inf")), kind.words["one"], kind.words["zero"]

    def call(name: str, value: str) -> str:
        return text.emit(f"call {d} @llvm.{name}.{kind.suffix}({d} {value})")

    def choose(relation: str, x: str, y: str, if_true: str = "", if_false: str = "") -> str:
        flag = text.emit(f"fcmp {relation} {d} {x}, {y}")
        return text.emit(f"select {b} {flag}, {d} {if_true or x}, {d} {if_false or y}")

    def divide(x: str, y: str) -> str:
        return text.emit(f"fmul {d} {x}, {text.emit(f'call {d} @inverse.v({d} {y})')}")

    text.lines += [f"  %worst = alloca {d}", f"  store {d} {zero}, ptr %worst"]
    text.name("%absolute", "%tolerances", n_controlled)
    with text.loop(n_controlled) as index:
        new, low, estimate = (text.load(f"%{name}", index) for name in ("new", "low", "estimate"))
        larger = choose("ogt", call("fabs", text.load("%x", index)), size := call("fabs", new))
        allowed = text.multiply_add(text.load("%tolerances", index), larger, text.load("%absolute", index))
        error = choose("ogt", new, low, divide(call("fabs", estimate), allowed), infinite)
        error = choose("olt", size, infinite, error, infinite)
        # NaN becomes infinite.
        error = choose("olt", error, infinite)
        text.store(choose("ogt", error, text.load("%worst", 0)), "%worst", 0)
    error = text.load("%worst", 0)
    text.store(error, "%control", job.ERROR)
    root = call("sqrt", call("sqrt", choose("ogt", error, kind.constant(1e-10))))
    basic_factor = divide(kind.constant(SAFETY), root)
    shrunk = choose("ogt", choose("olt", basic_factor, kind.constant(0.8)), kind.constant(SHRINK))
    text.store(shrunk, "%control", job.SHRUNK)
    # Without a previous step, the quotient is infinite and the basic factor is the minimum.
    ratio = divide(text.load("%th", 1), text.load("%control", job.STEP_BEFORE))
    ratio = text.emit(f"fmul {d} {text.times(SAFETY, ratio)}, {text.load('%control', job.ROOT_BEFORE)}")
    predicted = divide(ratio, text.emit(f"fmul {d} {root}, {root}"))
    factor = choose("olt", predicted, basic_factor)
    factor = choose("ogt", choose("olt", factor, kind.constant(GROWTH)), kind.constant(SHRINK))
    text.store(factor, "%control", job.FACTOR)
    text.store(choose("ogt", root, kind.constant(0.01**0.25)), "%control", job.ROOT)
    text.store(accepted := choose("ole", error, unity, unity, zero), "%control", job.TAKEN)
    due = text.emit(f"fcmp olt {d} {text.load('%control', job.NEXT)}, {text.load('%control', job.END)}")
    due = text.emit(f"and {b} {due}, {text.emit(f'fcmp une {d} {accepted}, {zero}')}")
    _store_mask(text, due, 0)
    return text.define("judge", "%tolerances %low %x %new %estimate %th %control")


def _store_mask(text: Text, flags: str, number: int) -> None:
    """Add lines that store one bit for each lane in an element of `control`.

    `flags` contains the bits, and `number` selects the element.
    """
    n = text.kind.width
    bits = text.emit(f"bitcast {text.kind.flag} {flags} to i{n}")
    wide = text.emit(f"zext i{n} {bits} to i64")
    pointer = text.emit(f"getelementptr inbounds i64, ptr %control, i64 {job.MASKS * n + number}")
    text.lines.append(f"  store i64 {wide}, ptr {pointer}")


def print_choose(kind: Kind) -> str:
    """Return the LLVM IR of the function `choose` for the length of the next step.

    The function `length` in `poppet.engine.stepping` uses the same formula.
    """
    text, d, b = Text(kind), kind.number, kind.flag

    def choose(relation: str, x: str, y: str, if_true: str, if_false: str) -> str:
        flag = text.emit(f"fcmp {relation} {d} {x}, {y}")
        return text.emit(f"select {b} {flag}, {d} {if_true}, {d} {if_false}")

    t, goal, h = text.load("%th", 0), text.load("%control", job.GOAL), text.load("%control", job.LENGTH)
    first = text.emit(f"insertelement {d} undef, double {text.emit('load double, ptr %limits')}, i32 0")
    longest = text.emit(f"shufflevector {d} {first}, {d} undef, <{kind.width} x i32> zeroinitializer")
    text.store(desired := choose("olt", h, longest, h, longest), "%control", job.WANTED)
    remaining = text.emit(f"fsub {d} {goal}, {t}")
    half = text.emit(f"fmul {d} {kind.words['half']}, {remaining}")
    h = choose("olt", desired, half, desired, choose("olt", desired, remaining, half, remaining))
    text.store(h, "%th", 1)
    threshold = text.emit(f"fmul {d} {remaining}, {kind.constant(1.0 - 1e-12)}")
    text.store(choose("oge", h, threshold, goal, text.emit(f"fadd {d} {t}, {h}")), "%control", job.END)
    return text.define("choose", "%control %th %limits")


def print_settle(kind: Kind) -> str:
    """Return LLVM IR of the function `settle`, which prepares the next steps of all lanes.

    It computes times and step lengths. It also marks the lanes that the integrator must handle separately, for example
    at the end of a segment.
    """
    text, d, b = Text(kind), kind.number, kind.flag
    unity, zero = kind.words["one"], kind.words["zero"]

    def compare(relation: str, x: str, y: str) -> str:
        return text.emit(f"fcmp {relation} {d} {x}, {y}")

    def choose(flag: str, if_true: str, if_false: str) -> str:
        return text.emit(f"select {b} {flag}, {d} {if_true}, {d} {if_false}")

    def times(x: str, y: str) -> str:
        return text.emit(f"fmul {d} {x}, {y}")

    rows = {
        k: text.load("%control", k)
        for k in (job.TAKEN, job.WANTED, job.FACTOR, job.SHRUNK, job.ROOT, job.END, job.STOP, job.REFUSED, job.LOOK)
    }
    t, h, desired, factor = text.load("%th", 0), text.load("%th", 1), rows[job.WANTED], rows[job.FACTOR]
    accepted = compare("une", rows[job.TAKEN], zero)
    factor_after_rejection = choose(compare("olt", factor, unity), factor, unity)
    next_length = times(h, choose(compare("une", rows[job.REFUSED], zero), factor_after_rejection, factor))
    grown = times(h, factor)
    # A step that the end of the segment shortened does not reduce the desired length.
    after_short_step = choose(compare("ogt", desired, grown), desired, grown)
    length = choose(
        accepted, choose(compare("olt", h, desired), after_short_step, next_length), times(h, rows[job.SHRUNK])
    )
    text.store(length, "%control", job.LENGTH)
    text.store(choose(accepted, zero, unity), "%control", job.REFUSED)
    for k, value in ((job.STEP_BEFORE, h), (job.ROOT_BEFORE, rows[job.ROOT])):
        text.store(choose(accepted, value, text.load("%control", k)), "%control", k)
    text.store(now := choose(accepted, rows[job.END], t), "%th", 0)
    tries = text.emit(f"fadd {d} {text.load('%control', job.TRIES)}, {unity}")
    text.store(tries, "%control", job.TRIES)
    text.store(text.emit(f"fadd {d} {text.load('%control', job.TAKES)}, {rows[job.TAKEN]}"), "%control", job.TAKES)
    has_ended = compare("uge", now, rows[job.STOP])
    stalls = compare("ule", text.emit(f"fadd {d} {now}, {length}"), now)
    stalls = text.emit(f"or {b} {stalls}, {compare('olt', length, kind.constant(1e-300))}")
    needs_check = compare("oge", tries, rows[job.LOOK])
    _store_mask(text, text.emit(f"or {b} {has_ended}, {text.emit(f'or {b} {stalls}, {needs_check}')}"), 1)
    return text.define("settle", "%control %th")


def print_commit(n_states: int, kind: Kind) -> str:
    """Return LLVM IR of the function `commit`, which completes accepted steps.

    Lanes with an accepted step get the new state. Extremes and sums of |change| of the states are updated.
    """
    text, d, b = Text(kind), kind.number, kind.flag
    text.lines.append(f"  %is = fcmp une {d} {text.load('%control', job.TAKEN)}, {kind.words['zero']}")
    for k, name in enumerate(("%least", "%greatest", "%through")):
        text.name(name, "%books", k * n_states)

    with text.loop(n_states) as index:
        x = text.load("%x", index)
        new = text.emit(f"select {b} %is, {d} {text.load('%new', index)}, {d} {x}")
        text.store(new, "%x", index)
        change = text.emit(f"call {d} @llvm.fabs.{kind.suffix}({d} {text.emit(f'fsub {d} {new}, {x}')})")
        text.store(text.emit(f"fadd {d} {text.load('%through', index)}, {change}"), "%through", index)
        for name, relation in (("%least", "olt"), ("%greatest", "ogt")):
            extreme = text.load(name, index)
            flag = text.emit(f"fcmp {relation} {d} {new}, {extreme}")
            text.store(text.emit(f"select {b} {flag}, {d} {new}, {d} {extreme}"), name, index)
    return text.define("commit", "%control %x %new %books")


def print_rows(outputs: Any, n_states: int, kind: Kind) -> str:
    """Return LLVM IR of `rows` and `rows_held`, which write output rows of one lane.

    They write `width` rows simultaneously. `rows` has inputs for each row and writes at most `width` rows. `rows_held`
    has constant inputs.

    The arguments are, in this order: the output times, which end with infinities; the table of outputs; the next
    column, which is also written; the number of rows; the time limit of the rows; start and length of the step; state,
    new state and interpolant; inputs and p of the lane.
    """
    text = print_function(outputs, "row", kind).replace("define void", "define internal void", 1)
    return text + _print_rows(outputs, n_states, kind, "rows_held") + _print_rows(outputs, n_states, kind, "rows")


def _print_rows(outputs: Any, n_states: int, kind: Kind, name: str) -> str:
    text, d, n = Text(kind), kind.number, kind.width
    elements: list[set[int]] = [set() for _ in range(4)]
    for instruction in instructions(outputs):
        if instruction.operation == "input":
            elements[instruction.place[0]].add(instruction.place[1])

    def broadcast(pointer: str, element: int) -> str:
        """Add a vector whose elements all equal one double in memory, and return its name."""
        location = text.emit(f"getelementptr inbounds double, ptr {pointer}, i64 {element * n}")
        value = text.emit(f"load double, ptr {location}")
        first = text.emit(f"insertelement {d} undef, double {value}, i32 0")
        return text.emit(f"shufflevector {d} {first}, {d} undef, <{n} x i32> zeroinitializer")

    n_y = outputs.nnz_out(0)
    for local, size in (("%xs", n_states), ("%us", outputs.nnz_in(2)), ("%ps", outputs.nnz_in(3)), ("%y", n_y)):
        text.lines.append(f"  {local} = alloca {d}, i64 {max(1, size)}")
    text.lines += [f"  %time = alloca {d}", "  %n = load i64, ptr %n_rows", "  %from = load i64, ptr %column"]
    end, begin, length = broadcast("%before", 0), broadcast("%th", 0), broadcast("%th", 1)
    for k in sorted(elements[3]):
        text.store(broadcast("%p", k), "%ps", k)
    if name == "rows_held":
        for k in sorted(elements[2]):
            text.store(broadcast("%u", k), "%us", k)
    parts = {
        k: [broadcast(pointer, index) for pointer, index in (("%x0", k), ("%x1", k), ("%d", k), ("%d", n_states + k))]
        for k in sorted(elements[1])
    }
    text.lines += ["  br label %next", "next:", "  %c = phi i64 [ %from, %0 ], [ %further, %next ]"]
    text.lines.append("  %first = getelementptr inbounds double, ptr %grid, i64 %c")
    time = text.emit(f"load {d}, ptr %first, align 8")
    mask = text.emit(f"fcmp olt {d} {time}, {end}")
    text.store(time, "%time", 0)
    theta = text.emit(f"fdiv {d} {text.emit(f'fsub {d} {time}, {begin}')}, {length}")
    flag = text.emit(f"fcmp ogt {d} {theta}, {kind.words['zero']}")
    theta = text.emit(f"select {kind.flag} {flag}, {d} {theta}, {d} {kind.words['zero']}")
    complement = text.emit(f"fsub {d} {kind.words['one']}, {theta}")
    for k, (x0, x1, d0, d1) in parts.items():
        weighted = text.multiply_add(complement, text.multiply_add(theta, d1, d0), x1)
        text.store(text.multiply_add(theta, weighted, text.emit(f"fmul {d} {complement}, {x0}")), "%xs", k)
    if name == "rows":
        for k in sorted(elements[2]):
            text.store(text.load("%u", k), "%us", k)
    text.lines.append("  call void @row(ptr %time, ptr %xs, ptr %us, ptr %ps, ptr %y)")
    for k in range(n_y):
        index = text.emit(f"add i64 {text.emit(f'mul i64 %n, {k}')}, %c")
        pointer = text.emit(f"getelementptr inbounds double, ptr %table, i64 {index}")
        arguments = f"{d} {text.load('%y', k)}, ptr {pointer}, i32 8, {kind.flag} {mask}"
        text.lines.append(f"  call void @llvm.masked.store.{kind.suffix}.p0({arguments})")
    bits = text.emit(f"bitcast {kind.flag} {mask} to i{n}")
    wide = text.emit(f"zext i{n} {bits} to i64")
    written = text.emit(f"call i64 @llvm.ctpop.i64(i64 {wide})")
    text.lines.append(f"  %further = add i64 %c, {written}")
    is_full = text.emit(f"icmp eq i64 {written}, {n if name == 'rows_held' else n + 1}")
    text.lines += [f"  br i1 {is_full}, label %next, label %done", "done:", "  store i64 %further, ptr %column"]
    definition = text.define(name, "%grid %table %column %n_rows %before %th %x0 %x1 %d %u %p")
    if name == "rows":
        return definition
    declared = f"declare void @llvm.masked.store.{kind.suffix}.p0({d}, ptr, i32, {kind.flag})"
    return "\n".join([declared, "declare i64 @llvm.ctpop.i64(i64)", definition])
