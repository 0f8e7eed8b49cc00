"""A circuit's kernel and the integrator as one WebAssembly module."""

from __future__ import annotations

from typing import Any

from poppet.deploy.live.linker import LinkError, Module, link
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.model import Model
from poppet.engine.printers.instructions import trace_functions
from poppet.engine.printers.llvm import OF_ONE, OF_TWO, PRELUDE, print_function
from poppet.engine.printers.llvm_step import print_step

CALLED = ("jacobian", "step", "dense", "outputs", "update")
"""Functions that the integrator is handed by their places in the table."""
GIVEN = (*OF_ONE, *OF_TWO, "exp2", "log2", "exp10")
"""Functions that a page has of its own; LLVM makes the last ones of powers and logarithms."""
_FEATURES = "+simd128,+bulk-memory,+bulk-memory-opt"
_OWN_STACK = 65536


def live_module(model: Model) -> Module:
    """The module of a model, which exports `integrate`, `start` and its memory."""
    import llvmlite.binding as llvm

    functions = trace_functions(model)
    text = PRELUDE + "\n".join(print_function(function, name) for name, function in functions.items())
    if model.size:
        text += print_step(model.size, len(model.states), len(model.inputs))
    whole = llvm.parse_assembly(INTEGRATOR.read())
    whole.link_in(llvm.parse_assembly(text))
    defined = {each.name for each in whole.functions if not each.is_declaration}
    tabled, exports = [name for name in CALLED if name in defined], ("integrate", "start")
    for each in whole.functions:
        if not each.is_declaration and each.name not in (*tabled, *exports):
            each.linkage = "internal"  # what nobody calls is left out
    # Slots of a long function lie on the stack, and so do those of the functions that call it.
    stack = _OWN_STACK + 8 * sum(function.sz_w() for function in functions.values())
    module = link(wasm_object(whole), exports, tabled, stack=stack)
    unknown = set(module.imports) - set(GIVEN)
    if unknown:
        raise LinkError(f"a page has no {', '.join(sorted(unknown))}")
    return module


def wasm_object(module: Any) -> bytes:
    """A relocatable WebAssembly object of a module of LLVM, optimised."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple("wasm32-unknown-unknown").create_target_machine(features=_FEATURES, opt=2)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))
