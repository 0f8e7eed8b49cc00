"""The site: parts, commands and codes have their place on it; it builds without a warning and asks nobody."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from poppet.cli.main import COMMANDS
from poppet.ground.wording import every_code
from poppet.parts import KINDS

pytest.importorskip("sphinx", reason="the site is built where the extra `docs` is installed")
import reference_pages

ROOT = Path(__file__).parents[2]


def test_every_kind_of_part_has_a_page_with_its_fields():
    for kind in KINDS:
        text = reference_pages.part_page(kind, {"pressure": "Pa"})
        names = {name for name, *_ in reference_pages.fields(KINDS[kind])}
        assert names
        assert all(name in text for name in names)
        assert "| `pressure` | Pa |" in text


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
