"""Tests that C code and kernel give the same bits if both use the same operations.

That is without fused multiplications and additions: compilers choose for themselves which ones they fuse. With them the
results differ by rounding, and where a run is sensitive to that by what its tolerance allows.
"""

from __future__ import annotations

import ctypes
import importlib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c_compiler import shared_library
from circuits_of_exports import EVERYDAY, TEN
from poppet import Circuit
from poppet.deploy.c.c_model import integrator_code, model_code
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.engine import call, compiled
from poppet.engine.compiled import CompiledFunctions, as_function
from poppet.engine.kernel import compile_kernel
from poppet.engine.problem import Problem

NAMES = ("rates", "jacobian", "factor", "solve", "outputs", "start", "energy", "update", "step", "dense")


def in_c(export_model: ExportModel, folder: Path, *options: str) -> tuple[Problem, Any]:
    """The problem with the functions of C, and the integrator in C."""
    sources = {"model.c": f"#include <math.h>\n\n{model_code(export_model)}\n", "integrator.c": integrator_code()}
    library = shared_library(sources, folder, *options)
    functions = {name: getattr(library, name, None) for name in NAMES}
    addresses = {name: ctypes.cast(f, ctypes.c_void_p).value or 0 for name, f in functions.items() if f is not None}
    kernel = replace(export_model.problem.kernel, functions=CompiledFunctions(addresses, library))
    entry = ctypes.cast(library.integrate, ctypes.c_void_p).value or 0
    return replace(export_model.problem, kernel=kernel), as_function(CompiledFunctions({"integrate": entry}, library))


def without_fused(circuit: Circuit) -> tuple[Problem, Any]:
    """The problem whose functions fuse nothing, and the integrator, in which nothing may be fused anyway."""
    problem = circuit.problem(circuit.run)
    return replace(problem, kernel=compile_kernel(circuit.model, fuses=False)), compiled.integrator()


def run(problem: Problem, function: Any, monkeypatch: pytest.MonkeyPatch) -> tuple[Any, np.ndarray, list[int]]:
    monkeypatch.setattr(call, "integrator", lambda: function)
    kernel_call = call.Call(problem)
    outcome = kernel_call.repeat()
    return outcome, kernel_call.table, kernel_call.counts[:4].tolist()


@pytest.mark.parametrize("name", EVERYDAY)
def test_exported_c_equals_the_kernel_in_every_bit(name, tmp_path, monkeypatch):
    circuit = TEN[name]()
    mine = run(*in_c(build_export_model(circuit), tmp_path), monkeypatch)
    theirs = run(*without_fused(circuit), monkeypatch)
    assert mine[0] is theirs[0] is call.Outcome.DONE
    assert mine[2] == theirs[2]
    assert np.array_equal(mine[1], theirs[1])
    assert np.isfinite(mine[1]).all()


@pytest.mark.parametrize("name", [name for name in TEN if name not in EVERYDAY])
def test_exported_c_of_ten_circuits_equals_the_kernel(name, tmp_path, monkeypatch):
    test_exported_c_equals_the_kernel_in_every_bit(name, tmp_path, monkeypatch)


@pytest.mark.parametrize("name", ["INTEGRATOR", "ESTIMATOR"])
def test_the_integrator_in_c_is_made_from_the_present_source(name, monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).parents[3] / "tools"))
    translator, made = importlib.import_module("integrator_c"), getattr(compiled, name)
    translated = translator.integrator_c(getattr(translator, name))
    shipped = Path(compiled.__file__).with_name(made.text).with_suffix(".c").read_text(encoding="utf-8")
    # Comments of the sources are no part of the text, but of their mark.
    assert shipped == f"/* {made.mark()} */\n{translated}\n", "run `make integrator`"
