"""Watch of a served circuit: selection of samples, faults that raise alarms, and twin files of other circuits."""

from __future__ import annotations

import asyncio
import shutil
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poppet
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.monitoring.baseline import read_baseline
from poppet.monitoring.samples import Sample
from poppet.monitoring.twin_file import read_twin_file
from poppet.monitoring.verdicts import VerdictKind, WatchVerdict
from poppet.monitoring.watch import watch_of_twin
from poppet.serve import served_watch
from poppet.serve.points import ServedCircuit
from poppet.serve.served_watch import SampleSelection, ServedWatch, WatchResult, evaluate

EXAMPLES = Path(__file__).parents[3] / "examples"
TANK, TWIN = EXAMPLES / "serve" / "watched_tank.toml", EXAMPLES / "watch" / "twin.toml"


def rows_with(inputs: list[float]) -> np.ndarray:
    """Rows with the time [periods] and one input."""
    return np.column_stack([np.arange(len(inputs), dtype=float), inputs])


def times(samples: list[np.ndarray]) -> list[int]:
    return [int(row[0]) for row in samples]


def test_changes_of_held_inputs_are_samples_with_the_row_before() -> None:
    inputs = [0.0] * 13 + [1.0] * 7 + [2.0] * 11
    rows = rows_with(inputs)
    assert times(SampleSelection(10, np.array([1])).select(0, rows)) == [0, 10, 12, 13, 19, 20, 30]
    # The result does not depend on the pieces in which the rows arrive.
    selection = SampleSelection(10, np.array([1]))
    pieces = [selection.select(k, rows[k : k + 1]) for k in range(len(rows))]
    assert times(list(chain.from_iterable(pieces))) == [0, 10, 12, 13, 19, 20, 30]


def test_an_input_that_always_changes_adds_one_change_per_sample() -> None:
    rows = rows_with([float(k) for k in range(31)])
    assert times(SampleSelection(10, np.array([1])).select(0, rows)) == [0, 1, 9, 10, 11, 19, 20, 21, 29, 30]
    assert times(SampleSelection(10, np.array([], dtype=int)).select(0, rows)) == [0, 10, 20, 30]


def test_a_fault_of_the_machine_raises_its_alarm() -> None:
    machine = poppet.load(TANK).serve("10 ms", clock=False)
    twin = read_twin_file(TWIN)
    watch = watch_of_twin(twin, read_baseline(twin.baseline, twin.plan))
    readings = (*twin.plan.channels, *twin.plan.inputs)
    columns = np.array([machine.row_names.index(item.address) for item in readings])
    random, noise = np.random.default_rng(served_watch.SEED), twin.plan.channels[0].noise
    selection = SampleSelection(10, columns[1:])

    def after(duration: float, first: int) -> tuple[WatchResult, int]:
        machine.advance(duration)
        first, rows = machine.rows(first)
        samples = []
        for row in selection.select(first, rows):
            values = row[columns]
            values[0] += noise * random.standard_normal()
            samples.append(Sample(float(row[0]), values.tolist()))
        return evaluate(watch, samples), first + len(rows)

    result, index = after(41.0, 0)
    assert (result.alarm, result.events) == ("", ())
    machine.set_fault("drain", "leak")
    result, index = after(15.0, index)
    assert "leak" in result.alarm.split(" or ")
    assert [event.partition(" s: ")[2].partition(".")[0] for event in result.events][-1] == f"alarm {result.alarm}"
    # 5 % of 0.4 dm^3/(s bar), from the circuit file.
    assert result.faults["leak"][2] == pytest.approx(0.02e-8, rel=0.4)


def test_starts_and_ends_of_alarms_are_events() -> None:
    class Watch:
        """Watch whose alarms are given by the times of the samples."""

        def __init__(self) -> None:
            self.alarm_text, self.faults = "", dict[str, Any]()
            self.verdict = WatchVerdict(VerdictKind.HEALTHY, (), Note("said", text="Verdict."))

        def process(self, sample: Sample, problems: list[Any]) -> bool:
            self.alarm_text = {1.0: "leak", 2.0: "leak", 3.0: "leak or stuck"}.get(sample.time, "")
            return True

    watch: Any = Watch()
    result = evaluate(watch, [Sample(float(k), []) for k in range(6)])
    assert result.events == (
        "1.0 s: alarm leak. Verdict.", "3.0 s: alarm leak or stuck. Verdict.", "4.0 s: the alarm has ended.",
    )  # fmt: skip


