"""Hostile files in the page, its content security policy, and two tabs on one file."""

from __future__ import annotations

import http.client
import json
import urllib.parse

import pytest

from editor_page import Editor

PAYLOADS = (
    "'\\\"></script><script>window.hacked=1</script><img src=x onerror=window.hacked=1><b id=hacked>",
    "<svg onload=window.hacked=1>${window.hacked=1}{{window.hacked=1}}",
    "javascript:window.hacked=1",
)
"""Texts in strings of TOML that markup, scripts and addresses of a careless page would execute."""
PLANT = """
title = "{payload}"
# {payload}
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.hole]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = {{ value = "1 dm^3/(s bar)", source = "measured", locator = "{payload}", note = "{payload}" }}
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "1 l"
{more}
[run]
duration = "1 s"
"""
HOSTILE = """
model = "{payload}"
thermal = "{payload}"
"{payload}" = 1

[parts."{payload}"]
kind = "chamber"
volume = "1 l"

[parts.other]
kind = "{payload}"

[parts.third]
kind = "orifice"
from = "{payload}"
to = "tank"

[parts.valve]
kind = "spool_valve"
function = "{payload}"
model = "{payload}"

[parts.plc]
kind = "sequence"
outputs = ["{payload}"]
start = "{payload}"
steps = {{ "{payload}" = {{ on = ["{payload}"], next = {{ "{payload}" = "{payload}" }} }} }}

[signals."{payload}"]
kind = "steps"
times = [0]
values = [1]

[signals."hole.opening"]
kind = "file"
path = "{payload}"

[connections]
"{payload}" = "{payload}"

[drawing]
"{payload}" = {{ x = 1, y = 2 }}
tank = {{ x = "{payload}", y = 2 }}
hole = {{ x = 1, y = 1, rotation = "{payload}" }}
"hole.from" = {{ points = "{payload}" }}
"hole.to" = {{ points = [["{payload}", 1], "{payload}"] }}

[ambient]
pressure = "{payload}"

["{payload}"]
x = 1
"""
MORE = (HOSTILE, "{payload} = ")
IS_CLEAN = """() => window.hacked === undefined && document.getElementById("hacked") === null
  && document.querySelector("img[src='x'], [onerror], [onload], iframe, object, embed") === null
  && [...document.scripts].every(s => s.src.startsWith(location.origin))
  && [...document.querySelectorAll("[href]")].every(e => !/^javascript:/i.test(e.getAttribute("href")))"""


def look_everywhere(editor: Editor) -> None:
    """Select every part and open every panel, so that all texts are displayed."""
    for part in editor.page.locator("[data-part]").all():
        part.focus()
        editor.page.keyboard.press("Enter")
    for tab in editor.page.get_by_role("tab").all():
        if tab.is_visible():
            tab.click()
    editor.wait()
    assert editor.page.evaluate(IS_CLEAN)


@pytest.mark.parametrize("payload", PAYLOADS)
def test_texts_of_a_file_are_never_markup(start_editor, payload):
    for more in MORE:
        editor = start_editor(PLANT.format(payload=payload, more=more.format(payload=payload)))
        look_everywhere(editor)


def test_names_of_javascript_are_names_of_parts(start_editor):
    names = ("constructor", "toString", "valueOf")
    stores = "".join(f'[parts.{name}]\nkind = "chamber"\nvolume = "1 l"\n' for name in names[:2])
    hole = 'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3\nfrom = "constructor"\nto = "toString"\n'
    editor = start_editor(f'{stores}[parts.valueOf]\nkind = "orifice"\n{hole}[run]\nduration = "1 s"\n')
    assert {"constructor.pressure", "valueOf.mass_flow_rate"} <= editor.recording().keys()
    for name in names:
        editor.select(name)
        editor.page.keyboard.press("Delete")
        editor.wait()
        assert editor.page.evaluate("() => window.poppet.store.selection.size") == 0
        assert f"[parts.{name}]" not in editor.text()


def test_positions_that_are_too_far_away_are_ignored(start_editor):
    """The page would compute without end."""
    hole = 'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3\nfrom = "tank"\nto = "ambient"\n'
    drawing = '[drawing]\ntank = { x = 1e300, y = -1e300 }\n"hole.from" = { points = [[1e300, 2]] }\n'
    tank = '[parts.tank]\nkind = "chamber"\nvolume = "1 l"\n'
    editor = start_editor(f'{tank}[parts.hole]\nkind = "orifice"\n{hole}[run]\nduration = "1 s"\n{drawing}')
    assert editor.part("tank").is_visible()


