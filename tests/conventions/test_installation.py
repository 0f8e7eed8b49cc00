"""Installation: extras of the pages, conda recipe, container file and release recipe agree with pyproject.toml."""

from __future__ import annotations

import re
import shlex
import subprocess
import tomllib
from pathlib import Path

import pytest

from poppet.core.version import __version__

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]
ALL = set(re.fullmatch(r"poppet\[(.+)\]", EXTRAS["all"][0])[1].split(","))
USES = {
    "plot": r"--plot\b|--diagram\b|--report\b|^import matplotlib|\.plot\(",
    "data": r"\.parquet\b|^import (pandas|pyarrow|xarray)|\.to_pandas\(|\.to_xarray\(|^\$ poppet ensemble",
    "control": r"^import control|to_control\(|poppet\.control\.python_control",
    "dask": r"--scheduler\b|^from dask|^import distributed",
    "fmu": r"^\$ poppet export (fmu|ssp)\b.*--platform",
    "check": r"^\$ poppet export check .*\.fmu\b",
    "measured": r"\.(tdms|mf4|mdf|h5)\b",
    "serve": r"^\$ poppet serve .*--(modbus|mqtt|live)\b",
    "opcua": r"^\$ poppet serve .*--opcua\b",
    "mcp": r"^\$ poppet mcp\b",
    "cosim": r"^kind = \"fmu\"|--allow-native\b",
}
"""What a page shows in code if it uses an extra."""
CONDA_NAMES = {"matplotlib": "matplotlib-base", "npTDMS": "nptdms"}
CODE = re.compile(r"^(?P<fence>`{3,})[^\n]*\n(.*?)^(?P=fence)$", re.MULTILINE | re.DOTALL)
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "website" / "pages").rglob("*.md")])


def used_extras(page: str) -> set[str]:
    """Return the extras that the code of a page uses."""
    code = "\n".join(match[2] for match in CODE.finditer(page)).replace("\\\n", " ")
    spans = "\n".join(re.findall(r"`\.\w+`", page))  # formats of files, which tables list
    return {extra for extra, pattern in USES.items() if re.search(pattern, f"{code}\n{spans}", re.MULTILINE)}


def named_extras(page: str) -> set[str]:
    """Return the extras that a page names, such as `poppet[check]` or `.[check]`."""
    return {extra for names in re.findall(r"(?:poppet|\.)\[([a-z,]+)\]", page) for extra in names.split(",")}


def test_every_extra_has_a_use():
    assert USES.keys() == EXTRAS.keys() - {"all", "dev", "docs"}
    used = set().union(*(used_extras(page.read_text(encoding="utf-8")) for page in PAGES))
    assert used >= ALL


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_pages_name_the_extras_that_all_does_not_contain(page):
    text = page.read_text(encoding="utf-8")
    assert used_extras(text) - ALL <= named_extras(text)


def test_named_extras_exist():
    for page in PAGES:
        assert named_extras(page.read_text(encoding="utf-8")) <= EXTRAS.keys(), page.name


def conda_requirement(requirement: str) -> str:
    """Return a requirement of pyproject.toml in the form of the conda recipe."""
    name, limits = re.fullmatch(r"([\w.-]+)(.*)", requirement.partition(";")[0]).groups()
    return f"{CONDA_NAMES.get(name, name)} {limits}"


@pytest.fixture(scope="module")
def recipe():
    yaml = pytest.importorskip("yaml")
    return yaml.safe_load((ROOT / "conda" / "recipe.yaml").read_text(encoding="utf-8"))


def test_conda_recipe_has_the_requirements_of_the_project(recipe):
    python = f"python {PROJECT['requires-python']}"
    assert recipe["requirements"]["run"] == [python, *map(conda_requirement, PROJECT["dependencies"])]
    build = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["build-system"]["requires"]
    assert recipe["requirements"]["host"] == [python, "pip", *map(conda_requirement, build)]


def test_conda_recipe_constrains_the_packages_of_the_extras(recipe):
    requirements = {
        conda_requirement(item)
        for extra in USES
        for item in EXTRAS[extra]
        if not item.startswith("ziglang")  # a compiler in a wheel, which conda environments do not need
    }
    assert set(recipe["requirements"]["run_constraints"]) == requirements


def test_conda_recipe_has_the_metadata_of_the_project(recipe):
    assert recipe["context"]["version"] == __version__
    assert recipe["build"]["python"]["entry_points"] == [f"{k} = {v}" for k, v in PROJECT["scripts"].items()]
    assert recipe["about"]["summary"] == PROJECT["description"]
    assert (ROOT / recipe["about"]["license_file"]).is_file()


def container_steps() -> list[tuple[str, str]]:
    """Return instructions and arguments of the container file."""
    lines = (ROOT / "Containerfile").read_text(encoding="utf-8").splitlines()
    text = "\n".join(line for line in lines if line and not line.startswith("#")).replace("\\\n", "")
    return [tuple(line.split(None, 1)) for line in text.splitlines()]


def test_container_copies_files_that_exist():
    copied = {
        source
        for instruction, arguments in container_steps()
        if instruction == "COPY" and "--from" not in arguments
        for source in arguments.split()[:-1]
    }
    assert copied == {"pyproject.toml", "README.md", "LICENSE", "constraints.txt", "src"}
    assert all((ROOT / source).exists() for source in copied)


def test_container_commands_are_valid_shell():
    for instruction, arguments in container_steps():
        if instruction == "RUN":
            subprocess.run(["sh", "-n", "-c", arguments], check=True)
            assert shlex.split(arguments)


def test_container_runs_as_an_ordinary_user_with_all_extras():
    steps = container_steps()
    names = [instruction for instruction, _ in steps]
    assert names.count("FROM") == 2
    assert "[all]" in dict(steps[names.index("FROM", 1) :])["RUN"] or any("[all]" in text for _, text in steps)
    assert names.index("USER") < names.index("ENTRYPOINT")
    images = [text for instruction, text in steps if instruction == "FROM"]
    minor = int(images[-1].partition("python:3.")[2].partition("-")[0])
    assert minor >= int(PROJECT["requires-python"].rpartition(".")[2])


def test_release_attests_what_it_uploads():
    yaml = pytest.importorskip("yaml")
    release = yaml.safe_load((ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8"))
    build, publish = release["jobs"]["build"], release["jobs"]["publish"]
    assert release["permissions"] == {}
    assert build["permissions"] == {"contents": "read", "id-token": "write", "attestations": "write"}
    assert publish["permissions"] == {"id-token": "write"}
    assert publish["needs"] == "build"
    steps = [step.get("uses", step.get("run", "")) for step in build["steps"]]
    order = ["make package", "actions/attest-build-provenance", "actions/upload-artifact"]
    places = [next(k for k, step in enumerate(steps) if step.startswith(name)) for name in order]
    assert places == sorted(places)
    assert publish["steps"][-1]["with"]["attestations"] is True
