"""Kernel of a live page: one WebAssembly module with the model and the integrator, and the arrays of a run.

The browser fills the same fields as `poppet.engine.job.Job`, with addresses in the memory of the module.

A page of the editor gets a new model whenever a wire changes. Its model is a module of its own, printed without LLVM,
because browsers optimise as well; the integrator, which is equal for all models, is another module. The memory begins
with the stack, so an overflow causes a trap; then come the data of the integrator and of a run.
"""

from __future__ import annotations

import base64
import json
import re
import subprocess
import zlib
from collections.abc import Mapping, Sequence
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.deploy.fmu.binaries import compile_object, kernel_code
from poppet.deploy.live.linker import LinkError, Module, link
from poppet.deploy.live.parameter_map import ParameterMap
from poppet.deploy.live.wasm_format import PAGE
from poppet.deploy.live.wasm_printer import print_module
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.job import Job
from poppet.engine.model import Model
from poppet.engine.printers.instructions import trace_functions
from poppet.engine.printers.llvm import OF_ONE, OF_TWO
from poppet.engine.problem import Problem

if TYPE_CHECKING:
    import casadi

CALLED = ("jacobian", "step", "dense", "outputs", "update")
"""Functions that the integrator calls by their index in the table."""
PAGE_FUNCTIONS = (*OF_ONE, *OF_TWO, "exp2", "log2", "exp10")
"""Functions that the page provides. LLVM replaces some powers and logarithms by calls of the last ones."""
SHARED_STACK = 1 << 20
"""Size of the stack that a model shares with the integrator [B]."""
SHARED_DATA = SHARED_STACK + 256
"""Address of the data of a run, after those of the integrator."""
_FEATURES = "+simd128,+bulk-memory,+bulk-memory-opt"
_TRIPLE = "wasm32-unknown-unknown"
_STACK_SIZE = 65536
_ALIGNMENT = 8
_MAIN = """
const fs = require("fs");
(async () => {
  const kernel = await Kernel.of(await unpacked(fs.readFileSync(0, "utf8")));
  const values = JSON.parse(process.argv[3]), changes = values.length ? kernel.changes(values) : [];
  kernel.run(...changes);
  // The second run finds its code compiled.
  const begin = performance.now();
  const ended = kernel.run(...changes);
  const seconds = 1e-3 * (performance.now() - begin);
  fs.writeFileSync(process.argv[2], Buffer.from(kernel.table.buffer, kernel.table.byteOffset, kernel.table.byteLength));
  console.log(JSON.stringify({ ...ended, seconds }));
})();
"""


def live_module(model: Model, mapping: ParameterMap | None = None) -> Module:
    """Return the WebAssembly module that simulates a model.

    It exports its memory and the functions `integrate` and `start`. If sliders change parameters, as `mapping`
    describes, it also exports the function `mapped`.
    """
    import llvmlite.binding as llvm

    functions = trace_functions(model)
    if mapping is not None:
        functions["mapped"] = mapping.function
    llvm_module = llvm.parse_assembly(INTEGRATOR.read())
    llvm_module.link_in(llvm.parse_assembly(kernel_code(model, functions)))
    defined = [function for function in llvm_module.functions if not function.is_declaration]
    exports = ("integrate", "start", "mapped")[: 2 + (mapping is not None)]
    tabled = [name for name in CALLED if name in {f.name for f in defined}]
    for function in defined:
        if function.name not in (*tabled, *exports):
            function.linkage = "internal"  # the optimiser removes unused functions
    return _checked(link(compile_wasm_object(llvm_module), exports, tabled, stack=_stack_of(functions)))


