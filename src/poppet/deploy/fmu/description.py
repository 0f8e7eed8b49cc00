"""Texts of `modelDescription.xml` and `buildDescription.xml` of an FMU."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from xml.sax.saxutils import quoteattr

from poppet.core.units import unmarked_unit
from poppet.core.version import __version__
from poppet.deploy.fmu.fmu_layout import FOLLOWS_REFERENCE, FmuLayout

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
    "m^3/s ANR": "l/min ANR",
}
"""Display unit by SI unit."""


def element(name: str, attributes: Mapping[str, str], children: Sequence[str] = (), depth: int = 0) -> str:
    """Return an XML element with attributes and child elements as text.

    Special characters in attributes are escaped. `depth` is the level of indentation.
    """
    indent = "  " * depth
    text = "".join(f" {key}={quoteattr(_INVALID_IN_XML.sub('?', value))}" for key, value in attributes.items())
    if not children:
        return f"{indent}<{name}{text}/>"
    return "\n".join([f"{indent}<{name}{text}>", *children, f"{indent}</{name}>"])


def build_description(identifier: str, sources: Sequence[str]) -> str:
    """Return the text of `buildDescription.xml`, which lists the C sources of an FMU.

    FMI 3.0 defines this file.
    """
    files = [element("SourceFile", {"name": name}, depth=3) for name in sources]
    file_set = element("SourceFileSet", {"language": "C99"}, files, 2)
    build = element("BuildConfiguration", {"modelIdentifier": identifier}, [file_set], 1)
    return _XML_HEAD + element("fmiBuildDescription", {"fmiVersion": "3.0"}, [build]) + "\n"


def describe_model(layout: FmuLayout, fmi: int, token: str, identifier: str) -> str:
    """Return the text of `modelDescription.xml` of an FMU.

    `fmi` is the FMI version, 2 or 3. `token` is a text that identifies the content of the model (GUID).
    """
    problem, export_model = layout.export_model.problem, layout.export_model
    capabilities = {"modelIdentifier": identifier}
    steps = {"canHandleVariableCommunicationStepSize": "true"}
    head = {"fmiVersion": f"{fmi}.0", "modelName": " ".join(export_model.title.split()) or export_model.name}
    tool = {"generationTool": f"poppet {__version__}", "variableNamingConvention": "structured"}
    if fmi == 2:
        capabilities["canNotUseMemoryManagementFunctions"] = "false"
        capabilities |= {"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"}
        capabilities["providesDirectionalDerivative"] = "true"
        files = [element("File", {"name": name}, depth=3) for name in ("fmi2.c", "model.c")]
        sources = [element("SourceFiles", {}, files, 2)]
        completed, steps["canInterpolateInputs"] = {}, "true"
        head |= {"guid": token} | tool | {"numberOfEventIndicators": str(layout.n_indicators)}
    else:
        capabilities |= {"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
        capabilities["providesDirectionalDerivatives"] = "true"
        sources, has_conditions = [], bool(problem.stop_conditions)
        # Stop conditions are evaluated at the end of each step.
        completed = {"needsCompletedIntegratorStep": "true"} if has_conditions else {}
        steps["canReturnEarlyAfterIntermediateUpdate"] = "false"
        steps |= {"mightReturnEarlyFromDoStep": "true" if has_conditions else "false", "hasEventMode": "false"}
        head |= {"instantiationToken": token} | tool
    units = _unit_elements(layout)
    # The names of `LOG_CATEGORIES` in C.
    categories = ("logAll", "logStatusWarning", "logStatusDiscard", "logStatusError")
    experiment = {"startTime": "0", "stopTime": repr(float(problem.grid[-1]))}
    experiment["tolerance"] = repr(problem.relative_tolerance)
    elements = [
        element("ModelExchange", capabilities | completed, sources, 1),
        element("CoSimulation", capabilities | steps, sources, 1),
        *([element("UnitDefinitions", {}, units, 1)] if units else []),
        element("LogCategories", {}, [element("Category", {"name": name}, depth=2) for name in categories], 1),
        element("DefaultExperiment", experiment, depth=1),
        element("ModelVariables", {}, _variable_elements(layout, fmi), 1),
        element("ModelStructure", {}, _structure_elements(layout, fmi), 1),
    ]
    return _XML_HEAD + element("fmiModelDescription", head, elements) + "\n"


def _variable_elements(layout: FmuLayout, fmi: int) -> list[str]:
    """Return the XML elements of all variables of an FMU as texts."""
    nominals = {layout.state_reference(k): size for k, size in enumerate(nominal_sizes(layout))}
    index_of = {v.reference: k + 1 for k, v in enumerate(layout.variables)}
    elements = []
    for v in layout.variables:
        common = {"name": v.name, "valueReference": str(v.reference)}
        common |= {"description": v.meaning} if v.meaning else {}
        common |= {"causality": v.causality, "variability": v.variability}
        common |= {"initial": v.initial} if v.initial else {}
        if v.reference == FOLLOWS_REFERENCE:
            kind, attributes = "Boolean", {"start": "true" if v.start else "false"}
        else:
            kind, attributes = "Real" if fmi == 2 else "Float64", {} if v.unit in ("", "1") else {"unit": v.unit}
            # A difference of temperatures has no offset.
            is_difference = v.unit == "K" and not v.name.endswith("temperature")
            if v.unit in DISPLAY_UNITS and not is_difference and v.causality != "independent":
                attributes["displayUnit"] = DISPLAY_UNITS[v.unit]
            values = {"min": v.low, "max": v.high, "nominal": nominals.get(v.reference), "start": v.start}
            attributes |= {
                key: repr(float(value)) for key, value in values.items() if value is not None and math.isfinite(value)
            }
            if v.state >= 0:
                attributes["derivative"] = str(index_of[v.state] if fmi == 2 else v.state)
        if fmi == 2:
            elements.append(element("ScalarVariable", common, [element(kind, attributes, depth=3)], 2))
        else:
            elements.append(element(kind, common | attributes, depth=2))
    return elements


def _structure_elements(layout: FmuLayout, fmi: int) -> list[str]:
    """Return the XML elements that list outputs, derivatives and initial unknowns.

    Each entry lists the variables on which its quantity depends. FMI 2.0 refers to variables by their positions in the
    list of variables, and FMI 3.0 by their value references.
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
    groups = {"Output": outputs, "ContinuousStateDerivative": derivatives, "InitialUnknown": unknowns}
    if fmi == 3:
        return [
            element(name, {"valueReference": str(v.reference), "dependencies": _join_sorted(references)}, depth=2)
            for name, group in groups.items()
            for v, references in group
        ]
    index_of = {v.reference: k + 1 for k, v in enumerate(layout.variables)}
    elements = []
    for name, group in zip(("Outputs", "Derivatives", "InitialUnknowns"), groups.values(), strict=True):
        children = [
            element("Unknown", {"index": str(index), "dependencies": _join_sorted(dependencies)}, depth=3)
            for index, dependencies in sorted(
                (index_of[v.reference], [index_of[reference] for reference in references]) for v, references in group
            )
        ]
        elements += [element(name, {}, children, 2)] if children else []
    return elements


