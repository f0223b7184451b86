"""Contact sheets: every asset rendered in a tile, for looking at the library.

Ray-traced on the CPU by Newton's camera sensor; imported lazily, never by the pipeline's stages.
"""

from __future__ import annotations

from collections.abc import Sequence
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.mesh import build_mesh
from esg.assets.geometry.sketch import Color
from esg.graph.models import AssetConfiguration

_FOV = 0.55
_SUPERSAMPLE = 3
"""Rays a pixel along each axis: thin rods would break up otherwise."""


def _merged(
    config: AssetConfiguration,
) -> list[tuple[NDArray[Any], NDArray[Any], Color]]:
    """Vertices [m], triangles and colour of the asset, parts of one colour together."""
    groups: dict[Color, list[Any]] = {}
    parts: list[Any] = build_mesh(config).dump()
    for node in parts:
        material = getattr(node.visual, "material", None)
        color = _color(material)
        groups.setdefault(color, []).append(node)
    out = []
    for color, meshes in groups.items():
        vertices, faces, base = [], [], 0
        for mesh in meshes:
            vertices.append(np.asarray(mesh.vertices) / 100.0)
            faces.append(np.asarray(mesh.faces) + base)
            base += len(mesh.vertices)
        out.append((np.concatenate(vertices), np.concatenate(faces), color))
    return out


def _color(material: Any) -> Color:
    """One colour for a material: its texture's mean where it has one."""
    for name in ("image", "baseColorTexture"):
        image = getattr(material, name, None)
        if image is not None:
            pixels = np.asarray(image.convert("RGB").resize((16, 16)), float)
            red, green, blue = (round(float(c) / 255.0, 4) for c in pixels.reshape(-1, 3).mean(0))
            return (red, green, blue)
    factor = getattr(material, "baseColorFactor", None)
    if factor is None:
        factor = getattr(material, "main_color", [160, 160, 160, 255])
    red, green, blue = (round(float(c) / 255.0, 4) for c in factor[:3])
    return (red, green, blue)


def _look(eye: Any, target: Any) -> Any:
    import trimesh
    import warp as wp

    forward = np.asarray(target, float) - np.asarray(eye, float)
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    matrix = np.eye(4)
    matrix[:3, :3] = np.stack([right, np.cross(right, forward), -forward], 1)
    q = trimesh.transformations.quaternion_from_matrix(matrix)
    return wp.transform(wp.vec3(*eye), wp.quat(q[1], q[2], q[3], q[0]))


FRONT_LEFT = (0.78, 0.5, 0.42)


def render(config: AssetConfiguration, size: int = 160) -> NDArray[np.uint8]:
    """One asset from its front left, shape [size, size, 3]."""
    return render_views(config, [FRONT_LEFT], size)[0]


def render_views(
    config: AssetConfiguration, directions: Sequence[Any], size: int
) -> NDArray[np.uint8]:
    """One asset from several directions.

    Args:
        config: The asset.
        directions: From the asset's middle towards each camera, shape [n, 3].
        size: Pixels along each side.

    Returns:
        Images, shape [n, size, size, 3].
    """
    import newton
    from newton.sensors import SensorCamera
    import warp as wp

    setattr(wp.config, "quiet", True)  # noqa: B010  # Warp declares no options
    builder = newton.ModelBuilder()
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    # A fixed shape: nothing is simulated, so no mass is needed.
    for vertices, faces, color in _merged(config):
        low, high = np.minimum(low, vertices.min(0)), np.maximum(high, vertices.max(0))
        mesh = newton.Mesh(
            vertices.astype(np.float32), faces.flatten().astype(np.int32), compute_inertia=False
        )
        builder.add_shape_mesh(-1, mesh=mesh, color=color)
    span = float(np.linalg.norm(high - low))
    plate = newton.Mesh(
        np.array(
            [[x, y, -0.002 * span] for x, y in ((-9, -9), (9, -9), (9, 9), (-9, 9))], np.float32
        )
        * np.array([span, span, 1], np.float32),
        np.array([0, 1, 2, 0, 2, 3], np.int32),
        compute_inertia=False,
    )
    builder.add_shape_mesh(-1, mesh=plate, color=(0.86, 0.87, 0.88))
    model = builder.finalize(device="cpu")
    camera = SensorCamera(model)
    camera.create_default_light()
    rays = SensorCamera.compute_camera_rays_pinhole(
        size, size, camera_fov=_FOV, device=model.device
    )
    target = (low + high) / 2
    distance = 0.56 * span / math.tan(_FOV / 2)
    state = model.state()
    images = []
    for direction in np.asarray(directions, float):
        eye = target + direction / np.linalg.norm(direction) * distance
        pose = wp.array([_look(eye.tolist(), target)], dtype=wp.transformf, device="cpu")
        image: Any = camera.allocate_image_color(1, size, size)
        camera.update(state, pose, rays, color_image=image)
        packed = image.numpy().reshape(size, size)
        images.append(np.stack([packed & 255, (packed >> 8) & 255, (packed >> 16) & 255], -1))
    return np.stack(images).astype(np.uint8)


def contact_sheet(
    configs: Sequence[AssetConfiguration], path: Path, *, columns: int = 12, size: int = 120
) -> None:
    """Writes one PNG with a labelled tile an asset."""
    from PIL import Image, ImageDraw

    label = 12
    rows = math.ceil(len(configs) / columns)
    sheet = Image.new("RGB", (columns * size, rows * (size + label)), "white")
    draw = ImageDraw.Draw(sheet)
    for i, config in enumerate(configs):
        x, y = (i % columns) * size, (i // columns) * (size + label)
        tile = Image.fromarray(render(config, size * _SUPERSAMPLE))
        sheet.paste(tile.resize((size, size), Image.Resampling.BOX), (x, y))
        draw.text((x + 3, y + size), config.asset_name.split("/")[-1][: size // 6], fill="black")
    sheet.quantize(128).save(path, optimize=True)


def library_sheet(path: Path, *, columns: int = 18, size: int = 96) -> int:
    """Writes the contact sheet of all parametric kinds that are no other kind's size.

    Returns:
        How many kinds it shows.
    """
    from esg.assets.library.catalogue import catalogue
    from esg.assets.stage import configure
    from esg.graph.models import AssetRequirement

    configs = [
        configure(
            e.name,
            AssetRequirement(
                asset_category=e.name,
                asset_description=e.description,
                expected_dimensions_cm=e.dimensions_cm,
                expected_mass_kg=e.mass_kg,
                is_movable=e.movable,
            ),
        )
        for e in catalogue()
        if "like" not in dict(e.params)
    ]
    contact_sheet(configs, path, columns=columns, size=size)
    return len(configs)


if __name__ == "__main__":
    import sys

    print(f"{library_sheet(Path(sys.argv[1]))} kinds in {sys.argv[1]}")
