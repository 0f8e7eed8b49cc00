"""An ensemble on disk: Parquet shards that are written aside and renamed, and a manifest that says what they are."""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import Circuit
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.version import __version__
from poppet.engine.lane_kernel import kernel_of_this_machine
from poppet.ensemble.designs import design_of
from poppet.ensemble.ensemble_plan import EnsemblePlan
from poppet.timeseries.tables.parquet import arrow, table_in

MANIFEST = "manifest.json"
FORMAT = 1
_NOT_OF_RUNS = ("indices",)
"""What may be changed later without touching the runs that are there."""


def fingerprint(circuit: Circuit) -> str:
    """Hash of all that a run of a circuit depends on."""
    problem = circuit.problem(circuit.run)
    arrays = (
        problem.p, problem.x0, problem.starts, problem.courses, problem.coefficients, problem.jumps, problem.grid,
        np.array([problem.relative_tolerance, problem.maximum_step]),
    )  # fmt: skip
    content = hashlib.sha256(repr((circuit.structure, circuit.run.stop_texts, problem.kernel.model.outputs)).encode())
    for array in arrays:
        content.update(repr(array.shape).encode() + np.ascontiguousarray(array).tobytes())
    return content.hexdigest()


def described(plan: EnsemblePlan) -> dict[str, Any]:
    """What decides the runs: of each aspect its facts as plain values, for a manifest and its hash."""
    circuit = plan.circuit
    numbers: dict[str, Any] = {a: {"distribution": d.kind, **d.numbers} for a, d in plan.alone.items()}
    for address, own in plan.alone.items():
        numbers[address] |= {k: v for k, v in (("from", own.low), ("to", own.high)) if np.isfinite(v)}
    if plan.joint_normal is not None:
        numbers["from_fit"] = {"addresses": list(plan.joint), **vars(plan.joint_normal)}
    if plan.table is not None:
        digest = hashlib.sha256(np.ascontiguousarray(plan.table[1]).tobytes()).hexdigest()
        numbers = {"table": {"addresses": list(plan.table[0]), "sha256": digest}}
    sampling = {"way": plan.sampling, "runs": plan.runs, "seed": plan.seed, "levels": plan.levels}
    return {
        "circuit": {"title": circuit.title, "sha256": fingerprint(circuit)},
        "sampling": sampling if plan.sampling == "grid" else {k: v for k, v in sampling.items() if k != "levels"},
        "numbers": numbers,
        "metrics": {metric.name: metric.facts() for metric in plan.metrics},
        "kept": {"keep": plan.keep, "curves": list(plan.curves)},
        "indices": plan.indices,
    }


def versions() -> dict[str, str]:
    """Of all that has a part in the bits."""
    python = ".".join(map(str, sys.version_info[:3]))
    return {"poppet": __version__, "python": python, **_packages(), "kernel": kernel_of_this_machine()}


@cache
def _packages() -> dict[str, str]:
    # Milliseconds each, in texts that packages have left behind.
    from importlib.metadata import version

    return {name: version(name) for name in ("numpy", "scipy", "casadi", "llvmlite", "pyarrow")}


