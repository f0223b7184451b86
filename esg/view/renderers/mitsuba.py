"""A scenery as Mitsuba 3 wants it: shapes, materials and lamps."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import ctypes.util
from dataclasses import dataclass
from functools import cache
import glob
import math
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.outcomes import UserError
from esg.view.camera import Camera
from esg.view.maps import linear, mean_color
from esg.view.pieces import Movers, Part
from esg.view.skies import AIRS, sky_at, sky_map
from esg.view.surroundings import Sky
from esg.view.tracer.stage import BOUNCE, CLEAR, surface

TEXTURE_PX = 512
GROUND_HALF_M = 1500.0
SUN_AWAY_M = 8000.0
SKY_PX = (1024, 512)
PANE = 0.6
"""What is less opaque and as smooth as glass is a pane: it mirrors, and bends nothing."""
PANE_ROUGHNESS = 0.2
LLVM_VERSIONS = (19, 20, 18, 17, 16)
"""In the order of trust: 19 is tested; 15 aborts the process."""


@cache
def loaded(device: str) -> Any:
    """The module of Mitsuba, its variant chosen for a device.

    Args:
        device: cpu (LLVM where there is one, otherwise slow scalar code) or cuda:N.

    Raises:
        UserError: If it is not installed.
    """
    try:
        if device == "cpu" and "DRJIT_LIBLLVM_PATH" not in os.environ:
            found = _llvm()
            if found:
                os.environ["DRJIT_LIBLLVM_PATH"] = found
        import mitsuba as mi
    except ImportError:
        raise UserError(
            "--renderer path needs Mitsuba: pip install 'esg-scenes[render]'"
        ) from None
    if device != "cpu":
        mi.set_variant("cuda_ad_rgb")
    else:
        mi.set_variant("llvm_ad_rgb" if os.environ.get("DRJIT_LIBLLVM_PATH") else "scalar_rgb")
    return mi


def _llvm() -> str | None:
    """The shared library of an LLVM that Dr.Jit gets on with."""
    for version in LLVM_VERSIONS:
        name = ctypes.util.find_library(f"LLVM-{version}")
        paths = sorted(
            p
            for pattern in (f"libLLVM.so.{version}*", f"libLLVM-{version}*.so*")
            for folder in ("/usr/lib/*", "/usr/lib64", f"/usr/lib/llvm-{version}/lib")
            for p in glob.glob(f"{folder}/{pattern}")
        )
        if paths or name:
            return paths[0] if paths else name
    return None


@dataclass
class Group:
    """All parts of one look that move as one.

    Args:
        mover: Index among `Movers`; -1 for the world.
        vertices: Shape [n, 3] [m].
        normals: At the vertices, shape [n, 3]; None for flat faces.
    """

    mover: int
    look: Look
    vertices: NDArray[np.float32]
    faces: NDArray[np.uint32]
    normals: NDArray[np.float32] | None
    uvs: NDArray[np.float32]


def groups(parts: Iterable[Part], movers: Movers) -> list[Group]:
    """Parts of one look, one pose and one kind of normals together."""
    found: dict[tuple[int, Look, bool], list[Part]] = {}
    for part in parts:
        if len(part.faces):
            key = (movers.of(part), surface(part), part.normals is not None)
            found.setdefault(key, []).append(part)
    out: list[Group] = []
    for (mover, look, smooth), members in found.items():
        starts = np.cumsum([0, *(len(p.vertices) for p in members[:-1])])
        faces = [p.faces + s for p, s in zip(members, starts, strict=True)]
        uvs = [np.zeros((len(p.vertices), 2)) if p.uvs is None else p.uvs for p in members]
        normals = [p.normals for p in members if p.normals is not None] if smooth else None
        out.append(
            Group(
                mover,
                look,
                np.concatenate([p.vertices for p in members]).astype(np.float32),
                np.concatenate(faces).astype(np.uint32),
                np.concatenate(normals).astype(np.float32) if normals else None,
                np.concatenate(uvs).astype(np.float32),
            )
        )
    return out


def material(mi: Any, look: Look, uv_scale: float = 1.0) -> Any:
    """A material of a look.

    Args:
        mi: Of `loaded`.
        look: How the surface looks.
        uv_scale: Texture coordinates are multiplied with it.
    """
    color = linear(look.color)
    if look.alpha < PANE and look.roughness < PANE_ROUGHNESS:
        through = (1 - look.alpha) + look.alpha * color
        return mi.load_dict(
            {
                "type": "thindielectric",
                "specular_transmittance": {"type": "rgb", "value": _floats(through)},
            }
        )
    base: Any = {"type": "rgb", "value": _floats(np.minimum(color, 0.95))}
    rough: Any = max(look.roughness, 0.05)
    maps = None
    if look.texture:
        from esg.assets import textures

        maps = textures.maps(look.texture, TEXTURE_PX)
        base = _bitmap(mi, np.minimum(linear(maps.base_color / 255.0) * color, 0.95), uv_scale)
        share = maps.roughness[..., None].astype(np.float32) / 255.0
        rough = _bitmap(mi, np.maximum(share * look.roughness, 0.05), uv_scale)
    bsdf: Any = {
        "type": "principled",
        "base_color": base,
        "roughness": rough,
        "metallic": float(look.metalness),
        "specular": 0.5,
    }
    if maps is not None:
        bent = _bitmap(mi, maps.normal.astype(np.float32) / 255.0, uv_scale)
        bsdf = {"type": "normalmap", "normalmap": bent, "bsdf": bsdf}
    bsdf = {"type": "twosided", "bsdf": bsdf}
    if look.alpha < CLEAR:
        bsdf = {"type": "mask", "opacity": float(look.alpha), "bsdf": bsdf}
    return mi.load_dict(bsdf)


def _bitmap(mi: Any, pixels: NDArray[np.float32], scale: float) -> dict[str, Any]:
    """A texture of linear values that repeats; its first row is the top of a tile."""
    return {
        "type": "bitmap",
        "bitmap": mi.Bitmap(np.ascontiguousarray(pixels[::-1], np.float32)),
        "raw": True,
        "to_uv": mi.ScalarTransform4f().scale([scale, scale, 1]),
    }


def _floats(values: Any) -> list[float]:
    return [float(v) for v in values]


def shape(mi: Any, name: str, group: Group, bsdf: Any) -> Any:
    """A mesh of Mitsuba."""
    props = mi.Properties()
    props["bsdf"] = bsdf
    props["face_normals"] = group.normals is None
    n, f = len(group.vertices), len(group.faces)
    mesh = mi.Mesh(name, n, f, props, group.normals is not None, True)
    params = mi.traverse(mesh)
    params["vertex_positions"] = group.vertices.ravel()
    params["faces"] = group.faces.ravel()
    params["vertex_texcoords"] = group.uvs.ravel()
    if group.normals is not None:
        params["vertex_normals"] = group.normals.ravel()
    params.update()
    return mesh


def ground_plane(mi: Any, look: Look) -> dict[str, Any]:
    """The endless plane, as wide as one sees."""
    t = mi.ScalarTransform4f()
    return {
        "type": "rectangle",
        "to_world": t.scale([GROUND_HALF_M, GROUND_HALF_M, 1.0]),
        "bsdf": material(mi, look, 2 * GROUND_HALF_M / look.tile_m),
    }


def lamps(mi: Any, sky: Sky, ground: Look | None, seed: int) -> dict[str, Any]:
    """Sun and sky: together they light a surface as `Sky` says.

    The sun is a far disc, so that its shadows are as soft as in the other renderers.
    """
    below = np.array(BOUNCE) if ground is None else mean_color(ground.color, ground.texture)
    columns, rows = SKY_PX
    azimuth = (np.arange(columns) + 0.5) / columns * 2 * math.pi
    polar = (np.arange(rows) + 0.5) / rows * math.pi
    d = np.stack(
        [
            np.outer(np.sin(polar), np.sin(azimuth)),
            np.outer(np.sin(polar), np.cos(azimuth)),
            np.repeat(np.cos(polar)[:, None], columns, axis=1),
        ],
        axis=-1,
    )
    light = sky_at(sky_map(sky, seed), d)
    up = np.maximum(d[..., 2:], 0) * np.sin(polar)[:, None, None]
    irradiance = (light * up).sum(axis=(0, 1)) / up.sum()
    light = light * (np.array(sky.ambient_rgb) / np.maximum(irradiance, 1e-6))
    light[d[..., 2] < 0] = below * np.array(sky.ambient_rgb)
    t = mi.ScalarTransform4f()
    air = AIRS[sky.kind]
    spread = math.tan(air.sun_radius)
    far = np.array(sky.sun) * SUN_AWAY_M
    across = [0.0, 0.0, 1.0] if abs(sky.sun[2]) < 0.9 else [1.0, 0.0, 0.0]
    place = t.look_at(origin=_floats(far), target=[0.0, 0.0, 0.0], up=across)
    return {
        "sky": {
            "type": "envmap",
            "bitmap": mi.Bitmap(light.astype(np.float32)),
            # Mitsuba's up is Y; its columns begin at -Z and go to +X.
            "to_world": t.rotate([1, 0, 0], 90),
        },
        "sun": {
            "type": "disk",
            "to_world": place @ t.scale([SUN_AWAY_M * spread, SUN_AWAY_M * spread, 1.0]),
            "emitter": {
                "type": "area",
                "radiance": {"type": "rgb", "value": _floats(np.array(sky.sun_rgb) / spread**2)},
            },
        },
    }


def sensor(mi: Any, camera: Camera, size: tuple[int, int]) -> Any:
    """A camera of Mitsuba: every sample counts for its own pixel only."""
    return mi.load_dict(
        {
            "type": "perspective",
            "fov": math.degrees(camera.fov),
            "fov_axis": "y",
            "near_clip": 0.01,
            "far_clip": 20000.0,
            "to_world": mi.ScalarTransform4f().look_at(
                origin=_floats(camera.eye), target=_floats(camera.target), up=[0, 0, 1]
            ),
            "film": {
                "type": "hdrfilm",
                "width": size[0],
                "height": size[1],
                "rfilter": {"type": "box"},
                "pixel_format": "rgba",
                "component_format": "float32",
            },
            "sampler": {"type": "independent"},
        }
    )


def moved(group: Group, position: NDArray[Any], quaternion: NDArray[Any]) -> Sequence[Any]:
    """Vertices and normals of a group in the world, for poses of all movers."""
    from esg.units import quat_rotate

    at, turn = position[group.mover], quaternion[group.mover]
    vertices = quat_rotate(turn, group.vertices.astype(np.float64)) + at
    normals = None
    if group.normals is not None:
        normals = quat_rotate(turn, group.normals.astype(np.float64)).astype(np.float32)
    return vertices.astype(np.float32), normals
