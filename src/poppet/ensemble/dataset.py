"""Ensemble on disk: Parquet files (shards), each with the results of some runs, and a manifest.

Every file is written atomically.
"""

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

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import InputError
from poppet.core.files import make_folder, open_input, write_whole
from poppet.core.version import __version__
from poppet.engine.lane_kernel import kernel_of_this_machine
from poppet.ensemble.ensemble_plan import EnsemblePlan
from poppet.timeseries.tables.reading import arrow, table_in

MANIFEST = "manifest.json"
FORMAT = 1
_NOT_OF_RUNS = ("indices",)
"""Settings of a plan that can change although runs are stored: the stored runs remain valid."""


def fingerprint(circuit: BaseCircuit) -> str:
    """Return a hash of all properties of a circuit that affect its runs."""
    problem = circuit.problem(circuit.run)
    arrays = (
        problem.p, problem.x0, problem.starts, problem.courses, problem.coefficients, problem.jumps, problem.grid,
        np.array([problem.relative_tolerance, problem.maximum_step]),
    )  # fmt: skip
    content = hashlib.sha256(repr((circuit.structure, circuit.run.stop_texts, problem.kernel.model.outputs)).encode())
    for array in arrays:
        content.update(repr(array.shape).encode() + np.ascontiguousarray(array).tobytes())
    return content.hexdigest()


def describe_plan(plan: EnsemblePlan) -> dict[str, Any]:
    """Return all settings of an ensemble that determine its runs, as plain values.

    They are written to the manifest of the dataset, the file that describes its content.
    """
    circuit = plan.circuit
    numbers: dict[str, Any] = {a: {"distribution": d.kind, **d.numbers} for a, d in plan.alone.items()}
    for address, distribution in plan.alone.items():
        numbers[address] |= {k: v for k, v in (("from", distribution.low), ("to", distribution.high)) if np.isfinite(v)}
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
    """Return the versions of all software that can affect the results, by name."""
    python = ".".join(map(str, sys.version_info[:3]))
    return {"poppet": __version__, "python": python, **_packages(), "kernel": kernel_of_this_machine()}


@cache
def _packages() -> dict[str, str]:
    # Each look-up takes milliseconds.
    from importlib.metadata import version

    return {name: version(name) for name in ("numpy", "scipy", "casadi", "llvmlite", "pyarrow")}


