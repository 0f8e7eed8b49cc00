"""Page of a served circuit in Chromium: values, inputs, faults, alarms, restarts and pages opened from a disk."""

from __future__ import annotations

import argparse
import asyncio
import math
import re
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("websockets", reason="the extra serve is not installed")

import poppet
from poppet.deploy.live.live_page import live_page
from poppet.serve.adapters import AdapterSettings
from poppet.serve.live_server import make_adapter
from poppet.serve.machine import Machine

ROOT = Path(__file__).parents[2]
TANK, TWIN = ROOT / "examples/serve/watched_tank.toml", ROOT / "examples/watch/twin.toml"
CHECKS = (ROOT / "tests/accessibility.js").read_text(encoding="utf-8")
TOKEN = "a-token-of-the-tests"
REFUSED = re.compile(r"WebSocket connection to .* failed")
"""The browser reports connections that a stopped server refuses."""


class PageServer:
    """Server of the page of a machine, whose event loop runs in a thread."""

    def __init__(self, machine: Machine, port: int, twin: Path | None = None) -> None:
        options = argparse.Namespace(watch=None if twin is None else str(twin))
        self.adapter = make_adapter(AdapterSettings(f"127.0.0.1:{port}", machine.served, options, print))
        self.machine, self.port = machine, port
        self.is_listening = threading.Event()
        self.thread = threading.Thread(target=lambda: asyncio.run(self._serve()))
        self.thread.start()
        assert self.is_listening.wait(30.0)

    async def _serve(self) -> None:
        self.loop = asyncio.get_running_loop()
        self.task = asyncio.create_task(self.adapter.run(self.machine, lambda note: self.is_listening.set()))
        with suppress(asyncio.CancelledError):
            await self.task

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}/?token={TOKEN}"

    def stop(self) -> None:
        self.loop.call_soon_threadsafe(self.task.cancel)
        self.thread.join(30.0)
        assert not self.thread.is_alive()


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@pytest.fixture
def machine() -> Machine:
    machine = poppet.load(TANK).serve("10 ms", clock=False)
    machine.advance("10 ms")
    return machine


@pytest.fixture
def start(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., PageServer]]:
    """Function that starts a server of the machine."""
    monkeypatch.setenv("POPPET_LIVE_TOKEN", TOKEN)
    with ExitStack() as stack:

        def begin(port: int | None = None, twin: Path | None = None, machine: Machine = machine) -> PageServer:
            server = PageServer(machine, port or free_port(), twin)
            stack.callback(lambda: server.stop() if server.thread.is_alive() else None)
            return server

        yield begin


@pytest.fixture
def show(browser: Any) -> Iterator[Callable[..., Any]]:
    """Function that opens an address in a new context; at the end, no page has reported an error."""
    problems: list[str] = []
    with ExitStack() as stack:

        def open_page(url: str, width: int = 1200, scheme: str = "light", height: int = 900) -> Any:
            size = {"width": width, "height": height}
            context = browser.new_context(viewport=size, color_scheme=scheme, locale="en-US")
            stack.callback(context.close)
            page = context.new_page()
            page.on("pageerror", lambda error: problems.append(str(error)))
            page.on("console", lambda message: problems.append(message.text) if message.type == "error" else None)
            page.goto(url)
            page.wait_for_selector("body.is-ready")
            return page

        yield open_page
    assert [text for text in problems if not REFUSED.search(text)] == []


def shown_pressure(page: Any) -> float:
    """Pressure of the tank in the drawing [bar]."""
    text = page.locator("#drawing text", has_text=re.compile("^tank.pressure")).text_content()
    number = text.partition("p ")[2].removesuffix(" bar")
    return math.nan if number == "-" else float(number)


def wait_for(page: Any, is_true: Callable[[], bool]) -> None:
    for _ in range(300):
        if is_true():
            return
        page.wait_for_timeout(50)
    raise AssertionError("the page has not reached this state")


def test_values_are_those_of_the_machine(start: Any, show: Any, machine: Machine) -> None:
    page = show(start().url)
    assert "token" not in page.url
    time = page.locator(".facts dd").first
    for _ in range(3):
        expected = machine.advance(1.0)
        wait_for(page, lambda: time.text_content() == f"{machine.snapshot().time:.2f} s")
        assert shown_pressure(page) == pytest.approx(expected["tank.pressure"] / 1e5, abs=5.1e-5)
    # The curves contain all rows since the page was opened, apart from those that are omitted.
    time, values = page.evaluate(
        "(() => { const k = connected.outputs.findIndex(o => o.address === 'tank.pressure');"
        " return [connected.window.time, connected.window.series.get(connected.columns[k])]; })()"
    )
    _, rows = machine.rows(0)
    column = machine.row_names.index("tank.pressure")
    places = np.round(np.array(time) / machine.period).astype(int)
    assert len(places) > 100
    np.testing.assert_allclose(values[1:], rows[places[1:], column], rtol=1e-7)
    assert page.locator(".state").text_content() == "Running"


