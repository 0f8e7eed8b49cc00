"""The one generic integrator: step control, rows and stop conditions around a step that it is handed by address.

Numba turns this file and `stepping.py` into LLVM IR once, when they change (`tools/make_integrator.py`); the text is
shipped beside them, and a user's machine makes object code of it (`poppet.engine.compiled`), so that nobody but a
developer needs numba. The method itself is printed with the model (`poppet.engine.rosenbrock`).
"""

from __future__ import annotations

import re

import numpy as np
from numba import carray, cfunc, types

from poppet.engine import stepping
from poppet.engine.stepping import (
    DENSE,
    DONE,
    INPUT_TIMES,
    JACOBIAN,
    OUTPUTS,
    SAFETY,
    SHRINK,
    STALL_WINDOW,
    STALLED,
    STEP,
    STOPPED,
    UPDATE,
    compiled,
)


@compiled
def _reach(h, longest, t, stop, calm, lands, z, n_timers):
    """Length wanted of a step, and where it has to end at the latest.

    That is the next instant of the memory, unless the instants have left the rates alone since `calm`: then a step may
    pass over as much time again, and they act on its interpolant.
    """
    wanted, goal = min(h, longest), stop
    if n_timers > 0:
        instant = stepping.next_instant(z, n_timers)
        if instant < stop - stepping.rounding(stop):
            if lands or instant - t >= t - calm:
                return wanted, instant
            wanted = min(wanted, t - calm)
    return wanted, goal


@compiled
def _again(script, step, remaining):
    """Length of a step that is replayed: one that ended on an instant ends on it wherever that has moved."""
    h = script[min(step, script.size - 1)]
    return remaining if h <= 0.0 or h >= remaining else h


@compiled
def _accept(
    addresses, t, h, end, start, c, x, x1, xi, dense, k, row, u, p, z, tt, y, fired, after, acting, grid, places,
    weights, table, books, counts,
):  # fmt: skip
    """Take the step just made, with its rows, up to a stop condition or an instant that changes the rates.

    Returns where it ended; counts[3] says which stop condition was met.
    """
    passes = fired.size > 0 and stepping.next_instant(z, fired.size) < end - stepping.rounding(end)
    has_events, outputs, reached = weights.shape[0] > 0, addresses[OUTPUTS], end
    if has_events or passes or grid[counts[2]] < end:
        stepping.call2(addresses[DENSE], k, dense)
    if has_events:
        event, theta = stepping.stop_inside(outputs, t, h, start, c, x, x1, dense, xi, u, p, tt, y, places, weights)
        counts[3], reached = event, t + theta * h if event >= 0 else end
    elif passes:
        reached = stepping.act_inside(
            addresses[UPDATE], outputs, t, h, end, start, c, x, x1, dense, xi, row, u, p, z, tt, y, fired, after,
            acting, grid, table, counts,
        )  # fmt: skip
    stepping.write_rows(outputs, t, h, reached, start, c, x, x1, dense, row, u, p, tt, y, grid, table, counts)
    stepping.take(x, xi if counts[3] >= 0 or reached < end else x1, books, counts)
    return reached