def _join_sorted(indices: Sequence[int]) -> str:
    return " ".join(map(str, sorted(indices)))


def nominal_sizes(layout: FmuLayout) -> list[float]:
    """Return the typical size of each state in SI units.

    The error control of the integrator uses the same sizes.
    """
    states, x = layout.export_model.model.states, layout.export_model.problem.x0
    return [abs(float(x[k])) if s.positive and x[k] else s.nominal for k, s in enumerate(states)]


def base_unit(name: str) -> dict[str, str]:
    """Return the attributes of the XML element `BaseUnit` of a unit.

    FMI and SSP have integer exponents only. The result is empty for a unit with another exponent.
    """
    unit = unmarked_unit(name)
    if any(exponent.denominator != 1 for exponent in unit.dimension):
        return {}
    base = {symbol: str(int(e)) for symbol, e in zip(BASE_UNITS, unit.dimension, strict=True) if e}
    return base | ({"factor": repr(float(unit.scale))} if base and unit.scale != 1 else {})


def _unit_elements(layout: FmuLayout) -> list[str]:
    """Return the XML definitions of all units that the variables use, as texts.

    A definition contains the exponents of the base units and the display unit.
    """
    elements = []
    for name in sorted({v.unit for v in layout.variables} - {"", "1"}):
        unit, base = unmarked_unit(name), base_unit(name)
        children = [element("BaseUnit", base, depth=3)] if base else []
        if name in DISPLAY_UNITS:
            display = unmarked_unit(DISPLAY_UNITS[name])
            attributes = {"name": DISPLAY_UNITS[name]}
            attributes |= {} if display.scale == unit.scale else {"factor": repr(float(unit.scale / display.scale))}
            attributes |= {"offset": repr(-float(display.offset))} if display.offset else {}
            children.append(element("DisplayUnit", attributes, depth=3))
        elements.append(element("Unit", {"name": name}, children, 2))
    return elements