@dataclass(frozen=True)
class Dataset:
    """A folder of shards."""

    folder: Path
    manifest: Mapping[str, Any]
    hashes: Mapping[str, str] = field(default_factory=dict)  # by which files were known when all of it was there

    @staticmethod
    def opened(folder: Path, plan: EnsemblePlan) -> Dataset:
        """The dataset of a plan in a folder that is new, empty, or holds a part of it."""
        arrow()
        content = {"format": FORMAT, "poppet ensemble": described(plan), "versions": versions()}
        # As a file gives it back.
        content = json.loads(_text(content))
        content["sha256"] = _hash({k: v for k, v in content["poppet ensemble"].items() if k not in _NOT_OF_RUNS})
        path, there = folder / MANIFEST, None
        if path.exists():
            there = _checked(path, content)
        elif folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise InputError("ensemble.folder_taken", path=str(folder))
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise InputError("files.unwritable", path=str(folder), why=problem.strerror or str(problem)) from problem
        if there is None:
            found = Dataset(folder, content)
        elif there["poppet ensemble"] == content["poppet ensemble"]:
            return Dataset(folder, content, there.get("files", {}))
        else:
            # Shards of other indices look like those that are wanted: they go before the manifest says these.
            for path in (folder / "indices").glob("part-*.parquet"):
                path.unlink()
            files = there.get("files", {})
            found = Dataset(folder, content, {k: v for k, v in files.items() if not k.startswith("indices/")})
        found._write_manifest()
        return found

    def _write_manifest(self) -> None:
        text = _text(self.manifest)
        path = self.folder / MANIFEST
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            write_whole(path, lambda stream: stream.write(text.encode("utf-8")))

    def sealed(self) -> Dataset:
        """With the hashes of all files in its manifest."""
        files = sorted(path for path in self.folder.glob("*/part-*.parquet"))
        hashes = {path.relative_to(self.folder).as_posix(): _digest(path) for path in files}
        found = Dataset(self.folder, {**self.manifest, "files": hashes})
        found._write_manifest()
        return found

    def missing(self, plan: EnsemblePlan, kind: str) -> list[int]:
        """Numbers of the shards of a kind that are not there, or not whole."""
        design = design_of(plan, kind)
        beside = {"bands": "bands", "all": "curves"}.get(plan.keep) if kind == "runs" and plan.curves else None
        found, count = [], -(-design.size // design.shard)
        for folder in (kind, beside) if beside else (kind,):
            strays = {path.name for path in (self.folder / folder).glob("part-*.parquet")} - set(
                map(_name, range(count))
            )
            if strays:
                raise InputError("ensemble.stray_file", path=str(self.folder / folder / min(strays)))
        for number in range(count):
            rows = min(design.shard, design.size - number * design.shard)
            if self._rows(kind, number) != rows or (beside and self._rows(beside, number) < 0):
                found.append(number)
        return found

    def _rows(self, kind: str, number: int) -> int:
        """Rows of a shard; none where its file is not there, is not what it was, or cannot be read."""
        path = self.folder / kind / _name(number)
        known = self.hashes.get(f"{kind}/{_name(number)}")
        if not path.exists() or (known and _digest(path) != known):
            return -1
        with suppress(OSError, arrow().ArrowException):
            return int(arrow().parquet.read_metadata(path).num_rows)
        return -1

    def write(self, files: Mapping[str, bytes]) -> None:
        """Write the files of a shard, the one that says that it is done last."""
        for name, content in files.items():
            path = self.folder / name
            path.parent.mkdir(exist_ok=True)
            write_whole(path, lambda stream, content=content: stream.write(content))  # type: ignore[misc]

    def shards(self, kind: str, columns: list[str] | None = None) -> Iterator[dict[str, NDArray[Any]]]:
        """Columns of one shard after the other, in the order of the runs."""
        for path in sorted((self.folder / kind).glob("part-*.parquet")):
            table = table_in(path, columns)
            yield {name: table[name].to_numpy() for name in table.column_names}

    def columns(self, kind: str, columns: list[str] | None = None, most: int | None = None) -> dict[str, NDArray[Any]]:
        """Columns of all shards, or of the first ones with that many runs."""
        parts: list[dict[str, NDArray[Any]]] = []
        count = 0
        for shard in self.shards(kind, columns):
            parts.append(shard)
            count += len(next(iter(shard.values())))
            if most is not None and count >= most:
                break
        return {name: np.concatenate([part[name] for part in parts])[:most] for name in (parts[0] if parts else ())}


def _name(number: int) -> str:
    return f"part-{number:05d}.parquet"


def _checked(path: Path, content: Mapping[str, Any]) -> dict[str, Any]:
    """The manifest that is there, refused if it is not one of this dataset."""
    try:
        there = json.loads(path.read_text(encoding="utf-8"))
        known = there["poppet ensemble"]
    except (OSError, ValueError, KeyError, TypeError):
        raise InputError("ensemble.folder_taken", path=str(path.parent)) from None
    if there.get("sha256") != content["sha256"]:
        wanted = content["poppet ensemble"]
        differs = [key for key in wanted if key not in _NOT_OF_RUNS and known.get(key) != wanted[key]]
        title = known.get("circuit", {}).get("title", "") if isinstance(known, dict) else ""
        raise InputError("ensemble.other_dataset", path=str(path.parent), differs=differs, title=title)
    if there.get("versions") != content["versions"]:
        old, new = there.get("versions", {}), content["versions"]
        changed = {name: f"{old.get(name, '-')} -> {new[name]}" for name in new if old.get(name) != new[name]}
        raise InputError("ensemble.other_versions", path=str(path.parent), changed=changed)
    return dict(there)


def _text(content: Mapping[str, Any]) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _hash(content: Any) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
