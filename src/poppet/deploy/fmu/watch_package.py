"""FMU of a watch for co-simulation: readings and inputs in, estimates and alarms out."""

from __future__ import annotations

import hashlib
import uuid
from collections.abc import Sequence
from importlib.resources import files
from typing import NamedTuple

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.version import __version__
from poppet.deploy.c.watch_project import watch_sources
from poppet.deploy.export_files import c_string, identifier
from poppet.deploy.exported_watch import WatchSource, check_watch
from poppet.deploy.fmu.binaries import PLATFORMS, link_commands, link_files
from poppet.deploy.fmu.description import base_unit, build_description, element
from poppet.deploy.fmu.fmu_layout import structured_name
from poppet.deploy.fmu.package import HEADERS, LICENSE, c_array, zip_bytes
from poppet.deploy.targets import Export

FIRST_REFERENCE = 2
KINDS = ("value", "sigma", "z", "alarm", "verdict", "nis")
"""Kinds of outputs, in the order of the constants in C."""


class WatchOutput(NamedTuple):
    """Output of the FMU of a watch."""

    name: str
    kind: str  # of `KINDS`
    number: int  # index of the free number, or 0
    unit: str
    meaning: str


class WatchPort(NamedTuple):
    """Input of the FMU of a watch."""

    name: str
    unit: str
    start: float
    meaning: str


def export_fmu_watch(
    watch: WatchSource, *, fmi: str = "2", platform: str | None = None, name: str | None = None
) -> Export:
    """Export the watch of a running plant as an FMU. The keyword arguments are options of the export target."""
    platforms = [entry.strip() for entry in (platform or "").split(",") if entry.strip()] or ["linux64"]
    check_watch(watch.plan)
    with ErrorCollector() as errors:
        for entry in platforms:
            if entry not in PLATFORMS:
                near = NameSuggestion(entry, PLATFORMS)
                errors.add("fields.not_an_option", "platform", value=entry, meaning="platform", suggestion=near)
    key, version = identifier(name or watch.title), int(fmi)
    inputs, outputs = ports_of(watch), outputs_of(watch)
    code = {**watch_sources(watch, key), **{f: _read("headers", f) for f in HEADERS[version]}}
    code |= {"core.h": _read("c", "watch_core.h"), "core.c": _read("c", "watch_core.c")}
    code[f"fmi{fmi}.c"] = _read("c", f"fmi{fmi}.c")
    # The GUID depends on the content of the model.
    texts = [ports_header(key, "", watch, inputs, outputs), *code.values()]
    token = f"{{{uuid.UUID(hashlib.sha256(chr(0).join(texts).encode()).hexdigest()[:32])}}}"
    code["ports.h"] = ports_header(key, token, watch, inputs, outputs)
    main = (f"fmi{fmi}.c", *(f for f in code if f.startswith(key) and f.endswith(".c")))
    content = {f"sources/{f}": text.encode() for f, text in code.items()}
    content["sources/LICENSE.txt"] = LICENSE.encode()
    if version == 3:
        content["sources/buildDescription.xml"] = build_description(key, main).encode()
    content["modelDescription.xml"] = description(watch, key, version, token, main, inputs, outputs).encode()
    linkable = [entry for entry in platforms if link_commands(entry)]
    for entry in linkable:
        folder = PLATFORMS[entry].folders[version - 2]
        content[f"binaries/{folder}/{key}{PLATFORMS[entry].suffix}"] = link_files(code, entry, main)
    notes = [Note("deploy.fmu.no_binary", platform=entry) for entry in platforms if entry not in linkable]
    summary = f"{len(inputs)} inputs, {len(outputs)} outputs; binaries: {', '.join(linkable) or 'none'}"
    return Export({f"{key}.fmu": zip_bytes(content)}, summary, notes)


def ports_of(watch: WatchSource) -> list[WatchPort]:
    """Return the inputs: the readings, then the driven inputs of the circuit."""
    plan = watch.plan
    constants = plan.instance.held_inputs({})
    readings = [
        WatchPort(f"measured.{structured_name(c.address)}", c.si_unit, 0.0, "reading; NaN if it is missing")
        for c in plan.channels
    ]
    return readings + [
        WatchPort(f"measured.{structured_name(i.address)}", i.si_unit, float(constants[i.index]), "input of the plant")
        for i in plan.inputs
    ]


def outputs_of(watch: WatchSource) -> list[WatchOutput]:
    """Return the outputs: estimates and alarms of the faults, estimates of the other free numbers, verdict and NIS."""
    plan, outputs = watch.plan, []
    for k, (name, unit) in enumerate(zip(plan.names, plan.units, strict=True)):
        is_fault = k < len(plan.faults)
        key = f"faults.{name}" if is_fault else f"nuisance.{structured_name(name)}"
        outputs += [
            WatchOutput(f"{key}.value", "value", k, unit, f"estimate of {name}"),
            WatchOutput(f"{key}.sigma", "sigma", k, unit, "its standard deviation"),
        ]
        if is_fault:
            outputs += [
                WatchOutput(f"{key}.z", "z", k, "1", "largest evidence for the fault, in standard deviations"),
                WatchOutput(f"{key}.alarm", "alarm", k, "1", "1 if the alarm names the fault, alone or with others"),
            ]
    verdict = "0 no information, 1 healthy, 2 nothing fits, 3 a fault, 4 one of several faults, 5 two faults"
    return [
        *outputs,
        WatchOutput("verdict", "verdict", 0, "1", verdict),
        WatchOutput("nis", "nis", 0, "1", "joint squared normalised innovation of the used readings"),
    ]


