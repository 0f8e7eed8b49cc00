"""FMU of a circuit as a reproducible archive.

The archive contains the model description, C sources, binaries and the circuit file.
"""

from __future__ import annotations

import hashlib
import io
import math
import uuid
import zipfile
from collections.abc import Collection, Iterable, Mapping, Sequence
from importlib.resources import files
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.deploy.c.c_model import DIRECTIONAL, integrator_code, model_code, prototypes
from poppet.deploy.controller import circuit_of_controllers, controllers_of_option, select_controllers
from poppet.deploy.export_files import c_string
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.deploy.fmu.binaries import PLATFORMS, kernel_code, link_commands, link_library
from poppet.deploy.fmu.description import build_description, describe_model, nominal_sizes
from poppet.deploy.fmu.fmu_layout import PORT, FmuLayout, build_layout
from poppet.deploy.fmu.importers import circuit_resources
from poppet.deploy.targets import CircuitSource, Export
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.job import Job
from poppet.engine.printers.c import print_function
from poppet.engine.rosenbrock import scratch_size

if TYPE_CHECKING:
    import casadi

    from poppet.circuit.circuit import BaseCircuit
    from poppet.engine.model import Model

PER_LINE = 6
JOB_FUNCTIONS = ("jacobian", "step", "dense", "outputs", "update")
ZIP_TIME = (1980, 1, 1, 0, 0, 0)
HEADERS = {
    2: ("fmi2FunctionTypes.h", "fmi2Functions.h", "fmi2TypesPlatform.h"),
    3: ("fmi3FunctionTypes.h", "fmi3Functions.h", "fmi3PlatformTypes.h"),
}
C_END = "#ifdef __cplusplus\n}\n#endif\n"


class Fmu(NamedTuple):
    """FMU before it is written: layout, contents of its files, platforms and notes."""

    layout: FmuLayout
    content: dict[str, bytes]  # path in the archive to bytes
    platforms: tuple[str, ...]  # with a binary
    notes: tuple[Note, ...] = ()


def directional_derivatives(model: Model) -> casadi.Function:
    """Return a CasADi function for directional derivatives of rates and outputs.

    Its arguments are t, x, u and p, then the changes of x, u and p.
    """
    import casadi as ca

    s, e = model.symbols, model.expressions
    names = ("t", "x", "u", "p")
    directions = [ca.SX.sym(f"d{name}", s[name].shape[0]) for name in names[1:]]
    derivatives = []
    for expression in (e["rates"], e["outputs"]):
        derivative = ca.SX.zeros(expression.shape[0])
        for name, direction in zip(names[1:], directions, strict=True):
            if s[name].shape[0]:
                derivative += ca.jtimes(expression, s[name], direction)
        derivatives.append(ca.densify(derivative))
    return ca.Function("directional", [*(s[name] for name in names), *directions], ca.cse(derivatives))


def export_fmu(
    circuit: BaseCircuit, source: CircuitSource, *, fmi: str = "2", platform: str | None = None,
    inputs: Sequence[str] = (), name: str | None = None, part: str | None = None,
) -> Export:  # fmt: skip
    """Export a circuit or its sampled controllers as an FMU.

    The keyword arguments are the options of `poppet export fmu`.
    """
    platforms = [entry.strip() for entry in (platform or "").split(",") if entry.strip()] or ["linux64"]
    resources, exposed = circuit_resources(source.text, source.changes, source.result), []
    if part:
        # The FMU of a controller is not compared with a whole circuit.
        selected, resources = select_controllers(circuit, controllers_of_option(circuit, part)), {}
        circuit = circuit_of_controllers(circuit, selected, with_signals=True)
        name, inputs = name or "_".join(selected), [*dict.fromkeys([*free_inputs(circuit), *inputs])]
        exposed = [address for address, _ in circuit.model.outputs if address not in circuit.inputs]
    fmu = build_fmu(
        circuit, name or "", fmi=int(fmi), inputs=inputs, platforms=platforms, resources=resources, exposed=exposed
    )
    names = {
        kind: [v.name for v in fmu.layout.variables if v.causality == kind] for kind in ("input", "parameter", "output")
    }
    counts = ", ".join(f"{len(group)} {kind}{'s' * (len(group) != 1)}" for kind, group in names.items())
    summary = f"{counts}; binaries: {', '.join(fmu.platforms) or 'none'}"
    if names["input"]:
        summary += f"\ninputs: {', '.join(names['input'])}"
    return Export({f"{fmu.layout.export_model.name}.fmu": zip_bytes(fmu.content)}, summary, fmu.notes)


