"""From a model to machine code: the functions the integrator calls, compiled together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.compiled import CompiledFunctions, LaneFunctions, compile_functions
from poppet.engine.job import address
from poppet.engine.lru_cache import LruCache
from poppet.engine.model import Model
from poppet.engine.printers.instructions import SIGNATURES, traced_functions
from poppet.engine.printers.llvm_step import print_step
from poppet.engine.rosenbrock import scratch_size

Array = NDArray[np.float64]
KERNELS: LruCache[Kernel] = LruCache(100)
"""Compiled models of this process by structure (and, where only some outputs are wanted, their places): a changed
number never compiles again. Code lives as long as a kernel with it does, here or in a problem."""


@dataclass(frozen=True, eq=False)
class Kernel:
    """A model ready to run."""

    model: Model
    functions: CompiledFunctions
    # Numbers of nonzeros of J and of its factors.
    jacobian_size: int
    factor_size: int
    pattern: tuple[NDArray[np.int64], NDArray[np.int64]]  # row and column of each nonzero of J
    # By width, made by `poppet.engine.lane_kernel`: what all kernels of a model have in common, and all of it.
    shared_lanes: dict[int, LaneFunctions] = field(default_factory=dict)
    lanes: dict[int, LaneFunctions] = field(default_factory=dict)

    @cached_property
    def job(self) -> dict[str, int]:
        """The fields of an integrator's `Job` that are the same for every run."""
        m, functions = self.model, self.functions.addresses
        # 0 for what a model has not: no states, no step; no memory, no update.
        fields = {name: functions.get(name, 0) for name in ("jacobian", "step", "dense", "outputs", "update")}
        fields |= {"n_states": m.size, "n_controlled": len(m.states), "n_inputs": len(m.inputs) or 1}
        fields |= {"n_outputs": len(m.outputs), "n_numbers": len(m.parameters)}
        fields |= {"n_memory": len(m.memory), "n_timers": m.n_timers}
        fields |= {"n_jacobian": self.jacobian_size, "n_scratch": scratch_size(m.size, self.factor_size)}
        return fields | {
            "scales": address(self.scales),
            "positive": address(self.positive),
            "acting": address(self.acting),
        }

    @cached_property
    def memory_size(self) -> int:
        """Doubles of scratch memory that the integrator needs."""
        j = self.job
        # As `_run_of` of the integrator carves them up: 12 vectors of states, tolerances, inputs with their slopes,
        # outputs, memory; then time and step, J, and what the printed step needs.
        of_model = (
            12 * j["n_states"]
            + 3 * j["n_controlled"]
            + 6 * j["n_inputs"]
            + j["n_outputs"]
            + j["n_memory"]
            + j["n_timers"]
        )
        return of_model + 2 + j["n_jacobian"] + j["n_scratch"]

    @cached_property
    def scales(self) -> Array:
        """For each controlled state the factor on the relative tolerance, its floor, its nominal size, (3, n)."""
        states = self.model.states
        return np.array([[s.tolerance for s in states], [s.floor for s in states], [s.nominal for s in states]])

    @cached_property
    def positive(self) -> NDArray[np.bool_]:
        """Which controlled states must stay positive."""
        return np.array([state.positive for state in self.model.states], dtype=np.bool_)

    @cached_property
    def acting(self) -> NDArray[np.bool_]:
        """On which elements of the memory the rates depend."""
        return np.array(self.model.acting, dtype=np.bool_)

    @cached_property
    def _callables(self) -> dict[str, Any]:
        import ctypes

        found: dict[str, Any] = {}
        for name in SIGNATURES.keys() & self.functions.addresses.keys():
            count = len(SIGNATURES[name].replace("->", "").split())
            found[name] = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * count)(self.functions.addresses[name])
            found[name].owner = self.functions.owner  # a caller may outlive the kernel
        return found

    def observing(self, places: Sequence[int]) -> Kernel:
        """The same machine code with some of the outputs only: a fit looks at a few, at many times, very often."""
        return KERNELS.get((self, tuple(places)), lambda: self._observing(places))

    def _observing(self, places: Sequence[int]) -> Kernel:
        import casadi as ca

        model, symbols = self.model, self.model.symbols
        # Only this one function is compiled anew; the rest, most of the code, is shared.
        chosen = ca.vertcat(*(model.expressions["outputs"][k] for k in places))
        arguments = [symbols[name] for name in ("t", "x", "u", "p")]
        own = compile_functions({"outputs": ca.Function("outputs", arguments, [ca.densify(chosen)])})
        functions = CompiledFunctions({**self.functions.addresses, **own.addresses}, (self.functions.owner, own.owner))
        outputs = tuple(model.outputs[k] for k in places)
        expressions = {**model.expressions, "outputs": chosen}
        model = replace(model, outputs=outputs, expressions=expressions)
        return replace(self, model=model, functions=functions, lanes={})

    def call(self, name: str, *arrays: Array) -> None:
        """Run one compiled function on contiguous arrays; the last ones are its outputs."""
        self.caller(name, *arrays)()

    def caller(self, name: str, *arrays: Array) -> Callable[[], None]:
        """`call`, to be run many times on the same arrays, which the owner must keep."""
        return partial(self._callables[name], *map(address, arrays))

    def start(self, p: Array) -> Array:
        """Initial state for the numbers in p; the initial memory is put behind them, into p itself."""
        x, memory = np.empty(self.model.size), np.empty(len(self.model.memory))
        self.call("start", p, x, memory)
        p[len(self.model.parameters) :] = memory
        return x

    def with_memory(self, numbers: Array) -> Array:
        """Room for the memory behind the numbers: p as the compiled functions want it."""
        return np.concatenate([numbers, np.zeros(len(self.model.memory))])


def compile_kernel(model: Model, *, fuses: bool = True) -> Kernel:
    """Compile a model; milliseconds for a small circuit, linear in its size."""
    functions = traced_functions(model)
    rows, columns = functions["jacobian"].sparsity_out(1).get_triplet()
    step = print_step(model.size, len(model.states), len(model.inputs)) if model.size else ""
    return Kernel(
        model,
        compile_functions(functions, more=step, fuses=fuses),
        functions["jacobian"].nnz_out(1),
        functions["factor"].nnz_out(0),
        (np.array(rows, dtype=np.int64), np.array(columns, dtype=np.int64)),
    )
