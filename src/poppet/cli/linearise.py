"""`poppet linearise`: the linear model of a circuit at a point."""

from __future__ import annotations

import argparse
from typing import Any

from poppet.cli.assignments import assignments, loaded
from poppet.cli.parser import FILE, SET, WITH, Option, tell_written
from poppet.cli.progress import Waiting
from poppet.core.note_groups import grouped
from poppet.core.number_format import aligned

EXAMPLES = (
    "poppet linearise two-tanks.toml",
    'poppet linearise valve-fill.toml --set-input valve.pilot_pressure="2 bar g"',
    "poppet linearise valve-fill.toml --at fill.csv -o linear.json",
)
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option("--at RECORDING", "where a recording ends; the state at rest when left out", rival="point"),
    Option(
        "--set-input ADDRESS=VALUE ...",
        'constant value of an input at rest: valve.pilot_pressure="2 bar g"',
        rival="point",
        more={"dest": "inputs"},
    ),
    Option("-o, --output FILE", "write A, B, C, D", (".json", ".mat", ".npz")),
)
FORGOTTEN = 1e-12
"""Size of an eigenvalue over a sample below which it is zero."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.timeseries.recording import Recording

    circuit, _ = loaded(options)
    inputs = assignments(options.inputs, "--set-input")
    at = Recording.read(options.at) if options.at else None
    with Waiting("The state of rest is looked for"):
        linear = circuit.linearise(inputs or None, at=at)
    # Memory has units as states have; a sampled model lists both.
    states = {state.name: state.unit for state in circuit.model.states}
    print(_text(linear, states | dict(circuit.model.memory)))
    if options.output:
        linear.save(options.output)
    tell_written(options.output)
    return 0


def _text(linear: Any, units: dict[str, str]) -> str:
    from poppet.report.result_tables import mode_table

    sample = getattr(linear, "sample_time", 0.0)
    sizes = {"state": linear.states, "input": linear.inputs, "output": linear.outputs}
    counts = ", ".join(f"{len(names)} {word}{'s' * (len(names) != 1)}" for word, names in sizes.items())
    point = [
        ["state or memory" if sample else "state", "unit", "value"],
        *([name, units.get(name, ""), f"{value:.6g}"] for name, value in zip(linear.states, linear.x, strict=True)),
    ]
    head = f"Linear model over samples of {sample:.6g} s: {counts}" if sample else f"Linear model: {counts}"
    texts = [head, aligned(point, [2]), mode_table(linear).text()]
    if sample:
        texts += [_multipliers(linear), "\n".join(f"- {note}" for note in grouped(linear.notes))]
    return "\n\n".join(text for text in texts if text)


def _multipliers(linear: Any) -> str:
    """Eigenvalues of a sampled model, the zeros of what is forgotten at once counted only."""
    values = [complex(z) for z in linear.eigenvalues()]
    kept = [z for z in values if abs(z) > FORGOTTEN and z.imag >= 0.0]
    gone = sum(abs(z) <= FORGOTTEN for z in values)
    texts = [f"{z.real:.6g}" if z.imag == 0.0 else f"{z.real:.6g} +- {z.imag:.6g}i" for z in kept]
    zero = [f"{gone} times 0 (worked out anew in every sample)"] if gone else []
    return f"Eigenvalues over a sample: {', '.join(texts + zero)}"
