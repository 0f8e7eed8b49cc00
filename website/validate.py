"""Measure claims of the validation page: `python website/validate.py [NAME ...]`, by default all.

The file `validation_results.toml` stores the results with date and version. A claim whose data or package are absent
keeps its last results. The script needs the extra `dev`.

Figures are kept with date and version in `validation_results.toml`. A claim whose data or package are not here keeps
its last figures. Needs the extra `dev`.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import json
import subprocess
import sys
import time
import tomllib
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import poppet
from claims import CLAIMS, ROOT, SOURCES, Claim

KEPT = Path(__file__).with_name("validation_results.toml")


def measured(claim: Claim) -> dict[str, Any]:
    """Return the results of a claim with date and version."""
    begin = time.perf_counter()
    figures = {name: _plain(value) for name, value in claim.measure().items()}
    package = SOURCES[claim.source].package
    return {
        "date": datetime.now(UTC).date().isoformat(),
        "version": poppet.__version__,
        "commit": COMMIT,
        **({"package": importlib.metadata.version(package)} if package else {}),
        "seconds": round(time.perf_counter() - begin, 1),
        "figures": figures,
    }


def _plain(value: Any) -> Any:
    """Return a value with the digits for the file."""
    return value if isinstance(value, (str, int)) else float(f"{float(value):.6g}")


def _commit() -> str:
    """Return the commit under test, empty if unknown."""
    command = ["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip()


COMMIT = _commit()
"""Commit at the start, because a commit can be added during a long run."""


def kept() -> dict[str, dict[str, Any]]:
    """Return the stored results by claim."""
    return tomllib.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}


def keep(results: dict[str, dict[str, Any]]) -> None:
    """Write all results in the order of the claims."""
    lines = ["# Written by validate.py; do not edit."]
    for name in CLAIMS:
        if name in results:
            lines += ["", f"[{name}]"]
            for key, value in results[name].items():
                if key == "figures":
                    fields = ", ".join(f"{k} = {_toml(v)}" for k, v in value.items())
                    lines.append(f"figures = {{ {fields} }}")
                else:
                    lines.append(f"{key} = {_toml(value)}")
    KEPT.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _toml(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def main() -> int:
    """Measure the selected claims and print the results."""
    parser = argparse.ArgumentParser(description="Measure claims of the validation page.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"one of {', '.join(CLAIMS)}; default: all")
    names = parser.parse_args().names or list(CLAIMS)
    if unknown := [name for name in names if name not in CLAIMS]:
        parser.error(f"unknown claim: {', '.join(unknown)}")
    for name in names:
        claim = CLAIMS[name]
        if not SOURCES[claim.source].is_here:
            last = kept().get(name, {}).get("date", "never")
            print(f"{name}: {SOURCES[claim.source].name} is not available; last measured: {last}", flush=True)
            continue
        result = measured(claim)
        keep(kept() | {name: result})
        verdict = "holds" if claim.holds(result["figures"]) else "DOES NOT HOLD"
        print(f"{name}: {claim.ours.format(**result['figures'])}; {verdict} ({result['seconds']} s)", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
