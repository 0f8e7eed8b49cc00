"""Sankey diagrams: widths of the drawn links, labels, and unusual values."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections import defaultdict
from graphlib import CycleError
from itertools import pairwise

import pytest

from poppet.report.audit.sankey import FLOW_HEIGHT, NARROW, WIDE, SankeyLink, SankeyNode, draw_sankey

SVG = "{http://www.w3.org/2000/svg}"
MACHINE = [
    ("Supplied air", "Machine", 453.0),
    ("Machine", "Work", 120.0),
    ("Machine", "Throttling", 250.0),
    ("Machine", "Stored", 83.0),
    ("Throttling", "valve.supply_a", 150.0),
    ("Throttling", "valve.exhaust_b", 100.0),
    ("Supplied air", "Leaks", 12.0),
]


def drawing(links, width=WIDE):
    links = [SankeyLink(*link) for link in links]
    names = dict.fromkeys(name for link in links for name in link[:2])
    return ET.fromstring(draw_sankey([SankeyNode(name, name) for name in names], links, width))


def widths(svg):
    """Widths of all links at their start and end, by their title."""
    found = {}
    for path in svg.iter(f"{SVG}path"):
        upper, lower = path.get("d")[1:-1].split("L")
        upper, lower = ([float(n) for n in re.findall(r"-?\d+\.?\d*", text)] for text in (upper, lower))
        assert upper[:1] == lower[-2:-1]
        assert upper[-2:-1] == lower[:1]
        found[path.find(f"{SVG}title").text] = (lower[-1] - upper[1], lower[1] - upper[-1])
    return found


@pytest.mark.parametrize("width", [WIDE, NARROW])
def test_widths_are_proportional_to_the_printed_values(width):
    svg = drawing(MACHINE, width)
    scale = FLOW_HEIGHT / 465.0
    assert widths(svg) == {
        f"{source} to {target}: {value:.4g}": pytest.approx((value * scale,) * 2, abs=2e-4)
        for source, target, value in MACHINE
    }


def test_links_fill_their_nodes_without_gap_or_overlap():
    svg = drawing(MACHINE)
    bars = [[float(bar.get(name)) for name in ("x", "y", "width", "height")] for bar in svg.iter(f"{SVG}rect")]
    pieces = defaultdict(list)
    for path in svg.iter(f"{SVG}path"):
        upper, lower = path.get("d")[1:-1].split("L")
        upper, lower = ([float(n) for n in re.findall(r"-?\d+\.?\d*", text)] for text in (upper, lower))
        for x, top, bottom in ((upper[0], upper[1], lower[-1]), (upper[-2], upper[-1], lower[1])):
            middle = 0.5 * (top + bottom)
            bar = next(
                k
                for k, (left, y, width, height) in enumerate(bars)
                if min(abs(x - left), abs(x - left - width)) < 0.02 and y - 0.01 < middle < y + height
            )
            pieces[bar, x].append((top, bottom))
    for (bar, _), ends in pieces.items():
        ends.sort()
        assert ends[0][0] == pytest.approx(bars[bar][1], abs=2e-3)
        assert [top for top, _ in ends[1:]] == pytest.approx([bottom for _, bottom in ends[:-1]], abs=2e-3)
    full = [bar for bar, _ in pieces if sum(bottom - top for top, bottom in pieces[bar, _]) > bars[bar][3] - 2e-3]
    assert set(full) == set(range(len(bars)))


def test_negative_links_flow_back_and_zero_links_are_omitted():
    svg = drawing([("in", "out", 10.0), ("store", "in", -2.0), ("in", "none", 0.0)])
    assert widths(svg).keys() == {"in to out: 10", "in to store: 2"}
    assert [text.findtext(f"{SVG}tspan") for text in svg.iter(f"{SVG}text")] == ["in", "out", "store"]
    assert draw_sankey([SankeyNode("a", "a")], [SankeyLink("a", "b", 0.0)]) == ""


def test_a_link_below_a_pixel_keeps_its_width_and_gets_an_outline():
    svg = drawing([("in", "large", 1000.0), ("in", "small", 1.0)])
    found = widths(svg)
    assert found["in to large: 1000"][0] / found["in to small: 1"][0] == pytest.approx(1000.0, rel=2e-3)
    outlined = [path.findtext(f"{SVG}title") for path in svg.iter(f"{SVG}path") if "stroke" in path.get("style")]
    assert outlined == ["in to small: 1"]


@pytest.mark.parametrize("width", [WIDE, NARROW])
def test_labels_of_ten_small_links_do_not_overlap(width):
    svg = drawing([("in", f"valve_{k}.exhaust", 1.0) for k in range(10)] + [("in", "rest", 1000.0)], width)
    lines = sorted(float(span.get("y")) for text in list(svg.iter(f"{SVG}text"))[1:] for span in text)
    assert min(b - a for a, b in pairwise(lines)) >= 12.5
    height = float(svg.get("height"))
    assert 0.0 < lines[0] < lines[-1] < height


def test_names_are_escaped():
    assert drawing([("a < b", 'c & "d"', 1.0)]).findtext(f".//{SVG}title") == 'a < b to c & "d": 1'


def test_a_circle_of_links_is_rejected():
    with pytest.raises(CycleError):
        drawing([("a", "b", 1.0), ("b", "a", 1.0)])
