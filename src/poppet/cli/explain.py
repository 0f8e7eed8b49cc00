"""`poppet explain`: what a code means, and what to do."""

from __future__ import annotations

import argparse

from poppet.cli.parser import Option

EXAMPLES = ("poppet explain fields.out_of_range", "poppet explain finding.capped run.stalled", "poppet explain wiring")
OPTIONS = (Option("[CODE] ...", "codes, or what they begin with; lists those that there are; all when left out"),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.core.errors import InputError, NameSuggestion
    from poppet.core.message_format import every_code, plain

    known = every_code()
    rooms = sorted({code.partition(".")[0] for code in known})
    codes = options.codes or rooms
    told = []
    for code in codes:
        if code in known:
            words = known[code]
            parts = {"": words} if isinstance(words, str) else words
            lines = [f"  {name + ':':<8}{plain(text)}" if name else f"  {plain(text)}" for name, text in parts.items()]
            told.append("\n".join([code, *lines]))
            continue
        within = [each for each in known if each.startswith(f"{code}.")]
        if not within:
            raise InputError("cli.code", code=code, near=NameSuggestion(code, known if "." in code else rooms))
        told.append("\n".join([f"{code}: {len(within)} codes", *(f"  {each}" for each in within)]))
    print("\n\n".join(told))
    return 0
