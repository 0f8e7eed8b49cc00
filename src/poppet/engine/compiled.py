"""Compilation of LLVM IR to machine code, and the compiled integrators."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.engine.object_cache import object_code, stored_code
from poppet.engine.printers.llvm import PRELUDE, print_function

if TYPE_CHECKING:
    import llvmlite.binding

CALLED = ("jacobian", "step", "dense", "outputs", "update")
"""Functions of a model that the integrator calls, the first fields of `poppet.engine.job.Job`."""


class CompiledFunctions(NamedTuple):
    """Machine code of several functions.

    `addresses` maps the names of the functions to memory addresses. `owner` is the LLVM engine, which must exist while
    the functions are used.
    """

    addresses: Mapping[str, int]
    owner: Any
    # Of code without optimisation: addresses of variables with the addresses of the functions that are called instead.
    switches: Mapping[str, int] = {}


class LaneFunctions(NamedTuple):
    """Machine code of functions for lanes (runs that are computed simultaneously).

    `addresses` maps names to memory addresses, and `owner` is the LLVM engine. The function `derived` appends
    `n_derived` elements to the parameter vector p.
    """

    addresses: Mapping[str, int]
    owner: Any
    n_derived: int


def _target_machine(opt: int = 2) -> llvmlite.binding.TargetMachine:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=opt, jit=True
    )


def compile_functions(
    functions: Mapping[str, Any], *, further_text: str = "", fuses: bool = True, optimises: bool = True
) -> CompiledFunctions:
    """Compile traced functions to machine code.

    The keyword `further_text` is LLVM IR of additional functions, which can call the traced functions. If the keyword
    `fuses` is True, the processor can use fused multiply-add operations, which round once instead of twice. If the
    keyword `optimises` is False, and the cache on disk has no optimised code, the code is compiled without
    optimisation. The results of both are equal if no operations are fused.
    """
    text = PRELUDE + "\n".join(print_function(function, name) for name, function in functions.items()) + further_text
    if not fuses:
        declared = re.compile(r"^declare double @llvm\.fmuladd\.f64\(.*\)$", re.MULTILINE)
        text = declared.sub(
            "define internal double @twice_rounded(double %a, double %b, double %c) alwaysinline {\n"
            "  %m = fmul double %a, %b\n  %s = fadd double %m, %c\n  ret double %s\n}",
            text.replace(" contract ", " "),
        ).replace("@llvm.fmuladd.f64", "@twice_rounded")
    # Functions of `more` are found by their definitions.
    names = *functions, *re.findall(r"^define void @(\w+)\(", further_text, re.MULTILINE)
    if optimises:
        return load(object_code(text, optimised_object), names)
    code = stored_code(text)
    return _load_quick(text, names) if code is None else load(code, names)


def _load_quick(text: str, names: Iterable[str]) -> CompiledFunctions:
    """Compile LLVM IR without optimisation, and load it into this process.

    The integrator calls these functions by variables, so other code can replace them at any time, also during a run.
    """
    pattern = rf"^define void @({'|'.join(CALLED)})\((.*)\) nounwind {{$"
    for name, formal in re.findall(pattern, text, re.MULTILINE):
        arguments = ", ".join(f"ptr %a{k}" for k in range(formal.count("ptr ")))
        text += (
            f"@switch_{name} = global ptr @{name}\n"
            f"define void @enter_{name}({arguments}) nounwind {{\n"
            f"  %f = load volatile ptr, ptr @switch_{name}\n"
            f"  tail call void %f({arguments})\n  ret void\n}}\n"
        )
    called = [name for name in CALLED if f"@switch_{name} =" in text]
    code = load(_quick_object(text), [*names, *(f"{kind}_{name}" for kind in ("enter", "switch") for name in called)])
    entries = {name: code.addresses[f"enter_{name}"] for name in called}
    switches = {name: code.addresses[f"switch_{name}"] for name in called}
    return code._replace(addresses={**code.addresses, **entries}, switches=switches)


def load(code: bytes, names: Iterable[str]) -> CompiledFunctions:
    """Load object code into this process, and return the memory addresses of the functions `names`."""
    import llvmlite.binding as llvm

    # An empty module: MCJIT only links the object code.
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _target_machine())
    engine.add_object_file(llvm.object_file.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return CompiledFunctions({name: engine.get_function_address(name) for name in names}, engine)


def optimised_object(text: str) -> bytes:
    """Compile LLVM IR with optimisation to object code, and return the code."""
    # Vectorisation contributes most to the speed of the loops of a step.
    return _object(text, _target_machine(), speed_level=2, loop_vectorization=True)


def _quick_object(text: str) -> bytes:
    """Compile LLVM IR without optimisation to object code: twenty times faster for code with half the speed."""
    return _object(text, _target_machine(opt=0), speed_level=0, loop_vectorization=False)


def _object(text: str, machine: Any, *, speed_level: int, loop_vectorization: bool) -> bytes:
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(text)
    # The text has no target triple because it is equal on all machines; LLVM requires one triple.
    module.triple = machine.triple
    options = llvm.create_pipeline_tuning_options(speed_level=speed_level)
    options.loop_vectorization = loop_vectorization
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))


class PrebuiltIntegrator(NamedTuple):
    """Integrator that is stored in a file of LLVM IR (intermediate code).

    `tools/make_integrator.py` writes the file. It is valid only if its first line identifies the present source files.
    """

    text: str  # file
    sources: tuple[str, ...]
    maker: str  # module and function that make the text
    entry: str

    def mark(self) -> str:
        """Return the first line of the file, with the names and a hash of the source files."""
        source = b"".join(Path(__file__).with_name(name).read_bytes().replace(b"\r\n", b"\n") for name in self.sources)
        return f"made from {', '.join(self.sources)}, sha256 {hashlib.sha256(source).hexdigest()}"

    def printed(self) -> str:
        """Return the LLVM IR of the integrator as text, which Numba generates from the source files."""
        module, name = self.maker.rsplit(".", 1)
        text: str = getattr(import_module(module), name)()
        return text

    def read(self) -> str:
        """Return the LLVM IR of the integrator.

        It is read from the file if the source files are unchanged. Otherwise it is generated.
        """
        path = Path(__file__).with_name(self.text)
        if path.exists():
            first, _, text = path.read_text(encoding="utf-8").partition("\n")
            if first == f"; {self.mark()}":
                return text
        # Numba takes seconds; only after a change of the sources.
        return self.printed()

    def compiled(self) -> Callable[[int], int]:
        """Return the integrator as a function of one address.

        This is the address of a `Job` or of a `LaneJob`, the arguments of the integrator.
        """
        return as_function(load(object_code(self.read(), optimised_object), [self.entry]))


_SOURCES = ("integrator.py", "stepping.py", "job.py", "rosenbrock.py")
INTEGRATOR = PrebuiltIntegrator("integrator.ll", _SOURCES, "poppet.engine.integrator.integrator_text", "integrate")
LANES = PrebuiltIntegrator("lanes.ll", ("lanes.py", *_SOURCES), "poppet.engine.lanes.lanes_text", "integrate_lanes")
ESTIMATOR = PrebuiltIntegrator(
    "estimator.ll",
    ("estimator.py", "estimator_job.py", *_SOURCES),
    "poppet.engine.estimator.estimator_text",
    "estimate",
)


@lru_cache(maxsize=1)
def integrator() -> Callable[[int], int]:
    """Return the compiled integrator of single runs.

    It is `poppet.engine.integrator.integrate`, a function of the address of a `Job`.
    """
    return INTEGRATOR.compiled()


@lru_cache(maxsize=1)
def lane_integrator() -> Callable[[int], int]:
    """Return the compiled integrator that computes several runs simultaneously.

    It is `poppet.engine.lanes.integrate_lanes`, a function of the address of a `LaneJob`. Each of the simultaneous runs
    is called a lane.
    """
    return LANES.compiled()


@lru_cache(maxsize=1)
def estimator() -> Callable[[int], int]:
    """Return the compiled estimator.

    It is `poppet.engine.estimator.estimate`, a function of the address of an `EstimatorJob`.
    """
    return ESTIMATOR.compiled()


def as_function(compiled: CompiledFunctions) -> Callable[[int], int]:
    """Return the first of several compiled functions as a Python function.

    The Python function takes a memory address and returns an integer.
    """
    import ctypes

    # CFUNCTYPE releases the interpreter lock, unlike PYFUNCTYPE: `Call` runs it in another thread.
    function = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p)(next(iter(compiled.addresses.values())))
    function.owner = compiled.owner  # type: ignore[attr-defined]  # keeps the code
    return function
