"""Serving one page on this machine only."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
import threading
from typing import Any

from esg.outcomes import UserError

HOST = "127.0.0.1"


class _Handler(SimpleHTTPRequestHandler):
    """The page at `/`, and below `/files/` the scene folder, read only."""

    def __init__(self, *args: Any, page: bytes, folder: Path, **kwargs: Any) -> None:
        self._page = page
        super().__init__(*args, directory=str(folder), **kwargs)

    def do_GET(self) -> None:
        if not self._local():
            return
        if self.path in ("/", "/index.html"):
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(self._page)))
            self.send_header("Cache-Control", "no-store")
            self.end_headers()
            self.wfile.write(self._page)
        elif self.path.startswith("/files/"):
            self.path = self.path.removeprefix("/files")
            super().do_GET()
        else:
            self.send_error(404)

    def do_HEAD(self) -> None:
        self.send_error(405)

    def _local(self) -> bool:
        """Whether the request names this machine: another name is a rebound address."""
        name = (self.headers.get("Host") or "").rsplit(":", 1)[0]
        if name in (HOST, "localhost"):
            return True
        self.send_error(421)
        return False

    def list_directory(self, path: Any) -> None:
        self.send_error(404)

    def log_message(self, format: str, *args: Any) -> None:
        """Requests are nobody's news."""


def serve(
    page: bytes,
    folder: Path,
    port: int,
    ready: Callable[[str], None],
    *,
    seconds: float | None = None,
) -> None:
    """Serves a page and the files of a folder until interrupted.

    Args:
        page: The HTML.
        folder: Its downloads.
        port: 0 takes a free one.
        ready: Called with the address once it answers.
        seconds: Stop by itself after so long.

    Raises:
        UserError: If the port is taken or forbidden.
    """
    handler = partial(_Handler, page=page, folder=folder)
    try:
        server = ThreadingHTTPServer((HOST, port), handler)
    except OSError as error:
        raise UserError(f"--port {port}: {error.strerror}; choose another, or 0") from None
    server.daemon_threads = True
    with server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            ready(f"http://{HOST}:{server.server_port}/")
            thread.join(seconds)
        finally:
            server.shutdown()
