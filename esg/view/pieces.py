"""What is drawn: triangle meshes fixed to bodies, to wheels that turn on them, or to the world."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.engines.breaking.swap import HIDDEN_M
from esg.engines.scene import Rollout, SimScene
from esg.engines.wheels import about_axle, scene_angles
from esg.units import quat_from_down, quat_multiply, quat_rotate


@dataclass(frozen=True)
class Turning:
    """What turns on a body: wheel number `index` of the scene, about Y of the body through `axle`.

    Args:
        index: Among all wheels of the scene, in the order of their bodies.
        axle: In the body's frame [m], shape [3].
    """

    index: int
    axle: tuple[float, float, float]


@dataclass(frozen=True)
class Strand:
    """A piece of a rope or spring, which keeps its length: pieces slide over each other.

    Args:
        bodies: That its ends are fixed to, -1 for the world.
        anchors: Its ends in the bodies' frames [m].
        length: Of the piece [m], from 0 to -Z in its own frame.
        share: Of the way from the first to the last place of a piece.
        longest: A rope with ends farther apart has broken and is not there [m].
    """

    bodies: tuple[int, int]
    anchors: tuple[tuple[float, float, float], tuple[float, float, float]]
    length: float
    share: float
    longest: float


@dataclass(frozen=True, eq=False)
class Track:
    """Poses in a body's frame at instants, straight from one to the next.

    Args:
        time_s: Ascending [s], shape [T].
        at: Where the frame's origin goes [m], shape [T, 3].
        turn: How it is turned (x, y, z, w), shape [T, 4]; neighbours are of one sign.
    """

    time_s: NDArray[np.float64]
    at: NDArray[np.float64]
    turn: NDArray[np.float64]

    def of(self, time: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses at times [s], shapes [..., 3] and [..., 4]."""
        both = np.concatenate([self.at, self.turn], axis=1)
        found = np.stack([np.interp(time, self.time_s, column) for column in both.T], axis=-1)
        turn = found[..., 3:]
        return found[..., :3], turn / np.linalg.norm(turn, axis=-1, keepdims=True)


