"""Editing sessions: saving, files that other programs change, limits to one folder, and the state for the page."""

from __future__ import annotations

import json
import os
import random
import signal
import stat
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from typing import Any

import pytest

from poppet import load
from poppet.cli.circuit_files import TEMPLATES
from poppet.core.errors import InputError
from poppet.core.toml_file import TomlFile
from poppet.edit.document import LARGEST
from poppet.edit.session import EMPTY, Session, with_line_endings
from poppet.serve.file_check import check_file
from refusals import refused

ROOT = Path(__file__).parents[3]
PLANT = """\
title = "Plant"

[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.hole]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "10 l"

[run]
duration = "1 s"
output_step = "10 ms"
"""
MOVE = {"op": "place", "part": "tank", "x": 4, "y": 2}


@pytest.fixture
def plant(tmp_path: Path) -> Path:
    path = tmp_path / "folder" / "plant.toml"
    path.parent.mkdir()
    path.write_text(PLANT, encoding="utf-8")
    return path


def edit(session: Session, *operations: dict[str, Any], **options: Any) -> dict[str, Any]:
    return session.apply(session.history.revision, list(operations or [MOVE]), **options)


def codes(session: Session) -> set[str]:
    return {error["code"] for error in session.state()["errors"]}


# --- State ---


def test_the_state_of_a_circuit(plant):
    session = Session(plant)
    state = session.state()
    assert (state["name"], state["folder"], state["text"], state["errors"]) == ("plant.toml", "folder", PLANT, [])
    assert not any(state[key] for key in ("dirty", "can_undo", "can_redo", "changed_on_disk", "created", "symbols"))
    assert {*state["places"]} == {"supply", "hole", "tank"}
    state = edit(session, {"op": "add", "kind": "orifice"}, {"op": "rename", "part": "tank", "name": "vessel"})
    assert state["created"] == ["orifice"]
    assert (state["dirty"], state["can_undo"], state["changed_on_disk"]) == (True, True, False)
    assert {error["address"] for error in state["errors"]} >= {"parts.orifice.from", "parts.orifice.to"}
    assert all(
        error["line"] and error["message"] and not error["message"].startswith("plant") for error in state["errors"]
    )
    json.dumps(state, allow_nan=False)


def test_an_invalid_text_has_one_error_with_its_line(plant):
    session = Session(plant)
    state = session.replace(session.history.revision, PLANT + "x = = 1\n")
    (error,) = state["errors"]
    assert (error["code"], error["line"]) == ("toml.invalid", PLANT.count("\n") + 1)
    assert error["line"] == state["view"]["error"]["line"]
    assert session.undo(session.history.revision)["text"] == PLANT


MODBUS = """
[modbus]
word_order = "middle"
[modbus.registers]
"tank.presure" = { input = 0 }
"tank.pressure" = { holding = 1 }
"supply.pressure" = { input = 2, type = "int16", raw = [0, 100], range = ["0 bar", "10 l"] }

[modbus.registers."hole.opening"]
holding = 4
unit = "bar"
"""


def test_the_table_modbus_has_the_messages_and_lines_of_poppet_check(plant):
    """Errors of this table do not keep the circuit from running; those of the circuit come before them."""
    text = PLANT.replace("\n[run]", f"{MODBUS}\n[run]")
    session = Session(plant)
    errors = session.replace(session.history.revision, text)["errors"]
    plant.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        check_file(load(plant))
    checked = TomlFile.read(plant).located(caught.value).problems
    assert len(checked) == 5
    assert [(e["code"], e["address"], e["line"]) for e in errors] == [(e.code, e.address, e.line) for e in checked]
    assert [f"{e['message']} {e['hint']}" for e in errors] == [f"{e.given} {e.reason} {e.hint}" for e in checked]
    lines = [text.splitlines()[error["line"] - 1] for error in errors]
    names = ["word_order", '"tank.presure"', '"tank.pressure"', '"supply.pressure"', "unit"]
    assert all(line.startswith(name) for line, name in zip(lines, names, strict=True))
    assert all(error["concerns_run"] is False for error in errors)
    assert session.circuit().simulate()["tank.pressure"][-1] > 1.1e5
    wrong = session.replace(session.history.revision, text.replace('"10 l"', '"10 bar"', 1))["errors"]
    assert {error["address"] for error in wrong} == {"parts.tank.volume"}
    assert session.replace(session.history.revision, PLANT)["errors"] == []


