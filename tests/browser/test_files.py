"""Example files in the editor: unchanged bytes, changes of the drawing only, and random actions."""

from __future__ import annotations

import random
import re
import shutil
import tomllib

import pytest

from circuits_of_exports import EXAMPLES
from editor_page import Editor
from poppet.circuit.file import loads
from poppet.core.errors import InputErrors

FILES = sorted(EXAMPLES.glob("*.toml"))
SLICES = 4


def open_file(editor: Editor, name: str) -> None:
    """Open a file of the folder and show it."""
    status = editor.page.evaluate(
        """async name => (await fetch("/open", {method: "POST", headers: {"Content-Type": "application/json"},
        body: JSON.stringify({file: name})})).status""",
        name,
    )
    assert status == 200
    editor.page.reload()
    editor.page.wait_for_function("() => window.poppet !== undefined")
    editor.wait()


@pytest.mark.parametrize("part", range(SLICES))
def test_examples_are_saved_with_the_same_bytes(start_editor, part):
    editor = start_editor("")
    chosen = FILES[part::SLICES]
    for path in EXAMPLES.iterdir():
        if path.is_file() and path.suffix in (".toml", ".csv", ".dat"):
            shutil.copy(path, editor.folder / path.name)
    shutil.copytree(EXAMPLES / "components", editor.folder / "components")
    for path in chosen:
        file = editor.folder / path.name
        open_file(editor, path.name)
        editor.press("Control+s")
        assert file.read_bytes() == path.read_bytes(), path.name
        parts = tomllib.loads(path.read_text(encoding="utf-8")).get("parts")
        if not parts:
            continue  # the file of an ensemble or of a test refers to a circuit
        name = random.Random(path.name).choice(sorted(parts))
        editor.select(name)
        editor.press("ArrowDown")
        assert_only_drawing_differs(editor.text(), path.read_text(encoding="utf-8"))
        editor.press("Control+s")
        assert file.read_text(encoding="utf-8") == editor.text(), path.name


def assert_only_drawing_differs(text: str, original: str) -> None:
    """Check that two texts are equal without the table [drawing], which is at the end of the first one."""
    start = re.search(r"^\[drawing", text, re.MULTILINE)
    assert start is not None
    assert text[: start.start()].rstrip("\n") == original.rstrip("\n")
    assert {*tomllib.loads(text)} - {*tomllib.loads(original)} <= {"drawing"}


def test_line_endings_and_a_byte_order_mark_are_kept(start_editor):
    content = (
        b'\xef\xbb\xbftitle = "CRLF"\r\n\r\n[parts.supply]\r\nkind = "reservoir"   # air\r\npressure = "6 bar g"\r\n'
    )
    editor = start_editor(content)
    editor.save()
    assert (editor.folder / "plant.toml").read_bytes() == content
    editor.add("orifice")
    editor.connect("orifice.from", "supply")
    editor.save()
    saved = (editor.folder / "plant.toml").read_bytes()
    assert saved.startswith(content)
    assert saved.count(b"\n") == saved.count(b"\r\n")


KINDS = ("orifice", "chamber", "reservoir", "check_valve", "cylinder", "mass", "spool_valve", "pid", "tube")


def random_action(editor: Editor, random_: random.Random) -> None:
    """Perform one random action of a user."""
    editor.wait()
    names, ports = editor.names(), editor.names("data-port")
    choice = random_.random()
    if choice < 0.2 or len(names) < 2:
        editor.palette(random_.choice(KINDS)).click()
    elif choice < 0.45:
        start = random_.choice(ports)
        end = random_.choice([*ports, *names])
        for name in (start, end):
            element = editor.port(name) if "." in name else editor.part(name)
            editor.page.mouse.click(*editor.centre(element))
        editor.page.keyboard.press("Escape")
    elif choice < 0.6:
        x, y = editor.centre(editor.part(random_.choice(names)))
        to = (x + random_.randint(-120, 120), y + random_.randint(-120, 120))
        editor.drag((x, y), to, steps=3)
    elif choice < 0.7:
        editor.select(random_.choice(names))
        fields = editor.page.locator("#form input[type=text]:visible").all()[:6]
        if fields:
            field = random_.choice(fields)
            field.fill(random_.choice(["1", "2 l", "0.3", "5 mm", "1 bar g", "", "nonsense", "-1 kg"]))
            field.press("Enter")
            editor.page.keyboard.press("Escape")
    elif choice < 0.8:
        editor.select(random_.choice(names))
        editor.page.keyboard.press(
            random_.choice(["Delete", "r", "m", "ArrowLeft", "Control+c", "Control+a", "Escape"])
        )
    else:
        editor.page.keyboard.press(random_.choice(["Control+z", "Control+z", "Control+y", "Control+v", "Escape"]))


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.slow)])
def test_random_actions_keep_page_and_server_alike(start_editor, seed):
    editor = start_editor(name="plant.toml")
    first = editor.text()
    random_ = random.Random(seed)
    for _ in range(100):
        random_action(editor, random_)
    editor.wait()
    state = editor.page.evaluate("async () => (await fetch('/document')).json()")
    assert editor.text() == state["text"]
    tables = tomllib.loads(editor.text())
    assert sorted(editor.names()) == sorted(tables.get("parts", {}))
    # The errors on the page are those of the text.
    try:
        loads(editor.text())
        expected = set()
    except InputErrors as errors:
        expected = {problem.address for problem in errors.problems}
    assert expected <= {*editor.names("data-address")}
    while state["can_undo"]:
        editor.press(*["Control+z"] * 10)
        state = editor.page.evaluate("async () => (await fetch('/document')).json()")
    assert editor.text() == first
