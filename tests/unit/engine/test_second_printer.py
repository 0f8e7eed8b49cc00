"""The second reader of the list of instructions, C, against the kernel and CasADi's own evaluation."""

from __future__ import annotations

import ctypes
from pathlib import Path

import numpy as np
import pytest

from c_compiler import shared_library
from poppet import Circuit, load
from poppet.engine.printers.c import print_function, used_prelude
from poppet.engine.printers.instructions import SIGNATURES, trace_functions

EXAMPLES = Path(__file__).parents[3] / "examples"
CIRCUITS = {
    "main stage": "fill_staircase",
    "regulator": "pressure_regulator",
    "sampled": "pressure_control",
    "bristles": "vertical_load",
}
CHANGES = {"bristles": {"load.friction.kind": "elasto_plastic"}}


@pytest.fixture(scope="module", params=CIRCUITS)
def circuit(request: pytest.FixtureRequest) -> Circuit:
    return load(EXAMPLES / f"{CIRCUITS[request.param]}.toml").with_values(CHANGES.get(request.param, {}))


@pytest.fixture(scope="module")
def library(circuit: Circuit, tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    functions = trace_functions(circuit.model)
    text = "\n\n".join(print_function(f, name) for name, f in functions.items())
    sources = {"model.c": "\n\n".join(["#include <math.h>", used_prelude(text), text, ""])}
    return shared_library(sources, tmp_path_factory.mktemp("c"))


def random_arguments(circuit: Circuit, seed: int) -> list[np.ndarray]:
    """Time, state, inputs, and numbers with the memory, somewhere in the working range; all timers have come."""
    generator, kernel = np.random.default_rng(seed), circuit.kernel
    p = kernel.with_memory(np.array(list(circuit.parameters.values())))
    x = kernel.start(p)
    nominal = np.array([state.nominal for state in circuit.model.states])
    is_positive = np.array([state.positive for state in circuit.model.states])
    moved = generator.uniform(0.5, 2.0, nominal.size) * x[: nominal.size]
    free = generator.uniform(-1.0, 1.0, nominal.size) * nominal
    x[: nominal.size] = np.where(is_positive, moved, free)
    p[len(circuit.parameters) :] += generator.uniform(0.0, 1.0, len(circuit.model.memory))
    defaults = (item.default for item in circuit.model.inputs)
    u = np.array([circuit.parameters[each] if isinstance(each, str) else each for each in defaults])
    u *= generator.uniform(0.5, 2.0, u.size)
    return [np.array([generator.uniform(0.0, 10.0)]), x, np.append(u, 0.0), p, np.ones(circuit.model.n_timers)]


@pytest.mark.parametrize("name", ["rates", "outputs", "update"])
def test_plain_c_gives_the_kernels_numbers(circuit, library, name):
    function = trace_functions(circuit.model).get(name)
    if function is None:
        assert name == "update"
        assert not circuit.model.memory
        return
    assert len(SIGNATURES[name].split()) == function.n_in() + function.n_out() + 1
    found, kept, known = [], [], []
    for seed in range(50):
        arguments = random_arguments(circuit, seed)[: function.n_in()]
        mine, theirs = np.empty(function.nnz_out(0)), np.empty(function.nnz_out(0))
        library[name](*(ctypes.c_void_p(a.ctypes.data) for a in (*arguments, mine)))
        circuit.kernel.call(name, *arguments, theirs)
        sized = [a[: function.nnz_in(k)] for k, a in enumerate(arguments)]
        found.append(mine), kept.append(theirs), known.append(np.array(function(*sized)).ravel())
    a, b, c = np.array(found), np.array(kept), np.array(known)
    # CasADi does the same operations one by one. The kernel fuses multiplications and additions.
    assert np.array_equal(a, c)
    size = np.abs(b).max(axis=0)
    assert np.all(np.abs(a - b) <= 1e-12 * (np.abs(b) + size)), np.max(np.abs(a - b) / (np.abs(b) + size))
    assert np.ptp(b, axis=0).astype(bool).sum() >= 3
