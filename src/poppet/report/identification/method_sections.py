"""Sections of an identification report that depend on the identification method.

The declaration of a method names its `MethodReport`. The functions return sections; empty tables are omitted.
"""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from poppet.core.number_format import number, readable_unit, scaled, with_unit
from poppet.identify import Result
from poppet.identify.friction.records import COORDINATES
from poppet.report.html_page import Section
from poppet.report.identification.identification_tables import error_text, estimate_text, plain_text
from poppet.report.tables import ReportTable, code, numeric

_CONDUCTANCE = "m^3/(s Pa)"
_STANDARD_UNITS = {
    "sonic_conductance": _CONDUCTANCE,
    "critical_ratio": "1",
    "subsonic_index": "1",
    "cracking_pressure": "Pa",
}


class MethodReport(NamedTuple):
    """Sections and references that one identification method adds to its report."""

    models: Callable[[Result], Sequence[Section]] = lambda result: ()  # before the section of the fit
    evidence: Callable[[Result], Sequence[Section]] = lambda result: ()  # after the tests of the fit
    references: tuple[str, ...] = ("runs", "aicc")  # codes of `identification.reference`
    has_bands: bool = True  # the summary shows the band of a curve instead of parameters


def _steady_sections(result: Result) -> list[Section]:
    """Return the sections on the tests of a flow bench or a valve characteristic."""
    stroke_rows = [
        (str(name), plain_text(stroke, "m"), error_text(c, u_c, _CONDUCTANCE), error_text(b, u_b, "1"))
        for name, (stroke, c, b, u_c, u_b) in result.conditions.get("tests", {}).items()
    ]
    formulas, formula_rows = result.comparison.get("standard_formulas") or {}, []
    for name, si_unit in _STANDARD_UNITS.items():
        if name not in formulas:
            continue
        value, error = float(formulas[name]), float(formulas.get(f"u_{name}", math.nan))
        fit = next((e for key, e in result.parameters.items() if key.rpartition(".")[2] == name), None)
        fixed = number(float(result.conditions.get("fixed", {}).get(name, math.nan)))
        text = error_text(value, error, si_unit) if error > 0.0 else number(value)
        formula_rows.append((code(name), text, estimate_text(fit) if fit else f"{fixed}, fixed"))
    formula_table = ReportTable(("parameter", "formulas of the standard", "direct fit"), formula_rows)
    note = "<p>The errors are standard uncertainties.</p>\n" if formula_rows else ""
    return [
        Section("Tests at the strokes", ReportTable(("test", *numeric("stroke", "C ± u(C)", "b ± u(b)")), stroke_rows)),
        Section("Formulas of the standard", [formula_table, note]),
        *_budget_sections(result),
    ]


def _budget_sections(result: Result) -> list[Section]:
    """Return the section on the uncertainty budget.

    For each parameter, the largest source of uncertainty comes first.
    """
    budget_rows = []
    for name, budget in result.comparison.get("uncertainty", {}).items():
        si_unit = result.parameters[name].unit if name in result.parameters else "1"
        total = math.hypot(*budget["sources"].values())
        unit = readable_unit(si_unit, total)
        for source, size in sorted(budget["sources"].items(), key=lambda pair: -pair[1]):
            fraction = f"{100.0 * (size / total) ** 2:.0f} %" if 0.0 < total < math.inf else "-"
            text = with_unit(f"{scaled(size, si_unit, unit):.2g}", unit) if math.isfinite(size) else number(size)
            budget_rows.append((code(name), source, text, fraction))
    budget_columns = numeric("standard uncertainty", "fraction of the variance")
    return [Section("Uncertainty budget", ReportTable(("parameter", "source", *budget_columns), budget_rows))]


def _force_sections(result: Result) -> list[Section]:
    """Return the section that compares force laws of a muscle, the best law first."""
    axes = result.comparison.get("held_out_by", ())
    rows = [
        (
            code(law["law"]),
            f"{law['held_out']:.3g} N",
            f"{100.0 * law['held_out_of_largest']:.2g} %",
            *(f"{law[f'held_out_by_{axis}']:.3g} N" for axis in axes),
            f"{law['rms']:.3g} N",
            f"{100.0 * law['rms_of_largest']:.2g} %",
            f"{law['worst']:.3g} N",
            str(law["numbers"]),
        )
        for law in result.comparison.get("forces", ())
    ]
    relative = "relative to the largest force"
    validation = ("rms of the validation", relative, *(f"validation by {axis}" for axis in axes))
    columns = numeric(*validation, "rms of the fit", relative, "maximum error", "parameters")
    return [Section("Force laws", ReportTable(("law", *columns), rows))]


def _friction_sections(result: Result) -> list[Section]:
    """Return the sections on friction.

    They contain the laws, the recordings, and the text of the part for a circuit file.
    """
    c = result.comparison
    coordinate = COORDINATES[c["body"]]
    unit, effort = coordinate.effort_unit, coordinate.effort
    laws = [
        (
            code(law["law"]),
            f"{law['held_out']:.3g} {unit}",
            f"{law['rms']:.3g} {unit}",
            str(law["numbers"]),
            "supported" if law["law"] == c["supported"] else "not distinguishable" if law["alike"] else "worse",
        )
        for law in c["laws"]
    ]
    recordings = [
        (
            recording["name"],
            plain_text(float(f"{recording['pressure']:.3g}"), "Pa") if recording["pressure"] else "-",
            " / ".join(plain_text(float(f"{speed:.3g}"), coordinate.speed) for speed in recording["speeds"]),
            *(
                f"{recording[key]:.3g} {unit}" if key in recording else "-"
                for key in ("level", "line", "offset", "half_of_force")
            ),
        )
        for recording in c["recordings"]
    ]
    headings = f"validation by {c['held_out_by']}", "rms of the fit", "parameters"
    efforts = f"offset of the {effort}", f"half of the {effort}s"
    content: list[str | ReportTable] = [
        ReportTable(("law", *numeric(*headings), ""), laws),
        ReportTable(("recording", *numeric("pressure", "mean speeds", "friction", "by the law", *efforts)), recordings),
        f"<p>In a circuit file:</p>\n<pre>{html.escape(c['ready'])}</pre>\n",
    ]
    return [Section("Friction laws", content)]


TANK = MethodReport(evidence=_budget_sections, references=("iso6358_2", "gum", "runs", "aicc"))
FLOW = MethodReport(evidence=_steady_sections, references=("iso6358_1", "gum", "aicc"))
CHARACTERISTIC = MethodReport(evidence=_steady_sections, references=("varga2012", "runs", "aicc"))
MUSCLE = MethodReport(_force_sections, references=("muscle_laws", "jackknife"))
FRICTION = MethodReport(_friction_sections, references=("friction_laws", "clusters", "one_error"), has_bands=False)
