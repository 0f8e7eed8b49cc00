"""What a page carries of a run: the module, and the arrays that the kernel is handed, bit by bit.

The same row of fields as `poppet.engine.job.Job` is filled in the browser, with addresses in the memory of the module.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np

from poppet.deploy.live.module import CALLED, live_module
from poppet.engine.job import Job
from poppet.engine.problem import Problem

_ALIGNED = 8


def run_blobs(problem: Problem) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Header and blobs of a run: lengths, and arrays by the name of the field that will hold their address."""
    kernel, conditions, module = problem.kernel, problem.stop_conditions, live_module(problem.kernel.model)
    lengths = {name: value for name, value in kernel.job.items() if name.startswith("n_")}
    lengths |= {
        "n_segments": problem.starts.size, "n_courses": len(problem.coefficients), "n_rows": problem.grid.size,
        "n_conditions": len(conditions), "n_script": 0,
    }  # fmt: skip
    limits = np.array([problem.maximum_step, problem.most_attempts, 0.0, problem.relative_tolerance])
    arrays = {
        "scales": kernel.scales, "positive": kernel.positive, "acting": kernel.acting, "p": problem.p,
        "starts": problem.starts, "courses": problem.courses, "coefficients": problem.coefficients,
        "jumps": problem.jumps, "grid": problem.grid, "limits": limits,
        "places": np.array([each.places for each in conditions], dtype=np.int64),
        "weights": np.array([each.weights for each in conditions], dtype=np.float64),
    }  # fmt: skip
    n = lengths["n_states"]
    # In doubles, as `poppet.engine.call.Call` has them.
    room = {"x": n, "table": lengths["n_outputs"] * problem.grid.size, "books": 3 * n, "watch": 2, "counts": 5}
    header = {
        "fields": Job._fields, "functions": {name: module.table.get(name, 0) for name in CALLED}, "heap": module.heap,
        "lengths": lengths, "room": room | {"memory": kernel.memory_size},
    }  # fmt: skip
    return header, {"module": module.code, **{name: array.tobytes() for name, array in arrays.items()}}


def packed(header: Mapping[str, Any], blobs: Mapping[str, bytes]) -> str:
    """One text of letters that a page may hold anywhere: length of the header, header as JSON, blobs; deflated."""
    places, body = {}, b""
    for name, blob in blobs.items():
        places[name] = [len(body), len(blob)]
        body += blob + bytes(-len(blob) % _ALIGNED)
    text = json.dumps({**header, "blobs": places}, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 4) % _ALIGNED)
    return base64.b64encode(zlib.compress(len(text).to_bytes(4, "little") + text + body, 9)).decode()
