"""What an export shows beside the bodies: ground, dressing, light from above, cameras."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.document import Corners
from esg.assets.gltf.surfaces import Surface, surface_of
from esg.assets.looks import Color, Look

if TYPE_CHECKING:
    from esg.view.pieces import Part
    from esg.view.surroundings import Sky

Floats = NDArray[np.float64]

CELLS = 16
"""Of the drawn ground along each side."""
SUNK, SUNK_M = 2e-5, 0.01
"""The drawn ground lies so much below what lies on it, by its side and at most [m]: whoever draws
by depth cannot tell them apart otherwise."""
CELL_M, MOST_CUTS = 25.0, 4
"""Longest edge of a triangle of a marking, and how often one is cut for it."""
MARKINGS = "ground/"
"""How the names of parts begin that lie on the ground."""
SPREAD = 4.0
"""So many times as far do markings of a ground lie apart from each other."""


@dataclass(frozen=True)
class View:
    """A camera that looks along its -Z with +Y up, still or moving.

    Args:
        name: Of the camera.
        time: When it is where [s], shape [T]; of a still one one instant.
        position: In the world [m], shape [T, 3].
        quaternion: (x, y, z, w), shape [T, 4].
        fov: Vertical field of view [rad].
        aspect: Width over height.
        near: Nearest of what it sees [m]: so far off that a centimetre on the ground is told apart.
    """

    name: str
    time: Floats
    position: Floats
    quaternion: Floats
    fov: float
    aspect: float = 1.5
    near: float = 0.05


@dataclass(frozen=True)
class Setting:
    """What is seen beside the bodies.

    Args:
        sky: Light from above.
        ground: The endless plane at z = 0.
        middle: Point of the plane that the action is about [m], shape [2].
        side: Of the square of it that is drawn [m].
        covered: Names of bodies in whose place the ground is seen.
        parts: Meshes fixed to the world, in its frame; those of one thing have names that are the
            same up to a slash. What lies on the ground has been `spread`.
        views: Cameras; the first is the one to look through.
        shows: Meshes that move by the time alone in the frames of their bodies, or of the world:
            lights, flames, what falls and what sways (`Part.act`).
        redrawn: Names of bodies that are drawn by these alone.
    """

    sky: Sky
    ground: Look
    middle: tuple[float, float] = (0.0, 0.0)
    side: float = 100.0
    covered: frozenset[str] = frozenset()
    parts: tuple[Part, ...] = ()
    views: tuple[View, ...] = ()
    shows: tuple[Part, ...] = ()
    redrawn: frozenset[str] = frozenset()


def seen_at(view: View, time: Floats) -> tuple[Floats, Floats]:
    """Poses of a camera at other instants: positions and quaternions, shapes [n, 3] and [n, 4].

    Args:
        view: The camera.
        time: [s], shape [n].
    """
    if len(view.time) == 1:
        return np.repeat(view.position, len(time), 0), np.repeat(view.quaternion, len(time), 0)
    turns = view.quaternion.copy()
    for k in range(1, len(turns)):  # the short way round
        if turns[k] @ turns[k - 1] < 0.0:
            turns[k] = -turns[k]

    def at(values: Floats) -> Floats:
        return np.stack([np.interp(time, view.time, column) for column in values.T], axis=1)

    turned = at(turns)
    return at(view.position), turned / np.linalg.norm(turned, axis=1, keepdims=True)


def ground_mesh(setting: Setting) -> tuple[Floats, NDArray[np.int64], Floats, Floats]:
    """The drawn ground: vertices [m], faces, normals and texture coordinates in tiles."""
    # Small cells in the middle: depth is not exact enough inside of what is larger than the view.
    line = np.linspace(-1.0, 1.0, CELLS + 1)
    line = np.sign(line) * line**2 * setting.side / 2
    y, x = np.meshgrid(line, line, indexing="ij")
    corners = np.stack([x.ravel(), y.ravel()], axis=1) + np.asarray(setting.middle)
    flat = [p for p in setting.parts if p.name.startswith(MARKINGS)]
    lowest = min([0.0, *(float(p.vertices[:, 2].min()) for p in flat)])
    height = np.full((len(corners), 1), lowest - min(SUNK_M, SUNK * setting.side))
    first = (np.arange(CELLS) + (CELLS + 1) * np.arange(CELLS)[:, None]).reshape(-1, 1)
    right, above = 1, CELLS + 1
    corner = np.array([0, right, right + above, 0, right + above, above])
    faces = (first + corner).reshape(-1, 3)
    normals = np.tile([0.0, 0.0, 1.0], (len(corners), 1))
    uvs = corners / setting.ground.tile_m
    return np.concatenate([corners, height], axis=1), faces, normals, uvs


def strength(rgb: Color) -> tuple[float, Color]:
    """A light's intensity and the colour that is left of it, whose largest channel is 1."""
    most = max(*rgb, 1e-9)
    red, green, blue = (c / most for c in rgb)
    return most, (red, green, blue)


