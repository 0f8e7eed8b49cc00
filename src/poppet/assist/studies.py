"""Functions `size`, `ensemble` and `identify`: many runs of a circuit."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from poppet.assist.arguments import Argument
from poppet.assist.circuits import NONE, File, Result, Text, Values, load_circuit
from poppet.assist.folder import Folder
from poppet.assist.limits import RUNS, TIME_LIMIT
from poppet.assist.replies import Json, note_rows, number, plain, quantity
from poppet.assist.simulation import Replace, TimeLimit, check_size
from poppet.core.errors import InputError, OutOfRangeError, raise_errors

if TYPE_CHECKING:
    from poppet.ensemble import CatalogueSizing
    from poppet.ensemble.catalogue_sizing import CatalogueTrial

METHODS = ("fit", "tank", "flow", "characteristic", "muscle", "friction", "design")
"""Methods of `identify`; those of plugins are not offered."""
ResultFile = Annotated[str, Argument("file for the complete result: .toml or .json", longest=200)]
RESULTS = (".toml", ".json")


def size(
    folder: Folder,
    *,
    free: Annotated[
        str, Argument('address of the parameter: "fill.sonic_conductance"; or use `catalogue`', longest=200)
    ] = "",
    catalogue: Annotated[
        str,
        Argument('part whose component is selected from the library and from component files: "valve"', longest=200),
    ] = "",
    find: Annotated[
        str, Argument('conditions on the components, with `catalogue`: "5/2, C > 3 dm^3/(s bar)"', longest=200)
    ] = "",
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    with_result: Result = "",
    meet: Annotated[Sequence[str], Argument("names of requirements of the circuit (default: all)")] = (),
    between: Annotated[Sequence[str], Argument('search range with units: ["1 l", "50 l"]', longest=2)] = (),
    largest: Annotated[bool, Argument("find the largest value instead of the smallest")] = False,
    share: Annotated[str, Argument('required fraction of the runs of an ensemble: "95 %"', longest=20)] = "",
    sizes: Annotated[Sequence[str], Argument('standard sizes: ["5 l", "10 l"]')] = (),
    output: ResultFile = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Find the parameter value or catalogue component with which a circuit meets its requirements."""
    from poppet.core.units import quantity as read_quantity
    from poppet.ensemble import size as find_size
    from poppet.ensemble import size_from_catalogue

    _check_subject(free, catalogue, find, {"between": between, "share": share, "sizes": sizes})
    target = folder.target(output, "output", replace, RESULTS) if output else None
    change = load_circuit(folder, file, text, set, with_result)
    check_size(change.circuit)
    if between and len(between) != 2:
        raise InputError("assist.pair", "between", count=len(between))
    try:
        if catalogue:
            selection = size_from_catalogue(change.circuit, catalogue, find=find, meet=meet, largest=largest)
            if target is not None:
                selection.save(target)
            notes = note_rows([*change.notes, *selection.remarks])
            return _selection_rows(selection) | {"notes": notes} | ({"output": output} if output else {})
        sizing = find_size(
            change.circuit, free, meet=meet, between=(between[0], between[1]) if between else None, largest=largest,
            share=read_quantity(share, "1", name="share").value if share else None, sizes=sizes,
        )  # fmt: skip
    except InputError as error:
        raise change.located(error) from None
    if target is not None:
        sizing.save(target)
    return {
        "is_met": sizing.is_met,
        "address": sizing.address,
        "extreme": "largest" if sizing.is_largest else "smallest",
        **quantity(sizing.value, sizing.unit),
        "relative_resolution": number(sizing.resolution),
        "standard_size": number(sizing.size),
        "limiting": sizing.limiting,
        "requirements": dict(sizing.requirements),
        "margins": plain(sizing.margins),
        "met_between": plain(sizing.holding),
        "runs_per_value": sizing.runs,
        "share_interval": plain(sizing.interval),
        "notes": note_rows([*change.notes, *sizing.remarks]),
    } | ({"output": output} if output else {})


def _check_subject(free: str, catalogue: str, find: str, of_parameter: Mapping[str, Any]) -> None:
    """Raise errors unless either a parameter or a part is to be sized, with arguments for it only."""
    if bool(free) == bool(catalogue):
        raise InputError("assist.one_subject", "free")
    misplaced, excluding = (of_parameter, "catalogue") if catalogue else ({"find": find}, "free")
    raise_errors([InputError("assist.excluded", name, other=excluding) for name, value in misplaced.items() if value])


