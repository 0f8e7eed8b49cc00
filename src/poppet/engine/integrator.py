"""The one generic integrator: a Rosenbrock method of order 4 over machine code that it is handed by address.

It is compiled once by numba and cached on disk; a new circuit never compiles it again. Method: RODAS (Hairer & Wanner,
Solving Ordinary Differential Equations II, 2nd ed. 1996, section VI.4): six stages, order 4(3), stiffly accurate,
L-stable, with an interpolant of order 3.

Everything in this file lives in one compiled unit, because numba's cache does not see changes in other files.
"""

from __future__ import annotations

from collections import namedtuple
from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types

from numba.extending import intrinsic

DONE, STOPPED, STALLED, TOO_MANY, NOT_FINITE, INTERRUPTED = range(6)

GAMMA = 0.25
STAGE_TIME = np.array([0.0, 0.386, 0.21, 0.63, 1.0, 1.0])
STAGE_SLOPE = np.array([0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0])
# A place the argument of a stage, C couple its right-hand side to the stages before it, D weigh the drift df/dt.
D1 = STAGE_SLOPE[0]
A21 = 1.544
A31, A32 = 0.9466785280815826, 0.2557011698983284
A41, A42, A43 = 3.314825187068521, 2.896124015972201, 0.9986419139977817
A51, A52, A53, A54 = 1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950
C21 = -5.6688
C31, C32 = -2.430093356833875, -0.2063599157091915
C41, C42, C43 = -0.1073529058151375, -9.594562251023355, -20.47028614809616
C51, C52, C53, C54 = 7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160
C61, C62, C63, C64, C65 = (
    8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054,
)  # fmt: skip
D21, D22, D23, D24, D25 = (
    10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662,
)  # fmt: skip
D31, D32, D33, D34, D35 = (
    -0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872,
)  # fmt: skip
GROWTH, SHRINK, SAFETY = 6.0, 0.15, 0.9
STALL_WINDOW = 400
"""Attempts after which progress is judged: a window with more than 3 rejections in 10 that brings the run less than
1e-4 of its rest forward is a stall."""

Memory = namedtuple(
    "Memory",
    "addresses p u slopes y tt shift f0 f1 ft right x0 x1 xi jacobian lu stages dense rtol atol scale positive "
    "event_places event_weights",
)
"""Everything a step works on; made once per run."""


