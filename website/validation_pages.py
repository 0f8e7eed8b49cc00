"""The validation page: every claim beside what others measured or calculated, from the figures that were kept."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from claims import CLAIMS, SOURCES, Claim
from reference_pages import prose, table
from validate import kept

Results = Mapping[str, Mapping[str, Any]]
KINDS = {
    "measured": (
        "Measured by others",
        "Recordings and maps that nobody here made. They are not part of the repository.",
    ),
    "codes": ("Independent codes", "Programs that share no line with this one, unless a line says so."),
    "known": ("Closed forms, tables, known truth", "Formulas, printed values, and recordings whose truth is known."),
}


def pages() -> dict[str, str]:
    """The page by its place."""
    return {"validation.md": page(kept())}


def page(results: Results) -> str:
    """The page of some results."""
    found = [claim for claim in CLAIMS.values() if claim.name in results]
    failed = [claim for claim in found if not holds(claim, results)]
    lines = [
        "# Validation",
        "",
        "Every claim beside a measurement that nobody here made, an independent code or a closed form: what we get,",
        "what is published or what a simpler model gets, what no fit had seen, and when it was run.",
        f"**Of {len(found)} lines {len(found) - len(failed)} hold and {len(failed)} do not.**",
        "[How far to trust a result](docs/accuracy.md) says what follows from this.",
        "",
        "Every figure is of the run whose date and version stand with it; where the files of others are not at hand,",
        "a line keeps its last one. Run any of them again, in a checkout with the extra `dev` and the files of others",
        "in `../shared/data`:",
        "",
        "```console",
        "$ python website/validate.py NAME",
        "```",
        "",
        "## What does not hold",
        "",
        *_overview(failed, results),
    ]
    for kind, (title, intro) in KINDS.items():
        chosen = [claim for claim in CLAIMS.values() if kind_of(claim) == kind]
        lines += [f"## {title}", "", intro, "", *_overview([c for c in chosen if c.name in results], results)]
        for claim in chosen:
            lines += _details(claim, results.get(claim.name))
    return "\n".join(lines)


def kind_of(claim: Claim) -> str:
    """Under which heading it stands."""
    source = SOURCES[claim.source]
    return "measured" if source.files else "codes" if source.package else "known"


def holds(claim: Claim, results: Results) -> bool:
    """Whether the kept figures keep what is claimed."""
    return bool(claim.holds(dict(results[claim.name]["figures"])))


def _verdict(claim: Claim, figures: Mapping[str, Any]) -> str:
    return "holds" if claim.holds(dict(figures)) else "**does not hold**"


def _overview(claims: Iterable[Claim], results: Results) -> list[str]:
    """A table of claims, whether they hold, and both figures."""
    rows = []
    for claim in claims:
        figures = results[claim.name]["figures"]
        said = (prose(text.format(**figures)) for text in (claim.ours, claim.theirs))
        rows.append((f"[{prose(claim.title)}](#{anchor(claim)})", "yes" if holds(claim, results) else "**no**", *said))
    return [table(("claim", "holds", "ours", "published or baseline"), rows)]


def anchor(claim: Claim) -> str:
    """Its place on the page."""
    return f"validation-{claim.name.replace('_', '-')}"


def _details(claim: Claim, result: Mapping[str, Any] | None) -> list[str]:
    source = SOURCES[claim.source]
    told = f"[{prose(source.name)}]({source.link})" if source.link else prose(source.name)
    lines = [f"({anchor(claim)})=", f"### {prose(claim.title)}", ""]
    if result is None:
        lines += ["- Not measured yet."]
    else:
        figures = result["figures"]
        ours, theirs, unseen = (prose(text.format(**figures)) for text in (claim.ours, claim.theirs, claim.unseen))
        other = f", {source.package} {result['package']}" if "package" in result else ""
        run = f"{result['date']}, poppet {result['version']} ({result['commit']}){other}"
        lines += [
            f"- **Ours:** {ours}",
            f"- **Published or baseline:** {theirs}",
            f"- **Holds when:** {prose(claim.when)}. It {_verdict(claim, figures)}.",
            f"- **Held out:** {unseen}",
            f"- **Source:** {told}; licence: {source.licence}",
            f"- **Run:** {run}",
        ]
    return [*lines, f"- **Again:** `python website/validate.py {claim.name}`", ""]