def _selection_rows(sizing: CatalogueSizing) -> Json:
    """Return the selected component, its neighbour, and all trials in ascending order of size."""
    selected, neighbour = sizing.selected, sizing.neighbour
    result: Json = {
        "is_met": sizing.is_met,
        "part": sizing.part,
        "extreme": "largest" if sizing.is_largest else "smallest",
        "measure": sizing.measure,
        "selected": _trial_row(selected, sizing.unit) if selected else None,
        "next": _trial_row(neighbour, sizing.unit) if neighbour else None,
        "requirements": dict(sizing.requirements),
        "units": dict(sizing.units),
        **plain({"trials": [_trial_row(trial, sizing.unit) for trial in sizing.trials]}),
    }
    if selected is not None:
        result["selected"] |= {
            "document": selected.component.place,
            "doubts": list(map(str, selected.component.doubts)),
        }
    return result


def _trial_row(trial: CatalogueTrial, unit: str) -> Json:
    return {
        "component": trial.component.name,
        **quantity(trial.size, unit),
        "is_met": trial.is_met,
        "outcome": trial.outcome,
        "margins": plain(trial.margins),
        "metrics": plain(trial.metrics),
    }


def ensemble(
    folder: Folder,
    *,
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    with_result: Result = "",
    runs: Annotated[int, Argument("number of runs; 0: that of the file", low=0, high=RUNS)] = 0,
    seed: Annotated[int, Argument("seed of the random numbers; -1: that of the file", low=-1, high=2**53)] = -1,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Run a circuit with the uncertain parameters of its table `ensemble`: yields, statistics, influences, worst."""
    from poppet.ensemble import plan_of, run_plan
    from poppet.ensemble.ensemble_plan import KINDS

    change = load_circuit(folder, file, text, set, with_result)
    check_size(change.circuit)
    fields: dict[str, Any] = ({"runs": runs} if runs else {}) | ({"seed": seed} if seed >= 0 else {})
    try:
        plan = plan_of(change.circuit, **fields)
        total = sum(plan.counts(kind)[0] for kind in KINDS)
        if total > RUNS:
            raise OutOfRangeError("assist.too_many_runs", "ensemble.runs", runs=total, most=RUNS)
    except InputError as error:
        raise change.located(error) from None
    with tempfile.TemporaryDirectory(prefix="poppet-ensemble-") as dataset:
        result = run_plan(plan, Path(dataset) / "dataset")
        return {
            "runs": result.done,
            "outcomes": result.outcomes(),
            "yields": [plain(asdict(row) | {"share": row.share}) for row in result.yields()],
            "metrics": [plain(asdict(row)) for row in result.summaries()],
            "influence": {name: [plain(asdict(row)) for row in rows] for name, rows in result.tornado().items()},
            "indices": {name: [plain(asdict(row)) for row in rows] for name, rows in result.indices().items()},
            "worst": {name: [plain(asdict(row)) for row in rows] for name, rows in result.worst().items()},
            "notes": note_rows([*change.notes, *result.remarks()]),
        }


def identify(
    folder: Folder,
    *,
    method: Annotated[str, Argument("identification method", choices=METHODS)],
    file: Annotated[str, Argument("identification file in the folder (.toml), which names recordings and the circuit")],
    profile: Annotated[Sequence[str], Argument("parameters with intervals by profile likelihood; fit, tank")] = (),
    bootstrap: Annotated[int, Argument("number of bootstrap fits; fit, tank", low=0, high=1000)] = 0,
    compare: Annotated[str, Argument("another fit file to compare with; fit", longest=200)] = "",
    output: ResultFile = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Identify parameters from recordings: values with 95 % intervals and verdicts, residuals and findings."""
    from poppet.identify.methods import BUILT_IN

    target = folder.target(output, "output", replace, RESULTS) if output else None
    declaration = next(row for row in BUILT_IN if row.name == method)
    path = folder.existing(file, "file", (".toml",))
    stated: dict[str, Any] = {
        "profile": list(profile),
        "repeats": bootstrap,
        "compare": str(folder.existing(compare, "compare", (".toml",))) if compare else None,
    }
    accepted = {option.keyword for option in declaration.options if option.keyword}
    for keyword, name in (("profile", "profile"), ("repeats", "bootstrap"), ("compare", "compare")):
        if stated[keyword] and keyword not in accepted:
            raise InputError("assist.no_option", name, method=method)
    result = declaration.identify(path, **{key: value for key, value in stated.items() if key in accepted})
    if target is not None:
        result.save(target)
    content = result.content()
    if "parameters" not in content:  # the ranking of tests has other tables
        return plain(content) | ({"output": output} if output else {})  # type: ignore[no-any-return]
    names = ("method", "title", "parameters", "residuals", "comparison", "conditions")
    return {
        **{key: plain(content[key]) for key in names},
        "findings": note_rows(result.remarks),
    } | ({"output": output} if output else {})
