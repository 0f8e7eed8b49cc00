"""Computation of several runs simultaneously, one per lane of the vector registers.

The module determines the number of lanes, compiles their machine code, and contains the worker of a batch.
"""

from __future__ import annotations

import os
from functools import lru_cache
from typing import Any

import numpy as np

from poppet.engine.compiled import CompiledFunctions, LaneFunctions, lane_integrator, load, optimised_object
from poppet.engine.job import BEFORE, LaneJob, address
from poppet.engine.kernel import Kernel
from poppet.engine.members import Batch, Integers, RunEnds
from poppet.engine.object_cache import object_code
from poppet.engine.printers.instructions import InstructionList, outputs_function, trace_functions
from poppet.engine.printers.lane_values import lane_listings
from poppet.engine.printers.llvm import Kind, print_function
from poppet.engine.printers.llvm_lanes import (
    lanes_prelude,
    print_choose,
    print_commit,
    print_judge,
    print_rows,
    print_settle,
    vector_functions,
)
from poppet.engine.printers.llvm_step import print_step
from poppet.engine.problem import Array, Problem

WIDTHS = 1, 2, 4, 8
_OF_SLICE = [LaneJob._fields.index(name) for name in ("first", "last", "base", "table")]
_LINE = 8
"""Alignment of the arrays, in doubles; equal to the largest number of lanes."""


def usual_width() -> int:
    """Return the number of runs (lanes) that are computed simultaneously.

    The environment variable `POPPET_LANES` sets it. The default is the number of doubles in a register of this
    processor.
    """
    variable = os.environ.get("POPPET_LANES")
    return int(variable) if variable else _register_width()


@lru_cache(maxsize=1)
def _register_width() -> int:
    import llvmlite.binding as llvm

    features = llvm.get_host_cpu_features()
    widths = ((8, "avx512f"), (4, "avx2"), (2, "sse2"), (2, "neon"))
    return next((width for width, feature in widths if features.get(feature, False)), 1)


def kernel_of_this_machine() -> str:
    """Return a text that identifies the processor and the number of lanes.

    Both affect the last digits of the results of a batch.
    """
    import llvmlite.binding as llvm

    return f"{llvm.get_host_cpu_name()}, {usual_width()} lanes"


def lane_functions(kernel: Kernel, width: int) -> LaneFunctions:
    """Return the machine code of a model for several simultaneous runs (lanes).

    `width` is the number of lanes. Kernels of one model with different outputs share all functions except the functions
    that write rows.
    """
    if width not in kernel.lanes:
        kind, shared, model = Kind(width), kernel.shared_lanes, kernel.model
        if width not in shared:
            functions, n_controlled = trace_functions(model), len(model.states)
            listings, n_derived = lane_listings(functions, model)
            listings |= {name: InstructionList.of(functions[name]) for name in ("factor", "solve")}
            text = [print_function(function, name, kind) for name, function in listings.items()]
            text.append(print_step(model.size, n_controlled, len(model.inputs), kind))
            text += [print_choose(kind), print_judge(n_controlled, kind), print_settle(kind)]
            text.append(print_commit(model.size, kind))
            names = ("jacobian", "jacobian_held", "derived", "step", "dense", "choose", "judge", "settle", "commit")
            code = _compile(kind, text, names)
            shared[width] = LaneFunctions(code.addresses, code.owner, n_derived)
        rows = print_rows(outputs_function(model), model.size, kind)
        code = _compile(kind, [rows], ("rows", "rows_held"))
        addresses = {**shared[width].addresses, **code.addresses}
        kernel.lanes[width] = shared[width]._replace(addresses=addresses, owner=(shared[width].owner, code.owner))
    return kernel.lanes[width]


def _compile(kind: Kind, text: list[str], names: tuple[str, ...]) -> CompiledFunctions:
    import llvmlite.binding as llvm

    for symbol, function_address in vector_functions(kind.width).values():
        llvm.add_symbol(symbol, function_address)
    return load(object_code("\n".join([lanes_prelude(kind), *text]), optimised_object), names)