def free_inputs(circuit: BaseCircuit) -> list[str]:
    """Return the addresses of the inputs of a circuit that have neither a signal nor a connection."""
    taken = {*circuit.signals, *circuit.connections}
    return [address for address, item in circuit.inputs.items() if address not in taken and not item.slope_of]


def build_fmu(
    circuit: BaseCircuit, name: str = "", *, fmi: int = 2, platforms: Sequence[str] = ("linux64",),
    inputs: Sequence[str] = (), resources: Mapping[str, bytes] | None = None, exposed: Collection[str] = (),
    follows_signals: bool = False, starts: Mapping[str, float] | None = None,
) -> Fmu:  # fmt: skip
    """Return the FMU of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.
    name : str, optional
        Name of the model (default: title of the circuit).
    fmi : int, optional
        Version of FMI: 2 or 3.
    platforms : sequence of str, optional
        Platforms of the binaries: `linux64`, `win64`, `darwin64`, `aarch64-darwin`.
    inputs : sequence of str, optional
        Addresses of inputs and parameters that the importer sets, in addition to the inputs with signals.
    resources : mapping of str to bytes, optional
        Further files by their paths in the FMU.
    exposed : collection of str, optional
        Addresses of internal outputs that are outputs of the FMU.
    follows_signals : bool, optional
        Start value of the parameter `follow_signals`.
    starts : mapping of str to float, optional
        Start values of inputs by address (default: those of the circuit).

    Returns
    -------
    Fmu
        FMU, with a note for each platform that has no available compiler.

    Raises
    ------
    InputErrors
        If a platform or an input is unknown, or if the circuit cannot be exported.
    """
    with ErrorCollector() as errors:
        for platform in platforms:
            if platform not in PLATFORMS:
                near = NameSuggestion(platform, PLATFORMS)
                errors.add("fields.not_an_option", "platform", value=platform, meaning="platform", suggestion=near)
    layout = build_layout(
        build_export_model(circuit, name), inputs, exposed, follows_signals=follows_signals, starts=starts
    )
    export_model = layout.export_model
    identifier, derivatives = export_model.name, directional_derivatives(export_model.model)
    unused = ("energy",) if export_model.model.size else ("energy", "jacobian", "factor", "solve")
    printed = {name: f for name, f in export_model.functions.items() if name not in unused} | {
        "directional": derivatives
    }
    kernel = kernel_code(export_model.model, printed)
    functions = [*printed, *(("step", "dense") if export_model.model.size else ())]
    sources = {file: _read("c", file) for file in ("core.h", "core.c", f"fmi{fmi}.c")}
    sources |= {file: _read("headers", file) for file in HEADERS[fmi]}
    sources["names.h"] = names_header(functions, fmi)
    # The GUID depends on the content of the model.
    texts = (model_header(layout, functions, ""), kernel, *sources.values(), INTEGRATOR.read())
    token = f"{{{uuid.UUID(hashlib.sha256(chr(0).join(texts).encode()).hexdigest()[:32])}}}"
    sources["model.h"] = model_header(layout, functions, token)
    content = {**(resources or {}), "modelDescription.xml": describe_model(layout, fmi, token, identifier).encode()}
    content |= {f"sources/{file}": text.encode() for file, text in sources.items()}
    content["sources/model.c"] = model_source(export_model, derivatives).encode()
    content["sources/LICENSE.txt"] = LICENSE.encode()
    if fmi == 3:
        build = build_description(identifier, (f"fmi{fmi}.c", "model.c"))
        content["sources/buildDescription.xml"] = build.encode()
    linkable = tuple(platform for platform in platforms if link_commands(platform))
    for platform in linkable:
        folders, suffix = PLATFORMS[platform].folders, PLATFORMS[platform].suffix
        library = link_library(kernel, sources, platform, f"fmi{fmi}.c")
        content[f"binaries/{folders[fmi - 2]}/{identifier}{suffix}"] = library
    notes = [Note("deploy.fmu.no_binary", platform=platform) for platform in platforms if platform not in linkable]
    # The importer sets inputs without delay.
    delayed = [i for i in export_model.model.inputs if i.delay and export_model.instance.parameters[i.delay]]
    notes += [Note("deploy.fmu.no_delay", item.name, delay=item.delay) for item in delayed]
    return Fmu(layout, content, linkable, tuple(notes))