def test_a_twin_file_of_another_circuit_is_rejected(tmp_path: Path) -> None:
    other = poppet.loads(
        TANK.read_text(encoding="utf-8")
        .replace("tank", "vessel")
        .replace("[parts.use]", "[parts.uses]")
        .replace('"use.', '"uses.')
    )
    with pytest.raises(InputError) as caught:
        ServedWatch.of(str(TWIN), ServedCircuit.of(other))
    assert [(problem.code, problem.address) for problem in caught.value.problems] == [
        ("serve.watch_address", "tank.pressure"), ("serve.watch_address", "use.opening"),
    ]  # fmt: skip


def test_an_output_in_another_unit_is_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    circuit = poppet.load(TANK)
    served = ServedCircuit.of(circuit)
    units = dict(zip(served.columns, served.column_units, strict=True)) | {"tank.pressure": "m"}
    monkeypatch.setattr(ServedCircuit, "column_units", tuple(units.values()))
    with pytest.raises(InputError) as caught:
        ServedWatch.of(str(TWIN), ServedCircuit.of(circuit))
    assert [problem.code for problem in caught.value.problems] == ["serve.watch_unit"]


def test_rows_that_are_overwritten_are_reported() -> None:
    machine = poppet.load(TANK).serve("10 ms", clock=False)
    machine.advance(200.0)
    watch = ServedWatch.of(str(TWIN), machine.served)

    async def run() -> None:
        task = asyncio.create_task(watch.run(machine))
        while watch.result is None:
            await asyncio.sleep(0.05)
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)

    asyncio.run(run())
    first = machine.rows(0)[0]
    assert first > 0
    assert watch.omitted == first // 10
    assert watch.events[0][1].startswith("The watch is slower than the machine")


def test_the_noise_is_that_of_the_twin_file(monkeypatch: pytest.MonkeyPatch) -> None:
    machine = poppet.load(TANK).serve("10 ms", clock=False)
    machine.advance(100.0)
    watch, samples = ServedWatch.of(str(TWIN), machine.served), list[Sample]()

    class Pool:
        """Executor that keeps the samples."""

        def __init__(self, *_: Any, **__: Any) -> None: ...

        def submit(self, function: Any, batch: list[Sample]) -> Any:
            from concurrent.futures import Future

            samples.extend(batch)
            future: Future[WatchResult] = Future()
            future.set_result(WatchResult(0.0, "", "", "", {}, ()))
            return future

        def shutdown(self, **_: Any) -> None: ...

    monkeypatch.setattr(served_watch, "ProcessPoolExecutor", Pool)

    async def run() -> None:
        task = asyncio.create_task(watch.run(machine))
        while len(samples) < 1000:
            await asyncio.sleep(0.01)
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)

    asyncio.run(run())
    _, rows = machine.rows(0)
    column = machine.row_names.index("tank.pressure")
    deviations = [sample.values[0] - rows[round(sample.time / 0.01), column] for sample in samples]
    noise = watch.twin.plan.channels[0].noise
    assert noise == pytest.approx(400.0)
    assert np.std(deviations) == pytest.approx(noise, rel=0.1)
    assert abs(np.mean(deviations)) < 4.0 * noise / len(deviations) ** 0.5


def test_a_missing_baseline_is_reported(tmp_path: Path) -> None:
    for name in ("twin.toml", "tank.toml"):
        shutil.copy(TWIN.with_name(name), tmp_path)
    with pytest.raises(InputError, match=r"healthy\.toml"):
        ServedWatch.of(str(tmp_path / "twin.toml"), ServedCircuit.of(poppet.load(TANK)))


def test_a_failed_watch_is_reported_and_the_machine_runs_on(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("websockets", reason="the extra serve is not installed")
    from poppet.serve.adapters import HostPort
    from poppet.serve.live_server import LiveServer
    from poppet.serve.live_session import LiveSession

    async def fail(machine: Any) -> None:
        raise ChildProcessError("it was ended")

    machine, notes = poppet.load(TANK).serve("10 ms", clock=False), list[Any]()
    watch = ServedWatch.of(str(TWIN), machine.served)
    monkeypatch.setattr(watch, "run", fail)
    server = LiveServer(HostPort("127.0.0.1", 0), "", "token", watch)

    async def run() -> None:
        task = asyncio.create_task(server.run(machine, notes.append))
        while len(notes) < 2:
            await asyncio.sleep(0.01)
        assert not task.done()
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)

    asyncio.run(run())
    assert [note.code for note in notes] == ["serve.page", "serve.watch_failed"]
    session: Any = LiveSession(machine, None, server.statistics, "", watch)  # type: ignore[arg-type]
    assert "every 0.1 s" in session._hello()["watch"]["note"]
    (message,) = session._watch_messages()
    assert "it was ended" in message["watch"]["verdict"]
    assert session._watch_messages() == []