class Lanes:
    """Worker that computes several runs of a batch simultaneously, each in one lane of a register.

    `width` is the number of lanes. If `leads` is True, all runs take the steps of the first run.
    `poppet.engine.batch.Worker` describes the methods.
    """

    def __init__(
        self, batch: Batch, ends: RunEnds, functions: LaneFunctions, width: int, *, leads: bool = False
    ) -> None:
        problem, kernel, model = batch.problem, batch.problem.kernel, batch.problem.kernel.model
        # Lanes wait only at the end of a slice, so slices are long.
        self.max_runs, self._shape = 32 * width, (len(model.outputs), problem.grid.size)
        self.ends, conditions = ends, problem.stop_conditions
        coefficients = np.array([problem.coefficients] * width) if batch.held else problem.coefficients
        limits = [problem.maximum_step, problem.most_attempts, leads, problem.relative_tolerance]
        self._watch = np.zeros(2)
        self._arrays: dict[str, Any] = {
            "numbers": problem.p,
            "varied": np.ascontiguousarray(batch.places, dtype=np.int64),
            "values": np.ascontiguousarray(batch.values, dtype=np.float64),
            "held": np.array(batch.held, dtype=np.int64),
            "starts": problem.starts,
            "courses": problem.courses,
            "coefficients": np.ascontiguousarray(coefficients),
            "jumps": problem.jumps,
            "row_length": np.array([problem.grid.size]),
            "grid": np.concatenate([problem.grid, np.full(width, np.inf)]),
            "limits": np.array(limits, dtype=np.float64),
            "places": np.array([c.places for c in conditions], dtype=np.int64),
            "weights": np.array([c.weights for c in conditions], dtype=np.float64),
            "record": ends.record,
            "counts": ends.counts,
            "watch": self._watch,
        }
        fields = {name: kernel.job[name] for name in LaneJob._fields if name in kernel.job}
        fields |= {name: kernel.functions.addresses.get(name, 0) for name in ("start", "energy", "outputs", "update")}
        fields |= {name: address(array) for name, array in self._arrays.items()}
        fields |= {**functions.addresses, **self._memory(kernel, width, functions.n_derived)}
        if problem.coefficients[:, :, 1:3].any():
            # If inputs change, all lanes use the same function: the two functions can round differently.
            fields["jacobian_held"] = fields["jacobian"]
        self._owner = functions.owner, kernel.functions.owner
        job = LaneJob(
            **fields, width=width, n_energies=model.n_energies, n_derived=functions.n_derived,
            n_segments=problem.starts.size, n_courses=len(problem.coefficients), n_rows=problem.grid.size,
            n_conditions=len(conditions), n_varied=batch.places.size, n_held=len(batch.held),
            n_record=ends.record.shape[1], first=0, last=0, busy=0, base=0, table=0,
        )  # fmt: skip
        self._job = np.array(job, dtype=np.int64)

    def _memory(self, kernel: Kernel, width: int, n_derived: int) -> dict[str, int]:
        """Allocate the arrays of all lanes as one block, and return their addresses by name.

        `n_derived` is the number of values that are appended to the parameter vector.
        """
        j = kernel.job
        n, n_c, n_u, n_p = j["n_states"], j["n_controlled"], j["n_inputs"], j["n_numbers"] + j["n_memory"]
        sizes = {
            "control": BEFORE + 1, "th": 2, "x": n, "u": n_u, "us": 4 * n_u, "slopes": n_u, "p": n_p + n_derived,
            "rates": n, "j": j["n_jacobian"], "drift": n, "scratch": j["n_scratch"], "stages": 5 * n, "estimate": n,
            "new": n, "interpolant": 2 * n, "tolerances": 2 * n_c, "sizes": n_c, "low": n_c, "books": 3 * n,
            "rows_u": n_u, "flags": 6, "own": n_p,
        }  # fmt: skip
        shared_size = 6 * n + 2 * n_u + 2 + j["n_outputs"] + j["n_timers"] + j["n_memory"] + 3 * n_c
        self._block = np.zeros(_LINE + width * sum(sizes.values()) + shared_size)
        position = -(-address(self._block) // (8 * _LINE)) * 8 * _LINE
        addresses = {}
        for name, size in sizes.items():
            addresses[name] = position
            position += 8 * width * size
        return addresses | {"one": position}

    def run(self, first: int, last: int, table: Array | None) -> None:
        """Compute the runs `first` to `last` - 1 and write their output rows."""
        if table is None:
            table = np.empty((last - first, *self._shape))
        self._job[_OF_SLICE] = first, last, first, address(table)
        lane_integrator()(address(self._job))

    def halt(self) -> None:
        """Stop the current runs as soon as possible.

        Another thread calls this method.
        """
        self._watch[1] = 1.0


class LockstepLanes:
    """Simultaneous runs that all take the steps of the first run.

    Without error control, their results are smooth functions of the parameters. Write the parameters of each run into a
    row of `values`, then call `run`. If the first run ends early, all runs end, and later output values are NaN.
    Problems with discrete states, stop conditions or no states are not supported.
    """

    def __init__(
        self, problem: Problem, count: int, indices: Integers, constant_inputs: tuple[tuple[int, int], ...]
    ) -> None:
        width = usual_width()
        # Each group of lanes contains the first run, with equal digits; unused lanes repeat the first run.
        groups = max(1, -(-(count - 1) // (width - 1)))
        followers = np.arange(groups * (width - 1)).reshape(groups, -1) + 1
        run_of_lane = np.zeros((groups, width), dtype=np.int64)
        run_of_lane[:, 1:] = np.where(followers < count, followers, 0)
        self._run_of_lane = run_of_lane.ravel()
        self._rows = np.array([0, *np.flatnonzero(self._run_of_lane)])
        self.values = np.empty((count, indices.size))
        self._batch = Batch(problem, indices, np.empty((run_of_lane.size, indices.size)), constant_inputs)
        lanes = lane_functions(problem.kernel, width)
        self._lanes = Lanes(self._batch, RunEnds.of(self._batch), lanes, width, leads=True)
        self._table = np.empty((run_of_lane.size, len(problem.kernel.model.outputs), problem.grid.size))
        self._width = width

    @staticmethod
    def can_run(problem: Problem) -> bool:
        """Return True if `LockstepLanes` can compute the runs of a problem on this processor.

        The problem must have states, but no discrete states and no stop conditions. More than two lanes are required.
        """
        model = problem.kernel.model
        return bool(model.size and not model.memory and not problem.stop_conditions and usual_width() > 2)

    def run(self) -> Array:
        """Return the outputs of all runs at the output times, (n_runs, n_outputs, n_times)."""
        np.take(self.values, self._run_of_lane, axis=0, out=self._batch.values)
        for first in range(0, self._run_of_lane.size, self._width):
            self._lanes.run(first, first + self._width, self._table[first : first + self._width])
        return np.asarray(self._table[self._rows])