def test_lines_of_the_table_modbus_follow_the_drawing(plant):
    plant.write_text(f"{PLANT}\n[drawing]\n{MODBUS}", encoding="utf-8")
    session = Session(plant)
    before = session.state()["errors"]
    state = edit(session)
    line = state["text"].splitlines().index('"tank.presure" = { input = 0 }') + 1
    assert line in [error["line"] for error in state["errors"]]
    assert [error["address"] for error in state["errors"]] == [error["address"] for error in before]


def test_symbols_of_parts_with_options(plant):
    session = Session(plant)
    state = edit(session, {"op": "add", "kind": "spool_valve"})
    assert "spool_valve" not in state["symbols"]
    state = edit(session, {"op": "set", "address": "spool_valve.function", "value": "5/3 closed"})  # incomplete
    ports = {port["name"] for port in state["symbols"]["spool_valve"]["ports"]}
    assert {"supply", "a", "b", "command_a", "command_b"} <= ports
    machine = Session(TEMPLATES["machine"]).state()
    outputs = {port["name"] for port in machine["symbols"]["plc"]["ports"] if port["type"] == "output"}
    assert {"clamp", "punch", "lift"} <= outputs


def test_incomplete_parts_have_symbols(tmp_path):
    """A gripper without jaws has no inputs, because a member that its options name is missing."""
    text = (ROOT / "examples" / "pick_and_place.toml").read_text(encoding="utf-8")
    path = tmp_path / "incomplete.toml"
    path.write_text("".join(line for line in text.splitlines(keepends=True) if not line.startswith("jaws =")))
    state = Session(path).state()
    assert {error["address"].partition(".")[2].partition(".")[0] for error in state["errors"]} >= {"hand"}
    assert {"plc", "swing"} <= {*state["symbols"]}
    assert "hand" in state["places"]


def test_components_of_the_circuit_are_choices():
    session = Session(ROOT / "examples" / "catalogue_numbers.toml")
    state = session.state()
    assert state["errors"] == []
    for kind, own in state["models"].items():
        assert own["choices"]
        assert {name for component in own["components"] for name in component["names"]} == set(own["choices"])
        text = f"components = {json.dumps(tomllib.loads(state['text'])['components'])}\n"
        assert kind in {"flow_control_valve", "spool_valve"}, text


def test_a_drag_does_not_read_the_circuit_again(plant, monkeypatch):
    session = Session(plant)
    circuit = session.circuit()
    edit(session)
    assert session.circuit() is circuit
    edit(session, {"op": "set", "address": "tank.volume", "value": "2 l"})
    assert session.circuit() is not circuit
    assert session.circuit().parameters["tank.volume"] == 2e-3


def test_continued_changes_are_one_step(plant):
    session = Session(plant)
    edit(session, {"op": "set", "address": "hole.critical_ratio", "value": 0.4})
    for k in range(5):
        edit(session, {"op": "set", "address": "tank.volume", "value": f"{k} l"}, continues=True)
    edit(session, MOVE, continues=False)
    for k in range(3):
        edit(session, {**MOVE, "x": 10 + k}, continues=True)
    texts = []
    while session.history.can_undo:
        texts.append(session.undo(session.history.revision)["text"])
    assert len(texts) == 4
    assert texts[1].count('volume = "4 l"') == 1
    assert texts[-1] == PLANT
    while session.history.can_redo:
        session.redo(session.history.revision)
    assert "x = 12" in session.document.text


def test_a_continued_change_back_to_the_start_is_no_step(plant):
    session = Session(plant)
    for volume in ("11 l", "12 l", "10 l"):
        edit(session, {"op": "set", "address": "tank.volume", "value": volume}, continues=True)
    assert not session.history.can_undo
    edit(session, {"op": "set", "address": "tank.volume", "value": "13 l"}, continues=True)
    session.undo(session.history.revision)
    edit(session, {"op": "set", "address": "tank.volume", "value": "14 l"}, continues=True)
    assert session.undo(session.history.revision)["text"] == PLANT


# --- Saving ---


def test_only_save_writes(plant):
    session = Session(plant)
    edit(session)
    assert plant.read_text() == PLANT
    state = session.save(session.history.revision)
    assert not state["dirty"]
    assert plant.read_text() == session.document.text != PLANT
    assert session.undo(session.history.revision)["dirty"]
    assert [path.name for path in plant.parent.iterdir()] == ["plant.toml"]  # no temporary file remains


