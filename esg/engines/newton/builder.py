"""Builders of Newton models whose worlds are those of several scenes: all that needs no GPU."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import CONTACT_GAP_M, quiet_warp
from esg.engines.newton.trees import Link, plan_trees
from esg.engines.shapes import Hull, SceneShapes

Wanted = tuple[tuple[int, int, int], ...]
"""Per scene of a model: its key, the number of its worlds and the factor on room for contacts."""

_GROUNDS = (-1, -2)
MARK = -3
"""Owner of a shape that touches nothing: ropes hold bodies by it."""
MARK_M = 1e-3


@dataclass
class Blueprint:
    """A model that has not been put on a device yet.

    Args:
        builder: Newton's `ModelBuilder` of all worlds.
        owners: Per scene, the body of every shape of a world; -1 and -2 for the grounds.
    """

    builder: Any
    owners: list[NDArray[np.int32]]


class Drafts:
    """Builders of the worlds of scenes, and blueprints made ahead of their use.

    Args:
        keep: Whether builders are kept for the next model of a scene.
    """

    def __init__(self, *, keep: bool) -> None:
        self.keep = keep
        self._meshes: dict[bytes, Any] = {}
        self._worlds: dict[int, tuple[Any, NDArray[np.int32]]] = {}
        self.ready: dict[Wanted, Blueprint] = {}

    def world(self, key: int, shapes: SceneShapes) -> tuple[Any, NDArray[np.int32]]:
        """The builder of one world of a scene, and the body of every shape."""
        if key in self._worlds:
            return self._worlds[key]
        wp = quiet_warp()
        import newton

        world = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=shapes.gravity)
        newton.solvers.SolverSteel.register_custom_attributes(world)
        config = newton.ModelBuilder.ShapeConfig(density=0.0, gap=CONTACT_GAP_M)
        meshes = self._meshes if self.keep else {}
        made = (world, _add_scene(wp, world, shapes, config, meshes))
        if self.keep:
            self._worlds[key] = made
        return made

    def prepare(self, wanted: Wanted, shapes: list[SceneShapes]) -> None:
        """Makes a blueprint that `take` will ask for."""
        self.ready[wanted] = self._make(wanted, shapes)

    def take(self, wanted: Wanted, shapes: list[SceneShapes]) -> Blueprint:
        """The blueprint of a model; it is made if nobody has prepared it."""
        ready = self.ready.pop(wanted, None)
        return self._make(wanted, shapes) if ready is None else ready

    def _make(self, wanted: Wanted, shapes: list[SceneShapes]) -> Blueprint:
        import newton

        gravity = shapes[0].gravity if shapes else (0.0, 0.0, -9.81)
        everything = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=gravity)
        newton.solvers.SolverSteel.register_custom_attributes(everything)
        owners = []
        for (key, worlds, _), s in zip(wanted, shapes, strict=True):
            world, own = self.world(key, s)
            owners.append(own)
            everything.replicate(world, worlds)
        return Blueprint(everything, owners)


def _add_scene(
    wp: Any, world: Any, s: SceneShapes, config: Any, meshes: dict[bytes, Any]
) -> NDArray[np.int32]:
    """Adds two grounds, bodies and shapes; returns the body of every shape.

    Wheeled bodies touch the second ground, all others the first. Bodies of trees get their joints
    once all bodies are there, and those with ties a mark that touches nothing.
    """
    plan = plan_trees(s.joints, s.ends, s.dynamic)
    linked = {link.child for link in plan.links}
    number: dict[int, int] = {}
    shapes: dict[int, list[int]] = {}
    grounds = [world.add_ground_plane(cfg=config) for _ in range(2)]
    touches = {False: grounds[1], True: grounds[0]}
    owners: list[int] = list(_GROUNDS)
    for b in range(s.n_bodies):
        if not s.collides[b]:
            continue
        owner = -1
        if not s.static[b]:
            add = world.add_link if b in linked else world.add_body
            owner = number[b] = add(
                xform=wp.transform_identity(),
                mass=float(s.mass[b]),
                inertia=wp.mat33(s.inertia[b].astype(np.float32).flatten()),
                lock_inertia=True,
            )
        for i in range(s.first[b], s.first[b + 1]):
            size, origin, turn = s.size[i].tolist(), s.origin[i].tolist(), s.rotation[i].tolist()
            shape = _add_shape(
                world, owner, s.kind[i], size, origin, turn, s.hulls[i], config, meshes
            )
            owners.append(b)
            shapes.setdefault(b, []).append(shape)
            world.add_shape_collision_filter_pair(shape, touches[bool(s.wheeled[b])])
    for a, b in plan.apart:
        for pair in product(shapes.get(a, ()), shapes.get(b, ())):
            world.add_shape_collision_filter_pair(*pair)
    for tree in plan.trees:
        world.add_articulation([_add_joint(wp, world, link, number) for link in tree])
    for b in plan.tied:
        if b in number:
            world.add_shape_sphere(number[b], radius=MARK_M, cfg=_mark())
            owners.append(MARK)
    return np.array(owners, np.int32)


def _mark() -> Any:
    import newton

    return newton.ModelBuilder.ShapeConfig(
        density=0.0, mu=0.0, restitution=0.0, has_shape_collision=False
    )


def _add_joint(wp: Any, world: Any, link: Link, number: dict[int, int]) -> int:
    """Adds the joint of a link; where it hangs on what does not move is written by each job."""
    child, record = number[link.child], link.record
    if record is None:
        return world.add_joint_free(child)
    ends = {
        "parent": -1 if link.parent < 0 else number[link.parent],
        "child": child,
        "parent_xform": wp.transform(record.parent_anchor, record.parent_rotation),
        "child_xform": wp.transform(record.child_anchor, record.child_rotation),
        "collision_filter_parent": False,
    }
    if record.kind in ("ball", "fixed"):
        add = {"ball": world.add_joint_ball, "fixed": world.add_joint_fixed}[record.kind]
        return add(**ends)
    add = {"hinge": world.add_joint_revolute, "slider": world.add_joint_prismatic}[record.kind]
    return add(
        **ends,
        axis=(1.0, 0.0, 0.0),
        limit_lower=-math.inf if record.lower is None else record.lower,
        limit_upper=math.inf if record.upper is None else record.upper,
        damping=0.0,
        armature=0.0,
        friction=0.0,
        target_ke=0.0,
        target_kd=0.0,
    )


def _add_shape(
    builder: Any,
    body: int,
    kind: str,
    size: tuple[float, ...],
    position: tuple[float, ...],
    quaternion: tuple[float, ...],
    convex: Hull | None,
    config: Any,
    meshes: dict[bytes, Any],
) -> int:
    """Adds a shape to a body of a Newton builder and returns its number.

    Args:
        builder: `newton.ModelBuilder`.
        body: Its number, -1 for the world.
        kind: As `Shape.kind`.
        size: As `Shape.size` [m].
        position: In the body's frame [m].
        quaternion: Orientation (x, y, z, w) in the body's frame.
        convex: Of convex shapes.
        config: `newton.ModelBuilder.ShapeConfig`.
        meshes: Hulls met so far; shapes of equal vertices share one.
    """
    import newton
    import warp as wp

    pose = wp.transform(wp.vec3(*position), wp.quat(*quaternion))
    x, y, z = size
    if kind == "sphere":
        return builder.add_shape_sphere(body, xform=pose, radius=x, cfg=config)
    if kind == "box":
        return builder.add_shape_box(body, xform=pose, hx=x, hy=y, hz=z, cfg=config)
    if kind == "capsule":
        return builder.add_shape_capsule(body, xform=pose, radius=x, half_height=z, cfg=config)
    if kind == "cylinder":
        return builder.add_shape_cylinder(body, xform=pose, radius=x, half_height=z, cfg=config)
    assert convex is not None
    vertices, faces = convex[0].astype(np.float32), convex[1].reshape(-1).astype(np.int32)
    key = vertices.tobytes()
    if key not in meshes:
        # Masses and inertias are given; Newton's own would cost a kernel launch per hull.
        meshes[key] = newton.Mesh(vertices, faces, compute_inertia=False)
    return builder.add_shape_convex_hull(body, xform=pose, mesh=meshes[key], cfg=config)
