"""Compile printed functions with LLVM and hand out their addresses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.engine.printer_llvm import prelude, print_function


@dataclass(frozen=True)
class CompiledFunctions:
    """Machine code of a set of traced functions.

    Parameters
    ----------
    addresses : dict
        Name of each function to its address in this process.
    owner : object
        The LLVM engine that owns the code; the addresses live as long as it does.
    """

    addresses: Mapping[str, int]
    owner: Any


def _target_machine() -> Any:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=2, jit=True
    )


def compile_functions(functions: Mapping[str, Any], *, more: str = "", names: tuple[str, ...] = ()) -> CompiledFunctions:
    """Compile traced functions.

    Parameters
    ----------
    functions : dict
        Name to SX `casadi.Function`.
    more : str, optional
        LLVM IR of further functions that may call them.
    names : tuple of str, optional
        Names of those.

    Returns
    -------
    CompiledFunctions
        Addresses of functions that take one pointer to doubles per input and output.
    """
    import llvmlite.binding as llvm

    machine = _target_machine()
    text = prelude() + "\n".join(print_function(function, name) for name, function in functions.items())
    text += more
    module = llvm.parse_assembly(text)
    module.triple = machine.triple
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    addresses = {name: engine.get_function_address(name) for name in (*functions, *names)}
    return CompiledFunctions(addresses, engine)
