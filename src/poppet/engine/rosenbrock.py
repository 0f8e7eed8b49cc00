"""The Rosenbrock method: its coefficients, and one step of it printed for a model of given size.

RODAS (Hairer & Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, section VI.4): six stages, order 4(3),
stiffly accurate, L-stable, with an interpolant of order 3. A step is printed next to the model's functions rather than
written in the integrator: with the number of states known, its loops become a few vector instructions each.
"""

from __future__ import annotations

from collections.abc import Sequence

GAMMA = 0.25
STAGE_TIME = (0.0, 0.386, 0.21, 0.63, 1.0, 1.0)
STAGE_DRIFT = (0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0)
ARGUMENT = (
    (),
    (1.544,),
    (0.9466785280815826, 0.2557011698983284),
    (3.314825187068521, 2.896124015972201, 0.9986419139977817),
    (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950),
    (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0),
)
"""Weights of the stages before it in the argument of each stage."""
COUPLING = (
    (),
    (-5.6688,),
    (-2.430093356833875, -0.2063599157091915),
    (-0.1073529058151375, -9.594562251023355, -20.47028614809616),
    (7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160),
    (8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054),
)
"""Weights of the stages before it in the right-hand side of each stage, to be divided by the step."""
DENSE = (
    (10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662),
    (-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872),
)
"""Weights of the stages in the two coefficients of the interpolant."""
INPUT_TIMES = (0.386, 0.21, 0.63, 1.0)
"""Fractions of the step at which the inputs are needed; stages 5 and 6 share the last."""
SCRATCH = 2
"""Doubles of scratch before the vectors: 1/(h gamma) and the stage's time."""


def scratch_size(n_states: int, factor_size: int) -> int:
    """Doubles of scratch memory that a printed step needs."""
    return SCRATCH + 2 * n_states + factor_size


