"""Printer (code generator) of traced functions as C that is valid C90, C99 and C++.

A printed function has one pointer per input and output, and no state:
``void rates(const double *t, const double *x, const double *u, const double *p, double *f)``. It allocates no memory
and calls only functions of `math.h`. Long functions are divided into blocks, which pass live values in an array.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

from poppet.engine.printers.instructions import SIGNATURES, Block, blocks, instructions
from poppet.engine.printers.statements import BlockForms, Language
from poppet.engine.rosenbrock import ARGUMENT, COUPLING, DENSE, GAMMA, INPUT_TIMES, STAGE_DRIFT, STAGE_TIME

BLOCK_SIZE = 1500
"""Maximum number of instructions per block; the time of compilers increases faster than linearly."""
_FORMS = {
    "assign": "{0}",
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "sq": "{0} * {0}",
    "twice": "{0} + {0}",
    "inv": "1.0 / {0}",
    # C90 has no fmin and fmax; these forms handle NaN like the kernel.
    "fmin": "{0} < {1} ? {0} : {1}",
    "fmax": "{0} > {1} ? {0} : {1}",
    "if_else_zero": "{0} != 0.0 ? {1} : 0.0",
    "not": "{0} == 0.0 ? 1.0 : 0.0",
    "and": "{0} != 0.0 && {1} != 0.0 ? 1.0 : 0.0",
    "or": "{0} != 0.0 || {1} != 0.0 ? 1.0 : 0.0",
    "lt": "{0} < {1} ? 1.0 : 0.0",
    "le": "{0} <= {1} ? 1.0 : 0.0",
    "eq": "{0} == {1} ? 1.0 : 0.0",
    "ne": "{0} != {1} ? 1.0 : 0.0",
    "sign": "{0} > 0.0 ? 1.0 : {0} < 0.0 ? -1.0 : 0.0",
    "copysign": "with_sign({0}, {1})",
    "pow": "power({0}, {1})",
}
"""Expressions of operations; all other operations are functions of `math.h` with the same name."""
_OF_LIBRARY = ("sqrt", "fabs", "floor", "ceil", "exp", "log", "sin", "cos", "tan", "tanh", "atan", "atan2")


LARGEST_SINGLE = 3e38
"""Constants beyond this magnitude are infinite in single precision."""


class Precision(NamedTuple):
    """Floating-point type in C, for example double.

    It contains the suffixes of its constants and of its functions in `math.h`.
    """

    real: str = "double"
    ending: str = ""

    def literal(self, value: float) -> str:
        """Return the text of a constant in C, with all significant digits."""
        if math.isnan(value):
            return "(0.0 / 0.0)"
        if math.isinf(value) or (self.ending and abs(value) > LARGEST_SINGLE):
            return f"{'-' if value < 0.0 else ''}HUGE_VAL{self.ending.upper()}"
        digits = repr(float(value)) if not self.ending else f"{value:.9g}"
        digits = digits if any(c in digits for c in ".e") else f"{digits}.0"
        return f"({digits}{self.ending})" if value < 0.0 else f"{digits}{self.ending}"


DOUBLE, SINGLE = Precision(), Precision("float", "f")


_POWER = """\
/* The exponent of the flow law is a number like others, and nearly always 1/2. */
static double power(double x, double e) {
  if (e == 0.5) return sqrt(x);
  if (e == (-0.5)) return 1.0 / sqrt(x);
  return pow(x, e);
}"""
_WITH_SIGN = """\
static double with_sign(double x, double s) {
  double size = fabs(x);
  return s < 0.0 || (s == 0.0 && 1.0 / s < 0.0) ? -size : size;
}"""
_STATEMENT_HELPERS = {
    "smaller": """\
static {real} smaller({real} a, {real} b) {{
  return (a < b) ? a : b;
}}""",
    "larger": """\
static {real} larger({real} a, {real} b) {{
  return (a > b) ? a : b;
}}""",
    "power": """\
