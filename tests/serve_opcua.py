"""OPC UA server in a thread, and certificates, for tests."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from asyncua import Client
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import rsa
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from poppet.serve.adapters import HostPort
from poppet.serve.opcua_server import OpcServer


@contextlib.contextmanager
def serving(machine: Any, *arguments: Any) -> Iterator[OpcServer]:
    """Run a server in a thread of its own."""
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()
    server = OpcServer(machine, *arguments)
    try:
        asyncio.run_coroutine_threadsafe(server.start(HostPort("127.0.0.1", 0)), loop).result(60)
        yield server
    finally:
        asyncio.run_coroutine_threadsafe(server.stop(), loop).result(60)
        loop.call_soon_threadsafe(loop.stop)
        thread.join(10)
        loop.close()


def client_of(url: str) -> Client:
    """Return a client that keeps its connection if a busy computer answers late."""
    return Client(url, timeout=60.0, watchdog_intervall=60.0)


def url_of(server: OpcServer) -> str:
    """Return the URL for clients."""
    return f"opc.tcp://127.0.0.1:{server.port}"


def new_key() -> rsa.RSAPrivateKey:
    """Return a private key."""
    return rsa.generate_private_key(public_exponent=65537, key_size=2048)


def certificate_of(key: rsa.RSAPrivateKey, uri: str = "urn:test:client", first: int = -1, last: int = 1) -> Any:
    """Return a certificate that is valid between two days, counted from now."""
    name = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "test")])
    now = datetime.now(UTC)
    names = [x509.UniformResourceIdentifier(uri), x509.DNSName("localhost")]
    uses = x509.KeyUsage(True, True, True, True, False, False, False, False, False)
    purposes = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.CLIENT_AUTH, ExtendedKeyUsageOID.SERVER_AUTH])
    builder = (
        x509.CertificateBuilder()
        .subject_name(name).issuer_name(name).public_key(key.public_key()).serial_number(x509.random_serial_number())
        .not_valid_before(now + timedelta(days=first)).not_valid_after(now + timedelta(days=last))
        .add_extension(x509.SubjectAlternativeName(names), critical=False)
        .add_extension(uses, critical=False).add_extension(purposes, critical=False)
    )  # fmt: skip
    return builder.sign(key, hashes.SHA256())


def write_pair(folder: Path, name: str, **more: Any) -> tuple[Path, Path]:
    """Write a certificate and its key, and return their paths."""
    key = new_key()
    certificate_file, key_file = folder / f"{name}.pem", folder / f"{name}.key"
    certificate_file.write_bytes(certificate_of(key, **more).public_bytes(serialization.Encoding.PEM))
    key_file.write_bytes(key_bytes(key))
    key_file.chmod(0o600)
    return certificate_file, key_file


def key_bytes(key: Any) -> bytes:
    """Return a key in PEM form."""
    form, plain = serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    return bytes(key.private_bytes(serialization.Encoding.PEM, form, plain))
