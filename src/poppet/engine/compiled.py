"""Compile printed functions with LLVM and hand out their addresses."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from poppet.engine.object_cache import object_code
from poppet.engine.printers.llvm import PRELUDE, print_function


class CompiledFunctions(NamedTuple):
    """Machine code: the address of each function by name, and the LLVM engine that owns the code while it lives."""

    addresses: Mapping[str, int]
    owner: Any


class LaneFunctions(NamedTuple):
    """Machine code for lanes: addresses, who owns the code, and the elements that `derived` puts behind p."""

    addresses: Mapping[str, int]
    owner: Any
    n_derived: int


def _target_machine() -> Any:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=2, jit=True
    )


def compile_functions(functions: Mapping[str, Any], *, more: str = "", fuses: bool = True) -> CompiledFunctions:
    """Compile traced functions, and `more` text of functions that may call them.

    Where it `fuses`, a processor that multiplies and adds at once may do so, with one rounding in place of two.
    """
    text = PRELUDE + "\n".join(print_function(function, name) for name, function in functions.items()) + more
    text = text if fuses else _rounding_twice(text)
    # What `more` defines is to be found as well, and its printer is the one who knows what that is.
    names = *functions, *re.findall(r"^define void @(\w+)\(", more, re.MULTILINE)
    return load(object_code(text, optimised_object), names)


def _rounding_twice(text: str) -> str:
    """The same text with nothing in it that a processor may fuse."""
    declared = re.compile(r"^declare double @llvm\.fmuladd\.f64\(.*\)$", re.MULTILINE)
    text = declared.sub(
        "define internal double @twice_rounded(double %a, double %b, double %c) alwaysinline {\n"
        "  %m = fmul double %a, %b\n  %s = fadd double %m, %c\n  ret double %s\n}",
        text.replace(" contract ", " "),
    )
    return text.replace("@llvm.fmuladd.f64", "@twice_rounded")


def load(code: bytes, names: Iterable[str]) -> CompiledFunctions:
    """Load object code into this process."""
    import llvmlite.binding as llvm

    # An empty module: MCJIT is used as a linker of object code that is there already.
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _target_machine())
    engine.add_object_file(llvm.object_file.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return CompiledFunctions({name: engine.get_function_address(name) for name in names}, engine)


def optimised_object(text: str) -> bytes:
    """Object code of LLVM IR."""
    import llvmlite.binding as llvm

    machine = _target_machine()
    module = llvm.parse_assembly(text)
    # The text names no triple, so that it is the same on all machines; LLVM refuses to mix.
    module.triple = machine.triple
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    # Most of what makes the loops of a step fast.
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))


class PrebuiltIntegrator(NamedTuple):
    """An integrator as LLVM IR, and what `tools/make_integrator.py` makes it from."""

    text: str  # file
    sources: tuple[str, ...]
    maker: str  # module and function that make the text
    entry: str

    def mark(self) -> str:
        """First line of the text: the source that it was made from."""
        source = b"".join(Path(__file__).with_name(name).read_bytes().replace(b"\r\n", b"\n") for name in self.sources)
        return f"made from {', '.join(self.sources)}, sha256 {hashlib.sha256(source).hexdigest()}"

    def printed(self) -> str:
        """LLVM IR of the present source, by numba."""
        module, name = self.maker.rsplit(".", 1)
        text: str = getattr(import_module(module), name)()
        return text

    def read(self) -> str:
        """LLVM IR of the integrator."""
        path = Path(__file__).with_name(self.text)
        if path.exists():
            first, _, text = path.read_text(encoding="utf-8").partition("\n")
            if first == f"; {self.mark()}":
                return text
        # Numba takes seconds; only where somebody works on the source.
        return self.printed()

    def compiled(self) -> Any:
        """The integrator, a function of the address of its row of fields."""
        return as_function(load(object_code(self.read(), optimised_object), [self.entry]))


_SOURCES = ("integrator.py", "stepping.py", "job.py", "rosenbrock.py")
INTEGRATOR = PrebuiltIntegrator("integrator.ll", _SOURCES, "poppet.engine.integrator.integrator_text", "integrate")
LANES = PrebuiltIntegrator("lanes.ll", ("lanes.py", *_SOURCES), "poppet.engine.lanes.lanes_text", "integrate_lanes")


@lru_cache(maxsize=1)
def integrator() -> Any:
    """`poppet.engine.integrator.integrate`, a function of a `Job`'s address."""
    return INTEGRATOR.compiled()


@lru_cache(maxsize=1)
def lane_integrator() -> Any:
    """`poppet.engine.lanes.integrate_lanes`, a function of a `LaneJob`'s address."""
    return LANES.compiled()


def as_function(compiled: CompiledFunctions) -> Any:
    """An integrator in this process."""
    import ctypes

    # CFUNCTYPE, unlike PYFUNCTYPE, releases the interpreter's lock: `Call` watches the run from another thread.
    function: Any = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p)(next(iter(compiled.addresses.values())))
    function.owner = compiled.owner  # the code lives as long as this does
    return function
