"""Binaries of an FMU for each platform.

Each library contains the kernel as object code and the C code for the FMI functions.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.errors import InputError
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.printers.llvm import PRELUDE, print_function
from poppet.engine.printers.llvm_step import print_step

if TYPE_CHECKING:
    import casadi

    from poppet.engine.model import Model


class Platform(NamedTuple):
    """Operating system and processor for which a binary is compiled."""

    triple: str  # of LLVM
    target: str  # of Zig
    cpu: str
    suffix: str
    folders: tuple[str, str]  # under `binaries` in FMI 2.0 and 3.0


PLATFORMS = {
    # An old C library, so that old systems can load the binary.
    "linux64": Platform(
        "x86_64-unknown-linux-gnu", "x86_64-linux-gnu.2.17", "x86-64", ".so", ("linux64", "x86_64-linux")
    ),
    "win64": Platform("x86_64-pc-windows-gnu", "x86_64-windows-gnu", "x86-64", ".dll", ("win64", "x86_64-windows")),
    "darwin64": Platform("x86_64-apple-macosx11.0", "x86_64-macos", "x86-64", ".dylib", ("darwin64", "x86_64-darwin")),
    "aarch64-darwin": Platform(
        "arm64-apple-macosx11.0", "aarch64-macos", "apple-m1", ".dylib", ("aarch64-darwin", "aarch64-darwin")
    ),
}
FLAGS = ("-shared", "-O2", "-std=c99", "-ffp-contract=off", "-fvisibility=hidden", "-g0", "-s")


def kernel_code(model: Model, functions: Mapping[str, casadi.Function]) -> str:
    """Return the model functions and the integration step as LLVM IR.

    LLVM IR is the intermediate code of the compiler LLVM. `functions` maps names to functions.
    """
    step = print_step(model.size, len(model.states), len(model.inputs)) if model.size else ""
    return PRELUDE + "\n".join(print_function(function, name) for name, function in functions.items()) + step


def compile_object(module: Any, triple: str, **settings: Any) -> bytes:
    """Compile an LLVM module to optimised object code for one platform.

    `triple` is the LLVM name of the platform. The keyword arguments are arguments of
    `llvmlite.binding.Target.create_target_machine`.
    """
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(triple).create_target_machine(opt=2, **settings)
    module.triple, module.data_layout = triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))


def has_zig() -> bool:
    """Return True if the Zig compiler of the extra `fmu` is installed."""
    return importlib.util.find_spec("ziglang") is not None


def link_commands(platform: str) -> list[list[str]]:
    """Return the available linker commands for a platform, in the order of preference.

    A command is a list of arguments.
    """
    commands = []
    if has_zig():
        commands.append([sys.executable, "-m", "ziglang", "cc", "-target", PLATFORMS[platform].target])
    host = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if platform == "linux64" and sys.platform == "linux" and os.uname().machine == "x86_64" and host:
        commands.append([host, "-fPIC"])
    return commands


def link_library(code: str, sources: Mapping[str, str], platform_name: str, main: str) -> bytes:
    """Return the binary (shared library) of an FMU for one platform.

    `code` is the LLVM IR of the model. `sources` maps names to the C sources, and `main` is the name of the source that
    includes all others.
    """
    import llvmlite.binding as llvm

    platform = PLATFORMS[platform_name]
    module = llvm.parse_assembly(code)
    module.link_in(llvm.parse_assembly(INTEGRATOR.read()))
    # The C library has a `step` too, and importers have other names: hidden symbols cannot collide.
    for function in module.functions:
        if not function.is_declaration and function.linkage == llvm.Linkage.external:
            function.name, function.visibility = f"model_{function.name}", "hidden"
    kernel = compile_object(module, platform.triple, cpu=platform.cpu, reloc="pic", codemodel="default")
    return link_files({**sources, "kernel.o": kernel}, platform_name, (main, "kernel.o"))


def link_files(files: Mapping[str, str | bytes], platform_name: str, linked: Sequence[str]) -> bytes:
    """Return the binary (shared library) of some C sources and object files for one platform.

    `files` maps names to contents, and `linked` are the names of the files that are compiled and linked.
    """
    library = f"model{PLATFORMS[platform_name].suffix}"
    command = [*link_commands(platform_name)[0], *FLAGS, "-I.", "-o", library, *linked, "-lm"]
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            Path(folder, name).write_bytes(content.encode() if isinstance(content, str) else content)
        result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if result.returncode:
            raise InputError("deploy.fmu.not_linked", command=command[0], said=result.stderr[-2000:])
        return Path(folder, library).read_bytes()
