"""C code of the functions of a model, with comments that name states, parameters and outputs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from poppet.deploy.export_files import comment_text
from poppet.deploy.export_model import ExportModel
from poppet.engine.model import Model
from poppet.engine.printers.c import DOUBLE, print_function, print_step, used_prelude
from poppet.engine.printers.instructions import SIGNATURES, trace_functions

if TYPE_CHECKING:
    import casadi

DIRECTIONAL = "t x u p dx du dp -> df dy"
_SIGNATURES = {
    **SIGNATURES,
    "directional": DIRECTIONAL,
    "step": "th x us p rates J drift scratch -> stages x1",
    "dense": "stages -> coefficients",
}


@cache
def integrator_code(name: str = "integrate") -> str:
    """Return the C source of the adaptive integrator under a given function name.

    The signature is ``int64_t integrate(const int64_t *fields)``, in which `name` replaces `integrate`.
    """
    text = files("poppet.engine").joinpath("integrator.c").read_text(encoding="utf-8")
    head = "int64_t integrate(const int64_t *fields)"
    assert head in text
    return text.replace(head, f"{head};\n{head}").replace("integrate(const", f"{name}(const")


def integrator_excerpt(*markers: str) -> str:
    """Return selected blocks of the integrator source.

    A block is a type or a function between two empty lines. Each marker selects the first block that contains it.
    """
    blocks = integrator_code().split("\n\n")
    return "\n\n".join(next(block for block in blocks if marker in block) for marker in markers)


def model_code(export_model: ExportModel, prefix: str = "", further: Sequence[str] = ()) -> str:
    """Return the C code of all model functions and of the integration step.

    The C functions in `further` are appended. Each function name begins with `prefix`.
    """
    model = export_model.model
    step = [print_step(model.size, len(model.inputs), "void", prefix)] if model.size else []
    return _print_functions(export_model, export_model.functions, [*step, *further], head="void", prefix=prefix)


def static_code(export_model: ExportModel, functions: Mapping[str, casadi.Function]) -> str:
    """Return the C code of model functions that are visible only in their source file."""
    return _print_functions(export_model, functions, [], head="static void", shares_inverses=True)


def _print_functions(
    export_model: ExportModel, functions: Mapping[str, casadi.Function], further: Sequence[str], **settings: Any
) -> str:
    """Return the C code of CasADi functions, after the helper functions that they need.

    `further` contains more functions. Comments in the code name the elements of arguments and results by their
    addresses in the circuit.
    """
    states, parameters, memory, inputs, outputs = (
        [comment_text(quantity.address) for quantity in getattr(export_model, name)]
        for name in ("states", "parameters", "memory", "inputs", "outputs")
    )
    labels = {"x": states, "f": states, "p": parameters + memory, "z": memory, "u": inputs, "y": outputs}
    printed = [print_function(f, name, labels=labels, **settings) for name, f in functions.items()]
    code = "\n\n".join([*printed, *further])
    return "\n\n".join(filter(None, (used_prelude(code), code)))


def prototypes(names: Iterable[str], prefix: str) -> list[str]:
    """Return the C prototypes of several model functions.

    `names` are the names of the functions, and `prefix` is their prefix in C.
    """
    lines = []
    for name in names:
        inputs, outputs = (side.split() for side in _SIGNATURES[name].split("->"))
        arguments = [f"double *{a}" if a == "scratch" else f"const double *{a}" for a in inputs]
        lines.append(f"void {prefix}{name}({', '.join([*arguments, *(f'double *{a}' for a in outputs)])});")
    return lines


def fixed_step_functions(model: Model) -> dict[str, casadi.Function]:
    """Return the model functions for an integration with fixed steps.

    The quadratures, which integrate flows for the balances, are omitted from the state vector.
    """
    n, symbols, expressions = len(model.states), dict(model.symbols), dict(model.expressions)
    symbols["x"], expressions["rates"] = symbols["x"][:n], expressions["rates"][:n]
    expressions["start"] = expressions["start"][:n]
    # No function depends on the quadratures.
    functions = trace_functions(replace(model, n_quadratures=0, symbols=symbols, expressions=expressions))
    names = (*(("rates", "jacobian", "factor", "solve") if model.states else ()), "outputs", "start", "update")
    return {name: functions[name] for name in names if name in functions}


def fill_template(file: str, name: str, fields: Mapping[str, str]) -> str:
    """Return the text of a C template in which placeholders are replaced.

    `fields` maps placeholders to their texts. `name`, the name of the model, replaces the prefix `model` of the C
    names.
    """
    text = files("poppet.deploy.c").joinpath("texts", file).read_text(encoding="utf-8")
    text = re.sub(r"\b(model|MODEL)_", lambda match: f"{name if match[1] == 'model' else name.upper()}_", text)
    # The fields are inserted last and in one pass: texts of the circuit are not searched for fields.
    return re.sub(r"@(\w+)@", lambda match: fields[match[1]], text)


def number_list(numbers: Iterable[float]) -> str:
    """Return numbers as C literals with all digits, separated by commas."""
    return ", ".join(DOUBLE.literal(float(number)) for number in numbers)


def number_rows(rows: Iterable[Iterable[float]]) -> str:
    """Return a two-dimensional table of numbers as C literals, one line per row."""
    return ",\n".join(f"  {number_list(row)}" for row in rows) or "  0.0"


def enum_members(prefix: str, rows: Sequence[tuple[str, str]]) -> str:
    """Return the members of a C enumeration, each with a comment.

    Each element of `rows` contains an identifier, to which `prefix` is added, and its comment.
    """
    lines = [
        f"  {prefix}_{name} = {k}{'' if k == len(rows) - 1 else ','} /* {comment} */"
        for k, (name, comment) in enumerate(rows)
    ]
    return "\n".join(lines) or f"  {prefix}_none = 0"


def comment_rows(quantities: Iterable[Any], *, with_value: bool = False) -> list[tuple[str, str]]:
    """Return an identifier and a comment for each quantity.

    The comment contains address and unit. If the keyword `with_value` is True, it also contains the value.
    """
    rows = []
    for q in quantities:
        unit = comment_text(q.unit if q.unit not in ("", "1") else "-")
        rows.append((q.identifier, f"{comment_text(q.address)} [{unit}]{f' {q.value:.6g}' if with_value else ''}"))
    return rows
