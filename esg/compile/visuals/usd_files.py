# pyright: reportAttributeAccessIssue=false
"""USD on disk: layers as text or in binary with their pictures beside, or one package."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
import os
from pathlib import Path
import tempfile
from typing import Any, Literal

UsdForm = Literal["usda", "usdc", "usdz"]
LOOKS_FILE = "scene_looks.usdc"
PACKAGE = "scene.usdz"
EPOCH_S = 315619200
"""The second day of 1980: packages know no time before the first."""
_PHYSICAL = ("physics:", "physx", "esg:")
"""How properties begin that a viewer has no use for."""
_SHOWN = {"Xform", "Scope", "Mesh", "Material", "Shader", "Camera"}
"""Types of prims that viewers on phones take (those of ARKit)."""


@dataclass(frozen=True)
class UsdScene:
    """The layers of a scene (`Sdf.Layer`s in memory) and the pictures they name.

    Args:
        physics: `scene.*`: to simulate.
        animation: `scene_animation.*`: to play.
        looks: `LOOKS_FILE`: what is seen.
        pictures: Encoded files by their paths beside the layers.
    """

    physics: Any
    animation: Any
    looks: Any
    pictures: dict[str, bytes]


def write_layers(scene: UsdScene, out: Path, suffix: str) -> list[Path]:
    """Writes the layers and their pictures below `out`; returns the files."""
    paths = [out / f"scene.{suffix}", out / f"scene_animation.{suffix}", out / LOOKS_FILE]
    for path, layer in zip(paths, (scene.physics, scene.animation, scene.looks), strict=True):
        if suffix == "usda" and path.name != LOOKS_FILE:
            path.write_text(layer.ExportToString(), "utf-8", newline="\n")
        else:
            layer.Export(str(path))
    for name, data in scene.pictures.items():
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        paths.append(path)
    return paths


def write_package(scene: UsdScene, out: Path) -> list[Path]:
    """Writes what is seen of a scene, as it moves, as one package; returns the file.

    It holds no physics and no light, and is Y up: so phones take it.
    """
    from pxr import Usd, UsdUtils

    with tempfile.TemporaryDirectory() as place:
        work = Path(place)
        write_layers(scene, work, "usdc")
        played = Usd.Stage.Open(str(work / "scene_animation.usdc"))
        flat = played.Flatten(addSourceFileComment=False)
        del played
        _strip(flat)
        _turn_y_up(flat)
        # Flattening has made the pictures' paths absolute.
        UsdUtils.ModifyAssetPaths(flat, partial(_beside, work))
        flat.Export(str(work / "seen.usdc"))
        for file in work.rglob("*"):
            os.utime(file, (EPOCH_S, EPOCH_S))  # a package tells the times of its files
        path = out / PACKAGE
        done = UsdUtils.CreateNewUsdzPackage(str(work / "seen.usdc"), str(path), "scene.usdc")
        assert done, path
    return [path]


def _beside(folder: Path, file: str) -> str:
    """The path of a file as layers in `folder` tell it."""
    return f"./{Path(file).relative_to(folder).as_posix()}"


def _strip(layer: Any) -> None:
    """Takes away what is not to be seen: physics, program, colliders, lights."""
    from pxr import Sdf

    gone: list[Any] = []

    def visit(path: Any) -> None:
        prim = layer.GetPrimAtPath(path)
        if not path.IsPrimPath() or prim is None:
            return
        purpose = layer.GetAttributeAtPath(path.AppendProperty("purpose"))
        hidden = purpose is not None and purpose.default == "guide"
        if prim.typeName not in _SHOWN or hidden:
            gone.append(path)
            return
        for name in [p.name for p in prim.properties if p.name.startswith(_PHYSICAL)]:
            prim.RemoveProperty(prim.properties[name])
        prim.ClearInfo("customData")
        kept = [
            name
            for name in prim.GetInfo("apiSchemas").GetAddedOrExplicitItems()
            if not name.startswith(("Physics", "Physx"))
        ]
        schemas = Sdf.TokenListOp()
        schemas.prependedItems = kept
        prim.SetInfo("apiSchemas", schemas) if kept else prim.ClearInfo("apiSchemas")

    layer.Traverse("/", visit)
    for path in sorted(gone, key=lambda p: -p.pathElementCount):
        parent = layer.GetPrimAtPath(path.GetParentPath())
        if parent is not None and path.name in parent.nameChildren:
            del parent.nameChildren[path.name]


def _turn_y_up(layer: Any) -> None:
    """Turns the world on its side, so that Y is up."""
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.Open(layer)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    world = UsdGeom.Xformable(stage.GetDefaultPrim())
    world.AddRotateXOp(UsdGeom.XformOp.PrecisionDouble).Set(-90.0)
