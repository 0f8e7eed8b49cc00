"""Tables of the documentation on the accuracy of `poppet watch`, row by row.

`python -m exact.watch_tables FOLDER TABLE ...` in the folder `tests` adds the missing rows to `FOLDER/TABLE.jsonl` and
prints them; without a table, all of them. An interrupted run continues with the next row. `--processes N` computes
several rows at the same time.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from exact import independent_watch_cylinder as cylinder
from exact import independent_watch_tank as tank
from exact.watch_batteries import (
    BAND_FAULTS,
    Outcome,
    cylinder_outcome,
    cylinder_plan,
    cylinder_run,
    cylinder_start,
    drawn_tanks,
    gauge_plan,
    healthy_runs,
    leak_steps,
    masked_leaks,
    model_errors,
    percentiles,
    silent_runs,
    tank_outcomes,
    tank_plan,
)
from exact.watch_batteries import bands as fault_bands

Facts = dict[str, Any]
"""Results of a row; `row` is the text for the documentation."""
Row = Callable[[], Facts]

FAULT_TIME = 150.0
"""Time at which the leaks of the tank begin [s]."""


def text_row(*cells: object) -> str:
    """Return a row of a table in Markdown."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def alarms_of(outcomes: Sequence[Outcome]) -> list[list[Any]]:
    """Return run, time and names of all alarms."""
    return [[k, alarm.time, alarm.names] for k, outcome in enumerate(outcomes) for alarm in outcome.alarms]


def silence(outcomes: Sequence[Outcome]) -> Facts:
    """Return the alarms of healthy runs, and the number of runs whose model did not fit."""
    return {
        "runs": len(outcomes),
        "alarms": alarms_of(outcomes),
        "runs_with_alarm": sum(bool(outcome.alarms) for outcome in outcomes),
        "runs_with_misfit": sum(bool(outcome.misfits) for outcome in outcomes),
        "unexplained": sum(bool(outcome.alarms) and not outcome.misfits for outcome in outcomes),
    }


# Tank -----------------------------------------------------------------------------------------------------------------

INPUTS = {False: "random", True: "duty cycle"}
DISTURBANCES = {
    "1 % outliers of 0.5 bar": tank.Sensors(outliers=0.01),
    "50 % missing samples": tank.Sensors(missing=0.5),
    "1 % outliers and 50 % missing": tank.Sensors(outliers=0.01, missing=0.5),
    "gauge readings": tank.Sensors(is_gauge=True),
    "resolution of 10 mbar": tank.Sensors(resolution=1e3),
}


def leak(size: float, duty: bool, has_wall: bool, runs: int = 40) -> Facts:
    """Return the scores of leaks that begin at a time; size in per cent of the conductance of the valve."""
    found = leak_steps(size, range(runs), start=FAULT_TIME, duty=duty, plan=tank_plan(has_wall))
    sizes, (median, most) = found.sizes / tank.ONE_PERCENT, percentiles(found.delays)
    name = INPUTS[duty] + (", wall" if has_wall else "")
    estimate = f"{sizes.mean():.3f} ± {sizes.std():.3f} %"
    text = text_row(f"{size:g} %", name, runs, f"{median:.1f} s", f"{most:.1f} s", estimate, found.early)
    facts = {"median": median, "most": most, "longest": float(found.delays.max()), "early": found.early}
    return facts | {"row": text, "delays": found.delays.tolist(), "sizes": sizes.tolist()}


def healthy_hours(batch: int, runs: int = 20, duration: float = 3600.0) -> Facts:
    """Return the alarms of a batch of healthy runs."""
    outcomes = list(healthy_runs(batch, runs, duration))
    hours = sum(outcome.nis.size for outcome in outcomes) * tank.SAMPLE_TIME / 3600.0
    nis = [float(np.nanmean(outcome.nis)) for outcome in outcomes]
    facts = silence(outcomes)
    kind = INPUTS[bool(batch % 2)]
    text = text_row(f"healthy, {kind}", f"{hours:.3g} h", facts["runs_with_alarm"], f"NIS {np.mean(nis):.3f}")
    return facts | {"row": text, "hours": hours, "nis": nis}


