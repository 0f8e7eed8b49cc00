"""Frame of the HTML output in notebooks: style, title and notes.

Text inherits the colour of the notebook; lines and backgrounds are mixed from it. The output therefore suits light and
dark themes of classic notebooks, JupyterLab and VS Code.
"""

from __future__ import annotations

import html
from collections.abc import Iterable

from poppet.core.codes import Note
from poppet.core.note_groups import grouped
from poppet.report.html_page import Content, folded, items, render

STYLE = """
.poppet-card { --paper: var(--jp-layout-color0, var(--vscode-editor-background, Canvas));
  --line: color-mix(in srgb, currentColor 22%, transparent);
  color: var(--jp-content-font-color1, var(--vscode-editor-foreground, inherit));
  max-width: 56rem; font-size: 13px; line-height: 1.45; overflow-wrap: anywhere; }
.poppet-card * { box-sizing: border-box; }
.poppet-card .poppet-head { font-size: 14px; font-weight: 600; }
.poppet-card p { margin: .25em 0; }
.poppet-card .lead, .poppet-card caption { opacity: .72; text-align: left; }
.poppet-card .scroll { overflow-x: auto; max-width: 100%; }
.poppet-card table { border-collapse: collapse; margin: .4em 0; font-size: 12px; font-variant-numeric: tabular-nums; }
.poppet-card th, .poppet-card td { padding: .2em 1em .2em 0; text-align: left; vertical-align: top; background: none;
  border: 0; border-bottom: 1px solid var(--line); max-width: 30rem; white-space: normal; overflow-wrap: normal; }
.poppet-card th { font-weight: 600; }
.poppet-card .number { text-align: right; white-space: nowrap; }
.poppet-card code { font-size: 12px; background: none; color: inherit; }
.poppet-card .verdict { white-space: nowrap; font-weight: 600; }
.poppet-card details { margin: .4em 0; } .poppet-card summary { cursor: pointer; }
.poppet-card ul { margin: .3em 0; padding-left: 1.4em; }
.poppet-card .poppet-panel { margin: .5em 0 .1em; }
.poppet-card .poppet-key span { white-space: nowrap; margin-left: .9em; }
.poppet-card .poppet-key i { display: inline-block; width: 1em; height: .2em; margin-right: .35em;
  vertical-align: .25em; }
.poppet-card .poppet-plot { display: grid; grid-template-columns: 4.4em minmax(0, 1fr); }
.poppet-card .poppet-ends { display: flex; flex-direction: column; justify-content: space-between; text-align: right;
  padding-right: .5em; white-space: nowrap; font-size: 11px; line-height: 1.1; opacity: .8;
  font-variant-numeric: tabular-nums; }
.poppet-card .poppet-plot svg { display: block; width: 100%; height: 84px; border-left: 1px solid var(--line);
  border-bottom: 1px solid var(--line); }
.poppet-card .poppet-plot path { fill: none; stroke-width: 1.5; vector-effect: non-scaling-stroke; }
.poppet-card .poppet-time { display: flex; justify-content: space-between; margin-left: 4.4em; font-size: 11px;
  opacity: .8; }
.poppet-card .poppet-picture svg { display: block; height: auto; }
"""
MAX_ROWS = 12
"""Maximum number of rows of an unfolded table."""


def card(title: str, lead: str, *blocks: Content) -> str:
    """Return the output of one object: title and lead are text, blocks are HTML or tables.

    Examples
    --------
    >>> card("a < b", "Recording").partition("</style>")[2]
    '<p><span class="poppet-head">a &lt; b</span> <span class="lead">Recording</span></p></div>'
    """
    name = f'<span class="poppet-head">{html.escape(title)}</span> ' if title else ""
    head = f'<p>{name}<span class="lead">{html.escape(lead)}</span></p>'
    return f'<div class="poppet-card"><style>{STYLE}</style>{head}{"".join(map(render, blocks))}</div>'


def note_list(notes: Iterable[Note]) -> str:
    """Return notes as a list that is folded if it is long."""
    texts = grouped(notes)
    return folded(plural(len(texts), "note"), items(texts), is_open=len(texts) <= 3)


def plural(count: int, noun: str) -> str:
    """Return a number with its noun, `2 notes`."""
    return f"{count} {noun}{'s' * (count != 1)}"
