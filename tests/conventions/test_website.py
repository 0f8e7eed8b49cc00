"""The site: parts, commands and codes have their place on it; it builds without a warning and asks nobody."""

from __future__ import annotations

import ast
import re
import runpy
import subprocess
import sys
import types
from pathlib import Path

import pytest

import poppet
from poppet.cli.commands import COMMANDS
from poppet.core.message_format import every_code
from poppet.parts import KINDS

pytest.importorskip("sphinx", reason="the site is built where the extra `docs` is installed")
import reference_pages

ROOT = Path(__file__).parents[2]


def test_every_kind_of_part_has_a_page_with_its_fields():
    for kind in KINDS:
        text = reference_pages.part_page(kind, {"setpoint": "bar"}, {"pressure": "Pa"})
        names = {name for name, *_ in reference_pages.fields(KINDS[kind])}
        assert names
        assert all(name in text for name in names)
        assert "| `setpoint` | bar |" in text.partition("## Inputs")[2]
        assert "| `pressure` | Pa |" in text.partition("## Outputs")[2]


def test_every_input_and_output_of_a_circuit_stands_on_the_page_of_its_part():
    pages = reference_pages.part_pages()
    # Passages, stores and bodies always show something; what turns gas into force may show it as its body's.
    assert [kind for kind in KINDS if "## Outputs" not in pages[f"reference/parts/{kind}.md"]] == []
    circuit = poppet.load(ROOT / "examples" / "muscle_joint.toml")
    for heading, of in (("Inputs", circuit.model.inputs), ("Outputs", circuit.model.outputs)):
        for name, unit in ((each[0], each[1]) for each in of):
            part, _, local = name.partition(".")
            if part in circuit.parts:
                page = pages[f"reference/parts/{circuit.parts[part].kind}.md"].partition(f"## {heading}")[2]
                own = re.escape(re.sub(r"^[0-9]+[.]", "N.", local))
                assert re.search(rf"^\| `{own}` \|.*\b{re.escape(unit)}(, |\b| ).*\|$", page, re.MULTILINE), name


def named(node: ast.expr) -> str:
    """A pattern of the texts that an expression may be: letters as they stand, anything for what is put in."""
    if isinstance(node, ast.Constant):
        return re.escape(str(node.value))
    if isinstance(node, ast.JoinedStr):
        return "".join(".*" if isinstance(each, ast.FormattedValue) else named(each) for each in node.values)
    return ".*"


def is_series(value: ast.expr) -> bool:
    """Whether an expression is what a part shows: a value and its unit."""
    return isinstance(value, ast.Tuple) and len(value.elts) == 2 and isinstance(value.elts[1], ast.Constant)


@pytest.mark.parametrize("which", ["inputs", "outputs"])
def test_what_the_source_of_parts_names_stands_on_a_page(which):
    """Also of options that no example takes."""
    shown = [name for own in reference_pages.series(which).values() for name in own]
    written = set()
    for path in sorted((ROOT / "src" / "poppet" / "parts").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(func=ast.Name(id="Input"), args=[name, *_]) if which == "inputs":
                    written.add(named(name))
                case ast.Dict() if which == "outputs":
                    pairs = zip(node.keys, node.values, strict=True)
                    written |= {named(key) for key, value in pairs if key and is_series(value)}
                case ast.Assign(targets=[ast.Subscript(slice=name)], value=value) if which == "outputs":
                    written |= {named(name)} if is_series(value) else set()
    assert len(written) > 15
    assert [name for name in sorted(written) if not any(re.fullmatch(f"(.*[.])?{name}", each) for each in shown)] == []


def test_a_command_of_a_notebook_that_fails_stops_the_build(monkeypatch):
    pytest.importorskip("IPython", reason="the extra `docs` has it")
    shell = types.SimpleNamespace(
        user_ns={}, system=lambda command: shell.user_ns.update(_exit_code=command == "false")
    )
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    runpy.run_path(str(ROOT / "website" / "ipython" / "profile_default" / "startup" / "commands.py"))
    shell.system("true")
    with pytest.raises(RuntimeError):
        shell.system("false")


def test_every_command_stands_in_the_reference():
    text = reference_pages.command_page()
    assert re.findall(r"^## `poppet (.+)`$", text, re.MULTILINE) == list(COMMANDS)


def test_every_code_has_an_anchor():
    found = reference_pages.code_pages()
    anchors = re.findall(r"^\(code-(.+)\)=$", "\n".join(found.values()), re.MULTILINE)
    assert sorted(anchors) == sorted(every_code())


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-W", "ignore", "website/make_site.py", "-o", str(folder)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=900, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "html"


def test_it_builds_asks_nobody_and_is_searched(site):
    pages = sorted(site.rglob("*.html"))
    assert len(pages) > 100
    asked = [
        f"{page.relative_to(site)}: {address}"
        for page in pages
        for tag in re.findall(r"<(?:script|link|img|iframe|source)\b[^>]*>", page.read_text(encoding="utf-8"))
        for address in re.findall(r'(?:src|href)="(?:https?:)?(//[^"]+)"', tag)
    ]
    assert asked == []
    # Words as the index has them, by their stems.
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    assert all(f"{word}" in index for word in ("sonic", "conduct", "hysteresi"))
