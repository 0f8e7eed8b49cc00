"""Where node is, and a kernel whose arithmetic is that of a browser."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from poppet.circuit.circuit import Circuit
from poppet.engine import call, compiled

needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")


def unfused(circuit: Circuit, monkeypatch: pytest.MonkeyPatch, folder: Path) -> call.Call:
    """A finished run of a kernel without fused multiplications, which WebAssembly has not."""
    import llvmlite.binding as llvm

    features = llvm.get_host_cpu_features()
    fused = [name for name in features if name.startswith(("fma", "avx512"))]
    features.update(dict.fromkeys(fused, False))

    def machine() -> Any:
        target = llvm.Target.from_default_triple()
        return target.create_target_machine(features=features.flatten(), opt=2, jit=True)

    problem = circuit.problem(circuit.run)
    with monkeypatch.context() as changed:
        changed.setenv("POPPET_CACHE_DIR", str(folder))
        changed.setattr(compiled, "_target_machine", machine)
        kernel, integrator = circuit._compiled(), compiled.INTEGRATOR.compiled()
        changed.setattr(call, "integrator", lambda: integrator)
        p = problem.p.copy()
        own = call.Call(replace(problem, kernel=kernel, x0=kernel.start(p), p=p))
        own.outcome = own.again()
    return own
