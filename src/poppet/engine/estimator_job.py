"""Arguments of the estimator: one row of addresses and lengths, as for the integrator (`poppet.engine.job`)."""

from __future__ import annotations

from typing import NamedTuple

PREDICT, CORRECT = 1, 2
"""Actions of the estimator. The sum of both is a complete update."""


class EstimatorJob(NamedTuple):
    """Arguments of the estimator, as integers of 64 bits.

    They are addresses of model functions and arrays, and array lengths. The lengths are n states, m free numbers, N = n
    + m estimates, k touched parameters, j touched inputs, c channels, o onsets and f faults. The faults are the first
    free numbers. Arrays of doubles have rows in sequence.
    """

    action: int  # `PREDICT`, `CORRECT` or their sum
    # Functions of the model, compiled for the touched elements and the channels. Matrices have columns in sequence.
    linear: int  # t x u p -> df/dx, df/d(touched p, touched u)
    observe: int  # t x u p -> y, dy/dx, dy/d(touched p, touched u)
    run: int  # address of a `Job` without segments, rows and stop conditions; its fields are those of the model
    n_free: int
    n_places: int
    n_touched_inputs: int
    n_channels: int
    n_onsets: int
    n_faults: int
    # Estimate, in and out.
    clock: int  # (2) time of the estimate and interval of the prediction [s]
    mean: int  # (N) states, then free numbers
    covariance: int  # (N, N)
    # Inputs and free numbers.
    u: int  # (2, n_inputs) at the start and at the end of the interval; touched inputs are written
    places: int  # (k) indices of integers in p
    touched_inputs: int  # (j) indices of integers in u
    base: int  # (k + j) touched elements for the reference values of the free numbers
    directions: int  # (k + j, m) derivative of the touched elements by the free numbers
    reference: int  # (m)
    low: int  # (m) limits of the free numbers
    high: int  # (m)
    # Readings; `effects` is the direct effect of the free numbers on them.
    effects: int  # (c, m)
    readings: int  # (c) NaN for a missing reading
    noise: int  # (c) variances
    gates: int  # (c) limits of the squared normalised innovations
    # Model of the free numbers.
    walk: int  # (N) variance per second
    cap: int  # (N) largest variance
    # Results.
    expected: int  # (c) readings that the prediction expects
    innovations: int  # (c) NaN for a missing reading
    deviations: int  # (c) standard deviations of the innovations
    used: int  # (c) 1 for a used reading, 0 for a missing one, -1 for a rejected one
    rejected: int  # (c) number of successive rejected readings, with the sign of their innovations
    outside: int  # (c) innovation of the last reading outside the gate
    scores: int  # (1) joint squared normalised innovation of the used readings (NIS)
    transition: int  # (n, N) derivative of the states at the end by states at the start and free numbers
    # Bank of onsets: evidence for steps of the faults at earlier times.
    signatures: int  # (N, o f) difference of truth and estimate that a unit step of each fault has caused
    numerators: int  # (o, f) sums of h v / S over the readings; h is the effect of the step on the innovation v
    gram: int  # (o, f f) sums of h h' / S
    memory: int  # scratch and memory between calls, `memory_size` doubles; zeros before the first call


def memory_size(n: int, m: int, touched: int, channels: int, inputs: int, memory: int, steps: int) -> int:
    """Return the length of the memory of an estimator.

    The arguments are the numbers of states, free numbers, touched elements, channels, inputs (at least 1), discrete
    states, and steps of faults (onsets times faults).
    """
    total = n + m
    of_step = 3 * n * (n + m) + n * touched + 3 * n * (2 * n + total)
    of_reading = channels * (4 + n + touched + 2 * total)
    of_onsets = (n + 1) * steps
    return of_step + of_reading + of_onsets + n * total + total * total + 5 * total + 8 * inputs + memory
