"""A scenery as Mitsuba 3 wants it: shapes, materials and lamps."""

from __future__ import annotations

import ctypes.util
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
from esg.view.ground import TILE_RAISE_M
from esg.view.maps import linear, mean_color
from esg.view.renderers.groups import Group
from esg.view.skies import AIRS, lighting_map
from esg.view.surroundings import Sky
from esg.view.tracer.stage import BOUNCE, CLEAR

INSTALL = "pip install 'esg-scenes[render]'"
TEXTURE_PX = 512
GROUND_HALF_M = 1500.0
SUN_AWAY_M = 8000.0
NEAR_M = 0.01
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
        raise UserError(f"--renderer path needs Mitsuba: {INSTALL}") from None
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
        bent = _bitmap(mi, sloped(maps.normal, look.normal_strength), uv_scale)
        bsdf = {
            "type": "normalmap",
            "normalmap": bent,
            "use_shadowing_function": True,
            "bsdf": bsdf,
        }
    bsdf = {"type": "twosided", "bsdf": bsdf}
    if look.alpha < CLEAR:
        bsdf = {"type": "mask", "opacity": float(look.alpha), "bsdf": bsdf}
    return mi.load_dict(bsdf)


def sloped(normals: NDArray[np.uint8], strength: float) -> NDArray[np.float32]:
    """A normal map with its slopes multiplied, each value in [0, 1], shape [n, n, 3]."""
    found = (normals / 127.5 - 1.0) * (strength, strength, 1.0)
    found /= np.linalg.norm(found, axis=-1, keepdims=True)
    return (0.5 + 0.5 * found).astype(np.float32)


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
        "to_world": t.translate([0, 0, -TILE_RAISE_M]).scale([GROUND_HALF_M, GROUND_HALF_M, 1.0]),
        "bsdf": material(mi, look, 2 * GROUND_HALF_M / look.tile_m),
    }


def lamps(mi: Any, sky: Sky, ground: Look | None, seed: int) -> dict[str, Any]:
    """Sun and sky: together they light a surface as `Sky` says.

    The sun is a far disc, so that its shadows are as soft as in the other renderers.
    """
    below = np.array(BOUNCE) if ground is None else mean_color(ground.color, ground.texture)
    light = lighting_map(sky, seed, below)
    columns = light.shape[1]
    # Mitsuba's rows fall, and its columns go clockwise from +Y once its up is ours.
    turned = light[::-1, (3 * columns // 4 - 1 - np.arange(columns)) % columns]
    t = mi.ScalarTransform4f()
    air = AIRS[sky.kind]
    spread = math.tan(air.sun_radius)
    far = np.array(sky.sun) * SUN_AWAY_M
    across = [0.0, 0.0, 1.0] if abs(sky.sun[2]) < 0.9 else [1.0, 0.0, 0.0]
    place = t.look_at(origin=_floats(far), target=[0.0, 0.0, 0.0], up=across)
    return {
        "sky": {
            "type": "envmap",
            "bitmap": mi.Bitmap(np.ascontiguousarray(turned)),
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
            "near_clip": NEAR_M,
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
