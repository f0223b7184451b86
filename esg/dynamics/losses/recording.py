"""A rollout seen through its story: series, times and members of its W worlds."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.story.story import Story
from esg.engines.joints import Joint, joint_poses, joint_state
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import TimelineNode

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


class Recording:
    """Rollout, scene and story, with what measuring them needs again and again.

    Attributes:
        n: Number of worlds W.
        t: Recorded times [s], shape [T].
        speed: Of every body [m/s], shape [W, T, B].
        times: Per world, the program's own times by node id [s].
        gaps: Surface distances measured so far, by what was asked for [m], shape [W, T].
    """

    def __init__(
        self, scene: SimScene, story: Story, rollout: Rollout, times: list[dict[str, float]]
    ) -> None:
        self.scene, self.story, self.r = scene, story, rollout
        self.n = rollout.position.shape[0]
        self.t = rollout.time
        self.fps = 1.0 / float(self.t[1] - self.t[0])
        self.times = times
        self.speed = np.linalg.norm(rollout.linear_velocity.astype(float), axis=-1)
        self.gaps: dict[object, Floats] = {}

    def program_time(self, node: TimelineNode) -> Floats:
        """The program's own time of an event [s], NaN if it sets none, shape [W]."""
        return np.array([t.get(node.id, np.nan) for t in self.times])

    def members(self, name: str) -> list[int]:
        """Body indices of an object, or of all members of its group."""
        return [self.scene.index(n) for n in self.story.expand(name) if n in self.scene.names]

    def opening(self, joint: Joint) -> Floats:
        """Position of a hinge or slider over time [rad or m], shape [W, T]."""
        poses = joint_poses(self.scene, joint, self.r.position, self.r.quaternion)
        state = joint_state(joint, *poses)
        return np.unwrap(state.position, axis=1) if joint.kind == "hinge" else state.position

    def late(self, earliest: Floats) -> Bools:
        """Frames at or after a time per world [s], shape [W, T]."""
        return self.t[None, :] >= earliest[:, None]

    def first(self, mask: Bools) -> Floats:
        """Time of the first true frame, inf if none, shape [W]."""
        return np.where(mask.any(axis=1), self.t[np.argmax(mask, axis=1)], np.inf)

    def at(self, series: Floats, time: Floats) -> Floats:
        """Value of [W, T] at a time per world, NaN for NaN times."""
        frame = np.clip(np.nan_to_num(time, nan=0.0, posinf=0.0) * self.fps, 0, len(self.t) - 1)
        value = series[np.arange(self.n), np.rint(frame).astype(int)]
        return np.where(np.isfinite(time), value, np.nan)

    def extreme(self, series: Floats, time: Floats, begin: float, end: float) -> Floats:
        """Largest value of [W, T] in a window after a time per world."""
        offsets = np.arange(math.floor(begin * self.fps), math.ceil(end * self.fps) + 1)
        stack = np.stack([self.at(series, time + k / self.fps) for k in offsets])
        return stack.max(axis=0)
