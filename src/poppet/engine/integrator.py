"""The one generic integrator: a Rosenbrock method of order 4 over machine code that it is handed by address.

It is compiled once by numba and cached on disk; a new circuit never compiles it again. Method: RODAS (Hairer & Wanner,
Solving Ordinary Differential Equations II, 2nd ed. 1996, section VI.4): six stages, order 4(3), stiffly accurate,
L-stable, with an interpolant of order 3.

Everything in this file lives in one compiled unit, because numba's cache does not see changes in other files.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types

from numba.extending import intrinsic

DONE, STOPPED, STALLED, TOO_MANY, NOT_FINITE, INTERRUPTED = range(6)

GAMMA = 0.25
STAGE_TIME = np.array([0.0, 0.386, 0.21, 0.63, 1.0, 1.0])
STAGE_SLOPE = np.array([0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0])
# a[i, j] place the argument of stage i, c[i, j] couple its right-hand side to the stages before it.
A = np.zeros((6, 6))
A[1, 0] = 1.544
A[2, :2] = 0.9466785280815826, 0.2557011698983284
A[3, :3] = 3.314825187068521, 2.896124015972201, 0.9986419139977817
A[4, :4] = 1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950
A[5, :5] = *A[4, :4], 1.0
C = np.zeros((6, 6))
C[1, 0] = -5.6688
C[2, :2] = -2.430093356833875, -0.2063599157091915
C[3, :3] = -0.1073529058151375, -9.594562251023355, -20.47028614809616
C[4, :4] = 7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160
C[5, :5] = 8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054
DENSE = np.array(
    [
        [10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662],
        [-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872],
    ]
)
GROWTH, SHRINK, SAFETY = 6.0, 0.15, 0.9
STALL_WINDOW = 400
"""Attempts after which progress is judged."""


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


@njit(cache=True, nogil=True, error_model="numpy")
def _inputs_at(t, start, coefficients, u):
    """Inputs at a time inside one segment."""
    dt = t - start
    for k in range(u.size):
        value = coefficients[k, 0] + coefficients[k, 1] * dt
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            value += coefficients[k, 2] * np.sin(phase)
        u[k] = value


@njit(cache=True, nogil=True, error_model="numpy")
def _input_slopes_at(t, start, coefficients, slopes):
    """Time derivatives of the inputs inside one segment."""
    dt = t - start
    for k in range(slopes.size):
        slope = coefficients[k, 1]
        if coefficients[k, 2] != 0.0:
            phase = 2.0 * np.pi * (coefficients[k, 3] + 0.5 * coefficients[k, 4] * dt) * dt + coefficients[k, 5]
            slope += 2.0 * np.pi * (coefficients[k, 3] + coefficients[k, 4] * dt) * coefficients[k, 2] * np.cos(phase)
        slopes[k] = slope


@njit(cache=True, nogil=True, error_model="numpy")
def _interpolate(theta, x0, x1, dense, x):
    """State inside a step, theta from 0 to 1 (RODAS, continuous extension of order 3)."""
    rest = 1.0 - theta
    for s in range(x.size):
        x[s] = rest * x0[s] + theta * (x1[s] + rest * (dense[0, s] + theta * dense[1, s]))


@njit(cache=True, nogil=True, error_model="numpy")
def _dense_coefficients(stages, dense):
    for k in range(2):
        for s in range(dense.shape[1]):
            total = 0.0
            for j in range(5):
                total += DENSE[k, j] * stages[j, s]
            dense[k, s] = total


@njit(cache=True, nogil=True, error_model="numpy")
def _stages(addresses, t, h, x, p, start, coefficients, f0, ft, lu, u, tt, right, argument, stages):
    """The six stages of one step; `argument` ends as the new state, `stages[5]` as its error estimate."""
    n = x.size
    for i in range(6):
        if i > 0:
            for s in range(n):
                argument[s] = x[s]
                right[s] = 0.0
            for j in range(i):
                a, c = A[i, j], C[i, j] / h
                for s in range(n):
                    argument[s] += a * stages[j, s]
                    right[s] += c * stages[j, s]
            tt[0] = t + STAGE_TIME[i] * h
            _inputs_at(tt[0], start, coefficients, u)
            _call5(addresses[0], tt, argument, u, p, f0)
        slope = h * STAGE_SLOPE[i]
        if i == 0:
            for s in range(n):
                right[s] = f0[s] + slope * ft[s]
        else:
            for s in range(n):
                right[s] += f0[s] + slope * ft[s]
        _call3(addresses[3], lu, right, stages[i])
    for s in range(n):
        argument[s] += stages[5, s]


@njit(cache=True, nogil=True, error_model="numpy")
def _error(x0, x1, estimate, rtol, atol, positive):
    """Largest weighted error of the controlled states; infinite where a state left its domain."""
    worst = 0.0
    for s in range(rtol.size):
        value = x1[s]
        if not np.isfinite(value) or (positive[s] and value <= 0.0):
            return np.inf
        size = max(abs(x0[s]), abs(value))
        e = abs(estimate[s]) / (atol[s] + rtol[s] * size)
        if not e <= worst:
            worst = e
    return worst


@njit(cache=True, nogil=True, error_model="numpy")
def _first_step(x, f, scale, span):
    """A step over which no controlled state moves by more than a twentieth of its size."""
    fastest = 20.0 / span
    for s in range(scale.size):
        fastest = max(fastest, 20.0 * abs(f[s]) / (abs(x[s]) + scale[s]))
    return 1.0 / fastest


@njit(cache=True, nogil=True, error_model="numpy")
def _write(addresses, t, x, u, p, tt, y, table, column):
    tt[0] = t
    _call5(addresses[4], tt, x, u, p, y)
    for k in range(y.size):
        table[k, column] = y[k]


@njit(cache=True, nogil=True, error_model="numpy")
def _event(addresses, t, x, u, p, tt, y, event_places, event_weights):
    """Index of the first stop condition that holds, or -1."""
    tt[0] = t
    _call5(addresses[4], tt, x, u, p, y)
    for k in range(event_weights.shape[0]):
        value = event_weights[k, 2]
        for j in range(2):
            if event_places[k, j] >= 0:
                value += event_weights[k, j] * y[event_places[k, j]]
        if value > 0.0:
            return k
    return -1


@njit(cache=True, nogil=True, error_model="numpy")
def _locate(addresses, t, h, x0, x1, dense, start, coefficients, p, u, tt, y, x, event_places, event_weights):
    """Bisect for the instant inside a step at which a stop condition begins to hold; leaves that state in `x`."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        _interpolate(middle, x0, x1, dense, x)
        _inputs_at(t + middle * h, start, coefficients, u)
        if _event(addresses, t + middle * h, x, u, p, tt, y, event_places, event_weights) >= 0:
            high = middle
        else:
            low = middle
        if (high - low) * h <= 4e-16 * (t + h):
            break
    _interpolate(high, x0, x1, dense, x)
    return t + high * h


