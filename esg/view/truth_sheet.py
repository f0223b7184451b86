"""All channels of one instant on one sheet, for people: a capture checked at a glance."""

from __future__ import annotations

import colorsys
import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.capture import decode_flow
from esg.view.containers import read_capture
from esg.view.lettering import font, lettered
from esg.view.sheet import Panel, write_sheet

Picture = NDArray[np.uint8]
_EDGES = ((0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7), (0, 4), (1, 5), (2, 6),
          (3, 7))  # fmt: skip
"""Corners of a box that an edge joins, as `box_corners` orders them."""


def truth_sheet(folder: Path, path: Path, time_s: float) -> Path:
    """Draws every channel of the frame nearest to a time, as the first camera sees it.

    Args:
        folder: A capture.
        path: Of the PNG.
        time_s: Wanted time [s].
    """
    manifest = json.loads((folder / "manifest.json").read_bytes())
    times = np.array(manifest["time_s"])
    frame = int(np.argmin(np.abs(times - time_s)))
    rows = read_capture(folder)
    row = next(r for r in rows if r["camera"] == 0 and r["frame"] == frame)
    names = {b["id"]: b["label"] or b["name"] for b in manifest["bodies"]}
    panels = [
        Panel(picture, name, caption) for name, picture, caption in _pictures(row, names, manifest)
    ]
    size = f"{manifest['width_px']} x {manifest['height_px']} px"
    note = f"camera_0, frame {frame}, t = {times[frame]:.2f} s, {size}"
    return write_sheet(path, panels, title=manifest["prompt"], note=note)


def _pictures(
    row: dict[str, Any], names: dict[int, str], manifest: dict[str, Any]
) -> list[tuple[str, Picture, str]]:
    height, width = manifest["height_px"], manifest["width_px"]
    base = row.get("rgb", np.full((height, width, 3), 40, np.uint8))
    out: list[tuple[str, Picture, str]] = []
    if "rgb" in row:
        out.append(("rgb", base, "8-bit colour"))
    if "depth" in row:
        depth = row["depth"]
        known = depth[depth > 0]
        low, high = np.percentile(known, (1, 90)) if len(known) else (0, 1)
        out.append(("depth", _ramp(depth, low, high), f"{low:.1f} to {high:.1f} m and beyond"))
    if "normal" in row:
        shown = (row["normal"] >> 8).astype(np.uint8)
        out.append(("normal", shown, "world frame"))
    if "segmentation" in row:
        ids = row["segmentation"]
        found = [names.get(int(i), "ground") for i in np.unique(ids) if i > 0]
        out.append(("segmentation", _palette(ids), ", ".join(found)))
    for name, way in (("flow", "to the next frame"), ("backward_flow", "to the frame before")):
        if name in row:
            shift, known = decode_flow(row[name])
            size = float(np.hypot(*np.moveaxis(shift, -1, 0))[known].max(initial=0.0))
            out.append((name, _wheel(shift, known, size), f"up to {size:.1f} px {way}"))
    if "object_coordinates" in row:
        shown = (row["object_coordinates"] >> 8).astype(np.uint8)
        out.append(("object_coordinates", shown, "share of each body's bounds"))
    if "boxes2d" in row:
        count = len(row["boxes2d"])
        out.append(("boxes2d", _boxes_2d(base, row["boxes2d"], names), f"{count} bodies in view"))
    if "boxes3d" in row:
        shown = [b for b in row["boxes3d"] if max(b["half_extents_m"][:2]) < 8]
        out.append(("boxes3d", _boxes_3d(base, shown), "oriented boxes; wide floors left out"))
    if "tracks" in row:
        seen = sum(row["tracks"]["visible"])
        total = len(row["tracks"]["visible"])
        drawn = _tracks(base, row["tracks"], manifest["track_points"]["id"])
        out.append(("tracks", drawn, f"{seen} of {total} points visible"))
    return out


def _hue(ids: Any) -> NDArray[np.float64]:
    """A colour an id, far apart for neighbours, shape [..., 3] in [0, 1]."""
    table = np.array([colorsys.hsv_to_rgb((0.618034 * k) % 1, 0.65, 0.95) for k in range(256)])
    return table[np.asarray(ids) % 256]


def _palette(ids: Any) -> Picture:
    colors = 255 * _hue(ids)
    colors[ids == 0] = 20
    colors[ids == 1] = 90
    return colors.astype(np.uint8)


def _ramp(values: Any, low: float, high: float) -> Picture:
    """Near bright and warm, far dark and cold; nothing is black."""
    t = np.clip((values - low) / max(high - low, 1e-9), 0, 1)[..., None]
    stops = np.array([[253, 231, 37], [53, 183, 121], [49, 104, 142], [68, 1, 84]], float)
    at = t * (len(stops) - 1)
    k = np.clip(at.astype(int), 0, len(stops) - 2)
    colors = stops[k[..., 0]] * (1 - (at - k)) + stops[k[..., 0] + 1] * (at - k)
    colors[values <= 0] = 0
    return colors.astype(np.uint8)


def _wheel(shift: Any, known: Any, size: float) -> Picture:
    """Direction as hue, length as strength."""
    angle = np.arctan2(shift[..., 1], shift[..., 0])
    strength = np.hypot(shift[..., 0], shift[..., 1]) / max(size, 1e-9)
    phase = angle[..., None] + np.array([0.0, -2.0944, 2.0944])
    full = 255 * (0.5 + 0.5 * np.cos(phase))
    colors = 255 - strength[..., None] * (255 - full)
    colors[~known] = 0
    return colors.astype(np.uint8)


def _canvas(base: Picture) -> tuple[Any, Any]:
    from PIL import Image, ImageDraw

    image = Image.fromarray((0.55 * base).astype(np.uint8))
    return image, ImageDraw.Draw(image)


def _rgb(index: int) -> tuple[int, int, int]:
    red, green, blue = (round(255 * float(v)) for v in _hue(index))
    return red, green, blue


def _boxes_2d(base: Picture, boxes: list[dict[str, Any]], names: dict[int, str]) -> Picture:
    image, draw = _canvas(base)
    letters = font(max(9, base.shape[0] // 26))
    for box in boxes:
        x0, y0, x1, y1 = box["box_px"]
        draw.rectangle((x0, y0, x1 - 1, y1 - 1), outline=_rgb(box["id"]))
        draw.text(
            (x0 + 2, y0), lettered(names.get(box["id"], "")), fill=_rgb(box["id"]), font=letters
        )
    return np.asarray(image)


def _boxes_3d(base: Picture, boxes: list[dict[str, Any]]) -> Picture:
    image, draw = _canvas(base)
    for box in boxes:
        corners = box["corners_px"]
        if not corners or np.abs(corners).max() > 1e5:
            continue
        for a, b in _EDGES:
            draw.line((*corners[a], *corners[b]), fill=_rgb(box["id"]))
    return np.asarray(image)


def _tracks(base: Picture, tracks: dict[str, Any], owners: list[int]) -> Picture:
    image, draw = _canvas(base)
    for (x, y), seen, owner in zip(tracks["xy_px"], tracks["visible"], owners, strict=True):
        if seen:
            draw.ellipse((x - 2, y - 2, x + 2, y + 2), fill=_rgb(owner))
    return np.asarray(image)
