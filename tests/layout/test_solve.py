"""Layout of whole documents: supports, relations, collisions, determinism, degenerate input."""

from __future__ import annotations

import itertools
import math

import pytest

from esg.graph.models import EsgDocument, MultiRelation, SemanticRegion
from esg.layout import LayoutConfig, solve, solve_batch
from esg.layout.judge.check import penetrations, world_poses
from esg.layout.problem.problem import build_problem
from esg.outcomes import UserError
from tests.layout import builders as b

DESK = b.table("desk", 80, 160, 75, category="desk")
ASSETS = {
    "desk": DESK,
    "laptop": b.box("laptop", 25, 36, 3),
    "mug": b.cylinder("mug", 4, 10),
    "chair": b.box("chair", 50, 50, 90, category="chair"),
    "bin": b.bin_("bin", 30, 30, 40),
    "crate": b.box("crate", 40, 50, 30),
    "ball": b.ball("ball", 11),
    "paper": b.box("paper", 5, 5, 5),
    "plate": b.cylinder("plate", 12, 2),
    "wall": b.box("wall", 20, 400, 260, is_movable=False),
    "picture": b.box("picture", 4, 60, 40),
}


def result(doc: EsgDocument, **kw):
    out = solve(doc, **kw).layout_result
    assert out is not None
    return out


def gap(layout, doc: EsgDocument, a: str, c: str) -> float:
    """Planar gap of two axis-aligned or round objects along the line of centres' axes."""
    pa, pc = layout.poses[a], layout.poses[c]
    return math.dist(pa.position_cm[:2], pc.position_cm[:2])


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    ("relation", "axis", "sign"),
    [("left_of", 0, 1), ("right_of", 0, -1), ("in_front_of", 1, 1), ("behind", 1, -1)],
)
def test_directions_follow_the_frame(relation: str, axis: int, sign: int, seed: int) -> None:
    """Left is +X and front is +Y, for the `from` object relative to the `to` object."""
    doc = b.document(ASSETS, {"a": "crate", "z": "chair"}, [("a", relation, "z")])
    out = result(doc, seed=seed)
    difference = out.poses["a"].position_cm[axis] - out.poses["z"].position_cm[axis]
    assert sign * difference > 0
    assert out.relations[0].satisfied


def test_rests_exactly_on_support_through_three_levels() -> None:
    """A plate on a crate on a desk stands at the sum of the heights, within half a millimetre."""
    doc = b.document(
        ASSETS,
        {"desk_1": "desk", "crate_1": "crate", "plate_1": "plate"},
        [("crate_1", "on", "desk_1"), ("plate_1", "on", "crate_1")],
    )
    out = result(doc)
    z = {n: p.position_cm[2] for n, p in out.poses.items()}
    for name, height in (("desk_1", 0.0), ("crate_1", 75.0), ("plate_1", 105.0)):
        assert 0.0 <= z[name] - height <= 0.05
    assert (
        math.dist(out.poses["plate_1"].position_cm[:2], out.poses["crate_1"].position_cm[:2]) < 32
    )
    assert out.feasible


def test_sphere_with_centred_proxy_rests_on_its_lowest_point() -> None:
    doc = b.document(ASSETS, {"ball_1": "ball"})
    assert 0 <= result(doc).poses["ball_1"].position_cm[2] <= 0.05


def test_inside_stands_on_the_floor_of_the_container() -> None:
    doc = b.document(
        ASSETS, {"bin_1": "bin", "paper_1": "paper"}, [("paper_1", "inside_of", "bin_1")]
    )
    out = result(doc)
    assert 0 <= out.poses["paper_1"].position_cm[2] - 2.0 <= 0.05
    dx, dy, _ = (
        p - q
        for p, q in zip(
            out.poses["paper_1"].position_cm, out.poses["bin_1"].position_cm, strict=True
        )
    )
    assert max(abs(dx), abs(dy)) <= 13 - 2.5 + 0.01
    assert out.max_penetration_cm == 0.0


def test_inside_of_a_solid_box_is_reported() -> None:
    doc = b.document(ASSETS, {"c": "crate", "p": "paper"}, [("p", "inside_of", "c")])
    out = result(doc)
    assert not out.feasible
    assert "no inside" in out.reason


def test_under_uses_the_room_between_the_legs() -> None:
    doc = b.document(ASSETS, {"desk_1": "desk", "bin_1": "bin"}, [("bin_1", "under", "desk_1")])
    out = result(doc)
    assert out.relations[0].satisfied
    assert out.max_penetration_cm == 0.0
    assert gap(out, doc, "bin_1", "desk_1") < 80


