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


class Job(NamedTuple):
    """Addresses of the model's functions, lengths, addresses of arrays; every field is a whole number of 64 bits.

    Parameters
    ----------
    jacobian, step, dense, outputs, update : int
        Functions, 0 where the model has none.
    n_states, n_controlled, n_inputs, n_outputs, n_numbers, n_memory, n_timers : int
        Of the model; quadratures count as states, and without inputs there is room for one.
    n_jacobian, n_scratch : int
        Nonzeros of the Jacobian, and what `step` needs besides.
    n_segments, n_rows, n_conditions, n_script : int
        Of the run.
    scales : int
        Factor on the relative tolerance, floor and nominal size of each controlled state (3, n_controlled).
    positive, acting : int
        Which controlled states must stay positive; on which elements of the memory the rates depend.
    x : int
        State (n), in and out.
    p : int
        Numbers, then the memory, in and out.
    starts, coefficients, jumps : int
        Segments of the inputs: (n_segments,), (n_segments, n_inputs, 6), (n_segments,).
    grid : int
        Output times, the last one is the end.
    limits : int
        Longest step, most attempts, 1 to replay the script, relative tolerance.
    places, weights : int
        Of the stop conditions (n_conditions, 2) and (n_conditions, 3).
    table : int
        Outputs (n_outputs, n_rows), written.
    books : int
        Least and greatest value and sum of |change| of each state (3 n), written.
    watch : int
        Time reached, and a flag by which another thread asks to stop.
    counts : int
        Accepted steps, attempts, columns written, stop condition or -1, scratch (5); the first three begin at 0.
    memory : int
        Scratch of `scratch_size` doubles.
    script : int
        Lengths of the accepted steps, written as far as there is room, negative where they ended on an instant; or read
        where they are replayed: runs that share a script differ smoothly in their numbers, as finite differences need.
    """

    jacobian: int
    step: int
    dense: int
    outputs: int
    update: int
    n_states: int
    n_controlled: int
    n_inputs: int
    n_outputs: int
    n_numbers: int
    n_memory: int
    n_timers: int
    n_jacobian: int
    n_scratch: int
    scales: int
    positive: int
    acting: int
    n_segments: int
    n_rows: int
    n_conditions: int
    n_script: int
    x: int
    p: int
    starts: int
    coefficients: int
    jumps: int
    grid: int
    limits: int
    places: int
    weights: int
    table: int
    books: int
    watch: int
    counts: int
    memory: int
    script: int
