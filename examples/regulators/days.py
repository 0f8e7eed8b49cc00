"""Validate the fits of this folder, each of one file of 10 January, with recordings of other days.

The recordings belong to ASU-RISE-Lab/4-chamber-softarm-control (MIT). The script needs a copy of it. Usage:

    python examples/regulators/days.py COPY
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from poppet.identify import baselines, identify_fit, read_fit_file
from poppet.identify.baseline_models import ARX, FIRST_ORDER, GREY_BOX, Score

FOLDER = Path(__file__).parent
CHANNELS = (1, 2, 4, 5)
COMMANDS = {"arm.pressure": "controller.setpoint"}
MONTHS = ("jan", "feb", "mar", "apr")
FITTED = ("Jan 10-2", "data_collect_1.txt")
LEAST = 3.9
"""Smallest change of a command for an evaluation [psi]."""
STEADY = ("controller.outer.feed_forward", "controller.outer.bias")
"""Steady-state parameters: the line between gauge and command."""


def columns(channel: int) -> tuple[int, int]:
    """Return the column indices of command and pressure of a channel.

    The order is time, three commands, three pressures, then the same for the next three channels.
    """
    place = channel if channel <= 3 else channel + 3
    return place, place + 3


def recordings(copy: Path, channel: int) -> dict[str, list[Path]]:
    """Return the files by day and command height if the command changes, without the fitted file and duplicates."""
    found: dict[tuple[int, int, int], list[Path]] = {}
    seen: set[bytes] = set()
    for path in sorted(copy.rglob("data_collect_*.txt")):
        content = path.read_bytes()
        if content in seen:
            continue
        seen.add(content)
        command = np.loadtxt(path, delimiter=",", usecols=columns(channel)[0])
        month, day = re.findall(r"^([a-z]+) *(\d+)", path.parent.name.lower())[0]
        if np.ptp(command) >= LEAST and path.parts[-2:] != FITTED:
            found.setdefault((MONTHS.index(month), int(day), round(command.max())), []).append(path)
    return {f"{day} {MONTHS[month].title()}, {psi} psi": found[month, day, psi] for month, day, psi in sorted(found)}


def table(path: Path, channel: int, use: str) -> str:
    """Return a fit-file table of one recording; the command before its first sample is 1 psi."""
    command, pressure = columns(channel)
    return f"""
file = "{path.resolve().as_posix()}"
use = "{use}"
time = {{ column = 0, unit = "s" }}
start = {{ "arm.initial_pressure" = "first" }}
"arm.pressure" = {{ column = {pressure}, unit = "psi g" }}
inputs = {{ "controller.setpoint" = {{ column = {command}, unit = "psi g", hold = true, before = 1 }} }}
"""


def fit_text(channel: int) -> str:
    """Return the fit file of a channel with absolute paths and only the fitted recording."""
    text = (FOLDER / f"fit_itv0050_{channel}.toml").read_text(encoding="utf-8")
    text = re.sub(r'"([^"]+\.(?:csv|toml))"', lambda m: f'"{(FOLDER / m[1]).resolve().as_posix()}"', text)
    return re.sub(r"\[recordings\.(?!seen).*?(?=\n\[)", "", text, flags=re.DOTALL)


def judged(channel: int, days: Mapping[str, Sequence[Path]]) -> tuple[dict[str, list[Score]], dict[str, list[float]]]:
    """Return the scores by day, and the NRMSE after a refit of the steady-state parameters for each file."""
    names = {day: [f"file_{k}_{n}" for n in range(len(days[day]))] for k, day in enumerate(days)}
    named = {name: path for day, paths in days.items() for name, path in zip(names[day], paths, strict=True)}
    text = fit_text(channel)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "fit.toml"
        tables = [f"\n[recordings.{name}]{table(path, channel, 'validation')}" for name, path in named.items()]
        file.write_text(text + "".join(tables), encoding="utf-8")
        result = identify_fit(file)
        scores = baselines(read_fit_file(file), COMMANDS, result)
        # Only the steady-state parameters are fitted again.
        values = {name: e.value for name, e in result.parameters.items()}
        fixed = ", ".join(f'"{name}" = {value:.17g}' for name, value in values.items() if name not in STEADY)
        free = "".join(f'"{name}" = {{ start = {values[name]:.17g} }}\n' for name in STEADY)
        head = re.split(r"\n\[", text, maxsplit=1)[0]
        given = re.search(r"^set = \{(.*)\}$", head, re.MULTILINE)
        fixed = ", ".join(filter(None, (given[1].strip() if given else "", fixed)))
        head = re.sub(r"^set = .*$", "", head, flags=re.MULTILINE) + f"\nset = {{ {fixed} }}\n"
        anew = {}
        for name, path in named.items():
            file.write_text(f"{head}[recordings.one]{table(path, channel, 'fit')}[free]\n{free}", encoding="utf-8")
            anew[name] = next(iter(identify_fit(file).residuals.values())).nrmse
    own = {day: [s for s in scores if s.response.partition(".")[0] in names[day]] for day in days}
    return own, {day: [anew[name] for name in names[day]] for day in days}


def rows(channel: int, scores: Mapping[str, list[Score]], anew: Mapping[str, list[float]]) -> Iterator[str]:
    """Yield a row for each day with the mean NRMSE of its files."""
    for day, own in scores.items():
        mean = {m: 100.0 * np.mean([s.nrmse for s in own if s.model == m]) for m in (GREY_BOX, FIRST_ORDER, ARX)}
        count = len(anew[day])
        gain = min(mean[FIRST_ORDER], mean[ARX]) / mean[GREY_BOX]
        shown = f"{mean[GREY_BOX]:.1f},{mean[FIRST_ORDER]:.1f},{mean[ARX]:.1f}"
        yield f"{channel},{day.replace(', ', ',')},{count},{shown},{gain:.1f},{100.0 * np.mean(anew[day]):.1f}"


def main() -> None:
    copy = Path(sys.argv[1])
    print("channel,day,command,files,circuit [%],first order + dead time [%],ARX [%],factor,circuit refitted [%]")
    for channel in CHANNELS:
        print(*rows(channel, *judged(channel, recordings(copy, channel))), sep="\n", flush=True)


if __name__ == "__main__":
    main()
