"""`poppet library`, `explain` and `paper`: published data, codes, and the published figures."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from poppet.core.errors import InputError, NameSuggestion


def show_library(options: argparse.Namespace) -> None:
    """List the sets, characteristics and gases of the library, or describe one."""
    from poppet import library

    if options.name is not None:
        print(library.describe(options.name))
        return
    groups = {
        "sets": library.sets(),
        "characteristics": library.characteristics(),
        "gases": library.gas_names(),
    }
    for heading, names in groups.items():
        print(f"{heading + ':':<17}{', '.join(names)}")


def explain_codes(options: argparse.Namespace) -> None:
    """Print the message template of codes, or list the codes with a common first part."""
    from poppet.core.message_format import every_code, plain

    templates = every_code()
    first_parts = sorted({code.partition(".")[0] for code in templates})
    explanations = []
    for code in options.codes or first_parts:
        if code in templates:
            template = templates[code]
            parts = {"": template} if isinstance(template, str) else template
            lines = [f"  {name + ':':<8}{plain(text)}" if name else f"  {plain(text)}" for name, text in parts.items()]
            explanations.append("\n".join([code, *lines]))
            continue
        members = [member for member in templates if member.startswith(f"{code}.")]
        if not members:
            raise InputError(
                "cli.code", code=code, near=NameSuggestion(code, templates if "." in code else first_parts)
            )
        explanations.append("\n".join([f"{code}: {len(members)} codes", *(f"  {member}" for member in members)]))
    print("\n\n".join(explanations))


def reproduce_paper(options: argparse.Namespace) -> None:
    """Reproduce the figures and statements of Varga & Keski-Honkola 2012."""
    folder = Path(options.output)
    if folder.exists() and not folder.is_dir():
        raise InputError("paper.folder_is_file", path=str(folder))
    from poppet.report.varga2012.paper import write_paper

    print(write_paper(folder, lambda step: None if options.quiet else print(step, file=sys.stderr)).table())