LICENSE = """The files fmi2*.h and fmi3*.h are licensed by the Modelica Association Project FMI under the 2-Clause BSD
License, whose text stands in them. All other sources were written by poppet, and are licensed with it.
"""


def model_source(export_model: ExportModel, derivatives: casadi.Function) -> str:
    """Return the C source of the model functions and of the integrator.

    Importers can compile it if the FMU has no binary for them. `derivatives` is the function of directional
    derivatives.
    """
    directional = print_function(derivatives, "directional", DIRECTIONAL, prefix="model_")
    head = "/* The model and the integrator; written by poppet. */\n#include <math.h>\n#include <stdint.h>\n\n"
    head += '#include "names.h"\n\n#ifdef __cplusplus\nextern "C" {\n#endif\n'
    return "\n\n".join(
        [head, model_code(export_model, "model_", [directional]), integrator_code("model_integrate"), C_END]
    )


def _read(folder: str, name: str) -> str:
    return files("poppet.deploy.fmu").joinpath(folder, name).read_text(encoding="utf-8")


def c_literal(value: float) -> str:
    """Return a floating-point number as a literal of C90 with all digits."""
    if math.isinf(value):
        return "-HUGE_VAL" if value < 0.0 else "HUGE_VAL"
    return repr(float(value))


def c_array(kind: str, name: str, values: Iterable[Any]) -> str:
    """Return the C definition of a constant array.

    `kind` is the C type of the elements. An empty array gets one element, because C has no empty arrays.
    """
    texts = [c_literal(v) if kind == "double" else str(int(v)) for v in values] or ["0"]
    lines = [", ".join(texts[k : k + PER_LINE]) for k in range(0, len(texts), PER_LINE)]
    return f"static const {kind} {name}[{len(texts)}] = {{\n  " + ",\n  ".join(lines) + "\n};"


def names_header(functions: Sequence[str], fmi: int) -> str:
    """Return the text of `names.h`, whose macros add a prefix to function names.

    With these macros, several FMUs can be linked together. `fmi` is the FMI version, 2 or 3.
    """
    prefix = f"FMI{fmi}_FUNCTION_PREFIX"
    lines = [
        "/* Names of the model where FMUs are linked together; written by poppet. */",
        "#ifndef POPPET_NAMES_H\n#define POPPET_NAMES_H\n",
        f"#ifdef {prefix}",
        "#define POPPET_JOIN(a, b) a##b\n#define POPPET_NAME(a, b) POPPET_JOIN(a, b)",
        *(f"#define model_{name} POPPET_NAME({prefix}, model_{name})" for name in (*functions, "energy", "integrate")),
        "#endif\n\n#endif\n",
    ]
    return "\n".join(lines)


