"""Serving one page on this machine only."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
import shutil
import threading
from typing import Any
import urllib.parse

from esg.outcomes import UserError
from esg.strangers.folders import file_in

HOST = "127.0.0.1"


class _Handler(BaseHTTPRequestHandler):
    """The page at `/`, and below `/files/` the scene folder, read only."""

    def __init__(self, *args: Any, page: bytes, folder: Path, **kwargs: Any) -> None:
        self._page, self._folder = page, folder
        super().__init__(*args, **kwargs)

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
            self._send_file(urllib.parse.unquote(self.path.removeprefix("/files/")))
        else:
            self.send_error(404)

    def _send_file(self, relative: str) -> None:
        """A file of the folder, to be kept and not to be shown: its maker may be anybody."""
        path = file_in(self._folder, relative)
        try:
            file = None if path is None else path.open("rb")
        except OSError:
            file = None
        if path is None or file is None:
            self.send_error(404)
            return
        with file:
            name = urllib.parse.quote(path.name)
            self.send_response(200)
            self.send_header("Content-Type", "application/octet-stream")
            self.send_header("Content-Length", str(path.stat().st_size))
            self.send_header("Content-Disposition", f"attachment; filename*=UTF-8''{name}")
            self.end_headers()
            shutil.copyfileobj(file, self.wfile)

    def end_headers(self) -> None:
        """Every answer is what it says it is, and shown, if at all, as if from nowhere."""
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Frame-Options", "DENY")
        if self.path not in ("/", "/index.html"):  # the page brings a stricter policy of its own
            self.send_header("Content-Security-Policy", "default-src 'none'; sandbox")
        super().end_headers()

    def do_HEAD(self) -> None:
        self.send_error(405)

    def _local(self) -> bool:
        """Whether the request names this machine: another name is a rebound address."""
        name = (self.headers.get("Host") or "").rsplit(":", 1)[0]
        if name in (HOST, "localhost"):
            return True
        self.send_error(421)
        return False

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
