"""`modelDescription.xml` and `buildDescription.xml` of an FMU."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from xml.sax.saxutils import quoteattr

from poppet.core.version import __version__
from poppet.deploy.fmu.fmu_layout import FOLLOWS_REFERENCE, FmuLayout, Variable
from poppet.deploy.fmu.units import definitions, shown_unit

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'


def element(name: str, attributes: Mapping[str, str], inside: Sequence[str] = (), depth: int = 0) -> str:
    """An XML element; whatever a name or a title holds stays text."""
    pad = "  " * depth
    text = "".join(f" {key}={quoteattr(_NO_XML.sub('?', value))}" for key, value in attributes.items())
    if not inside:
        return f"{pad}<{name}{text}/>"
    return "\n".join([f"{pad}<{name}{text}>", *inside, f"{pad}</{name}>"])


def describe(plan: FmuLayout, fmi: int, token: str, identifier: str) -> str:
    """The model description for a version of FMI."""
    return _describe_2(plan, token, identifier) if fmi == 2 else _describe_3(plan, token, identifier)


def build_description(identifier: str, sources: Sequence[str]) -> str:
    """How the sources of an FMU of FMI 3.0 are compiled."""
    found = [element("SourceFile", {"name": name}, depth=3) for name in sources]
    inside = element("SourceFileSet", {"language": "C99"}, found, 2)
    build = element("BuildConfiguration", {"modelIdentifier": identifier}, [inside], 1)
    return _HEAD + element("fmiBuildDescription", {"fmiVersion": "3.0"}, [build]) + "\n"


def _experiment(plan: FmuLayout) -> dict[str, str]:
    run = plan.carried.problem
    return {"startTime": "0", "stopTime": repr(float(run.grid[-1])), "tolerance": repr(run.relative_tolerance)}


def _head(plan: FmuLayout, version: str, token: Mapping[str, str]) -> dict[str, str]:
    title = " ".join(plan.carried.title.split())
    head = {"fmiVersion": version, "modelName": title or plan.carried.name, **token}
    return head | {"generationTool": f"poppet {__version__}", "variableNamingConvention": "structured"}


def _number(value: float) -> str:
    return repr(float(value))


def _common(variable: Variable) -> dict[str, str]:
    found = {"name": variable.name, "valueReference": str(variable.reference)}
    if variable.meaning:
        found["description"] = variable.meaning
    found |= {"causality": variable.causality, "variability": variable.variability}
    return found | ({"initial": variable.initial} if variable.initial else {})


def _of_type(variable: Variable, nominals: Mapping[int, float]) -> dict[str, str]:
    """Unit, limits, nominal size and start of a real number."""
    found = {} if variable.unit in ("", "1") else {"unit": variable.unit}
    shown = shown_unit(variable.name, variable.unit)
    found |= {"displayUnit": shown} if shown and variable.causality != "independent" else {}
    if math.isfinite(variable.low):
        found["min"] = _number(variable.low)
    if math.isfinite(variable.high):
        found["max"] = _number(variable.high)
    if variable.reference in nominals:
        found["nominal"] = _number(nominals[variable.reference])
    return found | ({} if variable.start is None else {"start": _number(variable.start)})


def _nominals(plan: FmuLayout) -> dict[int, float]:
    sizes = nominal_sizes(plan)
    return {plan.state_reference(k): size for k, size in enumerate(sizes)}


def nominal_sizes(plan: FmuLayout) -> list[float]:
    """Size of each state, as the error control of the kernel has it."""
    states, x = plan.carried.model.states, plan.carried.problem.x0
    return [abs(float(x[k])) if s.positive and x[k] else s.nominal for k, s in enumerate(states)]


def _initial(plan: FmuLayout, calculated: Iterable[Variable]) -> list[tuple[Variable, list[int]]]:
    """Unknowns of the initialisation with what they need."""
    n, found = len(plan.carried.states), []
    by_name = {name: plan.initial_dependencies(name) for name in ("start", "rates", "outputs")}
    places = {plan.state_reference(k): ("start", k) for k in range(n)}
    places |= {plan.rate_reference(k): ("rates", k) for k in range(n)}
    for each in calculated:
        name, k = places.get(each.reference, ("outputs", each.reference - plan.output_reference(0)))
        found.append((each, by_name[name][k]))
    return found


def _structure(plan: FmuLayout) -> tuple[list[tuple[Variable, list[int]]], list[tuple[Variable, list[int]]]]:
    """Outputs and derivatives, each with what it needs."""
    by_state = {plan.state_reference(k): [plan.state_reference(k)] for k in range(len(plan.carried.states))}
    y, f = plan.dependencies("outputs"), plan.dependencies("rates")
    outputs = [
        (v, by_state.get(v.reference) or y[v.reference - plan.output_reference(0)])
        for v in plan.variables
        if v.causality == "output"
    ]
    return outputs, [(v, f[v.reference - plan.rate_reference(0)]) for v in plan.variables if v.state >= 0]


def _units(plan: FmuLayout) -> list[str]:
    found = []
    for name, base, shown in definitions(v.unit for v in plan.variables):
        inside = [element("BaseUnit", base, depth=3)] if base else []
        inside += [element("DisplayUnit", {"name": shown[0], **shown[1]}, depth=3)] if shown else []
        found.append(element("Unit", {"name": name}, inside, 2))
    return found


def _categories() -> str:
    """Those of `LOG_CATEGORIES` in C."""
    names = ("logAll", "logStatusWarning", "logStatusDiscard", "logStatusError")
    return element("LogCategories", {}, [element("Category", {"name": name}, depth=2) for name in names], 1)


def _describe_2(plan: FmuLayout, token: str, identifier: str) -> str:
    kind = {
        "modelIdentifier": identifier,
        "canNotUseMemoryManagementFunctions": "false",
        "canGetAndSetFMUstate": "true",
        "canSerializeFMUstate": "true",
        "providesDirectionalDerivative": "true",
    }
    sources = [
        element("SourceFiles", {}, [element("File", {"name": each}, depth=3) for each in ("fmi2.c", "model.c")], 2)
    ]
    nominals = _nominals(plan)
    places = {v.reference: k + 1 for k, v in enumerate(plan.variables)}
    variables = []
    for v in plan.variables:
        if v.reference == FOLLOWS_REFERENCE:
            inside = element("Boolean", {"start": "false"}, depth=3)
        else:
            of_type = _of_type(v, nominals)
            of_type |= {"derivative": str(places[v.state])} if v.state >= 0 else {}
            inside = element("Real", of_type, depth=3)
        variables.append(element("ScalarVariable", _common(v), [inside], 2))

    def unknowns(rows: Iterable[tuple[Variable, list[int]]]) -> list[str]:
        return [
            element(
                "Unknown",
                {
                    "index": str(places[v.reference]),
                    "dependencies": " ".join(str(places[r]) for r in sorted(needs, key=places.__getitem__)),
                },
                depth=3,
            )
            for v, needs in sorted(rows, key=lambda row: places[row[0].reference])
        ]

    outputs, rates = _structure(plan)
    calculated = [
        v for v in plan.variables if v.initial == "calculated" and (v.causality == "output" or _is_state(plan, v))
    ]
    structure = [
        element(name, {}, unknowns(rows), 2)
        for name, rows in (
            ("Outputs", outputs),
            ("Derivatives", rates),
            ("InitialUnknowns", _initial(plan, calculated)),
        )
        if rows
    ]
    head = _head(plan, "2.0", {"guid": token}) | {"numberOfEventIndicators": str(plan.n_indicators)}
    steps = {"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "true"}
    units = _units(plan)
    parts = [
        element("ModelExchange", kind, sources, 1),
        element("CoSimulation", kind | steps, sources, 1),
        *([element("UnitDefinitions", {}, units, 1)] if units else []),
        _categories(),
        element("DefaultExperiment", _experiment(plan), depth=1),
        element("ModelVariables", {}, variables, 1),
        element("ModelStructure", {}, structure, 1),
    ]
    return _HEAD + element("fmiModelDescription", head, parts) + "\n"


def _is_state(plan: FmuLayout, variable: Variable) -> bool:
    return plan.state_reference(0) <= variable.reference < plan.output_reference(0)


def _describe_3(plan: FmuLayout, token: str, identifier: str) -> str:
    kind = {
        "modelIdentifier": identifier,
        "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
        "providesDirectionalDerivatives": "true",
    }
    nominals, variables = _nominals(plan), []
    for v in plan.variables:
        if v.reference == FOLLOWS_REFERENCE:
            variables.append(element("Boolean", _common(v) | {"start": "false"}, depth=2))
        else:
            more = {"derivative": str(v.state)} if v.state >= 0 else {}
            variables.append(element("Float64", _common(v) | _of_type(v, nominals) | more, depth=2))
    outputs, rates = _structure(plan)
    calculated = [
        v for v in plan.variables if v.initial == "calculated" and (v.causality == "output" or _is_state(plan, v))
    ]
    structure = [
        element(name, {"valueReference": str(v.reference), "dependencies": " ".join(map(str, sorted(needs)))}, depth=2)
        for name, rows in (
            ("Output", outputs),
            ("ContinuousStateDerivative", rates),
            ("InitialUnknown", _initial(plan, calculated)),
        )
        for v, needs in rows
    ]
    units = _units(plan)
    ends = bool(plan.carried.problem.stop_conditions)
    steps = {
        "canHandleVariableCommunicationStepSize": "true",
        "canReturnEarlyAfterIntermediateUpdate": "false",
        "mightReturnEarlyFromDoStep": "true" if ends else "false",
        "hasEventMode": "false",
    }
    parts = [
        # Stop conditions are looked for where a step has ended.
        element("ModelExchange", kind | ({"needsCompletedIntegratorStep": "true"} if ends else {}), depth=1),
        element("CoSimulation", kind | steps, depth=1),
        *([element("UnitDefinitions", {}, units, 1)] if units else []),
        _categories(),
        element("DefaultExperiment", _experiment(plan), depth=1),
        element("ModelVariables", {}, variables, 1),
        element("ModelStructure", {}, structure, 1),
    ]
    return _HEAD + element("fmiModelDescription", _head(plan, "3.0", {"instantiationToken": token}), parts) + "\n"
