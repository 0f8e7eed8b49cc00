"""The pieces of the integrator: inputs, errors and step sizes, rows, stop conditions, instants of the memory.

Compiled together with `poppet.engine.integrator`, which says how.
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
"""Places in `counts`; the last is the number of steps accepted before the window in which a stall is looked for."""
INTERNAL = 0.25
"""Relative tolerance of a step per unit of the one asked for: the errors of steps and of the interpolant add up. Chosen
so that the results, not the steps, keep the promise of `simulate`."""
STALL_WINDOW = 400
"""Attempts after which progress is judged: a window with more than 3 rejections in 10 that brings the run less than
1e-4 of its rest forward is a stall."""


class Functions(NamedTuple):
    """Addresses of the model's functions."""

    jacobian: Any
    step: Any
    dense: Any
    outputs: Any
    update: Any


class Memory(NamedTuple):
    """The numbers p, behind them the memory z; at an instant `fired` says which timers act, `after` is the new z."""

    p: Any
    z: Any
    acting: Any
    fired: Any
    after: Any


class Control(NamedTuple):
    """Relative and absolute tolerance and size of each controlled state (3, n_controlled), and which stay positive;
    longest step, most attempts; script."""

    tolerances: Any
    positive: Any
    longest: Any
    most: Any
    script: Any
    replays: Any


class Rows(NamedTuple):
    """Output times, what is written at them, and the outputs of the moment."""

    grid: Any
    table: Any
    y: Any


class Stops(NamedTuple):
    """Stop conditions."""

    places: Any
    weights: Any


class Work(NamedTuple):
    """Scratch: inputs now, at the stages of a step, and their slopes; time and length; at the begin of a step rates,
    their Jacobian and drift; then its new state, stages, error, interpolant, and a state inside it."""

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
    """All that a run shares from its begin to its end; x is the state."""

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
    """Inputs (n_inputs, 7) between two breakpoints."""

    start: Any
    stop: Any
    inputs: Any


class Step(NamedTuple):
    """A step just made from x to `new`: its begin, length and end (t + h but for rounding)."""

    t: Any
    h: Any
    end: Any
    new: Any


def caller(count: int) -> Any:
    """An intrinsic that calls machine code at an address with `count` arrays of doubles."""

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
    # Numba counts the arguments of an intrinsic by its signature, so it is written out.
    exec(f"def call(typing_context, address, {names}):\n    return typed(typing_context, address, {names})", scope)
    return intrinsic(scope["call"])


call2, call5, call6, call8, call10 = caller(2), caller(5), caller(6), caller(8), caller(10)


