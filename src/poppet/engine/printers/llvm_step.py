"""Printer: one step of the Rosenbrock method, and its interpolant, for a given number of states as LLVM IR.

A step is printed next to the model's functions rather than written in the integrator: with the number of states known,
its loops become a few vector instructions each.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from poppet.engine.printers.llvm import Text
from poppet.engine.rosenbrock import (
    ARGUMENT,
    COUPLING,
    DENSE,
    GAMMA,
    INPUT_TIMES,
    STAGE_DRIFT,
    STAGE_TIME,
)


def _literal(value: float) -> str:
    return f"{value:.17e}"


class _StepText(Text):
    """Text of loops over `n` states; %k0, %k1 ... are the stages."""

    def __init__(self, n: int) -> None:
        super().__init__()
        self.n, self.loops = n, 0

    def name(self, name: str, pointer: str, offset: int) -> None:
        self.lines.append(f"  {name} = getelementptr inbounds double, ptr {pointer}, i64 {offset}")

    def multiply_add(self, a: str, b: str, c: str) -> str:
        return self.emit(f"call double @llvm.fmuladd.f64(double {a}, double {b}, double {c})")

    @contextmanager
    def each_state(self) -> Iterator[str]:
        """A loop; gives its index."""
        self.loops += 1
        k, index = self.loops, f"%n{self.loops}"
        self.lines += [f"  br label %before{k}", f"before{k}:", f"  br label %loop{k}", f"loop{k}:"]
        self.lines.append(f"  {index} = phi i64 [ 0, %before{k} ], [ {index}.next, %loop{k} ]")
        yield index
        self.lines += [
            f"  {index}.next = add nuw nsw i64 {index}, 1",
            f"  {index}.done = icmp eq i64 {index}.next, {self.n}",
            f"  br i1 {index}.done, label %after{k}, label %loop{k}",
            f"after{k}:",
        ]

    def weighted(self, index: str, weights: Sequence[float], start: str = "") -> str:
        """Sum of weights times stages at one state, added to `start`."""
        total = start
        for j, weight in enumerate(weights):
            stage = self.load(f"%k{j}", index)
            if total:
                total = self.multiply_add(_literal(weight), stage, total)
            else:
                total = self.emit(f"fmul contract double {_literal(weight)}, {stage}")
        return total

    def with_drift(self, i: int, index: str, rates: str) -> str:
        """Rates, and the drift of stage i times the step."""
        if STAGE_DRIFT[i] == 0.0:
            return rates
        slope = self.emit(f"fmul contract double {_literal(STAGE_DRIFT[i])}, %h")
        return self.multiply_add(slope, self.load("%ft", index), rates)


def print_step(n_states: int, n_inputs: int) -> str:
    """LLVM IR of `step` and `dense`.

    `step`: time and length, state, inputs at `INPUT_TIMES`, numbers, rates, Jacobian and drift at the begin; scratch;
    the six stages and the new state, both written. Stage 5 is the estimate of the error.
    """
    text = _StepText(n_states)
    for i in range(6):
        text.name(f"%k{i}", "%k", i * n_states)
    for name, offset in (("time", 1), ("f1", 2), ("right", 2 + n_states), ("lu", 2 + 2 * n_states)):
        text.name(f"%{name}", "%w", offset)
    text.lines.append("  %t = load double, ptr %th")
    text.lines.append(f"  %h = load double, ptr {text.at('%th', 1)}")
    text.lines.append("  %g = fdiv double 1.0, %h")
    shift = text.emit(f"fmul double {_literal(1.0 / GAMMA)}, %g")
    text.lines += [f"  store double {shift}, ptr %w", "  call void @factor(ptr %j, ptr %w, ptr %lu)"]
    with text.each_state() as index:
        text.store(text.with_drift(0, index, text.load("%f0", index)), "%right", index)
    text.lines.append("  call void @solve(ptr %lu, ptr %right, ptr %k0)")
    for i in range(1, 6):
        _print_stage(text, i, n_inputs)
    with text.each_state() as index:
        # The last stage is the difference of both orders: stiffly accurate, the new state is its argument and it.
        text.store(text.emit(f"fadd double {text.load('%x1', index)}, {text.load('%k5', index)}"), "%x1", index)
    names = ("th", "x0", "us", "p", "f0", "j", "ft", "w", "k", "x1")
    head = ["declare double @llvm.fmuladd.f64(double, double, double)"]
    head.append(f"define void @step({', '.join(f'ptr noalias nocapture %{name}' for name in names)}) nounwind {{")
    return "\n".join([*head, *text.lines, "  ret void", "}", "", _print_dense(n_states)])


def _print_stage(text: _StepText, i: int, n_inputs: int) -> None:
    """Argument, rates, right-hand side and linear system of stage i > 0."""
    with text.each_state() as index:
        text.store(text.weighted(index, ARGUMENT[i], text.load("%x0", index)), "%x1", index)
    time = text.multiply_add(_literal(STAGE_TIME[i]), "%h", "%t")
    text.lines.append(f"  store double {time}, ptr %time")
    inputs = text.at("%us", INPUT_TIMES.index(STAGE_TIME[i]) * n_inputs)
    text.lines.append(f"  call void @rates(ptr %time, ptr %x1, ptr {inputs}, ptr %p, ptr %f1)")
    with text.each_state() as index:
        coupled = text.weighted(index, COUPLING[i])
        total = text.multiply_add("%g", coupled, text.load("%f1", index))
        text.store(text.with_drift(i, index, total), "%right", index)
    text.lines.append(f"  call void @solve(ptr %lu, ptr %right, ptr %k{i})")


def _print_dense(n_states: int) -> str:
    """The two coefficients of the interpolant, one behind the other, from the stages."""
    text = _StepText(n_states)
    for i in range(5):
        text.name(f"%k{i}", "%k", i * n_states)
    text.name("%d1", "%d0", n_states)
    with text.each_state() as index:
        for k in range(2):
            text.store(text.weighted(index, DENSE[k]), f"%d{k}", index)
    head = "define void @dense(ptr noalias nocapture %k, ptr noalias nocapture %d0) nounwind {"
    return "\n".join([head, *text.lines, "  ret void", "}", ""])
