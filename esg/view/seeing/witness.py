"""What cameras see of a replay: its pictures, batch by batch, and the exact answers to them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import shown
from esg.engines.scene import Rollout, SimScene
from esg.view import truth
from esg.view.camera import Camera
from esg.view.cameras import Takes, action_cameras, directed
from esg.view.director.acting import Action
from esg.view.director.review import PROBE_PX, Viewfinder
from esg.view.director.staging import AUTO
from esg.view.director.takes import Take, standing
from esg.view.film.shooting import viewfinder
from esg.view.filmed import said_rate, said_take
from esg.view.parts import scene_parts
from esg.view.pieces import Movers, Part, clocked
from esg.view.renderers.kinds import kind_named
from esg.view.renderers.records import Quality, Scenery
from esg.view.renderers.shutter import at_times, poses_at
from esg.view.scenery import scenery_of, seen_from
from esg.view.seeing.wanted import Settings
from esg.view.truth import Pinhole, Poses
from esg.view.worlds import Views

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

Floats = NDArray[np.float64]
GPU_PIXELS, GPU_FRAMES = 1 << 23, (4, 128)
"""Of one launch on a GPU: pictures of so many pixels take about a gigabyte on the way."""
OFF_S = 5e-4
"""Frames of a recording that are farther from every 1/fps are moved there."""


@dataclass(frozen=True)
class Tracked:
    """Points that are fixed on bodies.

    Args:
        points: In body axes from the centre of mass [m], shape [p, 3].
        owner: Body of each, shape [p].
    """

    points: Floats
    owner: NDArray[np.int64]


@dataclass(frozen=True)
class Sight:
    """A replay as cameras see it.

    Args:
        scene: The bodies.
        rollout: Their motion, what is broken or not yet there out of sight.
        scenery: Meshes of them and of their place.
        settings: What is rendered.
        frames: Frames of the rollout that are pictures.
        takes: Ways of the cameras.
        angles: Of all wheels in all frames of the rollout [rad], shape [T, W].
        moved: Poses of bodies and wheels in the pictures, shapes [n, movers, 3] and
            [n, movers, 4].
        tracked: Points that are followed; none unless asked for.
    """

    scene: SimScene
    rollout: Rollout
    scenery: Scenery
    settings: Settings
    frames: list[int]
    takes: Takes
    angles: Floats
    moved: tuple[Floats, Floats]
    tracked: Tracked

    @property
    def time_s(self) -> Floats:
        """When each picture is taken [s], shape [n]."""
        return np.asarray(self.rollout.time, float)[self.frames]

    @cached_property
    def bounds(self) -> Floats:
        """Lower and upper corner of every body's surface in its own axes [m], shape [B, 2, 3]."""
        return np.array([_bounds(self, k) for k in range(len(self.scene.bodies))]).reshape(-1, 2, 3)


def sight_of(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    settings: Settings,
    *,
    cameras: Sequence[Camera] | None = None,
) -> Sight:
    """Directs the cameras of a replay and gathers what they see.

    Args:
        scene: The bodies.
        rollout: The replay; its first world.
        verdict: Events, for the cameras.
        doc: Asset configurations (meshes) and the place.
        settings: What to render.
        cameras: Fixed cameras; default those of the settings.
    """
    fps = settings.fps / said_rate(doc)
    played = at_rate(rollout, fps)
    frames = frame_indices(played, fps)
    times = np.asarray(played.time, float)[frames]
    takes = _takes(scene, rollout, verdict, doc, settings, cameras, times)
    scenery = scenery_of(scene, rollout, doc)
    rollout = shown(scene, played)
    angles = clocked(scene, rollout)
    movers = Movers(scenery.parts, len(scene.bodies))
    position, quaternion = rollout.position[0][frames], rollout.quaternion[0][frames]
    moved = movers.poses(position.astype(float), quaternion.astype(float), angles[frames])
    tracked = _tracked(scenery.parts, len(scene.bodies), settings)
    return Sight(scene, rollout, scenery, settings, frames, takes, angles, moved, tracked)


