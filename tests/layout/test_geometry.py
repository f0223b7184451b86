"""Footprints and separations against an independent geometry library."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
import shapely.affinity

from esg.graph.models import Proxy, ProxyKind
from esg.layout import solve
from esg.layout.judge.check import plan_separation, prim_penetration
from esg.layout.problem.edges import near_band
from esg.layout.problem.shapes import Footprint, footprint, footprints, rotation
from esg.layout.problem.supports import shape_of
from tests.layout import builders as b


def polygon(kind: int, pose: tuple[float, float, float], half: tuple[float, float]):
    if kind == 0:
        return shapely.Point(pose[:2]).buffer(half[0], 128)
    box = shapely.affinity.rotate(
        shapely.box(-half[0], -half[1], half[0], half[1]), math.degrees(pose[2]), origin=(0, 0)
    )
    return shapely.affinity.translate(box, pose[0], pose[1])


def test_separation_never_misses_an_overlap() -> None:
    """The sign is exact, and the distance is a lower bound within the corner error."""
    rng = np.random.default_rng(5)
    for _ in range(400):
        ka, kb = (int(v) for v in rng.integers(0, 2, 2))
        pa, pb = ((*tuple(rng.uniform(-15, 15, 2)), rng.uniform(0, 7)) for _ in range(2))
        ha, hb = (tuple(rng.uniform(1, 10, 2)) for _ in range(2))
        d = plan_separation(ka, pa, ha, kb, pb, hb)
        p, q = polygon(ka, pa, ha), polygon(kb, pb, hb)
        true = p.distance(q)
        if p.intersection(q).area > 1e-2:
            assert d < 0
        elif true > 1e-2:
            assert 0 < d <= true + 0.02
            assert d >= 0.6 * true


def test_separation_is_exact_for_parallel_boxes_and_circles() -> None:
    assert plan_separation(1, (0, 0, 0), (2, 1), 1, (7, 6, 0), (2, 1)) == pytest.approx(5.0)
    assert plan_separation(0, (0, 0, 0), (2, 2), 0, (3, 4, 0), (1, 1)) == pytest.approx(2.0)
    assert plan_separation(0, (0, 0, 0), (1, 1), 1, (5, 6, 0), (2, 2)) == pytest.approx(4.0)


def test_kernel_separation_agrees_with_the_check() -> None:
    """The search and the judge measure the same distance."""
    import warp as wp

    from esg.layout.kernels import evaluation

    rng = np.random.default_rng(1)
    n = 64
    kinds = rng.integers(0, 2, (n, 2)).astype(np.int32)
    poses = rng.uniform(-10, 10, (n, 2, 3)).astype(np.float32)
    halves = rng.uniform(1, 6, (n, 2, 2)).astype(np.float32)
    out = wp.zeros(n, dtype=wp.float32, device="cpu")
    wp.launch(
        evaluation.separations,
        dim=n,
        inputs=[
            wp.array(kinds, dtype=wp.vec2i, device="cpu"),
            wp.array(np.ascontiguousarray(poses[:, 0]), dtype=wp.vec3, device="cpu"),
            wp.array(np.ascontiguousarray(poses[:, 1]), dtype=wp.vec3, device="cpu"),
            wp.array(np.ascontiguousarray(halves[:, 0]), dtype=wp.vec2, device="cpu"),
            wp.array(np.ascontiguousarray(halves[:, 1]), dtype=wp.vec2, device="cpu"),
        ],
        outputs=[out],
        device="cpu",
    )
    expected = [
        plan_separation(
            int(kinds[i, 0]), tuple(poses[i, 0]), tuple(halves[i, 0]),
            int(kinds[i, 1]), tuple(poses[i, 1]), tuple(halves[i, 1]),
        )
        for i in range(n)
    ]  # fmt: skip
    assert out.numpy() == pytest.approx(expected, abs=2e-4)


def test_spheres_of_different_size_side_by_side_do_not_penetrate() -> None:
    """Their circles overlap in plan although the balls only touch."""
    big = Footprint(0, 0, 0, 0, 10, 10, 0, 20, True)
    small = Footprint(0, 0, 0, 0, 2, 2, 0, 4, True)
    touching = 2 * math.sqrt(10 * 2)
    assert prim_penetration(big, (0, 0, 0), 0, small, (touching + 0.01, 0, 0), 0) == 0.0
    assert prim_penetration(big, (0, 0, 0), 0, small, (touching - 1, 0, 0), 0) > 0.3


def test_lying_cylinder_has_a_rectangular_footprint() -> None:
    s = math.sqrt(0.5)
    log = Proxy(
        kind=ProxyKind.CYLINDER,
        size_cm=(5, 5, 40),
        position_cm=(0, 0, 5),
        orientation_xyzw=(0, s, 0, s),
    )
    f = footprint(log)
    assert (f.kind, f.z0, f.z1) == (1, pytest.approx(0), pytest.approx(10))
    assert sorted((f.hx, f.hy)) == pytest.approx([5, 40])


def test_near_band_follows_the_paper() -> None:
    """d* = clamp(min(s/2, 0.1 S_R), 8, 300); two 1 m cubes: s = 1 m, d* = 50, band 40-60 cm."""
    cube = shape_of(b.box("cube", 100, 100, 100))
    assert near_band(cube, cube, 3000) == pytest.approx((40, 60))
    tiny = shape_of(b.box("tiny", 4, 4, 4))
    assert near_band(tiny, tiny, 3000) == pytest.approx((6, 10))
    assert near_band(cube, cube, 200) == pytest.approx((16, 24))


def test_a_slope_is_sliced_and_its_slices_hold_it() -> None:
    # a plank of 120 x 60 x 4 cm, raised by 20 degrees and turned by 35 degrees
    pitch, yaw = math.radians(-20.0), math.radians(35.0)
    cy, sy, cz, sz = math.cos(pitch / 2), math.sin(pitch / 2), math.cos(yaw / 2), math.sin(yaw / 2)
    plank = Proxy(
        kind=ProxyKind.BOX,
        size_cm=(60, 30, 2),
        position_cm=(0, 0, 23),
        orientation_xyzw=(-sz * sy, cz * sy, sz * cy, cz * cy),
    )
    config = b.asset("plank", (plank,), (120, 60, 46))
    prisms = footprints(config)
    whole = footprint(plank)
    assert len(prisms) == 6
    rng = np.random.default_rng(0)
    local = rng.uniform(-1, 1, (2000, 3)) * np.array(plank.size_cm)
    solid = local @ rotation(plank.orientation_xyzw).T + np.array(plank.position_cm)
    covered = np.zeros(len(solid), bool)
    for f in prisms:
        dx, dy = solid[:, 0] - f.x, solid[:, 1] - f.y
        x = math.cos(f.yaw) * dx + math.sin(f.yaw) * dy
        y = -math.sin(f.yaw) * dx + math.cos(f.yaw) * dy
        covered |= (
            (np.abs(x) <= f.hx + 1e-6) & (np.abs(y) <= f.hy + 1e-6)
            & (solid[:, 2] >= f.z0 - 1e-6) & (solid[:, 2] <= f.z1 + 1e-6)
        )  # fmt: skip
    assert covered.all()

    def volume(fs: tuple[Footprint, ...]) -> float:
        return sum(4 * f.hx * f.hy * (f.z1 - f.z0) for f in fs)

    assert volume(prisms) < 0.4 * volume((whole,))
    # heights rise along the slope
    middle = [0.5 * (f.z0 + f.z1) for f in prisms]
    assert middle == sorted(middle) or middle == sorted(middle, reverse=True)


def test_something_low_stands_under_the_upper_end_of_a_ramp() -> None:
    pitch = math.radians(-25.0)
    plank = Proxy(
        kind=ProxyKind.BOX,
        size_cm=(100, 40, 2),
        position_cm=(0, 0, 46),
        orientation_xyzw=(0.0, math.sin(pitch / 2), 0.0, math.cos(pitch / 2)),
    )
    ramp = b.asset("ramp", (plank,), (182, 80, 92))
    doc = b.document(
        {"ramp": ramp, "cube": b.box("cube", 20, 20, 20)},
        {"ramp_1": "ramp", "cube_1": "cube"},
        [("cube_1", "under", "ramp_1")],
    )
    out = solve(doc).layout_result
    assert out is not None and out.feasible and all(r.satisfied for r in out.relations)
    assert out.max_penetration_cm < 0.05
