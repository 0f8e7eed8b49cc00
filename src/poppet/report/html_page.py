"""Frame of self-contained HTML pages: style, sections, lists and figures.

A page loads no fonts, scripts or pictures. It is readable on paper and on narrow screens.
"""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from poppet.core.codes import Note
from poppet.core.files import by_suffix, write_whole
from poppet.core.note_groups import grouped
from poppet.core.number_format import printable
from poppet.core.version import __version__
from poppet.report.plots import interactive
from poppet.report.styles import stylesheet
from poppet.report.tables import ReportTable
from poppet.timeseries.plotting.figures import figure_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Content: TypeAlias = "str | ReportTable | Iterable[str | ReportTable] | None"
"""Content of a section: HTML text, a table, or a sequence of both."""


class Section(NamedTuple):
    """Section of a page, with heading and content.

    A section without content is omitted from the page.
    """

    title: str
    content: Content


def render(content: Content) -> str:
    """Return content as HTML text.

    The content can be HTML, a table, or a sequence of both.
    """
    if content is None or isinstance(content, str):
        return content or ""
    return content.html() if isinstance(content, ReportTable) else "".join(map(render, content))


def write_page(path: str | Path, text: Callable[[], str]) -> Path:
    """Write an HTML page to a file.

    `text` is a function that returns the page. It may take long, so the file name is checked before it is called.
    """
    target = Path(path)
    by_suffix(target, dict.fromkeys((".html", ".htm"), ""))
    content = printable(text()).encode("utf-8")
    return write_whole(target, lambda stream: stream.write(content))


def document(
    title: str, sections: Iterable[tuple[str, Content]], *, style: str = "", program: str = "", connects: str = ""
) -> str:
    """Return a complete HTML page with the given sections.

    The keyword `style` contains further style sheets. The keyword `program` is a script that runs after all others and
    may use WebAssembly. The keyword `connects` contains the sources to which scripts can connect, as in a content
    security policy.

    Examples
    --------
    >>> page = document("a < b", [Section("", "<p>text</p>"), Section("Empty", "")]).splitlines()
    >>> page[6], page[-3][:11]
    ('<title>a &lt; b</title>', '<p>text</p>')
    """
    rendered = [(heading, render(content)) for heading, content in sections]
    body = "".join(f"<h2>{heading}</h2>\n{text}" if heading else text for heading, text in rendered if text)
    body += f'<p class="lead">Written by poppet {__version__}.</p>\n'
    has_plots = interactive.MARK in body
    code = tuple(filter(None, (interactive.script() if has_plots else "", program)))
    body = f"<main>\n{body}</main>" + "".join(f"\n<script>{text}</script>\n" for text in code)
    css = stylesheet("page") + (interactive.style() if has_plots else "") + style
    meta = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    meta += interactive.policy(*code, computes=bool(program), connects=connects)
    meta += f"<title>{html.escape(title)}</title>\n<style>{css}</style>"
    return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{meta}\n</head>\n<body>{body}</body>\n</html>\n'


def head(title: str, lead: str) -> str:
    """Return the title and the first paragraph of a page as HTML."""
    return f'<h1>{html.escape(title)}</h1>\n<p class="lead">{html.escape(lead)}</p>\n'


def paragraph(text: str, *, css_class: str = "", bold: bool = False) -> str:
    """Return a text as an HTML paragraph.

    The result is empty if the text is empty.
    """
    content = f"<strong>{html.escape(text)}</strong>" if bold else html.escape(text)
    kind = f' class="{css_class}"' if css_class else ""
    return f"<p{kind}>{content}</p>\n" if text else ""


def folded(summary: str, content: Content, *, is_open: bool = False) -> str:
    """Return content as an HTML block that the reader can unfold.

    `summary` is the line that is always visible. Without content, the result is empty.
    """
    body, state = render(content), " open" if is_open else ""
    return f"<details{state}><summary>{html.escape(summary)}</summary>\n{body}</details>\n" if body else ""


def items(texts: Iterable[object], tag: str = "ul", css_class: str = "") -> str:
    """Return texts as an HTML list.

    `tag` is the HTML element of the list, `ul` or `ol`. Without texts, the result is empty.
    """
    rows = "".join(f"<li>{html.escape(str(text))}</li>\n" for text in texts)
    kind = f' class="{css_class}"' if css_class else ""
    return f"<{tag}{kind}>\n{rows}</{tag}>\n" if rows else ""


def findings(notes: Iterable[Note | str], tag: str = "ul") -> str:
    """Return notes as an HTML list.

    `tag` is the HTML element of the list, `ul` or `ol`. Without notes, the result is empty.
    """
    return items(grouped(notes), tag, "findings")


def picture(
    figure: Figure | str, name: str, caption: str, *, label: str = "", kind: str = "", is_still: bool = False
) -> str:
    """Return a figure with its caption as HTML.

    `figure` is a Matplotlib figure or the text of an SVG file.

    The first words of the caption are the text for screen readers. If the figure has curves, the page includes their
    values, and an interactive plot replaces the picture. If the keyword `is_still` is True, the picture is kept.
    """
    values = None
    if isinstance(figure, str):
        svg = figure
    else:
        svg = figure_bytes(figure, "svg", name).decode("utf-8")
        values = None if is_still else interactive.plot_data(figure)
    svg = inline_svg(svg, name, label or caption.partition(".")[0])
    css_class = f' class="{kind}"' if kind else ""
    element = interactive.data_element(values) if values else ""
    text = f"<figcaption>{html.escape(caption)}</figcaption>"
    return f'<figure{css_class}><div class="still scroll">{svg}</div>{element}{text}</figure>\n'


def inline_svg(svg: str, name: str, label: str) -> str:
    """Return the text of an SVG file as an HTML element.

    Identifiers in it get the prefix `name`. `label` is the text for screen readers.

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
