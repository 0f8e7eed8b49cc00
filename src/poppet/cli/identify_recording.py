"""Option `--from` of `poppet identify tank`: questions on a terminal, interpretation, and the file of the test."""

from __future__ import annotations

import argparse
import shlex
import sys
from collections.abc import Sequence
from pathlib import Path

from poppet.cli.summary import print_notes, print_written
from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors, MissingDependencyError, PoppetError
from poppet.core.files import by_suffix, check_folder, check_path, write_whole
from poppet.core.number_format import aligned, printable
from poppet.identify.recorded_columns import Question, UserStatement
from poppet.identify.tank.tank_recording import TankInterpretation, interpret_tank
from poppet.timeseries.tables.reading import Table, read_table

OPTIONS = {
    "time": '--time "{name} [s]"',
    "time_unit": '--time "{name} [s]", or another unit',
    "pressure": '--pressure "{name} [bar g]"',
    "pressure_unit": '--pressure "{name} [bar g]", or another unit',
    "reference": "--reference gauge or --reference absolute",
    "window": '--window "0.5 s, 20 s"',
    "opens": '--opens free, its time: --opens "2.3 s", or the column of the valve signal',
    "closes": '--closes "8 s", or --closes no',
    "volume": '--volume "20 l"',
    "ambient": '--ambient "1.013 bar"',
    "supply": '--supply "7 bar g", or its column',
    "ambient_temperature": '--ambient-temperature "21 degC"',
    "wall_conductance": "--wall-conductance free",
}
"""Options that answer the questions, with examples."""
KEYS = ("time", "pressure", "temperature", "reference", "volume", "ambient", "ambient_temperature", "direction",
        "supply", "opens", "closes", "window", "wall_conductance")  # fmt: skip
"""Keys of the statements, which are the names of the options."""
OPTIONAL = ("ambient_temperature", "wall_conductance")
"""Keys that a terminal also asks for, although the fit can do without them."""
TOGETHER = ("reference", "supply", "ambient")
"""Keys whose answers are asked again together, because a contradiction does not show which of them is wrong."""


def describe_recording(options: argparse.Namespace) -> bool:
    """Interpret a recording, write its picture and the file of the test, and set `options.file`.

    The result is False if the user rejects the interpretation or keeps an existing file.
    """
    path = Path(options.recording)
    target = Path(options.file) if options.file else path.with_suffix(".toml")
    by_suffix(target, {".toml": target})  # a recording must not be replaced
    check_path(target)
    check_folder(target, target.parent)
    is_terminal = sys.stdin.isatty() and sys.stderr.isatty()
    if target.exists() and not options.force and not is_terminal:
        raise InputError("question.exists", path=str(target))
    table = read_table(path)
    statements = {key: UserStatement(text, "option") for key in KEYS if (text := getattr(options, key))}
    interpretation = interpret_tank(path, statements, table)
    if interpretation.questions and not is_terminal:
        print(_summary(interpretation))
        raise _unanswered(path, interpretation.questions)
    if interpretation.questions and interpretation.curve[0].size:
        print_written(_draw(interpretation, options.picture, target))
    if is_terminal and (interpretation.questions or not options.yes):
        interpretation = _ask_all(path, table, statements, interpretation)
    print(_summary(interpretation))
    print_notes(interpretation.notes)
    print_written(_draw(interpretation, options.picture, target))
    if interpretation.doubts and not options.yes and not is_terminal:
        raise InputErrors(
            InputError("question.doubtful", path=str(path), finding=finding) for finding in interpretation.doubts
        )
    print_notes(interpretation.doubts)
    if is_terminal and not options.yes and not _agrees(Note("question.confirm")):
        print("No file of the test was written. Change the options, which contain your answers:", file=sys.stderr)
        print(printable(_command(path, options.file, statements)), file=sys.stderr)
        return False
    if target.exists() and not options.force and not _agrees(Note("question.overwrite", path=str(target))):
        return False
    text = interpretation.test_file(target.parent)
    write_whole(target, lambda stream: stream.write(text.encode()))
    print_written(target)
    options.file = str(target)
    return True


def _unanswered(path: Path, questions: Sequence[Question]) -> InputErrors:
    """Return one error for each open question, with the option that answers it."""
    return InputErrors(
        InputError(
            "question.unanswered",
            question.key,
            path=str(path),
            question=question.note,
            option=_option(question),
        )
        for question in questions
    )


