"""Processes of calls: errors of the program, failed starts, the number of waiting calls."""

from __future__ import annotations

import asyncio
import dataclasses
import os

import pytest

from poppet.assist import files, functions, simulation, workers
from poppet.assist.folder import Folder
from poppet.assist.limits import WAITING
from poppet.assist.workers import Workers
from poppet.engine import solve
from poppet.engine.problem import Outcome


def called(folder, name, arguments=None) -> dict:
    async def call() -> dict:
        pool = Workers(Folder.of(folder))
        try:
            return await pool.call(name, arguments)
        finally:
            await pool.close()

    return asyncio.run(call())


def test_an_error_of_the_program_does_not_end_the_server(folder, monkeypatch, capsys):
    def fail(folder: Folder) -> dict:
        raise RuntimeError("an error of the program")

    monkeypatch.setitem(functions.FUNCTIONS, "list_files", functions.Function(fail, is_quick=True))
    (row,) = called(folder, "list_files")["errors"]
    assert (row["code"], "list_files" in row["message"]) == ("assist.process_ended", True)
    assert "an error of the program" in capsys.readouterr().err


def test_an_unreadable_file_is_an_error(folder, monkeypatch):
    def refuse(path):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("poppet.assist.folder.open_input", refuse)
    (row,) = called(folder, "read_file", {"name": "tank.toml"})["errors"]
    assert (row["code"], row["message"]) == ("files.unreadable", "file tank.toml cannot be read: Permission denied.")


def test_too_many_waiting_calls_are_rejected(folder, monkeypatch):
    async def call_all() -> list[dict]:
        pool = Workers(Folder.of(folder))
        started = asyncio.Event()

        async def wait(*_) -> dict:
            await started.wait()
            return {"result": {}}

        monkeypatch.setattr(pool, "_in_process", wait)
        calls = [asyncio.create_task(pool.call("check", {"file": "tank.toml"})) for _ in range(WAITING + 3)]
        await asyncio.sleep(0.1)
        started.set()
        return await asyncio.gather(*calls)

    replies = asyncio.run(call_all())
    assert [reply["errors"][0]["code"] for reply in replies if "errors" in reply] == ["assist.many_calls"] * 3


@pytest.mark.skipif(os.name != "posix", reason="processes are listed by the system")
def test_a_process_is_used_again_and_its_folder_is_deleted(folder, monkeypatch):
    monkeypatch.setattr(workers, "CALLS_PER_PROCESS", 2)

    async def call_three_times() -> list:
        pool = Workers(Folder.of(folder))
        seen = []
        for _ in range(3):
            reply = await pool.call("check", {"file": "tank.toml"})
            assert reply["result"]["is_valid"]
            seen.append([worker.folder for worker in pool._idle])
        await pool.close()
        return seen

    first, second, third = asyncio.run(call_three_times())
    assert len(first) == 1
    assert second == []  # after two calls, the process is replaced
    assert len(third) == 1
    assert not any(path.exists() for path in (*first, *third))


def test_a_list_of_a_large_folder_ends(folder, monkeypatch):
    monkeypatch.setattr("poppet.assist.folder.VISITED", 50)
    for name in ("a", "b"):
        (folder / name).mkdir()
        for k in range(40):
            (folder / name / f"{k}.csv").write_text("t\n0\n")
    listed = files.list_files(Folder.of(folder))
    assert listed["has_more"]
    assert len(listed["files"]) < 60


def test_a_run_that_another_solver_continues_returns_its_part(folder, monkeypatch):
    run_kernel, request = solve.run_kernel, {"file": "tank.toml", "times": [9.0]}
    complete = simulation.simulate(Folder.of(folder), **request)
    monkeypatch.setattr(
        solve, "run_kernel", lambda problem, _: dataclasses.replace(run_kernel(problem), outcome=Outcome.STALLED)
    )

    def end(time: float) -> None:
        if time > 10.0:
            raise KeyboardInterrupt

    monkeypatch.setattr(simulation, "stop_after", lambda deadline: end)
    result = simulation.simulate(Folder.of(folder), **request)
    assert result["is_stopped"]
    assert 9.0 < result["duration"]["value"] < 20.0
    pressures = [run["values_at"]["tank.pressure"]["values"] for run in (result, complete)]
    assert pressures[0] == pytest.approx(pressures[1], rel=1e-5)
    assert {"assist.stopped", "run.handed_over"} <= {note["code"] for note in result["notes"]}