def test_sliders_and_fields_write(start: Any, show: Any, machine: Machine) -> None:
    page = show(start().url)
    slider = page.get_by_role("slider", name="supply.pressure")
    before = machine.snapshot()["supply.pressure"]
    slider.press("PageUp")
    wait_for(page, lambda: machine.snapshot()["supply.pressure"] == pytest.approx(before + 0.1 * 1.5 * before))
    field = page.get_by_role("textbox", name="supply.pressure")
    field.fill("9,5")
    field.press("Tab")
    wait_for(page, lambda: machine.snapshot()["supply.pressure"] == pytest.approx(9.5e5))
    field = page.get_by_role("textbox", name="leak.opening")
    for text in ("1.5", "much"):
        field.fill(text)
        field.press("Tab")
        why = page.locator(
            ".row", has=page.locator(f"#{field.get_attribute('id').replace('.', chr(92) + '.')}")
        ).locator(".why")
        assert why.text_content() == "Enter a number, at least 0 and at most 1. 1  stays in use."
        assert field.get_attribute("aria-invalid") == "true"
    assert machine.snapshot()["leak.opening"] == 1.0
    page.get_by_role("button", name="supply.pressure as at the start").click()
    wait_for(page, lambda: machine.snapshot()["supply.pressure"] == before)


def test_a_fault_is_switched_and_a_second_page_shows_it(start: Any, show: Any, machine: Machine) -> None:
    url = start().url
    first, second = show(url), show(url)
    first.get_by_role("combobox", name="drain").select_option("leak")
    wait_for(first, lambda: machine.fault_of("drain") == "leak")
    wait_for(second, lambda: second.get_by_role("combobox", name="drain").input_value() == "leak")
    assert second.get_by_text("Present: drain leak.").is_visible()
    machine.set_fault("drain", "none")
    wait_for(first, lambda: first.get_by_text("No valve has a fault.").is_visible())


def test_a_fault_that_is_switched_on_the_page_raises_its_alarm(start: Any, show: Any, machine: Machine) -> None:
    url = start(twin=TWIN).url
    page = show(url)

    def advance(duration: float) -> None:
        machine.advance(duration)
        time = machine.snapshot().time
        wait_for(page, lambda: page.evaluate("connected.watched.time.at(-1) ?? 0") > time - 0.2)

    for _ in range(41):
        advance(1.0)
    assert page.locator(".condition .is-alarm").count() == 0
    page.get_by_role("combobox", name="drain").select_option("leak")
    wait_for(page, lambda: machine.fault_of("drain") == "leak")
    for _ in range(20):
        advance(1.0)
    assert page.locator(".verdict-line.is-alarm").text_content().startswith("leak has changed by ")
    assert page.locator("tr.is-alarm th").text_content() == "leak"
    (event,) = page.locator(".events li").all_text_contents()
    assert re.match(r"4\d\.\d s: alarm leak\. leak has changed by ", event)
    # A page that is opened later shows the alarm, too.
    later = show(url)
    wait_for(later, lambda: later.locator(".events li").all_text_contents() == [event])


def test_a_page_reconnects_after_a_restart(start: Any, show: Any, machine: Machine) -> None:
    server = start()
    page = show(server.url)
    server.stop()
    wait_for(page, lambda: page.get_by_text("The page tries again.").is_visible())
    assert page.get_by_role("combobox", name="drain").is_disabled()
    start(server.port)
    wait_for(page, lambda: page.get_by_text("Connected to").is_visible())
    machine.advance(1.0)
    wait_for(page, lambda: shown_pressure(page) == pytest.approx(machine.snapshot()["tank.pressure"] / 1e5, abs=5.1e-5))
    assert page.get_by_text("The server was started again.").is_visible()


def test_an_exported_page_connects_from_a_disk(start: Any, show: Any, machine: Machine, tmp_path: Path) -> None:
    server = start()
    file = tmp_path / "page.html"
    file.write_text(live_page(poppet.load(TANK)), encoding="utf-8")
    page = show(f"{file.as_uri()}#connect=ws://127.0.0.1:{server.port}&token={TOKEN}")
    machine.advance(2.0)
    wait_for(page, lambda: shown_pressure(page) == pytest.approx(machine.snapshot()["tank.pressure"] / 1e5, abs=5.1e-5))
    page.get_by_role("combobox", name="drain").select_option("leak")
    wait_for(page, lambda: machine.fault_of("drain") == "leak")


