"""Measure the claims of the validation page anew: `python website/validate.py [NAME ...]`, without names all of them.

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
    """What a run of a claim found, when, and by which version."""
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
    """A figure with the digits that a file keeps."""
    return value if isinstance(value, (str, int)) else float(f"{float(value):.6g}")


def _commit() -> str:
    """The commit that was run, or nothing."""
    command = ["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip()


COMMIT = _commit()
"""Before anything runs: a long run outlives it."""


def kept() -> dict[str, dict[str, Any]]:
    """Results by name of the claim."""
    return tomllib.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}


def keep(results: dict[str, dict[str, Any]]) -> None:
    """Write all results, in the order of the claims."""
    lines = ["# Written by validate.py; not by hand."]
    for name in CLAIMS:
        if name in results:
            lines += ["", f"[{name}]"]
            for key, value in results[name].items():
                if key == "figures":
                    inside = ", ".join(f"{k} = {_toml(v)}" for k, v in value.items())
                    lines.append(f"figures = {{ {inside} }}")
                else:
                    lines.append(f"{key} = {_toml(value)}")
    KEPT.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _toml(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def main() -> int:
    """Measure what is asked for, and print it."""
    parser = argparse.ArgumentParser(description="Measure the claims of the validation page anew.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"one of {', '.join(CLAIMS)}; without names all")
    names = parser.parse_args().names or list(CLAIMS)
    if unknown := [name for name in names if name not in CLAIMS]:
        parser.error(f"no claim is called {', '.join(unknown)}")
    for name in names:
        claim = CLAIMS[name]
        if not SOURCES[claim.source].is_here:
            last = kept().get(name, {}).get("date", "never")
            print(f"{name}: {SOURCES[claim.source].name} is not here; last measured: {last}", flush=True)
            continue
        found = measured(claim)
        keep(kept() | {name: found})
        verdict = "holds" if claim.holds(found["figures"]) else "DOES NOT HOLD"
        print(f"{name}: {claim.ours.format(**found['figures'])}; {verdict} ({found['seconds']} s)", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
