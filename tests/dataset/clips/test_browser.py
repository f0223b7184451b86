"""A film with its caption in a real browser."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
import re
import threading
from typing import Any

import pytest

from tests.dataset.clips.synthetic import SIZE, write_synthetic
from tests.report import browser as chrome

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(bool(chrome.missing()), reason=chrome.missing() or "a browser is here"),
]
PAGE = Path(__file__).parents[3] / "docs" / "dataset" / "annotations.md"
FRAMES = 10
CAPTION = {
    "short": "A box slides & a ball falls.",
    "event_texts": ["The box hits the wall.", "The ball falls."],
    "event_times_s": [0.125, 0.25],
}
WATCH = """
const done = arguments[0], film = document.querySelector("video"), seen = [];
const track = film.textTracks[0];
track.mode = "showing";
track.oncuechange = () => seen.push(...[...track.activeCues].map(cue => cue.text));
film.onerror = () => done({error: film.error.message});
film.onended = () => done({
    seen, width: film.videoWidth, height: film.videoHeight, length: film.duration,
    at: film.currentTime, frames: film.getVideoPlaybackQuality().totalVideoFrames,
});
film.muted = true;
film.playbackRate = 0.25;
film.play().catch(error => done({error: String(error)}));
"""


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    """A server of a folder, silent."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, format: str, *args: Any) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=tmp_path)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


def subtitles() -> Callable[[dict[str, Any], float], str]:
    """The function that the documentation shows."""
    (code,) = re.findall(r"```python subtitles\n(.*?)```", PAGE.read_text("utf-8"), flags=re.S)
    found: dict[str, Any] = {}
    exec(code, found)
    return found["subtitles"]


def test_a_film_plays_with_its_caption(tmp_path: Path, address: str) -> None:
    film = write_synthetic(tmp_path, frames=FRAMES).files[0].path
    (tmp_path / "it.vtt").write_text(subtitles()(CAPTION, FRAMES / 24))
    track = '<track default kind="captions" src="it.vtt">'
    page = f'<!doctype html><html data-ready="yes"><video src="{film}">{track}</video></html>'
    (tmp_path / "page.html").write_text(page)
    with chrome.browser() as driver:
        chrome.open_page(driver, f"{address}/page.html")
        driver.set_script_timeout(120)
        told = driver.execute_async_script(WATCH)
    assert "error" not in told, told
    assert (told["width"], told["height"]) == SIZE
    assert told["at"] == told["length"] == pytest.approx(FRAMES / 24, abs=0.01)
    assert told["frames"] >= FRAMES - 1
    assert list(dict.fromkeys(told["seen"])) == [CAPTION["short"], *CAPTION["event_texts"]]
