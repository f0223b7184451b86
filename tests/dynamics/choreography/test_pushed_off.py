"""What is pushed off a table starts on it, with its pusher; who turns last drives on straight."""

from __future__ import annotations

import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import HoldVelocity
from esg.layout import solve
from tests.dynamics.stories import cast


@pytest.mark.parametrize(
    ("prompt", "pusher", "pushed", "table"),
    [
        (
            "A toy car pushes a wooden block off the table. The block lands on a cushion.",
            "toy_car_1", "wooden_block_1", "table_1",
        ),
        (
            "A marble rolls across the desk, hits a pencil cup and knocks it off the desk onto a "
            "book.",
            "marble_1", "cup_1", "desk_1",
        ),
    ],
)  # fmt: skip
def test_what_is_pushed_off_starts_at_the_edge(
    prompt: str, pusher: str, pushed: str, table: str
) -> None:
    """Neither floats beyond the table, and what it lands on is not on the table."""
    doc = cast(prompt)
    node = doc.spatial_relation_graph.nodes[table]
    surface = doc.asset_configurations[node.asset_id].support_surfaces[0]
    found = [c for c in choreograph(doc).hints.constellations if c.anchor == table]
    places = {p.node: p for c in found for p in c.placements}
    half = surface.half_extents_cm[0]
    for name in (pusher, pushed):
        assert abs(places[name].x_cm - surface.center_cm[0]) < half, name
    assert places[pusher].x_cm < places[pushed].x_cm
    target = next(p for n, p in places.items() if n not in (pusher, pushed))
    assert target.x_cm > surface.center_cm[0] + half


def test_who_turns_last_goes_on_straight() -> None:
    """Let go while it turns, a car would spin on."""
    doc = cast("A car drives at 8 m/s and turns left after 2 seconds.")
    doc = solve(doc, seed=0, hints=start_hints(doc))
    plan = make_plan(doc, build_scene(doc), seed=0)
    holds = [p for p in plan.compile(plan.initial()).primitives if isinstance(p, HoldVelocity)]
    turning = [k for k, p in enumerate(holds) if p.turn_rate]
    assert len(turning) == 1
    turn, after = holds[turning[0]], holds[turning[0] + 1]
    assert after.turn_rate == 0.0 and after.start == pytest.approx(turn.end)
    assert after.heading == pytest.approx(turn.heading + turn.turn_rate * (turn.end - turn.start))
    assert after.speed == pytest.approx(turn.speed)


def test_what_slides_off_into_something_hardly_lower_comes_down_in_it() -> None:
    """Put beside it, as what it would run into, the bin would be out of its reach."""
    doc = cast("A parcel slides off the end of a conveyor belt and drops into a bin.")
    nodes = doc.spatial_relation_graph.nodes
    belt, bin_, parcel = (
        doc.asset_configurations[nodes[f"{n}_1"].asset_id]
        for n in ("conveyor_belt", "bin", "parcel")
    )
    lower = belt.support_surfaces[0].center_cm[2] - bin_.dimensions_cm[2]
    assert lower < parcel.dimensions_cm[2]
    places = {p.node: p for c in choreograph(doc).hints.constellations for p in c.placements}
    beyond = places["bin_1"].x_cm - 0.5 * bin_.dimensions_cm[0] - 0.5 * belt.dimensions_cm[0]
    assert beyond < 0.5 * parcel.dimensions_cm[0]
