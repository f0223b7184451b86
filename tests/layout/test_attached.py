"""Walls, ceilings, heights."""

from __future__ import annotations

import math

from esg.layout import solve
from tests.layout import builders as b

ASSETS = {
    "wall": b.box("wall", 20, 400, 260, is_movable=False),
    "picture": b.box("picture", 4, 60, 40, is_movable=False),
    "clock": b.cylinder("clock", 12, 10, is_movable=False),
    "ceiling": b.box("ceiling", 500, 500, 10, is_movable=False),
    "lamp": b.cylinder("lamp", 20, 30, is_movable=False),
    "sofa": b.box("sofa", 90, 200, 80),
    "table": b.table("table", 90, 150, 75),
}


def layout(nodes, edges):
    out = solve(b.document(ASSETS, nodes, edges), seed=1).layout_result
    assert out is not None
    return out


def test_picture_hangs_flush_on_the_face_of_the_wall() -> None:
    out = layout({"wall_1": "wall", "p": "picture"}, [("p", "attached_vertical", "wall_1")])
    w, p = out.poses["wall_1"], out.poses["p"]
    a = math.radians(w.yaw_deg)
    dx, dy = (q - r for q, r in zip(p.position_cm[:2], w.position_cm[:2], strict=True))
    x, y = math.cos(a) * dx + math.sin(a) * dy, -math.sin(a) * dx + math.cos(a) * dy
    assert 0 <= x - 12 <= 0.05
    assert abs(y) <= 170.01
    assert 0 < p.position_cm[2] <= 220
    assert abs(math.remainder(p.yaw_deg - w.yaw_deg, 360)) < 1e-3
    assert out.relations[0].satisfied and out.feasible


def test_height_relations_move_what_hangs() -> None:
    nodes = {"wall_1": "wall", "p": "picture", "q": "picture", "r": "picture", "sofa_1": "sofa"}
    edges = [(n, "attached_vertical", "wall_1") for n in "pqr"]
    edges += [
        ("p", "higher_than", "q"),
        ("r", "same_level_as", "q"),
        ("q", "higher_than", "sofa_1"),
    ]
    out = layout(nodes, edges)
    z = {n: out.poses[n].position_cm[2] for n in nodes}
    assert z["p"] > z["q"] and abs(z["r"] - z["q"]) < 0.1
    assert all(r.satisfied for r in out.relations)
    assert out.max_penetration_cm == 0.0


def test_lamp_hangs_below_the_ceiling_above_the_table() -> None:
    nodes = {"ceiling_1": ("ceiling", {"is_structural": True}), "lamp_1": "lamp", "t": "table"}
    out = layout(nodes, [("lamp_1", "attached_horizontal", "ceiling_1"), ("lamp_1", "above", "t")])
    assert out.poses["lamp_1"].position_cm[2] + 30 == out.poses["ceiling_1"].position_cm[2] - 0.01
    (x, y, _), (u, v, _) = out.poses["lamp_1"].position_cm, out.poses["t"].position_cm
    assert math.dist((x, y), (u, v)) < 90
    assert all(r.satisfied for r in out.relations)


def test_wall_stands_behind_the_furniture() -> None:
    out = layout(
        {"wall_1": "wall", "sofa_1": "sofa", "t": "table"}, [("t", "in_front_of", "sofa_1")]
    )
    assert out.poses["wall_1"].position_cm[1] < out.poses["sofa_1"].position_cm[1]
