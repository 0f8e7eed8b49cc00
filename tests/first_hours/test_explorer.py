"""The explorer: a slider of the front page, a live page of the gallery, and its circuit in the editor."""

from __future__ import annotations

import http.client
import re
import shlex
import shutil
import threading
import time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

import chromium

ROOT = Path(__file__).parents[2]
CHECKS = (ROOT / "tests" / "accessibility.js").read_text(encoding="utf-8")
EXAMPLE = "cylinder_meter_out"
LARGEST = 600_000
"""Limit of what a browser receives for the front page [B]."""


class _Quiet(SimpleHTTPRequestHandler):
    """Files of a folder, without lines on the terminal."""

    def log_message(self, *_: object) -> None:
        """Print nothing."""


@pytest.fixture(scope="module")
def address(site):
    """Address of the website on a server of this computer."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(site)))
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    thread.join()
    server.server_close()


@pytest.fixture(scope="module")
def browser():
    """Chromium, for all tests of the module."""
    program = chromium.found()
    if program is None:
        pytest.skip("Chromium is not installed; POPPET_BROWSER can contain its path")
    with chromium.Browser(program) as opened:
        opened.call("Network.setCacheDisabled", cacheDisabled=True)
        yield opened


def wait_for(browser, condition: str) -> None:
    """Wait until an expression is true."""
    end = time.monotonic() + chromium.PATIENCE
    while not browser(condition):
        assert time.monotonic() < end, condition
        time.sleep(0.05)


def visit(browser, url: str, width: int, scheme: str = "light", height: int = 800) -> None:
    """Open a page of a server in a window of a given size."""
    browser.call(
        "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 500
    )
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    browser.call("Page.navigate", url=url)
    wait_for(browser, f"document.readyState === 'complete' && location.href === {url!r}")
    browser.settle()


def edges(browser, side: str, *names: str) -> list[float]:
    """Return the positions of one side of elements in the window [px]."""
    return browser(f"{[*names]}.map(name => document.querySelector(name).getBoundingClientRect().{side})")


def received(browser) -> int:
    """Return the bytes that the browser has received since the last call."""
    browser("0")  # the events before this reply are here
    events = [event for event in browser.events if event["method"] == "Network.loadingFinished"]
    browser.events.clear()
    return sum(int(event["params"]["encodedDataLength"]) for event in events)


@pytest.mark.parametrize("width", [1200, 360])
def test_a_slider_of_the_front_page_changes_its_plot(browser, address, width):
    browser.events.clear()
    visit(browser, f"{address}/index.html", width)
    wait_for(browser, "globalThis.front?.count === 1")
    assert 0 < received(browser) < LARGEST
    ends = edges(browser, "bottom", ".sketch", "#plot", "#pilot", "#volume")
    assert max(ends) < 800  # all visible without scrolling
    assert browser("document.documentElement.scrollWidth") == width
    before = browser("document.querySelector('#plot .curve.tank').getAttribute('d')")
    browser("document.getElementById('play').click()")  # pause
    browser("document.getElementById('pilot').focus()")
    browser.press("ArrowRight", "ArrowRight")
    wait_for(browser, "front.count === 3")
    after = browser("document.querySelector('#plot .curve.tank').getAttribute('d')")
    assert after != before
    assert browser("document.querySelector('#plot .curve.first').getAttribute('d')") == before
    assert browser("document.getElementById('pilot-shown').value") == "2.2 bar g"


def test_the_poppet_moves_and_the_numbers_are_those_of_a_run(browser, address):
    import poppet
    from poppet.cli.commands import COMMANDS

    assert "new" in COMMANDS
    visit(browser, f"{address}/index.html", 1200)
    wait_for(browser, "globalThis.front?.count === 1")
    browser("document.getElementById('play').textContent === 'Pause' && document.getElementById('play').click()")
    template = ROOT / "src" / "poppet" / "cli" / "templates" / "valve-fill.toml"
    run = poppet.load(template).simulate()
    places = []
    for at in (10.0, 30.0, 60.0):
        browser(
            "(() => { const box = document.getElementById('plot').getBoundingClientRect();"
            f"const x = box.left + 30 + (box.width - 40) * {at} / 120;"
            "document.getElementById('plot').dispatchEvent(new PointerEvent('pointermove',"
            "{ clientX: x, clientY: box.top + 50, pointerType: 'touch', bubbles: true })); })()"
        )
        shown = float(browser("document.getElementById('tank-value').textContent").removesuffix(" bar"))
        expected = float(run.converted(["bar"])["tank.pressure"][round(at / 0.1)])
        assert shown == pytest.approx(expected, abs=0.011)
        places.append(float(re.findall(r"-?[\d.]+", browser("document.getElementById('poppet').outerHTML"))[1]))
    assert places[2] < 0.0 < places[0] < places[1]


def test_a_card_of_the_gallery_leads_to_a_live_page_and_to_the_editor(browser, address, installed, tmp_path):
    visit(browser, f"{address}/index.html", 1200)
    browser("[...document.querySelectorAll('a')].find(link => link.textContent === 'Gallery').click()")
    wait_for(browser, f"document.querySelector('#{EXAMPLE} a.title') !== null")
    browser(f"document.querySelector('#{EXAMPLE} a.title').click()")
    wait_for(browser, "globalThis.live?.state.count > 0 && document.body.classList.contains('is-ready')")
    assert browser("document.querySelector('h1').textContent").startswith("Cylinder with meter-out")
    count = browser("live.state.count")
    browser("document.querySelector('#sliders input[type=range]').focus()")
    browser.press("ArrowRight")
    wait_for(browser, f"live.state.count > {count}")
    assert browser("live.state.runs.now.ended.status") == "done"
    browser("navigator.clipboard.writeText = async text => { globalThis.copied = text; }")
    browser("document.querySelector('.bar summary').click()")
    browser("document.querySelector('.bar [data-copy]').click()")
    wait_for(browser, "globalThis.copied")
    command = browser("copied")
    assert command == f"poppet edit examples/{EXAMPLE}.toml"
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    editor = installed.start(*shlex.split(command), "--no-browser", folder=tmp_path)
    try:
        match = re.search(r"http://(127\.0\.0\.1:\d+)(/\?token=\S+)", editor.stdout.readline())
        connection = http.client.HTTPConnection(match[1], timeout=60.0)
        connection.request("GET", match[2])
        assert connection.getresponse().status in (200, 302, 303)
        connection.close()
    finally:
        editor.terminate()
        editor.wait(60.0)
        editor.stdout.close()


def test_on_a_telephone_drawing_and_plot_come_before_the_sliders(browser, address):
    visit(browser, f"{address}/gallery/live/{EXAMPLE}.html", 360, height=740)
    wait_for(browser, "document.body.classList.contains('is-ready')")
    assert browser("document.documentElement.scrollWidth") == 360
    tops = browser(
        "['#drawing', '#curves .panel', '#reset'].map(n => document.querySelector(n).getBoundingClientRect().top)"
    )
    assert tops == sorted(tops)
    # The sliders stay at the lower edge of the window.
    assert browser("document.getElementById('sliders').getBoundingClientRect().bottom") == pytest.approx(740, abs=2)
    sizes = browser("[...document.querySelectorAll('#drawing text')].map(text => text.getBoundingClientRect().height)")
    assert min(sizes) >= 12.0


def test_pages_fit_a_telephone_and_their_tables_are_cards(browser, address):
    for page in ("gallery/index.html", "compare.html", "docs/live.html", "validation.html"):
        visit(browser, f"{address}/{page}", 360)
        assert browser("document.documentElement.scrollWidth") == 360, page
    rows = "[...document.querySelectorAll('table.cards tbody tr')].map(row => getComputedStyle(row).display)"
    assert {*browser(rows)} == {"block"}
    visit(browser, f"{address}/validation.html", 1200)
    assert {*browser(rows)} == {"table-row"}


def test_paper_is_light(browser, address):
    visit(browser, f"{address}/docs/live.html", 1200, "dark")
    assert browser("document.documentElement.dataset.theme") == "dark"
    browser.call(
        "Emulation.setEmulatedMedia", media="print", features=[{"name": "prefers-color-scheme", "value": "dark"}]
    )
    wait_for(browser, "document.documentElement.dataset.theme === 'light'")
    browser.call("Emulation.setEmulatedMedia", media="", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    wait_for(browser, "document.documentElement.dataset.theme === 'dark'")


PAGES = ("index.html", "gallery/index.html", f"gallery/live/{EXAMPLE}.html", "docs/live.html")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("page", PAGES)
def test_controls_have_names_and_texts_have_contrast(browser, address, page, scheme):
    visit(browser, f"{address}/{page}", 1200, scheme)
    if "live/" in page:
        wait_for(browser, "document.body.classList.contains('is-ready')")
    wait_for(browser, "document.getAnimations().length === 0")  # colours of the theme have arrived
    for check in ("withoutName", "doubleIds", "lowContrast"):
        assert browser(f"(() => {{ {CHECKS}\nreturn {check}(); }})()") == [], check
