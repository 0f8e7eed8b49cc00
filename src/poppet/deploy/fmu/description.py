"""Texts of `modelDescription.xml` and `buildDescription.xml` of an FMU."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from xml.sax.saxutils import quoteattr

from poppet.core.unit_table import read_unit
from poppet.core.version import __version__
from poppet.deploy.fmu.fmu_layout import FOLLOWS_REFERENCE, FmuLayout, Variable

_INVALID_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_XML_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
BASE_UNITS = ("m", "kg", "s", "K", "A", "rad")
DISPLAY_UNITS = {
    "Pa": "bar",
    "K": "degC",
    "m": "mm",
    "m^3": "l",
    "kg": "g",
    "kg/s": "g/s",
    "m^3/(s Pa)": "l/(s bar)",
    "rad": "deg",
    "m^2": "mm^2",
}
"""Display unit by SI unit."""


def element(name: str, attributes: Mapping[str, str], children: Sequence[str] = (), depth: int = 0) -> str:
    """Return an XML element with its attributes and child elements.

    Special characters in attributes are escaped. `depth` is the level of indentation.
    """
    indent = "  " * depth
    text = "".join(f" {key}={quoteattr(_INVALID_IN_XML.sub('?', value))}" for key, value in attributes.items())
    if not children:
        return f"{indent}<{name}{text}/>"
    return "\n".join([f"{indent}<{name}{text}>", *children, f"{indent}</{name}>"])


def build_description(identifier: str, sources: Sequence[str]) -> str:
    """Return the text of `buildDescription.xml`, which lists the C sources of an FMU (FMI 3.0)."""
    files = [element("SourceFile", {"name": name}, depth=3) for name in sources]
    file_set = element("SourceFileSet", {"language": "C99"}, files, 2)
    build = element("BuildConfiguration", {"modelIdentifier": identifier}, [file_set], 1)
    return _XML_HEAD + element("fmiBuildDescription", {"fmiVersion": "3.0"}, [build]) + "\n"


def describe_model(layout: FmuLayout, fmi: int, token: str, identifier: str) -> str:
    """Return the text of `modelDescription.xml` for FMI version 2 or 3.

    `token` identifies the content of the model: it is the GUID of the FMU.
    """
    return _describe_2(layout, token, identifier) if fmi == 2 else _describe_3(layout, token, identifier)


def _describe_2(layout: FmuLayout, token: str, identifier: str) -> str:
    capabilities = {
        "modelIdentifier": identifier,
        "canNotUseMemoryManagementFunctions": "false",
        "canGetAndSetFMUstate": "true",
        "canSerializeFMUstate": "true",
        "providesDirectionalDerivative": "true",
    }
    files = [element("File", {"name": name}, depth=3) for name in ("fmi2.c", "model.c")]
    sources = [element("SourceFiles", {}, files, 2)]
    nominals = _nominal_by_reference(layout)
    index_of = {v.reference: k + 1 for k, v in enumerate(layout.variables)}
    variables = []
    for v in layout.variables:
        if v.reference == FOLLOWS_REFERENCE:
            kind = element("Boolean", {"start": "false"}, depth=3)
        else:
            derivative = {"derivative": str(index_of[v.state])} if v.state >= 0 else {}
            kind = element("Real", _real_attributes(v, nominals) | derivative, depth=3)
        variables.append(element("ScalarVariable", _common_attributes(v), [kind], 2))
    structure = []
    for name, rows in zip(("Outputs", "Derivatives", "InitialUnknowns"), _dependency_rows(layout), strict=True):
        unknowns = []
        for v, references in sorted(rows, key=lambda row: index_of[row[0].reference]):
            dependencies = " ".join(str(index) for index in sorted(index_of[r] for r in references))
            attributes = {"index": str(index_of[v.reference]), "dependencies": dependencies}
            unknowns.append(element("Unknown", attributes, depth=3))
        structure += [element(name, {}, unknowns, 2)] if unknowns else []
    steps = {"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "true"}
    modes = [
        element("ModelExchange", capabilities, sources, 1),
        element("CoSimulation", capabilities | steps, sources, 1),
    ]
    head = {"guid": token, "numberOfEventIndicators": str(layout.n_indicators)}
    return _description(layout, "2.0", head, modes, variables, structure)


def _describe_3(layout: FmuLayout, token: str, identifier: str) -> str:
    capabilities = {
        "modelIdentifier": identifier,
        "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
        "providesDirectionalDerivatives": "true",
    }
    nominals, variables = _nominal_by_reference(layout), []
    for v in layout.variables:
        if v.reference == FOLLOWS_REFERENCE:
            variables.append(element("Boolean", _common_attributes(v) | {"start": "false"}, depth=2))
        else:
            derivative = {"derivative": str(v.state)} if v.state >= 0 else {}
            attributes = _common_attributes(v) | _real_attributes(v, nominals) | derivative
            variables.append(element("Float64", attributes, depth=2))
    names = ("Output", "ContinuousStateDerivative", "InitialUnknown")
    structure = [
        element(
            name,
            {"valueReference": str(v.reference), "dependencies": " ".join(map(str, sorted(references)))},
            depth=2,
        )
        for name, rows in zip(names, _dependency_rows(layout), strict=True)
        for v, references in rows
    ]
    has_conditions = bool(layout.export_model.problem.stop_conditions)
    steps = {
        "canHandleVariableCommunicationStepSize": "true",
        "canReturnEarlyAfterIntermediateUpdate": "false",
        "mightReturnEarlyFromDoStep": "true" if has_conditions else "false",
        "hasEventMode": "false",
    }
    # Stop conditions are evaluated at the end of each step.
    completed = {"needsCompletedIntegratorStep": "true"} if has_conditions else {}
    modes = [
        element("ModelExchange", capabilities | completed, depth=1),
        element("CoSimulation", capabilities | steps, depth=1),
    ]
    return _description(layout, "3.0", {"instantiationToken": token}, modes, variables, structure)


def _description(
    layout: FmuLayout, version: str, head: Mapping[str, str], modes: list[str], variables: list[str],
    structure: list[str],
) -> str:  # fmt: skip
    """Return the complete XML text of a model description.

    The order of the elements is common to both versions of FMI.
    """
    export_model = layout.export_model
    problem, title = export_model.problem, " ".join(export_model.title.split())
    token = {key: value for key, value in head.items() if key != "numberOfEventIndicators"}
    attributes = {
        "fmiVersion": version, "modelName": title or export_model.name, **token,
        "generationTool": f"poppet {__version__}", "variableNamingConvention": "structured", **head,
    }  # fmt: skip
    units = _unit_elements(layout)
    # The names of `LOG_CATEGORIES` in C.
    categories = ("logAll", "logStatusWarning", "logStatusDiscard", "logStatusError")
    experiment = {"startTime": "0", "stopTime": repr(float(problem.grid[-1]))}
    experiment["tolerance"] = repr(problem.relative_tolerance)
    elements = [
        *modes,
        *([element("UnitDefinitions", {}, units, 1)] if units else []),
        element("LogCategories", {}, [element("Category", {"name": name}, depth=2) for name in categories], 1),
        element("DefaultExperiment", experiment, depth=1),
        element("ModelVariables", {}, variables, 1),
        element("ModelStructure", {}, structure, 1),
    ]
    return _XML_HEAD + element("fmiModelDescription", attributes, elements) + "\n"


def _common_attributes(variable: Variable) -> dict[str, str]:
    attributes = {"name": variable.name, "valueReference": str(variable.reference)}
    if variable.meaning:
        attributes["description"] = variable.meaning
    attributes |= {"causality": variable.causality, "variability": variable.variability}
    return attributes | ({"initial": variable.initial} if variable.initial else {})


def _real_attributes(variable: Variable, nominals: Mapping[int, float]) -> dict[str, str]:
    """Return unit, limits, nominal value and start value of a real variable."""
    attributes = {} if variable.unit in ("", "1") else {"unit": variable.unit}
    # A difference of temperatures has no offset.
    is_difference = variable.unit == "K" and not variable.name.endswith("temperature")
    if variable.unit in DISPLAY_UNITS and not is_difference and variable.causality != "independent":
        attributes["displayUnit"] = DISPLAY_UNITS[variable.unit]
    values = {
        "min": variable.low if math.isfinite(variable.low) else None,
        "max": variable.high if math.isfinite(variable.high) else None,
        "nominal": nominals.get(variable.reference),
        "start": variable.start,
    }
    return attributes | {key: repr(float(value)) for key, value in values.items() if value is not None}


def nominal_sizes(layout: FmuLayout) -> list[float]:
    """Return the size of each state for the error control, as the kernel uses it [SI]."""
    states, x = layout.export_model.model.states, layout.export_model.problem.x0
    return [abs(float(x[k])) if s.positive and x[k] else s.nominal for k, s in enumerate(states)]


def _nominal_by_reference(layout: FmuLayout) -> dict[int, float]:
    return {layout.state_reference(k): size for k, size in enumerate(nominal_sizes(layout))}


def _dependency_rows(layout: FmuLayout) -> list[list[tuple[Variable, list[int]]]]:
    """Return the outputs, the derivatives and the initial unknowns of the model structure, in three lists.

    Each entry is a variable and the value references of the variables on which it depends.
    """
    n, first_output = len(layout.export_model.states), layout.output_reference(0)
    by_state = {layout.state_reference(k): [layout.state_reference(k)] for k in range(n)}
    of_outputs, of_rates = layout.dependencies("outputs"), layout.dependencies("rates")
    outputs = [
        (v, by_state.get(v.reference) or of_outputs[v.reference - first_output])
        for v in layout.variables
        if v.causality == "output"
    ]
    derivatives = [(v, of_rates[v.reference - layout.rate_reference(0)]) for v in layout.variables if v.state >= 0]
    initial = {name: layout.initial_dependencies(name) for name in ("start", "rates", "outputs")}
    rows = {layout.state_reference(k): ("start", k) for k in range(n)}
    rows |= {layout.rate_reference(k): ("rates", k) for k in range(n)}
    unknowns = []
    for v in layout.variables:
        is_state = layout.state_reference(0) <= v.reference < first_output
        if v.initial == "calculated" and (v.causality == "output" or is_state):
            name, k = rows.get(v.reference, ("outputs", v.reference - first_output))
            unknowns.append((v, initial[name][k]))
    return [outputs, derivatives, unknowns]


def _unit_elements(layout: FmuLayout) -> list[str]:
    """Return the XML definitions of all units that the variables use.

    A definition contains the exponents of the base units and the display unit.
    """
    elements = []
    for name in sorted({v.unit for v in layout.variables} - {"", "1"}):
        unit = read_unit(name)
        base = {symbol: str(int(e)) for symbol, e in zip(BASE_UNITS, unit.dimension, strict=True) if e}
        # FMI has integer exponents only; any other unit has only a name.
        base = {} if any(e.denominator != 1 for e in unit.dimension) else base
        if base and unit.scale != 1:
            base["factor"] = repr(float(unit.scale))
        children = [element("BaseUnit", base, depth=3)] if base else []
        if name in DISPLAY_UNITS:
            display = read_unit(DISPLAY_UNITS[name])
            attributes = {"name": DISPLAY_UNITS[name]}
            attributes |= {} if display.scale == unit.scale else {"factor": repr(float(unit.scale / display.scale))}
            attributes |= {"offset": repr(-float(display.offset))} if display.offset else {}
            children.append(element("DisplayUnit", attributes, depth=3))
        elements.append(element("Unit", {"name": name}, children, 2))
    return elements
