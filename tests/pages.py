"""What tests ask of a page: it needs nothing else, and its plots hold the numbers of their pictures."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from typing import Any

import numpy as np

SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)
DATA = re.compile(r'<script type="application/json" class="plot-data">(.*?)</script>', re.DOTALL)
POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">')


def needs_nothing_else(text: str, *, connects: str = "") -> None:
    """The page names no address elsewhere, a browser may ask for none, and runs the scripts of the page alone.

    Scripts of a page with `connects` can connect to these sources.
    """
    bare = SCRIPT.sub("", text)
    addresses = set(re.findall(r"https?:[^\"' <)]+", bare))
    assert addresses <= {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"}
    assert re.search(r"@import|url\((?!#)|<(link|img|iframe)\b|<script[^>]* src", bare) is None
    assert re.search(r"<image\b(?![^>]*href=\"data:)", bare) is None
    (rules,) = POLICY.findall(text)
    assert rules.startswith("default-src 'none'; ")
    assert re.findall(r"connect-src ([^;]*)", rules) == ([connects] if connects else [])
    hashes = [base64.b64encode(hashlib.sha256(own.encode()).digest()).decode() for own in SCRIPT.findall(text)]
    allowed = " ".join(f"'sha256-{each}'" for each in hashes) or "'none'"
    allowed += " 'wasm-unsafe-eval'" * ("WebAssembly" in text)
    assert f"script-src {allowed};" in rules


def plots(text: str) -> list[dict[str, Any]]:
    """The numbers of the plots of a page, in their order."""
    return [json.loads(each) for each in DATA.findall(text)]


def column(plot: dict[str, Any], place: int) -> np.ndarray:
    """A series of a plot."""
    own = plot["columns"][place]
    if isinstance(own, dict):
        return own["from"] + own["step"] * np.arange(own["count"])
    return np.array([np.nan if value is None else value for value in own], dtype=float)


def lines(plot: dict[str, Any]) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Label to places and values; of lines that share a label the first."""
    found: dict[str, tuple[np.ndarray, np.ndarray]] = {}
    for panel in plot["panels"]:
        for line in panel.get("lines", ()):
            name = f"{panel['y']['label']}: {line['label']}"
            found.setdefault(name, (column(plot, line["x"]), column(plot, line["y"])))
    return found
