"""Exact penetration depth of two placed bodies, measured by PhysX's own contact generation."""

from __future__ import annotations

from typing import Any

import numpy as np

from esg.engines.scene import Shape

STEP_S = 1.0e-6
"""Step of the throw-away scene: too short for anything to move."""

Placed = tuple[Any, Any]
"""Position [m], shape [3], and quaternion (x, y, z, w), shape [4]."""


class PenetrationProbe:
    """Answers "how deep do these overlap" with a PhysX scene that holds just the two."""

    def __init__(self) -> None:
        self._system: Any = None
        self._scene: Any = None
        self._bodies: dict[int, Any] = {}

    def depth(
        self, key: int, shapes: tuple[Shape, ...], pose: Placed, probe: Shape, where: Placed
    ) -> float:
        """Depth [m], 0 if apart.

        Args:
            key: Identifies `shapes`, whose body is kept between calls.
            shapes: Of the body, in the frame that `pose` places.
            pose: Of the body.
            probe: A box, sphere or capsule.
            where: Pose of the probe.
        """
        from esg.engines.physx_engine import physx_module, to_pose

        px = physx_module()
        import sapien

        if self._system is None:
            self._system = px.PhysxCpuSystem()
            self._scene = sapien.Scene([self._system])
            self._scene.set_timestep(STEP_S)
        if key not in self._bodies:
            self._bodies[key] = self._component(px, shapes)
        first, second = self._bodies[key], self._component(px, (probe,))
        entities = []
        for component, placed in ((first, pose), (second, where)):
            entity = sapien.Entity()
            entity.add_component(component)
            entity.set_pose(to_pose(*placed))
            component.linear_velocity = component.angular_velocity = (0.0, 0.0, 0.0)
            self._scene.add_entity(entity)
            entities.append(entity)
        self._system.step()
        deepest = 0.0
        for contact in self._system.get_contacts():
            for point in contact.points:
                deepest = max(deepest, -float(point.separation))
        for entity, component in zip(entities, (first, second), strict=True):
            self._scene.remove_entity(entity)
            entity.remove_component(component)
        return deepest

    @staticmethod
    def _component(px: Any, shapes: tuple[Shape, ...]) -> Any:
        from esg.engines.physx_engine import make_shape

        component = px.PhysxRigidDynamicComponent()
        material = px.PhysxMaterial(0.0, 0.0, 0.0)
        for shape in shapes:
            component.attach(make_shape(px, shape, material))
        component.mass = 1.0
        component.inertia = np.ones(3, np.float32)
        component.disable_gravity = True
        return component
