"""Drawing on rendered pictures: trails, captions and the sheet they stand on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.lettering import fitted, font, wrapped

INK = (28, 32, 38)
FAINT = (98, 106, 116)
PAPER = (250, 250, 248)
ALARM = (176, 42, 30)
TRAIL = (255, 196, 0)
ROPE = (46, 40, 34)
GAP = 12
CAPTION_PX = 40
TITLE_LINES = 4
PANELS = "esg-panels"
"""Key of the PNG text that says where the panels are."""


@dataclass(frozen=True)
class Panel:
    """One picture with two lines under it; image shape [height, width, 3] uint8."""

    image: NDArray[np.uint8]
    title: str
    caption: str


SPECK_PX = 9
"""What is smaller in a picture gets a ring of this radius, where that is asked for."""


def draw_trail(
    image: NDArray[np.uint8],
    camera: Camera,
    trails: Sequence[NDArray[np.float64]],
    specks: Sequence[NDArray[np.float64]] = (),
) -> NDArray[np.uint8]:
    """Draws where bodies came from, as half-transparent lines, and rings around tiny ones.

    Args:
        image: Shape [height, width, 3].
        camera: That took it.
        trails: World paths [m], each of shape [n, 3].
        specks: Corners [m] of bodies that get a ring where they are hardly seen, each [8, 3].
    """
    from PIL import Image, ImageDraw

    height, width = image.shape[:2]
    scale = 2
    layer = Image.new("RGBA", (scale * width, scale * height), (*TRAIL, 0))
    draw = ImageDraw.Draw(layer)
    for path in trails:
        pixels, ahead = camera.project(path, scale * width, scale * height)
        points = [(float(x), float(y)) for (x, y), ok in zip(pixels, ahead, strict=True) if ok]
        points = [p for p in points if abs(p[0]) < 1e5 and abs(p[1]) < 1e5]
        if len(points) > 1:
            draw.line(points, fill=(*TRAIL, 170), width=2 * scale, joint="curve")
            x, y = points[-1]
            r = 2.5 * scale
            draw.ellipse((x - r, y - r, x + r, y + r), fill=(*TRAIL, 220))
    for box in specks:
        pixels, ahead = camera.project(box, scale * width, scale * height)
        if ahead.all() and float(np.ptp(pixels, axis=0).max()) < SPECK_PX * scale:
            x, y = (float(c) for c in pixels.mean(axis=0))
            r = SPECK_PX * scale
            draw.ellipse((x - r, y - r, x + r, y + r), outline=(*TRAIL, 255), width=2 * scale)
    layer = layer.resize((width, height), Image.Resampling.LANCZOS)
    base = Image.fromarray(image).convert("RGBA")
    return np.asarray(Image.alpha_composite(base, layer).convert("RGB"))


def draw_ropes(
    image: NDArray[np.uint8], camera: Camera, ropes: Sequence[NDArray[np.float64]]
) -> NDArray[np.uint8]:
    """Draws ropes and springs, which have no mesh, over a picture: what hides them is not asked.

    Args:
        image: Shape [height, width, 3].
        camera: That took it.
        ropes: Their two ends in the world [m], each of shape [2, 3].
    """
    from PIL import Image, ImageDraw

    if not ropes:
        return image
    height, width = image.shape[:2]
    base = Image.fromarray(image).resize((2 * width, 2 * height), Image.Resampling.NEAREST)
    draw = ImageDraw.Draw(base)
    for ends in ropes:
        pixels, ahead = camera.project(ends, 2 * width, 2 * height)
        if ahead.all() and float(np.abs(pixels).max()) < 1e5:
            draw.line([(float(x), float(y)) for x, y in pixels], fill=ROPE, width=3)
    return np.asarray(base.resize((width, height), Image.Resampling.BOX))


def write_sheet(
    path: Path,
    panels: Sequence[Panel],
    *,
    title: str,
    note: str = "",
    footnotes: Sequence[str] = (),
) -> Path:
    """Writes the panels as one PNG, at most three a row, under a wrapped title.

    Args:
        path: Of the file.
        panels: At least one, all of one size.
        title: First lines, usually the prompt.
        note: Line below the title.
        footnotes: Lines below the panels, e.g. what did not happen.
    """
    from PIL import Image, ImageDraw
    from PIL.PngImagePlugin import PngInfo

    height, width = panels[0].image.shape[:2]
    columns = 2 if len(panels) in (2, 4) else min(3, len(panels))
    rows = -(-len(panels) // columns)
    sheet_width = columns * width + (columns + 1) * GAP
    title_lines = wrapped(title, 17, sheet_width - 2 * GAP)
    if len(title_lines) > TITLE_LINES:
        title_lines = [*title_lines[: TITLE_LINES - 1], title_lines[TITLE_LINES - 1] + " \u2026"]
    notes = wrapped(note, 13, sheet_width - 2 * GAP) if note else []
    foot = [line for f in footnotes[:8] for line in wrapped(f, 13, sheet_width - 2 * GAP)]
    top = GAP + 23 * len(title_lines) + 18 * len(notes) + 8
    bottom = 18 * len(foot) + (GAP if foot else 0)
    sheet_height = top + rows * (height + CAPTION_PX + GAP) + bottom
    sheet = Image.new("RGB", (sheet_width, sheet_height), PAPER)
    draw = ImageDraw.Draw(sheet)
    y = GAP
    for line in title_lines:
        draw.text((GAP, y), line, fill=INK, font=font(17))
        y += 23
    for line in notes:
        draw.text((GAP, y), line, fill=FAINT, font=font(13))
        y += 18
    boxes: list[list[int]] = []
    for k, panel in enumerate(panels):
        x = GAP + (k % columns) * (width + GAP)
        y = top + (k // columns) * (height + CAPTION_PX + GAP)
        sheet.paste(Image.fromarray(panel.image), (x, y))
        boxes.append([x, y, x + width, y + height])
        draw.text((x, y + height + 3), fitted(panel.title, 14, width), fill=INK, font=font(14))
        draw.text((x, y + height + 21), fitted(panel.caption, 13, width), fill=FAINT, font=font(13))
    y = top + rows * (height + CAPTION_PX + GAP)
    for line in foot:
        draw.text((GAP, y), line, fill=ALARM, font=font(13))
        y += 18
    path.parent.mkdir(parents=True, exist_ok=True)
    info = PngInfo()
    info.add_text(PANELS, json.dumps(boxes))
    sheet.save(path, "PNG", optimize=False, compress_level=6, pnginfo=info)
    return path


def panel_boxes(image: Any) -> list[tuple[int, int, int, int]]:
    """Where the panels are on a sheet that `write_sheet` wrote: left, top, right, bottom [px].

    Args:
        image: The opened PNG; of any other picture nothing is known and the list is empty.
    """
    try:
        boxes = json.loads(image.info.get(PANELS, "[]"))
        return [(int(a), int(b), int(c), int(d)) for a, b, c, d in boxes]
    except (TypeError, ValueError):
        return []
