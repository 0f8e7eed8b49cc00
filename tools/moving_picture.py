"""Film the live page of the paper's system for the README: `python tools/moving_picture.py`; needs Chromium.

The curves of the file are kept as A, the tank's volume is drawn to and fro, then the time runs and the poppet moves.
"""

from __future__ import annotations

import base64
import io
import sys
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))
browsers = import_module("chromium")
PAGE, PICTURE = ROOT / "docs/live/fill_staircase.html", ROOT / "docs/images/live.gif"
SHOWN = {"x": 0, "y": 145, "width": 1000, "height": 700, "scale": 0.84}
COLOURS, PACE, REST = 128, 120, 1500
"""Colours of the film, and how long a picture of it stands [ms], the last one longer."""
MOVED = """(() => {{ const range = document.querySelector('input[aria-label="{label}"]');
range.value = {value}; range.dispatchEvent(new Event("input", {{ bubbles: true }})); }})()"""


def film(browser: Any) -> list[Image.Image]:
    """The pictures of the film."""
    pictures = []

    def move(label: str, value: float) -> None:
        browser(MOVED.format(label=label, value=value))
        browser.settle()
        shot = browser.call("Page.captureScreenshot", clip=SHOWN, captureBeyondViewport=True)
        pictures.append(Image.open(io.BytesIO(base64.b64decode(shot["data"]))).convert("RGB"))

    ends = browser("""(() => { const range = document.querySelector('input[aria-label="tank.volume"]');
        return [range.min, range.max, range.value].map(Number); })()""")
    low, high, own = ends
    browser("document.getElementById('keep').click()")
    turns = [own, low + 0.1 * (high - low), high - 0.4 * (high - low), own]
    for begin, end in pairwise(turns):
        for value in np.linspace(begin, end, 9)[1:]:
            move("tank.volume", float(value))
    for moment in np.linspace(0.0, 60.0, 21):
        move("time shown in the drawing", float(moment))
    return pictures


def main() -> None:
    program = browsers.found()
    if program is None:
        sys.exit("There is no Chromium; POPPET_BROWSER may name one.")
    with browsers.Browser(program) as browser:
        browser.open(PAGE)
        pictures = film(browser)
    # Greys are many, colours few: an octree keeps the few.
    palette = pictures[len(pictures) // 4].quantize(COLOURS, Image.Quantize.FASTOCTREE)
    flat = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in pictures]
    times = [PACE] * (len(flat) - 1) + [REST]
    flat[0].save(PICTURE, save_all=True, append_images=flat[1:], duration=times, loop=0, optimize=True)
    print(f"{PICTURE}: {len(flat)} pictures, {PICTURE.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
