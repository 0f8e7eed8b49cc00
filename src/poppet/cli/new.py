"""`poppet new`: a circuit file to start from."""

from __future__ import annotations

import argparse
import tomllib
from pathlib import Path

from poppet.cli.output_files import output_path, write_text
from poppet.ground.errors import InputError, suggestion

EXAMPLES = ("poppet new", "poppet new valve-fill", "poppet new two-tanks -o rig.toml")
FOLDER = Path(__file__).with_name("templates")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("template", metavar="TEMPLATE", nargs="?", help="which one; lists them when left out")
    parser.add_argument("-o", "--output", metavar="FILE", help="file to write, TEMPLATE.toml by default")
    parser.add_argument("--force", action="store_true", help="overwrite an existing file")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    known = templates()
    if options.template is None:
        width = max(map(len, known))
        print("\n".join(f"{name:<{width}}  {_title(path)}" for name, path in known.items()))
        return 0
    if options.template not in known:
        raise InputError(f"template {options.template}", "is not known.", suggestion(options.template, known))
    target = output_path(options.output or f"{options.template}.toml", (".toml",))
    assert target is not None
    if target.exists() and not options.force:
        raise InputError(
            f"file {target}", "exists already.", "Choose another name with -o, or overwrite it with --force."
        )
    write_text(target, known[options.template].read_text(encoding="utf-8"))
    print(f"{target}: written. Run it with: poppet simulate {target}")
    return 0


def templates() -> dict[str, Path]:
    """Name and file of every template."""
    return {path.stem: path for path in sorted(FOLDER.glob("*.toml"))}


def _title(path: Path) -> str:
    return str(tomllib.loads(path.read_text(encoding="utf-8"))["title"])