def test_face_turns_towards_target_and_cardinal() -> None:
    doc = b.document(
        ASSETS,
        {"chair_1": "chair", "desk_1": "desk", "crate_1": "crate"},
        [
            ("chair_1", "near", "desk_1"),
            ("chair_1", "face", "desk_1"),
            ("crate_1", "face", "ground_1", {"cardinal": "-X"}),
        ],
    )
    out = result(doc)
    (x, y, _), (u, v, _) = out.poses["chair_1"].position_cm, out.poses["desk_1"].position_cm
    off = math.remainder(
        math.radians(out.poses["chair_1"].yaw_deg) - math.atan2(v - y, u - x), 2 * math.pi
    )
    assert abs(math.degrees(off)) < 20
    assert abs(math.remainder(out.poses["crate_1"].yaw_deg - 180, 360)) < 20


def test_chair_turns_to_its_desk_without_being_told() -> None:
    doc = b.document(
        ASSETS,
        {"chair_1": "chair", "desk_1": "desk"},
        [("chair_1", "near", "desk_1")],
    )
    out = result(doc)
    (x, y, _), (u, v, _) = out.poses["chair_1"].position_cm, out.poses["desk_1"].position_cm
    off = math.radians(out.poses["chair_1"].yaw_deg) - math.atan2(v - y, u - x)
    assert abs(math.degrees(math.remainder(off, 2 * math.pi))) < 25


def test_center_of_and_prescribed_distance() -> None:
    doc = b.document(
        ASSETS,
        {"desk_1": "desk", "mug_1": "mug", "crate_1": "crate", "crate_2": "crate"},
        [
            ("mug_1", "on", "desk_1"),
            ("mug_1", "center_of", "desk_1"),
            ("crate_1", "left_of", "crate_2", {"distance_cm": 150.0}),
        ],
    )
    out = result(doc)
    assert gap(out, doc, "mug_1", "desk_1") < 2.0
    (x, y, _), (u, v, _) = out.poses["crate_1"].position_cm, out.poses["crate_2"].position_cm
    assert 150 + 40 - 15 < math.hypot(x - u, y - v) < 150 + 64 + 5
    assert all(r.satisfied for r in out.relations)


def test_near_is_nearer_than_far_from() -> None:
    nodes = {"a": "crate", "c": "crate"}
    near = result(b.document(ASSETS, nodes, [("a", "near", "c")]))
    far = result(b.document(ASSETS, nodes, [("a", "far_from", "c")]))
    assert gap(near, None, "a", "c") + 50 < gap(far, None, "a", "c")  # type: ignore[arg-type]
    assert near.relations[0].satisfied and far.relations[0].satisfied


@pytest.mark.parametrize("seed", range(4))
def test_crowded_desk_has_no_overlap(seed: int) -> None:
    """Twelve small things on one desk keep half a centimetre of air."""
    nodes = {"desk_1": "desk", **{f"mug_{i}": "mug" for i in range(8)}}
    nodes |= {f"laptop_{i}": "laptop" for i in range(4)}
    edges = [(n, "on", "desk_1") for n in nodes if n != "desk_1"]
    doc = b.document(ASSETS, nodes, edges)
    out = result(doc, seed=seed)
    assert out.feasible and out.max_penetration_cm == 0.0
    for i in range(8):
        for j in range(i):
            assert gap(out, doc, f"mug_{i}", f"mug_{j}") >= 8.0 + 0.5


def test_too_small_table_says_so_and_keeps_everything() -> None:
    nodes = {"desk_1": "desk", **{f"laptop_{i}": "laptop" for i in range(20)}}
    doc = b.document(ASSETS, nodes, [(n, "on", "desk_1") for n in nodes if n != "desk_1"])
    out = result(doc, config=LayoutConfig(rounds=1))
    assert not out.feasible
    assert "desk_1 is too small: 20 objects" in out.reason
    assert len(out.poses) == 22