def test_a_new_file_is_created_by_save(tmp_path):
    session = Session(tmp_path / "new.toml")
    state = session.state()
    assert (state["name"], state["text"], state["dirty"]) == ("new.toml", EMPTY, False)
    assert not (tmp_path / "new.toml").exists()
    edit(session, {"op": "add", "kind": "chamber"})
    session.save(session.history.revision)
    assert (tmp_path / "new.toml").read_text() == session.document.text


def test_a_circuit_without_a_name_receives_a_free_one(tmp_path):
    (tmp_path / "circuit.toml").write_text(PLANT)
    session = Session(tmp_path)
    edit(session, {"op": "add", "kind": "chamber"})
    assert session.save(session.history.revision)["name"] == "circuit_2.toml"
    assert (tmp_path / "circuit.toml").read_text() == PLANT


def test_save_as(plant):
    (plant.parent / "other.toml").write_text("mine")
    session = Session(plant)
    edit(session)
    with refused("edit.file_exists", path="other.toml"):
        session.save(session.history.revision, name="other", overwrite=True)
    assert (plant.parent / "other.toml").read_text() == "mine"
    assert session.save(session.history.revision, name="third")["name"] == "third.toml"
    assert plant.read_text() == PLANT
    for name in ("", ".", "..", "../x", "a/b", "a\\b", ".hidden", "/etc/x", "a\n", "x\0"):
        with pytest.raises(ValueError):
            session.save(session.history.revision, name=name)
    assert sorted(path.name for path in plant.parent.parent.rglob("*.toml")) == [
        "other.toml",
        "plant.toml",
        "third.toml",
    ]


@pytest.mark.parametrize("overwrite", [False, True])
def test_a_file_that_has_changed_is_overwritten_on_request_only(plant, overwrite):
    session = Session(plant)
    edit(session)
    plant.write_text("other")
    assert session.status() == {"revision": session.history.revision, "changed_on_disk": True}
    if overwrite:
        assert not session.save(session.history.revision, overwrite=True)["changed_on_disk"]
        assert plant.read_text() == session.document.text
    else:
        with refused("edit.changed_on_disk", path="plant.toml"):
            session.save(session.history.revision)
        assert plant.read_text() == "other"


def test_a_change_between_check_and_rename_is_noticed(plant, monkeypatch):
    session = Session(plant)
    edit(session)
    monkeypatch.setattr(os, "fsync", lambda _: plant.write_text("other"))
    with refused("edit.changed_on_disk"):
        session.save(session.history.revision)
    assert plant.read_text() == "other"
    assert [path.name for path in plant.parent.iterdir()] == ["plant.toml"]


def test_the_same_change_on_disk_is_no_conflict(plant):
    session = Session(plant)
    edit(session)
    plant.write_text(session.document.text)
    session.save(session.history.revision)
    assert not session.state()["changed_on_disk"]


def test_reload_can_be_undone(plant):
    session = Session(plant)
    mine = edit(session)["text"]
    plant.write_text(PLANT.replace("10 l", "20 l"))
    state = session.reload(session.history.revision)
    assert (state["text"], state["dirty"], state["changed_on_disk"]) == (PLANT.replace("10 l", "20 l"), False, False)
    assert session.undo(session.history.revision)["text"] == mine


def test_a_circuit_without_a_file_cannot_be_read_again(tmp_path):
    session = Session(tmp_path)
    with refused("edit.no_name"):
        session.reload(session.history.revision)


def test_a_deleted_file(plant):
    session = Session(plant)
    edit(session)
    plant.unlink()
    assert session.state()["changed_on_disk"]
    with refused("edit.changed_on_disk"):
        session.save(session.history.revision)
    with refused("names.unknown", "plant.toml"):
        session.reload(session.history.revision)
    session.save(session.history.revision, overwrite=True)
    assert plant.read_text() == session.document.text


def test_a_file_that_becomes_unreadable(plant):
    session = Session(plant)
    edit(session)
    for content in (b"\xff\xfe", b"\0", b"#" * (LARGEST + 1)):
        plant.write_bytes(content)
        with refused("edit.changed_on_disk"):
            session.save(session.history.revision)
        with pytest.raises(ValueError):
            session.reload(session.history.revision)
        assert plant.read_bytes() == content
    plant.unlink()
    plant.mkdir()
    with refused("edit.changed_on_disk"):
        session.save(session.history.revision)
    with refused("files.no_file"):
        session.save(session.history.revision, overwrite=True)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="permissions do not limit the superuser")
