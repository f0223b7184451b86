# pyright: reportAttributeAccessIssue=false
"""USD: prims with time samples, and what stands beside them.

A thing is a prim with UsdPhysics' RigidBodyAPI, else the topmost one that moves or has geometry.
Shapes are its colliders, else its geometry; meshes count as hulls of their pieces. What UsdPhysics
says of masses counts. `esg export --to usd` writes a manifest into the default prim's customData.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
import zipfile

import numpy as np

from esg.engines.scene import Shape
from esg.judging.forms import MOST_PIECES, of_extents, of_mesh, of_points
from esg.judging.readers.carried import manifest_of
from esg.judging.recording import FRAMES, MOST_THINGS, Faults, Floats, Frame, Recording, Thing
from esg.strangers.arrays import check_archive
from esg.strangers.folders import lies_in

MOST_PRIMS = 200_000
MOST_SAMPLES = 1_000_000
MOST_BYTES = 2**31
_SOLIDS = ("Sphere", "Cube", "Cylinder", "Capsule", "Mesh")


def read_usd(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.usd`, `.usda`, `.usdc` and `.usdz`; a stage states its axes and units."""
    from pxr import Tf, Usd, UsdGeom

    _check(path, faults)
    try:
        stage = Usd.Stage.Open(str(path))
    except Tf.ErrorException as error:
        said = " ".join(str(error).split())
        raise faults.fail(f"it is no USD that can be read ({said[:120]})") from None
    if stage is None:
        raise faults.fail("it is no USD that can be read")
    _outside(stage, path, faults)
    axes = FRAMES["y-up" if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.y else "z-up"]
    unit = Frame("", float(UsdGeom.GetStageMetersPerUnit(stage)), axes.axes)
    prims = _things(stage, faults)
    codes = _codes(prims, stage)
    if len(codes) < 2:
        raise faults.fail("no prim of it has time samples: it is a scene, not a motion")
    poses = [_poses(prim, codes, unit) for prim in prims]
    manifest = _carried(stage, faults)
    names = [_name(prim) for prim in prims]
    if manifest is not None:
        things, notes = [Thing(name) for name in names], ()
    else:
        things = [
            _thing(prim, name, unit, codes[0]) for prim, name in zip(prims, names, strict=True)
        ]
        notes = ("shapes are its colliders, else hulls of the pieces of its meshes",)
    return Recording(
        "usd",
        (np.array(codes) - codes[0]) / float(stage.GetTimeCodesPerSecond()),
        np.stack([p for p, _ in poses], axis=1),
        np.stack([q for _, q in poses], axis=1),
        tuple(things),
        manifest=manifest,
        notes=notes,
    )


def _check(path: Path, faults: Faults) -> None:
    if path.suffix.lower() != ".usdz":
        return
    try:
        with zipfile.ZipFile(path) as archive:
            check_archive(archive, MOST_BYTES)
    except (zipfile.BadZipFile, ValueError, OSError) as error:
        raise faults.fail(f"it is no package that can be read ({error})") from None


def _outside(stage: Any, path: Path, faults: Faults) -> None:
    """Makes sure that the stage is made of files of one folder."""
    home = path.resolve().parent
    for layer in stage.GetUsedLayers():
        real = layer.realPath
        if real and not lies_in(Path(real.split("[")[0]), home):
            faults.add(f"it refers to {real!r}, outside of its folder")
    faults.stop()


def _things(stage: Any, faults: Faults) -> list[Any]:
    from pxr import Usd, UsdGeom, UsdPhysics

    prims = list(Usd.PrimRange(stage.GetPseudoRoot()))
    if len(prims) > MOST_PRIMS:
        raise faults.fail(f"it has {len(prims)} prims, at most {MOST_PRIMS} are read")
    rigid = [p for p in prims if p.HasAPI(UsdPhysics.RigidBodyAPI)]
    moving = {p.GetPath() for p in prims if p.IsA(UsdGeom.Xformable) and _moves(p)}
    solid = [p for p in prims if p.GetTypeName() in _SOLIDS]
    taken: set[Any] = {p.GetPath() for p in rigid}
    out = list(rigid)
    for prim in solid:
        above = _lineage(prim)
        if any(p.GetPath() in taken for p in above):
            continue
        # The topmost that moves; of what stands the one below the root's only children.
        movers = [p for p in above if p.GetPath() in moving]
        top = movers[0] if movers else _still(above, moving, stage)
        if top.GetPath() not in taken:
            taken.add(top.GetPath())
            out.append(top)
    if len(out) > MOST_THINGS:
        raise faults.fail(f"it has {len(out)} bodies, at most {MOST_THINGS} are judged")
    order = {p.GetPath(): k for k, p in enumerate(prims)}
    return sorted(out, key=lambda p: order[p.GetPath()])


