"""Public circuit class: types that `mypy --strict` reports, and class of variants."""

from __future__ import annotations

import pickle
import re
from dataclasses import replace
from pathlib import Path

import pytest

import poppet
from poppet import Chamber, Circuit, Orifice

SCRIPT = """
import poppet
from poppet import Chamber, Circuit, Orifice

circuit = Circuit({"tank": Chamber(volume="1 l"), "vent": Orifice(from_="tank", to="ambient", effective_area="1 mm^2")})
reveal_type(circuit)
reveal_type(poppet.load("circuit.toml"))
reveal_type(poppet.loads("text"))
reveal_type(circuit.with_values({"tank.volume": "2 l"}))
reveal_type(circuit.simulate("1 s"))
reveal_type(circuit.resumed(circuit.simulate("1 s")))
reveal_type(circuit.steady_state())
reveal_type(circuit.linearise())
reveal_type(circuit.linearise().to_control())
reveal_type(circuit.ensemble(runs=10))
reveal_type(circuit.to_ode("1 s"))
reveal_type(circuit.to_casadi())
reveal_type(circuit.to_control())
reveal_type(circuit.to_control(linear=True))
reveal_type(circuit.to_control(linear=True).poles())
"""
EXPECTED = (
    *("Circuit", "Circuit", "Circuit", "Circuit", "Recording", "Circuit", "SteadyState", "LinearModel"),
    *("ControlStateSpace", "Ensemble", "Ode", "CasadiModel", "ControlSystem", "ControlStateSpace", "ndarray"),
)


def test_strict_mypy_accepts_a_script_without_any(
    tmp_path: Path, pytestconfig: pytest.Config, monkeypatch: pytest.MonkeyPatch
):
    api = pytest.importorskip("mypy.api")
    script = tmp_path / "script.py"
    script.write_text(SCRIPT, encoding="utf-8")
    source = pytestconfig.rootpath / "src"
    monkeypatch.setenv("MYPYPATH", str(source))
    cache = pytestconfig.cache.mkdir("mypy") if pytestconfig.cache else tmp_path / "cache"
    # An empty configuration: the exceptions of this project do not apply to the scripts of users.
    (tmp_path / "mypy.ini").write_text("[mypy]\n[mypy-poppet.*]\nfollow_imports=silent\n", encoding="utf-8")
    options = ["--strict", "--config-file", str(tmp_path / "mypy.ini"), "--cache-dir", str(cache)]
    text, errors, _ = api.run([*options, str(script)])
    assert "error" not in text + errors, text + errors
    revealed = re.findall(r'Revealed type is "(.*)"', text)
    names = [re.split(r"\[", kind, maxsplit=1)[0].rpartition(".")[2] for kind in revealed]
    assert names == [*EXPECTED]


def test_variants_keep_the_public_class(tmp_path: Path):
    circuit = Circuit(
        {
            "tank": Chamber(volume="1 l", initial_pressure="2 bar"),
            "vent": Orifice(from_="tank", to="ambient", effective_area="1 mm^2"),
        }
    )
    variants = [
        circuit.with_values({"tank.volume": "2 l"}),
        circuit.resumed(circuit.simulate("0.1 s")),
        replace(circuit, title="variant"),
        pickle.loads(pickle.dumps(circuit)),
        poppet.load(Path("examples") / "fill_staircase.toml"),
    ]
    assert {type(variant) for variant in variants} == {Circuit}


def test_editors_list_the_names_for_users():
    assert "simulate" in dir(Circuit)
    assert [name for name in dir(Circuit) if name.startswith("_")] == []


def test_a_pickled_recording_keeps_its_notes_and_balances():
    recording = poppet.load(Path("examples") / "fill_staircase.toml").simulate("1 s")
    copy = pickle.loads(pickle.dumps(recording))
    assert copy.remarks == recording.remarks
    assert copy.residuals == recording.residuals
    assert [balance.is_kept for balance in copy.residuals] == [True, True]
