"""The functions as lines of JSON: one request a line, one reply a line."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS
from poppet.assist.limits import LINE
from poppet.assist.line_reader import Pipe
from poppet.assist.replies import Json
from poppet.assist.workers import Workers, error_reply

KEYS = ("id", "call", "arguments", "cancel")
Identifier = str | int | None


async def serve_lines(folder: Folder, time_limit: float) -> None:
    """Reply to the requests of the standard input, in their order, until it ends.

    A request is `{"call": "simulate", "arguments": {...}, "id": 1}`; `id` is optional. `{"call": "functions"}` lists
    the functions with the JSON schemas of their arguments. `{"cancel": 1}` ends the call with this `id`.
    """
    pipe, workers = Pipe(), Workers(folder, time_limit)
    pipe.start()
    waiting: asyncio.Queue[tuple[Identifier, asyncio.Task[Json]] | None] = asyncio.Queue(32)
    running: dict[Identifier, asyncio.Task[Json]] = {}
    order = asyncio.Lock()

    async def answer(request: Json) -> Json:
        async with order:
            if request["call"] == "functions":
                return {"result": function_list()}
            return await workers.call(request["call"], request.get("arguments"))

    async def write_replies() -> None:
        while (item := await waiting.get()) is not None:
            identifier, task = item
            try:
                reply = await task
            except asyncio.CancelledError:
                reply = error_reply("assist.cancelled")
            running.pop(identifier, None)
            write(pipe, identifier, reply)

    writer = asyncio.create_task(write_replies())
    try:
        await workers.prepare()
        async for line in pipe.lines():
            if not line.strip():
                continue
            request, errors = read_request(line)
            identifier = request.get("id")
            if errors is None and "cancel" in request:
                task = running.get(request["cancel"])
                write(pipe, identifier, {"result": {"is_cancelled": task is not None and task.cancel()}})
                continue
            task = asyncio.create_task(_ready(errors) if errors is not None else answer(request))
            if identifier is not None:
                running[identifier] = task
            await waiting.put((identifier, task))
            # A flood of requests must not prevent their replies.
            await asyncio.sleep(0)
        await waiting.put(None)
        await writer
    finally:
        writer.cancel()
        await workers.close()


def read_request(line: bytes) -> tuple[Json, Json | None]:
    """Return the request of a line, and a reply with errors if it is invalid."""
    if len(line) > LINE:
        return {}, error_reply("assist.long_line", most=LINE // 2**20)
    try:
        request = json.loads(line.decode("utf-8"))
    except (ValueError, RecursionError):
        return {}, error_reply("assist.no_json")
    if not isinstance(request, dict) or ("call" in request) == ("cancel" in request):
        return {}, error_reply("assist.no_request")
    identifier = request.get("id")
    if not _is_identifier(identifier) or not _is_identifier(request.get("cancel")):
        return {}, error_reply("assist.no_identifier", "id")
    unknown = [key for key in request if key not in KEYS]
    errors = error_reply("assist.unknown_key", unknown[0][:100], keys=KEYS) if unknown else None
    return {**request, "id": identifier}, errors


def _is_identifier(value: Any) -> bool:
    return value is None or (isinstance(value, str | int) and not isinstance(value, bool) and len(str(value)) <= 100)


def write(pipe: Pipe, identifier: Identifier, reply: Json) -> None:
    """Write a reply with the identifier of its request."""
    pipe.write(json.dumps(reply if identifier is None else {"id": identifier, **reply}, allow_nan=False))


def function_list() -> list[Json]:
    """Return the functions with their summaries and the JSON schemas of their arguments."""
    return [
        {"name": name, "summary": function.summary, "arguments": function.schema}
        for name, function in FUNCTIONS.items()
    ]


async def _ready(reply: Json) -> Json:
    return reply
