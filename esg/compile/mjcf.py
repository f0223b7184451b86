"""MuJoCo XML of a scene: bodies, masses, materials and start velocities.

What MuJoCo cannot represent is said in the file itself: it has no coefficient of restitution,
takes the larger of two frictions instead of the average, and a free joint has no damping; those
values stand in `<custom>`. The control program is not part of MJCF: `manifest.json` holds it.
"""

from __future__ import annotations

from dataclasses import dataclass
import json
import math
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from esg.compile import names
from esg.engines import starts
from esg.engines.joint_rules import BREAK_WINDOW_S, FARTHEST_RAD
from esg.engines.joints import WORLD, Joint, start_position
from esg.engines.manifest import Manifest
from esg.engines.program import batch_programs
from esg.engines.scene import FRAGMENT, Body, Shape, SimScene
from esg.engines.worlds import cylinder_vertices, principal_axes
from esg.units import quat_inverse, quat_multiply, quat_rotate

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
BREAKING_NOTE = "What breaks stays whole: MuJoCo swaps no bodies."
JOINTS_NOTE = (
    "Joints: the limit of a ball joint is one of its whole turn; motors are velocity and position "
    "actuators; ropes and springs are tendons; what closes a ring is tied by equalities, a slider "
    "there by none. A joint breaks when it takes more than the force in custom numerics "
    "break_<joint> [N]; DriveJoint commands are in manifest.json."
)
_NORMAL, _WHEELS = 1, 2
FAR_M = 1000.0
"""A slider with a limit on one side ends here on the other."""
FIRM = "0.008 1"
"""How fast a limit pushes back what is beyond it [s]: two steps at 240 Hz; MuJoCo takes 0.02."""
ACTUATOR = 1e4
"""Strength of an actuator that its range of force alone holds back."""
GROUND_SIZE_M = 100.0
"""Half side of the drawn ground; collision is with the whole plane."""


def scene_mjcf(manifest: Manifest) -> str:
    """The scene of a manifest as MJCF text; the same manifest gives the same text."""
    whole = tuple(b for b in manifest.scene.bodies if b.category != FRAGMENT)
    scene = manifest.scene.with_bodies(whole)
    idents = names.unique_identifiers(scene.names)
    root = ET.Element("mujoco", model=names.comment(scene.scene_id) or "scene")
    tyres = (TYRES_NOTE,) if any(b.tyre_friction > 0.0 for b in scene.bodies) else ()
    joints = (JOINTS_NOTE,) if scene.joints else ()
    breaks = (BREAKING_NOTE,) if len(whole) < len(manifest.scene.bodies) else ()
    root.append(ET.Comment(" " + " ".join((*NOTES, *tyres, *joints, *breaks)) + " "))
    ET.SubElement(root, "compiler", angle="radian", autolimits="true")
    # What drives a joint stiffly is stable only if it is solved for.
    more = {"integrator": "implicitfast"} if scene.joints else {}
    option = {"timestep": _n(manifest.dt), "gravity": _v(scene.gravity), "cone": "elliptic"}
    ET.SubElement(root, "option", option | more)
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
    start = start_velocities(manifest)
    held = _tree(scene)
    elements: dict[str, ET.Element] = {}
    states: dict[str, tuple[list[float], list[float]]] = {}
    for body in _parents_first(scene, held):
        name, joint = idents[body.name], held.get(body.name)
        base = scene.body(joint.parent) if joint and joint.parent else None
        at, turn = _within(body, base)
        element = elements[body.name] = ET.SubElement(
            elements[base.name] if base else world, "body", name=name, pos=_v(at), quat=_q(turn)
        )
        if body.collides and not body.static:
            if joint is None:
                ET.SubElement(element, "freejoint", name=f"{name}_free")
            else:
                _hold(element, joint, f"{name}_joint", start_position(scene, joint))
            moments, axes = principal_axes(np.asarray(body.inertia, float))
            ET.SubElement(
                element, "inertial", pos="0 0 0", quat=_q(axes), mass=_n(body.mass),
                diaginertia=_v(moments),
            )  # fmt: skip
            states[body.name] = _state(scene, body, joint, start)
        for number, shape in enumerate(body.shapes):
            _geom(element, assets, f"{name}_{number}", shape, body, scene)
        damping = f"{_n(body.linear_damping)} {_n(body.angular_damping)}"
        ET.SubElement(custom, "numeric", name=f"restitution_{name}", data=_n(body.restitution))
        ET.SubElement(custom, "numeric", name=f"damping_{name}", data=damping)
        ET.SubElement(custom, "text", name=f"body_{name}", data=_text(body.name))
    ctrl = _tie(root, custom, world, scene, idents, held, elements)
    order = [
        name for e in world.iter("body") for name in elements if elements[name] is e
    ]  # MuJoCo counts coordinates through the tree.
    qpos, qvel = ([v for n in order if n in states for v in states[n][k]] for k in (0, 1))
    if qpos:
        keys = ET.SubElement(root, "keyframe")
        state = {"name": "start", "qpos": _v(qpos), "qvel": _v(qvel)}
        ET.SubElement(keys, "key", state | ctrl)
    ET.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(root, "unicode") + "\n"