@njit(cache=True, nogil=True, error_model="numpy")
def integrate(
    addresses, sizes, x, p, starts, coefficients, jumps, grid, rtol, atol, scale, positive,
    limits, event_places, event_weights, table, extremes, through, progress, statistics,
):  # fmt: skip
    """Integrate over all segments.

    addresses: rates, jacobian, factor, solve, outputs. sizes: nonzeros of J and of the factors. x: state, in and out.
    starts, coefficients, jumps: the inputs' segments. grid: output times, the last one is the end. limits: longest
    step, most attempts. table: outputs (n_outputs, n_grid). extremes: least and greatest state met (2, n). through:
    sum of |change| of each state. progress: time reached, and a flag by which another thread asks to stop.
    statistics: accepted, rejected, columns written, time reached, stop condition, last step.
    """
    n, n_u, n_y = x.size, coefficients.shape[1], table.shape[0]
    n_c = rtol.size
    t_end = grid[-1]
    u, slopes, y, tt, shift = np.empty(n_u), np.empty(n_u), np.empty(n_y), np.empty(1), np.empty(1)
    f0, ft, right, x1, xi = np.empty(n), np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    jacobian, lu, stages, dense = np.empty(sizes[0]), np.empty(sizes[1]), np.empty((6, n)), np.empty((2, n))
    has_events = event_weights.shape[0] > 0
    h, column, attempts, accepted = 0.0, 0, 0, 0
    window_time, window_accepted = starts[0], 0
    status, t, event = DONE, starts[0], -1
    error_before, step_before = 1e-2, 0.0
    for s in range(n):
        extremes[0, s] = extremes[1, s] = x[s]
        through[s] = 0.0
    for k in range(starts.size):
        start, c = starts[k], coefficients[k]
        stop = starts[k + 1] if k + 1 < starts.size else t_end
        t = start
        _inputs_at(t, start, c, u)
        if has_events:
            event = _event(addresses, t, x, u, p, tt, y, event_places, event_weights)
            if event >= 0:
                status = STOPPED
                break
        fresh = True
        rejected_before = False
        while t < stop:
            if fresh:
                tt[0] = t
                _inputs_at(t, start, c, u)
                _input_slopes_at(t, start, c, slopes)
                _call8(addresses[1], tt, x, u, slopes, p, f0, jacobian, ft)
                fresh = False
                for s in range(n):
                    xi[s] = f0[s]
                if h == 0.0 or (t == start and jumps[k]):
                    first = _first_step(x, f0, scale, stop - start)
                    h = first if h == 0.0 else min(h, first)
                    step_before = 0.0
            else:
                for s in range(n):
                    f0[s] = xi[s]
            remaining = stop - t
            wanted = h
            last = h >= remaining * 0.9999999
            if last:
                h = remaining
            elif h > 0.5 * remaining:
                h = 0.5 * remaining
            shift[0] = 1.0 / (h * GAMMA)
            _call3(addresses[2], jacobian, shift, lu)
            _stages(addresses, t, h, x, p, start, c, f0, ft, lu, u, tt, right, x1, stages)
            error = _error(x, x1, stages[5], rtol, atol, positive)
            attempts += 1
            if error <= 1.0:
                t_new = stop if last else t + h
                _dense_coefficients(stages, dense)
                if has_events:
                    for half in range(2):
                        theta = 0.5 * (half + 1)
                        _interpolate(theta, x, x1, dense, xi)
                        _inputs_at(t + theta * h, start, c, u)
                        event = _event(addresses, t + theta * h, xi, u, p, tt, y, event_places, event_weights)
                        if event >= 0:
                            break
                    if event >= 0:
                        t_new = _locate(
                            addresses, t, h, x, x1, dense, start, c, p, u, tt, y, xi, event_places, event_weights
                        )
                        status = STOPPED
                while column < grid.size and grid[column] < t_new:
                    _interpolate((grid[column] - t) / h, x, x1, dense, right)
                    _inputs_at(grid[column], start, c, u)
                    _write(addresses, grid[column], right, u, p, tt, y, table, column)
                    column += 1
                if status == STOPPED:
                    for s in range(n):
                        x1[s] = xi[s]
                for s in range(n):
                    through[s] += abs(x1[s] - x[s])
                    x[s] = x1[s]
                    extremes[0, s] = min(extremes[0, s], x[s])
                    extremes[1, s] = max(extremes[1, s], x[s])
                accepted += 1
                t = t_new
                fresh = True
                error = max(error, 1e-10)
                factor = SAFETY * error**-0.25
                if step_before > 0.0:
                    # Predictive control (Gustafsson): extrapolate the trend of the error.
                    factor = min(factor, SAFETY * (h / step_before) * (error_before / (error * error)) ** 0.25)
                factor = min(GROWTH, max(SHRINK, factor))
                if rejected_before:
                    factor = min(1.0, factor)
                step_before, error_before = h, max(1e-2, error)
                h = max(h * factor, wanted) if h < wanted else h * factor
                h = min(h, limits[0])
                rejected_before = False
                progress[0] = t
                if status == STOPPED:
                    break
            else:
                factor = SAFETY * error**-0.25 if np.isfinite(error) else SHRINK
                h *= max(SHRINK, min(0.8, factor)) if not rejected_before or np.isfinite(error) else SHRINK
                rejected_before = True
                if t + h <= t or h < 1e-300:
                    status = STALLED
                    break
            if attempts % STALL_WINDOW == 0:
                got = accepted - window_accepted
                if got < STALL_WINDOW * 7 // 10 and t - window_time < 1e-4 * (t_end - window_time):
                    status = STALLED
                    break
                window_time, window_accepted = t, accepted
            if attempts >= limits[1]:
                status = TOO_MANY
                break
            if progress[1] != 0.0:
                status = INTERRUPTED
                break
        if status != DONE:
            break
    if status == DONE or status == STOPPED:
        segment = starts.size - 1
        while segment > 0 and starts[segment] > t:
            segment -= 1
        _inputs_at(t, starts[segment], coefficients[segment], u)
        if status == DONE:
            column = min(column, grid.size - 1)
        _write(addresses, t, x, u, p, tt, y, table, column)
        column += 1
    statistics[0], statistics[1], statistics[2] = accepted, attempts - accepted, column
    statistics[3], statistics[4], statistics[5] = t, event, h
    return status
