"""What creeps slowly on something else stays outside of it."""

from __future__ import annotations

import numpy as np

from esg.engines import get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.units import quat_from_euler_deg
from tests.engines.lab import ball

RADIUS = 0.108
PIN = (
    Shape("cylinder", (0.0258, 0.0258, 0.025), (0.0, 0.0, -0.1265)),
    Shape("cylinder", (0.057, 0.057, 0.065), (0.0, 0.0, -0.0365)),
    Shape("cylinder", (0.0275, 0.0275, 0.1005), (0.0, 0.0, 0.129)),
)
INERTIA = ((0.01305, 0.0, 0.0), (0.0, 0.01305, 0.0), (0.0, 0.0, 0.001925))


def test_a_slow_ball_does_not_sink_into_a_fallen_pin() -> None:
    """Kept manifolds of PhysX lost it, and a ball 8 cm deep is thrown out at 3 m/s."""
    rng = np.random.default_rng(1)
    bodies: list[Body] = []
    throws: list[SetVelocity] = []
    for k in range(30):
        y, yaw = 4.0 * k, rng.uniform(-30.0, 30.0)
        lying = tuple(quat_from_euler_deg(yaw, -90.0, 0.0).tolist())
        at = (RADIUS + 0.23 + rng.uniform(0.0, 0.2), y + rng.uniform(-0.04, 0.04), 0.06)
        bodies.append(
            ball(f"ball_{k}", RADIUS, 6.4, (0.0, y, RADIUS), friction=0.18, restitution=0.65)
        )
        bodies.append(
            Body(f"pin_{k}", False, 1.55, INERTIA, PIN, at, lying, friction=0.45, restitution=0.4)
        )
        v = rng.uniform(0.3, 1.5)
        throws.append(SetVelocity(f"ball_{k}", 0.0, (v, 0.0, 0.0), (0.0, v / RADIUS, 0.0)))
    scene = SimScene("pins", tuple(bodies))
    batch = batch_programs([Program(tuple(throws), 3.0)], scene.names)
    found = get_engine("physx").rollout(scene, batch, dt=1.0 / 240.0)
    assert len(found.contacts.depth) > 30
    assert float(found.contacts.depth.max()) < 0.005
