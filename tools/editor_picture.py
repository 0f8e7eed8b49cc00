"""Film the tutorial of the editor for its page: `python tools/editor_picture.py`; needs Chromium and Playwright.

The user of the acceptance test draws a cylinder drive. Then the user changes a flow control by its slider and moves
the time cursor through the run.
"""

from __future__ import annotations

import io
import sys
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))
browsers, pages, users = map(import_module, ("chromium", "editor_page", "editor_user"))
MouseUser: Any = users.MouseUser
PICTURE = ROOT / "docs/images/edit.gif"
SIZE, SCALE = (1280, 900), 0.68
COLOURS = 128
STEP, MOVE, REST = 700, 90, 2500
"""Durations of a picture [ms]: after an action, in a movement, and at the end."""
POINTER = ((0, 0), (0, 17), (4, 13), (7, 19), (10, 18), (7, 12), (12, 12))
"""Outline of a mouse pointer, which screenshots omit."""


class FilmedUser(MouseUser):  # type: ignore[misc]
    """A user with the mouse whose actions are filmed."""

    def __init__(self, editor: Any) -> None:
        super().__init__(editor)
        self.pictures: list[Image.Image] = []
        self.durations: list[int] = []

    def watch(self, duration: int = STEP) -> None:
        """Take a picture of the page with the pointer."""
        picture = Image.open(io.BytesIO(self.page.screenshot())).convert("RGB")
        x, y = self.pointer
        outline = [(x + dx, y + dy) for dx, dy in POINTER]
        ImageDraw.Draw(picture).polygon(outline, fill="white", outline="black")
        size = (round(SIZE[0] * SCALE), round(SIZE[1] * SCALE))
        self.pictures.append(picture.resize(size, Image.Resampling.LANCZOS))
        self.durations.append(duration)

    def slide(self, slider: Any, parts: tuple[float, ...]) -> None:
        """Drag a slider to fractions of its width."""
        slider.scroll_into_view_if_needed()
        left, top, right, bottom = self.editor.box(slider)
        y, thumb = (top + bottom) / 2.0, 8.0
        self.page.mouse.move(left + thumb + parts[0] * (right - left - 2.0 * thumb), y)
        self.page.mouse.down()
        for part in parts:
            self.pointer = left + thumb + part * (right - left - 2.0 * thumb), y
            self.page.mouse.move(*self.pointer)
            self.page.wait_for_timeout(150)  # the run and its picture
            self.watch(MOVE)
        self.page.mouse.up()
        self.editor.wait()


def film(user: FilmedUser) -> None:
    """Draw the circuit, change a number, and move through the run."""
    user.watch()
    users.draw_cylinder_drive(user)
    user.select("flow_control_valve_2")
    throttle = user.page.locator('[data-slider="flow_control_valve_2.throttle_conductance"]')
    user.slide(throttle, (0.5, 0.6, 0.7, 0.8, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.0))
    user.watch()
    user.slide(user.page.locator("#curves input[type=range]").first, tuple(k / 30.0 for k in range(31)))
    user.durations[-1] = REST


def main() -> None:
    from playwright.sync_api import sync_playwright

    program = browsers.found()
    if program is None:
        sys.exit("Chromium is not installed; POPPET_BROWSER can contain its path.")
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as driver:
        folder = Path(temporary) / "work"
        folder.mkdir()
        server = pages.Server(folder, "drive.toml")
        browser = driver.chromium.launch(executable_path=program, args=list(pages.FLAGS))
        page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]}, locale="en-US")
        user = FilmedUser(pages.Editor(server, page).open())
        film(user)
        browser.close()
        server.stop()
    # One palette for all: the colours of errors are in the first half, those of curves and pressures in the second.
    chosen = [user.pictures[round(part * (len(user.pictures) - 1))] for part in (0.1, 0.3, 0.5, 1.0)]
    both = Image.new("RGB", (chosen[0].width, chosen[0].height * len(chosen)))
    for k, picture in enumerate(chosen):
        both.paste(picture, (0, k * picture.height))
    palette = both.quantize(COLOURS, Image.Quantize.FASTOCTREE)
    flat = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in user.pictures]
    flat[0].save(PICTURE, save_all=True, append_images=flat[1:], duration=user.durations, loop=0, optimize=True)
    print(f"{PICTURE}: {len(flat)} pictures, {PICTURE.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
