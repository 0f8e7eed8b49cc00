"""The traced functions of a model as C, with the names of its states, numbers and outputs beside them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Any

from poppet.deploy.export_files import plain
from poppet.deploy.export_model import ExportModel
from poppet.engine.model import Model
from poppet.engine.printers.c import print_function, print_step, used_prelude
from poppet.engine.printers.instructions import SIGNATURES, trace_functions


@cache
def integrator_text(name: str = "integrate") -> str:
    """The adaptive integrator, ``int64_t integrate(const int64_t *fields)``, under some name."""
    text = files("poppet.engine").joinpath("integrator.c").read_text(encoding="utf-8")
    head = "int64_t integrate(const int64_t *fields)"
    assert head in text
    return text.replace(head, f"{head};\n{head}").replace("integrate(const", f"{name}(const")


def integrator_pieces(*heads: str) -> str:
    """Some of its types and functions alone, by how they begin or end."""
    pieces = integrator_text().split("\n\n")
    return "\n\n".join(next(piece for piece in pieces if head in piece) for head in heads)


def model_text(carried: ExportModel, prefix: str = "", head: str = "void") -> str:
    """All functions of the model, and the step of the kernel: without a prefix under the names of the kernel."""
    texts = [*_printed(carried, carried.functions, prefix, head)]
    if carried.model.size:
        texts.append(print_step(carried.model.size, len(carried.model.inputs), head, prefix))
    return _with_prelude(texts)


def lean_text(carried: ExportModel, functions: dict[str, Any]) -> str:
    """Functions that are seen in their file alone."""
    return _with_prelude(_printed(carried, functions, "", "static void", shares_inverses=True))


def _printed(
    carried: ExportModel, functions: dict[str, Any], prefix: str, head: str, *, shares_inverses: bool = False
) -> list[str]:
    style: dict[str, Any] = {"labels": labels(carried), "head": head, "prefix": prefix}
    return [print_function(f, name, shares_inverses=shares_inverses, **style) for name, f in functions.items()]


def _with_prelude(texts: list[str]) -> str:
    body = "\n\n".join(texts)
    return "\n\n".join(part for part in (used_prelude(body), body) if part)


def labels(carried: ExportModel) -> dict[str, list[str]]:
    """What the elements of arguments and results are, for comments."""
    states, numbers = [plain(s.address) for s in carried.states], [plain(n.address) for n in carried.numbers]
    memory = [plain(z.address) for z in carried.memory]
    found = {"x": states, "f": states, "p": numbers + memory, "z": memory}
    return found | {"u": [plain(i.address) for i in carried.inputs], "y": [plain(y.address) for y in carried.outputs]}


def without_integrals(model: Model) -> Model:
    """The model without the integrals of its flows, on which nothing depends."""
    n, symbols, expressions = len(model.states), dict(model.symbols), dict(model.expressions)
    symbols["x"], expressions["rates"] = symbols["x"][:n], expressions["rates"][:n]
    expressions["start"] = expressions["start"][:n]
    return replace(model, n_quadratures=0, symbols=symbols, expressions=expressions)


def lean_functions(model: Model) -> dict[str, Any]:
    """The functions that a fixed step needs, of the states alone."""
    wanted = ("rates", "jacobian", "factor", "solve", "outputs", "start", "update")
    functions = trace_functions(without_integrals(model))
    names = wanted if model.states else ("outputs", "start", "update")
    return {name: functions[name] for name in names if name in functions and name in SIGNATURES}
