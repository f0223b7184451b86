"""Contact sheets: every asset rendered in a tile, for looking at the library.

Ray-traced on the CPU by Newton's camera sensor; imported lazily, never by the pipeline's stages.
"""

from __future__ import annotations

from collections.abc import Sequence
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.mesh import build_mesh
from esg.assets.geometry.sketch import Color
from esg.graph.joints import child_frame
from esg.graph.models import AssetConfiguration, AssetRequirement, Joint
from esg.units import quat_rotate

if TYPE_CHECKING:
    from esg.assets.library.catalogue import Entry
    from esg.lexicon.articulations import Articulation

Pieces = list[tuple[NDArray[Any], NDArray[Any], Color]]
"""Vertices [m], triangles and colour of what is seen."""
UNLIMITED_DEG = 30.0
"""What has no limits is shown so far to either side."""

_FOV = 0.55
_SUPERSAMPLE = 3
"""Rays a pixel along each axis: thin rods would break up otherwise."""


def _merged(config: AssetConfiguration) -> Pieces:
    """The asset, parts of one colour together."""
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
    """One asset from several directions (`_render`)."""
    return _render(_merged(config), directions, size)


def _render(pieces: Pieces, directions: Sequence[Any], size: int) -> NDArray[np.uint8]:
    """Meshes from several directions.

    Args:
        pieces: What is seen.
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
    for vertices, faces, color in pieces:
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
    named = [(c.asset_name.split("/")[-1], _merged(c)) for c in configs]
    _sheet(named, path, columns, size)


def _sheet(named: Sequence[tuple[str, Pieces]], path: Path, columns: int, size: int) -> None:
    from PIL import Image, ImageDraw

    label = 12
    rows = math.ceil(len(named) / columns)
    sheet = Image.new("RGB", (columns * size, rows * (size + label)), "white")
    draw = ImageDraw.Draw(sheet)
    for i, (name, pieces) in enumerate(named):
        x, y = (i % columns) * size, (i // columns) * (size + label)
        tile = Image.fromarray(_render(pieces, [FRONT_LEFT], size * _SUPERSAMPLE)[0])
        sheet.paste(tile.resize((size, size), Image.Resampling.BOX), (x, y))
        draw.text((x + 3, y + size), name[: size // 6], fill="black")
    sheet.quantize(128).save(path, optimize=True)


def joints_sheet(path: Path, *, columns: int = 8, size: int = 120) -> int:
    """Writes the contact sheet of all jointed things, each at both ends of its joint.

    Returns:
        How many things it shows.
    """
    from esg.assets.library.catalogue import parts
    from esg.lexicon.articulations import articulations

    rows = list(dict.fromkeys(articulations().values()))
    named: list[tuple[str, Pieces]] = []
    for row in rows:
        ends = [_usual(parts()[n.replace(" ", "_")]) for n in (row.becomes, row.with_part)]
        parent, child = ends if row.carries == "becomes" else ends[::-1]
        for position in _extremes(row):
            seen = _merged(parent)
            for n in range(1, row.count + 1):
                at = position if n == 1 else row.start
                joint = Joint(
                    id="joint", kind=row.kind, parent="parent", child="child", upper=row.upper,
                    parent_mount=row.parent_mount.format(n=n), child_mount=row.child_mount,
                    position=at,
                )  # fmt: skip
                frame = child_frame(joint, parent, child)
                shift = np.asarray(frame.position) / 100.0
                seen += [
                    (quat_rotate(np.asarray(frame.quaternion), v) + shift, faces, color)
                    for v, faces, color in _merged(child)
                ]
            unit = "cm" if row.kind == "slider" else "deg"
            told = f" {position:g} {unit}"
            named.append((row.nouns[0][: size // 6 - len(told)] + told, seen))
    _sheet(named, path, columns, size)
    return len(rows)


def _extremes(row: Articulation) -> tuple[float, float]:
    """The positions between which a thing moves [deg or cm], or some to both sides."""
    if row.kind in ("hinge", "slider") and row.lower is not None and row.upper is not None:
        return row.lower, row.upper
    wide = row.upper if row.kind == "ball" and row.upper is not None else UNLIMITED_DEG
    return -wide, wide


def _usual(entry: Entry) -> AssetConfiguration:
    """A kind of the library as it usually is."""
    from esg.assets.stage import configure

    return configure(
        entry.name,
        AssetRequirement(
            asset_category=entry.name,
            asset_description=entry.description,
            expected_dimensions_cm=entry.dimensions_cm,
            expected_mass_kg=entry.mass_kg,
            is_movable=entry.movable,
        ),
    )


def library_sheet(path: Path, *, columns: int = 18, size: int = 96) -> int:
    """Writes the contact sheet of all parametric kinds that are no other kind's size.

    Returns:
        How many kinds it shows.
    """
    from esg.assets.library.catalogue import catalogue

    configs = [_usual(e) for e in catalogue() if "like" not in dict(e.params)]
    contact_sheet(configs, path, columns=columns, size=size)
    return len(configs)


if __name__ == "__main__":
    import sys

    joints = "--joints" in sys.argv
    written = joints_sheet(Path(sys.argv[1])) if joints else library_sheet(Path(sys.argv[1]))
    print(f"{written} kinds in {sys.argv[1]}")
