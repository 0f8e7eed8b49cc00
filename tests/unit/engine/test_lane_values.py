"""Functions rewritten for lanes: the same numbers with fewer divisions, and what numbers alone decide taken out."""

from __future__ import annotations

import ctypes
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from poppet import load
from poppet.engine.lane_kernel import WIDTHS, _compile, lane_functions
from poppet.engine.printers.instructions import Instruction, InstructionList, trace_functions
from poppet.engine.printers.lane_values import _Values, lane_listings
from poppet.engine.printers.llvm import Kind, print_function

sys.path.insert(0, str(Path(__file__).parent))
from test_second_printer import random_arguments

EXAMPLES = Path(__file__).parents[3] / "examples"


def aligned(rows: np.ndarray, width: int) -> np.ndarray:
    """Each number in all lanes, from where the widest element may begin."""
    block = np.zeros(rows.size * width + 8)
    first = -block.ctypes.data % 64 // 8
    found = block[first : first + rows.size * width].reshape(rows.size, width)
    found[:] = rows[:, np.newaxis]
    return found


@pytest.mark.parametrize(("name", "width"), [("fill_staircase", 8), ("fill_staircase", 4), ("pressure_control", 2)])
def test_lanes_compute_what_the_kernel_does(name, width):
    kernel = load(EXAMPLES / f"{name}.toml").kernel
    functions, n_j = lane_functions(kernel, width), kernel.jacobian_size

    def call(name: str, *arrays: np.ndarray) -> None:
        kind = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * len(arrays))
        kind(functions.addresses[name])(*(each.ctypes.data for each in arrays))

    for seed in range(5):
        t, x, u, p, _ = random_arguments(load(EXAMPLES / f"{name}.toml"), seed)
        slopes = np.random.default_rng(seed).normal(size=u.size)
        for given, jacobian in ((slopes, "jacobian"), (np.zeros(u.size), "jacobian_held")):
            known = [np.empty(x.size), np.empty(n_j), np.empty(x.size)]
            kernel.call("jacobian", t, x, u, given, p, *known)
            lanes = [aligned(each, width) for each in (t, x, u, given, np.append(p, np.zeros(functions.n_derived)))]
            found = [aligned(np.full(each.size, np.nan), width) for each in known]
            call("derived", lanes[-1], lanes[-1][p.size :])
            call(jacobian, *lanes, *found)
            for one, other in zip(found, known, strict=True):
                assert np.allclose(
                    one, other[:, np.newaxis], rtol=1e-11, atol=1e-12 * np.max(np.abs(other), initial=0.0)
                )
                assert np.ptp(one, axis=1).max() == 0.0


def test_parameter_expressions_are_computed_once_and_divisors_shared():
    model = load(EXAMPLES / "fill_staircase.toml").model
    functions = trace_functions(model)
    listings, n_derived = lane_listings(functions, model)
    count = {name: [each.operation for each in listed.instructions].count for name, listed in listings.items()}
    assert all(of("div") == 0 for of in count.values())
    assert n_derived == count["derived"]("output") > 15
    plain = [functions["jacobian"].instruction_id(k) for k in range(functions["jacobian"].n_instructions())]
    assert 3 * (count["jacobian"]("inverse") + count["jacobian"]("inverse_root")) < plain.count(ca.OP_DIV)
    assert len(listings["jacobian_held"].instructions) < len(listings["jacobian"].instructions)


@pytest.mark.parametrize("width", WIDTHS[1:])
def test_operations_of_lanes_alone(width):
    numbers = np.array([0.0, 1e-300, 0.3, 2.0, 1e300, np.inf, np.nan, -1.0])
    done = [Instruction("inverse", 1, (0,)), Instruction("inverse_root", 2, (0,))]
    written = [Instruction("output", -1, (1 + k,), place=(0, k)) for k in range(2)]
    kind = Kind(width)
    code = _compile(
        kind, [print_function(InstructionList([Instruction("input", 0, ()), *done, *written], 1, 1), "f", kind)], ("f",)
    )
    call = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(code.addresses["f"])
    for a in numbers:
        given, found = aligned(np.array([a]), width), aligned(np.zeros(2), width)
        call(given.ctypes.data, found.ctypes.data)
        with np.errstate(all="ignore"):
            known = [1.0 / a, 1.0 / np.sqrt(a)]
        np.testing.assert_allclose(found[:, 0], known, rtol=1e-15, atol=0.0)
        assert np.array_equal(found, np.repeat(found[:, :1], width, axis=1), equal_nan=True)


def test_rules():
    values = _Values(2)
    a, b, x, z = (values._index("input", *place) for place in (("p", 0), ("p", 1), ("x", 0), ("p", 2)))
    put, constant = values.put, values.constant
    assert [values.is_fixed[each] for each in (a, x, z, put("mul", a, b), put("mul", a, z))] == [1, 0, 0, 1, 0]
    assert put("mul", a, put("mul", x, b)) == put("mul", put("mul", a, b), x)
    assert put("div", put("twice", a), put("twice", x)) == put("div", a, x) == put("mul", a, put("inv", x))
    assert put("inv", put("twice", x)) == put("mul", constant(0.5), put("inv", x))
    assert put("inv", put("sqrt", x)) == put("inverse_root", x)
    assert put("div", x, constant(4.0)) == put("mul", x, constant(0.25))
    zero = constant(0.0)
    for left in (put("mul", zero, x), put("mul", x, zero), put("div", zero, x), put("if_else_zero", x, zero)):
        assert left == zero
    assert put("add", zero, x) == put("add", x, zero) == put("sub", x, zero) == put("mul", x, constant(1.0)) == x
    assert put("sub", zero, x) == put("neg", x)
