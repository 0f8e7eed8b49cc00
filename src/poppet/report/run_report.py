"""HTML report of a run: curves, circuit, results, balances and parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.core.number_format import with_unit
from poppet.core.provenance import LEAST_CERTAIN_FIRST
from poppet.report.circuit.schematic import draw_circuit
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.result_tables import ENERGY, STROKES, energy_table, extreme_table, stroke_table
from poppet.report.step_diagram import draw_step_diagram, sequences_of
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, code, numeric
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.plotting.plots import plot_recordings
from poppet.timeseries.recording import Recording

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit


def write_run(
    circuit: BaseCircuit, recording: Recording, path: str | Path, *, select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None, inner: bool = False,
) -> Path:  # fmt: skip
    """Write the report of a run as a self-contained HTML page.

    Parameters
    ----------
    circuit : Circuit
        The simulated circuit.
    recording : Recording
        The result of the simulation.
    path : str or Path
        File name with the suffix `.html`.
    select, units, inner : optional
        Selected outputs, their units, and whether internal outputs are drawn; see `plot_recordings`.

    Returns
    -------
    Path
        The written file.

    Examples
    --------
    >>> import tempfile
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> circuit = Circuit({"tank": Chamber(volume="10 l", initial_pressure="5 bar"), "vent": vent})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     page = write_run(circuit, circuit.simulate(1.0), f"{folder}/run.html")
    ...     "Parameters" in page.read_text(encoding="utf-8")
    True
    """
    return write_page(path, lambda: run_page(circuit, recording, select=select, units=units, inner=inner))


def run_page(
    circuit: BaseCircuit, recording: Recording, *, select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None, inner: bool = False,
) -> str:  # fmt: skip
    """Return the report of a run as HTML."""
    title = circuit.title or "A run"
    lead = f"{len(recording)} outputs"
    with style("A report of a run"):
        curves = ""
        if recording.time.size:
            lead = f"{recording.time[0]:.6g} to {recording.time[-1]:.6g} s, {recording.time.size} rows of {lead}"
            figure = plot_recordings({"": recording}, select=select, units=units, inner=inner)
            figure.texts[0].set_visible(not recording.title)  # the page shows the title
            curves = picture(figure, "run", "The run; bars at the bottom show the regime of each flow path.")
        loads: list[str | ReportTable] = []
        if (metrics := recording.figures) is not None:
            loads += [paragraph(STROKES), stroke_table(metrics)] if metrics.strokes else []
            energy = [(name, f"{value} {unit}") for name, value, unit in energy_table(metrics).rows]
            loads.append(ReportTable(("", Column("", "s")), energy, caption=ENERGY))
        accepted, rejected = (recording.statistics.get(f"{kind}_steps", 0) for kind in ("accepted", "rejected"))
        settings = [
            ("solver", circuit.run.solver),
            ("relative tolerance", f"{circuit.run.numbers()['relative_tolerance'].value:.3g}"),
            ("steps", f"{accepted:.0f} accepted, {rejected:.0f} rejected"),
            ("ambient pressure", f"{recording.ambient_pressure / 1e5:.6g} bar"),
        ]
        balance_rows = [
            (
                balance.name,
                *(f"{value} {balance.unit}" for value in (f"{balance.error:.2g}", f"{balance.allowed:.2g}",
                                                          f"{balance.through:.4g}")),
                "kept" if balance.is_kept else Markup("<strong>NOT kept</strong>"),
            )
            for balance in recording.residuals
            if balance.allowed > 0.0
        ]  # fmt: skip
        caption = "Residual: increase of the stored quantity minus the integrals of the flows into it."
        columns = numeric("residual", "allowed", "throughput")
        balances = ReportTable(("balance", *columns, ""), balance_rows, caption)
        # The parameters by the source of their values, the least certain source first.
        parameters, numbers = "", circuit.numbers()
        for kind in LEAST_CERTAIN_FIRST:
            rows = [
                (
                    code(address),
                    number.display(),
                    with_unit(f"{number.absolute(circuit.surroundings.pressure):.6g}", number.unit),
                    "; ".join(filter(None, (number.source.locator, number.source.note))),
                )
                for address, number in numbers.items()
                if number.source.kind == kind
            ]
            table = ReportTable(("parameter", "as written", Column("SI", "s"), "source"), rows, css_class="numbers")
            parameters += folded(f"{kind} ({len(rows)})", table, is_open=kind == "assumed")
        start = head(title, lead) + paragraph(recording.outcome, bold=True) + findings(recording.remarks)
        diagrams = ""
        for name in sequences_of(circuit) if recording.time.size else []:
            figure = draw_step_diagram(circuit, recording, sequence=name)
            figure.texts[0].set_visible(not circuit.title)  # the page shows the title
            diagrams += picture(figure, f"steps-{name}", f"The step sequence {name}.", is_still=True)
        sections = [
            Section("", start),
            Section("Strokes and energy", loads),
            Section("Steps", diagrams),
            Section("Run", curves),
            Section("Circuit", picture(draw_circuit(circuit), "circuit", "The circuit; * marks assumed values.")),
            Section("Values", extreme_table(recording) if recording.time.size else ""),
            Section("Balances", balances),
            Section("Solver", ReportTable(("", ""), settings)),
            Section("Parameters", parameters),
        ]
    return document(title, sections, style=stylesheet("run"))
