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
    limits: int  # longest step, most attempts, 1 to replay the script, relative tolerance
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
