"""Planned starts: constellations, groups, corridors, anchors, decals."""

from __future__ import annotations

import itertools
import math

import pytest

from esg.layout import Constellation, Corridor, Placement, StartHints, solve
from esg.layout.problem.patterns import arrange
from tests.layout import builders as b

ASSETS = {
    "car": b.box("car", 450, 180, 150, is_wheeled=True),
    "bin": b.cylinder("bin", 30, 100),
    "table": b.table("table", 180, 150, 75),
    "bottle": b.cylinder("bottle", 4, 25),
    "tree": b.cylinder("tree", 30, 400, is_movable=False),
    "road": b.decal("road", 6000, 700, category="road"),
    "lane": b.decal("lane", 1900, 106, category="lane"),
    "pin": b.cylinder("pin", 6.05, 38),
    "ball": b.ball("ball", 10.8),
    "pool": b.table("pool", 254, 127, 80),
    "billiard": b.ball("billiard", 2.85),
    "domino": b.box("domino", 1, 2.4, 4.8),
}
CHAIN = Constellation(
    (Placement("car_1", 0, 0), Placement("bin_1", 1200, 0), Placement("table_1", 1700, 0, None)),
    (Corridor(((0.0, 0.0), (1800.0, 0.0)), 120.0, ("car_1", "bin_1", "table_1")),),
)


def layout(doc, *constellations: Constellation, seed: int = 0):
    out = solve(doc, seed=seed, hints=StartHints(constellations)).layout_result
    assert out is not None
    return out


def local(out, base: str, name: str) -> tuple[float, float]:
    """Position of a node in another node's frame."""
    (x, y, _), (u, v, _) = out.poses[name].position_cm, out.poses[base].position_cm
    a = math.radians(out.poses[base].yaw_deg)
    dx, dy = x - u, y - v
    return math.cos(a) * dx + math.sin(a) * dy, -math.sin(a) * dx + math.cos(a) * dy


def scene(trees: int = 6):
    nodes = {
        "road_1": ("road", {"is_structural": True}),
        "car_1": "car",
        "bin_1": "bin",
        "table_1": "table",
        **{f"tree_{i}": ("tree", {"mentioned": False}) for i in range(trees)},
        **{f"bottle_{i}": ("bottle", {"group": "bottles"}) for i in range(5)},
    }
    edges = [(f"bottle_{i}", "on", "table_1") for i in range(5)]
    return b.document(ASSETS, nodes, edges)


@pytest.mark.parametrize("seed", range(3))
def test_members_keep_their_relative_start(seed: int) -> None:
    out = layout(scene(), CHAIN, seed=seed)
    assert local(out, "car_1", "bin_1") == pytest.approx((1200, 0), abs=0.01)
    assert local(out, "car_1", "table_1") == pytest.approx((1700, 0), abs=0.01)
    assert out.feasible


@pytest.mark.parametrize("seed", range(3))
def test_bystanders_leave_the_corridor_and_the_road(seed: int) -> None:
    """A tree of radius 30 stays 150 cm off the path and outside the carriageway."""
    out = layout(scene(), CHAIN, seed=seed)
    for i in range(6):
        x, y = local(out, "car_1", f"tree_{i}")
        assert abs(y) >= 150 - 0.1 or x < -150 or x > 1950
        rx, ry = local(out, "road_1", f"tree_{i}")
        assert abs(ry) >= 350 + 30 - 1.0 or abs(rx) > 3000


def test_what_stands_on_a_participant_follows_it() -> None:
    out = layout(scene(), CHAIN)
    for i in range(5):
        x, y = local(out, "table_1", f"bottle_{i}")
        assert abs(x) <= 90 and abs(y) <= 75
        assert 0 <= out.poses[f"bottle_{i}"].position_cm[2] - 75 <= 0.05


def test_road_lies_under_the_motion() -> None:
    out = layout(scene(), CHAIN)
    assert abs(local(out, "road_1", "car_1")[1]) < 1.0
    turned = out.poses["road_1"].yaw_deg - out.poses["car_1"].yaw_deg
    assert abs(math.sin(math.radians(turned))) < 1e-3
    assert out.poses["road_1"].position_cm[2] == 0.0


