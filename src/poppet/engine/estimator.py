"""Estimator of states and free numbers of a model: an extended Kalman filter with exact transition matrices.

The estimates are z = (x, theta): states x and free numbers theta, which act linearly on parameters and inputs of the
model. A prediction integrates the states with the step control of the integrator. The variational equation of each
accepted step gives the transition matrix, without finite differences. A correction processes the readings one after
another.

This file is compiled like `integrator.py`. It allocates nothing, and its results have identical bits in C.
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np
from numba import carray
from numba.np.unsafe.ndarray import to_fixed_tuple

from poppet.engine import stepping
from poppet.engine.estimator_job import CORRECT, PREDICT, EstimatorJob
from poppet.engine.integrator import N_FIELDS, _run_of, portable_text
from poppet.engine.job import Job
from poppet.engine.rosenbrock import SAFETY, SHRINK
from poppet.engine.stepping import (
    ACCEPTED,
    ATTEMPTS,
    DONE,
    NOT_FINITE,
    STALLED,
    TOO_MANY,
    Segment,
    Step,
    caller,
    compiled,
)

APART = ("_linearise", "_advance_part", "_solve", "_observe", "_use_reading", "_set_numbers", "act")
"""Functions that are not inlined."""
N_ESTIMATOR_FIELDS = len(EstimatorJob._fields)
SLOW, MOST_PARTS = 0.5, 3
"""Norm of Jacobian times step below which the transition of a step is computed in one part, and the parts otherwise.

The transition of a mode of any speed then has an error of at most 3e-4, for one part 0.02."""
MOVED, CURVED = 1.0, 0.1
"""Criteria for a second linearisation of the readings, in standard deviations of the noise.

The correction moves an expected reading by more than the first, and its linear forecast is wrong by more than the
second."""
ROUNDING = 1e-12
"""Relative increase of each variance per prediction.

It exceeds the rounding errors, which would otherwise make the covariance of a model without state noise indefinite. An
unobserved variance grows by 1e-6 in a million predictions."""
LASTING = 2.0
"""Number of successive rejected readings of a channel after which a further one on the same side is used.