@compiled
def _segment(
    addresses, t, stop, h, start, c, x, p, z, u, us, slopes, y, tt, rows, jacobian, scratch, fired, after, acting, grid,
    tolerances, positive, limits, places, weights, table, books, progress, counts, script,
):  # fmt: skip
    """Integrate over one segment of the inputs; returns status, time and step.

    rows: f0, ft, x1, xi, two of the interpolant, six stages. books: least, greatest, sum of |change| of each state.
    counts: accepted, attempts, next column, stop condition, accepted at the beginning of the window. `calm` is when the
    memory changed the rates last, `first` the step that went well after that.
    """
    n, n_u = x.size, u.size
    f0, ft, x1, xi = rows[:n], rows[n : 2 * n], rows[2 * n : 3 * n], rows[3 * n : 4 * n]
    dense, k, estimate = rows[4 * n : 6 * n], rows[6 * n :], rows[11 * n :]
    error_before, step_before, rejected, fresh, moves = 1e-2, 0.0, False, True, stepping.varies(c)
    window, replays, lands = t, limits[2] > 0.0, weights.shape[0] > 0 or script.size > 0
    calm, first, has_changed, has_acted = t, 0.0, True, fired.size > 0
    for i in range(4):
        stepping.inputs_at(t, start, c, us[i * n_u : (i + 1) * n_u])
    while t < stop:
        if fresh:
            h = stepping.begin(
                addresses[JACOBIAN], t, stop, h, start, c, x, u, slopes, p, tt, f0, jacobian, ft, tolerances
            )
            fresh = False
        wanted, goal = _reach(h, limits[0], t, stop, calm, lands, z, fired.size)
        h = _again(script, counts[0], goal - t) if replays else stepping.length(wanted, goal - t)
        for i in range(4 if moves else 0):
            stepping.inputs_at(t + INPUT_TIMES[i] * h, start, c, us[i * n_u : (i + 1) * n_u])
        end = goal if h >= (goal - t) * (1.0 - 1e-12) else t + h
        tt[0], tt[1] = t, h
        stepping.call10(addresses[STEP], tt, x, us, p, f0, jacobian, ft, scratch, k, x1)
        error = stepping.error(x, x1, estimate, tolerances, positive)
        counts[1] += 1
        if error <= 1.0 or (replays and np.isfinite(error)):
            if counts[0] < script.size and not replays:
                script[counts[0]] = -h if end == goal else h
            progress[0] = t = _accept(
                addresses, t, h, end, start, c, x, x1, xi, dense, k, ft, u, p, z, tt, y, fired, after, acting, grid,
                places, weights, table, books, counts,
            )  # fmt: skip
            if counts[3] >= 0:
                return STOPPED, t, h
            fresh, error, changes = True, max(error, 1e-10), t < end
            factor = stepping.growth(error, h, error_before, step_before)
            step_before, error_before = h, max(1e-2, error)
            if has_changed:
                first, has_changed = h * min(2.0, max(0.5, factor)), False
            # A step that was cut at the end of the segment says nothing against the longer one that was wanted.
            h = max(wanted, h * factor) if h < wanted else h * (min(1.0, factor) if rejected else factor)
            rejected = False
            if fired.size > 0 and t < stop - stepping.rounding(stop):
                has_acted = True
                if stepping.act(addresses[UPDATE], t, start, c, x, u, p, z, tt, fired, after, acting) or changes:
                    # The rates have jumped: begin with what went well after the last jump.
                    h, step_before, calm, has_changed = min(h, first), 0.0, t, True
        else:
            h *= max(SHRINK, min(0.8, SAFETY * error**-0.25)) if np.isfinite(error) else SHRINK
            rejected = True
            if t + h <= t or h < 1e-300 or replays:
                return STALLED, t, h
        status = stepping.verdict(t, window, grid[-1], limits, counts, progress[1] != 0.0, has_acted)
        if status != DONE:
            return status, t, h
        if counts[1] % STALL_WINDOW == 0:
            window, has_acted = t, False
    return DONE, t, h


_doubles, _integers, _bytes = (types.CPointer(t) for t in (types.float64, types.int64, types.uint8))
ARGUMENTS = (
    _integers, _integers, _doubles, _doubles, _doubles, _doubles, _bytes, _doubles, _doubles, _bytes, _doubles,
    _integers, _doubles, _bytes, _doubles, _doubles, _doubles, _integers, _doubles, _doubles,
)  # fmt: skip
"""Pointers only, so that the compiled function can be kept as object code and called without numba."""