def _lineage(prim: Any) -> list[Any]:
    """A prim and those above it, from the top, without the root of all."""
    out: list[Any] = []
    while prim and not prim.IsPseudoRoot():
        out.append(prim)
        prim = prim.GetParent()
    return out[::-1]


def _still(above: list[Any], moving: set[Any], stage: Any) -> Any:
    """Of the prims above something that stands the first that holds nothing that moves."""
    root = stage.GetDefaultPrim()
    for prim in above[:-1]:
        holds = any(path.HasPrefix(prim.GetPath()) for path in moving)
        if not holds and prim != root:
            return prim
    return above[-1]


def _moves(prim: Any) -> bool:
    from pxr import UsdGeom

    form = UsdGeom.Xformable(prim)
    return any(op.GetAttr().GetNumTimeSamples() > 1 for op in form.GetOrderedXformOps())


def _codes(prims: list[Any], stage: Any) -> list[float]:
    """Time codes at which anything that places a thing has a sample."""
    from pxr import UsdGeom

    found: set[float] = set()
    for prim in prims:
        for link in _lineage(prim):
            form = UsdGeom.Xformable(link)
            for op in form.GetOrderedXformOps() if form else ():
                attribute = op.GetAttr()
                if attribute.GetNumTimeSamples() > MOST_SAMPLES:
                    raise ValueError("too many samples")
                found.update(attribute.GetTimeSamples())
    return sorted(found)


def _poses(prim: Any, codes: list[float], unit: Frame) -> tuple[Floats, Floats]:
    """Poses of a prim in our axes [m], shapes [T, 3] and [T, 4]."""
    from pxr import Gf, UsdGeom

    at, turn = np.empty((len(codes), 3)), np.empty((len(codes), 4))
    form = UsdGeom.Imageable(prim)
    for k, code in enumerate(codes):
        matrix = form.ComputeLocalToWorldTransform(code)
        at[k] = matrix.ExtractTranslation()
        q = Gf.Transform(matrix).GetRotation().GetQuat()
        turn[k] = (*q.GetImaginary(), q.GetReal())
    return unit.lengths(at), unit.quaternions(turn)


def _carried(stage: Any, faults: Faults) -> Any:
    root = stage.GetDefaultPrim()
    text = root.GetCustomDataByKey("esg:manifest") if root else None
    if not isinstance(text, str):
        return None
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise faults.fail(f"the manifest in it is no JSON ({error})") from None
    return manifest_of(data, faults)


def _name(prim: Any) -> str:
    """What a prim is called: in our own files as JSON, since names may hold what USD cannot."""
    text = prim.GetCustomDataByKey("esg:name")
    if isinstance(text, str):
        try:
            return str(json.loads(text))
        except (ValueError, RecursionError):
            pass
    return prim.GetDisplayName() or prim.GetName()


def _thing(prim: Any, name: str, unit: Frame, code: float) -> Thing:
    from pxr import Usd, UsdGeom, UsdPhysics

    parts = [p for p in Usd.PrimRange(prim) if p.GetTypeName() in _SOLIDS]
    colliders = [p for p in parts if p.HasAPI(UsdPhysics.CollisionAPI)]
    home = UsdGeom.Imageable(prim).ComputeLocalToWorldTransform(code)
    rigid = home.RemoveScaleShear()
    shapes: list[Shape] = []
    points: list[Floats] = []
    for part in colliders or parts:
        to_home = UsdGeom.Imageable(part).ComputeLocalToWorldTransform(code) * rigid.GetInverse()
        found, corners = _solid(part, np.array(to_home), unit)
        shapes += found
        points.append(corners)
    if len(shapes) > MOST_PIECES:
        shapes = list(of_points(np.concatenate(points)))
    mass, center = None, None
    if prim.HasAPI(UsdPhysics.MassAPI):
        api = UsdPhysics.MassAPI(prim)
        stated = api.GetMassAttr().Get()
        mass = float(stated) if stated else None
        place = api.GetCenterOfMassAttr().Get()
        if place is not None and np.isfinite(place).all():
            x, y, z = (float(v) for v in unit.lengths(np.array(place, float)))
            center = (x, y, z)
    dynamic = prim.HasAPI(UsdPhysics.RigidBodyAPI)
    return Thing(
        name, tuple(shapes), mass=mass, center=center,
        static=False if dynamic else None, drawn=not colliders,
    )  # fmt: skip


