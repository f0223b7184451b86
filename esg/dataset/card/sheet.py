"""A sheet of pictures: what scenes of a dataset look like, each above what it was asked for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.outcomes import UserError
from esg.store.tables import iter_rows, part_files
from esg.view.lettering import font, wrapped

if TYPE_CHECKING:
    from PIL.Image import Image

SHEET = "sheet.jpg"
PICTURES, COLUMNS = 24, 6
TILE_PX = (320, 240)
_TEXT_PX, _LINES, _GAP = 13, 3, 8


def draw_sheet(out: Path) -> Image | None:
    """The sheet of a dataset, None if it has neither clips nor previews.

    Args:
        out: Its folder, with tables.
    """
    from PIL import Image, ImageDraw

    shown = list(_pictures(out))
    if not shown:
        return None
    face = font(_TEXT_PX)
    line = _TEXT_PX + 4
    width, height = TILE_PX[0] + _GAP, TILE_PX[1] + _LINES * line + 2 * _GAP
    rows = -(-len(shown) // COLUMNS)
    columns = min(COLUMNS, len(shown))
    sheet = Image.new("RGB", (columns * width + _GAP, rows * height + _GAP), (250, 250, 248))
    draw = ImageDraw.Draw(sheet)
    for k, (picture, text) in enumerate(shown):
        left, top = _GAP + (k % COLUMNS) * width, _GAP + (k // COLUMNS) * height
        sheet.paste(_fitted(picture), (left, top))
        lines = wrapped(text, _TEXT_PX, TILE_PX[0])
        if len(lines) > _LINES:
            lines = [*lines[: _LINES - 1], f"{lines[_LINES - 1][:-3]}..."]
        for number, words in enumerate(lines):
            draw.text((left, top + TILE_PX[1] + 4 + number * line), words, (40, 40, 44), face)
    return sheet


def _fitted(picture: Image) -> Image:
    """The middle of a picture, as large as a tile."""
    from PIL import ImageOps

    return ImageOps.fit(picture, TILE_PX)


def _spread(items: Sequence[Any]) -> list[Any]:
    """So many of them that the sheet is full, from the first to the last."""
    if len(items) <= PICTURES:
        return list(items)
    return [items[round(k * (len(items) - 1) / (PICTURES - 1))] for k in range(PICTURES)]


def _pictures(out: Path) -> Iterator[tuple[Image, str]]:
    """Pictures with their prompts: of the first camera's clips, or else previews."""
    first = _first_events(out)
    files = part_files(out, "clips")
    columns = ["scene_key", "camera", "files", "time_s"]
    frames = {
        row["scene_key"]: _frame(row, first)
        for row in iter_rows(files, columns)
        if row["camera"] == 0 and any(f["channel"] == "rgb" for f in row["files"])
    }
    shown = set(_spread(sorted(frames)))
    stills: dict[str, tuple[Image, str]] = {}
    for row in iter_rows(files, ["scene_key", "camera", "prompt", "video"], rows=16):
        key = row["scene_key"]
        if row["camera"] == 0 and key in shown:
            # Of a dataset at a URL, the films in the rows are all that is here.
            film = row["video"]["bytes"] or out / row["video"]["path"]
            picture = _still(film, frames[key])
            if picture is not None:
                stills[key] = picture, row["prompt"]
    yield from (stills[key] for key in sorted(stills))
    if not frames:
        yield from _previews(out)


def _first_events(out: Path) -> dict[str, float]:
    """When the first event of every scene happens [s]."""
    times: dict[str, float] = {}
    for row in iter_rows(part_files(out, "metrics"), ["scene_key", "time_s"]):
        if row["time_s"] is not None:
            key, time = str(row["scene_key"]), float(row["time_s"])
            times[key] = min(time, times.get(key, time))
    return times


def _frame(row: dict[str, Any], first: dict[str, float]) -> int:
    """The frame of a clip at its scene's first event, or in its middle."""
    times = row["time_s"]
    wanted = first.get(row["scene_key"], times[len(times) // 2])
    return min(range(len(times)), key=lambda k: abs(times[k] - wanted))


def _still(film: bytes | Path, wanted: int) -> Image | None:
    """One picture of a film; None if it is damaged, which others tell."""
    import av

    try:
        with av.open(io.BytesIO(film) if isinstance(film, bytes) else film, "r") as container:
            for number, frame in enumerate(container.decode(video=0)):
                if number == wanted:
                    return frame.to_image()
    except (OSError, ValueError, IndexError):
        return None
    return None


def _previews(out: Path) -> Iterator[tuple[Image, str]]:
    from PIL import Image

    files = part_files(out, "scenes")
    keys = [
        row["scene_key"]
        for row in iter_rows(files, ["scene_key", "preview"], rows=16)
        if row["preview"] and row["preview"]["bytes"]
    ]
    wanted = set(_spread(sorted(keys)))
    for row in iter_rows(files, ["scene_key", "preview", "prompt"], rows=16):
        if row["scene_key"] in wanted:
            try:
                yield Image.open(io.BytesIO(row["preview"]["bytes"])), row["prompt"]
            except (OSError, UserError):
                continue
