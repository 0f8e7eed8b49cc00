"""Extraction of the plant of a controller from a circuit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.control.manual_plant import ManualPlant
from poppet.control.plant import COMMANDS, Plant
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.parts.bodies import DRY_LAWS, Joint, Mass
from poppet.parts.part import Body, Controller
from poppet.parts.sampled_loop import SampledLoop

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit


def plant_of(circuit: BaseCircuit, controller: str | None = None) -> Plant:
    """Return the plant that a controller of a circuit commands.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a controller and its connections.
    controller : str, optional
        Name of the controller; required if there are several.

    Returns
    -------
    Plant
        Circuit with a free command in place of the controller.

    Raises
    ------
    InputError
        If there is no such controller, or it is not connected. Also if a pressure controller commands openings and the
        circuit has further sampled parts.

    Notes
    -----
    Outer loops are omitted; their controllers command only this controller. Friction with stiction is replaced by
    viscous friction, and hysteresis is omitted, because both act as springs in a steady state. The notes of the plant
    report these changes.
    """
    loop = loop_of(circuit, controller)
    part, controller = loop.part, loop.controller
    changed: dict[str, Any] = {}
    notes = []
    for name, member in loop.circuit.parts.items():
        friction: Any = getattr(member, "friction", None)
        if isinstance(member, Mass | Joint) and friction is not None and friction.kind in DRY_LAWS:
            viscous = friction.viscous_coefficient
            changed[name] = replace(member, friction={"viscous_coefficient": viscous})
            facts = {"law": friction.kind, "value": float(viscous), "unit": viscous.unit}
            notes.append(Note("plant.sliding", f"{name}.friction", **facts))
        elif getattr(member, "hysteresis", None) is not None:
            changed[name] = replace(member, hysteresis=None)  # type: ignore[type-var]
            notes.append(Note("plant.no_hysteresis", f"{name}.hysteresis"))
    simplified = replace(loop.circuit, parts={**loop.circuit.parts, **changed}) if changed else loop.circuit
    has_body = any(isinstance(member, Body) for member in circuit.parts.values())
    # A chamber alone starts at its operating point; other plants reach it in manual mode.
    is_manual = not part.is_of_openings or part.controls != "pressure" or has_body
    remaining = release_command(simplified, controller, keeps_controller=is_manual).instance
    if remaining.model.memory and not is_manual:
        raise InputError("plant.also_sampled", controller, other=remaining.model.memory[0][0].partition(".")[0])
    kind = ManualPlant if is_manual else Plant
    return kind(remaining, controller, part, loop.measurement, loop.commands, loop.begins, tuple(notes))


class Loop(NamedTuple):
    """Controller with its circuit, from which outer loops are removed.

    An outer loop commands only this controller, for example its setpoint.
    """

    circuit: BaseCircuit
    controller: str
    part: SampledLoop
    measurement: str
    commands: Mapping[str, tuple[str, ...]]
    begins: str

    @property
    def numbers(self) -> dict[str, float]:
        """Parameters of the controller in SI units, by name."""
        return self.part.parameters(self.circuit.surroundings)

    @property
    def sample_time(self) -> float:
        """Sample time of the controller [s]."""
        return self.numbers["sample_time"]

    @property
    def sensor_output(self) -> str:
        """Address of the output with the value that the sensor of the controller measures."""
        return f"{self.controller}.sensor_{self.part.controls}"

    @property
    def has_dead_zone(self) -> bool:
        """True if the controller compensates dead zones of its valves."""
        return "dead_zone_smoothing" in self.numbers

    @property
    def command_output(self) -> str:
        """Address of the output with the command of the control law, without the compensation of dead zones."""
        return f"{self.controller}.{'uncompensated_command' if self.has_dead_zone else 'command'}"


def loop_of(circuit: BaseCircuit, controller: str | None = None) -> Loop:
    """Return the loop of the controller with a given name.

    The name is optional if the circuit has only one sampled controller.
    """
    controllers = {name: part for name, part in circuit.parts.items() if isinstance(part, SampledLoop)}
    if controller is None and len(controllers) == 1:
        controller = next(iter(controllers))
    if controller not in controllers:
        suggestion = NameSuggestion(controller or "", controllers)
        if controllers and controller:
            raise InputError("names.unknown", controller, meaning="a controller of this circuit", suggestion=suggestion)
        raise InputError(f"plant.{'several_controllers' if controllers else 'no_controller'}", suggestion=suggestion)
    measurement = circuit.connections.get(f"{controller}.measurement")
    commands: dict[str, tuple[str, ...]] = {}
    for target, source in circuit.connections.items():
        name, _, local = source.partition(".")
        if name == controller and local in COMMANDS:
            commands[local] = (*commands.get(local, ()), target)
    if measurement is None or not commands:
        raise InputError(f"plant.{'measures' if measurement is None else 'commands'}_nothing", controller)
    store, _, output = measurement.partition(".")
    begins = circuit.parts[store].resume.get(output)
    initial_value = f"{store}.{begins}" if begins else ""
    inner_circuit = _remove_outer_loops(circuit, controller)
    return Loop(inner_circuit, controller, controllers[controller], measurement, commands, initial_value)


def release_command(circuit: BaseCircuit, controller: str, *, keeps_controller: bool) -> BaseCircuit:
    """Return a circuit in which the command of a controller becomes a free input.

    The free input is the manual command of the controller, or the inputs of the valves.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the controller.
    controller : str
        Name of the controller.
    keeps_controller : bool
        If True, the controller remains in manual mode, without the connections of its inputs except the measurement.
        Its manual command is then free. If False, the controller is removed. The inputs that the controller drives are
        then free.

    Returns
    -------
    Circuit
        Circuit with free inputs.
    """

    def stays(target: str, source: str = "") -> bool:
        owner, _, local = target.partition(".")
        if keeps_controller:
            return owner != controller or local == "measurement"
        return controller not in (owner, source.partition(".")[0])

    # The circuit is made again: an instance has neither parts nor connections.
    return replace(
        circuit,
        parts={name: part for name, part in circuit.parts.items() if keeps_controller or name != controller},
        connections={target: source for target, source in circuit.connections.items() if stays(target, source)},
        signals={a: s for a, s in circuit.signals.items() if a.partition(".")[0] != controller},
        is_excerpt=True,
    )


def _remove_outer_loops(circuit: BaseCircuit, controller: str) -> BaseCircuit:
    """Return the circuit without the outer loops of a controller.

    An outer controller commands only `controller`, or only other outer controllers.
    """
    targets_of: dict[str, set[str]] = {}
    for target, source in circuit.connections.items():
        name = source.partition(".")[0]
        if isinstance(circuit.parts.get(name), Controller) and name != controller:
            targets_of.setdefault(name, set()).add(target.partition(".")[0])
    outer: set[str] = set()
    while added := {n for n, targets in targets_of.items() if n not in outer and targets <= {controller, *outer}}:
        outer |= added
    if not outer:
        return circuit

    def stays(*addresses: str) -> bool:
        return not outer & {address.partition(".")[0] for address in addresses}

    return replace(
        circuit,
        parts={name: part for name, part in circuit.parts.items() if stays(name)},
        connections={target: source for target, source in circuit.connections.items() if stays(target, source)},
        signals={address: signal for address, signal in circuit.signals.items() if stays(address)},
        is_excerpt=True,
    )
