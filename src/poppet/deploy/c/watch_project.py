"""Export of a watch as C: the estimator, the filter around it, the rule of alarms, a host program."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import cache
from importlib.resources import files
from itertools import accumulate
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.version import __version__
from poppet.deploy.c.c_model import (
    enum_members,
    fill_template,
    fixed_step_functions,
    number_list,
    number_rows,
    prototypes,
)
from poppet.deploy.export_files import c_string, comment_text, identifier, identifiers
from poppet.deploy.exported_watch import WatchSource, check_watch, possible_changes, simulated_samples
from poppet.deploy.targets import Export
from poppet.engine.estimator_call import MOST_ATTEMPTS, EstimatorCall, derivative_functions
from poppet.engine.estimator_call import SIGNATURES as DERIVATIVES
from poppet.engine.estimator_job import EstimatorJob, memory_size
from poppet.engine.job import Job
from poppet.engine.printers.c import DOUBLE, print_function, print_step, used_prelude
from poppet.engine.printers.instructions import trace_functions
from poppet.monitoring import evidence, fault_statistics, verdicts
from poppet.monitoring.filter import CHECK, FARTHEST, FIRST, FORGET, GAP, LINEAR, PlantFilter
from poppet.monitoring.initial_estimate import STEP
from poppet.monitoring.onsets import ONSETS, PER_DELAY
from poppet.monitoring.plant_estimator import make_estimator
from poppet.monitoring.sensors import Readings

if TYPE_CHECKING:
    from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]


@cache
def estimator_code(name: str = "estimate") -> str:
    """Return the C source of the estimator; `name` replaces the name of its function."""
    text = files("poppet.engine").joinpath("estimator.c").read_text(encoding="utf-8")
    head = "int64_t estimate(const int64_t *fields)"
    assert head in text
    return text.replace(head, f"{head};\n{head}").replace("estimate(const int64_t", f"{name}(const int64_t")


def export_c_watch(watch: WatchSource, *, name: str | None = None) -> Export:
    """Export the watch of a running plant as C. The keyword argument is an option of the export target."""
    return Export(watch_project(watch, name or ""))


def watch_project(source: WatchSource, name: str = "") -> dict[str, str]:
    """Return the C files of a watch by name.

    Parameters
    ----------
    source : WatchSource
        Plan, baseline and column of the time.
    name : str, optional
        Name of the program (default: title of the watch).

    Returns
    -------
    dict
        Header, filter with the rule of alarms, model, estimator, host program, and a `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If the watch has delayed inputs or too many faults.
    """
    check_watch(source.plan)
    name = identifier(name or source.title)
    fields = {"ABOUT": _about(source, name), "NAME": name, **_test_vector(source)}
    return {
        **watch_sources(source, name),
        f"{name}_host.c": fill_template("watch_host.c", name, fields),
        "CMakeLists.txt": fill_template("watch.txt", name, fields),
    }


def watch_sources(source: WatchSource, name: str) -> dict[str, str]:
    """Return the C files of a watch without a host program."""
    fields = watch_fields(source, name)
    return {
        f"{name}.h": fill_template("watch.h", name, fields),
        f"{name}.c": fill_template("watch.c", name, fields),
        f"{name}_model.c": model_source(source.plan, name),
        f"{name}_estimator.c": estimator_code(f"{name}_estimate"),
    }


def _about(source: WatchSource, name: str) -> str:
    return f"{comment_text(source.title or name)}: exported by poppet {__version__}"


def _functions(plan: WatchPlan) -> dict[str, tuple[Any, str]]:
    """Return the CasADi functions that the exported watch calls, with their signatures."""
    model = make_estimator(plan, False).kernel.model
    names = [output for output, _ in model.outputs]
    outputs = [names.index(channel.address) for channel in plan.channels]
    derivatives = derivative_functions(model, outputs, plan.free.places.tolist(), plan.touched_inputs.tolist())
    functions = {name: (f, DERIVATIVES[name]) for name, f in derivatives.items()}
    traced = trace_functions(model)
    used = [*(("rates", "jacobian", "factor", "solve") if model.size else ()), *(("update",) if model.memory else ())]
    functions |= {key: (traced[key], "") for key in used}
    return functions | {"start": (fixed_step_functions(plan.instance.model)["start"], "")}


def model_source(plan: WatchPlan, name: str) -> str:
    """Return the C source of the model functions."""
    model = make_estimator(plan, False).kernel.model
    printed = [
        print_function(f, key, signature, head="void", prefix=f"{name}_")
        for key, (f, signature) in _functions(plan).items()
    ]
    step = [print_step(model.size, len(model.inputs), "void", f"{name}_")] if model.size else []
    code = "\n\n".join([*printed, *step])
    return "\n\n".join(
        ["/* Model of the plant; written by poppet. */\n#include <math.h>", used_prelude(code), code, ""]
    )


def watch_fields(source: WatchSource, name: str) -> dict[str, str]:
    """Return the texts that replace the placeholders of the templates."""
    template, e = PlantFilter(source.plan, source.baseline, fuses=False, fits=False), make_estimator(source.plan, False)
    return {
        "ABOUT": _about(source, name),
        "NAME": name,
        **_sizes(template, e),
        **_rule(source, e),
        **_arrays(source, template, e),
        **_names(source, template, name),
        "PROTOTYPES": _prototypes(source.plan, name),
        **_jobs(e, source.plan, name),
    }


def _slopes(plan: WatchPlan) -> list[int]:
    """Return the indices of inputs that are derivatives, each before that of its driven input."""
    inputs = plan.instance.model.inputs
    return [
        index
        for k, info in enumerate(inputs)
        for item in plan.inputs
        if info.slope_of == inputs[item.index].name
        for index in (k, item.index)
    ]


def _sizes(template: PlantFilter, e: EstimatorCall) -> dict[str, str]:
    """Return the sizes of arrays, and the offsets in the working memory."""
    plan, initial = template.plan, template.initial
    n, m, f, c = len(template.states), len(plan.names), len(plan.faults), len(plan.channels)
    sizes = {
        "CHANNELS": c, "INPUTS": len(plan.inputs), "FAULTS": f, "FREE": m, "STATES": n, "ONSETS": ONSETS,
        "REVIEWS": round(1.5 / verdicts.REVIEW), "ROOM_U": e.kernel.job["n_inputs"],
        "ROOM_P": max(1, e.p.size), "ROOM_INPUTS": max(1, len(plan.inputs)), "BASE_P": initial.p.size,
        "N_INITIAL": len(initial.places), "N_PLACES": len(plan.free.places), "N_SLOPES": len(_slopes(plan)) // 2,
    }  # fmt: skip
    places = {
        "P": initial.p.size, "TOUCHED": initial.p.size, "X": n, "MOVED": n, "BY_THETA": (n + m) * m,
        "PRODUCT": (n + m) * m, "ERRORS": len(initial.places) * n, "THETA": m, "COVARIANCE": m * m, "EXCESS": m,
        "KEPT": (n + m) * (n + m + 1), "MEMORY": len(plan.instance.model.memory) + 1,
    }  # fmt: skip
    offsets = list(accumulate(places.values(), initial=0))
    touched = len(plan.free.places) + len(plan.touched_inputs)
    sizes |= {f"AT_{key}": offset for key, offset in zip(places, offsets, strict=False)}
    sizes |= {"WORK": offsets[-1], "SCRATCH": e.kernel.memory_size}
    sizes["MEMORY"] = memory_size(n, m, touched, c, sizes["ROOM_U"], e.kernel.job["n_memory"], ONSETS * f)
    return {key: f"{size}" for key, size in sizes.items()}


def _rule(source: WatchSource, e: EstimatorCall) -> dict[str, str]:
    """Return the constants of the filter and of the rule of alarms."""
    plan, baseline, f = source.plan, source.baseline, len(source.plan.faults)
    constants = {
        "RISE": verdicts.RISE, "FALL": verdicts.FALL, "RISE_SIZE": evidence.RISE_SIZE,
        "FALL_SIZE": evidence.FALL_SIZE, "REVIEW": verdicts.REVIEW, "KEPT": verdicts.KEPT,
        "LARGEST": verdicts.LARGEST, "MISFIT": evidence.MISFIT,
        "EXPLAINED": verdicts.EXPLAINED, "EXPLAINED_LINEARLY": verdicts.EXPLAINED_LINEARLY, "GROWN": verdicts.GROWN,
        "LEFT": verdicts.LEFT_LINEARLY, "LIKELY": verdicts.LIKELY,
        "TEMPER": baseline.temper, "HEALTHY_NIS": max(baseline.healthy_nis, verdicts.SMALLEST_NIS),
        "SCATTER": fault_statistics.SCATTER,
        "WIDE": fault_statistics.WIDE, "FAULT_PRIOR": fault_statistics.PRIOR,
        "SPREAD": math.sqrt(2.0 * math.pi) / (fault_statistics.DECADES * math.log(10.0)), "SET": fault_statistics.SET,
        "CEILING": fault_statistics.CEILING, "LIMIT_ONE": fault_statistics.chi_square_limit(f - 1),
        "LIMIT_CAUTION": fault_statistics.chi_square_limit(max(f - 1, 1)),
        "LIMIT_TWO": fault_statistics.chi_square_limit(f - 2),
        "LIMIT_UNKNOWN": fault_statistics.chi_square_limit(f - 1, 3.09),
        "STEP": STEP, "WINDOW": plan.window, "ALARM_DELAY": plan.alarm_delay, "PER_DELAY": PER_DELAY,
        "GAP": GAP, "FORGET": FORGET, "FARTHEST": FARTHEST, "CHECK": CHECK, "FIRST": FIRST, "LINEAR": LINEAR,
        "MOST_ATTEMPTS": MOST_ATTEMPTS, "TOLERANCE": e.tolerance, "STATE_NOISE": plan.state_noise,
    }  # fmt: skip
    return {key: DOUBLE.literal(float(value)) for key, value in constants.items()}


def _arrays(source: WatchSource, template: PlantFilter, e: EstimatorCall) -> dict[str, str]:
    """Return the constant arrays of the plan, the baseline and the model."""
    plan, initial, start_u = source.plan, template.initial, np.zeros(e.kernel.job["n_inputs"])
    inputs = plan.instance.held_inputs({})
    start_u[: inputs.size] = inputs
    columns = [channel.address for channel in plan.channels]
    alarms, (least, most) = np.array([fault.alarm for fault in plan.faults]), possible_changes(plan, source.baseline)
    numbers: dict[str, Iterable[float]] = {
        "SCALES": e.kernel.scales.ravel(), "START_U": start_u,
        "INPUT_LOW": [x.low for x in plan.inputs], "INPUT_HIGH": [x.high for x in plan.inputs],
        "NOMINAL": [state.nominal for state in plan.instance.model.states], "BASE": e.base,
        "REFERENCE": e.reference, "LOW": e.low, "HIGH": e.high, "CAP": e.cap, "WALK": plan.walk, "PRIOR": plan.prior,
        "VARIANCES": template.prior_covariance.diagonal(), "NOISE": template.noise**2, "GATES": e.gates,
        "SENSOR_NOISE": template.noise, "INITIAL_SIZES": initial.sizes.values(),
        "ALARMS": alarms, "LEAST_CHANGE": least / alarms, "MOST_CHANGE": most / alarms,
    }  # fmt: skip
    integers: dict[str, Iterable[Any]] = {
        "POSITIVE": map(int, e.kernel.positive), "ACTING": map(int, e.kernel.acting),
        "DRIVEN": [x.index for x in plan.inputs], "HOLDS": [int(x.hold) for x in plan.inputs],
        "SLOPES": _slopes(plan), "PLACES": plan.free.places.tolist(),
        "TOUCHED_INPUTS": plan.touched_inputs.tolist(), "INITIAL_PLACES": initial.places.values(),
        "INITIAL_CHANNELS": [columns.index(a) if a in columns else -1 for a in initial.places],
        "WAYS": [fault.direction for fault in plan.faults],
    }  # fmt: skip
    return {
        **{key: number_list(values) or "0.0" for key, values in numbers.items()},
        **{key: ", ".join(map(str, values)) or "0" for key, values in integers.items()},
        "START_P": number_rows(_in_rows(e.p)), "INITIAL_P": number_rows(_in_rows(initial.p)),
        "DIRECTIONS": number_rows(e.directions), "EFFECTS": number_rows(e.effects),
    }  # fmt: skip


def _names(source: WatchSource, template: PlantFilter, name: str) -> dict[str, str]:
    """Return the lists of columns and free numbers, and the enumerations of their indices."""
    plan, clock, upper = source.plan, source.clock, name.upper()
    time = f'{{"", {c_string(clock.column)}, {c_string(clock.unit)}, {number_list([clock.scale, 0.0])}}}'
    healthy = zip(plan.names, plan.units, template.healthy, strict=True)
    rows = [f"  {{{c_string(key)}, {c_string(unit)}, {number_list([value])}}}" for key, unit, value in healthy]
    free = [
        (key, f"{comment_text(text)} [{comment_text(unit)}]")
        for key, text, unit in zip(identifiers(plan.names), plan.names, plan.units, strict=True)
    ]
    return {
        "TIME": time,
        "CHANNEL_LIST": _columns(plan.channels),
        "INPUT_LIST": _columns(plan.inputs),
        "FREE_LIST": ",\n".join(rows),
        "READING_NAMES": _members(f"{upper}_READING", plan.channels),
        "INPUT_NAMES": _members(f"{upper}_INPUT", plan.inputs),
        "FREE_NAMES": enum_members(f"{upper}_FREE", free),
    }


def _in_rows(values: Array) -> list[Array]:
    return [values[k : k + 6] for k in range(0, values.size, 6)]


def _columns(items: Sequence[Readings]) -> str:
    rows = [
        f"  {{{c_string(x.address)}, {c_string(x.column)}, {c_string(x.unit)}, {number_list([x.scale, x.shift])}}}"
        for x in items
    ]
    return ",\n".join(rows) or '  {"", "", "", 1.0, 0.0}'


def _members(prefix: str, items: Sequence[Readings]) -> str:
    names = identifiers([x.address for x in items])
    rows = [
        (key, f"{comment_text(x.address)} [{comment_text(x.si_unit)}]") for key, x in zip(names, items, strict=True)
    ]
    return enum_members(prefix, rows)


def _prototypes(plan: WatchPlan, name: str) -> str:
    lines = []
    for key, (_, signature) in _functions(plan).items():
        if signature:
            given, results = (side.split() for side in signature.split("->"))
            arguments = [*(f"const double *{a}" for a in given), *(f"double *{a}" for a in results)]
            lines.append(f"void {name}_{key}({', '.join(arguments)});")
        else:
            lines += prototypes([key], f"{name}_")
    has_states = bool(plan.instance.model.states)
    return "\n".join([*lines, *prototypes(("step", "dense") if has_states else (), f"{name}_")])


def _jobs(e: EstimatorCall, plan: WatchPlan, name: str) -> dict[str, str]:
    """Return the C code that fills the rows of addresses and lengths of the estimator."""
    functions = _functions(plan)
    job = dict.fromkeys(Job._fields, "0") | {key: str(value) for key, value in e.kernel.job.items()}
    calls = [*functions, *(("step", "dense") if plan.instance.model.states else ())]
    job |= dict.fromkeys(("jacobian", "step", "dense", "outputs", "update"), "0")
    job |= {key: f"(int64_t)(intptr_t){name}_{key}" for key in calls if key in job}
    job |= {key: f"address({key})" for key in ("scales", "positive", "acting")}
    job |= {key: f"address(w->{key})" for key in ("p", "x", "limits", "counts")} | {"memory": "address(w->scratch)"}
    fields = {key: f"address(w->{key})" for key in EstimatorJob._fields} | {
        "action": "action", "linear": f"(int64_t)(intptr_t){name}_linear",
        "observe": f"(int64_t)(intptr_t){name}_observe", "run": "address(job)", "n_free": f"{len(plan.names)}",
        "n_places": f"{len(plan.free.places)}", "n_touched_inputs": f"{len(plan.touched_inputs)}",
        "n_channels": f"{len(plan.channels)}", "n_onsets": f"{ONSETS}", "n_faults": f"{len(plan.faults)}",
        "scores": "address(&w->nis)",
        **{key: f"address({key})" for key in ("places", "touched_inputs", "base", "directions", "reference", "low",
                                               "high", "effects", "noise", "gates", "cap")},
    }  # fmt: skip
    return {
        "JOB": "\n".join(f"  job[{k}] = {job[field]}; /* {field} */" for k, field in enumerate(Job._fields)),
        "FIELDS": "\n".join(
            f"  fields[{k}] = {fields[field]}; /* {field} */" for k, field in enumerate(EstimatorJob._fields)
        ),
        "JOB_SIZE": f"{len(Job._fields)}",
        "FIELDS_SIZE": f"{len(EstimatorJob._fields)}",
    }


def _test_vector(source: WatchSource) -> dict[str, str]:
    """Return samples of a simulated plant and the expected results, by template placeholder."""
    rows = simulated_samples(source)
    return {"ROWS": f"{len(rows)}", "WIDTH": f"{len(rows[0])}", "TABLE": number_rows(rows)}
