"""Validation page: each claim with independent measurements or calculations."""

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
        "Recordings and maps of other groups. They are not part of the repository.",
    ),
    "codes": ("Independent codes", "Programs that share no code with poppet, unless the claim states otherwise."),
    "known": ("Closed forms, tables, known truth", "Formulas, printed values, and recordings with known parameters."),
}


def pages() -> dict[str, str]:
    """Return the page by its path."""
    return {"validation.md": page(kept())}


def page(results: Results) -> str:
    """Return the page of given results."""
    measured = [claim for claim in CLAIMS.values() if claim.name in results]
    failed = [claim for claim in measured if not holds(claim, results)]
    lines = [
        "# Validation",
        "",
        "This page compares each claim with an independent measurement, an independent code or a closed form. It lists",
        "our result, the published or baseline result, the data that no fit has used, and the date of the run.",
        f"**Of {len(measured)} claims, {len(measured) - len(failed)} hold and {len(failed)} do not hold.**",
        "[Accuracy](docs/accuracy.md) explains the consequences.",
        "",
        "Each result has its date and version. A claim whose external files are not available keeps its last result.",
        "You can repeat a measurement in a checkout with the extra `dev` and the external files in `../shared/data`:",
        "",
        "```console",
        "$ python website/validate.py NAME",
        "```",
        "",
        "## Claims that do not hold",
        "",
        *_overview(failed, results),
    ]
    for kind, (title, intro) in KINDS.items():
        claims = [claim for claim in CLAIMS.values() if kind_of(claim) == kind]
        lines += [f"## {title}", "", intro, "", *_overview([c for c in claims if c.name in results], results)]
        for claim in claims:
            lines += _details(claim, results.get(claim.name))
    return "\n".join(lines)


def kind_of(claim: Claim) -> str:
    """Return the section of a claim."""
    source = SOURCES[claim.source]
    return "measured" if source.files else "codes" if source.package else "known"


def holds(claim: Claim, results: Results) -> bool:
    """Return True if the stored results meet the criterion."""
    return bool(claim.holds(dict(results[claim.name]["figures"])))


def _verdict(claim: Claim, figures: Mapping[str, Any]) -> str:
    return "holds" if claim.holds(dict(figures)) else "**does not hold**"


def _overview(claims: Iterable[Claim], results: Results) -> list[str]:
    """Return a table of claims with verdicts and both values."""
    rows = []
    for claim in claims:
        figures = results[claim.name]["figures"]
        texts = (prose(text.format(**figures)) for text in (claim.ours, claim.theirs))
        rows.append((f"[{prose(claim.title)}](#{anchor(claim)})", "yes" if holds(claim, results) else "**no**", *texts))
    return [table(("claim", "holds", "poppet", "published or baseline"), rows)]


def anchor(claim: Claim) -> str:
    """Return the anchor of a claim on the page."""
    return f"validation-{claim.name.replace('_', '-')}"


def _details(claim: Claim, result: Mapping[str, Any] | None) -> list[str]:
    source = SOURCES[claim.source]
    origin = f"[{prose(source.name)}]({source.link})" if source.link else prose(source.name)
    lines = [f"({anchor(claim)})=", f"### {prose(claim.title)}", ""]
    if result is None:
        lines += ["- Not yet measured."]
    else:
        figures = result["figures"]
        ours, theirs, unseen = (prose(text.format(**figures)) for text in (claim.ours, claim.theirs, claim.unseen))
        package = f", {source.package} {result['package']}" if "package" in result else ""
        run = f"{result['date']}, poppet {result['version']} ({result['commit']}){package}"
        lines += [
            f"- **poppet:** {ours}",
            f"- **Published or baseline:** {theirs}",
            f"- **Criterion:** {prose(claim.when)}. The claim {_verdict(claim, figures)}.",
            f"- **Data without influence on the fit:** {unseen}",
            f"- **Source:** {origin}; licence: {source.licence}",
            f"- **Run:** {run}",
        ]
    return [*lines, f"- **Repeat:** `python website/validate.py {claim.name}`", ""]
