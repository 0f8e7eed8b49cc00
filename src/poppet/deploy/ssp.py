"""Export as an SSP: a system of FMUs with their connections (System Structure and Parameterization 1.0).

Each sampled controller is one component, and all other parts are the component of the plant.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.version import __version__
from poppet.deploy.export_files import identifier, identifiers
from poppet.deploy.fmu.description import base_unit, element
from poppet.deploy.fmu.fmu_layout import FmuLayout
from poppet.deploy.fmu.package import build_fmu, free_inputs, zip_bytes
from poppet.deploy.targets import CircuitSource, Export
from poppet.engine.printers.instructions import trace_functions
from poppet.parts.part import Controller

if TYPE_CHECKING:
    from poppet.parts.part import Part

PLANT = "plant"
NAMESPACES = {
    "xmlns:ssc": "http://ssp-standard.org/SSP1/SystemStructureCommon",
    "xmlns:ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
}
FMU_TYPE = "application/x-fmu-sharedlibrary"


class Component(NamedTuple):
    """Component of a system: circuit of some parts of the whole circuit."""

    name: str
    file: str  # in the archive
    circuit: BaseCircuit
    inputs: tuple[str, ...]  # addresses that the importer sets
    outputs: tuple[str, ...]  # addresses that other components use


class System(NamedTuple):
    """Circuit that is divided into components.

    `connections` maps inputs to outputs of other components.
    """

    components: tuple[Component, ...]
    connections: Mapping[str, str]

    def owner(self, address: str) -> str:
        """Return the name of the component whose circuit contains a part.

        `address` is the name of the part, or an address that begins with this name, such as `tank.pressure`.
        """
        part = address.partition(".")[0]
        return next(component.name for component in self.components if part in component.circuit.parts)


def export_ssp(
    circuit: BaseCircuit, source: CircuitSource, *, fmi: str = "2", platform: str | None = None, name: str | None = None
) -> Export:
    """Export a circuit as a system of FMUs.

    The keyword arguments are the options of `poppet export ssp`.
    """
    circuit.run.grid()  # raises the error of a missing duration
    platforms = [entry.strip() for entry in (platform or "").split(",") if entry.strip()] or ["linux64"]
    system = divide_circuit(circuit)
    starts = dict[str, float]()
    if system.connections:
        # Values of the connected inputs at the start of the run of the whole circuit.
        problem, model = circuit.problem(circuit.run), circuit.model
        first = problem.coefficients[problem.courses[0]]
        u = first[:, 0] + first[:, 2] * np.sin(first[:, 5])
        y = trace_functions(model)["outputs"](0.0, problem.x0, u[: len(model.inputs)], problem.p)
        index_of = {name: k for k, (name, _) in enumerate(model.outputs)}
        starts = {target: float(y[index_of[source]]) for target, source in system.connections.items()}
    content: dict[str, bytes] = {}
    layouts: dict[str, FmuLayout] = {}
    notes = (
        [Note("deploy.ssp.no_stop", "run.stop_when")] if circuit.run.stop_texts and len(system.components) > 1 else []
    )
    for component in system.components:
        fmu = build_fmu(
            component.circuit, component.name, fmi=int(fmi), platforms=platforms, inputs=component.inputs,
            exposed=component.outputs, follows_signals=True, starts=starts,
        )  # fmt: skip
        content[component.file] = zip_bytes(fmu.content)
        layouts[component.name] = fmu.layout
        notes += [note for note in fmu.notes if note not in notes]
    title = name or circuit.title or source.name or "system"
    content["SystemStructure.ssd"] = describe_system(system, layouts, " ".join(title.split())).encode()
    steps = [circuit.parameters[f"{c.name}.sample_time"] for c in system.components if c.name in _sampled(circuit)]
    summary = f"components: {', '.join(layouts)}; connections: {len(system.connections)}"
    if steps:
        summary += f"\nsmallest sample time: {min(steps):g} s; use a communication step that divides it"
    return Export({f"{identifier(title)}.ssp": zip_bytes(content)}, summary, tuple(notes))


def _sampled(circuit: BaseCircuit) -> dict[str, Part]:
    """Return the sampled controllers of a circuit by name; those inside compound parts are omitted."""
    return {name: part for name, part in circuit.parts.items() if isinstance(part, Controller) and part.timers()}


def divide_circuit(circuit: BaseCircuit) -> System:
    """Return the components of a circuit: its sampled controllers, and the plant with all other parts.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.

    Returns
    -------
    System
    """
    controllers = _sampled(circuit)
    rest = [name for name in circuit.parts if name not in controllers]
    groups = {name: [name] for name in controllers}
    if rest:
        plant = PLANT
        while plant in controllers:
            plant += "_"
        groups[plant] = rest
    part_of = {part: group for group, parts in groups.items() for part in parts}

    def group_of(address: str) -> str:
        return part_of[address.partition(".")[0]]

    between = {target: source for target, source in circuit.connections.items() if group_of(target) != group_of(source)}
    components = []
    for (group, parts), file in zip(groups.items(), identifiers(list(groups)), strict=True):
        partial = circuit
        if len(groups) > 1:
            inner = {t: s for t, s in circuit.connections.items() if group_of(t) == group and group_of(s) == group}
            signals = {address: signal for address, signal in circuit.signals.items() if group_of(address) == group}
            kept, run = {name: circuit.parts[name] for name in parts}, replace(circuit.run, stop_when=None)
            partial = BaseCircuit(kept, signals, run, circuit.ambient, circuit.gas, connections=inner, is_excerpt=True)
        inputs = [target for target in between if group_of(target) == group]
        if group in controllers:
            inputs = free_inputs(partial)
        outputs = dict.fromkeys(source for source in between.values() if group_of(source) == group)
        components.append(Component(group, f"resources/{file}.fmu", partial, tuple(inputs), tuple(outputs)))
    return System(tuple(components), between)


def describe_system(system: System, layouts: Mapping[str, FmuLayout], title: str) -> str:
    """Return the text of `SystemStructure.ssd`.

    `layouts` contains the layout of the FMU of each component by name.
    """
    # Other inputs follow a signal of the circuit, or have their start values.
    connectors = {}
    for name, layout in layouts.items():
        inputs = enumerate(layout.export_model.inputs)
        connected = {layout.input_reference(k) for k, item in inputs if item.address in system.connections}
        connectors[name] = [v for v in layout.variables if v.causality == "output" or v.reference in connected]
    units = sorted({v.unit for group in connectors.values() for v in group if base_unit(v.unit or "1")})
    elements = []
    for component in system.components:
        children = []
        for variable in connectors[component.name]:
            unit = {"unit": variable.unit} if base_unit(variable.unit or "1") else {}
            fields = {"name": variable.name, "kind": variable.causality}
            children.append(element("ssd:Connector", fields, [element("ssc:Real", unit, depth=6)], 5))
        attributes = {"name": component.name, "type": FMU_TYPE}
        attributes["source"] = component.file
        listed = [element("ssd:Connectors", {}, children, 4)] if children else []
        elements.append(element("ssd:Component", attributes, listed, 3))
    connections = []
    for target, source in system.connections.items():
        start, end = system.owner(source), system.owner(target)
        index = [item.address for item in layouts[end].export_model.inputs].index(target)
        reference = layouts[end].input_reference(index)
        attributes = {"startElement": start, "startConnector": layouts[start].output_variable(source).name}
        attributes |= {"endElement": end}
        attributes["endConnector"] = next(v.name for v in layouts[end].variables if v.reference == reference)
        connections.append(element("ssd:Connection", attributes, depth=3))
    body = [element("ssd:Elements", {}, elements, 2)]
    body += [element("ssd:Connections", {}, connections, 2)] if connections else []
    unit_elements = [
        element("ssc:Unit", {"name": u}, [element("ssc:BaseUnit", base_unit(u), depth=3)], 2) for u in units
    ]
    stop = max(float(layout.export_model.problem.grid[-1]) for layout in layouts.values())
    children = [
        element("ssd:System", {"name": "system"}, body, 1),
        *([element("ssd:Units", {}, unit_elements, 1)] if unit_elements else []),
        element("ssd:DefaultExperiment", {"startTime": "0.0", "stopTime": repr(stop)}, depth=1),
    ]
    head = {**NAMESPACES, "version": "1.0", "name": title, "generationTool": f"poppet {__version__}"}
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + element("ssd:SystemStructureDescription", head, children) + "\n"
