# pyright: reportAttributeAccessIssue=false
"""What a USD scene shows, in a binary layer of its own: meshes, materials, ground and dressing.

The layer that a simulator reads stays text and small; it references the prims of this one. Each
asset holds its materials below itself, because a reference brings nothing from beside it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.assets.gltf.document import Corners
from esg.assets.gltf.parts import MeshPart
from esg.assets.gltf.surfaces import Picture, Surface, surface_of, tinted
from esg.compile import names
from esg.compile.visuals.ropes import LOOKS, rope_mesh
from esg.compile.visuals.setting import (
    Setting,
    View,
    by_surface,
    by_thing,
    facing,
    ground_mesh,
    seen_at,
    strength,
)
from esg.engines.scene import Body

if TYPE_CHECKING:
    from esg.view.pieces import Part

TEXTURES = "textures"
"""Folder of the pictures beside the layers."""
ROOT = "/Seen"
SURROUNDINGS = f"{ROOT}/Surroundings"
RESERVED = ("looks", "ground", "sun", "sky")
"""Names of prims that no part gets, in lower case."""
SENSOR_MM = 36.0
"""Width of a camera's film; only its ratio to the focal length counts."""
SUN_INTENSITY = math.pi / 4
"""Of a sun that makes white paper reflect one unit of radiance, as Blender, Karma and Storm take
it; by the letter of UsdLux it is four times as much."""
FAR_M = 10000.0


