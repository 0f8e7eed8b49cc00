"""Command `poppet audit leaks`: flow and cost of the leaks in a leak survey."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING

from poppet.cli.summary import print_written
from poppet.core.number_format import aligned

if TYPE_CHECKING:
    from poppet.audit.leaks import LeakCost, LeakSurvey


def survey_leaks(options: argparse.Namespace) -> None:
    """Run the command `audit leaks`: print the flow and the cost of each leak in a survey."""
    from poppet.audit.leak_file import read_survey

    survey = read_survey(options.file)
    if options.output:
        survey.save(options.output)
    print(survey_text(survey))
    print_written(options.output)


def survey_text(survey: LeakSurvey) -> str:
    """Return a leak survey as text for a terminal: the leaks, their sum, and the tariff with its sources."""
    currency = survey.tariff.currency
    heads = ["leak", "method", "count", "flow [l/min ANR]", "air [m^3/year]", "electricity [kWh/year]"]
    heads += [f"cost [{currency}/year]", f"saved by repair [{currency}/year]"] if currency else []
    heads += ["CO2 [kg/year]"] if survey.tariff.emission is not None else []
    rows = [_cells(row) for row in (*survey.leaks, survey.total)]
    tariff = [
        [name.replace("_", " "), number.display(), str(number.source)] for name, number in survey.tariff.numbers()
    ]
    fraction = f"A repair saves {100.0 * survey.control_fraction:g} % of the electricity of a leak (control_fraction)."
    table = aligned([heads, *rows], range(2, len(heads)))
    return "\n\n".join(filter(None, [survey.title, table, aligned(tariff, (1,)), fraction]))


def _cells(row: LeakCost) -> list[str]:
    name = ["sum", "", ""] if row.leak is None else [row.leak.name, row.leak.method, str(row.leak.count)]
    values = [row.flow * 6e4, row.volume, row.electricity / 3.6e6, row.cost, row.saved_cost, row.co2]
    digits = [".2f", ".0f", ".0f", ".2f", ".2f", ".0f"]
    return name + [format(value, digit) for value, digit in zip(values, digits, strict=True) if not math.isnan(value)]
