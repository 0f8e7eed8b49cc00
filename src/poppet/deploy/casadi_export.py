"""Export of a circuit as CasADi functions and as a system of python-control."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from poppet.control.extraction import release_command
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, needed
from poppet.deploy.export_model import build_export_model
from poppet.engine.model_evaluation import ArrayFunction
from poppet.parts.part import Controller

if TYPE_CHECKING:
    import casadi

    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.linear_model import ControlSystem

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class CasadiModel:
    r"""Circuit as :math:`\dot x = f(x, u, p)`, :math:`y = g(x, u, p)` in CasADi.

    Parameters
    ----------
    f, g : casadi.Function
        Rates, (n,), and outputs, (n_y,), as functions of x, (n,), u, (n_u,), and p, (n_p,); SI and absolute.
    start : casadi.Function
        State at the start, (n,), as a function of p, (n_p,): the mass of a gas depends on its volume, for example.
    states, inputs, numbers, outputs : tuple of str
        Addresses, in the order of x, u, p and y.
    units : dict
        SI unit of each address.
    x0, u0, p0 : (n,), (n_u,), (n_p,) arrays
        State at the start, inputs at the start, and parameters of the circuit.
    sizes : (n,) array
        Nominal size of each state, SI: use it to scale an optimisation problem.

    Notes
    -----
    The first and second derivatives are exact and finite in all physical states: at rest, at equal pressures, with
    valves fully open or closed. At the kinks of the model they are one-sided.
    """

    f: casadi.Function
    g: casadi.Function
    start: casadi.Function
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    numbers: tuple[str, ...]
    outputs: tuple[str, ...]
    units: Mapping[str, str]
    x0: Array
    u0: Array
    p0: Array
    sizes: Array


def to_casadi(
    circuit: BaseCircuit,
    *,
    inputs: Sequence[str] | None = None,
    numbers: Sequence[str] = (),
    without: str | Sequence[str] = (),
) -> CasadiModel:
    """Return a circuit as CasADi functions.

    The public method `Circuit.to_casadi` describes the arguments.
    """
    import casadi as ca

    plant = _without_controllers(circuit, without)
    instance = plant.instance
    model = instance.model
    if model.memory:
        raise InputError("tools.sampled", model.memory[0][0])
    run = plant.run if plant.run.duration is not None else replace(plant.run, duration="1 s")
    parameters = build_export_model(replace(plant, run=run)).parameters if numbers else ()
    fixed = {parameter.address: parameter.fixed for parameter in parameters}
    with ErrorCollector() as errors:
        for address in numbers:
            if address not in fixed:
                near = NameSuggestion(address, fixed)
                errors.add("names.unknown", address, meaning="a parameter of the circuit", suggestion=near)
            elif fixed[address] not in ("", "delay"):
                errors.add("tools.fixed", address)
    free = [*map(instance.place, numbers)]
    x_start, p = instance.start()
    n, u = len(model.states), instance.held_inputs({})
    with ErrorCollector() as errors:
        for name in inputs or ():
            if name not in instance.input_names:
                near = NameSuggestion(name, instance.input_names)
                errors.add("names.unknown", name, meaning="an input of this circuit", suggestion=near)
    driven = [*map(instance.input_names.index, instance.input_names if inputs is None else inputs)]
    sizes_by_symbol = (("x", n), ("u", len(driven)), ("p", len(free)))
    x_symbol, u_symbol, p_symbol = (ca.SX.sym(name, size) for name, size in sizes_by_symbol)
    all_u, all_p = ca.SX(u.tolist()), ca.SX(p.tolist())
    all_u[driven], all_p[free] = u_symbol, p_symbol
    s, e = model.symbols, model.expressions
    # No expression depends on the quadratures after the states, and no rate on time.
    arguments = [ca.SX(0.0), ca.vertcat(x_symbol, ca.SX.zeros(model.n_quadratures)), all_u, all_p]
    symbols = [s[name] for name in ("t", "x", "u", "p")]
    rates, outputs = ca.substitute([e["rates"][:n], e["outputs"]], symbols, arguments)
    (start_state,) = ca.substitute([e["start"][:n]], [s["p"]], [all_p])
    f, g = (
        ca.Function(
            name, [x_symbol, u_symbol, p_symbol], ca.cse([ca.densify(expression)]), ["x", "u", "p"], [result]
        )
        for name, expression, result in (("f", rates, "rates"), ("g", outputs, "y"))
    )  # fmt: skip
    start = ca.Function("start", [p_symbol], [ca.densify(start_state)], ["p"], ["x"])
    units = dict(model.outputs) | {state.name: state.unit for state in model.states}
    units |= {item.name: item.unit for item in model.inputs}
    declared = plant.numbers()
    return CasadiModel(
        f, g, start, tuple(state.name for state in model.states), tuple(instance.input_names[k] for k in driven),
        tuple(numbers), model.columns[0], units | {name: declared[name].unit for name in numbers},
        x_start[:n].copy(), u[driven], p[free], np.array([state.nominal for state in model.states]),
    )  # fmt: skip


def to_control(
    circuit: BaseCircuit,
    *,
    linear: bool = False,
    inputs: Sequence[str] | None = None,
    numbers: Sequence[str] = (),
    without: str | Sequence[str] = (),
) -> ControlSystem:
    """Return a circuit as a system of python-control.

    The public method `Circuit.to_control` describes the arguments.
    """
    with needed("control", "A system of python-control", "control"):
        import control
    if linear:
        if inputs is not None or numbers:
            raise InputError("tools.of_nonlinear", "inputs" if inputs is not None else "numbers")
        return _without_controllers(circuit, without).linearise().to_control()
    model = to_casadi(circuit, inputs=inputs, numbers=numbers, without=without)
    # In python-control a dot separates system and signal.
    names = {name: name.replace(".", "__") for name in (*model.states, *model.inputs, *model.numbers, *model.outputs)}

    def adapt(function: casadi.Function) -> Callable[[float, Array, Array, Mapping[str, float]], Array]:
        evaluation = ArrayFunction(function)

        def evaluate(t: float, x: Array, u: Array, params: Mapping[str, float]) -> Array:
            p = np.array([params[names[address]] for address in model.numbers])
            return evaluation(np.asarray(x), np.asarray(u), p)[0].ravel()

        return evaluate

    system: ControlSystem = control.nlsys(
        adapt(model.f), adapt(model.g),
        inputs=[names[name] for name in model.inputs], outputs=[names[name] for name in model.outputs],
        states=[names[name] for name in model.states],
        params={names[name]: float(value) for name, value in zip(model.numbers, model.p0, strict=True)},
    )  # fmt: skip
    return system


def _without_controllers(circuit: BaseCircuit, controllers: str | Sequence[str]) -> BaseCircuit:
    """Return the circuit without some of its controllers.

    `controllers` are names. The inputs that these controllers drive become free inputs.
    """
    available = [name for name, part in circuit.parts.items() if isinstance(part, Controller)]
    for name in (controllers,) if isinstance(controllers, str) else controllers:
        if name not in available:
            near = NameSuggestion(name, available)
            raise InputError("fields.not_an_option", "without", value=name, meaning="controller", suggestion=near)
        circuit = release_command(circuit, name, keeps_controller=False)
    return circuit
