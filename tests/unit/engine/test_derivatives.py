"""The Jacobian by elimination against CasADi's own, and what it saves."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from poppet import load
from poppet.engine.derivatives import differentiate_rates
from poppet.engine.printers.instructions import instructions

EXAMPLES = Path(__file__).parents[3] / "examples"


def both(rates: ca.SX, t: ca.SX, x: ca.SX, u: ca.SX, p: ca.SX) -> tuple[ca.Function, ca.Function]:
    """Rates, Jacobian and drift as the kernel has them, and as CasADi derives them."""
    slopes = ca.SX.sym("slopes", u.shape[0])
    moving = ca.jacobian(rates, t) + ca.jtimes(rates, u, slopes)
    found = differentiate_rates(rates, (t, x, u, p), slopes)
    known = rates, ca.jacobian(rates, x), moving
    arguments = [t, x, u, slopes, p]
    return tuple(ca.Function("each", arguments, ca.cse([*map(ca.densify, of)])) for of in (found, known))  # type: ignore[return-value]


@pytest.mark.parametrize("example", ["vertical_load", "pressure_regulator"])
def test_derivatives_equal_those_of_casadi(example):
    circuit = load(EXAMPLES / f"{example}.toml")
    model, kernel, generator = circuit.model, circuit.kernel, np.random.default_rng(7)
    own, casadis = both(model.expressions["rates"], *(model.symbols[name] for name in ("t", "x", "u", "p")))
    p = kernel.with_memory(np.array(list(circuit.parameters.values())))
    start, n, m = kernel.start(p), len(model.states), len(model.inputs)
    nominal, positive = (np.array([getattr(s, name) for s in model.states]) for name in ("nominal", "positive"))
    for _ in range(5):
        x = start.copy()
        moved = x[:n] + nominal * generator.uniform(-1.0, 1.0, n) * generator.choice([1.0, 1e-3, 1e-6])
        x[:n] = np.where(positive, x[:n] * generator.uniform(0.7, 1.4, n), moved)
        arguments = 0.1, x, generator.uniform(0.0, 1.0, m), generator.normal(size=m), p
        for a, b in zip(own.call(arguments), casadis.call(arguments), strict=True):
            a, b = np.array(a), np.array(b)
            size = np.abs(b).max(axis=1, keepdims=True) if b.shape[1] > 1 else np.abs(b).max()
            assert np.all(np.abs(a - b) <= 1e-11 * np.abs(b) + 1e-14 * size)
    counts = [sum(i.operation not in ("input", "output", "const") for i in instructions(f)) for f in (own, casadis)]
    assert counts[0] < 0.85 * counts[1]


def derivative_at(make, value: float) -> float:
    """Of a rate of one state."""
    x, none = ca.SX.sym("x"), ca.SX.sym("none", 0)
    jacobian = differentiate_rates(make(x), (ca.SX.sym("t"), x, none, none), none)[1]
    return float(ca.Function("slope", [x], [ca.densify(jacobian)])(value))


def test_unselected_branch_can_be_infinite():
    assert derivative_at(lambda x: ca.if_else(x > 0.0, ca.sqrt(3.0 * x) + x * x, 2.0 * x), -4.0) == 2.0
    assert derivative_at(lambda x: ca.if_else(x > 0.0, ca.exp(ca.sqrt(3.0 * x)), 2.0 * x), -4.0) == 2.0


@pytest.mark.parametrize(("value", "slope"), [(-1.0, 0.0), (0.5, 3.0), (2.0, 0.0)])
def test_limits_and_ties(value, slope):
    assert derivative_at(lambda x: ca.fmin(ca.fmax(3.0 * x, 0.0), 3.0), value) == slope
    # Of two that are equal one is the greater, and it is the same one for both.
    assert derivative_at(lambda x: ca.fmax(x, 2.0 * value - x) + ca.fmin(x, 2.0 * value - x), value) == 0.0


def test_constant_rate_has_no_derivative():
    x, none = ca.SX.sym("x", 2), ca.SX.sym("none", 0)
    rates, jacobian, drift = differentiate_rates(ca.vertcat(1.0, x[0]), (ca.SX.sym("t"), x, none, none), none)
    assert (rates.shape, jacobian.shape, jacobian.nnz(), drift.shape) == ((2, 1), (2, 2), 1, (2, 1))
