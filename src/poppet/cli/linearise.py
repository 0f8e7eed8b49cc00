"""Command `poppet linearise`: linear model of a circuit at an operating point."""

from __future__ import annotations

import argparse
from typing import Any

from poppet.cli.assignments import load_circuit, read_assignments
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_written
from poppet.core.note_groups import grouped
from poppet.core.number_format import aligned

ZERO = 1e-12
"""Magnitude up to which an eigenvalue of a sampled model counts as zero."""


def linearise_file(options: argparse.Namespace) -> None:
    """Print the linear model of a circuit, and write it to a file if one is specified."""
    from poppet.timeseries.recording import Recording

    circuit, _ = load_circuit(options)
    inputs = read_assignments(options.inputs, "--set-input")
    recording = Recording.read(options.at) if options.at else None
    with Spinner("The operating point is computed", is_quiet=options.quiet):
        linear = circuit.linearise(inputs or None, at=recording)
    # A sampled model lists the discrete states as well.
    units = {state.name: state.unit for state in circuit.model.states} | dict(circuit.model.memory)
    print(_model_text(linear, units))
    if options.output:
        linear.save(options.output)
    print_written(options.output)


def _model_text(linear: Any, units: dict[str, str]) -> str:
    from poppet.report.result_tables import mode_table

    sample_time = getattr(linear, "sample_time", 0.0)
    names_by_kind = {"state": linear.states, "input": linear.inputs, "output": linear.outputs}
    counts = ", ".join(f"{len(names)} {kind}{'s' * (len(names) != 1)}" for kind, names in names_by_kind.items())
    point = [
        ["state or discrete state" if sample_time else "state", "unit", "value"],
        *([name, units.get(name, ""), f"{value:.6g}"] for name, value in zip(linear.states, linear.x, strict=True)),
    ]
    head = f"Linear model over samples of {sample_time:.6g} s: {counts}" if sample_time else f"Linear model: {counts}"
    texts = [head, aligned(point, [2]), mode_table(linear).text()]
    if sample_time:
        texts += [_eigenvalue_text(linear), "\n".join(f"- {note}" for note in grouped(linear.notes))]
    return "\n\n".join(text for text in texts if text)


def _eigenvalue_text(linear: Any) -> str:
    """Return a line with the nonzero eigenvalues of a sampled model, and the number of zero eigenvalues."""
    values = [complex(z) for z in linear.eigenvalues()]
    nonzero = [z for z in values if abs(z) > ZERO and z.imag >= 0.0]
    n_zero = sum(abs(z) <= ZERO for z in values)
    texts = [f"{z.real:.6g}" if z.imag == 0.0 else f"{z.real:.6g} +- {z.imag:.6g}i" for z in nonzero]
    texts += [f"{n_zero} times 0 (recomputed in every sample)"] if n_zero else []
    return f"Eigenvalues over a sample: {', '.join(texts)}"
