"""Model of a circuit for the page of the editor: a WebAssembly module, and the arrays of a run."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.notes import run_notes
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.note_groups import grouped
from poppet.deploy.export_model import parameter_specs, tied_of_part
from poppet.deploy.live.linker import Module
from poppet.deploy.live.page_kernel import SHARED_STACK, model_module, run_data
from poppet.deploy.live.wasm_format import PAGE
from poppet.engine.compiled import CompiledFunctions
from poppet.engine.kernel import Kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.printers.instructions import trace_functions
from poppet.engine.problem import Outcome, Problem, RawRun

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.instance import Instance
    from poppet.engine.model import Model
    from poppet.parts.fields import NumberSpec

MARK = b"POPPETM1"
"""First bytes of a payload."""
DURATION = 2.0
"""Duration of a run in the editor if the file states none [s]."""
MAX_VALUES = 4_000_000
"""Maximum number of values of all outputs on the page; a longer run has a larger output step there."""
MAX_ATTEMPTS = 2_000_000
"""Maximum number of solver steps on the page, because the user waits for the result."""
_ALIGNMENT = 8


@dataclass(frozen=True, eq=False)
class PageKernel(Kernel):
    """Kernel of the page: it has no machine code for this process, but a WebAssembly module."""

    module: Module = field(kw_only=True)

    @property
    def key(self) -> str:
        """Text that is equal for equal modules."""
        return hashlib.sha256(self.module.code).hexdigest()[:16]

    def start(self, p: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return zeros, because the page computes the initial state."""
        return np.zeros(self.model.size)


PAGE_KERNELS: LruCache[PageKernel] = LruCache(40)
"""Models of pages by structure, apart from the kernels with machine code."""
TIES: LruCache[frozenset[str]] = LruCache(500)
"""Names of the parameters that cannot be changed alone, by kind and structure of a part."""


