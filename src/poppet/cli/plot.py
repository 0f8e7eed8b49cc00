"""Command `poppet plot`: curves of several recordings in common axes."""

from __future__ import annotations

import argparse
from pathlib import Path

from poppet.cli.assignments import OutputSelection
from poppet.cli.commands import PICTURES
from poppet.cli.parser import output_path


def plot_files(options: argparse.Namespace) -> None:
    """Plot the recordings of several files in common axes."""
    paths = options.recordings
    output = options.output or output_path(f"{Path(paths[0]).stem}.png", PICTURES)
    selection = OutputSelection.read(options.select, options.units)
    from poppet.parts import KINDS
    from poppet.timeseries.plotting.plots import plot_recordings
    from poppet.timeseries.recording import Recording

    # A CSV file has names only: the parts declare their internal outputs.
    internal = {name for kind in KINDS.values() for name in kind.internal_outputs}
    recordings = []
    for recording in map(Recording.read, paths):
        if not recording.inner:
            inner = frozenset(name for name in recording.names if name.rpartition(".")[2] in internal)
            recording = Recording(**(recording.fields() | {"inner": inner}))
        recordings.append(recording)
    # Labels are the file names without suffix, or the paths if these are not unique; a repeated path gets a number.
    stems = [Path(path).stem for path in paths]
    labels = stems if len(set(stems)) == len(stems) else list(paths)
    labels = [label if labels.count(label) == 1 else f"{label} ({k})" for k, label in enumerate(labels, 1)]
    plot_recordings(
        dict(zip(labels, recordings, strict=True)),
        output,
        select=selection.patterns or None,
        units=selection.plot_units(recordings),
        inner=options.all,
    )
    print(f"{output}: {len(labels)} {'recordings' if len(labels) > 1 else 'recording'} drawn.")
