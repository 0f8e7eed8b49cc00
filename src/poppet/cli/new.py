"""`poppet new`: a circuit file to start from."""

from __future__ import annotations

import argparse
import tomllib
from pathlib import Path

from poppet.cli.parser import Option, output_path
from poppet.core.errors import InputError, NameSuggestion

EXAMPLES = ("poppet new", "poppet new valve-fill", "poppet new two-tanks -o rig.toml")
OPTIONS = (
    Option("[TEMPLATE]", "which one; lists them when left out"),
    Option("-o, --output FILE", "file to write instead of TEMPLATE.toml", (".toml",)),
    Option("--force", "overwrite an existing file"),
)
FOLDER = Path(__file__).with_name("templates")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    known, name = templates(), options.template
    if name is None:
        width = max(map(len, known))
        for known_name, path in known.items():
            print(f"{known_name:<{width}}  {tomllib.loads(path.read_text(encoding='utf-8'))['title']}")
        return 0
    if name not in known:
        near = NameSuggestion(name, known)
        raise InputError("fields.not_an_option", "template", value=name, meaning="template", near=near)
    # An `--output` was checked by the parser; the name from the template is checked here.
    target: Path = options.output or output_path(f"{name}.toml", (".toml",))
    if target.exists() and not options.force:
        raise InputError("cli.template.exists", path=str(target))

    from poppet.core.files import write_whole

    write_whole(target, lambda stream: stream.write(known[name].read_bytes()))
    print(f"{target}: written. Run it with: poppet simulate {target}")
    return 0


def templates() -> dict[str, Path]:
    """Name and file of every template."""
    return {path.stem: path for path in sorted(FOLDER.glob("*.toml"))}
