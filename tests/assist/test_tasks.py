"""Written tasks, solved by a scripted client through the tools of `poppet mcp` alone."""

from __future__ import annotations

import asyncio
import tomllib
from pathlib import Path

import pytest

pytest.importorskip("mcp", reason="the SDK of the Model Context Protocol is not installed")

from assistant_client import Call, caller, connected
from assistant_solutions import SOLUTIONS

TASKS = tomllib.loads(Path(__file__).with_name("tasks.toml").read_text(encoding="utf-8"))["task"]


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    """Answers of the client by task, or the error of its solution; one server solves all tasks."""

    async def solve_all() -> dict[str, float | Exception]:
        async with connected(tmp_path_factory.mktemp("tasks")) as client:
            call = caller(client)
            return {name: await solve(SOLUTIONS[name], call) for name in SOLUTIONS}

    async def solve(solution, call: Call) -> float | Exception:
        try:
            return await solution(call)
        except Exception as error:
            return error

    return asyncio.run(solve_all())


def test_every_task_has_a_solution():
    assert [task["id"] for task in TASKS if task["id"] not in SOLUTIONS] == []
    assert len(TASKS) == len(SOLUTIONS) >= 30


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task["id"])
def test_a_task_is_solved(task, answers):
    answer = answers[task["id"]]
    if isinstance(answer, Exception):
        raise answer
    assert answer == pytest.approx(task["answer"], rel=task["tolerance"], abs=0.0)
