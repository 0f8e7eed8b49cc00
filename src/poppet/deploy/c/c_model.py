"""C code of the functions of a model, with comments that name states, parameters and outputs."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Any

from poppet.deploy.export_files import comment_text
from poppet.deploy.export_model import ExportModel
from poppet.engine.model import Model
from poppet.engine.printers.c import print_function, print_step, used_prelude
from poppet.engine.printers.instructions import SIGNATURES, traced_functions


@cache
def integrator_code(name: str = "integrate") -> str:
    """Return the adaptive integrator, ``int64_t integrate(const int64_t *fields)``, with another name."""
    text = files("poppet.engine").joinpath("integrator.c").read_text(encoding="utf-8")
    head = "int64_t integrate(const int64_t *fields)"
    assert head in text
    return text.replace(head, f"{head};\n{head}").replace("integrate(const", f"{name}(const")


def integrator_excerpt(*markers: str) -> str:
    """Return the types and functions of the integrator that contain the markers."""
    blocks = integrator_code().split("\n\n")
    return "\n\n".join(next(block for block in blocks if marker in block) for marker in markers)


def model_code(export_model: ExportModel, prefix: str = "") -> str:
    """Return all functions of the model and the integration step, with a prefix of their names."""
    functions = _print_functions(export_model, export_model.functions, "void", prefix)
    model = export_model.model
    if model.size:
        functions.append(print_step(model.size, len(model.inputs), "void", prefix))
    return _with_prelude(functions)


def static_code(export_model: ExportModel, functions: dict[str, Any]) -> str:
    """Return functions with file scope."""
    return _with_prelude(_print_functions(export_model, functions, "static void", shares_inverses=True))


def _print_functions(
    export_model: ExportModel, functions: dict[str, Any], head: str, prefix: str = "", *, shares_inverses: bool = False
) -> list[str]:
    """Return the C code of functions; comments name the elements of their arguments and results."""
    addresses = {
        name: [comment_text(quantity.address) for quantity in getattr(export_model, name)]
        for name in ("states", "parameters", "memory", "inputs", "outputs")
    }
    labels = {
        "x": addresses["states"], "f": addresses["states"], "p": addresses["parameters"] + addresses["memory"],
        "z": addresses["memory"], "u": addresses["inputs"], "y": addresses["outputs"],
    }  # fmt: skip
    return [
        print_function(f, name, shares_inverses=shares_inverses, labels=labels, head=head, prefix=prefix)
        for name, f in functions.items()
    ]


def _with_prelude(functions: list[str]) -> str:
    code = "\n\n".join(functions)
    return "\n\n".join(filter(None, (used_prelude(code), code)))


def fixed_step_functions(model: Model) -> dict[str, Any]:
    """Return the functions for integration with a fixed step, without the quadratures of the flows."""
    names: tuple[str, ...] = ("rates", "jacobian", "factor", "solve", "outputs", "start", "update")
    n, symbols, expressions = len(model.states), dict(model.symbols), dict(model.expressions)
    symbols["x"], expressions["rates"] = symbols["x"][:n], expressions["rates"][:n]
    expressions["start"] = expressions["start"][:n]
    # No function depends on the quadratures.
    functions = traced_functions(replace(model, n_quadratures=0, symbols=symbols, expressions=expressions))
    names = names if model.states else ("outputs", "start", "update")
    return {name: functions[name] for name in names if name in functions and name in SIGNATURES}