def test_prescribed_yaw_and_start_in_the_air() -> None:
    doc = b.document(ASSETS, {"ball_1": "ball", "table_1": "table"})
    c = Constellation(
        (Placement("ball_1", 0, 0, z_cm=120.0), Placement("table_1", 400, 0)), yaw_deg=30.0
    )
    out = layout(doc, c)
    assert out.poses["ball_1"].position_cm[2] == 120.0
    (x, y, _), (u, v, _) = out.poses["ball_1"].position_cm, out.poses["table_1"].position_cm
    assert math.degrees(math.atan2(v - y, u - x)) == pytest.approx(30.0, abs=0.01)


def test_pins_stand_in_a_triangle_with_the_head_pin_towards_the_ball() -> None:
    nodes = {f"pin_{i}": ("pin", {"group": "pins", "group_pattern": "pins"}) for i in range(10)}
    doc = b.document(
        ASSETS, {"ball_1": "ball", "lane_1": ("lane", {"is_structural": True}), **nodes}
    )
    c = Constellation((Placement("ball_1", 0, 0), Placement("group:pins", 900, 0)))
    out = layout(doc, c)
    assert local(out, "ball_1", "pin_0") == pytest.approx((900, 0), abs=0.01)
    spots = [local(out, "ball_1", f"pin_{i}") for i in range(10)]
    nearest = min(math.dist(p, q) for i, p in enumerate(spots) for q in spots[:i])
    assert nearest == pytest.approx(30.48, abs=0.05)
    assert all(x >= 900 - 0.01 for x, _ in spots)
    assert abs(local(out, "lane_1", "ball_1")[1]) < 1.0


def test_free_heading_of_a_member_follows_its_face_relation() -> None:
    doc = b.document(ASSETS, {"car_1": "car", "table_1": "table"}, [("table_1", "face", "car_1")])
    c = Constellation((Placement("car_1", 0, 0), Placement("table_1", 900, 0, None)))
    out = layout(doc, c)
    assert abs(math.remainder(out.poses["table_1"].yaw_deg - out.poses["car_1"].yaw_deg, 360)) == (
        pytest.approx(180, abs=0.1)
    )
    assert out.relations[0].satisfied


def test_a_path_does_not_reach_back_behind_its_mover() -> None:
    """Who kicks a ball stands right behind it, however wide the path is."""
    doc = b.document(
        ASSETS,
        {"ball_1": "ball", "bin_1": "bin"},
        [("bin_1", "near", "ball_1")],
    )
    path = Corridor(((0.0, 0.0), (600.0, 0.0)), 120.0, ("ball_1",))
    out = layout(doc, Constellation((Placement("ball_1", 0, 0),), (path,)))
    assert out.relations[0].satisfied
    assert local(out, "ball_1", "bin_1")[0] < -40
    assert out.feasible


def test_anchor_frame_is_the_anchor_and_others_avoid_the_path() -> None:
    others = {f"b_{i}": ("billiard", {"group": "b", "group_pattern": "scatter"}) for i in range(6)}
    nodes = {"pool_1": "pool", "cue": "billiard", "black": "billiard", **others}
    doc = b.document(ASSETS, nodes, [(n, "on", "pool_1") for n in nodes if n != "pool_1"])
    path = Corridor(((-60.0, 0.0), (0.0, 10.0), (0.0, 60.0)), 4.0, ("cue", "black"))
    c = Constellation((Placement("cue", -60, 0), Placement("black", 0, 10)), (path,), "pool_1")
    out = layout(doc, c)
    assert local(out, "pool_1", "cue") == pytest.approx((-60, 0), abs=0.01)
    assert local(out, "pool_1", "black") == pytest.approx((0, 10), abs=0.01)
    for i in range(6):
        x, y = local(out, "pool_1", f"b_{i}")
        assert not (abs(x) < 2.85 + 3.9 and 6 < y < 62)
        assert 0 <= out.poses[f"b_{i}"].position_cm[2] - 80 <= 0.05
    assert out.feasible


def test_two_constellations_that_share_a_start_are_joined() -> None:
    doc = b.document(ASSETS, {"car_1": "car", "bin_1": "bin", "table_1": "table"})
    one = Constellation((Placement("car_1", 0, 0), Placement("bin_1", 800, 0)))
    two = Constellation((Placement("bin_1", 0, 0, 90.0), Placement("table_1", 500, 0)))
    out = layout(doc, one, two)
    assert local(out, "car_1", "bin_1") == pytest.approx((800, 0), abs=0.01)
    assert math.dist(
        out.poses["bin_1"].position_cm[:2], out.poses["table_1"].position_cm[:2]
    ) == pytest.approx(500, abs=0.01)