def error_of_model(name: str, duty: bool, runs: int = 20, *, is_nuisance: bool = True) -> Facts:
    """Return the alarms of healthy plants that differ from the circuit file."""
    is_gauge = name.startswith("barometer")
    plan = gauge_plan(is_nuisance) if is_gauge else tank_plan(False)
    sensors = tank.Sensors(is_gauge=is_gauge)
    outcomes = model_errors([name], range(runs), duty=duty, plan=plan, sensors=sensors)[name]
    facts = silence(outcomes) | {
        "nis": float(np.mean([np.nanmean(outcome.nis[100:]) for outcome in outcomes])),
        "bias": float(np.mean([o.values[-1, 0] - tank.HEALTHY.leak for o in outcomes])) / tank.ONE_PERCENT,
    }
    numbers = f"alarms {facts['runs_with_alarm']}", f"misfits {facts['runs_with_misfit']}", f"NIS {facts['nis']:.3f}"
    title = name + ("" if is_nuisance else ", not a nuisance")
    return facts | {"row": text_row(title, INPUTS[duty], runs, *numbers, f"bias {facts['bias']:.3f} %")}


def healthy_disturbed(name: str, runs: int = 20) -> Facts:
    """Return the alarms of healthy runs with a disturbance of the readings."""
    facts = silence(silent_runs(DISTURBANCES[name], range(runs), 300.0))
    numbers = f"alarms {facts['runs_with_alarm']}", f"misfits {facts['runs_with_misfit']}"
    return facts | {"row": text_row(name, runs, *numbers)}


def leak_disturbed(name: str, runs: int = 20) -> Facts:
    """Return the scores of leaks of 1 % with a disturbance of the readings."""
    found = leak_steps(1.0, range(runs), start=FAULT_TIME, sensors=DISTURBANCES[name])
    median, most = percentiles(found.delays)
    facts = {"median": median, "most": most, "longest": float(found.delays.max()), "early": found.early}
    times = (f"{value:.1f} s" for value in (median, most, facts["longest"]))
    return facts | {"row": text_row(name, *times, runs, found.early), "delays": found.delays.tolist()}


def bands(first: int, runs: int = 100, duration: float = 180.0) -> Facts:
    """Return the innovations, and the errors of all free numbers in standard deviations at their times.

    The leak walks as slowly as the filter assumes, and the nuisances are drawn from their distributions. A run has few
    independent errors.
    """
    seeds, samples, plan = range(first, first + runs), round(duration / tank.SAMPLE_TIME), tank_plan(False)
    walk = tank.walking_leak(tank.HEALTHY.leak, float(plan.walk[0]) ** 0.5, seeds, samples)
    plants = drawn_tanks(seeds)
    outcomes = list(tank_outcomes(plants, tank.random_openings(seeds, samples), seeds, leak=walk, plan=plan))
    names = ["leak", "valve", "wall_conductance", "use", "supply_pressure", "supply_temperature"]
    covered, squares = {}, {}
    for k, name in enumerate(names):
        true = walk[:, ::10] if name == "leak" else getattr(plants, name)[:, None]
        errors = (np.array([o.free[:, k] for o in outcomes]) - true) / [o.free_sigmas[:, k] for o in outcomes]
        covered[name] = float(np.mean(np.abs(errors[:, 60:]) < 1.96))
        squares[name] = float(np.mean(errors[:, 60:] ** 2))
    nis = float(np.mean([np.nanmean(o.nis[600:]) for o in outcomes]))
    text = text_row(f"{runs} runs", f"NIS {nis:.3f}", *(f"{name} {100.0 * c:.1f} %" for name, c in covered.items()))
    return {"row": text, "runs": runs, "nis": nis, "covered": covered, "mean_squares": squares}


def hidden_leak(size: float, runs: int = 20) -> Facts:
    """Return the delays of leaks that a controller of the pressure hides; size in per cent, 0 for a healthy plant."""
    outcomes = masked_leaks(size, range(runs), start=FAULT_TIME)
    delays = np.array([outcome.first for outcome in outcomes]) - FAULT_TIME
    median, most = percentiles(delays)
    text = text_row(f"{size:g} %", runs, f"{median:.1f} s", f"{most:.1f} s", f"longest {delays.max():.1f} s")
    return silence(outcomes) | {"row": text, "delays": delays.tolist(), "early": int(np.sum(delays < 0.0))}


