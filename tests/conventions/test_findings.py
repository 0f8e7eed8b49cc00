"""Every finding of an identification says on which numbers it rests."""

from __future__ import annotations

from poppet.core.message_format import every_code, facts_of, template
from poppet.identify.claims import RESTS_ON

ROOMS = ("finding", "flow", "characteristic", "friction")


def test_every_finding_of_an_identification_says_on_what_it_rests() -> None:
    """A new one joins the table in `identify/claims.py`, most often as one of samples."""
    findings = {c for c in every_code() if c.partition(".")[0] in ROOMS and isinstance(template(c), str)}
    assert findings == RESTS_ON.keys()
    for code, basis in RESTS_ON.items():
        assert not basis.otherwise or (not RESTS_ON[basis.otherwise].facts), code
        # What is said instead has words for the same facts.
        assert not basis.otherwise or facts_of(basis.otherwise) <= facts_of(code) | {
            *basis.facts,
            "value",
            "low",
            "high",
        }