class UsdLooks:
    """The layer and the pictures it names.

    Args:
        layer: An empty `Sdf.Layer` to write to.
    """

    def __init__(self, layer: Any) -> None:
        from pxr import Usd, UsdGeom

        self.layer = layer
        self.pictures: dict[str, Picture] = {}
        self._stage = Usd.Stage.Open(layer)
        UsdGeom.SetStageUpAxis(self._stage, UsdGeom.Tokens.z)
        UsdGeom.SetStageMetersPerUnit(self._stage, 1.0)
        self._stage.SetDefaultPrim(UsdGeom.Xform.Define(self._stage, ROOT).GetPrim())
        self._materials: dict[tuple[str, Surface], Any] = {}
        self._names: dict[str, set[str]] = {}

    def asset(self, root: str, parts: Iterable[MeshPart], body: Body) -> None:
        """Writes the mesh of a body below `root`, its wheels in prims of their own."""
        from pxr import UsdGeom

        UsdGeom.Xform.Define(self._stage, root)
        wheels = _wheel_prims(self._stage, root, body)
        for part in parts:
            path, axle = wheels.get(part.holder, (root, np.zeros(3)))
            corners = part.vertices - axle, part.faces, part.normals, part.uvs
            self._mesh(self._free(path, part.name), corners, part.surface, root)

    def surroundings(self, setting: Setting) -> None:
        """Writes ground, dressing and lights below `SURROUNDINGS`."""
        from pxr import UsdGeom

        UsdGeom.Xform.Define(self._stage, SURROUNDINGS)
        ground = surface_of(setting.ground)
        self._mesh(f"{SURROUNDINGS}/Ground", ground_mesh(setting), ground, SURROUNDINGS)
        for name, parts in by_thing(setting.parts).items():
            path = self._free(SURROUNDINGS, name)
            UsdGeom.Xform.Define(self._stage, path)
            for surface, corners in by_surface(parts):
                self._mesh(self._free(path, surface.name), corners, surface, SURROUNDINGS)
        _lights(self._stage, setting)

    def rope(self, kind: str) -> str:
        """Writes the mesh of ropes or springs unless it is there; returns its path."""
        path = f"{ROOT}/{kind.capitalize()}"
        if not self._stage.GetPrimAtPath(path):
            from pxr import UsdGeom

            UsdGeom.Xform.Define(self._stage, path)
            vertices, faces, normals = rope_mesh(kind)
            look = surface_of(LOOKS[kind])
            self._mesh(f"{path}/Mesh", (vertices, faces, normals, None), look, path)
        return path

    def show(self, number: int, parts: Sequence[Part]) -> str:
        """Writes the meshes of what moves as one by the time alone; returns its path."""
        from pxr import UsdGeom

        path = f"{ROOT}/Show{number}"
        UsdGeom.Xform.Define(self._stage, path)
        for k, (surface, corners) in enumerate(by_surface(parts)):
            self._mesh(f"{path}/Mesh{k or ''}", corners, surface, path)
        return path

    def _free(self, parent: str, name: str) -> str:
        """A path below `parent` that no other part has."""
        from pxr import Tf

        taken = self._names.setdefault(parent, set(RESERVED))
        stem = Tf.MakeValidIdentifier(name)
        ident, number = stem, 1
        while ident.lower() in taken:
            number += 1
            ident = f"{stem}_{number}"
        taken.add(ident.lower())
        return f"{parent}/{ident}"

    def _mesh(self, path: str, corners: Corners, surface: Surface, root: str) -> None:
        from pxr import Sdf, UsdGeom, UsdShade, Vt

        vertices, faces, normals, uvs = corners
        mesh = UsdGeom.Mesh.Define(self._stage, path)
        triangles(mesh, vertices, faces)
        flat = normals is None
        shown = _face_normals(vertices, faces) if flat else _floats(normals)
        mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(shown))
        mesh.SetNormalsInterpolation(UsdGeom.Tokens.faceVarying if flat else UsdGeom.Tokens.vertex)
        textured = uvs is not None and (surface.base or surface.normal or surface.rough_metal)
        if textured:
            st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
                "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.vertex
            )
            st.Set(Vt.Vec2fArray.FromNumpy(_floats(uvs)))
        mesh.CreateDisplayColorAttr([surface.shown])
        if surface.alpha < 1.0:
            mesh.CreateDisplayOpacityAttr([surface.alpha])
        if surface.two_sided:
            mesh.CreateDoubleSidedAttr(True)
        if not textured:
            surface = replace(surface, base=None, normal=None, rough_metal=None)
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(self._material(root, surface))

    def _material(self, root: str, surface: Surface) -> Any:
        """The material of a surface below `root`."""
        from pxr import UsdGeom, UsdShade

        surface = replace(surface, average=None)
        key = root, surface
        if key not in self._materials:
            scope = f"{root}/Looks"
            UsdGeom.Scope.Define(self._stage, scope)
            path = self._free(scope, surface.name or "Material")
            material = UsdShade.Material.Define(self._stage, path)
            self._shade(material, path, surface)
            self._materials[key] = material
        return self._materials[key]

    def _shade(self, material: Any, path: str, surface: Surface) -> None:
        from pxr import Gf, Sdf, Tf, UsdShade

        types = Sdf.ValueTypeNames
        shader = UsdShade.Shader.Define(self._stage, f"{path}/Surface")
        shader.CreateIdAttr("UsdPreviewSurface")
        material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")

        def input_(name: str, kind: Any, value: Any) -> Any:
            made = shader.CreateInput(name, kind)
            made.Set(value)
            return made

        # Not every reader multiplies a picture with a factor: the colour goes into the picture.
        surface = tinted(surface)
        color = input_("diffuseColor", types.Color3f, Gf.Vec3f(*surface.color))
        rough = input_("roughness", types.Float, surface.roughness)
        metal = input_("metallic", types.Float, surface.metalness)
        if surface.glow > 0.0:
            shining = Gf.Vec3f(*(surface.glow * c for c in surface.color))
            input_("emissiveColor", types.Color3f, shining)
        if surface.alpha < 1.0:
            input_("opacity", types.Float, surface.alpha)
        if not (surface.base or surface.normal or surface.rough_metal):
            return
        reader = UsdShade.Shader.Define(self._stage, f"{path}/Coordinates")
        reader.CreateIdAttr("UsdPrimvarReader_float2")
        reader.CreateInput("varname", types.String).Set("st")
        reader.CreateOutput("result", types.Float2)

        def texture(name: str, kind: str, picture: Picture, space: str) -> Any:
            stem = Tf.MakeValidIdentifier(picture.name or kind)
            file = f"{TEXTURES}/{stem}_{picture.digest}.{picture.suffix}"
            self.pictures[file] = picture
            made = UsdShade.Shader.Define(self._stage, f"{path}/{name}")
            made.CreateIdAttr("UsdUVTexture")
            made.CreateInput("file", types.Asset).Set(f"./{file}")
            made.CreateInput("st", types.Float2).ConnectToSource(reader.ConnectableAPI(), "result")
            made.CreateInput("wrapS", types.Token).Set("repeat")
            made.CreateInput("wrapT", types.Token).Set("repeat")
            made.CreateInput("sourceColorSpace", types.Token).Set(space)
            return made

        if surface.base is not None:
            made = texture("BaseColor", "color", surface.base, "sRGB")
            made.CreateOutput("rgb", types.Float3)
            color.ConnectToSource(made.ConnectableAPI(), "rgb")
        if surface.rough_metal is not None:
            made = texture("RoughMetal", "rough", surface.rough_metal, "raw")
            made.CreateOutput("g", types.Float)
            rough.ConnectToSource(made.ConnectableAPI(), "g")
            made.CreateInput("scale", types.Float4).Set(
                Gf.Vec4f(1.0, surface.roughness, surface.metalness, 1.0)
            )
            if surface.metalness > 0.0:
                made.CreateOutput("b", types.Float)
                metal.ConnectToSource(made.ConnectableAPI(), "b")
        if surface.normal is not None:
            made = texture("Normal", "normal", surface.normal, "raw")
            made.CreateInput("scale", types.Float4).Set(Gf.Vec4f(2.0, 2.0, 2.0, 1.0))
            made.CreateInput("bias", types.Float4).Set(Gf.Vec4f(-1.0, -1.0, -1.0, 0.0))
            made.CreateOutput("rgb", types.Float3)
            input_("normal", types.Normal3f, Gf.Vec3f(0.0, 0.0, 1.0)).ConnectToSource(
                made.ConnectableAPI(), "rgb"
            )


