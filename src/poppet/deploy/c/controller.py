"""Sampled controllers alone as C, for a microcontroller: what is to be called once in every cycle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.version import __version__
from poppet.deploy.c.project import filled, named_rows, places, remarks, values
from poppet.deploy.controller import SIGNATURES, ControllerProgram, controller_program
from poppet.deploy.export_files import c_string, identifier, plain
from poppet.engine.model_evaluation import Array
from poppet.engine.printers.c import DOUBLE, SINGLE, print_function, used_prelude

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

CALLS = 100
"""Calls of the test vector."""
ALLOWED = {"double": 1e-11, "single": 1e-3}
"""Differences of outputs from the test vector, by their size."""


def c_controller(
    circuit: Circuit, parts: Sequence[str] = (), *, name: str = "", precision: str = "double"
) -> dict[str, str]:
    """Files of one or several sampled controllers in C, by their names.

    Parameters
    ----------
    circuit : Circuit
        Where they stand.
    parts : sequence of str, optional
        Their names; needed where there are several.
    name : str, optional
        Of the program; default theirs.
    precision : str, optional
        `double`, or `single`: then times, timers and counters stay doubles, so that none stands still after hours.

    Returns
    -------
    dict
        Header, program, a host that checks it, and a `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If there is no such part, or it is no sampled controller.
    """
    program = controller_program(circuit, parts)
    own = identifier(name or program.name)
    kind = SINGLE if precision == "single" else DOUBLE
    labels = {
        "u": [plain(i.address) for i in program.inputs], "p": [plain(n.address) for n in program.numbers],
        "z": [plain(z.address) for z in program.memory], "y": [plain(y.address) for y in program.outputs],
    }  # fmt: skip
    labels["after"], of_time = labels["z"], _times(program)
    wide = {"t": (0,), "p": (), "z": of_time, "after": of_time}
    functions = "\n\n".join(
        print_function(
            program.functions[f],
            f,
            s.replace("-> z", "-> after"),
            labels=labels,
            precision=kind,
            head="static void",
            wide=wide if kind.ending else None,
        )
        for f, s in SIGNATURES.items()
    )
    title = f"{plain(program.title or own)}: {', '.join(map(plain, program.parts))}"
    words = {
        "ABOUT": f"{title}, exported by poppet {__version__}",
        "NAME": own, "REAL": kind.real, "CYCLE": DOUBLE.literal(program.cycle),
        "FUNCTIONS": "\n\n".join(filter(None, (used_prelude(functions, kind), functions))),
        "START": ", ".join(DOUBLE.literal(n.value) for n in program.numbers) or "0",
        "HELD": ", ".join(kind.literal(i.value) for i in program.inputs) or "0",
        "P": places(f"{own.upper()}_P", remarks(program.numbers, with_value=True)),
        "U": places(f"{own.upper()}_U", remarks(program.inputs, with_value=True)),
        "Y": places(f"{own.upper()}_Y", remarks(program.outputs)),
        "N_NUMBERS": f"{len(program.numbers)}", "N_INPUTS": f"{len(program.inputs)}",
        "N_MEMORY": f"{len(program.memory)}", "N_TIMERS": f"{program.n_timers}", "N_OUTPUTS": f"{len(program.outputs)}",
        **_vector(program, precision),
    }  # fmt: skip
    return {
        f"{own}.h": filled("controller.h", own, words),
        f"{own}.c": filled("controller.c", own, words),
        f"{own}_host.c": filled("controller_host.c", own, words),
        "CMakeLists.txt": filled("controller.txt", own, words),
    }


def _times(program: ControllerProgram) -> list[int]:
    """Places in the memory of times and of what counts periods: nothing that is measured decides them."""
    update, n = program.functions["update"], program.n_timers
    needs: dict[int, set[int]] = {k: set() for k in range(len(program.memory))}
    for row, column in zip(*update.jac_sparsity(0, 3).get_triplet(), strict=True):
        needs[row].add(column)
    driven = set(update.jac_sparsity(0, 1).get_triplet()[0])
    while more := {row for row, columns in needs.items() if columns & driven} - driven:
        driven |= more
    return sorted({*range(n), *(k for k in needs if k not in driven)})


def _vector(program: ControllerProgram, precision: str) -> dict[str, str]:
    """Calls with inputs somewhere in their range, and the outputs that they give."""
    generator = np.random.default_rng(0)
    sizes: dict[str, float] = {}
    for item in program.inputs:
        sizes[item.unit] = max(sizes.get(item.unit, 0.0), abs(item.value))
    rows = []
    for _ in range(CALLS):
        u = np.array([item.value for item in program.inputs])
        for k, item in enumerate(program.inputs):
            # What switches, between 0 and 1, stays as it is.
            if item.unit != "1":
                size = sizes[item.unit] or (item.high if np.isfinite(item.high) else 1.0)
                u[k] = np.clip(size * generator.uniform(0.6, 1.4), item.low, item.high)
        rows.append(np.asarray(u, dtype=np.float32).astype(float))
    found: Array = program.calls(rows)
    size = np.abs(found).max(axis=0)
    return {
        "CALLS": f"{CALLS}", "ALLOWED": DOUBLE.literal(ALLOWED[precision]),
        "GIVEN": named_rows(rows), "KNOWN": named_rows(found), "SIZES": values(np.where(size > 0.0, size, 1.0)),
        "NAMES": ", ".join(c_string(y.address) for y in program.outputs),
    }  # fmt: skip
