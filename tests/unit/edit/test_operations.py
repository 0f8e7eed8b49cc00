"""Operations on the text of a circuit file: what changes, and what does not."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from poppet import loads
from poppet.edit.document import Document
from refusals import refused

BENCH = """\
# A bench
title = "Bench"  # shown with every result

# the supply,
# regulated
[parts.supply]  # header
kind = "reservoir"
pressure = "6 bar g"    # gauge

# valve to the tank
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
sonic_conductance = "0.5 dm^3/(s bar)"
critical_ratio = 0.35

[parts.tank]
kind = "chamber"
volume = { value = "10 l", source = "measured" }  # filled with water
# initial_pressure = "2 bar"

# Signals
[signals."valve.command"]
kind = "steps"
times = ["0 s", "1 s"]
values = [0, 1]

[run]
duration = "10 s"
stop_when = ["tank.pressure > 5 bar", "valve.position > 0.5"]
"""


def edited(text: str, *operations: dict[str, Any]) -> str:
    return Document(text).apply(operations).text


def lines_of_change(before: str, after: str) -> tuple[list[str], list[str]]:
    """Lines that are removed and lines that are added, in their order."""
    import difflib

    lines = list(difflib.ndiff(before.splitlines(), after.splitlines()))
    return [x[2:] for x in lines if x[0] == "-"], [x[2:] for x in lines if x[0] == "+"]


def change(*operations: dict[str, Any], text: str = BENCH) -> tuple[list[str], list[str]]:
    after = edited(text, *operations)
    crlf = edited(text.replace("\n", "\r\n"), *operations)
    assert crlf == after.replace("\n", "\r\n")
    tomllib.loads(after)
    return lines_of_change(text, after)


# --- Set ---


@pytest.mark.parametrize(
    ("address", "value", "old", "new"),
    [
        ("supply.pressure", "7 bar g", 'pressure = "6 bar g"    # gauge', 'pressure = "7 bar g"    # gauge'),
        ("parts.supply.pressure", 7e5, 'pressure = "6 bar g"    # gauge', "pressure = 700000.0    # gauge"),
        (
            "title", 'A "B"', 'title = "Bench"  # shown with every result',
            'title = "A \\"B\\""  # shown with every result',
        ),
        ("run.duration", "1 s", 'duration = "10 s"', 'duration = "1 s"'),
        (
            "tank.volume.value", "11 l", 'volume = { value = "10 l", source = "measured" }  # filled with water',
            'volume = { value = "11 l", source = "measured" }  # filled with water',
        ),
    ],
)  # fmt: skip
def test_set_changes_one_line(address, value, old, new):
    assert change({"op": "set", "address": address, "value": value}) == ([old], [new])


@pytest.mark.parametrize(
    ("address", "value", "line", "above"),
    [
        ("supply.temperature", "25 degC", 'temperature = "25 degC"', 'pressure = "6 bar g"    # gauge'),
        (
            "tank.thermal", "isothermal", 'thermal = "isothermal"',
            'volume = { value = "10 l", source = "measured" }  # filled with water',
        ),
        ("run.output_step", 0.5, "output_step = 0.5", 'stop_when = ["tank.pressure > 5 bar", "valve.position > 0.5"]'),
        ("valve.spring.rate", 3, "spring.rate = 3", "critical_ratio = 0.35"),
    ],
)  # fmt: skip
def test_a_new_field_is_the_last_one_of_its_table(address, value, line, above):
    after = edited(BENCH, {"op": "set", "address": address, "value": value})
    assert lines_of_change(BENCH, after) == ([], [line])
    lines = after.splitlines()
    assert lines[lines.index(line) - 1] == above


def test_null_removes_a_field():
    assert change({"op": "set", "address": "valve.critical_ratio", "value": None}) == (["critical_ratio = 0.35"], [])
    assert change({"op": "set", "address": "tank.height", "value": None}) == ([], [])


def test_null_removes_a_member_of_an_inline_table():
    removed, added = change({"op": "set", "address": "tank.volume.value", "value": None})
    assert added == ['volume = { source = "measured" }  # filled with water']
    assert len(removed) == 1
    _, added = change({"op": "set", "address": "tank.volume.source", "value": None})
    assert added == ['volume = { value = "10 l" }  # filled with water']


def test_sections_have_the_usual_order():
    after = edited(BENCH, {"op": "set", "address": "ambient.pressure", "value": "1 bar"})
    assert lines_of_change(BENCH, after) == ([], ["[ambient]", 'pressure = "1 bar"', ""])
    assert after.index("values = [0, 1]") < after.index("[ambient]") < after.index("[run]")


def test_title_of_a_file_without_one():
    text = "# Comment\n\n[run]\nduration = 1\n"
    after = edited(text, {"op": "set", "address": "title", "value": "T"})
    assert after == '# Comment\n\ntitle = "T"\n\n[run]\nduration = 1\n'
    assert edited("", {"op": "set", "address": "title", "value": "T"}) == 'title = "T"\n'


def test_a_value_replaces_a_table_with_a_header():
    text = '[gas]\nname = "air"  # dry\n\n[run]\nduration = 1\n'
    after = edited(text, {"op": "set", "address": "gas", "value": "helium"})
    assert tomllib.loads(after) == {"gas": "helium", "run": {"duration": 1}}
    with refused("edit.no_table", "gas"):
        edited(after, {"op": "set", "address": "gas.name", "value": "air"})


def test_names_of_steps_can_contain_dots():
    text = '[parts.plc]\nkind = "sequence"\n[parts.plc.steps."v1.0"]\ntimeout = { after = "1 s", to = "x" }\n'
    after = edited(text, {"op": "set", "address": "plc.steps.v1.0.timeout.after", "value": "2 s"})
    assert lines_of_change(text, after)[1] == ['timeout = { after = "2 s", to = "x" }']


@pytest.mark.parametrize("value", [[1, "2 bar"], {"value": 1, "source": "measured"}, True, -0.0, 2**63 - 1, "a\tb"])
def test_values_are_read_as_they_were_set(value):
    after = edited(BENCH, {"op": "set", "address": "tank.x", "value": value})
    assert tomllib.loads(after)["parts"]["tank"]["x"] == value


# --- Forms of TOML ---

FORMS = {
    "headers": '[parts.a]\nkind = "chamber"\nvolume = 1\n\n[parts.b]\nkind = "chamber"\n',
    "out of order": '[parts.a]\nkind = "chamber"\nvolume = 1\n[run]\nduration = 1\n[parts.b]\nkind = "chamber"\n',
    "dotted": 'parts.a.kind = "chamber"\nparts.a.volume = 1\nparts.b.kind = "chamber"\n',
    "inline": 'parts = { a = { kind = "chamber", volume = 1 }, b = { kind = "chamber" } }\n',
    "inline parts": '[parts]\na = { kind = "chamber", volume = 1 }\nb = { kind = "chamber" }\n',
    "inline dotted": 'parts = { a.kind = "chamber", a.volume = 1, b.kind = "chamber" }\n',
    "half dotted": '[parts]\na.kind = "chamber"\na.volume = 1\nb.kind = "chamber"\n',
    "quoted": '[ "parts" . \'a\' ]\n"kind" = "chamber"\n"volume" = 1\n["parts"."b"]\nkind = "chamber"\n',
    "without last line ending": '[parts.a]\nkind = "chamber"\nvolume = 1\n[parts.b]\nkind = "chamber"',
    "indented": '  [parts.a]\n    kind = "chamber"\n    volume = 1\n  [parts.b]\n    kind = "chamber"\n',
}


@pytest.mark.parametrize("text", FORMS.values(), ids=FORMS)
def test_all_forms_of_tables(text):
    content = tomllib.loads(text)
    for line_ending in ("\n", "\r\n"):
        own = text.replace("\n", line_ending)

        def parts(*operations: dict[str, Any], own: str = own, line_ending: str = line_ending) -> Any:
            after = edited(own, *operations)
            assert after.count("\n") == after.count("\r\n") or line_ending == "\n"
            result = tomllib.loads(after)
            assert {k: v for k, v in result.items() if k != "parts"} == {
                k: v for k, v in content.items() if k != "parts"
            }
            return result["parts"]

        a, b = content["parts"]["a"], content["parts"]["b"]
        assert parts({"op": "set", "address": "a.volume", "value": 2}) == {"a": a | {"volume": 2}, "b": b}
        assert parts({"op": "set", "address": "b.volume", "value": 2}) == {"a": a, "b": b | {"volume": 2}}
        assert parts({"op": "set", "address": "a.volume", "value": None}) == {"a": {"kind": "chamber"}, "b": b}
        assert parts({"op": "set", "address": "a.g.x", "value": 2}) == {"a": a | {"g": {"x": 2}}, "b": b}
        assert parts({"op": "rename", "part": "a", "name": "c"}) == {"c": a, "b": b}
        assert parts({"op": "remove", "parts": ["a"]}) == {"b": b}
        assert parts({"op": "remove", "parts": ["b"]}) == {"a": a}
        assert parts({"op": "add", "kind": "mass"}) == {"a": a, "b": b, "mass": {"kind": "mass"}}
        group = [{"op": "set", "address": f"a.g.{key}", "value": 1} for key in "xy"]
        assert parts(*group) == {"a": a | {"g": {"x": 1, "y": 1}}, "b": b}
        renamed = edited(own, {"op": "rename", "part": "a", "name": "c"})
        assert edited(renamed, {"op": "rename", "part": "c", "name": "a"}) == own


def test_a_group_with_a_header_of_its_own():
    text = '[parts.v.spring]\nrate = 1\n\n[parts.w]\nkind = "mass"\n'
    after = edited(text, {"op": "set", "address": "v.kind", "value": "main_stage"})
    assert after == '[parts.v]\nkind = "main_stage"\n\n' + text
    after = edited(text, {"op": "set", "address": "v.spring.preload", "value": 2})
    assert after == text.replace("rate = 1\n", "rate = 1\npreload = 2\n")


# --- Add and remove ---


def test_a_part_is_added_behind_the_last_one():
    after = edited(BENCH, {"op": "add", "kind": "orifice"})
    assert lines_of_change(BENCH, after) == ([], ["[parts.orifice]", 'kind = "orifice"', ""])
    assert after.index('# initial_pressure = "2 bar"') < after.index("[parts.orifice]") < after.index("# Signals")
    again = edited(after, {"op": "add", "kind": "orifice"}, {"op": "add", "kind": "orifice", "name": "bleed"})
    assert [*tomllib.loads(again)["parts"]] == ["supply", "valve", "tank", "orifice", "orifice_2", "bleed"]


def test_the_first_part():
    assert edited("", {"op": "add", "kind": "mass"}) == '[parts.mass]\nkind = "mass"\n'
    text = "# Comment\n\n# run it\n[run]\nduration = 1\n"
    after = edited(text, {"op": "add", "kind": "mass", "place": {"x": 1, "y": 2.5}})
    assert after == (
        '# Comment\n\n[parts.mass]\nkind = "mass"\n\n# run it\n[run]\nduration = 1\n'
        "\n[drawing]\nmass = { x = 1, y = 2.5 }\n"
    )


def test_a_removed_part_takes_its_comments_and_its_connections():
    removed, added = change({"op": "remove", "parts": ["valve"]})
    assert added == ['stop_when = ["tank.pressure > 5 bar"]']
    assert "# valve to the tank" in removed
    assert '[signals."valve.command"]' in removed
    assert "# Signals" in removed  # directly above the removed signal
    removed, _ = change({"op": "remove", "parts": ["supply"]})
    assert {"# the supply,", "# regulated", "[parts.supply]  # header"} < {*removed}
    assert 'supply = "supply"' in removed


def test_add_and_remove_is_the_same_text():
    added = {"op": "add", "kind": "orifice", "name": "new"}
    assert edited(BENCH, added, {"op": "remove", "parts": ["new"]}) == BENCH


def test_all_parts_removed():
    after = edited(BENCH, {"op": "remove", "parts": ["supply", "valve", "tank"]})
    assert tomllib.loads(after) == {"title": "Bench", "run": {"duration": "10 s"}}
    assert after.startswith("# A bench\n")


def test_conditions_of_sequences_remain_and_are_errors():
    text = (
        '[parts.tank]\nkind = "chamber"\nvolume = 1\n\n[parts.plc]\nkind = "sequence"\noutputs = ["a"]\nstart = "x"\n'
        '[parts.plc.steps.x]\nnext = { y = "tank.pressure > 2 bar", z = "tank.pressure >" }\n'
        '[parts.switch]\nkind = "switch"\nmeasurement = "tank.pressure"\n'
    )
    after = edited(text, {"op": "remove", "parts": ["tank"]})
    assert lines_of_change(text, after)[0][-1] == 'measurement = "tank.pressure"'
    assert 'y = "tank.pressure > 2 bar"' in after


# --- Ports, signals, connections ---


def test_connect_and_disconnect():
    to = {"op": "connect", "port": "valve.exhaust", "to": "ambient"}
    assert change(to) == ([], ['exhaust = "ambient"'])
    assert change({"op": "connect", "port": "supply", "to": "valve.outlet"}) == (
        ['outlet = "tank"'],
        ['outlet = "supply"'],
    )
    assert change({"op": "disconnect", "port": "valve.outlet"}) == (['outlet = "tank"'], [])
    assert edited(BENCH, to, {"op": "disconnect", "port": "valve.exhaust"}) == BENCH


def test_the_end_of_a_tube_and_a_port_name_each_other():
    text = BENCH + '\n[parts.hose]\nkind = "tube"\nto = "tank"\n'
    for ends in (("hose.from", "valve.outlet"), ("valve.outlet", "hose.from")):
        after = edited(text, {"op": "connect", "port": ends[0], "to": ends[1]})
        parts = tomllib.loads(after)["parts"]
        assert (parts["hose"]["from"], parts["valve"]["outlet"]) == ("valve.outlet", "hose")
        for port in ends:
            alone = tomllib.loads(edited(after, {"op": "disconnect", "port": port}))["parts"]
            assert "from" not in alone["hose"]
            assert "outlet" not in alone["valve"]


@pytest.mark.parametrize(
    ("port", "to", "lost"),
    [
        ("hose.from", "tank", "valve.outlet"),
        ("valve.outlet", "tank", "hose.from"),
        ("hose.from", "second.outlet", "valve.outlet"),
        ("valve.outlet", "second_hose.to", "hose.from"),
    ],
)
def test_a_new_connection_ends_the_former_one_at_both_ports(port, to, lost):
    names = {"second": "directional_valve", "hose": "tube", "second_hose": "tube"}
    operations = [{"op": "add", "kind": kind, "name": name} for name, kind in names.items()]
    first = {"op": "connect", "port": "hose.from", "to": "valve.outlet"}
    parts = tomllib.loads(edited(BENCH, *operations, first, {"op": "connect", "port": port, "to": to}))["parts"]
    owner, _, name = lost.partition(".")
    assert name not in parts[owner]
    owner, _, name = port.partition(".")
    assert parts[owner][name] in (to, to.partition(".")[0])


def test_ports_that_cannot_be_connected():
    text = edited(BENCH, {"op": "add", "kind": "orifice"})
    with refused("edit.two_ports", port="valve.outlet", to="orifice.from"):
        edited(text, {"op": "connect", "port": "valve.outlet", "to": "orifice.from"})
    with refused("fields.not_an_option", "valve.outlett", value="outlett"):
        edited(text, {"op": "connect", "port": "valve.outlett", "to": "tank"})
    with refused("edit.no_port", port="supply", to="tank"):
        edited(text, {"op": "connect", "port": "supply", "to": "tank"})
    with refused("names.unknown", "tonk"):
        edited(text, {"op": "connect", "port": "valve.outlet", "to": "tonk"})


def test_body_and_open_member():
    text = '[parts.cylinder]\nkind = "cylinder"\n[parts.load]\nkind = "mass"\n[parts.hole]\nkind = "orifice"\n'
    after = edited(
        text,
        {"op": "connect", "port": "cylinder.body", "to": "load"},
        {"op": "connect", "port": "hole.from", "to": "cylinder.cap"},
    )
    parts = tomllib.loads(after)["parts"]
    assert (parts["cylinder"]["body"], parts["hole"]["from"]) == ("load", "cylinder.cap")


def test_signals():
    steps = {"kind": "steps", "times": ["0 s", "2 s"], "values": [0, 1]}
    assert change({"op": "signal", "address": "valve.command", "table": steps}) == (
        ['times = ["0 s", "1 s"]'], ['times = ["0 s", "2 s"]'],
    )  # fmt: skip
    ramp = {"op": "signal", "address": "supply.pressure", "table": {"kind": "ramp", "start": 1.0}}
    assert change(ramp) == ([], ['[signals."supply.pressure"]', 'kind = "ramp"', "start = 1.0", ""])
    assert edited(BENCH, ramp, {"op": "signal", "address": "supply.pressure", "table": None}) == BENCH
    constant = edited(BENCH, {"op": "signal", "address": "supply.pressure", "table": "7 bar"})
    assert tomllib.loads(constant)["signals"]["supply.pressure"] == "7 bar"
    removed, added = change({"op": "signal", "address": "valve.command", "table": None})
    assert (removed[:2], added) == (["# Signals", '[signals."valve.command"]'], [])


@pytest.mark.parametrize(
    "signals",
    [
        '[signals.valve.command]\nkind = "steps"\n',
        '[signals.valve]\ncommand = { kind = "steps" }\n',
        '[signals]\nvalve.command.kind = "steps"\n',
        '[signals]\n"valve.command" = 0.5\n',
        'signals = { "valve.command" = 0.5 }\n',
    ],
)
def test_all_forms_of_signals(signals):
    text = ("" if signals[0] == "[" else signals) + '[parts.valve]\nkind = "directional_valve"\n'
    text += signals if signals[0] == "[" else ""
    pulse = {"kind": "pulse", "width": 1}
    after = edited(text, {"op": "signal", "address": "valve.command", "table": pulse})
    view = Document(after).view()
    assert view["signals"] == {"valve.command": pulse}
    assert Document(edited(after, {"op": "signal", "address": "valve.command", "table": None})).view()["signals"] == {}
    renamed = Document(edited(after, {"op": "rename", "part": "valve", "name": "v"})).view()
    assert renamed["signals"] == {"v.command": pulse}


@pytest.mark.parametrize(
    "group",
    [
        '[parts.valve.cushion]  # group\nlength = "20 mm"\n',
        'cushion = { length = "20 mm" }\n',
        'cushion.length = "20 mm"\n',
    ],
)
def test_the_last_field_of_a_group_takes_the_group_with_it(group):
    text = BENCH.replace("[parts.tank]\n", f"{group}\n[parts.tank]\n")
    parts = tomllib.loads(edited(text, {"op": "set", "address": "valve.cushion.length", "value": None}))["parts"]
    assert parts == tomllib.loads(BENCH)["parts"]


def test_the_last_field_of_a_part_or_section_leaves_it():
    text = '[parts.hole]\nkind = "orifice"\n\n[run]\nduration = "1 s"\n'
    after = edited(text, {"op": "set", "address": "hole.kind", "value": None})
    assert tomllib.loads(edited(after, {"op": "set", "address": "run.duration", "value": None})) == {
        "parts": {"hole": {}},
        "run": {},
    }


def test_links():
    link = {"op": "link", "input": "valve.command", "output": "tank.pressure"}
    signal = ['[signals."valve.command"]', 'kind = "steps"', 'times = ["0 s", "1 s"]', "values = [0, 1]"]
    removed, added = change(link)
    assert [line for line in removed if line and line[0] != "#"] == signal  # an input has one source
    assert added == ["[connections]", '"valve.command" = "tank.pressure"']
    assert tomllib.loads(edited(BENCH, link))["connections"] == {"valve.command": "tank.pressure"}
    other = {"op": "link", "input": "valve.command", "output": "supply.pressure"}
    assert tomllib.loads(edited(BENCH, link, other))["connections"] == {"valve.command": "supply.pressure"}
    assert (
        "connections" not in Document(edited(BENCH, link, {"op": "unlink", "input": "valve.command"})).view()["parts"]
    )
    nested = BENCH + '\n[connections.valve]\ncommand = "tank.pressure"  # loop\n'
    assert edited(nested, other).endswith('command = "supply.pressure"  # loop\n')
    with refused("names.unknown", "tonk"):
        edited(BENCH, {"op": "link", "input": "valve.command", "output": "tonk.pressure"})


def test_a_signal_replaces_a_link():
    link = {"op": "link", "input": "valve.command", "output": "tank.pressure"}
    for table in ({"kind": "constant", "value": 1}, 1):
        after = tomllib.loads(edited(BENCH, link, {"op": "signal", "address": "valve.command", "table": table}))
        assert after["signals"] == {"valve.command": table}
        assert not after.get("connections")


def test_a_field_that_names_an_output_is_the_link():
    text = BENCH + '\n[parts.sensor]\nkind = "switch"\nmeasurement = "tank.pressure"  # port 2\n'
    after = edited(text, {"op": "link", "input": "sensor.measurement", "output": "supply.pressure"})
    assert after.endswith('measurement = "supply.pressure"  # port 2\n')
    assert "measurement" not in edited(after, {"op": "unlink", "input": "sensor.measurement"})


# --- Drawing and paste ---


def test_only_the_drawing_changes_if_a_part_is_moved():
    place = {"op": "place", "part": "tank", "x": 12.0, "y": 4.5, "rotation": 90}
    after = edited(BENCH, place)
    assert after == BENCH + "\n[drawing]\ntank = { x = 12, y = 4.5, rotation = 90 }\n"
    moved = edited(after, {"op": "place", "part": "tank", "x": 13, "y": 4})
    assert moved == BENCH + "\n[drawing]\ntank = { x = 13, y = 4, rotation = 90 }\n"
    turned = edited(moved, {"op": "place", "part": "tank", "x": 13, "y": 4, "rotation": 0, "mirror": True})
    assert turned == BENCH + "\n[drawing]\ntank = { x = 13, y = 4, mirror = true }\n"
    header = BENCH + "\n[drawing.tank]\nx = 1  # left\ny = 2\n"
    assert edited(header, {"op": "place", "part": "tank", "x": 3, "y": 2}) == header.replace("x = 1", "x = 3")


@pytest.mark.parametrize("place", [{"x": float("nan"), "y": 0}, {"x": 0, "y": 1e9}, {"x": 0, "y": 0, "rotation": 45}])
def test_positions_outside_the_drawing(place):
    with refused("edit.no_position", "drawing.tank"):
        edited(BENCH, {"op": "place", "part": "tank", **place})


ROUTE = {"op": "route", "port": "valve.outlet", "points": [[12.0, 4], [12, 8.5]]}
LINE = '"valve.outlet" = { points = [[12, 4], [12, 8.5]] }'


def test_only_the_drawing_changes_if_a_wire_has_points():
    after = edited(BENCH, ROUTE)
    assert after == BENCH + f"\n[drawing]\n{LINE}\n"
    assert change(ROUTE | {"points": [[1, 2]]}, text=after) == ([LINE], ['"valve.outlet" = { points = [[1, 2]] }'])
    assert change(ROUTE | {"points": None}, text=after) == ([LINE], [])
    placed = edited(after, {"op": "place", "part": "valve", "x": 1, "y": 2})
    assert placed == after + "valve = { x = 1, y = 2 }\n"
    loads(placed)


@pytest.mark.parametrize("points", [[], [[1]], [[1, 2, 3]], [1, 2], [["1", 2]], [[1, float("nan")]], [[1e9, 0]]])
def test_points_that_are_none(points):
    with refused("edit.no_points", "drawing.valve.outlet"):
        edited(BENCH, ROUTE | {"points": points})


@pytest.mark.parametrize(
    ("operation", "lines"),
    [
        ({"op": "rename", "part": "valve", "name": "v"}, [LINE.replace("valve", "v")]),
        ({"op": "rename", "part": "tank", "name": "t"}, [LINE]),
        ({"op": "remove", "parts": ["valve"]}, []),
        ({"op": "remove", "parts": ["tank"]}, []),
        ({"op": "disconnect", "port": "valve.outlet"}, []),
        ({"op": "disconnect", "port": "valve.supply"}, [LINE]),
        ({"op": "connect", "port": "valve.outlet", "to": "tank"}, [LINE]),
        ({"op": "connect", "port": "valve.outlet", "to": "supply"}, []),
    ],
)
def test_points_follow_their_wire(operation, lines):
    after = edited(BENCH, ROUTE, operation)
    assert [line for line in after.splitlines() if "points" in line] == lines


def test_points_of_tubes_and_signals_follow_their_wire():
    text = edited(
        BENCH,
        {"op": "add", "kind": "tube", "name": "hose"},
        {"op": "connect", "port": "hose.from", "to": "valve.outlet"},
    )
    both = [{"op": "route", "port": port, "points": [[1, 2]]} for port in ("hose.from", "valve.outlet")]
    assert edited(text, *both).count("points") == 2
    assert edited(text, *both, {"op": "disconnect", "port": "valve.outlet"}).count("points") == 0
    assert edited(text, *both, {"op": "connect", "port": "hose.from", "to": "tank"}).count("points") == 0
    link = {"op": "link", "input": "valve.command", "output": "tank.pressure"}
    linked = edited(BENCH, link, {"op": "route", "port": "valve.command", "points": [[1, 2]]})
    assert edited(linked, link) == linked
    for operation in (
        link | {"output": "supply.pressure"},
        {"op": "unlink", "input": "valve.command"},
        {"op": "remove", "parts": ["tank"]},
    ):
        assert "points" not in edited(linked, operation)


def test_copies_have_the_points_of_their_wires():
    parts = {name: tomllib.loads(BENCH)["parts"][name] for name in ("valve", "tank")}
    drawing = {"valve.outlet": {"points": [[3, 4]]}, "supply.x": {"points": [[5, 6]]}}
    after = edited(BENCH, {"op": "paste", "parts": parts, "drawing": drawing})
    assert tomllib.loads(after)["drawing"] == {"valve_2.outlet": {"points": [[3, 4]]}}
    link = {"op": "link", "input": "valve_2.command", "output": "tank_2.pressure"}
    linked = edited(BENCH, {"op": "paste", "parts": parts, "drawing": {"valve.command": {"points": [[3, 4]]}}}, link)
    assert tomllib.loads(linked)["drawing"] == {"valve_2.command": {"points": [[3, 4]]}}
    with refused("edit.no_points", "drawing.valve_2.outlet"):
        edited(BENCH, {"op": "paste", "parts": parts, "drawing": {"valve.outlet": {"x": 1, "y": 2}}})


def test_copies_are_connected_among_themselves():
    parts = {name: tomllib.loads(BENCH)["parts"][name] for name in ("valve", "tank")}
    after = edited(BENCH, {"op": "paste", "parts": parts, "drawing": {"tank": {"x": 1, "y": 2}}})
    content = tomllib.loads(after)
    assert [*content["parts"]] == ["supply", "valve", "tank", "valve_2", "tank_2"]
    assert content["parts"]["valve_2"]["outlet"] == "tank_2"
    assert "supply" not in content["parts"]["valve_2"]
    assert content["parts"]["tank_2"] == parts["tank"]
    assert content["drawing"] == {"tank_2": {"x": 1, "y": 2}}
    again = tomllib.loads(edited(after, {"op": "paste", "parts": {"tank_2": parts["tank"]}}))
    assert [*again["parts"]][-1] == "tank_3"
    loads(edited(after, {"op": "connect", "port": "valve_2.supply", "to": "supply"}))


# --- Errors ---

DEEP: list[Any] = []
for _ in range(900):
    DEEP = [DEEP]


@pytest.mark.parametrize(
    ("operation", "code", "address"),
    [
        ("add", "edit.no_operation", None),
        ({"op": "ad"}, "edit.no_operation", None),
        ({"op": ["add"]}, "edit.no_operation", None),
        ({"op": "add"}, "edit.no_field", "kind"),
        ({"op": "add", "kind": 3}, "edit.no_field", "kind"),
        ({"op": "add", "kind": "orifice", "nam": "x"}, "fields.unknown", "nam"),
        ({"op": "add", "kind": "orifise"}, "fields.not_an_option", "kind"),
        ({"op": "add", "kind": "orifice", "name": "tank"}, "edit.name_taken", "parts.tank"),
        ({"op": "add", "kind": "orifice", "name": "a b"}, "wiring.no_name", "parts.a b"),
        ({"op": "add", "kind": "orifice", "name": "ambient"}, "wiring.reserved", "parts.ambient"),
        ({"op": "add", "kind": "orifice", "place": {"x": 1}}, "edit.no_position", "drawing.orifice"),
        ({"op": "remove", "parts": ["tonk"]}, "names.unknown", "tonk"),
        ({"op": "rename", "part": "tonk", "name": "x"}, "names.unknown", "tonk"),
        ({"op": "rename", "part": "tank", "name": "supply"}, "edit.name_taken", "parts.supply"),
        ({"op": "set", "address": "tonk.volume", "value": 1}, "names.unknown", "tonk.volume"),
        ({"op": "set", "address": "tank", "value": 1}, "edit.no_address", "tank"),
        ({"op": "set", "address": "tank..x", "value": 1}, "edit.no_address", "tank..x"),
        ({"op": "set", "address": "tank.x", "value": [None]}, "edit.no_value", "tank.x"),
        ({"op": "set", "address": "tank.x", "value": 10**5000}, "edit.no_value", "tank.x"),
        ({"op": "set", "address": "tank.x", "value": DEEP}, "edit.no_value", "tank.x"),
        ({"op": "set", "address": "tank.x", "value": "\ud800"}, "edit.not_valid", None),
        ({"op": "set", "address": "valve.supply.x", "value": 1}, "edit.no_table", "parts.valve.supply"),
        ({"op": "place", "part": "tank", "x": True, "y": 1}, "edit.no_field", "x"),
        ({"op": "signal", "address": "valve", "table": 1}, "edit.no_address", "valve"),
        ({"op": "paste", "parts": {"tank": 3}}, "circuit.no_part", "parts.tank"),
    ],
)
def test_operations_that_are_not_possible(operation, code, address):
    before = Document(BENCH)
    with refused(code, address):
        before.apply([{"op": "add", "kind": "mass"}, operation])
    assert before.text == BENCH


SEQUENCE = """\
[parts.plc]
kind = "sequence"

[parts.plc.steps.rest]  # start
next = { lift = "elapsed > 1 s" }

[parts.plc.steps.lift]
on = ["up"]

# the valve
[parts.valve]
kind = "orifice"
"""


def test_a_table_gets_a_header_like_its_siblings():
    text = edited(
        SEQUENCE, {"op": "set", "address": "plc.steps.end", "value": {"on": ["up"], "next": {"rest": "elapsed > 2 s"}}}
    )
    added = '\n[parts.plc.steps.end]\non = ["up"]\nnext = { rest = "elapsed > 2 s" }\n'
    assert text == SEQUENCE.replace("\n# the valve", added + "\n# the valve")
    assert list(tomllib.loads(text)["parts"]["plc"]["steps"]) == ["rest", "lift", "end"]
    assert edited(text, {"op": "set", "address": "plc.steps.end", "value": None}) == SEQUENCE
