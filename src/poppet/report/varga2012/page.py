"""The report as one page that needs nothing else: no fonts, scripts or pictures from elsewhere."""

from __future__ import annotations

import html
import re
from collections.abc import Mapping, Sequence

from poppet.ground.version import __version__
from poppet.report.tables import Table
from poppet.report.varga2012.statements import Statement, Verdict

_CLASSES = {Verdict.HOLDS: "holds", Verdict.FAILS: "fails", Verdict.OPEN: "open"}
_PLURALS = {Verdict.HOLDS: "hold", Verdict.FAILS: "do not hold", Verdict.OPEN: "cannot be told"}

_STYLE = """
:root { color-scheme: light; --ink: #1b1f24; --soft: #57606a; --line: #d9dde3; --wash: #f6f7f9; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink);
  font: 16px/1.55 "Source Sans 3", "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 58rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.25; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.25rem; margin: 2.8rem 0 .8rem; padding-top: .8rem; border-top: 1px solid var(--line); }
p { margin: .6rem 0; max-width: 46rem; }
.lead { color: var(--soft); }
.tally { display: flex; gap: .6rem; flex-wrap: wrap; margin: 1.2rem 0; }
.tally span { border: 1px solid var(--line); border-radius: .4rem; padding: .35rem .8rem;
  background: var(--wash); }
figure { margin: 1.6rem 0; }
figure svg { display: block; width: 100%; height: auto; }
figure.narrow svg { max-width: 40rem; }
figcaption { color: var(--soft); font-size: .92rem; max-width: 46rem; margin-top: .4rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 1.2rem 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); font-size: .92rem; padding-bottom: .5rem; }
th, td { padding: .32rem 1.3rem .32rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--line); }
th { font-weight: 600; border-bottom: 2px solid var(--ink); }
th:last-child, td:last-child { padding-right: 0; }
th { vertical-align: bottom; }
.number { text-align: right; }
td.number, .plain td:first-child { white-space: nowrap; }
.plain th.number { max-width: 10rem; }
td.place { color: var(--soft); }
.statements { width: 100%; }
.statements td { font-size: .95rem; }
.statements td:nth-child(1) { width: 30%; }
.statements td:nth-child(2) { width: 15%; }
.verdict { display: inline-block; white-space: nowrap; border-radius: .3rem; padding: .05rem .5rem;
  font-size: .88rem; font-weight: 600; }
.holds { background: #e3f3e8; color: #14532d; }
.fails { background: #fbe6e1; color: #8a2411; }
.open { background: #eceef1; color: #3f4852; }
@media print { main { padding: 0; } h2 { break-after: avoid; } figure, tr { break-inside: avoid; } }
"""

_TITLE = "Mathematical model of pneumatic proportional valve, recomputed"
_SOURCE = (
    "Z. Varga, P. Keski-Honkola: Mathematical model of pneumatic proportional valve. Journal of applied "
    "science in the thermodynamics and fluid mechanics, vol. 1, no. 1/2012, ISSN 1802-9388."
)
_CHOICES = (
    "All numbers on this page were simulated when it was written. Printed in the paper, and used as "
    "printed: the polynomials of Table 1, eqs (1) to (8), the volume of 0.2 m³. Not printed, and assumed: "
    "supply 7 bar absolute and 20 °C, a tank that starts at 1 bar and 20 °C, every mechanical number, the "
    "exhaust. Pressures are absolute unless marked g. Air is an ideal gas, R = 287.05 J/(kg K), isentropic "
    "exponent 1.4."
)

