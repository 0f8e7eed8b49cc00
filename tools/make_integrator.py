"""Make `src/poppet/engine/integrator.ll` from `integrator.py`; run it after every change of that file.

Numba compiles for a generic processor and leaves vectors to the machine that will run the code. What only newer LLVM
versions can read (hints, not meaning) is taken out, so that the text serves every llvmlite with opaque pointers.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

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
    import llvmlite.binding as llvm

    from poppet.engine import integrator
    from poppet.engine.compiled import INTEGRATOR_TEXT, source_mark

    module = llvm.parse_assembly(integrator.integrator_text())
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
    text = re.sub(r"\n{2,}", "\n", text).strip()
    llvm.parse_assembly(text)
    folder = Path(integrator.__file__).parent
    (folder / INTEGRATOR_TEXT).write_text(f"; {source_mark()}\n{text}\n", encoding="utf-8")
    print(f"{INTEGRATOR_TEXT}: {len(text.splitlines())} lines", file=sys.stderr)


if __name__ == "__main__":
    main()
