"""Build the website: `python website/make_site.py`, then open the printed page; no server is needed.

The sources are the pages of `docs/`, README, examples and `website/pages`, and pages that are generated from
declarations. Sphinx converts them to HTML. The cache in the output folder makes a second build fast.

The pages of `docs/`, README and examples are laid beside pages of `website/pages` and pages made from declarations, so
that their links to each other hold, and Sphinx makes HTML of them. Its cache stays in the folder: a second build is
quick.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
from importlib import resources
from pathlib import Path

import gallery_pages
import reference_pages
import validation_pages

ROOT = Path(__file__).resolve().parents[1]
OWN = Path(__file__).resolve().parent
COPIED = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "LICENSE", "docs", "examples")
MATHJAX = ("sphinx-mathjax-offline", "static/mathjax/tex-svg.js")
"""Package and file of MathJax, which draws its glyphs without fonts or requests."""


def assemble(source: Path) -> None:
    """Copy all sources of the site into a folder; unchanged files keep their times."""
    fresh = source.with_name("fresh")
    shutil.rmtree(fresh, ignore_errors=True)
    shutil.copytree(OWN / "pages", fresh)
    for name in COPIED:
        path = ROOT / name
        if path.is_dir():
            shutil.copytree(path, fresh / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy2(path, fresh / name)
    shutil.copytree(OWN / "static", fresh / "static")
    (fresh / "static" / "mathjax.js").write_bytes(mathjax())
    for page in fresh.rglob("*.md"):
        page.write_text(_without_missing(page, fresh), encoding="utf-8")
    for generated in (reference_pages.pages(), gallery_pages.pages(ROOT / "examples", fresh), validation_pages.pages()):
        for name, text in generated.items():
            page = fresh / name
            page.parent.mkdir(parents=True, exist_ok=True)
            page.write_text(text, encoding="utf-8")
    _replace(fresh, source)


def _without_missing(page: Path, source: Path) -> str:
    """Return the text of a page without links to folders and files that are not part of the site."""

    def shown(link: re.Match[str]) -> str:
        target = page.parent / link[2]
        original = ROOT / os.path.relpath(target, source)
        return link[1] if target.is_dir() or (original.exists() and not target.exists()) else link[0]

    return re.sub(r"(?<!!)\[([^\]]+)\]\(([^)#\s:]+)\)", shown, page.read_text(encoding="utf-8"))


def mathjax() -> bytes:
    """Return the JavaScript of MathJax from its package."""
    package, file = MATHJAX
    resource = resources.files(package).joinpath(file)
    return resource.read_bytes()


def _replace(fresh: Path, source: Path) -> None:
    """Make a folder equal to another one; Sphinx rebuilds pages with new times."""
    source.mkdir(parents=True, exist_ok=True)
    names = {path.relative_to(fresh) for path in fresh.rglob("*") if path.is_file()}
    for path in [path for path in source.rglob("*") if path.is_file()]:
        if path.relative_to(source) not in names:
            path.unlink()
    for name in sorted(names):
        old, new = source / name, fresh / name
        if not old.exists() or old.read_bytes() != new.read_bytes():
            old.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(new, old)
    shutil.rmtree(fresh)


def build(folder: Path) -> int:
    """Assemble the sources and run Sphinx with warnings as errors; return its exit status."""
    assemble(folder / "source")
    command = [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-j", "2", "-c", str(OWN)]
    # Cached notebooks stay valid until their text or the package changes.
    command += ["-D", f"nb_execution_cache_path={folder / 'notebooks' / gallery_pages.program()}"]
    command += ["-d", str(folder / "doctrees"), str(folder / "source"), str(folder / "html")]
    # Notebooks call the `poppet` command of this environment.
    shutil.copytree(OWN / "ipython", folder / "ipython", dirs_exist_ok=True)
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    status = subprocess.run(
        command, check=False, env=os.environ | {"PATH": path, "IPYTHONDIR": str(folder / "ipython")}
    ).returncode
    if status == 0:
        print(f"The website is {folder / 'html' / 'index.html'}")
    return status


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Build the site.")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build" / "site", help="folder to build in")
    sys.exit(build(parser.parse_args().output.resolve()))
