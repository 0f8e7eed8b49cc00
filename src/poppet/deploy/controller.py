"""Selection of the sampled controllers of a circuit, for export to a microcontroller or a PLC.

Sensors are not part of the exported program: their values are inputs, and their lags and offsets are not parameters.
Connections between the controllers, such as from an outer loop to an inner one, are part of it. All other inputs are
free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.options import Run
from poppet.core.errors import InputError, NameSuggestion
from poppet.deploy.controller_program import ControllerProgram, trace_controller_program
from poppet.deploy.export_model import build_export_model
from poppet.parts.compound import Compound
from poppet.parts.part import Controller, Part


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
    selected = select_controllers(circuit, parts)
    controllers_only = circuit_of_controllers(circuit, selected)
    export_model = build_export_model(controllers_only, "_".join(selected))
    # State of each sensor to the input that it follows, and the prefix of its parameters.
    sensors = {
        f"{name}.{state}": (f"{name}.{target}", f"{name}.{group}.")
        for name, part in selected.items()
        if isinstance(part, Controller)
        for state, (target, group) in part.sensors().items()
    }
    return trace_controller_program(circuit, controllers_only, export_model, sensors)


def select_controllers(circuit: BaseCircuit, parts: Sequence[str] = ()) -> dict[str, Part]:
    """Return selected controllers of a circuit by name.

    The arguments and errors are the same as in `controller_program`.
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
    return selected


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


def circuit_of_controllers(
    circuit: BaseCircuit, selected: Mapping[str, Part], *, with_signals: bool = False
) -> BaseCircuit:
    """Return a circuit that consists only of selected controllers and their connections.

    If the keyword `with_signals` is True, the result also has the signals of the controllers, and the run options of
    the circuit without its stop conditions.
    """

    def address_inside(address: str) -> str:
        name, _, local = address.partition(".")
        whole = circuit.parts[name]
        if name in selected and isinstance(whole, Compound):
            member, _, local = whole.outside().get(local, "").partition(".")
            return f"{name}.{local}" if whole.members.get(member) is selected[name] else ""
        return address if name in selected else ""

    pairs = ((address_inside(target), address_inside(source)) for target, source in circuit.connections.items())
    connections = {target: source for target, source in pairs if target and source}
    run, signals = Run(duration="1 s"), {}
    if with_signals:
        run = replace(circuit.run, stop_when=None)
        signals = {address_inside(a): signal for a, signal in circuit.signals.items() if address_inside(a)}
    return BaseCircuit(
        dict(selected), signals, run, circuit.ambient, circuit.gas, connections=connections, is_excerpt=True
    )
