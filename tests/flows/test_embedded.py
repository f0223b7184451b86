"""Commands that start at the same moment: ports and the template database."""

from __future__ import annotations

from pathlib import Path
import socket
import threading
import time

import pytest

from flows import embedded


def test_the_port_of_a_starting_api_is_taken_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody else can bind it in the seconds before the API listens."""
    monkeypatch.delenv("PREFECT_API_URL", raising=False)
    monkeypatch.setattr(embedded, "prepare_template", lambda: tmp_path / "none.db")
    monkeypatch.setattr(embedded, "copy_whole", lambda source, target: target.touch())
    monkeypatch.setattr(embedded, "_SERVE", "import time; time.sleep(60)")
    server = embedded.EmbeddedServer()
    server.start()
    try:
        with socket.socket() as other, pytest.raises(OSError):
            other.bind(("127.0.0.1", server._port))
    finally:
        server.stop()


def test_commands_that_start_together_make_one_template(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(embedded, "template_path", lambda: tmp_path / "template.db")
    made: list[Path] = []

    def migrate(template: Path) -> None:
        made.append(template)
        time.sleep(0.3)
        template.touch()

    monkeypatch.setattr(embedded, "_migrate", migrate)
    threads = [threading.Thread(target=embedded.prepare_template) for _ in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert len(made) == 1