def test_permissions(plant):
    session = Session(plant)
    edit(session)
    plant.chmod(0)
    with refused("edit.changed_on_disk"):
        session.save(session.history.revision)
    with refused("files.unreadable"):
        session.reload(session.history.revision)
    plant.chmod(0o600)
    plant.parent.chmod(0o500)
    try:
        with refused("files.unwritable"):
            session.save(session.history.revision)
    finally:
        plant.parent.chmod(0o700)
    assert plant.read_text() == PLANT


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_links_and_permissions_are_kept(plant):
    plant.chmod(0o640)
    link = plant.with_name("link.toml")
    link.symlink_to("plant.toml")
    session = Session(link)
    edit(session)
    session.save(session.history.revision)
    assert link.is_symlink()
    assert plant.read_text() == session.document.text
    assert stat.S_IMODE(plant.stat().st_mode) == 0o640


@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_line_endings_and_byte_order_marks(plant, mark, newline):
    text = mark + PLANT.replace("\n", newline)
    plant.write_bytes(text.encode())
    session = Session(plant)
    assert session.state()["errors"] == []
    # The text field of a page has line feeds only.
    typed = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("10 l", "11 l").replace("[run]", "# new\n[run]")
    session.replace(session.history.revision, typed)
    edit(session)
    session.save(session.history.revision)
    content = plant.read_bytes().decode()
    assert content.startswith(text.replace("10 l", "11 l").replace("[run]", f"# new{newline}[run]"))
    assert content.count("\n") == content.count(newline)


def test_mixed_line_endings_stay_where_nothing_changes():
    assert with_line_endings("a\nb\nx\nc\nd", "a\r\nb\nc\r\nd") == "a\r\nb\nx\r\nc\r\nd"
    assert with_line_endings("", "a\r\n") == ""
    assert with_line_endings("a\n", "") == "a\n"


def test_texts_that_cannot_be_saved(plant):
    session = Session(plant)
    for text in ("\ud800", "a\0b"):
        with refused("edit.no_text"):
            session.replace(session.history.revision, text)
    with refused("edit.too_large", most=1):
        session.replace(session.history.revision, "#" * (LARGEST + 1))
    assert session.document.text == PLANT
    assert not session.history.can_undo


@pytest.mark.parametrize("content", [b"\xff", b"title = '\0'", b"#" * (LARGEST + 1)])
def test_files_that_are_no_text(plant, content):
    plant.write_bytes(content)
    with pytest.raises(ValueError) as caught:
        Session(plant)
    assert caught.value.code in ("toml.no_text", "toml.too_large")


def test_paths_that_cannot_be_edited(tmp_path):
    with refused("files.no_folder"):
        Session(tmp_path / "missing" / "plant.toml")
    with refused("files.suffix", suffix=".csv"):
        Session(tmp_path / "plant.csv")


SAVING = """
import sys
from pathlib import Path
from poppet.edit.session import Session
session = Session(Path(sys.argv[1]))
print("ready", flush=True)
for k in range(10**6):
    session.replace(session.history.revision, f"# {k}\\n" * 30000)
    session.save(session.history.revision)
"""


def test_a_killed_server_loses_neither_the_old_nor_the_new_file(plant):
    for seed in range(5):
        process = subprocess.Popen([sys.executable, "-c", SAVING, plant], stdout=subprocess.PIPE)
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(random.Random(seed).uniform(0.02, 0.1))
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
        text = plant.read_text()
        assert text == PLANT or (len({*text.splitlines()}), text.count("\n")) == (1, 30000)
    session = Session(plant)
    edit(session, {"op": "set", "address": "title", "value": "new"})
    session.save(session.history.revision)
    assert [path.name for path in plant.parent.iterdir()] == ["plant.toml"]  # files of killed processes are deleted


