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
    """Memory addresses of the compiled functions of a model."""

    jacobian: Any
    step: Any
    dense: Any
    outputs: Any
    update: Any


class Memory(NamedTuple):
    """Parameters and discrete states of a run.

    The array z is the end of p. At a sample instant, `fired` marks the timers that act, and `after` contains the new z.
    `acting` marks the discrete states that affect the rates.
    """

    p: Any
    z: Any
    acting: Any
    fired: Any
    after: Any


class Control(NamedTuple):
    """Data of the step control.

    `tolerances`, (3, n_controlled), contains relative tolerance, absolute tolerance and size of each controlled state.
    `positive` marks states that must be positive, and `script` contains step lengths.
    """

    tolerances: Any
    positive: Any
    longest: Any
    most: Any
    script: Any
    replays: Any


class OutputRows(NamedTuple):
    """Output times, table of outputs, and outputs y of the present output row."""

    grid: Any
    table: Any
    y: Any


class Stops(NamedTuple):
    """Stop conditions of a run, as arrays.

    The class `poppet.engine.problem.StopCondition` describes a single condition.
    """

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
    """All data of one run that the integrator uses.

    `x` is the state.
    """

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
    """Coefficients of the inputs, (n_inputs, 7), between two breakpoints `start` and `stop` [s]."""

    start: Any
    stop: Any
    inputs: Any


class Step(NamedTuple):
    """Completed step from x to `new`, with start t, length h and end.

    The end differs from t + h only by rounding.
    """

    t: Any
    h: Any
    end: Any
    new: Any