def model_header(layout: FmuLayout, functions: Sequence[str], token: str) -> str:
    """Return the text of the C header `model.h`, which contains all constants of the FMU.

    `functions` are the names of the model functions. `token` is a text that identifies the content of the model (GUID).
    """
    export_model, problem = layout.export_model, layout.export_model.problem
    model, kernel = export_model.model, export_model.instance.kernel
    sizes = {
        "N_STATES": len(model.states),
        "N_ALL": model.size,
        "N_INPUTS": len(model.inputs),
        "N_NUMBERS": len(model.parameters),
        "N_MEMORY": len(model.memory),
        "N_TIMERS": model.n_timers,
        "N_OUTPUTS": len(model.outputs),
        "N_INDICATORS": layout.n_indicators,
        "N_JACOBIAN": kernel.jacobian_size,
        "N_STEP_SCRATCH": scratch_size(model.size, kernel.factor_size),
        "N_SCRATCH": kernel.memory_size,
        "N_CONDITIONS": len(problem.stop_conditions),
        "N_SEGMENTS": problem.starts.size,
        "N_GUIDED": len(layout.initial_inputs),
        "JOB_SIZE": len(Job._fields),
    }
    sizes |= {f"JOB_{name}": k for k, name in enumerate(Job._fields)}
    start = [0.0 if info.slope_of and source >= PORT else layout.starts.get(item.address, item.value)
             for item, info, source in zip(export_model.inputs, model.inputs, layout.sources, strict=True)]  # fmt: skip
    conditions = problem.stop_conditions
    # The text of a condition, or the stroke that leaves its domain.
    reasons = [condition.reason for condition in conditions]
    texts = [c_string(str(r.facts.get("condition", f"{r.address} leaves its domain"))) for r in reasons] or ['""']
    # Variables for parameters and inputs, in the order of their value references; an empty name means none.
    names = {v.reference: v.name for v in layout.variables}
    references = range(layout.parameter_reference(0), layout.state_reference(0))
    variables = ",\n  ".join(c_string(names.get(reference, "")) for reference in references) or '""'
    lines = [
        "/* Constants of the model; written by poppet. */",
        "#ifndef POPPET_MODEL_H\n#define POPPET_MODEL_H\n",
        "#include <math.h>\n#include <stdint.h>\n",
        '#include "names.h"\n',
        f"#define MODEL_GUID {c_string(token)}",
        *(f"#define {name} {value}" for name, value in sizes.items()),
        f"#define START_FOLLOWS {float(layout.follows_signals)}",
        f"#define TOLERANCE {c_literal(problem.relative_tolerance)}",
        f"#define LONGEST_STEP {c_literal(problem.maximum_step)}",
        f"#define MOST_ATTEMPTS {c_literal(problem.most_attempts)}\n",
        c_array("double", "START_P", problem.p),
        c_array("double", "START_U", start),
        c_array("unsigned char", "NUMBER_ROLE", layout.roles),
        c_array("double", "NUMBER_LOW", (parameter.low for parameter in export_model.parameters)),
        c_array("double", "NUMBER_HIGH", (parameter.high for parameter in export_model.parameters)),
        c_array("unsigned char", "INPUT_SOURCE", layout.sources),
        c_array("int", "INPUT_NUMBER", (item.parameter for item in export_model.inputs)),
        c_array("double", "INPUT_LOW", (item.low for item in export_model.inputs)),
        c_array("double", "INPUT_HIGH", (item.high for item in export_model.inputs)),
        c_array("int", "GUIDED_NUMBER", (parameter for parameter, _ in layout.initial_inputs)),
        c_array("int", "GUIDED_INPUT", (item for _, item in layout.initial_inputs)),
        c_array("double", "SEGMENT_STARTS", problem.starts),
        c_array("int", "SEGMENT_COURSES", problem.courses),
        c_array("unsigned char", "SEGMENT_JUMPS", problem.jumps),
        c_array("double", "COURSES", problem.coefficients.ravel()),
        c_array("int", "STATE_NUMBER", (layout.initial_parameters.get(k, -1) for k in range(len(model.states)))),
        c_array("double", "STATE_SCALES", kernel.scales.ravel()),
        c_array("double", "STATE_NOMINALS", nominal_sizes(layout)),
        c_array("unsigned char", "STATE_POSITIVE", kernel.positive),
        c_array("unsigned char", "MEMORY_ACTING", kernel.acting),
        c_array("int64_t", "CONDITION_PLACES", (p for c in conditions for p in c.places)),
        c_array("double", "CONDITION_WEIGHTS", (w for c in conditions for w in c.weights)),
        f"static const char *const VARIABLE_NAMES[] = {{\n  {variables}\n}};",
        f"static const char *const CONDITION_TEXTS[] = {{{', '.join(texts)}}};\n",
        '#ifdef __cplusplus\nextern "C" {\n#endif',
        *prototypes(functions, "model_"),
        "int64_t model_integrate(const int64_t *job);",
        "#ifdef __cplusplus\n}\n#endif\n",
        "static void model_functions(int64_t *job) {",
        *(f"  job[JOB_{name}] = (int64_t)(intptr_t)model_{name};" for name in JOB_FUNCTIONS if name in functions),
        "  (void)job;\n}\n\n#endif\n",
    ]
    return "\n".join(lines)


def zip_bytes(content: Mapping[str, bytes]) -> bytes:
    """Return a ZIP archive with given files as bytes.

    `content` maps paths to contents. Equal contents give equal bytes.
    """
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in sorted(content, key=lambda path: (path != "modelDescription.xml", path)):
            info = zipfile.ZipInfo(path, ZIP_TIME)
            info.compress_type, info.create_system, info.external_attr = zipfile.ZIP_DEFLATED, 3, 0o644 << 16
            archive.writestr(info, content[path])
    return buffer.getvalue()