def frame_indices(rollout: Rollout, fps: float) -> list[int]:
    """Frames of the rollout nearest to every 1/fps, the first included."""
    time = np.asarray(rollout.time, float)
    wanted = _wanted(time, fps)
    right = np.clip(np.searchsorted(time, wanted), 0, len(time) - 1)
    left = np.maximum(right - 1, 0)
    return np.where(wanted - time[left] <= time[right] - wanted, left, right).tolist()


def _wanted(time: Floats, fps: float) -> Floats:
    return np.arange(math.floor(time[-1] * fps + 1e-6) + 1) / fps


def at_rate(rollout: Rollout, fps: float) -> Rollout:
    """The rollout, with frames at every 1/fps and no others if its own are elsewhere.

    Pictures 1/24 s apart of frames 1/60 s apart would jerk.
    """
    time = np.asarray(rollout.time, float)
    wanted = _wanted(time, fps)
    nearest = frame_indices(rollout, fps)
    if np.abs(time[nearest] - wanted).max() <= OFF_S:
        return rollout
    position, quaternion = at_times(rollout, wanted)
    return replace(
        rollout,
        time=wanted,
        position=position[None].astype(np.float32),
        quaternion=quaternion[None].astype(np.float32),
        linear_velocity=rollout.linear_velocity[:, nearest],
        angular_velocity=rollout.angular_velocity[:, nearest],
    )


