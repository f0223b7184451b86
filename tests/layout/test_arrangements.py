"""What people would call tidy: rows that continue, queues along their lane, full shelves."""

from __future__ import annotations

import itertools
import math
import time

import pytest

from esg.graph.models import EsgDocument, MultiRelation, Proxy, ProxyKind, SupportSurface
from esg.layout import Constellation, Corridor, LayoutConfig, Placement, StartHints, solve
from tests.layout.builders import asset, ball, box, cylinder, decal, document, table


def _poses(doc: EsgDocument) -> dict[str, tuple[float, float, float, float]]:
    assert doc.layout_result is not None
    return {n: (*p.position_cm, p.yaw_deg) for n, p in doc.layout_result.poses.items()}


def _slabs(count: int, **size: float) -> EsgDocument:
    slab = box("slab", size.get("x", 0.75), size.get("y", 2.4), size.get("z", 4.8))
    member = {"group": "slabs", "group_pattern": "row"}
    return document({"slab": slab}, {f"slab_{k}": ("slab", member) for k in range(count)})


def _push(name: str) -> StartHints:
    path = Corridor(((0.0, 0.0), (100.0, 0.0)), 20.0, (name,))
    return StartHints((Constellation((Placement(name, 0.0, 0.0),), (path,)),))


def test_the_row_of_a_pushed_domino_continues_at_toppling_distance() -> None:
    out = solve(_slabs(20), hints=_push("slab_0"))
    at = _poses(out)
    assert out.layout_result is not None and out.layout_result.feasible
    steps = [math.dist(at[f"slab_{k}"][:2], at[f"slab_{k + 1}"][:2]) for k in range(19)]
    assert max(steps) - min(steps) < 0.01
    assert 0.4 * 4.8 <= steps[0] <= 0.6 * 4.8
    heading = math.radians(at["slab_0"][3])
    ahead = math.atan2(at["slab_1"][1] - at["slab_0"][1], at["slab_1"][0] - at["slab_0"][0])
    assert abs(math.remainder(ahead - heading, 2 * math.pi)) < 0.01


@pytest.mark.parametrize("heading", [0.0, 180.0])
def test_a_row_continues_behind_the_domino_that_is_hit(heading: float) -> None:
    slabs = _slabs(8)
    marble = ball("marble", 1.0)
    doc = document(
        {**slabs.asset_configurations, "marble": marble},
        {n: (v.asset_id, {"group": v.group, "group_pattern": v.group_pattern})
         for n, v in slabs.spatial_relation_graph.nodes.items() if n != "ground_1"}
        | {"marble_1": "marble"},
    )  # fmt: skip
    path = Corridor(((0.0, 0.0), (90.0, 0.0)), 2.0, ("marble_1", "slab_0"))
    starts = (Placement("marble_1", 0.0, 0.0), Placement("slab_0", 91.5, 0.0, heading))
    out = solve(doc, hints=StartHints((Constellation(starts, (path,)),)))
    at = _poses(out)
    assert out.layout_result is not None and out.layout_result.feasible
    far = [math.dist(at["marble_1"][:2], at[f"slab_{k}"][:2]) for k in range(8)]
    assert far == sorted(far)
    assert 0.4 * 4.8 <= far[1] - far[0] <= 0.6 * 4.8


def test_a_row_never_continues_into_a_planned_path() -> None:
    # crates are not there to be run into: they stand aside
    out = solve(_slabs(4, x=40, y=40, z=40), hints=_push("slab_0"))
    assert out.layout_result is not None and out.layout_result.feasible
    at = _poses(out)
    heading = math.radians(at["slab_0"][3])
    for k in (1, 2, 3):
        dx, dy = at[f"slab_{k}"][0] - at["slab_0"][0], at[f"slab_{k}"][1] - at["slab_0"][1]
        along = math.cos(heading) * dx + math.sin(heading) * dy
        across = abs(-math.sin(heading) * dx + math.cos(heading) * dy)
        assert across > 39.0 or along < -30.0 or along > 130.0


def test_a_lane_lies_along_its_queue_of_cars() -> None:
    car = box("car", 455, 182, 146, is_wheeled=True)
    member = {"group": "cars", "group_pattern": "queue"}
    nodes = {f"car_{k}": ("car", member) for k in range(5)}
    lane = {"lane_1": ("lane", {"is_structural": True})}
    doc = document(
        {"car": car, "lane": decal("lane", 6000, 400, category="road")},
        {**nodes, **lane},
        [("car_0", "face", "ground_1", {"cardinal": "+Y"})],
    )
    at = _poses(solve(doc))
    lane_yaw = math.radians(at["lane_1"][3])
    for k in range(5):
        assert abs(math.sin(math.radians(at[f"car_{k}"][3]) - lane_yaw)) < 1e-3
        dx, dy = at[f"car_{k}"][0] - at["lane_1"][0], at[f"car_{k}"][1] - at["lane_1"][1]
        assert abs(-math.sin(lane_yaw) * dx + math.cos(lane_yaw) * dy) < 1.0


