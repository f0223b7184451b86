"""The parts and joints of a robot description as MuJoCo reads it, each part in its local frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
import math
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from esg.assets.geometry.fitting import hull_proxy
from esg.assets.imports.models.admitted import Admitted
from esg.assets.imports.sources import slug
from esg.graph.models import Joint, Mount, Proxy, ProxyKind

Floats = NDArray[np.float64]

CM = 100.0
MOST_PARTS = 64
_SIZE_CM, _MASS_KG = (0.1, 1e4), (1e-3, 1e5)
"""Of a part, as the verifier wants them."""
_FREE, _BALL, _SLIDE = 0, 1, 2  # numbers of MuJoCo's
_KINDS = {1: "ball", 2: "slider", 3: "hinge"}
_PLANE = 0
_SHAPES = {
    2: ProxyKind.SPHERE, 3: ProxyKind.CAPSULE, 5: ProxyKind.CYLINDER, 6: ProxyKind.BOX
}  # fmt: skip
_ELLIPSOID, _MESH = 4, 7
_GREY = (0.5, 0.5, 0.5, 1.0)
_AT_REST, _TINY_M = 1e-9, 1e-5


@dataclass
class Part:
    """Bodies that no joint moves against each other: one rigid body.

    Args:
        name: Of its first body.
        key: The same as a word of its own in the model.
        bodies: Of MuJoCo's.
        parent: Number of the part that carries it, None for the root.
        movable: Whether it is not fixed in the world.
        origin: Bottom centre of its bounding box [m], shape [3].
        dimensions_cm: Of that box.
        mass_kg: Its mass.
        center_cm: Centre of mass, local frame.
        inertia: Ixx, Iyy, Izz, Ixy, Ixz, Iyz about that [kg cm^2].
        meshes: What is drawn: mesh [cm, local frame], colour and opacity.
        proxies: What touches.
        mounts: Where joints take hold.
    """

    name: str
    key: str
    bodies: list[int]
    parent: int | None = None
    movable: bool = True
    origin: Floats = field(default_factory=lambda: np.zeros(3))
    dimensions_cm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mass_kg: float = 0.0
    center_cm: tuple[float, ...] = ()
    inertia: tuple[float, ...] = ()
    meshes: list[Any] = field(default_factory=list)
    proxies: list[Proxy] = field(default_factory=list)
    mounts: list[Mount] = field(default_factory=list)


def measured(model: Admitted) -> tuple[list[Part], list[Joint], list[str]]:
    """Parts (the root first), joints between their keys, and what is wrong with them."""
    import mujoco as untyped  # compiled: its names are known to no type checker

    mujoco: Any = untyped
    text = ET.tostring(model.root, encoding="unicode")
    try:
        m = mujoco.MjModel.from_xml_string(text, model.files)
    except ValueError as error:
        told = " ".join(str(error).split())[:300]
        return [], [], [f"MuJoCo does not read it ({told}); correct it"]
    d = mujoco.MjData(m)
    mujoco.mj_forward(m, d)
    faults = list(_several(m))
    parts = _grouped(m, model)
    if len(parts) < 2:
        faults.append("it has no joint that moves; import its meshes instead (a folder of them)")
    else:
        faults += _rooted(m, parts)
    if len(parts) > MOST_PARTS:
        faults.append(f"it has {len(parts)} moving parts; at most {MOST_PARTS} are imported")
    if faults:
        return parts, [], faults
    for part in parts:
        faults += _shape(m, d, part, model.urdf)
        faults += _weight(m, d, part)
    joints: list[Joint] = []
    for part in parts:
        if part.parent is not None:
            faults += _spring(m, part)
            joints.append(_joined(m, d, part, parts[part.parent]))
    return parts, joints, faults


def _several(m: Any) -> Iterator[str]:
    for body in range(1, m.nbody):
        count = int(m.body_jntnum[body])
        if count > 1:
            yield (
                f"body {m.body(body).name!r}: it has {count} joints; a part has one: put a body "
                "between each two of them"
            )


def _grouped(m: Any, model: Admitted) -> list[Part]:
    """Bodies with no joint between them, as parts; the root first, parents before children."""
    of: dict[int, int] = {}
    parts = [Part("", "", [0], movable=False)]
    of[0] = 0
    for body in range(1, m.nbody):
        above = of[int(m.body_parentid[body])]
        if not m.body_jntnum[body]:
            of[body] = above
            parts[above].bodies.append(body)
            continue
        of[body] = len(parts)
        free = int(m.jnt_type[m.body_jntadr[body]]) == _FREE
        parts.append(Part("", "", [body], parent=None if free else above))
    world = parts[0]
    solid = any(m.geom_type[g] != _PLANE for g in _geoms(m, world)) or _mass(m, world) > 0.0
    world.movable = model.urdf and not model.in_world
    roots = [p for p in parts[1:] if p.parent is None]
    if not solid and len(roots) == 1:
        # Nothing stands in the world: what moves freely is the root.
        parts = parts[1:]
        for part in parts:
            part.parent = None if part.parent in (None, 0) and part in roots else part.parent
            if part.parent is not None:
                part.parent -= 1
    taken: set[str] = set()
    for n, part in enumerate(parts):
        named = [m.body(b).name for b in part.bodies if b and m.body(b).name]
        part.name = named[0] if named else f"part {n}"
        key = stem = slug(part.name)[:40] or f"part_{n}"
        while key in taken:
            key = f"{stem}_{n}" if f"{stem}_{n}" not in taken else f"{key}_"
        taken.add(key)
        part.key = key
    return parts


def _rooted(m: Any, parts: list[Part]) -> Iterator[str]:
    roots = [p for p in parts if p.parent is None]
    if len(roots) > 1:
        told = ", ".join(repr(p.name) for p in roots if p.bodies != [0])
        yield f"{told}: they move freely of all else; a model has one root: import them one by one"
    elif not any(m.geom_type[g] != _PLANE for g in _geoms(m, parts[0])):
        hung = next((p.name for p in parts[1:]), parts[0].name)
        yield (
            f"body {hung!r}: it hangs in the empty world; give what carries it a shape, such as "
            "a post"
        )


def _geoms(m: Any, part: Part) -> Iterator[int]:
    return (g for g in range(m.ngeom) if int(m.geom_bodyid[g]) in part.bodies)


def _mass(m: Any, part: Part) -> float:
    return float(sum(m.body_mass[b] for b in part.bodies))


def _shown(m: Any, geoms: list[int], solid: list[int], urdf: bool) -> list[int]:
    """Which shapes are drawn.

    A viewer shows groups 0 to 2; of a URDF's link its visuals, else what touches.
    """
    seen = {int(m.geom_bodyid[g]) for g in geoms if g not in solid}
    shown = [
        g
        for g in geoms
        if (g not in solid or m.geom_bodyid[g] not in seen if urdf else m.geom_group[g] <= 2)
    ]
    return [g for g in shown if _color(m, g)[3] > 0.0]


def _shape(m: Any, d: Any, part: Part, urdf: bool) -> Iterator[str]:
    """Measures and draws a part."""
    geoms = [g for g in _geoms(m, part) if m.geom_type[g] != _PLANE]
    odd = [g for g in geoms if m.geom_type[g] not in (*_SHAPES, _ELLIPSOID, _MESH)]
    if odd:
        yield f"part {part.name!r}: a shape is neither a mesh nor a primitive; give one of them"
        return
    if not geoms:
        yield f"part {part.name!r}: it has no shape; give it one, or fix its joint"
        return
    solid = [g for g in geoms if m.geom_contype[g] or m.geom_conaffinity[g]]
    tiny = [g for g in geoms if m.geom_type[g] in _SHAPES and _thinnest(m, g) < _TINY_M]
    if tiny:
        told = f"{_thinnest(m, tiny[0]):g} m; a shape is at least {_TINY_M:g} m thick"
        yield f"part {part.name!r}: a shape measures {told}"
        return
    shown = _shown(m, geoms, solid, urdf) or solid or geoms
    solid = solid or shown
    drawn = {g: _placed(m, d, g) for g in {*solid, *shown}}
    corners = np.concatenate([mesh.vertices for mesh in drawn.values()])
    low, high = corners.min(0), corners.max(0)
    part.origin = np.array([*(low + high)[:2] / 2, low[2]])
    part.dimensions_cm = tuple(round(float(v), 3) for v in (high - low) * CM)  # type: ignore[assignment]
    for mesh in drawn.values():
        mesh.vertices = (mesh.vertices - part.origin) * CM
    if not all(_SIZE_CM[0] <= v <= _SIZE_CM[1] for v in part.dimensions_cm):
        told = " x ".join(f"{v:g}" for v in part.dimensions_cm)
        yield (
            f"part {part.name!r}: it measures {told} cm, expected {_SIZE_CM[0]:g} to "
            f"{_SIZE_CM[1]:g}; lengths are in metres"
        )
        return
    part.meshes = [(drawn[g], _color(m, g)) for g in shown]
    part.proxies = [_proxy(m, d, g, part.origin, drawn[g]) for g in solid]


def _thinnest(m: Any, g: int) -> float:
    """Smallest half extent or radius of a primitive [m]; a capsule may be as short as a sphere."""
    count = {ProxyKind.BOX: 3, ProxyKind.CYLINDER: 2}.get(_SHAPES[int(m.geom_type[g])], 1)
    return float(min(m.geom_size[g][:count]))


def _color(m: Any, g: int) -> tuple[float, float, float, float]:
    own = tuple(float(c) for c in m.geom_rgba[g])
    material = int(m.geom_matid[g])
    if material >= 0 and np.allclose(own, _GREY):
        own = tuple(float(c) for c in m.mat_rgba[material])
    return own  # type: ignore[return-value]


def _placed(m: Any, d: Any, g: int) -> Any:
    """The surface of a shape in the world [m]."""
    import trimesh

    kind, size = int(m.geom_type[g]), np.asarray(m.geom_size[g], float)
    if kind == _MESH:
        mesh_id = int(m.geom_dataid[g])
        v0, f0 = int(m.mesh_vertadr[mesh_id]), int(m.mesh_faceadr[mesh_id])
        vertices = m.mesh_vert[v0 : v0 + int(m.mesh_vertnum[mesh_id])]
        faces = m.mesh_face[f0 : f0 + int(m.mesh_facenum[mesh_id])]
        mesh = trimesh.Trimesh(np.array(vertices, float), np.array(faces), process=False)
    elif kind == _ELLIPSOID:
        mesh = trimesh.creation.icosphere(subdivisions=3)
        mesh.vertices = np.asarray(mesh.vertices) * size
    else:
        shape = _SHAPES[kind]
        if shape is ProxyKind.SPHERE:
            mesh = trimesh.creation.uv_sphere(radius=size[0])
        elif shape is ProxyKind.BOX:
            mesh = trimesh.creation.box(extents=2 * size)
        elif shape is ProxyKind.CYLINDER:
            mesh = trimesh.creation.cylinder(radius=size[0], height=2 * size[1])
        else:
            mesh = trimesh.creation.capsule(radius=size[0], height=2 * size[1])
            mesh.vertices = np.asarray(mesh.vertices) - np.ptp(mesh.vertices, axis=0) / 2 \
                - np.min(mesh.vertices, axis=0)  # fmt: skip
    turn = np.reshape(d.geom_xmat[g], (3, 3))
    mesh.vertices = np.asarray(mesh.vertices) @ turn.T + d.geom_xpos[g]
    return mesh


def _proxy(m: Any, d: Any, g: int, origin: Floats, mesh: Any) -> Proxy:
    """What of a shape touches: itself if it is a primitive, else its hull, as in MuJoCo."""
    kind = _SHAPES.get(int(m.geom_type[g]))
    if kind is None:
        return hull_proxy(np.asarray(mesh.vertices))
    a, b, c = (float(v) * CM for v in m.geom_size[g])
    size = {ProxyKind.SPHERE: (a, a, a), ProxyKind.BOX: (a, b, c)}.get(kind, (a, a, b))
    turn = Rotation.from_matrix(np.reshape(d.geom_xmat[g], (3, 3))).as_quat()
    return Proxy(
        kind=kind,
        size_cm=size,
        position_cm=_rounded((d.geom_xpos[g] - origin) * CM),
        orientation_xyzw=_rounded(turn, 9),
    )


def _rounded(values: Any, digits: int = 6) -> Any:
    return tuple(round(float(v), digits) + 0.0 for v in values)


def _weight(m: Any, d: Any, part: Part) -> Iterator[str]:
    """Mass, centre of mass and inertia of a part."""
    masses = np.array([m.body_mass[b] for b in part.bodies])
    mass = float(masses.sum())
    if not _MASS_KG[0] <= mass <= _MASS_KG[1]:
        yield (
            f"part {part.name!r}: it weighs {mass:g} kg, expected {_MASS_KG[0]:g} to "
            f"{_MASS_KG[1]:g}; give it a mass"
        )
        return
    places = np.array([d.xipos[b] for b in part.bodies])
    center = masses @ places / mass
    total = np.zeros((3, 3))
    for b, weight, at in zip(part.bodies, masses, places, strict=True):
        turn = np.reshape(d.ximat[b], (3, 3))
        total += turn @ np.diag(m.body_inertia[b]) @ turn.T
        off = at - center
        total += weight * (off @ off * np.eye(3) - np.outer(off, off))
    total *= CM * CM
    part.mass_kg = round(mass, 6)
    part.center_cm = _rounded((center - part.origin) * CM)
    part.inertia = _rounded(
        (total[0, 0], total[1, 1], total[2, 2], total[0, 1], total[0, 2], total[1, 2])
    )


def _spring(m: Any, part: Part) -> Iterator[str]:
    """Whether a joint's spring is one that the record holds."""
    j = int(m.body_jntadr[part.bodies[0]])
    q = int(m.jnt_qposadr[j])
    if not float(np.ravel(m.jnt_stiffness[j])[0]):
        return
    if int(m.jnt_type[j]) == _BALL or abs(m.qpos_spring[q] - m.qpos0[q]) > _AT_REST:
        yield (
            f"joint {m.joint(j).name!r}: its spring is of a ball joint, or at rest elsewhere than "
            "where the model stands; take its stiffness away, or let springref be ref"
        )


