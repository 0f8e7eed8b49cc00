"""The published text says nothing about the machine it was written on, and leaves nothing half done."""

from __future__ import annotations

import re
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
FOLDERS = ("src", "tests", "docs", "examples", "benchmarks", "tools", ".ci")
ENDINGS = {".py", ".md", ".toml", ".txt", ".yml", ".yaml", ".html", ".css", ".cfg", ".sh"}

# Put together here, so that this file does not find itself.
HOSTS = [
    ".".join(parts)
    for parts in (("pypi", "org"), ("pythonhosted", "org"), ("test", "pypi", "org"), ("conda", "anaconda", "org"))
]
UNFINISHED = ["TO" + "DO", "FIX" + "ME", "X" + "XX", "HA" + "CK"]
MACHINE = [re.escape(str(REPOSITORY)), re.escape(str(Path.home()) + "/") if str(Path.home()) != "/" else r"(?!)"]
MACHINE += ["/" + folder + "/" for folder in ("home", "root", "Users", "work", "tmp")]
WORDS = {
    "a path of one machine": re.compile("|".join(rf"(?<![\w.:/~])(?:{pattern})" for pattern in MACHINE)),
    "the host of a package registry": re.compile("|".join(re.escape(host) for host in HOSTS)),
    "something unfinished": re.compile("|".join(rf"\b{word}\b" for word in UNFINISHED)),
}


def files() -> list[Path]:
    found = [path for path in REPOSITORY.iterdir() if path.is_file()]
    for folder in FOLDERS:
        found += [path for path in (REPOSITORY / folder).rglob("*") if path.is_file()]
    kept = [path for path in found if path.suffix in ENDINGS or path.name in ("Makefile", "LICENSE", ".gitignore")]
    return sorted(
        path
        for path in kept
        if "__pycache__" not in path.parts and not any(part.endswith(".egg-info") for part in path.parts)
    )


FILES = {path.relative_to(REPOSITORY).as_posix(): path for path in files()}


def test_there_is_something_to_look_at():
    assert "src/poppet/__init__.py" in FILES
    assert "pyproject.toml" in FILES


def test_no_stray_words():
    found = [
        f"{name}:{text.count(chr(10), 0, match.start()) + 1}: {match[0]!r} is {what}"
        for name, path in FILES.items()
        for text in [path.read_text(encoding="utf-8")]
        for what, pattern in WORDS.items()
        for match in pattern.finditer(text)
    ]
    assert found == []


def test_the_check_sees_what_it_should():
    assert WORDS["a path of one machine"].search(f"see {REPOSITORY}/src")
    assert WORDS["something unfinished"].search("# " + UNFINISHED[0] + ": later")
    assert WORDS["the host of a package registry"].search("https://" + HOSTS[0] + "/simple")
    assert not WORDS["a path of one machine"].search("docs/home/page and ./tmp/x")