def caller(count: int) -> Any:
    """Return a Numba intrinsic that calls machine code with `count` arrays of doubles.

    The first argument of the intrinsic is the address of the code.
    """

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
    """Return a Numba intrinsic that converts an address to a pointer to numbers of type `kind`."""

    def at(typing_context: Any, address: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return types.CPointer(kind)(types.int64), generate

    return intrinsic(at)


doubles_at, integers_at, flags_at = pointer(types.float64), pointer(types.int64), pointer(types.uint8)


compiled = njit(nogil=True, error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)


@compiled
def set_tolerances(control, scales, relative, x):
    """Set the tolerances of the controlled states.

    They depend on the relative tolerance, on `Kernel.scales` and on the initial state x.
    """
    for s in range(scales.shape[1]):
        initial = abs(x[s])
        # Only positive states have a typical initial value; a plate can start near zero.
        size = initial if control.positive[s] and initial > 0.0 else scales[2, s]
        control.tolerances[0, s] = INTERNAL * relative * scales[0, s]
        control.tolerances[1, s] = control.tolerances[0, s] * scales[1, s] * size
        control.tolerances[2, s] = size


@compiled
def angle(c, dt):
    """Return the phase of a wave without complete turns [rad].

    Complete turns would reduce the accuracy at late times. c contains the coefficients of the segment, and dt is the
    time since its start.
    """
    turns = (c[3] + 0.5 * c[4] * dt) * dt
    return 2.0 * np.pi * (turns - np.floor(turns)) + c[5]


@compiled
def inputs_at(t, segment, u):
    """Write the inputs at the time t of a segment into u."""
    c = segment.inputs
    for k in range(u.size):
        dt = t - c[k, 6]
        value = c[k, 0] + c[k, 1] * dt
        if c[k, 2] != 0.0:
            value += c[k, 2] * np.sin(angle(c[k], dt))
        u[k] = value


@compiled
def input_slopes_at(t, segment, slopes):
    """Write the time derivatives of the inputs at the time t of a segment into `slopes`."""
    c = segment.inputs
    for k in range(slopes.size):
        slope = c[k, 1]
        if c[k, 2] != 0.0:
            dt = t - c[k, 6]
            slope += 2.0 * np.pi * (c[k, 3] + c[k, 4] * dt) * c[k, 2] * np.cos(angle(c[k], dt))
        slopes[k] = slope


@compiled
def varies(segment):
    """Return True if an input changes within a segment."""
    for k in range(segment.inputs.shape[0]):
        if segment.inputs[k, 1] != 0.0 or segment.inputs[k, 2] != 0.0:
            return True
    return False


@compiled
def stage_inputs(run, segment, t, h):
    """Compute the inputs at all solver stages of a step from t to t + h."""
    n = run.work.u.size
    for i in range(4):
        # The mask tells LLVM that the index is valid: otherwise the text contains an error message.
        inputs_at(t + INPUT_TIMES[i & 3] * h, segment, run.work.us[i * n : (i + 1) * n])


@compiled
def interpolate(run, step, theta, x):
    """Write the state inside a completed step into x, which can be shorter than the state.

    `theta` is the position in the step, from 0 to 1.
    """
    complement, n, dense = 1.0 - theta, run.x.size, run.work.dense
    for s in range(x.size):
        x[s] = complement * run.x[s] + theta * (step.new[s] + complement * (dense[s] + theta * dense[n + s]))


@compiled
def error(run):
    """Return the largest error of the controlled states in a step, relative to their tolerances.

    The result is infinite if a state is not finite, or is not positive although it must be.
    """
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
    """Return a length of the first step, from the rates of the controlled states.

    No state changes by more than a twentieth of its size, and the step is at most a twentieth of `span`.
    """
    fastest, tolerances = 20.0 / span, run.control.tolerances
    for s in range(tolerances.shape[1]):
        fastest = max(fastest, 20.0 * abs(run.work.rates[s]) / (abs(run.x[s]) + tolerances[2, s]))
    return 1.0 / fastest


@compiled
def begin(run, segment, t, h):
    """Compute rates, Jacobian and drift at the start of a step, and return the length of the step.

    If h is positive, it is the length. Otherwise, `first_step` selects the length; if h is negative, -h is the maximum.
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
    """Return the factor on the step length after an accepted step (predictive control of Gustafsson).

    `error` and h are the error and the length of the step. `error_before` and `step_before` are the error and the
    length of the previous step.
    """
    factor = SAFETY / fourth_root(error)
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * fourth_root(error_before / (error * error)))
    return min(GROWTH, max(SHRINK, factor))


@compiled
def outputs_at(run, segment, t, x):
    """Compute and return the outputs for the state x at the time t of a segment."""
    w, y = run.work, run.rows.y
    inputs_at(t, segment, w.u)
    w.tt[0] = t
    call5(run.functions.outputs, w.tt, x, w.u, run.memory.p, y)
    return y


@compiled
def write_row(run, segment, t, x):
    """Write the outputs for the state x at the time t into the next column of the output table."""
    y, column = outputs_at(run, segment, t, x), run.counts[COLUMN]
    for k in range(y.size):
        run.rows.table[k, column] = y[k]
    run.counts[COLUMN] = column + 1


@compiled
def stop_condition(run, segment, t, x):
    """Return the index of the first true stop condition for the state x at the time t, or -1."""
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
    """Return the index of the first stop condition in a completed step, and its position theta.

    The index is -1 if no condition is true. Conditions are evaluated in the middle and at the end of the step. The
    state at theta, from 0 to 1, is stored in `inside`.
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
    """Return the length of the next step, at most `remaining`.

    If the desired length is more than half of `remaining`, but not all of it, the result is half of `remaining`. This
    avoids a tiny last step.
    """
    if desired < 0.5 * remaining:
        return desired
    return 0.5 * remaining if desired < remaining else remaining


@compiled
def write_rows(run, segment, step, end):
    """Write the output rows inside a completed step before the time `end`.

    A row exactly at this time is written later, because it shows the values after an event.
    """
    # The memory of the drift is free after the step; no output depends on a quadrature.
    limit, grid, row = end - rounding(end), run.rows.grid, run.work.drift[: run.control.positive.size]
    while run.counts[COLUMN] < grid.size and grid[run.counts[COLUMN]] < limit:
        t = grid[run.counts[COLUMN]]
        interpolate(run, step, max(0.0, (t - step.t) / step.h), row)
        write_row(run, segment, t, row)


@compiled
def take(run, new):
    """Replace the state by `new`, and update extremes and sums of |change| of all states."""
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
    """Return the time difference below which two times count as equal [s]."""
    return 1e-14 * t + 1e-15


@compiled
def next_instant(memory):
    """Return the earliest time at which a timer is due [s], or infinity."""
    first = np.inf
    for k in range(memory.fired.size):
        first = min(first, memory.z[k])
    return first


@compiled
def reach(run, segment, t, h, calm, lands):
    """Return the desired length of a step from t, and the latest time at which it can end.

    The latest end is the next sample instant or the end of the segment. Since the time `calm`, sample instants have not
    changed the rates. A step can therefore continue past instants for a further duration of t - `calm`, unless `lands`
    is True. The interpolant of the step then gives the state at these instants.
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
    """Run all timers that are due at the time t, and return True if the rates have changed.

    A timer can be set to the same time again; the loop ends when no timer is due.
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
    """Run the timers that are due inside a completed step, and return the end of the step.

    Output rows before each instant are written first. The step ends early, with its state in `inside`, at the first
    instant that changes the rates.
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
    """Return the status that ends a run after an attempted step, or DONE if the run continues.

    A run has stalled if it advances little in `STALL_WINDOW` attempts since the time `window`, unless timers have
    acted.
    """
    counts, end = run.counts, run.rows.grid[-1]
    if counts[ATTEMPTS] % STALL_WINDOW == 0:
        slow = t - window < 1e-4 * (end - window) and not has_acted
        if counts[ACCEPTED] - counts[IN_WINDOW] < STALL_WINDOW * 7 // 10 and slow:
            return STALLED
        counts[IN_WINDOW] = counts[ACCEPTED]
    if counts[ATTEMPTS] >= run.control.most:
        return TOO_MANY
    return INTERRUPTED if run.watch[1] != 0.0 else DONE
