"""Integrator of lanes: several simultaneous runs, each with its own time, step size, segment, errors and rows.

A step is printed for vectors (`poppet.engine.printers.llvm_lanes`) without branches, so no lane waits for another. The
work between steps is done per lane, as in `poppet.engine.integrator`. A lane that has completed its run takes the next
run from the queue. This file is compiled like `integrator.py`.

Arguments of the functions are the fields of a `LaneJob` as an array f, and the index i of a lane. Arrays are created
where they are used, which keeps the compiled text short.

In lockstep (if the third of `limits` is 1), all lanes use the steps of the first lane, so the results of their runs are
smooth functions of the parameters. These runs begin together and have no events.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import carray, types
from numba.extending import intrinsic

from poppet.engine import integrator, stepping
from poppet.engine.job import (
    BEFORE,
    CALM,
    END,
    ERROR,
    FACTOR,
    FIRST,
    GOAL,
    LENGTH,
    LOOK,
    MASKS,
    NEXT,
    REFUSED,
    ROOT_BEFORE,
    STEP_BEFORE,
    STOP,
    TAKEN,
    TAKES,
    TRIES,
    WANTED,
    WINDOW,
    LaneJob,
)
from poppet.engine.rosenbrock import INPUT_TIMES
from poppet.engine.stepping import (
    ACCEPTED,
    ATTEMPTS,
    COLUMN,
    CONDITION,
    DONE,
    IN_WINDOW,
    INTERRUPTED,
    STALL_WINDOW,
    STALLED,
    STOPPED,
    TOO_MANY,
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

APART = (
    *integrator.APART,
    "begin_run",
    "enter",
    "finish",
    "onward",
    "events",
    "stop_at",
    "moving_rows",
    "inputs",
    "goal",
    "ending",
    "take_rows",
    "take_events",
    "after_change",
)
"""Functions that are not inlined: all functions that are not called in each step of each lane."""
AT = LaneJob(*range(len(LaneJob._fields)))
"""Indices of the fields."""
RUN, SEGMENT, MOVES, HAS_CHANGED, HAS_ACTED, ENDED = range(6)
"""Rows of the flags: run or -1; segment; 1 if inputs change, if discrete states changed the rates, if timers acted; end
of the segment, -1 while it continues."""
_TIMES = np.array(INPUT_TIMES)
OUTCOME = 5
"""Index of the outcome in `counts`, after those of `poppet.engine.stepping`."""


def jumper(count: int) -> Any:
    """Return a Numba intrinsic that calls machine code with `count` integers as arguments.

    The integers are addresses. The first argument of the intrinsic is the address of the code.
    """

    def typed(typing_context: Any, address: Any, *places: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            word = ir.IntType(64)
            kind = ir.FunctionType(ir.VoidType(), [word] * count)
            builder.call(builder.inttoptr(arguments[0], ir.PointerType(kind)), arguments[1:])
            return context.get_dummy_value()

        return types.void(types.int64, *[types.int64] * count), generate

    names = ", ".join(f"a{k}" for k in range(count))
    scope: dict[str, Any] = {"typed": typed}
    exec(f"def call(typing_context, address, {names}):\n    return typed(typing_context, address, {names})", scope)
    return intrinsic(scope["call"])


call2, call3, call4, call7, call8, call10, call11 = (jumper(k) for k in (2, 3, 4, 7, 8, 10, 11))
call3_arrays = stepping.caller(3)


@compiled
def rows(f, field):
    """Return a field of the job f as an array whose rows contain one double for each lane."""
    return carray(stepping.doubles_at(f[field]), (1, f[AT.width]))


@compiled
def flags_of(f):
    """Return the array of flags, which has one column for each lane.

    Constants such as `RUN` are the row indices.
    """
    return carray(stepping.integers_at(f[AT.flags]), (1, f[AT.width]))


@compiled
def doubles(f, field, size):
    """Return the array of `size` doubles whose address is a field of the job f."""
    return carray(stepping.doubles_at(f[field]), (size,))


@compiled
def integers(f, field, size):
    """Return the array of `size` integers whose address is a field of the job f."""
    return carray(stepping.integers_at(f[field]), (size,))


@compiled
def counts_of(f, run):
    """Return the counts of a run, such as the number of its accepted steps.

    `run` is the index of the run.
    """
    return carray(stepping.integers_at(f[AT.counts] + 48 * run), (6,))


@compiled
def own_of(f, i):
    """Return the array with parameters and discrete states of lane i."""
    size = f[AT.n_numbers] + f[AT.n_memory]
    return carray(stepping.doubles_at(f[AT.own] + 8 * i * size), (size,))


@compiled
def table_at(f, run):
    """Return the address of the output table of a run.

    `run` is the index of the run.
    """
    return f[AT.table] + 8 * (run - f[AT.base]) * f[AT.n_outputs] * f[AT.n_rows]


@compiled
def gather(f, field, i, one):
    """Copy the values of lane i from a field of the job f into the array `one`."""
    vector = rows(f, field)
    for s in range(one.size):
        one[s] = vector[s, i]


@compiled
def scatter(f, field, i, one):
    """Copy the array `one` into the values of lane i in a field of the job f."""
    vector = rows(f, field)
    for s in range(one.size):
        vector[s, i] = one[s]


@compiled
def single(f, i):
    """Return the run in lane i for the functions of `poppet.engine.stepping`.

    Its states are undefined until `gather` copies them.
    """
    n, n_c, n_u, n_z, n_y = f[AT.n_states], f[AT.n_controlled], f[AT.n_inputs], f[AT.n_memory], f[AT.n_outputs]
    run, at, own = flags_of(f)[RUN, i], f[AT.one], own_of(f, i)
    vectors = carray(stepping.doubles_at(at), (6 * n + 2 * n_u,))
    at += 8 * vectors.size
    tt, y = carray(stepping.doubles_at(at), (2,)), carray(stepping.doubles_at(at + 16), (n_y,))
    at += 8 * (2 + n_y)
    fired = carray(stepping.doubles_at(at), (f[AT.n_timers],))
    after = carray(stepping.doubles_at(at + 8 * fired.size), (n_z,))
    at += 8 * (fired.size + n_z)
    nothing, limits, n_conditions = vectors[:0], doubles(f, AT.limits, 4), f[AT.n_conditions]
    work = Work(
        vectors[6 * n : 6 * n + n_u], nothing, vectors[6 * n + n_u :], tt, nothing, nothing, vectors[:n], nothing,
        nothing, nothing, vectors[n : 2 * n], vectors[2 * n : 4 * n], vectors[4 * n : 5 * n],
    )  # fmt: skip
    return RunState(
        Functions(0, 0, 0, f[AT.outputs], f[AT.update]),
        Memory(own, own[f[AT.n_numbers] :], carray(stepping.flags_at(f[AT.acting]), (n_z,)), fired, after),
        Control(
            carray(stepping.doubles_at(at), (3, n_c)), carray(stepping.flags_at(f[AT.positive]), (n_c,)),
            limits[0], limits[1], nothing, False,
        ),
        OutputRows(
            doubles(f, AT.grid, f[AT.n_rows]), carray(stepping.doubles_at(table_at(f, run)), (n_y, f[AT.n_rows])), y
        ),
        Stops(
            carray(stepping.integers_at(f[AT.places]), (n_conditions, 2)),
            carray(stepping.doubles_at(f[AT.weights]), (n_conditions, 3)),
        ),
        work, vectors[5 * n : 6 * n], nothing, doubles(f, AT.watch, 2), counts_of(f, run),
    )  # fmt: skip


@compiled
def segment_of(f, i):
    """Return the present segment of the inputs in lane i."""
    k, n_k, n_u = flags_of(f)[SEGMENT, i], f[AT.n_segments], f[AT.n_inputs]
    starts = doubles(f, AT.starts, n_k)
    stop = starts[k + 1] if k + 1 < n_k else doubles(f, AT.grid, f[AT.n_rows])[-1]
    course = integers(f, AT.courses, n_k)[k] + (i * f[AT.n_courses] if f[AT.n_held] > 0 else 0)
    return Segment(starts[k], stop, carray(stepping.doubles_at(f[AT.coefficients] + 56 * n_u * course), (n_u, 7)))


@compiled
def act(f, i, run, segment, t, x):
    """Run the timers of lane i that are due at the time t, and return True if the rates have changed."""
    has_changed = stepping.act(run, segment, t, x)
    vector = rows(f, AT.p)
    for k in range(f[AT.n_memory]):
        vector[f[AT.n_numbers] + k, i] = run.memory.z[k]
    return has_changed


@compiled
def weigh(f, run, record):
    """Write the energies of the state of a run, which do not depend on inputs, into `record`."""
    if f[AT.n_energies] > 0:
        for k in range(run.work.u.size):
            run.work.u[k] = 0.0
        run.work.tt[0] = 0.0
        stepping.call5(f[AT.energy], run.work.tt, run.x, run.work.u, run.memory.p, record)


@compiled
def begin_run(f, i, k):
    """Start run k in lane i.

    Its parameters, initial state, tolerances, extremes and sums are set.
    """
    flags_of(f)[RUN, i], flags_of(f)[SEGMENT, i] = k, -1
    control = rows(f, AT.control)
    control[LENGTH, i] = control[TRIES, i] = control[TAKES, i] = 0.0
    control[NEXT, i], control[LOOK, i] = doubles(f, AT.grid, 1)[0], min(STALL_WINDOW, doubles(f, AT.limits, 2)[1])
    run, n, n_c, n_varied = single(f, i), f[AT.n_states], f[AT.n_controlled], f[AT.n_varied]
    own, numbers, after = run.memory.p, doubles(f, AT.numbers, own_of(f, i).size), run.memory.after
    for j in range(own.size):
        own[j] = numbers[j]
    varied, values = integers(f, AT.varied, n_varied), carray(stepping.doubles_at(f[AT.values]), (1, n_varied))
    for j in range(n_varied):
        own[varied[j]] = values[k, j]
    held, n_courses = carray(stepping.integers_at(f[AT.held]), (1, 2)), f[AT.n_courses]
    coefficients = carray(stepping.doubles_at(f[AT.coefficients]), (1, f[AT.n_inputs], 7))
    for j in range(f[AT.n_held]):
        for c in range(n_courses):
            coefficients[i * n_courses + c, held[j, 0], 0] = own[held[j, 1]]
    call3_arrays(f[AT.start], own, run.x, after)
    for j in range(after.size):
        own[f[AT.n_numbers] + j] = after[j]
    scatter(f, AT.p, i, own)
    # For all lanes; it changes only this lane.
    call2(f[AT.derived], f[AT.p], f[AT.p] + 8 * f[AT.width] * own.size)
    scatter(f, AT.x, i, run.x)
    relative = doubles(f, AT.limits, 4)[3]
    stepping.set_tolerances(run.control, carray(stepping.doubles_at(f[AT.scales]), (3, n_c)), relative, run.x)
    tolerances, sizes, given = rows(f, AT.tolerances), rows(f, AT.sizes), run.control.tolerances
    for s in range(n_c):
        tolerances[s, i], tolerances[n_c + s, i], sizes[s, i] = given[0, s], given[1, s], given[2, s]
    record, books = doubles(f, AT.record, (k + 1) * f[AT.n_record])[k * f[AT.n_record] :], rows(f, AT.books)
    for s in range(n):
        record[s] = books[s, i] = books[n + s, i] = run.x[s]
        books[2 * n + s, i] = 0.0
    weigh(f, run, record[5 * n :])
    for j in range(OUTCOME):
        run.counts[j] = 0
    run.counts[CONDITION] = -1


@compiled
def inputs(f, i, segment, t):
    """Compute the inputs of lane i and their slopes at the time t, the start of a step."""
    work = single(f, i).work
    stepping.inputs_at(t, segment, work.u)
    stepping.input_slopes_at(t, segment, work.slopes)
    scatter(f, AT.u, i, work.u)
    scatter(f, AT.slopes, i, work.slopes)


@compiled
def stage_inputs(f, i, segment, t, h):
    """Compute the inputs of lane i at all solver stages of a step from t to t + h."""
    u, us = single(f, i).work.u, rows(f, AT.us)
    for stage in range(4):
        stepping.inputs_at(t + _TIMES[stage] * h, segment, u)
        for k in range(u.size):
            us[stage * u.size + k, i] = u[k]


@compiled
def stop_at(f, i, segment):
    """Run the timers of lane i at the start of a segment, and check the stop conditions.

    The result is the index of the first true stop condition, or -1.
    """
    run = single(f, i)
    gather(f, AT.x, i, run.x)
    if f[AT.n_timers] > 0:
        act(f, i, run, segment, segment.start, run.x)
    if f[AT.n_conditions] > 0:
        run.counts[CONDITION] = stepping.stop_condition(run, segment, segment.start, run.x)
    return run.counts[CONDITION]


@compiled
def enter(f, i):
    """Start the next segment of lane i.

    The result is STOPPED if a stop condition is true, and DONE otherwise.
    """
    control, flags = rows(f, AT.control), flags_of(f)
    flags[SEGMENT, i] += 1
    segment, has_timers = segment_of(f, i), f[AT.n_timers] > 0
    t = segment.start
    rows(f, AT.th)[0, i], control[STOP, i], control[GOAL, i] = t, segment.stop, segment.stop
    if (has_timers or f[AT.n_conditions] > 0) and stop_at(f, i, segment) >= 0:
        return STOPPED
    if carray(stepping.flags_at(f[AT.jumps]), (f[AT.n_segments],))[flags[SEGMENT, i]]:
        control[LENGTH, i] = -control[LENGTH, i]
    control[ROOT_BEFORE, i], control[STEP_BEFORE, i] = 0.01**0.25, 0.0
    control[WINDOW, i] = control[CALM, i] = t
    control[FIRST, i] = control[REFUSED, i] = 0.0
    flags[HAS_CHANGED, i], flags[ENDED, i] = 1, -1
    # A new segment counts as progress, like a sample instant.
    flags[HAS_ACTED, i] = 1 if has_timers or t > 0.0 else 0
    flags[MOVES, i] = 1 if stepping.varies(segment) else 0
    inputs(f, i, segment, t)
    stage_inputs(f, i, segment, t, 0.0)
    return DONE


@compiled
def finish(f, i, status):
    """Store the results of the run in lane i, with its last output row.

    `status` is the outcome of the run.
    """
    run, n, n_e, n_y, n_rows = single(f, i), f[AT.n_states], f[AT.n_energies], f[AT.n_outputs], f[AT.n_rows]
    counts, table, t, k = run.counts, run.rows.table, rows(f, AT.th)[0, i], flags_of(f)[RUN, i]
    counts[ATTEMPTS], counts[ACCEPTED] = int(rows(f, AT.control)[TRIES, i]), int(rows(f, AT.control)[TAKES, i])
    gather(f, AT.x, i, run.x)
    record = doubles(f, AT.record, (k + 1) * f[AT.n_record])[k * f[AT.n_record] :]
    if status == DONE or status == STOPPED:
        counts[COLUMN] = min(counts[COLUMN], n_rows - 1)
        stepping.write_row(run, segment_of(f, i), t, run.x)
        record[-1] = t
    else:
        record[-1] = run.rows.grid[counts[COLUMN] - 1] if counts[COLUMN] > 0 else 0.0
    column, counts[OUTCOME], books = counts[COLUMN], status, rows(f, AT.books)
    for s in range(n):
        record[n + s] = run.x[s]
    for s in range(3 * n):
        record[2 * n + s] = books[s, i]
    weigh(f, run, record[5 * n + n_e :])
    for y in range(n_y):
        record[5 * n + 2 * n_e + y] = table[y, column - 1] if column > 0 else np.nan
        for c in range(column, n_rows):
            table[y, c] = np.nan


@compiled
def rest(f, i):
    """Make lane i idle, with a copy of the values of the first lane.

    The vector functions also compute idle lanes, and are slow for values that are not finite.
    """
    control, n_u = rows(f, AT.control), f[AT.n_inputs]
    flags_of(f)[RUN, i], flags_of(f)[MOVES, i], control[LENGTH, i] = -1, 0, 1e-9
    control[STOP, i] = control[GOAL, i] = control[NEXT, i] = control[LOOK, i] = np.inf
    f[AT.busy] -= 1
    for field, size in (
        (AT.x, f[AT.n_states]),
        (AT.u, n_u),
        (AT.us, 4 * n_u),
        (AT.slopes, n_u),
        (AT.tolerances, 2 * f[AT.n_controlled]),
        (AT.p, f[AT.n_numbers] + f[AT.n_memory] + f[AT.n_derived]),
    ):
        vector = rows(f, field)
        for s in range(size):
            vector[s, i] = vector[s, 0]


@compiled
def onward(f, i, status):
    """Process the end of a segment of lane i, whose status is given.

    The lane starts its next segment or the next run. If there is none, it becomes idle.
    """
    flags = flags_of(f)
    while True:
        if flags[RUN, i] >= 0:
            if status == DONE and flags[SEGMENT, i] + 1 < f[AT.n_segments]:
                status = enter(f, i)
                if status == DONE and rows(f, AT.th)[0, i] < rows(f, AT.control)[STOP, i]:
                    return
                continue
            finish(f, i, status)
        if f[AT.first] >= f[AT.last] or doubles(f, AT.watch, 2)[1] != 0.0:
            rest(f, i)
            return
        begin_run(f, i, f[AT.first])
        f[AT.first] += 1
        status = DONE


@compiled
def first_step(f, i, h):
    """Return the length of the first step of lane i after a jump.

    If h is negative, the maximum length is -h. The function `begin` in `poppet.engine.stepping` uses the same rule.
    """
    rates, x, sizes = rows(f, AT.rates), rows(f, AT.x), rows(f, AT.sizes)
    fastest = 20.0 / (rows(f, AT.control)[STOP, i] - rows(f, AT.th)[0, i])
    for s in range(f[AT.n_controlled]):
        fastest = max(fastest, 20.0 * abs(rates[s, i]) / (abs(x[s, i]) + sizes[s, i]))
    return min(-h, 1.0 / fastest) if h < 0.0 else 1.0 / fastest


@compiled
def goal(f, i, t, h):
    """Return the desired length of a step of lane i with timers, and the latest time at which it can end."""
    return stepping.reach(single(f, i), segment_of(f, i), t, h, rows(f, AT.control)[CALM, i], f[AT.n_conditions] > 0)


@compiled
def follow(f, i, control, th):
    """Set the length of the next step of lane i to the step length of the first lane."""
    th[1, i], control[WANTED, i], control[END, i] = th[1, 0], control[WANTED, 0], control[END, 0]
    if flags_of(f)[MOVES, i]:
        stage_inputs(f, i, segment_of(f, i), th[0, i], th[1, i])


@compiled
def led(i, control, flags):
    """Return the status that ends the run of lane i in lockstep, or -1 if it continues.

    The run ends early together with the run of the first lane. It stalls if its error is infinite after an accepted
    step of the first lane; other errors have no effect.
    """
    if flags[ENDED, 0] > DONE:
        return flags[ENDED, 0]
    return STALLED if control[TAKEN, 0] != 0.0 and control[TAKEN, i] == 0.0 else -1


@compiled
def write_rows(f, i, run, function, u):
    """Write the output rows of lane i before the time in row `BEFORE` of `control`.

    `function` is the address of `rows` or `rows_held`, and u the address of the inputs.
    """
    side = 8 * i
    call11(
        function, f[AT.grid], table_at(f, run), f[AT.counts] + 48 * run + 8 * COLUMN, f[AT.row_length],
        f[AT.control] + 8 * BEFORE * f[AT.width] + side, f[AT.th] + side, f[AT.x] + side, f[AT.new] + side,
        f[AT.interpolant] + side, u, f[AT.p] + side,
    )  # fmt: skip


@compiled
def moving_rows(f, i, run):
    """Write the output rows of lane i inside a completed step with changing inputs."""
    width, n_rows, segment, u = f[AT.width], f[AT.n_rows], segment_of(f, i), single(f, i).work.u
    column, grid, before = counts_of(f, run), doubles(f, AT.grid, n_rows + width), rows(f, AT.control)[BEFORE, i]
    while grid[column[COLUMN]] < before:
        for k in range(width):
            stepping.inputs_at(min(grid[column[COLUMN] + k], before), segment, u)
            scatter(f, AT.rows_u, k, u)
        write_rows(f, i, run, f[AT.rows], f[AT.rows_u])


@compiled
def events(f, i, t, h, end):
    """Process output rows, stop conditions and timers in a completed step of lane i.

    The result is the time at which the step ends, and True if the rates have changed there. If the step ends early, the
    new state is replaced by the state at this time.
    """
    run, segment = single(f, i), segment_of(f, i)
    work, counts, memory = run.work, run.counts, run.memory
    gather(f, AT.x, i, run.x)
    gather(f, AT.new, i, work.new)
    gather(f, AT.interpolant, i, work.dense)
    step, reached = Step(t, h, end, work.new), end
    if f[AT.n_conditions] > 0:
        event, theta = stepping.stop_inside(run, segment, step)
        counts[CONDITION], reached = event, t + theta * h if event >= 0 else end
    elif memory.fired.size > 0 and stepping.next_instant(memory) < end - stepping.rounding(end):
        reached = stepping.act_inside(run, segment, step)
    stepping.write_rows(run, segment, step, reached)
    if counts[CONDITION] >= 0 or reached < end:
        for s in range(run.x.size):
            work.new[s] = work.inside[s]
        scatter(f, AT.new, i, work.new)
    if memory.fired.size == 0 or counts[CONDITION] >= 0:
        return reached, False
    has_changed = False
    if reached < segment.stop - stepping.rounding(segment.stop):
        flags_of(f)[HAS_ACTED, i] = 1
        has_changed = act(f, i, run, segment, reached, work.new)
    else:
        # Instants inside the step have also changed discrete states.
        vector = rows(f, AT.p)
        for k in range(memory.z.size):
            vector[f[AT.n_numbers] + k, i] = memory.z[k]
    return reached, has_changed or reached < end


@compiled
def take_events(f, i, control, th):
    """Process output rows and events in a completed step of lane i, and store its end.

    The result is True if the rates have changed at the end.
    """
    end, has_changed = events(f, i, th[0, i], th[1, i], control[END, i])
    control[END, i] = end
    return has_changed


@compiled
def take_rows(f, i, control, flags, run):
    """Write the output rows of lane i inside a completed step, for a circuit without events."""
    end = control[END, i]
    control[BEFORE, i] = end - stepping.rounding(end)
    if flags[MOVES, i]:
        moving_rows(f, i, run)
    else:
        write_rows(f, i, run, f[AT.rows_held], f[AT.u] + 8 * i)
    control[NEXT, i] = doubles(f, AT.grid, 1)[counts_of(f, run)[COLUMN]]


@compiled
def after_change(i, control, th, flags, has_changed):
    """Set the step length of lane i after a step, at whose end the rates may have changed."""
    if flags[HAS_CHANGED, i]:
        control[FIRST, i], flags[HAS_CHANGED, i] = th[1, i] * min(2.0, max(0.5, control[FACTOR, i])), 0
    end = th[0, i]
    if has_changed and end < control[STOP, i] - stepping.rounding(control[STOP, i]):
        # The rates have jumped: start with the length that was successful after the last jump.
        control[LENGTH, i], control[STEP_BEFORE, i] = min(control[LENGTH, i], control[FIRST, i]), 0.0
        control[CALM, i], flags[HAS_CHANGED, i] = end, 1


@compiled
def verdict(f, i, counts, most):
    """Return the status that ends the run of lane i after an attempted step, or -1.

    The function `verdict` in `poppet.engine.stepping` uses the same rules. `most` is the maximum number of attempts.
    """
    control = rows(f, AT.control)
    tries, takes = int(control[TRIES, i]), int(control[TAKES, i])
    if tries % STALL_WINDOW == 0:
        flags, t = flags_of(f), rows(f, AT.th)[0, i]
        window, end = control[WINDOW, i], doubles(f, AT.grid, f[AT.n_rows])[-1]
        slow = t - window < 1e-4 * (end - window) and not flags[HAS_ACTED, i]
        if takes - counts[IN_WINDOW] < STALL_WINDOW * 7 // 10 and slow:
            return STALLED
        counts[IN_WINDOW] = takes
        control[WINDOW, i], flags[HAS_ACTED, i] = t, 0
    control[LOOK, i] = min((tries // STALL_WINDOW + 1) * STALL_WINDOW, most)
    if tries >= most:
        return TOO_MANY
    return INTERRUPTED if doubles(f, AT.watch, 2)[1] != 0.0 else -1


@compiled
def ending(f, i, control, th, flags):
    """Return the status with which a step of lane i ends its segment, or -1 if the segment continues."""
    counts, t, h = counts_of(f, flags[RUN, i]), th[0, i], control[LENGTH, i]
    if control[TAKEN, i] == 0.0:
        ended = STALLED if t + h <= t or h < 1e-300 else -1
    elif counts[CONDITION] >= 0:
        ended = STOPPED
    else:
        ended = -1 if t < control[STOP, i] else DONE
    limits = doubles(f, AT.limits, 4)
    if limits[2] != 0.0 and i > 0:
        return max(min(ended, DONE), led(i, control, flags))
    if ended < STOPPED and (control[TRIES, i] >= control[LOOK, i] or doubles(f, AT.watch, 2)[1] != 0.0):
        given_up = verdict(f, i, counts, limits[1])
        return given_up if given_up >= 0 else ended
    return ended


@compiled
def begin_step(f, control, th, flags):
    """Compute rates, Jacobian, step lengths and stage inputs of all lanes at the start of a step.

    The result is True if an input changes in a lane.
    """
    width, moves, leads = f[AT.width], False, doubles(f, AT.limits, 4)[2] != 0.0
    for i in range(width):
        moves |= flags[MOVES, i] != 0
    jacobian = f[AT.jacobian] if moves else f[AT.jacobian_held]
    call8(jacobian, f[AT.th], f[AT.x], f[AT.u], f[AT.slopes], f[AT.p], f[AT.rates], f[AT.j], f[AT.drift])
    for i in range(width):
        if control[LENGTH, i] <= 0.0:
            control[LENGTH, i] = first_step(f, i, control[LENGTH, i])
    if f[AT.n_timers] > 0:
        for i in range(width):
            if flags[RUN, i] >= 0:
                control[LENGTH, i], control[GOAL, i] = goal(f, i, th[0, i], control[LENGTH, i])
    call3(f[AT.choose], f[AT.control], f[AT.th], f[AT.limits])
    if leads:
        for i in range(1, width):
            follow(f, i, control, th)
    if moves:
        for i in range(width):
            if flags[MOVES, i]:
                stage_inputs(f, i, segment_of(f, i), th[0, i], th[1, i])
    return moves


@compiled
def advance(f):
    """Compute one step of all lanes, with its output rows and events."""
    width, flags, control, th = f[AT.width], flags_of(f), rows(f, AT.control), rows(f, AT.th)
    has_events, leads = f[AT.n_timers] > 0 or f[AT.n_conditions] > 0, doubles(f, AT.limits, 4)[2] != 0.0
    masks = carray(stepping.integers_at(f[AT.control] + 8 * MASKS * width), (2,))
    moves = begin_step(f, control, th, flags)
    call10(
        f[AT.step], f[AT.th], f[AT.x], f[AT.us], f[AT.p], f[AT.rates], f[AT.j], f[AT.drift], f[AT.scratch],
        f[AT.stages], f[AT.new],
    )  # fmt: skip
    call7(f[AT.judge], f[AT.tolerances], f[AT.low], f[AT.x], f[AT.new], f[AT.estimate], f[AT.th], f[AT.control])
    if leads or has_events:
        masks[0] = 0
        for i in range(width):
            if leads and i > 0:
                control[TAKEN, i] = control[TAKEN, 0] if control[ERROR, i] < np.inf else 0.0
            if flags[RUN, i] >= 0 and control[TAKEN, i] != 0.0 and (has_events or control[NEXT, i] < control[END, i]):
                masks[0] |= 1 << i
    changed, seen = 0, masks[0]
    if seen != 0:
        call2(f[AT.dense], f[AT.stages], f[AT.interpolant])
        for i in range(width):
            if seen >> i & 1 != 0:
                if has_events:
                    changed |= int(take_events(f, i, control, th)) << i
                else:
                    take_rows(f, i, control, flags, flags[RUN, i])
    call2(f[AT.settle], f[AT.control], f[AT.th])
    if has_events:
        for i in range(width):
            if seen >> i & 1 != 0:
                after_change(i, control, th, flags, changed >> i & 1 != 0)
    if moves:
        for i in range(width):
            if flags[MOVES, i] and control[TAKEN, i] != 0.0:
                inputs(f, i, segment_of(f, i), th[0, i])
    call4(f[AT.commit], f[AT.control], f[AT.x], f[AT.new], f[AT.books])
    if masks[1] != 0 or has_events or leads or doubles(f, AT.watch, 2)[1] != 0.0:
        has_ended = False
        for i in range(width):
            if flags[RUN, i] >= 0:
                flags[ENDED, i] = ending(f, i, control, th, flags)
                has_ended |= flags[ENDED, i] >= 0
        if has_ended:
            for i in range(width):
                if flags[RUN, i] >= 0 and flags[ENDED, i] >= 0:
                    onward(f, i, flags[ENDED, i])


def integrate_lanes(fields):
    """Compute the runs `first` to `last` - 1 in lanes; `fields` is the address of a `LaneJob`."""
    f = carray(fields, (len(AT),))
    width, n_c = f[AT.width], f[AT.n_controlled]
    low, positive = rows(f, AT.low), carray(stepping.flags_at(f[AT.positive]), (n_c,))
    f[AT.busy] = width
    for i in range(width):
        for s in range(n_c):
            low[s, i] = 0.0 if positive[s] else -np.inf
        flags_of(f)[RUN, i] = -1
        onward(f, i, DONE)
    while f[AT.busy] > 0:
        advance(f)
    return 0


def lanes_text() -> str:
    """Return LLVM IR of the integrator of lanes, the function `i64 integrate_lanes(ptr)`."""
    return integrator.portable_text(integrate_lanes, APART)
