"""Commands `poppet library`, `explain` and `paper`.

They show published data, explain message codes, and reproduce published figures.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import textwrap
from pathlib import Path

from poppet.core.errors import InputError, NameSuggestion

MAX_WIDTH = 100
"""Largest width of explanations on a terminal, in characters."""


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
    from poppet.core.explanations import renamed_codes, verdict_explanations
    from poppet.core.message_format import every_code, topics

    codes, titles = every_code(), topics()
    blocks = []
    for name in options.codes:
        new = renamed_codes().get(name, name)
        members = [code for code in codes if code.startswith(f"{name}.")]
        if new in codes or new in verdict_explanations():
            blocks.append("\n".join([f"{name} is now {new}."] * (new != name) + [new, *_explanation_lines(new)]))
        elif members:
            title = f": {titles[name]}" if name in titles else ""
            blocks.append("\n".join([f"{name}{title}, {len(members)} codes", *(f"  {code}" for code in members)]))
        else:
            raise InputError(
                "cli.code",
                code=name,
                suggestion=NameSuggestion(name, codes if "." in name else [*titles, *verdict_explanations()]),
            )
    if not options.codes:
        width = max(map(len, titles))
        blocks = ["\n".join(f"{topic:<{width}}  {title}" for topic, title in titles.items())]
    print("\n\n".join(blocks))


def _explanation_lines(code: str) -> list[str]:
    """Return the lines of an explanation, wrapped to the width of a terminal."""
    from poppet.core.explanations import explanation

    # A pipe gets one line for each text, so that a search finds whole sentences.
    width = min(shutil.get_terminal_size().columns, MAX_WIDTH) if sys.stdout.isatty() else sys.maxsize
    lines = []
    for title, text in explanation(code).items():
        lines += textwrap.wrap(text, width, initial_indent=f"  {f'{title}:':<9} ", subsequent_indent=" " * 12)
    return lines


def reproduce_paper(options: argparse.Namespace) -> None:
    """Run the command `paper`: reproduce the figures and statements of Varga & Keski-Honkola 2012.

    The option `--circuits` writes the circuits of the figures instead.
    """
    if options.circuits is not None:
        from poppet.report.varga2012.paper_circuits import write_circuits

        paths = write_circuits(Path(options.circuits), is_forced=options.force)
        print("\n".join(f"{path}: written." for path in paths))
        leak = '--parameter "leak.sonic_conductance=0..1 dm^3/(s bar)"'
        print(f"Run one: poppet simulate {paths[-1]} --plot figure6.png --select tank.pressure")
        print(f"Page with sliders: poppet live {paths[-1]} -o figure6.html --parameter tank.volume {leak}")
        return
    folder = Path(options.output)
    if folder.exists() and not folder.is_dir():
        raise InputError("paper.folder_is_file", path=str(folder))
    from poppet.report.varga2012.paper import write_paper

    print(write_paper(folder, lambda step: None if options.quiet else print(step, file=sys.stderr)).table())
