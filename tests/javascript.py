"""Where node is, a kernel with the arithmetic of a browser, and a browser with the functions of a kernel."""

from __future__ import annotations

import ctypes
import json
import os
import shutil
import struct
import subprocess
import threading
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import poppet.edit
from poppet import Circuit
from poppet.deploy.live import page_kernel
from poppet.deploy.live.page_kernel import PAGE_FUNCTIONS
from poppet.engine import call, compiled
from poppet.engine.kernel import compile_kernel
from poppet.engine.printers.llvm import OF_TWO
from poppet.engine.problem import Problem

needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
WWW = Path(poppet.edit.__file__).parent / "www"
"""Modules of the page of the editor."""


def unfused(circuit: Circuit, monkeypatch: pytest.MonkeyPatch, folder: Path) -> call.Call:
    """A finished run of a kernel without fused multiplications, which WebAssembly has not."""
    import llvmlite.binding as llvm

    features = llvm.get_host_cpu_features()
    fused = [name for name in features if name.startswith(("fma", "avx512"))]
    features.update(dict.fromkeys(fused, False))

    def machine(opt: int = 2) -> Any:
        target = llvm.Target.from_default_triple()
        return target.create_target_machine(features=features.flatten(), opt=opt, jit=True)

    problem = circuit.problem(circuit.run)
    with monkeypatch.context() as changed:
        changed.setenv("POPPET_CACHE_DIR", str(folder))
        changed.setattr(compiled, "_target_machine", machine)
        kernel, integrator = compile_kernel(circuit.model), compiled.INTEGRATOR.compiled()
        changed.setattr(call, "integrator", lambda: integrator)
        p = problem.p.copy()
        own = call.Call(replace(problem, kernel=kernel, x0=kernel.start(p), p=p))
        own.outcome = own.repeat()
    return own


_ASKING = """
const [questions, answers] = QUEUES.map((path, k) => require("fs").openSync(path, k ? "r" : "w"));
const asked = Buffer.alloc(24), answer = Buffer.alloc(8);
NAMES.forEach((name, k) => {
  LIBRARY[name] = (...given) => {
    [k, ...given].forEach((value, at) => asked.writeDoubleLE(value, 8 * at));
    require("fs").writeSync(questions, asked);
    require("fs").readSync(answers, answer);
    return answer.readDoubleLE(0);
  };
});
"""


def with_functions_of_this_machine(
    problem: Problem, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> tuple[dict[str, Any], NDArray[np.float64]]:
    """A run in node that asks this process for `exp`, powers and the like, so that they are those of the kernel."""
    queues = [folder / "questions", folder / "answers"]
    for each in queues:
        os.mkfifo(each)
    functions = [getattr(ctypes.CDLL(None), name) for name in PAGE_FUNCTIONS]
    for function in functions:
        function.restype = ctypes.c_double

    def answered() -> None:
        with queues[0].open("rb") as questions, queues[1].open("wb", buffering=0) as answers:
            while text := questions.read(24):
                k, x, y = struct.unpack("<3d", text)
                given = (x, y) if PAGE_FUNCTIONS[int(k)] in OF_TWO else (x,)
                answers.write(struct.pack("<d", functions[int(k)](*map(ctypes.c_double, given))))

    threading.Thread(target=answered, daemon=True).start()
    asking = _ASKING.replace("QUEUES", json.dumps([str(each) for each in queues])).replace(
        "NAMES", json.dumps(PAGE_FUNCTIONS)
    )
    with monkeypatch.context() as changed:
        changed.setattr(page_kernel, "_MAIN", asking + page_kernel._MAIN)
        return page_kernel.run_in_node(problem, folder)


def run_module(folder: Path, script: str, *, data: Any = None) -> Any:
    """Run a module of node beside a copy of the modules of the page; it prints JSON. `data` is its variable `DATA`."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in WWW.glob("*.js"):
        shutil.copy(path, folder)
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    (folder / "data.json").write_text(json.dumps(data), encoding="utf-8")
    head = 'import { readFileSync } from "node:fs";\nconst DATA = JSON.parse(readFileSync("data.json", "utf8"));\n'
    (folder / "main.js").write_text(head + script, encoding="utf-8")
    done = subprocess.run(["node", "main.js"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
