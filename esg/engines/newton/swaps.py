"""Bodies that change their posture, in the worlds of a Newton model.

Those that are not there are parked as fragments are (`esg.engines.newton.breaking`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.jobs import Job
from esg.engines.newton.breaking import tower
from esg.engines.newton.places import Numbers
from esg.engines.newton.setup import quiet_warp
from esg.engines.program import Action, Column
from esg.engines.shapes import SceneShapes

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

MOST_CHANGES = 8
"""Of one body in a scene."""
_COLUMNS = [Column.START, *range(Column.INTO, Column.FACING + 1)]


class Swaps:
    """Who changes his posture in all worlds of a model.

    Args:
        model: Newton's, finalized.
        shapes: Of its scenes.
        scene_of: Scene of each world, shape [W].
        dynamic: Number of each moving body, -1 for what stands still, shape [W, B].
    """

    def __init__(
        self, model: Any, shapes: list[SceneShapes], scene_of: Numbers, dynamic: NDArray[np.int32]
    ) -> None:
        self.wp = wp = quiet_warp()
        self._scene_of, self._shapes = scene_of, shapes
        towers = [tower(s) for s in shapes]
        own = [(w, k, s) for w, k in enumerate(scene_of) for s in shapes[k].stances]
        n, most = len(own), max(len(s.bodies) for _, _, s in own)
        member = np.full((n, most), -1, np.int32)
        pose = np.zeros((n, most, 7), np.float32)
        height = np.zeros((n, most), np.float32)
        for i, (w, k, s) in enumerate(own):
            m = len(s.bodies)
            member[i, :m] = dynamic[w, list(s.bodies)]
            pose[i, :m] = np.concatenate([s.local, s.turn], axis=1)
            height[i, :m] = [towers[k][b] for b in s.bodies]
        self.member = wp.array(member, dtype=int)
        self.pose = wp.array(pose, dtype=wp.transform)
        self.height = wp.array(height, dtype=float)
        self.time = wp.zeros((n, MOST_CHANGES), dtype=float)
        self.into = wp.zeros((n, MOST_CHANGES), dtype=int)
        self.placed = wp.zeros((n, MOST_CHANGES), dtype=int)
        self.place = wp.zeros((n, MOST_CHANGES), dtype=wp.transform)
        self.now = wp.zeros(n, dtype=int)
        joint_of = np.full(max(1, model.body_count), 0)
        joint_of[model.joint_child.numpy()] = np.arange(len(model.joint_child))
        self.first_q = wp.array(model.joint_q_start.numpy()[joint_of].astype(np.int32), dtype=int)

    def load(self, jobs: list[Job]) -> None:
        """Takes the times of the changes from the programs; everybody is as he starts.

        Args:
            jobs: One of each scene of the model.
        """
        time = np.full(self.time.shape, np.inf, np.float32)
        into, placed = np.zeros(self.into.shape, np.int32), np.zeros(self.into.shape, np.int32)
        place = np.zeros((*self.into.shape, 7), np.float32)
        first = np.searchsorted(self._scene_of, np.arange(len(self._shapes)))
        i = 0
        for w, k in enumerate(self._scene_of):
            job = jobs[k]
            for s in self._shapes[k].stances:
                rows = np.flatnonzero((job.kind == Action.CHANGE) & (job.body == s.bodies[0]))
                own = job.table[w - first[k], rows][:, _COLUMNS]
                own = own[np.argsort(own[:, 0], kind="stable")]
                if len(own) > MOST_CHANGES:
                    raise ValueError(f"{len(own)} changes of one body; at most {MOST_CHANGES}")
                time[i, : len(own)] = own[:, 0]
                into[i, : len(own)] = [s.bodies.index(int(b)) for b in own[:, 1]]
                placed[i, : len(own)] = np.isfinite(own[:, 2])
                place[i, : len(own), :3] = np.nan_to_num(own[:, 2:5])
                place[i, : len(own), 5], place[i, : len(own), 6] = (
                    np.sin(0.5 * own[:, 5]),
                    np.cos(0.5 * own[:, 5]),
                )
                i += 1
        self.time.assign(time)
        self.into.assign(into)
        self.placed.assign(placed)
        self.place.assign(place)
        self.now.zero_()

    def begin(self, worlds: NewtonWorlds, state: Any) -> None:
        """Before the programs act: who is due is swapped, who is not there is kept away."""
        from esg.engines.newton import break_kernels as kernels

        start = worlds.start if worlds.jointed is None else worlds.jointed.start
        self.wp.launch(
            kernels.change_bodies,
            dim=len(self.now),
            inputs=[
                worlds.clock, worlds.grid, self.time, self.into, self.placed, self.place, self.now,
                self.member, self.pose, self.height, self.first_q, start, state.body_q,
                state.body_qd, state.joint_q,
                state.joint_qd,
            ],
        )  # fmt: skip