It is no outlier but a change of the plant."""
LEAST_FRACTION = 0.1
"""Smallest factor on a positive state in one correction."""

call7 = caller(7)


class Estimator(NamedTuple):
    """Arrays of an `EstimatorJob`, without those of the integration."""

    linear: Any
    observe: Any
    clock: Any
    mean: Any
    covariance: Any
    u: Any
    places: Any
    touched_inputs: Any
    base: Any
    directions: Any
    reference: Any
    low: Any
    high: Any
    effects: Any
    readings: Any
    noise: Any
    gates: Any
    walk: Any
    cap: Any
    expected: Any
    innovations: Any
    deviations: Any
    used: Any
    rejected: Any
    outside: Any
    scores: Any
    transition: Any
    signatures: Any
    numerators: Any
    gram: Any
    scratch: Any


class Scratch(NamedTuple):
    """Memory of the estimator; the last two arrays are memory between calls.

    `by_state` and `by_free` contain the derivatives of the rates at start, middle and end of a step. `start_system` and
    `linear_system` are the two systems of the transition. `other` is a second covariance, `product` a part of it.
    `gains`, `variances` and `sequence` are gains, variances and innovations of the readings in sequence.
    """

    by_state: Any
    by_free: Any
    by_touched: Any
    start_system: Any
    linear_system: Any
    product: Any
    other: Any
    y: Any
    forecast: Any
    y_by_state: Any
    y_by_touched: Any
    slopes: Any
    gains: Any
    steps: Any
    effects: Any
    variances: Any
    sequence: Any
    moved: Any
    correction: Any
    shift: Any
    gain: Any
    image: Any
    course: Any
    kept: Any
    before: Any


@compiled
def _set_numbers(est, run, mean):
    """Write parameters and inputs for the free numbers of an estimate `mean`."""
    n, n_places = run.x.size, est.places.size
    for i in range(est.base.size):
        value = est.base[i]
        for j in range(est.reference.size):
            value += est.directions[i, j] * (mean[n + j] - est.reference[j])
        if i < n_places:
            run.memory.p[est.places[i]] = value
        else:
            k = est.touched_inputs[i - n_places]
            est.u[0, k] = est.u[1, k] = value


@compiled
def _linearise(est, run, segment, t, x, node):
    """Compute the derivatives of the rates by states and free numbers at the state x and the time t of a segment.

    They are stored as those of a `node` of the step: 0 for the start, 1 for the middle, 2 for the end.
    """
    w, s, n = run.work, est.scratch, run.x.size
    w.tt[0] = t
    stepping.inputs_at(t, segment, w.u)
    stepping.call6(est.linear, w.tt, x, w.u, run.memory.p, s.by_state[node], s.by_touched)
    for j in range(est.reference.size):
        for r in range(n):
            s.by_free[node, j * n + r] = 0.0
        for i in range(est.base.size):
            direction = est.directions[i, j]
            if direction != 0.0:
                for r in range(n):
                    s.by_free[node, j * n + r] += s.by_touched[i * n + r] * direction


@compiled
def _interpolated(derivatives, k, position):
    """Return the element k of derivatives at start, middle and end of a step, at a position from 0 to 1.

    The result is the value of the parabola.
    """
    if position == 0.0 or position == 1.0:
        return derivatives[0, k] if position == 0.0 else derivatives[2, k]
    a, b, c = (
        (1.0 - 2.0 * position) * (1.0 - position),
        4.0 * position * (1.0 - position),
        position * (2.0 * position - 1.0),
    )
    return a * derivatives[0, k] + b * derivatives[1, k] + c * derivatives[2, k]


@compiled
def _parts(est, run, h):
    """Return the number of equal parts of a step of length h for the transition.

    The errors of the states determine the step, not those of their derivatives: a fast mode at rest permits a long
    step. The number therefore depends on the norm of the Jacobian in the middle, with the sizes of the states.
    """
    n, sizes, largest = run.x.size, run.control.tolerances, 0.0
    for r in range(n):
        total = 0.0
        for c in range(n):
            total += abs(est.scratch.by_state[1, c * n + r]) * sizes[2, c]
        largest = max(largest, h * total / sizes[2, r])
    return 1 if largest < SLOW else MOST_PARTS


@compiled
def _solve(system, n):
    """Solve a linear system by elimination with row pivoting, for its last n unknowns.

    The right-hand sides are the columns after the square matrix, and the solutions replace them.
    """
    size, width = system.shape[0], system.shape[1]
    for k in range(size):
        pivot, largest = k, abs(system[k, k])
        for r in range(k + 1, size):
            if abs(system[r, k]) > largest:
                pivot, largest = r, abs(system[r, k])
        if pivot != k:
            for c in range(k, width):
                value = system[k, c]
                system[k, c] = system[pivot, c]
                system[pivot, c] = value
        inverse = 1.0 / system[k, k]
        for r in range(k + 1, size):
            factor = system[r, k] * inverse
            # Many elements are zero.
            if factor != 0.0:
                for c in range(k + 1, width):
                    system[r, c] -= factor * system[k, c]
    for i in range(n):
        r = size - 1 - i
        for q in range(r + 1, size):
            factor = system[r, q]
            if factor != 0.0:
                for c in range(size, width):
                    system[r, c] -= factor * system[q, c]
        inverse = 1.0 / system[r, r]
        for c in range(size, width):
            system[r, c] *= inverse


@compiled
def _solve_start(est, run, h, position):
    """Compute the matrix at the start of a part of a step, for given matrices at its middle and end.

    ``(3 - h A_0) Psi_0 = 6 Psi + [0, h B_0] - 4 Psi_1 + Psi_2``. The right-hand sides of the solution are the identity,
    the factor on ``Psi_2 - 4 Psi_1``, and the constant rest. h is the length of the part, and `position` is its start
    in the step.
    """
    s, system, n, sizes = est.scratch, est.scratch.start_system, run.x.size, run.control.tolerances
    for r in range(n):
        scale = 1.0 / sizes[2, r]
        for c in range(n):
            system[r, c] = -scale * h * _interpolated(s.by_state, c * n + r, position)
            system[r, n + c] = 0.0
        system[r, r] += 3.0 * scale
        system[r, n + r] = scale
        for c in range(est.mean.size):
            system[r, 2 * n + c] = 6.0 * scale * est.transition[r, c]
        for c in range(est.reference.size):
            system[r, 3 * n + c] += scale * h * _interpolated(s.by_free, c * n + r, position)
    _solve(system, n)


@compiled
def _advance_part(est, run, h, first, fraction):
    """Multiply the transition by that of a part of a step of length h.

    The part begins at the position `first` of the step, from 0 to 1, and its length is `fraction` of the step. The
    unknowns are the matrices Psi at the three nodes of Lobatto IIIC: ``Psi_i = Psi + h sum_j a_ij (A_j Psi_j + [0,
    B_j])``, where Psi is the present transition and the last Psi_j the next one. Multiplied by the inverse of the
    coefficients a, each equation contains the derivatives at one node only::

        (3 - h A_0) Psi_0 +     4 Psi_1 -               Psi_2 = 6 Psi + [0, h B_0]
                  - Psi_0 - h A_1 Psi_1 +               Psi_2 =         [0, h B_1]
                    Psi_0 -     4 Psi_1 + (3 - h A_2) * Psi_2 =         [0, h B_2]

    The solution of the first equation is inserted into the others. Each equation is divided by the size of its state.
    """
    s, n, sizes, length = est.scratch, run.x.size, run.control.tolerances, h * fraction
    start, system, middle, end = s.start_system, s.linear_system, first + 0.5 * fraction, first + fraction
    _solve_start(est, run, length, first)
    for r in range(n):
        scale = 1.0 / sizes[2, r]
        for c in range(n):
            factor = start[r, n + c]
            system[r, c] = scale * (4.0 * factor - length * _interpolated(s.by_state, c * n + r, middle))
            system[r, n + c] = -scale * factor
            system[n + r, c] = -4.0 * scale * factor
            system[n + r, n + c] = scale * (factor - length * _interpolated(s.by_state, c * n + r, end))
        system[r, n + r] += scale
        system[n + r, r] -= 4.0 * scale
        system[n + r, n + r] += 3.0 * scale
        for c in range(est.mean.size):
            rest = scale * start[r, 2 * n + c]
            system[r, 2 * n + c], system[n + r, 2 * n + c] = rest, -rest
        for c in range(est.reference.size):
            system[r, 3 * n + c] += scale * length * _interpolated(s.by_free, c * n + r, middle)
            system[n + r, 3 * n + c] += scale * length * _interpolated(s.by_free, c * n + r, end)
    _solve(system, n)
    for r in range(n):
        for c in range(est.mean.size):
            est.transition[r, c] = system[n + r, 2 * n + c]


@compiled
def _advance_transition(est, run, h):
    """Multiply the transition by that of an accepted step of length h."""
    parts = _parts(est, run, h)
    for k in range(parts):
        _advance_part(est, run, h, 1.0 * k / parts, 1.0 / parts)


@compiled
def _integrate(est, run, segment, h):
    """Integrate states and transition over a segment, and return status and next step length.

    If h is positive, it is the length of the first step. Otherwise the rates determine this length; if h is negative,
    -h is the maximum. Steps end at sample instants.
    """
    w, s, counts, n = run.work, est.scratch, run.counts, run.x.size
    t, stop, has_timers, moves = segment.start, segment.stop, run.memory.fired.size > 0, stepping.varies(segment)
    error_before, step_before, rejected, fresh, linear = 1e-2, 0.0, False, True, False
    stepping.stage_inputs(run, segment, t, 0.0)
    if has_timers:
        stepping.act(run, segment, t, run.x)
    while t < stop:
        if fresh:
            h = stepping.begin(run, segment, t, h)
            fresh = False
        desired, goal = stepping.reach(run, segment, t, h, t, True)
        h = stepping.length(desired, goal - t)
        if moves:
            stepping.stage_inputs(run, segment, t, h)
        end = goal if h >= (goal - t) * (1.0 - 1e-12) else t + h
        w.tt[0], w.tt[1] = t, h
        stepping.call10(
            run.functions.step, w.tt, run.x, w.us, run.memory.p, w.rates, w.jacobian, w.drift, w.scratch, w.stages,
            w.new,
        )  # fmt: skip
        error = stepping.error(run)
        counts[ATTEMPTS] += 1
        if error <= 1.0:
            counts[ACCEPTED] += 1
            stepping.call2(run.functions.dense, w.stages, w.dense)
            step = Step(t, h, end, w.new)
            if not linear:
                _linearise(est, run, segment, t, run.x, 0)
            stepping.interpolate(run, step, 0.5, w.inside)
            _linearise(est, run, segment, t + 0.5 * h, w.inside, 1)
            _linearise(est, run, segment, end, w.new, 2)
            _advance_transition(est, run, h)
            for r in range(n):
                run.x[r] = w.new[r]
            for k in range(n * n):
                s.by_state[0, k] = s.by_state[2, k]
            for k in range(n * est.reference.size):
                s.by_free[0, k] = s.by_free[2, k]
            t, fresh, linear, error = end, True, True, max(error, 1e-10)
            factor = stepping.growth(error, h, error_before, step_before)
            step_before, error_before = h, max(1e-2, error)
            # A step that the end of the segment shortened does not reduce the desired length.
            h = max(desired, h * factor) if h < desired else h * (min(1.0, factor) if rejected else factor)
            rejected = False
            # Timers that are due at the end act in the next interval, with its inputs.
            if has_timers and t < stop - stepping.rounding(stop) and stepping.act(run, segment, t, run.x):
                # The rates have jumped.
                h, step_before, linear = -h, 0.0, False
        else:
            h *= max(SHRINK, min(0.8, SAFETY / stepping.fourth_root(error))) if np.isfinite(error) else SHRINK
            rejected = True
            if t + h <= t or h < 1e-300:
                return STALLED, 0.0
        if counts[ATTEMPTS] >= run.control.most:
            return TOO_MANY, 0.0
    return DONE, abs(h)


@compiled
def _act_in(run, segment):
    """Run the timers of a model without states up to the end of a segment."""
    t, limit = segment.start, segment.stop - stepping.rounding(segment.stop)
    while t < limit:
        stepping.act(run, segment, t, run.x)
        t = stepping.next_instant(run.memory)


@compiled
def _set_course(est, t, dt):
    """Write the inputs, linear over the interval from t to t + dt, as coefficients of a segment.

    The result is True if an input has jumped since the last interval.
    """
    s, jumps = est.scratch, False
    for j in range(est.touched_inputs.size):
        # A corrected free number is no jump of a signal.
        s.before[est.touched_inputs[j]] = est.u[0, est.touched_inputs[j]]
    for k in range(s.before.size):
        jumps = jumps or est.u[0, k] != s.before[k]
        s.course[k, 0], s.course[k, 6] = est.u[0, k], t
        s.course[k, 1] = (est.u[1, k] - est.u[0, k]) / dt
        s.before[k] = est.u[1, k]
    return jumps


@compiled
def _spread(est, n, dt):
    """Compute the covariance at the end of an interval, ``F P F' + walk dt``, and return True if it is finite.

    A variance above its cap is reduced to the cap, with all correlations unchanged. So the variance of a free number
    about which the readings contain no information returns to its cap, and a combination that they determine remains
    determined. The result is stored in `other`.
    """
    s, total, finite = est.scratch, est.mean.size, True
    for r in range(n):
        for c in range(total):
            s.product[r, c] = 0.0
        for q in range(total):
            factor = est.transition[r, q]
            if factor != 0.0:
                for c in range(total):
                    s.product[r, c] += factor * est.covariance[q, c]
    for r in range(n):
        for c in range(r, n):
            value = 0.0
            for q in range(total):
                value += s.product[r, q] * est.transition[c, q]
            s.other[r, c] = s.other[c, r] = value
        for c in range(n, total):
            s.other[r, c] = s.other[c, r] = s.product[r, c]
    for r in range(n, total):
        for c in range(n, total):
            s.other[r, c] = est.covariance[r, c]
    for r in range(total):
        variance = s.other[r, r] * (1.0 + ROUNDING) + est.walk[r] * dt
        s.other[r, r] = variance
        if variance > est.cap[r]:
            factor = np.sqrt(est.cap[r] / variance)
            for c in range(total):
                s.other[r, c] *= factor
                s.other[c, r] *= factor
    for r in range(total):
        for c in range(total):
            finite = finite and np.isfinite(s.other[r, c])
    return finite


@compiled
def _move_signatures(est, n):
    """Advance the signatures of the steps of faults by the interval, with the transition."""
    steps, total = est.scratch.steps, est.mean.size
    for r in range(n):
        for k in range(steps.shape[1]):
            steps[r, k] = 0.0
        for q in range(total):
            factor = est.transition[r, q]
            if factor != 0.0:
                for k in range(steps.shape[1]):
                    steps[r, k] += factor * est.signatures[q, k]
    for r in range(n):
        for k in range(steps.shape[1]):
            est.signatures[r, k] = steps[r, k]


@compiled
def _predict(est, run, limits, scales):
    """Advance the estimate by the interval, and return the status.

    A failed prediction does not change time, mean, covariance and discrete states.
    """
    s, n, total = est.scratch, run.x.size, est.mean.size
    t, dt, z = est.clock[0], est.clock[1], run.memory.z
    if not (dt >= 0.0 and np.isfinite(t + dt)):
        return NOT_FINITE
    stop, status, h = t + dt, DONE, run.work.tt[1]
    for k in range(n):
        run.x[k] = est.mean[k]
        for c in range(total):
            est.transition[k, c] = 1.0 if c == k else 0.0
    for k in range(z.size):
        s.kept[k] = z[k]
    _set_numbers(est, run, est.mean)
    if limits[3] > 0.0:
        stepping.set_tolerances(run.control, scales, limits[3], run.x)
        limits[3], h = 0.0, 0.0
    run.counts[ACCEPTED] = run.counts[ATTEMPTS] = 0
    if stop > t:
        h = -h if _set_course(est, t, stop - t) else h
        segment = Segment(t, stop, s.course)
        if n > 0:
            status, h = _integrate(est, run, segment, h)
        else:
            _act_in(run, segment)
    run.work.tt[1] = h
    if status == DONE and not _spread(est, n, dt):
        status = NOT_FINITE
    if status == DONE:
        for k in range(n):
            est.mean[k] = run.x[k]
        for r in range(total):
            for c in range(total):
                est.covariance[r, c] = s.other[r, c]
        _move_signatures(est, n)
        est.clock[0] = stop
    else:
        run.work.tt[1] = 0.0
        for k in range(z.size):
            z[k] = s.kept[k]
    return status


@compiled
def _observe(est, run, mean):
    """Compute the readings y for an estimate `mean`, and their derivatives by states and free numbers.

    The result is True if they are finite.
    """
    w, s, n, n_c, finite = run.work, est.scratch, run.x.size, est.readings.size, True
    _set_numbers(est, run, mean)
    w.tt[0] = est.clock[0]
    call7(est.observe, w.tt, mean, est.u[1], run.memory.p, s.y, s.y_by_state, s.y_by_touched)
    for c in range(n_c):
        for k in range(n):
            s.slopes[c, k] = s.y_by_state[k * n_c + c]
        for j in range(est.reference.size):
            slope = est.effects[c, j]
            s.y[c] += slope * (mean[n + j] - est.reference[j])
            for i in range(est.base.size):
                slope += s.y_by_touched[i * n_c + c] * est.directions[i, j]
            s.slopes[c, n + j] = slope
        finite = finite and np.isfinite(s.y[c])
        for k in range(mean.size):
            finite = finite and np.isfinite(s.slopes[c, k])
    return finite


@compiled
def _variance(est, slopes, noise):
    """Return the variance of an innovation, and write the product of covariance and `slopes` into `image`."""
    image, variance = est.scratch.image, noise
    for r in range(image.size):
        value = 0.0
        for c in range(image.size):
            value += est.covariance[r, c] * slopes[c]
        image[r] = value
        variance += slopes[r] * value
    return variance


@compiled
def _use_reading(est, c):
    """Correct estimate and covariance with the reading of the channel c, and return its squared normalised innovation.

    The covariance has the form of Bucy and Joseph, ``(I - k h) P (I - k h)' + k r k'``, which remains positive with
    rounding errors.
    """
    s, total, slopes, p = est.scratch, est.mean.size, est.scratch.slopes[c], est.covariance
    variance = _variance(est, slopes, est.noise[c])
    innovation = est.readings[c] - s.y[c]
    for k in range(total):
        innovation -= slopes[k] * (s.correction[k] - s.shift[k])
        s.gain[k] = s.gains[c, k] = s.image[k] / variance
    s.variances[c], s.sequence[c] = variance, innovation
    for r in range(total):
        gain = s.gain[r]
        s.correction[r] += gain * innovation
        for k in range(total):
            p[r, k] -= gain * s.image[k]
    # The second factor.
    for r in range(total):
        value = 0.0
        for k in range(total):
            value += p[r, k] * slopes[k]
        s.image[r] = value
    for r in range(total):
        for k in range(r, total):
            p[r, k] += s.gain[k] * (est.noise[c] * s.gain[r] - s.image[r])
            p[k, r] = p[r, k]
    return innovation * innovation / variance


@compiled
def _use_all(est):
    """Correct the estimate with all accepted readings, and return the sum of their squared normalised innovations."""
    nis = 0.0
    for k in range(est.mean.size):
        est.scratch.correction[k] = 0.0
    for c in range(est.readings.size):
        if est.used[c] > 0.0:
            nis += _use_reading(est, c)
    return nis


@compiled
def _weigh_onsets(est):
    """Add the used readings to the evidence for steps of the faults, and correct the signatures.

    The likelihood ratio of steps at unknown times (Willsky & Jones 1976, IEEE Trans. Autom. Control 21, 108-112) needs
    the effect h of each step on the innovations of the filter, which assumes no step.
    """
    s, total, n_faults, effects = est.scratch, est.mean.size, est.numerators.shape[1], est.scratch.effects
    for c in range(est.readings.size):
        if est.used[c] > 0.0:
            for k in range(effects.size):
                effects[k] = 0.0
            for r in range(total):
                slope = s.slopes[c, r]
                if slope != 0.0:
                    for k in range(effects.size):
                        effects[k] += slope * est.signatures[r, k]
            for r in range(total):
                gain = s.gains[c, r]
                for k in range(effects.size):
                    est.signatures[r, k] -= gain * effects[k]
            weight, inverse = s.sequence[c] / s.variances[c], 1.0 / s.variances[c]
            for o in range(est.numerators.shape[0]):
                for i in range(n_faults):
                    effect = effects[o * n_faults + i]
                    est.numerators[o, i] += effect * weight
                    for j in range(n_faults):
                        est.gram[o, i * n_faults + j] += effect * effects[o * n_faults + j] * inverse


@compiled
def _select(est):
    """Compute innovations of all channels with their standard deviations, and decide which readings are used.

    The decision on a reading does not depend on the other readings. A reading outside its gate is rejected, unless it
    follows several rejected readings on the same side, and agrees with the last of them.
    """
    for c in range(est.readings.size):
        variance = _variance(est, est.scratch.slopes[c], est.noise[c])
        innovation = est.readings[c] - est.scratch.y[c]
        est.expected[c], est.innovations[c], est.deviations[c] = est.scratch.y[c], innovation, np.sqrt(variance)
        est.used[c] = 1.0
        if not (np.isfinite(innovation) and np.isfinite(variance)):
            est.used[c] = 0.0
        elif innovation * innovation > est.gates[c] * variance:
            side = 1.0 if innovation > 0.0 else -1.0
            if side * est.rejected[c] < 0.0:
                est.rejected[c] = 0.0
            # A single outlier among lasting changes has another size.
            jump = innovation - est.outside[c]
            if side * est.rejected[c] < LASTING:
                est.rejected[c] += side
                est.used[c] = -1.0
            elif jump * jump > 2.0 * est.gates[c] * est.noise[c]:
                est.used[c] = -1.0
            est.outside[c] = innovation
        else:
            est.rejected[c] = 0.0


@compiled
def _low(est, run, k):
    """Return the lower limit of the estimate k."""
    n = run.x.size
    if k >= n:
        return est.low[k - n]
    return LEAST_FRACTION * est.mean[k] if run.control.positive[k] else -np.inf


@compiled
def _move_inside(est, run, mean):
    """Move a corrected estimate into its limits, along the covariance.

    The result is the most probable estimate with the violated limit, as for a reading without noise. Other estimates
    therefore move with their correlation. The covariance is unchanged. The method repeats the projection, because the
    limits of others can be violated by it.
    """
    n, p = run.x.size, est.covariance
    for sweep in range(3):
        for k in range(mean.size):
            low = _low(est, run, k)
            high = est.high[k - n] if k >= n else np.inf
            limit = min(max(mean[k], low), high)
            if limit != mean[k]:
                factor = (limit - mean[k]) / p[k, k] if p[k, k] > 0.0 and sweep < 2 else 0.0
                for j in range(mean.size):
                    mean[j] += factor * p[j, k]
                mean[k] = limit


@compiled
def _move(est, run):
    """Write the corrected estimate into `moved`, and return True if it is finite."""
    s, finite = est.scratch, True
    for k in range(est.mean.size):
        s.moved[k] = est.mean[k] + s.correction[k]
    _move_inside(est, run, s.moved)
    for k in range(est.mean.size):
        finite = finite and np.isfinite(s.moved[k])
        for j in range(est.mean.size):
            finite = finite and np.isfinite(est.covariance[k, j])
    return finite


@compiled
def _is_curved(est, run):
    """Return True if the readings are nonlinear over the correction.

    If True, readings and derivatives are those of the corrected estimate, and `shift` is its distance.
    """
    s, is_far, is_curved = est.scratch, False, False
    for c in range(est.readings.size):
        s.forecast[c] = 0.0
        for k in range(est.mean.size):
            s.forecast[c] += s.slopes[c, k] * (s.moved[k] - est.mean[k])
        is_far = is_far or (est.used[c] > 0.0 and s.forecast[c] * s.forecast[c] > MOVED * MOVED * est.noise[c])
    if not is_far or not _observe(est, run, s.moved):
        return False
    for c in range(est.readings.size):
        difference = s.y[c] - (est.expected[c] + s.forecast[c])
        is_curved = is_curved or (est.used[c] > 0.0 and difference * difference > CURVED * CURVED * est.noise[c])
    for k in range(est.mean.size):
        s.shift[k] = s.moved[k] - est.mean[k]
    return is_curved


@compiled
def _correct(est, run):
    """Correct the estimate with the readings, and return the status.

    The readings are processed in sequence, because their noise is independent (Bierman, Factorization Methods for
    Discrete Sequential Estimation, 1977). The sum of the squared normalised innovations of the sequence is the joint
    one, ``v' S^-1 v``: the sequence is a factorisation of S. If the readings are nonlinear over the correction, it is
    repeated once with the derivatives at the corrected estimate (iterated Kalman filter). A failed correction does not
    change mean and covariance.
    """
    s, total = est.scratch, est.mean.size
    if not _observe(est, run, est.mean):
        return NOT_FINITE
    _select(est)
    for r in range(total):
        s.shift[r] = 0.0
        for k in range(total):
            s.other[r, k] = est.covariance[r, k]
    est.scores[0] = _use_all(est)
    finite = _move(est, run)
    if finite and _is_curved(est, run):
        for r in range(total):
            for k in range(total):
                est.covariance[r, k] = s.other[r, k]
        _use_all(est)
        finite = _move(est, run)
    if finite:
        for k in range(total):
            est.mean[k] = s.moved[k]
        _weigh_onsets(est)
        return DONE
    for r in range(total):
        for k in range(total):
            est.covariance[r, k] = s.other[r, k]
    return NOT_FINITE


@compiled
def _scratch_of(estimator_job, job):
    """Return the scratch memory of an `EstimatorJob` as arrays."""
    n, m, n_c, n_u = job.n_states, estimator_job.n_free, estimator_job.n_channels, job.n_inputs
    q, total = estimator_job.n_places + estimator_job.n_touched_inputs, n + m
    steps = estimator_job.n_onsets * estimator_job.n_faults
    # Addresses of the arrays.
    of_free = estimator_job.memory + 8 * 3 * n * n
    of_touched = of_free + 8 * 3 * n * m
    of_system = of_touched + 8 * n * q
    of_product = of_system + 8 * 3 * n * (2 * n + total)
    of_other = of_product + 8 * n * total
    of_slopes = of_other + 8 * total * total
    of_gains = of_slopes + 8 * n_c * total
    of_steps = of_gains + 8 * n_c * total
    of_course = of_steps + 8 * n * steps
    of_rest = of_course + 8 * 7 * n_u
    of_readings = n_c * (4 + n + q) + steps
    rest = carray(stepping.doubles_at(of_rest), (of_readings + 5 * total + job.n_memory + n_u,))
    vectors = rest[of_readings:]
    return Scratch(
        carray(stepping.doubles_at(estimator_job.memory), (3, n * n)),
        carray(stepping.doubles_at(of_free), (3, n * m)),
        carray(stepping.doubles_at(of_touched), (n * q,)),
        carray(stepping.doubles_at(of_system), (n, 2 * n + total)),
        carray(stepping.doubles_at(of_system + 8 * n * (2 * n + total)), (2 * n, 2 * n + total)),
        carray(stepping.doubles_at(of_product), (n, total)),
        carray(stepping.doubles_at(of_other), (total, total)),
        rest[:n_c], rest[n_c : 2 * n_c], rest[4 * n_c : (4 + n) * n_c], rest[(4 + n) * n_c : (4 + n + q) * n_c],
        carray(stepping.doubles_at(of_slopes), (n_c, total)),
        carray(stepping.doubles_at(of_gains), (n_c, total)),
        carray(stepping.doubles_at(of_steps), (n, steps)),
        rest[(4 + n + q) * n_c : of_readings], rest[2 * n_c : 3 * n_c], rest[3 * n_c : 4 * n_c],
        vectors[:total], vectors[total : 2 * total], vectors[2 * total : 3 * total], vectors[3 * total : 4 * total],
        vectors[4 * total : 5 * total],
        carray(stepping.doubles_at(of_course), (n_u, 7)),
        vectors[5 * total : 5 * total + job.n_memory], vectors[5 * total + job.n_memory :],
    )  # fmt: skip


@compiled
def _estimator_of(estimator_job, job):
    """Return the arrays of an `EstimatorJob`."""
    n, m, n_c, n_places = job.n_states, estimator_job.n_free, estimator_job.n_channels, estimator_job.n_places
    q, total = n_places + estimator_job.n_touched_inputs, n + m
    n_onsets, n_faults = estimator_job.n_onsets, estimator_job.n_faults
    return Estimator(
        estimator_job.linear, estimator_job.observe,
        carray(stepping.doubles_at(estimator_job.clock), (2,)),
        carray(stepping.doubles_at(estimator_job.mean), (total,)),
        carray(stepping.doubles_at(estimator_job.covariance), (total, total)),
        carray(stepping.doubles_at(estimator_job.u), (2, job.n_inputs)),
        carray(stepping.integers_at(estimator_job.places), (n_places,)),
        carray(stepping.integers_at(estimator_job.touched_inputs), (estimator_job.n_touched_inputs,)),
        carray(stepping.doubles_at(estimator_job.base), (q,)),
        carray(stepping.doubles_at(estimator_job.directions), (q, m)),
        carray(stepping.doubles_at(estimator_job.reference), (m,)),
        carray(stepping.doubles_at(estimator_job.low), (m,)),
        carray(stepping.doubles_at(estimator_job.high), (m,)),
        carray(stepping.doubles_at(estimator_job.effects), (n_c, m)),
        carray(stepping.doubles_at(estimator_job.readings), (n_c,)),
        carray(stepping.doubles_at(estimator_job.noise), (n_c,)),
        carray(stepping.doubles_at(estimator_job.gates), (n_c,)),
        carray(stepping.doubles_at(estimator_job.walk), (total,)),
        carray(stepping.doubles_at(estimator_job.cap), (total,)),
        carray(stepping.doubles_at(estimator_job.expected), (n_c,)),
        carray(stepping.doubles_at(estimator_job.innovations), (n_c,)),
        carray(stepping.doubles_at(estimator_job.deviations), (n_c,)),
        carray(stepping.doubles_at(estimator_job.used), (n_c,)),
        carray(stepping.doubles_at(estimator_job.rejected), (n_c,)),
        carray(stepping.doubles_at(estimator_job.outside), (n_c,)),
        carray(stepping.doubles_at(estimator_job.scores), (1,)),
        carray(stepping.doubles_at(estimator_job.transition), (n, total)),
        carray(stepping.doubles_at(estimator_job.signatures), (total, n_onsets * n_faults)),
        carray(stepping.doubles_at(estimator_job.numerators), (n_onsets, n_faults)),
        carray(stepping.doubles_at(estimator_job.gram), (n_onsets, n_faults * n_faults)),
        _scratch_of(estimator_job, job),
    )  # fmt: skip


def estimate(fields):
    """Predict or correct an estimate, or both, and return the status.

    `fields` is the address of an `EstimatorJob`.
    """
    estimator_job = EstimatorJob(*to_fixed_tuple(carray(fields, (N_ESTIMATOR_FIELDS,)), N_ESTIMATOR_FIELDS))
    job = Job(*to_fixed_tuple(carray(stepping.integers_at(estimator_job.run), (N_FIELDS,)), N_FIELDS))
    run = _run_of(job)
    est = _estimator_of(estimator_job, job)
    limits = carray(stepping.doubles_at(job.limits), (4,))
    scales = carray(stepping.doubles_at(job.scales), (3, job.n_controlled))
    status = DONE
    if estimator_job.action & PREDICT:
        status = _predict(est, run, limits, scales)
    if status == DONE and estimator_job.action & CORRECT:
        status = _correct(est, run)
    return status


def estimator_text() -> str:
    """Return LLVM IR of the estimator, the function `i64 estimate(ptr)`."""
    text = portable_text(estimate, ())
    names = "|".join(f"{len(name)}{name}" for name in APART)
    return re.sub(rf"^(define [^\n]*(?:{names})[^\n]*) {{$", r"\1 noinline {", text, flags=re.M)
