"""Where the bodies and joints of scenes are in a Newton model of many worlds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.trees import Link, Trees

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class Places:
    """Numbers of bodies and joints in a model (K scenes, W worlds, D moving bodies).

    Args:
        plans: Joints of each scene, length K.
        scene_of: Scene of each world, shape [W].
        first_body: Number of each world's first body, shape [W + 1].
        local: Per scene, a body's number in its world, -1 for what does not move.
        joint_of: Newton's joint that moves a body, shape [D].
        q_start, qd_start: Where the coordinates and velocities of a joint begin.
    """

    plans: list[Trees]
    scene_of: Numbers
    first_body: Numbers
    local: list[Numbers]
    joint_of: Numbers
    q_start: Numbers
    qd_start: Numbers

    @staticmethod
    def of(
        model: Any,
        plans: list[Trees],
        scene_of: Numbers,
        first_body: Numbers,
        local: list[Numbers],
    ) -> Places:
        child = model.joint_child.numpy()
        joint_of = np.full(model.body_count, -1)
        joint_of[child] = np.arange(len(child))
        return Places(
            plans,
            scene_of,
            first_body,
            local,
            joint_of,
            model.joint_q_start.numpy(),
            model.joint_qd_start.numpy(),
        )

    @property
    def links(self) -> list[tuple[int, Link]]:
        """All links with their scenes."""
        return [(k, link) for k, plan in enumerate(self.plans) for link in plan.links]

    def worlds(self, k: int) -> Numbers:
        """Of a scene."""
        return np.nonzero(self.scene_of == k)[0]

    def numbers(self, k: int, body: int) -> Numbers:
        """A body of scene k in each of its worlds; -1 where it does not move."""
        rows = self.worlds(k)
        own = self.local[k][body] if body >= 0 else -1
        return self.first_body[rows] + own if own >= 0 else np.full(len(rows), -1)

    def number(self, world: int, body: int) -> int:
        """A body in a world; -1 if it does not move."""
        own = self.local[self.scene_of[world]][body] if body >= 0 else -1
        return int(self.first_body[world] + own) if own >= 0 else -1