def bands_in_alarm(fault: str, size: float, growth: float = 0.0, runs: int = 10) -> Facts:
    """Return the errors of all sizes after the alarm, in standard deviations, and the names at the end."""
    results = fault_bands(fault, size, range(runs), growth=growth, duration=240.0 + growth)
    errors = np.concatenate([run.in_alarm for run in results])
    covered = float(np.mean(np.abs(errors) < 1.96))
    facts = {"covered": covered, "rms": float(np.sqrt(np.mean(errors**2))), "largest": float(np.abs(errors).max())}
    named = sum(run.outcome.names == (fault,) for run in results)
    wrong = sum(bool(set(run.outcome.names) - {fault}) for run in results)
    misfits = sum(bool(run.outcome.misfits) for run in results)
    delays = [run.outcome.first - 120.0 for run in results]
    deviations = [
        (run.outcome.sigmas[-1] / [entry["alarm"] for entry in BAND_FAULTS.values()]).tolist() for run in results
    ]
    text = text_row(
        fault, f"{size:g}", f"in {growth:g} s" if growth else "sudden", runs, f"bands {100.0 * covered:.1f} %",
        f"rms {facts['rms']:.2f}", f"largest {facts['largest']:.1f}", f"named {named}", f"wrong {wrong}",
        f"misfit {misfits}", f"median delay {percentiles(np.array(delays))[0]:.1f} s",
    )  # fmt: skip
    return {"row": text, "named": named, "wrong": wrong, "delays": delays, "deviations": deviations} | facts


# Cylinder -------------------------------------------------------------------------------------------------------------

FIVE = "seal_leak", "spool_leak", "leak_cap", "leak_rod", "coulomb_friction"
PAIRS = ("seal_leak", "leak_cap"), ("leak_rod", "coulomb_friction")
CONTROLLED = (), ("seal_leak",), ("leak_cap",), PAIRS[1]


def _setpoint(time: float) -> float:
    """Return the setpoint of the position control [m]."""
    return 0.05 if time % cylinder.CYCLE < 0.5 * cylinder.CYCLE else 0.15


def cylinder_faults(
    faults: Sequence[str],
    *,
    names: tuple[str, ...] = FIVE,
    has_control: bool = False,
    runs: int = 10,
    size: float = 1.0,
) -> Facts:
    """Return alarms, names and final sizes of faults that begin during a run of the cylinder."""
    plan, results = cylinder_plan(names), []
    for seed in range(runs):
        options = {"control": cylinder.position_loop(_setpoint)} if has_control else {}
        course = cylinder_run(dict.fromkeys(faults, size), seed, **options)
        outcome, start = cylinder_outcome(course, seed, plan=plan), cylinder_start(seed)
        units = [cylinder.FAULTS[name].unit for name in names]
        alarms = [
            {"delay": a.time - start, "names": a.names, "probabilities": a.probabilities.tolist()}
            for a in outcome.alarms
        ]
        results.append({
            "alarms": alarms, "names": outcome.names, "misfits": [time - start for time in outcome.misfits],
            "sizes": ((outcome.values[-1] - plan.reference[: len(names)]) / units).tolist(),
        })  # fmt: skip
    delays = np.array([run["alarms"][0]["delay"] if run["alarms"] else np.inf for run in results])
    median, most = percentiles(delays)
    first = sum(bool(run["alarms"]) and run["alarms"][0]["names"][:1] == faults[:1] for run in results)
    contained = sum(bool(run["alarms"]) and set(faults) <= set(run["alarms"][0]["names"]) for run in results)
    end = sum(set(run["names"]) == set(faults) for run in results)
    wrong = sum(bool(set(run["names"]) - set(faults)) for run in results)
    sizes = [abs(run["sizes"][names.index(name)]) for run in results for name in faults]
    text = text_row(
        "position control" if has_control else "cycles", " and ".join(faults) or "none", runs,
        f"{median:.1f} s", f"{most:.1f} s", f"first {first}", f"contained {contained}", f"only at the end {end}",
        f"wrong at the end {wrong}", f"misfit {sum(bool(run['misfits']) for run in results)}",
        f"{min(sizes):.2f} to {max(sizes):.2f}" if sizes else "",
    )  # fmt: skip
    counts = {"first": first, "contained": contained, "end": end, "wrong": wrong, "early": int(np.sum(delays < 0.0))}
    return {"row": text, "faults": faults, "results": results, "median": median, "most": most} | counts