/* The exponent is nearly always 1/2. */
static {real} power({real} x, {real} e) {{
  {real} result;
  if (e == {half}) {{
    result = sqrt{ending}(x);
  }} else if (e == {minus_half}) {{
    result = {one} / sqrt{ending}(x);
  }} else {{
    result = pow{ending}(x, e);
  }}
  return result;
}}""",
    "with_sign": """\
static {real} with_sign({real} x, {real} s) {{
  const {real} size = fabs{ending}(x);
  return ((s < {zero}) || ((s == {zero}) && (({one} / s) < {zero}))) ? (-size) : size;
}}""",
}
"""Functions that readable statements call, by name. They have one exit and braces, as MISRA C requires."""


def statement_helpers(text: str, precision: Precision) -> str:
    """Return the C text of the helper functions that readable statements call."""
    numbers = {"half": 0.5, "minus_half": -0.5, "one": 1.0, "zero": 0.0}
    fields = {name: precision.literal(number) for name, number in numbers.items()}
    fields |= {"real": precision.real, "ending": precision.ending}
    return "\n\n".join(form.format(**fields) for name, form in _STATEMENT_HELPERS.items() if f"{name}(" in text)


def used_prelude(text: str) -> str:
    """Return the C definitions of the helper functions that are called in C code.

    `text` is this C code. Other helper functions are omitted, because compilers would warn about unused functions.
    """
    return "\n\n".join(f for f, name in ((_POWER, "power("), (_WITH_SIGN, "with_sign(")) if name in text)


def statement_language(precision: Precision) -> Language:
    """Return the syntax of C for readable statements, which call `smaller`, `larger` and `power`."""
    real, e = precision
    one, zero = precision.literal(1.0), precision.literal(0.0)
    operations = {
        **{name: _FORMS[name] for name in ("add", "sub", "mul", "div", "neg", "sq", "twice", "copysign", "pow")},
        "inv": f"{one} / {{0}}",
        "fmin": "smaller({0}, {1})",
        "fmax": "larger({0}, {1})",
        "sign": f"(({{0}} > {zero}) ? {one} : (({{0}} < {zero}) ? -{one} : {zero}))",
        **{name: f"{name}{e}({{0}})" for name in _OF_LIBRARY if name != "atan2"},
        "atan2": f"atan2{e}({{0}}, {{1}})",
    }
    return Language(
        operations=operations,
        comparisons={"lt": "{0} < {1}", "le": "{0} <= {1}", "eq": "{0} == {1}", "ne": "{0} != {1}"},
        reversed={"lt": "{1} > {0}", "le": "{1} >= {0}"},
        logic={"and": "{0} && {1}", "or": "{0} || {1}", "not": "!{0}", "true": "true", "false": "false"},
        literal=precision.literal,
        choice="{0} ? {1} : {2}",
        non_zero=f"{{0}} != {zero}",
        types=(real, "bool"),
        declaration="  const {type} {name} = {text};",
        assignment="  {name} = {text};",
        comment="  /* {text} */",
        blocks=BlockForms(
            indent="  ",
            variable="{type} {name} = {text};",
            switch="switch ((int){0}) {{",
            case="case {0}: {1}",
            end_case=("break;",),
            end_switch=("  default:", "    break;", "}"),
            if_true="if ({0}) {{",
            else_if="}} else if ({0}) {{",
            otherwise="} else {",
            end_if="}",
            has_last_else=True,
        ),
        longest=60,
    )


def print_function(
    function: Any,
    name: str,
    signature: str = "",
    *,
    labels: Mapping[str, Sequence[str]] | None = None,
    head: str = "void",
    prefix: str = "",
    shares_inverses: bool = False,
) -> str:
    """Return the C text of one traced function.

    `signature` contains the names of its arguments and results, for example an entry of `SIGNATURES`. The keyword
    `labels` contains comments for the elements of each argument. With the keyword `shares_inverses`, divisions by the
    same value become products with one inverse, which is faster and changes the last digit.
    """
    arguments, _, results = (signature or SIGNATURES[name]).partition("->")
    names, name = (arguments.split(), results.split()), prefix + name
    formal = [f"const double *{argument}" for argument in names[0]] + [f"double *{result}" for result in names[1]]
    style = _Style(labels or {}, shares_inverses)
    parts = blocks(instructions(function), BLOCK_SIZE)
    if len(parts) <= 1:
        block = parts[0] if parts else Block((), frozenset())
        return "\n".join([f"{head} {name}({', '.join(formal)}) {{", *_print_block(block, names, style), "}"])
    text: list[str] = []
    for k, block in enumerate(parts):
        block_arguments = ", ".join([*formal, "double *w"])
        text += [f"static void {name}_{k}({block_arguments}) {{", *_print_block(block, names, style, "w"), "}", ""]
    text += [f"{head} {name}({', '.join(formal)}) {{", f"  double w[{function.sz_w()}];"]
    actual = ", ".join([*names[0], *names[1], "w"])
    return "\n".join([*text, *(f"  {name}_{k}({actual});" for k in range(len(parts))), "}"])


class _Style(NamedTuple):
    """Options with which a function is printed in C."""

    labels: Mapping[str, Sequence[str]]
    shares_inverses: bool


def _print_block(block: Block, names: tuple[list[str], list[str]], style: _Style, passed: str = "") -> list[str]:
    """Return the lines of C for a sequence of instructions.

    Each intermediate value becomes a constant in C. Lines that store results come last. `passed` is the name of the
    array that passes values between blocks.
    """
    live = _live_instructions(block)
    lines: list[str] = []
    stores: list[str] = []
    values: dict[int, str] = {}  # text of each value: the name of a variable, or a constant
    referenced: set[str] = set()
    inverses: dict[int, str] = {}
    divisors = _shared_divisors(block, live) if style.shares_inverses else {}

    def value(slot: int) -> str:
        if slot not in values:
            referenced.add(passed)
            values[slot] = assign(f"{passed}[{slot}]")
        return values[slot]

    def assign(text: str, comment: str = "") -> str:
        name = f"v{len(lines)}"
        lines.append(f"  const double {name} = {text};{comment}")
        return name

    def comment(vector: str, element: int) -> str:
        labels = style.labels.get(vector, ())
        return f" /* {labels[element]} */" if element < len(labels) else ""

    for k, instruction in enumerate(block.instructions):
        vector, element = instruction.place
        if instruction.operation == "output":
            name = names[1][vector]
            referenced.add(name)
            stores.append(f"  {name}[{element}] = {value(instruction.arguments[0])};{comment(name, element)}")
        elif k not in live:
            continue
        elif instruction.operation == "input":
            name = names[0][vector]
            referenced.add(name)
            values[instruction.result] = assign(f"{name}[{element}]", comment(name, element))
        elif instruction.operation == "const":
            values[instruction.result] = DOUBLE.literal(instruction.constant)
        else:
            arguments = [value(slot) for slot in instruction.arguments]
            if k in divisors:
                divisor = divisors[k]
                if divisor not in inverses:
                    inverses[divisor] = assign(f"1.0 / {arguments[-1]}")
                is_inverse = instruction.operation == "inv"
                product = f"{arguments[0]} * {inverses[divisor]}"
                values[instruction.result] = inverses[divisor] if is_inverse else assign(product)
                continue
            operation = instruction.operation
            if operation not in _FORMS and operation not in _OF_LIBRARY:
                raise NotImplementedError(f"no form in C for the CasADi operation {operation}")
            form = _FORMS.get(operation)
            call = f"{operation}({', '.join(arguments)})" if form is None else form.format(*arguments)
            values[instruction.result] = assign(call)
    stores += [f"  {passed}[{slot}] = {values[slot]};" for slot in sorted(block.live_out)]
    referenced |= {passed} if block.live_out else set()
    ignored = [
        f"  (void){name};" for name in (*names[0], *names[1], *([passed] if passed else [])) if name not in referenced
    ]
    return [*lines, *ignored, *stores]


def _shared_divisors(block: Block, live: Collection[int]) -> dict[int, int]:
    """Return the divisions whose divisor is also the divisor of another division.

    The keys are indices of instructions. Divisions with the same divisor have the same value.
    """
    origin: dict[int, int] = {}
    divisors: dict[int, int] = {}
    for k, instruction in enumerate(block.instructions):
        if instruction.operation in ("div", "inv") and k in live:
            divisors[k] = origin.get(instruction.arguments[-1], -1 - instruction.arguments[-1])
        origin[instruction.result] = k
    count = Counter(divisors.values())
    return {k: divisor for k, divisor in divisors.items() if count[divisor] > 1}


def _live_instructions(block: Block) -> set[int]:
    """Return the indices of the instructions whose results are used.

    All others are not printed, because compilers warn about unused variables.
    """
    needed, live = set(block.live_out), set()
    for k in reversed(range(len(block.instructions))):
        instruction = block.instructions[k]
        if instruction.operation == "output" or instruction.result in needed:
            live.add(k)
            needed.discard(instruction.result)
            needed.update(instruction.arguments)
    return live


# Step of the kernel


def _weighted_sum_of_stages(weights: Sequence[float]) -> str:
    """Return a C expression for a weighted sum of the solver stages of one state.

    With the index s of the state, it is `weights[0]*k0[s] + weights[1]*k1[s]` and so on.
    """
    return " + ".join(f"{DOUBLE.literal(weight)} * k{j}[s]" for j, weight in enumerate(weights))


def _with_drift(i: int, rates: str) -> str:
    """Return a C expression for the rate of a state plus the drift term of a solver stage.

    The drift is the time derivative of the rate. `i` is the index of the stage, and `rates` the expression of the rate.
    """
    return rates if STAGE_DRIFT[i] == 0.0 else f"{rates} + {DOUBLE.literal(STAGE_DRIFT[i])} * h * drift[s]"


def print_step(n_states: int, n_inputs: int, head: str = "void", prefix: str = "") -> str:
    """Return the C text of `step` and `dense` for the Rosenbrock method RODAS.

    `step` computes one step, and `dense` its interpolant. The module `poppet.engine.printers.llvm_step` describes them.
    """
    n = n_states
    stages = [f"  double *k{i} = k + {i * n};" for i in range(6)]
    text = [
        f"{head} {prefix}step(const double *th, const double *x0, const double *us, const double *p, const double *f0,",
        "          const double *J, const double *drift, double *w, double *k, double *x1) {",
        f"  double *time = w + 1, *f1 = w + 2, *right = w + {2 + n}, *lu = w + {2 + 2 * n};",
        *stages,
        "  const double h = th[1], g = 1.0 / h;",
        "  int s;",
        f"  w[0] = {1.0 / GAMMA!r} * g;",
        f"  {prefix}factor(J, w, lu);",
        f"  for (s = 0; s < {n}; s++) right[s] = {_with_drift(0, 'f0[s]')};",
        f"  {prefix}solve(lu, right, k0);",
    ]
    for i in range(1, 6):
        inputs = f"us + {INPUT_TIMES.index(STAGE_TIME[i]) * n_inputs}"
        coupled_rates = f"f1[s] + g * ({_weighted_sum_of_stages(COUPLING[i])})"
        text += [
            f"  for (s = 0; s < {n}; s++) x1[s] = x0[s] + {_weighted_sum_of_stages(ARGUMENT[i])};",
            f"  *time = th[0] + {DOUBLE.literal(STAGE_TIME[i])} * h;",
            f"  {prefix}rates(time, x1, {inputs}, p, f1);",
            f"  for (s = 0; s < {n}; s++) right[s] = {_with_drift(i, coupled_rates)};",
            f"  {prefix}solve(lu, right, k{i});",
        ]
    text += [
        "  /* The last stage is the difference of both orders: the new state is its argument and it. */",
        f"  for (s = 0; s < {n}; s++) x1[s] += k5[s];",
        "}",
        "",
        f"{head} {prefix}dense(const double *k, double *d) {{",
        *(f"  const double *k{i} = k + {i * n};" for i in range(5)),
        f"  double *d0 = d, *d1 = d + {n};",
        "  int s;",
        f"  for (s = 0; s < {n}; s++) {{",
        *(f"    d{k}[s] = {_weighted_sum_of_stages(DENSE[k])};" for k in range(2)),
        "  }",
        "}",
    ]
    return "\n".join(text)