def _bookshelf(shelves: int) -> EsgDocument:
    heights = [40.0 * (k + 1) for k in range(shelves)]
    proxies = tuple(
        Proxy(kind=ProxyKind.BOX, size_cm=(15, 40, 1), position_cm=(0, 0, z - 1))
        for z in (2.0, *heights)
    )
    tops = tuple(
        SupportSurface(name=f"s{k}", center_cm=(0, 0, z), half_extents_cm=(15, 40))
        for k, z in enumerate(heights)
    )
    rack = asset("rack", proxies, (30, 80, heights[-1]), support_surfaces=tops)
    nodes = {"rack_1": "rack"} | {f"book_{k}": "book" for k in range(10)}
    edges = [(f"book_{k}", "on", "rack_1") for k in range(10)]
    return document({"rack": rack, "book": box("book", 15, 20, 4)}, nodes, edges)


def test_books_fill_several_shelves_and_keep_to_one_if_there_is_one() -> None:
    out = solve(_bookshelf(4))
    assert out.layout_result is not None and out.layout_result.feasible
    heights = {round(z - 0.01, 1) for n, (_, _, z, _) in _poses(out).items() if "book" in n}
    assert heights <= {40.0, 80.0, 120.0, 160.0} and len(heights) >= 2
    crowded = solve(_bookshelf(1))
    assert crowded.layout_result is not None and not crowded.layout_result.feasible
    assert "rack_1 is too small: 10 objects" in crowded.layout_result.reason


def test_what_is_taller_than_the_gap_stays_on_top() -> None:
    doc = _bookshelf(3)
    tall = box("book", 15, 20, 60)
    doc = doc.model_copy(
        update={"asset_configurations": {**doc.asset_configurations, "book": tall}}
    )
    heights = {z for n, (_, _, z, _) in _poses(solve(doc)).items() if "book" in n}
    assert len(heights) == 1 and max(heights) > 119.0


def test_eight_plates_around_a_round_table_lie_on_it() -> None:
    top = SupportSurface(name="top", center_cm=(0, 0, 75), half_extents_cm=(60, 60))
    disc = cylinder("disc", 60, 75, support_surfaces=(top,))
    names = [f"plate_{k}" for k in range(8)]
    doc = document(
        {"disc": disc, "plate": cylinder("plate", 13, 2)},
        {"table_1": "disc"} | dict.fromkeys(names, "plate"),
        [(n, "on", "table_1") for n in names],
        [MultiRelation(relation_type="surround", subjects=tuple(names), targets=("table_1",))],
    )
    out = solve(doc)
    at = _poses(out)
    assert out.layout_result is not None
    assert out.layout_result.feasible and all(r.satisfied for r in out.layout_result.relations)
    angles = sorted(
        math.atan2(at[n][1] - at["table_1"][1], at[n][0] - at["table_1"][0]) for n in names
    )
    gaps = [b - a for a, b in itertools.pairwise(angles)]
    assert max(gaps) - min(gaps) < 0.25
    assert all(math.dist(at[n][:2], at["table_1"][:2]) < 47.5 for n in names)


# -- degenerate input ----------------------------------------------------------------------------


def _bounded(doc: EsgDocument, seconds: float) -> EsgDocument:
    solve(document({"b": box("b", 5, 5, 5)}, {"b_1": "b"}))  # compiles
    start = time.process_time()
    out = solve(doc, config=LayoutConfig(threads=1))
    assert time.process_time() - start < seconds
    assert out.layout_result is not None
    for p in out.layout_result.poses.values():
        assert all(math.isfinite(v) for v in (*p.position_cm, p.yaw_deg))
    return out


@pytest.mark.parametrize("size", [(0.0, 0.0, 0.0), (1e-6, 1e-6, 1e-6), (0.0, 50.0, 0.0)])
def test_objects_without_size(size: tuple[float, float, float]) -> None:
    point = asset("point", (Proxy(kind=ProxyKind.BOX, size_cm=size, position_cm=(0, 0, size[2])),),
                  tuple(2 * v for v in size))  # fmt: skip
    doc = document(
        {"point": point, "table": table("table", 80, 120, 75)},
        {"table_1": "table"} | {f"point_{k}": "point" for k in range(3)},
        [("point_0", "on", "table_1"), ("point_1", "near", "table_1"),
         ("point_2", "face", "point_1"), ("point_2", "adjacent", "point_1")],
    )  # fmt: skip
    out = _bounded(doc, 3.0).layout_result
    assert out is not None and out.feasible


