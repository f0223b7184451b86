"""Ropes, cones and joints outside of trees in a Newton model: contacts that nothing rubs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.engines.newton.places import Places
from esg.engines.newton.setup import BAUMGARTE, quiet_warp
from esg.engines.newton.trees import Poses, Tie, in_world

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

BREAK_STEPS = 64
"""Room for the steps of the window in which what breaks a joint adds up."""

Found = list[tuple[int, Tie]]
"""Ties or springs of all worlds, world by world, with the number of the world."""


def by_world(places: Places, of: str) -> Found:
    """`ties` or `springs` of all worlds."""
    return [(w, t) for w, k in enumerate(places.scene_of) for t in vars(places.plans[k])[of]]


def bodies_of(places: Places, found: Found, end: str) -> Any:
    """Body at one end of each, -1 for what does not move."""
    numbers = [places.number(w, getattr(t, end)) for w, t in found]
    return quiet_warp().array(np.array(numbers, np.int32), dtype=int)


def load_points(places: Places, found: Found, end: str, poses: list[Poses], target: Any) -> None:
    """Writes anchors: in the frames of bodies that move, else in the world."""
    first = np.searchsorted(places.scene_of, np.arange(len(places.plans)))
    points = np.zeros((len(found), 3), np.float32)
    for i, (w, tie) in enumerate(found):
        k = places.scene_of[w]
        body, point = getattr(tie, end), getattr(tie, f"point_{end}")
        if body >= 0 and places.local[k][body] < 0:
            own = poses[k][0][w - first[k], None], poses[k][1][w - first[k], None]
            point = in_world(own, body, point)[0]
        points[i] = point
    target.assign(points)


class Ties:
    """Ties of all worlds.

    Args:
        places: Where their bodies are.
        marks: Per world, the shape by which ties hold a body of its scene.
    """

    def __init__(self, places: Places, marks: list[dict[int, int]]) -> None:
        self.wp = wp = quiet_warp()
        self._places = places
        self.found = found = by_world(places, "ties")
        self._group_joints(places)

        def ints(values: list[int]) -> Any:
            return wp.array(np.array(values, np.int32), dtype=int)

        self.world = ints([w for w, _ in found])
        group = [self.groups[w, t.joint] for w, t in found]
        self.group = ints(group)
        self.first_tie = ints(np.searchsorted(group, np.arange(len(self.groups) + 1)).tolist())
        self.body_a, self.body_b = (bodies_of(places, found, end) for end in ("a", "b"))
        self.mark_a, self.mark_b = (
            ints([marks[w].get(getattr(t, end), -1) for w, t in found]) for end in ("a", "b")
        )
        self.longest = wp.array(np.array([t.length for _, t in found], np.float32), dtype=float)
        along = [np.zeros(3) if t.direction is None else t.direction for _, t in found]
        along = np.array(along, np.float32).reshape(-1, 3)
        self.direction = wp.array(along, dtype=wp.vec3)
        self.point_a, self.point_b = (wp.zeros(len(found), dtype=wp.vec3) for _ in range(2))
        self.solid = wp.zeros(1, dtype=int)

    def _group_joints(self, places: Places) -> None:
        """Joints of each world that are made of ties or keep their bodies apart until they break.

        Ties of a joint follow each other, and so do the joints of a world.
        """
        wp = self.wp
        self.groups: dict[tuple[int, int], int] = {}
        first, strength, pairs = [0], [], []
        for w, k in enumerate(places.scene_of):
            plan = places.plans[k]
            for joint in sorted({t.joint for t in plan.ties}):
                self.groups[w, joint] = len(self.groups)
                record = plan.joints[joint]
                brittle = record.break_impulse is not None
                strength.append(record.break_impulse if brittle else math.inf)
                tie = next(t for t in plan.ties if t.joint == joint)
                parted = brittle and not record.collide and tie.a >= 0
                pairs.append((tie.a, tie.b) if parted else (-2, -2))
            first.append(len(self.groups))
        n = len(self.groups)
        self.breaks = bool(np.isfinite(np.array(strength, float)).any())
        self.first_group = wp.array(np.array(first, np.int32), dtype=int)
        self.strength = wp.array(np.array(strength, np.float32), dtype=float)
        self.apart = wp.array(np.array(pairs, np.int32).reshape(-1, 2), dtype=int, ndim=2)
        self.broken = wp.zeros(n, dtype=int)
        self.taken = wp.zeros((n, BREAK_STEPS), dtype=wp.vec3)

    def load(self, poses: list[Poses]) -> None:
        """Writes anchors and mends what was broken."""
        for end, target in (("a", self.point_a), ("b", self.point_b)):
            load_points(self._places, self.found, end, poses, target)
        self.broken.zero_()
        self.taken.zero_()

    def hold(self, worlds: NewtonWorlds, state: Any) -> None:
        """After collisions were found: adds what holds to them."""
        from esg.engines.newton import joint_kernels as kernels

        c, launch = worlds.contacts, self.wp.launch
        launch(kernels.count_solid, dim=1, inputs=[c.rigid_contact_count, self.solid])
        if self.breaks:
            launch(
                kernels.part_joined,
                dim=c.rigid_contact_max,
                inputs=[
                    self.solid, self.first_group, self.apart, self.broken,
                    worlds.model.shape_world, worlds.shape_body, c.rigid_contact_shape0,
                    c.rigid_contact_shape1,
                ],
            )  # fmt: skip
        if self.found:
            launch(
                kernels.hold_ties,
                dim=len(self.found),
                inputs=[
                    self.solid, worlds.grid, worlds.model.gravity, BAUMGARTE, self.world,
                    self.group, self.body_a, self.body_b, self.mark_a, self.mark_b, self.point_a,
                    self.point_b, self.direction, self.longest, self.broken, state.body_q,
                    state.body_qd, c.rigid_contact_count, c.rigid_contact_shape0,
                    c.rigid_contact_shape1, c.rigid_contact_point0, c.rigid_contact_point1,
                    c.rigid_contact_normal, c.rigid_contact_margin0, c.rigid_contact_margin1,
                ],
            )  # fmt: skip

    def end(self, worlds: NewtonWorlds) -> None:
        """After the solver: what breaks."""
        from esg.engines.newton import joint_kernels as kernels

        if self.breaks:
            self.wp.launch(
                kernels.break_joints,
                dim=self.strength.shape[0],
                inputs=[
                    worlds.clock, self.solid, worlds.grid, BREAK_WINDOW_S, self.first_tie,
                    self.strength, worlds.observables.contact_f, self.taken, self.broken,
                ],
            )  # fmt: skip
