"""The clean environment is that of a new user: the wheel alone, and a terminal that answers questions."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_program_is_that_of_the_wheel(installed, tmp_path):
    where = installed.run("python", "-c", "import poppet; print(poppet.__file__)", folder=tmp_path)
    assert where.stdout.startswith(str(installed.folder))
    assert str(ROOT) not in where.stdout
    version = installed.run("poppet", "--version", folder=tmp_path)
    assert version.stdout.startswith("poppet ")
    assert list(tmp_path.iterdir()) == []


def test_a_terminal_answers_questions_in_turn(installed, tmp_path):
    script = (
        "import sys; assert sys.stdin.isatty() and sys.stdout.isatty()\n"
        "print(input('volume? '), input('unit? '), input('unit? ')); sys.exit(3)"
    )
    (tmp_path / "ask.py").write_text(script)
    answers = {r"volume\? ": "20 l", r"unit\? ": ["bar", "kPa"]}
    session = installed.on_terminal("python", "ask.py", folder=tmp_path, answers=answers)
    assert session.code == 3
    assert session.text.endswith("20 l bar kPa\n")
    assert session.asked == [r"volume\? ", r"unit\? ", r"unit\? "]
