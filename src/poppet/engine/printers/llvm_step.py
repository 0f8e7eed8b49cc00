"""Printer (code generator) of a Rosenbrock step and its interpolant as LLVM IR.

A step is printed with the functions of the model instead of being part of the integrator: with a constant number of
states, each of its loops becomes a few vector instructions.
"""

from __future__ import annotations

from collections.abc import Sequence

from poppet.engine.printers.llvm import SCALAR, Kind, Text
from poppet.engine.rosenbrock import ARGUMENT, COUPLING, DENSE, GAMMA, INPUT_TIMES, STAGE_DRIFT, STAGE_TIME


def _add_weighted_sum(text: Text, index: str, weights: Sequence[float], start: str = "") -> str:
    """Add a weighted sum of solver stages at one state, and return its name.

    `index` is the index of the state, and `weights` the factor of each stage. `start` is added to the sum. The stages
    are the arrays %k0, %k1 and so on.
    """
    total = start
    for j, weight in enumerate(weights):
        stage = text.load(f"%k{j}", index)
        total = text.multiply_add(weight, stage, total) if total else text.times(weight, stage)
    return total


def _add_drift(text: Text, i: int, index: str, rates: str) -> str:
    """Add the sum of a rate and the drift term of a stage, and return its name.

    The drift is the time derivative of the rate. `i` is the index of the solver stage, `index` that of the state, and
    `rates` the name of the rate.
    """
    if STAGE_DRIFT[i] == 0.0:
        return rates
    return text.multiply_add(text.times(STAGE_DRIFT[i], "%h"), text.load("%ft", index), rates)


def print_step(n_states: int, n_controlled: int, n_inputs: int, kind: Kind = SCALAR) -> str:
    """Return LLVM IR of `step` (one Rosenbrock step) and `dense` (its interpolant).

    The arguments of `step` are time and length, state, inputs at `INPUT_TIMES`, and p; then rates, Jacobian and drift
    at the start, and scratch memory. The results are the six stages and the new state. Stage 5 is the error estimate.

    The quadratures (the states after the controlled ones) do not affect the rates, so only the last stage computes
    their argument.
    """
    text, d = Text(kind), kind.number
    for i in range(6):
        text.name(f"%k{i}", "%k", i * n_states)
    for name, offset in (("time", 1), ("f1", 2), ("right", 2 + n_states), ("lu", 2 + 2 * n_states)):
        text.name(f"%{name}", "%w", offset)
    text.lines.append(f"  %t = load {d}, ptr %th")
    text.lines.append(f"  %h = load {d}, ptr {text.at('%th', 1)}")
    text.lines.append(f"  %g = fdiv {d} {kind.words['one']}, %h")
    # Not `times`: a product that is fused into the subtractions of `factor` would depend on inlining.
    shift = text.emit(f"fmul {d} {kind.constant(1.0 / GAMMA)}, %g")
    text.lines += [f"  store {d} {shift}, ptr %w", "  call void @factor(ptr %j, ptr %w, ptr %lu)"]
    with text.loop(n_states) as index:
        text.store(_add_drift(text, 0, index, text.load("%f0", index)), "%right", index)
    text.lines.append("  call void @solve(ptr %lu, ptr %right, ptr %k0)")
    for i in range(1, 6):
        with text.loop(n_controlled if i < 5 and n_controlled else n_states) as index:
            text.store(_add_weighted_sum(text, index, ARGUMENT[i], text.load("%x0", index)), "%x1", index)
        time = text.multiply_add(STAGE_TIME[i], "%h", "%t")
        text.lines.append(f"  store {d} {time}, ptr %time")
        inputs = text.at("%us", INPUT_TIMES.index(STAGE_TIME[i]) * n_inputs)
        text.lines.append(f"  call void @rates(ptr %time, ptr %x1, ptr {inputs}, ptr %p, ptr %f1)")
        with text.loop(n_states) as index:
            coupled = _add_weighted_sum(text, index, COUPLING[i])
            total = text.multiply_add("%g", coupled, text.load("%f1", index))
            text.store(_add_drift(text, i, index, total), "%right", index)
        text.lines.append(f"  call void @solve(ptr %lu, ptr %right, ptr %k{i})")
    with text.loop(n_states) as index:
        # The method is stiffly accurate: the new state is the argument of the last stage plus the last stage.
        text.store(text.emit(f"fadd {d} {text.load('%x1', index)}, {text.load('%k5', index)}"), "%x1", index)
    declared = f"declare {d} @llvm.fmuladd.{kind.suffix}({d}, {d}, {d})"
    step = text.define("step", "%th %x0 %us %p %f0 %j %ft %w %k %x1")
    text = Text(kind)
    for i in range(5):
        text.name(f"%k{i}", "%k", i * n_states)
    text.name("%d1", "%d0", n_states)
    with text.loop(n_states) as index:
        for k in range(2):
            text.store(_add_weighted_sum(text, index, DENSE[k]), f"%d{k}", index)
    return "\n".join([declared, step, text.define("dense", "%k %d0")])
