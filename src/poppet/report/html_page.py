"""Frame of self-contained pages: style, sections, lists, figures.

A page loads no fonts, scripts or pictures. It is readable on paper and on narrow screens.
"""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.note_groups import grouped
from poppet.core.number_format import printable
from poppet.core.version import __version__
from poppet.report.plots import scripts
from poppet.report.plots.reading import plot_data
from poppet.report.tables import Table
from poppet.timeseries.plotting.figures import figure_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLE = """
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1f24; --soft: #57606a; --line: #d9dde3; --wash: #f6f7f9;
  --edge: #1b1f2440; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); overflow-wrap: break-word;
  font: 16px/1.55 "Source Sans 3", "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 66rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.25; margin: 0 0 .4rem; letter-spacing: -.01em; }
h1, h2, h3 { overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .8rem; padding-top: .8rem; border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.8rem 0 .2rem; }
p { margin: .6rem 0; max-width: 50rem; }
.lead { color: var(--soft); }
figure { margin: .8rem 0 1.6rem; }
figure svg { display: block; width: 100%; height: auto; }
figure.narrow svg, figure.narrow .live { max-width: 40rem; }
figcaption { color: var(--soft); font-size: .92rem; max-width: 50rem; margin-top: .4rem; }
/* A shadow at an edge marks hidden content. */
.scroll { overflow-x: auto; max-width: 100%; background-attachment: local, local, scroll, scroll; background-image:
  linear-gradient(to right, var(--paper) 1rem, transparent 2rem),
  linear-gradient(to left, var(--paper) 1rem, transparent 2rem),
  linear-gradient(to right, var(--edge), transparent .6rem), linear-gradient(to left, var(--edge), transparent .6rem); }
table { border-collapse: collapse; margin: 1rem 0; font-size: .95rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); font-size: .92rem; padding-bottom: .5rem; }
th, td { padding: .32rem 1.2rem .32rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--line); }
th { font-weight: 600; border-bottom: 2px solid var(--ink); vertical-align: bottom; }
th:last-child, td:last-child { padding-right: 0; }
.number { text-align: right; }
td.number, td code { white-space: nowrap; }
.verdict { display: inline-block; white-space: nowrap; border-radius: .3rem; padding: .05rem .5rem;
  font-size: .88rem; font-weight: 600; }
.findings { max-width: 50rem; padding-left: 1.3rem; } .findings li { margin: .4rem 0; }
@media (max-width: 40rem) {
  main { padding: 1.2rem .9rem 2.5rem; } h1 { font-size: 1.4rem; }
  figure svg { min-width: 36rem; } figure.narrow svg { min-width: 0; }
  figure .still { background: none; }
  figure:not(.narrow) .still { padding-right: 1.2rem; mask-image: linear-gradient(to left, transparent, #000 1.2rem); }
  th, td { padding-right: .8rem; }
  .stack { background: none; }
  .stack table, .stack tbody { display: block; } .stack thead { display: none; }
  .stack tr { display: flex; flex-wrap: wrap; gap: 0 .9rem; padding: .4rem 0; border-bottom: 1px solid var(--line); }
  .stack td { border: 0; padding: 0; text-align: left; white-space: normal; overflow-wrap: anywhere; max-width: 100%;
    width: auto !important; }
  .stack td code { white-space: normal; }
  .stack td:first-child { flex: 1 1 100%; font-weight: 600; } .stack td:empty { display: none; }
  .stack td[data-name]::before { content: attr(data-name) " "; color: var(--soft); font-size: .85em; }
}
/* Figures have a white background: invert their lightness and keep their hues. */
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #121212; --ink: #e8e8e8; --soft: #a2a9b2; --line: #3a3f46; --wash: #1d2024; --edge: #e8e8e840; }
  figure svg, figure canvas, .key i, .verdict, .tinted { filter: invert(.93) hue-rotate(180deg); }
}
@media print { main { padding: 0; } h2, h3 { break-after: avoid; } figure, tr { break-inside: avoid; }
  /* Paper does not scroll. */
  .scroll { overflow: visible; background: none; } .stack table { font-size: .72rem; }
  .stack th.number { overflow-wrap: anywhere; min-width: 2rem; } .stack th, .stack td { padding-right: .6rem; } }
"""

Content: TypeAlias = "str | Table | Iterable[str | Table] | None"
"""HTML, tables, or a sequence of both."""


class Section(NamedTuple):
    """Heading of a page with its content; a section without content is omitted."""

    title: str
    content: Content


def render(content: Content) -> str:
    """Return tables and HTML as one text."""
    if content is None or isinstance(content, str):
        return content or ""
    return content.html() if isinstance(content, Table) else "".join(map(render, content))


