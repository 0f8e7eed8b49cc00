"""Binaries of an FMU: the very kernel as an object for each platform, and C around it, linked into one library."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from poppet.core.errors import InputError
from poppet.deploy.export_model import ExportModel
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.printers.llvm import PRELUDE, print_function
from poppet.engine.printers.llvm_step import print_step


class Platform(NamedTuple):
    """Where an FMU runs."""

    triple: str  # of LLVM
    target: str  # of Zig
    cpu: str
    suffix: str
    folders: tuple[str, str]  # under `binaries` in FMI 2.0 and 3.0


PLATFORMS = {
    # An old library of C, so that old systems can load what is linked against it.
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


def kernel_text(carried: ExportModel, more: Mapping[str, Any]) -> str:
    """LLVM IR of the functions of a model, `more` traced ones among them."""
    functions = {name: f for name, f in carried.functions.items() if name != "energy"} | dict(more)
    model = carried.model
    if not model.size:
        functions = {name: functions[name] for name in functions if name not in ("jacobian", "factor", "solve")}
    step = print_step(model.size, len(model.states), len(model.inputs)) if model.size else ""
    return PRELUDE + "\n".join(print_function(function, name) for name, function in functions.items()) + step


def kernel_object(text: str, platform: Platform) -> bytes:
    """Object code of the functions of a model and of the integrator, none of which a host can see."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(platform.triple).create_target_machine(
        cpu=platform.cpu, opt=2, reloc="pic", codemodel="default"
    )
    module = llvm.parse_assembly(text)
    module.link_in(llvm.parse_assembly(INTEGRATOR.read()))
    # Of the library of C there is a `step` too, and hosts may have anything: nobody else is to see these names.
    for function in module.functions:
        if not function.is_declaration and function.linkage == llvm.Linkage.external:
            function.name, function.visibility = f"model_{function.name}", "hidden"
    module.triple, module.data_layout = platform.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(machine.emit_object(module))


def has_zig() -> bool:
    """True where the extra `fmu` is installed."""
    return importlib.util.find_spec("ziglang") is not None


def compilers(platform: str) -> list[list[str]]:
    """Commands that link for a platform, the best one first."""
    found = []
    if has_zig():
        found.append([sys.executable, "-m", "ziglang", "cc", "-target", PLATFORMS[platform].target])
    host = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if platform == "linux64" and sys.platform == "linux" and os.uname().machine == "x86_64" and host:
        found.append([host, "-fPIC"])
    return found


def linked(text: str, sources: Mapping[str, str], platform: str, main: str) -> bytes:
    """The library of an FMU for a platform; `main` is the source that includes the others."""
    place = PLATFORMS[platform]
    command = compilers(platform)[0]
    with tempfile.TemporaryDirectory() as folder:
        for name, source in sources.items():
            Path(folder, name).write_text(source, encoding="utf-8")
        Path(folder, "kernel.o").write_bytes(kernel_object(text, place))
        _run([*command, *FLAGS, "-I.", "-o", f"model{place.suffix}", main, "kernel.o", "-lm"], folder)
        return Path(folder, f"model{place.suffix}").read_bytes()


def _run(command: Sequence[str], folder: str) -> None:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise InputError("deploy.fmu.not_linked", command=command[0], said=done.stderr[-2000:])