@dataclass(frozen=True)
class Act:
    """How a part moves in its body's frame by the time alone, and when it is there.

    Args:
        there: Intervals in which it is seen [s]; None is always.
        period_s, phase: Of what it does [s, rad].
        angle, lean: Largest angle that it swings by about Y through `pivot`, and what it swings
            about [rad].
        pivot: In the body's frame [m].
        shift: Largest way that it is moved by [m].
        drift: Velocity [m/s], over and over for `period_s`.
        track: Where it is instead of all that; None for what repeats itself.
    """

    there: tuple[tuple[float, float], ...] | None = None
    period_s: float = 1.0
    phase: float = 0.0
    angle: float = 0.0
    lean: float = 0.0
    pivot: tuple[float, float, float] = (0.0, 0.0, 0.0)
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    drift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    track: Track | None = None

    def seen(self, time: NDArray[Any]) -> NDArray[np.bool_]:
        """Whether it is there at times [s], shape [...]."""
        out = np.full(np.shape(time), self.there is None)
        for a, b in self.there or ():
            out |= (time >= a - 1e-9) & (time < b - 1e-9)
        return out

    def local(self, time: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses in the body's frame [m] at times [s], shapes [..., 3] and [..., 4]."""
        time = np.asarray(time, float)
        if self.track is not None:
            return self.track.of(time)
        wave = np.sin(2.0 * np.pi * time / self.period_s + self.phase)[..., None]
        turn = about_axle(self.lean + self.angle * wave[..., 0])
        pivot = np.asarray(self.pivot)
        at = pivot - quat_rotate(turn, np.broadcast_to(pivot, (*time.shape, 3)))
        at = at + wave * np.asarray(self.shift)
        return at + np.mod(time, self.period_s)[..., None] * np.asarray(self.drift), turn


@dataclass(frozen=True)
class Part:
    """One coloured triangle mesh, fixed to a body or (body -1) to the world.

    Args:
        body: Index of the body, -1 for the world.
        vertices: In the body's frame [m], shape [n, 3].
        faces: Vertex indices, counter-clockwise seen from outside, shape [m, 3].
        color: sRGB in [0, 1].
        wheel: The wheel it is a part of, which turns on the body.
        look: Its surface; None for a plain one in its colour.
        normals: Unit normals at the vertices, shape [n, 3]; None for flat faces.
        uvs: Texture coordinates at the vertices in tiles, v up, shape [n, 2]; None if untextured.
        name: Of the part in its asset.
        strand: The piece of a rope that it is; its body is -1.
        act: How it moves by the time alone; None is fixed to its body.
    """

    body: int
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    color: tuple[float, float, float]
    wheel: Turning | None = None
    look: Look | None = None
    normals: NDArray[np.float64] | None = None
    uvs: NDArray[np.float64] | None = None
    name: str = ""
    strand: Strand | None = None
    act: Act | None = None

    @cached_property
    def box(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lowest and highest corner in the body's frame [m], each of shape [3]."""
        return self.vertices.min(axis=0), self.vertices.max(axis=0)


class Movers:
    """What has a pose of its own: all bodies, the wheels that turn on them, and pieces of ropes.

    Args:
        parts: Meshes of the scene.
        n_bodies: Number of bodies B that `Part.body` refers to.
    """

    def __init__(self, parts: Iterable[Part], n_bodies: int) -> None:
        self._n_bodies = n_bodies
        parts = list(parts)
        turning = {p.wheel: p.body for p in parts if p.wheel is not None}
        self._wheels = sorted(turning, key=lambda w: w.index)
        self._carriers = [turning[w] for w in self._wheels]
        self._axles = np.array([w.axle for w in self._wheels]).reshape(-1, 3)
        self._indices = [w.index for w in self._wheels]
        self._strands = [p.strand for p in parts if p.strand is not None]
        acting = ((p.act, p.body) for p in parts if p.act is not None)
        self._acts = list(dict.fromkeys(acting))

    def __len__(self) -> int:
        return self._n_bodies + len(self._wheels) + len(self._strands) + len(self._acts)

    @property
    def bodies(self) -> list[int]:
        """Body of everything that has a pose; ropes belong to the world."""
        ropes = (-1 for _ in self._strands)
        return [*range(self._n_bodies), *self._carriers, *ropes, *(b for _, b in self._acts)]

    def of(self, part: Part) -> int:
        """Index of the pose that moves a part; -1 for the world."""
        if part.strand is not None:
            return self._n_bodies + len(self._wheels) + self._strands.index(part.strand)
        if part.act is not None:
            first = self._n_bodies + len(self._wheels) + len(self._strands)
            return first + self._acts.index((part.act, part.body))
        if part.wheel is None:
            return part.body
        return self._n_bodies + self._wheels.index(part.wheel)

    def poses(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses of everything for poses of the bodies.

        Args:
            position: Body origins [m], shape [..., B, 3].
            quaternion: (x, y, z, w), shape [..., B, 4].
            angles: Of all wheels of the scene [rad], and the time [s] (`clocked`), shape
                [..., W + 1]; None for none turned, at the start.

        Returns:
            Positions and quaternions of bodies and wheels, both in the body's frame at angle 0,
            of pieces of ropes, and of what acts.
        """
        out = [(position, quaternion)]
        if self._wheels:
            out.append(self._turned(position, quaternion, angles))
        if self._strands:
            out.append(self._hung(position, quaternion))
        if self._acts:
            out.append(self._acted(position, quaternion, angles))
        if len(out) == 1:
            return out[0]
        at, turned = zip(*out, strict=True)
        return np.concatenate(at, axis=-2), np.concatenate(turned, axis=-2)

    def _turned(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses of the wheels."""
        at, q = position[..., self._carriers, :], quaternion[..., self._carriers, :]
        turned = q
        if angles is not None:
            turned = quat_multiply(q, about_axle(angles[..., self._indices]))
        return at + quat_rotate(q, self._axles) - quat_rotate(turned, self._axles), turned

    def _acted(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses of what moves by the time alone; out of sight while it is not there."""
        time = np.zeros(position.shape[:-2]) if angles is None else angles[..., -1]
        at: list[NDArray[Any]] = []
        turned: list[NDArray[Any]] = []
        for act, body in self._acts:
            moved, turn = act.local(time)
            if body >= 0:
                q = quaternion[..., body, :]
                moved = position[..., body, :] + quat_rotate(q, moved)
                turn = quat_multiply(q, turn)
            at.append(moved - ~act.seen(time)[..., None] * np.array([0.0, 0.0, HIDDEN_M]))
            turned.append(turn)
        return np.stack(at, axis=-2), np.stack(turned, axis=-2)

    def _hung(
        self, position: NDArray[Any], quaternion: NDArray[Any]
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses of the pieces of ropes: in a row from end to end."""
        bodies = np.array([s.bodies for s in self._strands])
        anchors = np.array([s.anchors for s in self._strands])
        length, share, longest = np.array(
            [(s.length, s.share, s.longest) for s in self._strands]
        ).T[..., None]  # fmt: skip
        held = position[..., bodies, :] + quat_rotate(quaternion[..., bodies, :], anchors)
        ends = np.where(bodies[..., None] < 0, anchors, held)
        along = ends[..., 1, :] - ends[..., 0, :]
        apart = np.linalg.norm(along, axis=-1, keepdims=True)
        down = np.where(apart > 0, along / np.where(apart > 0, apart, 1.0), (0.0, 0.0, -1.0))
        at = ends[..., 0, :] + down * np.maximum(apart - length, 0.0) * share
        at[..., 2] -= HIDDEN_M * (apart > longest)[..., 0]
        return at, quat_from_down(down)


def clocked(scene: SimScene, rollout: Rollout) -> NDArray[np.float64]:
    """Angles of all wheels [rad], and the time [s], in all frames, shape [T, W + 1]."""
    time = np.asarray(rollout.time, float)[:, None]
    return np.concatenate([scene_angles(scene, rollout), time], axis=1)
