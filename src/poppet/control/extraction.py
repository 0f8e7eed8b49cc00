"""Taking the plant of a controller out of a circuit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.control.manual_plant import ManualPlant
from poppet.control.plant import COMMANDS, Plant
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.parts.bodies import Joint, Mass
from poppet.parts.part import Body, Controller
from poppet.parts.sampled_loop import SampledLoop

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit


def plant_of(circuit: Circuit, controller: str | None = None) -> Plant:
    """Take a controller out of a circuit.

    Parameters
    ----------
    circuit : Circuit
        With a controller and its connections.
    controller : str, optional
        Its name; needed where there are several.

    Returns
    -------
    Plant
        What is left, and how it was connected.

    Raises
    ------
    InputError
        If there is no such controller, or it measures or commands nothing; if other sampled parts stand beside one that
        opens valves to hold a pressure.

    Notes
    -----
    Controllers that command nothing but this one, the loops around it, are left out. Friction that sticks counts as its
    viscous part, and hysteresis as none: at rest both are springs, which no gains are for. `notes` says so.
    """
    loop = loop_of(circuit, controller)
    part, controller = loop.part, loop.controller
    kept, notes = _sliding(loop.circuit)
    moves = any(isinstance(each, Body) for each in circuit.parts.values())
    # A chamber alone begins at its operating point; anything else is followed there with its controller in manual.
    by_hand = not part.is_of_openings or part.controls != "pressure" or moves
    rest = freed(kept, controller, keeps=by_hand).instance
    if rest.model.memory and not by_hand:
        raise InputError("plant.also_sampled", controller, other=rest.model.memory[0][0].partition(".")[0])
    kind = ManualPlant if by_hand else Plant
    return kind(rest, controller, part, loop.measurement, loop.commands, loop.begins, notes)


class Loop(NamedTuple):
    """A controller in its circuit, without the loops around it."""

    circuit: Circuit
    controller: str
    part: SampledLoop
    measurement: str
    commands: Mapping[str, tuple[str, ...]]
    begins: str

    @property
    def numbers(self) -> dict[str, float]:
        """Of the controller, SI."""
        return self.part.parameters(self.circuit.surroundings)

    @property
    def sample_time(self) -> float:
        """Of the controller [s]."""
        return self.numbers["sample_time"]

    @property
    def shown(self) -> str:
        """Address of what the sensor has come to."""
        return f"{self.controller}.sensor_{self.part.controls}"


def loop_of(circuit: Circuit, controller: str | None = None) -> Loop:
    """The loop of a controller, which is the only one where it has no name; refused as `plant_of` says."""
    known = {name: part for name, part in circuit.parts.items() if isinstance(part, SampledLoop)}
    if controller is None and len(known) == 1:
        controller = next(iter(known))
    if controller not in known:
        code = "unknown_controller" if controller else "several_controllers"
        near = NameSuggestion(controller or "", known)
        raise InputError(f"plant.{code if known else 'no_controller'}", name=controller, near=near)
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
    inner = _without_outer(circuit, controller)
    return Loop(inner, controller, known[controller], measurement, commands, f"{store}.{begins}" if begins else "")


def freed(circuit: Circuit, controller: str, *, keeps: bool) -> Circuit:
    """A circuit without a controller, or with it connected to nothing but what it measures and commands.

    Parameters
    ----------
    circuit : Circuit
        With the controller.
    controller : str
        Its name.
    keeps : bool
        Whether it stays, with its command free.

    Returns
    -------
    Circuit
        In which the inputs that it drove are free.
    """

    def stays(target: str, source: str = "") -> bool:
        owner, _, local = target.partition(".")
        if keeps:
            return owner != controller or local == "measurement"
        return controller not in (owner, source.partition(".")[0])

    # A circuit is truly built anew: an instance knows neither parts nor connections.
    return replace(
        circuit,
        parts={name: part for name, part in circuit.parts.items() if keeps or name != controller},
        connections={target: source for target, source in circuit.connections.items() if stays(target, source)},
        signals={a: s for a, s in circuit.signals.items() if a.partition(".")[0] != controller},
    )


def _without_outer(circuit: Circuit, controller: str) -> Circuit:
    """The circuit without the controllers that act on nothing but this one: the loops around it."""
    outer: set[str] = set()
    while True:
        inside = {controller, *outer}
        acts = {
            name: {t.partition(".")[0] for t, source in circuit.connections.items() if source.partition(".")[0] == name}
            for name, part in circuit.parts.items()
            if isinstance(part, Controller) and name not in inside
        }
        found = {name for name, targets in acts.items() if targets and targets <= inside}
        if not found:
            break
        outer |= found
    if not outer:
        return circuit

    def stays(*addresses: str) -> bool:
        return not outer & {address.partition(".")[0] for address in addresses}

    return replace(
        circuit,
        parts={name: part for name, part in circuit.parts.items() if stays(name)},
        connections={target: source for target, source in circuit.connections.items() if stays(target, source)},
        signals={address: signal for address, signal in circuit.signals.items() if stays(address)},
    )


def _sliding(circuit: Circuit) -> tuple[Circuit, tuple[Note, ...]]:
    """The circuit with friction that sticks taken for its viscous part, for at rest it is a spring; and where."""
    changed: dict[str, Any] = {}
    notes = []
    for name, part in circuit.parts.items():
        friction: Any = getattr(part, "friction", None)
        if isinstance(part, Mass | Joint) and friction is not None and friction.kind in ("stribeck", "lugre"):
            viscous = friction.viscous_coefficient
            changed[name] = replace(part, friction={"viscous_coefficient": viscous})
            facts = {"law": friction.kind, "value": float(viscous), "unit": viscous.unit}
            notes.append(Note("plant.sliding", f"{name}.friction", **facts))
        elif getattr(part, "hysteresis", None) is not None:
            changed[name] = replace(part, hysteresis=None)  # type: ignore[type-var]
            notes.append(Note("plant.no_hysteresis", f"{name}.hysteresis"))
    return (replace(circuit, parts={**circuit.parts, **changed}) if changed else circuit), tuple(notes)
