"""Command `poppet explain`: cause, example and remedy of a message code."""

from __future__ import annotations

import argparse

from poppet.cli.parser import Option

EXAMPLES = ("poppet explain fields.out_of_range", "poppet explain finding.capped run.stalled", "poppet explain wiring")
OPTIONS = (Option("[CODE] ...", "codes or their first parts; if omitted, lists all first parts"),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.core.errors import InputError, NameSuggestion
    from poppet.core.message_format import every_code, renamed_codes, topics

    codes, titles = every_code(), topics()
    blocks = []
    for name in options.codes:
        new = renamed_codes().get(name, name)
        members = [code for code in codes if code.startswith(f"{name}.")]
        if new in codes:
            blocks.append((f"{name} is now {new}.\n" if new != name else "") + _explanation(new))
        elif members:
            title = f": {titles[name]}" if name in titles else ""
            blocks.append("\n".join([f"{name}{title}, {len(members)} codes", *(f"  {code}" for code in members)]))
        else:
            raise InputError("cli.code", code=name, near=NameSuggestion(name, codes if "." in name else titles))
    if not options.codes:
        width = max(map(len, titles))
        blocks = ["\n".join(f"{topic:<{width}}  {title}" for topic, title in titles.items())]
    print("\n\n".join(blocks))
    return 0


def _explanation(code: str) -> str:
    """Return cause, example and remedy of a code; the text of a note contains its remedy."""
    from poppet.core.message_format import example_texts, plain, stored_examples, template

    text, example = template(code), stored_examples().get(code)
    parts = {"": text} if isinstance(text, str) else text
    lines = [f"  cause:    {' '.join(plain(part) for name, part in parts.items() if name != 'hint')}"]
    if example is not None and "{" in "".join(parts.values()):
        texts = example_texts(code, example)
        lines.append(f"  example:  {' '.join(texts.values())}")
    if "hint" in parts:
        lines.append(f"  remedy:   {plain(parts['hint']).replace('<near>', 'Use one of the suggested names.')}")
    return "\n".join([code, *lines])