def integrate(
    addresses, sizes, x, p, starts, coefficients, jumps, grid, tolerances, positive, limits, places, weights, acting,
    table, books, progress, counts, memory, script,
):  # fmt: skip
    """Integrate over all segments; returns the status.

    addresses: jacobian, step, dense, outputs, update. sizes: states, controlled states, inputs, outputs, segments,
    rows, stop conditions, nonzeros of J, scratch of a step, length of the script, numbers, memory, timers. x: state,
    in and out. p: numbers, then the memory, in and out. starts, coefficients, jumps: segments of the inputs. grid:
    output times, the last one is the end. tolerances: relative, absolute, size (3, n_controlled). limits: longest
    step, most attempts, 1 to replay a script. places, weights: stop conditions. acting: on which of the memory the
    rates depend. table: outputs (n_outputs, n_grid). books: least and greatest value and sum of |change| of each state
    (3 n). progress: time reached, and a flag by which another thread asks to stop. counts: accepted, attempts, columns
    written, stop condition, scratch (5). memory: scratch, see `memory_size`. script: lengths of the accepted steps,
    written as far as there is room, negative where they ended on an instant; or read where they are replayed: runs that
    share a script differ smoothly in their numbers, which finite differences need.
    """
    n, n_c, n_u, n_y, n_k = sizes[0], sizes[1], sizes[2], sizes[3], sizes[4]
    n_t, n_e, n_j, n_w = sizes[5], sizes[6], sizes[7], sizes[8]
    n_p, n_z, n_m = sizes[10], sizes[11], sizes[12]
    starts_, c, jumps_ = carray(starts, (n_k,)), carray(coefficients, (n_k, n_u, 6)), carray(jumps, (n_k,))
    x_, grid_, table_ = carray(x, (n,)), carray(grid, (n_t,)), carray(table, (n_y, n_t))
    addresses_, counts_, progress_ = carray(addresses, (5,)), carray(counts, (5,)), carray(progress, (2,))
    places_, weights_ = carray(places, (n_e, 2)), carray(weights, (n_e, 3))
    tolerances_, positive_, limits_ = carray(tolerances, (3, n_c)), carray(positive, (n_c,)), carray(limits, (3,))
    books_, p_, script_ = carray(books, (3 * n,)), carray(p, (n_p + n_z,)), carray(script, (sizes[9],))
    z, acting_ = p_[n_p:], carray(acting, (n_z,))
    w = carray(memory, (12 * n + 6 * n_u + n_y + 2 + n_j + n_w + n_z + n_m,))
    rows, rest = w[: 12 * n], w[12 * n :]
    u, us, slopes, rest = rest[:n_u], rest[n_u : 5 * n_u], rest[5 * n_u : 6 * n_u], rest[6 * n_u :]
    tt, jacobian, rest = rest[:2], rest[2 : 2 + n_j], rest[2 + n_j :]
    scratch, rest = rest[:n_w], rest[n_w:]
    fired, after, y = rest[:n_m], rest[n_m : n_m + n_z], rest[n_m + n_z :]
    for s in range(n):
        books_[s], books_[n + s], books_[2 * n + s] = x_[s], x_[s], 0.0
    counts_[3] = -1
    status, t, h, k = DONE, starts_[0], 0.0, 0
    for k in range(n_k):
        t = starts_[k]
        stop = starts_[k + 1] if k + 1 < n_k else grid_[n_t - 1]
        if n_m > 0:
            stepping.act(addresses_[UPDATE], t, t, c[k], x_, u, p_, z, tt, fired, after, acting_)
        if n_e > 0:
            stepping.inputs_at(t, t, c[k], u)
            counts_[3] = stepping.stop_condition(addresses_[OUTPUTS], t, x_, u, p_, tt, y, places_, weights_)
            if counts_[3] >= 0:
                status = STOPPED
                break
        # After a jump of an input the step is chosen anew, but not longer than before.
        h = -h if jumps_[k] else h
        if n > 0:
            status, t, h = _segment(
                addresses_, t, stop, h, t, c[k], x_, p_, z, u, us, slopes, y, tt, rows, jacobian, scratch, fired, after,
                acting_, grid_, tolerances_, positive_, limits_, places_, weights_, table_, books_, progress_, counts_,
                script_,
            )  # fmt: skip
        else:
            t = _without_states(
                addresses_, t, stop, c[k], u, p_, z, x_, tt, y, fired, after, acting_, grid_, places_, weights_, table_,
                counts_,
            )  # fmt: skip
            status = STOPPED if counts_[3] >= 0 else DONE
        if status != DONE:
            break
    if status == DONE or status == STOPPED:
        stepping.inputs_at(t, starts_[k], c[k], u)
        counts_[2] = min(counts_[2], n_t - 1)
        stepping.write(addresses_[OUTPUTS], t, x_, u, p_, tt, y, table_, counts_[2])
        counts_[2] += 1
    progress_[0] = t
    return status


@compiled
def _without_states(
    addresses, start, stop, c, u, p, z, x, tt, y, fired, after, acting, grid, places, weights, table, counts
):
    """Rows, instants and stop conditions of a segment of a circuit that has no states; returns where it ends.

    Stop conditions are looked for between rows.
    """
    t, outputs = start, addresses[OUTPUTS]
    while t < stop:
        end = stop
        if fired.size > 0:
            stepping.act(addresses[UPDATE], t, start, c, x, u, p, z, tt, fired, after, acting)
            instant = stepping.next_instant(z, fired.size)
            end = instant if instant < stop - stepping.rounding(stop) else stop
        if weights.shape[0] > 0:
            row = counts[2]
            while row < grid.size - 1 and grid[row] <= t + stepping.rounding(t):
                row += 1
            end = grid[row] if grid[row] < end - stepping.rounding(end) else end
            event, theta = stepping.stop_inside(
                outputs, t, end - t, start, c, x, x, x, x, u, p, tt, y, places, weights
            )  # fmt: skip
            counts[3], end = event, t + theta * (end - t) if event >= 0 else end
        stepping.write_rows(outputs, t, end - t, end, start, c, x, x, x, x, u, p, tt, y, grid, table, counts)
        t = end
        if counts[3] >= 0:
            break
    return t


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
