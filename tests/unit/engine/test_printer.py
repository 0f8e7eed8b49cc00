"""Printed LLVM code against CasADi's own evaluation, and the cutting of long functions into blocks."""

from __future__ import annotations

import ctypes
from typing import Any

import casadi as ca
import numpy as np
import pytest

from poppet.engine.compiled import compile_functions
from poppet.engine.printers import llvm as printer_llvm
from poppet.engine.printers.llvm import print_function

A, B = ca.SX.sym("a"), ca.SX.sym("b")

UNARY = {
    "sqrt": ca.sqrt(ca.fabs(A)),
    "exp": ca.exp(A),
    "log": ca.log(ca.fabs(A) + 1e-3),
    "sin": ca.sin(A),
    "cos": ca.cos(A),
    "tan": ca.tan(A),
    "tanh": ca.tanh(A),
    "atan": ca.atan(A),
    "fabs": ca.fabs(A),
    "floor": ca.floor(A),
    "ceil": ca.ceil(A),
    "neg": -A,
    "square": A**2,
    "twice": 2 * A,
    "inverse": 1 / A,
    "sign": ca.sign(A),
    "not": ca.logic_not(A),
}
BINARY = {
    "add": A + B,
    "sub": A - B,
    "mul": A * B,
    "div": A / B,
    "atan2": ca.atan2(A, B),
    "copysign": ca.copysign(A, B),
    "fmin": ca.fmin(A, B),
    "fmax": ca.fmax(A, B),
    "lt": A < B,
    "le": A <= B,
    "eq": A == B,
    "ne": A != B,
    "and": ca.logic_and(A, B),
    "or": ca.logic_or(A, B),
    "if_else": ca.if_else(A > B, A * B, A - B),
    "if_else_zero": ca.if_else(A > 0, B, 0),
    "pow": ca.fabs(A) ** B,
    "pow_half": ca.fabs(A) ** 0.5,
    "pow_constant": ca.fabs(A) ** 1.7,
    "constant": A + 1e-320 + B * 1e300 + 0.1,
    "pow_int": A**3,
}
VALUES = [-1e5, -2.0, -1.5, -1.0, -0.5, -1e-9, -0.0, 0.0, 1e-9, 0.5, 1.0, 1.5, 2.0, 3.7, 1e5]


def evaluated(function: Any, *arguments: np.ndarray) -> list[np.ndarray]:
    """Outputs of the machine code, each a vector of nonzeros."""
    compiled = compile_functions({"f": function})
    arrays = [np.ascontiguousarray(a, dtype=float) for a in arguments]
    outputs = [np.full(max(1, function.nnz_out(k)), np.nan) for k in range(function.n_out())]
    pointers = [array.ctypes.data for array in (*arrays, *outputs)]
    ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * len(pointers))(compiled.addresses["f"])(*pointers)
    return [out[: function.nnz_out(k)] for k, out in enumerate(outputs)]


def assert_same(function: Any, *arguments: np.ndarray) -> None:
    known = function(*arguments)
    known = known if isinstance(known, tuple) else (known,)
    for mine, his in zip(evaluated(function, *arguments), known, strict=True):
        np.testing.assert_allclose(mine, np.array(his.nonzeros()), rtol=4e-15, atol=0.0)


@pytest.mark.parametrize("name", UNARY)
def test_operation_of_one(name):
    function = ca.Function("f", [A], [ca.densify(UNARY[name])])
    compiled = compile_functions({"f": function})
    call = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(compiled.addresses["f"])
    out = np.empty(1)
    for value in VALUES:
        if value == 0.0 and name == "inverse":
            continue
        argument = np.array([value])
        call(argument.ctypes.data, out.ctypes.data)
        np.testing.assert_allclose(out[0], float(function(value)), rtol=4e-15, atol=0.0, err_msg=f"{name}({value})")


@pytest.mark.parametrize("name", BINARY)
def test_operation_of_two(name):
    function = ca.Function("f", [A, B], [ca.densify(BINARY[name])])
    compiled = compile_functions({"f": function})
    call = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 3)(compiled.addresses["f"])
    out = np.empty(1)
    for a in VALUES:
        for b in VALUES:
            if (name == "div" and b == 0.0) or (name == "pow" and (abs(b) > 10.0 or a == 0.0)):
                continue
            first, second = np.array([a]), np.array([b])
            call(first.ctypes.data, second.ctypes.data, out.ctypes.data)
            np.testing.assert_allclose(out[0], float(function(a, b)), rtol=4e-15, atol=0.0, err_msg=f"{name}({a}, {b})")


def test_run_time_exponents():
    """A half is the usual one and takes a short way; every other goes through pow."""
    function = ca.Function("f", [A, B], [A**B])
    for exponent in (0.5, -0.5, 0.6, 1.0, 2.0, 0.0, 0.49999999999999994):
        for base in (0.0, 1e-12, 0.3, 1.0, 7.0):
            if base == 0.0 and exponent < 0.0:
                continue
            (out,) = evaluated(function, np.array([base]), np.array([exponent]))
            assert out[0] == pytest.approx(base**exponent, rel=2e-15, abs=0.0)


def test_not_a_number_is_propagated():
    """A state that is no number must show in the error, or the step would be taken."""
    function = ca.Function("f", [A, B], [A * B + ca.sqrt(A)])
    assert np.isnan(evaluated(function, np.array([np.nan]), np.array([1.0]))[0][0])
    assert np.isnan(evaluated(function, np.array([-1.0]), np.array([1.0]))[0][0])


def test_sparse_outputs_are_their_nonzeros():
    x = ca.SX.sym("x", 4)
    function = ca.Function("f", [x], [ca.jacobian(ca.vertcat(x[0] * x[3], x[1], x[2] ** 3), x)])
    (out,) = evaluated(function, np.array([1.0, 2.0, 3.0, 4.0]))
    assert out.tolist() == [4.0, 1.0, 27.0, 1.0]


def random_function(operations: int, seed: int) -> Any:
    """A long function whose every value may be used much later."""
    generator = np.random.default_rng(seed)
    x = ca.SX.sym("x", 5)
    values = [x[k] for k in range(5)]
    for _ in range(operations):
        i, j = generator.integers(0, len(values), 2)
        kind = generator.integers(0, 5)
        a, b = values[i], values[j]
        values.append([ca.sin(a) + b, ca.tanh(a - b), a * ca.cos(b), ca.fmax(a, b), ca.if_else(a > b, a, -b)][kind])
    return ca.Function("f", [x], [ca.vertcat(*values[-7:]), sum(ca.tanh(v) for v in values[5:])])


@pytest.mark.parametrize("block_size", [1, 2, 7, 50, 10_000])
def test_blocks_pass_their_values(monkeypatch, block_size):
    monkeypatch.setattr(printer_llvm, "BLOCK_SIZE", block_size)
    assert_same(random_function(120, 1), np.array([0.3, -0.7, 1.1, 0.01, -2.0]))


def test_long_functions_are_divided_into_blocks():
    function = random_function(1000, 2)
    text = print_function(function, "f")
    assert function.n_instructions() > printer_llvm.BLOCK_SIZE
    assert text.count("define internal void @f.") == -(-function.n_instructions() // printer_llvm.BLOCK_SIZE)
    assert_same(function, np.array([0.3, -0.7, 1.1, 0.01, -2.0]))


def test_an_operation_without_a_form_is_named():
    with pytest.raises(NotImplementedError, match="no LLVM form for the CasADi operation erf"):
        print_function(ca.Function("f", [A], [ca.erf(A)]), "f")