def _caller(count: int) -> Any:
    """An intrinsic that calls machine code at an address with `count` arrays of doubles."""

    def typed(typing_context: Any, address: Any, *arrays: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            pointer_type = ir.PointerType(ir.DoubleType())
            pointers = []
            for array_type, array in zip(signature.args[1:], arguments[1:], strict=True):
                data = context.make_array(array_type)(context, builder, array).data
                pointers.append(builder.bitcast(data, pointer_type))
            function_type = ir.FunctionType(ir.VoidType(), [pointer_type] * len(pointers))
            function = builder.inttoptr(arguments[0], ir.PointerType(function_type))
            builder.call(function, pointers)
            return context.get_dummy_value()

        return types.void(address, *arrays), generate

    names = ", ".join(f"a{k}" for k in range(count))
    scope: dict[str, Any] = {"typed": typed}
    exec(f"def call(typing_context, address, {names}):\n    return typed(typing_context, address, {names})", scope)
    return intrinsic(scope["call"])



_call3, _call5, _call8 = _caller(3), _caller(5), _caller(8)


@intrinsic
def _borrowed(typing_context: Any, array: Any) -> Any:
    """The same array without an owner: numba counts no references on it. The caller keeps it alive."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        view = context.make_array(signature.args[0])(context, builder, arguments[0])
        view.meminfo = ir.Constant(view.meminfo.type, None)
        return view._getvalue()

    return array(array), generate


def work_size(n_states: int, n_inputs: int, n_outputs: int, jacobian_size: int, factor_size: int) -> int:
    """Doubles of scratch memory that `integrate` needs."""
    return 15 * n_states + 2 * n_inputs + n_outputs + 2 + jacobian_size + factor_size


@njit(nogil=True, error_model="numpy", inline="always")
def _varies(coefficients):
    """True when an input changes inside a segment."""
    for k in range(coefficients.shape[0]):
        if coefficients[k, 1] != 0.0 or coefficients[k, 2] != 0.0:
            return True
    return False


@njit(nogil=True, error_model="numpy", inline="always")
def _inputs_at(t, start, coefficients, u):
    """Inputs at a time inside one segment."""
    dt = t - start
    for k in range(u.size):
        value = coefficients[k, 0] + coefficients[k, 1] * dt
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            value += coefficients[k, 2] * np.sin(phase)
        u[k] = value


@njit(nogil=True, error_model="numpy", inline="always")
def _input_slopes_at(t, start, coefficients, slopes):
    """Time derivatives of the inputs inside one segment."""
    dt = t - start
    for k in range(slopes.size):
        slope = coefficients[k, 1]
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            slope += 2.0 * np.pi * (coefficients[k, 3] + coefficients[k, 4] * dt) * coefficients[k, 2] * np.cos(phase)
        slopes[k] = slope


@njit(nogil=True, error_model="numpy", inline="always")
def _interpolate(theta, m, x):
    """State inside the step just made, theta from 0 to 1 (RODAS, continuous extension of order 3)."""
    rest = 1.0 - theta
    for s in range(x.size):
        x[s] = rest * m.x0[s] + theta * (m.x1[s] + rest * (m.dense[0, s] + theta * m.dense[1, s]))


@njit(nogil=True, error_model="numpy", inline="always")
def _prepare_dense(m):
    """Coefficients of the interpolant of the step just made."""
    k1, k2, k3, k4, k5 = m.stages[0], m.stages[1], m.stages[2], m.stages[3], m.stages[4]
    d2, d3 = m.dense[0], m.dense[1]
    for s in range(d2.size):
        d2[s] = D21 * k1[s] + D22 * k2[s] + D23 * k3[s] + D24 * k4[s] + D25 * k5[s]
        d3[s] = D31 * k1[s] + D32 * k2[s] + D33 * k3[s] + D34 * k4[s] + D35 * k5[s]


@njit(nogil=True, error_model="numpy", inline="always")
def _linearise(t, start, coefficients, m):
    """Rates, Jacobian and drift at the beginning of a step."""
    m.tt[0] = t
    _inputs_at(t, start, coefficients, m.u)
    _input_slopes_at(t, start, coefficients, m.slopes)
    _call8(m.addresses[1], m.tt, m.x0, m.u, m.slopes, m.p, m.f0, m.jacobian, m.ft)


@njit(nogil=True, error_model="numpy", inline="always")
def _solve_stage(i, t, h, start, coefficients, varies, m):
    """Rates at the argument x1 of stage i, and its linear system."""
    m.tt[0] = t + STAGE_TIME[i] * h
    if varies:
        _inputs_at(m.tt[0], start, coefficients, m.u)
    _call5(m.addresses[0], m.tt, m.x1, m.u, m.p, m.f1)
    slope = h * STAGE_SLOPE[i]
    for s in range(m.x1.size):
        m.right[s] += m.f1[s] + slope * m.ft[s]
    _call3(m.addresses[3], m.lu, m.right, m.stages[i])


@njit(nogil=True, error_model="numpy", inline="always")
def _make_stages(t, h, start, coefficients, varies, m):
    """The six stages of one step, written out: one pass over the states each. Leaves the new state in x1."""
    n = m.x0.size
    x0, x1, right, ft, f0 = m.x0, m.x1, m.right, m.ft, m.f0
    k1, k2, k3, k4, k5, k6 = m.stages[0], m.stages[1], m.stages[2], m.stages[3], m.stages[4], m.stages[5]
    g = 1.0 / h
    m.shift[0] = g / GAMMA
    _call3(m.addresses[2], m.jacobian, m.shift, m.lu)
    for s in range(n):
        right[s] = f0[s] + h * D1 * ft[s]
    _call3(m.addresses[3], m.lu, right, k1)
    for s in range(n):
        x1[s] = x0[s] + A21 * k1[s]
        right[s] = g * C21 * k1[s]
    _solve_stage(1, t, h, start, coefficients, varies, m)
    for s in range(n):
        x1[s] = x0[s] + A31 * k1[s] + A32 * k2[s]
        right[s] = g * (C31 * k1[s] + C32 * k2[s])
    _solve_stage(2, t, h, start, coefficients, varies, m)
    for s in range(n):
        x1[s] = x0[s] + A41 * k1[s] + A42 * k2[s] + A43 * k3[s]
        right[s] = g * (C41 * k1[s] + C42 * k2[s] + C43 * k3[s])
    _solve_stage(3, t, h, start, coefficients, varies, m)
    for s in range(n):
        x1[s] = x0[s] + A51 * k1[s] + A52 * k2[s] + A53 * k3[s] + A54 * k4[s]
        right[s] = g * (C51 * k1[s] + C52 * k2[s] + C53 * k3[s] + C54 * k4[s])
    _solve_stage(4, t, h, start, coefficients, varies, m)
    for s in range(n):
        x1[s] += k5[s]
        right[s] = g * (C61 * k1[s] + C62 * k2[s] + C63 * k3[s] + C64 * k4[s] + C65 * k5[s])
    _solve_stage(5, t, h, start, coefficients, varies, m)
    for s in range(n):
        x1[s] += k6[s]


@njit(nogil=True, error_model="numpy", inline="always")
def _error(m):
    """Largest weighted error of the controlled states; infinite where a state left its domain."""
    worst = 0.0
    for s in range(m.rtol.size):
        value = m.x1[s]
        if not np.isfinite(value) or (m.positive[s] and value <= 0.0):
            return np.inf
        size = max(abs(m.x0[s]), abs(value))
        e = abs(m.stages[5, s]) / (m.atol[s] + m.rtol[s] * size)
        if not e <= worst:
            worst = e
    return worst


@njit(nogil=True, error_model="numpy", inline="always")
def _first_step(m, span):
    """A step over which no controlled state moves by more than a twentieth of its size."""
    fastest = 20.0 / span
    for s in range(m.scale.size):
        fastest = max(fastest, 20.0 * abs(m.f0[s]) / (abs(m.x0[s]) + m.scale[s]))
    return 1.0 / fastest


@njit(nogil=True, error_model="numpy", inline="always")
def _growth(error, h, error_before, step_before):
    """Factor for the step after an accepted one, with the predictive control of Gustafsson."""
    factor = SAFETY * error**-0.25
    if step_before > 0.0:
        factor = min(factor, SAFETY * (h / step_before) * (error_before / (error * error)) ** 0.25)
    return min(GROWTH, max(SHRINK, factor))


@njit(nogil=True, error_model="numpy", inline="always")
def _write(t, x, m, table, column):
    m.tt[0] = t
    _call5(m.addresses[4], m.tt, x, m.u, m.p, m.y)
    for k in range(m.y.size):
        table[k, column] = m.y[k]


@njit(nogil=True, error_model="numpy", inline="always")
def _write_rows(t, h, end, start, coefficients, m, grid, table, column):
    """Rows inside the step just made, its end excluded; returns the next column."""
    while column < grid.size and grid[column] < end:
        _interpolate((grid[column] - t) / h, m, m.xi)
        _inputs_at(grid[column], start, coefficients, m.u)
        _write(grid[column], m.xi, m, table, column)
        column += 1
    return column


@njit(nogil=True, error_model="numpy", inline="always")
def _stop_condition(t, x, start, coefficients, m):
    """Index of the first stop condition that holds, or -1."""
    if m.event_weights.shape[0] == 0:
        return -1
    m.tt[0] = t
    _inputs_at(t, start, coefficients, m.u)
    _call5(m.addresses[4], m.tt, x, m.u, m.p, m.y)
    for k in range(m.event_weights.shape[0]):
        value = m.event_weights[k, 2]
        for j in range(2):
            if m.event_places[k, j] >= 0:
                value += m.event_weights[k, j] * m.y[m.event_places[k, j]]
        if value > 0.0:
            return k
    return -1


@njit(nogil=True, error_model="numpy", inline="always")
def _stop_inside(t, h, start, coefficients, m):
    """Look for a stop condition in the middle and at the end of the step just made: its index and theta, or -1."""
    for half in range(1, 3):
        theta = 0.5 * half
        _interpolate(theta, m, m.xi)
        event = _stop_condition(t + theta * h, m.xi, start, coefficients, m)
        if event >= 0:
            low = theta - 0.5
            while (theta - low) * h > 4e-16 * (t + h):
                middle = 0.5 * (low + theta)
                if middle <= low or middle >= theta:
                    break
                _interpolate(middle, m, m.xi)
                if _stop_condition(t + middle * h, m.xi, start, coefficients, m) >= 0:
                    theta = middle
                else:
                    low = middle
            return event, theta
    return -1, 1.0


@njit(nogil=True, error_model="numpy", inline="always")
def _advance(m, extremes, through):
    """Take the new state and keep the books."""
    for s in range(m.x0.size):
        through[s] += abs(m.x1[s] - m.x0[s])
        m.x0[s] = m.x1[s]
        extremes[0, s] = min(extremes[0, s], m.x0[s])
        extremes[1, s] = max(extremes[1, s], m.x0[s])


@njit(nogil=True, error_model="numpy", inline="always")
def _segment(t, stop, h, start, coefficients, m, grid, limits, table, extremes, through, progress, counts):
    """Integrate over one segment of the inputs.

    counts: accepted, attempts, next column, stop condition, accepted at the window's start. Returns status, time, step.
    """
    error_before, step_before, rejected = 1e-2, 0.0, False
    window, has_events, varies = t, m.event_weights.shape[0] > 0, _varies(coefficients)
    fresh = True
    while t < stop:
        if fresh:
            _linearise(t, start, coefficients, m)
            fresh = False
            if h <= 0.0:
                first = _first_step(m, stop - t)
                h = min(-h, first) if h < 0.0 else first
        wanted = min(h, limits[0])
        h = wanted if wanted < 0.5 * (stop - t) else (0.5 * (stop - t) if wanted < stop - t else stop - t)
        last = h >= stop - t
        _make_stages(t, h, start, coefficients, varies, m)
        error = _error(m)
        counts[1] += 1
        if error <= 1.0:
            if has_events or grid[counts[2]] < t + h:
                _prepare_dense(m)
            event, theta = _stop_inside(t, h, start, coefficients, m)
            end = stop if last and event < 0 else t + theta * h
            counts[2] = _write_rows(t, h, end, start, coefficients, m, grid, table, counts[2])
            if event >= 0:
                counts[3] = event
                _interpolate(theta, m, m.xi)
                m.x1[:] = m.xi
            _advance(m, extremes, through)
            counts[0] += 1
            progress[0] = t = end
            fresh = True
            if event >= 0:
                return STOPPED, t, h
            error = max(error, 1e-10)
            factor = _growth(error, h, error_before, step_before)
            step_before, error_before = h, max(1e-2, error)
            # A step that was cut at the end of the segment says nothing against the longer one that was wanted.
            h = max(wanted, h * factor) if h < wanted else h * (min(1.0, factor) if rejected else factor)
            rejected = False
        else:
            h *= SHRINK if not np.isfinite(error) else max(SHRINK, min(0.8, SAFETY * error**-0.25))
            rejected = True
            if t + h <= t or h < 1e-300:
                return STALLED, t, h
        if counts[1] % STALL_WINDOW == 0:
            if counts[0] - counts[4] < STALL_WINDOW * 7 // 10 and t - window < 1e-4 * (grid[-1] - window):
                return STALLED, t, h
            window, counts[4] = t, counts[0]
        if counts[1] >= limits[1]:
            return TOO_MANY, t, h
        if progress[1] != 0.0:
            return INTERRUPTED, t, h
    return DONE, t, h


@njit(cache=True, nogil=True, error_model="numpy")
def integrate(
    addresses, sizes, x, p, starts, coefficients, jumps, grid, rtol, atol, scale, positive,
    limits, event_places, event_weights, table, extremes, through, progress, statistics, work,
):  # fmt: skip
    """Integrate over all segments.

    addresses: rates, jacobian, factor, solve, outputs. sizes: nonzeros of J and of the factors. x: state, in and out.
    starts, coefficients, jumps: the inputs' segments. grid: output times, the last one is the end. limits: longest
    step, most attempts. table: outputs (n_outputs, n_grid). extremes: least and greatest state met (2, n). through:
    sum of |change| of each state. progress: time reached, and a flag by which another thread asks to stop.
    statistics: accepted, rejected, columns written, time reached, stop condition, last step. work: scratch memory of
    `work_size` doubles.
    """
    x, p, coefficients, grid, table = _borrowed(x), _borrowed(p), _borrowed(coefficients), _borrowed(grid), _borrowed(table)
    extremes, through, progress = _borrowed(extremes), _borrowed(through), _borrowed(progress)
    n, n_u, n_y = x.size, coefficients.shape[1], table.shape[0]
    work = _borrowed(work)
    rows = work[: 15 * n].reshape((15, n))
    a = 15 * n
    u, slopes, y = work[a : a + n_u], work[a + n_u : a + 2 * n_u], work[a + 2 * n_u : a + 2 * n_u + n_y]
    a += 2 * n_u + n_y
    tt, shift, jacobian, lu = work[a : a + 1], work[a + 1 : a + 2], work[a + 2 : a + 2 + sizes[0]], work[a + 2 + sizes[0] :]
    m = Memory(
        _borrowed(addresses), p, u, slopes, y, tt, shift,
        rows[0], rows[1], rows[2], rows[3], x, rows[4], rows[5], jacobian, lu, rows[6:12], rows[12:14],
        _borrowed(rtol), _borrowed(atol), _borrowed(scale), _borrowed(positive),
        _borrowed(event_places), _borrowed(event_weights),
    )  # fmt: skip
    counts = np.zeros(5, dtype=np.int64)
    counts[3] = -1
    extremes[0], extremes[1], through[:] = x, x, 0.0
    status, t, h, k = DONE, starts[0], 0.0, 0
    for k in range(starts.size):
        t = starts[k]
        stop = starts[k + 1] if k + 1 < starts.size else grid[-1]
        counts[3] = _stop_condition(t, x, starts[k], coefficients[k], m)
        if counts[3] >= 0:
            status = STOPPED
            break
        # After a jump of an input the step is chosen anew, but not longer than before.
        h = -h if jumps[k] else h
        status, t, h = _segment(
            t, stop, h, starts[k], coefficients[k], m, grid, limits, table, extremes, through, progress, counts
        )
        if status != DONE:
            break
    if status == DONE or status == STOPPED:
        _inputs_at(t, starts[k], coefficients[k], m.u)
        counts[2] = min(counts[2], grid.size - 1)
        _write(t, x, m, table, counts[2])
        counts[2] += 1
    statistics[0], statistics[1], statistics[2] = counts[0], counts[1] - counts[0], counts[2]
    statistics[3], statistics[4], statistics[5] = t, counts[3], h
    return status