CAPTIONS: dict[str, str] = {
    "fig3": (
        "Figure 3, on the axes of the paper. Line: polynomial of Table 1, exactly as printed; circles: its "
        "values in the table of strokes. The printed polynomial does not close; the dotted variant does, "
        "over the first 0.02 mm, and a valve on its seat uses it. Faint: the same polynomial with one digit "
        "of k5 changed, a hypothesis that the height of the paper's axis suggests and nothing else uses. "
        "The measured points are not in the text."
    ),
    "fig4": "Figure 4, on the axes of the paper. Polynomial of Table 1 as printed; circles: as in the table.",
    "fig6": (
        "Figure 6, on the axes of the paper (1 to 5.5 bar, 0 to 120 s), with the gas temperature below. The "
        "points of the paper's figure are not in its text, so only axes and statements can be compared. Its "
        "staircase is not printed either: four steps of 30 s are chosen here. The main stage as printed, "
        "eqs (5) to (8), has no feedback of the outlet pressure and would fill to the supply pressure "
        "whatever is required; the regulator mode is used instead, its pilot pressure set so that it closes "
        "at the required value. Its mechanical numbers are assumed."
    ),
    "circuit": "The circuit behind figure 6, in place of the block diagram of figure 5.",
}


def page(pictures: Mapping[str, str], tables: Mapping[str, Table], found: Sequence[Statement]) -> str:
    """The whole report."""
    parts = [
        f"<h1>{_TITLE}</h1>\n<p class='lead'>{html.escape(_SOURCE)}</p>\n<p>{_CHOICES}</p>\n",
        _tally(found),
        "<h2>Statements of the paper</h2>\n" + _statements(found),
        "<h2>Flow characteristic</h2>\n",
        *(_figure(name, pictures[name], "narrow") for name in ("fig3", "fig4")),
        _scrolled(tables["strokes"]),
        "<h2>Tank laws</h2>\n",
        "<p>The tank of the paper follows the isentrope of a closed gas. Charging does not: the same "
        "circuit, with nothing changed but the thermal law of the tank, gives the following.</p>\n",
        _scrolled(tables["tank_laws"]),
        _scrolled(tables["wall_conductances"]),
        "<h2>Following a required value</h2>\n",
        *(_figure(name, pictures[name], "") for name in ("fig6", "circuit")),
        f"<p class='lead'>Written by poppet {__version__}.</p>\n",
    ]
    head = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    head += f"<title>{_TITLE}</title>\n<style>{_STYLE}</style>"
    body = f"<body><main>\n{''.join(parts)}</main></body>"
    return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{head}\n</head>\n{body}\n</html>\n'


def _tally(found: Sequence[Statement]) -> str:
    counts = {verdict: sum(one.verdict is verdict for one in found) for verdict in Verdict}
    words = "".join(f"<span><b>{counts[verdict]}</b> {text}</span>" for verdict, text in _PLURALS.items())
    return f"<p class='tally'><span><b>{len(found)}</b> statements</span>{words}</p>\n"


def _statements(found: Sequence[Statement]) -> str:
    rows = "".join(
        f"<tr><td>{html.escape(one.text)}</td><td class='place'>{html.escape(one.place)}</td>"
        f"<td>{html.escape(one.finding)}</td>"
        f"<td><span class='verdict {_CLASSES[one.verdict]}'>{one.verdict.value}</span></td></tr>\n"
        for one in found
    )
    head = "".join(f'<th scope="col">{word}</th>' for word in ("The paper says", "Where", "What we find", "Verdict"))
    return (
        f"<div class='scroll'><table class='statements'><thead><tr>{head}</tr></thead>"
        f"<tbody>\n{rows}</tbody></table></div>\n"
    )


def _scrolled(table: Table) -> str:
    return f"<div class='scroll plain'>{table.html()}</div>\n"


def _figure(name: str, svg: str, kind: str) -> str:
    caption = html.escape(CAPTIONS[name])
    return f"<figure class='{kind}'>{_inline(svg, name)}<figcaption>{caption}</figcaption></figure>\n"


def _inline(svg: str, name: str) -> str:
    """An SVG file as an element: no prologue, no fixed size, and marks of its own on the page."""
    element = svg[svg.index("<svg") :]
    element = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", element, count=1)
    element = re.sub(r'(<svg[^>]*?) width="[^"]*"', r'\1 role="img"', element, count=1)
    element = re.sub(r"<metadata>.*?</metadata>", "", element, flags=re.DOTALL)
    return re.sub(r'( id="|"#|url\(#)', rf"\g<1>{name}-", element)