def test_contradictions_are_reported_and_nothing_overlaps() -> None:
    crate = box("crate", 40, 40, 40)
    names = ("crate_1", "crate_2", "crate_3")
    edges = [("crate_1", "left_of", "crate_2"), ("crate_2", "left_of", "crate_1"),
             ("crate_1", "near", "crate_3"), ("crate_1", "far_from", "crate_3"),
             ("crate_3", "under", "crate_2"), ("crate_2", "higher_than", "crate_3"),
             ("crate_3", "higher_than", "crate_2"),
             ("crate_1", "adjacent", "crate_3", {"distance_cm": 500.0})]  # fmt: skip
    doc = document({"crate": crate}, dict.fromkeys(names, "crate"), edges)
    out = _bounded(doc, 4.0).layout_result
    assert out is not None and out.max_penetration_cm < 0.05
    broken = {r.edge for r in out.relations if not r.satisfied}
    assert broken & {"crate_1 left_of crate_2", "crate_2 left_of crate_1"}
    assert broken & {"crate_1 near crate_3", "crate_1 far_from crate_3"}
    assert broken & {"crate_2 higher_than crate_3", "crate_3 higher_than crate_2"}


@pytest.mark.parametrize("length", [2, 3, 12])
def test_cycles_of_supports_and_of_directions_end(length: int) -> None:
    names = [f"box_{k}" for k in range(length)]
    ring = list(zip(names, names[1:] + names[:1], strict=True))
    for relation in ("on", "inside_of", "left_of", "face", "near", "above"):
        doc = document({"box": box("box", 20, 20, 20)}, dict.fromkeys(names, "box"),
                       [(a, relation, b) for a, b in ring])  # fmt: skip
        out = _bounded(doc, 6.0).layout_result
        assert out is not None
        broken = [r for r in out.relations if not r.satisfied]
        if relation in ("on", "inside_of"):
            assert not out.feasible and "cycle" in out.reason
        if relation == "left_of":
            assert 1 <= len(broken) <= 2
        if relation in ("face", "near") and length < 12:
            assert not broken


def test_a_region_smaller_than_its_object() -> None:
    region = {
        "spot": {
            "region_description": "a spot", "region_type": "SUPPORT_SURFACE", "parent_object": "table_1",
            "bounds_cm": ((-2.0, -2.0, 0.0), (2.0, 2.0, 10.0)),
        }
    }  # fmt: skip
    doc = document(
        {"table": table("table", 80, 120, 75), "crate": box("crate", 30, 30, 30)},
        {"table_1": "table", "crate_1": ("crate", {"semantic_region": "spot"}),
         "crate_2": ("crate", {"semantic_region": "spot"})},
        regions=region,
    )  # fmt: skip
    result = _bounded(doc, 3.0).layout_result
    assert result is not None
    # both want the same spot: they cannot have it, and that is said
    assert not result.feasible and "table_1 is too small" in result.reason


def test_two_hundred_balls_on_a_table_for_twenty() -> None:
    doc = document(
        {"table": table("table", 80, 120, 75), "ball": ball("ball", 10)},
        {"table_1": "table"} | {f"ball_{k}": "ball" for k in range(200)},
        [(f"ball_{k}", "on", "table_1") for k in range(200)],
    )
    result = _bounded(doc, 15.0).layout_result
    assert result is not None and not result.feasible
    assert "table_1 is too small: 200 objects need 8.00 m2 of 0.96 m2" in result.reason
    assert len(result.poses) == 202


def test_stacked_chairs_lean_off_each_others_backrests() -> None:
    """The legs of the upper chair stand on the seat of the lower one, before its backrest."""
    parts = [((23.0, 22.0, 1.5), (2.0, 0.0, 44.5)), ((2.0, 22.0, 21.0), (-23.0, 0.0, 67.0))]
    parts += [((2.0, 2.0, 21.5), (x, y, 21.5)) for x in (-22.0, 22.0) for y in (-20.0, 20.0)]
    proxies = tuple(Proxy(kind=ProxyKind.BOX, size_cm=size, position_cm=at) for size, at in parts)
    seat = SupportSurface(name="seat", center_cm=(2.0, 0.0, 46.0), half_extents_cm=(20.0, 20.0))
    chair = asset("chair", proxies, (50.0, 44.0, 88.0), support_surfaces=(seat,))
    member = {"group": "chairs", "group_pattern": "stack"}
    out = solve(document({"chair": chair}, {f"chair_{k}": ("chair", member) for k in range(3)}))
    assert out.layout_result is not None and out.layout_result.feasible
    at = _poses(out)
    steps = [math.dist(at[f"chair_{k}"][:2], at[f"chair_{k + 1}"][:2]) for k in range(2)]
    assert all(0.0 < s < 5.0 for s in steps)


def test_a_row_whose_members_are_planned_elsewhere_is_told_not_to_stand() -> None:
    whole = solve(_slabs(5), hints=_push("slab_0")).layout_result
    assert whole is not None and whole.patterns is None
    starts = tuple(Placement(f"slab_{k}", 40.0 * k, 30.0 * (k % 2)) for k in range(5))
    torn = solve(_slabs(5), hints=StartHints((Constellation(starts),))).layout_result
    assert torn is not None and torn.patterns is not None
    told = torn.patterns[0]
    assert told.edge == "slab_0,slab_1,slab_2,slab_3,slab_4 row" and not told.satisfied
    assert 5.0 < told.violation < 30.0