def model_module(model: Model, functions: Mapping[str, casadi.Function]) -> Module:
    """Return the WebAssembly module of a model alone, printed without LLVM.

    `functions` contains the functions of the model. The module exports `start`, and shares memory, table and stack
    pointer with the module of the integrator.
    """
    stack = _stack_of(functions)
    if stack > SHARED_STACK:
        raise LinkError(f"a stack of {stack} bytes")
    needed = {name: function for name, function in functions.items() if name != "energy"}
    sizes = model.size, len(model.states), len(model.inputs)
    code, table = print_module(needed, sizes, ("start",), CALLED, memory=-(-SHARED_DATA // PAGE))
    return Module(code, table, SHARED_DATA, ())


def integrator_module() -> Module:
    """Return the WebAssembly module of the integrator alone, which exports `integrate`."""
    import llvmlite.binding as llvm

    llvm_module = llvm.parse_assembly(INTEGRATOR.read())
    module = link(compile_wasm_object(llvm_module), (INTEGRATOR.entry,), (), stack=SHARED_STACK, data=SHARED_STACK)
    if module.heap > SHARED_DATA:
        raise LinkError(f"{module.heap - SHARED_STACK} bytes of data")
    return _checked(module)


def _stack_of(functions: Mapping[str, casadi.Function]) -> int:
    """Return the size of the stack of a model [B]: it contains the slots of a long function and of its callers."""
    return _STACK_SIZE + 8 * sum(function.sz_w() for function in functions.values())


def _checked(module: Module) -> Module:
    missing = set(module.imports) - set(PAGE_FUNCTIONS)
    if missing:
        raise LinkError(f"a page has no {', '.join(sorted(missing))}")
    return module


def compile_wasm_object(llvm_module: Any) -> bytes:
    """Compile an LLVM module to an optimised, relocatable WebAssembly object file."""
    return compile_object(llvm_module, _TRIPLE, features=_FEATURES)


def kernel_script() -> str:
    """Return the script of the kernel for a classic script; the file is a module, which exports its names."""
    text = (files("poppet.deploy.live") / "kernel.js").read_text(encoding="utf-8")
    return re.sub(r"^export \{.*\};\n", "", text, flags=re.MULTILINE)


def run_data(
    problem: Problem, mapping: ParameterMap | None = None, module: Module | None = None
) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Return the data with which a live page simulates a run.

    The result contains a header with array lengths, and the bytes of each array by name. The compiled model is one of
    the arrays. `mapping` contains the effect of sliders on parameters, and `module` the model (default: the result of
    `live_module`).
    """
    kernel, conditions = problem.kernel, problem.stop_conditions
    module = module or live_module(kernel.model, mapping)
    lengths = {name: value for name, value in kernel.job.items() if name.startswith("n_")}
    lengths |= {
        "n_segments": problem.starts.size, "n_courses": len(problem.coefficients), "n_rows": problem.grid.size,
        "n_conditions": len(conditions), "n_script": 0,
    }  # fmt: skip
    limits = np.array([problem.maximum_step, problem.most_attempts, 0.0, problem.relative_tolerance])
    arrays = {
        "scales": kernel.scales, "positive": kernel.positive, "acting": kernel.acting, "p": problem.p,
        "starts": problem.starts, "courses": problem.courses, "coefficients": problem.coefficients,
        "jumps": problem.jumps, "grid": problem.grid, "limits": limits,
        "places": np.array([condition.places for condition in conditions], dtype=np.int64),
        "weights": np.array([condition.weights for condition in conditions], dtype=np.float64),
    }  # fmt: skip
    n = lengths["n_states"]
    # Sizes in doubles, as in `poppet.engine.call.Call`.
    room = {"x": n, "table": lengths["n_outputs"] * problem.grid.size, "books": 3 * n, "watch": 2, "counts": 5}
    header: dict[str, Any] = {
        "fields": Job._fields, "functions": {name: module.table.get(name, 0) for name in CALLED}, "heap": module.heap,
        "lengths": lengths, "room": room | {"memory": kernel.memory_size},
    }  # fmt: skip
    if mapping is not None:
        header["map"] = mapping.header()
        header["room"] |= {"sliders": len(mapping.values), "results": mapping.function.numel_out(0)}
    return header, {"module": module.code, **{name: array.tobytes() for name, array in arrays.items()}}


def pack_base64(header: Mapping[str, Any], blobs: Mapping[str, bytes]) -> str:
    """Return a header and arrays as one compressed base64 text.

    The uncompressed order is: length of the header, header as JSON, arrays.
    """
    places, body = {}, b""
    for name, blob in blobs.items():
        places[name] = [len(body), len(blob)]
        body += blob + bytes(-len(blob) % _ALIGNMENT)
    text = json.dumps({**header, "blobs": places}, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 4) % _ALIGNMENT)
    return base64.b64encode(zlib.compress(len(text).to_bytes(4, "little") + text + body, 9)).decode()


def run_in_node(
    problem: Problem, folder: Path, mapping: ParameterMap | None = None, values: Sequence[float] = ()
) -> tuple[dict[str, Any], NDArray[np.float64]]:
    """Run the WebAssembly model in Node.js, and return the outcome and the outputs.

    The outcome includes the computing time [s], and the outputs have shape (n_outputs, n_times). `values` contains the
    values of the sliders in `mapping`.
    """
    script, table = folder / "run.js", folder / "table.bin"
    script.write_text(kernel_script() + _MAIN, encoding="utf-8")
    command = ["node", str(script), str(table), json.dumps([float(value) for value in values])]
    text = pack_base64(*run_data(problem, mapping))
    result = subprocess.run(command, input=text, capture_output=True, text=True, check=True, timeout=300)
    return json.loads(result.stdout), np.fromfile(table).reshape(-1, problem.grid.size)
