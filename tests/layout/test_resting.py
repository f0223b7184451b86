"""Everything is carried: what is planned beside its support is set on it, what hangs is reported."""

from __future__ import annotations

import pytest

from esg.graph.models import (
    NodeEvent,
    RegionType,
    SemanticRegion,
    SequenceGraph,
    SupportSurface,
    TimelineNode,
    TimelineSystem,
)
from esg.layout import Constellation, Placement, StartHints, solve
from esg.layout.problem.supports import shape_of, surface_for
from tests.layout import builders as b
from tests.layout.test_hints import local

ASSETS = {
    "cat": b.box("cat", 46, 14, 38),
    "table": b.table("table", 180, 100, 75),
    "jug": b.cylinder("jug", 9, 24),
    "crate": b.box("crate", 40, 40, 40),
}
ON = {
    "top": SemanticRegion(
        region_type=RegionType.SUPPORT_SURFACE, parent_object="table_1", region_description="top"
    )
}
ON_TABLE = {"semantic_region": "top"}


def scene(**nodes):
    """Things on a table through its region: no edge says so."""
    on = {n: (asset, ON_TABLE) for n, asset in nodes.items()}
    return b.document(ASSETS, {"table_1": "table", "cat_1": "cat", **on}, regions=ON)


def start(doc, *placements: Placement):
    cat = Placement("cat_1", -500.0, 0.0)
    table = Placement("table_1", 0.0, 0.0)
    hints = StartHints((Constellation((table, cat, *placements)),))
    out = solve(doc, hints=hints).layout_result
    assert out is not None
    return out


def test_what_is_planned_behind_a_table_stands_on_it():
    out = start(
        scene(jug_1="jug", jug_2="jug"), Placement("jug_1", 300, 10), Placement("jug_2", 600, 0)
    )
    assert out.feasible, out.reason
    assert "jug_1 was planned beside or in table_1" in out.reason
    places = [local(out, "table_1", n) for n in ("jug_1", "jug_2")]
    for (x, y), n in zip(places, ("jug_1", "jug_2"), strict=True):
        assert 0.0 <= out.poses[n].position_cm[2] - 75.0 < 0.1
        assert abs(x) <= 90 - 9 + 0.01
        assert abs(y) <= 50 - 9 + 0.01
    assert places[0][0] > 60  # at the edge that it was planned beyond
    assert max(abs(p - q) for p, q in zip(*places, strict=True)) > 12.0


def test_what_is_planned_on_a_table_stays_where_it_is_planned():
    out = start(scene(jug_1="jug"), Placement("jug_1", 88, 10))
    assert local(out, "table_1", "jug_1")[0] == pytest.approx(88)
    assert out.reason == ""


def falls(doc, name: str):
    node = TimelineNode(id="n1", event=NodeEvent.FALL, participants=(name,))
    timeline = TimelineSystem(sequence_graph=SequenceGraph(nodes=(node,)))
    return doc.model_copy(update={"timeline_system": timeline})


def test_what_falls_in_the_story_may_start_over_the_edge():
    doc = scene(crate_1="crate")
    over = Placement("crate_1", 100, 0)
    assert local(start(doc, over), "table_1", "crate_1")[0] <= 90
    assert local(start(falls(doc, "crate_1"), over), "table_1", "crate_1")[0] == pytest.approx(100)
    beside = Placement("crate_1", 115, 0)
    assert local(start(falls(doc, "crate_1"), beside), "table_1", "crate_1")[0] <= 90


def test_what_hangs_because_nothing_solid_is_below_is_reported():
    """Two narrow rails carry a long board but not what stands between them."""
    rails = b.asset(
        "rails",
        tuple(b.box("r", 200, 6, 50).proxies[0].model_copy(update={"position_cm": (0.0, y, 25.0)})
              for y in (-40.0, 40.0)),
        (200, 86, 50),
        support_surfaces=(
            SupportSurface(name="top", center_cm=(0, 0, 50), half_extents_cm=(100, 40)),
        ),
    )  # fmt: skip
    assets = {"rails": rails, "board": b.box("board", 40, 90, 4), "jug": ASSETS["jug"]}

    def carried(asset: str, at: float):
        doc = b.document(assets, {"rails_1": "rails", "x_1": asset}, [("x_1", "on", "rails_1")])
        hints = StartHints((Constellation((Placement("rails_1", 0, 0), Placement("x_1", 0, at))),))
        out = solve(doc, hints=hints).layout_result
        assert out is not None
        return out

    hung = carried("jug", 0.0)
    assert not hung.feasible
    assert "x_1 hangs in the air beside rails_1" in hung.reason
    assert carried("board", 0.0).feasible
    assert carried("jug", 40.0).feasible


def test_the_upper_end_of_a_thing_without_surfaces_is_its_highest_part():
    """A lamp: a pole of 4 cm in the middle of a foot of 60 cm."""
    foot = b.cylinder("foot", 30, 4).proxies[0]
    pole = b.cylinder("pole", 2, 150).proxies[0]
    lamp = shape_of(b.asset("lamp", (foot, pole), (60, 60, 150)))
    top = surface_for(lamp)
    assert top.center_cm == (0.0, 0.0, 150.0)
    assert top.half_extents_cm == (2.0, 2.0)


def test_what_is_planned_inside_a_part_of_its_support_moves_to_where_there_is_room():
    """A bed of 200 cm with a headboard across one end."""
    board = (
        b.box("board", 10, 90, 60).proxies[0].model_copy(update={"position_cm": (-90.0, 0.0, 80.0)})
    )
    bed = b.asset(
        "bed",
        (*b.box("frame", 200, 90, 50).proxies, board),
        (200, 90, 110),
        support_surfaces=(
            SupportSurface(name="top", center_cm=(0, 0, 50), half_extents_cm=(100, 45)),
        ),
    )
    doc = b.document(
        {"bed": bed, "crate": ASSETS["crate"]}, {"bed_1": "bed", "x_1": "crate"},
        [("x_1", "on", "bed_1")],
    )  # fmt: skip
    hints = StartHints((Constellation((Placement("bed_1", 0, 0), Placement("x_1", -80, 0))),))
    out = solve(doc, hints=hints).layout_result
    assert out is not None
    assert out.feasible, out.reason
    assert local(out, "bed_1", "x_1")[0] >= -85 + 20 - 1.01
