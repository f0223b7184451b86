"""How the bodies of a scene moved, as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import GROUND, Rollout, SimScene
from esg.outcomes import UserError

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Contact:
    """Two bodies that touch in one step.

    Args:
        time_s: End of the step [s].
        a: Name of the one.
        b: Name of the other; `ground` for the ground.
        impulse_ns: Normal impulse of the step [N s].
        depth_m: Largest penetration depth [m].
        point: Where they touch, in the world [m], shape [3].
        normal: Unit normal from b towards a, shape [3].
    """

    time_s: float
    a: str
    b: str
    impulse_ns: float
    depth_m: float
    point: tuple[float, float, float]
    normal: tuple[float, float, float]


@dataclass(frozen=True)
class Track:
    """How one body moved, T frames.

    Args:
        name: Of the body: its node in the scene graph.
        time: [s], shape [T].
        position: Of the centre of mass in the world, Z up [m], shape [T, 3].
        quaternion: (x, y, z, w), shape [T, 4].
        linear_velocity: Of the centre of mass [m/s], shape [T, 3].
        angular_velocity: In the world's frame [rad/s], shape [T, 3].
    """

    name: str
    time: Floats
    position: Floats
    quaternion: Floats
    linear_velocity: Floats
    angular_velocity: Floats

    @property
    def speed(self) -> Floats:
        """Of the centre of mass [m/s], shape [T]."""
        return np.linalg.norm(self.linear_velocity, axis=-1)


@dataclass(frozen=True)
class Trajectories:
    """How B bodies moved over T frames; columns of the arrays are in the order of `names`.

    Args:
        names: Of the bodies: their nodes in the scene graph.
        engine: That moved them: physx, rapier or newton.
        dt_s: Its physics step [s].
        time: Of the frames [s], shape [T].
        position: Of the centres of mass in the world, Z up [m], shape [T, B, 3].
        quaternion: (x, y, z, w), shape [T, B, 4].
        linear_velocity: Of the centres of mass [m/s], shape [T, B, 3].
        angular_velocity: In the world's frame [rad/s], shape [T, B, 3].
        rollout: What all this was taken from, with its contacts as columns.
    """

    names: tuple[str, ...]
    engine: str
    dt_s: float
    time: Floats
    position: Floats
    quaternion: Floats
    linear_velocity: Floats
    angular_velocity: Floats
    rollout: Rollout

    def of(self, name: str) -> Track:
        """The track of one body.

        Raises:
            UserError: If no body is called so.
        """
        if name not in self.names:
            raise UserError(f"no body {name!r} in this scene; it has {', '.join(self.names)}")
        k = self.names.index(name)
        states = (self.position, self.quaternion, self.linear_velocity, self.angular_velocity)
        return Track(name, self.time, *(column[:, k] for column in states))

    @cached_property
    def contacts(self) -> tuple[Contact, ...]:
        """Every pair that touches, step by step."""
        log = self.rollout.contacts.select(0)

        def name(index: int) -> str:
            return GROUND if index < 0 else self.names[index]

        return tuple(
            Contact(
                float(log.time[k]),
                name(int(log.a[k])),
                name(int(log.b[k])),
                float(log.impulse[k]),
                float(log.depth[k]),
                _triple(log.point[k]),
                _triple(log.normal[k]),
            )
            for k in range(len(log.time))
        )


def trajectories_of(scene: SimScene, rollout: Rollout) -> Trajectories:
    """The first world of a rollout.

    Args:
        scene: The bodies.
        rollout: Their motion.
    """
    return Trajectories(
        tuple(body.name for body in scene.bodies),
        rollout.engine,
        rollout.dt,
        rollout.time,
        rollout.position[0],
        rollout.quaternion[0],
        rollout.linear_velocity[0],
        rollout.angular_velocity[0],
        rollout,
    )


def _triple(values: NDArray[np.floating]) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
