"""A circuit as CasADi functions, and as a system of python-control."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.control.extraction import release_command
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, needed
from poppet.deploy.export_model import build_export_model
from poppet.engine.model_evaluation import ArrayFunction
from poppet.parts.part import Controller

if TYPE_CHECKING:
    import casadi

    from poppet.circuit.circuit import Circuit
    from poppet.circuit.linear_model import ControlSystem

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class CasadiModel:
    r"""A circuit as :math:`\dot x = f(x, u, p)`, :math:`y = g(x, u, p)`, in CasADi.

    Parameters
    ----------
    f, g : casadi.Function
        Of x, (n,), u, (n_u,), and p, (n_p,): rates, (n,), and outputs, (n_y,); SI and absolute.
    start : casadi.Function
        Of p, (n_p,): the state at the start, (n,), which numbers decide too: the mass of a gas, by its volume.
    states, inputs, numbers, outputs : tuple of str
        Addresses, in the order of x, u, p and y.
    units : dict
        Address of each of them to its SI unit.
    x0, u0, p0 : (n,), (n_u,), (n_p,) arrays
        State at the start with the numbers of the circuit, inputs as they are there, these numbers.
    sizes : (n,) array
        Usual size of each state, SI: divide by it in an optimisation.

    Notes
    -----
    Derivatives of first and second order are exact and finite wherever the states are physical: at rest, at equal
    pressures, with valves fully open or closed. At the kinks of the model they are those of one side.
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
    circuit: Circuit,
    *,
    inputs: Sequence[str] | None = None,
    numbers: Sequence[str] = (),
    without: str | Sequence[str] = (),
) -> CasadiModel:
    """A circuit as CasADi functions: `Circuit.to_casadi`."""
    import casadi as ca

    plant = _without(circuit, (without,) if isinstance(without, str) else without)
    instance = plant.instance
    model = instance.model
    if model.memory:
        raise InputError("tools.sampled", model.memory[0][0])
    free = _free_numbers(plant, numbers)
    x_start, p = instance.start()
    n, u = len(model.states), instance.held_inputs({})
    kept = _places(inputs, instance.input_names)
    x_symbol, u_symbol, p_symbol = (ca.SX.sym(*each) for each in (("x", n), ("u", len(kept)), ("p", len(free))))
    every_u, every_p = ca.SX(u.tolist()), ca.SX(p.tolist())
    every_u[kept], every_p[free] = u_symbol, p_symbol
    s = model.symbols
    # Nothing depends on the quadratures behind the states, and no rate on time.
    given = [ca.SX(0.0), ca.vertcat(x_symbol, ca.SX.zeros(model.n_quadratures)), every_u, every_p]
    traced = [model.expressions["rates"][:n], model.expressions["outputs"]]
    found = ca.substitute(traced, [s[name] for name in ("t", "x", "u", "p")], given)
    names = ["x", "u", "p"]
    f, g = (
        ca.Function(name, [x_symbol, u_symbol, p_symbol], ca.cse([ca.densify(each)]), names, [result])
        for name, each, result in zip(("f", "g"), found, ("rates", "y"), strict=True)
    )
    (begun,) = ca.substitute([model.expressions["start"][:n]], [s["p"]], [every_p])
    start = ca.Function("start", [p_symbol], [ca.densify(begun)], ["p"], ["x"])
    parameters = plant.numbers()
    units = dict(model.outputs) | {s.name: s.unit for s in model.states} | {i.name: i.unit for i in model.inputs}
    return CasadiModel(
        f, g, start, tuple(state.name for state in model.states), tuple(instance.input_names[k] for k in kept),
        tuple(numbers), model.columns[0], units | {name: parameters[name].unit for name in numbers},
        x_start[:n].copy(), u[kept], p[free], np.array([state.nominal for state in model.states]),
    )  # fmt: skip


def to_control(
    circuit: Circuit,
    *,
    linear: bool = False,
    inputs: Sequence[str] | None = None,
    numbers: Sequence[str] = (),
    without: str | Sequence[str] = (),
) -> ControlSystem:
    """A circuit for python-control: `Circuit.to_control`."""
    with needed("control", "A system of python-control", "control"):
        import control
    if linear:
        if inputs is not None or numbers:
            raise InputError("tools.of_nonlinear", "inputs" if inputs is not None else "numbers")
        return _without(circuit, (without,) if isinstance(without, str) else without).linearise().to_control()
    model = to_casadi(circuit, inputs=inputs, numbers=numbers, without=without)
    f, g = ArrayFunction(model.f), ArrayFunction(model.g)
    # python-control takes a dot for the border between system and signal.
    names = {name: name.replace(".", "__") for name in (*model.states, *model.inputs, *model.numbers, *model.outputs)}

    def of(function: ArrayFunction) -> Any:
        def evaluated(t: float, x: Array, u: Array, params: Mapping[str, float]) -> Array:
            p = np.array([params[names[each]] for each in model.numbers])
            return function(np.asarray(x), np.asarray(u), p)[0].ravel()

        return evaluated

    system: ControlSystem = control.nlsys(
        of(f), of(g),
        inputs=[names[each] for each in model.inputs], outputs=[names[each] for each in model.outputs],
        states=[names[each] for each in model.states],
        params={names[name]: float(value) for name, value in zip(model.numbers, model.p0, strict=True)},
    )  # fmt: skip
    return system


def _without(circuit: Circuit, controllers: Sequence[str]) -> Circuit:
    """The circuit without some controllers; the inputs that they drove are free."""
    known = [name for name, part in circuit.parts.items() if isinstance(part, Controller)]
    for name in controllers:
        if name not in known:
            raise InputError("tools.no_controller", name, near=NameSuggestion(name, known))
        circuit = release_command(circuit, name, keeps=False)
    return circuit


def _free_numbers(circuit: Circuit, numbers: Sequence[str]) -> list[int]:
    """Places in p of numbers from which no others follow."""
    if not numbers:
        return []
    run = circuit.run if circuit.run.duration is not None else replace(circuit.run, duration="1 s")
    known = {
        each.address: (k, each.fixed) for k, each in enumerate(build_export_model(replace(circuit, run=run)).numbers)
    }
    places = []
    with ErrorCollector() as errors:
        for name in numbers:
            place, fixed = known.get(name, (-1, ""))
            if place < 0:
                errors.add("tools.no_number", name, near=NameSuggestion(name, known))
            elif fixed not in ("", "delay"):
                errors.add("tools.fixed", name)
            places.append(place)
    return places


def _places(wanted: Sequence[str] | None, known: Sequence[str]) -> list[int]:
    if wanted is None:
        return [*range(len(known))]
    with ErrorCollector() as errors:
        for name in wanted:
            if name not in known:
                errors.add("inputs.unknown", name, near=NameSuggestion(name, known))
    return [known.index(name) for name in wanted]
