"""The files of a circuit in C."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.errors import InputError
from poppet.core.version import __version__
from poppet.deploy.c.c_model import integrator_pieces, integrator_text, lean_functions, lean_text, model_text
from poppet.deploy.comparison import GROWN, beside, grown, loosened, rounded, separate
from poppet.deploy.export_files import c_string, plain
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.engine.job import Job
from poppet.engine.printers.c import DOUBLE
from poppet.engine.printers.instructions import SIGNATURES

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

ROWS = 20
"""Rows of the test vector, behind that of the start."""
FIXED_STEP = 0.05
"""What a state may be off by its size in a run with a fixed step, of a length that suits no circuit in particular."""
MOST_SUBSTEPS = 10_000
STEP = "th x us p f0 J drift w -> k x1"
UNUSED = ("m", "h", "moves", "is_choosy", "nominal", "positive")
"""What a step without states does not look at."""
WHY = {
    "tied": "fixed: others follow from it",
    "delay": "fixed: a delay moves the signal",
    "derived": "fixed: it follows from others",
    "driven": "fixed: a signal decides it",
}


def c_project(circuit: Circuit, name: str = "", *, substeps: int = 1) -> dict[str, str]:
    """Files of a circuit in C, by their names.

    Parameters
    ----------
    circuit : Circuit
        With a duration, over which its signals are carried and the test vector is made.
    name : str, optional
        Of the model; default its title.
    substeps : int, optional
        In which each call of the fixed step is made at first, 1 to 10,000; the caller may change it.

    Returns
    -------
    dict
        Header, constants, fixed step, adaptive run, integrator, a host that checks them, and a `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If it has no duration, more signals than constants can carry, or no such number of substeps.
    SimulationError
        If its run fails, so that there is nothing to check against.
    """
    if not 1 <= substeps <= MOST_SUBSTEPS:
        raise InputError("deploy.substeps", count=substeps, most=MOST_SUBSTEPS)
    of = build_export_model(circuit, name)
    about = f"{plain(of.title or of.name)}: exported by poppet {__version__}"
    words = {"ABOUT": about, "NAME": of.name, **_data(of), **_sizes(of), **_vector(circuit, of)}
    words["SUBSTEPS"] = f"{substeps}"
    words |= {"FUNCTIONS": model_text(of, f"{of.name}_"), **_adaptive(of), "PROTOTYPES": _prototypes(of)}
    return {
        f"{of.name}.h": filled("header.h", of.name, words),
        f"{of.name}_data.c": filled("data.c", of.name, words),
        f"{of.name}_adaptive.c": filled("adaptive.c", of.name, words),
        f"{of.name}_integrator.c": integrator_text(f"{of.name}_integrate"),
        f"{of.name}_fixed.c": filled("fixed.c", of.name, words | _fixed(of)),
        f"{of.name}_host.c": filled("host.c", of.name, words),
        "CMakeLists.txt": filled("CMakeLists.txt", of.name, words),
    }


def filled(file: str, name: str, words: Mapping[str, str]) -> str:
    """A text of this room with its words in place, and the name of the model before its names."""
    text = files("poppet.deploy.c").joinpath("texts", file).read_text(encoding="utf-8")
    text = re.sub(r"\b(model|MODEL)_", lambda m: f"{name if m[1] == 'model' else name.upper()}_", text)
    # Words last, and once: nothing that a circuit brings is looked through for others.
    return re.sub(r"@(\w+)@", lambda m: words[m[1]], text)


def values(numbers: Iterable[float]) -> str:
    """Numbers of a list of C, of which no digit is lost."""
    return ", ".join(DOUBLE.literal(float(value)) for value in numbers)


def _flags(flags: Iterable[bool]) -> str:
    return ", ".join(str(int(flag)) for flag in flags) or "0"


def _rows(rows: Sequence[str], empty: str) -> str:
    """Elements of a table, which C wants to have one at least."""
    return ",\n".join(f"  {row}" for row in rows) or f"  {empty}"


def places(prefix: str, entries: Sequence[tuple[str, str]]) -> str:
    """Members of an enumeration with a remark for each; none has a comma behind the last."""
    lines = [
        f"  {prefix}_{name} = {k}{'' if k == len(entries) - 1 else ','} /* {remark} */"
        for k, (name, remark) in enumerate(entries)
    ]
    return "\n".join(lines) or f"  {prefix}_none = 0"


def _unit(unit: str) -> str:
    return plain(unit if unit not in ("", "1") else "-")


def remarks(quantities: Iterable[Any], *, with_value: bool = False) -> list[tuple[str, str]]:
    """Identifiers, and addresses with units as remarks."""
    return [
        (q.identifier, f"{plain(q.address)} [{_unit(q.unit)}]{f' {q.value:.6g}' if with_value else ''}")
        for q in quantities
    ]


def named_rows(rows: Iterable[Iterable[float]]) -> str:
    """A table of numbers, a line for each row."""
    return ",\n".join(f"  {values(row)}" for row in rows) or "  0.0"


def _data(of: ExportModel) -> dict[str, str]:
    problem, upper = of.problem, of.name.upper()
    numbers = [
        f"{{{c_string(n.address)}, {c_string(n.unit)}, {values([n.value, n.low, n.high])}, {int(n.is_free)}}}"
        for n in of.numbers
    ]
    inputs = [
        f"{{{c_string(i.address)}, {c_string(i.unit)}, {values([i.low, i.high])}, {i.number}, {int(i.is_driven)}}}"
        for i in of.inputs
    ]

    def quantities(each: Iterable[Any]) -> str:
        return _rows([f"{{{c_string(q.address)}, {c_string(q.unit)}}}" for q in each], "{0, 0}")

    numbered = [
        (
            n.identifier,
            "; ".join(filter(None, [f"{plain(n.address)} [{_unit(n.unit)}] {n.value:.6g}", WHY.get(n.fixed)])),
        )
        for n in of.numbers
    ]
    return {
        "NUMBERS": _rows(numbers, '{"", "", 0.0, 0.0, 0.0, 0}'),
        "INPUTS": _rows(inputs, '{"", "", 0.0, 0.0, -1, 0}'),
        "STATES": quantities(of.states),
        "MEMORY": quantities(of.memory),
        "OUTPUTS": quantities(of.outputs),
        "P": places(f"{upper}_P", numbered),
        "U": places(f"{upper}_U", remarks(of.inputs)),
        "X": places(f"{upper}_X", remarks(of.states)),
        "Y": places(f"{upper}_Y", remarks(of.outputs)),
        "STARTS": values(problem.starts),
        "COURSES": ", ".join(str(int(course)) for course in problem.courses),
        "COEFFICIENTS": named_rows(problem.coefficients.reshape(-1, 7)),
    }


def _sizes(of: ExportModel) -> dict[str, str]:
    model, kernel, problem = of.model, of.problem.kernel, of.problem
    return {
        "N_NUMBERS": f"{len(of.numbers)}",
        "N_INPUTS": f"{len(of.inputs)}",
        "ROOM": f"{max(1, len(of.inputs))}",
        "N_STATES": f"{len(of.states)}",
        "ROOM_X_FIXED": f"{max(1, len(of.states))}",
        "N_X": f"{model.size}",
        "N_MEMORY": f"{len(of.memory)}",
        "N_TIMERS": f"{model.n_timers}",
        "N_OUTPUTS": f"{len(of.outputs)}",
        "N_SEGMENTS": f"{problem.starts.size}",
        "N_COURSES": f"{len(problem.coefficients)}",
        "SCRATCH": f"{kernel.memory_size + 1}",
    }


def _prototypes(of: ExportModel) -> str:
    signatures = {name: SIGNATURES[name] for name in of.functions}
    if of.model.size:
        signatures |= {"step": STEP, "dense": "k -> d"}
    lines = []
    for name, signature in signatures.items():
        given, _, made = signature.partition("->")
        formal = [f"double *{a}" if a == "w" else f"const double *{a}" for a in given.split()]
        lines.append(f"void {of.name}_{name}({', '.join([*formal, *(f'double *{a}' for a in made.split())])});")
    return "\n".join(lines)


def _adaptive(of: ExportModel) -> dict[str, str]:
    kernel, problem, name = of.problem.kernel, of.problem, of.name
    conditions = problem.stop_conditions
    own = {key: str(value) for key, value in kernel.job.items() if key.startswith("n_")}
    own |= {key: f"(int64_t)(intptr_t){name}_{key}" for key in ("jacobian", "step", "dense", "outputs", "update")}
    if not of.model.size:
        own |= dict.fromkeys(("jacobian", "step", "dense"), "0")
    if not of.memory:
        own["update"] = "0"
    own |= {"n_segments": f"{name.upper()}_SEGMENTS", "n_courses": f"{name.upper()}_COURSES", "n_rows": "n_times"}
    own |= {"n_conditions": f"{len(conditions)}", "n_script": "0", "script": "0", "memory": "address(m->scratch)"}
    own |= {key: f"address({key})" for key in ("scales", "positive", "acting", "places", "weights", "table")}
    own |= {"starts": f"address({name}_starts)", "courses": f"address({name}_courses)", "grid": "address(times)"}
    own |= {key: f"address(m->{key})" for key in ("x", "p", "coefficients", "limits", "books", "watch", "counts")}
    own |= {"jumps": f"address({name}_jumps)"}
    lines = [f"  job[{k}] = {own[field]}; /* {field} */" for k, field in enumerate(Job._fields)]
    return {
        "JOB": "\n".join(lines),
        "N_FIELDS": f"{len(lines)}",
        "SCALES": values(kernel.scales.ravel()) or "0.0",
        "POSITIVE": _flags(kernel.positive),
        # What is never zero has a size of its own.
        "NOMINAL": values(0.0 if s.positive else s.nominal for s in of.model.states) or "0.0",
        "ACTING": _flags(kernel.acting),
        "JUMPS": _flags(problem.jumps),
        "PLACES": ", ".join(str(k) for c in conditions for k in c.places) or "-1",
        "WEIGHTS": values(w for c in conditions for w in c.weights) or "0.0",
        "TOLERANCE": DOUBLE.literal(problem.relative_tolerance),
        "LONGEST": DOUBLE.literal(problem.maximum_step),
    }


def _fixed(of: ExportModel) -> dict[str, str]:
    functions = lean_functions(of.model)
    found = {
        "FUNCTIONS": lean_text(of, functions),
        "PIECES": integrator_pieces(
            "} matrix;", "} Segment;", "static vector row_of(", "static double do_angle(", "static void do_inputs_at(",
            "static void do_input_slopes_at(", "static double do_rounding(",
        ),
        "STEP": "\n".join(f"  (void){word};" for word in UNUSED) + "\n  return 0;",
        "UPDATE": "",
        "INSTANT": "",
    }  # fmt: skip
    if of.states:
        sizes = {
            "JACOBIAN": f"{max(1, functions['jacobian'].nnz_out(1))}",
            "FACTOR": f"{functions['factor'].nnz_out(0)}",
        }
        found["STEP"] = filled("step.c", of.name, sizes).rstrip()
    if of.memory:
        found["UPDATE"] = filled("update.c", of.name, {}).rstrip()
        found["INSTANT"] = filled("instant.c", of.name, {}).rstrip()
    return found


def _vector(circuit: Circuit, of: ExportModel) -> dict[str, str]:
    """Rows of the states for the host to check, and how far from them a run may be; other outputs may jump on a row."""
    circuit.simulate()  # what fails says so here
    grid = np.linspace(0.0, of.problem.grid[-1], ROWS + 1)
    fused = replace(of.problem, grid=grid)
    problem = separate(fused)
    known = beside(problem, grid.size)
    states = {state.address for state in of.states}
    places = [k for k, output in enumerate(of.outputs) if output.address in states]
    # A circuit whose run follows rounding may differ by what rounding becomes in it, and by no more elsewhere.
    allowed = [
        [[float(f"{each:.1e}") for each in row] for row in np.clip(GROWN * grown(known, changes), least, 1e300)[places]]
        for least, changes in (
            (max(1e-9, 10.0 * problem.relative_tolerance), [*rounded(problem), fused]),
            (FIXED_STEP, loosened(problem, FIXED_STEP)),
        )
    ]
    sizes = np.where(known.sizes > 0.0, known.sizes, 1.0)
    return {
        "ROWS": f"{known.values.shape[1]}",
        "COMPARED": f"{len(places)}",
        "PLACES_OF_STATES": ", ".join(map(str, places)) or "0",
        "TIMES": values(grid[: known.values.shape[1]]),
        "SIZES": values(sizes[places]) or "1.0",
        "KNOWN": named_rows(known.values[places]),
        "ALLOWED_ADAPTIVE": named_rows(allowed[0]),
        "ALLOWED_FIXED": named_rows(allowed[1]),
    }
