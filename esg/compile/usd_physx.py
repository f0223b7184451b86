# pyright: reportAttributeAccessIssue=false
"""What UsdPhysics has no word for, in the attributes that NVIDIA's PhysX reads from USD.

They are plain attributes and names of applied schemas: any OpenUSD opens them, and simulators that
do not know them pass over them.
"""

from __future__ import annotations

from collections.abc import Mapping
import math
from typing import Any

from esg.engines.joints import Joint
from esg.engines.physx_engine import (
    BOUNCE_THRESHOLD_MPS,
    DEPENETRATION_MPS,
    VELOCITY_ITERATIONS,
    solver,
)
from esg.engines.scene import Body, SimScene

Paths = Mapping[str, str]

CONTACT_OFFSET_M = 0.05
"""Contacts are solved ahead of touching when bodies would touch within the step, so that they meet
without overlap: two bodies see each other at twice this distance."""
FASTEST_SPIN_RADPS = 1e6
HULL_VERTICES = 255
"""Of a convex hull at most; NVIDIA's USD takes 64."""


def physx_scene(prim: Any, scene: SimScene, dt: float) -> None:
    """Solver, step and thresholds of a PhysicsScene.

    The solver is the one with which the scene was proven. Of 24 oblique bounces in `ovphysx` 0.7
    all have the friction of the formula with PGS; with TGS and contacts solved ahead the median is
    33% off. A rod on a hinge let go at 120 degrees keeps 80% of its swing in 10 s with PGS, all of
    it with TGS.

    Args:
        prim: The PhysicsScene.
        scene: What is simulated.
        dt: Physics step [s].
    """
    _apply(
        prim,
        "PhysxSceneAPI",
        "physxScene",
        {
            "timeStepsPerSecond": round(1.0 / dt),
            "solverType": solver(scene),
            "bounceThreshold": BOUNCE_THRESHOLD_MPS,
            "enableCCD": False,
            "enableEnhancedDeterminism": True,
            "enableExternalForcesEveryIteration": False,
            "enableGPUDynamics": False,
            "broadphaseType": "MBP",
        },
    )


def physx_body(prim: Any, body: Body, iterations: int) -> None:
    """Damping [1/s], limits and solver of a moving body, and that its contacts are reported."""
    _apply(
        prim,
        "PhysxRigidBodyAPI",
        "physxRigidBody",
        {
            "linearDamping": float(body.linear_damping),
            "angularDamping": float(body.angular_damping),
            "maxAngularVelocity": math.degrees(FASTEST_SPIN_RADPS),
            "maxDepenetrationVelocity": DEPENETRATION_MPS,
            "sleepThreshold": 0.0,
            "solverPositionIterationCount": iterations,
            "solverVelocityIterationCount": VELOCITY_ITERATIONS,
            "enableGyroscopicForces": True,
        },
    )
    _apply(prim, "PhysxContactReportAPI", "physxContactReport", {"threshold": 0.0})


def physx_collider(prim: Any, hull: bool = False) -> None:
    """How far ahead a collider's contacts are solved [m]."""
    _apply(
        prim,
        "PhysxCollisionAPI",
        "physxCollision",
        {"contactOffset": CONTACT_OFFSET_M, "restOffset": 0.0},
    )
    if hull:
        _apply(
            prim,
            "PhysxConvexHullCollisionAPI",
            "physxConvexHullCollision",
            {"hullVertexLimit": HULL_VERTICES},
        )


def physx_material(prim: Any) -> None:
    """Friction and restitution of a pair are the average of the two."""
    _apply(
        prim,
        "PhysxMaterialAPI",
        "physxMaterial",
        {"frictionCombineMode": "average", "restitutionCombineMode": "average"},
    )


def physx_joint(prim: Any, joint: Joint) -> None:
    """Friction of a hinge, slider or ball joint."""
    _apply(prim, "PhysxJointAPI", "physxJoint", {"jointFriction": joint.friction})


def articulate(stage: Any, scene: SimScene, bodies: Paths, joints: Paths) -> None:
    """Puts what joints of two moving bodies hold together into articulations.

    Newton's importer takes such joints there alone. PhysX is told to make none of them: it solves
    joints one by one, as the engine does with which the scene was proven.

    Args:
        stage: With the joints.
        scene: Which has them.
        bodies, joints: Their prims by name.
    """
    from pxr import UsdPhysics

    moving = [b.name for b in scene.bodies if b.collides and not b.static]
    rigid = [j for j in scene.joints if not j.flexible]
    together = {name: {name} for name in moving}
    held: dict[str, Joint] = {}
    rings: list[Joint] = []
    for joint in (j for j in rigid if j.parent in together):
        one, two = together[joint.parent], together[joint.child]
        if one is two:
            rings.append(joint)
        one |= two
        together |= dict.fromkeys(two, one)
    trees = {id(t): t for t in together.values() if len(t) > 1}
    for joint in (j for j in rigid if j.parent not in together):
        tree = together[joint.child]
        if id(tree) in trees and held.setdefault(min(tree), joint) is not joint:
            rings.append(joint)
    carried = {j.child for j in rigid}
    for tree in trees.values():
        joint = held.get(min(tree))
        first = min(tree, key=lambda name: (name in carried, moving.index(name)))
        prim = stage.GetPrimAtPath(bodies[first] if joint is None else joints[joint.name])
        UsdPhysics.ArticulationRootAPI.Apply(prim)
        _apply(prim, "PhysxArticulationAPI", "physxArticulation", {"articulationEnabled": False})
    for joint in rings:
        prim = stage.GetPrimAtPath(joints[joint.name])
        UsdPhysics.Joint(prim).CreateExcludeFromArticulationAttr(True)


def physx_distance(prim: Any, joint: Joint) -> None:
    """That a spring is one, by its stiffness [N/m] and damping [N s/m]."""
    if joint.kind == "spring":
        _apply(
            prim,
            "PhysxPhysicsDistanceJointAPI",
            "physxPhysicsDistanceJoint",
            {
                "springEnabled": True,
                "springStiffness": joint.stiffness,
                "springDamping": joint.damping,
            },
        )


def _apply(prim: Any, schema: str, prefix: str, values: Mapping[str, Any]) -> None:
    from pxr import Sdf

    types = Sdf.ValueTypeNames
    of = {bool: types.Bool, int: types.Int, float: types.Float, str: types.Token}
    # The schemas need not be registered here: their names are data of the prim.
    prim.AddAppliedSchema(schema)
    for name, value in values.items():
        kind = types.UInt if name == "timeStepsPerSecond" else of[type(value)]
        prim.CreateAttribute(f"{prefix}:{name}", kind, custom=False).Set(value)
