"""Arguments of compiled code: addresses of arrays and, for the integrator, one row of addresses and lengths."""

from __future__ import annotations

from ctypes import addressof, c_char
from typing import Any, NamedTuple


def address(array: Any) -> int:
    """Return the memory address of a contiguous array, or 0 for an empty array."""
    if not array.size:
        return 0
    try:
        # Three times faster than `array.ctypes.data`; it rejects arrays that are not contiguous.
        return addressof(c_char.from_buffer(array))
    except TypeError:  # not writable
        return int(array.ctypes.data)


ERROR, FACTOR, SHRUNK, ROOT, ROOT_BEFORE, STEP_BEFORE, TAKEN, REFUSED, *_TIMES = range(22)
"""Rows of the control of lanes: error of the completed step; factors on the step if it is accepted and if not; fourth
root of the error and of the previous error; previous length; 1 for an accepted step; 1 after a rejected step."""
LENGTH, WANTED, GOAL, END, STOP, NEXT, TRIES, TAKES, LOOK, MASKS, *_OF_ONE = _TIMES
"""Length of the next step; desired length; latest end and end of the step; end of the segment; time of the next row;
attempts; accepted steps; attempt of the next stall test. The last row contains two integers with one bit per lane:
lanes with rows in the step, and lanes whose segment or run has ended or needs the stall test."""
CALM, FIRST, WINDOW, BEFORE = _OF_ONE
"""Rows that only the integrator uses, as in `_over` of the integrator, and the time limit of the rows."""


class Job(NamedTuple):
    """Arguments of the integrator of single runs, as integers of 64 bits.

    They are addresses of model functions and arrays, and array lengths.
    """

    # Functions, 0 for a missing function.
    jacobian: int
    step: int
    dense: int
    outputs: int
    update: int
    # Of the model: states include quadratures; without inputs, `n_inputs` is 1.
    n_states: int
    n_controlled: int
    n_inputs: int
    n_outputs: int
    n_numbers: int
    n_memory: int
    n_timers: int
    n_jacobian: int  # nonzeros
    n_scratch: int  # scratch memory of `step`
    scales: int  # (3, n_controlled) factor on the relative tolerance, floor, nominal size
    positive: int  # (n_controlled) 1 for states that must remain positive
    acting: int  # (n_memory) 1 for discrete states on which the rates depend
    # Of the run.
    n_segments: int
    n_courses: int
    n_rows: int
    n_conditions: int
    n_script: int
    x: int  # (n_states) in and out
    p: int  # numbers, then the memory, in and out
    starts: int  # (n_segments)
    courses: int  # (n_segments) index of the coefficients
    coefficients: int  # (n_courses, n_inputs, 7)
    jumps: int  # (n_segments)
    grid: int  # (n_rows) output times, the last one is the end
    # Longest step, maximum number of attempts, 1 to replay the script, relative tolerance. If the tolerance is 0, the
    # run continues with the tolerances and the step length of the previous run in `memory`.
    limits: int
    places: int  # (n_conditions, 2) in y, -1 for none
    weights: int  # (n_conditions, 3)
    table: int  # (n_outputs, n_rows) written
    books: int  # (3, n_states) minimum, maximum and sum of |change|, written
    watch: int  # time reached, and a flag with which another thread requests the end
    counts: int  # accepted steps, attempts, written columns; stop condition or -1; scratch
    memory: int  # scratch, `Kernel.memory_size` doubles
    # Lengths of the accepted steps, negative for steps that ended at an instant. They are written up to the size of the
    # script, or read in a replay: results of runs with one script are smooth functions of the parameters.
    script: int


class LaneJob(NamedTuple):
    """Arguments of the integrator that computes several runs (lanes) simultaneously.

    They are the fields of `Job` and further array addresses and lengths. In arrays for lanes, a row contains one double
    for each lane.
    """

    width: int
    # For lanes; `_held` for constant inputs.
    jacobian: int
    jacobian_held: int
    derived: int  # elements after the discrete state in p
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
    varied: int  # (n_varied) indices in p
    values: int  # (n_runs, n_varied)
    held: int  # (n_held, 2) indices of inputs and in p
    starts: int
    courses: int
    coefficients: int  # (n_courses, n_inputs, 7), or one set per lane if `n_held` is positive
    jumps: int
    row_length: int  # address of n_rows
    grid: int  # (n_rows), then `width` infinities
    limits: int
    places: int
    weights: int
    record: int  # (n_runs, n_record), see `poppet.engine.members.RunEnds`
    n_record: int
    counts: int  # (n_runs, 6)
    watch: int  # scratch, and a flag with which another thread requests the end
    # Of a slice.
    first: int  # next run
    last: int  # run after the last
    busy: int  # number of lanes with a run
    base: int  # first run of the table
    table: int  # (last - base, n_outputs, n_rows) written
    # Of the lanes, as for a step of one run.
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
    low: int  # (n_controlled) lower limit of a state
    books: int
    rows_u: int  # inputs at rows
    flags: int
    own: int  # (width, n_numbers + n_memory) p of each lane
    one: int  # scratch memory for one lane
