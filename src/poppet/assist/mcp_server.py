"""The functions as tools of the Model Context Protocol, over standard input and output."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS, Function
from poppet.assist.limits import LINE
from poppet.assist.line_reader import Pipe
from poppet.assist.replies import Json
from poppet.assist.workers import Workers, is_error
from poppet.core.errors import needed
from poppet.core.version import __version__

if TYPE_CHECKING:
    import mcp_types as types
    from mcp.server import Server

INSTRUCTIONS = (
    "Simulation of pneumatic circuits in TOML files. Read the resource poppet://reference, or call list_kinds and "
    "describe_kind, before you write a circuit: names of kinds, fields and outputs must be exact. Call check after "
    "each change; it reports all errors with hints. Values have units, such as '6 bar g'; results state their units."
)
"""Text that a client shows to its assistant."""
RESOURCES = {
    "poppet://guide": ("llms.txt", "How to write and run circuits: tables of a circuit file, example, functions"),
    "poppet://reference": ("llms-full.txt", "All kinds of parts: fields, units, defaults, inputs, outputs; signals"),
}
"""Files of this package and descriptions of the resources."""
NO_JSON = {"jsonrpc": "2.0", "id": None, "error": {"code": -32700, "message": "Parse error"}}
"""Reply to a line that is no JSON, as JSON-RPC defines it."""


async def serve_mcp(folder: Folder, time_limit: float) -> None:
    """Serve the functions until the client closes the standard input."""
    with needed("mcp", "The Model Context Protocol", "mcp"):
        from mcp.server.stdio import stdio_server
    workers = Workers(folder, time_limit)
    server, pipe = make_server(workers), Pipe()
    pipe.start()
    try:
        await workers.prepare()
        streams: Any = PipeReader(pipe), PipeWriter(pipe)
        async with stdio_server(*streams) as (read_stream, write_stream):
            await server.run(read_stream, write_stream, server.create_initialization_options())
    finally:
        await workers.close()


def make_server(workers: Workers) -> Server[Any]:
    """Return a server with the functions as tools."""
    import mcp_types as types
    from mcp.server import Server

    async def list_tools(_context: Any, _params: Any) -> types.ListToolsResult:
        return types.ListToolsResult(tools=[_tool(name, function) for name, function in FUNCTIONS.items()])

    async def call_tool(_context: Any, params: types.CallToolRequestParams) -> types.CallToolResult:
        return tool_result(await workers.call(params.name, params.arguments))

    async def list_resources(_context: Any, _params: Any) -> types.ListResourcesResult:
        return types.ListResourcesResult(
            resources=[
                types.Resource(uri=uri, name=name, description=description, mime_type="text/markdown")
                for uri, (name, description) in RESOURCES.items()
            ]
        )

    async def read_resource(_context: Any, params: types.ReadResourceRequestParams) -> types.ReadResourceResult:
        from mcp import MCPError

        uri = str(params.uri)
        if uri not in RESOURCES:
            raise MCPError(types.INVALID_PARAMS, f"{uri[:100]} is not a resource. Use {' or '.join(RESOURCES)}.")
        text = Path(__file__).with_name(RESOURCES[uri][0]).read_text(encoding="utf-8")
        content = types.TextResourceContents(uri=uri, text=text, mime_type="text/markdown")
        return types.ReadResourceResult(contents=[content])

    return Server(
        "poppet",
        version=__version__,
        instructions=INSTRUCTIONS,
        on_list_tools=list_tools,
        on_call_tool=call_tool,
        on_list_resources=list_resources,
        on_read_resource=read_resource,
    )


def _tool(name: str, function: Function) -> types.Tool:
    import mcp_types as types

    annotations = types.ToolAnnotations(
        read_only_hint=not function.writes, destructive_hint=function.writes, open_world_hint=False
    )
    return types.Tool(name=name, description=function.summary, input_schema=function.schema, annotations=annotations)


def tool_result(reply: Json) -> types.CallToolResult:
    """Return a reply as the result of a tool: structured, the same as text, and a figure as an image."""
    import mcp_types as types

    if is_error(reply):
        text = types.TextContent(text=json.dumps(reply))
        return types.CallToolResult(content=[text], structured_content=reply, is_error=True)
    result = dict(reply["result"])
    content: list[Any] = []
    if figure := result.pop("figure", None):
        content.append(types.ImageContent(data=figure["base64"], mime_type=figure["media_type"]))
        result["figure"] = {"media_type": figure["media_type"]}
    content.insert(0, types.TextContent(text=json.dumps(result)))
    return types.CallToolResult(content=content, structured_content=result)


class PipeReader:
    """Standard input of the server: lines that are JSON; others are answered here."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe

    async def __aiter__(self) -> AsyncIterator[str]:
        async for line in self._pipe.lines():
            try:
                text = line.decode("utf-8")
                if len(line) > LINE or not isinstance(json.loads(text), dict):
                    raise ValueError(text[:100])
            except (ValueError, RecursionError):
                if line.strip():
                    self._pipe.write(json.dumps(NO_JSON))
                continue
            yield text


class PipeWriter:
    """Standard output of the server."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe

    async def write(self, text: str) -> None:
        # In a thread: a client that does not read must not stop the server.
        await asyncio.to_thread(self._pipe.write, text.rstrip("\n"))

    async def flush(self) -> None:
        pass
