"""`poppet plot`: recordings drawn over each other."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.cli.assignments import Shape
from poppet.cli.parser import ALL, PICTURES, SELECT, UNITS, Option, output_path

if TYPE_CHECKING:
    from poppet.timeseries.recording import Recording

EXAMPLES = (
    "poppet plot fill.csv -o fill.png",
    'poppet plot measured.csv simulated.csv -o both.svg --select "tank.pressure,valve.stroke" --units bar,mm',
)
OPTIONS = (
    Option("RECORDING ...", "recordings: .csv, .parquet or .mat"),
    Option("-o, --output PICTURE", "file to write instead of FIRST.png", PICTURES),
    SELECT,
    UNITS,
    ALL,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    output = options.output or output_path(f"{Path(options.recordings[0]).stem}.png", PICTURES)
    shape = Shape.read(options.select, options.units)
    from poppet.timeseries.plotting.plots import plot_recordings
    from poppet.timeseries.recording import Recording

    read = [_known(Recording.read(path)) for path in options.recordings]
    labelled = dict(zip(_labels(options.recordings), read, strict=True))
    plot_recordings(labelled, output, select=shape.patterns or None, units=shape.plot_units(read), inner=options.all)
    print(f"{output}: {len(labelled)} {'recordings' if len(labelled) > 1 else 'recording'} drawn.")
    return 0


def _known(recording: Recording) -> Recording:
    """A recording that knows its inner series; a CSV file names series only, which parts know."""
    if recording.inner:
        return recording
    from poppet.parts import KINDS
    from poppet.timeseries.recording import Recording

    inner = {name for kind in KINDS.values() for name in kind.internal_outputs}
    found = frozenset(name for name in recording.names if name.rpartition(".")[2] in inner)
    return Recording(**(recording.fields() | {"inner": found}))


def _labels(paths: Sequence[str]) -> list[str]:
    """File names without suffix, or whole paths where those are not unique."""
    # The same file twice, or two of one name, must not fall together under one label.
    stems = [Path(path).stem for path in paths]
    labels = stems if len(set(stems)) == len(stems) else list(paths)
    return [label if labels.count(label) == 1 else f"{label} ({k})" for k, label in enumerate(labels, 1)]