@dataclass(frozen=True)
class Dataset:
    """Folder with the stored results of an ensemble.

    Results are stored in shards, files with the results of some runs. The manifest is a file with the settings, the
    software versions and, after completion, the hashes of all shards.
    """

    folder: Path
    manifest: Mapping[str, Any]
    hashes: Mapping[str, str] = field(default_factory=dict)  # of the files of a complete dataset

    @staticmethod
    def open(folder: Path, plan: EnsemblePlan) -> Dataset:
        """Open the folder in which the results of an ensemble are stored.

        The folder is created if necessary. An existing folder must be empty or contain results of the same ensemble.
        """
        arrow()
        content = {"format": FORMAT, "poppet ensemble": describe_plan(plan), "versions": versions()}
        # As it is read from a file.
        content = json.loads(_text(content))
        of_runs = {k: v for k, v in content["poppet ensemble"].items() if k not in _NOT_OF_RUNS}
        content["sha256"] = hashlib.sha256(json.dumps(of_runs, sort_keys=True).encode()).hexdigest()
        if plan.python_functions:
            content["python"] = list(plan.python_functions)
        path, stored = folder / MANIFEST, None
        if path.exists():
            stored = _read_manifest(path, content)
        elif folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise InputError("ensemble.folder_taken", path=str(folder))
        make_folder(folder)
        if stored is None:
            dataset = Dataset(folder, content)
        elif stored["poppet ensemble"] == content["poppet ensemble"]:
            return Dataset(folder, content, stored.get("files", {}))
        else:
            # Shards of other indices have equal names. Delete them before the manifest changes.
            for path in (folder / "indices").glob("part-*.parquet"):
                path.unlink()
            files = stored.get("files", {})
            dataset = Dataset(folder, content, {k: v for k, v in files.items() if not k.startswith("indices/")})
        dataset._write_manifest()
        return dataset

    def _write_manifest(self) -> None:
        text = _text(self.manifest)
        path = self.folder / MANIFEST
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            write_whole(path, lambda stream: stream.write(text.encode("utf-8")))

    def seal(self) -> Dataset:
        """Write the hashes of all result files to the manifest, and return the complete dataset.

        The manifest is the file that describes the content of the folder.
        """
        files = sorted(path for path in self.folder.glob("*/part-*.parquet"))
        hashes = {path.relative_to(self.folder).as_posix(): _digest(path) for path in files}
        dataset = Dataset(self.folder, {**self.manifest, "files": hashes})
        dataset._write_manifest()
        return dataset

    def missing(self, plan: EnsemblePlan, kind: str) -> list[int]:
        """Return the indices of the shards that must still be computed.

        A shard is a file with the results of some runs. `kind` is the kind of runs: `runs`, `tornado` or `indices`.
        """
        size, shard_size = plan.counts(kind)
        curve_folder = {"bands": "bands", "all": "curves"}.get(plan.keep) if kind == "runs" and plan.curves else None
        missing, count = [], -(-size // shard_size)
        for folder in (kind, curve_folder) if curve_folder else (kind,):
            names = {path.name for path in (self.folder / folder).glob("part-*.parquet")}
            if strays := names - {*map(_name, range(count))}:
                raise InputError("ensemble.stray_file", path=str(self.folder / folder / min(strays)))
        for number in range(count):
            rows = min(shard_size, size - number * shard_size)
            if self._rows(kind, number) != rows or (curve_folder and self._rows(curve_folder, number) < 0):
                missing.append(number)
        return missing

    def _rows(self, kind: str, number: int) -> int:
        """Return the number of runs in one shard: a file with the results of some runs.

        `kind` is the kind of these runs, and `number` the index of the shard. The result is -1 if the file is missing,
        has changed or is not readable.
        """
        path = self.folder / kind / _name(number)
        expected = self.hashes.get(f"{kind}/{_name(number)}")
        if not path.is_file() or (expected and _digest(path) != expected):
            return -1
        with suppress(OSError, arrow().ArrowException):
            return int(arrow().parquet.read_metadata(path).num_rows)
        return -1

    def write(self, files: Mapping[str, bytes]) -> None:
        """Write files with results of some runs into the folder, in the given order.

        `files` maps the relative path of each file to its content. These results count as complete if the last file
        exists.
        """
        for name, content in files.items():
            path = self.folder / name
            make_folder(path.parent)
            write_whole(path, lambda stream, content=content: stream.write(content))  # type: ignore[misc]

    def shards(self, kind: str, columns: list[str] | None = None) -> Iterator[dict[str, NDArray[Any]]]:
        """Yield the results as columns by name, one file after the other in the order of the runs.

        `kind` is a subfolder, for example `runs`, `tornado` or `indices`. `columns` contains the names of the columns
        to read. If it is None, all columns are read.
        """
        for path in sorted((self.folder / kind).glob("part-*.parquet")):
            table = table_in(path, columns)
            yield {name: table[name].to_numpy() for name in table.column_names}

    def columns(
        self, kind: str, columns: list[str] | None = None, max_rows: int | None = None
    ) -> dict[str, NDArray[Any]]:
        """Return results of all runs, or of the first `max_rows` runs, as columns by name.

        `kind` is the kind of runs: `runs`, `tornado` or `indices`. `columns` contains the names of the columns to read.
        If it is None, all columns are read. The result is empty if there are no runs of this kind.
        """
        parts: list[dict[str, NDArray[Any]]] = []
        count = 0
        for shard in self.shards(kind, columns):
            parts.append(shard)
            count += len(next(iter(shard.values())))
            if max_rows is not None and count >= max_rows:
                break
        return {name: np.concatenate([part[name] for part in parts])[:max_rows] for name in (parts[0] if parts else ())}


def _name(number: int) -> str:
    return f"part-{number:05d}.parquet"


def _read_manifest(path: Path, content: Mapping[str, Any]) -> dict[str, Any]:
    """Read the manifest of a folder, and check that it belongs to this ensemble.

    The manifest is a file that describes the stored results. `content` is the expected manifest. An error is raised if
    the ensemble or the software versions differ.
    """
    try:
        with open_input(path) as stream:
            stored = json.loads(stream.read())
        stored_plan = stored["poppet ensemble"]
    except (OSError, ValueError, KeyError, TypeError):
        raise InputError("ensemble.folder_taken", path=str(path.parent)) from None
    if stored.get("sha256") != content["sha256"]:
        expected = content["poppet ensemble"]
        differs = [key for key in expected if key not in _NOT_OF_RUNS and stored_plan.get(key) != expected[key]]
        title = stored_plan.get("circuit", {}).get("title", "") if isinstance(stored_plan, dict) else ""
        raise InputError("ensemble.other_dataset", path=str(path.parent), differs=differs, title=title)
    if stored.get("versions") != content["versions"]:
        old, new = stored.get("versions", {}), content["versions"]
        changed = {name: f"{old.get(name, '-')} -> {new[name]}" for name in new if old.get(name) != new[name]}
        raise InputError("ensemble.other_versions", path=str(path.parent), changed=changed)
    return dict(stored)


def _text(content: Mapping[str, Any]) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
