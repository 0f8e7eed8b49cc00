"""Volumes and bodies of a circuit whose pressures and positions an audit follows."""

from __future__ import annotations

from poppet.circuit.circuit import BaseCircuit
from poppet.parts.tube import Tube


def volumes_of(circuit: BaseCircuit) -> dict[str, tuple[str, ...]]:
    """Return the outputs with the pressures of each volume, by name of the volume.

    The cells of a tube are one volume, which is exhausted when all of them are.
    """
    outputs = dict(circuit.model.outputs)
    volumes: dict[str, list[str]] = {}
    for store in circuit.model.stores:
        owner, _, local = store.name.partition(".")
        name = owner if isinstance(circuit.parts[owner], Tube) and local.isdigit() else store.name
        if f"{store.name}.pressure" in outputs:
            volumes.setdefault(name, []).append(f"{store.name}.pressure")
    return {name: tuple(addresses) for name, addresses in volumes.items()}


def bodies_of(circuit: BaseCircuit) -> dict[str, str]:
    """Return the units of the positions of all bodies, by name of the body."""
    outputs = dict(circuit.model.outputs)
    names = (body for body, _ in circuit.model.bodies)
    return {body: outputs[f"{body}.position"] for body in names if f"{body}.position" in outputs}