def test_semantic_region_bounds_hold() -> None:
    """A region given by bounds in the parent's frame confines its objects."""
    region = SemanticRegion(
        region_description="left end of the desk",
        region_type="SUPPORT_SURFACE",
        parent_object="desk_1",
        bounds_cm=((-40, 30, 75), (40, 80, 75)),
    )
    doc = b.document(
        ASSETS,
        {"desk_1": "desk", "mug_1": ("mug", {"semantic_region": "r"})},
        regions={"r": region},
    )
    problem = build_problem(doc, 0, None)
    out = result(doc)
    (x, y, z), (u, v, _) = out.poses["mug_1"].position_cm, out.poses["desk_1"].position_cm
    yaw = math.radians(out.poses["desk_1"].yaw_deg)
    local_y = -math.sin(yaw) * (x - u) + math.cos(yaw) * (y - v)
    assert 34 - 0.05 <= local_y <= 76 + 0.05
    assert abs(z - 75) < 0.05
    assert problem.supports.of["mug_1"].parent == "desk_1"


def test_surround_spreads_evenly_and_faces_the_middle() -> None:
    nodes = {"desk_1": "desk", **{f"chair_{i}": "chair" for i in range(4)}}
    multi = MultiRelation(
        subjects=tuple(f"chair_{i}" for i in range(4)),
        targets=("desk_1",),
        relation_type="surround",
    )
    out = result(b.document(ASSETS, nodes, multi=[multi]))
    u, v, _ = out.poses["desk_1"].position_cm
    angles = sorted(
        math.atan2(
            out.poses[f"chair_{i}"].position_cm[1] - v, out.poses[f"chair_{i}"].position_cm[0] - u
        )
        for i in range(4)
    )
    steps = [*(y - x for x, y in itertools.pairwise(angles))]
    assert min(steps) > math.radians(45)
    assert out.feasible and out.relations[0].satisfied


def test_between_and_align() -> None:
    nodes = {k: "crate" for k in ("a", "c", "d", "e", "f")}
    between = MultiRelation(subjects=("a",), targets=("c", "d"), relation_type="between")
    align = MultiRelation(subjects=("d", "e", "f"), relation_type="align")
    out = result(b.document(ASSETS, nodes, multi=[between, align]))
    assert all(r.satisfied for r in out.relations)
    p = {k: out.poses[k].position_cm for k in nodes}
    mid = [(p["c"][k] + p["d"][k]) / 2 for k in (0, 1)]
    assert math.dist(mid, p["a"][:2]) < 25
    cross = (p["e"][0] - p["d"][0]) * (p["f"][1] - p["d"][1]) - (p["e"][1] - p["d"][1]) * (
        p["f"][0] - p["d"][0]
    )
    assert abs(cross) / max(1.0, math.dist(p["f"][:2], p["d"][:2])) < 8


def test_same_seed_same_bytes_other_seed_other_layout() -> None:
    nodes = {f"c{i}": "crate" for i in range(6)}
    doc = b.document(ASSETS, nodes)
    one, two, three = (solve(doc, seed=s).model_dump_json() for s in (1, 1, 2))
    assert one == two
    assert one != three


def test_batch_equals_single() -> None:
    docs = [
        b.document(ASSETS, {f"c{i}": "crate" for i in range(n)}, [("c0", "near", "c1")])
        for n in (2, 5, 9)
    ]
    together = solve_batch(docs, [3, 4, 5])
    alone = [solve(d, seed=s) for d, s in zip(docs, (3, 4, 5), strict=True)]
    assert [d.model_dump_json() for d in together] == [d.model_dump_json() for d in alone]


def test_input_is_untouched_and_provenance_written() -> None:
    doc = b.document(ASSETS, {"a": "crate"})
    before = doc.model_dump_json()
    out = solve(doc, seed=7)
    assert doc.model_dump_json() == before
    assert (out.provenance[-1].stage, out.provenance[-1].seed) == ("layout", 7)


def test_cyclic_relations_end_and_are_reported() -> None:
    """Contradictions cost a report, not a hang."""
    edges = [
        ("a", "left_of", "c"),
        ("c", "left_of", "a"),
        ("a", "on", "c"),
        ("c", "on", "a"),
        ("d", "near", "d"),
    ]
    out = result(b.document(ASSETS, {k: "crate" for k in "acd"}, edges))
    assert sum(not r.satisfied for r in out.relations) >= 3
    assert not out.feasible
    assert "cycle" in out.reason


def test_odd_relations_never_crash() -> None:
    """Relations to the ground, to oneself, to nobody; empty multi relations."""
    edges = [
        ("a", "near", "ground_1"),
        ("a", "center_of", "ground_1"),
        ("a", "attached_vertical", "ground_1"),
        ("a", "face", "a"),
        ("a", "near", "ghost"),
    ]
    multi = [
        MultiRelation(subjects=(), targets=("a",), relation_type="surround"),
        MultiRelation(subjects=("a", "c"), targets=("d",), relation_type="between"),
        MultiRelation(subjects=("a",), relation_type="align"),
    ]
    out = result(b.document(ASSETS, {k: "crate" for k in "acd"}, edges, multi))
    assert [r.satisfied for r in out.relations[:5]] == [True, True, True, False, False]
    assert out.max_penetration_cm == 0.0


