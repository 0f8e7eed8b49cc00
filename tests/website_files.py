"""The website, built once for all tests of a session, and what its pages refer to."""

from __future__ import annotations

import fcntl
import os
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).parents[1]


def built_site(session_folder: Path) -> Path:
    """Return the folder of the pages; the first worker of pytest-xdist builds them, and the others wait.

    `POPPET_SITE` can name the folder of a site that is already built.
    """
    if "POPPET_SITE" in os.environ:
        return Path(os.environ["POPPET_SITE"])
    if "PYTEST_XDIST_WORKER" in os.environ:
        session_folder = session_folder.parent  # each worker has a folder of its own in that of the session
    folder = session_folder / "website"
    with (session_folder / "website.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            command = [sys.executable, "-W", "ignore", "website/make_site.py", "-o", str(folder)]
            done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=900, check=False)
            (folder / "problem.txt").write_text((done.stdout + done.stderr) * (done.returncode != 0), encoding="utf-8")
    problem = (folder / "problem.txt").read_text(encoding="utf-8")
    assert not problem, problem
    return folder / "html"


class PageReferences(HTMLParser):
    """Targets of links and files of a page, and the identifiers of its elements."""

    def __init__(self, page: Path) -> None:
        super().__init__()
        self.page, self.targets, self.identifiers = page, set(), {"", "top"}
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        """Keep the addresses and the identifier of an element."""
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.identifiers.add(value)
            elif name in ("href", "src") and value and not (tag == "link" and ("rel", "canonical") in attributes):
                self.targets.add(value)


def broken_links(site: Path) -> list[str]:
    """Return the links of all pages to files of the site and to places in pages that do not exist."""
    pages = {path: PageReferences(path) for path in site.rglob("*.html") if "_static" not in path.parts}
    broken = []
    for path, references in pages.items():
        for target in references.targets:
            address = urlsplit(target)
            if address.scheme or address.netloc:
                continue
            file = (path.parent / unquote(address.path)).resolve() if address.path else path
            place = unquote(address.fragment)
            is_place = file not in pages or place in pages[file].identifiers
            if not file.exists() or not is_place:
                broken.append(f"{path.relative_to(site)}: {target}")
    return sorted(broken)
