"""What a page's kernel computes, run by node; and a kernel whose arithmetic is that of a browser."""

from __future__ import annotations

import json
import shutil
import subprocess
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet.circuit.circuit import Circuit
from poppet.deploy.live.packed import packed, run_blobs
from poppet.engine import call, compiled
from poppet.engine.problem import Problem

MAIN = """
const fs = require("fs");
(async () => {
  const kernel = await Kernel.of(await unpacked(fs.readFileSync(0, "utf8")));
  const ended = kernel.run(...JSON.parse(process.argv[3] ?? "[]"));
  fs.writeFileSync(process.argv[2], Buffer.from(kernel.table.buffer, kernel.table.byteOffset, kernel.table.byteLength));
  console.log(JSON.stringify(ended));
})();
"""
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")


def run_in_node(problem: Problem, folder: Path, *numbers: Any) -> tuple[dict[str, Any], np.ndarray]:
    """How a run ended, and its table; `numbers` are places in p and values."""
    script, table = folder / "run.js", folder / "table.bin"
    script.write_text((files("poppet.deploy.live") / "kernel.js").read_text(encoding="utf-8") + MAIN, encoding="utf-8")
    command = ["node", str(script), str(table), json.dumps([numbers])]
    told = subprocess.run(
        command, input=packed(*run_blobs(problem)), capture_output=True, text=True, check=True, timeout=300
    )
    return json.loads(told.stdout), np.fromfile(table).reshape(-1, problem.grid.size)


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
