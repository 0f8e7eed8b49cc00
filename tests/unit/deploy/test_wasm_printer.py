"""WebAssembly without LLVM: every operation, on special values too, as machine code computes it."""

from __future__ import annotations

import base64
import ctypes
import json
import subprocess
from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np
import pytest

from javascript import needs_node
from poppet.deploy.live import wasm_printer
from poppet.deploy.live.page_kernel import kernel_script
from poppet.deploy.live.wasm_printer import print_module
from poppet.engine.compiled import compile_functions

SPECIAL = (0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.0, 3.7, -3.7, 1e-310, 1e300, np.inf, -np.inf, np.nan)
EXACT = ("add", "sub", "mul", "div", "fmin", "fmax", "lt", "le", "eq", "ne", "and", "or", "if_else_zero", "copysign")
SINGLE = ("assign", "neg", "sq", "twice", "inv", "not", "sign", "sqrt", "fabs", "floor", "ceil")
PROGRAM = """
const fs = require("fs");
const { code, name, pages, sizes, stack } = JSON.parse(fs.readFileSync(0, "utf8"));
const memory = new WebAssembly.Memory({ initial: pages });
const table = new WebAssembly.Table({ initial: 9, element: "anyfunc" });
const shared = { memory, table, stack: new WebAssembly.Global({ value: "i32", mutable: true }, stack) };
const module = new WebAssembly.Module(Buffer.from(code, "base64"));
const { exports } = new WebAssembly.Instance(module, { env: LIBRARY, shared });
const [given, length] = sizes, at = [stack, stack + 8 * given.length];
new Float64Array(memory.buffer, at[0]).set(given.map(Number));
try {
  exports[name](...at);
  console.log(JSON.stringify(Array.from(new BigUint64Array(memory.buffer, at[1], length), String)));
} catch (error) { console.log(JSON.stringify(String(error))); }
console.log(shared.stack.value);
"""


def in_node(functions: Mapping[str, Any], name: str, given: list[float], length: int, stack: int = 65536) -> Any:
    """Return the bits of the results of one function with one argument, and the stack pointer after the call."""
    pages = 1 + stack // 65536
    code, _ = print_module(functions, (0, 0, 0), tuple(functions), (), memory=pages)
    data: dict[str, Any] = {"code": base64.b64encode(code).decode(), "name": name}
    data |= {"pages": pages, "sizes": [[str(value) for value in given], length], "stack": stack}
    text = json.dumps(data).replace('"inf"', '"Infinity"').replace('"-inf"', '"-Infinity"').replace('"nan"', '"NaN"')
    output = subprocess.run(
        ["node", "-e", kernel_script() + PROGRAM], input=text, capture_output=True, text=True, check=False
    )
    assert output.returncode == 0, output.stderr
    first, second = output.stdout.splitlines()
    result = json.loads(first)
    return (np.array(result, dtype=np.uint64).view(float) if isinstance(result, list) else result), int(second)


def native(function: Any, given: list[float], length: int) -> np.ndarray:
    """Return the results of machine code without fused operations."""
    code = compile_functions({"f": function}, fuses=False)
    x, y = np.array(given), np.empty(length)
    ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(code.addresses["f"])(x.ctypes.data, y.ctypes.data)
    return y


def same_bits(first: np.ndarray, second: np.ndarray) -> bool:
    """Return True if all values are equal, with the signs of zeros; NaN has no defined sign."""
    is_equal = (first.view(np.uint64) == second.view(np.uint64)) | (np.isnan(first) & np.isnan(second))
    return bool(is_equal.all())


@needs_node
def test_every_exact_operation_gives_the_bits_of_machine_code():
    n = len(SPECIAL)
    x = ca.SX.sym("x", n)
    results = [ca.SX.unary(getattr(ca, f"OP_{name.upper()}"), x[k]) for name in SINGLE for k in range(n)]
    results += [
        ca.SX.binary(getattr(ca, f"OP_{name.upper()}"), x[i], x[k])
        for name in EXACT
        for i in range(n)
        for k in range(n)
    ]
    function = ca.Function("f", [x], [ca.densify(ca.vertcat(*results))])
    values, stack = in_node({"f": function}, "f", list(SPECIAL), len(results))
    assert same_bits(values, native(function, list(SPECIAL), len(results)))
    assert stack == 65536


def test_every_operation_of_machine_code_has_a_form():
    from poppet.engine.printers import llvm

    assert set(wasm_printer._FORMS) == set(llvm._FORMS) - {"inverse", "inverse_root"}


@needs_node
@pytest.mark.parametrize("exponent", [0.5, -0.5, 2.0, 0.25])
def test_powers_and_functions_of_the_library(exponent):
    given = [0.3, 1.7, exponent]
    x = ca.SX.sym("x", 3)
    one = [getattr(ca, name)(x[0]) for name in ("exp", "log", "sin", "cos", "tan", "tanh", "atan")]
    results = ca.vertcat(*one, ca.atan2(x[0], x[1]), ca.power(x[1], x[2]))
    function = ca.Function("f", [x], [results])
    values, _ = in_node({"f": function}, "f", given, 9)
    assert np.allclose(values, native(function, given, 9), rtol=4e-16, atol=0.0)
    if abs(exponent) == 0.5:
        assert values[-1] == (np.sqrt(1.7) if exponent > 0.0 else 1.0 / np.sqrt(1.7))


def long_function() -> Any:
    x = ca.SX.sym("x", 3)
    values = [x[0], x[1], x[2]]
    for k in range(200):
        values.append(ca.sin(values[k]) * values[k + 2] + values[k // 3])
    return ca.Function("f", [x], [ca.vertcat(*values[-40:])])


@needs_node
@pytest.mark.parametrize("size", [1, 7, 100, 10_000])
def test_blocks_pass_their_values(size, monkeypatch):
    monkeypatch.setattr(wasm_printer, "BLOCK_SIZE", size)
    whole, given = long_function(), [0.1, 0.7, -0.4]
    values, stack = in_node({"f": whole}, "f", given, 40)
    monkeypatch.setattr(wasm_printer, "BLOCK_SIZE", 100_000)
    assert same_bits(values, in_node({"f": whole}, "f", given, 40)[0])
    assert np.allclose(values, np.array(whole(given)).ravel(), rtol=1e-13)
    assert stack == 65536


@needs_node
def test_an_overflow_of_the_stack_is_a_trap(monkeypatch):
    monkeypatch.setattr(wasm_printer, "BLOCK_SIZE", 20)
    error, _ = in_node({"f": long_function()}, "f", [0.1, 0.7, -0.4], 40, stack=64)
    assert "out of bounds" in error
