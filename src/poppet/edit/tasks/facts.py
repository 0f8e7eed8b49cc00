"""Facts about the present circuit, from which the page makes the forms of the tasks."""

from __future__ import annotations

from typing import Any

from poppet.circuit.circuit import BaseCircuit
from poppet.deploy.controller import find_controllers
from poppet.deploy.targets import TARGETS
from poppet.edit.tasks.order import default_range, written_value
from poppet.ensemble.ensemble_plan import varied_specs
from poppet.ensemble.metrics import METRIC_KINDS
from poppet.parts.pid import PID


def task_facts(circuit: BaseCircuit) -> dict[str, Any]:
    """Return the names that the forms of the tasks offer.

    The result contains outputs and inputs with their SI units, parameters with their values, controllers, metrics and
    export targets.
    """
    numbers, ambient = circuit.numbers(), circuit.surroundings.pressure
    driven = {*circuit.signals, *circuit.connections}
    parameters = {
        address: {
            "text": numbers[address].display(),
            "unit": spec.unit,
            "value": numbers[address].absolute(ambient),
            "range": [
                str(written_value(end, spec.unit, numbers[address], digits=3, ambient=ambient))
                for end in default_range(circuit, address, spec)
            ],
        }
        for address, spec in varied_specs(circuit).items()
        if address not in driven
    }
    ensemble = circuit.origin.tables.get("ensemble", {})
    return {
        "outputs": dict(circuit.model.outputs),
        "inputs": {address: item.unit for address, item in circuit.inputs.items()},
        "parameters": parameters,
        "controllers": [name for name, part in circuit.parts.items() if isinstance(part, PID)],
        "sampled": [*find_controllers(circuit)],
        "has_ensemble": bool(ensemble.get("parameters") or ensemble.get("numbers") or ensemble.get("file")),
        "metrics": [*ensemble.get("metrics", {})],
        "requirements": {name: str(text) for name, text in circuit.origin.tables.get("requirements", {}).items()},
        "metric_kinds": {name: kind.meaning for name, kind in METRIC_KINDS.items()},
        "targets": {name: {"summary": target.summary, "needs_part": name == "st"} for name, target in TARGETS.items()},
    }