def _takes(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    settings: Settings,
    cameras: Sequence[Camera] | None,
    times: Floats,
) -> Takes:
    """Cameras at the times of all pictures [s]."""
    width, height = settings.size
    if cameras or settings.camera == "around":
        around = partial(action_cameras, scene, rollout, verdict, doc, settings.cameras)
        return [standing(camera, times) for camera in cameras or around(width / height)]
    action = Action(scene, rollout, verdict, doc)
    finder = viewfinder(action, doc, scene_parts(scene, rollout, doc))
    finder = Viewfinder(
        action, finder.scan, (PROBE_PX[0], max(1, PROBE_PX[0] * height // width)), finder.around
    )
    auto = settings.camera == "auto"
    said = said_take(doc, scene, rollout, width / height) if auto else None
    kinds = AUTO if auto else (settings.camera,)
    takes = directed(finder, kinds, settings.cameras, settings.seed, said)
    return [take.at(times) for take in takes]


class Shot:
    """One camera's pictures, and what is exactly in them.

    Args:
        sight: What there is to see.
        take: The camera's way.
    """

    def __init__(self, sight: Sight, take: Take) -> None:
        self.sight, self.take = sight, take
        self._cameras = take.cameras
        still = Pinhole.of(self._cameras[0], sight.settings.size)
        self.holes = [
            still if c == self._cameras[0] else Pinhole.of(c, sight.settings.size)
            for c in self._cameras
        ]

    @cached_property
    def scenery(self) -> Scenery:
        """What there is to see without what stands before the camera."""
        sight = self.sight
        return seen_from(sight.scenery, _some(self._cameras), sight.scene, sight.rollout)

    def drawn(self) -> Iterator[tuple[range, Views]]:
        """Pictures, batch by batch: their numbers, and the views in that order."""
        sight, settings = self.sight, self.sight.settings
        wanted = set(settings.channels)
        color = "rgb" in wanted
        # Without colours there is nothing for the other renderers to do better.
        kind = kind_named(settings.renderer if color else "raster")
        quality = Quality(
            settings.size, settings.samples, settings.seed, settings.device,
            exact=wanted != {"rgb"}, color=color,
        )  # fmt: skip
        drawer = kind.load(self.scenery, quality)
        batch = _batch(kind.batch, settings)
        for first in range(0, len(sight.frames), batch):
            numbers = range(first, min(first + batch, len(sight.frames)))
            frames = [sight.frames[k] for k in numbers]
            poses = poses_at(sight.rollout, frames, sight.angles, settings.open_s)
            yield numbers, drawer.draw(poses, [self._cameras[k] for k in numbers])

    def flow(self, at: int, to: int, depth: NDArray[Any], mover: NDArray[Any]) -> Any:
        """Shifts of picture `at` to picture `to` [px], NaN where unknown, shape [H, L, 2]."""
        if not 0 <= to < len(self.holes):
            return np.full((*depth.shape, 2), np.nan, np.float32)
        other = self.holes[to] if self.holes[to] is not self.holes[at] else None
        return truth.flow(self.holes[at], depth, mover, self._poses(at), self._poses(to), other)

    def places(self, at: int, depth: NDArray[Any], views: Views, k: int) -> Any:
        """Where pixels lie on their bodies, as shares of the bodies' bounds, shape [H, L, 3]."""
        bounds = self.sight.bounds
        found = truth.body_points(self.holes[at], depth, views.mover[k], self._poses(at))
        body = np.maximum(views.body[k], 0)
        low, high = bounds[:, 0], bounds[:, 1]
        share = (found - low[body]) / np.maximum(high - low, 1e-9)[body]
        return np.where((views.body[k] >= 0)[..., None], share, np.nan).astype(np.float32)

    def boxes_3d(self, at: int) -> list[dict[str, Any]]:
        """Oriented boxes of all bodies."""
        bodies = self.sight.scene.bodies
        half = np.array([b.half_extents for b in bodies])
        offset = np.array([b.origin_offset for b in bodies])
        position, quaternion = (v[: len(bodies)] for v in self._poses(at))
        found = truth.boxes_3d(self.holes[at], half, offset, position, quaternion)
        return [_identified(b) for b in found]

    def boxes_2d(self, body: NDArray[Any]) -> list[dict[str, Any]]:
        """Boxes of what is visible of each body."""
        return [_identified(b) for b in truth.boxes_2d(body)]

    def tracks(self, at: int, depth: NDArray[Any], body: NDArray[Any]) -> tuple[Floats, Any]:
        """Pixels of the tracked points and whether they are visible."""
        tracked = self.sight.tracked
        return truth.track(
            self.holes[at], depth, body, tracked.owner, tracked.points, *self._poses(at)
        )

    def _poses(self, at: int) -> Poses:
        position, quaternion = self.sight.moved
        return position[at], quaternion[at]


def shots(sight: Sight) -> list[Shot]:
    """One shot a camera."""
    return [Shot(sight, take) for take in sight.takes]


def _batch(usual: int, settings: Settings) -> int:
    """Frames drawn at once: on a GPU what fills it and fits beside others, of any size."""
    if settings.device == "cpu" or usual == 1:
        return usual
    width, height = settings.size
    return int(np.clip(GPU_PIXELS // (width * height), *GPU_FRAMES))


def _some(cameras: Sequence[Camera]) -> list[Camera]:
    """At most eight of a take's cameras, the first one included."""
    return list(dict.fromkeys(cameras[:: max(1, len(cameras) // 7)]))


def _identified(box: dict[str, Any]) -> dict[str, Any]:
    return {"id": box["body"] + 2, **{k: v for k, v in box.items() if k != "body"}}


def _bounds(sight: Sight, body: int) -> Floats:
    vertices = [p.vertices for p in sight.scenery.parts if p.body == body and len(p.vertices)]
    if vertices:
        joined = np.concatenate(vertices)
        return np.array([joined.min(axis=0), joined.max(axis=0)])
    b = sight.scene.bodies[body]
    half, offset = np.asarray(b.half_extents, float), np.asarray(b.origin_offset, float)
    return np.array([offset - half * (1, 1, 0), offset + half * (1, 1, 2)])


def _tracked(parts: Sequence[Part], n_bodies: int, settings: Settings) -> Tracked:
    """Points spread over the bodies' surfaces, the same whichever camera looks."""
    points, owner = [np.zeros((0, 3))], []
    for body in range(n_bodies if "tracks" in settings.channels else 0):
        mine = [p for p in parts if p.body == body and p.wheel is None]
        if not mine:
            continue
        starts = np.cumsum([0, *(len(p.vertices) for p in mine[:-1])])
        vertices = np.concatenate([p.vertices for p in mine])
        faces = np.concatenate([p.faces + s for p, s in zip(mine, starts, strict=True)])
        rng = np.random.default_rng([settings.seed, body])
        points.append(truth.sample_points(vertices, faces, truth.TRACKS_PER_BODY, rng))
        owner += [body] * truth.TRACKS_PER_BODY
    return Tracked(np.concatenate(points), np.array(owner, np.int64))
