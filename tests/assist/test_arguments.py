"""Arguments of functions: schema and check from one declaration in the signature."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated

import jsonschema
import pytest

from poppet.assist.arguments import Argument, arguments_schema, read_arguments
from poppet.assist.functions import FUNCTIONS
from poppet.assist.replies import number, plain, quantity
from poppet.core.codes import Note
from poppet.core.errors import InputError


def example(
    folder: str,
    name: Annotated[str, Argument("name; of a part", longest=5)],
    count: Annotated[int, Argument("count", low=1, high=3)] = 2,
    size: Annotated[float, Argument("size", low=0.0)] = 1.0,
    is_large: Annotated[bool, Argument("large or not")] = False,
    words: Annotated[Sequence[str], Argument("words", choices=("a", "b"), longest=2)] = (),
    values: Annotated[Mapping[str, str | float], Argument("values")] = {},
) -> dict:
    return locals()


VALID = [
    {"name": "x"},
    {
        "name": "x",
        "count": 3,
        "size": 0,
        "is_large": True,
        "words": ["a"],
        "values": {"a.b": "1 l", "c": 2.5, "d": True},
    },
    {"name": "x", "count": None},
]
INVALID = [
    ({}, "fields.missing", "name"),
    ({"name": 1}, "fields.other_type", "name"),
    ({"name": "long name"}, "assist.too_long", "name"),
    ({"name": "x", "nam": 1}, "fields.unknown", "nam"),
    ({"name": "x", "count": 4}, "fields.out_of_range", "count"),
    ({"name": "x", "count": 1.0}, "fields.other_type", "count"),
    ({"name": "x", "count": True}, "fields.other_type", "count"),
    ({"name": "x", "size": -1}, "fields.out_of_range", "size"),
    ({"name": "x", "size": float("nan")}, "fields.other_type", "size"),
    ({"name": "x", "size": 10**400}, "fields.out_of_range", "size"),
    ({"name": "x", "is_large": "yes"}, "fields.other_type", "is_large"),
    ({"name": "x", "words": "a"}, "fields.other_type", "words"),
    ({"name": "x", "words": ["c"]}, "fields.not_an_option", "words[0]"),
    ({"name": "x", "words": ["a", "b", "a"]}, "assist.too_long", "words"),
    ({"name": "x", "values": []}, "fields.other_type", "values"),
    ({"name": "x", "values": {"a.b": [1]}}, "fields.other_type", "values.a.b"),
    ({"name": "x", "values": {"a.b": 1e31}}, "fields.other_type", "values.a.b"),
]


def test_the_schema_and_the_check_accept_the_same_values():
    schema = arguments_schema(example)
    assert schema["required"] == ["name"]
    assert "folder" not in schema["properties"]
    for arguments in VALID:
        jsonschema.validate({k: v for k, v in arguments.items() if v is not None}, schema)
        assert example("", **read_arguments(example, arguments))["name"] == "x"


@pytest.mark.parametrize(("arguments", "code", "address"), INVALID)
def test_invalid_values_have_code_and_address(arguments, code, address):
    with pytest.raises(InputError) as caught:
        read_arguments(example, arguments)
    assert (caught.value.code, caught.value.address) == (code, address)
    assert len(str(caught.value)) < 400
    assert caught.value.hint


def test_all_errors_are_reported_together():
    with pytest.raises(InputError) as caught:
        read_arguments(example, {"count": 9, "words": ["x", "y"], "sizes": 1})
    codes = [problem.code for problem in caught.value.problems]
    assert codes == [
        "fields.unknown", "fields.missing", "fields.out_of_range", "fields.not_an_option", "fields.not_an_option"
    ]  # fmt: skip


def test_all_schemas_are_valid():
    for function in FUNCTIONS.values():
        jsonschema.Draft202012Validator.check_schema(function.schema)


def test_results_are_values_of_json():
    assert quantity(1.0 / 3.0, "") == {"value": 0.3333333333, "unit": "1"}
    assert [number(value) for value in (float("nan"), float("inf"), float("-inf"))] == [None, "inf", "-inf"]
    note = Note("said", text="Recorded on a cold morning.")
    assert plain({"a": (1, True, None), "b": note})["b"]["text"] == str(note)
    content = plain({"rows": list(range(250)), "short": [1]})
    assert (len(content["rows"]), content["rows_count"], "short_count" in content) == (100, 250, False)
