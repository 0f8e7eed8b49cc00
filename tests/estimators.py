"""Estimators of circuits for tests, also with all functions in C."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from c_compiler import shared_library
from poppet import Circuit
from poppet.circuit.free_numbers import free_numbers
from poppet.engine import compiled
from poppet.engine.compiled import CompiledFunctions, as_function
from poppet.engine.estimator_call import SIGNATURES, EstimatorCall, derivative_functions
from poppet.engine.estimator_job import EstimatorJob
from poppet.engine.job import Job
from poppet.engine.printers.c import print_function, print_step, used_prelude
from poppet.engine.printers.instructions import trace_functions
from poppet.engine.state_start import model_from_state


def estimator_of(
    circuit: Circuit,
    addresses: Sequence[str],
    outputs: Sequence[str],
    tolerance: float = 1e-6,
    *,
    fuses: bool = True,
    **bank: int,
) -> EstimatorCall:
    """An estimator at the initial state of a circuit, with the values of its free numbers."""
    instance = circuit.instance
    free = free_numbers(instance, addresses)
    model = model_from_state(circuit.symbolic_model)
    places = [[name for name, _ in model.outputs].index(output) for output in outputs]
    effects = np.zeros((len(outputs), len(addresses)))
    call = EstimatorCall(
        model, places, free.places, free.inputs, free.directions, effects, tolerance=tolerance, fuses=fuses, **bank
    )
    x, p = instance.start()
    numbers = instance.numbers()
    call.p[: numbers.size] = numbers
    call.p[len(model.parameters) :] = p[numbers.size :]
    call.u[:] = instance.held_inputs({})
    call.base[:], call.reference[:] = free.base(call.p, call.u[0]), free.values
    call.low[:], call.high[:] = free.low, free.high
    call.mean[:] = [*x[: len(model.states)], *free.values]
    call.noise[:] = 1.0
    return call


def move_to_c(
    call: EstimatorCall, outputs: Sequence[int], places: Sequence[int], inputs: Sequence[int], folder: Path
) -> None:
    """Let an estimator use functions that a C compiler has made from the printed model and the file of the package."""
    model = call.kernel.model
    functions = trace_functions(model) | derivative_functions(model, outputs, places, inputs)
    texts = [print_function(f, name, SIGNATURES.get(name, "")) for name, f in functions.items() if name != "energy"]
    texts += [print_step(model.size, len(model.inputs))] if model.size else []
    code = "\n\n".join(texts)
    core = Path(compiled.__file__).with_name("estimator.c").read_text(encoding="utf-8")
    sources = {"model.c": f"#include <math.h>\n\n{used_prelude(code)}\n\n{code}\n", "estimator.c": core}
    library = shared_library(sources, folder, "-std=c99", "-O2", "-ffp-contract=off")
    for rows, fields, names in (
        ([call._run], Job._fields, ("jacobian", "step", "dense", "outputs", "update")),
        (call._jobs, EstimatorJob._fields, tuple(SIGNATURES)),
    ):
        for name in names:
            function = getattr(library, name, None)
            for row in rows:
                address = 0 if function is None else ctypes.cast(function, ctypes.c_void_p).value
                row[fields.index(name)] = address
    entry = ctypes.cast(library.estimate, ctypes.c_void_p).value or 0
    call._function = as_function(CompiledFunctions({"estimate": entry}, library))
