"""Warp kernels that measure given layouts: distances of footprints and energies of scenes."""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

from __future__ import annotations

import warp as wp

from esg.layout.kernels.energy import spread, total_energy
from esg.layout.kernels.planar import Problem, separation

wp.set_module_options({"enable_backward": False, "max_unroll": 1})


@wp.kernel
def separations(
    kind: wp.array(dtype=wp.vec2i),
    pa: wp.array(dtype=wp.vec3),
    pb: wp.array(dtype=wp.vec3),
    ha: wp.array(dtype=wp.vec2),
    hb: wp.array(dtype=wp.vec2),
    out: wp.array(dtype=wp.float32),
):
    """Signed distances of footprint pairs [cm], shape [n]."""
    i = wp.tid()
    k = kind[i]
    out[i] = separation(k[0], pa[i], ha[i], k[1], pb[i], hb[i])


@wp.kernel
def evaluate(
    p: Problem,
    soft: float,
    x: wp.array(dtype=wp.vec3),
    w: wp.array(dtype=wp.vec3),
    energy: wp.array(dtype=wp.vec3),
):
    """Relation, collision and region energy of one layout per scene: x [units], energy [scenes]."""
    scene = wp.tid()
    for u in range(p.scene_unit[scene], p.scene_unit[scene + 1]):
        spread(p, w, x, 0, 0, u, 1 << 30)
    energy[scene] = total_energy(p, w, 0, scene, soft)