def pointer(kind: Any) -> Any:
    """An intrinsic from an address to a typed pointer."""

    def at(typing_context: Any, address: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return types.CPointer(kind)(types.int64), generate

    return intrinsic(at)


doubles_at, integers_at, flags_at = pointer(types.float64), pointer(types.int64), pointer(types.uint8)


compiled = njit(nogil=True, error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)


@compiled
def set_tolerances(control, scales, relative, x):
    """Tolerances of the controlled states, from their scales and the state at the start."""
    for s in range(scales.shape[1]):
        initial = abs(x[s])
        # What is never zero has a size of its own; a plate that happens to start near rest has not.
        size = initial if control.positive[s] and initial > 0.0 else scales[2, s]
        control.tolerances[0, s] = INTERNAL * relative * scales[0, s]
        control.tolerances[1, s] = control.tolerances[0, s] * scales[1, s] * size
        control.tolerances[2, s] = size


@compiled
def angle(c, dt):
    """Phase of a wave; whole turns are dropped, which keeps the digits of a late one."""
    turns = (c[3] + 0.5 * c[4] * dt) * dt
    return 2.0 * np.pi * (turns - np.floor(turns)) + c[5]


@compiled
def inputs_at(t, segment, u):
    """Inputs at a time inside a segment."""
    c = segment.inputs
    for k in range(u.size):
        dt = t - c[k, 6]
        value = c[k, 0] + c[k, 1] * dt
        if c[k, 2] != 0.0:
            value += c[k, 2] * np.sin(angle(c[k], dt))
        u[k] = value


@compiled
def input_slopes_at(t, segment, slopes):
    """Time derivatives of the inputs inside a segment."""
    c = segment.inputs
    for k in range(slopes.size):
        slope = c[k, 1]
        if c[k, 2] != 0.0:
            dt = t - c[k, 6]
            slope += 2.0 * np.pi * (c[k, 3] + c[k, 4] * dt) * c[k, 2] * np.cos(angle(c[k], dt))
        slopes[k] = slope


@compiled
def varies(segment):
    """True when an input changes inside a segment."""
    for k in range(segment.inputs.shape[0]):
        if segment.inputs[k, 1] != 0.0 or segment.inputs[k, 2] != 0.0:
            return True
    return False


@compiled
def stage_inputs(run, segment, t, h):
    """Inputs at the stages of a step, one set behind the other."""
    n = run.work.u.size
    for i in range(4):
        # Of four, which LLVM is told so: else it keeps an error for another place, and the text of that.
        inputs_at(t + INPUT_TIMES[i & 3] * h, segment, run.work.us[i * n : (i + 1) * n])


@compiled
def interpolate(run, step, theta, x):
    """State, or the begin of it, inside the step just made, theta from 0 to 1."""
    rest, n, dense = 1.0 - theta, run.x.size, run.work.dense
    for s in range(x.size):
        x[s] = rest * run.x[s] + theta * (step.new[s] + rest * (dense[s] + theta * dense[n + s]))


@compiled
def error(run):
    """Largest weighted error of the controlled states; infinite where a state left its domain."""
    worst, tolerances = 0.0, run.control.tolerances
    for s in range(tolerances.shape[1]):
        value = run.work.new[s]
        if not np.isfinite(value) or (run.control.positive[s] and value <= 0.0):
            return np.inf
        e = abs(run.work.estimate[s]) / (tolerances[1, s] + tolerances[0, s] * max(abs(run.x[s]), abs(value)))
        # So that an error that is no number is the worst.
        if not e <= worst:
            worst = e
    return worst


@compiled
def first_step(run, span):
    """A step over which no controlled state moves by more than a twentieth of its size."""
    fastest, tolerances = 20.0 / span, run.control.tolerances
    for s in range(tolerances.shape[1]):
        fastest = max(fastest, 20.0 * abs(run.work.rates[s]) / (abs(run.x[s]) + tolerances[2, s]))
    return 1.0 / fastest


@compiled
def begin(run, segment, t, h):
    """Rates, Jacobian and drift at the begin of a step; returns its length, chosen where none is known.

    A negative length asks for one that is not longer.
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
    """The same bits on every machine, which no library of powers promises."""
    return np.sqrt(np.sqrt(value))


@compiled
def growth(error, h, error_before, step_before):
    """Factor for the step after an accepted one, with the predictive control of Gustafsson."""
    factor = SAFETY / fourth_root(error)
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * fourth_root(error_before / (error * error)))
    return min(GROWTH, max(SHRINK, factor))


@compiled
def outputs_at(run, segment, t, x):
    """Outputs of a state at a time inside a segment."""
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
    """Index of the first stop condition that holds, or -1."""
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
    """Look for a stop condition in the middle and at the end of the step just made: its index and theta, or -1.

    The state at theta is left in `inside`.
    """
    low, high, event, x = 0.0, 0.5, -1, run.work.inside
    while True:
        interpolate(run, step, high, x)
        found = stop_condition(run, segment, step.t + high * step.h, x)
        if event < 0 and found < 0:
            if high == 1.0:
                return -1, 1.0
            low, high = 0.5, 1.0
            continue
        if found >= 0:
            event, theta = found, high
        else:
            low = high
        high = 0.5 * (low + theta)
        if (theta - low) * step.h <= 4e-16 * (step.t + step.h) or high <= low or high >= theta:
            interpolate(run, step, theta, x)
            return event, theta


@compiled
def length(wanted, remaining):
    """Length of the next step: never past the end of the segment, and no crumb left over."""
    if wanted < 0.5 * remaining:
        return wanted
    return 0.5 * remaining if wanted < remaining else remaining


@compiled
def write_rows(run, segment, step, until):
    """Write the rows inside the step just made, up to a time that is excluded: a row on it shows what comes after."""
    # The step is made, so the room of its drift is free; no output depends on a quadrature.
    before, grid, row = until - rounding(until), run.rows.grid, run.work.drift[: run.control.positive.size]
    while run.counts[COLUMN] < grid.size and grid[run.counts[COLUMN]] < before:
        t = grid[run.counts[COLUMN]]
        interpolate(run, step, max(0.0, (t - step.t) / step.h), row)
        write_row(run, segment, t, row)


@compiled
def take(run, new):
    """Make a state the current one."""
    x, books = run.x, run.books
    n = x.size
    for s in range(n):
        # Element by element: a slice assignment would cost a second of compile time.
        value = new[s]
        books[2 * n + s] += abs(value - x[s])
        x[s] = value
        books[s], books[n + s] = min(books[s], value), max(books[n + s], value)
    run.counts[ACCEPTED] += 1


@compiled
def rounding(t):
    """Instants closer than this are one."""
    return 1e-14 * t + 1e-15


@compiled
def next_instant(memory):
    """The earliest time among the timers."""
    first = np.inf
    for k in range(memory.fired.size):
        first = min(first, memory.z[k])
    return first


@compiled
def reach(run, segment, t, h, calm, lands):
    """Length wanted of a step, and where it has to end at the latest.

    That is the next instant of the memory, unless the instants have left the rates alone since `calm`: then a step may
    pass over as much time again, and they act on its interpolant.
    """
    wanted, goal = min(h, run.control.longest), segment.stop
    if run.memory.fired.size > 0:
        instant = next_instant(run.memory)
        if instant < goal - rounding(goal):
            if lands or instant - t >= t - calm:
                return wanted, instant
            wanted = min(wanted, t - calm)
    return wanted, goal


@compiled
def act(run, segment, t, x):
    """Let all timers act whose time has come; returns whether the rates have changed.

    A part may set a timer to the same instant again, so it goes on until none is left.
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
    """Let the instants inside the step just made act, rows before them written first.

    Returns where the step ends: at the first instant that changed the rates, whose state is left in `inside`, or as it
    was.
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
    """Why to give up after an attempt, or DONE to go on; a run that gets from instant to instant has not stalled."""
    counts, end = run.counts, run.rows.grid[-1]
    if counts[ATTEMPTS] % STALL_WINDOW == 0:
        slow = t - window < 1e-4 * (end - window) and not has_acted
        if counts[ACCEPTED] - counts[IN_WINDOW] < STALL_WINDOW * 7 // 10 and slow:
            return STALLED
        counts[IN_WINDOW] = counts[ACCEPTED]
    if counts[ATTEMPTS] >= run.control.most:
        return TOO_MANY
    return INTERRUPTED if run.watch[1] != 0.0 else DONE
