"""What compiled code is handed: addresses of arrays, and for the integrator one row of them and of lengths."""

from __future__ import annotations

from ctypes import addressof, c_char
from typing import Any, NamedTuple


def address(array: Any) -> int:
    """Where the numbers of a contiguous array lie; 0 for an empty one."""
    if not array.size:
        return 0
    try:
        # A third of the time of `array.ctypes.data`, and refuses what is not contiguous.
        return addressof(c_char.from_buffer(array))
    except TypeError:  # not writable
        return int(array.ctypes.data)


ERROR, FACTOR, SHRUNK, ROOT, ROOT_BEFORE, STEP_BEFORE, TAKEN, REFUSED, *_TIMES = range(22)
"""Rows of the control of lanes: error of the step just made, factors on the step where it is taken and where not,
fourth root of the error and that of the step before, the length of that, 1 where the step is taken, and where the one
before was not."""
LENGTH, WANTED, GOAL, END, STOP, NEXT, TRIES, TAKES, LOOK, MASKS, *_OF_ONE = _TIMES
"""Length of the next step, length wanted of a step, where it has to end at the latest and where it does, end of the
segment, time of the next row, attempts, accepted steps, the attempt after which progress is judged. In the last row two
whole numbers with a bit for each lane: of those with rows in the step, and of those whose segment or run has ended or
is to be judged."""
CALM, FIRST, WINDOW, BEFORE = _OF_ONE
"""And what only the integrator uses, as in `_over` of the integrator; time before which rows are written."""


class Job(NamedTuple):
    """Addresses of the model's functions, lengths, addresses of arrays; every field is a whole number of 64 bits."""

    # Functions, 0 where the model has none.
    jacobian: int
    step: int
    dense: int
    outputs: int
    update: int
    # Of the model: quadratures count as states, and without inputs there is room for one.
    n_states: int
    n_controlled: int
    n_inputs: int
    n_outputs: int
    n_numbers: int
    n_memory: int
    n_timers: int
    n_jacobian: int  # nonzeros
    n_scratch: int  # what `step` needs besides
    scales: int  # (3, n_controlled) factor on the relative tolerance, floor, nominal size
    positive: int  # (n_controlled) which must stay positive
    acting: int  # (n_memory) on which of them the rates depend
    # Of the run.
    n_segments: int
    n_courses: int
    n_rows: int
    n_conditions: int
    n_script: int
    x: int  # (n_states) in and out
    p: int  # numbers, then the memory, in and out
    starts: int  # (n_segments)
    courses: int  # (n_segments) which coefficients hold
    coefficients: int  # (n_courses, n_inputs, 7)
    jumps: int  # (n_segments)
    grid: int  # (n_rows) output times, the last one is the end
    # Longest step, most attempts, 1 to replay the script, relative tolerance; where that is 0, the run goes on from the
    # one before, whose tolerances and step length are in `memory`.
    limits: int
    places: int  # (n_conditions, 2) in y, -1 for none
    weights: int  # (n_conditions, 3)
    table: int  # (n_outputs, n_rows) written
    books: int  # (3, n_states) least and greatest value and sum of |change|, written
    watch: int  # time reached, and a flag by which another thread asks to stop
    counts: int  # accepted steps, attempts, columns written, from 0 on; stop condition or -1; scratch
    memory: int  # scratch, `Kernel.memory_size` doubles
    # Lengths of the accepted steps, written as far as there is room, negative where they ended on an instant; or read
    # where they are replayed: runs that share a script differ smoothly in their numbers, as differences need.
    script: int


class LaneJob(NamedTuple):
    """What the integrator of lanes is handed: fields of `Job`, and the arrays of the lanes, each row a double for every
    lane."""

    width: int
    # On lanes; `_held` where the inputs hold still.
    jacobian: int
    jacobian_held: int
    derived: int  # what stands behind the memory in p
    step: int
    dense: int
    choose: int
    judge: int
    settle: int
    commit: int
    rows: int
    rows_held: int
    # For one lane.
    start: int
    energy: int
    outputs: int
    update: int
    n_states: int
    n_controlled: int
    n_inputs: int
    n_outputs: int
    n_numbers: int
    n_memory: int
    n_timers: int
    n_energies: int
    n_derived: int
    scales: int
    positive: int
    acting: int
    # Of all runs.
    n_segments: int
    n_courses: int
    n_rows: int
    n_conditions: int
    n_varied: int
    n_held: int
    numbers: int  # (n_numbers + n_memory) p of the problem
    varied: int  # (n_varied) places in p
    values: int  # (n_runs, n_varied)
    held: int  # (n_held, 2) inputs and places in p
    starts: int
    courses: int
    coefficients: int  # (n_courses, n_inputs, 7), or with held inputs one set for each lane
    jumps: int
    row_length: int  # where n_rows is written
    grid: int  # (n_rows), and `width` infinities behind them
    limits: int
    places: int
    weights: int
    record: int  # (n_runs, n_record) as `Ends` of `poppet.engine.batch` has it
    n_record: int
    counts: int  # (n_runs, 6)
    watch: int  # scratch, and a flag by which another thread asks to stop
    # Of a slice.
    first: int  # run that is taken next
    last: int  # and the one behind the last
    busy: int  # lanes that have a run
    base: int  # run at the begin of the table
    table: int  # (last - base, n_outputs, n_rows) written
    # Of the lanes, as a step of one run has them.
    control: int
    th: int
    x: int
    u: int
    us: int
    slopes: int
    p: int
    rates: int
    j: int
    drift: int
    scratch: int
    stages: int
    estimate: int
    new: int
    interpolant: int
    tolerances: int  # (2 n_controlled) relative, absolute
    sizes: int  # (n_controlled)
    low: int  # (n_controlled) what a state must exceed
    books: int
    rows_u: int  # inputs at rows
    flags: int
    own: int  # (width, n_numbers + n_memory) p of each lane, one behind the other
    one: int  # scratch for one lane at a time
