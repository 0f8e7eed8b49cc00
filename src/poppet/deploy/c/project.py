"""Export of a circuit as C: the model, the adaptive integrator, a fixed step for real time, a host program."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.errors import InputError
from poppet.core.tables import Field
from poppet.core.version import __version__
from poppet.deploy.c.c_model import (
    comment_rows,
    enum_members,
    fill_template,
    fixed_step_functions,
    integrator_code,
    integrator_excerpt,
    model_code,
    number_list,
    number_rows,
    prototypes,
    static_code,
)
from poppet.deploy.c.controller import c_controller
from poppet.deploy.comparison import (
    MARGIN,
    change_effects,
    rounding_changes,
    run_reference,
    tolerance_changes,
    without_fused_operations,
)
from poppet.deploy.controller import controllers_of_option
from poppet.deploy.export_files import c_string, comment_text
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.deploy.targets import CircuitSource, Export
from poppet.engine.job import Job
from poppet.engine.printers.c import DOUBLE

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

N_ROWS = 20
"""Number of output times of the test vector after the start."""
FIXED_STEP = 0.05
"""Allowed error of a state relative to its size, in a run with a fixed step. The step is not adapted to the circuit."""
MAX_SUBSTEPS = 10_000
UNUSED = ("m", "h", "moves", "is_choosy", "nominal", "positive")
"""Arguments that a step without states does not use."""
FIXED_REASONS = {
    "tied": "fixed: other parameters depend on it",
    "delay": "fixed: a delay moves the signal",
    "derived": "fixed: depends on other parameters",
    "driven": "fixed: a signal sets it",
}


def export_c(
    circuit: BaseCircuit, source: CircuitSource, *, name: str | None = None, substeps: int | None = None,
    part: str | None = None, precision: str | None = None,
) -> Export:  # fmt: skip
    """Export a circuit or its sampled controllers as C.

    The keyword arguments are the options of the export target.
    """
    if precision and not part:
        raise InputError("deploy.precision")
    if substeps is not None and part:
        raise InputError("deploy.substeps_of_part")
    if part:
        parts = controllers_of_option(circuit, part)
        return Export(c_controller(circuit, parts, name=name or "", precision=precision or "double"))
    return Export(c_project(circuit, name or source.name, substeps=1 if substeps is None else substeps))


def c_project(circuit: BaseCircuit, name: str = "", *, substeps: int = 1) -> dict[str, str]:
    """Return the C files of a circuit by name.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration, over which the signals are exported and the test vector is computed.
    name : str, optional
        Name of the model (default: title of the circuit).
    substeps : int, optional
        Initial number of integration steps per fixed-step call, 1 to 10,000; the host program can change it.

    Returns
    -------
    dict
        Header, constants, fixed step, adaptive run, integrator, a host program that checks them, and a
        `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If the circuit has no duration or too many signal segments, or if the number of substeps is invalid.
    SimulationError
        If the run of the circuit fails: the test vector requires it.
    """
    meaning = "number of integration steps per fixed-step call"
    Field(type="integer", low=1, high=MAX_SUBSTEPS, meaning=meaning).read(substeps, "substeps")
    export_model = build_export_model(circuit, name)
    name = export_model.name
    fields = {
        "ABOUT": f"{comment_text(export_model.title or name)}: exported by poppet {__version__}",
        "NAME": name,
        "SUBSTEPS": f"{substeps}",
        "FUNCTIONS": model_code(export_model, f"{name}_"),
        **_constants_in_c(export_model), **_test_vector(circuit, export_model),
        **_adaptive_run(export_model),
    }  # fmt: skip
    functions = fixed_step_functions(export_model.model)
    fixed = {
        "FUNCTIONS": static_code(export_model, functions),
        "PIECES": integrator_excerpt(
            "} matrix;", "} Segment;", "static vector row_of(", "static double do_angle(", "static void do_inputs_at(",
            "static void do_input_slopes_at(", "static double do_rounding(",
        ),
        "STEP": "\n".join(f"  (void){argument};" for argument in UNUSED) + "\n  return 0;",
        "UPDATE": "",
        "INSTANT": "",
    }  # fmt: skip
    if export_model.states:
        sizes = {"JACOBIAN": max(1, functions["jacobian"].nnz_out(1)), "FACTOR": functions["factor"].nnz_out(0)}
        step = fill_template("step.c", name, {field: f"{size}" for field, size in sizes.items()})
        fixed["STEP"] = step.rstrip()
    if export_model.memory:
        fixed |= {field: fill_template(f"{field.lower()}.c", name, {}).rstrip() for field in ("UPDATE", "INSTANT")}
    return {
        f"{name}.h": fill_template("header.h", name, fields),
        f"{name}_data.c": fill_template("data.c", name, fields),
        f"{name}_adaptive.c": fill_template("adaptive.c", name, fields),
        f"{name}_integrator.c": integrator_code(f"{name}_integrate"),
        f"{name}_fixed.c": fill_template("fixed.c", name, fields | fixed),
        f"{name}_host.c": fill_template("host.c", name, fields),
        "CMakeLists.txt": fill_template("CMakeLists.txt", name, fields),
    }


def _flags(flags: Iterable[bool]) -> str:
    return ", ".join(str(int(flag)) for flag in flags) or "0"


def _table_rows(rows: Sequence[str], empty: str) -> str:
    """Return the initial values of a C table, one line per row.

    C has no empty tables: a table without rows gets the single element `empty`.
    """
    return ",\n".join(f"  {row}" for row in rows) or f"  {empty}"


def _constants_in_c(export_model: ExportModel) -> dict[str, str]:
    """Return the constants of the circuit in C, by template placeholder.

    They are sizes, parameters, inputs, names and signals.
    """
    problem, model, upper = export_model.problem, export_model.model, export_model.name.upper()
    sizes = {
        "N_NUMBERS": len(export_model.parameters), "N_INPUTS": len(export_model.inputs),
        "ROOM": max(1, len(export_model.inputs)), "N_STATES": len(export_model.states),
        "ROOM_X_FIXED": max(1, len(export_model.states)), "N_X": model.size, "N_MEMORY": len(export_model.memory),
        "N_TIMERS": model.n_timers, "N_OUTPUTS": len(export_model.outputs), "N_SEGMENTS": problem.starts.size,
        "N_COURSES": len(problem.coefficients), "SCRATCH": problem.kernel.memory_size + 1,
    }  # fmt: skip
    parameters = [
        f"{{{c_string(q.address)}, {c_string(q.unit)}, {number_list([q.value, q.low, q.high])}, {int(q.is_free)}}}"
        for q in export_model.parameters
    ]
    inputs = [
        f"{{{c_string(q.address)}, {c_string(q.unit)}, {number_list([q.low, q.high])}, {q.parameter}, "
        f"{int(q.is_driven)}}}"
        for q in export_model.inputs
    ]

    def names_and_units(quantities: Iterable[Any]) -> str:
        return _table_rows([f"{{{c_string(q.address)}, {c_string(q.unit)}}}" for q in quantities], "{0, 0}")

    parameter_comments = [
        (name, "; ".join(filter(None, [comment, FIXED_REASONS.get(q.fixed)])))
        for q, (name, comment) in zip(
            export_model.parameters, comment_rows(export_model.parameters, with_value=True), strict=True
        )
    ]
    return {
        **{name: f"{size}" for name, size in sizes.items()},
        "NUMBERS": _table_rows(parameters, '{"", "", 0.0, 0.0, 0.0, 0}'),
        "INPUTS": _table_rows(inputs, '{"", "", 0.0, 0.0, -1, 0}'),
        "STATES": names_and_units(export_model.states),
        "MEMORY": names_and_units(export_model.memory),
        "OUTPUTS": names_and_units(export_model.outputs),
        "P": enum_members(f"{upper}_P", parameter_comments),
        "U": enum_members(f"{upper}_U", comment_rows(export_model.inputs)),
        "X": enum_members(f"{upper}_X", comment_rows(export_model.states)),
        "Y": enum_members(f"{upper}_Y", comment_rows(export_model.outputs)),
        "STARTS": number_list(problem.starts),
        "COURSES": ", ".join(str(int(course)) for course in problem.courses),
        "COEFFICIENTS": number_rows(problem.coefficients.reshape(-1, 7)),
    }


def _adaptive_run(export_model: ExportModel) -> dict[str, str]:
    """Return the C code that prepares the adaptive integrator, as a mapping from template placeholder to code.

    The code contains the prototypes of the model functions, the job (an array of pointers and sizes that the
    integrator reads) and the constants.
    """
    problem, name, model = export_model.problem, export_model.name, export_model.model
    kernel, conditions, upper = problem.kernel, problem.stop_conditions, name.upper()
    job = {key: str(value) for key, value in kernel.job.items() if key.startswith("n_")}
    job |= {key: f"(int64_t)(intptr_t){name}_{key}" for key in ("jacobian", "step", "dense", "outputs", "update")}
    if not model.size:
        job |= dict.fromkeys(("jacobian", "step", "dense"), "0")
    if not export_model.memory:
        job["update"] = "0"
    job |= {"n_segments": f"{upper}_SEGMENTS", "n_courses": f"{upper}_COURSES", "n_rows": "n_times"}
    job |= {"n_conditions": f"{len(conditions)}", "n_script": "0", "script": "0", "memory": "address(m->scratch)"}
    job |= {key: f"address({key})" for key in ("scales", "positive", "acting", "places", "weights", "table")}
    job |= {key: f"address({name}_{key})" for key in ("starts", "courses", "jumps")}
    job |= {key: f"address(m->{key})" for key in ("x", "p", "coefficients", "limits", "books", "watch", "counts")}
    job |= {"grid": "address(times)"}
    functions = [*export_model.functions, *(("step", "dense") if model.size else ())]
    lines = [f"  job[{k}] = {job[field]}; /* {field} */" for k, field in enumerate(Job._fields)]
    return {
        "PROTOTYPES": "\n".join(prototypes(functions, f"{name}_")),
        "JOB": "\n".join(lines),
        "N_FIELDS": f"{len(lines)}",
        "SCALES": number_list(kernel.scales.ravel()) or "0.0",
        "POSITIVE": _flags(kernel.positive),
        # The size of a positive state follows its value.
        "NOMINAL": number_list(0.0 if state.positive else state.nominal for state in model.states) or "0.0",
        "ACTING": _flags(kernel.acting),
        "JUMPS": _flags(problem.jumps),
        "PLACES": ", ".join(str(k) for condition in conditions for k in condition.places) or "-1",
        "WEIGHTS": number_list(w for condition in conditions for w in condition.weights) or "0.0",
        "TOLERANCE": DOUBLE.literal(problem.relative_tolerance),
        "LONGEST": DOUBLE.literal(problem.maximum_step),
    }


def _test_vector(circuit: BaseCircuit, export_model: ExportModel) -> dict[str, str]:
    """Return expected states at several times, by template placeholder.

    The exported program compares its own states with them, and permits the differences that are also returned. Other
    outputs are not compared, because they may jump.
    """
    circuit.simulate()  # raises the error of a run that fails
    grid = np.linspace(0.0, export_model.problem.grid[-1], N_ROWS + 1)
    fused = replace(export_model.problem, grid=grid)
    problem = without_fused_operations(fused)
    reference = run_reference(problem, grid.size)
    states = {state.address for state in export_model.states}
    indices = [k for k, output in enumerate(export_model.outputs) if output.address in states]
    # Near a switching event, rounding has a larger effect: the allowed difference increases with it, and only there.
    adaptive, fixed = (
        [
            [float(f"{difference:.1e}") for difference in row]
            for row in np.clip(MARGIN * change_effects(reference, changes), limit, 1e300)[indices]
        ]
        for limit, changes in (
            (max(1e-9, 10.0 * problem.relative_tolerance), [*rounding_changes(problem), fused]),
            (FIXED_STEP, tolerance_changes(problem, FIXED_STEP)),
        )
    )
    sizes = np.where(reference.sizes > 0.0, reference.sizes, 1.0)
    n_rows = reference.values.shape[1]
    return {
        "ROWS": f"{n_rows}",
        "COMPARED": f"{len(indices)}",
        "PLACES_OF_STATES": ", ".join(map(str, indices)) or "0",
        "TIMES": number_list(grid[:n_rows]),
        "SIZES": number_list(sizes[indices]) or "1.0",
        "KNOWN": number_rows(reference.values[indices]),
        "ALLOWED_ADAPTIVE": number_rows(adaptive),
        "ALLOWED_FIXED": number_rows(fixed),
    }
