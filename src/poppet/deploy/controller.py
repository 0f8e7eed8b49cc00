"""Program of sampled controllers for a microcontroller or a PLC, traced without the rest of the circuit.

Sensors are not part of the program: their values are inputs, and their lags and offsets are not parameters. Connections
between the controllers, such as from an outer loop to an inner one, are part of it. All other inputs are free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.options import Run
from poppet.core.errors import InputError, NameSuggestion
from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter, ExportQuantity, build_export_model
from poppet.engine.model_evaluation import Array, ArrayFunction
from poppet.parts.compound import Compound
from poppet.parts.part import NEVER, Controller, Part

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
    functions: Mapping[str, Any]

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
    selected = _select_controllers(circuit, tuple(parts))
    if not any(part.timers() for part in selected.values()):
        raise InputError("deploy.controller.unsampled", next(iter(selected)), kind=next(iter(selected.values())).kind)
    controllers_only = _circuit_of_controllers(circuit, selected)
    export_model = build_export_model(controllers_only, "_".join(selected))
    return _program(export_model, controllers_only, circuit.title)


def select_parts(circuit: BaseCircuit, text: str | None) -> list[str]:
    """Return the names of the controllers in the text of the option --part.

    The text `controller` selects the only controller of the circuit.
    """
    parts = [name.strip() for name in (text or "").split(",") if name.strip()]
    return [] if parts == ["controller"] and "controller" not in circuit.parts else parts


def find_controllers(circuit: BaseCircuit) -> dict[str, Part]:
    """Return the controllers of a circuit by the names of the parts that contain them.

    The order is that of the circuit. A compound part has at most one controller.
    """
    controllers: dict[str, Part] = {}
    for name, part in circuit.parts.items():
        members = part.members if isinstance(part, Compound) else {"": part}
        candidates = [member for member in members.values() if isinstance(member, Controller)]
        if len(candidates) == 1:
            controllers[name] = candidates[0]
    return controllers


def _select_controllers(circuit: BaseCircuit, parts: tuple[str, ...]) -> dict[str, Part]:
    controllers = find_controllers(circuit)
    if not controllers:
        raise InputError("deploy.controller.none")
    if not parts and len(controllers) > 1:
        raise InputError("deploy.controller.several", known=[*controllers])
    for name in parts:
        if name not in circuit.parts:
            raise InputError("deploy.controller.unknown", name, near=NameSuggestion(name, controllers))
        if name not in controllers:
            raise InputError("deploy.controller.other", name, kind=circuit.parts[name].kind, known=[*controllers])
    # In the order of the circuit, in which controllers with a common sample instant act.
    return {name: part for name, part in controllers.items() if not parts or name in parts}


def _circuit_of_controllers(circuit: BaseCircuit, selected: Mapping[str, Part]) -> BaseCircuit:
    """Return a circuit that contains only the selected controllers and the connections between them."""

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


def _program(export_model: ExportModel, circuit: BaseCircuit, title: str) -> ControllerProgram:
    model = export_model.model
    # State of each sensor to the input that it follows, and the prefix of its parameters.
    sensors = {
        f"{name}.{state}": (f"{name}.{target}", f"{name}.{group}.")
        for name, part in circuit.parts.items()
        if isinstance(part, Controller)
        for state, (target, group) in part.sensors().items()
    }
    functions, output_indices = _trace_functions(export_model, circuit, sensors)
    # Parameters of the sensors and inputs that are only recorded have no effect.
    parameters = _used_elements([(functions[name], k) for name, k in (("start", 0), ("update", 2), ("outputs", 1))])
    inputs = _used_elements([(functions["update"], 1), (functions["outputs"], 0)])
    start, update, _ = (ArrayFunction(functions[name]) for name in SIGNATURES)
    p = np.array([parameter.value for parameter in export_model.parameters])
    u = np.array([item.value for item in export_model.inputs])
    z = start(p)[0].ravel()
    timers = slice(0, model.n_timers)
    next_instants = update(0.0, u, p, z, np.asarray(z[timers] <= 0.0, dtype=float))[0].ravel()[timers]
    values = {parameter.address: parameter.value for parameter in export_model.parameters}
    return ControllerProgram(
        export_model.name, title, tuple(circuit.parts),
        tuple(export_model.inputs[k] for k in inputs), tuple(export_model.parameters[k] for k in parameters),
        export_model.memory, model.n_timers, tuple(export_model.outputs[k] for k in output_indices),
        float(next_instants[next_instants < NEVER].min()),
        {target: (state, values[f"{group}offset"]) for state, (target, group) in sensors.items()},
        _restrict_arguments(functions, {"u": inputs, "p": parameters}),
    )  # fmt: skip


def _trace_functions(
    export_model: ExportModel, circuit: BaseCircuit, sensors: Mapping[str, tuple[str, str]]
) -> tuple[dict[str, Any], list[int]]:
    """Return the CasADi functions of a controller program, with all inputs and parameters as arguments.

    The measured values replace the states of the sensors. The second result contains the indices of the program's
    outputs among the outputs of the model.
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

    def substitute_symbols(expression: Any) -> Any:
        # The states first, because their replacements contain inputs and parameters.
        (without_states,) = ca.substitute([ca.densify(expression)], [s["x"]], [ca.vertcat(*measured)])
        return ca.cse(ca.substitute([without_states], [s["p"]], [ca.vertcat(*values, z)]))[0]

    inputs = {f"{name}.{item.name}" for name, part in circuit.parts.items() for item in part.inputs()}
    output_indices = [k for name, k in indices.items() if name not in inputs and name not in sensors]
    t, u, fired = s["t"], s["u"], s["fired"]
    return {
        "start": ca.Function("start", [p], [substitute_symbols(e["memory_start"])]),
        "update": ca.Function("update", [t, u, p, z, fired], [substitute_symbols(e["update"])]),
        "outputs": ca.Function("outputs", [u, p, z], [substitute_symbols(outputs[output_indices])]),
    }, output_indices


def _used_elements(arguments: Sequence[tuple[Any, int]]) -> list[int]:
    """Return the indices of the elements of an argument that affect any of the functions.

    Each element of `arguments` is a function and the position of the argument in it.
    """
    indices: set[int] = set()
    for function, position in arguments:
        indices |= set(function.jac_sparsity(0, position).get_col())
    return sorted(indices)


def _restrict_arguments(functions: Mapping[str, Any], elements: Mapping[str, list[int]]) -> dict[str, Any]:
    """Return the functions with shorter argument vectors.

    `elements` maps the name of an argument to the indices of the elements that remain.
    """
    import casadi as ca

    restricted = {}
    for name, signature in SIGNATURES.items():
        symbols = functions[name].sx_in()
        argument_names = signature.partition(" -> ")[0].split()
        (result,) = functions[name].call(symbols)
        arguments = [
            symbol[elements[argument]] if argument in elements else symbol
            for argument, symbol in zip(argument_names, symbols, strict=True)
        ]
        restricted[name] = ca.Function(name, arguments, [ca.densify(result)])
    return restricted