# Other plants ---------------------------------------------------------------------------------------------------------


def isolation_draws(sensors: tuple[str, ...], seed: int) -> Facts:
    """Return the results of all faults of all sizes for one seed, each on one cycle of the cylinder."""
    from exact.isolation_battery import SIZES, Draw, draws, judge_of

    results: list[Draw] = [*draws(judge_of(sensors), SIZES, [seed])]
    right = [draw.named[:1] == (draw.fault,) for draw in results if draw.size == 1.0]
    text = text_row(", ".join(sensors), seed, f"{np.mean(right):.2f} of the faults of size 1 are the most probable")
    return {"row": text, "draws": [asdict(draw) for draw in results]}


def damadics_scenario(name: str) -> Facts:
    """Return the indices of a scenario of the DAMADICS benchmark, and the changes of the verdict."""
    from exact.damadics_watch import evaluate, row
    from exact.independent_damadics import SCENARIOS

    result = evaluate(next(scenario for scenario in SCENARIOS if scenario.name == name))
    facts = {"indices": result.indices._asdict(), "verdicts": result.verdicts, "sizes": result.sizes}
    return {"row": row(result), "per_update": result.per_update} | facts


def growing_leak(growth: float, nuisance: Sequence[str] | None, duration: float) -> Facts:
    """Return the scores of a leak of the valve that wears; growth of its effective area [m^2/s]."""
    from exact.wear_valve_watch import NUISANCE, PORT, evaluate

    names = list(NUISANCE) if nuisance is None else list(nuisance)
    result, percent = (
        evaluate(growth, duration=duration, nuisance={name: NUISANCE[name] for name in names}),
        0.01 * PORT,
    )
    is_alarm = np.array([bool(alarm) for alarm in result.alarms])
    k = int(np.argmax(is_alarm))
    lag = result.time[-1] - np.interp(result.size[-1], result.true, result.time)
    text = text_row(
        f"{growth / percent:.4f} %/s", "supply and ports" if len(names) > 1 else "supply",
        f"{result.time[k] - 200.0:.0f} s", f"{result.true[k] / percent:.2f} %",
        f"{result.true[-1] / percent:.2f} % after {duration - 200.0:.0f} s",
        f"{result.size[-1] / percent:.2f} ± {result.sigma[-1] / percent:.2f} %", f"lag {lag:.0f} s",
    )  # fmt: skip
    facts = {"is_found": bool(is_alarm.any()), "names": sorted(set(result.alarms)), "lag": float(lag)}
    early = bool(is_alarm[result.time < 200.0].any())
    return {"row": text, "early": early, "alarm_size": float(result.true[k] / percent)} | facts


def chamber(name: str) -> Facts:
    """Return C/V of a real chamber by windows and by a straight line."""
    from published.test_chamber_leaks import EARLY, EMPTY, LATE, by_window, slope_of_logarithm

    windows = [EARLY] if name in EMPTY else [EARLY, LATE]
    pairs = [(by_window(name, window)[0].value, slope_of_logarithm(name, window).value) for window in windows]
    return {"row": text_row(name, *(f"{first:.4g}, {second:.4g}" for first, second in pairs)), "values": pairs}


# Tables ---------------------------------------------------------------------------------------------------------------


