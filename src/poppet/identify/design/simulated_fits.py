"""Fits to simulated recordings of the recommended tests: the intervals and verdicts that a fit would report."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.identify.design.design_file import DesignPlan, TestCandidate
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_plan import FitPlan, offset_parameters, recording_parameters
from poppet.identify.fit.identify_fit import describe_optimum
from poppet.identify.fit.optima import find_optima
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.result import VERDICTS, Estimate, Verdict
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, Measurement

USUAL_FITS = 5
"""Default number of simulated fits."""
MOST_FITTED = 20_000
"""Largest number of samples for which fits are simulated by default."""


@dataclass(frozen=True)
class SimulatedEstimate:
    """Estimates of one parameter in several fits to simulated recordings.

    Parameters
    ----------
    unit : str
        SI unit.
    standard_error : float
        Median of the reported standard errors, in `unit`.
    deviation : float
        Root mean square of estimate minus assumed value, in `unit`.
    verdict : str
        Median of the reported verdicts.
    determined : int
        Number of fits with the verdict `determined`.
    fits : int
        Number of fits.
    """

    unit: str
    standard_error: float
    deviation: float
    verdict: Verdict
    determined: int
    fits: int


def count_fits(plan: DesignPlan, selected: Sequence[TestCandidate]) -> int:
    """Return the number of simulated fits of the selected tests.

    If the plan does not state it, the default is 5. It is 0 if fits are slow (circuits with sampled controllers, many
    samples), and for designs with an earlier result, because a fit does not use this result.
    """
    if plan.fits is not None:
        return plan.fits
    samples = sum(candidate.samples * len(candidate.sensors) for candidate in selected)
    is_slow = samples > MOST_FITTED or any(c.circuit.instance.model.n_timers > 0 for c in selected)
    return 0 if is_slow or plan.known is not None else USUAL_FITS


def simulate_fits(
    plan: DesignPlan, selected: Sequence[TestCandidate], on_fit: Callable[[int, int], None]
) -> dict[str, SimulatedEstimate]:
    """Fit simulated recordings of the recommended tests, and return the estimates of each free parameter.

    Each test is simulated with the assumed values of the parameters; random noise and sensor offsets are added.
    `on_fit` is called with the number of completed fits and their total number.

    Raises
    ------
    KeyboardInterrupt
        If the user interrupted a fit.
    """
    count, generator = count_fits(plan, selected), np.random.default_rng([plan.seed, len(selected)])
    assumed = by_name(plan.free, [f.start for f in plan.free])
    simulated = []  # noise-free measurements
    for k, candidate in enumerate(selected, start=1):
        measurement = empty_measurement(f"test_{k}", candidate)
        values = noise_free_values(measurement, candidate, assumed, plan.free)
        simulated.append(with_values(measurement, values))
    tables: list[Mapping[str, Estimate]] = []
    for k in range(count):
        on_fit(k, count)
        measurements = []
        for measurement, candidate in zip(simulated, selected, strict=True):
            rows = []
            for channel, sensor in zip(measurement.channels, candidate.sensors, strict=True):
                # A free offset without prior is zero.
                offset = generator.normal(0.0, sensor.offset) if np.isfinite(sensor.offset) else 0.0
                rows.append(channel.values + offset + generator.normal(0.0, sensor.noise, channel.values.size))
            measurements.append(with_values(measurement, rows))
        circuits, roles = [candidate.circuit for candidate in selected], ["fit"] * len(selected)
        free = (
            *plan.free,
            *recording_parameters(measurements, circuits, roles),
            *offset_parameters(measurements, circuits, roles),
        )
        experiments = tuple(
            Experiment(circuit.instance, measurement, free)
            for circuit, measurement in zip(circuits, measurements, strict=True)
        )
        fit_plan = FitPlan(experiments, free)
        optimum = find_optima(fit_plan)
        if optimum.interrupted:
            raise KeyboardInterrupt
        tables.append(describe_optimum(fit_plan, optimum, with_trials=False).parameters)
    result = {}
    for f in plan.free if tables else ():
        estimates = [table[f.name] for table in tables]
        verdicts = sorted((e.verdict for e in estimates), key=VERDICTS.index)
        result[f.name] = SimulatedEstimate(
            f.unit,
            float(np.median([e.standard_error for e in estimates])),
            float(np.sqrt(np.mean([(e.value - f.start) ** 2 for e in estimates]))),
            verdicts[len(verdicts) // 2],
            verdicts.count("determined"),
            len(estimates),
        )
    return result


def empty_measurement(name: str, candidate: TestCandidate) -> Measurement:
    """Return the measurement of one possible test, with zeros instead of samples."""
    time = candidate.sample_time * np.arange(candidate.samples, dtype=np.float64)
    channels = tuple(
        Channel(s.address, time, np.zeros(time.size), s.unit, s.noise, s.lag, offset=s.offset or None)
        for s in candidate.sensors
    )
    ambient = candidate.circuit.surroundings.pressure
    return Measurement(name, channels, start=candidate.start, ambient_pressure=ambient, duration=candidate.duration)


def with_values(measurement: Measurement, values: Sequence[FloatArray]) -> Measurement:
    """Return a measurement with other samples.

    `values` contains the samples of each channel, in the order of the channels.
    """
    channels = zip(measurement.channels, values, strict=True)
    return replace(measurement, channels=tuple(replace(channel, values=row) for channel, row in channels))


def noise_free_values(
    measurement: Measurement, candidate: TestCandidate, values: Mapping[str, float], free: Sequence[FreeParameter]
) -> list[FloatArray]:
    """Return the simulated samples of each channel of a test, without noise.

    `values` maps the names of the free parameters to their values. A sensor lag that is a free parameter has its start
    value.
    """
    # A free initial value starts from the first value of the noise-free recording.
    started = replace(measurement, start={})
    lags = recording_parameters([started], [candidate.circuit], ["fit"])
    experiment = Experiment(candidate.circuit.instance, started, (*free, *lags))
    return experiment.outputs({**values, **by_name(lags, [f.start for f in lags])})
