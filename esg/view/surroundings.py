"""What is around the bodies of a scene: sky, sun, ground and what only dresses the place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.lexicon.shown import weather_of

if TYPE_CHECKING:
    from esg.engines.scene import Rollout, SimScene
    from esg.graph.models import Dressing, EsgDocument
    from esg.view.camera import Camera
    from esg.view.pieces import Part

SkyKind = Literal["plain", "clear", "cloudy", "dusk", "night", "indoor"]
Vec = tuple[float, float, float]
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Sky:
    """Light from above.

    Args:
        kind: What the sky shows, and what lights a room.
        sun: Unit vector toward the sun, or toward the main lamp of a room.
        sun_rgb: Linear irradiance of it on a surface that faces it; 1 is white paper in daylight.
        ambient_rgb: Linear irradiance of everything else.
        zenith, horizon: Linear colours of the sky straight up and at the horizon.
        sight_m: Distance at which things are mostly gone in fog, rain or snow; 0 for clear air.
    """

    kind: SkyKind = "plain"
    sun: Vec = (0.5 / math.sqrt(2.0), 0.5 / math.sqrt(2.0), math.sqrt(0.75))
    sun_rgb: Color = (0.8, 0.78, 0.74)
    ambient_rgb: Color = (0.34, 0.36, 0.4)
    zenith: Color = (0.6, 0.7, 0.83)
    horizon: Color = (0.6, 0.7, 0.83)
    sight_m: float = 0.0


@dataclass(frozen=True)
class Surroundings:
    """Everything one sees that is no body of the physics.

    Args:
        sky: Its light.
        ground: The endless plane at z = 0.
        parts: Meshes fixed to the world (body -1): walls, kerbs, facades, trees, lamps. Their names
            begin with the id of the thing they are of, before a "/"; markings are "ground/...".
    """

    sky: Sky
    ground: Look
    parts: tuple[Part, ...] = ()

    def seen_from(self, cameras: Sequence[Camera], points: Floats) -> Surroundings:
        """Without the things that stand between cameras and what they are to show.

        Walls of a room and facades of a street are left out whole as soon as one looks through
        them from one of the eyes, as in a dollhouse, and so is what a camera stands in and what
        covers a part of its picture.

        Args:
            cameras: All that draw it.
            points: What they look at: a few points of the action [m], shape [m, 3].
        """
        eyes = np.unique([c.eye for c in cameras], axis=0)
        hidden = in_the_way(self.parts, eyes, np.atleast_2d(points))
        hidden |= before_the_picture(self.parts, cameras)
        return replace(self, parts=tuple(p for p in self.parts if thing_of(p) not in hidden))


GROUND = "ground"
"""What the parts of markings are of; they hide nothing."""
MOST_EYES, MOST_POINTS = 16, 40
"""Lines of sight of a shot are tried between so many of its eyes and points."""
RAYS = (12, 8)
"""Lines of sight all over a picture, along its width and height."""
SHORT_OF = 0.8
"""They end so far on the way to what it shows."""
COVERS = 0.03
"""Share of a picture from which on a thing before it is left out."""
FLAT_M = 0.4
"""What is thinner hides as its whole plane does: a fence of wires, a row of posts."""
SIGHTS, MOST_SIGHT_M = 4.5, 95.0
"""In any air one sees so many times as far as what is named is tall, at most so far [m]."""
NEAR_M = 0.6
"""A camera stands in what is nearer to it than this."""


def thing_of(part: Part) -> str:
    """Id of the thing of a dressing that a part belongs to."""
    return part.name.partition("/")[0]


def in_the_way(parts: Sequence[Part], eyes: Floats, points: Floats) -> frozenset[str]:
    """Things between eyes and points, and things in which an eye stands.

    Args:
        parts: Of surroundings.
        eyes: [m], shape [n, 3].
        points: [m], shape [m, 3].
    """
    from_eyes, to_points = _some(eyes, MOST_EYES), _some(points, MOST_POINTS)
    starts = np.repeat(from_eyes, len(to_points), axis=0)
    ends = np.tile(to_points, (len(from_eyes), 1))
    solid = [part for part in parts if thing_of(part) != GROUND]
    low, high = _boxes(solid)
    around = np.all((eyes > low - NEAR_M) & (eyes < high + NEAR_M), axis=-1)
    inside = np.asarray(np.any(around, axis=-1), bool)
    near = _crosses_box(starts, ends, low, high)
    found = {thing_of(part) for part, holds in zip(solid, inside, strict=True) if holds}
    for part, cross in zip(solid, near, strict=True):
        name = thing_of(part)
        if name in found or not cross.any():
            continue
        if _crosses(starts[cross], ends[cross], part.vertices[part.faces]):
            found.add(name)
    return frozenset(found)


def _boxes(parts: Sequence[Part]) -> tuple[Floats, Floats]:
    """Lowest and highest corners of parts [m], each of shape [n, 1, 3]."""
    corners = np.array([part.box for part in parts], float).reshape(-1, 2, 1, 3)
    return corners[:, 0], corners[:, 1]


def before_the_picture(parts: Sequence[Part], cameras: Sequence[Camera]) -> frozenset[str]:
    """Things that fill a part of a picture from nearer than what it is of.

    A wall at its edge, a fence all over it: rays go out all over the picture, to shortly before the
    distance of what it shows; wires and slats count as the plane they lie in.

    Args:
        parts: Of surroundings.
        cameras: At least one.
    """
    things: dict[str, list[int]] = {}
    for k, part in enumerate(parts):
        name = thing_of(part)
        if name != GROUND:
            things.setdefault(name, []).append(k)
    low, high = _boxes(parts)
    thin = (high - low).min(axis=(1, 2)) < FLAT_M
    found: set[str] = set()
    for camera in cameras:
        ends = camera.spread(RAYS, SHORT_OF)
        starts = np.repeat(np.array([camera.eye], float), len(ends), axis=0)
        near = _crosses_box(starts, ends, low, high)
        enough = COVERS * len(ends)
        for name in [n for n in things if n not in found]:
            # What is cheap comes first: most things have too few rays near them.
            members = things[name]
            if np.count_nonzero(near[members].any(axis=0)) < enough:
                continue
            met = np.array(np.any(near[[k for k in members if thin[k]]], axis=0))
            solid = [k for k in members if not thin[k]]
            for k, ray in zip(*np.nonzero(near[solid]), strict=True):
                if np.count_nonzero(met) >= enough:
                    break
                if not met[ray]:
                    corners = parts[solid[k]].vertices[parts[solid[k]].faces]
                    met[ray] = _crosses(starts[ray : ray + 1], ends[ray : ray + 1], corners)
            if np.count_nonzero(met) >= enough:
                found.add(name)
    return frozenset(found)


def _some(rows: Floats, most: int) -> Floats:
    """At most so many rows, evenly from all."""
    return rows[np.unique(np.linspace(0, len(rows) - 1, most).astype(int))]


def _crosses_box(starts: Floats, ends: Floats, low: Floats, high: Floats) -> NDArray[np.bool_]:
    """Which segments meet which boxes, shape [..., n] for boxes of shape [..., 1, 3]."""
    way = ends - starts
    way = np.where(np.abs(way) < 1e-9, 1e-9, way)
    near, far = (low - starts) / way, (high - starts) / way
    enter = np.minimum(near, far).max(axis=-1)
    leave = np.maximum(near, far).min(axis=-1)
    return (enter <= leave) & (leave >= 0.0) & (enter <= 1.0)


def _crosses(starts: Floats, ends: Floats, corners: Floats) -> bool:
    """Whether a segment meets a triangle (Moeller and Trumbore, 1997).

    Args:
        starts, ends: Of the segments, shape [n, 3].
        corners: Of the triangles, shape [m, 3, 3].
    """
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    for start, end in zip(starts, ends, strict=True):
        way = end - start
        p = np.cross(way, v)
        det = (u * p).sum(axis=1)
        safe = np.where(np.abs(det) < 1e-12, np.inf, det)
        s = start - a
        x = (s * p).sum(axis=1) / safe
        q = np.cross(s, u)
        y = (q @ way) / safe
        t = (v * q).sum(axis=1) / safe
        inside = np.abs(det) >= 1e-12
        if (inside & (x >= 0) & (y >= 0) & (x + y <= 1) & (t > 0) & (t < 1)).any():
            return True
    return False


def surroundings_of(doc: EsgDocument, scene: SimScene, rollout: Rollout) -> Surroundings:
    """What surrounds a scene: its dressing, or without one a plain ground with a checkerboard.

    Args:
        doc: The document.
        scene: Its bodies.
        rollout: Their motion: the checkerboard lies where they go.
    """
    from esg.view.ground import checkerboard, ground_color

    dressing = doc.dressing
    if dressing is None:
        color = ground_color(scene, doc)
        return Surroundings(
            in_weather(Sky(), scene), Look("", color, 0.9), checkerboard(rollout, color)
        )
    from esg.dressing.meshes import surface_look

    sky = in_weather(_sky(dressing), scene)
    return Surroundings(sky, surface_look(dressing.ground)[0], _standing(dressing))


def in_weather(sky: Sky, scene: SimScene) -> Sky:
    """A sky with the air of what falls or hangs in it."""
    told = [found for noun in scene.weather if (found := weather_of(noun)) is not None]
    sights = [row.sight_m / much for row, much in told]
    if not sights:
        return sky
    # What is tall is filmed from farther off, and is not to be lost in the air before that.
    tall = max((2.0 * b.half_extents[2] for b in scene.bodies if b.mentioned), default=0.0)
    return replace(sky, sight_m=max(min(sights), min(SIGHTS * tall, MOST_SIGHT_M)))


_last: list[tuple[Dressing, tuple[Part, ...]]] = []
"""The dressing whose parts were made last, which a scene's record asks for several times."""


def _standing(dressing: Dressing) -> tuple[Part, ...]:
    from esg.dressing.meshes import meshes_of
    from esg.view.pieces import Part

    for known, parts in _last:
        if known is dressing:
            return parts
    made = tuple(
        Part(-1, m.vertices, m.faces, m.color, None, m.look, m.normals, m.uvs, m.name)
        for m in meshes_of(dressing)
    )
    _last[:] = [(dressing, made)]
    return made


def _sky(dressing: Dressing) -> Sky:
    from esg.lexicon.places import skies

    row = skies()[dressing.sky]
    azimuth = math.radians(dressing.sun_azimuth_deg)
    elevation = math.radians(dressing.sun_elevation_deg)
    flat = math.cos(elevation)
    sun = (flat * math.cos(azimuth), flat * math.sin(azimuth), math.sin(elevation))
    return Sky(row.kind, sun, row.sun_rgb, row.ambient_rgb, row.zenith, row.horizon)
