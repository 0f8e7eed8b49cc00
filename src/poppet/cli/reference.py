"""Commands `poppet library`, `explain` and `paper`.

They show published data, explain message codes, and reproduce published figures.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from poppet.core.errors import InputError, NameSuggestion


def show_library(options: argparse.Namespace) -> None:
    """Run the command `library`: list the contents of the parameter library, or print entries."""
    from poppet import library

    if options.components is not None or options.find is not None:
        _list_components(options)
        return
    if options.name is not None:
        print(_entry(options.name))
        return
    groups = {"sets": library.sets(), "characteristics": library.characteristics(), "gases": library.gas_names()}
    for heading, names in groups.items():
        print(f"{heading + ':':<17}{', '.join(names)}")
    print(f"{'components:':<17}poppet library --components")


def _entry(name: str) -> str:
    """Return the text of a set, a characteristic, a gas or a component."""
    from poppet import library
    from poppet.library.components import component_names, find_variants

    others = (*library.sets(), *library.characteristics(), *library.gas_names())
    key = name.casefold()
    # The manufacturer before the catalogue number is easily forgotten.
    is_component = " " in name.strip() or (
        not NameSuggestion(name, others).names and any(key in full_name.casefold() for full_name in component_names())
    )
    if name in others or not is_component:
        return library.describe(name)
    from poppet.report.component_passport import passports

    return passports(find_variants(name))


def _list_components(options: argparse.Namespace) -> None:
    """Print components of the library or of a file: all, one by its name, or those that fulfil conditions."""
    from poppet.library.components import components, find_variants
    from poppet.parts.component_file import read_components
    from poppet.parts.component_search import search
    from poppet.report.component_passport import component_list, passports

    selected = read_components(options.components) if options.components else components()
    if options.find is not None:
        selected = tuple(search(options.find, selected))
    if options.name is not None:
        print(passports(find_variants(options.name, selected)))
    else:
        print(component_list(selected) if selected else "No component fulfils all conditions.")


def explain_codes(options: argparse.Namespace) -> None:
    """Run the command `explain`: print cause, example and remedy of the messages with given codes.

    For the first part of a code, all codes that begin with it are listed. Without codes, all first parts are listed.
    """
    from poppet.core.explanations import example_texts, renamed_codes, stored_examples
    from poppet.core.message_format import every_code, plain, template, topics

    codes, titles = every_code(), topics()
    blocks = []
    for name in options.codes:
        new = renamed_codes().get(name, name)
        members = [code for code in codes if code.startswith(f"{name}.")]
        if new in codes:
            text, example = template(new), stored_examples().get(new)
            # The text of a note already contains its remedy.
            parts = {"": text} if isinstance(text, str) else text
            lines = [f"{name} is now {new}."] if new != name else []
            cause = " ".join(plain(part) for key, part in parts.items() if key != "hint")
            lines += [new, f"  cause:    {cause}"]
            if example is not None and "{" in "".join(parts.values()):
                lines.append(f"  example:  {' '.join(example_texts(new, example).values())}")
            if "hint" in parts:
                remedy = plain(parts["hint"]).replace("<suggestion>", "Use one of the suggested names.")
                lines.append(f"  remedy:   {remedy}")
            blocks.append("\n".join(lines))
        elif members:
            title = f": {titles[name]}" if name in titles else ""
            blocks.append("\n".join([f"{name}{title}, {len(members)} codes", *(f"  {code}" for code in members)]))
        else:
            raise InputError("cli.code", code=name, suggestion=NameSuggestion(name, codes if "." in name else titles))
    if not options.codes:
        width = max(map(len, titles))
        blocks = ["\n".join(f"{topic:<{width}}  {title}" for topic, title in titles.items())]
    print("\n\n".join(blocks))


def reproduce_paper(options: argparse.Namespace) -> None:
    """Run the command `paper`: reproduce the figures and statements of Varga & Keski-Honkola 2012."""
    folder = Path(options.output)
    if folder.exists() and not folder.is_dir():
        raise InputError("paper.folder_is_file", path=str(folder))
    from poppet.report.varga2012.paper import write_paper

    print(write_paper(folder, lambda step: None if options.quiet else print(step, file=sys.stderr)).table())
