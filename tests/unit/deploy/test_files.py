"""Tests of exported files: identifiers, comments, string literals and folders."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from poppet.deploy.export_files import MARK, c_string, comment_text, identifier, identifiers, write_folder
from refusals import refused

HOSTILE = "*/ int main; /* \\\n // (* *) ??/ <script>&\"'%s \u202e µ"


@given(st.lists(st.text(max_size=12), max_size=6))
def test_identifiers_are_valid_and_distinct(texts):
    names = identifiers(texts)
    assert all(re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name) for name in names)
    assert len({name.lower() for name in names}) == len(texts)
    assert not any("__" in name for name in names)


@given(st.text(max_size=80))
def test_comment_text_cannot_end_the_comment(text):
    comment = comment_text(text)
    assert not any(end in comment for end in ("*/", "/*", "//", "*)", "(*", "??", "\\", "\n"))
    assert re.fullmatch(r"[ -~]*", comment)


@given(st.text(max_size=80))
def test_c_string_contains_all_bytes(text):
    content = c_string(text)[1:-1]
    read = re.sub(r"\\([0-7]{3})", lambda m: chr(int(m[1], 8)), content)
    assert read.encode("latin-1") == text.encode()
    assert '"' not in content
    assert content.isascii()
    assert "??" not in content


def test_reserved_words_are_no_identifiers():
    assert [identifier(reserved) for reserved in ("int", "While", "END_", "class")] == [
        "int_v",
        "While_v",
        "END_v",
        "class_v",
    ]
    assert identifier(HOSTILE).isidentifier()


def test_a_folder_is_written_completely_and_can_be_rewritten(tmp_path):
    folder = tmp_path / "valve"
    write_folder(folder, {"a.c": "1", "sub/b.h": b"2"}, "x = 1\n")
    assert sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()) == sorted(
        ["a.c", MARK, "sub/b.h"]
    )
    (folder / "mine.txt").write_text("kept")
    write_folder(folder, {"a.c": "3"}, "x = 2\n")
    assert (folder / "a.c").read_text() == "3"
    assert (folder / "mine.txt").read_text() == "kept"
    assert [p.name for p in tmp_path.iterdir()] == ["valve"]


def test_a_folder_with_other_files_is_refused(tmp_path):
    (tmp_path / "theirs").mkdir()
    (tmp_path / "theirs" / "thesis.txt").write_text("years")
    with refused("deploy.folder_taken"):
        write_folder(tmp_path / "theirs", {"a.c": "1"}, "")
    assert [p.name for p in (tmp_path / "theirs").iterdir()] == ["thesis.txt"]
    with refused("files.no_folder"):
        write_folder(tmp_path / "none" / "below", {"a.c": "1"}, "")


@pytest.mark.parametrize("path", ["../a.c", "/etc/a.c", "a/../../b", "a\\b", "", ".hidden", "C:a", "a/", "con."])
def test_paths_outside_the_folder_are_refused(tmp_path, path):
    with refused("deploy.outside", path=path):
        write_folder(tmp_path / "own", {path: "1"}, "")
    assert list(tmp_path.iterdir()) == []


def test_links_out_of_the_folder_are_not_followed(tmp_path):
    folder, link_target = tmp_path / "own", tmp_path / "outside"
    link_target.mkdir()
    (link_target / "a.c").write_text("theirs")
    write_folder(folder, {"b.c": "1"}, "")
    (folder / "sub").symlink_to(link_target)
    with refused("deploy.outside", path="sub/a.c"):
        write_folder(folder, {"sub/a.c": "1"}, "")
    (folder / "a.c").symlink_to(link_target / "a.c")
    write_folder(folder, {"a.c": "mine"}, "")
    assert (link_target / "a.c").read_text() == "theirs"
    assert (folder / "a.c").read_text() == "mine"