def test_zero_size_object_and_oversized_child() -> None:
    assets = {
        **ASSETS,
        "dot": b.asset("dot", (), (0.0, 0.0, 0.0)),
        "board": b.box("board", 120, 120, 2),
    }
    doc = b.document(
        assets,
        {"dot_1": "dot", "crate_1": "crate", "board_1": "board"},
        [("board_1", "on", "crate_1"), ("dot_1", "near", "crate_1")],
    )
    out = result(doc)
    assert gap(out, doc, "board_1", "crate_1") < 1.0
    assert all(math.isfinite(v) for p in out.poses.values() for v in p.position_cm)


@pytest.mark.slow
def test_two_hundred_objects() -> None:
    doc = b.document(ASSETS, {f"c{i}": "crate" for i in range(200)})
    out = result(doc, config=LayoutConfig(starts=2, rounds=1))
    assert out.feasible and out.max_penetration_cm == 0.0


def test_missing_asset_configuration_is_a_user_error() -> None:
    doc = b.document(ASSETS, {"a": "crate", "c": "unicorn"})
    with pytest.raises(UserError, match="unicorn"):
        solve(doc)


@pytest.mark.parametrize("mode", ["proxy", "aabb", "sdf", "hybrid"])
def test_every_collision_mode_separates_crates(mode: str) -> None:
    nodes = {f"c{i}": "crate" for i in range(6)}
    doc = b.document(ASSETS, nodes, [(f"c{i}", "near", "c0") for i in range(1, 6)])
    config = LayoutConfig(collision=mode, rounds=1)  # type: ignore[arg-type]
    out = result(doc, config=config)
    assert out.max_penetration_cm == 0.0


def test_refinement_lowers_the_energy_of_a_random_start() -> None:
    nodes = {f"c{i}": "crate" for i in range(8)}
    doc = b.document(ASSETS, nodes, [(f"c{i}", "adjacent", f"c{i - 1}") for i in range(1, 8)])
    config = LayoutConfig(sample_init=False, rounds=1, starts=4)
    out = result(doc, config=config)
    assert out.energy < 0.2 * out.energy_terms["initial"]


def test_reported_penetration_matches_an_independent_count() -> None:
    nodes = {"desk_1": "desk", **{f"laptop_{i}": "laptop" for i in range(20)}}
    doc = b.document(ASSETS, nodes, [(n, "on", "desk_1") for n in nodes if n != "desk_1"])
    config = LayoutConfig(rounds=1, starts=2)
    out = result(doc, config=config)
    import shapely

    boxes = []
    for i in range(20):
        p = out.poses[f"laptop_{i}"]
        box = shapely.box(-12.5, -18, 12.5, 18)
        box = shapely.affinity.rotate(box, p.yaw_deg, origin=(0, 0))
        boxes.append(shapely.affinity.translate(box, *p.position_cm[:2]))
    overlaps = any(x.intersection(y).area > 1 for i, x in enumerate(boxes) for y in boxes[:i])
    assert overlaps == (out.max_penetration_cm > 0)


def test_world_pose_composition_is_rigid() -> None:
    """Children keep their distance to their parent under the parent's yaw."""
    doc = b.document(ASSETS, {"desk_1": "desk", "mug_1": "mug"}, [("mug_1", "on", "desk_1")])
    problem = build_problem(doc, 0, None)
    import numpy as np

    units = np.zeros((len(problem.units), 3))
    order = {next(iter(u.members)): i for i, u in enumerate(problem.units)}
    units[order["desk_1"]] = (100.0, 50.0, math.pi / 2)
    units[order["mug_1"]] = (30.0, 10.0, 0.3)
    world = world_poses(problem, units)
    assert world.pose["mug_1"][:2] == pytest.approx((90.0, 80.0))
    assert world.pose["mug_1"][2] == pytest.approx(math.pi / 2 + 0.3)
    assert penetrations(problem, world) == []


def test_search_is_silent_on_standard_output() -> None:
    """Callers print one JSON document on standard output and nothing else."""
    import subprocess
    import sys

    code = (
        "from tests.layout import builders as b; from esg.layout import solve;"
        "solve(b.document({'a': b.box('a', 5, 5, 5)}, {'x': 'a'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == ""
