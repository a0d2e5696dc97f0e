"""A server of the page, for this machine alone."""

from __future__ import annotations

import gzip
import os
import re
import sys
from functools import lru_cache
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from carom.studio.built import page_files

HOST = "127.0.0.1"
SCENARIO = "/scenario"
"""The address that leads on to the page with the scenario in its link, where that is too long to hand over."""

TYPES = {
    "html": "text/html; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "css": "text/css; charset=utf-8",
    "wasm": "application/wasm",
    "svg": "image/svg+xml",
    "png": "image/png",
    "json": "application/json",
    "txt": "text/plain; charset=utf-8",
    "woff2": "font/woff2",
}
HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-cache",
}
NOTHING = "default-src 'none'; frame-ancestors 'none'"
POLICY = re.compile(r'http-equiv="Content-Security-Policy"\s+content="([^"]*)"')


class Server(ThreadingHTTPServer):
    """Serves the page on a port of the loopback address: its files, which it reads once, and nothing else.

    Parameters
    ----------
    port : int
        The port; 0 for any free one.
    fragment : str
        What follows the page's address in the link that opens it; empty for the page as it begins.

    Raises
    ------
    MissingPageError
        When this installation has no page.
    OSError
        When the port is taken.
    """

    daemon_threads = True
    allow_reuse_address = os.name == "posix"  # elsewhere that would share a port that is taken

    def __init__(self, port: int = 0, fragment: str = "") -> None:
        files = {f"/{name}": path.read_bytes() for name, path in page_files().items()}
        self.files = {"/": files["/index.html"], **files}
        said = POLICY.search(files["/index.html"].decode("utf-8"))
        self.policy = f"{said[1]}; frame-ancestors 'none'" if said else NOTHING
        self.fragment = fragment
        super().__init__((HOST, port), _Handler)

    def handle_error(self, *_: object) -> None:
        """Say nothing of a client that went away."""
        if not isinstance(sys.exc_info()[1], (ConnectionError, TimeoutError)):
            super().handle_error(*_)  # type: ignore[arg-type]

    @property
    def address(self) -> str:
        """The address of the page."""
        return f"http://{HOST}:{self.server_port}/"

    @property
    def hosts(self) -> tuple[str, str]:
        """The names that this server answers to; a name of elsewhere that leads here is none of them."""
        return f"{HOST}:{self.server_port}", f"localhost:{self.server_port}"


class _Handler(BaseHTTPRequestHandler):
    """Answers GET and HEAD."""

    server: Server
    protocol_version = "HTTP/1.1"
    server_version = "carom"
    sys_version = ""
    timeout = 60

    def do_GET(self) -> None:
        """Send a file."""
        self._answer()

    def do_HEAD(self) -> None:
        """Send what stands at the head of a file."""
        self._answer()

    def _answer(self) -> None:
        if self.headers.get("Host", "").lower() not in self.server.hosts:
            return self._send(HTTPStatus.FORBIDDEN, "txt", b"This server answers to its own address only.\n")
        path = self.path.partition("?")[0]
        if path == SCENARIO and self.server.fragment:
            return self._send(HTTPStatus.SEE_OTHER, "txt", b"", {"Location": f"/{self.server.fragment}"})
        # A path is looked up as it was sent, and no file is opened for it.
        content = self.server.files.get(path)
        if content is None:
            return self._send(HTTPStatus.NOT_FOUND, "txt", b"There is no such file.\n")
        ending = "html" if path == "/" else path.rpartition(".")[2]
        headers = {"Vary": "Accept-Encoding"}
        if "gzip" in _encodings(self.headers.get("Accept-Encoding", "")):
            headers["Content-Encoding"] = "gzip"
            content = _packed(content)
        return self._send(HTTPStatus.OK, ending, content, headers)

    def _send(self, status: HTTPStatus, ending: str, content: bytes, more: dict[str, str] | None = None) -> None:
        self.send_response(status)
        # The worker gets its policy from here, too: it has no page that says it.
        policy = self.server.policy if status == HTTPStatus.OK else NOTHING
        said = {"Content-Type": TYPES.get(ending, "application/octet-stream"), "Content-Length": str(len(content))}
        for name, value in {**said, "Content-Security-Policy": policy, **HEADERS, **(more or {})}.items():
            self.send_header(name, value)
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(content)

    def log_message(self, *_: object) -> None:
        """Say nothing of what was asked for."""


def _encodings(accepted: str) -> set[str]:
    """Read what a client takes.

    Examples
    --------
    >>> sorted(_encodings("gzip, br;q=0.5, zstd;q=0"))
    ['br', 'gzip']
    """
    words = [word.replace(" ", "").lower().partition(";q=") for word in accepted.split(",")]
    return {name for name, _, quality in words if not re.fullmatch(r"0(\.0*)?", quality)}


@lru_cache(maxsize=64)
def _packed(content: bytes) -> bytes:
    return gzip.compress(content, 6, mtime=0)
