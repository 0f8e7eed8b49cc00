"""Tests of `poppet identify tank --from`: options, questions on a terminal, and files."""

from __future__ import annotations

import io
import shlex
import sys

import numpy as np
import pytest

from poppet.cli import identify_recording
from tank_discharge import TRUTH, excel_export

OPTIONS = ("--volume", "20 l", "--ambient", "987 hPa", "--reference", "gauge", "--opens", "free")


class Terminal(io.StringIO):
    """Standard input that claims to be a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.fixture
def recording(tmp_path):
    pytest.importorskip("matplotlib")
    return excel_export(tmp_path / "messung.csv")


@pytest.fixture
def fits(monkeypatch):
    """Files that would be fitted; a fit itself takes a second."""
    from poppet.cli import identify

    fitted = []

    class Method:
        name, options, counts_points = "tank", (), False

        def identify(self, path, **_):
            fitted.append(path)
            raise KeyboardInterrupt

    monkeypatch.setattr(identify, "METHODS", {"tank": Method()})
    return fitted


def terminal(monkeypatch, *answers):
    monkeypatch.setattr(sys, "stdin", Terminal("".join(f"{answer}\n" for answer in answers)))
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)


def test_missing_facts_are_listed_with_their_options(poppet, recording, tmp_path):
    answer = poppet("identify", "tank", "--from", "messung.csv")
    assert answer.code == 2
    assert answer.codes == ["question.unanswered"] * 4
    assert [error.address for error in answer.errors] == ["reference", "opens", "volume", "ambient"]
    for option in ("--reference gauge", "--opens free", "--volume", "--ambient"):
        assert option in answer.err
    assert [path.name for path in tmp_path.iterdir()] == ["messung.csv"]


def test_options_give_the_file_the_picture_and_the_fit(poppet, recording, tmp_path):
    code, out, _ = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS, "-o", "result.toml")
    assert code == 0
    assert {path.name for path in tmp_path.iterdir()} == {
        "messung.csv", "messung.toml", "messung-interpretation.png", "result.toml",
    }  # fmt: skip
    assert out.index("messung-interpretation.png: written.") < out.index("messung.toml: written.")
    assert "All 5 parameters are determined." in out
    from poppet.identify import read_result

    found = read_result(tmp_path / "result.toml").parameters
    assert found["valve.sonic_conductance"].low < TRUTH["C"] < found["valve.sonic_conductance"].high
    # The written file alone gives the same result.
    again = poppet("identify", "tank", "messung.toml")
    assert again.code == 0
    assert again.out in out


def test_numbers_without_a_unit_and_unknown_units_name_the_unit(poppet, recording):
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS[2:], "--volume", "5")
    assert (answer.code, answer.codes) == (2, ["question.no_unit"])
    assert "for example: 5 l." in answer.err
    furlong = ("--pressure", "Druck Kessel [furlong]")
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS, *furlong)
    assert answer.codes == ["question.column_unit"]
    assert 'the unit "furlong", which is unknown. Write one of: bar, mbar, kPa, Pa, psi.' in answer.err


def test_an_existing_file_is_kept_unless_forced(poppet, recording, tmp_path, fits):
    (tmp_path / "messung.toml").write_text("mine")
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert (answer.code, answer.codes) == (2, ["question.exists"])
    assert (tmp_path / "messung.toml").read_text() == "mine"
    poppet("identify", "tank", "--from", "messung.csv", *OPTIONS, "--force", "--picture", "look.svg")
    assert "volume" in (tmp_path / "messung.toml").read_text()
    assert (tmp_path / "look.svg").stat().st_size > 2000
    assert fits == ["messung.toml"]


def test_a_recording_is_never_replaced(poppet, recording, tmp_path, fits):
    content = (tmp_path / "messung.csv").read_bytes()
    answer = poppet("identify", "tank", "messung.csv", "--from", "messung.csv", *OPTIONS, "--force", "--yes")
    assert (answer.code, answer.codes) == (2, ["files.suffix"])
    assert (tmp_path / "messung.csv").read_bytes() == content
    assert fits == []


def test_a_doubt_stops_the_fit_unless_accepted(poppet, recording, tmp_path, fits):
    wrong = [*OPTIONS[:-1], "1 s"]
    answer = poppet("identify", "tank", "--from", "messung.csv", *wrong)
    assert (answer.code, answer.codes) == (2, ["question.doubtful"])
    assert not (tmp_path / "messung.toml").exists()
    assert fits == []
    poppet("identify", "tank", "--from", "messung.csv", *wrong, "--yes")
    assert fits == ["messung.toml"]


def test_a_terminal_asks_until_the_answer_is_valid(poppet, recording, tmp_path, fits, monkeypatch):
    terminal(monkeypatch, "relative", "g", "", "20", "20 l", "1 bar g", "987 hPa", "21 degC", "", "yes")
    answer = poppet("identify", "tank", "test.toml", "--from", "messung.csv")
    assert fits == ["test.toml"]
    text = (tmp_path / "test.toml").read_text()
    assert 'volume = "20 l"                   # answer' in text
    assert 'ambient_temperature = "21 degC"' in text
    assert answer.err.count("error: ") == 3 + 1  # three invalid answers, and the interrupted fit
    # The picture for the question on the opening is there before the first question.
    assert answer.out.index("test-interpretation.png: written.") < answer.out.index("Interpretation of")


@pytest.mark.parametrize("last", ["no", ""])
def test_a_rejected_interpretation_writes_no_file(poppet, recording, tmp_path, fits, monkeypatch, last):
    terminal(monkeypatch, "unknown", "", last)
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert answer.code == 2
    assert not (tmp_path / "messung.toml").exists()
    assert fits == []


def test_a_rejected_interpretation_gives_the_command_with_all_answers(poppet, recording, fits, monkeypatch):
    terminal(monkeypatch, "gauge", "", "20 l", "987 hPa", "21 degC", "", "perhaps", "no")
    answer = poppet("identify", "tank", "--from", "messung.csv")
    assert answer.err.count("Is this correct?") == 2
    command = shlex.split(answer.err[answer.err.rindex("poppet identify tank") :])
    terminal(monkeypatch, "yes")  # nothing else is asked again
    poppet(*command[1:])
    assert fits == ["messung.toml"]


def test_contradicting_answers_are_asked_again(poppet, tmp_path, fits, monkeypatch):
    time = np.arange(0.0, 8.0, 0.05)
    pressure = 6.0 * (1.0 - np.exp(-np.maximum(time - 2.0, 0.0)))
    rows = "".join(f"{t:.2f};{p:.4f}\n" for t, p in zip(time, pressure, strict=True))
    (tmp_path / "charge.csv").write_text("t [s];p Tank [bar]\n" + rows)
    conditions = ("--opens", "free", "--closes", "no", "--volume", "5 l")
    terminal(monkeypatch, "gauge", "1 bar a", "1 bar", "gauge", "7 bar a", "1 bar", "", "", "yes")
    answer = poppet("identify", "tank", "--from", "charge.csv", *conditions)
    assert "above the supply pressure" in answer.err
    assert answer.err.count("Supply pressure of the charge?") == 2
    assert fits == ["charge.toml"]


def test_no_picture_is_drawn_before_the_column_of_the_pressure_is_known(poppet, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    rows = "".join(f"{0.1 * i:.1f};{5 - 0.04 * i:.2f};{6 + 0.01 * (i % 2):.2f}\n" for i in range(100))
    (tmp_path / "two.csv").write_text("t [s];p A [bar];p B [bar]\n" + rows)
    terminal(monkeypatch)
    answer = poppet("identify", "tank", "--from", "two.csv")
    assert answer.error.problems[0].address == "pressure"
    assert [path.name for path in tmp_path.iterdir()] == ["two.csv"]


def test_the_end_of_the_answers_lists_what_is_open(poppet, recording, monkeypatch):
    terminal(monkeypatch, "gauge")
    answer = poppet("identify", "tank", "--from", "messung.csv")
    assert answer.code == 2
    assert [error.address for error in answer.error.problems] == ["opens", "volume", "ambient"]


def test_a_terminal_asks_before_it_replaces_a_file(poppet, recording, tmp_path, fits, monkeypatch):
    (tmp_path / "messung.toml").write_text("mine")
    terminal(monkeypatch, "", "", "yes", "no")
    assert poppet("identify", "tank", "--from", "messung.csv", *OPTIONS).code == 2
    assert (tmp_path / "messung.toml").read_text() == "mine"
    terminal(monkeypatch, "", "", "yes", "yes")
    poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert fits == ["messung.toml"]


def test_without_the_drawing_package_only_a_named_picture_is_an_error(poppet, recording, tmp_path, fits, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS, "--picture", "look.png")
    assert answer.codes == ["missing.package"]
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert "note: " in answer.err
    assert fits == ["messung.toml"]


def test_options_of_a_recording_belong_to_tank_tests(poppet, recording):
    assert poppet("identify", "flow", "--from", "messung.csv").codes == ["cli.option.misplaced"]
    assert poppet("identify", "tank").codes == ["cli.usage"]


@pytest.mark.parametrize("words", [("tank", "messung.csv"), ("messung.csv",), ("--from", "messung.csv")])
def test_a_recording_without_method_or_option_has_the_command_as_its_hint(poppet, recording, words):
    answer = poppet("identify", *words)
    assert answer.codes == ["question.is_recording"]
    assert "poppet identify tank --from messung.csv" in answer.err


def test_every_question_has_an_option():
    asked = {*identify_recording.OPTIONS}
    from poppet.core.message_format import every_code

    questions = {code.partition(".")[2] for code in every_code() if code.startswith("question.")}
    assert asked <= questions


@pytest.mark.parametrize("answers", [(), ("21 degC",)])
def test_the_end_of_the_answers_to_optional_questions_lists_them(poppet, recording, monkeypatch, tmp_path, answers):
    terminal(monkeypatch, *answers)
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert answer.code == 2
    addresses = ["ambient_temperature", "wall_conductance"][len(answers) :]
    assert [error.address for error in answer.error.problems] == addresses
    for address in addresses:
        assert f"Use --{address.replace('_', '-')} " in answer.err
    assert not (tmp_path / "messung.toml").exists()


def test_ctrl_c_at_a_question_ends_like_other_commands(poppet, recording, monkeypatch, tmp_path):
    class Interrupted(Terminal):
        def readline(self, *_):
            raise KeyboardInterrupt

    terminal(monkeypatch)
    monkeypatch.setattr(sys, "stdin", Interrupted())
    answer = poppet("identify", "tank", "--from", "messung.csv", *OPTIONS)
    assert answer.code == 130
    assert not (tmp_path / "messung.toml").exists()