def test_names_of_files_are_never_markup(start_editor):
    name = "<img src=x onerror=window.hacked=1>.toml"
    editor = start_editor(files={name: PLANT.format(payload=PAYLOADS[0], more="")})
    editor.page.wait_for_timeout(300)
    assert editor.page.evaluate(IS_CLEAN)


def test_values_typed_by_a_user_are_never_markup(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    for payload in PAYLOADS:
        editor.select("tank")
        editor.type("tank.volume", payload)
        assert editor.page.evaluate(IS_CLEAN)
        editor.press("Escape", "Control+z")


def test_a_pasted_clipboard_is_checked(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    before = editor.text()
    editor.select("tank")
    for content in ("<img src=x onerror=window.hacked=1>", '{"parts": {"<b id=hacked>": {"kind": "x"}}}', "[[["):
        editor.page.evaluate(
            """content => { const clipboardData = new DataTransfer(); clipboardData.setData("text/plain", content);
            const event = new ClipboardEvent("paste", {clipboardData, bubbles: true});
            document.activeElement.dispatchEvent(event); }""",
            content,
        )
        editor.wait()
        assert editor.page.evaluate(IS_CLEAN)
    assert editor.text() == before


def test_the_policy_stops_scripts_that_are_not_of_the_server(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    response = editor.page.reload()
    policy = response.headers["content-security-policy"]
    directives = {part.split()[0]: part.split()[1:] for part in policy.split(";") if part.strip()}
    assert directives["default-src"] == ["'none'"]
    assert {*directives["script-src"]} == {"'self'", "'wasm-unsafe-eval'"}
    assert directives["connect-src"] == ["'self'"]
    assert directives["frame-ancestors"] == ["'none'"]
    editor.page.evaluate(
        """() => { const script = document.createElement("script"); script.textContent = "window.hacked = 1";
        document.body.append(script); const image = document.createElement("div");
        image.innerHTML = "<img src='data:,' onerror='window.hacked = 1'>"; document.body.append(image);
        script.remove(); }"""
    )
    editor.page.wait_for_timeout(100)
    assert editor.page.evaluate("() => window.hacked === undefined")
    refused = [problem for problem in editor.problems if "Content Security Policy" in problem]
    assert refused
    editor.problems.clear()  # they are what this test causes


def test_the_page_asks_only_its_own_server(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    requested: list[str] = []
    editor.page.on("request", lambda request: requested.append(request.url))
    editor.page.reload()
    editor.page.wait_for_function("() => window.poppet !== undefined")
    editor.wait()
    editor.add("chamber")
    origin = urllib.parse.urlsplit(editor.address)
    foreign = [url for url in requested if urllib.parse.urlsplit(url).netloc not in (origin.netloc, "")]
    assert requested
    assert foreign == []


def test_the_token_becomes_a_cookie(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""), own=True)
    assert "token" not in editor.page.url
    (cookie,) = editor.page.context.cookies()
    assert (cookie["httpOnly"], cookie["sameSite"]) == (True, "Strict")
    assert editor.page.evaluate("() => document.cookie") == ""


def test_a_stranger_gets_nothing(start_editor):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    host = urllib.parse.urlsplit(editor.address).netloc
    for path in ("/", "/document", "/palette", "/www/editor.js", "/model?revision=0"):
        connection = http.client.HTTPConnection(host, timeout=10)
        connection.request("GET", path)
        assert connection.getresponse().status == 403, path
        connection.close()


def test_two_tabs_show_the_same_file(start_editor, browser):
    editor = start_editor(PLANT.format(payload="plant", more=""))
    page = editor.page.context.new_page()
    second = Editor(editor.server, page)
    second.open(editor.page.url)
    assert second.text() == editor.text()
    editor.add("chamber")
    assert second.text() != editor.text()
    second.add("orifice")  # of a stale revision: the page takes the present state and repeats its operation
    assert {"chamber", "orifice"} <= {*second.names()}
    state = json.loads(second.page.evaluate("async () => (await fetch('/document')).text()"))
    assert second.text() == state["text"]
    editor.add("mass")
    assert {"chamber", "orifice", "mass"} <= {*editor.names()}
    assert second.problems == []