def _tree(scene: SimScene) -> dict[str, Joint]:
    """The joint by which each body hangs on another, by the body's name; never in a ring."""
    out: dict[str, Joint] = {}
    for joint in scene.joints:
        above: str = joint.parent
        while above in out and above != joint.child:
            above = out[above].parent
        if not joint.flexible and joint.child not in out and above != joint.child:
            out[joint.child] = joint
    return out


def _parents_first(scene: SimScene, held: dict[str, Joint]) -> list[Body]:
    """The bodies in their order, but none before the one it hangs on."""
    out: dict[str, Body] = {}

    def add(body: Body) -> None:
        joint = held.get(body.name)
        if joint and joint.parent != WORLD:
            add(scene.body(joint.parent))
        out.setdefault(body.name, body)

    for body in scene.bodies:
        add(body)
    return list(out.values())


def _within(body: Body, base: Body | None) -> tuple[Any, Any]:
    """Pose of a body in the frame of another, or in the world."""
    if base is None:
        return body.position, body.quaternion
    back = quat_inverse(base.quaternion)
    at = quat_rotate(back, np.asarray(body.position) - np.asarray(base.position))
    return at, quat_multiply(back, np.asarray(body.quaternion))


def _hold(element: ET.Element, joint: Joint, name: str, position: float) -> None:
    """The joint by which a body hangs on what its element is in; a fixed one needs none."""
    kind = {"hinge": "hinge", "slider": "slide", "ball": "ball"}.get(joint.kind)
    if kind is None:
        return
    attributes = {"name": name, "type": kind, "pos": _v(joint.child_anchor)}
    low, high = joint.lower, joint.upper
    if kind == "ball":
        attributes |= {} if high is None else {"range": f"0 {_n(high)}", "solreflimit": FIRM}
    else:
        axis = quat_rotate(np.array(joint.child_rotation), np.array([1.0, 0.0, 0.0]))
        attributes |= {"axis": _v(axis), "ref": _n(position), "springref": "0"}
        far = FARTHEST_RAD if kind == "hinge" else FAR_M
        if low is not None or high is not None:
            ends = (-far if low is None else low, far if high is None else high)
            attributes |= {"range": _v(ends), "solreflimit": FIRM}
    for field, value in (
        ("stiffness", joint.stiffness),
        ("damping", joint.damping),
        ("frictionloss", joint.friction),
    ):
        if value:
            attributes[field] = _n(value)
    ET.SubElement(element, "joint", attributes)


def _state(
    scene: SimScene, body: Body, joint: Joint | None, start: dict[str, tuple[Any, Any]]
) -> tuple[list[float], list[float]]:
    """Coordinates and speeds of a body at the start, as MuJoCo keeps those of its joint."""
    still = ((0.0,) * 3, (0.0,) * 3)
    linear, angular = (np.asarray(v, float) for v in start.get(body.name, still))
    x, y, z, w = body.quaternion
    own = (-x, -y, -z, w)
    if joint is None:
        # MuJoCo keeps a free joint's angular velocity in the body's own frame.
        return [*body.position, w, x, y, z], [*linear, *quat_rotate(own, angular).tolist()]
    base = start.get(joint.parent, still)
    spin = quat_rotate(own, angular - np.asarray(base[1], float))
    axis = quat_rotate(np.array(joint.child_rotation), np.array([1.0, 0.0, 0.0]))
    if joint.kind == "ball":
        return [1.0, 0.0, 0.0, 0.0], spin.tolist()
    if joint.kind == "hinge":
        return [start_position(scene, joint)], [float(axis @ spin)]
    if joint.kind == "slider":
        way = quat_rotate(own, linear - np.asarray(base[0], float))
        return [start_position(scene, joint)], [float(axis @ way)]
    return [], []


