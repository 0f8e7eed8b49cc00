"""Program of sampled controllers for a microcontroller or a PLC, traced without the rest of the circuit.

Sensors are not part of the program: their values are inputs, and their lags and offsets are not parameters. Connections
between the controllers, such as from an outer loop to an inner one, are part of it. All other inputs are free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.options import Run
from poppet.core.errors import InputError, NameSuggestion
from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter, ExportQuantity, build_export_model
from poppet.engine.model_evaluation import Array, ArrayFunction
from poppet.parts.compound import Compound
from poppet.parts.part import NEVER, Controller, Part

if TYPE_CHECKING:
    import casadi

SIGNATURES = {"start": "p -> z", "update": "t u p z fired -> z", "outputs": "u p z -> y"}
"""Arguments and results of a program's functions: inputs u, parameters p, discrete states z (timers first), outputs y;
`fired` is 1 for each expired timer."""


@dataclass(frozen=True, eq=False)
class ControllerProgram:
    """Program of sampled controllers.

    Parameters
    ----------
    name, title : str
        Identifier of the program; title of the circuit.
    parts : tuple of str
        Names of the controllers in the circuit.
    inputs : tuple of ExportInput
        Inputs of the program, in the order of u.
    parameters : tuple of ExportParameter
        Parameters that can change at run time, in the order of p; the others are constants.
    memory : tuple of ExportQuantity
        Discrete states with start values, in the order of z; the first `n_timers` are the next sample instants [s].
    n_timers : int
        Number of timers.
    outputs : tuple of ExportQuantity
        Outputs, in the order of y.
    cycle : float
        Shortest sample time; call the program with this period [s].
    sensed : dict
        Address of a measured input to the output of a run with its value, and the offset that the sensor adds.
    functions : dict
        CasADi functions `start`, `update`, `outputs` with the `SIGNATURES`, for a printer.
    """

    name: str
    title: str
    parts: tuple[str, ...]
    inputs: tuple[ExportInput, ...]
    parameters: tuple[ExportParameter, ...]
    memory: tuple[ExportQuantity, ...]
    n_timers: int
    outputs: tuple[ExportQuantity, ...]
    cycle: float
    sensed: Mapping[str, tuple[str, float]]
    functions: Mapping[str, casadi.Function]

    def run(self, inputs: Sequence[Array], parameters: Array | None = None, cycle: float | None = None) -> Array:
        """Return the outputs after each call of the program, evaluated by CasADi.

        Parameters
        ----------
        inputs : sequence of (n_inputs,) arrays
            Inputs of each call, SI.
        parameters : (n_parameters,) array, optional
            Parameters (default: those of the circuit).
        cycle : float, optional
            Time between calls (default: `cycle` of the program) [s].

        Returns
        -------
        (n_calls, n_outputs) array
            Outputs, SI.
        """
        p = np.array([parameter.value for parameter in self.parameters]) if parameters is None else parameters
        start, update, outputs = (ArrayFunction(self.functions[name]) for name in SIGNATURES)
        z = start(p)[0].ravel()
        rows = []
        for count, u in enumerate(inputs):
            t = count * (self.cycle if cycle is None else cycle)
            # A timer that is closer than this tolerance has expired, as in the kernel.
            while np.any(fired := z[: self.n_timers] <= t + 1e-14 * t + 1e-15):
                z = update(t, u, p, z, fired.astype(float))[0].ravel()
            rows.append(outputs(u, p, z)[0].ravel())
        return np.array(rows).reshape(len(rows), len(self.outputs))


def controller_program(circuit: BaseCircuit, parts: Sequence[str] = ()) -> ControllerProgram:
    """Return the program of one or several sampled controllers of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with controllers.
    parts : sequence of str, optional
        Names of the controllers; required if there are several. A `proportional_valve` stands for its electronics.

    Returns
    -------
    ControllerProgram

    Raises
    ------
    InputErrors
        If there is no such part, or the part is no sampled controller.
    """
    controllers = find_controllers(circuit)
    if not controllers:
        raise InputError("deploy.controller.none")
    if not parts and len(controllers) > 1:
        raise InputError("deploy.controller.several", known=[*controllers])
    for name in parts:
        if name not in circuit.parts:
            near = NameSuggestion(name, controllers)
            raise InputError("names.unknown", name, meaning="a part of the circuit", suggestion=near)
        if name not in controllers:
            raise InputError("deploy.controller.other", name, kind=circuit.parts[name].kind, known=[*controllers])
    # In the order of the circuit, in which controllers with a common sample instant act.
    selected = {name: part for name, part in controllers.items() if not parts or name in parts}
    if not any(part.timers() for part in selected.values()):
        raise InputError("deploy.controller.unsampled", next(iter(selected)), kind=next(iter(selected.values())).kind)
    controllers_only = _circuit_of_controllers(circuit, selected)
    export_model = build_export_model(controllers_only, "_".join(selected))
    # State of each sensor to the input that it follows, and the prefix of its parameters.
    sensors = {
        f"{name}.{state}": (f"{name}.{target}", f"{name}.{group}.")
        for name, part in selected.items()
        if isinstance(part, Controller)
        for state, (target, group) in part.sensors().items()
    }
    functions, output_indices, used = _trace_functions(export_model, controllers_only, sensors)
    inputs = tuple(export_model.inputs[k] for k in used["u"])
    parameters = tuple(export_model.parameters[k] for k in used["p"])
    start, update, _ = (ArrayFunction(functions[name]) for name in SIGNATURES)
    p = np.array([parameter.value for parameter in parameters])
    z, timers = start(p)[0].ravel(), slice(0, export_model.model.n_timers)
    fired = np.asarray(z[timers] <= 0.0, dtype=float)
    next_instants = update(0.0, np.array([item.value for item in inputs]), p, z, fired)[0].ravel()[timers]
    values = {parameter.address: parameter.value for parameter in export_model.parameters}
    return ControllerProgram(
        export_model.name, circuit.title, tuple(selected), inputs, parameters, export_model.memory, timers.stop,
        tuple(export_model.outputs[k] for k in output_indices), float(next_instants[next_instants < NEVER].min()),
        {target: (state, values[f"{group}offset"]) for state, (target, group) in sensors.items()}, functions,
    )  # fmt: skip


def controllers_of_option(circuit: BaseCircuit, text: str | None) -> list[str]:
    """Return the names of the controllers that the option --part selects.

    `text` is the value of the option. The text `controller` selects the only controller of the circuit.
    """
    parts = [name.strip() for name in (text or "").split(",") if name.strip()]
    return [] if parts == ["controller"] and "controller" not in circuit.parts else parts


def find_controllers(circuit: BaseCircuit) -> dict[str, Part]:
    """Return all controllers of a circuit.

    The keys are the names of the parts that contain them, in the order of the circuit. A compound part has at most one
    controller.
    """
    controllers: dict[str, Part] = {}
    for name, part in circuit.parts.items():
        members = part.members if isinstance(part, Compound) else {"": part}
        candidates = [member for member in members.values() if isinstance(member, Controller)]
        if len(candidates) == 1:
            controllers[name] = candidates[0]
    return controllers


def _circuit_of_controllers(circuit: BaseCircuit, selected: Mapping[str, Part]) -> BaseCircuit:
    """Return a circuit that consists only of selected controllers and their connections."""

    def address_inside(address: str) -> str:
        name, _, local = address.partition(".")
        whole = circuit.parts[name]
        if name in selected and isinstance(whole, Compound):
            member, _, local = whole.outside().get(local, "").partition(".")
            return f"{name}.{local}" if whole.members.get(member) is selected[name] else ""
        return address if name in selected else ""

    pairs = ((address_inside(target), address_inside(source)) for target, source in circuit.connections.items())
    connections = {target: source for target, source in pairs if target and source}
    run = Run(duration="1 s")
    return BaseCircuit(dict(selected), run=run, ambient=circuit.ambient, gas=circuit.gas, connections=connections)


def _trace_functions(
    export_model: ExportModel, circuit: BaseCircuit, sensors: Mapping[str, tuple[str, str]]
) -> tuple[dict[str, casadi.Function], list[int], dict[str, list[int]]]:
    """Return the CasADi functions of a controller program, with indices of outputs and arguments.

    The measured values replace the states of the sensors. The second result contains the indices of the program's
    outputs among the outputs of the model. The third contains the indices of the inputs u and parameters p that are
    arguments: parameters of the sensors and inputs that are only recorded have no effect.
    """
    import casadi as ca

    model, s, e = export_model.model, export_model.model.symbols, export_model.model.expressions
    if continuous := sorted({state.name for state in model.states} - set(sensors)):
        raise InputError("deploy.controller.continuous", continuous[0])
    outputs = ca.densify(e["outputs"])
    indices = {name: k for k, (name, _) in enumerate(model.outputs)}
    measured = [outputs[indices[sensors[state.name][0]]] for state in model.states]
    p, z = ca.SX.sym("p", len(export_model.parameters)), ca.SX.sym("z", len(model.memory))
    groups = tuple(group for _, group in sensors.values())
    values = [
        0.0 if parameter.address.startswith(groups) else p[k] if parameter.is_free else parameter.value
        for k, parameter in enumerate(export_model.parameters)
    ]
    inputs = {f"{name}.{item.name}" for name, part in circuit.parts.items() for item in part.inputs()}
    output_indices = [k for name, k in indices.items() if name not in inputs and name not in sensors]
    symbols = {"t": s["t"], "u": s["u"], "p": p, "z": z, "fired": s["fired"]}
    arguments = {name: signature.partition(" -> ")[0].split() for name, signature in SIGNATURES.items()}
    results = {}
    for name, result in (("start", e["memory_start"]), ("update", e["update"]), ("outputs", outputs[output_indices])):
        # The states first, because their replacements contain inputs and parameters.
        (without_states,) = ca.substitute([ca.densify(result)], [s["x"]], [ca.vertcat(*measured)])
        results[name] = ca.cse(ca.substitute([without_states], [s["p"]], [ca.vertcat(*values, z)]))[0]
    used = {}
    for argument in ("u", "p"):
        sparsities = [
            ca.jacobian_sparsity(results[name], symbols[argument]) for name in results if argument in arguments[name]
        ]
        used[argument] = sorted({column for sparsity in sparsities for column in sparsity.get_col()})
        symbols[argument] = symbols[argument][used[argument]]
    functions = {
        name: ca.Function(name, [symbols[argument] for argument in arguments[name]], [ca.densify(result)])
        for name, result in results.items()
    }
    return functions, output_indices, used
