"""File access of the functions for assistants: one folder, ordinary files, no silent loss."""

from __future__ import annotations

import os

import pytest

from poppet.assist.circuits import check, load_circuit
from poppet.assist.files import list_files, read_file, write_file
from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS, perform
from poppet.assist.limits import TEXT
from poppet.core.errors import InputError

ESCAPES = (
    "../secret.toml",
    "/etc/passwd",
    "sub/../../secret.toml",
    "./tank.toml",
    "..",
    "",
    "sub//tank.toml",
    ".git/config.toml",
    ".hidden.toml",
    "C:\\secret.toml",
    "..\\secret.toml",
    "a\nb.toml",
    "nul.toml",
    "tank.toml.",
    "x" * 300 + ".toml",
    "tank\u202e.toml",
    "tank\u200b.toml",
    "..\u2215secret.toml",
    "tank\0.toml",
    "file:///etc/passwd",
    "/proc/self/environ",
    "~/../secret.toml",
    "tank.toml/../../secret.toml",
)


@pytest.mark.parametrize("name", ESCAPES)
@pytest.mark.parametrize("action", ["read", "write"])
def test_names_of_other_files_are_rejected(folder, name, action):
    arguments = {"name": name} | ({"text": "x", "replace": True} if action == "write" else {})
    with pytest.raises(InputError) as caught:
        perform(Folder.of(folder), FUNCTIONS[f"{action}_file"], arguments)
    assert caught.value.code == "assist.file_name"
    assert caught.value.address == "name"
    assert caught.value.hint
    assert (folder.parent / "secret.toml").read_text() == "key = 1\n"


@pytest.mark.parametrize("suffix", ["", ".py", ".sh", ".pem", ".html"])
def test_files_that_could_be_executed_or_are_no_data_are_rejected(folder, suffix):
    for function, arguments in ((read_file, {}), (write_file, {"text": "import os"})):
        with pytest.raises(InputError) as caught:
            function(Folder.of(folder), f"conftest{suffix}", **arguments)
        assert caught.value.code == "files.suffix"
    assert not (folder / f"conftest{suffix}").exists()


@pytest.mark.skipif(os.name != "posix", reason="links need rights on Windows")
def test_links_do_not_lead_out(folder):
    (folder / "link.toml").symlink_to(folder.parent / "secret.toml")
    (folder / "sub").symlink_to(folder.parent, target_is_directory=True)
    (folder / "dangling.toml").symlink_to(folder.parent / "new.toml")
    for name in ("link.toml", "sub/secret.toml"):
        with pytest.raises(InputError) as caught:
            read_file(Folder.of(folder), name)
        assert caught.value.code == "files.outside"
        assert str(folder) not in f"{caught.value}"
    for name in ("link.toml", "sub/new.toml", "dangling.toml"):
        with pytest.raises(InputError) as caught:
            write_file(Folder.of(folder), name, "x", replace=True)
        assert caught.value.code == "files.outside"
    assert not (folder.parent / "new.toml").exists()
    assert [row["name"] for row in list_files(Folder.of(folder))["files"]] == ["tank.toml"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no pipes with names")
def test_a_pipe_is_no_file(folder):
    os.mkfifo(folder / "pipe.toml")
    for function, arguments in ((read_file, {}), (write_file, {"text": "x", "replace": True})):
        with pytest.raises(InputError) as caught:
            function(Folder.of(folder), "pipe.toml", **arguments)
        assert caught.value.code == "files.no_file"


def test_a_file_is_replaced_on_request_only(folder):
    before = (folder / "tank.toml").read_text()
    with pytest.raises(InputError) as caught:
        write_file(Folder.of(folder), "tank.toml", "x")
    assert (caught.value.code, caught.value.address) == ("assist.exists", "name")
    assert (folder / "tank.toml").read_text() == before
    assert write_file(Folder.of(folder), "tank.toml", "x = 1\n", replace=True) == {"name": "tank.toml", "bytes": 6}
    assert (folder / "tank.toml").read_text() == "x = 1\n"


def test_a_missing_folder_is_named(folder):
    with pytest.raises(InputError) as caught:
        write_file(Folder.of(folder), "absent/below/tank.toml", "x")
    assert (caught.value.code, caught.value.facts["folder"]) == ("files.no_folder", "absent/below")


def test_large_and_binary_files_are_not_read(folder):
    (folder / "large.csv").write_bytes(b"1" * (TEXT + 1))
    (folder / "binary.csv").write_bytes(b"\xff\xfe\x00")
    for name, code in (
        ("large.csv", "assist.large_file"),
        ("binary.csv", "assist.no_text"),
        ("no.csv", "names.unknown"),
    ):
        with pytest.raises(InputError) as caught:
            read_file(Folder.of(folder), name)
        assert caught.value.code == code


OUTSIDE = {
    "signal": '[signals."valve.opening"]\nkind = "file"\npath = "../opening.csv"\ncolumn = "x"\n',
    "components": 'components = ["../components.toml"]\n',
    "ensemble": '[ensemble]\nsampling = "file"\nfile = "../table.csv"\n'
    '[ensemble.metrics]\nx = { of = "tank.pressure", metric = "max" }\n',
}


@pytest.mark.parametrize("case", OUTSIDE)
def test_a_circuit_cannot_name_files_outside(folder, case):
    (folder.parent / "opening.csv").write_text("time,x\n0,1\n1,1\n")
    (folder.parent / "components.toml").write_text("[components]\n")
    (folder.parent / "table.csv").write_text("tank.volume\n1\n")
    own = OUTSIDE[case] if case == "components" else ""
    text = own + (folder / "tank.toml").read_text() + ("" if own else OUTSIDE[case])
    with pytest.raises(InputError) as caught:
        perform(Folder.of(folder), FUNCTIONS["check"], {"text": text})
    assert caught.value.code == "files.outside"


def test_circuits_with_python_or_native_code_are_rejected(folder):
    base = (folder / "tank.toml").read_text()
    (folder / "metrics.py").write_text("raise SystemExit('executed')\n")
    python = base + "[ensemble]\nruns = 2\n[ensemble.parameters]\n"
    python += '"tank.volume" = { distribution = "normal", relative_sigma = 0.1 }\n'
    python += '[ensemble.metrics]\nx = { of = "tank.pressure", metric = "metrics.py:x" }\n'
    with pytest.raises(InputError) as caught:
        check(Folder.of(folder), text=python)
    assert "ensemble.python_forbidden" in [row.code for row in caught.value.problems]
    native = base + '[parts.valve2]\nkind = "fmu"\npath = "valve.fmu"\n'
    with pytest.raises(InputError) as caught:
        load_circuit(Folder.of(folder), "", native)
    assert (caught.value.code, caught.value.address) == ("assist.native", "parts.valve2")