@pytest.mark.parametrize("seed", range(3))
def test_random_operations_beside_a_second_editor_lose_nothing(plant, seed):
    """Each text that another program writes remains on the disk until the user has read it or overwrites it."""
    rng = random.Random(seed)
    session = Session(plant)
    disk = PLANT  # content that must be on the disk
    refusals = 0
    for number in range(500):
        revision, text = session.history.revision, session.document.text
        names = [*session.document.view().get("parts", {})] or ["none"]
        action = rng.choice(["change"] * 4 + ["save", "save", "undo", "redo", "reload", "write", "overwrite"])
        try:
            if action == "change":
                part, other = rng.choice(names), rng.choice(names)
                operation = rng.choice(
                    [
                        {"op": "add", "kind": rng.choice(["orifice", "chamber", "tube"])},
                        {"op": "place", "part": part, "x": number, "y": 1},
                        {"op": "rename", "part": part, "name": f"n{number}"},
                        {"op": "remove", "parts": [part]},
                        {"op": "connect", "port": f"{part}.to", "to": other},
                        {"op": "set", "address": "title", "value": f"title {number}"},
                    ]
                )
                edit(session, operation, continues=rng.random() < 0.3)
            elif action == "write":
                disk = PLANT.replace("Plant", f"other {number}")
                plant.write_text(disk)
            elif action in ("save", "overwrite"):
                session.save(revision, overwrite=action == "overwrite")
                disk = session.document.text
            elif action == "reload":
                session.reload(revision)
                assert session.document.text == disk
                assert text == disk or session.undo(session.history.revision)["text"] == text
            else:
                getattr(session, action)(revision)
        except ValueError as error:
            refusals += error.code == "edit.changed_on_disk"
            assert session.document.text == text
        assert plant.read_text() == disk
        assert session.state()["dirty"] == (session.document.text != session._disk.decode())
    assert refusals > 5


# --- Files ---


def test_the_start_page(plant):
    (plant.parent / "broken.toml").write_text("= 1")
    (plant.parent / "fit.toml").write_text("[recordings]\n")
    (plant.parent / "plant.csv").write_text("")
    (plant.parent / "folder.toml").mkdir()
    os.utime(plant, (1, 1))
    (plant.parent / "new.toml").write_text(PLANT.replace("Plant", "<script>"))
    start = Session(plant.parent, TEMPLATES).start()
    assert [(file["name"], file["title"]) for file in start["files"]] == [
        ("new.toml", "<script>"),
        ("plant.toml", "Plant"),
    ]
    assert [template["name"] for template in start["templates"]] == [*TEMPLATES]
    assert all(template["title"] and template["summary"] for template in start["templates"])


def test_open(plant):
    session = Session(plant.parent, TEMPLATES)
    state = session.open(file="plant.toml")
    assert (state["name"], state["text"]) == ("plant.toml", PLANT)
    revision = edit(session)["revision"]
    with refused("edit.unsaved"):
        session.open(template="cylinder")
    state = session.open(template="cylinder", discard=True)
    assert (state["name"], state["dirty"], state["errors"]) == (None, False, [])
    assert state["revision"] > revision
    with refused("edit.stale"):  # of a page with the former file
        session.apply(revision, [MOVE])
    with refused("fields.not_an_option", "template"):
        session.open(template="../cylinder")
    with refused("names.unknown", "plan.toml"):
        session.open(file="plan.toml")
    assert session.open(empty=True)["text"] == EMPTY


SECRET = "in the secret file"
OUTSIDE = {
    "signal": '[signals."hole.opening"]\nkind = "file"\npath = "{path}.csv"\ncolumn = "opening"\n',
    "duty": '[signals."hole.opening"]\nkind = "pwm"\nfrequency = "1 Hz"\n'
    'duty = {{ kind = "file", path = "{path}.csv", column = "opening" }}\n',
    "component": 'components = ["{path}.toml"]\n',
    "characteristic": '[parts.other]\nkind = "orifice"\nfrom = "supply"\nto = "tank"\nstroke = "1 mm"\n'
    'characteristic = "{path}.toml"\n',
    "edge": '[parts.other]\nkind = "spool_valve"\nsupply = "supply"\na = "tank"\nb = "tank"\n'
    'nominal_flow = "500 l/min ANR"\ncharacteristic = "{path}.toml"\n',
    "data": '[parts.other]\nkind = "main_stage"\nsupply = "supply"\noutlet = "tank"\ndata = "{path}.toml"\n',
}