def _read(folder: str, name: str) -> str:
    return files("poppet.deploy.fmu").joinpath(folder, name).read_text(encoding="utf-8")


def ports_header(
    key: str, token: str, watch: WatchSource, inputs: Sequence[WatchPort], outputs: Sequence[WatchOutput]
) -> str:
    """Return the text of `ports.h`, which contains the constants of the interface."""
    n_readings = len(watch.plan.channels)
    lines = [
        "/* Interface of the watch; written by poppet. */",
        "#ifndef POPPET_PORTS_H\n#define POPPET_PORTS_H\n",
        f'#include "{key}.h"\n',
        f"#define WATCH(name) {key}_##name",
        f"#define MODEL_GUID {c_string(token)}",
        f"#define N_READINGS {n_readings}",
        f"#define N_DRIVEN {len(inputs) - n_readings}",
        f"#define N_OUTPUTS {len(outputs)}",
        f"enum {{ {', '.join(f'OUTPUT_{kind.upper()}' for kind in KINDS)} }};",
        c_array("double", "START_PORTS", [port.start for port in inputs]),
        c_array("unsigned char", "OUTPUT_KINDS", [KINDS.index(output.kind) for output in outputs]),
        c_array("int", "OUTPUT_NUMBERS", [output.number for output in outputs]),
        "\n#endif\n",
    ]
    return "\n".join(lines)


def description(
    watch: WatchSource, key: str, fmi: int, token: str, sources: Sequence[str], inputs: Sequence[WatchPort],
    outputs: Sequence[WatchOutput],
) -> str:  # fmt: skip
    """Return the text of `modelDescription.xml`."""
    head = {"fmiVersion": f"{fmi}.0", "modelName": " ".join(watch.title.split()) or key}
    head["guid" if fmi == 2 else "instantiationToken"] = token
    head |= {"generationTool": f"poppet {__version__}", "variableNamingConvention": "structured"}
    capabilities = {"modelIdentifier": key, "canHandleVariableCommunicationStepSize": "true"}
    capabilities |= dict.fromkeys(
        ("canGetAndSetFMUstate", "canSerializeFMUstate")
        if fmi == 2
        else ("canGetAndSetFMUState", "canSerializeFMUState"),
        "true",
    )
    listed = [element("File", {"name": name}, depth=3) for name in sources]
    units = [
        element("Unit", {"name": unit}, [element("BaseUnit", base_unit(unit), depth=3)] if base_unit(unit) else [], 2)
        for unit in sorted(({port.unit for port in inputs} | {output.unit for output in outputs}) - {"", "1"})
    ]
    variables, kind = [], "Real" if fmi == 2 else "Float64"
    time = {"name": "time", "valueReference": "0", "causality": "independent", "variability": "continuous"}
    rows: list[tuple[dict[str, str], dict[str, str]]] = [(time, {})]
    for k, port in enumerate(inputs):
        common = {"name": port.name, "valueReference": f"{FIRST_REFERENCE + k}", "description": port.meaning}
        common |= {"causality": "input", "variability": "continuous"}
        rows.append((common, {"start": repr(port.start)} | ({} if port.unit in ("", "1") else {"unit": port.unit})))
    for k, output in enumerate(outputs, FIRST_REFERENCE + len(inputs)):
        common = {"name": output.name, "valueReference": f"{k}", "description": output.meaning}
        common |= {"causality": "output", "variability": "continuous", "initial": "calculated"}
        rows.append((common, {} if output.unit in ("", "1") else {"unit": output.unit}))
    for common, values in rows:
        if fmi == 2:
            variables.append(element("ScalarVariable", common, [element(kind, values, depth=3)], 2))
        else:
            variables.append(element(kind, common | values, depth=2))
    first = 2 + len(inputs) if fmi == 2 else FIRST_REFERENCE + len(inputs)
    indices = [str(first + k) for k in range(len(outputs))]
    if fmi == 2:
        unknowns = [element("Unknown", {"index": k, "dependencies": ""}, depth=3) for k in indices]
        structure = [element(group, {}, unknowns, 2) for group in ("Outputs", "InitialUnknowns")]
    else:
        structure = [
            element(group, {"valueReference": k, "dependencies": ""}, depth=2)
            for group in ("Output", "InitialUnknown")
            for k in indices
        ]
    categories = ("logAll", "logStatusWarning", "logStatusDiscard", "logStatusError")
    elements = [
        element("CoSimulation", capabilities, [element("SourceFiles", {}, listed, 2)] if fmi == 2 else [], 1),
        *([element("UnitDefinitions", {}, units, 1)] if units else []),
        element("LogCategories", {}, [element("Category", {"name": name}, depth=2) for name in categories], 1),
        element("ModelVariables", {}, variables, 1),
        element("ModelStructure", {}, structure, 1),
    ]
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + element("fmiModelDescription", head, elements) + "\n"
