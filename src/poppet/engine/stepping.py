"""Functions of the integrator: inputs, errors, step sizes, rows, stop conditions and sample instants.

These functions are compiled together with `poppet.engine.integrator`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.extending import intrinsic

from poppet.engine.rosenbrock import GROWTH, INPUT_TIMES, SAFETY, SHRINK

DONE, STOPPED, STALLED, TOO_MANY, NOT_FINITE, INTERRUPTED = range(6)
ACCEPTED, ATTEMPTS, COLUMN, CONDITION, IN_WINDOW = range(5)
"""Indices in `counts`; the last counts the steps accepted before the window of the stall test."""
INTERNAL = 0.25
"""Factor on the relative tolerance for a step, because errors of steps and interpolant add up in the results."""
STALL_WINDOW = 400
"""Attempts between stall tests: a run stalls if more than 3 of 10 attempts are rejected and the run advances by less
than 1e-4 of the remaining time."""


class Functions(NamedTuple):
    """Addresses of the functions of the model."""

    jacobian: Any
    step: Any
    dense: Any
    outputs: Any
    update: Any


class Memory(NamedTuple):
    """Parameters and discrete state z in p; at an instant, timers that act (`fired`) and the new z (`after`)."""

    p: Any
    z: Any
    acting: Any
    fired: Any
    after: Any


class Control(NamedTuple):
    """Step control: tolerances and sizes of controlled states (3, n_controlled), positive states, limits, script."""

    tolerances: Any
    positive: Any
    longest: Any
    most: Any
    script: Any
    replays: Any


class OutputRows(NamedTuple):
    """Output times, table of outputs, and outputs of the current row."""

    grid: Any
    table: Any
    y: Any


class Stops(NamedTuple):
    """Stop conditions."""

    places: Any
    weights: Any


class Work(NamedTuple):
    """Scratch arrays of a step.

    They contain inputs, inputs at the stages, slopes of inputs, time and length; rates, Jacobian and drift at the
    start; stages, error estimate, new state, interpolant, and a state inside the step.
    """

    u: Any
    us: Any
    slopes: Any
    tt: Any
    rates: Any
    jacobian: Any
    drift: Any
    scratch: Any
    stages: Any
    estimate: Any
    new: Any
    dense: Any
    inside: Any


class RunState(NamedTuple):
    """Data of a run; x is the state."""

    functions: Any
    memory: Any
    control: Any
    rows: Any
    stops: Any
    work: Any
    x: Any
    books: Any
    watch: Any
    counts: Any


class Segment(NamedTuple):
    """Inputs, (n_inputs, 7), between two breakpoints."""

    start: Any
    stop: Any
    inputs: Any


class Step(NamedTuple):
    """Completed step from x to `new`: start, length and end (t + h with rounding errors)."""

    t: Any
    h: Any
    end: Any
    new: Any


def caller(count: int) -> Any:
    """Return an intrinsic that calls machine code at an address with `count` arrays of doubles."""

    def typed(typing_context: Any, address: Any, *arrays: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            pointer = ir.PointerType(ir.DoubleType())
            data = [
                builder.bitcast(context.make_array(kind)(context, builder, array).data, pointer)
                for kind, array in zip(signature.args[1:], arguments[1:], strict=True)
            ]
            kind = ir.FunctionType(ir.VoidType(), [pointer] * len(data))
            builder.call(builder.inttoptr(arguments[0], ir.PointerType(kind)), data)
            return context.get_dummy_value()

        return types.void(address, *arrays), generate

    names = ", ".join(f"a{k}" for k in range(count))
    scope: dict[str, Any] = {"typed": typed}
    # Numba requires an explicit signature of an intrinsic.
    exec(f"def call(typing_context, address, {names}):\n    return typed(typing_context, address, {names})", scope)
    return intrinsic(scope["call"])


call2, call5, call6, call8, call10 = caller(2), caller(5), caller(6), caller(8), caller(10)


def pointer(kind: Any) -> Any:
    """Return an intrinsic that converts an address to a typed pointer."""

    def at(typing_context: Any, address: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return types.CPointer(kind)(types.int64), generate

    return intrinsic(at)


doubles_at, integers_at, flags_at = pointer(types.float64), pointer(types.int64), pointer(types.uint8)


compiled = njit(nogil=True, error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)


@compiled
def set_tolerances(control, scales, relative, x):
    """Set the tolerances of the controlled states from their scales and the initial state."""
    for s in range(scales.shape[1]):
        initial = abs(x[s])
        # Only positive states have a typical initial value; a plate can start near zero.
        size = initial if control.positive[s] and initial > 0.0 else scales[2, s]
        control.tolerances[0, s] = INTERNAL * relative * scales[0, s]
        control.tolerances[1, s] = control.tolerances[0, s] * scales[1, s] * size
        control.tolerances[2, s] = size


@compiled
def angle(c, dt):
    """Return the phase of a wave without complete turns, to keep its digits at late times."""
    turns = (c[3] + 0.5 * c[4] * dt) * dt
    return 2.0 * np.pi * (turns - np.floor(turns)) + c[5]


@compiled
def inputs_at(t, segment, u):
    """Compute the inputs at a time in a segment."""
    c = segment.inputs
    for k in range(u.size):
        dt = t - c[k, 6]
        value = c[k, 0] + c[k, 1] * dt
        if c[k, 2] != 0.0:
            value += c[k, 2] * np.sin(angle(c[k], dt))
        u[k] = value


@compiled
def input_slopes_at(t, segment, slopes):
    """Compute the time derivatives of the inputs in a segment."""
    c = segment.inputs
    for k in range(slopes.size):
        slope = c[k, 1]
        if c[k, 2] != 0.0:
            dt = t - c[k, 6]
            slope += 2.0 * np.pi * (c[k, 3] + c[k, 4] * dt) * c[k, 2] * np.cos(angle(c[k], dt))
        slopes[k] = slope


@compiled
def varies(segment):
    """Return True if an input changes in a segment."""
    for k in range(segment.inputs.shape[0]):
        if segment.inputs[k, 1] != 0.0 or segment.inputs[k, 2] != 0.0:
            return True
    return False


@compiled
def stage_inputs(run, segment, t, h):
    """Compute the inputs at the stages of a step."""
    n = run.work.u.size
    for i in range(4):
        # The mask tells LLVM that the index is valid: otherwise the text contains an error message.
        inputs_at(t + INPUT_TIMES[i & 3] * h, segment, run.work.us[i * n : (i + 1) * n])


@compiled
def interpolate(run, step, theta, x):
    """Compute the first elements of the state inside a completed step, with theta from 0 to 1."""
    complement, n, dense = 1.0 - theta, run.x.size, run.work.dense
    for s in range(x.size):
        x[s] = complement * run.x[s] + theta * (step.new[s] + complement * (dense[s] + theta * dense[n + s]))


@compiled
def error(run):
    """Return the largest weighted error of the controlled states; infinite if a state is outside its domain."""
    worst, tolerances = 0.0, run.control.tolerances
    for s in range(tolerances.shape[1]):
        value = run.work.new[s]
        if not np.isfinite(value) or (run.control.positive[s] and value <= 0.0):
            return np.inf
        e = abs(run.work.estimate[s]) / (tolerances[1, s] + tolerances[0, s] * max(abs(run.x[s]), abs(value)))
        # This form also selects NaN.
        if not e <= worst:
            worst = e
    return worst


@compiled
def first_step(run, span):
    """Return a step length in which no controlled state changes by more than a twentieth of its size."""
    fastest, tolerances = 20.0 / span, run.control.tolerances
    for s in range(tolerances.shape[1]):
        fastest = max(fastest, 20.0 * abs(run.work.rates[s]) / (abs(run.x[s]) + tolerances[2, s]))
    return 1.0 / fastest


@compiled
def begin(run, segment, t, h):
    """Compute rates, Jacobian and drift at the start of a step, and return its length.

    If h is positive, it is the length. Otherwise `first_step` selects the length, which is at most -h if h is negative.
    """
    w = run.work
    w.tt[0] = t
    inputs_at(t, segment, w.u)
    input_slopes_at(t, segment, w.slopes)
    call8(run.functions.jacobian, w.tt, run.x, w.u, w.slopes, run.memory.p, w.rates, w.jacobian, w.drift)
    if h > 0.0:
        return h
    longest = first_step(run, segment.stop - t)
    return min(-h, longest) if h < 0.0 else longest


@compiled
def fourth_root(value):
    """Return the fourth root with identical bits on all machines, unlike the power function of a library."""
    return np.sqrt(np.sqrt(value))


@compiled
def growth(error, h, error_before, step_before):
    """Return the factor of the step after an accepted step, from the predictive control of Gustafsson."""
    factor = SAFETY / fourth_root(error)
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * fourth_root(error_before / (error * error)))
    return min(GROWTH, max(SHRINK, factor))


@compiled
def outputs_at(run, segment, t, x):
    """Return the outputs of a state at a time in a segment."""
    w, y = run.work, run.rows.y
    inputs_at(t, segment, w.u)
    w.tt[0] = t
    call5(run.functions.outputs, w.tt, x, w.u, run.memory.p, y)
    return y


@compiled
def write_row(run, segment, t, x):
    """Write the next row."""
    y, column = outputs_at(run, segment, t, x), run.counts[COLUMN]
    for k in range(y.size):
        run.rows.table[k, column] = y[k]
    run.counts[COLUMN] = column + 1


@compiled
def stop_condition(run, segment, t, x):
    """Return the index of the first true stop condition, or -1."""
    y, places, weights = outputs_at(run, segment, t, x), run.stops.places, run.stops.weights
    for k in range(weights.shape[0]):
        value = weights[k, 2]
        for j in range(2):
            if places[k, j] >= 0:
                value += weights[k, j] * y[places[k, j]]
        if value > 0.0:
            return k
    return -1


@compiled
def stop_inside(run, segment, step):
    """Return the first stop condition in a completed step and its theta, or -1.

    Conditions are evaluated in the middle and at the end of the step. The state at theta is stored in `inside`.
    """
    low, high, event, x = 0.0, 0.5, -1, run.work.inside
    while True:
        interpolate(run, step, high, x)
        condition = stop_condition(run, segment, step.t + high * step.h, x)
        if event < 0 and condition < 0:
            if high == 1.0:
                return -1, 1.0
            low, high = 0.5, 1.0
            continue
        if condition >= 0:
            event, theta = condition, high
        else:
            low = high
        high = 0.5 * (low + theta)
        if (theta - low) * step.h <= 4e-16 * (step.t + step.h) or high <= low or high >= theta:
            interpolate(run, step, theta, x)
            return event, theta


@compiled
def length(desired, remaining):
    """Return the length of the next step, which ends in the segment and leaves no tiny step."""
    if desired < 0.5 * remaining:
        return desired
    return 0.5 * remaining if desired < remaining else remaining


@compiled
def write_rows(run, segment, step, end):
    """Write the rows inside a completed step before a time; a row at that time shows the values after it."""
    # The memory of the drift is free after the step; no output depends on a quadrature.
    limit, grid, row = end - rounding(end), run.rows.grid, run.work.drift[: run.control.positive.size]
    while run.counts[COLUMN] < grid.size and grid[run.counts[COLUMN]] < limit:
        t = grid[run.counts[COLUMN]]
        interpolate(run, step, max(0.0, (t - step.t) / step.h), row)
        write_row(run, segment, t, row)


@compiled
def take(run, new):
    """Accept a new state, and update extremes and sums of |change|."""
    x, books = run.x, run.books
    n = x.size
    for s in range(n):
        # Per element: a slice assignment would need a second of compilation.
        value = new[s]
        books[2 * n + s] += abs(value - x[s])
        x[s] = value
        books[s], books[n + s] = min(books[s], value), max(books[n + s], value)
    run.counts[ACCEPTED] += 1


@compiled
def rounding(t):
    """Return the difference below which two instants are equal."""
    return 1e-14 * t + 1e-15


@compiled
def next_instant(memory):
    """Return the earliest time of the timers."""
    first = np.inf
    for k in range(memory.fired.size):
        first = min(first, memory.z[k])
    return first


@compiled
def reach(run, segment, t, h, calm, lands):
    """Return the desired length of a step and its latest end.

    The latest end is the next sample instant. If no instant has changed the rates since `calm`, a step can pass
    instants for the same duration again; they are then evaluated with its interpolant.
    """
    desired, goal = min(h, run.control.longest), segment.stop
    if run.memory.fired.size > 0:
        instant = next_instant(run.memory)
        if instant < goal - rounding(goal):
            if lands or instant - t >= t - calm:
                return desired, instant
            desired = min(desired, t - calm)
    return desired, goal


@compiled
def act(run, segment, t, x):
    """Run all timers that are due, and return True if the rates have changed.

    A timer can be set to the same instant again; the loop ends when no timer is due.
    """
    changed, w, m = False, run.work, run.memory
    due = t + rounding(t)
    while next_instant(m) <= due:
        for k in range(m.fired.size):
            m.fired[k] = 1.0 if m.z[k] <= due else 0.0
        w.tt[0] = t
        inputs_at(t, segment, w.u)
        call6(run.functions.update, w.tt, x, w.u, m.p, m.fired, m.after)
        for k in range(m.z.size):
            if m.acting[k] and m.after[k] != m.z[k]:
                changed = True
            m.z[k] = m.after[k]
    return changed


@compiled
def act_inside(run, segment, step):
    """Run the instants inside a completed step, after writing the rows before each, and return the end of the step.

    The step ends at the first instant that changes the rates, with its state in `inside`; else its end is unchanged.
    """
    while True:
        instant = next_instant(run.memory)
        if instant >= step.end - rounding(step.end):
            return step.end
        write_rows(run, segment, step, instant)
        interpolate(run, step, (instant - step.t) / step.h, run.work.inside)
        if act(run, segment, instant, run.work.inside):
            return instant


@compiled
def verdict(run, t, window, has_acted):
    """Return the status after an attempt, DONE to continue; a run that reaches a sample instant has not stalled."""
    counts, end = run.counts, run.rows.grid[-1]
    if counts[ATTEMPTS] % STALL_WINDOW == 0:
        slow = t - window < 1e-4 * (end - window) and not has_acted
        if counts[ACCEPTED] - counts[IN_WINDOW] < STALL_WINDOW * 7 // 10 and slow:
            return STALLED
        counts[IN_WINDOW] = counts[ACCEPTED]
    if counts[ATTEMPTS] >= run.control.most:
        return TOO_MANY
    return INTERRUPTED if run.watch[1] != 0.0 else DONE
