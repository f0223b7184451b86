"""Films: which instants they show, how fast, that browsers can play them, and what a full disk does."""

from __future__ import annotations

import builtins
import math
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest

from esg.view.director.acting import Beat
from esg.view.director.review import PROBE_PX
from esg.view.film.cutting import (
    FPS,
    MAX_FRAMES,
    SLOW,
    SLOW_AFTER_S,
    SLOW_BEFORE_S,
    cuts_of,
    told,
)
from esg.view.film.encoding import NoFilmError, write_film
from esg.view.film.shooting import SIZE_PX, frames_of, shots_of, write_scene_film
from tests.view.plays import PLAYS, action_of, document_of, finder_of, parts_of

DROP = next(play for play in PLAYS if play.name == "drop")


def beat(time: float, kind: str = "collision") -> Beat:
    """An event of the first body."""
    return Beat("e", kind, time, (0,))


def test_normal_speed_with_slow_motion_around_short_events() -> None:
    """Every frame is a 24th of a second on, or a quarter of that around the hit."""
    (cut,) = cuts_of([beat(2.0)], 5.0)
    step = np.diff(cut.time_s)
    slow = (cut.time_s >= 2.0 - SLOW_BEFORE_S - 1e-9) & (cut.time_s < 2.0 + SLOW_AFTER_S - 1e-9)
    assert (cut.speed[slow] == SLOW).all() and (cut.speed[~slow] == 1.0).all()
    assert slow.sum() == math.ceil((SLOW_BEFORE_S + SLOW_AFTER_S) / SLOW * FPS)
    assert (step <= cut.speed[:-1] / FPS + 1e-9).all()
    # Only the frame before slow motion may be shorter.
    assert (np.abs(step - cut.speed[:-1] / FPS) > 1e-9).sum() <= 1
    assert cut.time_s[0] == 1.3 and cut.time_s[-1] == pytest.approx(2.6, abs=1 / FPS)


def test_lasting_events_are_not_slowed() -> None:
    """A car that drives off does not do so in an instant, and one sees where it goes."""
    (cut,) = cuts_of([beat(1.0, "moves")], 5.0)
    assert (cut.speed == 1.0).all()
    assert cut.time_s[-1] >= 2.9


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8, 20])
@pytest.mark.parametrize("apart", [0.05, 0.5, 3.0])
def test_films_are_short_and_show_every_event(count: int, apart: float) -> None:
    """However many there are."""
    beats = [beat(0.5 + apart * k) for k in range(count)]
    cuts = cuts_of(beats, 100.0)
    times = np.concatenate([cut.time_s for cut in cuts])
    assert len(times) <= MAX_FRAMES + len(cuts)
    assert (np.diff(times) > 0).all()
    for one in beats:
        assert (
            np.abs(times - one.time_s).min() <= 0.5 * max(c.speed.max() for c in cuts) / FPS + 1e-9
        )


def test_the_corner_says_time_and_speed() -> None:
    """What is slowed down or sped up is said."""
    assert told(1.137, 1.0) == "1.14 s"
    assert told(1.137, SLOW) == "1.14 s   1/4 speed"
    assert told(2.0, 1.31) == "2.00 s   1.4 x speed"


def opened(path: Path) -> dict[str, Any]:
    """What a player finds in a film."""
    with av.open(str(path)) as film:
        stream = film.streams.video[0]
        frames = [frame.to_ndarray(format="rgb24") for frame in film.decode(stream)]
        return {
            "codec": stream.codec_context.name,
            "pixels": stream.codec_context.pix_fmt,
            "rate": float(stream.average_rate or 0),
            "seconds": float(stream.duration * stream.time_base),  # type: ignore[operator]
            "frames": frames,
        }


def test_a_film_opens_with_its_rate_duration_and_pictures(tmp_path: Path) -> None:
    """H.264 in 4:2:0, its index in front; the same scene gives the same bytes."""
    finder = finder_of(DROP, PROBE_PX)
    shots = shots_of(finder)
    drawn = list(frames_of(finder, shots))
    one, two = (tmp_path / name for name in ("one.mp4", "two.mp4"))
    for path in (one, two):
        write_scene_film(action_of(DROP), document_of(DROP), parts_of(DROP), path)
    assert one.read_bytes() == two.read_bytes()
    found = opened(one)
    assert (found["codec"], found["pixels"], found["rate"]) == ("h264", "yuv420p", FPS)
    assert len(found["frames"]) == len(drawn) <= MAX_FRAMES
    assert found["seconds"] == pytest.approx(len(drawn) / FPS, abs=1 / FPS)
    assert found["frames"][0].shape == (SIZE_PX[1], SIZE_PX[0], 3)
    for k in (0, len(drawn) // 2, -1):
        assert np.abs(found["frames"][k].astype(int) - drawn[k]).mean() < 6
    # Browsers start playing before the end has come: the index is in front of the pictures.
    data = one.read_bytes()
    assert 0 < data.index(b"moov") < data.index(b"mdat")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["one.mp4", "two.mp4"]


def test_the_ball_is_where_it_falls_and_moves_in_the_film() -> None:
    """Frames around the hit differ where the ball is; the corner tells their speed."""
    finder = finder_of(DROP)
    (shot,) = shots_of(finder)
    frames = list(frames_of(finder, [shot]))
    hit = int(np.argmin(np.abs(shot.cut.time_s - 0.51)))
    assert shot.cut.speed[hit] == SLOW
    pixels, ahead = shot.take.camera(hit).project(np.array([[0.0, 0.0, 0.71]]), *SIZE_PX)
    assert ahead.all()
    x, y = (int(v) for v in pixels[0])
    red, green, _ = (int(v) for v in frames[hit][y, x])
    assert green > 1.2 * red  # as `parts_of` paints the first thing
    assert (frames[0] != frames[hit]).mean() > 0.01


def test_without_pyav_or_on_a_full_disk_there_is_a_reason(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And no half a file."""
    frames = [np.zeros((SIZE_PX[1], SIZE_PX[0], 3), np.uint8)] * 3
    with pytest.raises(NoFilmError, match="could not be written"):
        write_film(tmp_path / "missing" / "film.mp4", frames, SIZE_PX)

    def full(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    with pytest.raises(NoFilmError, match="No space left"):
        write_film(tmp_path / "film.mp4", frames, SIZE_PX)
    assert list(tmp_path.iterdir()) == []
    real = builtins.__import__

    def without(name: str, *more: Any, **options: Any) -> Any:
        if name.partition(".")[0] == "av":
            raise ImportError("no av here")
        return real(name, *more, **options)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(NoFilmError, match="no av here"):
        write_film(tmp_path / "film.mp4", frames, SIZE_PX)


def test_who_passes_is_seen_to_come_and_to_go() -> None:
    """Longer than a hit, and at its own speed."""
    (cut,) = cuts_of([beat(3.0, "misses")], 8.0)
    assert (cut.speed == 1.0).all()
    assert cut.time_s[0] < 1.9 and cut.time_s[-1] > 3.9