def test_contradicting_starts_are_reported() -> None:
    doc = b.document(ASSETS, {"car_1": "car", "bin_1": "bin"})
    one = Constellation((Placement("car_1", 0, 0), Placement("bin_1", 800, 0)))
    two = Constellation((Placement("car_1", 0, 0), Placement("bin_1", 500, 0)))
    out = layout(doc, one, two)
    assert "disagree by 300 cm" in out.reason


def test_unknown_names_in_hints_are_ignored_with_a_note() -> None:
    doc = b.document(ASSETS, {"car_1": "car"})
    out = layout(doc, Constellation((Placement("car_1", 0, 0), Placement("ghost", 5, 5))))
    assert "ghost" in out.reason
    assert out.feasible


def test_stack_rests_member_on_member() -> None:
    nodes = {f"c{i}": ("bin", {"group": "s", "group_pattern": "stack"}) for i in range(4)}
    out = layout(b.document(ASSETS, nodes))
    z = [out.poses[f"c{i}"].position_cm[2] for i in range(4)]
    for i, height in enumerate(z):
        assert 0 <= height - 100 * i <= 0.05 + 0.01 * i
    assert out.max_penetration_cm == 0.0


def test_a_stack_stays_one_where_a_single_member_has_a_start() -> None:
    nodes = {f"c{i}": ("bin", {"group": "s", "group_pattern": "stack"}) for i in range(4)}
    path = Corridor(((-500.0, 0.0), (200.0, 0.0)), 60.0, ("car_1", "c1"))
    start = Constellation((Placement("car_1", -500, 0), Placement("c1", 0, 0)), (path,))
    out = layout(b.document(ASSETS, {"car_1": "car", **nodes}), start)
    assert out.feasible, out.reason
    assert len({out.poses[f"c{i}"].position_cm[:2] for i in range(4)}) == 1
    assert [round(out.poses[f"c{i}"].position_cm[2] / 100.0) for i in range(4)] == [0, 1, 2, 3]


def test_a_row_is_kept_beside_the_member_that_is_hit() -> None:
    """The path to the one ends among the others, which stand across it."""
    nodes = {f"b{i}": ("billiard", {"group": "s", "group_pattern": "row"}) for i in range(5)}
    path = Corridor(((-90.0, 0.0), (0.0, 0.0), (100.0, 0.0)), 38.0, ("cue_1", "b0"))
    start = Constellation((Placement("cue_1", -90, 0), Placement("b0", 0, 0)), (path,))
    out = layout(b.document(ASSETS, {"cue_1": "billiard", **nodes}), start)
    assert out.feasible, out.reason
    spots = [out.poses[f"b{i}"].position_cm[:2] for i in range(5)]
    steps = {(round(q[0] - p[0], 2), round(q[1] - p[1], 2)) for p, q in itertools.pairwise(spots)}
    assert len(steps) == 1


@pytest.mark.parametrize("pattern", ["row", "queue", "column"])
def test_dominoes_stand_at_toppling_distance(pattern: str) -> None:
    """Each slab must reach its neighbour while falling, and none may touch."""
    import numpy as np

    spots = arrange(pattern, [(1.0, 2.4, 4.8)] * 12, np.random.default_rng(0))
    steps = [q[0] - p[0] for p, q in itertools.pairwise(spots)]
    assert all(0.4 * 4.8 <= s <= 0.6 * 4.8 for s in steps)
    assert all(s > 1.0 for s in steps)
    assert {p[1] for p in spots} == {0.0}


def test_rack_touches_nearly_but_never_overlaps() -> None:
    import numpy as np

    spots = arrange("rack", [(5.7, 5.7, 5.7)] * 15, np.random.default_rng(0))
    nearest = min(math.dist(p[:2], q[:2]) for i, p in enumerate(spots) for q in spots[:i])
    assert 5.7 < nearest < 5.7 + 0.3


def test_scatter_is_seeded_and_free_of_overlap() -> None:
    import numpy as np

    sizes = [(10.0, 20.0, 5.0)] * 30
    one = arrange("scatter", sizes, np.random.default_rng(3))
    two = arrange("scatter", sizes, np.random.default_rng(3))
    assert one == two
    radius = math.hypot(5, 10)
    assert all(math.dist(p[:2], q[:2]) > 2 * radius for i, p in enumerate(one) for q in one[:i])
