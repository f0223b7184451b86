"""Rollouts that were never simulated: boxes that do what a test says, and touch when it says."""

from __future__ import annotations

import numpy as np

from esg.dynamics.losses.recording import Recording
from esg.dynamics.story.story import Story
from esg.engines.scene import Body, ContactLog, Region, Rollout, Shape, SimScene

FPS = 60.0
UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
Row = tuple[float, int, int, float]


def box(name: str, x: float) -> Body:
    return Body(name, False, 1.0, UNIT, (Shape("box", (0.1, 0.1, 0.1)),), (x, 0.0, 0.1),
                half_extents=(0.1, 0.1, 0.1), category=name)  # fmt: skip


SCENE = SimScene(
    "s",
    (box("a", 0.0), box("b", 5.0), box("c", 10.0)),
    (Region("c/inside", "c", (0.0, 0.0, 0.0), (0.5, 0.5, 0.5), "inside"),),
)


def rollout(worlds: list[list[Row]], duration: float = 3.0, **series: np.ndarray) -> Rollout:
    """Bodies at rest far apart, and a contact log of (time, a, b, impulse) per world."""
    frames, n, count = round(duration * FPS) + 1, len(worlds), len(SCENE.bodies)
    rows = [(w, *row) for w, world in enumerate(worlds) for row in world]
    log = ContactLog(
        world=np.array([r[0] for r in rows], np.int32),
        frame=np.array([round(r[1] * FPS) for r in rows], np.int32),
        a=np.array([r[2] for r in rows], np.int32),
        b=np.array([r[3] for r in rows], np.int32),
        time=np.array([r[1] for r in rows], float),
        impulse=np.array([r[4] for r in rows], float),
        depth=np.zeros(len(rows)),
        point=np.zeros((len(rows), 3)),
        normal=np.tile([1.0, 0.0, 0.0], (len(rows), 1)),
    )
    at = np.array([b.position for b in SCENE.bodies])
    still = {
        "position": np.tile(at, (n, frames, 1, 1)).astype(np.float32),
        "quaternion": np.tile([0.0, 0.0, 0.0, 1.0], (n, frames, count, 1)).astype(np.float32),
        "linear_velocity": np.zeros((n, frames, count, 3), np.float32),
        "angular_velocity": np.zeros((n, frames, count, 3), np.float32),
    }
    return Rollout(
        engine="test",
        dt=1.0 / 240.0,
        time=np.arange(frames) / FPS,
        contacts=log,
        valid=np.ones(n, bool),
        **{**still, **series},
    )


def recording(rolled: Rollout) -> Recording:
    story = Story({}, {}, {}, {}, {}, {})
    return Recording(SCENE, story, rolled, [{} for _ in rolled.position])