def test_a_page_from_a_disk_needs_the_token(start: Any, browser: Any, tmp_path: Path) -> None:
    server = start()
    file = tmp_path / "page.html"
    file.write_text(live_page(poppet.load(TANK)), encoding="utf-8")
    page = browser.new_page()
    page.goto(f"{file.as_uri()}#connect=ws://127.0.0.1:{server.port}&token=other")
    wait_for(page, lambda: page.get_by_text("The page tries again.").is_visible())
    assert server.adapter.statistics.total == 0
    page.close()


def test_curves_are_added(start: Any, show: Any, machine: Machine) -> None:
    page = show(start().url)
    machine.advance(1.0)
    choice = page.get_by_label("curve to add")
    assert not page.get_by_text("temperature [°C]").is_visible()
    choice.select_option(label="tank.temperature")
    assert page.get_by_text("temperature [°C]").is_visible()
    machine.advance(1.0)
    script = "connected.plot.panels.flatMap(p => p.spec.lines).find(l => l.label === 'tank.temperature').y.at(-1)"
    wait_for(
        page, lambda: page.evaluate(script) == pytest.approx(machine.snapshot()["tank.temperature"] - 273.15, abs=1e-3)
    )


TUBE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "inlet"
exhaust = "ambient"
sonic_conductance = "1.2 dm^3/(s bar)"
critical_ratio = 0.3
[parts.inlet]
kind = "chamber"
volume = "10 cm^3"
[parts.hose]
kind = "tube"
from = "inlet"
to = "tank"
length = "4 m"
bore = "4 mm"
cells = 3
wall_conductance = "1 W/K"
[parts.tank]
kind = "chamber"
volume = "1 l"
[signals."valve.command"]
kind = "constant"
value = 1
[run]
duration = "1 s"
"""


@pytest.fixture
def tube_machine() -> Machine:
    machine = poppet.loads(TUBE).serve("20 ms", clock=False)
    machine.advance("20 ms")
    return machine


def last_edges(page: Any, quantity: str) -> list[Any]:
    """Labels and last values of the lines of the tube in the panel of a quantity."""
    script = """quantity => connected.plot.panels.find(({ spec }) => spec.y.label.startsWith(quantity))
        .spec.lines.filter(({ label }) => /hose/.test(label))
        .map(({ label, y, high }) => [label, y.at(-1), high.at(-1)])"""
    edges: list[Any] = page.evaluate(script, quantity)
    return edges


@pytest.mark.parametrize("is_exported", [False, True])
def test_the_cells_of_a_tube_are_one_band(
    start: Any, show: Any, tube_machine: Machine, tmp_path: Path, is_exported: bool
) -> None:
    server, exported = start(machine=tube_machine), tmp_path / "page.html"
    exported.write_text(live_page(poppet.loads(TUBE)), encoding="utf-8")
    url = f"{exported.as_uri()}#connect=ws://127.0.0.1:{server.port}&token={TOKEN}" if is_exported else server.url
    page = show(url, height=2400)
    tube_machine.advance(0.2)
    cells = [tube_machine.snapshot()[f"hose.{k}.pressure"] / 1e5 for k in (1, 2, 3)]
    assert max(cells) - min(cells) > 0.01
    expected = ["hose, cells 1 to 3", *(pytest.approx(edge(cells), rel=1e-6) for edge in (min, max))]
    wait_for(page, lambda: last_edges(page, "pressure") == [expected])
    # All panels have the same time axis, also that of the bars.
    ends = page.evaluate("connected.plot.panels.filter(p => !p.box.hidden).map(p => p.u.scales.x.max)")
    assert len(ends) > 1
    assert ends == [ends[0]] * len(ends)


def test_a_band_is_added(start: Any, show: Any, tube_machine: Machine) -> None:
    page = show(start(machine=tube_machine).url)
    choice = page.get_by_label("curve to add")
    choice.select_option(label="hose.temperature, cells 1 to 3")
    names = choice.locator("option").all_text_contents()
    assert not any("cells" in name for name in names if "temperature" in name or ".pressure" in name)
    assert {"hose.2.pressure", "hose.2.temperature"} <= set(names)
    tube_machine.advance(0.2)
    cells = [tube_machine.snapshot()[f"hose.{k}.temperature"] - 273.15 for k in (1, 2, 3)]
    assert max(cells) - min(cells) > 0.1
    expected = ["hose.temperature, cells 1 to 3", *(pytest.approx(edge(cells), abs=1e-3) for edge in (min, max))]
    wait_for(page, lambda: last_edges(page, "temperature") == [expected])


@pytest.mark.parametrize("width", [1200, 360])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_is_accessible(start: Any, show: Any, machine: Machine, width: int, scheme: str) -> None:
    machine.set_fault("drain", "leak")
    page = show(start(twin=TWIN).url, width, scheme)
    machine.advance(1.0)
    page.wait_for_selector(".condition td:not(:empty)")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for check in ("withoutName", "doubleIds", "lowContrast"):
        assert page.evaluate(f"(() => {{ {CHECKS}; return {check}(); }})()") == [], check
