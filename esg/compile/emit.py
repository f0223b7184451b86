"""From a scene and its program to the two files of an Unreal class and its import manifest."""

from __future__ import annotations

from dataclasses import dataclass
import json
from typing import Any

from esg.compile.assets import MeshAsset, Primitive
from esg.compile.header import emit_header
from esg.compile.model import ScenePlan, WatchedEvent, plan
from esg.compile.source import emit_source
from esg.engines.base import VERIFY_DT_S
from esg.engines.program import Program
from esg.engines.scene import SimScene

IMPORTS_FORMAT = "esg-unreal-imports"
IMPORTS_VERSION = 1


@dataclass(frozen=True)
class EmittedClass:
    """An emitted class.

    Args:
        name: Class and file name, without Unreal's leading A.
        header: Text of `<name>.h`.
        source: Text of `<name>.cpp`.
        imports_json: Text of `imports.json`: every asset the class names, the GLB it comes from,
            its collision (Unreal's frame, cm) and which component is which body.
    """

    name: str
    header: str
    source: str
    imports_json: str


def emit_class(
    scene: SimScene,
    program: Program,
    *,
    watch: tuple[WatchedEvent, ...] = (),
    dt: float = VERIFY_DT_S,
) -> EmittedClass:
    """Writes a scene as an Unreal actor class; the same input gives the same bytes.

    Args:
        scene: Bodies and materials (SI).
        program: What drives them.
        watch: Contacts the class reports and checks.
        dt: Physics step the class pins [s].

    Raises:
        ValueError: For what the class cannot say: unknown names, a gravity that is not vertical,
            values that are not finite, a mesh path outside the scene folder.
    """
    what = plan(scene, program, watch, dt)
    return EmittedClass(what.name, emit_header(what), emit_source(what), imports_json(what))


def imports_json(what: ScenePlan) -> str:
    """The import manifest of a class."""
    data = {
        "format": IMPORTS_FORMAT,
        "version": IMPORTS_VERSION,
        "class": what.name,
        "frame": "Unreal: cm, left-handed, Z up; a GLB (m, right-handed, Y up) gets there by "
        "(x, y, z) -> 100 (x, z, y), which is what Unreal's glTF import does",
        "shape": "size: sphere (r, r, r); box half extents; capsule and cylinder (r, r, half "
        "height along local Z without caps); convex half extents of its bounding box",
        "assets": [*(_asset(a, what) for a in what.assets), *_wheel_assets(what)],
        "components": {
            b.name: {
                "body": b.source.name,
                "index": b.index,
                "center_of_mass_cm": b.center_of_mass.tolist(),
                **({"fragments": list(b.source.fragments)} if b.source.fragments else {}),
                **({"postures": list(b.source.postures)} if b.source.postures else {}),
            }
            for b in what.bodies
        },
    }
    return json.dumps(data, indent=1, ensure_ascii=True, allow_nan=False) + "\n"


def _wheel_assets(what: ScenePlan) -> list[dict[str, Any]]:
    """The meshes of wheels: each a node of its body's file, about its axle."""
    assets = {
        wheel.path: {
            "path": wheel.path,
            "source": body.asset.source,
            "node": wheel.node,
            "half_extents_cm": [wheel.radius] * 3,
            "collision": [],
        }
        for body, wheel in what.wheels
    }
    return list(assets.values())


def _asset(asset: MeshAsset, what: ScenePlan) -> dict[str, Any]:
    apart = dict.fromkeys(w.node for body, w in what.wheels if body.asset == asset)
    return {
        **({"without_nodes": list(apart)} if apart else {}),
        "path": asset.path,
        "source": asset.source,
        "half_extents_cm": list(asset.half_extents),
        "collision": [_primitive(p) for p in asset.collision],
    }


def _primitive(p: Primitive) -> dict[str, Any]:
    out: dict[str, Any] = {
        "kind": p.kind,
        "size_cm": list(p.size),
        "position_cm": list(p.position),
        "quaternion": list(p.quaternion),
    }
    if p.vertices:
        out["vertices_cm"] = [list(v) for v in p.vertices]
    return out