def _solid(part: Any, matrix: Floats, unit: Frame) -> tuple[tuple[Shape, ...], Floats]:
    """Shapes of a piece of geometry in its thing's frame and our axes, and points around it.

    Args:
        part: A sphere, cube, cylinder, capsule or mesh.
        matrix: Into the thing's frame (row vectors, as USD has them), shape [4, 4].
        unit: Of the stage.
    """
    from pxr import UsdGeom

    kind = part.GetTypeName()
    if kind == "Mesh":
        mesh = UsdGeom.Mesh(part)
        local = np.array(mesh.GetPointsAttr().Get() or [], float).reshape(-1, 3)
        faces = _triangles(mesh)
        placed = unit.lengths(local @ matrix[:3, :3] + matrix[3, :3])
        return of_mesh(placed, faces), placed
    extents = _extents(part, kind)
    scale = np.linalg.norm(matrix[:3, :3], axis=1)
    half = 0.5 * np.array(extents)
    corners = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) * half
    placed = unit.lengths(corners @ matrix[:3, :3] + matrix[3, :3])
    made = of_extents(
        {"Sphere": "sphere", "Cube": "box", "Cylinder": "cylinder", "Capsule": "capsule"}[kind],
        (unit.metres * scale * np.array(extents)).tolist(),
    )
    turn = _turn(matrix, scale, unit)
    x, y, z = (float(v) for v in unit.lengths(matrix[3, :3]))
    return tuple(Shape(s.kind, s.size, (x, y, z), turn) for s in made), placed


def _turn(matrix: Floats, scale: Floats, unit: Frame) -> tuple[float, float, float, float]:
    """Orientation of a solid's own axes in our axes of its thing."""
    from scipy.spatial.transform import Rotation

    own = (matrix[:3, :3] / np.where(scale > 1e-12, scale, 1.0)[:, None]).T
    turned = np.array(unit.axes, float) @ own
    if np.linalg.det(turned) < 0.0:
        turned = turned @ np.diag([1.0, -1.0, 1.0])
    x, y, z, w = (float(v) for v in Rotation.from_matrix(turned).as_quat())
    return x, y, z, w


def _extents(part: Any, kind: str) -> list[float]:
    """Size of a solid's box along its own axes, Z the axis of what is round [stage units]."""
    from pxr import UsdGeom

    if kind == "Sphere":
        return [2.0 * float(UsdGeom.Sphere(part).GetRadiusAttr().Get())] * 3
    if kind == "Cube":
        return [float(UsdGeom.Cube(part).GetSizeAttr().Get())] * 3
    form = UsdGeom.Cylinder(part) if kind == "Cylinder" else UsdGeom.Capsule(part)
    radius, height = float(form.GetRadiusAttr().Get()), float(form.GetHeightAttr().Get())
    return [2 * radius, 2 * radius, height + (2 * radius if kind == "Capsule" else 0.0)]


def _triangles(mesh: Any) -> Any:
    """Triangles of a mesh as fans of its faces, shape [m, 3]."""
    counts = np.array(mesh.GetFaceVertexCountsAttr().Get() or [], int)
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get() or [], np.int64)
    if not len(counts) or counts.sum() != len(corners) or (counts < 3).any():
        return np.zeros((0, 3), np.int64)
    starts = np.cumsum(counts) - counts
    rows = [
        corners[[s, s + k, s + k + 1]]
        for s, n in zip(starts.tolist(), counts.tolist(), strict=True)
        for k in range(1, n - 1)
    ]
    return np.array(rows, np.int64).reshape(-1, 3)
