"""The scripts and styles of plots, as they stand in a page: no page asks for anything from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from functools import cache
from importlib.resources import files
from typing import Any

MARK = 'class="plot-data"'
"""What a page with such plots contains."""
STYLE = """
.live { display: none; } figure.is-live > .live { display: flex; flex-wrap: wrap; gap: .2rem .8rem; }
figure.is-live > .still { display: none; }
.panel { flex: 1 1 100%; min-width: 0; position: relative; } .panel .u-over { touch-action: pan-y; }
.keys { display: flex; flex-wrap: wrap; gap: 0 .9rem; padding: .3rem 0 0 3.4rem; font-size: .8rem; line-height: 1.5; }
.keys .name { font-weight: 600; } .keys .unit { color: var(--ink); } .keys .at { color: var(--soft); min-width: 7rem; }
.keys .at:empty { min-width: 0; }
.key { all: unset; cursor: pointer; display: inline-flex; align-items: baseline; gap: .35rem; min-height: 1.5rem; }
.key:focus-visible { outline: 2px solid var(--ink); } .key[aria-pressed="false"] { opacity: .4; }
.key i { width: .8rem; height: .8rem; align-self: center; border-radius: .15rem; } .key i.line { height: .2rem; }
.key b { font-variant-numeric: tabular-nums; } .key b:empty { display: none; }
.live > .notes, .live > .foot { flex: 1 1 100%; color: var(--soft); font-size: .8rem; margin: .2rem 0; }
.foot button { margin-left: .6rem; font: inherit; color: var(--ink); background: var(--wash);
  border: 1px solid var(--line); border-radius: .3rem; padding: .1rem .6rem; cursor: pointer; }
.foot strong { color: var(--ink); font-weight: 600; }
.u-select { background: #5b9bd544; } .u-hz .u-cursor-x, .u-vt .u-cursor-y { border-right-color: var(--soft); }
@media (max-width: 40rem) { .panel { flex-basis: 100% !important; order: var(--place); }
  .live > .notes, .live > .foot { order: 99; } .keys { padding-left: 0; } }
@media print { .live { display: none !important; } figure.is-live > .still { display: block !important; } }
"""

# uPlot asks for the format of a language that browsers without any locale name wrongly.
_LOCALE = (
    'try{new Intl.NumberFormat(navigator.language)}catch{Object.defineProperty(navigator,"language",{value:"en-US"})}'
)


def data_element(data: dict[str, Any]) -> str:
    """The numbers of a figure; nothing in a name can end the element, and an XML reader takes it too.

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
    """uPlot and what draws with it, in one text."""
    place = files("poppet.report.plots")
    own = tight((place / "plots.js").read_text(encoding="utf-8"))
    library = (place / "uplot" / "uPlot.iife.min.js").read_text(encoding="utf-8")
    return f"{_LOCALE}\n{library.strip()}\n{own}"


def tight(script: str) -> str:
    """A script without its comments and indents."""
    lines = (line.strip() for line in re.sub(r"/\*.*?\*/", "", script, flags=re.DOTALL).splitlines())
    return "\n".join(filter(None, lines)) + "\n"


@cache
def style() -> str:
    """The style of uPlot and of the plots."""
    text = (files("poppet.report.plots") / "uplot" / "uPlot.min.css").read_text(encoding="utf-8")
    return f"{text.strip()}\n{STYLE.strip()}\n"


def policy(*scripts: str, computes: bool = False) -> str:
    """What a browser may do with a page: run these scripts, which may use WebAssembly, and ask nobody for anything."""
    hashes = (base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in scripts)
    allowed = " ".join(f"'sha256-{each}'" for each in hashes) or "'none'"
    allowed += " 'wasm-unsafe-eval'" * computes
    rules = f"default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src {allowed}; base-uri 'none'"
    return f'<meta http-equiv="Content-Security-Policy" content="{rules}; form-action \'none\'">\n'
