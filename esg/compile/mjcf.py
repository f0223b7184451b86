"""MuJoCo XML of a scene: bodies, masses, materials and start velocities.

What MuJoCo cannot represent is said in the file itself: it has no coefficient of restitution,
takes the larger of two frictions instead of the average, and a free joint has no damping; those
values stand in `<custom>`. The control program is not part of MJCF: `manifest.json` holds it.
"""

from __future__ import annotations

import json
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from esg.compile import names
from esg.engines import starts
from esg.engines.manifest import Manifest
from esg.engines.program import batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.engines.worlds import cylinder_vertices, principal_axes
from esg.units import quat_rotate

NOTES = (
    "Friction: MuJoCo takes the larger of two frictions, the scene the average. Each body carries "
    "the average with the ground it touches, both grounds carry 0: exact against the ground, an "
    "approximation between bodies.",
    "Restitution: MuJoCo has no coefficient of restitution; contacts do not bounce. The values "
    "stand in custom numerics restitution_<body>.",
    "Damping: a free joint has none; linear and angular damping [1/s] stand in custom numerics "
    "damping_<body>. Apply v *= max(0, 1 - c dt) each step to match.",
    "Program: the key frame holds the velocities at time 0; later commands are in manifest.json.",
)
TYRES_NOTE = (
    "Tyres: no part of MJCF; without them a wheeled body slides sideways as easily as it rolls. "
    "The conventions of manifest.json say what they do."
)
_NORMAL, _WHEELS = 1, 2
GROUND_SIZE_M = 100.0
"""Half side of the drawn ground; collision is with the whole plane."""


def scene_mjcf(manifest: Manifest) -> str:
    """The scene of a manifest as MJCF text; the same manifest gives the same text."""
    scene = manifest.scene
    idents = names.unique_identifiers(scene.names)
    root = ET.Element("mujoco", model=names.comment(scene.scene_id) or "scene")
    tyres = (TYRES_NOTE,) if any(b.tyre_friction > 0.0 for b in scene.bodies) else ()
    root.append(ET.Comment(" " + " ".join((*NOTES, *tyres)) + " "))
    ET.SubElement(root, "compiler", angle="radian", autolimits="true")
    ET.SubElement(
        root, "option", timestep=_n(manifest.dt), gravity=_v(scene.gravity), cone="elliptic"
    )
    assets = ET.SubElement(root, "asset")
    world = ET.SubElement(root, "worldbody")
    ET.SubElement(world, "light", pos="0 0 20", dir="0 0 -1", directional="true")
    for name, kind in (("ground", _NORMAL), ("vehicle_ground", _WHEELS)):
        ET.SubElement(
            world, "geom", name=name, type="plane", size=f"{GROUND_SIZE_M} {GROUND_SIZE_M} 1",
            contype="0", conaffinity=str(kind), friction="0 0 0", rgba="0.6 0.6 0.6 1",
            group="0" if kind == _NORMAL else "5",
        )  # fmt: skip
    custom = ET.SubElement(root, "custom")
    qpos: list[float] = []
    qvel: list[float] = []
    start = start_velocities(manifest)
    for body in scene.bodies:
        name = idents[body.name]
        element = ET.SubElement(
            world, "body", name=name, pos=_v(body.position), quat=_q(body.quaternion)
        )
        if body.collides and not body.static:
            ET.SubElement(element, "freejoint", name=f"{name}_free")
            moments, axes = principal_axes(np.asarray(body.inertia, float))
            ET.SubElement(
                element, "inertial", pos="0 0 0", quat=_q(axes), mass=_n(body.mass),
                diaginertia=_v(moments),
            )  # fmt: skip
            linear, angular = start.get(body.name, ((0.0,) * 3, (0.0,) * 3))
            x, y, z, w = body.quaternion
            qpos += [*body.position, w, x, y, z]
            # MuJoCo keeps a free joint's angular velocity in the body's own frame.
            qvel += [*linear, *quat_rotate((-x, -y, -z, w), angular).tolist()]
        for number, shape in enumerate(body.shapes):
            _geom(element, assets, f"{name}_{number}", shape, body, scene)
        damping = f"{_n(body.linear_damping)} {_n(body.angular_damping)}"
        ET.SubElement(custom, "numeric", name=f"restitution_{name}", data=_n(body.restitution))
        ET.SubElement(custom, "numeric", name=f"damping_{name}", data=damping)
        ET.SubElement(custom, "text", name=f"body_{name}", data=_text(body.name))
    if qpos:
        keys = ET.SubElement(root, "keyframe")
        ET.SubElement(keys, "key", name="start", qpos=_v(qpos), qvel=_v(qvel))
    ET.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(root, "unicode") + "\n"


def start_velocities(manifest: Manifest) -> dict[str, tuple[Any, Any]]:
    """Linear [m/s] and angular [rad/s] velocity of each body that the first step is given."""
    bodies = manifest.scene.bodies
    batch = batch_programs([manifest.program], manifest.scene.names)
    mass = np.array([[b.mass for b in bodies]])
    given = starts.start_velocities(batch, mass, manifest.dt)
    due = {p.body for p in manifest.program.primitives if p.time <= manifest.dt / 2}
    return {
        b.name: (tuple(linear.tolist()), tuple(angular.tolist()))
        for b, linear, angular in zip(bodies, *(v[0] for v in given), strict=True)
        if b.name in due
    }


def _geom(
    element: ET.Element, assets: ET.Element, name: str, shape: Shape, body: Body, scene: SimScene
) -> None:
    x, y, z = shape.size
    ground = scene.vehicle_ground_friction if body.wheeled else scene.ground_friction
    friction = (body.friction + ground) / 2
    attributes = {
        "name": name,
        "pos": _v(shape.position),
        "quat": _q(shape.quaternion),
        "contype": str(_WHEELS if body.wheeled else _NORMAL),
        "conaffinity": str(_NORMAL | _WHEELS),
        "friction": f"{_n(friction)} 0 0",
        "condim": "3",
        "mass": "0",
        "rgba": f"{_v(body.color)} 1",
    }
    if shape.kind == "sphere":
        attributes |= {"type": "sphere", "size": _n(x)}
    elif shape.kind == "box":
        attributes |= {"type": "box", "size": _v((x, y, z))}
    elif shape.kind == "capsule":
        attributes |= {"type": "capsule", "size": _v((x, z))}
    else:
        points = cylinder_vertices(shape) if shape.kind == "cylinder" else np.array(shape.vertices)
        ET.SubElement(assets, "mesh", name=name, vertex=_v(points.ravel()))
        attributes |= {"type": "mesh", "mesh": name}
    ET.SubElement(element, "geom", attributes)


def _text(value: str) -> str:
    """A name as JSON: XML 1.0 cannot carry control characters."""
    return json.dumps(value, ensure_ascii=True)


def _n(value: float) -> str:
    return f"{float(value) + 0.0:.12g}"


def _v(values: Any) -> str:
    return " ".join(_n(v) for v in values)


def _q(quaternion: Any) -> str:
    x, y, z, w = quaternion
    return _v((w, x, y, z))
