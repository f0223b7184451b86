"""Bodies that break, in the worlds of a Newton model.

What is not there is parked high above the scene, without velocity, step by step: Newton's models
have a fixed number of bodies. A static body cannot be parked; its contacts are dropped.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking.swap import PARKED_M
from esg.engines.jobs import Job
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.engines.newton.places import Numbers
from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.ties import BREAK_STEPS
from esg.engines.newton.trees import Poses
from esg.engines.shapes import SceneShapes

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

_APART_M = 1.0
"""Between the surfaces of what is parked, at least."""


def tower(s: SceneShapes) -> dict[int, float]:
    """How high each body that breaks or changes and each fragment of a scene is parked [m]."""
    step = 4.0 * float(s.half.max(initial=0.0)) + _APART_M
    bodies = [i for b in s.brittle for i in (b.whole, *b.pieces)]
    bodies += [i for b in s.stances for i in b.bodies]
    return {body: PARKED_M + step * n for n, body in enumerate(bodies)}


def parked(job: Job, s: SceneShapes) -> Job:
    """A job whose fragments and later postures are parked from the start."""
    heights = tower(s)
    position = job.position.copy()
    for b in s.brittle:
        for piece in b.pieces:
            position[:, piece] = (0.0, 0.0, heights[piece])
    for stance in s.stances:
        for body in stance.bodies[1:]:
            position[:, body] = (0.0, 0.0, heights[body])
    return replace(job, position=position)


class Shatter:
    """What breaks in all worlds of a model.

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
        self.model = model
        self._shapes, self._scene_of = shapes, scene_of
        number = np.full(dynamic.shape, -1, np.int32)
        whole: list[int] = []
        strength: list[float] = []
        rows: list[tuple[int, int]] = []
        local: list[Any] = []
        turn: list[Any] = []
        for w, k in enumerate(scene_of):
            for b in shapes[k].brittle:
                number[w, b.whole] = len(whole)
                rows += [(len(whole), int(dynamic[w, p])) for p in b.pieces]
                local += [*b.local]
                turn += [*b.turn]
                whole.append(int(dynamic[w, b.whole]))
                strength.append(b.impulse)
        towers = [tower(s) for s in shapes]
        heights = [towers[k][p] for k in scene_of for b in shapes[k].brittle for p in b.pieces]
        heights_whole = [towers[k][b.whole] for k in scene_of for b in shapes[k].brittle]

        def ints(values: Any) -> Any:
            return wp.array(np.array(values, np.int32), dtype=int)

        def above(z: list[float]) -> Any:
            return wp.array(np.array([(0.0, 0.0, h) for h in z], np.float32), dtype=wp.vec3)

        n = len(whole)
        self.number = wp.array(number, dtype=int)
        self.whole, self.strength = (
            ints(whole),
            wp.array(np.array(strength, np.float32), dtype=float),
        )
        self.of, self.piece = ints([r[0] for r in rows]), ints([r[1] for r in rows])
        self.local = wp.array(np.array(local, np.float32), dtype=wp.vec3)
        self.turn = wp.array(np.array(turn, np.float32), dtype=wp.quat)
        self.parked, self.parked_whole = above(heights), above(heights_whole)
        self.still = wp.zeros(n, dtype=wp.transform)
        self.state, self.share = wp.zeros(n, dtype=int), wp.zeros(n, dtype=float)
        self.blow, self.taken = wp.zeros(n, dtype=wp.int64), wp.zeros((n, BREAK_STEPS), dtype=float)
        self.back = wp.zeros(max(1, model.body_count), dtype=float)
        self._drops = any(v < 0 for v in whole)
        joint_of = np.full(max(1, model.body_count), 0)
        joint_of[model.joint_child.numpy()] = np.arange(len(model.joint_child))
        self.first_q = ints(model.joint_q_start.numpy()[joint_of])

    def load(self, poses: list[Poses]) -> None:
        """Mends everything; writes where what stands still stands."""
        first = np.searchsorted(self._scene_of, np.arange(len(self._shapes)))
        still: list[Any] = []
        for w, k in enumerate(self._scene_of):
            for b in self._shapes[k].brittle:
                still.append(np.concatenate([a[w - first[k], b.whole] for a in poses[k]]))
        self.still.assign(np.array(still, np.float32))
        for array in self.states():
            array.zero_()

    def states(self) -> list[Any]:
        """Arrays that a step changes."""
        return [self.state, self.share, self.blow, self.taken, self.back]

    def drop(self, worlds: NewtonWorlds) -> None:
        """After collisions were found: what is broken touches nothing."""
        from esg.engines.newton import break_kernels as kernels

        c = worlds.contacts
        if self._drops:
            self.wp.launch(
                kernels.drop_gone,
                dim=c.rigid_contact_max,
                inputs=[
                    c.rigid_contact_count, self.state, self.number, worlds.model.shape_world,
                    worlds.shape_body, c.rigid_contact_shape0, c.rigid_contact_shape1,
                ],
            )  # fmt: skip

    def end(self, worlds: NewtonWorlds, count: Any, before: Any, after: Any) -> None:
        """After the solver: what breaks is swapped.

        Args:
            worlds: The model.
            count: Of contacts between bodies.
            before, after: States of the step.
        """
        from esg.engines.newton import break_kernels as kernels

        model, c, launch = worlds.model, worlds.contacts, self.wp.launch
        found = [count, c.rigid_contact_shape0, c.rigid_contact_shape1]
        press = [c.rigid_contact_normal, worlds.observables.contact_f]
        whose = [self.number, model.shape_world, worlds.shape_body]
        launch(
            kernels.gather_blows,
            dim=c.rigid_contact_max,
            inputs=[*found, worlds.grid, *press, *whose, self.blow],
        )
        launch(
            kernels.find_broken,
            dim=len(self.strength),
            inputs=[
                worlds.clock, worlds.grid, BREAK_WINDOW_S, self.strength, self.blow, self.taken,
                self.state, self.share,
            ],
        )  # fmt: skip
        start = worlds.start if worlds.jointed is None else worlds.jointed.start
        arrays = [after.body_q, after.body_qd]
        launch(
            kernels.share_out,
            dim=c.rigid_contact_max,
            inputs=[*found, worlds.grid, *press, *whose, model.shape_body, self.share, self.back],
        )
        launch(
            kernels.take_back,
            dim=model.body_count,
            inputs=[
                worlds.grid, model.gravity, self.back, before.body_qd, start, after.body_qd,
                after.joint_qd,
            ],
        )  # fmt: skip
        coordinates = [after.joint_q, after.joint_qd]
        launch(
            kernels.swap_pieces,
            dim=len(self.piece),
            inputs=[
                self.of, self.piece, self.local, self.turn, self.parked, self.whole, self.still,
                self.state, self.first_q, start, *arrays, *coordinates,
            ],
        )  # fmt: skip
        launch(
            kernels.park_wholes,
            dim=len(self.whole),
            inputs=[
                self.whole, self.parked_whole, self.state, self.first_q, start, *arrays,
                *coordinates,
            ],
        )  # fmt: skip