class _Text:
    """Lines of LLVM IR with fresh names."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.count = 0

    def emit(self, text: str) -> str:
        self.count += 1
        name = f"%s{self.count}"
        self.lines.append(f"  {name} = {text}")
        return name

    def at(self, pointer: str, offset: int | str) -> str:
        return self.emit(f"getelementptr inbounds double, ptr {pointer}, i64 {offset}")

    def load(self, pointer: str, offset: int | str) -> str:
        return self.emit(f"load double, ptr {self.at(pointer, offset)}")

    def multiply_add(self, a: str, b: str, c: str) -> str:
        return self.emit(f"call double @llvm.fmuladd.f64(double {a}, double {b}, double {c})")


def _literal(value: float) -> str:
    return f"{value:.17e}"


class _StepPrinter(_Text):
    """Prints a step for `n` states and `n_u` inputs."""

    def __init__(self, n: int, n_u: int) -> None:
        super().__init__()
        self.n, self.n_u, self.loops = n, n_u, 0

    def begin_loop(self) -> tuple[str, str]:
        """Open a loop over the states; returns its label and index."""
        self.loops += 1
        label, index = f"loop{self.loops}", f"%n{self.loops}"
        self.lines += [f"  br label %before{self.loops}", f"before{self.loops}:", f"  br label %{label}", f"{label}:"]
        self.lines.append(f"  {index} = phi i64 [ 0, %before{self.loops} ], [ {index}.next, %{label} ]")
        return label, index

    def end_loop(self, label: str, index: str) -> None:
        self.lines += [
            f"  {index}.next = add nuw nsw i64 {index}, 1",
            f"  {index}.done = icmp eq i64 {index}.next, {self.n}",
            f"  br i1 {index}.done, label %after{self.loops}, label %{label}",
            f"after{self.loops}:",
        ]

    def weighted(self, index: str, weights: Sequence[float], start: str | None) -> str:
        """Sum of weights times stages at one state, added to `start`."""
        total = start
        for j, weight in enumerate(weights):
            stage = self.load(f"%k{j}", index)
            if total is None:
                total = self.emit(f"fmul contract double {_literal(weight)}, {stage}")
            else:
                total = self.multiply_add(_literal(weight), stage, total)
        assert total is not None
        return total

    def store(self, value: str, pointer: str, index: str) -> None:
        self.lines.append(f"  store double {value}, ptr {self.at(pointer, index)}")

    def stage(self, i: int) -> None:
        """Argument, rates, right-hand side and linear system of stage i > 0."""
        label, index = self.begin_loop()
        self.store(self.weighted(index, ARGUMENT[i], self.load("%x0", index)), "%x1", index)
        self.end_loop(label, index)
        time = self.multiply_add(_literal(STAGE_TIME[i]), "%h", "%t")
        self.lines.append(f"  store double {time}, ptr %time")
        inputs = self.at("%us", INPUT_TIMES.index(STAGE_TIME[i]) * self.n_u)
        self.lines.append(f"  call void @rates(ptr %time, ptr %x1, ptr {inputs}, ptr %p, ptr %f1)")
        label, index = self.begin_loop()
        coupled = self.weighted(index, COUPLING[i], None)
        total = self.multiply_add("%g", coupled, self.load("%f1", index))
        if STAGE_DRIFT[i] != 0.0:
            slope = self.emit(f"fmul contract double {_literal(STAGE_DRIFT[i])}, %h")
            total = self.multiply_add(slope, self.load("%ft", index), total)
        self.store(total, "%right", index)
        self.end_loop(label, index)
        self.lines.append(f"  call void @solve(ptr %lu, ptr %right, ptr %k{i})")


def print_step(n_states: int, n_inputs: int) -> str:
    """LLVM IR of one step and of its interpolant."""
    p = _StepPrinter(n_states, n_inputs)
    for i in range(6):
        p.lines.append(f"  %k{i} = getelementptr inbounds double, ptr %k, i64 {i * n_states}")
    for name, offset in (("time", 1), ("f1", 2), ("right", 2 + n_states), ("lu", 2 + 2 * n_states)):
        p.lines.append(f"  %{name} = getelementptr inbounds double, ptr %w, i64 {offset}")
    p.lines.append("  %t = load double, ptr %th")
    p.lines.append(f"  %h = load double, ptr {p.at('%th', 1)}")
    p.lines.append("  %g = fdiv double 1.0, %h")
    shift = p.emit(f"fmul double {_literal(1.0 / GAMMA)}, %g")
    p.lines += [f"  store double {shift}, ptr %w", "  call void @factor(ptr %j, ptr %w, ptr %lu)"]
    label, index = p.begin_loop()
    slope = p.emit(f"fmul contract double {_literal(STAGE_DRIFT[0])}, %h")
    p.store(p.multiply_add(slope, p.load("%ft", index), p.load("%f0", index)), "%right", index)
    p.end_loop(label, index)
    p.lines.append("  call void @solve(ptr %lu, ptr %right, ptr %k0)")
    for i in range(1, 6):
        p.stage(i)
    label, index = p.begin_loop()
    p.store(p.emit(f"fadd double {p.load('%x1', index)}, {p.load('%k5', index)}"), "%x1", index)
    p.end_loop(label, index)
    names = ("th", "x0", "us", "p", "f0", "j", "ft", "w", "k", "x1")
    head = ["declare double @llvm.fmuladd.f64(double, double, double)"]
    head.append(f"define void @step({', '.join(f'ptr noalias nocapture %{name}' for name in names)}) nounwind {{")
    return "\n".join([*head, *p.lines, "  ret void", "}", "", _print_dense(n_states)])


def _print_dense(n_states: int) -> str:
    p = _StepPrinter(n_states, 0)
    for i in range(5):
        p.lines.append(f"  %k{i} = getelementptr inbounds double, ptr %k, i64 {i * n_states}")
    p.lines.append(f"  %d1 = getelementptr inbounds double, ptr %d0, i64 {n_states}")
    label, index = p.begin_loop()
    for k in range(2):
        p.store(p.weighted(index, DENSE[k], None), f"%d{k}", index)
    p.end_loop(label, index)
    head = "define void @dense(ptr noalias nocapture %k, ptr noalias nocapture %d0) nounwind {"
    return "\n".join([head, *p.lines, "  ret void", "}", ""])
