"""The kernel as WebAssembly: what the linker makes of an object, and that a browser's engine computes the same."""

from __future__ import annotations

import llvmlite.binding as llvm
import numpy as np
import pytest

from circuits_of_exports import TEN
from javascript import needs_node, unfused
from poppet.deploy.live.in_node import run_in_node
from poppet.deploy.live.linker import LinkError, Module, link
from poppet.deploy.live.module import live_module, wasm_object
from poppet.engine.call import Call

SMALL = """
@table = internal constant [2 x double] [double 2.0, double 5.0]
@place = internal global ptr getelementptr (i8, ptr @table, i32 8)
declare double @sin(double)
define double @second() {
  %at = load volatile ptr, ptr @place
  %value = load double, ptr %at
  ret double %value
}
define double @wave(i32 %k) {
  %at = getelementptr double, ptr @table, i32 %k
  %value = load double, ptr %at
  %result = call double @sin(double %value)
  ret double %result
}
"""
# What the libraries of both give differs in last digits, which grow in a run that switches.
OF_LIBRARIES = {"energy wall": 1e-10, "cylinder": np.inf, "muscle joint": np.inf}


def small(text: str = SMALL, **given) -> Module:
    return link(wasm_object(llvm.parse_assembly(text)), ("second", "wave"), ("wave",), **{"stack": 100, **given})


def sections(code: bytes) -> list[int]:
    at, found = 8, []
    while at < len(code):
        found.append(code[at])
        at += 1
        size = shift = 0
        while True:
            byte = code[at]
            at += 1
            size |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                break
        at += size
    assert at == len(code)
    return found


def test_a_module_owns_what_an_object_asks_for():
    module = small()
    assert module.code.startswith(b"\0asm\1\0\0\0")
    # Types, imports, functions, table, memory, globals, exports, elements, code and data, in this order.
    kinds = [kind for kind in sections(module.code) if kind != 12]
    assert kinds == [1, 2, 3, 4, 5, 6, 7, 9, 10, 11]
    assert module.imports == ("sin",)
    assert module.table == {"wave": 1}
    assert module.heap % 16 == 0
    assert module.heap >= 112 + 16 + 4


@needs_node
def test_addresses_of_data_are_moved_behind_the_stack(tmp_path):
    import subprocess

    (tmp_path / "m.wasm").write_bytes(small().code)
    script = f"""
    const bytes = require("fs").readFileSync({str(tmp_path / "m.wasm")!r});
    WebAssembly.instantiate(bytes, {{ env: {{ sin: x => x + 100 }} }}).then(({{ instance: {{ exports: e }} }}) =>
      console.log(e.second(), e.wave(0), e.wave(1), e.memory.buffer.byteLength));
    """
    told = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=True)
    assert told.stdout.split() == ["5", "102", "105", "65536"]


def test_what_the_linker_does_not_know_it_refuses():
    text = SMALL.replace("load volatile ptr, ptr @place", "load volatile ptr, ptr @elsewhere")
    with pytest.raises(LinkError):
        small("@elsewhere = external global double\n" + text)
    with pytest.raises(LinkError):
        link(b"\0asm\2\0\0\0", (), (), stack=0)


def test_the_module_of_the_paper_is_small():
    module = live_module(TEN["staircase"]().model)
    assert len(module.code) < 40_000
    assert set(module.imports) <= {"sin", "cos", "pow"}
    assert set(module.table) == {"jacobian", "step", "dense", "outputs"}


@needs_node
@pytest.mark.parametrize("name", TEN)
def test_a_browser_computes_the_same_bits(name, tmp_path, monkeypatch):
    circuit = TEN[name]()
    expected = unfused(circuit, monkeypatch, tmp_path)
    allowed = OF_LIBRARIES.get(name, 0.0)
    ended, table = run_in_node(expected.problem, tmp_path)
    assert ended["status"] == "done"
    if allowed < np.inf:
        assert [ended["accepted"], ended["attempts"], ended["rows"]] == expected.counts[:3].tolist()
        size = np.max(np.abs(expected.table), axis=1, keepdims=True)
        assert np.all(np.abs(table - expected.table) <= allowed * size)
    else:
        assert np.all(np.isfinite(table))


@needs_node
@pytest.mark.parametrize("name", ["two tanks", "energy wall", "helium", "check and relief"])
def test_of_the_kernel_of_this_machine_it_differs_by_rounding(name, tmp_path):
    circuit = TEN[name]()
    own = Call(circuit.problem(circuit.run))
    own.again()
    ended, table = run_in_node(own.problem, tmp_path)
    assert [ended["accepted"], ended["attempts"]] == own.counts[:2].tolist()
    size = np.max(np.abs(own.table), axis=1, keepdims=True)
    assert np.all(np.abs(table - own.table) <= 1e-10 * size)
