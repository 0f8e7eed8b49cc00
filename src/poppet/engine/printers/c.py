"""Printer: the instructions of a traced function become C, which is C90, C99 and C++ alike.

A printed function takes one pointer per input and per output and holds no state, as those of the LLVM printer do:
``void rates(const double *t, const double *x, const double *u, const double *p, double *f)``. It allocates nothing and
calls nothing but `math.h`. Long lists are cut into blocks that hand their live values on through an array.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

from poppet.engine.printers.instructions import SIGNATURES, Block, Instruction, blocks, instructions
from poppet.engine.rosenbrock import ARGUMENT, COUPLING, DENSE, GAMMA, INPUT_TIMES, STAGE_DRIFT, STAGE_TIME

BLOCK_SIZE = 1500
"""Instructions per block; compilers take longer than linearly for more."""
_FORMS = {
    "assign": "{0}",
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "sq": "{0} * {0}",
    "twice": "{0} + {0}",
    "inv": "{one} / {0}",
    # Not fmin and fmax, which C90 has not; so the kernel does it, also where something is no number.
    "fmin": "{0} < {1} ? {0} : {1}",
    "fmax": "{0} > {1} ? {0} : {1}",
    "if_else_zero": "{0} != {zero} ? {1} : {zero}",
    "not": "{0} == {zero} ? {one} : {zero}",
    "and": "{0} != {zero} && {1} != {zero} ? {one} : {zero}",
    "or": "{0} != {zero} || {1} != {zero} ? {one} : {zero}",
    "lt": "{0} < {1} ? {one} : {zero}",
    "le": "{0} <= {1} ? {one} : {zero}",
    "eq": "{0} == {1} ? {one} : {zero}",
    "ne": "{0} != {1} ? {one} : {zero}",
    "sign": "{0} > {zero} ? {one} : {0} < {zero} ? -{one} : {zero}",
    "copysign": "with_sign({0}, {1})",
    "pow": "power({0}, {1})",
}
"""Expressions of operations; all others are functions of `math.h` of the same name."""
_FLAGS = ("lt", "le", "eq", "ne", "not", "and", "or")
_OF_LIBRARY = ("sqrt", "fabs", "floor", "ceil", "exp", "log", "sin", "cos", "tan", "tanh", "atan", "atan2")


LARGEST_SINGLE = 3e38


class Precision(NamedTuple):
    """The type of numbers, and the ending of its constants and of its functions in `math.h`."""

    real: str = "double"
    ending: str = ""

    def literal(self, value: float) -> str:
        """A constant of which no digit is lost."""
        if math.isnan(value):
            return "(0.0 / 0.0)"
        if math.isinf(value) or (self.ending and abs(value) > LARGEST_SINGLE):
            return f"{'-' if value < 0.0 else ''}HUGE_VAL{self.ending.upper()}"
        shown = repr(float(value)) if not self.ending else f"{value:.9g}"
        shown = shown if any(c in shown for c in ".e") else f"{shown}.0"
        return f"({shown}{self.ending})" if value < 0.0 else f"{shown}{self.ending}"


DOUBLE, SINGLE = Precision(), Precision("float", "f")


def prelude(precision: Precision = DOUBLE) -> str:
    """Functions that the printed ones use, where they use them."""
    real, e = precision
    one, zero = precision.literal(1.0), precision.literal(0.0)
    return f"""/* The exponent of the flow law is a number like others, and nearly always 1/2. */
static {real} power({real} x, {real} e) {{
  if (e == {precision.literal(0.5)}) return sqrt{e}(x);
  if (e == {precision.literal(-0.5)}) return {one} / sqrt{e}(x);
  return pow{e}(x, e);
}}

