"""The program of sampled controllers alone: what a microcontroller or a PLC runs, traced as part of no circuit.

Sensors stay outside: what they show are inputs, and their lags and offsets are no numbers of the program. Connections
between the controllers, as from an outer loop to an inner one, are in it; every other input is free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.circuit.options import Run
from poppet.core.errors import InputError, NameSuggestion
from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter, Quantity, build_export_model
from poppet.engine.model_evaluation import Array, ArrayFunction
from poppet.parts.compound import Compound
from poppet.parts.part import NEVER, Controller, Part

SIGNATURES = {"start": "p -> z", "update": "t u p z fired -> z", "outputs": "u p z -> y"}
"""Arguments and results of a program's functions: inputs u, numbers p, memory z with its timers in front, outputs y;
`fired` is 1 for each timer that has come."""


@dataclass(frozen=True, eq=False)
class ControllerProgram:
    """What sampled controllers do at their instants.

    Parameters
    ----------
    name, title : str
        An identifier; the title of the circuit.
    parts : tuple of str
        Names of the controllers in the circuit.
    inputs : tuple of CarriedInput
        In the order of u: those that the program reads.
    numbers : tuple of CarriedNumber
        In the order of p: those on which it depends and that may be changed while it runs; others are constants in it.
    memory : tuple of Quantity
        In the order of z, with its values at the start; the first `n_timers` are the times of the next instants [s].
    n_timers : int
        How many.
    outputs : tuple of Quantity
        In the order of y.
    cycle : float
        Shortest sample time, with which the program is to be called [s].
    sensed : dict
        Input that a sensor feeds to the series of a run that shows its value, and the offset that a sensor adds.
    functions : dict
        CasADi functions `start`, `update`, `outputs`, as `SIGNATURES` has them, for a printer.
    """

    name: str
    title: str
    parts: tuple[str, ...]
    inputs: tuple[ExportInput, ...]
    numbers: tuple[ExportParameter, ...]
    memory: tuple[Quantity, ...]
    n_timers: int
    outputs: tuple[Quantity, ...]
    cycle: float
    sensed: Mapping[str, tuple[str, float]]
    functions: Mapping[str, Any]

    def calls(self, inputs: Sequence[Array], numbers: Array | None = None, cycle: float | None = None) -> Array:
        """Outputs of the program after each of its calls, evaluated by CasADi: what any text of it must give.

        Parameters
        ----------
        inputs : sequence of (n_inputs,) arrays
            For each call, SI.
        numbers : (n_numbers,) array, optional
            Default those of the circuit.
        cycle : float, optional
            Time between calls [s].

        Returns
        -------
        (n_calls, n_outputs) array
        """
        p = np.array([each.value for each in self.numbers]) if numbers is None else numbers
        start, update, outputs = (ArrayFunction(self.functions[name]) for name in SIGNATURES)
        z = start(p)[0].ravel()
        rows = []
        for count, u in enumerate(inputs):
            t = count * (self.cycle if cycle is None else cycle)
            while np.any(fired := z[: self.n_timers] <= due(t)):
                z = update(t, u, p, z, fired.astype(float))[0].ravel()
            rows.append(outputs(u, p, z)[0].ravel())
        return np.array(rows).reshape(len(rows), len(self.outputs))


def due(t: float) -> float:
    """Timers up to this time have come at a call at time t: what is closer is one instant, as for the kernel."""
    return t + 1e-14 * t + 1e-15


def controller_program(circuit: Circuit, parts: Sequence[str] = ()) -> ControllerProgram:
    """The program of one or several sampled controllers of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Where they stand.
    parts : sequence of str, optional
        Their names; needed where there are several. A `proportional_valve` stands for its electronics.

    Returns
    -------
    ControllerProgram

    Raises
    ------
    InputErrors
        If there is no such part, or it is no controller.
    """
    chosen = _chosen(circuit, tuple(parts))
    if not any(part.timers() for part in chosen.values()):
        raise InputError("deploy.controller.unsampled", next(iter(chosen)), kind=next(iter(chosen.values())).kind)
    alone = _alone(circuit, chosen)
    return _program(build_export_model(alone, "_".join(chosen)), alone, circuit.title)


def controllers(circuit: Circuit) -> dict[str, Part]:
    """Controllers by the name of their part; a compound that holds one stands for it.

    Parameters
    ----------
    circuit : Circuit
        Of any parts.

    Returns
    -------
    dict
        In the order of the circuit.
    """
    found: dict[str, Part] = {}
    for name, part in circuit.parts.items():
        inner = part.members if isinstance(part, Compound) else {"": part}
        own = [each for each in inner.values() if isinstance(each, Controller)]
        if len(own) == 1:
            found[name] = own[0]
    return found


def _chosen(circuit: Circuit, parts: tuple[str, ...]) -> dict[str, Part]:
    known = controllers(circuit)
    if not known:
        raise InputError("deploy.controller.none")
    if not parts and len(known) > 1:
        raise InputError("deploy.controller.several", known=[*known])
    for name in parts:
        if name not in circuit.parts:
            raise InputError("deploy.controller.unknown", name, near=NameSuggestion(name, known))
        if name not in known:
            raise InputError("deploy.controller.other", name, kind=circuit.parts[name].kind, known=[*known])
    # In the order of the circuit, in which those act that sample together.
    return {name: part for name, part in known.items() if not parts or name in parts}


def _alone(circuit: Circuit, chosen: Mapping[str, Part]) -> Circuit:
    """A circuit of nothing but the chosen controllers, with the connections between them."""

    def inside(address: str) -> str:
        name, _, local = address.partition(".")
        whole = circuit.parts[name]
        if name in chosen and isinstance(whole, Compound):
            member, _, local = whole.outside().get(local, "").partition(".")
            return f"{name}.{local}" if whole.members.get(member) is chosen[name] else ""
        return address if name in chosen else ""

    pairs = ((inside(target), inside(source)) for target, source in circuit.connections.items())
    joined = {target: source for target, source in pairs if target and source}
    return Circuit(dict(chosen), run=Run(duration="1 s"), ambient=circuit.ambient, gas=circuit.gas, connections=joined)


def _program(of: ExportModel, circuit: Circuit, title: str) -> ControllerProgram:
    model = of.model
    functions, kept = _functions(of, circuit)
    # What nothing depends on is left out: numbers of the sensors, inputs that are only recorded.
    numbers = _needed([(functions[name], k) for name, k in (("start", 0), ("update", 2), ("outputs", 1))])
    inputs = _needed([(functions["update"], 1), (functions["outputs"], 0)])
    start, update, _ = (ArrayFunction(functions[name]) for name in SIGNATURES)
    p, u = np.array([each.value for each in of.numbers]), np.array([each.value for each in of.inputs])
    z = start(p)[0].ravel()
    timers = slice(0, model.n_timers)
    following = update(0.0, u, p, z, np.asarray(z[timers] <= 0.0, dtype=float))[0].ravel()[timers]
    return ControllerProgram(
        of.name, title, tuple(circuit.parts),
        tuple(of.inputs[k] for k in inputs), tuple(of.numbers[k] for k in numbers),
        of.memory, model.n_timers, tuple(of.outputs[k] for k in kept),
        float(following[following < NEVER].min()), _sensed(of, circuit), _narrowed(functions, inputs, numbers),
    )  # fmt: skip


def _sensors(circuit: Circuit) -> dict[str, tuple[str, str]]:
    """State of each sensor to the input that it follows, and the group of its numbers, by address."""
    return {
        f"{name}.{state}": (f"{name}.{target}", f"{name}.{group}.")
        for name, part in circuit.parts.items()
        if isinstance(part, Controller)
        for state, (target, group) in part.sensors().items()
    }


def _sensed(of: ExportModel, circuit: Circuit) -> dict[str, tuple[str, float]]:
    values = {each.address: each.value for each in of.numbers}
    return {target: (state, values[f"{group}offset"]) for state, (target, group) in _sensors(circuit).items()}


def _functions(of: ExportModel, circuit: Circuit) -> tuple[dict[str, Any], list[int]]:
    """The functions of all inputs and numbers, and the places of their outputs in those of the model."""
    import casadi as ca

    model, s = of.model, of.model.symbols
    sensors = _sensors(circuit)
    if others := sorted({each.name for each in model.states} - set(sensors)):
        raise InputError("deploy.controller.continuous", others[0])
    outputs = ca.densify(model.expressions["outputs"])
    places = {name: k for k, (name, _) in enumerate(model.outputs)}
    shown = [outputs[places[sensors[each.name][0]]] for each in model.states]
    p, z = ca.SX.sym("p", len(of.numbers)), ca.SX.sym("z", len(model.memory))
    groups = tuple(group for _, group in sensors.values())
    values = [
        0.0 if each.address.startswith(groups) else p[k] if each.is_free else each.value
        for k, each in enumerate(of.numbers)
    ]

    def alone(expression: Any) -> Any:
        # The states first, for what stands for them holds inputs and numbers.
        (found,) = ca.substitute([ca.densify(expression)], [s["x"]], [ca.vertcat(*shown)])
        return ca.cse(ca.substitute([found], [s["p"]], [ca.vertcat(*values, z)]))[0]

    inputs = {f"{name}.{item.name}" for name, part in circuit.parts.items() for item in part.inputs()}
    kept = [k for name, k in places.items() if name not in inputs and name not in sensors]
    e, t, u, fired = model.expressions, s["t"], s["u"], s["fired"]
    return {
        "start": ca.Function("start", [p], [alone(e["memory_start"])]),
        "update": ca.Function("update", [t, u, p, z, fired], [alone(e["update"])]),
        "outputs": ca.Function("outputs", [u, p, z], [alone(outputs[kept])]),
    }, kept


def _needed(arguments: Sequence[tuple[Any, int]]) -> list[int]:
    """Elements of an argument on which the result of one of some functions depends."""
    found: set[int] = set()
    for function, place in arguments:
        found |= set(function.jac_sparsity(0, place).get_col())
    return sorted(found)


def _narrowed(functions: Mapping[str, Any], inputs: Sequence[int], numbers: Sequence[int]) -> dict[str, Any]:
    """The same functions of the inputs and numbers that they need."""
    import casadi as ca

    found = {}
    for name, signature in SIGNATURES.items():
        given = functions[name].sx_in()
        words = signature.partition(" -> ")[0].split()
        (result,) = functions[name].call(given)
        places = {"u": list(inputs), "p": list(numbers)}
        narrow = [each[places[word]] if word in places else each for word, each in zip(words, given, strict=True)]
        found[name] = ca.Function(name, narrow, [ca.densify(result)])
    return found
