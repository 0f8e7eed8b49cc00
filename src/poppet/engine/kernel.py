"""Compiled model: machine code of the functions that the integrator calls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.compiled import CALLED, CompiledFunctions, LaneFunctions, compile_functions
from poppet.engine.job import address
from poppet.engine.lru_cache import LruCache
from poppet.engine.model import Model
from poppet.engine.printers.instructions import SIGNATURES, trace_functions
from poppet.engine.printers.llvm_step import print_step
from poppet.engine.rosenbrock import scratch_size
from poppet.engine.tier import Tier

Array = NDArray[np.float64]
KERNELS: LruCache[Kernel] = LruCache(100)
"""Compiled models of this process by structure, and by the indices of selected outputs.

A changed parameter needs no compilation. Code is freed with the last kernel that uses it."""
LARGE = 20_000
"""Number of instructions above which the code of a model is first compiled without optimisation."""
SECONDS_PER_INSTRUCTION = 7e-5
"""Usual time in which LLVM optimises one instruction [s]."""


@dataclass(frozen=True, eq=False)
class Kernel:
    """Compiled model, which all circuits with the same structure share."""

    model: Model
    functions: CompiledFunctions
    # Number of nonzeros of J and of its factors.
    jacobian_size: int
    factor_size: int
    pattern: tuple[NDArray[np.int64], NDArray[np.int64]]  # row and column of each nonzero of J
    # By width, from `poppet.engine.lane_kernel`: functions that all kernels of a model share, and all functions.
    shared_lanes: dict[int, LaneFunctions] = field(default_factory=dict)
    lanes: dict[int, LaneFunctions] = field(default_factory=dict)
    tier: Tier | None = None  # of a large model

    @cached_property
    def job(self) -> dict[str, int]:
        """Arguments of the integrator that are equal for all runs, as fields of `Job`."""
        m, functions = self.model, self.functions.addresses
        # 0 for missing functions: `step` without states, `update` without discrete states.
        fields = {name: functions.get(name, 0) for name in CALLED}
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
        """Number of doubles that the integrator needs as working memory."""
        j = self.job
        # In the order of `_run_of` of the integrator: 12 vectors of states, tolerances, inputs with their slopes,
        # outputs, discrete states; then time and step, J, and the scratch memory of the printed step.
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
        """Tolerance scales of the controlled states, (3, n).

        The rows are the factor on the relative tolerance, the size below which the tolerance is constant (`floor` of
        `StateInfo`), and the nominal size.
        """
        states = self.model.states
        return np.array([[s.tolerance for s in states], [s.floor for s in states], [s.nominal for s in states]])

    @cached_property
    def positive(self) -> NDArray[np.bool_]:
        """Mask of the controlled states that must remain positive, (n,)."""
        return np.array([state.positive for state in self.model.states], dtype=np.bool_)

    @cached_property
    def acting(self) -> NDArray[np.bool_]:
        """Mask of the discrete states that affect the rates, (n_memory,)."""
        return np.array(self.model.acting, dtype=np.bool_)

    @cached_property
    def _callables(self) -> dict[str, Any]:
        import ctypes

        callables: dict[str, Any] = {}
        for name in SIGNATURES.keys() & self.functions.addresses.keys():
            count = len(SIGNATURES[name].replace("->", "").split())
            callables[name] = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * count)(self.functions.addresses[name])
            callables[name].owner = self.functions.owner  # a caller can outlive the kernel
        return callables

    def optimise(self) -> None:
        """Optimise the code of a large model now, because many runs follow."""
        if self.tier is not None:
            self.tier.optimise()

    def observing(self, outputs: Sequence[int]) -> Kernel:
        """Return a kernel that computes only the outputs with the given indices.

        All other machine code is shared. Fits use such kernels, because they need few outputs.
        """
        self.optimise()

        def compile_outputs() -> Kernel:
            import casadi as ca

            model, symbols = self.model, self.model.symbols
            # Only this function is compiled; the rest, most of the code, is shared.
            selected = ca.vertcat(*(model.expressions["outputs"][k] for k in outputs))
            arguments = [symbols[name] for name in ("t", "x", "u", "p")]
            code = compile_functions({"outputs": ca.Function("outputs", arguments, [ca.densify(selected)])})
            addresses = {**self.functions.addresses, **code.addresses}
            functions = CompiledFunctions(addresses, (self.functions.owner, code.owner))
            selected_outputs = tuple(model.outputs[k] for k in outputs)
            model = replace(model, outputs=selected_outputs, expressions={**model.expressions, "outputs": selected})
            return replace(self, model=model, functions=functions, lanes={})

        return KERNELS.get((self, tuple(outputs)), compile_outputs)

    def call(self, name: str, *arrays: Array) -> None:
        """Call a compiled model function by its name.

        The further arguments are its contiguous argument arrays, followed by the arrays into which it writes its
        results.
        """
        self.caller(name, *arrays)()

    def caller(self, name: str, *arrays: Array) -> Callable[[], None]:
        """Return a function without arguments that calls a compiled model function with fixed arrays.

        The further arguments are its argument arrays and its result arrays. The caller must keep references to the
        arrays, because only their addresses are stored.
        """
        return partial(self._callables[name], *map(address, arrays))

    def start(self, p: Array) -> Array:
        """Return the initial state for a parameter vector p.

        The method writes the initial discrete states into the end of p.
        """
        x, memory = np.empty(self.model.size), np.empty(len(self.model.memory))
        self.call("start", p, x, memory)
        p[len(self.model.parameters) :] = memory
        return x

    def with_memory(self, numbers: Array) -> Array:
        """Return the vector p: the parameter values `numbers`, then zeros for the discrete states."""
        return np.concatenate([numbers, np.zeros(len(self.model.memory))])


def compile_kernel(model: Model, *, fuses: bool = True) -> Kernel:
    """Compile a symbolic model to machine code.

    This takes milliseconds for a small circuit. The time increases linearly with the size of the model. The code of a
    large model does not fuse operations, and is first compiled without optimisation.
    """
    functions = trace_functions(model)
    size = sum(function.n_instructions() for function in functions.values())
    rows, columns = functions["jacobian"].sparsity_out(1).get_triplet()
    step = print_step(model.size, len(model.states), len(model.inputs)) if model.size else ""
    settings: dict[str, Any] = {"further_text": step, "fuses": fuses and size <= LARGE}
    code = compile_functions(functions, **settings, optimises=size <= LARGE)
    tier = None
    if code.switches:
        tier = Tier(code, lambda: compile_functions(trace_functions(model), **settings), size * SECONDS_PER_INSTRUCTION)
    return Kernel(
        model,
        code,
        functions["jacobian"].nnz_out(1),
        functions["factor"].nnz_out(0),
        (np.array(rows, dtype=np.int64), np.array(columns, dtype=np.int64)),
        tier=tier,
    )
