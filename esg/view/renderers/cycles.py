"""Blender's Cycles, as a process of its own: its Python cannot share this one's libraries."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from functools import cache
import json
import os
from pathlib import Path
import shutil
import subprocess
import tempfile
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from esg.outcomes import UserError
from esg.view.camera import Camera
from esg.view.maps import linear, mean_color
from esg.view.pieces import Movers
from esg.view.renderers.finish import denoiser, finished
from esg.view.renderers.groups import groups
from esg.view.renderers.raster import Raster
from esg.view.renderers.records import Kind, Poses, Quality, Scenery, blank
from esg.view.skies import AIRS, lighting_map
from esg.view.tracer.stage import BOUNCE
from esg.view.worlds import Views

SAMPLES = 32
SCRIPT = Path(__file__).with_name("blender_script.py")
TEXTURE_PX = 512
BATCH = 24
PASSES = ("image", "Depth", "Normal", "DiffCol")
"""What the script writes of every frame."""


@cache
def blender() -> tuple[str, str]:
    """The program and its version.

    Raises:
        UserError: If none is found, or it does not start.
    """
    named = os.environ.get("ESG_BLENDER", "")
    found = shutil.which(named or "blender")
    if found is None:
        where = f"ESG_BLENDER={named!r} is no program" if named else "there is none on the PATH"
        raise UserError(f"--renderer cycles needs Blender: {where}; set ESG_BLENDER to its path")
    try:
        shown = subprocess.run(
            [found, "--background", "--version"], capture_output=True, text=True, timeout=60
        ).stdout
    except (OSError, subprocess.TimeoutExpired) as error:
        raise UserError(f"{found} does not start: {error}") from None
    words = shown.split()
    if "Blender" not in words:
        raise UserError(f"{found} is no Blender: it says {shown[:80]!r}")
    return found, words[words.index("Blender") + 1]


class Cycles:
    """Draws all frames that it is given in one run of Blender; see `Drawer`.

    Args:
        scenery: What there is.
        quality: How to draw it.

    Raises:
        UserError: If there is no Blender.
    """

    def __init__(self, scenery: Scenery, quality: Quality) -> None:
        self._program = blender()[0]
        self._scenery, self._quality = scenery, quality
        self._movers = Movers(scenery.everything, scenery.n_bodies)
        self._denoise = denoiser()
        self._exact = Raster(scenery, quality) if quality.exact else None

    def draw(self, poses: Poses, cameras: Sequence[Camera]) -> Views:
        """Pictures of F frames.

        Raises:
            UserError: If Blender fails, with the end of what it said.
        """
        with tempfile.TemporaryDirectory(prefix="esg-cycles-") as work:
            folder = Path(work)
            self._write(folder, poses, cameras)
            run = subprocess.run(
                [self._program, "--background", "--factory-startup", "--python-exit-code", "3",
                 "--python", str(SCRIPT), "--", str(folder)],
                capture_output=True, text=True, env={**os.environ, "PYTHONPATH": ""},
            )  # fmt: skip
            if run.returncode:
                said = "\n".join((run.stdout + run.stderr).strip().splitlines()[-12:])
                raise UserError(f"{self._program} failed with code {run.returncode}:\n{said}")
            size, count = self._quality.size, len(poses)
            found = [
                [_pictures(folder / f"{name}{k}.bin", size) for name in PASSES]
                for k in range(count)
            ]
        rgb = np.stack([self._developed(*v) for v in zip(found, cameras, strict=True)])
        if self._exact is None:
            return blank(rgb)
        return replace(self._exact.draw(poses.middle(), cameras), rgb=rgb)

    def _developed(self, passes: Sequence[NDArray[Any]], camera: Camera) -> NDArray[np.uint8]:
        image, depth, normal, albedo = passes
        color = image[..., :3]
        if self._denoise is not None:
            color = self._denoise(color, albedo[..., :3], normal[..., :3])
        sky, seed = self._scenery.sky, self._quality.seed
        return finished(color, image[..., 3], depth[..., 0], sky, seed, camera)

    def _write(self, folder: Path, poses: Poses, cameras: Sequence[Camera]) -> None:
        """The scene as arrays and a description, for `blender_script.py`."""
        scenery, quality = self._scenery, self._quality
        arrays: dict[str, NDArray[Any]] = {}
        made = groups(scenery.everything, self._movers)
        for k, group in enumerate(made):
            arrays[f"vertices{k}"] = group.vertices
            arrays[f"faces{k}"] = group.faces.astype(np.int32)
            arrays[f"uvs{k}"] = group.uvs
            if group.normals is not None:
                arrays[f"normals{k}"] = group.normals
        at, turn = self._movers.poses(poses.position, poses.quaternion, poses.angles)
        arrays["position"] = np.asarray(at, np.float32)
        arrays["quaternion"] = np.asarray(turn, np.float32)
        ground = scenery.ground
        below = np.array(BOUNCE) if ground is None else mean_color(ground.color, ground.texture)
        # Blender's columns go clockwise, and its pixels have four channels.
        around = lighting_map(scenery.sky, quality.seed, below)[:, ::-1]
        arrays["sky"] = np.concatenate([around, np.ones_like(around[..., :1])], axis=-1)
        looks = [*(g.look for g in made), *([ground] if ground else [])]
        for name in {k.texture for k in looks if k.texture}:
            from esg.assets import textures

            maps = textures.maps(name, TEXTURE_PX)
            for kind in ("base_color", "normal", "roughness"):
                Image.fromarray(getattr(maps, kind)).save(folder / f"{name}.{kind}.png")
        for name, values in arrays.items():
            (folder / f"{name}.bin").write_bytes(np.ascontiguousarray(values).tobytes())
        sky = scenery.sky
        described = {
            "size": quality.size,
            "samples": quality.samples or SAMPLES,
            "seed": quality.seed,
            "device": quality.device,
            "arrays": {
                k: ["i" if v.dtype == np.int32 else "f", v.shape] for k, v in arrays.items()
            },
            "groups": [{"mover": g.mover, "look": _described(g.look)} for g in made],
            "ground": None if ground is None else _described(ground),
            "sun": {"toward": sky.sun, "rgb": sky.sun_rgb, "radius": AIRS[sky.kind].sun_radius},
            "cameras": [
                {"eye": c.eye, "quaternion": c.quaternion().tolist(), "fov": c.fov} for c in cameras
            ],
        }
        (folder / "scene.json").write_text(json.dumps(described), encoding="utf-8")


def _pictures(path: Path, size: tuple[int, int]) -> NDArray[np.float32]:
    """Four channels a pixel, rows from top to bottom."""
    return np.fromfile(path, np.float32).reshape(size[1], size[0], 4)[::-1]


def _described(look: Any) -> dict[str, Any]:
    return asdict(look) | {"linear": linear(look.color).tolist()}


def _version() -> str:
    return f"blender {blender()[1]}"


KIND = Kind("cycles", SAMPLES, Cycles, _version, BATCH)
