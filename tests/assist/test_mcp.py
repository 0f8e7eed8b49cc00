"""`poppet mcp` with the client of the official SDK, and with raw frames that no client sends."""

from __future__ import annotations

import asyncio
import base64
import json
import random
import subprocess
import sys
import time

import pytest

pytest.importorskip("mcp", reason="the SDK of the Model Context Protocol is not installed")

from assistant_client import ToolError, caller, connected, environment
from poppet.assist.functions import FUNCTIONS
from poppet.assist.limits import LINE

SLOW = {"file": "tank.toml", "duration": "1e8 s", "output_step": "1e6 s", "set": {"run.maximum_step": "1 ms"}}
"""Arguments of a simulation that takes far longer than the tests."""


def test_a_client_uses_tools_and_resources(folder):
    async def use() -> None:
        async with connected(folder) as client:
            await check_tools(client)
            await check_resources(client)
            await check_errors(caller(client), folder)

    asyncio.run(use())


async def check_tools(client) -> None:
    """The tools are the functions; a result is structured, the same as text, and an image."""
    tools = {tool.name: tool for tool in (await client.list_tools()).tools}
    assert list(tools) == list(FUNCTIONS)
    for name, tool in tools.items():
        assert tool.input_schema == FUNCTIONS[name].schema
        assert tool.annotations.read_only_hint is not FUNCTIONS[name].writes
    reply = await client.call_tool("simulate", {"file": "tank.toml", "figure": "png", "rows": 5})
    text, image = reply.content
    assert json.loads(text.text) == reply.structured_content
    assert len(reply.structured_content["series"]["tank.pressure"]["values"]) == 5
    assert image.mime_type == "image/png"
    assert base64.b64decode(image.data)[:8] == b"\x89PNG\r\n\x1a\n"
    assert "base64" not in text.text


async def check_resources(client) -> None:
    """The resources contain all kinds; no other resource, such as a file, can be read."""
    for resource in (await client.list_resources()).resources:
        (content,) = (await client.read_resource(resource.uri)).contents
        assert "`proportional_valve`" in content.text
    with pytest.raises(Exception, match="poppet://reference"):
        await client.read_resource("file:///etc/passwd")


async def check_errors(call, folder) -> None:
    """Errors are results with code, address and hint."""
    with pytest.raises(ToolError) as caught:
        await call("check", text=(folder / "tank.toml").read_text().replace("volume", "volum"))
    (row,) = caught.value.errors
    assert (row["code"], row["address"]) == ("fields.unknown", "parts.tank.volum")
    assert row["hint"] == "Did you mean volume?"
    for name in ("../secret.toml", "/etc/passwd"):
        with pytest.raises(ToolError) as caught:
            await call("read_file", name=name)
        assert caught.value.errors[0]["code"] == "assist.file_name"


def test_a_cancelled_call_ends_and_the_server_stays_responsive(folder):
    async def use() -> None:
        async with connected(folder) as client:
            call = caller(client)
            slow = [asyncio.create_task(call("simulate", **SLOW)) for _ in range(3)]
            await asyncio.sleep(1.0)
            begin = time.monotonic()
            assert "reservoir" in (await call("list_kinds"))["kinds"]  # although two calls run and one waits
            assert time.monotonic() - begin < 10.0
            for task in slow:
                task.cancel()
            await asyncio.gather(*slow, return_exceptions=True)
            assert (await call("check", file="tank.toml"))["is_valid"]

    asyncio.run(use())


def frame(number: int, method: str, **parameters) -> bytes:
    return json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": parameters}).encode()


HELLO = frame(
    0, "initialize", protocolVersion="2025-06-18", capabilities={}, clientInfo={"name": "test", "version": "1"}
)
LAST = frame(9999, "tools/call", name="list_kinds", arguments={})
READY = b'{"jsonrpc": "2.0", "method": "notifications/initialized"}'


def exchange(folder, frames: list[bytes]) -> list[dict]:
    """Send frames to a server, wait for the reply to the last one, and return all lines of its output."""
    process = subprocess.Popen(
        [sys.executable, "-m", "poppet", "mcp", str(folder)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, env=environment(),
    )  # fmt: skip
    process.stdin.write(b"\n".join([HELLO, READY, *frames]) + b"\n" + LAST + b"\n")
    process.stdin.flush()
    replies = []
    while line := process.stdout.readline():
        replies.append(json.loads(line))  # nothing but the protocol is written
        if replies[-1].get("id") == 9999:
            break
    process.stdin.close()
    process.stdout.close()
    assert process.wait(30) == 0
    assert "reservoir" in replies[-1]["result"]["structuredContent"]["kinds"]
    return replies


def test_frames_that_are_no_json_are_rejected(folder):
    invalid = [b"{", b"\xff\xfe\x00", b"x" * 10_000_000, b'"' + b"a" * (LINE + 10) + b'"', b"[" * 50_000, b"[1]", b"7"]
    replies = exchange(folder, invalid)
    assert sum(reply.get("error", {}).get("code") == -32700 for reply in replies) == len(invalid)


def test_random_frames_do_no_harm(folder):
    chance = random.Random(8)
    words = [None, True, -1, 1.5, "", "tools/call", "tank.toml", [], {}, {"name": "check"}, 10**30]
    keys = ["jsonrpc", "id", "method", "params", "result", "error"]

    def content() -> bytes:
        if chance.random() < 0.3:
            return bytes(chance.randrange(1, 256) for _ in range(30)).replace(b"\n", b" ")
        message = {key: chance.choice(words) for key in chance.sample(keys, chance.randint(0, 4))}
        return json.dumps(message | ({"jsonrpc": "2.0"} if chance.random() < 0.5 else {})).encode()

    def call(number: int) -> bytes:
        arguments = {chance.choice(["file", "text", "set", "x"]): chance.choice(words) for _ in range(2)}
        return frame(number, "tools/call", name=chance.choice([*FUNCTIONS, "", "x"]), arguments=arguments)

    exchange(folder, [content() if chance.random() < 0.7 else call(100 + k) for k in range(300)])


def test_without_the_sdk_the_command_says_how_to_install_it(poppet_without_mcp):
    done = poppet_without_mcp
    assert done.returncode == 2
    assert "poppet[mcp]" in done.stderr.decode()
    assert done.stdout == b""


@pytest.fixture
def poppet_without_mcp(folder):
    program = "import sys; sys.modules['mcp'] = None; from poppet.cli.main import run; sys.exit(run(['mcp']))"
    return subprocess.run(
        [sys.executable, "-c", program], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, env=environment(),
        check=False, timeout=60,
    )  # fmt: skip