def build_payload(circuit: BaseCircuit, key: str | None = None) -> bytes:
    """Return the model of a circuit with the data of a run, from which the page simulates the circuit.

    The bytes are `MARK`, the length of the header, the header as JSON, and the arrays. In addition to the fields of
    `run_data`, the header contains `key`, `columns` (name and unit of each output), `numbers` (parameters that the page
    can change by itself), `duration`, `output_step` and `notes`. A circuit without a duration is simulated for
    `DURATION`.

    Parameters
    ----------
    circuit : Circuit
        Circuit.
    key : str, optional
        Key of the model that the page has. If the circuit has the same model, the result does not contain the model.

    Raises
    ------
    InputErrors
        If the run has too many rows, or a stop condition is invalid.
    """
    instance, problem, notes = _run_of_page(circuit)
    kernel = page_kernel(circuit)
    header, arrays = run_data(replace(problem, most_attempts=MAX_ATTEMPTS), module=kernel.module)
    if key == kernel.key:
        del arrays["module"]
    header |= {
        "key": kernel.key,
        "shared": {
            "stack": SHARED_STACK,
            "pages": -(-kernel.module.heap // PAGE),
            "functions": len(kernel.module.table),
        },
        "columns": [
            {"name": name, "unit": unit, "inner": name in instance.inner} for name, unit in kernel.model.outputs
        ],
        "numbers": _free_numbers(circuit, instance),
        "duration": float(problem.grid[-1]),
        "output_step": float(problem.grid[1] - problem.grid[0]) if problem.grid.size > 1 else 0.0,
        "notes": [str(note) for note in (*circuit.static_notes, *notes)],
    }
    return _pack(header, arrays)


def page_notes(circuit: BaseCircuit, results: bytes) -> list[str]:
    """Return the notes on a completed run of the page: those of `Circuit.simulate`, and those on the run options.

    Balances are not checked, because only compiled code computes the energies. No code is compiled here.

    Parameters
    ----------
    circuit : Circuit
        Circuit of the run.
    results : bytes
        Numbers of type float64: index of the stop condition that was met, or -1; minimum of each state, maximum of each
        state; times; values of each output. The number of rows follows from the length.

    Raises
    ------
    InputErrors
        If the length is not that of a run of this circuit.
    """
    instance, problem, notes = _run_of_page(circuit)
    n_states, n_outputs = instance.model.size, len(instance.model.outputs)
    rows, rest = divmod(len(results) - 8 * (1 + 2 * n_states), 8 * (1 + n_outputs))
    if rest or not 0 < rows <= problem.grid.size:
        raise InputError("edit.no_request", "body", wanted="the table of a run", value=len(results))
    numbers = np.frombuffer(results, dtype="<f8")
    stop, extremes, table = numbers[0], numbers[1 : 1 + 2 * n_states], numbers[1 + 2 * n_states :]
    if stop not in range(-1, len(problem.stop_conditions)):
        raise InputError("edit.no_request", "body", wanted="the table of a run", value=float(stop))
    table, none = table.reshape(1 + n_outputs, rows), np.zeros(n_states)
    raw = RawRun(
        Outcome.DONE if stop < 0 else Outcome.STOPPED, table[0], table[1:], none, extremes.reshape(2, n_states), none,
        accepted=0, rejected=0, stop=int(stop),
    )  # fmt: skip
    return [str(note) for note in grouped([*run_notes(instance, problem, raw), *notes])]


def _run_of_page(circuit: BaseCircuit) -> tuple[Instance, Problem, list[Note]]:
    """Return the run of the page, with notes on run options that differ from those of the circuit."""
    notes = []
    if circuit.run.duration is None:
        circuit = circuit.with_values({"run.duration": DURATION})
        notes.append(Note("edit.default_run", "run.duration", duration=DURATION))
    grid = circuit.run.grid()  # checks without cost come before the compilation
    kernel = page_kernel(circuit)
    n_outputs = len(kernel.model.outputs)
    max_rows = max(2, MAX_VALUES // max(1, n_outputs))
    if grid.size > max_rows:
        circuit = circuit.with_values({"run.output_step": float(grid[-1]) / (max_rows - 1)})
        notes.append(Note("edit.fewer_rows", "run.output_step", rows=grid.size, shown=max_rows, outputs=n_outputs))
    instance = circuit.instance_of(kernel)
    return instance, instance.problem(circuit.run), notes


def page_kernel(circuit: BaseCircuit) -> PageKernel:
    """Return the model of a circuit for a page."""
    return PAGE_KERNELS.get(circuit.structure, lambda: _compile(circuit.symbolic_model))


def _compile(model: Model) -> PageKernel:
    functions = trace_functions(model)
    sparsity = functions["jacobian"].sparsity_out(1)
    rows, columns = (np.array(places, dtype=np.int64) for places in sparsity.get_triplet())
    n_factor = functions["factor"].nnz_out(0)
    no_code = CompiledFunctions({}, None)
    return PageKernel(model, no_code, sparsity.nnz(), n_factor, (rows, columns), module=model_module(model, functions))


def _free_numbers(circuit: BaseCircuit, instance: Instance) -> dict[str, dict[str, Any]]:
    """Return the parameters that the page can change by itself, with their indices in p and their values.

    Nothing else of the run depends on them: no other parameter, no breakpoint of a signal and no stop condition. Inputs
    that take a parameter are included, as indices in u.
    """
    inputs, signals = instance.model.inputs, instance.signals
    excluded = {*_tied_numbers(circuit), *(item.delay for item in inputs), *(item.slope_of for item in inputs)}
    excluded |= {str(item.default) for item in inputs if item.slope_of}
    limited = {address.partition(".")[0] for address, (curve, _) in instance.domains.items() if curve.edge == "error"}
    users: dict[str, list[int]] = {}
    for k, item in enumerate(inputs):
        if isinstance(item.default, str) and item.name not in signals and not item.slope_of:
            users.setdefault(item.default, []).append(k)
    numbers, values = circuit.numbers(), instance.parameters
    free = {}
    for place, address in enumerate(values):
        part = address.partition(".")[0]
        if address in numbers and address not in excluded and part in circuit.parts and part not in limited:
            free[address] = {"place": place, "value": values[address], "inputs": users.get(address, [])}
    return free


def _tied_numbers(circuit: BaseCircuit) -> set[str]:
    """Return the parameters of the parts that cannot be changed alone.

    They are found once for each structure of a part. A later value at a limit could tie another one; this is noticed as
    soon as the circuit is read again.
    """
    specs, tied = cache(lambda: parameter_specs(circuit)), set()
    for name, part in circuit.parts.items():
        key = type(part), part.structure(), frozenset(part.numbers())
        tied |= {f"{name}.{local}" for local in TIES.get(key, partial(_ties_of, circuit, name, specs))}
    return tied


def _ties_of(circuit: BaseCircuit, name: str, specs: Callable[[], Mapping[str, NumberSpec]]) -> frozenset[str]:
    return tied_of_part(circuit, name, specs())


def _pack(header: Mapping[str, Any], blobs: Mapping[str, bytes]) -> bytes:
    """Return a header and arrays as bytes; the header and each array begin at a multiple of 8 bytes."""
    places, body = {}, bytearray()
    for name, blob in blobs.items():
        places[name] = [len(body), len(blob)]
        body += blob + bytes(-len(blob) % _ALIGNMENT)
    text = json.dumps({**header, "blobs": places}, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(MARK) + 4 + len(text)) % _ALIGNMENT)
    return MARK + len(text).to_bytes(4, "little") + text + body
