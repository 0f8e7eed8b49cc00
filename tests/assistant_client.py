"""Client of `poppet mcp` for the tests: the server is a process, its tools are all that the client uses."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

Call = Callable[..., Awaitable[dict[str, Any]]]
SOURCES = str(Path(__file__).parents[1] / "src")


class ToolError(Exception):
    """Errors of a call, as the server has returned them."""

    def __init__(self, errors: list[dict[str, Any]]) -> None:
        super().__init__("; ".join(f"{row['code']} {row['address']}: {row['message']} {row['hint']}" for row in errors))
        self.errors = errors


@asynccontextmanager
async def connected(folder: Path, *options: str) -> AsyncIterator[Any]:
    """Yield a client of the official SDK, connected to a server of a folder over standard input and output."""
    from mcp import Client, StdioServerParameters, stdio_client

    server = StdioServerParameters(
        command=sys.executable, args=["-m", "poppet", "mcp", str(folder), *options], env=environment()
    )
    async with Client(stdio_client(server)) as client:
        yield client


def caller(client: Any) -> Call:
    """Return a function that calls a tool, and returns its structured result."""

    async def call(name: str, /, **arguments: Any) -> dict[str, Any]:
        result = await client.call_tool(name, arguments)
        if result.is_error:
            raise ToolError(result.structured_content["errors"])
        return result.structured_content

    return call


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": SOURCES}


def lines(folder: Path, requests: Iterable[Any], *options: str, timeout: float = 60.0) -> list[dict[str, Any]]:
    """Send requests to `poppet mcp --lines`, objects or bytes, and return its replies."""
    data = b"\n".join(r if isinstance(r, bytes) else json.dumps(r).encode() for r in requests) + b"\n"
    done = subprocess.run(
        [sys.executable, "-m", "poppet", "mcp", str(folder), "--lines", *options],
        input=data, capture_output=True, timeout=timeout, env=environment(), check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr.decode()
    return [json.loads(line) for line in done.stdout.splitlines()]


def codes(reply: dict[str, Any]) -> list[str]:
    return [row["code"] for row in reply["errors"]]
