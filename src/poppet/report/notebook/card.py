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
from poppet.report.styles import stylesheet

STYLE = stylesheet("notebook")
MAX_ROWS = 12
"""Maximum number of rows of an unfolded table."""


def card(title: str, lead: str, *blocks: Content) -> str:
    """Return the HTML output of one object in a notebook.

    `title` and `lead` are text; `blocks` are HTML or tables.

    Examples
    --------
    >>> card("a < b", "Recording").partition("</style>")[2]
    '<p><span class="poppet-head">a &lt; b</span> <span class="lead">Recording</span></p></div>'
    """
    name = f'<span class="poppet-head">{html.escape(title)}</span> ' if title else ""
    head = f'<p>{name}<span class="lead">{html.escape(lead)}</span></p>'
    return f'<div class="poppet-card"><style>{STYLE}</style>{head}{"".join(map(render, blocks))}</div>'


def note_list(notes: Iterable[Note]) -> str:
    """Return notes as an HTML list.

    A long list is folded: the reader can unfold it.
    """
    texts = grouped(notes)
    return folded(plural(len(texts), "note"), items(texts), is_open=len(texts) <= 3)


def plural(count: int, noun: str) -> str:
    """Return a count with its noun in singular or plural, such as `2 notes`."""
    return f"{count} {noun}{'s' * (count != 1)}"
