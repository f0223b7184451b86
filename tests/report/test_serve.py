"""`esg view`: only this machine, only the page and its files."""

from __future__ import annotations

from collections.abc import Iterator
import http.client
from pathlib import Path
import threading
from urllib.parse import urlsplit

import pytest

from esg.commands.view import view
from esg.outcomes import UserError
from esg.report.serve import serve
from tests.report.folders import write_scene


@pytest.fixture
def address(tmp_path: Path) -> Iterator[tuple[str, int]]:
    """A page served for the length of a test."""
    (tmp_path / "scene").mkdir()
    (tmp_path / "scene" / "esg.json").write_text("{}")
    (tmp_path / "secret.txt").write_text("no")
    found: list[str] = []
    there = threading.Event()

    def ready(url: str) -> None:
        found.append(url)
        there.set()

    thread = threading.Thread(
        target=serve, args=(b"<p>page</p>", tmp_path / "scene", 0, ready), kwargs={"seconds": 5}
    )
    thread.start()
    assert there.wait(5)
    parts = urlsplit(found[0])
    assert parts.hostname == "127.0.0.1"
    assert parts.port
    yield parts.hostname, parts.port


def get(address: tuple[str, int], path: str, host: str | None = None) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection(*address, timeout=5)
    connection.putrequest("GET", path, skip_host=host is not None)
    if host is not None:
        connection.putheader("Host", host)
    connection.endheaders()
    answer = connection.getresponse()
    return answer.status, answer.read()


def test_the_page_its_files_and_nothing_else(address: tuple[str, int]) -> None:
    """No listing, no way out of the folder, no other name for this machine."""
    assert get(address, "/") == (200, b"<p>page</p>")
    assert get(address, "/files/esg.json") == (200, b"{}")
    assert get(address, "/files/")[0] == 404
    assert get(address, "/files/../secret.txt")[0] == 404
    assert get(address, "/files/%2e%2e/secret.txt")[0] == 404
    assert get(address, "/esg.json")[0] == 404
    assert get(address, "/", host="evil.example")[0] == 421
    assert get(address, "/", host="localhost:1234")[0] == 200


def test_view_answers_once_and_stops(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It prints the address it answered at."""
    folder = write_scene(tmp_path / "drop")
    assert view(str(folder), port=0, once=True) == 0
    assert capsys.readouterr().out.startswith("http://127.0.0.1:")


def test_a_taken_port_is_told(tmp_path: Path) -> None:
    """The message names the port and the way out."""
    import socket

    folder = write_scene(tmp_path / "drop")
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        with pytest.raises(UserError, match="choose another, or 0"):
            view(str(folder), port=other.getsockname()[1], once=True)
    with pytest.raises(UserError, match="--port 70000"):
        view(str(folder), port=70000)