def _tables() -> Mapping[str, dict[str, Row]]:
    from exact.independent_damadics import DAY, SCENARIOS
    from exact.isolation_battery import SENSORS
    from published.test_chamber_leaks import DATA, ORDER

    both, names = (False, True), tuple(name for name in cylinder.FAULTS if name not in ("load", "supply_low"))
    growths = (5e-10, None, 600.0), (5e-10, ["supply.pressure"], 600.0), (1e-10, None, 1500.0)
    return {
        "leaks": {
            f"{size:g} %, {INPUTS[duty]}{', wall' * has_wall}": partial(leak, size, duty, has_wall)
            for has_wall in both
            for duty in both
            for size in (0.3, 1.0, 3.0, 10.0)
        },
        "healthy": {str(batch): partial(healthy_hours, batch) for batch in range(5)},
        "errors": {
            f"{name}, {INPUTS[duty]}": partial(error_of_model, name, duty)
            for name in tank.MODEL_ERRORS
            for duty in both
        }
        | {
            f"barometer, no nuisance, {INPUTS[duty]}": partial(
                error_of_model, "barometer +1.3 kPa", duty, is_nuisance=False
            )
            for duty in both
        },
        "disturbed": {f"healthy, {name}": partial(healthy_disturbed, name) for name in DISTURBANCES}
        | {f"leak, {name}": partial(leak_disturbed, name) for name in DISTURBANCES},
        "bands": {str(first): partial(bands, first) for first in range(0, 400, 100)},
        "steps": {
            f"{fault} {size:g}{f' in {growth:g} s' * (growth > 0.0)}": partial(bands_in_alarm, fault, size, growth)
            for fault, size, growth in (
                *(("leak", size, 0.0) for size in (1.0, 3.0, 10.0)),
                *(("clogged", size, 0.0) for size in (-5.0, -15.0, -30.0)),
                *(("supply_low", size, 0.0) for size in (-0.3, -1.0, -2.0)),
                *(("leak", 10.0, 120.0), ("clogged", -30.0, 120.0), ("supply_low", -1.0, 120.0)),
            )
        },
        "loops": {f"{size:g} %": partial(hidden_leak, size) for size in (0.0, 0.3, 1.0, 3.0)},
        "cylinder": {
            f"{'position control' if has_control else 'cycles'}: {' and '.join(faults) or 'none'}": partial(
                cylinder_faults, faults, has_control=has_control
            )
            for has_control, cases in ((False, ((), *((name,) for name in FIVE), *PAIRS)), (True, CONTROLLED))
            for faults in cases
        },
        "twelve": {
            " ".join(faults) or "none": partial(cylinder_faults, faults, names=names, runs=5)
            for faults in ((), *((name,) for name in names))
        },
        "isolation": {
            f"{', '.join(sensors)}: {seed}": partial(isolation_draws, sensors, seed)
            for seed in range(8)
            for sensors in SENSORS
        },
        "damadics": {
            scenario.name: partial(damadics_scenario, scenario.name)
            for scenario in sorted(SCENARIOS, key=lambda scenario: scenario.development)
            if scenario.development < DAY
        },
        "day": {s.name: partial(damadics_scenario, s.name) for s in SCENARIOS if s.development >= DAY},
        "wear": {str(case): partial(growing_leak, *case) for case in growths},
        "chambers": {name: partial(chamber, name) for name in ORDER} if DATA.is_dir() else {},
    }


TABLES = _tables()
"""Rows of each table by name."""


def _computed(task: tuple[str, str]) -> tuple[str, str, Facts]:
    """Compute one row."""
    table, name = task
    start = perf_counter()
    facts = TABLES[table][name]()
    return table, name, facts | {"seconds": round(perf_counter() - start, 1)}


def stored(folder: Path, table: str) -> dict[str, Facts]:
    """Return the rows of a table that are in a folder."""
    path = folder / f"{table}.jsonl"
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return {row["name"]: row for row in map(json.loads, lines)}


def main() -> None:
    """Add the missing rows of some tables to a folder."""
    parser = argparse.ArgumentParser(description="Compute tables of the documentation of `poppet watch`.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=f"one of {', '.join(TABLES)}")
    parser.add_argument("--processes", type=int, default=1)
    arguments = parser.parse_args()
    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    tables = arguments.tables or list(TABLES)
    tasks = [(table, name) for table in tables for name in TABLES[table] if name not in stored(folder, table)]
    with multiprocessing.get_context("spawn").Pool(arguments.processes) as pool:
        for table, name, facts in pool.imap_unordered(_computed, tasks):
            with (folder / f"{table}.jsonl").open("a", encoding="utf-8") as file:
                file.write(json.dumps({"name": name} | facts) + "\n")
            print(table, facts["row"], f"{facts['seconds']} s", flush=True)


if __name__ == "__main__":
    main()