static {real} with_sign({real} x, {real} s) {{
  {real} size = fabs{e}(x);
  return s < {zero} || (s == {zero} && {one} / s < {zero}) ? -size : size;
}}
"""


def used_prelude(text: str, precision: Precision = DOUBLE) -> str:
    """Of these functions those that a text calls: compilers warn about the others."""
    first, second = prelude(precision).split("\n\n", 1)
    return "\n\n".join(
        f for f, name in ((first, "power("), (second.rstrip(), "with_sign(")) if name in text
    )  # fmt: skip


def print_function(
    function: Any,
    name: str,
    signature: str = "",
    *,
    labels: Mapping[str, Sequence[str]] | None = None,
    precision: Precision = DOUBLE,
    head: str = "void",
    prefix: str = "",
    wide: Mapping[str, Collection[int]] | None = None,
    shares_inverses: bool = False,
) -> str:
    """C of one traced function.

    `signature` names its arguments, as `SIGNATURES` does; `labels` says for each argument what its elements are. In
    single precision the vectors of `wide` are of doubles all the same, and those elements of them stay so in what is
    worked out of them: times, of which no digit may get lost. Other elements of these vectors do beside such ones.
    With `shares_inverses` divisions by the same are products with one inverse, faster and different in the last digit.
    """
    given, _, made = (signature or SIGNATURES[name]).partition("->")
    names, name = (given.split(), made.split()), prefix + name
    wide = wide or {}

    def vector(argument: str) -> str:
        return f"{'double' if argument in wide else precision.real} *{argument}"

    formal = [f"const {vector(a)}" for a in names[0]] + [vector(a) for a in names[1]]
    cut = blocks(instructions(function), BLOCK_SIZE)
    if len(cut) <= 1:
        every = cut or [Block((), frozenset())]
        return "\n".join(
            [
                f"{head} {name}({', '.join(formal)}) {{",
                *_printed(every[0], names, _Style(labels or {}, precision, wide, shares_inverses)),
                "}",
            ]
        )
    text: list[str] = []
    for number, block in enumerate(cut):
        arguments = ", ".join([*formal, f"{precision.real} *w"])
        text += [
            f"static void {name}_{number}({arguments}) {{",
            *_printed(block, names, _Style(labels or {}, precision, wide, shares_inverses), "w"),
            "}",
            "",
        ]
    text += [f"{head} {name}({', '.join(formal)}) {{", f"  {precision.real} w[{function.sz_w()}];"]
    actual = ", ".join([*names[0], *names[1], "w"])
    return "\n".join([*text, *(f"  {name}_{number}({actual});" for number in range(len(cut))), "}"])


class _Style(NamedTuple):
    """How a function is printed."""

    labels: Mapping[str, Sequence[str]]
    precision: Precision
    wide: Mapping[str, Collection[int]]
    shares_inverses: bool


class _Value(NamedTuple):
    """A value of a block: a name or a constant, and whether it is a double where others are not; beside those it is
    what is `kept`, with all its digits."""

    name: str
    constant: float = 0.0
    is_wide: bool = False
    kept: str = ""

    def shown(self, precision: Precision) -> str:
        name = self.kept if self.kept and not precision.ending else self.name
        return name or precision.literal(self.constant)


def _printed(block: Block, names: tuple[list[str], list[str]], style: _Style, handed: str = "") -> list[str]:
    """Lines of one block: a constant for every value, then what is written."""
    live, own, is_single = _live(block), style.precision, bool(style.precision.ending)
    lines: list[str] = []
    stores: list[str] = []
    values: dict[int, _Value] = {}
    used: set[str] = set()
    inverses: dict[int, _Value] = {}
    divisors = _divisors(block, live) if style.shares_inverses else {}

    def value(slot: int) -> _Value:
        if slot not in values:
            used.add(handed)
            values[slot] = named(f"{handed}[{slot}]")
        return values[slot]

    def named(text: str, remark: str = "", is_wide: bool = False) -> _Value:
        name = f"v{len(lines)}"
        lines.append(f"  const {'double' if is_wide else own.real} {name} = {text};{remark}")
        return _Value(name, is_wide=is_wide)

    def remark(vector: str, element: int) -> str:
        known = style.labels.get(vector, ())
        return f" /* {known[element]} */" if element < len(known) else ""

    for k, each in enumerate(block.instructions):
        vector, element = each.place
        if each.operation == "output":
            name = names[1][vector]
            used.add(name)
            given = value(each.arguments[0])
            cast = f"({own.real})" if given.is_wide and name not in style.wide else ""
            stores.append(f"  {name}[{element}] = {cast}{given.shown(own)};{remark(name, element)}")
        elif k not in live:
            continue
        elif each.operation == "input":
            name = names[0][vector]
            used.add(name)
            is_wide = is_single and element in style.wide.get(name, ())
            kept = f"{name}[{element}]"
            if is_single and name in style.wide and not is_wide:
                values[each.result] = _Value(f"({own.real}){kept}", kept=kept)
            else:
                values[each.result] = named(kept, remark(name, element), is_wide)
        elif each.operation == "const":
            is_wide = is_single and abs(each.constant) > LARGEST_SINGLE
            values[each.result] = _Value("", each.constant, is_wide)
        else:
            arguments = [value(slot) for slot in each.arguments]
            # A choice is what is chosen, and a comparison a flag.
            deciding = arguments[1:] if each.operation == "if_else_zero" else arguments
            is_wide = each.operation not in _FLAGS and any(argument.is_wide for argument in deciding)
            if k in divisors:
                of = divisors[k]
                if of not in inverses:
                    inverses[of] = named(f"{own.literal(1.0)} / {arguments[-1].shown(own)}")
                product = f"{arguments[0].shown(own)} * {inverses[of].name}"
                values[each.result] = inverses[of] if each.operation == "inv" else named(product)
                continue
            text = _expression(each, arguments, own, is_wide)
            values[each.result] = named(text, is_wide=is_wide)
    stores += [f"  {handed}[{slot}] = {values[slot].shown(own)};" for slot in sorted(block.handed_on)]
    used |= {handed} if block.handed_on else set()
    ignored = [f"  (void){name};" for name in (*names[0], *names[1], *([handed] if handed else [])) if name not in used]
    return [*lines, *ignored, *stores]


def _divisors(block: Block, live: Collection[int]) -> dict[int, int]:
    """Divisions whose divisor others have too: their places in the block, and where that comes from."""
    made: dict[int, int] = {}
    found: dict[int, int] = {}
    for k, each in enumerate(block.instructions):
        if each.operation in ("div", "inv") and k in live:
            found[k] = made.get(each.arguments[-1], -1 - each.arguments[-1])
        made[each.result] = k
    count = Counter(found.values())
    return {k: of for k, of in found.items() if count[of] > 1}


def _live(block: Block) -> set[int]:
    """Places in a block of what something needs: compilers warn about the rest."""
    wanted, found = set(block.handed_on), set()
    for k in reversed(range(len(block.instructions))):
        each = block.instructions[k]
        if each.operation == "output" or each.result in wanted:
            found.add(k)
            wanted.discard(each.result)
            wanted.update(each.arguments)
    return found


def _expression(instruction: Instruction, arguments: Sequence[_Value], own: Precision, is_wide: bool) -> str:
    result = DOUBLE if is_wide else own
    # Beside a double a constant keeps its digits, also in a comparison.
    among = DOUBLE if any(argument.is_wide for argument in arguments) else own
    shown = [argument.shown(among) for argument in arguments]
    form = _FORMS.get(instruction.operation)
    if form is not None:
        return form.format(*shown, one=result.literal(1.0), zero=result.literal(0.0))
    if instruction.operation not in _OF_LIBRARY:
        raise NotImplementedError(f"no form in C for the CasADi operation {instruction.operation}")
    return f"{instruction.operation}{result.ending}({', '.join(shown)})"


# The step of the kernel


def _weighted(weights: Sequence[float]) -> str:
    """Sum of weights times stages at one state."""
    return " + ".join(f"{DOUBLE.literal(weight)} * k{j}[s]" for j, weight in enumerate(weights))


def _with_drift(i: int, rates: str) -> str:
    """Rates, and the drift of stage i times the step."""
    return rates if STAGE_DRIFT[i] == 0.0 else f"{rates} + {DOUBLE.literal(STAGE_DRIFT[i])} * h * drift[s]"


def print_step(n_states: int, n_inputs: int, head: str = "void", prefix: str = "") -> str:
    """C of `step` and `dense`, which `poppet.engine.printers.llvm_step` describes: one step of RODAS."""
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
        text += [
            f"  for (s = 0; s < {n}; s++) x1[s] = x0[s] + {_weighted(ARGUMENT[i])};",
            f"  *time = th[0] + {DOUBLE.literal(STAGE_TIME[i])} * h;",
            f"  {prefix}rates(time, x1, {inputs}, p, f1);",
            f"  for (s = 0; s < {n}; s++) right[s] = {_with_drift(i, f'f1[s] + g * ({_weighted(COUPLING[i])})')};",
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
        *(f"    d{k}[s] = {_weighted(DENSE[k])};" for k in range(2)),
        "  }",
        "}",
    ]
    return "\n".join(text)
