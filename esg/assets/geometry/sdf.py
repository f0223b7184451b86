"""Voxel signed distance fields by a Warp kernel, with a sign that survives open meshes.

The sign is the generalized winding number's (Barill et al. 2018, in `wp.Mesh`): it degrades
gracefully at holes, where parity and pseudo-normals flip whole regions. Imported lazily.
"""

from __future__ import annotations

# Warp reads annotations and operators as its own language.
# pyright: reportOperatorIssue=false, reportAttributeAccessIssue=false
from dataclasses import dataclass
from functools import lru_cache
import hashlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_MARGIN = 1.1


@dataclass(frozen=True)
class VoxelSdf:
    """Distances at the centres of cubic cells; negative inside.

    Args:
        values: [cm], shape [n, n, n], axes x, y, z, float32.
        origin_cm: Corner of the grid, shape [3].
        cell_cm: Edge of a cell.
    """

    values: NDArray[np.float32]
    origin_cm: NDArray[np.float64]
    cell_cm: float

    def sample(self, points_cm: NDArray[np.float64]) -> NDArray[np.float64]:
        """Trilinear distance at points, shape [k, 3] -> [k]; outside the grid, its border's."""
        n = self.values.shape[0]
        u = (np.asarray(points_cm) - self.origin_cm) / self.cell_cm - 0.5
        u = np.clip(u, 0, n - 1 - 1e-9)
        i = np.minimum(u.astype(int), n - 2)
        f = u - i
        total = np.zeros(len(u))
        for corner in range(8):
            d = np.array([(corner >> k) & 1 for k in range(3)])
            weight = np.prod(np.where(d, f, 1 - f), axis=1)
            x, y, z = (i + d).T
            total += weight * self.values[x, y, z]
        return total

    @property
    def volume_cm3(self) -> float:
        """Volume inside, with half cells at the surface."""
        inside = np.clip(0.5 - self.values / self.cell_cm, 0.0, 1.0)
        return float(inside.sum()) * self.cell_cm**3


@lru_cache(maxsize=1)
def _kernel() -> Any:
    import warp as wp

    @wp.kernel
    def distances(
        mesh: wp.uint64,
        corner: wp.vec3,
        cell: float,
        n: int,
        reach: float,
        out: wp.array(dtype=float),  # type: ignore[valid-type]  # Warp reads it at run time
    ):
        t = wp.tid()
        i = t // (n * n)
        j = (t // n) % n
        k = t % n
        p = corner + wp.vec3(float(i) + 0.5, float(j) + 0.5, float(k) + 0.5) * cell
        q = wp.mesh_query_point_sign_winding_number(mesh, p, reach)
        closest = wp.mesh_eval_position(mesh, q.face, q.u, q.v)
        out[t] = wp.length(p - closest) * q.sign

    return distances


def voxel_sdf(
    vertices: NDArray[np.float64],
    faces: NDArray[np.int64],
    resolution: int = 48,
    cache: Path | None = None,
    device: str = "cpu",
) -> VoxelSdf:
    """Signed distance field of a mesh that need not be closed.

    Args:
        vertices: [cm], shape [m, 3].
        faces: Shape [f, 3].
        resolution: Cells an edge.
        cache: Folder of results by content.
        device: Warp device.
    """
    vertices = np.asarray(vertices, np.float64)
    digest = hashlib.sha256(f"sdf1 {resolution}".encode())
    digest.update(np.round(vertices, 4).astype("<f8").tobytes())
    digest.update(np.asarray(faces).astype("<i8").tobytes())
    stored = cache / f"{digest.hexdigest()}.npz" if cache else None
    low, high = vertices.min(0), vertices.max(0)
    cell = float((high - low).max()) * _MARGIN / resolution
    origin = (low + high) / 2 - cell * resolution / 2
    if stored is not None and stored.is_file():
        with np.load(stored) as archive:
            return VoxelSdf(archive["values"], origin, cell)
    from esg.engines.newton import quiet_warp

    wp = quiet_warp()
    mesh = wp.Mesh(
        points=wp.array(vertices.astype(np.float32), dtype=wp.vec3, device=device),
        indices=wp.array(np.asarray(faces).flatten().astype(np.int32), dtype=int, device=device),
        support_winding_number=True,
    )
    out = wp.zeros(resolution**3, dtype=float, device=device)
    wp.launch(
        _kernel(),
        resolution**3,
        [mesh.id, wp.vec3(*origin.tolist()), cell, resolution, 1e6],
        [out],
        device=device,
    )
    values = out.numpy().reshape(resolution, resolution, resolution)
    if stored is not None:
        stored.parent.mkdir(parents=True, exist_ok=True)
        partial = stored.with_suffix(".part.npz")
        np.savez_compressed(partial, values=values)
        partial.replace(stored)
    return VoxelSdf(values, origin, cell)
