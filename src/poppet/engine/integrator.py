"""The one generic integrator: step control, rows and stop conditions around a step that it is handed by address.

Numba turns this file into LLVM IR once, when it changes (`tools/make_integrator.py`); the text is shipped beside it,
and a user's machine makes object code of it (`poppet.engine.compiled`), so that nobody but a developer needs numba. The
method itself is printed with the model (`poppet.engine.rosenbrock`).
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from llvmlite import ir
from numba import carray, cfunc, njit, types
from numba.extending import intrinsic

DONE, STOPPED, STALLED, TOO_MANY, NOT_FINITE, INTERRUPTED = range(6)
JACOBIAN, STEP, DENSE, OUTPUTS = range(4)
INPUT_TIMES = (0.386, 0.21, 0.63, 1.0)
GROWTH, SHRINK, SAFETY = 6.0, 0.15, 0.9
STALL_WINDOW = 400
"""Attempts after which progress is judged: a window with more than 3 rejections in 10 that brings the run less than
1e-4 of its rest forward is a stall."""


def _caller(count: int) -> Any:
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


_call2, _call5, _call8, _call10 = _caller(2), _caller(5), _caller(8), _caller(10)


_compiled = njit(nogil=True, error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)


@_compiled
def _inputs_at(t, start, coefficients, u):
    """Inputs at a time inside one segment."""
    dt = t - start
    for k in range(u.size):
        value = coefficients[k, 0] + coefficients[k, 1] * dt
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            value += coefficients[k, 2] * np.sin(phase)
        u[k] = value


@_compiled
def _input_slopes_at(t, start, coefficients, slopes):
    """Time derivatives of the inputs inside one segment."""
    dt = t - start
    for k in range(slopes.size):
        slope = coefficients[k, 1]
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            slope += 2.0 * np.pi * (coefficients[k, 3] + coefficients[k, 4] * dt) * coefficients[k, 2] * np.cos(phase)
        slopes[k] = slope


@_compiled
def _varies(coefficients):
    """True when an input changes inside a segment."""
    for k in range(coefficients.shape[0]):
        if coefficients[k, 1] != 0.0 or coefficients[k, 2] != 0.0:
            return True
    return False


@_compiled
def _interpolate(theta, x0, x1, dense, x):
    """State inside the step just made, theta from 0 to 1."""
    rest, n = 1.0 - theta, x.size
    for s in range(n):
        x[s] = rest * x0[s] + theta * (x1[s] + rest * (dense[s] + theta * dense[n + s]))


@_compiled
def _error(x0, x1, estimate, tolerances, positive):
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


@_compiled
def _first_step(x, f, tolerances, span):
    """A step over which no controlled state moves by more than a twentieth of its size."""
    fastest = 20.0 / span
    for s in range(tolerances.shape[1]):
        fastest = max(fastest, 20.0 * abs(f[s]) / (abs(x[s]) + tolerances[2, s]))
    return 1.0 / fastest


@_compiled
def _growth(error, h, error_before, step_before):
    """Factor for the step after an accepted one, with the predictive control of Gustafsson."""
    factor = SAFETY * error**-0.25
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * (error_before / (error * error)) ** 0.25)
    return min(GROWTH, max(SHRINK, factor))


@_compiled
def _write(outputs, t, x, u, p, tt, y, table, column):
    tt[0] = t
    _call5(outputs, tt, x, u, p, y)
    for k in range(y.size):
        table[k, column] = y[k]


@_compiled
def _stop_condition(outputs, t, x, u, p, tt, y, places, weights):
    """Index of the first stop condition that holds, or -1."""
    tt[0] = t
    _call5(outputs, tt, x, u, p, y)
    for k in range(weights.shape[0]):
        value = weights[k, 2]
        for j in range(2):
            if places[k, j] >= 0:
                value += weights[k, j] * y[places[k, j]]
        if value > 0.0:
            return k
    return -1


@_compiled
def _stop_inside(outputs, t, h, start, c, x0, x1, dense, x, u, p, tt, y, places, weights):
    """Look for a stop condition in the middle and at the end of the step just made: its index and theta, or -1.

    The state at theta is left in x.
    """
    low, high, event = 0.0, 0.5, -1
    while True:
        _interpolate(high, x0, x1, dense, x)
        _inputs_at(t + high * h, start, c, u)
        found = _stop_condition(outputs, t + high * h, x, u, p, tt, y, places, weights)
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
            _interpolate(theta, x0, x1, dense, x)
            return event, theta


@_compiled
def _length(wanted, remaining):
    """Length of the next step: never past the end of the segment, and no crumb left over."""
    if wanted < 0.5 * remaining:
        return wanted
    return 0.5 * remaining if wanted < remaining else remaining


@_compiled
def _take(outputs, t, h, end, start, c, x, x1, xi, dense, row, u, p, tt, y, grid, table, books, counts):
    """Write the rows inside the step just made, its end excluded, then take its state (xi, if it was stopped)."""
    while counts[2] < grid.size and grid[counts[2]] < end:
        _interpolate((grid[counts[2]] - t) / h, x, x1, dense, row)
        _inputs_at(grid[counts[2]], start, c, u)
        _write(outputs, grid[counts[2]], row, u, p, tt, y, table, counts[2])
        counts[2] += 1
    n = x.size
    for s in range(n):
        # Element by element: a slice assignment would cost a second of compile time.
        new = xi[s] if counts[3] >= 0 else x1[s]
        books[2 * n + s] += abs(new - x[s])
        x[s] = new
        books[s], books[n + s] = min(books[s], new), max(books[n + s], new)
    counts[0] += 1


@_compiled
def _verdict(t, window, end, limits, counts, asked_to_stop):
    """Why to give up after an attempt, or DONE to go on."""
    if counts[1] % STALL_WINDOW == 0:
        if counts[0] - counts[4] < STALL_WINDOW * 7 // 10 and t - window < 1e-4 * (end - window):
            return STALLED
        counts[4] = counts[0]
    if counts[1] >= limits[1]:
        return TOO_MANY
    return INTERRUPTED if asked_to_stop else DONE


@_compiled
def _segment(
    addresses, t, stop, h, start, c, x, p, u, us, slopes, y, tt, rows, jacobian, scratch, grid, tolerances, positive,
    limits, places, weights, table, books, progress, counts, script,
):  # fmt: skip
    """Integrate over one segment of the inputs; returns status, time and step.

    rows: f0, ft, x1, xi, two of the interpolant, six stages. books: least, greatest, sum of |change| of each state.
    counts: accepted, attempts, next column, stop condition, accepted at the beginning of the window.
    """
    n, n_u, outputs = x.size, u.size, addresses[OUTPUTS]
    f0, ft, x1, xi = rows[:n], rows[n : 2 * n], rows[2 * n : 3 * n], rows[3 * n : 4 * n]
    dense, k, estimate = rows[4 * n : 6 * n], rows[6 * n :], rows[11 * n :]
    error_before, step_before, rejected, fresh = 1e-2, 0.0, False, True
    window, has_events, varies, replays = t, weights.shape[0] > 0, _varies(c), limits[2] > 0.0
    for i in range(4):
        _inputs_at(t, start, c, us[i * n_u : (i + 1) * n_u])
    while t < stop:
        if fresh:
            tt[0] = t
            _inputs_at(t, start, c, u)
            _input_slopes_at(t, start, c, slopes)
            _call8(addresses[JACOBIAN], tt, x, u, slopes, p, f0, jacobian, ft)
            fresh = False
            if h <= 0.0:
                first = _first_step(x, f0, tolerances, stop - t)
                h = min(-h, first) if h < 0.0 else first
        wanted = min(h, limits[0])
        h = script[counts[0]] if replays else _length(wanted, stop - t)
        for i in range(4 if varies else 0):
            _inputs_at(t + INPUT_TIMES[i] * h, start, c, us[i * n_u : (i + 1) * n_u])
        end = stop if h >= (stop - t) * (1.0 - 1e-12) else t + h
        tt[0], tt[1] = t, h
        _call10(addresses[STEP], tt, x, us, p, f0, jacobian, ft, scratch, k, x1)
        error = _error(x, x1, estimate, tolerances, positive)
        counts[1] += 1
        if error <= 1.0 or (replays and np.isfinite(error)):
            if counts[0] < script.size and not replays:
                script[counts[0]] = h
            if has_events or grid[counts[2]] < end:
                _call2(addresses[DENSE], k, dense)
            if has_events:
                event, theta = _stop_inside(outputs, t, h, start, c, x, x1, dense, xi, u, p, tt, y, places, weights)
                counts[3], end = event, t + theta * h if event >= 0 else end
            _take(outputs, t, h, end, start, c, x, x1, xi, dense, ft, u, p, tt, y, grid, table, books, counts)
            progress[0] = t = end
            if counts[3] >= 0:
                return STOPPED, t, h
            fresh, error = True, max(error, 1e-10)
            factor = _growth(error, h, error_before, step_before)
            step_before, error_before = h, max(1e-2, error)
            # A step that was cut at the end of the segment says nothing against the longer one that was wanted.
            h = max(wanted, h * factor) if h < wanted else h * (min(1.0, factor) if rejected else factor)
            rejected = False
        else:
            h *= max(SHRINK, min(0.8, SAFETY * error**-0.25)) if np.isfinite(error) else SHRINK
            rejected = True
            if t + h <= t or h < 1e-300 or replays:
                return STALLED, t, h
        status = _verdict(t, window, grid[-1], limits, counts, progress[1] != 0.0)
        if status != DONE:
            return status, t, h
        if counts[1] % STALL_WINDOW == 0:
            window = t
    return DONE, t, h


_doubles, _integers, _bytes = (types.CPointer(t) for t in (types.float64, types.int64, types.uint8))
ARGUMENTS = (
    _integers, _integers, _doubles, _doubles, _doubles, _doubles, _bytes, _doubles, _doubles, _bytes, _doubles,
    _integers, _doubles, _doubles, _doubles, _doubles, _integers, _doubles, _doubles,
)  # fmt: skip
"""Pointers only, so that the compiled function can be kept as object code and called without numba."""


def integrate(
    addresses, sizes, x, p, starts, coefficients, jumps, grid, tolerances, positive, limits, places, weights, table,
    books, progress, counts, memory, script,
):  # fmt: skip
    """Integrate over all segments; returns the status.

    addresses: jacobian, step, dense, outputs. sizes: states, controlled states, inputs, outputs, segments, rows, stop
    conditions, nonzeros of J, scratch of a step, length of the script. x: state, in and out. starts, coefficients,
    jumps: segments of the inputs. grid: output times, the last one is the end. tolerances: relative, absolute, size
    (3, n_controlled). limits: longest step, most attempts, 1 to replay a script. places, weights: stop conditions.
    table: outputs (n_outputs, n_grid). books: least and greatest value and sum of |change| of each state (3 n).
    progress: time reached, and a flag by which another thread asks to stop. counts: accepted, attempts, columns
    written, stop condition, scratch (5). memory: scratch, see `memory_size`. script: lengths of the accepted steps,
    written as far as there is room, or read where they are
    replayed: runs that share a script differ smoothly in their numbers, which finite differences need.
    """
    n, n_c, n_u, n_y, n_k = sizes[0], sizes[1], sizes[2], sizes[3], sizes[4]
    n_t, n_e, n_j, n_w = sizes[5], sizes[6], sizes[7], sizes[8]
    starts_, c, jumps_ = carray(starts, (n_k,)), carray(coefficients, (n_k, n_u, 6)), carray(jumps, (n_k,))
    x_, grid_, table_ = carray(x, (n,)), carray(grid, (n_t,)), carray(table, (n_y, n_t))
    addresses_, counts_, progress_ = carray(addresses, (4,)), carray(counts, (5,)), carray(progress, (2,))
    places_, weights_ = carray(places, (n_e, 2)), carray(weights, (n_e, 3))
    tolerances_, positive_, limits_ = carray(tolerances, (3, n_c)), carray(positive, (n_c,)), carray(limits, (3,))
    books_, p_, script_ = carray(books, (3 * n,)), carray(p, (1,)), carray(script, (sizes[9],))
    w = carray(memory, (12 * n + 6 * n_u + n_y + 2 + n_j + n_w,))
    rows, rest = w[: 12 * n], w[12 * n :]
    u, us, slopes, rest = rest[:n_u], rest[n_u : 5 * n_u], rest[5 * n_u : 6 * n_u], rest[6 * n_u :]
    tt, jacobian, rest = rest[:2], rest[2 : 2 + n_j], rest[2 + n_j :]
    scratch, y = rest[:n_w], rest[n_w:]
    for s in range(n):
        books_[s], books_[n + s], books_[2 * n + s] = x_[s], x_[s], 0.0
    counts_[3] = -1
    status, t, h, k = DONE, starts_[0], 0.0, 0
    for k in range(n_k):
        t = starts_[k]
        stop = starts_[k + 1] if k + 1 < n_k else grid_[n_t - 1]
        if n_e > 0:
            _inputs_at(t, t, c[k], u)
            counts_[3] = _stop_condition(addresses_[OUTPUTS], t, x_, u, p_, tt, y, places_, weights_)
            if counts_[3] >= 0:
                status = STOPPED
                break
        # After a jump of an input the step is chosen anew, but not longer than before.
        h = -h if jumps_[k] else h
        if n > 0:
            status, t, h = _segment(
                addresses_, t, stop, h, t, c[k], x_, p_, u, us, slopes, y, tt, rows, jacobian, scratch, grid_,
                tolerances_, positive_, limits_, places_, weights_, table_, books_, progress_, counts_, script_,
            )  # fmt: skip
        else:
            t = _rows_without_states(addresses_[OUTPUTS], t, stop, c[k], u, p_, x_, tt, y, grid_, table_, counts_)
        if status != DONE:
            break
    if status == DONE or status == STOPPED:
        _inputs_at(t, starts_[k], c[k], u)
        counts_[2] = min(counts_[2], n_t - 1)
        _write(addresses_[OUTPUTS], t, x_, u, p_, tt, y, table_, counts_[2])
        counts_[2] += 1
    progress_[0] = t
    return status


@_compiled
def _rows_without_states(outputs, t, stop, c, u, p, x, tt, y, grid, table, counts):
    """Rows of a segment of a circuit that has no states; returns its end."""
    while counts[2] < grid.size and grid[counts[2]] < stop:
        _inputs_at(grid[counts[2]], t, c, u)
        _write(outputs, grid[counts[2]], x, u, p, tt, y, table, counts[2])
        counts[2] += 1
    return stop


def integrator_text() -> str:
    """LLVM IR of the integrator: `void integrate(...)` over pointers, free of Python and of numba's run-time.

    Returns
    -------
    str
        A module with one entry, `integrate`, which returns the status.

    Notes
    -----
    Compiling with numba takes seconds. Numba's own wrapper is replaced, because it would tie the code to a process in
    which numba lives; the reference counts are dropped, because `carray` makes arrays without an owner.
    """
    compiled = cfunc(types.int64(*ARGUMENTS), nopython=True, error_model="numpy")(integrate)
    text = compiled._library.get_llvm_str()
    wrapper = compiled.native_name
    name = re.escape(wrapper.removeprefix("cfunc."))
    inner = re.search(rf'^define .*?i32 @("?[\w.$]*{name}"?)\(', text, re.M)
    assert inner is not None
    begin = text.index(f"define i64 @{wrapper}(")
    text = text[:begin] + text[text.index("\n}\n", begin) + 3 :]
    text = re.sub(r"^define (?!linkonce_odr|internal)", "define internal ", text, flags=re.M)
    text = text.replace("define linkonce_odr", "define internal")
    text = re.sub(r"^ *(?:tail )?call void @NRT_(?:incref|decref)\(.*$", "", text, flags=re.M)
    pointers = [f"ptr %a{k}" for k in range(len(ARGUMENTS))]
    entry = [
        f"define i64 @integrate({', '.join(pointers)}) {{",
        "  %status = alloca i64",
        "  %problem = alloca ptr",
        "  store i64 0, ptr %status",
        f"  call i32 @{inner.group(1)}(ptr %status, ptr %problem, {', '.join(pointers)})",
        "  %result = load i64, ptr %status",
        "  ret i64 %result",
        "}",
    ]
    return "\n".join([text, *entry, ""])
