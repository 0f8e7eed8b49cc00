"""Make the files of integrator and estimator in `src/poppet/engine`; run it when their sources have changed.

They are LLVM IR (`integrator.ll`, `lanes.ll`, `estimator.ll`) and C (`integrator.c`, `estimator.c`).

The integrator is also compiled to a WebAssembly module for the page of the editor, `integrator.wasm`.

Numba compiles for a generic processor and leaves vectors to the machine that will run the code. What only newer LLVM
versions can read (hints, not meaning) is taken out, so that the text serves every llvmlite with opaque pointers.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import integrator_c

GENERIC = {
    "NUMBA_OPT": "0",
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_LOOP_VECTORIZE": "0",
    "NUMBA_SLP_VECTORIZE": "0",
    "NUMBA_ENABLE_AVX": "0",
    "NUMBA_DISABLE_INTEL_SVML": "1",
}
HINTS = (
    (r" range\([^)]*\)", ""),
    (r" captures\([^)]*\)", ""),
    (r" initializes\(\(.*?\)\)", ""),
    (r"getelementptr (inbounds )?nuw ", r"getelementptr \1"),
    (r"icmp samesign ", "icmp "),
    (r"\bor disjoint ", "or "),
    (r"(zext|uitofp) nneg ", r"\1 "),
    (r"trunc (?:nuw |nsw )+", "trunc "),
    (r"^attributes #.*$", ""),
    (r"^;.*$", ""),
    (r"^(?:target|source_filename).*$", ""),
    (r" #\d+", ""),
    (r"\s*;.*$", ""),
    (r'!"_ZN[^"]*"', '!"scope"'),
)


def main() -> None:
    os.environ.update(GENERIC)
    from poppet.engine import compiled
    from poppet.engine.compiled import ESTIMATOR, INTEGRATOR, LANES

    for each in (INTEGRATOR, LANES, ESTIMATOR):
        text = portable(each.printed())
        Path(compiled.__file__).with_name(each.text).write_text(f"; {each.mark()}\n{text}\n", encoding="utf-8")
        print(f"{each.text}: {len(text.splitlines())} lines", file=sys.stderr)
    for each, program in ((INTEGRATOR, integrator_c.INTEGRATOR), (ESTIMATOR, integrator_c.ESTIMATOR)):
        text = f"/* {each.mark()} */\n{integrator_c.integrator_c(program)}\n"
        Path(compiled.__file__).with_name(each.text).with_suffix(".c").write_text(text, encoding="utf-8")
    write_page_integrator()


def write_page_integrator() -> None:
    """Write the module of the page, whose last section contains the mark."""
    from poppet.deploy.live.page_kernel import SHARED_STACK, integrator_module
    from poppet.edit import build
    from poppet.engine.compiled import INTEGRATOR

    module = integrator_module().code
    mark = f"{INTEGRATOR.mark()}, stack {SHARED_STACK}".encode()
    section = bytes([4]) + b"mark" + mark
    size = bytes([len(section) & 0x7F | 0x80, len(section) >> 7])
    path = Path(build.__file__).with_name("www") / "integrator.wasm"
    path.write_bytes(module + b"\0" + size + section)
    print(f"{path.name}: {len(module)} bytes", file=sys.stderr)


def portable(printed: str) -> str:
    """The text for a generic processor and every LLVM, its names short."""
    import llvmlite.binding as llvm

    module = llvm.parse_assembly(printed)
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple("x86_64-unknown-linux-gnu").create_target_machine(cpu="generic", opt=2)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    text = str(module)
    for pattern, replacement in HINTS:
        text = re.sub(pattern, replacement, text, flags=re.M)
    names: dict[str, str] = {}
    text = re.sub(
        r"@(?:\"[^\"]*\"|[\w.$]*_Z[\w.$]*|numba[\w.]+)", lambda m: names.setdefault(m.group(), f"@v{len(names)}"), text
    )
    text = re.sub(r"^@v\d+ = common .*$", "", text, flags=re.M)
    # Labels that hold the name of a function may be too long to be read again.
    text = re.sub(r"[\w.$]*_ZN[\w.$]*", lambda m: names.setdefault(m.group(), f"b{len(names)}"), text)
    text = re.sub(r"\n{2,}", "\n", text).strip()
    llvm.parse_assembly(text)
    return text


if __name__ == "__main__":
    main()