@dataclass(frozen=True)
class _Ties:
    """Where what is no part of the tree goes."""

    contact: ET.Element
    tendon: ET.Element
    equality: ET.Element
    actuator: ET.Element


def _tie(
    root: ET.Element,
    custom: ET.Element,
    world: ET.Element,
    scene: SimScene,
    idents: dict[str, str],
    held: dict[str, Joint],
    elements: dict[str, ET.Element],
) -> dict[str, str]:
    """Writes motors, tendons, rings and pairs that do not touch; returns the key's controls."""
    if not scene.joints:
        return {}
    kinds = ("contact", "tendon", "equality", "actuator")
    ties = _Ties(*(ET.SubElement(root, kind) for kind in kinds))
    labels = names.unique_identifiers(j.name for j in scene.joints)
    control: list[float] = []
    for joint in scene.joints:
        label = labels[joint.name]
        ends = [(idents[joint.child], elements[joint.child], joint.child_anchor)]
        other = elements.get(joint.parent, world)
        ends.append((idents.get(joint.parent, "world"), other, joint.parent_anchor))
        (child, _, _), (parent, _, _) = ends
        if joint.parent != WORLD and not joint.collide:
            ET.SubElement(ties.contact, "exclude", body1=child, body2=parent)
        if joint.break_impulse is not None:
            force = _n(joint.break_impulse / BREAK_WINDOW_S)
            ET.SubElement(custom, "numeric", name=f"break_{label}", data=force)
        if joint.flexible:
            _tendon(ties.tendon, joint, label, ends)
        elif held.get(joint.child) is joint:
            control += _motor(ties.actuator, joint, label, f"{child}_joint")
        elif joint.kind == "fixed":
            ET.SubElement(ties.equality, "weld", body1=child, body2=parent)
        elif joint.kind != "slider":
            along = quat_rotate(np.array(joint.child_rotation), np.array([1.0, 0.0, 0.0]))
            points = [np.asarray(joint.child_anchor)]
            points += [points[0] + along] if joint.kind == "hinge" else []
            for point in points:
                ET.SubElement(ties.equality, "connect", body1=child, body2=parent, anchor=_v(point))
    for tie in (ties.contact, ties.tendon, ties.equality, ties.actuator):
        if not len(tie):
            root.remove(tie)
    return {"ctrl": _v(control)} if control else {}


def _tendon(
    tendons: ET.Element, joint: Joint, label: str, ends: list[tuple[str, ET.Element, Any]]
) -> None:
    """A rope or spring between two sites."""
    length = joint.upper or 0.0
    attributes = {"name": label}
    if joint.kind == "rope":
        attributes |= {"range": f"0 {_n(length)}", "solreflimit": FIRM}
    else:
        attributes |= {"springlength": _n(length), "stiffness": _n(joint.stiffness)}
        attributes |= {"damping": _n(joint.damping)}
    spatial = ET.SubElement(tendons, "spatial", attributes)
    for k, (_, element, anchor) in enumerate(ends):
        ET.SubElement(element, "site", name=f"{label}_{k}", pos=_v(anchor), size="0.01")
        ET.SubElement(spatial, "site", site=f"{label}_{k}")


def _motor(actuators: ET.Element, joint: Joint, label: str, name: str) -> list[float]:
    """The actuator of a joint with a motor; returns its control at the start."""
    motor = joint.motor
    if motor is None:
        return []
    attributes = {"name": label, "joint": name}
    if not math.isinf(motor.limit):
        attributes["forcerange"] = _v((-motor.limit, motor.limit))
    if motor.position is None:
        ET.SubElement(actuators, "velocity", attributes, kv=_n(ACTUATOR))
        return [motor.speed]
    ET.SubElement(actuators, "position", attributes, kp=_n(ACTUATOR), dampratio="1")
    return [motor.position]


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