def write_page(path: str | Path, text: Callable[[], str]) -> Path:
    """Write a page; the file name is checked before `text` is called."""
    target = Path(path)
    if target.suffix.lower() not in (".html", ".htm"):
        raise InputError("page.suffix", path=str(target))
    content = printable(text()).encode("utf-8")
    return write_whole(target, lambda stream: stream.write(content))


def document(title: str, sections: Iterable[tuple[str, Content]], *, style: str = "", program: str = "") -> str:
    """Return a page of sections.

    `program` is a script that runs after all others and may use WebAssembly.

    Examples
    --------
    >>> page = document("a < b", [Section("", "<p>text</p>"), Section("Empty", "")]).splitlines()
    >>> page[6], page[-3][:11]
    ('<title>a &lt; b</title>', '<p>text</p>')
    """
    rendered = [(heading, render(content)) for heading, content in sections]
    body = "".join(f"<h2>{heading}</h2>\n{text}" if heading else text for heading, text in rendered if text)
    body += f'<p class="lead">Written by poppet {__version__}.</p>\n'
    has_plots = scripts.MARK in body
    code = tuple(filter(None, (scripts.script() if has_plots else "", program)))
    body = f"<main>\n{body}</main>" + "".join(f"\n<script>{text}</script>\n" for text in code)
    css = STYLE + (scripts.style() if has_plots else "") + style
    meta = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    meta += f"{scripts.policy(*code, computes=bool(program))}<title>{html.escape(title)}</title>\n<style>{css}</style>"
    return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{meta}\n</head>\n<body>{body}</body>\n</html>\n'


def head(title: str, lead: str) -> str:
    """Return the title and the first line of a page."""
    return f'<h1>{html.escape(title)}</h1>\n<p class="lead">{html.escape(lead)}</p>\n'


def paragraph(text: str, *, css_class: str = "", bold: bool = False) -> str:
    """Return a text as a paragraph, or nothing if it is empty."""
    content = f"<strong>{html.escape(text)}</strong>" if bold else html.escape(text)
    kind = f' class="{css_class}"' if css_class else ""
    return f"<p{kind}>{content}</p>\n" if text else ""


def folded(summary: str, content: Content, *, is_open: bool = False) -> str:
    """Return content that the reader can unfold, or nothing if it is empty."""
    body, state = render(content), " open" if is_open else ""
    return f"<details{state}><summary>{html.escape(summary)}</summary>\n{body}</details>\n" if body else ""


def items(texts: Iterable[object], tag: str = "ul", css_class: str = "") -> str:
    """Return a list of texts, or nothing if there are none."""
    rows = "".join(f"<li>{html.escape(str(text))}</li>\n" for text in texts)
    kind = f' class="{css_class}"' if css_class else ""
    return f"<{tag}{kind}>\n{rows}</{tag}>\n" if rows else ""


def findings(notes: Iterable[Note | str], tag: str = "ul") -> str:
    """Return a list of notes, or nothing if there are none."""
    return items(grouped(notes), tag, "findings")


def picture(
    figure: Figure | str, name: str, caption: str, *, label: str = "", kind: str = "", is_still: bool = False
) -> str:
    """Return a figure, or the text of its SVG file, with its caption.

    The first words of the caption are the text for screen readers. If the figure has curves, the page includes their
    values, and an interactive plot replaces the picture. Set `is_still` to keep the picture.
    """
    values = None
    if isinstance(figure, str):
        svg = figure
    else:
        svg = figure_bytes(figure, "svg", name).decode("utf-8")
        values = None if is_still else plot_data(figure)
    svg = inline_svg(svg, name, label or caption.partition(".")[0])
    css_class = f' class="{kind}"' if kind else ""
    element = scripts.data_element(values) if values else ""
    text = f"<figcaption>{html.escape(caption)}</figcaption>"
    return f'<figure{css_class}><div class="still scroll">{svg}</div>{element}{text}</figure>\n'


def inline_svg(svg: str, name: str, label: str) -> str:
    """Return an SVG file as an element of a page.

    Examples
    --------
    >>> inline_svg('<svg xmlns="a" width="9pt" height="9pt"><g id="b"/></svg>', "fit", "Fit")
    '<svg role="img" aria-label="Fit"><g id="fit-b"/></svg>'
    """
    element = svg[svg.index("<svg") :].rstrip()
    opening, rest = element.split(">", 1)
    # The width of the page sets the size. HTML needs no declarations of name spaces.
    opening = re.sub(r' (?:height|width|xmlns(?::\w+)?)="[^"]*"', "", opening)
    opening = opening.replace("<svg", f'<svg role="img" aria-label="{html.escape(label)}"', 1)
    rest = re.sub(r"<metadata>.*?</metadata>\s*", "", rest, flags=re.DOTALL).replace(" xlink:href=", " href=")
    # Identifiers are unique within one figure only.
    return f"{opening}>" + re.sub(r'( id="|"#|url\(#)', rf"\g<1>{name}-", rest)
