"""Grammar of the conditions of step sequences."""

import pytest

from poppet.core.errors import InputError
from poppet.parts.conditions import (
    MAX_DEPTH,
    MAX_LENGTH,
    AllOf,
    AnyOf,
    Flag,
    Internal,
    Literal,
    Names,
    Not,
    Reading,
    Relation,
    parse_condition,
)

NAMES = Names(("stop", "ready"), ("extend A", "A+"))
VALUES = {"a.x": 0.097, "b.x": 0.05, "tank.pressure": 3e5, "other.pressure": 2.8e5, "door.state": 1.0, "plc.step": 2.0}
VALUES |= {"other.step:clamp": 1.0, "elapsed": 0.3, "cycles": 4.0, "count": 5.0, "stop": 0.0, "ready": 1.0}


def parsed(text):
    return parse_condition(text, NAMES, "extend A.next.A+")


def value_of(operand):
    match operand:
        case Literal():
            return operand.number.value
        case Reading():
            return VALUES[operand.address]
        case _:
            return VALUES[operand.name]


def truth(text):
    result = parsed(text).evaluate(value_of)
    assert result in (0.0, 1.0)
    return bool(result)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a.x > 96 mm", True),
        ("a.x>96mm", True),
        ("96 mm < a.x", True),
        ("a.x >= 98 mm", False),
        ("a.x < 98 mm and b.x > 48 mm", True),
        ("a.x > 98 mm or b.x > 48 mm", True),
        # `and` binds more tightly than `or`, and `not` more tightly than `and`.
        ("ready or ready and stop", True),
        ("(ready or ready) and stop", False),
        ("not stop and ready", True),
        ("not (stop and ready)", True),
        ("not ready or stop", False),
        ("not not ready", True),
        ("tank.pressure > 2.9 bar", True),
        ("tank.pressure > other.pressure", True),
        ("tank.pressure > other.pressure + 0.3 bar", False),
        ("tank.pressure > other.pressure - 0.3 bar", True),
        ("tank.pressure < 3e2 kPa", False),
        ("elapsed > 0.2 s", True),
        ("elapsed < 300 ms", False),
        ("elapsed >= 300 ms", True),
        ("elapsed > 300 ms", False),
        ("elapsed <= 300 ms", True),
        ("300 ms <= elapsed", True),
        ("300 ms < elapsed", False),
        ("cycles == 4", True),
        ("cycles != 4", False),
        ('count("extend A") >= 5', True),
        ('5 > count("A+")', False),
        ("door.state", True),
        ("door.state == 1", True),
        ("door.state != 0 and ready == 1", True),
        ("plc.step == 2", True),
        ('other.step == "clamp"', True),
        ('"clamp" == other.step', True),
        ('other.step != "clamp"', False),
        ("a.x > -5 mm", True),
        ("a.x > +5 mm", True),
    ],
)
def test_truth_of_conditions(text, expected):
    assert truth(text) is expected


def test_tree_is_plain_data():
    tree = parsed('a.x > 98 mm and (elapsed >= 0.5 s or not stop) or count("A+") == 3').tree
    assert isinstance(tree, AnyOf)
    both, counted = tree.terms
    assert isinstance(both, AllOf)
    position, either = both.terms
    assert isinstance(position, Relation)
    assert position.left == Reading("a.x", "m")
    assert position.relation == ">"
    assert (position.right.number.value, position.right.number.unit) == (0.098, "m")
    assert either.terms[1] == Not(Flag("stop"))
    assert counted.left == Internal("count", "A+")


def test_numbers_are_parameters_except_integers_of_equalities():
    condition = parsed("a.x > 98 mm and plc.step == 2 and elapsed > 0.5 s")
    assert {x.place: x.number.value for x in condition.literals()} == {
        "extend A.next.A+.1": 0.098, "extend A.next.A+.2": 0.5,
    }  # fmt: skip
    assert [x.place for x in parsed("a.x > 98 mm").literals()] == ["extend A.next.A+"]


@pytest.mark.parametrize(
    ("text", "changes", "expected"),
    [
        ("a.x > 98 mm", {"extend A.next.A+": "95 mm"}, "a.x > 95 mm"),
        ("a.x > 98 mm and elapsed < 1 s", {"extend A.next.A+.2": "2 s"}, "a.x > 98 mm and elapsed < 2 s"),
        ("a.pressure > b.pressure - 1 bar", {"extend A.next.A+": "2 bar"}, "a.pressure > b.pressure +2 bar"),
    ],
)
def test_text_with_other_numbers(text, changes, expected):
    condition = parsed(text)
    numbers = {x.place: x.number for x in condition.literals()}
    for place, new in changes.items():
        quantity = "p" if "bar" in new else "x"
        numbers[place] = parsed(f"{quantity}.v > {new}").literals()[0].number
    assert condition.with_text(numbers) == expected
    assert parsed(expected).literals()[-1].number.value == list(numbers.values())[-1].value


@pytest.mark.parametrize(
    ("text", "code", "column"),
    [
        ("", "empty", 1),
        ("a.x >", "no_operand", 6),
        ("a.x > 98 mm and", "no_operand", 16),
        ("and ready", "no_operand", 1),
        ("elapsed", "no_relation", 8),
        ("5 mm", "no_relation", 5),
        ("ready stop", "no_end", 7),
        ("ready)", "closing", 6),
        ("(ready or stop", "no_bracket", 15),
        ("1 mm < a.x < 2 mm", "chained", 12),
        ("a.x = 5 mm", "character", 5),
        ("ready && stop", "character", 7),
        ('other.step == "clamp', "character", 15),
        ("a.x > 98 furlong", "no_value", 7),
        ("a.x > 0,5 m", "no_value", 7),
        ("count(A+) > 3", "no_count", 1),
        ('count("A-") > 3', "unknown_step", 7),
        ("redy", "unknown_name", 1),
        ('a.x > "clamp"', "no_step", 7),
        ("5 mm > 3 mm", "constant", 1),
        ("a.u > b.v", "no_unit", 1),
        ("elapsed > 5 bar", "other_unit", 11),
        ("tank.pressure > other.pressure + 5 bar g", "no_value", 32),
        ("elapsed == 5 s", "no_integers", 1),
        ("a.x == 5 mm", "no_integers", 1),
        ("ready == 0.5", "no_integers", 1),
        ("a.x > 5 mm + 3 mm", "no_offset", 12),
        ("tank.pressure > other.pressure + ready", "no_number", 34),
        ("__import__('os')", "character", 12),
        ("not " * (MAX_DEPTH + 1) + "ready", "too_deep", 4 * MAX_DEPTH + 1),
        ("(" * 400 + "ready", "too_deep", MAX_DEPTH + 1),
    ],
)
def test_invalid_conditions(text, code, column):
    with pytest.raises(InputError) as caught:
        parsed(text)
    assert (caught.value.code, caught.value.facts["column"]) == (f"condition.{code}", column)
    assert caught.value.address == "extend A.next.A+"
    assert str(caught.value)


def test_limits_and_type():
    with pytest.raises(InputError) as caught:
        parsed("ready or " * MAX_LENGTH + "ready")
    assert caught.value.code == "condition.too_long"
    with pytest.raises(InputError) as caught:
        parsed(5)
    assert caught.value.code == "condition.no_text"
