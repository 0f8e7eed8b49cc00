"""The frame of a page that needs nothing else: no fonts, scripts or pictures from elsewhere."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence

STYLE = """
:root { color-scheme: light; --ink: #1b1f24; --soft: #57606a; --line: #d9dde3; --wash: #f6f7f9; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink);
  font: 16px/1.55 "Source Sans 3", "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 66rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.25; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .8rem; padding-top: .8rem; border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.8rem 0 .2rem; }
p { margin: .6rem 0; max-width: 50rem; }
.lead { color: var(--soft); }
figure { margin: .8rem 0 1.6rem; }
figure svg { display: block; width: 100%; height: auto; }
figure.narrow svg { max-width: 40rem; }
figcaption { color: var(--soft); font-size: .92rem; max-width: 50rem; margin-top: .4rem; }
.scroll { overflow-x: auto; }
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
@media print { main { padding: 0; } h2, h3 { break-after: avoid; } figure, tr { break-inside: avoid; } }
"""


def document(title: str, body: str, *, style: str = "") -> str:
    """A whole page.

    Examples
    --------
    >>> document("a < b", "<p>text</p>").splitlines()[5]
    '<title>a &lt; b</title>'
    """
    head = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    head += f"<title>{html.escape(title)}</title>\n<style>{STYLE}{style}</style>"
    return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{head}\n</head>\n<body><main>\n{body}</main></body>\n</html>\n'


def inline_svg(svg: str, name: str, label: str) -> str:
    """An SVG file as an element of a page.

    Examples
    --------
    >>> inline_svg('<svg xmlns="a" width="9pt" height="9pt"><g id="b"/></svg>', "fit", "Fit")
    '<svg role="img" aria-label="Fit"><g id="fit-b"/></svg>'
    """
    element = svg[svg.index("<svg") :].rstrip()
    opening, rest = element.split(">", 1)
    opening = re.sub(r' (?:height|xmlns(?::\w+)?)="[^"]*"', "", opening)
    opening = re.sub(r' width="[^"]*"', "", opening)
    opening = opening.replace("<svg", f'<svg role="img" aria-label="{html.escape(label)}"', 1)
    rest = re.sub(r"<metadata>.*?</metadata>\s*", "", rest, flags=re.DOTALL).replace(" xlink:href=", " href=")
    return f"{opening}>" + re.sub(r'( id="|"#|url\(#)', rf"\g<1>{name}-", rest)


def table(headings: Sequence[str], rows: Sequence[Sequence[str]], *, numbers: Sequence[int] = ()) -> str:
    """A table that scrolls on narrow screens."""
    marks = [' class="number"' if k in numbers else "" for k in range(len(rows[0]) if rows else len(headings))]
    head = "".join(f'<th scope="col"{m}>{html.escape(text)}</th>' for m, text in zip(marks, headings, strict=False))
    head = f"<thead><tr>{head}</tr></thead>\n" if head else ""
    body = "".join(
        "<tr>" + "".join(f"<td{m}>{cell}</td>" for m, cell in zip(marks, row, strict=True)) + "</tr>\n" for row in rows
    )
    return f'<div class="scroll"><table>{head}<tbody>\n{body}</tbody></table></div>\n'
