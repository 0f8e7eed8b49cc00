"""Tasks on a dropped recording of a tank test: interpretation with questions, and the fit of C and b."""

from __future__ import annotations

import base64
from typing import Any

from poppet.core.errors import InputError
from poppet.edit.tasks.fits import upload_path
from poppet.edit.tasks.order import TaskOrder, TaskResult, value_operations
from poppet.edit.tasks.runs import sentences
from poppet.identify.recorded_columns import UserStatement
from poppet.identify.tank.tank_recording import TankInterpretation, interpret_tank
from poppet.timeseries.plotting.figures import style

VALUES = {"valve.sonic_conductance": "sonic_conductance", "valve.critical_ratio": "critical_ratio"}
"""Estimates that a flow path of the circuit can take, and its fields."""


def interpret_recording(order: TaskOrder) -> TaskResult:
    """Interpret a recording of a tank test, and return items, questions and a picture."""
    from poppet.report.identification.interpretation_figure import curve_picture

    interpretation = _interpretation(order)
    picture = base64.b64encode(curve_picture(interpretation)).decode()
    questions = [
        {
            "key": question.key,
            "text": str(question.note),
            "choices": list(question.choices),
            "default": question.default,
            "is_closed": question.is_closed,
        }
        for question in interpretation.questions
    ]
    items = [{"subject": i.subject, "value": i.value, "origins": list(i.origins)} for i in interpretation.items]
    doubts = sentences(interpretation.doubts)
    data = {"items": items, "questions": questions, "doubts": list(doubts), "picture": picture}
    return TaskResult(notes=sentences(interpretation.notes), data=data)


def fit_tank_test(order: TaskOrder) -> TaskResult:
    """Fit C, b and the wall conductance to a recording of a tank test."""
    from poppet.identify.tank.identify_tank import identify_tank
    from poppet.report.identification.headline import result_summary
    from poppet.report.identification.identification_report import write_identification
    from poppet.report.identification.interpretation_figure import draw_interpretation

    style("A report of an identification")
    interpretation = _interpretation(order)
    if interpretation.questions:
        question = interpretation.questions[0]
        raise InputError(
            "question.unanswered",
            question.key,
            path=interpretation.path.name,
            question=question.note,
            option=f"the field {question.key}",
        )
    draw_interpretation(interpretation, order.path("-interpretation.png"))
    text = interpretation.test_file(interpretation.path.parent)
    order.path("-test.toml").write_text(text, encoding="utf-8")
    result = identify_tank(interpretation.tank_test(), progress=lambda n, _: order.report("evaluations", n, None))
    order.report("report", 0.0, None)
    result.save(order.path("-fit.toml"))
    write_identification(result, order.path("-fit.html"))
    part, values = order.options.get("part"), result.values()
    numbers = {f"{part}.{field}": values[address] for address, field in VALUES.items() if address in values}
    operations = value_operations(order, numbers) if part else ()
    return TaskResult(result_summary(result), sentences(interpretation.doubts), operations)


def _interpretation(order: TaskOrder) -> TankInterpretation:
    statements: dict[str, Any] = dict(order.options.get("statements", {}))
    path = upload_path(order.uploads, order.options["recording"])
    answers = {key: UserStatement(str(text).strip(), "answer") for key, text in statements.items() if str(text).strip()}
    return interpret_tank(path, answers)
