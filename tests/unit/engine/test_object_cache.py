"""Object code on disk is run only where nobody but the user can have written it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from poppet.engine import object_cache
from poppet.engine.object_cache import object_code

pytestmark = pytest.mark.skipif(os.name != "posix", reason="rights of files as on POSIX")


class Compiler:
    """Counts how often it is asked."""

    def __init__(self) -> None:
        self.asked = 0

    def __call__(self, source: str) -> bytes:
        self.asked += 1
        return source.encode()[::-1]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("POPPET_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache"


def entry(folder: Path) -> Path:
    (found,) = folder.glob("*.o")
    return found


def code(compiler: Compiler) -> int:
    """Asks twice for one code, and says how often it was compiled."""
    compiler.asked = 0
    assert [object_code("abc", compiler), object_code("abc", compiler)] == [b"cba", b"cba"]
    return compiler.asked


def test_folder_and_entries_are_accessible_to_the_user_only(folder):
    assert code(Compiler()) == 1
    assert folder.stat().st_mode & 0o777 == 0o700
    assert entry(folder).stat().st_mode & 0o777 == 0o600


def test_entry_with_write_permission_of_others_is_compiled_again(folder):
    code(Compiler())
    entry(folder).chmod(0o666)
    assert code(Compiler()) == 1  # made anew, renamed over the old one, and read
    assert entry(folder).stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("rights", [0o777, 0o770])
def test_folder_with_write_permission_of_others_is_not_used(folder, rights):
    folder.mkdir()
    folder.chmod(rights)
    assert code(Compiler()) == 2
    assert list(folder.iterdir()) == []


def test_a_link_in_place_of_an_entry_is_not_followed(folder, tmp_path):
    code(Compiler())
    planted = tmp_path / "planted"
    entry(folder).rename(planted)
    path = folder / f"{object_cache._key('abc')}.o"
    path.symlink_to(planted)
    assert code(Compiler()) == 1
    assert not path.is_symlink()


def test_entry_of_another_owner_is_not_read(folder, monkeypatch):
    code(Compiler())
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert code(Compiler()) == 2


def test_incomplete_entry_is_compiled_again(folder):
    code(Compiler())
    entry(folder).write_bytes(entry(folder).read_bytes()[:-1])
    assert code(Compiler()) == 1
