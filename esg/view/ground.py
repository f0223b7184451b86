"""The ground that a scene moves over: its colour, an endless plane, a checkerboard."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.compile.visuals.decals import is_ground
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument
from esg.view.pieces import Part

TILE_RAISE_M = 0.0002
"""Tiles lie so much above the plane: less than depth resolves, more than a ray's rounding."""
GROUND_RGB = {"indoor": (0.47, 0.41, 0.35), "outdoor": (0.36, 0.38, 0.36)}


def ground_color(scene: SimScene, doc: EsgDocument) -> Color:
    """Of the endless plane where nothing dresses it (sRGB)."""
    own = [b.color for b in scene.bodies if is_ground(b)]
    return own[-1] if own else GROUND_RGB[doc.scene_definition.scene_parameters.scene_type]


def span(rollout: Rollout) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Between which points of the plane nearly all happens [m], each of shape [2]."""
    span = rollout.position[0, :, :, :2].reshape(-1, 2)
    span = span[np.isfinite(span).all(axis=1)]
    low, high = np.percentile(span, [2, 98], axis=0).astype(np.float64)
    return low, high


def plane(middle: NDArray[np.float64], look: Look) -> Part:
    """The ground: a plane just below what is drawn at z = 0."""
    corner = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    flat = (corner - 0.5) * 900 + middle
    vertices = np.concatenate([flat, np.full((4, 1), -TILE_RAISE_M)], axis=1)
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return Part(-1, vertices, faces, shown(look), None, look, normals, flat / look.tile_m, "ground")


def shown(look: Look) -> Color:
    """The colour (sRGB) that a surface has on average."""
    from esg.assets.textures import linear, recipes, srgb

    if look.texture is None:
        return look.color
    light = linear(look.color) * linear(recipes()[look.texture].mean)
    red, green, blue = (float(c) for c in srgb(light))
    return red, green, blue


def checkerboard(rollout: Rollout, color: Color) -> tuple[Part, ...]:
    """As a sense of scale every second one of faint tiles of 1 m (or 0.25 m), at z = 0."""
    low, high = span(rollout)
    extent = float(np.max(high - low))
    tile = 0.25 if extent < 3 else 1.0
    margin = 14 * tile + 0.25 * extent
    start = np.floor((low - margin) / tile).astype(int)
    stop = np.ceil((high + margin) / tile).astype(int)
    if int(np.max(stop - start)) > 240:  # a runaway body: tiles around the origin only
        start, stop = np.array([-120, -120]), np.array([120, 120])
    corner = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    i, j = np.meshgrid(np.arange(start[0], stop[0]), np.arange(start[1], stop[1]), indexing="ij")
    cells = np.stack([i.ravel(), j.ravel()], axis=1)
    red, green, blue = (min(1.0, 1.1 * c) for c in color)
    # The others are the plane just below: every ray searches every mesh of the ground, so that
    # another one for them would cost a fifth of a picture.
    lighter = cells[cells.sum(axis=1) % 2 == 0]
    corners = ((lighter[:, None, :] + corner) * tile).reshape(-1, 2)
    flat = np.concatenate([corners, np.zeros((len(corners), 1))], axis=1)
    square = np.array([[0, 1, 2], [0, 2, 3]])
    faces = (square[None] + 4 * np.arange(len(lighter))[:, None, None]).reshape(-1, 3)
    return (Part(-1, flat, faces, (red, green, blue), name="ground/tiles"),)
