"""The pages of documentation and website stay short, and the index names each page once."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [*sorted(DOCS.rglob("*.md")), *sorted((ROOT / "website" / "pages").rglob("*.md"))]
MOST_WORDS = 55_000
MOST_REPEATED = 12
"""Largest number of successive words that two pages may share."""


def prose(text: str) -> str:
    """Return a page without front matter, code blocks, displayed formulas and rows of tables."""
    text = re.sub(r"\A---\n.*?^---\n", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^ *(```+|~~~+).*?^ *\1 *$", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"\$\$.*?\$\$", "", text, flags=re.DOTALL)
    return "\n".join(line for line in text.splitlines() if not line.lstrip().startswith("|"))


def words_of(text: str) -> int:
    return len(prose(text).split())


def repeated(pages: dict[str, str]) -> list[tuple[str, str, str]]:
    """Runs of more successive words than permitted that stand on two pages, with the names of both."""
    first: dict[str, str] = {}
    found = []
    for page, text in pages.items():
        for sentence in re.split(r"(?<=[.:])\s+|\n\n", re.sub(r"\]\([^)]*\)", "]", prose(text))):
            words = re.findall(r"[\w.%°/]+", sentence.lower())
            for k in range(len(words) - MOST_REPEATED):
                run = " ".join(words[k : k + MOST_REPEATED + 1])
                if first.setdefault(run, page) != page:
                    found.append((first[run], page, run))
    return found


def test_pages_are_short() -> None:
    counts = {page.relative_to(ROOT).as_posix(): words_of(page.read_text(encoding="utf-8")) for page in PAGES}
    assert sum(counts.values()) <= MOST_WORDS, sorted(counts.items(), key=lambda item: -item[1])[:10]


def test_only_prose_is_counted() -> None:
    page = "---\na: b\n---\n# Two words\n\nThree more words.\n\n| no | row |\n\n```c\nno code\n```\n\n$$\nx = y\n$$\n"
    assert words_of(page) == 6
    assert words_of("- item:\n\n  ```c\n  int no_code;\n  ```\n") == 2


def test_no_sentence_is_on_two_pages() -> None:
    assert repeated({page.relative_to(ROOT).as_posix(): page.read_text(encoding="utf-8") for page in PAGES}) == []


def test_a_repeated_sentence_is_found() -> None:
    sentence = "a b c d e f g h i j k l m"
    (found,) = repeated({"one": f"First. {sentence}.", "two": f"{sentence}. Last."})
    assert found[:2] == ("one", "two")
    assert repeated({"one": f"{sentence}. {sentence}.", "two": sentence.removesuffix(" m")}) == []


def test_index_names_each_page_once() -> None:
    tables = re.findall(r"^\|.*\|$", (DOCS / "index.md").read_text(encoding="utf-8"), re.MULTILINE)
    named = re.findall(r"\[(?:\w+\.md)\]\((\w+\.md)\)", "\n".join(tables))
    others = {"index.md", "python.md"}  # the tour is a tutorial, above the tables
    assert sorted(named) == sorted({page.name for page in DOCS.glob("*.md")} - others)