def _option(question: Question) -> str:
    facts = question.note.facts
    names = facts.get("names", ())
    return OPTIONS[question.key].format(name=facts.get("column") or (names[0] if names else ""))


def _ask_all(
    path: Path, table: Table, statements: dict[str, UserStatement], interpretation: TankInterpretation
) -> TankInterpretation:
    """Ask the open questions one after the other, and return the complete interpretation."""
    print(f"{path}: poppet asks for what the file does not contain.", file=sys.stderr)
    while interpretation.questions:
        interpretation = _ask(interpretation.questions, path, table, statements, interpretation)
    optional = [
        Question(key, Note(f"question.{key}"), default="free" if key == "wall_conductance" else "unknown")
        for key in OPTIONAL
        if key not in statements
    ]
    for k in range(len(optional)):
        interpretation = _ask(optional[k:], path, table, statements, interpretation)
    return interpretation


def _ask(
    questions: Sequence[Question],
    path: Path,
    table: Table,
    statements: dict[str, UserStatement],
    interpretation: TankInterpretation,
) -> TankInterpretation:
    """Ask the first question until its answer is valid, add the answer to the statements, and interpret again.

    If the input ends, the error lists all of the questions.
    """
    question = questions[0]
    while True:
        text = _answer(question)
        if text is None:
            raise _unanswered(path, questions)
        if not text:
            text = question.default
        if text == "unknown" or (not text and question.default):
            return interpretation
        if text and not (question.is_closed and text not in question.choices):
            trial = statements | {question.key: UserStatement(text, "answer")}
            try:
                interpretation = interpret_tank(path, trial, table)
            except PoppetError as problem:
                print(f"error: {printable(str(problem))}", file=sys.stderr)
                doubtful = [key for key in TOGETHER if key in trial and trial[key].origin == "answer"]
                if _is_contradiction(problem) and doubtful:
                    for key in doubtful:
                        statements.pop(key, None)
                    return interpret_tank(path, statements, table)
                continue
            statements.update(trial)
            return interpretation
        example = "no, or a value with its unit" if question.key == "closes" else "a value with its unit"
        choices = question.choices or (example,)
        print(f"error: {InputError('question.no_answer', question.key, value=text, choices=choices)}", file=sys.stderr)


def _answer(question: Question) -> str | None:
    """Print a question and return the answer, which can be a unique start of a choice; None at the end of the input."""
    choices = f" [{', '.join(question.choices)}]" if question.choices else ""
    default = f" [Enter: {question.default}]" if question.default else ""
    print(f"{printable(str(question.note))}{choices}{default} ", end="", file=sys.stderr, flush=True)
    line = sys.stdin.readline()
    if not line:
        print(file=sys.stderr)
        return None
    text = line.strip()
    matches = [choice for choice in question.choices if choice.startswith(text.lower())] if text else []
    return matches[0] if len(matches) == 1 and question.is_closed else text


def _is_contradiction(problem: PoppetError) -> bool:
    """Return whether an error is on the recording as a whole, and not on one statement."""
    return isinstance(problem, InputError) and all(each.code == "tank.above_supply" for each in problem.problems)


def _command(path: Path, file: str | None, statements: dict[str, UserStatement]) -> str:
    """Return the command with all options and answers, for a shell."""
    options = [text for key in statements for text in (f"--{key.replace('_', '-')}", statements[key].text)]
    return shlex.join(["poppet", "identify", "tank", *([file] if file else []), "--from", str(path), *options])


def _agrees(note: Note) -> bool:
    while True:
        answer = _answer(Question("confirm", note, choices=("yes", "no"), is_closed=True))
        if answer in ("yes", "no", None):
            return answer == "yes"


def _summary(interpretation: TankInterpretation) -> str:
    rows = [[f"  {item.subject}", item.value, ", ".join(item.origins)] for item in interpretation.items]
    return f"Interpretation of {interpretation.path}\n" + aligned([["  item", "value", "source"], *rows], [])


def _draw(interpretation: TankInterpretation, picture: Path | None, target: Path) -> Path | None:
    """Write the picture of an interpretation; without Matplotlib, the default picture is omitted with a note."""
    from poppet.report.identification.interpretation_figure import draw_interpretation

    path = picture or target.with_name(f"{target.stem}-interpretation.png")
    try:
        draw_interpretation(interpretation, path)
    except MissingDependencyError as problem:
        if picture:
            raise
        print(f"note: {problem}", file=sys.stderr)
        return None
    return path