@pytest.mark.parametrize("form", ["absolute", "relative", "link", "folder_link"])
@pytest.mark.parametrize("table", OUTSIDE)
def test_a_circuit_reads_no_file_outside_its_folder(plant, table, form, monkeypatch):
    outside = plant.parents[1] / "secret"
    for suffix in ("csv", "toml"):
        outside.with_suffix(f".{suffix}").write_text(f"time,opening\n0,0\n1,1\n# {SECRET}\n")
    if form == "link":
        for suffix in ("csv", "toml"):
            (plant.parent / f"link.{suffix}").symlink_to(outside.with_suffix(f".{suffix}"))
    elif form == "folder_link":
        (plant.parent / "inner").symlink_to(plant.parents[1])
    path = {"absolute": str(outside), "relative": "../secret", "link": "link", "folder_link": "inner/secret"}[form]
    opened: list[str] = []
    sys.addaudithook(lambda event, args: opened.append(str(args[0])) if event == "open" else None)
    text = OUTSIDE[table].format(path=path)
    plant.write_text(text + PLANT if table == "component" else PLANT + text)
    session = Session(plant)
    errors = session.state()["errors"]
    assert errors
    assert SECRET not in json.dumps(errors)
    names = {"secret.csv", "secret.toml", "link.csv", "link.toml"}
    assert not any(Path(name).name in names for name in opened)


def test_files_of_the_folder_are_read_again_if_they_change(plant):
    course = plant.parent / "data" / "course.csv"
    course.parent.mkdir()
    course.write_text("time [s],opening [1]\n0,0\n1,1\n")
    plant.write_text(PLANT + OUTSIDE["signal"].format(path="data/course"))
    session = Session(plant)
    assert session.state()["errors"] == []
    first = session.circuit().signals["hole.opening"]
    edit(session, {"op": "set", "address": "title", "value": "new"})
    assert session.circuit().signals["hole.opening"] is first  # large files are slow to read
    course.write_text("time [s],opening [1]\n0,0\n1,0.5\n")
    edit(session, {"op": "set", "address": "title", "value": "newer"})
    assert session.circuit().signals["hole.opening"].values[-1] == 0.5
    course.unlink()
    assert edit(session, {"op": "set", "address": "title", "value": "newest"})["errors"]


def test_a_link_that_leads_out_is_neither_read_nor_written(plant):
    secret = plant.parents[1] / "secret.toml"
    secret.write_text(PLANT)
    link = plant.parent / "link.toml"
    link.symlink_to(secret)
    with refused("files.outside"):
        Session(link)
    session = Session(plant)
    with refused("files.outside"):
        session.open(file="link.toml")
    edit(session)
    with pytest.raises(ValueError):
        session.save(session.history.revision, name="link.toml")
    # A file that becomes a link while it is edited.
    plant.unlink()
    plant.symlink_to(secret)
    with pytest.raises(ValueError):
        session.save(session.history.revision, overwrite=True)
    assert secret.read_text() == PLANT
    assert "link.toml" not in [file["name"] for file in session.start()["files"]]


def test_a_circuit_executes_no_python(plant):
    mark = plant.parent / "executed"
    (plant.parent / "metric.py").write_text(f"open({str(mark)!r}, 'w')\n\ndef peak(recording):\n    return 1.0\n")
    plant.write_text(PLANT + '[ensemble.metrics.peak]\nmetric = "metric.py:peak"\nof = "tank.pressure"\n')
    session = Session(plant)
    assert session.state()["errors"] == []
    session.circuit()
    assert not mark.exists()


EXAMPLES = sorted(
    path for path in (ROOT / "examples").rglob("*.toml") if "parts" in tomllib.loads(path.read_text(encoding="utf-8"))
)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_examples_are_saved_unchanged_and_moves_change_the_drawing_only(example, tmp_path):
    path = tmp_path / example.name
    path.write_bytes(example.read_bytes())
    session = Session(path)
    state = session.state()
    session.save(state["revision"])
    assert path.read_bytes() == example.read_bytes()
    places = {part: {"x": 3 * k, "y": k, "rotation": 90} for k, part in enumerate(state["places"])}
    edit(session, *({"op": "place", "part": part, **place} for part, place in places.items()))
    session.save(session.history.revision)
    assert path.read_bytes().startswith(example.read_bytes())
    before, after = tomllib.loads(example.read_text("utf-8")), tomllib.loads(path.read_text("utf-8"))
    assert {key: value for key, value in after.items() if key != "drawing"} == before
    assert after["drawing"] == places
    assert session.undo(session.history.revision)["text"].encode() == example.read_bytes()
