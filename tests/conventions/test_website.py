"""The site: parts, commands and codes have their place on it; it builds without a warning and asks nobody."""

from __future__ import annotations

import ast
import re
import runpy
import types
from pathlib import Path

import pytest

import poppet
from poppet.cli.commands import COMMANDS
from poppet.core.message_format import every_code
from poppet.parts import KINDS

pytest.importorskip("sphinx", reason="the site is built where the extra `docs` is installed")
import card_pictures
import field_meanings
import reference_pages
from website_files import broken_links

ROOT = Path(__file__).parents[2]


def test_every_kind_of_part_has_a_page_with_its_fields():
    for kind in KINDS:
        text = reference_pages.part_page(kind, {"setpoint": "bar"}, {"pressure": "Pa"})
        names = {name for name, *_ in reference_pages.fields(KINDS[kind])}
        assert names
        assert all(name in text for name in names)
        assert "| `setpoint` | bar |" in text.partition("## Inputs")[2]
        assert "| `pressure` | Pa |" in text.partition("## Outputs")[2]


def test_fields_of_parts_have_the_meanings_of_the_page_on_the_circuit_file():
    """The page lists no field that a compound part sets itself, such as `piston.bore` of a cylinder."""
    for kind, part in KINDS.items():
        names = {name.strip("`") for name, *_ in reference_pages.fields(part)}
        assert names <= field_meanings.meanings(kind).keys(), kind
    text = reference_pages.part_page("orifice", {}, {})
    assert "| C and b over the stroke, see [characteristics](../../docs/circuit_file.md#characteristics) |" in text


def test_every_input_and_output_of_a_circuit_stands_on_the_page_of_its_part():
    pages = reference_pages.part_pages()
    # Passages, stores and bodies always show something; what turns gas into force may show it as its body's.
    # The variables of an FMU are those of its description.
    assert [kind for kind in KINDS if "## Outputs" not in pages[f"reference/parts/{kind}.md"]] == ["fmu"]
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
    for name in ("llms.txt", "llms-full.txt"):  # texts for assistants, at the root of the site
        assert (site / name).read_bytes() == (ROOT / "src" / "poppet" / "assist" / name).read_bytes()
    # Words as the index has them, by their stems.
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    assert all(f"{word}" in index for word in ("sonic", "conduct", "hysteresi"))


def test_pictures_of_a_card_show_all_parts_and_the_whole_curve():
    circuit = poppet.load(ROOT / "examples" / "pressure_control.toml")
    drawing = card_pictures.card_drawing(circuit)
    assert set(re.findall("<title>(.*?)</title>", drawing)) == set(circuit.parts)
    run = circuit.simulate()
    curve = card_pictures.card_curve(run, "tank.pressure", dashed="regulator.setpoint")
    assert ">pressure of tank [bar]<" in curve
    assert ">setpoint<" in curve
    assert ">6.5 s<" in curve
    ticks = [float(text) for text in re.findall(r'<text class="end" x="35"[^>]*>([\d.]+)<', curve)]
    bar = run.converted(["bar"])["tank.pressure"]
    margin = 0.1 * (ticks[1] - ticks[0])
    assert ticks[0] - margin <= bar.min() < bar.max() <= ticks[-1] + margin
    assert len(ticks) in (3, 4, 5)
    # The end of the curve, between the first and the last tick.
    last = re.findall(r'<path class="curve" d="M.*?([\d.]+) ([\d.]+)"', curve)[0]
    top, bottom = card_pictures.MARGINS["top"], card_pictures.CURVE_HEIGHT - card_pictures.MARGINS["bottom"]
    share = (bar[-1] - ticks[0]) / (ticks[-1] - ticks[0])
    assert float(last[0]) == pytest.approx(card_pictures.WIDTH - card_pictures.MARGINS["right"], abs=0.1)
    assert float(last[1]) == pytest.approx(bottom - share * (bottom - top), abs=0.1)


def test_links_lead_to_pages_and_places(site):
    assert broken_links(site) == []


def test_the_front_page_is_one_small_file_with_a_model(site):
    page = site / "index.html"
    text = page.read_text(encoding="utf-8")
    assert page.stat().st_size < 100_000
    assert re.findall(r"<(?:script|link|img|iframe|source)\b[^>]*(?:src|href)=", text) == []
    assert all(entry in text for entry in ("I have a recording", "I design a machine", "I control a valve"))
    assert "pip install" in re.sub("<[^>]+>", "", text)
    assert text.count('type="range"') == 2


def test_each_example_has_a_card_with_pictures_a_live_page_and_a_command(site):
    text = (site / "gallery" / "index.html").read_text(encoding="utf-8")
    cards = dict(re.findall(r'<li id="(\w+)">(.*?)</li>', text, re.DOTALL))
    assert sorted(cards) == sorted(path.stem for path in (ROOT / "examples").glob("*.toml"))
    for name, card in cards.items():
        assert card.count("<svg") == 2, name
        assert f'href="live/{name}.html"' in card
        assert f'data-copy="poppet edit examples/{name}.toml"' in card
        assert 'id="model"' in (site / "gallery" / "live" / f"{name}.html").read_text(encoding="utf-8")