def facing(direction: tuple[float, float, float]) -> Floats:
    """Quaternion (x, y, z, w) that turns +Z toward a unit vector, shape [4]."""
    x, y, z = direction
    if z < -1.0 + 1e-9:
        return np.array([1.0, 0.0, 0.0, 0.0])
    turn = np.array([-y, x, 0.0, 1.0 + z])
    return turn / np.linalg.norm(turn)


def spread(parts: Iterable[Part]) -> list[Part]:
    """The parts, with the markings of the ground in cells and farther apart below the highest."""
    parts = list(parts)
    flat = [p for p in parts if p.name.startswith(MARKINGS)]
    top = max((float(p.vertices[:, 2].max()) for p in flat), default=0.0)

    def lowered(part: Part) -> Part:
        z = part.vertices[:, 2:]
        lower = np.concatenate([part.vertices[:, :2], top + SPREAD * (z - top)], axis=1)
        return in_cells(replace(part, vertices=lower))

    return [lowered(p) if p.name.startswith(MARKINGS) else p for p in parts]


def in_cells(part: Part) -> Part:
    """A flat part whose triangles are cut into four until none is longer than `CELL_M`."""
    if part.normals is None or part.uvs is None:
        return part
    corners = np.concatenate([part.vertices, part.normals, part.uvs], axis=1)[part.faces]
    for _ in range(MOST_CUTS):
        edges = corners[:, :, :3] - np.roll(corners[:, :, :3], 1, axis=1)
        if not len(corners) or np.linalg.norm(edges, axis=2).max() <= CELL_M:
            break
        a, b, c = (corners[:, k] for k in range(3))
        d, e, f = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
        cut = [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        corners = np.concatenate([np.stack(three, axis=1) for three in cut])
    rows, faces = np.unique(corners.reshape(-1, 8), axis=0, return_inverse=True)
    return replace(
        part,
        vertices=rows[:, :3],
        faces=faces.reshape(-1, 3),
        normals=rows[:, 3:6],
        uvs=rows[:, 6:],
    )


def by_thing(parts: Iterable[Part]) -> dict[str, list[Part]]:
    """Parts of one thing together, in their order, by the name of the thing."""
    groups: dict[str, list[Part]] = {}
    for part in parts:
        thing = part.name.partition("/")[0] or "part"
        groups.setdefault("markings" if part.name.startswith(MARKINGS) else thing, []).append(part)
    return groups


def by_track(parts: Iterable[Part]) -> list[tuple[Part, ...]]:
    """Parts that move as one are together: those of one limb."""
    out: dict[object, list[Part]] = {}
    for number, part in enumerate(parts):
        tracked = part.act is not None and part.act.track is not None
        out.setdefault((part.body, part.act) if tracked else number, []).append(part)
    return [tuple(own) for own in out.values()]


def by_surface(parts: Iterable[Part]) -> list[tuple[Surface, Corners]]:
    """Parts of one surface together: vertices [m], faces, normals and texture coordinates."""
    groups: dict[tuple[Surface, bool, bool], list[Part]] = {}
    for part in parts:
        surface = surface_of(part.look or Look("", part.color), part.color)
        plain = part.uvs is None or surface.base is None
        groups.setdefault((surface, part.normals is None, plain), []).append(part)
    out: list[tuple[Surface, Corners]] = []
    for (surface, flat, plain), members in groups.items():
        starts = np.cumsum([0, *(len(m.vertices) for m in members[:-1])])
        faces = [m.faces + start for m, start in zip(members, starts, strict=True)]
        normals = None if flat else np.concatenate([_known(m.normals) for m in members])
        uvs = None if plain else np.concatenate([_known(m.uvs) for m in members])
        vertices = np.concatenate([m.vertices for m in members])
        out.append((surface, (vertices, np.concatenate(faces), normals, uvs)))
    return out


def _known(values: Floats | None) -> Floats:
    assert values is not None
    return values
