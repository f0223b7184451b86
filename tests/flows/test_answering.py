"""A flow server of the user's that says nothing is told at once; Prefect would wait for minutes."""

from __future__ import annotations

from http.server import BaseHTTPRequestHandler, HTTPServer
import socket
import threading

import pytest

from esg.outcomes import UserError
from flows import embedded


def test_a_silent_server_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(embedded, "ANSWER_S", 0.2)
    with socket.create_server(("127.0.0.1", 0)) as server:
        url = f"http://127.0.0.1:{server.getsockname()[1]}/api"
        monkeypatch.setenv("PREFECT_API_URL", url)
        with embedded.prefect_api() as api, pytest.raises(UserError, match="no answer") as told:
            api.wait()
    assert url in str(told.value) and told.value.exit_code == 1


def test_no_server_and_no_address_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    for url in ("http://127.0.0.1:9/api", "here"):
        monkeypatch.setenv("PREFECT_API_URL", url)
        with embedded.prefect_api() as api, pytest.raises(UserError, match="no answer"):
            api.wait()


def test_a_server_that_refuses_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    """It wants a key; whether that is right, Prefect will tell."""

    class Refusing(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_error(401)

    with HTTPServer(("127.0.0.1", 0), Refusing) as server:
        thread = threading.Thread(target=server.handle_request)
        thread.start()
        monkeypatch.setenv("PREFECT_API_URL", f"http://127.0.0.1:{server.server_port}/api")
        with embedded.prefect_api() as api:
            api.wait()
        thread.join()
