"""Names, landmarks, focus, contrast and narrow screens of the page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from editor_page import Editor

PLANT = """title = "A tank is filled"

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
volume = "1 l"

[run]
duration = "1 s"
"""
BROKEN = PLANT.replace('to = "tank"', 'to = "tnak"')
SCRIPT = (Path(__file__).parents[1] / "accessibility.js").read_text(encoding="utf-8")


def ask(editor: Editor, function: str) -> Any:
    """Return the result of a function of the script."""
    return editor.page.evaluate(f"() => {{ {SCRIPT}\nreturn {function}(); }}")


def tab_stops(editor: Editor, limit: int = 700) -> list[str]:
    """Return what Tab reaches from the start of the page, and check that the focus is visible everywhere."""
    page = editor.page
    page.locator("body a").first.focus()  # the link that skips to the drawing
    page.evaluate(f"() => {{ window.nextStop = (() => {{ {SCRIPT}\nreturn nextStop; }})(); }}")
    stops: list[str] = []
    for _ in range(limit):
        page.keyboard.press("Tab")
        stop = page.evaluate("() => window.nextStop()")
        if stop is None:
            break
        assert stop[1], f"the focus on {stop[0]} is not visible"
        stops.append(stop[0].strip())
    return stops


def check(editor: Editor) -> None:
    """Check names, identifiers and contrast of what is displayed."""
    assert ask(editor, "withoutName") == []
    assert ask(editor, "doubleIds") == []
    assert ask(editor, "lowContrast") == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everything_has_a_name_and_contrast(start_editor, scheme):
    editor = start_editor(PLANT, scheme=scheme)
    check(editor)
    editor.select("hole")
    check(editor)
    for tab in editor.page.get_by_role("tab").all():
        if tab.is_visible():
            tab.click()
            check(editor)


def test_errors_have_names_and_contrast(start_editor):
    for scheme in ("light", "dark"):
        editor = start_editor(BROKEN, scheme=scheme)
        check(editor)


def test_dark_is_dark(start_editor):
    colour = {
        scheme: start_editor(PLANT, scheme=scheme).page.evaluate(
            "() => getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)"
        )
        for scheme in ("light", "dark")
    }
    assert sum(colour["light"][:3]) > 600
    assert sum(colour["dark"][:3]) < 200


def test_landmarks_and_language(start_editor):
    page = start_editor(PLANT).page
    for role in ("banner", "navigation", "main"):
        assert page.get_by_role(role).count() >= 1, role
    assert page.get_by_role("main").count() == 1
    assert page.locator("h1").count() == 1
    assert page.evaluate("() => document.documentElement.lang") == "en"
    assert page.locator("[aria-live=polite]").count() >= 1
    assert page.title()


def test_tab_reaches_every_action(start_editor):
    editor = start_editor(PLANT)
    editor.select("hole")
    stops = tab_stops(editor)
    assert {"supply", "hole", "tank", "hole.from", "hole.to", "hole.sonic_conductance"} <= {*stops}
    for name in ("Save", "Redo", "Delete", "Rotate"):
        button = editor.button(name)
        assert button.is_disabled() or any(stop.startswith(name) for stop in stops), name


def test_arrow_keys_reach_every_kind(start_editor):
    editor = start_editor(PLANT)
    kinds = editor.names("data-kind")
    editor.palette(kinds[0]).focus()
    reached = [kinds[0]]
    for _ in kinds[1:]:
        editor.page.keyboard.press("ArrowRight")
        reached.append(editor.page.evaluate("() => document.activeElement.dataset.kind"))
    assert reached == kinds
    assert editor.page.evaluate("() => document.activeElement.tabIndex") == 0


def test_parts_and_ports_are_named(start_editor):
    editor = start_editor(PLANT)
    assert "hole" in editor.part("hole").get_attribute("aria-label")
    assert "tank" in editor.port("hole.to").get_attribute("aria-label")  # it is connected


HEARD = """() => { window.heard = []; for (const live of document.querySelectorAll("[aria-live=polite]"))
  new MutationObserver(() => window.heard.push(live.textContent)).observe(live,
    {childList: true, characterData: true, subtree: true}); }"""


def test_results_are_announced(start_editor):
    editor = start_editor(PLANT)
    editor.page.evaluate(HEARD)
    editor.add("chamber")
    editor.press("Control+z")
    editor.select("tank")
    editor.type("tank.volume", "2 l")
    editor.page.wait_for_function("() => window.heard.some(words => /tank.pressure/.test(words))")
    heard = editor.page.evaluate("() => window.heard")
    assert any("chamber" in words for words in heard)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_telephone_has_no_horizontal_scroll(start_editor, scheme):
    editor = start_editor(PLANT, width=360, height=740, scheme=scheme, touch=True)
    page = editor.page
    width = "() => document.documentElement.scrollWidth"
    assert page.evaluate(width) <= 360
    for tab in page.get_by_role("tab").all():
        if tab.is_visible():
            tab.click()
            assert page.evaluate(width) <= 360, tab.inner_text()
            outside = page.evaluate(
                """() => [...document.querySelectorAll("button, input, select, textarea")]
                .filter(e => e.checkVisibility() && !e.closest("[class*=scroll], svg"))
                .filter(e => { const b = e.getBoundingClientRect(); return b.width > 361; }).map(e => e.outerHTML)"""
            )
            assert outside == []
    assert ask(editor, "withoutName") == []
