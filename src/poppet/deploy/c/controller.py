"""Export of sampled controllers as C for a microcontroller, to be called once per cycle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.version import __version__
from poppet.deploy.c.c_model import comment_rows, enum_members, fill_template, number_list, number_rows
from poppet.deploy.controller import SIGNATURES, ControllerProgram, controller_program
from poppet.deploy.export_files import c_string, comment_text, identifier
from poppet.engine.printers.c import DOUBLE, SINGLE, print_function, used_prelude

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

N_CALLS = 100
"""Number of calls of the test vector."""
ALLOWED = {"double": 1e-11, "single": 1e-3}
"""Allowed differences of outputs from the test vector, relative to their size."""


def c_controller(
    circuit: BaseCircuit, parts: Sequence[str] = (), *, name: str = "", precision: str = "double"
) -> dict[str, str]:
    """Return the C files of one or several sampled controllers by name.

    Parameters
    ----------
    circuit : Circuit
        Circuit with controllers.
    parts : sequence of str, optional
        Names of the controllers; required if there are several.
    name : str, optional
        Name of the program (default: names of the controllers).
    precision : str, optional
        `double` or `single`. With `single`, times, timers and counters are still doubles, because a single-precision
        time stops increasing after some hours.

    Returns
    -------
    dict
        Header, program, a host program that checks it, and a `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If there is no such part, or the part is no sampled controller.
    """
    program = controller_program(circuit, parts)
    name = identifier(name or program.name)
    kind = SINGLE if precision == "single" else DOUBLE
    quantities: dict[str, Sequence[Any]]
    quantities = {"u": program.inputs, "p": program.parameters, "z": program.memory, "y": program.outputs}
    labels = {symbol: [comment_text(q.address) for q in items] for symbol, items in quantities.items()}
    labels["after"] = labels["z"]
    # Times and counters stay double: the timers, and all discrete states on which no input acts.
    update = program.functions["update"]
    sources: dict[int, set[int]] = {k: set() for k in range(len(program.memory))}
    for row, column in zip(*update.jac_sparsity(0, 3).get_triplet(), strict=True):
        sources[row].add(column)
    driven = set(update.jac_sparsity(0, 1).get_triplet()[0])
    while newly_driven := {row for row, columns in sources.items() if columns & driven} - driven:
        driven |= newly_driven
    times = sorted({*range(program.n_timers), *(k for k in sources if k not in driven)})
    wide = {"t": (0,), "p": (), "z": times, "after": times} if kind.ending else None
    functions = "\n\n".join(
        print_function(
            program.functions[function], function, signature.replace("-> z", "-> after"),
            labels=labels, precision=kind, head="static void", wide=wide,
        )
        for function, signature in SIGNATURES.items()
    )  # fmt: skip
    title = f"{comment_text(program.title or name)}: {', '.join(map(comment_text, program.parts))}"
    fields = {
        "ABOUT": f"{title}, exported by poppet {__version__}",
        "NAME": name, "REAL": kind.real, "CYCLE": DOUBLE.literal(program.cycle),
        "FUNCTIONS": "\n\n".join(filter(None, (used_prelude(functions, kind), functions))),
        "START": ", ".join(DOUBLE.literal(parameter.value) for parameter in program.parameters) or "0",
        "HELD": ", ".join(kind.literal(item.value) for item in program.inputs) or "0",
        "P": enum_members(f"{name.upper()}_P", comment_rows(program.parameters, with_value=True)),
        "U": enum_members(f"{name.upper()}_U", comment_rows(program.inputs, with_value=True)),
        "Y": enum_members(f"{name.upper()}_Y", comment_rows(program.outputs)),
        "N_NUMBERS": f"{len(program.parameters)}", "N_INPUTS": f"{len(program.inputs)}",
        "N_MEMORY": f"{len(program.memory)}", "N_TIMERS": f"{program.n_timers}", "N_OUTPUTS": f"{len(program.outputs)}",
        **_test_vector(program, precision),
    }  # fmt: skip
    templates = {".h": "controller.h", ".c": "controller.c", "_host.c": "controller_host.c"}
    project = {f"{name}{ending}": fill_template(template, name, fields) for ending, template in templates.items()}
    return {**project, "CMakeLists.txt": fill_template("controller.txt", name, fields)}


def _test_vector(program: ControllerProgram, precision: str) -> dict[str, str]:
    """Return test calls of a controller program with the expected outputs.

    The inputs are random values of typical size. The result maps each placeholder of the C template to its text.
    """
    generator = np.random.default_rng(0)
    sizes: dict[str, float] = {}
    for item in program.inputs:
        sizes[item.unit] = max(sizes.get(item.unit, 0.0), abs(item.value))
    rows = []
    for _ in range(N_CALLS):
        u = np.array([item.value for item in program.inputs])
        for k, item in enumerate(program.inputs):
            # Inputs between 0 and 1 are switches and keep their values.
            if item.unit != "1":
                size = sizes[item.unit] or (item.high if np.isfinite(item.high) else 1.0)
                u[k] = np.clip(size * generator.uniform(0.6, 1.4), item.low, item.high)
        rows.append(np.asarray(u, dtype=np.float32).astype(float))
    outputs = program.run(rows)
    magnitudes = np.abs(outputs).max(axis=0)
    return {
        "CALLS": f"{N_CALLS}", "ALLOWED": DOUBLE.literal(ALLOWED[precision]),
        "GIVEN": number_rows(rows), "KNOWN": number_rows(outputs),
        "SIZES": number_list(np.where(magnitudes > 0.0, magnitudes, 1.0)),
        "NAMES": ", ".join(c_string(output.address) for output in program.outputs),
    }  # fmt: skip
