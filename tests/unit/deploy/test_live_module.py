"""Tests of the WebAssembly kernel: linker, and comparison with the native kernel."""

from __future__ import annotations

from dataclasses import replace

import llvmlite.binding as llvm
import numpy as np
import pytest

from circuits_of_exports import TEN
from javascript import needs_node, unfused, with_functions_of_this_machine
from poppet.deploy.live.linker import LinkError, Module, link
from poppet.deploy.live.page_kernel import compile_wasm_object, live_module, run_in_node
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
SENSITIVE = ("staircase", "regulator", "switched", "cylinder", "muscle joint")


def small(text: str = SMALL, **given) -> Module:
    return link(
        compile_wasm_object(llvm.parse_assembly(text)), ("second", "wave"), ("wave",), **{"stack": 100, **given}
    )


def sections(code: bytes) -> list[int]:
    offset, kinds = 8, []
    while offset < len(code):
        kinds.append(code[offset])
        offset += 1
        size = shift = 0
        while True:
            byte = code[offset]
            offset += 1
            size |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                break
        offset += size
    assert offset == len(code)
    return kinds


def test_a_module_defines_the_imports_of_the_object():
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
def test_data_follows_the_stack(tmp_path):
    import subprocess

    (tmp_path / "m.wasm").write_bytes(small().code)
    script = f"""
    const bytes = require("fs").readFileSync({str(tmp_path / "m.wasm")!r});
    WebAssembly.instantiate(bytes, {{ env: {{ sin: x => x + 100 }} }}).then(({{ instance: {{ exports: e }} }}) =>
      console.log(e.second(), e.wave(0), e.wave(1), e.memory.buffer.byteLength));
    """
    output = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=True)
    assert output.stdout.split() == ["5", "102", "105", "65536"]


def test_unsupported_objects_are_refused():
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
def test_wasm_kernel_gives_the_same_bits(name, tmp_path, monkeypatch):
    circuit = TEN[name]()
    expected = unfused(circuit, monkeypatch, tmp_path)
    ended, table = with_functions_of_this_machine(expected.problem, tmp_path, monkeypatch)
    assert ended["status"] == "done"
    assert [ended["accepted"], ended["attempts"], ended["rows"]] == expected.counts[:3].tolist()
    assert np.array_equal(table, expected.table)


def difference(circuit, table, reference) -> np.ndarray:
    """Return the maximum difference in each row, relative to the maximum of each output that is no code."""
    numbers = np.array([not name.endswith("regime") for name, _ in circuit.model.outputs])
    size = np.max(np.abs(reference), axis=1, keepdims=True)
    return np.max(np.abs(table - reference)[numbers] / np.where(size > 0.0, size, 1.0)[numbers], axis=0)


@needs_node
@pytest.mark.parametrize("name", [name for name in TEN if name not in SENSITIVE])
def test_wasm_differs_from_the_native_kernel_by_rounding(name, tmp_path):
    circuit = TEN[name]()
    reference = Call(circuit.problem(circuit.run))
    reference.repeat()
    ended, table = run_in_node(reference.problem, tmp_path)
    assert [ended["accepted"], ended["attempts"]] == reference.counts[:2].tolist()
    assert np.max(difference(circuit, table, reference.table)) <= 1e-10


@needs_node
@pytest.mark.parametrize("name", SENSITIVE)
def test_larger_differences_have_the_size_of_the_effect_of_rounding(name, tmp_path):
    circuit = TEN[name]()
    problem = circuit.problem(circuit.run)
    reference = Call(problem)
    reference.repeat()
    _, table = run_in_node(problem, tmp_path)
    page, effects = difference(circuit, table, reference.table), np.zeros(problem.grid.size)
    for share in (1.0 + 1e-14, 1.0 - 1e-14):
        changed_run = Call(replace(problem, x0=share * problem.x0, coefficients=share * problem.coefficients))
        changed_run.repeat()
        effects = np.maximum(effects, difference(circuit, changed_run.table, reference.table))
    print(f"{name}: page {page.max():.1e}, moved {effects.max():.1e}")
    assert 1e-10 < page.max() < 10.0 * effects.max()
    # Until they part, they are the same.
    assert np.all(page[: np.argmax(effects > 1e-11)] < 1e-10)
