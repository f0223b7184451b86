"""Shapes: what builders draw with, colliders, mass properties, meshes and distance fields.

`sketch` and `collider` record a drawing, `shapes` makes its meshes, `stretch` and `rolling` change
it, `fitting`, `convex` and `boxes` fit colliders to foreign meshes, `mesh` writes GLB files.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.assets.geometry.mesh import build_mesh, glb_bytes, write_meshes
    from esg.assets.geometry.sdf import VoxelSdf, voxel_sdf
    from esg.assets.geometry.sketch import Color, Sketch

__all__ = [
    "Color",
    "Sketch",
    "VoxelSdf",
    "build_mesh",
    "glb_bytes",
    "voxel_sdf",
    "write_meshes",
]

_HOME = {
    "Color": "sketch",
    "Sketch": "sketch",
    "build_mesh": "mesh",
    "glb_bytes": "mesh",
    "write_meshes": "mesh",
    "VoxelSdf": "sdf",
    "voxel_sdf": "sdf",
}


def __getattr__(name: str) -> Any:
    # what is behind a name loads when it is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