def triangles(mesh: Any, vertices: Any, faces: Any) -> None:
    """Points, triangles and extent of a mesh, which is no cage of a smoother one."""
    from pxr import Vt

    points = _floats(vertices)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(faces), 3, np.int32)))
    index = np.ascontiguousarray(np.ravel(faces), np.int32)
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(index))
    mesh.CreateSubdivisionSchemeAttr("none")
    low, high = points.min(0), points.max(0)
    mesh.CreateExtentAttr([tuple(map(float, low)), tuple(map(float, high))])


def _floats(values: Any) -> Any:
    return np.ascontiguousarray(values, np.float32)


def _face_normals(vertices: Any, faces: Any) -> Any:
    """The normal of every face at each of its corners, shape [3 m, 3]."""
    a, b, c = (np.asarray(vertices, float)[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(length > 0.0, normals / np.where(length > 0.0, length, 1.0), (0.0, 0.0, 1.0))
    return np.repeat(normals, 3, axis=0).astype(np.float32)


def _wheel_prims(stage: Any, root: str, body: Body) -> dict[str, tuple[str, Any]]:
    """Prims of a body's wheels below its asset: path and axle in the mesh's frame [m] by name."""
    from pxr import Gf, UsdGeom

    out: dict[str, tuple[str, Any]] = {}
    idents = names.unique_identifiers((w.name for w in body.wheels), "Wheel")
    for wheel in body.wheels:
        path = f"{root}/{idents[wheel.name]}"
        form = UsdGeom.Xform.Define(stage, path)
        axle = np.asarray(wheel.axle) - np.asarray(body.origin_offset)
        form.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(*map(float, axle)))
        form.AddRotateYOp(UsdGeom.XformOp.PrecisionDouble).Set(0.0)
        out[wheel.name] = path, axle
    return out


def _lights(stage: Any, setting: Setting) -> None:
    from pxr import Gf, UsdGeom, UsdLux

    most, color = strength(setting.sky.sun_rgb)
    sun = UsdLux.DistantLight.Define(stage, f"{SURROUNDINGS}/Sun")
    sun.CreateIntensityAttr(SUN_INTENSITY * most)
    sun.CreateColorAttr(Gf.Vec3f(*color))
    sun.CreateAngleAttr(0.53)
    sun.CreateNormalizeAttr(True)
    turn = quatd(facing(setting.sky.sun))
    UsdGeom.Xformable(sun).AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(turn)
    most, color = strength(setting.sky.ambient_rgb)
    dome = UsdLux.DomeLight.Define(stage, f"{SURROUNDINGS}/Sky")
    dome.CreateIntensityAttr(most)
    dome.CreateColorAttr(Gf.Vec3f(*color))


def camera_prim(stage: Any, path: str, view: View, time: Any) -> None:
    """Writes a camera, as it is in the first of the frames."""
    from pxr import Gf, UsdGeom

    camera = UsdGeom.Camera.Define(stage, path)
    height = SENSOR_MM / view.aspect
    camera.CreateHorizontalApertureAttr(SENSOR_MM)
    camera.CreateVerticalApertureAttr(height)
    camera.CreateFocalLengthAttr(height / 2 / math.tan(view.fov / 2))
    camera.CreateClippingRangeAttr(Gf.Vec2f(view.near, FAR_M))
    at, turn = seen_at(view, time[:1])
    place(camera, at[0], turn[0])


def place(form: Any, position: Any, quaternion: Any) -> None:
    """Where a prim is [m], and how it is turned (x, y, z, w)."""
    from pxr import Gf, UsdGeom

    at = Gf.Vec3d(*(float(v) for v in position))
    form.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble).Set(at)
    form.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(quatd(quaternion))


def quatd(quaternion: Any) -> Any:
    """A quaternion (x, y, z, w) as USD takes it."""
    from pxr import Gf

    x, y, z, w = (float(v) for v in quaternion)
    return Gf.Quatd(w, x, y, z)
