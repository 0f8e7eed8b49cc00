"""OPC UA adapter of `poppet serve`: checks of its options, certificates and users."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, needed
from poppet.serve.adapters import AdapterSettings, HostPort, open_address_notes, read_host_port
from poppet.serve.machine import Machine
from poppet.serve.secrets_file import read_bytes, read_secret_bytes, read_secrets

if TYPE_CHECKING:
    from poppet.serve.opcua_server import OpcServer

OPTION = "--opcua"
DEFAULT_PORT = 4840
SCHEME = "opc.tcp://"
_PURPOSE = "an OPC UA server"


@dataclass(frozen=True)
class OpcSecurity:
    """Protection of a server: certificate, private key and users.

    Without a certificate, connections are neither signed nor encrypted. Without users, clients are anonymous.
    """

    passwords: Mapping[str, str]
    certificate: Any = None
    key: Any = None
    application_uri: str | None = None  # in the certificate


class OpcAdapter:
    """OPC UA server of `poppet serve`."""

    def __init__(self, address: HostPort, security: OpcSecurity) -> None:
        self.address, self.security = address, security
        self.server: OpcServer | None = None

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        """Serve a machine until the task is cancelled."""
        from poppet.serve.opcua_server import APPLICATION_URI, OpcServer

        security = self.security
        uri = security.application_uri or APPLICATION_URI
        self.server = server = OpcServer(machine, security.passwords, security.certificate, security.key, uri)
        try:
            await server.start(self.address)
            report(Note(
                "opcua.listening", OPTION, server=f"{SCHEME}{HostPort(self.address.host, server.port)}",
                nodes=len(server.attributes.values.variables), users=len(security.passwords) or None,
                is_anonymous=not security.passwords, is_plain=security.certificate is None,
                is_encrypted=security.certificate is not None,
            ))  # fmt: skip
            await server.wait()
        finally:
            await server.stop()

    def summary(self) -> Sequence[Note]:
        """Return a note on sessions and requests."""
        server = self.server
        if server is None or server.port == 0:
            return ()
        return (Note(
            "opcua.summary", OPTION, sessions=server.users.n_sessions, written=server.attributes.n_written,
            rejected=server.attributes.n_rejected or None,
            refused=server.users.n_refused or None, excess=server.n_rejected or None,
        ),)  # fmt: skip


def make_adapter(settings: AdapterSettings) -> OpcAdapter:
    """Return the adapter for the value of the option `--opcua`."""
    with needed("asyncua", _PURPOSE, "opcua"):
        import asyncua  # noqa: F401
    address = read_url(str(settings.value))
    security = read_security(settings)
    if not address.is_local and not (security.certificate and security.passwords):
        raise InputError("opcua.unprotected", OPTION, host=address.host)
    for note in open_address_notes(address, OPTION):
        settings.report(note)
    return OpcAdapter(address, security)


def read_url(text: str) -> HostPort:
    """Return host and port of a URL such as `opc.tcp://127.0.0.1:4840`; the scheme can be omitted."""
    return read_host_port(text.strip().removeprefix(SCHEME).removesuffix("/"), OPTION, DEFAULT_PORT)


def read_security(settings: AdapterSettings) -> OpcSecurity:
    """Return the protection that the options select."""
    options = settings.options
    certificate_file, key_file, users_file = (
        getattr(options, f"opcua_{name}", None) for name in ("certificate", "key", "users")
    )
    certificate = key = None
    passwords: Mapping[str, str] = {}
    with ErrorCollector() as errors:
        if (certificate_file is None) != (key_file is None):
            missing = "--opcua-key" if key_file is None else "--opcua-certificate"
            errors.add("opcua.half_certificate", "--opcua-certificate" if key_file is None else "--opcua-key",
                       missing=missing)  # fmt: skip
        if users_file is not None:
            with errors.collecting():
                passwords = read_secrets(users_file, "--opcua-users", settings.report)
            if certificate_file is None:
                errors.add("opcua.plain_passwords", "--opcua-users")
        if certificate_file is not None:
            with errors.collecting():
                certificate = _certificate(certificate_file)
        if key_file is not None:
            with errors.collecting():
                key = _key(read_secret_bytes(key_file, "--opcua-key", settings.report), key_file)
        if certificate is not None and key is not None and certificate.public_key() != key.public_key():
            errors.add("opcua.other_key", "--opcua-key", key=key_file, certificate=certificate_file)
    return OpcSecurity(passwords, certificate, key, None if certificate is None else _application_uri(certificate))


def _certificate(path: str) -> Any:
    """Return a certificate in PEM or DER form that is valid today."""
    from cryptography import x509

    content = read_bytes(path, "--opcua-certificate")
    read = x509.load_pem_x509_certificate if content.startswith(b"-----") else x509.load_der_x509_certificate
    try:
        certificate = read(content)
    except ValueError:
        raise InputError("opcua.certificate", "--opcua-certificate", path=path) from None
    first, last = certificate.not_valid_before_utc, certificate.not_valid_after_utc
    if not first <= datetime.now(UTC) <= last:
        raise InputError("opcua.expired", "--opcua-certificate", path=path, first=f"{first:%F}", last=f"{last:%F}")
    return certificate


def _key(content: bytes, path: str) -> Any:
    """Return an RSA key in PEM or DER form without a password."""
    from cryptography.hazmat.primitives import serialization
    from cryptography.hazmat.primitives.asymmetric.rsa import RSAPrivateKey

    is_pem = content.startswith(b"-----")
    read = serialization.load_pem_private_key if is_pem else serialization.load_der_private_key
    try:
        key = read(content, password=None)
    except (ValueError, TypeError):
        key = None
    if not isinstance(key, RSAPrivateKey):
        raise InputError("opcua.key", "--opcua-key", path=path)
    return key


def _application_uri(certificate: Any) -> str | None:
    """Return the URI in a certificate, with which clients compare that of the server."""
    from cryptography import x509

    try:
        names = certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except x509.ExtensionNotFound:
        return None
    return next(iter(names.get_values_for_type(x509.UniformResourceIdentifier)), None)
