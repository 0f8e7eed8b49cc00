"""The pieces of the integrator: inputs, errors and step sizes, rows, stop conditions, instants of the memory.

Compiled together with `poppet.engine.integrator`, which says how.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.extending import intrinsic

DONE, STOPPED, STALLED, TOO_MANY, NOT_FINITE, INTERRUPTED = range(6)
JACOBIAN, STEP, DENSE, OUTPUTS, UPDATE = range(5)
INPUT_TIMES = (0.386, 0.21, 0.63, 1.0)
GROWTH, SHRINK, SAFETY = 6.0, 0.15, 0.9
STALL_WINDOW = 400
"""Attempts after which progress is judged: a window with more than 3 rejections in 10 that brings the run less than
1e-4 of its rest forward is a stall."""


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
    exec(f"def call(typing_context, address, {names}):\n    return typed(typing_context, address, {names})", scope)
    return intrinsic(scope["call"])


call2, call5, call6, call8, call10 = caller(2), caller(5), caller(6), caller(8), caller(10)


compiled = njit(nogil=True, error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)


@compiled
def inputs_at(t, start, coefficients, u):
    """Inputs at a time inside one segment."""
    dt = t - start
    for k in range(u.size):
        value = coefficients[k, 0] + coefficients[k, 1] * dt
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            value += coefficients[k, 2] * np.sin(phase)
        u[k] = value


@compiled
def input_slopes_at(t, start, coefficients, slopes):
    """Time derivatives of the inputs inside one segment."""
    dt = t - start
    for k in range(slopes.size):
        slope = coefficients[k, 1]
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            slope += 2.0 * np.pi * (coefficients[k, 3] + coefficients[k, 4] * dt) * coefficients[k, 2] * np.cos(phase)
        slopes[k] = slope


@compiled
def varies(coefficients):
    """True when an input changes inside a segment."""
    for k in range(coefficients.shape[0]):
        if coefficients[k, 1] != 0.0 or coefficients[k, 2] != 0.0:
            return True
    return False


@compiled
def interpolate(theta, x0, x1, dense, x):
    """State inside the step just made, theta from 0 to 1."""
    rest, n = 1.0 - theta, x.size
    for s in range(n):
        x[s] = rest * x0[s] + theta * (x1[s] + rest * (dense[s] + theta * dense[n + s]))


@compiled
def error(x0, x1, estimate, tolerances, positive):
    """Largest weighted error of the controlled states; infinite where a state left its domain."""
    worst = 0.0
    for s in range(tolerances.shape[1]):
        value = x1[s]
        if not np.isfinite(value) or (positive[s] and value <= 0.0):
            return np.inf
        e = abs(estimate[s]) / (tolerances[1, s] + tolerances[0, s] * max(abs(x0[s]), abs(value)))
        if not e <= worst:
            worst = e
    return worst


@compiled
def first_step(x, f, tolerances, span):
    """A step over which no controlled state moves by more than a twentieth of its size."""
    fastest = 20.0 / span
    for s in range(tolerances.shape[1]):
        fastest = max(fastest, 20.0 * abs(f[s]) / (abs(x[s]) + tolerances[2, s]))
    return 1.0 / fastest


@compiled
def begin(function, t, stop, h, start, c, x, u, slopes, p, tt, f0, jacobian, ft, tolerances):
    """Rates, Jacobian and drift at the beginning of a step; returns its length, chosen where none is known.

    A negative length asks for one that is not longer.
    """
    tt[0] = t
    inputs_at(t, start, c, u)
    input_slopes_at(t, start, c, slopes)
    call8(function, tt, x, u, slopes, p, f0, jacobian, ft)
    if h > 0.0:
        return h
    longest = first_step(x, f0, tolerances, stop - t)
    return min(-h, longest) if h < 0.0 else longest


@compiled
def growth(error, h, error_before, step_before):
    """Factor for the step after an accepted one, with the predictive control of Gustafsson."""
    factor = SAFETY * error**-0.25
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * (error_before / (error * error)) ** 0.25)
    return min(GROWTH, max(SHRINK, factor))


@compiled
def write(outputs, t, x, u, p, tt, y, table, column):
    tt[0] = t
    call5(outputs, tt, x, u, p, y)
    for k in range(y.size):
        table[k, column] = y[k]


@compiled
def stop_condition(outputs, t, x, u, p, tt, y, places, weights):
    """Index of the first stop condition that holds, or -1."""
    tt[0] = t
    call5(outputs, tt, x, u, p, y)
    for k in range(weights.shape[0]):
        value = weights[k, 2]
        for j in range(2):
            if places[k, j] >= 0:
                value += weights[k, j] * y[places[k, j]]
        if value > 0.0:
            return k
    return -1


@compiled
def stop_inside(outputs, t, h, start, c, x0, x1, dense, x, u, p, tt, y, places, weights):
    """Look for a stop condition in the middle and at the end of the step just made: its index and theta, or -1.

    The state at theta is left in x.
    """
    low, high, event = 0.0, 0.5, -1
    while True:
        interpolate(high, x0, x1, dense, x)
        inputs_at(t + high * h, start, c, u)
        found = stop_condition(outputs, t + high * h, x, u, p, tt, y, places, weights)
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
        if (theta - low) * h <= 4e-16 * (t + h) or high <= low or high >= theta:
            interpolate(theta, x0, x1, dense, x)
            return event, theta


@compiled
def length(wanted, remaining):
    """Length of the next step: never past the end of the segment, and no crumb left over."""
    if wanted < 0.5 * remaining:
        return wanted
    return 0.5 * remaining if wanted < remaining else remaining


@compiled
def write_rows(outputs, t, h, until, start, c, x, x1, dense, row, u, p, tt, y, grid, table, counts):
    """Write the rows inside the step just made, up to a time that is excluded: a row on it shows what comes after."""
    before = until - rounding(until)
    while counts[2] < grid.size and grid[counts[2]] < before:
        interpolate(max(0.0, (grid[counts[2]] - t) / h), x, x1, dense, row)
        inputs_at(grid[counts[2]], start, c, u)
        write(outputs, grid[counts[2]], row, u, p, tt, y, table, counts[2])
        counts[2] += 1


@compiled
def take(x, new, books, counts):
    """Make a state the current one."""
    n = x.size
    for s in range(n):
        # Element by element: a slice assignment would cost a second of compile time.
        value = new[s]
        books[2 * n + s] += abs(value - x[s])
        x[s] = value
        books[s], books[n + s] = min(books[s], value), max(books[n + s], value)
    counts[0] += 1


@compiled
def rounding(t):
    """Instants closer than this are one."""
    return 1e-14 * t + 1e-15


@compiled
def next_instant(z, n_timers):
    """The earliest time among the timers."""
    first = np.inf
    for k in range(n_timers):
        first = min(first, z[k])
    return first


@compiled
def act(update, t, start, c, x, u, p, z, tt, fired, after, acting):
    """Let all timers act whose time has come; returns whether the rates have changed.

    A part may set a timer to the same instant again, so it goes on until none is left.
    """
    changed = False
    due = t + rounding(t)
    while next_instant(z, fired.size) <= due:
        for k in range(fired.size):
            fired[k] = 1.0 if z[k] <= due else 0.0
        tt[0] = t
        inputs_at(t, start, c, u)
        call6(update, tt, x, u, p, fired, after)
        for k in range(z.size):
            if acting[k] and after[k] != z[k]:
                changed = True
            z[k] = after[k]
    return changed


@compiled
def act_inside(
    update, outputs, t, h, end, start, c, x, x1, dense, xi, row, u, p, z, tt, y, fired, after, acting, grid, table,
    counts,
):  # fmt: skip
    """Let the instants inside the step just made act, rows before them written first.

    Returns where the step ends: at the first instant that changed the rates, whose state is left in xi, or as it was.
    """
    while True:
        instant = next_instant(z, fired.size)
        if instant >= end - rounding(end):
            return end
        write_rows(outputs, t, h, instant, start, c, x, x1, dense, row, u, p, tt, y, grid, table, counts)
        interpolate((instant - t) / h, x, x1, dense, xi)
        if act(update, instant, start, c, xi, u, p, z, tt, fired, after, acting):
            return instant


@compiled
def verdict(t, window, end, limits, counts, asked_to_stop, has_acted):
    """Why to give up after an attempt, or DONE to go on; a run that gets from instant to instant has not stalled."""
    if counts[1] % STALL_WINDOW == 0:
        slow = t - window < 1e-4 * (end - window) and not has_acted
        if counts[0] - counts[4] < STALL_WINDOW * 7 // 10 and slow:
            return STALLED
        counts[4] = counts[0]
    if counts[1] >= limits[1]:
        return TOO_MANY
    return INTERRUPTED if asked_to_stop else DONE
