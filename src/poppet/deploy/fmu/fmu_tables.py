"""C headers `model.h` and `names.h` of an FMU.

They contain array sizes, parameters, signals and limits as constants.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from poppet.deploy.export_files import c_string
from poppet.deploy.fmu.description import nominal_sizes
from poppet.deploy.fmu.fmu_layout import PORT, FmuLayout
from poppet.engine.job import Job
from poppet.engine.printers.instructions import SIGNATURES
from poppet.engine.problem import StopCondition
from poppet.engine.rosenbrock import scratch_size

PER_LINE = 6
JOB_FUNCTIONS = ("jacobian", "step", "dense", "outputs", "update")
DIRECTIONAL = "t x u p dx du dp -> df dy"


def literal(value: float) -> str:
    """Return a number as a C90 literal with all digits."""
    if math.isinf(value):
        return "-HUGE_VAL" if value < 0.0 else "HUGE_VAL"
    return repr(float(value))


def array(kind: str, name: str, values: Iterable[Any]) -> str:
    """Return the definition of a constant C array with elements of type `kind`.

    An empty array gets one element, because C has no empty arrays.
    """
    texts = [literal(v) if kind == "double" else str(int(v)) for v in values] or ["0"]
    lines = [", ".join(texts[k : k + PER_LINE]) for k in range(0, len(texts), PER_LINE)]
    return f"static const {kind} {name}[{len(texts)}] = {{\n  " + ",\n  ".join(lines) + "\n};"


def prototypes(functions: Sequence[str]) -> list[str]:
    """Return the C prototypes of the named model functions."""
    signatures = {**SIGNATURES, "directional": DIRECTIONAL}
    signatures |= {"step": "th x us p rates J drift scratch -> stages x1", "dense": "stages -> coefficients"}
    lines = []
    for name in functions:
        inputs, outputs = (side.split() for side in signatures[name].split("->"))
        arguments = [*(f"const double *{a}" for a in inputs), *(f"double *{a}" for a in outputs)]
        if name == "step":  # it writes to its scratch memory
            arguments[7] = "double *scratch"
        lines.append(f"void model_{name}({', '.join(arguments)});")
    return lines


def names_header(functions: Sequence[str], fmi: int) -> str:
    """Return the text of `names.h`, which adds a unique prefix to the names of the model functions."""
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
    """Return the text of `model.h`, which contains all constants of an FMU."""
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
        "N_GUIDED": len(layout.guided),
        "JOB_SIZE": len(Job._fields),
    }
    sizes |= {f"JOB_{name}": k for k, name in enumerate(Job._fields)}
    start = [0.0 if info.slope_of and source >= PORT else item.value
             for item, info, source in zip(export_model.inputs, model.inputs, layout.sources, strict=True)]  # fmt: skip
    conditions = problem.stop_conditions
    texts = [c_string(_reason(condition)) for condition in conditions] or ['""']
    lines = [
        "/* Constants of the model; written by poppet. */",
        "#ifndef POPPET_MODEL_H\n#define POPPET_MODEL_H\n",
        "#include <math.h>\n#include <stdint.h>\n",
        '#include "names.h"\n',
        f"#define MODEL_GUID {c_string(token)}",
        *(f"#define {name} {value}" for name, value in sizes.items()),
        f"#define TOLERANCE {literal(problem.relative_tolerance)}",
        f"#define LONGEST_STEP {literal(problem.maximum_step)}",
        f"#define MOST_ATTEMPTS {literal(problem.most_attempts)}\n",
        array("double", "START_P", problem.p),
        array("double", "START_U", start),
        array("unsigned char", "NUMBER_ROLE", layout.roles),
        array("double", "NUMBER_LOW", (parameter.low for parameter in export_model.parameters)),
        array("double", "NUMBER_HIGH", (parameter.high for parameter in export_model.parameters)),
        array("unsigned char", "INPUT_SOURCE", layout.sources),
        array("int", "INPUT_NUMBER", (item.parameter for item in export_model.inputs)),
        array("double", "INPUT_LOW", (item.low for item in export_model.inputs)),
        array("double", "INPUT_HIGH", (item.high for item in export_model.inputs)),
        array("int", "GUIDED_NUMBER", (parameter for parameter, _ in layout.guided)),
        array("int", "GUIDED_INPUT", (item for _, item in layout.guided)),
        array("double", "SEGMENT_STARTS", problem.starts),
        array("int", "SEGMENT_COURSES", problem.courses),
        array("unsigned char", "SEGMENT_JUMPS", problem.jumps),
        array("double", "COURSES", problem.coefficients.ravel()),
        array("int", "STATE_NUMBER", (layout.initial_parameters.get(k, -1) for k in range(len(model.states)))),
        array("double", "STATE_SCALES", kernel.scales.ravel()),
        array("double", "STATE_NOMINALS", nominal_sizes(layout)),
        array("unsigned char", "STATE_POSITIVE", kernel.positive),
        array("unsigned char", "MEMORY_ACTING", kernel.acting),
        array("int64_t", "CONDITION_PLACES", (p for c in conditions for p in c.places)),
        array("double", "CONDITION_WEIGHTS", (w for c in conditions for w in c.weights)),
        f"static const char *const CONDITION_TEXTS[] = {{{', '.join(texts)}}};\n",
        '#ifdef __cplusplus\nextern "C" {\n#endif',
        *prototypes(functions),
        "int64_t model_integrate(const int64_t *job);",
        "#ifdef __cplusplus\n}\n#endif\n",
        "static void model_functions(int64_t *job) {",
        *(f"  job[JOB_{name}] = (int64_t)(intptr_t)model_{name};" for name in JOB_FUNCTIONS if name in functions),
        "  (void)job;\n}\n\n#endif\n",
    ]
    return "\n".join(lines)


def _reason(condition: StopCondition) -> str:
    """Return the message that reports a stop condition.

    It is the text of the condition, or it names the stroke that leaves its domain.
    """
    reason = condition.reason
    return str(reason.facts.get("condition", f"{reason.address} leaves its domain"))
