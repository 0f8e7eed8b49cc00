"""Generic integrator: step control, rows and stop conditions for a step function, which is passed by its address.

After a change of this file or `stepping.py`, Numba translates them to LLVM IR (`tools/make_integrator.py`). The text is
part of the package and is compiled on the user's machine (`poppet.engine.compiled`), so only developers need Numba. The
step of the method is printed with the model (`poppet.engine.printers.llvm_step`).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numba import carray, cfunc, types
from numba.np.unsafe.ndarray import to_fixed_tuple

from poppet.engine import stepping
from poppet.engine.job import Job
from poppet.engine.rosenbrock import SAFETY, SHRINK
from poppet.engine.stepping import (
    ACCEPTED,
    ATTEMPTS,
    COLUMN,
    CONDITION,
    DONE,
    STALL_WINDOW,
    STALLED,
    STOPPED,
    Control,
    Functions,
    Memory,
    OutputRows,
    RunState,
    Segment,
    Step,
    Stops,
    Work,
    compiled,
)

APART = ("act", "act_inside", "stop_inside", "write_rows")
"""Functions that are not inlined: copies of them would increase the code by half without a gain in speed."""
N_FIELDS = len(Job._fields)


@compiled
def _again(script, step, remaining):
    """Return the length of the next step of a run that repeats stored steps.

    `script` contains the lengths of the stored steps. If the stored length is not positive, or exceeds `remaining`, the
    step ends at the next instant.
    """
    h = script[min(step, script.size - 1)]
    return remaining if h <= 0.0 or h >= remaining else h


@compiled
def _accept(run, segment, step):
    """Accept a completed step, write its output rows, and return its end.

    The step ends early at a stop condition, or at an instant that changes the rates. counts[CONDITION] is then the
    index of the stop condition; otherwise it is -1.
    """
    memory, counts, end = run.memory, run.counts, step.end
    passes = memory.fired.size > 0 and stepping.next_instant(memory) < end - stepping.rounding(end)
    has_stops, reached = run.stops.weights.shape[0] > 0, end
    if has_stops or passes or run.rows.grid[counts[COLUMN]] < end:
        stepping.call2(run.functions.dense, run.work.stages, run.work.dense)
    if has_stops:
        event, theta = stepping.stop_inside(run, segment, step)
        counts[CONDITION], reached = event, step.t + theta * step.h if event >= 0 else end
    elif passes:
        reached = stepping.act_inside(run, segment, step)
    stepping.write_rows(run, segment, step, reached)
    stepping.take(run, run.work.inside if counts[CONDITION] >= 0 or reached < end else step.new)
    return reached


@compiled
def _over(run, segment, h):
    """Integrate over one segment of the inputs, and return status, end and next step length.

    If h is positive, it is the length of the first step. Otherwise the rates determine this length; if h is negative,
    -h is the maximum.
    """
    work, control, counts, memory, script = run.work, run.control, run.counts, run.memory, run.control.script
    t, stop, has_timers = segment.start, segment.stop, run.memory.fired.size > 0
    error_before, step_before, rejected, fresh, moves = 1e-2, 0.0, False, True, stepping.varies(segment)
    window, lands = t, run.stops.weights.shape[0] > 0 or script.size > 0
    # Last time at which discrete states changed the rates, and length of the first accepted step after it. A new
    # segment counts as progress, like a sample instant.
    calm, first, has_changed, has_acted = t, 0.0, True, has_timers or t > 0.0
    stepping.stage_inputs(run, segment, t, 0.0)
    while t < stop:
        if fresh:
            h = stepping.begin(run, segment, t, h)
            fresh = False
        desired, goal = stepping.reach(run, segment, t, h, calm, lands)
        h = _again(script, counts[ACCEPTED], goal - t) if control.replays else stepping.length(desired, goal - t)
        if moves:
            stepping.stage_inputs(run, segment, t, h)
        end = goal if h >= (goal - t) * (1.0 - 1e-12) else t + h
        work.tt[0], work.tt[1] = t, h
        stepping.call10(
            run.functions.step, work.tt, run.x, work.us, memory.p, work.rates, work.jacobian, work.drift,
            work.scratch, work.stages, work.new,
        )  # fmt: skip
        error = stepping.error(run)
        counts[ATTEMPTS] += 1
        if error <= 1.0 or (control.replays and np.isfinite(error)):
            if counts[ACCEPTED] < script.size and not control.replays:
                script[counts[ACCEPTED]] = -h if end == goal else h
            run.watch[0] = t = _accept(run, segment, Step(t, h, end, work.new))
            if counts[CONDITION] >= 0:
                return STOPPED, t, h
            fresh, error, changes = True, max(error, 1e-10), t < end
            factor = stepping.growth(error, h, error_before, step_before)
            step_before, error_before = h, max(1e-2, error)
            if has_changed:
                first, has_changed = h * min(2.0, max(0.5, factor)), False
            # A step that the end of the segment shortened does not reduce the desired length.
            h = max(desired, h * factor) if h < desired else h * (min(1.0, factor) if rejected else factor)
            rejected = False
            if has_timers and t < stop - stepping.rounding(stop):
                has_acted = True
                if stepping.act(run, segment, t, run.x) or changes:
                    # The rates have jumped: start with the length that was successful after the last jump.
                    h, step_before, calm, has_changed = min(h, first), 0.0, t, True
        else:
            h *= max(SHRINK, min(0.8, SAFETY / stepping.fourth_root(error))) if np.isfinite(error) else SHRINK
            rejected = True
            if t + h <= t or h < 1e-300 or control.replays:
                return STALLED, t, h
        status = stepping.verdict(run, t, window, has_acted)
        if status != DONE:
            return status, t, h
        if counts[ATTEMPTS] % STALL_WINDOW == 0:
            window, has_acted = t, False
    return DONE, t, h


@compiled
def _without_states(run, segment):
    """Process a segment of a circuit without states, and return the time at which it ends.

    Output rows and timers are processed in the order of time. Stop conditions are also evaluated between rows.
    """
    t, stop, counts, grid = segment.start, segment.stop, run.counts, run.rows.grid
    while t < stop:
        end = stop
        if run.memory.fired.size > 0:
            stepping.act(run, segment, t, run.x)
            instant = stepping.next_instant(run.memory)
            end = instant if instant < stop - stepping.rounding(stop) else stop
        if run.stops.weights.shape[0] > 0:
            row = counts[COLUMN]
            while row < grid.size - 1 and grid[row] <= t + stepping.rounding(t):
                row += 1
            end = grid[row] if grid[row] < end - stepping.rounding(end) else end
            event, theta = stepping.stop_inside(run, segment, Step(t, end - t, end, run.x))
            counts[CONDITION], end = event, t + theta * (end - t) if event >= 0 else end
        stepping.write_rows(run, segment, Step(t, end - t, end, run.x), end)
        t = end
        if counts[CONDITION] >= 0:
            break
    return t


@compiled
def _run_of(job):
    """Return the arrays of a `Job` as the data of a run.

    Arrays without an address of their own are parts of the scratch memory of the job.
    """
    n, n_c, n_u, n_y, n_z, n_m = job.n_states, job.n_controlled, job.n_inputs, job.n_outputs, job.n_memory, job.n_timers
    p = carray(stepping.doubles_at(job.p), (job.n_numbers + n_z,))
    limits = carray(stepping.doubles_at(job.limits), (4,))
    tolerances = carray(stepping.doubles_at(job.memory), (3, n_c))
    of_model = 12 * n + 6 * n_u + n_y + n_z + n_m
    tail = carray(stepping.doubles_at(job.memory + 24 * n_c), (of_model + 2 + job.n_jacobian + job.n_scratch,))
    vectors, tail = tail[: 12 * n], tail[12 * n :]
    u, us, slopes, tail = tail[:n_u], tail[n_u : 5 * n_u], tail[5 * n_u : 6 * n_u], tail[6 * n_u :]
    tt, jacobian, tail = tail[:2], tail[2 : 2 + job.n_jacobian], tail[2 + job.n_jacobian :]
    scratch, tail = tail[: job.n_scratch], tail[job.n_scratch :]
    fired, after, y = tail[:n_m], tail[n_m : n_m + n_z], tail[n_m + n_z :]
    work = Work(
        u, us, slopes, tt, vectors[:n], jacobian, vectors[n : 2 * n], scratch, vectors[6 * n :], vectors[11 * n :],
        vectors[2 * n : 3 * n], vectors[4 * n : 6 * n], vectors[3 * n : 4 * n],
    )  # fmt: skip
    return RunState(
        Functions(job.jacobian, job.step, job.dense, job.outputs, job.update),
        Memory(p, p[job.n_numbers :], carray(stepping.flags_at(job.acting), (n_z,)), fired, after),
        Control(
            tolerances, carray(stepping.flags_at(job.positive), (n_c,)), limits[0], limits[1],
            carray(stepping.doubles_at(job.script), (job.n_script,)), limits[2] > 0.0,
        ),
        OutputRows(
            carray(stepping.doubles_at(job.grid), (job.n_rows,)),
            carray(stepping.doubles_at(job.table), (n_y, job.n_rows)),
            y,
        ),
        Stops(
            carray(stepping.integers_at(job.places), (job.n_conditions, 2)),
            carray(stepping.doubles_at(job.weights), (job.n_conditions, 3)),
        ),
        work,
        carray(stepping.doubles_at(job.x), (n,)),
        carray(stepping.doubles_at(job.books), (3 * n,)),
        carray(stepping.doubles_at(job.watch), (2,)),
        carray(stepping.integers_at(job.counts), (5,)),
    )  # fmt: skip


def integrate(fields):
    """Integrate over all segments, and return the status.

    `fields` is the address of a `Job`.
    """
    job = Job(*to_fixed_tuple(carray(fields, (N_FIELDS,)), N_FIELDS))
    run = _run_of(job)
    n, n_u, n_k, counts, grid = job.n_states, job.n_inputs, job.n_segments, run.counts, run.rows.grid
    starts, jumps = carray(stepping.doubles_at(job.starts), (n_k,)), carray(stepping.flags_at(job.jumps), (n_k,))
    courses = carray(stepping.integers_at(job.courses), (n_k,))
    coefficients = carray(stepping.doubles_at(job.coefficients), (job.n_courses, n_u, 7))
    limits, scales = (
        carray(stepping.doubles_at(job.limits), (4,)),
        carray(stepping.doubles_at(job.scales), (3, job.n_controlled)),
    )
    # Without a tolerance, the run continues with the tolerances and the step length of the previous run.
    if limits[3] > 0.0:
        stepping.set_tolerances(run.control, scales, limits[3], run.x)
        run.work.tt[1] = 0.0
    for s in range(n):
        run.books[s], run.books[n + s], run.books[2 * n + s] = run.x[s], run.x[s], 0.0
    counts[CONDITION] = -1
    status, t, h = DONE, starts[0], run.work.tt[1]
    segment = Segment(t, t, coefficients[courses[0]])
    for k in range(n_k):
        t = starts[k]
        segment = Segment(t, starts[k + 1] if k + 1 < n_k else grid[-1], coefficients[courses[k]])
        if job.n_timers > 0:
            stepping.act(run, segment, t, run.x)
        if job.n_conditions > 0:
            counts[CONDITION] = stepping.stop_condition(run, segment, t, run.x)
            if counts[CONDITION] >= 0:
                status = STOPPED
                break
        # After a jump of an input, the step length is selected again and is at most the previous length.
        h = -h if jumps[k] else h
        if n > 0:
            status, t, h = _over(run, segment, h)
        else:
            t = _without_states(run, segment)
            status = STOPPED if counts[CONDITION] >= 0 else DONE
        if status != DONE:
            break
    if status == DONE or status == STOPPED:
        counts[COLUMN] = min(counts[COLUMN], grid.size - 1)
        stepping.write_row(run, segment, t, run.x)
    run.watch[0], run.work.tt[1] = t, h
    return status


def integrator_text() -> str:
    """Return LLVM IR of the integrator of single runs, the function `i64 integrate(ptr)`."""
    return portable_text(integrate, APART)


def portable_text(function: Any, apart: Sequence[str]) -> str:
    """Return LLVM IR of an integrator that needs neither Python nor the run-time library of Numba.

    The wrapper of Numba is replaced, because it needs Numba in the process. Reference counts are removed, because the
    arrays of `carray` have no owner. The functions named in `apart` are not inlined. The compilation takes seconds.
    """
    compiled = cfunc(types.int64(types.CPointer(types.int64)), nopython=True, error_model="numpy")(function)
    text = compiled._library.get_llvm_str()
    wrapper = compiled.native_name
    name = re.escape(wrapper.removeprefix("cfunc."))
    inner = re.search(rf'^define .*?i32 @("?[\w.$]*{name}"?)\(', text, re.M)
    assert inner is not None
    begin = text.index(f"define i64 @{wrapper}(")
    text = text[:begin] + text[text.index("\n}\n", begin) + 3 :]
    text = re.sub(r"^define (?!linkonce_odr|internal)", "define internal ", text, flags=re.M)
    text = text.replace("define linkonce_odr", "define internal")
    names = "|".join(f"{len(name)}{name}" for name in apart)
    text = re.sub(rf"^(define [^\n]*(?:stepping|lanes)(?:{names})[^\n]*) {{$", r"\1 noinline {", text, flags=re.M)
    text = re.sub(r"^ *(?:tail )?call void @NRT_(?:incref|decref)\(.*$", "", text, flags=re.M)
    # A square root without an error number is one instruction.
    root = "declare double @llvm.sqrt.f64(double)"
    text = re.sub(r"^declare double @sqrt\(.*$", "" if root in text else root, text, flags=re.M)
    text = text.replace("@sqrt(", "@llvm.sqrt.f64(")
    entry = """
define i64 @ENTRY(ptr %job) {
  %status = alloca i64
  %problem = alloca ptr
  store i64 0, ptr %status
  call i32 @INNER(ptr %status, ptr %problem, ptr %job)
  %result = load i64, ptr %status
  ret i64 %result
}
"""
    return text + entry.replace("INNER", inner.group(1)).replace("ENTRY", function.__name__)