def _joined(m: Any, d: Any, part: Part, parent: Part) -> Joint:
    """The joint that carries a part, with a mount at both."""
    j = int(m.body_jntadr[part.bodies[0]])
    q, v = int(m.jnt_qposadr[j]), int(m.jnt_dofadr[j])
    kind = int(m.jnt_type[j])
    name = slug(m.joint(j).name)[:40] or f"{part.key}_joint"
    axis = np.asarray(d.xaxis[j], float)
    if kind == _BALL:  # it is held within a cone about where it points now
        away = d.xipos[part.bodies[0]] - d.xanchor[j]
        axis = away / length if (length := float(np.linalg.norm(away))) > _AT_REST else axis
    for side in (part, parent):
        at = (d.xanchor[j] - side.origin) * CM
        mount = Mount(name=f"{part.key}.{name}", position_cm=_rounded(at), axis=_rounded(axis, 9))
        side.mounts.append(mount)
    lower, upper = (None, None)
    if m.jnt_limited[j]:
        scale = CM if kind == _SLIDE else math.degrees(1.0)
        still = 0.0 if kind == _BALL else float(m.qpos0[q])
        lower, upper = (round((float(e) - still) * scale, 6) for e in m.jnt_range[j])
    if kind == _BALL:
        lower = None
    stiffness = float(np.ravel(m.jnt_stiffness[j])[0])
    return Joint(
        id=f"{part.key}.{name}",
        kind=_KINDS[kind],  # type: ignore[arg-type]
        child=part.key,
        child_mount=f"{part.key}.{name}",
        parent=parent.key,
        parent_mount=f"{part.key}.{name}",
        lower=lower,
        upper=upper,
        position=min(max(0.0, lower or 0.0), upper if upper is not None else 0.0)
        if kind != _BALL and lower is not None
        else 0.0,
        stiffness=stiffness or None,
        damping=float(np.ravel(m.dof_damping[v])[0]) or None,
        friction=float(m.dof_frictionloss[v]) or None,
    )
