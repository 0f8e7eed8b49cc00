"""Result of a fit, with the fitted circuit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any, Generic, TypeVar

from poppet.circuit.circuit import BaseCircuit
from poppet.identify.fit.experiment import Experiment, start_values
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.fit_series import driving_signals
from poppet.identify.result import Result, fitted_number

CircuitT = TypeVar("CircuitT", bound=BaseCircuit)


@dataclass(frozen=True)
class FitResult(Result, Generic[CircuitT]):
    """Result of a fit of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the fitted values. After a fit of one recording it also has the inputs and the start values of that
        recording: `circuit.simulate` then repeats the fitted curves.
    circuits : mapping
        Name of each recording to the circuit with its inputs and start values.
    """

    circuit: CircuitT = field(kw_only=True, repr=False, compare=False)
    circuits: Mapping[str, CircuitT] = field(kw_only=True, repr=False, compare=False)

    @classmethod
    def of(cls, result: Result, circuit: CircuitT, plan: FitPlan) -> FitResult[CircuitT]:
        """Return a result with the fitted circuits.

        Parameters
        ----------
        result : Result
            Result of the fit.
        circuit : Circuit
            Circuit before the fit.
        plan : FitPlan
            Plan of the fit.

        Returns
        -------
        FitResult
        """
        circuits = {e.name: _circuit_of(circuit, e, result) for e in (*plan.experiments, *plan.validation)}
        fitted = circuits[plan.experiments[0].name] if len(circuits) == 1 else circuit.with_values(result.values())
        content = {item.name: getattr(result, item.name) for item in fields(Result)}
        return FitResult(**content, circuit=fitted, circuits=circuits)


def _circuit_of(circuit: CircuitT, experiment: Experiment, result: Result) -> CircuitT:
    """Return a circuit with the fitted values, the inputs and the start values of a recording."""
    measurement = experiment.measurement
    values: dict[str, Any] = {a: n for a, n in result.values().items() if a in circuit.numbers()}
    values |= start_values(measurement, experiment.instance)
    shifts: dict[str, dict[str, float]] = {"delay": {}, "input_lag": {}}
    for parameter in experiment.free:
        estimate = result.parameters[parameter.name]
        if parameter.role in shifts:
            shifts[parameter.role][parameter.address] = estimate.value
        elif parameter.role == "start":
            values[parameter.address] = fitted_number(estimate, result.title)
    fitted = circuit.with_values(values)
    if fitted.run.duration is None:
        fitted = fitted.with_values({"run.duration": float(experiment.grid[-1])})
    driven = driving_signals(measurement, shifts["delay"], shifts["input_lag"])
    return replace(fitted, signals={**fitted.signals, **driven}, like=fitted) if driven else fitted
