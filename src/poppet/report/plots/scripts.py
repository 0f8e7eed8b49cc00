"""Scripts and style sheets of interactive plots, which a page contains completely."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from functools import cache
from importlib.resources import files
from typing import Any

from poppet.report.styles import stylesheet

MARK = 'class="plot-data"'
"""Attribute of the data elements of plots."""
# uPlot needs a valid language; browsers without a locale report an invalid one.
_LOCALE = (
    'try{new Intl.NumberFormat(navigator.language)}catch{Object.defineProperty(navigator,"language",{value:"en-US"})}'
)


def data_element(data: dict[str, Any]) -> str:
    """Return the data of a figure as an HTML element.

    Special characters are escaped for HTML and XML.

    Examples
    --------
    >>> print(data_element({"a": "</script>"}))
    <script type="application/json" class="plot-data">{"a":"\\u003c/script\\u003e"}</script>
    """
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return f'<script type="application/json" {MARK}>{text}</script>'


@cache
def script() -> str:
    """Return the JavaScript of the plots: the library uPlot and the script that uses it."""
    folder = files("poppet.report.plots")
    plots = tight((folder / "plots.js").read_text(encoding="utf-8"))
    library = (folder / "uplot" / "uPlot.iife.min.js").read_text(encoding="utf-8")
    return f"{_LOCALE}\n{library.strip()}\n{plots}"


def tight(script: str) -> str:
    """Return a script without its comments and indentation."""
    lines = (line.strip() for line in re.sub(r"/\*.*?\*/", "", script, flags=re.DOTALL).splitlines())
    return "\n".join(filter(None, lines)) + "\n"


@cache
def style() -> str:
    """Return the style sheets of uPlot and of the plots."""
    text = (files("poppet.report.plots") / "uplot" / "uPlot.min.css").read_text(encoding="utf-8")
    return f"{text.strip()}\n{stylesheet('plots').strip()}\n"


def policy(*scripts: str, computes: bool = False) -> str:
    """Return a content security policy that permits only the given scripts.

    With `computes`, the policy also permits WebAssembly.
    """
    hashes = (base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in scripts)
    allowed = " ".join(f"'sha256-{digest}'" for digest in hashes) or "'none'"
    allowed += " 'wasm-unsafe-eval'" * computes
    rules = f"default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src {allowed}; base-uri 'none'"
    return f'<meta http-equiv="Content-Security-Policy" content="{rules}; form-action \'none\'">\n'
