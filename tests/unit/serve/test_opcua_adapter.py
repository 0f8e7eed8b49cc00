"""OPC UA adapter of `poppet serve`: options, certificates, users, and the notes of a run."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("asyncua", reason="the extra opcua is not installed")

from asyncua import ua
from asyncua.crypto.security_policies import SecurityPolicyBasic256Sha256
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.hazmat.primitives.serialization import Encoding

import poppet
from poppet.core.errors import InputError
from poppet.serve.adapters import AdapterSettings
from poppet.serve.machine import Machine
from poppet.serve.opcua import OpcAdapter, make_adapter, read_url
from serve_opcua import certificate_of, client_of, key_bytes, new_key, write_pair

CIRCUIT = Path(__file__).parents[3] / "examples" / "serve" / "two_cylinders_machine.toml"
URI = "urn:test:served"


@pytest.fixture(scope="module")
def machine() -> Iterator[Machine]:
    with poppet.load(CIRCUIT).serve(clock=False) as running:
        running.advance(0.1)
        yield running


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("opcua")
    certificate, key = write_pair(folder, "server", uri=URI)
    users = folder / "users.toml"
    users.write_text('plc = "first secret"\nscada = "second"\n')
    users.chmod(0o600)
    return {"certificate": certificate, "key": key, "users": users}


def made(machine: Machine, value: str, notes: list[Any] | None = None, **files: Path | None) -> OpcAdapter:
    options = argparse.Namespace(
        **{f"opcua_{name}": None if path is None else str(path) for name, path in files.items()}
    )
    return make_adapter(AdapterSettings(value, machine.served, options, ([] if notes is None else notes).append))


def error_of(machine: Machine, value: str = "4840", **files: Path | None) -> list[tuple[str, str | None]]:
    with pytest.raises(InputError) as caught:
        made(machine, value, **files)
    assert "secret" not in str(caught.value)
    return [(problem.code, problem.address) for problem in caught.value.problems]


@pytest.mark.parametrize(
    "text", ["opc.tcp://127.0.0.1:4840", "opc.tcp://127.0.0.1:4840/", "4840", "127.0.0.1", " :4840"]
)
def test_urls(text: str) -> None:
    assert str(read_url(text)) == "127.0.0.1:4840"


@pytest.mark.parametrize(
    "text", ["http://127.0.0.1:4840", "opc.tcp://user:word@127.0.0.1", "opc.tcp://host/path", "a:b"]
)
def test_invalid_urls(text: str) -> None:
    with pytest.raises(InputError) as caught:
        read_url(text)
    assert (caught.value.code, caught.value.address) == ("serve.address", "--opcua")


def test_other_addresses_require_a_certificate_and_users(machine: Machine, files: dict[str, Path]) -> None:
    pair = {name: files[name] for name in ("certificate", "key")}
    assert error_of(machine, "0.0.0.0:4840") == [("opcua.unprotected", "--opcua")]
    assert error_of(machine, "0.0.0.0:4840", **pair) == [("opcua.unprotected", "--opcua")]
    notes: list[Any] = []
    made(machine, "0.0.0.0:4840", notes, **files)
    assert [note.code for note in notes] == ["serve.open_address"]


def test_invalid_files(machine: Machine, files: dict[str, Path], tmp_path: Path) -> None:
    certificate, key, users = files["certificate"], files["key"], files["users"]
    assert error_of(machine, certificate=certificate) == [("opcua.half_certificate", "--opcua-certificate")]
    assert error_of(machine, key=key) == [("opcua.half_certificate", "--opcua-key")]
    assert error_of(machine, users=users) == [("opcua.plain_passwords", "--opcua-users")]
    assert error_of(machine, certificate=key, key=certificate) == [
        ("opcua.certificate", "--opcua-certificate"), ("opcua.key", "--opcua-key"),
    ]  # fmt: skip
    other, other_key = write_pair(tmp_path, "other")
    assert error_of(machine, certificate=certificate, key=other_key) == [("opcua.other_key", "--opcua-key")]
    expired, expired_key = write_pair(tmp_path, "expired", first=-3, last=-1)
    assert error_of(machine, certificate=expired, key=expired_key) == [("opcua.expired", "--opcua-certificate")]
    curve = tmp_path / "curve.key"
    curve.write_bytes(key_bytes(ec.generate_private_key(ec.SECP256R1())))
    assert error_of(machine, certificate=other, key=curve) == [("opcua.key", "--opcua-key")]
    missing = tmp_path / "missing.pem"
    assert error_of(machine, certificate=missing, key=key) == [("serve.unreadable", "--opcua-certificate")]
    for text, code in (("", "toml.empty"), ("# nothing\n", "serve.no_secrets"), ('a = ""\nb = 3\n', "serve.secret")):
        (tmp_path / "users.toml").write_text(text)
        problems = error_of(machine, certificate=certificate, key=key, users=tmp_path / "users.toml")
        assert {found for found, _ in problems} == {code}


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX systems")
def test_files_that_others_can_read_cause_a_warning(machine: Machine, files: dict[str, Path]) -> None:
    files["users"].chmod(0o644)
    try:
        notes: list[Any] = []
        made(machine, "4840", notes, **files)
    finally:
        files["users"].chmod(0o600)
    assert [(note.code, note.address) for note in notes] == [("serve.readable_secret", "--opcua-users")]


def test_encryption_and_users(machine: Machine, files: dict[str, Path], tmp_path: Path) -> None:
    adapter = made(machine, "127.0.0.1:0", **files)
    notes: list[Any] = []
    key = new_key()
    own = tmp_path / "client.der", tmp_path / "client.pem"
    own[0].write_bytes(certificate_of(key, "urn:freeopcua:client").public_bytes(Encoding.DER))
    own[1].write_bytes(key_bytes(key))

    async def connect(url: str, user: str | None, password: str | None, *, is_encrypted: bool = True) -> None:
        client = client_of(url)
        client.application_uri = "urn:freeopcua:client"
        if is_encrypted:
            policy = SecurityPolicyBasic256Sha256
            await client.set_security(policy, str(own[0]), str(own[1]), server_certificate=str(files["certificate"]))
        if user is not None:
            client.set_user(user)
            client.set_password(password)
        async with client:
            node = client.get_node("ns=2;s=valveA.command")
            await node.write_value(1.0)
            assert await node.read_value() == machine.snapshot()["valveA.command"] == 1.0
            await node.write_value(0.0)

    async def run() -> None:
        task = asyncio.create_task(adapter.run(machine, notes.append))
        while not notes:
            assert not task.done(), task
            await asyncio.sleep(0.01)
        url = notes[0].facts["server"]
        endpoints = await client_of(url).connect_and_get_server_endpoints()
        assert [endpoint.SecurityMode for endpoint in endpoints] == [ua.MessageSecurityMode.SignAndEncrypt]
        assert {policy.TokenType for policy in endpoints[0].UserIdentityTokens} == {ua.UserTokenType.UserName}
        assert endpoints[0].Server.ApplicationUri == URI
        await connect(url, "plc", "first secret")
        await connect(url, "scada", "second")
        for user, password in (("plc", "second"), ("plc", ""), ("nobody", "second"), ("", ""), (None, None)):
            with pytest.raises((ua.UaError, TimeoutError, ConnectionError)):
                await connect(url, user, password)
        with pytest.raises((ua.UaError, TimeoutError, ConnectionError)):
            await connect(url, "plc", "first secret", is_encrypted=False)
        task.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await task

    asyncio.run(run())
    assert [note.code for note in notes] == ["opcua.listening"]
    (summary,) = adapter.summary()
    facts = summary.facts
    assert (facts["sessions"], facts["written"], facts["rejected"]) == (2, 4, None)
    assert facts["refused"] >= 3
