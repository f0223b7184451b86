"""What a rendering is asked for: channels, sizes, cameras, renderer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from esg.outcomes import UserError
from esg.view.renderers.shutter import OPEN

PICTURES = (
    "rgb",
    "depth",
    "normal",
    "segmentation",
    "flow",
    "backward_flow",
    "object_coordinates",
)
BOXES = ("boxes2d", "boxes3d")
CHANNELS = (*PICTURES, *BOXES, "tracks")


@dataclass(frozen=True)
class Settings:
    """What to render.

    Args:
        channels: Of `CHANNELS`.
        size: Width and height [px].
        fps: Frames a second.
        cameras: How many, 1 to 8.
        container: png writes files, parquet shards of rows.
        device: cpu or cuda:N.
        seed: Of the points that are tracked, of noise and of clouds.
        renderer: Of `esg.view.renderers.kinds`, for colours; the other channels are exact.
        samples: Rays a pixel; None for what the renderer takes by itself.
        motion_blur: Colours are those of all the time the shutter is open.
        camera: `around` for cameras that stand around the whole action, or what the director may
            choose from: `auto`, or one of `esg.view.director.paths.KINDS`.
    """

    channels: tuple[str, ...] = ("rgb", "depth", "segmentation")
    size: tuple[int, int] = (256, 256)
    fps: float = 24.0
    cameras: int = 1
    container: Literal["png", "parquet"] = "png"
    device: str = "cpu"
    seed: int = 0
    renderer: str = "raster"
    samples: int | None = None
    motion_blur: bool = False
    camera: str = "around"

    @property
    def open_s(self) -> float:
        """How long the shutter is open [s]."""
        return OPEN / self.fps if self.motion_blur else 0.0


def parse_channels(text: str) -> tuple[str, ...]:
    """Channels of a comma-separated list, `all` for all, `boxes` for both kinds.

    Raises:
        UserError: Naming every unknown one.
    """
    if text.strip() == "all":
        return CHANNELS
    given = [n.strip() for n in text.split(",") if n.strip()]
    names = tuple(dict.fromkeys(m for n in given for m in (BOXES if n == "boxes" else (n,))))
    unknown = [n for n in names if n not in CHANNELS]
    if unknown or not names:
        what = f"unknown channel {', '.join(map(repr, unknown))}" if unknown else "no channel"
        known = ", ".join(CHANNELS)
        raise UserError(f"{what}: choose from {known} or boxes, with commas, or all")
    return names


def parse_size(text: str) -> tuple[int, int]:
    """Width and height of e.g. `256x192`.

    Raises:
        UserError: If it is none, or not between 16 and 4096.
    """
    parts = text.lower().replace("×", "x").split("x")
    if len(parts) == 2 and all(p.strip().isdigit() for p in parts):
        width, height = (int(p) for p in parts)
        if 16 <= width <= 4096 and 16 <= height <= 4096:
            return width, height
    raise UserError(f"--size {text!r}: give width x height in pixels, e.g. 256x256 (16 to 4096)")
