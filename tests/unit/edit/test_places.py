"""Positions of parts without one: complete, apart from each other, and below the positions of the file."""

from __future__ import annotations

import tomllib
from itertools import combinations
from pathlib import Path

import pytest

from poppet.edit.document import Document
from poppet.edit.places import SIZE, places_of

EXAMPLES = Path(__file__).parents[3] / "examples"
FILES = {
    path.name: text
    for path in sorted(EXAMPLES.glob("*.toml"))
    if "parts" in tomllib.loads(text := path.read_text(encoding="utf-8"))
}


def assert_apart(places):
    for a, b in combinations(places.values(), 2):
        assert abs(a["x"] - b["x"]) >= SIZE[0] or abs(a["y"] - b["y"]) >= SIZE[1]


@pytest.mark.parametrize("file", FILES)
def test_parts_do_not_overlap(file):
    document = Document(FILES[file])
    places = places_of(document.view())
    assert {*places} == {*document.view()["parts"]}
    assert_apart(places)
    names = [*places]
    moved = document.apply([{"op": "place", "part": names[0], "x": 0, "y": 7, "rotation": 90}])
    places = places_of(moved.view())
    assert places[names[0]] == {"x": 0, "y": 7, "rotation": 90}
    assert_apart(places)
    assert all(places[name]["y"] > 7 for name in names[1:])


@pytest.mark.parametrize(
    "text",
    [
        "",
        '[parts.a]\nkind = "mass"\n',
        '[parts.a]\nkind = "orifice"\nfrom = "a"\nto = "none"\n[drawing]\na = 3\nb = 1\n',
    ],
)
def test_incomplete_circuits(text):
    view = Document(text).view()
    assert {*places_of(view)} == {*view["parts"]}


def test_a_long_chain_is_divided_into_rows():
    parts = [
        f'[parts.tank_{k}]\nkind = "chamber"\n'
        f'[parts.hole_{k}]\nkind = "orifice"\nfrom = "tank_{k - 1}"\nto = "tank_{k}"\n'
        for k in range(1, 31)
    ]
    view = Document('[parts.tank_0]\nkind = "reservoir"\n' + "".join(parts)).view()
    places = places_of(view, dict.fromkeys(view["parts"], (10.0, 12.0)))
    for a, b in combinations(places.values(), 2):
        assert abs(a["x"] - b["x"]) >= 10 or abs(a["y"] - b["y"]) >= 12
    width, height = (max(place[key] for place in places.values()) for key in "xy")
    assert 0.8 < width / height < 3.2
